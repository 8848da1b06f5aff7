"""The case behind a BEARING that is a designation or a case file, with the speeds of options."""

from __future__ import annotations

import os
from collections.abc import Sequence
from math import pi
from typing import TYPE_CHECKING, Final

import rolamento
from rolamento.cli.streams import STANDARD_STREAM
from rolamento.errors import InputError

if TYPE_CHECKING:
    from rolamento.vibration.frequencies import AngleChoice

__all__ = ["angle_of", "at_speeds", "case_of", "has_load", "is_designation"]

_ANGLE_EXAMPLE: Final = "--angle zero, --angle free or --angle '15 deg'"


def is_designation(bearing: str) -> bool:
    """Tell a designation from a file: by its ending, or by its being there."""
    if bearing == STANDARD_STREAM or bearing.lower().endswith((".toml", ".json")):
        return False
    try:
        return not os.path.isfile(bearing)
    except ValueError:
        return True


def case_of(
    bearing: str,
    settings: Sequence[str] = (),
    inner_speed: float | None = None,
    outer_speed: float | None = None,
) -> rolamento.Case:
    """Return the case of a file, or one of a designation without load.

    Parameters
    ----------
    bearing
        Designation, case file, or ``"-"`` for a case on standard input.
    settings
        ``KEY=VALUE``, over the case.
    inner_speed, outer_speed
        Over both (rad/s); None is not given.

    Raises
    ------
    InputError, FileError
        If there is no such bearing, or the file is no case.
    """
    case = _named(bearing, settings) if is_designation(bearing) else None
    if case is None:
        case = rolamento.load_case(bearing, settings)
    return at_speeds(case, inner_speed, outer_speed)


def at_speeds(
    case: rolamento.Case, inner_speed: float | None, outer_speed: float | None
) -> rolamento.Case:
    """Return the case with other speeds of its rings (rad/s); None leaves one as it is.

    Raises
    ------
    InputError
        If a ring cannot turn so fast.
    """
    speeds = (
        ("--speed", "inner_speed", inner_speed),
        ("--outer-speed", "outer_speed", outer_speed),
    )
    for option, field, speed in speeds:
        if speed is not None and speed != getattr(case.duty, field):
            case = _at_speed(case, option, field, speed)
    return case


def _named(designation: str, settings: Sequence[str]) -> rolamento.Case:
    import json

    from rolamento.case import parse_case

    named = {"bearing": {"designation": designation}, "duty": {}}
    try:
        return parse_case(json.dumps(named), format="json", overrides=settings)
    except InputError as error:
        if error.source:
            raise
        # the case behind a designation is none of the user's: no line of it is worth telling
        raise InputError(
            error.rule, field=error.field, value=error.value, example=error.example
        ) from None


def _at_speed(case: rolamento.Case, option: str, field: str, speed: float) -> rolamento.Case:
    from rolamento.case import override
    from rolamento.units import from_si

    given = from_si(speed, "angular_speed")
    try:
        return override(case, [f"duty.{field}={given}"])
    except InputError as error:
        raise InputError(
            error.rule, source=option, value=given, example=f"{option} '1797 rpm'"
        ) from None


def has_load(case: rolamento.Case) -> bool:
    """Tell whether anything presses the balls: a load, a displacement or a preload."""
    from rolamento.case.duty import AXES, LOADS

    duty = case.duty
    given = [getattr(duty.load, name) for name in LOADS]
    given += [getattr(duty.displacement, name) for name in AXES]
    return any(given) or case.bearing.preload is not None


def angle_of(text: str) -> float | AngleChoice:
    """Return the contact angle that ``--angle`` gives (rad), or which of its two choices.

    Raises
    ------
    InputError
        If it is none, or no ball could have it.
    """
    if text == "zero":
        return "zero"
    if text == "free":
        return "free"
    from rolamento.units import to_si

    try:
        angle = to_si(text, "angle")
    except InputError as error:
        raise error.with_details(source="--angle", example=_ANGLE_EXAMPLE) from None
    if not 0.0 <= angle < 0.5 * pi:
        rule = "must be at least 0 deg and less than 90 deg"
        raise InputError(rule, source="--angle", value=text, example=_ANGLE_EXAMPLE)
    return angle
