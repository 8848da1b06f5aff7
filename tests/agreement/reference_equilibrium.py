"""The Jones-Harris equilibrium written out plainly, to be compared with the package's own.

Nothing here is shared with `rolamento`: a case is only read. Hertz's contact comes from SciPy's
complete elliptic integrals at every loaded angle; at rest the ring is left to
`scipy.optimize.root`; from there the speed is raised step by step, all balls and the ring being
one system for Newton's method with a Jacobian by differences.

In the radial plane of a ball, (x, r) with r outward, the outer groove's centre is the origin,
the ball's at X and the inner groove's at A. A ball's orbit passes from the cage's, the mean of
the held balls' own, to its own as the inner ring presses on it (docs/theory/kinematics.md).
Sources: Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapter 8; Jones (1960); Radaelli
(2013), chapter 4, extended to both rings turning and to inner control by swapping the roles of
the races.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import root
from scipy.special import ellipe, ellipk

from rolamento import Case

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Contacts:
    """One race's contacts at the solution."""

    load: Floats
    angle: Floats
    deflection: Floats


@dataclass(frozen=True)
class Solution:
    displacement: Floats
    load: Floats
    inner: Contacts
    outer: Contacts
    centrifugal_force: Floats
    gyroscopic_moment: Floats
    orbital_speed: Floats
    error: float


def ellipticity(difference: Floats) -> Floats:
    """k = a/b from the relative difference of curvatures, by the secant method."""

    def excess(k: Floats) -> Floats:
        first, second = ellipk(1.0 - k**-2), ellipe(1.0 - k**-2)
        return ((k**2 + 1.0) * second - 2.0 * first) / ((k**2 - 1.0) * second) - difference

    before = 1.0339 * ((1.0 + difference) / (1.0 - difference)) ** 0.636
    k = 1.003 * before
    f_before = excess(before)
    for _ in range(12):
        f = excess(k)
        flat = f == f_before
        slope = np.where(flat, 1.0, (f - f_before) / np.where(flat, 1.0, k - before))
        before, f_before, k = k, f, k - np.where(flat, 0.0, f / slope)
        if np.abs(k - before).max() < 1e-9 * k.max():  # the next step's error is its square
            break
    return k


def hertz_stiffness(rolling: Floats, across: float, modulus: float) -> Floats:
    """K of Q = K δ^1.5 from the principal curvature sums; modulus: E'."""
    total = rolling + across
    k = ellipticity(np.abs(rolling - across) / total)
    first, second = ellipk(1.0 - k**-2), ellipe(1.0 - k**-2)
    semi_major = np.cbrt(6.0 * k**2 * second / (np.pi * total * modulus))  # at Q = 1
    approach = 3.0 * first / (np.pi * semi_major * modulus)
    return np.asarray(approach**-1.5)


class Bearing:
    """A bearing, its duty and its model, as plain numbers."""

    def __init__(self, case: Case) -> None:
        bearing, duty, model = case.bearing, case.duty, case.model
        self.balls = bearing.ball_count
        self.d, self.pitch = bearing.ball_diameter, bearing.pitch_diameter
        self.fi, self.fo = bearing.inner_conformity, bearing.outer_conformity
        ring, ball = bearing.ring_material, bearing.ball_material
        compliances = [(1.0 - m.poisson_ratio**2) / m.youngs_modulus for m in (ring, ball)]
        self.modulus = 2.0 / sum(compliances)
        self.mass = ball.density * np.pi * self.d**3 / 6.0
        self.li, self.lo = (self.fi - 0.5) * self.d, (self.fo - 0.5) * self.d
        distance = self.li + self.lo
        if bearing.contact_angle is not None:
            angle = bearing.contact_angle
            self.a10, self.a20 = distance * np.sin(angle), distance * np.cos(angle)
        else:
            assert bearing.diametral_clearance is not None
            angle = np.arccos(min(1.0, 1.0 - bearing.diametral_clearance / (2.0 * distance)))
            self.a10, self.a20 = 0.0, distance - bearing.diametral_clearance / 2.0
        self.free_angle = angle
        self.arm = self.pitch / 2.0 + self.li * np.cos(angle)
        self.psi = duty.first_ball_azimuth + 2.0 * np.pi * np.arange(self.balls) / self.balls
        self.speeds = np.array([duty.inner_speed, duty.outer_speed])
        self.free = np.array(duty.free)
        self.applied = np.array(duty.applied_load)
        self.imposed = np.array(duty.imposed_displacement)
        self.control = model.raceway_control
        self.has_force, self.has_moment = model.centrifugal_force, model.gyroscopic_moment
        self.lambda_i = {"outer": 0.0, "inner": 2.0, "none": 1.0}[self.control]
        self.cage = model.cage

    def groove(self, u: Floats) -> tuple[Floats, Floats]:
        x, y, z, ry, rz = u
        c, s = np.cos(self.psi), np.sin(self.psi)
        return self.a10 + x + self.arm * (ry * c - rz * s), self.a20 + z * c + y * s

    def stiffness(self, angle: Floats, inner: bool) -> Floats:
        gamma = self.d * np.cos(angle) / self.pitch
        rolling = 2.0 / self.d / (1.0 - gamma if inner else 1.0 + gamma)
        across = 2.0 / self.d - 1.0 / ((self.fi if inner else self.fo) * self.d)
        return hertz_stiffness(rolling, across, self.modulus)

    def contact(self, v1: Floats, v2: Floats, inner: bool) -> Contacts:
        up = np.maximum(v2, 0.0)  # a groove is open toward its own ring's axis
        angle, length = np.arctan2(v1, up), np.hypot(v1, up)
        deflection = np.maximum(length - (self.li if inner else self.lo), 0.0)
        return Contacts(self.stiffness(angle, inner) * deflection**1.5, angle, deflection)

    def inertia(
        self, ai: Floats, ao: Floats, qi: Floats, speeds: Floats
    ) -> tuple[Floats, Floats, Floats]:
        """F_c, signed M_g, and ω_m."""
        gamma = self.d / self.pitch
        wi, wo = speeds
        divisor = 1.0 + np.cos(ai - ao)
        if self.control == "inner":
            share_i = (np.cos(ai - ao) - gamma * np.cos(ao)) / divisor
            share_o = (1.0 + gamma * np.cos(ao)) / divisor
        else:
            share_i = (1.0 - gamma * np.cos(ai)) / divisor
            share_o = (np.cos(ai - ao) + gamma * np.cos(ai)) / divisor
        own = share_i * wi + share_o * wo

        free = np.cos(self.free_angle) * gamma
        idle = 0.5 * (wi * (1.0 - free) + wo * (1.0 + free))
        firm = 0.5 * self.mass * self.pitch * max(abs(idle), 0.25 * (abs(wi) + abs(wo))) ** 2
        grip = np.clip(qi / (0.8 * firm), 0.0, 1.0) if firm > 0.0 else np.ones_like(qi)
        hold = np.ones_like(qi) if self.cage == "none" else grip**2 * (3.0 - 2.0 * grip)
        cage = (np.sum(hold * qi * own) + 1e-2 * firm * idle) / (np.sum(hold * qi) + 1e-2 * firm)
        orbit = cage + (self.cage != "rigid") * hold * (own - cage)

        # the radial part of the ball's ω, rolling on the race in control as far as that holds it
        if self.control == "inner":
            outward = -hold * (orbit - wi) / gamma * np.sin(ai)
        else:
            outward = -(wo - orbit) / gamma * np.sin(ao)
        force = 0.5 * self.mass * self.pitch * orbit**2 * self.has_force
        polar = self.mass * self.d**2 / 10.0
        return force, -polar * orbit * outward * self.has_moment, orbit

    def ring_load(self, inner: Contacts, moment: Floats) -> Floats:
        """What the shaft must put on the ring."""
        c, s = np.cos(self.psi), np.sin(self.psi)
        t = self.lambda_i * moment / self.d
        axial = inner.load * np.sin(inner.angle) - t * np.cos(inner.angle)
        radial = inner.load * np.cos(inner.angle) + t * np.sin(inner.angle)
        tilting = self.arm * axial + self.lambda_i * self.fi * moment
        return np.array(
            [
                axial.sum(),
                (radial * s).sum(),
                (radial * c).sum(),
                (tilting * c).sum(),
                -(tilting * s).sum(),
            ]
        )

    @property
    def load_scale(self) -> Floats:
        force = max(np.abs(self.applied[:3]).max(), np.abs(self.applied[3:]).max() / self.arm, 1.0)
        return np.array([force, force, force, force * self.arm, force * self.arm])


def solve_at_rest(bearing: Bearing) -> tuple[Floats, Contacts, Contacts]:
    """Displacement and contacts without inertia: every ball on the line of the groove centres."""
    scale = bearing.d * np.array([1.0, 1.0, 1.0, 1.0 / bearing.arm, 1.0 / bearing.arm]) * 1e-3
    free = bearing.free

    def contacts(u: Floats) -> tuple[Contacts, Contacts]:
        a1, a2 = bearing.groove(u)
        angle = np.arctan2(a1, a2)
        ki, ko = bearing.stiffness(angle, True), bearing.stiffness(angle, False)
        approach = np.maximum(np.hypot(a1, a2) - bearing.li - bearing.lo, 0.0)
        load = (approach / (ki ** (-2 / 3) + ko ** (-2 / 3))) ** 1.5
        return (
            Contacts(load, angle, (load / ki) ** (2 / 3)),
            Contacts(load, angle, (load / ko) ** (2 / 3)),
        )

    def displaced(v: Floats) -> Floats:
        u = bearing.imposed.copy()
        u[free] = v * scale[free]
        return u

    def unbalanced(v: Floats) -> Any:
        inner, _ = contacts(displaced(v))
        load = bearing.ring_load(inner, np.zeros(bearing.balls))
        return ((load - bearing.applied) / bearing.load_scale)[free]

    direction = bearing.applied / bearing.load_scale
    best, least = np.zeros(int(free.sum())), np.inf
    for push in (1.0, 3.0, 8.0, 20.0, 0.3):
        start = (push * direction)[free]
        if bearing.a10 == 0.0:
            start = start + (bearing.lo + bearing.li - bearing.a20) / scale[0] * direction[free]
        found = root(unbalanced, start, method="hybr", options={"xtol": 1e-14})
        error = float(np.abs(unbalanced(found.x)).max()) if len(found.x) else 0.0
        if error < least:
            best, least = found.x, error
        if least < 1e-9:
            break
    assert least < 1e-9, least
    u = displaced(best)
    return u, *contacts(u)


def solve_reference(case: Case) -> Solution:
    """Solve a case, raising the speeds from rest as fast as every step converges."""
    bearing = Bearing(case)
    u, inner, outer = solve_at_rest(bearing)
    if not bearing.speeds.any() or not (bearing.has_force or bearing.has_moment):
        zero = np.zeros(bearing.balls)
        orbit = bearing.inertia(inner.angle, outer.angle, inner.load, bearing.speeds)[2]
        return Solution(u, bearing.ring_load(inner, zero), inner, outer, zero, zero, orbit, 0.0)

    free = bearing.free
    unit = bearing.lo * np.array([1.0, 1.0, 1.0, 1.0 / bearing.arm, 1.0 / bearing.arm])
    count = int(free.sum())

    def parts(v: Floats, share: float) -> tuple[Any, ...]:
        u = bearing.imposed.copy()
        u[free] = v[:count] * unit[free]
        x1, x2 = v[count:].reshape(2, -1) * bearing.lo
        a1, a2 = bearing.groove(u)
        inner = bearing.contact(a1 - x1, a2 - x2, True)
        outer = bearing.contact(x1, x2, False)
        inertia = bearing.inertia(inner.angle, outer.angle, inner.load, share * bearing.speeds)
        return u, inner, outer, *inertia

    def unbalanced(v: Floats, share: float, ball_scale: Floats) -> Floats:
        _, inner, outer, force, moment, _ = parts(v, share)
        t = moment / bearing.d
        li, lo = bearing.lambda_i, 2.0 - bearing.lambda_i
        si, ci, so, co = (f(c.angle) for c in (inner, outer) for f in (np.sin, np.cos))
        axial = inner.load * si - outer.load * so - t * (li * ci - lo * co)
        radial = inner.load * ci - outer.load * co + t * (li * si - lo * so) + force
        ring = (bearing.ring_load(inner, moment) - bearing.applied) / bearing.load_scale
        return np.concatenate([ring[free], axial / ball_scale, radial / ball_scale])

    def thrown(share: float) -> tuple[Floats, Floats]:
        """Centrifugal force of a ball at the bottom of its groove, and how far it throws it."""
        zero = np.zeros(bearing.balls)
        force = bearing.inertia(zero, zero, zero, share * bearing.speeds)[0]
        ko = bearing.stiffness(zero, False)
        return force, bearing.lo + (force / ko) ** (2 / 3)

    def start(share: float) -> Floats:
        """The ring as at rest; balls without load there go to the least energy under F_c."""
        a1, a2 = bearing.groove(u)
        x1, x2 = ((bearing.lo + outer.deflection) * f(outer.angle) for f in (np.sin, np.cos))
        y1, y2 = least_energy(a1, a2, thrown(share)[0])
        loaded = inner.load > 0.0
        x1, x2 = np.where(loaded, x1, y1), np.where(loaded, x2, y2)
        return np.concatenate([(u / unit)[free], x1 / bearing.lo, x2 / bearing.lo])

    def least_energy(a1: Floats, a2: Floats, force: Floats) -> tuple[Floats, Floats]:
        """Places of balls that only a force presses outward between fixed grooves.

        By halving: the outer angle between the radial direction and the line of the groove
        centres, and for each the distance at which the forces along the normal balance.
        """
        zero = np.zeros(bearing.balls)
        ki, ko = bearing.stiffness(zero, True), bearing.stiffness(zero, False)
        side = np.where(a1 < 0.0, -1.0, 1.0)

        def forces(alpha: Floats, reach: Floats) -> tuple[Floats, Floats]:
            """Along the outer normal and across it, toward the line of centres."""
            s, c = np.sin(alpha), np.cos(alpha)
            y1, y2 = side * a1 - reach * s, a2 - reach * c
            length = np.hypot(y1, y2)
            pull = ki * np.maximum(length - bearing.li, 0.0) ** 1.5 / length
            push = ko * np.maximum(reach - bearing.lo, 0.0) ** 1.5
            along = pull * (y1 * s + y2 * c) - push + force * c
            return along, pull * (y1 * c - y2 * s) - force * s

        low, high = zero, np.arctan2(side * a1, a2)
        for _ in range(50):
            alpha = 0.5 * (low + high)
            least, most = np.full_like(zero, bearing.lo), np.full_like(zero, 1.5 * bearing.lo)
            for _ in range(50):
                reach = 0.5 * (least + most)
                outward = forces(alpha, reach)[0] > 0.0
                least, most = np.where(outward, reach, least), np.where(outward, most, reach)
            rising = forces(alpha, least)[1] > 0.0
            low, high = np.where(rising, alpha, low), np.where(rising, high, alpha)
        return side * least * np.sin(alpha), least * np.cos(alpha)

    def newton(v: Floats, share: float, loads: Floats) -> tuple[Floats, float]:
        """Newton's method with differences for derivatives, and shortened steps."""
        scale = np.maximum(loads, thrown(share)[0]) + 1e-9
        value = unbalanced(v, share, scale)
        for _ in range(25):
            jacobian = np.empty((len(v), len(v)))
            for column in range(len(v)):
                h = np.zeros(len(v))
                h[column] = 1e-9
                jacobian[:, column] = (unbalanced(v + h, share, scale) - value) / 1e-9
            try:
                step = -np.linalg.solve(jacobian, value)
            except np.linalg.LinAlgError:
                break
            for part in 0.5 ** np.arange(8):
                trial = unbalanced(v + part * step, share, scale)
                if np.linalg.norm(trial) < np.linalg.norm(value):
                    break
            else:
                break
            v, value = v + part * step, trial
            if np.abs(part * step).max() < 1e-13:
                break
        return v, float(np.abs(value).max())

    share, stride, loads, v, error = 0.0, 0.34, outer.load, np.empty(0), np.inf
    while share < 1.0:
        ahead = min(share + stride, 1.0)
        trial, error = newton(v if share else start(ahead), ahead, loads)
        x1, x2 = trial[count:].reshape(2, -1)
        side = np.sign(bearing.groove(parts(trial, ahead)[0])[0])
        if error < 1e-9 and (side * x1 >= -1e-9).all() and (x2 > 0.0).all():
            v, share, stride = trial, ahead, 1.5 * stride
            loads = parts(v, share)[2].load
        else:
            stride *= 0.4
            assert stride > 1e-4, (case.title, share, error)
    u, inner, outer, force, moment, orbit = parts(v, 1.0)
    load = bearing.ring_load(inner, moment)
    return Solution(u, load, inner, outer, force, moment, orbit, error)
