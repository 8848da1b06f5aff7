"""The options of `rolamento diagnose`, in the groups in which its help shows them."""

from __future__ import annotations

from typing import Annotated, ClassVar

import typer

from rolamento.cli.grouped_help import GroupedCommand, Groups
from rolamento.cli.options import csv_option, plot_option

__all__ = [
    "AngleOption",
    "BearingOption",
    "CsvOption",
    "DiagnoseCommand",
    "FalseAlarmOption",
    "KurtogramOption",
    "NominalOption",
    "PlotOption",
    "PulsesOption",
    "SignalArgument",
    "SlipOption",
    "SpeedChannelOption",
    "SpeedOption",
    "SpeedToleranceOption",
    "SpeedUnitOption",
    "TachoOption",
    "TrackOption",
    "UnitOption",
    "WithinOption",
]


class DiagnoseCommand(GroupedCommand):
    """`rolamento diagnose`, its help in groups."""

    groups: ClassVar[Groups] = {
        "Bearing": ("bearing", "settings", "nominal", "angle"),
        "Speed": (
            *("speed", "outer_speed", "speed_channel", "speed_unit"),
            *("tacho", "pulses", "track", "within"),
        ),
        "Signal": ("channel", "rate", "unit", "scale", "start", "duration", "decimal_mark"),
        "Search": ("slip", "speed_tolerance", "false_alarm"),
        "Output": ("plot", "kurtogram", "json", "csv", "lang", "help"),
    }


SignalArgument = Annotated[
    str,
    typer.Argument(
        metavar="SIGNAL",
        help="File of a signal: WAV, CSV, NumPy, MATLAB, HDF5, Parquet or UFF 58.",
    ),
]

# --- bearing ---------------------------------------------------------------------------------

BearingOption = Annotated[
    str,
    typer.Option(
        "--bearing",
        metavar="BEARING",
        help="Designation such as 6205, or a case file: with a load, the loaded bearing's"
        " frequencies are looked for.",
    ),
]
NominalOption = Annotated[
    bool,
    typer.Option("--nominal", help="Look for the geometry's frequencies, whatever the load."),
]
AngleOption = Annotated[
    str | None,
    typer.Option(
        "--angle",
        metavar="ANGLE",
        help="Of contact, without a load: zero (radial load, the default) or free (axial load) of a"
        " bearing given by its clearance; or any angle, such as '15 deg'.",
    ),
]

# --- speed -----------------------------------------------------------------------------------

SpeedOption = Annotated[
    str | None,
    typer.Option(
        "--speed",
        metavar="SPEED",
        help="Of the inner ring, steady, such as '1797 rpm'; by default as the file tells it, or"
        " else the case.",
    ),
]
SpeedChannelOption = Annotated[
    str | None,
    typer.Option(
        "--speed-channel",
        metavar="CHANNEL",
        help="Of the same file: the shaft's speed at each sample, by name or number.",
    ),
]
SpeedUnitOption = Annotated[
    str | None,
    typer.Option(
        "--speed-unit",
        metavar="UNIT",
        help="Of that: rpm, rad/s, deg/s or Hz, if the file is silent.",
    ),
]
TachoOption = Annotated[
    str | None,
    typer.Option(
        "--tacho",
        metavar="CHANNEL",
        help="Of the same file: pulses of the shaft, held in memory, up to 20 million samples.",
    ),
]
PulsesOption = Annotated[
    int | None,
    typer.Option("--pulses", metavar="N", help="Of that per revolution; by default 1."),
]
TrackOption = Annotated[
    bool,
    typer.Option(
        "--track",
        help="Find the speed along the record in the vibration itself, about --speed; at least 96"
        " revolutions.",
    ),
]
WithinOption = Annotated[
    float | None,
    typer.Option(
        "--within",
        metavar="PART",
        help="By which the speed may be off --speed anywhere, for --track: up to 0.3, by default"
        " 0.1.",
    ),
]

# --- signal ----------------------------------------------------------------------------------

UnitOption = Annotated[
    str | None,
    typer.Option(
        "--unit",
        metavar="UNIT",
        help="Of the samples: m/s^2, g, mm/s, um …; V or counts if they are not calibrated.",
    ),
]

# --- search ----------------------------------------------------------------------------------

SlipOption = Annotated[
    float,
    typer.Option(
        "--slip",
        metavar="PART",
        help="By which the cage may be off the expected speed, 0 to 0.1.",
    ),
]
SpeedToleranceOption = Annotated[
    str,
    typer.Option(
        "--speed-tolerance",
        metavar="PART",
        help="By which a steady speed may be wrong, such as '3 %', up to 10 %; 0 if it is certain."
        " The shaft's own lines tell by how much.",
    ),
]
FalseAlarmOption = Annotated[
    float,
    typer.Option(
        "--false-alarm",
        metavar="P",
        help="Probability that noise without lines of the bearing gives any finding, up to 0.5.",
    ),
]

# --- output ----------------------------------------------------------------------------------

PlotOption = Annotated[str | None, plot_option("Draw waveform, kurtogram and envelope spectrum")]
KurtogramOption = Annotated[
    str | None,
    typer.Option("--kurtogram", metavar="FILE", help="Draw the kurtogram alone, likewise."),
]
CsvOption = Annotated[str | None, csv_option("Write the spectrum of the squared envelope")]
