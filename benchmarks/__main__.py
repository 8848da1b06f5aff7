"""Measure the speed: `python -m benchmarks [--quick] [--json FILE]`.

Slow is not wrong: the exit code is 1 only where a case does not converge, where the answers
differ from SciPy's, or where a command fails.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections.abc import Callable
from dataclasses import asdict, dataclass
from functools import partial
from pathlib import Path
from time import perf_counter

from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn
from rich.table import Table

from benchmarks import (
    against_scipy,
    app,
    duty_sets,
    first_use,
    friction_control,
    growth,
    heat,
    interactive,
    laws,
    life,
    line_contact,
    lubrication,
    machines,
    robustness,
    roller_laws,
    rollers,
    sets,
    start,
    sweep,
    throughput,
    vibration,
    weibull,
    worst_case,
)
from benchmarks.figures import Figure, Findings, has_avx512


@dataclass(frozen=True, slots=True)
class Effort:
    """How much is measured."""

    cases: int
    repeats: int
    sample: int
    robust_cases: int
    timed_cases: int
    law_cases: int
    roller_law_cases: int
    runs: int
    sweep_cases: int
    analysed_cases: int
    friction_cases: int
    friction_sample: int
    life_sample: int
    stress_cases: int
    stress_sample: int
    inferred: int
    weibull_fits: int
    weibull_sample: int
    signal_seconds: float
    modulations: int
    line_contacts: int
    roller_cases: int
    set_cases: int
    set_sample: int
    recordings: tuple[float, float]
    app_moves: int
    app_requests: int


FULL = Effort(
    cases=duty_sets.CASES,
    repeats=5,
    sample=100,
    robust_cases=100_000,
    timed_cases=1_000_000,
    law_cases=100_000,
    roller_law_cases=10_000,
    runs=5,
    sweep_cases=1_000_000,
    analysed_cases=100_000,
    friction_cases=200,
    friction_sample=2,
    life_sample=2000,
    stress_cases=1000,
    stress_sample=2,
    inferred=40,
    weibull_fits=10_000,
    weibull_sample=20,
    signal_seconds=vibration.DURATION,
    modulations=3,
    line_contacts=2000,
    roller_cases=10_000,
    set_cases=20_000,
    set_sample=30,
    recordings=(2.0, 20.0),
    app_moves=50,
    app_requests=10_000,
)
QUICK = Effort(
    cases=8_000,
    repeats=1,
    sample=5,
    robust_cases=3_000,
    timed_cases=3_000,
    law_cases=2_000,
    roller_law_cases=500,
    runs=2,
    sweep_cases=20_000,
    analysed_cases=5_000,
    friction_cases=20,
    friction_sample=0,
    life_sample=100,
    stress_cases=50,
    stress_sample=0,
    inferred=4,
    weibull_fits=500,
    weibull_sample=2,
    signal_seconds=2.0,
    modulations=1,
    line_contacts=100,
    roller_cases=500,
    set_cases=2_000,
    set_sample=2,
    recordings=(0.5, 2.0),
    app_moves=5,
    app_requests=400,
)


def steps(effort: Effort) -> list[tuple[str, Callable[[], Findings]]]:
    """What is measured, in order, each with its name."""
    e = effort
    return [
        *((n, partial(throughput.measure, n, e.cases, e.repeats)) for n in throughput.SETS),
        ("kernels", partial(throughput.measure_kernels, e.cases, e.repeats)),
        *(
            (f"SciPy, {n}", partial(against_scipy.measure, n, e.sample, e.repeats))
            for n in against_scipy.SETS
        ),
        (
            "friction control",
            partial(friction_control.measure, e.friction_cases, e.friction_sample, e.repeats),
        ),
        ("line contact", partial(line_contact.measure, e.line_contacts, 5, e.repeats)),
        ("rollers", partial(rollers.measure, e.roller_cases, 5, e.repeats)),
        ("sets", partial(sets.measure, e.set_cases, e.set_sample, e.repeats)),
        ("machines", partial(machines.measure, 5, e.repeats)),
        ("start", partial(start.measure, e.runs)),
        ("first use", first_use.measure),
        ("one case", partial(interactive.measure, e.runs)),
        ("heat", partial(heat.measure, e.runs)),
        ("sweep", partial(sweep.measure, e.sweep_cases)),
        ("film and friction", partial(lubrication.measure, e.analysed_cases)),
        ("life", partial(life.measure, e.analysed_cases, e.life_sample, e.repeats)),
        (
            "stress volume",
            partial(life.measure_stress_volume, e.stress_cases, e.stress_sample, e.repeats),
        ),
        ("catalogue", partial(life.measure_catalogue, e.inferred)),
        ("Weibull fits", partial(weibull.measure, e.weibull_fits, e.weibull_sample, e.repeats)),
        *vibration_steps(e),
        *((n, partial(robustness.measure, n, e.robust_cases)) for n in robustness.KINDS),
        ("growth", partial(growth.measure, e.sweep_cases, e.analysed_cases)),
        ("worst case", partial(worst_case.measure, e.timed_cases)),
        ("laws", partial(laws.measure, e.law_cases)),
        ("laws of rollers", partial(roller_laws.measure, e.roller_law_cases)),
        ("app", partial(app.measure, e.app_moves, e.app_requests)),
    ]


def vibration_steps(e: Effort) -> list[tuple[str, Callable[[], Findings]]]:
    """Those of vibration signals; the recording comes last, as it takes longest."""
    each = {
        "diagnosis": vibration.measure,
        "kurtogram": vibration.measure_kurtogram,
        "synthesis": vibration.measure_synthesis,
        "order tracking": vibration.measure_tracking,
    }
    return [
        *((name, partial(measure, e.signal_seconds, e.repeats)) for name, measure in each.items()),
        ("short diagnosis", partial(vibration.measure_short, e.repeats)),
        (
            "cyclic coherence",
            partial(vibration.measure_coherence, e.signal_seconds, e.modulations, e.repeats),
        ),
        ("recording", partial(vibration.measure_recording, *e.recordings)),
    ]


def main(arguments: list[str] | None = None) -> int:
    """Run the benchmarks; the exit code."""
    options = parse(arguments)
    errors = Console(stderr=True)
    findings = run(QUICK if options.quick else FULL, errors)
    avx512 = has_avx512()
    show(findings, avx512, Console())
    if options.json is not None:
        write_json(findings, avx512, options.json)
    for failure in findings.failures:
        errors.print(f"[bold red]Failed:[/] {failure}", highlight=False, soft_wrap=True)
    return 1 if findings.failures else 0


def parse(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument("--quick", action="store_true", help="fewer cases: a minute")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the figures to a file")
    return parser.parse_args(arguments)


def run(effort: Effort, console: Console) -> Findings:
    """Take all measurements, warm kernels first, and tell what is going on."""
    findings, took = Findings.none(), list[Figure]()
    columns = TextColumn("{task.description:32}"), BarColumn(), TimeElapsedColumn()
    with Progress(*columns, console=console, transient=True) as progress:
        task = progress.add_task("compiling the kernels", total=len(steps(effort)) + 1)
        throughput.warm_up()
        for name, measure in steps(effort):
            progress.update(task, advance=1, description=name)
            began = perf_counter()
            findings.add(measure())
            took.append(Figure("what measuring takes", name, perf_counter() - began, "s"))
    findings.figures += took
    return findings


def show(findings: Findings, avx512: bool, console: Console) -> None:
    """Print the table and the remarks."""
    table = Table(title=f"Speed, {machine(avx512)}", title_justify="left")
    table.add_column("")
    table.add_column("measured", justify="right")
    table.add_column("", justify="left")
    table.add_column("target", justify="right")
    table.add_column("reached")
    group = ""
    for figure in findings.figures:
        if figure.group != group:
            group = figure.group
            table.add_section()
            table.add_row(f"[bold]{group}[/]")
        table.add_row(*cells(figure, avx512))
    console.print(table)
    for remark in findings.remarks:
        console.print(remark, highlight=False, soft_wrap=True)


def cells(figure: Figure, avx512: bool) -> tuple[str, str, str, str, str]:
    """A figure as a row of the table."""
    target = figure.target
    if target is None:
        return f"  {figure.name}", written(figure.value), figure.unit, "", ""
    sign = "≥" if target.direction == "at least" else "<"
    reached = "[green]yes[/]" if target.reached(figure.value, avx512) else "[yellow]no[/]"
    aim = f"{sign} {written(target.value(avx512))}"
    return f"  {figure.name}", written(figure.value), figure.unit, aim, reached


def written(value: float) -> str:
    """A number with three figures, or in whole thousands."""
    if value != 0.0 and abs(value) < 1e-3:
        return f"{value:.1e}"
    return f"{value:,.0f}".replace(",", " ") if abs(value) >= 1000.0 else f"{value:.3g}"


def machine(avx512: bool) -> str:
    vectors = "with AVX-512" if avx512 else "without AVX-512"
    return f"{os.cpu_count()} processors {vectors}, Python {sys.version.split()[0]}"


def write_json(findings: Findings, avx512: bool, path: Path) -> None:
    """Write all figures, with the target for this machine and whether it was reached."""
    figures = []
    for figure in findings.figures:
        row = asdict(figure) | {"target": None, "reached": None}
        if figure.target is not None:
            row["target"] = figure.target.value(avx512)
            row["reached"] = figure.target.reached(figure.value, avx512)
        figures.append(row)
    record = {
        "machine": machine(avx512),
        "figures": figures,
        "remarks": findings.remarks,
        "failures": findings.failures,
    }
    path.write_text(json.dumps(record, indent=2, ensure_ascii=False) + "\n", encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main())
