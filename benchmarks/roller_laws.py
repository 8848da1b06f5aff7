"""What every converged equilibrium of rollers has to obey, worked out anew from its own numbers.

As `benchmarks.laws` does for balls, and nothing of the solver is used: of a result its place of the
ring, the approach and tilt of every roller, its speed and its loads are read. The profile, the law
of a slice, the points and normals of the contacts and the direction of the rib's force are written
down here once more, and force and moment of every roller and of the ring are added up in the plane
and in space. Duties are wider than anybody's: loads over seven decades, speeds from 10⁻³ rpm to the
limit, tilts held and free, clearances and interferences, ribs with and without play.

Two more laws need a second solution: a case is the same to the last bit alone and among others, in
whatever order and by however many threads; and the same with both rings turning the other way.
"""

from __future__ import annotations

import math
import time
from collections import Counter
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

import rolamento
from benchmarks.figures import Figure, Findings, below
from benchmarks.laws import Worst, describe
from rolamento.case.roller_bearing import RollerBearing
from rolamento.status import NOT_CONVERGED

Floats = NDArray[np.float64]

CASES_PER_BEARING: Final = 100
KINDS: Final = ("tapered", "cylindrical", "ribbed", "needle")
FASTEST: Final = 1e6
"""Of n d_pw, mm/min: twice what catalogues allow such bearings."""
SLOWEST: Final = 1e-3
"""rpm."""
STEEL: Final = 35948e6
"""c_L / L_we^(8/9) of both contacts of a steel roller in line, N/m²; ISO/TS 16281:2008."""
PROMISED: Final = 1e-8
"""Of the loads: the residual that a converged case may have."""
NEGLIGIBLE: Final = 1e-7
"""Of the roller's diameter: an approach whose load counts as none (docs/theory/rollers.md)."""
MOST_LEFT: Final = 0.1
"""%, of cases that may end as not converged."""
LISTED: Final = 6
"""Most of those whose parameters are shown."""
AGAIN: Final = 10
"""Every so many bearings are solved once more."""
TRIED_ALONE: Final = 3
"""Cases of a bearing that are solved once more by themselves."""


def random_case(random: np.random.Generator) -> rolamento.Case:
    """A bearing of 8 to 40 rollers of one kind, its profile and model."""
    kind = KINDS[int(random.integers(len(KINDS)))]
    rollers = int(random.integers(8, 41))
    diameter = math.exp(random.uniform(math.log(2e-3), math.log(60e-3)))
    closest = diameter / math.sin(math.pi / rollers)
    long = random.uniform(2.5, 7.0) if kind == "needle" else random.uniform(0.8, 2.4)
    fields: dict[str, Any] = {
        "element": "cylindrical" if kind == "ribbed" else kind,
        "roller_count": rollers,
        "roller_diameter": diameter,
        "pitch_diameter": closest * random.uniform(1.02, 1.4),
        "effective_length": long * diameter,
        "roller_length": 1.05 * long * diameter,
        "roller_profile": {"kind": "none" if random.random() < 0.1 else "iso"},
    }
    if kind == "tapered":
        fields["contact_angle"] = math.radians(random.uniform(9.0, 30.0))
    else:
        fields["diametral_clearance"] = random.uniform(-2e-4, 2e-2) * diameter
    if kind == "ribbed":
        fields["inner_ribs"] = fields["outer_ribs"] = "both"
        fields["axial_play"] = random.uniform(0.0, 0.02) * diameter
    return rolamento.Case(
        bearing=RollerBearing(**fields),
        duty=rolamento.Duty(first_ball_azimuth=float(random.choice([0.0, random.uniform(0, 6.2)]))),
    )


def random_duty(
    random: np.random.Generator, bearing: RollerBearing, cases: int
) -> dict[str, Floats]:
    """Duties for a bearing: loads over seven decades, any speeds, tilts held or moments given."""
    area = bearing.roller_count * bearing.roller_diameter * bearing.effective_length
    size = 1e8 * area * 10.0 ** random.uniform(-7.0, 0.0, cases)
    around = random.uniform(0.0, 2.0 * math.pi, cases)
    duty: dict[str, Floats] = {"fz": size * np.cos(around), "fy": size * np.sin(around)}
    if bearing.element == "tapered":
        # what the radial load alone presses out of the cones, and up to six times as much
        least = size * math.tan(bearing.contact_angle or 0.0)
        if random.random() < 0.7:
            duty["fx"] = least * random.uniform(0.6, 6.0, cases)
        else:
            duty["x"] = random.uniform(0.0, 0.005, cases) * bearing.roller_diameter
    elif bearing.inner_ribs == "both":
        duty["fx"] = size * random.uniform(-0.3, 0.3, cases)
    else:
        duty["x"] = np.zeros(cases)
    if random.random() < 0.25:
        moment = size * bearing.effective_length * random.uniform(-0.1, 0.1, (2, cases))
        duty["my"], duty["mz"] = moment
    else:
        tilt = 4e-3 * random.choice([0.0, 1.0], cases)
        duty["ry"], duty["rz"] = tilt * random.uniform(-1.0, 1.0, (2, cases))
    top = FASTEST / (1e3 * bearing.pitch_diameter)
    speed = SLOWEST * (top / SLOWEST) ** random.uniform(0.0, 1.0, cases) * math.pi / 30.0
    speed *= random.choice([-1.0, 0.0, 1.0], cases, p=[0.475, 0.05, 0.475])
    turning = random.choice(4, cases, p=[0.6, 0.2, 0.1, 0.1])  # inner, outer, both, against
    ratio = np.select([turning == 1, turning == 2, turning == 3], [1.0, 0.7, -0.7], 0.0)
    duty["inner_speed"] = np.where(turning == 1, 0.0, speed)
    duty["outer_speed"] = ratio * speed
    return duty


def profile_drop(bearing: RollerBearing, place: Floats) -> Floats:
    """P(x_k) of the roller, ISO/TS 16281:2008; m."""
    length, diameter = bearing.effective_length, bearing.roller_diameter
    if bearing.roller_profile.kind == "none":
        return np.zeros_like(place)
    if bearing.element == "tapered":
        factor, part = 0.00045, np.abs(2.0 * place / length)
    elif length <= 2.5 * diameter:
        factor, part = 0.00035, np.abs(2.0 * place / length)
    else:
        straight = length - 2.5 * diameter
        factor = 0.0005
        part = np.maximum((np.abs(2.0 * place) - straight) / (2.5 * diameter), 0.0)
    return np.asarray(factor * diameter * np.log(1.0 / (1.0 - part**2)))


def check(
    case: rolamento.Case, batch: rolamento.Solved, duty: dict[str, Floats], worst: Worst
) -> None:
    """Take the converged cases of a batch of one row through all laws."""
    good = np.flatnonzero(batch.converged)
    bearing = case.bearing
    assert isinstance(bearing, RollerBearing)
    if not good.size or batch.rollers is None:
        return
    duty = {name: np.broadcast_to(values, len(batch))[good] for name, values in duty.items()}

    def note(law: str, values: Floats, limit: float) -> None:
        worst.note(law, values, limit, case, duty)

    half, angle = bearing.roller_half_angle or 0.0, bearing.contact_angle or 0.0
    axis, radius = angle - half, 0.5 * bearing.roller_diameter
    length, pitch = bearing.effective_length, bearing.pitch_diameter
    rollers = batch.rollers
    place = rollers.slice_place[good]
    drop, width = profile_drop(bearing, place), length / place.shape[-1]

    # the law of a slice, from where ring and roller are
    psi = batch.elements.azimuth[good]
    c, s = np.cos(psi), np.sin(psi)
    u = batch.displacement.array[good]
    theta = u[:, 3:4] * c - u[:, 4:5] * s
    slopes = rollers.tilt[good], -rollers.tilt[good] - theta
    approaches = batch.outer.approach[good], batch.inner.approach[good]
    loads = rollers.outer.load_per_length[good], rollers.inner.load_per_length[good]
    constant = 2.0 ** (10.0 / 9.0) * STEEL * length ** (8.0 / 9.0) / length
    steel = bearing.ring_material
    modulus = steel.youngs_modulus / (1.0 - steel.poisson_ratio**2)
    constant *= modulus / (207e9 / (1.0 - 0.3**2))
    none = constant * length * (NEGLIGIBLE * bearing.roller_diameter) ** (10.0 / 9.0)
    q_o, q_i = (q.sum(axis=-1) * width for q in loads)
    force = batch.elements.centrifugal_force[good]
    heaviest = np.maximum(np.maximum(q_i, q_o), np.maximum(force, none)).max(axis=1)
    own = np.maximum(np.maximum(q_i, q_o), np.maximum(force, none))
    for name, approach, slope, q in zip(("outer", "inner"), approaches, slopes, loads, strict=True):
        depth = approach[..., np.newaxis] + slope[..., np.newaxis] * place - drop
        exact = constant * np.maximum(depth, 0.0) ** (10.0 / 9.0)
        error = np.abs(exact - q).sum(axis=-1) * width
        note(f"{name} slices against their law", (error / own).max(axis=1), PROMISED)

    # every roller in balance in its plane: points and normals, t along and n across its axis
    t, n = np.array([math.cos(axis), -math.sin(axis)]), np.array([math.sin(axis), math.cos(axis)])
    mass_centre = 0.0
    if half > 0.0:
        whole, taper = bearing.roller_length, math.tan(half)
        mass_centre = 2.0 * radius * taper * whole**2 / 12.0
        mass_centre /= radius**2 + taper**2 * whole**2 / 12.0
    sums = np.zeros((len(good), psi.shape[1], 3))
    on_ring = np.zeros_like(sums)
    for q, side in zip(loads, (1.0, -1.0), strict=True):
        normal = n * math.cos(half) + side * t * math.sin(half)
        along = np.array([normal[1], -normal[0]])
        at = side * radius * n + place[..., np.newaxis] * along
        f = -side * width * q[..., np.newaxis] * normal
        moment = f[..., 0] * at[..., 1] - f[..., 1] * at[..., 0]
        part = np.concatenate([f, moment[..., np.newaxis]], axis=-1).sum(axis=2)
        sums += part
        on_ring += 0.0 if side > 0.0 else part
    rib = rollers.rib_force[good]
    if half > 0.0:
        below = radius + 0.5 * bearing.roller_length * math.tan(half) - bearing.contact_height
        sphere = radius / math.tan(half) + 0.5 * bearing.roller_length
        sine = below / sphere
        push = math.sqrt(1.0 - sine**2) * t + sine * n
        at = -0.5 * bearing.roller_length * t - below * n
        turn = push[0] * at[1] - push[1] * at[0]
        part = rib[..., np.newaxis] * np.array([*push, turn])
        sums += part
        on_ring += part
    else:
        # one end pushes below the axis, the other above: a couple, and the axial force goes through
        reach = (radius - bearing.contact_height) * np.where(bearing.inner_ribs == "none", 0, 1)
        sums[..., 2] -= 2.0 * reach * rib
        on_ring[..., 0] += rib
        on_ring[..., 2] -= reach * rib
    sums[..., 1] += force
    sums[..., 2] += force * mass_centre * math.cos(axis)
    sums[..., 2] -= batch.elements.gyroscopic_moment[good]
    error = np.hypot(sums[..., 0], sums[..., 1])
    note("balance of a roller, of its own load", (error / own).max(axis=1), PROMISED)
    lever = np.abs(sums[..., 2]) / (0.5 * length)
    note("balance of its moments", (lever / own).max(axis=1), PROMISED)
    pulling = np.where(half > 0.0, np.maximum(-rib, 0.0), 0.0) / own
    note("a rib that pulls", pulling.max(axis=1), PROMISED)

    # the ring in balance, in space
    f_x, f_r = on_ring[..., 0], on_ring[..., 1]
    arm = 0.5 * pitch
    moment = on_ring[..., 2] + arm * f_x
    total = np.stack(
        [
            f_x.sum(axis=1),
            (f_r * s).sum(axis=1),
            (f_r * c).sum(axis=1),
            (moment * c).sum(axis=1) / arm,
            -(moment * s).sum(axis=1) / arm,
        ],
        axis=1,
    )
    load = batch.load.array[good] / np.array([1.0, 1.0, 1.0, arm, arm])
    size = np.maximum(np.abs(load).max(axis=1), heaviest)
    note("balance of the ring", np.abs(total - load).max(axis=1) / size, PROMISED)

    # the gaps close: both contacts' approaches add up to what the ring's place leaves
    a, b = u[:, :1] + arm * theta, u[:, 1:2] * s + u[:, 2:3] * c
    if half == 0.0:
        gap = 0.5 * (bearing.diametral_clearance or 0.0)
        closed = np.abs(approaches[0] + approaches[1] - b + gap)
        note("the gaps close (m over D)", closed.max(axis=1) / bearing.roller_diameter, 1e-12)
    else:
        # the roller moves along the rib's normal with the ring, and turns about where it touches
        cosine = math.cos(math.asin(sine))
        ring_arm = 0.5 * bearing.roller_length * sine - below * cosine
        turn = slopes[1]
        e_i, e_o = (n * math.cos(half) + side * t * math.sin(half) for side in (-1.0, 1.0))
        f = push
        across = np.array([-f[1], f[0]])
        reach = radius * math.sin(half)
        inner_rest = approaches[1] + turn * reach - ring_arm * turn * (e_i @ f)
        shift = -inner_rest / (e_i @ across)
        move = shift[..., np.newaxis] * across - (turn * ring_arm)[..., np.newaxis] * f
        outer = e_o[0] * (a + move[..., 0]) + e_o[1] * (b + move[..., 1])
        outer += (theta + turn) * reach
        closed = np.abs(outer - approaches[0])
        note("the gaps close (m over D)", closed.max(axis=1) / bearing.roller_diameter, 1e-12)


def check_again(
    random: np.random.Generator,
    case: rolamento.Case,
    batch: rolamento.Solved,
    duty: dict[str, Floats],
    worst: Worst,
) -> None:
    """Solve the cases once more: some alone, all in another order, and with both rings reversed."""
    count = len(batch)
    order = random.permutation(count)
    again = [(order, _solved(case, duty, order, threads=2))]
    for index in random.choice(count, min(TRIED_ALONE, count), replace=False):
        which = np.array([index])
        again.append((which, _solved(case, duty, which, threads=1)))
    for which, other in again:
        _compare("alone or among others", case, batch, duty, which, other, 0.0, worst)
    backward = {**duty, **{k: -duty[k] for k in ("inner_speed", "outer_speed")}}
    every = np.arange(count)
    reversed_ = _solved(case, backward, every, threads=1)
    _compare("turning backward", case, batch, duty, every, reversed_, PROMISED, worst)


def _solved(
    case: rolamento.Case, duty: dict[str, Floats], which: NDArray[np.intp], threads: int
) -> rolamento.Solved:
    some: dict[str, Any] = {name: values[which] for name, values in duty.items()}
    return rolamento.solve(case, threads=threads, **some)


def _compare(
    law: str,
    case: rolamento.Case,
    batch: rolamento.Solved,
    duty: dict[str, Floats],
    which: NDArray[np.intp],
    other: rolamento.Solved,
    limit: float,
    worst: Worst,
) -> None:
    """Compare a second solution of some cases: status, and the rollers' loads over the heaviest."""
    some = {name: values[which] for name, values in duty.items()}
    unlike = (batch.status.number[which] != other.status.number).astype(np.float64)
    worst.note(f"{law}: status", unlike, 0.0, case, some)
    own, there = batch.inner.load[which], other.inner.load
    both = batch.converged[which] & other.converged
    heaviest = np.maximum(np.where(both[:, np.newaxis], own, 1.0).max(axis=1), 1e-9)
    apart = np.where(both, np.abs(own - there).max(axis=1), 0.0) / heaviest
    worst.note(f"{law}: loads", apart, limit, case, some)


def measure(cases: int, seed: int = 33) -> Findings:
    """Solve so many random cases, check all that converged, and list those that did not."""
    random, worst, counts = np.random.default_rng(seed), Worst(), Counter[str]()
    slowest, left = 0.0, list[str]()
    for first in range(0, cases, CASES_PER_BEARING):
        lot = min(CASES_PER_BEARING, cases - first)
        case = random_case(random)
        bearing = case.bearing
        assert isinstance(bearing, RollerBearing)
        duty = random_duty(random, bearing, lot)
        start = time.perf_counter()
        batch = rolamento.solve(case, threads=1, **duty)
        if first:  # the first one compiles
            slowest = max(slowest, (time.perf_counter() - start) / lot)
        counts.update(batch.status.code.tolist())
        stuck = np.flatnonzero(batch.status.number == NOT_CONVERGED)
        left += [f"{batch.status.residual[i]:.1e}: {describe(case, duty, i)}" for i in stuck]
        check(case, batch, duty, worst)
        if first % (AGAIN * CASES_PER_BEARING) == 0:
            check_again(random, case, batch, duty, worst)
    group = "laws over random duties of rollers"
    figures = [
        Figure(group, status.replace("_", " "), 100.0 * count / cases, "%")
        for status, count in counts.most_common()
        if status != "not_converged"
    ]
    figures.append(Figure(group, "not converged", 100.0 * len(left) / cases, "%", below(MOST_LEFT)))
    figures.append(Figure(group, "slowest bearing, a case", 1e3 * slowest, "ms"))
    figures += [Figure(group, law, value) for law, value in worst.values.items()]
    failures = [
        f"{law}: {count} cases, the worst {worst.values[law]:.1e}: {worst.cases[law]}"
        for law, count in worst.broken.items()
        if count
    ]
    return Findings(figures, [f"not converged, residual {one}" for one in left[:LISTED]], failures)
