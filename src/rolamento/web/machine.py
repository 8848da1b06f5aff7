"""The page of a machine: its drawing with what can be taken hold of, and what follows from it.

Of a request nothing is read but its own tables: they may name no file.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from functools import cache, lru_cache
from threading import Lock
from time import perf_counter
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from rolamento.analysis.machine import MachineAnalysis, analyse_machine
from rolamento.case.machine import (
    Machine,
    machine_of_tables,
    machine_to_json,
    machine_to_toml,
    parse_machine,
    with_changes,
)
from rolamento.case.record import Record
from rolamento.document import Document, Section
from rolamento.document.html import body
from rolamento.errors import InputError
from rolamento.io.text import format_of_text, parse_mapping
from rolamento.pages.machine import PICTURES, machine_page, machine_picture, machine_report
from rolamento.tasks.examples import EXAMPLES, TITLES
from rolamento.validate import one_of
from rolamento.web.answers import answer, error_object, read_json
from rolamento.web.drops import REPORTS, file_of, plain_name, response_of
from rolamento.web.form import in_labels
from rolamento.web.limits import SECONDS, by_weight, check_machine, size_of_machine, slow
from rolamento.words import language, marked, said
from rolamento.words.reasons import reason

if TYPE_CHECKING:
    from rolamento.plots.machine_sketch import Sketch

__all__ = [
    "ROUTES",
    "machine_described",
    "machine_file",
    "machine_live",
    "machine_opened",
    "machine_saved",
]

_FORMATS: Final = ("toml", "json")
_FOLDER: Final = "machines/"
_LONGEST_NAME: Final = 200
_REMEMBERED: Final = 4
"""Machines: the one that is moved, and what it was before."""
_WIDTHS: Final = (80, 300)
"""Paper that a drawing may be asked for, in mm."""
_AWAY: Final = 0.045
"""How far a line of deflection is drawn from the axis at most, over the width of the paper."""
_REPORT_SECONDS: Final = 120.0

_FORCES: Final = ("fx", "fy", "fz", "mx", "my", "mz")
_FIELDS: Final[Mapping[str, tuple[str, ...]]] = {
    "bearings": ("position", "designation", "preload", "offset", "spring_force"),
    "loads": ("position", *_FORCES),
    "gears": ("position", "torque", "power", "mesh_azimuth"),
    "belts": ("position", "torque", "power", "tension", "tight", "slack", "azimuth"),
    "masses": ("position", "mass", "unbalance"),
}
"""What the page changes of parts on shafts; of others than loads only what is given."""
_LABELS: Final[Mapping[str, str]] = {
    "position": marked("position"),
    "designation": marked("designation"),
    "preload": marked("preload"),
    "offset": marked("offset"),
    "spring_force": marked("force of the springs"),
    "torque": marked("torque"),
    "power": marked("power"),
    "mesh_azimuth": marked("azimuth of the mesh"),
    "tension": marked("tension at rest"),
    "tight": marked("pull of the tight strand"),
    "slack": marked("pull of the slack strand"),
    "azimuth": marked("azimuth"),
    "mass": marked("mass"),
    "unbalance": marked("unbalance"),
    "fx": marked("force F_x"),
    "fy": marked("force F_y"),
    "fz": marked("force F_z"),
    "mx": marked("torque M_x"),
    "my": marked("moment M_y"),
    "mz": marked("moment M_z"),
}
_KINDS: Final[Mapping[str, str]] = {
    "bearings": marked("bearing"),
    "loads": marked("load"),
    "gears": marked("gear"),
    "belts": marked("belt"),
    "masses": marked("mass"),
}
_PEN: Final = Lock()
"""Matplotlib's style is one for all threads."""


# --- what is asked --------------------------------------------------------------------------------


def machine_described() -> dict[str, Any]:
    """Return what the page needs before a machine is opened, in the language that is spoken."""
    return {
        "examples": [
            {"name": name, "title": said(TITLES[_FOLDER + name])} for name in _machine_examples()
        ],
        "pictures": [{"key": key, "label": said(label)} for key, label in PICTURES.items()],
    }


@cache
def _machine_examples() -> tuple[str, ...]:
    return tuple(
        file.removeprefix(_FOLDER).removesuffix(".toml")
        for example in EXAMPLES.values()
        for file in example.files
        if file.startswith(_FOLDER)
    )


def machine_opened(request: Mapping[str, Any]) -> dict[str, Any]:
    """Return a machine as the page holds it: the tables of its file.

    Parameters
    ----------
    request
        One of ``text`` (of a machine file, with its ``format`` and ``name`` if they are known),
        ``example``, ``machine`` (tables).

    Raises
    ------
    InputError
        If it is none of them, no valid machine, or too large.
    """
    given = {name: request[name] for name in ("text", "example", "machine")
             if request.get(name) is not None}  # fmt: skip
    if len(given) != 1:
        raise InputError(
            said("must have one of text, example and machine"),
            field="open", example='{"example": "motor"}',
        )  # fmt: skip
    ((kind, value),) = given.items()
    if kind == "machine":
        tables = _tables(request)
        machine_of_tables(tables)
    elif not isinstance(value, str):
        raise InputError(said("must be text"), field=kind, value=value, example='"motor"')
    elif kind == "text":
        known = request.get("format")
        form = known if known in _FORMATS else format_of_text(value)
        source = str(request.get("name") or "")[:_LONGEST_NAME]
        parse_machine(value, format=form, source=source)  # its errors name the line
        tables = parse_mapping(value, form, source)
    else:
        tables = _example(value)
    check_machine(tables)
    return {"machine": tables}


def _tables(request: Mapping[str, Any]) -> dict[str, Any]:
    found = request.get("machine")
    if not isinstance(found, dict):
        raise InputError(said("must be a table"), field="machine", example='{"shafts": []}')
    return found


def _example(name: str) -> dict[str, Any]:
    file = f"{_FOLDER}{name}.toml"
    own = next((one for one in EXAMPLES.values() if file in one.files), None)
    if name not in _machine_examples() or own is None:
        known = ", ".join(_machine_examples())
        raise InputError(said("must be one of {known}", known=known), field="example", value=name)
    tables = parse_mapping(own.source(file).read_text(encoding="utf-8"), "toml", file)
    return {**tables, "title": said(TITLES[_FOLDER + name])}


def machine_saved(request: Mapping[str, Any]) -> dict[str, str]:
    """Return a machine as the text of a file.

    Parameters
    ----------
    request
        ``machine``: tables; ``format``: ``"toml"`` (default) or ``"json"``.

    Raises
    ------
    InputError
        If it is no valid machine.
    """
    machine = machine_of_tables(_tables(request))
    wanted = request.get("format", "toml")
    one_of(wanted, "format", _FORMATS)
    text = machine_to_json(machine) if wanted == "json" else machine_to_toml(machine)
    return {"text": text, "name": f"{plain_name(machine.title) or 'machine'}.{wanted}"}


def machine_file(tables: Mapping[str, Any], form: str) -> dict[str, Any]:
    """Return the report of a machine as a file.

    Parameters
    ----------
    tables
        As its file has them.
    form
        Kind of the file, one of `rolamento.web.drops.REPORTS`.

    Raises
    ------
    InputError
        If it is no valid machine, or there is no such kind of file.
    """
    one_of(form, "format", REPORTS, "pdf")
    found = _found(json.dumps(tables, sort_keys=True))
    return file_of(machine_report(found), found.to_mapping(), form)


# --- what follows a change ------------------------------------------------------------------------


def machine_live(request: Mapping[str, Any]) -> dict[str, Any]:
    """Return what the page shows of a machine.

    Parameters
    ----------
    request
        ``machine``: tables as a file has them; ``changes``: values over them, by dotted names;
        ``step`` of the spectrum, from 0; ``width`` of the drawing, in mm; ``pictures``: keys of
        those that are seen.

    Raises
    ------
    InputError
        If it is no such request; a machine that is wrong is reported in ``error``.
    """
    began = perf_counter()
    tables, changes = _tables(request), request.get("changes") or {}
    if not isinstance(changes, Mapping):
        raise InputError(said("must be a table"), field="changes", example='{"loads.0.fz": "1 kN"}')
    keys = request.get("pictures") or []
    if not isinstance(keys, list):
        raise InputError(said("must be a list of names"), field="pictures", example='["forces"]')
    shown: dict[str, Any] = {"machine": tables, "status": None, "error": None}
    try:
        tables = with_changes(tables, changes)
        found = _found(json.dumps(tables, sort_keys=True))
    except InputError as error:
        return {**shown, "error": error_object(error)}
    steps = len(found.solved)
    step = int(np.clip(_whole(request, "step", 0), 0, steps - 1))
    width = int(np.clip(_whole(request, "width", 125), *_WIDTHS))
    return {
        **shown,
        "machine": tables,
        "status": _status(found),
        "title": found.solved.title,
        "steps": list(found.solved.steps) if steps > 1 else [],
        "step": step,
        **_drawing(found, step, width),
        "sections": _sections(found),
        "pictures": {key: _picture(found, key, step) for key in PICTURES if key in keys},
        "milliseconds": 1e3 * (perf_counter() - began),
    }


def _whole(request: Mapping[str, Any], name: str, otherwise: int) -> int:
    given = request.get(name, otherwise)
    if isinstance(given, bool) or not isinstance(given, int):
        raise InputError(
            said("must be an integer"), field=name, value=given, example=str(otherwise)
        )
    return given


@lru_cache(maxsize=_REMEMBERED)
def _found(text: str) -> MachineAnalysis:
    tables = json.loads(text)
    machine = machine_of_tables(tables)
    check_machine(tables)
    return analyse_machine(machine)


def _status(found: MachineAnalysis) -> dict[str, Any]:
    """Whether every step has a result; why the first has none, and what to do."""
    status = found.solved.status
    case = 0 if found.converged else int(np.flatnonzero(~status.converged)[0])
    code, advice = str(status.code[case]), found.solved.advice[case]
    why, name = reason(code), found.solved.steps[case]
    return {
        "code": code,
        "converged": found.converged,
        "text": f"{name}: {why}" if name and not found.converged else why,
        "advice": None if advice is None else advice.text,
    }


def _sections(found: MachineAnalysis) -> list[dict[str, str]]:
    """The parts of the machine's page as HTML, without those that the page has otherwise."""
    parts = [one for one in machine_page(found).sections if isinstance(one, Section)]
    return [
        {
            "key": part.key,
            "label": part.heading,
            "html": _html(replace(part, heading="")),
        }
        for part in parts
        if part.key not in ("given", "picture")
    ]


def _html(section: Section, **more: Any) -> str:
    return body(Document("", (section,), kind="live", language=language()), **more)


def _picture(found: MachineAnalysis, key: str, step: int) -> str:
    with _PEN:
        figure = machine_picture(found.solved, key, step)
        return _html(Section("", (figure,), key="picture"), images=True)


# --- the drawing ----------------------------------------------------------------------------------


def _drawing(found: MachineAnalysis, step: int, width: int) -> dict[str, Any]:
    """The machine to scale, what can be taken hold of, and how its shafts bend; in points."""
    from rolamento.document.picture import picture_address
    from rolamento.plots.machine_sketch import sketch_machine

    machine = found.solved.machine
    with _PEN:
        sketch = sketch_machine(machine, step=step, width=width)
        image = picture_address(sketch.figure)
    lines, times = _deflected(found, step, sketch)
    return {
        "drawing": {
            "image": image,
            "width": sketch.width,
            "height": sketch.height,
            "left": sketch.left,
            "scale": sketch.scale,
            "lines": lines,
            "times": times,
        },
        "parts": list(_parts(machine, sketch)),
    }


def _deflected(
    found: MachineAnalysis, step: int, sketch: Sketch
) -> tuple[list[dict[str, Any]], float | None]:
    """Points of each shaft's line in z, and in y turned into the paper; how many times as large."""
    shafts = found.solved.shafts.values()
    if not found.solved.status.converged[step]:
        return [], None
    most = max(float(np.abs(one.displacement[step, :, 1:3]).max()) for one in shafts)
    if not most > 0.0:
        return [], None
    times = _rounded(_AWAY * sketch.width / sketch.scale / most)
    lines = []
    for one in shafts:
        x = sketch.left + sketch.scale * (one.shaft.position + one.position)
        axis = sketch.axes[one.name]
        for plane, index in (("y", 1), ("z", 2)):
            y = axis - sketch.scale * times * one.displacement[step, :, index]
            points = np.round(np.column_stack([x, y]), 2).tolist()
            lines.append({"shaft": one.name, "plane": plane, "points": points})
    return lines, times


def _rounded(value: float) -> float:
    """The round number below a positive one: the scale of a moving picture seldom changes."""
    power = 10.0 ** np.floor(np.log10(value))
    return float(next(one * power for one in (5.0, 2.0, 1.0) if one * power <= value * 1.000001))


def _parts(machine: Machine, sketch: Sketch) -> Iterator[dict[str, Any]]:
    """What stands on the shafts: where it is, how far it goes, and what may be changed of it."""
    grips = {grip.part: grip for grip in sketch.grips}
    for kind, names in _FIELDS.items():
        for index, part in enumerate(getattr(machine, kind)):
            key, shaft = f"{kind}.{index}", machine.shaft(part.shaft)
            grip = grips[key]
            yield {
                "key": key,
                "kind": kind,
                "label": f"{part.name} ({said(_KINDS[kind])})"
                if part.name
                else f"{said(_KINDS[kind])} {index + 1}",
                "shaft": part.shaft,
                "position": part.position,
                "length": shaft.length,
                "start": shaft.position,
                "x": grip.x,
                "y": grip.y,
                "axis": grip.axis,
                "fields": list(_fields(part, key, names)),
            }


def _fields(part: Record, key: str, names: tuple[str, ...]) -> Iterator[dict[str, Any]]:
    for name in names:
        if name in _FORCES or name in part.model_fields_set:
            example = (type(part).model_fields[name].examples or [""])[0]
            own = f"{key}.{name}"
            yield {"name": own, "label": said(_LABELS[name]), "example": str(example)}
    table = getattr(part, "bearing", None)
    if isinstance(table, Mapping) and "designation" in table:
        label = said(_LABELS["designation"])
        yield {"name": f"{key}.bearing.designation", "label": label, "example": "6308"}


# --- addresses ------------------------------------------------------------------------------------

_ASKED: Final = {"open": machine_opened, "save": machine_saved, "live": machine_live}


async def _asked(request: Request) -> Response:
    """Answer what the page asks: large machines in a process of their own."""
    asked = await read_json(request)
    function = _ASKED[request.url.path.rpartition("/")[2]]
    tables, changes = asked.get("machine"), asked.get("changes")
    if isinstance(tables, dict) and isinstance(changes, dict):
        with suppress(InputError):  # which is said where the request is answered
            tables = with_changes(tables, changes)
    seconds = 0.0 if size_of_machine(tables).is_fast else SECONDS
    light = request.app.state.hands.run
    return answer(
        await by_weight(in_labels, function, asked, asked=asked, seconds=seconds, light=light)
    )


async def _reported(request: Request) -> Response:
    """Answer with the report of a machine: ``machine`` and ``format``."""
    asked = await read_json(request)
    tables, form = _tables(asked), str(asked.get("format", "html"))
    return response_of(await slow(machine_file, tables, form, seconds=_REPORT_SECONDS))


ROUTES: Final = (
    *(Route(f"/page/machine/{name}", _asked, methods=["POST"]) for name in _ASKED),
    Route("/page/machine/report", _reported, methods=["POST"]),
)
