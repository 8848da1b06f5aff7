"""What acts on the shafts of a machine: forces of gears and belts, masses, gravity."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rolamento.case.machine_loads import Belt, Gear, Gravity, Mass, ShaftLoad, mirrored
from rolamento.errors import InputError

SHAFT = {"shaft": "s", "position": 0.1}
KINDS: dict[str, dict[str, Any]] = {
    "spur": {},
    "helical": {"helix_angle": 0.3},
    "bevel": {"cone_angle": 0.4, "apex": "-x"},
    "worm": {"lead_angle": 0.2, "friction_coefficient": 0.04},
    "worm_wheel": {"lead_angle": 0.2, "friction_coefficient": 0.04},
}

angles = st.floats(-math.pi, math.pi)
speeds = st.floats(1.0, 1000.0) | st.floats(-1000.0, -1.0)


def gear(kind: str = "spur", **fields: Any) -> Gear:
    plain = {"pitch_diameter": 0.1, "torque": 50.0, "mesh_azimuth": 0.0, "drives": True}
    return Gear(**{**SHAFT, "kind": kind, **KINDS[kind], **plain, **fields})


@st.composite
def gears(draw: st.DrawFn, kinds: tuple[str, ...] = tuple(KINDS)) -> Gear:
    kind = draw(st.sampled_from(kinds))
    own: dict[str, Any] = {}
    if kind != "spur":
        own["hand"] = draw(st.sampled_from(["right", "left"]))
    if kind in ("helical", "bevel"):
        own["helix_angle"] = draw(st.floats(0.01, 0.8))
    if kind == "bevel":
        own["cone_angle"] = draw(st.floats(0.05, 1.5))
        own["apex"] = draw(st.sampled_from(["+x", "-x"]))
    if kind in ("worm", "worm_wheel"):
        own["lead_angle"] = draw(st.floats(0.15, 0.6))
        own["friction_coefficient"] = draw(st.floats(0.0, 0.1))
    return gear(
        kind,
        **own,
        pitch_diameter=draw(st.floats(0.02, 1.0)),
        torque=draw(st.floats(0.1, 1e4)),
        mesh_azimuth=draw(angles),
        pressure_angle=draw(st.floats(0.1, 0.5)),
        drives=draw(st.booleans()),
    )


def arm(of: Gear) -> np.ndarray:
    azimuth = of.mesh_azimuth or 0.0
    return 0.5 * of.diameter * np.array([0.0, math.sin(azimuth), math.cos(azimuth)])


class TestGears:
    @given(gears(), speeds)
    def test_the_moment_is_that_of_the_force_at_the_mesh_point(
        self, one: Gear, speed: float
    ) -> None:
        force, moment = np.split(np.array(one.forces(speed)), 2)
        size = 1e-12 * np.linalg.norm(force) * one.diameter
        np.testing.assert_allclose(moment, np.cross(arm(one), force), atol=size)

    @given(gears(), speeds)
    def test_power_leaves_the_shaft_where_the_gear_drives(self, one: Gear, speed: float) -> None:
        power = one.forces(speed)[3] * speed
        assert power == pytest.approx((-1 if one.drives else 1) * one.torque * abs(speed))
        velocity = np.cross([speed, 0.0, 0.0], arm(one))
        assert np.dot(one.forces(speed)[:3], velocity) == pytest.approx(power)

    @given(gears(), speeds)
    def test_a_power_is_a_torque_at_a_speed(self, one: Gear, speed: float) -> None:
        same = one.replace(torque=None, power=one.torque * abs(speed))
        assert same.forces(speed) == pytest.approx(one.forces(speed))

    @given(gears(), speeds, angles)
    def test_a_mesh_point_elsewhere_turns_the_forces_with_it(
        self, one: Gear, speed: float, by: float
    ) -> None:
        there = one.replace(mesh_azimuth=0.0).forces(speed)
        turned = one.replace(mesh_azimuth=by).forces(speed)
        cosine, sine = math.cos(by), math.sin(by)  # from +z toward +y: about -x
        turn = np.array([[1.0, 0.0, 0.0], [0.0, cosine, sine], [0.0, -sine, cosine]])
        for part in (slice(0, 3), slice(3, 6)):
            expected = turn @ np.array(there[part])
            np.testing.assert_allclose(
                turned[part], expected, atol=1e-12 * np.linalg.norm(there[part])
            )

    @given(gears(), speeds)
    def test_the_other_hand_is_the_mirror_image(self, one: Gear, speed: float) -> None:
        """A mirror at x = 0 turns hands and apices round, and leaves the rotation as it is."""
        other: dict[str, Any] = {}
        if one.kind != "spur":
            other["hand"] = "left" if one.hand == "right" else "right"
        if one.apex:
            other["apex"] = "+x" if one.apex == "-x" else "-x"
        force = np.array(one.forces(speed))
        mirrored_force = force * [-1, 1, 1, 1, -1, -1]
        assert one.replace(**other).forces(speed) == pytest.approx(
            mirrored_force, abs=1e-9 * np.abs(force).max()
        )

    @given(gears(), speeds)
    def test_turned_round_in_rotation_and_hand_it_is_the_mirror_image_across(
        self, one: Gear, speed: float
    ) -> None:
        """A mirror at y = 0 turns hands and rotation round."""
        one = one.replace(mesh_azimuth=0.0)
        other = {} if one.kind == "spur" else {"hand": "left" if one.hand == "right" else "right"}
        force = np.array(one.forces(speed))
        expected = force * [1, -1, 1, -1, 1, -1]
        assert one.replace(**other).forces(-speed) == pytest.approx(
            expected, abs=1e-9 * np.abs(force).max()
        )

    @given(gears(("spur", "helical")), speeds, st.floats(0.02, 1.0))
    def test_mates_press_on_each_other_with_the_same_force(
        self, one: Gear, speed: float, diameter: float
    ) -> None:
        """Equal and opposite forces; and the mate alone, given its torque, has the same."""
        own: dict[str, Any] = {"pitch_diameter": diameter, "torque": None}
        mate = one.replace(**own, mate="one", mesh_azimuth=None, drives=None)
        action, reaction = (
            np.array(one.forces(speed)),
            np.array(mirrored(mate, one, one.forces(speed))),
        )
        size = float(np.abs(action).max())
        np.testing.assert_allclose(action[:3], -reaction[:3], atol=1e-9 * size)
        hand = {"hand": "left" if one.hand == "right" else "right"} if one.kind == "helical" else {}
        alone = one.replace(
            pitch_diameter=diameter,
            torque=one.torque * diameter / one.diameter,
            mesh_azimuth=(one.mesh_azimuth or 0.0) + math.pi
            if (one.mesh_azimuth or 0.0) < 0
            else (one.mesh_azimuth or 0.0) - math.pi,
            drives=not one.drives,
            **hand,
        )
        np.testing.assert_allclose(
            alone.forces(-speed * one.diameter / diameter), reaction, atol=1e-9 * size
        )
        gain = action[3] * speed + reaction[3] * -speed * one.diameter / diameter
        assert gain == pytest.approx(0.0, abs=1e-9 * abs(action[3] * speed))

    @given(gears(("worm",)), st.booleans())
    def test_a_worm_and_its_wheel_press_on_each_other_with_the_same_force(
        self, worm: Gear, positive: bool
    ) -> None:
        """Of shafts at right angles: axial on one is tangential on the other."""
        speed = 100.0 if positive else -100.0
        axial, tangential = worm.forces(speed)[0], abs(worm.forces(speed)[3]) / worm.diameter * 2
        wheel = worm.replace(
            kind="worm_wheel",
            pitch_diameter=0.3,
            torque=abs(axial) * 0.15,
            drives=not worm.drives,
            mesh_azimuth=0.0,
        )
        found = wheel.forces(1.0)
        assert abs(found[0]) == pytest.approx(tangential)
        assert -found[2] == pytest.approx(-worm.replace(mesh_azimuth=0.0).forces(speed)[2])

    def test_a_right_hand_drives_toward_its_thumb(self) -> None:
        """Of a right-hand gear that drives, thrust is where the thumb points (Decker, Shigley)."""
        assert gear("helical", hand="right").forces(1.0)[0] > 0.0
        assert gear("helical", hand="left").forces(1.0)[0] < 0.0
        assert gear("helical", hand="right").forces(-1.0)[0] < 0.0
        assert gear("helical", hand="right", drives=False).forces(1.0)[0] < 0.0
        assert gear("worm", hand="right").forces(1.0)[0] > 0.0

    def test_a_bevel_gear_is_pushed_away_from_its_apex(self) -> None:
        assert gear("bevel", apex="-x").forces(1.0)[0] > 0.0
        assert gear("bevel", apex="+x").forces(1.0)[0] < 0.0

    def test_shigley_13_7_helical(self) -> None:
        """Helical pinion, 1 hp at 1800 rpm, 18 teeth of normal pitch 12, 30° helix, 20° normal.

        Shigley's Mechanical Engineering Design, example 13-7: 40.4, 17.0 and 23.3 lbf.
        """
        one = gear(
            "helical", pitch_diameter=None, teeth=18, module=0.0254 / 12, torque=None,
            helix_angle=math.radians(30.0), power=745.6998715822702,
        )  # fmt: skip
        fx, fy, fz, *_ = (force / 4.4482216152605 for force in one.forces(1800 * math.pi / 30))
        assert (fy, -fz, fx) == pytest.approx((40.4, 17.0, 23.3), abs=0.06)

    def test_shigley_13_35_helical(self) -> None:
        """800 lbf, 30° helix, 20° normal: 336 and 462 lbf (solution of problem 13-35)."""
        one = gear("helical", helix_angle=math.radians(30.0), torque=800.0 * 0.05)
        fx, fy, fz, *_ = one.forces(1.0)
        assert (fy, -fz, fx) == pytest.approx((800.0, 336.0, 462.0), abs=0.5)

    def test_shigley_13_8_bevel(self) -> None:
        """Bevel pinion, 5 hp at 600 rpm, mean radius 1.293 in, 15:45 teeth, 20°.

        Shigley's Mechanical Engineering Design, example 13-8: 406, 140 and 46.6 lbf.
        """
        one = gear(
            "bevel", cone_angle=math.atan(15 / 45), apex="+x", pitch_diameter=0.0254 * 2 * 1.293,
            torque=None, power=5 * 745.6998715822702,
        )  # fmt: skip
        fx, fy, fz, *_ = (force / 4.4482216152605 for force in one.forces(600 * math.pi / 30))
        assert (fy, -fz, -fx) == pytest.approx((406.0, 140.0, 46.6), rel=4e-3)

    def test_shigley_13_10_worm(self) -> None:
        """Right-hand worm of two threads, 2 in, 1 hp at 1200 rpm, wheel of pitch 6, 14.5°, f 0.03.

        Shigley's Mechanical Engineering Design, example 13-10: 52.5, 69.6 and 264 lbf.
        """
        one = gear(
            "worm", pitch_diameter=0.0508, lead_angle=math.atan(2 * (math.pi / 6) / (math.pi * 2)),
            friction_coefficient=0.03, pressure_angle=math.radians(14.5), torque=None,
            power=745.6998715822702,
        )  # fmt: skip
        fx, fy, fz, *_ = (force / 4.4482216152605 for force in one.forces(1200 * math.pi / 30))
        assert (fy, -fz, fx) == pytest.approx((52.5, 69.6, 264.0), rel=3e-3)

    def test_a_bevel_gear_with_a_cone_of_next_to_nothing_is_a_helical_one(self) -> None:
        for apex in ("+x", "-x"):
            for hand in ("right", "left"):
                bevel = gear("bevel", apex=apex, cone_angle=1e-12, helix_angle=0.3, hand=hand)
                helical = gear("helical", helix_angle=0.3, hand=hand)
                assert bevel.forces(1.0) == pytest.approx(helical.forces(1.0), abs=1e-6)

    def test_diameters_by_teeth(self) -> None:
        by_teeth = {"pitch_diameter": None, "teeth": 30, "module": 0.004}
        assert gear(**by_teeth).diameter == pytest.approx(0.12)
        assert gear("helical", **by_teeth).diameter == pytest.approx(0.12 / math.cos(0.3))
        assert gear("worm_wheel", **by_teeth).diameter == pytest.approx(0.12)

    @pytest.mark.parametrize(
        ("kind", "fields", "field", "rule"),
        [
            ("spur", {"helix_angle": 0.2}, "helix_angle", "is not for kind"),
            ("spur", {"hand": "left"}, "hand", "is not for kind"),
            ("spur", {"apex": "+x"}, "apex", "is not for kind"),
            ("helical", {"helix_angle": 0.0}, "helix_angle", "is missing"),
            ("bevel", {"cone_angle": None}, "cone_angle", "is missing"),
            ("bevel", {"apex": None}, "apex", "is missing"),
            ("bevel", {"mate": "b"}, "mate", "is not for kind"),
            ("worm", {"lead_angle": None}, "lead_angle", "is missing"),
            ("worm", {"friction_coefficient": None}, "friction_coefficient", "is missing"),
            ("worm", {"pitch_diameter": None, "teeth": 2, "module": 0.004}, "pitch_diameter",
             "does not follow"),
            ("worm", {"friction_coefficient": 0.3, "drives": False}, "friction_coefficient",
             "self-locking"),
            ("worm_wheel", {"friction_coefficient": 0.3}, "friction_coefficient", "self-locking"),
            ("spur", {"pitch_diameter": None}, "pitch_diameter", "or teeth and module"),
            ("spur", {"teeth": 20}, "teeth", "cannot be combined"),
            ("spur", {"power": 100.0}, "power", "cannot be combined"),
            ("spur", {"torque": None}, "torque", "is missing"),
            ("spur", {"mesh_azimuth": None}, "mesh_azimuth", "is missing"),
            ("spur", {"drives": None}, "drives", "is missing"),
            ("spur", {"torque": -1.0}, "torque", "must be"),
            ("spur", {"torque": math.nan}, "torque", "finite"),
            ("bevel", {"pitch_diameter": None, "teeth": 10, "module": 0.001, "face_width": 0.1},
             "face_width", "pitch cone"),
        ],
    )  # fmt: skip
    def test_refusals(self, kind: str, fields: dict[str, Any], field: str, rule: str) -> None:
        with pytest.raises(InputError, match=rule) as refused:
            gear(kind, **fields)
        assert refused.value.field == field

    def test_a_power_at_rest_is_no_torque(self) -> None:
        with pytest.raises(InputError, match="at rest give the torque"):
            gear(torque=None, power=100.0).forces(0.0)

    def test_without_a_torque_of_its_own_it_has_no_forces_alone(self) -> None:
        with pytest.raises(InputError, match="that of its mate"):
            gear(torque=None, mesh_azimuth=None, drives=None, mate="b").forces(1.0)


def belt(**fields: Any) -> Belt:
    plain = {"diameter": 0.2, "tight": 1500.0, "slack": 500.0, "azimuth": 0.0, "drives": False}
    return Belt(**{**SHAFT, **plain, **fields})


class TestBelts:
    def test_parallel_strands_pull_with_their_sum(self) -> None:
        assert belt().forces(100.0) == pytest.approx((0, 0, 2000.0, 100.0, 0, 0), abs=1e-9)
        assert belt(azimuth=0.5 * math.pi).forces(1.0)[1] == pytest.approx(2000.0)
        assert belt(drives=True).forces(100.0)[3] == pytest.approx(-100.0)
        assert belt().forces(-100.0)[3] == pytest.approx(-100.0)

    def test_tension_and_torque_are_two_pulls(self) -> None:
        same = belt(tight=None, slack=None, tension=1000.0, torque=100.0)
        assert same.strands(0.0) == (1500.0, 500.0)
        assert same.forces(1.0) == pytest.approx(belt().forces(1.0))
        by_power = belt(tight=None, slack=None, tension=1000.0, power=1e4)
        assert by_power.forces(100.0) == pytest.approx(belt().forces(100.0))

    @given(st.floats(0.5, 5.0), angles, speeds, st.booleans())
    def test_force_and_torque_are_those_of_two_strands(
        self, wrap: float, azimuth: float, speed: float, drives: bool
    ) -> None:
        """Each strand is tangent to the pulley, on the arc's ends, and r × F sums to the torque."""
        one = belt(wrap_angle=wrap, azimuth=azimuth, drives=drives)
        found = np.array(one.forces(speed))
        toward = np.array([0.0, math.sin(azimuth), math.cos(azimuth)])
        across = np.cross([1.0, 0.0, 0.0], toward)
        opening = 0.5 * (math.pi - wrap)
        options = []
        for pulls in ((1500.0, 500.0), (500.0, 1500.0)):
            force, moment = np.zeros(3), np.zeros(3)
            for side, pull in zip((1.0, -1.0), pulls, strict=True):
                strand = math.cos(opening) * toward + side * math.sin(opening) * across
                point = 0.1 * (side * math.cos(opening) * across - math.sin(opening) * toward)
                force += pull * strand
                moment += np.cross(point, pull * strand)
            options.append(np.concatenate([force, moment]))
        (same,) = [one for one in options if one[3] * found[3] > 0.0]
        np.testing.assert_allclose(found, same, atol=1e-8)
        assert found[3] * speed == pytest.approx((-1 if drives else 1) * 100.0 * abs(speed))

    @pytest.mark.parametrize(
        ("fields", "field", "rule"),
        [
            ({"slack": None}, "slack", "two strands"),
            ({"tight": None, "slack": None}, "tension", "or tight and slack"),
            ({"tight": None, "slack": None, "tension": 10.0}, "torque", "tension needs it"),
            ({"torque": 5.0}, "torque", "cannot be combined"),
            ({"slack": 1600.0}, "slack", "at most 1.5 kN"),
            ({"tight": None, "slack": None, "tension": 100.0, "torque": 100.0}, "tension",
             "no tension left"),
        ],
    )  # fmt: skip
    def test_refusals(self, fields: dict[str, Any], field: str, rule: str) -> None:
        with pytest.raises(InputError, match=rule) as refused:
            belt(**fields)
        assert refused.value.field == field


class TestMasses:
    def test_a_disk_has_the_inertia_of_a_cylinder(self) -> None:
        disk = Mass(**SHAFT, diameter=0.28, bore=0.05, width=0.07, density=7810.0).inertia
        mass = 7810.0 * math.pi / 4 * (0.28**2 - 0.05**2) * 0.07
        assert disk.mass == pytest.approx(mass)
        assert disk.polar == pytest.approx(mass / 8 * (0.28**2 + 0.05**2))
        assert disk.transverse == pytest.approx(mass / 12 * (0.75 * (0.28**2 + 0.05**2) + 0.07**2))

    @pytest.mark.parametrize(
        ("fields", "field", "rule"),
        [
            ({}, "mass", "or diameter and width"),
            ({"diameter": 0.1}, "width", "is missing"),
            ({"mass": 1.0, "width": 0.1}, "width", "cannot be combined"),
            ({"diameter": 0.1, "width": 0.1, "polar_inertia": 1.0}, "polar_inertia", "combined"),
            ({"diameter": 0.1, "width": 0.1, "bore": 0.1}, "bore", "less than diameter"),
            ({"mass": 1.0, "polar_inertia": 1.0, "transverse_inertia": 0.4}, "polar_inertia",
             "at most twice"),
            ({"mass": -1.0}, "mass", "at least"),
        ],
    )  # fmt: skip
    def test_refusals(self, fields: dict[str, Any], field: str, rule: str) -> None:
        with pytest.raises(InputError, match=rule) as refused:
            Mass(**SHAFT, **fields)
        assert refused.value.field == field


def test_gravity_has_a_direction() -> None:
    assert Gravity().vector == (0.0, 0.0, -9.80665)
    assert Gravity(acceleration=2.0, direction="+x").vector == (2.0, 0.0, 0.0)
    with pytest.raises(InputError, match="must be one of"):
        Gravity(direction="down")


def test_a_load_is_six_numbers() -> None:
    load = ShaftLoad(**SHAFT, fx=1.0, fz=-3.0, mx=4.0, mz=6.0)
    assert load.forces() == (1.0, 0.0, -3.0, 4.0, 0.0, 6.0)
