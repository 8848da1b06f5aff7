"""`rolamento frequencies`: at which frequencies a bearing shows damage."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any, Final

import typer

from rolamento.cli.case_options import NOTHING_GIVEN, CaseOptions, with_case
from rolamento.cli.common import NO_RESULT, SOLVED, plain_endings
from rolamento.cli.option_names import in_options
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import (
    BearingArgument,
    JsonOption,
    LagOption,
    LanguageOption,
    OuterSpeedOption,
    SpeedOption,
)
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.streams import put_json
from rolamento.errors import InputError
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.tasks.frequencies import FrequencyResult
    from rolamento.vibration.frequency_band import Tolerances

_HARMONICS: Final = 3
_TOLERANCES: Final[dict[str, Any]] = {
    "ball_diameter": "length",
    "roller_diameter": "length",
    "pitch_diameter": "length",
    "contact_angle": "angle",
    "speed": None,
    "slip": None,
}
"""What a tolerance may be of, by its dimension; parts have none."""


app = typer.Typer()


@app.command(
    cls=JsonCommand,
    epilog="Examples: frequencies 6205 --speed '1797 rpm'; frequencies case.toml --json.",
)
@with_outputs
@with_case
def frequencies(
    bearing: BearingArgument,
    speed: SpeedOption = None,
    outer_speed: OuterSpeedOption = None,
    given: CaseOptions = NOTHING_GIVEN,
    slip: LagOption = 0.0,
    angle: Annotated[
        str,
        typer.Option(
            "--angle",
            metavar="ANGLE",
            help="Contact angle of a bearing given by its clearance: zero (radial "
            "load) or free (axial load); or any angle, such as '15 deg'.",
        ),
    ] = "zero",
    tolerances: Annotated[
        list[str] | None,
        typer.Option(
            "--tolerance",
            metavar="KEY=VALUE",
            help="Tolerance of ball_diameter or roller_diameter, pitch_diameter, "
            "contact_angle, speed (a fraction) or slip, such as speed=0.01. Repeatable.",
        ),
    ] = None,
    harmonics: Annotated[
        int, typer.Option("--harmonics", metavar="N", help="Harmonics to show, 1 to 100.")
    ] = _HARMONICS,
    sidebands: Annotated[
        int,
        typer.Option(
            "--sidebands", metavar="N", help="Sidebands on either side of each harmonic, 0 to 10."
        ),
    ] = 1,
    json: JsonOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show the fault frequencies of a bearing, also under load.

    BPFO, BPFI, BSF and FTF, from its geometry, and from what rolls under the case's load if any.
    """
    with plain_endings(lang), given.in_force(), in_options(frequencies):
        outputs.check({"--json": json}, bearing)
        from rolamento import tasks

        found = tasks.fault_frequencies(
            bearing,
            speed=speed,
            outer_speed=outer_speed,
            slip=slip,
            angle=angle,
            tolerances=_tolerances(tolerances or []),
            harmonics=harmonics,
            sidebands=sidebands,
            changes=given.settings,
        )
        _show(found, json, outputs)
    failed = found.solved is not None and not found.solved.converged[0]
    raise typer.Exit(NO_RESULT if failed else SOLVED)


def _tolerances(given: list[str]) -> Tolerances:
    from rolamento.units import to_si
    from rolamento.vibration.frequency_band import Tolerances

    found: dict[str, Any] = {}
    try:
        for setting in given:
            key, equals, text = setting.partition("=")
            if not equals or key not in _TOLERANCES:
                raise InputError(
                    said(
                        "must be KEY=VALUE; KEY is one of {tolerances}",
                        tolerances=", ".join(_TOLERANCES),
                    ),
                    value=setting,
                    example="speed=0.01",
                )
            dimension = _TOLERANCES[key]
            value = to_si(text, dimension) if dimension else _part_of_one(key, text)
            found["ball_diameter" if key == "roller_diameter" else key] = value
        return Tolerances(**found)
    except InputError as error:
        raise error.with_details(source="--tolerance") from None


def _part_of_one(key: str, text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise InputError(
            said("must be a fraction"), field=key, value=text, example=f"{key}=0.01"
        ) from None


def _show(found: FrequencyResult, json: str | None, outputs: Outputs) -> None:
    if json is not None:
        put_json(found.to_mapping(), json)
    from rolamento.pages.frequencies import frequencies_page

    outputs.show(lambda: frequencies_page(found), json)
