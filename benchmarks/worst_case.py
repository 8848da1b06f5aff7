"""What the dearest case costs: the distribution of the time of one case, over random ones.

Random bearings and duties as in `robustness`. All cases of a bearing are solved in one batch, one
thread; what it takes of the processor is shared out evenly to those of the fast path. Each one that
took the safe path is solved again by itself, and timed with all the Python around it. Where the
bound on the work gave a case up, it is solved once more with ten times the bound, to count what
that loses. Rings that turn against each other at light load are a set of their own.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from typing import Final

import numpy as np

import rolamento
from benchmarks import laws
from benchmarks.duty_sets import Floats
from benchmarks.figures import Figure, Findings, Target, below
from benchmarks.robustness import CASES_PER_BEARING, KINDS, SEED, random_case, random_duties
from rolamento import status
from rolamento.rows.ball.row import BallRow
from rolamento.rows.ball.run import MOST_WORK, solve_columns
from rolamento.system import spread

NAME: Final = "time of one case"
LAWS: Final = "the same, duties of laws"
AGAINST: Final = "the same, rings against each other at light load"
PARTS: Final = (50.0, 99.0, 99.9)
TARGETS: Final = {99.9: below(2.0)}
LONGEST: Final = below(50.0)


def measure(cases: int) -> Findings:
    """Time so many random cases, a tenth as many of `laws`, a hundredth against each other."""
    findings = _measured(NAME, _random(cases), TARGETS)
    findings.add(_measured(LAWS, _of_laws(cases // 10, against=False), {}))
    findings.add(_measured(AGAINST, _of_laws(cases // 100, against=True), {}))
    return findings


def _random(cases: int) -> Iterator[tuple[rolamento.Case, dict[str, Floats]]]:
    random, kind = np.random.default_rng(SEED), KINDS["random cases"]
    for lot in _lots(cases):
        case = random_case(random, kind.control)
        yield case, random_duties(random, case.bearing, lot, counter_rotating=False)


def _of_laws(cases: int, *, against: bool) -> Iterator[tuple[rolamento.Case, dict[str, Floats]]]:
    """The duties of `laws`; against: at light load, a few hundredths without an equilibrium."""
    random = np.random.default_rng(SEED)
    for lot in _lots(cases):
        case = laws.random_case(random)
        duty = laws.random_duty(random, case.bearing, lot)
        yield case, laws.turned_against(random, duty) if against else duty


def _lots(cases: int) -> Iterator[int]:
    return (min(CASES_PER_BEARING, cases - k) for k in range(0, cases, CASES_PER_BEARING))


def _measured(
    name: str,
    lots: Iterator[tuple[rolamento.Case, dict[str, Floats]]],
    targets: dict[float, Target],
) -> Findings:
    times, lost = [np.zeros(0)], 0
    for case, duties in lots:
        own, more = _times(case, duties)
        times.append(own)
        lost += more
    all_times = 1e3 * np.concatenate(times)
    if not all_times.size:
        return Findings.none()
    figures = [
        Figure(name, f"{part:g} % of the cases within", value, "ms", targets.get(part))
        for part, value in zip(PARTS, np.percentile(all_times, PARTS), strict=True)
    ]
    figures.append(Figure(name, "the longest", float(all_times.max()), "ms", LONGEST))
    figures.append(Figure(name, "cases", float(all_times.size)))
    figures.append(Figure(name, "given up that ten times the work solves", float(lost)))
    return Findings(figures, [], [])


def _times(case: rolamento.Case, duties: dict[str, Floats]) -> tuple[Floats, int]:
    """Processor time of every case in seconds, and how many only more work brings to a result."""
    spread_cases = spread(case, duties)
    row = spread_cases.rows[0].row
    assert isinstance(row, BallRow)
    p = row.asked(spread_cases.free, spread_cases.load, spread_cases.displacement).p
    balls = case.bearing.element_count
    control = np.full((1, balls), -1.0 if case.model.raceway_control == "inner" else 1.0)
    solve_columns(p.of([0]), control, balls, threads=1)  # to load what it needs
    begin = time.process_time()
    solution = solve_columns(p, control, balls, threads=1)
    whole = time.process_time() - begin
    own, lost = np.zeros(p.cases), 0
    for index in np.flatnonzero(solution.safe_path):
        column = p.of([index])
        begin = time.process_time()
        solve_columns(column, control, balls, threads=1)
        own[index] = time.process_time() - begin
        if solution.number[index] == status.NOT_CONVERGED:
            again = solve_columns(column, control, balls, threads=1, most_work=10.0 * MOST_WORK)
            lost += int(again.number[0] == status.CONVERGED)
    fast = ~solution.safe_path
    own[fast] = max(whole - own.sum(), 0.0) / max(np.count_nonzero(fast), 1)
    return own, lost
