"""Whatever a signal file holds: a signal or one sentence, soon, and within bounded memory.

What damage is done follows from one number that Hypothesis draws: drawing each step would take
longer than the reading.
"""

from __future__ import annotations

import io
import random
import struct
import time
import tracemalloc
import zlib
from functools import cache
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
import scipy.io
import scipy.io.wavfile
from hypothesis import HealthCheck, given, note, settings
from hypothesis import strategies as st

from rolamento.errors import InputError
from rolamento.io.foreign import isolated
from rolamento.vibration.reading import open_signal
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

MANY = 10
"""Files that are damaged for one example: an example takes longer than a file."""

within_bounds = settings(
    max_examples=10,
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
    """Valid files, with their endings, of the formats that are read without a process."""
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
def isolated_seeds() -> tuple[tuple[str, bytes], ...]:
    """Valid files of the formats that a process reads."""
    found: list[tuple[str, bytes]] = []
    content = io.BytesIO()
    with h5py.File(content, "w") as file:
        data = file.create_dataset("g/x", data=SAMPLES, chunks=(40,), compression="gzip")
        data.attrs["fs"] = 1000.0
        data.attrs["unit"] = "g"
    found.append((".h5", content.getvalue()))
    for compressed in (False, True):
        mat = io.BytesIO()
        variables = {"X097_DE_time": SAMPLES, "X097RPM": 1796.0, "s": {"gs": SAMPLES, "sr": 5.0}}
        scipy.io.savemat(mat, variables, do_compression=compressed)
        found.append((".mat", mat.getvalue()))
    return tuple(found)


def check(file: Path) -> None:
    """Read a file; nothing may come out but signals or a short message."""
    start = time.monotonic()
    tracemalloc.start()
    try:
        read(file)
    except InputError as error:
        assert str(error).isprintable()
        assert len(str(error)) < 1200
        assert error.source == str(file)
    finally:
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
    assert peak < MOST_MEMORY
    assert time.monotonic() - start < LONGEST


def read(file: Path) -> None:
    """Read the first channel in blocks, with the last one as the speed if there are several.

    What the file does not say is given, and a file is opened as rarely as can be: that of HDF5
    and of MATLAB starts a process each time.
    """
    given: dict[str, Any] = {"channel": 1}
    for _ in range(4):
        try:
            opened = open_signal(file, **given)
        except InputError as error:
            missing = {"rate": 100.0, "unit": "g", "speed_unit": "rpm"}.get(error.field)
            if missing is None or error.field in given:
                raise
            given[error.field] = missing
            continue
        with opened:
            if len(opened.channels) > 1 and "speed_channel" not in given:
                given["speed_channel"] = len(opened.channels)
                if not str(file).endswith((".h5", ".mat")):
                    continue
            for number, block in enumerate(opened.blocks(100, overlap=10)):
                assert isinstance(block, Signal)
                assert np.all(np.isfinite(block.samples))
                assert block.speed is None or np.all(np.isfinite(block.speed))
                if number == 50:
                    break
            return


def damaged(content: bytes, seed: int, most: int = 6) -> bytes:
    """Return a file that was cut, or of which bytes were changed, repeated or lost."""
    chance = random.Random(seed)
    spoilt = bytearray(content)
    last = len(spoilt) - 1
    for _ in range(chance.randint(1, most)):
        # headers are where it hurts: most changes are near the ends
        back = chance.randint(0, min(300, last))
        at = chance.choice([back, last - back, chance.randint(0, last)])
        at = min(at, max(len(spoilt) - 1, 0))
        kind = chance.choice(["bit", "byte", "number", "splinter", "cut", "lose", "repeat"])
        if kind == "bit" and spoilt:
            spoilt[at] ^= 1 << chance.randint(0, 7)
        elif kind == "byte" and spoilt:
            spoilt[at] = chance.randint(0, 255)
        elif kind == "number":
            extreme = chance.choice([0, 1, 2**31 - 1, 2**31, 2**32 - 1])
            spoilt[at : at + 4] = struct.pack("<I", extreme)
        elif kind == "splinter":
            spoilt[at:at] = chance.choice(SPLINTERS)
        elif kind == "cut":
            del spoilt[at:]
        elif kind == "lose":
            del spoilt[at : at + chance.randint(1, 60)]
        else:
            spoilt[at:at] = spoilt[at : at + chance.randint(1, 400)]
    return bytes(spoilt)


def written(directory: Path, ending: str, content: bytes) -> Path:
    """A new file: to write over one waits for the disk."""
    file = directory / f"a{ending}"
    file.unlink(missing_ok=True)
    file.write_bytes(content)
    return file


SEEDS = st.integers(0, 2**63 - 1)


@settings(within_bounds, max_examples=150)
@given(
    content=st.binary(max_size=400),
    ending=st.sampled_from(ENDINGS),
    number=st.integers(-1, len(seeds()) - 1),
)
def test_any_bytes(tmp_path: Path, content: bytes, ending: str, number: int) -> None:
    """Random bytes, alone or after the beginning of a valid file."""
    if number >= 0:
        ending, valid = seeds()[number]
        content = valid[: len(content) // 2] + content
    check(written(tmp_path, ending, content))


@pytest.mark.parametrize("number", range(len(seeds())))
@within_bounds
@given(seed=SEEDS)
@pytest.mark.thirds
def test_damaged_files(tmp_path: Path, number: int, seed: int) -> None:
    ending, valid = seeds()[number]
    for damage in range(seed, seed + MANY):
        note(f"damage {damage}")
        check(written(tmp_path, ending, damaged(valid, damage)))


@given(text=st.text(alphabet="0123456789.,;+-eE\t\n \"'#abgns()[]é\r", max_size=200))
@settings(within_bounds, max_examples=150)
def test_any_table(tmp_path: Path, text: str) -> None:
    check(written(tmp_path, ".csv", ("time;x\n" + text).encode()))


@pytest.mark.slow
@pytest.mark.parametrize("number", range(len(isolated_seeds())))
@settings(max_examples=10, suppress_health_check=list(HealthCheck))
@given(seed=SEEDS)
@pytest.mark.thirds
def test_damaged_files_of_a_process(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: int, seed: int
) -> None:
    """Some bring their library down, or round in circles."""
    monkeypatch.setattr(isolated, "PATIENCE", 2.0)
    ending, valid = isolated_seeds()[number]
    check(written(tmp_path, ending, damaged(valid, seed, most=2)))


def test_matlab_that_inflates_without_end(tmp_path: Path) -> None:
    mat = io.BytesIO()
    scipy.io.savemat(mat, {"x": SAMPLES})
    packed = zlib.compress(struct.pack("<II", 14, 1000) + bytes(50_000_000), 9)
    file = tmp_path / "a.mat"
    file.write_bytes(mat.getvalue()[:128] + struct.pack("<II", 15, len(packed)) + packed)
    check(file)
