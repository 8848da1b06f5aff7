"""Balls that friction controls, as an engineer would write it: NumPy arrays and `scipy.optimize`.

Nothing of the engine's: vectors in space and cross products instead of formulas in components,
polar nodes on the ellipse, Hertz's contact from SciPy's elliptic integrals, all unknowns of ring,
cage and balls in one system, its derivatives by differences.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq, root
from scipy.special import ellipe, ellipk

from rolamento import Bearing

Floats = NDArray[np.float64]
X_AXIS = np.array([1.0, 0.0, 0.0])


@dataclass(frozen=True, slots=True)
class Duty:
    """Loads fx, fy, fz (N) and my, mz (N·m) where free, else the displacements; speeds in rad/s."""

    load: Floats
    displacement: Floats
    free: NDArray[np.bool_]
    inner_speed: float
    outer_speed: float
    friction: float
    drag: float = 0.0


@dataclass(frozen=True, slots=True)
class Found:
    """A solution: ring (5,), cage, the balls' places (balls, 2) and speeds (balls, 3)."""

    success: bool
    ring: Floats
    cage: float
    places: Floats
    speeds: Floats
    power: float
    torque: float


class FrictionModel:
    """One bearing with nodes on its ellipses; a ball's speed is (x, y, z) in space."""

    def __init__(self, bearing: Bearing, radial: int, round_: int) -> None:
        self.count, self.d = bearing.ball_count, bearing.ball_diameter
        self.pitch = bearing.pitch_diameter
        angle = bearing.contact_angle
        assert angle is not None
        self.conformity = np.array([bearing.inner_conformity, bearing.outer_conformity])
        self.offset = (self.conformity - 0.5) * self.d
        self.between = self.offset.sum() * np.array([np.sin(angle), np.cos(angle)])
        self.ring_radius = 0.5 * self.pitch + self.offset[0] * np.cos(angle)
        steel, ball = bearing.ring_material, bearing.ball_material
        parts = [(1.0 - m.poisson_ratio**2) / m.youngs_modulus for m in (steel, ball)]
        self.modulus = 2.0 / sum(parts)
        self.mass = ball.density * np.pi * self.d**3 / 6.0
        self.inertia = 0.1 * self.mass * self.d**2
        azimuth = 2.0 * np.pi * np.arange(self.count) / self.count
        zero = np.zeros_like(azimuth)
        self.cos, self.sin = np.cos(azimuth), np.sin(azimuth)
        self.outward = np.stack([zero, self.sin, self.cos], axis=1)
        self.along = np.stack([zero, self.cos, -self.sin], axis=1)
        # p dA = 3Q/(2π) √(1-r²) r dr dθ, with s² = 1-r²: s² ds dθ
        s, weight = np.polynomial.legendre.leggauss(radial)
        s, weight = 0.5 * (1.0 + s), 0.5 * weight
        theta = 2.0 * np.pi * (np.arange(round_) + 0.5) / round_
        r = np.sqrt(1.0 - s**2)
        self.nodes = np.stack([np.outer(r, np.cos(theta)), np.outer(r, np.sin(theta))]).reshape(
            2, -1
        )
        self.weights = np.repeat(3.0 * weight * s**2 / round_, round_)
        self._shapes = [self._shape_table(race) for race in (0, 1)]

    def _shape_table(self, race: int) -> Floats:
        """Polynomials in cos α of K, a/Q^(1/3), b/Q^(1/3), through exact values; (3, 9)."""
        cosines = 0.5 + 0.5 * np.cos(np.pi * (np.arange(9) + 0.5) / 9)
        values = np.array([self._hertz(float(c), race) for c in cosines])
        return np.linalg.solve(np.vander(cosines), values).T

    def _hertz(self, cosine: float, race: int) -> tuple[float, float, float]:
        """K of Q = K δ^(3/2), a/Q^(1/3) and b/Q^(1/3), of one race at one angle."""
        gamma = self.d * cosine / self.pitch
        rolling = 2.0 / self.d / (1.0 - gamma if race == 0 else 1.0 + gamma)
        across = 2.0 / self.d - 1.0 / (self.conformity[race] * self.d)
        total, difference = rolling + across, rolling - across

        def excess(log_ratio: float) -> float:
            k2 = np.exp(2.0 * log_ratio)
            first, second = ellipk(1.0 - 1.0 / k2), ellipe(1.0 - 1.0 / k2)
            share = ((k2 + 1.0) * second - 2.0 * first) / ((k2 - 1.0) * second)
            return float(share - difference / total)

        k = float(np.exp(brentq(excess, 1e-3, 6.0, xtol=1e-14)))
        first, second = ellipk(1.0 - 1.0 / k**2), ellipe(1.0 - 1.0 / k**2)
        a = (6.0 * k**2 * second / (np.pi * total * self.modulus)) ** (1.0 / 3.0)
        approach = first * (4.5 * total / second / (np.pi * k * self.modulus) ** 2) ** (1.0 / 3.0)
        return float(approach**-1.5), float(a), float(a / k)

    def contact(
        self, race: int, vector: Floats, spin: Floats, cage: float, duty: Duty, v0: float
    ) -> tuple[Floats, Floats, Floats]:
        """Force and moment of a race on every ball, (balls, 3), and the power lost, (balls,).

        vector: between the centres of groove and ball, (balls, 2); spin: ω_b, (balls, 3).
        """
        side, speed = ((-1.0, duty.inner_speed), (1.0, duty.outer_speed))[race]
        length = np.hypot(*vector.T)
        sine, cosine = vector.T / length
        stiffness, a, b = (np.polyval(p, cosine) for p in self._shapes[race])
        load = stiffness * np.maximum(length - self.offset[race], 0.0) ** 1.5
        a, b = a * np.cbrt(load), b * np.cbrt(load)
        a = np.minimum(a, 0.4 * self.d)  # where a solver strays
        normal = sine[:, None] * X_AXIS + cosine[:, None] * self.outward
        tangent = cosine[:, None] * X_AXIS - sine[:, None] * self.outward
        radius = 2.0 * self.conformity[race] * self.d / (2.0 * self.conformity[race] + 1.0)
        x, y = a[:, None] * self.nodes[0], b[:, None] * self.nodes[1]
        lift = np.sqrt(0.25 * self.d**2 - a**2) - np.sqrt(radius**2 - a**2)
        height = side * (np.sqrt(radius**2 - x**2) + lift[:, None])
        place = (
            height[..., None] * normal[:, None]
            + x[..., None] * tangent[:, None]
            + y[..., None] * self.along[:, None]
        )
        ball = np.cross((spin - cage * X_AXIS)[:, None], place)
        centre = 0.5 * self.pitch * self.outward[:, None]
        ring = np.cross((speed - cage) * X_AXIS, centre + place)
        slip = ball - ring
        slip -= np.sum(slip * normal[:, None], axis=2, keepdims=True) * normal[:, None]
        size = np.sqrt(np.sum(slip**2, axis=2) + v0**2)
        part = -duty.friction * load[:, None] * self.weights / size
        friction = part[..., None] * slip
        force = friction.sum(axis=1) - side * load[:, None] * normal
        return force, np.cross(place, friction).sum(axis=1), -np.sum(friction * slip, axis=(1, 2))

    def grooves(self, ring: Floats) -> Floats:
        """The inner groove's centre at every ball, from the outer's; (balls, 2)."""
        x, y, z, ry, rz = ring
        axial = self.between[0] + x + self.ring_radius * (ry * self.cos - rz * self.sin)
        return np.stack([axial, self.between[1] + z * self.cos + y * self.sin], axis=1)

    def balance(
        self, ring: Floats, cage: float, places: Floats, spin: Floats, duty: Duty, v0: float
    ) -> tuple[Floats, Floats, Floats, float, float, float]:
        """What is left of the balls' forces, moments, of ring and cage; power, inner torque."""
        y = self.grooves(ring) - places
        force_i, moment_i, power_i = self.contact(0, y, spin, cage, duty, v0)
        force_o, moment_o, power_o = self.contact(1, places, spin, cage, duty, v0)
        centrifugal = 0.5 * self.mass * self.pitch * cage**2
        forces = force_i + force_o + centrifugal * self.outward
        moments = moment_i + moment_o - self.inertia * np.cross(cage * X_AXIS, spin)
        along = np.sum(forces * self.along)
        arm = (self.ring_radius - y[:, 1])[:, None] * self.outward - y[:, :1] * X_AXIS
        turning = (np.cross(arm, force_i) + moment_i).sum(axis=0)
        total = np.concatenate([force_i.sum(axis=0), turning[1:]])
        about = np.cross(0.5 * self.pitch * self.outward, force_i) + moment_i
        rest = along + np.sign(cage) * duty.drag / (0.5 * self.pitch)
        power = float(power_i.sum() + power_o.sum())
        return forces, moments, total, float(rest), power, float(about[:, 0].sum())

    def solve(self, duty: Duty, start: Found, smoothing: list[float]) -> Found:
        """Solve by `scipy.optimize.root`, at one smoothing after another: v0 over |ω_i - ω_o| D."""
        relative = abs(duty.inner_speed - duty.outer_speed)
        scale = max(float(np.abs(duty.load).max()), 1.0)
        n = self.count
        free = np.flatnonzero(duty.free)
        sizes = np.concatenate(
            [
                np.where(free < 3, 1e-5, 1e-4),
                [relative],
                np.full(2 * n, 1e-5),
                np.full(3 * n, relative * self.pitch / self.d),
            ]
        )

        def parts(unknowns: Floats) -> tuple[Floats, float, Floats, Floats]:
            values = unknowns * sizes
            ring = duty.displacement.copy()
            ring[free] = values[: free.size]
            rest = values[free.size + 1 :]
            return ring, values[free.size], rest[: 2 * n].reshape(n, 2), rest[2 * n :].reshape(n, 3)

        def residual(unknowns: Floats, v0: float) -> Floats:
            ring, cage, places, spin = parts(unknowns)
            forces, moments, total, along, *_ = self.balance(ring, cage, places, spin, duty, v0)
            grip = duty.friction * scale
            missing = (total - duty.load) / (scale * np.where(np.arange(5) < 3, 1.0, self.pitch))
            plane = np.stack([forces @ X_AXIS, np.sum(forces * self.outward, axis=1)], axis=1)
            return np.concatenate(
                [
                    missing[free],
                    [along / grip],
                    n * plane.ravel() / scale,
                    n * moments.ravel() / (grip * self.d),
                ]
            )

        unknowns = np.concatenate(
            [start.ring[free], [start.cage], start.places.ravel(), start.speeds.ravel()]
        )
        unknowns /= sizes
        success, v0 = False, 0.0
        for part in smoothing:
            v0 = part * relative * self.d
            found = root(
                residual,
                unknowns,
                args=(v0,),
                method="hybr",
                options={"xtol": 1e-12, "factor": 1.0},
            )
            unknowns = found.x
            success = bool(np.abs(found.fun).max() < 1e-7)
        ring, cage, places, spin = parts(unknowns)
        *_, power, torque = self.balance(ring, cage, places, spin, duty, v0)
        return Found(success, ring, cage, places, spin, power, torque)
