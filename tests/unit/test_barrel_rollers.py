"""Spherical, barrel and toroidal roller bearings: equilibrium against mathematics and a rival."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq, fsolve
from scipy.special import ellipe, ellipk

import rolamento as ro
from rolamento.errors import InputError

STEEL = 207e9 / (1.0 - 0.3**2)
"""E' of steel on steel."""
SPHERICAL: dict[str, Any] = {
    "element": "barrel", "kind": "spherical", "roller_count": 17, "roller_diameter": 0.012,
    "effective_length": 0.011, "pitch_diameter": 0.072, "contact_angle": np.radians(10.0),
    "diametral_clearance": 40e-6,
}  # fmt: skip
TOROIDAL: dict[str, Any] = {
    "element": "barrel", "kind": "toroidal", "roller_count": 16, "roller_diameter": 0.012,
    "effective_length": 0.018, "pitch_diameter": 0.072, "outer_raceway_radius": 0.12,
    "diametral_clearance": 60e-6,
}  # fmt: skip
MATERIAL = {"youngs_modulus": 207e9, "poisson_ratio": 0.3, "density": 7850.0}


def of(fields: dict[str, Any], **changes: Any) -> ro.RollerBearing:
    return ro.RollerBearing(**{"ring_material": MATERIAL, **fields, **changes})


# --- a rival: loops and SciPy ---------------------------------------------------------------------


def hertz_stiffness(rolling: float, across: float) -> tuple[float, float]:
    """K of Q = K δ^1.5 and a at 1 N, from the defining integrals of Hertz's problem."""

    # b²/a² = m1: the ratio of curvatures is (D-integral)/(B-integral) of the ellipse
    def ratio(m1: float) -> float:
        m = 1.0 - m1
        first, second = ellipk(m), ellipe(m)
        return float((second / m1 - first) / (first - second) - rolling / across)

    m1 = brentq(ratio, 1e-7, 1.0 - 1e-9, xtol=1e-16, rtol=1e-15)
    first, second = ellipk(1.0 - m1), ellipe(1.0 - m1)
    total, reduced = rolling + across, STEEL / 2.0
    # Johnson (1985), 4.26 to 4.28: p0 and the approach of an ellipse a >= b
    b_cubed = 3.0 * second * np.sqrt(m1) / (np.pi * reduced * total) * 1.0
    semi_minor = b_cubed ** (1.0 / 3.0)
    semi_major = semi_minor / np.sqrt(m1)
    pressure = 1.5 / (np.pi * semi_major * semi_minor)
    approach = pressure / reduced * semi_minor * first
    return float(approach**-1.5), float(semi_major)


def rival(fields: dict[str, Any], sign: float, phase: float, place: np.ndarray) -> np.ndarray:
    """Force of the ring on one row at rest, roller by roller, in vectors of three dimensions."""
    d, pitch, angle = fields["roller_diameter"], fields["pitch_diameter"], fields["contact_angle"]
    outer = pitch / (2.0 * np.cos(angle)) + d / 2.0
    profile = 0.97 * outer
    stiffness = []
    for side in (-1.0, 1.0):
        race = (pitch / 2.0 + side * d / 2.0 * np.cos(angle)) / np.cos(angle)
        stiffness.append(hertz_stiffness(2.0 / d - side / race, 1.0 / profile - 1.0 / outer)[0])
    both = sum(k ** (-2.0 / 3.0) for k in stiffness) ** -1.5
    distance = 2.0 * outer - d
    gap = 0.5 * fields["diametral_clearance"] * np.cos(angle)
    theta = np.hypot(place[3], place[4])
    axis = np.array([0.0, place[3], place[4]]) / (theta or 1.0)
    total = np.zeros(5)
    for number in range(fields["roller_count"]):
        psi = phase + 2.0 * np.pi * number / fields["roller_count"]
        arm = distance * np.array(
            [sign * np.sin(angle), np.cos(angle) * np.sin(psi), np.cos(angle) * np.cos(psi)]
        )
        # Rodrigues; a tilt ry takes z toward +x, as the house has it
        arm = (
            arm * np.cos(theta)
            + np.cross(axis, arm) * np.sin(theta)
            + axis * (axis @ arm) * (1.0 - np.cos(theta))
        )
        centre = arm + place[:3]
        approach = float(np.linalg.norm(centre)) - distance - gap
        load = both * max(approach, 0.0) ** 1.5
        force = load * centre / np.linalg.norm(centre)
        moment = np.cross(centre, force)
        total += np.array([*force, moment[1], moment[2]])
    return total


def rival_set(fields: dict[str, Any], place: np.ndarray) -> np.ndarray:
    half = np.pi / fields["roller_count"]
    return rival(fields, -1.0, 0.0, place) + rival(fields, 1.0, half, place)


@pytest.mark.parametrize("load", [(0.0, 0.0, 5e3), (1e3, -2e3, 6e3), (-1.5e3, 3e3, 1e3)])
@pytest.mark.parametrize("tilt", [(0.0, 0.0), (0.01, -0.004)])
def test_the_equilibrium_is_that_of_the_rival(
    load: tuple[float, float, float], tilt: tuple[float, float]
) -> None:
    solved = ro.solve(of(SPHERICAL), fx=load[0], fy=load[1], fz=load[2], ry=tilt[0], rz=tilt[1])
    assert solved.converged[0]
    found = solved.displacement.array[0]
    force = rival_set(SPHERICAL, found)
    assert force[:3] == pytest.approx(load, rel=1e-9, abs=1e-6)
    place = fsolve(
        lambda u: (rival_set(SPHERICAL, np.array([*(1e-6 * u), *tilt]))[:3] - load) / 1e3,
        1e6 * found[:3] + 0.5,
        xtol=1e-12,
    )
    assert 1e-6 * place == pytest.approx(found[:3], rel=1e-7, abs=1e-12)


def test_a_sphere_holds_no_moment_at_any_tilt() -> None:
    solved = ro.solve(of(SPHERICAL), x=10e-6, y=-30e-6, z=60e-6, ry=0.01, rz=0.007)
    force, moment = solved.load.array[0, :3], solved.load.array[0, 3:]
    assert np.abs(moment).max() <= 1e-13 * np.linalg.norm(force) * SPHERICAL["pitch_diameter"]


def test_rows_share_a_radial_load_by_symmetry() -> None:
    even = {**SPHERICAL, "roller_count": 16}
    solved = ro.solve(of(even), x=0.0, fz=8e3)
    # the second row stands half a pitch on, so that each has its own heaviest roller
    loads = np.sort(solved.rows.load[0, :, 2])
    assert loads.sum() == pytest.approx(8e3, rel=1e-9)
    pushed = solved.rows.load[0, :, 0]
    assert pushed[0] < 0.0 < pushed[1]
    turned = ro.solve(of(even), x=0.0, fz=8e3, first_ball_azimuth=np.pi / 16.0)
    assert turned.rows.load[0, ::-1, 2] == pytest.approx(solved.rows.load[0, :, 2], rel=1e-9)


def test_one_loaded_roller_is_hertz() -> None:
    fields = {**SPHERICAL, "roller_count": 3, "diametral_clearance": 0.0}
    barrel = {k: v for k, v in fields.items() if k not in ("kind", "contact_angle")}
    solved = ro.solve(of(barrel), x=0.0, y=0.0, z=5e-6)
    outer = 0.042
    profile, d = 0.97 * outer, 0.012
    k = [
        hertz_stiffness(2 / d - side / (0.036 + side * 0.006), 1 / profile - 1 / outer)[0]
        for side in (-1.0, 1.0)
    ]
    both = sum(one ** (-2.0 / 3.0) for one in k) ** -1.5
    assert solved.inner.load[0, 0] == pytest.approx(both * 5e-6**1.5, rel=1e-9)
    assert solved.load.fz[0] == pytest.approx(both * 5e-6**1.5, rel=1e-9)
    _, unit = hertz_stiffness(2 / d + 1 / 0.030, 1 / profile - 1 / outer)
    semi_major = unit * np.cbrt(solved.inner.load[0, 0])
    line = solved.rollers.inner.load_per_length[0, 0]
    bearing = line > 0.0
    assert bearing.sum() * 0.011 / len(line) == pytest.approx(2.0 * semi_major, abs=0.011 / 15)
    assert line.sum() * 0.011 / len(line) == pytest.approx(solved.inner.load[0, 0], rel=1e-12)


@pytest.mark.parametrize("fields", [SPHERICAL, TOROIDAL])
@pytest.mark.parametrize("speed", [0.0, 600.0])
def test_the_stiffness_is_the_derivative(fields: dict[str, Any], speed: float) -> None:
    place = np.array([20e-6, -25e-6, 55e-6, 0.004, -0.003])
    names = ("x", "y", "z", "ry", "rz")
    held = ro.solve(of(fields), **dict(zip(names, place, strict=True)), inner_speed=speed)
    step = np.array([1e-9, 1e-9, 1e-9, 1e-7, 1e-7])
    moved = {
        name: np.concatenate([place[i] + np.array([1.0, -1.0]) * step[i] if i == j else
                              np.full(2, place[i]) for j in range(5)])
        for i, name in enumerate(names)
    }  # fmt: skip
    force = ro.solve(of(fields), **moved, inner_speed=speed).load.array.reshape(5, 2, 5)
    numeric = ((force[:, 0] - force[:, 1]) / (2.0 * step[:, np.newaxis])).T
    arms = np.array([1.0, 1.0, 1.0, 0.036, 0.036])
    scale = np.outer(arms, arms)
    size = np.abs(held.stiffness.array[0] / scale).max()
    assert np.abs((held.stiffness.array[0] - numeric) / scale).max() < 2e-5 * size


def test_speed_throws_the_rollers_outward() -> None:
    still = ro.solve(of(SPHERICAL), fz=8e3)
    fast = ro.solve(of(SPHERICAL), fz=8e3, inner_speed=800.0)
    force = fast.elements.centrifugal_force[0, 0]
    assert force > 0.0
    loaded = fast.loaded[0]
    more = fast.outer.load[0] - fast.inner.load[0]
    cosine = np.cos(fast.outer.contact_angle[0])
    assert more == pytest.approx(force * cosine, rel=1e-9)
    assert (fast.outer.load[0, ~loaded] > 0.0).all()
    assert fast.displacement.z[0] > still.displacement.z[0]
    slow = ro.solve(of(SPHERICAL), fz=8e3, inner_speed=1e-6)
    assert slow.displacement.z[0] == pytest.approx(still.displacement.z[0], rel=1e-12)


def test_a_torus_loses_clearance_as_it_is_displaced() -> None:
    """P_d falls by s²/(2R - D)."""
    radius, s = TOROIDAL["outer_raceway_radius"], 1.0e-3
    lost = s**2 / (2.0 * radius - TOROIDAL["roller_diameter"])
    assert 2e-6 < lost < TOROIDAL["diametral_clearance"]
    open_at = 0.5 * (TOROIDAL["diametral_clearance"] - lost)
    just = ro.solve(of(TOROIDAL), x=s, y=0.0, z=np.array([open_at * 0.99, open_at * 1.02]))
    assert (just.inner.load[0] == 0.0).all()
    assert (just.inner.load[1] > 0.0).any()
    # and holds its ring at any place along the shaft
    solved = ro.solve(of(TOROIDAL), x=np.array([-1e-3, 0.0, 1e-3]), fz=4e3)
    assert solved.load.fx[1] == pytest.approx(0.0, abs=1e-9)
    assert np.abs(solved.load.fx).max() < 0.02 * 4e3
    assert solved.load.fx[0] == pytest.approx(-solved.load.fx[2], rel=1e-9)


def test_a_torus_takes_a_tilt_almost_freely() -> None:
    """Its rollers tilt and shift: the moment is far below that of rigid cylinders."""
    solved = ro.solve(of(TOROIDAL), fz=4e3, ry=np.array([0.0, 0.005]))
    assert abs(solved.load.my[1]) < 4e3 * 0.072 * 0.02


def test_cases_know_nothing_of_each_other() -> None:
    loads = np.linspace(1e3, 60e3, 7)
    many = ro.solve(of(SPHERICAL), fz=loads, fx=500.0, inner_speed=100.0)
    for case, load in enumerate(loads):
        one = ro.solve(of(SPHERICAL), fz=np.array([load]), fx=500.0, inner_speed=100.0)
        assert np.array_equal(one.displacement.array[0], many.displacement.array[case])
        assert np.array_equal(one.inner.load[0], many.inner.load[case])


@pytest.mark.parametrize("designation", ["22220 E", "C 2220"])
def test_without_an_equilibrium_there_is_no_life(designation: str) -> None:
    """A ring that no moment can hold has NaN along its rollers, not zero, and no endless life."""
    solved = ro.solve(designation, fz=[10e3, 10e3], my=[0.0, 10.0], inner_speed=100.0)
    assert solved.converged.tolist() == [True, False]
    assert np.isnan(solved.rollers.inner.load_per_length[1]).all()
    found = ro.rating_life(solved)
    assert np.isfinite(found.headline.life[0])
    assert np.isnan(found.headline.life[1])
    assert np.isnan(found.reference.life[1])
    assert found.headline.valid.tolist() == [True, False]


def test_the_load_has_no_step_where_the_ends_cut_the_ellipse() -> None:
    short = {**SPHERICAL, "effective_length": 0.006}
    depth = np.linspace(20e-6, 60e-6, 400)
    solved = ro.solve(of(short), x=0.0, y=0.0, z=depth)
    load = solved.inner.load[:, 0]
    steps = np.diff(load) / np.diff(depth)
    assert (steps >= 0.0).all()
    assert np.abs(np.diff(steps)).max() < 0.1 * steps.max()
    peak = solved.inner.max_pressure[40:, 0]
    assert np.abs(np.diff(peak)).max() < 0.03 * peak.max()
    whole = solved.rollers.inner.load_per_length[:, 0] > 0.0
    assert not whole[np.argmax(load > 100.0)].all()
    assert whole[-1].all()


def test_it_converges_with_the_slices() -> None:
    short = of({**SPHERICAL, "effective_length": 0.006})
    loads = [
        ro.solve(ro.Case(bearing=short, duty={}, model={"slices": n}), z=70e-6, x=0.0, y=0.0)
        .inner.load[0].max() for n in (15, 31, 61, 201)
    ]  # fmt: skip
    errors = np.abs(np.array(loads[:-1]) / loads[-1] - 1.0)
    assert (np.diff(errors) < 0.0).all()
    assert errors[1] < 2e-3


@pytest.mark.parametrize(
    ("changes", "field"),
    [
        ({"outer_raceway_radius": 0.05}, "outer_raceway_radius"),
        ({"contact_angle": None}, "contact_angle"),
        ({"roller_profile_radius": 0.05}, "roller_profile_radius"),
        ({"roller_profile_radius": 0.005}, "roller_profile_radius"),
        ({"diametral_clearance": None}, "diametral_clearance"),
        ({"element": "cylindrical"}, "kind"),
        ({"kind": "toroidal", "contact_angle": None}, "outer_raceway_radius"),
    ],
)
def test_what_is_no_such_bearing_is_refused(changes: dict[str, Any], field: str) -> None:
    with pytest.raises(InputError) as caught:
        of(SPHERICAL, **changes)
    assert caught.value.field == field
