"""`rolamento clearance`: clearance and preload of a mounted bearing in operation, step by step."""

from __future__ import annotations

from typing import Annotated, Final

import typer

import rolamento
from rolamento.cli.case_options import NOTHING_GIVEN, CaseOptions, with_case
from rolamento.cli.common import SOLVED, plain_endings
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import JsonOption, LanguageOption, SeedOption
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.streams import put_json
from rolamento.errors import InputError
from rolamento.words import said

_SCHEMA: Final = 2


app = typer.Typer()


@app.command(cls=JsonCommand, epilog="Example: clearance case.toml --samples 10000.")
@with_outputs
@with_case
def clearance(
    case: Annotated[
        str,
        typer.Argument(
            metavar="CASE",
            help="Case file with a [mounting], or a designation and its fits by --set; - for"
            " standard input.",
        ),
    ],
    given: CaseOptions = NOTHING_GIVEN,
    samples: Annotated[
        int | None,
        typer.Option(
            "--samples",
            metavar="N",
            help="Sample so many bearings from their tolerances, up to a million.",
        ),
    ] = None,
    seed: SeedOption = 0,
    json: JsonOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show the clearance in operation, and the preload of a set.

    After fits, temperatures, speed and wear, step by step.
    """
    with plain_endings(lang), given.in_force():
        outputs.check({"--json": json}, case)
        loaded = given.case(case)
        if loaded.mounting is None and rolamento.case.is_designation(case):
            raise InputError(
                said("is missing: without it the bearing runs at its own clearance"),
                source=case,
                field="mounting",
                example="--set mounting.shaft_tolerance=k5 --set mounting.housing_tolerance=H7",
            )
        from rolamento.tasks.clearance import mounted_clearance, mounted_samples

        found = mounted_clearance(loaded)
        drawn = None if samples is None else mounted_samples(loaded, samples, seed)
        if json is not None:
            scatter = {} if drawn is None else {"samples": drawn.to_mapping()}
            put_json({"schema": _SCHEMA, **found.to_mapping(), **scatter}, json)
        from rolamento.pages.clearance import clearance_page

        outputs.show(lambda: clearance_page(found, drawn, title=loaded.title), json)
    raise typer.Exit(SOLVED)
