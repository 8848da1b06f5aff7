"""The 218 solved: a ball under friction alone and one under outer raceway control."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Final, Literal

import numpy as np

from rolamento.case import Case
from rolamento.case.bearing import Bearing
from rolamento.case.duty import Duty, Load
from rolamento.case.lubricant import Lubricant
from rolamento.case.model import Model
from rolamento.friction.slip import (
    BallVelocity,
    Patch,
    RelativeMotion,
    relative_motion,
)
from rolamento.geometry import Race
from rolamento.rows.ball import solve
from rolamento.state import State
from rolamento_reproductions.braga_almeida.orbit import Orbits
from rolamento_reproductions.given import KILO, MILLI, RPM, Given
from rolamento_reproductions.record import Floats

__all__ = ["GIVEN", "Ball", "ball", "bearing"]

GIVEN: Final = Given("braga_almeida")
Control = Literal["outer", "friction"]


def bearing() -> Bearing:
    """Return the 218."""
    given = GIVEN.inputs_of("bearing")
    return Bearing(
        ball_count=given["ball_count"],
        ball_diameter=given["ball_diameter_mm"] * MILLI,
        pitch_diameter=given["pitch_diameter_mm"] * MILLI,
        contact_angle=np.radians(given["contact_angle_deg"]),
        inner_conformity=given["conformity"],
        outer_conformity=given["conformity"],
    )


@dataclass(frozen=True, slots=True)
class Ball:
    """One ball of the solved bearing; under thrust all are alike.

    velocity: seen from the cage, along x, the orbit and outward; orbit: of the cage; rad/s.
    """

    state: State
    speed: float
    orbit: float
    velocity: tuple[float, float, float]

    @property
    def ball_speed(self) -> float:
        """ω_R, negative: against the orbit; rad/s."""
        return -float(np.linalg.norm(self.velocity))

    @property
    def attitude(self) -> float:
        """β; rad."""
        return float(np.arcsin(-self.velocity[2] / self.ball_speed))

    @property
    def yaw(self) -> float:
        """β′; rad."""
        return float(np.arctan2(-self.velocity[1], -self.velocity[0]))

    def patch(self, race: Race) -> Patch:
        """The contact with a race, arrays of one."""
        contact, bearing = getattr(self.state.balls[0], race), self.state.case.bearing
        numbers = (
            contact.load,
            contact.contact_angle,
            contact.semi_major,
            contact.semi_minor,
            bearing.ball_diameter,
            bearing.pitch_diameter,
            getattr(bearing, f"{race}_conformity"),
        )
        return Patch(race, *(np.array([number]) for number in numbers))

    def motion(self, race: Race) -> RelativeMotion:
        """How the race moves relative to the ball, arrays of one."""
        ring = (self.speed if race == "inner" else 0.0) - self.orbit
        velocity = BallVelocity(*(np.array([part]) for part in self.velocity))
        return relative_motion(self.patch(race), velocity, np.array([ring]))

    def rolling_radius(self, race: Race) -> float:
        """r′ of (37), where ball and race would move alike on the normal; m."""
        motion = self.motion(race)
        return float(-motion.drift[0] / (motion.side * motion.roll[0]))

    def orbits(self, *, idle: bool = False, beta: Floats | None = None, yaw: float = 0.0) -> Orbits:
        """Equations 48 to 50 for this ball.

        idle: with rolling radii of D/2 and β′ = 0; beta: at other attitudes, with that yaw.
        """
        half = 0.5 * self.state.case.bearing.ball_diameter
        one = np.ones(1) if beta is None else np.ones_like(beta)
        inner, outer = self.patch("inner"), self.patch("outer")
        return Orbits(
            pitch_radius=0.5 * self.state.case.bearing.pitch_diameter * one,
            r_e=(half if idle else self.rolling_radius("outer")) * one,
            r_i=(half if idle else self.rolling_radius("inner")) * one,
            theta_e=outer.contact_angle * one,
            theta_i=inner.contact_angle * one,
            beta=self.attitude * one if beta is None else beta,
            yaw=(0.0 if idle else self.yaw) * one if beta is None else yaw * one,
            speed=self.speed * one,
        )


@cache
def ball(
    control: Control, speed_rpm: float | None = None, friction_coefficient: float | None = None
) -> Ball:
    """Solve the bearing and return a ball; speed and friction of figure 3.1 by default."""
    given = GIVEN.inputs_of("contacts")
    speed = RPM * (given["inner_speed_rpm"] if speed_rpm is None else speed_rpm)
    mu = given["friction_coefficient"] if friction_coefficient is None else friction_coefficient
    case = Case(
        bearing=bearing(),
        duty=Duty(inner_speed=speed, load=Load(fx=given["axial_load_kN"] * KILO)),
        model=Model(raceway_control=control),
        lubricant=Lubricant(kind="dry", friction_coefficient=mu),
    )
    state = solve(case)
    first = state.balls[0]
    if state.rolling is None:
        velocity = (
            first.ball_speed * np.cos(first.attitude),
            0.0,
            -first.ball_speed * np.sin(first.attitude),
        )
        return Ball(state, speed, first.orbital_speed, velocity)
    turning = state.rolling.balls[0].angular_velocity  # seen from the housing
    orbit = state.rolling.cage_speed
    return Ball(state, speed, orbit, (turning[0] - orbit, turning[1], turning[2]))
