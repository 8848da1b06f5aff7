"""The HTTP API, under ``/api/v1``: a use case for each address, JSON as the commands write it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from json import loads
from types import MappingProxyType
from typing import Any, Final, cast
from urllib.parse import unquote

from fastapi import APIRouter
from starlette.requests import Request
from starlette.responses import Response

import rolamento
from rolamento._json import dumps
from rolamento.case.record import Record
from rolamento.errors import InputError
from rolamento.tasks.asked import SIGNAL, Asked, Group
from rolamento.web.answers import answer, read_json, received
from rolamento.web.limits import fast, slow
from rolamento.web.requests import (
    BatchRequest,
    CaseRequest,
    FrequenciesRequest,
    FrictionRequest,
    LifeRequest,
    ReportRequest,
    WeibullRequest,
)
from rolamento.words import marked, said

__all__ = ["OPERATIONS", "PREFIX", "Operation", "Parameter", "router"]

PREFIX: Final = "/api/v1"
LARGEST_SIGNAL: Final = 256 * 2**20
"""Bytes of a record that is sent."""
_MOST_FOUND: Final = 1000
_LONGEST: Final = 300
_MACHINE: Final = "Machine"
"""What a signal's form asks for its severity, which is not diagnosed here."""
_DESIGNATION: Final = {
    "designation": "6310/C3",
    "settings": {"duty.load.fz": "5 kN", "duty.inner_speed": "1480 rpm"},
}
_OIL: Final = {"lubricant": "ISO VG 68", "temperature.lubricant": "70 degC"}


@dataclass(frozen=True, slots=True)
class Parameter:
    """What an address may say behind the question mark."""

    name: str
    meaning: str
    schema: Mapping[str, Any]
    example: str = ""
    is_required: bool = False


@dataclass(frozen=True, slots=True)
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
        that it may take in a process of its own; 0 if it is fast
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
    from rolamento.tasks.life import life_of_case, life_of_shaft

    if not asked.bearings:
        return life_of_case(asked.to_case()).to_json()
    if asked.case is not None or asked.designation is not None or asked.settings:
        rule = said("cannot be combined with a case: a shaft has its bearings alone")
        raise InputError(rule, field="bearings")
    cases = [_of_list(one, "bearings", place) for place, one in enumerate(asked.bearings)]
    titles = [own.title for own in cases]
    distinct = all(titles) and len(set(titles)) == len(titles)
    return life_of_shaft(cases).to_json(
        titles if distinct else [str(place + 1) for place in range(len(cases))]
    )


def _of_list(asked: CaseRequest, name: str, place: int) -> rolamento.Case:
    """Return one case of several; what is wrong is told of with its place."""
    try:
        return asked.to_case()
    except InputError as error:
        source = error.source or f"{name}.{place}"
        raise error.with_details(source=source) from None


def _friction(asked: FrictionRequest) -> str:
    from rolamento.tasks.friction import friction_mapping, friction_of_case

    return dumps(friction_mapping(friction_of_case(asked.to_case(), hysteresis=asked.hysteresis)))


def _frequencies(asked: FrequenciesRequest) -> str:
    from rolamento.tasks import fault_frequencies
    from rolamento.vibration.frequency_band import Tolerances

    tolerances = asked.tolerances
    found = fault_frequencies(
        asked.to_case(needs_load=False),
        speed=asked.speed,
        outer_speed=asked.outer_speed,
        slip=asked.slip,
        angle=asked.angle,
        tolerances=Tolerances(**{name: getattr(tolerances, name)
                                 for name in type(tolerances).model_fields}),
        harmonics=asked.harmonics,
        sidebands=asked.sidebands,
    )  # fmt: skip
    return dumps(found.to_mapping())


def _weibull(asked: WeibullRequest) -> str:
    from rolamento.tasks.weibull import bounds_named, fits_named, life_test_study
    from rolamento.weibull import LifeTest, ShapePrior

    table, prior = asked.test, asked.prior
    columns = {name: getattr(table, name) for name in ("failed", "lower", "counts", "group", "rig")}
    given: dict[str, Any] = {name: one for name, one in columns.items() if one is not None}
    if table.lower is not None:
        given["lower"] = [float("nan") if one is None else one for one in table.lower]
    found = life_test_study(
        LifeTest(table.times, **given, unit=table.unit, title=table.title),
        only=asked.only,
        by_group=asked.by_group,
        times=asked.times,
        calculated=asked.calculated,
        samples=asked.samples,
        methods=fits_named(asked.methods),
        bounds=None if asked.bounds is None else bounds_named(asked.bounds),
        confidence=asked.confidence,
        sides=asked.sides,
        reliabilities=tuple(dict.fromkeys(asked.reliabilities)),
        shape=asked.shape,
        prior=None if prior is None else ShapePrior(prior.low, prior.high, kind=prior.kind),
        seed=asked.seed,
    )
    return dumps(found.to_mapping())


def _report(asked: ReportRequest) -> dict[str, Any]:
    from rolamento.pages.report import report_page
    from rolamento.tasks.report import report_on
    from rolamento.web.files import file_of

    cases = [_of_list(one, "cases", place) for place, one in enumerate(asked.cases)]
    found = report_on(cases, asked.head)
    return file_of(report_page(found), found.to_mapping(), asked.format)


def _catalogue(given: Mapping[str, str]) -> str:
    from rolamento.catalogue.search import built_in_catalogue
    from rolamento.tasks.catalogue import bearing_mapping, inside_of, search_mapping

    if ("text" in given) == ("designation" in given):
        rule = said("must be given, or designation")
        raise InputError(rule, field="text", example="text=6205")
    if "designation" in given:
        return dumps(bearing_mapping(inside_of(built_in_catalogue(), given["designation"])))
    most = given.get("most", "40")
    if not (most.isascii() and most.isdigit() and 1 <= int(most[:9]) <= _MOST_FOUND):
        rule = said("must be between 1 and {most}", most=_MOST_FOUND)
        raise InputError(rule, field="most", value=most, example="most=40")
    return dumps(search_mapping(built_in_catalogue().search(given["text"], int(most))))


def _schema(_: Mapping[str, str]) -> str:
    return dumps(rolamento.Case.model_json_schema())


def _version(_: Mapping[str, str]) -> str:
    return dumps({"version": rolamento.__version__})


def _diagnosed(path: str, label: str, given: Mapping[str, str]) -> str:
    """Diagnose a record; what runs in a process."""
    from rolamento.tasks import diagnose
    from rolamento.tasks.asked import given as read
    from rolamento.vibration.diagnosis import DiagnosisSettings

    asked = dict(given)
    case = CaseRequest(
        designation=asked.pop("bearing", None),
        case=_tables(asked.pop("case", "")),
        settings=_tables(asked.pop("settings", "")) or {},
    )
    told = read(_SIGNAL, {name: [text] for name, text in asked.items()})
    search = DiagnosisSettings(
        **{name: told.pop(name) for name in ("tolerance", "speed_tolerance", "false_alarm")}
    )
    try:
        found = diagnose(path, case.to_case(needs_load=False), search=search, **told)
    except InputError as error:
        rule = error.rule.replace(path, label)
        source = label if error.source == path else error.source
        raise error.with_details(source=source).with_rule(rule) from None
    mapping = found.to_mapping()
    return dumps({**mapping, "title": label} if "title" in mapping else mapping)


def _tables(text: str) -> dict[str, Any] | None:
    """Return the tables of a text of JSON; None of an empty one."""
    if not text:
        return None
    from rolamento._reading import parse_mapping

    return parse_mapping(text, "json", "case")
