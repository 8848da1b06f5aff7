"""Fault frequencies of a bearing: of its geometry, and of a solved case.

They are orders of the shaft and Hz, with harmonics and sidebands. With γ = D cos α/d_m, ring speeds
ω_i and ω_o, and a cage that lags by the part s of what it does against the outer ring,

    ω_m = ω_o + ½ (1 - s) (1 - γ) (ω_i - ω_o)                cage
    ω_R = -½ (1 - s) (d_m/D) (1 - γ²) (ω_i - ω_o)            ball, seen from the cage

and damage to the outer race is met Z |ω_m - ω_o|, to the inner Z |ω_i - ω_m|, to a ball 2 |ω_R|
times in 2π. A slipping ball rolls on the outer race, on which centrifugal force presses it, and
slips on the inner: cage and ball slow down by the same part.

Rollers have the same formulas with the angle β of their axis for α, 0 of cylindrical ones: exact
for tapered rollers whose cone has its apex with those of the raceways (`kinematics.apex_mismatch`).

Sources: Harris, Rolling Bearing Analysis, 3rd ed. (1991); Braga and Almeida, equations 19 and 22.
See docs/theory/vibration-frequencies.md.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, replace
from math import cos, isfinite, nan, pi, sin
from typing import TYPE_CHECKING, Any, Final, Literal, NamedTuple

import numpy as np

from rolamento.case.bearing import Bearing
from rolamento.case.roller_bearing import RollerBearing, axis_angle
from rolamento.errors import InputError, arguments
from rolamento.geometry import apex_half_angle, ring_geometry
from rolamento.io.json import plain
from rolamento.kinematics import apex_mismatch, ball_motion, roller_motion
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import number, one_of, whole_number
from rolamento.words import Note, said
from rolamento.words.naming import of_element

if TYPE_CHECKING:
    from rolamento.solved import Solved

FaultKind = Literal["outer_race", "inner_race", "ball", "cage"]
RollingElement = Literal["ball", "roller"]
"""What rolls, of whatever form."""
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
"""What is damaged, and the line that shows it."""

ABBREVIATIONS: Final[dict[LineName, str]] = {
    "cage": "FTF",
    "ball_pass_outer": "BPFO",
    "ball_pass_inner": "BPFI",
    "ball_spin": "BSF",
    "ball_spin_twice": "2×BSF",
}
"""What the lines are called on the shop floor, in every language."""

_MOST_LINES: Final = 10_000


@frozen
class LineBand:
    """What uncertainty of geometry, slip and speed leaves open; orders of the shaft, and Hz."""

    order_low: float
    order_high: float
    frequency_low: float
    frequency_high: float


@frozen
class FaultLine:
    """One frequency of a bearing.

    Attributes
    ----------
    order
        multiple of the shaft's frequency
    frequency
        Hz; NaN if the shaft's speed is not known
    minimum, mean, maximum
        orders over the loaded balls of a solved case; `order` where only the geometry is known
    band
        what uncertainty leaves open; None if nothing is said about it
    """

    order: float
    frequency: float
    minimum: float
    mean: float
    maximum: float
    band: LineBand | None = None


@frozen
class Turns:
    """Signed speeds over that of the shaft: of the rings, the cage, and a ball in the cage."""

    inner: float
    outer: float
    cage: float
    ball: float


@frozen
class Harmonic:
    """One line of a spectrum: `harmonic` times the fault's frequency and `sideband` spacings.

    order: of the shaft; frequency: Hz.
    """

    fault: FaultKind
    harmonic: int
    sideband: int
    order: float
    frequency: float


@frozen
class FaultFrequencies:
    """Fault frequencies of a row of balls or rollers; of rollers all that is said of balls.

    The shaft is the ring that turns: the inner one, or the outer if the inner stands still.
    Frequencies are positive; `turns` holds the signs.

    Attributes
    ----------
    source
        "nominal", of the geometry, or "loaded", of a solved case
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
        rad; of a solved case, the mean weighted by the loads; of rollers those of the raceways
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
        what a user should know
    element
        what rolls, as a case file has it: "ball", "tapered" …
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
    notes: tuple[Note, ...] = ()
    element: str = "ball"

    @property
    def rolling_element(self) -> RollingElement:
        """What rolls, of whatever form."""
        return "ball" if self.element == "ball" else "roller"

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
        """Return the line of damage to a part."""
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
        mapping: dict[str, Any] = plain(asdict(replace(self, rows=(), notes=())))
        if self.element == "ball":
            mapping.pop("element")
        return {
            **mapping,
            "rows": [row.to_mapping() for row in self.rows],
            "notes": [note.to_mapping() for note in self.notes],
        }


def _known(kind: FaultKind) -> FaultKind:
    one_of(kind, "kind", FAULTS, "outer_race")
    return kind


def _check_counts(harmonics: int, sidebands: int) -> None:
    whole_number(harmonics, "harmonics", 1, _MOST_LINES, "3")
    if sidebands < 0 or harmonics * (2 * sidebands + 1) > _MOST_LINES:
        raise InputError(
            said(
                "must be at least 0 and give at most {most} lines with the harmonics",
                most=_MOST_LINES,
            ),
            field="sidebands",
            value=sidebands,
            example="1",
        )


def plain_line(order: float, shaft_frequency: float) -> FaultLine:
    """Return a line of the geometry alone; order of the shaft, Hz."""
    order = abs(order)
    return FaultLine(order, order * shaft_frequency, order, order, order)


def missing_line() -> FaultLine:
    """Return the line of a case without a result."""
    return FaultLine(nan, nan, nan, nan, nan)


# --- of the geometry -----------------------------------------------------------------------------


AngleChoice = Literal["zero", "free"]
_TURN: Final = 2.0 * pi
_RIGHT_ANGLE: Final = 0.5 * pi
_MOST_SPEED: Final = 1e7
_TRUE_CONES: Final = 0.02
"""Part by which a half angle may be off that of one apex, as it is where both are rounded."""


class _Shaft(NamedTuple):
    """The rings' speeds, and which of them is the shaft; rad/s, NaN if not given."""

    inner: float
    outer: float
    role: Literal["inner", "outer"]
    speed: float

    @property
    def ratios(self) -> tuple[float, float]:
        """Speeds of inner and outer ring over the shaft's."""
        if not isfinite(self.speed) or self.speed == 0.0:
            return 1.0, 0.0
        return self.inner / self.speed, self.outer / self.speed

    @property
    def frequency(self) -> float:
        return abs(self.speed) / _TURN

    @property
    def notes(self) -> tuple[Note, ...]:
        if self.speed == 0.0:
            return (Note("orders_at_rest"),)
        return (Note("rings_turn_alike"),) if self.inner == self.outer else ()


def nominal_frequencies(
    bearing: Bearing | RollerBearing,
    inner_speed: float | None = None,
    outer_speed: float = 0.0,
    *,
    slip: float = 0.0,
    contact_angle: float | AngleChoice = "zero",
) -> FaultFrequencies:
    """Fault frequencies by the geometry alone.

    Parameters
    ----------
    bearing
        Of balls or rollers; its free contact angle is taken, if it is given by one.
    inner_speed, outer_speed
        Of the rings, signed (rad/s). With neither, the inner ring turns, and there are orders but
        no Hz.
    slip
        Part s of the cage's speed against the outer ring that it lags behind, from -1 to 1.
    contact_angle
        For a ball bearing given by its clearance: "zero", as under radial load, or "free", as under
        axial load. Or an angle for any ball bearing (rad). Rollers have the angles of their
        raceways.

    Raises
    ------
    InputError
        If a number is out of range.
    """
    shaft = shaft_of(inner_speed, outer_speed)
    _check_slip(slip)
    check_angle(bearing, contact_angle)
    rows = [
        _nominal_row(place.bearing, shaft, slip, contact_angle, index)
        for index, place in enumerate(bearing.element_rows)
    ]
    return rows[0] if len(rows) == 1 else replace(rows[0], rows=tuple(rows))


def frequencies_of(solved: Solved, *, slip: float = 0.0) -> FaultFrequencies:
    """Fault frequencies of a solved case, with its loaded contact angles and its cage speed.

    Without friction control every ball would like an orbital speed of its own: the cage has the
    mean of the balls that the inner ring presses on, weighted by their loads. Minimum, mean and
    maximum over these balls stand beside.

    Parameters
    ----------
    solved
        One case of what `rolamento.solve` returns; without a result there are NaN everywhere.
    slip
        Part of the cage's speed against the outer ring that it lags behind what the result says.

    Raises
    ------
    InputError
        If these are several cases, or the slip is out of range.
    """
    from rolamento.solved import refuse_other

    refuse_other(solved, "vibration.frequencies_of")
    if len(solved) != 1:
        raise InputError(
            said("must be a single case"),
            field="solved",
            value=len(solved),
            example="solved[0]",
        )
    _check_slip(slip)
    speeds = (float(solved.field(f"duty.{ring}_speed")[0]) for ring in ("inner", "outer"))
    shaft = shaft_of(*speeds)
    rows = [_loaded_row(solved, shaft, slip, row) for row in range(len(solved.rows))]
    if len(rows) == 1:
        return rows[0]
    loads = np.where(solved.loaded[0], solved.inner.load[0], 0.0)
    carried = np.add.reduceat(loads, solved.rows.starts)
    leading = rows[int(np.argmax(carried))]
    if solved.case.bearing.bearing_type.has_arches:  # the same balls and cage
        return replace(leading, row=0)
    return replace(leading, rows=tuple(rows))


def turns_of(
    diameter_ratio: float,
    contact_angle: float,
    inner: float = 1.0,
    outer: float = 0.0,
    slip: float = 0.0,
) -> Turns:
    """Signed speeds of cage and ball between rings that turn; in the unit of inner and outer.

    Parameters
    ----------
    diameter_ratio
        γ' = D/d_m.
    contact_angle
        α, of both contacts (rad).
    inner, outer
        Speeds of the rings, signed.
    slip
        Part of the cage's speed against the outer ring that it lags behind.

    Braga and Almeida, equations 19 and 22, with the slip.

    >>> print(f"{turns_of(0.2, 0.0).cage:.1f} turns of the cage a turn of the shaft")
    0.4 turns of the cage a turn of the shaft
    """
    gamma = diameter_ratio * cos(contact_angle)
    lead = (1.0 - slip) * (inner - outer)
    cage = outer + 0.5 * (1.0 - gamma) * lead
    ball = -0.5 * (1.0 - gamma**2) / diameter_ratio * lead
    return Turns(inner, outer, cage, ball)


def shaft_of(inner_speed: float | None, outer_speed: float) -> _Shaft:
    """Return which ring is the shaft; InputError for speeds out of range."""
    for field, value in (("inner_speed", inner_speed), ("outer_speed", outer_speed)):
        if value is not None and not abs(value) <= _MOST_SPEED:
            raise InputError(
                said("must be a finite number up to {most:.6g} rad/s", most=_MOST_SPEED),
                field=field,
                value=value,
                example=f"{field} = 188.2",
            )
    if outer_speed != 0.0 and not inner_speed:
        return _Shaft(0.0, outer_speed, "outer", outer_speed)
    if inner_speed is None:
        return _Shaft(nan, 0.0, "inner", nan)
    return _Shaft(inner_speed, outer_speed, "inner", inner_speed)


def line_orders(turns: Turns, ball_count: int) -> dict[LineName, float]:
    """Return the signed orders of all lines, for speeds over the shaft's."""
    return {
        "cage": turns.cage,
        "ball_pass_outer": ball_count * (turns.cage - turns.outer),
        "ball_pass_inner": ball_count * (turns.inner - turns.cage),
        "ball_spin": turns.ball,
        "ball_spin_twice": 2.0 * turns.ball,
    }


def check_angle(bearing: Bearing | RollerBearing, contact_angle: float | AngleChoice) -> None:
    """Refuse a contact angle for a bearing that has rollers alone; InputError."""
    if isinstance(bearing, RollerBearing) and not isinstance(contact_angle, str):
        raise InputError(
            said("is of ball bearings; rollers keep the angles of their raceways"),
            field="contact_angle",
            value=contact_angle,
            example='bearing.contact_angle = "14 deg"',
        )


def nominal_angle(
    bearing: Bearing | RollerBearing, contact_angle: float | AngleChoice
) -> tuple[float, tuple[Note, ...]]:
    """Return the angle of γ = D cos α/d_m of a plain bearing (rad), and what to say about it.

    Of rollers it is that of their axis.
    """
    if isinstance(bearing, RollerBearing):
        return float(axis_angle(bearing)), _apex_notes(bearing)
    if isinstance(contact_angle, str):
        if contact_angle not in ("zero", "free"):
            raise InputError(
                said("must be zero or free, or an angle in rad"),
                field="contact_angle",
                value=contact_angle,
                example='contact_angle = "free"',
            )
        if bearing.contact_angle is not None:
            return bearing.contact_angle, ()
        if contact_angle == "zero":
            return 0.0, (Note("angle_zero"),)
        return ring_geometry(bearing).free_contact_angle, (Note("angle_free"),)
    if not 0.0 <= contact_angle < _RIGHT_ANGLE:
        raise InputError(
            said("must be at least 0 and less than a right angle, in rad"),
            field="contact_angle",
            value=contact_angle,
            example="contact_angle = 0.26",
        )
    return contact_angle, ()


def _apex_notes(bearing: RollerBearing) -> tuple[Note, ...]:
    """Say so where the cones of rollers and raceways cannot roll truly."""
    if bearing.bearing_type.washers and not bearing.bearing_type.conical:
        return (Note("rollers_slide_on_washers"),)
    if bearing.bearing_type.barrels:  # which roll at their middle by their shape
        return ()
    half, axis = bearing.roller_half_angle or 0.0, float(axis_angle(bearing))
    sizes = bearing.roller_diameter, bearing.pitch_diameter
    if abs(float(apex_mismatch(*sizes, axis, half))) <= _TRUE_CONES:
        return ()
    inner, outer = sin(axis - half), sin(axis + half)
    values = {
        "half_angle": half,
        "apex_half_angle": float(
            apex_half_angle(*sizes, bearing.row_angle, washers=bearing.bearing_type.washers)
        ),
        "order_by_angles": inner / (inner + outer),
    }
    return (Note("no_common_apex", values),)


def _nominal_row(
    bearing: Bearing | RollerBearing,
    shaft: _Shaft,
    slip: float,
    contact_angle: float | AngleChoice,
    row: int,
) -> FaultFrequencies:
    angle, notes = nominal_angle(bearing, contact_angle)
    count, ratio = bearing.element_count, bearing.element_diameter / bearing.pitch_diameter
    turns = turns_of(ratio, angle, *shaft.ratios, slip)
    orders = line_orders(turns, count)
    lines = {name: plain_line(order, shaft.frequency) for name, order in orders.items()}
    angles = (angle, angle)
    if isinstance(bearing, RollerBearing):
        angles = (bearing.inner_contact_angle, bearing.outer_contact_angle)
    row_of = _Row("nominal", count, shaft, slip, row, bearing.element)
    return row_of.record(angles, turns, lines, (*shaft.notes, *notes))


class _Row(NamedTuple):
    """What all frequencies of one row have in common."""

    source: Literal["nominal", "loaded"]
    ball_count: int
    shaft: _Shaft
    slip: float
    row: int
    element: str

    def record(
        self,
        angles: tuple[float, float],
        turns: Turns,
        lines: Mapping[LineName, FaultLine],
        notes: tuple[Note, ...],
    ) -> FaultFrequencies:
        """Put the record together; angles: of the inner and the outer contact."""
        return FaultFrequencies(
            source=self.source,
            ball_count=self.ball_count,
            inner_speed=self.shaft.inner,
            outer_speed=self.shaft.outer,
            shaft=self.shaft.role,
            shaft_frequency=self.shaft.frequency,
            slip=self.slip,
            inner_contact_angle=angles[0],
            outer_contact_angle=angles[1],
            turns=turns,
            cage=lines["cage"],
            ball_pass_outer=lines["ball_pass_outer"],
            ball_pass_inner=lines["ball_pass_inner"],
            ball_spin=lines["ball_spin"],
            ball_spin_twice=lines["ball_spin_twice"],
            row=self.row,
            notes=tuple(
                of_element(note, "ball" if self.element == "ball" else "roller") for note in notes
            ),
            element=self.element,
        )

    def without_result(self, key: str) -> FaultFrequencies:
        """Return the record of a row that has no answer."""
        lines = {name: missing_line() for name in LINES}
        return self.record((nan, nan), Turns(*self.shaft.ratios, nan, nan), lines, (Note(key),))


# --- of a solved case ------------------------------------------------------------------------


class _LoadedBalls(NamedTuple):
    """What the loaded balls of a row do; arrays (balls,), speeds over the shaft's."""

    cage: FloatArray
    ball: FloatArray
    weight: FloatArray
    inner_angle: FloatArray
    outer_angle: FloatArray

    def mean(self, values: FloatArray) -> float:
        """Mean weighted by the loads."""
        return float(np.average(values, weights=self.weight))


def _loaded_row(solved: Solved, shaft: _Shaft, slip: float, row: int) -> FaultFrequencies:
    count = int(solved.rows.element_count[row])
    element = solved.rows.element[row]
    row_of = _Row("loaded", count, shaft, slip, row, element)
    if not solved.converged[0]:
        return row_of.without_result("no_solution_no_frequencies")
    if not solved.loaded_elements[0, row]:
        return row_of.without_result("no_ball_drives_cage")
    balls = _loaded_balls(solved, shaft, slip, row)
    inner, outer = shaft.ratios
    turns = Turns(inner, outer, balls.mean(balls.cage), balls.mean(balls.ball))
    each = [
        line_orders(Turns(inner, outer, *speeds), count)
        for speeds in zip(balls.cage.tolist(), balls.ball.tolist(), strict=True)
    ]
    lines = {
        name: _spread_line(order, [one[name] for one in each], shaft.frequency)
        for name, order in line_orders(turns, count).items()
    }
    angles = (balls.mean(balls.inner_angle), balls.mean(balls.outer_angle))
    friction = () if solved.rolling is None else (Note("cage_by_friction"),)
    return row_of.record(angles, turns, lines, (*shaft.notes, *friction))


def _loaded_balls(solved: Solved, shaft: _Shaft, slip: float, row: int) -> _LoadedBalls:
    """Gather what loaded balls do; at rest, what they would do with the inner ring turning."""
    own = (solved.elements.row == row) & solved.loaded[0]
    elements, rows = solved.elements, solved.rows
    inner_angle, outer_angle = (
        contacts.contact_angle[0, own] for contacts in (solved.inner, solved.outer)
    )
    if shaft.speed == 0.0:
        control = np.where(elements.raceway_control[0, own] == -1, -1, 1)
        diameter, pitch = rows.ball_diameter[0, row], rows.pitch_diameter[0, row]
        motion = ball_motion(inner_angle, outer_angle, diameter / pitch, 1.0, control=control)
        if solved.rows.element[row] != "ball":
            axis, half = 0.5 * (outer_angle + inner_angle), 0.5 * (outer_angle - inner_angle)
            motion = roller_motion(diameter, pitch, axis, half, 1.0)
        cage, ball_speed = motion.orbital_speed, motion.ball_speed
    else:
        cage = elements.orbital_speed[0, own] / shaft.speed
        ball_speed = elements.ball_speed[0, own] / shaft.speed
        if solved.rolling is not None:
            cage = np.full(len(cage), solved.rolling.cage_speed[0] / shaft.speed)
    outer = shaft.ratios[1]
    return _LoadedBalls(
        cage=outer + (1.0 - slip) * (cage - outer),
        ball=(1.0 - slip) * ball_speed,
        weight=solved.inner.load[0, own],
        inner_angle=inner_angle,
        outer_angle=outer_angle,
    )


def _spread_line(order: float, orders: Sequence[float], shaft_frequency: float) -> FaultLine:
    sizes = np.abs(orders)
    return FaultLine(
        order=abs(order),
        frequency=abs(order) * shaft_frequency,
        minimum=float(sizes.min()),
        mean=float(sizes.mean()),
        maximum=float(sizes.max()),
    )


def _check_slip(slip: float) -> None:
    number(slip, "slip", least=-1.0, most=1.0, example=arguments(slip=0.01))
