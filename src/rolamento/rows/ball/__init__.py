"""The equilibrium of balls and ring: `solve` for a case, `solve_batch` for many duties.

From the inside out: `ball` (one ball's equations), `settle` (one ball's place), `robust` (the
ring, safely), `lanes` and `blocks` (the ring, fast), `accept` (whether a result may be shown),
`batch` (all of it compiled), `run` (threads), `sets` (rows that share a ring), `jones` (raceway
control), `fields` and `columns` (what a batch varies), `detail` and `record` (what the user sees),
`notes` (what he should know).
"""

from rolamento.rows.ball.batch_state import BatchState
from rolamento.rows.ball.solve import solve, solve_batch

__all__ = ["BatchState", "solve", "solve_batch"]
