"""The heat of a spindle pair, warm kernels: its balance, a curve over the speed, a start-up."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

import numpy as np

from benchmarks.figures import Figure, Findings, alternately, below
from rolamento import Case
from rolamento.heat import heat_balance, heat_balances, heat_transient
from rolamento.solution import solve

SPEEDS: Final = np.linspace(1000.0, 8000.0, 40) * np.pi / 30.0
AIMS: Final = {"balance": 30.0, "40 speeds": 1000.0, "an hour": 500.0}
"""ms"""


def pair() -> Case:
    """Two 7014 C back to back with grease."""
    return Case(
        bearing={"designation": "7014 C DB", "preload": "240 N", "spacing": "20 mm"},
        duty={"inner_speed": "6000 rpm"},
        mounting={"shaft_interference": "5 um", "housing_interference": "-2 um"},
        lubricant="ISO VG 32",
        heat={"shaft_ambient": 2.0, "housing_ambient": 6.0},
    )


def measure(repeats: int) -> Findings:
    """The best of several runs of each."""
    case = pair()
    solve(case, inner_speed=[100.0] * 2)  # a single case does not load kernels
    if not heat_balance(case).converged:
        return Findings([], [], ["heat: no balance"])
    steps: dict[str, Callable[[], object]] = {
        "balance": lambda: heat_balance(case),
        "40 speeds": lambda: heat_balances(case, {"duty.inner_speed": SPEEDS}),
        "an hour": lambda: heat_transient(case, 3600.0),
    }
    seconds = alternately(list(steps.values()), repeats)
    figures = [
        Figure("heat of a pair", step, 1e3 * took, "ms", below(AIMS[step]))
        for step, took in zip(steps, seconds, strict=True)
    ]
    return Findings(figures, [], [])
