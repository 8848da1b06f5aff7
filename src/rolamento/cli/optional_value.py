"""An option whose value may be left out: ``--json`` as well as ``--json FILE``.

Typer has no such option. The arguments are therefore put in order before they are parsed: where
``--json`` has no value, it gets ``-``, which stands for standard output.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

from typer.core import TyperCommand

__all__ = ["SolveCommand", "with_values"]

_OPTION: Final = "--json"
_LEFT_OUT: Final = "--json=-"
_WITH_VALUE: Final = frozenset({"--csv", "--set", "--lang"})


class SolveCommand(TyperCommand):
    """A command in which the value of ``--json`` may be left out."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Parse the arguments with that value filled in."""
        return super().parse_args(ctx, with_values(args))


def with_values(arguments: Sequence[str]) -> list[str]:
    """Return the arguments with a value for every ``--json``.

    The word after ``--json`` is its FILE, unless the command line would then lack its CASE:
    ``--json case.toml`` writes the JSON of that case to standard output.
    """
    kinds = _kinds(arguments)
    has_case = "case" in kinds
    result: list[str] = []
    for word, kind in zip(arguments, kinds, strict=True):
        if kind == "file" and has_case:
            result[-1] = f"{_OPTION}={word}"
        else:
            result.append(_LEFT_OUT if kind == "json" else word)
    return result


def _kinds(arguments: Sequence[str]) -> list[str]:
    """Tell for every word what it is: option, value, json, file (its value, perhaps) or case."""
    kinds: list[str] = []
    for position, word in enumerate(arguments):
        before = kinds[-1] if kinds else ""
        if "--" in arguments[:position]:
            kinds.append("case")
        elif before == "needs value":
            kinds.append("value")
        elif word.startswith("-") and word != "-":
            kinds.append(_kind_of_option(word))
        else:
            kinds.append("file" if before == "json" else "case")
    return kinds


def _kind_of_option(word: str) -> str:
    if word == _OPTION:
        return "json"
    return "needs value" if word in _WITH_VALUE else "option"
