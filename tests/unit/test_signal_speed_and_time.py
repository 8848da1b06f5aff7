"""Speeds and times that a signal file has beside its samples, in every format."""

from __future__ import annotations

import tracemalloc
from collections.abc import Callable
from math import pi
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
import scipy.io
import scipy.io.wavfile

from rolamento.errors import FileError, InputError
from rolamento.vibration.reading import channels_of, open_signal, read_signal

RATE = 2000.0
COUNT = 1200
SAMPLES = np.random.default_rng(11).normal(size=COUNT)
TIMES = np.arange(COUNT) / RATE
RPM = 1500.0 + 200.0 * np.sin(2 * pi * 3 * TIMES)
SPEED = RPM * pi / 30


def write_csv(path: Path) -> None:
    rows = [f"{t:.6f};{r:.9f};{x:.9f}" for t, r, x in zip(TIMES, RPM, SAMPLES, strict=True)]
    path.write_text("time;speed (rpm);acc (g)\n" + "\n".join(rows) + "\n", "utf-8")


def write_hdf5(path: Path) -> None:
    with h5py.File(path, "w") as file:
        stored = {"chunks": (170,), "compression": "gzip"}
        file.create_dataset("run/acc", data=SAMPLES, **stored)
        file.create_dataset("run/shaft", data=RPM / 60, **stored).attrs["units"] = "Hz"
        file.create_dataset("run/time", data=TIMES, chunks=(400,))
        file["run/mean rpm"] = 1500.0


def write_parquet(path: Path) -> None:
    table = pa.table({"t": TIMES, "acc": SAMPLES, "omega (rad/s)": SPEED})
    pq.write_table(table, path, row_group_size=333)


def write_uff(path: Path) -> None:
    pyuff = pytest.importorskip("pyuff")
    common = {
        **{"type": 58, "binary": 0, "func_type": 1, "x": TIMES, "rsp_node": 1, "rsp_dir": 3},
        **{"ref_node": 0, "ref_dir": 0, "abscissa_spacing": 1, "abscissa_spec_data_type": 17},
        **{"orddenom_spec_data_type": 0},
    }
    acc = {"data": SAMPLES, "id1": "acc", "ordinate_axis_units_lab": "g"}
    shaft = {"data": RPM, "id1": "tacho", "ordinate_axis_units_lab": "RPM"}
    kinds = ({**acc, "ordinate_spec_data_type": 12}, {**shaft, "ordinate_spec_data_type": 0})
    pyuff.UFF(str(path)).write_sets([{**common, **kind} for kind in kinds])


def write_wav(path: Path) -> None:
    scipy.io.wavfile.write(path, int(RATE), np.column_stack([SAMPLES, RPM]))


Case = tuple[Callable[[Path], Any], dict[str, Any]]
CASES: dict[str, Case] = {
    "a.csv": (write_csv, {"speed_channel": "speed"}),
    "a.h5": (write_hdf5, {"channel": "run/acc", "speed_channel": "run/shaft"}),
    "a.parquet": (write_parquet, {"channel": "acc", "speed_channel": "OMEGA"}),
    "a.uff": (write_uff, {"channel": "acc", "speed_channel": "tacho"}),
    "a.wav": (write_wav, {"channel": 1, "speed_channel": 2, "speed_unit": "rpm"}),
    "a.npy": (
        lambda path: np.save(path, np.column_stack([RPM, SAMPLES])),
        {"rate": RATE, "channel": "a[2]", "speed_channel": "a[1]", "speed_unit": "1/min"},
    ),
    "turned.npy": (
        lambda path: np.save(path, np.array([RPM, SAMPLES])),
        {"rate": RATE, "channel": 2, "speed_channel": "1", "speed_unit": "rpm"},
    ),
    "a.npz": (
        lambda path: np.savez_compressed(path, x=SAMPLES, rpm=RPM.astype(np.float64), tempo=TIMES),
        {"channel": "x", "speed_channel": "rpm"},
    ),
    "a.mat": (
        lambda path: scipy.io.savemat(
            path, {"X097_DE_time": SAMPLES, "X097RPM": RPM, "Time": TIMES[:, None], "n": 3.0}
        ),
        {"channel": "X097_DE_time", "speed_channel": "X097RPM"},
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_speed_sample_by_sample(tmp_path: Path, name: str) -> None:
    write, arguments = CASES[name]
    write(tmp_path / name)
    signal = read_signal(tmp_path / name, **arguments)
    assert signal.speed is not None
    assert signal.rate == pytest.approx(RATE, rel=1e-5)
    scale = 9.80665 if signal.unit == "m/s^2" else 1.0
    np.testing.assert_allclose(signal.samples, SAMPLES * scale, atol=1e-7)
    np.testing.assert_allclose(signal.speed, SPEED, atol=1e-7)
    with open_signal(tmp_path / name, **arguments, start=0.05, duration=0.5) as file:
        assert (file.speed, file.length) == (None, 1000)
        assert file.speed_channel is not None
        blocks = list(file.blocks(300, overlap=60))
        again = file.read(17, 31)
    for piece, first in [*zip(blocks, range(0, 940, 240), strict=True), (again, 17)]:
        part = slice(100 + first, 100 + first + len(piece.samples))
        np.testing.assert_allclose(piece.samples, SAMPLES[part] * scale, atol=1e-7)
        assert piece.speed is not None
        np.testing.assert_allclose(piece.speed, SPEED[part], atol=1e-7)


def test_speed_is_read_in_bounded_memory(tmp_path: Path) -> None:
    long = np.column_stack([np.tile(SAMPLES, 1500), np.tile(RPM, 1500)])
    np.save(tmp_path / "a.npy", long)
    arguments: dict[str, Any] = {"channel": 1, "speed_channel": 2, "speed_unit": "rpm"}
    total = 0.0
    with open_signal(tmp_path / "a.npy", rate=RATE, **arguments) as file:
        tracemalloc.start()
        for block in file.blocks(100_000):
            total += float(np.sum(np.asarray(block.speed)))
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
    assert total == pytest.approx(float(np.sum(long[:, 1])) * pi / 30)
    assert peak < 20e6 < long.nbytes


@pytest.mark.parametrize(
    ("wanted", "unit", "expected"),
    [
        ("X097RPM", None, 1796 * pi / 30),
        ("x097rpm", "Hz", 1796 * 2 * pi),
        ("shaft", "rad/s", 188.0),
        ("shaft", "deg/s", 188.0 * pi / 180),
        ("speed_Hz", None, -30 * 2 * pi),
    ],
)
def test_speed_that_is_one_number(
    tmp_path: Path, wanted: str, unit: str | None, expected: float
) -> None:
    numbers = {"X097RPM": np.array([[1796]]), "shaft": 188.0, "speed_Hz": -30.0}
    scipy.io.savemat(tmp_path / "a.mat", {"x": SAMPLES, **numbers})
    with open_signal(tmp_path / "a.mat", rate=RATE, speed_channel=wanted, speed_unit=unit) as file:
        assert file.speed == pytest.approx(expected)
        assert file.speed_channel is None
        speed = file.read(0, 10).speed
    assert speed is not None
    assert speed.shape == ()
    assert float(speed) == pytest.approx(expected)


def test_speed_above_a_table(tmp_path: Path) -> None:
    rows = "\n".join(f"{x:.9f}" for x in SAMPLES)
    text = f"fs: 2000\nspeed = 1500\nRPM: 1400\nacc (g)\n{rows}\n"
    (tmp_path / "a.csv").write_text(text, "utf-8")
    assert read_signal(tmp_path / "a.csv").mean_speed == pytest.approx(1400 * pi / 30)
    given = read_signal(tmp_path / "a.csv", speed_channel="speed", speed_unit="rpm")
    assert given.mean_speed == pytest.approx(1500 * pi / 30)


@pytest.fixture
def arrays(tmp_path: Path) -> Path:
    wrong = RPM.copy()
    wrong[40] = np.nan
    np.savez(
        tmp_path / "a.npz",
        acc=SAMPLES,
        rpm=RPM,
        speed=RPM,
        short_rpm=RPM[:-1],
        wrong_rpm=wrong,
        great_rpm=RPM * 1e300,
        none_rpm=np.nan,
        fs=RATE,
    )
    return tmp_path / "a.npz"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            {"speed_channel": "rmp"},
            r'speed_channel = "rmp": must be one, and only one, of 1 acc, 2 rpm.*a number: .*fs',
        ),
        ({"speed_channel": 9}, "speed_channel = 9: must be one, and only one, of 1 acc"),
        ({"speed_channel": True}, "speed_channel = true: must be one, and only one, of 1 acc"),
        ({"speed_channel": "acc"}, 'speed_channel = "acc": is the channel of the samples'),
        (
            {"speed_channel": "short_rpm"},
            '"short_rpm": has 1199 numbers, and the channel of the samples 1200',
        ),
        (
            {"speed_channel": "speed"},
            'speed_unit: is needed for the speed "speed".*one of rpm, rad/s',
        ),
        (
            {"speed_channel": "speed", "speed_unit": "g"},
            'speed_unit = "g": must be one of rpm, rad/s',
        ),
        ({"speed_channel": "speed", "speed_unit": 5}, "speed_unit = 5: must be one of rpm"),
        (
            {"speed_unit": "rpm"},
            'speed_unit = "rpm": needs a speed_channel, and none is given',
        ),
        ({"speed_channel": "wrong_rpm"}, r"speed = nan: 1 of 1200 samples are not finite.* 40 "),
        (
            {"speed_channel": "great_rpm"},
            r"speed = .*must be finite numbers of magnitude up to 1e7",
        ),
        ({"speed_channel": "none_rpm"}, "none_rpm = nan: is not a finite number"),
    ],
)
def test_speed_that_is_refused(arrays: Path, arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message) as caught:
        read_signal(arrays, channel="acc", **arguments)
    assert str(caught.value).startswith(str(arrays))


def test_speed_in_a_unit_of_the_file(tmp_path: Path) -> None:
    rows = "\n".join(f"{x:.9f};{r:.6f};{r:.6f}" for x, r in zip(SAMPLES, RPM, strict=True))
    (tmp_path / "a.csv").write_text(f"fs: 2000\nacc;a (V);b (rpm)\n{rows}\n", "utf-8")
    with pytest.raises(
        InputError, match='speed_channel = "a": is in V, which is not a unit of speed'
    ):
        read_signal(tmp_path / "a.csv", channel=1, speed_channel="a", speed_unit="rpm")
    with pytest.raises(InputError, match=r'speed_unit = "Hz": contradicts the file, .* "rpm"'):
        read_signal(tmp_path / "a.csv", channel=1, speed_channel="b", speed_unit="Hz")
    signal = read_signal(tmp_path / "a.csv", channel=1, speed_channel=3)
    np.testing.assert_allclose(np.asarray(signal.speed), SPEED, atol=1e-6)


def test_speed_at_another_rate(tmp_path: Path) -> None:
    with h5py.File(tmp_path / "a.h5", "w") as file:
        file.create_dataset("acc", data=SAMPLES).attrs["fs"] = RATE
        file.create_dataset("rpm", data=RPM).attrs["fs"] = RATE / 10
    with pytest.raises(FileError, match="is sampled at 200 Hz, and the samples at 2000 Hz"):
        read_signal(tmp_path / "a.h5", speed_channel="rpm")


def write_times(path: Path, times: Any, more: dict[str, Any] | None = None) -> None:
    """A file of a channel and its times, in the format of its ending."""
    arrays = {"x": SAMPLES, "Time": times, **(more or {})}
    if path.suffix == ".npz":
        np.savez(path, **arrays)
    elif path.suffix == ".mat":
        scipy.io.savemat(path, {"run": arrays}, do_compression=True)
    elif path.suffix == ".parquet":
        pq.write_table(pa.table({name: pa.array(array) for name, array in arrays.items()}), path)
    elif path.suffix == ".csv":
        rows = "\n".join(f"{a:.17g};{b:.17g}" for a, b in zip(SAMPLES, times, strict=True))
        path.write_text(f"x;Time\n{rows}\n", "utf-8")
    else:
        with h5py.File(path, "w") as file:
            for name, array in arrays.items():
                file.create_dataset(f"run/{name}", data=array)


FORMATS = ["a.csv", "a.npz", "a.mat", "a.h5", "a.parquet"]


@pytest.mark.parametrize("name", FORMATS)
def test_times_give_the_rate(tmp_path: Path, name: str) -> None:
    write_times(tmp_path / name, TIMES + 5.0)
    (channel,) = channels_of(tmp_path / name)
    assert channel.name in ("x", "run.x", "run/x")
    assert channel.rate == pytest.approx(RATE, rel=1e-9)
    np.testing.assert_allclose(read_signal(tmp_path / name).samples, SAMPLES)
    with open_signal(tmp_path / name, rate=1990.0) as file:
        (note,) = file.notes
        assert (file.rate, note.key) == (1990.0, "rate_over_file")
        assert note.values == {"rate": 1990.0, "file": pytest.approx(2000.0)}


@pytest.mark.parametrize("name", FORMATS)
@pytest.mark.parametrize(
    ("place", "change", "refused"),
    [
        (700, 0.25, False),  # of a step: what rounding may do
        (700, 0.35, True),
        (700, -5.0, True),
        (300, float("nan"), True),
        (-1, float("inf"), True),
        (-1, -10_000.0, True),
    ],
)
@pytest.mark.thirds
def test_times_that_are_not_even(
    tmp_path: Path, name: str, place: int, change: float, refused: bool
) -> None:
    times = TIMES.copy()
    times[place] += change / RATE
    write_times(tmp_path / name, times)
    if refused:
        rule = r"time column.*(is not evenly spaced|does not increase)"
        with pytest.raises(FileError, match=rule) as caught:
            read_signal(tmp_path / name)
        assert str(caught.value).startswith(str(tmp_path / name))
    else:
        np.testing.assert_allclose(read_signal(tmp_path / name).samples, SAMPLES)


@pytest.mark.parametrize("name", FORMATS)
def test_a_sample_missing_in_a_block_that_is_not_read(tmp_path: Path, name: str) -> None:
    """What is wrong later in the file does not keep from reading what comes before."""
    times = TIMES.copy()
    times[900] += 0.8 / RATE
    write_times(tmp_path / name, times)
    with open_signal(tmp_path / name) as file:
        assert len(file.read(0, 800).samples) == 800
        with pytest.raises(FileError, match="is not evenly spaced: sample 900 "):
            file.read(800, 400)


@pytest.mark.parametrize("name", ["a.npz", "a.mat", "a.h5"])
def test_times_and_rates_that_contradict(tmp_path: Path, name: str) -> None:
    """Nobody knows which is right: the user is asked."""
    write_times(tmp_path / name, TIMES, {"fs": 2500.0})
    doubt = '"fs" says 2500 Hz and the column of times says 2000 Hz'
    (channel,) = channels_of(tmp_path / name)
    assert channel.rate is None
    assert [claim.name for claim in channel.rate_doubt] == ['"fs"', "the column of times"]
    with pytest.raises(InputError, match=f"rate: is ambiguous: in the file {doubt}; give it"):
        read_signal(tmp_path / name)
    with open_signal(tmp_path / name, rate=2500.0) as file:
        (note,) = file.notes
        assert note.text == f"The sampling rate is 2500 Hz as given; in the file {doubt}."
    write_times(tmp_path / name, TIMES, {"fs": 2000.5})
    assert read_signal(tmp_path / name).rate == 2000.5


def test_times_of_their_own_channels_only(tmp_path: Path) -> None:
    """Of the same group, or above all of them, and as long; else they are a channel."""
    np.savez(tmp_path / "a.npz", x=SAMPLES, y=SAMPLES[:500], t=TIMES, time=TIMES[:700])
    found = {channel.name: channel.rate for channel in channels_of(tmp_path / "a.npz")}
    assert found == {"x": pytest.approx(RATE), "y": None, "time": None}
    with h5py.File(tmp_path / "a.h5", "w") as file:
        file["one/x"], file["one/t"] = SAMPLES, TIMES
        file["two/x"], file["two/t"] = SAMPLES, TIMES * 1e3
        file["two/t"].attrs["unit"] = "ms"
        file["three/x"], file["three/t"] = SAMPLES, TIMES
        file["three/t"].attrs["unit"] = "days since 1970-01-01"
    rates = {channel.name: channel.rate for channel in channels_of(tmp_path / "a.h5")}
    assert rates["one/x"] == pytest.approx(RATE)
    assert rates["two/x"] == pytest.approx(RATE)
    assert (rates["three/x"], rates["three/t"]) == (None, None)
    assert len(rates) == 4
