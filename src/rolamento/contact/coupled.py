"""A roller on a race cut into slices that feel each other through the bodies.

Slice k, of width w, carries the load per length q_k as a Hertz pressure over its own half width
b_k. At the middle of slice l, j = |l - k| slices away, it presses the surfaces apart by

    u_lk = (2 q_k / (π E')) [g_j(b_k/w) - s B_j],
    g_j(β) = G(j + ½, β) - G(j - ½, β),     G(a, β) = ⟨asinh(a/(β |t|))⟩,

the mean being over the half ellipse of pressure, -1 < t < 1: Boussinesq's point loads summed over
the slice. Loads are found that press and do not pull:

    Σ_k u_lk = δ + x_l tan ψ - P(x_l) where q_l > 0,   at least that where q_l = 0.

**What the approach is.** Half-spaces approach each other from infinity. That is the race, backed
by its ring and housing; but the roller's other side, where the other race presses, is only its
diameter away. Johnson's compression of a cylinder from the contact to its axis is, of the length
of the roller's share s in the compliance 2/E' (eq. 5.57),

    δ_r = (2 q/(π E')) s [2 ln(2D/b) - 1],

and a long line on a half-space less its image at the depth h gives 2 ln(2h/b) + 1 in the bracket:
they are one where h = D/e. So the image,

    B_j = asinh((j + ½) w/h) - asinh((j - ½) w/h),      h = D/e = 0.368 D,

takes away what the roller does not have: the approach is that of the race to the *roller's axis*,
and slices farther apart than about a roller's radius feel each other through the race alone. It
does not change the pressures' edges, nor a roller short against its diameter. Without it (s = 0)
it is the plain half-space.

G has no closed form, its derivative has: ∂G/∂ln β = -(4/π) a D(m)/√(a² + β²), m = β²/(a² + β²),
D being the associate elliptic integral; a table of it is integrated once for a number of slices.

Sources: Boussinesq (1885) and Johnson (1985), sections 3.2 and 5.6; Reusner (1977) for slices
with a half ellipse of pressure each; de Mul, Kalker and Fredriksson (1986) for their use in
bearings; Polonsky and Keer (1999) for the conditions of contact.
"""

from __future__ import annotations

from functools import lru_cache
from math import exp, log
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.contact.line import half_width, max_pressure, slice_places
from rolamento.numerics import FloatArray
from rolamento.numerics import FloatArray as Array
from rolamento.numerics.compiled import filling, kernel, vector_loop
from rolamento.numerics.elliptic import associate
from rolamento.numerics.threads import goes_plainly, ready
from rolamento.records import frozen

__all__ = [
    "CoupledPress",
    "body_term",
    "coupled_press",
    "coupled_slices",
    "influence_table",
    "scratch",
]

_FIRST: Final = -8.0
"""ln(b/w) at which the table begins: below, it goes on as a straight line, which it is."""
_STEPS_PER_UNIT: Final = 8
_POINTS: Final = 14 * _STEPS_PER_UNIT + 1
"""Up to b/w = e^6: 1001 slices of a roller half as long as thick, under twenty GPa."""
_STEP: Final = 1.0 / _STEPS_PER_UNIT
_NODES: Final = 5
"""Number of nodes of the integration over a step of the table: to rounding."""

_ROUNDS: Final = 60
_BOLD: Final = 15
"""Rounds in which a slice that would pull is let go at once; afterwards it yields by steps."""
_TOLERANCE: Final = 1e-6
"""Fraction of the gap, over the deepest interference, from which one last step of Newton is taken:
it leaves 1e-12 of the load."""
_NO_LOAD: Final = 1e-14
"""Load over the greatest at which a slice that goes on yielding is let go."""


@lru_cache(maxsize=16)
def influence_table(slices: int) -> Array:
    """Return g_j(β) and its slope at the points of the table, for so many slices.

    Returns
    -------
    (points, 2, slices): g_j, and ∂g_j/∂ln β times the distance of the points, at ln β = -8, …, 6.
    Not to be written to.
    """
    edge = np.asarray(
        np.arange(slices + 1) - 0.5, np.float64
    )  # the slice j reaches from j - ½ to j + ½
    node, weight = np.polynomial.legendre.leggauss(_NODES)
    start = np.asarray(_FIRST + _STEP * np.arange(_POINTS), np.float64)
    between = np.asarray(start[:-1, np.newaxis] + 0.5 * _STEP * (node + 1.0), np.float64)
    grown = 0.5 * _STEP * np.tensordot(_slope(edge, between), weight, axes=([1], [0]))
    # far below a: ⟨ln(2a/(β|t|)) + (β t/2a)²⟩ = ln(2a/β) + ln 2 + ½ + β²/(16 a²); G is odd in a
    size = np.abs(edge)
    far = np.log(4.0 * size) - _FIRST + 0.5 + np.exp(2.0 * _FIRST) / (4.0 * size) ** 2
    first = np.sign(edge) * far
    value = first + np.concatenate([np.zeros((1, edge.size)), np.cumsum(grown, axis=0)])
    table = np.stack([np.diff(value, axis=-1), _STEP * np.diff(_slope(edge, start), axis=-1)], 1)
    table.setflags(write=False)
    return np.ascontiguousarray(table)


def _slope(edge: FloatArray, log_beta: FloatArray) -> FloatArray:
    """∂G/∂ln β; the shape of log_beta, and edges last."""
    square = np.exp(2.0 * log_beta)[..., np.newaxis]
    both = edge * edge + square
    return np.asarray(-4.0 / np.pi * edge / np.sqrt(both) * associate(edge * edge / both)[1])


def body_term(slices: int, width: float, roller_diameter: float, share: float) -> Array:
    """Return s B_j, what the roller's compression to its axis is less than a half-space's.

    Parameters
    ----------
    slices : how many.
    width : of a slice; m.
    roller_diameter : D; m. Of a tapered roller its mean.
    share : s, the roller's part of the compliance (`contact.line.roller_share`); 0 for the plain
        half-space.

    Returns
    -------
    (slices,), by the distance of two slices.

    Johnson (1985), eq. 5.57, as stated at the head of this module.
    """
    edge = (np.arange(slices + 1) - 0.5) * (width * exp(1.0) / roller_diameter)
    return np.asarray(share * np.diff(np.arcsinh(edge)))


def scratch(slices: int) -> Array:
    """Return room for the kernel to work in: rows of the matrix with three right sides, and six."""
    return np.empty((slices + 6, slices + 3))


@filling
def coupled_slices(
    approach: float,
    tilt: float,
    place: Array,
    drop: Array,
    width: float,
    compliance: float,
    curvature: Array,
    table: Array,
    body: Array,
    load: Array,
    work: Array,
    answer: Array,
) -> int:
    """Press a roller on a race.

    Parameters
    ----------
    approach : δ, of the race and the roller's axis at its middle; m.
    tilt : tan ψ, the slope of the roller against the race; positive presses the end at +x in.
    place : (n,), x_k; m.
    drop : (n,), P(x_k) of roller and race together; m. Infinite where there is no contact.
    width : of a slice; m.
    compliance : 2/(π E'); 1/Pa.
    curvature : (n,), Σρ in the rolling direction; 1/m.
    table, body : of `influence_table` and `body_term`.
    load : (n,), the loads to begin with (zeros if none are known), and takes q_k; N/m.
    work : of `scratch`, for the kernel.
    answer : (6,), takes load Q (N), moment M = Σ q_k x_k width (N·m), and their derivatives
        ∂Q/∂δ, ∂Q/∂tan ψ, ∂M/∂δ, ∂M/∂tan ψ.

    Returns
    -------
    0; or 1 with NaN where a number is not one, or no loads are found.
    """
    n = place.size
    for i in range(6):
        answer[i] = float("nan")
    if work.shape[0] < n + 6 or work.shape[1] < n + 3 or table.shape[2] != n or body.size != n:
        return 1
    depth, pressed = work[n, :n], work[n + 1, :n]
    deepest = 0.0
    finite = abs(approach) < 1e300 and abs(tilt) < 1e300 and 0.0 < compliance < 1e300
    for k in range(n):
        depth[k] = approach + tilt * place[k] - drop[k]
        deepest = max(deepest, depth[k])
        # a drop may be infinite, but nothing else
        finite = finite and depth[k] < 1e300 and 0.0 < curvature[k] < 1e300
    if finite and deepest <= 0.0:
        for i in range(6):
            answer[i] = 0.0
        for k in range(n):
            load[k] = 0.0
        return 0
    if finite:
        # in the loop, a load per length counts as the length v = q · 2/(π E')
        _begin(depth, deepest, compliance, load, pressed)
        for turn in range(_ROUNDS):
            active = _assemble(depth, width, curvature, table, body, pressed, work)
            if _join(depth, deepest, pressed, work):
                continue
            settled = _residual(depth, deepest, place, active, work)
            if not _solve(active, 3 if settled else 1, work):
                break
            if not settled:
                _step(active, turn < _BOLD, pressed, work)
                continue
            _tell(active, place, width, compliance, pressed, load, work, answer)
            return 0
    for k in range(n):
        load[k] = 0.0
    return 1


@filling
def _begin(depth: Array, deepest: float, compliance: float, load: Array, pressed: Array) -> None:
    """Set loads to begin with: those given, or for want of them a twelfth of the interference."""
    known = False
    for k in range(depth.size):
        if load[k] > 0.0:
            known = True
    for k in range(depth.size):
        pressed[k] = 0.0
        if depth[k] > 0.0:
            start = load[k] * compliance if known else depth[k] / 12.0
            if 0.0 < start < 10.0 * deepest:
                pressed[k] = start


@filling
def _assemble(
    depth: Array,
    width: float,
    curvature: Array,
    table: Array,
    body: Array,
    pressed: Array,
    work: Array,
) -> int:
    """Set displacements of all slices, and the Jacobian and list of the loaded ones; their number.

    work: rows 0 … hold ∂u_l/∂v_k, row n + 2 u, row n + 3 the loaded slices, n + 4 and n + 5 one
    column.
    """
    n = depth.size
    moved, chosen, value, slope = work[n + 2], work[n + 3], work[n + 4], work[n + 5]
    active = 0
    for k in range(n):
        moved[k] = 0.0
        if pressed[k] > 0.0:
            chosen[active] = k
            active += 1
    for column in range(active):
        k = int(chosen[column])
        v = pressed[k]
        at = (0.5 * log(4.0 * v / (curvature[k] * width * width)) - _FIRST) * _STEPS_PER_UNIT
        _influence(at, table, body, value, slope)
        for j in range(k):
            moved[j] += v * value[k - j]
        for j in range(k, n):
            moved[j] += v * value[j - k]
        for row in range(active):
            work[row, column] = slope[abs(int(chosen[row]) - k)]
    return active


@filling
def _influence(at: float, table: Array, body: Array, value: Array, slope: Array) -> None:
    """g_j - s B_j, and with it ∂(v g_j)/∂v: cubic between points, and what it tends to beyond."""
    n = body.size
    last = table.shape[0] - 1
    if 0.0 <= at < last:
        i = int(at)
        t = at - i
        v0 = (1.0 + 2.0 * t) * (1.0 - t) ** 2
        s0 = t * (1.0 - t) ** 2
        v1 = t * t * (3.0 - 2.0 * t)
        s1 = t * t * (t - 1.0)
        # half of the derivative by ln β, which itself is ½ ln v and what does not change
        half = 0.5 * _STEPS_PER_UNIT
        dv = half * 6.0 * t * (t - 1.0)
        ds0 = half * (1.0 - t) * (1.0 - 3.0 * t)
        ds1 = half * t * (3.0 * t - 2.0)
        below, above = table[i], table[i + 1]
        for j in range(n):
            g = v0 * below[0, j] + s0 * below[1, j] + v1 * above[0, j] + s1 * above[1, j]
            d = dv * (below[0, j] - above[0, j]) + ds0 * below[1, j] + ds1 * above[1, j]
            value[j] = g - body[j]
            slope[j] = g - body[j] + d
    elif at < 0.0:
        for j in range(n):
            g = table[0, 0, j] + at * table[0, 1, j]
            value[j] = g - body[j]
            slope[j] = g - body[j] + 0.5 * _STEPS_PER_UNIT * table[0, 1, j]
    else:
        # far wider than the slice the mean goes with 1/β
        fallen = exp((last - at) * _STEP)
        for j in range(n):
            value[j] = fallen * table[last, 0, j] - body[j]
            slope[j] = 0.5 * fallen * table[last, 0, j] - body[j]


@filling
def _join(depth: Array, deepest: float, pressed: Array, work: Array) -> bool:
    """Load the slices into which the race would stand otherwise; whether there are any."""
    n = depth.size
    moved = work[n + 2]
    joined = False
    for k in range(n):
        if pressed[k] == 0.0 and depth[k] - moved[k] > 0.1 * _TOLERANCE * deepest:
            pressed[k] = (depth[k] - moved[k]) / 24.0
            joined = True
    return joined


@filling
def _residual(depth: Array, deepest: float, place: Array, active: int, work: Array) -> bool:
    """Put right sides behind the Jacobian; whether the loaded slices lack next to nothing.

    What they lack; and once that is nothing 1 and x, whose solutions are ∂v/∂δ and ∂v/∂tan ψ.
    """
    n = depth.size
    moved, chosen = work[n + 2], work[n + 3]
    settled = True
    for row in range(active):
        k = int(chosen[row])
        lack = depth[k] - moved[k]
        work[row, active] = lack
        if not abs(lack) <= _TOLERANCE * deepest:
            settled = False
    if settled:
        for row in range(active):
            work[row, active + 1] = 1.0
            work[row, active + 2] = place[int(chosen[row])]
    return settled


@vector_loop
def _solve(active: int, sides: int, work: Array) -> bool:
    """Solve for so many right sides, each replaced by its solution; False for a bad matrix.

    Without a search for pivots: the matrix is near a symmetric, positive one. Two rows at a time
    are taken out of those below: that halves the traffic.
    """
    end = active + sides
    for k in range(0, active, 2):
        first = work[k]
        inverse = 1.0 / first[k]
        if not 0.0 < inverse < 1e300:
            return False
        if k + 1 == active:
            break
        second = work[k + 1]
        share = second[k] * inverse
        for j in range(k + 1, end):
            second[j] -= share * first[j]
        next_inverse = 1.0 / second[k + 1]
        if not 0.0 < next_inverse < 1e300:
            return False
        for i in range(k + 2, active):
            row = work[i]
            one = row[k] * inverse
            two = (row[k + 1] - one * first[k + 1]) * next_inverse
            for j in range(k + 2, end):
                row[j] -= one * first[j] + two * second[j]
    for side in range(active, end):
        for i in range(active - 1, -1, -1):
            row = work[i]
            known = 0.0
            for j in range(i + 1, active):
                known += row[j] * work[j, side]
            row[side] = (row[side] - known) / row[i]
    return True


@filling
def _step(active: int, bold: bool, pressed: Array, work: Array) -> None:
    """Take Newton's step; a slice that would pull is let go."""
    n = pressed.size
    chosen = work[n + 3]
    greatest = 0.0
    for k in range(n):
        greatest = max(greatest, pressed[k])
    for row in range(active):
        k = int(chosen[row])
        new = pressed[k] + work[row, active]
        if new <= 0.0:
            new = 0.0 if bold else 0.2 * pressed[k]
            if new < _NO_LOAD * greatest:
                new = 0.0
        pressed[k] = new


@filling
def _tell(
    active: int,
    place: Array,
    width: float,
    compliance: float,
    pressed: Array,
    load: Array,
    work: Array,
    answer: Array,
) -> None:
    """Take the last step, and sum up loads, moments and derivatives."""
    n = place.size
    chosen = work[n + 3]
    for i in range(6):
        answer[i] = 0.0
    for row in range(active):
        k = int(chosen[row])
        pressed[k] = max(0.0, pressed[k] + work[row, active])
        x, by_approach, by_tilt = place[k], work[row, active + 1], work[row, active + 2]
        answer[0] += pressed[k]
        answer[1] += pressed[k] * x
        answer[2] += by_approach
        answer[3] += by_tilt
        answer[4] += by_approach * x
        answer[5] += by_tilt * x
    for i in range(6):
        answer[i] *= width / compliance
    for k in range(n):
        load[k] = pressed[k] / compliance


@kernel
def press_one(
    approach: float,
    tilt: float,
    place: Array,
    drop: Array,
    width: float,
    compliance: float,
    curvature: Array,
    table: Array,
    body: Array,
    load: Array,
    work: Array,
    answer: Array,
) -> int:
    """`coupled_slices` on its own."""
    return coupled_slices(
        approach, tilt, place, drop, width, compliance, curvature, table, body, load, work, answer
    )


@frozen
class CoupledPress:
    """A roller pressed on a race; NaN where no loads are found. SI.

    place, load_per_length, half_width, max_pressure: (slices,). load N, moment N·m.
    stiffness: (2, 2), of load and moment by approach and tilt. converged.
    """

    place: FloatArray
    load_per_length: FloatArray
    half_width: FloatArray
    max_pressure: FloatArray
    load: float
    moment: float
    stiffness: FloatArray
    converged: bool


def coupled_press(
    approach: float,
    tilt: float,
    drop: ArrayLike,
    *,
    effective_length: float,
    curvature: ArrayLike,
    modulus: float,
    roller_diameter: float,
    share: float = 0.5,
) -> CoupledPress:
    """Press a roller on a race: the kernel `coupled_slices` for a single contact.

    Parameters
    ----------
    approach : δ, of the race and the roller's axis at its middle; m.
    tilt : tan ψ, the slope of the roller against the race; positive presses the end at +x in.
    drop : (slices,), of roller and race together at `slice_places`; m.
    effective_length, roller_diameter : L_we and D_we; m.
    curvature : Σρ in the rolling direction, one or of each slice; 1/m.
    modulus : effective modulus E'; Pa.
    share : the roller's part of the compliance; 0 for a plain half-space.

    Returns
    -------
    CoupledPress.
    """
    drops = np.ascontiguousarray(drop, dtype=np.float64)
    n = drops.size
    place, width = slice_places(effective_length, n), effective_length / n
    rho = np.ascontiguousarray(np.broadcast_to(np.asarray(curvature, np.float64), n))
    load, answer = np.zeros(n), np.zeros(6)
    press = press_one if goes_plainly(press_one, little=False) else ready(press_one)
    number = press(
        approach, tilt, place, drops, width, 2.0 / (np.pi * modulus), rho, influence_table(n),
        body_term(n, width, roller_diameter, share), load, scratch(n), answer,
    )  # fmt: skip
    if number:
        load[:] = np.nan
    return CoupledPress(
        place,
        load,
        half_width(load, rho, modulus),
        max_pressure(load, rho, modulus),
        float(answer[0]),
        float(answer[1]),
        answer[2:].reshape(2, 2),
        number == 0,
    )
