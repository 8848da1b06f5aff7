"""An option whose value may be left out: ``--json`` as well as ``--json FILE``.

Typer has no such option. The arguments are therefore put in order before they are parsed: where
``--json`` has no value, it gets ``-``, which stands for standard output.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Any, Final

from rolamento.cli.grouped_help import SpokenCommand

__all__ = ["JsonCommand", "with_values"]

_OPTION: Final = "--json"
_LEFT_OUT: Final = "--json=-"


class JsonCommand(SpokenCommand):
    """A command in which the value of ``--json`` may be left out."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Parse the arguments with that value filled in."""
        takers: set[str] = set()
        takes_word, lacks_word = False, True
        for parameter in self.params:
            is_option = parameter.param_type_name == "option"
            takes_word = takes_word or not is_option
            lacks_word = lacks_word and (is_option or not parameter.required)
            if is_option and not getattr(parameter, "is_flag", False):
                takers.update(parameter.opts)
        if _OPTION in takers:
            args = with_values(args, takers - {_OPTION}, takes_word, lacks_word)
        return super().parse_args(ctx, args)


def with_values(
    arguments: Sequence[str],
    takers: Collection[str],
    takes_word: bool = True,
    lacks_word: bool = False,
) -> list[str]:
    """Return the arguments with a value for every ``--json``.

    takers: the other options that take a value; takes_word: whether the command takes a word that
    is no option, its CASE; lacks_word: whether it may go without.

    The word after ``--json`` is its FILE, unless the command line would then lack its CASE:
    ``--json case.toml`` writes the JSON of that case to standard output. Of a command that may go
    without, only a word that ends in .json is a FILE then.
    """
    kinds = _kinds(arguments, takers)
    has_case = "case" in kinds or not takes_word
    result: list[str] = []
    for word, kind in zip(arguments, kinds, strict=True):
        is_file = has_case or (lacks_word and word.casefold().endswith(".json"))
        if kind == "file" and is_file:
            result[-1] = f"{_OPTION}={word}"
        else:
            result.append(_LEFT_OUT if kind == "json" else word)
    return result


def _kinds(arguments: Sequence[str], takers: Collection[str]) -> list[str]:
    """Return the kind of every word: option, value, json, file (its value, perhaps) or case."""
    kinds: list[str] = []
    for position, word in enumerate(arguments):
        before = kinds[-1] if kinds else ""
        if "--" in arguments[:position]:
            kinds.append("case")
        elif before == "needs value":
            kinds.append("value")
        elif word.startswith("-") and word != "-":
            kinds.append(_kind_of_option(word, takers))
        else:
            kinds.append("file" if before == "json" else "case")
    return kinds


def _kind_of_option(word: str, takers: Collection[str]) -> str:
    if word == _OPTION:
        return "json"
    return "needs value" if word in takers else "option"
