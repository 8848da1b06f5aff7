"""Film and film parameter: as printed, as they should be, and what each choice does to them."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from rolamento.case import Case
from rolamento.case.duty import Duty, Load
from rolamento.contact.hertz import effective_modulus, elliptical_contact
from rolamento.geometry import Race
from rolamento.lubrication import film as film_of
from rolamento.lubrication.film_thickness import central_film, film_groups
from rolamento.lubrication.regime import regime_of
from rolamento.lubrication.roughness import rms_of_mean_roughness
from rolamento.oil import wooster
from rolamento.solution import solve
from rolamento.units import MILLIMETRE
from rolamento.verification import Check
from rolamento_reproductions.campanha_2008.contact import (
    check_of,
    contact_table,
    curvatures,
    evidence,
    temperature_of_print,
)
from rolamento_reproductions.campanha_2008.inputs import (
    GIVEN,
    MICRO,
    ZERO_CELSIUS,
    Number,
    bearing,
    clearances_of_class,
    film_checks,
    load,
    numbers_table,
    oil,
    oil_at,
    printed,
    said,
    speed,
    steel_of_film,
    temperature,
)
from rolamento_reproductions.record import Claim, Section, Table, TableColumn
from rolamento_reproductions.text import Text

REGIMES = {
    "full_film": said("regimes.full_film"),
    "partial": said("regimes.partial"),
    "boundary": said("regimes.boundary"),
    "adhesive": said("regimes.adhesive"),
}
_CONDITIONS = ("I", "II")
_USUAL_RATIO = 1.25
"""σ over R_a as the dissertation takes it."""


def film_section(title: Text) -> Section:
    """Compute the numbers of chapter 4.4.3."""
    return Section(title, (contact_table(), _films(), _choices()))


# --- film and film parameter ------------------------------------------------


@cache
def film_numbers() -> tuple[Number, ...]:
    """Return the printed films, roughnesses and film parameters."""
    rough = (_rms(row) for row in GIVEN.inputs_of("contact")["roughness"])
    return (
        *(_thickness(condition) for condition in _CONDITIONS),
        *rough,
        *(_parameter(case, check) for case, check in _parameters()),
    )


def _thickness(condition: str) -> Number:
    check = check_of("h_c", condition)
    return Number(
        f"film_{condition}",
        said("thickness.quantity", condition=condition),
        check.printed,
        evidence(check),
        check.computed,
        said("thickness.reason"),
    )


def _rms(row: dict[str, Any]) -> Number:
    mean = row["mean_um"]
    inner = row["part"] == "inner"
    part = said("rms.inner_race") if inner else said("rms.ball")
    return Number(
        f"rms_{row['bearing']}_{row['part']}",
        said("rms.quantity", bearing=row["bearing"], part=part),
        row["rms_um"],
        _USUAL_RATIO * mean,
        float(rms_of_mean_roughness(mean)),
        said("rms.reason", mean=mean),
    )


def _parameters() -> list[tuple[dict[str, Any], Check]]:
    """Return the cases of λ with their numbers, as printed."""
    checks = [check for check in film_checks() if check.quantity.startswith("λ")]
    return list(zip(printed("film")["lambda"], checks, strict=True))


def _parameter(case: dict[str, Any], check: Check) -> Number:
    bearing_of_case = (
        said("parameter.new_bearing")
        if case["bearing"] == "new"
        else said("parameter.bearing_after_test", bearing=case["bearing"])
    )
    before, after = (_regime(value) for value in (evidence(check), check.computed))
    return Number(
        f"lambda_{case['condition']}_{case['bearing']}",
        said("parameter.quantity", condition=case["condition"], bearing_of_case=bearing_of_case),
        check.printed,
        evidence(check),
        check.computed,
        said("parameter.reason", before=before, after=after),
    )


def _regime(parameter: float) -> Text:
    regime = regime_of(parameter)
    assert regime is not None
    return REGIMES[regime.name]


def _films() -> Table:
    return numbers_table(
        "I",
        said("films.caption"),
        GIVEN.source_of("contact"),
        film_numbers(),
        claims=(_speed_doubted(), _pressure_doubted()),
    )


def _speed_doubted() -> Claim:
    check = check_of("U")
    ratio = float(check.printed) / check.computed
    return Claim(
        said("speed_doubted.statement"),
        said("speed_doubted.finding", ratio=ratio),
        holds=abs(ratio - 1.0) > 0.1,
    )


def _pressure_doubted() -> Claim:
    viscosity = check_viscosity("I")
    both = [_film(viscosity, coefficient=float(wooster(viscosity)) * k) for k in (1.0, 1.1)]
    return Claim(
        said("pressure_doubted.statement"),
        said("pressure_doubted.finding", both=100.0 * (both[1] / both[0] - 1.0)),
        holds=False,
        partly=True,
    )


# --- what each choice does --------------------------------------------------


def check_viscosity(condition: str) -> float:
    """Return the printed dynamic viscosity of a condition; Pa·s."""
    rows = {row["name"]: row for row in printed("film")["condition"]}
    return float(rows[condition]["viscosity_cP"]) * 1e-3


def _film(
    viscosity: float,
    *,
    speeds: float = 1.0,
    curvature: float | None = None,
    ellipticity: float | None = None,
    race: Race = "inner",
    coefficient: float | None = None,
) -> float:
    """Central film (m) as it should be, or with one thing or another in its place.

    viscosity in Pa·s; speeds: 2 for their sum; curvature: instead of 1/R_x, 1/m; coefficient: α.
    """
    rolling, across = curvatures(race)
    steel = steel_of_film()
    modulus, force = effective_modulus(steel, steel), printed("film")["load_N"]
    exact = float(elliptical_contact(force, rolling, across, modulus).ellipticity)
    scale = rolling if curvature is None else curvature
    groups = film_groups(
        speeds * check_of("U").computed * MILLIMETRE,
        force,
        scale,
        exact if ellipticity is None else ellipticity,
        modulus,
        viscosity,
        float(wooster(viscosity)) if coefficient is None else coefficient,
    )
    return float(central_film(groups)) / scale


def _steps() -> list[tuple[Text, list[float]]]:
    """Return what is put together, and the films of both conditions; m."""
    convex = {
        "curvature": 1.0 / (check_of("R, convex").computed * MILLIMETRE),
        "ellipticity": check_of("k, convex").computed,
    }
    ways: list[tuple[Text, dict[str, Any]]] = [
        (_RIGHT, {}),
        (_SUM, {"speeds": 2.0}),
        (_RADIUS, {"curvature": convex["curvature"]}),
        (_ELLIPSE, {"ellipticity": convex["ellipticity"]}),
        (_ALL, {"speeds": 2.0, **convex}),
        (_OUTER, {"race": "outer"}),
    ]
    steps = [
        (told, [_film(check_viscosity(condition), **way) for condition in _CONDITIONS])
        for told, way in ways
    ]
    warm = [float(oil_at(temperature(condition)).dynamic_viscosity) for condition in _CONDITIONS]
    steps.append((_WARM, [_film(viscosity) for viscosity in warm]))
    solved = [_solved_films(condition) for condition in _CONDITIONS]
    steps += [
        (told, [films[place] for films in solved])
        for place, told in enumerate((_PROGRAM, _PROGRAM_OUTER))
    ]
    return steps


_RIGHT = said("right.as_it_should")
_SUM = said("sum.same_with_sum")
_RADIUS = said("radius.same_with_r")
_ELLIPSE = said("ellipse.same_with_k")
_ALL = said("all.three_together_dissertatio")
_OUTER = said("outer.as_it_should")
_WARM = said("warm.as_it_should")
_PROGRAM = said("program.this_program_that")
_PROGRAM_OUTER = said("program_outer.same_outer_race")


@cache
def _solved_films(condition: str) -> tuple[float, float]:
    """Films (m) of the heaviest ball by the program's own way, inner and outer race."""
    case = Case(
        bearing=bearing(sum(clearances_of_class()) / 2.0),
        duty=Duty(inner_speed=speed(), load=Load(fz=load())),
        lubricant=oil(),
        temperature={"lubricant": temperature(condition) + ZERO_CELSIUS},
    )
    film = film_of(solve(case))
    inner, outer = film.inner.central_thickness, film.outer.central_thickness
    return float(np.nanmin(inner)), float(np.nanmin(outer))


def _choices() -> Table:
    steps = _steps()
    right = steps[0][1]
    films = [
        TableColumn(
            f"film_{condition}_um",
            said("choices.h_c_condition", condition=condition),
            tuple(f"{found[place] / MICRO:.4f}" for _, found in steps),
        )
        for place, condition in enumerate(_CONDITIONS)
    ]
    shares = TableColumn(
        "over_right",
        said("choices.over_right"),
        tuple(f"{found[0] / right[0]:.3f}" for _, found in steps),
    )
    return Table(
        number="J",
        caption=said("choices.caption"),
        source=GIVEN.source_of("contact"),
        columns=(
            TableColumn("way", said("choices.way"), tuple(told for told, _ in steps)),
            films[0],
            shares,
            films[1],
        ),
        notes=(
            said(
                "choices.printed_viscosities_hide",
                temperature_of_print=temperature_of_print() - temperature("I"),
                right=100.0 * (right[1] / steps[6][1][1] - 1.0),
            ),
        ),
    )
