"""How long a person waits: for the import, and for the first answer of a command.

Beside a solve stands the import of the libraries that it cannot do without, and of Numba, which a
set takes too; beside a diagnosis a script with SciPy. All are new processes.
"""

from __future__ import annotations

import importlib
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from benchmarks import duty_sets, vibration
from benchmarks.figures import Figure, Findings, below
from rolamento.vibration.synthesis import synthesise
from rolamento.vibration.writing import write_signal

_ROOT = Path(__file__).parents[1]
_LIBRARIES = "numpy, pydantic.main, typer"


def measure(runs: int) -> Findings:
    """Wall time of new processes: `import rolamento`, commands and libraries, on warm caches."""
    imported = [sys.executable, "-c", "import rolamento"]
    findings = _measure("import rolamento", imported, runs, 0.2)
    command = command_line()
    if command is None:
        findings.remarks.append("rolamento solve: skipped, there is no command line yet.")
        return findings
    example = duty_sets.example_path()
    for name, file, target in (("218 example", example.name, 0.8), ("pair", "6012_pair.toml", 0.6)):
        solve = [*command, "solve", str(example.with_name(file))]
        findings.add(_measure(f"rolamento solve, {name}", solve, runs, target))
    named = [*command, "solve", "6310/C3", "--fr", "5 kN", "--speed", "3000 rpm"]
    findings.add(_measure("rolamento solve, 6310/C3", named, runs, 0.25))
    life = [*command, "life", str(example.with_name("6305_life.toml"))]
    findings.add(_measure("rolamento life, 6305", life, runs, None))
    for libraries in (_LIBRARIES, f"{_LIBRARIES}, numba"):
        imported = [sys.executable, "-c", f"import {libraries}"]
        findings.add(_measure(f"import {libraries}", imported, runs, None))
    findings.add(_diagnoses(command, runs))
    return findings


def _diagnoses(command: list[str], runs: int) -> Findings:
    """Of 10 s at 51.2 kHz from a file, without and with a picture."""
    findings = Findings.none()
    script = [sys.executable, "-m", vibration.vibration_plain.__name__]
    with tempfile.TemporaryDirectory() as folder:
        path, picture = Path(folder) / "signal.npz", Path(folder) / "picture.png"
        write_signal(synthesise(vibration.recipe(vibration.DURATION)).signal, path)
        diagnose = [*command, "diagnose", str(path), "--bearing", "6205"]
        for name, drawn, alone, target in (
            ("rolamento diagnose, 10 s", [], [], 1.5),
            ("rolamento diagnose --plot", ["--plot", str(picture)], [str(picture)], 3.0),
        ):
            findings.add(_measure(name, [*diagnose, *drawn], runs, target))
            findings.add(_measure(f"{name}: SciPy", [*script, str(path), *alone], runs, None))
    return findings


def command_line() -> list[str] | None:
    """The installed command, or how to run it without; None where the package has none."""
    try:
        if not hasattr(importlib.import_module("rolamento.cli"), "main"):
            return None
    except ModuleNotFoundError:
        return None
    script = Path(sys.executable).with_name("rolamento")
    if script.is_file():
        return [str(script)]
    return [sys.executable, "-c", "from rolamento.cli import main; main()"]


def _measure(name: str, command: list[str], runs: int, target: float | None) -> Findings:
    """Best and median of several runs, after one that fills the caches."""
    times = []
    for _ in range(runs + 1):
        begin = time.perf_counter()
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=300, check=False, cwd=_ROOT
        )
        times.append(time.perf_counter() - begin)
        if done.returncode != 0:
            last = (done.stderr or done.stdout).strip().splitlines()[-1:]
            return Findings([], [], [f"{name}: exit code {done.returncode}: {' '.join(last)}"])
    aim = None if target is None else below(target)
    figures = [
        Figure("start", f"{name}: best", min(times[1:]), "s", aim),
        Figure("start", f"{name}: median", statistics.median(times[1:]), "s"),
    ]
    return Findings(figures, [], [])
