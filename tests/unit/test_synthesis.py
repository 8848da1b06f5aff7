"""Synthetic signals: impacts and their slip, ringing, load and path, waviness, noise, the truth."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from math import cos, inf, nan, pi, sin, sqrt
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy import special

from rolamento import Bearing, Case, Duty, Load
from rolamento.case.lubricant import Lubricant
from rolamento.case.model import Model
from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.plots.vibration_modulation import envelope_depths
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.status import NOT_CONVERGED
from rolamento.vibration.demodulation import analytic_signal
from rolamento.vibration.frequencies import FaultFrequencies, frequencies_of, nominal_frequencies
from rolamento.vibration.signal import Signal
from rolamento.vibration.synthesis import (
    Fault,
    GivenSpeed,
    LoadDistribution,
    Mode,
    Noise,
    Recipe,
    SteadySpeed,
    SwingingSpeed,
    TransferPath,
    WanderingSpeed,
    Waviness,
    recipe_of,
    synthesise,
    waviness_lines,
)
from rolamento.vibration.synthesis.speed import angle_of, speeds_of
from rolamento.vibration.synthesis.transfer import fast_length, recursion, ringing, summed

RATE = 51_200.0
SPEED = 2.0 * pi * 30.0
MODE = Mode(3500.0, 0.03, 10.0)


@pytest.fixture(scope="module")
def bearing() -> Bearing:
    return Bearing(
        ball_count=9,
        ball_diameter=7.94e-3,
        pitch_diameter=39.04e-3,
        diametral_clearance="0.012 mm",
        inner_conformity=0.52,
        outer_conformity=0.52,
    )


@pytest.fixture(scope="module")
def found(bearing: Bearing) -> FaultFrequencies:
    return nominal_frequencies(bearing, SPEED)


@pytest.fixture(scope="module")
def state(bearing: Bearing) -> Solved:
    return solve(Case(bearing=bearing, duty=Duty(inner_speed=SPEED, load=Load(fz="1 kN"))))


def _made(found: FaultFrequencies, *faults: Fault, **parts: Any) -> Any:
    return synthesise(Recipe(**{"frequencies": found, "faults": faults, "duration": 2.0, **parts}))


def _envelope_spectrum(samples: FloatArray) -> FloatArray:
    """Amplitudes of the Hilbert envelope's lines; by the transform alone."""
    count = samples.size
    spectrum = np.fft.fft(samples)
    spectrum[1 : count // 2] *= 2.0
    spectrum[count // 2 + 1 :] = 0.0
    envelope = np.abs(np.fft.ifft(spectrum))
    return 2.0 / count * np.abs(np.fft.rfft(envelope - envelope.mean()))


# --- when impacts come -----------------------------------------------------------------------


@pytest.mark.parametrize("kind", ["outer_race", "inner_race", "ball", "cage"])
def test_without_jitter_impacts_keep_the_clock(found: FaultFrequencies, kind: Any) -> None:
    truth = _made(found, Fault(kind=kind, jitter=0.0), duration=4.0).truth.faults[0]
    assert truth.frequency == pytest.approx(found.of_fault(kind).frequency)
    assert np.diff(truth.times) == pytest.approx(1.0 / truth.frequency, rel=1e-9)
    assert 0.0 <= truth.times[0] < 1.0 / truth.frequency
    assert 4.0 - 1.0 / truth.frequency <= truth.times[-1] + 1e-9 < 4.0


def test_deviations_of_intervals_add_up(found: FaultFrequencies) -> None:
    """The k-th impact of a random walk is off by √k standard deviations of an interval."""
    ends = []
    for seed in range(300):
        parts: dict[str, Any] = {"seed": seed, "duration": 1.0, "rate": 8192.0}
        truth = _made(
            found, Fault(kind="outer_race", jitter=0.05), modes=(Mode(1000.0),), **parts
        ).truth.faults[0]
        ends.append((truth.times[80] - truth.times[0]) * truth.frequency)
    assert np.mean(ends) == pytest.approx(80.0, abs=4.0 * 0.05 * sqrt(80.0 / 300.0))
    assert np.std(ends) == pytest.approx(0.05 * sqrt(80.0), rel=0.15)


def test_scatter_about_a_clock_does_not_add_up(found: FaultFrequencies) -> None:
    fault = Fault(kind="outer_race", jitter=0.05, slip="around")
    truth = _made(found, fault, duration=20.0, rate=8192.0, modes=(Mode(1000.0),)).truth.faults[0]
    off = truth.times * truth.frequency - np.arange(truth.times.size)
    off -= off.mean()
    assert np.std(off) == pytest.approx(0.05, rel=0.05)
    assert np.std(off[-500:]) == pytest.approx(np.std(off[:500]), rel=0.2)


def test_impacts_follow_the_angle_of_a_swinging_shaft(found: FaultFrequencies) -> None:
    speed = SwingingSpeed(SPEED, 0.3, 0.7)
    made = _made(found, Fault(kind="inner_race", jitter=0.0), speed=speed)
    truth = made.truth.faults[0]
    angle = angle_of(made.truth.speed, made.signal.samples.size, RATE)
    at = np.interp(truth.times, np.arange(angle.size) / RATE, angle)
    assert np.diff(at) * truth.order / (2 * pi) == pytest.approx(1.0, abs=1e-6)
    assert np.ptp(np.diff(truth.times)) > 0.3 / truth.frequency
    mean = angle[-1] / (2 * pi) / ((angle.size - 1) / RATE)
    assert truth.frequency == pytest.approx(truth.order * mean)


def test_a_shaft_that_turns_backwards_is_as_good(found: FaultFrequencies, bearing: Bearing) -> None:
    back = nominal_frequencies(bearing, -SPEED)
    fault = Fault(kind="inner_race", azimuth=0.5)
    one, other = _made(found, fault).truth.faults[0], _made(back, fault).truth.faults[0]
    assert one.times == pytest.approx(other.times)
    assert np.mod(one.azimuths + other.azimuths, 2 * pi) == pytest.approx(1.0)


# --- how strong they are ---------------------------------------------------------------------


def test_a_spot_on_the_inner_race_goes_round_with_the_shaft(found: FaultFrequencies) -> None:
    load = LoadDistribution.radial(0.5)
    path = TransferPath(sensor_azimuth=0.0, far_gain=0.2)
    truth = _made(found, Fault(kind="inner_race", azimuth=0.3), load=load, path=path).truth.faults[
        0
    ]
    assert truth.azimuths == pytest.approx(np.mod(0.3 - SPEED * truth.times, 2 * pi), abs=1e-6)
    expected = load.at(truth.azimuths, "inner") * path.at(truth.azimuths)
    assert truth.strengths == pytest.approx(expected)
    assert truth.strengths.min() == 0.0


def test_a_spot_on_a_still_outer_race_stays(found: FaultFrequencies, state: Solved) -> None:
    load = LoadDistribution.of_solved(state)
    for azimuth in (0.0, 0.6, pi):
        fault = Fault(kind="outer_race", azimuth=azimuth)
        truth = _made(found, fault, load=load).truth.faults[0]
        assert np.ptp(truth.strengths) == 0.0
        strength = load.at(azimuth, "outer") * TransferPath().at(azimuth)
        assert truth.strengths[0] == pytest.approx(float(strength))


def test_a_spot_on_a_turning_outer_race_goes_round(bearing: Bearing) -> None:
    turning = nominal_frequencies(bearing, 0.0, SPEED)
    truth = _made(turning, Fault(kind="outer_race")).truth.faults[0]
    assert truth.azimuths == pytest.approx(np.mod(-SPEED * truth.times, 2 * pi), abs=1e-6)


def test_unbalance_takes_the_load_along(found: FaultFrequencies) -> None:
    parts: dict[str, Any] = {
        "load": LoadDistribution.radial(0.5), "load_turns": 1.0, "path": TransferPath(far_gain=1.0)
    }  # fmt: skip
    inner = _made(found, Fault(kind="inner_race", azimuth=0.4), **parts).truth.faults[0]
    assert np.ptp(inner.strengths) < 1e-9
    outer = _made(found, Fault(kind="outer_race"), **parts).truth.faults[0]
    assert outer.strengths.min() < 0.01
    assert outer.strengths.max() > 0.9


def test_a_ball_strikes_both_races_by_turns(found: FaultFrequencies) -> None:
    fault = Fault(kind="ball", inner_gain=0.25)
    truth = _made(found, fault, path=TransferPath(far_gain=1.0)).truth.faults[0]
    assert truth.strengths[::2] == pytest.approx(1.0)
    assert truth.strengths[1::2] == pytest.approx(0.25)
    cage = found.turns.cage * SPEED * truth.times
    slow = 0.02 * found.cage.order * 2 * pi * sqrt(truth.times.size) / truth.order
    assert np.abs(np.angle(np.exp(1j * (truth.azimuths + cage)))).max() < slow


def test_the_cage_is_not_pressed(found: FaultFrequencies) -> None:
    parts: dict[str, Any] = {"load": LoadDistribution.radial(0.3)}
    truth = _made(found, Fault(kind="cage", strength=2.0, jitter=0.0), **parts).truth.faults[0]
    # it strikes once a turn, and so at one place
    assert truth.strengths == pytest.approx(float(2.0 * TransferPath().at(truth.azimuths[0])))


def test_strengths_scatter(found: FaultFrequencies) -> None:
    fault = Fault(kind="outer_race", scatter=0.2)
    truth = _made(found, fault, duration=10.0).truth.faults[0]
    assert np.std(truth.strengths) / np.mean(truth.strengths) == pytest.approx(0.2, rel=0.1)
    assert truth.strengths.min() >= 0.0


# --- load ------------------------------------------------------------------------------------


def test_load_of_a_state_is_solved_between_its_balls(state: Solved) -> None:
    load = LoadDistribution.of_solved(state, positions=8)
    assert load.azimuth.size == 72
    assert load.at(0.0, "inner") == pytest.approx(1.0)
    assert load.at(pi, "inner") == 0.0
    assert load.at(0.3, "inner") == pytest.approx(float(load.at(-0.3, "inner")), abs=1e-3)
    own = LoadDistribution.of_solved(state, positions=1)
    assert own.azimuth.size == 9
    loads = state.inner.load[0]
    assert own.inner == pytest.approx(loads / loads.max())
    # what is solved agrees with the state where the state has a ball; the peaks differ a little
    at_balls = load.at(state.elements.azimuth[0], "inner")
    assert at_balls == pytest.approx(loads / loads.max(), abs=0.02)


def test_load_under_friction_control_is_of_its_own_balls(bearing_218: Bearing) -> None:
    case = Case(
        bearing=bearing_218,
        duty=Duty(inner_speed="3000 rpm", load=Load(fx="10 kN")),
        lubricant=Lubricant(kind="dry", friction_coefficient=0.1),
        model=Model(raceway_control="friction", mesh="coarse"),
    )
    load = LoadDistribution.of_solved(solve(case))
    assert load.azimuth.size == 16
    assert load.inner == pytest.approx(1.0, abs=1e-6)


def test_load_needs_a_result(state: Solved) -> None:
    failed = replace(state, status=replace(state.status, number=np.array([NOT_CONVERGED])))
    with pytest.raises(InputError, match="with a result"):
        LoadDistribution.of_solved(failed)
    with pytest.raises(InputError, match="such a row"):
        LoadDistribution.of_solved(state, row=1)
    with pytest.raises(InputError, match="positions"):
        LoadDistribution.of_solved(state, positions=0)


def test_plain_loads() -> None:
    assert LoadDistribution.uniform().at([0.0, 1.0, 100.0], "outer").tolist() == [1.0, 1.0, 1.0]
    zone = LoadDistribution.radial(0.5, azimuth=1.0)
    assert zone.at(1.0, "inner") == pytest.approx(1.0, abs=1e-4)
    assert zone.at(1.0 + 0.5 * pi, "inner") == pytest.approx(0.0, abs=1e-3)
    assert zone.at(2.0, "inner") == pytest.approx(cos(1.0) ** 1.5, abs=1e-4)
    wide = LoadDistribution.radial(1e6)
    assert wide.inner.min() > 0.999


@pytest.mark.parametrize(
    ("azimuth", "inner"),
    [([], []), ([0.0, 0.0], [1, 1]), ([0.0, 7.0], [1, 1]), ([0.0], [1.2]), ([0.0], [nan]),
     ([nan], [1.0]), ([0.0, 1.0], [1.0])],
)  # fmt: skip
def test_loads_are_checked(azimuth: list[float], inner: list[float]) -> None:
    with pytest.raises(InputError):
        LoadDistribution(np.array(azimuth), np.array(inner), np.array(inner))


# --- from the impact to the sensor -----------------------------------------------------------


def _by_formula(
    times: FloatArray, strengths: FloatArray, modes: tuple[Mode, ...], count: int
) -> FloatArray:
    total, at = np.zeros(count), np.arange(count) / RATE
    for moment, strength in zip(times, strengths, strict=True):
        after = np.maximum(at - moment, 0.0)
        for mode in modes:
            pulse = 2 * pi * mode.frequency
            ring = np.exp(-mode.damping * pulse * after)
            ring *= np.sin(pulse * sqrt(1 - mode.damping**2) * after)
            total += strength * mode.gain * ring
    return total


def test_ringing_is_the_sum_of_the_answers() -> None:
    random = np.random.default_rng(3)
    count = 3000
    times, strengths = np.sort(random.uniform(0, count / RATE, 25)), random.uniform(0, 2, 25)
    # the last rings through the whole signal and takes the other way
    modes = (MODE, Mode(900.0, 1e-4, -2.0), Mode(60.0, 0.7, 3.0))
    found = ringing(times, strengths, modes, count, RATE)
    assert found == pytest.approx(_by_formula(times, strengths, modes, count), abs=1e-10)


def test_both_ways_of_ringing_agree() -> None:
    random = np.random.default_rng(4)
    count = 5003
    place = np.sort(random.integers(0, count, 40)).astype(np.intp)
    entering = random.standard_normal(40) + 1j * random.standard_normal(40)
    for root in (-0.01 + 0.4j, -1e-5 + 1e-3j, -0.5 + 3.0j):
        lasts = min(count, int(40.0 / -root.real) + 1)
        plain = summed(place, entering, root, lasts, count)
        fast = recursion(place, entering, root, lasts, count)
        assert fast == pytest.approx(plain, abs=1e-9)


def test_impacts_outside_ring_nothing() -> None:
    assert not ringing(np.array([-1.0, 99.0]), np.ones(2), (MODE,), 100, RATE).any()
    assert not ringing(np.zeros(0), np.zeros(0), (MODE,), 100, RATE).any()


@pytest.mark.parametrize("count", [1, 2, 7, 97, 5003, 512_000, 999_983])
def test_fast_lengths(count: int) -> None:
    length = rest = fast_length(count)
    for prime in (2, 3, 5):
        while rest % prime == 0:
            rest //= prime
    assert rest == 1
    assert count <= length <= 1.1 * count + 1


def test_path_weakens_away_from_the_sensor() -> None:
    path = TransferPath(sensor_azimuth=1.0, far_gain=0.2)
    assert path.at([1.0, 1.0 + pi, 1.0 + pi / 2]) == pytest.approx([1.0, 0.2, 0.6])
    table = TransferPath(sensor_azimuth=0.5, gains=(1.0, 0.4, 0.2, 0.6))
    assert table.at(0.5 + np.arange(4) * pi / 2) == pytest.approx([1.0, 0.4, 0.2, 0.6])
    assert table.at(0.5 + 1.75 * pi) == pytest.approx(0.8)


# --- amplitude and frequency -----------------------------------------------------------------


def test_an_envelope_shows_impacts_and_no_swinging_frequency(found: FaultFrequencies) -> None:
    """What impacts do is modulation of amplitude: the envelope of the other kind is flat."""
    lines = {}
    place = round(found.ball_pass_outer.frequency * 4.0)
    for modulation in ("amplitude", "frequency"):
        fault = Fault(kind="outer_race", jitter=0.0, modulation=modulation)
        made = _made(found, fault, duration=4.0)
        spectrum = _envelope_spectrum(made.signal.samples)
        lines[modulation] = spectrum[place - 1 : place + 2].max() / made.signal.samples.std()
    assert lines["amplitude"] > 0.5
    assert lines["frequency"] < 1e-3


THEORY = Path(__file__).resolve().parents[2] / "docs" / "theory" / "vibration-frequencies.md"


def _swing(signal: Signal, line: float, band: tuple[float, float] | None) -> float:
    """Swing of the instantaneous frequency at a line; Hz."""
    phase = np.unwrap(np.angle(analytic_signal(signal, band)))
    frequency = signal.rate / (2.0 * pi) * np.diff(phase)
    turns = np.exp(-2j * pi * line / signal.rate * np.arange(frequency.size))
    return float(2.0 * abs(np.mean(frequency * turns)))


def test_the_theory_prints_what_envelopes_of_both_modulations_are() -> None:
    """Every figure of its table, to the digits that are printed."""
    frequencies = nominal_frequencies(Bearing.named("6205"), 1797.0 * pi / 30.0)
    line = frequencies.ball_pass_outer.frequency
    amplitude, frequency = (
        _made(
            frequencies,
            Fault(kind="outer_race", modulation=modulation, jitter=0.0),
            duration=200.0 / line,
        ).signal
        for modulation in ("amplitude", "frequency")
    )
    text = THEORY.read_text("utf-8").partition("| band | AM")[2].partition("\n\n")[0]
    rows = re.findall(r"\| (all|\d+ to \d+ Hz) \| (\S+) \| (\S+) \| (\d+) Hz \|", text)
    assert len(rows) == 3
    for name, *printed in rows:
        edges = [float(number) for number in re.findall(r"\d+", name)]
        band = (edges[0], edges[1]) if edges else None
        depths = [envelope_depths(signal, line, band)[0] for signal in (amplitude, frequency)]
        found = (*depths, _swing(frequency, line, band))
        for text_of, value in zip(printed, found, strict=True):
            digits = len(text_of.partition(".")[2])
            assert f"{value:.{digits}f}" == text_of


@pytest.mark.parametrize("passages", [100, 333])
def test_one_sided_modulation_of_frequency_against_bessel(
    found: FaultFrequencies, passages: int
) -> None:
    """|Σ J_k(1) exp(jkθ)| over k from 0: its first lines over its mean, whatever the record."""
    angle = np.linspace(0.0, 2.0 * pi, 1000, endpoint=False)
    size = np.abs(sum(special.jv(k, 1.0) * np.exp(1j * k * angle) for k in range(12)))
    wanted = [2.0 * abs(np.mean(size * np.exp(-1j * n * angle))) / size.mean() for n in (1, 2, 3)]
    assert wanted[0] == pytest.approx(0.549, abs=5e-4)
    line = found.ball_pass_outer.frequency
    fault = Fault(kind="outer_race", modulation="frequency", jitter=0.0)
    made = _made(found, fault, duration=passages / line)
    depths = envelope_depths(made.signal, line, (3450.0, 4500.0))
    assert depths == pytest.approx(wanted, abs=6e-3)


def test_a_swinging_frequency_has_sidebands_of_bessel(found: FaultFrequencies) -> None:
    """J_0(1) = 0.7652 at the carrier, J_1(1) = 0.4401 a passage away, J_2(1) = 0.1149 two."""
    speed = 2 * pi * 100.0 / found.ball_pass_outer.order
    fault = Fault(kind="outer_race", jitter=0.0, modulation="frequency", index=1.0)
    made = _made(
        found, fault, speed=SteadySpeed(speed), duration=1.0, modes=(Mode(4000.0, 0.03, 1.0),)
    )
    spectrum = 2.0 / made.signal.samples.size * np.abs(np.fft.rfft(made.signal.samples))
    found_lines = spectrum[[4000, 4100, 3900, 4200]]
    assert found_lines == pytest.approx([0.7652, 0.4401, 0.4401, 0.1149], abs=2e-3)


# --- speed -----------------------------------------------------------------------------------


def test_given_speeds_go_straight_between() -> None:
    random = np.random.default_rng(0)
    profile = GivenSpeed(np.array([0.5, 1.5]), np.array([100.0, 200.0]))
    speeds = speeds_of(profile, 2001, 1000.0, random)
    assert speeds[[0, 500, 1000, 1500, 2000]] == pytest.approx([100, 100, 150, 200, 200])
    angle = angle_of(speeds, 2001, 1000.0)
    assert angle[-1] == pytest.approx(0.5 * 100 + 150 + 0.5 * 200)


def test_wandering_speeds_have_their_spread_and_memory() -> None:
    profile = WanderingSpeed(100.0, 0.02, 0.5)
    speeds = speeds_of(profile, 2_000_000, 1000.0, np.random.default_rng(1))
    off = speeds / 100.0 - 1.0
    assert off.std() == pytest.approx(0.02, rel=0.1)
    later = np.mean(off[:-500] * off[500:]) / np.mean(off**2)
    assert later == pytest.approx(np.exp(-1.0), abs=0.08)


@pytest.mark.parametrize(
    "profile",
    [
        SteadySpeed(0.0),
        SteadySpeed(nan),
        SteadySpeed(1e9),
        SwingingSpeed(0.0, 0.1, 1.0),
        SwingingSpeed(100.0, 0.95, 1.0),
        SwingingSpeed(100.0, 0.1, -1.0),
        WanderingSpeed(100.0, 0.5, 1.0),
        WanderingSpeed(100.0, 0.1, 0.0),
        GivenSpeed(np.array([0.0, 1.0]), np.array([-1.0, 1.0])),
        GivenSpeed(np.array([0.0, 0.0]), np.array([1.0, 1.0])),
        GivenSpeed(np.array([0.0]), np.array([1.0, 1.0])),
        GivenSpeed(np.zeros(0), np.zeros(0)),
        GivenSpeed(np.array([0.0, 1.0]), np.array([1.0, nan])),
    ],
)
def test_speeds_are_checked(profile: Any) -> None:
    with pytest.raises(InputError):
        speeds_of(profile, 1000, 1000.0, np.random.default_rng(0))


def test_a_speed_has_to_come_from_somewhere(bearing: Bearing) -> None:
    with pytest.raises(InputError, match="speed"):
        synthesise(Recipe(frequencies=nominal_frequencies(bearing), duration=0.1))
    made = synthesise(
        Recipe(frequencies=nominal_frequencies(bearing), duration=0.1, speed=SteadySpeed(100.0))
    )
    assert made.signal.mean_speed == 100.0


# --- waviness --------------------------------------------------------------------------------


def _motion_of_ring(
    found: FaultFrequencies, surface: str, waves: int, axial: bool, angle: float
) -> tuple[FloatArray, FloatArray]:
    """Shaft angle, and the ring's motion under waves of amplitude 1, added up ball by ball."""
    turned = np.linspace(0.0, 40.0 * pi, 40_000)
    turns, count = found.turns, found.ball_count
    total = np.zeros(turned.size)
    for ball in range(count):
        place = 2.0 * pi * ball / count
        azimuth = turns.cage * turned + place
        if surface == "ball":
            felt = np.cos(waves * turns.ball * turned) + np.cos(waves * (turns.ball * turned + pi))
            felt = felt if ball == 0 else 0.0 * felt
        else:
            ring = turns.outer if surface == "outer" else turns.inner
            felt = np.cos(waves * ((turns.cage - ring) * turned + place) + 0.7)
        part = 1.0 / sin(angle) if axial else 2.0 * np.cos(azimuth) / cos(angle)
        total += felt * part / count
    return turned, total


@pytest.mark.parametrize("surface", ["outer", "inner", "ball"])
@pytest.mark.parametrize("axial", [False, True])
@pytest.mark.parametrize("rings", [(SPEED, 0.0), (SPEED, -0.4 * SPEED)])
@pytest.mark.thirds
def test_waves_as_the_balls_feel_them_together(
    bearing: Bearing, surface: Any, axial: bool, rings: tuple[float, float]
) -> None:
    """The lines against the sum over all balls: what they say is there, and nothing else."""
    angle = 0.3
    found = nominal_frequencies(bearing, *rings, contact_angle=angle)
    for waves in range(1, 2 * bearing.ball_count + 3):
        wavy = Waviness(surface, ((waves, 1e-4),), "axial" if axial else "radial")
        lines = waviness_lines(found, wavy)
        turned, motion = _motion_of_ring(found, surface, waves, axial, angle)
        if not lines:
            # one wave around a still outer race shifts the ring and lets it stay there
            assert np.ptp(motion) < 1e-9
            continue
        columns = [f(line.order * turned) for line in lines for f in (np.cos, np.sin)]
        basis = np.stack(columns, axis=1)
        fitted, *_ = np.linalg.lstsq(basis, motion, rcond=None)
        assert np.abs(basis @ fitted - motion).max() < 1e-6
        sizes = np.hypot(fitted[::2], fitted[1::2])
        assert sizes == pytest.approx([line.amplitude / 1e-4 for line in lines], rel=1e-4)


def test_waves_of_the_races_at_their_usual_places(found: FaultFrequencies) -> None:
    outer = waviness_lines(found, Waviness("outer", ((8, 1e-7), (9, 1e-7), (10, 1e-7))))
    assert [line.order for line in outer] == pytest.approx([found.ball_pass_outer.order] * 2)
    inner = waviness_lines(found, Waviness("inner", ((8, 1e-7), (10, 1e-7))))
    order = found.ball_pass_inner.order
    assert [line.order for line in inner] == pytest.approx([order - 1.0, order + 1.0])
    ball = waviness_lines(found, Waviness("ball", ((2, 9e-7), (3, 9e-7))))
    spin, cage = found.ball_spin_twice.order, found.cage.order
    assert sorted(line.order for line in ball) == pytest.approx([spin - cage, spin + cage])
    assert ball[0].amplitude == pytest.approx(2e-7)


def test_a_ring_that_follows_waves_is_accelerated(found: FaultFrequencies) -> None:
    made = _made(found, waviness=(Waviness("outer", ((10, 1e-7),)),))
    pulse = found.ball_pass_outer.order * SPEED
    assert made.signal.samples.std() == pytest.approx(1e-7 * pulse**2 / sqrt(2.0), rel=1e-3)


def test_acceleration_under_a_swinging_speed(found: FaultFrequencies) -> None:
    """The second difference of the motion itself."""
    speed = SwingingSpeed(SPEED, 0.3, 5.0)
    made = _made(found, waviness=(Waviness("outer", ((10, 1e-6),)),), speed=speed)
    angle = angle_of(made.truth.speed, made.signal.samples.size, RATE)
    line = made.truth.waviness_lines[0]
    basis = [np.gradient(np.gradient(f(line.order * angle))) for f in (np.cos, np.sin)]
    columns = np.stack(basis, axis=1)[2:-2] * RATE**2
    samples = made.signal.samples[2:-2]
    fitted, *_ = np.linalg.lstsq(columns, samples, rcond=None)
    assert np.hypot(*fitted) == pytest.approx(1e-6, rel=1e-3)
    assert np.abs(columns @ fitted - samples).max() < 2e-3 * np.abs(samples).max()


def test_waves_beyond_half_the_rate_are_left_out(found: FaultFrequencies) -> None:
    made = _made(found, waviness=(Waviness("outer", ((1801, 1e-9),)),), rate=20_000.0)
    assert made.truth.waviness_lines[0].order * 30.0 > 10_000.0
    assert not made.signal.samples.any()


def test_axial_waves_need_a_contact_angle(found: FaultFrequencies) -> None:
    with pytest.raises(InputError, match="contact angle"):
        waviness_lines(found, Waviness("outer", ((9, 1e-7),), "axial"))


def test_amplitudes_that_fall() -> None:
    wavy = Waviness.falling("inner", 1e-6, first=2, last=8, slope=2.0)
    assert dict(wavy.amplitudes)[2] == 1e-6
    assert dict(wavy.amplitudes)[8] == pytest.approx(1e-6 / 16.0)


@pytest.mark.parametrize(
    "arguments",
    [("cage", ()), ("outer", ((0, 1e-7),)), ("outer", ((2, -1.0),)), ("outer", ((2, 1.0),)),
     ("outer", ((2, 1e-7),), "tangential"), ("outer", ((2, 1e-9),) * 20_000)],
)  # fmt: skip
def test_waviness_is_checked(arguments: tuple[Any, ...]) -> None:
    with pytest.raises(InputError):
        Waviness(*arguments)


# --- shaft and noise -------------------------------------------------------------------------


def test_harmonics_of_the_shaft(found: FaultFrequencies) -> None:
    made = _made(found, shaft_harmonics=(1.0, 0.0, 0.25))
    spectrum = 2.0 / made.signal.samples.size * np.abs(np.fft.rfft(made.signal.samples))
    assert spectrum[[60, 120, 180]] == pytest.approx([1.0, 0.0, 0.25], abs=1e-6)
    assert np.delete(spectrum, [60, 180]).max() < 1e-6


@pytest.mark.parametrize("colour", ["white", "pink"])
def test_noise_has_its_ratio_and_colour(found: FaultFrequencies, colour: Any) -> None:
    fault = Fault(kind="outer_race")
    clean = _made(found, fault, shaft_harmonics=(2.0,))
    noisy = _made(found, fault, shaft_harmonics=(2.0,), noise=Noise(colour=colour, ratio=-6.0))
    noise = noisy.signal.samples - clean.signal.samples
    power = float(np.mean(clean.signal.samples**2))
    assert 10 * np.log10(power / np.mean(noise**2)) == pytest.approx(-6.0)
    assert noisy.truth.signal_to_noise == pytest.approx(-6.0)
    assert noisy.truth.noise_level == pytest.approx(noise.std(), rel=1e-3)
    density = np.abs(np.fft.rfft(noise)) ** 2
    low, high = density[200:400].mean(), density[20_000:40_000].mean()
    # pink: a hundred times the frequency, a hundredth of the density
    assert low / high == pytest.approx(100.0 if colour == "pink" else 1.0, rel=0.3)


def test_noise_beside_the_faults_alone(found: FaultFrequencies) -> None:
    noise = Noise(ratio=0.0, of="faults")
    fault = Fault(kind="outer_race")
    alone, loud = (_made(found, fault, noise=noise, shaft_harmonics=h) for h in ((), (100.0,)))
    assert alone.truth.noise_level == pytest.approx(loud.truth.noise_level)
    assert loud.truth.signal_to_noise > 20.0


def test_noise_beside_waviness_alone(found: FaultFrequencies) -> None:
    waves = (Waviness.falling("outer", 1e-7, last=60),)
    clean = _made(found, waviness=waves).signal.samples
    made = _made(found, waviness=waves, noise=Noise(ratio=-3.0))
    noise = made.signal.samples - clean
    assert 10 * np.log10(np.mean(clean**2) / np.mean(noise**2)) == pytest.approx(-3.0)
    assert made.truth.signal_to_noise == pytest.approx(-3.0)


def test_a_ratio_to_faults_needs_one(found: FaultFrequencies) -> None:
    for waves in ((), (Waviness("outer", ((10, 1e-7),)),)):
        with pytest.raises(InputError, match="there are none") as caught:
            Recipe(frequencies=found, waviness=waves, noise=Noise(ratio=0.0, of="faults"))
        assert caught.value.field == "noise.of"
    assert Recipe(frequencies=found, noise=Noise(level=1.0, of="faults")).faults == ()


def test_noise_at_a_level_and_without_a_signal(found: FaultFrequencies) -> None:
    made = _made(found, noise=Noise(level=0.5))
    assert np.sqrt(np.mean(made.signal.samples**2)) == pytest.approx(0.5)
    assert made.truth.signal_to_noise == -inf
    silent = _made(found, noise=Noise(ratio=0.0))
    assert not silent.signal.samples.any()


@pytest.mark.parametrize(
    "arguments",
    [{}, {"ratio": 0.0, "level": 1.0}, {"ratio": nan}, {"level": -1.0}, {"colour": "brown"},
     {"ratio": 0.0, "of": "waves"}],
)  # fmt: skip
def test_noise_is_checked(arguments: dict[str, Any]) -> None:
    with pytest.raises(InputError):
        Noise(**arguments)


# --- seeds, truth, bounds --------------------------------------------------------------------


def test_the_same_seed_gives_the_same_signal(found: FaultFrequencies) -> None:
    parts: dict[str, Any] = {
        "noise": Noise(ratio=0.0), "speed": WanderingSpeed(SPEED, 0.01, 0.3),
        "waviness": (Waviness.falling("outer", 1e-7),), "shaft_harmonics": (1.0, 0.5),
    }  # fmt: skip
    fault = Fault(kind="ball", scatter=0.1)
    one, same, other = (_made(found, fault, seed=seed, **parts) for seed in (5, 5, 6))
    assert np.array_equal(one.signal.samples, same.signal.samples)
    assert not np.array_equal(one.truth.faults[0].times, other.truth.faults[0].times)
    assert not np.array_equal(one.truth.speed, other.truth.speed)


def test_one_more_part_changes_none_of_the_others(found: FaultFrequencies) -> None:
    fault, more = Fault(kind="inner_race"), Fault(kind="outer_race")
    plain = _made(found, fault)
    rich = _made(
        found, fault, more, noise=Noise(ratio=0.0), shaft_harmonics=(1.0,),
        waviness=(Waviness.falling("inner", 1e-8),),
    )  # fmt: skip
    assert np.array_equal(plain.truth.faults[0].times, rich.truth.faults[0].times)


def test_a_recipe_of_a_state(state: Solved) -> None:
    recipe = recipe_of(state, [Fault(kind="inner_race")], duration=0.5, noise=Noise(ratio=10.0))
    assert recipe.frequencies == frequencies_of(state)
    assert recipe.load.at(0.0, "inner") == pytest.approx(1.0)
    made = synthesise(recipe)
    assert made.signal.quantity == "acceleration"
    assert made.signal.unit == "m/s^2"
    assert made.signal.mean_speed == pytest.approx(SPEED)
    assert made.signal.speed is not None
    assert made.signal.speed.shape == ()
    own = LoadDistribution.uniform()
    assert recipe_of(state, [], load=own).load is own


def test_the_truth_can_be_written(found: FaultFrequencies) -> None:
    fault = Fault(kind="ball", azimuth=1.0)
    made = _made(found, fault, waviness=(Waviness("outer", ((10, 1e-8),)),), duration=0.2)
    truth = json.loads(json.dumps(made.truth.to_mapping(), allow_nan=False))
    assert truth["faults"][0]["times"] == made.truth.faults[0].times.tolist()
    assert truth["faults"][0]["kind"] == "ball"
    assert truth["signal_to_noise"] is None
    assert truth["speed"]["mean"] == pytest.approx(SPEED)
    assert truth["waviness"][0]["waves"] == 10
    assert truth["frequencies"]["cage"]["order"] == found.cage.order


def test_each_fault_has_the_size_of_what_it_makes_alone(found: FaultFrequencies) -> None:
    faults = (
        Fault(kind="outer_race", strength=2.0),
        Fault(kind="ball", modulation="frequency", index=0.5),
        Fault(kind="inner_race", strength=0.0),
    )
    truth = _made(found, *faults, noise=Noise(level=3.0), shaft_harmonics=(1.0,)).truth
    for number, told in enumerate(truth.faults):
        # silent beside it, so that each draws from its own source as before
        others = tuple(
            replace(fault, strength=fault.strength if place == number else 0.0)
            for place, fault in enumerate(faults)
        )
        alone = _made(found, *others).signal.samples
        assert told.rms == pytest.approx(np.sqrt(np.mean(alone**2)), rel=1e-12)
        assert told.to_mapping()["rms"] == told.rms
    assert truth.faults[2].rms == 0.0


@pytest.mark.parametrize("speed", [None, SwingingSpeed(SPEED, 0.1, 1.0)])
def test_speed_at_every_sample(found: FaultFrequencies, speed: Any) -> None:
    made = _made(found, Fault(kind="cage"), speed=speed)
    assert made.truth.speeds.shape == made.signal.samples.shape
    assert np.array_equal(made.truth.speeds, made.truth.speed + np.zeros(made.signal.samples.size))
    angle = angle_of(made.truth.speeds, made.signal.samples.size, RATE)
    assert angle == pytest.approx(angle_of(made.truth.speed, angle.size, RATE), rel=1e-9)


def test_rings_that_turn_alike_make_no_impacts(bearing: Bearing) -> None:
    alike = nominal_frequencies(bearing, SPEED, SPEED)
    made = _made(alike, Fault(kind="outer_race"), Fault(kind="ball", modulation="frequency"))
    assert [truth.times.size for truth in made.truth.faults] == [0, 0]


@pytest.mark.parametrize(
    "parts",
    [
        {"duration": 0.0},
        {"duration": nan},
        {"duration": 1e5},
        {"rate": 0.0},
        {"rate": inf},
        {"rate": 6000.0},
        {"seed": -1},
        {"seed": True},
        {"load_turns": nan},
        {"shaft_harmonics": (-1.0,)},
        {"shaft_harmonics": (1.0,) * 1000},
        {"modes": (Mode(1000.0),) * 1000},
    ],
)
def test_recipes_are_checked(found: FaultFrequencies, parts: dict[str, Any]) -> None:
    with pytest.raises(InputError):
        Recipe(frequencies=found, **parts)


def test_frequencies_without_a_result_make_no_signal(state: Solved) -> None:
    failed = replace(state, status=replace(state.status, number=np.array([NOT_CONVERGED])))
    with pytest.raises(InputError, match="result"):
        Recipe(frequencies=frequencies_of(failed))


@pytest.mark.parametrize(
    "parts",
    [{"kind": "gear"}, {"slip": "none"}, {"modulation": "phase"}, {"jitter": 0.5},
     {"jitter": nan}, {"scatter": -1.0}, {"strength": -1.0}, {"index": nan}, {"azimuth": inf},
     {"inner_gain": -1.0}],
)  # fmt: skip
def test_faults_are_checked(parts: dict[str, Any]) -> None:
    with pytest.raises(InputError):
        Fault(**{"kind": "ball", **parts})


@pytest.mark.parametrize(
    "make",
    [
        lambda: Mode(-1.0),
        lambda: Mode(100.0, 0.0),
        lambda: Mode(100.0, 0.1, nan),
        lambda: TransferPath(far_gain=2.0),
        lambda: TransferPath(sensor_azimuth=nan),
        lambda: TransferPath(gains=(1.0, -1.0)),
        lambda: LoadDistribution.radial(0.0),
    ],
)
def test_paths_and_modes_are_checked(make: Any) -> None:
    with pytest.raises(InputError):
        make()


def test_impacts_have_a_bound(bearing: Bearing) -> None:
    fast = nominal_frequencies(bearing, 1e6)
    recipe = Recipe(
        frequencies=fast,
        faults=(Fault(kind="inner_race"),),
        duration=10.0,
        rate=8000.0,
        modes=(Mode(1000.0),),
    )
    with pytest.raises(InputError, match="may be at most 5 000 000; shorten") as caught:
        synthesise(recipe)
    assert caught.value.field == "faults.impacts"
    assert caught.value.value == round(fast.ball_pass_inner.frequency * 10.0 * (1.0 - 1.0 / 80_000))


def test_lines_of_waviness_and_steps_of_a_speed_have_a_bound(found: FaultFrequencies) -> None:
    with pytest.raises(InputError) as caught:
        waviness_lines(found, Waviness.falling("inner", 1e-9, last=10_000))
    assert caught.value.field == "waviness.lines"
    with pytest.raises(InputError, match="steps of a wandering speed") as caught:
        speeds_of(WanderingSpeed(1.0, 0.1, 1e-3), 200_000, 1000.0, np.random.default_rng(0))
    assert (caught.value.field, caught.value.value) == ("memory", 1e-3)


def test_ten_seconds_with_everything(found: FaultFrequencies) -> None:
    recipe = Recipe(
        frequencies=found,
        faults=(Fault(kind="inner_race"),),
        load=LoadDistribution.radial(),
        noise=Noise(ratio=0.0),
        shaft_harmonics=(1.0, 0.5),
    )
    made = synthesise(recipe)
    assert made.signal.samples.size == 512_000


# --- the guide -------------------------------------------------------------------------------


@pytest.mark.parametrize("number", [0, 1])
def test_the_examples_of_the_guide_run(number: int, capsys: pytest.CaptureFixture[str]) -> None:
    guide = (Path(__file__).resolve().parents[2] / "docs" / "frequencies.md").read_text("utf-8")
    blocks = re.findall(r"```python\n(.*?)```", guide, re.DOTALL)
    assert len(blocks) == 2
    exec(compile(blocks[number], "guide", "exec"), {})
    printed = capsys.readouterr().out
    assert ("3.5778 107.15 Hz" if number == 0 else "inner_race 5.42") in printed
