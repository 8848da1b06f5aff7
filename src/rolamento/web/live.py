"""What the page shows of a case, or of up to four side by side, while they are changed."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from functools import cached_property, lru_cache
from time import perf_counter
from typing import Any, Final

from rolamento import __version__
from rolamento.analysis import Analysis
from rolamento.case import Case
from rolamento.case.fields import changed
from rolamento.case.report import ReportHead
from rolamento.document import Document, Section
from rolamento.document.html import body
from rolamento.errors import InputError
from rolamento.pages.given import no_load_text
from rolamento.pages.report import (
    PARTS,
    KeyFigure,
    comparison_sections,
    key_figures,
    part_of,
    remarks_section,
    warnings_section,
)
from rolamento.records import frozen
from rolamento.solved.notes import nothing_given
from rolamento.tasks.report import CaseReport, Input, Report, analysis_of, inputs_of, names_in
from rolamento.web.answers import error_object
from rolamento.web.form import inputs, labelled, likely
from rolamento.web.pictures import figures
from rolamento.web.section import section_svg
from rolamento.words import language, said
from rolamento.words.reasons import reason

__all__ = ["MOST_CASES", "live"]

MOST_CASES: Final = 4
_NAMES: Final = "ABCD"
_LONGEST_NAME: Final = 40
_REMEMBERED: Final = 64
"""Analyses: of two cases side by side one stays as it is while the other is moved."""


@frozen(slots=False)
class _Given:
    """A case as the page holds it, read and analysed; named: what its tables say."""

    case: Case
    named: frozenset[str]
    analysis: Analysis

    @cached_property
    def inputs(self) -> tuple[Input, ...]:
        """What the case says, and what it does not and still counts."""
        return inputs_of(self.case, self.named)


def live(request: Mapping[str, Any]) -> dict[str, Any]:
    """Return what the page shows of the cases of a request.

    Parameters
    ----------
    request
        ``cases``: one to four of ``{"case": tables as a file has them, "changes": {field: value
        as a file has it, or None}, "name": what it is called}``; ``active``: the place of the one
        that is edited, which pictures show beside the first; ``pictures``, ``sections``: keys of
        what is seen; ``quick``: leave out what is slow.

    Raises
    ------
    InputError
        If it is no such request; a case that is wrong is reported in its place.
    """
    began = perf_counter()
    entries = request.get("cases")
    if not isinstance(entries, list) or not 1 <= len(entries) <= MOST_CASES:
        raise InputError(
            said("must be a list of 1 to {most} cases", most=MOST_CASES),
            field="cases",
            example='[{"case": {"bearing": {"designation": "6310"}, "duty": {}}, "changes": {}}]',
        )
    quick = request.get("quick") is True
    told: list[dict[str, Any]] = []
    found: list[_Given | None] = []
    for entry in entries:
        answer, given = _one(entry, quick=quick)
        told.append(answer)
        found.append(given)
    keys, parts = (_names(request, name) for name in ("pictures", "sections"))
    called = [_called(entry, place) for place, entry in enumerate(entries)]
    drawn = _drawn(request, len(found))
    analyses = [None if one is None else one.analysis for one in (found[at] for at in drawn)]
    names = [called[place] for place in drawn]
    return {
        "cases": told,
        "pictures": figures(analyses, keys, names=names),
        **_documents(found, called, parts, quick=quick),
        "milliseconds": 1e3 * (perf_counter() - began),
    }


def _called(entry: Any, place: int) -> str:
    """What the reader calls a case: a line of text, or its letter."""
    given = entry.get("name") if isinstance(entry, Mapping) else None
    text = " ".join(str(given).split())[:_LONGEST_NAME] if isinstance(given, str) else ""
    return text or _NAMES[place]


def _drawn(request: Mapping[str, Any], count: int) -> list[int]:
    """Places of the cases that pictures show: the first, and the edited one or the second."""
    active = request.get("active", 0)
    if isinstance(active, bool) or not isinstance(active, int) or not 0 <= active < count:
        active = 0
    return [0] if count == 1 else [0, active or 1]


def _names(request: Mapping[str, Any], name: str) -> list[str]:
    given = request.get(name, [])
    if not isinstance(given, list) or not all(isinstance(one, str) for one in given):
        raise InputError(said("must be a list of names"), field=name, example='["rosette"]')
    return given


def _one(entry: object, *, quick: bool) -> tuple[dict[str, Any], _Given | None]:
    mapping: Any = entry.get("case") if isinstance(entry, Mapping) else None
    changes: Any = entry.get("changes") or {} if isinstance(entry, Mapping) else None
    if not isinstance(mapping, Mapping) or not isinstance(changes, Mapping):
        raise InputError(
            said("must have the tables of a case, and may have changes"),
            field="cases",
            example='{"case": {"bearing": {"designation": "6310"}, "duty": {}}, "changes": {}}',
        )
    answer: dict[str, Any] = {"case": mapping, "status": None, "error": None}
    try:
        answer["case"] = mapping = changed(mapping, changes, Case, in_file=True)
        given = _given(json.dumps(mapping, sort_keys=True), quick)
    except InputError as error:
        return {**answer, "error": error_object(labelled(error))}, None
    solved = given.analysis.solved
    code, advice = str(solved.status.code[0]), solved.advice[0]
    text = reason(code)
    unloaded = bool(solved.converged[0]) and nothing_given(solved)
    if unloaded:
        text = no_load_text()
        advice = next(note for note in solved.notes[0] if note.key == "no_load_given")
    answer["status"] = {
        "code": code,
        "converged": bool(solved.converged[0]),
        "text": text,
        "advice": None if advice is None else advice.text,
        "unloaded": unloaded,
        "left_out": list(given.analysis.left_out),
    }
    answer["title"] = given.case.title
    answer["drawing"] = section_svg(given.case, solved)
    answer["elements"] = sorted({place.bearing.element for place in given.case.bearing.places})
    if not quick:
        answer["inputs"] = inputs(given.inputs)
        answer["likely"] = likely(given.analysis)
    return answer, given


@lru_cache(maxsize=_REMEMBERED)
def _given(text: str, quick: bool) -> _Given:
    mapping = json.loads(text)
    case = Case.from_mapping(mapping)
    return _Given(case, frozenset(names_in(mapping)), analysis_of(case, quick=quick))


def _documents(
    found: Sequence[_Given | None], names: Sequence[str], keys: Sequence[str], *, quick: bool
) -> dict[str, Any]:
    """Key figures, what differs, the parts that are open, and what the reader should know."""
    there = [(name, one) for name, one in zip(names, found, strict=True) if one is not None]
    if not there:
        return {"figures": [], "summary": "", "same": "", "leading": "", "notes": "",
                "sections": {}}  # fmt: skip
    asks = "inputs" in keys or len(there) > 1
    cases = tuple(
        CaseReport(name, "", one.case, one.inputs if asks else (), one.analysis)
        for name, one in there
    )
    report = Report(ReportHead(), cases, __version__)
    wanted = [key for key in dict.fromkeys(keys) if key in PARTS]
    differing, same = comparison_sections(report) if len(there) > 1 else (None, None)
    own = iter(cases)
    shown = [None if one is None else next(own) for one in found]
    return {
        "figures": [
            [] if one is None else list(map(_table_of, key_figures(one, report))) for one in shown
        ],
        "summary": _html(differing),
        "same": _html(same),
        "leading": "" if quick else _html(warnings_section(report)),
        "notes": "" if quick else _html(remarks_section(report)),
        "sections": {key: _html(part_of(report, key)) for key in wanted},
    }


def _table_of(figure: KeyFigure) -> dict[str, Any]:
    return {one.name: getattr(figure, one.name) for one in fields(figure)}


def _html(section: Section | None) -> str:
    if section is None or not section.blocks:
        return ""
    return body(Document("", (replace(section, heading=""),), kind="live", language=language()))
