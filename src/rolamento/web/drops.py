"""Files that are dropped on the page, and reports that are taken from it.

What is asked for beside a file stands in the requests of `rolamento.tasks`. The work is done by
functions that a process of its own can be sent (`signal_page`, `life_test_page`, `plan_page`,
`report_file`): they take texts and the name of a private file, and give back plain data. What the
user calls the file is only said; it is never part of a path.
"""

from __future__ import annotations

import os
import re
import unicodedata
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any, Final
from urllib.parse import unquote

from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from rolamento.document import Document, Section, Statement
from rolamento.errors import InputError
from rolamento.records import frozen
from rolamento.tasks.bearing import designated
from rolamento.tasks.request import Request as UseCase
from rolamento.tasks.severity import MACHINE, VibrationSeverity
from rolamento.tasks.vibration_diagnosis import VibrationDiagnosis
from rolamento.tasks.weibull import DemonstrationTest, LifeTestEvaluation
from rolamento.validate import one_of
from rolamento.vibration.reading.formats import ENDINGS
from rolamento.web.answers import answer, read_json, received
from rolamento.web.form import as_labelled
from rolamento.web.limits import slow
from rolamento.words import manner, marked, said, spelling

if TYPE_CHECKING:
    from rolamento.case import Case
    from rolamento.tasks.severity import SeverityResult

__all__ = [
    "LARGEST",
    "WORDS",
    "described",
    "ending_of",
    "example_file",
    "file_of",
    "label_of",
    "life_test_page",
    "plain_name",
    "plan_page",
    "report_file",
    "response_of",
    "signal_page",
]

Typed = Mapping[str, Sequence[str]]
"""What was typed, by names; more than one text where several may be given."""

LARGEST: Final[Mapping[str, int]] = {"signal": 256 * 2**20, "weibull": 5_000_000}
"""Bytes of an upload."""
_CASE: Final = "case"
_OF_MACHINE: Final = tuple(VibrationSeverity.options_by_heading()[MACHINE][1:])
"""What is asked for of the machine, beside its speed."""
_ENDINGS: Final = tuple(ending for many in ENDINGS.values() for ending in many)
_LONGEST_NAME: Final = 100
_SECONDS: Final[Mapping[str, float]] = {"signal": 120.0, "weibull": 60.0}
"""That a file may take: those that read damaged ones give up after a quarter of it."""

WORDS: Final[Mapping[str, str]] = {
    "title_signal": marked("Diagnose a vibration record"),
    "title_weibull": marked("Evaluate a life test"),
    "title_plan": marked("Plan a test that demonstrates a life"),
    "drop_signal": marked("Drop a vibration record here, or choose a file"),
    "drop_weibull": marked("Drop a table of lives here, or choose a file"),
    "formats_signal": marked("WAV, CSV, NumPy, MATLAB, HDF5, Parquet or UFF 58"),
    "formats_weibull": marked("CSV: a column of times, one of what failed; groups, if any"),
    "paste": marked("Or type or paste a table"),
    "paste_example": marked("time (h),status\n120,failed\n340,suspended"),
    "examples": marked("Try an example"),
    "more": marked("More options"),
    "none": marked("(not given)"),
    "run_signal": marked("Diagnose the record"),
    "run_weibull": marked("Evaluate the life test"),
    "run_plan": marked("Plan the test"),
    "cancel": marked("Cancel"),
    "remove": marked("Remove the file"),
    "no_file": marked("Choose a file first, or try an example."),
    "no_table": marked("Choose a file, or type or paste a table first."),
    "too_large": marked("The file is too large to be uploaded."),
    "sending": marked("Sending the file"),
    "working": marked("Calculating"),
    "cancelled": marked("Cancelled."),
    "no_answer": marked("The program does not answer. Is it still running?"),
    "of_options": marked("The options have changed since this result."),
    "save_as": marked("Save the result"),
    "result": marked("Result"),
}
"""What the page says by itself."""

_TYPES: Final[Mapping[str, str]] = {
    "html": "text/html; charset=utf-8",
    "pdf": "application/pdf",
    "md": "text/markdown; charset=utf-8",
    "txt": "text/plain; charset=utf-8",
    "csv": "text/csv; charset=utf-8",
    "xlsx": "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet",
    "json": "application/json",
}
REPORTS: Final = ("html", "pdf", "md", "txt", "json")
"""What a report of cases can be."""


@frozen
class _Example:
    """An example: what it is called, marked; the name of its file; what is typed beside it."""

    label: str
    file: str
    typed: Mapping[str, str]


_EXAMPLES: Final[Mapping[str, Mapping[str, _Example]]] = {
    "signal": {
        "outer_race": _Example(
            marked("synthetic: 6205 with damage to the outer race"),
            "synthetic-6205-outer-race.npz",
            {"bearing": "6205", "speed": "1797 rpm", "unit": "m/s^2"},
        ),
        "healthy": _Example(
            marked("synthetic: 6205 without damage"),
            "synthetic-6205-healthy.npz",
            {"bearing": "6205", "speed": "1797 rpm", "unit": "m/s^2"},
        ),
    },
    "weibull": {
        "campanha_2008": _Example(
            marked("6305 C3 in two conditions (Campanha, 2008)"),
            "campanha_2008.csv",
            {"calculated": ""},
        ),
        "lieblein_zelen_1956": _Example(
            marked("23 deep-groove ball bearings (Lieblein and Zelen, 1956)"),
            "lieblein_zelen_1956.csv",
            {},
        ),
    },
}


def described() -> dict[str, Any]:
    """Return what the page makes its forms of, in the language that is spoken."""
    return {
        "signal": _signal_form(),
        "weibull": LifeTestEvaluation.described(),
        "plan": DemonstrationTest.described(),
        "examples": {
            kind: [
                {"name": name, "label": said(one.label), "file": one.file, "typed": one.typed}
                for name, one in many.items()
            ]
            for kind, many in _EXAMPLES.items()
        },
        "endings": {"signal": list(_ENDINGS), "weibull": [".csv", ".tsv", ".txt", ".xlsx"]},
        "largest": dict(LARGEST),
        "files": list(_TYPES),
        "reports": list(REPORTS),
        "words": {key: said(text) for key, text in WORDS.items()},
    }


def _signal_form() -> list[dict[str, Any]]:
    """Return the form of a record: of its diagnosis, and, before the search, of the machine."""
    (machine,) = VibrationSeverity.described(MACHINE)
    machine["options"] = [one for one in machine["options"] if one["name"] in _OF_MACHINE]
    *groups, search = VibrationDiagnosis.described()
    return [*groups, machine, search]


# --- the work, each in a process of its own ----------------------------------------------------


def signal_page(path: str, label: str, typed: Typed, form: str = "") -> dict[str, Any]:
    """Diagnose a record, and measure its severity where its samples are calibrated.

    Parameters
    ----------
    path
        Of a private file.
    label
        What the user calls it.
    typed
        By the names of the form; ``case`` is the case on the page, as JSON.
    form
        "" for what the page shows; or the kind of a file.

    Raises
    ------
    InputError
        By the name of what was typed; of the file, by its label.
    """
    typed = dict(typed)
    page_case = typed.pop(_CASE, ())
    machine = {name: typed.pop(name) for name in _OF_MACHINE if name in typed}
    shared = {name: texts for name, texts in typed.items() if name in VibrationSeverity.inputs()}
    if not any(text.strip() for text in typed.get("bearing", ())):
        typed["bearing"] = ()
        own = {"bearing": _case_on_page(page_case[-1] if page_case else "")}
    else:
        own = {}
    with _labelled((VibrationDiagnosis, VibrationSeverity), path, label):
        asked = VibrationDiagnosis.read(typed, signal=path, **own)
        found: Any = asked.run()
        found = replace(found, title=_named(found.title, path, label))
        mapping = found.to_mapping()
        severity = _severity(path, {**machine, **shared}, any(map(any, machine.values())))
        pages = [asked.page(found)]
        if severity is not None:
            measured = [replace(one, title=label) for one in severity.measured]
            severity = replace(severity, measured=tuple(measured))
            mapping["severity"] = severity.to_mapping()
            pages.append(severity.page())
        return _answer(pages, mapping, found.verdict, form)


def life_test_page(path: str, label: str, typed: Typed, form: str = "") -> dict[str, Any]:
    """Evaluate a life test; parameters as of `signal_page`."""
    from rolamento.io.tables import table_text
    from rolamento.weibull import parse_life_test

    with _labelled((LifeTestEvaluation,), path, label):
        asked = LifeTestEvaluation.read(typed)
        test = parse_life_test(table_text(path)[0], label, **asked.reading)
        asked = asked.replace(data=test)
        found = asked.run()
        verdict = "result" if found.has_result else "no_result"
        return _answer((asked.page(found),), found.to_mapping(), verdict, form)


def plan_page(typed: Typed, form: str = "") -> dict[str, Any]:
    """Plan a test that demonstrates a life; parameters as of `signal_page`."""
    with _labelled((DemonstrationTest,)):
        found = DemonstrationTest.read(typed).run()
        verdict = "result" if found.plan.planned else "no_result"
        return _answer((found.page(),), found.to_mapping(), verdict, form)


def report_file(
    cases: Sequence[Mapping[str, Any]],
    head: Mapping[str, str | None],
    form: str,
    names: Sequence[str] = (),
) -> dict[str, Any]:
    """Return the report of the cases on the page as a file.

    Parameters
    ----------
    cases
        As their files have them.
    head
        project, author, revision, date, checked_by; what is missing is as in the first case.
    form
        Kind of the file, one of `REPORTS`.
    names
        Of several cases; A, B, C … if not given.

    Raises
    ------
    InputError
        If a case is not valid, or there is no such kind of file.
    """
    from rolamento.case import Case
    from rolamento.case.report import ReportHead
    from rolamento.tasks import ReportRequest

    one_of(form, "format", REPORTS, "pdf")
    given = {name: one for name, one in head.items() if one is not None}
    asked = ReportRequest(
        case=[Case.from_mapping(one) for one in cases],
        **ReportHead.from_mapping(given).to_mapping(),
        names=names,
    )
    found = asked.run()
    return _answer((asked.page(found),), found.found.to_mapping(), "", form)


def example_file(kind: str, name: str) -> dict[str, Any]:
    """Return a file to try; records are made when they are asked for, and say that they are.

    Raises
    ------
    InputError
        If there is no such example.
    """
    known = _EXAMPLES[kind]
    one_of(name, "name", known)
    file = known[name].file
    if kind == "weibull":
        from rolamento.weibull import published_text

        return {"content": published_text(name).encode(), "name": file, "type": _TYPES["csv"]}
    with TemporaryDirectory(prefix="rolamento-") as folder:
        path = Path(folder) / file
        _synthesise(path, damaged=name == "outer_race")
        content = path.read_bytes()
    return {"content": content, "name": file, "type": "application/octet-stream"}


def _synthesise(path: Path, *, damaged: bool) -> None:
    """Make a record of a 6205 in noise; the damage, if any, is clear."""
    from rolamento import tasks
    from rolamento.vibration.synthesis import Fault, Noise

    tasks.synthesise(
        designated("6205"),
        path,
        speed="1797 rpm",
        faults=[Fault(kind="outer_race", jitter=0.01)] if damaged else [],
        shaft_harmonics=(0.3, 0.1),
        noise=Noise(ratio=3.0) if damaged else Noise(level=0.5),
        duration=5.0,
        rate=12_000.0,
        seed=1,
    )


# --- parts of the work -------------------------------------------------------------------------


def _case_on_page(text: str) -> Case:
    """Return the case on the page."""
    if not text:
        raise InputError(said("is missing"), field="bearing", example="6205")
    from rolamento.case import Case
    from rolamento.io.text import parse_mapping

    return Case.from_mapping(parse_mapping(text, "json", ""))


def _severity(path: str, typed: Typed, was_asked: bool) -> SeverityResult | None:
    """Measure the severity; None of samples that are not calibrated, if it was not asked for."""
    try:
        return VibrationSeverity.read(typed, signals=path).run()
    except InputError:
        if was_asked:
            raise
        return None


@contextmanager
def _labelled(requests: Sequence[type[UseCase]], path: str = "", label: str = "") -> Iterator[None]:
    """Call what is said as the page does: fields by their labels, the file by its own name."""
    known = {name: one for request in requests for name, one in request.inputs().items()}
    labels = {name: said(one.label) for name, one in known.items()}
    names = {name: said("“{label}”", label=label) for name, label in labels.items()}
    names["rolamento diagnose"] = said("the diagnosis")
    try:
        with spelling(partial(as_labelled, names)):
            yield
    except InputError as error:
        field = error.source if error.source in labels else error.field
        spelled = error.spelled(labels, "{}: {}".format)
        source = "" if error.source in labels else label if error.source == path else error.source
        # an example that is written as in Python is of no use on a page
        as_typed = field not in known or spelled.example == error.example
        raise type(error)(
            _named(spelled.rule, path, label),
            field=field,
            value=error.value,
            example=spelled.example if as_typed else known[field].example,
            source=source,
            line=error.line,
        ) from None


def _named(text: str, path: str, label: str) -> str:
    """Return a text that calls a file by what the user calls it."""
    return text.replace(path, label).replace(os.path.basename(path), label) if path else text


def _answer(
    pages: Sequence[Document], mapping: dict[str, Any], code: str, form: str
) -> dict[str, Any]:
    """Return what the page shows, one page behind the other, or a file of them."""
    sections = tuple(part for page in pages for part in page.sections)
    document = replace(pages[0], sections=sections)
    if form:
        return file_of(document, mapping, form)
    from rolamento.document.html import body

    statements = [block for block in document.blocks() if isinstance(block, Statement)]
    first = next((one for one in statements if one.tone != "faint"), None)
    return {
        "verdict": {
            "code": code,
            "text": "" if first is None else first.text,
            "tone": "" if first is None else first.tone,
        },
        "title": document.title,
        "html": "".join(_below(body(_pictures_first(one), images=True)) for one in pages),
        "files": [one for one in _TYPES if one not in ("csv", "xlsx") or document.tables()],
    }


def _pictures_first(document: Document) -> Document:
    """Return a document whose pictures stand behind its first section: the verdict, or the data."""
    parts = list(document.sections)
    first = next(place for place, part in enumerate(parts, 1) if isinstance(part, Section))
    pictures = [part for part in parts if part.key == "figures"]
    others = [part for part in parts[first:] if part.key != "figures"]
    return replace(document, sections=(*parts[:first], *pictures, *others))


def _below(html: str) -> str:
    """Return a page as a part of another: its headings stand a level lower."""
    return re.sub(r"(</?h)([1-5])", lambda at: at[1] + str(int(at[2]) + 1), html)


def file_of(document: Document, mapping: dict[str, Any], form: str) -> dict[str, Any]:
    """Return a document, its tables or its numbers as a file: its content, name and type."""
    name = f"{plain_name(document.title) or 'rolamento'}.{form}"
    return {"content": _file(document, mapping, form), "name": name, "type": _TYPES[form]}


def _file(document: Document, mapping: dict[str, Any], form: str) -> bytes:
    """Return a document, its tables or its numbers as a file."""
    if form == "html":
        from rolamento.document.html import html

        return html(document).encode()
    if form == "pdf":
        from rolamento.document.pdf import pdf

        return pdf(document)
    if form == "md":
        from rolamento.document.markdown import markdown

        return markdown(document).encode()  # its pictures would be files beside it
    if form == "txt":
        from rolamento.document.medium import WIDEST, Medium
        from rolamento.document.terminal import terminal

        return terminal(document, Medium(width=WIDEST)).encode()
    if form == "csv":
        from rolamento.document.tables import to_csv

        decimal = manner().mark
        text = to_csv(document, separator=";" if decimal == "," else ",", decimal=decimal)
        return b"\xef\xbb\xbf" + text.encode()
    if form == "xlsx":
        from rolamento.document.tables import to_xlsx

        return to_xlsx(document)
    if form == "json":
        from rolamento.io.json import dumps

        return (dumps(mapping, indent=2) + "\n").encode()
    rule = said("must be one of {known}", known=", ".join(_TYPES))
    raise InputError(rule, field="format", value=form, example="pdf")


def plain_name(title: str) -> str:
    """Return a title as the name of a file, in plain letters."""
    letters = unicodedata.normalize("NFKD", title).encode("ascii", "ignore").decode()
    return re.sub(r"[^A-Za-z0-9]+", "-", letters).strip("-").lower()[:60].strip("-")


# --- what the page asks --------------------------------------------------------------------------

_PAGES: Final = {"signal": signal_page, "weibull": life_test_page}


async def _dropped(request: Request) -> Response:
    """Answer with what a file says: its body is the file, the address has the options."""
    kind = request.url.path.rpartition("/")[2]
    typed, form = _typed(request)
    label = label_of(unquote(request.headers.get("x-file-name", "")), kind)
    async with received(request, LARGEST[kind], ending_of(label, kind)) as path:
        found = await slow(_PAGES[kind], str(path), label, typed, form, seconds=_SECONDS[kind])
    return response_of(found)


async def _planned(request: Request) -> Response:
    """Answer with a planned test; the address has the options."""
    return response_of(await slow(plan_page, *_typed(request), seconds=_SECONDS["weibull"]))


async def _reported(request: Request) -> Response:
    """Answer with the report of cases: ``cases``, ``format``, and ``head`` if there is one."""
    asked = await read_json(request)
    cases, head = asked.get("cases"), asked.get("head") or {}
    if not isinstance(cases, list) or not all(isinstance(one, dict) for one in cases):
        raise InputError(said("must be a list of tables"), field="cases")
    if not isinstance(head, dict):
        raise InputError(said("must be a table"), field="head")
    names = asked.get("names") or []
    if not isinstance(names, list) or not all(isinstance(one, str) for one in names):
        raise InputError(said("must be a list of names"), field="names", example='["A", "B"]')
    names = [one[:_LONGEST_NAME] for one in names] if len(names) == len(cases) else []
    form = str(asked.get("format", "html"))
    return response_of(
        await slow(report_file, cases, head, form, names, seconds=_SECONDS["weibull"])
    )


async def _example(request: Request) -> Response:
    """Answer with a file to try."""
    kind, name = (request.path_params[part] for part in ("kind", "name"))
    if kind not in _EXAMPLES:
        raise HTTPException(404)
    return response_of(await slow(example_file, kind, name))


ROUTES: Final = (
    *(Route(f"/page/{kind}", _dropped, methods=["PUT"]) for kind in _PAGES),
    Route("/page/weibull/plan", _planned, methods=["POST"]),
    Route("/page/report", _reported, methods=["POST"]),
    Route("/page/example/{kind}/{name}", _example),
)


def _typed(request: Request) -> tuple[dict[str, list[str]], str]:
    """Return what an address says, by names, and which kind of file is asked for."""
    typed: dict[str, list[str]] = {}
    for name, text in request.query_params.multi_items():
        typed.setdefault(name, []).append(text)
    typed.pop("lang", None)
    form = typed.pop("format", [""])[-1]
    if form:
        one_of(form, "format", _TYPES, "pdf")
    return typed, form


def response_of(found: dict[str, Any]) -> Response:
    """Return JSON, or a file to be saved under its name."""
    if "content" not in found:
        return answer(found)
    headers = {"content-disposition": f'attachment; filename="{found["name"]}"'}
    return Response(found["content"], headers=headers, media_type=found["type"])


def label_of(name: str, kind: str = "") -> str:
    """Return what to call a file that a client calls so: its last part, in one line."""
    last = re.split(r"[/\\]", name)[-1]
    shown = "".join(sign for sign in last if sign.isprintable()).strip()[-_LONGEST_NAME:]
    return shown or (said("typed table") if kind == "weibull" else said("file"))


def ending_of(label: str, kind: str) -> str:
    """Return the ending of a file's name, if it is one that is read."""
    ending = os.path.splitext(label)[1].lower()
    return ending if kind == "signal" and ending in _ENDINGS else ""
