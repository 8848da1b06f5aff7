"""How strongly the balls are pressed as they pass each azimuth, as parts of the strongest."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Self

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.geometry import Race
from rolamento.numerics import FloatArray
from rolamento.state import State
from rolamento.vibration.synthesis._checks import check_within

__all__ = ["LoadDistribution"]

_TURN: Final = 2.0 * np.pi
_POINTS: Final = 720
_MOST_POSITIONS: Final = 360


@dataclass(frozen=True, slots=True, eq=False)
class LoadDistribution:
    """Loads of inner and outer contacts over the azimuth; arrays (points,).

    Attributes
    ----------
    azimuth
        rising, within a turn; rad, 0 at +z
    inner, outer
        loads over the greatest of their race, 0 to 1
    """

    azimuth: FloatArray
    inner: FloatArray
    outer: FloatArray

    def __post_init__(self) -> None:
        arrays = [np.asarray(a, dtype=np.float64) for a in (self.azimuth, self.inner, self.outer)]
        azimuth, inner, outer = arrays
        if azimuth.ndim != 1 or not azimuth.size or any(a.shape != azimuth.shape for a in arrays):
            raise InputError("must be three rows of as many numbers", field="azimuth")
        rises = bool(np.all(np.diff(azimuth) > 0.0)) and azimuth[-1] - azimuth[0] < _TURN
        if not (rises and np.all(np.isfinite(azimuth))):
            raise InputError("must rise, within one turn", field="azimuth")
        for name, loads in (("inner", inner), ("outer", outer)):
            if not np.all((loads >= 0.0) & (loads <= 1.0)):
                raise InputError("must be parts from 0 to 1", field=name)
        for name, array in zip(("azimuth", "inner", "outer"), arrays, strict=True):
            object.__setattr__(self, name, array)

    def at(self, azimuth: ArrayLike, race: Race) -> FloatArray:
        """Load at azimuths (rad) over the greatest; the shape of the azimuths.

        Straight between the points in the approach of ball and race, which goes with Q^(2/3).
        """
        loads = self.inner if race == "inner" else self.outer
        angle = np.asarray(azimuth, dtype=np.float64)
        approach = np.interp(angle, self.azimuth, np.cbrt(loads**2), period=_TURN)
        return np.asarray(approach**1.5)

    @classmethod
    def uniform(cls) -> Self:
        """Equal all round, as under pure axial load."""
        return cls(np.zeros(1), np.ones(1), np.ones(1))

    @classmethod
    def radial(cls, extent: float = 0.5, azimuth: float = 0.0) -> Self:
        """Stribeck's: q = [1 - (1 - cos ψ)/(2 ε)]^(3/2) about the direction of a radial load.

        Parameters
        ----------
        extent
            ε, of the load zone: ½ is half the bearing, 1 and more all of it.
        azimuth
            Of the load (rad).

        Sjövall (1933); Harris (1991).
        """
        check_within("extent", extent, 1e-3, 1e6, "extent = 0.5")
        psi = np.arange(_POINTS, dtype=np.float64) * (_TURN / _POINTS)
        load = np.maximum(1.0 - (1.0 - np.cos(psi - azimuth)) / (2.0 * extent), 0.0) ** 1.5
        return cls(psi, load, load)

    @classmethod
    def of_state(cls, state: State, *, row: int = 0, positions: int = 8) -> Self:
        """Of a solved state, solved again for so many positions of the cage.

        Parameters
        ----------
        state
            With a result.
        row
            Of the balls.
        positions
            Of the cage within the angle from ball to ball. With 1, and under friction control,
            only the state's own balls are taken, and nothing is solved.

        Raises
        ------
        InputError
            If the state has no result, or no ball of the row is pressed.
        """
        check_within("positions", positions, 1, _MOST_POSITIONS, "positions = 8")
        balls = [ball for ball in state.balls if ball.row == row]
        if not state.status.converged or not balls:
            raise InputError("has no result, or no such row of balls", field="state", value=row)
        azimuth = np.array([ball.azimuth for ball in balls])
        inner = np.array([ball.inner.load for ball in balls])
        outer = np.array([ball.outer.load for ball in balls])
        if positions > 1 and state.rolling is None:
            azimuth, inner, outer = _solved_between(state, row, positions)
        if not (inner.max() > 0.0 and outer.max() > 0.0):
            raise InputError("presses no ball of this row", field="state", value=row)
        azimuth = np.mod(azimuth, _TURN)
        order = np.argsort(azimuth)
        return cls(azimuth[order], inner[order] / inner.max(), outer[order] / outer.max())


def _solved_between(
    state: State, row: int, positions: int
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Azimuths and loads of all balls of a row, at cage positions between those of the state."""
    from rolamento.solution import solve_batch

    case = state.case
    count = case.bearing.places[row].bearing.ball_count
    shifts = np.arange(positions) * (_TURN / count / positions)
    batch = solve_batch(case, first_ball_azimuth=case.duty.first_ball_azimuth + shifts, threads=1)
    table = batch.balls()
    own = batch.row == row
    found = (table.azimuth, table.inner.load, table.outer.load)
    azimuth, inner, outer = (array[batch.converged][:, own].ravel() for array in found)
    return azimuth, inner, outer
