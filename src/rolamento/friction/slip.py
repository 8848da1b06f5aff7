"""Slip inside the contacts: how the race's surface moves over the ball's, point by point.

The frame stands at the ball and turns with its orbit: x along the shaft, z radially outward,
y = z × x along the orbit. A contact at angle α has the tangent t = (cos α, 0, -sin α) across
rolling and the normal n = (sin α, 0, cos α), so that (t, y, n) is right-handed; σ = +1 at the
outer contact, which lies at +n, and -1 at the inner one, at -n. A point of the contact lies at
x0 t + y0 y + σ ρ n from the ball's centre. With the ring's speed ω_r and the ball's angular
velocity ω_b, both seen from the cage, and w = ω_b - ω_r x,

    v_y = -ω_r d_m/2 + σ ρ w·t - x0 w·n        in the rolling direction
    v_t = -σ ρ ω_y + y0 w·n                    across it

is the velocity of the race relative to the ball: friction on the ball points along it. Both
surfaces lie on the deformed arc of radius R = 2 f D/(2 f + 1):

    ρ(x0) = √(R² - x0²) - √(R² - a²) + √(D²/4 - a²)

Sources: Jones (1959); Harris (1991), chapter 8; Braga and Almeida, equations 28 to 44, who draw
the outer contact on the -x side (α → -α). What is misprinted there is listed in
docs/theory/slip.md.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from rolamento.geometry import Race
from rolamento.kinematics import spin_resistance, spin_to_roll
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.solved import Contacts, Solved
from rolamento.validate import within

_FASTEST: Final = 1e9
"""rad/s, far beyond any bearing: a number above has the wrong unit."""


class BallVelocity(NamedTuple):
    """Angular velocity of balls seen from the cage; arrays of one shape, rad/s."""

    x: FloatArray
    y: FloatArray
    z: FloatArray


@frozen
class Patch:
    """Loaded contacts of balls with one race: what slip depends on; arrays of one shape.

    load N, contact_angle rad, semi_major and semi_minor m, ball_diameter and pitch_diameter m,
    conformity the groove's radius over the ball's diameter.
    """

    race: Race
    load: FloatArray
    contact_angle: FloatArray
    semi_major: FloatArray
    semi_minor: FloatArray
    ball_diameter: FloatArray
    pitch_diameter: FloatArray
    conformity: FloatArray

    @classmethod
    def of(cls, contacts: Contacts) -> Patch:
        """The contacts of a race as they were solved; (cases, elements)."""
        names = (field.name for field in fields(cls))
        return cls(*(getattr(contacts, name) for name in names))

    @property
    def side(self) -> float:
        """σ: +1 for the outer contact, -1 for the inner."""
        return 1.0 if self.race == "outer" else -1.0

    @property
    def deformed_radius(self) -> FloatArray:
        """Radius R = 2 f D/(2 f + 1) of the deformed surface across rolling; m. Jones (1959)."""
        f = self.conformity
        return np.asarray(2.0 * f * self.ball_diameter / (2.0 * f + 1.0))

    @property
    def resistance_to_spin(self) -> FloatArray:
        """Q a E(m); N·m, 0 without load."""
        touching = self.load > 0.0
        ratio = np.where(touching, self.semi_major, 1.0) / np.where(touching, self.semi_minor, 1.0)
        return spin_resistance(self.load, self.semi_major, ratio)

    @property
    def max_pressure(self) -> FloatArray:
        """Hertz pressure p0 = 3Q/(2πab); Pa, NaN without a contact."""
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.asarray(1.5 * self.load / (np.pi * self.semi_major * self.semi_minor))

    def rolling_radius(self, across: FloatArray) -> FloatArray:
        """Radius ρ of the surface about the axis t, at points `across` times a from the middle.

        across : array that broadcasts with the patch. Returns m; NaN where a exceeds D/2.
        """
        return np.asarray(self._arc(across) + self._lift)

    def _arc(self, across: FloatArray) -> FloatArray:
        with np.errstate(invalid="ignore"):
            return np.sqrt(self.deformed_radius**2 - (across * self.semi_major) ** 2)

    @property
    def _lift(self) -> FloatArray:
        """ρ - √(R² - x0²): from the arc's centre to the ball's."""
        a2 = self.semi_major**2
        with np.errstate(invalid="ignore"):
            chord = np.sqrt(0.25 * self.ball_diameter**2 - a2)
            return np.asarray(chord - np.sqrt(self.deformed_radius**2 - a2))

    def at_points(self) -> Patch:
        """The same contacts with one more axis, for points on each."""
        return self.mapped(lambda array: array[..., np.newaxis])

    def mapped(self, function: Callable[[FloatArray], FloatArray]) -> Patch:
        """The patch with a function applied to each of its arrays."""
        return Patch(self.race, *map(function, self.arrays))

    @property
    def arrays(self) -> tuple[FloatArray, ...]:
        """All arrays, in the order of the constructor."""
        return tuple(getattr(self, field.name) for field in fields(self)[1:])


@frozen
class RelativeMotion:
    """How a race moves relative to the ball, contact by contact; arrays of one shape.

    v_y = drift + σ ρ roll - x0 twist, v_t = -σ ρ tumble + y0 twist.
    """

    drift: FloatArray
    """-ω_r d_m/2: speed of the ring at the pitch circle; m/s."""
    roll: FloatArray
    """w·t, ball relative to ring about the tangent; rad/s."""
    twist: FloatArray
    """w·n, ball relative to ring about the outward normal; rad/s."""
    tumble: FloatArray
    """ω_y of the ball; rad/s."""
    side: float

    @property
    def spin(self) -> FloatArray:
        """Ball relative to ring about the normal from the ring into the ball; rad/s."""
        return np.asarray(-self.side * self.twist)

    @property
    def spin_to_roll(self) -> FloatArray:
        """Ratio of spin to roll; NaN where nothing rolls."""
        return spin_to_roll(self.spin, self.roll)


@frozen
class Slip:
    """Velocity of the race relative to the ball at points of contacts; m/s, one shape."""

    rolling: FloatArray
    """v_y, along the rolling direction."""
    transverse: FloatArray
    """v_t, across it."""

    @property
    def speed(self) -> FloatArray:
        """Magnitude; m/s."""
        return np.hypot(self.rolling, self.transverse)


def relative_motion(patch: Patch, ball: BallVelocity, ring_speed: ArrayLike) -> RelativeMotion:
    """Roll, twist and drift of contacts.

    Parameters
    ----------
    patch : contacts of one race, arrays (...).
    ball : angular velocity of the balls seen from the cage, arrays that broadcast; rad/s.
    ring_speed : of this ring, seen from the cage, array that broadcasts; rad/s.

    Returns
    -------
    RelativeMotion of the broadcast shape.

    Raises
    ------
    InputError
        If a speed is not finite, or beyond 1e9 rad/s.
    """
    ring = _speed(ring_speed, "ring_speed")
    x, y, z = (_speed(part, f"ball.{name}") for name, part in ball._asdict().items())
    cosine, sine = np.cos(patch.contact_angle), np.sin(patch.contact_angle)
    along = x - ring
    drift, roll, twist, tumble = np.broadcast_arrays(
        -0.5 * ring * patch.pitch_diameter,
        along * cosine - z * sine,
        along * sine + z * cosine,
        y,
    )
    return RelativeMotion(drift, roll, twist, tumble, patch.side)


def _speed(value: ArrayLike, field: str) -> FloatArray:
    return within(value, field, "rad/s", -_FASTEST, _FASTEST)


def solved_motion(solved: Solved, race: Race, *, yawing: bool = True) -> RelativeMotion:
    """Roll, twist and drift of the contacts of a race as they were solved; (cases, elements).

    yawing: with the yaw that friction control gives the axes of the balls.
    """
    elements, contacts = solved.elements, solved.contacts[race]
    yaw = elements.yaw if yawing else np.zeros_like(elements.yaw)
    across = elements.ball_speed * np.cos(elements.attitude)
    ball = BallVelocity(
        across * np.cos(yaw),
        across * np.sin(yaw),
        -elements.ball_speed * np.sin(elements.attitude),
    )
    return relative_motion(Patch.of(contacts), ball, contacts.ring_speed - elements.orbital_speed)


def slip_velocity(
    patch: Patch, motion: RelativeMotion, across: ArrayLike, along: ArrayLike
) -> Slip:
    """Slip at points of the contacts.

    Parameters
    ----------
    patch, motion : of the same contacts, arrays (...).
    across, along : x0/a and y0/b of the points, arrays (points,) or (..., points).

    Returns
    -------
    Slip, arrays (..., points).
    """
    u, v = np.asarray(across, dtype=np.float64), np.asarray(along, dtype=np.float64)
    points = patch.at_points()
    radius = patch.side * points.rolling_radius(u)
    twist = motion.twist[..., np.newaxis]
    rolling = (
        motion.drift[..., np.newaxis]
        + radius * motion.roll[..., np.newaxis]
        - points.semi_major * u * twist
    )
    transverse = points.semi_minor * v * twist - radius * motion.tumble[..., np.newaxis]
    return Slip(*np.broadcast_arrays(rolling, transverse))


def rolling_lines(patch: Patch, motion: RelativeMotion) -> FloatArray:
    """Lines without slip in the rolling direction, x0 = const across the ellipse.

    v_y does not depend on y0, so it vanishes on lines: where the arc of the contact meets the
    straight line of equal speeds (Harris 1971). There are two, one or none.

    Parameters
    ----------
    patch, motion : of the same contacts, arrays (...).

    Returns
    -------
    x0/a of the lines, (..., 2) in rising order; NaN for a line outside the ellipse.
    """
    a, radius = patch.semi_major, patch.deformed_radius
    slope, turn = patch.side * motion.roll, motion.twist
    level = motion.drift + slope * patch._lift
    # slope √(R² - x²) = turn x - level, squared
    with np.errstate(invalid="ignore", divide="ignore"):
        total = slope**2 + turn**2
        root = np.abs(slope) * np.sqrt(radius**2 * total - level**2)
        roots = np.stack([turn * level - root, turn * level + root], axis=-1)
        lines = roots / (total * a)[..., np.newaxis]
        across = lines * a[..., np.newaxis]
        same = (turn[..., np.newaxis] * across - level[..., np.newaxis]) * slope[..., np.newaxis]
        inside = (np.abs(lines) <= 1.0) & (same >= 0.0)
    return np.sort(np.where(inside, lines, np.nan), axis=-1)


def pressure_share(across: ArrayLike, along: ArrayLike) -> FloatArray:
    """Hertz pressure over its maximum, √(1 - u² - v²); 0 outside the ellipse.

    Parameters: x0/a and y0/b, arrays that broadcast. Returns the broadcast shape.
    """
    inside = 1.0 - np.asarray(across) ** 2 - np.asarray(along) ** 2
    return np.asarray(np.sqrt(np.maximum(inside, 0.0)))


@frozen
class PressureSlip:
    """The maximum product of pressure and slip in contacts, and where it is.

    value W/m², across and along x0/a and y0/b; arrays of one shape.
    """

    value: FloatArray
    across: FloatArray
    along: FloatArray


_SHRINKING: Final = 0.1
"""Reduction of the grid from one zoom to the next."""


def maximum_pressure_slip(patch: Patch, motion: RelativeMotion) -> PressureSlip:
    """Find the maximum of p·v over every ellipse: a grid, then grids around its best point.

    Parameters
    ----------
    patch, motion : of the same contacts, arrays (...).

    Returns
    -------
    PressureSlip of that shape, the value to about 1e-9 of itself; NaN without a contact.
    """
    within(patch.load, "patch.load", "N", 0.0, 1e12)
    shape = motion.roll.shape
    centre_u, centre_v = np.zeros(shape), np.zeros(shape)
    best = np.full(shape, -1.0)
    steps = np.linspace(-1.0, 1.0, 41)
    grid_u, grid_v = (array.ravel() for array in np.meshgrid(steps, steps, indexing="ij"))
    width = 1.0
    for _ in range(6):
        u = np.clip(centre_u[..., np.newaxis] + width * grid_u, -1.0, 1.0)
        v = np.clip(centre_v[..., np.newaxis] + width * grid_v, -1.0, 1.0)
        slip = slip_velocity(patch, motion, u, v)
        product = pressure_share(u, v) * slip.speed
        place = np.argmax(np.nan_to_num(product), axis=-1)[..., np.newaxis]
        found = np.take_along_axis(product, place, axis=-1)[..., 0]
        centre_u = np.take_along_axis(u, place, axis=-1)[..., 0]
        centre_v = np.take_along_axis(v, place, axis=-1)[..., 0]
        best = np.maximum(best, found)
        width *= _SHRINKING
    return PressureSlip(best * patch.max_pressure, centre_u, centre_v)


def fast_maximum_pressure_slip(patch: Patch, motion: RelativeMotion) -> FloatArray:
    """The maximum of p·v of each contact, without its place; W/m², NaN without a contact.

    For a ball that does not tumble, v² = v_y(u)² + (b ω_n v)² at u = x0/a, v = y0/b, and over v
    (1 - u² - v²)(A² + B² v²) is at its maximum where v² = max(0, ((1 - u²) B² - A²)/(2 B²)): only
    u is left to be searched. Where balls tumble, the whole ellipse is searched.

    Parameters
    ----------
    patch, motion : of the same contacts, arrays (...).
    """
    flat = patch.mapped(np.ravel)
    columns = [np.ravel(a) for a in (motion.drift, motion.roll, motion.twist, motion.tumble)]
    tumbles = bool(np.any(np.nan_to_num(columns[3]) != 0.0))
    found = np.full(flat.load.size, np.nan)
    size = 128 if tumbles else 2048
    (contacts,) = np.nonzero(flat.load > 0.0)
    for first in range(0, contacts.size, size):
        some = contacts[first : first + size]
        part = flat.mapped(lambda array, chosen=some: array[chosen])  # type: ignore[misc]
        drift, roll, twist, tumble = (column[some] for column in columns)
        own = RelativeMotion(drift, roll, twist, tumble, motion.side)
        if tumbles:
            found[some] = maximum_pressure_slip(part, own).value
        else:
            found[some] = _maximum_without_tumbling(part, own)
    return found.reshape(patch.load.shape)


def _maximum_without_tumbling(patch: Patch, motion: RelativeMotion) -> FloatArray:
    """Maxima of contacts (contacts,): a grid over u, then grids about its best."""
    points = patch.at_points()
    drift, roll, twist = (
        array[:, np.newaxis] for array in (motion.drift, motion.roll, motion.twist)
    )
    across = (points.semi_minor * twist) ** 2
    steps, centre, width = np.linspace(-1.0, 1.0, 41), np.zeros((patch.load.size, 1)), 1.0
    best = np.zeros(patch.load.size)
    for _ in range(4):
        u = np.clip(centre + width * steps, -1.0, 1.0)
        rolling = drift + motion.side * points.rolling_radius(u) * roll
        along = (rolling - points.semi_major * u * twist) ** 2
        room = 1.0 - u**2
        with np.errstate(divide="ignore", invalid="ignore"):
            square = np.where(across > 0.0, 0.5 * (room - along / across), 0.0)
        square = np.clip(square, 0.0, room)
        product = (room - square) * (along + across * square)
        place = np.argmax(product, axis=1)[:, np.newaxis]
        centre = np.take_along_axis(u, place, axis=1)
        best = np.maximum(best, np.take_along_axis(product, place, axis=1)[:, 0])
        width *= _SHRINKING
    return np.sqrt(best) * patch.max_pressure
