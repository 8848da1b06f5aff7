"""Todd's model: one contact of a ball rolls, the other spins, and both lose by hysteresis.

The race that holds the ball sees Heathcote slip only, the other one spin only; the moments are
added without asking whether they balance. Todd, Stevens and Robins (1980), as Ricci and Fleury
describe it.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.friction.closed_forms import (
    DEFAULT_HYSTERESIS,
    rolling_moment,
    spin_moment,
)
from rolamento.friction.model import (
    ControlChoice,
    Setting,
    Torque,
    TorqueModel,
    checked_coefficient,
    controlling_race,
    hysteresis_loss,
    limits_of_dry_friction,
    loss_at_rates,
    torque_of_losses,
    unit_motion,
)
from rolamento.friction.slip import Patch
from rolamento.solved import Solved
from rolamento.words import marked


def todd(
    solved: Solved,
    coefficient: ArrayLike,
    *,
    hysteresis: ArrayLike | None = DEFAULT_HYSTERESIS,
    control: ControlChoice = "jones",
) -> Torque:
    """Torque of Todd's model, for dry or boundary friction at low speed.

    Parameters
    ----------
    solved : cases.
    coefficient : μ, a number or (cases,).
    hysteresis : α_h, likewise; None leaves that part out.
    control : which race the balls roll on; by default that with the greater resistance to spin.

    Returns
    -------
    Torque; parts "spin", "rolling_slip" and "hysteresis".
    """
    mu = checked_coefficient(coefficient, "friction_coefficient", len(solved))
    held = controlling_race(solved, control)
    motion = unit_motion(solved, held)
    inner_roll = np.where(held < 0, motion.inner_roll, 0.0)
    outer_roll = np.where(held > 0, motion.outer_roll, 0.0)
    losses = {
        "spin": loss_at_rates(
            solved, lambda race: spin_moment(race, mu), motion.inner_spin, motion.outer_spin
        ),
        "rolling_slip": loss_at_rates(
            solved, lambda race: rolling_moment(Patch.of(race), mu), inner_roll, outer_roll
        ),
    }
    if hysteresis is not None:
        lost = checked_coefficient(hysteresis, "hysteresis", len(solved))
        losses["hysteresis"] = hysteresis_loss(solved, motion, lost)
    return torque_of_losses(MODEL.name, solved, losses)


def _of_contacts(setting: Setting) -> Torque:
    """Without hysteresis, which is counted for every model."""
    mu = setting.friction_coefficient[:, 0]
    return todd(setting.solved, mu, hysteresis=None, control=setting.control)


MODEL: Final = TorqueModel(
    name="todd",
    title=marked("Todd"),
    short_title=marked("Todd"),
    needs=("friction_coefficient",),
    evaluate=_of_contacts,
    limits=limits_of_dry_friction,
    closed_form=True,
)
