"""Friction over one field of a case: every model at every point, and where it is valid.

Beside the models without inertia stands the motion that friction alone gives the balls with their
inertia (`raceway_control = "friction"`): it holds at any speed, and has a ratio of spin to roll
at both contacts, where raceway control makes one of them zero.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.analysis.needs import has_friction, machines_known
from rolamento.case import Case
from rolamento.friction import Friction, friction
from rolamento.friction.coefficient import SLIDING_BOUNDARY, coefficient_by_regime
from rolamento.friction.models import TORQUE_MODELS
from rolamento.friction.summary import no_coefficient
from rolamento.lubrication.films import film, has_film
from rolamento.numerics.blocks import joined
from rolamento.records import frozen
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.studies.fields import Field
from rolamento.studies.ranges import MOST_POINTS, Range, read_range, refuse_many_singles
from rolamento.studies.solving import array_fields, base_case
from rolamento.words.headlines import Qualified, over_cases

__all__ = [
    "MOST_POINTS",
    "Controlled",
    "FrictionCurve",
    "Range",
    "curves_mapping",
    "friction_curve",
    "read_range",
]

Floats = NDArray[np.float64]

SCHEMA: Final = 2
_COEFFICIENT: Final = "lubricant.friction_coefficient"


@frozen(eq=False)
class Controlled:
    """Balls that friction alone controls, their inertia counted; arrays (points,), SI.

    torque: of the friction in the contacts, N·m; cage_speed rad/s; inner_spin_to_roll and
    outer_spin_to_roll of the ball with the maximum inner load. NaN without a result.
    """

    torque: Floats
    cage_speed: Floats
    inner_spin_to_roll: Floats
    outer_spin_to_roll: Floats


@frozen(eq=False)
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
    controlled
        under friction control; None for a set of rows, and for rollers
    cautions
        what qualifies torque and power, and at which points
    """

    case: Case
    label: str
    field: Field
    values: Floats
    status: NDArray[np.str_]
    friction: Friction
    controlled: Controlled | None
    cautions: tuple[Qualified, ...]

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
        """Running torque of all sources by a model, NaN where it is not evaluated; (points,), N·m.

        Models of lubricated machine bearings have all sources in them.
        """
        found = self.friction.models.get(model)
        if found is None:
            return np.full(len(self), np.nan)
        if not TORQUE_MODELS[model].of_contacts:
            return np.asarray(found.total)
        return np.asarray(found.total + self.beside_contacts)

    def valid(self, model: str) -> NDArray[np.bool_]:
        """Where a model is valid; (points,)."""
        found = [own.valid for own in self.friction.validity if own.model == model]
        return found[0] if found else np.zeros(len(self), dtype=np.bool_)

    @property
    def controlled_valid(self) -> NDArray[np.bool_]:
        """Where friction control is valid; (points,)."""
        found = np.isfinite(self.controlled_torque)
        return np.asarray(found & (self.friction.by_regime | (self.friction.regime != "full_film")))

    @property
    def without_model(self) -> NDArray[np.bool_]:
        """Where no model is valid though there is a result; (points,)."""
        valid = [own.valid for own in self.friction.validity]
        return np.asarray(
            (self.status == "converged") & ~np.any([*valid, self.controlled_valid], axis=0)
        )

    @property
    def controlled_torque(self) -> Floats:
        """The same under friction control; (points,), N·m."""
        if self.controlled is None:
            return np.full(len(self), np.nan)
        return np.asarray(self.controlled.torque + self.beside_contacts)

    def to_mapping(self) -> dict[str, Any]:
        """Give the points as plain mappings and arrays in SI units."""
        friction, found = self.friction, self.controlled
        nothing = np.full(len(self), np.nan)
        return {
            "label": self.label,
            "status": self.status.tolist(),
            "model": friction.model,
            "torque": friction.torque,
            "starting_torque": friction.starting_torque,
            "power": friction.power,
            "torque_range": friction.torque_range,
            "upper_bound": friction.upper_bound.tolist(),
            "torque_by_source": dict(friction.torque_by_source),
            "regime": friction.regime.tolist(),
            "film_parameter": friction.film_parameter,
            "models": {
                own.model: {
                    "contact_torque": friction.models[own.model].total,
                    "torque": self.torque(own.model),
                    "valid": own.valid.tolist(),
                    "reasons": {name: where.tolist() for name, where in own.notes.items()},
                }
                for own in friction.validity
            },
            "friction_control": {
                "torque": self.controlled_torque,
                **{
                    name: nothing if found is None else getattr(found, name)
                    for name in ("cage_speed", "inner_spin_to_roll", "outer_spin_to_roll")
                },
            },
        }


def curves_mapping(curves: Sequence[FrictionCurve]) -> dict[str, Any]:
    """Give curves over one field, the first the case's own, as plain mappings in SI units."""
    first = curves[0]
    return {
        "schema": SCHEMA,
        "kind": "friction_curve",
        "title": first.case.title,
        "field": first.field.name,
        "unit": first.field.unit,
        "values": first.values,
        "curves": [curve.to_mapping() for curve in curves],
    }


def friction_curve(
    case: Case, over: Range, *, hysteresis: float = 0.01, label: str = ""
) -> FrictionCurve:
    """Solve a case over a range, and find the friction by every model.

    Parameters
    ----------
    case
        Must have a friction coefficient or an oil or a grease at its temperature, unless that is
        what varies.
    over
        From `read_range`.
    hysteresis
        Part α_h of the elastic work that the material loses.
    label
        What sets this case apart.

    Raises
    ------
    InputError
        If there is neither, or the field does not go with the case.
    """
    solutions = _solutions(case, over)
    if not all(has_friction(solved) for solved in solutions):
        raise no_coefficient(case)
    films = (film(solved) if has_film(solved) else None for solved in solutions)
    machines = list(map(machines_known, solutions, films))
    if () in machines:  # the models of all points are the same
        machines = [()] * len(solutions)
    each = [
        friction(solved, hysteresis=hysteresis, compare=True, machine=machine)
        for solved, machine in zip(solutions, machines, strict=True)
    ]
    found = joined(each)
    notes = (
        (*own, *one.qualifications(solved, case))
        for solved, one in zip(solutions, each, strict=True)
        for case, own in enumerate(solved.notes)
    )
    return FrictionCurve(
        case=case,
        label=label,
        field=over.field,
        values=over.values,
        status=np.concatenate([solved.status.code for solved in solutions]),
        friction=found,
        controlled=joined(list(map(_controlled, solutions)))
        if case.bearing.element == "ball" and not case.bearing.is_set
        else None,
        cautions=over_cases(notes),
    )


def _solutions(case: Case, over: Range) -> list[Solved]:
    """One result where the field varies as an array, else one for each value."""
    name, values = over.field.name, over.values
    if name in array_fields():
        return [solve(case, {name: values})]
    refuse_many_singles(len(values))
    return [solve(base_case(case, {name: float(value)})) for value in values]


def _controlled(solved: Solved) -> Controlled:
    """What friction control makes of cases, unless that is how they were solved."""
    case, varied = solved.case, solved.varied
    if case.model.raceway_control != "friction":
        lubricant = case.lubricant
        assert lubricant is not None
        if lubricant.friction_coefficient is None and _COEFFICIENT not in varied:
            mu = coefficient_by_regime(solved)[0].balls[:, 0]
            varied = {**varied, _COEFFICIENT: np.where(np.isfinite(mu), mu, SLIDING_BOUNDARY)}
        if lubricant.friction_coefficient is None:
            lubricant = lubricant.replace(friction_coefficient=SLIDING_BOUNDARY)
        own = case.replace(
            model=case.model.replace(raceway_control="friction"), lubricant=lubricant
        )
        solved = solve(own, varied)
    nothing = np.full(len(solved), np.nan)
    if solved.rolling is None:
        return Controlled(nothing, nothing, nothing, nothing)
    speed = solved.relative_speed
    with np.errstate(divide="ignore", invalid="ignore"):
        torque = np.where(speed > 0.0, solved.rolling.power / speed, np.nan)
    heaviest = np.argmax(np.nan_to_num(solved.inner.load), axis=1)[:, np.newaxis]
    ratios = (
        np.take_along_axis(contacts.spin_to_roll, heaviest, axis=1)[:, 0]
        for contacts in (solved.inner, solved.outer)
    )
    columns = (torque, solved.rolling.cage_speed, *ratios)
    return Controlled(*(np.where(solved.converged, column, np.nan) for column in columns))
