"""`rolamento friction`: torque by every model, for a case or over one of its fields."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Annotated, Final

import typer

import rolamento
from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    Language,
    complain_of,
    plain_endings,
    words_of,
)
from rolamento.cli.options import (
    CaseArgument,
    JsonOption,
    LanguageOption,
    SettingsOption,
    csv_option,
)
from rolamento.cli.outputs import check_outputs
from rolamento.cli.over_field import (
    POINTS,
    CurvesPlotOption,
    LogOption,
    PointsOption,
    VariantsOption,
    check_variants,
    show_curves,
)
from rolamento.cli.streams import STANDARD_STREAM, print_text, put
from rolamento.cli.waiting import waiting
from rolamento.errors import InputError
from rolamento.words import said

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure

    from rolamento.studies.friction_curves import FrictionCurve

__all__ = ["friction"]

_HYSTERESIS: Final = 0.01


def friction(
    case: CaseArgument,
    over: Annotated[
        str | None,
        typer.Option(
            "--over",
            metavar="FIELD=FIRST..LAST",
            help="Vary a field, such as duty.load.fx=10..200N or duty.inner_speed=0.5..30000rpm.",
        ),
    ] = None,
    points: PointsOption = POINTS,
    log: LogOption = False,
    variants: VariantsOption = None,
    coefficient: Annotated[
        float | None,
        typer.Option("--coefficient", metavar="MU", help="Coefficient of friction, up to 1."),
    ] = None,
    hysteresis: Annotated[
        float,
        typer.Option(
            "--hysteresis", metavar="LOSS", help="Part of the elastic work that is lost, 0 to 1."
        ),
    ] = _HYSTERESIS,
    json: JsonOption = None,
    csv: Annotated[str | None, csv_option("With --over: write the points")] = None,
    plot: CurvesPlotOption = None,
    settings: SettingsOption = None,
    lang: LanguageOption = None,
) -> None:
    """Show the friction torque by every model.

    Of a case, or over one of its fields; says which of the models are valid.
    """
    with plain_endings(lang):
        _check(case, over, json, csv, plot, variants or [])
        _check_share("--hysteresis", hysteresis)
        _check_share("--coefficient", coefficient)
        loaded = rolamento.load_case(case, settings or ())
        chosen = _with_coefficient(loaded, coefficient)
        if over is None:
            solved = _one(chosen, hysteresis, json, lang)
        else:
            curves = _curves(chosen, over, points, log, variants or [], hysteresis, lang)
            from rolamento.document.medium import Medium
            from rolamento.report import friction_curves

            solved = show_curves(
                curves,
                json_text=friction_curves.curves_json,
                csv_text=friction_curves.curves_csv,
                page_text=lambda shown: friction_curves.curves_report(
                    shown, words_of(lang), Medium.of(sys.stdout)
                ),
                figure=_figure,
                outputs=(json, csv, plot),
                lang=lang,
            )
    raise typer.Exit(SOLVED if solved else NO_RESULT)


def _check(
    case: str,
    over: str | None,
    json: str | None,
    csv: str | None,
    plot: str | None,
    variants: list[str],
) -> None:
    """Refuse what does not go together, before any work."""
    if over is None:
        for name, given in (("--csv", csv), ("--plot", plot), ("--variant", variants or None)):
            if given is not None:
                raise InputError(
                    said("needs --over"),
                    field=name,
                    value=given,
                    example="--over duty.load.fx=10..200N",
                )
    check_variants(variants)
    check_outputs({"--json": json, "--csv": csv, "--plot": plot}, case)


def _check_share(name: str, value: float | None) -> None:
    if value is not None and not 0.0 <= value <= 1.0:
        raise InputError(
            said("must be from 0 to 1"), field=name, value=value, example=f"{name} 0.1"
        )


def _with_coefficient(case: rolamento.Case, coefficient: float | None) -> rolamento.Case:
    """Return the case with the coefficient in its lubricant; a dry one if it has none."""
    if coefficient is None:
        return case
    if case.lubricant is None:
        dry = {"kind": "dry", "name": "dry", "friction_coefficient": coefficient}
        return case.replace(lubricant=dry)
    return case.replace(lubricant=case.lubricant.replace(friction_coefficient=coefficient))


def _one(case: rolamento.Case, hysteresis: float, json: str | None, lang: Language | None) -> bool:
    """Show the friction of the case itself; tell whether it has a result."""
    from rolamento.analysis import analyse

    if case.lubricant is None or case.lubricant.friction_coefficient is None:
        raise InputError(
            said("is missing; the friction calculation needs it"),
            field="lubricant.friction_coefficient",
            example="--coefficient 0.1",
        )
    analysis = analyse(case, hysteresis=hysteresis)
    from rolamento.document.medium import Medium
    from rolamento.report.friction_curves import friction_json, friction_report

    converged = bool(analysis.solved.converged[0])
    if json is not None:
        put(friction_json(analysis) + "\n", json)
    if json != STANDARD_STREAM:
        print_text(friction_report(analysis, words_of(lang), Medium.of(sys.stdout)))
    elif not converged:
        complain_of(analysis.solved, lang)
    return converged


def _curves(
    case: rolamento.Case,
    over: str,
    points: int,
    log: bool,
    variants: list[str],
    hysteresis: float,
    lang: Language | None,
) -> list[FrictionCurve]:
    """Solve the case and its variants."""
    from rolamento.studies.friction_curves import friction_curve, read_range

    chosen = read_range(over, points, log=log)
    cases = [("", case), *((text, rolamento.override(case, [text])) for text in variants)]

    with waiting(lang):
        return [
            friction_curve(one, chosen, hysteresis=hysteresis, label=label) for label, one in cases
        ]


def _figure(curves: Sequence[FrictionCurve]) -> Figure:
    from rolamento.plots.friction import friction_figure

    return friction_figure(curves)
