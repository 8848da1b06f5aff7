"""Reliability, equivalent load, basic and modified life, contamination, factors of 1990."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from rolamento.errors import InputError
from rolamento.iso4406 import cleanliness_numbers
from rolamento.life.contamination import (
    class_of_code,
    class_of_filter,
    class_of_grease,
    contamination_factor,
)
from rolamento.life.equivalent_load import (
    equivalent_load,
    load_factors,
    static_equivalent_load,
    static_safety,
)
from rolamento.life.iso281 import basic_rating_life, hours, load_notes
from rolamento.life.iso281_1990 import adjusted_life, adjustment_notes
from rolamento.life.iso281_modified import (
    fatigue_load_limit,
    fatigue_load_limit_of_contacts,
    life_modification_factor,
    modification_notes,
)
from rolamento.life.reliability import outside_print, reliability_factor, reliability_of

RPM = np.pi / 30.0
MPA = 1e6


def test_reliability_goes_there_and_back() -> None:
    s = np.array([0.5, 0.9, 0.95, 0.99, 0.9995])
    for edition in ("2007", "1990"):
        factor = reliability_factor(s, edition)
        assert factor[1] == pytest.approx(1.0, abs=1e-15)
        assert np.all(np.diff(factor) < 0.0)
        assert reliability_of(factor, edition) == pytest.approx(s, rel=1e-12)
    assert reliability_of(0.04) == 1.0
    assert reliability_of(0.04, "1990") < 1.0


def test_median_life_of_weibull() -> None:
    expected = (np.log(2.0) / np.log(1.0 / 0.9)) ** (2.0 / 3.0)
    assert reliability_factor(0.5, "1990") == pytest.approx(expected, rel=1e-14)


@pytest.mark.parametrize("wrong", [95.0, 0.0, 1.0, -0.1, np.nan, "much"])
def test_wrong_reliability(wrong: object) -> None:
    allowed = r"numbers \(example: reliability = 0\.95\)" if wrong == "much" else r"0\.01"
    with pytest.raises(InputError, match=f"reliability.*{allowed}"):
        reliability_factor(wrong)  # type: ignore[arg-type]


def test_unknown_edition() -> None:
    with pytest.raises(InputError, match="edition"):
        reliability_factor(0.9, "2010")  # type: ignore[arg-type]


def test_reliability_outside_the_table() -> None:
    assert list(outside_print([0.5, 0.9, 0.995, 0.9999])) == [True, False, False, True]
    assert list(outside_print([0.99, 0.995], "1990")) == [False, True]


def test_factors_at_the_table() -> None:
    found = load_factors(np.radians([0.0, 10.0, 15.0, 40.0]), 1.38 * MPA)
    assert found.radial == pytest.approx([0.56, 0.46, 0.44, 0.35])
    assert found.axial == pytest.approx([1.45, 1.34, 1.19, 0.57])
    assert found.limit == pytest.approx([0.30, 0.40, 0.47, 1.14])


def test_factors_between_and_beyond() -> None:
    between = load_factors(np.radians(12.5), 0.5 * (0.345 + 0.689) * MPA)
    assert between.axial == pytest.approx(np.mean([1.71, 1.52, 1.40, 1.30]))
    assert load_factors(0.0, 0.01 * MPA).axial == load_factors(0.0, 0.172 * MPA).axial
    assert load_factors(0.0, 99.0 * MPA).axial == 1.0


def test_equivalent_load_either_side_of_e() -> None:
    # 40 degrees: e = 1.14, X = 0.35, Y = 0.57; back to back Y1 = 0.55, X2 = 0.57, Y2 = 0.93
    angle = np.radians(40.0)
    single = equivalent_load([1000.0, 1000.0, 0.0], [500.0, 2000.0, 700.0], angle, 1.0)
    assert single.load == pytest.approx([1000.0, 1490.0, 399.0])
    double = equivalent_load([1000.0, 1000.0], [500.0, 2000.0], angle, 1.0, double_row=True)
    assert double.load == pytest.approx([1275.0, 2430.0])


def test_double_row_is_continuous_at_e() -> None:
    for degrees in (5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0):
        found = load_factors(np.radians(degrees), 2.0 * MPA, double_row=True)
        below = 1.0 + found.axial_below * found.limit
        beyond = found.radial + found.axial * found.limit
        assert beyond == pytest.approx(float(below), rel=0.02)


def test_five_degrees() -> None:
    """A single row counts as radial contact there, two rows have a line of their own."""
    angle = np.radians(5.0)
    single, radial = load_factors(angle, 1.38 * MPA), load_factors(0.0, 1.38 * MPA)
    assert (single.radial, single.axial, single.limit) == pytest.approx(
        (float(radial.radial), float(radial.axial), float(radial.limit))
    )
    double = load_factors(angle, 1.38 * MPA, double_row=True)
    assert (double.axial_below, double.radial, double.axial, double.limit) == pytest.approx(
        (1.75, 0.78, 2.36, 0.36)
    )


def test_static_load_of_two_rows_of_radial_contact() -> None:
    one = static_equivalent_load(100.0, 1000.0, 0.0)
    two = static_equivalent_load(100.0, 1000.0, 0.0, double_row=True)
    assert one == two == pytest.approx(560.0)
    assert static_equivalent_load(0.0, 1000.0, np.radians(5.0)) == pytest.approx(520.0)


def test_thrust_bearing_is_refused() -> None:
    with pytest.raises(InputError, match="45"):
        load_factors(np.radians(60.0), 1.0)


def test_static_equivalent_load() -> None:
    assert static_equivalent_load(1000.0, 0.0, 0.0) == 1000.0
    assert static_equivalent_load(0.0, 1000.0, np.radians(40.0)) == pytest.approx(260.0)
    assert static_equivalent_load(100.0, 1000.0, np.radians(40.0), double_row=True) == (
        pytest.approx(620.0)
    )
    assert static_safety(11200.0, 5600.0) == 2.0
    assert static_safety(11200.0, 0.0) == np.inf


def test_basic_life() -> None:
    life = basic_rating_life(20000.0, [10000.0, 0.0])
    assert life == pytest.approx([8.0, np.inf])
    assert hours(8.0, 1000.0 * RPM) == pytest.approx(8e6 / 60000.0)
    assert np.isnan(hours(8.0, 0.0))
    assert hours(8.0, -1000.0 * RPM) > 0.0
    with pytest.raises(InputError, match="dynamic_rating"):
        basic_rating_life(0.0, 1.0)
    with pytest.raises(InputError, match="equivalent_load"):
        basic_rating_life(1.0, [1.0, -1.0])


def test_notes_on_great_loads() -> None:
    notes = load_notes([900.0, 1100.0, 1300.0], 2000.0, 1200.0)
    assert list(notes["load_above_half_rating"]) == [False, True, True]
    assert list(notes["load_above_static_rating"]) == [False, False, True]


def test_modification_factor_has_no_steps() -> None:
    for edge in (0.4, 1.0):
        low, high = (
            life_modification_factor(edge * (1.0 + shift), 0.5, 100.0, 1000.0)
            for shift in (-1e-9, 1e-9)
        )
        assert high == pytest.approx(float(low), rel=2e-3)


def test_modification_factor_at_its_limits() -> None:
    dirty = life_modification_factor([0.2, 1.0, 4.0], 0.0, 100.0, 1000.0)
    assert dirty == pytest.approx([0.1, 0.1, 0.1])
    assert life_modification_factor(4.0, 1.0, 1000.0, 1000.0) == 50.0
    assert life_modification_factor(1.0, 1.0, 1000.0, 0.0) == 50.0
    assert life_modification_factor(9.0, 0.5, 100.0, 1e3) == life_modification_factor(
        4.0, 0.5, 100.0, 1e3
    )
    assert np.isnan(life_modification_factor(0.09, 1.0, 100.0, 1000.0))
    notes = modification_notes([0.05, 1.0, 5.0], [0.5, 0.0, 0.5])
    assert list(notes["viscosity_ratio_too_small"]) == [True, False, False]
    assert list(notes["contamination_severe"]) == [False, True, False]
    assert list(notes["viscosity_ratio_capped"]) == [False, False, True]


def test_additives_help_a_thin_film_within_bounds() -> None:
    arguments = (0.3, 0.8, 200.0, 1000.0)
    without = life_modification_factor(*arguments)
    helped = life_modification_factor(*arguments, additives=True)
    assert without < helped <= 3.0
    assert life_modification_factor(0.3, 0.1, 200.0, 1000.0, additives=True) == (
        life_modification_factor(0.3, 0.1, 200.0, 1000.0)
    )
    assert np.isnan(life_modification_factor(0.05, 0.8, 200.0, 1000.0, additives=True))


def test_fatigue_load_limits() -> None:
    assert fatigue_load_limit(22000.0, 0.1) == pytest.approx(1000.0)
    assert fatigue_load_limit(22000.0, 0.4) == pytest.approx(500.0)
    arguments = (8, 0.010319, 0.0445, 0.52, 0.53, 0.0, 2.0 / (2.0 * 0.91 / 207e9))
    limit = fatigue_load_limit_of_contacts(*arguments)
    # the pressure is 1500 MPa under it and 4200 MPa under C_0: the cube of 2.8 is 21.95
    rated = fatigue_load_limit_of_contacts(*arguments, pressure=4.2e9)
    assert rated / limit == pytest.approx(2.8**3)
    assert fatigue_load_limit_of_contacts(*arguments, rows=2) == pytest.approx(2.0 * float(limit))


def test_codes() -> None:
    assert cleanliness_numbers("18/15/12") == (18, 15, 12)
    assert cleanliness_numbers(" -/15/12 ") == (None, 15, 12)
    assert class_of_code("18/15/12", "circulating").name == "-/15/12"
    assert class_of_code("-/15/13", "circulating").name == "-/17/14"
    assert class_of_code("-/12/9", "bath").name == "-/13/10"


@pytest.mark.parametrize(
    "code",
    [
        "",
        "15",
        "15/12",
        "-/12/15",
        "12/15/10",
        "a/b/c",
        "-/15/12/9",
        "-/٣/٣",
        "9" * 10_000,
        "-/99/9",
    ],
)
def test_malformed_code(code: str) -> None:
    with pytest.raises(InputError, match="cleanliness"):
        class_of_code(code, "circulating")


def test_dirt_without_a_class() -> None:
    with pytest.raises(InputError, match="dirtier than -/19/16"):
        class_of_code("-/21/18", "circulating")
    assert class_of_code("-/21/18", "bath").name == "-/21/18"
    with pytest.raises(InputError, match="supply"):
        class_of_code("-/15/12", "spray")  # type: ignore[arg-type]
    with pytest.raises(InputError, match="did you mean severe"):
        class_of_grease("sever")
    with pytest.raises(InputError, match="coarser"):
        class_of_filter(50e-6, 200.0)


def test_filters() -> None:
    assert class_of_filter(6e-6, 200.0).name == "-/13/10"
    assert class_of_filter(12e-6, 1000.0).name == "-/15/12"
    assert class_of_filter(12e-6, 75.0).name == "-/17/14"
    assert class_of_filter(40e-6, 75.0).name == "-/19/16"


def test_contamination_factor() -> None:
    # by hand: 0.0288 (100 mm)^0.55 = 0.3626 at kappa 1; 1 - 1.6329/100^(1/3) = 0.6482
    oil = class_of_code("-/17/14", "circulating")
    assert contamination_factor(oil, 1.0, 0.1) == pytest.approx(0.3626 * 0.6482, rel=1e-3)
    ratios = np.linspace(0.1, 4.0, 50)
    for level in ("high", "normal", "slight", "severe", "very_severe"):
        factor = contamination_factor(class_of_grease(level), ratios, 0.15)
        assert np.all(np.diff(factor) >= 0.0)
        assert np.all((factor >= 0.0) & (factor <= 1.0))
    assert contamination_factor(class_of_grease("very_severe"), 1.0, 0.02) == 0.0


def test_adjusted_life_and_its_conditions() -> None:
    assert adjusted_life(100.0, 0.62, 1.0, 0.5) == pytest.approx(31.0)
    with pytest.raises(InputError, match="operation_factor"):
        adjusted_life(100.0, 1.0, 1.0, 0.0)
    notes = adjustment_notes(1.0, 1.0, [12e-6, 14e-6, np.nan], 1000.0 * RPM, 0.0445)
    assert list(notes["operation_factor_too_great"]) == [True, False, False]
    slow = adjustment_notes(2.0, 1.5, 100e-6, 100.0 * RPM, 0.0445)
    assert slow["operation_factor_too_great"]
    assert slow["operation_factor_unfounded"]
    assert slow["material_factor_unsupported"]


def test_grease_of_slight_contamination_has_a_constant_of_its_own_for_large_bearings() -> None:
    """ISO 281:2007, annex A: c2 = 1.887, and 1.677 from D_pw = 500 mm on."""
    slight = class_of_grease("slight")
    for millimetres, c2 in ((499.0, 1.887), (500.0, 1.677), (0.5 / 1e-3, 1.677), (900.0, 1.677)):
        film = min(0.0177 * 0.3**0.68 * millimetres**0.55, 1.0)
        expected = film * (1.0 - c2 / millimetres ** (1.0 / 3.0))
        found = contamination_factor(slight, 0.3, millimetres * 1e-3)
        assert float(found) == pytest.approx(expected, rel=1e-12)
    for other in ("high", "normal", "severe"):
        below, above = contamination_factor(class_of_grease(other), 0.3, [0.49999999, 0.5])
        assert below == pytest.approx(above, rel=1e-6)


@pytest.mark.parametrize(
    ("function", "arguments", "field"),
    [
        (hours, (1.0, "fast"), "speed"),
        (hours, ([1.0, "two"], 1.0), "life"),
        (load_notes, ("5 kN", 1.0, 1.0), "equivalent_load"),
        (life_modification_factor, (1.0, "clean", 1.0, 1.0), "contamination_factor"),
        (load_factors, ("steep", 0.0), "contact_angle"),
        (outside_print, ("sure",), "reliability"),
    ],
)
def test_what_is_no_number_is_refused(
    function: Any, arguments: tuple[Any, ...], field: str
) -> None:
    with pytest.raises(InputError, match=f"{field}.*must be a number"):
        function(*arguments)
