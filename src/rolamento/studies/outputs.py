"""What a study may put out: the catalogue of names, units and how each is computed.

Each module of outputs offers its own as a tuple; a new one is named in `catalogue`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from typing import TYPE_CHECKING, Any, Final, Literal

import numpy as np
from numpy.typing import NDArray

from rolamento.errors import UnknownKeyError, nearest

if TYPE_CHECKING:
    from rolamento.contact.hertz import HertzContact
    from rolamento.equilibrium import BatchState
    from rolamento.equilibrium.detail import BallTable, ContactTable
    from rolamento.geometry import Race

__all__ = ["DEFAULT_OUTPUTS", "Output", "Solved", "catalogue", "outputs_of"]

Floats = NDArray[np.float64]

DEFAULT_OUTPUTS: Final = (
    "x",
    "y",
    "z",
    "ry",
    "rz",
    "max_inner_load",
    "max_inner_max_pressure",
    "max_outer_max_pressure",
    "stiffness_xx",
    "stiffness_zz",
)


class Solved:
    """A solved batch, from which each output takes what it needs; shared parts are made once."""

    def __init__(self, batch: BatchState) -> None:
        self.batch = batch

    @cached_property
    def balls(self) -> BallTable:
        """Every ball of every case."""
        return self.batch.balls()

    @cached_property
    def _hertz(self) -> dict[Race, HertzContact]:
        return {}

    def hertz(self, race: Race) -> HertzContact:
        """Ellipse and pressure of every contact of a race."""
        if race not in self._hertz:
            self._hertz[race] = self.batch.contact(race, self.balls)
        return self._hertz[race]

    def contacts(self, race: Race) -> ContactTable:
        """Load, angle and deflection of every contact of a race."""
        return self.balls.inner if race == "inner" else self.balls.outer


@dataclass(frozen=True, slots=True)
class Output:
    """One output.

    Attributes
    ----------
    name
        as a study asks for it
    unit
        SI; ``"1"`` of a number without one
    long_name
        in words
    compute
        from a solved batch: (cases,), or (cases, balls) of an output per ball
    per_ball
        whether it has a value for each ball
    kind
        ``"whole"`` of a whole number that every case has, solved or not
    """

    name: str
    unit: str
    long_name: str
    compute: Callable[[Solved], NDArray[Any]]
    per_ball: bool = False
    kind: Literal["real", "whole"] = "real"

    @property
    def dtype(self) -> np.dtype[Any]:
        """Of its arrays."""
        return np.dtype(np.float64 if self.kind == "real" else np.int32)

    @property
    def absent(self) -> float:
        """What stands for the value of a case that was never solved."""
        return np.nan if self.kind == "real" else 0


@cache
def catalogue() -> Mapping[str, Output]:
    """Return all outputs by name."""
    from rolamento.studies.ball_outputs import ball_outputs
    from rolamento.studies.ring_outputs import ring_outputs

    providers = (ring_outputs, ball_outputs)
    return {output.name: output for provider in providers for output in provider()}


def outputs_of(names: Iterable[str]) -> tuple[Output, ...]:
    """Return the outputs of some names.

    Raises
    ------
    UnknownKeyError
        For a name that is not in the catalogue; the message gives the nearest one.
    """
    known = catalogue()
    found = []
    for name in names:
        if name not in known:
            near = nearest(name, known)
            advice = f"did you mean {near}?" if near else "rolamento sweep --list outputs shows all"
            raise UnknownKeyError(f"is not a known output; {advice}", field="outputs", value=name)
        found.append(known[name])
    return tuple(found)
