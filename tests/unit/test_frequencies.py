"""Fault frequencies: of the geometry, of solved states, their bands, and any ball attitude."""

from __future__ import annotations

import json
from dataclasses import replace
from math import cos, isnan, nan, pi, radians

import numpy as np
import pytest

from rolamento import Bearing, Case, Displacement, Duty, Load
from rolamento.case.lubricant import Lubricant
from rolamento.case.model import Model
from rolamento.errors import InputError
from rolamento.kinematics import ball_motion
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.status import NOT_CONVERGED
from rolamento.vibration.frequencies import (
    FAULTS,
    LINES,
    FaultFrequencies,
    frequencies_of,
    nominal_frequencies,
    turns_of,
)
from rolamento.vibration.frequency_band import (
    Tolerances,
    alternatives_of,
    banded_frequencies,
)
from rolamento.vibration.motion import general_motion
from rolamento.words import Note

RPM = pi / 30.0


@pytest.fixture(scope="module")
def deep_groove() -> Bearing:
    """A 6205 as the Case Western rig has it, with some clearance."""
    return Bearing(
        ball_count=9,
        ball_diameter=0.3126 * 25.4e-3,
        pitch_diameter=1.537 * 25.4e-3,
        diametral_clearance="0.012 mm",
        inner_conformity=0.52,
        outer_conformity=0.52,
    )


@pytest.fixture(scope="module")
def radial(deep_groove: Bearing) -> Case:
    return Case(bearing=deep_groove, duty=Duty(inner_speed="1797 rpm", load=Load(fz="1 kN")))


@pytest.fixture(scope="module")
def state_218(case_218: Case) -> Solved:
    return solve(case_218)


# --- geometry --------------------------------------------------------------------------------


def test_the_frequencies_of_the_test_rig(deep_groove: Bearing) -> None:
    found = nominal_frequencies(deep_groove, 1797.0 * RPM)
    assert found.shaft_frequency == pytest.approx(29.95)
    assert found.ball_pass_outer.order == pytest.approx(3.5848, abs=2e-4)
    assert found.ball_pass_inner.frequency == pytest.approx(5.4152 * 29.95, abs=0.01)
    assert found.ball_spin_twice.order == 2.0 * found.ball_spin.order
    assert found.notes == (Note("angle_zero"),)
    assert found.source == "nominal"


def test_turning_the_outer_ring_exchanges_nothing_but_the_cage(deep_groove: Bearing) -> None:
    inner = nominal_frequencies(deep_groove, 100.0)
    outer = nominal_frequencies(deep_groove, 0.0, 100.0)
    assert (inner.shaft, outer.shaft) == ("inner", "outer")
    # the rings' relative speed is the same, so are the passages and the spin
    for name in ("ball_pass_outer", "ball_pass_inner", "ball_spin"):
        assert getattr(outer, name).order == pytest.approx(getattr(inner, name).order)
    assert inner.cage.order + outer.cage.order == pytest.approx(1.0)


def test_only_an_outer_speed_turns_the_outer_ring(deep_groove: Bearing) -> None:
    assert nominal_frequencies(deep_groove, None, 100.0) == nominal_frequencies(
        deep_groove, 0.0, 100.0
    )


def test_without_a_speed_there_are_orders_and_no_hertz(deep_groove: Bearing) -> None:
    found = nominal_frequencies(deep_groove)
    assert found.cage.order == pytest.approx(0.398308, abs=1e-5)
    assert all(isnan(line.frequency) for line in found.lines.values())
    assert found.to_mapping()["cage"]["frequency"] is None
    assert json.dumps(found.to_mapping(), allow_nan=False)


def test_at_rest_the_orders_stay_and_the_note_says_so(deep_groove: Bearing) -> None:
    found = nominal_frequencies(deep_groove, 0.0, 0.0)
    assert found.notes[0].key == "orders_at_rest"
    assert found.ball_pass_outer.frequency == 0.0
    assert found.ball_pass_outer.order == nominal_frequencies(deep_groove).ball_pass_outer.order


def test_rings_that_turn_alike_roll_no_ball(deep_groove: Bearing) -> None:
    found = nominal_frequencies(deep_groove, 50.0, 50.0)
    assert found.notes[0].key == "rings_turn_alike"
    assert found.cage.order == 1.0
    assert found.ball_pass_outer.order == found.ball_spin.order == 0.0


def test_counter_rotation_can_hold_the_cage_still(deep_groove: Bearing) -> None:
    gamma = deep_groove.ball_diameter / deep_groove.pitch_diameter
    found = nominal_frequencies(deep_groove, 100.0, -100.0 * (1.0 - gamma) / (1.0 + gamma))
    assert found.cage.order == pytest.approx(0.0, abs=1e-12)
    assert found.ball_pass_outer.order > 3.0


def test_the_free_contact_angle_of_a_clearance(deep_groove: Bearing) -> None:
    free = nominal_frequencies(deep_groove, 100.0, contact_angle="free")
    spread = 1.0 - 0.012e-3 / (2.0 * 0.04 * deep_groove.ball_diameter)
    assert cos(free.inner_contact_angle) == pytest.approx(spread)
    assert free.notes == (Note("angle_free"),)
    assert free.ball_pass_outer.order > nominal_frequencies(deep_groove, 1.0).ball_pass_outer.order


def test_a_bearing_with_an_angle_keeps_it_unless_told(bearing_218: Bearing) -> None:
    assert nominal_frequencies(bearing_218).inner_contact_angle == pytest.approx(radians(40))
    assert nominal_frequencies(bearing_218, contact_angle="free").notes == ()
    assert nominal_frequencies(bearing_218, contact_angle=0.5).inner_contact_angle == 0.5


def test_slip_slows_what_the_outer_race_sees(deep_groove: Bearing) -> None:
    rolling, slipping = (nominal_frequencies(deep_groove, 100.0, slip=s) for s in (0.0, 0.02))
    for name in ("cage", "ball_pass_outer", "ball_spin", "ball_spin_twice"):
        ratio = getattr(slipping, name).order / getattr(rolling, name).order
        assert ratio == pytest.approx(0.98)
    assert slipping.ball_pass_inner.order > rolling.ball_pass_inner.order
    stuck = nominal_frequencies(deep_groove, 100.0, slip=1.0)
    assert stuck.ball_pass_outer.order == stuck.cage.order == 0.0
    assert stuck.ball_pass_inner.order == pytest.approx(9.0)


@pytest.mark.parametrize(
    ("field", "arguments"),
    [
        ("slip", {"slip": 1.5}),
        ("slip", {"slip": nan}),
        ("contact_angle", {"contact_angle": 2.0}),
        ("contact_angle", {"contact_angle": -0.1}),
        ("contact_angle", {"contact_angle": "right"}),
        ("inner_speed", {"inner_speed": nan}),
        ("outer_speed", {"outer_speed": 1e300}),
    ],
)
def test_wrong_input(deep_groove: Bearing, field: str, arguments: dict[str, object]) -> None:
    with pytest.raises(InputError) as caught:
        nominal_frequencies(deep_groove, **arguments)
    assert caught.value.field == field


# --- harmonics -------------------------------------------------------------------------------


def test_harmonics_and_sidebands_of_the_inner_race(deep_groove: Bearing) -> None:
    found = nominal_frequencies(deep_groove, 2.0 * pi * 30.0)
    lines = found.harmonics("inner_race", 2, 1)
    order = found.ball_pass_inner.order
    assert [(line.harmonic, line.sideband) for line in lines] == [
        (1, -1), (1, 0), (1, 1), (2, -1), (2, 0), (2, 1),
    ]  # fmt: skip
    assert [line.order for line in lines] == pytest.approx(
        [order - 1, order, order + 1, 2 * order - 1, 2 * order, 2 * order + 1]
    )
    assert [line.frequency for line in lines] == pytest.approx([30.0 * li.order for li in lines])


def test_what_modulates_depends_on_the_part(deep_groove: Bearing) -> None:
    found = nominal_frequencies(deep_groove, 100.0)
    assert found.spacing("inner_race") == 1.0
    assert found.spacing("outer_race") == found.spacing("cage") == 0.0
    assert found.spacing("ball") == found.cage.order
    assert len(found.harmonics("outer_race", 3, 2)) == 3
    turning = nominal_frequencies(deep_groove, 0.0, 100.0)
    assert turning.spacing("outer_race") == 1.0


def test_sidebands_below_zero_are_left_out(deep_groove: Bearing) -> None:
    lines = nominal_frequencies(deep_groove, 100.0).harmonics("ball", 1, 20)
    assert min(line.order for line in lines) > 0.0
    assert len(lines) < 41


@pytest.mark.parametrize(("harmonics", "sidebands"), [(0, 1), (1, -1), (10**9, 0), (1, 10**9)])
def test_tables_have_bounds(deep_groove: Bearing, harmonics: int, sidebands: int) -> None:
    with pytest.raises(InputError, match="must be"):
        nominal_frequencies(deep_groove).harmonics("ball", harmonics, sidebands)


def test_an_unknown_part_is_refused(deep_groove: Bearing) -> None:
    with pytest.raises(InputError, match="outer_race"):
        nominal_frequencies(deep_groove).of_fault("rotor")  # type: ignore[arg-type]
    assert set(FAULTS) == {"outer_race", "inner_race", "ball", "cage"}


# --- of a solved case ------------------------------------------------------------------------


def test_a_radial_load_leaves_the_nominal_frequencies(radial: Case) -> None:
    loaded = frequencies_of(solve(radial))
    nominal = nominal_frequencies(radial.bearing, radial.duty.inner_speed)
    for name in LINES:
        line = loaded.lines[name]
        assert line.order == pytest.approx(nominal.lines[name].order, rel=1e-9)
        assert line.minimum == pytest.approx(line.maximum, rel=1e-9)
    assert loaded.source == "loaded"
    assert loaded.notes == ()


def test_loaded_angles_move_the_frequencies(state_218: Solved) -> None:
    found = frequencies_of(state_218)
    loads, cages = state_218.inner.load[0], state_218.elements.orbital_speed[0]
    mean = (loads * cages).sum() / loads.sum()
    assert found.cage.frequency == pytest.approx(mean / (2.0 * pi))
    speed = 10_000 * RPM
    assert found.cage.minimum == pytest.approx(cages.min() / speed)
    assert found.cage.maximum == pytest.approx(cages.max() / speed)
    assert found.cage.mean == pytest.approx(cages.mean() / speed)
    assert found.ball_pass_inner.maximum == pytest.approx(16.0 * (1.0 - cages.min() / speed))
    spins = np.abs(state_218.elements.ball_speed[0])
    assert found.ball_spin.frequency == pytest.approx((loads * spins).sum() / loads.sum() / 2 / pi)


def test_slip_goes_beyond_what_the_state_has(state_218: Solved) -> None:
    rolling, slipping = frequencies_of(state_218), frequencies_of(state_218, slip=0.1)
    assert slipping.cage.order == pytest.approx(0.9 * rolling.cage.order)
    assert slipping.ball_spin.maximum == pytest.approx(0.9 * rolling.ball_spin.maximum)
    with pytest.raises(InputError):
        frequencies_of(state_218, slip=-2.0)


def test_only_balls_that_the_inner_ring_presses_on_count() -> None:
    bearing = Bearing.named("6305")
    solved = solve(Case(bearing=bearing, duty=Duty(inner_speed="2000 rpm", load=Load(fz="5 kN"))))
    assert np.any(solved.inner.load == 0.0), "the test needs balls outside the load zone"
    found = frequencies_of(solved)
    gamma = bearing.ball_diameter / bearing.pitch_diameter
    assert found.cage.maximum == pytest.approx(0.5 * (1.0 - gamma))


def test_at_rest_the_loaded_angles_give_orders(case_218: Case) -> None:
    case = case_218.replace(duty=case_218.duty.replace(inner_speed=0.0))
    solved = solve(case)
    found = frequencies_of(solved)
    assert found.notes == (Note("orders_at_rest"),)
    ball = np.argmax(solved.inner.load[0])
    angles = (contacts.contact_angle[0, ball] for contacts in (solved.inner, solved.outer))
    motion = ball_motion(*angles, 22.23 / 125.26, 1.0)
    assert found.cage.minimum <= float(motion.orbital_speed) <= found.cage.maximum
    assert found.cage.frequency == 0.0


def test_friction_control_tells_the_cage_speed(bearing_218: Bearing) -> None:
    case = Case(
        bearing=bearing_218,
        duty=Duty(inner_speed="5000 rpm", load=Load(fx="10 kN", fz="2 kN")),
        lubricant=Lubricant(kind="dry", friction_coefficient=0.1),
        model=Model(raceway_control="friction", mesh="coarse"),
    )
    solved = solve(case)
    assert solved.rolling is not None
    found = frequencies_of(solved)
    assert found.notes == (Note("cage_by_friction"),)
    assert found.cage.frequency == pytest.approx(abs(solved.rolling.cage_speed[0]) / (2.0 * pi))
    assert found.cage.minimum == found.cage.maximum
    assert found.ball_spin.minimum < found.ball_spin.maximum


def test_a_case_without_result_has_no_frequencies(state_218: Solved) -> None:
    status = replace(state_218.status, number=np.array([NOT_CONVERGED]))
    failed = replace(state_218, status=status)
    found = frequencies_of(failed)
    assert found.notes == (Note("no_solution_no_frequencies"),)
    assert all(isnan(line.order) and isnan(line.frequency) for line in found.lines.values())
    assert found.to_mapping()["turns"]["cage"] is None
    assert found.harmonics("ball") == ()


def test_no_loaded_ball_drives_the_cage(radial: Case) -> None:
    held = Displacement(x=0.0, y=0.0, z=0.0)
    idle = solve(radial.replace(duty=Duty(inner_speed="1797 rpm", displacement=held)))
    assert idle.converged.all()
    assert frequencies_of(idle).notes == (Note("no_ball_drives_cage"),)


def test_one_case_of_several_has_frequencies(radial: Case) -> None:
    speeds = [100.0, 200.0]
    solved = solve(radial, inner_speed=speeds)
    with pytest.raises(InputError, match="must be a single case"):
        frequencies_of(solved)
    found = [frequencies_of(solved[i]) for i in range(2)]
    assert [one.inner_speed for one in found] == speeds
    with pytest.raises(InputError, match="must be the result of rolamento"):
        frequencies_of(radial)  # type: ignore[arg-type]


def test_rows_of_a_set_have_their_own_frequencies(bearing_218: Bearing) -> None:
    pair = bearing_218.replace(arrangement="DB", spacing=0.03, preload="500 N")
    solved = solve(Case(bearing=pair, duty=Duty(inner_speed="3000 rpm", load=Load(fx="10 kN"))))
    found = frequencies_of(solved)
    assert [one.row for one in found.rows] == [0, 1]
    carried = [solved.inner.load[0, solved.elements.row == row].sum() for row in (0, 1)]
    assert found.row == int(np.argmax(carried))
    assert found.cage == found.rows[found.row].cage
    assert found.rows[0].cage.order != found.rows[1].cage.order
    assert len(nominal_frequencies(pair, 100.0).rows) == 2


# --- bands -----------------------------------------------------------------------------------


def _band(found: FaultFrequencies, name: str) -> tuple[float, float, float, float]:
    band = getattr(found, name).band
    return band.order_low, band.order_high, band.frequency_low, band.frequency_high


def test_the_band_of_a_tolerance_holds_its_corners(deep_groove: Bearing) -> None:
    allowed = Tolerances(ball_diameter=0.05e-3, pitch_diameter=0.2e-3, contact_angle=0.0, slip=0.01)
    found = banded_frequencies(deep_groove, 100.0, tolerances=allowed)
    low, high, least, most = _band(found, "ball_pass_outer")
    gammas = [
        (deep_groove.ball_diameter + s * 0.05e-3) / (deep_groove.pitch_diameter - s * 0.2e-3)
        for s in (1.0, -1.0)
    ]
    assert low == pytest.approx(0.99 * 4.5 * (1.0 - gammas[0]), rel=1e-12)
    assert high == pytest.approx(4.5 * (1.0 - gammas[1]), rel=1e-12)
    shaft = 100.0 / (2.0 * pi)
    assert (least, most) == pytest.approx((low * shaft, high * shaft))


def test_a_speed_moves_hertz_and_not_orders(deep_groove: Bearing) -> None:
    allowed = Tolerances(contact_angle=0.0, speed=0.01)
    found = banded_frequencies(deep_groove, 100.0, tolerances=allowed)
    low, high, least, most = _band(found, "ball_pass_inner")
    assert low == pytest.approx(high)
    nominal = found.ball_pass_inner.frequency
    assert (least, most) == pytest.approx((0.99 * nominal, 1.01 * nominal))


def test_two_ring_speeds_move_orders_too(deep_groove: Bearing) -> None:
    allowed = Tolerances(contact_angle=0.0, speed=0.01)
    found = banded_frequencies(deep_groove, 100.0, 50.0, tolerances=allowed)
    low, high, least, most = _band(found, "ball_pass_outer")
    gamma = deep_groove.ball_diameter / deep_groove.pitch_diameter
    share = 4.5 * (1.0 - gamma)
    assert low == pytest.approx(share * (1.0 - 0.5 * 1.01 / 0.99))
    assert high == pytest.approx(share * (1.0 - 0.5 * 0.99 / 1.01))
    assert least == pytest.approx(share * (99.0 - 50.5) / (2 * pi))
    assert most == pytest.approx(share * (101.0 - 49.5) / (2 * pi))


def test_a_band_that_crosses_zero_begins_there(deep_groove: Bearing) -> None:
    gamma = deep_groove.ball_diameter / deep_groove.pitch_diameter
    speeds = (100.0, -100.0 * (1.0 - gamma) / (1.0 + gamma))
    found = banded_frequencies(deep_groove, *speeds, tolerances=Tolerances(ball_diameter=1e-4))
    assert _band(found, "cage")[0] == 0.0
    assert _band(found, "cage")[1] > 0.0


def test_a_clearance_leaves_the_angle_open(deep_groove: Bearing) -> None:
    found = banded_frequencies(deep_groove, 100.0)
    low, high = _band(found, "ball_pass_outer")[:2]
    assert low == pytest.approx(nominal_frequencies(deep_groove).ball_pass_outer.order)
    free = nominal_frequencies(deep_groove, contact_angle="free")
    assert high == pytest.approx(free.ball_pass_outer.order)


def test_a_known_bearing_has_no_width(bearing_218: Bearing) -> None:
    found = banded_frequencies(bearing_218, 100.0)
    for line in found.lines.values():
        assert line.band is not None
        assert line.band.order_low == pytest.approx(line.order, rel=1e-14)
        assert line.band.order_high == pytest.approx(line.order, rel=1e-14)


def test_an_inferred_inside_widens_the_band() -> None:
    bearing = Bearing.named("6205")
    found = banded_frequencies(bearing, 100.0)
    low, high = _band(found, "ball_pass_outer")[:2]
    # the geometry of the Case Western rig's own 6205 is inside
    assert low < 3.5848 < high
    alone = banded_frequencies(bearing, 100.0, tolerances=Tolerances(candidates=False))
    assert _band(alone, "ball_pass_outer")[0] > low
    told = bearing.replace(ball_count=9, ball_diameter=7.94e-3, pitch_diameter=39.04e-3)
    assert alternatives_of(told) == ()


def test_alternatives_of_an_inferred_inside() -> None:
    found = alternatives_of(Bearing.named("6205"), 100.0)
    assert [one.rank for one in found] == list(range(1, len(found) + 1))
    assert sum(one.share for one in found) == pytest.approx(1.0)
    nominal = nominal_frequencies(Bearing.named("6205"), 100.0)
    assert found[0].orders["ball_spin"] == pytest.approx(nominal.ball_spin.order)


def test_published_balls_have_no_alternatives() -> None:
    assert alternatives_of(Bearing.named("EX 70 25deg")) == ()


@pytest.mark.parametrize("field", ["ball_diameter", "speed", "slip", "contact_angle"])
@pytest.mark.parametrize("value", [-0.1, nan, 100.0])
def test_tolerances_are_checked(field: str, value: float) -> None:
    with pytest.raises(InputError, match=field):
        Tolerances(**{field: value})


def test_bands_of_a_set(bearing_218: Bearing) -> None:
    pair = bearing_218.replace(arrangement="DB", spacing=0.03)
    found = banded_frequencies(pair, 100.0, tolerances=Tolerances(ball_diameter=1e-5))
    assert len(found.rows) == 2
    assert all(one.cage.band is not None for one in found.rows)


# --- any attitude ----------------------------------------------------------------------------


def test_the_general_relations_come_to_the_usual_ones() -> None:
    angle, ratio = 0.4, 0.2
    usual = turns_of(ratio, angle, 100.0, -30.0)
    found = general_motion(1.0, (0.1, 0.1), (angle, angle), angle, 0.0, 100.0, -30.0)
    assert float(found.orbital_speed) == pytest.approx(usual.cage)
    assert float(found.ball_speed) == pytest.approx(usual.ball)
    outer, inner = found.passes(9, 100.0, -30.0)
    assert float(outer) == pytest.approx(9.0 * (usual.cage + 30.0) / (2.0 * pi))
    assert float(outer + inner) == pytest.approx(9.0 * 130.0 / (2.0 * pi))


def test_the_general_relations_come_to_raceway_control() -> None:
    inner, outer, ratio = 0.7, 0.5, 0.18
    for control in ("outer", "inner"):
        motion = ball_motion(inner, outer, ratio, 500.0, 40.0, control)
        found = general_motion(
            1.0, (0.5 * ratio,) * 2, (inner, outer), motion.attitude, 0.0, 500.0, 40.0
        )
        assert float(found.orbital_speed) == pytest.approx(float(motion.orbital_speed))
        assert float(found.ball_speed) == pytest.approx(float(motion.ball_speed))


def test_a_yawed_ball_turns_faster_and_carries_the_cage_alike() -> None:
    straight = general_motion(1.0, (0.1, 0.1), (0.0, 0.0), 0.0, 0.0, 100.0)
    yawed = general_motion(1.0, (0.1, 0.1), (0.0, 0.0), 0.0, 0.3, 100.0)
    assert float(yawed.orbital_speed) == pytest.approx(float(straight.orbital_speed))
    assert float(yawed.ball_speed) == pytest.approx(float(straight.ball_speed) / cos(0.3))


def test_smaller_rolling_radii_speed_the_cage_up() -> None:
    rigid = general_motion(1.0, (0.1, 0.1), (0.3, 0.3), 0.3, 0.0, 100.0)
    pressed = general_motion(1.0, (0.098, 0.098), (0.3, 0.3), 0.3, 0.0, 100.0)
    assert float(pressed.orbital_speed) > float(rigid.orbital_speed)


def test_a_ball_across_both_tangents_has_no_speed() -> None:
    found = general_motion(1.0, (0.1, 0.1), (0.0, 0.0), 0.5 * pi, 0.5 * pi, [100.0, 50.0])
    assert np.isnan(found.ball_speed).tolist() == [True, True]
    assert np.isnan(found.orbital_speed).tolist() == [True, True]
