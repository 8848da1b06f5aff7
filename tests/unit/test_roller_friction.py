"""Film and friction of solved roller bearings: records, sources, limits, sets of both elements."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from math import degrees, pi, radians, sin, tan
from typing import Any

import numpy as np
import pytest

from rolamento import Case
from rolamento.analysis import analyse
from rolamento.errors import InputError
from rolamento.friction import MachineBearing, friction
from rolamento.friction.line_losses import starting_torque
from rolamento.friction.skf import constants_by_series, skf_moment
from rolamento.geometry import apex_half_angle
from rolamento.lubrication import film
from rolamento.lubrication.line_film import line_groups, pan_hamrock_central
from rolamento.solution import solve
from rolamento.solved import Solved

OIL: dict[str, Any] = {
    "lubricant": "ISO VG 68",
    "temperature": {"lubricant": "50 degC"},
    "surface": {
        "inner_roughness": "0.2 um", "outer_roughness": "0.2 um", "ball_roughness": "0.1 um",
    },
}  # fmt: skip
NU_210 = {
    "element": "cylindrical", "roller_count": 14, "roller_diameter": "11 mm",
    "effective_length": "11 mm", "pitch_diameter": "70.5 mm", "diametral_clearance": "0.03 mm",
}  # fmt: skip
OUTER = radians(14.036)
HALF = float(apex_half_angle(7.4e-3, 46e-3, OUTER))
TAPERED = {
    "element": "tapered", "roller_count": 17, "roller_diameter": "7.4 mm",
    "effective_length": "10.5 mm", "roller_length": "11.2 mm", "pitch_diameter": "46 mm",
    "contact_angle": f"{degrees(OUTER)} deg", "roller_half_angle": f"{degrees(HALF)} deg",
    "rib_height": "0.8 mm",
}  # fmt: skip


def case(bearing: dict[str, Any], speed: str = "1500 rpm", **load: str) -> Case:
    duty = {"inner_speed": speed, "load": load}
    return Case.from_mapping({"bearing": bearing, "duty": duty, **OIL})


@cache
def nu_210() -> Solved:
    return solve(case(NU_210, fz="10 kN"))


@cache
def tapered() -> Solved:
    return solve(case(TAPERED, fx="500 N"))


# --- film --------------------------------------------------------------------------------------


def test_the_film_is_that_of_the_slice_with_the_most_load() -> None:
    solved = nu_210()
    found = film(solved)
    assert solved.rollers is not None
    contacts, most = solved.inner, solved.rollers.inner.load_per_length.max(axis=-1)
    groups = line_groups(
        contacts.entrainment, most, contacts.rolling_curvature, contacts.modulus,
        found.dynamic_viscosity[:, np.newaxis], found.pressure_viscosity[:, np.newaxis],
    )  # fmt: skip
    own = pan_hamrock_central(groups) / contacts.rolling_curvature
    touching = contacts.load[0] > 0.0
    thickness = (own * found.inner.thermal_factor)[0][touching]
    assert found.inner.central_thickness[0][touching] == pytest.approx(thickness)
    assert np.isinf(found.inner.ellipticity[0][touching]).all()
    assert np.isnan(found.inner.central_thickness[0][~touching]).all()
    # u = (d_pw/4)(1 - γ²) ω for rollers as for balls
    speed = 70.5e-3 / 4 * (1 - (11 / 70.5) ** 2) * 1500 * pi / 30
    assert found.inner.entrainment_speed[0][touching] == pytest.approx(speed)
    mapping = found.to_mapping()
    assert mapping["balls"] == []
    assert len(mapping["rollers"]) == 14
    assert mapping["rollers"][0]["inner"]["ellipticity"] is None


def test_the_other_pair_of_formulas_and_the_starvation_of_ellipses() -> None:
    usual = film(nu_210())
    other = film(solve(case(NU_210, fz="10 kN").replace(film={"line": "dowson_toyoda"})))
    ratio = other.inner.central_thickness[0, 0] / usual.inner.central_thickness[0, 0]
    assert 1.1 < ratio < 1.5
    starved = {"starvation": "inlet_distance", "inlet_distance": "0.3 mm"}
    flooded = film(solve(case(NU_210, fz="10 kN").replace(film=starved)))
    assert flooded.inner.central_thickness == pytest.approx(
        usual.inner.central_thickness, nan_ok=True
    )
    assert "lines_not_starved" in [note.key for note in flooded.notes_of()]
    assert "outside_hamrock_dowson" not in [note.key for note in flooded.notes_of()]
    cold = case(NU_210, "3000 rpm", fz="20 N").replace(temperature={"lubricant": 283.15})
    light = film(solve(cold))
    assert "film_of_light_lines" in [note.key for note in light.notes_of()]


# --- friction ----------------------------------------------------------------------------------


def test_a_cylindrical_bearing_without_axial_load_slides_nowhere() -> None:
    found = friction(nu_210(), friction_coefficient=0.1)
    assert found.model == "roller_sliding"
    assert found.torque_by_source["rib"] == 0.0
    assert found.torque_by_source["rolling_slip"] == 0.0
    assert found.starting_torque == found.torque_by_source["hysteresis"]
    assert found.torque == pytest.approx(sum(found.torque_by_source.values()))
    heat = sum(loss.total for loss in found.heat.values())
    assert heat == pytest.approx(found.power)
    assert found.power == pytest.approx(found.torque * 1500 * pi / 30)


def test_the_rib_of_a_tapered_bearing_takes_e_mu_fa() -> None:
    """At rest exactly NSK's torque but for cos β; turning, centrifugal force adds to the rib's."""
    found = friction(tapered(), friction_coefficient=0.1)
    assert found.torque_by_source["rib"] == pytest.approx(0.8e-3 * 0.1 * 500.0, rel=0.02)
    rest = friction(solve(case(TAPERED, "0 rpm", fx="500 N")), friction_coefficient=0.1)
    nsk = starting_torque(500.0, 0.8e-3, HALF)
    own = rest.starting_torque - rest.torque_by_source["hysteresis"]
    assert float(own[0]) == pytest.approx(float(nsk), rel=0.01)
    given = friction(tapered(), friction_coefficient=0.1, static_coefficient=0.15)
    assert given.starting_torque == pytest.approx(1.5 * found.torque_by_source["rib"], rel=0.03)


def test_a_film_relieves_the_rib() -> None:
    """With the radius of the end known; between boundary friction and none."""
    apex = 7.4e-3 / 2 / sin(HALF)
    with_end = {**TAPERED, "roller_end_radius": f"{0.95e3 * apex} mm"}
    torques = []
    for speed in ("10 rpm", "100 rpm", "1500 rpm"):
        found = friction(solve(case(with_end, speed, fx="500 N")), friction_coefficient=0.1)
        torques.append(float(found.torque_by_source["rib"][0]))
        assert found.validity[-1].notes_of() == () or found.regime[0] == "boundary"
    assert 0.04 > torques[0] > torques[1] > torques[2]
    assert torques[2] < 1e-3
    bare = friction(tapered(), friction_coefficient=0.1)
    assert [note.key for note in bare.validity[-1].notes_of()] == ["rib_film_unknown"]


def test_an_apex_off_the_axis_slips() -> None:
    """In proportion to μ, and nothing where the cones have one apex."""
    assert friction(tapered(), friction_coefficient=0.1).torque_by_source["rolling_slip"] < 1e-9
    blunt = {**TAPERED, "roller_half_angle": f"{degrees(HALF) + 0.3} deg"}
    solved = solve(case(blunt, fx="500 N"))
    low, high = (
        friction(solved, friction_coefficient=mu).torque_by_source["rolling_slip"]
        for mu in (0.05, 0.1)
    )
    assert 2.0 * low == pytest.approx(high)
    # uniform load: μ Q spin l/4 per line; the tangent of the mismatch is the spin over the roll
    assert 0.001 < float(high[0]) < 0.05


def test_models_of_balls_say_so() -> None:
    found = friction(nu_210(), friction_coefficient=0.1, compare=True)
    validity = {own.model: own for own in found.validity}
    assert not validity["jones_full"].valid[0]
    assert [note.key for note in validity["jones_full"].notes_of()] == ["for_balls"]
    assert np.isnan(found.models["jones_full"].total).all()
    assert found.valid_models() == ("roller_sliding",)
    asked = friction(nu_210(), model="jones_full", friction_coefficient=0.1)
    assert np.isnan(asked.torque).all()
    with pytest.raises(InputError, match="roller_sliding"):
        friction(nu_210(), model="coulomb", friction_coefficient=0.1)


def test_many_cases_are_as_single_ones() -> None:
    loads = np.array([300.0, 900.0])
    many = solve(case(TAPERED, fx="500 N", fz="200 N"), {"duty.load.fx": loads})
    found = friction(many, friction_coefficient=0.1)
    for place, fx in enumerate(loads):
        own = friction(solve(case(TAPERED, fx=f"{fx} N", fz="200 N")), friction_coefficient=0.1)
        assert found.torque[place] == pytest.approx(own.torque[0], rel=1e-6)
        assert found.starting_torque[place] == pytest.approx(own.starting_torque[0], rel=1e-6)
    angles = np.radians([13.0, 15.0])
    varied = solve(case(TAPERED, fx="500 N"), {"bearing.contact_angle": angles})
    assert friction(varied, friction_coefficient=0.1).torque_by_source["rolling_slip"][1] > 1e-6


@pytest.mark.parametrize(
    ("bearing", "field", "values"),
    [
        # cones keep one apex: the half angle follows the diameter
        ({k: v for k, v in TAPERED.items() if k != "roller_half_angle"},
         "roller_diameter", (7.0e-3, 7.6e-3)),
        ({"element": "barrel", "kind": "toroidal", "roller_count": 14, "roller_diameter": "11 mm",
          "effective_length": "14 mm", "pitch_diameter": "70.5 mm", "diametral_clearance": "20 um",
          "outer_raceway_radius": "90 mm"}, "outer_raceway_radius", (0.08, 0.1)),
        ({**TAPERED, "roller_end_radius": "150 mm"}, "roller_end_radius", (0.12, 0.2)),
    ],
)  # fmt: skip
def test_a_batch_over_geometry_is_as_single_ones(
    bearing: dict[str, Any], field: str, values: tuple[float, float]
) -> None:
    load = {"fz": "3 kN"} if bearing["element"] == "barrel" else {"fz": "3 kN", "fx": "2 kN"}
    one = case(bearing, **load)
    batch = friction(solve(one, {f"bearing.{field}": values}))
    for i, value in enumerate(values):
        alone = friction(solve(one.replace(bearing=one.bearing.replace(**{field: value}))))
        assert batch.torque[i] == pytest.approx(alone.torque[0], rel=1e-8)


def test_a_preloaded_pair_takes_twice_the_torque_of_one() -> None:
    """O arrangement, 500 N: each bearing bears the preload."""
    pair = {**TAPERED, "arrangement": "DB", "spacing": "40 mm", "preload": "500 N"}
    solved = solve(case(pair, "0 rpm"))
    found = friction(solved, friction_coefficient=0.1)
    own = float((found.starting_torque - found.torque_by_source["hysteresis"])[0])
    assert own == pytest.approx(2.0 * float(starting_torque(500.0, 0.8e-3, HALF)), rel=0.01)
    one = MachineBearing(
        kind="tapered", bore_diameter=30e-3, outside_diameter=62e-3, kinematic_viscosity=43e-6,
        static_load_rating=1.0, static_load_ratio=0.0, contact_angle=OUTER,
        supply="bath", constants=constants_by_series("tapered")["302"],
        axial_factor=0.4 / tan(OUTER), row=0,
    )  # fmt: skip
    both = (one, replace(one, row=1))
    made = friction(solved, friction_coefficient=0.1, machine=both).models["skf"]
    alone = skf_moment(
        one.constants or constants_by_series("tapered")["302"], speed=0.0, bore_diameter=30e-3,
        outside_diameter=62e-3, kinematic_viscosity=43e-6, radial_load=0.0, axial_load=500.0,
        axial_factor=0.4 / tan(OUTER),
    )  # fmt: skip
    assert made.starting is not None
    assert float(made.starting[0]) == pytest.approx(2.0 * float(alone.starting), rel=1e-3)
    # the two makers' formulas, with heights of the rib that nobody prints: within half
    assert found.starting_torque / made.starting == pytest.approx(1.0, abs=0.5)


def test_balls_beside_rollers() -> None:
    """Each element is reckoned by its own laws; what both do is added."""
    rows = [
        {"element": "ball", "position": "-20 mm"},
        {"element": "cylindrical", "position": "20 mm", "inner_ribs": "none", "outer_ribs": "both",
         "roller_count": 14, "roller_diameter": "7 mm", "effective_length": "7 mm",
         "pitch_diameter": "46 mm", "diametral_clearance": "10 um", "roller_length": "7 mm"},
    ]  # fmt: skip
    both = {
        "ball_diameter": "10 mm", "ball_count": 9, "pitch_diameter": "46 mm",
        "contact_angle": "25 deg", "inner_conformity": 0.52, "outer_conformity": 0.53, "rows": rows,
    }  # fmt: skip
    solved = solve(case(both, "500 rpm", fx="500 N", fz="3 kN"))
    found = friction(solved, friction_coefficient=0.1, compare=True)
    assert found.model == "jones_full"
    assert "jones_full" in found.valid_models()
    assert found.torque == pytest.approx(sum(found.torque_by_source.values()))
    balls = np.array(solved.rows.row_of_element) == 0
    heat = found.heat["rolling_resistance"].inner[0]
    assert (heat[balls] > 0.0).all()
    assert (heat[~balls] > 0.0).any()
    mapping = film(solved).to_mapping()
    assert (len(mapping["balls"]), len(mapping["rollers"])) == (9, 14)


def test_an_analysis_has_film_and_friction() -> None:
    whole = case(NU_210, fz="10 kN")
    assert whole.lubricant is not None
    whole = whole.replace(lubricant=whole.lubricant.replace(friction_coefficient=0.1))
    analysis = analyse(whole)
    assert analysis.film is not None
    assert analysis.friction is not None
    mapping = analysis.friction.to_mapping()
    assert mapping["model"] == "roller_sliding"
    assert mapping["models"]["todd"]["torque"] is None
    assert set(mapping["heat"]) == {"rib", "rolling_slip", "hysteresis", "rolling_resistance"}


# --- what is shown -----------------------------------------------------------------------------


def _pair(**more: Any) -> Case:
    """Two 30206 back to back, preloaded with 500 N."""
    bearing = {
        "designation": "30206", "arrangement": "DB", "spacing": "30 mm", "preload": "500 N",
    }  # fmt: skip
    whole = Case.from_mapping(
        {"bearing": bearing, "duty": {"inner_speed": "1000 rpm"}, **OIL, **more}
    )
    assert whole.lubricant is not None
    return whole.replace(lubricant=whole.lubricant.replace(friction_coefficient=0.1))


def test_a_pair_by_designation_beside_the_makers_models() -> None:
    """Running and starting torque of contacts, Palmgren and SKF within a factor of two."""
    found = analyse(_pair(temperature={"lubricant": "70 degC"})).friction
    assert found is not None
    assert set(found.models) >= {"roller_sliding", "palmgren", "skf"}
    own, made = float(found.torque[0]), found.models["skf"]
    assert 0.5 < own / float(made.total[0]) < 1.5
    assert 0.5 < own / float(found.models["palmgren"].total[0]) < 2.0
    assert made.starting is not None
    assert 0.5 < float(found.starting_torque[0]) / float(made.starting[0]) < 1.5
    mapping = found.to_mapping()["models"]
    assert mapping["skf"]["starting_torque"] == pytest.approx(float(made.starting[0]))
    assert "starting_torque" not in mapping["palmgren"]


def test_pages_of_rollers_know_no_balls() -> None:
    from rolamento.document import Document
    from rolamento.document.terminal import terminal
    from rolamento.pages.film import film_sections
    from rolamento.pages.friction import friction_page

    analysis = analyse(_pair())
    assert analysis.film is not None
    text = terminal(friction_page(analysis))
    for part in ("sliding at the ribs", "starting torque, SKF", "not run in", "Palmgren"):
        assert part in text
    assert "the models of Jones, Harris and Todd are for balls" in text
    assert "Jones, full" not in text
    films = terminal(Document("films", tuple(film_sections(analysis.film)), main="films"))
    assert "Films of the rollers" in films


def test_a_curve_over_speed_has_the_models_of_rollers() -> None:
    from rolamento.document.terminal import terminal
    from rolamento.pages.friction_over import friction_over_page
    from rolamento.studies.friction_curves import friction_curve, read_range

    curve = friction_curve(_pair(), read_range("duty.inner_speed=100..3000rpm", points=3))
    assert curve.controlled is None
    assert np.isfinite(curve.torque("roller_sliding")).all()
    assert (np.diff(curve.torque("skf")) > 0.0).all()
    text = terminal(friction_over_page([curve]))
    assert "Rollers" in text
    assert "Jones" not in text


def test_an_axial_load_beyond_palmgrens_third_term() -> None:
    bearing = {"designation": "NJ 210"}
    loads = {"load": {"fz": "2 kN", "fx": "1 kN"}, "inner_speed": "3000 rpm"}
    whole = Case.from_mapping({"bearing": bearing, "duty": loads, **OIL})
    assert whole.lubricant is not None
    whole = whole.replace(lubricant=whole.lubricant.replace(friction_coefficient=0.1))
    found = analyse(whole).friction
    assert found is not None
    validity = {own.model: own for own in found.validity}
    assert "axial_share" in [note.key for note in validity["palmgren"].notes_of()]
    # both ribs share the force, the inner and the outer: μ F h (ω_ri + ω_ro) at 0.1 D
    body = whole.bearing
    height = 0.1 * body.element_diameter
    rates = body.pitch_diameter / body.element_diameter
    expected = 0.1 * 1000.0 * height * rates
    assert float(found.torque_by_source["rib"][0]) == pytest.approx(expected, rel=0.1)
