"""The bearing that a task is about: name, speeds, contact angle, whether it is loaded."""

from __future__ import annotations

from math import pi
from typing import TYPE_CHECKING

from rolamento.case import Case, override
from rolamento.case.bearing import Bearing
from rolamento.case.duty import AXES, LOADS
from rolamento.case.roller_bearing import RollerBearing
from rolamento.errors import InputError, arguments, phrase
from rolamento.units import from_si, readable, to_si
from rolamento.words import marked, said

if TYPE_CHECKING:
    from rolamento.vibration.frequencies import AngleChoice


def designated(designation: str, parameter: str = "bearing") -> Case:
    """Return the bearing of a designation without a load; no file is looked for by its name.

    Raises
    ------
    InputError
        If there is no such designation; parameter: what to call it.
    """
    try:
        case = Case.from_mapping({"bearing": {"designation": designation}, "duty": {}})
    except InputError as error:
        example = arguments(**{parameter: "6205"})
        raise error.with_details(field=parameter, value=designation, example=example) from None
    return case if case.title else case.replace(title=designation)


def at_speeds(case: Case, inner_speed: float | None, outer_speed: float | None) -> Case:
    """Return the case with other speeds of its rings (rad/s); None leaves one as it is.

    Raises
    ------
    InputError
        If a ring cannot turn so fast.
    """
    for parameter, field, speed in (
        ("speed", "inner_speed", inner_speed),
        ("outer_speed", "outer_speed", outer_speed),
    ):
        if speed is None or speed == getattr(case.duty, field):
            continue
        given = from_si(speed, "angular_speed")
        try:
            case = override(case, [f"duty.{field}={given}"])
        except InputError as error:
            example = arguments(**{parameter: "1797 rpm"})
            value = readable(speed, "angular_speed")
            raise InputError(error.rule, field=parameter, value=value, example=example) from None
    return case


def has_load(case: Case) -> bool:
    """Return whether anything presses the balls: a load, a displacement or a preload."""
    duty = case.duty
    given = [getattr(duty.load, name) for name in LOADS]
    given += [getattr(duty.displacement, name) for name in AXES]
    return any(given) or case.bearing.preload is not None


def angle_of(given: str | float, bearing: Bearing | RollerBearing) -> float | AngleChoice:
    """Return a contact angle that is given for a bearing (rad), or which of its two choices.

    Raises
    ------
    InputError
        If it is none, no ball could have it, or the bearing has rollers.
    """
    if given == "zero":
        return "zero"
    if given == "free":
        return "free"
    if isinstance(bearing, RollerBearing):
        rule = said("is of ball bearings; rollers keep the angles of their raceways")
        example = 'bearing.contact_angle = "14 deg"'
        raise InputError(rule, field="angle", value=given, example=example)
    try:
        angle = to_si(given, "angle") if isinstance(given, str) else given
    except InputError as error:
        raise error.with_details(field="angle", example=_angle_example()) from None
    if not 0.0 <= angle < 0.5 * pi:
        rule = said("must be at least 0° and less than 90°")
        raise InputError(rule, field="angle", value=given, example=_angle_example())
    return angle


def _angle_example() -> str:
    choices = (arguments(angle=angle) for angle in ("zero", "free", "15 deg"))
    first, second, third = choices
    return phrase(marked("{first}, {second} or {third}"), first=first, second=second, third=third)
