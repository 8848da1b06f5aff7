"""Outputs of what may end a bearing beside fatigue in rotation: statics, currents, oscillation."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.studies.outputs import Evaluation, Floats, Output

if TYPE_CHECKING:
    from rolamento.electrical import BearingElectrics
    from rolamento.life.oscillation import OscillationLife
    from rolamento.safety import StaticSafety
    from rolamento.solved import Solved

_SWINGS: Final = ("life", "duty.oscillation")
_OIL: Final = ("lubricant", "temperature.lubricant")


def limit_outputs() -> tuple[Output, ...]:
    """Return the outputs of static safety, of electricity and of oscillation."""
    return (
        *(
            Output(f"oscillation_{name}", unit, _swing(name), needs=_SWINGS, slow=True)
            for name, unit in (("hours", "h"), ("critical", "rad"))
        ),
        Output("static_safety_by_stress", "1", lambda given: _minimum(given, "stress")),
        Output("static_safety_by_load", "1", lambda given: _minimum(given, "load")),
        Output("row_gap", "m", lambda given: given.of(_static).launch.gap, along="row"),
        Output("bearing_capacitance", "F", lambda given: _electrics(given).capacitance, needs=_OIL),
        Output(
            "current_density",
            "A/m^2",
            lambda given: _electrics(given).current_density,
            needs=(*_OIL, "electrical.current"),
        ),
        Output(
            "film_field",
            "V/m",
            lambda given: _electrics(given).field,
            needs=(*_OIL, "electrical.voltage"),
        ),
    )


def _static(solved: Solved) -> StaticSafety:
    from rolamento.safety import static_safety_of

    return static_safety_of(solved)


def _minimum(given: Evaluation, by: str) -> Floats:
    found = given.of(_static)
    return np.where(found.solved.converged, found.minimum(by), np.nan)


def _electrics_of(solved: Solved) -> BearingElectrics:
    from rolamento.electrical import electrics_of

    return electrics_of(solved)


def _electrics(given: Evaluation) -> BearingElectrics:
    return given.of(_electrics_of)


def _oscillations(solved: Solved) -> tuple[OscillationLife | None, ...]:
    """The life of each case in oscillations; None without one."""
    from rolamento.life.oscillation import oscillation_life
    from rolamento.life.row_ratings import UnratedError
    from rolamento.solution import Refused, solve

    def of(index: int) -> OscillationLife | None:
        given = solved.refusals
        case = given.alone(index) if isinstance(given, Refused) else solved.delivered_case
        if case.duty.oscillation is None:
            return None
        try:
            return oscillation_life(solve(case, preload_loss=False))
        except UnratedError:
            return None

    return tuple(of(i) if well else None for i, well in enumerate(solved.converged.tolist()))


def _swing(name: str) -> Callable[[Evaluation], Floats]:
    return lambda given: np.array(
        [np.nan if one is None else getattr(one, name) for one in given.of(_oscillations)]
    )
