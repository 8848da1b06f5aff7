"""Laws of fault frequencies: sums, signs, limits, exchanged rings, intervals, general attitudes."""

from __future__ import annotations

from math import cos, pi

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from rolamento import Bearing
from rolamento.kinematics import ball_motion
from rolamento.vibration.frequencies import (
    FAULTS,
    LINES,
    line_orders,
    nominal_frequencies,
    turns_of,
)
from rolamento.vibration.frequency_band import Tolerances, banded_frequencies
from rolamento.vibration.motion import general_motion

RATIOS = st.floats(0.02, 0.4)
ANGLES = st.floats(0.0, 1.4)
SPEEDS = st.floats(-2000.0, 2000.0).map(lambda speed: round(speed, 3))
SLIPS = st.floats(0.0, 1.0)
COUNTS = st.integers(3, 30)


def _bearing(count: int, ratio: float, angle: float) -> Bearing:
    most = 0.99 * np.sin(pi / count)
    return Bearing(
        ball_count=count,
        ball_diameter=0.05 * min(ratio, most),
        pitch_diameter=0.05,
        contact_angle=angle,
        inner_conformity=0.52,
        outer_conformity=0.52,
    )


@given(COUNTS, RATIOS, ANGLES, SPEEDS, SPEEDS, SLIPS)
def test_passages_add_up_to_all_balls_times_the_relative_speed(
    count: int, ratio: float, angle: float, inner: float, outer: float, slip: float
) -> None:
    orders = line_orders(turns_of(ratio, angle, inner, outer, slip), count)
    total = orders["ball_pass_outer"] + orders["ball_pass_inner"]
    assert total == pytest.approx(count * (inner - outer), rel=1e-12, abs=1e-9)
    # both have the sign of the relative speed, so their sizes add up as well
    assert orders["ball_pass_outer"] * orders["ball_pass_inner"] >= 0.0


@given(RATIOS, ANGLES, SPEEDS, SPEEDS, SLIPS, st.floats(-3.0, 3.0))
def test_speeds_scale_everything(
    ratio: float, angle: float, inner: float, outer: float, slip: float, factor: float
) -> None:
    found = turns_of(ratio, angle, inner, outer, slip)
    scaled = turns_of(ratio, angle, factor * inner, factor * outer, slip)
    assert scaled.cage == pytest.approx(factor * found.cage, abs=1e-6)
    assert scaled.ball == pytest.approx(factor * found.ball, abs=1e-6)


@given(RATIOS, ANGLES, SPEEDS, SPEEDS, SLIPS, SPEEDS)
def test_turning_the_whole_machine_turns_the_cage_along(
    ratio: float, angle: float, inner: float, outer: float, slip: float, more: float
) -> None:
    found = turns_of(ratio, angle, inner, outer, slip)
    turned = turns_of(ratio, angle, inner + more, outer + more, slip)
    assert turned.cage - more == pytest.approx(found.cage, abs=1e-6)
    assert turned.ball == pytest.approx(found.ball, abs=1e-6)


@given(RATIOS, ANGLES, SPEEDS, SPEEDS)
def test_exchanged_rings(ratio: float, angle: float, inner: float, outer: float) -> None:
    """With γ → -γ the outer groove is the inner one: the cage moves alike, the ball backwards."""
    found = turns_of(ratio, angle, inner, outer)
    mirrored = turns_of(-ratio, angle, outer, inner)
    assert mirrored.cage == pytest.approx(found.cage, abs=1e-6)
    assert mirrored.ball == pytest.approx(found.ball, abs=1e-6)


@given(RATIOS, ANGLES, SPEEDS, SPEEDS)
def test_as_the_kinematics_of_equal_angles(
    ratio: float, angle: float, inner: float, outer: float
) -> None:
    found = turns_of(ratio, angle, inner, outer)
    motion = ball_motion(angle, angle, ratio, inner, outer)
    assert found.cage == pytest.approx(float(motion.orbital_speed), abs=1e-7)
    # the ball of raceway control leans away from the tangent: its speed along it is the usual one
    along = float(motion.ball_speed * np.cos(motion.attitude - angle))
    assert found.ball == pytest.approx(along, abs=1e-7 * (1.0 + 1.0 / ratio))


@given(COUNTS, ANGLES)
def test_small_balls_go_half_as_fast_as_the_ring(count: int, angle: float) -> None:
    found = turns_of(1e-9, angle)
    assert found.cage == pytest.approx(0.5)
    assert found.ball == pytest.approx(-0.5e9)


@given(RATIOS)
def test_thrust_bearing_limit(ratio: float) -> None:
    found = turns_of(ratio, 0.5 * pi)
    assert found.cage == pytest.approx(0.5)
    assert found.ball == pytest.approx(-0.5 / ratio)


@given(COUNTS, RATIOS, ANGLES, st.floats(0.1, 2000.0), st.sampled_from([-1.0, 1.0]))
def test_the_direction_of_turning_changes_no_frequency(
    count: int, ratio: float, angle: float, speed: float, sign: float
) -> None:
    bearing = _bearing(count, ratio, angle)
    one, other = nominal_frequencies(bearing, speed), nominal_frequencies(bearing, sign * speed)
    for name in LINES:
        assert one.lines[name].frequency == pytest.approx(other.lines[name].frequency)
        assert one.lines[name].order == pytest.approx(other.lines[name].order)
    assert other.turns.cage > 0.0


@given(COUNTS, RATIOS, ANGLES, SPEEDS, SPEEDS)
def test_orders_times_the_shaft_are_hertz(
    count: int, ratio: float, angle: float, inner: float, outer: float
) -> None:
    found = nominal_frequencies(_bearing(count, ratio, angle), inner, outer)
    for line in found.lines.values():
        assert line.order >= 0.0
        assert line.frequency == line.order * found.shaft_frequency
    if inner or outer:
        turns = turns_of(_bearing(count, ratio, angle).ball_diameter / 0.05, angle, inner, outer)
        assert found.cage.frequency == pytest.approx(abs(turns.cage) / (2 * pi), abs=1e-6)


@given(COUNTS, RATIOS, st.integers(1, 6), st.integers(0, 4), st.sampled_from(list(FAULTS)))
def test_tables_rise_and_hold_every_harmonic(
    count: int, ratio: float, harmonics: int, sidebands: int, kind: str
) -> None:
    found = nominal_frequencies(_bearing(count, ratio, 0.2), 100.0)
    lines = found.harmonics(kind, harmonics, sidebands)  # type: ignore[arg-type]
    orders = [line.order for line in lines]
    assert orders == sorted(orders)
    centres = [line.order for line in lines if line.sideband == 0]
    own = found.of_fault(kind).order  # type: ignore[arg-type]
    assert sorted(centres) == pytest.approx([n * own for n in range(1, harmonics + 1)])


@given(
    COUNTS,
    RATIOS,
    st.floats(0.05, 1.3),
    SPEEDS,
    SPEEDS,
    st.tuples(*[st.floats(-1.0, 1.0)] * 6),
)
def test_nothing_inside_the_tolerances_leaves_the_band(
    count: int,
    ratio: float,
    angle: float,
    inner: float,
    outer: float,
    at: tuple[float, ...],
) -> None:
    bearing = _bearing(count, ratio, angle)
    allowed = Tolerances(
        ball_diameter=0.01 * bearing.ball_diameter,
        pitch_diameter=0.0005,
        contact_angle=0.04,
        speed=0.02,
        slip=0.03,
    )
    assume(inner or outer)
    found = banded_frequencies(bearing, inner, outer, tolerances=allowed)
    gap = (bearing.ball_diameter * (1.0 + 0.01 * at[0])) / (0.05 + 0.0005 * at[1])
    turns = turns_of(
        gap,
        angle + 0.04 * at[2],
        inner * (1.0 + 0.02 * at[3]),
        outer * (1.0 + 0.02 * at[4]),
        0.015 * (1.0 + at[5]),
    )
    shaft = turns.inner if found.shaft == "inner" else turns.outer
    for name, size in line_orders(turns, count).items():
        band = found.lines[name].band
        assert band is not None
        hertz, order = abs(size) / (2.0 * pi), abs(size / shaft)
        assert band.frequency_low * (1 - 1e-9) - 1e-9 <= hertz <= band.frequency_high + 1e-6
        assert band.order_low * (1 - 1e-9) - 1e-9 <= order <= band.order_high * (1 + 1e-9) + 1e-9


@given(RATIOS, ANGLES, st.floats(-1.0, 1.0), SPEEDS, SPEEDS)
def test_yaw_turns_the_ball_and_not_the_cage(
    ratio: float, angle: float, yaw: float, inner: float, outer: float
) -> None:
    """With β = 0 the yaw weakens the ball's grip on both races alike."""
    assume(angle < 1.3)
    found = general_motion(1.0, (0.5 * ratio,) * 2, (angle, angle), 0.0, yaw, inner, outer)
    usual = turns_of(ratio, angle, inner, outer)
    assert float(found.orbital_speed) == pytest.approx(usual.cage, abs=1e-6)
    lead = usual.ball / (cos(yaw) * cos(angle))
    assert float(found.ball_speed) == pytest.approx(lead, rel=1e-9, abs=1e-6)


@given(
    RATIOS,
    st.tuples(ANGLES, ANGLES),
    st.floats(0.0, 1.2),
    st.floats(-0.8, 0.8),
    st.tuples(st.floats(0.9, 1.0), st.floats(0.9, 1.0)),
    SPEEDS,
    SPEEDS,
)
def test_no_point_of_contact_slips_along_rolling(
    ratio: float,
    angles: tuple[float, float],
    attitude: float,
    yaw: float,
    shares: tuple[float, float],
    inner: float,
    outer: float,
) -> None:
    """Velocities ω × r of ball and rings at the contacts, in the frame of the paper."""
    radii = (0.5 * ratio * shares[0], 0.5 * ratio * shares[1])
    found = general_motion(1.0, radii, angles, attitude, yaw, inner, outer)
    assume(bool(np.isfinite(found.ball_speed)) and abs(float(found.ball_speed)) < 1e6)
    axis = np.array(
        [
            np.cos(attitude) * np.cos(yaw),
            np.cos(attitude) * np.sin(yaw),
            np.sin(attitude),
        ]
    )
    ball = float(found.ball_speed) * axis
    sides = ((radii[0], angles[0], -1.0, inner), (radii[1], angles[1], 1.0, outer))
    for radius, angle, side, speed in sides:
        place = side * radius * np.array([-np.sin(angle), 0.0, np.cos(angle)])
        ring = np.array([speed - float(found.orbital_speed), 0.0, 0.0])
        race = np.cross(ring, np.array([0.0, 0.0, 0.5]) + place)
        slip = race - np.cross(ball, place)
        assert slip[1] == pytest.approx(0.0, abs=1e-9 * (1.0 + np.abs(race).max()))
