"""Bore and outside diameter of a designated bearing, for the tables of a case that need them."""

from __future__ import annotations

from collections.abc import Mapping
from math import isclose
from typing import Any, Final

from rolamento.case.bearing import Bearing
from rolamento.case.mounting import Mounting
from rolamento.errors import InputError
from rolamento.units import from_si

__all__ = ["check_catalogue_sizes", "with_catalogue_sizes"]

_SIZES: Final = ("bore", "outside_diameter")
_ROUNDING: Final = 1e-9


def with_catalogue_sizes(given: Mapping[str, Any], *, in_file: bool) -> Mapping[str, Any]:
    """Return the tables of a case with the sizes that they need and the catalogue tells.

    Parameters
    ----------
    given
        The fields of a case: tables or records.
    in_file
        Whether quantities are text with units.
    """
    missing = {
        name: [size for size in _SIZES if size not in table]
        for name in ("mounting", "film")
        if isinstance(table := given.get(name), Mapping) and _needs_sizes(name, table)
    }
    if not any(missing.values()):
        return given
    sizes = _sizes_of(given.get("bearing"))
    if not sizes:
        return given
    filled = dict(given)
    for name, names in missing.items():
        own = {size: from_si(sizes[size], "length") if in_file else sizes[size] for size in names}
        filled[name] = {**given[name], **own}
    return filled


def check_catalogue_sizes(bearing: Bearing, mounting: Mounting) -> None:
    """Refuse a mounting for a bearing of another size than that of the designation.

    Raises
    ------
    InputError
        Naming the size.
    """
    published = bearing.published
    if published is None:
        return
    for name in _SIZES:
        told, own = getattr(published, name), getattr(mounting, name)
        if not isclose(told, own, rel_tol=_ROUNDING):
            raise InputError(
                f"must be {from_si(told, 'length')}, that of {bearing.designation}",
                field=f"mounting.{name}",
                value=from_si(own, "length"),
                example=f'leave it out, or {name} = "{from_si(told, "length")}"',
            )


def _needs_sizes(name: str, table: Mapping[str, Any]) -> bool:
    return name == "mounting" or table.get("starvation") == "replenishment"


def _sizes_of(bearing: Any) -> dict[str, float]:
    """What the catalogue tells; nothing of what is no designation, which others refuse."""
    if isinstance(bearing, Bearing):
        designation: Any = bearing.designation
    else:
        designation = bearing.get("designation") if isinstance(bearing, Mapping) else None
    if isinstance(designation, int) and not isinstance(designation, bool):
        designation = str(designation)
    if not isinstance(designation, str):
        return {}
    from rolamento.catalogue import built_in_geometry

    try:
        found = built_in_geometry(designation, False).bearing
    except InputError:
        return {}
    return {name: getattr(found, name) for name in _SIZES}
