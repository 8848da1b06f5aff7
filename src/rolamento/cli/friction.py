"""`rolamento friction`: torque by every model, for a case or over one of its fields."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Final

import typer

import rolamento
from rolamento.cli.case_options import NOTHING_GIVEN, CaseOptions, with_case
from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    Language,
    complain_of,
    plain_endings,
)
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import (
    CaseArgument,
    JsonOption,
    LanguageOption,
    VariantsOption,
)
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
from rolamento.cli.streams import STANDARD_STREAM, put_json
from rolamento.cli.waiting import waiting
from rolamento.errors import InputError
from rolamento.words import said

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure

    from rolamento.studies.friction_curves import FrictionCurve

__all__ = ["app", "friction"]

_HYSTERESIS: Final = 0.01
_COEFFICIENT: Final = "lubricant.friction_coefficient"
_DRY: Final = ("lubricant.kind=dry", "lubricant.name=dry")
"""The lubricant of a case that has none, if the coefficient is an option."""


app = typer.Typer()


@app.command(
    cls=JsonCommand,
    epilog="Examples: friction 6310 --fr '5 kN' --speed '1480 rpm' --lubricant 'ISO VG 68'"
    " --temperature '70 degC'; friction case.toml --over duty.load.fx=10..200N"
    " --plot friction.png.",
)
@with_outputs
@with_case
def friction(
    case: CaseArgument,
    given: CaseOptions = NOTHING_GIVEN,
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
        typer.Option(
            "--coefficient",
            metavar="MU",
            help="Coefficient of friction, up to 1; by the regime of lubrication if not given.",
        ),
    ] = None,
    hysteresis: Annotated[
        float,
        typer.Option(
            "--hysteresis",
            metavar="LOSS",
            help="Hysteresis loss: fraction of the elastic work, 0 to 1.",
        ),
    ] = _HYSTERESIS,
    json: JsonOption = None,
    plot: CurvesPlotOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show the friction torque by every model.

    For a case, or over one of its fields, with the validity of each model.
    """
    with plain_endings(lang), given.in_force():
        _check(over, plot, variants or [])
        outputs.check({"--json": json, "--plot": plot}, case)
        _check_share("--hysteresis", hysteresis)
        _check_share("--coefficient", coefficient)
        wanted = [] if coefficient is None else [f"{_COEFFICIENT}={coefficient!r}"]
        chosen = given.case(
            case, *wanted, otherwise=_DRY if wanted else (), needs_load=over is None
        )
        if over is None:
            solved = _one(chosen, hysteresis, json, outputs, lang)
        else:
            curves = _curves(chosen, over, points, log, variants or [], hysteresis, lang)
            solved = _show_curves(curves, json, plot, outputs, lang)
    raise typer.Exit(SOLVED if solved else NO_RESULT)


def _check(over: str | None, plot: str | None, variants: list[str]) -> None:
    """Refuse what does not go together, before any work."""
    if over is None:
        for name, given in (("--plot", plot), ("--variant", variants or None)):
            if given is not None:
                raise InputError(
                    said("needs --over"),
                    field=name,
                    value=given,
                    example="--over duty.load.fx=10..200N",
                )
    check_variants(variants)


def _check_share(name: str, value: float | None) -> None:
    if value is not None and not 0.0 <= value <= 1.0:
        raise InputError(
            said("must be from 0 to 1"), field=name, value=value, example=f"{name} 0.1"
        )


def _one(
    case: rolamento.Case,
    hysteresis: float,
    json: str | None,
    outputs: Outputs,
    lang: Language | None,
) -> bool:
    """Show the friction of the case itself; return whether it has a result."""
    from rolamento.tasks.friction import friction_mapping, friction_of_case

    analysis = friction_of_case(case, hysteresis=hysteresis)
    converged = bool(analysis.solved.converged[0])
    if json is not None:
        put_json(friction_mapping(analysis), json)
    from rolamento.pages.friction import friction_page

    outputs.show(lambda: friction_page(analysis), json)
    if STANDARD_STREAM in (json, outputs.csv) and not converged:
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
    cases = cases_over(case, variants)

    with waiting(lang):
        return [
            friction_curve(one, chosen, hysteresis=hysteresis, label=label) for label, one in cases
        ]


def _show_curves(
    curves: Sequence[FrictionCurve],
    json: str | None,
    plot: str | None,
    outputs: Outputs,
    lang: Language | None,
) -> bool:
    """Show friction over a field; return whether every point has a result."""
    from rolamento.pages.friction_over import friction_over_page
    from rolamento.studies.friction_curves import curves_mapping

    def figure(shown: Sequence[FrictionCurve]) -> Figure:
        from rolamento.plots.friction import friction_figure

        return friction_figure(shown)

    def json_text(shown: Sequence[FrictionCurve]) -> str:
        from rolamento.io.json import dumps

        return dumps(curves_mapping(shown), indent=2)

    return show_curves(curves, friction_over_page, json_text, figure, json, plot, outputs, lang)
