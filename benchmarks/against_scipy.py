"""The engine beside `scipy.optimize.root`, one thread against one, on the same duties."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Final

import numpy as np

import rolamento
from benchmarks import duty_sets
from benchmarks.figures import Figure, Findings, Target, alternately, at_least
from benchmarks.scipy_model import Floats, ScipyBearing, load_of

AGREEMENT: Final = 1e-6
"""Greatest difference of the displacements, over their size."""
NEIGHBOUR: Final = 0.98
"""Loads and speed of the duty whose solution is the warm start, over those of the duty."""
BATCH: Final = 10_000
"""Cases with which the engine is timed; SciPy takes a sample of them."""

SETS: Final[dict[str, tuple[Callable[[int], duty_sets.Duties], bool]]] = {
    "tilts held": (duty_sets.tilts_held, False),
    "moments given": (duty_sets.moments_given, True),
}


def measure(name: str, sample: int, repeats: int) -> Findings:
    """Compare rates and answers on a sample of a duty set."""
    duties_of, tilting = SETS[name]
    case = example()
    everything = duty_sets.some(duties_of(duty_sets.CASES), BATCH)
    engine = partial(rolamento.solve, case, threads=1, **everything)
    sides = _Sample(case, duty_sets.some(everything, sample), tilting)
    runs = (
        ("cold", sides.cold, True, None),
        ("warm", sides.warm, False, at_least(1000.0)),
        ("warm, exact Jacobian given", sides.warm, True, None),
    )
    findings = Findings.none()
    for label, starts, exact, target in runs:
        findings.add(_compare(sides, f"{name}, {label}", starts, exact, engine, target, repeats))
    return findings


def example() -> rolamento.Case:
    """The 218 bearing as SciPy's side has it: raceway control alone, and no cage."""
    return rolamento.override(duty_sets.example(), ["model.cage=none"])


class _Sample:
    """Some duties, their solution by the engine, and places for SciPy to start from."""

    def __init__(self, case: rolamento.Case, duties: duty_sets.Duties, tilting: bool) -> None:
        self.bearing = ScipyBearing(case.bearing, tilting=tilting)
        self.speeds = duties["inner_speed"]
        self.loads = [load_of(duties, i) for i in range(len(self.speeds))]
        solution = rolamento.solve(case, threads=1, **duties)
        self.expected = solution.displacement.array * self.bearing.arms
        self.cold = [self.bearing.static_guess(load) for load in self.loads]
        self.warm = self._neighbours(case, duties)

    def _neighbours(self, case: rolamento.Case, duties: duty_sets.Duties) -> list[Floats]:
        """The solutions of duties with loads and speed a little lower."""
        near = rolamento.solve(case, **{k: NEIGHBOUR * v for k, v in duties.items()})
        outer = near.outer
        reach = self.bearing.free_length[1, 0] + outer.deflection
        angle = outer.contact_angle
        places = np.stack([reach * np.sin(angle), reach * np.cos(angle)], axis=1)
        rings = near.displacement.array
        return [self.bearing.unknowns(r, x) for r, x in zip(rings, places, strict=True)]

    def solve(self, starts: list[Floats], exact_jacobian: bool) -> list[tuple[bool, Floats]]:
        """Solve all duties, one at a time, from the given starts."""
        return [
            self.bearing.solve(load, float(speed), start, exact_jacobian=exact_jacobian)
            for load, speed, start in zip(self.loads, self.speeds, starts, strict=True)
        ]

    def differences(self, solved: list[tuple[bool, Floats]]) -> Floats:
        """Distance of SciPy's displacements from the engine's, over their size; NaN if none."""
        found = np.array([self.bearing.displacement(unknowns) for _, unknowns in solved])
        size = np.linalg.norm(self.expected, axis=1)
        error = np.linalg.norm(found - self.expected, axis=1) / size
        return np.where([success for success, _ in solved], error, np.nan)


def _compare(
    sides: _Sample,
    label: str,
    starts: list[Floats],
    exact_jacobian: bool,
    engine: Callable[[], object],
    target: Target | None,
    repeats: int,
) -> Findings:
    """Time SciPy from one kind of start, and check what it finds."""
    solved = sides.solve(starts, exact_jacobian)
    scipy = partial(sides.solve, starts, exact_jacobian)
    scipy_time, engine_time = alternately([scipy, engine], repeats)
    rate, engine_rate = len(starts) / scipy_time, BATCH / engine_time
    difference = sides.differences(solved)
    found = float(np.isfinite(difference).mean())
    group = "against scipy.optimize.root"
    figures = [
        Figure(group, f"{label}: SciPy", rate, "cases/s"),
        Figure(group, "  the engine is faster by", engine_rate / rate, "times", target),
    ]
    remarks = []
    if found < 1.0:
        remarks.append(f"{label}: SciPy finds a solution in {100.0 * found:.0f} % of the cases.")
    failures = []
    worst = float(np.nanmax(difference, initial=0.0))
    if worst > AGREEMENT:
        failures.append(f"{label}: SciPy's displacements differ by up to {worst:.1e}")
    if found == 0.0:
        failures.append(f"{label}: SciPy finds no solution to compare with")
    return Findings(figures, remarks, failures)
