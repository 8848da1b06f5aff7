"""The heat balance of one bearing as makers print it: friction over temperature against cooling.

SKF, Rolling bearings, "Power loss and bearing temperature": ΔT = N_R/W_s, N_R = 1.05e-4 M n, with M
in N·mm, n in r/min and the cooling factor W_s in W/K. Makers' examples let the convection q/50 K
over π B 2 d_m of ISO 15312 and 30 W/(l/min K) of oil remove what Palmgren's torque at the oil's
temperature makes: the crossing of two curves. Their printed example of a 6220 is not at hand; the
crossing is found here without the program's network, by Brent's method.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq

from rolamento import load_case
from rolamento.friction.palmgren import palmgren
from rolamento.heat import CONDUCTANCES, heat_balance
from rolamento.oil.state import oil_state

SPEED = 3000.0 * np.pi / 30.0
LOAD = 10e3
PERFECT = {
    f"heat.{name}": 1e8
    for name in CONDUCTANCES
    if not name.endswith("ambient")
}  # fmt: skip


def wheel(**changes: object) -> object:
    values = {
        "duty.load.fz": LOAD,
        "duty.inner_speed": SPEED,
        "lubricant": "ISO VG 68",
        "heat.friction": "palmgren",
        **PERFECT,
        **changes,
    }
    return load_case("6220", values)


def torque(case: object, temperature: float) -> float:
    """Palmgren's torque of a 6220 in an oil bath, N·m."""
    state = oil_state(case.lubricant, np.array([temperature]))  # type: ignore[attr-defined]
    static = case.bearing.published.static_rating  # type: ignore[attr-defined]
    found = palmgren(
        kind="deep_groove",
        lubrication="oil_bath",
        speed=SPEED,
        mean_diameter=0.14,
        kinematic_viscosity=state.kinematic_viscosity,
        radial_load=LOAD,
        axial_load=0.0,
        static_load_ratio=LOAD / static,
    )
    return float(found.total[0])


@pytest.mark.parametrize("factor", [5.0, 12.0, 40.0])
def test_the_cooling_factor_of_skf(factor: float) -> None:
    """All parts as one: ΔT = 1.05e-4 M n/W_s."""
    case = wheel(**{"heat.shaft_ambient": 0.0, "heat.housing_ambient": factor})
    found = heat_balance(case)  # type: ignore[arg-type]
    assert found.warm is not None
    loss = 1.05e-4 * 1e3 * found.warm.torque * 3000.0
    rise = found.temperatures["outer_ring"] - 293.15
    assert rise == pytest.approx(loss / factor, rel=0.003)  # π/30 is printed as 0.105


@pytest.mark.parametrize("oil", [0.0, 0.5, 3.0])
def test_the_balance_is_the_crossing_of_the_two_curves(oil: float) -> None:
    """Convection over π B 2 d_m by the reference heat flow density, and oil."""
    changes = {"heat.oil_flow": oil / 60e3, "heat.oil_inlet": 303.15} if oil else {}
    case = wheel(**changes)
    density = 0.016 * 1e6  # up to 50 000 mm², W/m²
    area = np.pi * 0.034 * 2.0 * 0.14

    def excess(temperature: float) -> float:
        removed = density / 50.0 * area * (temperature - 293.15)
        removed += 30.0 * oil * (temperature - 303.15)
        return torque(case, temperature) * SPEED - removed

    crossing = brentq(excess, 293.15, 423.15, xtol=1e-9)
    found = heat_balance(case)  # type: ignore[arg-type]
    assert found.temperatures["housing"] == pytest.approx(crossing, abs=0.01)
    assert found.power == pytest.approx(torque(case, crossing) * SPEED, rel=2e-3)
    for temperature, friction in zip(
        found.curve.temperatures[0], found.curve.friction, strict=True
    ):
        assert friction == pytest.approx(torque(case, float(temperature)) * SPEED, rel=2e-3)
