"""`rolamento report`: what an engineer signs, of one case or of several side by side."""

from __future__ import annotations

import sys
from typing import Annotated

import typer

from rolamento.cli.case_options import NOTHING_GIVEN, CaseOptions, with_case
from rolamento.cli.common import NO_RESULT, SOLVED, plain_endings
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import JsonOption, LanguageOption
from rolamento.cli.outputs import check_outputs
from rolamento.cli.streams import STANDARD_STREAM, print_text, put
from rolamento.cli.waiting import progress_of
from rolamento.words import said

__all__ = ["app", "report"]


app = typer.Typer()


@app.command(
    cls=JsonCommand,
    epilog="Examples: report case.toml -o report.pdf --author 'A. Souza';"
    " report old.toml new.toml -o comparison.html; report 6305 --fr '2 kN'.",
)
@with_case
def report(
    cases: Annotated[
        list[str],
        typer.Argument(
            metavar="CASE...",
            help="Case files, or designations such as 6305; up to 20, side by side. "
            "- is standard input.",
        ),
    ],
    given: CaseOptions = NOTHING_GIVEN,
    output: Annotated[
        str | None,
        typer.Option(
            "--output",
            "-o",
            metavar="FILE",
            help="Write the report: a .html, .pdf, .md or .txt file. By default it is printed.",
        ),
    ] = None,
    project: Annotated[
        str, typer.Option("--project", metavar="TEXT", help="Project, in the title block.")
    ] = "",
    author: Annotated[
        str, typer.Option("--author", metavar="TEXT", help="Author, in the title block.")
    ] = "",
    revision: Annotated[
        str, typer.Option("--revision", metavar="TEXT", help="Revision, in the title block.")
    ] = "",
    date: Annotated[
        str, typer.Option("--date", metavar="DATE", help="Date of the report; today by default.")
    ] = "",
    checked_by: Annotated[
        str, typer.Option("--checked-by", metavar="TEXT", help="Checker, in the title block.")
    ] = "",
    json: JsonOption = None,
    lang: LanguageOption = None,
) -> None:
    """Write a calculation report to sign, of one case or several.

    Several cases stand side by side, with their differences from the first.
    """
    with plain_endings(lang), given.in_force():
        _check(cases, output, json)
        from rolamento.tasks.report import calculation_report

        head = {
            "project": project,
            "author": author,
            "revision": revision,
            "date": date,
            "checked_by": checked_by,
        }
        with progress_of(said("cases analysed")) as progress:
            found = calculation_report(cases, head, given.settings, progress=progress)
        from rolamento.pages.report import report_page

        if json is not None:
            put(found.to_json() + "\n", json)
        page = report_page(found)
        if output is not None:
            from rolamento.document.writing import write

            write(page, output)
        elif json != STANDARD_STREAM:
            from rolamento.document import Medium
            from rolamento.document.terminal import terminal

            print_text(terminal(page, Medium.of(sys.stdout)))
    raise typer.Exit(SOLVED if found.converged else NO_RESULT)


def _check(cases: list[str], output: str | None, json: str | None) -> None:
    """Refuse, before any work, names that will not do."""
    for case in cases:
        check_outputs({"--output": output, "--json": json}, case)
    if output is not None:
        from rolamento.document.writing import REPORTS, check_ending

        check_ending(output, REPORTS)
