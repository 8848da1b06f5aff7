"""Kill runs, break what they need, feed them damaged files: `python -m benchmarks.faults`.

Each trial ends well, or it is counted as what it was: a traceback, a crash, an end that is late,
a result that differs, memory beyond the bound. The exit code is 1 if there is any of those.

Options: --count N (damaged files of each kind), --kills N, --only NAMES, --seed N,
--markdown FILE (writes docs/faults.md).
"""

from __future__ import annotations

import argparse
import http.server
import importlib
import io
import json
import os
import random
import re
import resource
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import traceback
import zipfile
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from types import SimpleNamespace
from typing import Final

import h5py
import numpy as np
import openpyxl
import scipy.io
from typer.testing import CliRunner

import rolamento
from rolamento.cli.app import app
from rolamento.io.foreign import isolated

STUDY: Final = """
title = "Faults"
case = "case.toml"
outputs = ["x", "max_inner_load", "inner_load"]

[scatter]
count = {count}

[scatter.fields."duty.load.fx"]
distribution = "uniform"
minimum = "10 kN"
maximum = "40 kN"
"""
EXAMPLE: Final = Path(rolamento.__file__).parent / "examples" / "218_combined.toml"
MAIN: Final = "from rolamento.cli import main; main()"
LONGEST: Final = {"kills": 120.0, "faults": 120.0, "cluster": 15.0, "files": 45.0}
"""Seconds that a trial may take: a few times the bound of the readers, half a minute to compile."""
MOST_MEMORY: Final = 1.2e9
"""Bytes of a process that reads a damaged file, Matplotlib and SciPy among them."""

EVERY: Final = 10.0
"""Seconds between two lines about how far a kind of trial has come."""


@dataclass(slots=True)
class Tried:
    """What came of many trials of one kind."""

    name: str
    outcomes: Counter[str] = field(default_factory=Counter)
    bad: list[str] = field(default_factory=list)
    longest: float = 0.0
    memory: float = 0.0
    shown: float = field(default_factory=time.monotonic)

    @property
    def trials(self) -> int:
        """How many there were."""
        return sum(self.outcomes.values())

    def take(self, outcome: str, ended: Ended, longest: float, what: str) -> None:
        """Count a trial."""
        self.longest = max(self.longest, ended.seconds)
        self.memory = max(self.memory, ended.memory)
        wrong = ended.wrong(longest)
        self.outcomes[wrong or outcome] += 1
        if wrong:
            self.bad.append(f"{what}: {wrong}: {ended.said[-300:]}")
        if time.monotonic() - self.shown > EVERY:
            self.shown = time.monotonic()
            print(f"{self.name}: {self.trials} so far, {len(self.bad)} bad", file=sys.stderr)


@dataclass(frozen=True, slots=True)
class Ended:
    """How a process ended; memory: the most that it, or a process of its own, has held."""

    code: int
    said: str
    seconds: float
    memory: float

    def wrong(self, longest: float) -> str:
        """What is wrong with that, if anything."""
        if "Traceback" in self.said or "Exception ignored" in self.said:
            return "traceback"
        if self.code not in (0, 1, 2, 130):
            return f"crash ({self.code})"
        if self.code == 2 and self.said.count("\n") != 1:
            return "not one message"
        if self.seconds > longest:
            return "late"
        return "memory" if self.memory > MOST_MEMORY else ""


def command(folder: Path, *arguments: str, limit: int = 0, longest: float = 300.0) -> Ended:
    """Run the command line; limit: bytes of the largest file that it may write."""

    def bounded() -> None:
        if limit:
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, resource.RLIM_INFINITY))

    began = time.monotonic()
    process = subprocess.Popen(
        [sys.executable, "-c", MAIN, *arguments],
        cwd=folder,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,  # a file would be bounded too
        text=True,
        preexec_fn=bounded,
    )
    timer = threading.Timer(longest, process.kill)
    timer.start()
    with process.stderr as stream:
        text = stream.read()
    _, status, usage = os.wait4(process.pid, 0)
    timer.cancel()
    process.returncode = os.waitstatus_to_exitcode(status)
    seconds = time.monotonic() - began
    return Ended(process.returncode, text, seconds, usage.ru_maxrss * 1024.0)


# --- runs that are killed -------------------------------------------------------------------


def kills(folder: Path, count: int, seed: int) -> Iterator[Tried]:
    """Sweeps ended at random moments; the file that comes out in the end is the same."""
    rng = random.Random(seed)
    _write_study(folder, 150_000)
    command(folder, "sweep", "study.toml", "-o", "straight.nc")  # kernels are compiled and kept
    began = time.monotonic()
    straight = command(folder, "sweep", "study.toml", "-o", "straight.nc")
    assert straight.code == 0, straight.said
    whole, took = (folder / "straight.nc").read_bytes(), time.monotonic() - began
    for how in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
        tried = Tried(f"sweep ended by {how.name} and resumed")
        for _ in range(count):
            stopped = _stopped(folder, how, rng.uniform(0.1, 1.0) * took)
            ended = command(folder, "sweep", "study.toml", "-o", "killed.nc")
            seconds = max(ended.seconds, stopped.seconds)
            both = Ended(ended.code, stopped.said + ended.said, seconds, ended.memory)
            result = folder / "killed.nc"
            same = result.exists() and result.read_bytes() == whole
            tried.take("the same file" if same else "differs", both, LONGEST["kills"], how.name)
            if not same:
                tried.bad.append(f"{how.name}: the file differs")
            result.unlink(missing_ok=True)
        yield tried


def _stopped(folder: Path, how: signal.Signals, after: float) -> Ended:
    """Start a sweep and end it; seconds: from the signal to the end."""
    process = subprocess.Popen(
        [sys.executable, "-c", MAIN, "sweep", "study.toml", "-o", "killed.nc"],
        cwd=folder,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )
    time.sleep(after)
    process.send_signal(how)
    sent = time.monotonic()
    _, said = process.communicate()
    return Ended(process.returncode, said, time.monotonic() - sent, 0.0)


# --- disks, caches --------------------------------------------------------------------------


def faults(folder: Path, count: int, seed: int) -> Iterator[Tried]:
    """Full disks while each kind of result is written, and damaged kernel caches."""
    rng = random.Random(seed)
    _write_study(folder, 20_000)
    for name in ("r.nc", "r.csv", "r.parquet"):
        tried = Tried(f"full disk, {name[2:]}")
        for _ in range(count):
            limit = round(10 ** rng.uniform(0.0, 7.0))
            ended = command(folder, "sweep", "study.toml", "-o", name, "--restart", limit=limit)
            tried.take("result" if ended.code == 0 else "message", ended, LONGEST["faults"], name)
            if ended.code and (folder / name).exists():
                tried.bad.append(f"{name}: half a file")
            (folder / name).unlink(missing_ok=True)
        yield tried
    _write_study(folder, 1_000)
    tried = Tried("full disk, JSON, CSV and figures")
    for name, option in (("s.json", "--json"), ("s.csv", "--csv")):
        for limit in (1, 100, 1000):
            ended = command(folder, "solve", "case.toml", option, name, limit=limit)
            tried.take("message", ended, LONGEST["faults"], name)
            if (folder / name).exists():
                tried.bad.append(f"{name}: half a file")
    yield tried
    yield _caches(folder, rng)


def _caches(folder: Path, rng: random.Random) -> Tried:
    """Compiled code that is damaged, in a cache of its own."""
    tried = Tried("kernel cache damaged")
    kept = folder / "kernels"
    os.environ |= {"NUMBA_CACHE_DIR": str(kept), "ROLAMENTO_COMPILE": "here"}
    try:
        command(folder, "sweep", "study.toml", "-o", "k.nc")
        for ending in ("nbi", "nbc"):
            for _ in range(2):
                files = sorted(kept.rglob(f"*.{ending}"), key=lambda p: p.stat().st_size)
                content = bytearray(files[-1].read_bytes())
                content[rng.randrange(len(content))] ^= 0xFF
                files[-1].write_bytes(content[: rng.choice((len(content), len(content) // 2))])
                ended = command(folder, "sweep", "study.toml", "-o", "k.nc")
                tried.take(f"exit code {ended.code}", ended, LONGEST["faults"], ending)
        ended = command(folder, "sweep", "study.toml", "-o", "k.nc")
        tried.take(f"exit code {ended.code}", ended, LONGEST["faults"], "mended")
        if ended.said:
            tried.bad.append(f"mended: {ended.said}")
    finally:
        del os.environ["NUMBA_CACHE_DIR"], os.environ["ROLAMENTO_COMPILE"]
        shutil.rmtree(kept, ignore_errors=True)
    return tried


# --- clusters -------------------------------------------------------------------------------


def cluster(folder: Path, count: int, seed: int) -> Iterator[Tried]:
    """Whatever may stand at the address of a scheduler."""
    _write_study(folder, 1_000)
    tried = Tried("no Dask scheduler at the address")
    with _web() as web, _silent() as silent:
        for address in ("abc", "tcp://127.0.0.1:9", "ftp://127.0.0.1:21", web, silent):
            ended = command(
                folder, "sweep", "study.toml", "-o", "r.nc", "--scheduler", address
            )  # fmt: skip
            tried.take(f"exit code {ended.code}", ended, LONGEST["cluster"], address)
    yield tried


@contextmanager
def _web() -> Iterator[str]:
    class Silent(http.server.BaseHTTPRequestHandler):
        def log_message(self, *_: object) -> None:
            """Say nothing."""

    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), Silent) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"tcp://127.0.0.1:{server.server_address[1]}"
        server.shutdown()


@contextmanager
def _silent() -> Iterator[str]:
    with socket.socket() as listening:
        listening.bind(("127.0.0.1", 0))
        listening.listen()
        yield f"tcp://127.0.0.1:{listening.getsockname()[1]}"


# --- damaged and hostile files --------------------------------------------------------------


def files(folder: Path, count: int, seed: int) -> Iterator[Tried]:
    """Files with wrong bytes and missing ends, and small ones that inflate."""
    rng = random.Random(seed)
    _write_study(folder, 300)
    command(folder, "sweep", "study.toml", "-o", "seed.nc")
    command(folder, "solve", "case.toml", "--json", "seed.json")
    signal_of = np.random.default_rng(seed).normal(size=4000)
    _write_record(folder / "seed.h5", signal_of)
    scipy.io.savemat(folder / "seed.mat", {"acc": signal_of, "fs": 12e3}, do_compression=True)
    np.savez_compressed(folder / "seed.npz", acc=signal_of, fs=np.array(12e3))
    rows = "".join(f"{n / 12e3:.9f},{value:.6g}\n" for n, value in enumerate(signal_of))
    (folder / "seed.csv").write_text(f"time (s),acc (m/s^2)\n{rows}", "utf-8")
    shutil.copy(folder / "case.toml", folder / "seed.toml")
    heard = ("--bearing", "6205", "--speed", "1797 rpm", "--unit", "m/s^2", "--rate", "12 kHz")
    commands: dict[str, tuple[tuple[str, ...], ...]] = {
        "nc": (("plot", "damaged.nc", "-o", "d.png"), ("tolerance", "damaged.nc")),
        "h5": (("diagnose", "damaged.h5", *heard),),
        "mat": (("diagnose", "damaged.mat", *heard),),
        "npz": (("diagnose", "damaged.npz", *heard),),
        "csv": (("diagnose", "damaged.csv", *heard[:6]), ("weibull", "damaged.csv")),
        "toml": (("solve", "damaged.toml"),),
        "json": (("plot", "damaged.json", "-o", "d.png"),),
    }
    for ending, programs in commands.items():
        tried = Tried(f"damaged {ending}")
        whole = (folder / f"seed.{ending}").read_bytes()
        for place in range(count):
            (folder / f"damaged.{ending}").write_bytes(damaged(whole, rng))
            ended = command(folder, *programs[place % len(programs)])
            tried.take(f"exit code {ended.code}", ended, LONGEST["files"], f"{ending} {place}")
        yield tried
    yield _bombs(folder, heard)


class _Forked:
    """The process of a reader, forked from this one, which has loaded what it needs.

    Ten times as soon as one that is started; bounds and conversation are the same.
    """

    def __init__(self, program: list[str], **_: object) -> None:
        (asked, own_questions), (own_answers, answered) = os.pipe(), os.pipe()
        self._pid = os.fork()
        if self._pid == 0:
            try:
                for place, end in enumerate((asked, answered, os.open(os.devnull, os.O_WRONLY))):
                    os.dup2(end, place)
                os.close(own_questions)
                os.close(own_answers)
                sys.stdin = os.fdopen(0)
                exec(program[-1], {})
            finally:
                os._exit(0)
        os.close(asked)
        os.close(answered)
        self.stdin, self.stdout = os.fdopen(own_questions, "wb"), os.fdopen(own_answers, "rb")

    def kill(self) -> None:
        """End it; it is waited for after that, so that its number is still its own."""
        os.kill(self._pid, signal.SIGKILL)

    def wait(self) -> None:
        """Wait for its end."""
        os.waitpid(self._pid, 0)


def readers(folder: Path, count: int, seed: int) -> Iterator[Tried]:
    """Damaged spreadsheets, results and records, one after the other in one process."""
    for library in ("h5netcdf", "h5py", "openpyxl", "xarray"):
        importlib.import_module(library)
    isolated.subprocess = SimpleNamespace(  # type: ignore[attr-defined]
        Popen=_Forked, PIPE=subprocess.PIPE, DEVNULL=subprocess.DEVNULL
    )
    rng = random.Random(seed)
    _write_study(folder, 300)
    command(folder, "sweep", "study.toml", "-o", "seed.nc")
    _write_workbook(folder / "seed.xlsx")
    _write_record(folder / "seed.h5", np.random.default_rng(seed).normal(size=4000))
    for ending, arguments in _READ.items():
        tried = Tried(f"damaged {ending}, read in one process")
        whole = (folder / f"seed.{ending}").read_bytes()
        for place in range(_IN_ONE * count):
            spoil = damaged_member if ending == "xlsx" and rng.random() < 0.8 else damaged
            (folder / f"damaged.{ending}").write_bytes(spoil(whole, rng))
            ended = _in_this_process(folder, *arguments)
            tried.take(f"exit code {ended.code}", ended, LONGEST["files"], f"{ending} {place}")
        yield tried


_IN_ONE: Final = 25
"""Files that are read in one process, to one that is read by its own."""
_READ: Final[dict[str, tuple[str, ...]]] = {
    "xlsx": ("weibull", "damaged.xlsx"),
    "nc": ("tolerance", "damaged.nc"),
    "h5": (
        "diagnose", "damaged.h5", "--bearing", "6205", "--speed", "1797 rpm", "--unit", "m/s^2",
        "--rate", "12 kHz",
    ),
}  # fmt: skip


def _in_this_process(folder: Path, *arguments: str) -> Ended:
    """Run the command line here; what it raises but an exit is a traceback."""
    began = time.monotonic()
    before = Path.cwd()
    os.chdir(folder)
    try:
        found = CliRunner().invoke(app, arguments)
    finally:
        os.chdir(before)
    said = found.stderr
    if found.exception is not None and not isinstance(found.exception, SystemExit):
        said += "".join(traceback.format_exception(found.exception))
    # the memory is this process's own, which has done much else
    return Ended(found.exit_code, said, time.monotonic() - began, 0.0)


def _write_workbook(path: Path) -> None:
    """A life test of twenty bearings."""
    book = openpyxl.Workbook()
    book.active.append(["time (h)", "failed"])
    for place in range(20):
        book.active.append([100.0 + 37.5 * place, place % 3 != 0])
    book.save(path)


def damaged_member(whole: bytes, rng: random.Random) -> bytes:
    """A workbook of which one part is damaged, and packed again: its checksum is right."""
    packed = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(whole)) as old, zipfile.ZipFile(packed, "w") as new:
        names = old.namelist()
        chosen = rng.choice(names)
        for name in names:
            content = old.read(name)
            if name == chosen:
                content = rng.choice((damaged, _other_number))(content, rng)
            new.writestr(name, content)
    return packed.getvalue()


def _other_number(content: bytes, rng: random.Random) -> bytes:
    """A number of a text in place of another, which may be large, negative or none."""
    found = list(re.finditer(rb"\d+", content))
    if not found:
        return content
    chosen = rng.choice(found)
    number = rng.choice((b"0", b"-1", b"1e999", b"99999999", b"2147483648", b"nan", b"", b"1.5"))
    return content[: chosen.start()] + number + content[chosen.end() :]


def _write_record(path: Path, samples: np.ndarray) -> None:
    with h5py.File(path, "w") as file:
        data = file.create_dataset("acc", data=samples, chunks=(500,), compression="gzip")
        data.attrs["rate"], data.attrs["unit"] = 12000.0, "m/s^2"


def damaged(whole: bytes, rng: random.Random) -> bytes:
    """Some bytes wrong, most of them near the beginning, where formats keep what they are."""
    content = bytearray(whole)
    for _ in range(rng.choice((1, 1, 2, 5, 30))):
        place = rng.randrange(min(len(content), rng.choice((200, 5000, len(content)))))
        if rng.random() < 0.7:
            content[place] = rng.randrange(256)
        else:
            content[place : place + 8] = rng.choice(
                (b"\xff" * 8, b"\0" * 8, (10**12).to_bytes(8, "little"), b"\x1b]0;x\x07\x00\x80")
            )
    if rng.random() < 0.15:
        del content[rng.randrange(len(content)) :]
    return bytes(content)


def _bombs(folder: Path, heard: tuple[str, ...]) -> Tried:
    """Small files that declare, or inflate to, far more than they have."""
    tried = Tried("files that inflate")
    with h5py.File(folder / "bomb.h5", "w") as file:
        file.create_dataset("acc", (10**12,), "f8", chunks=(1000,), compression="gzip")
    np.savez_compressed(folder / "bomb.npz", acc=np.zeros(60_000_000))
    scipy.io.savemat(folder / "bomb.mat", {"acc": np.zeros(60_000_000)}, do_compression=True)
    names = ",".join(f'"k{n}":1' for n in range(60_000))
    (folder / "bomb.json").write_text("{" + names + ',"k59999":2}', "utf-8")
    for name in ("bomb.h5", "bomb.npz", "bomb.mat"):
        ended = command(folder, "diagnose", name, *heard)
        tried.take(f"exit code {ended.code}", ended, LONGEST["files"], name)
    ended = command(folder, "solve", "bomb.json")
    tried.take(f"exit code {ended.code}", ended, LONGEST["files"], "bomb.json")
    return tried


# --- all together ---------------------------------------------------------------------------

KINDS: Final[dict[str, Callable[[Path, int, int], Iterator[Tried]]]] = {
    "kills": kills, "faults": faults, "cluster": cluster, "files": files, "readers": readers,
}  # fmt: skip


def _write_study(folder: Path, count: int) -> None:
    shutil.copy(EXAMPLE, folder / "case.toml")
    (folder / "study.toml").write_text(STUDY.format(count=count), "utf-8")


def page(found: list[Tried], arguments: str) -> str:
    """The figures as a page of the documentation."""
    rows = "\n".join(
        f"| {tried.name} | {tried.trials} | {_outcomes(tried)} | {len(tried.bad)} "
        f"| {tried.longest:.1f} | {f'{tried.memory / 1e6:.0f}' if tried.memory else '–'} |"
        for tried in found
    )
    return PAGE.format(rows=rows, arguments=arguments)


def _outcomes(tried: Tried) -> str:
    return ", ".join(f"{name}: {number}" for name, number in sorted(tried.outcomes.items()))


PAGE: Final = """\
# Faults and hostile files

What happens when a run is killed, a disk fills up, a cluster is not one, or a file is damaged on
its way or made to do harm. Written by

    .venv/bin/python -m benchmarks.faults{arguments} --markdown docs/faults.md

| what was tried | trials | outcomes | bad ends | longest, s | memory, MB |
|---|---|---|---|---|---|
{rows}

A bad end is a traceback, a crash, more than one message, a time or memory beyond the bound, a file
that is there by half, or one that differs from that of an undisturbed run. Exit codes: 0 done, 1 no
result or not valid, 2 refused in one message. The time of an ended sweep is that from the signal to
the end, or that of resuming it.

## What a file may take

Cases, studies and tables of text: 1 MB. Signals and results may be larger, and are bounded by their
own size ([decision 11](adr/0011-foreign-files.md)): what they declare, or inflate to, may be 32
times that, or 64 MB where it is more; numbers count as 8 bytes. What has to be held whole (MATLAB,
NPZ, UFF) may have 512 MB. MATLAB, HDF5 and NetCDF are read by a process of their own with 2 GB,
which may fall 30 s behind 4 MB/s ([decision 13](adr/0013-formats-by-libraries.md)).

Control characters in a file, which a terminal would obey, are shown as escapes such as `\\x1b`.

## What is written

Every output is written beside its place and then renamed: it is the old one or the new one, never
half of it. A sweep keeps what it has solved, two seconds later at the most; the file that it makes
after having been stopped is that of an undisturbed run, byte for byte.

## Compiled code

A kernel that is kept on disk has a checksum behind it. One that is damaged is discarded and
recompiled, which a line on standard error says; one that cannot be kept is compiled by each
process.

It is run as soon as it is read. So a folder is used only if nobody but the user, the owner of the
program and the administrator may write to it or to one above it; else each process compiles its
own, which a line says once ([decision 36](adr/0036-whose-cache-is-read.md)). `chmod go-w FOLDER`
mends it.

## How a long command is ended

Ctrl-C and `kill PID` end a sweep alike: exit code 130, and what is solved is kept. Where Ctrl-C is
ignored, as in what a shell starts in the background, a line on standard error says with which
number.
"""


def main() -> int:
    """Run it."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--count", type=int, default=40, help="damaged files of each kind")
    parser.add_argument("--kills", type=int, default=5, help="of each kind")
    parser.add_argument("--only", nargs="*", choices=KINDS, default=list(KINDS))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--markdown", type=Path)
    parser.add_argument("--json", type=Path)
    options = parser.parse_args()
    found = []
    for name in options.only:
        count = options.count if name in ("files", "readers") else options.kills
        with tempfile.TemporaryDirectory() as folder:
            for tried in KINDS[name](Path(folder), count, options.seed):
                found.append(tried)
                print(
                    f"{tried.name}: {tried.trials} trials, {len(tried.bad)} bad;"
                    f" {_outcomes(tried)};"
                    f" longest {tried.longest:.1f} s, {tried.memory / 1e6:.0f} MB",
                    flush=True,
                )
                for text in tried.bad:
                    print("   ", " ".join(text.split()))
    if options.markdown:
        arguments = f" --count {options.count} --kills {options.kills}"
        options.markdown.write_text(page(found, arguments), encoding="utf-8")
    if options.json:
        record = [{"name": t.name, "trials": t.trials, "outcomes": t.outcomes} for t in found]
        options.json.write_text(json.dumps(record, indent=2) + "\n", encoding="utf-8")
    return int(any(tried.bad for tried in found))


if __name__ == "__main__":
    sys.exit(main())
