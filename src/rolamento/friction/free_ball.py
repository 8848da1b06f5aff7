"""One ball that friction alone moves: the motion of least power, and what it loses; compiled.

The relative velocity of a contact is linear in V = (drift, roll, twist): with r = σρ(x0) and
y0 = b v

    v_y = drift + r roll - x0 twist,   v_t = y0 twist

and V is linear in the motion of the ball (ball_x, ball_z, orbit). Without tumbling the slip along
rolling, and r and x0, are the same at all points of a place across the ellipse, so that three sums
over the points along it are enough for the power Σ w √(v_y² + v_t² + v0²), its gradient and its
Hessian; the places lie side by side in vector instructions.

`minimum_power` has the same in NumPy, for few balls.
"""

from __future__ import annotations

from math import inf, sqrt
from typing import Final

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.numerics.compiled import filling, kernel, vector_loop

LOAD: Final = 0  # of a contact, rows of `contacts`
COSINE: Final = 1
SINE: Final = 2
SEMI_MAJOR: Final = 3
SEMI_MINOR: Final = 4
RADIUS: Final = 5  # of the deformed surface
LIFT: Final = 6  # from the arc's centre to the ball's
PITCH: Final = 7  # d_m / 2
NUMBERS: Final = 8

VELOCITIES: Final = 3  # drift, roll, twist
# of `sums` of one contact: power, its gradient by V, its Hessian (upper half), and the gradient
# without cancellation
POWER: Final = 0
GRADIENT: Final = 1
HESSIAN: Final = 4
SCALE: Final = 10
SUMS: Final = 13

STEPS: Final = 60
HALVINGS: Final = 30
ARMIJO: Final = 1e-4
TOLERANCE: Final = 1e-9
"""Of the gradient, over the sum of what it is made of."""
NEARLY: Final = 1e-3
"""The same of a stage that is not the last."""
DAMPING: Final = 1e-12


@vector_loop
def _place_across(u: FloatArray, side: float, c: FloatArray, ball: int, room: FloatArray) -> None:
    """Put x0 and r = σρ of all places of a contact into room (2, places)."""
    a, square, lift = c[SEMI_MAJOR, ball], c[RADIUS, ball] ** 2, c[LIFT, ball]
    for i in range(u.size):
        x = a * u[i]
        room[0, i] = x
        room[1, i] = side * (sqrt(square - x * x) + lift)


@vector_loop
def _add_power(
    v2: FloatArray, weight: FloatArray, share: float, b: float, velocity: FloatArray, v0: float,
    room: FloatArray, sums: FloatArray,
) -> None:  # fmt: skip
    """Sum up the rounded power of one contact, and its derivatives by its velocities.

    v2, weight (rows, places): v² and the weight of the points; share of the ball's load; velocity
    (VELOCITIES,); room (7, places), the first two as of `_place_across`; sums (SUMS,).
    """
    drift, roll, twist = velocity[0], velocity[1], velocity[2]
    square, across, places = v0 * v0, b * b, v2.shape[1]
    tumble = across * twist * twist
    for i in range(places):
        slip = drift + room[1, i] * roll - room[0, i] * twist
        room[2, i] = slip
        room[3, i] = slip * slip + square
        room[4, i], room[5, i], room[6, i] = 0.0, 0.0, 0.0
    for row in range(v2.shape[0]):
        for i in range(places):
            t = v2[row, i]
            inverse = 1.0 / (room[3, i] + tumble * t)
            g = weight[row, i] * inverse * sqrt(inverse)
            room[4, i] += g
            room[5, i] += g * t
            room[6, i] += g * t * t
    power, g_d, g_r, g_t, s_d, s_r, s_t = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    dd, dr, dt, rr, rt, tt = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for i in range(places):
        x, r, slip, least = room[0, i], room[1, i], room[2, i], room[3, i]
        one, two, three = room[4, i], room[5, i], room[6, i]
        inner = least * one + tumble * two  # Σ w/|v|
        outer = least * two + tumble * three  # Σ w v²/|v|
        pull = slip * inner
        turn = across * twist * outer
        power += least * inner + tumble * outer
        g_d += pull
        g_r += r * pull
        g_t += turn - x * pull
        s_d += abs(pull)
        s_r += abs(r * pull)
        s_t += abs(turn) + abs(x * pull)
        yy = tumble * two + square * one
        yt = -slip * across * twist * two
        dd += yy
        dr += r * yy
        dt += yt - x * yy
        rr += r * r * yy
        rt += r * (yt - x * yy)
        tt += x * (x * yy - 2.0 * yt) + across * least * two
    sums[POWER] = share * power
    sums[GRADIENT], sums[GRADIENT + 1], sums[GRADIENT + 2] = share * g_d, share * g_r, share * g_t
    sums[SCALE], sums[SCALE + 1], sums[SCALE + 2] = share * s_d, share * s_r, share * s_t
    sums[HESSIAN], sums[HESSIAN + 1], sums[HESSIAN + 2] = share * dd, share * dr, share * dt
    sums[HESSIAN + 3], sums[HESSIAN + 4], sums[HESSIAN + 5] = share * rr, share * rt, share * tt


@vector_loop
def _add_sharp(
    v2: FloatArray, weight: FloatArray, b: float, velocity: FloatArray, room: FloatArray,
    found: FloatArray,
) -> None:  # fmt: skip
    """Put the power by Coulomb's sharp law and that of the twist alone, over μ Q, into found (2,).

    Arguments as of `_add_power`.
    """
    drift, roll, twist = velocity[0], velocity[1], velocity[2]
    tumble = b * b * twist * twist
    power, turned = 0.0, 0.0
    for row in range(v2.shape[0]):
        for i in range(v2.shape[1]):
            slip = drift + room[1, i] * roll - room[0, i] * twist
            across = tumble * v2[row, i]
            speed = sqrt(slip * slip + across)
            power += weight[row, i] * speed
            part = weight[row, i] / (speed if speed > 0.0 else 1.0)
            turned += part * (across - room[0, i] * twist * slip)
    found[0], found[1] = power, turned


@filling
def _rates(c: FloatArray, ball: int, rate: FloatArray) -> None:
    """Fill the derivatives of V by the motion (ball_x, ball_z, orbit); (VELOCITIES, 3)."""
    cosine, sine = c[COSINE, ball], c[SINE, ball]
    rate[0, 0], rate[0, 1], rate[0, 2] = 0.0, 0.0, c[PITCH, ball]
    rate[1, 0], rate[1, 1], rate[1, 2] = cosine, -sine, 0.0
    rate[2, 0], rate[2, 1], rate[2, 2] = sine, cosine, 0.0


@filling
def _velocity(
    c: FloatArray, ball: int, ring: float, rate: FloatArray, motion: FloatArray,
    velocity: FloatArray,
) -> None:  # fmt: skip
    """Fill V of a contact whose ring turns at a speed."""
    x, z, orbit = motion[0], motion[1], motion[2]
    velocity[0] = c[PITCH, ball] * (orbit - ring)
    velocity[1] = rate[1, 0] * (x - ring) + rate[1, 1] * z
    velocity[2] = rate[2, 0] * (x - ring) + rate[2, 1] * z


@filling
def _evaluate(
    v2: FloatArray, weight: FloatArray, contacts: FloatArray, ball: int, motion: FloatArray,
    allowed: FloatArray, v0: float, rates: FloatArray, velocity: FloatArray, room: FloatArray,
    sums: FloatArray, system: FloatArray,
) -> tuple[float, float]:  # fmt: skip
    """Power per load, and the gradient over its own scale, of a motion.

    allowed (3, k): changes of the motion; system (3 k + k k): fills the gradient and the Hessian by
    them.
    """
    k = allowed.shape[1]
    power, worst = 0.0, 0.0
    for i in range(k):
        system[i], system[3 + i] = 0.0, 0.0
        for j in range(k):
            system[6 + 3 * i + j] = 0.0
    total = contacts[0, LOAD, ball] + contacts[1, LOAD, ball]
    for race in range(2):
        c, rate = contacts[race], rates[race]
        _velocity(c, ball, 1.0 - race, rate, motion, velocity)
        _add_power(
            v2, weight, c[LOAD, ball] / total, c[SEMI_MINOR, ball], velocity, v0, room[race], sums
        )
        power += sums[POWER]
        for i in range(k):
            d_i, r_i, t_i = _along(rate, allowed, i)
            system[i] += d_i * sums[GRADIENT] + r_i * sums[GRADIENT + 1] + t_i * sums[GRADIENT + 2]
            system[3 + i] += (
                abs(d_i) * sums[SCALE] + abs(r_i) * sums[SCALE + 1] + abs(t_i) * sums[SCALE + 2]
            )
            for j in range(i + 1):
                d_j, r_j, t_j = _along(rate, allowed, j)
                system[6 + 3 * i + j] += (
                    d_i * d_j * sums[HESSIAN]
                    + (d_i * r_j + r_i * d_j) * sums[HESSIAN + 1]
                    + (d_i * t_j + t_i * d_j) * sums[HESSIAN + 2]
                    + r_i * r_j * sums[HESSIAN + 3]
                    + (r_i * t_j + t_i * r_j) * sums[HESSIAN + 4]
                    + t_i * t_j * sums[HESSIAN + 5]
                )
    for i in range(k):
        part = abs(system[i]) / system[3 + i]
        worst = part if not part <= worst else worst
    return power, worst


@filling
def _along(rate: FloatArray, allowed: FloatArray, i: int) -> tuple[float, float, float]:
    """How drift, roll and twist change with an allowed change of the motion."""
    x, z, orbit = allowed[0, i], allowed[1, i], allowed[2, i]
    return (
        rate[0, 2] * orbit,
        rate[1, 0] * x + rate[1, 1] * z,
        rate[2, 0] * x + rate[2, 1] * z,
    )


@filling
def _newton_step(k: int, system: FloatArray, step: FloatArray) -> float:
    """Solve for the step in coordinates that make the diagonal one: the descent along it.

    By Cholesky's method in place, with a touch of damping.
    """
    for i in range(k):
        step[i] = -system[i] / sqrt(system[6 + 4 * i])
        for j in range(i):
            system[6 + 3 * i + j] /= sqrt(system[6 + 4 * i] * system[6 + 4 * j])
    for i in range(k):
        for j in range(i + 1):
            value = system[6 + 3 * i + j] if j < i else 1.0 + DAMPING
            for m in range(j):
                value -= system[15 + 3 * i + m] * system[15 + 3 * j + m]
            system[15 + 3 * i + j] = value / system[15 + 4 * j] if j < i else sqrt(value)
        for m in range(i):
            step[i] -= system[15 + 3 * i + m] * step[m]
        step[i] /= system[15 + 4 * i]
    for i in range(k - 1, -1, -1):
        for m in range(i + 1, k):
            step[i] -= system[15 + 3 * m + i] * step[m]
        step[i] /= system[15 + 4 * i]
    descent = 0.0
    for i in range(k):
        step[i] /= sqrt(system[6 + 4 * i])
        descent += system[i] * step[i]
    return descent


@filling
def _minimise(
    v2: FloatArray, weight: FloatArray, contacts: FloatArray, ball: int, motion: FloatArray,
    allowed: FloatArray, v0: float, enough: float, rates: FloatArray, room: FloatArray,
    small: FloatArray,
) -> float:  # fmt: skip
    """Newton's method at one rounding, in place, the step shortened until the power falls.

    Returns the gradient over its own scale before the last step, which is taken all the same.
    """
    k = allowed.shape[1]
    velocity, step, origin, system, sums = small[0], small[1], small[2], small[3], small[4]
    value, worst = _evaluate(
        v2, weight, contacts, ball, motion, allowed, v0, rates, velocity, room, sums, system
    )
    for _ in range(STEPS):
        descent = _newton_step(k, system, step)
        for i in range(3):
            origin[i] = motion[i]
        length, lower = 1.0, False
        last = worst <= enough
        for _ in range(HALVINGS):
            for i in range(3):
                motion[i] = origin[i]
                for j in range(k):
                    motion[i] += length * allowed[i, j] * step[j]
            if last:
                return worst
            trial, near = _evaluate(
                v2, weight, contacts, ball, motion, allowed, v0, rates, velocity, room, sums, system
            )
            lower = trial <= value + ARMIJO * length * descent + 1e-15 * value
            if lower:
                value, worst = trial, near
                break
            length *= 0.5
        if not lower:
            for i in range(3):
                motion[i] = origin[i]
            return worst
    return worst


@filling
def _unit_slip(contacts: FloatArray, ball: int, rates: FloatArray, motion: FloatArray) -> float:
    """Slip that the curvature of the contacts makes in rolling, the smaller of both; m/s."""
    least = inf
    for race in range(2):
        c, rate = contacts[race], rates[race]
        roll = rate[1, 0] * (motion[0] - (1.0 - race)) + rate[1, 1] * motion[1]
        least = min(least, abs(roll) * c[SEMI_MAJOR, ball] ** 2 / (2.0 * c[RADIUS, ball]))
    return least


@kernel
def move_free_balls(
    first: int,
    beyond: int,
    coarse: tuple[FloatArray, FloatArray, FloatArray],
    fine: tuple[FloatArray, FloatArray, FloatArray],
    contacts: FloatArray,
    start: FloatArray,
    directions: FloatArray,
    roundings: FloatArray,
    motion: FloatArray,
    found: FloatArray,
    sharp: FloatArray,
) -> None:
    """Find the motion of least power of balls from a first one to that before another.

    coarse, fine: u (places,), v² and weight (rows, places) of a mesh; contacts (2, NUMBERS, balls)
    of the inner and the outer race; start (balls, 3) and directions (balls, 3, k); roundings, over
    the slip that rolling makes. Fills motion (balls, 3), found (balls, 2): the last rounding, m/s,
    and the gradient over its own scale; sharp (balls, 2, 2): by race the power by the sharp law and
    that of the twist, over μ Q.
    """
    places = max(coarse[0].size, fine[0].size)
    room, wide = np.empty((2, 7, places)), np.empty((2, 7, places))
    rates, small, allowed = np.empty((2, 3, 3)), np.empty((5, 24)), np.empty(directions.shape[1:])
    for ball in range(first, beyond):
        _move_ball(
            ball, ball > first, coarse, fine, contacts, start, directions, roundings, motion, found,
            sharp, room, wide, rates, small, allowed,
        )  # fmt: skip


@filling
def _move_ball(
    ball: int,
    has_neighbour: bool,
    coarse: tuple[FloatArray, FloatArray, FloatArray],
    fine: tuple[FloatArray, FloatArray, FloatArray],
    contacts: FloatArray,
    start: FloatArray,
    directions: FloatArray,
    roundings: FloatArray,
    motion: FloatArray,
    found: FloatArray,
    sharp: FloatArray,
    room: FloatArray,
    wide: FloatArray,
    rates: FloatArray,
    small: FloatArray,
    allowed: FloatArray,
) -> None:
    """One ball of `move_free_balls`, unless it is like the one before.

    Nearly to the end on the coarse mesh; if that leads astray, from the start on the fine one.
    """
    if has_neighbour and _alike(contacts, start, directions, ball):
        for i in range(3):
            motion[ball, i] = motion[ball - 1, i]
        for i in range(2):
            found[ball, i] = found[ball - 1, i]
            sharp[ball, i, 0], sharp[ball, i, 1] = sharp[ball - 1, i, 0], sharp[ball - 1, i, 1]
        return
    own, k = motion[ball], allowed.shape[1]
    for i in range(3):
        own[i] = start[ball, i]
        for j in range(k):
            allowed[i, j] = directions[ball, i, j]
    for race in range(2):
        _rates(contacts[race], ball, rates[race])
        _place_across(coarse[0], 2.0 * race - 1.0, contacts[race], ball, room[race])
        _place_across(fine[0], 2.0 * race - 1.0, contacts[race], ball, wide[race])
    unit, residual = _unit_slip(contacts, ball, rates, own), inf
    for stage in range(roundings.size):
        v0 = roundings[stage] * unit
        _minimise(
            coarse[1], coarse[2], contacts, ball, own, allowed, v0, NEARLY, rates, room, small
        )
    last = roundings[roundings.size - 1] * unit
    residual = _minimise(
        fine[1], fine[2], contacts, ball, own, allowed, last, TOLERANCE, rates, wide, small
    )
    if not residual <= TOLERANCE:
        for i in range(3):
            own[i] = start[ball, i]
        for stage in range(roundings.size):
            v0 = roundings[stage] * unit
            residual = _minimise(
                fine[1], fine[2], contacts, ball, own, allowed, v0, TOLERANCE, rates, wide, small
            )
    found[ball, 0], found[ball, 1] = last, residual
    for race in range(2):
        _velocity(contacts[race], ball, 1.0 - race, rates[race], own, small[0])
        _add_sharp(
            fine[1], fine[2], contacts[race, SEMI_MINOR, ball], small[0], wide[race],
            sharp[ball, race],
        )  # fmt: skip


@filling
def _alike(contacts: FloatArray, start: FloatArray, directions: FloatArray, ball: int) -> bool:
    """Whether a ball has the same numbers as the one before it."""
    for race in range(2):
        for number in range(NUMBERS):
            if contacts[race, number, ball] != contacts[race, number, ball - 1]:
                return False
    for i in range(3):
        if start[ball, i] != start[ball - 1, i]:
            return False
        for j in range(directions.shape[2]):
            if directions[ball, i, j] != directions[ball - 1, i, j]:
                return False
    return True
