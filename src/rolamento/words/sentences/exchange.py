"""What is said of what a file of another program holds."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from rolamento.words.sentences import Sentence
from rolamento.words.speaking import counted, marked, said

__all__ = ["SENTENCES"]


def _type_misleads(values: Mapping[str, Any]) -> str:
    return said(
        "The file calls it {word}, and {designation} is a {type} of the catalogue; the catalogue"
        " counts.",
        word=values["word"],
        designation=values["designation"],
        type=said(str(values["type"])),
    )


def _by_size(values: Mapping[str, Any]) -> str:
    text = said(
        "Of its type and size, {bore:.6g mm} × {outside:.6g mm} × {width:.6g mm}, the catalogue has"
        " {designation}.",
        **values,
    )
    count = int(values["count"])
    if count < 2:
        return text
    if values["rated"]:
        return said(
            "{text} It is the one of {count} whose load rating is nearest.", text=text, count=count
        )
    return said(
        "{text} It is the one of {count} with the lowest load rating.", text=text, count=count
    )


_DIRECTIONS: Final = {"positive": marked("positive"), "negative": marked("negative")}


def _axial_word(values: Mapping[str, Any]) -> str:
    return said(
        "It supports axial load in the {direction} direction of u: {key} = {value} here.",
        direction=said(_DIRECTIONS[str(values["word"])]),
        key=values["key"],
        value=values["value"],
    )


def _components_left(values: Mapping[str, Any]) -> str:
    return counted(
        "{n} component {type} is not read: {ids}.",
        "{n} components {type} are not read: {ids}.",
        int(values["count"]),
        type=values["type"],
        ids=values["ids"],
    )


SENTENCES: Final[dict[str, Sentence]] = {
    # inferred
    "rexs_named_again": marked("Several parts are called {name}; this one is {new} here."),
    "rexs_at_rest": marked("No speed is given or follows from the gears; the shaft is at rest."),
    "rexs_speed_by_teeth": marked("Its speed follows from the teeth of {gear} and {mate}."),
    "rexs_turned_shaft": marked(
        "Its u axis points against that of the others; it is laid out from its other end, and all"
        " on it with it."
    ),
    "rexs_axes": marked(
        "The shafts do not lie along u of the gear unit: x is the axis of {shaft}, y and z are its"
        " v and w."
    ),
    "rexs_gap": marked(
        "Between two sections {gap:.4g mm} are free; they are filled as thick as the thinner one."
    ),
    "rexs_by_name": marked("Its designation {designation} is that of its name."),
    "rexs_by_size": _by_size,
    "rexs_other_sizes": marked(
        "{designation} of the catalogue has {bore:.6g mm} × {outside:.6g mm}, the file says"
        " {given_bore:.6g mm} × {given_outside:.6g mm}; the designation does not count."
    ),
    "rexs_type_misleads": _type_misleads,
    "rexs_no_clearance": marked("No clearance is given; it is taken as zero."),
    "rexs_places_differ": marked(
        "Its place in space and its coordinate on the shaft differ by {difference:.4g mm}; the"
        " place in space counts."
    ),
    "rexs_power_flow": marked(
        "{power:.6g W} flow through the mesh of {gear} and {mate}, without losses, as the loads"
        " and the other meshes of the shaft leave it."
    ),
    "rexs_operating_mesh": marked(
        "At the centre distance of {distance:.6g mm} the gears mesh at α_n = {pressure:.4g °} and"
        " β = {helix:.4g °}; the module is that of the operating pitch circles."
    ),
    "rexs_bevel": marked(
        "{power:.6g W} flow through its mesh, as the loads and other meshes of its shaft leave"
        " them: it acts at the mean pitch circle of {diameter:.6g mm} of a cone of {cone:.4g °},"
        " whose apex is where the axes cross."
    ),
    "rexs_hand": marked("A positive helix angle is taken as right-handed."),
    "rexs_usual_density": marked(
        "No density is given; it is taken as 880 kg/m³, as of mineral oils."
    ),
    "rexs_pressure_angle": marked("No pressure angle is given; it is taken as 20°."),
    "rexs_balance": marked("The torque that the gears leave: {torque:.6g N·m}."),
    "rexs_torque_of_power": marked("Its torque is that of its power at the speed of the shaft."),
    "rexs_equal_shares": marked("The load cases have no time shares; they are taken as equal."),
    "rexs_forces_as_load": marked("The forces of its mesh are given; they count as a load."),
    "rexs_axial_word": _axial_word,
    # left out
    "rexs_components_left": _components_left,
    "rexs_attributes_left": marked("Attributes of {type} are not read: {attributes}."),
    "rexs_results_left": marked(
        "The results that the file holds are not read; `rolamento shaft` calculates anew."
    ),
    "rexs_no_mass": marked("It is left out: its mass is not given."),
    "rexs_missing_component": marked("Relation {relation} names component {id}, which is missing."),
    "rexs_not_parallel": marked(
        "It is not parallel to the other shafts; it is left out with all on it."
    ),
    "rexs_no_sections": marked("It has no sections; it is left out with all on it."),
    "rexs_no_shaft": marked("It stands on no shaft that was read."),
    "rexs_ring_on_casing": marked(
        "Its inner ring stands on the casing and its outer ring turns, which a machine file does"
        " not have."
    ),
    "rexs_bearing_unknown": marked(
        "It is left out: neither its geometry nor a designation or size of the catalogue tells"
        " what rolls in it."
    ),
    "rexs_bearing_refused": marked("It is left out: {reason}"),
    "rexs_table_refused": marked("Its {table} is left out: {reason}"),
    "rexs_no_place": marked("It is left out: its place on the shaft is not given."),
    "rexs_off_shaft": marked("It is left out: it is not on the shaft."),
    "rexs_one_way": marked(
        "A bearing of its type carries axial load one way alone; the file says {word}."
    ),
    "rexs_stiffness_unknown": marked("It is left out: its stiffness is rigid or not known."),
    "rexs_mesh_left": marked(
        "Its forces are left out: they are not given, and neither torque nor teeth and place of"
        " its mate tell them."
    ),
    "rexs_internal_gear": marked("Its forces are left out: it is an internal gear."),
    "rexs_misaligned": marked("The misalignment of its rings is left out."),
    "rexs_load_cases": marked(
        "{count} load cases differ by more than one factor of load and one of speed: load case"
        " {taken} is taken, the others are left out."
    ),
    "rexs_gravity": marked("Gravity is left out: it does not point along an axis."),
    "rexs_lubricant": marked("It is left out: its viscosities are not given."),
    "rexs_version": marked("Its version {version} is not one that is known (1.0 to 2.0)."),
    "rexs_changed": marked(
        "{keys} was changed after Rolamento had written it: what the file says otherwise counts."
    ),
    # written
    "rexs_kept_by_custom": marked(
        "{part}: {keys} stands in an attribute that only Rolamento reads."
    ),
    "rexs_as_loads": marked("{part}: other programs see a load with its forces."),
    "rexs_without_type": marked("{part}: REXS has no word for its type, {type}."),
    "rexs_unsolved": marked("Without results: {reason}"),
    # for simulations
    "fmu_between_points": marked(
        "Between its points the stiffness is linear: off by at most {apart:.2g %} of the greatest"
        " of its kind halfway between them; `points` takes more."
    ),
    # for ROSS
    "coupled_by_housing": marked(
        "{bearing}: its housing couples it to other bearings by up to {stiffness:.3g N/µm}, which"
        " is left out: an element of ROSS is of one bearing."
    ),
    "ross_no_lever": marked(
        "{bearing}: one element: it resists no tilt about any place of its shaft."
    ),
    "ross_lever_off_shaft": marked(
        "{bearing}: one element: two of them would have to stand {lever:.4g mm} from their middle,"
        " beyond the end of the shaft."
    ),
    "rexs_not_the_same": marked("Read back, it is not the same machine. {reason}"),
}
