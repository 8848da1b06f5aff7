"""Friction as plain mappings and lists, as JSON has them."""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rolamento.analysis.needs import coefficient
from rolamento.state import State

if TYPE_CHECKING:
    from rolamento.friction import Friction


def friction_mapping(state: State, friction: Friction) -> dict[str, Any]:
    """Give the friction of a state as plain mappings and lists in SI units, NaN as None."""
    heat = {
        source: {"inner": loss.inner[0].tolist(), "outer": loss.outer[0].tolist()}
        for source, loss in friction.heat.items()
    }
    models = {
        found.model: {
            "torque": float(friction.models[found.model].total[0]),
            "parts": _numbers(friction.models[found.model].parts),
            "holds": bool(found.holds[0]),
            "reasons": [name for name, where in found.notes.items() if where[0]],
        }
        for found in friction.verdicts
    }
    mapping: dict[str, Any] = _without_nan(
        {
            "friction_coefficient": coefficient(state.case),
            "model": friction.model,
            "regime": str(friction.regime[0]),
            "torque": float(friction.torque[0]),
            "starting_torque": float(friction.starting_torque[0]),
            "power": float(friction.power[0]),
            "torque_by_source": _numbers(friction.torque_by_source),
            "heat": heat,
            "models": models,
        }
    )
    return mapping


def _numbers(arrays: Mapping[str, NDArray[np.float64]]) -> dict[str, float]:
    return {name: float(array[0]) for name, array in arrays.items()}


def _without_nan(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _without_nan(item) for key, item in value.items()}
    if isinstance(value, list):
        return [_without_nan(item) for item in value]
    return None if isinstance(value, float) and not isfinite(value) else value
