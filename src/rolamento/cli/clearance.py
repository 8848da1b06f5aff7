"""`rolamento clearance`: clearance and preload of a mounted bearing in operation, step by step."""

from __future__ import annotations

from typing import Annotated, Final

import typer

import rolamento
from rolamento.cli.common import SOLVED, plain_endings
from rolamento.cli.options import JsonOption, LanguageOption, SeedOption, SettingsOption
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.streams import put_json

_SCHEMA: Final = 2


@with_outputs
def clearance(
    case: Annotated[
        str,
        typer.Argument(metavar="CASE", help="Case file with a [mounting]; - for standard input."),
    ],
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
    settings: SettingsOption = None,
    lang: LanguageOption = None,
) -> None:
    """Show the clearance that is left in operation, and the preload of a set.

    After fits, temperatures, speed and wear, step by step.
    """
    with plain_endings(lang):
        outputs.check({"--json": json}, case)
        loaded = rolamento.load_case(case, settings or ())
        from rolamento.tasks.clearance import mounted_clearance, mounted_samples

        found = mounted_clearance(loaded)
        drawn = None if samples is None else mounted_samples(loaded, samples, seed)
        if json is not None:
            scatter = {} if drawn is None else {"samples": drawn.to_mapping()}
            put_json({"schema": _SCHEMA, **found.to_mapping(), **scatter}, json)
        from rolamento.pages.clearance import clearance_page

        outputs.show(lambda: clearance_page(found, drawn, title=loaded.title), json)
    raise typer.Exit(SOLVED)
