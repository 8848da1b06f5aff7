"""A turn of the cage: its record, its clock, its frequencies, one ball's history, failures."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from rolamento import Case, Duty, InputError, Load, load_case
from rolamento.case.arrangement import BallRow
from rolamento.plots.cage_turn import cage_turn_figure
from rolamento.solution import solve
from rolamento.studies.cage_turn import CageTurn, cage_turn
from rolamento.words import speaking

RPM = np.pi / 30.0


@pytest.fixture(scope="module", autouse=True)
def _compiled(case_218: Case) -> None:
    """Load the compiled kernels first: few cases alone would run as plain Python, slowly."""
    solve(case_218, fx=np.full(100, 1e4))


@pytest.fixture(scope="module")
def turn(case_218: Case) -> CageTurn:
    return cage_turn(case_218, points=32)


def with_speeds(case: Case, inner: float, outer: float, **load: float) -> Case:
    given = Load(**load) if load else case.duty.load
    duty = Duty(inner_speed=inner * RPM, outer_speed=outer * RPM, load=given)
    return case.replace(duty=duty)


def test_the_points_lie_evenly_over_one_pitch_without_its_end(turn: CageTurn) -> None:
    assert turn.period == pytest.approx(2 * np.pi / 16)
    np.testing.assert_allclose(turn.angle, turn.period * np.arange(32) / 32)
    assert turn.solved.displacement.array.shape == turn.solved.load.array.shape == (32, 5)
    assert turn.solved.stiffness.array.shape == (32, 5, 5)
    assert turn.solved.inner.load.shape == turn.solved.outer.load.shape == (32, 16)
    assert len(turn) == 32
    assert turn.converged
    assert turn.advice is None


def test_every_instant_is_what_solve_finds(case_218: Case, turn: CageTurn) -> None:
    duty = case_218.duty.replace(first_ball_azimuth=float(turn.angle[5]))
    state = solve(case_218.replace(duty=duty))
    found = turn.solved[5]
    np.testing.assert_allclose(found.displacement.array, state.displacement.array, atol=1e-13)
    np.testing.assert_allclose(found.load.array, state.load.array, atol=1e-6)
    np.testing.assert_allclose(found.stiffness.array, state.stiffness.array, rtol=1e-7, atol=1.0)
    np.testing.assert_allclose(found.inner.load, state.inner.load)


def test_the_history_of_one_ball_holds_what_each_ball_meets(case_218: Case, turn: CageTurn) -> None:
    duty = case_218.duty.replace(first_ball_azimuth=float(turn.angle[5]))
    (history,) = turn.histories
    state = solve(case_218.replace(duty=duty))
    for ball, azimuth in enumerate(state.elements.azimuth[0]):
        step = int(np.argmin(np.abs(history.azimuth - azimuth)))
        assert history.azimuth[step] == pytest.approx(azimuth, abs=1e-9)
        for race in ("inner", "outer"):
            for name in ("load", "contact_angle", "max_pressure"):
                found = getattr(getattr(history, race), name)[step]
                expected = getattr(getattr(state, race), name)[0, ball]
                assert found == pytest.approx(expected)


def test_the_heaviest_load_is_met_on_the_load_line(turn: CageTurn) -> None:
    (history,) = turn.histories
    for contact in (history.inner, history.outer):
        assert contact.load[contact.heaviest] == contact.load.max()
        assert history.azimuth[contact.heaviest] == 0.0


# --- the cage and the clock -------------------------------------------------------------------


def test_at_low_speed_the_passage_frequency_is_the_textbook_one(case_218: Case) -> None:
    """Z/2 (n_i (1 - γ) + n_o (1 + γ)) with γ of the loaded contact angle: Harris (1991)."""
    for inner, outer in ((30.0, 0.0), (0.0, 30.0), (30.0, -10.0), (-30.0, 0.0)):
        turned = cage_turn(with_speeds(case_218, inner, outer, fx=10e3), points=4)
        angle = turned.histories[0].inner.contact_angle[0]
        gamma = 22.23 / 125.26 * np.cos(angle)
        expected = 8.0 * abs(inner / 60.0 * (1.0 - gamma) + outer / 60.0 * (1.0 + gamma))
        assert turned.passage_frequency == pytest.approx(expected, rel=1e-5)
        np.testing.assert_allclose(turned.frequencies, turned.passage_frequency * np.arange(1, 2))
        assert np.sign(turned.cage_speed.mean) == np.sign(inner + outer)


@pytest.mark.parametrize("rpm", [6000.0, -6000.0])
def test_the_clock_runs_with_the_balls(case_218: Case, rpm: float) -> None:
    """Between two instants the first ball moves as a body that turns about +x does."""
    turned = cage_turn(with_speeds(case_218, rpm, 0.0), points=16)
    order = np.argsort(turned.time)
    assert turned.time[0] == 0.0
    np.testing.assert_allclose(np.diff(turned.time[order]), turned.time[order][1])
    assert turned.time.max() < 1.0 / turned.passage_frequency
    first, second = np.unwrap(turned.angle[order][1:3])
    step = turned.time[order][2] - turned.time[order][1]
    place = np.array([0.0, np.sin(first), np.cos(first)])
    spin = np.array([turned.cage_speed.mean, 0.0, 0.0])
    moved = np.array([0.0, np.sin(second), np.cos(second)]) - place
    assert np.dot(moved / step, np.cross(spin, place)) > 0.99 * turned.cage_speed.mean**2


def test_the_cage_speed_is_the_mean_of_the_loaded_balls(turn: CageTurn, case_218: Case) -> None:
    speed = turn.cage_speed
    assert speed.minimum < speed.mean < speed.maximum
    orbits = solve(case_218).elements.orbital_speed[0]
    assert speed.mean == pytest.approx(np.mean(orbits), rel=1e-3)
    # the range is that of all instants: wider than at one of them, by little
    at_once = (max(orbits) - min(orbits)) / np.mean(orbits)
    assert at_once <= speed.spread < 1.02 * at_once


def test_balls_without_load_have_no_say_in_the_cage_speed(examples: Path) -> None:
    """With clearance the inner ring leaves balls behind, whose orbits mean nothing."""
    turned = cage_turn(load_case(examples / "209_radial.toml", ["duty.inner_speed=500 rpm"]))
    assert turned.solved.inner.load.min() == 0.0 < turned.solved.outer.load.min()
    rolling = 0.5 * 500 * RPM * (1.0 - 12.7 / 65.0)
    assert turned.cage_speed.mean == pytest.approx(rolling, rel=1e-3)
    assert turned.cage_speed.spread < 0.01


def test_at_standstill_there_is_no_time_and_no_frequency(examples: Path) -> None:
    turned = cage_turn(load_case(examples / "209_radial.toml"), points=8)
    assert turned.converged
    assert np.isnan(turned.passage_frequency)
    assert np.isnan(turned.time).all()
    assert np.isnan(turned.frequencies).all()
    assert turned.cage_speed.mean == 0.0


def test_orders_count_by_the_revolution_of_the_cage(turn: CageTurn) -> None:
    np.testing.assert_array_equal(turn.orders, 16 * np.arange(1, 16))
    np.testing.assert_allclose(
        turn.frequencies, turn.orders * turn.cage_speed.mean / (2 * np.pi), rtol=1e-12
    )


def test_the_first_harmonic_is_the_amplitude_of_the_wave(case_218: Case) -> None:
    """Nearly a sine, where no ball passes from the cage to its own orbit: half of peak to peak."""
    alone = case_218.replace(model=case_218.model.replace(cage="none"))
    variation = cage_turn(alone, points=32).variation("displacement")
    amplitude = np.abs(variation.harmonics[0, :3])
    np.testing.assert_allclose(2.0 * amplitude, variation.peak_to_peak[:3], rtol=1e-2)


# --- sets of rows -----------------------------------------------------------------------------


def two_rows(case: Case, **second: Any) -> Case:
    rows = (
        BallRow(orientation="+", position="-15 mm"),
        BallRow(orientation="-", position="15 mm", **second),
    )
    return case.replace(bearing=case.bearing.replace(rows=rows, preload="500 N"))


def test_a_set_has_a_history_for_each_row(case_218: Case) -> None:
    turned = cage_turn(two_rows(case_218), points=8)
    assert turned.converged
    assert turned.period == pytest.approx(2 * np.pi / 16)
    assert [history.row for history in turned.histories] == [0, 1]
    for history in turned.histories:
        of_row = turned.solved.inner.load[:, turned.solved.elements.row == history.row]
        np.testing.assert_array_equal(np.sort(history.inner.load), np.sort(of_row.ravel()))
    first, second = (history.inner.load.max() for history in turned.histories)
    assert first > 2.0 * second  # the axial load takes the second row's preload away


def test_rows_of_different_ball_counts_repeat_by_their_common_divisor(case_218: Case) -> None:
    unlike = two_rows(case_218, ball_count=12, phase="5 deg")
    turned = cage_turn(unlike, points=24)
    assert turned.converged
    assert turned.period == pytest.approx(2 * np.pi / 4)
    np.testing.assert_array_equal(turned.orders[:4], [4, 8, 12, 16])
    onward = solve(unlike, first_ball_azimuth=turned.angle + turned.period)
    np.testing.assert_allclose(
        onward.displacement.array, turned.solved.displacement.array, atol=1e-14
    )
    np.testing.assert_array_equal(onward.elements.row, turned.solved.elements.row)
    for history in turned.histories:  # one ball, once round, in even steps
        assert len(history.azimuth) == 96
        np.testing.assert_allclose(np.diff(history.azimuth), 2 * np.pi / 96, atol=1e-12)
    # the second row's first ball stands five degrees on: its load at a step is that ball's
    second = turned.histories[1]
    azimuth = float(np.radians(5.0) + turned.angle[7])
    step = int(np.argmin(np.abs(second.azimuth - azimuth)))
    assert second.azimuth[step] == pytest.approx(azimuth, abs=1e-9)
    assert second.inner.load[step] == turned.solved.inner.load[7, 16]


# --- without a result -------------------------------------------------------------------------


def test_a_turn_without_a_result_says_why_and_invents_nothing(case_218: Case) -> None:
    turned = cage_turn(case_218.replace(duty=Duty(load=Load(fx="-1 N"))), points=8)
    assert not turned.converged
    assert set(turned.status) == {"no_equilibrium"}
    assert turned.advice is not None
    assert "axial" in turned.advice.text
    for quantity in ("displacement", "load", "stiffness"):
        variation = turned.variation(quantity)
        assert np.isnan(variation.mean).all()
        assert np.isnan(variation.peak_to_peak).all()
        assert np.isnan(variation.harmonics).all()
    assert np.isnan(turned.cage_speed.mean)
    assert np.isnan(turned.passage_frequency)
    assert turned.histories[0].inner.heaviest == -1


@pytest.mark.parametrize("points", [0, 3, 4097, -1])
def test_the_number_of_points_has_bounds(case_218: Case, points: int) -> None:
    with pytest.raises(InputError, match="must be an integer from 4 to 4"):
        cage_turn(case_218, points=points)


# --- the figure -------------------------------------------------------------------------------


def panel(figure: Any, title: str) -> Any:
    (found,) = [
        axes for axes in figure.axes if title in (axes.get_title(), axes.get_title(loc="left"))
    ]
    return found


def test_the_figure_shows_the_variation_about_the_mean(turn: CageTurn) -> None:
    figure = cage_turn_figure(turn)
    lines = panel(figure, "Displacement of the inner ring").get_lines()
    assert [line.get_label() for line in lines] == ["x", "y", "z"]
    drawn = lines[0].get_ydata()
    assert len(drawn) == 33
    assert np.ptp(drawn) == pytest.approx(1e9 * np.ptp(turn.solved.displacement.array[:, 0]))  # nm
    assert np.mean(drawn[:-1]) == pytest.approx(0.0, abs=1e-9)
    polar = panel(figure, "Load of one ball over a turn (kN)")
    largest = np.max(polar.get_lines()[0].get_ydata())
    assert largest == pytest.approx(1e-3 * turn.solved.inner.load.max())


def test_the_figure_of_what_does_not_vary_says_so(case_218: Case) -> None:
    still = cage_turn(with_speeds(case_218, 1e4, 0.0, fx=2e4), points=8)
    with speaking("pt"):
        figure = cage_turn_figure(still)
    texts = [text.get_text() for axes in figure.axes for text in axes.texts]
    assert texts.count("sem variação") == 3


def test_the_figure_without_a_result_is_empty_and_says_so(case_218: Case) -> None:
    failed = cage_turn(case_218.replace(duty=Duty(load=Load(fx="-1 N"))), points=8)
    figure = cage_turn_figure(failed)
    texts = [text.get_text() for axes in figure.axes for text in axes.texts]
    assert texts.count("no point has a result") == 3
