"""What a study may put out: the catalogue of names, units and how each is computed.

Each module of outputs offers its own as a tuple; a new one is named in `catalogue`.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping
from functools import cache
from typing import TYPE_CHECKING, Any, Final, Literal, TypeVar

import numpy as np
from numpy.typing import NDArray

from rolamento.analysis.needs import has_life
from rolamento.errors import InputError, UnknownKeyError, guess
from rolamento.friction.machine import are_designated
from rolamento.records import frozen
from rolamento.words import marked, said, speaking

if TYPE_CHECKING:
    from rolamento.case import Case
    from rolamento.life.theory import Need
    from rolamento.solved import Solved


T = TypeVar("T")
Along = Literal["", "ball", "row", "bearing", "shaft"]
Kind = Literal["real", "whole"]
Floats = NDArray[np.float64]

OF: Final = " of "
"""Between an output of a machine and the bearing or shaft that it is of."""
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


class Evaluation:
    """A solved batch, and what each law says of it, found once for all outputs that ask."""

    def __init__(self, solved: Solved) -> None:
        self.solved = solved
        self._found: dict[tuple[object, ...], Any] = {}

    def of(self, law: Callable[..., T], **options: Hashable) -> T:
        """Return what a law says of the batch, such as ``of(friction, model="todd")``."""
        key = (law, *sorted(options.items()))
        if key not in self._found:
            self._found[key] = law(self.solved, **options)
        found: T = self._found[key]
        return found


@frozen
class Output:
    """One output.

    Attributes
    ----------
    name
        as a study asks for it
    unit
        SI, but of lives: ``"h"`` and ``"Mrev"``, millions of revolutions; ``"1"`` of a number
        without one
    called
        says what it is called, in the language that is spoken
    compute
        from an `Evaluation`, or that of machines: (cases,), or (cases, balls) or (cases, rows)
    along
        ``"ball"`` or ``"row"`` of an output that has a value for each of them; rollers count as
        balls. ``"bearing"`` or ``"shaft"`` of one that has a variable for each of a machine's
    kind
        ``"whole"`` of a whole number that every case has, solved or not
    needs
        fields or tables that the case must have, or that must vary
    slow
        whether a case takes some milliseconds
    """

    name: str
    unit: str
    called: Callable[[], str]
    compute: Callable[[Any], NDArray[Any]]
    along: Along = ""
    kind: Kind = "real"
    needs: tuple[str, ...] = ()
    slow: bool = False

    @property
    def label(self) -> str:
        """What it is called, in the language that is spoken."""
        return self.called()

    @property
    def long_name(self) -> str:
        """What it is called in files: its label in English."""
        with speaking("en"):
            return self.called()

    @property
    def dtype(self) -> np.dtype[Any]:
        """Type of its arrays."""
        return np.dtype(np.float64 if self.kind == "real" else np.int32)

    @property
    def absent(self) -> float:
        """What stands for the value of a case that was never solved."""
        return np.nan if self.kind == "real" else 0


@cache
def needs_of_life() -> Mapping[str, Need]:
    """Return what theories of life need of a case, by name."""
    from rolamento.life.theories import NEEDS

    return NEEDS


@cache
def catalogue() -> Mapping[str, Output]:
    """Return all outputs by name."""
    from rolamento.studies.bearing_outputs import ball_outputs, ring_outputs
    from rolamento.studies.friction_outputs import friction_outputs
    from rolamento.studies.heat_outputs import heat_outputs
    from rolamento.studies.life_outputs import life_outputs
    from rolamento.studies.limit_outputs import limit_outputs
    from rolamento.studies.lubrication_outputs import lubrication_outputs
    from rolamento.studies.roller_outputs import roller_outputs
    from rolamento.studies.row_outputs import row_outputs

    providers = (
        ring_outputs, row_outputs, ball_outputs, roller_outputs, lubrication_outputs,
        friction_outputs, heat_outputs, life_outputs, limit_outputs,
    )  # fmt: skip
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
            advice = guess(name, known, said("rolamento sweep --list outputs lists them all"))
            raise UnknownKeyError(
                said("is an unknown output; {advice}", advice=advice), field="outputs", value=name
            )
        found.append(known[name])
    return tuple(found)


_MISSING: Final[Mapping[str, tuple[str, str]]] = {
    "bearing.preload": (
        marked("a preload between opposed rows"),
        '[bearing] arrangement = "DB", spacing = "30 mm", preload = { force = "300 N" }',
    ),
    "lubricant": (marked("a lubricant"), 'lubricant = "ISO VG 68"'),
    "temperature.lubricant": (
        marked("the lubricant's temperature"),
        '[temperature] lubricant = "70 degC"',
    ),
    "surface": (
        marked("the roughness of the surfaces"),
        '[surface] with inner_roughness = "0.025 um" and the others in the case',
    ),
    "friction": (
        marked("a coefficient of friction of at most 1, or an oil or a grease at its temperature"),
        'lubricant = "ISO VG 68", [temperature] lubricant = "70 degC"',
    ),
    "friction control": (
        marked("friction control of the balls"),
        'model.raceway_control = "friction" in the case',
    ),
    "bearing.designation": (marked("a designation"), '[bearing] designation = "6310"'),
    "heat": (
        marked("a [heat] table"),
        '[heat] with housing_ambient = "5 W/K" in the case',
    ),
    "electrical.current": (
        marked("the current through the bearing"),
        '[electrical] with current = "0.5 A" in the case',
    ),
    "electrical.voltage": (
        marked("the voltage across the bearing"),
        '[electrical] with voltage = "10 V" in the case',
    ),
    "duty.oscillation": (
        marked("an oscillation"),
        '[duty.oscillation] with angle = "30 deg" and frequency = "2 Hz" in the case',
    ),
    "balls": (marked("balls"), "friction_torque_roller_sliding"),
    "rollers": (marked("rollers"), '[bearing] element = "cylindrical"'),
    "life": (
        marked("a designation or a [life] table"),
        '[life] with cleanliness = "-/17/14" and oil_supply = "circulating" in the case',
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
                of_life = needs_of_life().get(need)
                what, example = (
                    _MISSING[need] if of_life is None else (of_life.what, of_life.example)
                )
                raise InputError(
                    said("needs {what}, which the case lacks", what=said(what)),
                    field="outputs",
                    value=output.name,
                    example=example,
                )
            needed.add(need)
    if "life" in needed:
        from rolamento.studies.life_outputs import refuse_lifeless

        refuse_lifeless(case, given)


def supplied(output: Output, case: Case, varied: Iterable[str]) -> bool:
    """Return whether a case, or what varies, has all that an output rests on."""
    given = frozenset(varied)
    return all(_has(case, need, given) for need in output.needs)


def _has(case: Case, need: str, varied: frozenset[str]) -> bool:
    if need in varied or any(name.startswith(f"{need}.") for name in varied):
        return True
    if need == "bearing.designation":
        return are_designated(case.bearing)
    if need == "bearing.preload":
        return case.bearing.preload is not None
    if need == "life":
        return has_life(case) or "bearing.designation" in varied
    if need in needs_of_life():
        return needs_of_life()[need].met(case, varied)
    if need in ("balls", "rollers"):
        rolls = {place.bearing.element == "ball" for place in case.bearing.places}
        return (need == "balls") in rolls or "bearing.designation" in varied
    lubricant = case.lubricant
    if need == "lubricant":
        return lubricant is not None and lubricant.kind != "dry"
    if need == "friction":
        if "lubricant.friction_coefficient" in varied:
            return True
        mu = None if lubricant is None else lubricant.friction_coefficient
        if mu is not None:
            return mu <= 1.0
        return _has(case, "lubricant", varied) and _has(case, "temperature.lubricant", varied)
    if need == "temperature.lubricant":
        return case.lubricant_temperature is not None
    if need == "duty.oscillation":
        return case.duty.oscillation is not None
    if need == "heat":
        return case.heat is not None
    if need == "surface":
        return case.surface is not None
    if need.startswith("electrical."):
        name = need.partition(".")[2]
        return case.electrical is not None and getattr(case.electrical, name) is not None
    return case.model.raceway_control == "friction" or "model.raceway_control" in varied
