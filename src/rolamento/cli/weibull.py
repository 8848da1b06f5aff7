"""`rolamento weibull`: what a life test says, with bounds, pictures and JSON."""

from __future__ import annotations

import typer

from rolamento.cli.requested import add_command
from rolamento.tasks.weibull import LifeTestEvaluation

__all__ = ["app"]

app = typer.Typer()
add_command(
    app,
    LifeTestEvaluation,
    "weibull",
    "Fit a Weibull distribution to a life test, with bounds.\n\n"
    "What the test shows, and what it does not.",
    epilog="Examples: weibull tests.csv --plot paper.png; weibull tests.csv --shape 1.5;"
    " weibull --example campanha-2008 --calculated-life 'ISO 281=58 h'.",
)
