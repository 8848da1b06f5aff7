"""Rows on one ring: cases/s of sets and of other grooves, and `scipy.optimize.root` on a pair.

SciPy's side is two of the bearings of `scipy_model` on one ring: its five displacements and the
places of all balls for unknowns, warm-started from the solution at 2 % less load and speed. The
bearing is that of the shipped example `6012_pair`, 22 balls a row.
"""

from __future__ import annotations

import math
from functools import partial
from importlib import resources
from pathlib import Path
from typing import Any, Final

import numpy as np
from scipy.optimize import root

import rolamento
from benchmarks.figures import Figure, Findings, alternately, at_least
from benchmarks.scipy_model import LENGTH, Floats, ScipyBearing
from rolamento.solved import Solved

GROUP: Final = "sets"
SEED: Final = 6012
NEIGHBOUR: Final = 0.98
"""Loads and speed of the duty whose solution is the warm start, over those of the duty."""
AGREEMENT: Final = 1e-6
"""Greatest difference of the ring's place, over its size."""
OFFSET: Final = 5e-6
"""m: how far each ring of the pair is pressed in that SciPy solves."""

CAGE: Final = "model.cage=none"
"""As SciPy's side has it: raceway control alone."""

SETS: Final[dict[str, tuple[str, tuple[str, ...]]]] = {
    "pair, clamped": ("6012_pair", (f"bearing.preload={1e6 * OFFSET} um", CAGE)),
    "pair, preload force": ("6012_pair", ("bearing.preload=500 N",)),
    "pair, play": ("6012_pair", ("bearing.preload=-3 um",)),
    "pair, springs": ("6012_pair", ("bearing.preload.spring=300 N",)),
    "pair, Jones": ("6012_pair", ("model.raceway_control=jones",)),
    "triplet": ("6012_triple", ()),
}
OTHERS: Final = {
    "four-point": ("QJ 210", {"fx": 5e3, "fz": 1e3}),
    "self-aligning": ("1205", {"fz": 2e3, "fx": 200.0}),
    "thrust": ("51110", {"fx": 8e3}),
}
SLOW: Final = frozenset({"pair, springs", "pair, Jones", *OTHERS})
"""Measured on a tenth of the cases."""


def example(name: str) -> rolamento.Case:
    """A set by its name in `SETS` or `OTHERS`."""
    if name in OTHERS:
        designation, load = OTHERS[name]
        duty = {"load": {k: f"{v} N" for k, v in load.items()}, "inner_speed": "1480 rpm"}
        mapping = {"bearing": {"designation": designation}, "duty": duty}
        return rolamento.Case.model_validate(mapping)
    file, settings = SETS[name]
    folder = Path(str(resources.files("rolamento") / "examples"))
    return rolamento.override(rolamento.load_case(folder / f"{file}.toml"), list(settings))


def duties(name: str, cases: int) -> dict[str, Floats]:
    """Loads, and for the pairs and triplets moments too, and the speed; seeded."""
    random = np.random.default_rng(SEED)
    if name in OTHERS:
        load = OTHERS[name][1]
        part = random.uniform(0.3, 1.5, cases)
        found = {f"duty.load.{key}": value * part for key, value in load.items()}
        return {**found, "duty.inner_speed": random.uniform(50.0, 300.0, cases)}
    return {
        "duty.load.fx": random.uniform(0.1e3, 1.5e3, cases),
        "duty.load.fy": random.uniform(-0.5e3, 0.5e3, cases),
        "duty.load.fz": random.uniform(0.0, 2e3, cases),
        "duty.load.my": random.uniform(-10.0, 10.0, cases),
        "duty.load.mz": random.uniform(-10.0, 10.0, cases),
        "duty.inner_speed": random.uniform(0.0, 20_000.0 * math.pi / 30.0, cases),
    }


def measure(cases: int, sample: int, repeats: int) -> Findings:
    """Time every set; SciPy on a sample of the clamped pair's duties."""
    findings = Findings.none()
    for name in (*SETS, *OTHERS):
        count = max(cases // 10, 1) if name in SLOW else cases
        findings.add(_rates(name, count, repeats))
    if sample:
        findings.add(_beside_scipy(cases, sample))
    return findings


def _rates(name: str, cases: int, repeats: int) -> Findings:
    case, given = example(name), duties(name, cases)
    solved = rolamento.solve(case, given)
    runs = [partial(rolamento.solve, case, given, threads=threads) for threads in (1, 2)]
    one, two = (cases / spent for spent in alternately(runs, repeats))
    target = at_least(50_000.0, 25_000.0) if name.startswith("pair, clamped") else None
    figures = [
        Figure(GROUP, f"{name}: one thread", one, "cases/s"),
        Figure(GROUP, "  two threads", two, "cases/s", target),
    ]
    lost = int((~solved.converged).sum())
    remarks = [f"sets: {name}: {lost} of {cases} without a result."] if lost else []
    failed = int((solved.status.code == "not_converged").sum())
    return Findings(figures, remarks, [f"{name}: {failed} not converged"] if failed else [])


def _beside_scipy(cases: int, sample: int) -> Findings:
    name = "pair, clamped"
    case, given = example(name), duties(name, cases)
    some = {key: values[:sample] for key, values in given.items()}
    pair = ScipyPair(case)
    expected = rolamento.solve(case, some)
    near = rolamento.solve(case, {key: NEIGHBOUR * values for key, values in some.items()})
    starts = [pair.unknowns(near, i) for i in range(sample)]
    found: list[Floats] = []

    def scipy() -> None:
        found[:] = [pair.solve(some, i, starts[i]) for i in range(sample)]

    engine = partial(rolamento.solve, case, given, threads=1)
    spent, own = alternately([scipy, engine], 2)
    plain, rate = sample / spent, cases / own
    places = expected.displacement.array * pair.arms
    wrong = np.linalg.norm(np.array(found) - places, axis=1) / np.linalg.norm(places, axis=1)
    failures = []
    if not np.nanmedian(wrong) < AGREEMENT:
        failures.append(f"sets: SciPy's answers differ by {np.nanmedian(wrong):.1e}")
    return Findings(
        [
            Figure(GROUP, f"{name}: scipy.optimize.root, warm", plain, "cases/s"),
            Figure(GROUP, "  the engine is faster by", rate / plain, "times", at_least(500.0)),
        ],
        [f"sets: SciPy finds {np.mean(wrong < AGREEMENT):.0%} of the pair's cases."],
        failures,
    )


class ScipyPair:
    """Two rows of one bearing back to back, clamped by `OFFSET`, on one ring that tilts."""

    def __init__(self, case: rolamento.Case) -> None:
        bearing = case.bearing
        alone = bearing.replace(arrangement=None, spacing=None, preload=None)
        self.row = ScipyBearing(alone, tilting=True)
        self.arms = self.row.arms
        self.levers = [place.position / self.arms[3] for place in bearing.places]
        self.ways = [place.sign for place in bearing.places]

    def _standing(self, ring: Floats, index: int) -> Floats:
        """Where a row is held by the ring, in its own frame."""
        way, lever = self.ways[index], self.levers[index]
        x, y, z, p, q = ring
        return np.array([way * x + OFFSET, y + lever * q, z - lever * p, way * p, way * q])

    def unknowns(self, solved: Solved, case: int) -> Floats:
        """Of a solution of the engine: the ring, and the balls row by row, over `LENGTH`."""
        ring = solved.displacement.array[case] * self.arms
        outer = solved.outer
        reach = self.row.free_length[1, 0] + outer.deflection[case]
        angle = outer.contact_angle[case]
        places = np.stack([reach * np.sin(angle), reach * np.cos(angle)]).reshape(2, 2, -1)
        balls = [(places[:, row] - self.row.rest).ravel() for row in range(2)]
        return np.concatenate([ring, *balls]) / LENGTH

    def residual(self, load: Floats, speed: float, unknowns: Floats) -> Floats:
        """Unbalanced forces of the ring and of all balls, over the axial load."""
        row, each = self.row, 2 * self.row.balls
        ring = unknowns[:5] * LENGTH
        force, balls = -load / self.arms, []
        for index, (way, lever) in enumerate(zip(self.ways, self.levers, strict=True)):
            own = unknowns[5 + index * each : 5 + (index + 1) * each]
            standing = self._standing(ring, index) / LENGTH
            at = row.evaluate(speed, np.concatenate([standing, own]))
            found = row.residual(_ONE, at)
            fx, fy, fz, p, q = found[:5] + _ONE
            force = force + np.array([way * fx, fy, fz, way * p - lever * fz, way * q + lever * fy])
            balls.append(found[5:])
        return np.concatenate([force, *balls]) / abs(load[0])

    def solve(self, given: dict[str, Floats], case: int, start: Floats) -> Floats:
        """The ring's place, tilts times the arm (5,), m; NaN where `root` finds none."""
        load = np.array(
            [given[f"duty.load.{name}"][case] for name in ("fx", "fy", "fz", "my", "mz")]
        )
        speed = float(given["duty.inner_speed"][case])
        found: Any = root(partial(self.residual, load, speed), start)
        return np.asarray(found.x[:5]) * LENGTH if found.success else np.full(5, np.nan)


_ONE: Final = np.array([1.0, 0.0, 0.0, 0.0, 0.0])
"""N: a load that is put on and taken off again."""
