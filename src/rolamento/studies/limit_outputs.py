"""Outputs of what may end a bearing beside fatigue: static safety, gaps, current density."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.studies.outputs import Evaluation, Floats, Output

if TYPE_CHECKING:
    from rolamento.electrical import BearingElectrics
    from rolamento.safety import StaticSafety
    from rolamento.solved import Solved

_OIL: Final = ("lubricant", "temperature.lubricant")


def limit_outputs() -> tuple[Output, ...]:
    """Return the outputs of static safety and of electricity."""
    return (
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
