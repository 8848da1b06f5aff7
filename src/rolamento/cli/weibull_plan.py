"""`rolamento weibull-plan`: how many bearings, how long, how many failures."""

from __future__ import annotations

import typer

from rolamento.cli.common import LanguageOption
from rolamento.cli.grouped_help import GroupedCommands
from rolamento.cli.requested import add_command
from rolamento.tasks.weibull import DemonstrationTest, PrecisionTest

__all__ = ["app"]

app = typer.Typer(cls=GroupedCommands, no_args_is_help=True, rich_markup_mode=None)


@app.callback()
def weibull_plan(lang: LanguageOption = None) -> None:
    """Plan a life test: bearings, time, failures.

    Bearings and time to demonstrate a life, or failures to estimate one.
    """


add_command(app, DemonstrationTest, "demonstration")
add_command(app, PrecisionTest, "precision")
