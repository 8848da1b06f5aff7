"""Four-point, thrust and self-aligning bearings: records, limits, laws, statuses and notes."""

from __future__ import annotations

from math import asin, atan, cos, degrees, nan, pi, radians, sin, tan
from typing import Any

import numpy as np
import pytest
from tests.one_case import keys, said

from rolamento import Bearing, Case, Displacement, Duty, Load, Model
from rolamento.case import case_to_toml, parse_case
from rolamento.contact.hertz import contact_stiffness, effective_modulus, elliptical_contact
from rolamento.errors import InputError
from rolamento.friction.model import touches_both_arcs
from rolamento.geometry import race_curvature, sphere_conformity
from rolamento.kinematics import centrifugal_force
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.static import race_stiffness
from rolamento.vibration import frequencies_of, nominal_frequencies

QJ: dict[str, Any] = {
    "kind": "four_point",
    "ball_count": 12,
    "ball_diameter": 12.7e-3,
    "pitch_diameter": 70e-3,
    "shim_angle": radians(20.0),
    "contact_angle": radians(35.0),
    "inner_conformity": 0.52,
    "outer_conformity": 0.53,
}
THRUST: dict[str, Any] = {
    "kind": "thrust",
    "ball_count": 14,
    "ball_diameter": 8.73e-3,
    "pitch_diameter": 61.2e-3,
    "inner_conformity": 0.54,
    "outer_conformity": 0.535,
}
SPHERE: dict[str, Any] = {
    "kind": "self_aligning",
    "ball_count": 12,
    "ball_diameter": 7.9e-3,
    "pitch_diameter": 39e-3,
    "spacing": 9e-3,
    "diametral_clearance": 15e-6,
    "inner_conformity": 0.52,
}


def case_of(
    bearing: dict[str, Any],
    speed: float = 0.0,
    model: dict[str, Any] | None = None,
    held: dict[str, float] | None = None,
    **load: float,
) -> Case:
    return Case(
        bearing=Bearing(**bearing),
        duty=Duty(inner_speed=speed, load=Load(**load), displacement=Displacement(**held or {})),
        model=Model(**model or {}),
    )


def without(bearing: dict[str, Any], *names: str, **changes: Any) -> dict[str, Any]:
    return {name: value for name, value in bearing.items() if name not in names} | changes


# --- the record -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("given", "field"),
    [
        (without(QJ, "shim_angle"), "shim_angle"),
        (without(QJ, "kind"), "shim_angle"),
        (QJ | {"diametral_clearance": 1e-5}, "diametral_clearance"),
        (QJ | {"arrangement": "DB", "spacing": 0.02}, "arrangement"),
        (QJ | {"shim_angle": 0.0}, "shim_angle"),
        (THRUST | {"contact_angle": radians(45.0)}, "contact_angle"),
        (THRUST | {"diametral_clearance": 1e-5}, "diametral_clearance"),
        (THRUST | {"preload": "100 N"}, "preload"),
        (without(THRUST, "kind", contact_angle=0.5 * pi), "contact_angle"),
        (SPHERE | {"outer_conformity": 0.53}, "outer_conformity"),
        (SPHERE | {"outer_shoulder_height": 1e-3}, "outer_shoulder_height"),
        (without(SPHERE, "spacing"), "spacing"),
        (without(SPHERE, "diametral_clearance", contact_angle=0.2), "spacing"),
        (without(SPHERE, "kind"), "outer_conformity"),
        (QJ | {"kind": "gothic"}, "kind"),
    ],
)
def test_what_a_kind_does_not_take_is_refused_by_name(given: dict[str, Any], field: str) -> None:
    with pytest.raises(InputError) as raised:
        Bearing(**given)
    assert raised.value.field == field
    assert raised.value.example


@pytest.mark.parametrize(
    "given", [QJ, THRUST, SPHERE, without(QJ, "contact_angle", diametral_clearance=2e-5)]
)
def test_case_files_hold_every_kind(given: dict[str, Any]) -> None:
    case = case_of(given, fx=1e3)
    assert parse_case(case_to_toml(case)).bearing == case.bearing


def test_a_thrust_bearing_has_ninety_degrees_by_itself() -> None:
    assert Bearing(**THRUST).contact_angle == 0.5 * pi
    assert parse_case(case_to_toml(case_of(THRUST, fx=1.0))).bearing.contact_angle == 0.5 * pi


def test_the_angle_that_takes_up_the_play_of_two_arches() -> None:
    """cos α = cos α_s - P_d/(2 B D), and s = (f - ½) D sin α_s."""
    clearance = 30e-6
    bearing = Bearing(**without(QJ, "contact_angle", diametral_clearance=clearance))
    reach = 0.05 * 12.7e-3
    assert cos(bearing.row_angle) == pytest.approx(cos(radians(20.0)) - clearance / (2 * reach))
    closed = Bearing(**without(QJ, "contact_angle", diametral_clearance=0.0))
    assert closed.row_angle == pytest.approx(radians(20.0), rel=1e-12)


def test_places_follow_the_kind() -> None:
    four, sphere, thrust = (Bearing(**given) for given in (QJ, SPHERE, THRUST))
    assert [(p.sign, p.position, p.phase) for p in four.places] == [(1, 0, 0), (-1, 0, 0)]
    assert len(four.element_rows) == 1
    assert [p.sign for p in sphere.places] == [-1.0, 1.0]  # face to face
    assert sphere.places[1].position == pytest.approx(4.5e-3)
    assert sphere.places[1].phase == pytest.approx(pi / 12)
    assert thrust.places[0].bearing == thrust
    # every outer groove centre is the bearing's own
    length = (sphere.outer_conformity - 0.5) * sphere.ball_diameter
    assert length * cos(sphere.row_angle) == pytest.approx(0.5 * sphere.pitch_diameter)
    assert length * sin(sphere.row_angle) == pytest.approx(4.5e-3)


@pytest.mark.parametrize(
    ("given", "model", "field"),
    [
        (QJ, {"raceway_control": "friction"}, "model.raceway_control"),
        (SPHERE, {"raceway_control": "friction"}, "model.raceway_control"),
        (THRUST, {"raceway_control": "jones"}, "model.raceway_control"),
        (QJ, {"raceway_control": "none"}, "model.raceway_control"),
        (THRUST, {"cage": "none"}, "model.cage"),
    ],
)
def test_models_that_do_not_apply_are_refused(
    given: dict[str, Any], model: dict[str, str], field: str
) -> None:
    with pytest.raises(InputError) as raised:
        case_of(given, model=model, fx=1e3)
    assert raised.value.field == field


# --- laws of all kinds ----------------------------------------------------------------------------

HARD = [
    (QJ, 0.0, {"fx": 2e3, "fz": 5e3}),
    (QJ, 500.0, {"fx": 500.0, "fz": 8e3, "my": 20.0, "mz": -10.0}),
    (without(QJ, "contact_angle", diametral_clearance=-5e-6), 900.0, {"fx": -300.0, "fy": 2e3}),
    (THRUST, 0.0, {"fx": 5e3, "fz": 200.0, "my": 20.0}),
    (THRUST, 800.0, {"fx": 2e3, "fy": 50.0, "mz": 10.0}),
    (THRUST | {"contact_angle": radians(60.0)}, 500.0, {"fx": 3e3, "fz": 400.0}),
    (SPHERE, 0.0, {"fx": 200.0, "fz": 2e3}),
    (SPHERE, 600.0, {"fx": -100.0, "fy": 900.0}),
]


@pytest.mark.parametrize(("given", "speed", "load"), HARD)
def test_every_ball_and_the_ring_are_in_balance(
    given: dict[str, Any], speed: float, load: dict[str, float]
) -> None:
    solved = solve(case_of(given, speed, model={"gyroscopic_moment": False}, **load))
    assert solved.converged[0], solved.advice[0]
    inner, outer, elements = solved.inner, solved.outer, solved.elements
    sign = solved.rows.sign[elements.row]
    force = np.zeros((2, len(sign)))
    ring = np.zeros((2, len(sign)))
    for contacts, way in ((inner, 1.0), (outer, -1.0)):
        axial = way * sign * contacts.load[0] * np.sin(contacts.contact_angle[0])
        radial = way * contacts.load[0] * np.cos(contacts.contact_angle[0])
        force += [axial, radial]
        if way > 0.0:
            ring += [axial, radial]
    if given["kind"] == "four_point":  # two rows of contacts, one row of balls
        force = force.reshape(2, 2, -1).sum(axis=1)
    force[1] += elements.centrifugal_force[0, : force.shape[1]]
    heaviest = inner.load.max()
    assert np.abs(force).max() < 1e-9 * heaviest
    psi = elements.azimuth[0]
    found = [ring[0].sum(), (ring[1] * np.sin(psi)).sum(), (ring[1] * np.cos(psi)).sum()]
    np.testing.assert_allclose(found, solved.load.array[0, :3], atol=1e-8 * heaviest)
    np.testing.assert_allclose(solved.rows.load[0].sum(axis=0), solved.load.array[0], atol=1e-6)


@pytest.mark.parametrize(("given", "speed", "load"), HARD)
def test_the_stiffness_is_the_derivative(
    given: dict[str, Any], speed: float, load: dict[str, float]
) -> None:
    solved = solve(case_of(given, speed, **load))
    place, matrix = solved.displacement.array[0], solved.stiffness.array[0]
    steps = np.array([2e-9, 2e-9, 2e-9, 1e-7, 1e-7])
    names = ("x", "y", "z", "ry", "rz")

    def reactions(shift: np.ndarray) -> np.ndarray:
        held = dict(zip(names, (place + shift).tolist(), strict=True))
        found = solve(case_of(given, speed, held=held))
        assert found.converged[0], found.advice[0]
        return np.asarray(found.load.array[0])

    columns = [
        (reactions(step * unit) - reactions(-step * unit)) / (2.0 * step)
        for step, unit in zip(steps, np.eye(5), strict=True)
    ]
    arms = np.array([1.0, 1.0, 1.0, 0.03, 0.03])
    scale = np.abs(matrix / np.outer(arms, arms)).max()
    difference = (np.stack(columns, axis=1) - matrix) / np.outer(arms, arms)
    assert np.abs(difference).max() < 2e-5 * scale


@pytest.mark.parametrize("given", [QJ, THRUST, SPHERE])
def test_a_turned_bearing_answers_turned(given: dict[str, Any]) -> None:
    load = {"fx": 2e3, "fz": 150.0}
    one = solve(case_of(given, 300.0, **load))
    angle = 0.7
    turned = Case(
        bearing=Bearing(**given),
        duty=Duty(
            inner_speed=300.0,
            first_ball_azimuth=angle,
            load=Load(fx=2e3, fy=150.0 * sin(angle), fz=150.0 * cos(angle)),
        ),
    )
    other = solve(turned)
    z = one.displacement.z[0]
    np.testing.assert_allclose(
        [other.displacement.y[0], other.displacement.z[0]],
        [z * sin(angle), z * cos(angle)], rtol=1e-7,
    )  # fmt: skip
    np.testing.assert_allclose(other.inner.load, one.inner.load, rtol=1e-6, atol=1e-6)


@pytest.mark.parametrize("given", [QJ, THRUST, SPHERE])
def test_many_cases_are_the_single_ones(given: dict[str, Any]) -> None:
    case = case_of(given, 200.0, fx=1e3)
    axial = np.array([500.0, 1e3, np.nan, 3e3])
    ball = np.array([given["ball_diameter"]] * 3 + [0.98 * given["ball_diameter"]])
    many = solve(case, {"duty.load.fx": axial, "bearing.ball_diameter": ball})
    assert many.status.code.tolist() == ["converged"] * 2 + ["invalid_input", "converged"]
    assert np.isnan(many.inner.load[2]).all()
    for index in (0, 1, 3):
        alone = solve(
            case_of(given | {"ball_diameter": ball[index]}, 200.0, fx=float(axial[index]))
        )
        np.testing.assert_allclose(
            many.displacement.array[index], alone.displacement.array[0], rtol=1e-8, atol=1e-14
        )
        np.testing.assert_allclose(
            many.outer.load[index], alone.outer.load[0], rtol=1e-7, atol=1e-9
        )


@pytest.mark.parametrize("given", [QJ, THRUST, SPHERE])
def test_a_result_is_read_as_it_was_written(given: dict[str, Any]) -> None:
    solved = solve(case_of(given, 300.0, fx=2e3, fz=100.0))
    again = Solved.from_json(solved.to_json())
    assert again.to_json() == solved.to_json()


# --- four-point contact ---------------------------------------------------------------------------


def test_an_axial_load_is_carried_by_two_contacts_as_in_an_angular_contact_bearing() -> None:
    four = solve(case_of(QJ, fx=5e3))
    plain = solve(case_of(without(QJ, "kind", "shim_angle"), fx=5e3))
    np.testing.assert_allclose(four.inner.load[0, :12], plain.inner.load[0], rtol=1e-9)
    assert not four.inner.load[0, 12:].any()
    # x counts from the middle: the play up to first contact is B D (sin α - sin α_s)
    play = 0.05 * 12.7e-3 * (sin(radians(35.0)) - sin(radians(20.0)))
    assert four.displacement.x[0] - play == pytest.approx(plain.displacement.x[0], rel=1e-8)


def test_without_a_shim_it_is_a_deep_groove_bearing() -> None:
    play = {"diametral_clearance": 40e-6}
    given = without(QJ, "contact_angle", shim_angle=1e-9, **play)
    groove = without(QJ, "kind", "shim_angle", "contact_angle", **play)
    load = {"fx": 4e3, "fz": 800.0}
    four, plain = solve(case_of(given, **load)), solve(case_of(groove, **load))
    np.testing.assert_allclose(
        four.displacement.array, plain.displacement.array, rtol=1e-6, atol=1e-13
    )
    np.testing.assert_allclose(four.inner.load[0, :12], plain.inner.load[0], rtol=1e-6)


def test_a_radial_load_is_carried_by_four_contacts() -> None:
    solved = solve(case_of(QJ, fz=5e3))
    first, mirrored = np.split(solved.inner.load[0], 2)
    np.testing.assert_allclose(first, mirrored, rtol=1e-9)
    assert solved.displacement.x[0] == pytest.approx(0.0, abs=1e-15)
    np.testing.assert_allclose(solved.rows.load[0, 0, 2], 2.5e3, rtol=1e-9)
    assert solved.rows.sign.tolist() == [1.0, -1.0]
    assert solved.rows.element_count.tolist() == [12, 12]


def test_a_mirrored_load_takes_the_other_arcs() -> None:
    one = solve(case_of(QJ, 400.0, fx=1e3, fz=3e3))
    other = solve(case_of(QJ, 400.0, fx=-1e3, fz=3e3))
    np.testing.assert_allclose(
        np.roll(one.inner.load[0], 12), other.inner.load[0], rtol=1e-8, atol=1e-8
    )
    np.testing.assert_allclose(
        np.roll(one.inner.spin[0], 12), other.inner.spin[0], rtol=1e-6, atol=1e-6
    )
    assert one.displacement.x[0] == pytest.approx(-other.displacement.x[0], rel=1e-9)


def test_at_speed_an_idle_ball_rests_on_both_outer_arcs() -> None:
    solved = solve(case_of(QJ, 500.0, fz=5e3))
    idle = 6  # opposite the load
    force = solved.elements.centrifugal_force[0, idle]
    assert solved.inner.load[0, idle] == 0.0
    angle = solved.outer.contact_angle[0, idle]
    loads = solved.outer.load[0, [idle, idle + 12]]
    np.testing.assert_allclose(loads, 0.5 * force / cos(angle), rtol=1e-9)
    assert degrees(angle) == pytest.approx(20.0, abs=0.05)
    mass = 7810.0 * pi / 6.0 * 12.7e-3**3
    orbit = 0.5 * 500.0 * (1.0 - 12.7 / 70.0 * cos(radians(35.0)))
    assert force == pytest.approx(float(centrifugal_force(mass, 70e-3, orbit)), rel=1e-3)


def test_one_rotation_of_a_ball_serves_all_its_contacts() -> None:
    """Seen in either row's frame it is the same: the axes mirror each other."""
    solved = solve(case_of(QJ, 300.0, fx=1e3, fz=5e3))
    elements = solved.elements
    np.testing.assert_array_equal(elements.ball_speed[0, :12], elements.ball_speed[0, 12:])
    np.testing.assert_array_equal(elements.attitude[0, :12], -elements.attitude[0, 12:])
    # the ball's gyroscopic moment counts once
    assert not elements.gyroscopic_moment[0, 12:].any()
    note = next(n for n in solved.notes[0] if n.key == "gyroscopic_moment_left_out")
    assert note.values["moment"] == np.abs(elements.gyroscopic_moment).max()
    assert touches_both_arcs(solved)[0]
    assert not touches_both_arcs(solve(case_of(QJ, fx=5e3)))[0]


def test_the_cage_and_balls_of_two_rows_of_contacts_are_told_once() -> None:
    bearing = Bearing(**QJ)
    assert not nominal_frequencies(bearing, 100.0).rows
    assert not frequencies_of(solve(case_of(QJ, 100.0, fx=1e3))).rows


def test_an_idle_flank_is_no_lost_row() -> None:
    solved = solve(case_of(QJ, 300.0, fx=5e3))
    assert not keys(solved.notes[0]) & {"row_unloaded", "balls_unloaded"}


def test_an_ellipse_that_meets_the_other_arc_is_told() -> None:
    low = without(QJ, "contact_angle", shim_angle=radians(4.0), diametral_clearance=0.0)
    assert "ellipse_over_arch" in keys(solve(case_of(low, fz=5e3)).notes[0])
    assert "ellipse_over_arch" not in keys(solve(case_of(QJ, fx=2e3)).notes[0])


# --- thrust ---------------------------------------------------------------------------------------


def test_a_central_load_presses_all_balls_alike() -> None:
    """δ = (F/(Z K))^(2/3) with both contacts in series at 90°."""
    solved = solve(case_of(THRUST, fx=5e3))
    bearing = Bearing(**THRUST)
    both = race_stiffness(bearing, 0.5 * pi).combined
    assert solved.displacement.x[0] == pytest.approx(
        float((5e3 / 14 / both) ** (2.0 / 3.0)), rel=1e-9
    )
    np.testing.assert_allclose(solved.inner.load, 5e3 / 14, rtol=1e-9)
    np.testing.assert_allclose(solved.inner.contact_angle, 0.5 * pi, rtol=1e-12)


def test_a_moment_is_an_excentric_load() -> None:
    solved = solve(case_of(THRUST, fx=5e3, my=30.0))
    psi, load = solved.elements.azimuth[0], solved.inner.load[0]
    arm = 0.5 * 61.2e-3
    assert (arm * load * np.cos(psi)).sum() == pytest.approx(30.0, rel=1e-6)
    assert load.argmax() == 0


def test_centrifugal_force_spreads_the_contact_angles() -> None:
    """F_c = Q_o cos α_o - Q_i cos α_i, and both carry the same axial load."""
    solved = solve(case_of(THRUST | {"outer_conformity": 0.54}, 1500.0, fx=1e3))
    inner, outer = solved.inner, solved.outer
    alpha = outer.contact_angle[0, 0]
    assert inner.contact_angle[0, 0] == pytest.approx(pi - alpha, rel=1e-3)
    force = solved.elements.centrifugal_force[0, 0]
    assert tan(alpha) == pytest.approx(2.0 * 1e3 / 14 / force, rel=1e-2)
    assert alpha < 0.5 * pi < inner.contact_angle[0, 0]


def test_balls_that_leave_the_grooves_are_named_with_the_load_that_keeps_them() -> None:
    shallow = THRUST | {"inner_shoulder_height": 1e-3, "outer_shoulder_height": 1e-3}
    lost = solve(case_of(shallow, 2000.0, fx=50.0))
    assert lost.status.code[0] == "over_shoulder"
    advice = lost.advice[0]
    assert advice is not None
    assert advice.key == "thrust_over_shoulder"
    least = advice.values["minimum_load"]
    assert solve(case_of(shallow, 2000.0, fx=1.1 * least)).converged[0]
    assert not solve(case_of(shallow, 2000.0, fx=0.9 * least)).converged[0]
    assert "axial load of" in said(advice)


@pytest.mark.parametrize(
    ("speed", "load", "key"),
    [
        (0.0, {"fx": -10.0}, "thrust_unsupported"),
        (0.0, {"fz": 100.0}, "thrust_unsupported"),
        (100.0, {}, "thrust_unsupported"),
        (0.0, {"fx": 100.0, "my": 20.0}, "thrust_pushed_aside"),
    ],
)
def test_what_a_thrust_bearing_cannot_hold_is_named(
    speed: float, load: dict[str, float], key: str
) -> None:
    solved = solve(case_of(THRUST, speed, **load))
    assert solved.status.code[0] == "no_equilibrium"
    assert solved.advice[0] is not None
    assert solved.advice[0].key == key
    assert np.isnan(solved.inner.load).all()


def test_a_radial_load_climbs_the_grooves_to_their_end() -> None:
    """A half circle would carry it; a groove with shoulders does not."""
    deep = solve(case_of(THRUST, fx=1e3, fz=2e3))
    assert deep.converged[0]
    assert deep.inner.contact_angle[0, 0] < radians(60.0)
    shallow = THRUST | {"inner_shoulder_height": 2e-3, "outer_shoulder_height": 2e-3}
    lost = solve(case_of(shallow, fx=1e3, fz=2e3))
    assert lost.status.code[0] == "over_shoulder"
    assert lost.advice[0] is not None
    assert lost.advice[0].key == "thrust_carries_no_radial_load"


def test_without_any_load_a_thrust_bearing_just_lies_there() -> None:
    solved = solve(case_of(THRUST))
    assert solved.converged[0]
    assert keys(solved.notes[0]) == {"no_load_given"}


def test_below_ninety_degrees_it_is_an_angular_contact_bearing() -> None:
    given = THRUST | {"contact_angle": radians(60.0)}
    thrust, plain = solve(case_of(given, fx=3e3)), solve(case_of(without(given, "kind"), fx=3e3))
    np.testing.assert_allclose(thrust.displacement.x, plain.displacement.x, rtol=1e-9)
    np.testing.assert_allclose(thrust.inner.load, plain.inner.load, rtol=1e-9)
    np.testing.assert_allclose(
        thrust.stiffness.array[0], plain.stiffness.array[0], rtol=1e-6, atol=1e-3
    )


# --- self-aligning --------------------------------------------------------------------------------


def test_a_sphere_has_one_radius_at_every_angle() -> None:
    bearing = Bearing(**SPHERE)
    radius = bearing.outer_conformity * bearing.ball_diameter
    angles = np.radians([0.0, 5.0, 13.0, 30.0])
    found = race_curvature(7.9e-3, 39e-3, bearing.outer_conformity, angles, "outer")
    np.testing.assert_allclose(found.rolling, 2.0 / 7.9e-3 - 1.0 / radius, rtol=1e-14)
    np.testing.assert_array_equal(found.rolling, found.across)
    assert sphere_conformity(7.9e-3, 39e-3, tan(asin(0.2))) == pytest.approx(
        39 / (2 * 7.9 * cos(asin(0.2))) + 0.5
    )


def test_its_contact_is_hertz_of_two_spheres() -> None:
    """a = (3 Q R/(4 E*))^(1/3), p = 6 Q/(...): Johnson (1985), eqs. 4.22 to 4.24."""
    bearing = Bearing(**SPHERE)
    modulus = effective_modulus(bearing.ring_material, bearing.ball_material)
    radius = 1.0 / (2.0 / 7.9e-3 - 1.0 / (bearing.outer_conformity * 7.9e-3))
    found = elliptical_contact(500.0, 1.0 / radius, 1.0 / radius, modulus)
    a = (3.0 * 500.0 * radius / (4.0 * 0.5 * modulus)) ** (1.0 / 3.0)
    assert float(found.semi_major) == pytest.approx(a, rel=1e-12)
    assert float(found.semi_minor) == pytest.approx(a, rel=1e-12)
    assert float(found.max_pressure) == pytest.approx(1.5 * 500.0 / (pi * a**2), rel=1e-12)
    near = contact_stiffness(1.0 / radius, (1.0 + 1e-9) / radius, modulus)
    assert float(contact_stiffness(1.0 / radius, 1.0 / radius, modulus)) == pytest.approx(
        float(near), rel=1e-8
    )
    solved = solve(case_of(SPHERE, fz=1e3))
    np.testing.assert_allclose(solved.outer.ellipticity, 1.0, rtol=1e-12)


@pytest.mark.parametrize("speed", [0.0, 500.0])
def test_a_tilt_makes_no_moment(speed: float) -> None:
    level = solve(case_of(SPHERE, speed, fx=200.0, fz=2e3))
    for tilt in ({"ry": 0.03}, {"rz": -0.04}, {"ry": 0.02, "rz": 0.02}):
        tilted = solve(case_of(SPHERE, speed, held=tilt, fx=200.0, fz=2e3))
        assert not tilted.load.array[0, 3:].any()
        assert not tilted.stiffness.array[0, 3:].any()
        # what the sphere carries is the same: only the direction in the ring's frame changes
        assert tilted.inner.load.sum() == pytest.approx(level.inner.load.sum(), rel=0.05)


def test_without_load_across_a_tilt_changes_nothing_but_the_frame() -> None:
    """A load that turns with the ring finds the same balls."""
    angle = 0.03
    level = solve(case_of(SPHERE, fz=2e3))
    load = {"fx": 2e3 * sin(angle), "fz": 2e3 * cos(angle)}  # z turned about y
    turned = solve(case_of(SPHERE, held={"ry": angle}, **load))
    np.testing.assert_allclose(turned.inner.load, level.inner.load, rtol=1e-8, atol=1e-8)
    rotation = np.array([[cos(angle), sin(angle)], [-sin(angle), cos(angle)]])
    shift = level.displacement.array[0, [0, 2]]
    np.testing.assert_allclose(turned.displacement.array[0, [0, 2]], rotation @ shift, rtol=1e-7)


def test_the_static_contacts_push_through_the_centre() -> None:
    """What makes the moment zero, checked on the outer contacts' lines: L_o sin α_o from it."""
    solved = solve(case_of(SPHERE, fz=2e3, fx=300.0))
    loaded = solved.inner.load[0] > 0.0
    np.testing.assert_allclose(
        solved.inner.contact_angle[0, loaded], solved.outer.contact_angle[0, loaded], rtol=1e-9
    )


def test_free_tilts_are_told_and_a_moment_is_refused() -> None:
    free = solve(case_of(SPHERE, fz=2e3, my=0.0, mz=0.0))
    assert free.converged[0]
    assert "tilt_undetermined" in keys(free.notes[0])
    loaded = solve(case_of(SPHERE, fz=2e3, my=1.0))
    assert loaded.status.code[0] == "no_equilibrium"
    assert loaded.advice[0] is not None
    assert loaded.advice[0].key == "sphere_holds_no_moment"
    far = solve(case_of(SPHERE, fz=2e3, held={"ry": radians(4.0)}))
    assert far.converged[0]
    assert "tilt_beyond_self_aligning" in keys(far.notes[0])


def test_the_play_of_a_self_aligning_bearing_is_radial() -> None:
    """The ring moves by half the diametral play before a ball touches."""
    play = 15e-6
    light = solve(case_of(SPHERE, fz=0.1))
    assert light.displacement.z[0] == pytest.approx(0.5 * play, rel=0.03)
    none = solve(
        case_of(
            without(SPHERE, "spacing", "diametral_clearance", contact_angle=atan(9 / 39)), fz=0.1
        )
    )
    assert abs(none.displacement.z[0]) < 0.2e-6


def test_jones_control_works_on_a_sphere() -> None:
    solved = solve(case_of(SPHERE, 300.0, model={"raceway_control": "jones"}, fz=1e3, fx=300.0))
    assert solved.converged[0]
    assert (solved.elements.raceway_control[0] == -1).any()


# --- double-row angular contact -------------------------------------------------------------------


@pytest.mark.parametrize("play", [{"contact_angle": radians(30.0)}, {"diametral_clearance": 2e-5}])
def test_a_double_row_bearing_is_a_pair_back_to_back(play: dict[str, float]) -> None:
    bearing = {
        "ball_count": 12, "ball_diameter": 9.5e-3, "pitch_diameter": 46.5e-3,
        "inner_conformity": 0.52, "outer_conformity": 0.52, "arrangement": "DB", "spacing": 11e-3,
        **play,
    }  # fmt: skip
    one = solve(case_of(bearing, 200.0, fx=1e3, fz=3e3, my=5.0, mz=0.0))
    assert one.converged[0]
    other = solve(case_of(bearing, 200.0, fx=-1e3, fz=3e3, my=-5.0, mz=0.0))
    assert other.displacement.x[0] == pytest.approx(-one.displacement.x[0], rel=1e-7)
    assert one.stiffness["my", "ry"][0] > 0.0


def test_fields_of_another_kind_do_not_vary() -> None:
    with pytest.raises(InputError, match="four-point"):
        solve(case_of(THRUST, fx=1e3), {"bearing.shim_angle": [0.3, 0.4]})
    with pytest.raises(InputError, match="sphere"):
        solve(case_of(SPHERE, fz=1e3), {"bearing.outer_conformity": [0.53, 0.54]})
    with pytest.raises(InputError, match="thrust"):
        solve(case_of(THRUST, fx=1e3), {"bearing.diametral_clearance": [1e-5, nan]})
    angles = solve(case_of(THRUST, fx=1e3), {"bearing.contact_angle": np.radians([40.0, 60, 90])})
    assert angles.status.code.tolist() == ["invalid_input", "converged", "converged"]
    shims = solve(case_of(QJ, fz=1e3), {"bearing.shim_angle": np.radians([15.0, 20.0, 25.0])})
    assert shims.converged.all()
    spacings = solve(case_of(SPHERE, fz=1e3), {"bearing.spacing": [8e-3, 9e-3]})
    one = solve(case_of(SPHERE, fz=1e3))
    np.testing.assert_allclose(spacings.inner.load[1], one.inner.load[0], rtol=1e-8, atol=1e-8)
