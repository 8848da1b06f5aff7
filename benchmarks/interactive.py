"""One case as a page asks for it that follows a slider: read, solve, analyse, write; warm kernels.

The shipped examples, a kind of bearing each. *Quick* is `analyse(quick=True)`: without the other
friction models, the life by stress volume and the load at which a set loses its preload. *Full* is
written too: theories of life and models of friction are evaluated when they are looked up.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Final

import rolamento
from benchmarks.figures import Figure, Findings, alternately, below
from rolamento import Case, analyse, load_case
from rolamento.solution import solve

EXAMPLES: Final = ("6305_film", "6310_motor", "nu205_gear", "6012_pair", "30206_pinion")
MILLISECONDS: Final = {"read": 1.0, "quick": 8.0, "full": 25.0, "write": 2.0}
OF_SETS: Final = {"read": 1.0, "quick": 16.0, "full": 120.0, "write": 6.0}
"""Those that are aimed at; the full analysis of a set looks for the loss of its preload."""


def measure(repeats: int) -> Findings:
    """The best of several runs of each step, for each example."""
    findings = Findings.none()
    for name in EXAMPLES:
        findings.add(_measure(name, repeats))
    return findings


def _measure(name: str, repeats: int) -> Findings:
    case = load_case(Path(rolamento.__file__).parent / "examples" / f"{name}.toml")
    solve(case, inner_speed=[case.duty.inner_speed] * 2)  # a single case does not load kernels
    analysis = analyse(case)
    if not analysis.solved.converged[0]:
        return Findings([], [], [f"interactive, {name}: not solved"])
    steps: dict[str, Callable[[], object]] = {
        "read": partial(Case.from_mapping, case.to_mapping()),
        "quick": partial(analyse, case, quick=True),
        "full": lambda: analyse(case).to_mapping(),
        "write": analysis.to_mapping,
    }
    seconds = alternately(list(steps.values()), repeats)
    aims = OF_SETS if case.bearing.is_set else MILLISECONDS
    figures = [
        Figure(f"one case, {name}", step, 1e3 * took, "ms", below(aims[step]))
        for step, took in zip(steps, seconds, strict=True)
    ]
    return Findings(figures, [], [])
