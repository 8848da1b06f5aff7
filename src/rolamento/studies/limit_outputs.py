"""Outputs of what may end a bearing beside fatigue in rotation.

Statics, grease, currents, oscillation.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.studies.outputs import Evaluation, Floats, Output
from rolamento.words import marked, said

if TYPE_CHECKING:
    from rolamento.electrical import BearingElectrics
    from rolamento.grease.of_case import GreaseCase
    from rolamento.life.oscillation import OscillationLife
    from rolamento.safety import StaticSafety
    from rolamento.solved import Solved

_SWINGS: Final = ("life", "duty.oscillation")
_OIL: Final = ("lubricant", "temperature.lubricant")


def limit_outputs() -> tuple[Output, ...]:
    """Return the outputs of static safety, of grease, of electricity and of oscillation."""
    return (
        *_of_grease(),
        Output(
            "oscillation_hours",
            "h",
            lambda: said("life in oscillation"),
            _swing("hours"),
            needs=_SWINGS,
            slow=True,
        ),
        Output(
            "oscillation_critical",
            "rad",
            lambda: said("critical angle of oscillation"),
            _swing("critical"),
            needs=_SWINGS,
            slow=True,
        ),
        Output(
            "static_safety_by_stress",
            "1",
            lambda: said("static safety by stress, minimum of all contacts"),
            lambda given: _minimum(given, "stress"),
        ),
        Output(
            "static_safety_by_load",
            "1",
            lambda: said("static safety by load, minimum of all contacts"),
            lambda given: _minimum(given, "load"),
        ),
        Output(
            "row_gap",
            "m",
            lambda: said("gap of a row at the inner race"),
            lambda given: given.of(_static).launch.gap,
            along="row",
        ),
        Output(
            "bearing_capacitance",
            "F",
            lambda: said("capacitance of the bearing"),
            lambda given: given.of(_electrics).capacitance,
            needs=_OIL,
        ),
        Output(
            "current_density",
            "A/m^2",
            lambda: said("apparent current density"),
            lambda given: given.of(_electrics).current_density,
            needs=(*_OIL, "electrical.current"),
        ),
        Output(
            "film_field",
            "V/m",
            lambda: said("electric field across the film"),
            lambda given: given.of(_electrics).field,
            needs=(*_OIL, "electrical.voltage"),
        ),
    )


def _of_grease() -> Iterator[Output]:
    for name, called, get in (
        ("grease_hours", marked("mean life of the grease"), lambda one: one.hours),
        (
            "grease_hours_l10",
            marked("life of the grease that 90 % of the bearings reach"),
            lambda one: one.l10,
        ),
        (
            "relubrication_hours_minimum",
            marked("minimum relubrication interval"),
            lambda one: one.interval[0],
        ),
        (
            "relubrication_hours_maximum",
            marked("maximum relubrication interval"),
            lambda one: one.interval[1],
        ),
    ):
        yield Output(name, "h", partial(said, called), _grease(get), needs=_OIL, slow=True)


def _static(solved: Solved) -> StaticSafety:
    from rolamento.safety import static_safety_of

    return static_safety_of(solved)


def _minimum(given: Evaluation, by: str) -> Floats:
    found = given.of(_static)
    return np.where(found.solved.converged, found.minimum(by), np.nan)


def _electrics(solved: Solved) -> BearingElectrics:
    from rolamento.electrical import electrics_of

    return electrics_of(solved)


def _alone(solved: Solved) -> Iterator[Solved | None]:
    """Each case as a result of its own, with what varied put in its case; None without one."""
    from rolamento.solution import Refused

    for index, well in enumerate(solved.converged.tolist()):
        if not well:
            yield None
            continue
        given, one = solved.refusals, solved[index]
        delivered = given.alone(index) if isinstance(given, Refused) else solved.delivered_case
        before = one.before_mounting
        yield replace(
            one,
            case=delivered if before is None else one.case_at(0),
            varied={},
            refusals=None,
            before_mounting=None if before is None else replace(before, case=delivered),
        )


def _greases(solved: Solved) -> tuple[GreaseCase | None, ...]:
    """The grease of each case; None without a result."""
    from rolamento.grease.of_case import grease_of_solved

    return tuple(None if one is None else grease_of_solved(one) for one in _alone(solved))


def _grease(get: Callable[[GreaseCase], float]) -> Callable[[Evaluation], Floats]:
    return lambda given: np.array(
        [np.nan if one is None else get(one) for one in given.of(_greases)]
    )


def _oscillations(solved: Solved) -> tuple[OscillationLife | None, ...]:
    """The life of each case in oscillations; None without one."""
    from rolamento.life.oscillation import oscillation_life
    from rolamento.life.row_ratings import UnratedError

    def of(one: Solved | None) -> OscillationLife | None:
        if one is None or one.delivered_case.duty.oscillation is None:
            return None
        try:
            return oscillation_life(one)
        except UnratedError:
            return None

    return tuple(of(one) for one in _alone(solved))


def _swing(name: str) -> Callable[[Evaluation], Floats]:
    return lambda given: np.array(
        [np.nan if one is None else getattr(one, name) for one in given.of(_oscillations)]
    )
