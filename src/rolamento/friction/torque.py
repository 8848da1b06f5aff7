"""What every friction model returns."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.friction.loaded_balls import LoadedBalls
from rolamento.numerics import BoolArray, FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class ContactLoss:
    """What one source loses in the contacts; (cases, balls), W, or N·m at a unit speed."""

    inner: FloatArray
    outer: FloatArray

    @property
    def total(self) -> FloatArray:
        """Of all contacts; (cases,)."""
        return np.asarray(np.sum(self.inner + self.outer, axis=-1))

    def scaled(self, factor: FloatArray) -> ContactLoss:
        """The same times a factor, (cases, 1)."""
        return ContactLoss(self.inner * factor, self.outer * factor)


@dataclass(frozen=True, slots=True, eq=False)
class Torque:
    """Friction torque of bearings by one model; arrays over cases, NaN without a result.

    Attributes
    ----------
    model
        its name
    total
        torque against the relative rotation of the rings, (cases,), N·m, never negative
    parts
        the same by source; they add up to the total
    power
        the total times the relative speed of the rings, (cases,), W
    converged
        (cases,), whether the model found a result
    losses
        heat by source in every contact at the speeds of the case, W; empty where the model
        does not know contacts, zero at rest
    notes
        what the model leaves out
    """

    model: str
    total: FloatArray
    parts: Mapping[str, FloatArray]
    power: FloatArray
    converged: BoolArray
    losses: Mapping[str, ContactLoss] = field(default_factory=dict)
    notes: tuple[str, ...] = ()


def torque_of_losses(
    model: str,
    balls: LoadedBalls,
    losses: Mapping[str, ContactLoss],
    converged: BoolArray,
    notes: tuple[str, ...] = (),
) -> Torque:
    """Add the losses of all contacts at a unit relative speed up: T = Σ M |ω_rel|/ω."""
    fine = np.asarray(converged & balls.solved)
    marked = np.where(fine, 1.0, np.nan)[:, np.newaxis]
    unit = {name: loss.scaled(marked) for name, loss in losses.items()}
    parts = {name: loss.total for name, loss in unit.items()}
    total = np.sum(list(parts.values()), axis=0)
    speed = np.abs(balls.relative_speed)
    return Torque(
        model=model,
        total=total,
        parts=parts,
        power=total * speed[:, 0],
        converged=fine,
        losses={name: loss.scaled(speed) for name, loss in unit.items()},
        notes=notes,
    )


def torque_of_parts(
    model: str, parts: Mapping[str, FloatArray], speed: FloatArray, notes: tuple[str, ...] = ()
) -> Torque:
    """The torque of a model that knows no contacts; speed: of the rings to each other, rad/s."""
    total = np.asarray(np.sum(list(parts.values()), axis=0))
    return Torque(model, total, parts, total * np.abs(speed), np.isfinite(total), notes=notes)


def checked_coefficient(value: ArrayLike, name: str, most: float = 1.0) -> FloatArray:
    """A coefficient for every case, as a column (cases or 1, 1).

    Raises
    ------
    InputError
        If it is not a number, or an array of them over cases, from 0 to `most`.
    """
    array = np.asarray(value, dtype=np.float64)
    if array.ndim > 1 or not np.all((array >= 0.0) & (array <= most)):
        raise InputError(
            f"must be from 0 to {most:g}, one number or one for each case",
            field=name,
            value=value if array.ndim == 0 else "an array",
            example=f"{name} = 0.1",
        )
    return array.reshape(-1, 1)


def checked_positive(value: ArrayLike, name: str, *, zero: bool = False) -> FloatArray:
    """Numbers above zero (or zero as well) as an array.

    Raises
    ------
    InputError
        If one is not.
    """
    array = np.asarray(value, dtype=np.float64)
    fine = np.isfinite(array) & ((array >= 0.0) if zero else (array > 0.0))
    if not np.all(fine):
        raise InputError(
            "must be a number of at least zero" if zero else "must be a number above zero",
            field=name,
            value=value if array.ndim == 0 else "an array",
        )
    return array
