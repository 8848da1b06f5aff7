"""How far ring, cage and balls are from their balance, and how that changes: one evaluation.

A ball has five equations and five unknowns, and sees the ring through its groove's place A and
the cage through ω_m. The ring sees of a ball, and the shaft has to bear, the force F and the moment
M of the inner race on it, with the arm of the ball's centre from the middle of the circle of inner
groove centres:

    f1 = F_x,   f2 = F_r,   F_e,   R_i h = (R_i - Y2) F_x + Y1 F_r + M_e,   R_i h_r = M_r - Y1 F_e

where Y leads from the ball's centre to the groove's.
"""

from __future__ import annotations

from math import sqrt
from typing import Final, NamedTuple

import numpy as np

from rolamento.numerics.compiled import filling, shared
from rolamento.rows.ball import layout
from rolamento.rows.ball.single import direction, groove
from rolamento.rows.ball.traction.ball import (
    FRICTION,
    HALF,
    INERTIA,
    MASS,
    OUTPUTS,
    RADIUS,
    Mesh,
    Race,
    Rig,
    contact_forces,
    race_room,
    rolling_start,
)
from rolamento.rows.ball.types import Array, Two

BALL: Final = 5  # X1, X2, ω_x, ω_e, ω_r
RING: Final = 6  # x, y, z, ry R_i, rz R_i, and the cage's speed
CAGE: Final = 5
SEEN: Final = 5  # by the ring: f1, f2, h, F_e, h_r
BOTH: Final = 5  # beside them, what the cage sees: both races' force along the orbit
LOAD_FLOOR: Final = 1e-6  # of the heaviest ball: below it a ball's own load is no scale

INNER_POWER: Final = 4  # where things stand in `Sheet.forces`
OUTER_POWER: Final = 5
OF_INNER: Final = 6
OF_OUTER: Final = OF_INNER + OUTPUTS
FORCES: Final = OF_OUTER + OUTPUTS


class Place(NamedTuple):
    """The unknowns: u (RING,), x (balls, 2), omega (balls, 3)."""

    u: Array
    x: Array
    omega: Array


class Sheet(NamedTuple):
    """Room for one evaluation.

    residual (balls, BALL) of the balls; matrix (balls, BALL, BALL) its derivatives by a ball's
    own unknowns, inputs (balls, BALL, 3) by A1, A2, ω_m. sight (balls, SEEN), what the ring sees,
    and slope (balls, SEEN + 1, BALL + 3), its derivatives, those of both races' force along the
    orbit in the last row. forces (balls, FORCES): Q_i, Q_o, F_c, friction along the orbit, power
    at the inner and the outer race, forces and moments of each race as of `contact_forces`.
    reaction (5,), what the balls ask of the ring.
    """

    residual: Array
    matrix: Array
    inputs: Array
    sight: Array
    slope: Array
    forces: Array
    reaction: Array
    inner: Race
    outer: Race


@shared
def sheet_for(balls: int) -> Sheet:
    """Make room for so many balls."""
    return Sheet(
        np.empty((balls, BALL)),
        np.empty((balls, BALL, BALL)),
        np.empty((balls, BALL, 3)),
        np.empty((balls, SEEN)),
        np.empty((balls, SEEN + 1, BALL + 3)),
        np.empty((balls, FORCES)),
        np.empty(layout.DEGREES_OF_FREEDOM),
        race_room(),
        race_room(),
    )


@filling
def start_amid_gaps(rig: Rig, place: Place) -> None:
    """Set balls without inertia that nothing touches amid their gap, in place."""
    inner, outer = rig.p[layout.INNER_LENGTH, rig.case], rig.p[layout.OUTER_LENGTH, rig.case]
    if rig.k[MASS] != 0.0:
        return
    for j in range(rig.cosines.size):
        c, s = direction(rig.p, rig.case, rig.cosines[j], rig.sines[j])
        a1, a2 = groove(rig.p, rig.case, place.u, c, s)
        if sqrt(a1 * a1 + a2 * a2) <= inner + outer:
            place.x[j, 0] = a1 * outer / (inner + outer)
            place.x[j, 1] = a2 * outer / (inner + outer)


@filling
def start_rolling(rig: Rig, place: Place) -> None:
    """Set the balls rolling as under outer raceway control, the cage as the loaded ones have it."""
    weight, orbit = 0.0, 0.0
    u, x, omega = place.u, place.x, place.omega
    for j in range(rig.cosines.size):
        c, s = direction(rig.p, rig.case, rig.cosines[j], rig.sines[j])
        a1, a2 = groove(rig.p, rig.case, u, c, s)
        outer = sqrt(x[j, 0] ** 2 + x[j, 1] ** 2)
        inner = sqrt((a1 - x[j, 0]) ** 2 + (a2 - x[j, 1]) ** 2)
        omega[j, 0], omega[j, 2], own = rolling_start(
            rig, (a1 - x[j, 0]) / inner, (a2 - x[j, 1]) / inner, x[j, 0] / outer, x[j, 1] / outer
        )
        omega[j, 1] = 0.0
        load = max(inner - rig.p[layout.INNER_LENGTH, rig.case], 0.0) ** 1.5
        weight += load
        orbit += load * own
    u[CAGE] = orbit / weight if weight > 0.0 else u[CAGE]


@filling
def evaluate(rig: Rig, place: Place, mesh: Mesh, sheet: Sheet) -> Two:
    """Residuals and derivatives everywhere: (merit, greatest residual), both relative."""
    orbit = place.u[CAGE]
    forces = sheet.forces
    heaviest = 0.0
    for j in range(rig.cosines.size):
        c, s = direction(rig.p, rig.case, rig.cosines[j], rig.sines[j])
        a1, a2 = groove(rig.p, rig.case, place.u, c, s)
        x1, x2 = place.x[j, 0], place.x[j, 1]
        omega = place.omega[j]
        for inner in range(2):  # one call, so that the compiler has one to look at
            race = sheet.inner if inner == 1 else sheet.outer
            y1, y2 = (a1 - x1, a2 - x2) if inner == 1 else (x1, x2)
            least = mesh.least
            if mesh.film.size > 0:
                _add_film(mesh, race, j, 1 - inner)
                least = race.least
            if mesh.lift.size > 0:
                race.lift[0] = mesh.lift[j, 1 - inner]
            q, power = contact_forces(rig, inner == 1, y1, y2, omega, orbit, mesh, least, race)
            forces[j, 1 - inner], forces[j, OUTER_POWER - inner] = q, power
        _put_ball(rig, omega, orbit, sheet, j)
        _put_sight(rig, a1 - x1, a2 - x2, sheet, j)
        heaviest = max(heaviest, forces[j, 0], forces[j, 1], forces[j, 2])
    return _measured(rig, place.u, sheet, heaviest)


@filling
def _add_film(mesh: Mesh, race: Race, j: int, side: int) -> None:
    """Make v0² at one contact: with the film of the ball's inner (0) or outer (1) side."""
    for node in range(mesh.least.size):
        race.least[node] = mesh.least[node] + mesh.film[j, side, node]


@filling
def _put_ball(rig: Rig, omega: Array, orbit: float, sheet: Sheet, j: int) -> None:
    """Forces, residual and derivatives of one ball."""
    k = rig.k
    inner, outer, forces = sheet.inner, sheet.outer, sheet.forces[j]
    r, m, inputs = sheet.residual[j], sheet.matrix[j], sheet.inputs[j]
    f_c = k[MASS] * k[RADIUS] * orbit * orbit
    j_m = k[INERTIA]
    for row in range(BALL):
        source = row if row < 2 else row + 1
        r[row] = inner.force[source] + outer.force[source]
        for column in range(2):
            m[row, column] = outer.slope[source, column] - inner.slope[source, column]
            inputs[row, column] = inner.slope[source, column]
        for column in range(2, BALL):
            m[row, column] = outer.slope[source, column] + inner.slope[source, column]
        inputs[row, 2] = outer.slope[source, 5] + inner.slope[source, 5]
    r[1] += f_c
    inputs[1, 2] += 2.0 * k[MASS] * k[RADIUS] * orbit
    r[3] += j_m * orbit * omega[2]
    m[3, 4] += j_m * orbit
    inputs[3, 2] += j_m * omega[2]
    r[4] -= j_m * orbit * omega[1]
    m[4, 3] -= j_m * orbit
    inputs[4, 2] -= j_m * omega[1]
    if forces[0] == 0.0 and forces[1] == 0.0 and f_c == 0.0:  # a free gyroscope is no one's burden
        for row in range(BALL):
            r[row] = 0.0
    forces[2] = f_c
    forces[3] = inner.force[2] + outer.force[2]
    for i in range(OUTPUTS):
        forces[OF_INNER + i], forces[OF_OUTER + i] = inner.force[i], outer.force[i]


@filling
def _put_sight(rig: Rig, y1: float, y2: float, sheet: Sheet, j: int) -> None:
    """What ring and cage see of one ball, with its derivatives."""
    sight, slope, d_i, d_o = sheet.sight[j], sheet.slope[j], sheet.inner.slope, sheet.outer.slope
    force, arm = sheet.inner.force, rig.p[layout.ARM, rig.case]
    sight[0], sight[1], sight[3] = force[0], force[1], force[2]
    sight[2] = force[0] + (y1 * force[1] - y2 * force[0] + force[4]) / arm
    sight[4] = (force[5] - y1 * force[2]) / arm
    for column in range(BALL + 3):
        # by X1, X2 (against Y), ω_x, ω_e, ω_r, then A1, A2 (with Y), ω_m
        source = column if column < BALL else (column - BALL if column < BALL + 2 else 5)
        sign = -1.0 if column < 2 else 1.0
        dy1 = sign if source == 0 else 0.0
        dy2 = sign if source == 1 else 0.0
        d1, d2 = sign * d_i[0, source], sign * d_i[1, source]
        along = sign * d_i[2, source]
        slope[0, column], slope[1, column], slope[3, column] = d1, d2, along
        turned = dy1 * force[1] - dy2 * force[0] + y1 * d2 - y2 * d1 + sign * d_i[4, source]
        slope[2, column] = d1 + turned / arm
        slope[4, column] = (sign * d_i[5, source] - dy1 * force[2] - y1 * along) / arm
        outer = d_o[2, source] if column < BALL or column == BALL + 2 else 0.0
        slope[BOTH, column] = along + outer


@filling
def _measured(rig: Rig, u: Array, sheet: Sheet, heaviest: float) -> Two:
    """Sum of squares and greatest of all residuals, each over the scale of its own loads."""
    merit, worst = 0.0, 0.0
    grip = rig.k[FRICTION] * rig.k[HALF]
    for j in range(rig.cosines.size):
        forces = sheet.forces[j]
        load = max(forces[0], forces[1], forces[2], LOAD_FLOOR * heaviest)
        for row in range(BALL):
            part = abs(sheet.residual[j, row]) / (load if row < 2 else grip * load)
            merit += part * part
            worst = part if not part <= worst else worst
    ring = _ring_residual(rig, sheet.sight, heaviest, sheet.reaction)
    cage, total = cage_residual(rig, u[CAGE], sheet.forces)
    if total > 0.0:
        ring = max(ring, abs(cage) / (rig.k[FRICTION] * total))
    worst = ring if not ring <= worst else worst
    return merit + ring * ring, worst


@filling
def _ring_residual(rig: Rig, sight: Array, heaviest: float, reaction: Array) -> float:
    """The ring's greatest unbalanced load over the greatest load on it or in it."""
    for i in range(layout.DEGREES_OF_FREEDOM):
        reaction[i] = 0.0
    for j in range(rig.cosines.size):
        c, s = direction(rig.p, rig.case, rig.cosines[j], rig.sines[j])
        add_reaction(c, s, sight[j], reaction)
    scale, error = heaviest, 0.0
    for i in range(layout.DEGREES_OF_FREEDOM):
        if rig.p[layout.FREE + i, rig.case] > 0.0:
            applied = rig.p[layout.APPLIED + i, rig.case]
            scale = max(scale, abs(applied))
            miss = abs(applied - reaction[i])
            error = miss if not miss <= error else error
    return error / scale if scale > 0.0 else error


@filling
def add_reaction(c: float, s: float, sight: Array, total: Array) -> None:
    """Add what a ball at azimuth (c, s) asks of the ring: x, y, z, ry R_i, rz R_i."""
    total[0] += sight[0]
    total[1] += s * sight[1] + c * sight[3]
    total[2] += c * sight[1] - s * sight[3]
    total[3] += c * sight[2] + s * sight[4]
    total[4] += c * sight[4] - s * sight[2]


@filling
def cage_residual(rig: Rig, orbit: float, forces: Array) -> Two:
    """Friction along the orbit that the cage's drag does not balance; and all loads together."""
    along, total = 0.0, 0.0
    for j in range(forces.shape[0]):
        along += forces[j, 3]
        total += forces[j, 0] + forces[j, 1]
    # e runs against the sense in which the cage turns for ω_m > 0
    against = rig.drag / rig.k[RADIUS]
    return along + (against if orbit > 0.0 else -against), total
