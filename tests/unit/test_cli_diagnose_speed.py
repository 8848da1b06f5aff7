"""`rolamento diagnose` with a speed that changes: from a channel, from pulses, or found."""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import cache
from math import pi
from pathlib import Path
from typing import Any, NamedTuple

import h5py
import numpy as np
import pytest
from typer.testing import CliRunner

from rolamento import Bearing
from rolamento.cli.requested import program_of
from rolamento.tasks import shaft_speed, signals
from rolamento.vibration.frequencies import nominal_frequencies
from rolamento.vibration.synthesis import Fault, Noise, Recipe, SwingingSpeed, synthesise

app = program_of("vibration_diagnosis:VibrationDiagnosis", "diagnose")

Run = Callable[..., tuple[int, str, str]]
RATE = 12_000.0
MEAN = 1797.0 * pi / 30.0
RPM = 30.0 / pi


class Machine(NamedTuple):
    """Vibration of a damaged outer race, speed (rad/s) and pulses, one and two a revolution."""

    samples: np.ndarray
    speed: np.ndarray
    angle: np.ndarray

    def pulses(self, count: int = 1) -> np.ndarray:
        return 5.0 * (np.mod(count * self.angle, 1.0) < 0.2)


@cache
def machine(duration: float = 12.0) -> Machine:
    recipe = Recipe(
        frequencies=nominal_frequencies(Bearing.named("6205"), MEAN),
        faults=(Fault(kind="outer_race"),), noise=Noise(ratio=0.0), duration=duration, rate=RATE,
        speed=SwingingSpeed(MEAN, depth=0.06, frequency=0.15), shaft_harmonics=(2.0, 1.0, 1.0),
    )  # fmt: skip
    signal = synthesise(recipe).signal
    assert signal.speed is not None
    return Machine(signal.samples, signal.speed, np.cumsum(signal.speed) / RATE / (2.0 * pi))


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    monkeypatch.chdir(tmp_path)
    own = machine()
    np.savez(
        "swing.npz", acc=own.samples, n=own.speed * RPM, key=own.pulses(), two=own.pulses(2),
        turning=own.speed * np.sign(np.linspace(-1.0, 1.0, len(own.speed))), fs=RATE,
    )  # fmt: skip

    def runner(*arguments: str) -> tuple[int, str, str]:
        result = CliRunner().invoke(app, arguments, env={"LC_ALL": "C.UTF-8"})
        if result.exception and not isinstance(result.exception, SystemExit):
            raise result.exception
        return result.exit_code, result.stdout, result.stderr

    return runner


GIVEN = ("swing.npz", "--channel", "acc", "--bearing", "6205")
CHANNEL = (*GIVEN, "--speed-channel", "n", "--speed-unit", "rpm")
TACHO = (*GIVEN, "--tacho", "key")
TRACK = (*GIVEN, "--track", "--speed", "1780 rpm")


def found(run: Run, *arguments: str) -> dict[str, Any]:
    code, out, err = run(*arguments, "--json")
    assert (code, err) == (0, "")
    data: dict[str, Any] = json.loads(out)
    return data


class TestOrderTracking:
    @pytest.mark.parametrize("way", [CHANNEL, TACHO, (*GIVEN, "--tacho", "two", "--pulses", "2"),
                                     TRACK])  # fmt: skip
    def test_fault_is_found_where_it_is(self, run: Run, way: tuple[str, ...]) -> None:
        data = found(run, *way)
        assert data["faults"] == ["outer_race"]
        assert abs(data["components"][0]["deviation"]) < 3e-3
        speed, true = data["speed"], machine().speed
        assert speed["mean"] == pytest.approx(true.mean(), rel=1e-3)
        assert speed["minimum"] == pytest.approx(true.min(), rel=0.01)
        assert speed["maximum"] == pytest.approx(true.max(), rel=0.01)

    def test_it_is_clearer_than_at_a_steady_speed(self, run: Run) -> None:
        steady = found(run, *GIVEN, "--speed", "1797 rpm")["components"][0]["evidence"]
        tracked = found(run, *CHANNEL)["components"][0]["evidence"]
        assert tracked > 3.0 * steady + 10.0

    def test_sources_are_told(self, run: Run) -> None:
        assert found(run, *CHANNEL)["speed"]["source"] == "channel"
        tacho = found(run, *TACHO)["speed"]
        assert (tacho["source"], tacho["channel"]) == ("pulses", "key")
        assert tacho["pulses_per_revolution"] == 1
        track = found(run, *TRACK, "--within", "0.08")["speed"]
        assert track["source"] == "vibration"
        assert (track["tracking"]["found"], track["tracking"]["within"]) == (True, 0.08)
        assert track["tracking"]["evidence"] > 2.0
        text = " ".join(run(*CHANNEL, "--lang", "en")[1].split())
        assert "rpm from the channel n signal" in text
        assert "found in the vibration within 10 % of 1780 rpm" in " ".join(
            run(*TRACK, "--lang", "en")[1].split()
        )

    def test_frequencies_are_at_the_mean_speed(self, run: Run) -> None:
        data = found(run, *CHANNEL)
        shaft = machine().speed.mean() / (2.0 * pi)
        assert data["frequencies"]["shaft_frequency"] == pytest.approx(shaft, rel=1e-9)
        assert data["shaft_frequency"] == pytest.approx(shaft, rel=5e-3)

    def test_speed_of_an_outer_ring_that_turns_alone(self, run: Run) -> None:
        alone = found(run, *CHANNEL, "--set", "duty.outer_speed=1 rpm")
        assert alone["frequencies"]["shaft"] == "outer"
        assert alone["frequencies"]["outer_speed"] == pytest.approx(machine().speed.mean())

    def test_part_of_a_record(self, run: Run) -> None:
        part = ("--start", "4 s", "--duration", "6 s")
        true = machine().speed[48_000:120_000]
        for way in (CHANNEL, TACHO, TRACK):
            data = found(run, *way, *part)
            assert data["faults"] == ["outer_race"]
            assert data["speed"]["mean"] == pytest.approx(true.mean(), rel=3e-3)

    @pytest.mark.parametrize("way", [CHANNEL, TACHO, TRACK])
    def test_long_records_are_read_in_pieces(
        self, run: Run, way: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
    ) -> None:
        whole = found(run, *way)
        monkeypatch.setattr(signals, "PIECE", 9_000)
        pieces = found(run, *way)
        assert pieces["faults"] == ["outer_race"]
        assert pieces["signal"]["indicators_of_first"] == pytest.approx(9_000 / RATE)
        assert pieces["speed"]["mean"] == pytest.approx(whole["speed"]["mean"], rel=1e-12)
        order = whole["components"][0]["order"]
        assert pieces["components"][0]["order"] == pytest.approx(order, rel=2e-3)


class TestTachoOfAnotherRate:
    def test_pulses_are_sampled_slower(self, run: Run) -> None:
        own = machine()
        with h5py.File("two.h5", "w") as file:
            for name, samples, rate in (
                ("acc", own.samples, RATE),
                ("key", own.pulses()[::4], RATE / 4.0),
            ):
                file.create_dataset(name, data=samples).attrs["fs"] = rate
        given = ("two.h5", "--channel", "acc", "--bearing", "6205", "--tacho", "key")
        data = found(run, *given, "--start", "1 s")
        assert data["faults"] == ["outer_race"]
        assert abs(data["components"][0]["deviation"]) < 3e-3
        assert data["speed"]["mean"] == pytest.approx(own.speed[12_000:].mean(), rel=1e-3)

    @pytest.mark.parametrize(
        ("pulses", "told"),
        [
            (1, "ends at 6 s, before the analysed signal, at 12 s"),
            (None, "since the file gives no rates, they must be equal"),
        ],
    )
    def test_pulses_that_end_before(self, run: Run, pulses: int | None, told: str) -> None:
        own = machine()
        with h5py.File("short.h5", "w") as file:
            file["acc"], file["key"] = own.samples, own.pulses()[:72_000]
            if pulses:
                file["acc"].attrs["fs"] = file["key"].attrs["fs"] = RATE
        given = ("short.h5", "--channel", "acc", "--bearing", "6205", "--tacho", "key")
        code, out, err = run(*given, *(() if pulses else ("--rate", "12 kHz")))
        assert (code, out) == (2, "")
        assert told in err


class TestFindingTheSpeed:
    """The speed found in the vibration, against the one that the signal was made with."""

    @staticmethod
    def along(
        monkeypatch: pytest.MonkeyPatch, stretch: float, samples: int = 2**23
    ) -> tuple[np.ndarray, np.ndarray, int]:
        """Found and true speed at every sample, and how many stretches there were."""
        from rolamento.vibration.reading import open_signal

        monkeypatch.setattr(shaft_speed, "_STRETCH", stretch)
        monkeypatch.setattr(shaft_speed, "MOST_STRETCH_SAMPLES", samples)
        done = []
        with open_signal("swing.npz", channel="acc") as source:
            count = source.length
            along, tracking = shaft_speed.found_in_vibration(
                source, range(0, count, count), MEAN, 0.1, lambda *told: done.append(told)
            )
        assert along is not None
        assert tracking.found
        return along.at(0, count), machine().speed, len(done)

    def test_in_one_stretch_or_in_several(self, run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
        for stretch, expected in ((1600.0, 1), (120.0, 3)):
            speed, true, stretches = self.along(monkeypatch, stretch)
            off = speed / true - 1.0
            assert stretches == expected
            assert np.sqrt(np.mean(off**2)) < 5e-3
            # the angle of the shaft is right to a part of a turn where the speed was found
            inside = slice(12_000, -12_000)
            lost = np.cumsum((speed - true)[inside]) / RATE / (2.0 * pi)
            assert np.ptp(lost) < 0.5

    def test_memory_limits_the_stretches(self, run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
        _, _, stretches = self.along(monkeypatch, 1600.0, samples=110_000)
        assert stretches > 1

    def test_backwards(self, run: Run) -> None:
        data = found(run, *GIVEN, "--track", "--speed", "-1780 rpm")
        assert data["faults"] == ["outer_race"]
        assert data["speed"]["mean"] == pytest.approx(-machine().speed.mean(), rel=1e-3)

    def test_noise_has_no_speed(self, run: Run) -> None:
        np.save("noise.npy", np.random.default_rng(3).normal(size=144_000))
        given = ("noise.npy", "--rate", "12 kHz", "--bearing", "6205", "--lang", "en")
        code, out, err = run(*given, "--track", "--speed", "1797 rpm")
        assert (code, err) == (1, "")
        assert out.startswith("No verdict: the speed was not found in the vibration")
        assert "From 0 to 12 s the shaft does not stand out" in " ".join(out.split())
        code, out, err = run(*given, "--track", "--speed", "1797 rpm", "--json")
        data = json.loads(out)
        assert code == 1
        assert data["verdict"] == "no_verdict"
        assert data["speed"]["source"] == "given"
        assert data["speed"]["tracking"]["lost"] == [0.0, 12.0]
        assert err.startswith("rolamento: No verdict: the speed was not found")

    def test_a_path_that_is_not_the_shaft_s(self, run: Run) -> None:
        """A shaft that swings faster than is followed: said, and nothing made of the wrong path."""
        recipe = Recipe(
            frequencies=nominal_frequencies(Bearing.named("6205"), MEAN),
            faults=(Fault(kind="outer_race"),), noise=Noise(ratio=0.0), duration=12.0, rate=RATE,
            speed=SwingingSpeed(MEAN, depth=0.1, frequency=4.0), shaft_harmonics=(2.0, 1.0, 1.0),
        )  # fmt: skip
        np.save("wild.npy", synthesise(recipe).signal.samples)
        given = ("wild.npy", "--rate", "12 kHz", "--bearing", "6205", "--lang", "en")
        code, out, _ = run(*given, "--track", "--speed", "1780 rpm")
        assert code == 1
        assert out.startswith("No verdict: ")
        assert "does not follow the shaft" in " ".join(out.split())
        code, out, _ = run(*given, "--track", "--speed", "1780 rpm", "--json")
        data = json.loads(out)
        assert (code, data["speed"]["tracking"]["found"]) == (1, False)
        assert data["speed"]["minimum"] == data["speed"]["maximum"] == data["speed"]["mean"]
        assert "path_lost" in [note["key"] for note in data["notes"]]

    def test_a_fault_is_one_without_it(self, run: Run) -> None:
        recipe = Recipe(
            frequencies=nominal_frequencies(Bearing.named("6205"), MEAN),
            faults=(Fault(kind="outer_race"),), noise=Noise(ratio=2.0), duration=10.0, rate=RATE,
        )  # fmt: skip
        np.save("steady.npy", synthesise(recipe).signal.samples)
        given = ("steady.npy", "--rate", "12 kHz", "--bearing", "6205")
        data = found(run, *given, "--track", "--speed", "1797 rpm")
        assert data["faults"] == ["outer_race"]
        assert "speed_not_found" in [note["key"] for note in data["notes"]]


class TestWrongInput:
    @pytest.mark.parametrize(
        ("arguments", "told"),
        [
            ((*GIVEN, "--speed-channel", "n"), '--speed-unit: is needed for the speed "n"'),
            ((*GIVEN, "--speed-channel", "n", "--speed-unit", "knots"), "one of rpm, rad/s, deg/s"),
            ((*GIVEN, "--speed-channel", "x", "--speed-unit", "rpm"), "1 acc, 2 n, 3 key"),
            ((*GIVEN, "--speed-channel", "acc", "--speed-unit", "rpm"), "channel of the samples"),
            (
                (*GIVEN, "--speed-channel", "turning", "--speed-unit", "rad/s"),
                "must keep its direction and stay clear of zero; cut the",
            ),
            ((*GIVEN, "--speed", "1797 rpm", "--speed-unit", "rpm"), "needs --speed-channel"),
            ((*GIVEN, "--speed", "1797 rpm", "--pulses", "2"), "needs --tacho"),
            ((*GIVEN, "--speed", "1797 rpm", "--within", "0.1"), "needs --track"),
            ((*CHANNEL, "--tacho", "key"), "gives the speed in another way than --speed-channel"),
            ((*TACHO, "--track"), "gives the speed in another way than --tacho"),
            ((*TACHO, "--speed", "1797 rpm"), '--speed: "1797 rpm": is a steady speed'),
            ((*CHANNEL, "--outer-speed", "9 rpm"), '--outer-speed: "9 rpm": is a steady speed'),
            (
                (*CHANNEL, "--set", "duty.inner_speed=9 rpm", "--set", "duty.outer_speed=9 rpm"),
                "--outer-speed '0 rpm'",
            ),
            ((*TRACK, "--outer-speed", "9 rpm"), "--track: is the speed of one ring"),
            ((*GIVEN, "--tacho", "acc"), "--channel 1 --tacho 2"),
            ((*GIVEN, "--tacho", "none"), "--tacho"),
            ((*GIVEN, "--tacho", "n"), "--tacho 2 --pulses 1"),
            ((*TACHO, "--pulses", "0"), "integer from 1"),
            ((*TACHO, "--duration", "0.1 s"), "number of pulses: must be at least 4, here "),
            ((*GIVEN, "--track"), "--speed: is missing"),
            (
                (*TRACK, "--within", "0.5"),
                "--within: 0.5: must be a fraction above 0 and at most 0.3",
            ),
            ((*TRACK, "--duration", "1 s"), "at least 96 shaft revolutions at the nominal speed"),
            ((*GIVEN, "--track", "--speed", "60000 rpm"), "--track: rate"),
        ],
    )
    def test_one_line_and_two(self, run: Run, arguments: tuple[str, ...], told: str) -> None:
        code, out, err = run(*arguments)
        assert (code, out) == (2, "")
        assert told in err
        assert err.count("\n") == 1

    def test_long_pulses_are_refused(self, run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(shaft_speed, "MOST_TACHO_SAMPLES", 100_000)
        code, _, err = run(*TACHO)
        assert code == 2
        assert "up to 100 000 samples, 8.33333 s; this record has 144 000" in err
        example = err.partition("example: ")[2].partition(")")[0].replace("'", "")
        option, duration = example.split(" ", 1)
        assert run(*TACHO, option, duration)[0] == 0

    def test_slow_shafts_at_high_rates_are_refused(
        self, run: Run, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(shaft_speed, "MOST_STRETCH_SAMPLES", 50_000)
        code, _, err = run(*TRACK)
        assert code == 2
        assert "--track: holds 50 000 samples in memory at once, and 192 revolutions are" in err
