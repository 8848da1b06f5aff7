"""A machine, and what was found of it, as a REXS 2.0 model.

What REXS has no word for stands as JSON in the attribute ``custom_rolamento`` of its component:
for each key of the machine file what any reader finds, and what it is. It counts as long as that
is still what stands there.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping
from datetime import datetime
from typing import TYPE_CHECKING, Any, Final

import numpy as np

import rolamento
from rolamento.case.machine import Gear, Machine, MachineBearing, Shaft
from rolamento.case.machine_loads import Six
from rolamento.case.quantity import AT_THE_BORDER
from rolamento.case.record import Record
from rolamento.errors import InputError
from rolamento.exchange.rexs.model import (
    Attribute,
    Component,
    LoadCase,
    Ref,
    Relation,
    RexsModel,
)
from rolamento.exchange.rexs.reading import (
    APPLICATION,
    CUSTOM,
    DIGEST,
    Part,
    machine_of_rexs,
    parts_of,
)
from rolamento.exchange.rexs.values import attribute_of, plain_number, words
from rolamento.oil.state import oil_density, oil_state
from rolamento.records import frozen
from rolamento.types import BALL
from rolamento.units import HOUR, ZERO_CELSIUS
from rolamento.words import Note

if TYPE_CHECKING:
    from rolamento.analysis.machine import MachineAnalysis
    from rolamento.case.lubricant import Lubricant
    from rolamento.solved.machine import SeatedBearing

__all__ = ["Exported", "rexs_of_machine"]

_AXES: Final = "uvw"
_CYLINDRICAL: Final = ("spur", "helical")
_SEEN: Final = frozenset({
    "name", "shaft", "position", "designation", "bearing", "kind", "teeth", "module", "face_width",
    "helix_angle", "hand", "pitch_diameter", "torque", "power", "drives", "mesh_azimuth", "mate",
    "pressure_angle", "ratio", "of", "speed", "units", "temperature", "diameter", "bore", "width",
    "title", "gravity", "spectrum", "lubricant", "unbalance", "unbalance_azimuth", "material",
})  # fmt: skip
"""Keys whose meaning stands in attributes of REXS too, though not word for word."""
_MOST_CONTACTS: Final = 4000
"""Contacts of rolling elements, in all steps, that are written one by one."""
_DENSITY_AT: Final = 15.0 + ZERO_CELSIUS
_MOST_STEPS: Final = 100
"""Steps whose results are written."""
_LIVES: Final = {
    "iso281": "nominal_rating_life_{}_iso_281_2007",
    "iso281_modified": "modified_rating_life_{}_iso_281_2007",
    "iso16281": "nominal_reference_rating_life_{}_iso_16281_2008",
    "iso16281_modified": "modified_reference_rating_life_{}_iso_16281_2008",
}
"""Attributes of lives by our theories."""
_FREQUENCIES: Final = {
    "ball_pass_inner": "overrolling_frequency_inner_ring",
    "ball_pass_outer": "overrolling_frequency_outer_ring",
    "ball_spin_twice": "overrolling_frequency_rolling_element",
}
_STIFFNESS: Final = (
    ("f_u", "f_v", "f_w", "m_v", "m_w"), ("d_u", "d_v", "d_w", "rot_v", "rot_w"),
)  # fmt: skip
_STIFFNESS_UNITS: Final = {
    ("f", "d"): ("N / m", 1.0), ("f", "rot"): ("N / rad", 1.0), ("m", "d"): ("N", 1.0),
    ("m", "rot"): ("N mm / rad", 1e3),
}  # fmt: skip
"""Force or moment over shift or tilt: the unit that REXS gives it, and how many of it SI has."""


@frozen(eq=False)
class Exported:
    """A REXS model of a machine.

    Attributes
    ----------
    model
        to be written
    notes
        what other programs do not see, or see otherwise
    """

    model: RexsModel
    notes: tuple[Note, ...]


def rexs_of_machine(found: Machine | MachineAnalysis, *, date: str = "") -> Exported:
    """Return a machine as a REXS 2.0 model, with its results if it was solved.

    Parameters
    ----------
    found
        A `Machine`, or what `rolamento.analyse_machine` returned.
    date
        Of the file, by ISO 8601; now if not given.
    """
    machine = found if isinstance(found, Machine) else found.solved.machine
    writer = _Writer(machine, None if isinstance(found, Machine) else found)
    return writer.exported(date or datetime.now().astimezone().isoformat(timespec="seconds"))


class _Draft:
    """A component that is being written."""

    def __init__(self, number: int, kind: str, name: str) -> None:
        self.id, self.type, self.name = number, kind, name
        self.attributes: dict[str, Attribute] = {}

    def put(self, **values: Any) -> None:
        """Take attributes in SI; None is left out."""
        for name, value in values.items():
            if value is not None and value != "" and not _is_nan(value):
                self.attributes[name] = attribute_of(name, value)

    def word(self, name: str, value: str) -> None:
        self.attributes[name] = Attribute(name, value, "none", "enum")

    @property
    def component(self) -> Component:
        return Component(self.id, self.type, self.name, dict(self.attributes))


def _is_nan(value: Any) -> bool:
    return isinstance(value, float) and not math.isfinite(value)


class _Writer:
    """Writes a machine once."""

    def __init__(self, machine: Machine, found: MachineAnalysis | None) -> None:
        self._machine = machine
        self._found = found
        self._drafts: list[_Draft] = []
        self._relations: list[Relation] = []
        self._own: list[Part] = []
        self._notes: list[Note] = []
        self._oils: dict[Lubricant, _Draft] = {}
        self._materials: dict[Any, _Draft] = {}
        self._loads: dict[str, _Draft] = {}
        self._bearings: dict[str, _Draft] = {}
        self._elements: dict[str, list[_Draft]] = {}
        self._contacts: dict[tuple[int, str], _Draft] = {}
        self._unit = self._add("gear_unit", machine.title)
        self._casing = self._add("gear_casing", "")
        self._relate("assembly", assembly=self._unit, part=self._casing)
        self._shafts: dict[str, _Draft] = {}

    def _add(self, kind: str, name: str) -> _Draft:
        draft = _Draft(len(self._drafts) + 1, kind, _in_xml(name))
        self._drafts.append(draft)
        return draft

    def _relate(self, relation: str, order: int | None = None, **roles: _Draft) -> None:
        refs = tuple(Ref(draft.id, role) for role, draft in roles.items())
        self._relations.append(Relation(len(self._relations) + 1, relation, refs, order))

    def _place(self, draft: _Draft, reference: _Draft, *support: float) -> None:
        draft.put(support_vector=support)
        for name, axis in (("u_axis_vector", ("1.0", "0.0", "0.0")),
                           ("w_axis_vector", ("0.0", "0.0", "1.0"))):  # fmt: skip
            draft.attributes[name] = Attribute(name, axis, "mm", "floating_point_array")
        name = "reference_component_for_position"
        draft.attributes[name] = Attribute(name, str(reference.id), "none", "reference_component")

    def _owns(self, kind: str, draft: _Draft, part: Record) -> None:
        self._own.append(Part(kind, draft.id, _own_table(part)))

    # --- the whole --------------------------------------------------------------------------------

    def exported(self, date: str) -> Exported:
        machine = self._machine
        self._write_unit()
        places = _places_of_shafts(machine)
        for shaft in machine.shafts:
            self._write_shaft(shaft, places[shaft.name])
        housings = {one.name: self._write_housing(one) for one in machine.housings}
        for bearing in machine.bearings:
            housing = machine.housing_of(bearing.name)
            self._write_bearing(bearing, housings[housing.name] if housing else self._casing)
        for index, spring in enumerate(machine.springs):
            self._write_spring(spring, index)
        for index, load in enumerate(machine.loads):
            self._write_load(f"loads.{index}", load.name, load)
        for index, belt in enumerate(machine.belts):
            self._write_load(f"belts.{index}", belt.name, belt)
        gears = {}
        for index, gear in enumerate(machine.gears):
            if gear.kind in _CYLINDRICAL:
                gears[gear.name] = self._write_gear(f"gears.{index}", gear)
            else:
                self._write_load(f"gears.{index}", gear.name, gear)
        for gear in machine.gears:
            if gear.mate is not None and gear.follows_mate and gear.mate in gears:
                self._write_stage(machine.gear(gear.mate), gear, gears)
        for mass in machine.masses:
            self._write_mass(mass)
        cases, accumulation = self._write_duty()
        model = RexsModel(
            words()["version"], APPLICATION, rolamento.__version__, date,
            tuple(draft.component for draft in self._drafts), tuple(self._relations), cases,
            accumulation,
        )  # fmt: skip
        return self._completed(model)

    def _completed(self, model: RexsModel) -> Exported:
        """The model with what REXS cannot say, checked by reading it."""
        read: dict[int, list[Part]] = {}
        for part in parts_of(model):
            read.setdefault(part.component, []).append(part)
        changes: dict[int, list[Any]] = {}
        for part in self._own:
            there = read.get(part.component, [])
            place = len(changes.setdefault(part.component, []))
            old = there[place] if place < len(there) else None
            keys = _changes(old, part)
            changes[part.component].append([part.kind, keys])
        customs = {
            number: Attribute(CUSTOM, json.dumps(entries), "none", "string")
            for number, entries in changes.items()
            if any(keys for _, keys in entries)
            or [kind for kind, _ in entries] != [part.kind for part in read.get(number, [])]
        }
        digest = Attribute(DIGEST, model.digest(CUSTOM), "none", "string")
        own = {number: {CUSTOM: custom} for number, custom in customs.items()}
        own.setdefault(self._unit.id, {})[DIGEST] = digest
        components = tuple(
            Component(one.id, one.type, one.name, {**one.attributes, **own[one.id]})
            if one.id in own
            else one
            for one in model.components
        )
        whole = RexsModel(
            model.version, model.application, model.application_version, model.date, components,
            model.relations, model.load_cases, model.accumulation,
        )  # fmt: skip
        for number, entries in changes.items():
            for kind, keys in entries:
                if keys:
                    self._note_kept(model.by_id[number], kind, keys)
        try:
            same = machine_of_rexs(whole).machine == self._machine
        except InputError as error:
            self._notes.append(Note("rexs_not_the_same", {"reason": str(error)}))
        else:
            if not same:
                self._notes.append(Note("rexs_not_the_same", {"reason": ""}))
        return Exported(whole, tuple(self._notes))

    def _note_kept(self, component: Component, kind: str, keys: Mapping[str, Any]) -> None:
        lost = [key for key, (_, now) in keys.items() if now is not None and key not in _SEEN]
        if lost:
            part = kind if kind == "machine" else f"{kind}: {component.name}".strip(": ")
            values = {"part": part, "keys": ", ".join(lost)}
            self._notes.append(Note("rexs_kept_by_custom", values))

    def _write_unit(self) -> None:
        machine, unit = self._machine, self._unit
        self._place(unit, unit, 0.0, 0.0, 0.0)
        unit.put(model_name=machine.title)
        if machine.gravity is not None:
            vector, size = machine.gravity.vector, machine.gravity.acceleration
            unit.put(account_for_gravity=True, gravitational_acceleration=size)
            for axis, part in zip(_AXES, vector, strict=True):
                unit.put(**{f"direction_vector_gravity_{axis}": part / size if size else 0.0})
        warm = machine.temperature
        if warm is not None:
            self._casing.put(
                temperature_lubricant=warm.lubricant, mean_operating_temperature=warm.housing
            )
        if machine.lubricant is not None:
            oil = self._oil(machine.lubricant)
            self._relate("reference", origin=self._casing, referenced=oil)
        table = {
            name: value
            for name, value in machine.to_mapping().items()
            if name
            in ("title", "gravity", "spectrum", "model", "lubricant", "surface", "temperature",
                "film", "life")
        }  # fmt: skip
        if "spectrum" in table:
            table["spectrum"] = [_own_table(step) for step in machine.spectrum]
        self._own.append(Part("machine", unit.id, table))

    def _oil(self, lubricant: Lubricant) -> _Draft:
        if lubricant in self._oils:
            return self._oils[lubricant]
        draft = self._oils[lubricant] = self._add("lubricant", lubricant.name)
        draft.put(name=lubricant.name)
        if lubricant.kind not in ("oil", "grease"):
            return draft
        draft.word("kind", lubricant.kind)
        warm = oil_state(lubricant, np.array([40.0, 100.0]) + ZERO_CELSIUS)
        for name, given, found in (
            ("viscosity_at_40_degree_celsius", lubricant.viscosity_40, warm.kinematic_viscosity[0]),
            ("viscosity_at_100_degree_celsius", lubricant.viscosity_100,
             warm.kinematic_viscosity[1]),
        ):  # fmt: skip
            draft.put(**{name: float(f"{float(found):.12g}") if given is None else given})
        cool = float(oil_density(lubricant, _DENSITY_AT))
        as_given = lubricant.density_temperature == _DENSITY_AT
        draft.put(
            density_at_15_degree_celsius=lubricant.density if as_given else float(f"{cool:.12g}"),
            thermal_conductivity=lubricant.thermal_conductivity,
        )
        return draft

    # --- shafts -----------------------------------------------------------------------------------

    def _write_shaft(self, shaft: Shaft, place: tuple[float, float]) -> None:
        draft = self._shafts[shaft.name] = self._add("shaft", shaft.name)
        self._relate("assembly", assembly=self._unit, part=draft)
        self._place(draft, self._unit, shaft.position, *place)
        draft.put(defines_speed=shaft.ratio is None)
        if not self._machine.spectrum:
            draft.put(rotational_speed=self._machine.speed(shaft.name))
        warm = self._machine.temperature
        if warm is not None:
            draft.put(mean_operating_temperature=warm.shaft)
        for section, left in zip(shaft.sections, shaft.edges, strict=False):
            own = self._add("shaft_section", "")
            self._relate("assembly", assembly=draft, part=own)
            own.put(
                u_coordinate_on_shaft=left,
                length=section.length,
                outer_diameter_begin=section.diameter,
                outer_diameter_end=section.right_diameter,
                inner_diameter_begin=section.bore,
                inner_diameter_end=section.right_bore,
            )
        material = shaft.material
        if material not in self._materials:
            own = self._materials[material] = self._add("material", material.name)
            own.put(
                material_designation=material.name,
                elastic_modulus=material.youngs_modulus,
                poisson_ratio=material.poisson_ratio,
                density=material.density,
            )
        self._relate("reference", origin=draft, referenced=self._materials[material])
        self._owns("shafts", draft, shaft)

    def _write_housing(self, housing: Any) -> _Draft:
        draft = self._add("gear_casing", housing.name)
        self._relate("assembly", assembly=self._unit, part=draft)
        self._owns("housings", draft, housing)
        return draft

    # --- bearings ---------------------------------------------------------------------------------

    def _write_bearing(self, bearing: MachineBearing, casing: _Draft) -> None:
        case = bearing.case
        inside, published = case.bearing, case.bearing.published
        draft = self._add("rolling_bearing_with_detailed_geometry", bearing.name)
        self._bearings[bearing.name] = draft
        shaft, outer = self._shafts[bearing.shaft], bearing.outer_shaft
        around = casing if outer is None else self._shafts[outer]
        self._relate("side", assembly=draft, inner_part=shaft, outer_part=around)
        self._relate("assembly", assembly=self._unit, part=draft)
        self._place(draft, shaft, bearing.position, 0.0, 0.0)
        mounting, life, warm = case.mounting, case.life, case.temperature
        draft.put(
            u_coordinate_on_shaft_inner_side=bearing.position,
            u_coordinate_on_shaft_outer_side=bearing.position
            if outer is None
            else self._machine.outer_position(bearing.name),
            catalogue_designation=inside.designation,
            inner_diameter=_first(mounting and mounting.bore, published and published.bore),
            outer_diameter=_first(
                mounting and mounting.outside_diameter, published and published.outside_diameter
            ),
            width=published and published.width,
            manufacturer=published and published.maker,
            number_of_bearing_rows=len(inside.element_rows),
            radial_bearing_clearance=inside.diametral_clearance,
            preload_force=bearing.preload,
            preload_distance=bearing.offset,
        )
        axial = inside.bearing_type.washers
        kind = "axial" if axial else "radial"
        draft.put(**{
            f"{kind}_dynamic_load_rating": _first(
                life and life.dynamic_rating, published and published.dynamic_rating
            ),
            f"{kind}_static_load_rating": _first(
                life and life.static_rating, published and published.static_rating
            ),
            "fatigue_limit_load": _first(
                life and life.fatigue_load_limit, published and published.fatigue_load_limit
            ),
            "contamination_factor_iso_281_2007": life and life.contamination,
        })  # fmt: skip
        if warm is not None:
            draft.put(
                temperature_lubricant=warm.lubricant,
                mean_operating_temperature_inner_ring=warm.inner_ring,
                mean_operating_temperature_outer_ring=warm.outer_ring,
            )
        if mounting is not None and mounting.shaft_tolerance and mounting.housing_tolerance:
            draft.word("shaft_tolerance_class", mounting.shaft_tolerance)
            draft.word("casing_bore_tolerance_class", mounting.housing_tolerance)
        self._write_type(bearing, draft)
        if case.lubricant is not None:
            self._relate("reference", origin=draft, referenced=self._oil(case.lubricant))
        self._write_rows(bearing, draft)
        self._owns("bearings", draft, bearing)

    def _write_type(self, bearing: MachineBearing, draft: _Draft) -> None:
        inside = bearing.case.bearing
        kind = inside.listed_type
        names = words()["bearing_types"]
        word = next(
            (name for place in range(3) for name, keys in names.items()
             if kind.key in keys[place : place + 1]),
            None,
        )  # fmt: skip
        if word is None:
            values = {"part": bearing.name, "type": kind.name}
            self._notes.append(Note("rexs_without_type", values))
        else:
            draft.word("bearing_type", word)
        way = bearing.located
        if way == "both" and not inside.is_set and inside.carries_one_way:
            way = "-x" if bearing.turned else "+x"
        absorbed = {"both": "both_directions", "floating": "no_direction", "+x": "positive",
                    "-x": "negative"}[way]  # fmt: skip
        if inside.bearing_type.floats and not inside.locates and _ribless(inside):
            absorbed = "no_direction"
        draft.word("axial_force_absorption", absorbed)

    def _write_rows(self, bearing: MachineBearing, draft: _Draft) -> None:
        """Rows, and each of their elements."""
        elements = self._elements[bearing.name] = []
        for order, place in enumerate(bearing.case.bearing.element_rows, start=1):
            row = place.bearing
            own = self._add("rolling_bearing_row", "")
            self._relate("ordered_assembly", order, assembly=draft, part=own)
            own.put(
                number_of_rolling_elements=row.element_count,
                reference_diameter_rolling_bearing=row.pitch_diameter,
                pressure_angle=row.contact_angle or 0.0,
            )
            if row.element == BALL:
                own.put(
                    raceway_radius_of_inner_ring=row.inner_conformity * row.element_diameter,
                    raceway_radius_of_outer_ring=row.outer_conformity * row.element_diameter,
                )
            else:
                own.put(
                    significant_contact_length_inner_ring=row.effective_length,
                    significant_contact_length_outer_ring=row.effective_length,
                    raceway_radius_of_inner_ring=row.inner_raceway_radius,
                    raceway_radius_of_outer_ring=row.outer_raceway_radius,
                )
            for number in range(1, row.element_count + 1):
                element = self._add("rolling_element", "")
                self._relate("ordered_assembly", number, assembly=own, part=element)
                element.put(diameter_of_rolling_element=row.element_diameter)
                if row.element != BALL:
                    element.put(
                        length_of_rolling_element=row.roller_length,
                        roller_crowning_radius=row.roller_profile_radius,
                    )
                elements.append(element)

    # --- what acts --------------------------------------------------------------------------------

    def _write_spring(self, spring: Any, index: int) -> None:
        draft = self._add("coupling", spring.name)
        shaft = self._shafts[spring.shaft]
        other = self._casing if spring.to_shaft is None else self._shafts[spring.to_shaft]
        self._relate("side", assembly=draft, inner_part=shaft, outer_part=other)
        self._place(draft, shaft, spring.position, 0.0, 0.0)
        stiffness = spring.stiffness_matrix
        draft.put(
            u_coordinate_on_shaft_inner_side=spring.position,
            u_coordinate_on_shaft_outer_side=spring.to_position,
            axial_stiffness=float(stiffness[0, 0]),
            radial_stiffness=float(stiffness[2, 2]),
            bending_stiffness=float(stiffness[3, 3]),
        )
        self._owns("springs", draft, spring)

    def _write_load(self, source: str, name: str, part: Any) -> None:
        draft = self._loads[source] = self._add("external_load", name)
        self._relate("assembly", assembly=self._shafts[part.shaft], part=draft)
        draft.put(u_coordinate_on_shaft=part.position, transmits_torque=True)
        kind = source.partition(".")[0]
        if kind != "loads":
            values = {"part": f"{kind}: {name}".strip(": ")}
            self._notes.append(Note("rexs_as_loads", values))
        self._owns(kind, draft, part)

    def _write_gear(self, source: str, gear: Gear) -> _Draft:
        draft = self._loads[source] = self._add("cylindrical_gear", gear.name)
        shaft = self._shafts[gear.shaft]
        self._relate("assembly", assembly=shaft, part=draft)
        self._place(draft, shaft, gear.position, 0.0, 0.0)
        width = gear.face_width or 0.0
        sign = 1.0 if gear.hand == "right" else -1.0
        draft.put(
            u_coordinate_on_shaft=gear.position - 0.5 * width,
            face_width=gear.face_width,
            number_of_teeth=gear.teeth,
            normal_module=gear.module,
            reference_diameter_cylindrical_gear=gear.diameter,
            helix_angle_reference_diameter=sign * gear.helix_angle,
        )
        left, right = self._add("flank_geometry", ""), self._add("flank_geometry", "")
        for flank in (left, right):
            flank.put(normal_pressure_angle=gear.pressure_angle)
        self._relate("flank", gear=draft, left=left, right=right)
        self._owns("gears", draft, gear)
        return draft

    def _write_stage(self, giver: Gear, taker: Gear, gears: Mapping[str, _Draft]) -> None:
        stage = self._add("cylindrical_stage", "")
        self._relate("assembly", assembly=self._unit, part=stage)
        stage.put(center_distance=0.5 * (giver.diameter + taker.diameter))
        self._relate("stage", stage=stage, gear_1=gears[giver.name], gear_2=gears[taker.name])

    def _write_mass(self, mass: Any) -> None:
        draft = self._add("additional_mass", mass.name)
        shaft = self._shafts[mass.shaft]
        self._relate("assembly", assembly=shaft, part=draft)
        self._place(draft, shaft, mass.position, 0.0, 0.0)
        own = mass.inertia
        draft.put(
            u_coordinate_on_shaft=mass.position,
            mass_of_component=own.mass,
            moment_of_inertia_u_axis=own.polar,
            moment_of_inertia_v_axis=own.transverse,
            moment_of_inertia_w_axis=own.transverse,
        )
        if mass.unbalance and own.mass:
            arm, angle = mass.unbalance / own.mass, mass.unbalance_azimuth
            draft.put(eccentricity_vector=[0.0, arm * math.sin(angle), arm * math.cos(angle)])
        self._owns("masses", draft, mass)

    # --- speeds, loads and results ----------------------------------------------------------------

    def _write_duty(self) -> tuple[tuple[LoadCase, ...], tuple[Component, ...]]:
        """Put speeds, loads and results of one load where they are, of a spectrum in load cases."""
        machine = self._machine
        if not machine.spectrum:
            for source, force in self._forces(None):
                self._put_force(self._loads[source], force)
            if self._found is not None:
                results = self._results(0, None)
                if results is not None:
                    self._put_lives(self._bearings, accumulated=False)
            return (), ()
        cases = []
        for number, step in enumerate(machine.spectrum, start=1):
            own: dict[int, _Draft] = {}
            _of(own, self._unit).put(operating_time_fraction=100.0 * step.share)
            for shaft in machine.shafts:
                speed = machine.speed(shaft.name, step.speed_factor)
                _of(own, self._shafts[shaft.name]).put(rotational_speed=speed)
            for source, force in self._forces(step):
                self._put_force(_of(own, self._loads[source]), force)
            if self._found is not None and number <= _MOST_STEPS:
                self._results(number - 1, own)
            cases.append(LoadCase(number, tuple(draft.component for draft in own.values())))
        total: dict[int, _Draft] = {}
        if self._found is not None:
            copies = {name: _of(total, draft) for name, draft in self._bearings.items()}
            self._put_lives(copies, accumulated=True)
        return tuple(cases), tuple(draft.component for draft in total.values() if draft.attributes)

    def _forces(self, step: Any) -> Iterator[tuple[str, Six]]:
        for one in self._machine.forces(step):
            yield one.source, one.force

    def _put_force(self, draft: _Draft, force: Six) -> None:
        names = (
            ("force_{}_direction", "torque_around_{}_axis")
            if draft.type == "external_load"
            else ("force_acting_on_shaft_{}", "torque_acting_on_shaft_{}")
        )
        for axis, part, moment in zip(_AXES, force[:3], force[3:], strict=True):
            draft.put(**{names[0].format(axis): part, names[1].format(axis): moment})

    def _results(self, case: int, drafts: dict[int, _Draft] | None) -> bool | None:
        """Put what was found in a step; None where it has no result."""
        found = self._found
        assert found is not None
        solved = found.solved
        if not solved.status.converged[case]:
            advice = solved.advice[case]
            reason = str(advice) if advice is not None else str(solved.status.code[case])
            self._notes.append(Note("rexs_unsolved", {"reason": reason}))
            return None
        lines: dict[tuple[str, str], float] = {
            (line.part, line.line): line.frequency for line in found.frequencies(case)
        }
        for name, shaft in solved.shafts.items():
            draft = _of(drafts, self._shafts[name])
            draft.put(u_coordinates_of_beam_nodes=shaft.position.tolist())
            for place, axis in enumerate(_AXES):
                values = shaft.displacement[case, :, place].tolist()
                draft.put(**{f"displacement_{axis}_of_nodes": values})
        for name, seated in solved.bearings.items():
            draft = _of(drafts, self._bearings[name])
            self._put_bearing(draft, name, seated, case)
            for line, attribute in _FREQUENCIES.items():
                frequency = lines.get((name, line))
                if frequency is not None and math.isfinite(frequency):
                    text = plain_number(float(f"{frequency:.15g}"))
                    draft.attributes[attribute] = Attribute(attribute, text, "Hz",
                                                            "floating_point")  # fmt: skip
            cage = lines.get((name, "cage"))
            if cage is not None:
                draft.put(speed_rolling_element_set=2.0 * math.pi * float(cage))
        contacts = 2 * len(solved) * sum(map(len, self._elements.values()))
        if contacts <= _MOST_CONTACTS:
            for name, seated in solved.bearings.items():
                self._put_contacts(drafts, name, seated, case)
        return True

    def _put_bearing(self, draft: _Draft, name: str, seated: SeatedBearing, case: int) -> None:
        assert self._found is not None
        own, solved = self._found.bearings[name], seated.solved
        inner, outer, force = (
            getattr(seated, part)[case].tolist() for part in ("inner", "outer", "force")
        )
        machine = self._machine
        step = machine.spectrum[case] if machine.spectrum else None
        factor = 1.0 if step is None else step.speed_factor
        draft.put(speed_inner_ring=machine.speed(seated.bearing.shaft, factor))
        if seated.bearing.outer_shaft is not None:
            draft.put(speed_outer_ring=machine.speed(seated.bearing.outer_shaft, factor))
        for place, axis in enumerate(_AXES):
            draft.put(**{
                f"force_acting_on_inner_component_{axis}": 0.0 - force[place],
                f"force_acting_on_outer_component_{axis}": force[place],
                f"displacement_inner_side_{axis}": inner[place],
                f"displacement_outer_side_{axis}": outer[place],
            })  # fmt: skip
        for place, axis in ((3, "v"), (4, "w")):
            draft.put(**{
                f"torque_acting_on_inner_component_{axis}": 0.0 - force[place],
                f"torque_acting_on_outer_component_{axis}": force[place],
                f"tilting_inner_side_{axis}": inner[place],
                f"tilting_outer_side_{axis}": outer[place],
                f"angular_deflection_in_{axis}": inner[place] - outer[place],
            })  # fmt: skip
        draft.put(
            axial_deflection=inner[0] - outer[0],
            radial_deflection_in_v=inner[1] - outer[1],
            radial_deflection_in_w=inner[2] - outer[2],
        )
        pressures = {
            race: float(np.nanmax(contacts.max_pressure[case]))
            for race, contacts in solved.contacts.items()
            if np.isfinite(contacts.max_pressure[case]).any()
        }
        draft.put(
            maximum_hertzian_pressure=max(pressures.values(), default=None),
            maximum_hertzian_pressure_inner_ring=pressures.get("inner"),
            maximum_hertzian_pressure_outer_ring=pressures.get("outer"),
        )
        self._put_stiffness(draft, seated, case)
        if own.life is not None:
            loads = own.life.loads
            if loads is not None:
                draft.put(
                    static_safety_factor_iso_76_2006=_number(loads.safety, case),
                    equivalent_dynamic_bearing_load_iso_281_2007=_number(loads.dynamic, case),
                )
            if machine.spectrum:
                for theory, life in own.life.theories.items():
                    _put_life(draft, theory, life, case)
        if own.film is not None:
            draft.put(viscosity_ratio_iso_281_2007=_number(own.film.viscosity_ratio, case))
        if own.friction is not None:
            draft.put(
                total_frictional_torque=_number(own.friction.torque, case),
                total_frictional_power_loss=_number(own.friction.power, case),
            )

    def _put_stiffness(self, draft: _Draft, seated: SeatedBearing, case: int) -> None:
        side = float(seated.bearing.side)
        turn = np.array([side, 1.0, 1.0, side, side])  # as the forces of what is turned round
        matrix = turn[:, None] * seated.solved.stiffness.array[case] * turn
        for row, force in enumerate(_STIFFNESS[0]):
            for column, shift in enumerate(_STIFFNESS[1]):
                unit, scale = _STIFFNESS_UNITS[force[0], shift.partition("_")[0]]
                value = scale * float(matrix[row, column])
                if math.isfinite(value):
                    name = f"operating_point_stiffness_{force}_{shift}"
                    text = plain_number(float(f"{value:.15g}"))
                    draft.attributes[name] = Attribute(name, text, unit, "floating_point")

    def _put_contacts(
        self, drafts: dict[int, _Draft] | None, name: str, seated: SeatedBearing, case: int
    ) -> None:
        """Put load, angle, pressure and size of the contacts of each element."""
        solved = seated.solved
        azimuth = solved.elements.azimuth[case]
        for place, element in enumerate(self._elements[name]):
            if place >= len(azimuth):
                break
            # azimuths count from z toward y, angles about u from v (y) toward w (z)
            angle = math.remainder(0.5 * math.pi - float(azimuth[place]), 2.0 * math.pi)
            _of(drafts, element).put(angular_position_around_u=angle)
            for race, contacts in solved.contacts.items():
                load = float(contacts.load[case, place])
                if not load > 0.0:
                    continue
                own = self._contact(element, race)
                draft = _of(drafts, own)
                draft.put(
                    rolling_element_force=load,
                    maximum_hertzian_pressure=float(contacts.max_pressure[case, place]),
                    operating_pressure_angle=float(contacts.contact_angle[case, place]),
                    half_length_of_contact_area=float(contacts.semi_major[case, place]),
                    half_width_of_contact_area=float(contacts.semi_minor[case, place]),
                )

    def _contact(self, element: _Draft, race: str) -> _Draft:
        if (element.id, race) not in self._contacts:
            own = self._contacts[element.id, race] = self._add("rolling_element_contact", "")
            self._relate("assembly", assembly=element, part=own)
            own.word("rolling_element_contact_type", f"{race}_raceway_contact")
        return self._contacts[element.id, race]

    def _put_lives(self, drafts: Mapping[str, _Draft], *, accumulated: bool) -> None:
        assert self._found is not None
        for name, draft in drafts.items():
            if accumulated:
                lives = self._found.lives[name]
                for theory, life in () if lives is None else lives.theories.items():
                    if theory in _LIVES and life.valid and math.isfinite(life.hours):
                        _put_hours(draft, theory, float(life.hours), float(life.life))
                continue
            own = self._found.bearings[name].life
            for theory, one in () if own is None else own.theories.items():
                _put_life(draft, theory, one, 0)


# --- small parts ----------------------------------------------------------------------------------


def _of(drafts: dict[int, _Draft] | None, draft: _Draft) -> _Draft:
    """A draft for some attributes of a component in a load case; itself where there is none."""
    if drafts is None:
        return draft
    if draft.id not in drafts:
        drafts[draft.id] = _Draft(draft.id, draft.type, "")
    return drafts[draft.id]


def _first(*values: Any) -> Any:
    return next((value for value in values if value is not None), None)


def _number(values: Any, case: int) -> float:
    return float(np.broadcast_to(values, (max(case + 1, np.size(values)),))[case])


def _ribless(inside: Any) -> bool:
    return getattr(inside, "inner_ribs", "none") == "none" or (
        getattr(inside, "outer_ribs", "none") == "none"
    )


def _put_life(draft: _Draft, theory: str, life: Any, case: int) -> None:
    hours, count = float(life.hours[case]), float(life.life[case])
    if theory in _LIVES and bool(life.valid[case]) and math.isfinite(hours):
        _put_hours(draft, theory, hours, count)


def _put_hours(draft: _Draft, theory: str, hours: float, count: float) -> None:
    draft.put(**{_LIVES[theory].format("time"): hours * HOUR})
    name = _LIVES[theory].format("rotations")
    if math.isfinite(count):
        text = plain_number(float(f"{count:.15g}"))
        draft.attributes[name] = Attribute(name, text, "MRev", "floating_point")


def _in_xml(text: str) -> str:
    """A text without the characters that XML does not have."""
    return "".join(
        char if char >= " " and char not in "\ufffe\uffff" and not "\ud800" <= char <= "\udfff"
        else "\ufffd"
        for char in text
    )  # fmt: skip


def _own_table(part: Record) -> dict[str, Any]:
    """The table of a part, without what is usual."""
    table = part.model_dump(context=AT_THE_BORDER, exclude_none=True, exclude_defaults=True)
    if hasattr(part, "units"):
        table["units"] = part.units
    return {name: value for name, value in table.items() if value not in ("", (), [])}


def _changes(old: Part | None, own: Part) -> dict[str, list[Any]]:
    """What is read of a part, and what it is, by its keys, where they differ."""
    was = {} if old is None else json.loads(json.dumps(old.table))
    now = json.loads(json.dumps(own.table))
    other_kind = old is not None and old.kind != own.kind
    return {
        key: [was.get(key), now.get(key)]
        for key in dict.fromkeys([*was, *now])
        if was.get(key) != now.get(key) or (other_kind and key in was)
    }


def _places_of_shafts(machine: Machine) -> dict[str, tuple[float, float]]:
    """Where the axes of shafts are, y and z: gears in mesh touch; others are coaxial."""
    meshes = [
        (machine.gear(gear.mate), gear)
        for gear in machine.gears
        if gear.mate is not None and gear.follows_mate
    ]
    places: dict[str, tuple[float, float]] = {}
    for shaft in machine.shafts:
        if shaft.name in places:
            continue
        places[shaft.name] = (0.0, 0.0)
        waiting = [shaft.name]
        while waiting:
            here = waiting.pop()
            for giver, taker in meshes:
                for one, other, sign in ((giver, taker, 1.0), (taker, giver, -1.0)):
                    if one.shaft != here or other.shaft in places:
                        continue
                    apart = 0.5 * sign * (giver.diameter + taker.diameter)
                    azimuth = giver.mesh_azimuth or 0.0
                    y, z = places[here]
                    places[other.shaft] = (
                        y + apart * math.sin(azimuth), z + apart * math.cos(azimuth),
                    )  # fmt: skip
                    waiting.append(other.shaft)
    return places
