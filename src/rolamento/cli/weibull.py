"""`rolamento weibull`: what a life test says, with bounds, pictures and JSON."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final

import typer

from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    plain_endings,
)
from rolamento.cli.grouped_help import Groups
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import LanguageOption, SeedOption, json_option, plot_option
from rolamento.cli.outputs import NOWHERE, OUTPUT_OPTIONS, Outputs, with_outputs
from rolamento.cli.shipped_data import check_one_given, data_and_json, known_example
from rolamento.cli.streams import STANDARD_STREAM, complain, print_text, put_json
from rolamento.cli.table_options import (
    ALL_COLUMNS,
    COLUMN_OPTIONS,
    LifeColumns,
    told_in_options,
    with_life_columns,
)
from rolamento.errors import InputError
from rolamento.tasks.inputs import LIFE_TEST, by_name
from rolamento.words import marked, said

if TYPE_CHECKING:
    from rolamento.weibull import LifeTestSummary

__all__ = ["WeibullCommand", "app", "weibull"]

_ASKED: Final = by_name(LIFE_TEST)
EXAMPLES: Final = ("campanha-2008", "lieblein-zelen-1956")
_CONFIDENCE: Final = 0.9
_MAXIMUM_NUMBERS: Final = 50
_OPTIONS: Final = {
    "method": "--method", "bounds": "--bounds", "prior": "--bayes", "times": "--time",
    "calculated": "--calculated-life", "only": "--only", "only_mode": "--mode",
}  # fmt: skip
"""What the task calls otherwise, or does not find in the file."""


class WeibullCommand(JsonCommand):
    """`rolamento weibull`, its help in groups."""

    groups: ClassVar[Groups] = {
        "Data": (
            *("example", "write", *COLUMN_OPTIONS),
            *("group", "by_group", "only", "mode", "by_mode"),
        ),
        "Fit": ("method", "three_parameter", "shape", "bayes", "models"),
        "Bounds": ("bounds", "confidence", "sides", "samples", "seed"),
        "Results": ("reliability", "time", "calculated_life"),
        "Output": ("plot", "contour", "contour_of", "json", *OUTPUT_OPTIONS, "lang", "help"),
    }


app = typer.Typer()


@app.command(
    cls=WeibullCommand,
    epilog="Examples: weibull tests.csv --plot paper.png; weibull tests.csv --shape 1.5;"
    " weibull --example campanha-2008 --calculated-life 'ISO 281=58 h'.",
)
@with_outputs
@with_life_columns
def weibull(
    data: Annotated[
        str | None,
        typer.Argument(
            metavar="DATA.csv",
            help="Life test: columns time, status and, if any, group, rig, count "
            "and more; - for standard input.",
        ),
    ] = None,
    example: Annotated[
        str | None,
        typer.Option(
            "--example", metavar="NAME", help=f"A shipped life test: {' or '.join(EXAMPLES)}."
        ),
    ] = None,
    write: Annotated[
        str | None,
        typer.Option("--write", metavar="FILE", help="Write the example as CSV instead."),
    ] = None,
    method: Annotated[
        list[str] | None,
        typer.Option(
            "--method",
            metavar="METHOD",
            help="Fitting method: ml, unbiased, rrx, rry, three-parameter. "
            "Repeatable; by default the first four.",
        ),
    ] = None,
    three_parameter: Annotated[
        bool, typer.Option("--three-parameter", help="Fit a failure-free time as well.")
    ] = False,
    shape: Annotated[
        float | None,
        typer.Option(
            "--shape",
            metavar="BETA",
            help=_ASKED["shape"].meaning,
        ),
    ] = None,
    bayes: Annotated[
        str | None,
        typer.Option(
            "--bayes",
            metavar="LOW..HIGH",
            help=_ASKED["prior"].meaning,
        ),
    ] = None,
    models: Annotated[
        bool | None,
        typer.Option("--models/--no-models", help=_ASKED["models"].meaning),
    ] = None,
    bounds: Annotated[
        str | None,
        typer.Option(
            "--bounds",
            metavar="METHOD",
            help="Bounds: pivotal, calibrated-likelihood-ratio, likelihood-ratio, "
            "fisher, bootstrap-bca, …; by default a method that is exact with "
            "few failures.",
        ),
    ] = None,
    confidence: Annotated[
        float,
        typer.Option("--confidence", metavar="C", help=_ASKED["confidence"].meaning),
    ] = _CONFIDENCE,
    sides: Annotated[
        str,
        typer.Option("--sides", metavar="SIDES", help=_ASKED["sides"].meaning),
    ] = "two",
    reliability: Annotated[
        list[float] | None,
        typer.Option(
            "--reliability",
            metavar="R",
            help=_ASKED["reliabilities"].meaning,
        ),
    ] = None,
    time: Annotated[
        list[str] | None,
        typer.Option(
            "--time",
            metavar="TIME",
            help=_ASKED["times"].meaning,
        ),
    ] = None,
    calculated_life: Annotated[
        list[str] | None,
        typer.Option(
            "--calculated-life",
            metavar="[NAME=]LIFE",
            help=_ASKED["calculated"].meaning,
        ),
    ] = None,
    group: Annotated[
        str | None,
        typer.Option("--group", metavar="COLUMN", help=_ASKED["group"].meaning),
    ] = None,
    by_group: Annotated[
        bool,
        typer.Option("--by-group/--pooled", help=_ASKED["by_group"].meaning),
    ] = True,
    only: Annotated[
        list[str] | None,
        typer.Option("--only", metavar="GROUP", help=_ASKED["only"].meaning),
    ] = None,
    mode: Annotated[
        str | None,
        typer.Option("--mode", metavar="MODE", help=_ASKED["only_mode"].meaning),
    ] = None,
    by_mode: Annotated[
        bool,
        typer.Option("--by-mode/--modes-pooled", help=_ASKED["by_mode"].meaning),
    ] = True,
    columns: LifeColumns = ALL_COLUMNS,
    samples: Annotated[
        int | None,
        typer.Option(
            "--samples",
            metavar="N",
            help="Tests to simulate, 100 to a million; 10 000 by default, fewer for large tests.",
        ),
    ] = None,
    seed: SeedOption = 0,
    plot: Annotated[str | None, plot_option("Draw probability paper")] = None,
    contour: Annotated[
        str | None,
        typer.Option("--contour", metavar="FILE", help="Draw the likelihood contours, likewise."),
    ] = None,
    contour_of: Annotated[
        str,
        typer.Option(
            "--contour-of",
            metavar="LIFE",
            help="Quantity of the contours, over the shape: L10, L1, scale …",
        ),
    ] = "L10",
    json: Annotated[
        str | None, json_option("Write everything as JSON, in the unit of the data")
    ] = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Fit a Weibull distribution to a life test, with bounds.

    What the test shows, and what it does not.
    """
    with plain_endings(lang):
        data, json = data_and_json(data, example, json)
        outputs.check(
            {"--json": json, "--plot": plot, "--contour": contour},
            data,
            rule=marked("is the data file itself; choose another name"),
        )
        if write is not None:
            print_text(_write_example(data, example, write))
            return
        check_one_given(data, example, "weibull", EXAMPLES)
        read = {"group": group, **columns.arguments()}
        from rolamento.tasks.weibull import (
            bounds_named,
            fits_named,
            life_test_study,
            lives_named,
            prior_of,
        )

        with told_in_options(**_OPTIONS):
            wanted: dict[str, Any] = {
                "methods": fits_named(method or (), three_parameter=three_parameter),
                "bounds": None if bounds is None else bounds_named(bounds),
                "prior": None if bayes is None else prior_of(bayes),
                "reliabilities": tuple(dict.fromkeys(reliability or (0.9, 0.5))),
                "models": models, "shape": shape, "confidence": confidence, "sides": sides,
                "seed": seed,
            }  # fmt: skip
            calculated = lives_named(calculated_life or ())
        if bounds is not None and shape is not None:
            rule = said("cannot be combined with --shape, which has its own bounds")
            raise InputError(rule, source="--bounds", value=bounds)
        for option, many in (("--reliability", reliability), ("--time", time)):
            if len(many or ()) > _MAXIMUM_NUMBERS:
                raise InputError(
                    said("may be given at most {most} times", most=_MAXIMUM_NUMBERS),
                    source=option,
                )
        from rolamento.cli.waiting import progress_of
        from rolamento.weibull import bands_of, published_life_test, regions_of

        with progress_of(said("Simulating tests and fitting them …")) as progress:
            with told_in_options(**_OPTIONS):
                given: Any = data
                if example is not None:
                    given = published_life_test(_published_name(example), **read)
                found = life_test_study(
                    given,
                    only=only or (),
                    only_mode=mode,
                    by_group=by_group,
                    by_mode=by_mode,
                    times=time or (),
                    calculated=calculated,
                    samples=samples,
                    columns=read,
                    progress=progress,
                    **wanted,
                )
            if plot is not None:
                from rolamento.plots.saving import save_figure
                from rolamento.plots.weibull import weibull_figure

                save_figure(weibull_figure(found, bands_of(found)), plot)
            if contour is not None:
                from rolamento.plots.saving import save_figure
                from rolamento.plots.weibull import contour_figure

                with told_in_options(quantity="--contour-of"):
                    regions = regions_of(found, contour_of)
                save_figure(contour_figure(found, regions), contour)
        _show(found, json, outputs)
    raise typer.Exit(SOLVED if found.has_result else NO_RESULT)


def _published_name(example: str) -> str:
    return known_example(example, EXAMPLES).replace("-", "_")


def _write_example(data: str | None, example: str | None, path: str) -> str:
    """Write an example's CSV under a new name, and return what to say about it."""
    from rolamento.io.writing import write_text
    from rolamento.weibull import published_text

    if example is None or data is not None:
        raise InputError(said("goes with --example alone"), source="--write", value=path)
    write_text(published_text(_published_name(example)), path, new=True)
    return said("Wrote {path}", path=path) + "\n"


def _show(found: LifeTestSummary, json: str | None, outputs: Outputs) -> None:
    """Write what was asked for; standard output takes data or the page, not both."""
    if json is not None:
        put_json(found.to_mapping(), json)
    from rolamento.pages.weibull import weibull_page

    outputs.show(lambda: weibull_page(found), json)
    if STANDARD_STREAM in (json, outputs.csv) and not found.has_result:
        complain(str(found.groups[0].main.advice))
