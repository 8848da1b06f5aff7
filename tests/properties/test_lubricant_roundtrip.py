"""Lubricant, surface, temperature and film of a case read back as they were written."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from hypothesis import given
from hypothesis import strategies as st

from rolamento import Case, load_case
from rolamento.case import case_to_json, case_to_toml, parse_case
from rolamento.case.film_model import FilmModel
from rolamento.case.lubricant import Lubricant, ViscosityPoint
from rolamento.case.surface import Surface
from rolamento.case.temperature import Temperature

EXAMPLE = Path(__file__).resolve().parents[2] / "src" / "rolamento" / "examples/209_radial.toml"
LINES = st.sampled_from(["custom", "ISO VG 68", "bp 135", "", "π, lot 7"])


def reals(least: float, greatest: float) -> st.SearchStrategy[float]:
    return st.floats(least, greatest, allow_nan=False)


@cache
def plain() -> Case:
    return load_case(EXAMPLE)


@st.composite
def lubricants(draw: st.DrawFn) -> Lubricant:
    if draw(st.booleans()):
        return Lubricant.named(draw(st.sampled_from(Lubricant.names())))
    cool, thick = draw(reals(250.0, 330.0)), draw(reals(5e-6, 1e-2))
    warmer, thinner = draw(reals(1.0, 100.0)), draw(reals(0.2, 0.99))
    by_base = draw(st.booleans())
    points = (
        ViscosityPoint(temperature=cool + warmer, viscosity=thick * thinner),
        ViscosityPoint(temperature=cool, viscosity=thick),
    )
    return Lubricant(
        name=draw(LINES),
        kind=draw(st.sampled_from(["oil", "grease"])),
        base_oil="ISO VG 32" if by_base else None,
        viscosities=None if by_base else points,
        density=draw(st.none() | reals(600.0, 2000.0)) if by_base else draw(reals(600.0, 2000.0)),
        density_temperature=draw(st.none() | reals(260.0, 330.0)),
        thermal_expansion=draw(st.none() | reals(0.0, 1e-3)),
        pressure_viscosity=draw(st.none() | reals(0.0, 1e-7)),
        thermal_conductivity=draw(st.none() | reals(0.05, 1.0)),
        minimum_temperature=draw(st.none() | reals(200.0, 250.0)),
        maximum_temperature=draw(st.none() | reals(350.0, 500.0)),
        friction_coefficient=draw(st.none() | reals(0.001, 1.0)),
        source=draw(LINES),
    )


roughness = reals(1e-9, 1e-5)
surfaces = st.builds(
    Surface,
    parameter=st.sampled_from(["Ra", "Rq"]),
    inner_roughness=roughness,
    outer_roughness=roughness,
    ball_roughness=roughness,
)
temperatures = st.builds(Temperature, lubricant=reals(200.0, 600.0))
films = st.builds(
    FilmModel, starvation=st.just("inlet_distance"), inlet_distance=reals(1e-6, 1e-2)
) | st.builds(FilmModel, thermal=st.sampled_from(["murch_wilson", "gupta_cheng", "none"]))


@given(lubricants(), surfaces, temperatures, films)
def test_reads_back_what_was_written(
    lubricant: Lubricant, surface: Surface, temperature: Temperature, film: FilmModel
) -> None:
    case = plain().replace(lubricant=lubricant, surface=surface, temperature=temperature, film=film)
    assert parse_case(case_to_toml(case)) == case
    assert parse_case(case_to_json(case)) == case
