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
    speed,
    steel_of_film,
    temperature,
)
from rolamento_reproductions.record import Claim, Section, Table, TableColumn
from rolamento_reproductions.text import Text, said

REGIMES = {
    "full_film": said("full film", "filme completo"),
    "partial": said("partial", "parcial"),
    "boundary": said("boundary", "limítrofe"),
    "adhesive": said("adhesive", "adesivo"),
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
        said("h_c, condition {} (µm)", "h_c, condição {} (µm)", condition),
        check.printed,
        evidence(check),
        check.computed,
        said(
            "Sum of the speeds, convex groove, x and y exchanged: the first makes the film thicker,"
            " the others thinner, and they nearly cancel (table J). Right with the printed"
            " viscosity.",
            "Soma das velocidades, canal convexo, x e y trocados: a primeira engrossa o filme, os"
            " outros o afinam, e quase se compensam (tabela J). Correto com a viscosidade"
            " impressa.",
        ),
    )


def _rms(row: dict[str, Any]) -> Number:
    mean = row["mean_um"]
    inner = row["part"] == "inner"
    part = said("inner race", "pista interna") if inner else said("ball", "esfera")
    return Number(
        f"rms_{row['bearing']}_{row['part']}",
        said("σ, bearing {}, {} (µm)", "σ, rolamento {}, {} (µm)", row["bearing"], part),
        row["rms_um"],
        _USUAL_RATIO * mean,
        float(rms_of_mean_roughness(mean)),
        said(
            "1.25 R_a = 1.25 · {:.4f} µm; of a Gaussian surface √(π/2) R_a. A worn one need not be"
            " Gaussian.",
            "1,25 R_a = 1,25 · {:.4f} µm; em superfície gaussiana, √(π/2) R_a. Uma gasta pode não"
            " o ser.",
            mean,
        ),
    )


def _parameters() -> list[tuple[dict[str, Any], Check]]:
    """Return the cases of λ with their numbers, as printed."""
    checks = [check for check in film_checks() if check.quantity.startswith("λ")]
    return list(zip(printed("film")["lambda"], checks, strict=True))


def _parameter(case: dict[str, Any], check: Check) -> Number:
    bearing_of_case = (
        said("new bearing", "rolamento novo")
        if case["bearing"] == "new"
        else said("bearing {} after test", "rolamento {} após ensaio", case["bearing"])
    )
    before, after = (_regime(value) for value in (evidence(check), check.computed))
    return Number(
        f"lambda_{case['condition']}_{case['bearing']}",
        said("λ, condition {}, {}", "λ, condição {}, {}", case["condition"], bearing_of_case),
        check.printed,
        evidence(check),
        check.computed,
        said(
            "Follows h_c. By the dissertation's own limits: {} as printed, {} as it should be.",
            "Segue h_c. Pelos limites da própria dissertação: {} como impresso, {} no correto.",
            before,
            after,
        ),
    )


def _regime(parameter: float) -> Text:
    regime = regime_of(parameter)
    assert regime is not None
    return REGIMES[regime.name]


def _films() -> Table:
    return numbers_table(
        "I",
        said(
            "Film and film parameter λ at the inner race.",
            "Filme e parâmetro de filme λ na pista interna.",
        ),
        GIVEN.source_of("contact"),
        film_numbers(),
        claims=(_speed_doubted(), _pressure_doubted()),
    )


def _speed_doubted() -> Claim:
    check = check_of("U")
    ratio = float(check.printed) / check.computed
    return Claim(
        said(
            "The formula of the mean speed seems unfit for the theory of the film (chapter 5).",
            "A formulação da velocidade média parece inadequada à teoria do filme (capítulo 5).",
        ),
        said(
            "The suspicion is right: the printed speed is {:.3f} times the mean of both surfaces,"
            " which the theory rests on. Rolling without sliding is what it was made for.",
            "A suspeita procede: a velocidade impressa é {:.3f} vezes a média das duas superfícies,"
            " em que a teoria se baseia. É para rolagem sem deslizamento que ela foi feita.",
            ratio,
        ),
        holds=abs(ratio - 1.0) > 0.1,
    )


def _pressure_doubted() -> Claim:
    viscosity = check_viscosity("I")
    both = [_film(viscosity, coefficient=float(wooster(viscosity)) * k) for k in (1.0, 1.1)]
    return Claim(
        said(
            "Barus's law was used, and the film may be off by how viscosity depends on pressure"
            " (chapter 5).",
            "Usou-se a lei de Barus, e o filme pode divergir pela dependência entre viscosidade e"
            " pressão (capítulo 5).",
        ),
        said(
            "No law of high pressures enters h_c: it forms in the inlet, and only the slope α"
            " counts, which Barus and Roelands share. 10 % more α gives {:.0f} % more film.",
            "Nenhuma lei de altas pressões entra em h_c: o filme se forma na entrada, e só conta a"
            " inclinação α, comum a Barus e Roelands. 10 % a mais em α dão {:.0f} % a mais de"
            " filme.",
            100.0 * (both[1] / both[0] - 1.0),
        ),
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


_RIGHT = said(
    "as it should be: mean speed, R_x of rolling, exact ellipse",
    "como deve ser: velocidade média, R_x na rolagem, elipse exata",
)
_SUM = said("the same with the sum of the speeds", "idem com a soma das velocidades")
_RADIUS = said(
    "the same with R′ of a convex groove for R_x", "idem com R′ de um canal convexo em vez de R_x"
)
_ELLIPSE = said(
    "the same with k of a convex groove, x and y exchanged",
    "idem com k de um canal convexo, x e y trocados",
)
_ALL = said("the three together: the dissertation", "os três juntos: a dissertação")
_OUTER = said(
    "as it should be, outer race (f_o = 0.53)", "como deve ser, pista externa (f_o = 0,53)"
)
_WARM = said(
    "as it should be, with the oil at the mean temperature, its density too",
    "como deve ser, com o óleo à temperatura média, também na densidade",
)
_PROGRAM = said(
    "this program: that oil, ball loads by equilibrium, heat of shear; inner race",
    "este programa: esse óleo, cargas pelo equilíbrio, calor de cisalhamento; pista interna",
)
_PROGRAM_OUTER = said("the same, outer race", "idem, pista externa")


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
            said("h_c, condition {} (µm)", "h_c, condição {} (µm)", condition),
            tuple(f"{found[place] / MICRO:.4f}" for _, found in steps),
        )
        for place, condition in enumerate(_CONDITIONS)
    ]
    shares = TableColumn(
        "over_right",
        said("over the first row (I)", "sobre a primeira linha (I)"),
        tuple(f"{found[0] / right[0]:.3f}" for _, found in steps),
    )
    return Table(
        number="J",
        caption=said(
            "What each choice does to the central film.", "O que cada escolha faz ao filme central."
        ),
        source=GIVEN.source_of("contact"),
        columns=(
            TableColumn("way", said("Calculation", "Cálculo"), tuple(told for told, _ in steps)),
            films[0],
            shares,
            films[1],
        ),
        notes=(
            said(
                "The printed viscosities hide two more choices, which nearly cancel in condition I:"
                " a temperature {:.1f} °C too high makes the oil thinner, the density of 20 °C"
                " makes it thicker. In condition II only the density is left, and the film {:.0f} %"
                " too thick for it.",
                "As viscosidades impressas escondem outras duas escolhas, que quase se compensam na"
                " condição I: uma temperatura {:.1f} °C alta demais afina o óleo, a densidade de"
                " 20 °C o engrossa. Na condição II resta só a densidade, e o filme fica {:.0f} %"
                " mais espesso por ela.",
                temperature_of_print() - temperature("I"),
                100.0 * (right[1] / steps[6][1][1] - 1.0),
            ),
        ),
    )
