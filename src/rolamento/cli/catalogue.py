"""`rolamento catalogue`: search bearings, show one with what is inside."""

from __future__ import annotations

import itertools
from typing import Any

import typer

from rolamento.cli.common import LanguageOption
from rolamento.cli.grouped_help import GroupedCommands
from rolamento.cli.requested import add_command
from rolamento.tasks.catalogue import BearingRequest, CatalogueSearch

__all__ = ["app"]


class _Commands(GroupedCommands):
    """A designation where a command is expected is shown, also one of several words."""

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        """Take the first words for a designation if they are no command and have a figure.

        Letters before the figure, as of ``QJ 210``, are then capitals; other words are misspelt
        commands.
        """
        first = args[0] if args else ""
        if first not in self.commands and not first.startswith("-"):
            has_figure = any(sign.isdigit() for sign in first)
            if has_figure or (first.isupper() and any(s.isdigit() for s in "".join(args[1:2]))):
                args = ["show", *args]
        if args and args[0] == "show":
            args = ["show", *_with_one_designation(args[1:])]
        return super().resolve_command(ctx, args)


def _with_one_designation(args: list[str]) -> list[str]:
    """Arguments with the words before the first option as one."""
    words = list(itertools.takewhile(lambda word: not word.startswith("-"), args))
    return [" ".join(words), *args[len(words) :]] if words else args


app = typer.Typer(
    cls=_Commands,
    no_args_is_help=True,
    rich_markup_mode=None,
)


@app.callback()
def catalogue(lang: LanguageOption = None) -> None:
    """Search bearings, and show the internal geometry of one.

    By designation: published data, and what is estimated from them.
    """


add_command(app, CatalogueSearch, "search")
add_command(app, BearingRequest, "show")
