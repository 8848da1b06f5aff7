"""The clearance in operation of many cases at once, for batches and studies.

The same equations as `operating_clearance`, on arrays: what varies is put in the place of the
case's own numbers.
"""

from __future__ import annotations

from collections.abc import Mapping, Set
from dataclasses import make_dataclass, replace
from typing import Any, Final

import numpy as np

from rolamento.case import Case
from rolamento.case.bearing import Bearing, clearance_fits
from rolamento.case.mounting import Mounting
from rolamento.case.parameters import parameters_of
from rolamento.case.roller_bearing import RollerBearing, roller_clearance_fits
from rolamento.case.varied import is_of_mounting
from rolamento.clearance.chain import (
    Chain,
    PartTemperatures,
    check_two_rings,
    gathered,
    housing_bands,
    initial_band,
    shaft_bands,
    warm_geometry,
)
from rolamento.clearance.standards import Band
from rolamento.errors import InputError
from rolamento.geometry import free_contact_angle
from rolamento.numerics import FloatArray
from rolamento.words import said

_PARTS: Final = tuple(PartTemperatures.__dataclass_fields__)
MOUNTED_FIELDS: Final = tuple(
    name for name, field in Case.fields().items() if field.varies and is_of_mounting(name)
)
"""What a batch may vary of a mounted bearing beside its geometry and its duty."""

_OF_SETS: Final = (
    "bearing.spacing",
    *(f"bearing.preload.{name}" for name in ("force", "offset", "spring")),
)
"""What does not change a row itself."""


def operating_batch(
    case: Case, values: Mapping[str, FloatArray]
) -> tuple[Case, dict[str, FloatArray]]:
    """The case without its mounting, and the fields with the clearance in operation in them.

    Parameters
    ----------
    case
        Single row, with a mounting.
    values
        Scalars or arrays (cases,) by the dotted names of fields, SI.

    Returns
    -------
    tuple
        The case, and fields for `solve`: without `MOUNTED_FIELDS`, with the clearance or
        the contact angle as the bearing runs; NaN where no bearing is left.

    Raises
    ------
    InputError
        If something is missing, or what varies does not go together.
    """
    assert case.mounting is not None
    assert case.bearing.is_one_bearing, "a set has a preload too: see rolamento.system.mounted"
    arrays = {name: np.asarray(array, np.float64) for name, array in values.items()}
    bearing = row_bearing(case.bearing, case.bearing, frozenset(), arrays)
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        clearance, warm = _clearance(case, bearing, arrays)
        field, running = _as_given(replace(bearing, **warm), clearance)
    rivals = ("bearing.diametral_clearance", "bearing.contact_angle")
    replaced = (*MOUNTED_FIELDS, *(rivals if case.bearing.element == "ball" else (field,)))
    kept = {name: array for name, array in arrays.items() if name not in replaced}
    kept |= {f"bearing.{name}": array for name, array in warm.items()}
    of_bearing = None if case.temperature is None else case.temperature.of_bearing
    return case.replace(mounting=None, temperature=of_bearing), {**kept, field: running}


def _clearance(
    case: Case, bearing: Any, arrays: Mapping[str, FloatArray]
) -> tuple[FloatArray, dict[str, FloatArray]]:
    """Clearance in operation at the limit that the mounting names, NaN where none is; warm sizes.

    The clearance (cases,), and the sizes that the temperatures leave, by field.
    """
    mounting = mounting_of(case, arrays)
    assembly = gathered(
        bearing,
        mounting,
        temperatures_of(case, arrays),
        arrays.get("duty.inner_speed", case.duty.inner_speed),
        arrays.get("duty.outer_speed", case.duty.outer_speed),
    )
    try:
        initial, reading = initial_of_row(assembly, case.bearing, arrays)
        chain = Chain(assembly, initial, reading, shaft_bands(mounting), housing_bands(mounting))
    except InputError as error:
        raise error.with_details(field=f"mounting.{error.field}") from None
    found = np.asarray(chain.at(mounting.limit))
    clearance = np.where(inside_seats(assembly, mounting), found, np.nan)
    return clearance, warm_geometry(bearing, assembly.strains)


def inside_seats(assembly: Any, mounting: Any) -> Any:
    """Return where the rings lie between shaft and housing."""
    inside = (mounting.bore < assembly.inner_raceway) & (
        mounting.outside_diameter > assembly.outer_raceway
    )
    inside = inside & (mounting.shaft_bore < mounting.bore)
    if mounting.housing_outside_diameter is not None:
        inside = inside & (mounting.outside_diameter < mounting.housing_outside_diameter)
    return inside


def initial_of_row(
    assembly: Any, row: Bearing | RollerBearing, arrays: Mapping[str, FloatArray]
) -> tuple[Band, float | None]:
    """Clearance before mounting; the bearing's own if that is what varies.

    Raises
    ------
    InputError
        If what varies contradicts the mounting.
    """
    varied = [name for name in arrays if name.startswith("bearing.") and name not in _OF_SETS]
    own = {"bearing.diametral_clearance", "bearing.contact_angle"} & set(varied)
    mounting = assembly.mounting
    given = mounting.clearance_class or mounting.measured_clearance
    if given and own:
        raise InputError(
            said("is given, and {field} varies: give only one of them", field=min(own)),
            field="clearance_class" if mounting.clearance_class else "measured_clearance",
            value=given,
        )
    if mounting.measured_clearance is not None and varied:
        raise InputError(
            said(
                "cannot be traced back while {varied} varies; give the clearance itself",
                varied=varied[0],
            ),
            field="measured_clearance",
            example="bearing.diametral_clearance",
        )
    if own:
        return Band(assembly.initial_clearance, assembly.initial_clearance), None
    return initial_band(assembly, row)


def _as_given(bearing: Any, clearance: FloatArray) -> tuple[str, FloatArray]:
    """The field that the bearing is given by, and its values as it runs."""
    if bearing.bearing_type.conical:
        angle = bearing.contact_angle + 0.0 * clearance
        return "bearing.contact_angle", np.asarray(angle)
    if bearing.bearing_type.has_rollers:
        fits = roller_clearance_fits(clearance, bearing.roller_diameter)
        return "bearing.diametral_clearance", np.where(fits, clearance, np.nan)
    reach = bearing.ball_diameter * (bearing.inner_conformity + bearing.outer_conformity - 1.0)
    fits = clearance_fits(clearance, reach)
    if bearing.contact_angle is None:
        return "bearing.diametral_clearance", np.where(fits, clearance, np.nan)
    one_sided = np.asarray(bearing.contact_angle) > 0.0
    fits &= (clearance >= 0.0) | ~one_sided
    if not np.any(one_sided):  # an angle of nought: two-sided, as a clearance
        return "bearing.diametral_clearance", np.where(fits, clearance, np.nan)
    angle = free_contact_angle(clearance, reach)
    return "bearing.contact_angle", np.where(fits, angle, np.nan)


def row_bearing(
    bearing: Bearing | RollerBearing,
    row: Bearing | RollerBearing,
    own: Set[str],
    arrays: Mapping[str, FloatArray],
) -> Any:
    """A row's bearing with the arrays for its attributes; own: what the row has of its own.

    Raises
    ------
    InputError
        If it has no inner ring that could be fitted.
    """
    check_two_rings(row)
    return parameters_of(bearing, row, frozenset(own), arrays)


MountingParameters: Any = make_dataclass(
    "MountingParameters", [(name, Any) for name in Mounting.model_fields], frozen=True, eq=False
)
"""A mounting in many cases: the fields of its record, numbers or arrays (cases,)."""


def mounting_of(case: Case, arrays: Mapping[str, FloatArray]) -> Any:
    """The mounting of many cases; what varies takes the place of its rivals."""
    given = {
        name: arrays.get(f"mounting.{name}", getattr(case.mounting, name))
        for name in Mounting.model_fields
    }
    for name in MOUNTED_FIELDS:
        if name in arrays:
            rivals = Case.fields()[name].rivals
            given.update((rival.removeprefix("mounting."), None) for rival in rivals)
    return MountingParameters(**given)


def temperatures_of(case: Case, arrays: Mapping[str, FloatArray]) -> PartTemperatures:
    """The temperatures of the parts in many cases."""
    own = case.temperature or PartTemperatures()
    return PartTemperatures(
        **{name: arrays.get(f"temperature.{name}", getattr(own, name)) for name in _PARTS}
    )
