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

from rolamento.friction.control import ControlChoice, controlling_race, unit_motion
from rolamento.friction.ellipse_mesh import EllipseMesh, ellipse_mesh
from rolamento.friction.least_power import least_power_losses
from rolamento.friction.loaded_balls import LoadedBalls
from rolamento.friction.torque import Torque, checked_coefficient, torque_of_losses
from rolamento.numerics import FloatArray

NAME: Final = "jones_control"


def jones_control(
    balls: LoadedBalls,
    coefficient: ArrayLike,
    *,
    control: ControlChoice = "jones",
    mesh: EllipseMesh | None = None,
) -> Torque:
    """Torque of Jones's model with raceway control, for dry friction at low speed.

    Parameters
    ----------
    balls : of solved cases.
    coefficient : μ, a number or (cases,).
    control : which race the balls roll on; by default that with the greater resistance to spin.
    mesh : points on the ellipses; 80 × 5 by default.

    Returns
    -------
    Torque; parts "spin" and "rolling_slip". A case with a ball that did not converge is NaN.
    """
    mu = checked_coefficient(coefficient, "friction_coefficient")
    mesh = ellipse_mesh() if mesh is None else mesh
    held = controlling_race(balls, control)
    directions = _allowed(balls, held)
    losses, converged, _ = least_power_losses(balls, mu, unit_motion(balls, held), directions, mesh)
    return torque_of_losses(NAME, balls, losses, converged)


def _allowed(balls: LoadedBalls, held: NDArray[np.int64]) -> FloatArray:
    """Turn about the tangent of the race that holds the ball, and orbit; (cases, balls, 3, 2)."""
    angle = np.where(held > 0, balls.outer.contact_angle, balls.inner.contact_angle)
    zero, one = np.zeros_like(angle), np.ones_like(angle)
    turn = np.stack([np.cos(angle), -np.sin(angle), zero], axis=-1)
    orbit = np.stack([zero, zero, one], axis=-1)
    return np.stack([turn, orbit], axis=-1)
