"""Bearings that oscillate: limits, continuity, symmetry, histograms, and hostile inputs."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

from rolamento import Case, InputError, Solved, load_case, solve
from rolamento.cli.app import app
from rolamento.life import life
from rolamento.life.oscillation import (
    critical_angle,
    lives_over_angles,
    oscillation_life,
    oscillations_per_revolution,
    window_factor,
)
from rolamento.studies import Study, run
from rolamento.tasks.oscillation import life_in_oscillation, life_under_oscillations

ROLLS = {
    "balls": ("6310", {"duty.load.fz": "5 kN"}),
    "rollers": ("NU 210", {"duty.load.fz": "8 kN"}),
    "two rows": ("22210", {"duty.load.fz": "8 kN"}),
    "thrust": ("51210", {"duty.load.fx": "5 kN"}),
}


@pytest.fixture(scope="module", params=ROLLS)
def solved(request: pytest.FixtureRequest) -> Solved:
    name, values = ROLLS[request.param]
    return solve(load_case(name, values))


# --- the law --------------------------------------------------------------------------------------


def test_a_full_swing_is_two_half_turns(solved: Solved) -> None:
    """At φ = 360° there and back are two turns, and every point passes the whole load."""
    reference = life(solved).reference.life[0]
    found = oscillation_life(solved, 2.0 * np.pi)
    np.testing.assert_allclose(found.window, 1.0, rtol=1e-9)
    assert found.life == pytest.approx(0.5 * reference, rel=1e-9)
    assert found.harris == pytest.approx(0.5 * reference, rel=1e-12)


def test_any_whole_number_of_turns_is_rotation(solved: Solved) -> None:
    reference = life(solved).reference.life[0]
    for turns in (2, 5):
        found = oscillation_life(solved, turns * 2.0 * np.pi)
        assert found.life == pytest.approx(0.5 * reference / turns, rel=1e-9)


def test_lives_are_continuous_and_fall_with_the_angle(solved: Solved) -> None:
    found = oscillation_life(solved, 1.5)
    for critical in (*found.critical_inner, *found.critical_outer):
        before, after = lives_over_angles(solved, critical * np.array([1.0 - 1e-9, 1.0 + 1e-9]))[0]
        assert before == pytest.approx(after, rel=1e-7, nan_ok=True)
    angles = np.linspace(0.51 * found.critical, 2.0 * np.pi, 40)
    assert np.all(np.diff(lives_over_angles(solved, angles)[0]) < 0.0)


def test_below_half_the_critical_angle_there_is_no_life(solved: Solved) -> None:
    critical = oscillation_life(solved, 1.5).critical
    above, below = (oscillation_life(solved, share * critical) for share in (0.501, 0.499))
    assert np.isfinite(above.life)
    assert not above.fretting
    assert np.isnan(below.life)
    assert below.fretting
    assert "oscillation_frets" in [note.key for note in below.notes]
    assert "oscillation_under_critical" in [note.key for note in above.notes]


def test_the_window_between_its_limits() -> None:
    """1 for a turn, (J_2/J_1)^p of the points for no way at all, and falling between."""
    azimuth = np.linspace(0.0, 2.0 * np.pi, 720, endpoint=False)
    load = np.maximum(1.0 - 2.0 * (1.0 - np.cos(azimuth)) / 2.0, 0.0) ** 1.5
    for p, e in ((3.0, 10.0 / 9.0), (4.0, 9.0 / 8.0)):
        j_1 = (load**p).mean() ** (1.0 / p)
        j_2 = (load ** (p * e)).mean() ** (1.0 / (p * e))
        still = window_factor(load, 1e-6, exponent=p, slope=e)
        assert float(still) == pytest.approx((j_2 / j_1) ** p, rel=1e-9)
        turn = window_factor(load, 2.0 * np.pi, exponent=p, slope=e)
        assert float(turn) == pytest.approx(1.0, rel=1e-12)
        over = [
            float(window_factor(load, a, exponent=p, slope=e)) for a in np.linspace(0.1, 6.2, 30)
        ]
        assert np.all(np.diff(over) < 0.0)


def test_the_window_by_brute_force() -> None:
    """Against a sum over a fine grid, for a window that ends between points."""
    rng = np.random.default_rng(3)
    load, angle = rng.uniform(0.0, 1.0, 24), 1.234
    fine = np.linspace(0.0, 2.0 * np.pi, 24 * 400, endpoint=False)
    at = np.interp(fine, np.arange(25) * 2.0 * np.pi / 24, np.append(load**3, load[0] ** 3))
    risk = []
    for middle in np.arange(24) * 2.0 * np.pi / 24:
        away = np.abs(np.mod(fine - middle + np.pi, 2.0 * np.pi) - np.pi)
        risk.append(at[away <= 0.5 * angle].mean() ** (10.0 / 9.0))
    by_hand = np.mean(risk) ** 0.9 / (load**3).mean()
    assert float(window_factor(load, angle)) == pytest.approx(by_hand, rel=2e-3)


def test_an_even_load_has_no_average_to_lose() -> None:
    assert float(window_factor(np.full(16, 7.0), 0.3)) == pytest.approx(1.0)
    assert np.isnan(window_factor(np.zeros(16), 0.3))


def test_slices_add_their_risks() -> None:
    """Slices that are alike are as one."""
    load = np.random.default_rng(5).uniform(0.0, 1.0, 32)
    one = window_factor(load, 1.0, exponent=4.0, slope=9.0 / 8.0)
    many = window_factor(np.repeat(load[:, None], 7, axis=1), 1.0, exponent=4.0, slope=9.0 / 8.0)
    assert float(one) == pytest.approx(float(many))


def test_an_axial_load_is_shared_evenly() -> None:
    solved = solve(load_case("7210 B", {"duty.load.fx": "5 kN"}))
    found = oscillation_life(solved, 2.0)
    np.testing.assert_allclose(found.window, 1.0, rtol=1e-9)
    assert found.life == pytest.approx(found.harris, rel=1e-9)


def test_a_turned_load_changes_nothing() -> None:
    """The same force along y and along z: the races do not know the difference."""
    lives = []
    for axis in ("fy", "fz"):
        case = load_case("6310", {f"duty.load.{axis}": "5 kN", "duty.first_ball_azimuth": "0 deg"})
        lives.append(oscillation_life(solve(case), 1.6).life)
    assert lives[0] == pytest.approx(lives[1], rel=1e-6)


def test_a_rotating_load_moves_against_the_outer_ring() -> None:
    fixed = load_case("6310", {"duty.load.fz": "5 kN"})
    turning = fixed.with_({"life.rotating_load": True})
    assert oscillation_life(solve(fixed), 1.5).moving == "inner"
    assert oscillation_life(solve(turning), 1.5).moving == "outer"


def test_hours_and_reliability() -> None:
    case = load_case("6310", {"duty.load.fz": "5 kN", "life.reliability": 0.99})
    solved = solve(case)
    found = oscillation_life(solved, 1.5, 2.0)
    assert found.hours == pytest.approx(found.life * 1e6 / 2.0 / 3600.0)
    ninety = oscillation_life(solve(case.with_({"life.reliability": 0.9})), 1.5)
    assert found.life == pytest.approx(found.reliability_factor * ninety.life)
    assert np.isnan(ninety.hours)


def test_angles_and_counts_that_are_none() -> None:
    for wrong in (0.0, -1.0):
        with pytest.raises(InputError):
            oscillations_per_revolution(wrong, 1.0)
    with pytest.raises(InputError):
        critical_angle(0, 0.1, race="inner")
    with pytest.raises(InputError, match="how far"):
        oscillation_life(solve("6310", fz=5e3))
    with pytest.raises(InputError, match="one case"):
        oscillation_life(solve("6310", fz=[4e3, 5e3]), 1.0)


def test_no_load_no_fatigue() -> None:
    found = oscillation_life(solve(load_case("6310")), 1.5)
    assert np.isnan(found.life)
    assert "oscillation_unloaded" in [note.key for note in found.notes]


# --- duty and histogram ---------------------------------------------------------------------------


def swinging(**changes: Any) -> Case:
    duty = {"load": {"fz": "5 kN"}, "oscillation": {"angle": "90 deg", "frequency": "2 Hz"}}
    return Case(bearing="6310", duty={**duty, **changes})


def test_a_ring_turns_or_swings() -> None:
    with pytest.raises(InputError, match="it swings"):
        swinging(inner_speed="100 rpm")
    turning = load_case("6310", {"duty.inner_speed": "100 rpm", "duty.load.fz": "5 kN"})
    changed = turning.with_({"duty.oscillation.angle": "30 deg"})
    assert changed.duty.inner_speed == 0.0
    assert changed.duty.oscillation is not None
    assert changed.duty.oscillation.frequency is None


def test_a_life_of_rotation_says_that_the_duty_oscillates() -> None:
    summary = life(solve(swinging()))
    assert "duty_oscillates" in [note.key for note in summary.qualifications()]
    still = life(solve(swinging(oscillation=None)))
    assert "duty_oscillates" not in [note.key for note in still.qualifications()]


def test_one_step_is_the_case_itself(tmp_path: Path) -> None:
    path = tmp_path / "steps.csv"
    path.write_text("share,duty.oscillation.angle\n0.5,90 deg\n0.5,90 deg\n")
    found = life_under_oscillations(swinging(), path)
    alone = life_in_oscillation(swinging()).life
    assert alone is not None
    assert found.life == pytest.approx(alone.life)
    assert found.hours == pytest.approx(alone.hours)
    np.testing.assert_allclose(found.damage, [0.5, 0.5])


def test_a_histogram_between_its_steps(tmp_path: Path) -> None:
    path = tmp_path / "steps.csv"
    path.write_text(
        "revolutions,duty.oscillation.angle,duty.load.fz\n0.9,90 deg,4 kN\n0.1,180 deg,6 kN\n"
    )
    found = life_under_oscillations(swinging(), path)
    lives = [one.life for one in found.lives]
    assert min(lives) < found.life < max(lives)
    assert found.damage.sum() == pytest.approx(1.0)
    # one and the same race limits both steps: Miner of the whole is nearly that of the races
    assert found.life == pytest.approx(1.0 / (0.9 / lives[0] + 0.1 / lives[1]), rel=0.02)
    assert json.loads(found.to_json())["steps"][1]["angle"] == pytest.approx(np.pi)


def test_a_step_that_frets_has_no_life(tmp_path: Path) -> None:
    path = tmp_path / "steps.csv"
    path.write_text("share,duty.oscillation.angle\n0.9,90 deg\n0.1,5 deg\n")
    found = life_under_oscillations(swinging(), path)
    assert not found.converged
    assert "oscillation_frets" in [note.key for note in found.notes]
    assert json.loads(found.to_json())["life"] is None


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("share,duty.oscillation.angle\n1,-3 deg\n", "greater than 0 deg"),
        ("share,duty.oscillation.angle\n1,3 mm\n", "angle"),
        ("share,duty.load.fz\n1,5 kN\n", "how far"),
    ],
)
def test_steps_that_are_none(tmp_path: Path, text: str, message: str) -> None:
    path = tmp_path / "steps.csv"
    path.write_text(text)
    base = swinging(oscillation=None) if "oscillation" not in text else swinging()
    with pytest.raises(InputError, match=message):
        life_under_oscillations(base, path)


def test_the_command() -> None:
    run = CliRunner().invoke
    good = run(
        app, ["oscillation", "6310", "--fr", "5 kN", "--angle", "90deg", "--frequency", "2Hz"]
    )
    assert good.exit_code == 0
    assert "million oscillations" in " ".join(good.output.split())
    frets = run(app, ["oscillation", "6310", "--fr", "5 kN", "--angle", "10deg"])
    assert frets.exit_code == 1
    assert "frets" in frets.output
    assert run(app, ["oscillation", "6310", "--fr", "5 kN"]).exit_code == 2


@pytest.mark.parametrize("name", ["6310", "NU 210"])
def test_what_varied_loads_the_case_too(name: str) -> None:
    """A duty given to `solve` has the life of the same duty in the case itself."""
    own = oscillation_life(solve(load_case(name, {"duty.load.fz": "5 kN"})), 2.0, 2.0)
    varied = oscillation_life(solve(name, fz=5e3), 2.0, 2.0)
    assert own.window[0] > 1.05
    assert varied.window[0] == pytest.approx(own.window[0], rel=1e-9)
    assert varied.life == pytest.approx(own.life, rel=1e-9)


def test_a_study_has_the_life_of_each_case() -> None:
    swing = {"angle": "90 deg", "frequency": "2 Hz"}
    case = Case(bearing="6310", duty={"load": {"fz": "5 kN"}, "oscillation": swing})
    loads, names = [4e3, 8e3], ("oscillation_hours", "oscillation_critical")
    axes = [{"field": "duty.load.fz", "values": loads}]
    found = run(Study(case=case, axes=axes, outputs=names))
    for place, load in enumerate(loads):
        own = oscillation_life(solve(case.with_({"duty.load.fz": load})))
        assert float(found["oscillation_hours"][place]) == pytest.approx(own.hours, rel=1e-9)
        assert float(found["oscillation_critical"][place]) == pytest.approx(own.critical)
    turning = Case(bearing="6310", duty={"load": {"fz": "5 kN"}})
    with pytest.raises(InputError, match="needs an oscillation"):
        Study(case=turning, axes=axes, outputs=names)
