"""A machine's history, its bearings together, and a bearing that nobody knows."""

from __future__ import annotations

from math import pi
from pathlib import Path

import numpy as np
import pytest

import rolamento as ro
from rolamento import Bearing, tasks
from rolamento.document.terminal import terminal
from rolamento.errors import FileError, InputError
from rolamento.pages.history import history_page, machine_page, records_page, unknown_page
from rolamento.tasks.diagnosis import DiagnosisResult, UnknownResult
from rolamento.tasks.history import History, Records, change_points, records_of
from rolamento.tasks.machine_diagnosis import MachineDiagnosis, read_machine
from rolamento.vibration import write_signal
from rolamento.vibration.frequencies import nominal_frequencies
from rolamento.vibration.signal import Signal
from rolamento.vibration.synthesis import Fault, Noise, Recipe, synthesise

SPEED = 188.2
RATE = 12_000.0
RPM = f"{SPEED * 30.0 / pi} rpm"


def outer_race_of(
    designation: str, ratio: float, *, seed: int = 1, duration: float = 5.0, at: float = SPEED
) -> Signal:
    """A bearing with a damaged outer race, so many dB above or below noise, beside its shaft."""
    sought = nominal_frequencies(Bearing.named(designation), at)
    recipe = Recipe(
        frequencies=sought,
        duration=duration,
        rate=RATE,
        faults=(Fault(kind="outer_race"),),
        shaft_harmonics=(1.0, 0.5),
        noise=Noise(ratio=ratio),
        seed=seed,
    )
    made = synthesise(recipe).signal
    return Signal(made.samples / np.std(made.samples), RATE, speed=SPEED)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Records of a machine: modulated a little at first, then twice and more."""
    path = tmp_path_factory.mktemp("records")
    for number, ratio in enumerate((-16.0, -16.5, -4.0), start=1):
        write_signal(outer_race_of("6205", ratio, seed=number), path / f"day_{number}.npz")
    return path


def of_record(name: Path, *good: Path) -> History:
    found = tasks.diagnose_since(name, "6205", list(good), speed=RPM)
    assert isinstance(found, History)
    return found


def test_a_depth_that_doubled_is_damage(folder: Path) -> None:
    days = [folder / f"day_{number}.npz" for number in (1, 2, 3)]
    found = of_record(days[2], *days[:2])
    assert found.verdict == "fault"
    (grown,) = found.grown
    assert grown.component == "outer_race"
    assert grown.now >= 2.0 * grown.usual
    assert len(grown.then) == len(found.compared) == 2
    assert found.statement[0].key == "depth_grown"
    page = history_page(found)
    assert page.sections[0].key == "verdict"


def test_a_depth_that_was_always_there_is_none(folder: Path) -> None:
    """The record alone is called damaged; beside another as deep it is as always."""
    last = folder / "day_3.npz"
    alone = tasks.diagnose(last, "6205", speed=RPM)
    assert isinstance(alone, DiagnosisResult)
    assert alone.diagnosis.stated[0].component == "outer_race"
    found = of_record(last, last)
    assert found.verdict != "fault"
    assert [part.component for part in found.always] == ["outer_race"]
    assert found.statement[0].key == "depth_as_always"


def test_only_like_speeds_are_compared(folder: Path, tmp_path: Path) -> None:
    slow = outer_race_of("6205", -4.0, at=0.7 * SPEED)
    write_signal(Signal(slow.samples, RATE, speed=0.7 * SPEED), tmp_path / "slow.npz")
    found = tasks.diagnose_since(folder / "day_3.npz", "6205", [tmp_path])
    assert isinstance(found, History)
    assert found.compared == ()
    assert {part.change for part in found.parts} == {"unknown"}
    assert "no_like_speed" in {note.key for note in found.statement}


def test_records_come_in_the_order_of_their_names(tmp_path: Path) -> None:
    for name in ("b10.wav", "b2.wav", "a.txt", "notes.md"):
        (tmp_path / name).write_bytes(b"")
    assert [path.name for path in records_of([tmp_path])] == ["a.txt", "b2.wav", "b10.wav"]
    (tmp_path / "empty").mkdir()
    with pytest.raises(InputError):
        records_of([tmp_path / "empty"])


def test_a_step_is_found_where_it_is() -> None:
    """By ranks: neither its size nor a few outliers matter; noise has none."""
    random = np.random.default_rng(4)
    values = random.normal(size=60)
    assert change_points(values) == ()
    values[40:] += 3.0
    values[10] = np.nan
    values[20] = 1e6
    (step,) = change_points(values)
    assert abs(step.place - 40) <= 1
    assert step.after - step.before == pytest.approx(3.0, abs=0.6)
    assert step.probability < 1e-3
    assert change_points(values[:8]) == ()


def test_many_short_records_are_one(tmp_path: Path) -> None:
    """Of 0.4 s each, twelve revolutions: the spectra of nine are averaged."""
    for number in range(144):
        damaged = number >= 72
        some = outer_race_of("6205", 6.0 if damaged else -30.0, seed=number, duration=0.4)
        np.save(tmp_path / f"r{number}.npy", some.samples)
    found = tasks.trend_of_records([tmp_path], "6205", speed=RPM, rate=RATE)
    assert isinstance(found, Records)
    assert found.counts == (9,) * 16
    depths = found.depths["outer_race"]
    assert np.median(depths[-5:]) > 2.0 * np.median(depths[:5])
    (step,) = found.steps["kurtosis"]
    assert found.names[step.place] == "r72.npy"
    assert found.statement[0].key == "series_changed"
    assert records_page(found, "records").main == "records"


def test_records_of_three_revolutions_have_no_depths(tmp_path: Path) -> None:
    """Multiples of the shaft hide both races in them: not told as a depth of 0."""
    for number in range(68):
        some = outer_race_of("6205", 6.0, seed=number, duration=0.1)
        np.save(tmp_path / f"r{number}.npy", some.samples)
    found = tasks.trend_of_records([tmp_path], "6205", speed=RPM, rate=RATE)
    assert found.counts == (34, 34)
    assert np.all(np.isnan(list(found.depths.values())))
    assert np.all(found.kurtosis > 4.0)
    assert "nan" not in terminal(records_page(found, "records"))


MACHINE = """
[[bearings]]
name = "motor"
designation = "6205"
[[bearings]]
name = "fan"
designation = "6203"
[[shafts]]
name = "slow"
ratio = 0.5
[[gears]]
teeth = 31
[[gears]]
teeth = 20
shaft = "slow"
"""


def test_the_bearings_of_a_machine_are_tested_together(tmp_path: Path) -> None:
    """The damaged one is named, and its peak is no doubt of the other."""
    file, record = tmp_path / "machine.toml", tmp_path / "now.npz"
    file.write_text(MACHINE, encoding="utf-8")
    write_signal(outer_race_of("6203", 3.0), record)
    machine = read_machine(file)
    assert machine.meshes == (31.0, 10.0)
    assert set(machine.turning(0.5)) == {2.0, 62.0, 20.0}
    found = tasks.diagnose_machine(record, machine, speed=RPM)
    assert isinstance(found, MachineDiagnosis)
    assert found.alone(0) == ()
    assert found.alone(1) == ("outer_race",)
    assert found.verdict == "fault"
    assert found.found[0].diagnosis.impacts is None
    lone = tasks.diagnose(record, "6205", speed=RPM)
    assert isinstance(lone, DiagnosisResult)
    assert lone.verdict == "undecided"
    assert machine_page(found).sections


def test_a_peak_of_two_bearings_decides_between_neither(tmp_path: Path) -> None:
    file, record = tmp_path / "machine.toml", tmp_path / "now.npz"
    file.write_text('[[bearings]]\ndesignation = "6205"\n' * 2, encoding="utf-8")
    write_signal(outer_race_of("6205", 3.0), record)
    found = tasks.diagnose_machine(record, file, speed=RPM)
    assert isinstance(found, MachineDiagnosis)
    assert len(found.shared) == 1
    assert found.verdict == "undecided"
    assert [note.key for note in found.statement] == ["peak_of_either"]


@pytest.mark.parametrize(
    ("text", "field"),
    [
        ("# nothing", "bearings"),
        ('[[bearing]]\ndesignation = "6205"', "bearing"),
        ('[[bearings]]\ndesignation = "6205"\nspeed = 3', "bearings.speed"),
        ('[[bearings]]\ndesignation = "6205"\nshaft = "x"', "shaft"),
        ('[[bearings]]\ndesignation = "6205"\n[[gears]]\nteeth = 0', "teeth"),
        ('[[bearings]]\ndesignation = "6205"\n[[shafts]]\nname = "a"\nratio = true', "ratio"),
        ("bearings = 3", "bearings"),
        ('[[bearings]]\ndesignation = "6205"\nshaft = {a = 1}', "shaft"),
        ('[[bearings]]\ndesignation = "6205"\nname = 3', "name"),
        ('[[bearings]]\ndesignation = "6205"\n[[shafts]]\nname = "main"\nratio = 2', "name"),
        (f'[[bearings]]\ndesignation = "6205"\n[[shafts]]\nname = "{"a" * 100_000}"', "name"),
    ],
)
def test_a_wrong_machine_is_refused(text: str, field: str, tmp_path: Path) -> None:
    path = tmp_path / "machine.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InputError) as raised:
        read_machine(path)
    assert raised.value.field == field
    for content in (b"[[bearings\n", b"\xff\xfe", b"bearings = " + b"[" * 2000):
        path.write_bytes(content)
        with pytest.raises(FileError):
            read_machine(path)
    with pytest.raises(FileError):
        read_machine(tmp_path / "none.toml")


def test_an_unknown_bearing_is_ranked() -> None:
    """The bearing itself is among those that explain the comb, with hardly any slip."""
    found = tasks.rank_bearings(outer_race_of("6205", 6.0))
    assert isinstance(found, UnknownResult)
    assert found.verdict == "undecided"
    own = next(fit for fit in found.found.fits if fit.designation == "6205")
    assert ("outer_race", 0) in {(part, number) for part, number, _ in own.parts}
    assert own.slip < 0.005
    assert own.share == pytest.approx(found.found.fits[0].share, abs=0.05)
    assert unknown_page(found).main == "bearings"
    noise = np.random.default_rng(0).normal(size=60_000)
    nothing = tasks.rank_bearings(noise, rate=RATE, speed=RPM)
    assert nothing.verdict == "nothing_found"
    assert nothing.statement[0].key == "no_combs"


def test_samples_in_memory_are_diagnosed() -> None:
    """As an array, or as a signal, steady or not: as a file of them is."""
    signal = outer_race_of("6205", 6.0)
    of_array = tasks.diagnose(signal.samples, "6205", rate=RATE, speed=RPM)
    of_signal = tasks.diagnose(signal, "6205")
    along = Signal(signal.samples, RATE, speed=np.full(len(signal.samples), SPEED))
    of_changing = tasks.diagnose(along, "6205")
    for found, source in ((of_array, "given"), (of_signal, "file"), (of_changing, "channel")):
        assert isinstance(found, DiagnosisResult)
        assert found.diagnosis.faults == ("outer_race",)
        assert found.speed is not None
        assert found.speed.source == source
    with pytest.raises(InputError, match="rate"):
        tasks.diagnose(signal.samples, "6205", speed=RPM)


EXAMPLES = Path(ro.__file__).parent / "examples" / "machines"


def test_a_machine_file_of_shafts_names_what_turns(tmp_path: Path) -> None:
    """Shafts, a bearing between two of them, and the speed come from the file."""
    coaxial = read_machine(EXAMPLES / "coaxial.toml")
    assert coaxial.speed == pytest.approx(30.0 * pi)
    assert coaxial.shafts == {"inner shaft": pytest.approx(-1.5)}
    between = coaxial.bearings[3]
    assert (between.ratio, between.outer_ratio) == (pytest.approx(-1.5), 1.0)
    own = nominal_frequencies(Bearing.named("6008"), -1.5, 1.0)
    assert between.orders()[0] == pytest.approx(1.5 * own.ball_pass_outer.order)
    assert between.orders()[0] > between.bearing.bearing.ball_count  # type: ignore[union-attr]
    gears = read_machine(EXAMPLES / "gear_shaft.toml")
    assert gears.meshes == (58.0,)
    still = (EXAMPLES / "three_supports.toml").read_text(encoding="utf-8")
    still = still.replace('"600 rpm"', '"0 rpm"')
    (tmp_path / "still.toml").write_text(still, encoding="utf-8")
    with pytest.raises(InputError, match="must turn"):
        read_machine(tmp_path / "still.toml")


def test_a_machine_file_of_shafts_is_diagnosed(tmp_path: Path) -> None:
    """The bearing between both shafts is named by its own frequency, at the file's speeds."""
    machine = read_machine(EXAMPLES / "coaxial.toml")
    assert machine.speed is not None
    speed = machine.speed
    sought = nominal_frequencies(Bearing.named("6008"), -1.5 * speed, speed)
    recipe = Recipe(
        frequencies=sought,
        duration=8.0,
        rate=RATE,
        faults=(Fault(kind="inner_race"),),
        noise=Noise(ratio=3.0),
        seed=3,
    )
    write_signal(Signal(synthesise(recipe).signal.samples, RATE), tmp_path / "now.npz")
    found = tasks.diagnose_machine(tmp_path / "now.npz", EXAMPLES / "coaxial.toml")
    assert isinstance(found, MachineDiagnosis)
    assert [found.alone(place) for place in range(4)] == [(), (), (), ("inner_race",)]
    assert found.verdict == "fault"
