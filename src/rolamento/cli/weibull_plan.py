"""`rolamento weibull-plan`: how many bearings, how long, how many failures."""

from __future__ import annotations

from typing import Annotated, Final

import typer

from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    plain_endings,
)
from rolamento.cli.grouped_help import GroupedCommands
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import LanguageOption, PlotOption, SeedOption, json_option
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.requested import add_command
from rolamento.cli.streams import STANDARD_STREAM, complain, put_json
from rolamento.cli.table_options import told_in_options
from rolamento.errors import InputError
from rolamento.tasks.weibull import DemonstrationTest
from rolamento.words import said

__all__ = ["app"]

_ASKED: Final = DemonstrationTest.meanings()
_SHAPE: Final = 1.5
_MAXIMUM_SIZES: Final = 20

app = typer.Typer(
    cls=GroupedCommands,
    no_args_is_help=True,
    rich_markup_mode=None,
)

LifeOption = Annotated[
    str | None,
    typer.Option("--life", metavar="LIFE", help="Expected life, such as '1000 h'."),
]
ShapeOption = Annotated[
    float,
    typer.Option("--shape", metavar="BETA", help=_ASKED["shape"]),
]
ReliabilityOption = Annotated[
    float, typer.Option("--reliability", metavar="R", help=_ASKED["reliability"])
]
ConfidenceOption = Annotated[
    float, typer.Option("--confidence", metavar="C", help=_ASKED["confidence"])
]
JsonOption = Annotated[str | None, json_option("Write everything as JSON, in the unit of the life")]


@app.callback()
def weibull_plan(lang: LanguageOption = None) -> None:
    """Plan a life test: bearings, time, failures.

    Bearings and time to demonstrate a life, or failures to estimate one.
    """


add_command(app, DemonstrationTest, "demonstration")


@app.command(
    cls=JsonCommand,
    epilog="Examples: weibull-plan precision --ratio 5 --life '1000 h';"
    " weibull-plan precision --failures 6 --groups 6 --group-size 4.",
)
@with_outputs
def precision(
    ratio: Annotated[
        float | None,
        typer.Option(
            "--ratio", metavar="RATIO", help="Required ratio of upper to lower bound, such as 5."
        ),
    ] = None,
    failures: Annotated[
        int | None,
        typer.Option(
            "--failures",
            metavar="R",
            help="Failures of a given test, instead: which precision it gives.",
        ),
    ] = None,
    groups: Annotated[
        int | None,
        typer.Option(
            "--groups", metavar="G", help="Bearings of that test, or rigs with several each."
        ),
    ] = None,
    group_size: Annotated[
        list[int] | None,
        typer.Option(
            "--group-size", metavar="M", help="Bearings per rig of a sudden-death test. Repeatable."
        ),
    ] = None,
    life: LifeOption = None,
    shape: ShapeOption = _SHAPE,
    reliability: ReliabilityOption = 0.9,
    confidence: ConfidenceOption = 0.9,
    samples: Annotated[
        int, typer.Option("--samples", metavar="N", help="Tests to simulate, 100 to a million.")
    ] = 10_000,
    seed: SeedOption = 0,
    plot: PlotOption = None,
    json: JsonOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Plan the precision of an estimated life.

    How many failures narrow the bounds, and how long that takes.
    """
    with plain_endings(lang):
        outputs.check({"--json": json, "--plot": plot})
        sizes = group_size or []
        if (ratio is None) == (failures is None):
            raise InputError(
                said("give --ratio or --failures"), source="precision", example="--ratio 5"
            )
        if ratio is not None and groups is not None and len(sizes) > 1:
            raise InputError(
                said("goes with a single --group-size"), source="--groups", value=groups
            )
        if len(sizes) > _MAXIMUM_SIZES:
            rule = said("may be given at most {most} times", most=_MAXIMUM_SIZES)
            raise InputError(rule, source="--group-size")
        from rolamento.cli.waiting import progress_of
        from rolamento.pages.weibull_plan import precision_page
        from rolamento.tasks.weibull import precision_study

        with (
            progress_of(said("Simulating tests …")) as progress,
            told_in_options(life="--life"),
        ):
            found = precision_study(
                ratio,
                failures=failures,
                groups=groups,
                group_sizes=sizes,
                life=life,
                shape=shape,
                reliability=reliability,
                confidence=confidence,
                samples=samples,
                seed=seed,
                progress=progress,
            )
        if json is not None:
            put_json(found.to_mapping(), json)
        if plot is not None:
            from rolamento.plots.saving import save_figure
            from rolamento.plots.weibull_plan import cost_figure

            save_figure(cost_figure(found.plans, found.time_label), plot)
        outputs.show(lambda: precision_page(found), json)
        if STANDARD_STREAM in (json, outputs.csv) and not found.planned:
            complain(str(found.plans[0].advice))
    raise typer.Exit(SOLVED if found.planned else NO_RESULT)
