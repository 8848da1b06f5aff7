"""Where commands write to: checked before any work, so that none is lost at the end."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields
from typing import TYPE_CHECKING, Annotated, Final

import typer

from rolamento.cli.common import same_file
from rolamento.cli.streams import STANDARD_STREAM, put, show
from rolamento.document.writing import REPORTS, check_ending
from rolamento.errors import FileError, InputError
from rolamento.io.writing import write_bytes
from rolamento.records import frozen
from rolamento.validate import one_of
from rolamento.words import said
from rolamento.words.naming import listed

if TYPE_CHECKING:
    from rolamento.document import Document

__all__ = ["OUTPUT_OPTIONS", "Outputs", "check_outputs"]

_PICTURES: Final = ("--plot", "--contour", "--kurtogram")
_SEPARATORS: Final = {"comma": ",", "semicolon": ";", "tab": "\t", "bar": "|"}
_DECIMAL_MARKS: Final = {"point": ".", "comma": ","}
_ENDINGS: Final = {"--report": REPORTS, "--csv": (".csv", ".tsv", ".txt", ""), "--xlsx": (".xlsx",)}


@frozen
class Outputs:
    """Where a page goes besides the terminal, and how its tables are written."""

    report: Annotated[
        str | None,
        typer.Option(
            "--report",
            metavar="FILE",
            help="Write the page as a report: a .html, .pdf, .md or .txt file.",
        ),
    ] = None
    csv: Annotated[
        str | None,
        typer.Option(
            "--csv",
            metavar="FILE",
            help="Write the main table, or that of --table, as CSV; - is standard output.",
        ),
    ] = None
    xlsx: Annotated[
        str | None,
        typer.Option(
            "--xlsx", metavar="FILE", help="Write all tables as a workbook, one sheet each."
        ),
    ] = None
    table: Annotated[
        str | None,
        typer.Option("--table", metavar="NAME", help="Table of --csv, such as stiffness."),
    ] = None
    separator: Annotated[
        str | None,
        typer.Option(
            "--separator",
            metavar="MARK",
            help="Separator of --csv: comma, semicolon, tab or bar; comma by default, semicolon"
            " where the decimal mark is a comma.",
        ),
    ] = None
    decimal: Annotated[
        str | None,
        typer.Option(
            "--decimal", metavar="MARK", help="Decimal mark of --csv: point (default) or comma."
        ),
    ] = None
    si: Annotated[
        bool,
        typer.Option("--si", help="SI units in --csv and --xlsx instead of µm, MPa, rpm, °C …"),
    ] = False

    def files(self) -> dict[str, str | None]:
        """Return the files by their options, for `check_outputs`."""
        return {"--report": self.report, "--csv": self.csv, "--xlsx": self.xlsx}

    def check(self, others: Mapping[str, str | None], *read: str | None) -> None:
        """Refuse options that say nothing, marks that are none, and files as `check_outputs`.

        others: the files of further options.

        Raises
        ------
        InputError, FileError
            For the first that will not do.
        """
        for option, value, needed in (
            ("--table", self.table, self.csv),
            ("--separator", self.separator, self.csv),
            ("--decimal", self.decimal, self.csv),
            ("--si", self.si or None, self.csv or self.xlsx),
        ):
            if value is not None and needed is None:
                raise InputError(said("needs {option}", option="--csv"), source=option)
        self._marks()
        check_outputs({**others, **self.files()}, *read)

    @property
    def has_tables(self) -> bool:
        """Whether tables of the page go to files."""
        return self.csv is not None or self.xlsx is not None

    def show(
        self,
        page: Callable[[], Document],
        *others: str | None,
        report: Callable[[], Document] | None = None,
    ) -> None:
        """Write a page where it was asked for, and on the terminal, unless data goes there.

        Parameters
        ----------
        page
            Returns it; not called where nobody asked for it.
        others
            Where else the command has written data to.
        report
            Returns what a report has, where that is more than the page.
        """
        silent = STANDARD_STREAM in (self.csv, *others)
        if silent and not any(self.files().values()):
            return
        document = page()
        if not silent:
            show(document)
        self.write(document, report)

    def write(self, document: Document, report: Callable[[], Document] | None = None) -> None:
        """Write the files that were asked for; report: as of `show`."""
        if not any(self.files().values()):
            return
        from rolamento.document.tables import to_csv, to_xlsx
        from rolamento.document.writing import write

        if self.csv is not None:
            separator, decimal = self._marks()
            try:
                text = to_csv(
                    document, self.table or "", separator=separator, decimal=decimal, si=self.si
                )
            except InputError as error:
                raise error.with_details(source="--table" if self.table else "--csv") from None
            put(text, self.csv)
        if self.xlsx is not None:
            write_bytes(to_xlsx(document, si=self.si), self.xlsx)
        if self.report is not None:
            write(document if report is None else report(), self.report)

    def _marks(self) -> tuple[str, str]:
        """Return separator and decimal mark."""
        decimal = _mark("--decimal", self.decimal or "point", _DECIMAL_MARKS)
        usual = "semicolon" if decimal == "," else "comma"
        separator = _mark("--separator", self.separator or usual, _SEPARATORS)
        if separator == decimal:
            raise InputError(
                said("the separator and the decimal mark must differ"),
                source="--separator",
                value=separator,
                example="semicolon",
            )
        return separator, decimal


def _mark(option: str, given: str, marks: Mapping[str, str]) -> str:
    """Return a mark that is given by its name or as it is."""
    if given in marks.values():
        return given
    one_of(given, "", marks, source=option)
    return marks[given]


OUTPUT_OPTIONS: Final = tuple(one.name for one in fields(Outputs))
"""The names of their parameters, for the groups of a help."""


def check_outputs(outputs: Mapping[str, str | None], *read: str | None) -> None:
    """Refuse outputs that would run into each other or over what is read, and unknown pictures.

    Parameters
    ----------
    outputs
        Files by option; None where nothing is asked for.
    read
        Files that the command reads.

    Raises
    ------
    InputError, FileError
        For the first that will not do.
    """
    given = {option: path for option, path in outputs.items() if path is not None}
    for option, path in given.items():
        meeting = [one for one, other in given.items() if same_file(path, other)]
        if len(meeting) > 1:
            where = said("standard output") if path == STANDARD_STREAM else path
            raise InputError(
                said("only one of {options} can go there", options=listed(meeting)), source=where
            )
        if path != STANDARD_STREAM and any(other and same_file(path, other) for other in read):
            rule = said("is one of the input files; choose another name")
            raise FileError(rule, source=path)
        if option in _PICTURES:
            from rolamento.plots.saving import check_name

            check_name(path)
        if option in _ENDINGS and (option, path) != ("--csv", STANDARD_STREAM):
            check_ending(path, _ENDINGS[option])
