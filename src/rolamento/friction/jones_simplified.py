"""Jones's model simplified: spin and rolling slip are computed apart and added.

Both contacts roll with Heathcote slip; the one that does not hold the ball spins besides. Where
a contact does both, the sum overrates it, because friction there has one direction only. Ricci
and Fleury found it nearest to Todd's measurements.
"""

from __future__ import annotations

from typing import Final

from numpy.typing import ArrayLike

from rolamento.friction.closed_forms import rolling_moment, spin_moment
from rolamento.friction.model import (
    ControlChoice,
    Torque,
    TorqueModel,
    checked_coefficient,
    controlling_race,
    limits_of_dry_friction,
    loss_at_rates,
    torque_of_losses,
    unit_motion,
)
from rolamento.friction.slip import Patch
from rolamento.kinematics import BallMotion
from rolamento.solved import Solved
from rolamento.words import marked


def jones_simplified(
    solved: Solved,
    coefficient: ArrayLike,
    *,
    control: ControlChoice = "jones",
    motion: BallMotion | None = None,
) -> Torque:
    """Torque of Jones's model with spin and rolling apart, for dry friction at low speed.

    Parameters
    ----------
    solved : cases.
    coefficient : μ, a number or (cases,).
    control : which race the balls roll on; by default that with the greater resistance to spin.
    motion : of the balls under that control, where it is known.

    Returns
    -------
    Torque; parts "spin" and "rolling_slip".
    """
    mu = checked_coefficient(coefficient, "friction_coefficient", len(solved))
    if motion is None:
        motion = unit_motion(solved, controlling_race(solved, control))
    losses = {
        "spin": loss_at_rates(
            solved, lambda race: spin_moment(race, mu), motion.inner_spin, motion.outer_spin
        ),
        "rolling_slip": loss_at_rates(
            solved,
            lambda race: rolling_moment(Patch.of(race), mu),
            motion.inner_roll,
            motion.outer_roll,
        ),
    }
    return torque_of_losses(MODEL.name, solved, losses)


MODEL: Final = TorqueModel(
    name="jones_simplified",
    title=marked("Jones, simplified"),
    short_title=marked("Jones simp"),
    needs=("friction_coefficient",),
    evaluate=lambda setting: jones_simplified(
        setting.solved, setting.friction_coefficient[:, 0], motion=setting.unit_motion
    ),
    limits=limits_of_dry_friction,
    closed_form=True,
)
