"""`rolamento speed`: how fast a bearing may run, and what load its elements need."""

from __future__ import annotations

from typing import Annotated, Final

import typer

from rolamento.cli.case_options import NOTHING_GIVEN, CaseOptions, with_case
from rolamento.cli.common import SOLVED, plain_endings
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import CaseArgument, JsonOption, LanguageOption
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.streams import put_json

__all__ = ["app", "speed_command"]

_SCHEMA: Final = 1


app = typer.Typer()


@app.command(
    "speed",
    cls=JsonCommand,
    epilog="Examples: speed 6210 --fr '2 kN' --speed '6000 rpm' --lubricant 'ISO VG 32'"
    " --temperature '70 degC'; speed case.toml --json.",
)
@with_outputs
@with_case
def speed_command(
    case: CaseArgument,
    given: CaseOptions = NOTHING_GIVEN,
    series: Annotated[
        str | None,
        typer.Option(
            "--series",
            metavar="SERIES",
            help="Series of the bearing, such as 62, 70 or NU2, where no designation tells it.",
        ),
    ] = None,
    width: Annotated[
        str | None,
        typer.Option(
            "--width",
            metavar="LENGTH",
            help="Width of the bearing, B or T of tapered rollers, such as '20 mm'.",
        ),
    ] = None,
    minimum_load_factor: Annotated[
        str | None,
        typer.Option(
            "--minimum-load-factor",
            metavar="FORCE",
            help="Factor A of a thrust ball bearing, as its maker lists it, such as '12 N'.",
        ),
    ] = None,
    json: JsonOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show how fast a bearing may run, and the load that it needs.

    Thermal reference and permissible speed, the maker's n·d_m, minimum load.
    """
    with plain_endings(lang), given.in_force():
        outputs.check({"--json": json}, case)
        from rolamento.errors import InputError
        from rolamento.tasks.speed import speed_limits
        from rolamento.units import Dimension, to_si

        def number(text: str | None, dimension: Dimension, option: str) -> float | None:
            if text is None:
                return None
            try:
                return to_si(text, dimension)
            except InputError as error:
                raise error.with_details(source=option) from None

        found = speed_limits(
            given.case(case),
            series=series,
            width=number(width, "length", "--width"),
            minimum_load_factor=number(minimum_load_factor, "force", "--minimum-load-factor"),
        )
        if json is not None:
            put_json({"schema": _SCHEMA, **found.to_mapping()}, json)
        from rolamento.pages.speed import speed_page

        outputs.show(lambda: speed_page(found), json)
    raise typer.Exit(SOLVED)
