"""Moments in tables: days, times of day and zones, as people and recorders write them.

2024-03-04 08:30, 04.03.2024 08:30:15, 4 Mar 2024, Mar 4, 2024 8:30 PM, 2024-03-04T08:30:00+02:00.
Whether 03/04/2024 is of March or of April, the column, the table or the language says; where none
does, the user is asked.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from datetime import UTC, datetime, timedelta, timezone
from typing import Final, Literal, get_args

from rolamento.errors import InputError, arguments, phrase
from rolamento.io.columns import folded_name
from rolamento.io.numerals import named_choice
from rolamento.records import frozen
from rolamento.words import Note, manner, marked, said

__all__ = [
    "DateOrder",
    "Dates",
    "checked_order",
    "dates_of",
    "days_between",
    "is_time_of_day",
    "moment_after",
    "moment_said",
]

DateOrder = Literal["day_first", "month_first"]

_CLOCK: Final = re.compile(
    r"(?P<hour>\d{1,2})(?:[:h](?P<minute>\d{2})(?:[:m](?P<second>\d{2}(?:[.,]\d{1,9})?)s?)?|h)"
    r"(?:\s*(?P<half>[AaPp])\.?[Mm]\.?)?"
    r"\s*(?P<zone>Z|UTC|GMT|[+-]\d{2}:?\d{2}|[+-]\d{2})?"
)
_BETWEEN: Final = r"(?:T|[,;]?\s+(?:às\s+|at\s+|um\s+|a las\s+)?|\s*-\s+)"
_ISO: Final = re.compile(r"(?P<year>\d{4})[-/.](?P<month>\d{1,2})[-/.](?P<day>\d{1,2})")
_COMPACT: Final = re.compile(r"(?P<year>\d{4})(?P<month>\d{2})(?P<day>\d{2})(?=T\d)")
_DAY_AND_MONTH: Final = re.compile(r"(\d{1,2})([-/.])(\d{1,2})\2(\d{4}|\d{2})(?!\d)")
_DAY_AND_NAME: Final = re.compile(
    r"(?P<day>\d{1,2})\.?[-/. ]\s?(?:de )?(?P<name>[^\W\d]{3,10})\.?[-/. ]\s?(?:de )?"
    r"(?P<year>\d{4}|\d{2})(?!\d)",
    re.I,
)
_NAME_AND_DAY: Final = re.compile(
    r"(?P<name>[^\W\d]{3,10})\.?[-/. ](?P<day>\d{1,2}),?[-/. ]\s?(?P<year>\d{4})(?!\d)", re.I
)
_COMPACT_CLOCK: Final = re.compile(
    r"T(?P<hour>\d{2})(?P<minute>\d{2})(?P<second>\d{2}(?:[.,]\d{1,9})?)?"
    r"(?P<half>(?!))?(?P<zone>Z|[+-]\d{2}:?\d{2})?"
)
_MONTHS: Final = {
    name: number
    for number, names in enumerate(
        ("jan ene", "feb fev", "mar mrz", "apr abr", "may mai", "jun", "jul", "aug ago", "sep set",
         "oct out okt", "nov", "dec dez dic"), 1)
    for name in names.split()
}  # fmt: skip
_DAY_FIRST_WORDS: Final = frozenset(
    (
        *("data_da_medicao", "data_medicao", "data_da_leitura", "data_leitura", "data_hora"),
        *("medido_em", "data_e_hora", "datum", "messdatum", "zeitstempel", "datum_uhrzeit"),
        *("fecha", "fecha_de_medicion", "fecha_hora", "fecha_y_hora"),
    )
)
"""Headings in languages that put the day first; "data" is English as well."""
_LONGEST: Final = 60
_EXAMPLE: Final = "2024-02-29 08:30"


@frozen
class Dates:
    """How the dates of a table are written.

    Attributes
    ----------
    order
        of day and month in 03/04/2024; None if nothing decides it, and nothing needs it
    doubt
        a date that may be read in two ways; empty if there is none
    taken
        that date, where not the column but the language or the table decided; empty otherwise
    """

    order: DateOrder | None = None
    doubt: str = ""
    taken: str = ""

    def moment(self, cell: str) -> datetime | None:
        """Return the moment of a cell; None if it is no date. With a zone it is aware of it."""
        return _moment(cell, self.order)

    @property
    def notes(self) -> tuple[Note, ...]:
        """That the day was taken to come first, where only the language or the table said so."""
        if not self.taken:
            return ()
        found = _moment(self.taken, self.order)
        day = "" if found is None else found.date().isoformat()
        return (Note("dates_day_first", {"date": self.taken, "day": day}),)

    def check(self, field: str, example: str = "") -> None:
        """Refuse dates that may be read in two ways.

        example: of what decides it, where neither an argument nor a line above a table does.

        Raises
        ------
        InputError
            With both readings, and how to say which it is.
        """
        if not self.doubt:
            return
        found = [_moment(self.doubt, order) for order in get_args(DateOrder)]
        first, second = ("" if one is None else one.date().isoformat() for one in found)
        raise InputError(
            said(
                "is {first} if the day comes first and {second} if the month does; nothing shows"
                " which",
                first=first,
                second=second,
            ),
            field=field,
            value=self.doubt,
            example=example
            or phrase(
                marked(
                    '{day_first} for {first}, {month_first} for {second}; or a line "# dates: day'
                    ' first" above the table'
                ),
                first=first,
                second=second,
                day_first=arguments(date_order="day_first"),
                month_first=arguments(date_order="month_first"),
            ),
        )


def dates_of(
    cells: Iterable[str], order: object = None, *, title: str = "", decimal_commas: bool = False
) -> Dates:
    """Find how the dates of a column are written, by all of them together.

    2024-03-04 and 4 Mar 2024 are clear, and 04.03.2024 has the day first. Of 04/03/2024 and
    04-03-2024 a number above 12 in one of the cells decides; else the day comes first where the
    heading, decimal commas in the table or the language that is spoken are of those who write so.

    Parameters
    ----------
    cells
        Those of the column.
    order
        What the user says, which holds: ``"day_first"`` or ``"month_first"``.
    title
        Heading of the column.
    decimal_commas
        Whether the numbers of the table have them.
    """
    if order is not None:
        return Dates(checked_order(order))
    doubt = ""
    for cell in cells:
        match = _DAY_AND_MONTH.match(cell)
        if match is None or match[2] == ".":
            continue
        first, second = int(match[1]), int(match[3])
        if first > 12 >= second:
            return Dates("day_first")
        if second > 12 >= first:
            return Dates("month_first")
        if first != second:
            doubt = doubt or cell
    words = {folded_name(title), folded_name(title.split("(")[0].split("[")[0])}
    if doubt and (decimal_commas or words & _DAY_FIRST_WORDS or manner().mark == ","):
        return Dates("day_first", "", doubt)
    return Dates(None, doubt)


def checked_order(order: object, source: str = "") -> DateOrder:
    """Return an order of day and month by its name.

    Raises
    ------
    InputError
        If it is none.
    """
    known: dict[str, DateOrder] = {
        "day_first": "day_first", "dmy": "day_first", "dd_mm_yyyy": "day_first",
        "dia_primeiro": "day_first", "dma": "day_first", "dd_mm_aaaa": "day_first",
        "month_first": "month_first", "mdy": "month_first", "mm_dd_yyyy": "month_first",
        "mes_primeiro": "month_first", "mda": "month_first", "mm_dd_aaaa": "month_first",
    }  # fmt: skip
    word = folded_name(order) if isinstance(order, str) else None
    return named_choice(order, word, known, field="date_order", example="day_first", source=source)


def is_time_of_day(cell: str) -> bool:
    """Return whether a cell is a time of day without a day: 08:30, 8h30, 8:30 PM."""
    return len(cell) <= _LONGEST and _clock(_CLOCK.fullmatch(cell.strip())) is not None


def days_between(moments: Sequence[datetime], field: str = "time") -> list[float]:
    """Return the days from the first of some moments to each of them.

    Raises
    ------
    InputError
        If only some of them have a zone.
    """
    if len({moment.tzinfo is None for moment in moments}) > 1:
        raise InputError(
            said("has a time zone in some rows and none in others"), field=field, example=_EXAMPLE
        )
    first = min(moments)
    return [(moment - first) / timedelta(days=1) for moment in moments]


def moment_said(moment: datetime) -> str:
    """Return a moment as ISO 8601 has it; without a time of day where it is midnight."""
    text = moment.isoformat(" ", "seconds" if not moment.microsecond else "microseconds")
    return moment.date().isoformat() if text.endswith(" 00:00:00") else text


def moment_after(start: str, days: float, *, to_the_day: bool = False) -> str:
    """Return the moment so many days after another, both as `moment_said` writes them.

    to_the_day: rounded to days, where the start is a day.
    """
    first = datetime.fromisoformat(start)
    if to_the_day and len(start) <= len("2024-02-29"):
        days = round(days)
    second = round(86400.0 * days, 3)
    return moment_said(first + timedelta(seconds=round(second) if to_the_day else second))


def _moment(cell: str, order: DateOrder | None) -> datetime | None:
    text = " ".join(cell.split())
    if len(text) > _LONGEST:
        return None
    try:
        for pattern in (_ISO, _COMPACT, _DAY_AND_NAME, _NAME_AND_DAY):
            if match := pattern.match(text):
                part = match.groupdict()
                month = int(part["month"]) if "month" in part else _month(part["name"])
                return _at(_year(part["year"]), month, int(part["day"]), text[match.end() :])
        if match := _DAY_AND_MONTH.match(text):
            day, month = int(match[1]), int(match[3])
            if order == "month_first" and match[2] != ".":
                day, month = month, day
            return _at(_year(match[4]), month, day, text[match.end() :])
    except (KeyError, ValueError, OverflowError):
        return None
    return None


def _at(year: int, month: int, day: int, rest: str) -> datetime | None:
    """The moment of a day and what stands behind it; None if that is no time of day."""
    if not rest:
        return datetime(year, month, day)
    compact = _COMPACT_CLOCK.fullmatch(rest)
    between = None if compact else re.match(_BETWEEN, rest)
    if compact is None and between is None:
        return None
    clock = _clock(compact or _CLOCK.fullmatch(rest[between.end() :] if between else ""))
    if clock is None:
        return None
    span, zone = clock
    moment = datetime(year, month, day, tzinfo=zone) + span
    return moment if zone is None else moment.astimezone(UTC)


def _clock(match: re.Match[str] | None) -> tuple[timedelta, timezone | None] | None:
    """Time since midnight and zone of a time of day; None if it is none."""
    if match is None:
        return None
    hour, minute = int(match["hour"]), int(match["minute"] or 0)
    second = float((match["second"] or "0").replace(",", "."))
    if half := match["half"]:
        if not 1 <= hour <= 12:
            return None
        hour = hour % 12 + (12 if half in "Pp" else 0)
    if hour > 24 or minute > 59 or second >= 60.0 or (hour == 24 and (minute or second)):
        return None
    zone = match["zone"]
    found = None
    if zone in ("Z", "UTC", "GMT"):
        found = UTC
    elif zone:
        digits = zone[1:].replace(":", "").ljust(4, "0")
        offset = timedelta(hours=int(digits[:2]), minutes=int(digits[2:]))
        if offset > timedelta(hours=14):
            return None
        found = timezone(-offset if zone[0] == "-" else offset)
    return timedelta(hours=hour, minutes=minute, microseconds=round(second * 1e6)), found


def _month(name: str) -> int:
    return _MONTHS[folded_name(name)[:3]]


def _year(text: str) -> int:
    """Two figures are of this century."""
    return int(text) + (2000 if len(text) == 2 else 0)
