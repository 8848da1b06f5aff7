"""Lubricants of the case: the library, the ways to give one, what is refused."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from rolamento import Case, case_to_json, case_to_toml, load_case, parse_case
from rolamento.case.film_model import FilmModel
from rolamento.case.lubricant import Lubricant
from rolamento.case.surface import Surface
from rolamento.case.temperature import Temperature
from rolamento.errors import InputError
from rolamento.oil.state import oil_density, oil_state

EXAMPLES = Path(__file__).resolve().parents[2] / "src" / "rolamento" / "examples"
SHEET: dict[str, Any] = {
    "viscosity_40": "68 mm^2/s", "viscosity_100": "8.6 mm^2/s", "density": "880 kg/m^3",
}  # fmt: skip


def sheet(**changes: Any) -> dict[str, Any]:
    mapping = {**SHEET, **changes}
    return {key: value for key, value in mapping.items() if value is not None}


def full_case(**tables: Any) -> Case:
    mapping = load_case(EXAMPLES / "218_combined.toml").to_mapping()
    return Case.from_mapping({**mapping, **tables})


# --- the library ---


@pytest.mark.parametrize("name", Lubricant.names())
def test_every_lubricant_names_its_source(name: str) -> None:
    lubricant = Lubricant.named(name)
    assert lubricant.source
    assert Lubricant.named(name.lower().replace(" ", "")) == lubricant
    if lubricant.kind == "dry":
        assert lubricant.friction_coefficient is not None
        with pytest.raises(InputError, match="dry"):
            _ = lubricant.points
    else:
        cool, hot = lubricant.points
        assert cool.viscosity > hot.viscosity > 0.0
        assert lubricant.oil.density is not None


def test_grades_have_their_number_at_40_degrees() -> None:
    for grade in (10, 68, 460):
        point, _ = Lubricant.named(f"ISO VG {grade}").points
        assert point.viscosity == pytest.approx(grade * 1e-6, rel=1e-12)


def test_a_grease_is_its_base_oil() -> None:
    grease, oil = Lubricant.named("Rheolube 2000"), Lubricant.named("Pennzane SHF X-2000")
    assert grease.points == oil.points
    assert grease.oil.kind == "grease"
    own = Lubricant(kind="grease", base_oil="ISO VG 68", density=900.0)
    assert own.points == Lubricant.named("ISO VG 68").points
    # its own density is at 15 °C, not at the temperature of the base oil's
    assert float(oil_density(own, 288.15)) == pytest.approx(900.0, rel=1e-12)


def test_what_is_given_takes_the_place_of_its_rival() -> None:
    base = Lubricant(base_oil="ISO VG 68", pressure_viscosity=2e-8)
    assert base.oil.pressure_viscosity == 2e-8
    method = Lubricant(base_oil="ISO VG 68", pressure_viscosity_method="so_klaus")
    assert method.oil.pressure_viscosity_method == "so_klaus"
    assert float(oil_state(base, [343.15]).pressure_viscosity[0]) == 2e-8
    assert 1e-8 < float(oil_state(method, [343.15]).pressure_viscosity[0]) < 3e-8


def test_ways_to_give_two_viscosities_agree() -> None:
    by_index = Lubricant.from_mapping(sheet(viscosity_100=None, viscosity_index=98))
    _, hot = by_index.points
    points = [
        {"temperature": "100 degC", "viscosity": f"{hot.viscosity!r} m^2/s"},
        {"temperature": "40 degC", "viscosity": "68 mm^2/s"},
    ]
    by_points = Lubricant.from_mapping(
        sheet(viscosity_40=None, viscosity_100=None, viscosities=points)
    )
    assert by_points.points == by_index.points


# --- what is refused ---


@pytest.mark.parametrize(
    ("changes", "field", "rule"),
    [
        ({"viscosity_40": "8 cSt", "viscosity_100": "68 cSt"}, "viscosity_100", "thins"),
        ({"viscosity_100": "68 cSt"}, "viscosity_100", "thins"),
        ({"viscosity_100": None}, "viscosity_100", "needed"),
        ({"viscosity_index": 95}, "viscosity_100", "not both"),
        ({"viscosity_40": None}, "viscosity_40", "nothing"),
        ({"base_oil": "ISO VG 68"}, "viscosity_40", "viscosity_40 and base_oil"),
        ({"density": None}, "density", "missing"),
        ({"density": "0.9"}, "density", "unit"),
        ({"viscosity_40": "68"}, "viscosity_40", "unit"),
        ({"viscosity_40": "0 cSt"}, "viscosity_40", "at least 0.5"),
        ({"viscosity_40": "5 cSt", "viscosity_100": None, "viscosity_index": 95},
         "viscosity_index", "2 mm"),
        ({"kind": "dry"}, "friction_coefficient", "missing"),
        ({"kind": "dry", "friction_coefficient": 0.1}, "viscosity_40", "no oil"),
        ({"kind": "wet"}, "kind", "one of"),
        ({"friction_coefficient": 0.0}, "friction_coefficient", "greater than 0"),
        ({"pressure_viscosity": "20 1/GPa", "pressure_viscosity_method": "wooster"},
         "pressure_viscosity", "cannot be combined with"),
        ({"minimum_temperature": "80 degC", "maximum_temperature": "20 degC"},
         "minimum_temperature", "less than"),
        ({"viscosity_41": "68 cSt"}, "viscosity_41", "did you mean viscosity_40"),
        ({"viscosity_40": None, "viscosity_100": None, "base_oil": "ISO VG 69"},
         "base_oil", "did you mean"),
        ({"viscosity_40": None, "viscosity_100": None, "base_oil": "Rheolube 2000"},
         "base_oil", "must be an oil"),
        ({"viscosity_40": None, "viscosity_100": None, "viscosities": [
            {"temperature": "40 degC", "viscosity": "68 cSt"},
            {"temperature": "40 degC", "viscosity": "8 cSt"}]}, "viscosities", "same"),
        ({"viscosity_40": None, "viscosity_100": None, "viscosities": [
            {"temperature": "40 degC", "viscosity": "8 cSt"},
            {"temperature": "100 degC", "viscosity": "68 cSt"}]}, "viscosities", "thins"),
    ],
)  # fmt: skip
def test_refuses(changes: dict[str, Any], field: str, rule: str) -> None:
    with pytest.raises(InputError) as caught:
        Lubricant.from_mapping(sheet(**changes))
    assert caught.value.field == field
    assert rule in str(caught.value)
    with pytest.raises(InputError) as inside:
        full_case(lubricant=sheet(**changes))
    assert inside.value.field == f"lubricant.{field}"


@pytest.mark.parametrize("given", [3, ["ISO VG 68"], True, "", "motor oil"])
def test_refuses_what_is_no_lubricant(given: object) -> None:
    with pytest.raises(InputError) as caught:
        full_case(lubricant=given)
    assert caught.value.field == "lubricant"


# --- the other tables ---


def test_surface_by_either_parameter() -> None:
    rq = Surface(inner_roughness=3e-8, outer_roughness=6e-8, ball_roughness=4e-8)
    assert rq.inner_combined == pytest.approx(5e-8)
    assert rq.outer_combined == pytest.approx((36.0 + 16.0) ** 0.5 * 1e-8)
    ra = rq.replace(parameter="Ra")
    assert ra.inner_combined == pytest.approx(1.25 * 5e-8)


@pytest.mark.parametrize("value", ["0 um", "-1 um", "1 mm", "0.1"])
def test_refuses_a_roughness(value: str) -> None:
    surface = {"inner_roughness": value, "outer_roughness": "1 um", "ball_roughness": "1 um"}
    with pytest.raises(InputError) as caught:
        full_case(surface=surface)
    assert caught.value.field == "surface.inner_roughness"


@pytest.mark.parametrize("value", ["-300 degC", "1000 degC", "70"])
def test_refuses_a_temperature(value: str) -> None:
    with pytest.raises(InputError) as caught:
        full_case(temperature={"lubricant": value})
    assert caught.value.field == "temperature.lubricant"


@pytest.mark.parametrize(
    ("fields", "field"),
    [
        ({"starvation": "inlet_distance"}, "inlet_distance"),
        ({"inlet_distance": "1 mm"}, "inlet_distance"),
        ({"starvation": "replenishment", "supply": "bath", "bore": "25 mm"}, "outside_diameter"),
        ({"starvation": "replenishment", "supply": "bath", "bore": "62 mm",
          "outside_diameter": "25 mm"}, "outside_diameter"),
        ({"starvation": "replenishment", "bore": "25 mm", "outside_diameter": "62 mm"}, "supply"),
        ({"thermal": "cold"}, "thermal"),
    ],
)  # fmt: skip
def test_refuses_a_film_model(fields: dict[str, Any], field: str) -> None:
    with pytest.raises(InputError) as caught:
        FilmModel.from_mapping(fields)
    assert caught.value.field == field


def test_a_case_with_all_tables_is_read_back_as_it_was() -> None:
    case = full_case(
        lubricant="ISO VG 68",
        surface={"inner_roughness": "0.1 um", "outer_roughness": "0.1 um",
                 "ball_roughness": "0.02 um", "parameter": "Ra"},
        temperature={"lubricant": "70 degC"},
        film={"starvation": "inlet_distance", "inlet_distance": "0.4 mm", "thermal": "none"},
    )  # fmt: skip
    assert parse_case(case_to_toml(case)) == case
    assert parse_case(case_to_json(case)) == case
    assert 'lubricant = "ISO VG 68"' in case_to_toml(case)
    own = full_case(lubricant=sheet(viscosity_100=None, viscosity_index=120.5))
    assert parse_case(case_to_toml(own)) == own


def test_a_case_without_them_is_written_as_before() -> None:
    plain = load_case(EXAMPLES / "218_combined.toml")
    assert set(plain.to_mapping()) == {"title", "bearing", "duty", "model"}
    assert plain.lubricant is None
    assert plain.temperature is None
    assert Temperature(lubricant=343.15).lubricant == 343.15
