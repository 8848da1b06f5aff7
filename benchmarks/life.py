"""Rating and fatigue life of solved cases, inference and search in the catalogue.

The 218 of `duty_sets.tilts_held`, all theories but the stress volume; the stress volume on its own;
each beside what a user would write instead, in the same run: a plain Python loop, scipy's `dblquad`
with `minimize_scalar`, a triple loop over balls and pitch diameters. Their answers have to agree.
"""

from __future__ import annotations

import dataclasses
import math
import statistics
import time
from functools import partial
from typing import Final

import numpy as np

from benchmarks import duty_sets, life_plain
from benchmarks.figures import Figure, Findings, alternately, below
from rolamento.catalogue import Catalogue, ball_sizes, catalogue, inferred_geometry
from rolamento.life import Life, LifeConditions, life
from rolamento.life.ioannides_harris import FATIGUE_LIMIT, Ellipses, risk_integral
from rolamento.ratings import dynamic_factor, static_factor
from rolamento.solution import solve
from rolamento.solved import Solved

CASES: Final = 100_000
STRESS_CASES: Final = 1000
SECONDS: Final = 1.0
INFERENCE_MS: Final = 50.0
KEYSTROKE_MS: Final = 5.0
SCIPY_ACCURACY: Final = 1e-3
AGREEMENT: Final = 1e-9
STRESS_AGREEMENT: Final = 5e-3
TYPED: Final = (
    "6", "63", "630", "6305", "6305/", "6305/C3", "e", "ex", "ex 7", "ex 70", "ex 70 25",
    "25x52", "25x52x15", "snfa", "nsk 62", "zzz",
)  # fmt: skip
RPM: Final = math.pi / 30.0
BEARING: Final = life_plain.PlainBearing(
    balls=16, ball=22.23, pitch=125.26, inner=0.5232, outer=0.5232, angle=math.radians(40.0),
    dynamic=106e3, fatigue=4e3, viscosity=15.0, clean=0.6, reliability=0.95,
)  # fmt: skip
CONDITIONS: Final = LifeConditions(
    dynamic_rating=BEARING.dynamic, static_rating=95e3, fatigue_load_limit=BEARING.fatigue,
    viscosity=BEARING.viscosity * 1e-6, contamination=BEARING.clean,
    reliability=BEARING.reliability, material_factor=1.0, nsk_cleanliness=0.8,
)  # fmt: skip


def measure(cases: int, sample: int, repeats: int) -> Findings:
    """All theories but the stress volume; sample: cases of the plain loop."""
    batch = _solved(cases)
    run = partial(_lives, batch)
    plain = partial(_plain_lives, batch, sample)
    plain()
    seconds, looped = alternately([run, plain], repeats)
    name = f"life, {len(run())} theories, {cases} solved cases"
    figures = [
        Figure(name, "wall time", seconds, "s", below(SECONDS) if cases >= CASES else None),
        Figure(name, "rate", cases / seconds, "cases/s"),
        Figure(name, "plain Python loop, five theories", sample / looped, "cases/s"),
        Figure(name, "  the engine is faster by", cases / seconds / (sample / looped), "times"),
    ]
    worst = _difference(batch, sample)
    failed = [f"{name}: the plain loop differs by {worst:.1e}"] if not worst < AGREEMENT else []
    return Findings(figures, [], failed)


def measure_stress_volume(cases: int, sample: int, repeats: int) -> Findings:
    """Ioannides and Harris; sample: contacts that scipy integrates, some seconds each."""
    batch = _solved(cases)
    case = duty_sets.example()
    run = partial(_lives, batch, stress_volume=True)
    run()  # the field, which is computed once in a process
    without, seconds = alternately([partial(_lives, batch), run], repeats)
    name = f"stress volume, {cases} solved cases of 16 balls"
    target = below(SECONDS) if cases >= STRESS_CASES else None
    contacts = cases * 2 * case.bearing.ball_count
    each = (seconds - without) / contacts
    findings = Findings(
        [
            Figure(name, "wall time", seconds, "s", target),
            Figure(name, "of it the stress volume", seconds - without, "s"),
            Figure(name, "a contact", 1e6 * each, "µs"),
        ],
        [],
        [],
    )
    if sample:
        findings.add(_beside_scipy(name, batch, sample, each))
    return findings


def measure_catalogue(bearings: int) -> Findings:
    """Inference of the inside of so many bearings of each list, and search key by key."""
    known = catalogue()
    lists = [
        [b for b in known.bearings if b.maker == maker][:bearings] for maker in ("NSK", "SNFA")
    ]
    hidden = [
        dataclasses.replace(one, ball_count=None, ball_diameter=None)
        for one in (*lists[0], *lists[1])
    ]
    inferred_geometry(hidden[0])
    times = [1e3 * alternately([partial(inferred_geometry, one)], 2)[0] for one in hidden]
    name = "catalogue"
    median = statistics.median(times)
    figures = [
        Figure(name, "inference, median", median, "ms", below(INFERENCE_MS)),
        Figure(name, "inference, slowest", max(times), "ms", below(INFERENCE_MS)),
        *_search_figures(name, known),
    ]
    findings = Findings(figures, [], [])
    findings.add(_beside_triple_loop(name, median))
    return findings


def _solved(cases: int) -> Solved:
    duties = duty_sets.some(duty_sets.tilts_held(duty_sets.CASES), cases)
    duties["inner_speed"] = np.maximum(duties["inner_speed"], 10.0)  # at rest there is no κ
    return solve(duty_sets.example(), **duties)


def _lives(solved: Solved, *, stress_volume: bool = False) -> dict[str, Life]:
    """Lives by all theories: each is evaluated when it is looked up."""
    return dict(life(solved, CONDITIONS, stress_volume=stress_volume).theories)


def _plain_lives(solved: Solved, sample: int) -> list[dict[str, float]]:
    inner, outer = solved.inner.load[:sample].tolist(), solved.outer.load[:sample].tolist()
    axial = np.abs(solved.load.fx[:sample]).tolist()
    radial = np.hypot(solved.load.fy[:sample], solved.load.fz[:sample]).tolist()
    speed = (duty_sets.tilts_held(duty_sets.CASES)["inner_speed"][:sample] / RPM).tolist()
    return [
        life_plain.lives(BEARING, *case, max(rpm, 10.0 / RPM))
        for *case, rpm in zip(inner, outer, axial, radial, speed, strict=True)
    ]


def _difference(solved: Solved, sample: int) -> float:
    """Maximum relative difference of a life; infinite if only one of them has a number."""
    found = life(solved, CONDITIONS)
    worst = 0.0
    for index, plain in enumerate(_plain_lives(solved, sample)):
        for theory, expected in plain.items():
            own = float(found[theory].life[index])
            if math.isnan(own) and math.isnan(expected):
                continue
            difference = abs(own / expected - 1.0)
            worst = max(worst, math.inf if math.isnan(difference) else difference)
    return worst


def _beside_scipy(name: str, solved: Solved, sample: int, each: float) -> Findings:
    """Scipy on the heaviest contacts of the first cases, where a limit still leaves something."""
    contacts = solved.inner
    places = np.argsort(-np.nan_to_num(contacts.max_pressure.ravel()))[:sample]
    a, b, p0 = (
        getattr(contacts, field).ravel()[places]
        for field in ("semi_major", "semi_minor", "max_pressure")
    )
    begin = time.perf_counter()
    found = [
        life_plain.stress_integral(*map(float, contact), FATIGUE_LIMIT, SCIPY_ACCURACY)
        for contact in zip(a, b, p0, strict=True)
    ]
    spent = (time.perf_counter() - begin) / sample
    own = risk_integral(Ellipses(a, b, p0), FATIGUE_LIMIT)
    worst = float(np.max(np.abs(np.array(found) / own - 1.0)))
    figures = [
        Figure(name, "scipy dblquad and minimize_scalar, a contact", spent, "s"),
        Figure(name, "  the engine is faster by", spent / each, "times"),
    ]
    failed = [f"{name}: scipy differs by {worst:.1e}"] if not worst < STRESS_AGREEMENT else []
    return Findings(figures, [], failed)


def _beside_triple_loop(name: str, median: float) -> Findings:
    """The same question for NSK's 6305 in plain Python; both have to find the same balls."""
    one = catalogue().find("6305").bearing
    sizes = (1e3 * ball_sizes()).tolist()
    tables = (
        dynamic_factor(np.arange(1, 41) / 100.0).tolist(),
        static_factor(np.arange(41) / 100.0).tolist(),
    )
    assert one.dynamic_rating is not None
    assert one.static_rating is not None
    begin = time.perf_counter()
    balls, ball = life_plain.infer(
        1e3 * one.bore, 1e3 * one.outside_diameter, one.dynamic_rating, one.static_rating,
        sizes, *tables,
    )  # fmt: skip
    spent = 1e3 * (time.perf_counter() - begin)
    own = inferred_geometry(one)[0]
    same = balls == own.ball_count and abs(ball - 1e3 * own.ball_diameter) < 1e-6
    figures = [
        Figure(name, "inference, triple loop in plain Python", spent, "ms"),
        Figure(name, "  the engine is faster by", spent / median, "times"),
    ]
    return Findings(figures, [], [] if same else [f"{name}: the triple loop finds other balls"])


def _search_figures(name: str, known: Catalogue) -> list[Figure]:
    """The slowest key of what somebody types, in the built-in list and in the largest allowed."""
    many = tuple(
        dataclasses.replace(bearing, designation=f"{bearing.designation}-{copy}")
        for copy in range(20_000 // len(known.bearings))
        for bearing in known.bearings
    )
    names = [bearing.designation for bearing in known.bearings]

    def slowest(catalog: Catalogue) -> float:
        return 1e3 * max(alternately([partial(catalog.search, text) for text in TYPED], 5))

    plain = 1e3 * max(alternately([partial(life_plain.search, names, t) for t in TYPED], 3))
    own, target = slowest(known), below(KEYSTROKE_MS)
    return [
        Figure(name, f"search, {len(names)} bearings, slowest key", own, "ms", target),
        Figure(name, f"search, {len(many)} bearings, slowest key", slowest(Catalogue(many)), "ms"),
        Figure(name, "search, list comprehension", plain, "ms"),
        Figure(name, "  the catalogue is faster by", plain / own, "times"),
    ]


if __name__ == "__main__":
    for one in (
        measure(CASES, 2000, 3),
        measure_stress_volume(STRESS_CASES, 1, 3),
        measure_catalogue(20),
    ):
        for figure in one.figures:
            print(f"{figure.name}: {figure.value:.3g} {figure.unit}")
        for failure in one.failures:
            print("Failed:", failure)
