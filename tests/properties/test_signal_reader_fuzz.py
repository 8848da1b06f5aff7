"""Whatever a signal file holds: a signal or one sentence, soon, and within bounded memory."""

from __future__ import annotations

import io
import struct
import time
import tracemalloc
import zlib
from functools import cache
from pathlib import Path

import h5py
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
import scipy.io
import scipy.io.wavfile
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from rolamento.errors import InputError
from rolamento.vibration.reading import channels_of, hdf5, open_signal
from rolamento.vibration.signal import Signal

SAMPLES = np.random.default_rng(3).normal(size=150)
MOST_MEMORY = 100 * 2**20
LONGEST = 10.0
ENDINGS = [".wav", ".csv", ".npy", ".npz", ".mat", ".h5", ".parquet", ".uff", ""]
SPLINTERS = [
    b"\0",
    b"\xff" * 4,
    b"\x7f\xff\xff\xff",
    b"1e999",
    b"nan",
    b"-1\n",
    b"    -1\n",
    b",",
    b";",
]

within_bounds = settings(
    max_examples=150,
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)


def uff(form: str) -> bytes:
    """A data set 58, in text or binary."""
    point = f"{1:5d}{0:10d}{0:5d}{0:10d} {'A':10s}{1:10d}{3:4d} {'NONE':10s}{0:10d}{0:4d}"
    shape = f"{4:10d}{len(SAMPLES):10d}{1:10d}{0.0:13.5e}{1e-3:13.5e}{0.0:13.5e}"
    axes = [f"{kind:10d}{0:5d}{0:5d}{0:5d} {'NONE':20s} {'g':20s}" for kind in (17, 12, 0, 0)]
    head = "\n".join([*["id"] * 5, point, shape, *axes]) + "\n"
    if form == "text":
        numbers = "".join(
            f"{value:20.11e}" + "\n" * (number % 4 == 3) for number, value in enumerate(SAMPLES)
        )
        return f"    -1\n    58\n{head}{numbers}\n    -1\n".encode()
    mark = f"    -1\n    58b{1:6d}{2:6d}{11:12d}{8 * len(SAMPLES):12d}{0:6d}{0:6d}{0:12d}{0:12d}\n"
    return (mark + head).encode() + SAMPLES.astype("<f8").tobytes() + b"    -1\n"


@cache
def seeds() -> tuple[tuple[str, bytes], ...]:
    """Valid files of every format but HDF5, with their endings."""
    found: list[tuple[str, bytes]] = []
    for dtype in (np.uint8, np.int16, np.float32):
        wav = io.BytesIO()
        scipy.io.wavfile.write(wav, 8000, (SAMPLES * 20 + 100).astype(dtype))
        found.append((".wav", wav.getvalue()))
    array, archive, packed = io.BytesIO(), io.BytesIO(), io.BytesIO()
    np.save(array, np.column_stack([SAMPLES, SAMPLES]))
    np.savez(archive, x=SAMPLES, fs=8000.0)
    np.savez_compressed(packed, x=SAMPLES, fs=8000.0)
    found += [(".npy", array.getvalue()), (".npz", archive.getvalue()), (".npz", packed.getvalue())]
    for compressed in (False, True):
        mat = io.BytesIO()
        variables = {"X097_DE_time": SAMPLES, "X097RPM": 1796.0, "s": {"gs": SAMPLES, "sr": 5.0}}
        scipy.io.savemat(mat, variables, do_compression=compressed)
        found.append((".mat", mat.getvalue()))
    table = pa.table({"time": np.arange(150) / 1000.0, "x": SAMPLES, "n": np.arange(150) % 5})
    for codec in ("snappy", "gzip"):
        parquet = io.BytesIO()
        pq.write_table(table, parquet, compression=codec, row_group_size=70)
        found.append((".parquet", parquet.getvalue()))
    rows = "\n".join(f"{k / 1000};{x:.5f}" for k, x in enumerate(SAMPLES))
    found.append((".csv", f"time (s);acc (g)\n{rows}\n".replace(".", ",").encode()))
    found.append((".csv", f"# fs = 100\nx,y\n{rows}\n".replace(";", ",").encode()))
    found += [(".uff", uff("text")), (".uff", uff("binary"))]
    return tuple(found)


@cache
def hdf5_seed() -> bytes:
    content = io.BytesIO()
    with h5py.File(content, "w") as file:
        data = file.create_dataset("g/x", data=SAMPLES, chunks=(40,), compression="gzip")
        data.attrs["fs"] = 1000.0
        data.attrs["unit"] = "g"
    return content.getvalue()


def check(file: Path) -> None:
    """Read a file; nothing may come out but signals or a short message."""
    start = time.monotonic()
    tracemalloc.start()
    try:
        channels = channels_of(file)
        rate = None if channels[-1].rate else 100.0
        with open_signal(file, channel=len(channels), rate=rate) as opened:
            for number, block in enumerate(opened.blocks(100, overlap=10)):
                assert isinstance(block, Signal)
                assert np.all(np.isfinite(block.samples))
                if number == 50:
                    break
    except InputError as error:
        assert str(error).isprintable()
        assert len(str(error)) < 1200
        assert error.source == str(file)
    finally:
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
    assert peak < MOST_MEMORY
    assert time.monotonic() - start < LONGEST


@st.composite
def damaged(draw: st.DrawFn, number: int) -> bytes:
    """A file that was cut, or of which bytes were changed, repeated or lost."""
    spoilt = bytearray(seeds()[number][1] if number >= 0 else hdf5_seed())
    last = len(spoilt) - 1
    # headers are where it hurts: most changes are near the ends
    near = st.integers(0, min(300, last))
    place = near | near.map(lambda back: last - back) | st.integers(0, last)
    for _ in range(draw(st.integers(1, 6))):
        at = min(draw(place), max(len(spoilt) - 1, 0))
        kind = draw(st.sampled_from(["bit", "byte", "number", "splinter", "cut", "lose", "repeat"]))
        if kind == "bit" and spoilt:
            spoilt[at] ^= 1 << draw(st.integers(0, 7))
        elif kind == "byte" and spoilt:
            spoilt[at] = draw(st.integers(0, 255))
        elif kind == "number":
            extreme = draw(st.sampled_from([0, 1, 2**31 - 1, 2**31, 2**32 - 1]))
            spoilt[at : at + 4] = struct.pack("<I", extreme)
        elif kind == "splinter":
            spoilt[at:at] = draw(st.sampled_from(SPLINTERS))
        elif kind == "cut":
            del spoilt[at:]
        elif kind == "lose":
            del spoilt[at : at + draw(st.integers(1, 60))]
        else:
            spoilt[at:at] = spoilt[at : at + draw(st.integers(1, 400))]
    return bytes(spoilt)


@within_bounds
@given(content=st.binary(max_size=400), ending=st.sampled_from(ENDINGS), number=st.integers(-1, 13))
def test_any_bytes(tmp_path: Path, content: bytes, ending: str, number: int) -> None:
    """Random bytes, alone or after the beginning of a valid file."""
    if number >= 0:
        ending, valid = seeds()[number]
        content = valid[: len(content) // 2] + content
    file = tmp_path / f"a{ending}"
    file.write_bytes(content)
    check(file)


@pytest.mark.parametrize("number", range(len(seeds())))
@within_bounds
@given(data=st.data())
def test_damaged_files(tmp_path: Path, number: int, data: st.DataObject) -> None:
    file = tmp_path / f"a{seeds()[number][0]}"
    file.write_bytes(data.draw(damaged(number)))
    check(file)


@given(text=st.text(alphabet="0123456789.,;+-eE\t\n \"'#abgns()[]é\r", max_size=200))
@within_bounds
def test_any_table(tmp_path: Path, text: str) -> None:
    file = tmp_path / "a.csv"
    file.write_text("time;x\n" + text, encoding="utf-8", newline="")
    check(file)


@pytest.mark.slow
@settings(max_examples=25, suppress_health_check=list(HealthCheck))
@given(data=st.data())
def test_damaged_hdf5(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, data: st.DataObject) -> None:
    """Each takes a process; some bring the HDF5 library down or round in circles."""
    monkeypatch.setattr(hdf5, "_PATIENCE", 4.0)
    file = tmp_path / "a.h5"
    file.write_bytes(data.draw(damaged(-1)))
    check(file)


def test_matlab_that_inflates_without_end(tmp_path: Path) -> None:
    mat = io.BytesIO()
    scipy.io.savemat(mat, {"x": SAMPLES})
    packed = zlib.compress(struct.pack("<II", 14, 1000) + bytes(50_000_000), 9)
    file = tmp_path / "a.mat"
    file.write_bytes(mat.getvalue()[:128] + struct.pack("<II", 15, len(packed)) + packed)
    check(file)
