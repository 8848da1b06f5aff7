"""Tables that people write: comma-separated values with a header, one reader for all of them.

Commas, semicolons or tabs part the cells. Lines that begin with # are comments; ``# name: value``
above the header is read. A table may be of a spreadsheet that writes decimal commas: then points
part thousands, and ``12.500`` is 12500. Where nothing in the table tells, the user is asked; a line
``# decimal mark: point`` or ``# decimal mark: comma`` above the header answers, or an argument.
"""

from __future__ import annotations

import csv
import os
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any, Final, Literal, get_args

from rolamento.errors import ABSENT, FileError, InputError
from rolamento.io.text import STANDARD_INPUT, read_bytes
from rolamento.words import marked, said

__all__ = [
    "DecimalMark",
    "Numerals",
    "Table",
    "checked_mark",
    "mark_said",
    "numerals_of",
    "parse_table",
    "read_table",
    "table_text",
]

DecimalMark = Literal["point", "comma"]

_LONGEST_LINE: Final = 5000
_LONGEST_CELL: Final = 200
_MOST_COLUMNS: Final = 1000
_LONGEST_NUMBER: Final = 40
_LARGEST: Final = 5_000_000
_MARK: Final = "decimal mark"
_IN_PORTUGUESE: Final = {
    "título": "title", "titulo": "title", "fonte": "source", "unidade": "unit", "datas": "dates",
    "separador decimal": _MARK, "marca decimal": _MARK,
}  # fmt: skip
"""Names of comments, and those that are read."""
_GROUPED: Final = re.compile(r"[+-]?\d{1,3}(?:[ \u00a0\u2009\u202f]\d{3})+(?!\d)")
"""A number whose thousands are parted by spaces, as these pages write it."""

_EXPONENT: Final = r"(?:[eE][+-]?\d{1,3})?"
_PLAIN: Final = re.compile(rf"[+-]?(?:\d+(?:\.\d*)?|\.\d+){_EXPONENT}")
_IN_THOUSANDS: Final = re.compile(rf"[+-]?[1-9]\d{{0,2}}(?:\.\d{{3}})+(?:,\d*)?{_EXPONENT}")
"""A number whose points may part thousands; one with a leading zero never does."""
_DECIMAL_COMMA: Final = re.compile(
    r"[+-]?(?:\d{1,3}(?:\.\d{3})+,\d*|\d*,(?:\d{1,2}|\d{4,}))(?:[eE][+-]?\d{1,3})?"
)
_MARKED: Final = re.compile(r"[+-]?[\d.,]*[.,][\d.,]*(?:[eE][+-]?\d{1,3})?")
_LEAD: Final = re.compile(r"[+-]?(?=[.,]?\d)[\d.,]+(?:[eE][+-]?\d{1,3})?(?=\s|%|[A-Za-zµμ°]|$)")
_POINTS_AND_COMMAS: Final = str.maketrans(".,", ",.")


@dataclass(frozen=True, slots=True)
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
        if len(text) > _LONGEST_NUMBER:
            return None
        if not self.commas and _PLAIN.fullmatch(text):
            return text
        if grouped := _GROUPED.match(text):
            text = "".join(grouped[0].split()) + text[grouped.end() :]
        if self.commas and self.mark == "comma":
            text = text.translate(_POINTS_AND_COMMAS)
        if self.commas and "," in text:
            # 1,234.5 in thousands; else the comma is the decimal one, as there is no other mark
            turned = text.translate(_POINTS_AND_COMMAS)
            if self.mark is not None or "." in text:
                text = text.replace(",", "") if _IN_THOUSANDS.fullmatch(turned) else ""
            else:
                text = turned
        return text if _PLAIN.fullmatch(text) else None

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
            example = said(
                'decimal_mark="point" for {point:.9g}, decimal_mark="comma" for {comma:.9g}; or a'
                ' line "# decimal mark: comma" above the table',
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
    """Tell how the numbers of a table are written, by all of them together.

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
        if len(cell) > _LONGEST_NUMBER or not _MARKED.fullmatch(cell):
            continue
        if "." not in cell:
            if _IN_THOUSANDS.fullmatch(cell.replace(",", ".")):
                in_commas = in_commas or cell
            else:
                ask_of_commas = False  # 0,25, 12,5: a decimal comma
        elif not _IN_THOUSANDS.fullmatch(cell):
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


@dataclass(frozen=True, slots=True)
class Table:
    """Cells as text.

    Attributes
    ----------
    source
        what to call the file in messages
    said
        what comments above the header say, by name in lower case
    header
        names of the columns
    header_line, lines
        of the header and of the rows in the file, counted from 1
    rows
        cells, as many in each row as there are columns
    separator
        between the cells
    """

    source: str
    said: dict[str, str]
    header: tuple[str, ...]
    header_line: int
    rows: tuple[tuple[str, ...], ...]
    lines: tuple[int, ...]
    separator: str

    def placed(self, error: InputError, row: int | None = None) -> InputError:
        """Return an error with the place of its row, or of the header."""
        line = self.header_line if row is None else self.lines[row]
        return error.with_details(source=self.source, line=line)

    def numerals(
        self, columns: Sequence[int], mark: object = None, *, argument: bool = True
    ) -> Numerals:
        """Tell how the numbers of some columns are written.

        Parameters
        ----------
        columns
            Their places.
        mark
            ``"point"`` or ``"comma"``, over what the file says.
        argument
            Whether the mark can be given as an argument.

        Raises
        ------
        InputError
            If nothing tells, and it matters; or the mark is none.
        """
        given = self.said.get(_MARK) if mark is None else mark
        chosen = None if given is None else checked_mark(given, self.source)
        leads = (_lead(row[column]) for row in self.rows for column in columns)
        apart = self.separator != ","
        asked = apart or chosen is not None or self._has_decimal_commas()
        found = numerals_of(leads, commas=asked, mark=chosen, ask_of_commas=self.separator == "\t")
        if apart and "." in found.doubt and self._has_decimal_commas(alone=True):
            found = Numerals(True, "comma")  # 12.450 beside 1.250,00: one hand wrote both
        if not apart and chosen is None and not found.doubt:
            found = Numerals(commas=False)
        if found.doubt:
            place, column = next(
                (number, column)
                for number, row in enumerate(self.rows)
                for column in columns
                if _lead(row[column]) == found.doubt
            )
            try:
                found.check(self.header[column], argument=argument)
            except InputError as error:
                raise self.placed(error, place) from None
        return found

    def _has_decimal_commas(self, *, alone: bool = False) -> bool:
        """Whether a number of any column has one: between quotation marks if commas part cells.

        alone: and none has a decimal point.
        """
        cells = [cell for row in self.rows for cell in row]
        if alone and any(
            _PLAIN.fullmatch(lead) and not _IN_THOUSANDS.fullmatch(lead)
            for lead in (_lead(cell) for cell in cells if "." in cell)
            if "." in lead
        ):
            return False
        return any(_DECIMAL_COMMA.fullmatch(_lead(cell)) for cell in cells if "," in cell)

    def plain(self, mark: object = None) -> Table:
        """Return the table with decimal points, and no marks in thousands, in all its numbers.

        Raises
        ------
        InputError
            As `numerals`, of all columns.
        """
        numerals = self.numerals(range(len(self.header)), mark)
        if not numerals.commas:
            return self
        rows = tuple(tuple(_rewritten(cell, numerals) for cell in row) for row in self.rows)
        header = tuple(_rewritten(cell, numerals) for cell in self.header)
        return replace(self, header=header, rows=rows)


def _lead(cell: str) -> str:
    """The number with which a cell begins, a unit or a per cent behind it or not."""
    found = _LEAD.match(cell)
    return "" if found is None else found[0]


def _rewritten(cell: str, numerals: Numerals) -> str:
    lead = _lead(cell)
    text = numerals.plain(lead) if lead else None
    return cell if text is None else text + cell[len(lead) :]


def mark_said(line: str) -> str | None:
    """Return what a comment above a table says of its decimal mark; None if it says nothing."""
    name, colon, value = line.lstrip("#% \t").partition(":")
    folded = name.strip().casefold()
    return value.strip() if colon and _IN_PORTUGUESE.get(folded, folded) == _MARK else None


def checked_mark(mark: object, source: str = "") -> DecimalMark:
    """Return a decimal mark by its name, or as the sign itself.

    Raises
    ------
    InputError
        If it is none.
    """
    known: dict[Any, DecimalMark] = {"point": "point", "comma": "comma", ".": "point", ",": "comma"}
    known |= {"ponto": "point", "vírgula": "comma", "virgula": "comma"}
    word = mark.strip().casefold() if isinstance(mark, str) else None
    if word not in known:
        raise InputError(
            said("must be one of {known}", known=", ".join(get_args(DecimalMark))),
            field="decimal_mark",
            value=ABSENT if mark is None else mark,
            example='decimal_mark="comma"',
            source=source,
        )
    return known[word]


def read_table(path: str | os.PathLike[str], *, most_rows: int, example: str) -> Table:
    """Read a table from a file, or from standard input for ``"-"``; see `parse_table`."""
    return parse_table(*table_text(path), most_rows=most_rows, example=example)


def table_text(path: str | os.PathLike[str]) -> tuple[str, str]:
    """Return the text of a table and what to call it; ``"-"`` is standard input.

    UTF-8, or else what Windows writes in Western languages; 5 MB at most.

    Raises
    ------
    FileError
        If it cannot be read, or is no text.
    """
    source = os.fspath(path)
    source = STANDARD_INPUT if source == "-" else source
    content = read_bytes(path, _LARGEST, marked("a CSV table"))
    if len(content) > _LARGEST:
        raise FileError(said("is larger than {most} MB", most=_LARGEST // 1_000_000), source=source)
    if content[:2] in (b"\xff\xfe", b"\xfe\xff"):
        raise FileError(said("is UTF-16 text; save it as CSV in UTF-8"), source=source)
    if b"\0" in content:
        raise FileError(said("is a binary file; save the table as CSV"), source=source)
    try:
        return content.decode("utf-8-sig"), source
    except UnicodeDecodeError:
        return content.decode("cp1252", errors="replace"), source


def parse_table(
    text: str, source: str, *, most_rows: int, example: str, least_rows: int = 1
) -> Table:
    """Take a table apart.

    Parameters
    ----------
    text
        As the module tells. Lines without anything count nothing.
    source
        What to call it in messages.
    most_rows, least_rows
        Below the header.
    example
        Of a header, for messages.

    Raises
    ------
    FileError
        If it is no such table, or is too large.
    """
    told: dict[str, str] = {}
    found: list[tuple[int, tuple[str, ...]]] = []
    separator = ","
    for number, line in enumerate(text.replace("\r\n", "\n").replace("\r", "\n").split("\n"), 1):
        if len(line) > _LONGEST_LINE:
            rule = said("is longer than {most} characters", most=_LONGEST_LINE)
            raise FileError(rule, source=source, line=number)
        if line.lstrip().startswith("#"):
            name, colon, value = line.lstrip("# \t").partition(":")
            if colon and not found:
                folded = name.strip().casefold()
                told.setdefault(_IN_PORTUGUESE.get(folded, folded), value.strip()[:_LONGEST_CELL])
            continue
        if not line.strip(" \t;,"):
            continue
        if not found:
            separator = next((mark for mark in ";\t" if mark in line), ",")
        if len(found) > most_rows:
            raise FileError(said("has more than {most} rows", most=most_rows), source=source)
        found.append((number, _cells(line, separator, source, number)))
        _check_row(found, separator, source)
    if not found:
        raise FileError(said("contains no table"), source=source, example=example)
    (header_line, header), *rows = found
    if len(rows) < least_rows:
        raise FileError(said("has a header but no rows"), source=source, example=example)
    return Table(
        source,
        told,
        header,
        header_line,
        tuple(cells for _, cells in rows),
        tuple(line for line, _ in rows),
        separator,
    )


def _cells(line: str, separator: str, source: str, number: int) -> tuple[str, ...]:
    try:
        cells = next(csv.reader([line], delimiter=separator, strict=True))
    except (csv.Error, StopIteration):
        rule = said("is not a line of a CSV table; check for an unmatched quotation mark")
        raise FileError(rule, source=source, line=number) from None
    return tuple(cell.strip() for cell in cells)


def _check_row(found: list[tuple[int, tuple[str, ...]]], separator: str, source: str) -> None:
    """Refuse a row that is too large, or not as long as the header but for blank cells."""
    line, cells = found[-1]
    header = found[0][1]
    while len(cells) > len(header) and not cells[-1]:  # separators behind the last cell
        cells = cells[:-1]
        found[-1] = line, cells
    if len(cells) > _MOST_COLUMNS:
        raise FileError(
            said("has more than {most} columns", most=_MOST_COLUMNS), source=source, line=line
        )
    if max(map(len, cells)) > _LONGEST_CELL:
        rule = said("has a cell of more than {most} characters", most=_LONGEST_CELL)
        raise FileError(rule, source=source, line=line)
    if len(cells) != len(header):
        numbers = {"count": len(cells), "columns": len(header)}
        rule = said("has {count} cells where the header has {columns}", **numbers)
        if separator == ",":
            rule = said(
                "has {count} cells where the header has {columns}; with decimal commas, separate"
                " the cells by semicolons",
                **numbers,
            )
        raise FileError(rule, source=source, line=line)
