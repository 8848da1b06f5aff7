"""The motion of a ball between turning rings that takes the least power of friction.

Without inertia, friction alone moves the ball. Its power is convex in the ball's angular
velocity and the speed of its orbit, and its gradient holds the moments on the ball and the force
along its orbit: the minimum is the equilibrium. With fewer motions allowed (raceway control) it
is the equilibrium of what remains, and takes no less power.

Newton's method on the rounded law, from a wide rounding to a narrow one, each step shortened
until the power falls: compiled (`free_ball`), or in NumPy for so few balls that loading the
compiler would take longer. Jones's full model and his model with raceway control take their torque
from the motion that is found.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from rolamento.friction import free_ball
from rolamento.friction.model import ContactLoss, has_result
from rolamento.friction.slip import BallVelocity, Patch, RelativeMotion, relative_motion
from rolamento.friction.slip import slip_velocity as slip_at
from rolamento.friction.traction import EllipseMesh, contact_friction, ellipse_mesh
from rolamento.kinematics import BallMotion
from rolamento.numerics import BoolArray, FloatArray
from rolamento.numerics.threads import share_out
from rolamento.records import frozen
from rolamento.solved import Solved

ROUNDINGS = (0.1, 0.01)
"""v0 over the slip that rolling alone makes in the smaller contact, stage by stage."""

GRADIENT_TOLERANCE = free_ball.TOLERANCE
"""Fraction of the sum of what the gradient is made of, without cancellation."""

FEW = 1000
"""Balls that take NumPy less time than loading the compiler."""

COARSE_PLACES = 20
"""Across the ellipses, on which the motion is nearly found."""

_STEPS = 60
_HALVINGS = 30
_ARMIJO = 1e-4
_CHUNK = 64


@frozen
class SharpPower:
    """Power of the friction in the contacts of a race over μ Q; (balls,), m/s.

    total: of the slip, spin: the part that the twisting moment takes.
    """

    total: FloatArray
    spin: FloatArray


@frozen
class FreeMotion:
    """The motion found, for a unit speed of the inner ring relative to the outer.

    Seen from the outer ring. ball_x, ball_z and orbit: (balls,), rad/s; rounding: v0 of the last
    stage, m/s; converged: (balls,); residual: the maximum gradient over its own scale. inner,
    outer: the power by Coulomb's sharp law at this motion, which near a minimum of the rounded one
    is off by the square only.
    """

    ball_x: FloatArray
    ball_z: FloatArray
    orbit: FloatArray
    rounding: FloatArray
    converged: BoolArray
    residual: FloatArray
    inner: SharpPower
    outer: SharpPower

    def at_cage(self) -> BallVelocity:
        """The ball's angular velocity seen from the cage; rad/s."""
        return BallVelocity(self.ball_x - self.orbit, np.zeros_like(self.orbit), self.ball_z)

    def relative_motion(self, patch: Patch) -> RelativeMotion:
        """Roll, twist and drift of the contacts of one race."""
        ring = 1.0 if patch.race == "inner" else 0.0
        return relative_motion(patch, self.at_cage(), ring - self.orbit)


def loaded_contacts(solved: Solved) -> tuple[Patch, Patch, BoolArray]:
    """The contacts of the balls that bear on both races.

    Returns those of the inner and of the outer race, arrays (loaded,), and which of
    (cases, elements) they are.
    """
    chosen = solved.balls_bear
    inner, outer = (_picked(Patch.of(race), chosen) for race in solved.contacts.values())
    return inner, outer, chosen


def start_of(motion: BallMotion, chosen: BoolArray) -> FloatArray:
    """The motion under raceway control, seen from the outer ring: (loaded, 3)."""
    orbit, speed, attitude = (
        array[chosen] for array in (motion.orbital_speed, motion.ball_speed, motion.attitude)
    )
    return np.stack([orbit + speed * np.cos(attitude), -speed * np.sin(attitude), orbit], axis=-1)


def minimum_power_losses(
    solved: Solved,
    mu: FloatArray,
    motion: BallMotion,
    directions: FloatArray,
    mesh: EllipseMesh,
) -> tuple[Mapping[str, ContactLoss], BoolArray, FreeMotion | None]:
    """Losses of every contact at the motion of minimum power, at a unit relative speed; N·m.

    directions: (cases, elements, 3, k), the changes of the motion that are allowed.
    Returns the losses by source, which cases were found, and the motion of the loaded balls.
    """
    inner, outer, chosen = loaded_contacts(solved)
    losses = {name: ContactLoss(*np.zeros((2, *chosen.shape))) for name in ("spin", "rolling_slip")}
    if not np.any(chosen):
        return losses, has_result(solved), None
    mesh = mesh.folded  # nothing tumbles, so the power is even along rolling
    found = minimum_power_motion(inner, outer, start_of(motion, chosen), directions[chosen], mesh)
    coefficient = np.broadcast_to(mu, chosen.shape)[chosen]
    for patch, sharp in ((inner, found.inner), (outer, found.outer)):
        force = coefficient * patch.load
        spin = force * sharp.spin
        getattr(losses["spin"], patch.race)[chosen] = spin
        getattr(losses["rolling_slip"], patch.race)[chosen] = force * sharp.total - spin
    converged = np.ones(chosen.shape, np.bool_)
    converged[chosen] = found.converged
    return losses, np.all(converged, axis=-1), found


def minimum_power_motion(
    inner: Patch,
    outer: Patch,
    start: FloatArray,
    directions: FloatArray,
    mesh: EllipseMesh,
    roundings: tuple[float, ...] = ROUNDINGS,
) -> FreeMotion:
    """Find the motion of minimum friction power.

    Parameters
    ----------
    inner, outer : contacts of the same balls, arrays (balls,).
    start : (balls, 3), a motion (ball_x, ball_z, orbit) for a unit speed of the inner ring.
    directions : (balls, 3, k), which changes of it are allowed.
    mesh : points on the ellipses.
    roundings : stages, falling.

    Returns
    -------
    FreeMotion. Balls whose numbers are alike are solved once.
    """
    balls = len(start)
    motion, found, sharp = np.empty((balls, 3)), np.empty((balls, 2)), np.empty((balls, 2, 2))

    def run(function: Callable[..., None], first: int, beyond: int) -> None:
        if function is free_ball.move_free_balls:  # not compiled
            some = slice(first, beyond)
            motion[some], found[some], sharp[some] = _moved(
                _picked(inner, some), _picked(outer, some), start[some], directions[some], mesh,
                roundings,
            )  # fmt: skip
            return
        function(
            first, beyond, coarse.rows, fine,
            contacts, start, np.ascontiguousarray(directions), np.array(roundings),
            motion, found, sharp,
        )  # fmt: skip

    fine = mesh.rows
    # one row stays one: it is the model of no slip across rolling
    coarse = ellipse_mesh(COARSE_PLACES, min(3, len(fine[1]))).folded
    contacts = np.stack([contact_numbers(patch) for patch in (inner, outer)])
    share_out(
        free_ball.move_free_balls, run, balls, chunk=max(balls, 1), threads=1, little=balls <= FEW
    )
    converged = found[:, 1] <= GRADIENT_TOLERANCE
    motion[~converged] = np.nan
    return FreeMotion(
        motion[:, 0], motion[:, 1], motion[:, 2], found[:, 0], converged, found[:, 1],
        *(SharpPower(sharp[:, race, 0], sharp[:, race, 1]) for race in range(2)),
    )  # fmt: skip


def contact_numbers(patch: Patch) -> FloatArray:
    """What `free_ball` reads of the contacts of a race; (NUMBERS, balls)."""
    lift = patch.rolling_radius(np.zeros_like(patch.load)) - patch.deformed_radius
    angle = patch.contact_angle
    return np.stack(
        [patch.load, np.cos(angle), np.sin(angle), patch.semi_major, patch.semi_minor,
         patch.deformed_radius, lift, 0.5 * patch.pitch_diameter, 0.5 * patch.ball_diameter]
    )  # fmt: skip


def _moved(
    inner: Patch,
    outer: Patch,
    start: FloatArray,
    directions: FloatArray,
    mesh: EllipseMesh,
    roundings: tuple[float, ...],
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """What `free_ball.move_free_balls` finds of all balls: motion, found and sharp, by NumPy."""
    key = np.column_stack([*inner.arrays, *outer.arrays, start, directions.reshape(len(start), -1)])
    _, first, back = np.unique(key, axis=0, return_index=True, return_inverse=True)
    parts = [
        _solved(_picked(inner, c), _picked(outer, c), start[c], directions[c], mesh, roundings)
        for c in np.array_split(first, max(1, -(-first.size // _CHUNK)))
    ]
    motion, rounding, residual, sharp = (
        np.concatenate(arrays)[back.reshape(-1)] for arrays in zip(*parts, strict=True)
    )
    return motion, np.stack([rounding, residual], axis=-1), sharp


def _picked(patch: Patch, chosen: BoolArray | NDArray[np.intp] | slice) -> Patch:
    return patch.mapped(lambda array: array[chosen])


@frozen
class _Problem:
    """Slip as a linear function of the motion: values at zero, and rates by its coordinates.

    rolling (balls, points), transverse (balls, points); *_rate (balls, points, k); weight: the
    load's share of each point (balls, points).
    """

    rolling: FloatArray
    transverse: FloatArray
    rolling_rate: FloatArray
    transverse_rate: FloatArray
    weight: FloatArray

    def of(self, balls: NDArray[np.intp]) -> _Problem:
        """The same for some of the balls."""
        if len(balls) == len(self.weight):
            return self
        return _Problem(
            self.rolling[balls],
            self.transverse[balls],
            self.rolling_rate[balls],
            self.transverse_rate[balls],
            self.weight[balls],
        )


def _solved(
    inner: Patch,
    outer: Patch,
    start: FloatArray,
    directions: FloatArray,
    mesh: EllipseMesh,
    roundings: tuple[float, ...],
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    problem = _problem(inner, outer, start, directions, mesh)
    unit = _slip_scale(inner, outer, start)
    y = np.zeros(directions.shape[::2])
    residual = np.full(len(start), np.inf)
    for stage in roundings:
        y, residual = _newton(problem, y, (stage * unit)[:, np.newaxis])
    motion = start + np.einsum("bik,bk->bi", directions, y)
    sharp = [_sharp(inner, motion, 1.0, mesh), _sharp(outer, motion, 0.0, mesh)]
    return motion, roundings[-1] * unit, residual, np.stack(sharp, axis=1)


def _sharp(patch: Patch, motion: FloatArray, ring: float, mesh: EllipseMesh) -> FloatArray:
    """Power by the sharp law and that of the twist, over μ Q; (balls, 2)."""
    friction = contact_friction(patch, _motion(patch, motion, ring), 1.0, mesh=mesh)
    return np.stack([friction.power, friction.spin_power], axis=-1) / patch.load[:, np.newaxis]


def _problem(
    inner: Patch, outer: Patch, start: FloatArray, directions: FloatArray, mesh: EllipseMesh
) -> _Problem:
    columns = [_contact_columns(patch, start, directions, mesh) for patch in (inner, outer)]
    rolling, transverse, rolling_rate, transverse_rate, weight = (
        np.concatenate(arrays, axis=1) for arrays in zip(*columns, strict=True)
    )
    total = np.sum(weight, axis=1, keepdims=True)
    return _Problem(rolling, transverse, rolling_rate, transverse_rate, weight / total)


def _contact_columns(
    patch: Patch, start: FloatArray, directions: FloatArray, mesh: EllipseMesh
) -> tuple[FloatArray, ...]:
    """Slip at the start, its rates, and the load at the points of one contact."""
    ring = 1.0 if patch.race == "inner" else 0.0
    slip = slip_at(patch, _motion(patch, start, ring), mesh.across, mesh.along)
    rates = [
        slip_at(patch, _motion(patch, directions[..., k], 0.0), mesh.across, mesh.along)
        for k in range(directions.shape[-1])
    ]
    return (
        slip.rolling,
        slip.transverse,
        np.stack([rate.rolling for rate in rates], axis=-1),
        np.stack([rate.transverse for rate in rates], axis=-1),
        patch.load[:, np.newaxis] * mesh.weight,
    )


def _motion(patch: Patch, motion: FloatArray, ring: float) -> RelativeMotion:
    ball_x, ball_z, orbit = motion[:, 0], motion[:, 1], motion[:, 2]
    ball = BallVelocity(ball_x - orbit, np.zeros_like(orbit), ball_z)
    return relative_motion(patch, ball, ring - orbit)


def _slip_scale(inner: Patch, outer: Patch, start: FloatArray) -> FloatArray:
    """Slip that the curvature of the contacts makes in rolling, the smaller of both; m/s."""
    scales = []
    for patch, ring in ((inner, 1.0), (outer, 0.0)):
        roll = np.abs(_motion(patch, start, ring).roll)
        scales.append(roll * patch.semi_major**2 / (2.0 * patch.deformed_radius))
    return np.minimum(*scales)


def _newton(p: _Problem, y: FloatArray, rounding: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Minimise the rounded power per load; y (balls, k), rounding (balls, 1)."""
    y, residual = y.copy(), np.full(len(y), np.inf)
    left = np.arange(len(y))
    for _ in range(_STEPS):
        part, near, width = p.of(left), y[left], rounding[left]
        value, gradient, hessian, scale = _derivatives(part, near, width)
        residual[left] = np.max(np.abs(gradient) / scale, axis=1)
        step = _newton_step(gradient, hessian)
        found = residual[left] <= GRADIENT_TOLERANCE  # and the last step is taken all the same
        length = np.where(found, 1.0, _step_length(part, near, step, width, value, gradient))
        y[left] += length[:, np.newaxis] * step
        left = left[~found & (length > 0.0)]
        if not left.size:
            break
    return y, residual


def _step_length(
    p: _Problem,
    y: FloatArray,
    step: FloatArray,
    rounding: FloatArray,
    value: FloatArray,
    gradient: FloatArray,
) -> FloatArray:
    """Length of a step after which the power is lower (Armijo); 0 where none was found."""
    descent = np.einsum("bk,bk->b", gradient, step)
    length = np.ones(len(y))
    for _ in range(_HALVINGS):
        trial = _power(p, y + length[:, np.newaxis] * step, rounding)
        high = ~(trial <= value + _ARMIJO * length * descent + 1e-15 * value)
        if not np.any(high):
            return length
        length = np.where(high, 0.5 * length, length)
    return np.where(high, 0.0, length)


def _newton_step(gradient: FloatArray, hessian: FloatArray) -> FloatArray:
    """Solve for the step in coordinates that make the diagonal one, with a touch of damping."""
    k = gradient.shape[1]
    diagonal = np.sqrt(np.einsum("bii->bi", hessian))
    scaled = hessian / (diagonal[:, :, np.newaxis] * diagonal[:, np.newaxis, :])
    scaled = scaled + 1e-12 * np.eye(k)
    solved = np.linalg.solve(scaled, -(gradient / diagonal)[:, :, np.newaxis])[:, :, 0]
    return np.asarray(solved / diagonal)


def _slip(p: _Problem, y: FloatArray) -> tuple[FloatArray, FloatArray]:
    column = y[:, :, np.newaxis]
    rolling = p.rolling + np.matmul(p.rolling_rate, column)[:, :, 0]
    return rolling, p.transverse + np.matmul(p.transverse_rate, column)[:, :, 0]


def _power(p: _Problem, y: FloatArray, rounding: FloatArray) -> FloatArray:
    rolling, transverse = _slip(p, y)
    speed = np.sqrt(rolling**2 + transverse**2 + rounding**2)
    return np.asarray(np.einsum("bp,bp->b", p.weight, speed))


def _derivatives(
    p: _Problem, y: FloatArray, rounding: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Rounded power per load, gradient, Hessian, and the gradient without cancellation."""
    rolling, transverse = _slip(p, y)
    speed = np.sqrt(rolling**2 + transverse**2 + rounding**2)
    value = np.einsum("bp,bp->b", p.weight, speed)
    share = p.weight / speed
    toward = (
        rolling[:, :, np.newaxis] * p.rolling_rate
        + transverse[:, :, np.newaxis] * p.transverse_rate
    )
    gradient = np.einsum("bp,bpk->bk", share, toward)
    scale = np.einsum("bp,bpk->bk", share, np.abs(toward))
    hessian = (
        _outer(share, p.rolling_rate)
        + _outer(share, p.transverse_rate)
        - _outer(share / speed**2, toward)
    )
    return value, gradient, hessian, scale


def _outer(weight: FloatArray, rate: FloatArray) -> FloatArray:
    return np.asarray(np.matmul(np.swapaxes(weight[:, :, np.newaxis] * rate, 1, 2), rate))
