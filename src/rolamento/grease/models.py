"""All laws of a grease's life, in the order of tables; a new one is named here."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from rolamento.grease import jtekt, kawamura, nsk
from rolamento.grease.estimate import GreaseModel

__all__ = ["MODELS"]

MODELS: Final[Mapping[str, GreaseModel]] = {
    module.MODEL.name: module.MODEL for module in (nsk, kawamura, jtekt)
}
"""By name."""
