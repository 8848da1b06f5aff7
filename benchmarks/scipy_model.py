"""The same equilibrium as a user would write it: NumPy over the balls, SciPy's root finder.

Written on its own, from docs/theory/equilibrium.md and not from the engine's kernels, so that
equal answers mean something. Outer raceway control, inner ring turning, one duty at a time. The
unknowns are the free displacements of the ring, then X1 and X2 of every ball as distances from
where the unloaded ball stands, in units of 10 µm; residuals are in units of the axial load.

It is meant to be fast: both contacts of all balls in one array, an exact Jacobian computed only
when it is asked for, and Hertz's stiffness as a polynomial in cos α, fitted once. With elliptic
integrals in every evaluation, or without the Jacobian, SciPy looks far worse.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import Polynomial
from numpy.typing import NDArray
from scipy.optimize import root

from rolamento import Bearing
from rolamento.contact.hertz import contact_stiffness, effective_modulus
from rolamento.geometry import Race, race_curvature, ring_geometry
from rolamento.kinematics import ball_mass

Floats = NDArray[np.float64]

LENGTH = 1e-5
"""m: the unit of the unknowns, about the size of the displacements."""
DEGREE = 6


@dataclass(slots=True)
class Evaluation:
    """What residual and Jacobian share; arrays over balls (Z), or (2, Z) for inner and outer."""

    unknowns: Floats
    sine: Floats
    cosine: Floats
    length: Floats
    load: Floats
    stiffness: Floats
    """dQ/dδ of each contact."""
    w: Floats
    """ω_m / ω_i."""
    sine_between: Floats
    """sin(α_i - α_o)."""
    one_plus_cosine: Floats
    gyroscopic: Floats
    """λ_o M_g / (D sin α_o)."""
    centrifugal: Floats


class ScipyBearing:
    """A bearing whose equilibrium `scipy.optimize.root` finds; tilts held, or moments given.

    Inside, tilts are multiplied by R_i and moments divided by it. `along[0]` and `along[1]`,
    each (free, Z), say how A1 and A2 of every ball follow the ring.
    """

    def __init__(self, bearing: Bearing, *, tilting: bool) -> None:
        ring = ring_geometry(bearing)
        self.balls = bearing.ball_count
        self.free = 5 if tilting else 3
        self.arms = np.array([1.0, 1.0, 1.0, *[ring.inner_groove_radius] * 2])
        self.free_length = np.array([[ring.inner_length], [ring.outer_length]])
        self.offset = np.array([ring.axial_offset, ring.radial_offset])
        self.gamma = bearing.ball_diameter / bearing.pitch_diameter
        mass = float(ball_mass(bearing.ball_diameter, bearing.ball_material.density))
        self.c_f = 0.5 * mass * bearing.pitch_diameter
        self.c_g = 0.1 * mass * bearing.pitch_diameter
        races = [stiffness_polynomial(bearing, race) for race in ("inner", "outer")]
        self.polynomial = np.stack(races, axis=1)[:, :, np.newaxis]  # (power, race, 1)
        azimuth = 2.0 * np.pi * np.arange(self.balls) / self.balls
        c, s = np.cos(azimuth), np.sin(azimuth)
        zero, one = np.zeros_like(c), np.ones_like(c)
        self.along = np.array([[one, zero, zero, c, -s], [zero, s, c, zero, zero]])[:, : self.free]
        share = ring.outer_length / ring.groove_centre_distance
        self.rest = (self.offset * share)[:, np.newaxis] * np.ones(self.balls)
        self.x1 = np.arange(self.free, self.free + self.balls)
        self.x2 = self.x1 + self.balls

    def unknowns(self, displacement: Floats, place: Floats) -> Floats:
        """The vector that `root` works on, of the ring (5) and the balls (2, Z); m, rad."""
        ring = (displacement * self.arms)[: self.free]
        return np.concatenate([ring, (place - self.rest).ravel()]) / LENGTH

    def displacement(self, unknowns: Floats) -> Floats:
        """The ring's x, y, z, and tilts times R_i, zero where held; (5), m."""
        ring = np.zeros(5)
        ring[: self.free] = unknowns[: self.free] * LENGTH
        return ring

    def static_guess(self, load: Floats) -> Floats:
        """A cold start: the ring as the axial load alone pushes it at rest and at the free angle.

        The balls stay on the line of groove centres. load: (5), N and N·m.
        """
        sine, cosine = self.offset / np.hypot(*self.offset)
        powers = cosine ** np.arange(DEGREE + 1)
        series = sum((powers @ self.polynomial[:, :, 0]) ** (-2.0 / 3.0)) ** -1.5
        approach = (abs(load[0]) / (self.balls * series * sine)) ** (2.0 / 3.0)
        displacement = np.array([approach / sine, 0.0, 0.0, 0.0, 0.0])
        inner_groove = self.offset + np.array([approach / sine, 0.0])
        share = self.free_length[1, 0] / self.free_length.sum()
        place = (inner_groove * share)[:, np.newaxis] * np.ones(self.balls)
        return self.unknowns(displacement, place)

    def evaluate(self, inner_speed: float, unknowns: Floats) -> Evaluation:
        """Contacts and inertia of all balls at the unknowns; inner_speed in rad/s."""
        moved = unknowns * LENGTH
        ring = moved[: self.free]
        y = np.empty((2, 2, self.balls))  # (component, race, ball): from ball to groove centre
        y[:, 1] = self.rest + moved[self.free :].reshape(2, self.balls)
        y[:, 0] = ring @ self.along + self.offset[:, np.newaxis] - y[:, 1]
        length = np.sqrt(y[0] * y[0] + y[1] * y[1])
        s, c = y / length
        k = self.polynomial[-1]
        for coefficient in self.polynomial[-2::-1]:
            k = k * c + coefficient
        # a groove is open toward its own ring's axis
        delta = np.where(c > 0.0, np.maximum(length - self.free_length, 0.0), 0.0)
        slope = k * np.sqrt(delta)

        one_plus_cosine = 1.0 + c[0] * c[1] + s[0] * s[1]
        w = (1.0 - self.gamma * c[0]) / one_plus_cosine
        square = (inner_speed * w) ** 2
        return Evaluation(
            unknowns=unknowns.copy(),
            sine=s,
            cosine=c,
            length=length,
            load=slope * delta,
            stiffness=1.5 * slope,
            w=w,
            sine_between=s[0] * c[1] - c[0] * s[1],
            one_plus_cosine=one_plus_cosine,
            gyroscopic=-2.0 * self.c_g * square,
            centrifugal=self.c_f * square,
        )

    def residual(self, load: Floats, at: Evaluation) -> Floats:
        """Unbalanced forces of ring and balls, over the axial load; load: (5), N and N·m."""
        n, z = self.free, self.balls
        (s_i, s_o), (c_i, c_o), (q_i, q_o) = at.sine, at.cosine, at.load
        f1, f2, friction = q_i * s_i, q_i * c_i, at.gyroscopic * s_o
        residual = np.empty(n + 2 * z)
        residual[:n] = self.along[0] @ f1 + self.along[1] @ f2 - (load / self.arms)[:n]
        residual[n : n + z] = f1 - q_o * s_o + friction * c_o
        residual[n + z :] = f2 - q_o * c_o - friction * s_o + at.centrifugal
        return residual / abs(load[0])

    def jacobian(self, load: Floats, at: Evaluation) -> Floats:
        """Derivative of `residual` by the unknowns.

        Only the small change of K with the angle is left out: it costs more than it saves.
        """
        n, x1, x2 = self.free, self.x1, self.x2
        (s_i, s_o), (c_i, c_o), (l_i, l_o) = at.sine, at.cosine, at.length
        across = at.load / at.length
        along_normal = at.stiffness - across
        spring11 = across + along_normal * at.sine**2
        spring12 = along_normal * at.sine * at.cosine
        spring22 = across + along_normal * at.cosine**2

        # F_c and the friction T = λ_o M_g / D go as w², T also as sin α_o
        relative_o = -2.0 * at.sine_between / at.one_plus_cosine
        relative_i = 2.0 * self.gamma * s_i / (at.w * at.one_plus_cosine) - relative_o
        f_c_i, f_c_o = at.centrifugal * relative_i, at.centrifugal * relative_o
        friction = at.gyroscopic * s_o
        t_i, t_o = friction * relative_i, friction * relative_o + at.gyroscopic * c_o

        p1, p2 = t_i * c_o / l_i, (f_c_i - t_i * s_o) / l_i
        y11, y12 = spring11[0] + p1 * c_i, spring12[0] - p1 * s_i
        y21, y22 = spring12[0] + p2 * c_i, spring22[0] - p2 * s_i
        o1 = (t_o * c_o - friction * s_o) / l_o
        o2 = (f_c_o - t_o * s_o - friction * c_o) / l_o

        jacobian = np.zeros((len(at.unknowns), len(at.unknowns)))
        jacobian[x1, x1] = o1 * c_o - spring11[1] - y11
        jacobian[x1, x2] = -o1 * s_o - spring12[1] - y12
        jacobian[x2, x1] = o2 * c_o - spring12[1] - y21
        jacobian[x2, x2] = -o2 * s_o - spring22[1] - y22
        b1, b2 = self.along
        jacobian[x1, :n] = (b1 * y11 + b2 * y12).T
        jacobian[x2, :n] = (b1 * y21 + b2 * y22).T
        k1 = b1 * spring11[0] + b2 * spring12[0]
        k2 = b1 * spring12[0] + b2 * spring22[0]
        jacobian[:n, :n] = k1 @ b1.T + k2 @ b2.T
        jacobian[:n, n : n + self.balls] = -k1
        jacobian[:n, n + self.balls :] = -k2
        return jacobian * (LENGTH / abs(load[0]))

    def solve(
        self,
        load: Floats,
        inner_speed: float,
        start: Floats,
        *,
        exact_jacobian: bool = True,
    ) -> tuple[bool, Floats]:
        """Find the equilibrium of one duty: (whether `root` says so, the unknowns).

        With the method "hybr" and its default tolerance. "lm" is slower, and from a cold start
        often stops at a place that is no equilibrium.
        """
        last = self.evaluate(inner_speed, start)

        def residual(unknowns: Floats) -> Floats:
            nonlocal last
            last = self.evaluate(inner_speed, unknowns)
            return self.residual(load, last)

        def jacobian(unknowns: Floats) -> Floats:
            same = np.array_equal(unknowns, last.unknowns)
            return self.jacobian(load, last if same else self.evaluate(inner_speed, unknowns))

        found = root(residual, start, jac=jacobian if exact_jacobian else None)
        return bool(found.success), found.x


def stiffness_polynomial(bearing: Bearing, race: Race) -> Floats:
    """Coefficients of the Hertz stiffness K(cos α) of a race, constant first; N/m^1.5."""
    conformity = bearing.inner_conformity if race == "inner" else bearing.outer_conformity
    cosines = np.linspace(0.0, 1.0, 2 * DEGREE + 1)
    curvature = race_curvature(
        bearing.ball_diameter, bearing.pitch_diameter, conformity, np.arccos(cosines), race
    )
    modulus = effective_modulus(bearing.ring_material, bearing.ball_material)
    stiffness = contact_stiffness(curvature.rolling, curvature.across, modulus)
    return np.asarray(Polynomial.fit(cosines, stiffness, DEGREE).convert().coef)


def load_of(duties: Mapping[str, Floats], case: int) -> Floats:
    """The five loads of a case of a duty set; N, N·m."""
    names = ("fx", "fy", "fz", "my", "mz")
    return np.array([duties[name][case] if name in duties else 0.0 for name in names])
