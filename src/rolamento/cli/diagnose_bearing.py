"""The bearing of `rolamento diagnose`, and the frequencies at which it would tell of damage."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import isfinite, pi
from typing import TYPE_CHECKING, Final

import rolamento
from rolamento.cli.bearing_case import angle_of, at_speeds, case_of, has_load
from rolamento.errors import InputError

if TYPE_CHECKING:
    from rolamento.state import State
    from rolamento.vibration.diagnosis import DiagnosisSettings, FaultOrders
    from rolamento.vibration.frequencies import FaultFrequencies

__all__ = ["GivenBearing", "Search", "Sought", "bearing_of", "searched", "sought"]

_WIDEST: Final = 0.1
"""Part by which a cage may be off in a search."""


@dataclass(frozen=True, slots=True)
class GivenBearing:
    """A bearing by its designation or of a case file, with its duty."""

    name: str
    case: rolamento.Case

    @property
    def speeds(self) -> tuple[float | None, float | None]:
        """Of the inner and the outer ring; rad/s, None if not given."""
        return self.case.duty.inner_speed or None, self.case.duty.outer_speed or None


@dataclass(frozen=True, slots=True)
class Sought:
    """The frequencies to look for, and the loaded bearing's state, if one was asked for."""

    frequencies: FaultFrequencies
    state: State | None


@dataclass(frozen=True, slots=True)
class Search:
    """How widely to look.

    Attributes
    ----------
    settings
        with a tolerance that covers the range over the balls
    slip
        the tolerance before that, if the range is wider; else None
    covers_balls
        whether all loaded balls are covered: a search has its widest
    other_rows
        rows of a set, counted from 0, that are not
    """

    settings: DiagnosisSettings
    slip: float | None
    covers_balls: bool
    other_rows: tuple[int, ...]


def bearing_of(text: str, settings: list[str]) -> GivenBearing:
    """Return the bearing of a designation or a case file.

    Parameters
    ----------
    text
        A designation is a case with that bearing and no load.
    settings
        ``KEY=VALUE``, over the case.

    Raises
    ------
    InputError, FileError
        If there is no such bearing, or the file is no case.
    """
    try:
        case = case_of(text, settings)
    except InputError as error:
        if error.field != "bearing.designation" or error.source:
            raise
        raise InputError(
            error.rule, value=error.value, source="--bearing", example="--bearing 6205"
        ) from None
    return GivenBearing(case.title or text, case)


def sought(
    given: GivenBearing, inner: float, outer: float, *, nominal: bool, angle: str | None
) -> Sought:
    """Return the frequencies to look for at some speeds of the rings (rad/s).

    Those of the loaded bearing, where its case has a load and a solution; else those of the
    geometry, with the contact angle that is wanted.

    Raises
    ------
    InputError
        If an angle is given beside a load, or is none, or no ball rolls.
    """
    from rolamento.vibration.frequencies import frequencies_of, nominal_frequencies

    loaded = has_load(given.case) and not nominal
    if loaded and angle is not None:
        raise InputError(
            "goes with the geometry's frequencies; here a load makes the angle",
            source="--angle",
            value=angle,
            example="--nominal --angle free",
        )
    if inner == outer:
        raise InputError(
            "is that of the inner ring as well: no ball rolls",
            source="--outer-speed",
            value=_rpm(outer),
            example="--outer-speed '0 rpm'",
        )
    case = at_speeds(given.case, inner, outer)
    state = rolamento.solve(case) if loaded else None
    if state is not None and state.status.converged:
        found = frequencies_of(state)
        if isfinite(found.cage.order):
            return Sought(found, state)
    choice = angle_of("zero" if angle is None else angle)
    found = nominal_frequencies(case.bearing, inner, outer, contact_angle=choice)
    return Sought(found, state)


def searched(frequencies: FaultFrequencies, settings: DiagnosisSettings) -> Search:
    """Widen a search, as far as it may be, to the orders of all loaded balls."""
    from rolamento.vibration.diagnosis import FaultOrders

    orders = FaultOrders.of(frequencies)
    own, slip = _range(frequencies, frequencies, orders), settings.tolerance
    tolerance = max(slip, min(own, _WIDEST))
    others = [row for row in frequencies.rows if row.row != frequencies.row]
    return Search(
        settings=replace(settings, tolerance=tolerance),
        slip=slip if tolerance > slip else None,
        covers_balls=own <= tolerance,
        other_rows=tuple(
            row.row for row in others if _range(frequencies, row, orders) > tolerance * (1.0 + 1e-9)
        ),
    )


def _range(own: FaultFrequencies, row: FaultFrequencies, orders: FaultOrders) -> float:
    """Part by which the cage has to be allowed off for a search to cover the balls of a row."""
    from rolamento.vibration.diagnosis import COMPONENTS

    widest = 0.0
    for part in COMPONENTS:
        line, sought_for = row.of_fault(part), own.of_fault(part).order
        for order in (line.minimum, line.maximum):
            if isfinite(order) and sought_for > 0.0:
                widest = max(widest, abs(order / sought_for - 1.0) / orders.tolerance(part, 1.0))
    return widest


def _rpm(speed: float) -> str:
    return f"{30.0 * speed / pi:.6g} rpm"
