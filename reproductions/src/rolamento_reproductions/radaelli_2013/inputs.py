"""The inputs: bearings, loads and speeds as the dissertation gives them, in SI where they leave."""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from rolamento.case import Case
from rolamento.case.bearing import Bearing
from rolamento.case.duty import Duty
from rolamento.case.material import Material
from rolamento.case.model import Model
from rolamento_reproductions.given import MILLI, Given
from rolamento_reproductions.text import Prose

GIVEN: Final = Given("radaelli_2013")
said: Final = Prose(GIVEN.name)
inputs_of = GIVEN.inputs_of
source_of = GIVEN.source_of


def modulus() -> float:
    """Young's modulus behind the printed stiffness constant; Pa.

    K = √8/3 · E/(1 - ν²) · Σρ^-½ δ*^-3/2 is Radaelli's eq. 11 with 2.15e5 N, mm for the first two
    factors.
    """
    constant, poisson = GIVEN.data["stiffness_constant"], GIVEN.data["poisson_ratio"]
    return float(constant * 1e6 * 3.0 / np.sqrt(8.0) * (1.0 - poisson**2))


def steel() -> Material:
    """Return the material of rings and balls."""
    return Material(
        name="Radaelli's steel",
        youngs_modulus=modulus(),
        poisson_ratio=GIVEN.data["poisson_ratio"],
        density=GIVEN.data["density"],
    )


def bearing(name: str) -> Bearing:
    """Return the 209 or the 218, tables 5.1 and 5.2."""
    given: dict[str, Any] = GIVEN.data["bearings"][name]
    angle, clearance = given.get("contact_angle_deg"), given.get("diametral_clearance_mm")
    return Bearing(
        ball_count=given["ball_count"],
        ball_diameter=given["ball_diameter_mm"] * MILLI,
        pitch_diameter=given["pitch_diameter_mm"] * MILLI,
        contact_angle=None if angle is None else np.radians(angle),
        diametral_clearance=None if clearance is None else clearance * MILLI,
        inner_conformity=given["inner_conformity"],
        outer_conformity=given["outer_conformity"],
        ring_material=steel(),
    )


def case(duty: Duty | None = None, model: Model | None = None) -> Case:
    """Return a case of the 218: outer raceway control alone, as in the dissertation."""
    model = (model or Model()).replace(cage="none")
    return Case(bearing=bearing("218"), duty=duty or Duty(), model=model)
