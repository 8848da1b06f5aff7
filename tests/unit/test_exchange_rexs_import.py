"""Machines of REXS models: what is read, in which units and versions, and what is no error."""

from __future__ import annotations

import base64
import json
import math
import struct

import pytest
from tests.rexs_models import Model, at, gear_pair, shaft_on_two, side, texts, vector

from rolamento.analysis.machine import analyse_machine
from rolamento.case.machine import Machine
from rolamento.errors import FileError, InputError
from rolamento.exchange.rexs import Imported, machine_of_rexs, parse_rexs
from rolamento.words import Note


def read(model: Model, load_case: int | None = None) -> Imported:
    return machine_of_rexs(parse_rexs(model.xml()), load_case=load_case)


def keys(found: Imported, sort: str) -> list[str]:
    return [remark.note.key for remark in found.of_sort(sort)]


def refused(model: Model) -> str:
    with pytest.raises(InputError) as caught:
        read(model)
    assert "\n" not in str(caught.value)
    return str(caught.value)


EXPECTED = {
    "shafts": [{
        "name": "Welle",
        "sections": [
            {"length": "40 mm", "diameter": "25 mm"},
            {"length": "60 mm", "diameter": "30 mm", "bore": "10 mm", "end_diameter": "26 mm",
             "end_bore": "8 mm"},
        ],
        "speed": "1500 rpm",
        "position": "10 mm",
    }],
    "bearings": [
        {"name": "Lager A", "shaft": "Welle", "position": "10 mm", "designation": "6305",
         "life": {"dynamic_rating": "22.4 kN", "static_rating": "11.4 kN"}},
        {"name": "Lager B", "shaft": "Welle", "position": "85 mm", "designation": "NU205"},
    ],
    "loads": [{"name": "Kraft", "shaft": "Welle", "position": "50 mm", "fx": "300 N",
               "fz": "-2 kN"}],
}  # fmt: skip


@pytest.mark.parametrize("version", ["1.0", "2.0"])
@pytest.mark.parametrize("container", ["xml", "json", "zip", "zipped json", "with a mark"])
def test_every_version_and_container_has_the_same_machine(version: str, container: str) -> None:
    model = shaft_on_two(version)
    content = {
        "xml": model.xml,
        "json": model.json,
        "zip": model.zipped,
        "zipped json": lambda: model.zipped("gear.rexsj"),
        "with a mark": lambda: b"\xef\xbb\xbf" + model.xml(),
    }[container]()
    found = machine_of_rexs(parse_rexs(content))
    assert found.machine == Machine.from_mapping(EXPECTED)
    assert found.version == version
    assert keys(found, "inferred") == []


def test_a_machine_that_was_read_is_solved() -> None:
    solved = analyse_machine(read(gear_pair()).machine)
    assert solved.converged
    assert all(life is not None for life in solved.lives.values())


# --- units and unknown numbers --------------------------------------------------------------------


@pytest.mark.parametrize(
    ("value", "unit", "millimetres"),
    [("40", "mm", 40.0), ("0.04", "m", 40.0), ("40000", "mum", 40.0), ("40", "", 40.0),
     ("4e1", "mm", 40.0), (" 40.0 ", "mm", 40.0)],
)  # fmt: skip
def test_a_length_has_the_unit_that_the_file_states(
    value: str, unit: str, millimetres: float
) -> None:
    found = read(shaft_on_two().set(4, length=(value, unit)))
    assert found.machine.shafts[0].sections[0].length == pytest.approx(millimetres / 1e3, 1e-15)


@pytest.mark.parametrize(
    ("attributes", "expected"),
    [
        ({"length": ("40", "kN")}, 'shaft_section 4.length: "kN" is not a unit of length'),
        ({"length": ("forty", "mm")}, 'shaft_section 4.length = "forty mm": '),
        ({"length": ("nan", "mm")}, 'shaft_section 4.length = "nan": must be a finite number'),
        ({"length": ("4,5", "mm")}, "shaft_section 4.length"),
        ({"outer_diameter_begin": ("25", "furlong")}, "shaft_section 4.outer_diameter_begin"),
        ({"length": (["1", "2"], "mm")}, "shaft_section 4.length: must be a single value"),
    ],
)
def test_a_wrong_number_or_unit_is_one_message_with_the_place(
    attributes: dict[str, object], expected: str
) -> None:
    assert refused(shaft_on_two().set(4, **attributes)).startswith(expected)


@pytest.mark.parametrize("name", ["dynamic_capacity", "static_capacity"])
def test_zero_is_unknown_in_old_files(name: str) -> None:
    found = read(shaft_on_two("1.0").set(6, **{name: ("0.0", "kN")}))
    life = found.machine.bearings[0].life
    assert {"dynamic_capacity": "dynamic_rating", "static_capacity": "static_rating"}[
        name
    ] not in life


def test_an_infinite_stiffness_is_no_data() -> None:
    model = shaft_on_two()
    model.add(40, "concept_bearing", None, "Lagerung", **at(3, 20, 0, 0),
              radial_stiffness=("1e23", "N / m"), axial_stiffness=("0", "N / m"))  # fmt: skip
    model.relations.append(side(540, 40, 3, 2))
    found = read(model)
    assert found.machine.springs == ()
    assert "rexs_stiffness_unknown" in keys(found, "left")


def test_a_finite_stiffness_is_a_spring() -> None:
    model = shaft_on_two()
    model.add(40, "coupling", None, "Kupplung", **at(3, 20, 0, 0),
              radial_stiffness=("1e8", "N / m"), axial_stiffness=("5e7", "N / m"),
              bending_stiffness=("2e6", "N mm / rad"))  # fmt: skip
    model.relations.append(side(540, 40, 3, 2))
    (spring,) = read(model).machine.springs
    assert spring.stiffness == pytest.approx((5e7, 1e8, 1e8, 2e3, 2e3))


@pytest.mark.parametrize(("code", "form"), [("float32", "f"), ("float64", "d")])
@pytest.mark.parametrize("padding", [True, False])
def test_arrays_may_be_coded(code: str, form: str, padding: bool) -> None:
    text = base64.b64encode(struct.pack(f"<3{form}", 20.0, 0.0, 0.0)).decode()
    text = text if padding else text.rstrip("=")
    model = shaft_on_two()
    plain = "<array><c>20</c><c>0</c><c>0</c></array>"
    assert plain.encode() in model.xml()
    coded = model.xml().replace(plain.encode(), f'<array code="{code}">{text}</array>'.encode())
    assert machine_of_rexs(parse_rexs(coded)).machine.bearings[0].position == 0.010
    mapping = json.loads(model.json())
    for attribute in mapping["model"]["components"][5]["attributes"]:
        if attribute["id"] == "support_vector":
            del attribute["floating_point_array"]
            attribute["floating_point_array_coded"] = {"code": code, "value": text}
    found = machine_of_rexs(parse_rexs(json.dumps(mapping).encode()))
    assert found.machine.bearings[0].position == 0.010


# --- places ---------------------------------------------------------------------------------------


def test_places_follow_chains_of_references() -> None:
    model = shaft_on_two()
    model.add(50, "assembly_group", None, "", **at(3, 30, 0, 0))
    model.add(51, "assembly_group", None, "", **at(50, 40, 0, 0))
    model.set(7, **at(51, 10, 0, 0))
    assert read(model).machine.bearings[1].position == 0.080


def test_references_that_go_round_in_a_circle_are_refused() -> None:
    model = shaft_on_two()
    model.add(50, "assembly_group", None, "", **at(51, 1, 0, 0))
    model.add(51, "assembly_group", None, "", **at(50, 1, 0, 0))
    assert "closes a circle" in refused(model.set(7, **at(51, 10, 0, 0)))


def test_a_chain_of_many_references_takes_no_time() -> None:
    model = shaft_on_two()
    for number in range(100, 5100):
        model.add(number, "assembly_group", None, "", **at(number + 1, 0, 0, 0))
    model.add(5100, "assembly_group", None, "", **at(1, 0, 0, 0))
    assert len(read(model).machine.bearings) == 2


def test_a_shaft_that_points_the_other_way_is_turned_round() -> None:
    """All of it, seen from the other end: the machine is the same one."""
    model = shaft_on_two().set(
        3, **at(1, 110, 0, 0, u_axis_vector=vector(-1, 0, 0)),
        rotational_speed=("-1500", "1 / min"),
    )  # fmt: skip
    model.set(4, u_coordinate_on_shaft=("60", "mm"))
    model.set(5, u_coordinate_on_shaft=("0", "mm"), outer_diameter_begin=("26", "mm"),
              outer_diameter_end=("30", "mm"), inner_diameter_begin=("8", "mm"),
              inner_diameter_end=("10", "mm"))  # fmt: skip
    model.set(7, **at(3, 15, 0, 0))
    model.set(8, force_u_direction=("-300", "N"))
    found = read(model)
    assert found.machine == Machine.from_mapping(EXPECTED)
    assert keys(found, "inferred") == ["rexs_turned_shaft"]


def test_shafts_along_another_axis_have_their_own() -> None:
    turned = {"u_axis_vector": vector(0, 0, 1), "w_axis_vector": vector(1, 0, 0)}
    model = shaft_on_two().set(3, **at(1, 0, 0, 10, **turned))
    model.set(6, **at(1, 0, 0, 20, **turned))
    found = read(model)
    assert found.machine.loads[0].forces()[:3] == (300.0, 0.0, -2000.0)
    assert found.machine.bearings[0].position == 0.010
    assert "rexs_axes" in keys(found, "inferred")


def test_a_shaft_across_the_others_is_left_out() -> None:
    model = shaft_on_two()
    model.add(60, "shaft", 1, "quer", **at(1, 0, 0, 0, u_axis_vector=vector(0, 1, 0)))
    model.add(61, "shaft_section", 60, "", length=("10", "mm"), outer_diameter_begin=("9", "mm"))
    model.add(62, "external_load", 60, "", u_coordinate_on_shaft=("5", "mm"))
    found = read(model)
    assert len(found.machine.shafts) == 1
    assert {"rexs_not_parallel", "rexs_no_shaft"} <= {*keys(found, "left")}


def test_place_and_coordinate_that_differ_are_named() -> None:
    found = read(shaft_on_two().set(6, u_coordinate_on_shaft_inner_side=("12", "mm")))
    assert found.machine.bearings[0].position == 0.010
    assert keys(found, "inferred") == ["rexs_places_differ"]


@pytest.mark.parametrize("length", ["5", "25"])
def test_sections_with_a_gap_are_filled(length: str) -> None:
    model = shaft_on_two().set(4, length=(str(40 - float(length)), "mm"))
    found = read(model)
    assert found.machine.shafts[0].length == pytest.approx(0.1)
    assert found.machine.shafts[0].sections[1].diameter == 0.025
    assert keys(found, "inferred") == ["rexs_gap"]


def test_sections_that_overlap_are_refused() -> None:
    assert "overlap by 5 mm" in refused(shaft_on_two().set(4, length=("45", "mm")))


def test_shafts_of_one_name_are_told_apart_by_their_ids() -> None:
    model = gear_pair()
    model.components[20]["name"] = "Welle"
    found = read(model)
    assert [shaft.name for shaft in found.machine.shafts] == ["Welle", "Welle (20)"]
    assert "rexs_named_again" in keys(found, "inferred")


# --- bearings -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("word", "designation", "size", "key"),
    [
        ("radial_self_aligning_roller_bearing", "22210", (50, 90, 23), "spherical"),
        ("radial_tapered_roller_bearing", "30206", (30, 62, 17.25), "tapered"),
        ("angular_contact_ball_bearing", "7206B", (30, 62, 16), "angular_contact"),
        ("radial_self_aligning_ball_bearing", "1206", (30, 62, 16), "self_aligning"),
        ("radial_roller_bearing", "NJ206", (30, 62, 16), "cylindrical"),
    ],
)
def test_words_of_types(word: str, designation: str, size: tuple[float, ...], key: str) -> None:
    model = shaft_on_two().set(
        6, bearing_type=word, catalogue_designation=designation, axial_force_absorption="positive",
        **{name: (str(value), "mm") for name, value in
           zip(("inner_diameter", "outer_diameter", "width"), size, strict=True)},
    )  # fmt: skip
    found = read(model)
    bearing = found.machine.bearings[0]
    assert bearing.case.bearing.listed_type.key == key
    assert "rexs_type_misleads" not in keys(found, "inferred")
    one_way = bearing.case.bearing.carries_one_way and not bearing.case.bearing.is_set
    assert (bearing.faces, bearing.located)[not one_way] in ("+x", "both")


def test_a_word_that_misleads_is_named() -> None:
    """The barrel roller bearing is called "spherical", the spherical one "self-aligning"."""
    found = read(
        shaft_on_two().set(6, catalogue_designation="22210", inner_diameter=("50", "mm"),
                           outer_diameter=("90", "mm"), width=("23", "mm"),
                           bearing_type="radial_spherical_roller_bearing")
    )  # fmt: skip
    assert found.machine.bearings[0].case.bearing.listed_type.key == "spherical"
    assert "rexs_type_misleads" in keys(found, "inferred")


@pytest.mark.parametrize("u", [1, -1])
@pytest.mark.parametrize("word", ["positive", "negative"])
def test_the_u_axis_of_a_bearing_may_oppose_its_shafts(u: int, word: str) -> None:
    model = shaft_on_two().set(6, axial_force_absorption=word, u_axis_vector=vector(u, 0, 0))
    sign = u if word == "positive" else -u
    assert read(model).machine.bearings[0].located == ("+x" if sign > 0 else "-x")


def test_an_unknown_designation_gives_way_to_the_size() -> None:
    found = read(shaft_on_two().set(6, catalogue_designation="XYZ-1"))
    assert found.machine.bearings[0].designation == "6305"
    assert keys(found, "inferred") == ["rexs_by_size"]


def test_a_designation_of_another_size_does_not_count() -> None:
    found = read(shaft_on_two().set(6, catalogue_designation="6205"))
    assert found.machine.bearings[0].designation == "6305"
    assert keys(found, "inferred") == ["rexs_other_sizes", "rexs_by_size"]


def test_the_name_of_a_component_may_be_its_designation() -> None:
    model = shaft_on_two().drop(6, "catalogue_designation")
    model.components[6]["name"] = "Lager 6305-Z [6]"
    found = read(model)
    assert found.machine.bearings[0].designation == "6305-Z"
    assert keys(found, "inferred") == ["rexs_by_name"]


def test_a_clearance_class_is_of_the_designation() -> None:
    found = read(shaft_on_two().set(6, radial_clearance_class="C3"))
    assert found.machine.bearings[0].designation == "6305/C3"


def test_a_bearing_that_nobody_knows_is_left_out() -> None:
    model = shaft_on_two().set(7, catalogue_designation="?", inner_diameter=("25.1", "mm"))
    found = read(model)
    assert [one.name for one in found.machine.bearings] == ["Lager A"]
    assert "rexs_bearing_unknown" in keys(found, "left")


def test_geometry_of_rows_and_balls() -> None:
    model = shaft_on_two().set(6, catalogue_designation="special", inner_diameter=("26", "mm"),
                               radial_bearing_clearance=("12", "mum"))  # fmt: skip
    model.set(9, number_of_rolling_elements="8",
              reference_diameter_rolling_bearing=("44", "mm"),
              raceway_radius_of_inner_ring=("5.15", "mm"),
              raceway_radius_of_outer_ring=("5.30", "mm"))  # fmt: skip
    model.add(10, "rolling_element", 9, "", diameter_of_rolling_element=("10", "mm"))
    bearing = read(model).machine.bearings[0].case.bearing
    assert (bearing.ball_count, bearing.ball_diameter) == (8, 0.010)
    assert (bearing.inner_conformity, bearing.outer_conformity) == (0.515, 0.53)
    assert (bearing.pitch_diameter, bearing.diametral_clearance) == (0.044, 12e-6)


def test_geometry_of_rows_and_rollers() -> None:
    model = shaft_on_two().set(7, catalogue_designation="special", inner_diameter=("26", "mm"))
    model.add(11, "rolling_bearing_row", 7, "", number_of_rolling_elements="12",
              reference_diameter_rolling_bearing=("39", "mm"),
              significant_contact_length_inner_ring=("6.9", "mm"))  # fmt: skip
    model.add(12, "rolling_element", 11, "", diameter_of_rolling_element=("7.5", "mm"),
              length_of_rolling_element=("7.5", "mm"))  # fmt: skip
    found = read(model)
    bearing = found.machine.bearings[1].case.bearing
    assert (bearing.roller_count, bearing.effective_length) == (12, 6.9e-3)
    assert "rexs_no_clearance" in keys(found, "inferred")


def test_a_ring_on_the_casing_is_left_out() -> None:
    model = shaft_on_two()
    model.relations = [one for one in model.relations if one[0] != 6]
    model.relations.append(side(6, 7, 2, 3))
    assert "rexs_ring_on_casing" in keys(read(model), "left")


def test_a_bearing_between_two_shafts() -> None:
    model = shaft_on_two()
    model.add(60, "shaft", 1, "hohl", **at(1, 10, 0, 0), rotational_speed=("-300", "1 / min"))
    model.add(61, "shaft_section", 60, "", length=("100", "mm"), outer_diameter_begin=("80", "mm"),
              inner_diameter_begin=("62", "mm"), inner_diameter_end=("62", "mm"))  # fmt: skip
    model.add(62, "rolling_bearing_with_catalog_geometry", None, "Lager C", **at(60, 50, 0, 0),
              catalogue_designation="6216", bearing_type="radial_grooved_ball_bearing")  # fmt: skip
    model.relations = [one for one in model.relations if one[0] != 6]
    model.relations += [side(6, 7, 3, 60), side(562, 62, 60, 2)]
    found = read(model)
    assert found.machine.bearings[1].outer_shaft == "hohl"


def test_fits_temperatures_and_preload() -> None:
    model = shaft_on_two().set(
        6, shaft_tolerance_class="k5", casing_bore_tolerance_class="H6",
        mean_operating_temperature_inner_ring=("80", "C"), preload_distance=("3", "mum"),
    )  # fmt: skip
    bearing = read(model).machine.bearings[0]
    assert bearing.case.mounting is not None
    assert bearing.case.mounting.shaft_tolerance == "k5"
    assert bearing.case.temperature is not None
    assert bearing.case.temperature.inner_ring == pytest.approx(353.15)
    assert bearing.offset == pytest.approx(3e-6)


def test_what_a_type_does_not_take_is_left_out_with_the_reason() -> None:
    found = read(shaft_on_two().set(7, preload_force=("500", "N")))
    assert found.machine.bearings[1].preload is None


def test_lubricant_temperatures_and_gravity() -> None:
    model = shaft_on_two()
    model.set(2, temperature_lubricant=("70", "C"), mean_operating_temperature=("60", "C"))
    model.set(1, account_for_gravity="true", direction_vector_gravity_u="0.0",
              direction_vector_gravity_v="0.0", direction_vector_gravity_w="-1.0",
              gravitational_acceleration=("9.81", "m / s^2"), model_name="Getriebe")  # fmt: skip
    model.add(70, "lubricant", None, "Oil", name="CLP 220", kind="oil",
              viscosity_at_40_degree_celsius=("220", "mm^2 / s"),
              viscosity_at_100_degree_celsius=("19", "mm^2 / s"),
              density_at_15_degree_celsius=("0.89", "kg / dm^3"))  # fmt: skip
    model.relations.append((570, "reference", {"origin": 2, "referenced": 70}))
    machine = read(model).machine
    assert machine.title == "Getriebe"
    assert machine.gravity is not None
    assert machine.gravity.vector == (0.0, 0.0, -9.81)
    assert machine.lubricant is not None
    assert machine.lubricant.viscosity_40 == pytest.approx(220e-6)
    assert machine.lubricant.density == pytest.approx(890.0)
    assert machine.temperature is not None
    assert machine.temperature.lubricant == pytest.approx(343.15)


def test_a_lubricant_by_its_curve_or_its_name() -> None:
    curve = shaft_on_two()
    curve.add(70, "lubricant", None, "Oil",
              temperature_variation_lubricant_viscosity=(texts([40.0, 70.0, 100.0]), "C"),
              temperature_dependent_kinematic_viscosity=(
                  texts([220.0, 60.0, 19.0]), "mm^2 / s"
              ))  # fmt: skip
    found = read(curve).machine.lubricant
    assert found is not None
    assert found.viscosities is not None
    named = shaft_on_two().add(70, "lubricant", None, "ISO VG 220")
    assert read(named).machine.lubricant is not None
    neither = read(shaft_on_two().add(70, "lubricant", None, "Öl"))
    assert neither.machine.lubricant is None
    assert "rexs_lubricant" in keys(neither, "left")


def test_a_mass_with_its_eccentricity() -> None:
    model = shaft_on_two()
    model.add(80, "additional_mass", 3, "Rad", **at(3, 50, 0, 0), mass_of_component=("4", "kg"),
              moment_of_inertia_u_axis=("0.02", "kg m^2"),
              moment_of_inertia_v_axis=("0.012", "kg m^2"),
              eccentricity_vector=vector(0, 0.01, 0))  # fmt: skip
    (mass,) = read(model).machine.masses
    assert (mass.mass, mass.polar_inertia, mass.transverse_inertia) == (4.0, 0.02, 0.012)
    assert mass.unbalance == pytest.approx(4e-5)
    assert mass.unbalance_azimuth == pytest.approx(math.pi / 2.0)


# --- gears ----------------------------------------------------------------------------------------


def test_tooth_forces_follow_from_the_torque() -> None:
    found = read(gear_pair())
    pinion, wheel = found.machine.gears
    power = 50.0 * 1500.0 * math.pi / 30.0
    assert pinion.drives is True
    assert pinion.power == pytest.approx(power)
    assert pinion.mesh_azimuth == pytest.approx(0.0)  # the wheel is toward +w
    assert (pinion.teeth, pinion.module) == (20, 0.002)
    assert wheel.mate == "Ritzel"
    assert found.machine.shafts[1].ratio == -0.5
    forces = {force.source: force.force for force in found.machine.forces()}
    assert forces["gears.0"][1] == pytest.approx(2500.0)
    assert forces["gears.1"][3] == pytest.approx(-100.0)
    (load,) = (one for one in found.machine.loads if one.name == "Abtriebslast")
    assert load.mx == pytest.approx(100.0)


def test_a_wheel_that_is_driven_backward_gives_its_power_to_the_pinion() -> None:
    model = gear_pair().set(8, torque_around_u_axis=("-50", "N m"))
    pinion, wheel = sorted(read(model).machine.gears, key=lambda one: one.name, reverse=True)
    assert (pinion.name, wheel.name) == ("Ritzel", "Rad")
    assert wheel.drives is True
    assert pinion.mate == "Rad"


def test_power_instead_of_torque() -> None:
    model = gear_pair().drop(8, "torque_around_u_axis").set(8, power=("7.5", "kW"))
    found = read(model)
    assert found.machine.gears[0].power == pytest.approx(7500.0)
    assert "rexs_torque_of_power" in keys(found, "inferred")


@pytest.mark.parametrize("word", ["30", "-30"])
def test_helical_gears_have_opposite_hands(word: str) -> None:
    model = gear_pair().set(30, helix_angle_reference_diameter=(word, "deg"))
    model.set(31, helix_angle_reference_diameter=(str(-float(word)), "deg"))
    distance = 60.0 / math.cos(math.radians(30.0))
    model.set(20, **at(1, 10, 0, distance))
    found = read(model)
    hands = {gear.name: gear.hand for gear in found.machine.gears}
    assert hands == ({"Ritzel": "right", "Rad": "left"} if word == "30" else
                     {"Ritzel": "left", "Rad": "right"})  # fmt: skip
    assert "rexs_operating_mesh" not in keys(found, "inferred")


def test_profile_shift_moves_the_pitch_circles() -> None:
    found = read(gear_pair().set(32, center_distance=("61.0", "mm")))
    pinion, wheel = found.machine.gears
    assert pinion.diameter == pytest.approx(2.0 * 0.061 / 3.0)
    assert pinion.diameter + wheel.diameter == pytest.approx(0.122)
    assert math.cos(pinion.pressure_angle) == pytest.approx(math.cos(math.radians(20)) * 60 / 61)
    assert "rexs_operating_mesh" in keys(found, "inferred")


def test_a_gear_between_two_others_has_two_meshes() -> None:
    model = gear_pair().drop(33, "transmits_torque")
    model.add(40, "shaft", 1, "Dritte", **at(1, 10, 0, 60 + 2.0 * 30))
    model.add(41, "shaft_section", 40, "", length=("100", "mm"), outer_diameter_begin=("30", "mm"))
    for number, place in ((42, 10), (43, 90)):
        model.add(number, "rolling_bearing_with_catalog_geometry", None, f"Dritte {place}",
                  **at(40, place, 0, 0), catalogue_designation="6206")  # fmt: skip
        model.relations.append(side(500 + number, number, 40, 2))
    model.add(44, "cylindrical_gear", 40, "Drittes Rad", **at(40, 60, 0, 0),
              number_of_teeth="20", normal_module=("2", "mm"))  # fmt: skip
    model.add(45, "cylindrical_stage", 1)
    model.relations.append((601, "stage", {"stage": 45, "gear_1": 31, "gear_2": 44}))
    model.add(46, "external_load", 40, "Last", transmits_torque="true",
              u_coordinate_on_shaft=("100", "mm"))  # fmt: skip
    machine = read(model).machine
    assert len(machine.gears) == 4
    forces = {force.name: force.force for force in machine.forces() if "gears" in force.source}
    # the tangential forces of both meshes of the wheel add up, the radial ones cancel
    across = [force for name, force in forces.items() if name.startswith("Rad")]
    assert sum(force[1] for force in across) == pytest.approx(-2.0 * 2500.0)
    assert sum(force[2] for force in across) == pytest.approx(0.0, abs=1e-9)
    assert sum(force[3] for force in across) == pytest.approx(0.0, abs=1e-9)
    assert analyse_machine(machine).converged


def test_forces_that_are_given_count() -> None:
    model = gear_pair()
    for number, sign in ((30, 1.0), (31, -1.0)):
        model.set(number, force_acting_on_shaft_v=(str(2500.0 * sign), "N"),
                  force_acting_on_shaft_w=(str(-910.0 * sign), "N"),
                  torque_acting_on_shaft_u=("-50", "N m"))  # fmt: skip
    found = read(model)
    assert found.machine.gears == ()
    loads = {load.name: load for load in found.machine.loads}
    assert loads["Ritzel"].forces() == (0.0, 2500.0, -910.0, -50.0, 0.0, 0.0)
    assert loads["Ritzel"].position == 0.060


def test_a_mesh_without_torque_is_named() -> None:
    found = read(gear_pair().drop(8, "torque_around_u_axis"))
    assert found.machine.gears == ()
    assert keys(found, "left").count("rexs_mesh_left") == 2


def test_an_internal_gear_is_named() -> None:
    model = gear_pair().set(31, number_of_teeth="-40")
    model.set(20, rotational_speed=("750", "1 / min"), **at(1, 10, 0, 20))
    found = read(model)
    assert found.machine.gears == ()
    assert "rexs_internal_gear" in keys(found, "left")


def bevel_pair(**pinion: object) -> Model:
    """A pinion of 20 teeth on the shaft along x, a wheel of 30 on one that crosses it at 130."""
    model = shaft_on_two().set(8, torque_around_u_axis=("50", "N m"), transmits_torque="true")
    across = {"u_axis_vector": vector(0, 0, 1), "w_axis_vector": vector(1, 0, 0)}
    model.add(20, "shaft", 1, "Quer", **{**at(1, 130, 0, 10), **across},
              rotational_speed=("1000", "1 / min"))  # fmt: skip
    model.add(21, "shaft_section", 20, "", length=("100", "mm"), outer_diameter_begin=("30", "mm"))
    for number, place in ((22, 40), (23, 90)):
        model.add(number, "rolling_bearing_with_catalog_geometry", None, f"Quer {place}",
                  **at(20, place, 0, 0), catalogue_designation="6206")  # fmt: skip
        model.relations.append(side(500 + number, number, 20, 2))
    model.add(
        30,
        "bevel_gear",
        3,
        "Ritzel",
        **at(3, 90, 0, 0),
        number_of_teeth="20",
        mean_normal_module=("2", "mm"),
        normal_pressure_angle=("20", "deg"),
        **pinion,
    )
    model.add(31, "bevel_gear", 20, "Rad", **at(20, 10, 0, 0), number_of_teeth="30",
              mean_normal_module=("2", "mm"), normal_pressure_angle=("20", "deg"))  # fmt: skip
    model.add(32, "bevel_stage", 1)
    model.relations.append((600, "stage", {"stage": 32, "gear_1": 30, "gear_2": 31}))
    return model


def test_a_bevel_gear_has_the_forces_of_the_power_of_its_shaft() -> None:
    found = read(bevel_pair())
    (gear,) = found.machine.gears
    assert (gear.kind, gear.apex, gear.drives) == ("bevel", "+x", True)
    assert gear.position == pytest.approx(0.090)
    assert gear.diameter == pytest.approx(0.040)
    cone, pressed = math.atan2(20, 30), 2500.0 * math.tan(math.radians(20))
    (force,) = [one.force for one in found.machine.forces() if "gears" in one.source]
    moment = 0.02 * pressed * math.sin(cone)
    assert force == pytest.approx(
        (-pressed * math.sin(cone), 2500.0, -pressed * math.cos(cone), -50.0, -moment, 0.0)
    )
    assert "rexs_bevel" in keys(found, "inferred")
    assert "rexs_not_parallel" in keys(found, "left")


@pytest.mark.parametrize("spiral", [0.0, 35.0])
def test_both_gears_of_a_bevel_stage_push_each_other(spiral: float) -> None:
    def slanted(hand: str) -> dict[str, object]:
        return {"mean_spiral_angle": (str(spiral), "deg"), "spiral_angle_pitch_direction": hand}

    model = bevel_pair().set(30, **slanted("left_handed")).set(31, **slanted("right_handed"))
    size = 40.0 / math.cos(math.radians(spiral))
    for number, diameter in ((30, size), (31, 1.5 * size)):
        model.set(number, mean_pitch_diameter=(repr(diameter), "mm"))
    for one in (3, 20):  # room for the larger gears
        model.set(4 if one == 3 else 21, length=("40" if one == 3 else "200", "mm"))
    (pinion,) = [one.force for one in read(model).machine.forces() if "gears" in one.source]
    # the same stage, and the other shaft the first one: x there is z here, y is -y, z is x
    model.components = {20: model.components.pop(20), **model.components}
    model.drop(8, "torque_around_u_axis", "transmits_torque")
    model.add(33, "external_load", 20, "Last", u_coordinate_on_shaft=("100", "mm"),
              torque_around_u_axis=("-75", "N m"))  # fmt: skip
    found = read(model)
    (wheel,) = [one.force for one in found.machine.forces() if "gears" in one.source]
    assert not found.machine.gears[0].drives
    assert (wheel[2], -wheel[1], wheel[0]) == pytest.approx(tuple(-one for one in pinion[:3]))


def test_a_bevel_gear_without_torque_or_mate_is_named() -> None:
    for model in (
        bevel_pair().drop(8, "torque_around_u_axis"),
bevel_pair().set(20, support_vector=vector(130, 20, 10)),  # axes that do not cross
        bevel_pair().set(31, number_of_teeth="0").drop(31, "mean_normal_module"),
    ):  # fmt: skip
        found = read(model)
        assert found.machine.gears == ()
        assert "rexs_mesh_left" in keys(found, "left")
    lonely = bevel_pair()
    lonely.relations = [one for one in lonely.relations if one[1] != "stage"]
    assert read(lonely).machine.gears == ()


@pytest.mark.parametrize("kind", ["bevel_gear", "worm_gear", "worm_wheel", "ring_gear"])
def test_forces_of_any_gear_count_where_they_are_given(kind: str) -> None:
    model = bevel_pair()
    model.components[30]["type"] = kind
    model.set(30, force_acting_on_shaft_u=("-700", "N"), force_acting_on_shaft_v=("2500", "N"))
    found = read(model)
    load = next(one for one in found.machine.loads if one.name == "Ritzel")
    assert load.forces()[:2] == (-700.0, 2500.0)


@pytest.mark.parametrize("kind", ["worm_gear", "worm_wheel", "ring_gear"])
def test_other_gears_without_forces_are_named(kind: str) -> None:
    model = bevel_pair()
    model.components[30]["type"] = kind
    key = "rexs_internal_gear" if kind == "ring_gear" else "rexs_mesh_left"
    assert key in keys(read(model), "left")


# --- load cases -----------------------------------------------------------------------------------


def with_cases(*cases: tuple[str, str, str]) -> Model:
    """Load cases of a speed, a force across the shaft and a share."""
    model = shaft_on_two().drop(3, "rotational_speed").drop(8, "force_w_direction",
                                                            "force_u_direction")  # fmt: skip
    model.cases = [
        (number, {1: {"operating_time_fraction": (share, "%")},
                  3: {"rotational_speed": (speed, "1 / min")},
                  8: {"force_w_direction": (force, "N"), "force_v_direction": ("100", "N")
                      if number == 3 else ("0", "N")}})
        for number, (speed, force, share) in enumerate(cases, start=1)
    ]  # fmt: skip
    return model


@pytest.mark.parametrize("container", ["xml", "json"])
def test_load_cases_that_two_factors_tell_apart_are_a_spectrum(container: str) -> None:
    model = with_cases(("1000", "-2000", "25"), ("1500", "-500", "75"))
    found = machine_of_rexs(parse_rexs(getattr(model, container)()))
    one, other = found.machine.spectrum
    assert (one.share, one.speed_factor, one.load_factor) == (0.25, 1.0, 1.0)
    assert (other.share, other.speed_factor, other.load_factor) == (0.75, 1.5, 0.25)
    assert found.machine.loads[0].fz == -2000.0


def test_other_load_cases_are_taken_one_by_one() -> None:
    model = with_cases(("1000", "-2000", "25"), ("1500", "-500", "25"), ("900", "-700", "50"))
    found = read(model)
    assert found.machine.spectrum == ()
    assert found.machine.loads[0].fz == -2000.0
    assert "rexs_load_cases" in keys(found, "left")
    third = read(model, 3)
    assert third.machine.loads[0].forces()[:3] == (0.0, 100.0, -700.0)
    with pytest.raises(FileError, match="is no load case of the file; it has 1, 2, 3"):
        read(model, 4)


# --- what nobody knows ----------------------------------------------------------------------------


def test_unknown_parts_and_attributes_are_named_and_no_error() -> None:
    model = shaft_on_two().set(3, surface_finish="blank", custom_maker_colour="red")
    model.add(90, "flux_capacitor", 1, "", power=("1.21", "GW"))
    model.relations.append(assembly_of_nothing := (900, "assembly", {"assembly": 1, "part": 99}))
    assert assembly_of_nothing
    found = read(model)
    assert found.machine == Machine.from_mapping(EXPECTED)
    left = {remark.note.key: remark.note.values for remark in found.of_sort("left")}
    assert left["rexs_components_left"]["type"] == "flux_capacitor"
    told = str(Note("rexs_components_left", left["rexs_components_left"]))
    assert told == "1 component flux_capacitor is not read: 90."
    assert "custom_maker_colour, surface_finish" in [
        remark.note.values.get("attributes") for remark in found.of_sort("left")
    ]
    assert left["rexs_missing_component"]["id"] == 99


def test_the_list_is_plain_data() -> None:
    mapping = read(gear_pair()).to_mapping()
    again = json.loads(json.dumps(mapping))
    assert again == mapping
    parts = {one["part"]: one for one in mapping["taken"] if one["part"]}
    assert {"shafts.0", "bearings.0", "loads.0", "gears.1"} <= {*parts}
    assert "rotational_speed" in parts["shafts.0"]["attributes"]
    assert {"component", "key", "text", "values"} == {*mapping["inferred"][0]}


@pytest.mark.parametrize(
    ("model", "expected"),
    [
        (Model("2.0", [], []), "has no shaft with sections"),
        (Model("2.0", [{"id": 1, "type": "gear_unit", "name": "", "attributes": {}}], []),
         "has no shaft with sections"),
    ],
)  # fmt: skip
def test_a_model_that_is_no_machine_is_refused(model: Model, expected: str) -> None:
    assert expected in refused(model)


def test_a_model_without_bearings_is_refused() -> None:
    model = shaft_on_two()
    del model.components[6], model.components[7]
    assert "at least one bearing" in refused(model)


@pytest.mark.parametrize(
    "kind", ["shaft", "rolling_bearing_with_catalog_geometry", "external_load"]
)
def test_more_than_a_machine_has_is_refused_soon(kind: str) -> None:
    model = shaft_on_two()
    for number in range(1000, 6000):
        model.add(number, kind, None, "many")
    assert f"{kind}: is there 500" in refused(model)
