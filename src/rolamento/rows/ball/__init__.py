"""A row of balls: the equilibrium of balls and ring, compiled. Private but for `row`.

From the inside out: `ball` (one ball's equations), `settle` (one ball's place), `robust` (the
ring, safely), `lanes` and `blocks` (the ring, fast), `continuation` and `edges` (where those fail),
`accept` (whether a result may be shown), `batch` (all of it compiled), `run` (threads), `problem`
(from a bearing to numbers), `detail` (every ball, once its place is known), `traction` (friction
alone moves the balls), `row` (what others see). `layout` says what stands where in the arrays.
"""
