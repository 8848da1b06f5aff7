"""`rolamento oscillation`: the life of a bearing that swings to and fro."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from rolamento.cli.case_options import NOTHING_GIVEN, CaseOptions, with_case
from rolamento.cli.common import NO_RESULT, SOLVED, Language, plain_endings
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import CaseArgument, JsonOption, LanguageOption, plot_option
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.streams import STANDARD_STREAM, complain, put
from rolamento.cli.table_options import DecimalMarkOption
from rolamento.cli.waiting import waiting

if TYPE_CHECKING:
    from rolamento.case import Case

__all__ = ["app", "oscillation"]

app = typer.Typer()


@app.command(
    cls=JsonCommand,
    epilog="Examples: oscillation 6310 --fr '5 kN' --angle 90deg --frequency 2Hz; oscillation"
    " pitch.toml --plot life.png; oscillation pitch.toml --spectrum angles.csv.",
)
@with_outputs
@with_case
def oscillation(
    case: CaseArgument,
    given: CaseOptions = NOTHING_GIVEN,
    angle: Annotated[
        str | None,
        typer.Option(
            "--angle", metavar="ANGLE", help="Between the end points of the swing, such as 30deg."
        ),
    ] = None,
    frequency: Annotated[
        str | None,
        typer.Option(
            "--frequency",
            metavar="FREQUENCY",
            help="Oscillations, there and back, such as 2Hz or '30 1/min'.",
        ),
    ] = None,
    spectrum: Annotated[
        str | None,
        typer.Option(
            "--spectrum",
            metavar="FILE.csv",
            help="Histogram: a column share (of the time) or revolutions (of the oscillations),"
            " and fields such as duty.oscillation.angle.",
        ),
    ] = None,
    plot: Annotated[str | None, plot_option("Draw the life over the angle")] = None,
    json: JsonOption = None,
    outputs: Outputs = NOWHERE,
    decimal_mark: DecimalMarkOption = None,
    lang: LanguageOption = None,
) -> None:
    """Show the life of a bearing that swings instead of turning.

    Race by race, beside Harris's form; critical angles, fretting, and a histogram of angles.
    """
    with plain_endings(lang), given.in_force():
        outputs.check({"--json": json, "--plot": plot}, case)
        wanted = [
            f"duty.oscillation.{name}={value}"
            for name, value in (("angle", angle), ("frequency", frequency))
            if value is not None
        ]
        if wanted:  # a swing takes the place of a speed, whatever the file has
            stills = [("inner", given.speed), ("outer", given.outer_speed)]
            wanted += [f"duty.{ring}_speed=0 rpm" for ring, own in stills if own is None]
        chosen = given.case(case, *wanted, needs_load=spectrum is None)
        if spectrum is None:
            solved = _one(chosen, plot, json, outputs, lang)
        else:
            solved = _spectrum(chosen, spectrum, decimal_mark, json, outputs, lang)
    raise typer.Exit(SOLVED if solved else NO_RESULT)


def _one(
    case: Case, plot: str | None, json: str | None, outputs: Outputs, lang: Language | None
) -> bool:
    from rolamento.tasks.oscillation import life_in_oscillation

    with waiting(lang):
        found = life_in_oscillation(case)
    if json is not None:
        put(found.to_json() + "\n", json)
    if plot is not None:
        from rolamento.plots.oscillation import oscillation_figure
        from rolamento.plots.saving import save_figure

        save_figure(oscillation_figure(found), plot)
    from rolamento.pages.oscillation import oscillation_page

    outputs.show(lambda: oscillation_page(found), json)
    if STANDARD_STREAM in (json, outputs.csv) and not found.converged:
        from rolamento.words.reasons import reason

        complain(reason(str(found.solved.status.code[0])))
    return found.converged and not (found.life is None or found.life.fretting)


def _spectrum(
    case: Case,
    spectrum: str,
    decimal_mark: str | None,
    json: str | None,
    outputs: Outputs,
    lang: Language | None,
) -> bool:
    from rolamento.tasks.oscillation import life_under_oscillations

    with waiting(lang):
        found = life_under_oscillations(case, spectrum, decimal_mark=decimal_mark)
    if json is not None:
        put(found.to_json() + "\n", json)
    from rolamento.pages.oscillation import oscillation_spectrum_page

    outputs.show(lambda: oscillation_spectrum_page(found), json)
    return found.converged
