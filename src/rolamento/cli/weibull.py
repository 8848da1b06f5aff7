"""`rolamento weibull`: what a life test says, with bounds, pictures and JSON."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Annotated, ClassVar, Final

import typer

from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    Language,
    plain_endings,
    words_of,
)
from rolamento.cli.grouped_help import GroupedCommand, Groups
from rolamento.cli.options import LanguageOption, SeedOption, json_option, plot_option
from rolamento.cli.outputs import check_outputs
from rolamento.cli.shipped_data import data_and_json, known_example
from rolamento.cli.streams import STANDARD_STREAM, complain, print_text, put
from rolamento.cli.table_options import (
    DecimalMarkOption,
    StatusColumnOption,
    TimeColumnOption,
)
from rolamento.cli.weibull_options import (
    EXAMPLES,
    life_test,
    only_groups,
    wanted,
)
from rolamento.errors import InputError

if TYPE_CHECKING:
    from rolamento.report.language import Words
    from rolamento.weibull.summary import LifeTestSummary

__all__ = ["WeibullCommand", "weibull"]

_CONFIDENCE: Final = 0.9
_SAMPLES, _FEWEST_SAMPLES = 10_000, 1000
_MOST_DRAWN: Final = 5_000_000
"""Bearings in all drawn tests together, if it is left to the program."""


class WeibullCommand(GroupedCommand):
    """`rolamento weibull`, its help in groups."""

    groups: ClassVar[Groups] = {
        "Data": (
            *("example", "write", "unit", "time_column", "status_column", "decimal_mark"),
            *("group", "by_group", "only"),
        ),
        "Fit": ("method", "three_parameter", "shape", "bayes"),
        "Bounds": ("bounds", "confidence", "sides", "samples", "seed"),
        "Wanted": ("reliability", "time", "calculated_life"),
        "Output": ("plot", "contour", "contour_of", "json", "lang", "help"),
    }


def weibull(
    data: Annotated[
        str | None,
        typer.Argument(
            metavar="DATA.csv",
            help="Life test: columns time, status, and group, rig, count and more if there are;"
            " - is standard input.",
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
            help="Of fitting: ml, unbiased, rrx, rry, three-parameter. Repeats; by default the"
            " first four.",
        ),
    ] = None,
    three_parameter: Annotated[
        bool, typer.Option("--three-parameter", help="Fit a time free of failures as well.")
    ] = False,
    shape: Annotated[
        float | None,
        typer.Option(
            "--shape", metavar="BETA", help="From experience: only the scale is fitted (Weibayes)."
        ),
    ] = None,
    bayes: Annotated[
        str | None,
        typer.Option(
            "--bayes",
            metavar="LOW..HIGH",
            help="What the shape lies between with 90 %: gives a posterior as well.",
        ),
    ] = None,
    bounds: Annotated[
        str | None,
        typer.Option(
            "--bounds",
            metavar="METHOD",
            help="pivotal, calibrated-likelihood-ratio, likelihood-ratio, fisher, bootstrap-bca,"
            " …; by default what keeps its promise with few failures.",
        ),
    ] = None,
    confidence: Annotated[
        float, typer.Option("--confidence", metavar="C", help="Of the bounds, such as 0.9.")
    ] = _CONFIDENCE,
    sides: Annotated[
        str, typer.Option("--sides", metavar="SIDES", help="Of the bounds: two, lower or upper.")
    ] = "two",
    reliability: Annotated[
        list[float] | None,
        typer.Option(
            "--reliability",
            metavar="R",
            help="That lives are wanted for, 0.9 for L10. Repeats; by default 0.9 and 0.5.",
        ),
    ] = None,
    time: Annotated[
        list[str] | None,
        typer.Option(
            "--time", metavar="TIME", help="That reliabilities are wanted for: '100 h'. Repeats."
        ),
    ] = None,
    calculated_life: Annotated[
        list[str] | None,
        typer.Option(
            "--calculated-life",
            metavar="[NAME=]LIFE",
            help="Set it against the data: 'ISO 281=58 h', for the first reliability. Repeats.",
        ),
    ] = None,
    group: Annotated[
        str | None,
        typer.Option("--group", metavar="COLUMN", help="Column of the groups, if another."),
    ] = None,
    by_group: Annotated[
        bool,
        typer.Option(
            "--by-group/--pooled", help="Each group by itself, and compared; or all together."
        ),
    ] = True,
    only: Annotated[
        list[str] | None,
        typer.Option("--only", metavar="GROUP", help="Leave the other groups out. Repeats."),
    ] = None,
    unit: Annotated[
        str | None,
        typer.Option("--unit", metavar="UNIT", help="Of the times, if the file says another."),
    ] = None,
    time_column: TimeColumnOption = None,
    status_column: StatusColumnOption = None,
    decimal_mark: DecimalMarkOption = None,
    samples: Annotated[
        int | None,
        typer.Option(
            "--samples",
            metavar="N",
            help="Tests to draw, 100 to a million; 10 000 by default, fewer of large tests.",
        ),
    ] = None,
    seed: SeedOption = 0,
    plot: Annotated[str | None, plot_option("Draw probability paper")] = None,
    contour: Annotated[
        str | None,
        typer.Option(
            "--contour", metavar="FILE", help="Draw the regions of equal likelihood, likewise."
        ),
    ] = None,
    contour_of: Annotated[
        str,
        typer.Option("--contour-of", metavar="LIFE", help="Over the shape: L10, L1, scale …"),
    ] = "L10",
    json: Annotated[
        str | None, json_option("Write everything as JSON, in the unit of the data")
    ] = None,
    lang: LanguageOption = None,
) -> None:
    """Fit a life test by Weibull's distribution, with bounds.

    Says what the test tells and what not.
    """
    with plain_endings(lang):
        data, json = data_and_json(data, example, json)
        outputs = {"--json": json, "--plot": plot, "--contour": contour}
        check_outputs(outputs, data, rule="is the file of the data itself")
        if write is not None:
            print_text(_written(data, example, write, words_of(lang)))
            return
        test = life_test(
            data,
            example,
            group=group,
            unit=unit,
            time=time_column,
            status=status_column,
            decimal_mark=decimal_mark,
        )
        test = only_groups(test, only or ())
        asked = wanted(
            test.unit,
            methods=method or (),
            three_parameter=three_parameter,
            bounds=bounds,
            shape=shape,
            bayes=bayes,
            confidence=confidence,
            sides=sides,
            reliabilities=reliability or (),
            times=time or (),
            calculated=calculated_life or (),
            samples=_enough(test.size) if samples is None else samples,
            seed=seed,
        )
        from rolamento.cli.waiting import progress_of
        from rolamento.report.weibull_words import WEIBULL_WORDS
        from rolamento.weibull.summary import summarise

        words = words_of(lang)
        with progress_of(WEIBULL_WORDS[words.code].working) as progress:
            found = summarise(test, asked, by_group=by_group, progress=progress)
            if plot is not None:
                _draw_paper(found, plot, words.code)
            if contour is not None:
                _draw_contour(found, contour, contour_of, words.code)
        _show(found, json, lang)
    raise typer.Exit(SOLVED if found.has_result else NO_RESULT)


def _enough(size: int) -> int:
    """How many tests to draw: those of many bearings take long, and few of them do."""
    return max(min(_SAMPLES, _MOST_DRAWN // size), _FEWEST_SAMPLES)


def _written(data: str | None, example: str | None, path: str, words: Words) -> str:
    """Write an example's CSV under a new name, and return what to say about it."""
    from rolamento._writing import write_text
    from rolamento.report.weibull_words import WEIBULL_WORDS
    from rolamento.weibull import published_text

    if example is None or data is not None:
        raise InputError("goes with --example alone", source="--write", value=path)
    text = published_text(known_example(example, EXAMPLES).replace("-", "_"))
    write_text(text, path, new=True)
    return WEIBULL_WORDS[words.code].written.format(path=path) + "\n"


def _draw_paper(found: LifeTestSummary, path: str, language: str) -> None:
    from rolamento.plots.saving import save_figure
    from rolamento.plots.weibull import weibull_figure
    from rolamento.weibull.band import confidence_band

    asked = found.wanted
    bands = {
        group.name: confidence_band(
            group.test,
            method=asked.bounds,
            confidence=asked.confidence,
            samples=asked.samples,
            seed=asked.seed,
            shape=asked.shape,
        )
        for group in found.groups
        if group.bounded
    }
    save_figure(weibull_figure(found, bands, language), path)


def _draw_contour(found: LifeTestSummary, path: str, quantity: str, language: str) -> None:
    from rolamento.plots.saving import save_figure
    from rolamento.plots.weibull_contour import contour_figure
    from rolamento.weibull.likelihood_region import likelihood_region

    asked = found.wanted
    try:
        regions = {
            group.name: likelihood_region(
                group.test, quantity, samples=asked.samples, seed=asked.seed
            )
            for group in found.groups
        }
    except InputError as error:
        raise error.with_details(source="--contour-of") from None
    save_figure(contour_figure(found, regions, language), path)


def _show(found: LifeTestSummary, json: str | None, lang: Language | None) -> None:
    """Write what was asked for; standard output takes data or the report, not both."""
    from rolamento.report.weibull import weibull_json, weibull_report

    words = words_of(lang)
    if json is not None:
        put(weibull_json(found) + "\n", json)
    if json != STANDARD_STREAM:
        from rolamento.report.medium import Medium

        print_text(weibull_report(found, words, Medium.of(sys.stdout)))
    elif not found.has_result:
        from rolamento.report.weibull_sentences import said_advice

        complain(said_advice(found.groups[0].main.code, words.code))
