"""The catalogue: bearings found, one with its internal geometry, a study's axis of candidates."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final

from rolamento.errors import InputError
from rolamento.io.json import dumps
from rolamento.tasks.case_request import Finding, FindingRequest
from rolamento.tasks.machines import CATALOGUES
from rolamento.tasks.parameters import Progress, quietly
from rolamento.tasks.request import Input
from rolamento.units import from_si
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.catalogue import (
        Candidate,
        Catalogue,
        CatalogueBearing,
        InternalGeometry,
        RollerCandidate,
    )

__all__ = [
    "BearingRequest", "CatalogueSearch", "axis_toml", "bearing_mapping", "inside_of",
    "search_mapping",
]  # fmt: skip

_RATINGS: Final = {"dynamic": "dynamic_rating", "static": "static_rating"}


class CatalogueSearch(FindingRequest):
    """List the bearings whose designation contains a text.

    Parameters
    ----------
    text
        Part of a designation, or boundary dimensions such as 25x52.
    most
        Maximum number of results.
    catalogues
        A catalogue of your own, CSV or TOML, for designations.
    """

    text: Annotated[str, Input(essential=True, example="6205", stands_alone=True, metavar="TEXT")]
    most: Annotated[
        int, Input("", "count", example="40", default="40", between=(1, 1000), metavar="N")
    ] = 40
    catalogues: Annotated[Any, CATALOGUES] = ()

    examples: ClassVar = (
        "Examples: catalogue search 62; catalogue search 'EX 70'; catalogue search 25x52x15."
    )

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it, a tuple of `CatalogueBearing`."""
        from rolamento.catalogue import catalogue
        from rolamento.pages.catalogue import search_page

        found = catalogue().beside(self.catalogues).search(self.text, self.most + 1)
        shown, is_all = found[: self.most], len(found) <= self.most
        return Finding(
            shown, partial(search_page, shown, is_all=is_all),
            lambda: dumps(search_mapping(shown)), is_result=bool(found),
        )  # fmt: skip


class BearingRequest(FindingRequest):
    """Show a bearing by its designation.

    Published data with their sources, and the internal geometry, marked where estimated.

    Parameters
    ----------
    designation
        Designation, such as 6205/C3 or 'EX 70 25deg'.
    dynamic
        Dynamic load rating, instead of that in the list.
    static
        Static load rating, instead of that in the list.
    axis
        Print the candidates as an axis of a study file instead.
    catalogues
        A catalogue of your own, CSV or TOML, for designations.
    """

    designation: Annotated[
        str,
        Input(
            essential=True, example="6205/C3", stands_alone=True,
            metavar="DESIGNATION",
        ),
    ]  # fmt: skip
    dynamic: Annotated[
        float | None,
        Input(
            "", "quantity", example="14.8 kN", dimension="force", between=(1.0, 1e9),
            metavar="FORCE",
        ),
    ] = None  # fmt: skip
    static: Annotated[
        float | None,
        Input(
            "", "quantity", example="7.8 kN", dimension="force", between=(1.0, 1e9),
            metavar="FORCE",
        ),
    ] = None  # fmt: skip
    axis: Annotated[bool, Input("", "switch")] = False
    catalogues: Annotated[Any, CATALOGUES] = ()

    examples: ClassVar = (
        "Examples: catalogue show 6205/C3; catalogue show 7205B --dynamic '14.8 kN'."
    )

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it, an `InternalGeometry`."""
        from rolamento.catalogue import catalogue
        from rolamento.pages.catalogue import bearing_page

        found = inside_of(self._rated(catalogue().beside(self.catalogues)), self.designation)
        json = partial(_json, found)
        if self.axis and found.has_elements:
            return Finding(found, to_json=json, text=axis_toml(found))
        return Finding(found, partial(bearing_page, found), json, is_result=found.has_elements)

    def _rated(self, known: Catalogue) -> Catalogue:
        """Put ratings in the place of the list's; what the list infers from beside them goes."""
        from rolamento.catalogue import Catalogue

        given: dict[str, Any] = {
            name: value
            for field, name in _RATINGS.items()
            if (value := getattr(self, field)) is not None
        }
        if not given:
            return known
        bearing = known.find(self.designation).bearing
        sources = {**bearing.sources, **dict.fromkeys(given, "given")}
        own = replace(bearing, f0=None, **given, sources=sources)
        return Catalogue((*known.bearings, own))


def _json(found: InternalGeometry) -> str:
    return dumps(bearing_mapping(found))


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
    from rolamento.catalogue import ambiguity_axis

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
    from rolamento.catalogue import geometry_of

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
