"""The bearing, duty and oil of Campanha; a printed number as one row of a table.

A row: as printed, with the author's choices, as it should be, and why.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal
from functools import cache
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case.bearing import Bearing
from rolamento.case.lubricant import Lubricant
from rolamento.case.material import Material
from rolamento.contact.hertz import HertzContact, effective_modulus, elliptical_contact
from rolamento.geometry import Race, race_curvature
from rolamento.life.iso281 import basic_rating_life, hours
from rolamento.oil.state import OilState, oil_state
from rolamento.units import MILLIMETRE, RPM
from rolamento.verification import Check, campanha_2008
from rolamento.verification.check import bearing_of, published, steel
from rolamento_reproductions.given import Given
from rolamento_reproductions.record import Cell, Claim, Table, TableColumn
from rolamento_reproductions.text import Prose, Text, fixed, same

GIVEN: Final = Given("campanha_2008")
said: Final = Prose(GIVEN.name)
MICRO: Final = 1e-6
HOUR: Final = 3600.0
ZERO_CELSIUS: Final = 273.15


def printed(name: str) -> Any:
    """Return a table of what the verification reads."""
    return published("campanha_2008")[name]


def load() -> float:
    """Return the radial load of a tested bearing; N."""
    return float(printed("life")["load_N"])


def speed() -> float:
    """Return the speed of the tests; rad/s."""
    return float(printed("life")["speed_rpm"]) * RPM


def ball_count() -> int:
    """Return Z."""
    return int(printed("bearing_6305")["ball_count"])


def pitch_diameter() -> float:
    """Return d_m; m."""
    return float(printed("bearing_6305")["pitch_diameter_mm"]) * MILLIMETRE


def basic_life_hours(rating: float) -> float:
    """Return (C/P)³ under the load and at the speed of the tests; h."""
    return float(hours(basic_rating_life(rating, load()), speed()))


def ball_diameter() -> float:
    """Return D; m."""
    return float(printed("bearing_6305")["ball_diameter_mm"]) * MILLIMETRE


def outer_conformity() -> float:
    """Return f_o, which the dissertation does not print."""
    return float(GIVEN.inputs_of("ratings")["outer_conformity"])


def bearing(clearance: float, inner_conformity: float | None = None) -> Bearing:
    """Return the 6305 with a diametral clearance (m), its inner groove as measured or another."""
    measured = printed("life")["measured_conformity"]
    table: Mapping[str, Any] = {
        **printed("bearing_6305"),
        "inner_conformity": measured if inner_conformity is None else inner_conformity,
        "outer_conformity": outer_conformity(),
    }
    return bearing_of(table, steel_of_film(), diametral_clearance=clearance)


def contact_at(ball_load: float, conformity: float, race: Race) -> HertzContact:
    """Return the contact of a ball with a race under a load in N."""
    curvature = race_curvature(ball_diameter(), pitch_diameter(), conformity, 0.0, race)
    modulus = effective_modulus(steel_of_film(), steel_of_film())
    return elliptical_contact(ball_load, curvature.rolling, curvature.across, modulus)


def clearances_of_class() -> tuple[float, float]:
    """Return the minimum and the maximum clearance of the new 6305, class C3; m."""
    low, high = (
        check.computed * MICRO for check in clearance_checks() if check.quantity.endswith("6305 C3")
    )
    return low, high


def oil() -> Lubricant:
    """Return the oil of the tests."""
    return Lubricant.named("Shell Tonna S 68")


def temperature(condition: str) -> float:
    """Return the temperature of a condition of the tests; °C."""
    states = {state["condition"]: state for state in printed("oil_in_operation")}
    return float(states[condition]["temperature_degC"])


def oil_at(celsius: ArrayLike) -> OilState:
    """Return the oil at a temperature in °C, or at several."""
    return oil_state(oil(), np.asarray(celsius, dtype=np.float64) + ZERO_CELSIUS)


@cache
def film_checks() -> tuple[Check, ...]:
    """Return the verified numbers of oil, contact and film, in the order of the dissertation."""
    return tuple(campanha_2008.film_checks())


@cache
def clearance_checks() -> tuple[Check, ...]:
    """Return the verified numbers of table 3.2 and of the clearance classes."""
    return tuple(campanha_2008.clearance_checks())


def steel_of_film() -> Material:
    """Return the steel of chapter 4.4.3."""
    film = printed("film")
    return steel(film["youngs_modulus_GPa"] * 1e9, printed("bearing_6305")["poisson_ratio"])


NUMBER_HEADS: Final = (said("printed"), said("number_heads.with_author_s"))
NONE: Final = said("none")
"""Where there is no right number, because the method does not hold for the case."""


@dataclass(frozen=True, slots=True)
class Number:
    """One printed number.

    quantity: with its unit; choices: computed with the author's choices; right: as it should be, a
    number in the same unit, or words; reason: why the two differ, or what the number rests on; cut:
    printed with its digits cut.
    """

    key: str
    quantity: Text
    printed: str
    choices: float
    right: float | Text
    reason: Text
    cut: bool = False

    @property
    def cell(self) -> Cell:
        """The printed number beside that of the author's choices."""
        return Cell(self.printed, self.choices, cut=self.cut)

    @property
    def right_text(self) -> Text:
        """The right number, with as many decimals as printed."""
        return self.right if isinstance(self.right, Text) else said_like(self.printed, self.right)


def said_like(printed: str, value: float) -> Text:
    """Say a number with as many decimals as a printed one."""
    exponent = Decimal(printed).as_tuple().exponent
    assert isinstance(exponent, int)
    return fixed(value, max(-exponent, 0))


def by_key(numbers: tuple[Number, ...]) -> dict[str, Number]:
    """Return the numbers by their keys."""
    return {number.key: number for number in numbers}


def numbers_table(
    number: str,
    caption: Text,
    source: Text,
    rows: tuple[Number, ...],
    *,
    claims: tuple[Claim, ...] = (),
    notes: tuple[Text, ...] = (),
    heads: tuple[Text, Text] = NUMBER_HEADS,
) -> Table:
    """Put numbers together as a table.

    Parameters
    ----------
    number
        Of the table.
    caption, source
        Of the table.
    rows
        The numbers, in the order of the dissertation.
    claims, notes
        Below it.
    heads
        Over the printed number and the one beside it, where that is not by the author's choices.
    """
    return Table(
        number=number,
        caption=caption,
        source=source,
        columns=(
            TableColumn("quantity", said("quantity"), tuple(row.quantity for row in rows)),
            TableColumn("number", same(""), tuple(row.cell for row in rows), heads=heads),
            TableColumn("right", said("right"), tuple(row.right_text for row in rows)),
            TableColumn("reason", said("why"), tuple(row.reason for row in rows), sentences=True),
        ),
        claims=claims,
        notes=notes,
    )
