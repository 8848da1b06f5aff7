"""The record of fault frequencies: orders of the shaft and Hz, harmonics and sidebands."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from math import nan
from typing import Any, Final, Literal

from rolamento._json import plain
from rolamento.errors import InputError

__all__ = [
    "FAULTS",
    "LINES",
    "NOTES",
    "Band",
    "FaultFrequencies",
    "FaultKind",
    "FaultLine",
    "Harmonic",
    "LineName",
    "Turns",
]

FaultKind = Literal["outer_race", "inner_race", "ball", "cage"]
LineName = Literal["cage", "ball_pass_outer", "ball_pass_inner", "ball_spin", "ball_spin_twice"]

LINES: Final[tuple[LineName, ...]] = (
    "cage",
    "ball_pass_outer",
    "ball_pass_inner",
    "ball_spin",
    "ball_spin_twice",
)
"""Names of the lines of a `FaultFrequencies`."""

FAULTS: Final[dict[FaultKind, LineName]] = {
    "outer_race": "ball_pass_outer",
    "inner_race": "ball_pass_inner",
    "ball": "ball_spin_twice",
    "cage": "cage",
}
"""What is damaged, and the line that tells of it."""

NOTES: Final[dict[str, str]] = {
    "angle_zero": (
        "The bearing is given by its clearance: contact angle 0, as under radial load. Under"
        " axial load it is the free contact angle or more."
    ),
    "angle_free": "The bearing is given by its clearance: free contact angle, as under axial load.",
    "at_rest": "Nothing turns: the orders are those of a turning inner ring.",
    "turns_alike": "Both rings turn alike: no ball rolls.",
    "no_result": "The case has no solution, and so no loaded frequencies.",
    "no_loaded_ball": "The inner ring presses on no ball: nothing drives the cage.",
    "friction": "The cage speed is that of friction control.",
}
"""What a user should know about frequencies, by name."""

_MOST_LINES: Final = 10_000


@dataclass(frozen=True, slots=True)
class Band:
    """What uncertainty of geometry, slip and speed leaves open; orders of the shaft, and Hz."""

    order_low: float
    order_high: float
    frequency_low: float
    frequency_high: float


@dataclass(frozen=True, slots=True)
class FaultLine:
    """One frequency of a bearing.

    Attributes
    ----------
    order
        multiple of the shaft's frequency
    frequency
        Hz; NaN if the shaft's speed is not known
    minimum, mean, maximum
        orders over the loaded balls of a solved state; `order` where the geometry alone tells
    band
        what uncertainty leaves open; None if nothing is said about it
    """

    order: float
    frequency: float
    minimum: float
    mean: float
    maximum: float
    band: Band | None = None


@dataclass(frozen=True, slots=True)
class Turns:
    """Signed speeds over that of the shaft: of the rings, the cage, and a ball in the cage."""

    inner: float
    outer: float
    cage: float
    ball: float


@dataclass(frozen=True, slots=True)
class Harmonic:
    """One line of a spectrum: `harmonic` times the fault's frequency and `sideband` spacings.

    order: of the shaft; frequency: Hz.
    """

    fault: FaultKind
    harmonic: int
    sideband: int
    order: float
    frequency: float


@dataclass(frozen=True, slots=True)
class FaultFrequencies:
    """At which frequencies a row of balls tells of damage.

    The shaft is the ring that turns: the inner one, or the outer if the inner stands still.
    Frequencies are positive; `turns` holds the signs.

    Attributes
    ----------
    source
        "nominal", of the geometry, or "loaded", of a solved state
    ball_count
        Z
    inner_speed, outer_speed
        of the rings (rad/s), signed; NaN if not given
    shaft
        "inner" or "outer"
    shaft_frequency
        Hz; NaN if not given
    slip
        part by which the cage lags behind rolling, seen from the outer ring
    inner_contact_angle, outer_contact_angle
        rad; of a state, the mean weighted by the loads
    turns
        signed speeds over the shaft's
    cage
        f_c, of the cage against what does not turn
    ball_pass_outer, ball_pass_inner
        f_o and f_i: balls that pass a point of the outer and of the inner race
    ball_spin, ball_spin_twice
        f_b, of a ball about its own axis; twice that, as its damage strikes both races
    row
        of balls, counted from 0
    rows
        of a set, the frequencies of every row; the record itself is that of the row that carries
        most. Empty for a single row.
    notes
        names in `NOTES`
    """

    source: Literal["nominal", "loaded"]
    ball_count: int
    inner_speed: float
    outer_speed: float
    shaft: Literal["inner", "outer"]
    shaft_frequency: float
    slip: float
    inner_contact_angle: float
    outer_contact_angle: float
    turns: Turns
    cage: FaultLine
    ball_pass_outer: FaultLine
    ball_pass_inner: FaultLine
    ball_spin: FaultLine
    ball_spin_twice: FaultLine
    row: int = 0
    rows: tuple[FaultFrequencies, ...] = ()
    notes: tuple[str, ...] = ()

    @property
    def lines(self) -> dict[LineName, FaultLine]:
        """The lines by their names."""
        return {name: getattr(self, name) for name in LINES}

    def with_lines(self, lines: Mapping[LineName, FaultLine]) -> FaultFrequencies:
        """Return the same frequencies with other lines."""
        return replace(
            self,
            cage=lines["cage"],
            ball_pass_outer=lines["ball_pass_outer"],
            ball_pass_inner=lines["ball_pass_inner"],
            ball_spin=lines["ball_spin"],
            ball_spin_twice=lines["ball_spin_twice"],
        )

    def of_fault(self, kind: FaultKind) -> FaultLine:
        """Return the line that tells of damage to a part."""
        line: FaultLine = getattr(self, FAULTS[_known(kind)])
        return line

    def spacing(self, kind: FaultKind) -> float:
        """Order of the modulation that damage undergoes under a load that stands still.

        Damage to a race goes through the load as its ring turns, damage to a ball with the cage;
        damage to the cage has none.
        """
        turn = {
            "outer_race": self.turns.outer,
            "inner_race": self.turns.inner,
            "ball": self.turns.cage,
            "cage": 0.0,
        }[_known(kind)]
        return abs(turn)

    def harmonics(
        self, kind: FaultKind, harmonics: int = 3, sidebands: int = 1
    ) -> tuple[Harmonic, ...]:
        """Return the lines of a spectrum that damage to a part makes, in rising order.

        Parameters
        ----------
        kind
            What is damaged.
        harmonics
            How many multiples of its frequency, at least 1.
        sidebands
            How many on either side of each, in steps of `spacing`; none where that is 0. Lines
            that would fall to zero or below are left out.

        Raises
        ------
        InputError
            If a number is out of range.
        """
        order, spacing = self.of_fault(kind).order, self.spacing(kind)
        _check_counts(harmonics, sidebands)
        sides = range(-sidebands, sidebands + 1) if spacing > 0.0 else range(1)
        found = [
            (number, side, number * order + side * spacing)
            for number in range(1, harmonics + 1)
            for side in sides
        ]
        return tuple(
            Harmonic(kind, number, side, place, place * self.shaft_frequency)
            for number, side, place in sorted(found, key=lambda item: item[2])
            if place > 0.0
        )

    def to_mapping(self) -> dict[str, Any]:
        """Give the frequencies as plain mappings and lists in SI units, NaN as None."""
        mapping: dict[str, Any] = plain(asdict(self))
        return mapping


def _known(kind: FaultKind) -> FaultKind:
    if kind not in FAULTS:
        raise InputError(
            f"must be one of {', '.join(FAULTS)}", field="kind", value=kind, example="outer_race"
        )
    return kind


def _check_counts(harmonics: int, sidebands: int) -> None:
    if not 1 <= harmonics <= _MOST_LINES:
        raise InputError(
            f"must be between 1 and {_MOST_LINES}", field="harmonics", value=harmonics, example="3"
        )
    if sidebands < 0 or harmonics * (2 * sidebands + 1) > _MOST_LINES:
        raise InputError(
            f"must be at least 0, and give at most {_MOST_LINES} lines with the harmonics",
            field="sidebands",
            value=sidebands,
            example="1",
        )


def plain_line(order: float, shaft_frequency: float) -> FaultLine:
    """Return a line that geometry alone tells; order of the shaft, Hz."""
    order = abs(order)
    return FaultLine(order, order * shaft_frequency, order, order, order)


def missing_line() -> FaultLine:
    """Return the line of a case without a result."""
    return FaultLine(nan, nan, nan, nan, nan)
