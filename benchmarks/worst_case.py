"""What the dearest case costs: the distribution of the time of one case, over random ones.

Random bearings and duties as in `robustness`. All cases of a bearing are solved in one batch, one
thread; what it takes is shared out evenly to those of the fast path. Each one that took the safe
path is solved again by itself, and timed with all the Python around it. Where the bound on the work
gave a case up, it is solved once more with ten times the bound, to count what that loses.
"""

from __future__ import annotations

import time
from typing import Final

import numpy as np

import rolamento
from benchmarks.duty_sets import Floats
from benchmarks.figures import Figure, Findings, below
from benchmarks.robustness import CASES_PER_BEARING, KINDS, SEED, random_case, random_duties
from rolamento import status
from rolamento.rows.ball.row import BallRow
from rolamento.rows.ball.run import MOST_WORK, solve_columns
from rolamento.system import spread

NAME: Final = "time of one case"
PARTS: Final = (50.0, 99.0, 99.9)
TARGETS: Final = {99.9: below(2.0)}
LONGEST: Final = below(50.0)


def measure(cases: int) -> Findings:
    """Time so many random cases."""
    random, kind = np.random.default_rng(SEED), KINDS["random cases"]
    times, lost = [], 0
    for first in range(0, cases, CASES_PER_BEARING):
        lot = min(CASES_PER_BEARING, cases - first)
        case = random_case(random, kind.control)
        duties = random_duties(random, case.bearing, lot, counter_rotating=False)
        own, more = _times(case, duties)
        times.append(own)
        lost += more
    all_times = 1e3 * np.concatenate(times)
    figures = [
        Figure(NAME, f"{part:g} % of the cases within", value, "ms", TARGETS.get(part))
        for part, value in zip(PARTS, np.percentile(all_times, PARTS), strict=True)
    ]
    figures.append(Figure(NAME, "the longest", float(all_times.max()), "ms", LONGEST))
    figures.append(Figure(NAME, "cases", float(all_times.size)))
    figures.append(Figure(NAME, "given up that ten times the work solves", float(lost)))
    return Findings(figures, [], [])


def _times(case: rolamento.Case, duties: dict[str, Floats]) -> tuple[Floats, int]:
    """Seconds for every case, and how many only more work brings to a result."""
    spread_cases = spread(case, duties)
    row = spread_cases.rows[0].row
    assert isinstance(row, BallRow)
    p = row.asked(spread_cases.free, spread_cases.load, spread_cases.displacement).p
    balls = case.bearing.element_count
    control = np.ones((1, balls))
    solve_columns(p.of([0]), control, balls, threads=1)  # to load what it needs
    begin = time.perf_counter()
    solution = solve_columns(p, control, balls, threads=1)
    whole = time.perf_counter() - begin
    own, lost = np.zeros(p.cases), 0
    for index in np.flatnonzero(solution.safe):
        column = p.of([index])
        begin = time.perf_counter()
        solve_columns(column, control, balls, threads=1)
        own[index] = time.perf_counter() - begin
        if solution.code[index] == status.NOT_CONVERGED:
            again = solve_columns(column, control, balls, threads=1, most_work=10.0 * MOST_WORK)
            lost += int(again.code[0] == status.CONVERGED)
    fast = ~solution.safe
    own[fast] = max(whole - own.sum(), 0.0) / max(np.count_nonzero(fast), 1)
    return own, lost
