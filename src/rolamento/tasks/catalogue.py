"""The catalogue as plain values: bearings found, one with its internal geometry, a study's axis."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from rolamento.catalogue import (
    Candidate,
    Catalogue,
    CatalogueBearing,
    InternalGeometry,
    RollerCandidate,
    ambiguity_axis,
    geometry_of,
)
from rolamento.errors import InputError
from rolamento.units import from_si
from rolamento.words import said

__all__ = ["axis_toml", "bearing_mapping", "inside_of", "search_mapping"]


def axis_toml(geometry: InternalGeometry) -> str:
    """Return the axis of a study file over the candidates that the ratings allow.

    Parameters
    ----------
    geometry
        With candidates.

    Raises
    ------
    InputError
        If its inside is published: there is nothing to vary.
    """
    if not geometry.candidates:
        raise InputError(
            said("has a published interior: there are no candidates"),
            field="designation",
            value=geometry.designation.text,
        )
    axis = ambiguity_axis(geometry.candidates)
    lines = ["[[axes]]", f'name = "{axis["name"]}"', "[axes.zipped]"]
    for name, values in axis["zipped"].items():
        is_length = name.endswith(("diameter", "length"))
        texts = [f'"{from_si(value, "length")}"' if is_length else str(value) for value in values]
        lines.append(f'"{name}" = [{", ".join(texts)}]')
    return "\n".join(lines) + "\n"


def inside_of(known: Catalogue, designation: str) -> InternalGeometry:
    """Return what is inside a bearing; without balls where neither they nor ratings are published.

    Raises
    ------
    InputError
        If there is no such bearing.
    """
    bearing = known.find(designation).bearing
    rated = bearing.rated != (None, None)
    return geometry_of(designation, catalogue_of=known, with_balls=rated or bearing.knows_elements)


def search_mapping(found: Sequence[CatalogueBearing]) -> dict[str, Any]:
    """Give a list of bearings as plain values, in SI."""
    return {"schema": 1, "kind": "catalogue", "bearings": [_bearing_mapping(b) for b in found]}


def bearing_mapping(geometry: InternalGeometry) -> dict[str, Any]:
    """Give one bearing as plain values, in SI; ``inside`` is None if nothing is known of it."""
    inside = {
        name: {"value": value, "origin": geometry.origins[name]}
        for name, value in geometry.fields.items()
    }
    return {
        "schema": 1,
        "kind": "bearing",
        "bearing": _bearing_mapping(geometry.bearing),
        "clearance_class": geometry.clearance_class,
        "meanings": dict(geometry.designation.meanings),
        "unknown": list(geometry.designation.unknown),
        "without_effect": [part for part, _ in geometry.idle],
        "notes": [note.to_mapping() for note in geometry.notes],
        "inside": inside if geometry.has_elements else None,
        "candidates": [_candidate_mapping(one) for one in geometry.candidates],
        "same_size": [_bearing_mapping(one) for one in geometry.sisters],
    }


def _bearing_mapping(bearing: CatalogueBearing) -> dict[str, Any]:
    return {
        "designation": bearing.designation,
        "maker": bearing.maker,
        "kind": bearing.kind,
        "figures": {
            name: {"value": value, "source": bearing.sources.get(name, "")}
            for name, value in bearing.figures.items()
        },
    }


def _candidate_mapping(one: Candidate | RollerCandidate) -> dict[str, Any]:
    names = one.__dataclass_fields__
    return {
        name: list(value) if isinstance(value := getattr(one, name), tuple) else value
        for name in names
    }
