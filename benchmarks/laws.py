"""What every converged equilibrium has to obey, worked out anew from its own numbers.

Nothing of the solver is used here: a case is read, and of its result the displacement of the
ring and the table of the balls. Loads come from Hertz's exact theory by SciPy's elliptic
integrals, forces are added up in the plane of every ball, and the ring's balance in space. The
random duties are wider than anybody's: light loads at full speed, large clearances, held and free
tilts, every raceway control, either ring or both turning, D/d_m to the geometric limit.
"""

from __future__ import annotations

import math
import time
from collections import Counter
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from scipy.special import ellipe, ellipk

import rolamento
from benchmarks.figures import Figure, Findings
from rolamento.case.model import CageKind, RacewayControl

Floats = NDArray[np.float64]

PROMISED: Final = 1e-8
"""Of the loads: the residual that a converged case may have."""
FLOOR: Final = 1e-6
"""Of the heaviest ball's load: below it a ball's own load is no scale."""
ROUNDING: Final = 2e-16
CASES_PER_BEARING: Final = 200
CONTROLS: Final[tuple[RacewayControl, ...]] = ("outer", "inner", "jones", "none")
CAGES: Final[tuple[CageKind, ...]] = ("loose", "rigid")


@dataclass(slots=True)
class Worst:
    """The greatest violation of each law so far, and the case of it."""

    values: dict[str, float] = field(default_factory=dict)
    cases: dict[str, str] = field(default_factory=dict)
    broken: Counter[str] = field(default_factory=Counter)

    def note(self, law: str, values: Floats, limit: float, case: rolamento.Case, duty: Any) -> None:
        """Take in one law's values over cases; above the limit a case breaks it."""
        if not values.size:
            return
        self.broken[law] += int(np.sum(~(values <= limit)))
        index = int(np.argmax(np.where(np.isnan(values), np.inf, values)))
        if not values[index] <= self.values.get(law, -1.0):
            self.values[law] = float(values[index])
            self.cases[law] = describe(case, duty, index)


def describe(case: rolamento.Case, duty: dict[str, Floats], index: int) -> str:
    """All that is needed to solve a case again; SI units where none is written."""
    given = {name: float(values[index]) for name, values in duty.items()}
    return f"{case.to_mapping()!r} | {given!r}"


def hertz_stiffness(rolling: Floats, across: float, modulus: float) -> Floats:
    """K of Q = K δ^1.5 from sums of principal curvatures, N/m^1.5; modulus: E', Pa."""
    total = rolling + across
    difference = np.abs(rolling - across) / total

    def excess(k: Floats) -> Floats:
        m = 1.0 - k**-2.0
        first, second = ellipk(m), ellipe(m)
        return ((k * k + 1.0) * second - 2.0 * first) / ((k * k - 1.0) * second) - difference

    before = 1.0339 * ((1.0 + difference) / (1.0 - difference)) ** 0.636
    k, f_before = 1.003 * before, excess(before)
    for _ in range(14):
        f = excess(k)
        flat = f == f_before
        slope = np.where(flat, 1.0, (f - f_before) / np.where(flat, 1.0, k - before))
        before, f_before, k = k, f, k - np.where(flat, 0.0, f / slope)
    m = 1.0 - k**-2.0
    semi_major = np.cbrt(6.0 * k * k * ellipe(m) / (np.pi * total * modulus))
    return np.asarray((3.0 * ellipk(m) / (np.pi * semi_major * modulus)) ** -1.5)


def check(case: rolamento.Case, batch: Any, duty: dict[str, Floats], worst: Worst) -> None:
    """Take the converged cases of a batch of one row through all laws."""
    good = np.flatnonzero(batch.converged)
    if not good.size:
        return
    bearing, model = case.bearing, case.model
    duty = {name: np.broadcast_to(values, len(batch))[good] for name, values in duty.items()}
    inner, outer, motion = batch.inner, batch.outer, batch.elements
    q_i, q_o = inner.load[good], outer.load[good]
    a_i, a_o = inner.contact_angle[good], outer.contact_angle[good]
    force, gyro = motion.centrifugal_force[good], motion.gyroscopic_moment[good]
    orbit = motion.orbital_speed[good]
    d, pitch = bearing.ball_diameter, bearing.pitch_diameter
    f_i, f_o = bearing.inner_conformity, bearing.outer_conformity
    l_i, l_o = (f_i - 0.5) * d, (f_o - 0.5) * d
    ring, ball = bearing.ring_material, bearing.ball_material
    modulus = 2.0 / sum((1.0 - m.poisson_ratio**2) / m.youngs_modulus for m in (ring, ball))

    def note(law: str, values: Floats, limit: float) -> None:
        worst.note(law, values, limit, case, duty)

    # on the arc
    pressed_i, pressed_o = q_i > 0.0, q_o > 0.0
    steepest = np.maximum(
        np.where(pressed_i, np.abs(a_i), 0.0), np.where(pressed_o, np.abs(a_o), 0.0)
    ).max(axis=1)
    note("loaded contact beyond 90° (degrees)", np.degrees(steepest) - 90.0, 0.0)

    # Hertz, exactly
    scale = np.maximum(q_i, np.maximum(q_o, force))
    heaviest = np.maximum(scale.max(axis=1, keepdims=True), 1e-9)  # N: less is rounding
    own = np.maximum(scale, FLOOR * heaviest)
    for name, q, alpha, delta, f, sign in (
        ("inner", q_i, a_i, inner.deflection[good], f_i, -1.0),
        ("outer", q_o, a_o, outer.deflection[good], f_o, 1.0),
    ):
        gamma = d * np.cos(alpha) / pitch
        rolling = 2.0 / d / (1.0 + sign * gamma)
        k = hertz_stiffness(rolling, 2.0 / d - 1.0 / (f * d), modulus)
        exact = k * delta**1.5
        error = np.where(q > 0.0, np.abs(exact - q), 0.0) / own
        note(f"{name} load against exact Hertz", error.max(axis=1), PROMISED)

    # every ball in balance
    by_inner = batch.answer.control[good] < 0.0
    share = np.where(by_inner, 2.0, 0.0)
    if model.raceway_control == "none":
        share = np.ones_like(q_i)
    t = gyro / d
    m_i, m_o = share * t, (2.0 - share) * t
    along_x = q_i * np.sin(a_i) - m_i * np.cos(a_i) - q_o * np.sin(a_o) + m_o * np.cos(a_o)
    outward = q_i * np.cos(a_i) + m_i * np.sin(a_i) - q_o * np.cos(a_o) - m_o * np.sin(a_o) + force
    # a load Q turns on an approach that is known to rounding of the groove's offset
    k = q_o / np.where(outer.deflection[good] > 0.0, outer.deflection[good], 1.0) ** 1.5
    known = ROUNDING * max(l_i, l_o) * 10.0 * np.cbrt(k * k * own)
    error = np.hypot(along_x, outward)
    # where balls are taken to be at rest, their inertia is left out: of the heaviest, too little
    beyond = error - known - PROMISED * heaviest
    note("balance of a ball, of its own load", (beyond / own).max(axis=1), PROMISED)
    note("balance of a ball, of the heaviest", ((error - known) / heaviest).max(axis=1), PROMISED)
    at_rest = (duty["inner_speed"] == 0.0) & (duty["outer_speed"] == 0.0)
    unlike = (np.abs(q_i - q_o) - known).max(axis=1) / heaviest[:, 0]
    note("at rest Q_i = Q_o", np.where(at_rest, unlike, 0.0), PROMISED)

    # the ring in balance, in space
    psi = motion.azimuth[good]
    if bearing.contact_angle is not None:
        free_angle = bearing.contact_angle
    else:
        assert bearing.diametral_clearance is not None
        free_angle = math.acos(min(1.0, 1.0 - bearing.diametral_clearance / (2.0 * (l_i + l_o))))
    radius = pitch / 2.0 + l_i * math.cos(free_angle)
    f_x = q_i * np.sin(a_i) - m_i * np.cos(a_i)
    f_r = q_i * np.cos(a_i) + m_i * np.sin(a_i)
    arm = radius * f_x + m_i * f_i * d
    reaction = np.stack(
        [
            f_x.sum(axis=1),
            (f_r * np.sin(psi)).sum(axis=1),
            (f_r * np.cos(psi)).sum(axis=1),
            (arm * np.cos(psi)).sum(axis=1) / radius,
            -(arm * np.sin(psi)).sum(axis=1) / radius,
        ],
        axis=1,
    )
    load = batch.load.array[good] / np.array([1.0, 1.0, 1.0, radius, radius])
    ring_scale = np.maximum(np.abs(load).max(axis=1), heaviest[:, 0])
    unbalanced = np.abs(reaction - load).max(axis=1) - known.sum(axis=1)
    note("balance of the ring", unbalanced / np.where(ring_scale > 0.0, ring_scale, 1.0), PROMISED)

    # the vectors close: the balls stand where the ring's displacement puts the grooves
    u = batch.displacement.array[good]
    if bearing.contact_angle is not None:
        a10, a20 = (l_i + l_o) * math.sin(free_angle), (l_i + l_o) * math.cos(free_angle)
    else:
        a10, a20 = 0.0, l_i + l_o - bearing.diametral_clearance / 2.0
    c, s = np.cos(psi), np.sin(psi)
    a1 = a10 + u[:, :1] + radius * (c * u[:, 3:4] - s * u[:, 4:5])
    a2 = a20 + c * u[:, 2:3] + s * u[:, 1:2]
    reach_i, reach_o = l_i + inner.deflection[good], l_o + outer.deflection[good]
    gap = np.hypot(
        a1 - reach_i * np.sin(a_i) - reach_o * np.sin(a_o),
        a2 - reach_i * np.cos(a_i) - reach_o * np.cos(a_o),
    )
    both = pressed_i & pressed_o
    note("the vectors close (m over L)", np.where(both, gap, 0.0).max(axis=1) / (l_i + l_o), 1e-12)

    # orbits: control by the inner race itself takes a ball beyond the rings' speeds where the share
    # (1 + γ cos α_o) / (1 + cos(α_i - α_o)) exceeds 1, the angles far apart
    shared = ~by_inner | (d / pitch * np.cos(a_o) <= np.cos(a_i - a_o))
    slow = np.minimum(duty["inner_speed"], duty["outer_speed"])[:, np.newaxis]
    fast = np.maximum(duty["inner_speed"], duty["outer_speed"])[:, np.newaxis]
    speed = np.maximum(np.abs(slow), np.abs(fast))
    outside = np.maximum(slow - orbit, orbit - fast) / np.where(speed > 0.0, speed, 1.0)
    note("orbit outside the rings' speeds", np.where(shared, outside, 0.0).max(axis=1), 1e-12)
    mass = ball.density * math.pi / 6.0 * d**3
    most = 0.5 * mass * pitch * speed**2
    part = np.where(shared, force, 0.0) / np.where(most > 0.0, most, 1.0)
    note("F_c beyond the fastest orbit's", part.max(axis=1), 1.0)


def random_case(random: np.random.Generator) -> rolamento.Case:
    """A bearing of 3 to 60 balls and a model, any of those that raceway control knows."""
    balls = int(random.integers(3, 61))
    diameter = math.exp(random.uniform(math.log(1e-3), math.log(60e-3)))
    closest = diameter / math.sin(math.pi / balls)
    f_i, f_o = random.uniform(0.503, 0.6, 2)
    total = (f_i + f_o - 1.0) * diameter
    shape: dict[str, float] = {}
    if random.random() < 0.5:
        shape["contact_angle"] = math.radians(random.uniform(0.0, 60.0))
    else:
        shape["diametral_clearance"] = random.uniform(-0.005, 0.15) * total
    bearing = rolamento.Bearing(
        ball_count=balls,
        ball_diameter=diameter,
        pitch_diameter=closest * math.exp(random.uniform(math.log(1.02), math.log(2.5))),
        inner_conformity=float(f_i),
        outer_conformity=float(f_o),
        ball_material="Si3N4" if random.random() < 0.3 else "100Cr6",
        **shape,
    )
    control = CONTROLS[int(random.choice(4, p=[0.55, 0.15, 0.15, 0.15]))]
    cage = CAGES[int(random.random() < 0.2)]
    return rolamento.Case(
        bearing=bearing,
        duty=rolamento.Duty(first_ball_azimuth=float(random.choice([0.0, random.uniform(0, 6.2)]))),
        model=rolamento.Model(raceway_control=control, cage=cage),
    )


def random_duty(
    random: np.random.Generator, bearing: rolamento.Bearing, cases: int
) -> dict[str, Floats]:
    """Duties for a bearing: loads over seven decades, any speeds, tilts held or moments given."""
    capacity = 40e6 * bearing.ball_count * bearing.ball_diameter**2
    size = capacity * 10.0 ** random.uniform(-7.0, 0.0, cases)
    angle = random.uniform(0.0, 0.5 * math.pi, cases)
    duty: dict[str, Floats] = {
        "fz": size * np.sin(angle) * random.choice([0.0, 1.0], cases, p=[0.15, 0.85]),
        "fy": size * random.uniform(-0.4, 0.4, cases) * random.choice([0.0, 1.0], cases),
    }
    if random.random() < 0.8:
        duty["fx"] = size * np.cos(angle)
    else:
        duty["x"] = random.uniform(0.0, 0.02, cases) * bearing.ball_diameter
    if random.random() < 0.3:
        moment = size * bearing.pitch_diameter * random.uniform(-0.1, 0.1, (2, cases))
        duty["my"], duty["mz"] = moment
    else:
        tilt = math.radians(0.15) * random.choice([0.0, 1.0], cases)
        duty["ry"], duty["rz"] = tilt * random.uniform(-1.0, 1.0, (2, cases))
    top = 2500.0 / bearing.pitch_diameter * math.pi / 30.0
    speed = top * 10.0 ** random.uniform(-4.0, 0.0, cases) * random.choice([-1.0, 1.0], cases)
    speed *= random.choice([0.0, 1.0], cases, p=[0.05, 0.95])
    turning = random.choice(4, cases, p=[0.5, 0.25, 0.15, 0.1])  # inner, outer, both, against
    ratio = np.select([turning == 1, turning == 2, turning == 3], [1.0, 0.7, -0.7], 0.0)
    duty["inner_speed"] = np.where(turning == 1, 0.0, speed)
    duty["outer_speed"] = ratio * speed * np.where(turning > 1, random.uniform(0, 1, cases), 1.0)
    return duty


def turned_against(random: np.random.Generator, duty: dict[str, Floats]) -> dict[str, Floats]:
    """The same duties at a hundredth of the load, the rings turning against each other."""
    light = {name: 1e-2 * duty[name] for name in ("fx", "fy", "fz", "my", "mz") if name in duty}
    inner = np.where(duty["inner_speed"] == 0.0, duty["outer_speed"], duty["inner_speed"])
    outer = -inner * random.uniform(0.1, 1.0, len(inner))
    return {**duty, **light, "inner_speed": inner, "outer_speed": outer}


def measure(cases: int, seed: int = 13) -> Findings:
    """Solve so many random cases, check all that converged, and count how the others end.

    Rings that turn against each other at light load, which may have several equilibria, are a
    tenth as many more, counted by themselves.
    """
    findings = _measured("laws over random duties", cases, seed, against=False)
    findings.add(
        _measured("laws, rings against each other at light load", cases // 10, seed, against=True)
    )
    return findings


def _measured(group: str, cases: int, seed: int, *, against: bool) -> Findings:
    random, worst, counts = np.random.default_rng(seed), Worst(), Counter[str]()
    ordinary: Counter[str] = Counter()
    slowest = 0.0
    for first in range(0, cases, CASES_PER_BEARING):
        lot = min(CASES_PER_BEARING, cases - first)
        case = random_case(random)
        duty = random_duty(random, case.bearing, lot)
        if against:
            duty = turned_against(random, duty)
        start = time.perf_counter()
        batch = rolamento.solve(case, threads=1, **duty)
        if first:  # the first one compiles
            slowest = max(slowest, (time.perf_counter() - start) / lot)
        counts.update(batch.status.code.tolist())
        opposed = duty["inner_speed"] * duty["outer_speed"] < 0.0
        ordinary.update(batch.status.code[~opposed].tolist())
        check(case, batch, duty, worst)
    figures = [
        Figure(group, status.replace("_", " "), 100.0 * count / cases, "%")
        for status, count in counts.most_common()
    ]
    if not against:
        share = 100.0 * ordinary["not_converged"] / max(sum(ordinary.values()), 1)
        figures.append(Figure(group, "not converged, rings not against each other", share, "%"))
    figures.append(Figure(group, "slowest bearing, a case", 1e3 * slowest, "ms"))
    figures += [Figure(group, law, value) for law, value in worst.values.items()]
    failures = [
        f"{law}: {count} cases, the worst {worst.values[law]:.1e}: {worst.cases[law]}"
        for law, count in worst.broken.items()
        if count
    ]
    return Findings(figures, [], failures)
