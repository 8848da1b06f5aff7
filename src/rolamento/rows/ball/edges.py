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
from rolamento.rows.ball.single import OFF_GROOVE, OneCase, changes_groove, direction, groove

TRIALS: Final = 8
OFF: Final = 3.0


@shared
def _regroup(one: OneCase) -> int:
    """Take balls off the inner groove or put them on, in control; how many changed."""
    p, case, control, u, x = one.p, one.case, one.control, one.u, one.x
    changed = 0
    for j in range(control.size):
        c, s = direction(p, case, one.cosines[j], one.sines[j])
        a1, a2 = groove(p, case, u, c, s)
        off = abs(control[j]) >= OFF_GROOVE
        if changes_groove(off, a1, a2, x[j, 0], x[j, 1], p[layout.INNER_LENGTH, case]):
            control[j] = control[j] / OFF if off else control[j] * OFF
            changed += 1
    return changed


@shared
def solve_off_groove(one: OneCase, cage: float) -> tuple[int, float, int, int, float]:
    """Balance the ring without the balls that its groove has left; control is changed.

    Returns (code, residual, unsupported) as `judge` does, (iterations,
    cage's speed); over_shoulder where no set of balls on the groove holds by itself.
    """
    steps = 0
    code, residual, unsupported = status.OVER_SHOULDER, 0.0, -1
    for _ in range(TRIALS):
        if _regroup(one) == 0:
            return code, residual, unsupported, steps, cage
        _, more, _, cage = solve_robust(one, cage)
        steps += more
        code, residual, unsupported = judge(one, cage)
        if code != status.CONVERGED and code != status.OVER_SHOULDER:
            break
    return status.OVER_SHOULDER, residual, -1, steps, cage
