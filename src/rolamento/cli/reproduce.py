"""`rolamento reproduce`: the figures and tables of a publication, computed anew."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from enum import StrEnum
from typing import TYPE_CHECKING, Annotated

import typer

from rolamento.cli.common import plain_endings, words_of
from rolamento.cli.options import LanguageOption
from rolamento.cli.streams import print_text

if TYPE_CHECKING:
    from rolamento_reproductions.record import Section
    from rolamento_reproductions.text import Language as Code
    from rolamento_reproductions.text import Text


class Pictures(StrEnum):
    """Formats of the pictures."""

    svg = "svg"
    png = "png"
    both = "both"


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
    with plain_endings(lang):
        code: Code = "pt" if words_of(lang).code == "pt" else "en"
        if name is None:
            print_text(_list_of_sources(code))
            return
        _write_reproduction(name, output, pictures, code)


def _write_reproduction(name: str, output: str | None, pictures: Pictures, code: Code) -> None:
    """Compute and write what a name stands for, and say where it lies."""
    from rolamento_reproductions import computed, find, open_folder, write
    from rolamento_reproductions.writing import PAGE

    source = find(name)
    folder = open_folder(source.name if output is None else output, source)
    with _progress_bar(code) as progress:
        sections = computed(source, progress)
        write(
            source,
            sections,
            folder,
            language=code,
            pictures=pictures.value,
            progress=progress,
        )
    print_text(_summary_and_page(sections, str(folder / PAGE), code))


def _list_of_sources(code: Code) -> str:
    """List what can be reproduced, with the source and what is in it."""
    from rolamento_reproductions import NAMES, find

    return "".join(f"{name}\n    {find(name).reference.speak(code)}\n" for name in NAMES)


def _summary_and_page(sections: tuple[Section, ...], page: str, code: Code) -> str:
    from rolamento_reproductions.page import summary

    lines = [text.speak(code) for text in summary(sections)]
    return "\n".join([*lines, page]) + "\n"


@contextmanager
def _progress_bar(code: Code) -> Iterator[Callable[[int, int, Text], None]]:
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
    with Progress(*columns, console=console, transient=True) as shown:
        task = shown.add_task("", total=None)
        yield lambda done, total, what: shown.update(
            task, completed=done, total=total, description=_short(what.speak(code))
        )


def _short(text: str) -> str:
    return text if len(text) <= 40 else text[:39] + "…"
