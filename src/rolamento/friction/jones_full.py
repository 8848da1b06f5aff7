"""Jones's full model: friction alone decides how the balls move.

Coulomb friction acts over both ellipses of every ball; the ball's angular velocity and orbit are
unknown, and follow from its balance of moments and forces without inertia, which is the minimum
of the power (`minimum_power`). Both contacts spin.

Jones (1959), without its forces of inertia: for low speed.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.friction.minimum_power import FreeMotion, minimum_power_losses
from rolamento.friction.model import (
    Torque,
    TorqueModel,
    checked_coefficient,
    controlling_race,
    limits_of_dry_friction,
    torque_of_losses,
    unit_motion,
)
from rolamento.friction.traction import EllipseMesh, ellipse_mesh
from rolamento.solved import Solved
from rolamento.words import marked


def jones_full(
    solved: Solved, coefficient: ArrayLike, *, mesh: EllipseMesh | None = None
) -> Torque:
    """Torque of Jones's full model, for dry or boundary friction at low speed.

    Parameters
    ----------
    solved : cases.
    coefficient : μ, a number or (cases,). The motion does not depend on it: T is proportional.
    mesh : points on the ellipses; 80 × 5 by default.

    Returns
    -------
    Torque; parts "spin" and "rolling_slip". A case with a ball that did not converge is NaN.
    """
    return jones_full_motion(solved, coefficient, mesh=mesh)[0]


def jones_full_motion(
    solved: Solved, coefficient: ArrayLike, *, mesh: EllipseMesh | None = None
) -> tuple[Torque, FreeMotion | None]:
    """The torque, and the motion of the balls that bear on both races, for a unit speed.

    Parameters as of `jones_full`; the motion is None where no ball is loaded.
    """
    mu = checked_coefficient(coefficient, "friction_coefficient", len(solved))
    mesh = ellipse_mesh() if mesh is None else mesh
    start = unit_motion(solved, controlling_race(solved, "jones"))
    free = np.broadcast_to(np.eye(3), (*solved.inner.load.shape, 3, 3))
    losses, converged, motion = minimum_power_losses(solved, mu, start, free, mesh)
    return torque_of_losses(MODEL.name, solved, losses, converged), motion


MODEL: Final = TorqueModel(
    name="jones_full",
    title=marked("Jones, full"),
    short_title=marked("Jones full"),
    needs=("friction_coefficient",),
    evaluate=lambda setting: jones_full(
        setting.solved, setting.friction_coefficient[:, 0], mesh=setting.mesh
    ),
    limits=limits_of_dry_friction,
)
