"""A machine of a REXS model: what is taken, what is inferred, and what is left out."""

from __future__ import annotations

import json
import math
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, Final, Literal, NamedTuple

from rolamento.case.lubricant import Lubricant
from rolamento.case.machine import (
    Belt,
    Gear,
    Housing,
    Machine,
    MachineBearing,
    Mass,
    Shaft,
    ShaftLoad,
    Spring,
)
from rolamento.case.machine_files import MOST_SECTIONS
from rolamento.case.machine_loads import operating_mesh
from rolamento.case.record import Record
from rolamento.catalogue import CatalogueBearing, catalogue
from rolamento.errors import FileError, InputError
from rolamento.exchange.rexs.model import Component, LoadCase, RexsModel
from rolamento.exchange.rexs.poses import HOME, Pose, Vector, crossing, dot, poses_of
from rolamento.exchange.rexs.values import (
    former_names,
    number_of,
    numbers_of,
    placed,
    quantity_of,
    words,
)
from rolamento.io.json import plain
from rolamento.records import frozen
from rolamento.types import BALL, TYPES, BearingType
from rolamento.units import Dimension, from_si, readable, to_si
from rolamento.words import Note, said

__all__ = [
    "APPLICATION",
    "CUSTOM",
    "DIGEST",
    "Imported",
    "Part",
    "Remark",
    "Taken",
    "machine_of_rexs",
    "parts_of",
]

SCHEMA: Final = 1
KIND: Final = "rexs_import"
APPLICATION: Final = "Rolamento"
CUSTOM: Final = "custom_rolamento"
"""Attribute in which Rolamento keeps what REXS has no word for."""

DIGEST: Final = f"{CUSTOM}_digest"
"""Attribute that says whether anything else in the file was changed since."""

BEARINGS: Final = (
    "rolling_bearing_with_catalog_geometry", "rolling_bearing_with_detailed_geometry",
)  # fmt: skip
GEARS: Final = ("cylindrical_gear", "bevel_gear", "worm_gear", "worm_wheel", "ring_gear")
_SPRINGS: Final = ("concept_bearing", "coupling")
_READ: Final = (
    "gear_unit", "gear_casing", "shaft", "shaft_section", "external_load", *GEARS,
    "cylindrical_stage", "bevel_stage", "additional_mass", "lubricant", "material",
    "rolling_bearing_row", "rolling_element", "flank_geometry", *BEARINGS, *_SPRINGS,
)  # fmt: skip
_MOST: Final = (
    (("shaft",), 20), (BEARINGS, 100), (("external_load",), 500), (GEARS, 100),
    (("cylindrical_stage", "bevel_stage"), 100), (("additional_mass",), 500), (_SPRINGS, 200),
    (("shaft_section",), 20 * MOST_SECTIONS),
)  # fmt: skip
"""As many components of some types as a machine has; no more are looked at."""
_RECORDS: Final[Mapping[str, type[Record]]] = {
    "shafts": Shaft, "bearings": MachineBearing, "housings": Housing, "springs": Spring,
    "loads": ShaftLoad, "gears": Gear, "belts": Belt, "masses": Mass,
}  # fmt: skip
_SILENT: Final = ("stage_gear_data", "rolling_element_contact")
"""What holds no more than results, or nothing."""
_PARALLEL: Final = 1e-6
_CROSSING: Final = 0.01
"""Distance of two axes, over the pitch diameter, up to which they count as crossing: no hypoids."""
_NEAR: Final = 1e-6
"""By how much (m) a place may be off before that is said."""
_SIZE: Final = 1e-6
_ALIKE: Final = 1e-6
_NOISE: Final = 4e-15
"""What rounding leaves of a number that was calculated from one with few digits."""
_FINEST: Final = 12
"""Decimals of a place in m."""
_SPEEDS: Final = ("rotational_speed",)
_LOADS: Final = (
    "force_u_direction", "force_v_direction", "force_w_direction", "torque_around_u_axis",
    "torque_around_v_axis", "torque_around_w_axis", "force_acting_on_shaft_u",
    "force_acting_on_shaft_v", "force_acting_on_shaft_w", "torque_acting_on_shaft_u",
    "torque_acting_on_shaft_v", "torque_acting_on_shaft_w",
)  # fmt: skip
_USUAL_PRESSURE_ANGLE: Final = math.radians(20.0)
_USUAL_DENSITY: Final = "880 kg/m^3"
_OFTEN_REFUSED: Final = ("mounting", "temperature", "life", "preload", "offset")
"""What a bearing may do without, in the order in which it is tried."""


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


@frozen
class Taken:
    """A component that became a part of the machine.

    Attributes
    ----------
    component, type, name
        as in the file
    part
        of the machine, such as ``"shafts.0"``; empty of one that counts elsewhere
    attributes
        that were read
    """

    component: int
    type: str
    name: str
    part: str
    attributes: tuple[str, ...]


@frozen(eq=False)
class Imported:
    """A machine that was read from a REXS model.

    Attributes
    ----------
    machine
        what it became
    version, application
        of the file
    taken
        components that were read, in the order of the file
    remarks
        what was inferred or left out
    """

    machine: Machine
    version: str
    application: str
    taken: tuple[Taken, ...]
    remarks: tuple[Remark, ...]

    def of_sort(self, sort: str) -> tuple[Remark, ...]:
        """Return the remarks on what was ``"inferred"``, or ``"left"`` out."""
        return tuple(one for one in self.remarks if one.sort == sort)

    def to_mapping(self) -> dict[str, Any]:
        """Give everything as plain mappings and lists."""
        return {
            "schema": SCHEMA,
            "kind": KIND,
            "version": self.version,
            "application": self.application,
            "taken": [
                {
                    "component": one.component,
                    "type": one.type,
                    "name": one.name,
                    "part": one.part or None,
                    "attributes": list(one.attributes),
                }
                for one in self.taken
            ],
            **{
                sort: [
                    {"component": one.component, **one.note.to_mapping()}
                    for one in self.of_sort(sort)
                ]
                for sort in ("inferred", "left")
            },
            "machine": plain(self.machine.to_mapping()),
        }


class Part(NamedTuple):
    """A part of a machine as its file has it, and the component that it comes from.

    kind: its list in the machine file, such as ``"shafts"``; ``"machine"`` of what stands above.
    """

    kind: str
    component: int
    table: dict[str, Any]


def machine_of_rexs(model: RexsModel, *, load_case: int | None = None) -> Imported:
    """Return the machine that a REXS model describes.

    Parameters
    ----------
    model
        Of `rolamento.exchange.rexs.read_rexs`.
    load_case
        Id of the one to take; by default the whole load spectrum, where one factor of load and one
        of speed part its load cases, else the first.

    Raises
    ------
    FileError
        If a number or a unit is none, components refer to each other in a circle, or there is no
        such load case.
    InputError
        If what is there makes no machine: no shaft, or no bearing.
    """
    reader = _Reader(model, load_case)
    plain_parts = reader.parts()
    parts = list(reader.restored(plain_parts))
    if not any(part.kind == "shafts" for part in parts):
        raise InputError(said("has no shaft with sections, of which a machine is made"))
    try:
        machine = Machine.from_mapping(_assembled(parts))
    except InputError:
        if not reader.was_changed:
            raise
        parts = plain_parts  # parts that do not go together with what was changed
        machine = Machine.from_mapping(_assembled(parts))
    counts: dict[str, int] = {}
    names: dict[int, list[str]] = {}
    for part in parts:
        if part.kind != "machine":
            place = counts.get(part.kind, -1) + 1
            counts[part.kind] = place
            names.setdefault(part.component, []).append(f"{part.kind}.{place}")
    taken = tuple(
        Taken(one.id, one.type, one.name, ", ".join(names.get(one.id, ())), used)
        for one in model.components
        if (used := tuple(reader.used.get(one.id, ()))) or one.id in names
    )
    reader.name_what_is_left()
    return Imported(machine, model.version, model.application, taken, tuple(reader.remarks))


def parts_of(model: RexsModel) -> list[Part]:
    """Return the parts of a machine as any reader of REXS finds them, without Rolamento's own."""
    return _Reader(model, None).parts()


def _assembled(parts: Iterable[Part]) -> dict[str, Any]:
    mapping: dict[str, Any] = {}
    for part in parts:
        if part.kind == "machine":
            mapping.update(part.table)
        else:
            mapping.setdefault(part.kind, []).append(part.table)
    return mapping


class _Laid(NamedTuple):
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
        return round(self.length - along if self.flipped else along, _FINEST) + 0.0


class _Mesh(NamedTuple):
    """Two gears that drive each other."""

    stage: Component
    gears: tuple[Component, Component]
    shafts: tuple[_Laid, _Laid]


class _Reader:
    """Reads a model once; notes what it uses, infers and leaves."""

    def __init__(self, model: RexsModel, load_case: int | None) -> None:
        self.whole = model
        self.used: dict[int, dict[str, None]] = {}
        self.remarks: list[Remark] = []
        self._spectrum: list[dict[str, Any]] = []
        self.model = self._with_loads(load_case)
        self._poses = poses_of(self.model, self._use)
        self._frame = HOME
        self._shafts: dict[int, _Laid] = {}
        self._names: dict[str, set[str]] = {}
        self._untouched = False
        self._speeds: dict[int, float] = {}
        self._meshes: list[_Mesh] = []
        self._powers: dict[int, list[float]] = {}
        """What loads and given tooth forces bring to each shaft, NaN where nobody says; W."""
        self._open: list[tuple[_Laid, Component, float]] = []
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

    # --- the whole --------------------------------------------------------------------------------

    def parts(self) -> list[Part]:
        """Return the parts of the machine, as any reader finds them."""
        if not self.model.version.startswith(("1.", "2.0")):
            self._note("left", None, "rexs_version", version=self.model.version[:20])
        self._check_counts()
        self._check_relations()
        shafts = self._read_shafts()
        bearings = list(self._read_bearings())
        springs = list(self._read_springs())
        loads, gears = list(self._read_loads()), list(self._read_gears())
        masses = list(self._read_masses())
        units = list(self.model.of_type("gear_unit"))
        head = self._read_head(units[0] if units else None)
        return [
            Part("machine", units[0].id if units else 0, head),
            *shafts, *bearings, *springs, *loads, *gears, *masses,
        ]  # fmt: skip

    def _check_counts(self) -> None:
        counts = Counter(one.type for one in self.model.components)
        for types, most in _MOST:
            count = sum(counts[name] for name in types)
            if count > most:
                raise FileError(
                    said("is there {count} times; a machine has at most {most}",
                         count=count, most=most),
                    field=types[0],
                )  # fmt: skip

    def _check_relations(self) -> None:
        missing: set[int] = set()
        for relation in self.model.relations:
            for ref in relation.refs:
                if ref.id not in self.model.by_id and ref.id not in missing:
                    missing.add(ref.id)
                    self._note(
                        "left", None, "rexs_missing_component", relation=relation.id, id=ref.id
                    )

    @property
    def was_changed(self) -> bool:
        """Whether another program has changed what Rolamento had written."""
        return any(one.note.key == "rexs_changed" for one in self.remarks)

    def name_what_is_left(self) -> None:
        """Note components and attributes that nobody read, those of a type together."""
        others: dict[str, list[Component]] = {}
        unread: dict[str, dict[str, None]] = {}
        read: dict[str, set[str]] = {}
        for one in self.whole.components:
            read.setdefault(one.type, {CUSTOM, DIGEST}).update(self.used.get(one.id, ()))
        for one in self.whole.components:
            if one.type not in _READ and one.type not in _SILENT:
                others.setdefault(one.type, []).append(one)
            elif one.type in _READ:
                left = [
                    name
                    for name in one.attributes
                    if name not in read[one.type] and not _is_result(name)
                ]
                if left:
                    unread.setdefault(one.type, {}).update(dict.fromkeys(left))
        if any(_is_result(name) for one in self.whole.components for name in one.attributes):
            self._note("left", None, "rexs_results_left")
        if self.whole.application == APPLICATION and not self.was_changed:
            return  # what nobody read stands in its own attributes
        for kind, found in others.items():
            self.remarks.append(
                Remark("left", None, Note("rexs_components_left", {
                    "type": kind, "count": len(found),
                    "ids": ", ".join(str(one.id) for one in found[:20]),
                }))
            )  # fmt: skip
        for kind, names in unread.items():
            self.remarks.append(
                Remark("left", None, Note("rexs_attributes_left", {
                    "type": kind, "attributes": ", ".join(sorted(names)),
                }))
            )  # fmt: skip

    def _read_head(self, unit: Component | None) -> dict[str, Any]:
        head: dict[str, Any] = {}
        warm: dict[str, str] = {}
        if unit is not None:
            if title := self._text(unit, "model_name"):
                head["title"] = " ".join(title.split())[:200]
            if gravity := self._gravity(unit):
                head["gravity"] = gravity
        for casing in self.model.of_type("gear_casing"):
            _put(warm, "lubricant", self._value(casing, "temperature_lubricant"), "temperature")
            _put(warm, "housing", self._value(casing, "mean_operating_temperature"), "temperature")
            break
        for laid in self._shafts.values():
            hot = self._value(laid.component, "mean_operating_temperature")
            if "shaft" not in warm:
                _put(warm, "shaft", hot, "temperature")
        oil = self._shared_oil()
        if oil is not None and (table := self._lubricant(oil)):
            head["lubricant"] = table
        if warm:
            head["temperature"] = warm
        if self._spectrum:
            head["spectrum"] = self._spectrum
        return head

    def _gravity(self, unit: Component) -> dict[str, Any] | None:
        if not self._true(unit, "account_for_gravity"):
            return None
        vector = [self._number(unit, f"direction_vector_gravity_{axis}") or 0.0 for axis in "uvw"]
        local = self._frame.local((vector[0], vector[1], vector[2]))
        size = math.hypot(*local)
        axis = max(range(3), key=lambda place: abs(local[place]))
        if not size or abs(local[axis]) < (1.0 - _PARALLEL) * size:
            self._note("left", unit, "rexs_gravity")
            return None
        gravity = {"direction": f"{'+' if local[axis] > 0.0 else '-'}{'xyz'[axis]}"}
        _put(gravity, "acceleration", self._value(unit, "gravitational_acceleration"),
             "acceleration")  # fmt: skip
        return gravity

    def _lubricant_of(self, *origins: Component) -> Component | None:
        for origin in origins:
            for found in self.model.related("reference", origin.id, "origin", "referenced"):
                if found.type == "lubricant":
                    return found
        return None

    def _shared_oil(self) -> Component | None:
        """The lubricant of the casing, or the first one."""
        of_casing = self._lubricant_of(*self.model.of_type("gear_casing"))
        return of_casing or next(self.model.of_type("lubricant"), None)

    def _lubricant(self, oil: Component) -> Any:
        """A lubricant by its viscosities, or its name where that is known."""
        name = self._text(oil, "name") or oil.name.removesuffix(f"[{oil.id}]").strip()
        table: dict[str, Any] = {}
        quantities: tuple[tuple[str, str, Dimension], ...] = (
            ("viscosity_40", "viscosity_at_40_degree_celsius", "kinematic_viscosity"),
            ("viscosity_100", "viscosity_at_100_degree_celsius", "kinematic_viscosity"),
            ("density", "density_at_15_degree_celsius", "density"),
            ("pressure_viscosity", "pressure_viscosity_coefficient_at_38_degrees_celsius",
             "pressure_viscosity_coefficient"),
            ("thermal_conductivity", "thermal_conductivity", "thermal_conductivity"),
        )  # fmt: skip
        for key, attribute, dimension in quantities:
            _put(table, key, self._value(oil, attribute), dimension)
        if "density" in table:
            table["density_temperature"] = "15 degC"
        if "viscosity_40" not in table or "viscosity_100" not in table:
            points = zip(
                self._numbers(oil, "temperature_variation_lubricant_viscosity"),
                self._numbers(oil, "temperature_dependent_kinematic_viscosity"),
                strict=False,
            )
            found = [
                {"temperature": _text(hot, "temperature"),
                 "viscosity": _text(thick, "kinematic_viscosity")}
                for hot, thick in points
            ]  # fmt: skip
            if len(found) > 1:
                table = {k: v for k, v in table.items() if not k.startswith("viscosity_")}
                table["viscosities"] = [found[0], found[-1]]
        if name:
            table["name"] = " ".join(name.split())[:100]
        if (kind := self._text(oil, "kind")) in ("oil", "grease"):
            table["kind"] = kind
        if self._text(oil, "basis") == "mineral":
            table["oil_type"] = "mineral"
        if any(key.startswith("viscosit") for key in table) and "density" not in table:
            table["density"] = _USUAL_DENSITY
        for tried in (table, name):
            try:
                if isinstance(tried, str):
                    Lubricant.named(tried)
                else:
                    Lubricant.from_mapping(tried)
            except InputError:
                continue
            if tried is table and table.get("density") == _USUAL_DENSITY:
                self._note("inferred", oil, "rexs_usual_density")
            return tried
        self._note("left", oil, "rexs_lubricant")
        return None

    # --- shafts -----------------------------------------------------------------------------------

    def _read_shafts(self) -> list[Part]:
        components = list(self.model.of_type("shaft"))
        self._lay_frame(components)
        sections = {one.id: self._sections(one) for one in components}
        for one in components:
            pose = self._poses.get(one.id, HOME)
            along = dot(pose.u, self._frame.u)
            if abs(abs(along) - 1.0) > _PARALLEL:
                self._note("left", one, "rexs_not_parallel")
                continue
            if not sections[one.id]:
                self._note("left", one, "rexs_no_sections")
                continue
            if along < 0.0:
                self._note("inferred", one, "rexs_turned_shaft")
            start = sections[one.id][0][0]
            length = math.fsum(section[1] for section in sections[one.id])
            name = self._named(one, "shafts")
            self._shafts[one.id] = _Laid(one, name, pose, along < 0.0, start, length)
        self._meshes = list(self._read_meshes())
        ratios = self._read_speeds()
        parts = []
        for number, laid in self._shafts.items():
            left = laid.start + (laid.length if laid.flipped else 0.0)
            at = self._frame.seen_from(laid.pose.point((left, 0.0, 0.0)))[0]
            table: dict[str, Any] = {
                "name": laid.name,
                "sections": [
                    _section(one, laid.flipped)
                    for one in sections[number][:: -1 if laid.flipped else 1]
                ],
                **ratios.get(number, {}),
            }
            if at := round(at, _FINEST) + 0.0:
                table["position"] = _text(at, "length")
            if material := self._material(laid.component):
                table["material"] = material
            parts.append(Part("shafts", number, table))
        return parts

    def _lay_frame(self, shafts: Sequence[Component]) -> None:
        """Choose x: along u of the gear unit if the first shaft lies so, else along the shaft."""
        if not shafts:
            return
        pose = self._poses.get(shafts[0].id, HOME)
        if abs(abs(pose.u[0]) - 1.0) > _PARALLEL:
            self._frame = Pose((0.0, 0.0, 0.0), pose.u, pose.v, pose.w)
            self._note("inferred", None, "rexs_axes", shaft=shafts[0].name)

    def _sections(self, shaft: Component) -> list[tuple[float, ...]]:
        """Start, length, both outside and both inside diameters of its sections, in order."""
        found: list[tuple[float, ...]] = []
        for one in self.model.parts(shaft.id, "shaft_section"):
            length = self._value(one, "length")
            outside = [self._value(one, f"outer_diameter_{end}") for end in ("begin", "end")]
            begin = outside[0] if outside[0] is not None else outside[1]
            end = outside[1] if outside[1] is not None else outside[0]
            if length is None or begin is None or end is None:
                raise placed(
                    FileError(said("is missing")), one,
                    "length" if length is None else "outer_diameter_begin",
                )  # fmt: skip
            inside = [
                self._value(one, f"inner_diameter_{side}") or 0.0 for side in ("begin", "end")
            ]
            start = self._value(one, "u_coordinate_on_shaft")
            if start is None:
                start = found[-1][0] + found[-1][1] if found else 0.0
            if length > 0.0:
                found.append((start, length, begin, end, *inside))
        found.sort(key=lambda section: section[0])
        filled: list[tuple[float, ...]] = []
        for section in found:
            gap = round(section[0] - filled[-1][0] - filled[-1][1], 9) if filled else 0.0
            if gap < 0.0:
                raise FileError(
                    said("has sections that overlap by {overlap}",
                         overlap=_text(-gap, "length")),
                    field=f"shaft {shaft.id}", value=shaft.name or None,
                )  # fmt: skip
            if gap > 0.0:
                last = filled[-1]
                thin = min((last[3], last[5]), (section[2], section[4]))
                filled.append((last[0] + last[1], gap, thin[0], thin[0], thin[1], thin[1]))
                self._note("inferred", shaft, "rexs_gap", gap=gap)
            filled.append(section)
        return filled

    def _material(self, shaft: Component) -> dict[str, Any] | None:
        for found in self.model.related("reference", shaft.id, "origin", "referenced"):
            if found.type != "material":
                continue
            table: dict[str, Any] = {}
            _put(table, "youngs_modulus", self._value(found, "elastic_modulus"), "stress")
            _put(table, "density", self._value(found, "density"), "density")
            if (ratio := self._number(found, "poisson_ratio")) is not None:
                table["poisson_ratio"] = ratio
            if len(table) == 3:
                named = self._text(found, "material_designation") or found.name
                return {"name": " ".join(named.split())[:100] or "custom", **table}
        return None

    def _read_meshes(self) -> Iterator[_Mesh]:
        for relation in self.model.relations:
            if relation.type != "stage":
                continue
            numbers = [relation.in_role(role) for role in ("stage", "gear_1", "gear_2")]
            found = [self.model.by_id.get(number or 0) for number in numbers]
            if None in found:
                continue
            stage, *gears = (one for one in found if one is not None)
            shafts = [self._shaft_of(gear) for gear in gears]
            if all(gear.type == "cylindrical_gear" for gear in gears) and None not in shafts:
                one, other = (shaft for shaft in shafts if shaft is not None)
                yield _Mesh(stage, (gears[0], gears[1]), (one, other))

    def _shaft_of(self, part: Component) -> _Laid | None:
        whole = self.model.whole_of(part.id, "shaft")
        return None if whole is None else self._shafts.get(whole.id)

    def _read_speeds(self) -> dict[int, dict[str, Any]]:
        """Speeds that are given, and ratios to shafts in mesh for those that have none."""
        found: dict[int, dict[str, Any]] = {}
        for number, laid in self._shafts.items():
            speed = self._value(laid.component, "rotational_speed")
            defines = self._true(laid.component, "defines_speed")
            if speed is None and defines and "rotational_speed" in laid.component.attributes:
                speed = 0.0
            if speed is not None:
                self._speeds[number] = -speed if laid.flipped else speed
                found[number] = {"speed": _text(self._speeds[number] + 0.0, "angular_speed")}
        waiting = True
        while waiting:
            waiting = False
            for mesh in self._meshes:
                numbers = [shaft.component.id for shaft in mesh.shafts]
                known = [number in self._speeds for number in numbers]
                if known[0] == known[1] or numbers[0] == numbers[1]:
                    continue
                here = known.index(False)
                teeth = [self._whole(gear, "number_of_teeth") or 0 for gear in mesh.gears]
                if min(teeth) < 1:
                    continue
                ratio = -teeth[1 - here] / teeth[here]
                self._speeds[numbers[here]] = ratio * self._speeds[numbers[1 - here]]
                found[numbers[here]] = {"ratio": ratio, "of": mesh.shafts[1 - here].name}
                self._note(
                    "inferred", mesh.shafts[here].component, "rexs_speed_by_teeth",
                    gear=mesh.gears[here].name, mate=mesh.gears[1 - here].name,
                )  # fmt: skip
                waiting = True
        for number, laid in self._shafts.items():
            if number not in self._speeds:
                self._speeds[number] = 0.0
                self._note("inferred", laid.component, "rexs_at_rest")
        return found

    # --- places -----------------------------------------------------------------------------------

    def _position(
        self, part: Component, laid: _Laid, coordinate: str, before: float = 0.0
    ) -> float | None:
        """Where a part is from the left end of its shaft; before: its middle, past a coordinate."""
        given = self._value(part, coordinate)
        by_coordinate = None if given is None else laid.position(given + before)
        pose = self._poses.get(part.id)
        position = by_coordinate
        if pose is not None:
            local = laid.pose.seen_from(pose.origin)
            position = laid.position(local[0])
            if by_coordinate is not None and abs(position - by_coordinate) > _NEAR:
                self._note("inferred", part, "rexs_places_differ",
                           difference=abs(position - by_coordinate))  # fmt: skip
        if position is None:
            self._note("left", part, "rexs_no_place")
            return None
        if not -_NEAR <= position <= laid.length + _NEAR:
            self._note("left", part, "rexs_off_shaft")
            return None
        return min(max(position, 0.0), laid.length)

    def _sides(self, part: Component) -> tuple[Component | None, Component | None]:
        """What stands in a bearing or coupling, and what around it."""
        for relation in self.model.relations_of(part.id, "assembly", "side"):
            one, other = (
                self.model.by_id.get(relation.in_role(role) or 0)
                for role in ("inner_part", "outer_part")
            )
            return one, other
        return self.model.whole_of(part.id, "shaft"), None

    def _toward_x(self, part: Component, laid: _Laid) -> float:
        """+1 where the u axis of a part points as the machine's x, else -1."""
        pose = self._poses.get(part.id, laid.pose)
        return -1.0 if dot(pose.u, self._frame.u) < 0.0 else 1.0

    # --- bearings ---------------------------------------------------------------------------------

    def _read_bearings(self) -> Iterator[Part]:
        for one in self.model.of_type(*BEARINGS):
            if (table := self._bearing(one)) is not None:
                yield Part("bearings", one.id, table)

    def _bearing(self, one: Component) -> dict[str, Any] | None:
        inner, outer = self._sides(one)
        laid = None if inner is None else self._shafts.get(inner.id)
        if laid is None:
            around = None if outer is None else self._shafts.get(outer.id)
            self._note("left", one, "rexs_ring_on_casing" if around else "rexs_no_shaft")
            return None
        position = self._position(one, laid, "u_coordinate_on_shaft_inner_side")
        if position is None:
            return None
        inside = self._inside(one)
        if inside is None:
            self._note("left", one, "rexs_bearing_unknown")
            return None
        table: dict[str, Any] = {
            "name": self._named(one, "bearings"),
            "shaft": laid.name,
            "position": _text(position, "length"),
            **inside,
        }
        if outer is not None and outer.id in self._shafts:
            self._value(one, "u_coordinate_on_shaft_outer_side")
            table["outer_shaft"] = self._shafts[outer.id].name
        for key, own in (
            ("life", self._life(one)), ("temperature", self._warmth(one)),
            ("mounting", self._mounting(one)),
        ):  # fmt: skip
            if own:
                table[key] = own
        if force := self._value(one, "preload_force"):
            table["preload"] = _text(force, "force")
        elif shift := self._value(one, "preload_distance"):
            table["offset"] = _text(shift, "length")
        oil = self._lubricant_of(one)
        if oil is not None and oil is not self._shared_oil() and (found := self._lubricant(oil)):
            table["lubricant"] = found
        if any(
            self._value(one, name)
            for name in ("misalignment_in_v_direction", "misalignment_in_w_direction",
                         "angular_misalignment_around_v_axis",
                         "angular_misalignment_around_w_axis")
        ):  # fmt: skip
            self._note("left", one, "rexs_misaligned")
        return self._valid_bearing(one, table, laid)

    def _valid_bearing(
        self, one: Component, table: dict[str, Any], laid: _Laid
    ) -> dict[str, Any] | None:
        """The table of a bearing without what its type does not take; None if it is none."""
        while True:
            try:
                case = MachineBearing.from_mapping(table).case
            except InputError as error:
                head = (error.field or "").partition(".")[0]
                spare = [key for key in _OFTEN_REFUSED if key in table]
                if not spare:
                    self._note("left", one, "rexs_bearing_refused", reason=str(error))
                    return None
                key = head if head in spare else spare[0]
                del table[key]
                self._note("left", one, "rexs_table_refused", table=key, reason=str(error))
            else:
                break
        bearing = case.bearing
        word = self._text(one, "axial_force_absorption")
        sign = {"positive": 1.0, "negative": -1.0}.get(word)
        if sign is not None:
            way = "+x" if sign * self._toward_x(one, laid) > 0.0 else "-x"
            if bearing.carries_one_way:
                table["faces"] = way
            elif bearing.locates or bearing.is_set:
                table["located"] = way
            self._note(
                "inferred", one, "rexs_axial_word", word=word,
                key="faces" if "faces" in table else "located", value=way,
            )  # fmt: skip
        elif word == "no_direction" and (
            bearing.locates or getattr(bearing, "inner_ribs", "none") != "none"
        ):
            table["located"] = "floating"
        elif word == "both_directions" and bearing.carries_one_way:
            self._note("left", one, "rexs_one_way", word=word)
        if not (bearing.locates or bearing.is_set):
            table.pop("preload", None)
            table.pop("offset", None)
        return table

    def _inside(self, one: Component) -> dict[str, Any] | None:
        """Designation or table of a bearing; None where nothing says what rolls in it."""
        word = self._text(one, "bearing_type")
        keys: list[str] = words()["bearing_types"].get(word, [])
        sizes = [self._value(one, name) for name in ("inner_diameter", "outer_diameter", "width")]
        designation = self._designation(one, keys, sizes, word)
        geometry = self._geometry(one, keys)
        clearance = self._value(one, "radial_bearing_clearance")
        kind = TYPES[keys[0]] if keys else None
        angled = kind is not None and (kind.in_pairs or kind.conical or kind.washers)
        if clearance and not angled:
            geometry = {**(geometry or {}), "diametral_clearance": _text(clearance, "length")}
        if designation and not geometry:
            return {"designation": designation}
        if designation:
            return {"bearing": {"designation": designation, **(geometry or {})}}
        if geometry and len(geometry) > 3:
            return {"bearing": geometry}
        return None

    def _designation(
        self, one: Component, keys: Sequence[str], sizes: Sequence[float | None], word: str
    ) -> str:
        """A designation that the catalogue knows, with the sizes of the file; empty without one."""
        given = self._text(one, "catalogue_designation")
        plain = one.name.removesuffix(f"[{one.id}]").strip()
        tried = {given: False, plain: True, plain.partition(" ")[2]: True}
        for text, from_name in tried.items():
            if not (found := _of_catalogue(text)):
                continue
            bore, outside, _ = sizes
            if _apart(found.bore, bore) or _apart(found.outside_diameter, outside):
                self._note(
                    "inferred", one, "rexs_other_sizes", designation=text, bore=found.bore,
                    outside=found.outside_diameter, given_bore=bore or 0.0,
                    given_outside=outside or 0.0,
                )  # fmt: skip
                continue
            if from_name:
                self._note("inferred", one, "rexs_by_name", designation=text)
            if keys and found.kind not in keys:
                self._note(
                    "inferred", one, "rexs_type_misleads", word=word, designation=text,
                    type=TYPES[found.kind].name,
                )  # fmt: skip
            return self._with_class(one, text)
        return self._by_size(one, keys, sizes)

    def _with_class(self, one: Component, designation: str) -> str:
        given = self._text(one, "radial_clearance_class")
        usual: dict[str, str] = words()["fits"]["clearance_classes"]
        suffix = usual.get(given, "CN")
        if suffix == "CN" or "/C" in designation.upper():
            return designation
        longer = f"{designation}/{suffix}"
        return longer if _of_catalogue(longer) else designation

    def _by_size(self, one: Component, keys: Sequence[str], sizes: Sequence[float | None]) -> str:
        bore, outside, width = sizes
        if bore is None or outside is None or not keys:
            return ""
        rating = self._value(one, "radial_dynamic_load_rating") or 0.0
        alike = [
            other
            for other in catalogue().bearings
            if other.kind in keys
            and not _apart(other.bore, bore)
            and not _apart(other.outside_diameter, outside)
            and not _apart(other.width, width)
        ]
        if not alike:
            return ""
        found = min(alike, key=lambda other: abs((other.dynamic_rating or 0.0) - rating))
        self._note(
            "inferred", one, "rexs_by_size", designation=found.designation, bore=bore,
            outside=outside, width=found.width or 0.0, count=len(alike),
            rated=bool(rating),
        )  # fmt: skip
        return found.designation

    def _geometry(self, one: Component, keys: Sequence[str]) -> dict[str, Any] | None:
        """The inside of a bearing as rows and elements give it; None where one is missing."""
        rows = self.model.parts(one.id, "rolling_bearing_row")
        if not rows or not keys:
            return None
        row = rows[0]
        elements = self.model.parts(row.id, "rolling_element")
        kind: BearingType = TYPES[keys[0]]
        if len(rows) > 1 and kind.rows < len(rows):
            return None
        count = self._whole(row, "number_of_rolling_elements") or len(elements)
        pitch = self._value(row, "reference_diameter_rolling_bearing")
        size = self._value(elements[0], "diameter_of_rolling_element") if elements else None
        angle = self._value(row, "pressure_angle")
        if not (count and pitch and size):
            return None
        table: dict[str, Any] = {} if kind.grooves is None else {"kind": kind.grooves}
        table["pitch_diameter"] = _text(pitch, "length")
        if kind.element == BALL:
            radii = [self._value(row, f"raceway_radius_of_{ring}_ring") for ring in
                     ("inner", "outer")]  # fmt: skip
            if not all(radii):
                return None
            table["ball_count"], table["ball_diameter"] = count, _text(size, "length")
            for ring, radius in zip(("inner", "outer"), radii, strict=True):
                table[f"{ring}_conformity"] = round((radius or 0.0) / size, 15)
        else:
            long = self._value(elements[0], "length_of_rolling_element")
            contact = self._value(row, "significant_contact_length_inner_ring") or long
            if not (long and contact):
                return None
            table |= {
                "element": kind.element, "roller_count": count,
                "roller_diameter": _text(size, "length"),
                "roller_length": _text(long, "length"),
                "effective_length": _text(contact, "length"),
            }  # fmt: skip
        if angle:
            table["contact_angle"] = _text(angle, "angle")
        elif self._value(one, "radial_bearing_clearance") is None:
            table["diametral_clearance"] = "0 mm"
            self._note("inferred", one, "rexs_no_clearance")
        return table

    def _life(self, one: Component) -> dict[str, Any]:
        life: dict[str, Any] = {}
        for key, names in (
            ("dynamic_rating", ("radial_dynamic_load_rating", "axial_dynamic_load_rating")),
            ("static_rating", ("radial_static_load_rating", "axial_static_load_rating")),
            ("fatigue_load_limit", ("fatigue_limit_load",)),
        ):
            given = [self._value(one, name) for name in names]
            _put(life, key, next((value for value in given if value), None), "force")
        clean = self._number(one, "contamination_factor_iso_281_2007")
        if clean is not None:
            life["contamination"] = clean
        survival = self._number(one, "survival_probability")
        if survival:
            life["reliability"] = survival / 100.0
        return life

    def _warmth(self, one: Component) -> dict[str, Any]:
        warm: dict[str, Any] = {}
        for key, name in (
            ("lubricant", "temperature_lubricant"),
            ("inner_ring", "mean_operating_temperature_inner_ring"),
            ("outer_ring", "mean_operating_temperature_outer_ring"),
        ):
            _put(warm, key, self._value(one, name), "temperature")
        return warm

    def _mounting(self, one: Component) -> dict[str, Any]:
        fits = {
            "shaft_tolerance": self._text(one, "shaft_tolerance_class"),
            "housing_tolerance": self._text(one, "casing_bore_tolerance_class"),
        }
        if not all(fits.values()):
            return {}
        table: dict[str, Any] = dict(fits)
        for key, name in (
            ("bore", "inner_diameter"), ("outside_diameter", "outer_diameter"),
            ("width", "width"), ("shaft_bore", "shaft_inner_diameter"),
            ("housing_outside_diameter", "casing_outer_diameter"),
        ):  # fmt: skip
            if value := self._value(one, name):
                _put(table, key, value, "length")
        return table

    # --- springs, loads, masses -------------------------------------------------------------------

    def _read_springs(self) -> Iterator[Part]:
        for one in self.model.of_type(*_SPRINGS):
            inner, outer = self._sides(one)
            ends = [None if side is None else self._shafts.get(side.id) for side in (inner, outer)]
            laid = ends[0] or ends[1]
            if laid is None:
                self._note("left", one, "rexs_no_shaft")
                continue
            numbers = [
                self._value(one, name)
                for name in ("axial_stiffness", "radial_stiffness", "bending_stiffness")
            ]
            axial, radial, bending = (number or 0.0 for number in numbers)
            if not (axial or radial or bending):
                self._note("left", one, "rexs_stiffness_unknown")
                continue
            side = "inner" if ends[0] else "outer"
            position = self._position(one, laid, f"u_coordinate_on_shaft_{side}_side")
            if position is None:
                continue
            table: dict[str, Any] = {
                "name": self._named(one, "springs"),
                "shaft": laid.name,
                "position": _text(position, "length"),
                "stiffness": [
                    *(_text(value, "stiffness") for value in (axial, radial, radial)),
                    *[_text(bending, "angular_stiffness")] * 2,
                ],
            }
            if ends[0] and ends[1]:
                there = self._position(one, ends[1], "u_coordinate_on_shaft_outer_side")
                if there is None:
                    continue
                table |= {"to_shaft": ends[1].name, "to_position": _text(there, "length")}
            yield Part("springs", one.id, table)

    def _read_loads(self) -> Iterator[Part]:
        for one in self.model.of_type("external_load"):
            laid = self._shaft_of(one)
            if laid is None:
                self._note("left", one, "rexs_no_shaft")
                continue
            position = self._position(one, laid, "u_coordinate_on_shaft")
            if position is None:
                continue
            force = self._vector(one, laid, "force_{}_direction")
            moment = self._vector(one, laid, "torque_around_{}_axis")
            speed = self._speeds[laid.component.id]
            power = self._value(one, "power")
            if power and not moment[0] and speed:
                moment = (power / speed, moment[1], moment[2])
                self._note("inferred", one, "rexs_torque_of_power")
            self._use(one, "transmits_torque")
            self._use(one, "defines_torque")
            known = "torque_around_u_axis" in one.attributes or bool(power)
            through = self._true(one, "transmits_torque")
            flows = self._powers.setdefault(laid.component.id, [])
            if not known and through:
                flows.append(math.nan)
                self._open.append((laid, one, position))
                continue
            flows.append(moment[0] * speed)
            yield Part("loads", one.id, _load(self._named(one, "loads"), laid.name, position,
                                              force, moment))  # fmt: skip

    def _vector(self, one: Component, laid: _Laid, names: str) -> Vector:
        """A vector of a part in the axes of the machine."""
        local = tuple(self._value(one, names.format(axis)) or 0.0 for axis in "uvw")
        pose = self._poses.get(one.id, laid.pose)
        if pose.u == self._frame.u and pose.w == self._frame.w:
            return local[0], local[1], local[2]
        return self._frame.local(pose.direction((local[0], local[1], local[2])))

    def _read_masses(self) -> Iterator[Part]:
        for one in self.model.of_type("additional_mass"):
            laid = self._shaft_of(one)
            mass = self._value(one, "mass_of_component")
            if laid is None or mass is None:
                self._note("left", one, "rexs_no_shaft" if laid is None else "rexs_no_mass")
                continue
            position = self._position(one, laid, "u_coordinate_on_shaft")
            if position is None:
                continue
            table: dict[str, Any] = {
                "name": self._named(one, "masses"), "shaft": laid.name,
                "position": _text(position, "length"), "mass": _text(mass, "mass"),
            }  # fmt: skip
            polar = self._value(one, "moment_of_inertia_u_axis")
            across = [
                value
                for axis in "vw"
                if (value := self._value(one, f"moment_of_inertia_{axis}_axis"))
            ]
            _put(table, "polar_inertia", polar, "inertia")
            _put(table, "transverse_inertia", max(across, default=None), "inertia")
            if polar and "transverse_inertia" not in table:
                table["transverse_inertia"] = _text(0.5 * polar, "inertia")
            eccentric = self._numbers(one, "eccentricity_vector")
            if len(eccentric) == 3 and any(eccentric[1:]):
                y, z = eccentric[1:]
                table["unbalance"] = _text(mass * math.hypot(y, z), "unbalance")
                table["unbalance_azimuth"] = _text(math.atan2(y, z), "angle")
            yield Part("masses", one.id, table)

    # --- gears ------------------------------------------------------------------------------------

    def _read_gears(self) -> Iterator[Part]:
        given: set[int] = set()
        middles: dict[int, float] = {}
        bevels: list[tuple[_Laid, Component]] = []
        for one in self.model.of_type(*GEARS):
            laid = self._shaft_of(one)
            if laid is None:
                self._note("left", one, "rexs_no_shaft")
                continue
            straight = one.type in ("cylindrical_gear", "ring_gear")
            width = (self._value(one, "face_width") or 0.0) if straight else 0.0
            middle = self._position(one, laid, "u_coordinate_on_shaft", 0.5 * width)
            if middle is None:
                continue
            force = self._vector(one, laid, "force_acting_on_shaft_{}")
            moment = self._vector(one, laid, "torque_acting_on_shaft_{}")
            if any(force) or any(moment):
                given.add(one.id)
                self._note("inferred", one, "rexs_forces_as_load")
                self._powers.setdefault(laid.component.id, []).append(
                    moment[0] * self._speeds[laid.component.id]
                )
                yield Part(
                    "loads", one.id,
                    _load(self._named(one, "loads"), laid.name, middle, force, moment),
                )  # fmt: skip
            elif one.type == "bevel_gear":
                self._powers.setdefault(laid.component.id, []).append(math.nan)
                bevels.append((laid, one))
            elif one.type == "ring_gear":
                self._note("left", one, "rexs_internal_gear")
            else:
                middles[one.id] = middle
        meshes = [
            mesh
            for mesh in self._meshes
            if not given & {gear.id for gear in mesh.gears}
            and all(gear.id in middles for gear in mesh.gears)
        ]
        powers = self._power_flow(meshes)
        done: set[int] = set(given)
        for place, mesh in enumerate(meshes):
            if (power := powers.get(place)) is None:
                continue
            for part in self._mesh(mesh, power, middles):
                done.add(part.component)
                yield part
        for number in middles.keys() - done:
            self._note("left", self.model.by_id[number], "rexs_mesh_left")
        for laid, gear in bevels:
            if (table := self._bevel_gear(laid, gear)) is None:
                self._note("left", gear, "rexs_mesh_left")
            else:
                yield Part("gears", gear.id, table)
        yield from self._balancing()

    def _bevel_gear(self, laid: _Laid, gear: Component) -> dict[str, Any] | None:
        """A bevel gear with the power that its shaft leaves it; None where something is missing.

        Its mate is on a shaft across, which no machine has: where the axes cross is the apex of
        its pitch cone, and the mesh lies toward its mate.
        """
        speed = self._speeds[laid.component.id]
        power = self._left_over.get(laid.component.id, 0.0)
        mate = self._mate(gear)
        other = None if mate is None else self.model.whole_of(mate.id, "shaft")
        if not power or not speed or mate is None or other is None or other.id not in self._poses:
            return None
        pose = self._poses[other.id]
        met = crossing(laid.pose, pose)
        if met is None:
            return None
        sides = [
            self._side(gear, laid.component, laid.pose, met[0]),
            self._side(mate, other, pose, met[1]),
        ]
        away = [(side * u[0], side * u[1], side * u[2])
                for side, u in zip(sides, (laid.pose.u, pose.u), strict=True)]  # fmt: skip
        teeth = [self._whole(one, "number_of_teeth") or 0 for one in (gear, mate)]
        cone = self._value(gear, "pitch_angle")
        if not cone and min(teeth) > 0:
            apart = math.acos(max(-1.0, min(1.0, dot(away[0], away[1]))))
            cone = math.atan2(math.sin(apart), teeth[1] / teeth[0] + math.cos(apart))
        spiral = abs(self._value(gear, "mean_spiral_angle") or 0.0)
        diameter = self._mean_diameter(gear, cone or 0.0, spiral)
        if not cone or not diameter or met[2] > _CROSSING * diameter:
            return None
        position = laid.position(met[0] + sides[0] * 0.5 * diameter / math.tan(cone))
        if not 0.0 <= position <= laid.length:
            return None
        _, y, z = self._frame.local(away[1])
        pressure = self._value(gear, "normal_pressure_angle")
        table: dict[str, Any] = {
            "name": self._named(gear, "gears"),
            "shaft": laid.name,
            "position": _text(position, "length"),
            "kind": "bevel",
            "pitch_diameter": readable(diameter, "length", 12),
            "cone_angle": readable(cone, "angle", 12),
            "apex": "-x" if dot(away[0], self._frame.u) > 0.0 else "+x",
            "pressure_angle": readable(pressure or _USUAL_PRESSURE_ANGLE, "angle", 12),
            "power": readable(abs(power), "power", 12),
            "drives": power < 0.0,
            "mesh_azimuth": readable(math.atan2(y, z), "angle", 12),
        }
        hand = self._text(gear, "spiral_angle_pitch_direction").casefold()
        if spiral:
            table |= {"helix_angle": readable(spiral, "angle", 12),
                      "hand": "left" if hand.startswith("left") else "right"}  # fmt: skip
        if not _is_valid("gears", table):
            return None
        if not pressure:
            self._note("inferred", gear, "rexs_pressure_angle")
        if spiral and not hand.startswith(("left", "right")):
            self._note("inferred", gear, "rexs_hand")
        self._note("inferred", gear, "rexs_bevel", power=abs(power), diameter=diameter, cone=cone)
        return table

    def _mate(self, gear: Component) -> Component | None:
        for relation in self.model.relations:
            numbers = [relation.in_role(role) for role in ("gear_1", "gear_2")]
            if relation.type == "stage" and gear.id in numbers:
                return self.model.by_id.get(numbers[1 - numbers.index(gear.id)] or 0)
        return None

    def _side(self, gear: Component, shaft: Component, pose: Pose, crossed: float) -> float:
        """On which side of the crossing of the axes a gear is, along u of its shaft: +1 or -1."""
        own = self._poses.get(gear.id)
        at = self._value(gear, "u_coordinate_on_shaft")
        here = pose.seen_from(own.origin)[0] if own is not None else at or 0.0
        if abs(here - crossed) < _NEAR:  # it is placed by its apex: the shaft is behind it
            lengths = [self._value(one, "length") or 0.0
                       for one in self.model.parts(shaft.id, "shaft_section")]  # fmt: skip
            here = 0.5 * math.fsum(lengths)
        return 1.0 if here > crossed else -1.0

    def _mean_diameter(self, gear: Component, cone: float, spiral: float) -> float | None:
        """Pitch diameter of a bevel gear in the middle of its face; m."""
        if mean := self._value(gear, "mean_pitch_diameter"):
            return mean
        teeth, module = (
            self._whole(gear, "number_of_teeth"),
            self._value(gear, "mean_normal_module"),
        )
        if teeth and module:
            return teeth * module / math.cos(spiral)
        outer, width = (self._value(gear, name) for name in ("outer_pitch_diameter", "face_width"))
        return outer - width * math.sin(cone) if outer and width else None

    def _power_flow(self, meshes: Sequence[_Mesh]) -> dict[int, float]:
        """Power that each mesh brings to its second gear: what comes to a shaft leaves it; W."""
        powers: dict[int, float] = {}
        waiting = True
        while waiting:
            waiting = False
            for number in self._shafts:
                flows = self._powers.get(number, [])
                total = math.fsum(power for power in flows if not math.isnan(power))
                unknown: list[tuple[int, float] | None] = [
                    None for power in flows if math.isnan(power)
                ]
                for place, mesh in enumerate(meshes):
                    for side, shaft in enumerate(mesh.shafts):
                        if shaft.component.id != number:
                            continue
                        sign = 1.0 if side else -1.0
                        if place in powers:
                            total += sign * powers[place]
                        else:
                            unknown.append((place, sign))
                if len(unknown) != 1:
                    continue
                if unknown[0] is None:
                    if number not in self._left_over:
                        self._left_over[number] = -total
                    continue
                place, sign = unknown[0]
                if self._speeds[number] and (flows or total):
                    powers[place] = -sign * total
                    waiting = True
        return {place: power for place, power in powers.items() if power}

    def _balancing(self) -> Iterator[Part]:
        """The torques that external loads take or bring, where the gears give them."""
        for laid, one, position in self._open:
            speed = self._speeds[laid.component.id]
            power = self._left_over.get(laid.component.id, 0.0)
            force = self._vector(one, laid, "force_{}_direction")
            moment = self._vector(one, laid, "torque_around_{}_axis")
            if power and speed:
                moment = (power / speed, moment[1], moment[2])
                self._note("inferred", one, "rexs_balance", torque=moment[0])
            yield Part("loads", one.id, _load(self._named(one, "loads"), laid.name, position,
                                              force, moment))  # fmt: skip

    def _mesh(self, mesh: _Mesh, power: float, middles: Mapping[int, float]) -> Iterator[Part]:
        """Two gears in mesh: the driving one with the power, the other with its mate."""
        teeth = [self._whole(gear, "number_of_teeth") for gear in mesh.gears]
        modules = [self._value(gear, "normal_module") for gear in mesh.gears]
        helices = [
            self._value(gear, "helix_angle_reference_diameter") or 0.0 for gear in mesh.gears
        ]
        module = modules[0] or modules[1]
        axes = [shaft.pose.origin for shaft in mesh.shafts]
        _, *across = self._frame.local(
            (axes[1][0] - axes[0][0], axes[1][1] - axes[0][1], axes[1][2] - axes[0][2])
        )
        distance = math.hypot(*across)
        if None in teeth or not module or distance < _NEAR:
            return
        if min(count or 0 for count in teeth) < 0:
            for gear in mesh.gears:
                self._note("left", gear, "rexs_internal_gear")
            return
        total = sum(count or 0 for count in teeth)
        helix = abs(helices[0] or helices[1])
        at = operating_mesh(
            self._value(mesh.stage, "center_distance") or distance, total, module,
            self._pressure_angle(mesh), helix,
        )  # fmt: skip
        if abs(at.module - module) > _ALIKE * module:
            self._note(
                "inferred", mesh.gears[0], "rexs_operating_mesh",
                distance=self._value(mesh.stage, "center_distance") or distance,
                pressure=at.pressure_angle, helix=at.helix_angle,
            )  # fmt: skip
        else:
            at = at._replace(
                module=module, pressure_angle=self._pressure_angle(mesh), helix_angle=helix
            )
        driver = 0 if power > 0.0 else 1
        if helix:
            self._note("inferred", mesh.gears[driver], "rexs_hand")
        self._note(
            "inferred", mesh.gears[driver], "rexs_power_flow", power=abs(power),
            gear=mesh.gears[driver].name, mate=mesh.gears[1 - driver].name,
        )  # fmt: skip
        names = [self._named(gear, "gears") for gear in mesh.gears]
        for side in (driver, 1 - driver):
            gear = mesh.gears[side]
            table: dict[str, Any] = {
                "name": names[side],
                "shaft": mesh.shafts[side].name,
                "position": _text(middles[gear.id], "length"),
                "teeth": teeth[side],
                "module": readable(at.module, "length", 12),
                "pressure_angle": readable(at.pressure_angle, "angle", 12),
            }
            _put(table, "face_width", self._value(gear, "face_width"), "length")
            if at.helix_angle:
                left = (helices[side] or -helices[1 - side]) < 0.0
                table |= {"kind": "helical", "helix_angle": readable(at.helix_angle, "angle", 12),
                          "hand": "left" if left else "right"}  # fmt: skip
            if side == driver:
                toward = 1.0 if side == 0 else -1.0
                azimuth = math.atan2(toward * across[0], toward * across[1])
                table |= {"power": readable(abs(power), "power", 12), "drives": True,
                          "mesh_azimuth": readable(azimuth, "angle", 12)}  # fmt: skip
            else:
                table["mate"] = names[driver]
            yield Part("gears", gear.id, table)

    def _pressure_angle(self, mesh: _Mesh) -> float:
        for gear in mesh.gears:
            for relation in self.model.relations_of(gear.id, "gear", "flank"):
                for ref in relation.refs:
                    flank = self.model.by_id.get(ref.id)
                    if flank is not None and flank.type == "flank_geometry":
                        angle = self._value(flank, "normal_pressure_angle")
                        if angle:
                            return angle
        self._note("inferred", mesh.gears[0], "rexs_pressure_angle")
        return _USUAL_PRESSURE_ANGLE

    # --- what Rolamento wrote ---------------------------------------------------------------------

    def restored(self, parts: Iterable[Part]) -> Iterator[Part]:
        """Put back what REXS had no word for, where the rest is still as it was written."""
        read: dict[int, list[Part]] = {}
        for part in parts:
            read.setdefault(part.component, []).append(part)
        digests = [one.attributes[DIGEST].text for one in self.model.of_type("gear_unit")
                   if DIGEST in one.attributes]  # fmt: skip
        self._untouched = bool(digests) and digests[0] == self.whole.digest(CUSTOM)
        for component in self.model.components:
            own = read.pop(component.id, [])
            attribute = component.attributes.get(CUSTOM)
            if attribute is None:
                yield from own
                continue
            self._use(component, CUSTOM)
            count = len(self.remarks)
            yield from self._mended(component, own, attribute.text)
            if len(self.remarks) == count:  # nothing was changed: what was inferred does not count
                also = (
                    {oil.id for oil in self.model.of_type("lubricant")}
                    if component.type == "gear_unit"
                    else set()
                )
                self.remarks = [
                    one for one in self.remarks if one.component not in {component.id, *also}
                ]
        for left in read.values():
            yield from left

    def _mended(self, component: Component, own: list[Part], text: str) -> Iterator[Part]:
        try:
            entries = json.loads(text)
            changes = [
                (str(kind), {str(k): (was, now) for k, (was, now) in keys.items()})
                for kind, keys in entries
            ]
        except (ValueError, TypeError, AttributeError, RecursionError):
            raise placed(
                FileError(said("is not what Rolamento writes there")), component, CUSTOM
            ) from None
        for place, (kind, keys) in enumerate(changes):
            part = own[place] if place < len(own) else None
            table = {} if part is None else dict(part.table)
            plain = _as_json(table)
            stale = [
                key
                for key, (was, _) in keys.items()
                if plain.get(key) != was and not self._untouched
            ]
            other_kind = part is None or part.kind != kind
            if stale:
                self._note("left", component, "rexs_changed", keys=", ".join(stale))
                if other_kind and part is not None:
                    yield part
                    continue
                if other_kind:
                    continue
            for key, (_, now) in keys.items():
                if key in stale:
                    continue
                if now is None:
                    table.pop(key, None)
                else:
                    table[key] = now
            if stale and part is not None and not _is_valid(kind, table):
                table = part.table  # what is left of the keys does not go with what was changed
            if table or kind == "machine":
                yield Part(kind, component.id, table)
        yield from own[len(changes) :]


# --- small parts ----------------------------------------------------------------------------------


def _is_valid(kind: str, table: Mapping[str, Any]) -> bool:
    """Whether a table describes a part; of what stands above the parts the machine says."""
    record = _RECORDS.get(kind)
    try:
        part = None if record is None else record.from_mapping(table)
        if isinstance(part, MachineBearing):
            part.case  # noqa: B018  # which is refused if it is none
    except InputError:
        return False
    return True


def _is_result(name: str) -> bool:
    """Whether an attribute holds what a program calculated."""
    results = words()["results"]
    return name.startswith(tuple(results["begin"])) and name not in results["inputs"]


def _as_json(table: Mapping[str, Any]) -> dict[str, Any]:
    """A table as it comes back from JSON: lists instead of tuples."""
    found: dict[str, Any] = json.loads(json.dumps(table))
    return found


def _text(value: float, dimension: Dimension) -> str:
    """A quantity as a machine file has it, without what rounding left behind the twelfth digit."""
    short = readable(value, dimension, 12)
    return (
        short
        if abs(to_si(short, dimension) - value) <= _NOISE * abs(value)
        else from_si(value, dimension)
    )


def _put(table: dict[str, Any], key: str, value: float | None, dimension: Dimension) -> None:
    if value is not None:
        table[key] = _text(value, dimension)


def _section(section: Sequence[float], flipped: bool) -> dict[str, str]:
    _, length, begin, end, bore, end_bore = section
    if flipped:
        begin, end, bore, end_bore = end, begin, end_bore, bore
    table = {"length": _text(length, "length"), "diameter": _text(begin, "length")}
    if bore:
        table["bore"] = _text(bore, "length")
    if end != begin:
        table["end_diameter"] = _text(end, "length")
    if end_bore != bore:
        table["end_bore"] = _text(end_bore, "length")
    return table


def _load(name: str, shaft: str, position: float, force: Vector, moment: Vector) -> dict[str, Any]:
    table: dict[str, Any] = {"name": name, "shaft": shaft, "position": _text(position, "length")}
    for key, value in zip(("fx", "fy", "fz"), force, strict=True):
        if value:
            table[key] = _text(value, "force")
    for key, value in zip(("mx", "my", "mz"), moment, strict=True):
        if value:
            table[key] = _text(value, "moment")
    return table


def _of_catalogue(designation: str) -> CatalogueBearing | None:
    if not designation or len(designation) > 60:
        return None
    try:
        return catalogue().find(designation).bearing
    except InputError:
        return None


def _apart(one: float | None, other: float | None) -> bool:
    """Whether two sizes are known and differ."""
    return one is not None and other is not None and abs(one - other) > _SIZE


def _duty(
    base: RexsModel, components: Iterable[Component]
) -> tuple[dict[tuple[int, str], float], dict[tuple[int, str], float]]:
    """Speeds and loads of a load case, by component and attribute."""
    found: tuple[dict[tuple[int, str], float], dict[tuple[int, str], float]] = ({}, {})
    for one in components:
        full = base.by_id.get(one.id)
        if full is None or full.type not in ("shaft", "external_load", "cylindrical_gear"):
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
        if abs(value - factor * first.get(key, 0.0)) > _ALIKE * max(greatest, abs(value)):
            return None
    return float(f"{factor:.12g}")
