"""Whatever happens has a name, a reason and advice; and what is shown is worth showing."""

from __future__ import annotations

import json
import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from tests.one_case import said, solve_one

from rolamento import (
    Bearing,
    Case,
    Displacement,
    Duty,
    InputError,
    Load,
    Model,
    UnknownKeyError,
    override,
)
from rolamento.kinematics import friction_demand
from rolamento.solution import solve
from rolamento.status import STATUS_NAMES

ANGULAR: dict[str, Any] = {
    "ball_count": 16,
    "ball_diameter": "22.23 mm",
    "pitch_diameter": "125.26 mm",
    "contact_angle": "40 deg",
    "inner_conformity": 0.5232,
    "outer_conformity": 0.5232,
}
DEEP_GROOVE: dict[str, Any] = {
    "ball_count": 9,
    "ball_diameter": "12.7 mm",
    "pitch_diameter": "65 mm",
    "diametral_clearance": "0.015 mm",
    "inner_conformity": 0.52,
    "outer_conformity": 0.52,
}
RPM = math.pi / 30.0


def solved(
    bearing: dict[str, Any],
    load: dict[str, Any] | None = None,
    held: dict[str, Any] | None = None,
    model: dict[str, Any] | None = None,
    **duty: Any,
) -> SimpleNamespace:
    return solve_one(
        Case(
            bearing=Bearing(**bearing),
            duty=Duty(load=Load(**load or {}), displacement=Displacement(**held or {}), **duty),
            model=Model(**model or {}),
        )
    )


def assert_no_numbers(state: SimpleNamespace) -> None:
    """NaN in the record, null in JSON, and no notes on numbers that are not there."""
    assert not state.status.converged
    assert state.status.advice
    assert all(math.isnan(value) for value in (*state.displacement, *state.load))
    assert np.isnan(state.stiffness).all()
    assert state.notes == ()
    mapping = state.to_mapping()
    assert set(mapping["displacement"].values()) == {None}
    assert set(mapping["load"].values()) == {None}
    assert {value for row in mapping["stiffness"] for value in row} == {None}
    for ball in mapping["balls"]:
        assert ball["azimuth"] is not None
        for name in ("centrifugal_force", "gyroscopic_moment", "orbital_speed", "ball_speed"):
            assert ball[name] is None
        assert {*ball["inner"].values(), *ball["outer"].values()} == {None}
    assert json.loads(state.to_json())["status"]["code"] == state.status.code


def has_note(state: SimpleNamespace, *words: str) -> bool:
    return any(all(word in note.text for word in words) for note in state.notes)


# --- converged ----------------------------------------------------------------------------------


def test_converged() -> None:
    state = solved(ANGULAR, {"fx": "20 kN", "fz": "8 kN"}, inner_speed="5000 rpm")
    assert state.status.code == "converged"
    assert state.status.converged
    assert state.status.advice is None
    assert state.status.residual < 1e-8
    assert state.status.iterations > 0
    mapping = state.to_mapping()
    assert mapping["schema"] == 3
    assert list(mapping["displacement"]) == ["x", "y", "z", "ry", "rz"]
    assert list(mapping["load"]) == ["fx", "fy", "fz", "my", "mz"]
    assert np.array(mapping["stiffness"]).shape == (5, 5)
    assert len(mapping["balls"]) == 16
    ball = mapping["balls"][0]
    assert {"row", "azimuth", "inner", "outer", "centrifugal_force", "gyroscopic_moment",
            "orbital_speed", "ball_speed"} <= set(ball)  # fmt: skip
    assert {"load", "contact_angle", "deflection", "semi_major", "semi_minor",
            "max_pressure"} <= set(ball["inner"])  # fmt: skip
    assert json.loads(state.to_json()) == mapping


def test_given_loads_come_back_exactly() -> None:
    state = solved(ANGULAR, {"fx": 2e4, "fz": 8e3, "my": 50.0}, {"rz": 1e-4}, inner_speed=500.0)
    assert state.load[:4] == (2e4, 0.0, 8e3, 50.0)
    assert state.displacement.rz == 1e-4
    assert state.load.mz != 0.0


# --- no equilibrium -----------------------------------------------------------------------------


@pytest.mark.parametrize("speed", [0.0, "6000 rpm"])
@pytest.mark.parametrize(
    "load",
    [{"fx": "-1 kN"}, {"fx": "-1 kN", "fz": "2 kN"}, {"fz": "5 kN"}, {"fy": "-5 kN"}],
    ids=["pulled", "pulled aside", "radial", "lateral"],
)
def test_nothing_supports_x(load: dict[str, str], speed: Any) -> None:
    state = solved(ANGULAR, load, inner_speed=speed)
    assert state.status.code == "no_equilibrium"
    assert "toward -x" in said(state.status.advice)
    assert "duty.load.fx" in said(state.status.advice)
    assert "duty.displacement.x" in said(state.status.advice)
    assert_no_numbers(state)


def test_the_advice_helps() -> None:
    """Holding x, or axial load of about fz tan α, as the advice says."""
    assert solved(ANGULAR, {"fz": "5 kN"}, {"x": 0.0}).status.converged
    assert solved(
        ANGULAR, {"fz": "5 kN", "fx": 5e3 * math.tan(math.radians(40.0))}
    ).status.converged


def test_negative_thrust_is_fine_on_a_bearing_with_two_shoulders() -> None:
    state = solved(DEEP_GROOVE, {"fx": "-1 kN"}, inner_speed="3000 rpm")
    assert state.status.converged
    assert all(ball.inner.contact_angle < 0.0 for ball in state.balls)


def test_a_moment_that_overturns() -> None:
    state = solved(ANGULAR, {"fx": "1 kN", "my": "2 kN m", "mz": 0.0})
    assert state.status.code == "no_equilibrium"
    assert_no_numbers(state)


def test_unsupported_names_the_degree_of_freedom() -> None:
    batch = solve(Case(bearing=Bearing(**ANGULAR), duty=Duty()), fx=[1e4, -1e3])
    assert batch.status.code.tolist() == ["converged", "no_equilibrium"]
    assert batch.status.unsupported.tolist() == [-1, 0]


# --- overloaded, invalid ------------------------------------------------------------------------


@pytest.mark.parametrize("speed", [0.0, "3000 rpm"])
def test_overloaded(speed: Any) -> None:
    state = solved(ANGULAR, {"fx": "1e5 kN"}, inner_speed=speed)
    assert state.status.code == "overloaded"
    assert "2 %" in said(state.status.advice)
    assert "units" in said(state.status.advice)
    assert_no_numbers(state)


def test_overloaded_by_a_displacement() -> None:
    state = solved(ANGULAR, {}, {"x": "2 mm"})
    assert state.status.code == "overloaded"
    assert_no_numbers(state)


def test_invalid_input_is_each_case_s_own_affair() -> None:
    case = Case(bearing=Bearing(**ANGULAR), duty=Duty(inner_speed=500.0))
    fx = np.array([1e4, np.nan, 2e4, np.inf, 3e4])
    batch = solve(case, fx=fx)
    good = solve(case, fx=fx[[0, 2, 4]])
    assert batch.status.code.tolist() == ["converged", "invalid_input"] * 2 + ["converged"]
    for race in ("inner", "outer"):
        loads, clean = (getattr(state, race).load for state in (batch, good))
        np.testing.assert_allclose(loads[[0, 2, 4]], clean, rtol=1e-8)
        assert np.isnan(loads[[1, 3]]).all()


def test_every_code_has_a_name() -> None:
    assert set(STATUS_NAMES.values()) == {
        "converged",
        "no_equilibrium",
        "not_converged",
        "overloaded",
        "invalid_input",
        "unconstrained_ball",
        "over_shoulder",
    }


def test_an_empty_batch_has_no_cases() -> None:
    batch = solve(Case(bearing=Bearing(**ANGULAR), duty=Duty()), fx=[])
    assert len(batch) == 0
    assert batch.inner.load.shape == (0, ANGULAR["ball_count"])


def test_friction_alone_carries_nothing() -> None:
    """Inner control at speed under a light thrust: in balance only by friction without load."""
    model = {"raceway_control": "inner", "cage": "none"}
    state = solved(ANGULAR, {"fx": "1 kN"}, model=model, inner_speed="10000 rpm")
    assert state.status.code in {"unconstrained_ball", "not_converged"}
    assert "raceway control cannot hold" in said(state.status.advice)
    assert_no_numbers(state)


def test_the_cage_and_the_outer_race_take_over_from_an_inner_race_without_load() -> None:
    model = {"raceway_control": "inner"}
    state = solved(ANGULAR, {"fx": "1 kN"}, model=model, inner_speed="10000 rpm")
    assert state.status.converged
    for ball in state.balls:  # the inner contact alone could not hold this moment
        assert ball.inner.load * 22.23e-3 < 20.0 * abs(ball.gyroscopic_moment)


@pytest.mark.parametrize("race", ["inner", "outer"])
def test_a_contact_beyond_the_edge_of_its_groove(race: str) -> None:
    """40 kN of thrust bring the contact to 42.7°; a groove may end below it."""
    radius = 0.5232 * 22.23e-3
    angle = solved(ANGULAR, {"fx": "40 kN"}).balls[0].inner.contact_angle
    for edge, converges in ((angle + 1e-3, True), (angle - 1e-3, False)):
        height = radius * (1.0 - math.cos(edge))
        state = solved(ANGULAR | {f"{race}_shoulder_height": height}, {"fx": "40 kN"})
        assert state.status.converged is converges
    assert state.status.code == "over_shoulder"
    assert f"the {race} " in said(state.status.advice)
    assert f"{math.degrees(edge):.1f}°" in said(state.status.advice)
    assert_no_numbers(state)


def test_a_groove_without_a_height_is_a_half_circle() -> None:
    """Thrown outward through a large clearance, the balls stand beside the inner flank."""
    tight = DEEP_GROOVE | {"inner_conformity": 0.505, "diametral_clearance": "0.13 mm"}
    assert solved(tight, {"fx": "50 N"}).status.converged
    state = solved(tight, {"fx": "50 N"}, inner_speed="10000 rpm")
    assert state.status.code == "over_shoulder"
    assert state.status.advice is not None
    assert said(state.status.advice).count("90.0°") == 2


# --- notes --------------------------------------------------------------------------------------


def test_an_unremarkable_duty_has_no_notes() -> None:
    assert solved(ANGULAR, {"fx": "5 kN"}, inner_speed="10000 rpm").notes == ()
    assert solved(ANGULAR, {"fx": "20 kN"}).notes == ()


def test_balls_without_inner_contact() -> None:
    state = solved(ANGULAR, {"fx": "5 kN", "fz": "9 kN"}, inner_speed="500 rpm")
    loose = sum(ball.inner.load == 0.0 for ball in state.balls)
    assert 0 < loose < 16
    assert has_note(state, f"{loose} balls without inner contact", "they orbit with the cage")
    assert not has_note(state, "an assumption")
    alone = {"cage": "none"}
    left = solved(ANGULAR, {"fx": "5 kN", "fz": "9 kN"}, model=alone, inner_speed="500 rpm")
    assert has_note(left, "balls without inner contact")
    assert not has_note(left, "they orbit with the cage")
    assert has_note(left, "an assumption")
    idle = solved(DEEP_GROOVE)
    assert idle.status.converged
    assert "no_load_given" in {note.key for note in idle.notes}
    held = solved(DEEP_GROOVE, held={"x": "0 mm", "y": "0 mm", "z": "1 um"})
    assert held.status.converged
    assert has_note(held, "No ball contacts the inner ring")


def test_free_direction() -> None:
    """One ball of three carries, at α = 0: it holds z, but nothing holds y."""
    one_ball = solved(DEEP_GROOVE | {"ball_count": 3}, {"fz": "10 N"})
    assert one_ball.status.converged
    assert sum(ball.inner.load > 0.0 for ball in one_ball.balls) == 1
    assert has_note(one_ball, "No ball supports the ring along y")


def test_pressure_over_4200_mpa() -> None:
    below = solved(DEEP_GROOVE, {"fz": "5 kN"})
    above = solved(DEEP_GROOVE, {"fz": "40 kN"})
    assert max(ball.inner.max_pressure for ball in below.balls) < 4.2e9
    assert max(ball.inner.max_pressure for ball in above.balls) > 4.2e9
    assert not has_note(below, "4200 MPa")
    assert has_note(above, "inner race", "4200 MPa", "ISO 76")


@pytest.mark.parametrize("race", ["inner", "outer"])
def test_shoulder_overrun(race: str) -> None:
    load = {"fx": "40 kN"}
    low, high = (
        ANGULAR | {f"{race}_shoulder_height": 4e-3},
        ANGULAR | {f"{race}_shoulder_height": 9e-3},
    )
    state = solved(low, load)
    assert has_note(state, f"at the {race} shoulder")
    assert not has_note(solved(high, load), "shoulder")
    assert not has_note(solved(ANGULAR, load), "shoulder")
    # where the ellipse ends and the groove ends, worked out apart
    contact = getattr(state.balls[0], race)
    radius = 0.5232 * 22.23e-3
    reach = math.degrees(contact.contact_angle + contact.semi_major / radius)
    edge = math.degrees(math.acos(1.0 - 4e-3 / radius))
    assert reach > edge
    assert has_note(state, f"{reach:.1f}°", f"{edge:.1f}°")


def test_an_ellipse_over_the_edge_of_a_half_circle() -> None:
    """Without a shoulder height the groove ends at 90°, which a thrown ball comes near."""
    steep = DEEP_GROOVE | {"inner_conformity": 0.505, "diametral_clearance": "0.125 mm"}
    state = solved(steep, {"fx": "500 N"}, inner_speed="10000 rpm")
    contact = state.balls[0].inner
    reach = math.degrees(contact.contact_angle + contact.semi_major / (0.505 * 12.7e-3))
    assert reach > 90.0 > math.degrees(contact.contact_angle)
    assert has_note(state, f"{reach:.1f}°", "assumed to be a half circle, ends at 90.0°")


def test_gyroscopic_slip() -> None:
    """A lightly loaded inner race cannot hold the gyroscopic moment; the outer race can."""
    load, speed = {"fx": "5 kN"}, "10000 rpm"
    state = solved(ANGULAR, load, model={"raceway_control": "inner"}, inner_speed=speed)
    ball = state.balls[0]
    demand = friction_demand(ball.gyroscopic_moment, 22.23e-3, ball.inner.load)
    assert demand > 0.1
    assert has_note(state, "coefficient of friction", f"{float(demand):.2f}", "slip")
    assert not has_note(solved(ANGULAR, load, inner_speed=speed), "coefficient of friction")
    still = solved(
        ANGULAR,
        load,
        model={"raceway_control": "inner", "gyroscopic_moment": False},
        inner_speed=speed,
    )
    assert not has_note(still, "coefficient of friction")


def test_speed_and_tilt_out_of_range() -> None:
    assert has_note(solved(ANGULAR, {"fx": "20 kN"}, inner_speed="30000 rpm"), "speed factor")
    loose = DEEP_GROOVE | {
        "inner_conformity": 0.6,
        "outer_conformity": 0.6,
        "diametral_clearance": "0.5 mm",
    }
    assert has_note(solved(loose, {"fz": "1 kN"}, {"ry": "1.5 deg"}), "tilts by 1.50°")
    assert not has_note(solved(loose, {"fz": "1 kN"}, {"ry": "0.5 deg"}), "tilts")


# --- raceway control ----------------------------------------------------------------------------

CONTROL_POINTS = [
    ("heavy and slow", ANGULAR, {"fx": "20 kN"}, 300.0),
    ("light and fast", ANGULAR, {"fx": "1 kN"}, 10000.0),
    ("combined", ANGULAR, {"fx": "20 kN", "fz": "10 kN"}, 6000.0),
    ("clearance", DEEP_GROOVE, {"fx": "2 kN", "fz": "3 kN"}, 2000.0),
    ("open outer groove", ANGULAR | {"outer_conformity": 0.56}, {"fx": "20 kN"}, 300.0),
]


def verdict(ball: Any) -> str:
    """Jones's criterion from the published record alone."""
    from scipy.special import ellipe

    def resistance(contact: Any) -> float:
        ratio = contact.semi_minor / contact.semi_major if contact.load else 1.0
        return float(contact.load * contact.semi_major * ellipe(1.0 - ratio**2))

    inner, outer = resistance(ball.inner), resistance(ball.outer)
    cosine = math.cos(ball.inner.contact_angle - ball.outer.contact_angle)
    if outer * cosine > inner:
        return "outer"
    return "inner" if inner * cosine > outer else "indeterminate"


@pytest.mark.parametrize(("name", "bearing", "load", "rpm"), CONTROL_POINTS)
def test_jones_is_true_to_its_own_criterion(
    name: str, bearing: dict[str, Any], load: dict[str, Any], rpm: float
) -> None:
    state = solved(bearing, load, model={"raceway_control": "jones"}, inner_speed=rpm * RPM)
    assert state.status.converged
    controls = {ball.raceway_control for ball in state.balls}
    assert controls <= {"outer", "inner", "indeterminate"}
    for ball in state.balls:
        if ball.raceway_control != "indeterminate":
            assert ball.raceway_control == verdict(ball)
    assert has_note(state, "favours neither race") == ("indeterminate" in controls)
    if name == "light and fast":
        assert controls == {"outer"}
    if name == "open outer groove":  # small ellipse, little resistance: the inner race controls
        assert controls == {"inner"}


def test_jones_equals_the_control_that_it_names() -> None:
    for control, bearing, load, rpm in (
        ("outer", ANGULAR, {"fx": "1 kN"}, 10000.0),
        ("inner", ANGULAR | {"outer_conformity": 0.56}, {"fx": "20 kN"}, 300.0),
    ):
        jones, named = (
            solved(bearing, load, model={"raceway_control": mode}, inner_speed=rpm * RPM)
            for mode in ("jones", control)
        )
        assert {ball.raceway_control for ball in jones.balls} == {control}
        assert jones.displacement.x == pytest.approx(named.displacement.x, rel=1e-9)
        assert not has_note(named, "contradicts")


def test_jones_contradicts() -> None:
    load, speed = {"fx": "5 kN"}, "10000 rpm"
    state = solved(ANGULAR, load, model={"raceway_control": "inner"}, inner_speed=speed)
    assert state.status.converged
    assert has_note(state, "contradicts inner raceway control", "16 balls")
    narrow = ANGULAR | {"outer_conformity": 0.56}
    state = solved(narrow, {"fx": "20 kN"}, inner_speed="300 rpm")
    assert state.status.converged
    assert has_note(state, "contradicts outer raceway control", "16 balls")
    shared = solved(
        narrow, {"fx": "20 kN"}, model={"raceway_control": "none"}, inner_speed="300 rpm"
    )
    assert not has_note(shared, "contradicts")
    assert {ball.raceway_control for ball in shared.balls} == {"none"}
    assert not has_note(solved(narrow, {"fx": "20 kN"}), "contradicts")  # at rest nobody controls


# --- one and many -------------------------------------------------------------------------------


def test_one_case_and_many_agree() -> None:
    duties: list[dict[str, float]] = [
        {"fx": 20e3, "fz": 15e3, "inner_speed": 1000.0},
        {"fx": 20e3, "fz": 5e3, "my": 100.0, "mz": -50.0, "inner_speed": 500.0},
        {"fx": 10e3, "outer_speed": 500.0},
        {"fx": 15e3, "fy": 3e3},
        {"fx": -1e3},
    ]
    bearing = Bearing(**ANGULAR)
    for duty in duties:
        loads = {name: value for name, value in duty.items() if name[0] in "fm"}
        speeds = {name: value for name, value in duty.items() if name.endswith("speed")}
        one = solve_one(Case(bearing=bearing, duty=Duty(load=Load(**loads), **speeds)))
        fields = {name: np.full(40, value) for name, value in duty.items()}
        many = solve(Case(bearing=bearing, duty=Duty()), **fields)
        assert set(many.status.code) == {one.status.code}
        if not one.status.converged:
            continue
        shift = np.abs(one.displacement).max()
        np.testing.assert_allclose(many.displacement.array[7], one.displacement, atol=1e-9 * shift)
        np.testing.assert_allclose(many.load.array[7], one.load, rtol=1e-9, atol=1e-6)
        for race in ("inner", "outer"):
            contacts = [getattr(ball, race) for ball in one.balls]
            for name in ("load", "contact_angle", "deflection"):
                values = np.array([getattr(contact, name) for contact in contacts])
                found = getattr(getattr(many, race), name)[7]
                touching = np.array([contact.load for contact in contacts]) > 1.0
                np.testing.assert_allclose(found[touching], values[touching], rtol=1e-7)
        np.testing.assert_allclose(
            many.stiffness.array[7],
            one.stiffness,
            atol=1e-7 * np.abs(one.stiffness).max(),
        )


def test_threads_change_nothing() -> None:
    rng, n = np.random.default_rng(9), 6000
    case = Case(bearing=Bearing(**ANGULAR), duty=Duty())
    fx = rng.uniform(50.0, 4e4, n)
    fields = {"fx": fx, "fz": fx * rng.uniform(0.0, 1.5, n), "inner_speed": rng.uniform(0, 1500, n)}
    one, two = (solve(case, threads=threads, **fields) for threads in (1, 2))
    for name in ("number", "residual", "iterations"):
        np.testing.assert_array_equal(getattr(one.status, name), getattr(two.status, name))
    for name in ("displacement", "load", "stiffness"):
        np.testing.assert_array_equal(getattr(one, name).array, getattr(two, name).array)
    np.testing.assert_array_equal(one.outer.load, two.outer.load)


def test_scalars_and_the_case_s_own_values_fill_up() -> None:
    case = Case(
        bearing=Bearing(**ANGULAR),
        duty=Duty(inner_speed=300.0, load=Load(fz="1 kN"), displacement=Displacement(ry=1e-4)),
    )
    batch = solve(case, fx=[1e4, 2e4], my=0.0)
    assert len(batch) == 2
    np.testing.assert_array_equal(batch.load.array[:, 2], 1e3)
    np.testing.assert_array_equal(batch.load.array[:, 3], 0.0)
    assert (batch.displacement.array[:, 3] != 1e-4).all()  # the moment has freed the tilt
    assert len(solve(case, fx=1e4)) == 1


@pytest.mark.parametrize(
    ("fields", "error", "words"),
    [
        ({"fxx": [1.0]}, UnknownKeyError, "fx"),
        ({"inner_sped": [1.0]}, UnknownKeyError, "inner_speed"),
        ({"weight": [1.0]}, UnknownKeyError, "not a field that can vary; nearest: .*--list fields"),
        ({"load": [1.0]}, UnknownKeyError, "did you mean duty.load.fz"),
        ({"fx": [1.0, 2.0], "fz": [1.0]}, InputError, "one length"),
        ({"fx": [[1.0, 2.0]]}, InputError, "one-dimensional"),
        ({"fx": [1.0], "x": [0.0]}, InputError, r"displacement\.x: cannot be combined .*load\.fx"),
        ({"my": 0.0, "ry": [0.0]}, InputError, r"displacement\.ry: cannot be combined .*load\.my"),
    ],
)
def test_input_errors_of_a_batch(
    fields: dict[str, Any], error: type[Exception], words: str
) -> None:
    case = Case(bearing=Bearing(**ANGULAR), duty=Duty())
    with pytest.raises(error, match=words):
        solve(case, **fields)


@pytest.mark.parametrize(("speed", "million"), [(300_000, "37.6"), (400_000, "50.1")])
def test_an_overspeed_is_named_as_one(case_218: Case, speed: float, million: str) -> None:
    state = solve_one(override(case_218, [f"duty.inner_speed={speed} rpm"]))
    assert not state.status.converged
    assert state.status.advice.key == "overspeed"
    advice = said(state.status.advice)
    assert advice.startswith(f"Overspeed: the rings rotate at n·d_m = {million} million mm·rpm")
    assert "please report" not in advice
    portuguese = said(state.status.advice, "pt")
    assert portuguese.startswith("Rotação excessiva")
    assert million.replace(".", ",") in portuguese


def test_what_fails_at_a_usual_speed_is_no_overspeed(case_218: Case) -> None:
    state = solve_one(override(case_218, ["duty.load.fx=20 MN"]))
    assert state.status.code == "overloaded"
    assert state.status.advice.key == "overloaded"
