"""Severity of vibration: velocity in the band, zones, alarms, and the command."""

import json
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from rolamento import tasks
from rolamento.cli.app import app
from rolamento.errors import InputError
from rolamento.vibration import (
    Signal,
    alarm_setting,
    classes_of,
    machine_classes,
    measure_severity,
)
from rolamento.vibration.severity import band_at

RATE, SPEED = 8192.0, 155.0
TIMES = np.arange(int(10 * RATE)) / RATE


def tone(frequency: float, velocity: float, quantity: str = "velocity") -> np.ndarray:
    """Samples of a vibration with an RMS velocity (m/s), in SI."""
    omega = 2.0 * np.pi * frequency
    power = {"displacement": -1, "velocity": 0, "acceleration": 1}[quantity]
    return np.sqrt(2.0) * velocity * omega**power * np.cos(omega * TIMES + 0.3)


UNITS = {"acceleration": "m/s^2", "velocity": "m/s", "displacement": "m"}


class TestVelocity:
    @pytest.mark.parametrize("quantity", UNITS)
    @pytest.mark.parametrize("frequency", [10.0, 10.3, 24.67, 160.0, 999.0, 1000.0])
    def test_tone_within_the_band_counts_whole(self, quantity: str, frequency: float) -> None:
        signal = Signal(tone(frequency, 3e-3, quantity), RATE, quantity, UNITS[quantity])  # type: ignore[arg-type]
        found = measure_severity(signal, speed=SPEED)
        assert found.velocity == pytest.approx(3e-3, rel=2e-3)
        assert found.lower <= found.velocity <= found.upper

    @pytest.mark.parametrize("frequency", [4.0, 7.0, 1030.0, 3000.0])
    def test_tone_outside_the_band_does_not_count(self, frequency: float) -> None:
        signal = Signal(tone(frequency, 3e-3, "acceleration"), RATE, "acceleration", "m/s^2")
        assert measure_severity(signal, speed=SPEED).velocity < 3e-6

    def test_displacement_of_a_tone(self) -> None:
        signal = Signal(tone(25.0, 3e-3), RATE, "velocity", "m/s")
        found = measure_severity(signal, speed=SPEED)
        assert found.displacement == pytest.approx(3e-3 / (50.0 * np.pi), rel=2e-3)

    def test_offset_and_drift_do_not_reach_the_band(self) -> None:
        """Integration in time would make metres per second of them."""
        samples = tone(25.0, 1e-3, "acceleration") + 9.81 + 0.5 * TIMES
        found = measure_severity(Signal(samples, RATE, "acceleration", "m/s^2"), speed=SPEED)
        assert found.velocity == pytest.approx(1e-3, rel=2e-3)

    def test_slow_machines_from_two_hertz(self) -> None:
        signal = Signal(tone(4.0, 3e-3), RATE, "velocity", "m/s")
        slow = measure_severity(signal, speed=599.0 * np.pi / 30.0)
        assert slow.band == (2.0, 1000.0)
        assert slow.velocity == pytest.approx(3e-3, rel=2e-3)
        assert band_at(600.0 * np.pi / 30.0) == band_at(float("nan")) == (10.0, 1000.0)

    def test_powers_of_parts_add(self) -> None:
        parts = [tone(25.0, 2e-3), tone(300.0, 1.5e-3)]
        found = measure_severity(Signal(sum(parts), RATE, "velocity", "m/s"), speed=SPEED)
        assert found.velocity == pytest.approx(2.5e-3, rel=2e-3)

    def test_interval_holds_as_often_as_it_says(self) -> None:
        random, held = np.random.default_rng(3), 0
        true = (2.0 * 990.0 / 4096.0) ** 0.5  # white noise of unit variance
        for _ in range(200):
            samples = random.standard_normal(4 * 4096)
            found = measure_severity(Signal(samples, 4096.0, "velocity", "m/s"), speed=SPEED)
            held += found.lower <= true <= found.upper
        assert held / 200 == pytest.approx(0.95, abs=0.05)

    def test_too_short_and_too_slow_are_told(self) -> None:
        with pytest.raises(InputError, match=r"at least 0\.75 s"):
            measure_severity(Signal(np.ones(4000), RATE, "velocity", "m/s"), speed=SPEED)
        coarse = Signal(np.sin(np.arange(8000)), 1000.0, "velocity", "m/s")
        found = measure_severity(coarse, speed=SPEED)
        assert not found.measured
        assert [note.key for note in found.notes] == ["severity_band_missing"]

    def test_speed_that_is_unknown_or_outside_is_noted(self) -> None:
        signal = Signal(tone(25.0, 1e-3), RATE, "velocity", "m/s")
        keys = [note.key for note in measure_severity(signal).notes]
        assert keys == ["severity_speed_unknown"]
        keys = [note.key for note in measure_severity(signal, speed=10.0).notes]
        assert keys == ["severity_speed_outside"]


class TestClasses:
    def test_boundaries_rise_and_have_sources(self) -> None:
        for one in machine_classes():
            assert sorted(one.velocity) == list(one.velocity)
            assert one.source and one.quoted  # noqa: PT018
            assert bool(one.displacement) == bool(one.displacement_source) == bool(one.group)

    def test_value_on_a_boundary_is_of_the_better_zone(self) -> None:
        (machine,) = classes_of(group=2, support="rigid")
        zones = [machine.zone_of(v * 1e-3) for v in (1.4, 1.41, 2.8, 4.5, 4.51)]
        assert zones == ["A", "B", "B", "C", "D"]

    def test_power_gives_the_group(self) -> None:
        groups = [{one.group for one in classes_of(power=1e3 * p)} for p in (15.1, 300, 301, 9e4)]
        assert groups == [{2}, {2}, {1}, {1}]
        assert [one.name for one in classes_of(power=15e3)] == ["class I"]
        assert len(classes_of()) == 4

    def test_contradictions_are_refused(self) -> None:
        with pytest.raises(InputError, match="above 300 kW"):
            classes_of(group=1, power=45e3)
        with pytest.raises(InputError, match="above 15 kW"):
            classes_of(group=2, power=4e3)
        with pytest.raises(InputError, match="cannot be combined"):
            classes_of(machine_class="II", power=45e3)
        for wrong in ({"group": 3}, {"support": "soft"}, {"machine_class": "V"}, {"power": -1.0}):
            with pytest.raises(InputError):
                classes_of(**wrong)  # type: ignore[arg-type]

    def test_alarm_over_the_baseline(self) -> None:
        (machine,) = classes_of(group=2, support="rigid")
        assert alarm_setting(machine, 1.1e-3).alarm == pytest.approx(1.8e-3)
        assert alarm_setting(machine, 3.2e-3).alarm == pytest.approx(3.5e-3)  # 1.25 of 2.8
        assert alarm_setting(machine).alarm == pytest.approx(2.8e-3)
        assert alarm_setting(machine).trip == pytest.approx(5.625e-3)


def run(*arguments: str) -> tuple[int, str]:
    result = CliRunner().invoke(app, ["severity", *arguments])
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    return result.exit_code, result.output


@pytest.fixture
def machine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for place, level in enumerate([1.0, 1.1, 1.3, 1.5, 1.8]):
        np.savez(f"m{place}.npz", velocity=1e3 * tone(24.67, 1e-3 * level), fs=RATE)


@pytest.mark.usefixtures("machine")
class TestCommand:
    def test_zone_and_class_are_stated(self) -> None:
        code, text = run("m4.npz", "--unit", "mm/s", "--speed", "1480 rpm", "--power", "45 kW",
                         "--support", "rigid")  # fmt: skip
        assert code == 0
        assert text.startswith("Zone B")
        assert "ISO 20816-3, group 2, rigid support" in " ".join(text.split())
        assert "rolamento diagnose" in " ".join(text.split())

    def test_unit_is_asked_for(self) -> None:
        code, text = run("m0.npz")
        assert code == 2
        assert "--unit" in text and "--scale" in text  # noqa: PT018

    def test_without_a_class_all_zones_are_given(self) -> None:
        code, text = run("m4.npz", "--unit", "mm/s", "--json")
        found = json.loads(text)
        assert code == 0
        assert found["zone"] is None
        assert set(found["signals"][0]["zones"].values()) == {"A", "B"}
        assert found["notes"][0]["key"] == "severity_not_bearings"

    def test_trend_and_its_record(self) -> None:
        files = [f"m{place}.npz" for place in range(5)]
        options = ("--unit", "mm/s", "--power", "60 cv", "--support", "rigid",
                   "--baseline", "1.0 mm/s", "--hours", "0,700,1400,2100,2800")  # fmt: skip
        code, text = run(*files, *options, "--limit", "4.5 mm/s", "--json",
                         "--record", "record.csv")  # fmt: skip
        assert code == 0
        found = json.loads(text)
        assert found["alarm"] == pytest.approx(1.7e-3)
        law = next(one for one in found["trend"]["laws"] if one["law"] == found["trend"]["law"])
        assert law["crossing"]["code"] == "reached"
        assert law["crossing"]["lower"] < law["crossing"]["time"] < law["crossing"]["upper"]
        again = (
            tasks.TrendEvaluation(data="record.csv", limits=["4.5 mm/s"]).run().limits[0].forecast
        )
        assert again.crossing.time == pytest.approx(law["crossing"]["time"], rel=1e-6)

    @pytest.mark.parametrize(
        ("options", "words"),
        [
            (("--power", "45"), "--power"),
            (("--group", "3"), "--group"),
            (("--class", "V"), "--class"),
            (("--limit", "4.5 mm/s"), "--limit"),
            (("--baseline", "-1 mm/s"), "--baseline"),
            (("--hours", "1,2"), "--hours"),
            (("--hours", "0", "--growth", "square"), "--growth"),
        ],
    )
    def test_wrong_options_are_named(self, options: tuple[str, ...], words: str) -> None:
        code, text = run("m0.npz", "--unit", "mm/s", *options)
        assert code == 2
        assert words in text
        assert "Traceback" not in text

    def test_pictures(self) -> None:
        code, _ = run("m0.npz", "m4.npz", "--unit", "mm/s", "--plot", "zones.png")
        assert code == 0
        files = [f"m{place}.npz" for place in range(5)]
        code, _ = run(*files, "--unit", "mm/s", "--group", "2", "--support", "rigid",
                      "--hours", "0,1,2,3,4", "--plot", "trend.svg")  # fmt: skip
        assert code == 0
        assert Path("zones.png").stat().st_size > 5000
        assert Path("trend.svg").stat().st_size > 5000


def test_the_worse_zone_leads(tmp_path: Path) -> None:
    """A slow machine that moves far: zone C by displacement, A by velocity."""
    from rolamento.pages.severity import severity_statement

    time = np.arange(20 * 5120) / 5120.0
    path = tmp_path / "slow.npz"
    velocity = 1.1107e-3 * np.sin(2 * np.pi * 2.5 * time)
    np.savez(path, velocity=velocity, fs=5120.0)
    found = tasks.VibrationSeverity(
        signals=path, speed="150 rpm", power="45 kW", support="rigid", unit="m/s"
    ).run()
    assert found.zone == "C"
    assert "zone A by velocity" in severity_statement(found)


def test_whole_numbers_have_no_zone_without_a_scale(tmp_path: Path) -> None:
    """Full scale of a recorder is nobody's g: what it is worth has to be said."""
    from scipy.io import wavfile

    samples = np.random.default_rng(2).normal(scale=4000.0, size=24_000).astype(np.int16)
    path = tmp_path / "recorder.wav"
    wavfile.write(path, 12_000, samples)
    given = (str(path), "--speed", "1797 rpm", "--power", "2 hp", "--support", "rigid")
    code, text = run(*given, "--unit", "g")
    assert code == 2
    assert "--scale" in text
    assert "Zone" not in text
    code, text = run(*given, "--scale", "10 g")
    assert code == 0
    assert text.startswith("Zone ")


@pytest.mark.usefixtures("machine")
def test_a_growth_that_reaches_the_limit_stands_with_the_zone() -> None:
    """The last reading is in zone B, and the trend leaves it within days."""
    files = [f"m{place}.npz" for place in range(5)]
    options = ("--unit", "mm/s", "--power", "60 cv", "--support", "rigid",
               "--hours", "0,700,1400,2100,2800", "--limit", "4.5 mm/s")  # fmt: skip
    code, text = run(*files, *options)
    assert code == 0
    head, _, rest = " ".join(text.split()).partition("Severity of vibration")
    assert head.startswith("Zone ")
    assert "The limit of 4.5 mm/s is reached in" in head
    assert "The limit of 4.5 mm/s" not in rest
