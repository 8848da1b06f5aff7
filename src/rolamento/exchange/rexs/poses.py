"""Where components are: each relative to another one, as REXS has it."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Final, NamedTuple

from rolamento.errors import FileError
from rolamento.exchange.rexs.model import Component, RexsModel
from rolamento.exchange.rexs.values import numbers_of, placed
from rolamento.words import said

__all__ = ["HOME", "Pose", "Vector", "crossing", "dot", "poses_of"]

Vector = tuple[float, float, float]
_PERPENDICULAR: Final = 1e-4
"""By how much two axes may lean, written with few digits."""
_LEAST: Final = 1e-9


class Pose(NamedTuple):
    """A place in space and its axes u, v and w, in the coordinates of the gear unit; m."""

    origin: Vector
    u: Vector
    v: Vector
    w: Vector

    def point(self, local: Vector) -> Vector:
        """Return a point that is given in its coordinates, in those of the gear unit."""
        turned = self.direction(local)
        return (
            self.origin[0] + turned[0], self.origin[1] + turned[1], self.origin[2] + turned[2],
        )  # fmt: skip

    def direction(self, local: Vector) -> Vector:
        """Return a vector that is given along its axes, along those of the gear unit."""
        x, y, z = (
            local[0] * self.u[axis] + local[1] * self.v[axis] + local[2] * self.w[axis]
            for axis in range(3)
        )
        return x, y, z

    def local(self, vector: Vector) -> Vector:
        """Return a vector along the axes of the gear unit, along its own."""
        return dot(vector, self.u), dot(vector, self.v), dot(vector, self.w)

    def seen_from(self, point: Vector) -> Vector:
        """Return a point of the gear unit in its own coordinates."""
        x, y, z = (one - other for one, other in zip(point, self.origin, strict=True))
        return self.local((x, y, z))


HOME: Final = Pose((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
"""That of the gear unit."""


def dot(one: Vector, other: Vector) -> float:
    """Return the scalar product."""
    return one[0] * other[0] + one[1] * other[1] + one[2] * other[2]


def _cross(one: Vector, other: Vector) -> Vector:
    return (
        one[1] * other[2] - one[2] * other[1],
        one[2] * other[0] - one[0] * other[2],
        one[0] * other[1] - one[1] * other[0],
    )


def crossing(one: Pose, other: Pose) -> tuple[float, float, float] | None:
    """Return where the u axes of two poses are nearest, along each of them, and how near; m.

    None of parallel ones.
    """
    across = _cross(one.u, other.u)
    size = dot(across, across)
    if size < _PERPENDICULAR:
        return None
    x, y, z = (b - a for a, b in zip(one.origin, other.origin, strict=True))
    between = (x, y, z)
    here = dot(_cross(between, other.u), across) / size
    there = dot(_cross(between, one.u), across) / size
    return here, there, abs(dot(between, across)) / math.sqrt(size)


def poses_of(
    model: RexsModel, use: Callable[[Component, str], None] = lambda component, name: None
) -> dict[int, Pose]:
    """Return the poses of all components that have one, by their ids.

    Parameters
    ----------
    model
        Whose components refer to each other.
    use
        Called with each component and attribute that counts.

    Raises
    ------
    FileError
        If components refer to each other in a circle, or axes are none.
    """
    found: dict[int, Pose] = {}
    for component in model.components:
        chain: list[Component] = []
        met: set[int] = set()
        one: Component | None = component
        while one is not None and one.id not in found:
            if one.id in met:
                raise FileError(
                    said("closes a circle: no component in it has a place of its own"),
                    field=f"{one.type} {one.id}.reference_component_for_position",
                    value=_reference(one),
                )
            chain.append(one)
            met.add(one.id)
            reference = _reference(one)
            # the gear unit refers to itself
            one = None if reference in (None, one.id) else model.by_id.get(reference or 0)
        for part in reversed(chain):
            own = _own_pose(part, use)
            if own is None:
                continue
            reference = _reference(part)
            base = HOME if reference in (None, part.id) else found.get(reference or 0)
            if base is not None:
                found[part.id] = _within(base, own)
            elif (other := model.by_id.get(reference or 0)) is not None and not other.attributes:
                found[part.id] = own  # such as a casing without a place: that of the gear unit
    return found


def _reference(component: Component) -> int | None:
    attribute = component.attributes.get("reference_component_for_position")
    if attribute is None:
        return None
    text = attribute.text
    return int(text) if text.isascii() and text.isdigit() and len(text) < 11 else None


def _own_pose(component: Component, use: Callable[[Component, str], None]) -> Pose | None:
    support = component.attributes.get("support_vector")
    if support is None:
        return None
    origin = _vector(component, "support_vector")
    u = _axis(component, "u_axis_vector", HOME.u)
    w = _axis(component, "w_axis_vector", HOME.w)
    for name in ("support_vector", "u_axis_vector", "w_axis_vector",
                 "reference_component_for_position"):  # fmt: skip
        use(component, name)
    if abs(dot(u, w)) > _PERPENDICULAR:
        raise placed(FileError(said("is not across the u axis")), component, "w_axis_vector")
    lean = dot(u, w)
    w = _of_length_one((w[0] - lean * u[0], w[1] - lean * u[1], w[2] - lean * u[2]))
    return Pose(origin, u, _cross(w, u), w)


def _vector(component: Component, name: str) -> Vector:
    numbers = numbers_of(component, component.attributes[name], name)
    if len(numbers) != 3:
        rule = said("must have 3 numbers, and has {count}", count=len(numbers))
        raise placed(FileError(rule), component, name)
    return numbers[0], numbers[1], numbers[2]


def _axis(component: Component, name: str, usual: Vector) -> Vector:
    if name not in component.attributes:
        return usual
    vector = _vector(component, name)
    length = math.hypot(*vector)
    if not length > _LEAST * 1e-3:
        raise placed(FileError(said("has no direction")), component, name)
    return _of_length_one(vector)


def _of_length_one(vector: Vector) -> Vector:
    length = math.hypot(*vector)
    return vector[0] / length, vector[1] / length, vector[2] / length


def _within(base: Pose, own: Pose) -> Pose:
    return Pose(
        base.point(own.origin), base.direction(own.u), base.direction(own.v), base.direction(own.w)
    )
