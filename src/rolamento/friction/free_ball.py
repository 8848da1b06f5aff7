"""One ball that friction alone moves: the motion of least power, and what it loses; compiled.

The relative velocity of a contact is linear in V = (slip, roll, twist), slip being that in its
middle: with r = σ(ρ(x0) - ρ(0)) and y0 = b v

    v_y = slip + r roll - x0 twist,   v_t = y0 twist

Drift and ρ(0) roll, of which the slip is made, are a million times as large in a light contact:
their sum is made once, and what moves is added to it.

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
HALF: Final = 8  # D / 2
NUMBERS: Final = 9

VELOCITIES: Final = 3  # slip in the middle, roll, twist
# of `sums` of one contact: power, its gradient by V, its Hessian (upper half), and the gradient
# without cancellation
POWER: Final = 0
GRADIENT: Final = 1
HESSIAN: Final = 4
SCALE: Final = 10
SUMS: Final = 13
# rows of what is small: V, the sums of a contact, gradient, its scale, the Hessian, the step, y, a
# trial of it
V, OF_CONTACT, DOWN, SIZE, CURVED, STEP, AT, TRIAL, SMALL = 0, 1, 2, 3, 4, 7, 8, 9, 10

STEPS: Final = 60
HALVINGS: Final = 30
ARMIJO: Final = 1e-4
TOLERANCE: Final = 1e-9
"""Fraction of the gradient, over the sum of what it is made of."""
NEARLY: Final = 1e-3
"""The same on the coarse mesh."""
ROUGHLY: Final = 5e-2
"""The same at a rounding that is not the last."""
DAMPING: Final = 1e-12


@vector_loop
def _place_across(u: FloatArray, side: float, c: FloatArray, ball: int, room: FloatArray) -> None:
    """Put x0 and r = σ(ρ(x0) - ρ(0)) of all places of a contact into room (2, places)."""
    a, radius = c[SEMI_MAJOR, ball], c[RADIUS, ball]
    for i in range(u.size):
        x = a * u[i]
        square = x * x
        room[0, i] = x
        room[1, i] = -side * square / (radius + sqrt(radius * radius - square))


@vector_loop
def _add_power(
    v2: FloatArray, weight: FloatArray, share: float, b: float, velocity: FloatArray, v0: float,
    room: FloatArray, sums: FloatArray,
) -> None:  # fmt: skip
    """Sum up the rounded power of one contact, and its derivatives by its velocities.

    v2, weight (rows, places): v² and the weight of the points; share of the ball's load; velocity
    (VELOCITIES,); room (7, places), the first two as of `_place_across`; sums (SUMS,).
    """
    middle, roll, twist = velocity[0], velocity[1], velocity[2]
    square, across, places = v0 * v0, b * b, v2.shape[1]
    tumble = across * twist * twist
    for i in range(places):
        slip = middle + room[1, i] * roll - room[0, i] * twist
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
    middle, roll, twist = velocity[0], velocity[1], velocity[2]
    tumble = b * b * twist * twist
    power, turned = 0.0, 0.0
    for row in range(v2.shape[0]):
        for i in range(v2.shape[1]):
            slip = middle + room[1, i] * roll - room[0, i] * twist
            across = tumble * v2[row, i]
            speed = sqrt(slip * slip + across)
            power += weight[row, i] * speed
            part = weight[row, i] / (speed if speed > 0.0 else 1.0)
            turned += part * (across - room[0, i] * twist * slip)
    found[0], found[1] = power, turned


@filling
def _relative_motion(
    c: FloatArray, ball: int, side: float, motion: FloatArray, allowed: FloatArray,
    velocity: FloatArray, rate: FloatArray,
) -> None:  # fmt: skip
    """Put V of a contact into velocity (VELOCITIES,), its derivatives into rate (VELOCITIES, k).

    side: -1 at the inner ring, which turns at 1 rad/s, +1 at the outer, which stands; motion (3,):
    ball_x, ball_z, orbit; allowed (3, k): changes of it.
    """
    cosine, sine, radius = c[COSINE, ball], c[SINE, ball], c[PITCH, ball]
    ring, middle = 0.5 * (1.0 - side), side * (c[RADIUS, ball] + c[LIFT, ball])
    velocity[1] = cosine * (motion[0] - ring) - sine * motion[1]
    velocity[2] = sine * (motion[0] - ring) + cosine * motion[1]
    velocity[0] = radius * (motion[2] - ring) + middle * velocity[1]
    for i in range(allowed.shape[1]):
        rate[1, i] = cosine * allowed[0, i] - sine * allowed[1, i]
        rate[0, i] = radius * allowed[2, i] + middle * rate[1, i]
        rate[2, i] = sine * allowed[0, i] + cosine * allowed[1, i]


@filling
def _evaluate(
    v2: FloatArray, weight: FloatArray, contacts: FloatArray, ball: int, v0: float,
    y: FloatArray, start: FloatArray, rates: FloatArray, room: FloatArray, small: FloatArray,
) -> tuple[float, float]:  # fmt: skip
    """Power per load at coordinates y, and the gradient over its own scale.

    start (2, VELOCITIES), rates (2, VELOCITIES, k): of both contacts, as of `_relative_motion`.
    Fills rows of small: V, sums, the gradient, its scale, and the Hessian in three.
    """
    k = rates.shape[2]
    velocity, sums, gradient, scale = small[V], small[OF_CONTACT], small[DOWN], small[SIZE]
    power, worst = 0.0, 0.0
    for i in range(k):
        gradient[i], scale[i] = 0.0, 0.0
        for j in range(i + 1):
            small[CURVED + i, j] = 0.0
    total = contacts[0, LOAD, ball] + contacts[1, LOAD, ball]
    for race in range(2):
        rate = rates[race]
        for i in range(VELOCITIES):
            velocity[i] = start[race, i]
            for j in range(k):
                velocity[i] += rate[i, j] * y[j]
        share, b = contacts[race, LOAD, ball] / total, contacts[race, SEMI_MINOR, ball]
        _add_power(v2, weight, share, b, velocity, v0, room[race], sums)
        power += sums[POWER]
        dd, dr, dt = sums[HESSIAN], sums[HESSIAN + 1], sums[HESSIAN + 2]
        rr, rt, tt = sums[HESSIAN + 3], sums[HESSIAN + 4], sums[HESSIAN + 5]
        for i in range(k):
            d, r, t = rate[0, i], rate[1, i], rate[2, i]
            gradient[i] += d * sums[GRADIENT] + r * sums[GRADIENT + 1] + t * sums[GRADIENT + 2]
            scale[i] += abs(d) * sums[SCALE] + abs(r) * sums[SCALE + 1] + abs(t) * sums[SCALE + 2]
            by_d, by_r = d * dd + r * dr + t * dt, d * dr + r * rr + t * rt
            by_t = d * dt + r * rt + t * tt
            for j in range(i + 1):
                small[CURVED + i, j] += by_d * rate[0, j] + by_r * rate[1, j] + by_t * rate[2, j]
    for i in range(k):
        part = abs(gradient[i]) / scale[i]
        worst = part if not part <= worst else worst
    return power, worst


@filling
def _newton_step(k: int, small: FloatArray) -> float:
    """Solve for the step in coordinates that make the diagonal one: the descent along it.

    By Cholesky's method in place, with a touch of damping.
    """
    gradient, step, unit = small[DOWN], small[STEP], small[SIZE]
    for i in range(k):
        unit[i] = 1.0 / sqrt(small[CURVED + i, i])
        step[i] = -gradient[i] * unit[i]
        for j in range(i):
            value = small[CURVED + i, j] * unit[i] * unit[j]
            for m in range(j):
                value -= small[CURVED + i, m] * small[CURVED + j, m]
            small[CURVED + i, j] = value * small[CURVED + j, j]
        value = 1.0 + DAMPING
        for m in range(i):
            value -= small[CURVED + i, m] * small[CURVED + i, m]
            step[i] -= small[CURVED + i, m] * step[m]
        small[CURVED + i, i] = 1.0 / sqrt(value)
        step[i] *= small[CURVED + i, i]
    descent = 0.0
    for i in range(k - 1, -1, -1):
        for m in range(i + 1, k):
            step[i] -= small[CURVED + m, i] * step[m]
        step[i] *= small[CURVED + i, i]
    for i in range(k):
        step[i] *= unit[i]
        descent += gradient[i] * step[i]
    return descent


@filling
def _minimise(
    v2: FloatArray, weight: FloatArray, contacts: FloatArray, ball: int, v0: float, enough: float,
    y: FloatArray, start: FloatArray, rates: FloatArray, room: FloatArray, small: FloatArray,
) -> float:  # fmt: skip
    """Newton's method at one rounding, y in place, the step shortened until the power falls.

    Returns the gradient over its own scale before the last step, which is taken all the same.
    """
    k = rates.shape[2]
    trial, step = small[TRIAL], small[STEP]
    value, worst = _evaluate(v2, weight, contacts, ball, v0, y, start, rates, room, small)
    for _ in range(STEPS):
        descent = _newton_step(k, small)
        if worst <= enough:
            for i in range(k):
                y[i] += step[i]
            break
        length, lower, found, near = 1.0, False, value, worst
        for _ in range(HALVINGS):
            for i in range(k):
                trial[i] = y[i] + length * step[i]
            found, near = _evaluate(
                v2, weight, contacts, ball, v0, trial, start, rates, room, small
            )
            lower = found <= value + ARMIJO * length * descent + 1e-15 * value
            if lower:
                break
            length *= 0.5
        if not lower:
            break
        value, worst = found, near
        for i in range(k):
            y[i] = trial[i]
    return worst


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
    k, places = directions.shape[2], max(coarse[0].size, fine[0].size)
    rooms, small = np.empty((2, 2, 7, places)), np.empty((SMALL, SUMS))
    velocities, rates = np.empty((2, VELOCITIES)), np.empty((2, VELOCITIES, k))
    for ball in range(first, beyond):
        if ball > first and _alike(contacts, start, directions, ball):
            _copy(motion, found, sharp, ball)
        else:
            _move_ball(
                ball, coarse, fine, contacts, start, directions, roundings, motion, found, sharp,
                rooms, velocities, rates, small,
            )  # fmt: skip


@filling
def _move_ball(
    ball: int,
    coarse: tuple[FloatArray, FloatArray, FloatArray],
    fine: tuple[FloatArray, FloatArray, FloatArray],
    contacts: FloatArray,
    start: FloatArray,
    directions: FloatArray,
    roundings: FloatArray,
    motion: FloatArray,
    found: FloatArray,
    sharp: FloatArray,
    rooms: FloatArray,
    velocities: FloatArray,
    rates: FloatArray,
    small: FloatArray,
) -> None:
    """One ball of `move_free_balls`.

    Nearly to the end on the coarse mesh; if that leads astray, from the start on the fine one.
    """
    k, y, unit = rates.shape[2], small[AT], inf
    room, wide = rooms[0], rooms[1]
    for race in range(2):
        c, side = contacts[race], 2.0 * race - 1.0
        _relative_motion(
            c, ball, side, start[ball], directions[ball], velocities[race], rates[race]
        )
        _place_across(coarse[0], side, c, ball, room[race])
        _place_across(fine[0], side, c, ball, wide[race])
        # what the curvature of the contact makes in rolling
        slip = abs(velocities[race, 1]) * c[SEMI_MAJOR, ball] ** 2 / (2.0 * c[RADIUS, ball])
        unit = min(unit, slip)
    for i in range(k):
        y[i] = 0.0
    for stage in range(roundings.size):
        _minimise(
            coarse[1], coarse[2], contacts, ball, roundings[stage] * unit,
            NEARLY if stage == roundings.size - 1 else ROUGHLY, y, velocities, rates, room, small,
        )  # fmt: skip
    last = roundings[roundings.size - 1] * unit
    residual = _minimise(
        fine[1], fine[2], contacts, ball, last, TOLERANCE, y, velocities, rates, wide, small
    )
    if not residual <= TOLERANCE:
        for i in range(k):
            y[i] = 0.0
        for stage in range(roundings.size):
            residual = _minimise(
                fine[1], fine[2], contacts, ball, roundings[stage] * unit, TOLERANCE, y,
                velocities, rates, wide, small,
            )  # fmt: skip
    found[ball, 0], found[ball, 1] = last, residual
    for i in range(3):
        motion[ball, i] = start[ball, i]
        for j in range(k):
            motion[ball, i] += directions[ball, i, j] * y[j]
    for race in range(2):
        for i in range(VELOCITIES):
            for j in range(k):
                velocities[race, i] += rates[race, i, j] * y[j]
        _add_sharp(
            fine[1], fine[2], contacts[race, SEMI_MINOR, ball], velocities[race], wide[race],
            sharp[ball, race],
        )  # fmt: skip


@filling
def _copy(motion: FloatArray, found: FloatArray, sharp: FloatArray, ball: int) -> None:
    """Give a ball what the one before has."""
    for i in range(3):
        motion[ball, i] = motion[ball - 1, i]
    for i in range(2):
        found[ball, i] = found[ball - 1, i]
        sharp[ball, i, 0], sharp[ball, i, 1] = sharp[ball - 1, i, 0], sharp[ball - 1, i, 1]


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
