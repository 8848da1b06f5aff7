"""Signal files of every format, written by other software, come back as they were."""

from __future__ import annotations

import re
import struct
import zipfile
import zlib
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
from rolamento.io.foreign import bounds, isolated
from rolamento.vibration.reading import channels_of, open_signal, read_signal
from rolamento.words import Note

RATE = 12000.0
COUNT = 1500
SAMPLES = np.random.default_rng(7).normal(size=COUNT)
OTHER = np.random.default_rng(8).normal(size=COUNT)
TIMES = np.arange(COUNT) / RATE
GRAVITY = 9.80665
GUIDE = Path(__file__).resolve().parents[2] / "docs" / "signals.md"


def write_hdf5(path: Path, **storage: Any) -> None:
    with h5py.File(path, "w") as file:
        group = file.create_group("run")
        group.attrs["fs"] = RATE
        group.attrs["rpm"] = 1500
        data = group.create_dataset("drive end", data=SAMPLES, **storage)
        data.attrs["unit"] = "g"
        group.create_dataset("both", data=np.column_stack([SAMPLES, OTHER]))


def write_csv(path: Path, *, separator: str = ";", comma: bool = True, head: str = "") -> None:
    rows = [f"{t:.8f}{separator}{x:.9f}" for t, x in zip(TIMES, SAMPLES, strict=True)]
    text = "\n".join(rows)
    path.write_text(head + (text.replace(".", ",") if comma else text) + "\n", encoding="utf-8")


def write_uff(path: Path, *, binary: int = 0, even: int = 1, count: int = 1, **more: Any) -> None:
    pyuff = pytest.importorskip("pyuff")
    record = {
        **{"type": 58, "binary": binary, "func_type": 1, "data": SAMPLES, "x": TIMES},
        **{"rsp_node": 4, "rsp_dir": 3, "ref_node": 0, "ref_dir": 0, "id1": "drive end"},
        **{"abscissa_spacing": even, "abscissa_spec_data_type": 17},
        **{"ordinate_spec_data_type": 12, "orddenom_spec_data_type": 0},
        **{"ordinate_axis_units_lab": "g"},
        **more,
    }
    pyuff.UFF(str(path)).write_sets([dict(record) for _ in range(count)])


# pyuff leaves a file open when it writes binary data
writes_uff = pytest.mark.filterwarnings(
    "ignore::ResourceWarning", "ignore::pytest.PytestUnraisableExceptionWarning"
)


@pytest.mark.parametrize("dtype", [np.uint8, np.int16, np.int32, np.float32, np.float64])
def test_wav(tmp_path: Path, dtype: Any) -> None:
    floats = np.issubdtype(dtype, np.floating)
    scale = 1.0 if floats else 2.0 ** (8 * np.dtype(dtype).itemsize - 1)
    offset = 128.0 if dtype == np.uint8 else 0.0
    stored = (0.2 * np.clip(SAMPLES, -4, 4) * scale + offset).astype(dtype)
    scipy.io.wavfile.write(tmp_path / "a.wav", int(RATE), stored)
    signal = read_signal(tmp_path / "a.wav")
    assert signal.rate == RATE
    assert (signal.quantity, signal.unit) == ("unknown", "" if floats else "1")
    np.testing.assert_array_equal(signal.samples, (stored - offset) / scale)


@pytest.mark.parametrize("order", ["<", ">"])
def test_wav_of_24_bits_and_odd_chunks(tmp_path: Path, order: str) -> None:
    numbers = np.array([0, 1, -1, 2**23 - 1, -(2**23), 1234567], dtype=f"{order}i4")
    raw = numbers.view(np.uint8).reshape(-1, 4)
    content = (raw[:, :3] if order == "<" else raw[:, 1:]).tobytes()
    form = struct.pack(f"{order}HHIIHHHHI", 0xFFFE, 2, 48000, 288000, 6, 24, 22, 24, 3)
    form += struct.pack(f"{order}IHH", 1, 0, 16) + bytes.fromhex("800000aa00389b71")
    chunks = b"".join(
        name + struct.pack(f"{order}I", len(data)) + data + bytes(len(data) % 2)
        for name, data in ((b"LIST", b"odd"), (b"fmt ", form), (b"data", content))
    )
    head = (b"RIFF" if order == "<" else b"RIFX") + struct.pack(f"{order}I", len(chunks) + 4)
    (tmp_path / "a.wav").write_bytes(head + b"WAVE" + chunks)
    with open_signal(tmp_path / "a.wav", channel=2) as file:
        np.testing.assert_array_equal(file.read().samples, numbers[1::2] / 2.0**23)
        assert file.notes == (Note("bits_to_full_scale", {"bits": 24}),)


@pytest.mark.parametrize(
    ("head", "separator", "comma"),
    [
        ("Time (s);acc (g)\n", ";", True),
        ("Zeit;Beschleunigung\ns;g\n", ";", True),
        ("Device: X\nOperator;B\n\ntime [s]\tacc [g]\n", "\t", True),
        ("time,acc (g)\n", ",", False),
        ("# time acc[g]\n", " ", False),
    ],
)
def test_csv(tmp_path: Path, head: str, separator: str, comma: bool) -> None:
    write_csv(tmp_path / "a.csv", separator=separator, comma=comma, head=head)
    signal = read_signal(tmp_path / "a.csv")
    assert signal.rate == pytest.approx(RATE, rel=1e-6)
    assert (signal.quantity, signal.unit) == ("acceleration", "m/s^2")
    np.testing.assert_allclose(signal.samples, SAMPLES * GRAVITY, atol=1e-7)


def test_csv_with_a_rate_above_the_table(tmp_path: Path) -> None:
    rows = "\n".join(f"{a:.6f},{b:.6f}," for a, b in zip(SAMPLES, OTHER, strict=True))
    (tmp_path / "a.txt").write_text(
        f"# fs = 25600 Hz\n# rpm: 1500\nx (mm/s),y\n{rows}\n\n", "utf-8"
    )
    x, y = channels_of(tmp_path / "a.txt")
    assert (x.name, x.rate, x.unit, x.quantity, x.length) == ("x", 25600, "mm/s", "velocity", COUNT)
    assert x.speed == pytest.approx(50 * pi)
    assert (y.name, y.unit) == ("y", "")
    np.testing.assert_allclose(
        read_signal(tmp_path / "a.txt", channel="y").samples, OTHER, atol=1e-6
    )
    velocity = read_signal(tmp_path / "a.txt", channel="X")
    np.testing.assert_allclose(velocity.samples, SAMPLES * 1e-3, atol=1e-9)


def test_csv_of_one_column_with_decimal_commas(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text("acc (g)\n0,25\n-0,5\n0,75\n", "utf-8")
    signal = read_signal(tmp_path / "a.csv", rate=10.0)
    np.testing.assert_allclose(signal.samples, np.array([0.25, -0.5, 0.75]) * GRAVITY)


def test_csv_without_headings_and_with_dates(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text("12:00:01;1;5\n12:00:02;3;4\n12:00:03;2;6\n", "utf-8")
    channels = channels_of(tmp_path / "a.csv")
    assert [channel.length for channel in channels] == [3, 3]
    np.testing.assert_array_equal(
        read_signal(tmp_path / "a.csv", channel=2, rate=1).samples, [5, 4, 6]
    )


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("a;b\n1;2\n3;4\n" + "5;6\n" * 5 + "7;x\n", r'line 9: column 2 "b" = "x": is not a number'),
        ("a;b\n" + "1;2\n" * 6 + "\n3;4\n", "line 2: has blank or joined lines"),
        ("a;b\n" + "1;2\n" * 6 + "1;\n3;4\n", 'line 8: column 2 "b" = "": is not a number'),
        ("a;b\n" + "1;2\n" * 6 + "1\n3;4\n", 'line 8: column 2 "b": has fewer columns'),
        ("only words\nand words\n", "has no table of numbers"),
        ("\ufeff", "has no table of numbers"),
        ("time;a\n0;1\n1;2\n2;1\n4;2\n5;1\n", "time column = .*is not evenly spaced: sample"),
        ("time;a\n0;1\n0;2\n0;1\n", "time column.*does not increase"),
        ("a;b\n" + "1;2\n" * 9 + "1;" + "1" * 70000, "has a line of more than 64 kB"),
    ],
)
def test_csv_that_is_wrong(tmp_path: Path, text: str, message: str) -> None:
    (tmp_path / "a.csv").write_text(text, "utf-8")
    channel = None if "time" in text else 2
    rate = 10.0 if channel else None
    with pytest.raises(FileError, match=message):
        read_signal(tmp_path / "a.csv", channel=channel, rate=rate)


@pytest.mark.parametrize("order", ["C", "F"])
@pytest.mark.parametrize("turned", [False, True])
def test_npy(tmp_path: Path, order: Any, turned: bool) -> None:
    both = np.column_stack([SAMPLES, OTHER]).astype(np.float32)
    np.save(tmp_path / "a.npy", np.array(both.T if turned else both, order=order))
    assert [channel.name for channel in channels_of(tmp_path / "a.npy")] == ["a[1]", "a[2]"]
    signal = read_signal(tmp_path / "a.npy", channel="a[2]", rate=RATE, unit="um", start=0.05)
    np.testing.assert_allclose(signal.samples, both[600:, 1] * 1e-6)
    assert (signal.quantity, signal.unit) == ("displacement", "m")


def test_npy_never_unpickles(tmp_path: Path) -> None:
    np.save(tmp_path / "a.npy", np.array([{}], dtype=object), allow_pickle=True)
    with pytest.raises(FileError, match="must be real numbers: arrays of objects"):
        read_signal(tmp_path / "a.npy", rate=RATE)


def test_npz(tmp_path: Path) -> None:
    np.savez_compressed(
        tmp_path / "a.npz",
        acc=SAMPLES,
        both=np.asfortranarray(np.column_stack([SAMPLES, OTHER])),
        Fs=RATE,
        note=np.array(["text"]),
        objects=np.array([None]),
    )
    names = [channel.name for channel in channels_of(tmp_path / "a.npz")]
    assert names == ["acc", "both[1]", "both[2]"]
    signal = read_signal(tmp_path / "a.npz", channel="both[2]")
    assert signal.rate == RATE
    np.testing.assert_array_equal(signal.samples, OTHER)


def test_npz_that_inflates_too_far(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    np.savez_compressed(tmp_path / "a.npz", acc=np.zeros(200_000))
    monkeypatch.setattr(bounds, "LARGEST_WHOLE", 1_000_000)
    with pytest.raises(FileError, match="inflates to more than"):
        read_signal(tmp_path / "a.npz", rate=RATE)


def test_npz_with_a_path_out_of_it_writes_nothing(tmp_path: Path) -> None:
    np.save(tmp_path / "x.npy", SAMPLES)
    (tmp_path / "in").mkdir()
    with zipfile.ZipFile(tmp_path / "in" / "a.npz", "w") as archive:
        archive.write(tmp_path / "x.npy", "../../escaped.npy")
    signal = read_signal(tmp_path / "in" / "a.npz", rate=RATE)
    np.testing.assert_array_equal(signal.samples, SAMPLES)
    assert not list(tmp_path.parent.rglob("escaped*"))


@pytest.mark.parametrize("compressed", [False, True])
def test_matlab_as_case_western(tmp_path: Path, compressed: bool) -> None:
    scipy.io.savemat(
        tmp_path / "97.mat",
        {
            "X097_DE_time": SAMPLES[:, None],
            "X097_FE_time": OTHER[:, None].astype(np.float32),
            "X098_DE_time": OTHER[None, :],
            "X097RPM": np.array([[1796]]),
            "words": "text",
            "complex": np.ones(4) * 1j,
            "cells": np.array([SAMPLES, "x"], dtype=object),
        },
        do_compression=compressed,
    )
    channels = channels_of(tmp_path / "97.mat")
    assert [c.name for c in channels] == ["X097_DE_time", "X097_FE_time", "X098_DE_time"]
    assert [c.speed for c in channels] == [pytest.approx(1796 * pi / 30), channels[0].speed, None]
    signal = read_signal(tmp_path / "97.mat", channel="X097_DE_time", rate=RATE, unit="g")
    np.testing.assert_allclose(signal.samples, SAMPLES * GRAVITY)
    assert signal.mean_speed == pytest.approx(1796 * pi / 30)
    third = read_signal(tmp_path / "97.mat", channel=3, rate=RATE)
    np.testing.assert_array_equal(third.samples, OTHER)
    with pytest.raises(InputError, match="is not in the file; give it, in Hz"):
        read_signal(tmp_path / "97.mat", channel=1)


def test_matlab_structure_and_narrow_integers(tmp_path: Path) -> None:
    whole = np.arange(COUNT) % 100  # SciPy keeps the type, MATLAB would narrow it
    fields = {"sr": 97656.0, "gs": SAMPLES, "rate": 25.0, "inner": {"raw": whole.astype(np.int16)}}
    scipy.io.savemat(tmp_path / "a.mat", {"bearing": fields, "Fs": 5000.0})
    gs, raw = channels_of(tmp_path / "a.mat")
    assert (gs.name, gs.rate) == ("bearing.gs", 97656.0)
    assert (raw.name, raw.rate) == ("bearing.inner.raw", 5000.0)
    np.testing.assert_array_equal(read_signal(tmp_path / "a.mat", channel=2).samples, whole)


def test_matlab_bomb(tmp_path: Path) -> None:
    scipy.io.savemat(tmp_path / "a.mat", {"x": SAMPLES})
    head = (tmp_path / "a.mat").read_bytes()[:128]
    inner = struct.pack("<II", 14, 2**31) + bytes(10_000_000)
    packed = zlib.compress(inner, 9)
    (tmp_path / "b.mat").write_bytes(head + struct.pack("<II", 15, len(packed)) + packed)
    with pytest.raises(FileError, match="is not a readable MATLAB file"):
        channels_of(tmp_path / "b.mat")


@pytest.mark.parametrize(
    "storage",
    [
        {},
        {"chunks": (400,)},
        {"chunks": (400,), "compression": "gzip", "shuffle": True, "fletcher32": True},
    ],
)
def test_hdf5(tmp_path: Path, storage: dict[str, Any]) -> None:
    write_hdf5(tmp_path / "a.h5", **storage)
    names = [channel.name for channel in channels_of(tmp_path / "a.h5")]
    assert names == ["run/both[1]", "run/both[2]", "run/drive end"]
    with open_signal(tmp_path / "a.h5", channel="run/drive end") as file:
        assert (file.rate, file.unit, file.speed) == (RATE, "m/s^2", pytest.approx(50 * pi))
        np.testing.assert_allclose(file.read().samples, SAMPLES * GRAVITY)
        np.testing.assert_allclose(file.read(390, 30).samples, SAMPLES[390:420] * GRAVITY)
    second = read_signal(tmp_path / "a.h5", channel="run/both[2]")
    np.testing.assert_array_equal(second.samples, OTHER)


def test_matlab_7_3(tmp_path: Path) -> None:
    with h5py.File(tmp_path / "a.mat", "w", userblock_size=512) as file:
        for name, values in (("vib", SAMPLES[None, :]), ("Fs", np.array([[RATE]]))):
            file.create_dataset(name, data=values).attrs["MATLAB_class"] = np.bytes_("double")
    with (tmp_path / "a.mat").open("r+b") as raw:
        raw.write(b"MATLAB 7.3 MAT-file".ljust(124) + b"\x00\x02IM")
    signal = read_signal(tmp_path / "a.mat", unit="m/s²")
    assert (signal.rate, signal.unit) == (RATE, "m/s^2")
    np.testing.assert_array_equal(signal.samples, SAMPLES)


def test_hdf5_follows_nothing_out_of_the_file(tmp_path: Path) -> None:
    write_hdf5(tmp_path / "secret.h5")
    OTHER.tofile(tmp_path / "raw.bin")
    with h5py.File(tmp_path / "a.h5", "w") as file:
        own = file.create_dataset("own", data=SAMPLES)
        file["soft"] = h5py.SoftLink("/own")
        file["external"] = h5py.ExternalLink("secret.h5", "/run/drive end")
        file["again"] = own
        file["loop"] = file["/"]
        layout = h5py.VirtualLayout(shape=(COUNT,), dtype="f8")
        layout[:] = h5py.VirtualSource("secret.h5", "run/drive end", shape=(COUNT,))
        file.create_virtual_dataset("virtual", layout)
        places = [(str(tmp_path / "raw.bin"), 0, COUNT * 8)]
        file.create_dataset("stored", shape=(COUNT,), dtype="f8", external=places)
        file.create_dataset("pointer", data=np.array([own.ref], dtype=h5py.ref_dtype))
    channels = channels_of(tmp_path / "a.h5")
    assert len(channels) == 1
    np.testing.assert_array_equal(read_signal(tmp_path / "a.h5", rate=RATE).samples, SAMPLES)


def test_hdf5_bomb(tmp_path: Path) -> None:
    with h5py.File(tmp_path / "a.h5", "w") as file:
        data = file.create_dataset("x", (100,), "f8", chunks=(100,), compression="gzip")
        data.id.write_direct_chunk((0,), zlib.compress(bytes(4_000_000), 9))
    with pytest.raises(
        FileError, match="samples: no sensor was connected, or it is the wrong channel"
    ):
        read_signal(tmp_path / "a.h5", rate=RATE)


def test_process_that_does_not_answer(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write_hdf5(tmp_path / "a.h5")
    monkeypatch.setattr(isolated, "PATIENCE", 0.5)
    for program in ("import time; time.sleep(60)", "import os; os.abort()"):
        monkeypatch.setattr(isolated, "_PROGRAM", program)
        with pytest.raises(FileError, match="the library of this HDF5 file broke off, or came to"):
            channels_of(tmp_path / "a.h5")


@pytest.mark.parametrize("codec", ["snappy", "gzip", "none"])
def test_parquet(tmp_path: Path, codec: str) -> None:
    fields = [
        pa.field("time (ms)", pa.float64()),
        pa.field("drive end", pa.float32(), metadata={"unit": "g"}),
        pa.field("count", pa.int16()),
        pa.field("label", pa.string()),
    ]
    columns = [TIMES * 1e3, SAMPLES.astype(np.float32), np.arange(COUNT, dtype=np.int16)]
    arrays = [pa.array(column) for column in columns] + [pa.array(["a"] * COUNT)]
    table = pa.table(arrays, schema=pa.schema(fields, metadata={"rpm": "1500"}))
    pq.write_table(table, tmp_path / "a.parquet", row_group_size=400, compression=codec)
    first, second = channels_of(tmp_path / "a.parquet")
    assert (first.name, first.unit, second.name, second.unit) == ("drive end", "g", "count", "")
    with open_signal(tmp_path / "a.parquet", channel=1) as file:
        assert file.rate == pytest.approx(RATE)
        assert file.speed == pytest.approx(50 * pi)
        np.testing.assert_allclose(file.read(395, 600).samples, columns[1][395:995] * GRAVITY)
        np.testing.assert_allclose(file.read(3, 5).samples, columns[1][3:8] * GRAVITY)


def test_parquet_with_missing_numbers(tmp_path: Path) -> None:
    table = pa.table({"x": pa.array([1.0, None, 2.0])}).replace_schema_metadata({"fs": "100"})
    pq.write_table(table, tmp_path / "a.parquet")
    with pytest.raises(FileError, match=r"1 of 3 samples are not finite .* sample 1 .*0.01 s"):
        read_signal(tmp_path / "a.parquet")


@writes_uff
@pytest.mark.parametrize("binary", [0, 1])
@pytest.mark.parametrize("even", [0, 1])
def test_universal_file(tmp_path: Path, binary: int, even: int) -> None:
    write_uff(tmp_path / "a.uff", binary=binary, even=even, count=2)
    first, _ = channels_of(tmp_path / "a.uff")
    assert (first.name, first.unit, first.length) == ("drive end", "g", COUNT)
    signal = read_signal(tmp_path / "a.uff", channel=2, start=0.05, duration=0.05)
    assert signal.rate == pytest.approx(RATE, rel=3e-6)
    np.testing.assert_allclose(signal.samples, SAMPLES[600:1200] * GRAVITY, atol=1e-9)


@writes_uff
def test_universal_file_of_other_functions(tmp_path: Path) -> None:
    write_uff(tmp_path / "a.uff", func_type=4, abscissa_spec_data_type=18)
    with pytest.raises(FileError, match="holds frequency responses; a record over time is needed"):
        channels_of(tmp_path / "a.uff")


def test_universal_file_in_single_precision_with_touching_numbers(tmp_path: Path) -> None:
    values = [-1.5e-100, -2.25e-101, -3.5e-102, 4.0, -5.0, 6.0, -7.0]
    cells = [f"{value:13.5e}" for value in values]
    assert cells[0] + cells[1] == "-1.50000e-100-2.25000e-101"
    lines = ["NONE"] * 5 + [
        f"{1:5d}{0:10d}{0:5d}{0:10d} {'NONE':10s}{7:10d}{3:4d} {'NONE':10s}{0:10d}{0:4d}",
        f"{2:10d}{len(values):10d}{1:10d}{0.0:13.5e}{1e-3:13.5e}{0.0:13.5e}",
        f"{17:10d}{0:5d}{0:5d}{0:5d} {'NONE':20s} {'NONE':20s}",
        f"{11:10d}{0:5d}{0:5d}{0:5d} {'NONE':20s} {'NONE':20s}",
        *[f"{0:10d}{0:5d}{0:5d}{0:5d} {'NONE':20s} {'NONE':20s}"] * 2,
        "".join(cells[:6]),
        cells[6],
    ]
    text = "    -1\n    58\n" + "\n".join(lines) + "\n    -1\n"
    (tmp_path / "a.unv").write_text(text.replace("e", "D"), "utf-8")
    (channel,) = channels_of(tmp_path / "a.unv")
    assert (channel.name, channel.rate, channel.quantity) == ("point 7", 1000.0, "velocity")
    with pytest.raises(InputError, match="unit: of the samples is not in the file"):
        read_signal(tmp_path / "a.unv")
    signal = read_signal(tmp_path / "a.unv", unit="mm/s")
    np.testing.assert_allclose(signal.samples, np.array(values) * 1e-3)
    si = "    -1\n   164\n" + f"{1:10d}{'SI':20s}{2:10d}\n" + "    -1\n"
    (tmp_path / "b.unv").write_text(si + text, "utf-8")
    np.testing.assert_allclose(read_signal(tmp_path / "b.unv").samples, values)


WRITERS: dict[str, Callable[[Path], Any]] = {
    "a.wav": lambda path: scipy.io.wavfile.write(path, int(RATE), SAMPLES),
    "a.npy": lambda path: np.save(path, SAMPLES),
    "a.npz": lambda path: np.savez(path, x=SAMPLES),
    "a.mat": lambda path: scipy.io.savemat(path, {"x": SAMPLES}),
    "a.h5": lambda path: write_hdf5(path, chunks=(400,)),
    "a.parquet": lambda path: pq.write_table(pa.table({"x": SAMPLES}), path, row_group_size=333),
    "a.csv": lambda path: np.savetxt(path, SAMPLES, header="x", fmt="%.17e"),
    "a.uff": write_uff,
}


@writes_uff
@pytest.mark.parametrize("name", WRITERS)
def test_blocks_are_the_whole(tmp_path: Path, name: str) -> None:
    WRITERS[name](tmp_path / name)
    channel = 3 if name == "a.h5" else 1
    scale = GRAVITY if name in ("a.h5", "a.uff") else 1.0
    rate = None if name == "a.uff" else RATE
    with open_signal(tmp_path / name, channel=channel, rate=rate, start=0.01, duration=0.1) as file:
        blocks = [block.samples for block in file.blocks(500, overlap=100)]
        assert file.length == 1200
        assert [len(block) for block in blocks] == [500, 500, 400]
        again = list(file.blocks(10_000))
    whole = np.concatenate([blocks[0], *(block[100:] for block in blocks[1:])])
    np.testing.assert_allclose(whole, SAMPLES[120:1320] * scale, atol=1e-10)
    np.testing.assert_array_equal(again[0].samples, whole)
    np.testing.assert_array_equal(blocks[1][:100], blocks[0][-100:])


@pytest.fixture
def stereo(tmp_path: Path) -> Path:
    file = tmp_path / "stereo.npz"
    np.savez(file, left=SAMPLES, right=OTHER, fs=RATE)
    return file


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({}, r"channel: must be chosen, by name or number: 1 left, 2 right .*channel=\"left\""),
        (
            {"channel": "rigth"},
            'channel = "rigth": .*only one, of 1 left, 2 right.*channel="right"',
        ),
        ({"channel": 3}, "channel = 3"),
        ({"channel": True}, "channel = true"),
        ({"channel": 1, "rate": -1.0}, "rate = -1.0: must be a number greater than 0"),
        ({"channel": 1, "rate": float("nan")}, "rate = nan"),
        ({"channel": 1, "unit": "g", "quantity": "velocity"}, 'unit = "g": is not a unit of vel'),
        ({"channel": 1, "quantity": "velocity"}, "unit: of the samples is not in the file"),
        ({"channel": 1, "quantity": "speed"}, "unit|quantity"),
        ({"channel": 1, "unit": 5}, "unit = 5: must be text"),
        ({"channel": 1, "start": 1.0}, "start = 1.0: must be before the end of the file, 0.125 s"),
        ({"channel": 1, "start": -1.0}, "start = -1.0"),
        ({"channel": 1, "duration": 9.0}, "duration = 9.0: must be between .* the 0.125 s after"),
        ({"channel": 1, "duration": 0.0}, "duration = 0.0"),
    ],
)
def test_wrong_arguments(stereo: Path, arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message) as caught:
        read_signal(stereo, **arguments)
    assert str(caught.value).startswith(str(stereo))


def test_rate_and_unit_that_agree(stereo: Path, tmp_path: Path) -> None:
    assert read_signal(stereo, channel="LEFT", rate=12000.5).rate == 12000.5
    write_hdf5(tmp_path / "a.h5")
    assert read_signal(tmp_path / "a.h5", channel=3, unit="G").unit == "m/s^2"
    with pytest.raises(InputError, match='unit = "mm/s": contradicts the file, which says "g"'):
        read_signal(tmp_path / "a.h5", channel=3, unit="mm/s")


def test_samples_that_are_no_signal(tmp_path: Path) -> None:
    file = tmp_path / "a.npy"
    np.save(file, np.full(100, 2.5))
    with pytest.raises(
        FileError, match="samples: no sensor was connected, or it is the wrong channel"
    ):
        read_signal(file, rate=RATE)
    with open_signal(file, rate=RATE) as opened:
        assert [len(block.samples) for block in opened.blocks(60)] == [60, 40]
    np.save(file, np.zeros(0))
    with pytest.raises(FileError, match="has no samples"):
        read_signal(file, rate=RATE)
    wrong = SAMPLES.copy()
    wrong[[700, 900]] = np.nan, np.inf
    np.save(file, wrong)
    with pytest.raises(FileError, match=r"2 of 1500 samples are not finite .* sample 700 "):
        read_signal(file, rate=RATE)
    with open_signal(file, rate=RATE) as opened, pytest.raises(FileError, match="sample 700 "):
        list(opened.blocks(500))
    np.save(file, SAMPLES * 1e300)
    with pytest.raises(InputError, match="must be finite numbers of magnitude up to 1e60"):
        read_signal(file, rate=RATE)


@pytest.mark.parametrize(
    ("name", "content", "message"),
    [
        ("a.wav", b"not a wav", "is not a WAV file, although its name says so"),
        ("a.mat", b"MATLAB 4?", "is not a MATLAB file of version 5 to 7.3"),
        ("a.jpg", b"\xff\xd8\xff", "is not of a format that can be read: WAV"),
        ("a.csv", b"\xff\xfea\0", "has no table of numbers in its first lines"),
        ("a.csv", b"1,2\n\0\0", "is a binary file"),
        ("a.h5", b"", "is empty"),
        ("a.h5", b"\x89HDF\r\n\x1a\n" + bytes(100), "is not a readable HDF5 file"),
        ("a.parquet", b"PAR1" + bytes(100), "is not a readable Parquet file"),
        ("a.npz", b"PK\x03\x04" + bytes(100), "is not a readable NumPy archive"),
        ("a.uff", b"    -1\n    58\n", "without a channel of real numbers"),
    ],
)
def test_files_that_are_something_else(
    tmp_path: Path, name: str, content: bytes, message: str
) -> None:
    (tmp_path / name).write_bytes(content)
    with pytest.raises(FileError, match=message) as caught:
        read_signal(tmp_path / name)
    assert str(caught.value).isprintable()


def test_no_file(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="no such file"):
        read_signal(tmp_path / "none.wav")
    with pytest.raises(FileError, match="is a directory"):
        read_signal(tmp_path)
    for path in ("", "a\0b", 5):
        with pytest.raises(FileError, match="must be the name of a file"):
            read_signal(path)  # type: ignore[arg-type]


def test_declared_sizes_are_checked(tmp_path: Path) -> None:
    scipy.io.wavfile.write(tmp_path / "a.wav", 8000, SAMPLES)
    (tmp_path / "b.wav").write_bytes((tmp_path / "a.wav").read_bytes()[:-8])
    with pytest.raises(FileError, match="is truncated: it declares"):
        read_signal(tmp_path / "b.wav")
    np.save(tmp_path / "a.npy", SAMPLES)
    content = (tmp_path / "a.npy").read_bytes()
    (tmp_path / "b.npy").write_bytes(content.replace(b"(1500,), }", b"(99999,),}", 1))
    with pytest.raises(FileError, match="does not fit into it"):
        read_signal(tmp_path / "b.npy", rate=RATE)


def test_guide(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    variables = {"X097_DE_time": SAMPLES, "X097_FE_time": OTHER, "X097RPM": 1796.0}
    long = {"X097_DE_time": np.tile(SAMPLES, 2), "X097_FE_time": np.tile(OTHER, 2)}
    scipy.io.savemat(tmp_path / "X097.mat", {**variables, **long})
    mfpt = {"sr": 48828.0, "gs": SAMPLES[:, None], "load": 270.0, "rate": 25.0}
    scipy.io.savemat(tmp_path / "baseline_1.mat", {"bearing": mfpt})
    table = pa.table({"drive end": SAMPLES, "fan end": OTHER})
    pq.write_table(table.replace_schema_metadata({"fs": "12000"}), tmp_path / "run.parquet")
    rows = "\n".join(f"{t:.6f};{x:.6f};{1500 + x:.6f}" for t, x in zip(TIMES, SAMPLES, strict=True))
    (tmp_path / "run-up.csv").write_text(f"time;sensor (V);speed (rpm)\n{rows}\n", "utf-8")
    scipy.io.wavfile.write(tmp_path / "recorder.wav", 48000, (SAMPLES * 5000).astype(np.int16))
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"```python\n(.*?)```", GUIDE.read_text("utf-8"), re.DOTALL)
    assert len(blocks) == 5
    for block in blocks:
        exec(compile(block, "example", "exec"), {})
