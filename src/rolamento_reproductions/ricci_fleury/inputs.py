"""The bearing of Ricci and Fleury, and cases of it."""

from __future__ import annotations

from typing import Final

import numpy as np

from rolamento.case import Case
from rolamento.case.bearing import Bearing
from rolamento.case.duty import Duty, Load
from rolamento.case.model import Model
from rolamento_reproductions.given import MILLI, RPM, Given

__all__ = ["GIVEN", "case"]

GIVEN: Final = Given("ricci_fleury")


def case(axial_load: float, speed_rpm: float, *, outer_conformity: float | None = None) -> Case:
    """Return a case of the bearing under thrust.

    Without the gyroscopic moment: Harris's model of 1971 has no force that could carry it, and
    the models of figure 8 are for speeds at which it is nothing.
    """
    given = GIVEN.inputs_of("bearing")
    conformity = given["conformity"]
    bearing = Bearing(
        ball_count=given["ball_count"],
        ball_diameter=given["ball_diameter_mm"] * MILLI,
        pitch_diameter=0.5 * (given["bore_mm"] + given["outside_mm"]) * MILLI,
        contact_angle=np.radians(given["contact_angle_deg"]),
        inner_conformity=conformity,
        outer_conformity=conformity if outer_conformity is None else outer_conformity,
    )
    return Case(
        bearing=bearing,
        duty=Duty(inner_speed=speed_rpm * RPM, load=Load(fx=axial_load)),
        model=Model(gyroscopic_moment=False),
    )
