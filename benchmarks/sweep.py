"""A million cases from a study file: wall time, rate, memory, and how much of it each part takes.

The duty set of `duty_sets.tilts_held` as scatter: the 218 bearing, speed 0 to 15 000 rpm, axial
loads of its upper half, radial loads in the same proportions, drawn independently. Default
outputs, to NetCDF, two threads. A process of its own runs it, so that its memory can be told.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from benchmarks import duty_sets
from benchmarks.figures import Figure, Findings, below, peak_megabytes
from rolamento.studies import Distribution, Scatter, Study, run_to_file

CASES = 1_000_000
SECONDS = 60.0
MEGABYTES = 1000.0
RANGES = {
    "duty.inner_speed": ("0 rpm", "15000 rpm"),
    "duty.load.fx": ("20 kN", "45 kN"),
    "duty.load.fy": ("-8 kN", "8 kN"),
    "duty.load.fz": ("0 kN", "18 kN"),
}


def measure(cases: int = CASES, ending: str = ".nc") -> Findings:
    """Run the study in a new process; all cases have to converge."""
    command = [sys.executable, "-m", "benchmarks.sweep", str(cases), ending]
    root = Path(__file__).parents[1]
    done = subprocess.run(
        command, capture_output=True, text=True, timeout=900, check=False, cwd=root
    )
    name = f"sweep, {cases} cases to {ending[1:]}"
    if done.returncode != 0:
        last = (done.stderr or done.stdout).strip().splitlines()[-1:]
        return Findings([], [], [f"{name}: exit code {done.returncode}: {' '.join(last)}"])
    found = json.loads(done.stdout)
    full = cases >= CASES
    figures = [
        Figure(name, "wall time", found["seconds"], "s", below(SECONDS) if full else None),
        Figure(name, "rate", cases / found["seconds"], "cases/s"),
        Figure(name, "of it assembling the file", found["assembling"], "s"),
        Figure(name, "peak memory", found["megabytes"], "MB", below(MEGABYTES)),
        Figure(name, "size of the file", found["size"], "MB"),
    ]
    failures = []
    if found["converged"] != cases:
        failures.append(f"{name}: {cases - found['converged']} cases without a result")
    return Findings(figures, [], failures)


def study(cases: int) -> Study:
    """The study that is measured."""
    laws = {
        name: Distribution(distribution="uniform", minimum=low, maximum=high)
        for name, (low, high) in RANGES.items()
    }
    scatter = Scatter(count=cases, fields=laws)
    return Study(case=duty_sets.example(), seed=duty_sets.SEED, scatter=scatter)


def main(cases: int, ending: str) -> None:
    """Run it here, and print the figures as JSON."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"result{ending}"
        begin = time.perf_counter()
        summary = run_to_file(study(cases), path, threads=2)
        seconds = time.perf_counter() - begin
        size = path.stat().st_size / 1e6
    figures = {
        "seconds": seconds,
        "assembling": seconds - summary.seconds,
        "converged": summary.converged,
        "megabytes": peak_megabytes(),
        "size": size,
    }
    print(json.dumps(figures))


if __name__ == "__main__":
    main(int(sys.argv[1]), sys.argv[2])
