"""Localised damage: when its impacts come, and how strong they are.

Impacts come once a passage of the part that is damaged, at the orders of `FaultFrequencies`, but
not like clockwork: balls slip a little, differently from one passage to the next. With the
intervals independent of each other, T_k = T + ε_k, the deviations add up: the k-th impact is off
by √k standard deviations, and the signal keeps no phase (Antoni and Randall 2003). Older models
have every impact scatter about its place on a strict clock. Both are offered.

The strength goes with the load of the ball that strikes (McFadden and Smith 1984), as a part of
the strongest, and with what the path to the sensor leaves of it.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Final, Literal, NamedTuple, Self

import numpy as np
from numpy.typing import ArrayLike

from rolamento.contact.line import EXPONENT
from rolamento.errors import InputError
from rolamento.geometry import Race
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import number, one_of
from rolamento.vibration.frequencies import (
    FAULTS,
    FaultFrequencies,
    FaultKind,
    RollingElement,
)
from rolamento.vibration.signal import real_numbers
from rolamento.vibration.synthesis.transfer import TransferPath
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.solved import Solved

_TURN: Final = 2.0 * np.pi
_POINTS: Final = 720
_MOST_POSITIONS: Final = 360

EXPONENTS: Final[Mapping[RollingElement, float]] = {"ball": 1.5, "roller": EXPONENT}
"""With which the load of a contact goes with its approach: Hertz; ISO/TS 16281 for rollers."""


@frozen(eq=False)
class LoadDistribution:
    """Loads of inner and outer contacts over the azimuth; arrays (points,).

    Attributes
    ----------
    azimuth
        rising, within a turn; rad, 0 at +z
    inner, outer
        loads over the maximum of their race, 0 to 1
    exponent
        with which the load goes with the approach: 3/2 of balls, 10/9 of rollers
    """

    azimuth: FloatArray
    inner: FloatArray
    outer: FloatArray
    exponent: float = EXPONENTS["ball"]

    def __post_init__(self) -> None:
        arrays = [
            real_numbers(getattr(self, name), name, f"{name} = [0.0, 1.0]")
            for name in ("azimuth", "inner", "outer")
        ]
        azimuth, inner, outer = arrays
        if azimuth.ndim != 1 or not azimuth.size or any(a.shape != azimuth.shape for a in arrays):
            raise InputError(said("must be three rows of equal length"), field="azimuth")
        rises = bool(np.all(np.diff(azimuth) > 0.0)) and azimuth[-1] - azimuth[0] < _TURN
        if not (rises and np.all(np.isfinite(azimuth))):
            raise InputError(said("must increase, within one revolution"), field="azimuth")
        for name, loads in (("inner", inner), ("outer", outer)):
            if not np.all((loads >= 0.0) & (loads <= 1.0)):
                raise InputError(said("must be fractions from 0 to 1"), field=name)
        number(self.exponent, "exponent", least=1.0, most=2.0, example="exponent = 1.5")
        for name, array in zip(("azimuth", "inner", "outer"), arrays, strict=True):
            object.__setattr__(self, name, array)

    def at(self, azimuth: ArrayLike, race: Race) -> FloatArray:
        """Load at azimuths (rad) over the maximum; the shape of the azimuths.

        Straight between the points in the approach, which goes with Q^(2/3) of balls and Q^(9/10)
        of rollers.
        """
        loads = self.inner if race == "inner" else self.outer
        angle = real_numbers(azimuth, "azimuth", "azimuth = [0.0, 1.57]")
        if self.exponent == EXPONENTS["ball"]:
            return np.asarray(
                np.interp(angle, self.azimuth, np.cbrt(loads**2), period=_TURN) ** 1.5
            )
        known = loads ** (1.0 / self.exponent)
        return np.asarray(np.interp(angle, self.azimuth, known, period=_TURN) ** self.exponent)

    @classmethod
    def uniform(cls) -> Self:
        """Equal all round, as under pure axial load."""
        return cls(np.zeros(1), np.ones(1), np.ones(1))

    @classmethod
    def radial(
        cls, extent: float = 0.5, azimuth: float = 0.0, element: RollingElement = "ball"
    ) -> Self:
        """Stribeck's: q = [1 - (1 - cos ψ)/(2 ε)]^(3/2) about the direction of a radial load.

        Of rollers with the exponent 10/9.

        Parameters
        ----------
        extent
            ε, of the load zone: ½ is half the bearing, 1 and more all of it.
        azimuth
            Of the load (rad).
        element
            What rolls, "ball" or "roller".

        Sjövall (1933); Harris (1991).
        """
        number(extent, "extent", least=1e-3, most=1e6, example="extent = 0.5")
        psi = np.arange(_POINTS, dtype=np.float64) * (_TURN / _POINTS)
        approach = np.maximum(1.0 - (1.0 - np.cos(psi - azimuth)) / (2.0 * extent), 0.0)
        exponent = EXPONENTS[element]
        return cls(psi, approach**exponent, approach**exponent, exponent)

    @classmethod
    def of_solved(cls, solved: Solved, *, row: int = 0, positions: int = 8) -> Self:
        """Load distribution of a solved case, solved again for so many positions of the cage.

        Parameters
        ----------
        solved
            One case with a result.
        row
            Of the balls.
        positions
            Of the cage within the angle from ball to ball. With 1, and under friction control,
            only the result's own balls are taken, and nothing is solved.

        Raises
        ------
        InputError
            If these are several cases, there is no result, or no ball of the row is pressed.
        """
        from rolamento.solved import refuse_other

        refuse_other(solved, "vibration.LoadDistribution.of_solved")
        number(positions, "positions", least=1, most=_MOST_POSITIONS, example="positions = 8")
        own = solved.elements.row == row
        if len(solved) != 1 or not solved.converged[0] or not own.any():
            raise InputError(
                said("must be a single case with a result and such a row"),
                field="solved",
                value=row,
            )
        if positions > 1 and solved.rolling is None:
            solved = _solved_between(solved, row, positions)
        azimuth, inner, outer = (
            table[solved.converged][:, own].ravel()
            for table in (solved.elements.azimuth, solved.inner.load, solved.outer.load)
        )
        if not (inner.max() > 0.0 and outer.max() > 0.0):
            raise InputError(
                said("loads no rolling element of this row"), field="solved", value=row
            )
        azimuth = np.mod(azimuth, _TURN)
        order = np.argsort(azimuth)
        loads = inner[order] / inner.max(), outer[order] / outer.max()
        kind = solved.rows.element[row]
        return cls(azimuth[order], *loads, EXPONENTS["ball" if kind == "ball" else "roller"])


def _solved_between(solved: Solved, row: int, positions: int) -> Solved:
    """Solve for cage positions from that of a case to where the next ball takes its place."""
    from rolamento.solution import solve

    first = solved.field("duty.first_ball_azimuth")[0]
    shifts = np.arange(positions) * (_TURN / int(solved.rows.element_count[row]) / positions)
    varied = {name: float(values[0]) for name, values in solved.varied.items()}
    return solve(solved.case, {**varied, "duty.first_ball_azimuth": first + shifts}, threads=1)


# --- impacts of damage ---------------------------------------------------------------------------


_MOST_IMPACTS: Final = 5_000_000
_LEAST_INTERVAL: Final = 0.05
"""Fraction of the mean: no impact overtakes the one before."""


@frozen(kw_only=True)
class Fault:
    """Damage at one place.

    Attributes
    ----------
    kind
        "outer_race", "inner_race", "ball" or "cage"
    strength
        of an impact under the maximum load right at the sensor; times the gains of the modes
    azimuth
        of the damage when the signal begins (rad, 0 at +z): of the spot on a race or the cage, or
        of the damaged ball
    jitter
        standard deviation of an interval between impacts over its mean, 0 to 0.2
    slip
        "cumulative", where the deviations of the intervals add up, or "around", where each impact
        scatters about its place on a strict clock
    scatter
        standard deviation of the strengths over their means, 0 to 1
    modulation
        "amplitude": impacts that ring and decay; or "frequency": modes that ring on at a level
        while their frequency swings with the passages (as Braga and Almeida suppose)
    index
        of the modulation of frequency (rad)
    inner_gain
        of a damaged ball: what its impacts on the inner race are worth beside those on the outer
    """

    kind: FaultKind
    strength: float = 1.0
    azimuth: float = 0.0
    jitter: float = 0.01
    slip: Literal["cumulative", "around"] = "cumulative"
    scatter: float = 0.0
    modulation: Literal["amplitude", "frequency"] = "amplitude"
    index: float = 1.0
    inner_gain: float = 0.5

    def __post_init__(self) -> None:
        for field, allowed in (
            ("kind", tuple(FAULTS)),
            ("slip", ("cumulative", "around")),
            ("modulation", ("amplitude", "frequency")),
        ):
            value = getattr(self, field)
            one_of(value, field, allowed)
        number(self.strength, "strength", least=0.0, most=1e9, example="strength = 1.0")
        number(self.azimuth, "azimuth", least=-1e3, most=1e3, unit="rad", example="azimuth = 0.0")
        number(self.jitter, "jitter", least=0.0, most=0.2, example="jitter = 0.01")
        number(self.scatter, "scatter", least=0.0, most=1.0, example="scatter = 0.1")
        number(self.index, "index", least=0.0, most=1e4, unit="rad", example="index = 1.0")
        number(self.inner_gain, "inner_gain", least=0.0, most=1e3, example="inner_gain = 0.5")


class Impacts(NamedTuple):
    """Impacts of one fault; arrays (impacts,).

    times s, rising; cycles passages of the part since the signal began, without the jitter's
    share; azimuths where they happened, rad; strengths dimensionless.
    """

    times: FloatArray
    cycles: FloatArray
    azimuths: FloatArray
    strengths: FloatArray


class Turning(NamedTuple):
    """The shaft's angle (rad, away from 0) at every sample, and the samples per second."""

    angle: FloatArray
    rate: float

    @property
    def size(self) -> FloatArray:
        """The angle's size, which rises."""
        return np.abs(self.angle)

    @property
    def sign(self) -> float:
        """Which way the shaft turns."""
        return -1.0 if self.angle[-1] < 0.0 else 1.0


def impacts_of(
    fault: Fault,
    frequencies: FaultFrequencies,
    turning: Turning,
    load: LoadDistribution,
    path: TransferPath,
    random: np.random.Generator,
    load_turns: float = 0.0,
) -> Impacts:
    """Return the impacts of a fault over a signal.

    Parameters
    ----------
    fault
        What is damaged.
    frequencies
        Of the bearing: orders and signed speeds over the shaft's.
    turning
        Of the shaft.
    load, path
        What the strengths go with.
    random
        Of jitter and scatter.
    load_turns
        Speed of the load's direction over the shaft's: 0 for a load that stands still, 1 for
        unbalance.

    Raises
    ------
    InputError
        If there would be more than five million impacts.
    """
    order = frequencies.of_fault(fault.kind).order
    size = turning.size
    if order == 0.0 or size.size < 2:
        return Impacts(*[np.zeros(0)] * 4)
    total = order * float(size[-1]) / _TURN
    if total > _MOST_IMPACTS:
        raise InputError(
            said("may be at most {most}; shorten the duration", most=_MOST_IMPACTS),
            field="faults.impacts",
            value=round(total),
            example="duration = 10.0",
        )
    cycles = _cycles(fault, total, random)
    angles = cycles * (_TURN / order)
    times = np.interp(angles, size, np.arange(size.size) / turning.rate)
    turned = turning.sign * angles
    # turning about +x leads from +y to +z, and azimuths count from +z to +y: they run backward
    azimuths = fault.azimuth - _turn(fault.kind, frequencies) * turned
    strengths = fault.strength * path.at(azimuths)
    strengths = strengths * _pressed(fault, azimuths + load_turns * turned, load)
    if fault.scatter > 0.0:
        strengths *= np.maximum(1.0 + fault.scatter * random.standard_normal(cycles.size), 0.0)
    return Impacts(times, np.arange(cycles.size) + cycles[:1], np.mod(azimuths, _TURN), strengths)


def cycles_at(impacts: Impacts, turning: Turning, order: float) -> FloatArray:
    """Passages so far at every sample (samples,): whole at every impact, steady between.

    order: of the fault; beyond the first and last impact passages go on at its pace.
    """
    time = np.arange(turning.angle.size) / turning.rate
    steady = order * turning.size / _TURN
    if not impacts.times.size:
        return steady
    late = np.interp(impacts.times, time, steady) - np.arange(impacts.times.size)
    return np.asarray(steady - np.interp(time, impacts.times, late))


def _cycles(fault: Fault, total: float, random: np.random.Generator) -> FloatArray:
    """Passages at which impacts come, jitter included, from 0 to the total."""
    start = float(random.random())
    count = int(total * (1.0 + fault.jitter)) + int(20.0 * fault.jitter * np.sqrt(total)) + 2
    deviations = fault.jitter * random.standard_normal(count)
    if fault.slip == "cumulative":
        intervals = np.maximum(1.0 + deviations[1:], _LEAST_INTERVAL)
        cycles = start + np.concatenate(([0.0], np.cumsum(intervals)))
    else:
        cycles = np.sort(start + np.arange(count) + deviations)
    return np.asarray(cycles[(cycles >= 0.0) & (cycles < total)])


def _turn(kind: FaultKind, frequencies: FaultFrequencies) -> float:
    """Speed of the damage around the bearing, over the shaft's."""
    turns = frequencies.turns
    return {
        "outer_race": turns.outer,
        "inner_race": turns.inner,
        "ball": turns.cage,
        "cage": turns.cage,
    }[kind]


def _pressed(fault: Fault, azimuths: FloatArray, load: LoadDistribution) -> FloatArray:
    """How hard the ball that strikes is pressed, over the most."""
    if fault.kind == "cage":
        return np.ones(azimuths.size)
    if fault.kind == "inner_race":
        return load.at(azimuths, "inner")
    outer = load.at(azimuths, "outer")
    if fault.kind == "outer_race":
        return outer
    # a damaged ball strikes the outer and the inner race by turns
    strikes_inner = np.arange(azimuths.size) % 2 == 1
    return np.where(strikes_inner, fault.inner_gain * load.at(azimuths, "inner"), outer)
