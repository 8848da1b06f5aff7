"""Jones's model simplified: spin and rolling slip are computed apart and added.

Both contacts roll with Heathcote slip; the one that does not hold the ball spins besides. Where
a contact does both, the sum overrates it, because friction there has one direction only. Ricci
and Fleury found it nearest to Todd's measurements.
"""

from __future__ import annotations

from typing import Final

from numpy.typing import ArrayLike

from rolamento.friction.closed_forms import rolling_slip_loss, spin_loss
from rolamento.friction.control import ControlChoice, controlling_race, unit_motion
from rolamento.friction.loaded_balls import LoadedBalls
from rolamento.friction.torque import Torque, checked_coefficient, torque_of_losses

NAME: Final = "jones_simplified"


def jones_simplified(
    balls: LoadedBalls, coefficient: ArrayLike, *, control: ControlChoice = "jones"
) -> Torque:
    """Torque of Jones's model with spin and rolling apart, for dry friction at low speed.

    Parameters
    ----------
    balls : of solved cases.
    coefficient : μ, a number or (cases,).
    control : which race the balls roll on; by default that with the greater resistance to spin.

    Returns
    -------
    Torque; parts "spin" and "rolling_slip".
    """
    mu = checked_coefficient(coefficient, "friction_coefficient")
    motion = unit_motion(balls, controlling_race(balls, control))
    losses = {
        "spin": spin_loss(balls, motion, mu),
        "rolling_slip": rolling_slip_loss(balls, motion, mu),
    }
    return torque_of_losses(NAME, balls, losses, balls.solved)
