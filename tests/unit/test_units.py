from __future__ import annotations

import math
import sys
from fractions import Fraction
from typing import get_args

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rolamento import units
from rolamento.errors import UnitError
from rolamento.units import SI_UNIT, Dimension, from_si, refuse_thousands, to_si
from rolamento.words import speaking

DIMENSIONS: tuple[Dimension, ...] = get_args(Dimension)


@pytest.mark.parametrize(
    ("text", "dimension", "value"),
    [
        ("22.23 mm", "length", 0.02223),
        ("22.23mm", "length", 0.02223),
        (" 15 µm ", "length", 15e-6),
        ("15 μm", "length", 15e-6),  # the Greek letter, not the micro sign
        ("15 um", "length", 15e-6),
        ("0.5 in", "length", 0.0127),
        ("2 inches", "length", 0.0508),
        ("3 millimetres", "length", 0.003),
        ("1e3 mm", "length", 1.0),
        ("-.5 m", "length", -0.5),
        ("10 kN", "force", 10e3),
        ("1 lbf", "force", 4.4482216152605),
        ("1 kgf", "force", 9.80665),
        ("1 N m", "moment", 1.0),
        ("1 N·m", "moment", 1.0),
        ("1 N*m", "moment", 1.0),
        ("1 N.m", "moment", 1.0),
        ("1 Nm", "moment", 1.0),
        ("1 kNm", "moment", 1000.0),
        ("250 Nmm", "moment", 0.25),
        ("250 N mm", "moment", 0.25),
        ("8 lbf in", "moment", 8 * 0.1129848290276167),
        ("207 GPa", "stress", 207e9),
        ("207000 N/mm^2", "stress", 207e9),
        ("207000 N/mm²", "stress", 207e9),
        ("1 bar", "stress", 1e5),
        ("7.81 g/cm^3", "density", 7810.0),
        ("7.81 g cm⁻³", "density", 7810.0),
        ("180 deg", "angle", math.pi),
        ("180°", "angle", math.pi),
        ("0.5 rev", "angle", math.pi),
        ("2 mrad", "angle", 0.002),
        ("60 rpm", "angular_speed", math.tau),
        ("60 r/min", "angular_speed", math.tau),
        ("1 rev/s", "angular_speed", math.tau),
        ("20 °C", "temperature", 293.15),
        ("68 degF", "temperature", 293.15),
        ("300 K", "temperature", 300.0),
        ("68 mm^2/s", "kinematic_viscosity", 68e-6),
        ("68 mm²/s", "kinematic_viscosity", 68e-6),
        ("68 cSt", "kinematic_viscosity", 68e-6),
        ("0.68 St", "kinematic_viscosity", 68e-6),
        ("11.34 mPa s", "dynamic_viscosity", 0.01134),
        ("11.34 mPa·s", "dynamic_viscosity", 0.01134),
        ("11.34 cP", "dynamic_viscosity", 0.01134),
        ("0.02 N s/m^2", "dynamic_viscosity", 0.02),
        ("16.2 1/GPa", "pressure_viscosity_coefficient", 16.2e-9),
        ("16.2 GPa^-1", "pressure_viscosity_coefficient", 16.2e-9),
        ("16.2 GPa⁻¹", "pressure_viscosity_coefficient", 16.2e-9),
        ("2e-8 m^2/N", "pressure_viscosity_coefficient", 2e-8),
        ("0.002 1 / bar", "pressure_viscosity_coefficient", 2e-8),
        ("0.145 W/m/K", "thermal_conductivity", 0.145),
        ("145 mW/m/K", "thermal_conductivity", 0.145),
        ("7e-4 1/K", "thermal_expansion", 7e-4),
        ("7e-4 K^-1", "thermal_expansion", 7e-4),
        ("7e-4 1/°C", "thermal_expansion", 7e-4),
    ],
)
def test_reads_the_units_that_people_write(text: str, dimension: Dimension, value: float) -> None:
    assert to_si(text, dimension) == value


@pytest.mark.parametrize(
    ("text", "dimension", "rule"),
    [
        ("", "length", "must be a finite number with a unit of"),
        ("22.23", "length", "needs a unit"),
        ("mm", "length", "must be a finite number with a unit of"),
        ("22,23 mm", "length", "a decimal point, not a comma"),
        ("nan mm", "length", "finite number"),
        ("inf mm", "length", "finite number"),
        ("1e999 mm", "length", "is beyond the range of floating-point numbers"),
        ("1e99999999 mm", "length", "is beyond the range of floating-point numbers"),
        ("1e308 km", "length", "is beyond the range of floating-point numbers"),
        ("5 mmm", "length", "did you mean mm"),
        ("5 kg", "length", "not a unit of length"),
        ("5 m**9999999", "length", "not a known unit"),
        ("5 m^2", "length", "not a unit of length"),
        ("5 mm/", "length", "not a known unit"),
        ("5 /mm", "length", "not a known unit"),
        ("5 m + m", "length", "not a known unit"),
        ("5 (m)", "length", "not a known unit"),
        ("2*3 mm", "length", "not a known unit"),
        ("__import__('os') mm", "length", "finite number"),
        ("٣ mm", "length", "finite number"),
        ("5 Ns", "force", "not a known unit"),
        ("100 1/s", "angular_speed", "not a known unit"),
        ("68", "kinematic_viscosity", "needs a unit"),
        ("68 mPa s", "kinematic_viscosity", "not a unit of kinematic viscosity"),
        ("68 cSt", "dynamic_viscosity", "not a unit of dynamic viscosity"),
        ("20 GPa", "pressure_viscosity_coefficient", "not a unit of pressure-viscosity"),
        ("20 2/GPa", "pressure_viscosity_coefficient", "not a known unit"),
        ("20 1/1/GPa", "pressure_viscosity_coefficient", "not a known unit"),
        ("20 1/GPa^2", "pressure_viscosity_coefficient", "not a known unit"),
        ("0.14 W/m", "thermal_conductivity", "not a unit of thermal conductivity"),
        ("7e-4 degC", "thermal_expansion", "not a unit of thermal expansion"),
        ("5 deg", "angular_speed", "not a unit of angular speed"),
        ("5 degC^2", "temperature", "not a unit of temperature"),
        ("5 " + "m " * 60, "length", "at most 100 characters"),
        ("1" * 10**6 + " mm", "length", "at most 100 characters"),
    ],
)
def test_explains_what_it_cannot_read(text: str, dimension: Dimension, rule: str) -> None:
    with pytest.raises(UnitError) as caught:
        to_si(text, dimension)
    assert rule in str(caught.value)
    assert len(str(caught.value)) < 400


@pytest.mark.parametrize(
    ("value", "dimension", "text"),
    [
        (0.02223, "length", "22.23 mm"),
        (0.0, "length", "0 mm"),
        (1e-9, "length", "0.000001 mm"),
        (-15e-6, "length", "-0.015 mm"),
        (math.radians(40), "angle", "40 deg"),
        (0.7, "angle", "0.7 rad"),
        (1.0000000000000003e-05, "length", "1.0000000000000003e-05 m"),
        (20e3, "force", "20 kN"),
        (999.0, "force", "999 N"),
        (207e9, "stress", "207 GPa"),
        (1.5e6, "stress", "1.5 MPa"),
        (3240.0, "density", "3240 kg/m^3"),
        (0.25, "moment", "0.25 N m"),
        (66.9e-6, "kinematic_viscosity", "66.9 mm^2/s"),
        (0.01134, "dynamic_viscosity", "11.34 mPa s"),
        (16.2e-9, "pressure_viscosity_coefficient", "16.2 1/GPa"),
        (0.145, "thermal_conductivity", "0.145 W/m/K"),
        (7e-4, "thermal_expansion", "0.0007 1/K"),
    ],
)
def test_writes_the_units_that_people_read(value: float, dimension: Dimension, text: str) -> None:
    assert from_si(value, dimension) == text


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_does_not_write_what_is_no_number(value: float) -> None:
    with pytest.raises(ValueError, match="not a finite number"):
        from_si(value, "length")


@given(
    value=st.floats(allow_nan=False, allow_infinity=False), dimension=st.sampled_from(DIMENSIONS)
)
def test_reads_back_what_it_writes_bit_for_bit(value: float, dimension: Dimension) -> None:
    assert to_si(from_si(value, dimension), dimension) == value


@given(st.decimals(-1000, 1000, places=4))
def test_millimetres_are_scaled_without_a_rounding_of_their_own(number: object) -> None:
    assert to_si(f"{number} mm", "length") == float(Fraction(str(number)) / 1000)


@given(st.text(max_size=120), st.sampled_from(DIMENSIONS))
def test_any_text_is_a_finite_number_or_a_unit_error(text: str, dimension: Dimension) -> None:
    try:
        value = to_si(text, dimension)
    except UnitError as error:
        assert str(error).isprintable()
    else:
        assert math.isfinite(value)


@pytest.mark.parametrize("dimension", DIMENSIONS)
def test_the_common_units_are_those_of_pint(dimension: Dimension) -> None:
    for text, unit in units._COMMON[dimension].items():
        assert units._parsed_unit(text, dimension) == unit
    assert units._parsed_unit(SI_UNIT[dimension], dimension) == (1, 0)


def test_common_units_do_not_import_pint() -> None:
    import subprocess

    script = (
        "import sys; from rolamento.units import to_si, from_si;"
        "from_si(to_si('22.23 mm', 'length'), 'length');"
        "print('pint' in sys.modules)"
    )
    result = subprocess.run([sys.executable, "-c", script], capture_output=True, check=True)
    assert result.stdout.strip() == b"False"


@pytest.mark.parametrize("text", ["1.480 rpm", "5.000 N", "-5.000N", "500.000 kgf"])
def test_points_that_may_part_thousands_where_commas_are_decimal(text: str) -> None:
    refuse_thousands(text)  # in English a point is the decimal mark
    with speaking("pt"), pytest.raises(UnitError) as refused:
        refuse_thousands(text)
    assert refused.value.value == text
    with speaking("pt"):
        refuse_thousands(refused.value.example)
    assert float(refused.value.example.split()[0]) == 1e3 * float(text.rstrip(" rpmNkgf"))


@pytest.mark.parametrize(
    "text",
    ["9.525 mm", "1.25 rpm", "1480 rpm", "0.125 N", "1.2500 N", "1480.125 rpm", "6.310", "x"],
)
def test_points_that_part_no_thousands(text: str) -> None:
    with speaking("pt"):
        refuse_thousands(text)
