"""How time and memory grow with cases, balls and rows, and what a study of 10^8 cases would take.

    python -m benchmarks.growth                     # to 10^6 cases: three or four minutes
    python -m benchmarks.growth --plot growth.svg   # and draw it
    python -m benchmarks.growth --cases 10000000    # 10^7 at once: some 14 GB

Every number of cases is solved in a process of its own, so that its peak of memory can be told from
that of the others; what a process takes before its first batch is subtracted. The bearing is that
of the duty sets; of balls and rows, 6 mm balls as close as its own.
"""

from __future__ import annotations

import argparse
import json
import math
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, Final

import numpy as np

import rolamento
from benchmarks import duty_sets, sweep
from benchmarks.figures import Figure, Findings, peak_megabytes
from rolamento.studies import run_to_file
from rolamento.studies.plan import Part, Plan

CASES: Final = (1_000, 10_000, 100_000, 1_000_000)
BALLS: Final = (3, 8, 16, 40, 100, 250, 500)
ROWS: Final = (1, 2, 3, 4)
CASES_OF_BALLS: Final = 20_000
GREAT_STUDY: Final = 1e8
_RUNS: Final = 2


def measure(most: int, study_cases: int) -> Findings:
    """Solve up to so many cases at once; reckon from a study of so many."""
    figures, failures = [], []
    for cases in (n for n in (*CASES, 10_000_000) if n <= most):
        found = _alone(cases)
        if "error" in found:
            failures.append(f"growth, {cases} cases: {found['error']}")
            continue
        figures += [
            Figure("growth over cases", f"{cases} cases: time", found["seconds"], "s"),
            Figure("growth over cases", f"{cases} cases: memory", found["megabytes"], "MB"),
        ]
    for name, case in _with_balls():
        figures.append(Figure("growth over balls", name, _microseconds(case), "µs a case"))
    for name, case in _with_rows():
        figures.append(Figure("growth over rows", name, _microseconds(case), "µs a case"))
    figures += [*_reckoned(study_cases), *_on_cluster(study_cases)]
    return Findings(figures, [], failures)


def _alone(cases: int) -> dict[str, Any]:
    """Solve so many cases in a new process: its processor time in seconds, and its megabytes.

    Megabytes beyond those of a few cases.
    """
    command = [sys.executable, "-m", "benchmarks.growth", "--alone", str(cases)]
    root = Path(__file__).parents[1]
    done = subprocess.run(
        command, capture_output=True, text=True, timeout=900, check=False, cwd=root
    )
    if done.returncode != 0:
        return {"error": (done.stderr or f"exit code {done.returncode}").strip()[-200:]}
    return dict(json.loads(done.stdout))


def _here(cases: int) -> None:
    case, few = duty_sets.example(), duty_sets.tilts_held(100)
    rolamento.solve(case, **few)
    before = peak_megabytes()
    duties = duty_sets.tilts_held(cases)
    begin = time.process_time()
    batch = rolamento.solve(case, **duties)
    seconds = time.process_time() - begin
    assert batch.converged.all()
    after = peak_megabytes()
    print(json.dumps({"seconds": seconds, "megabytes": after - before}))


def _bearing(balls: int, **more: Any) -> rolamento.Case:
    diameter = 6e-3
    pitch = max(1.15 * balls * diameter / math.pi, 3.5 * diameter)
    mapping = {
        "bearing": {
            "ball_count": balls,
            "ball_diameter": f"{1e3 * diameter} mm",
            "pitch_diameter": f"{1e3 * pitch} mm",
            "inner_conformity": 0.52,
            "outer_conformity": 0.53,
            "contact_angle": "25 deg",
            **more,
        },
        "duty": {},
    }
    return rolamento.Case.model_validate(mapping)


def _with_balls() -> Iterator[tuple[str, rolamento.Case]]:
    for balls in BALLS:
        yield f"{balls} balls", _bearing(balls)


def _with_rows() -> Iterator[tuple[str, rolamento.Case]]:
    for rows in ROWS:
        placed = [
            {"orientation": "+-"[row % 2], "position": f"{8.0 * (row - 0.5 * (rows - 1))} mm"}
            for row in range(rows)
        ]
        more: dict[str, Any] = {"rows": placed} if rows > 1 else {}
        yield f"{rows} rows" if rows > 1 else "1 row", _bearing(16, **more)


def _microseconds(case: rolamento.Case) -> float:
    """Processor time of a case of a batch, one thread, the lesser of two runs."""
    random = np.random.default_rng(duty_sets.SEED)
    cases = CASES_OF_BALLS * 16 // max(case.bearing.element_count, 16)
    static = 30.0 * case.bearing.element_count
    fx = static * random.uniform(0.2, 1.0, cases)
    duties = {
        "fx": fx,
        "fz": fx * random.uniform(0.0, 0.6, cases),
        "inner_speed": 30.0 / case.bearing.pitch_diameter * random.uniform(0.2, 1.0, cases),
    }
    best = math.inf
    for _ in range(2):
        begin = time.process_time()
        rolamento.solve(case, threads=1, **duties)
        best = min(best, time.process_time() - begin)
    return 1e6 * best / cases


def _reckoned(cases: int) -> list[Figure]:
    """What a worker's core and the client each take for a case of a study, and for 10^8.

    The workers solve chunks; the client keeps and assembles them, in one process. Its part is the
    time of the same study with parts that are solved already.
    """
    study = sweep.study(cases)
    ready: list[Part] = []
    seconds = [0.0]

    def solved(plan: Plan, indices: Sequence[int]) -> Iterator[Part]:
        begin = time.perf_counter()
        ready.extend(plan.solve(index, 1) for index in indices)
        seconds[0] = time.perf_counter() - begin
        yield from ready

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "result.nc"
        begin = time.perf_counter()
        run_to_file(study, path, threads=1, executor=solved)
        whole = time.perf_counter() - begin
        size = path.stat().st_size
    of_worker, of_client = seconds[0] / cases, (whole - seconds[0]) / cases
    group = "study of 10^8 cases, reckoned"
    return [
        Figure(group, "a core of a worker", 1e6 * of_worker, "µs a case"),
        Figure(group, "the client: keep and assemble", 1e6 * of_client, "µs a case"),
        Figure(group, "the result", GREAT_STUDY * size / cases / 1e9, "GB"),
        Figure(group, "on 2 cores of workers", GREAT_STUDY * of_worker / 2.0 / 3600.0, "h"),
        Figure(group, "the client alone", GREAT_STUDY * of_client / 3600.0, "h"),
        Figure(group, "cores that keep the client busy", of_worker / of_client),
    ]


def _on_cluster(cases: int) -> list[Figure]:
    """The same study by two threads here, and by two workers of Dask with one thread each.

    Once more than is measured, as a worker loads its kernels with the first chunk. What the one
    that asks takes is a bound, whatever the number of workers. Nothing where Dask is not installed.
    """
    try:
        import distributed
    except ImportError:
        return []
    from rolamento.studies.cluster import dask_cluster

    study = sweep.study(cases)
    quiet = {"dashboard_address": None, "silence_logs": 50}
    with (
        tempfile.TemporaryDirectory() as folder,
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, **quiet) as cluster,
    ):
        times: dict[str, list[tuple[float, float]]] = {"here": [], "Dask": []}
        executors = {"here": None, "Dask": dask_cluster(cluster.scheduler_address)}
        for run in range(1 + _RUNS):
            for name, executor in executors.items():
                path = Path(folder) / f"{name}{run}.nc"
                begin, busy = time.perf_counter(), time.process_time()
                run_to_file(study, path, threads=2, executor=executor)
                times[name].append((time.perf_counter() - begin, time.process_time() - busy))
    (here, _), (dask, of_client) = (
        1e6 * np.min(times[name][1:], axis=0) / cases for name in ("here", "Dask")
    )
    group = f"study of {cases} cases, two cores"
    return [
        Figure(group, "two threads of one process", here, "µs a case"),
        Figure(group, "two workers of Dask", dask, "µs a case"),
        Figure(group, "  processor of the one that asks", of_client, "µs a case"),
        Figure(group, "  so 10^8 cases take at least", GREAT_STUDY * of_client / 3.6e9, "h"),
    ]


def draw(findings: Findings, path: Path) -> None:
    """Draw time and memory over cases, and time over balls and rows."""
    import matplotlib.pyplot as plt

    def points(group: str, ending: str = "") -> tuple[list[float], list[float]]:
        chosen = [f for f in findings.figures if f.group == group and f.name.endswith(ending)]
        return [float(f.name.split()[0]) for f in chosen], [f.value for f in chosen]

    figure, axes = plt.subplots(1, 3, figsize=(11.0, 3.4), layout="constrained")
    cases, seconds = points("growth over cases", "time")
    _, megabytes = points("growth over cases", "memory")
    axes[0].loglog(cases, seconds, "o-", label="processor time, s")
    axes[0].loglog(cases, [m or math.nan for m in megabytes], "s--", label="memory, MB")
    axes[0].set_xlabel("cases, 16 balls, two threads")
    axes[0].legend()
    axes[1].loglog(*points("growth over balls"), "o-")
    axes[1].set_xlabel("balls")
    axes[1].set_ylabel("µs a case, one thread")
    axes[2].plot(*points("growth over rows"), "o-")
    axes[2].set_xlabel("rows of 16 balls")
    axes[2].set_ylabel("µs a case, one thread")
    axes[2].set_xticks(ROWS)
    axes[2].set_ylim(bottom=0.0)
    for axis in axes:
        axis.grid(alpha=0.3)
    figure.savefig(path)


def main() -> None:
    """Measure, print, and draw."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--alone", type=int, metavar="N", help="only N cases, figures as JSON")
    parser.add_argument(
        "--cases", type=int, default=CASES[-1], metavar="N", help="at once, at most"
    )
    parser.add_argument("--plot", type=Path, metavar="FILE", help="draw the growth to a file")
    options = parser.parse_args()
    if options.alone:
        _here(options.alone)
        return
    findings = measure(options.cases, 300_000)
    for figure in findings.figures:
        print(f"{figure.group:32} {figure.name:32} {figure.value:12.4g} {figure.unit}")
    for failure in findings.failures:
        print(failure, file=sys.stderr)
    if options.plot is not None:
        draw(findings, options.plot)


if __name__ == "__main__":
    main()
