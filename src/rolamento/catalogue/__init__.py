"""Bearings by their designation: dimensions and ratings from catalogues, the inside inferred.

>>> from rolamento.catalogue import geometry_of
>>> geometry_of("6205").fields["ball_count"]
9
"""

from __future__ import annotations

from rolamento.catalogue.designation import Designation, parse_designation
from rolamento.catalogue.geometry import (
    ASSUMED_CONFORMITY,
    InternalGeometry,
    Origin,
    ambiguity_axis,
    geometry_of,
    with_ratings,
)
from rolamento.catalogue.inference import (
    Candidate,
    Practice,
    ball_name,
    ball_sizes,
    inferred_geometry,
    practice_of,
)
from rolamento.catalogue.letters import ClearanceClass, Letters, Part
from rolamento.catalogue.records import CatalogueBearing
from rolamento.catalogue.roller_inference import (
    RollerCandidate,
    inferred_rollers,
    nominal_angle,
    roller_diameters,
)
from rolamento.catalogue.rolling import RollingBearing, rolling_bearings
from rolamento.catalogue.search import (
    Catalogue,
    Found,
    catalogue,
    catalogue_with,
    catalogues,
    listed,
)

__all__ = [
    "ASSUMED_CONFORMITY",
    "Candidate",
    "Catalogue",
    "CatalogueBearing",
    "ClearanceClass",
    "Designation",
    "Found",
    "InternalGeometry",
    "Letters",
    "Origin",
    "Part",
    "Practice",
    "RollerCandidate",
    "RollingBearing",
    "ambiguity_axis",
    "ball_name",
    "ball_sizes",
    "catalogue",
    "catalogue_with",
    "catalogues",
    "geometry_of",
    "inferred_geometry",
    "inferred_rollers",
    "listed",
    "nominal_angle",
    "parse_designation",
    "practice_of",
    "roller_diameters",
    "rolling_bearings",
    "with_ratings",
]
