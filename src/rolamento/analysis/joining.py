"""What follows from solved cases, and parts of it put one after another."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from rolamento.friction import ContactLoss, Friction, ModelValidity, Torque
    from rolamento.life import LifeSummary
    from rolamento.lubrication import FilmTable


@dataclass(frozen=True, slots=True, eq=False)
class BatchAnalysis:
    """What follows from solved cases: film, friction, life, arrays over cases; None as above."""

    film: FilmTable | None
    friction: Friction | None
    life: LifeSummary | None = None


def joined(parts: list[BatchAnalysis]) -> BatchAnalysis:
    """Put what was found for some cases after what was found for others."""
    from rolamento.lubrication.table import _stacked

    if len(parts) == 1:
        return parts[0]
    films = [part.film for part in parts if part.film is not None]
    frictions = [part.friction for part in parts if part.friction is not None]
    return BatchAnalysis(
        _stacked(films) if films else None, _joined_friction(frictions) if frictions else None
    )


def _joined_friction(parts: list[Friction]) -> Friction:
    from rolamento.friction import Friction

    first = parts[0]
    return Friction(
        friction_coefficient=np.concatenate([part.friction_coefficient for part in parts]),
        model=first.model,
        torque=np.concatenate([part.torque for part in parts]),
        starting_torque=np.concatenate([part.starting_torque for part in parts]),
        power=np.concatenate([part.power for part in parts]),
        torque_by_source=_joined_arrays([part.torque_by_source for part in parts]),
        heat=_joined_losses([part.heat for part in parts]),
        regime=np.concatenate([part.regime for part in parts]),
        models={
            name: _joined_torque([part.models[name] for part in parts]) for name in first.models
        },
        validity=tuple(
            _joined_validity([part.validity[index] for part in parts])
            for index in range(len(first.validity))
        ),
    )


def _joined_arrays(parts: list[Mapping[str, Any]]) -> dict[str, Any]:
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


def _joined_losses(parts: list[Mapping[str, ContactLoss]]) -> dict[str, ContactLoss]:
    from rolamento.friction import ContactLoss

    return {
        name: ContactLoss(
            np.concatenate([part[name].inner for part in parts]),
            np.concatenate([part[name].outer for part in parts]),
        )
        for name in parts[0]
    }


def _joined_torque(parts: list[Torque]) -> Torque:
    from rolamento.friction import Torque

    first = parts[0]
    return Torque(
        first.model,
        np.concatenate([part.total for part in parts]),
        _joined_arrays([part.parts for part in parts]),
        np.concatenate([part.power for part in parts]),
        np.concatenate([part.converged for part in parts]),
        _joined_losses([part.losses for part in parts]),
    )


def _joined_validity(parts: list[ModelValidity]) -> ModelValidity:
    """A note that some blocks do not have is false in their cases."""
    from rolamento.friction import ModelValidity

    names = dict.fromkeys(name for part in parts for name in part.notes)
    notes = {
        name: np.concatenate(
            [part.notes.get(name, np.zeros(len(part.valid), np.bool_)) for part in parts]
        )
        for name in names
    }
    return ModelValidity(parts[0].model, np.concatenate([part.valid for part in parts]), notes)
