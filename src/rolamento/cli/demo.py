"""`rolamento demo`: the shipped example, and what to try next."""

from __future__ import annotations

import os
import shutil
import sys
from typing import Annotated, Final

import typer

from rolamento.cli.common import LanguageOption, plain_endings
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.streams import print_text, show
from rolamento.cli.waiting import waiting
from rolamento.words import said

__all__ = ["app", "demo"]

_PROGRAM: Final = "rolamento"

app = typer.Typer()


@app.command(cls=JsonCommand)
def demo(
    write: Annotated[
        str | None,
        typer.Option("--write", metavar="FILE", help="Write the example's case file instead."),
    ] = None,
    lang: LanguageOption = None,
) -> None:
    """Solve the shipped example, and suggest what to try next.

    A 218 angular-contact bearing at 10 000 rpm under combined load.
    """
    from rolamento.tasks.demonstration import example_case, write_example

    with plain_endings(lang):
        if write is not None:
            write_example(write)
            text = said("Wrote {path}; now try: {command} solve {path}", path=write,
                        command=_command())  # fmt: skip
            print_text(f"{text}\n")
            return
        from rolamento.analysis import analyse
        from rolamento.pages.state import state_page

        with waiting(lang):
            found = analyse(example_case())
        show(state_page(found.solved, found))
        print_text(_what_next())


def _what_next() -> str:
    """Return which file was solved, and commands to go on with."""
    from rolamento.tasks.demonstration import EXAMPLE

    command = _command()
    steps = (
        (said("a copy to work on"), "demo --write case.toml"),
        (said("the same with ceramic balls"), "solve case.toml --set bearing.ball_material=Si3N4"),
        (
            said("the balls as a table, and everything as JSON"),
            "solve case.toml --csv balls.csv --json state.json",
        ),
    )
    lines = [f"  # {purpose}\n  {command} {arguments}\n" for purpose, arguments in steps]
    source = said("This was {path}", path=_nearby(str(EXAMPLE)))
    return f"\n{source}\n\n{said('What to try next')}\n{''.join(lines)}"


def _command() -> str:
    """Return how this program can be called again from here."""
    called, found = sys.argv[0], shutil.which(_PROGRAM)
    if os.path.basename(called) != _PROGRAM or not os.path.isfile(called):
        return _PROGRAM
    known = found is not None and os.path.samefile(found, called)
    return _PROGRAM if known else _nearby(called)


def _nearby(path: str) -> str:
    """Return the path as seen from the current directory, if that is shorter."""
    try:
        return min(os.path.relpath(path), path, key=len)
    except ValueError:  # on another drive
        return path
