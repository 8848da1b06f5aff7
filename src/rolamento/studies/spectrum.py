"""Life under a duty of several steps: read from a table, every step solved, damage gathered.

Miner: a step uses up its share of the revolutions over the life that it alone would allow. For the
lives that know the races apart, each race gathers its damage before the races combine, for the
steps may load different races and rows.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.case import Case
from rolamento.case.life_model import LifeModel
from rolamento.errors import InputError
from rolamento.life import Headline
from rolamento.life.iso281 import hours
from rolamento.life.iso16281 import SLOPE
from rolamento.life.reliability import Edition, reliability_factor, reliability_of
from rolamento.life.spectrum import miner_life, races_under_spectrum, revolution_shares
from rolamento.numerics import BoolArray, FloatArray
from rolamento.solution import solve
from rolamento.studies.duty_steps import DutySteps, read_spectrum
from rolamento.studies.fields import Value
from rolamento.studies.life_solving import (
    LifeBlock,
    gathered,
    gathered_headline,
    gathered_notes,
    life_blocks,
    theories_of,
)
from rolamento.studies.solving import CONVERGED, INVALID_INPUT, array_fields, base_case

if TYPE_CHECKING:
    from rolamento.life.l_able import FactorTable

__all__ = ["DutySteps", "SpectrumHeadline", "SpectrumLife", "life_under", "read_spectrum"]

MOST_WITH_STRESS_VOLUME: Final = 1000
"""Steps up to which the theory of Ioannides and Harris, which takes milliseconds, is evaluated."""
_MOST_SINGLE: Final = 2000
"""Cases of their own that the steps may need."""
_HOUR: Final = 3600.0
_REFERENCE: Final = "iso16281"
_REFERENCES: Final = (_REFERENCE, "iso16281_modified")


@dataclass(frozen=True, slots=True, eq=False)
class SpectrumHeadline:
    """The life that leads under all steps together.

    Attributes
    ----------
    theory
        that it is by in the step that takes most
    life, hours
        millions of revolutions and hours; NaN if a step that takes part has no life
    step_hours
        (steps,): if this step were all of the duty
    damage
        (steps,): share of each step in what ends the life
    holds
        whether the lives of all steps that take part hold
    below
        whether the life is a bound: that of some step is
    """

    theory: str
    life: float
    hours: float
    step_hours: FloatArray
    damage: FloatArray
    holds: bool
    below: bool


@dataclass(frozen=True, slots=True, eq=False)
class SpectrumLife:
    """Life under all steps together, and what each of them takes of it.

    Attributes
    ----------
    case
        what does not vary
    steps
        what does
    status
        (steps,), of each solved step
    time_shares, revolution_shares
        (steps,); each sums to 1
    mean_speed
        of the rings against each other, over the time; rad/s
    life, hours
        by theory: under all steps, millions of revolutions and hours; NaN if a step that takes part
        has no life
    step_life, step_hours
        by theory, (steps,): if this step were all of the duty
    damage
        by theory, (steps,): share of each step in what ends the life
    holds
        by theory: whether it holds in every step that takes part and carries load
    below
        by theory: whether its life is a bound, for that of some step is
    headline
        the life that leads
    notes
        by theory, by name of the note: in which steps it is true, (steps,)
    reliability
        S that the lives are for
    wanted_life
        in s; None if none is wanted
    stress_volume
        whether the theory of Ioannides and Harris was evaluated
    """

    case: Case
    steps: DutySteps
    status: NDArray[np.str_]
    time_shares: FloatArray
    revolution_shares: FloatArray
    mean_speed: float
    life: Mapping[str, float]
    hours: Mapping[str, float]
    step_life: Mapping[str, FloatArray]
    step_hours: Mapping[str, FloatArray]
    damage: Mapping[str, FloatArray]
    holds: Mapping[str, bool]
    below: Mapping[str, bool]
    headline: SpectrumHeadline
    notes: Mapping[str, Mapping[str, BoolArray]]
    reliability: float
    wanted_life: float | None
    stress_volume: bool

    @property
    def taking_part(self) -> BoolArray:
        """(steps,): whether a step turns at all."""
        return np.asarray(self.revolution_shares > 0.0)

    @property
    def converged(self) -> bool:
        """Whether every step that takes part has a result."""
        return bool(np.all(self.status[self.taking_part] == CONVERGED))

    def reliability_of_wanted(self, theory: str | None = None) -> float | None:
        """Reliability with which the wanted life is reached; None if there is none.

        By a theory, or by the life that leads; where that is a bound, so is the reliability.
        """
        own = "2007" if self.case.life is None else self.case.life.edition
        edition: Edition = "1990" if theory == "iso281_1990" else own
        reached = self.headline.hours if theory is None else self.hours[theory]
        hours_for_ninety = reached / float(reliability_factor(self.reliability, edition))
        if self.wanted_life is None or not hours_for_ninety > 0.0:
            return None
        return float(reliability_of(self.wanted_life / _HOUR / hours_for_ninety, edition))


def life_under(
    case: Case, steps: DutySteps, *, nsk_table: FactorTable | None = None
) -> SpectrumLife:
    """Solve every step of a duty, and find the life under all of them.

    Parameters
    ----------
    case
        Supplies what does not vary.
    steps
        From `read_spectrum`.
    nsk_table
        a_NSK of L_able.

    Raises
    ------
    InputError
        If a step is no valid case, or has no life for its geometry, with its line; or if nothing
        turns.
    """
    blocks = _blocks(case, steps, nsk_table)
    speed = _speeds(case, steps)
    time, turns = _both_shares(steps, speed)
    mean_speed = float(time @ speed)
    status = np.empty(len(steps), dtype="U16")
    for block in blocks:
        status[block.index] = block.status
    theories, count = theories_of(blocks), len(steps)
    notes = {t: gathered_notes(blocks, t, count) for t in theories}
    idle = notes[_REFERENCE].get("unloaded", np.zeros(count, dtype=np.bool_))
    step_life = {t: gathered(blocks, t, "life", count) for t in theories}
    summed = {t: _idling(step_life[t], idle) for t in theories}
    reference = _idling(_races(blocks, count), idle)
    races: dict[str, FloatArray] = {
        t: reference * _factor(blocks, t, count)[:, np.newaxis]
        for t in _REFERENCES
        if t in theories
    }
    life = {t: _life(summed[t], races.get(t), turns) for t in theories}
    part = (turns > 0.0) & ~idle
    holds = {t: bool(np.all(gathered(blocks, t, "holds", count)[part] > 0.0)) for t in theories}
    below = {t: gathered(blocks, t, "below", count) > 0.0 for t in theories}
    leading = gathered_headline(blocks, count)
    wishes = case.life or LifeModel()
    return SpectrumLife(
        case=case,
        steps=steps,
        status=status,
        time_shares=time,
        revolution_shares=turns,
        mean_speed=mean_speed,
        life=life,
        hours={t: float(hours(life[t], mean_speed)) for t in theories},
        step_life=step_life,
        step_hours={t: hours(step_life[t], speed) for t in theories},
        damage={t: _damage(summed[t], races.get(t), turns) for t in theories},
        holds={t: held and bool(part.any()) for t, held in holds.items()},
        below={t: bool(np.any(below[t][part])) for t in theories},
        headline=_headline(leading, reference, turns, part, (mean_speed, speed)),
        notes=notes,
        reliability=wishes.reliability,
        wanted_life=wishes.wanted_life,
        stress_volume=len(steps) <= MOST_WITH_STRESS_VOLUME,
    )


def _headline(
    leading: Headline,
    races: FloatArray,
    turns: FloatArray,
    part: BoolArray,
    speeds: tuple[float, FloatArray],
) -> SpectrumHeadline:
    """Sum the lives that lead, race by race; races: by the basic reference life."""
    mean_speed, speed = speeds
    with np.errstate(invalid="ignore"):
        own = np.where(np.isinf(races), races, races * leading.factor[:, np.newaxis])
    whole = _life(leading.life, own, turns)
    damage = _damage(leading.life, own, turns)
    leads = bool(part.any()) and bool(np.all(leading.leads[part]))
    below = leads and bool(np.any(leading.below[part]))
    return SpectrumHeadline(
        theory=str(leading.theory[int(np.argmax(np.nan_to_num(damage)))]),
        life=whole,
        hours=float(hours(whole, mean_speed)),
        step_hours=hours(leading.life, speed),
        damage=damage,
        holds=leads and not below,
        below=below,
    )


def _blocks(case: Case, steps: DutySteps, nsk_table: FactorTable | None) -> list[LifeBlock]:
    """Solve all steps; the first that is no valid case is an error with its line."""
    single = [values for name, values in steps.values.items() if name not in array_fields()]
    if single and len(set(zip(*single, strict=True))) > _MOST_SINGLE:
        raise InputError(
            f"needs more than {_MOST_SINGLE} cases of their own; let fewer steps differ in"
            f" {', '.join(n for n in steps.values if n not in array_fields())}",
            source=steps.source,
        )
    columns: dict[str, Sequence[Value]] = dict(steps.values)
    if not columns:
        columns = {"duty.inner_speed": [case.duty.inner_speed] * len(steps)}
    detailed = len(steps) <= MOST_WITH_STRESS_VOLUME
    blocks = list(life_blocks(case, columns, stress_volume=detailed, nsk_table=nsk_table))
    for block in blocks:
        for row in block.index[block.status == INVALID_INPUT].tolist():
            _refuse(case, steps, row, block.refused)
    return blocks


def _refuse(case: Case, steps: DutySteps, row: int, error: InputError | None) -> None:
    """Tell why a step is no valid case, by what it says when it is solved alone."""
    try:
        if error is not None:
            raise error
        solve(base_case(case, {name: values[row] for name, values in steps.values.items()}))
    except InputError as found:
        raise found.with_details(source=steps.source, line=steps.lines[row]) from None


def _speeds(case: Case, steps: DutySteps) -> FloatArray:
    """Speed of the rings against each other in every step, unsigned, rad/s."""

    def column(name: str) -> FloatArray:
        given = steps.values.get(f"duty.{name}")
        alike = [getattr(case.duty, name)] * len(steps)
        return np.array(alike if given is None else given, dtype=np.float64)

    return np.asarray(np.abs(column("inner_speed") - column("outer_speed")))


def _both_shares(steps: DutySteps, speed: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Shares of time and of revolutions."""
    if not np.any(speed[steps.shares > 0.0] > 0.0):
        raise InputError(
            "turns in no step: there is no life without rotation",
            field="duty.inner_speed",
            source=steps.source,
            example='duty.inner_speed = "2000 rpm"',
        )
    if steps.kind == "share":
        return steps.shares, revolution_shares(steps.shares, speed)
    standing = np.flatnonzero((speed == 0.0) & (steps.shares > 0.0))
    if standing.size:
        raise InputError(
            "has revolutions, and nothing turns; give shares of the time instead",
            field="revolutions",
            source=steps.source,
            line=steps.lines[int(standing[0])],
        )
    time = np.divide(steps.shares, speed, out=np.zeros(len(steps)), where=steps.shares > 0.0)
    return time / time.sum(), steps.shares


def _races(blocks: Sequence[LifeBlock], count: int) -> FloatArray:
    """Basic reference life of every race in every step, (steps, races)."""
    parts = []
    for block in blocks:
        if block.summary is not None:
            reference = block.summary.reference
            races = np.concatenate([reference.inner, reference.outer], axis=1)
            parts.append((block.index, races))
    found = np.full((count, parts[0][1].shape[1]), np.nan)
    for index, races in parts:
        found[index] = races
    return found


def _factor(blocks: Sequence[LifeBlock], theory: str, count: int) -> FloatArray:
    """a_1 a_ISO of every step by a reference theory, (steps,)."""
    found = np.full(count, np.nan)
    for block in blocks:
        if block.summary is not None and theory in block.summary.theories:
            factors = block.summary[theory].factors
            found[block.index] = factors["a_1"] * factors.get("a_iso", np.ones(len(block.index)))
    return found


def _idling(lives: FloatArray, idle: BoolArray) -> FloatArray:
    """Lives of steps, or of their races, endless where no ball carries load: no damage there."""
    where = idle if lives.ndim == 1 else idle[:, np.newaxis]
    return np.where(where, np.inf, lives)


def _life(lives: FloatArray, races: FloatArray | None, shares: FloatArray) -> float:
    if races is None:
        return float(miner_life(lives, shares))
    half = races.shape[1] // 2
    return float(races_under_spectrum(races[:, :half], races[:, half:], shares))


def _damage(lives: FloatArray, races: FloatArray | None, shares: FloatArray) -> FloatArray:
    """Share of each step in what ends the life: of races, by how much they risk."""
    own = lives[:, np.newaxis] if races is None else races
    with np.errstate(divide="ignore", invalid="ignore"):
        used = np.where(shares[:, np.newaxis] > 0.0, shares[:, np.newaxis] / own, 0.0)
        total = used.sum(axis=0)
        risk = total**SLOPE / np.sum(total**SLOPE)
        parts = np.where(total > 0.0, used / total, 0.0)
        return np.asarray(parts @ risk)
