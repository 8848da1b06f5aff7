"""`rolamento reproduce`: the figures and tables of a publication, computed anew."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from enum import StrEnum
from textwrap import fill
from typing import TYPE_CHECKING, Annotated, Final, Protocol

import typer

from rolamento.cli.common import LanguageOption, plain_endings
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.streams import print_text
from rolamento.cli.waiting import silenced
from rolamento.errors import InputError, guess
from rolamento.words import said

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

GROUP: Final = "rolamento.reproductions"
"""Entry points by which packages offer publications, each a `Reproduction`."""

Progress = Callable[[int, int, object], None]
_LONGEST_TEXT: Final = 40
_INDENT: Final = "    "


class Reproduction(Protocol):
    """A publication that a package can compute anew; its texts are said by `str`."""

    @property
    def reference(self) -> object:
        """Source, and what is in it."""

    def reproduce(self, folder: str | None, pictures: str, progress: Progress) -> list[str]:
        """Write it to a folder, by default of its name; return lines on what came out."""


class Pictures(StrEnum):
    """Formats of the pictures."""

    svg = "svg"
    png = "png"
    both = "both"


app = typer.Typer()


@app.command(
    cls=JsonCommand, epilog="Example: reproduce radaelli-2013 --output radaelli --lang pt."
)
def reproduce(
    name: Annotated[
        str | None,
        typer.Argument(
            metavar="NAME",
            help="Publication, such as radaelli-2013; without it, the list of them.",
        ),
    ] = None,
    output: Annotated[
        str | None,
        typer.Option(
            "--output", metavar="FOLDER", help="Folder to write to; by default one of that name."
        ),
    ] = None,
    pictures: Annotated[
        Pictures, typer.Option("--pictures", help="Formats of the pictures.")
    ] = Pictures.both,
    lang: LanguageOption = None,
) -> None:
    """Reproduce every figure and table of a publication.

    Computed by this program, with an index page.
    """
    from importlib.metadata import entry_points

    with plain_endings(lang):
        found = {point.name: point for point in entry_points(group=GROUP)}
        if not found:
            raise InputError(
                said(
                    "no reproductions are installed; they are a package of their own:"
                    " pip install rolamento-reproductions (in a checkout: pip install"
                    " ./reproductions)"
                )
            )
        if name is None:
            print_text("".join(f"{key}\n{_hung(_loaded(found[key]))}\n" for key in sorted(found)))
            return
        if name not in found:
            rule = said("cannot be reproduced; {guess}", guess=guess(name, sorted(found)))
            raise InputError(rule, value=name)
        with _progress_bar() as progress:
            lines = _loaded(found[name]).reproduce(output, pictures.value, progress)
        print_text("\n".join(lines) + "\n")


def _hung(one: Reproduction) -> str:
    return fill(str(one.reference), 80, initial_indent=_INDENT, subsequent_indent=_INDENT)


def _loaded(point: EntryPoint) -> Reproduction:
    reproduction: Reproduction = point.load()
    return reproduction


@contextmanager
def _progress_bar() -> Iterator[Progress]:
    """Show on standard error how far it is, if a person is there to see it."""
    if sys.stderr is None or not sys.stderr.isatty():
        yield lambda done, total, what: None
        return
    from rich.console import Console
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        TextColumn,
        TimeElapsedColumn,
    )

    text = TextColumn("{task.description}", markup=False)
    columns = (BarColumn(), MofNCompleteColumn(), TimeElapsedColumn(), text)
    console = Console(stderr=True, highlight=False)
    with silenced(), Progress(*columns, console=console, transient=True) as shown:
        task = shown.add_task("", total=None)
        yield lambda done, total, what: shown.update(
            task, completed=done, total=total, description=_short(str(what))
        )


def _short(text: str) -> str:
    return text if len(text) <= _LONGEST_TEXT else text[: _LONGEST_TEXT - 1] + "…"
