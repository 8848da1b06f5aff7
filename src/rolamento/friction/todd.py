"""Todd's model: one contact of a ball rolls, the other spins, and both lose by hysteresis.

The race that holds the ball sees Heathcote slip only, the other one spin only; the moments are
added without asking whether they balance. Todd, Stevens and Robins (1980), as Ricci and Fleury
describe it.
"""

from __future__ import annotations

from typing import Final

from numpy.typing import ArrayLike

from rolamento.friction.closed_forms import rolling_slip_loss, spin_loss
from rolamento.friction.control import ControlChoice, controlling_race, unit_motion
from rolamento.friction.hysteresis import DEFAULT_LOSS, hysteresis_loss
from rolamento.friction.loaded_balls import LoadedBalls
from rolamento.friction.torque import Torque, checked_coefficient, torque_of_losses

NAME: Final = "todd"


def todd(
    balls: LoadedBalls,
    coefficient: ArrayLike,
    *,
    hysteresis: ArrayLike = DEFAULT_LOSS,
    control: ControlChoice = "jones",
) -> Torque:
    """Torque of Todd's model, for dry or boundary friction at low speed.

    Parameters
    ----------
    balls : of solved cases.
    coefficient : μ, a number or (cases,).
    hysteresis : α_h, likewise; 0 leaves hysteresis out.
    control : which race the balls roll on; by default that with the greater resistance to spin.

    Returns
    -------
    Torque; parts "spin", "rolling_slip" and "hysteresis".
    """
    mu = checked_coefficient(coefficient, "friction_coefficient")
    lost = checked_coefficient(hysteresis, "hysteresis")
    held = controlling_race(balls, control)
    motion = unit_motion(balls, held)
    losses = {
        "spin": spin_loss(balls, motion, mu),
        "rolling_slip": rolling_slip_loss(balls, motion, mu, at_inner=held < 0, at_outer=held > 0),
        "hysteresis": hysteresis_loss(balls, motion, lost),
    }
    return torque_of_losses(NAME, balls, losses, balls.solved)
