"""`rolamento replace`: keep a bearing or replace it, by a Weibull distribution of lives."""

from __future__ import annotations

import typer

from rolamento.cli.common import LanguageOption
from rolamento.cli.grouped_help import GroupedCommands
from rolamento.cli.requested import add_command
from rolamento.tasks.replace import FleetRequest, RemainingLifeRequest, ReplacementRequest

__all__ = ["app"]

app = typer.Typer(cls=GroupedCommands, no_args_is_help=True, rich_markup_mode=None)


@app.callback()
def replace(lang: LanguageOption = None) -> None:
    """Plan to keep or to replace bearings.

    Remaining life, replacement at least cost, expected failures of a fleet.
    """


add_command(app, RemainingLifeRequest, "remaining")
add_command(app, ReplacementRequest, "age")
add_command(app, FleetRequest, "fleet")
