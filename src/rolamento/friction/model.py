"""What a torque model is: what it needs, where it is valid, what it returns; and what all share.

A model is a `TorqueModel` at the end of its own file, and `rolamento.friction.models` lists them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field, fields, replace
from functools import cached_property
from typing import TYPE_CHECKING, Final, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.errors import InputError
from rolamento.friction.closed_forms import hysteresis_moment
from rolamento.friction.coefficient import Coefficient
from rolamento.friction.traction import EllipseMesh
from rolamento.kinematics import BallMotion, ball_motion, friction_demand
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.solved import Contacts, Solved
from rolamento.validate import numbers, one_of, within
from rolamento.words import Note, said

if TYPE_CHECKING:
    from rolamento.friction.machine import MachineBearing

ControlChoice = Literal["jones", "state", "inner", "outer"]
_CONTROLS: Final = ("jones", "state", "inner", "outer")

INERTIA_SHARE: Final = 0.1
"""Share of friction, or of the ball's load, that forces of inertia may take at low speed."""

COUNTED_LOAD: Final = 0.05
"""Fraction of the heaviest ball's load: balls with less are not judged for inertia."""

FULL_FILM: Final = 3.0
"""Film parameter λ above which the surfaces do not touch."""

BOUNDARY: Final = 1.0
"""Film parameter λ below which the asperities carry the load."""

RIB_LOAD_SHARE: Final = 0.4
"""F_a/F_r of cylindrical roller bearings up to which Palmgren's f2 is valid."""

REMARKS: Final = (
    "partial_film",
    "film_by_regime",
    "torque_at_rest",
    "rib_film_unknown",
    "rating_of_steel",
)
"""Keys of the notes that do not refuse a model."""


# --- what a model returns ---------------------------------------------------------------------


@frozen(eq=False)
class ContactLoss:
    """What one source loses in the contacts; (cases, elements), W, or N·m at a unit speed."""

    inner: FloatArray
    outer: FloatArray

    @property
    def total(self) -> FloatArray:
        """Sum of all contacts; (cases,)."""
        return np.asarray(np.sum(self.inner + self.outer, axis=-1))

    def scaled(self, factor: FloatArray) -> ContactLoss:
        """The same times a factor, (cases, 1)."""
        return ContactLoss(self.inner * factor, self.outer * factor)

    def beside(self, other: ContactLoss) -> ContactLoss:
        """That of these elements and of others."""
        return ContactLoss(self.inner + other.inner, self.outer + other.outer)


@frozen(eq=False)
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
        does not resolve contacts, zero at rest
    starting
        of the first motion, (cases,), N·m, of a model of roller bearings that has its own
    """

    model: str
    total: FloatArray
    parts: Mapping[str, FloatArray]
    power: FloatArray
    converged: BoolArray
    losses: Mapping[str, ContactLoss] = field(default_factory=dict)
    starting: FloatArray | None = None


def torque_of_losses(
    model: str,
    solved: Solved,
    losses: Mapping[str, ContactLoss],
    converged: BoolArray | None = None,
) -> Torque:
    """Add the losses of all contacts at a unit relative speed up: T = Σ M |ω_rel|/ω.

    converged: whether a motion that had to be sought was found, (cases,).
    """
    fine = has_result(solved) if converged is None else np.asarray(converged & has_result(solved))
    marked = np.where(fine, 1.0, np.nan)[:, np.newaxis]
    unit = {name: loss.scaled(marked) for name, loss in losses.items()}
    parts = {name: loss.total for name, loss in unit.items()}
    total = np.sum(list(parts.values()), axis=0)
    speed = solved.relative_speed
    heat = {name: loss.scaled(speed[:, np.newaxis]) for name, loss in unit.items()}
    return Torque(model, total, parts, total * speed, fine, heat)


def torque_of_parts(model: str, parts: Mapping[str, FloatArray], speed: FloatArray) -> Torque:
    """The torque of a model without contacts; speed: of the rings relative to each other, rad/s."""
    total = np.asarray(np.sum(list(parts.values()), axis=0))
    return Torque(model, total, parts, total * np.abs(speed), np.isfinite(total))


def added(torques: Sequence[Torque]) -> Torque:
    """That of bearings side by side by one model without contacts."""
    first = torques[0]
    if len(torques) == 1:
        return first
    parts = {name: np.sum([one.parts[name] for one in torques], axis=0) for name in first.parts}
    return Torque(
        first.model,
        np.sum([one.total for one in torques], axis=0),
        parts,
        np.sum([one.power for one in torques], axis=0),
        np.all([one.converged for one in torques], axis=0),
    )


# --- what a model reads -----------------------------------------------------------------------


@frozen(eq=False, slots=False)
class Setting:
    """All that a model may ask for; numbers of the cases are columns, (cases, 1).

    Attributes
    ----------
    solved
        the cases
    coefficient
        μ of all that slides
    static_coefficient
        μ between elements and races at the first motion
    rib_coefficient
        μ between rollers and ribs at the first motion
    hysteresis
        α_h of the material
    dynamic_viscosity
        η₀ of the oil at the contacts' inlets, Pa·s; None without an oil
    film_parameter
        the minimum λ of each case; NaN where unknown, None before it is computed
    control
        which race the balls roll on, for models that need it
    mesh
        points on the ellipses; 80 × 5 by default
    machines
        size, rating and lubricant of each bearing of the set, or of the one; empty if not known
    by_regime
        whether the coefficient is that of the regime of lubrication, rather than given
    limits
        the coefficient at its lower and upper limits
    """

    solved: Solved
    coefficient: Coefficient
    static_coefficient: FloatArray
    rib_coefficient: FloatArray
    hysteresis: FloatArray
    dynamic_viscosity: FloatArray | None = None
    film_parameter: FloatArray | None = None
    control: ControlChoice = "jones"
    mesh: EllipseMesh | None = None
    machines: tuple[MachineBearing, ...] = ()
    by_regime: bool = False
    limits: tuple[Coefficient, ...] = ()

    def __len__(self) -> int:
        """Count the cases."""
        return len(self.solved)

    def __getitem__(self, some: slice) -> Setting:
        """Return that of some of the cases."""
        changed = {
            part.name: getattr(self, part.name)[some]
            for part in fields(self)
            if isinstance(getattr(self, part.name), np.ndarray | Solved | Coefficient)
        }
        machines = tuple(machine.part(some) for machine in self.machines)
        limits = tuple(limit[some] for limit in self.limits)
        return replace(self, machines=machines, limits=limits, **changed)

    @property
    def at_limits(self) -> tuple[Setting, ...]:
        """The same with the coefficient at its lower and at its upper limit."""
        return tuple(replace(self, coefficient=limit) for limit in self.limits)

    @property
    def friction_coefficient(self) -> FloatArray:
        """μ between elements and races, of a set of balls and rollers that of balls; (cases, 1)."""
        if self.solved.are_rollers.all():
            return self.coefficient.rollers[:, :1]
        return self.coefficient.balls

    @cached_property
    def regime(self) -> NDArray[np.str_]:
        """Regime of lubrication, (cases,): see `film_regime`."""
        if self.film_parameter is None:
            return np.full(len(self), "unknown")
        return film_regime(self.film_parameter[:, 0])

    @cached_property
    def unit_motion(self) -> BallMotion:
        """How the balls roll on the race that controls them, as of the function `unit_motion`."""
        return unit_motion(self.solved, controlling_race(self.solved, self.control))

    def supplies(self, needs: tuple[str, ...]) -> bool:
        """Whether the needs of a model, attributes of this or of all its machines, are known."""
        return all(
            hasattr(self, need)
            or (self.machines and all(getattr(one, need) is not None for one in self.machines))
            for need in needs
        )


@frozen(eq=False)
class TorqueModel:
    """One model of the friction torque.

    Attributes
    ----------
    name
        as callers, case files and JSON have it
    title, short_title
        in English: of a row, of a narrow column
    needs
        attributes of `Setting`, or of its machines, that must be known
    evaluate
        the torque; of models of the contacts without hysteresis and oil, which are added to each
    limits
        the cases in which the model is not valid, or only with a remark, by keys of notes
    of_contacts
        whether it resolves contacts, rather than the bearing as a whole
    closed_form
        whether a case takes microseconds
    elements
        what may roll in the rows; empty of models of any bearing
    """

    name: str
    title: str
    short_title: str
    needs: tuple[str, ...]
    evaluate: Callable[[Setting], Torque]
    limits: Callable[[Setting], Mapping[str, BoolArray]]
    of_contacts: bool = True
    closed_form: bool = False
    elements: tuple[str, ...] = ("ball",)

    def knows(self, solved: Solved) -> bool:
        """Whether the model is of one of the elements of a bearing."""
        return not (self.of_contacts and set(self.elements).isdisjoint(solved.rows.element))


# --- where a model is valid -------------------------------------------------------------------


@frozen(eq=False)
class ModelValidity:
    """Whether a model is valid, (cases,); limits: by key of a note in which cases, (cases,)."""

    model: str
    valid: BoolArray
    limits: Mapping[str, BoolArray]

    @property
    def notes(self) -> dict[str, BoolArray]:
        """The limits that concern at least one case."""
        return {name: where for name, where in self.limits.items() if np.any(where)}

    def notes_of(self, case: int = 0) -> tuple[Note, ...]:
        """Return why the model is not valid for a case, and the remarks on it."""
        values = {"inertia": {"share": INERTIA_SHARE}, "axial_share": {"share": RIB_LOAD_SHARE}}
        return tuple(Note(k, values.get(k, {})) for k, where in self.limits.items() if where[case])


def validity_of(model: TorqueModel, setting: Setting, converged: BoolArray) -> ModelValidity:
    """Judge a model for every case; converged: whether it found a result."""
    if not model.knows(setting.solved):
        known = np.zeros(len(setting), np.bool_)
        return ModelValidity(model.name, known, {"for_balls": ~known})
    limits = {
        **model.limits(setting),
        **({"more_contacts": touches_both_arcs(setting.solved)} if model.of_contacts else {}),
        "torque_at_rest": setting.solved.relative_speed == 0.0,
        "torque_unknown": ~converged,
    }
    refused = [where for name, where in limits.items() if name not in REMARKS]
    return ModelValidity(model.name, ~np.any(refused, axis=0), limits)


def touches_both_arcs(solved: Solved) -> BoolArray:
    """(cases,): whether a ball of a four-point bearing bears on more than one arc of a ring."""
    if not solved.case.bearing.bearing_type.has_arches:
        return np.zeros(len(solved), np.bool_)
    with np.errstate(invalid="ignore"):
        pairs = solved.loaded.reshape(len(solved), 2, -1)
    return np.asarray(np.any(np.all(pairs, axis=1), axis=1))


def limits_of_dry_friction(setting: Setting) -> dict[str, BoolArray]:
    """Limits of models of dry or boundary friction without inertia."""
    film = setting.regime == "full_film"
    return {
        "inertia": inertia_counts(setting.solved, setting.friction_coefficient),
        "full_film": film & (not setting.by_regime),
        "film_by_regime": film & setting.by_regime,
        "partial_film": setting.regime == "mixed",
    }


def limits_of_lubricated_bearings(setting: Setting) -> dict[str, BoolArray]:
    """Limits of models of lubricated machine bearings."""
    return {"no_film": setting.regime == "boundary"}


def film_regime(film_parameter: FloatArray) -> NDArray[np.str_]:
    """Name the regimes of film parameters λ: "boundary", "mixed", "full_film" or "unknown"."""
    with np.errstate(invalid="ignore"):
        choices = [
            film_parameter < BOUNDARY,
            film_parameter <= FULL_FILM,
            film_parameter > FULL_FILM,
        ]
    return np.select(choices, ["boundary", "mixed", "full_film"], "unknown")


def inertia_counts(solved: Solved, coefficient: FloatArray) -> BoolArray:
    """(cases,): whether inertia takes a share of a ball's friction or load that cannot be left.

    coefficient : μ, (cases or 1, 1).
    """
    elements, inner, outer = solved.elements, solved.inner, solved.outer
    demand = friction_demand(elements.gyroscopic_moment, inner.ball_diameter, outer.load)
    with np.errstate(invalid="ignore"):
        turned = demand > INERTIA_SHARE * coefficient
        thrown = elements.centrifugal_force > INERTIA_SHARE * inner.load
        heaviest = np.max(inner.load, axis=-1, keepdims=True)
        counted = solved.balls_bear & (inner.load > COUNTED_LOAD * heaviest)
    return np.asarray(np.any(counted & (turned | thrown), axis=-1))


# --- what models read of solved cases ---------------------------------------------------------


def has_result(solved: Solved) -> BoolArray:
    """(cases,): whether a case has a result, with ellipses narrower than the balls."""
    with np.errstate(invalid="ignore"):
        inner, outer = (2.0 * r.semi_major < r.ball_diameter for r in solved.contacts.values())
    fine = np.isfinite(solved.outer.load) & (inner & outer | ~solved.balls_bear)
    return np.asarray(np.all(fine, axis=-1))


def bearing_load(solved: Solved, machine: MachineBearing) -> tuple[FloatArray, FloatArray]:
    """Radial and axial load of one bearing of a set, or of the one, (cases,) each; N."""
    if machine.row is None:
        load = solved.load
        return np.hypot(load.fy, load.fz), load.fx
    row = solved.rows.load[:, machine.row]
    return np.hypot(row[:, 1], row[:, 2]), row[:, 0]


# --- how balls move under raceway control, and what that loses ---------------------------------


def controlling_race(solved: Solved, control: ControlChoice) -> NDArray[np.int64]:
    """Return which race each ball rolls on without spin: 1 outer, -1 inner; (cases, elements).

    control: "inner", "outer"; "state", as the state was solved; "jones", the race with the
    greater resistance to spin Q a E. Where the state's control is undecided, Jones's is taken.

    Raises
    ------
    InputError
        For any other word.
    """
    one_of(control, "control", _CONTROLS, 'control = "jones"')
    inner, outer = (race.resistance_to_spin for race in solved.contacts.values())
    if control in ("inner", "outer"):
        return np.full(inner.shape, 1 if control == "outer" else -1, dtype=np.int64)
    jones = np.where(outer > inner, 1, -1)
    if control == "jones":
        return jones.astype(np.int64)
    own = solved.elements.raceway_control
    return np.where(own != 0, own, jones).astype(np.int64)


def unit_motion(solved: Solved, control: NDArray[np.int64]) -> BallMotion:
    """Motion under raceway control for a unit speed of the inner ring relative to the outer.

    Seen from the outer ring; arrays (cases, elements), rad/s.
    """
    inner, outer = solved.inner, solved.outer
    ratio = inner.ball_diameter / inner.pitch_diameter
    return ball_motion(inner.angle, outer.angle, ratio, 1.0, 0.0, control)


def loss_at_rates(
    solved: Solved,
    moment: Callable[[Contacts], FloatArray],
    inner_rate: FloatArray,
    outer_rate: FloatArray,
) -> ContactLoss:
    """What a moment in every contact of the loaded balls takes at the rates (cases, elements)."""
    loaded = solved.balls_bear
    return ContactLoss(
        *(
            np.where(loaded, moment(race) * np.abs(rate), 0.0)
            for race, rate in zip(solved.contacts.values(), (inner_rate, outer_rate), strict=True)
        )
    )


def hysteresis_loss(solved: Solved, motion: BallMotion, loss: FloatArray) -> ContactLoss:
    """Loss of every contact by elastic hysteresis, α_h (cases or 1, 1)."""
    return loss_at_rates(
        solved, lambda race: hysteresis_moment(race, loss), motion.inner_roll, motion.outer_roll
    )


# --- checks -----------------------------------------------------------------------------------


def checked_coefficient(value: ArrayLike, name: str, cases: int) -> FloatArray:
    """A coefficient from 0 to 1, one number or one for each case, as a column (cases, 1).

    Raises
    ------
    InputError
        If it is not.
    """
    array = within(value, name, "", 0.0, 1.0, example=f"{name} = 0.1", nan_too=False)
    return over_cases(array, name, cases)


def over_cases(value: ArrayLike, name: str, cases: int) -> FloatArray:
    """One number, or one for each case, as a column (cases, 1).

    Raises
    ------
    InputError
        If there are neither one nor as many as there are cases.
    """
    array = numbers(value, name)
    if array.ndim > 1 or array.size not in (1, cases):
        raise InputError(
            said("must be one number, or one for each of the {cases} cases", cases=cases),
            field=name,
        )
    return np.broadcast_to(array.reshape(-1, 1), (cases, 1))
