"""`rolamento severity`: broadband velocity of a machine, its zone, its alarm, and its trend."""

from __future__ import annotations

import typer

from rolamento.cli.requested import add_command
from rolamento.tasks.severity import VibrationSeverity

__all__ = ["app"]

app = typer.Typer()
add_command(
    app,
    VibrationSeverity,
    "severity",
    "Show the vibration severity in mm/s and its zone.\n\n"
    "Broadband RMS velocity and zones A to D of ISO 20816-3; for several signals, over time.",
    epilog="Examples: severity motor.csv --unit g --speed '1480 rpm' --power '45 kW' --support"
    " rigid; severity jan.wav feb.wav mar.wav --unit mm/s --hours 0,700,1400 --plot trend.png.",
)
