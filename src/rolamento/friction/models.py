"""The torque models there are: to add one, write its file and name it here."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from rolamento.friction import (
    harris_1971,
    jones_control,
    jones_full,
    jones_simplified,
    palmgren,
    rollers,
    skf,
    todd,
)
from rolamento.friction.model import TorqueModel
from rolamento.words import said

TORQUE_MODELS: Final[Mapping[str, TorqueModel]] = {
    module.MODEL.name: module.MODEL
    for module in (
        jones_full, jones_control, jones_simplified, harris_1971, todd, rollers, palmgren, skf
    )
}  # fmt: skip
"""By name, in the order in which they are shown."""

CONTACT_MODELS: Final = tuple(
    name for name, model in TORQUE_MODELS.items() if model.of_contacts and "ball" in model.elements
)
"""Names of the models of the friction in the contacts of balls."""

ROLLER_MODEL: Final = rollers.MODEL.name
"""Name of the model of the friction in the contacts of rollers."""


def torque_model_name(model: str, *, short: bool = False) -> str:
    """Say what a torque model, or friction control, is called; short: over a narrow column."""
    if model == "friction_control":
        return said("fr. control") if short else said("friction control")
    known = TORQUE_MODELS.get(model)
    if known is None:
        return model
    return said(known.short_title if short else known.title)
