"""What all chapters of the reader of REXS share: attributes, notes, load cases."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Final, Literal, NamedTuple

from rolamento.case.machine import (
    Belt,
    Gear,
    Housing,
    MachineBearing,
    Mass,
    Shaft,
    ShaftLoad,
    Spring,
)
from rolamento.case.record import Record
from rolamento.errors import FileError, InputError
from rolamento.exchange.rexs.model import Component, LoadCase, RexsModel
from rolamento.exchange.rexs.poses import HOME, Pose, Vector, poses_of
from rolamento.exchange.rexs.values import (
    former_names,
    number_of,
    numbers_of,
    placed,
    quantity_of,
    words,
)
from rolamento.records import frozen
from rolamento.units import Dimension, from_si, readable, to_si
from rolamento.words import Note, said

__all__ = [
    "ALIKE",
    "BEARINGS",
    "CUSTOM",
    "DIGEST",
    "FINEST",
    "GEARS",
    "NEAR",
    "PARALLEL",
    "SPRINGS",
    "Laid",
    "Mesh",
    "Part",
    "Reader",
    "Remark",
    "is_valid",
    "load_table",
    "put_written",
    "written",
]

CUSTOM: Final = "custom_rolamento"
"""Attribute in which Rolamento keeps what REXS has no word for."""
DIGEST: Final = f"{CUSTOM}_digest"
"""Attribute that says whether anything else in the file was changed since."""
BEARINGS: Final = (
    "rolling_bearing_with_catalog_geometry", "rolling_bearing_with_detailed_geometry",
)  # fmt: skip
GEARS: Final = ("cylindrical_gear", "bevel_gear", "worm_gear", "worm_wheel", "ring_gear")
SPRINGS: Final = ("concept_bearing", "coupling")
_RECORDS: Final[Mapping[str, type[Record]]] = {
    "shafts": Shaft, "bearings": MachineBearing, "housings": Housing, "springs": Spring,
    "loads": ShaftLoad, "gears": Gear, "belts": Belt, "masses": Mass,
}  # fmt: skip
PARALLEL: Final = 1e-6
"""By how much the cosine of two axes may differ from 1."""
NEAR: Final = 1e-6
"""By how much (m) a place may be off before that is said."""
ALIKE: Final = 1e-6
"""Part of a number by which two count as one."""
_NOISE: Final = 4e-15
"""What rounding leaves of a number that was calculated from one with few digits."""
FINEST: Final = 12
"""Decimals of a place in m."""
_SPEEDS: Final = ("rotational_speed",)
_LOADS: Final = (
    "force_u_direction", "force_v_direction", "force_w_direction", "torque_around_u_axis",
    "torque_around_v_axis", "torque_around_w_axis", "force_acting_on_shaft_u",
    "force_acting_on_shaft_v", "force_acting_on_shaft_w", "torque_acting_on_shaft_u",
    "torque_acting_on_shaft_v", "torque_acting_on_shaft_w",
)  # fmt: skip


@frozen
class Remark:
    """What was inferred, or left out.

    Attributes
    ----------
    sort
        ``"inferred"`` or ``"left"``
    component
        its id; None of the whole model
    note
        what is said
    """

    sort: Literal["inferred", "left"]
    component: int | None
    note: Note


class Part(NamedTuple):
    """A part of a machine as its file has it, and the component that it comes from.

    kind: its list in the machine file, such as ``"shafts"``; ``"machine"`` of what stands above.
    """

    kind: str
    component: int
    table: dict[str, Any]


class Laid(NamedTuple):
    """A shaft as it lies in the machine.

    flipped: whether its u axis points against x. start: u of its first section.
    """

    component: Component
    name: str
    pose: Pose
    flipped: bool
    start: float
    length: float

    def position(self, u: float) -> float:
        """Where a coordinate of the shaft is from its left end."""
        along = u - self.start
        return round(self.length - along if self.flipped else along, FINEST) + 0.0


class Mesh(NamedTuple):
    """Two gears that drive each other."""

    stage: Component
    gears: tuple[Component, Component]
    shafts: tuple[Laid, Laid]


class Reader:
    """Reads attributes of a model; notes what it uses, infers and leaves."""

    def __init__(self, model: RexsModel, load_case: int | None) -> None:
        self.whole = model
        self.used: dict[int, dict[str, None]] = {}
        self.remarks: list[Remark] = []
        self._spectrum: list[dict[str, Any]] = []
        self.model = self._with_loads(load_case)
        self._poses = poses_of(self.model, self._use)
        self._frame = HOME
        self._shafts: dict[int, Laid] = {}
        self._names: dict[str, set[str]] = {}
        self._untouched = False
        self._speeds: dict[int, float] = {}
        self._meshes: list[Mesh] = []
        self._powers: dict[int, list[float]] = {}
        """What loads and given tooth forces bring to each shaft, NaN where nobody says; W."""
        self._open: list[tuple[Laid, Component, float]] = []
        self._left_over: dict[int, float] = {}

    # --- attributes -------------------------------------------------------------------------------

    def _use(self, component: Component, name: str) -> None:
        self.used.setdefault(component.id, {})[name] = None

    def _note(
        self,
        sort: Literal["inferred", "left"],
        component: Component | None,
        note: str,
        /,
        **values: Any,
    ) -> None:
        number = None if component is None else component.id
        self.remarks.append(Remark(sort, number, Note(note, values)))

    def _found(self, component: Component, name: str) -> str | None:
        """The name, perhaps a former one, under which a component has an attribute."""
        return next((one for one in former_names(name) if one in component.attributes), None)

    def _value(self, component: Component, name: str) -> float | None:
        """A quantity in SI; None where it is missing or unknown."""
        if (found := self._found(component, name)) is None:
            return None
        self._use(component, found)
        attribute = component.attributes[found]
        if not attribute.value or (isinstance(attribute.value, str) and not attribute.text):
            return None
        value = quantity_of(component, attribute, name)
        return None if self._is_unknown(name, value, attribute.text) else value

    def _is_unknown(self, name: str, value: float, text: str) -> bool:
        unknown = words()["unknown"]
        if name.endswith("stiffness") and abs(value) >= unknown["stiffness"]:
            return True
        return self.model.zero_is_unknown and name in unknown["zero"] and float(text or "0") == 0.0

    def _number(self, component: Component, name: str) -> float | None:
        """A plain number; None where it is missing or unknown."""
        found = self._found(component, name)
        if found is None or not component.attributes[found].text:
            return None
        self._use(component, found)
        value = number_of(component, component.attributes[found])
        return None if self._is_unknown(name, value, repr(value)) else value

    def _whole(self, component: Component, name: str) -> int | None:
        number = self._number(component, name)
        if number is not None and (number != int(number) or abs(number) > 1e6):
            raise placed(FileError(said("must be a whole number"), value=number), component, name)
        return None if number is None else int(number)

    def _numbers(self, component: Component, name: str) -> tuple[float, ...]:
        if name not in component.attributes:
            return ()
        self._use(component, name)
        return numbers_of(component, component.attributes[name], name)

    def _text(self, component: Component, name: str) -> str:
        if (found := self._found(component, name)) is None:
            return ""
        self._use(component, found)
        return component.attributes[found].text

    def _true(self, component: Component, name: str) -> bool | None:
        text = self._text(component, name).lower()
        return None if text not in ("true", "false", "1", "0") else text in ("true", "1")

    def _named(self, component: Component, kind: str) -> str:
        """A name for a part, which no other of its kind has."""
        plain = component.name.removesuffix(f"[{component.id}]").strip()
        plain = " ".join("".join(c if c.isprintable() else " " for c in plain).split())[:150]
        name = plain or f"{component.type.replace('_', ' ')} {component.id}"
        taken = self._names.setdefault(kind, set())
        if name in taken:
            new = f"{name} ({component.id})"
            while new in taken:
                new += "'"
            self._note("inferred", component, "rexs_named_again", name=name, new=new)
            name = new
        taken.add(name)
        return name

    # --- load cases -------------------------------------------------------------------------------

    def _with_loads(self, wanted: int | None) -> RexsModel:
        cases = self.whole.load_cases
        if wanted is not None:
            chosen = next((case for case in cases if case.id == wanted), None)
            if chosen is None:
                known = ", ".join(str(case.id) for case in cases[:20])
                raise FileError(
                    said("is no load case of the file; it has {known}", known=known or "–"),
                    field="load_case",
                    value=wanted,
                )
            return self.whole.in_load_case(chosen)
        if not cases:
            return self.whole
        base = self.whole.in_load_case(cases[0])
        if len(cases) > 1:
            self._read_spectrum(base, cases)
        return base

    def _read_spectrum(self, base: RexsModel, cases: Sequence[LoadCase]) -> None:
        """Take load cases as the steps of a spectrum, where two factors part them."""
        first = _duty(base, base.components)
        steps = []
        shares = []
        for case in cases:
            own = _duty(base, case.components)
            factors = [_factor(first[kind], own[kind]) for kind in (0, 1)]
            if None in factors or own[0].keys() != first[0].keys() & own[0].keys():
                self._note(
                    "left", None, "rexs_load_cases", count=len(cases), taken=cases[0].id
                )  # fmt: skip
                return
            speed, load = factors
            steps.append({
                "name": said("load case {number}", number=case.id),
                "speed_factor": speed, "load_factor": load,
            })  # fmt: skip
            shares.append(self._share(base, case))
        total = math.fsum(share for share in shares if share is not None)
        if None in shares or not total > 0.0:
            self._note("inferred", None, "rexs_equal_shares")
            shares, total = [1.0] * len(cases), float(len(cases))
        for step, share in zip(steps, shares, strict=True):
            step["share"] = (share or 0.0) / total
        self._spectrum = [
            {name: value for name, value in step.items() if value != 1.0 or name == "share"}
            for step in steps
        ]

    def _share(self, base: RexsModel, case: LoadCase) -> float | None:
        for component in case.components:
            full = base.by_id.get(component.id)
            if full is None or full.type != "gear_unit":
                continue
            for name in ("operating_time_fraction", "operating_time"):
                if name in component.attributes:
                    self._use(full, name)
                    own = component.attributes[name]
                    return (
                        number_of(full, own)
                        if name.endswith("fraction")
                        else quantity_of(full, own, name)
                    )
        return None


def is_valid(kind: str, table: Mapping[str, Any]) -> bool:
    """Whether a table describes a part; of what stands above the parts the machine says."""
    record = _RECORDS.get(kind)
    try:
        part = None if record is None else record.from_mapping(table)
        if isinstance(part, MachineBearing):
            part.case  # noqa: B018  # which is refused if it is none
    except InputError:
        return False
    return True


def written(value: float, dimension: Dimension) -> str:
    """A quantity as a machine file has it, without what rounding left behind the twelfth digit."""
    short = readable(value, dimension, 12)
    return (
        short
        if abs(to_si(short, dimension) - value) <= _NOISE * abs(value)
        else from_si(value, dimension)
    )


def put_written(table: dict[str, Any], key: str, value: float | None, dimension: Dimension) -> None:
    """Put a quantity into a table as a machine file has it, if it is known."""
    if value is not None:
        table[key] = written(value, dimension)


def load_table(
    name: str, shaft: str, position: float, force: Vector, moment: Vector
) -> dict[str, Any]:
    """Return the table of a load; force and moment in N and N·m."""
    table: dict[str, Any] = {"name": name, "shaft": shaft, "position": written(position, "length")}
    for key, value in zip(("fx", "fy", "fz"), force, strict=True):
        if value:
            table[key] = written(value, "force")
    for key, value in zip(("mx", "my", "mz"), moment, strict=True):
        if value:
            table[key] = written(value, "moment")
    return table


def _duty(
    base: RexsModel, components: Iterable[Component]
) -> tuple[dict[tuple[int, str], float], dict[tuple[int, str], float]]:
    """Speeds and loads of a load case, by component and attribute."""
    found: tuple[dict[tuple[int, str], float], dict[tuple[int, str], float]] = ({}, {})
    for one in components:
        full = base.by_id.get(one.id)
        if full is None or full.type not in ("shaft", "external_load", *GEARS):
            continue
        for names, values in zip((_SPEEDS, _LOADS), found, strict=True):
            if names is _SPEEDS and full.type != "shaft":
                continue
            for name in names:
                if name in one.attributes and one.attributes[name].text:
                    values[one.id, name] = quantity_of(full, one.attributes[name], name)
    return found


def _factor(
    first: Mapping[tuple[int, str], float], own: Mapping[tuple[int, str], float]
) -> float | None:
    """The one factor between two load cases; None where there is more than one."""
    greatest = max((abs(value) for value in first.values()), default=0.0)
    if not greatest:
        return None if any(own.values()) else 1.0
    pivot = max(first, key=lambda key: abs(first[key]))
    factor = own.get(pivot, first[pivot]) / first[pivot]
    for key, value in own.items():
        if abs(value - factor * first.get(key, 0.0)) > ALIKE * max(greatest, abs(value)):
            return None
    return float(f"{factor:.12g}")
