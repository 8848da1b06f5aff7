"""The HTTP API, under ``/api/v1``: a use case for each address, JSON as the commands write it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field
from functools import cache
from types import MappingProxyType
from typing import Any, Final
from urllib.parse import unquote

from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

import rolamento
from rolamento import tasks
from rolamento.case.record import Record
from rolamento.errors import InputError, UnknownKeyError, arguments, guess
from rolamento.io.json import dumps
from rolamento.records import frozen
from rolamento.tasks.life import MOST_BEARINGS
from rolamento.tasks.request import Input
from rolamento.tasks.vibration_diagnosis import VibrationDiagnosis
from rolamento.web.answers import MOST_COLUMNS, MOST_JSON, answer, read_json, received
from rolamento.web.drops import LARGEST, ending_of, file_of, label_of, response_of
from rolamento.web.limits import by_weight, slow
from rolamento.web.requests import (
    EXAMPLE_MACHINE,
    BatchRequest,
    CaseRequest,
    LifeRequest,
    LifeTestRequest,
    MachineRequest,
    ReportRequest,
    asking,
)
from rolamento.words import marked, said

__all__ = ["OPERATIONS", "PREFIX", "ROUTES", "Operation", "Parameter"]

PREFIX: Final = "/api/v1"
_MOST_FOUND: Final = 1000
_LONGEST: Final = 300
_LOAD: Final = {"duty.load.fz": "5 kN", "duty.inner_speed": "1480 rpm"}
_DESIGNATION: Final = {"designation": "6310/C3", "settings": _LOAD}
_OIL: Final = {"lubricant": "ISO VG 68", "temperature.lubricant": "70 degC"}
_OF_FREQUENCIES: Final = (
    *("speed", "outer_speed", "slip", "angle", "tolerances", "harmonics", "sidebands"),
)
_OF_LIFE_TEST: Final = (
    "bounds", "confidence", "sides", "reliabilities", "times", "shape", "by_group", "only",
    "by_mode", "only_mode", "models", "samples", "seed",
)  # fmt: skip
_ON_SHAFT: Final = {"machine": EXAMPLE_MACHINE, "settings": {"loads.0.fz": "-3 kN"}}
_WITH_OIL: Final = {"designation": "6310/C3", "settings": {**_LOAD, **_OIL}}


@frozen
class Parameter:
    """What an address may say behind the question mark."""

    name: str
    meaning: str
    schema: Mapping[str, Any]
    example: str = ""
    is_required: bool = False


@frozen
class Operation:
    """One thing that the API does.

    Attributes
    ----------
    method, path
        of HTTP, the path behind the prefix
    summary, description
        marked
    run
        what it does: of the record that it asks for, or of its parameters, to JSON or a file
    asks
        the record that its body holds; None if it takes no body
    example
        of a body
    parameters
        of the address
    has
        keys of its answer
    files
        media types, if it answers with a file
    seconds
        that it may take in a process of its own; 0 if it is usually fast
    most
        bytes of its body
    """

    method: str
    path: str
    summary: str
    description: str
    run: Callable[[Any], str | dict[str, Any]]
    asks: type[Record] | None = None
    example: Mapping[str, Any] = field(default_factory=dict)
    parameters: tuple[Parameter, ...] = ()
    has: tuple[str, ...] = ()
    files: tuple[str, ...] = ()
    seconds: float = 0.0
    most: int = MOST_JSON


# --- what is done: each takes what was asked for and gives JSON, or a file ----------------------


def _solved(asked: CaseRequest) -> str:
    return rolamento.solve(asked.to_case()).to_json(indent=None)


def _analysed(asked: CaseRequest) -> str:
    return rolamento.analyse(asked.to_case()).to_json(indent=None)


def _batch(asked: BatchRequest) -> str:
    from rolamento.tasks.batch import batch

    case = asked.to_case(needs_load=False)
    return dumps(batch(case, asked.fields, asked.outputs).to_mapping())


def _life(asked: LifeRequest) -> str:
    alone = asked.case is None and asked.designation is None and not asked.settings
    if asked.bearings and not alone:
        rule = said("cannot be combined with a case: a shaft has its bearings alone")
        raise InputError(rule, field="bearings")
    if len(asked.bearings) == 1:
        rule = said("must be from 2 to {most} on one shaft", most=MOST_BEARINGS)
        raise InputError(rule, field="bearings", value=1)
    cases = [_of_list(one, "bearings", place) for place, one in enumerate(asked.bearings)]
    done = tasks.LifeRequest(case=cases or [asked.to_case()])
    return done.json_text(done.run())


def _of_list(asked: CaseRequest, name: str, place: int) -> rolamento.Case:
    """Return one case of several; what is wrong is reported with its place."""
    try:
        return asked.to_case()
    except InputError as error:
        source = error.source or f"{name}.{place}"
        raise error.with_details(source=source) from None


def _shaft(asked: MachineRequest) -> str:
    return rolamento.analyse_machine(asked.to_machine()).to_json(indent=None)


def _run(
    request: type[tasks.Request],
    *names: str,
    needs_load: bool = True,
    of: type[Record] | None = None,
) -> tuple[Callable[[Any], str], type[Any]]:
    """Return what runs a use case, and the record that its body holds.

    names: of what else it may be given; of: as of `asking`.
    """

    def run(asked: Any) -> str:
        given = {name: one for name in names if (one := getattr(asked, name)) is not None}
        try:
            done = request(**asked.subject(needs_load=needs_load), **given)
            return done.json_text(done.run())
        except InputError as error:
            raise error.spelled(getattr(of, "spelling", {})) from None

    return run, asking(request, *names, of=of)


def _report(asked: ReportRequest) -> dict[str, Any]:
    cases = [_of_list(one, "cases", place) for place, one in enumerate(asked.cases)]
    done = tasks.ReportRequest(case=cases, **asked.head.to_mapping())
    found = done.run()
    return file_of(done.page(found), found.found.to_mapping(), asked.format)


def _catalogue(given: Mapping[str, str]) -> str:
    from rolamento.catalogue.search import built_in_catalogue
    from rolamento.tasks.catalogue import bearing_mapping, inside_of, search_mapping

    if ("text" in given) == ("designation" in given):
        rule = said("must be given, or designation")
        raise InputError(rule, field="text", example=arguments(text=6205))
    if "designation" in given:
        return dumps(bearing_mapping(inside_of(built_in_catalogue(), given["designation"])))
    most = given.get("most", "40")
    if not (most.isascii() and most.isdigit() and 1 <= int(most[:9]) <= _MOST_FOUND):
        rule = said("must be between 1 and {most}", most=_MOST_FOUND)
        raise InputError(rule, field="most", value=most, example=arguments(most=40))
    return dumps(search_mapping(built_in_catalogue().search(given["text"], int(most))))


@cache
def _case_schema() -> str:
    return dumps(rolamento.Case.model_json_schema())


def _schema(_: Mapping[str, str]) -> str:
    return _case_schema()


def _version(_: Mapping[str, str]) -> str:
    return dumps({"version": rolamento.__version__})


def _diagnosed(path: str, label: str, given: Mapping[str, str]) -> str:
    """Diagnose a record; what runs in a process."""
    asked = dict(given)
    case = CaseRequest(
        designation=asked.pop("bearing", None),
        case=_tables(asked.pop("case", "")),
        settings=_tables(asked.pop("settings", "")) or {},
    )
    typed = {name: [text] for name, text in asked.items()}
    try:
        bearing = case.to_case(needs_load=False)
        found = VibrationDiagnosis.read(typed, signal=path, bearing=bearing).run()
    except InputError as error:
        source = label if error.source == path else error.source
        rule = error.rule.replace(path, label)
        raise error.with_details(source=source, rule=rule) from None
    # what has no name of its own is called by its file's, here the name of a private one
    return dumps(found.to_mapping()).replace(dumps(path)[1:-1], dumps(label)[1:-1])


def _tables(text: str) -> dict[str, Any] | None:
    """Return the tables of a text of JSON; None of an empty one."""
    if not text:
        return None
    from rolamento.io.text import parse_mapping

    return parse_mapping(text, "json", "case")


# --- what there is --------------------------------------------------------------------------------


def _of_asked(name: str, one: Input, meaning: str) -> Parameter:
    """Return what may be typed beside a signal as a parameter of the address."""
    schema: dict[str, Any] = {"type": "string", "maxLength": _LONGEST}
    if one.kind == "switch":
        schema = {"type": "string", "enum": ["true", "false"]}
    elif one.choices is not None:
        schema = {"type": "string", "enum": list(one.choices())}
    return Parameter(name, one.on_page or meaning, schema, one.example)


_TEXT: Final = MappingProxyType({"type": "string", "minLength": 1, "maxLength": _LONGEST})
_STATE: Final = ("schema", "title", "status", "case")

OPERATIONS: Final[tuple[Operation, ...]] = (
    Operation(
        "POST",
        "/solve",
        marked("Internal state"),
        marked(
            "The equilibrium of the bearing: displacements, stiffness, loads, angles and pressures"
            " of every ball or roller. As rolamento.solve(case).to_json()."
        ),
        _solved,
        CaseRequest,
        _DESIGNATION,
        has=(*_STATE, "displacement", "load", "stiffness", "notes"),
    ),
    Operation(
        "POST",
        "/analyse",
        marked("Everything about a case"),
        marked(
            "The internal state, and what follows from it: film, friction, life, frequencies. As"
            " rolamento solve CASE --json."
        ),
        _analysed,
        CaseRequest,
        _WITH_OIL,
        has=(*_STATE, "film", "friction", "life", "frequencies"),
    ),
    Operation(
        "POST",
        "/batch",
        marked("Many cases at once"),
        marked(
            "Values of fields over one case, as columns; a status for each case, and a column for"
            " each result. A case without a result has null and stops no other."
        ),
        _batch,
        BatchRequest,
        {
            "designation": "6310/C3",
            "fields": {"duty.load.fz": ["2 kN", "5 kN"], "duty.inner_speed": "1480 rpm"},
            "outputs": ["max_inner_load", "stiffness_zz"],
        },
        has=("schema", "kind", "cases", "fields", "status", "units", "outputs", "case"),
        seconds=60.0,
        most=MOST_COLUMNS,
    ),
    Operation(
        "POST",
        "/life",
        marked("Life"),
        marked(
            "The life by every theory, and what would help; of several bearings on one shaft, of"
            " each and of all together. As rolamento life CASE --json."
        ),
        _life,
        LifeRequest,
        _WITH_OIL,
        has=("schema", "kind"),
        seconds=60.0,
    ),
    Operation(
        "POST",
        "/shaft",
        marked("Machine"),
        marked(
            "Shafts on their bearings: loads, tilts, deflection, the life of each bearing and of"
            " all together, in each step of the spectrum. As rolamento shaft MACHINE --json."
        ),
        _shaft,
        MachineRequest,
        _ON_SHAFT,
        has=("schema", "kind", "title", "shafts", "bearings", "life"),
        seconds=60.0,
    ),
    Operation(
        "POST",
        "/rotor",
        marked("Vibration of a machine"),
        marked(
            "Natural frequencies, mode shapes, critical speeds and the response to unbalance. As"
            " rolamento rotor MACHINE --json."
        ),
        *_run(tasks.RotorRequest, "speeds", "shaft", "points", "modes", "orders", "damping"),
        {**_ON_SHAFT, "speeds": "0..6000rpm", "points": 3, "modes": 4},
        has=("schema", "kind", "title", "modes", "campbell", "unbalance_response"),
        seconds=120.0,
    ),
    Operation(
        "POST",
        "/friction",
        marked("Friction"),
        marked("The friction torque by every model. As rolamento friction CASE --json."),
        *_run(tasks.FrictionRequest, "hysteresis"),
        {
            "designation": "6310/C3",
            "settings": {
                **_LOAD,
                **_OIL,
                "lubricant.friction_coefficient": 0.1,
            },
        },
        has=(*_STATE, "kind", "friction"),
        seconds=60.0,
    ),
    Operation(
        "POST",
        "/heat",
        marked("Temperatures and preload in operation"),
        marked("How warm a bearing runs, or how it warms up. As rolamento heat CASE --json."),
        *_run(tasks.HeatRequest, "time"),
        {
            "designation": "6310/C3",
            "settings": {**_LOAD, "lubricant": "ISO VG 68", "heat.housing_ambient": "4 W/K"},
        },
        has=("schema", "kind", "title", "status", "temperatures", "power", "notes", "case"),
        seconds=60.0,
    ),
    Operation(
        "POST",
        "/frequencies",
        marked("Fault frequencies"),
        marked(
            "BPFO, BPFI, BSF and FTF, from the geometry, and from what rolls under the case's load"
            " if any. As rolamento frequencies BEARING --json."
        ),
        *_run(tasks.FrequenciesRequest, *_OF_FREQUENCIES, needs_load=False),
        {"designation": "6205", "speed": "1797 rpm"},
        has=("schema", "kind", "title", "nominal", "loaded", "harmonics"),
    ),
    Operation(
        "POST",
        "/weibull",
        marked("Life test"),
        marked(
            "Fits of a Weibull distribution to a life test, with bounds, and comparisons of its"
            " groups. As rolamento weibull DATA --json."
        ),
        *_run(tasks.LifeTestEvaluation, *_OF_LIFE_TEST, of=LifeTestRequest),
        {"test": {"times": [17.88, 28.92, 33.0, 41.52, 42.12, 45.6], "unit": "Mrev"}},
        has=("schema", "kind"),
        seconds=60.0,
        most=MOST_COLUMNS,
    ),
    Operation(
        "POST",
        "/report",
        marked("Calculation report"),
        marked("What an engineer signs, of one case or of several side by side, as a file."),
        _report,
        ReportRequest,
        {"cases": [_DESIGNATION], "format": "html", "head": {"project": "Pump P-101"}},
        files=("text/html", "application/pdf", "text/markdown", "text/plain", "application/json"),
        seconds=120.0,
    ),
    Operation(
        "GET",
        "/catalogue",
        marked("Catalogue"),
        marked(
            "The bearings whose designation contains a text, or one bearing with what is inside. As"
            " rolamento catalogue search TEXT --json, and show DESIGNATION --json."
        ),
        _catalogue,
        parameters=(
            Parameter(
                "text",
                marked("Part of a designation, or boundary dimensions such as 25x52."),
                _TEXT,
                "6205",
            ),
            Parameter(
                "most",
                marked("Maximum number of results."),
                {"type": "integer", "minimum": 1, "maximum": _MOST_FOUND},
                "40",
            ),
            Parameter(
                "designation", marked("Designation, such as 6205/C3, instead of a text."), _TEXT, ""
            ),
        ),
        has=("schema", "kind"),
    ),
    Operation(
        "GET",
        "/schema",
        marked("Schema of a case"),
        marked("The JSON schema of a case: every field with its unit, bounds and meaning."),
        _schema,
        has=("properties", "$defs"),
    ),
    Operation(
        "GET",
        "/version",
        marked("Version"),
        marked("The version of the program."),
        _version,
        has=("version",),
    ),
)
"""All but a record that is diagnosed, and whether the server is ready: they need its request."""
_BY_PATH: Final = {one.path: one for one in OPERATIONS}

DIAGNOSE: Final = Operation(
    "POST",
    "/diagnose",
    marked("Vibration record"),
    marked(
        "Which parts of a bearing a vibration record shows to be damaged. The body is the file:"
        " WAV, CSV, NumPy, MATLAB, HDF5, Parquet or UFF 58. As rolamento diagnose SIGNAL --json."
    ),
    lambda _: "",
    parameters=(
        Parameter("bearing", marked("Designation of the bearing, or case instead."), _TEXT, "6205"),
        Parameter("case", marked("The tables of a case file, as JSON."), {"type": "string"}),
        Parameter("settings", marked("Values over the case, as JSON."), {"type": "string"}),
        *(
            _of_asked(name, one, VibrationDiagnosis.meanings()[name])
            for name, one in VibrationDiagnosis.inputs().items()
            if not one.is_local and name != "bearing"
        ),
    ),
    has=("schema", "kind"),
    seconds=120.0,
)
READY: Final = Operation(
    "GET",
    "/ready",
    marked("Readiness"),
    marked("Whether the first request need not wait, and how far that is."),
    lambda _: "",
    has=("ready", "done", "total"),
)


def _done(path: str, given: Mapping[str, Any]) -> str | dict[str, Any]:
    """Do what an address does; the thread or the process that it runs in reads the request too."""
    operation = _BY_PATH[path]
    asked = operation.asks
    return operation.run(given if asked is None else asked.from_mapping(given))


def _route(operation: Operation) -> Route:
    async def endpoint(request: Request) -> Response:
        if operation.asks is None:
            given: Mapping[str, Any] = _query(request, operation)
        else:
            given = await read_json(request, operation.most)
        found = await by_weight(
            _done, operation.path, given, asked=given, seconds=operation.seconds
        )
        return answer(found) if isinstance(found, str) else response_of(found)

    return Route(PREFIX + operation.path, endpoint, methods=[operation.method])


def _query(request: Request, operation: Operation) -> dict[str, str]:
    """Return what an address says, of what it may say.

    Raises
    ------
    InputError
        For a name that nobody reads, or one that is given twice.
    """
    known = [one.name for one in operation.parameters]
    found: dict[str, str] = {}
    for name, text in request.query_params.multi_items():
        if name in found:
            raise InputError(said("is given twice"), field=name, value=text)
        if name in known:
            found[name] = text
        elif name != "lang":
            raise UnknownKeyError(
                said("is not read here; {guess}", guess=guess(name, [*known, "lang"])), field=name
            )
    return found


async def _diagnose(request: Request) -> Response:
    """Diagnose the record that the body holds."""
    given = _query(request, DIAGNOSE)
    label = label_of(unquote(request.headers.get("x-file-name", "")))
    async with received(request, LARGEST["signal"], ending_of(label, "signal")) as path:
        text = await slow(_diagnosed, str(path), label, given, seconds=DIAGNOSE.seconds)
    return answer(text)


async def _ready(request: Request) -> Response:
    """Return whether the first request need not wait."""
    return answer(request.app.state.warmth.to_mapping())


ROUTES: Final = (
    *map(_route, OPERATIONS),
    Route(PREFIX + DIAGNOSE.path, _diagnose, methods=[DIAGNOSE.method]),
    Route(PREFIX + READY.path, _ready),
)
