"""How long a person waits: for the import, and for the first answer of the command."""

from __future__ import annotations

import importlib
import statistics
import subprocess
import sys
import time
from pathlib import Path

from benchmarks import duty_sets
from benchmarks.figures import Figure, Findings, below


def measure(runs: int) -> Findings:
    """Wall time of new processes: `import rolamento`, and `rolamento solve` on a warm cache."""
    findings = _measure("import rolamento", [sys.executable, "-c", "import rolamento"], runs, 0.2)
    command = command_line()
    if command is None:
        findings.remarks.append("rolamento solve: skipped, there is no command line yet.")
        return findings
    example = duty_sets.example_path()
    for name, file, target in (("218 example", example.name, 0.8), ("pair", "6012_pair.toml", 0.6)):
        solve = [*command, "solve", str(example.with_name(file))]
        findings.add(_measure(f"rolamento solve, {name}", solve, runs, target))
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


def _measure(name: str, command: list[str], runs: int, target: float) -> Findings:
    """Best and median of several runs, after one that fills the caches."""
    times = []
    for _ in range(runs + 1):
        begin = time.perf_counter()
        done = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)
        times.append(time.perf_counter() - begin)
        if done.returncode != 0:
            last = (done.stderr or done.stdout).strip().splitlines()[-1:]
            return Findings([], [], [f"{name}: exit code {done.returncode}: {' '.join(last)}"])
    figures = [
        Figure("start", f"{name}: best", min(times[1:]), "s", below(target)),
        Figure("start", f"{name}: median", statistics.median(times[1:]), "s"),
    ]
    return Findings(figures, [], [])
