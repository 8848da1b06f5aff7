"""Does every case end well? Random duties at the edge of sense, on random bearings."""

from __future__ import annotations

import json
import math
from collections import Counter
from dataclasses import dataclass
from typing import Final

import numpy as np

import rolamento
from benchmarks.duty_sets import TOP_SPEED, Duties
from benchmarks.figures import Figure, Findings
from benchmarks.throughput import PROMISED_RESIDUAL
from rolamento.case.model import RacewayControl

SEED: Final = 2013
CASES_PER_BEARING: Final = 200
LISTED: Final = 6
"""Most cases without convergence whose parameters are shown."""


def random_case(random: np.random.Generator, control: RacewayControl) -> rolamento.Case:
    """A bearing: 3 to 60 balls of steel or ceramic, given by contact angle or by clearance."""
    balls = int(random.integers(3, 61))
    diameter = math.exp(random.uniform(math.log(2e-3), math.log(50e-3)))
    closest = diameter / math.sin(math.pi / balls)
    f_i, f_o = random.uniform(0.505, 0.6, 2)
    shape = {}
    if random.random() < 0.6:
        shape["contact_angle"] = math.radians(random.uniform(0.0, 45.0))
    else:
        # from a light interference to a free contact angle of 16°
        total = (f_i + f_o - 1.0) * diameter
        shape["diametral_clearance"] = random.uniform(-0.005, 0.08) * total
    bearing = rolamento.Bearing(
        ball_count=balls,
        ball_diameter=diameter,
        pitch_diameter=max(closest * random.uniform(1.05, 2.0), 3.0 * diameter),
        inner_conformity=float(f_i),
        outer_conformity=float(f_o),
        ball_material="Si3N4" if random.random() < 0.4 else "100Cr6",
        **shape,
    )
    return rolamento.Case(
        bearing=bearing,
        duty=rolamento.Duty(first_ball_azimuth=random.uniform(0.0, 2.0 * math.pi)),
        model=rolamento.Model(raceway_control=control),
    )


def random_duties(
    random: np.random.Generator, bearing: rolamento.Bearing, cases: int, *, counter_rotating: bool
) -> Duties:
    """Duties for a bearing, a third of them with 50 N at 15 000 rpm.

    The other loads go to 40 MPa times the square of the ball diameter and ball, a Hertz pressure
    of some 4 GPa, and all speeds to 2.5 million mm/min. The inner ring turns, the outer, or both,
    the same way or, if so wanted, all of them against each other; fz/fx goes to 3, tilts to 0.1°.
    """
    light = random.random(cases) < 1.0 / 3.0
    capacity = 40e6 * bearing.ball_count * bearing.ball_diameter**2
    fx = np.where(light, 50.0, capacity * 10.0 ** random.uniform(-3.0, 0.0, cases))
    top = 2500.0 / bearing.pitch_diameter * math.pi / 30.0
    speed = np.where(light, min(TOP_SPEED, top), top * random.uniform(0.0, 1.0, cases))
    driven = random.integers(0, 3, cases)  # the inner ring, the outer, both
    ratio = random.uniform(0.0, 1.0, cases)
    if counter_rotating:
        driven, ratio = np.full(cases, 2), -ratio
    tilt = math.radians(0.1)
    return {
        "fx": fx,
        "fz": fx * random.uniform(0.0, 3.0, cases),
        "fy": fx * random.uniform(-0.5, 0.5, cases),
        "ry": random.uniform(-tilt, tilt, cases),
        "rz": random.uniform(-tilt, tilt, cases),
        "inner_speed": np.where(driven != 1, speed, 0.0),
        "outer_speed": np.where(driven != 0, speed * np.where(driven == 1, 1.0, ratio), 0.0),
    }


MOST_ASTRAY: Final = 1e-3
"""Share of random cases that may end as not_converged: absurd ones, whose rings have moved so far
off their balls that the grooves, taken as whole circles, pull instead of push."""


@dataclass(frozen=True, slots=True)
class Kind:
    """A kind of random cases.

    part: how many are solved, of those of the first kind; must_end: whether all but a few
    (`MOST_ASTRAY`) have to end with a result or with a reason why there is none.
    """

    control: RacewayControl = "outer"
    counter_rotating: bool = False
    part: float = 1.0
    must_end: bool = True


KINDS: Final = {
    "random cases": Kind(),
    "random cases, moment shared": Kind("none", part=0.1),
    # A ball that the inner race does not load cannot be controlled by it, and between rings that
    # turn against each other the orbit may be so slow that the gyroscopic moment overturns an
    # unloaded ball: not every such case has an equilibrium. They are counted all the same.
    "random cases, inner control": Kind("inner", part=0.01, must_end=False),
    "random cases, rings counter-rotating": Kind(counter_rotating=True, part=0.1, must_end=False),
}


def measure(name: str, cases: int) -> Findings:
    """Solve random cases of a kind, its part of so many, a new bearing for every 200 of them."""
    kind, random = KINDS[name], np.random.default_rng(SEED)
    cases = max(round(kind.part * cases), 1)
    counts: Counter[str] = Counter()
    worst, safe = 0.0, 0
    astray: list[str] = []
    for first in range(0, cases, CASES_PER_BEARING):
        lot = min(CASES_PER_BEARING, cases - first)
        case = random_case(random, kind.control)
        duties = random_duties(random, case.bearing, lot, counter_rotating=kind.counter_rotating)
        batch = rolamento.solve(case, **duties)
        counts.update(batch.status.code.tolist())
        safe += int(batch.status.safe_path.sum())
        worst = max(worst, float(np.max(batch.status.residual[batch.converged], initial=0.0)))
        failed = np.flatnonzero(batch.status.code == "not_converged")
        astray += [description(case, duties, int(i)) for i in failed]

    figures = [
        Figure(name, status.replace("_", " "), 100.0 * count / cases, "%")
        for status, count in counts.most_common()
    ]
    figures.append(Figure(name, "cases on the safe path", 100.0 * safe / cases, "%"))
    figures.append(Figure(name, "greatest residual", worst))
    failures = []
    if not worst <= PROMISED_RESIDUAL:
        failures.append(f"{name}: a converged case has a residual of {worst:.1e}")
    if kind.must_end and len(astray) > MOST_ASTRAY * cases:
        failures.append(f"{name}: {len(astray)} cases did not converge, among them:")
        failures += astray[:LISTED]
    counted = ", ".join(f"{count} {status}" for status, count in counts.most_common())
    return Findings(figures, [f"{name}: {counted}"], failures)


def description(case: rolamento.Case, duties: Duties, index: int) -> str:
    """All that is needed to solve the case again; SI units where none is written."""
    bearing = json.dumps(case.to_mapping()["bearing"], ensure_ascii=False)
    given = {"first_ball_azimuth": case.duty.first_ball_azimuth}
    given |= {name: float(values[index]) for name, values in duties.items()}
    duty = ", ".join(f"{name}={value!r}" for name, value in given.items())
    return f"{bearing}, {case.model.raceway_control} raceway control, {duty}"
