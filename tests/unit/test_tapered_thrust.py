"""Tapered roller thrust bearings: washers that are both cones; equilibrium, ratings, refusals."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import rolamento as ro
from rolamento.analysis.speed_limits import speed_limits
from rolamento.catalogue import catalogue, geometry_of
from rolamento.contact.profile import ISO_FACTOR_TAPERED
from rolamento.errors import InputError
from rolamento.plots.bearing_section import section_drawing
from rolamento.solved.outline import roller_outline

CONES: dict[str, Any] = {
    "element": "tapered", "kind": "thrust", "roller_count": 24, "roller_diameter": 0.016,
    "effective_length": 0.020, "pitch_diameter": 0.2,
}  # fmt: skip
HALF = float(np.arctan(0.016 / 0.2))


def of(**changes: Any) -> ro.RollerBearing:
    return ro.RollerBearing(**{**CONES, **changes})


def test_cones_have_their_apex_on_the_shaft() -> None:
    bearing = of()
    assert bearing.bearing_type.key == "tapered_thrust"
    assert bearing.roller_half_angle == pytest.approx(HALF)
    assert bearing.row_angle == pytest.approx(np.pi / 2)
    assert bearing.inner_contact_angle == pytest.approx(np.pi / 2 - HALF)
    assert bearing.outer_contact_angle == pytest.approx(np.pi / 2 + HALF)
    found = ro.fault_frequencies(bearing)
    assert not found.notes  # they roll truly
    assert found.nominal.turns.cage == pytest.approx(0.5)


def test_every_roller_is_in_balance_at_speed() -> None:
    """Both washers, the rib and the centrifugal force, in (x, r), without the solver's geometry."""
    omega = 250.0
    solved = ro.solve(of(), fx=60e3, inner_speed=omega)
    (q_i,), (q_o,) = solved.inner.load[:, 0], solved.outer.load[:, 0]
    rib = float(solved.rollers.rib_force[0, 0])
    force = float(solved.elements.centrifugal_force[0, 0])
    large = 0.008 + 0.010 * np.tan(HALF)  # radius of the large end; a rib of a tenth of D
    lean = np.arcsin((large - 0.0016) / 0.110)  # a sphere about the apex
    along = q_i * np.sin(np.pi / 2 - HALF) + rib * np.sin(lean) - q_o * np.sin(np.pi / 2 + HALF)
    outward = q_i * np.cos(np.pi / 2 - HALF) - rib * np.cos(lean)
    outward += force - q_o * np.cos(np.pi / 2 + HALF)
    assert abs(along) < 1e-9 * q_o
    assert abs(outward) < 1e-9 * q_o
    assert force > 0.01 * rib  # it is no trifle here
    assert q_o * np.cos(HALF) == pytest.approx(60e3 / 24, rel=1e-9)  # what the housing bears


def test_slight_cones_are_cylinders_between_flat_washers() -> None:
    slight = ro.solve(of(roller_half_angle=1e-7), fx=100e3)
    flat = ro.solve(of(element="cylindrical"), fx=100e3)
    assert slight.displacement.x == pytest.approx(flat.displacement.x, rel=1e-6)
    assert slight.inner.load == pytest.approx(flat.inner.load, rel=1e-6)
    assert slight.inner.max_pressure == pytest.approx(flat.inner.max_pressure, rel=1e-6)


def test_lines_of_action_meet_on_the_shaft() -> None:
    """About that point, d_pw/2 tan α_i away, nothing resists but the rollers' own stiffness."""
    stiffness = ro.solve(of(), fx=100e3).stiffness
    apart = 0.1 / np.tan(HALF)
    assert -stiffness["fz", "ry"][0] / stiffness["fz", "z"][0] == pytest.approx(apart, rel=2e-3)
    left = (
        stiffness["my", "ry"]
        - stiffness["my", "z"] * stiffness["fz", "ry"] / (stiffness["fz", "z"])
    )
    assert 0.0 < left[0] < 0.01 * stiffness["my", "ry"][0]


def test_it_is_rated_for_axial_load() -> None:
    """ISO 281:2007, 8.1: C_a = b_m f_c L^(7/9) Z^(3/4) D^(29/27), N and mm; ISO 76: 220 Z L D."""
    case = ro.Case(bearing=of(), duty={"inner_speed": "300 rpm", "load": {"fx": "100 kN"}})
    ratings = ro.rating_life(case).ratings
    factor = 293.16 * 0.08 ** (2.0 / 9.0)
    by_hand = 1.1 * factor * 20.0 ** (7.0 / 9.0) * 24**0.75 * 16.0 ** (29.0 / 27.0)
    assert float(ratings.dynamic[0, 0]) == pytest.approx(by_hand, rel=1e-3)
    assert float(ratings.static[0, 0]) == pytest.approx(220.0 * 24 * 20.0 * 16.0)
    speeds = speed_limits(case)
    assert speeds.boundary.static_rating == pytest.approx(float(ratings.static[0, 0]))
    assert not speeds.minimum_loads  # those of rollers are radial


def test_a_radial_load_is_for_another_bearing() -> None:
    little = ro.solve(of(), fx=100e3, fz=2e3)
    assert [n.key for n in little.notes[0] if n.key == "thrust_under_radial_load"]
    assert "ball" not in " ".join(str(n) for n in little.notes[0])
    for load in ({"fx": 100e3, "fz": 20e3}, {"fx": -1e3}):
        solved = ro.solve(of(), **load)
        assert solved.status.code[0] == "no_equilibrium"
        assert solved.advice[0] is not None
        assert solved.advice[0].key.startswith("thrust_")


@pytest.mark.parametrize("element", ["tapered", "cylindrical"])
def test_thrust_rollers_have_the_standards_profile_of_thrust_bearings(element: str) -> None:
    """ISO/TS 16281:2008, 4.3.2: 0.00045 D ln 1/(1 - (2x/L)²), not the 0.00035 of radial ones."""
    solved = ro.solve(of(element=element), fx=50e3)
    outline = roller_outline(solved, 0)
    share = 2.0 * outline.place / 0.020
    expected = ISO_FACTOR_TAPERED * 0.016 * np.log(1.0 / (1.0 - share**2))
    assert outline.drop == pytest.approx(expected)


@pytest.mark.parametrize(
    ("changes", "field"),
    [
        ({"contact_angle": 1.4}, "contact_angle"),
        ({"diametral_clearance": 10e-6}, "diametral_clearance"),
        ({"arrangement": "DB", "spacing": 0.02}, "arrangement"),
        ({"element": "barrel"}, "kind"),
    ],
)
def test_what_conical_washers_have_not_is_refused(changes: dict[str, Any], field: str) -> None:
    with pytest.raises(InputError) as caught:
        of(**changes)
    assert caught.value.field == field


def test_one_of_a_catalogue_of_ones_own(tmp_path: Path) -> None:
    file = tmp_path / "own.csv"
    head = "designation,kind,bore_mm,outside_diameter_mm,height_mm,roller_count,roller_diameter_mm,"
    head += "effective_length_mm,pitch_diameter_mm,dynamic_rating_N,static_rating_N\n"
    file.write_text(head + "T1,tapered_thrust,150,250,50,24,16,20,200,403000,1690000\n", "utf-8")
    found = geometry_of("T1", catalogue_of=catalogue().beside([file])).fields
    assert found["kind"] == "thrust"
    assert found["contact_angle"] == pytest.approx(np.pi / 2)
    assert found["roller_half_angle"] == pytest.approx(HALF)


def test_the_section_shows_the_cones_and_the_rib() -> None:
    case = ro.Case(bearing=of(), duty={"load": {"fx": "50 kN"}})
    shaft, housing, *_ = [o.points for o in section_drawing(case).outlines if o.kind == "ring"]
    slopes = []
    for points in (shaft, housing):
        (x_out, r_out), (x_in, r_in) = points[-2:]
        slopes.append((x_out - x_in) / (r_out - r_in))
    assert slopes == pytest.approx([-np.tan(HALF), np.tan(HALF)])
    assert len(shaft) == len(housing) + 2  # the rib of the shaft washer
