"""Modified reference rating life: a_1 a_ISO L_10r, with the load of the reference life in a_ISO.

Source: ISO/TS 16281:2008, 4.6; ISO 281:2007, 9.3.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rolamento.life.iso281_modified import modification
from rolamento.life.theory import (
    CLEANLINESS,
    OF_BEARING,
    OF_LOAD,
    OF_LUBRICATION,
    VISCOSITY_RATIO,
    Theory,
)

if TYPE_CHECKING:
    from rolamento.life.basis import Basis
    from rolamento.life.record import Life


def _evaluate(basis: Basis) -> Life:
    load = basis.reference_load
    factors, notes = modification(basis)
    return basis.record(
        THEORY.name,
        basis.reference.life,
        {**factors, "equivalent_load": load},
        {**basis.notes_on_reference_load(), **notes},
    )


THEORY: Final = Theory(
    name="iso16281_modified",
    evaluate=_evaluate,
    asked=lambda basis: basis.contamination_factor is not None,
    needs=(VISCOSITY_RATIO, CLEANLINESS),
    validity=(*OF_BEARING, *OF_LOAD, *OF_LUBRICATION),
    rank=0,
    standard=True,
    by_race=True,
)
