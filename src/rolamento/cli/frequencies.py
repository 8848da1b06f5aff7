"""`rolamento frequencies`: at which frequencies a bearing tells of damage."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Annotated, Any, Final

import typer

import rolamento
from rolamento.cli.bearing_case import angle_of, case_of, has_load, is_designation
from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    plain_endings,
    words_of,
)
from rolamento.cli.options import (
    BearingArgument,
    JsonOption,
    LagOption,
    LanguageOption,
    OuterSpeedOption,
    SettingsOption,
    SpeedOption,
    csv_option,
)
from rolamento.cli.outputs import check_outputs
from rolamento.cli.quantities import speed_given
from rolamento.cli.streams import STANDARD_STREAM, print_text, put
from rolamento.errors import InputError

if TYPE_CHECKING:
    from rolamento.report.frequencies import FrequencyResult
    from rolamento.vibration.frequencies import AngleChoice
    from rolamento.vibration.frequency_band import Tolerances

__all__ = ["frequencies"]

_HARMONICS: Final = 3
_MOST_HARMONICS: Final = 100
_MOST_SIDEBANDS: Final = 10
_TOLERANCES: Final[dict[str, Any]] = {
    "ball_diameter": "length",
    "pitch_diameter": "length",
    "contact_angle": "angle",
    "speed": None,
    "slip": None,
}
"""What a tolerance may be of, by its dimension; parts have none."""


def frequencies(
    bearing: BearingArgument,
    speed: SpeedOption = None,
    outer_speed: OuterSpeedOption = None,
    slip: LagOption = 0.0,
    angle: Annotated[
        str,
        typer.Option(
            "--angle",
            metavar="ANGLE",
            help="Of a bearing given by its clearance: zero (radial load) or free (axial load);"
            " or any angle, such as '15 deg'.",
        ),
    ] = "zero",
    tolerances: Annotated[
        list[str] | None,
        typer.Option(
            "--tolerance",
            metavar="KEY=VALUE",
            help="How far off ball_diameter, pitch_diameter, contact_angle, speed (a part) or slip"
            " may be, such as speed=0.01. Repeats.",
        ),
    ] = None,
    harmonics: Annotated[
        int, typer.Option("--harmonics", metavar="N", help="Multiples to show, 1 to 100.")
    ] = _HARMONICS,
    sidebands: Annotated[
        int, typer.Option("--sidebands", metavar="N", help="On either side of each, 0 to 10.")
    ] = 1,
    json: JsonOption = None,
    csv: Annotated[str | None, csv_option("Write the lines")] = None,
    settings: SettingsOption = None,
    lang: LanguageOption = None,
) -> None:
    """Show the fault frequencies of a bearing, also under load.

    By its geometry, and of its loaded balls where the case has a load.
    """
    with plain_endings(lang):
        check_outputs({"--json": json, "--csv": csv}, bearing)
        _check_counts(harmonics, sidebands)
        inner, outer = speed_given(speed, "--speed"), speed_given(outer_speed, "--outer-speed")
        case = case_of(bearing, settings or (), inner, outer)
        known_speed = speed or outer_speed or case.duty.inner_speed or case.duty.outer_speed
        found = _found(
            case.title or bearing,
            case,
            None if is_designation(bearing) and not known_speed else case.duty.inner_speed,
            slip,
            angle_of(angle),
            _tolerances(tolerances or []),
            (harmonics, sidebands),
        )
        _show(found, json, csv, lang)
    failed = found.state is not None and not found.state.status.converged
    raise typer.Exit(NO_RESULT if failed else SOLVED)


def _check_counts(harmonics: int, sidebands: int) -> None:
    """Refuse tables without end."""
    for name, least, most, value in (
        ("--harmonics", 1, _MOST_HARMONICS, harmonics),
        ("--sidebands", 0, _MOST_SIDEBANDS, sidebands),
    ):
        if not least <= value <= most:
            raise InputError(f"must be from {least} to {most}", source=name, value=value)


def _tolerances(given: list[str]) -> Tolerances:
    from rolamento.units import to_si
    from rolamento.vibration.frequency_band import Tolerances

    found: dict[str, Any] = {}
    try:
        for setting in given:
            key, equals, text = setting.partition("=")
            if not equals or key not in _TOLERANCES:
                raise InputError(
                    f"must be KEY=VALUE, with a KEY of {', '.join(_TOLERANCES)}",
                    value=setting,
                    example="speed=0.01",
                )
            dimension = _TOLERANCES[key]
            found[key] = to_si(text, dimension) if dimension else _part(key, text)
        return Tolerances(**found)
    except InputError as error:
        raise error.with_details(source="--tolerance") from None


def _part(key: str, text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise InputError("must be a part", field=key, value=text, example=f"{key}=0.01") from None


def _found(
    title: str,
    case: rolamento.Case,
    inner_speed: float | None,
    slip: float,
    angle: float | AngleChoice,
    tolerances: Tolerances,
    counts: tuple[int, int],
) -> FrequencyResult:
    """Find the nominal frequencies, and the loaded ones if the case has a load."""
    from rolamento.report.frequencies import FrequencyResult
    from rolamento.vibration.frequencies import frequencies_of
    from rolamento.vibration.frequency_band import alternatives_of, banded_frequencies

    speeds = (inner_speed, case.duty.outer_speed)
    choices: dict[str, Any] = {"slip": slip, "contact_angle": angle}
    nominal = banded_frequencies(case.bearing, *speeds, tolerances=tolerances, **choices)
    state = rolamento.solve(case) if has_load(case) else None
    return FrequencyResult(
        title=title,
        bearing=case.bearing,
        nominal=nominal,
        loaded=None if state is None else frequencies_of(state, slip=slip),
        state=state,
        alternatives=alternatives_of(case.bearing, *speeds, **choices),
        harmonics=counts[0],
        sidebands=counts[1],
    )


def _show(found: FrequencyResult, json: str | None, csv: str | None, lang: Any) -> None:
    from rolamento.report.frequencies import (
        frequencies_csv,
        frequencies_json,
        frequencies_report,
    )
    from rolamento.report.medium import Medium

    if json is not None:
        put(frequencies_json(found) + "\n", json)
    if csv is not None:
        put(frequencies_csv(found), csv)
    if STANDARD_STREAM not in (json, csv):
        print_text(frequencies_report(found, words_of(lang), Medium.of(sys.stdout)))
