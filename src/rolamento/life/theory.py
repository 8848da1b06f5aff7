"""What a theory of life is: a name, what it needs, where it is valid, and how it is evaluated.

Each theory stands in a file of its own, and in the list of `theories`; its words are in
`rolamento.words.theories`. Nothing else names them one by one.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import TYPE_CHECKING, Final

from rolamento.case.life_model import CONTAMINATION_FIELDS
from rolamento.records import frozen
from rolamento.words import marked

if TYPE_CHECKING:
    from rolamento.case import Case
    from rolamento.life.basis import Basis
    from rolamento.life.record import Life
    from rolamento.life.reliability import Edition

OF_BEARING: Final = ("unloaded", "thrust_bearing", "no_dynamic_rating", "too_hot_for_steel")
"""Notes that refuse any theory that starts from the rating."""
OF_LOAD: Final = ("load_above_half_rating", "load_above_static_rating")
OF_EQUIVALENT_LOAD: Final = ("no_force", "moment_governs", "no_equivalent_load", *OF_LOAD)
OF_LUBRICATION: Final = (
    "viscosity_ratio_too_small",
    "contamination_severe",
    "no_fatigue_load_limit",
)


@frozen
class Need:
    """What a theory takes from the case, beside its loads.

    Attributes
    ----------
    name
        as a study's output asks for it
    what, example
        for the message where it is missing
    fields
        of the [life] table: any of them supplies it
    from_lubricant
        whether the case's lubricant, with its temperature, does as well
    """

    name: str
    what: str
    example: str
    fields: tuple[str, ...]
    from_lubricant: bool = False

    def met(self, case: Case, varied: Collection[str] = ()) -> bool:
        """Return whether a case has it; varied: dotted names of what varies."""
        if any(
            f"life.{name}" in varied or getattr(case.life, name, None) is not None
            for name in self.fields
        ):
            return True
        if not self.from_lubricant:
            return False
        oil = case.lubricant is not None and case.lubricant.kind != "dry"
        warm = case.lubricant_temperature is not None or "temperature.lubricant" in varied
        return (oil or _any_below("lubricant", varied)) and warm


def _any_below(table: str, names: Collection[str]) -> bool:
    return any(name == table or name.startswith(f"{table}.") for name in names)


VISCOSITY_RATIO: Final = Need(
    "viscosity ratio",
    marked("a viscosity ratio, or a lubricant and its temperature,"),
    "[life] with viscosity_ratio = 1.5 in the case",
    ("viscosity_ratio",),
    from_lubricant=True,
)
CLEANLINESS: Final = Need(
    "cleanliness",
    marked("the cleanliness of the lubricant"),
    '[life] with cleanliness = "-/17/14" and oil_supply = "circulating" in the case',
    CONTAMINATION_FIELDS,
)
REQUIRED_LIFE: Final = Need(
    "life.required_life",
    marked("the required life"),
    '[life] with required_life = "20000 h" in the case',
    ("required_life",),
)
"""No theory needs it, but the reliability with which it is reached."""


@frozen(kw_only=True)
class Theory:
    """A theory of life.

    Attributes
    ----------
    name
        in JSON, in names of outputs and columns
    evaluate
        from what the theories share to a `Life`
    asked
        whether the conditions ask for it
    needs
        what the case has to supply for it
    validity
        keys of the notes that refuse it: outside of these it is valid
    rank
        by weight, from 0: figures list and colour theories by it
    standard
        whether it is of the standard in force, and shown even where there is room for few
    by_race
        whether its life is that of the single races, times factors
    of_balls
        whether it is for point contact, and rows of rollers are refused
    bound
        whether its life is an upper bound, even far within its validity
    slow
        whether a case takes milliseconds
    refuses
        whether it raises InputError where the conditions lack something
    edition
        of ISO 281 for its a_1, where it has one of its own
    """

    name: str
    evaluate: Callable[[Basis], Life]
    validity: tuple[str, ...]
    rank: int
    asked: Callable[[Basis], bool] = lambda basis: True
    needs: tuple[Need, ...] = ()
    standard: bool = False
    by_race: bool = False
    of_balls: bool = False
    bound: bool = False
    slow: bool = False
    refuses: bool = False
    edition: Edition | None = None
