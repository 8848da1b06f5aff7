"""`rolamento grease` and `rolamento oil`: life and renewal of a grease, and which oil to take."""

from __future__ import annotations

from typing import Annotated, Final

import typer

from rolamento.cli.case_options import NOTHING_GIVEN, CaseOptions, with_case
from rolamento.cli.common import NO_RESULT, SOLVED, plain_endings
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import CaseArgument, JsonOption, LanguageOption, plot_option
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.streams import put, put_json
from rolamento.cli.waiting import waiting

__all__ = ["app", "grease", "oil"]

_SCHEMA: Final = 1
_KAPPA: Final = 1.5

app = typer.Typer()

KappaOption = Annotated[
    float,
    typer.Option("--kappa", metavar="NUMBER", help="Viscosity ratio κ that the oil is to give."),
]


@app.command(
    cls=JsonCommand,
    epilog="Examples: grease 6205-2RS1 --fr '500 N' --speed '3000 rpm' --temperature '70 degC';"
    " grease motor.toml --plot grease.png.",
)
@with_outputs
@with_case
def grease(
    case: CaseArgument,
    given: CaseOptions = NOTHING_GIVEN,
    kappa: KappaOption = _KAPPA,
    plot: Annotated[
        str | None, plot_option("Draw the life of the grease over the temperature")
    ] = None,
    json: JsonOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show how long a grease lives, and which one to take.

    Several makers' formulas side by side, amounts, limits of temperature and speed, base oil.
    """
    with plain_endings(lang), given.in_force():
        outputs.check({"--json": json, "--plot": plot}, case)
        from rolamento.tasks.grease import grease_of_case

        chosen = given.case(case, needs_load=True)
        with waiting(lang):
            found = grease_of_case(chosen, kappa=kappa)
        if json is not None:
            put(found.to_json() + "\n", json)
        if plot is not None:
            from rolamento.plots.grease import grease_figure
            from rolamento.plots.saving import save_figure

            save_figure(grease_figure(found), plot)
        from rolamento.pages.grease import grease_page

        outputs.show(lambda: grease_page(found), json)
        known = bool(found.intervals) or any(one.valid for one in found.lives)
    raise typer.Exit(SOLVED if known else NO_RESULT)


@app.command(
    cls=JsonCommand,
    epilog="Examples: oil 6310 --speed '1480 rpm' --kappa 1.5 --temperatures 40..80degC; oil"
    " case.toml.",
)
@with_outputs
@with_case
def oil(
    case: CaseArgument,
    given: CaseOptions = NOTHING_GIVEN,
    kappa: KappaOption = _KAPPA,
    temperatures: Annotated[
        str | None,
        typer.Option(
            "--temperatures",
            metavar="FIRST..LAST",
            help="Coldest and hottest of the lubricant, such as 40..80degC; by default that of"
            " the case.",
        ),
    ] = None,
    json: JsonOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show which ISO viscosity grade gives a wanted κ.

    The hottest decides; what the grade does in the coldest stands beside.
    """
    with plain_endings(lang), given.in_force():
        outputs.check({"--json": json}, case)
        from rolamento.tasks.grease import choose_oil_of_case

        chosen = given.case(case)
        ends = (None, None) if temperatures is None else _ends(temperatures)
        found = choose_oil_of_case(chosen, kappa, *ends)
        if json is not None:
            put_json({"schema": _SCHEMA, "kind": "oil", **found.to_mapping()}, json)
        from rolamento.pages.given import title_of
        from rolamento.pages.grease import oil_page

        title = chosen.title or chosen.bearing.designation or title_of(chosen)
        outputs.show(lambda: oil_page(found, title), json)
    raise typer.Exit(SOLVED if found.chosen is not None else NO_RESULT)


def _ends(text: str) -> tuple[float, float]:
    """Read coldest and hottest; the unit of the last stands for both."""
    from rolamento.errors import InputError
    from rolamento.units import to_si
    from rolamento.words import said

    first, dots, last = text.partition("..")
    unit = last.strip().lstrip("+-0123456789.,eE ")
    example = "--temperatures 40..80degC"
    if not dots:
        raise InputError(
            said("must be two temperatures"), source="--temperatures", value=text, example=example
        )
    first = first if any(sign.isalpha() for sign in first) else f"{first} {unit}"
    try:
        return to_si(first.strip(), "temperature"), to_si(last.strip(), "temperature")
    except InputError as error:
        raise error.with_details(source="--temperatures", value=text, example=example) from None
