"""The options that several commands have, in one wording each."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from rolamento.cli.common import Language

__all__ = [
    "BearingArgument",
    "CataloguesOption",
    "ForceOption",
    "JsonOption",
    "LagOption",
    "LanguageOption",
    "MachineArgument",
    "MachineSettingsOption",
    "OuterSpeedOption",
    "PlotOption",
    "SettingsOption",
    "SpeedOption",
    "VariantsOption",
    "json_option",
    "plot_option",
]


def json_option(what: str) -> Any:
    """Return the option ``--json [FILE]`` that does what is said."""
    text = f"{what}; without FILE, to standard output."
    return typer.Option("--json", metavar="[FILE]", help=text)


def plot_option(what: str) -> Any:
    """Return the option ``--plot FILE`` that does what is said."""
    return typer.Option("--plot", metavar="FILE", help=f"{what}: a .png, .svg or .pdf file.")


# --- of most commands ------------------------------------------------------------------------

MachineArgument = Annotated[
    str,
    typer.Argument(
        metavar="MACHINE",
        help="Machine file (TOML or JSON, or a workbook, .xlsx); - for standard input.",
    ),
]
MachineSettingsOption = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="KEY=VALUE",
        help="Override a field of the machine: parts by name, or by number from 0. Repeatable.",
    ),
]
SettingsOption = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="KEY=VALUE", help="Override a field of the case. Repeatable."),
]
CataloguesOption = Annotated[
    list[str] | None,
    typer.Option(
        "--catalogue",
        metavar="FILE",
        help="A catalogue of your own, CSV or TOML, for designations. Repeatable.",
    ),
]
VariantsOption = Annotated[
    list[str] | None,
    typer.Option(
        "--variant",
        metavar="NAME:FIELD=VALUE",
        help="Also the case with this changed, under this name; further FIELD=VALUE after commas, "
        "such as 'spring:bearing.preload={ spring = \"500 N\" }'. Repeatable.",
    ),
]
ForceOption = Annotated[bool, typer.Option("--force", help="Overwrite files that are there.")]
JsonOption = Annotated[str | None, json_option("Write everything as JSON, in SI units")]
PlotOption = Annotated[str | None, plot_option("Draw the result")]
LanguageOption = Annotated[
    Language | None,
    typer.Option(
        "--lang", help="Language of pages, help and messages; by default that of the locale."
    ),
]

# --- a bearing that turns --------------------------------------------------------------------

BearingArgument = Annotated[
    str,
    typer.Argument(
        metavar="BEARING",
        help="Designation such as 6205, or a case file; - for a case on standard input.",
    ),
]
SpeedOption = Annotated[
    str | None,
    typer.Option("--speed", metavar="SPEED", help="Speed of the inner ring, such as '1797 rpm'."),
]
OuterSpeedOption = Annotated[
    str | None,
    typer.Option("--outer-speed", metavar="SPEED", help="Speed of the outer ring, with its sign."),
]
LagOption = Annotated[
    float,
    typer.Option(
        "--slip",
        metavar="FRACTION",
        help="Fraction by which the cage lags, such as 0.01; from -1 to 1.",
    ),
]
