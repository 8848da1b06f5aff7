"""Friswell, Penny, Garvey and Lees, Dynamics of Rotating Machines (2010), example 5.9.1.

A shaft of 1.5 m, 50 mm, six elements, with two disks of 70 mm: 280 mm at 0.5 m, 350 mm at 1 m, on
bearings of 1 MN/m at the ends; E 211 GPa, G 81.2 GPa, 7810 kg/m³. Natural frequencies in rad/s.
"""

from __future__ import annotations

import numpy as np
import pytest

from rolamento.case.machine import Machine, Mass, Shaft
from rolamento.system.beam import Elements
from rolamento.system.network import FIVE, Linear, Rest
from rolamento.system.rotor import rotor_of
from rolamento.system.shafts import Beam, MachineRest, Structure


@pytest.mark.parametrize(
    ("rpm", "printed"),
    [
        (0.0, [86.658, 86.658, 274.31, 274.31, 716.78, 716.78]),
        (4000.0, [85.39, 87.80, 251.78, 294.71, 600.18]),
    ],
)
def test_two_disks_on_isotropic_bearings(rpm: float, printed: list[float]) -> None:
    """To a unit of the last digit that is printed."""
    e, g = 211e9, 81.2e9
    steel = {"name": "steel", "youngs_modulus": e, "poisson_ratio": e / (2 * g) - 1,
             "density": 7810.0}  # fmt: skip
    shaft = Shaft(name="s", sections=[{"length": 1.5, "diameter": 0.05}], material=steel)
    six = [np.full(6, value) for value in
           (0.25, 0.05, 0.05, 0.0, 0.0, e, e / (2 * g) - 1, 7810.0)]  # fmt: skip
    beam = Beam(shaft, 0, np.linspace(0.0, 1.5, 7), Elements(*six))
    disks = tuple(
        Mass(shaft="s", position=place, diameter=d, bore=0.05, width=0.07, density=7810.0)
        for place, d in ((0.5, 0.28), (1.0, 0.35))
    )
    bearing = np.diag([1e9, 1e6, 1e6, 0.0, 0.0])[np.newaxis]
    springs = tuple(Linear((node,), bearing) for node in (0, 6))
    unknowns = 7 * FIVE
    structure = Structure(
        (beam,), (), springs, np.zeros(unknowns, np.bool_), (), np.zeros((1, unknowns))
    )
    rest = MachineRest(Rest.nowhere(1, unknowns, ()), np.zeros((1, 7, FIVE)))
    machine = Machine.model_construct(shafts=(shaft,), masses=disks)
    rotor = rotor_of(machine, structure, rest, {"s": np.array([rpm * np.pi / 30])})
    found = rotor.modes(0, len(printed)).frequency
    decimals = [len(f"{value}".partition(".")[2]) for value in printed]
    for value, expected, digits in zip(found, printed, decimals, strict=True):
        assert value == pytest.approx(expected, abs=10**-digits)
