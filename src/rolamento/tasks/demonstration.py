"""The shipped example: a 218 angular-contact bearing at 10 000 rpm under combined load."""

from __future__ import annotations

import os
from importlib import resources
from typing import Final

from rolamento.case import Case, parse_case
from rolamento.io.writing import write_text

__all__ = ["EXAMPLE", "example_case", "write_example"]

EXAMPLE: Final = resources.files("rolamento") / "examples" / "218_combined.toml"
"""Case file of the demonstration."""


def example_case() -> Case:
    """Return the example's case."""
    return parse_case(EXAMPLE.read_text(encoding="utf-8"), source=str(EXAMPLE))


def write_example(path: str | os.PathLike[str]) -> None:
    """Write the example's case file under a new name.

    Raises
    ------
    FileError
        If there is a file of that name already, or it cannot be written.
    """
    write_text(EXAMPLE.read_text(encoding="utf-8"), path, new=True)
