"""Keep or replace: what a Weibull distribution says of bearings in service, from end to end."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from datetime import date, datetime, time
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError, arguments
from rolamento.io.dates import dates_of, days_between, moment_said
from rolamento.records import frozen
from rolamento.weibull import LifeTest, read_life_test
from rolamento.weibull.distribution import LifeDistribution
from rolamento.weibull.fleet import Fleet, FleetForecast, fleet_forecast
from rolamento.weibull.fleet_table import FleetTable, read_fleet
from rolamento.weibull.goodness import goodness_of_fit
from rolamento.weibull.life_test import UNKNOWN_MODE
from rolamento.weibull.life_units import life_in, life_with_unit
from rolamento.weibull.replacement import AgeReplacement, age_replacement
from rolamento.weibull.residual import RemainingLife, remaining_life
from rolamento.words import Note, said

__all__ = [
    "FleetStudy",
    "RemainingStudy",
    "ReplacementStudy",
    "fleet_study",
    "remaining_study",
    "replacement_study",
]

SCHEMA: Final = 1
ALL_MODES: Final = "all"
"""In the place of a failure mode: all failures alike."""
_SAMPLES, _FEWEST_SAMPLES = 10_000, 1000
_MAXIMUM_DRAWN: Final = 20_000_000
"""Bearings in all drawn tests together, if it is left to the program."""
_LONGEST_DATE: Final = 20


@frozen
class _Study:
    """What is decided, and by which distribution.

    Attributes
    ----------
    distribution
        of the lives, which may be none: then nothing is decided
    title
        of the data; "" without
    notes
        what is to be known of it all
    """

    distribution: LifeDistribution
    title: str
    notes: tuple[Note, ...]

    def _plain(
        self, kind: str, found: RemainingLife | AgeReplacement | FleetForecast | None
    ) -> dict[str, Any]:
        lives = {"distribution": self.distribution.to_mapping()}
        return {
            "schema": SCHEMA,
            "kind": kind,
            "unit": self.distribution.unit,
            "title": self.title,
            **(lives if found is None else found.to_mapping()),
            "study_notes": [note.to_mapping() for note in self.notes],
        }


@frozen
class RemainingStudy(_Study):
    """What is left of a life; found is None where there is no distribution."""

    found: RemainingLife | None

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values, in the unit that it names."""
        return self._plain("remaining_life", self.found)


@frozen
class ReplacementStudy(_Study):
    """When to replace; found is None where there is no distribution.

    currency: label of the costs.
    """

    found: AgeReplacement | None
    currency: str

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values, in the units that it names."""
        plain = self._plain("age_replacement", self.found)
        return {**plain, "currency": self.currency}


@frozen
class FleetStudy(_Study):
    """Number of failures expected in a fleet; found is None where there is no distribution.

    Attributes
    ----------
    names
        of the rows of the fleet
    begin, end
        of the time that is looked at; None without dates
    of_data
        whether the fleet is that of the data
    """

    found: FleetForecast | None
    names: tuple[str, ...]
    begin: datetime | None
    end: datetime | None
    of_data: bool

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values, in the unit that it names."""
        return {
            **self._plain("fleet_forecast", self.found),
            "names": list(self.names),
            "from": None if self.begin is None else moment_said(self.begin),
            "until": None if self.end is None else moment_said(self.end),
        }


def remaining_study(
    data: LifeTest | ArrayLike | str | os.PathLike[str] | None = None,
    *,
    age: float | str,
    mission: float | str | None = None,
    confidence: float = 0.9,
    **lives: Any,
) -> RemainingStudy:
    """Find what is left of the life of a bearing that has run so long.

    Parameters
    ----------
    data
        Of the lives: a CSV file, "-" for standard input; a `LifeTest`; or times of bearings that
        all failed. None where the distribution is given.
    age, mission
        Run already, and to be run more: in the unit of the data, or as text with another.
    confidence
        Of the intervals.
    **lives
        shape, scale, l10, only, only_mode, columns, samples and seed, as of `lives_of`.

    Raises
    ------
    FileError, InputError
        If the data are no life test, or a parameter cannot be.
    """
    law, title, _, notes = lives_of(data, **lives)
    t = life_in(age, law.unit, "age")
    x = None if mission is None else life_in(mission, law.unit, "mission")
    if not law.converged:
        return RemainingStudy(law, title, notes, None)
    found = remaining_life(law, t, x, confidence=confidence)
    notes = (*notes, *_beyond(law, t + (x or 0.0)), *_early(law))
    return RemainingStudy(law, title, notes, found)


def replacement_study(
    data: LifeTest | ArrayLike | str | os.PathLike[str] | None = None,
    *,
    planned: float,
    failure: float,
    currency: str = "",
    confidence: float = 0.9,
    **lives: Any,
) -> ReplacementStudy:
    """Find the age of replacement at least cost.

    Parameters
    ----------
    data
        As of `remaining_study`.
    planned, failure
        Costs of a planned replacement, and of a failure with all that it brings.
    currency
        Label of the costs.
    confidence
        Of the intervals.
    **lives
        As of `lives_of`.

    Raises
    ------
    FileError, InputError
        If the data are no life test, or a parameter cannot be.
    """
    if len(currency) > _LONGEST_DATE or not (currency.isprintable()):
        rule = said("must be one line of at most {most} characters", most=_LONGEST_DATE)
        raise InputError(rule, field="currency", value=currency, example=arguments(currency="USD"))
    law, title, _, notes = lives_of(data, **lives)
    if not law.converged:
        return ReplacementStudy(law, title, notes, None, currency)
    found = age_replacement(law, planned, failure, confidence=confidence)
    if found.worthwhile:
        notes = (*notes, *_beyond(law, found.age.value))
    return ReplacementStudy(law, title, notes, found, currency)


def fleet_study(
    data: LifeTest | ArrayLike | str | os.PathLike[str] | None = None,
    *,
    fleet: FleetTable | str | os.PathLike[str] | None = None,
    within: float | str | None = None,
    until: str | date | None = None,
    begin: str | date | None = None,
    usage: float | str | None = None,
    renewed: bool = False,
    confidence: float = 0.9,
    fleet_columns: Mapping[str, Any] | None = None,
    **lives: Any,
) -> FleetStudy:
    """Count the failures of a fleet beforehand.

    Parameters
    ----------
    data
        As of `remaining_study`.
    fleet
        Bearings in service: a CSV file or a `FleetTable`. By default those of the data that have
        not failed.
    within
        Time that each will run more: in the unit of the data, or as text with another.
    until, begin
        Instead: dates, such as "2026-12-31"; begin is today by default.
    usage
        What each runs a day, in the unit of the data or as text with another; by default what the
        fleet's table says.
    renewed
        Whether those that fail are replaced by new ones, which may fail too.
    confidence
        Of the prediction.
    fleet_columns
        Of the fleet's file, as of `read_fleet`.
    **lives
        As of `lives_of`.

    Raises
    ------
    FileError, InputError
        If a table is none, or a parameter cannot be.
    """
    if (within is None) == (until is None):
        raise InputError(said("or until must be given, not both"), field="within",
                         example=arguments(within="2000 h"))  # fmt: skip
    law, title, test, notes = lives_of(data, **lives)
    table = _fleet_of(fleet, test, fleet_columns or {}, law.unit)
    first, of_begin = _moment(begin, "begin")
    last, of_until = _moment(until, "until")
    notes = (*notes, *dict.fromkeys((*of_begin, *of_until)))
    if within is not None:
        if first is not None or usage is not None:
            field = "begin" if first is not None else "usage"
            raise InputError(
                said("goes with until"), field=field, example=arguments(until="2026-12-31")
            )
        ahead = np.full(len(table.ages), life_in(within, law.unit, "within"))
    else:
        assert last is not None
        first = first or datetime.combine(datetime.now(last.tzinfo).date(), time(), last.tzinfo)
        ahead = _ahead(table, first, last, usage, law.unit)
    notes = (*notes, *table.notes)
    if fleet is not None and table.left_out:
        notes = (*notes, Note("fleet_failed_left_out", {"count": table.left_out}))
    if not law.converged:
        return FleetStudy(law, title, notes, None, table.names, first, last, fleet is None)
    found = fleet_forecast(
        law,
        Fleet.of(table.ages, ahead, table.counts),
        renewed=renewed,
        confidence=confidence,
        seed=law.seed,
    )
    notes = (*notes, *found.notes, *_beyond(law, float((table.ages + ahead).max())))
    return FleetStudy(law, title, notes, found, table.names, first, last, fleet is None)


def lives_of(
    data: LifeTest | ArrayLike | str | os.PathLike[str] | None,
    *,
    shape: float | None = None,
    scale: float | str | None = None,
    l10: float | str | None = None,
    only: Sequence[str] = (),
    only_mode: str | None = None,
    columns: Mapping[str, Any] | None = None,
    samples: int | None = None,
    seed: int = 0,
) -> tuple[LifeDistribution, str, LifeTest | None, tuple[Note, ...]]:
    """Return the distribution of lives, the title of its data, the data, and notes on them.

    Parameters
    ----------
    data
        As of `remaining_study`.
    shape
        β: with data, from experience, so that only the scale is fitted; without, needed.
    scale, l10
        η or the life that 90 % reach, without data: a number of hours, or a text with its unit.
    only
        Groups of the data to keep.
    only_mode
        Failure mode of the data to keep, failures by others as suspensions; `ALL_MODES` for all
        failures alike. Needed where the data have several.
    columns
        Of a file, as of `read_life_test`.
    samples, seed
        Draws, fewer of large tests by default, and what they are drawn with.

    Raises
    ------
    FileError, InputError
        If the data are no life test, or a parameter cannot be.
    """
    from rolamento.tasks.weibull import only_groups

    if data is None:
        if shape is None or (scale is None) == (l10 is None):
            raise InputError(
                said("must be given with scale or l10 where there are no data"),
                field="shape",
                example=arguments(shape=1.5, l10="20000 h"),
            )
        field = "l10" if scale is None else "scale"
        life, unit = _life_with_unit(l10 if scale is None else scale, field)
        law = LifeDistribution.given(shape, **{field: life}, unit=unit)
        return law, "", None, ()
    for field, value in (("scale", scale), ("l10", l10)):
        if value is not None:
            rule = said("is for a distribution that is given, without data")
            raise InputError(rule, field=field, value=value)
    if isinstance(data, str | os.PathLike):
        test = read_life_test(data, **(columns or {}))
    else:
        test = LifeTest.of(data)
    test = only_groups(test, only)
    test, notes = _of_mode(test, only_mode)
    notes = (*notes, *test.notes)
    groups = {str(name) for name in test.group}
    if len(groups) > 1:
        notes = (*notes, Note("decision_groups_pooled", {"count": len(groups)}))
    if samples is None:
        samples = max(min(_SAMPLES, _MAXIMUM_DRAWN // test.size), _FEWEST_SAMPLES)
    law = LifeDistribution.of_test(test, shape=shape, samples=samples, seed=seed)
    fit = goodness_of_fit(test, shape=shape, samples=min(samples, 1000), seed=seed)
    return law, test.title, test, (*fit.contradictions(test.unit), *notes)


def _of_mode(test: LifeTest, only_mode: str | None) -> tuple[LifeTest, tuple[Note, ...]]:
    """Return the test of the mode that is decided by, and what to know of it."""
    from rolamento.tasks.weibull import notes_of_mode, of_mode

    modes = test.modes
    if only_mode == ALL_MODES and only_mode not in modes:
        return test, (Note("modes_pooled", {"count": len(modes)}),) if len(modes) > 1 else ()
    if only_mode is None and len(modes) > 1:
        there = ", ".join(mode or said(UNKNOWN_MODE) for mode in modes)
        rule = said(
            "must be chosen where bearings failed by several modes ({there}); {all} takes all"
            " failures alike",
            there=there,
            all=ALL_MODES,
        )
        raise InputError(rule, field="only_mode", example=arguments(only_mode=modes[0]))
    if only_mode is None:
        return test, ()
    notes = notes_of_mode(test, only_mode)
    single = any(note.key == "one_mode" for note in notes)
    return of_mode(test, only_mode), (*notes, *((Note("decision_one_mode"),) if single else ()))


def _life_with_unit(life: float | str | None, field: str) -> tuple[float, str]:
    assert life is not None
    return life_with_unit(life, field) if isinstance(life, str) else (life, "h")


def _fleet_of(
    fleet: FleetTable | str | os.PathLike[str] | None,
    test: LifeTest | None,
    columns: Mapping[str, Any],
    unit: str,
) -> FleetTable:
    if isinstance(fleet, FleetTable):
        return fleet
    if fleet is not None:
        found = read_fleet(fleet, **columns)
        if found.unit.casefold() != unit.casefold():
            raise InputError(
                said("must be in the unit of the data, {unit}", unit=unit),
                field="fleet",
                value=found.unit,
                source=os.fspath(fleet),
            )
        return found
    if test is None:
        rule = said("must be given where there are no data")
        raise InputError(rule, field="fleet", example=arguments(fleet="fleet.csv"))
    if not np.any(~test.failed):
        raise InputError(
            said("must be given: all bearings of the data have failed"),
            field="fleet",
            example=arguments(fleet="fleet.csv"),
        )
    return FleetTable.of_test(test)


def _moment(given: str | date | None, field: str) -> tuple[datetime | None, tuple[Note, ...]]:
    """A moment, and how a date was read that may be read in two ways."""
    if given is None or isinstance(given, datetime):
        return given, ()
    if isinstance(given, date):
        return datetime.combine(given, time()), ()
    dates = dates_of([given.strip()])
    found = dates.moment(given.strip())
    if found is None or dates.doubt:
        rule = said("must be a date whose day and month cannot be taken for each other")
        raise InputError(rule, field=field, value=given, example="2026-12-31")
    return found, dates.notes


def _ahead(
    table: FleetTable, first: datetime, last: datetime, usage: float | str | None, unit: str
) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Time that each bearing will run between two moments."""
    days = days_between([first, last], "until")[1]
    if not last > first:
        raise InputError(
            said("must be after {first}", first=moment_said(first)),
            field="until",
            value=moment_said(last),
        )
    daily = table.usage
    if usage is not None:
        each = life_in(usage, unit, "usage")
        daily = np.where(np.isnan(daily), each, daily)
    elif np.any(np.isnan(daily)):
        if unit.casefold() not in ("d", "day", "days", "dia", "dias"):
            raise InputError(
                said("must be given for dates: what a bearing runs a day"),
                field="usage",
                example=arguments(usage=f"16 {unit}"),
            )
        daily = np.ones(len(table.ages))
    if unit.casefold() == "h" and np.any(daily > 24.0):
        rule = said("must be at most 24 h a day")
        raise InputError(rule, field="usage", value=float(np.nanmax(daily)))
    return np.asarray(days * daily)


def _beyond(law: LifeDistribution, longest: float) -> tuple[Note, ...]:
    """Say that what is asked lies beyond the data."""
    if not longest > law.longest:
        return ()
    return (Note("decision_beyond_data", {"longest": law.longest, "unit": law.unit}),)


def _early(law: LifeDistribution) -> tuple[Note, ...]:
    return (Note("decision_early_failures"),) if law.shape < 1.0 else ()
