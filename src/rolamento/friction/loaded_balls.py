"""What the friction models read of a solved state: every ball's contacts, and the rings' speeds."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rolamento.contact.hertz import effective_modulus
from rolamento.friction.slip import BallVelocity, Patch
from rolamento.geometry import Race, race_curvature
from rolamento.numerics import BoolArray, FloatArray
from rolamento.rows.ball import BatchState, layout
from rolamento.state import State

NO_LOAD = 1e-9
"""Of the load at the outer race: what is less is rounding, and no contact."""

_CONTROL_CODES = {"outer": 1, "inner": -1}


@dataclass(frozen=True, slots=True)
class LoadedBalls:
    """The balls of solved cases, arrays (cases, balls); a case without a result holds NaN.

    Attributes
    ----------
    inner, outer
        the contacts
    inner_speed, outer_speed
        of the rings about the shaft, (cases, 1), rad/s
    orbital_speed, ball_speed, attitude
        as the state has them: rad/s, rad/s, rad
    control
        1 outer, -1 inner, 0 where neither race controls
    centrifugal_force, gyroscopic_moment
        N, N·m
    inner_rolling_curvature, outer_rolling_curvature
        1/R_x, summed over ball and ring; 1/m
    modulus
        E'; Pa
    """

    inner: Patch
    outer: Patch
    inner_speed: FloatArray
    outer_speed: FloatArray
    orbital_speed: FloatArray
    ball_speed: FloatArray
    attitude: FloatArray
    control: NDArray[np.int64]
    centrifugal_force: FloatArray
    gyroscopic_moment: FloatArray
    inner_rolling_curvature: FloatArray
    outer_rolling_curvature: FloatArray
    modulus: FloatArray

    @property
    def loaded(self) -> BoolArray:
        """(cases, balls): whether the ball bears on both races."""
        inner, outer = self.inner.load, self.outer.load
        with np.errstate(invalid="ignore"):
            return np.asarray((inner > NO_LOAD * outer) & (outer > 0.0))

    @property
    def solved(self) -> BoolArray:
        """(cases,): whether the case has a result, with ellipses narrower than the balls."""
        with np.errstate(invalid="ignore"):
            narrow = [2.0 * patch.semi_major < patch.ball_diameter for patch in self.patches]
        fine = np.isfinite(self.outer.load) & (np.all(narrow, axis=0) | ~self.loaded)
        return np.asarray(np.all(fine, axis=-1))

    @property
    def patches(self) -> tuple[Patch, Patch]:
        """The contacts of both races, inner and outer."""
        return self.inner, self.outer

    @property
    def relative_speed(self) -> FloatArray:
        """(cases, 1): of the inner ring to the outer; rad/s."""
        return np.asarray(self.inner_speed - self.outer_speed)

    @property
    def ball_velocity(self) -> BallVelocity:
        """Of the balls seen from the cage, by raceway control as the state has it; rad/s."""
        return BallVelocity(
            self.ball_speed * np.cos(self.attitude),
            np.zeros_like(self.ball_speed),
            -self.ball_speed * np.sin(self.attitude),
        )

    def ring_speed(self, race: Race) -> FloatArray:
        """(cases, balls): of a ring, seen from the cage as the state has it; rad/s."""
        ring = self.inner_speed if race == "inner" else self.outer_speed
        return np.asarray(ring - self.orbital_speed)

    def patch(self, race: Race) -> Patch:
        """The contacts of one race."""
        return self.inner if race == "inner" else self.outer


def loaded_balls(state: State | BatchState) -> LoadedBalls:
    """Read the balls of a solved state, or of a batch of them.

    A state becomes a batch of one case; a case without a result holds NaN.
    """
    return _of_state(state) if isinstance(state, State) else _of_batch(state)


def _of_state(state: State) -> LoadedBalls:
    duty, places = state.case.duty, state.case.bearing.places
    bearings = [places[ball.row].bearing for ball in state.balls]
    nan = np.nan if not state.status.converged else 0.0

    def column(values: list[float]) -> FloatArray:
        return np.array([values], dtype=np.float64) + nan

    def patch(race: Race) -> Patch:
        contacts = [ball.inner if race == "inner" else ball.outer for ball in state.balls]
        conformities = [
            b.inner_conformity if race == "inner" else b.outer_conformity for b in bearings
        ]
        return Patch(
            race,
            column([c.load for c in contacts]),
            column([c.contact_angle for c in contacts]),
            column([c.semi_major for c in contacts]),
            column([c.semi_minor for c in contacts]),
            column([b.ball_diameter for b in bearings]),
            column([b.pitch_diameter for b in bearings]),
            column(conformities),
        )

    inner, outer = patch("inner"), patch("outer")
    materials = [(b.ball_material, b.ring_material) for b in bearings]
    return LoadedBalls(
        inner,
        outer,
        inner_speed=np.array([[duty.inner_speed]]),
        outer_speed=np.array([[duty.outer_speed]]),
        orbital_speed=column([ball.orbital_speed for ball in state.balls]),
        ball_speed=column([ball.ball_speed for ball in state.balls]),
        attitude=column([ball.attitude for ball in state.balls]),
        control=np.array([[_CONTROL_CODES.get(b.raceway_control, 0) for b in state.balls]]),
        centrifugal_force=column([ball.centrifugal_force for ball in state.balls]),
        gyroscopic_moment=column([ball.gyroscopic_moment for ball in state.balls]),
        inner_rolling_curvature=_rolling_curvature(inner),
        outer_rolling_curvature=_rolling_curvature(outer),
        modulus=column([effective_modulus(*pair) for pair in materials]),
    )


def _of_batch(batch: BatchState) -> LoadedBalls:
    table = batch.balls()
    first = batch.rows[0].parameters
    inner, outer = (_patch_of(batch, race) for race in ("inner", "outer"))
    return LoadedBalls(
        inner,
        outer,
        inner_speed=first[layout.INNER_SPEED][:, np.newaxis],
        outer_speed=first[layout.OUTER_SPEED][:, np.newaxis],
        orbital_speed=table.motion.orbital_speed,
        ball_speed=table.motion.ball_speed,
        attitude=table.motion.attitude,
        control=batch.raceway_control,
        centrifugal_force=table.centrifugal_force,
        gyroscopic_moment=table.gyroscopic_moment,
        inner_rolling_curvature=_rolling_curvature(inner),
        outer_rolling_curvature=_rolling_curvature(outer),
        modulus=_per_ball(batch, layout.MODULUS),
    )


def _patch_of(batch: BatchState, race: Race) -> Patch:
    table = batch.balls()
    contacts = table.inner if race == "inner" else table.outer
    ellipse = batch.contact(race, table)
    diameter = _per_ball(batch, layout.BALL_DIAMETER)
    length = _per_ball(batch, layout.INNER_LENGTH if race == "inner" else layout.OUTER_LENGTH)
    return Patch(
        race,
        contacts.load,
        contacts.contact_angle,
        ellipse.semi_major,
        ellipse.semi_minor,
        diameter,
        diameter / _per_ball(batch, layout.GAMMA),
        0.5 + length / diameter,
    )


def _per_ball(batch: BatchState, parameter: int) -> FloatArray:
    """A parameter of each row of balls, repeated for its balls; (cases, balls)."""
    parts = [
        np.repeat(row.parameters[parameter][:, np.newaxis], row.azimuth.shape[1], axis=1)
        for row in batch.rows
    ]
    return np.concatenate(parts, axis=1)


def _rolling_curvature(patch: Patch) -> FloatArray:
    return race_curvature(
        patch.ball_diameter,
        patch.pitch_diameter,
        patch.conformity,
        patch.contact_angle,
        patch.race,
    ).rolling
