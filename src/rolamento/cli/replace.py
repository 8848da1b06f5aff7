"""`rolamento replace`: keep a bearing or replace it, by a Weibull distribution of lives."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import fields
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final

import typer

from rolamento.cli.common import NO_RESULT, SOLVED, plain_endings
from rolamento.cli.grouped_help import GroupedCommands, Groups
from rolamento.cli.option_names import in_options
from rolamento.cli.option_records import with_record
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import LanguageOption, PlotOption, SeedOption, json_option
from rolamento.cli.outputs import NOWHERE, OUTPUT_OPTIONS, Outputs, with_outputs
from rolamento.cli.shipped_data import data_and_json, known_example
from rolamento.cli.streams import STANDARD_STREAM, complain, put_json
from rolamento.cli.table_options import (
    ALL_COLUMNS,
    COLUMN_OPTIONS,
    LifeColumns,
    told_in_options,
    with_life_columns,
)
from rolamento.errors import InputError
from rolamento.records import frozen
from rolamento.tasks.life_tables import SHIPPED
from rolamento.words import marked, said

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from rolamento.document import Document
    from rolamento.tasks.replace import FleetStudy, RemainingStudy, ReplacementStudy

__all__ = ["app"]


@frozen
class LivesOptions:
    """What options say of a distribution of lives: from a table, or given."""

    example: Annotated[
        str | None,
        typer.Option("--example", metavar="NAME", help=f"Shipped lives: {' or '.join(SHIPPED)}."),
    ] = None
    only: Annotated[
        list[str] | None,
        typer.Option("--only", metavar="GROUP", help="Only this group of the data. Repeatable."),
    ] = None
    shape: Annotated[
        float | None,
        typer.Option(
            "--shape",
            metavar="BETA",
            help="Shape from experience, such as 1.5; with data, only the scale is fitted.",
        ),
    ] = None
    scale: Annotated[
        str | None,
        typer.Option("--scale", metavar="LIFE", help="Scale η without data, such as '30000 h'."),
    ] = None
    l10: Annotated[
        str | None,
        typer.Option("--l10", metavar="LIFE", help="L10 without data, such as '20000 h', instead."),
    ] = None
    mode: Annotated[
        str | None,
        typer.Option(
            "--mode",
            metavar="MODE",
            help="Only this failure mode of the data, failures by others as suspensions; all for"
            " all failures alike.",
        ),
    ] = None
    samples: Annotated[
        int | None,
        typer.Option(
            "--samples",
            metavar="N",
            help="Tests to simulate, 100 to a million; 10 000 by default, fewer for large tests.",
        ),
    ] = None
    seed: SeedOption = 0


app = typer.Typer(
    cls=GroupedCommands,
    no_args_is_help=True,
    rich_markup_mode=None,
)


class ReplaceCommand(JsonCommand):
    """A command of `rolamento replace`, its help in groups."""

    groups: ClassVar[Groups] = {
        "Decision": (
            *("age", "mission", "planned_cost", "failure_cost", "currency"),
            *("fleet", "within", "until", "begin", "usage", "usage_column", "renewed"),
            "confidence",
        ),
        "Lives": (*(one.name for one in fields(LivesOptions)), *COLUMN_OPTIONS),
        "Output": ("plot", "json", *OUTPUT_OPTIONS, "lang", "help"),
    }

    def headings(self) -> Groups:
        """Return its groups, without what other commands of the kind have."""
        names = {"help", *(str(parameter.name) for parameter in self.params)}
        return {
            heading: tuple(name for name in group if name in names)
            for heading, group in self.groups.items()
        }


DataArgument = Annotated[
    str | None,
    typer.Argument(
        metavar="DATA.csv",
        help="Lives: columns time and status, of failed bearings and of those in service; - for"
        " standard input. Without it --shape, and --scale or --l10.",
    ),
]
ConfidenceOption = Annotated[
    float, typer.Option("--confidence", metavar="C", help="Confidence of the intervals.")
]
JsonOption = Annotated[str | None, json_option("Write everything as JSON, in the unit of the data")]


NOTHING_OF_LIVES: Final = LivesOptions()
with_lives = with_record("of_lives", LivesOptions)
"""Give a command the options of `LivesOptions`, which it takes as one argument, ``of_lives``."""


@app.callback()
def replace(lang: LanguageOption = None) -> None:
    """Plan to keep or to replace bearings.

    Remaining life, replacement at least cost, expected failures of a fleet.
    """


@app.command(
    "remaining",
    cls=ReplaceCommand,
    epilog="Examples: replace remaining field.csv --age '8000 h' --mission '2000 h';"
    " replace remaining --shape 1.5 --l10 '20000 h' --age '8000 h' --mission '2000 h'.",
)
@with_outputs
@with_life_columns
@with_lives
def remaining(
    data: DataArgument = None,
    age: Annotated[
        str, typer.Option("--age", metavar="TIME", help="Time run so far, such as '8000 h'.")
    ] = "",
    mission: Annotated[
        str | None,
        typer.Option("--mission", metavar="TIME", help="Time to run more, such as '2000 h'."),
    ] = None,
    confidence: ConfidenceOption = 0.9,
    of_lives: LivesOptions = NOTHING_OF_LIVES,
    columns: LifeColumns = ALL_COLUMNS,
    plot: PlotOption = None,
    json: JsonOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show the chance that a bearing of an age runs on.

    Conditional reliability and residual life.
    """
    with plain_endings(lang):
        if not age:
            raise InputError(said("is missing"), source="--age", example="--age '8000 h'")
        data, json, lives = _lives(of_lives, columns, data, json, plot, outputs)
        from rolamento.pages.replace import remaining_page
        from rolamento.tasks.replace import remaining_study

        with _working(), _told(remaining):
            found = remaining_study(data, age=age, mission=mission, confidence=confidence, **lives)

        def draw() -> Figure:
            from rolamento.plots.replace import remaining_life_figure

            assert found.found is not None
            return remaining_life_figure(found.found)

        _show(found, lambda: remaining_page(found), draw, plot, json, outputs)


def _cost(text: str | None, option: str) -> float:
    """Return a cost; 12.000 and 12.000,00 as the language that is spoken writes them.

    Raises
    ------
    InputError
        If it is missing, no number, or may be two.
    """
    from rolamento.io.numerals import Numerals
    from rolamento.units import refuse_thousands
    from rolamento.words import manner

    if text is None:
        raise InputError(said("is missing"), source=option, example=f"{option} 800")
    try:
        refuse_thousands(text, units=("",))
    except InputError as error:
        raise error.with_details(source=option, example=f"{option} {error.example}") from None
    comma = "," in text and manner().mark == ","
    cost = Numerals(True, "comma" if comma else "point").number(text.strip())
    if cost is None:
        raise InputError(
            said("must be a number"), source=option, value=text, example=f"{option} 800"
        )
    return cost


@app.command(
    "age",
    cls=ReplaceCommand,
    epilog="Examples: replace age field.csv --planned-cost 800 --failure-cost 12000;"
    " replace age --shape 2.5 --scale '1000 h' --planned-cost 1 --failure-cost 5.",
)
@with_outputs
@with_life_columns
@with_lives
def age_command(
    data: DataArgument = None,
    planned_cost: Annotated[
        str | None,
        typer.Option("--planned-cost", metavar="COST", help="Cost of a planned replacement."),
    ] = None,
    failure_cost: Annotated[
        str | None,
        typer.Option(
            "--failure-cost",
            metavar="COST",
            help="Cost of a failure: replacement, damage and lost production.",
        ),
    ] = None,
    currency: Annotated[
        str, typer.Option("--currency", metavar="NAME", help="Label of the costs, such as USD.")
    ] = "",
    confidence: ConfidenceOption = 0.9,
    of_lives: LivesOptions = NOTHING_OF_LIVES,
    columns: LifeColumns = ALL_COLUMNS,
    plot: PlotOption = None,
    json: JsonOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Plan the age of replacement at least cost per hour.

    Planned replacement against replacement on failure.
    """
    with plain_endings(lang):
        planned = _cost(planned_cost, "--planned-cost")
        failure = _cost(failure_cost, "--failure-cost")
        data, json, lives = _lives(of_lives, columns, data, json, plot, outputs)
        from rolamento.pages.replace import replacement_page
        from rolamento.tasks.replace import replacement_study

        with _working(), _told(age_command):
            found = replacement_study(
                data,
                planned=planned,
                failure=failure,
                currency=currency,
                confidence=confidence,
                **lives,
            )

        def draw() -> Figure:
            from rolamento.plots.replace import cost_of_ages_figure

            assert found.found is not None
            return cost_of_ages_figure(found.found, found.currency)

        _show(found, lambda: replacement_page(found), draw, plot, json, outputs)


@app.command(
    "fleet",
    cls=ReplaceCommand,
    epilog="Examples: replace fleet field.csv --within '2000 h';"
    " replace fleet field.csv --fleet plant.csv --until 2026-12-31 --usage '16 h' --renewed.",
)
@with_outputs
@with_life_columns
@with_lives
def fleet_command(
    data: DataArgument = None,
    fleet: Annotated[
        str | None,
        typer.Option(
            "--fleet",
            metavar="FLEET.csv",
            help="Bearings in service: columns time and, if any, status, count, hours per day; by"
            " default those of the data that have not failed.",
        ),
    ] = None,
    within: Annotated[
        str | None,
        typer.Option(
            "--within", metavar="TIME", help="Time that each will run more, such as '2000 h'."
        ),
    ] = None,
    until: Annotated[
        str | None,
        typer.Option("--until", metavar="DATE", help="Date instead, such as 2026-12-31."),
    ] = None,
    begin: Annotated[
        str | None,
        typer.Option("--from", metavar="DATE", help="Date of the ages; today by default."),
    ] = None,
    usage: Annotated[
        str | None,
        typer.Option("--usage", metavar="TIME", help="What a bearing runs a day, such as '16 h'."),
    ] = None,
    usage_column: Annotated[
        str | None,
        typer.Option(
            "--usage-column",
            metavar="COLUMN",
            help="Column of the fleet's table of what each runs a day, if named otherwise.",
        ),
    ] = None,
    renewed: Annotated[
        bool,
        typer.Option(
            "--renewed/--not-renewed",
            help="Bearings that fail are replaced by new ones, which may fail too.",
        ),
    ] = False,
    confidence: ConfidenceOption = 0.9,
    of_lives: LivesOptions = NOTHING_OF_LIVES,
    columns: LifeColumns = ALL_COLUMNS,
    plot: PlotOption = None,
    json: JsonOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show how many of a fleet are expected to fail.

    By a date or within a time, with a prediction interval.
    """
    with plain_endings(lang):
        data, json, lives = _lives(of_lives, columns, data, json, plot, outputs, fleet)
        from rolamento.pages.replace import fleet_page
        from rolamento.tasks.replace import fleet_study

        with _working(), _told(fleet_command):
            found = fleet_study(
                data,
                fleet=fleet,
                within=within,
                until=until,
                begin=begin,
                usage=usage,
                renewed=renewed,
                confidence=confidence,
                fleet_columns={
                    "usage": usage_column,
                    "decimal_mark": columns.decimal_mark,
                    "ignored": tuple(columns.ignore_column or ()),
                },
                **lives,
            )

        def draw() -> Figure:
            from rolamento.plots.replace import fleet_failures_figure

            assert found.found is not None
            return fleet_failures_figure(found.found)

        _show(found, lambda: fleet_page(found), draw, plot, json, outputs)


# --- what the commands share -----------------------------------------------------------------


def _lives(
    options: LivesOptions,
    columns: LifeColumns,
    data: str | None,
    json: str | None,
    plot: str | None,
    outputs: Outputs,
    *read: str | None,
) -> tuple[Any, str | None, dict[str, Any]]:
    """Return the data, where JSON goes, and the other arguments of `lives_of`."""
    data, json = data_and_json(data, options.example, json)
    outputs.check(
        {"--json": json, "--plot": plot},
        data,
        *read,
        rule=marked("is the data file itself; choose another name"),
    )
    if data is not None and options.example is not None:
        raise InputError(said("give a CSV file or --example, not both"), field="DATA.csv")
    names = ("shape", "scale", "l10", "samples", "seed")
    lives: dict[str, Any] = {
        "columns": columns.arguments(), "only": options.only or (), "only_mode": options.mode,
        **{name: getattr(options, name) for name in names},
    }  # fmt: skip
    source: Any = data
    if options.example is not None:
        from rolamento.weibull import published_life_test

        with told_in_options():
            name = known_example(options.example, SHIPPED).replace("-", "_")
            source = published_life_test(name, **columns.arguments())
    return source, json, lives


def _working() -> Any:
    from rolamento.cli.waiting import progress_of

    return progress_of(said("Simulating tests and fitting them …"))


@contextmanager
def _told(command: Callable[..., Any]) -> Iterator[None]:
    """Say what is wrong in the options of a command."""
    with (
        told_in_options(),
        in_options(
            command,
            only_mode="--mode",
            planned="--planned-cost",
            failure="--failure-cost",
            begin="--from",
        ),
    ):
        yield


def _show(
    found: RemainingStudy | ReplacementStudy | FleetStudy,
    page: Callable[[], Document],
    draw: Callable[[], Figure],
    plot: str | None,
    json: str | None,
    outputs: Outputs,
) -> None:
    """Write what was asked for, and end with the exit code."""
    decided = found.found is not None
    if plot is not None and decided:
        from rolamento.plots.saving import save_figure

        save_figure(draw(), plot)
    if json is not None:
        put_json(found.to_mapping(), json)
    outputs.show(page, json)
    if STANDARD_STREAM in (json, outputs.csv) and not decided:
        complain(str(found.distribution.advice))
    raise typer.Exit(SOLVED if decided else NO_RESULT)
