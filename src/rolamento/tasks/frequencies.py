"""Fault frequencies of a bearing: by its geometry, and under its load."""

from __future__ import annotations

from dataclasses import asdict
from math import isfinite
from typing import TYPE_CHECKING, Any, Final

from rolamento.case import Case, case_of, is_designation
from rolamento.case.bearing import Bearing
from rolamento.case.case import BearingLike, name_of
from rolamento.case.fields import Changes
from rolamento.case.roller_bearing import RollerBearing
from rolamento.errors import InputError
from rolamento.records import frozen
from rolamento.tasks.bearing import angle_of, at_speeds, has_load
from rolamento.tasks.parameters import speed_of
from rolamento.vibration.frequencies import (
    ABBREVIATIONS,
    FAULTS,
    FaultFrequencies,
    frequencies_of,
)
from rolamento.vibration.frequency_band import (
    Alternative,
    Tolerances,
    alternatives_of,
    banded_frequencies,
    open_counts,
)
from rolamento.words import Note, said

if TYPE_CHECKING:
    from rolamento.solved import Solved

SCHEMA: Final = 2
_SPEEDS: Final = frozenset({"inner_speed", "outer_speed"})
_MOST_HARMONICS: Final = 100
_MOST_SIDEBANDS: Final = 10


@frozen
class FrequencyResult:
    """Fault frequencies of a bearing, by its geometry and under its load.

    Attributes
    ----------
    title
        designation or title of the case
    bearing
        whose frequencies these are
    nominal
        by its geometry, with bands
    loaded, solved
        of the case's load; None without one
    alternatives
        of an estimated internal geometry
    harmonics, sidebands
        how many the tables show
    """

    title: str
    bearing: Bearing | RollerBearing
    nominal: FaultFrequencies
    loaded: FaultFrequencies | None
    solved: Solved | None
    alternatives: tuple[Alternative, ...]
    harmonics: int
    sidebands: int

    def _shown(self) -> dict[str, str]:
        best = self.best
        shown = {"": self.title, "source": best.source}
        for fault in FAULTS:
            line = best.of_fault(fault)
            shown[fault] = f"{line.order:.5g} x shaft, {line.frequency:.5g} Hz"
        return shown

    @property
    def by_source(self) -> tuple[FaultFrequencies, ...]:
        """The nominal frequencies of every row, then the loaded ones."""
        found = (self.nominal,) if self.loaded is None else (self.nominal, self.loaded)
        return tuple(row for one in found for row in (one.rows or (one,)))

    @property
    def best(self) -> FaultFrequencies:
        """The frequencies to look for: the loaded ones where there are any."""
        loaded = self.loaded
        return self.nominal if loaded is None or not isfinite(loaded.cage.order) else loaded

    @property
    def notes(self) -> tuple[Note, ...]:
        """What is to be known of the frequencies, each once."""
        own = dict.fromkeys(note for one in self.by_source for note in one.notes)
        return (*own, *open_counts(self.bearing))

    def to_mapping(self) -> dict[str, Any]:
        """Return everything as plain data, in SI units and Hz."""
        tables = {
            kind: [
                {key: value for key, value in asdict(line).items() if key != "fault"}
                for line in self.best.harmonics(kind, self.harmonics, self.sidebands)
            ]
            for kind in FAULTS
        }
        return {
            "schema": SCHEMA,
            "kind": "frequencies",
            "title": self.title,
            "abbreviations": dict(ABBREVIATIONS),
            "nominal": self.nominal.to_mapping(),
            "loaded": None if self.loaded is None else self.loaded.to_mapping(),
            "harmonics": tables,
            "alternatives": [asdict(one) for one in self.alternatives],
        }


def fault_frequencies(
    bearing: BearingLike,
    *,
    speed: str | float | None = None,
    outer_speed: str | float | None = None,
    slip: float = 0.0,
    angle: str | float = "zero",
    tolerances: Tolerances | None = None,
    harmonics: int = 3,
    sidebands: int = 1,
    changes: Changes = (),
) -> FrequencyResult:
    """Find the fault frequencies of a bearing: nominal ones, and loaded ones if it has a load.

    Parameters
    ----------
    bearing
        Designation, case file or case.
    speed, outer_speed
        Of the rings: text such as "1797 rpm", or rad/s; by default those of the case.
    slip
        Part of the cage's speed against the outer ring that it lags behind, from -1 to 1.
    angle
        Of contact, of a bearing given by its clearance: "zero", "free", an angle such as "15 deg",
        or rad.
    tolerances
        By how much what may be off.
    harmonics, sidebands
        How many multiples the tables show, 1 to 100, and how many on either side of each, 0 to 10.
    changes
        What goes over the case, by dotted name, such as ``{"duty.load.fz": "5 kN"}``.

    Returns
    -------
    FrequencyResult
        `nominal` by the geometry alone, and `loaded` if the case has a load; Hz.

    Raises
    ------
    FileError, InputError
        If there is no such bearing, or a number is out of range.

    >>> found = fault_frequencies("6205", speed="1800 rpm").nominal
    >>> outer, inner = found.ball_pass_outer.frequency, found.ball_pass_inner.frequency
    >>> print(f"{outer + inner:.1f} Hz")  # nine balls at 30 turns a second
    270.0 Hz
    """
    for name, lowest, highest, value in (
        ("harmonics", 1, _MOST_HARMONICS, harmonics),
        ("sidebands", 0, _MOST_SIDEBANDS, sidebands),
    ):
        if not lowest <= value <= highest:
            raise InputError(
                said("must be from {least} to {most}", least=lowest, most=highest),
                field=name,
                value=value,
            )
    inner, outer = speed_of(speed, "speed"), speed_of(outer_speed, "outer_speed")
    case = at_speeds(case_of(bearing, changes), inner, outer)
    duty = case.duty
    told = inner is not None or outer is not None or duty.turns
    has_no_duty = (
        isinstance(bearing, Bearing | RollerBearing)
        or (isinstance(bearing, Case) and not _SPEEDS & bearing.duty.model_fields_set)
        or is_designation(bearing)
    )
    speeds = None if has_no_duty and not told else duty.inner_speed, duty.outer_speed
    contact_angle = angle_of(angle, case.bearing)
    own = case.bearing
    solved: Solved | None = None
    if has_load(case):
        from rolamento.solution import solve

        solved = solve(case)
    return FrequencyResult(
        title=name_of(bearing, case),
        bearing=own,
        nominal=banded_frequencies(
            case.bearing,
            *speeds,
            slip=slip,
            contact_angle=contact_angle,
            tolerances=tolerances,
        ),
        loaded=None if solved is None else frequencies_of(solved, slip=slip),
        solved=solved,
        alternatives=alternatives_of(own, *speeds, slip=slip, contact_angle=contact_angle),
        harmonics=harmonics,
        sidebands=sidebands,
    )
