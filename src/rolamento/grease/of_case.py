"""The grease of a case: how long it lives, when it wants renewing, how much, and which."""

from __future__ import annotations

import os
from math import exp, isfinite, isnan, log, nan
from typing import Any, Final

import numpy as np

from rolamento.analysis.speed_limits import Boundary, speed_limits
from rolamento.case import Case, case_of
from rolamento.case.grease import BaseOil, Grease, Thickener
from rolamento.errors import InputError
from rolamento.grease.amount import fag_amount, skf_amount
from rolamento.grease.estimate import GreaseDuty, GreaseLife, figures, l10_of_mean
from rolamento.grease.models import MODELS
from rolamento.grease.nsk import nsk_grease
from rolamento.grease.relubrication import Interval, base_interval, intervals
from rolamento.io.json import dumps
from rolamento.life.basis import Basis
from rolamento.life.conditions import conditions_of
from rolamento.life.row_ratings import UnratedError
from rolamento.lubrication.oil_choice import OilChoice, choose_oil
from rolamento.records import frozen
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.types import of_balls
from rolamento.units import HOUR, ZERO_CELSIUS
from rolamento.validate import finite
from rolamento.words import Note, said

__all__ = ["GREASE_KAPPA", "GreaseCase", "grease_of_case", "grease_of_solved"]

SCHEMA: Final = 1
GREASE_KAPPA: Final = 1.5
"""κ that the base oil is to have if none is wanted: between 1 and 4, as makers advise."""
_SEALS: Final = ("seal", "shield")
_BOTH: Final = "both sides"
_ASSUMED_TEMPERATURE: Final = 70.0 + ZERO_CELSIUS

CaseSource = Case | str | os.PathLike[str]
"""A case, or its file."""


@frozen(eq=False)
class GreaseCase:
    """The grease of one case.

    Attributes
    ----------
    solved
        the case
    duty
        what ages the grease
    sealed
        whether it is in for life
    lives
        by every law, of bearings of one row of deep grooves with seals; else empty
    base
        relubrication interval under reference conditions, h; of sealed bearings NaN
    intervals
        with every set of factors; of sealed bearings empty
    amount_side, amount_middle, amount_fag
        of one relubrication, kg; NaN where D and B are not known
    usable
        temperatures between which the grease may be used, K
    oil
        base oil that κ wants, and the ISO grades beside it; None at rest
    nlgi
        consistency to take
    vertical
        whether the shaft stands upright
    notes
        what was inferred, and what to know
    """

    solved: Solved
    duty: GreaseDuty
    sealed: bool
    lives: tuple[GreaseLife, ...]
    base: float
    intervals: tuple[Interval, ...]
    amount_side: float
    amount_middle: float
    amount_fag: float
    usable: tuple[float, float]
    oil: OilChoice | None
    nlgi: int
    vertical: bool
    notes: tuple[Note, ...]

    @property
    def hours(self) -> float:
        """Mean life of the grease, the geometric mean of the laws; h, NaN without one."""
        known = [log(one.hours) for one in self.lives if one.valid]
        return exp(sum(known) / len(known)) if known else nan

    @property
    def spread(self) -> tuple[float, float]:
        """Least and greatest mean life by the laws; h."""
        known = [one.hours for one in self.lives if one.valid]
        return (min(known), max(known)) if known else (nan, nan)

    @property
    def l10(self) -> float:
        """Life of the grease that 90 % of the bearings reach, from the mean; h."""
        return l10_of_mean(self.hours)

    @property
    def interval(self) -> tuple[float, float]:
        """Least and greatest relubrication interval of all sets of factors; h."""
        known = [x for one in self.intervals for x in (one.low, one.high) if isfinite(x)]
        return (min(known), max(known)) if known else (nan, nan)

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values: SI, hours and kg; NaN as None."""
        duty, low_high = self.duty, (*self.spread, *self.interval)
        return {
            "schema": SCHEMA,
            "kind": "grease",
            "title": self.solved.title,
            "temperature": finite(duty.temperature),
            "speed": duty.speed,
            "limiting_speed": finite(duty.limiting_speed),
            "speed_ratio": finite(duty.speed_ratio),
            "n_dm": finite(duty.speed_factor),
            "load_ratio": finite(duty.load_ratio),
            "thickener": duty.thickener,
            "base_oil": duty.base_oil,
            "sealed": self.sealed,
            "vertical_shaft": self.vertical,
            "lives": [one.to_mapping() for one in self.lives],
            "hours": finite(self.hours),
            "l10": finite(self.l10),
            **dict(
                zip(
                    ("minimum_life", "maximum_life", "minimum_interval", "maximum_interval"),
                    map(finite, low_high),
                    strict=True,
                )
            ),
            "base_interval": finite(self.base),
            "intervals": [one.to_mapping() for one in self.intervals],
            "amount": {
                "skf_side": finite(self.amount_side),
                "skf_middle": finite(self.amount_middle),
                "fag": finite(self.amount_fag),
            },
            "usable_temperatures": list(self.usable),
            "oil": None if self.oil is None else self.oil.to_mapping(),
            "nlgi": self.nlgi,
            "notes": [note.to_mapping() for note in self.notes],
            "case": self.solved.case.to_mapping(),
        }

    def to_json(self) -> str:
        """Return all of it as one JSON object."""
        return dumps(self.to_mapping(), indent=2)


def grease_of_case(case: CaseSource, *, kappa: float = GREASE_KAPPA) -> GreaseCase:
    """Solve a case, and find how long its grease lives and what it needs.

    Parameters
    ----------
    case
        Or its file, or a designation; with a speed, a load and the lubricant's temperature.
    kappa
        κ that the base oil is to have.

    Raises
    ------
    InputError
        If the lubrication is dry, or κ is out of range.

    >>> case = Case(
    ...     bearing="6205-2RS1",
    ...     duty={"inner_speed": "3000 rpm", "load": {"fz": "500 N"}},
    ...     temperature={"lubricant": "70 degC"},
    ... )
    >>> found = grease_of_case(case)
    >>> found.sealed, [one.name for one in found.lives if one.valid]
    (True, ['nsk_general', 'kawamura_lithium', 'jtekt'])
    """
    return grease_of_solved(solve(case_of(case)), kappa=kappa)


def grease_of_solved(solved: Solved, *, kappa: float = GREASE_KAPPA) -> GreaseCase:
    """Find how long the grease of a solved case lives and what it needs.

    Parameters
    ----------
    solved
        A single case.
    kappa
        κ that the base oil is to have.

    Raises
    ------
    InputError
        As `grease_of_case`.
    """
    return _Asked(solved, kappa).answer()


class _Asked:
    def __init__(self, solved: Solved, kappa: float) -> None:
        self.solved = solved
        self.case = solved.delivered_case
        self.kappa = kappa
        self.given = self.case.grease or Grease()
        self.notes: list[Note] = []
        lubricant = self.case.lubricant
        if lubricant is not None and lubricant.kind == "dry":
            raise InputError(
                said("is dry: there is no grease"), field="lubricant.kind", value="dry",
                example='kind = "grease"',
            )  # fmt: skip
        self.speeds = speed_limits(self.case)

    def answer(self) -> GreaseCase:
        lubricant = self.case.lubricant
        if lubricant is None:
            self.notes.append(Note("grease_assumed"))
        elif lubricant.kind == "oil":
            self.notes.append(Note("grease_instead_of_oil", {"oil": lubricant.name}))
        thickener, base_oil = self._kind()
        sealed, duty = self._sealed(), self._duty(thickener, base_oil)
        deep = self._is_deep_groove
        lives: tuple[GreaseLife, ...] = ()
        if sealed and deep and duty.speed > 0.0:
            lives = tuple(law.evaluate(duty) for law in MODELS.values())
            most = figures()["reliable"]["most_hours"]
            if any(one.hours > most for one in lives):
                self.notes.append(Note("grease_beyond_tests", {"limit": most * HOUR}))
        elif sealed and not deep:
            self.notes.append(Note("grease_laws_of_deep_groove"))
        if not duty.speed > 0.0:
            self.notes.append(Note("grease_at_rest"))
        boundary = self.speeds.boundary
        base, found = (nan, ()) if sealed else self._intervals(duty, boundary)
        side, middle, fag = self._amounts(boundary, found)
        oil = self._oil(duty)
        self._limits(duty)
        cold = duty.celsius < figures()["nlgi"]["cold_below"]
        stiff = "vertical" if self.given.vertical_shaft else "cold" if cold else "usual"
        return GreaseCase(
            solved=self.solved,
            duty=duty,
            sealed=sealed,
            lives=lives,
            base=base,
            intervals=found,
            amount_side=side,
            amount_middle=middle,
            amount_fag=fag,
            usable=self._usable(base_oil),
            oil=oil,
            nlgi=int(figures()["nlgi"][stiff]),
            vertical=self.given.vertical_shaft,
            notes=tuple(self.notes),
        )

    # --- what the case says ---------------------------------------------------------------------

    def _kind(self) -> tuple[Thickener, BaseOil]:
        """Thickener and base oil, as given or inferred."""
        lubricant = self.case.lubricant
        type_ = None if lubricant is None else lubricant.oil.oil_type
        inferred: BaseOil = "pao" if type_ == "synthetic" else "mineral"
        thickener, base_oil = self.given.thickener, self.given.base_oil
        if thickener is None or base_oil is None:
            values = {"thickener": thickener or "lithium", "base_oil": base_oil or inferred}
            self.notes.append(Note("grease_kind_inferred", values))
        return thickener or "lithium", base_oil or inferred

    def _sealed(self) -> bool:
        if self.given.sealed is not None:
            return self.given.sealed
        resolved = self.case.bearing.resolved
        if resolved is None:
            self.notes.append(Note("grease_open_assumed"))
            return False
        letters = resolved.designation.letters
        for part in letters.parts:
            is_seal = any(word in part.meaning for word in _SEALS)
            if is_seal and _BOTH in part.meaning:
                self.notes.append(Note("grease_sealed_by_designation", {"part": part.text}))
                return True
        self.notes.append(Note("grease_open_by_designation"))
        return False

    @property
    def _is_deep_groove(self) -> bool:
        """Whether it is one row of balls in deep grooves, for which the laws are made."""
        bearing = self.case.bearing
        resolved = bearing.resolved
        type_ = bearing.bearing_type if resolved is None else resolved.bearing.type
        return type_ == of_balls(angled=False) and len(bearing.places) == 1

    def _duty(self, thickener: Thickener, base_oil: BaseOil) -> GreaseDuty:
        case, row = self.case, self.case.bearing.places[0].bearing
        swing = case.duty.oscillation
        speed = self.speeds.speed
        if swing is not None:
            speed = 2.0 * swing.angle * (swing.frequency or 0.0)
            self.notes.append(Note("grease_oscillates", {"speed": speed}))
        outer = bool(case.duty.outer_speed) and not case.duty.inner_speed
        gamma = row.element_diameter / row.pitch_diameter * abs(np.cos(row.contact_angle or 0.0))
        return GreaseDuty(
            temperature=self._temperature(),
            speed=speed,
            limiting_speed=self._limiting_speed(),
            mean_diameter=self.speeds.mean_diameter,
            load_ratio=self._load_ratio(),
            thickener=thickener,
            base_oil=base_oil,
            outer_ring_turns=outer,
            ratio=float(gamma),
        )

    def _temperature(self) -> float:
        """The hottest of lubricant and rings; 70 °C where none is given."""
        own = self.case.temperature
        names = ("lubricant", "inner_ring", "outer_ring")
        known = [t for name in names if (t := getattr(own, name, None)) is not None]
        if known:
            return float(max(known))
        self.notes.append(Note("grease_temperature_assumed", {"temperature": _ASSUMED_TEMPERATURE}))
        return _ASSUMED_TEMPERATURE

    def _limiting_speed(self) -> float:
        """N with grease: as given, of the maker's class, or three quarters of that with oil."""
        if self.given.limiting_speed is not None:
            return self.given.limiting_speed
        by_name = {limit.name: limit for limit in self.speeds.limits}
        if "grease" in by_name:
            speed = by_name["grease"].speed
            self.notes.append(Note("grease_limit_of_class", {"speed": speed}))
            return speed
        self.notes.append(Note("grease_limit_missing"))
        return nan

    def _load_ratio(self) -> float:
        """P/C; by the reference load where there is no P, NaN where there is neither."""
        if not self.solved.converged[0]:
            return nan
        try:
            basis = Basis.of(self.solved, conditions_of(self.solved))
        except UnratedError:
            return nan
        load, reference = float(basis.loads.dynamic[0]), float(basis.reference_load[0])
        taken = load if isfinite(load) and load > 0.0 else reference
        return taken / float(basis.ratings.dynamic_of_set[0])

    # --- what follows ---------------------------------------------------------------------------

    def _intervals(
        self, duty: GreaseDuty, boundary: Boundary
    ) -> tuple[float, tuple[Interval, ...]]:
        bearing, row = self.case.bearing, self.case.bearing.places[0].bearing
        if boundary.bore is None:
            self.notes.append(Note("grease_without_sizes"))
            return nan, ()
        if not duty.speed > 0.0:
            return nan, ()
        base = base_interval(
            duty.speed, boundary.bore, row.element, axial=bearing.bearing_type.washers
        )
        if isnan(base):
            self.notes.append(Note("grease_beyond_interval"))
            return nan, ()
        outside, mean = boundary.outside_diameter, boundary.mean_diameter
        turning = outside is not None and mean is not None and duty.outer_ring_turns
        ratio = outside / mean if turning and outside and mean else 1.0
        level = None if self.case.life is None else self.case.life.grease_cleanliness
        if level is None:
            self.notes.append(Note("grease_cleanliness_assumed"))
        found = intervals(
            base,
            duty.temperature,
            duty.load_ratio,
            level or "normal",
            vertical=self.given.vertical_shaft,
            bore=boundary.bore,
            sizes_ratio=ratio,
        )
        if any(one.name == "fag" and isnan(one.low) for one in found):
            self.notes.append(Note("grease_beyond_fag"))
        return base, found

    def _amounts(
        self, boundary: Boundary, found: tuple[Interval, ...]
    ) -> tuple[float, float, float]:
        outside, width = boundary.outside_diameter, boundary.width
        if outside is None or width is None:
            return nan, nan, nan
        after = min((one.low for one in found if isfinite(one.low)), default=nan)
        fag = fag_amount(outside, width, after) if isfinite(after) else nan
        return skf_amount(outside, width), skf_amount(outside, width, "middle"), fag

    def _oil(self, duty: GreaseDuty) -> OilChoice | None:
        if not duty.speed > 0.0:
            return None
        pitch = min(place.bearing.pitch_diameter for place in self.case.bearing.places)
        return choose_oil(duty.speed, pitch, self.kappa, duty.temperature, duty.temperature)

    def _usable(self, base_oil: BaseOil) -> tuple[float, float]:
        """Temperatures between which the grease may be used: its own, else those of its kind."""
        low, high = figures()["nsk"][nsk_grease(base_oil)]["usable"]
        lubricant = self.case.lubricant
        own = None if lubricant is None else lubricant.oil
        least = None if own is None else own.minimum_temperature
        most = None if own is None else own.maximum_temperature
        return (
            low + ZERO_CELSIUS if least is None else least,
            high + ZERO_CELSIUS if most is None else most,
        )

    def _limits(self, duty: GreaseDuty) -> None:
        low, high = self._usable(duty.base_oil)
        values = {"temperature": duty.temperature, "least": low, "most": high}
        if duty.temperature > high:
            self.notes.append(Note("grease_above_its_limit", values))
        elif duty.temperature < low:
            self.notes.append(Note("grease_under_its_limit", values))
        if duty.speed_ratio > 1.0:
            self.notes.append(Note("grease_above_speed", {"ratio": duty.speed_ratio}))
