"""How long a person waits who has never used the program: nothing compiled, not even bytecode.

Each command is a new process whose caches, of Python and of the compiler, are empty folders. Wall
time is that to the first line of the answer; processor time that of the command alone, and that of
what it leaves working beside it.
"""

from __future__ import annotations

import os
import shlex
import shutil
import signal
import subprocess
import tempfile
import time
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from benchmarks.figures import Figure, Findings, below
from benchmarks.start import command_line

__all__ = ["COMMANDS", "measure"]

COMMANDS: Final = (  # of the README and of the getting-started page, and what used to be slow
    ("solve 6310/C3 --fr '5 kN' --fa '1 kN' --speed '1480 rpm'", 3.0),
    (
        "life 6310/C3 --fr '5 kN' --fa '1 kN' --speed '1480 rpm' --lubricant 'ISO VG 68'"
        " --temperature '70 degC'",
        3.0,
    ),
    ("frequencies 6310 --speed '1480 rpm'", 3.0),
    ("new 6310/C3", 3.0),
    ("examples", 3.0),
    ("report 6310/C3 --fr '5 kN' --speed '1480 rpm' -o motor.pdf", 6.0),
    ("solve 30206 --fr '4 kN' --fa '1.5 kN' --speed '600 rpm'", 3.0),
    ("solve '30206 DF' --fr '4 kN' --speed '600 rpm'", 3.0),
    ("solve '7210 C DB' --fr '2 kN' --speed '1480 rpm' --set bearing.spacing='30 mm'"
     " --set bearing.preload='300 N'", 3.0),
    (
        "solve '7014 C DB' --fa 400N --fr 800N --speed 15000rpm"
        " --set bearing.preload='{spring=\"240 N\"}'",
        3.0,
    ),
    ("friction 6310/C3 --fr '5 kN' --speed '1480 rpm' --lubricant 'ISO VG 68'"
     " --temperature '70 degC'", 3.0),
    (
        "life 6310/C3 --fa '1 kN' --speed '1480 rpm' --over duty.load.fz=1..10kN --points 21",
        6.0,
    ),
    ("sweep studies/218_speed.toml -o speed.nc", 6.0),
    ("weibull --example campanha-2008", 3.0),
    ("synthesise 6205 --speed '1797 rpm' --fault outer_race -o s.wav", 3.0),
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class FirstUse:
    """Seconds to the first line of an answer, to its end, and of processor time."""

    first: float
    end: float
    processor: float
    exit_code: int
    said: str


def measure(commands: Sequence[tuple[str, float]] = COMMANDS) -> Findings:
    """Run each command once as the first that this machine has seen."""
    findings = Findings.none()
    start = command_line()
    if start is None:
        findings.remarks.append("first use: skipped, there is no command line.")
        return findings
    for command, target in commands:
        used = first_use([*start, *shlex.split(command)])
        name = f"rolamento {command}"
        if used.exit_code != 0:
            findings.failures.append(f"{name}: exit code {used.exit_code}: {used.said}")
            continue
        group = "first use"
        findings.figures += [
            Figure(group, f"{name}: processor", used.processor, "s", below(target)),
            Figure(group, f"{name}: first line", used.first, "s"),
            Figure(group, f"{name}: end", used.end, "s"),
        ]
    return findings


def first_use(command: Sequence[str], limit: float = 600.0) -> FirstUse:
    """Run a command in an empty folder with empty caches."""
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        work = place / "work"
        work.mkdir()
        _examples(work)
        environment = {
            **os.environ,
            "NUMBA_CACHE_DIR": str(place / "kernels"),
            "PYTHONPYCACHEPREFIX": str(place / "bytecode"),
            "MPLCONFIGDIR": str(place / "matplotlib"),
        }
        with (place / "errors").open("w+b") as errors:
            begin = time.perf_counter()
            process = subprocess.Popen(
                command, cwd=work, env=environment, stdout=subprocess.PIPE, stderr=errors
            )
            assert process.stdout is not None
            line = process.stdout.readline()
            first = time.perf_counter() - begin
            process.stdout.read()
            _, status, usage = os.wait4(process.pid, 0)
            end = time.perf_counter() - begin
            process.returncode = os.waitstatus_to_exitcode(status)
            process.stdout.close()
            errors.seek(0)
            said = errors.read().decode(errors="replace").strip()[-400:]
        _end_compiler(place / "kernels")
    return FirstUse(
        first if line else end, end, usage.ru_utime + usage.ru_stime, process.returncode, said
    )


def _end_compiler(kernels: Path) -> None:
    """End the process that compiles in the background: its folder goes."""
    for _ in range(50):  # until it has begun
        lock = kernels / "compiling.lock"
        if lock.is_file() and (written := lock.read_text()):
            with suppress(ProcessLookupError):
                os.kill(int(written), signal.SIGKILL)
            return
        if not lock.parent.is_dir():  # nothing was compiled
            return
        time.sleep(0.1)


def _examples(folder: Path) -> None:
    """Copy what is shipped to where the commands look for it."""
    import rolamento

    shutil.copytree(Path(rolamento.__file__).parent / "examples", folder, dirs_exist_ok=True)


if __name__ == "__main__":
    found = measure()
    for figure in found.figures:
        print(f"{figure.value:8.2f} {figure.unit}  {figure.name}", flush=True)
    for failure in found.failures:
        print(f"failed: {failure}")
