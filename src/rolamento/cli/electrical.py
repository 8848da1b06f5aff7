"""`rolamento electrical`: a bearing as a capacitor; current density, field, breakdown."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import typer

from rolamento.cli.case_options import NOTHING_GIVEN, CaseOptions, with_case
from rolamento.cli.common import NO_RESULT, SOLVED, plain_endings
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import CaseArgument, JsonOption, LanguageOption
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.streams import STANDARD_STREAM, complain, put_json
from rolamento.cli.waiting import waiting

if TYPE_CHECKING:
    from rolamento.document import Document

__all__ = ["app", "electrical"]

_SCHEMA: Final = 1

app = typer.Typer()


@app.command(
    cls=JsonCommand,
    epilog="Examples: electrical 6310 --fr '1 kN' --speed '1500 rpm' --lubricant 'ISO VG 100'"
    " --temperature '70 degC' --set electrical.current='0.5 A'; electrical motor.toml --set"
    " electrical.voltage='10 V'.",
)
@with_outputs
@with_case
def electrical(
    case: CaseArgument,
    given: CaseOptions = NOTHING_GIVEN,
    json: JsonOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show a bearing as a capacitor: current, field, breakdown.

    Capacitance of its films; the apparent current density of [electrical] beside published
    bands; the field in the films and the voltage at which they break down; steel beside ceramic.
    """
    with plain_endings(lang), given.in_force():
        outputs.check({"--json": json}, case)
        chosen = given.case(case)
        from rolamento.electrical import electrics_of

        with waiting(lang):
            found = electrics_of(chosen)
        if json is not None:
            put_json({"schema": _SCHEMA, "kind": "electrical", **found.to_mapping()}, json)

        def page() -> Document:
            from rolamento.pages.electrical import electrical_page

            return electrical_page(found)

        outputs.show(page, json)
        converged = bool(found.solved.converged[0])
        if STANDARD_STREAM in (json, outputs.csv) and not converged:
            from rolamento.words.reasons import reason

            complain(reason(str(found.solved.status.code[0])))
    raise typer.Exit(SOLVED if converged else NO_RESULT)
