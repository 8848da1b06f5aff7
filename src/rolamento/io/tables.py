"""Tables that people, spreadsheets and recorders write: one reader for all of them.

Semicolons, tabs, vertical bars, commas or blanks part the cells, and a first line ``sep=;`` says
which. The text is UTF-8, UTF-16 or what Windows writes in Western languages. Lines that begin with
# are comments; ``# name: value`` above the header is read, and so it is without the #. Title lines
above the header count nothing. A line of units below the header belongs to the names above it. A
workbook (.xlsx) is a table where it has one sheet that holds something; ``lives.xlsx#Rig 3`` names
one of several.

A table may be of a spreadsheet that writes decimal commas: then points part thousands, and
``12.500`` is 12500. Where nothing in the table shows it, the user is asked; a line
``# decimal mark: point`` or ``# decimal mark: comma`` above the header answers, or an argument.
"""

from __future__ import annotations

import codecs
import csv
import os
import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace
from typing import Any, Final

from rolamento.errors import FileError, InputError, guess
from rolamento.io.columns import folded_name, is_unit_word, title_parts
from rolamento.io.numerals import (
    DECIMAL_COMMA,
    GROUPED,
    IN_THOUSANDS,
    PLAIN,
    Numerals,
    checked_mark,
    lead_of,
    numerals_of,
    rewritten,
)
from rolamento.io.sheets import is_workbook, text_of_workbook
from rolamento.io.text import STANDARD_INPUT, read_bytes
from rolamento.records import frozen
from rolamento.words import counted, marked, said

__all__ = [
    "BLANKS",
    "SEPARATORS",
    "Table",
    "decoded",
    "encoding_of",
    "mark_said",
    "parse_table",
    "read_columns",
    "read_table",
    "separator_said",
    "split_line",
    "table_text",
    "with_units",
]

SEPARATORS: Final = (";", "\t", "|", ",")
"""Between cells, the surest sign of a table first."""
BLANKS: Final = " "
"""Where one blank or several part the cells."""

_LONGEST_LINE: Final = 5000
_LONGEST_CELL: Final = 200
_MOST_COLUMNS: Final = 1000
_LARGEST: Final = 5_000_000
_MOST_ABOVE: Final = 200
"""Lines above the header."""
_SAMPLED: Final = 300
"""Lines by which the separator is judged."""
_MOST_LINES_OF_CELL: Final = 4
_MARK: Final = "decimal mark"
_SAID: Final = {
    "title": "title", "título": "title", "titulo": "title", "titel": "title",
    "source": "source", "fonte": "source", "fuente": "source", "quelle": "source",
    "unit": "unit", "unidade": "unit", "unidad": "unit", "einheit": "unit",
    "units": "unit", "unidades": "unit", "einheiten": "unit",
    "dates": "dates", "datas": "dates", "fechas": "dates",
    "decimal mark": _MARK, "separador decimal": _MARK, "marca decimal": _MARK,
    "dezimaltrennzeichen": _MARK,
}  # fmt: skip
"""Names of comments in the languages in which they are read."""
_OPEN_QUOTE: Final = re.compile(r'(?:^|[;,\t|])"(?:[^"]|"")*$')
_SEPARATOR_SAID: Final = re.compile(r'"?sep=(.|\\t)"?', re.I)
_BEGINS_AS_NUMBER: Final = re.compile(r"[+-]?[.,]?\d")


@frozen
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
        between the cells; a blank where blanks part them
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
        """Return how the numbers of some columns are written.

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
            If nothing shows it, and it matters; or the mark is none.
        """
        given = self.said.get(_MARK) if mark is None else mark
        chosen = None if given is None else checked_mark(given, self.source)
        leads = (lead_of(row[column]) for row in self.rows for column in columns)
        apart = self.separator != ","
        asked = apart or chosen is not None or self._has_decimal_commas()
        ask = self.separator in ("\t", "|", BLANKS) or len(self.header) == 1
        found = numerals_of(leads, commas=asked, mark=chosen, ask_of_commas=ask)
        if apart and "." in found.doubt and self._has_decimal_commas(alone=True):
            found = Numerals(True, "comma")  # 12.450 beside 1.250,00: one hand wrote both
        if not apart and chosen is None and not found.doubt:
            found = Numerals(commas=False)
        if found.doubt:
            place, column = next(
                (number, column)
                for number, row in enumerate(self.rows)
                for column in columns
                if lead_of(row[column]) == found.doubt
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
            PLAIN.fullmatch(lead) and not IN_THOUSANDS.fullmatch(lead)
            for lead in (lead_of(cell) for cell in cells if "." in cell)
            if "." in lead
        ):
            return False
        return any(DECIMAL_COMMA.fullmatch(lead_of(cell)) for cell in cells if "," in cell)

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
        rows = tuple(tuple(rewritten(cell, numerals) for cell in row) for row in self.rows)
        header = tuple(rewritten(cell, numerals) for cell in self.header)
        return replace(self, header=header, rows=rows)


def mark_said(line: str) -> str | None:
    """Return what a comment above a table says of its decimal mark; None if it says nothing."""
    found = _saying(line.lstrip("#% \t"))
    return found[1] if found is not None and found[0] == _MARK else None


def _saying(line: str, separator: str = "") -> tuple[str, str] | None:
    """What a line above the header says by a name that is read, and the name in English."""
    for mark in (":", "=", separator):
        name, found, value = line.partition(mark) if mark else ("", "", "")
        folded = _SAID.get(name.strip().casefold())
        if found and folded is not None:
            return folded, value.strip().strip('"').rstrip(";,|\t ")[:_LONGEST_CELL]
    return None


# --- from bytes to text -------------------------------------------------------------------------


def read_table(
    path: str | os.PathLike[str],
    *,
    most_rows: int,
    example: str,
    is_header: Callable[[Sequence[str]], bool] | None = None,
) -> Table:
    """Read a table from a file, or from standard input for ``"-"``; see `parse_table`."""
    return parse_table(*table_text(path), most_rows=most_rows, example=example, is_header=is_header)


def read_columns(
    path: str | os.PathLike[str],
    words: Mapping[str, str],
    needed: Collection[str],
    **options: Any,
) -> tuple[Table, dict[str, tuple[int, str]]]:
    """Read a table of known columns, as `read_table`: the place and the unit of those it has.

    words: by column, what may stand above it, parted by blanks; needed: columns that it must have.

    Raises
    ------
    FileError
        If it is no such table, or a column is unknown, given twice or missing.
    """
    columns = {folded_name(word): one for one, more in words.items() for word in more.split()}

    def refused(rule: str, field: str) -> InputError:
        return table.placed(FileError(rule, field=field, example=options["example"]))

    def column_of(title: str) -> str | None:
        return columns.get(folded_name(title_parts(title)[0]))

    table = read_table(path, is_header=lambda cells: any(map(column_of, cells)), **options)
    places: dict[str, tuple[int, str]] = {}
    for place, title in enumerate(table.header):
        column = column_of(title)
        if column is None:
            near = guess(folded_name(title), words)
            raise refused(said("is an unknown column; {guess}", guess=near), title)
        if column in places:
            raise refused(said("is given twice"), title)
        places[column] = place, title_parts(title)[1]
    if missing := [column for column in needed if column not in places]:
        raise refused(said("is missing"), missing[0])
    return table, places


def table_text(path: str | os.PathLike[str]) -> tuple[str, str]:
    """Return the text of a table and what to call it; ``"-"`` is standard input.

    UTF-8, UTF-16, or else what Windows writes in Western languages; or a workbook, of which one
    sheet is taken. 5 MB at most.

    Raises
    ------
    FileError
        If it cannot be read, is no text, or is a workbook of several sheets of which none is named.
    """
    source = os.fspath(path)
    if is_workbook(source):
        return text_of_workbook(source, _LARGEST), source
    source = STANDARD_INPUT if source == "-" else source
    content = read_bytes(path, _LARGEST, marked("a CSV table"))
    if len(content) > _LARGEST:
        raise FileError(said("is larger than {most} MB", most=_LARGEST // 1_000_000), source=source)
    return decoded(content, source), source


def decoded(content: bytes, source: str) -> str:
    """Return the text of some bytes: UTF-8, UTF-16, or what Windows writes in Western languages.

    Raises
    ------
    FileError
        If they are no text.
    """
    name = encoding_of(content)
    if name != "utf-8":
        try:
            return content.decode(name).removeprefix("\ufeff")
        except UnicodeDecodeError:
            raise FileError(said("is damaged UTF-16 text"), source=source) from None
    if b"\0" in content:
        raise FileError(said("is a binary file; save the table as CSV"), source=source)
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("cp1252", errors="replace")


def encoding_of(content: bytes) -> str:
    """Return "utf-16-le" or "utf-16-be" of text that is such, by its mark or its zeros."""
    for mark, name in ((codecs.BOM_UTF16_LE, "utf-16-le"), (codecs.BOM_UTF16_BE, "utf-16-be")):
        if content.startswith(mark):
            return name
    head = content[:200]
    half = len(head) // 2
    if half > 3 and head[1::2].count(0) > 0.8 * half and not head[::2].count(0):
        return "utf-16-le"
    if half > 3 and head[::2].count(0) > 0.8 * half and not head[1::2].count(0):
        return "utf-16-be"
    return "utf-8"


# --- from text to cells -------------------------------------------------------------------------


def parse_table(
    text: str,
    source: str,
    *,
    most_rows: int,
    example: str,
    least_rows: int = 1,
    is_header: Callable[[Sequence[str]], bool] | None = None,
) -> Table:
    """Take a table apart.

    Parameters
    ----------
    text
        As described in the module. Lines without anything count nothing.
    source
        What to call it in messages.
    most_rows, least_rows
        Below the header.
    example
        Of a header, for messages.
    is_header
        Whether cells are names of columns that are known: by them a header below title lines is
        found. Without it the first line is the header.

    Raises
    ------
    FileError
        If it is no such table, or is too large.
    """
    comments, given, lines = _lines_of(text, source)
    if not lines:
        raise FileError(said("contains no table"), source=source, example=example)
    separator, first = _layout(lines, given, is_header)
    told: dict[str, str] = {}
    for number, line in comments:
        name, colon, value = line.partition(":")
        if colon and number < lines[first][0]:
            folded = name.strip().casefold()
            told.setdefault(_SAID.get(folded, folded), value.strip()[:_LONGEST_CELL])
    found: list[tuple[int, tuple[str, ...]]] = []
    for number, line in lines[first:]:
        if len(found) > most_rows + 1:
            raise FileError(said("has more than {most} rows", most=most_rows), source=source)
        if not line.strip(" \t;,|"):
            continue
        found.append((number, _cells(line, separator, source, number)))
        _check_row(found, separator, source)
    _take_titles(lines[:first], separator, told, source)
    (header_line, header), *rows = found
    if is_header is not None:
        _refuse_second_header(lines[:first], separator, header, is_header, source)
    if rows and _is_row_of_units(rows[0][1]):
        header = with_units(header, rows.pop(0)[1])
    if len(rows) > most_rows:
        raise FileError(said("has more than {most} rows", most=most_rows), source=source)
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


def _lines_of(text: str, source: str) -> tuple[list[tuple[int, str]], str, list[tuple[int, str]]]:
    """Take comments, the separator that is given, and the other lines, with their numbers.

    A cell in quotation marks may go over several lines of the file.
    """
    comments: list[tuple[int, str]] = []
    lines: list[tuple[int, str]] = []
    given = ""
    held: list[str] = []
    for number, line in enumerate(text.replace("\r\n", "\n").replace("\r", "\n").split("\n"), 1):
        if len(line) > _LONGEST_LINE:
            rule = said("is longer than {most} characters", most=_LONGEST_LINE)
            raise FileError(rule, source=source, line=number)
        if held:
            held.append(line.strip())
            line = " ".join(held)
            if _is_open(line) and len(held) < _MOST_LINES_OF_CELL:
                continue
            number, held = number - len(held) + 1, []
        elif _is_open(line):
            held = [line.rstrip()]
            continue
        if line.lstrip().startswith("#"):
            comments.append((number, line.lstrip("# \t")))
            continue
        if not lines and not given and (match := separator_said(line)):
            given = match
            continue
        if line.strip(" \t;,|"):
            lines.append((number, line))
    if held:
        lines.append((number - len(held) + 1, " ".join(held)))
    return comments, given, lines


def _is_open(line: str) -> bool:
    """Whether a line ends within a cell in quotation marks."""
    return line.count('"') % 2 == 1 and _OPEN_QUOTE.search(line) is not None


def separator_said(line: str) -> str:
    """Return the separator that a line such as ``sep=;`` says; empty if it says none."""
    match = _SEPARATOR_SAID.fullmatch(line.strip(" \ufeff"))
    if match is None:
        return ""
    return "\t" if match[1] in ("\\t", "\t") else match[1]


def split_line(line: str, separator: str) -> list[str]:
    """Return the cells of a line, without the blanks around them; none of a line that is no CSV."""
    if separator == BLANKS:
        return line.split()
    try:
        return [cell.strip() for cell in next(csv.reader([line], delimiter=separator, strict=True))]
    except (csv.Error, StopIteration):
        return []


def _layout(
    lines: Sequence[tuple[int, str]],
    given: str,
    is_header: Callable[[Sequence[str]], bool] | None,
) -> tuple[str, int]:
    """Return what parts the cells, and which line is the header.

    A header holds a known name and as many cells as the line below it; of several ways to part the
    cells, that of the most lines is taken, and the earlier of `SEPARATORS` where they are even.
    """
    texts = [line for _, line in lines[: _MOST_ABOVE + _SAMPLED]]
    found: list[tuple[tuple[bool, int], str, int]] = []
    there = [mark for mark in (*SEPARATORS, BLANKS) if any(mark in line for line in texts)]
    # where nothing parts the cells it is one column, in which a comma is a decimal one
    for mark in (given,) if given else (*there, SEPARATORS[0]):
        place = None if is_header is None else _header_place(texts, mark, is_header)
        if place is None:
            continue
        width = len(split_line(texts[place], mark))
        fitting = sum(len(split_line(line, mark)) == width for line in texts[place:])
        found.append(((width > 1, fitting), mark, place))
        if width > 1 and fitting == len(texts) - place:
            break  # no other can do better
    if found:
        best = max(score for score, *_ in found)
        return next((mark, place) for score, mark, place in found if score == best)
    if given:
        return given, 0
    first = texts[0]
    return next((mark for mark in (";", "\t", "|") if mark in first), ","), 0


def _header_place(
    lines: Sequence[str], mark: str, is_header: Callable[[Sequence[str]], bool]
) -> int | None:
    """The first line that can be the header if a mark parts the cells; None without."""
    if mark == BLANKS and _only_grouped(lines):
        return None
    for place, line in enumerate(lines[:_MOST_ABOVE]):
        row = split_line(line, mark)
        if (mark == BLANKS and len(row) < 2) or not is_header(row) or _has_number(row):
            continue
        if place + 1 == len(lines):
            return place
        below = split_line(lines[place + 1], mark)
        if len(below) != len(row):
            continue
        plain = _has_number(below) or _is_row_of_units(below)
        if plain or len(row) == 1 or not is_header(below):
            return place  # else it is a title, perhaps, above the names
    return None


def _has_number(cells: Sequence[str]) -> bool:
    return any(PLAIN.fullmatch(cell.replace(",", ".")) for cell in cells)


def _only_grouped(lines: Sequence[str]) -> bool:
    """Whether below the first line every line is one number, its thousands parted by blanks."""
    return all(GROUPED.fullmatch(line.strip()) for line in lines[1:])


def _take_titles(
    lines: Sequence[tuple[int, str]], separator: str, told: dict[str, str], source: str
) -> None:
    """Take what the lines above the header say; refuse those that are rows of numbers.

    Raises
    ------
    FileError
        If numbers stand there: they would be left out.
    """
    for number, line in lines:
        cells = [cell for cell in split_line(line, separator) if cell]
        if len(cells) > 1 and _BEGINS_AS_NUMBER.match(cells[0]):
            rule = said("stands above the names of the columns; put it below them, or leave it out")
            raise FileError(rule, field=cells[0], source=source, line=number)
        if saying := _saying(line, separator):
            told.setdefault(*saying)
        elif len(cells) == 1:
            told.setdefault("title", cells[0][:_LONGEST_CELL])


def _refuse_second_header(
    lines: Sequence[tuple[int, str]],
    separator: str,
    header: Sequence[str],
    is_header: Callable[[Sequence[str]], bool],
    source: str,
) -> None:
    """Refuse a table above whose header another line holds nothing but names of columns.

    Raises
    ------
    FileError
        If there is one: nobody knows which of them names the columns.
    """
    for number, line in lines:
        cells = split_line(line, separator)
        if len(cells) == len(header) > 1 and all(is_header([cell]) for cell in cells):
            rule = said("holds names of columns, and so does a line below; leave one out")
            raise FileError(rule, field=cells[0], source=source, line=number)


def _is_row_of_units(cells: Sequence[str]) -> bool:
    """Whether every cell that is filled is a unit, and one of them more than a dash."""
    filled = [cell.strip("[]() ") for cell in cells if cell]
    return all(map(is_unit_word, filled)) and any(cell not in ("", "-", "–") for cell in filled)


def with_units(header: Sequence[str], units: Sequence[str]) -> tuple[str, ...]:
    """Return names of columns with the units of the line below them in brackets."""
    bare = [unit.strip("[]() ") for unit in units]
    return tuple(
        f"{name} [{unit}]" if unit and not title_parts(name)[1] else name
        for name, unit in zip(header, bare, strict=True)
    )


def _cells(line: str, separator: str, source: str, number: int) -> tuple[str, ...]:
    if separator == BLANKS:
        return tuple(line.split())
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
        rule = counted(
            "has {n} cell where the header has {columns}",
            "has {n} cells where the header has {columns}",
            len(cells),
            columns=len(header),
        )
        if separator == ",":
            rule += said("; with decimal commas, separate the cells by semicolons")
        raise FileError(rule, source=source, line=line)
