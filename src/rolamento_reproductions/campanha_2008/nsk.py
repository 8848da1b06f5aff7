"""The maker's life L_able beside a stand-in for its charts: chapters 3.4.1 and 4.1.2."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from rolamento.life.iso281 import MAXIMUM_LOAD
from rolamento.life.iso281_modified import fatigue_load_limit, life_modification_factor
from rolamento.life.l_able import l_able, refusals
from rolamento.lubrication.oil_state import viscosity_ratio
from rolamento_reproductions.campanha_2008.inputs import (
    GIVEN,
    MICRO,
    ZERO_CELSIUS,
    basic_life_hours,
    load,
    pitch_diameter,
    speed,
    temperature,
)
from rolamento_reproductions.campanha_2008.numbers import NONE, Number, numbers_table
from rolamento_reproductions.given import KILO
from rolamento_reproductions.record import Table
from rolamento_reproductions.text import Text, said
from rolamento_reproductions.wording import PRINTED

__all__ = ["nsk_numbers", "nsk_table"]


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
