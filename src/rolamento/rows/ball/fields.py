"""Which values of a ball bearing's fields go together, over many cases."""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.case.bearing import balls_fit, clearance_fits

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

GEOMETRY: Final = (
    "ball_diameter",
    "pitch_diameter",
    "contact_angle",
    "diametral_clearance",
    "inner_conformity",
    "outer_conformity",
)
PRELOADS: Final = ("force", "offset", "spring")


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
