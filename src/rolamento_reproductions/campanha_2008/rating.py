"""Load ratings, rating life and the maker's life L_able: chapters 3.2, 3.4 and 4.1.2."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from rolamento.life.iso281 import MAXIMUM_LOAD
from rolamento.life.iso281_modified import fatigue_load_limit, life_modification_factor
from rolamento.life.l_able import l_able, refusals
from rolamento.life.reliability import reliability_factor
from rolamento.lubrication.oil_state import viscosity_ratio
from rolamento.ratings import (
    dynamic_factor,
    dynamic_factor_of_grooves,
    dynamic_rating,
    static_rating,
)
from rolamento.units import MILLIMETRE
from rolamento.verification.campanha_2008 import STRIBECK
from rolamento_reproductions.campanha_2008.inputs import (
    GIVEN,
    MICRO,
    NONE,
    ZERO_CELSIUS,
    Number,
    ball_count,
    ball_diameter,
    basic_life_hours,
    contact_at,
    load,
    numbers_table,
    pitch_diameter,
    printed,
    speed,
    temperature,
)
from rolamento_reproductions.given import KILO
from rolamento_reproductions.page import PRINTED
from rolamento_reproductions.record import Cell, Claim, Section, Table, TableColumn
from rolamento_reproductions.text import Text, said, same

_PERMITTED = 4200e6
"""Pa, pressure at the static rating; ISO 76."""


def rating_section(title: Text) -> Section:
    """Compute the ratings, table 2.6.2 and the lives."""
    return Section(title, (_ratings(), _reliability(), nsk_table()))


# --- ratings and rating life ------------------------------------------------


@cache
def rating_numbers() -> tuple[Number, ...]:
    """Return the printed ratings and the rating life."""
    given = GIVEN.inputs_of("ratings")
    catalogue = float(given["dynamic_rating_kN"]) * KILO
    rated = float(dynamic_rating(*_geometry())) / KILO
    static = float(static_rating(*_geometry())) / KILO
    share = 100.0 * load() / catalogue
    margin = 100.0 * (1.0 - load() / (float(given["static_rating_kN"]) * KILO))
    return (
        Number(
            "static_rating",
            said("C_0r, catalogue (kN)", "C_0r, catálogo (kN)"),
            given["static_rating_kN"],
            static,
            static,
            said(
                "ISO 76 with the printed geometry: {:.1f} N.",
                "ISO 76 com a geometria impressa: {:.1f} N.",
                static * KILO,
            ),
        ),
        Number(
            "rating",
            said("C_r, catalogue (kN)", "C_r, catálogo (kN)"),
            given["dynamic_rating_kN"],
            rated,
            rated,
            said("ISO 281 with the printed geometry.", "ISO 281 com a geometria impressa."),
        ),
        Number(
            "share",
            said("load over C_r (%)", "carga sobre C_r (%)"),
            given["load_over_rating_percent"],
            share,
            share,
            said(
                "Rating life is defined up to C_r/2 only, and the maker's L_able too: all tests lie"
                " just outside.",
                "A vida nominal só é definida até C_r/2, assim como a L_able do fabricante: todos"
                " os ensaios ficam pouco além.",
            ),
        ),
        Number(
            "margin",
            said("load below C_0r (%)", "carga abaixo de C_0r (%)"),
            given["margin_to_static_percent"],
            margin,
            margin,
            said("Printed with its digits cut.", "Impresso com os dígitos cortados."),
            cut=True,
        ),
        *_factors(given, rated),
        Number(
            "basic_life",
            same("L_10h (h)"),
            printed("life")["basic_life_h"],
            basic_life_hours(catalogue),
            basic_life_hours(catalogue),
            said(
                "(C/P)³. The number is right; at P/C = {:.3f} it lies outside what it is defined"
                " for.",
                "(C/P)³. O número está certo; com P/C = {:.3f} está fora do que a norma define.",
                load() / catalogue,
            ),
        ),
    )


def _geometry() -> tuple[int, float, float]:
    """Return Z, D, d_m; m."""
    return ball_count(), ball_diameter(), pitch_diameter()


def _gamma() -> float:
    return ball_diameter() / pitch_diameter()


def _factors(given: dict[str, Any], rated: float) -> tuple[Number, ...]:
    return (
        Number(
            "gamma",
            same("φ = D_w/D_pw"),
            given["gamma"],
            _gamma(),
            _gamma(),
            said("The γ of this program.", "O γ deste programa."),
        ),
        *_by_the_standard(given, rated),
        *_by_measured_grooves(given, rated),
    )


def _by_the_standard(given: dict[str, Any], rated: float) -> tuple[Number, Number]:
    by_table = float(dynamic_factor(_gamma()))
    nominal = given["nominal_conformity"]
    closed = float(dynamic_factor_of_grooves(_gamma(), nominal, nominal))
    return (
        Number(
            "table_factor",
            said("f_c, conformity 0.52", "f_c, conformidade 0,52"),
            given["table_factor"],
            by_table,
            by_table,
            said("Interpolated in the table of ISO 281.", "Interpolado na tabela da ISO 281."),
        ),
        Number(
            "rating_of_table",
            said("C_r, conformity 0.52 (N)", "C_r, conformidade 0,52 (N)"),
            given["dynamic_rating_of_table_N"],
            float(dynamic_rating(*_geometry(), factor=closed)),
            rated * KILO,
            said(
                "Not with the printed f_c of the table, but with {:.2f} of the closed form behind"
                " it; the table's gives the number on the right.",
                "Não com o f_c impresso da tabela, mas com {:.2f} da forma fechada por trás dela; o"
                " da tabela dá o número da direita.",
                closed,
            ),
        ),
    )


def _by_measured_grooves(given: dict[str, Any], rated: float) -> tuple[Number, Number, Number]:
    raised, usual = (
        float(given[name]) for name in ("dynamic_rating_of_measured_N", "dynamic_rating_of_table_N")
    )
    gain = 100.0 * (raised / usual - 1.0)
    radii = (printed("life")["groove_radius_mm"], given["outer_groove_mm"])
    rounded = [
        round(radius * MILLIMETRE / ball_diameter(), given["conformity_digits"]) for radius in radii
    ]
    factor = float(dynamic_factor_of_grooves(_gamma(), *rounded))
    return (
        Number(
            "measured_factor",
            said("f_c, measured conformity 0.505", "f_c, conformidade medida 0,505"),
            str(printed("life")["factor_of_measured_grooves"]),
            factor,
            float(dynamic_factor(_gamma())),
            said(
                "The closed form with grooves of {:.2f} and {:.2f} mm (the outer is not printed)"
                " over D, rounded to {:.4f} and {:.4f}. With 0.505 itself it is {:.1f}. The"
                " standard lets nobody raise a rating for grooves closer than 0.52: the table's"
                " factor stays.",
                "A forma fechada com canais de {:.2f} e {:.2f} mm (o externo não é impresso) sobre"
                " D, arredondados a {:.4f} e {:.4f}. Com 0,505 exato dá {:.1f}. A norma não permite"
                " elevar a capacidade por canais mais fechados que 0,52: fica o fator da tabela.",
                *radii,
                *rounded,
                _factor_of_exact_grooves(),
            ),
        ),
        Number(
            "measured_rating",
            said("C_r, measured conformity (N)", "C_r, conformidade medida (N)"),
            given["dynamic_rating_of_measured_N"],
            float(dynamic_rating(*_geometry(), factor=factor)),
            rated * KILO,
            said(
                "Follows f_c. Life goes with the cube: {:.1f} times as long, on paper.",
                "Segue f_c. A vida vai com o cubo: {:.1f} vezes maior, no papel.",
                (raised / usual) ** 3,
            ),
        ),
        Number(
            "gain",
            said("C_r above the catalogue's (%)", "C_r acima da do catálogo (%)"),
            given["gain_percent"],
            gain,
            0.0,
            said(
                "“Approximately”; of the two printed ratings. Rightly there is no gain to be"
                " claimed.",
                "“Aproximadamente”; das duas capacidades impressas. O correto é não haver ganho a"
                " reivindicar.",
            ),
        ),
    )


def _factor_of_exact_grooves() -> float:
    life = printed("life")
    return float(
        dynamic_factor_of_grooves(_gamma(), life["measured_conformity"], life["outer_conformity"])
    )


def _ratings() -> Table:
    return numbers_table(
        "B",
        said(
            "Ratings and rating life of the 6305 under {:,.0f} N at 2000 rpm.",
            "Capacidades e vida nominal do 6305 sob {:,.0f} N a 2000 rpm.",
            load(),
        ),
        GIVEN.source_of("ratings"),
        rating_numbers(),
        claims=(_below_plastic(), _underrated()),
    )


def _below_plastic() -> Claim:
    heaviest = STRIBECK * load() / ball_count()
    nominal = GIVEN.inputs_of("ratings")["nominal_conformity"]
    measured = printed("life")["measured_conformity"]
    pressures = [
        float(contact_at(heaviest, conformity, "inner").max_pressure)
        for conformity in (nominal, measured)
    ]
    return Claim(
        said(
            "The load stays below the static rating, so as not to deform the bearing plastically.",
            "A carga fica abaixo da capacidade estática, para não deformar plasticamente o"
            " rolamento.",
        ),
        said(
            "{:.0f} MPa at the heaviest ball with the catalogue's groove of 0.52, {:.0f} MPa with"
            " the measured one; the limit is {:.0f} MPa, at which the dent is already 1/10 000 of"
            " the ball.",
            "{:.0f} MPa na esfera mais carregada com o canal de catálogo, 0,52, {:.0f} MPa com o"
            " medido; o limite é {:.0f} MPa, em que a marca já é 1/10 000 da esfera.",
            *(pressure / 1e6 for pressure in (*pressures, _PERMITTED)),
        ),
        max(pressures) < _PERMITTED,
    )


def _underrated() -> Claim:
    """The dissertation's conclusion on the catalogue's rating."""
    nominal = GIVEN.inputs_of("ratings")["nominal_conformity"]
    heaviest = STRIBECK * load() / ball_count()
    found = [
        float(contact_at(heaviest, conformity, "inner").max_pressure)
        for conformity in (nominal, printed("life")["measured_conformity"])
    ]
    return Claim(
        said(
            "The catalogue's rating is too low, because it rests on the standard's conformity and"
            " not on the real one.",
            "A capacidade de catálogo está subdimensionada, pois se baseia na conformidade da norma"
            " e não na real.",
        ),
        said(
            "The closer groove does lower the inner pressure, by {:.0f} %, and by theory the inner"
            " race lives longer. But the standard says that closer grooves need not raise the"
            " capacity, and lets nobody rate them higher; friction and heat grow with them.",
            "O canal mais fechado de fato reduz a pressão interna, em {:.0f} %, e pela teoria a"
            " pista interna dura mais. Mas a norma diz que canais mais fechados não elevam"
            " necessariamente a capacidade e não permite classificá-los acima; atrito e calor"
            " crescem com eles.",
            100.0 * (1.0 - found[1] / found[0]),
        ),
        holds=False,
        partly=True,
    )


# --- table 2.6.2 ------------------------------------------------------------


def _reliability() -> Table:
    given = GIVEN.inputs_of("reliability")
    survival = np.array(given["percent"], dtype=np.float64) / 100.0
    old = reliability_factor(survival, "1990")
    new = reliability_factor(survival, "2007")
    return Table(
        number="2.6.2",
        caption=said(
            "Factor a_1 of the reliability: ISO 281:1990, as printed, and ISO 281:2007, which"
            " replaced it.",
            "Fator a_1 da confiabilidade: ISO 281:1990, como impresso, e ISO 281:2007, que a"
            " substituiu.",
        ),
        source=GIVEN.source_of("reliability"),
        columns=(
            TableColumn(
                "reliability_percent",
                said("Reliability (%)", "Confiabilidade (%)"),
                tuple(str(percent) for percent in given["percent"]),
            ),
            TableColumn(
                "a1_1990",
                same("a_1 (1990)"),
                tuple(Cell(p, float(v)) for p, v in zip(given["factors"], old, strict=True)),
            ),
            TableColumn(
                "a1_2007", same("a_1 (2007)"), tuple(f"{float(value):.2f}" for value in new)
            ),
        ),
        notes=(
            said(
                "a_1 = [ln(1/S)/ln(1/0.9)]^(2/3); since 2007 0.95 times that, plus 0.05: a life"
                " that practically every bearing reaches.",
                "a_1 = [ln(1/S)/ln(1/0,9)]^(2/3); desde 2007, 0,95 vezes isso mais 0,05: uma vida"
                " que praticamente todo rolamento atinge.",
            ),
        ),
    )


@cache
def nsk_numbers() -> tuple[Number, ...]:
    """Return the printed lives of NSK's method beside the stand-in for its charts."""
    return tuple(_nsk_number(row) for row in GIVEN.inputs_of("nsk")["row"])


def _nsk_number(row: dict[str, Any]) -> Number:
    rating, condition = float(row["dynamic_rating_N"]), row["condition"]
    measured = row["grooves"] == "measured"
    basic = basic_life_hours(rating)
    ratio = _viscosity_ratio(condition)
    factor = float(life_modification_factor(ratio, _cleanliness(), _fatigue_limit(rating), load()))
    given = refusals(
        load(),
        rating,
        float(GIVEN.inputs_of("ratings")["static_rating_kN"]) * KILO,
        speed(),
        temperature(condition) + ZERO_CELSIUS,
    )
    refused = not np.isfinite(float(l_able(basic, factor, given)))
    grooves = (
        said("measured grooves", "canais medidos") if measured else said("catalogue", "catálogo")
    )
    return Number(
        f"{row['grooves']}_{condition}",
        said("L_able, condition {}, {} (h)", "L_able, condição {}, {} (h)", condition, grooves),
        row["life_h"],
        basic * factor,
        NONE,
        said(
            "κ = {:.2f}, L_10h = {:.1f} h, so that the printed life stands for a_NSK = {:.2f}; the"
            " stand-in has {:.2f}. {}",
            "κ = {:.2f}, L_10h = {:.1f} h, de modo que a vida impressa equivale a a_NSK = {:.2f}; o"
            " substituto tem {:.2f}. {}",
            ratio,
            basic,
            float(row["life_h"]) / basic,
            factor,
            _REFUSED if refused else _RAISED,
        ),
    )


_REFUSED = said(
    "The maker refuses loads above C_r/2.", "O fabricante recusa cargas acima de C_r/2."
)
_RAISED = said(
    "The raised rating is not one that the standard allows.",
    "A capacidade elevada não é uma que a norma admita.",
)


def _viscosity_ratio(condition: str) -> float:
    viscosity = GIVEN.inputs_of("contact")["viscosities_mm2_s"][condition] * MICRO
    return float(viscosity_ratio(viscosity, speed(), pitch_diameter()))


def _cleanliness() -> float:
    return float(GIVEN.inputs_of("nsk")["contamination_factor"])


def _fatigue_limit(rating: float) -> float:
    """C_0/22, raised as the dynamic rating is."""
    given = GIVEN.inputs_of("ratings")
    limit = fatigue_load_limit(float(given["static_rating_kN"]) * KILO, pitch_diameter())
    return float(limit) * rating / (float(given["dynamic_rating_kN"]) * KILO)


def nsk_table() -> Table:
    """Return the printed lives as a table."""
    return numbers_table(
        "C",
        said(
            "NSK's life beside a stand-in. The maker's a_NSK is a chart that is not redrawn here;"
            " in its place a_ISO of ISO 281:2007 with e_C = a_c = {:.1f} and the printed"
            " viscosities.",
            "Vida pela NSK ao lado de um substituto. O a_NSK do fabricante é um gráfico que não se"
            " redesenha aqui; em seu lugar, a_ISO da ISO 281:2007 com e_C = a_c = {:.1f} e as"
            " viscosidades impressas.",
            _cleanliness(),
        ),
        GIVEN.source_of("nsk"),
        nsk_numbers(),
        heads=(PRINTED, said("stand-in", "substituto")),
        notes=(_outside(),),
    )


def _outside() -> Text:
    rating = float(GIVEN.inputs_of("ratings")["dynamic_rating_kN"]) * KILO
    return said(
        "That the stand-in comes near does not make it right: both methods end at P = {:.0f} % of"
        " C_r, and the tests have {:.1f} %. Nearest to a calculated life is the reference life of"
        " ISO/TS 16281, from the loads of the single balls (table D); a life for this load takes"
        " tests.",
        "Que o substituto chegue perto não o torna certo: os dois métodos terminam em P = {:.0f} %"
        " de C_r, e os ensaios têm {:.1f} %. O mais próximo de uma vida calculada é a de referência"
        " da ISO/TS 16281, com as cargas de cada esfera (tabela D); uma vida para esta carga exige"
        " ensaios.",
        100.0 * MAXIMUM_LOAD,
        100.0 * load() / rating,
    )
