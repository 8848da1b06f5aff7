"""One output of a case over one of its fields: what a page draws as a curve."""

from __future__ import annotations

from math import inf, nextafter
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

from rolamento.case import Case
from rolamento.errors import InputError
from rolamento.records import frozen
from rolamento.status import STATUS_NAMES
from rolamento.studies.axes import Axis
from rolamento.studies.fields import Field, known_fields, no_range, read_field
from rolamento.studies.outputs import Output, catalogue, outputs_of, refuse_missing
from rolamento.studies.plan import Part, Plan
from rolamento.studies.solving import CONVERGED
from rolamento.studies.study import Study
from rolamento.tasks.report import number_of_field, with_life
from rolamento.words import Note, said

__all__ = [
    "Curve",
    "Scale",
    "bounds_of",
    "curve_over",
    "fields_over",
    "outputs_over",
    "usual_range",
]

Floats = NDArray[np.float64]
Scale = Literal["linear", "log"]

POINTS: Final = 61
_WIDER: Final = 10.0
"""A logarithmic range goes from a tenth to ten times the present value."""
_LEAST, _MOST = 0.25, 2.0
"""A linear one from a quarter to twice the present value,"""
_DEGREES: Final = 40.0
"""and of temperatures so many kelvins up and down."""
_INSIDE: Final = 1e-3
"""Fraction of the way between limits that are not in the range themselves."""
_OFFERED: Final = ("duty.", "bearing.", "lubricant.", "temperature.", "mounting.", "life.")
_NOT_OFFERED: Final = frozenset({"residual", "weakest_row", "weakest_ball", "lift_row", "lost_row"})
_ALWAYS: Final = ("duty.inner_speed", "duty.load.fx", "duty.load.fz", "duty.displacement.ry")


@frozen(eq=False)
class Curve:
    """An output of a case over one of its fields.

    Attributes
    ----------
    case
        what does not vary
    field, output
        which
    values
        of the field, rising, SI; the present one among them, (points,)
    numbers
        the output there, in its unit; NaN without a result, (points,)
    status
        how the solution of each point ended, (points,)
    present
        place of the case itself among the points; None where it has no such number
    reasons
        why points have no result, each once
    """

    case: Case
    field: Field
    output: Output
    values: Floats
    numbers: Floats
    status: NDArray[np.str_]
    present: int | None
    reasons: tuple[Note, ...]

    @property
    def missing(self) -> NDArray[np.bool_]:
        """Which points have no number, (points,)."""
        return np.asarray(np.isnan(self.numbers) | (self.status != CONVERGED))


def curve_over(
    case: Case,
    field: str,
    output: str,
    low: object = None,
    high: object = None,
    *,
    scale: Scale = "linear",
    points: int = POINTS,
) -> Curve:
    """Solve a case over a range of one of its fields.

    Parameters
    ----------
    case
        Whose other fields stay as they are.
    field
        Dotted name of a continuous field.
    output
        A name of the catalogue of outputs that has one number a case.
    low, high
        Ends of the range as a case file has them; by default around the present value.
    scale
        Equal steps, or equal ratios.
    points
        How many, 2 to 201; the present value comes besides.

    Raises
    ------
    InputError
        If the field takes no range, the case lacks what the output rests on, or an end is out of
        bounds.
    """
    known = _continuous(field)
    found = _whole(output)
    if not 2 <= points <= 201:
        raise InputError(said("must be 2 to {most}", most=201), field="points", value=points)
    case = with_life(case)
    refuse_missing([found], case, (field,))
    usual = usual_range(case, known, scale)
    ends = [
        usual[place] if given is None or given == "" else _end(known, given, name)
        for place, (name, given) in enumerate((("low", low), ("high", high)))
    ]
    if not ends[0] < ends[1]:
        raise InputError(
            said("must be greater than the first"), field="high", value=known.written(ends[1])
        )
    if scale == "log" and not ends[0] > 0.0:
        raise InputError(
            said("must be greater than zero on a logarithmic scale"),
            field="low",
            value=known.written(ends[0]),
        )
    space = np.geomspace if scale == "log" else np.linspace
    values = space(ends[0], ends[1], points).astype(np.float64)
    values[[0, -1]] = ends  # rounding must not carry them over a bound
    own = number_of_field(case, field)
    if own is not None:
        values = np.unique(np.append(values, own))
    part = _solved(Study(case=case, outputs=(output,), axes=(Axis(field=field, values=values),)))
    codes = part.arrays["status"]
    status = np.array([STATUS_NAMES[int(code)] for code in codes], np.str_)
    numbers = np.where(status == CONVERGED, part.arrays[output], np.nan).astype(np.float64)
    present = None if own is None else int(np.searchsorted(values, own))
    return Curve(case, known, found, values, numbers, status, present, part.reasons)


def _solved(study: Study) -> Part:
    plan = Plan(study)
    return Part.joined([plan.solve(index, threads=None) for index in range(plan.chunks)])


def usual_range(case: Case, field: Field, scale: Scale = "linear") -> tuple[float, float]:
    """Return a range around the present value of a field, within its bounds; SI.

    Parameters
    ----------
    case
        That has the value; without one the range is made around the field's example.
    field
        A continuous one.
    scale
        Wider where it is logarithmic.
    """
    own = number_of_field(case, field.name)
    least, most = bounds_of(field)
    if not own:  # none, or zero, around which nothing has a size
        text = field.example.strip('"')
        size = abs(float(field.checked(text if field.dimension else float(text), in_file=True)))
        low, high = (0.0 if own is None or least >= 0.0 else -size), size
        if scale == "log":
            low = size / _WIDER**2
    elif field.dimension == "temperature":
        low, high = own - _DEGREES, own + _DEGREES
    elif scale == "log":
        low, high = abs(own) / _WIDER, abs(own) * _WIDER
    else:
        low, high = sorted((_LEAST * own, _MOST * own))
    if np.isfinite(least) and np.isfinite(most):
        room = _INSIDE * min(most - least, high - low)
        least, most = least + room, most - room
    elif np.isfinite(least) and least != 0.0:
        least += _INSIDE * abs(least)
    low, high = max(low, least), min(high, most)
    return low, high


def bounds_of(field: Field) -> tuple[float, float]:
    """Return the least and the greatest value that a field may have, SI."""
    limits = {} if field.bounds is None else field.bounds.limits_in_si
    least = limits.get("at_least", -inf)
    if "above" in limits:
        least = max(least, nextafter(limits["above"], inf))
    most = limits.get("at_most", inf)
    if "below" in limits:
        most = min(most, nextafter(limits["below"], -inf))
    return least, most


def _end(field: Field, given: object, name: str) -> float:
    if field.dimension is None and isinstance(given, str):
        try:
            given = float(given)
        except ValueError:
            raise InputError(said("must be a number"), field=name, value=given) from None
    try:
        return float(field.checked(given, in_file=True))
    except InputError as error:
        raise error.with_details(field=name) from None


def _continuous(name: str) -> Field:
    field = read_field(name)
    if not field.continuous:
        raise InputError(no_range(name), field="field", value=name,
                         example='"duty.load.fz"')  # fmt: skip
    return field


def _whole(name: str) -> Output:
    (output,) = outputs_of([name])
    if output.along:
        raise InputError(
            said("has more than one number a case"), field="output", value=name,
            example='"max_inner_load"',
        )  # fmt: skip
    return output


def fields_over(case: Case) -> list[Field]:
    """Return the continuous fields that a case has numbers of, and the usual loads and speeds."""
    return [
        field
        for name, field in known_fields().items()
        if field.continuous
        and name.startswith(_OFFERED)
        and (name in _ALWAYS or number_of_field(case, name) is not None)
    ]


def outputs_over(case: Case) -> list[Output]:
    """Return the outputs of one number a case that a case has what they rest on for."""
    case = with_life(case)
    return [
        own
        for own in catalogue().values()
        if not own.along
        and own.kind == "real"
        and own.name not in _NOT_OFFERED
        and _possible(own, case)
    ]


def _possible(output: Output, case: Case) -> bool:
    try:
        refuse_missing([output], case, ())
    except InputError:
        return False
    return True
