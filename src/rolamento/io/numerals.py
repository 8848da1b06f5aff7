"""How people write numbers: with a decimal point or a decimal comma, and marks between thousands.

Where nothing in a table shows what 12.500 is, the user is asked; a line ``# decimal mark: comma``
above the header answers, or an argument.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Final, Literal, TypeVar, get_args

from rolamento.errors import ABSENT, InputError, arguments, phrase
from rolamento.records import frozen
from rolamento.words import marked, said

__all__ = [
    "DECIMAL_COMMA",
    "GROUPED",
    "IN_THOUSANDS",
    "LONGEST_NUMBER",
    "PLAIN",
    "DecimalMark",
    "Numerals",
    "checked_mark",
    "lead_of",
    "numerals_of",
    "rewritten",
]

T = TypeVar("T", bound=str)
DecimalMark = Literal["point", "comma"]

LONGEST_NUMBER: Final = 40
GROUPED: Final = re.compile(r"[+-]?\d{1,3}(?:[ \u00a0\u2009\u202f]\d{3})+(?!\d)")
"""A number whose thousands are parted by spaces, as these pages write it."""

_EXPONENT: Final = r"(?:[eE][+-]?\d{1,3})?"
PLAIN: Final = re.compile(rf"[+-]?(?:\d+(?:\.\d*)?|\.\d+){_EXPONENT}")
IN_THOUSANDS: Final = re.compile(rf"[+-]?[1-9]\d{{0,2}}(?:\.\d{{3}})+(?:,\d*)?{_EXPONENT}")
"""A number whose points may part thousands; one with a leading zero never does."""
DECIMAL_COMMA: Final = re.compile(
    r"[+-]?(?:\d{1,3}(?:\.\d{3})+,\d*|\d*,(?:\d{1,2}|\d{4,}))(?:[eE][+-]?\d{1,3})?"
)
_MARKED: Final = re.compile(r"[+-]?[\d.,]*[.,][\d.,]*(?:[eE][+-]?\d{1,3})?")
_LEAD: Final = re.compile(r"[+-]?(?=[.,]?\d)[\d.,]+(?:[eE][+-]?\d{1,3})?(?=\s|%|[A-Za-zµμ°]|$)")
_POINTS_AND_COMMAS: Final = str.maketrans(".,", ",.")


@frozen
class Numerals:
    """How the numbers of a table are written.

    Attributes
    ----------
    commas
        whether a comma can be part of a number: none parts the cells
    mark
        the decimal mark, if it is known; then the other one parts thousands
    doubt
        a cell that is one number with a decimal point and another with a decimal comma; empty if
        there is none
    """

    commas: bool
    mark: DecimalMark | None = None
    doubt: str = ""

    def number(self, cell: str) -> float | None:
        """Return the number of a cell; None if it is none."""
        text = self.plain(cell)
        return None if text is None else float(text)

    def plain(self, cell: str) -> str | None:
        """Return the number of a cell as text with a decimal point; None if it is none."""
        text = cell
        if len(text) > LONGEST_NUMBER:
            return None
        if not self.commas and PLAIN.fullmatch(text):
            return text
        if grouped := GROUPED.match(text):
            text = "".join(grouped[0].split()) + text[grouped.end() :]
        if self.commas and self.mark == "comma":
            text = text.translate(_POINTS_AND_COMMAS)
        if self.commas and "," in text:
            # 1,234.5 in thousands; else the comma is the decimal one, as there is no other mark
            turned = text.translate(_POINTS_AND_COMMAS)
            if self.mark is not None or "." in text:
                text = text.replace(",", "") if IN_THOUSANDS.fullmatch(turned) else ""
            else:
                text = turned
        return text if PLAIN.fullmatch(text) else None

    def readings(self) -> tuple[float, float]:
        """Return what the cell in doubt is with a decimal point, and with a decimal comma."""
        point, comma = (Numerals(True, mark).number(self.doubt) for mark in get_args(DecimalMark))
        assert point is not None
        assert comma is not None
        return point, comma

    def check(self, field: str, *, argument: bool = True) -> None:
        """Refuse numbers that may be read in two ways.

        argument: whether the reader takes the mark as an argument, besides the line in the file.

        Raises
        ------
        InputError
            With both readings, and how to say which it is.
        """
        if not self.doubt:
            return
        point, comma = self.readings()
        readings = {"point": point, "comma": comma}
        rule = said(
            "is {point:.9g} if the point is the decimal mark and {comma:.9g} if it "
            "separates thousands; the table does not tell which",
            **readings,
        )
        if "," in self.doubt:
            rule = said(
                "is {point:.9g} if the comma separates thousands and {comma:.9g} if it is the"
                " decimal mark; the table does not tell which",
                **readings,
            )
        example = said(
            '"# decimal mark: point" above the table for {point:.9g}, "# decimal mark: comma" for'
            " {comma:.9g}",
            **readings,
        )
        if argument:
            example = phrase(
                marked(
                    "{with_point} for {point:.9g}, {with_comma} for {comma:.9g}; or a line"
                    ' "# decimal mark: comma" above the table'
                ),
                with_point=arguments(decimal_mark="point"),
                with_comma=arguments(decimal_mark="comma"),
                **readings,
            )
        raise InputError(rule, field=field, value=self.doubt, example=example)


def numerals_of(
    cells: Iterable[str],
    *,
    commas: bool,
    mark: DecimalMark | None = None,
    ask_of_commas: bool = False,
) -> Numerals:
    """Return how the numbers of a table are written, by all of them together.

    Parameters
    ----------
    cells
        Those that hold numbers; others count nothing.
    commas
        Whether a comma can be part of a number: none parts the cells.
    mark
        What the user says, which holds.
    ask_of_commas
        Whether 12,500 may be 12500 as well: nothing else shows that decimal commas are written.
    """
    if not commas or mark is not None:
        return Numerals(commas, mark)
    doubt = in_commas = ""
    point = False
    for cell in cells:
        if len(cell) > LONGEST_NUMBER or not _MARKED.fullmatch(cell):
            continue
        if "." not in cell:
            if IN_THOUSANDS.fullmatch(cell.replace(",", ".")):
                in_commas = in_commas or cell
            else:
                ask_of_commas = False  # 0,25, 12,5: a decimal comma
        elif not IN_THOUSANDS.fullmatch(cell):
            point = True  # 0.25, 12.5, 1,234.5: a decimal point
            if in_commas:
                break
        elif not point and ("," in cell or cell.count(".") > 1):
            return Numerals(commas, "comma")
        elif "e" not in cell.lower():
            doubt = doubt or cell
    if point:  # 12,500 beside 8.2 is 12500
        return Numerals(commas, "point" if in_commas else None)
    return Numerals(commas, None, doubt or (in_commas if ask_of_commas else ""))


def lead_of(cell: str) -> str:
    """Return the number with which a cell begins, a unit or a per cent behind it or not."""
    found = _LEAD.match(cell)
    return "" if found is None else found[0]


def rewritten(cell: str, numerals: Numerals) -> str:
    """Return a cell whose number has a decimal point, and what stands behind it as it is."""
    lead = lead_of(cell)
    text = numerals.plain(lead) if lead else None
    return cell if text is None else text + cell[len(lead) :]


def named_choice(
    value: object,
    word: str | None,
    known: Mapping[str, T],
    *,
    field: str,
    example: T,
    source: str = "",
) -> T:
    """Return what a word stands for.

    Parameters
    ----------
    value
        As it was given.
    word
        As it is looked up; None of what is no text.
    known
        Meaning of every word.
    field, example, source
        Of the error.

    Raises
    ------
    InputError
        If it stands for nothing.
    """
    if word is None or word not in known:
        raise InputError(
            said("must be one of {known}", known=", ".join(dict.fromkeys(known.values()))),
            field=field,
            value=ABSENT if value is None else value,
            example=f'{field}="{example}"',
            source=source,
        )
    return known[word]


def checked_mark(mark: object, source: str = "") -> DecimalMark:
    """Return a decimal mark by its name, or as the sign itself.

    Raises
    ------
    InputError
        If it is none.
    """
    known: dict[str, DecimalMark] = {"point": "point", "comma": "comma", ".": "point", ",": "comma"}
    known |= {"ponto": "point", "vírgula": "comma", "virgula": "comma"}
    word = mark.strip().casefold() if isinstance(mark, str) else None
    return named_choice(mark, word, known, field="decimal_mark", example="comma", source=source)
