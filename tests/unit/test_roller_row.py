"""Rows of rollers: balance of every roller, of the ring, and their limits."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import root

from rolamento.assembly.cases import spread
from rolamento.case import Case
from rolamento.rows.roller import layout
from rolamento.rows.roller.row import RollerRow
from rolamento.solution import solve

Array = NDArray[np.float64]

NU205: dict[str, Any] = {
    "element": "cylindrical",
    "roller_count": 13,
    "roller_diameter": "7.5 mm",
    "effective_length": "9 mm",
    "pitch_diameter": "38.5 mm",
    "diametral_clearance": "0.03 mm",
}
TAPERED: dict[str, Any] = {
    "element": "tapered",
    "roller_count": 17,
    "roller_diameter": "7 mm",
    "effective_length": "11 mm",
    "roller_length": "12 mm",
    "pitch_diameter": "42 mm",
    "contact_angle": "15 deg",
    "roller_half_angle": "2.08 deg",
}


def case_of(bearing: dict[str, Any], **parts: Any) -> Case:
    return Case.model_validate({"bearing": bearing, **parts})


def row_of(case: Case) -> RollerRow:
    row = spread(case).rows[0].row
    assert isinstance(row, RollerRow)
    return row


def held_at(row: RollerRow, place: Array) -> Any:
    return row.held(place[np.newaxis], np.array([0]), np.ones((1, row.element_count)))


# --- an independent roller: points and normals in the plane, nothing eliminated --------------------


@dataclass
class Roller:
    """A roller in its plane with three displacements of its own, and the rib's force."""

    row: RollerRow

    def __post_init__(self) -> None:
        n, p = self.row.numbers, self.row.numbers.p[:, 0]
        beta, half = n.axis[0], n.half_angle[0]
        self.pitch, self.radius = p[layout.ARM], 0.5 * p[layout.DIAMETER]
        self.along = np.array([np.cos(beta), -np.sin(beta)])
        self.normal = np.array([np.sin(beta), np.cos(beta)])
        self.place, self.drops = n.cut.place[0], n.cut.drops[0]
        self.inner, self.outer = (
            np.array([np.sin(a), np.cos(a)]) for a in (beta - half, beta + half)
        )
        self.inner_points = -self.radius * self.normal + np.outer(
            self.place, [self.inner[1], -self.inner[0]]
        )
        self.outer_points = self.radius * self.normal + np.outer(
            self.place, [self.outer[1], -self.outer[0]]
        )
        self.constant = p[layout.OUTER_CONSTANT] / self.place.size
        self.gap = p[layout.GAP]
        self.centrifugal, self.moment = p[layout.CENTRIFUGAL], p[layout.GYROSCOPIC]
        self.tapered = n.tapered

    def rib(self, length: float, height: float, sphere: float, half: float) -> None:
        """Where the rib touches, and its normal: toward the middle of the spherical end."""
        below = self.radius + 0.5 * length * np.tan(half) - height
        self.touch = -0.5 * length * self.along - below * self.normal
        # the end's vertex is taken where the contact is: its sag is left out
        sine = below / sphere
        self.push = np.sqrt(1.0 - sine**2) * self.along + sine * self.normal

    def loads(self, ring: Array, own: Array) -> tuple[Array, Array]:
        """Q of the slices, inner and outer; ring, own: displacement at the centre, and tilt."""
        relative = ring - own
        inner = moved(relative, self.inner_points) @ self.inner - self.drops[0] - self.gap
        outer = moved(own, self.outer_points) @ self.outer - self.drops[1] - self.gap
        return tuple(self.constant * np.maximum(d, 0.0) ** (10 / 9) for d in (inner, outer))

    def balance(self, ring: Array, own: Array, rib: float) -> Array:
        """What is unbalanced: force along x and r, and moment about the centre."""
        inner, outer = self.loads(ring, own)
        force = inner.sum() * self.inner - outer.sum() * self.outer + [0.0, self.centrifugal]
        moment = moments(inner, self.inner, self.inner_points) + self.moment
        moment -= moments(outer, self.outer, self.outer_points)
        if self.tapered:
            force = force + rib * self.push
            moment += turning(rib * self.push, self.touch)
        return np.array([*force, moment])

    def on_ring(self, ring: Array, own: Array, rib: float) -> Array:
        """Force and moment about the bearing's axis of the ring on the roller."""
        inner, _ = self.loads(ring, own)
        force = inner.sum() * self.inner
        moment = moments(inner, self.inner, self.inner_points)
        if self.tapered:
            force = force + rib * self.push
            moment += turning(rib * self.push, self.touch)
        return np.array([*force, moment + force[0] * self.pitch])


def moved(place: Array, points: Array) -> Array:
    """Displacement of points of a body that moves by (x, r) and turns by θ."""
    turn = np.stack([points[..., 1], -points[..., 0]], axis=-1)
    return np.asarray(place[:2] + place[2] * turn)


def turning(force: Array, at: Array) -> float:
    return float(force[0] * at[1] - force[1] * at[0])


def moments(loads: Array, normal: Array, points: Array) -> float:
    return float(sum(turning(q * normal, at) for q, at in zip(loads, points, strict=True)))


def ring_at(roller: Roller, u: Array, azimuth: float) -> Array:
    c, s = np.cos(azimuth), np.sin(azimuth)
    tilt = u[3] * c - u[4] * s
    return np.array([u[0] + roller.pitch * tilt, u[1] * s + u[2] * c, tilt])


def own_of(row: RollerRow, roller: Roller, ring: Array, state: Array) -> Array:
    """The roller's displacement from η and ω over the ring."""
    epsilon, arm = row.numbers.rib_angle[0], row.numbers.rib_arm[0]
    f = np.cos(epsilon) * roller.along + np.sin(epsilon) * roller.normal
    across = np.array([-f[1], f[0]])
    shift = state[0] * across - (state[1] * arm * f if roller.tapered else 0.0)
    return np.array([*(ring[:2] + shift), ring[2] + state[1]])


CASES = {
    "cylindrical": (NU205, [0.0, 4e-6, 31e-6, 2e-3, -1e-3], "0 rpm"),
    "fast": (NU205, [0.0, 4e-6, 31e-6, 2e-3, -1e-3], "12000 rpm"),
    "interference": (
        {**NU205, "diametral_clearance": "-0.02 mm"}, [0.0, 2e-6, 5e-6, 8e-3, 0.0], "8000 rpm",
    ),
    "tapered": (TAPERED, [40e-6, 3e-6, 11e-6, 1e-3, -5e-4], "0 rpm"),
    "fast tapered": (TAPERED, [40e-6, 3e-6, 21e-6, 1e-3, -5e-4], "9000 rpm"),
    "ends": (
        {**TAPERED, "rib_height": "1.1 mm", "roller_end_radius": "80 mm"},
        [55e-6, 0.0, 11e-6, 1e-3, -5e-4], "9000 rpm",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_every_roller_is_in_balance_by_an_independent_evaluation(name: str) -> None:
    bearing, place, speed = CASES[name]
    case = case_of(bearing, duty={"load": {"fz": "1 kN"}, "inner_speed": speed})
    row = row_of(case)
    u = np.array(place)
    held = held_at(row, u)
    roller = Roller(row)
    if roller.tapered:
        given = case.bearing
        half = given.roller_half_angle
        apex = roller.radius / np.tan(half) + 0.5 * given.roller_length
        roller.rib(given.roller_length, given.contact_height, given.roller_end_radius or apex, half)
    azimuths = 2.0 * np.pi * np.arange(row.element_count) / row.element_count
    answer = row.answer(held, np.ones((1, 1)), np.ones((1, 1), np.int64), np.zeros(1, bool))
    tables = answer.tables()
    total = np.zeros(5)
    loaded = 0
    for j, azimuth in enumerate(azimuths):
        ring = ring_at(roller, u, azimuth)
        own = own_of(row, roller, ring, held.solution.state[0, j])
        inner, outer = roller.loads(ring, own)
        assert tables.inner.load[0, j] == pytest.approx(inner.sum(), abs=1e-9, rel=1e-10)
        assert tables.outer.load[0, j] == pytest.approx(outer.sum(), abs=1e-9, rel=1e-10)
        assert tables.rollers is not None
        assert tables.rollers.tilt[0, j] == pytest.approx(-own[2], abs=1e-15)
        rib = float(tables.rollers.rib_force[0, j])
        rest = roller.balance(ring, own, rib)
        if not roller.tapered:
            rest[0] = 0.0
        else:
            assert rib >= 0.0
            assert tables.rollers.rib_moment[0, j] == pytest.approx(
                turning(rib * roller.push, roller.touch), rel=1e-9, abs=1e-12
            )
        size = max(outer.sum(), 1.0)
        assert np.abs(rest / [size, size, size * 5e-3]).max() < 1e-9
        loaded += outer.sum() > 0.0
        f = roller.on_ring(ring, own, rib)
        c, s = np.cos(azimuth), np.sin(azimuth)
        total += [f[0], f[1] * s, f[1] * c, f[2] * c, -f[2] * s]
    assert 3 <= loaded <= row.element_count
    if not roller.tapered:
        total[0] = 0.0
    assert held.force[0] == pytest.approx(total, rel=1e-9, abs=1e-7)


@pytest.mark.parametrize("name", CASES)
def test_the_tangent_is_the_derivative_of_the_force(name: str) -> None:
    bearing, place, speed = CASES[name]
    case = case_of(bearing, duty={"load": {"fz": "1 kN"}, "inner_speed": speed})
    row = row_of(case)
    u = np.array(place)
    tangent = held_at(row, u).stiffness[0]
    steps = [2e-9, 2e-9, 2e-9, 1e-7, 1e-7]
    scale = np.sqrt(np.abs(np.diag(tangent)))
    scale = np.where(scale > 0.0, scale, 1.0)
    for i, h in enumerate(steps):
        change = np.zeros(5)
        change[i] = h
        both = [held_at(row, u + sign * change).force[0] for sign in (1.0, -1.0)]
        slope = (both[0] - both[1]) / (2.0 * h)
        assert np.abs((slope - tangent[:, i]) / (scale * scale[i])).max() < 2e-5
    assert np.allclose(tangent, tangent.T, rtol=1e-9, atol=1e-9 * np.abs(tangent).max())
