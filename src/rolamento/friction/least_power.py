"""Torque from a ball motion of least power: what Jones's full model and raceway control share."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from rolamento.friction.ellipse_mesh import EllipseMesh
from rolamento.friction.loaded_balls import LoadedBalls
from rolamento.friction.minimum_power import FreeMotion, flat_balls, least_power_motion
from rolamento.friction.slip import Patch
from rolamento.friction.torque import ContactLoss
from rolamento.friction.traction import contact_friction
from rolamento.kinematics import BallMotion
from rolamento.numerics import BoolArray, FloatArray


def start_of(motion: BallMotion, chosen: BoolArray) -> FloatArray:
    """The motion under raceway control, seen from the outer ring: (loaded, 3)."""
    orbit, speed, attitude = (
        array[chosen] for array in (motion.orbital_speed, motion.ball_speed, motion.attitude)
    )
    return np.stack([orbit + speed * np.cos(attitude), -speed * np.sin(attitude), orbit], axis=-1)


def least_power_losses(
    balls: LoadedBalls,
    mu: FloatArray,
    motion: BallMotion,
    directions: FloatArray,
    mesh: EllipseMesh,
) -> tuple[Mapping[str, ContactLoss], BoolArray, FreeMotion | None]:
    """Losses of every contact at the motion of least power, at a unit relative speed; N·m.

    directions: (cases, balls, 3, k), the changes of the motion that are allowed.
    Returns the losses by source, which cases were found, and the motion of the loaded balls.
    """
    inner, outer, chosen = flat_balls(balls)
    if not np.any(chosen):
        return _losses(balls, chosen, {}), balls.solved, None
    mesh = mesh.folded()  # nothing tumbles, so the power is even along rolling
    found = least_power_motion(inner, outer, start_of(motion, chosen), directions[chosen], mesh)
    coefficient = np.broadcast_to(mu, chosen.shape)[chosen]
    by_race: dict[str, tuple[FloatArray, FloatArray]] = {
        patch.race: _power(patch, found, coefficient, mesh) for patch in (inner, outer)
    }
    converged = np.ones(chosen.shape, np.bool_)
    converged[chosen] = found.converged
    return _losses(balls, chosen, by_race), np.all(converged, axis=-1), found


def _power(
    patch: Patch, found: FreeMotion, coefficient: FloatArray, mesh: EllipseMesh
) -> tuple[FloatArray, FloatArray]:
    """Power by spin and by rolling slip of one race's contacts, by Coulomb's sharp law.

    At the motion found with the rounded one: near a minimum that is off by the square only.
    """
    friction = contact_friction(patch, found.relative_motion(patch), coefficient, mesh=mesh)
    return friction.spin_power, friction.power - friction.spin_power


def _losses(
    balls: LoadedBalls, chosen: BoolArray, by_race: Mapping[str, tuple[FloatArray, FloatArray]]
) -> dict[str, ContactLoss]:
    losses = {}
    for place, name in enumerate(("spin", "rolling_slip")):
        parts = []
        for race in ("inner", "outer"):
            part = np.zeros(chosen.shape)
            if race in by_race:
                part[chosen] = by_race[race][place]
            parts.append(part)
        losses[name] = ContactLoss(*parts)
    return losses
