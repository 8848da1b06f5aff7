"""REXS models of machines: read back they are the same, and others find what they need."""

from __future__ import annotations

import json
import math
import re
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import rolamento
from rolamento.analysis.machine import MachineAnalysis, analyse_machine
from rolamento.case.machine import Machine, load_machine, parse_machine
from rolamento.exchange.rexs import (
    Attribute,
    Component,
    Exported,
    RexsModel,
    machine_of_rexs,
    parse_rexs,
    rexs_bytes,
    rexs_of_machine,
)
from rolamento.exchange.rexs.reading import CUSTOM
from rolamento.exchange.rexs.values import attribute_of, quantity_of, standard_of, words
from rolamento.types import TYPES

EXAMPLES = sorted((Path(rolamento.__file__).parent / "examples" / "machines").glob("*.toml"))
BEARING = "rolling_bearing_with_detailed_geometry"
DATE = "2026-01-01T00:00:00+00:00"


@pytest.fixture(scope="module")
def shaft() -> MachineAnalysis:
    return analyse_machine(load_machine(EXAMPLES[1]))


def changed(model: RexsModel, kind: str, name: str, **values: str) -> RexsModel:
    """A model in which another program has changed attributes of a component."""
    components = tuple(
        replace(
            one,
            attributes={
                **one.attributes,
                **{key: replace(one.attributes[key], value=value)
                   for key, value in values.items()},
            },
        )
        if one.type == kind and one.name == name
        else one
        for one in model.components
    )  # fmt: skip
    return RexsModel(model.version, "Other", "1", model.date, components, model.relations,
                     model.load_cases, model.accumulation)  # fmt: skip


def of(model: RexsModel, kind: str, name: str = "") -> Component:
    return next(one for one in model.components if one.type == kind and one.name in (name, ""))


def value(component: Component, name: str) -> float:
    return quantity_of(component, component.attributes[name], name)


# --- the same machine -----------------------------------------------------------------------------


@pytest.mark.parametrize("ending", [".rexs", ".rexsj", ".rexsz"])
@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_every_example_reads_back_as_the_same_machine(path: Path, ending: str) -> None:
    machine = load_machine(path)
    exported = rexs_of_machine(machine, date=DATE)
    found = machine_of_rexs(parse_rexs(rexs_bytes(exported.model, f"a{ending}")))
    assert found.machine == machine
    assert found.machine.to_mapping() == machine.to_mapping()
    assert found.of_sort("inferred") == ()
    assert not [note for note in exported.notes if note.key == "rexs_not_the_same"]


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_with_results_too(path: Path) -> None:
    analysis = analyse_machine(load_machine(path))
    exported = rexs_of_machine(analysis, date=DATE)
    found = machine_of_rexs(parse_rexs(rexs_bytes(exported.model, "a.rexs")))
    assert found.machine == analysis.solved.machine


LONG = st.floats(1e-4, 1.0)
ODD = st.floats(-1e5, 1e5).filter(lambda number: number == 0.0 or abs(number) > 1e-9)


@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(LONG, LONG, LONG, ODD, ODD, ODD, st.floats(-1e4, 1e4), st.floats(0.0, 1.0))
def test_any_numbers_come_back_to_the_last_digit(
    long: float, wide: float, left: float, fx: float, fz: float, mx: float, speed: float, at: float
) -> None:
    machine = Machine(
        title="any",
        shafts=[
            {"name": "s", "sections": [{"length": long, "diameter": wide},
                                       {"length": left, "diameter": wide, "bore": 0.3 * wide}],
             "speed": speed, "position": fx * 1e-4},
        ],
        bearings=[{"name": "b", "shaft": "s", "position": at * long, "designation": "6205",
                   "life": {"contamination": 0.3}, "temperature": {"lubricant": 333.15}}],
        loads=[{"shaft": "s", "position": at * long, "fx": fx, "fz": fz, "mx": mx}],
    )  # fmt: skip
    for ending in (".rexs", ".rexsj"):
        content = rexs_bytes(rexs_of_machine(machine, date=DATE).model, f"a{ending}")
        assert machine_of_rexs(parse_rexs(content)).machine == machine


EVERYTHING = """
title = "Everything & <more>"
lubricant = "ISO VG 100"
[temperature]
lubricant = "61.3 degC"
shaft = "55 degC"
[life]
cleanliness = "-/17/14"
oil_supply = "bath"
[gravity]
direction = "-y"
[[shafts]]
name = "hollow \\"one\\""
speed = "1111.1 rpm"
sections = [
    { length = "100 mm", diameter = "60 mm", end_diameter = "70 mm", end_bore = "3.1 mm" },
    { length = "33.3 mm", diameter = "60 mm" },
]
[shafts.material]
name = "iron"
youngs_modulus = "170 GPa"
poisson_ratio = 0.28
density = "7100 kg/m^3"
[[shafts]]
name = "second"
ratio = -0.5
of = "hollow \\"one\\""
sections = [{ length = "200 mm", diameter = "40 mm" }]
position = "-12.34 mm"
[[bearings]]
name = "A"
shaft = "hollow \\"one\\""
position = "10 mm"
designation = "30212"
faces = "+x"
preload = "123.4 N"
housing = "h"
[bearings.lubricant]
name = "own"
viscosity_40 = "46 mm^2/s"
viscosity_100 = "7 mm^2/s"
density = "870 kg/m^3"
[[bearings]]
name = "B"
shaft = "hollow \\"one\\""
position = "120 mm"
designation = "30212"
faces = "-x"
offset = "3.3 um"
housing = "h"
[[bearings]]
name = "C"
shaft = "second"
position = "10 mm"
designation = "22208"
[[bearings]]
name = "D"
shaft = "second"
position = "180 mm"
located = "floating"
spring_force = "77 N"
[bearings.bearing]
ball_count = 9
ball_diameter = "11.1125 mm"
pitch_diameter = "60 mm"
diametral_clearance = "11 um"
inner_conformity = 0.515
outer_conformity = 0.53
[bearings.surface]
inner_roughness = "0.1 um"
outer_roughness = "0.1 um"
ball_roughness = "0.05 um"
[[housings]]
name = "h"
stiffness = ["400 N/um", "250 N/um", "250 N/um"]
[[springs]]
shaft = "second"
position = "100 mm"
stiffness = ["1 N/um", "2 N/um", "3 N/um", "10 N m/rad", "20 N m/rad"]
[[loads]]
shaft = "second"
position = "111.1 mm"
my = "3.3 N m"
mz = "-1 N m"
[[gears]]
name = "g1"
shaft = "hollow \\"one\\""
position = "60 mm"
kind = "helical"
teeth = 20
module = "3 mm"
helix_angle = "11.5 deg"
torque = "77.7 N m"
mesh_azimuth = "33.3 deg"
drives = true
[[gears]]
name = "g2"
shaft = "second"
position = "100 mm"
kind = "helical"
hand = "left"
teeth = 40
module = "3 mm"
helix_angle = "11.5 deg"
mate = "g1"
[[belts]]
shaft = "second"
position = "199 mm"
diameter = "100 mm"
tight = "300 N"
slack = "100 N"
azimuth = "45 deg"
drives = true
[[masses]]
shaft = "second"
position = "50 mm"
diameter = "100 mm"
width = "20 mm"
unbalance = "12 g mm"
unbalance_azimuth = "77 deg"
[[spectrum]]
name = "one"
share = 0.3
speed_factor = 0.9
[[spectrum]]
share = 0.7
load_factor = 0.31
"""


def test_every_part_of_a_machine_file_comes_back() -> None:
    machine = parse_machine(EVERYTHING)
    exported = rexs_of_machine(machine, date=DATE)
    for ending in (".rexs", ".rexsj"):
        found = machine_of_rexs(parse_rexs(rexs_bytes(exported.model, f"a{ending}")))
        assert found.machine == machine
    kept = {note.values["part"]: note.values["keys"] for note in exported.notes
            if note.key == "rexs_kept_by_custom"}  # fmt: skip
    assert kept["housings: h"] == "stiffness"
    assert "spring_force" in kept["bearings: D"]
    assert "life" in kept["machine"]


# --- what other programs change -------------------------------------------------------------------


def test_what_another_program_changed_counts(shaft: MachineAnalysis) -> None:
    model = rexs_of_machine(shaft, date=DATE).model
    moved = changed(model, "external_load", "")
    assert machine_of_rexs(moved).machine == shaft.solved.machine
    position = ("20.0", "0.0", "0.0")
    moved = changed(
        model,
        "rolling_bearing_with_detailed_geometry",
        "floating",
        support_vector=position,
        u_coordinate_on_shaft_inner_side="20.0",
    )  # type: ignore[arg-type]
    found = machine_of_rexs(moved)
    assert found.machine.bearing("floating").position == 0.020
    assert found.machine.bearing("floating").designation == "NU308"
    assert found.machine.bearing("locating") == shaft.solved.machine.bearing("locating")


def test_a_bearing_whose_inside_was_changed_is_as_it_is_now(shaft: MachineAnalysis) -> None:
    """Its designation alone would not say so: it stands with the new geometry."""
    model = changed(rexs_of_machine(shaft, date=DATE).model, "rolling_element", "",
                    diameter_of_rolling_element="14.0")  # fmt: skip
    found = machine_of_rexs(model)
    bearing = found.machine.bearing("locating").case.bearing
    assert (bearing.designation, bearing.ball_diameter) == ("6308", 0.014)
    assert {"rexs_changed"} == {remark.note.key for remark in found.of_sort("left")
                                if remark.component is not None}  # fmt: skip


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_parts_that_another_program_calls_otherwise_make_a_machine(path: Path) -> None:
    model = rexs_of_machine(load_machine(path), date=DATE).model
    renamed = replace(
        model,
        components=tuple(replace(one, name=f"{one.name} new") for one in model.components),
    )
    machine = machine_of_rexs(parse_rexs(rexs_bytes(renamed, "a.rexs"))).machine
    assert all(shaft.name.endswith(" new") for shaft in machine.shafts)
    assert len(machine.bearings) == len(load_machine(path).bearings)


def test_a_machine_without_its_custom_attributes_is_nearly_the_same(
    shaft: MachineAnalysis,
) -> None:
    """As any other reader finds it: shafts, bearings, forces, and what oil and temperature are."""
    model = rexs_of_machine(shaft, date=DATE).model
    bare = RexsModel(
        model.version, "Other", "1", model.date,
        tuple(replace(one, attributes={n: a for n, a in one.attributes.items() if n != CUSTOM})
              for one in model.components),
        model.relations, model.load_cases,
    )  # fmt: skip
    found, machine = machine_of_rexs(bare).machine, shaft.solved.machine
    assert [one.share for one in found.spectrum] == [one.share for one in machine.spectrum]
    assert [one.speed_factor for one in found.spectrum] == [1.0, 1.0, 1.2]
    assert found.lubricant is not None
    assert found.lubricant.viscosity_40 == pytest.approx(220e-6)
    assert found.temperature == machine.temperature
    own, other = found.shafts[0], machine.shafts[0]
    assert (own.sections, own.speed) == (other.sections, other.speed)
    for step, same in zip(found.spectrum, machine.spectrum, strict=True):
        ours, theirs = (m.forces(s)[0].force for m, s in ((found, step), (machine, same)))
        assert ours == pytest.approx(theirs, rel=1e-9)
    solved = rolamento.shaft(found)
    for name, seated in shaft.solved.bearings.items():
        assert solved.bearings[name].force == pytest.approx(seated.force, rel=1e-3, abs=0.5)


@pytest.mark.parametrize("ending", [".rexs", ".rexsj", ".rexsz"])
def test_a_file_that_nobody_changed_is_the_same_to_a_reader_that_finds_more(
    shaft: MachineAnalysis, ending: str
) -> None:
    """What any reader finds stands in the file too: of an untouched one it does not matter."""
    model = rexs_of_machine(shaft, date=DATE).model
    other = re.sub(r'"designation": \[null', '"designation": ["found by a later one"',
                   of(model, BEARING, "floating").attributes[CUSTOM].text)  # fmt: skip
    assert "later" in other
    later = changed(model, BEARING, "floating", **{CUSTOM: other})
    found = machine_of_rexs(parse_rexs(rexs_bytes(later, f"a{ending}")))
    assert found.machine == shaft.solved.machine
    touched = changed(later, "shaft_section", "", inner_diameter_begin="1.0")
    found = machine_of_rexs(parse_rexs(rexs_bytes(touched, f"a{ending}")))
    assert "rexs_changed" in [remark.note.key for remark in found.remarks]


@pytest.mark.parametrize("text", ["nonsense", "[1]", '[["loads", 3]]', "{}x", "[" * 50_000])
def test_a_damaged_custom_attribute_is_one_message(shaft: MachineAnalysis, text: str) -> None:
    model = rexs_of_machine(shaft.solved.machine, date=DATE).model
    broken = changed(model, "rolling_bearing_with_detailed_geometry", "floating", **{CUSTOM: text})
    with pytest.raises(rolamento.FileError, match=CUSTOM) as caught:
        machine_of_rexs(broken)
    assert "\n" not in str(caught.value)


# --- by the standard ------------------------------------------------------------------------------

CHILDREN = {
    "model": ["relations", "components", "load_spectrum"], "relations": ["relation"],
    "relation": ["ref"], "components": ["component"], "component": ["attribute"],
    "attribute": ["array", "matrix"], "array": ["c"], "load_case": ["component"],
    "load_spectrum": ["load_case", "accumulation"], "accumulation": ["component"],
}  # fmt: skip
NEEDED = {
    "model": ["version", "applicationId", "applicationVersion", "date"], "relation": ["id", "type"],
    "ref": ["id", "role"], "component": ["id", "type"], "attribute": ["id"],
    "load_spectrum": ["id"], "load_case": ["id"],
}  # fmt: skip


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_the_form_is_that_of_the_schema(path: Path) -> None:
    exported = rexs_of_machine(analyse_machine(load_machine(path)), date=DATE)
    root = ElementTree.fromstring(rexs_bytes(exported.model, "a.rexs"))
    for element in root.iter():
        order = CHILDREN.get(element.tag, [])
        places = [order.index(child.tag) for child in element]
        assert places == sorted(places)
        assert all(element.get(name) is not None for name in NEEDED.get(element.tag, []))
    numbers = [one.get("id") for one in root.findall("./components/component")]
    assert len(numbers) == len({*numbers})
    for named in (*root.iterfind(".//ref"), *root.iterfind(".//load_case/component"),
                  *root.iterfind(".//accumulation/component")):  # fmt: skip
        assert named.get("id") in numbers
    for relation in root.iterfind(".//relation"):
        roles = [ref.get("role") for ref in relation]
        assert len(roles) == len({*roles})
    for attribute in root.iterfind(".//attribute"):
        name = attribute.get("id") or ""
        assert re.fullmatch(r"[a-z0-9_]+", name)
        standard = standard_of(name)
        assert standard is None or attribute.get("unit") == standard.unit


def test_attributes_of_load_cases_stand_only_there(shaft: MachineAnalysis) -> None:
    model = rexs_of_machine(shaft, date=DATE).model
    for case in model.load_cases:
        for one in case.components:
            assert not one.attributes.keys() & model.by_id[one.id].attributes.keys()
    assert len(model.load_cases) == 3


def test_every_type_of_bearing_has_a_word_or_none_by_intent() -> None:
    known = {key for keys in words()["bearing_types"].values() for key in keys}
    assert TYPES.keys() - known == {"toroidal"}
    assert known <= TYPES.keys()


@pytest.mark.parametrize("name", [name for group in words()["quantities"]
                                  for name in group["attributes"][:1]])  # fmt: skip
@pytest.mark.parametrize("number", [0.1, 1.0 / 3.0, 2.0 / 3.0 * 1e-5, 5e-324, 12345.678, 0.0])
def test_what_is_written_is_the_identical_float(name: str, number: float) -> None:
    if name == "temperature_lubricant":  # of which nobody has a millionth of a kelvin
        number += 300.0
    attribute = attribute_of(name, number)
    assert isinstance(attribute, Attribute)
    assert quantity_of(Component(1, "x"), attribute, name) == number


# --- results --------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def pinion() -> tuple[MachineAnalysis, Exported]:
    found = analyse_machine(load_machine(EXAMPLES[3]))
    return found, rexs_of_machine(found, date=DATE)


def test_loads_and_displacements(pinion: tuple[MachineAnalysis, Exported]) -> None:
    found, exported = pinion
    for name, seated in found.solved.bearings.items():
        one = of(exported.model, "rolling_bearing_with_detailed_geometry", name)
        for place, axis in enumerate("uvw"):
            for side, sign in (("inner", -1.0), ("outer", 1.0)):
                force = value(one, f"force_acting_on_{side}_component_{axis}")
                assert force == pytest.approx(sign * seated.force[0, place])
            shift = value(one, f"displacement_inner_side_{axis}")
            assert shift == pytest.approx(seated.inner[0, place], rel=1e-12, abs=1e-15)
        assert value(one, "tilting_inner_side_v") == pytest.approx(seated.inner[0, 3])
        assert value(one, "tilting_outer_side_w") == pytest.approx(seated.outer[0, 4])


def test_the_stiffness_is_that_of_the_machines_axes(
    pinion: tuple[MachineAnalysis, Exported],
) -> None:
    """A step of the rings gives the change of force, whichever way a bearing faces."""
    found, exported = pinion
    names = ("f_u", "f_v", "f_w", "m_v", "m_w"), ("d_u", "d_v", "d_w", "rot_v", "rot_w")
    scales = {"N / m": 1.0, "N / rad": 1.0, "N": 1.0, "N mm / rad": 1e-3}
    for name, seated in found.solved.bearings.items():
        one = of(exported.model, "rolling_bearing_with_detailed_geometry", name)
        matrix = np.array([
            [
                float(one.attributes[f"operating_point_stiffness_{row}_{column}"].text)
                * scales[one.attributes[f"operating_point_stiffness_{row}_{column}"].unit]
                for column in names[1]
            ]
            for row in names[0]
        ])  # fmt: skip
        assert matrix == pytest.approx(matrix.T, rel=1e-6, abs=1e-6 * np.abs(matrix).max())
        side = float(seated.bearing.side)
        turn = np.diag([side, 1.0, 1.0, side, side])
        own = seated.solved.stiffness.array[0]
        assert matrix == pytest.approx(turn @ own @ turn, rel=1e-12)
        # a cone is pressed in by axial force the way it faces, and then tilts its ring
        assert matrix[0, 0] > 0.0
        assert math.copysign(1.0, matrix[0, 2]) == side * math.copysign(1.0, own[0, 2])


def test_lives_safeties_frequencies_and_pressures(
    pinion: tuple[MachineAnalysis, Exported],
) -> None:
    found, exported = pinion
    for name, own in found.bearings.items():
        one = of(exported.model, "rolling_bearing_with_detailed_geometry", name)
        assert own.life is not None
        hours = float(own.life.theories["iso281"].hours[0])
        written = value(one, "nominal_rating_life_time_iso_281_2007")
        assert written == pytest.approx(3600.0 * hours)
        turns = float(one.attributes["nominal_rating_life_rotations_iso_281_2007"].text)
        assert turns == pytest.approx(hours * 60.0 * 1500.0 / 1e6)
        safety = float(one.attributes["static_safety_factor_iso_76_2006"].text)
        assert safety == pytest.approx(float(own.life.loads.safety[0]))
        pressure = value(one, "maximum_hertzian_pressure")
        assert pressure == pytest.approx(max(
            float(np.nanmax(race.max_pressure)) for race in own.solved.contacts.values()
        ))  # fmt: skip
        outer = float(one.attributes["overrolling_frequency_outer_ring"].text)
        cage = value(one, "speed_rolling_element_set")
        count = own.solved.case.bearing.element_count
        assert outer == pytest.approx(count * cage / (2.0 * math.pi), rel=1e-9)


def test_every_element_has_its_contacts(pinion: tuple[MachineAnalysis, Exported]) -> None:
    found, exported = pinion
    model = exported.model
    name, seated = next(iter(found.solved.bearings.items()))
    bearing = of(model, "rolling_bearing_with_detailed_geometry", name)
    (row,) = model.parts(bearing.id, "rolling_bearing_row")
    elements = model.parts(row.id, "rolling_element")
    loads = seated.solved.inner.load[0]
    assert len(elements) == len(loads)
    for place, element in enumerate(elements):
        contacts = {
            one.attributes["rolling_element_contact_type"].text: one
            for one in model.parts(element.id, "rolling_element_contact")
        }
        assert ("inner_raceway_contact" in contacts) == (loads[place] > 0.0)
        if one := contacts.get("inner_raceway_contact"):
            assert value(one, "rolling_element_force") == pytest.approx(loads[place])
            assert value(one, "maximum_hertzian_pressure") == pytest.approx(
                seated.solved.inner.max_pressure[0, place]
            )
        angle = value(element, "angular_position_around_u")
        azimuth = float(seated.solved.elements.azimuth[0, place])
        # v is y and w is z: the same place, counted from another axis
        assert (math.cos(angle), math.sin(angle)) == pytest.approx(
            (math.sin(azimuth), math.cos(azimuth)), abs=1e-12
        )


def test_a_machine_without_equilibrium_is_written_without_results() -> None:
    machine = load_machine(EXAMPLES[1], ["bearings.locating.located=floating"])
    exported = rexs_of_machine(analyse_machine(machine), date=DATE)
    assert "rexs_unsolved" in [note.key for note in exported.notes]
    assert "maximum_hertzian_pressure" not in json.dumps(str(exported.model.load_cases))
    assert machine_of_rexs(exported.model).machine == machine


def test_other_programs_are_told_of_belts_and_bevel_gears(
    pinion: tuple[MachineAnalysis, Exported],
) -> None:
    _, exported = pinion
    assert "rexs_as_loads" in [note.key for note in exported.notes]
    load = of(exported.model, "external_load", "pinion")
    assert value(load, "torque_around_u_axis") == pytest.approx(-60.0)
