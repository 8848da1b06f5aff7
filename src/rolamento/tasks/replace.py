"""Keep or replace: what a Weibull distribution says of bearings in service, from end to end."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from datetime import date, datetime, time
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final, Self

import numpy as np
from numpy.typing import ArrayLike
from pydantic import model_validator

from rolamento.errors import InputError, arguments, phrase
from rolamento.io.dates import dates_of, days_between, moment_said
from rolamento.records import frozen
from rolamento.tasks.life_tables import DATA, SHIPPED, LifeTable
from rolamento.tasks.parameters import Progress, quietly
from rolamento.tasks.request import PICTURE, Input, Product
from rolamento.weibull import LifeTest, published_life_test, published_text, read_life_test
from rolamento.weibull.distribution import LifeDistribution
from rolamento.weibull.fleet import Fleet, FleetForecast, fleet_forecast
from rolamento.weibull.fleet_table import FleetTable, read_fleet
from rolamento.weibull.goodness import goodness_of_fit
from rolamento.weibull.life_test import UNKNOWN_MODE
from rolamento.weibull.life_units import life_in, life_with_unit
from rolamento.weibull.replacement import AgeReplacement, age_replacement
from rolamento.weibull.residual import RemainingLife, remaining_life
from rolamento.words import Note, marked, said

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from rolamento.document import Document

__all__ = [
    "FleetRequest",
    "FleetStudy",
    "RemainingLifeRequest",
    "RemainingStudy",
    "ReplacementRequest",
    "ReplacementStudy",
]

DECISION: Final = marked("Decision")
LIVES: Final = marked("Lives")

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

    @property
    def complaint(self) -> str:
        """Why nothing is decided; "" if something is."""
        return "" if getattr(self, "found", None) is not None else str(self.distribution.advice)

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

    def page(self) -> Document:
        """Return what people read of it."""
        from rolamento.pages.replace import remaining_page

        return remaining_page(self)

    def picture(self) -> Figure | None:
        """Draw it; None where nothing is decided."""
        from rolamento.plots.replace import remaining_life_figure

        return None if self.found is None else remaining_life_figure(self.found)

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

    def page(self) -> Document:
        """Return what people read of it."""
        from rolamento.pages.replace import replacement_page

        return replacement_page(self)

    def picture(self) -> Figure | None:
        """Draw it; None where nothing is decided."""
        from rolamento.plots.replace import cost_of_ages_figure

        return None if self.found is None else cost_of_ages_figure(self.found, self.currency)

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

    def page(self) -> Document:
        """Return what people read of it."""
        from rolamento.pages.replace import fleet_page

        return fleet_page(self)

    def picture(self) -> Figure | None:
        """Draw it; None where nothing is decided."""
        from rolamento.plots.replace import fleet_failures_figure

        return None if self.found is None else fleet_failures_figure(self.found)

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values, in the unit that it names."""
        return {
            **self._plain("fleet_forecast", self.found),
            "names": list(self.names),
            "from": None if self.begin is None else moment_said(self.begin),
            "until": None if self.end is None else moment_said(self.end),
        }


class LivesRequest(LifeTable):
    """A use case by a distribution of lives: of a table, or given.

    Parameters
    ----------
    data
        Lives: columns time and status, of failed bearings and of those in service; - for standard
        input. Without it, `shape` and `scale` or `l10`.
    example
        Shipped lives: campanha-2008 or lieblein-zelen-1956.
    only
        Only this group of the data.
    only_mode
        Only this failure mode of the data, failures by others as suspensions; all for all failures
        alike.
    shape
        Shape from experience, such as 1.5; with data, only the scale is fitted.
    scale
        Scale η without data, such as '30000 h'.
    l10
        L10 without data, such as '20000 h', instead.
    samples
        Tests to simulate, 100 to a million; 10 000 by default, fewer for large tests.
    seed
        Seed of the random numbers.
    confidence
        Confidence of the intervals.
    """

    data: Annotated[Any, Input("Lives", "file", metavar="DATA.csv")] = None
    example: Annotated[
        str | None,
        Input(
            "Example", "shipped", LIVES, choices=lambda: dict.fromkeys(SHIPPED, ""), metavar="NAME"
        ),
    ] = None
    only: Annotated[
        tuple[str, ...], Input("Only these groups", "list", LIVES, example="I", metavar="GROUP")
    ] = ()
    only_mode: Annotated[
        str | None,
        Input(
            "Only this failure mode",
            group=LIVES,
            example="fatigue",
            option="--mode",
            metavar="MODE",
        ),
    ] = None
    shape: Annotated[
        float | None, Input("Shape", "number", LIVES, example="1.5", metavar="BETA")
    ] = None
    scale: Annotated[
        float | str | None, Input("Scale", group=LIVES, example="30000 h", metavar="LIFE")
    ] = None
    l10: Annotated[
        float | str | None, Input("L10", group=LIVES, example="20000 h", metavar="LIFE")
    ] = None
    samples: Annotated[
        int | None, Input("Tests to simulate", "count", LIVES, example="10000", at_computer=True)
    ] = None
    seed: Annotated[
        int, Input("Seed", "count", LIVES, example="0", default="0", at_computer=True)
    ] = 0
    confidence: Annotated[
        float,
        Input("Confidence", "fraction", DECISION, example="0.9", default="0.9", metavar="C"),
    ] = 0.9

    json_meaning: ClassVar = "Write everything as JSON, in the unit of the data"
    waiting: ClassVar = marked("Simulating tests and fitting them …")
    headings: ClassVar = (DECISION, LIVES, DATA)
    ships: ClassVar = True
    needs_file: ClassVar = False

    @classmethod
    def shipped_text(cls, name: str) -> str:
        """Return a shipped life test as CSV."""
        return published_text(name.replace("-", "_"))

    def lives(self) -> tuple[LifeDistribution, str, LifeTest | None, tuple[Note, ...]]:
        """Return the distribution of lives, the title of its data, the data, and notes on them.

        Raises
        ------
        FileError, InputError
            As `lives_of`.
        """
        data = self.data
        if self.example is not None:
            data = published_life_test(self.example.replace("-", "_"), **self.reading)
        return lives_of(
            data, shape=self.shape, scale=self.scale, l10=self.l10, only=self.only,
            only_mode=self.only_mode, columns=self.reading, samples=self.samples, seed=self.seed,
        )  # fmt: skip

    products: ClassVar = {"plot": Product(PICTURE, lambda asked, found: found.picture())}


class RemainingLifeRequest(LivesRequest):
    """Show the chance that a bearing of an age runs on.

    Conditional reliability and residual life.

    Parameters
    ----------
    age
        Time run so far, such as '8000 h'.
    mission
        Time to run more, such as '2000 h'.
    """

    age: Annotated[float | str, Input("Age", group=DECISION, example="8000 h", metavar="TIME")]
    mission: Annotated[
        float | str | None, Input("Mission", group=DECISION, example="2000 h", metavar="TIME")
    ] = None

    examples: ClassVar = (
        "Examples: replace remaining field.csv --age '8000 h' --mission '2000 h'; replace remaining"
        " --shape 1.5 --l10 '20000 h' --age '8000 h' --mission '2000 h'."
    )

    def run(self, progress: Progress = quietly) -> RemainingStudy:
        """Find what is left of the life of a bearing that has run so long.

        Raises
        ------
        FileError, InputError
            If the data are no life test, or a parameter cannot be.
        """
        law, title, _, notes = self.lives()
        t = life_in(self.age, law.unit, "age")
        x = None if self.mission is None else life_in(self.mission, law.unit, "mission")
        if not law.converged:
            return RemainingStudy(law, title, notes, None)
        found = remaining_life(law, t, x, confidence=self.confidence)
        notes = (*notes, *_beyond(law, t + (x or 0.0)), *_early(law))
        return RemainingStudy(law, title, notes, found)


class ReplacementRequest(LivesRequest):
    """Plan the age of replacement at least cost per hour.

    Planned replacement against replacement on failure.

    Parameters
    ----------
    planned
        Cost of a planned replacement.
    failure
        Cost of a failure: replacement, damage and lost production.
    currency
        Label of the costs, such as USD.
    """

    planned: Annotated[
        float,
        Input(
            "Planned cost", "cost", DECISION, example="800", option="--planned-cost", metavar="COST"
        ),
    ]
    failure: Annotated[
        float,
        Input(
            "Cost of a failure",
            "cost",
            DECISION,
            example="12000",
            option="--failure-cost",
            metavar="COST",
        ),
    ]
    currency: Annotated[str, Input("Currency", group=DECISION, example="USD", metavar="NAME")] = ""

    examples: ClassVar = (
        "Examples: replace age field.csv --planned-cost 800 --failure-cost 12000; replace age"
        " --shape 2.5 --scale '1000 h' --planned-cost 1 --failure-cost 5."
    )

    @model_validator(mode="after")
    def _has_a_short_label(self) -> Self:
        label = self.currency
        if len(label) > _LONGEST_DATE or not label.isprintable():
            rule = said("must be one line of at most {most} characters", most=_LONGEST_DATE)
            raise InputError(rule, field="currency", value=label)
        return self

    def run(self, progress: Progress = quietly) -> ReplacementStudy:
        """Find the age of replacement at least cost.

        Raises
        ------
        FileError, InputError
            As of `RemainingLifeRequest`.
        """
        law, title, _, notes = self.lives()
        if not law.converged:
            return ReplacementStudy(law, title, notes, None, self.currency)
        found = age_replacement(law, self.planned, self.failure, confidence=self.confidence)
        if found.worthwhile:
            notes = (*notes, *_beyond(law, found.age.value))
        return ReplacementStudy(law, title, notes, found, self.currency)


class FleetRequest(LivesRequest):
    """Show how many of a fleet are expected to fail.

    By a date or within a time, with a prediction interval.

    Parameters
    ----------
    fleet
        Bearings in service: columns time and, if any, status, count, hours per day; by default
        those of the data that have not failed.
    within
        Time that each will run more, such as '2000 h'.
    until
        Date instead, such as 2026-12-31.
    begin
        Date of the ages; today by default.
    usage
        What a bearing runs a day, such as '16 h'.
    usage_column
        Column of the fleet's table of what each runs a day, if named otherwise.
    renewed
        Bearings that fail are replaced by new ones, which may fail too.
    """

    fleet: Annotated[
        Any, Input("Fleet", "path", DECISION, example="fleet.csv", metavar="FLEET.csv")
    ] = None
    within: Annotated[
        float | str | None, Input("Within", group=DECISION, example="2000 h", metavar="TIME")
    ] = None
    until: Annotated[
        Any, Input("Until", "date", DECISION, example="2026-12-31", metavar="DATE")
    ] = None
    begin: Annotated[
        Any,
        Input("From", "date", DECISION, example="2026-01-31", option="--from", metavar="DATE"),
    ] = None
    usage: Annotated[
        float | str | None, Input("Use per day", group=DECISION, example="16 h", metavar="TIME")
    ] = None
    usage_column: Annotated[
        str | None,
        Input("Column of the use per day", group=DECISION, example="usage", metavar="COLUMN"),
    ] = None
    renewed: Annotated[
        bool,
        Input(
            "Failed ones are replaced", "switch", DECISION, default="false",
            option="--renewed/--not-renewed",
        ),
    ] = False  # fmt: skip

    examples: ClassVar = (
        "Examples: replace fleet field.csv --within '2000 h'; replace fleet field.csv --fleet"
        " plant.csv --until 2026-12-31 --usage '16 h' --renewed."
    )

    @model_validator(mode="after")
    def _goes_together(self) -> Self:
        if (self.within is None) == (self.until is None):
            either = marked("or {until} must be given, not both")
            rule: str = phrase(either, until=arguments(until=...))
            raise InputError(rule, field="within")
        for name in ("begin", "usage") if self.within is not None else ():
            if getattr(self, name) is not None:
                rule = phrase(marked("goes with {until}"), until=arguments(until=...))
                raise InputError(rule, field=name, example=arguments(until="2026-12-31"))
        return self

    def run(self, progress: Progress = quietly) -> FleetStudy:
        """Count the failures of a fleet beforehand.

        Raises
        ------
        FileError, InputError
            If a table is none, or a parameter cannot be.
        """
        law, title, test, notes = self.lives()
        columns = {
            "usage": self.usage_column,
            "decimal_mark": self.decimal_mark,
            "ignored": self.ignored,
        }
        table = _fleet_of(self.fleet, test, columns, law.unit)
        first, of_begin = _moment(self.begin, "begin")
        last, of_until = _moment(self.until, "until")
        notes = (*notes, *dict.fromkeys((*of_begin, *of_until)))
        if self.within is not None:
            ahead = np.full(len(table.ages), life_in(self.within, law.unit, "within"))
        else:
            assert last is not None
            first = first or datetime.combine(datetime.now(last.tzinfo).date(), time(), last.tzinfo)
            ahead = _ahead(table, first, last, self.usage, law.unit)
        notes = (*notes, *table.notes)
        own = self.fleet is None
        if not own and table.left_out:
            notes = (*notes, Note("fleet_failed_left_out", {"count": table.left_out}))
        if not law.converged:
            return FleetStudy(law, title, notes, None, table.names, first, last, own)
        found = fleet_forecast(
            law,
            Fleet.of(table.ages, ahead, table.counts),
            renewed=self.renewed,
            confidence=self.confidence,
            seed=law.seed,
        )
        notes = (*notes, *found.notes, *_beyond(law, float((table.ages + ahead).max())))
        return FleetStudy(law, title, notes, found, table.names, first, last, own)


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
        A CSV file, "-" for standard input; a `LifeTest`; or times of bearings that all failed. None
        where the distribution is given.
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
