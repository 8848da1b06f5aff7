"""Rows of rollers: balance of every roller, of the ring, and their limits."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from pydantic import ValidationError
from scipy.optimize import root

from rolamento.case import Case
from rolamento.rows.roller import layout
from rolamento.rows.roller.row import RollerRow
from rolamento.solution import solve
from rolamento.system.cases import spread

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
    return row.respond(place[np.newaxis], np.array([0]))


# --- an independent roller: points and normals in the plane, nothing eliminated -------------------


@dataclass
class Roller:
    """A roller in its plane with three displacements of its own, and the rib's force."""

    row: RollerRow

    def __post_init__(self) -> None:
        n, p = self.row.numbers, self.row.numbers.p[:, 0]
        beta, half = n.geometry.axis[0], n.geometry.half_angle[0]
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
        self.centrifugal, self.moment = p[layout.CENTRIFUGAL], p[layout.MOMENT]
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
    geometry = row.numbers.geometry
    epsilon, arm = geometry.rib_angle[0], geometry.rib_arm[0]
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


# --- the ring -------------------------------------------------------------------------------------


def test_the_ring_comes_to_rest_where_a_general_solver_finds_it() -> None:
    """All equations at once in SciPy: the ring, and every roller with its rib's force."""
    bearing = {**TAPERED, "roller_count": 8, "rib_height": "1 mm", "roller_end_radius": "90 mm"}
    duty = {
        "load": {"fx": "2 kN", "fy": "0.4 kN", "fz": "1.5 kN"},
        "displacement": {"ry": "1.5 mrad", "rz": "-0.5 mrad"},
        "inner_speed": "6000 rpm",
    }
    case = case_of(bearing, duty=duty, model={"slices": 15})
    solved = solve(case)
    assert solved.status.code[0] == "converged"
    row = row_of(case)
    roller = Roller(row)
    given = case.bearing
    roller.rib(given.roller_length, 1e-3, 0.09, given.roller_half_angle)
    azimuths = 2.0 * np.pi * np.arange(8) / 8
    place = solved.displacement.array[0]
    target = np.array([2000.0, 400.0, 1500.0])
    unit = np.array([1e-6, 1e-6, 1e-4, 10.0])

    def unbalanced(unknowns: Array) -> Array:
        u = place.copy()
        u[:3] = 1e-6 * unknowns[:3]
        rest, total = [], np.zeros(3)
        for own, azimuth in zip(unknowns[3:].reshape(8, 4) * unit, azimuths, strict=True):
            ring = ring_at(roller, u, azimuth)
            gap = moved(own[:3] - ring, roller.touch) @ roller.push
            rest += [*roller.balance(ring, own[:3], own[3]) * [1, 1, 300], gap * 1e9]
            f = roller.on_ring(ring, own[:3], own[3])
            total += [f[0], f[1] * np.sin(azimuth), f[1] * np.cos(azimuth)]
        return np.array([*(total - target), *rest])

    rollers = solved.rollers
    assert rollers is not None
    held = held_at(row, place)
    start = [*(1e6 * place[:3])]
    for j, azimuth in enumerate(azimuths):
        ring = ring_at(roller, place, azimuth)
        own = own_of(row, roller, ring, held.solution.state[0, j])
        start += [*(own / unit[:3]), rollers.rib_force[0, j] / unit[3]]
    begin = np.array(start) * np.tile([1.03, 0.96], len(start))[: len(start)]
    found = root(unbalanced, begin, method="hybr", tol=1e-13)
    assert np.abs(unbalanced(found.x)).max() < 1e-5
    assert found.x[:3] == pytest.approx(start[:3], rel=1e-8, abs=1e-8)
    assert np.abs(unbalanced(np.array(start))).max() < 1e-5


def test_what_turns_by_a_pitch_stays_itself() -> None:
    pitch = 2.0 * np.pi / 13
    duty = {"load": {"fz": "3 kN"}, "displacement": {"ry": "3 mrad", "rz": "1 mrad"}}
    one, other = (
        solve(case_of(NU205, duty={**duty, "first_ball_azimuth": f"{phase} rad"}))
        for phase in (0.0, pitch)
    )
    assert one.displacement.array == pytest.approx(other.displacement.array, rel=1e-10, abs=1e-17)
    assert np.roll(one.inner.load[0], -1) == pytest.approx(other.inner.load[0], rel=1e-9, abs=1e-9)
    c, s = np.cos(pitch), np.sin(pitch)
    # the tilt turns with the load: (ry, rz) as (z, -y) do
    turned = {
        "load": {"fy": f"{3 * s} kN", "fz": f"{3 * c} kN"},
        "displacement": {"ry": f"{3 * c + s} mrad", "rz": f"{c - 3 * s} mrad"},
    }
    moved_on = solve(case_of(NU205, duty=turned))
    assert np.roll(moved_on.inner.load[0], -1) == pytest.approx(
        one.inner.load[0], rel=1e-9, abs=1e-9
    )
    assert np.hypot(moved_on.displacement.y, moved_on.displacement.z) == pytest.approx(
        np.hypot(one.displacement.y, one.displacement.z), rel=1e-10
    )


def test_many_cases_are_each_as_alone_compiled_or_not() -> None:
    case = case_of(NU205, duty={"load": {"fz": "2 kN"}, "inner_speed": "9000 rpm"})
    values = {
        "duty.displacement.ry": np.linspace(-0.01, 0.01, 7),
        "bearing.diametral_clearance": np.linspace(-20e-6, 60e-6, 7),
        "bearing.effective_length": np.linspace(8e-3, 9e-3, 7),
    }
    many = solve(case, values)
    assert many.status.converged.all()
    for index in (0, 3, 6):
        alone = solve(case, {name: value[index] for name, value in values.items()})
        assert alone.displacement.array[0] == pytest.approx(
            many.displacement.array[index], rel=1e-10, abs=1e-16
        )
        assert alone.inner.max_pressure[0] == pytest.approx(
            many.inner.max_pressure[index], rel=1e-8, abs=1.0
        )


# --- limits ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("law", ["slices", "coupled"])
def test_what_begins_from_a_memory_is_what_begins_anew(law: str) -> None:
    case = case_of(NU205, duty={"inner_speed": "6000 rpm"}, model={"roller_contact": law})
    row = row_of(case)
    place = np.array([0.0, 2e-6, 30e-6, 2e-3, 0.0])
    anew = held_at(row, place)
    far = anew.memory + np.array([0.0, 0.0, 0.0, 0.0, 0.0, *[1.0, 0.3] * 13])  # nowhere near
    steps = []
    for memory in (anew.memory, held_at(row, 0.9 * place).memory, far):
        held = row.respond(place[np.newaxis], np.array([0]), memory)
        assert held.number[0] == anew.number[0]
        assert held.residual[0] <= 1e-10
        assert held.force == pytest.approx(anew.force, rel=1e-9, abs=1e-9 * anew.scale[0])
        largest = np.abs(anew.stiffness).max()
        assert held.stiffness == pytest.approx(anew.stiffness, rel=1e-6, abs=1e-6 * largest)
        steps.append(int(held.solution.steps[0]))
    assert steps[0] == 0
    assert steps[1] < anew.solution.steps[0]


def test_centrifugal_force_is_the_difference_of_both_races() -> None:
    solved = solve(
        case_of(NU205, duty={"load": {"fz": "2 kN"}, "inner_speed": "15000 rpm"}),
    )
    inner, outer = solved.inner.load[0], solved.outer.load[0]
    force = solved.elements.centrifugal_force[0]
    mass = np.pi / 4 * 0.0075**2 * 0.009 * solved.case.bearing.roller_material.density
    orbit = 0.5 * (1.0 - 7.5 / 38.5) * 15000 * np.pi / 30
    assert force == pytest.approx(mass * 0.01925 * orbit**2, rel=1e-9)
    assert outer - inner == pytest.approx(force, rel=1e-9)
    assert (inner == 0.0).any()
    assert (inner > 0.0).any()


@pytest.mark.parametrize("speed", ["0 rpm", "20000 rpm"])
@pytest.mark.parametrize("ends", [{}, {"rib_height": "0.9 mm", "roller_end_radius": "60 mm"}])
def test_the_rib_balances_what_the_cones_squeeze_out(speed: str, ends: dict[str, str]) -> None:
    """Across the inner raceway's normal the rib alone acts against the outer race.

    With the rib along the inner raceway, F = Q_o sin(α_o - α_i); its part along the shaft with a
    rib that pushes along the shaft is Q_o sin(α_o - α_i)/cos α_i.
    """
    bearing = {**TAPERED, **ends}
    solved = solve(
        case_of(bearing, duty={"load": {"fx": "4 kN", "fz": "1 kN"}, "inner_speed": speed})
    )
    row = row_of(solved.case)
    half, beta = row.numbers.geometry.half_angle[0], row.numbers.geometry.axis[0]
    leaning = row.numbers.geometry.rib_angle[0] - half  # of the rib's normal over the inner raceway
    outer, thrown = solved.outer.load[0], solved.elements.centrifugal_force[0]
    rollers = solved.rollers
    assert rollers is not None
    expected = outer * np.sin(2.0 * half) + thrown * np.sin(beta - half)
    assert rollers.rib_force[0] * np.cos(leaning) == pytest.approx(expected, rel=1e-9)
    assert (rollers.rib_force[0] > 0.0).all()


def test_a_tapered_row_of_no_taper_is_a_cylindrical_one() -> None:
    plain = {**NU205, "diametral_clearance": "0 mm", "roller_profile": "logarithmic"}
    tapered = {
        key: value for key, value in plain.items() if key not in ("diametral_clearance", "element")
    }
    tapered |= {"element": "tapered", "contact_angle": "1e-8 rad", "roller_half_angle": "1e-10 rad"}
    duty = {
        "load": {"fz": "2 kN"},
        "displacement": {"x": "0 mm", "ry": "2 mrad", "rz": "1 mrad"},
        "inner_speed": "9000 rpm",
    }
    one, other = (solve(case_of(bearing, duty=duty)) for bearing in (plain, tapered))
    assert other.outer.load[0] == pytest.approx(one.outer.load[0], rel=1e-5, abs=1e-3)
    assert other.displacement.z == pytest.approx(one.displacement.z, rel=1e-5)


@pytest.mark.parametrize("arrangement", ["DB", "DF"])
def test_an_opposed_pair_is_its_own_mirror_image(arrangement: str) -> None:
    pair = {**TAPERED, "arrangement": arrangement, "spacing": "30 mm", "preload": "400 N"}
    load = {"fz": "3 kN", "my": "0 N m", "mz": "0 N m"}
    one, other = (
        solve(case_of(pair, duty={"load": {**load, "fx": fx}, "inner_speed": "4000 rpm"}))
        for fx in ("800 N", "-800 N")
    )
    assert one.displacement.x == pytest.approx(-other.displacement.x, rel=1e-8)
    assert one.displacement.ry == pytest.approx(-other.displacement.ry, rel=1e-6)
    z = 17
    assert one.inner.load[0, :z] == pytest.approx(other.inner.load[0, z:], rel=1e-7, abs=1e-6)
    assert one.inner.max_pressure[0, z:] == pytest.approx(
        other.inner.max_pressure[0, :z], rel=1e-7, abs=1.0
    )
    still = solve(case_of(pair, duty={"load": {}, "displacement": {}}))
    row = still.rows.load[0]
    assert row[:, 0] == pytest.approx(400.0 * still.rows.sign, rel=1e-6)


def test_slices_converge_with_the_square_of_their_width() -> None:
    bearing = {**NU205, "roller_profile": "none"}
    duty = {
        "load": {"fz": "9 kN"},
        "displacement": {"ry": "0.3 mrad", "rz": "0 mrad"},
    }  # the heaviest roller bears all along
    found = [
        solve(case_of(bearing, duty=duty, model={"slices": n})).load.my[0]
        for n in (5, 15, 45, 1001)
    ]
    errors = np.abs(np.array(found[:-1]) - found[-1])
    order = np.log(errors[:-1] / errors[1:]) / np.log(3.0)
    assert (order > 1.6).all()


# --- ribs of cylindrical rollers ------------------------------------------------------------------

RIBBED = {**NU205, "inner_ribs": "-", "outer_ribs": "both", "axial_play": "0.05 mm"}


def test_opposed_ribs_carry_the_axial_load_over_the_rollers_ends() -> None:
    solved = solve(case_of(RIBBED, duty={"load": {"fx": "300 N", "fz": "3 kN"}}))
    rollers = solved.rollers
    assert rollers is not None
    assert rollers.rib_force[0].sum() == pytest.approx(300.0, rel=1e-9)
    assert (rollers.rib_force[0] >= 0.0).all()
    assert solved.displacement.x[0] > 25e-6  # beyond half of the play
    # the couple of the ribs tilts the roller until the raceways hold it
    couple = -2.0 * (0.5 * 7.5e-3 - 0.75e-3) * rollers.rib_force[0]
    assert rollers.rib_moment[0] == pytest.approx(couple, rel=1e-9)
    lines = rollers.outer.load_per_length[0], rollers.inner.load_per_length[0]
    width = 9e-3 / rollers.slices
    place = rollers.slice_place[0]
    held = [(q * place).sum(axis=-1) * width for q in lines]
    assert held[1] - held[0] == pytest.approx(couple, rel=1e-6, abs=1e-7)


@pytest.mark.parametrize(
    ("bearing", "axial", "code"),
    [
        (NU205, "300 N", "no_equilibrium"),
        (RIBBED, "-300 N", "no_equilibrium"),
        ({**RIBBED, "inner_ribs": "both"}, "-300 N", "converged"),
        ({**RIBBED, "inner_ribs": "both", "outer_ribs": "none"}, "300 N", "no_equilibrium"),
    ],
)
def test_an_axial_load_takes_a_rib_on_either_ring(
    bearing: dict[str, Any], axial: str, code: str
) -> None:
    solved = solve(case_of(bearing, duty={"load": {"fx": axial, "fz": "3 kN"}}))
    assert solved.status.code[0] == code
    if code == "no_equilibrium":
        assert solved.status.unsupported[0] == 0
        assert np.isnan(solved.inner.load).all()


def test_friction_control_is_of_balls() -> None:
    with pytest.raises(ValidationError, match=r"raceway_control.*is for balls only"):
        case_of(
            NU205,
            duty={"load": {"fz": "3 kN"}},
            lubricant={"kind": "dry", "friction_coefficient": 0.1},
            model={"raceway_control": "friction"},
        )


@pytest.mark.parametrize(
    ("ends", "message"),
    [
        ({"rib_height": "4 mm"}, r"rib_height.*less than half the roller diameter, 3.5 mm"),
        ({"roller_end_radius": "3 mm"}, r"roller_end_radius.*must be greater than 3.0"),
    ],
)
def test_a_rib_touches_the_end_of_a_roller(ends: dict[str, str], message: str) -> None:
    with pytest.raises(ValidationError, match=message):
        case_of({**TAPERED, **ends}, duty={"load": {"fx": "3 kN"}})


# --- hard cases -----------------------------------------------------------------------------------

NEEDLES = {
    "element": "needle",
    "roller_count": 500,
    "roller_diameter": "2.5 mm",
    "effective_length": "15 mm",
    "pitch_diameter": "420 mm",
    "diametral_clearance": "0.03 mm",
}
HELD = {"ry": "0 rad", "rz": "0 rad"}
HARD: dict[str, tuple[dict[str, Any], dict[str, Any], str]] = {
    "no load": (NU205, {"load": {"fz": "0 N"}}, "converged"),
    "no load, fast": (NU205, {"load": {}, "inner_speed": "30000 rpm"}, "converged"),
    "a milligram": (NU205, {"load": {"fz": "1e-5 N"}, "inner_speed": "20000 rpm"}, "converged"),
    "a moment alone": (NU205, {"load": {"my": "5 N m", "mz": "3 N m"}}, "converged"),
    "10 mrad": (
        NU205, {"load": {"fz": "3 kN"}, "displacement": {**HELD, "ry": "10 mrad"}}, "converged",
    ),
    "10 mrad of a tapered row": (
        TAPERED,
        {"load": {"fx": "3 kN"}, "displacement": {**HELD, "rz": "-10 mrad"}},
        "converged",
    ),
    "interference": ({**NU205, "diametral_clearance": "-0.14 mm"}, {"load": {}}, "converged"),
    "3 mm of play": (
        {**NU205, "diametral_clearance": "3 mm"},
        {"load": {"fz": "1 kN"}, "inner_speed": "20000 rpm"},
        "converged",
    ),
    "500 needles": (
        NEEDLES,
        {"load": {"fz": "5 kN", "my": "10 N m", "mz": "0 N m"}, "inner_speed": "900 rpm"},
        "converged",
    ),
    "1 MN": (NU205, {"load": {"fz": "1 MN"}}, "overloaded"),
    "pulled apart": (TAPERED, {"load": {"fx": "-1 kN"}}, "no_equilibrium"),
    "radial alone": (TAPERED, {"load": {"fz": "1 kN"}}, "no_equilibrium"),
    "thrown out": (
        TAPERED, {"load": {"fx": "5 N"}, "inner_speed": "30000 rpm"}, "no_equilibrium",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", HARD)
def test_hard_cases_end_as_they_should(name: str) -> None:
    bearing, duty, code = HARD[name]
    solved = solve(case_of(bearing, duty=duty))
    assert solved.status.code[0] == code
    if code == "converged":
        assert solved.status.residual[0] < 1e-9
        assert np.isfinite(solved.inner.load).all()
    else:
        assert np.isnan(solved.displacement.array).all()
        assert np.isnan(solved.inner.max_pressure).all()


@pytest.mark.parametrize("bearing", [NU205, TAPERED], ids=["cylindrical", "tapered"])
def test_coupled_slices_find_the_same_balance_with_peaks_at_the_edges(
    bearing: dict[str, Any],
) -> None:
    sharp = {**bearing, "roller_profile": "none"}
    axial = {"fx": "3 kN"} if bearing is TAPERED else {}
    duty = {
        "load": {"fz": "3 kN", **axial},
        "displacement": {"ry": "2 mrad", "rz": "0 rad"},
        "inner_speed": "8000 rpm",
    }
    plain, coupled = (
        solve(case_of(sharp, duty=duty, model={"roller_contact": name}))
        for name in ("slices", "coupled")
    )
    assert coupled.status.code[0] == "converged"
    assert coupled.load.fz[0] == pytest.approx(3000.0)
    heaviest = int(plain.inner.load[0].argmax())
    assert coupled.inner.load[0, heaviest] == pytest.approx(plain.inner.load[0, heaviest], rel=0.05)
    lines = [one.rollers.inner for one in (plain, coupled) if one.rollers is not None]
    assert lines[1].pressure[0, heaviest].max() > 1.1 * lines[0].pressure[0, heaviest].max()
    row = row_of(case_of(sharp, duty=duty, model={"roller_contact": "coupled"}))
    u = coupled.displacement.array[0]
    tangent = held_at(row, u).stiffness[0]
    for i, h in enumerate([1e-10, 1e-10, 1e-10, 5e-9, 5e-9]):
        change = np.zeros(5)
        change[i] = h
        both = [held_at(row, u + sign * change).force[0] for sign in (1.0, -1.0)]
        slope = (both[0] - both[1]) / (2.0 * h)
        size = np.sqrt(np.abs(np.diag(tangent)))
        size = np.where(size > 0.0, size, 1.0)
        assert np.abs((slope - tangent[:, i]) / (size * size[i])).max() < 1e-4


# --- sets of several kinds ------------------------------------------------------------------------


def test_a_cylindrical_row_beside_a_pair_of_ball_bearings_floats() -> None:
    balls = {
        "ball_count": 12,
        "ball_diameter": "7.938 mm",
        "pitch_diameter": "39 mm",
        "inner_conformity": 0.52,
        "outer_conformity": 0.52,
        "contact_angle": "25 deg",
        "preload": "100 N",
        "rows": [
            {"position": "0 mm", "orientation": "+"},
            {"position": "15 mm", "orientation": "-"},
            {**NU205, "position": "60 mm"},
        ],
    }
    load = {"fx": "500 N", "fz": "3 kN", "my": "90 N m", "mz": "0 N m"}
    solved = solve(case_of(balls, duty={"load": load, "inner_speed": "3000 rpm"}))
    assert solved.status.code[0] == "converged"
    assert solved.rows.element == ("ball", "ball", "cylindrical")
    assert solved.rows.load[0].sum(axis=0) == pytest.approx([500, 0, 3000, 90, 0], abs=1e-5)
    assert solved.rows.load[0, 2, 0] == 0.0
    assert abs(solved.rows.load[0, 2, 2]) > 100.0
    rollers = solved.rollers
    assert rollers is not None
    assert np.isnan(rollers.tilt[0, :24]).all()
    assert np.isfinite(rollers.tilt[0, 24:]).all()
    still = solve(case_of(balls, duty={"load": {}, "inner_speed": "0 rpm"}))
    assert still.rows.load[0, :, 0] == pytest.approx([100.0, -100.0, 0.0], abs=1e-6)
