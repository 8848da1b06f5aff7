"""Which fields of a case a batch may vary as arrays, and which of their values are valid."""

from __future__ import annotations

from functools import cache
from typing import Any, Final, get_args

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel

from rolamento.case import Case
from rolamento.case.bearing import balls_fit, clearance_fits
from rolamento.case.duty import AXES, LOADS
from rolamento.case.quantity import Quantity, Ratio
from rolamento.case.record import record_of
from rolamento.clearance.batch import MOUNTED_FIELDS

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

_MATERIAL: Final = ("youngs_modulus", "poisson_ratio", "density")
GEOMETRY: Final = (
    "ball_diameter",
    "pitch_diameter",
    "contact_angle",
    "diametral_clearance",
    "inner_conformity",
    "outer_conformity",
)
LIFE: Final = (
    "dynamic_rating",
    "static_rating",
    "fatigue_load_limit",
    "contamination",
    "viscosity_ratio",
    "material_factor",
    "operation_factor",
    "fatigue_limit",
    "nsk_cleanliness",
)
PRELOADS: Final = ("force", "offset", "spring")

SHORT_NAMES: Final = {
    **{name: f"duty.{name}" for name in ("inner_speed", "outer_speed", "first_ball_azimuth")},
    **{name: f"duty.load.{name}" for name in LOADS},
    **{name: f"duty.displacement.{name}" for name in AXES},
}
"""What `solve_batch` takes as keywords."""

BATCH_FIELDS: Final = (
    *SHORT_NAMES.values(),
    *(f"bearing.{name}" for name in GEOMETRY),
    *(
        f"bearing.{part}.{name}"
        for part in ("ring_material", "ball_material")
        for name in _MATERIAL
    ),
    "bearing.spacing",
    *(f"bearing.preload.{name}" for name in PRELOADS),
    "lubricant.friction_coefficient",
    "model.cage_drag",
    "temperature.lubricant",
    *(f"life.{name}" for name in LIFE),
    *MOUNTED_FIELDS,
)
"""Those of temperature and life change no equilibrium: they are for film and life. The last ones
are for a mounted bearing, whose clearance they change before it comes here."""


def batch_fields() -> tuple[str, ...]:
    """Return the dotted names of the fields that a batch may vary as arrays, in SI units."""
    return BATCH_FIELDS


def within_bounds(field: str, values: Floats) -> Flags:
    """Tell which values a field would take: finite, and within its own bounds."""
    return np.asarray(_annotation(field).allows(values))


def consistent(bearing: Any, displacement: dict[str, Floats], ball_count: int) -> Flags:
    """Tell in which cases the fields do not contradict each other, as `Bearing` and `Case` have it.

    bearing: attributes as arrays; displacement: what is imposed, by axis.
    """
    diameter, pitch = bearing.ball_diameter, bearing.pitch_diameter
    sound = (pitch > diameter) & balls_fit(ball_count, diameter, pitch)
    if bearing.diametral_clearance is not None:
        reach = diameter * (bearing.inner_conformity + bearing.outer_conformity - 1.0)
        sound = sound & clearance_fits(bearing.diametral_clearance, reach)
    for height in (bearing.inner_shoulder_height, bearing.outer_shoulder_height):
        if height is not None:
            sound = sound & (height < diameter / 2)
    for axis in ("x", "y", "z"):
        if axis in displacement:
            sound = sound & (np.abs(displacement[axis]) <= diameter)
    return np.asarray(sound)


@cache
def _annotation(field: str) -> Quantity | Ratio:
    """The annotation that bounds a field of a case."""
    *path, name = field.split(".")
    record: type[BaseModel] = Case
    for part in path:
        inner = record_of(record.model_fields[part].annotation)
        assert inner is not None
        record = inner
    info = record.model_fields[name]
    found = _bounds_in((*info.metadata, info.annotation))
    assert found is not None
    return found


def _bounds_in(parts: tuple[Any, ...]) -> Quantity | Ratio | None:
    for part in parts:
        if isinstance(part, Quantity | Ratio):
            return part
        inner = _bounds_in((*getattr(part, "__metadata__", ()), *get_args(part)))
        if inner is not None:
            return inner
    return None
