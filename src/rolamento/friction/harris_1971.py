"""Harris's model of 1971: slip in the rolling direction only, in closed form.

The pressure is summed along the ellipse, q(s) = (3Q/4a)(1 - s²), and friction acts along rolling
with the sign of v_y. That sign changes only on the lines of pure rolling, at most two in each
contact, and between them every integral is a closed form. The motion is the one that balances
the ball: forces along the orbit, moments about x and z. No force acts across rolling, so the
model cannot carry a gyroscopic moment: low speed only. It lies below Jones's full model by about
the factor E(m) of spin, because it leaves out slip across rolling.

Harris (1971), with Ricci and Fleury's equations 15 to 19 as corrected in docs/theory/friction.md.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.friction.line_balance import balance_balls
from rolamento.friction.minimum_power import (
    FEW,
    contact_numbers,
    loaded_contacts,
    minimum_power_motion,
    start_of,
)
from rolamento.friction.model import (
    ContactLoss,
    Torque,
    TorqueModel,
    checked_coefficient,
    controlling_race,
    limits_of_dry_friction,
    torque_of_losses,
    unit_motion,
)
from rolamento.friction.slip import (
    BallVelocity,
    Patch,
    RelativeMotion,
    relative_motion,
    rolling_lines,
)
from rolamento.friction.traction import ellipse_mesh
from rolamento.numerics import BoolArray, FloatArray
from rolamento.numerics.threads import share_out
from rolamento.records import frozen
from rolamento.solved import Solved
from rolamento.words import marked

_POINTS = 120


@frozen
class LineFriction:
    """Friction along rolling of contacts, per μ; arrays (contacts,).

    force N along rolling; roll = ∫ρ f and twist = ∫x0 f, N·m; power for the motion, W.
    """

    force: FloatArray
    roll: FloatArray
    twist: FloatArray
    power: FloatArray


def line_friction(patch: Patch, motion: RelativeMotion) -> LineFriction:
    """Sum friction up between the lines of pure rolling, for a coefficient of one.

    Parameters
    ----------
    patch, motion : of the same contacts, arrays (contacts,).

    Returns
    -------
    LineFriction.
    """
    lines = rolling_lines(patch, motion)
    ends = np.sort(np.nan_to_num(lines, nan=1.0), axis=-1)
    edge = np.ones((*lines.shape[:-1], 1))
    cuts = np.concatenate([-edge, ends, edge], axis=-1)
    middle = 0.5 * (cuts[..., 1:] + cuts[..., :-1])
    sign = np.sign(_slip(patch, motion, middle))
    force, roll, twist = (
        np.sum(sign * np.diff(primitive, axis=-1), axis=-1) * patch.load
        for primitive in _primitives(patch, cuts)
    )
    power = force * motion.drift + patch.side * roll * motion.roll - twist * motion.twist
    return LineFriction(force, roll, twist, power)


def _primitives(patch: Patch, s: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Primitives by s of q, ρ q and x0 q over the load, q the pressure summed along."""
    plain = 0.75 * (s - s**3 / 3.0)
    moment = 0.75 * (s**2 / 2.0 - s**4 / 4.0)
    a, radius = patch.semi_major[..., np.newaxis], patch.deformed_radius[..., np.newaxis]
    ratio = a / radius
    with np.errstate(invalid="ignore"):  # an ellipse wider than the ball has no result
        root = np.sqrt(1.0 - (ratio * s) ** 2)
        angle = np.arcsin(ratio * s)
    first = 0.5 * (s * root + angle / ratio)
    t = ratio * s
    second = (0.125 * (2.0 * t**2 - 1.0) * t * root + 0.125 * angle) / ratio**3
    arc = 0.75 * radius * (first - second)
    lift = patch.rolling_radius(np.zeros_like(patch.load)) - patch.deformed_radius
    return plain, arc + lift[..., np.newaxis] * plain, moment * a


def _slip(patch: Patch, motion: RelativeMotion, s: FloatArray) -> FloatArray:
    """v_y at s = x0/a, (contacts, points)."""
    points = patch.at_points()
    roll, twist, drift = (
        array[..., np.newaxis] for array in (motion.roll, motion.twist, motion.drift)
    )
    return np.asarray(
        drift + patch.side * points.rolling_radius(s) * roll - points.semi_major * s * twist
    )


def harris_1971(solved: Solved, coefficient: ArrayLike) -> Torque:
    """Torque of Harris's model of 1971, for dry friction at low speed.

    Parameters
    ----------
    solved : cases.
    coefficient : μ, a number or (cases,).

    Returns
    -------
    Torque; parts "spin" and "rolling_slip". A case with a ball that did not converge is NaN.
    """
    mu = checked_coefficient(coefficient, "friction_coefficient", len(solved))
    inner, outer, chosen = loaded_contacts(solved)
    parts = {name: ContactLoss(*np.zeros((2, *chosen.shape))) for name in ("spin", "rolling_slip")}
    converged = np.ones(chosen.shape, np.bool_)
    if np.any(chosen):
        start = start_of(unit_motion(solved, controlling_race(solved, "jones")), chosen)
        motion, converged[chosen] = _balanced(inner, outer, start)
        friction = np.broadcast_to(mu, chosen.shape)[chosen]
        for place, patch in enumerate((inner, outer)):
            seen = _motion_at(patch, motion)
            sums = line_friction(patch, seen)
            spin = -friction * sums.twist * seen.twist
            for loss, value in (
                (parts["spin"], spin),
                (parts["rolling_slip"], friction * sums.power - spin),
            ):
                (loss.inner, loss.outer)[place][chosen] = value
    return torque_of_losses(MODEL.name, solved, parts, np.all(converged, axis=-1))


def _balanced(inner: Patch, outer: Patch, start: FloatArray) -> tuple[FloatArray, BoolArray]:
    """The motion (balls, 3) that balances the balls, by Newton with damping from a mesh's."""
    free = np.broadcast_to(np.eye(3), (*start.shape, 3))
    # one point along the ellipse, in the middle: no slip across rolling there
    found = minimum_power_motion(inner, outer, start, free, ellipse_mesh(_POINTS, 1))
    motion = np.stack([found.ball_x, found.ball_z, found.orbit], axis=-1)
    motion = np.where(found.converged[:, np.newaxis], motion, start)
    balls, converged = len(start), np.empty(len(start), np.bool_)
    contacts = np.stack([contact_numbers(patch) for patch in (inner, outer)])

    def run(function: Callable[..., None], first: int, beyond: int) -> None:
        function(first, beyond, contacts, motion, converged)

    share_out(balance_balls, run, balls, chunk=max(balls, 1), threads=1, little=balls <= FEW)
    return motion, converged


def _motion_at(patch: Patch, motion: FloatArray) -> RelativeMotion:
    ball_x, ball_z, orbit = motion[:, 0], motion[:, 1], motion[:, 2]
    ring = 1.0 if patch.race == "inner" else 0.0
    ball = BallVelocity(ball_x - orbit, np.zeros_like(orbit), ball_z)
    return relative_motion(patch, ball, ring - orbit)


MODEL: Final = TorqueModel(
    name="harris_1971",
    title=marked("Harris 1971"),
    short_title=marked("Harris"),
    needs=("friction_coefficient",),
    evaluate=lambda setting: harris_1971(setting.solved, setting.friction_coefficient[:, 0]),
    limits=limits_of_dry_friction,
)
