"""What a REXS file holds, whichever container it came in: components, relations, load cases.

Numbers stay the texts that they were, so that nothing is rounded on the way.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping
from dataclasses import field
from functools import cached_property

from rolamento.records import frozen

__all__ = ["Attribute", "Component", "LoadCase", "Ref", "Relation", "RexsModel", "Value"]

Value = str | tuple[str, ...] | tuple[tuple[str, ...], ...]
"""A scalar, an array, or a matrix."""


@frozen
class Attribute:
    """A named value of a component.

    Attributes
    ----------
    id
        such as ``"outer_diameter_begin"``
    value
        as text
    unit
        as REXS writes it: ``"mm"``, ``"1 / min"``; empty without one
    form
        what JSON calls its type, such as ``"floating_point_array"``; empty of XML, which has none
    """

    id: str
    value: Value
    unit: str = ""
    form: str = ""

    @property
    def text(self) -> str:
        """A scalar as text; empty of arrays."""
        return self.value.strip() if isinstance(self.value, str) else ""


@frozen
class Component:
    """A part of a gear unit.

    Attributes
    ----------
    id
        unique in the model
    type
        such as ``"shaft"``
    name
        as its author called it
    attributes
        by their ids
    """

    id: int
    type: str
    name: str = ""
    attributes: Mapping[str, Attribute] = field(default_factory=dict, hash=False)


@frozen
class Ref:
    """A component in a relation, and its role there."""

    id: int
    role: str


@frozen
class Relation:
    """Components that belong together.

    Attributes
    ----------
    id
        unique in the model
    type
        such as ``"assembly"``
    refs
        its components
    order
        of a part among others; None without one
    """

    id: int
    type: str
    refs: tuple[Ref, ...]
    order: int | None = None

    def in_role(self, role: str) -> int | None:
        """Return the component that has a role; None without one."""
        return next((ref.id for ref in self.refs if ref.role == role), None)


@frozen
class LoadCase:
    """What a load case has that others have otherwise: components with some of their attributes."""

    id: int
    components: tuple[Component, ...]


@frozen(slots=False)
class RexsModel:
    """A gear unit.

    Attributes
    ----------
    version
        of REXS, such as ``"2.0"``
    application, application_version, date
        who wrote it, and when
    components, relations
        in the order of the file
    load_cases
        of its load spectrum
    accumulation
        what follows from all load cases together
    """

    version: str
    application: str = ""
    application_version: str = ""
    date: str = ""
    components: tuple[Component, ...] = ()
    relations: tuple[Relation, ...] = ()
    load_cases: tuple[LoadCase, ...] = ()
    accumulation: tuple[Component, ...] = ()

    @property
    def zero_is_unknown(self) -> bool:
        """Whether its writers gave zero to what they did not know: files of REXS 1."""
        return not self.version.strip().startswith("2")

    @cached_property
    def by_id(self) -> Mapping[int, Component]:
        """Components by their ids."""
        return {one.id: one for one in self.components}

    def of_type(self, *types: str) -> Iterator[Component]:
        """Give the components of some types, in the order of the file."""
        return (one for one in self.components if one.type in types)

    def parts(self, assembly: int, *types: str) -> tuple[Component, ...]:
        """Return what belongs to a component: ordered parts in their order, then as in the file."""
        found = [
            (relation.order if relation.order is not None else 0, part)
            for relation in self._by_role.get(("assembly", assembly), ())
            if relation.type in ("assembly", "ordered_assembly")
            and (part := self.by_id.get(relation.in_role("part") or -1)) is not None
            and part.type in types
        ]
        return tuple(part for _, part in sorted(found, key=lambda pair: pair[0]))

    def whole_of(self, part: int, *types: str) -> Component | None:
        """Return the component of some type that a part belongs to; None without one."""
        for relation in self._by_role.get(("part", part), ()):
            whole = self.by_id.get(relation.in_role("assembly") or -1)
            if whole is not None and whole.type in types:
                return whole
        return None

    def related(self, kind: str, component: int, role: str, other: str) -> tuple[Component, ...]:
        """Return what stands in another role in the relations where a component has a role."""
        return tuple(
            found
            for relation in self._by_role.get((role, component), ())
            if relation.type == kind
            and (found := self.by_id.get(relation.in_role(other) or -1)) is not None
        )

    def relations_of(self, component: int, role: str, kind: str) -> tuple[Relation, ...]:
        """Return the relations of a kind in which a component has a role."""
        return tuple(one for one in self._by_role.get((role, component), ()) if one.type == kind)

    @cached_property
    def _by_role(self) -> Mapping[tuple[str, int], list[Relation]]:
        found: dict[tuple[str, int], list[Relation]] = {}
        for relation in self.relations:
            for ref in relation.refs:
                found.setdefault((ref.role, ref.id), []).append(relation)
        return found

    def digest(self, besides: str) -> str:
        """Return a text that is another one where anything was changed.

        besides: how attributes begin that do not count.
        """
        parts: list[object] = [
            [(one.id, one.type, one.name, _plain(one, besides)) for one in self.components],
            [
                (one.id, one.type, [(ref.id, ref.role) for ref in one.refs], one.order)
                for one in self.relations
            ],
            [
                (case.id, [(one.id, _plain(one, besides)) for one in case.components])
                for case in self.load_cases
            ],
        ]
        return hashlib.sha256(repr(parts).encode("utf-8", "replace")).hexdigest()[:32]

    def in_load_case(self, load_case: LoadCase) -> RexsModel:
        """Return the model with what a load case gives over it."""
        own = {one.id: one for one in load_case.components}
        merged = tuple(
            Component(one.id, one.type, one.name, {**one.attributes, **own[one.id].attributes})
            if one.id in own
            else one
            for one in self.components
        )
        return RexsModel(
            self.version, self.application, self.application_version, self.date, merged,
            self.relations,
        )  # fmt: skip


def _plain(component: Component, besides: str) -> list[tuple[str, Value, str]]:
    return [
        (one.id, one.value, one.unit)
        for name, one in sorted(component.attributes.items())
        if not name.startswith(besides)
    ]
