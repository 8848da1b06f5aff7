"""Balls that the inner ring has left: out of its groove on the open side, nothing presses on them.

The paths to a solution let a groove's flanks go on straight up beyond 90°, so that no force jumps
on the way. Where a ball of the solution is pressed out there, it is taken off the groove and the
rest is balanced without it; where that brings it back between the flanks, it is put on again. A
contact beyond the edge of a lower shoulder is another matter: the ball is in the groove and
loaded, and what its edge bears is not computed (`accept`).
"""

from __future__ import annotations

from typing import Final

from rolamento import status
from rolamento.numerics.compiled import shared
from rolamento.rows.ball import layout
from rolamento.rows.ball.accept import judge
from rolamento.rows.ball.robust import solve_robust
from rolamento.rows.ball.single import OFF_GROOVE, Ring, changes_groove, direction, groove
from rolamento.rows.ball.types import Array

TRIALS: Final = 8
OFF: Final = 3.0


@shared
def _regroup(
    p: Array, case: int, control: Array, cosines: Array, sines: Array, u: Array, x: Array
) -> int:
    """Take balls off the inner groove or put them on, in control; how many changed."""
    changed = 0
    for j in range(cosines.size):
        c, s = direction(p, case, cosines[j], sines[j])
        a1, a2 = groove(p, case, u, c, s)
        off = abs(control[j]) >= OFF_GROOVE
        if changes_groove(off, a1, a2, x[j, 0], x[j, 1], p[layout.INNER_LENGTH, case]):
            control[j] = control[j] / OFF if off else control[j] * OFF
            changed += 1
    return changed


@shared
def solve_off_groove(
    p: Array,
    case: int,
    moving: bool,
    control: Array,
    cosines: Array,
    sines: Array,
    u: Array,
    cage: float,
    x: Array,
    ring: Ring,
    errors: Array,
) -> tuple[int, float, int, int, float]:
    """Balance the ring without the balls that its groove has left; u and x in place.

    control (balls,) is changed. Returns (code, residual, unsupported) as `judge` does, (iterations,
    cage's speed); over_shoulder where no set of balls on the groove holds by itself.
    """
    steps = 0
    code, residual, unsupported = status.OVER_SHOULDER, 0.0, -1
    for _ in range(TRIALS):
        if _regroup(p, case, control, cosines, sines, u, x) == 0:
            return code, residual, unsupported, steps, cage
        _, more, _, cage = solve_robust(p, case, moving, control, cosines, sines, u, cage, x, ring)
        steps += more
        code, residual, unsupported = judge(
            p, case, moving, control, cosines, sines, u, cage, x, ring, errors
        )
        if code != status.CONVERGED and code != status.OVER_SHOULDER:
            break
    return status.OVER_SHOULDER, residual, -1, steps, cage
