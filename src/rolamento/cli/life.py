"""`rolamento life`: rating and fatigue life by every theory, of one bearing or of a shaft."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Annotated

import typer

import rolamento
from rolamento.cli.case_options import NOTHING_GIVEN, CaseOptions, with_case
from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    Language,
    complain_of,
    complain_of_points,
    plain_endings,
)
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import LanguageOption, VariantsOption, json_option
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.over_field import (
    POINTS,
    CurvesPlotOption,
    LogOption,
    PointsOption,
    cases_over,
    check_variants,
    show_curves,
)
from rolamento.cli.streams import STANDARD_STREAM, complain, put
from rolamento.cli.table_options import DecimalMarkOption, told_in_options
from rolamento.cli.waiting import waiting
from rolamento.errors import InputError
from rolamento.words import marked, said
from rolamento.words.reasons import reason

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from matplotlib.figure import Figure

    from rolamento.document import Document
    from rolamento.tasks.life_over import LifeCurve
    from rolamento.tasks.life_spectrum import SpectrumLife

__all__ = ["app", "life"]


app = typer.Typer()


@app.command(
    cls=JsonCommand,
    epilog="Examples: life 6310/C3 --fr '5 kN' --speed '1480 rpm'; life case.toml"
    " --reliability 0.95; life left.toml right.toml;"
    " life case.toml --spectrum steps.csv; life case.toml --over duty.load.fz=1..8kN.",
)
@with_outputs
@with_case
def life(
    case: Annotated[
        list[str],
        typer.Argument(
            metavar="CASE",
            help="Case file (TOML or JSON), or a designation such as 6310/C3; several are the "
            "bearings of one shaft.",
        ),
    ],
    given: CaseOptions = NOTHING_GIVEN,
    over: Annotated[
        str | None,
        typer.Option(
            "--over",
            metavar="FIELD=FIRST..LAST",
            help="Vary a field, such as duty.load.fz=1..8kN or life.contamination=0.1..1.",
        ),
    ] = None,
    points: PointsOption = POINTS,
    log: LogOption = False,
    variants: VariantsOption = None,
    spectrum: Annotated[
        str | None,
        typer.Option(
            "--spectrum",
            metavar="FILE.csv",
            help="Steps of the duty: a column share (of the time), and fields of the case.",
        ),
    ] = None,
    nsk_table: Annotated[
        str | None,
        typer.Option(
            "--nsk-table",
            metavar="FILE.csv",
            help="a_NSK from the maker's chart: rows of kappa, columns of (P-P_u)/(C a_c).",
        ),
    ] = None,
    reliability: Annotated[
        float | None,
        typer.Option("--reliability", metavar="S", help="Reliability of the life, such as 0.95."),
    ] = None,
    cleanliness: Annotated[
        str | None,
        typer.Option(
            "--cleanliness",
            metavar="LEVEL",
            help="Cleanliness of the oil or grease in words: extreme, high, normal, slight,"
            " typical, severe or very_severe (contamination).",
        ),
    ] = None,
    json: Annotated[str | None, json_option("Write everything as JSON")] = None,
    outputs: Outputs = NOWHERE,
    plot: CurvesPlotOption = None,
    decimal_mark: DecimalMarkOption = None,
    lang: LanguageOption = None,
) -> None:
    """Show the life by every theory, and what would help.

    For a bearing, several on one shaft, or a duty of several steps: where each theory applies,
    and what limits the life.
    """
    with plain_endings(lang), given.in_force():
        _check(case, over, spectrum, variants or [])
        read = [path for path in (*case, spectrum, nsk_table) if path is not None]
        _check_files(read, json, plot, outputs, over)
        wanted = [] if reliability is None else [_setting_of(reliability)]
        cases = [given.case(one, *wanted, needs_load=over is None) for one in case]
        if cleanliness is not None:
            cases = [_with_cleanliness(one, cleanliness) for one in cases]
        tables = {"nsk_table": nsk_table, "decimal_mark": decimal_mark}
        if over is not None:
            curves = _curves(cases[0], over, points, log, variants or [], tables, lang)
            solved = _show_curves(curves, json, plot, outputs, lang)
        elif spectrum is not None:
            solved = _spectrum(case, cases, spectrum, tables, json, outputs, lang)
        elif len(cases) > 1:
            solved = _shaft(case, cases, tables, json, outputs, lang)
        else:
            solved = _one(cases[0], tables, json, outputs, lang)
    raise typer.Exit(SOLVED if solved else NO_RESULT)


def _with_cleanliness(case: rolamento.Case, level: str) -> rolamento.Case:
    """Return the case with a level of cleanliness in words, of its oil or grease."""
    grease = case.lubricant is not None and case.lubricant.kind == "grease"
    name = "grease_cleanliness" if grease else "cleanliness"
    try:
        return rolamento.override(case, [f"life.{name}={level}"])
    except InputError as error:
        if not error.field.startswith("life."):
            raise
        example = "--cleanliness normal"
        raise error.with_details(field="--cleanliness", source="", example=example) from None


def _setting_of(reliability: float) -> str:
    """Return the setting that an option stands for."""
    from rolamento.studies.fields import read_field

    field = read_field("life.reliability")
    try:
        field.checked(reliability, in_file=True)
    except InputError as error:
        raise error.with_details(field="--reliability", example="--reliability 0.95") from None
    return f"{field.name}={reliability!r}"


def _check(cases: list[str], over: str | None, spectrum: str | None, variants: list[str]) -> None:
    """Refuse what does not go together, before any work."""
    if over is not None and spectrum is not None:
        raise InputError(said("cannot be combined with --over"), field="--spectrum", value=spectrum)
    if over is not None and len(cases) > 1:
        raise InputError(
            said("is for a single case; several are given"), field="--over", value=over
        )
    if variants and over is None:
        raise InputError(
            said("needs --over"),
            field="--variant",
            value=variants[0],
            example="--over duty.load.fz=1..8kN",
        )
    check_variants(variants)


def _check_files(
    read: list[str], json: str | None, plot: str | None, outputs: Outputs, over: str | None
) -> None:
    """Refuse outputs without what they show, or that run into each other or into what is read."""
    if read.count(STANDARD_STREAM) > 1:
        raise InputError(said("can be read only once"), source="standard input")
    if plot is not None and over is None:
        raise InputError(
            said("needs --over"),
            field="--plot",
            value=plot,
            example="--over duty.load.fz=1..8kN",
        )
    outputs.check(
        {"--json": json, "--plot": plot},
        *read,
        rule=marked("is one of the input files; choose another name"),
    )
    if json is not None and json.lower().endswith(".toml"):
        raise InputError(
            said(
                "is taken as the FILE of --json; put --json last, or follow it with a "
                "name that ends in .json"
            ),
            field="--json",
            value=json,
            example="life a.toml b.toml --json",
        )


def _one(
    case: rolamento.Case,
    tables: dict[str, str | None],
    json: str | None,
    outputs: Outputs,
    lang: Language | None,
) -> bool:
    """Show the life of a case; return whether it has a result."""
    from rolamento.pages.life import life_page
    from rolamento.tasks.life import life_of_case

    with told_in_options(), waiting(lang):
        found = life_of_case(case, **tables)
    if json is not None:
        put(found.to_json() + "\n", json)
    outputs.show(
        lambda: life_page(found.solved, found.life, found.changes, friction=found.friction), json
    )
    if STANDARD_STREAM in (json, outputs.csv) and not found.converged:
        complain_of(found.solved, lang)
    return found.converged


def _shaft(
    paths: list[str],
    cases: list[rolamento.Case],
    tables: dict[str, str | None],
    json: str | None,
    outputs: Outputs,
    lang: Language | None,
) -> bool:
    """Show the lives of several bearings and of all together."""
    from rolamento.pages.shaft import shaft_page
    from rolamento.tasks.life import life_of_shaft

    with told_in_options(), waiting(lang):
        found = life_of_shaft(cases, **tables)
    names = _names(paths, cases)
    if json is not None:
        put(found.to_json(names) + "\n", json)
    outputs.show(lambda: shaft_page(found, names), json)
    if STANDARD_STREAM in (json, outputs.csv) and not found.converged:
        failed = next(solved for solved in found.bearings if not solved.converged[0])
        complain(f"{failed.title}: {reason(str(failed.status.code[0]))}")
    return found.converged


def _names(paths: list[str], cases: list[rolamento.Case]) -> list[str]:
    """What to call the bearings of a shaft: by their titles if they differ, else by their files."""
    titles = [own.title for own in cases]
    return titles if all(titles) and len(set(titles)) == len(titles) else paths


def _spectrum(
    paths: list[str],
    cases: list[rolamento.Case],
    spectrum: str,
    tables: dict[str, str | None],
    json: str | None,
    outputs: Outputs,
    lang: Language | None,
) -> bool:
    """Show the life of a bearing under a duty of several steps, or the lives of a shaft's."""
    from rolamento.pages.life_spectrum import life_spectrum_page, shaft_spectrum_page
    from rolamento.tasks.life_spectrum import life_of_duty_spectrum, lives_under

    text: Callable[[], str]
    page: Callable[[], Document]
    bearings: tuple[SpectrumLife, ...]
    with told_in_options(), waiting(lang):
        if len(cases) > 1:
            shaft = lives_under(cases, spectrum, **tables)
            names, bearings = _names(paths, cases), shaft.bearings
            text, page = partial(shaft.to_json, names), partial(shaft_spectrum_page, shaft, names)
        else:
            alone = life_of_duty_spectrum(cases[0], spectrum, **tables)
            bearings, text, page = (alone,), alone.to_json, partial(life_spectrum_page, alone)
    if json is not None:
        put(text() + "\n", json)
    outputs.show(page, json)
    failed = next((own for own in bearings if not own.converged), None)
    if STANDARD_STREAM in (json, outputs.csv) and failed is not None:
        points = failed.status[(failed.status != "converged") & failed.taking_part]
        complain_of_points(points, len(failed.steps), lang)
    return failed is None


def _curves(
    case: rolamento.Case,
    over: str,
    points: int,
    log: bool,
    variants: list[str],
    tables: dict[str, str | None],
    lang: Language | None,
) -> list[LifeCurve]:
    """Solve the case and its variants over a field."""
    from rolamento.studies.ranges import read_range
    from rolamento.tasks.life_over import life_curves

    chosen = read_range(over, points, log=log)
    cases = cases_over(case, variants)
    with told_in_options(), waiting(lang):
        return life_curves(cases, chosen, **tables)


def _show_curves(
    curves: Sequence[LifeCurve],
    json: str | None,
    plot: str | None,
    outputs: Outputs,
    lang: Language | None,
) -> bool:
    """Show life over a field; return whether every point has a result."""
    from rolamento.pages.life_over import life_over_page
    from rolamento.tasks.life_over import curves_json

    def figure(shown: Sequence[LifeCurve]) -> Figure:
        from rolamento.plots.life import life_figure

        return life_figure(shown)

    return show_curves(curves, life_over_page, curves_json, figure, json, plot, outputs, lang)
