"""FMI: a bearing as a force element in C, which simulation programs compile; 2.0 and 3.0.

Functional Mock-up Interface for Model Exchange and Co-Simulation 2.0 (2014) and Functional Mock-up
Interface 3.0 (2022), Modelica Association. The headers are those of the standard, under its
2-clause BSD licence, which stands in each of them; the other sources are ours.
"""

from __future__ import annotations

import hashlib
import io
import uuid
import zipfile
from collections.abc import Iterator
from importlib import resources
from typing import Any, Final
from xml.etree import ElementTree

import numpy as np

import rolamento
from rolamento.case.duty import AXES, LOADS
from rolamento.errors import InputError, arguments
from rolamento.exchange.tables import COLUMNS, about, identifiers
from rolamento.numerics import FloatArray
from rolamento.solved.maps import StiffnessMap
from rolamento.words import said

__all__ = ["VERSIONS", "between_points", "fmu_bytes"]

VERSIONS: Final = (2, 3)
_HEADERS: Final = {
    2: ("fmi2Functions.h", "fmi2FunctionTypes.h", "fmi2TypesPlatform.h"),
    3: ("fmi3Functions.h", "fmi3FunctionTypes.h", "fmi3PlatformTypes.h"),
}
_DAY: Final = (1980, 1, 1, 0, 0, 0)
"""The day of every file in it: the same map gives the same bytes."""
_SPACE: Final = uuid.UUID("6f0f4a3e-6c0f-5f0e-9b57-0d6f5c1a2b3c")
_BASE: Final = {
    "m": {"m": 1}, "rad": {"rad": 1}, "s": {"s": 1}, "m/s": {"m": 1, "s": -1},
    "rad/s": {"rad": 1, "s": -1}, "N": {"kg": 1, "m": 1, "s": -2},
    "N*m": {"kg": 1, "m": 2, "s": -2}, "K": {"K": 1}, "Pa": {"kg": 1, "m": -1, "s": -2},
    "W": {"kg": 1, "m": 2, "s": -3},
}  # fmt: skip
"""SI units of variables by their base units; others are written without a unit."""


def fmu_bytes(
    given: StiffnessMap, version: int, *, start: float | None = None, damping: float = 0.0
) -> bytes:
    """Return the FMU of a bearing: modelDescription.xml and sources in C.

    The force that the shaft puts on the inner ring follows from the displacement u of its rings
    against each other, their velocity v, and the quantity s over which the map goes,

        f = F(s) + K(s) (u - U(s)) + d K(s) v,

    linear between the points of the map, and held beyond its ends, where the output ``outside`` is
    true. It stands for model exchange and for co-simulation, and has derivatives.

    Parameters
    ----------
    given
        Over one field.
    version
        Of FMI: 2 or 3.
    start
        Of the quantity; the last point of the map if not given.
    damping
        s: d, where the simulation begins; a parameter.

    Raises
    ------
    InputError
        If there is no such version, the map is over two fields, or a point has no equilibrium.
    """
    if version not in VERSIONS:
        raise InputError(said("must be one of {known}", known="2, 3"), field="fmi",
                         value=version, example=arguments(fmi=3))  # fmt: skip
    if len(given.axes) > 1:
        raise InputError(
            said("can be given once: the element goes over one field"), field="over",
            value=given.axes[1].field,
        )  # fmt: skip
    if not given.converged:
        status = str(given.status[given.status != "converged"][0])
        raise InputError(
            said("has points without an equilibrium ({status}); give another range", status=status),
            field="over", value=given.name,
        )  # fmt: skip
    one = given.rising()
    values = one.axes[0].values
    begins = float(given.axes[0].values[-1]) if start is None else start
    (name,) = identifiers([one.name])
    table = _table(one, begins, damping)
    digest = hashlib.sha256(table.encode("utf-8")).hexdigest()
    token = f"{{{uuid.uuid5(_SPACE, digest)}}}"
    sources = ["element.c", f"fmi{version}.c", "table.c"]
    described = _Description(one, name, token, sources, begins, damping)
    files = {
        "modelDescription.xml": described.of_fmi2() if version == 2 else described.of_fmi3(),
        "sources/table.c": table.replace("TOKEN", token),
        "documentation/index.html": _documentation(one, values),
    }
    if version == 3:
        files["sources/buildDescription.xml"] = described.of_build()
    here = resources.files(__name__)
    for file in ("element.c", "element.h", f"fmi{version}.c"):
        files[f"sources/{file}"] = (here / file).read_text("utf-8")
    for file in _HEADERS[version]:
        files[f"sources/{file}"] = (here / "headers" / file).read_text("utf-8")
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w") as archive:
        for file, text in files.items():
            entry = zipfile.ZipInfo(file, _DAY)
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, text.encode("utf-8"))
    return content.getvalue()


def between_points(every: StiffnessMap) -> tuple[StiffnessMap, float]:
    """Return every second point of a map, and how far from linear the stiffness is between them.

    The greatest difference over the greatest stiffness of its kind (shifts, tilts, both).
    """
    some = slice(None, None, 2)
    axis = every.axes[0]
    kept = StiffnessMap(
        every.name, (type(axis)(axis.field, axis.unit, axis.values[some]),), every.stiffness[some],
        every.force[some], every.displacement[some], every.status[some], every.made_of, every.notes,
    )  # fmt: skip
    linear = 0.5 * (kept.stiffness[:-1] + kept.stiffness[1:])
    apart = np.abs(every.stiffness[1::2] - linear)
    size = np.abs(every.stiffness)
    worst = 0.0
    for rows, columns in (
        (slice(3), slice(3)),
        (slice(3), slice(3, 5)),
        (slice(3, 5), slice(3, 5)),
    ):
        most = float(size[:, rows, columns].max())
        if most > 0.0:
            worst = max(worst, float(apart[:, rows, columns].max()) / most)
    return kept, worst


# --- numbers --------------------------------------------------------------------------------------


def _table(one: StiffnessMap, start: float, damping: float) -> str:
    points = one.status.size
    return "".join([
        f"/* {points} operating points, SI; written by Rolamento {rolamento.__version__}. */\n\n",
        '#include "element.h"\n\n',
        'const char element_token[] = "TOKEN";\n',
        f"const int table_points = {points};\n",
        _array("table_quantity", one.axes[0].values[:, np.newaxis]),
        _array("table_force", one.force),
        _array("table_place", one.displacement),
        _array("table_stiffness", one.stiffness.reshape(points, 25)),
        f"const double start_quantity = {start!r};\n",
        f"const double start_damping = {damping!r};\n",
    ])  # fmt: skip


def _array(name: str, rows: FloatArray) -> str:
    lines = ",\n".join("    " + ", ".join(repr(one) for one in row) for row in rows.tolist())
    return f"const double {name}[] = {{\n{lines}\n}};\n"


# --- descriptions ---------------------------------------------------------------------------------


class _Description:
    """What an FMU says of itself."""

    def __init__(
        self,
        one: StiffnessMap,
        name: str,
        token: str,
        sources: list[str],
        start: float,
        damping: float,
    ) -> None:
        self._map, self._name, self._token, self._sources = one, name, token, sources
        self._variables = list(_variables(one, start, damping))

    def _head(self, version: str, **named: Any) -> ElementTree.Element:
        said_of = "; ".join(f"{name}: {value}" for name, value in about(self._map).items())
        return ElementTree.Element(
            "fmiModelDescription", fmiVersion=version, modelName=_in_xml(self._map.name),
            description=_in_xml(said_of), generationTool=f"Rolamento {rolamento.__version__}",
            variableNamingConvention="flat", **named,
        )  # fmt: skip

    def _units(self, root: ElementTree.Element) -> None:
        units = ElementTree.SubElement(root, "UnitDefinitions")
        for unit in dict.fromkeys(str(one["unit"]) for one in self._variables if one.get("unit")):
            base = {name: str(power) for name, power in _BASE[unit].items()}
            ElementTree.SubElement(
                ElementTree.SubElement(units, "Unit", name=unit), "BaseUnit", base
            )

    def of_fmi2(self) -> str:
        root = self._head("2.0", guid=self._token, numberOfEventIndicators="0")
        for kind in ("ModelExchange", "CoSimulation"):
            more: dict[str, Any] = {}
            if kind == "CoSimulation":
                more["canHandleVariableCommunicationStepSize"] = "true"
            face = ElementTree.SubElement(
                root, kind, modelIdentifier=self._name, providesDirectionalDerivative="true",
                canNotUseMemoryManagementFunctions="true", **more,
            )  # fmt: skip
            files = ElementTree.SubElement(face, "SourceFiles")
            for source in self._sources:
                ElementTree.SubElement(files, "File", name=source)
        self._units(root)
        variables = ElementTree.SubElement(root, "ModelVariables")
        places: dict[str, int] = {}
        for one in self._variables[1:]:  # without time
            places[one["name"]] = len(places) + 1
            own = {key: one[key] for key in ("name", "valueReference", "description", "causality",
                                             "variability")}  # fmt: skip
            scalar = ElementTree.SubElement(variables, "ScalarVariable", own)
            kind = "Boolean" if one["name"] == "outside" else "Real"
            value: dict[str, str] = {key: one[key] for key in ("unit", "start") if key in one}
            ElementTree.SubElement(scalar, kind, value)
        structure = ElementTree.SubElement(root, "ModelStructure")
        knowns = " ".join(str(places[one["name"]]) for one in self._of("input"))
        for heading in ("Outputs", "InitialUnknowns"):
            some = ElementTree.SubElement(structure, heading)
            for one in self._of("output"):
                of_all = one["name"] != "outside"
                depends = knowns if of_all else knowns.split()[-1]
                if heading == "InitialUnknowns" and of_all:
                    depends += f" {places['damping']}"
                ElementTree.SubElement(some, "Unknown", index=str(places[one["name"]]),
                               dependencies=depends)  # fmt: skip
        return _text(root)

    def of_fmi3(self) -> str:
        root = self._head("3.0", instantiationToken=self._token)
        for kind in ("ModelExchange", "CoSimulation"):
            more: dict[str, Any] = {}
            if kind == "CoSimulation":
                more["canHandleVariableCommunicationStepSize"] = "true"
            ElementTree.SubElement(
                root, kind, modelIdentifier=self._name, providesDirectionalDerivatives="true",
                providesAdjointDerivatives="true", **more,
            )  # fmt: skip
        self._units(root)
        variables = ElementTree.SubElement(root, "ModelVariables")
        for one in self._variables:
            kind = "Boolean" if one["name"] == "outside" else "Float64"
            ElementTree.SubElement(variables, kind, one)
        structure = ElementTree.SubElement(root, "ModelStructure")
        inputs = [one["valueReference"] for one in self._of("input")]
        parameter = next(one["valueReference"] for one in self._of("parameter"))
        for heading in ("Output", "InitialUnknown"):
            for one in self._of("output"):
                of_all = one["name"] != "outside"
                knowns = inputs if of_all else inputs[-1:]
                if heading == "InitialUnknown" and of_all:
                    knowns = [*knowns, parameter]
                ElementTree.SubElement(structure, heading, valueReference=one["valueReference"],
                               dependencies=" ".join(knowns))  # fmt: skip
        return _text(root)

    def of_build(self) -> str:
        root = ElementTree.Element("fmiBuildDescription", fmiVersion="3.0")
        made = ElementTree.SubElement(root, "BuildConfiguration", modelIdentifier=self._name)
        files = ElementTree.SubElement(made, "SourceFileSet", language="C99")
        for source in self._sources:
            ElementTree.SubElement(files, "SourceFile", name=source)
        return _text(root)

    def _of(self, causality: str) -> list[dict[str, str]]:
        return [one for one in self._variables if one["causality"] == causality]


def _variables(one: StiffnessMap, start: float, damping: float) -> Iterator[dict[str, str]]:
    """The variables in the order of their references, as `element.h` has them."""
    axis = one.axes[0]
    yield _variable("time", 0, "independent", "s", "time")
    for place, (name, unit) in enumerate(COLUMNS["displacement"]):
        text = "displacement of the inner ring against the outer one"
        yield _variable(name, 1 + place, "input", unit, text, 0.0)
    for place, name in enumerate(AXES):
        text = "velocity of the inner ring against the outer one"
        unit = "rad/s" if len(name) > 1 else "m/s"
        yield _variable(f"v{name}", 6 + place, "input", unit, text, 0.0)
    least, most = float(axis.values.min()), float(axis.values.max())
    text = f"{axis.field}, over which the table goes, from {least!r} to {most!r}"
    (quantity,) = identifiers([f"s_{axis.leaf}"])
    yield _variable(quantity, 11, "input", axis.unit, text, start)
    for place, name in enumerate(LOADS):
        text = "that the shaft puts on the inner ring; the bearing puts the opposite on the shaft"
        yield _variable(name, 12 + place, "output", "N*m" if name[0] == "m" else "N", text)
    yield _variable("damping", 17, "parameter", "s", "damping over stiffness", damping)
    yield _variable("outside", 18, "output", "", f"whether {quantity} is beyond the table")


def _variable(
    name: str, reference: int, causality: str, unit: str, text: str, start: float | None = None
) -> dict[str, str]:
    variability = "tunable" if causality == "parameter" else "continuous"
    found = {
        "name": name,
        "valueReference": str(reference),
        "causality": causality,
        "variability": "discrete" if name == "outside" else variability,
        "description": text,
    }
    if unit in _BASE:
        found["unit"] = unit
    if start is not None:
        found["start"] = repr(start)
    return found


def _in_xml(text: str) -> str:
    return "".join(one if one.isprintable() else " " for one in text)


def _text(root: ElementTree.Element) -> str:
    ElementTree.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ElementTree.tostring(root, "unicode") + "\n"


def _documentation(one: StiffnessMap, values: Any) -> str:
    root = ElementTree.Element("html")
    head = ElementTree.SubElement(root, "head")
    ElementTree.SubElement(head, "title").text = _in_xml(one.name)
    body = ElementTree.SubElement(root, "body")
    ElementTree.SubElement(body, "h1").text = _in_xml(one.name)
    ElementTree.SubElement(body, "p").text = (
        "A rolling bearing: f = F(s) + K(s) (u - U(s)) + damping K(s) v, the force that the shaft "
        "puts on the inner ring, linear in s between the points of the table and held beyond its "
        "ends. The bearing puts the opposite on the shaft. Linear about the operating points: "
        "valid for displacements small beside those of the operating points."
    )
    entries = ElementTree.SubElement(body, "dl")
    for name, value in {**about(one), one.axes[0].field: f"{values[0]!r} .. {values[-1]!r} "
                        f"{one.axes[0].unit}, {len(values)} points"}.items():  # fmt: skip
        ElementTree.SubElement(entries, "dt").text = name
        ElementTree.SubElement(entries, "dd").text = _in_xml(value)
    return "<!DOCTYPE html>\n" + ElementTree.tostring(root, "unicode", method="html") + "\n"
