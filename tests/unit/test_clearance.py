"""The clearance in operation: the chain, its limits, its scatter, its refusals."""

from __future__ import annotations

import json
import tomllib
from itertools import pairwise
from math import acos, cos, pi
from typing import Any

import numpy as np
import pytest
from tests.one_case import keys, said, solve_one

from rolamento import Bearing, Case, Duty, Load
from rolamento.case import case_to_toml, override, parse_case
from rolamento.case.temperature import Temperature
from rolamento.clearance import (
    Mounting,
    OperatingClearance,
    PartTemperatures,
    SeatMaterial,
    class_clearance,
    clearance_notes,
    clearance_of_case,
    operating_case,
    operating_clearance,
    sample_clearance,
)
from rolamento.clearance.effects import bore_shrinkage, contact_pressure, expansion_of
from rolamento.clearance.operating import bearing_with_clearance
from rolamento.errors import InputError, UnitError
from rolamento.geometry import ring_geometry
from rolamento.solution import solve

RPM = pi / 30.0
WARM = PartTemperatures(inner_ring=343.15, outer_ring=335.15)


def bearing_6305(**changes: Any) -> Bearing:
    fields: dict[str, Any] = {
        "ball_count": 8,
        "ball_diameter": "10.319 mm",
        "pitch_diameter": "44.5 mm",
        "diametral_clearance": "0.02 mm",
        "inner_conformity": 0.505,
        "outer_conformity": 0.53,
    }
    return Bearing(**(fields | changes))


def mounting(**changes: Any) -> Mounting:
    fields: dict[str, Any] = {"bore": "25 mm", "outside_diameter": "62 mm"}
    return Mounting(**(fields | changes))


FULL: dict[str, Any] = {
    "clearance_class": "C3",
    "shaft_tolerance": "k5",
    "housing_tolerance": "J7",
    "shaft_finish": "ground",
    "housing_finish": "turned",
    "shaft_bore": "8 mm",
    "housing_material": "cast iron",
    "housing_outside_diameter": "100 mm",
    "wear": "5 um",
}


def found(
    temperatures: PartTemperatures | None = None, speed: float = 0.0, **changes: Any
) -> OperatingClearance:
    return operating_clearance(bearing_6305(), mounting(**changes), temperatures, inner_speed=speed)


# --- the chain ----------------------------------------------------------------------


def test_a_bearing_in_its_box_keeps_its_clearance() -> None:
    result = found()
    assert [step.name for step in result.steps] == ["initial"]
    assert result.minimum == result.mean == result.maximum == pytest.approx(20e-6)
    assert result.warnings == ()


def test_the_steps_add_up() -> None:
    result = found(WARM, 2000 * RPM, **FULL)
    assert [step.name for step in result.steps] == [
        "initial",
        "shaft_fit",
        "housing_fit",
        "temperature",
        "speed",
        "wear",
    ]
    total = np.sum([step.change for step in result.steps], axis=0)
    assert total == pytest.approx([result.minimum, result.mean, result.maximum], rel=1e-12)
    for before, after in pairwise(result.steps):
        assert after.clearance == pytest.approx(np.add(before.clearance, after.change))
    assert all(step.formula and step.source for step in result.steps)
    assert result.minimum < result.mean < result.maximum


def test_a_class_and_the_limits_of_fits() -> None:
    """25 k5 in a normal bore: 2 to 21 µm of interference; solid steel: times bore over raceway."""
    result = found(clearance_class="C3", shaft_tolerance="k5")
    fit = result.steps[1]
    assert fit.details["interference"] == pytest.approx((21e-6, 11.5e-6, 2e-6))
    ring = ring_geometry(bearing_6305())
    raceway = 2 * (ring.inner_groove_radius - 0.505 * 10.319e-3)
    band = class_clearance(0.025, "C3")
    expected = [
        initial - tight * 0.025 / raceway
        for initial, tight in ((band.low, 21e-6), (band.middle, 11.5e-6), (band.high, 2e-6))
    ]
    assert [result.minimum, result.mean, result.maximum] == pytest.approx(expected, rel=1e-9)


def test_an_interference_that_is_known_has_one_result() -> None:
    result = found(shaft_interference="10 um", housing_interference="8 um")
    assert result.minimum == result.maximum
    loose = found(shaft_interference="-10 um", housing_interference="-8 um")
    assert loose.mean == pytest.approx(20e-6)


def test_the_housing_presses_the_outer_ring() -> None:
    bearing = bearing_6305()
    result = found(housing_interference="8 um")
    ring = ring_geometry(bearing)
    inner = 2 * (ring.inner_groove_radius - 0.505 * 10.319e-3)
    raceway = inner + 2 * 10.319e-3 + 20e-6
    steel = bearing.ring_material
    pressure = contact_pressure(
        8e-6, 0.062, bore=raceway, outside=float("inf"), inner=steel, outer=steel
    )
    shrinkage = float(bore_shrinkage(pressure, 0.062, raceway, steel))
    assert result.mean == pytest.approx(20e-6 - shrinkage, rel=1e-12)
    softer = found(housing_interference="8 um", housing_material="aluminium")
    thinner = found(housing_interference="8 um", housing_outside_diameter="70 mm")
    assert softer.mean > result.mean
    assert thinner.mean > result.mean


def test_temperature_is_linear_where_the_fit_does_not_change() -> None:
    cold = found(shaft_tolerance="k5").mean
    changes = [
        found(PartTemperatures(293.15 + rise, 293.15), shaft_tolerance="k5").mean - cold
        for rise in (10.0, 20.0)
    ]
    assert changes[1] == pytest.approx(2 * changes[0], rel=1e-9)
    assert changes[0] == pytest.approx(-12.5e-6 * 10 * (0.0445 + 0.010319), rel=1e-3)


def test_a_warm_aluminium_housing_lets_go_of_the_ring() -> None:
    warm = PartTemperatures(343.15, 343.15)
    result = found(warm, housing_interference="10 um", housing_material="aluminium")
    step = result.steps[1]
    assert step.details["expansion"][1] == pytest.approx(-(23e-6 - 12.5e-6) * 50 * 0.062)
    assert step.change == (0.0, 0.0, 0.0)
    assert keys(result.warnings) == {"outer_ring_loose"}


def test_speed_loosens_the_fit_and_grows_the_ring() -> None:
    slow, fast = (found(None, speed, shaft_interference="10 um") for speed in (1000.0, 2000.0))
    for name in ("speed", "shaft_fit"):
        assert name in [step.name for step in fast.steps]
    growth = [result.steps[2].change[1] for result in (slow, fast)]
    assert growth[1] == pytest.approx(4 * growth[0], rel=1e-12)
    rotation = [result.steps[1].details["rotation"][1] for result in (slow, fast)]
    assert rotation[1] == pytest.approx(4 * rotation[0], rel=1e-12)
    assert rotation[0] > 0.0
    fast = found(None, 30000.0, shaft_interference="10 um")
    assert "inner_ring_loose" in keys(fast.warnings)


def test_a_turning_outer_ring_opens_the_bearing() -> None:
    opened = operating_clearance(bearing_6305(), mounting(), outer_speed=2000.0)
    closed = operating_clearance(bearing_6305(), mounting(), inner_speed=2000.0)
    assert opened.mean > 20e-6 > closed.mean
    with pytest.raises(
        InputError, match="is missing; the expansion of a rotating housing depends on"
    ) as error:
        operating_clearance(
            bearing_6305(), mounting(housing_interference="5 um"), outer_speed=100.0
        )
    assert error.value.field == "mounting.housing_outside_diameter"


def test_a_measured_clearance_is_corrected_first() -> None:
    result = found(measured_clearance="26 um")
    assert [step.name for step in result.steps] == ["initial", "measuring_load"]
    assert result.steps[0].change[1] == pytest.approx(26e-6)
    assert result.steps[1].details["load"][1] == 49.0
    assert 26e-6 - 6e-6 < result.mean < 26e-6 - 5e-6
    heavier = found(measured_clearance="26 um", measuring_load="98 N")
    assert heavier.mean < result.mean


def test_wear_is_added() -> None:
    assert found(wear="7 um").mean == pytest.approx(27e-6)


# --- what solve uses -------------------------------------------------------------------


def mounted_case(**changes: Any) -> Case:
    fields: dict[str, Any] = {
        "bearing": bearing_6305(),
        "duty": Duty(inner_speed=2000 * RPM, load=Load(fz=5000.0)),
        "mounting": mounting(**FULL),
        "temperature": Temperature(lubricant=343.15, inner_ring=343.15, outer_ring=335.15),
    }
    return Case(**(fields | changes))


def test_a_clearance_that_is_given_is_not_taken_for_the_catalogues() -> None:
    table = {"shaft_tolerance": "k5", "housing_tolerance": "H7"}
    listed = Case.from_mapping({"bearing": {"designation": "6305"}, "duty": {}, "mounting": table})
    given = listed.with_(bearing__diametral_clearance=listed.bearing.diametral_clearance)
    assert given.bearing == listed.bearing
    sources = [clearance_of_case(one).steps[0].source for one in (listed, given, listed)]
    assert sources[0] == sources[2] != sources[1]


def test_the_bearing_in_operation_is_what_solve_takes() -> None:
    case = mounted_case()
    result = found(WARM, 2000 * RPM, **FULL)
    running = operating_case(case)
    assert clearance_of_case(case).to_mapping() == result.to_mapping()
    assert running.bearing.diametral_clearance == result.mean
    assert running.mounting is None
    own = case.temperature
    assert own is not None
    assert running.temperature == Temperature(
        lubricant=343.15, inner_ring=own.inner_ring, outer_ring=own.outer_ring
    )
    assert operating_case(running) is running
    solve_one(running)  # a first hard case has the compiled kernels loaded, which round otherwise
    state, plain = solve_one(case), solve_one(running)
    assert state.displacement == plain.displacement
    assert state.case == running
    assert state.notes == (*clearance_notes(result), *plain.notes)


def test_the_limit_decides_which_clearance_is_solved_with() -> None:
    loads = [
        solve_one(mounted_case(mounting=mounting(**FULL, limit=limit))).displacement.z
        for limit in ("mean", "maximum")
    ]
    assert loads[0] < loads[1]
    for limit in ("minimum", "mean", "maximum"):
        case = mounted_case(mounting=mounting(**FULL, limit=limit))
        expected = getattr(clearance_of_case(case), limit)
        assert operating_case(case).bearing.diametral_clearance == expected


def test_a_case_file_with_a_mounting() -> None:
    text = case_to_toml(mounted_case())
    assert "[mounting]" in text
    assert parse_case(text, format="toml") == mounted_case()
    changed = override(mounted_case(), ["mounting.shaft_tolerance=m5"])
    assert clearance_of_case(changed).mean < clearance_of_case(mounted_case()).mean
    with pytest.raises(InputError, match=r"line .*mounting\.shaft_bore"):
        parse_case(text.replace('shaft_bore = "8 mm"', "shaft_bore = 8"))


def test_temperatures_of_seats_need_a_mounting() -> None:
    warm = Temperature(inner_ring=350.0, outer_ring=340.0, shaft=360.0)
    with pytest.raises(InputError, match=r"has no effect without \[mounting\]") as error:
        mounted_case(mounting=None, temperature=warm)
    assert error.value.field == "temperature.shaft"
    with pytest.raises(
        InputError, match="is missing: without it the bearing runs at its own clearance"
    ):
        clearance_of_case(mounted_case(mounting=None, temperature=None))


def test_a_batch_runs_with_the_clearance_in_operation() -> None:
    mounted = solve(mounted_case(), fz=[1e3, 2e3])
    running = solve(operating_case(mounted_case()), fz=[1e3, 2e3])
    assert mounted.displacement.array == pytest.approx(running.displacement.array, rel=1e-12)


def test_the_notes_speak_portuguese() -> None:
    result = found(WARM, **FULL)
    assert all(said(note, "pt") != said(note) for note in clearance_notes(result))
    negative = clearance_notes(found(shaft_interference="40 um"))[0]
    assert "of −" in negative.text
    assert said(negative, "pt").startswith("Montado")


def test_an_angular_contact_bearing_changes_its_angle() -> None:
    bearing = bearing_6305(diametral_clearance=None, contact_angle="25 deg")
    distance = 10.319e-3 * 0.035
    before = 2 * distance * (1 - cos(25 * pi / 180))
    result = operating_clearance(bearing, mounting(shaft_interference="8 um"))
    assert result.steps[0].change[1] == pytest.approx(before, rel=1e-9)
    after = result.operating_bearing()
    assert after.diametral_clearance is None
    assert after.contact_angle == pytest.approx(acos(1 - result.mean / (2 * distance)))
    assert after.contact_angle < bearing.contact_angle  # type: ignore[operator]


def test_fits_that_close_the_bearing() -> None:
    result = found(shaft_interference="24 um", housing_interference="20 um")
    assert keys(result.warnings) == {"interference"}
    assert result.operating_bearing().diametral_clearance == result.mean < 0.0
    angular = bearing_6305(diametral_clearance=None, contact_angle="12 deg")
    closed = operating_clearance(
        angular, mounting(shaft_interference="24 um", housing_interference="20 um")
    )
    with pytest.raises(InputError, match="leaves no contact angle") as error:
        closed.operating_bearing()
    assert error.value.field == "mounting"
    crushed = found(shaft_interference="300 um")
    assert keys(crushed.warnings) == {"interference", "tight_shaft"}
    with pytest.raises(InputError, match="closes the bearing"):
        crushed.operating_bearing()
    with pytest.raises(
        InputError, match="opens the bearing too far: its operating clearance would be"
    ):
        bearing_with_clearance(bearing_6305(), 2e-3)


def test_warnings_have_sentences() -> None:
    result = found(clearance_class="C4", shaft_tolerance="p6")
    assert keys(result.warnings) == {"interference_at_minimum", "tight_shaft"}
    assert all(note.text.endswith(".") for note in result.warnings)


def test_results_are_plain_for_json() -> None:
    text = json.dumps(found(WARM, 100.0, **FULL).to_mapping(), allow_nan=False)
    read = json.loads(text)
    assert len(read["steps"]) == 6
    assert read["steps"][1]["details"]["pressure"][1] > 0.0


# --- scatter ---------------------------------------------------------------------------

TIGHT = {"clearance_class": "C3", "shaft_tolerance": "m5", "housing_tolerance": "P7"}


def drawn(samples: int = 40_000, seed: int = 1, distribution: str = "normal") -> Any:
    return sample_clearance(
        bearing_6305(),
        mounting(**TIGHT),
        WARM,
        samples=samples,
        seed=seed,
        distribution=distribution,  # type: ignore[arg-type]
    )


def test_samples_scatter_about_the_mean_within_the_limits() -> None:
    """Tight fits throughout keep the chain linear: mean and variance follow from the bands."""
    limits = found(WARM, **TIGHT)
    samples = drawn()
    assert samples.clearance.min() >= limits.minimum
    assert samples.clearance.max() <= limits.maximum
    assert samples.mean == pytest.approx(limits.mean, abs=4 * samples.standard_deviation / 200)
    half = [
        0.5 * (step.change[2] - step.change[0]) / 3 for step in limits.steps[:3]
    ]  # of classes and of the two parts of each fit below
    shaft, housing = limits.steps[1], limits.steps[2]
    slope = [
        (step.change[2] - step.change[0])
        / (step.details["interference"][2] - step.details["interference"][0])
        for step in (shaft, housing)
    ]
    parts = [(9e-6, 10e-6), (30e-6, 13e-6)]  # IT5 of 25, bore; IT7 of 62, outside diameter
    variance = half[0] ** 2 + sum(
        (s * width / 6) ** 2 for s, widths in zip(slope, parts, strict=True) for width in widths
    )
    # a normal distribution cut at three standard deviations has 0.9867 of them
    assert samples.standard_deviation == pytest.approx(0.9867 * variance**0.5, rel=0.02)


def test_percentiles_are_those_of_a_normal_distribution() -> None:
    samples = drawn()
    for percent, sigmas in ((15.866, -1.0), (50.0, 0.0), (97.725, 2.0)):
        expected = samples.mean + sigmas * samples.standard_deviation
        assert samples.percentile(percent) == pytest.approx(
            expected, abs=0.04 * samples.standard_deviation
        )


def test_uniform_dimensions_scatter_more() -> None:
    ratio = drawn(distribution="uniform").standard_deviation / drawn().standard_deviation
    assert ratio == pytest.approx(3**0.5 / 0.9867, rel=0.02)


def test_the_seed_decides() -> None:
    assert np.array_equal(drawn(100).clearance, drawn(100).clearance)
    assert not np.array_equal(drawn(100).clearance, drawn(100, seed=2).clearance)


def test_one_sample_and_none_of_a_seat() -> None:
    samples = sample_clearance(bearing_6305(), mounting(), samples=1)
    assert samples.mean == pytest.approx(20e-6)
    assert np.isnan(samples.standard_deviation)
    assert np.isnan(samples.shaft_interference).all()


# SKF, Housing tolerances and resultant fits: diameter, class, probable fit in µm, a gap positive.
PROBABLE_OF_SKF = [
    (62, "J7", -7, 26),
    (62, "JS5", -3, 16),
    (62, "JS6", -6, 19),
    (62, "JS7", -10, 23),
    (62, "K5", -7, 13),
    (62, "H7", 5, 38),
    (62, "H8", 5, 54),
    (62, "J6", -2, 22),
    (52, "J7", -7, 26),
    (100, "J7", -8, 32),
    (100, "JS6", -6, 21),
    (140, "J7", -7, 37),
    (170, "K5", -9, 22),
]


@pytest.mark.parametrize(("diameter", "tolerance", "low", "high"), PROBABLE_OF_SKF)
def test_probable_fits_are_those_that_skf_prints(
    diameter: float, tolerance: str, low: float, high: float
) -> None:
    """Three standard deviations of independent normal dimensions; SKF rounds outward by a µm."""
    d = 1e-3 * diameter
    bearing = bearing_6305(pitch_diameter=0.75 * d, ball_diameter=0.1 * d)
    place = Mounting(bore=0.4 * d, outside_diameter=d, housing_tolerance=tolerance)
    samples = sample_clearance(bearing, place, samples=200_000, seed=3)
    fit = -1e6 * samples.housing_interference
    sigma = fit.std() / 0.9867
    assert [fit.mean() - 3 * sigma, fit.mean() + 3 * sigma] == pytest.approx([low, high], abs=1.1)


def test_interferences_on_shafts_are_those_that_a_maker_prints() -> None:
    """GBBCO, Table 1, bore 18 to 30 and 50 to 80: greatest gap and greatest interference, µm."""
    for bore, tolerance, gap, tight in (
        (25, "g6", 20, 3),
        (25, "h6", 13, 10),
        (25, "j5", 4, 15),
        (25, "j6", 4, 19),
        (25, "js6", 6.5, 16.5),
        (75, "g6", 29, 5),
        (75, "j5", 7, 21),
        (75, "js6", 9.5, 24.5),
    ):
        bearing = bearing_6305(pitch_diameter="115 mm", ball_diameter="12 mm")
        if bore == 25:
            bearing = bearing_6305()
        place = Mounting(bore=1e-3 * bore, outside_diameter="150 mm", shaft_tolerance=tolerance)
        limits = operating_clearance(bearing, place).steps[1].details["interference"]
        assert [1e6 * limits[0], -1e6 * limits[2]] == pytest.approx([tight, gap])


def test_what_is_left_of_an_interference_is_never_negative() -> None:
    samples = sample_clearance(bearing_6305(), mounting(housing_tolerance="J7"))
    assert samples.housing_interference.min() < 0.0 == samples.housing_effective.min()
    tight = samples.housing_interference > 0.0
    assert samples.housing_effective[tight] == pytest.approx(samples.housing_interference[tight])


def test_share_of_preloaded_bearings() -> None:
    samples = sample_clearance(bearing_6305(), mounting(clearance_class="CN", shaft_tolerance="n6"))
    assert samples.preloaded == np.mean(samples.clearance < 0.0) > 0.5


@pytest.mark.parametrize(
    ("fields", "told"),
    [
        ({"samples": 0}, "integer from 1"),
        ({"samples": 10**9}, "integer from 1"),
        ({"samples": True}, "integer from 1"),
        ({"seed": -1}, "must be a non-negative integer"),
        ({"distribution": "beta"}, "one of normal, uniform"),
    ],
)
def test_samples_out_of_range(fields: dict[str, Any], told: str) -> None:
    with pytest.raises(InputError, match=told):
        sample_clearance(bearing_6305(), mounting(), **fields)


# --- refusals ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("changes", "field", "told"),
    [
        ({"clearance_class": "C3", "bore": "2 mm"}, "mounting.bore", "which covers sizes over"),
        ({"shaft_tolerance": "K5"}, "mounting.shaft_tolerance", "must be one of"),
        ({"housing_tolerance": "j7"}, "mounting.housing_tolerance", "must be one of"),
        ({"measured_clearance": "1 um"}, "mounting.measured_clearance", "interference"),
        ({"bore": "40 mm"}, "mounting.bore", "must be less than the diameter of the inner raceway"),
        (
            {"outside_diameter": "50 mm"},
            "mounting.outside_diameter",
            "must be greater than the diameter of the outer raceway",
        ),
    ],
)
def test_wrong_mountings(changes: dict[str, Any], field: str, told: str) -> None:
    with pytest.raises(InputError, match=told) as error:
        found(**changes)
    assert error.value.field == field


@pytest.mark.parametrize(
    ("changes", "field", "told"),
    [
        ({"clearance_class": "C9"}, "clearance_class", "must be one of"),
        (
            {"clearance_class": "C3", "measured_clearance": "20 um"},
            "measured_clearance",
            "combined with clearance_class",
        ),
        (
            {"shaft_tolerance": "k5", "shaft_interference": 1e-6},
            "shaft_interference",
            "cannot be combined with",
        ),
        ({"measuring_load": "49 N"}, "measuring_load", "needs the clearance that was measured"),
        ({"shaft_bore": "25 mm"}, "shaft_bore", "must be less than bore, 25 mm"),
        ({"outside_diameter": "20 mm"}, "bore", "must be less than outside_diameter"),
        ({"housing_outside_diameter": "62 mm"}, "outside_diameter", "must be less than housing"),
        ({"housing_material": "aluminum"}, "housing_material", "did you mean aluminium"),
        ({"housing_material": 3}, "housing_material", r"must be a name \(material of a seat\)"),
        ({"wear": "-1 um"}, "wear", "must be at least 0 mm"),
    ],
)
def test_wrong_records(changes: dict[str, Any], field: str, told: str) -> None:
    with pytest.raises(InputError, match=told) as error:
        mounting(**changes)
    assert error.value.field == field


def test_temperatures_and_expansions_that_are_missing() -> None:
    for given, field in (
        (PartTemperatures(inner_ring=340.0), "temperature.outer_ring"),
        (PartTemperatures(outer_ring=340.0), "temperature.inner_ring"),
        (PartTemperatures(balls=340.0), "temperature.inner_ring"),
        (PartTemperatures(inner_ring=-4.0, outer_ring=340.0), "temperature.inner_ring"),
    ):
        with pytest.raises(InputError) as error:
            found(given)
        assert error.value.field == field
    hot = bearing_6305(ring_material="M50")
    with pytest.raises(InputError, match="is missing: the thermal expansion of"):
        operating_clearance(hot, mounting(), WARM)
    given_one = operating_clearance(
        hot, mounting(ring_expansion="12e-6 1/K", ball_expansion="12e-6 1/K"), WARM
    )
    assert given_one.mean < 20e-6
    assert operating_clearance(hot, mounting()).mean == pytest.approx(20e-6)


def test_sets_angles_and_speeds_that_do_not_go() -> None:
    pair = bearing_6305(
        diametral_clearance=None, contact_angle="15 deg", arrangement="DB", spacing="17 mm"
    )
    with pytest.raises(InputError, match="is a set: the clearance is that of one of its rows"):
        operating_clearance(pair, mounting())
    angular = bearing_6305(diametral_clearance=None, contact_angle="15 deg")
    with pytest.raises(
        InputError, match="is for bearings given by their clearance; this one is given"
    ) as error:
        operating_clearance(angular, mounting(clearance_class="C3"))
    assert error.value.field == "mounting.clearance_class"
    for speed in (float("nan"), float("inf"), 1e7):
        with pytest.raises(InputError, match="1e6 rad/s"):
            found(None, speed)


# --- the record in a file -------------------------------------------------------------------


def test_a_table_of_a_file_and_back() -> None:
    text = """
        bore = "25 mm"
        outside_diameter = "62 mm"
        clearance_class = "C3"
        shaft_tolerance = "k5"
        housing_material = "aluminium"
        assembly_temperature = "20 degC"
    """
    record = Mounting.from_mapping(tomllib.loads(text))
    assert record.housing_material == SeatMaterial.named("Aluminium")
    assert record.assembly_temperature == 293.15
    assert Mounting.from_mapping(record.to_mapping()) == record
    assert record.to_mapping()["housing_material"] == "aluminium"
    with pytest.raises(UnitError, match="needs a unit"):
        Mounting.from_mapping({"bore": 0.025, "outside_diameter": "62 mm"})
    custom = record.replace(housing_material=SeatMaterial.named("steel").replace(name="mine"))
    assert Mounting.from_mapping(custom.to_mapping()) == custom


@pytest.mark.parametrize("given", [{"contact_angle": 0.7}, {"diametral_clearance": 20e-6}])
def test_one_temperature_and_one_coefficient_change_nothing_but_the_size(
    given: dict[str, float],
) -> None:
    """All parts equally warm: forces grow with the square of the size, strains and angles stay."""
    case = Case(
        bearing={
            "ball_count": 8, "ball_diameter": 0.010319, "pitch_diameter": 0.0445,
            "inner_conformity": 0.51, "outer_conformity": 0.53, **given,
        },
        mounting={"bore": 0.025, "outside_diameter": 0.062, "shaft_interference": 12e-6},
        duty={"load": {"fx": 500.0, "fz": 1000.0}},
    )  # fmt: skip
    rise = 80.0
    size = 1.0 + expansion_of(case.bearing.ring_material, "mounting.ring_expansion") * rise
    warm = case.with_(
        {
            "temperature.inner_ring": 293.15 + rise,
            "temperature.outer_ring": 293.15 + rise,
            "mounting.shaft_interference": 12e-6 * size,
            "duty.load.fx": 500.0 * size**2,
            "duty.load.fz": 1000.0 * size**2,
        }
    )
    before, after = solve(case), solve(warm)
    np.testing.assert_allclose(after.inner.load, before.inner.load * size**2, rtol=1e-9, atol=1e-6)
    np.testing.assert_allclose(after.inner.contact_angle, before.inner.contact_angle, atol=1e-9)
    np.testing.assert_allclose(after.inner.max_pressure, before.inner.max_pressure, rtol=1e-9)
    np.testing.assert_allclose(
        after.rows.free_contact_angle, before.rows.free_contact_angle, atol=1e-12
    )
    many = solve(warm, {"temperature.inner_ring": np.full(2, 293.15 + rise)})
    np.testing.assert_allclose(many.inner.load[1], after.inner.load[0], rtol=1e-9, atol=1e-6)
