"""Friction over one field of a case: every model at every point, and where it holds.

Beside the models without inertia stands the motion that friction alone gives the balls with their
inertia (`raceway_control = "friction"`): it holds at any speed, and has a ratio of spin to roll
at both contacts, where raceway control makes one of them zero.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from rolamento.analysis import BatchAnalysis, analyse_batch, joined, least_film_parameter
from rolamento.case import Case
from rolamento.errors import InputError
from rolamento.friction import Friction
from rolamento.rows.ball import BatchState
from rolamento.solution import solve_batch
from rolamento.studies.fields import Field
from rolamento.studies.ranges import MOST_POINTS, Range, read_range, refuse_many_singles
from rolamento.studies.solving import array_fields, base_case

__all__ = ["MOST_POINTS", "Controlled", "FrictionCurve", "Range", "friction_curve", "read_range"]

Floats = NDArray[np.float64]

_COEFFICIENT: Final = "lubricant.friction_coefficient"
_TEMPERATURE: Final = "temperature.lubricant"


@dataclass(frozen=True, slots=True, eq=False)
class Controlled:
    """Balls that friction alone controls, their inertia counted; arrays (points,), SI.

    torque: of the friction in the contacts, N·m; cage_speed rad/s; inner_spin_to_roll and
    outer_spin_to_roll of the ball with the greatest inner load. NaN without a result.
    """

    torque: Floats
    cage_speed: Floats
    inner_spin_to_roll: Floats
    outer_spin_to_roll: Floats


@dataclass(frozen=True, slots=True, eq=False)
class FrictionCurve:
    """Friction of a case over the values of one field.

    Attributes
    ----------
    case
        what does not vary
    label
        what sets this curve apart from others beside it; empty of the case itself
    field, values
        what varies, (points,), SI
    status
        (points,), of each solved case
    friction
        arrays over the points
    film_parameter
        (points,), the least λ of all contacts; NaN where it is not known
    controlled
        under friction control; None for a set of rows
    """

    case: Case
    label: str
    field: Field
    values: Floats
    status: NDArray[np.str_]
    friction: Friction
    film_parameter: Floats
    controlled: Controlled | None

    def __len__(self) -> int:
        """Count the points."""
        return len(self.values)

    @property
    def converged(self) -> bool:
        """Whether every point has a result."""
        return bool(np.all(self.status == "converged"))

    @property
    def is_speed(self) -> bool:
        """Whether the field is a speed of a ring."""
        return self.field.dimension == "angular_speed"

    @property
    def beside_contacts(self) -> Floats:
        """Torque of hysteresis and oil, which every model has to be given; (points,), N·m."""
        friction = self.friction
        return np.asarray(friction.torque - friction.models[friction.model].total)

    def torque(self, model: str) -> Floats:
        """Running torque of all sources by a model of the contacts; (points,), N·m."""
        return np.asarray(self.friction.models[model].total + self.beside_contacts)

    @property
    def controlled_torque(self) -> Floats:
        """The same under friction control; (points,), N·m."""
        if self.controlled is None:
            return np.full(len(self), np.nan)
        return np.asarray(self.controlled.torque + self.beside_contacts)


def friction_curve(
    case: Case, over: Range, *, hysteresis: float = 0.01, label: str = ""
) -> FrictionCurve:
    """Solve a case over a range, and find the friction by every model.

    Parameters
    ----------
    case
        Must have a friction coefficient, unless that is what varies.
    over
        From `read_range`.
    hysteresis
        Part α_h of the elastic work that the material loses.
    label
        What sets this case apart.

    Raises
    ------
    InputError
        If there is no friction coefficient, or the field does not go with the case.
    """
    mu = None if case.lubricant is None else case.lubricant.friction_coefficient
    if mu is None and over.field.name != _COEFFICIENT:
        raise InputError(
            "is missing: friction rests on it",
            field=_COEFFICIENT,
            example="--coefficient 0.1",
        )
    blocks = _blocks(case, over, hysteresis)
    found = joined([analysis for _, _, analysis in blocks])
    assert found.friction is not None
    film = None if found.film is None else least_film_parameter(found.film)
    return FrictionCurve(
        case=case,
        label=label,
        field=over.field,
        values=over.values,
        status=np.concatenate([batch.status for _, batch, _ in blocks]),
        friction=found.friction,
        film_parameter=np.full(len(over.values), np.nan) if film is None else film,
        controlled=_controlled(case, over, blocks),
    )


Block = tuple[Case, BatchState, BatchAnalysis]


def _blocks(case: Case, over: Range, hysteresis: float) -> list[Block]:
    """One batch where the field varies as an array, else a batch of one for each value."""
    name, values = over.field.name, over.values
    if name in array_fields():
        batch = solve_batch(case, {name: values})
        mu = values if name == _COEFFICIENT else None
        warm = values if name == _TEMPERATURE else None
        analysis = analyse_batch(
            case,
            batch,
            model="jones_full",
            hysteresis=hysteresis,
            compare=True,
            friction_coefficient=mu,
            lubricant_temperature=warm,
        )
        return [(case, batch, analysis)]
    return [_single(own, hysteresis) for own in _cases(case, over)]


def _cases(case: Case, over: Range) -> list[Case]:
    refuse_many_singles(len(over.values))
    return [base_case(case, {over.field.name: float(value)}) for value in over.values]


def _single(case: Case, hysteresis: float) -> Block:
    batch = solve_batch(case)
    analysis = analyse_batch(case, batch, model="jones_full", hysteresis=hysteresis, compare=True)
    return case, batch, analysis


def _controlled(case: Case, over: Range, blocks: Sequence[Block]) -> Controlled | None:
    """Solve again under friction control, unless that is how it was solved."""
    if case.bearing.is_set:
        return None
    name = over.field.name
    parts = []
    for own, solved, _ in blocks:
        batch = solved
        if own.model.raceway_control != "friction":
            changed = own.replace(model=own.model.replace(raceway_control="friction"))
            values = {name: over.values} if name in array_fields() else {}
            batch = solve_batch(changed, values)
        parts.append(_motion(batch))
    return Controlled(*(np.concatenate(columns) for columns in zip(*parts, strict=True)))


def _motion(batch: BatchState) -> tuple[Floats, Floats, Floats, Floats]:
    """Torque, cage speed and the ratios of the heaviest ball; NaN without a result."""
    from rolamento.rows.ball import layout

    row = batch.rows[0]
    nothing = np.full(len(batch), np.nan)
    if row.rolling is None:
        return nothing, nothing, nothing, nothing
    table = batch.balls()
    speed = np.abs(row.parameters[layout.INNER_SPEED] - row.parameters[layout.OUTER_SPEED])
    power = row.rolling.power.sum(axis=(1, 2))
    with np.errstate(divide="ignore", invalid="ignore"):
        torque = np.where(speed > 0.0, power / speed, np.nan)
    heaviest = np.argmax(np.nan_to_num(table.inner.load), axis=1)[:, np.newaxis]
    ratios = (
        np.take_along_axis(values, heaviest, axis=1)[:, 0]
        for values in (table.motion.inner_spin_to_roll, table.motion.outer_spin_to_roll)
    )
    inner, outer = (np.where(batch.converged, ratio, np.nan) for ratio in ratios)
    solved = batch.converged
    cage = np.where(solved, row.rolling.cage_speed, np.nan)
    return np.where(solved, torque, np.nan), cage, inner, outer
