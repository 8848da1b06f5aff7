"""REXS models for the tests, written by hand: a shaft on two bearings, and a pair of gears."""

from __future__ import annotations

import io
import json
import re
import zipfile
from collections.abc import Mapping, Sequence
from typing import Any

Attributes = Mapping[str, Any]
"""Values by attribute: a text, a list of texts, or a pair of value and unit."""

POSE = {"u_axis_vector": (["1.0", "0.0", "0.0"], "mm"), "w_axis_vector": (["0", "0", "1"], "mm")}


def at(reference: int, *place: float, **turned: Any) -> dict[str, Any]:
    """Attributes of a pose."""
    return {
        "support_vector": ([str(one) for one in place], "mm"),
        **POSE,
        "reference_component_for_position": str(reference),
        **turned,
    }


def component(number: int, kind: str, name: str = "", /, **attributes: Any) -> dict[str, Any]:
    return {"id": number, "type": kind, "name": name, "attributes": attributes}


def assembly(number: int, whole: int, part: int) -> tuple[int, str, dict[str, int]]:
    return number, "assembly", {"assembly": whole, "part": part}


def side(number: int, bearing: int, inner: int, outer: int) -> tuple[int, str, dict[str, int]]:
    return number, "side", {"assembly": bearing, "inner_part": inner, "outer_part": outer}


class Model:
    """A model as plain data, which a test may change before it is written."""

    def __init__(
        self, version: str, components: list[dict[str, Any]],
        relations: list[tuple[int, str, dict[str, int]]],
    ) -> None:  # fmt: skip
        self.version = version
        self.components = {one["id"]: one for one in components}
        self.relations = relations
        self.cases: list[tuple[int, dict[int, Attributes]]] = []

    def set(self, number: int, **attributes: Any) -> Model:
        self.components[number]["attributes"].update(attributes)
        return self

    def drop(self, number: int, *names: str) -> Model:
        for name in names:
            del self.components[number]["attributes"][name]
        return self

    def add(
        self, number: int, kind: str, whole: int | None = None, name: str = "", /, **attributes: Any
    ) -> Model:  # fmt: skip
        self.components[number] = component(number, kind, name, **attributes)
        if whole is not None:
            self.relations.append(assembly(1000 + number, whole, number))
        return self

    # --- containers -------------------------------------------------------------------------------

    def xml(self) -> bytes:
        lines = [
            '<?xml version="1.0" encoding="UTF-8" standalone="no"?>',
            '<model applicationId="Test" applicationVersion="1" date="2026-01-01T00:00:00+00:00"'
            f' version="{self.version}">',
            "<relations>",
        ]
        for number, kind, roles in self.relations:
            order = ' order="1"' if kind.startswith("ordered") else ""
            refs = "".join(f'<ref hint="x" id="{one}" role="{role}"/>'
                           for role, one in roles.items())  # fmt: skip
            lines.append(f'<relation id="{number}"{order} type="{kind}">{refs}</relation>')
        lines += ["</relations>", "<!-- Bauteile -->", "<components>"]
        lines += [_as_xml(one) for one in self.components.values()]
        lines.append("</components>")
        if self.cases:
            lines.append('<load_spectrum id="1">')
            for number, own in self.cases:
                lines.append(f'<load_case id="{number}">')
                for key, attributes in own.items():
                    kind = self.components[key]["type"]
                    lines.append(_as_xml(component(key, kind, **attributes)))
                lines.append("</load_case>")
            lines.append("</load_spectrum>")
        return "\n".join([*lines, "</model>"]).encode()

    def json(self) -> bytes:
        model: dict[str, Any] = {
            "version": self.version,
            "applicationId": "Test",
            "applicationVersion": "1",
            "date": "2026-01-01T00:00:00+00:00",
            "relations": [
                {"id": number, "type": kind,
                 **({"order": 1} if kind.startswith("ordered") else {}),
                 "refs": [{"id": one, "role": role, "hint": "x"} for role, one in roles.items()]}
                for number, kind, roles in self.relations
            ],
            "components": [_as_json(one) for one in self.components.values()],
        }  # fmt: skip
        if self.cases:
            model["load_spectrum"] = {"id": 1, "load_cases": [
                {"id": number, "components": [
                    _as_json(component(key, self.components[key]["type"], **attributes))
                    for key, attributes in own.items()
                ]}
                for number, own in self.cases
            ]}  # fmt: skip
        return json.dumps({"model": model}).encode()

    def zipped(self, inner: str = "gear.rexs") -> bytes:
        file = io.BytesIO()
        with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
            content = self.json() if inner.endswith("j") else self.xml()
            archive.writestr(inner, content)
            archive.writestr("cad/casing.stp", b"nothing to see")
        return file.getvalue()


def _pair(value: Any) -> tuple[Any, str]:
    return value if isinstance(value, tuple) else (value, "none")


def _as_xml(one: Mapping[str, Any]) -> str:
    inner = []
    for name, given in one["attributes"].items():
        value, unit = _pair(given)
        text = (
            f"<array>{''.join(f'<c>{cell}</c>' for cell in value)}</array>"
            if isinstance(value, list)
            else str(value)
        )
        inner.append(f'<attribute id="{name}" unit="{unit}">{text}</attribute>')
    return (
        f'<component id="{one["id"]}" name="{one["name"]}" type="{one["type"]}">'
        f"{''.join(inner)}</component>"
    )


def _as_json(one: Mapping[str, Any]) -> dict[str, Any]:
    attributes = []
    for name, given in one["attributes"].items():
        value, unit = _pair(given)
        form: str
        if isinstance(value, list):
            form, value = "floating_point_array", [float(cell) for cell in value]
        elif value in ("true", "false"):
            form, value = "boolean", value == "true"
        elif re.fullmatch(r"-?\d+", str(value)):
            form, value = "integer", int(value)
        elif re.fullmatch(r"-?[\d.]+(e-?\d+)?", str(value), re.IGNORECASE):
            form, value = "floating_point", float(value)
        else:
            form = "string"
        attributes.append({"id": name, "unit": unit, form: value})
    return {"id": one["id"], "type": one["type"], "name": one["name"], "attributes": attributes}


# --- models ---------------------------------------------------------------------------------------


def shaft_on_two(version: str = "2.0") -> Model:
    """A shaft of 100 mm of two sections on a 6305 and an NU 205, pulled in the middle."""
    old = version.startswith("1")
    designation = "name" if old else "catalogue_designation"
    rating = "dynamic_capacity" if old else "radial_dynamic_load_rating"
    static = "static_capacity" if old else "radial_static_load_rating"
    degree = "°" if old else "deg"
    return Model(
        version,
        [
            component(1, "gear_unit", "Unit", **at(1, 0, 0, 0)),
            component(2, "gear_casing"),
            component(3, "shaft", "Welle [3]", **at(1, 10, 0, 0),
                      rotational_speed=("1500", "1 / min"), defines_speed="true"),
            component(4, "shaft_section", length=("40.0", "mm"),
                      u_coordinate_on_shaft=("0.0", "mm"),
                      outer_diameter_begin=("25.0", "mm"), outer_diameter_end=("25.0", "mm"),
                      inner_diameter_begin=("0.0", "mm"), inner_diameter_end=("0.0", "mm")),
            component(5, "shaft_section", length=("60.0", "mm"),
                      u_coordinate_on_shaft=("40.0", "mm"),
                      outer_diameter_begin=("30.0", "mm"), outer_diameter_end=("26.0", "mm"),
                      inner_diameter_begin=("10.0", "mm"), inner_diameter_end=("8.0", "mm")),
            component(6, "rolling_bearing_with_catalog_geometry", "Lager A [6]",
                      **at(1, 20, 0, 0),
                      **{designation: "6305", rating: ("22.4", "kN"), static: ("11.4", "kN")},
                      bearing_type="radial_grooved_ball_bearing",
                      inner_diameter=("25", "mm"), outer_diameter=("62", "mm"),
                      width=("17", "mm"), axial_force_absorption="both_directions",
                      axial_stiffness=("0.0", "N / m"),
                      radial_stiffness=("9.999999999999999E22", "N / m")),
            component(7, "rolling_bearing_with_catalog_geometry", "Lager B [7]",
                      **at(3, 85, 0, 0),
                      **{designation: "NU205"}, bearing_type="radial_roller_bearing",
                      inner_diameter=("25", "mm"), outer_diameter=("52", "mm"),
                      width=("15", "mm"), axial_force_absorption="no_direction"),
            component(8, "external_load", "Kraft [8]", u_coordinate_on_shaft=("50.0", "mm"),
                      force_w_direction=("-2.0", "kN"), force_u_direction=("300", "N"),
                      torque_around_u_axis=("0.0", "N m")),
            component(9, "rolling_bearing_row", pressure_angle=("0.0", degree)),
        ],
        [
            assembly(1, 1, 3), assembly(2, 3, 4), assembly(3, 3, 5), assembly(4, 3, 8),
            side(5, 6, 3, 2), side(6, 7, 3, 2),
            (7, "ordered_assembly", {"assembly": 6, "part": 9}),
        ],
    )  # fmt: skip


def gear_pair(version: str = "2.0") -> Model:
    """Two parallel shafts in mesh: the first is driven with 50 N·m, the second has a load."""
    model = shaft_on_two(version).set(8, torque_around_u_axis=("50", "N m"),
                                      transmits_torque="true")  # fmt: skip
    distance = 0.5 * 2.0 * (20 + 40)
    model.add(20, "shaft", 1, "Abtrieb", **at(1, 10, 0, distance))
    model.add(21, "shaft_section", 20, "", length=("100", "mm"),
              outer_diameter_begin=("30", "mm"), outer_diameter_end=("30", "mm"))  # fmt: skip
    for number, place in ((22, 10), (23, 90)):
        model.add(number, "rolling_bearing_with_catalog_geometry", None, f"Abtrieb {place}",
                  **at(20, place, 0, 0), catalogue_designation="6206",
                  bearing_type="radial_grooved_ball_bearing")  # fmt: skip
        model.relations.append(side(500 + number, number, 20, 2))
    for number, shaft, teeth, name in ((30, 3, 20, "Ritzel"), (31, 20, 40, "Rad")):
        model.add(number, "cylindrical_gear", shaft, name, **at(shaft, 60, 0, 0),
                  u_coordinate_on_shaft=("55", "mm"), face_width=("10", "mm"),
                  number_of_teeth=str(teeth), normal_module=("2", "mm"))  # fmt: skip
    model.add(32, "cylindrical_stage", 1)
    model.relations.append((600, "stage", {"stage": 32, "gear_1": 30, "gear_2": 31}))
    model.add(33, "external_load", 20, "Abtriebslast", transmits_torque="true",
              u_coordinate_on_shaft=("100", "mm"))  # fmt: skip
    return model


def vector(*numbers: float) -> tuple[list[str], str]:
    return [str(one) for one in numbers], "mm"


def texts(values: Sequence[float]) -> list[str]:
    return [repr(value) for value in values]
