"""`rolamento verify`: the published numbers beside those that the program gives."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Annotated

import typer

from rolamento.cli.common import NO_RESULT, SOLVED, plain_endings
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import LanguageOption, json_option
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.streams import STANDARD_STREAM, complain, put
from rolamento.cli.waiting import silenced
from rolamento.words import said, speaking

if TYPE_CHECKING:
    from rolamento.verification import Progress, Source, Verification


app = typer.Typer()


@app.command(cls=JsonCommand)
@with_outputs
def verify(
    source: Annotated[
        list[str] | None,
        typer.Option(
            "--source", metavar="NAME", help="Only this source, such as radaelli_2013. Repeatable."
        ),
    ] = None,
    markdown: Annotated[
        str | None,
        typer.Option(
            "--markdown", metavar="FILE", help="Write a page in Markdown; - for standard output."
        ),
    ] = None,
    json: Annotated[str | None, json_option("Write all numbers as JSON")] = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Compare the program with published numbers.

    The exit code is 1 if one fails.
    """
    with plain_endings(lang):
        outputs.check({"--json": json, "--markdown": markdown})
        found = _run(source or ())
        _write_outputs(found, json, markdown, outputs)
    raise typer.Exit(SOLVED if found.passed else NO_RESULT)


def _run(names: Sequence[str]) -> Verification:
    from rolamento.verification import run

    if sys.stderr is None or not sys.stderr.isatty():
        return run(names)
    with silenced(), _progress_on_terminal() as progress:
        return run(names, progress=progress)


@contextmanager
def _progress_on_terminal() -> Iterator[Progress]:
    """Show on a terminal's standard error which source is at work."""
    from rich.console import Console

    from rolamento.document.medium import Medium

    medium = Medium.of(sys.stderr)
    with Console(stderr=True, highlight=False, markup=False).status(
        "", spinner="dots" if medium.draws else "line"
    ) as status:

        def progress(source: Source, done: int, count: int) -> None:
            text = said(
                "Verifying {number} of {count}: {name} …",
                number=done + 1,
                count=count,
                name=source.name,
            )
            status.update(medium.fitted(text))

        yield progress


def _write_outputs(
    found: Verification, json: str | None, markdown: str | None, outputs: Outputs
) -> None:
    """Write what was asked for; standard output takes data or the page, not both."""
    from rolamento.document.markdown import markdown as as_markdown
    from rolamento.pages.verification import summary, verification_page

    if json is not None:
        put(found.to_json() + "\n", json)
    if markdown is not None:
        with speaking("en"):  # the page of the documentation
            put(as_markdown(verification_page(found, introduction=True)), markdown)
    outputs.show(lambda: verification_page(found), json, markdown)
    if STANDARD_STREAM in (json, markdown, outputs.csv) and not found.passed:
        complain(summary(found))
