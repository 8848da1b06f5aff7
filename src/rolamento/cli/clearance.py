"""`rolamento clearance`: the clearance of a mounted bearing in operation, step by step."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Final

import typer

import rolamento
from rolamento.cli.case_options import NOTHING_GIVEN, CaseOptions, with_case
from rolamento.cli.common import SOLVED, plain_endings
from rolamento.cli.options import JsonOption, LanguageOption, SeedOption
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.streams import put_json

if TYPE_CHECKING:
    from rolamento.clearance import ClearanceSamples

_SCHEMA: Final = 2


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
    """Show the clearance that is left in operation.

    After fits, temperatures, speed and wear, step by step.
    """
    with plain_endings(lang), given.in_force():
        outputs.check({"--json": json}, case)
        loaded = given.case(case)
        from rolamento.clearance import clearance_of_case

        found = clearance_of_case(loaded)
        drawn = None if samples is None else _drawn(loaded, samples, seed)
        if json is not None:
            scatter = {} if drawn is None else {"samples": drawn.to_mapping()}
            put_json({"schema": _SCHEMA, **found.to_mapping(), **scatter}, json)
        from rolamento.pages.clearance import clearance_page

        outputs.show(lambda: clearance_page(found, drawn, title=loaded.title), json)
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
