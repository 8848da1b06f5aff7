"""Four-point, thrust and self-aligning bearings against an equilibrium written out with SciPy.

Nothing of the mechanics is shared with the package: arcs, sphere and ring are put down in space
from the drawing, Hertz's contact comes from SciPy's elliptic integrals at every loaded angle, and
all balls and the ring are one system for `scipy.optimize.root`.
"""

from __future__ import annotations

from math import atan, cos, pi, radians, sin, sqrt
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import brentq, root
from scipy.special import ellipe, ellipk

from rolamento import Bearing, Case, Displacement, Duty, Load
from rolamento.solution import solve

Floats = NDArray[np.float64]

STEEL = {"youngs_modulus": 207e9, "poisson_ratio": 0.3, "density": 7810.0}


def stiffness(rolling: float, across: float) -> float:
    """K of Q = K δ^1.5 from the two relative curvatures; Johnson (1985), eqs. 4.22 to 4.26."""
    modulus = 2.0 * STEEL["youngs_modulus"] / 2.0 / (1.0 - STEEL["poisson_ratio"] ** 2)  # E'
    low, high = min(rolling, across), max(rolling, across)
    if high / low - 1.0 < 1e-9:  # a circle: δ = (9 Q² / (16 E*² R))^(1/3), E* = E'/2
        return 4.0 / 3.0 * 0.5 * modulus * sqrt(2.0 / (low + high))
    difference = (high - low) / (high + low)

    def excess(k: float) -> float:
        first, second = ellipk(1.0 - k**-2), ellipe(1.0 - k**-2)
        return ((k**2 + 1.0) * second - 2.0 * first) / ((k**2 - 1.0) * second) - difference

    k = brentq(excess, 1.0 + 1e-7, 1e3, xtol=1e-15)
    first, second = ellipk(1.0 - k**-2), ellipe(1.0 - k**-2)
    total = low + high
    # a³ = 6 k² E Q/(π Σ E'), δ = 3 K Q/(π a E')
    a = (6.0 * k**2 * second / (pi * total * modulus)) ** (1.0 / 3.0)
    return float((3.0 * first / (pi * a * modulus)) ** -1.5)


class Arc:
    """One arc of one ring: where its centre is in the plane of a ball, and what it answers."""

    def __init__(self, bearing: Bearing, side: float, radius: float, sphere: bool = False) -> None:
        self.side, self.radius, self.sphere = side, radius, sphere
        self.diameter, self.pitch = bearing.ball_diameter, bearing.pitch_diameter

    def force(self, centre: Floats, ball: Floats, toward: float) -> Floats:
        """On the ball, from an arc with this centre; toward: the sign of its own side along x."""
        stretch = ball - centre
        distance = float(np.hypot(*stretch))
        depth = distance + 0.5 * self.diameter - self.radius
        if depth <= 0.0 or (toward and toward * stretch[0] <= 0.0):
            return np.zeros(2)
        across = 2.0 / self.diameter - 1.0 / self.radius
        ratio = self.diameter / self.pitch * stretch[1] / distance  # γ with its sign
        rolling = across if self.sphere else 2.0 / self.diameter / (1.0 + ratio)
        return np.asarray(-stiffness(rolling, across) * depth**1.5 * stretch / distance)


def four_point(bearing: Bearing) -> list[tuple[Floats, Floats, float]]:
    """Centres of the outer and inner arcs of either side, at rest: (x, r) and the side."""
    shim = bearing.shim_angle or 0.0
    centres = []
    for side in (1.0, -1.0):
        reach = [
            (f - 0.5) * bearing.ball_diameter
            for f in (bearing.outer_conformity, bearing.inner_conformity)
        ]
        if bearing.contact_angle is not None:
            apart = sum(reach) * cos(bearing.contact_angle)
        else:
            apart = sum(reach) * cos(shim) - 0.5 * (bearing.diametral_clearance or 0.0)
        outer = np.array([-side * reach[0] * sin(shim), 0.0])
        inner = np.array([side * reach[1] * sin(shim), apart])
        centres.append((outer, inner, side))
    return centres


def balanced(
    case: Case, free: list[int], unknown: Floats, start: Floats, near: Floats | None = None
) -> Floats:
    """Ring displacements that balance the case; free: their places in the duty.

    near: where to begin. Every ball is then brought to rest by itself before all move together.
    """
    bearing, duty = case.bearing, case.duty
    count, diameter = bearing.ball_count, bearing.ball_diameter
    azimuth = duty.first_ball_azimuth + 2.0 * pi * np.arange(count) / count
    if bearing.kind == "four_point":
        sides = four_point(bearing)
        cosine = cos(bearing.row_angle)
    else:
        angle = bearing.contact_angle or 0.0
        length = (bearing.inner_conformity + bearing.outer_conformity - 1.0) * diameter
        inner_centre = np.array([length * sin(angle), length * cos(angle)])
        sides, cosine = [(np.zeros(2), inner_centre, 0.0)], cos(angle)
    inner = Arc(bearing, -1.0, bearing.inner_conformity * diameter)
    outer = Arc(bearing, 1.0, bearing.outer_conformity * diameter)
    orbit = 0.5 * duty.inner_speed * (1.0 - diameter / bearing.pitch_diameter * cosine)
    mass = STEEL["density"] * pi / 6.0 * diameter**3
    thrown = np.array([0.0, 0.5 * mass * bearing.pitch_diameter * orbit**2])
    load = np.array(duty.applied_load)
    arm = 0.5 * bearing.pitch_diameter + (bearing.inner_conformity - 0.5) * diameter * cosine

    def rest(u: Floats) -> Floats:
        place = np.array(duty.imposed_displacement, dtype=np.float64)
        place[free] = u[: len(free)] * unknown
        x, y, z, ry, rz = place
        balls = u[len(free) :].reshape(count, 2) * 1e-5 + start
        ring, out = np.zeros(5), []
        for psi, ball in zip(azimuth, balls, strict=True):
            shift = np.array(
                [x + arm * (ry * cos(psi) - rz * sin(psi)), z * cos(psi) + y * sin(psi)]
            )
            total = thrown.copy()
            for centre_o, centre_i, side in sides:
                from_outer = outer.force(centre_o, ball, side)
                from_inner = _inner_force(inner, centre_i + shift, ball, side)
                total += from_outer + from_inner
                f = from_inner
                ring += [
                    f[0], f[1] * sin(psi), f[1] * cos(psi), arm * f[0] * cos(psi),
                    -arm * f[0] * sin(psi),
                ]  # fmt: skip
            out.append(total)
        residual = (ring - load)[free] / np.where(np.array(free) > 2, arm, 1.0)
        return np.concatenate([residual, np.ravel(out)]) / 100.0

    begin = np.zeros(len(free) + 2 * count)
    if near is not None:
        begin[: len(free)] = near / unknown
        for j in range(count):
            mine = slice(len(free) + 2 * j, len(free) + 2 * j + 2)

            def alone(v: Floats, mine: slice = mine) -> Floats:
                u = begin.copy()
                u[mine] = v
                return rest(u)[mine]

            for first in np.array([[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [0.0, 3.0], [0.0, 6.0]]):
                one = root(alone, first, method="lm", tol=1e-12)
                if np.abs(one.fun).max() < 1e-9:
                    break
            begin[mine] = one.x
    found = root(rest, begin, method="hybr", tol=1e-13)
    for method in ("lm", "hybr"):
        if np.abs(found.fun).max() > 1e-9:
            found = root(rest, found.x, method=method, tol=1e-14)
    assert np.abs(found.fun).max() < 1e-8
    return np.asarray(found.x[: len(free)] * unknown)


def _inner_force(arc: Arc, centre: Floats, ball: Floats, side: float) -> Floats:
    """The force of an inner arc on the ball: away from the contact, toward the arc's centre."""
    stretch = centre - ball
    distance = float(np.hypot(*stretch))
    depth = distance + 0.5 * arc.diameter - arc.radius
    if depth <= 0.0 or (side and side * stretch[0] <= 0.0):
        return np.zeros(2)
    across = 2.0 / arc.diameter - 1.0 / arc.radius
    ratio = arc.diameter / arc.pitch * stretch[1] / distance
    rolling = 2.0 / arc.diameter / (1.0 - ratio)
    return np.asarray(stiffness(rolling, across) * depth**1.5 * stretch / distance)


QJ: dict[str, Any] = {
    "kind": "four_point",
    "ball_count": 9,
    "ball_diameter": 12.7e-3,
    "pitch_diameter": 70e-3,
    "shim_angle": radians(20.0),
    "inner_conformity": 0.52,
    "outer_conformity": 0.53,
    "ring_material": STEEL | {"name": "steel"},
}
THRUST: dict[str, Any] = {
    "kind": "thrust",
    "ball_count": 9,
    "ball_diameter": 9.525e-3,
    "pitch_diameter": 60e-3,
    "inner_conformity": 0.535,
    "outer_conformity": 0.54,
    "ring_material": STEEL | {"name": "steel"},
}


@pytest.mark.parametrize(
    ("play", "speed", "load"),
    [
        ({"contact_angle": radians(35.0)}, 0.0, {"fx": 3e3}),
        ({"contact_angle": radians(35.0)}, 600.0, {"fx": 3e3, "fz": 2e3}),
        ({"diametral_clearance": 20e-6}, 0.0, {"fx": 500.0, "fz": 4e3}),
        ({"diametral_clearance": -4e-6}, 900.0, {"fx": 200.0, "fz": 3e3}),
    ],
)
@pytest.mark.thirds
def test_four_point(play: dict[str, float], speed: float, load: dict[str, float]) -> None:
    bearing = Bearing(**QJ, **play)
    duty = Duty(inner_speed=speed, load=Load(**load), displacement=Displacement(y=0.0))
    case = Case(bearing=bearing, duty=duty)
    solved = solve(case)
    assert solved.converged[0]
    length = (0.5 * bearing.ball_diameter) * 0.04
    start = np.array([0.0, (bearing.outer_conformity - 0.5) * bearing.ball_diameter * 0.95])
    near = 1.01 * solved.displacement.array[0][[0, 2]]
    found = balanced(case, [0, 2], np.array([length, length]), start, near)
    np.testing.assert_allclose(
        [solved.displacement.x[0], solved.displacement.z[0]], found, rtol=2e-7, atol=1e-13
    )


@pytest.mark.parametrize(
    ("angle", "speed", "load"),
    [
        (90.0, 0.0, {"fx": 3e3, "fz": 150.0}),
        (90.0, 700.0, {"fx": 1e3, "my": 5.0}),
        (60.0, 400.0, {"fx": 3e3, "fz": 500.0, "my": 10.0}),
    ],
)
@pytest.mark.thirds
def test_thrust(angle: float, speed: float, load: dict[str, float]) -> None:
    bearing = Bearing(**THRUST, contact_angle=radians(angle))
    held = Displacement(y=0.0, rz=0.0, **({} if "my" in load else {"ry": 0.0}))
    case = Case(bearing=bearing, duty=Duty(inner_speed=speed, load=Load(**load), displacement=held))
    solved = solve(case)
    assert solved.converged[0]
    length = (bearing.outer_conformity - 0.5) * bearing.ball_diameter
    start = 1.005 * length * np.array([sin(radians(angle)), cos(radians(angle))])
    free = [0, 2, 3] if "my" in load else [0, 2]
    unknown = np.array([1e-5, 1e-5, 1e-4])[: len(free)]
    found = balanced(case, free, unknown, start)
    np.testing.assert_allclose(solved.displacement.array[0][free], found, rtol=3e-7, atol=1e-12)


def test_self_aligning_in_space() -> None:
    """The balls of both rows as springs toward the centre of the sphere, in three dimensions."""
    bearing = Bearing(
        kind="self_aligning", ball_count=10, ball_diameter=7.9e-3, pitch_diameter=39e-3,
        spacing=9e-3, diametral_clearance=12e-6, inner_conformity=0.52,
        ring_material=STEEL | {"name": "steel"},
    )  # fmt: skip
    tilt = Displacement(ry=0.02, rz=-0.01)
    case = Case(bearing=bearing, duty=Duty(load=Load(fx=150.0, fz=1500.0), displacement=tilt))
    solved = solve(case)
    assert solved.converged[0]
    diameter, pitch = bearing.ball_diameter, bearing.pitch_diameter
    angle = atan(9e-3 / 39e-3)
    sphere = 0.5 * pitch / cos(angle) + 0.5 * diameter
    inner = (bearing.inner_conformity - 0.5) * diameter
    across = 2.0 / diameter - 1.0 / sphere
    k_outer = stiffness(across, across)
    theta = np.array([0.0, 0.02, -0.01])
    cross = np.array(
        [[0.0, -theta[2], theta[1]], [theta[2], 0.0, -theta[0]], [-theta[1], theta[0], 0.0]]
    )
    size = np.linalg.norm(theta)
    turn = np.eye(3) + np.sin(size) / size * cross + (1 - np.cos(size)) / size**2 * cross @ cross

    def force(u: Floats) -> Floats:
        """On the ring: every ball on the line from its inner groove's centre to the middle."""
        total = np.zeros(3)
        for sign, phase in ((-1.0, 0.0), (1.0, pi / 10)):
            for psi in phase + 2.0 * pi * np.arange(10) / 10:
                out = np.array([0.0, sin(psi), cos(psi)])
                x = sign * (0.5 * pitch * np.tan(angle) + inner * sin(angle))
                radius = 0.5 * pitch + inner * cos(angle) - 6e-6
                centre = turn @ (np.array([x, 0, 0]) + radius * out) + u  # inner groove's
                distance = np.linalg.norm(centre)
                squeeze = distance - inner - (sphere - 0.5 * diameter)
                if squeeze <= 0.0:
                    continue
                # in the ring's own frame, the part of the normal that is radial gives γ
                own = turn.T @ centre
                ratio = diameter / pitch * float(own @ out) / distance
                groove = 2.0 / diameter - 1.0 / (bearing.inner_conformity * diameter)
                k_inner = stiffness(2.0 / diameter / (1.0 - ratio), groove)
                series = (k_inner ** (-2 / 3) + k_outer ** (-2 / 3)) ** -1.5
                total += series * squeeze**1.5 * centre / distance
        return np.asarray(total - np.array([150.0, 0.0, 1500.0]))

    found = root(lambda u: force(u * 1e-5) / 1e3, np.ones(3), tol=1e-13)
    assert np.abs(found.fun).max() < 1e-9
    # the package's balls stay in the radial planes of the ring: y/r is of second order
    np.testing.assert_allclose(
        solved.displacement.array[0][:3], found.x * 1e-5, rtol=2e-3, atol=2e-8
    )
    assert np.abs(solved.stiffness.array[0][3:]).max() == 0.0
