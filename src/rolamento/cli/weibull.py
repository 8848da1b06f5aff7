"""`rolamento weibull`: what a life test says, with bounds, pictures and JSON."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final, cast

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
    CountColumnOption,
    DecimalMarkOption,
    StatusColumnOption,
    TimeColumnOption,
    told_in_options,
)
from rolamento.errors import InputError
from rolamento.words import marked, said

if TYPE_CHECKING:
    from rolamento.weibull import FitMethod, LifeTestSummary, Method, ShapePrior

__all__ = ["WeibullCommand", "weibull"]

EXAMPLES: Final = ("campanha-2008", "lieblein-zelen-1956")
FITS: Final[dict[str, FitMethod]] = {
    "ml": "maximum_likelihood",
    "unbiased": "unbiased",
    "rrx": "rank_regression_x_on_y",
    "rry": "rank_regression_y_on_x",
    "three-parameter": "three_parameter",
}
_CONFIDENCE: Final = 0.9
_MAXIMUM_NUMBERS: Final = 50
_MAXIMUM_CALCULATED: Final = 8
_PRIOR: Final = re.compile(r"(?:(lognormal|uniform):)?([^:]{1,30})\.\.([^:]{1,30})")


class WeibullCommand(JsonCommand):
    """`rolamento weibull`, its help in groups."""

    groups: ClassVar[Groups] = {
        "Data": (
            *("example", "write", "unit", "time_column", "status_column", "count_column"),
            "decimal_mark",
            *("group", "by_group", "only"),
        ),
        "Fit": ("method", "three_parameter", "shape", "bayes"),
        "Bounds": ("bounds", "confidence", "sides", "samples", "seed"),
        "Results": ("reliability", "time", "calculated_life"),
        "Output": ("plot", "contour", "contour_of", "json", *OUTPUT_OPTIONS, "lang", "help"),
    }


@with_outputs
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
            help="Shape from experience: only the scale is fitted (Weibayes).",
        ),
    ] = None,
    bayes: Annotated[
        str | None,
        typer.Option(
            "--bayes",
            metavar="LOW..HIGH",
            help="90 % range of the shape: gives a posterior as well.",
        ),
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
        typer.Option("--confidence", metavar="C", help="Confidence of the bounds, such as 0.9."),
    ] = _CONFIDENCE,
    sides: Annotated[
        str,
        typer.Option("--sides", metavar="SIDES", help="Sides of the bounds: two, lower or upper."),
    ] = "two",
    reliability: Annotated[
        list[float] | None,
        typer.Option(
            "--reliability",
            metavar="R",
            help="Reliability to give lives for, 0.9 for L10. Repeatable; by default 0.9 and 0.5.",
        ),
    ] = None,
    time: Annotated[
        list[str] | None,
        typer.Option(
            "--time",
            metavar="TIME",
            help="Time to give the reliability at, such as '100 h'. Repeatable.",
        ),
    ] = None,
    calculated_life: Annotated[
        list[str] | None,
        typer.Option(
            "--calculated-life",
            metavar="[NAME=]LIFE",
            help="Calculated life to compare with the data, such as 'ISO 281=58 h', "
            "for the first reliability. Repeatable.",
        ),
    ] = None,
    group: Annotated[
        str | None,
        typer.Option("--group", metavar="COLUMN", help="Column of the groups, if named otherwise."),
    ] = None,
    by_group: Annotated[
        bool,
        typer.Option(
            "--by-group/--pooled", help="Each group by itself, and compared; or all together."
        ),
    ] = True,
    only: Annotated[
        list[str] | None,
        typer.Option("--only", metavar="GROUP", help="Only this group. Repeatable."),
    ] = None,
    unit: Annotated[
        str | None,
        typer.Option("--unit", metavar="UNIT", help="Unit of the times, if the file says another."),
    ] = None,
    time_column: TimeColumnOption = None,
    status_column: StatusColumnOption = None,
    count_column: CountColumnOption = None,
    decimal_mark: DecimalMarkOption = None,
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
        columns = {
            "group": group, "unit": unit, "time": time_column, "status": status_column,
            "count": count_column, "decimal_mark": decimal_mark,
        }  # fmt: skip
        wanted: dict[str, Any] = {
            "methods": _fit_methods(method or (), three_parameter),
            "bounds": _bounds_method(bounds, shape),
            "prior": None if bayes is None else _prior_of(bayes),
            "reliabilities": tuple(dict.fromkeys(reliability or (0.9, 0.5))),
            "shape": shape, "confidence": confidence, "sides": sides, "seed": seed,
        }  # fmt: skip
        calculated = _named_lives(calculated_life or ())
        for option, many in (("--reliability", reliability), ("--time", time)):
            if len(many or ()) > _MAXIMUM_NUMBERS:
                raise InputError(
                    said("may be given at most {most} times", most=_MAXIMUM_NUMBERS),
                    source=option,
                )
        from rolamento.cli.waiting import progress_of
        from rolamento.tasks.weibull import life_test_study
        from rolamento.weibull import bands_of, published_life_test, regions_of

        with progress_of(said("Simulating tests and fitting them …")) as progress:
            with told_in_options(times="--time", calculated="--calculated-life", only="--only"):
                given: Any = data
                if example is not None:
                    given = published_life_test(_published_name(example), **columns)
                found = life_test_study(
                    given,
                    only=only or (),
                    by_group=by_group,
                    times=time or (),
                    calculated=calculated,
                    samples=samples,
                    columns=columns,
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
    from rolamento._writing import write_text
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


# --- what the options say --------------------------------------------------------------------


def _fit_methods(names: Sequence[str], three_parameter: bool) -> tuple[FitMethod, ...]:
    for name in names:
        if name not in FITS:
            raise InputError(
                said("must be one of {known}", known=", ".join(FITS)),
                source="--method",
                value=name,
                example="ml",
            )
    chosen = [*(names or ("ml", "unbiased", "rrx", "rry"))]
    chosen += ["three-parameter"] if three_parameter else []
    return tuple(dict.fromkeys(FITS[name] for name in chosen))


def _bounds_method(name: str | None, shape: float | None) -> Method | None:
    if name is None:
        return None
    from rolamento.weibull import METHODS

    known = [method.replace("_", "-") for method in METHODS if method != "fixed_shape"]
    word = name.replace("_", "-")
    if word not in known:
        raise InputError(
            said("must be one of {known}", known=", ".join(known)),
            source="--bounds",
            value=name,
            example=known[0],
        )
    if shape is not None:
        rule = said("cannot be combined with --shape, which has its own bounds")
        raise InputError(rule, source="--bounds", value=name)
    return cast("Method", word.replace("-", "_"))


def _prior_of(text: str) -> ShapePrior:
    from rolamento.weibull import ShapePrior

    match = _PRIOR.fullmatch(text.strip())
    try:
        low, high = (float(match[2]), float(match[3])) if match else (0.0, 0.0)
    except ValueError:
        match = None
    if match is None:
        raise InputError(
            said("must be LOW..HIGH, the 90 % range of the shape, or uniform:LOW..HIGH"),
            source="--bayes",
            value=text,
            example="1..2.5",
        )
    try:
        return ShapePrior(low, high, kind="uniform" if match[1] == "uniform" else "lognormal")
    except InputError as error:
        raise error.with_details(source="--bayes") from None


def _named_lives(texts: Sequence[str]) -> dict[str, str]:
    """Calculated lives by their names; those without one are called by what was written."""
    if len(texts) > _MAXIMUM_CALCULATED:
        rule = said("may be given at most {most} times", most=_MAXIMUM_CALCULATED)
        raise InputError(rule, source="--calculated-life")
    lives: dict[str, str] = {}
    for text in texts:
        name, _, life = text.rpartition("=")
        name = name.strip() or text.strip()
        if name in lives:
            raise InputError(
                said("gives two lives of the same name"), source="--calculated-life", value=text
            )
        lives[name] = life
    return lives
