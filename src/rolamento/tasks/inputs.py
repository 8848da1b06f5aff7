"""What people are asked for beside a file: of a signal, of a life test, of a planned one.

Each thing is described once: what it is called, what it means, what it may be. The help of the
commands says the meaning, the page makes its form of all of it, and `given` reads what was typed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from math import isfinite
from typing import Any, Final, Literal

from rolamento.errors import InputError
from rolamento.records import frozen
from rolamento.words import marked, said

__all__ = ["DEMONSTRATION", "LIFE_TEST", "SIGNAL", "Group", "Input", "by_name", "given"]

Kind = Literal[
    "text", "number", "count", "fraction", "frequency", "time", "switch", "choice", "choices",
    "list",
]  # fmt: skip
"""Kind of a value: text with or without a unit, a number, one of several, several of them."""
_LONGEST: Final = 300
_MOST: Final = 50


@frozen
class Input:
    """One thing that may be given.

    Attributes
    ----------
    name
        parameter of the task
    label, meaning
        marked; the meaning is a sentence or two
    kind
        what is typed
    example
        of a value
    choices
        returns the values that it may have, with their labels, marked; those that are no words of
        a language are their own labels
    default
        as it is typed; empty where the task or the file decides
    essential
        whether it is seen at once
    """

    name: str
    label: str
    meaning: str = ""
    kind: Kind = "text"
    example: str = ""
    choices: Callable[[], Mapping[str, str]] | None = None
    default: str = ""
    essential: bool = False

    def described(self) -> dict[str, Any]:
        """Return it as plain data, in the language that is spoken."""
        choices = {} if self.choices is None else self.choices()
        return {
            "name": self.name,
            "label": said(self.label),
            "meaning": said(self.meaning) if self.meaning else "",
            "kind": self.kind,
            "example": self.example,
            "choices": [
                {"value": value, "label": said(label).strip() if label else value}
                for value, label in choices.items()
            ],
            "default": self.default,
            "essential": self.essential,
        }


Group = tuple[str, tuple[Input, ...]]
"""A heading, marked, and what stands below it."""


def _marks() -> Mapping[str, str]:
    return {"point": marked("point: 12.5"), "comma": marked("comma: 12,5")}


def _orders() -> Mapping[str, str]:
    return {"day_first": marked("day first"), "month_first": marked("month first")}


def _supports() -> Mapping[str, str]:
    return {"rigid": marked("rigid"), "flexible": marked("flexible")}


def _fits() -> Mapping[str, str]:
    from rolamento.pages.weibull import FITS as LABELS
    from rolamento.tasks.weibull import FITS

    return {name: LABELS[method] for name, method in FITS.items()}


def _bounds() -> Mapping[str, str]:
    from rolamento.pages.weibull import BOUND_METHODS
    from rolamento.tasks.weibull import bounds_known

    return {name: BOUND_METHODS[name.replace("-", "_")] for name in bounds_known()}


_DECIMAL_MARK: Final = Input(
    "decimal_mark",
    marked("Decimal mark"),
    marked("Decimal mark, point or comma, for a table in which 12.500 may be 12.5 or 12500."),
    "choice",
    choices=_marks,
)

SIGNAL: Final[tuple[Group, ...]] = (
    (
        marked("Bearing"),
        (
            Input(
                "bearing",
                marked("Bearing"),
                marked(
                    "Designation; left empty, the bearing and the load of the case on the page."
                ),
                example="6205",
                essential=True,
            ),
            Input(
                "nominal",
                marked("Without the load"),
                marked("Search the frequencies of the geometry, whatever the load."),
                "switch",
            ),
            Input(
                "angle",
                marked("Contact angle"),
                marked(
                    "Contact angle without a load: zero (radial load, the default) or "
                    "free (axial load) of a bearing given by its clearance; or any "
                    "angle, such as '15 deg'."
                ),
                example="15 deg",
            ),
        ),
    ),
    (
        marked("Speed"),
        (
            Input(
                "speed",
                marked("Shaft speed"),
                marked(
                    "Steady speed of the inner ring, such as '1797 rpm'; by default "
                    "that of the file, or else of the case."
                ),
                example="1797 rpm",
                essential=True,
            ),
            Input(
                "outer_speed",
                marked("Speed of the outer ring"),
                marked("Speed of the outer ring, with its sign."),
                example="0 rpm",
            ),
            Input(
                "speed_channel",
                marked("Channel of the speed"),
                marked(
                    "Channel of the same file with the shaft speed at each sample, by name or"
                    " number."
                ),
                example="2",
            ),
            Input(
                "speed_unit",
                marked("Unit of that channel"),
                marked("Unit of that channel: rpm, rad/s, deg/s or Hz, if the file gives none."),
                "choice",
                choices=lambda: {"rpm": "", "rad/s": "", "deg/s": "", "Hz": ""},
            ),
            Input(
                "tacho",
                marked("Channel of the tachometer"),
                marked(
                    "Channel of the same file with tachometer pulses of the shaft; "
                    "held in memory, up to 20 million samples."
                ),
                example="2",
            ),
            Input(
                "pulses",
                marked("Pulses per revolution"),
                marked("Tachometer pulses per revolution (default 1)."),
                "count",
                example="1",
            ),
            Input(
                "track",
                marked("Track the speed"),
                marked(
                    "Find the varying speed in the vibration itself, around the shaft speed given"
                    " above; at least 96 revolutions."
                ),
                "switch",
            ),
            Input(
                "within",
                marked("Greatest deviation of the speed"),
                marked("Of a tracked speed from the one given: up to 30 % (default 10 %)."),
                "fraction",
                example="10 %",
            ),
        ),
    ),
    (
        marked("Signal"),
        (
            Input(
                "unit",
                marked("Unit of the samples"),
                marked(
                    "Unit of the samples: m/s^2, g, mm/s, um …; V or counts if they "
                    "are not calibrated."
                ),
                example="m/s^2",
                essential=True,
            ),
            Input(
                "rate",
                marked("Sampling rate"),
                marked("Sampling rate, such as '50 kHz', instead of that in the file."),
                "frequency",
                example="50 kHz",
                essential=True,
            ),
            Input(
                "channel",
                marked("Channel or variable"),
                marked("Channel, by name or by number from 1."),
                example="1",
                essential=True,
            ),
            Input(
                "scale",
                marked("Sensitivity of the sensor"),
                marked("Sensitivity of the sensor, such as '100 mV/g'."),
                example="100 mV/g",
            ),
            Input(
                "start",
                marked("Start"),
                marked("Start of the part to analyse, such as '2 s'."),
                "time",
                example="2 s",
            ),
            Input(
                "duration",
                marked("Duration"),
                marked("Duration of the part to analyse; by default to the end."),
                "time",
                example="10 s",
            ),
            _DECIMAL_MARK,
        ),
    ),
    (
        marked("Machine"),
        (
            Input(
                "power",
                marked("Rated power"),
                marked("Rated power of the machine, such as '45 kW' or '60 cv': gives its group."),
                example="45 kW",
                essential=True,
            ),
            Input(
                "support",
                marked("Support"),
                marked("Support: rigid or flexible."),
                "choice",
                choices=_supports,
                essential=True,
            ),
            Input(
                "group",
                marked("Group of ISO 20816-3"),
                marked("Group of ISO 20816-3, 1 or 2, instead."),
                "choice",
                choices=lambda: {"1": "", "2": ""},
            ),
            Input(
                "machine_class",
                marked("Class of ISO 10816-1"),
                marked("Class of ISO 10816-1, I to IV, instead of a group."),
                "choice",
                choices=lambda: {"I": "", "II": "", "III": "", "IV": ""},
            ),
            Input(
                "baseline",
                marked("Usual velocity"),
                marked("Usual RMS velocity of the machine, such as '1.2 mm/s': sets the alarm."),
                example="1.2 mm/s",
            ),
        ),
    ),
    (
        marked("Search"),
        (
            Input(
                "tolerance",
                marked("Slip of the cage"),
                marked("Maximum deviation of the cage from its expected speed, 0 to 0.1."),
                "fraction",
                example="2 %",
                default="2 %",
            ),
            Input(
                "speed_tolerance",
                marked("Uncertainty of the speed"),
                marked(
                    "Uncertainty of a steady speed, such as '3 %', up to 10 %; 0 if it "
                    "is exact. It is corrected by the peaks of the shaft itself."
                ),
                "fraction",
                example="3 %",
                default="3 %",
            ),
            Input(
                "false_alarm",
                marked("False alarms"),
                marked(
                    "Probability that noise without peaks of the bearing gives any "
                    "finding, up to 0.5."
                ),
                "fraction",
                example="1 %",
                default="1 %",
            ),
        ),
    ),
)
"""Inputs of `rolamento.tasks.diagnose` and `vibration_severity`."""

LIFE_TEST: Final[tuple[Group, ...]] = (
    (
        marked("Results"),
        (
            Input(
                "reliabilities",
                marked("Reliabilities"),
                marked(
                    "Reliability to give lives for, 0.9 for L10. Repeatable; by default 0.9 and"
                    " 0.5."
                ),
                "list",
                example="0.9; 0.5",
                default="0.9; 0.5",
                essential=True,
            ),
            Input(
                "times",
                marked("Times"),
                marked("Time to give the reliability at, such as '100 h'. Repeatable."),
                "list",
                example="100 h; 500 h",
                essential=True,
            ),
            Input(
                "calculated",
                marked("Calculated life"),
                marked(
                    "Calculated life to compare with the data, such as 'ISO 281=58 h', "
                    "for the first reliability. Repeatable."
                ),
                "list",
                example="ISO 281=58 h",
                essential=True,
            ),
        ),
    ),
    (
        marked("Bounds"),
        (
            Input(
                "confidence",
                marked("Confidence of bounds"),
                marked("Confidence of the bounds, such as 0.9."),
                "fraction",
                example="0.9",
                default="0.9",
                essential=True,
            ),
            Input(
                "sides",
                marked("Sides of the bounds"),
                marked("Sides of the bounds: two, lower or upper."),
                "choice",
                choices=lambda: {
                    "two": marked("lower and upper"),
                    "lower": marked("lower only"),
                    "upper": marked("upper only"),
                },
                default="two",
            ),
            Input(
                "bounds",
                marked("Method of the bounds"),
                marked("Left empty, a method that is exact with few failures."),
                "choice",
                choices=_bounds,
            ),
        ),
    ),
    (
        marked("Fit"),
        (
            Input(
                "method",
                marked("Methods of fitting"),
                marked("By default the first four; the bounds refer to the first one chosen."),
                "choices",
                choices=_fits,
            ),
            Input(
                "models",
                marked("Other distributions beside"),
                marked(
                    "Fit other distributions beside, with their likelihoods; by default where the"
                    " data contradict Weibull's."
                ),
                "switch",
            ),
            Input(
                "shape",
                marked("Shape from experience"),
                marked("Shape from experience: only the scale is fitted (Weibayes)."),
                "number",
                example="1.5",
            ),
            Input(
                "prior",
                marked("Range of the shape"),
                marked("90 % range of the shape: gives a posterior as well."),
                example="1..2.5",
            ),
        ),
    ),
    (
        marked("Data"),
        (
            Input(
                "by_group",
                marked("Compare the groups"),
                marked("Each group by itself, and compared; or all together."),
                "switch",
                default="true",
                essential=True,
            ),
            Input(
                "by_mode",
                marked("Separate the failure modes"),
                marked(
                    "Each failure mode by itself, the others as suspensions, and all of them put"
                    " together; or all failures alike."
                ),
                "switch",
                default="true",
                essential=True,
            ),
            Input(
                "only_mode",
                marked("Only this failure mode"),
                marked("Only this failure mode: failures by others are suspensions."),
                example="fatigue",
            ),
            Input(
                "only",
                marked("Only these groups"),
                marked("Only this group. Repeatable."),
                "list",
                example="I; II",
            ),
            Input(
                "unit",
                marked("Unit of the times"),
                marked("Unit of the times, if the file says another."),
                example="h",
            ),
            Input(
                "time",
                marked("Column of the times"),
                marked("Column of the times, if named otherwise."),
                example="hours",
            ),
            Input(
                "status",
                marked("Column of the status"),
                marked("Column that says what failed, if named otherwise."),
                example="status",
            ),
            Input(
                "count",
                marked("Column of the counts"),
                marked("Column of how many bearings a row stands for, if named otherwise."),
                example="count",
            ),
            Input(
                "group",
                marked("Column of the groups"),
                marked("Column of the groups, if named otherwise."),
                example="group",
            ),
            Input(
                "mode",
                marked("Column of the failure modes"),
                marked("Column of the failure modes, if named otherwise."),
                example="mode",
            ),
            Input(
                "start",
                marked("Column of the first day in service"),
                marked(
                    "Column of the days on which bearings went into service, for lives between"
                    " two dates, if named otherwise."
                ),
                example="installed",
            ),
            Input(
                "end",
                marked("Column of the last day in service"),
                marked(
                    "Column of the days on which bearings failed or were removed, if named"
                    " otherwise."
                ),
                example="failure date",
            ),
            Input(
                "use_per_day",
                marked("Use per day"),
                marked(
                    "What a bearing runs a day, such as '16 h', for lives between two dates; by"
                    " default lives are in days."
                ),
                example="16 h",
            ),
            Input(
                "as_of",
                marked("Day of the data"),
                marked(
                    "Day of the data, such as 2026-12-31: bearings without a second date were"
                    " running then."
                ),
                example="2026-12-31",
            ),
            Input(
                "date_order",
                marked("Order of the dates"),
                marked("Order of dates, for a table in which 03/04/2024 may be either."),
                "choice",
                choices=_orders,
            ),
            _DECIMAL_MARK,
        ),
    ),
)
"""Inputs of `rolamento.tasks.life_test_study`, and the columns of a table."""

DEMONSTRATION: Final[tuple[Group, ...]] = (
    (
        marked("Plan a test"),
        (
            Input(
                "life",
                marked("Life to demonstrate"),
                marked("Life to demonstrate, such as '1000 h'."),
                example="1000 h",
                essential=True,
            ),
            Input(
                "bearings",
                marked("Bearings"),
                marked("Available bearings: the test time is calculated."),
                "count",
                example="10",
                essential=True,
            ),
            Input(
                "time",
                marked("Test time"),
                marked("Test time of each bearing: their number is calculated."),
                example="500 h",
                essential=True,
            ),
            Input(
                "failures_allowed",
                marked("Failures allowed"),
                marked("Failures with which the test is still passed."),
                "count",
                example="0",
                default="0",
                essential=True,
            ),
            Input(
                "shape",
                marked("Shape"),
                marked("Expected shape of the Weibull distribution."),
                "number",
                example="1.5",
                default="1.5",
                essential=True,
            ),
            Input(
                "reliability",
                marked("Reliability"),
                marked("Reliability of the life: 0.9 for L10."),
                "fraction",
                example="0.9",
                default="0.9",
                essential=True,
            ),
            Input(
                "confidence",
                marked("Confidence"),
                marked("Confidence level, such as 0.9."),
                "fraction",
                example="0.9",
                default="0.9",
                essential=True,
            ),
        ),
    ),
)
"""Inputs of `rolamento.tasks.demonstration_study`."""


def by_name(groups: Sequence[Group]) -> dict[str, Input]:
    """Return what is asked for by its names."""
    return {one.name: one for _, many in groups for one in many}


def given(groups: Sequence[Group], typed: Mapping[str, Sequence[str]]) -> dict[str, Any]:
    """Read what was typed; what is left empty has its default, or is not there.

    Parameters
    ----------
    groups
        What may be given.
    typed
        Texts by names; several only of kinds that take several.

    Returns
    -------
    dict
        Values by names: SI of frequencies and times, parts of one of fractions, a tuple of lists.

    Raises
    ------
    InputError
        For a name that is not asked for, or a value that is not of its kind.
    """
    known = by_name(groups)
    for name in typed:
        if name not in known:
            rule = said("is not asked for here; known: {known}", known=", ".join(known))
            raise InputError(rule, field=name)
    found: dict[str, Any] = {}
    for name, one in known.items():
        texts = [text.strip() for text in typed.get(name, ()) if text.strip()]
        if any(len(text) > _LONGEST for text in texts) or len(texts) > _MOST:
            rule = said("must be at most {most} characters long", most=_LONGEST)
            raise InputError(rule, field=name, value=texts[0], example=one.example)
        if not texts and one.default:
            texts = [one.default]
        if texts:
            found[name] = _value(one, texts)
    return found


def _value(one: Input, texts: list[str]) -> Any:
    if one.kind == "list":
        parts = [part.strip() for text in texts for part in text.split(";")]
        return tuple(dict.fromkeys(filter(None, parts)))
    if one.kind == "choices":
        return tuple(_chosen(one, text) for text in texts)
    text = texts[-1]
    if one.kind == "choice":
        return _chosen(one, text)
    if one.kind == "switch":
        return text == "true"
    if one.kind in ("frequency", "time"):
        from rolamento.tasks.quantities import number_given

        return number_given(_with_point(text), one.name, one.kind, one.example)
    if one.kind == "fraction":
        from rolamento.tasks.quantities import part_of_one

        return part_of_one(_with_point(text), one.name, one.example)
    if one.kind in ("number", "count"):
        return number_in(text, one.name, one.example, whole=one.kind == "count")
    return text


def number_in(text: str, name: str, example: str, *, whole: bool = False) -> float | int:
    """Return the number of a text, its decimal mark a point or a comma.

    Raises
    ------
    InputError
        If it is none.
    """
    try:
        value = float(_with_point(text))
    except ValueError:
        value = float("nan")
    if not isfinite(value) or (whole and (value != int(value) or abs(value) > 1e9)):
        rule = said("must be an integer") if whole else said("must be a number")
        raise InputError(rule, field=name, value=text, example=example)
    return int(value) if whole else value


def _with_point(text: str) -> str:
    """Return a number with a decimal comma as one with a point."""
    return text.replace(",", ".") if text.count(",") == 1 and "." not in text else text


def _chosen(one: Input, text: str) -> str:
    known = {} if one.choices is None else one.choices()
    if text not in known:
        rule = said("must be one of {known}", known=", ".join(known))
        raise InputError(rule, field=one.name, value=text, example=next(iter(known), ""))
    return text
