"""`rolamento diagnose`: which parts of a bearing a vibration signal shows to be damaged."""

from __future__ import annotations

import typer

from rolamento.cli.requested import add_command
from rolamento.tasks.vibration_diagnosis import VibrationDiagnosis

__all__ = ["app"]

app = typer.Typer()
add_command(
    app,
    VibrationDiagnosis,
    "diagnose",
    "Diagnose damaged parts of a bearing from a vibration signal.\n\n"
    "How severe, why, and what speaks against it. A long signal is read block by block, in bounded"
    " memory.",
    epilog="Examples: diagnose signal.wav --bearing 6205 --speed '1797 rpm' --plot signal.png; "
    "diagnose run.npz --bearing case.toml --speed-channel rpm.",
)
