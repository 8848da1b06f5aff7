"""Tasks on signals from Python: what they take, what they return, what they refuse."""

from __future__ import annotations

import pickle
from math import pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from rolamento import Bearing, Case, Duty, FileError, InputError, Load, tasks
from rolamento.errors import arguments, phrase
from rolamento.tasks.parameters import speed_of
from rolamento.vibration import DiagnosisSettings, Fault, Noise, Waviness

SPEED = 1797.0 * pi / 30.0


@pytest.fixture(scope="module")
def signal(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("signals") / "outer.npz"
    made = tasks.synthesise(
        "6205", path, speed="1797 rpm", faults=[Fault(kind="outer_race")], load="radial",
        noise=Noise(ratio=-3.0, of="faults"), duration=4.0, rate=12_000.0, seed=2,
    )  # fmt: skip
    assert made.status == "made"
    return path


@pytest.mark.parametrize(
    "bearing", ["6205", Bearing.named("6205"), Case(bearing=Bearing.named("6205"), duty=Duty())],
    ids=["designation", "bearing", "case"],
)  # fmt: skip
def test_a_file_is_diagnosed_in_one_call(signal: Path, bearing: Any) -> None:
    told: list[tuple[int, int]] = []
    found = tasks.diagnose(signal, bearing, progress=lambda *done: told.append(done))
    assert isinstance(found, tasks.DiagnosisResult)
    assert found.verdict == "fault"
    assert found.diagnosis.faults == ("outer_race",)
    assert found.speed is not None
    assert found.speed.source == "file"
    assert found.speed.mean == pytest.approx(SPEED)
    assert told[-1] == (1, 1)


def test_speeds_are_text_or_radians_per_second(signal: Path) -> None:
    assert speed_of("30 rpm", "speed") == pytest.approx(pi)
    assert speed_of(2.5, "speed") == 2.5
    assert speed_of(None, "speed") is None
    as_text = tasks.fault_frequencies("6205", speed="1797 rpm")
    as_number = tasks.fault_frequencies("6205", speed=SPEED)
    assert as_text.nominal.ball_pass_outer.frequency == pytest.approx(
        as_number.nominal.ball_pass_outer.frequency
    )
    assert tasks.fault_frequencies("6205").nominal.shaft_frequency != 0.0
    with pytest.raises(InputError) as refused:
        tasks.diagnose(signal, "6205", speed="fast")
    assert (refused.value.field, refused.value.example) == ("speed", 'speed="1797 rpm"')


def test_frequencies_of_a_loaded_case() -> None:
    case = Case(bearing=Bearing.named("6205"), duty=Duty(inner_speed=SPEED, load=Load(fx="2 kN")))
    found = tasks.fault_frequencies(case, slip=0.01)
    assert found.loaded is not None
    assert found.loaded.cage.order > found.nominal.cage.order
    assert found.solved is not None
    assert found.solved.converged.all()
    with pytest.raises(InputError, match="must be from 1 to 100"):
        tasks.fault_frequencies(case, harmonics=0)


REFUSED: list[tuple[dict[str, Any], str, str]] = [
    ({"speed_unit": "rpm"}, "speed_unit", "needs speed_channel=…"),
    ({"track": True, "tacho": 2}, "track", "gives the speed in another way than tacho=…"),
    ({"speed_channel": "n", "speed": 10.0}, "speed", "is a steady speed, but speed_channel=…"),
    ({"angle": "wide"}, "angle", "number"),
    ({"outer_speed": SPEED, "speed": SPEED}, "outer_speed", "nothing rolls"),
    ({"start": 9.0}, "start", "must be before the end of the signal, 4 s"),
    ({"start": -1.0}, "start", "must be at least 0"),
    ({"duration": 9.0}, "duration", "which lasts 4 s"),
    ({"channel": "z"}, "channel", "no channel"),
]


@pytest.mark.parametrize(
    ("given", "field", "rule"), REFUSED, ids=[field for _, field, _ in REFUSED]
)
def test_errors_name_the_parameter(
    signal: Path, given: dict[str, Any], field: str, rule: str
) -> None:
    with pytest.raises(InputError) as refused:
        tasks.diagnose(signal, "6205", **given)
    assert refused.value.field == field
    if field not in ("angle", "channel"):
        assert rule in refused.value.rule
    assert "--" not in str(refused.value)


def test_a_record_that_is_too_short_is_no_verdict(signal: Path) -> None:
    found = tasks.diagnose(signal, "6205", duration=0.05)
    assert (found.verdict, found.status) == ("no_verdict", "record_too_short")
    assert found.too_short is not None
    assert found.too_short.revolutions == pytest.approx(0.05 * 29.95, rel=1e-3)
    assert found.too_short.required_revolutions > found.too_short.revolutions
    with pytest.raises(InputError, match=r"has no diagnosis: .* the record is too short"):
        _ = found.diagnosis


def test_the_search_is_a_record(signal: Path) -> None:
    found = tasks.diagnose(signal, "6205", search=DiagnosisSettings(false_alarm=0.001))
    assert isinstance(found, tasks.DiagnosisResult)
    assert found.settings.false_alarm == 0.001


def test_anderons_of_files(tmp_path: Path) -> None:
    samples = 1e-5 * np.random.default_rng(1).normal(size=120_000)
    paths = []
    for hours, factor in ((60, 1.0), (120, 2.0)):
        paths.append(tmp_path / f"t{hours}.npz")
        np.savez(paths[-1], velocity=factor * samples, fs=24_000.0)
    one = tasks.NoiseLevel(signals=paths[0], unit="m/s").run()
    assert one.verdicts == ("none",)
    both = tasks.NoiseLevel(
        signals=paths,
        unit="m/s",
        hours=[60, 120],
        full_scale={"low": 1e6, "high": tasks.FullScale(0.1, True)},
    ).run()
    assert both.verdicts == ("accepted", "accepted")
    assert both.trend is not None
    assert both.trend.of("low").ratio == pytest.approx(2.0)
    for wrong in ({"hours": [1.0]}, {"accepted": 2.0}, {"speed": 0.0}, {"bearing": "a\nb"}):
        with pytest.raises(InputError) as refused:
            tasks.NoiseLevel(signals=paths, unit="m/s", **wrong).run()
        assert refused.value.field == next(iter(wrong))
    with pytest.raises(InputError, match="1 to 500 files"):
        tasks.NoiseLevel(signals=[]).run()
    with pytest.raises(InputError, match='unit="um/s"'):
        tasks.NoiseLevel(signals=paths[0]).run()


def test_a_case_without_solution_makes_no_signal() -> None:
    overloaded = Case(
        bearing=Bearing.named("6205"), duty=Duty(inner_speed=SPEED, load=Load(fz="1 GN"))
    )
    found = tasks.synthesise(overloaded, faults=[Fault(kind="ball")])
    assert found.status == "overloaded"
    with pytest.raises(InputError, match="has no signal"):
        _ = found.made


def test_what_is_made_has_to_be_something(tmp_path: Path) -> None:
    for given, field in (
        ({}, "signal"),
        ({"faults": [Fault(kind="ball")] * 21}, "faults"),
        ({"faults": [Fault(kind="ball")], "duration": 1e6}, "duration"),
        ({"faults": [Fault(kind="ball")], "load": "solved"}, "load"),
        ({"faults": [Fault(kind="ball")], "load": "side"}, "load"),
        ({"waviness": [Waviness.falling("outer", 1e-7)], "duration": -1.0}, "duration"),
    ):
        with pytest.raises(InputError) as refused:
            tasks.synthesise("6205", tmp_path / "a.npz", speed=SPEED, **given)
        assert refused.value.field == field
    with pytest.raises(FileError, match="must end in"):
        tasks.synthesise("6205", "a.mp3", speed=SPEED, faults=[Fault(kind="ball")])
    assert not list(tmp_path.iterdir())


def test_names_of_parameters_are_those_of_options() -> None:
    names = {"speed_unit": "--speed-unit", "pulses": "--pulses", "rate": "--rate"}
    rule = phrase(
        "needs {unit} or {rate}; its rate = 25 may be it, and x.rate=3 not",
        unit=arguments(speed_unit="Hz"),
        rate=arguments(rate=2e3),
    )
    error = InputError(rule, field="pulses", example=arguments(speed_unit="Hz", pulses=1))
    assert str(error) == (
        'pulses: needs speed_unit="Hz" or rate=2000.0; its rate = 25 may be it, and x.rate=3 not'
        ' (example: speed_unit="Hz", pulses=1)'
    )
    told = error.spelled(names, lambda name, value: f"{name} {value}", between=" ")
    assert told.rule == (
        'needs --speed-unit "Hz" or --rate 2000.0; its rate = 25 may be it, and x.rate=3 not'
    )
    assert (told.field, told.example) == ("--pulses", '--speed-unit "Hz" --pulses 1')
    nested = InputError("is too low", source="pulses", field="rate")
    assert (nested.spelled(names).source, nested.spelled(names).field) == ("--pulses", "rate")


def test_what_names_arguments_outlives_a_process() -> None:
    error = InputError("is missing", field="unit", example=arguments(unit="g", scale=...))
    again = pickle.loads(pickle.dumps(error.with_details(source="a.csv")))
    assert again.example == 'unit="g", scale=…'
    assert again.spelled({"unit": "--unit"}).example == '--unit="g", scale=…'


def test_names_of_the_package() -> None:
    for name in tasks.__all__:
        assert getattr(tasks, name) is not None
        assert name in dir(tasks)
    with pytest.raises(AttributeError):
        tasks.guess  # noqa: B018
