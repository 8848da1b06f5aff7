"""`rolamento warm`: compile the solver for this machine, before anybody waits for it."""

from __future__ import annotations

from typing import Annotated

import typer

from rolamento.cli.common import SOLVED, LanguageOption, plain_endings
from rolamento.cli.grouped_help import SpokenCommand
from rolamento.cli.streams import print_text
from rolamento.cli.waiting import progress_of
from rolamento.words import said

__all__ = ["app", "warm"]

app = typer.Typer()


@app.command(cls=SpokenCommand, epilog="Example: warm.")
def warm(
    background: Annotated[
        bool,
        typer.Option("--background", help="Give way to others, and use one processor."),
    ] = False,
    lang: LanguageOption = None,
) -> None:
    """Compile the solver for this machine, once.

    Later, nothing waits for the compiler. Without this command the first one starts it in the
    background. ROLAMENTO_COMPILE=here, in the environment, compiles where it is needed instead.
    """
    from rolamento.tasks.warm import warm as compile_all

    with plain_endings(lang):
        with progress_of(said("Compiling …")) as progress:
            done = compile_all(progress, background=background)
        if done.busy:
            print_text(said("Another process is compiling already.") + "\n")
        else:
            for title in done.parts:
                print_text(said("compiled: {part}", part=said(title)) + "\n")
    raise typer.Exit(SOLVED)
