"""All theories of life, in the order of tables; a new one is named here."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from rolamento.life import (
    ioannides_harris,
    iso281,
    iso281_1990,
    iso281_modified,
    iso16281,
    iso16281_modified,
    l_able,
    tallian,
)
from rolamento.life.theory import REQUIRED_LIFE, Need, Theory

THEORIES: Final[Mapping[str, Theory]] = {
    module.THEORY.name: module.THEORY
    for module in (
        iso281,
        iso281_modified,
        iso281_1990,
        iso16281,
        iso16281_modified,
        ioannides_harris,
        l_able,
        tallian,
    )
}
"""By name."""

BY_RANK: Final = tuple(sorted(THEORIES, key=lambda name: THEORIES[name].rank))
"""Names by weight: figures list theories so."""

NEEDS: Final[Mapping[str, Need]] = {
    need.name: need
    for need in (*(one for theory in THEORIES.values() for one in theory.needs), REQUIRED_LIFE)
}
"""What theories need of a case, by name."""
