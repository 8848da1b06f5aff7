"""The geometry of a row in many cases: the fields of its record, numbers or arrays (cases,).

What the records hold to is said once, as rules that take a record or its parameters: a record that
violates one is refused with its message, of many cases those that do are not solved.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Self

import numpy as np

from rolamento.geometry import apex_half_angle, usual_end_radius
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.types import BearingType

if TYPE_CHECKING:
    from rolamento.case.rolling_bearing import RollingBearing
    from rolamento.errors import InputError

__all__ = ["BallParameters", "Elastic", "Parameters", "RollerParameters", "Rule", "parameters_of"]


@frozen
class Rule:
    """What holds of every bearing: holds takes a record or parameters, refusal the record."""

    holds: Callable[[Any], Any]
    refusal: Callable[[Any], InputError]


@frozen(eq=False)
class Elastic:
    """A material in many cases: its name, and numbers or arrays (cases,) in SI."""

    name: Any
    youngs_modulus: Any
    poisson_ratio: Any
    density: Any

    @classmethod
    def of(cls, material: Any, part: str, arrays: Mapping[str, FloatArray]) -> Self:
        """Take them from a material, and from the arrays that vary one of that part."""
        names = ("name", "youngs_modulus", "poisson_ratio", "density")
        return cls(
            *(arrays.get(f"bearing.{part}.{name}", getattr(material, name)) for name in names)
        )


@frozen(eq=False, kw_only=True)
class Parameters:
    """What rows of balls and of rollers have in common; SI, numbers or arrays (cases,).

    None is what such a row has not: one of `contact_angle` and `diametral_clearance`, among others.
    """

    rules: tuple[Rule, ...]
    bearing_type: BearingType
    element_count: int
    pitch_diameter: Any
    contact_angle: Any
    diametral_clearance: Any
    ring_material: Any
    element_material: Any

    @property
    def element_diameter(self) -> Any:
        """D; m."""
        raise NotImplementedError

    @property
    def consistent(self) -> BoolArray:
        """In which cases the fields do not contradict each other."""
        sound: Any = True
        with np.errstate(invalid="ignore"):
            for rule in self.rules:
                sound = sound & rule.holds(self)
        return np.asarray(sound)

    def with_(self, **changes: Any) -> Self:
        """The same with other fields."""
        return replace(self, **changes)

    def following(self, varied: Container[str], known: Container[str]) -> Self:
        """Let what follows from other fields follow from what varies; known: what is given."""
        return self


@frozen(eq=False, kw_only=True)
class BallParameters(Parameters):
    """The geometry of rows of balls, as a `Bearing` has it."""

    ball_diameter: Any
    inner_conformity: Any
    outer_conformity: Any
    shim_angle: Any = None
    inner_shoulder_height: Any = None
    outer_shoulder_height: Any = None

    @property
    def element_diameter(self) -> Any:
        """D; m."""
        return self.ball_diameter

    @property
    def ball_material(self) -> Any:
        """Material of the balls."""
        return self.element_material


@frozen(eq=False, kw_only=True)
class RollerParameters(Parameters):
    """The geometry of rows of rollers, as a `RollerBearing` has it."""

    roller_diameter: Any
    effective_length: Any
    roller_length: Any
    roller_half_angle: Any = None
    roller_profile_radius: Any = None
    inner_raceway_radius: Any = None
    outer_raceway_radius: Any = None
    axial_play: Any = None
    rib_height: Any = None
    roller_end_radius: Any = None
    inner_ribs: Any = "none"
    outer_ribs: Any = "none"
    roller_profile: Any = None
    inner_profile: Any = None
    outer_profile: Any = None

    @property
    def element_diameter(self) -> Any:
        """D_we; m."""
        return self.roller_diameter

    @property
    def roller_material(self) -> Any:
        """Material of the rollers."""
        return self.element_material

    def following(self, varied: Container[str], known: Container[str]) -> Self:
        """Cones keep one apex, rollers their ends."""
        made: dict[str, Any] = {}
        if self.bearing_type.conical and "roller_half_angle" not in known:
            sizes = (self.roller_diameter, self.pitch_diameter, self.contact_angle)
            made["roller_half_angle"] = apex_half_angle(*sizes, washers=self.bearing_type.washers)
        if "effective_length" in varied and "roller_length" not in known:
            made["roller_length"] = self.effective_length
        shape = self.with_(**made)
        if self.roller_end_radius is None or "roller_end_radius" in known:
            return shape
        ends = (shape.roller_diameter, shape.roller_length, shape.roller_half_angle)
        return shape.with_(roller_end_radius=usual_end_radius(*ends))


def parameters_of(
    bearing: RollingBearing,
    row: RollingBearing,
    own: frozenset[str],
    arrays: Mapping[str, FloatArray],
) -> Any:
    """Return the parameters of a row of a bearing, with the arrays for their fields.

    Parameters
    ----------
    bearing
        That the row is of, which may be itself.
    row
        As a bearing of one row.
    own
        Fields that the row has of its own: what varies of the bearing's leaves them.
    arrays
        What varies, by the dotted names of fields.
    """
    given = {
        name: arrays[f"bearing.{name}"]
        for name in row.VARIES
        if f"bearing.{name}" in arrays and name not in own
    }
    play = [name for name in row.RIVALS if name in given]
    ended = {name: None for name in row.RIVALS if play and name not in play}
    rings = Elastic.of(row.ring_material, "ring_material", arrays)
    rolling = rings if row.elements_follow_rings else row.element_material
    made = {name: getattr(row, name) for name in (*row.VARIES, *row.STAYS)} | given | ended
    whole: Parameters = row.PARAMETERS(
        rules=row.RULES,
        bearing_type=row.bearing_type,
        element_count=row.element_count,
        ring_material=rings,
        element_material=Elastic.of(rolling, row.MATERIAL, {} if row.MATERIAL in own else arrays),
        **made,
    )
    return whole.following(given, own | given.keys() | bearing.model_fields_set)
