"""Jones's model with raceway control: a ball rolls on one race without spin.

The race that holds the ball fixes the axis about which the ball turns relative to it; how fast
it turns, and the orbit, follow from friction, integrated over both ellipses: the minimum of the
power among these motions. It is never below that of the full model.

Jones (1959, 1960).
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.friction.minimum_power import minimum_power_losses
from rolamento.friction.model import (
    ControlChoice,
    Torque,
    TorqueModel,
    checked_coefficient,
    controlling_race,
    limits_of_dry_friction,
    torque_of_losses,
    unit_motion,
)
from rolamento.friction.traction import EllipseMesh, ellipse_mesh
from rolamento.numerics import FloatArray
from rolamento.solved import Solved
from rolamento.words import marked


def jones_control(
    solved: Solved,
    coefficient: ArrayLike,
    *,
    control: ControlChoice = "jones",
    mesh: EllipseMesh | None = None,
) -> Torque:
    """Torque of Jones's model with raceway control, for dry friction at low speed.

    Parameters
    ----------
    solved : cases.
    coefficient : μ, a number or (cases,).
    control : which race the balls roll on; by default that with the greater resistance to spin.
    mesh : points on the ellipses; 80 × 5 by default.

    Returns
    -------
    Torque; parts "spin" and "rolling_slip". A case with a ball that did not converge is NaN.
    """
    mu = checked_coefficient(coefficient, "friction_coefficient", len(solved))
    mesh = ellipse_mesh() if mesh is None else mesh
    held = controlling_race(solved, control)
    directions = _allowed_directions(solved, held)
    losses, converged, _ = minimum_power_losses(
        solved, mu, unit_motion(solved, held), directions, mesh
    )
    return torque_of_losses(MODEL.name, solved, losses, converged)


def _allowed_directions(solved: Solved, held: NDArray[np.int64]) -> FloatArray:
    """Turn about the tangent of the race that holds the ball, and orbit; (cases, balls, 3, 2)."""
    angle = np.where(held > 0, solved.outer.contact_angle, solved.inner.contact_angle)
    zero, one = np.zeros_like(angle), np.ones_like(angle)
    turn = np.stack([np.cos(angle), -np.sin(angle), zero], axis=-1)
    orbit = np.stack([zero, zero, one], axis=-1)
    return np.stack([turn, orbit], axis=-1)


MODEL: Final = TorqueModel(
    name="jones_control",
    title=marked("Jones, raceway control"),
    short_title=marked("Jones ctrl"),
    needs=("friction_coefficient",),
    evaluate=lambda setting: jones_control(
        setting.solved,
        setting.friction_coefficient[:, 0],
        control=setting.control,
        mesh=setting.mesh,
    ),
    limits=limits_of_dry_friction,
)
