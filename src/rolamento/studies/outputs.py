"""What a study may put out: the catalogue of names, units and how each is computed.

Each module of outputs offers its own as a tuple; a new one is named in `catalogue`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, fields
from functools import cache, cached_property
from typing import TYPE_CHECKING, Any, Final, Literal

import numpy as np
from numpy.typing import NDArray

from rolamento.analysis.needs import has_life
from rolamento.case.life_model import DIRT
from rolamento.errors import InputError, UnknownKeyError, nearest

if TYPE_CHECKING:
    from rolamento import solved
    from rolamento.case import Case
    from rolamento.contact.hertz import HertzContact
    from rolamento.friction import Friction
    from rolamento.geometry import Race
    from rolamento.life import LifeSummary
    from rolamento.lubrication import Film
    from rolamento.rows.ball import BatchState
    from rolamento.rows.ball.detail import BallTable, ContactTable

__all__ = ["DEFAULT_OUTPUTS", "Output", "Solved", "catalogue", "outputs_of", "refuse_missing"]

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
    """A solved batch, from which each output takes what it needs; shared parts are made once.

    Parameters
    ----------
    batch
        From `solve_batch`.
    case
        The one that was solved; film, friction and life take lubricant, temperature, surface and
        ratings of it.
    values
        What varied, by the dotted names of the fields; SI.
    """

    def __init__(
        self,
        batch: BatchState,
        case: Case | None = None,
        values: Mapping[str, NDArray[Any]] | None = None,
    ) -> None:
        self.batch, self._case, self._values = batch, case, values or {}

    @property
    def case(self) -> Case:
        """What was solved."""
        assert self._case is not None
        return self._case

    @cached_property
    def cases(self) -> solved.Solved:
        """The cases as film and friction read them."""
        from rolamento.solving import solve

        return solve(self.case, self._values, threads=1)

    @cached_property
    def shared(self) -> BatchState:
        """The batch, whose balls and ellipses are made once for all that follows from it."""
        from rolamento.rows.ball.remembering import RememberingBatch

        return RememberingBatch(*(getattr(self.batch, part.name) for part in fields(self.batch)))

    @cached_property
    def film(self) -> Film:
        """The film of every contact."""
        from rolamento.lubrication import film

        return film(self.cases, threads=1)

    @cached_property
    def friction_coefficient(self) -> Floats:
        """μ of every case."""
        given = self._values.get("lubricant.friction_coefficient")
        own = None if self.case.lubricant is None else self.case.lubricant.friction_coefficient
        mu = own if given is None else self._sound(given)
        return np.full(len(self.batch), mu, np.float64)

    @property
    def has_friction(self) -> NDArray[np.bool_]:
        """Whether a case has a coefficient that the friction models take."""
        return np.asarray(self.friction_coefficient <= 1.0)

    @cached_property
    def _frictions(self) -> dict[str, Friction]:
        return {}

    def friction(self, model: str) -> Friction:
        """Torque, power and heat with a model of the contacts.

        Where there is no coefficient that the models take, it is taken as zero: `has_friction`.
        """
        from rolamento.friction import friction

        if model not in self._frictions:
            self._frictions[model] = friction(
                self.cases,
                friction_coefficient=np.where(self.has_friction, self.friction_coefficient, 0.0),
                model=model,
                film_parameter=np.nan,
                compare=False,
                threads=1,
            )
        return self._frictions[model]

    @cached_property
    def _lives(self) -> dict[bool, LifeSummary | None]:
        return {}

    def life(self, *, stress_volume: bool = False) -> LifeSummary | None:
        """Life by every theory that the case allows; None if it allows none.

        stress_volume: with that of Ioannides and Harris, which takes long.
        """
        if stress_volume not in self._lives:
            self._lives[stress_volume] = self._life(stress_volume)
        return self._lives[stress_volume]

    def _life(self, stress_volume: bool) -> LifeSummary | None:
        from rolamento.life import conditions_of, life_of_batch

        names = [name for name in self._values if name.startswith(("life.", "temperature."))]
        values = {name: self._sound(self._values[name]) for name in names}
        try:
            conditions = conditions_of(self.case, values)
            return life_of_batch(self.case, self.shared, conditions, stress_volume=stress_volume)
        except InputError:  # a thrust bearing or one without a rating, one of many in a study
            return None

    def _sound(self, values: NDArray[Any]) -> Floats:
        """Replace what made a case invalid: its results are NaN whatever stands there."""
        invalid = self.batch.status == "invalid_input"
        return np.where(invalid, 1.0, np.asarray(values, dtype=np.float64))

    @cached_property
    def balls(self) -> BallTable:
        """Every ball of every case."""
        return self.shared.balls()

    @cached_property
    def _hertz(self) -> dict[Race, HertzContact]:
        return {}

    def hertz(self, race: Race) -> HertzContact:
        """Ellipse and pressure of every contact of a race."""
        if race not in self._hertz:
            self._hertz[race] = self.shared.contact(race, self.balls)
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
        SI, but of lives: ``"h"`` and ``"Mrev"``, millions of revolutions; ``"1"`` of a number
        without one
    long_name
        in words
    compute
        from a solved batch: (cases,), or (cases, balls) of an output per ball
    per_ball
        whether it has a value for each ball
    kind
        ``"whole"`` of a whole number that every case has, solved or not
    needs
        fields or tables that the case must have, or that must vary
    slow
        whether a case takes some milliseconds
    """

    name: str
    unit: str
    long_name: str
    compute: Callable[[Solved], NDArray[Any]]
    per_ball: bool = False
    kind: Literal["real", "whole"] = "real"
    needs: tuple[str, ...] = ()
    slow: bool = False

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
    from rolamento.studies.friction_outputs import friction_outputs
    from rolamento.studies.life_outputs import life_outputs
    from rolamento.studies.lubrication_outputs import lubrication_outputs
    from rolamento.studies.ring_outputs import ring_outputs

    providers = (ring_outputs, ball_outputs, lubrication_outputs, friction_outputs, life_outputs)
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


_MISSING: Final[Mapping[str, tuple[str, str]]] = {
    "lubricant": ("a lubricant", 'lubricant = "ISO VG 68" in the case'),
    "temperature.lubricant": (
        "the lubricant's temperature",
        '[temperature] with lubricant = "70 degC" in the case',
    ),
    "surface": (
        "the roughness of the surfaces",
        '[surface] with inner_roughness = "0.025 um" and the others in the case',
    ),
    "lubricant.friction_coefficient": (
        "a coefficient of friction of at most 1",
        "[lubricant] with friction_coefficient = 0.1 in the case",
    ),
    "friction control": (
        "balls that friction controls",
        'model.raceway_control = "friction" in the case',
    ),
    "life": (
        "a designation or a [life] table",
        '[life] with cleanliness = "-/17/14" and oil_supply = "circulating" in the case',
    ),
    "viscosity ratio": (
        "a viscosity ratio, or a lubricant and its temperature,",
        "[life] with viscosity_ratio = 1.5 in the case",
    ),
    "cleanliness": (
        "the cleanliness of the lubricant",
        '[life] with cleanliness = "-/17/14" and oil_supply = "circulating" in the case',
    ),
    "adjustment": (
        "a material factor or an operation factor",
        "[life] with operation_factor = 0.8 in the case",
    ),
    "life.nsk_cleanliness": (
        "the maker's cleanliness factor",
        "[life] with nsk_cleanliness = 0.8 in the case",
    ),
    "life.wanted_life": (
        "the life that is wanted",
        '[life] with wanted_life = "20000 h" in the case',
    ),
}


def refuse_missing(outputs: Iterable[Output], case: Case, varied: Iterable[str]) -> None:
    """Refuse outputs that rest on what neither the case has nor what varies supplies.

    Raises
    ------
    InputError
        Naming the output and what it needs, or why the case has no life.
    """
    given, needed = frozenset(varied), set()
    for output in outputs:
        for need in output.needs:
            if not _has(case, need, given):
                what, example = _MISSING[need]
                raise InputError(
                    f"needs {what}, which the case does not have",
                    field="outputs",
                    value=output.name,
                    example=example,
                )
            needed.add(need)
    if "life" in needed:
        from rolamento.studies.life_outputs import refuse_lifeless

        refuse_lifeless(case, given)


def _has(case: Case, need: str, varied: frozenset[str]) -> bool:
    if need in varied or any(name.startswith(f"{need}.") for name in varied):
        return True
    if need in _LIFE_NEEDS:
        return _LIFE_NEEDS[need](case, varied)
    lubricant = case.lubricant
    if need == "lubricant":
        return lubricant is not None and lubricant.kind != "dry"
    if need == "lubricant.friction_coefficient":
        mu = None if lubricant is None else lubricant.friction_coefficient
        return mu is not None and mu <= 1.0
    if need == "temperature.lubricant":
        return case.lubricant_temperature is not None
    if need == "surface":
        return case.surface is not None
    return case.model.raceway_control == "friction" or "model.raceway_control" in varied


def _has_of_life(case: Case, names: Iterable[str], varied: frozenset[str]) -> bool:
    """Whether the [life] table has one of some fields, or one varies."""
    return any(
        f"life.{name}" in varied or getattr(case.life, name, None) is not None for name in names
    )


def _has_viscosity_ratio(case: Case, varied: frozenset[str]) -> bool:
    given = _has_of_life(case, ("viscosity_ratio",), varied)
    return given or all(_has(case, need, varied) for need in ("lubricant", "temperature.lubricant"))


_LIFE_NEEDS: Final[Mapping[str, Callable[[Case, frozenset[str]], bool]]] = {
    "life": lambda case, varied: has_life(case) or "bearing.designation" in varied,
    "viscosity ratio": _has_viscosity_ratio,
    "cleanliness": lambda case, varied: _has_of_life(case, DIRT, varied),
    "adjustment": lambda case, varied: _has_of_life(
        case, ("material_factor", "operation_factor"), varied
    ),
    "life.nsk_cleanliness": lambda case, varied: _has_of_life(case, ("nsk_cleanliness",), varied),
    "life.wanted_life": lambda case, varied: _has_of_life(case, ("wanted_life",), varied),
}
