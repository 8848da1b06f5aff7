"""`rolamento clearance`: the clearance of a mounted bearing in operation, step by step."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Annotated

import typer

import rolamento
from rolamento.cli.common import SOLVED, plain_endings, words_of
from rolamento.cli.options import JsonOption, LanguageOption, SeedOption, SettingsOption
from rolamento.cli.outputs import check_outputs
from rolamento.cli.streams import STANDARD_STREAM, print_text, put

if TYPE_CHECKING:
    from rolamento.clearance import ClearanceSamples


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
    settings: SettingsOption = None,
    lang: LanguageOption = None,
) -> None:
    """Show the clearance that is left in operation.

    After fits, temperatures, speed and wear, step by step.
    """
    with plain_endings(lang):
        check_outputs({"--json": json}, case)
        loaded = rolamento.load_case(case, settings or ())
        from rolamento.clearance import clearance_of_case
        from rolamento.document.medium import Medium
        from rolamento.report.clearance import clearance_json, clearance_report

        found = clearance_of_case(loaded)
        drawn = None if samples is None else _drawn(loaded, samples, seed)
        if json is not None:
            put(clearance_json(found, drawn) + "\n", json)
        if json != STANDARD_STREAM:
            print_text(clearance_report(found, drawn, words_of(lang), Medium.of(sys.stdout)))
    raise typer.Exit(SOLVED)


def _drawn(case: rolamento.Case, samples: int, seed: int) -> ClearanceSamples:
    """Bearings drawn from the tolerances of a case, which has a mounting."""
    from rolamento.clearance import sample_clearance

    assert case.mounting is not None
    return sample_clearance(
        case.bearing,
        case.mounting,
        case.temperature,
        inner_speed=case.duty.inner_speed,
        outer_speed=case.duty.outer_speed,
        samples=samples,
        seed=seed,
    )
