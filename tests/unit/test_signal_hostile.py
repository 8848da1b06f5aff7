"""Files that mean harm, or are broken in the worst way: one sentence, soon, in little memory."""

from __future__ import annotations

import io
import os
import pickle
import struct
import time
import tracemalloc
import zipfile
import zlib
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
import scipy.io
import scipy.io.wavfile

from rolamento.errors import InputError
from rolamento.vibration.reading import open_signal, parquet, read_signal

SAMPLES = np.random.default_rng(2).normal(size=300)
MOST_MEMORY = 60 * 2**20
LONGEST = 20.0
"""Seconds; each takes a fraction of one where nothing else runs."""


def refused(path: Path, message: str, **arguments: Any) -> None:
    """Check that reading a file ends in one sentence, in bounded time and memory."""
    begin = time.monotonic()
    tracemalloc.start()
    try:
        with pytest.raises(InputError, match=message) as caught:
            read_signal(path, **{"rate": 100.0, **arguments})
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert str(caught.value).startswith(str(path))
    assert str(caught.value).isprintable()
    assert len(str(caught.value)) < 1200
    assert peak < MOST_MEMORY
    assert time.monotonic() - begin < LONGEST


class Trap:
    """An object whose pickle makes a directory when it is loaded."""

    def __init__(self, mark: Path) -> None:
        self._mark = mark

    def __reduce__(self) -> tuple[Any, ...]:
        return os.mkdir, (str(self._mark),)


@pytest.fixture
def trap(tmp_path: Path) -> tuple[Trap, Path]:
    """The trap works, and where it would leave its mark."""
    mark = tmp_path / "sprung"
    pickle.loads(pickle.dumps(Trap(mark)))
    mark.rmdir()
    return Trap(mark), mark


def npy(shape: str, descr: str = "'<f8'", content: bytes = bytes(80)) -> bytes:
    text = f"{{'descr': {descr}, 'fortran_order': False, 'shape': {shape}, }}".ljust(117) + "\n"
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(text)) + text.encode() + content


# what is no regular file


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no pipes with names")
def test_pipes_and_devices_are_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.wav")
    (tmp_path / "to_pipe.csv").symlink_to("pipe.wav")
    (tmp_path / "to_device.npy").symlink_to("/dev/zero")
    for name in ("pipe.wav", "to_pipe.csv", "to_device.npy"):
        refused(tmp_path / name, "is not a regular file")
    refused(Path("/dev/zero"), "is not a regular file")


def test_links(tmp_path: Path) -> None:
    np.save(tmp_path / "a.npy", SAMPLES)
    (tmp_path / "good.npy").symlink_to("a.npy")
    assert len(read_signal(tmp_path / "good.npy", rate=100.0).samples) == len(SAMPLES)
    (tmp_path / "nowhere.npy").symlink_to("missing.npy")
    refused(tmp_path / "nowhere.npy", "no such file")
    (tmp_path / "round.npy").symlink_to("round.npy")
    refused(tmp_path / "round.npy", "too many levels of symbolic links")


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="may read everything")
def test_file_that_may_not_be_read(tmp_path: Path) -> None:
    np.save(tmp_path / "a.npy", SAMPLES)
    (tmp_path / "a.npy").chmod(0)
    refused(tmp_path / "a.npy", "permission denied")


@pytest.mark.parametrize(
    ("name", "head", "message"),
    [
        ("a.npy", npy("(137438953472,)", content=b""), "must be at most 100 000 000 at once"),
        ("a.csv", b"a\n1\n2\n", "a text table is read up to 16 GB"),
        ("a.parquet", b"PAR1", "is not a readable Parquet file"),
        ("a.mat", b"MATLAB".ljust(124) + b"\0\1IM", "is read whole, up to 512 MB"),
        ("a.npz", b"PK\x03\x04", "is read whole, up to 512 MB"),
        ("a.uff", b"    -1\n    58\n", "is read whole, up to 512 MB"),
        ("a.h5", b"\x89HDF\r\n\x1a\n", "is not a readable HDF5 file"),
    ],
)
def test_files_of_a_terabyte(tmp_path: Path, name: str, head: bytes, message: str) -> None:
    """Files with a hole take no room on the disk, and may be as long as one likes."""
    with (tmp_path / name).open("wb") as file:
        file.write(head)
        try:
            file.truncate(2**40 + len(head))
        except OSError:
            pytest.skip("the file system knows no holes")
    refused(tmp_path / name, message)


# archives of NumPy


def archive(path: Path, member: bytes, *, kind: int = zipfile.ZIP_DEFLATED) -> None:
    with zipfile.ZipFile(path, "w", kind) as file:
        file.writestr("x.npy", member)


def with_declared_size(path: Path, size: int) -> None:
    """Write another size of the one member into the list of an archive."""
    content = bytearray(path.read_bytes())
    place = content.rindex(b"PK\x01\x02")
    content[place + 24 : place + 28] = struct.pack("<I", size)
    path.write_bytes(content)


def test_npz_that_says_it_inflates_too_far(tmp_path: Path) -> None:
    archive(tmp_path / "a.npz", npy("(10,)"))
    with_declared_size(tmp_path / "a.npz", 2**30)
    refused(tmp_path / "a.npz", "inflates to more than 512 MB")


def test_npz_that_inflates_further_than_it_says(tmp_path: Path) -> None:
    archive(tmp_path / "a.npz", npy("(20000000,)", content=bytes(160_000_000)))
    assert (tmp_path / "a.npz").stat().st_size < 200_000
    with_declared_size(tmp_path / "a.npz", 300)
    refused(tmp_path / "a.npz", "does not fit into it|bad crc-32")


def test_npz_of_other_compressions(tmp_path: Path) -> None:
    """That of LZMA may ask for gigabytes before it gives a byte."""
    for kind in (zipfile.ZIP_LZMA, zipfile.ZIP_BZIP2):
        archive(tmp_path / "a.npz", npy("(10,)"), kind=kind)
        refused(tmp_path / "a.npz", "is compressed in another way than by numpy")


def test_npz_with_a_password(tmp_path: Path) -> None:
    archive(tmp_path / "a.npz", npy("(10,)"), kind=zipfile.ZIP_STORED)
    content = bytearray((tmp_path / "a.npz").read_bytes())
    for mark, place in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        content[content.index(mark) + place] |= 1
    (tmp_path / "a.npz").write_bytes(content)
    refused(tmp_path / "a.npz", "is encrypted")


def test_npz_with_members_without_end(tmp_path: Path) -> None:
    """Fifty thousand entries in the list, which Python makes objects of."""
    one = struct.pack("<4s6H3I5H2I", b"PK\1\2", 20, 20, *[0] * 7, 5, *[0] * 6) + b"a.npy"
    count, begin = 50_000, 30
    end = begin + count * len(one)
    tail = struct.pack("<4sQ2H2I4Q", b"PK\6\6", 44, 45, 45, 0, 0, count, count, end - begin, begin)
    tail += struct.pack("<4sIQI", b"PK\6\7", 0, end, 1)
    tail += struct.pack("<4s4H2IH", b"PK\5\6", 0, 0, 65535, 65535, 2**32 - 1, 2**32 - 1, 0)
    (tmp_path / "a.npz").write_bytes(b"PK\3\4" + bytes(begin - 4) + one * count + tail)
    refused(tmp_path / "a.npz", "has more than 10 000 arrays")


# what would have to be executed


def test_pickles_are_not_loaded(tmp_path: Path, trap: tuple[Trap, Path]) -> None:
    objects = np.array([trap[0]], dtype=object)
    np.save(tmp_path / "a.npy", objects, allow_pickle=True)
    refused(tmp_path / "a.npy", "must be real numbers: arrays of objects")
    np.savez(tmp_path / "a.npz", x=objects, allow_pickle=True)
    refused(tmp_path / "a.npz", "NumPy archive without a channel of real numbers")
    (tmp_path / "b.npy").write_bytes(pickle.dumps(trap[0]))
    refused(tmp_path / "b.npy", "is not a NumPy file, although its name says so")
    assert not trap[1].exists()


def test_headers_are_not_evaluated(tmp_path: Path, trap: tuple[Trap, Path]) -> None:
    command = f"__import__('os').mkdir('{trap[1]}')"
    for shape, descr in ((f"({command},)", "'<f8'"), ("(10,)", f"[{command}]"), ("(10,)", command)):
        (tmp_path / "a.npy").write_bytes(npy(shape, descr))
        refused(tmp_path / "a.npy", "is not a readable NumPy array: |must be real numbers")
    assert not trap[1].exists()


def test_parquet_types_of_python_are_not_loaded(tmp_path: Path, trap: tuple[Trap, Path]) -> None:
    about = {
        b"ARROW:extension:name": b"arrow.py_extension_type",
        b"ARROW:extension:metadata": pickle.dumps(trap[0]),
    }
    schema = pa.schema([pa.field("x", pa.float64(), metadata=about)])
    pq.write_table(pa.table([pa.array(SAMPLES)], schema=schema), tmp_path / "a.parquet")
    signal = read_signal(tmp_path / "a.parquet", rate=100.0)
    np.testing.assert_array_equal(signal.samples, SAMPLES)
    assert not trap[1].exists()


# sizes that are declared


@pytest.mark.parametrize(
    "shape",
    ["(1152921504606846976,)", "(999999999999999, 2)", "(11,)", "(99999999999, 99999999999)"],
)
def test_npy_that_declares_too_much(tmp_path: Path, shape: str) -> None:
    (tmp_path / "a.npy").write_bytes(npy(shape))
    refused(tmp_path / "a.npy", "does not fit into it|has a shape that is not one")


def test_npy_with_a_header_without_end(tmp_path: Path) -> None:
    (tmp_path / "a.npy").write_bytes(b"\x93NUMPY\x02\x00" + b"\xff\xff\xff\x7f" + b" " * 1000)
    refused(tmp_path / "a.npy", "is not a readable NumPy array: eof: reading array header")


def wav(data: bytes, *, channels: int = 1, rate: int = 8000, size: bytes = b"\xff" * 4) -> bytes:
    form = struct.pack("<HHIIHH", 1, channels, rate, 2 * rate, (2 * channels) % 65536, 16)
    return b"RIFF" + size + b"WAVEfmt " + struct.pack("<I", 16) + form + data


@pytest.mark.parametrize(
    ("content", "message"),
    [
        # of a recorder that did not know the size: what is there is read
        (wav(b"data\xf0\xff\xff\xff" + bytes(100)), "is constant over 50 samples"),
        (
            wav(b"data\x64\0\0\0" + bytes(100), size=b"\xf0\xff\xff\x7f"),
            "declares 2 147 483 640 bytes, and there are 144",
        ),
        (
            b"RF64\xff\xff\xff\xffWAVE"
            + b"ds64"
            + struct.pack("<IQQQI", 28, 2**63, 2**63, 0, 0)
            + wav(b"")[12:],
            "declares 9 223 372 036 854 775 816 bytes",
        ),
        (wav(b"data\x64\0\0\0" + bytes(100), channels=65535), "is not a readable WAV file"),
        (wav(b"data\x64\0\0\0" + bytes(100), channels=0), "is not a readable WAV file"),
        (wav(b"data\x64\0\0\0" + bytes(100), rate=0), "is not a readable WAV file"),
        (wav(b"LIST\0\0\0\0" * 5000), "is not a readable WAV file"),
        (wav(b"data\0\0\0\0"), "has no samples"),
        (wav(b""), "is not a readable WAV file"),
    ],
)
def test_wav_that_is_wrong(tmp_path: Path, content: bytes, message: str) -> None:
    (tmp_path / "a.wav").write_bytes(content)
    refused(tmp_path / "a.wav", message)


def matrix(shape: tuple[int, int], numbers: bytes, kind: int = 6) -> bytes:
    """An array of MATLAB named x."""
    inner = struct.pack("<IIII", 6, 8, kind, 0) + struct.pack("<IIii", 5, 8, *shape)
    inner += struct.pack("<HHI", 1, 1, ord("x")) + numbers
    return struct.pack("<II", 14, len(inner)) + inner


def doubles(size: int, content: bytes = bytes(80)) -> bytes:
    return struct.pack("<II", 9, size) + content


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (matrix((2**31 - 1, 2**31 - 1), doubles(80)), "declares 3.436e10 GB and has"),
        (matrix((-10, 1), doubles(80)), "is constant over 10 samples"),
        (matrix((-10, -1), doubles(80)), "is not a readable MATLAB file"),
        (matrix((10, 1), doubles(2**32 - 1)), "asks for more memory"),
        (matrix((9, 1), doubles(80)), "cannot reshape"),
        (matrix((10, 1), struct.pack("<II", 99, 80) + bytes(80)), "the library .* broke off|."),
        (bytes(8 * 300_000), "is not a readable MATLAB file"),
        (matrix((0, 0), doubles(0, b"")) * 10_001, "MATLAB file that holds x: nothing, which is"),
        (struct.pack("<II", 15, 2**32 - 1) + bytes(80), "is not a readable MATLAB file"),
        (struct.pack("<II", 15, 80) + bytes(80), "is not a readable MATLAB file"),
    ],
)
@pytest.mark.thirds
def test_matlab_that_is_wrong(tmp_path: Path, content: bytes, message: str) -> None:
    (tmp_path / "a.mat").write_bytes(b"MATLAB".ljust(124) + b"\0\1IM" + content)
    refused(tmp_path / "a.mat", message)


def test_matlab_in_itself(tmp_path: Path) -> None:
    """Structures are followed to a depth, and what is in cells not at all."""
    nested: Any = SAMPLES
    for _ in range(40):
        nested = {"deeper": nested}
    scipy.io.savemat(tmp_path / "a.mat", {"s": nested, "c": np.array([SAMPLES, 1.0], dtype=object)})
    refused(
        tmp_path / "a.mat",
        "is a MATLAB file that holds s: a structure, c: cells or objects, which is not read, and "
        "no channel of real numbers",
    )


def test_hdf5_that_declares_too_much(tmp_path: Path) -> None:
    with h5py.File(tmp_path / "a.h5", "w") as file:
        file.create_dataset("x", (10**15,), "f8", chunks=(1000,), compression="gzip")
    refused(tmp_path / "a.h5", r"declares 7\.451e6 GB and has .* kB; a file may")
    with h5py.File(tmp_path / "b.h5", "w") as file:
        file.create_dataset("x", (10**6,), "f8", chunks=(40_000_000,), maxshape=(None,))
    refused(tmp_path / "b.h5", '"x" has chunks of more than 64 MB')


def test_hdf5_of_unwritten_samples(tmp_path: Path) -> None:
    """As many as a file of its size may declare are read: what was never written is 0."""
    with h5py.File(tmp_path / "a.h5", "w") as file:
        file.create_dataset("x", (8_000_000,), "f8", chunks=(1000,), compression="gzip")
    with open_signal(tmp_path / "a.h5", rate=100.0) as file:
        assert not np.any(file.read(7_000_000, 5000).samples)


@pytest.mark.parametrize("kind", ["f8", "i1"])
@pytest.mark.thirds
def test_arrays_that_repeat_one_number(tmp_path: Path, kind: str) -> None:
    """100 kB that inflate to 100 MB, or to as many samples of one byte each."""
    count = 100_000_000 // np.dtype(kind).itemsize
    matrix = struct.pack("<IIIIII", 6, 8, 6 if kind == "f8" else 8, 0, 5, 8)
    matrix += struct.pack("<iiHH4s", count, 1, 1, 1, b"x") + struct.pack(
        "<II", 9 if kind == "f8" else 1, 100_000_000
    )
    compressor = zlib.compressobj(9)
    pieces = [compressor.compress(struct.pack("<II", 14, len(matrix) + 100_000_000) + matrix)]
    pieces += [compressor.compress(bytes(10**6)) for _ in range(100)]
    inner = b"".join([*pieces, compressor.flush()])
    mark = b"MATLAB".ljust(124) + b"\0\1IM"
    (tmp_path / "a.mat").write_bytes(mark + struct.pack("<II", 15, len(inner)) + inner)
    assert (tmp_path / "a.mat").stat().st_size < 600_000
    refused(tmp_path / "a.mat", "a file may declare 32 times its size, or 64 MB")
    with (
        zipfile.ZipFile(tmp_path / "a.npz", "w", zipfile.ZIP_DEFLATED) as file,
        file.open("x.npy", "w") as member,
    ):
        member.write(npy(f"({count},)", repr(np.dtype(kind).str), b""))
        for _ in range(100):
            member.write(bytes(10**6))
    refused(tmp_path / "a.npz", "a file may declare 32 times its size, or 64 MB")


@pytest.mark.parametrize("storage", [{"compression": "lzf"}, {"fletcher32": True}])
def test_hdf5_of_any_compression_that_the_library_has(
    tmp_path: Path, storage: dict[str, Any]
) -> None:
    with h5py.File(tmp_path / "a.h5", "w") as file:
        file.create_dataset("x", data=SAMPLES, chunks=(100,), **storage)
    samples = read_signal(tmp_path / "a.h5", rate=100.0).samples
    np.testing.assert_array_equal(samples, SAMPLES)


def test_hdf5_attribute_without_end(tmp_path: Path) -> None:
    with h5py.File(tmp_path / "a.h5", "w", libver="latest") as file:
        data = file.create_dataset("x", data=SAMPLES)
        data.attrs["note"] = "x" * 20_000_000
        data.attrs["table"] = np.zeros((1000, 1000))
        for number in range(300):
            data.attrs[f"a{number}"] = number
    assert len(read_signal(tmp_path / "a.h5", rate=100.0).samples) == len(SAMPLES)


def test_parquet_with_groups_of_too_many_rows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A few bytes may stand for any number of rows that are alike."""
    monkeypatch.setattr(parquet, "MOST_SAMPLES", 1_000_000)
    column = pa.array(np.zeros(1_000_001, np.int8))
    pq.write_table(pa.table({"x": column}), tmp_path / "a.parquet", row_group_size=2_000_000)
    assert (tmp_path / "a.parquet").stat().st_size < 10_000
    refused(tmp_path / "a.parquet", "rows in a group = 1000001: must be at most 1 000 000")


@pytest.mark.parametrize("place", ["head", "pages", "foot"])
def test_parquet_that_is_damaged(tmp_path: Path, place: str) -> None:
    """Among others, statistics that do not fit their column brought the program down."""
    whole = io.BytesIO()
    pq.write_table(pa.table({"time": np.arange(300) / 100, "x": SAMPLES}), whole)
    content = whole.getvalue()
    chance = np.random.default_rng(17)
    ranges = {"head": (4, 200), "pages": (200, 2000), "foot": (len(content) - 1500, len(content))}
    for _ in range(60):
        wrong = bytearray(content)
        wrong[int(chance.integers(*ranges[place]))] ^= 1 << int(chance.integers(8))
        (tmp_path / "a.parquet").unlink(missing_ok=True)
        (tmp_path / "a.parquet").write_bytes(wrong)
        try:
            assert np.all(np.isfinite(read_signal(tmp_path / "a.parquet", channel=1).samples))
        except InputError as error:
            assert error.source == str(tmp_path / "a.parquet")


# tables of text


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"7" * 20_000_000, "has no table of numbers in its first lines"),
        (b"1;2\n3;4\n" + b"5" * 20_000_000, "has a line of more than 64 kB"),
        (b'"' * 60_000 + b"\n1;2\n", "."),
        (b'1;"2\n' * 20_000, "."),
        (b"1\n" + b"9" * 59 + b"\n1e308\n", "must be finite numbers of magnitude up to 1e60"),
        (b"1\n2\n1e400\n", "1 of 3 samples are not finite numbers; the first is sample 2"),
        (b"1\nnan\n2\n", "1 of 3 samples are not finite numbers; the first is sample 1"),
        (b"1\n-inf\n2\n", "1 of 3 samples are not finite numbers"),
        (b"fs: -100\nx\n1\n2\n", "rate: is not in the file"),
        (b"fs: 0\nx\n1\n2\n", "rate: is not in the file"),
        (b"fs: 1e308\nx\n1\n2\n", "rate: is not in the file"),
        (b"dt: -0.01\nx\n1\n2\n", "rate: is not in the file"),
        (
            b"fs: 1e11\nx\n1\n2\n",
            "rate = 100000000000.0: must be a number greater than 0 and at most 1e9",
        ),
        (b"time;x\n2;1\n1;2\n0;1\n", "does not increase from the first row to the last"),
        (b"time;x\n0;1\n1e308;2\n2e308;1\n", "does not increase from the first row to the last"),
        (b"time;x\n0;1\nnan;2\n2;1\n", "is not evenly spaced: sample 1"),
        (b",".join([b"1"] * 1001) + b"\n", "number of columns = 1001: must be at most 1000"),
        (b"a\t" * 95 + b"\n" + (b"a" + b" \t" * 95 + b"\n") * 300, "has no table of numbers"),
    ],
)
def test_tables_that_are_wrong(tmp_path: Path, content: bytes, message: str) -> None:
    (tmp_path / "a.csv").write_bytes(content)
    names = content.startswith((b"fs", b"dt", b"time"))
    refused(tmp_path / "a.csv", message, **({"rate": None} if names else {}))


# universal files


def universal(step: float, count: int) -> bytes:
    shape = f"{4:10d}{count:10d}{1:10d}{0.0:13.5e}{step:13.5e}{0.0:13.5e}"
    axes = [f"{kind:10d}{0:5d}{0:5d}{0:5d} {'NONE':20s} {'g':20s}" for kind in (17, 12, 0, 0)]
    point = f"{1:5d}{0:10d}{0:5d}{0:10d} {'A':10s}{1:10d}{3:4d} {'NONE':10s}{0:10d}{0:4d}"
    head = "\n".join([*["id"] * 5, point, shape, *axes])
    return f"    -1\n    58\n{head}\n{1.0:20.11e}{2.0:20.11e}\n    -1\n".encode()


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (universal(1e-3, 2**31 - 1), "a record is too short"),
        (universal(1e-3, 30), "ends before its last sample: 2 of 30"),
        (universal(-1e-3, 2), "rate: is not in the file"),
        (universal(0.0, 2), "rate: is not in the file"),
        (b"    -1\n    58\n" + b"    -1x" * 3_000_000, "without a channel of real numbers"),
        (b"    -1\n    58\n" + b"\n    -1x" * 3_000_000, "without a channel of real numbers"),
        (b"    -1\n    58\n" + b"    -1\n" * 1_000_000, "has more than 10 000 data sets"),
        (b"    -1\n    58\n" + b"    -1" + b" " * 20_000_000, "without a channel of real numbers"),
    ],
)
def test_universal_files_that_are_wrong(tmp_path: Path, content: bytes, message: str) -> None:
    (tmp_path / "a.uff").write_bytes(content)
    refused(tmp_path / "a.uff", message, rate=None)


# numbers that are none, in every format


def write(path: Path, numbers: Any, rate: float) -> None:
    if path.suffix == ".npz":
        np.savez(path, x=numbers, fs=rate)
    elif path.suffix == ".mat":
        scipy.io.savemat(path, {"x": numbers, "fs": rate})
    elif path.suffix == ".parquet":
        table = pa.table({"x": numbers}).replace_schema_metadata({"fs": str(rate)})
        pq.write_table(table, path)
    else:
        with h5py.File(path, "w") as file:
            file.create_dataset("x", data=numbers).attrs["fs"] = rate


@pytest.mark.parametrize("name", ["a.npz", "a.mat", "a.parquet", "a.h5"])
def test_numbers_that_are_none(tmp_path: Path, name: str) -> None:
    for rate in (-100.0, 1e308, float("nan")):
        write(tmp_path / name, SAMPLES, rate)
        refused(tmp_path / name, "rate: is not in the file; give it", rate=None)
    for value, message in (
        (float("nan"), r"1 of 300 samples are not finite .* sample 7 .*0.07 s"),
        (float("-inf"), r"1 of 300 samples are not finite .* sample 7 "),
        (1e308, r"must be finite numbers of magnitude up to 1e60; number 7 is not"),
    ):
        wrong = SAMPLES.copy()
        wrong[7] = value
        write(tmp_path / name, wrong, 100.0)
        refused(tmp_path / name, message, scale="10 g")


def test_floats_that_signal(tmp_path: Path) -> None:
    """A NaN that NumPy warns of as it is converted is refused as any other."""
    wrong = SAMPLES.astype(np.float32)
    wrong.view(np.uint32)[7] = 0x7F800001
    scipy.io.wavfile.write(tmp_path / "a.wav", 100, wrong)
    np.save(tmp_path / "a.npy", wrong)
    scipy.io.savemat(tmp_path / "a.mat", {"x": wrong})
    for name in ("a.wav", "a.npy", "a.mat"):
        refused(tmp_path / name, "1 of 300 samples are not finite .* sample 7 ")


@pytest.mark.parametrize("rate", [-1.0, 0, 1e308, float("nan"), "100", True, [1.0]])
def test_rates_that_are_none(tmp_path: Path, rate: Any) -> None:
    np.save(tmp_path / "a.npy", SAMPLES)
    refused(
        tmp_path / "a.npy",
        "rate = .*: must be a number greater than 0 and at most 1e9",
        rate=rate,
    )


def test_matlab_that_inflates_in_pieces(tmp_path: Path) -> None:
    """Many variables that are small each, and together too large."""
    inner = struct.pack("<II", 14, 60_000_000)
    piece = zlib.compress(inner, 9)
    one = struct.pack("<II", 15, len(piece)) + piece
    (tmp_path / "a.mat").write_bytes(b"MATLAB".ljust(124) + b"\0\1IM" + one)
    refused(tmp_path / "a.mat", "is not a readable MATLAB file")
