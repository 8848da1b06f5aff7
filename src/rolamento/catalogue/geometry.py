"""From a designation to the inside of a bearing: each figure published, inferred or assumed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from math import radians
from typing import Any, Final, Literal

from rolamento._data import toml_of
from rolamento.catalogue.designation import ClearanceClass, Designation
from rolamento.catalogue.inference import Candidate, inferred_geometry
from rolamento.catalogue.records import CatalogueBearing
from rolamento.catalogue.search import (
    Catalogue,
    catalogue,
    catalogue_with,
    is_built_in,
)
from rolamento.errors import InputError
from rolamento.units import MILLIMETRE, readable
from rolamento.words import said

Origin = Literal["published", "inferred", "assumed"]

ASSUMED_CONFORMITY: Final = 0.52
"""Of both races where nothing is published: what ISO 281 supposes of its ratings."""

_BALLS: Final = ("ball_count", "ball_diameter")
_LEAST_ANGLE: Final = radians(1.0)
_HALF_MICROMETRES: Final = 2e6
"""In a metre."""
_ROUNDING: Final = 1e-9


@dataclass(frozen=True, slots=True, kw_only=True)
class InternalGeometry:
    """The inside of a bearing, with where each figure comes from.

    Attributes
    ----------
    bearing
        What the catalogue holds.
    designation
        What was asked for.
    fields
        Fields of a `rolamento.Bearing` in SI: balls, pitch diameter, conformities, and the
        nominal contact angle or the diametral clearance where there is one.
    origins
        Of each field: ``"published"``, ``"inferred"`` from the ratings, or ``"assumed"``.
    candidates
        All insides that the ratings allow, the best first; empty if nothing was inferred.
    records
        What has to be known beside the built-in catalogue to find the same again.
    """

    bearing: CatalogueBearing
    designation: Designation
    fields: Mapping[str, Any]
    origins: Mapping[str, Origin]
    candidates: tuple[Candidate, ...] = ()
    records: tuple[CatalogueBearing, ...] = ()

    @property
    def is_inferred(self) -> bool:
        """Whether the balls are inferred."""
        return "inferred" in self.origins.values()

    @property
    def lack_of_play(self) -> str:
        """What a user has to add if neither contact angle nor clearance is known, as a rule."""
        if self.clearance_class is None:
            return said("does not define the contact angle: give contact_angle")
        return said(
            "has class {class_}, for which ISO 5753-1 has no range at a bore of {bore}: give"
            " diametral_clearance",
            class_=self.clearance_class,
            bore=readable(self.bearing.bore, "length"),
        )

    @property
    def clearance_class(self) -> ClearanceClass | None:
        """The class of the designation, CN if a deep-groove bearing names none."""
        if self.bearing.kind != "deep_groove":
            return None
        return self.designation.clearance_class or "CN"


def geometry_of(
    designation: str,
    *,
    catalogue_of: Catalogue | None = None,
    rank: int = 1,
    with_balls: bool = True,
) -> InternalGeometry:
    """Return the inside of a bearing by its designation.

    Parameters
    ----------
    designation
        Such as ``"6305/C3"`` or ``"EX 70 25deg"``.
    catalogue_of
        Where to look; by default in `rolamento.catalogue.catalogue`.
    rank
        Which of the candidates to take, if the balls are inferred.
    with_balls
        Whether balls and pitch diameter are wanted at all; if not, they are left out.

    Raises
    ------
    InputError
        If the designation is not known, its balls are neither published nor to be inferred, or
        there is no such rank.
    """
    return _geometry_in(catalogue_of or catalogue(), designation, rank, with_balls)


@lru_cache(maxsize=512)
def _geometry_in(
    known: Catalogue, designation: str, rank: int, with_balls: bool
) -> InternalGeometry:
    found = known.find(designation)
    bearing = found.bearing
    fields: dict[str, Any] = {}
    origins: dict[str, Origin] = {}
    candidates: tuple[Candidate, ...] = ()
    if with_balls:
        candidates = _add_balls(bearing, rank, fields, origins)
    for name in ("inner_conformity", "outer_conformity"):
        own = getattr(bearing, name)
        fields[name] = ASSUMED_CONFORMITY if own is None else own
        origins[name] = "assumed" if own is None else "published"
    _add_play(bearing, found.designation, fields, origins)
    return InternalGeometry(
        bearing=bearing,
        designation=found.designation,
        fields=fields,
        origins=origins,
        candidates=candidates,
        records=() if known is catalogue_with(()) or is_built_in(bearing) else (bearing,),
    )


def ambiguity_axis(
    candidates: Sequence[Candidate], *, credible_only: bool = True
) -> dict[str, Any]:
    """Return the candidates as an axis of a study: any result becomes a band.

    Parameters
    ----------
    candidates
        Such as those of an `InternalGeometry`.
    credible_only
        Leave out those that miss a printed figure by more than three tolerances, the best
        excepted.

    Returns
    -------
    dict
        ``name`` and ``zipped`` with balls and pitch diameter in SI: the arguments of
        `rolamento.studies.Axis`.
    """
    kept = [one for one in candidates if one.reproduces or not credible_only]
    kept = kept or list(candidates[:1])
    if not kept:
        raise InputError(said("has no candidates"), field="candidates")
    return {
        "name": "internal geometry",
        "zipped": {
            "bearing.ball_count": [one.ball_count for one in kept],
            "bearing.ball_diameter": [one.ball_diameter for one in kept],
            "bearing.pitch_diameter": [one.pitch_diameter for one in kept],
        },
    }


def middle_clearance(bore: float, clearance_class: str) -> float | None:
    """Return the middle of a class's radial internal clearance in m; None without a range.

    Parameters
    ----------
    bore
        In m.
    clearance_class
        Of ISO 5753-1.
    """
    data = toml_of("iso5753", "rolamento.clearance")
    limits = [MILLIMETRE * limit for limit in data["bore_mm"]]
    for step, (over, to) in enumerate(pairwise(limits)):
        if over * (1.0 + _ROUNDING) < bore <= to * (1.0 + _ROUNDING):
            pair = data["classes"][clearance_class][step]
            return sum(pair) / _HALF_MICROMETRES if pair else None
    return None


def _chosen(candidates: tuple[Candidate, ...], rank: int, bearing: CatalogueBearing) -> Candidate:
    if not candidates:
        raise InputError(
            said(
                "has ratings that no standard balls reproduce: give ball_count, "
                "ball_diameter and pitch_diameter"
            ),
            field="designation",
            value=bearing.designation,
        )
    if not 1 <= rank <= len(candidates):
        raise InputError(
            said("must be between 1 and {count}, the number of candidates", count=len(candidates)),
            field="rank",
            value=rank,
        )
    return candidates[rank - 1]


def _add_balls(
    bearing: CatalogueBearing, rank: int, fields: dict[str, Any], origins: dict[str, Origin]
) -> tuple[Candidate, ...]:
    """Add balls and pitch diameter; return what they were chosen from, if inferred."""
    names = (*_BALLS, "pitch_diameter")
    known = {name: getattr(bearing, name) for name in names}
    candidates: tuple[Candidate, ...] = ()
    otherwise: Origin = "assumed"
    if any(known[name] is None for name in _BALLS):
        candidates, otherwise = inferred_geometry(bearing), "inferred"
        chosen = _chosen(candidates, rank, bearing)
        fields.update({name: getattr(chosen, name) for name in names})
    else:
        fields.update(known)
        fields["pitch_diameter"] = known["pitch_diameter"] or bearing.mean_diameter
    for name in names:
        origins[name] = otherwise if known[name] is None else "published"
    return candidates


def _add_play(
    bearing: CatalogueBearing,
    designation: Designation,
    fields: dict[str, Any],
    origins: dict[str, Origin],
) -> None:
    """Add the nominal contact angle, or the middle of the clearance class."""
    angle = bearing.contact_angle
    if angle is None and bearing.kind == "angular_contact":
        angle = designation.contact_angle
    if angle is not None and angle >= _LEAST_ANGLE:
        fields["contact_angle"], origins["contact_angle"] = angle, "published"
    elif bearing.kind == "deep_groove":
        clearance = middle_clearance(bearing.bore, designation.clearance_class or "CN")
        if clearance is not None:
            fields["diametral_clearance"] = clearance
            origins["diametral_clearance"] = "assumed"
