"""Palmgren's and SKF's torque and the oil's rolling resistance against figures of others."""

from __future__ import annotations

from math import pi
from pathlib import Path

import numpy as np
import pytest

from rolamento import load_case
from rolamento.errors import InputError
from rolamento.friction import MachineBearing, friction
from rolamento.friction.palmgren import (
    constants_by_type,
    friction_load,
    load_torque,
    lubricant_torque,
    palmgren,
)
from rolamento.friction.rolling_resistance import rolling_force
from rolamento.friction.skf import (
    SkfConstants,
    constants_by_series,
    series_constants,
    skf_moment,
    skf_torque,
)
from rolamento.friction.slip import Patch
from rolamento.solution import solve

EXAMPLES = Path(__file__).parents[2] / "src" / "rolamento" / "examples"
RPM = pi / 30.0
CST = 1e-6


def test_palmgren_lubricant_torque_by_hand() -> None:
    # ν n = 20 × 3000 = 60 000; 60 000^(2/3) = 1532.6; 1e-7 × 2 × 1532.6 × 50³ = 38.3 N·mm
    assert lubricant_torque(20 * CST, 3000 * RPM, 50e-3, 2.0) == pytest.approx(38.31e-3, rel=1e-3)
    # below 2000: 160e-7 × 2 × 50³ = 4.0 N·mm, whatever the speed
    for rpm in (0.0, 10.0, 99.0):
        assert lubricant_torque(20 * CST, rpm * RPM, 50e-3, 2.0) == pytest.approx(4.0e-3)


def test_palmgren_agrees_with_the_thermal_literature_of_machine_tools() -> None:
    """ThermCA (after Jungnickel 2010) in SI: 36 008 f0 r³ (ν ω)^0.666 and 128 f0 r³ at rest."""
    radius, f0, viscosity, speed = 0.03, 3.3, 68e-6, 1000 * RPM
    si = 36008.0 * f0 * radius**3 * (viscosity * speed) ** 0.666
    assert lubricant_torque(viscosity, speed, 2 * radius, f0) == pytest.approx(si, rel=1e-2)
    assert lubricant_torque(viscosity, 0.0, 2 * radius, f0) == pytest.approx(128 * f0 * radius**3)


def test_palmgren_load_torque_agrees_at_a_tenth_of_the_rating() -> None:
    """f1 = 0.00046 there (Jungnickel 2010), 0.001 × 0.1^0.33 = 0.00047 by Harris."""
    f1 = load_torque(1.0, 1.0, 0.1, "angular_contact")
    assert f1 == pytest.approx(0.00046, rel=0.03)


def test_palmgren_friction_load() -> None:
    assert friction_load(1000.0, 0.0, "deep_groove") == 1000.0
    assert friction_load(1000.0, 500.0, "deep_groove") == pytest.approx(1400.0)
    assert friction_load(100.0, -1000.0, "angular_contact", np.radians(40.0)) == pytest.approx(
        0.9 * 1000.0 / np.tan(np.radians(40.0)) - 10.0
    )


def test_palmgren_as_a_torque() -> None:
    found = palmgren(
        kind="deep_groove",
        lubrication="oil_bath",
        speed=np.array([0.0, 100.0]),
        mean_diameter=50e-3,
        kinematic_viscosity=20 * CST,
        radial_load=1000.0,
        axial_load=0.0,
        static_load_ratio=0.1,
    )
    np.testing.assert_allclose(found.total, found.parts["lubricant"] + found.parts["load"])
    own = constants_by_type()["deep_groove"]
    z, y = own.z, own.y
    np.testing.assert_allclose(found.parts["load"], z * 0.1**y * 1000.0 * 0.05)
    np.testing.assert_allclose(found.power, found.total * [0.0, 100.0])


@pytest.mark.parametrize(
    ("design", "r", "s", "k_z"),
    [
        ("angular_contact", (5.03e-7, 1.97, 1.90e-12), (1.30e-2, 0.68, 1.91e-12), 4.4),
        ("double_row", (6.34e-7, 1.41, 7.83e-13), (7.56e-3, 1.21, 7.83e-13), 3.1),
        ("four_point", (4.78e-7, 2.42, 1.40e-12), (1.20e-2, 0.9, 1.40e-12), 3.1),
    ],
)
def test_skf_angular_contact_constants_are_those_of_the_catalogue(
    design: str, r: tuple[float, ...], s: tuple[float, ...], k_z: float
) -> None:
    """A bearing of size 210 by hand: d_m = 70 mm, 2 and 1 kN, 3000 r/min, 30 mm²/s."""
    found = skf_moment(
        series_constants(design),
        speed=3000 * RPM,
        bore_diameter=50e-3,
        outside_diameter=90e-3,
        kinematic_viscosity=30 * CST,
        radial_load=2000.0,
        axial_load=1000.0,
        supply="bath",
    )
    thrown = 70.0**4 * 3000.0**2
    g_rr = r[0] * 70**1.97 * (2000 + r[2] * thrown + r[1] * 1000) ** 0.54
    g_sl = s[0] * 70**0.26 * ((2000 + s[2] * thrown) ** (4 / 3) + s[1] * 1000 ** (4 / 3))
    heating = 1.0 / (1.0 + 1.84e-9 * (3000 * 70) ** 1.28 * 30**0.64)
    starved = np.exp(-3e-8 * 30 * 3000 * (50 + 90) * np.sqrt(k_z / (2 * (90 - 50))))
    share = np.exp(-2.6e-8 * (3000 * 30) ** 1.4 * 70)
    mu = share * 0.12 + (1 - share) * 0.05
    assert found.rolling == pytest.approx(1e-3 * heating * starved * g_rr * 90000**0.6)
    assert found.sliding == pytest.approx(1e-3 * mu * g_sl)


def test_skf_refuses_an_unknown_design() -> None:
    with pytest.raises(InputError, match="deep_groove, angular_contact, double_row"):
        series_constants("triple_row")


@pytest.mark.parametrize(
    ("constants", "degrees", "valid"),
    [
        (series_constants("angular_contact"), 40.0, True),
        (series_constants("angular_contact"), 25.0, False),
        (series_constants("double_row"), 30.0, True),
        (series_constants("double_row"), 40.0, False),
        (series_constants("four_point"), 35.0, True),
        (SkfConstants("angular_contact", 5e-7, 2.0, 1e-2, 0.7), 25.0, True),
    ],
)
def test_skf_angular_contact_constants_are_for_one_contact_angle(
    constants: SkfConstants, degrees: float, valid: bool
) -> None:
    state = solve(load_case(EXAMPLES / "218_combined.toml"))
    machine = MachineBearing(
        kind="angular_contact",
        bore_diameter=90e-3,
        outside_diameter=160e-3,
        kinematic_viscosity=20 * CST,
        static_load_rating=120e3,
        contact_angle=float(np.radians(degrees)),
        constants=constants,
    )
    found = friction(state, friction_coefficient=0.1, machine=machine, film_parameter=5.0)
    (validity,) = (own for own in found.validity if own.model == "skf")
    assert bool(validity.valid[0]) is valid
    assert ("other_angle" in validity.notes) is not valid
    assert found.models["skf"].total[0] > 0.0


@pytest.mark.parametrize(
    ("change", "field"),
    [
        ({"kind": "roller"}, "kind"),
        ({"lubrication": "water"}, "lubrication"),
        ({"mean_diameter": 0.0}, "mean_diameter"),
        ({"kinematic_viscosity": -1.0}, "kinematic_viscosity"),
        ({"kind": "angular_contact", "contact_angle": 0.0}, "contact_angle"),
    ],
)
def test_palmgren_refuses(change: dict[str, object], field: str) -> None:
    given: dict[str, object] = {
        "kind": "deep_groove",
        "lubrication": "grease",
        "speed": 100.0,
        "mean_diameter": 50e-3,
        "kinematic_viscosity": 20 * CST,
        "radial_load": 1000.0,
        "axial_load": 0.0,
        "static_load_ratio": 0.1,
        **change,
    }
    with pytest.raises(InputError, match=field):
        palmgren(**given)  # type: ignore[arg-type]


def moment_61811(rpm: float) -> object:
    return skf_moment(
        series_constants("deep_groove", "618"),
        speed=rpm * RPM,
        bore_diameter=55e-3,
        outside_diameter=72e-3,
        kinematic_viscosity=30 * CST,
        radial_load=6.51,
    )


def test_skf_worked_figures_of_61811() -> None:
    """A published decomposition of measured free-run losses (2 × 61811, ν = 30, F_r = 6.51 N).

    It prints 0.0032 N·m of rolling at 2000 rpm without φ_ish and φ_rs, and 2.5e-6 N·m of sliding
    with μ_sl = 0.05.
    """
    found = moment_61811(2000.0)
    plain = found.rolling / (found.inlet_heating * found.replenishment)  # type: ignore[attr-defined]
    assert plain == pytest.approx(0.0032, abs=0.00006)
    sliding = found.sliding / found.sliding_coefficient * 0.05  # type: ignore[attr-defined]
    assert sliding == pytest.approx(2.5e-6, abs=0.06e-6)


def test_skf_factors_by_hand() -> None:
    found = moment_61811(2000.0)
    # (2000 × 63.5)^1.28 = 3.407e6, 30^0.64 = 8.817: 1/(1 + 0.05527)
    assert found.inlet_heating == pytest.approx(0.9476, abs=2e-4)  # type: ignore[attr-defined]
    # 6e-8 × 30 × 2000 × 127 × √(3.1/34) = 0.1381
    assert found.replenishment == pytest.approx(0.8710, abs=2e-4)  # type: ignore[attr-defined]
    # 2.6e-8 × 60 000^1.4 × 63.5 = 8.08: full film
    assert found.sliding_coefficient == pytest.approx(0.05002, abs=1e-5)  # type: ignore[attr-defined]


def test_skf_with_axial_load_by_hand() -> None:
    """6205: d_m 38.5, C_0 7800 N, F_r 500 N, F_a 200 N, formulas of table 2a."""
    found = skf_moment(
        series_constants("deep_groove", "62"),
        speed=1500 * RPM,
        bore_diameter=25e-3,
        outside_diameter=52e-3,
        kinematic_viscosity=40 * CST,
        radial_load=500.0,
        axial_load=200.0,
        static_load_rating=7800.0,
    )
    sine = np.sin(np.radians(24.6 * (200 / 7800) ** 0.24))
    rolling = 3.9e-7 * 38.5**1.96 * (500 + 1.7 * 200 / sine) ** 0.54 * 60000**0.6
    sliding = 3.23e-3 * 38.5**-0.145 * (500**5 + 36.5 * 38.5**1.5 / sine * 200**4) ** (1 / 3)
    assert found.rolling == pytest.approx(
        1e-3 * rolling * found.inlet_heating * found.replenishment
    )
    assert found.sliding == pytest.approx(1e-3 * sliding * found.sliding_coefficient)
    assert found.starting == pytest.approx(1e-3 * sliding * 0.15)
    as_torque = skf_torque(found, 1500 * RPM)
    assert as_torque.total[0] == pytest.approx(float(found.rolling + found.sliding))


def test_skf_axial_form_meets_the_radial_one_only_in_rolling() -> None:
    """As F_a → 0 the rolling variable is continuous; the sliding one is tabulated apart."""
    given = {
        "speed": 1500 * RPM,
        "bore_diameter": 25e-3,
        "outside_diameter": 52e-3,
        "kinematic_viscosity": 40 * CST,
        "radial_load": 500.0,
        "static_load_rating": 7800.0,
    }
    constants = series_constants("deep_groove", "62")
    without = skf_moment(constants, **given)  # type: ignore[arg-type]
    nearly = skf_moment(constants, axial_load=1e-9, **given)  # type: ignore[arg-type]
    assert nearly.rolling == pytest.approx(without.rolling, rel=1e-6)
    expected = 38.5 ** (0.26 - 0.145)
    assert nearly.sliding / without.sliding == pytest.approx(expected, rel=1e-6)


def test_skf_angular_contact_by_hand() -> None:
    constants = SkfConstants("angular_contact", 4e-7, 2.0, 1.5e-2, 0.7, 1e-12, 2e-12, 4.4)
    found = skf_moment(
        constants,
        speed=6000 * RPM,
        bore_diameter=40e-3,
        outside_diameter=80e-3,
        kinematic_viscosity=20 * CST,
        radial_load=300.0,
        axial_load=800.0,
        supply="jet",
        oil="synthetic",
    )
    thrown = 60.0**4 * 6000.0**2
    rolling = 4e-7 * 60**1.97 * (300 + 1e-12 * thrown + 1600) ** 0.54 * 120000**0.6
    sliding = 1.5e-2 * 60**0.26 * ((300 + 2e-12 * thrown) ** (4 / 3) + 0.7 * 800 ** (4 / 3))
    factor = found.inlet_heating * found.replenishment
    assert found.rolling == pytest.approx(1e-3 * rolling * factor)
    assert found.sliding == pytest.approx(1e-3 * sliding * found.sliding_coefficient)
    assert found.sliding_coefficient == pytest.approx(0.04, abs=1e-4)


def test_skf_boundary_friction_at_rest_and_full_film_at_speed() -> None:
    slow, fast = moment_61811(0.0), moment_61811(1e4)
    assert slow.rolling == 0.0  # type: ignore[attr-defined]
    assert slow.sliding_coefficient == pytest.approx(0.12)  # type: ignore[attr-defined]
    assert fast.sliding_coefficient == pytest.approx(0.05)  # type: ignore[attr-defined]


def test_skf_series_are_those_of_the_catalogue() -> None:
    known = constants_by_series("deep_groove")
    assert len(known) == 20
    assert all(c.kind == "deep_groove" and c.k_z == 3.1 for c in known.values())
    with pytest.raises(InputError, match="series"):
        series_constants("deep_groove", "NU2")


@pytest.mark.parametrize(
    ("change", "field"),
    [
        ({"outside_diameter": 50e-3}, "outside_diameter"),
        ({"axial_load": 10.0}, "static_load_rating"),
        ({"supply": "spray"}, "supply"),
        ({"oil": "olive"}, "oil"),
    ],
)
def test_skf_refuses(change: dict[str, object], field: str) -> None:
    given: dict[str, object] = {
        "speed": 100.0,
        "bore_diameter": 55e-3,
        "outside_diameter": 72e-3,
        "kinematic_viscosity": 30 * CST,
        "radial_load": 6.51,
        **change,
    }
    with pytest.raises(InputError, match=field):
        skf_moment(series_constants("deep_groove", "618"), **given)  # type: ignore[arg-type]


def circle(load: float, radius: float, modulus: float) -> Patch:
    """A sphere of a radius on a plane; the groove's data do not enter."""
    a = np.cbrt(1.5 * load * radius / modulus)
    return Patch("inner", *(np.array(x) for x in (load, 0.0, a, a, 2 * radius, 20 * radius, 0.55)))


@pytest.mark.parametrize("ratio", [500.0, 1000.0, 4000.0])
def test_force_of_rolling_on_one_surface_is_that_of_kapitza(ratio: float) -> None:
    """Rigid sphere, isoviscous oil, pressure ahead of the middle only: p = -(12/5) η u x/h².

    W = (24π/5) η u R √(R/2h0); on each surface F = ½ ∫ h ∂p/∂x dA = (6π/5) η u R [ln(1+s) +
    1/(1+s) - 1] with s = r²/(2 R h0) at the rim of the flooded inlet, r = R/2. Were the formula
    the force on both surfaces, the ratio would be 0.6; for the flooding it may be off by half.
    """
    radius, viscosity, speed = 5e-3, 0.05, 1.0
    unit = viscosity * speed * radius
    force = rolling_force(circle(ratio * unit, radius, 1e18), 1.0 / radius, 1e18, viscosity, speed)
    gap = 0.5 * (24.0 * pi / 5.0 / ratio) ** 2
    s = 0.5**2 / (2.0 * gap)
    kapitza = 1.2 * pi * (np.log1p(s) + 1.0 / (1.0 + s) - 1.0)
    assert 0.9 < force / unit / kapitza < 1.5


def test_rolling_force_of_the_rigid_limit_knows_no_modulus() -> None:
    forces = [rolling_force(circle(0.1, 5e-3, e), 200.0, e, 0.05, 1.0) for e in (1e18, 1e20, 1e22)]
    np.testing.assert_allclose(forces, forces[0], rtol=2e-3)


def test_rolling_force_of_a_ball_in_a_groove_as_in_d_brain() -> None:
    """NSK's D-BRAIN tests its code against 0.7780845 N·mm for F R_x (TribologyTest)."""
    d, race, w, a, b = 4.365e-3, 40.635e-3, 136.0, 429.5e-6, 76.762e-6
    eta, e = 43.691e-3, 207e9 / (1.0 - 0.3**2)
    radius = 1.0 / (2.0 / d + 1.0 / race)
    pitch = 2.0 * race + d
    speed = 0.25 * d * (pitch / d - d / pitch) * 10000 * RPM
    patch = Patch("inner", *(np.array(x) for x in (w, 0.0, a, b, d, pitch, 0.53)))
    found = float(rolling_force(patch, 1.0 / radius, e, eta, speed)) * radius
    assert found == pytest.approx(0.7780845243544707e-3, rel=2e-5)


def test_nothing_resists_without_load_oil_or_speed() -> None:
    for load, eta, speed in ((0.0, 0.1, 1.0), (1.0, 0.0, 1.0), (1.0, 0.1, 0.0)):
        assert rolling_force(circle(load, 5e-3, 2e11), 200.0, 2e11, eta, speed) == 0.0
