"""The shipped example: what `rolamento demo` solves, copies and says."""

from __future__ import annotations

import os
import shutil
import sys
from importlib import resources
from typing import Final

from rolamento._writing import write_text
from rolamento.case import Case, parse_case
from rolamento.report.language import Words

__all__ = ["example_case", "what_next", "written"]

_PROGRAM: Final = "rolamento"
_EXAMPLE: Final = resources.files("rolamento") / "examples" / "218_combined.toml"


def example_case() -> Case:
    """Return the example."""
    return parse_case(_text(), source=str(_EXAMPLE))


def written(path: str, words: Words) -> str:
    """Write the example's case file under a new name, and return what to say about it.

    Raises
    ------
    FileError
        If there is a file of that name already, or it cannot be written.
    """
    write_text(_text(), path, new=True)
    return words.demo_written.format(path=path, command=_command()) + "\n"


def what_next(words: Words) -> str:
    """Return which file was solved, and commands to go on with."""
    command = _command()
    steps = (
        (words.demo_copy, "demo --write case.toml"),
        (words.demo_vary, "solve case.toml --set bearing.ball_material=Si3N4"),
        (words.demo_data, "solve case.toml --csv balls.csv --json state.json"),
    )
    lines = [f"  # {purpose}\n  {command} {arguments}\n" for purpose, arguments in steps]
    source = words.demo_source.format(path=_nearby(str(_EXAMPLE)))
    return f"\n{source}\n\n{words.demo_next}\n{''.join(lines)}"


def _text() -> str:
    return _EXAMPLE.read_text(encoding="utf-8")


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
