"""`rolamento frequencies`: at which frequencies a bearing tells of damage."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING, Annotated, Any, Final

import typer

import rolamento
from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    JsonOption,
    LanguageOption,
    SettingsOption,
    plain_endings,
    same_file,
    words_of,
)
from rolamento.cli.streams import STANDARD_STREAM, print_text, put
from rolamento.errors import FileError, InputError

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
    bearing: Annotated[
        str,
        typer.Argument(
            metavar="BEARING",
            help="Designation such as 6205, or a case file; - is a case on standard input.",
        ),
    ],
    speed: Annotated[
        str | None,
        typer.Option("--speed", metavar="SPEED", help="Of the inner ring, such as '1797 rpm'."),
    ] = None,
    outer_speed: Annotated[
        str | None,
        typer.Option("--outer-speed", metavar="SPEED", help="Of the outer ring; signed as well."),
    ] = None,
    slip: Annotated[
        float,
        typer.Option(
            "--slip", metavar="PART", help="By which the cage lags, such as 0.01; -1 to 1."
        ),
    ] = 0.0,
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
    csv: Annotated[
        str | None,
        typer.Option("--csv", metavar="FILE", help="Write the lines; - is standard output."),
    ] = None,
    settings: SettingsOption = None,
    lang: LanguageOption = None,
) -> None:
    """Show the fault frequencies of a bearing, by its geometry and under load."""
    with plain_endings(lang):
        _check(bearing, json, csv, harmonics, sidebands)
        case = _case(bearing, speed, outer_speed, settings or [])
        known_speed = speed or outer_speed or case.duty.inner_speed or case.duty.outer_speed
        found = _found(
            bearing if _is_designation(bearing) else case.title or bearing,
            case,
            None if _is_designation(bearing) and not known_speed else case.duty.inner_speed,
            slip,
            _angle(angle),
            _tolerances(tolerances or []),
            (harmonics, sidebands),
        )
        _show(found, json, csv, lang)
    failed = found.state is not None and not found.state.status.converged
    raise typer.Exit(NO_RESULT if failed else SOLVED)


def _check(bearing: str, json: str | None, csv: str | None, harmonics: int, sidebands: int) -> None:
    """Refuse outputs that would run into each other, and tables without end."""
    if json is not None and json == csv:
        where = "standard output" if json == STANDARD_STREAM else json
        raise InputError("only one of --json and --csv can go there", source=where)
    for path in (json, csv):
        if path is not None and same_file(path, bearing):
            raise FileError("is the case file itself; choose another name", source=path)
    for name, least, most, value in (
        ("--harmonics", 1, _MOST_HARMONICS, harmonics),
        ("--sidebands", 0, _MOST_SIDEBANDS, sidebands),
    ):
        if not least <= value <= most:
            raise InputError(f"must be from {least} to {most}", source=name, value=value)


def _is_designation(bearing: str) -> bool:
    """Tell a designation from a file: by its ending, or by its being there."""
    if bearing == STANDARD_STREAM or bearing.lower().endswith((".toml", ".json")):
        return False
    try:
        return not os.path.isfile(bearing)
    except ValueError:
        return True


def _case(
    bearing: str, speed: str | None, outer_speed: str | None, settings: list[str]
) -> rolamento.Case:
    """Return the case of a file, or one of a designation without load; speeds over both."""
    import json

    from rolamento.case import parse_case
    from rolamento.units import from_si, to_si

    for option, name, text in (
        ("--speed", "inner_speed", speed),
        ("--outer-speed", "outer_speed", outer_speed),
    ):
        if text is not None:
            try:
                value = to_si(text, "angular_speed")
            except InputError as error:
                raise error.with_details(source=option) from None
            settings = [*settings, f"duty.{name}={from_si(value, 'angular_speed')}"]
    if not _is_designation(bearing):
        return rolamento.load_case(bearing, settings)
    named = {"bearing": {"designation": bearing}, "duty": {}}
    try:
        return parse_case(json.dumps(named), format="json", overrides=settings)
    except InputError as error:
        if error.source:
            raise
        # the file behind it is none of the user's: no line of it is worth telling
        raise InputError(
            error.rule, field=error.field, value=error.value, example=error.example
        ) from None


def _angle(text: str) -> float | AngleChoice:
    if text == "zero":
        return "zero"
    if text == "free":
        return "free"
    from rolamento.units import to_si

    try:
        return to_si(text, "angle")
    except InputError as error:
        raise error.with_details(source="--angle", example="zero, free or '15 deg'") from None


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
    state = rolamento.solve(case) if _has_load(case) else None
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


def _has_load(case: rolamento.Case) -> bool:
    """Tell whether anything presses the balls: a load, a displacement or a preload."""
    from rolamento.duty import AXES, LOADS

    duty = case.duty
    given = [getattr(duty.load, name) for name in LOADS]
    given += [getattr(duty.displacement, name) for name in AXES]
    return any(given) or case.bearing.preload is not None


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
