"""What the bodies of requests to the HTTP API may hold: records as those of a case are.

Their docstrings are the descriptions of its OpenAPI document.
"""

from __future__ import annotations

import inspect
from collections.abc import Mapping
from typing import Annotated, Any, ClassVar, Final, Literal

from pydantic import (
    AfterValidator,
    Field,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    WithJsonSchema,
    create_model,
)
from pydantic_core import CoreSchema

from rolamento.case import Case
from rolamento.case.fields import changed
from rolamento.case.machine import Machine, machine_of_tables
from rolamento.case.quantity import Quantity
from rolamento.case.record import Record
from rolamento.case.report import ReportHead
from rolamento.errors import InputError
from rolamento.studies.outputs import DEFAULT_OUTPUTS
from rolamento.tasks.bearing import has_load
from rolamento.tasks.life import MOST_BEARINGS
from rolamento.tasks.report import MOST_CASES
from rolamento.tasks.request import Input
from rolamento.tasks.request import Request as UseCase
from rolamento.web.limits import check_machine
from rolamento.weibull.life_test import MAXIMUM_ROWS, LifeTest
from rolamento.words import said

__all__ = [
    "EXAMPLE_MACHINE",
    "BatchRequest",
    "CaseRequest",
    "LifeRequest",
    "LifeTestRequest",
    "MachineRequest",
    "ReportRequest",
    "asking",
]

_MOST_SETTINGS: Final = 200
_LONGEST: Final = 300
_MOST_NUMBERS: Final = 50
_CASE: Final = {
    "bearing": {"designation": "6310/C3"},
    "duty": {"inner_speed": "1480 rpm", "load": {"fz": "5 kN"}},
}
_SETTINGS: Final = {"duty.load.fz": "5 kN", "duty.inner_speed": "1480 rpm"}
_LIVES: Final = [17.88, 28.92, 33.0, 41.52, 42.12, 45.6]


class TablesOf:
    """Annotation of a mapping that holds the tables of a record as its file has them."""

    def __init__(self, record: type[Record]) -> None:
        self.record = record

    def __get_pydantic_core_schema__(
        self, source: object, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        """Take any mapping: whoever reads it says what is wrong, by the names of its fields."""
        return handler(source)

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        """Describe the record."""
        return handler(self.record.__pydantic_core_schema__)


Text = Annotated[str, Field(strict=True, max_length=_LONGEST)]
Number = Annotated[float, Quantity()]
Flag = Annotated[bool, Field(strict=True)]


def _checked_time(given: object) -> object:
    is_number = isinstance(given, int | float) and not isinstance(given, bool)
    if not is_number and not (isinstance(given, str) and len(given) <= _LONGEST):
        raise InputError(said("must be a number, or text with a unit"), example='"100 h"')
    return given


Time = Annotated[
    Any,
    AfterValidator(_checked_time),
    WithJsonSchema({"anyOf": [{"type": "string", "maxLength": _LONGEST}, {"type": "number"}]}),
]
"""A number in the unit of the data, or text with another."""


class CaseRequest(Record):
    """A case: its tables, or the designation of a bearing; with settings over it.

    Parameters
    ----------
    case
        The tables of a case file; quantities are text with a unit, such as "10 kN".
    designation
        Of a bearing in the catalogue, such as "6310/C3", instead of a case.
    settings
        Values over the case, by the dotted names of its fields; null takes one away.
    """

    case: Annotated[dict[str, Any], TablesOf(Case)] | None = Field(None, examples=[_CASE])
    designation: Text | None = Field(None, min_length=1, examples=["6310/C3"])
    settings: dict[Text, Any] = Field(
        default_factory=dict, max_length=_MOST_SETTINGS, examples=[_SETTINGS]
    )

    def subject(self, *, needs_load: bool = True) -> dict[str, Any]:
        """Return what a use case of a case is of, by the name of its field."""
        return {"case": self.to_case(needs_load=needs_load)}

    def to_case(self, *, needs_load: bool = True) -> Case:
        """Return the case.

        needs_load: refuse a designation that no setting gives a load.

        Raises
        ------
        InputError
            If it is neither tables nor a designation, or not valid.
        """
        if (self.case is None) == (self.designation is None):
            raise InputError(
                said("must have one of case and designation"),
                field="case",
                example='{"designation": "6310/C3", "settings": {"duty.load.fz": "5 kN"}}',
            )
        tables: Mapping[str, Any] = self.case or {}
        if self.designation is not None:
            tables = {"bearing": {"designation": self.designation.strip()}, "duty": {}}
        case = Case.from_mapping(changed(tables, self.settings, Case, in_file=True))
        if self.designation is None:
            return case
        if needs_load and not has_load(case):
            rule = said("is missing: nothing loads the bearing")
            raise InputError(rule, field="duty.load", example='{"duty.load.fz": "5 kN"}')
        return case if case.title else case.replace(title=self.designation.strip())


class BatchRequest(CaseRequest):
    """Many cases of one bearing: values of fields in, columns of results out.

    Parameters
    ----------
    case
        The tables of a case file, for what does not vary.
    designation
        Of a bearing in the catalogue, instead of a case.
    settings
        Values over the case, by the dotted names of its fields; null takes one away.
    fields
        Values by the dotted names of the fields that vary: lists of one length, of text with a unit
        or of numbers in SI units; or one value for all cases.
    outputs
        Names of results, as `rolamento sweep --list outputs` lists them.
    """

    fields: dict[Text, Any] = Field(
        min_length=1, max_length=_MOST_NUMBERS, examples=[{"duty.load.fz": ["2 kN", "5 kN"]}]
    )
    outputs: tuple[Text, ...] = Field(
        DEFAULT_OUTPUTS, min_length=1, max_length=100, examples=[["max_inner_load", "stiffness_zz"]]
    )


class LifeRequest(CaseRequest):
    """A case, or the cases of the bearings on one shaft, whose life is to be found.

    Parameters
    ----------
    case
        The tables of a case file.
    designation
        Of a bearing in the catalogue, instead of a case.
    settings
        Values over the case, by the dotted names of its fields; null takes one away.
    bearings
        Of one shaft, two or more, instead of a case.
    """

    bearings: tuple[CaseRequest, ...] = Field((), max_length=MOST_BEARINGS)


EXAMPLE_MACHINE: Final[dict[str, Any]] = {
    "shafts": [
        {
            "name": "shaft",
            "speed": "1480 rpm",
            "sections": [{"length": "300 mm", "diameter": "40 mm"}],
        }
    ],
    "bearings": [
        {"name": "A", "shaft": "shaft", "position": "20 mm", "designation": "6308"},
        {
            "name": "B",
            "shaft": "shaft",
            "position": "240 mm",
            "designation": "6308",
            "located": "floating",
        },
    ],
    "loads": [{"name": "pulley", "shaft": "shaft", "position": "290 mm", "fz": "-2 kN"}],
}


class MachineRequest(Record):
    """A machine: shafts on their bearings, with settings over it.

    Parameters
    ----------
    machine
        The tables of a machine file; it names no other file: sections, matrices and cases stand in
        it.
    settings
        Values over the machine, by their dotted names: parts of a list by their names or numbers,
        such as "loads.0.fz"; null takes one away.
    """

    machine: Annotated[dict[str, Any], TablesOf(Machine)] = Field(examples=[EXAMPLE_MACHINE])
    settings: dict[Text, Any] = Field(
        default_factory=dict, max_length=_MOST_SETTINGS, examples=[{"loads.0.fz": "-3 kN"}]
    )

    def subject(self, *, needs_load: bool = True) -> dict[str, Any]:
        """Return what a use case of a machine is of, by the name of its field."""
        return {"machine": self.to_machine()}

    def to_machine(self) -> Machine:
        """Return the machine.

        Raises
        ------
        InputError
            If it is not valid, names a file, or is too large for a request.
        """
        machine = machine_of_tables(self.machine, self.settings)
        check_machine(machine.to_mapping())
        return machine


def asking(request: type[UseCase], *names: str, of: type[Record] | None = None) -> type[Any]:
    """Return a record of what a use case is of, and of what else it is given.

    Parameters
    ----------
    request
        The use case.
    names
        Of its fields that it may be given here.
    of
        What it is of; a case or a machine, whichever it takes, if not given.
    """
    base = of or (CaseRequest if request.takes_case else MachineRequest)
    inputs, means = request.inputs(), request.meanings()
    fields: dict[str, Any] = {}
    for name in names:
        one, default = inputs[name], request.model_fields[name].default
        example = _example(one)
        shown = Field(default, description=means[name], examples=[example] if example else None)
        fields[name] = (Annotated[request.model_fields[name].annotation, one], shown)
    of_subject = (base.__doc__ or "").partition("\n\n")[2]
    doc = f"{request.summary()}\n\n{inspect.cleandoc(of_subject)}"
    return create_model(request.__name__, __base__=base, __doc__=doc, **fields)


def _example(one: Input) -> Any:
    """Return an example as JSON has it: several values as a list, a number as one."""
    text = one.example or one.default
    if one.kind in ("number", "count", "fraction", "switch"):
        return one.value(text)
    return [*one.value(text)] if one.is_many and not one.is_by_key else text


class LifeTestTable(Record):
    """Lives of a test, one row a bearing or so many alike.

    Parameters
    ----------
    times
        At which a bearing failed, was found to have failed, or was suspended.
    failed
        Whether it failed; all did if not given.
    lower
        Time of the last inspection that a failed bearing passed; null where the time of failure
        itself is known.
    counts
        How many bearings a row stands for.
    group
        Label of the group, such as a lot.
    rig
        Label of bearings whose test ended together, at the first failure.
    mode
        Label of the failure mode of a failed bearing; "" where it is not known.
    unit
        Of the times: "h", "Mrev" (millions of revolutions), "rev" …
    title
        What the data are.
    """

    times: tuple[Number, ...] = Field(min_length=1, max_length=MAXIMUM_ROWS, examples=[_LIVES])
    failed: tuple[Flag, ...] | None = Field(None, max_length=MAXIMUM_ROWS)
    lower: tuple[Number | None, ...] | None = Field(None, max_length=MAXIMUM_ROWS)
    counts: tuple[Annotated[int, Field(strict=True, ge=1)], ...] | None = Field(
        None, max_length=MAXIMUM_ROWS
    )
    group: tuple[Text, ...] | None = Field(None, max_length=MAXIMUM_ROWS)
    rig: tuple[Text, ...] | None = Field(None, max_length=MAXIMUM_ROWS)
    mode: tuple[Text, ...] | None = Field(None, max_length=MAXIMUM_ROWS)
    unit: Text = Field("h", examples=["h"])
    title: Text = Field("", examples=["Lot A"])

    def to_test(self) -> LifeTest:
        """Return the life test."""
        names = ("failed", "counts", "group", "rig", "mode")
        given: dict[str, Any] = {
            name: one for name in names if (one := getattr(self, name)) is not None
        }
        if self.lower is not None:
            given["lower"] = [float("nan") if one is None else one for one in self.lower]
        return LifeTest(self.times, **given, unit=self.unit, title=self.title)


class PriorShape(Record):
    """What was known of the shape before the test.

    Parameters
    ----------
    low, high
        The shape lies between them, with a probability of 0.9 if it is "lognormal".
    kind
        "lognormal", or "uniform": nothing outside.
    """

    low: Annotated[float, Quantity(above=0.0)] = Field(examples=[1.0])
    high: Annotated[float, Quantity(above=0.0)] = Field(examples=[2.5])
    kind: Literal["lognormal", "uniform"] = "lognormal"

    def to_text(self) -> str:
        """Return it as it is typed."""
        return f"{'uniform:' * (self.kind == 'uniform')}{self.low!r}..{self.high!r}"


class LifeTestRequest(Record):
    """A life test, and what is to be found of it.

    Parameters
    ----------
    test
        The lives.
    methods
        Of fitting: ml, unbiased, rrx, rry, three-parameter; by default the first four.
    calculated
        Calculated lives to compare with the data, by their names: numbers in the unit of the test,
        or text with another.
    prior
        What was known of the shape: gives a posterior as well.
    """

    test: LifeTestTable = Field(examples=[{"times": _LIVES, "unit": "h"}])
    methods: tuple[Text, ...] = Field((), max_length=10, examples=[["ml", "unbiased"]])
    calculated: dict[Text, Time] = Field(
        default_factory=dict, max_length=8, examples=[{"ISO 281": "58 h"}]
    )
    prior: PriorShape | None = Field(None, examples=[{"low": 1.0, "high": 2.5}])

    spelling: ClassVar = {"method": "methods", "reliability": "reliabilities"}
    """Names here of what the use case calls otherwise."""

    def subject(self, *, needs_load: bool = True) -> dict[str, Any]:
        """Return what the use case is given, by the names of its fields."""
        return {
            "data": self.test.to_test(),
            "method": self.methods,
            "calculated": self.calculated,
            "prior": None if self.prior is None else self.prior.to_text(),
        }


class ReportRequest(Record):
    """Cases of which a calculation report is to be written, side by side if there are several.

    Parameters
    ----------
    cases
        One to twenty.
    format
        Of the file.
    head
        Of the title block: project, author, revision, date, checked_by.
    """

    cases: tuple[CaseRequest, ...] = Field(
        min_length=1, max_length=MOST_CASES, examples=[[{"case": _CASE}]]
    )
    format: Literal["html", "pdf", "md", "txt", "json"] = Field("html", examples=["pdf"])
    head: ReportHead = Field(default_factory=ReportHead, examples=[{"project": "Pump P-101"}])
