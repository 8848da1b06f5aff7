"""Film and friction of a hundred thousand solved cases, over all of their contacts.

The duty set of `duty_sets.tilts_held` with oil, temperature, roughness and a coefficient of
friction; friction by a closed form, Jones's simplified model, with hysteresis and the oil's
rolling resistance. What is measured begins where the cases are solved.
"""

from __future__ import annotations

import time

import numpy as np

from benchmarks import duty_sets
from benchmarks.figures import Figure, Findings, below
from rolamento import Lubricant, analyse
from rolamento.solution import solve

CASES = 100_000
SECONDS = 10.0
SURFACE = dict.fromkeys(("inner_roughness", "outer_roughness", "ball_roughness"), 1e-7)


def measure(cases: int = CASES) -> Findings:
    """Analyse a solved batch; every case has to have a film and a torque."""
    oil = Lubricant.named("ISO VG 68").replace(friction_coefficient=0.08)
    case = duty_sets.example().replace(
        lubricant=oil, temperature={"lubricant": 343.15}, surface=SURFACE
    )
    random = np.random.default_rng(duty_sets.SEED)
    batch = solve(
        case,
        inner_speed=random.uniform(0.0, 1500.0, cases),
        fx=random.uniform(20e3, 45e3, cases),
        fz=random.uniform(0.0, 18e3, cases),
    )
    begin = time.perf_counter()
    found = analyse(batch)
    seconds = time.perf_counter() - begin
    name = f"film and friction, {cases} solved cases"
    target = below(SECONDS) if cases >= CASES else None
    figures = [
        Figure(name, "wall time", seconds, "s", target),
        Figure(name, "rate", cases / seconds, "cases/s"),
    ]
    assert found.film is not None
    assert found.friction is not None
    film = np.isfinite(found.film.outer.central_thickness).any(axis=1)
    missing = cases - int((film & np.isfinite(found.friction.torque)).sum())
    return Findings(figures, [], [f"{name}: {missing} without a result"] if missing else [])


if __name__ == "__main__":
    for figure in measure().figures:
        print(f"{figure.name}: {figure.value:.3g} {figure.unit}")
