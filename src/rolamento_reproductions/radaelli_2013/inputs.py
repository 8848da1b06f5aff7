"""The inputs: bearings, loads and speeds as the dissertation gives them, in SI where they leave."""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from rolamento.case import Case
from rolamento.case.bearing import Bearing
from rolamento.case.duty import Duty
from rolamento.case.material import Material
from rolamento.case.model import Model
from rolamento_reproductions.given import KILO, MILLI, RPM, Given, grid, status_column
from rolamento_reproductions.text import Text

__all__ = [
    "KILO",
    "MILLI",
    "RPM",
    "bearing",
    "case",
    "data",
    "grid",
    "inputs_of",
    "modulus",
    "source_of",
    "status_column",
    "steel",
]

_GIVEN: Final = Given("radaelli_2013")


def data() -> dict[str, Any]:
    """Return the data file: inputs and printed numbers, each with its place in the source."""
    return _GIVEN.data


def inputs_of(name: str) -> dict[str, Any]:
    """Return one table of the data file."""
    return _GIVEN.inputs_of(name)


def source_of(name: str) -> Text:
    """Return where a table's inputs stand, or how they were chosen."""
    return _GIVEN.source_of(name)


def modulus() -> float:
    """Young's modulus behind the printed stiffness constant; Pa.

    K = √8/3 · E/(1 - ν²) · Σρ^-½ δ*^-3/2 is Radaelli's eq. 11 with 2.15e5 N, mm for the first two
    factors.
    """
    constant, poisson = data()["stiffness_constant"], data()["poisson_ratio"]
    return float(constant * 1e6 * 3.0 / np.sqrt(8.0) * (1.0 - poisson**2))


def steel() -> Material:
    """Return the material of rings and balls."""
    return Material(
        name="Radaelli's steel",
        youngs_modulus=modulus(),
        poisson_ratio=data()["poisson_ratio"],
        density=data()["density"],
    )


def bearing(name: str) -> Bearing:
    """Return the 209 or the 218, tables 5.1 and 5.2."""
    given: dict[str, Any] = data()["bearings"][name]
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
