"""The command that draws: a state's JSON or a study's file, as PNG, SVG or PDF."""

from __future__ import annotations

import os
from typing import Annotated

import typer

from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    plain_endings,
)
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import LanguageOption, VariantsOption
from rolamento.cli.outputs import check_outputs
from rolamento.cli.streams import STANDARD_STREAM, complain, print_text
from rolamento.cli.waiting import waiting
from rolamento.tasks.drawing import Kind, draw
from rolamento.words import marked, said

app = typer.Typer()


@app.command(
    cls=JsonCommand,
    epilog="Examples: plot state.json --kind ellipses -o ellipses.pdf;"
    " plot sweep.nc --variable stiffness_zz.",
)
def plot(
    results: Annotated[
        list[str],
        typer.Argument(
            metavar="RESULT...",
            help="What to draw: the JSON of a state (solve --json), - for standard input, or the "
            "NetCDF file of a study; several of one or the other share a figure.",
        ),
    ],
    kind: Annotated[
        Kind | None,
        typer.Option(
            metavar="KIND",
            help="For a state: rosette (default), balls, angles, pressures, "
            "ellipses; with rollers: along (pressure along them), between (the most loaded "
            "one between the races); for its life: aiso (a_ISO), sn (life over load), zone "
            "(life over the load zone), helps (what would help); for a study: "
            "lines, map, histogram, scatter (default: what suits it).",
        ),
    ] = None,
    variable: Annotated[
        str | None, typer.Option(metavar="NAME", help="Output of a study to draw.")
    ] = None,
    over: Annotated[
        str | None,
        typer.Option(metavar="NAME", help="Input of a study along the horizontal axis."),
    ] = None,
    label: Annotated[
        list[str] | None,
        typer.Option(
            "--label",
            metavar="TEXT",
            help="What the legend calls a file; once for each. By default titles or names.",
        ),
    ] = None,
    variants: VariantsOption = None,
    output: Annotated[
        str | None,
        typer.Option(
            "--output",
            "-o",
            metavar="FILE",
            help="File to write: .png, .svg or .pdf; by default RESULT's name with "
            ".png, in this folder.",
        ),
    ] = None,
    lang: LanguageOption = None,
) -> None:
    """Draw a state, its life or a study; several share a figure.

    Loads, angles, pressures, ellipses, rollers, life, sweeps, distributions.
    """
    with plain_endings(lang):
        from rolamento.case.variant import read_variants
        from rolamento.charts.texts import no_result
        from rolamento.plots.saving import check_name, save_figure

        target = _default_name(results[0]) if output is None else output
        check_name(target)
        check_outputs(
            {"--output": target}, *results, rule=marked("is the result itself; choose another name")
        )
        with waiting(lang):
            drawing = draw(
                results,
                kind,
                variable=variable,
                over=over,
                labels=label or (),
                variants=read_variants(variants or ()),
            )
        save_figure(drawing.figure, target)
        print_text(said("Wrote {path}", path=target) + "\n")
        if drawing.failure is not None:
            complain(no_result(drawing.failure))
    raise typer.Exit(SOLVED if drawing.failure is None else NO_RESULT)


def _default_name(result: str) -> str:
    if result == STANDARD_STREAM:
        return "state.png"
    name = os.path.splitext(os.path.basename(result))[0].strip(".")
    return f"{name or 'figure'}.png"
