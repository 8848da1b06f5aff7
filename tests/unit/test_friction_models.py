"""Models of friction torque on one bearing: what they say, and in which order they stand."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import rolamento as ro
from rolamento import Bearing, Case, Duty, Load
from rolamento.errors import InputError
from rolamento.friction.closed_forms import hysteresis_moment
from rolamento.friction.harris_1971 import harris_1971
from rolamento.friction.jones_control import jones_control
from rolamento.friction.jones_full import jones_full, jones_full_motion
from rolamento.friction.jones_simplified import jones_simplified
from rolamento.friction.minimum_power import loaded_contacts
from rolamento.friction.todd import todd
from rolamento.friction.traction import contact_friction, ellipse_mesh
from rolamento.solution import solve
from rolamento.solved import Solved

MU = 0.17
LOADS = (20.0, 50.0, 100.0, 200.0)


@pytest.fixture(scope="module")
def satellite() -> Case:
    """The bearing of Ricci and Fleury: three balls, no cage, 0.5 rpm."""
    bearing = Bearing(
        ball_count=3,
        ball_diameter="7.94 mm",
        pitch_diameter="42.5 mm",
        contact_angle="15.1 deg",
        inner_conformity=0.525,
        outer_conformity=0.525,
    )
    return Case(bearing=bearing, duty=Duty(inner_speed="0.5 rpm", load=Load(fx="50 N")))


@pytest.fixture(scope="module")
def thrust(satellite: Case) -> Solved:
    return solve(satellite, fx=np.array(LOADS))


def second_integral(balls: Solved) -> np.ndarray:
    """E of the contact that spins, roughly: the mean of both, for the balls of each case."""
    from scipy.special import ellipe

    values = [
        ellipe(1.0 - (patch.semi_minor / patch.semi_major) ** 2)[:, 0]
        for patch in (balls.inner, balls.outer)
    ]
    return np.mean(values, axis=0)


def test_order_of_the_models_on_ricci_and_fleurys_bearing(thrust: Solved) -> None:
    full, control = jones_full(thrust, MU).total, jones_control(thrust, MU).total
    bare = todd(thrust, MU, hysteresis=0.0).total
    simple, harris = jones_simplified(thrust, MU).total, harris_1971(thrust, MU).total
    assert np.all((full / harris > 1.015) & (full / harris < 1.035))
    np.testing.assert_allclose(full / harris, second_integral(thrust), rtol=6e-3)
    np.testing.assert_allclose(control / bare, 1.0, atol=3e-3)
    assert np.all((simple / control > 1.10) & (simple / control < 1.18))
    assert np.all((simple / full > 1.27) & (simple / full < 1.54))


def test_harris_equals_the_mesh_without_slip_across(thrust: Solved) -> None:
    """The closed forms against quadrature of the same model: one point along the ellipse."""
    mesh = ellipse_mesh(1500, 1)
    lines = jones_full(thrust, MU, mesh=mesh).total
    np.testing.assert_allclose(harris_1971(thrust, MU).total, lines, rtol=3e-5)


def test_both_contacts_spin_where_friction_decides(thrust: Solved) -> None:
    _, motion = jones_full_motion(thrust, MU)
    inner, outer, _ = loaded_contacts(thrust)
    assert motion is not None
    spin_in, spin_out = (motion.relative_motion(patch).spin for patch in (inner, outer))
    heavy = np.repeat(np.array(LOADS) >= 50.0, 3)
    assert np.all(np.abs(spin_in) > 0.02)
    assert np.all(np.abs(spin_out[heavy]) > 0.02)


def test_torque_on_both_rings_is_the_power(thrust: Solved) -> None:
    """T ω = ∫ f·v at the motion found, and the ball is in balance; by the rounded law."""
    _, motion = jones_full_motion(thrust, MU)
    assert motion is not None
    total = {}
    for patch in loaded_contacts(thrust)[:2]:
        total[patch.race] = contact_friction(
            patch,
            motion.relative_motion(patch),
            MU,
            rounding=motion.rounding,
            mesh=ellipse_mesh().folded,
        )
    inner, outer = total["inner"], total["outer"]
    np.testing.assert_allclose(inner.race_torque, -outer.race_torque, rtol=1e-6)
    # -race_torque is the friction that the shaft has to overcome, at 1 rad/s
    np.testing.assert_allclose(-inner.race_torque, inner.power + outer.power, rtol=1e-6)
    np.testing.assert_allclose(inner.force_rolling, -outer.force_rolling, rtol=0, atol=1e-6)


@pytest.mark.parametrize("model", [jones_full, jones_control, jones_simplified, harris_1971, todd])
def test_result_of_every_model(model: object, thrust: Solved) -> None:
    torque = model(thrust, [0.1, 0.2, 0.1, 0.2])  # type: ignore[operator]
    assert torque.converged.all()
    np.testing.assert_allclose(torque.total, sum(torque.parts.values()), rtol=1e-12)
    speed = 0.5 * np.pi / 30.0
    np.testing.assert_allclose(torque.power, torque.total * speed, rtol=1e-12)
    heat = sum(loss.total for loss in torque.losses.values())
    np.testing.assert_allclose(heat, torque.power, rtol=1e-12)
    assert np.all(torque.total > 0.0)


@pytest.mark.parametrize("name", ["todd", "jones_control", "jones_simplified"])
def test_control_can_be_chosen(name: str, thrust: Solved) -> None:
    model = {"todd": todd, "jones_control": jones_control, "jones_simplified": jones_simplified}[
        name
    ]
    by_jones = model(thrust, MU).total
    inner, outer = (
        model(thrust, MU, control="inner").total,
        model(thrust, MU, control="outer").total,
    )
    np.testing.assert_allclose(by_jones, inner)  # the inner ellipse is longer
    assert np.all(outer != inner)
    np.testing.assert_allclose(model(thrust, MU, control="state").total, outer)
    with pytest.raises(InputError, match="must be one of"):
        model(thrust, MU, control="both")  # type: ignore[arg-type]


def test_hysteresis_is_a_source_of_its_own(thrust: Solved) -> None:
    with_it, without = todd(thrust, MU, hysteresis=0.02), todd(thrust, MU, hysteresis=0.0)
    np.testing.assert_allclose(
        with_it.total - without.total, with_it.parts["hysteresis"], rtol=1e-9
    )
    moment = hysteresis_moment(thrust.inner, 0.02) + hysteresis_moment(thrust.outer, 0.02)
    # rolling is d_m/D (1 - γ²)/2 and a little; T = Σ M ω_roll/ω, about 2.7 here
    ratio = with_it.parts["hysteresis"] / moment.sum(axis=1)
    assert np.all((ratio > 2.3) & (ratio < 3.1))


def test_speed_does_not_matter_to_coulomb(satellite: Case) -> None:
    slow = solve(satellite, inner_speed=[0.0, 1e-3, -1e-3, 0.05])
    for model in (jones_full, jones_control, harris_1971, todd, jones_simplified):
        torque = model(slow, MU)  # type: ignore[operator]
        np.testing.assert_allclose(torque.total, torque.total[0], rtol=1e-6)
        assert torque.power[0] == 0.0
        assert np.all(torque.power[1:] > 0.0)


def test_balls_without_load_take_no_part(examples: Path) -> None:
    state = solve(ro.load_case(examples / "209_radial.toml"))
    balls = state
    assert 0 < balls.loaded.sum() < balls.loaded.size
    for model in (jones_full, jones_control, harris_1971, todd, jones_simplified):
        torque = model(balls, 0.1)  # type: ignore[operator]
        assert torque.converged.all()
        assert torque.total[0] > 0.0
        for loss in torque.losses.values():
            assert np.all(loss.inner[~balls.loaded] == 0.0)
            assert np.all(loss.outer[~balls.loaded] == 0.0)


def test_case_without_result_is_nan_and_alone(satellite: Case) -> None:
    batch = solve(satellite, fx=[50.0, -50.0, np.nan, 100.0])
    assert list(batch.converged) == [True, False, False, True]
    balls = batch
    for model in (jones_full, jones_control, harris_1971, todd, jones_simplified):
        total = model(balls, MU).total  # type: ignore[operator]
        assert list(np.isfinite(total)) == [True, False, False, True]


def test_ellipse_wider_than_the_ball_has_no_torque() -> None:
    bearing = Bearing(
        ball_count=8,
        ball_diameter="10 mm",
        pitch_diameter="50 mm",
        contact_angle="20 deg",
        inner_conformity=0.501,
        outer_conformity=0.501,
    )
    case = Case(bearing=bearing, duty=Duty(load=Load(fx="1 kN")))
    batch = solve(case, fx=[1e-3, 1e3, 1e5])
    assert batch.converged.all()
    balls = batch
    for model in (jones_full, jones_control, harris_1971, todd, jones_simplified):
        total = model(balls, MU).total  # type: ignore[operator]
        assert list(np.isfinite(total)) == [True, True, False]


def test_batch_is_the_states_one_by_one(case_218: Case) -> None:
    speeds = [100.0, 900.0]
    balls = solve(case_218, inner_speed=speeds)
    for model in (jones_full, harris_1971, todd):
        batch = model(balls, 0.08)  # type: ignore[operator]
        for k, speed in enumerate(speeds):
            case = ro.override(case_218, [f"duty.inner_speed={speed} rad/s"])
            one = model(solve(case), 0.08)  # type: ignore[operator]
            assert batch.total[k] == pytest.approx(one.total[0], rel=1e-7)


def test_a_set_is_the_sum_of_its_rows(case_218: Case) -> None:
    single = case_218.bearing
    alone = Case(bearing=single, duty=Duty(inner_speed="100 rpm", load=Load(fx="10 kN")))
    pair = alone.replace(
        bearing=single.replace(arrangement="DT", spacing="30 mm"),
        duty=alone.duty.replace(load=Load(fx="20 kN")),
    )
    one = jones_full(solve(alone), MU).total[0]
    two = jones_full(solve(pair), MU).total[0]
    assert two == pytest.approx(2.0 * one, rel=1e-6)


@pytest.mark.parametrize("bad", [-0.1, 1.5, np.nan, [[0.1]], "a lot"])
def test_wrong_coefficients_are_refused(bad: object, thrust: Solved) -> None:
    with pytest.raises((InputError, ValueError)):
        jones_full(thrust, bad)  # type: ignore[arg-type]


def test_torque_converges_with_the_mesh(thrust: Solved) -> None:
    fine = jones_full(thrust, MU, mesh=ellipse_mesh(400, 15)).total
    worst = []
    for mesh in ((20, 3), (40, 5), (80, 5), (160, 9)):
        worst.append(
            np.max(np.abs(jones_full(thrust, MU, mesh=ellipse_mesh(*mesh)).total / fine - 1))
        )
    assert worst[0] < 2e-2
    assert worst[2] < 1e-3  # the default
    assert worst[3] < 2e-4


def test_a_ball_that_hardly_anything_holds_is_no_wrong_input() -> None:
    """The idle row of a self-aligning bearing under load to one side: Newton runs off there."""
    bearing = Bearing(
        kind="self_aligning",
        ball_count=12,
        ball_diameter="7.9 mm",
        pitch_diameter="39 mm",
        spacing="9 mm",
        diametral_clearance="0.015 mm",
        inner_conformity=0.52,
    )
    load = Load(fx="500 N", fz="1 kN")
    solved = solve(Case(bearing=bearing, duty=Duty(inner_speed="1500 rpm", load=load)))
    harris, full = harris_1971(solved, MU), jones_full(solved, MU)
    assert full.converged.all()
    assert np.isfinite(harris.total[0]) == harris.converged[0]
