"""Friction of solved cases: torque, power, heat, and which models are valid."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any, Final, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.case import Case
from rolamento.errors import InputError, arguments
from rolamento.friction.bounds import upper_bounds
from rolamento.friction.closed_forms import DEFAULT_HYSTERESIS
from rolamento.friction.coefficient import (
    SLIDING_AT_START,
    Coefficient,
    coefficient_by_regime,
)
from rolamento.friction.line_losses import RIB_COEFFICIENT
from rolamento.friction.machine import MachineBearing
from rolamento.friction.model import (
    REMARKS,
    ContactLoss,
    ControlChoice,
    ModelValidity,
    Setting,
    Torque,
    TorqueModel,
    checked_coefficient,
    hysteresis_loss,
    over_cases,
    torque_of_losses,
    validity_of,
)
from rolamento.friction.models import CONTACT_MODELS, ROLLER_MODEL, TORQUE_MODELS
from rolamento.friction.rollers import (
    line_hysteresis_loss,
    line_resistance_loss,
    roller_sliding,
    starting_losses,
)
from rolamento.friction.rolling_resistance import rolling_resistance_loss
from rolamento.friction.traction import EllipseMesh
from rolamento.io.json import plain
from rolamento.lubrication.films import film, has_film
from rolamento.numerics import BoolArray, FloatArray
from rolamento.numerics.blocks import in_blocks
from rolamento.records import Lazily, frozen, span
from rolamento.solved import Solved, refuse_other
from rolamento.validate import one_of, positive
from rolamento.words import Note, said
from rolamento.words.headlines import qualifies

T = TypeVar("T")

HYSTERESIS: Final = "hysteresis"
ROLLING_RESISTANCE: Final = "rolling_resistance"
MODELS_AGREE: Final = 1.5
"""Ratio to the models of whole bearings above which a difference is worth a note: their own authors
put a torque within some tens of percent."""


@frozen(eq=False)
class Friction:
    """Friction of solved cases; arrays over cases, NaN without a result.

    Attributes
    ----------
    friction_coefficient
        μ between elements and races, (cases,)
    coefficient_range
        its lower and upper limits, (cases, 2): the same twice where it was given
    by_regime
        whether the coefficient is that of the regime of lubrication, for want of a given one
    model
        of the friction in the contacts
    torque
        running torque of all sources, (cases,), N·m; at rest the limit of slow turning
    torque_range
        the torque with the coefficient at its limits, (cases, 2), N·m
    starting_torque
        of the first motion: static friction and hysteresis, (cases,), N·m; at the ribs of rollers
        with 0.2 if no static coefficient is given
    power
        running torque times the relative speed of the rings, (cases,), W
    torque_by_source
        "spin", "rolling_slip", "rib" of rollers, "hysteresis", "rolling_resistance": (cases,), N·m
    heat
        the same sources, contact by contact: (cases, elements), W; sums up to the power
    film_parameter
        the minimum λ of all contacts, (cases,); NaN where it is not known
    regime
        (cases,): "boundary", "mixed", "full_film" or "unknown"
    models
        every model that could be evaluated: its torque
    validities
        whether each of them is valid here, and if not, why; both are found when they are looked up
    bounds
        why the torque is an upper bound, by keys of notes: in which cases, (cases,)
    """

    friction_coefficient: FloatArray
    coefficient_range: FloatArray
    by_regime: bool
    model: str
    torque: FloatArray
    torque_range: FloatArray
    starting_torque: FloatArray
    power: FloatArray
    torque_by_source: Mapping[str, FloatArray]
    heat: Mapping[str, ContactLoss]
    film_parameter: FloatArray
    regime: NDArray[np.str_]
    models: Mapping[str, Torque]
    validities: Mapping[str, ModelValidity]
    bounds: Mapping[str, BoolArray]

    def _shown(self) -> dict[str, str]:
        bound = ", at most" if self.upper_bound.any() else ""
        parts = self.torque_by_source.items()
        rounding = 1e-12 * np.nanmax([np.abs(part) for _, part in parts], axis=0, initial=0.0)
        return {
            "": f"{self.model}{bound}",
            "cases": str(len(self.torque)),
            "torque": f"{span(1e3 * self.torque, 'N mm')}, {span(1e3 * self.torque_range, 'N mm')}"
            " with the coefficient at its limits",
            "power": span(self.power, "W"),
            "starting torque": span(1e3 * self.starting_torque, "N mm"),
            "friction coefficient": span(self.friction_coefficient),
            "regime": ", ".join(dict.fromkeys(map(str, self.regime))),
            "torque by source, N mm": ", ".join(
                f"{name} {span(np.where(np.abs(part) <= rounding, 0.0, 1e3 * part))}"
                for name, part in parts
            ),
            "models": ", ".join(self.models),
        }

    @property
    def validity(self) -> tuple[ModelValidity, ...]:
        """Whether each of the models is valid, and if not, why."""
        return tuple(self.validities.values())

    @property
    def upper_bound(self) -> BoolArray:
        """(cases,): whether torque and power are an upper bound only."""
        return np.asarray(np.any([np.zeros(len(self.torque), bool), *self.bounds.values()], axis=0))

    @property
    def of_whole_bearings(self) -> FloatArray:
        """Minimum and maximum torque by the models of whole bearings; (cases, 2), N·m.

        Of those that are valid; NaN where there is none.
        """
        whole = [
            np.where(found.valid, self.models[found.model].total, np.nan)
            for found in self.validity
            if not TORQUE_MODELS[found.model].of_contacts
        ]
        if not whole:
            return np.full((len(self.torque), 2), np.nan)
        return np.stack([np.fmin.reduce(whole), np.fmax.reduce(whole)], axis=-1)

    def qualifications(self, solved: Solved, case: int = 0) -> tuple[Note, ...]:
        """Return the notes that qualify torque and power of one case, as `LifeSummary` does.

        Where no model is valid, else where the one that leads is strained; of what they are an
        upper bound; the coefficient that was taken for want of a given one; and how far the models
        of whole bearings lie from them.
        """
        notes = [*self.without_model(solved, case)]
        if not notes:
            leading = [one for one in self.judged if one.model == self.model]
            notes += [note for one in leading for note in one.notes_of(case) if qualifies(note)]
        notes += (Note(key) for key, where in self.bounds.items() if where[case])
        if self.by_regime and solved.converged[case]:
            notes.append(self._coefficient_note(case))
        low, high = self.of_whole_bearings[case]
        own = float(self.torque[case])
        if own < low / MODELS_AGREE or own > high * MODELS_AGREE:
            key = "torque_below_models" if own < low else "torque_above_models"
            notes.append(Note(key, {"low": float(low), "high": float(high)}))
        return tuple(notes)

    def _coefficient_note(self, case: int) -> Note:
        low, high = self.coefficient_range[case]
        torque = self.torque_range[case]
        return Note(
            "coefficient_by_regime",
            {
                "coefficient": float(self.friction_coefficient[case]),
                "low": float(low),
                "high": float(high),
                "low_torque": float(torque[0]),
                "high_torque": float(torque[1]),
            },
        )

    @property
    def judged(self) -> tuple[ModelValidity, ...]:
        """The validity of the models of what rolls in the bearing."""
        return tuple(own for own in self.validity if "for_balls" not in own.limits)

    def valid_models(self, case: int = 0) -> tuple[str, ...]:
        """Name the models that are valid for a case."""
        return tuple(found.model for found in self.validity if found.valid[case])

    def without_model(self, solved: Solved, case: int = 0) -> tuple[Note, ...]:
        """Say that no model is valid for a case, and why; nothing where one is, or may be.

        Where models of the contacts were left out, one of them may be.

        Parameters
        ----------
        solved
            What the friction is of: friction control may give the torque too.
        case
            Which of the cases.
        """
        counts = self.by_regime or self.regime[case] != "full_film"
        controlled = solved.rolling is not None and counts
        of_contacts = (m for m in TORQUE_MODELS.values() if m.of_contacts and m.knows(solved))
        if any(m.name not in self.models for m in of_contacts):
            return ()
        if controlled or self.valid_models(case) or not solved.converged[case]:
            return ()
        reasons: dict[str, list[str]] = {}
        for found in self.validity:
            for note in found.notes_of(case):
                if note.key not in REMARKS:
                    reasons.setdefault(note.key, []).append(TORQUE_MODELS[found.model].title)
        one = Note("no_valid_torque_model", {"reasons": reasons})
        if solved.case.bearing.is_set:
            return (one, no_friction_control())
        inertia = "inertia" in reasons and solved.rolling is None
        return (one, Note("friction_control_has_inertia")) if inertia else (one,)

    def to_mapping(self, case: int = 0) -> dict[str, Any]:
        """Give one case as plain mappings and lists in SI units, NaN as None."""
        mapping: dict[str, Any] = plain(
            {
                "friction_coefficient": self.friction_coefficient[case],
                "coefficient_range": self.coefficient_range[case],
                "coefficient_by_regime": self.by_regime,
                "model": self.model,
                "regime": str(self.regime[case]),
                "torque": self.torque[case],
                "torque_range": self.torque_range[case],
                "upper_bound": bool(self.upper_bound[case]),
                "starting_torque": self.starting_torque[case],
                "power": self.power[case],
                "torque_by_source": {k: part[case] for k, part in self.torque_by_source.items()},
                "heat": {
                    source: {"inner": loss.inner[case], "outer": loss.outer[case]}
                    for source, loss in self.heat.items()
                },
                "models": {
                    found.model: {
                        "torque": self.models[found.model].total[case],
                        **_started(self.models[found.model].starting, case),
                        "parts": {k: p[case] for k, p in self.models[found.model].parts.items()},
                        "valid": found.valid[case],
                        "reasons": [note.to_mapping() for note in found.notes_of(case)],
                    }
                    for found in self.validity
                },
            }
        )
        return mapping


def _started(torque: FloatArray | None, case: int) -> dict[str, Any]:
    """The starting torque of a model that has one of its own."""
    return {} if torque is None else {"starting_torque": torque[case]}


def default_model(solved: Solved, *, quick: bool = False) -> str:
    """Name the model of the contacts that is used if none is named; quick: a closed form."""
    if solved.are_rollers.all():
        return ROLLER_MODEL
    return "jones_simplified" if quick else "jones_full"


def no_friction_control() -> Note:
    """Say that the rows of a set have no friction control."""
    return Note("no_friction_control_of_sets")


def friction(
    solved: Solved,
    *,
    model: str | None = None,
    friction_coefficient: ArrayLike | None = None,
    static_coefficient: ArrayLike | None = None,
    hysteresis: ArrayLike = DEFAULT_HYSTERESIS,
    dynamic_viscosity: ArrayLike | None = None,
    film_parameter: ArrayLike | None = None,
    machine: MachineBearing | Sequence[MachineBearing] | None = None,
    control: ControlChoice = "jones",
    compare: bool | None = None,
    mesh: EllipseMesh | None = None,
    threads: int | None = None,
) -> Friction:
    """Find torque, power and heat of friction in solved bearings.

    With an oil at a known temperature its rolling resistance counts, less what heat in the inlets
    and lack of oil take as `case.film` says, and its film decides which models are valid.

    Parameters
    ----------
    solved
        From `rolamento.solve`.
    model
        Of the friction in the contacts: a name in `CONTACT_MODELS`, by default "jones_full", or
        "roller_sliding", the default of roller bearings.
    friction_coefficient
        μ between elements and races in the place of the lubricant's, a number or (cases,). If
        neither is given, that of the regime of lubrication (`rolamento.friction.coefficient`),
        which needs an oil or a grease at its temperature.
    static_coefficient
        μ at the first motion; if not given μ itself, or 0.15 where that is by the regime, and 0.2
        at the ribs of rollers.
    hysteresis
        α_h of the material; 0 leaves hysteresis out.
    dynamic_viscosity
        η₀ of the oil at the contacts' inlets in the place of the lubricant's, Pa·s.
    film_parameter
        λ of the cases in the place of the film's.
    machine
        Sizes, rating and lubricant of the bearing, or of each of a set, for the models of Palmgren
        and SKF, evaluated in addition.
    control
        Which race the balls roll on, for the models that need it.
    compare
        Whether to evaluate the other models of the contacts too; by default of a single case only.
    mesh
        Points on the ellipses; 80 × 5 by default.
    threads
        As many as there are processors by default.

    Raises
    ------
    InputError
        For an unknown name, a missing coefficient, or a number out of range.
    """
    refuse_other(solved, "friction")
    model = default_model(solved) if model is None else model
    one_of(model, "model", (*CONTACT_MODELS, ROLLER_MODEL), arguments(model="jones_full"))
    mu = friction_coefficient
    if mu is None:
        mu = solved.field("lubricant.friction_coefficient")
        mu = None if np.all(np.isnan(mu)) and len(solved) else mu
    by_regime = mu is None
    if mu is None and not has_film(solved):
        raise no_coefficient(solved.case)
    viscosity, known = dynamic_viscosity, film_parameter
    if has_film(solved):
        if viscosity is None:
            viscosity = np.where(solved.converged, solved.oil.dynamic_viscosity, 0.0)
    elif known is None:
        known = np.nan

    def column(value: ArrayLike, name: str) -> FloatArray:
        return checked_coefficient(value, name, len(solved))

    cases = len(solved)
    if mu is None:
        ranged = coefficient_by_regime(solved)
        static_mu = SLIDING_AT_START if static_coefficient is None else static_coefficient
    else:
        ranged = (Coefficient.given(column(mu, "friction_coefficient")),) * 3
        static_mu = mu if static_coefficient is None else static_coefficient
    machines = () if machine is None else machine
    if viscosity is not None:
        positive(viscosity, "dynamic_viscosity", zero=True, finite=True)
        viscosity = over_cases(viscosity, "dynamic_viscosity", cases)
    setting = Setting(
        solved,
        coefficient=ranged[0],
        limits=ranged[1:],
        static_coefficient=column(static_mu, "static_coefficient"),
        rib_coefficient=column(
            RIB_COEFFICIENT if static_coefficient is None else static_coefficient,
            "static_coefficient",
        ),
        hysteresis=column(hysteresis, "hysteresis"),
        dynamic_viscosity=viscosity,
        film_parameter=None if known is None else over_cases(known, "film_parameter", cases),
        control=control,
        mesh=mesh,
        machines=(machines,) if isinstance(machines, MachineBearing) else tuple(machines),
        by_regime=by_regime,
    )
    compared = len(solved) == 1 if compare is None else compare
    return in_blocks(lambda some: _friction_of(some, model, compared), setting, threads)


def _friction_of(setting: Setting, model: str, compare: bool) -> Friction:
    thinnest = setting.film_parameter
    if thinnest is None:
        thinnest = film(setting.solved, threads=1).minimum_film_parameter[:, np.newaxis]
        setting = replace(setting, film_parameter=thinnest)
    names = [
        name
        for name, own in TORQUE_MODELS.items()
        if name == model or (_shown(own, setting, compare) and setting.supplies(own.needs))
    ]
    models = Lazily(names, lambda name: _torque_by(TORQUE_MODELS[name], setting))
    beside = [_hysteresis(setting)]
    if setting.dynamic_viscosity is not None:
        beside.append(_rolling_resistance(setting, setting.dynamic_viscosity))
    if setting.solved.rollers is not None and model != ROLLER_MODEL:
        beside.append(_sliding(setting, roller_sliding(setting)))
    sources = [models[model], *beside]
    mu = setting.friction_coefficient
    with np.errstate(divide="ignore", invalid="ignore"):
        lift = np.where(mu > 0.0, setting.static_coefficient / mu, 1.0)[:, 0]
    starting = beside[0].total
    if model != ROLLER_MODEL:
        starting = lift * models[model].total + starting
    if setting.solved.rollers is not None:
        starting = starting + _sliding(setting, starting_losses(setting)).total
    torque = np.asarray(np.sum([source.total for source in sources], axis=0))
    by_source = _together([source.parts for source in sources], np.add)
    return Friction(
        friction_coefficient=mu[:, 0],
        coefficient_range=np.hstack([limit.friction_coefficient for limit in setting.at_limits]),
        by_regime=setting.by_regime,
        model=model,
        torque=torque,
        torque_range=_torque_range(setting, models[model], torque),
        starting_torque=starting,
        power=np.sum([source.power for source in sources], axis=0),
        torque_by_source=by_source,
        heat=_together([source.losses for source in sources], ContactLoss.beside),
        film_parameter=thinnest[:, 0],
        regime=setting.regime,
        models=models,
        validities=Lazily(
            names, lambda name: validity_of(TORQUE_MODELS[name], setting, models[name].converged)
        ),
        bounds=upper_bounds(setting, torque, by_source),
    )


def _torque_range(setting: Setting, own: Torque, torque: FloatArray) -> FloatArray:
    """The torque with the coefficient at its limits, (cases, 2).

    The motion of the balls does not depend on the coefficient, so that their torque is in
    proportion to it; rollers slide with one at their races and another at the ribs.
    """
    if not setting.by_regime:
        return np.stack([torque, torque], axis=-1)
    of_balls = own.model != ROLLER_MODEL
    slides = setting.solved.rollers is not None
    here = _sliding(setting, roller_sliding(setting)).total if slides else 0.0
    found = []
    for limit in setting.at_limits:
        changed = np.zeros(len(setting))
        if of_balls:
            ratio = limit.coefficient.balls / setting.coefficient.balls
            changed = own.total * (ratio[:, 0] - 1.0)
        if slides:
            changed = changed + _sliding(limit, roller_sliding(limit)).total - here
        found.append(torque + changed)
    return np.stack(found, axis=-1)


def no_coefficient(case: Case) -> InputError:
    """Say that neither a coefficient of friction nor an oil at its temperature is known."""
    if case.lubricant is not None and case.lubricant.kind != "dry":
        return InputError(
            said("is missing; the friction calculation needs it, or a coefficient of friction"),
            field="temperature.lubricant",
            example='[temperature] with lubricant = "70 degC"',
        )
    return InputError(
        said(
            "is missing; the friction calculation needs it, or an oil or a grease at its"
            " temperature"
        ),
        field="lubricant.friction_coefficient",
        example='lubricant = "ISO VG 68", and [temperature] with lubricant = "70 degC"',
    )


def _together(parts: list[Mapping[str, T]], add: Callable[[T, T], T]) -> dict[str, T]:
    """The parts of all sources by name; balls and rollers of one set both slip in rolling."""
    whole: dict[str, T] = {}
    for name, part in (item for one in parts for item in one.items()):
        whole[name] = add(whole[name], part) if name in whole else part
    return whole


def _shown(own: TorqueModel, setting: Setting, compare: bool) -> bool:
    """Whether a model stands beside the one in use; that of rollers only where there are some."""
    rolls = setting.solved.are_rollers
    if own.name == ROLLER_MODEL:
        return bool(rolls.all())
    return compare or not own.of_contacts


def _torque_by(own: TorqueModel, setting: Setting) -> Torque:
    """The torque by a model; none by one of other elements."""
    if own.knows(setting.solved):
        return own.evaluate(setting)
    nothing = np.full(len(setting), np.nan)
    return Torque(own.name, nothing, {}, nothing, np.zeros(len(setting), np.bool_))


def _sliding(setting: Setting, losses: Mapping[str, ContactLoss]) -> Torque:
    return torque_of_losses(ROLLER_MODEL, setting.solved, losses)


def _hysteresis(setting: Setting) -> Torque:
    solved = setting.solved
    rolls = solved.are_rollers
    if rolls.all():
        lost = line_hysteresis_loss(solved, setting.hysteresis)
    else:
        with np.errstate(all="ignore" if rolls.any() else None):
            lost = hysteresis_loss(solved, setting.unit_motion, setting.hysteresis)
        if rolls.any():
            lost = lost.beside(line_hysteresis_loss(solved, setting.hysteresis))
    return torque_of_losses(HYSTERESIS, solved, {HYSTERESIS: lost})


def _rolling_resistance(setting: Setting, viscosity: FloatArray) -> Torque:
    """The oil's rolling resistance as a torque."""
    solved = setting.solved
    rolls = solved.are_rollers
    speed = solved.relative_speed[:, np.newaxis]
    turning = np.where(speed > 0.0, speed, 1.0)
    if rolls.all():
        lost = line_resistance_loss(solved, viscosity)
    else:
        with np.errstate(all="ignore" if rolls.any() else None):
            lost = rolling_resistance_loss(solved, viscosity[:, 0])
        if rolls.any():
            lost = lost.beside(line_resistance_loss(solved, viscosity))
    with np.errstate(over="ignore", invalid="ignore"):  # of a speed next to none
        lost = lost.scaled(1.0 / turning)
    return torque_of_losses(ROLLING_RESISTANCE, solved, {ROLLING_RESISTANCE: lost})
