"""Load ratings, rating life and the maker's life L_able: chapters 3.2, 3.4 and 4.1.2."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from rolamento.life.iso281 import MAXIMUM_LOAD
from rolamento.life.iso281_modified import fatigue_load_limit, life_modification_factor
from rolamento.life.l_able import l_able, refusals
from rolamento.life.reliability import reliability_factor
from rolamento.oil.state import viscosity_ratio
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
    said,
    speed,
    temperature,
)
from rolamento_reproductions.given import KILO
from rolamento_reproductions.record import Cell, Claim, Section, Table, TableColumn
from rolamento_reproductions.text import Text, same

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
            said("rating_numbers.static_rating.quantity"),
            given["static_rating_kN"],
            static,
            static,
            said("rating_numbers.static_rating.reason", static=static * KILO),
        ),
        Number(
            "rating",
            said("rating_numbers.rating.quantity"),
            given["dynamic_rating_kN"],
            rated,
            rated,
            said("rating_numbers.rating.reason"),
        ),
        Number(
            "share",
            said("rating_numbers.share.quantity"),
            given["load_over_rating_percent"],
            share,
            share,
            said("rating_numbers.share.reason"),
        ),
        Number(
            "margin",
            said("rating_numbers.margin.quantity"),
            given["margin_to_static_percent"],
            margin,
            margin,
            said("rating_numbers.margin.reason"),
            cut=True,
        ),
        *_factors(given, rated),
        Number(
            "basic_life",
            same("L_10h (h)"),
            printed("life")["basic_life_h"],
            basic_life_hours(catalogue),
            basic_life_hours(catalogue),
            said("rating_numbers.basic_life.reason", load=load() / catalogue),
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
            said("factors.gamma.reason"),
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
            said("by_the_standard.table_factor.quantity"),
            given["table_factor"],
            by_table,
            by_table,
            said("by_the_standard.table_factor.reason"),
        ),
        Number(
            "rating_of_table",
            said("by_the_standard.rating_of_table.quantity"),
            given["dynamic_rating_of_table_N"],
            float(dynamic_rating(*_geometry(), factor=closed)),
            rated * KILO,
            said("by_the_standard.rating_of_table.reason", closed=closed),
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
            said("by_measured_grooves.measured_factor.quantity"),
            str(printed("life")["factor_of_measured_grooves"]),
            factor,
            float(dynamic_factor(_gamma())),
            said(
                "by_measured_grooves.measured_factor.reason",
                *radii,
                *rounded,
                _factor_of_exact_grooves(),
            ),
        ),
        Number(
            "measured_rating",
            said("by_measured_grooves.measured_rating.quantity"),
            given["dynamic_rating_of_measured_N"],
            float(dynamic_rating(*_geometry(), factor=factor)),
            rated * KILO,
            said("by_measured_grooves.measured_rating.reason", raised=(raised / usual) ** 3),
        ),
        Number(
            "gain",
            said("by_measured_grooves.gain.quantity"),
            given["gain_percent"],
            gain,
            0.0,
            said("by_measured_grooves.gain.reason"),
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
        said("ratings.caption", load=load()),
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
        said("below_plastic.statement"),
        said("below_plastic.finding", *(pressure / 1e6 for pressure in (*pressures, _PERMITTED))),
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
        said("underrated.statement"),
        said("underrated.finding", found=100.0 * (1.0 - found[1] / found[0])),
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
        caption=said("reliability.caption"),
        source=GIVEN.source_of("reliability"),
        columns=(
            TableColumn(
                "reliability_percent",
                said("reliability.reliability_percent"),
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
        notes=(said("reliability.1_ln_1"),),
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
    grooves = said("nsk_number.measured_grooves") if measured else said("nsk_number.catalogue")
    return Number(
        f"{row['grooves']}_{condition}",
        said("nsk_number.quantity", condition=condition, grooves=grooves),
        row["life_h"],
        basic * factor,
        NONE,
        said(
            "nsk_number.reason",
            ratio=ratio,
            basic=basic,
            life_h=float(row["life_h"]) / basic,
            factor=factor,
            refused=_REFUSED if refused else _RAISED,
        ),
    )


_REFUSED = said("refused.maker_refuses_loads")
_RAISED = said("raised.raised_rating_is")


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
        said("nsk_table.caption", cleanliness=_cleanliness()),
        GIVEN.source_of("nsk"),
        nsk_numbers(),
        heads=(said("printed"), said("nsk_table.heads")),
        notes=(_outside(),),
    )


def _outside() -> Text:
    rating = float(GIVEN.inputs_of("ratings")["dynamic_rating_kN"]) * KILO
    return said(
        "outside.that_stand_in", maximum_load=100.0 * MAXIMUM_LOAD, load=100.0 * load() / rating
    )
