"""Ring, cage and balls together, in balance with friction: Newton's method.

Every ball is eliminated by itself (five unknowns that see the ring through its groove's place and
the orbital speed); what is left are the ring's five and the cage's one. The smoothing speed v0 of
the friction is lowered step by step: at a high one the friction is nearly viscous and the
equations nearly linear, at a low one it is Coulomb's.
"""

from __future__ import annotations

from math import inf, sqrt
from typing import Final

import numpy as np

from rolamento.equilibrium import rows
from rolamento.equilibrium.settle import in_place
from rolamento.equilibrium.single import direction, groove
from rolamento.equilibrium.traction.ball import (
    FRICTION,
    HALF,
    INERTIA,
    INPUTS,
    MASS,
    OUTPUTS,
    RADIUS,
    contact_forces,
    least_speed,
    rolling_start,
)
from rolamento.equilibrium.types import Array, Two
from rolamento.numerics.compiled import kernel, shared
from rolamento.numerics.dense import solve_dense

BALL: Final = 5  # X1, X2, ω_x, ω_e, ω_r
RING: Final = 6  # x, y, z, ry R_i, rz R_i, and the cage's speed
CAGE: Final = 5
STEPS: Final = 40
SHORTENINGS: Final = 12
TOLERANCE: Final = 1e-9
ACCEPTED: Final = 5e-9
STAGES: Final = 60
BOLDEST: Final = 0.1  # of the smoothing before
TIMIDEST: Final = 0.95
SMOOTHEST: Final = 1e3
ENOUGH: Final = 1e-4  # before the smoothing is lowered
LOAD_FLOOR: Final = 1e-6
INWARD: Final = 1e-6  # of the ball's radius: the size of a shift beside that of a speed

OF_INNER: Final = 6  # where the forces and moments of the races stand
OF_OUTER: Final = OF_INNER + OUTPUTS
FORCES: Final = OF_OUTER + OUTPUTS

CONVERGED: Final = 0
NOT_CONVERGED: Final = 1
STRAYED: Final = 2


@shared
def evaluate(
    p: Array,
    case: int,
    k: Array,
    drag: float,
    cosines: Array,
    sines: Array,
    nodes: tuple[Array, Array, Array],
    least: Array,
    u: Array,
    x: Array,
    omega: Array,
    ball_residual: Array,
    ball_matrix: Array,
    ball_input: Array,
    ring_view: Array,
    ring_slope: Array,
    forces: Array,
) -> tuple[float, float]:
    """Residuals and derivatives everywhere: (merit, greatest residual), both relative.

    u (RING,); x (balls, 2); omega (balls, 3). Fills ball_residual (balls, BALL), ball_matrix
    (balls, BALL, BALL), ball_input (balls, BALL, 3), the derivative by A1, A2, ω_m; ring_view
    (balls, 4), the ball's f1, f2, h and force along the orbit on ring and cage; ring_slope
    (balls, 5, BALL + 3) its derivatives (the last row: both races' force along the orbit);
    forces (balls, FORCES): Q_i, Q_o, F_c, friction along the orbit, power at the inner and outer
    race, then the forces and moments of each race as of `contact_forces`.
    """
    out_i, out_o = np.empty(OUTPUTS), np.empty(OUTPUTS)
    d_i, d_o = np.empty((OUTPUTS, INPUTS)), np.empty((OUTPUTS, INPUTS))
    orbit = u[CAGE]
    j_m = k[INERTIA]
    merit, worst, heaviest = 0.0, 0.0, 0.0
    for j in range(cosines.size):
        c0, s0 = direction(p, case, cosines[j], sines[j])
        a1, a2 = groove(p, case, u, c0, s0)
        y1, y2 = a1 - x[j, 0], a2 - x[j, 1]
        q_o, power_o = contact_forces(
            p, case, k, False, x[j, 0], x[j, 1], omega[j], orbit, nodes, least, out_o, d_o
        )
        q_i, power_i = contact_forces(
            p, case, k, True, y1, y2, omega[j], orbit, nodes, least, out_i, d_i
        )
        f_c = k[MASS] * k[RADIUS] * orbit * orbit
        r, m = ball_residual[j], ball_matrix[j]
        r[0] = out_i[0] + out_o[0]
        r[1] = out_i[1] + out_o[1] + f_c
        r[2] = out_i[3] + out_o[3]
        r[3] = out_i[4] + out_o[4] + j_m * orbit * omega[j, 2]
        r[4] = out_i[5] + out_o[5] - j_m * orbit * omega[j, 1]
        for row in range(BALL):
            source = row if row < 2 else row + 1
            for column in range(2):
                m[row, column] = d_o[source, column] - d_i[source, column]
                ball_input[j, row, column] = d_i[source, column]
            for column in range(3):
                m[row, 2 + column] = d_o[source, 2 + column] + d_i[source, 2 + column]
            ball_input[j, row, 2] = d_o[source, 5] + d_i[source, 5]
        m[3, 4] += j_m * orbit
        m[4, 3] -= j_m * orbit
        ball_input[j, 1, 2] += 2.0 * k[MASS] * k[RADIUS] * orbit
        ball_input[j, 3, 2] += j_m * omega[j, 2]
        ball_input[j, 4, 2] -= j_m * omega[j, 1]

        # what the ring and the cage see
        length = sqrt(y1 * y1 + y2 * y2)
        s, c = y1 / length, y2 / length
        arm = p[rows.FRICTION_ARM, case]
        ring_view[j, 0], ring_view[j, 1] = out_i[0], out_i[1]
        ring_view[j, 2] = out_i[0] - arm * (out_i[0] * c - out_i[1] * s)
        ring_view[j, 3] = out_i[2]
        for column in range(BALL + 3):
            if column < 2:
                source, sign = column, -1.0
            elif column < BALL:
                source, sign = column, 1.0
            elif column < BALL + 2:
                source, sign = column - BALL, 1.0
            else:
                source, sign = 5, 1.0
            by1, by2 = sign * d_i[0, source], sign * d_i[1, source]
            ring_slope[j, 0, column] = by1
            ring_slope[j, 1, column] = by2
            turn = 0.0
            if source < 2:
                turn = sign * (c if source == 0 else -s) / length
            across = by1 * c - by2 * s - (out_i[0] * s + out_i[1] * c) * turn
            ring_slope[j, 2, column] = by1 - arm * across
            ring_slope[j, 3, column] = sign * d_i[2, source]
            along_outer = 0.0
            if column < BALL:
                along_outer = d_o[2, column]
            elif column == BALL + 2:
                along_outer = d_o[2, 5]
            ring_slope[j, 4, column] = sign * d_i[2, source] + along_outer
        forces[j, 0], forces[j, 1], forces[j, 2] = q_i, q_o, f_c
        forces[j, 3] = out_i[2] + out_o[2]
        forces[j, 4], forces[j, 5] = power_i, power_o
        for i in range(OUTPUTS):
            forces[j, OF_INNER + i], forces[j, OF_OUTER + i] = out_i[i], out_o[i]
        heaviest = max(heaviest, q_i, q_o, f_c)

    grip = k[FRICTION] * k[HALF]
    for j in range(cosines.size):
        load = max(forces[j, 0], forces[j, 1], forces[j, 2], LOAD_FLOOR * heaviest)
        for row in range(BALL):
            part = abs(ball_residual[j, row]) / (load if row < 2 else grip * load)
            merit += part * part
            worst = part if not part <= worst else worst
    ring = ring_residual(p, case, cosines, sines, ring_view, heaviest)
    cage, total = cage_residual(k, drag, u[CAGE], forces)
    if total > 0.0:
        ring = max(ring, abs(cage) / (k[FRICTION] * total))
        merit += (cage / (k[FRICTION] * total)) ** 2
    worst = ring if not ring <= worst else worst
    return merit + ring * ring, worst


@shared
def cage_residual(k: Array, drag: float, orbit: float, forces: Array) -> Two:
    """Friction along the orbit that the cage's drag does not balance; and all loads together."""
    along, total = 0.0, 0.0
    for j in range(forces.shape[0]):
        along += forces[j, 3]
        total += forces[j, 0] + forces[j, 1]
    # the friction drives the cage along -e, which is where it turns for ω_m > 0
    against = drag / k[RADIUS] if orbit > 0.0 else -drag / k[RADIUS]
    return along + against, total


@shared
def add_reaction(c: float, s: float, view: Array, total: Array) -> None:
    """Add what a ball at azimuth (c, s) asks of the ring: x, y, z, ry R_i, rz R_i."""
    total[0] += view[0]
    total[1] += s * view[1] + c * view[3]
    total[2] += c * view[1] - s * view[3]
    total[3] += c * view[2]
    total[4] -= s * view[2]


@shared
def ring_residual(
    p: Array, case: int, cosines: Array, sines: Array, ring_view: Array, heaviest: float
) -> float:
    """The ring's greatest unbalanced load over the greatest load on it or in it."""
    reaction = np.zeros(5)
    for j in range(cosines.size):
        c, s = direction(p, case, cosines[j], sines[j])
        add_reaction(c, s, ring_view[j], reaction)
    scale, error = heaviest, 0.0
    for i in range(5):
        if p[rows.FREE + i, case] > 0.0:
            applied = p[rows.APPLIED + i, case]
            scale = max(scale, abs(applied))
            miss = abs(applied - reaction[i])
            error = miss if not miss <= error else error
    return error / scale if scale > 0.0 else error


@shared
def eliminate_balls(
    p: Array,
    case: int,
    k: Array,
    cosines: Array,
    sines: Array,
    ball_residual: Array,
    ball_matrix: Array,
    ball_input: Array,
    ring_view: Array,
    ring_slope: Array,
    follow: Array,
    matrix: Array,
    right: Array,
) -> bool:
    """Let every ball follow ring and cage; False where a ball's matrix is singular.

    Fills follow (balls, BALL, 4), each ball's own step and its derivatives by A1, A2, ω_m; right
    (RING,), what the balls ask of ring and cage after their own steps, and matrix (RING, RING),
    its derivative.
    """
    small, column = np.empty((BALL, BALL)), np.empty(BALL)
    seen = np.empty((5, 4))
    place = np.zeros((3, RING))
    speed = max(least_speed(p, case, k)[1], 1e-300)
    inward = INWARD * k[HALF]
    matrix[:, :] = 0.0
    right[:] = 0.0
    for j in range(cosines.size):
        c, s = direction(p, case, cosines[j], sines[j])
        for right_side in range(4):
            for row in range(BALL):
                weight = 1.0 if row < 2 else 1.0 / k[HALF]
                for other in range(BALL):
                    scale = inward if other < 2 else speed
                    small[row, other] = ball_matrix[j, row, other] * weight * scale
                if right_side == 0:
                    column[row] = -ball_residual[j, row] * weight
                else:
                    column[row] = -ball_input[j, row, right_side - 1] * weight
            if not solve_dense(small, column):
                return False
            for row in range(BALL):
                follow[j, row, right_side] = column[row] * (inward if row < 2 else speed)
        for row in range(5):
            for right_side in range(4):
                value = 0.0 if right_side == 0 else ring_slope[j, row, BALL + right_side - 1]
                for inner in range(BALL):
                    value += ring_slope[j, row, inner] * follow[j, inner, right_side]
                seen[row, right_side] = value
        # A1, A2 and ω_m by the unknowns of ring and cage
        place[0, 0], place[0, 3], place[0, 4] = 1.0, c, -s
        place[1, 1], place[1, 2] = s, c
        place[2, CAGE] = 1.0
        for unknown in range(RING):
            f1, f2, h, along, both = 0.0, 0.0, 0.0, 0.0, 0.0
            for i in range(3):
                f1 += seen[0, i + 1] * place[i, unknown]
                f2 += seen[1, i + 1] * place[i, unknown]
                h += seen[2, i + 1] * place[i, unknown]
                along += seen[3, i + 1] * place[i, unknown]
                both += seen[4, i + 1] * place[i, unknown]
            matrix[0, unknown] += f1
            matrix[1, unknown] += s * f2 + c * along
            matrix[2, unknown] += c * f2 - s * along
            matrix[3, unknown] += c * h
            matrix[4, unknown] -= s * h
            matrix[CAGE, unknown] += both
        f2, along = ring_view[j, 1] + seen[1, 0], ring_view[j, 3] + seen[3, 0]
        h = ring_view[j, 2] + seen[2, 0]
        right[0] += ring_view[j, 0] + seen[0, 0]
        right[1] += s * f2 + c * along
        right[2] += c * f2 - s * along
        right[3] += c * h
        right[4] -= s * h
        right[CAGE] += seen[4, 0]
    return True


@shared
def newton_step(
    p: Array,
    case: int,
    k: Array,
    drag: float,
    cosines: Array,
    sines: Array,
    orbit: float,
    forces: Array,
    follow: Array,
    matrix: Array,
    right: Array,
    ring_step: Array,
    ball_step: Array,
) -> bool:
    """Solve for the steps of ring, cage and balls, from what `eliminate_balls` has filled in.

    Destroys matrix and right. False where the matrix is singular.
    """
    speed = max(least_speed(p, case, k)[1], 1e-300)
    inward = INWARD * k[HALF]
    for i in range(5):
        right[i] = p[rows.APPLIED + i, case] - right[i]
    right[CAGE] = -right[CAGE] - cage_residual(k, drag, orbit, forces)[0]
    for i in range(RING):
        for unknown in range(RING):
            matrix[i, unknown] *= speed if unknown == CAGE else inward
        free = i == CAGE or p[rows.FREE + min(i, 4), case] > 0.0
        largest = 0.0
        for unknown in range(RING):
            largest = max(largest, abs(matrix[i, unknown]))
        for unknown in range(RING):  # one size for all equations, and none for what is held
            unit = 1.0 if i == unknown else 0.0
            matrix[i, unknown] = matrix[i, unknown] / largest if free and largest > 0.0 else unit
        right[i] = right[i] / largest if free and largest > 0.0 else 0.0
    if not solve_dense(matrix, right):
        return False
    for i in range(RING):
        ring_step[i] = right[i] * (speed if i == CAGE else inward)
    for j in range(cosines.size):
        c, s = direction(p, case, cosines[j], sines[j])
        da1 = ring_step[0] + c * ring_step[3] - s * ring_step[4]
        da2 = c * ring_step[2] + s * ring_step[1]
        for row in range(BALL):
            f = follow[j, row]
            ball_step[j, row] = f[0] + f[1] * da1 + f[2] * da2 + f[3] * ring_step[CAGE]
    return True


@shared
def begin(
    p: Array, case: int, k: Array, cosines: Array, sines: Array, u: Array, x: Array, omega: Array
) -> None:
    """Set the balls rolling as under outer raceway control, the cage as the loaded ones have it."""
    weight, orbit = 0.0, 0.0
    for j in range(cosines.size):
        c, s = direction(p, case, cosines[j], sines[j])
        a1, a2 = groove(p, case, u, c, s)
        outer = sqrt(x[j, 0] ** 2 + x[j, 1] ** 2)
        inner = sqrt((a1 - x[j, 0]) ** 2 + (a2 - x[j, 1]) ** 2)
        omega[j, 0], omega[j, 2], own = rolling_start(
            p, case, k, (a1 - x[j, 0]) / inner, (a2 - x[j, 1]) / inner,
            x[j, 0] / outer, x[j, 1] / outer,
        )  # fmt: skip
        omega[j, 1] = 0.0
        load = max(inner - p[rows.INNER_LENGTH, case], 0.0) ** 1.5
        weight += load
        orbit += load * own
    u[CAGE] = orbit / weight if weight > 0.0 else u[CAGE]


@shared
def relax(
    p: Array,
    case: int,
    k: Array,
    drag: float,
    cosines: Array,
    sines: Array,
    nodes: tuple[Array, Array, Array],
    v0: float,
    enough: float,
    u: Array,
    x: Array,
    omega: Array,
    ring_view: Array,
    forces: Array,
    tangent: Array,
) -> tuple[float, int]:
    """Newton's method at one smoothing speed, in place: (greatest residual, evaluations).

    Fills tangent (5, 5), where it is not empty, with the ring's stiffness.
    """
    balls = cosines.size
    residual, matrix = np.empty((balls, BALL)), np.empty((balls, BALL, BALL))
    inputs, slope = np.empty((balls, BALL, 3)), np.empty((balls, 5, BALL + 3))
    ring_step, ball_step = np.empty(RING), np.empty((balls, BALL))
    follow, system, right = np.empty((balls, BALL, 4)), np.empty((RING, RING)), np.empty(RING)
    from_u, from_x, from_omega = u.copy(), x.copy(), omega.copy()
    least = np.full(nodes[0].size, v0 * v0)
    reach = 0.2 * p[rows.OUTER_LENGTH, case]
    merit, worst = evaluate(
        p, case, k, drag, cosines, sines, nodes, least, u, x, omega,
        residual, matrix, inputs, ring_view, slope, forces,
    )  # fmt: skip
    evaluations = 1
    for _ in range(STEPS):
        if worst <= enough:
            break
        if not eliminate_balls(
            p, case, k, cosines, sines, residual, matrix, inputs, ring_view, slope,
            follow, system, right,
        ):  # fmt: skip
            break
        if not newton_step(
            p, case, k, drag, cosines, sines, u[CAGE], forces, follow, system, right,
            ring_step, ball_step,
        ):  # fmt: skip
            break
        longest = 0.0
        for j in range(balls):
            longest = max(longest, abs(ball_step[j, 0]), abs(ball_step[j, 1]))
        part = min(1.0, reach / longest) if longest > 0.0 else 1.0
        from_u[:], from_x[:, :], from_omega[:, :] = u, x, omega
        before = merit
        for _ in range(SHORTENINGS):
            for i in range(RING):
                u[i] = from_u[i] + part * ring_step[i]
            for j in range(balls):
                x[j, 0] = from_x[j, 0] + part * ball_step[j, 0]
                x[j, 1] = from_x[j, 1] + part * ball_step[j, 1]
                for i in range(3):
                    omega[j, i] = from_omega[j, i] + part * ball_step[j, 2 + i]
            merit, worst = evaluate(
                p, case, k, drag, cosines, sines, nodes, least, u, x, omega,
                residual, matrix, inputs, ring_view, slope, forces,
            )  # fmt: skip
            evaluations += 1
            if merit < before:
                break
            part *= 0.4
        if not merit < before:
            break
    if tangent.size > 0 and eliminate_balls(
        p, case, k, cosines, sines, residual, matrix, inputs, ring_view, slope,
        follow, system, right,
    ):  # fmt: skip
        for i in range(5):
            for j in range(5):
                cage = system[i, CAGE] * system[CAGE, j] / system[CAGE, CAGE]
                tangent[i, j] = system[i, j] - cage
    return worst, evaluations


@kernel
def solve_with_friction(
    p: Array,
    case: int,
    k: Array,
    drag: float,
    cosines: Array,
    sines: Array,
    coarse: tuple[Array, Array, Array],
    fine: tuple[Array, Array, Array],
    smoothest: float,
    smoothing: float,
    u: Array,
    x: Array,
    omega: Array,
    ring_view: Array,
    forces: Array,
    tangent: Array,
) -> tuple[int, float, int]:
    """Find the equilibrium with friction from that of raceway control: (code, residual, steps).

    The smoothing, v0 over |ω_i - ω_o| D, falls from the first to the last of the two given, by a
    tenth at a time, or by less where that fails; the last is solved on the fine nodes as well.
    u (RING,) and x (balls, 2) hold the start and take the result, omega (balls, 3) likewise;
    ring_view and forces as in `evaluate`. Fills tangent (5, 5), the derivative of the ring's load
    by its displacement with balls and cage following.
    """
    begin(p, case, k, cosines, sines, u, x, omega)
    speed = least_speed(p, case, k)[0]
    nothing = np.empty((0, 0))
    good_u, good_x, good_omega = u.copy(), x.copy(), omega.copy()
    done, ratio, total, worst = inf, BOLDEST, 0, inf
    wanted = smoothest
    for _ in range(STAGES):
        worst, evaluations = relax(
            p, case, k, drag, cosines, sines, coarse, wanted * speed,
            TOLERANCE if wanted == smoothing else ENOUGH, u, x, omega, ring_view, forces, nothing,
        )  # fmt: skip
        total += evaluations
        if worst <= ENOUGH:
            done = wanted
            good_u[:], good_x[:, :], good_omega[:, :] = u, x, omega
            ratio = max(BOLDEST, ratio * ratio)
            if wanted == smoothing:
                break
        else:
            u[:], x[:, :], omega[:, :] = good_u, good_x, good_omega
            if done == inf:
                smoothest *= 10.0
                wanted = smoothest
                if smoothest > SMOOTHEST:
                    return NOT_CONVERGED, worst, total
                continue
            ratio = sqrt(ratio)
            if ratio > TIMIDEST:
                return NOT_CONVERGED, worst, total
        wanted = max(done * ratio, smoothing)
    if done != smoothing:
        return NOT_CONVERGED, worst, total
    worst, evaluations = relax(
        p, case, k, drag, cosines, sines, fine, smoothing * speed, TOLERANCE,
        u, x, omega, ring_view, forces, tangent,
    )  # fmt: skip
    total += evaluations
    if not worst <= ACCEPTED:
        return NOT_CONVERGED, worst, total
    for j in range(cosines.size):
        c, s = direction(p, case, cosines[j], sines[j])
        a1, _ = groove(p, case, u, c, s)
        if forces[j, 0] > 0.0 and not in_place(p, case, a1, x[j, 0], x[j, 1]):
            return STRAYED, worst, total
    return CONVERGED, worst, total
