"""The page of a report that an engineer signs: one case, or several side by side.

Every number is one of `CaseReport.numbers`, which the JSON holds too: a row of a table names it by
its path there, in a column that stands only in files.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from math import inf, isfinite, nan
from typing import TYPE_CHECKING, Final, cast

from rolamento import document as doc
from rolamento.case import Case
from rolamento.case.duty import AXES, LOADS
from rolamento.friction.model import REMARKS
from rolamento.friction.models import torque_model_name
from rolamento.life.record import BOUNDS, OUTSIDE, UNRATED, note_of
from rolamento.life.theories import THEORIES
from rolamento.pages import quantities as q
from rolamento.pages.clearance import STEPS, chain_lines, limit_heads
from rolamento.pages.electrical import electrical_sections
from rolamento.pages.elements import CONTACT_UNITS, contact_name, element_tables, roller_pictures
from rolamento.pages.equations import equations_of, references_of
from rolamento.pages.film import FILMS
from rolamento.pages.frequencies import line_name
from rolamento.pages.friction import SOURCES, power_unit, source_name, torque_unit
from rolamento.pages.given import no_load_text, title_of
from rolamento.pages.life import LONGEST_LIFE, hours_text, rating_source, theory_table, verdict
from rolamento.pages.preload import STAGE_NAMES
from rolamento.pages.state import rosette_section, stiffness_section
from rolamento.pages.static import static_sections
from rolamento.records import frozen
from rolamento.solved.notes import nothing_given
from rolamento.vibration.frequencies import ABBREVIATIONS, LineName
from rolamento.words import Note, manner, marked, said, worded
from rolamento.words.headlines import qualifies
from rolamento.words.quantities import called
from rolamento.words.reasons import why_not
from rolamento.words.theories import theory_name

if TYPE_CHECKING:
    from rolamento.friction import Friction
    from rolamento.geometry import Race
    from rolamento.life import Life, LifeSummary
    from rolamento.numerics import FloatArray
    from rolamento.solved import Preloading, Solved
    from rolamento.tasks.report import CaseReport, Input, Report
    from rolamento.tasks.time_line import ServiceLife

__all__ = [
    "ORIGINS",
    "PARTS",
    "TABLES",
    "KeyFigure",
    "Part",
    "comparison_page",
    "comparison_sections",
    "key_figures",
    "part_of",
    "remarks_section",
    "report_page",
    "summary_section",
    "warnings_section",
]

_Quantity = q.Quantity["CaseReport"]
_Group = q.Group["CaseReport"]


def report_page(report: Report) -> doc.Document:
    """Return a report: title block, summary, inputs, results, remarks, equations, provenance.

    Parameters
    ----------
    report
        What `rolamento.tasks.calculation_report` gathered.
    """
    solved = [case for case in report.cases if case.converged]
    remarks = _remarks(report)
    parts = [
        (said("Summary"), _summary(report), "summary", ()),
        (said("Inputs"), (), "inputs", _inputs(report)),
        *([(said("Results"), (), "results", _results(report))] if solved else []),
        *([(said("Remarks"), remarks, "remarks", ())] if remarks else []),
        *([(said("Equations used"), equations_of(solved), "equations", ())] if solved else []),
        *([(said("Validity"), (), "validity", _validity(report))] if solved else []),
        *([(said("References"), _references(solved), "references", ())] if solved else []),
        (said("Provenance"), _provenance(report), "provenance", ()),
    ]
    sections: list[doc.Section | doc.Beside] = [_head(report)]
    for number, (heading, blocks, key, inner) in enumerate(parts, start=1):
        sections.append(doc.Section(f"{number}  {heading}", tuple(blocks), key, 1))
        sections += inner
    many = len(report.cases) > 1
    return doc.Document(
        _title(report) if many else report.cases[0].title or title_of(report.cases[0].case),
        tuple(sections),
        kind="report",
        main="summary",
        program=said("Rolamento {version}", version=report.version),
        date=report.head.date,
    )


def comparison_page(report: Report, title: str = "") -> doc.Document:
    """Return a page of several cases side by side: what differs in them, and what follows.

    Parameters
    ----------
    report
        Of the cases; the others are compared with the first.
    title
        Of the page.
    """
    differing, *_ = _inputs(report)
    sections: list[doc.Section | doc.Beside] = [
        doc.Section("", (doc.Title(title or said("Comparison")),), "title"),
        summary_section(report),
        replace(differing, level=2),
        *(part_of(report, key) for key in _COMPARED),
        remarks_section(report),
    ]
    kept = tuple(one for one in sections if isinstance(one, doc.Beside) or one.blocks)
    return doc.Document(title or said("Comparison"), kept, kind="comparison", main="summary")


def summary_section(report: Report, *, advice: bool = True) -> doc.Section:
    """Return what leads: the status of each case, what qualifies it, life, pressure, torque.

    advice: whether a case without a result says what to do, and not only why.
    """
    return doc.Section(said("Summary"), _summary(report, advice=advice), "summary")


def warnings_section(report: Report) -> doc.Section:
    """Return the limits that are passed, and what the summary has to be read with."""
    return doc.Section(said("Warnings"), _qualifications(report), "warnings")


def remarks_section(report: Report) -> doc.Section:
    """Return what else the reader should know; without blocks where there is nothing."""
    return doc.Section(said("Remarks"), _remarks(report), "remarks")


def part_of(report: Report, key: str) -> doc.Section:
    """Return a part of the results by its key in `PARTS`; without blocks where no case has it."""
    part = PARTS[key]
    return doc.Section(said(part.label), tuple(part.blocks(report)), key)


# --- the head -------------------------------------------------------------------------------------


def _head(report: Report) -> doc.Section:
    head = report.head
    entries = [
        *([doc.Entry(said("project"), head.project)] if head.project else []),
        *_case_titles(report),
        *([doc.Entry(said("author"), head.author)] if head.author else []),
        *([doc.Entry(said("revision"), head.revision)] if head.revision else []),
        doc.Entry(said("date"), head.date),
        doc.Entry(said("checked by"), head.checked_by or "_" * 24),
        doc.Entry(said("program"), said("Rolamento {version}", version=report.version)),
    ]
    blocks = (doc.Title(_title(report)), doc.KeyValues(tuple(entries)), _drawing(report.cases[0]))
    return doc.Section("", blocks, "title_block")


def _drawing(case: CaseReport) -> doc.Figure:
    """The bearing in section, with what acts on it."""
    from rolamento.plots.bearing_section import draw_section, section_drawing

    drawing = section_drawing(case.case, case.analysis.solved)
    return doc.Figure(
        drawing.remark, lambda: draw_section(drawing), "section", alternative=drawing.said
    )


def _title(report: Report) -> str:
    count = len(report.cases)
    if count == 1:
        return said("Bearing calculation report")
    return said("Bearing calculation report: comparison of {n} cases", n=count)


def _case_titles(report: Report) -> list[doc.Entry]:
    if len(report.cases) == 1:
        return [doc.Entry(said("case"), report.cases[0].title or title_of(report.cases[0].case))]
    return [
        doc.Entry(said("case {name}", name=case.name), case.title or title_of(case.case))
        for case in report.cases
    ]


# --- warnings -------------------------------------------------------------------------------------


@frozen
class _Warning:
    """What the reader should know of a case.

    weight: 0 a limit passed, 1 what qualifies the summary, 2 a remark.
    """

    weight: int
    text: str
    key: str


def _warnings(report: Report) -> list[tuple[_Warning, str]]:
    """Return all warnings, the gravest first, each with the names of its cases."""
    found: dict[_Warning, list[str]] = {}
    for case in report.cases:
        for warning in dict.fromkeys(_warnings_of(case)):
            found.setdefault(warning, []).append(case.name)
    listed = [(warning, ", ".join(names)) for warning, names in found.items()]
    return sorted(listed, key=lambda item: item[0].weight)


def _warnings_of(case: CaseReport) -> Iterator[_Warning]:
    analysis = case.analysis
    if not case.converged:  # the status says why
        return
    if not nothing_given(analysis.solved):
        yield from _life_warnings(case)
    yield from _friction_warnings(case)
    for check in case.checks:
        if not check.met and check.name in _CHECKS and not check.name.startswith("film"):
            text = said("Limit exceeded: {limit}.", limit=said(_CHECKS[check.name][0]))
            yield _Warning(0, text, f"limit_{check.name}")
    notes: list[Note] = [*analysis.solved.notes[0], *analysis.notes]
    if analysis.film is not None:
        notes += analysis.film.notes_of(0)
    if analysis.frequencies is not None:
        notes += analysis.frequencies.notes
    for note in notes:
        yield _Warning(_weight(note), note.text, note.key)


def _weight(note: Note) -> int:
    return 1 if qualifies(note) else 2


def _failure(case: CaseReport, *, advised: bool) -> str:
    """Say why a case has no result, and what to do."""
    solved = case.analysis.solved
    advice = solved.advice[0] if advised else None
    text = said("No solution: {reason}.", reason=why_not(solved))
    return text if advice is None else f"{text} {advice.text}"


def _life_warnings(case: CaseReport) -> Iterator[_Warning]:
    life = case.analysis.life
    if life is None:
        return
    if not life.headline.valid[0] and not life.headline.below[0]:
        yield _Warning(0, said("No theory of life is valid for this case."), "no_life_valid")
    leading = life.qualifications()
    theories: dict[str, list[str]] = {}
    for name, own in life.theories.items():
        for note in own.notes_of(0):
            theories.setdefault(note.key, []).append(name)
    for note in leading:
        if note.key not in theories:
            yield _Warning(1, note.text, note.key)
    for key, concerned in theories.items():
        always = key in BOUNDS and all(THEORIES[name].bound for name in concerned)
        known = life.headline.valid[0] and key in UNRATED  # to another theory
        refuses = key in OUTSIDE | BOUNDS and not (always or known)
        names = [theory_name(name) for name in concerned]
        what = "; ".join(names) if len(names) < len(life.theories) else said("all theories")
        text = note_of(key, life.headline.element).text
        if key in OUTSIDE:
            shown = said("Life, not valid ({theories}): {reason}", theories=what, reason=text)
        else:
            shown = said("Life ({theories}): {reason}", theories=what, reason=text)
        leads = any(note.key == key for note in leading)
        yield _Warning(0 if refuses else 1 if leads else 2, shown, key)


def _friction_warnings(case: CaseReport) -> Iterator[_Warning]:
    friction = case.analysis.friction
    if friction is None:
        return
    refused: dict[Note, list[str]] = {}
    for found in friction.judged:
        for note in found.notes_of(0):
            refused.setdefault(note, []).append(found.model)
    for note in friction.qualifications(case.analysis.solved):
        if note not in refused:
            yield _Warning(2 if note.key == "coefficient_by_regime" else 1, note.text, note.key)
    for note, models in refused.items():
        names = "; ".join(map(torque_model_name, models))
        shown = said("Friction ({models}): {reason}", models=names, reason=note.text)
        limits = friction.model in models and note.key not in REMARKS
        chosen = friction.model in models
        yield _Warning(0 if limits else _weight(note) if chosen else 2, shown, note.key)


_REMARK: Final = 2
_TONES: Final[tuple[doc.Tone, ...]] = ("bad", "warning", "")


def _qualifications(report: Report) -> tuple[doc.Statement | doc.Notes, ...]:
    """Return what the summary has to be read with: limits that are passed, then other notes."""
    found = [one for one in _warnings(report) if one[0].weight < _REMARK]
    if found:
        return (_notes(report, found),)
    loaded = all(
        case.converged and not nothing_given(case.analysis.solved) for case in report.cases
    )
    return (doc.Statement(said("No warnings."), "good", mark="✓"),) if loaded else ()


def _remarks(report: Report) -> tuple[doc.Notes, ...]:
    """Return what else is to be known; nothing without."""
    found = [one for one in _warnings(report) if one[0].weight == _REMARK]
    return (_notes(report, found),) if found else ()


def _notes(report: Report, warnings: Sequence[tuple[_Warning, str]]) -> doc.Notes:
    many = len(report.cases) > 1
    remarks = []
    for warning, names in warnings:
        text = warning.text
        if many:
            text = said("Case {names}: {text}", names=names, text=text)
        remarks.append(doc.Remark(text, warning.key, _TONES[warning.weight]))
    return doc.Notes(tuple(remarks))


# --- summary --------------------------------------------------------------------------------------


def _summary(
    report: Report, *, advice: bool = True
) -> tuple[doc.Statement | doc.Notes | doc.Table, ...]:
    many = len(report.cases) > 1
    statements = [_status_statement(case, many=many, advice=advice) for case in report.cases]
    solved = [case.analysis.solved for case in report.cases if case.converged]
    rows = _summary_rows(report) if not all(map(nothing_given, solved)) else []
    tables = q.tables_of(report.cases, [("", rows)], "summary")
    if len(report.cases) == 1 and tables:
        tables = (_with_limits(report, rows, tables[0]),)
    return (*statements, *_verdict_of(report), *tables, *_qualifications(report))


def _with_limits(report: Report, rows: Sequence[_Quantity], table: doc.Table) -> doc.Table:
    """The table of the summary with what each row is held against."""
    case = report.cases[0]
    shown = [row for row in rows if row.known(report.cases)]
    found = [_limit_of(case, row) if case.converged else ("", None, "") for row in shown]
    if not any(limit for limit, _, _ in found):
        return table
    *columns, path = table.columns
    tones: list[doc.Tone] = [tone for _, _, tone in found]
    limits = doc.Column(said("limit"), [one[0] for one in found], "limit", tones=tones)
    return replace(table, columns=(*columns, limits, path))


def _verdict_of(report: Report) -> tuple[doc.Statement, ...]:
    """Say in a line whether the limits that are checked are kept; nothing without a result."""
    found: list[doc.Statement] = []
    for case in report.cases:
        figures = key_figures(case, report)
        if not figures:
            continue
        grave = [one.text for one in _warnings_of(case) if one.weight == 0]
        beyond = [one.label for one in figures if one.tone == "bad"]
        if beyond or grave:
            names = "; ".join(beyond) or said("see the warnings")
            text, tone, mark = said("Beyond its limits: {names}.", names=names), "bad-strong", "✗"
        else:
            text, tone, mark = said("Within the limits that are checked."), "good", "✓"
        if len(report.cases) > 1:
            text = said("Case {names}: {text}", names=case.name, text=text)
        found.append(doc.Statement(text, cast("doc.Tone", tone), mark=mark))
    return tuple(found)


def _status_statement(case: CaseReport, *, many: bool, advice: bool) -> doc.Statement:
    status = case.analysis.solved.status
    empty = case.converged and nothing_given(case.analysis.solved)
    if empty:
        text = no_load_text()
    elif case.converged:
        text = said(
            "converged in {iterations} iterations, residual {residual:.1e}",
            iterations=int(status.iterations[0]),
            residual=float(status.residual[0]),
        )
    else:
        text = _failure(case, advised=advice)
    if many:
        text = said("Case {names}: {text}", names=case.name, text=text)
    if empty:
        return doc.Statement(text, "warning-strong", mark="!")
    return doc.Statement(text, "good" if case.converged else "bad-strong",
                     mark="✓" if case.converged else "✗")  # fmt: skip


def _summary_rows(report: Report) -> list[_Quantity]:
    torque, power = _torque_form(report), _power_form(report)
    return [
        _life_row(report),
        q.Quantity(said("theory used"), _leading),
        q.Quantity(
            called("required_life_reliability"),
            _reliability,
            ".4 %",
            "analysis.life.required_life.reliability",
        ),
        _static_safety(),
        _load_ratio(),
        q.extreme(called("max_pressure"), "max_pressure", ".4 MPa"),
        _viscosity_ratio(),
        q.extreme(said("minimum film parameter λ"), "film_parameter", ".3"),
        q.Quantity(said("speed"), _speed, ".5 rpm"),
        q.FRICTION(_bounded(report, "torque"), "torque", torque),
        q.FRICTION(_bounded(report, "power"), "power", power),
        q.ROLLING(called("rolling_power"), "power", power),
        _clearance_row(said("mean clearance in operation"), "mean"),
        q.PRELOAD(said("axial preload at speed"), "at_speed", ".4 N"),
        _stiffness_row(said("axial stiffness"), 0),
        _stiffness_row(said("radial stiffness (z)"), 2),
    ]


def _reliability(case: CaseReport) -> float | None:
    life = case.analysis.life
    wanted = None if life is None else life.conditions.required_life
    if life is None or wanted is None:
        return None
    return float(life.reliability_after(wanted)[0])


def _speed(case: CaseReport) -> float | None:
    """The speed of the rings against each other, where there is a limit of it."""
    limit = case.speed_limit
    return None if limit is None else limit.share * limit.speed


def _static_safety() -> _Quantity:
    return q.LIFE(
        called("static_safety"), "loads.static_safety", ".3", lambda own: own.loads.safety
    )


def _load_ratio() -> _Quantity:
    return q.extreme(called("load_ratio"), "load_ratio", ".3")


def _viscosity_ratio() -> _Quantity:
    return q.FILM(called("viscosity_ratio"), "viscosity_ratio", ".3")


def _clearance_row(label: str, name: str) -> _Quantity:
    def of(case: CaseReport) -> float | None:
        return None if case.clearance is None else float(getattr(case.clearance, name))

    return q.Quantity(label, of, ".3 µm", f"clearance.{name}")


def _stiffness_row(label: str, at: int) -> _Quantity:
    form = ".4 N/µm" if at < 3 else ".4 N·m/mrad"
    return q.SOLVED(label, f"stiffness.{at}.{at}", form, lambda own: own.stiffness.array[0, at, at])


# --- key figures ----------------------------------------------------------------------------------


@frozen
class KeyFigure:
    """A result that leads, with its limit beside it.

    Attributes
    ----------
    key
        path of the number in `CaseReport.numbers`; of a text what it is of
    label
        what it is called
    value, unit
        as people read them
    limit
        what it is held against, with its unit, such as "of 4200 MPa"; empty without
    share
        of the limit that is used; None without a limit
    tone
        "bad" beyond a limit, "warning" where a limit is no refusal; empty else
    """

    key: str
    label: str
    value: str
    unit: str = ""
    limit: str = ""
    share: float | None = None
    tone: doc.Tone = ""


def key_figures(case: CaseReport, report: Report) -> tuple[KeyFigure, ...]:
    """Return the results that lead, each with its limit; none of a case without a result or load.

    Parameters
    ----------
    case
        One of the report's.
    report
        Its cases may have rows of their own.
    """
    if not case.converged or nothing_given(case.analysis.solved):
        return ()
    alone = replace(report, cases=(case,))
    keys: dict[object, str] = {_hours: "life", _life_text: "life", _speed: "speed"}
    found = []
    for row in _summary_rows(alone):
        shown = _shown(row.cell(case))
        if not shown:
            continue
        key = keys.get(row.of) or row.path or "theory"
        limit, share, tone = _limit_of(case, row)
        found.append(KeyFigure(key, row.label, shown, row.shown_unit, limit, share, tone))
    return (*found, *_tilt_figure(case))


def _shown(cell: str | doc.Number) -> str:
    if isinstance(cell, str):
        return cell
    return manner().number(cell.value, cell.form) if isfinite(cell.value) else ""


def _limit_of(case: CaseReport, row: _Quantity) -> tuple[str, float | None, doc.Tone]:
    """What a row of the summary is held against: the limit, the share of it, the tone."""
    value = row.number(case)
    if row.path == "extremes.max_pressure" and value is not None:
        known = [check.high for check in case.checks if check.name.endswith("pressure")]
        least = min((one for one in known if one is not None), default=nan)
        if not least > 0.0:
            return "", None, ""
        return said("of {limit:.4 MPa}", limit=least), value / least, "bad" if value > least else ""
    if row.path == "extremes.load_ratio" and value is not None:
        high = next((check.high for check in case.checks if check.name == "load"), None)
        if high:
            return (
                said("at least {limit:.3}", limit=1.0 / high),
                1.0 / (high * value),
                "bad" if value < 1.0 / high else "",
            )
    if row.of is _speed and (limit := case.speed_limit):
        name = said(_OF_SPEED[limit.name])
        text = said("of {limit:.4 rpm} ({name})", limit=limit.speed, name=name)
        return text, limit.share, "warning" if limit.share > 1.0 else ""
    for path, least, refused in _LEAST:
        if row.path == path and value is not None and value > 0.0:
            tone: doc.Tone = "" if value >= least else "bad" if value < refused else "warning"
            return said("at least {limit:.3}", limit=least), min(least / value, 9.0), tone
    required = case.case.life.required_life if case.case.life is not None else None
    if required and row.of in (_hours, _life_text) and (hours := _hours(case)):
        wanted = required / 3600.0
        text = said("at least {hours:.4r} h", hours=wanted)
        return text, min(wanted / hours, 9.0), "bad" if hours < wanted else ""
    return "", None, ""


_OF_SPEED: Final = {
    "catalogue": marked("oil"),
    "oil_bath": marked("oil"),
    "high_speed": marked("oil-air"),
    "grease": marked("grease"),
    "reference": marked("ISO 15312"),
}
"""With what, or by what, a speed is limited."""
_LEAST: Final = (
    ("analysis.life.loads.static_safety", 1.0, 0.5),
    ("analysis.film.viscosity_ratio", 1.0, 0.1),
)
"""Numbers that should be at least one: S_0, below which balls leave a dent of a ten-thousandth of
their diameter (ISO 76:2006, the definition of C_0); κ, at which the oil has the viscosity that is
required (ISO 281:2007, 9.3.3.1); and below what they are out of bounds: κ of the range of a_ISO."""


def _tilt_figure(case: CaseReport) -> Iterator[KeyFigure]:
    """The tilt of roller bearings, where makers say what they permit."""
    for check in case.checks:
        if check.name == "misalignment" and check.high and check.high < inf and check.greatest:
            yield KeyFigure(
                "checks.misalignment",
                called("ring_tilt"),
                manner().number(check.greatest, ".3 [mrad]"),
                "mrad",
                said("of {limit:.3 mrad}", limit=check.high),
                check.greatest / check.high,
                "" if check.met else "bad",
            )


def comparison_sections(report: Report) -> tuple[doc.Section, doc.Section]:
    """Return the summary of several cases in two: what differs, and what is the same in all.

    Parameters
    ----------
    report
        Of at least two cases.
    """
    solved = [case.analysis.solved for case in report.cases if case.converged]
    rows = _summary_rows(report) if not all(map(nothing_given, solved)) else []
    differing: list[_Quantity] = []
    same: list[_Quantity] = []
    for row in rows:
        texts = {_shown(row.cell(case)) for case in report.cases}
        (same if len(texts) == 1 else differing).append(row)
    return (
        doc.Section(
            said("What differs"),
            q.tables_of(report.cases, [("", differing)], "summary", abreast=3),
            "summary",
        ),
        doc.Section(
            said("The same in all"),
            q.tables_of(report.cases, [("", same)], "same", abreast=3),
            "same",
        ),
    )


def _hours(case: CaseReport) -> float | None:
    life = case.analysis.life
    return None if life is None else q.number_of(life.headline.hours)


def _life_row(report: Report) -> _Quantity:
    """The leading life; in words where fatigue does not decide, or no theory is valid."""
    label = said("rating life")
    if all(_is_plain(case) for case in report.cases):
        return q.Quantity(label, _hours, ".4r", "analysis.life.headline.hours", "h")
    return q.Quantity(label, _life_text)


def _is_plain(case: CaseReport) -> bool:
    """Whether a number says what there is to say of the leading life, or there is none."""
    life, hours = case.analysis.life, _hours(case)
    if life is None or hours is None:
        return not (case.converged and life is not None and _is_endless(case))
    return bool(life.headline.valid[0]) and hours <= LONGEST_LIFE


def _is_endless(case: CaseReport) -> bool:
    life = case.analysis.life
    return life is not None and float(life.headline.life[0]) == inf


def _life_text(case: CaseReport) -> str:
    life, hours = case.analysis.life, _hours(case)
    if life is None:
        return ""
    if not life.headline.leads[0]:
        return said("no theory is valid")
    if _is_endless(case):
        return said("no fatigue limit reached")
    if hours is None:
        return ""
    if life.headline.below[0]:
        return said("< {hours:.4r} h", hours=hours)
    if hours > LONGEST_LIFE:
        return said("> {hours} h", hours=int(LONGEST_LIFE))
    return said("{hours:.4r} h", hours=hours)


def _leading(case: CaseReport) -> str:
    life = case.analysis.life
    if life is None or not life.headline.leads[0]:
        return ""
    name = theory_name(str(life.headline.theory[0]))
    return said("{theory} (upper bound)", theory=name) if life.headline.below[0] else name


# --- inputs ---------------------------------------------------------------------------------------

ORIGINS: Final = {
    "given": marked("case file"),
    "set": marked("command line (--set)"),
    "published": marked("catalogue"),
    "inferred": marked("estimated from ratings"),
    "assumed": marked("assumed"),
    "designation": marked("designation"),
    "data": marked("data file"),
    "default": marked("default"),
}
TABLES: Final = {
    "bearing": marked("Bearing"),
    "duty": marked("Duty"),
    "model": marked("Model"),
    "lubricant": marked("Lubricant"),
    "surface": marked("Surface"),
    "temperature": marked("Temperature"),
    "mounting": marked("Mounting"),
    "film": marked("Film"),
    "heat": marked("Heat"),
    "grease": marked("Grease"),
    "static": marked("Static safety"),
    "electrical": marked("Electricity"),
    "losses": marked("Seals and oil bath"),
    "life": marked("Life"),
}


def _inputs(report: Report) -> list[doc.Section]:
    """Every input with its origin; of several cases first those that differ."""
    fields = _all_fields(report)
    sources = _Sources()
    if len(report.cases) == 1:
        table = _input_table(report, fields, [0], "inputs", sources)
        return [doc.Section("", (*table, *sources.blocks()), "inputs_table")]
    equal = [field for field in fields if not _differing(report, field)]
    tables: list[doc.Table] = []
    for index in range(1, len(report.cases)):
        own = [field for field in fields if index in _differing(report, field)]
        key = "inputs_that_differ" + (f"_{index}" if index > 1 else "")
        tables += _input_table(report, own, [0, index], key, sources)
    same: Sequence[doc.Statement | doc.Table] = tables or [
        doc.Statement(said("The cases have the same inputs."))
    ]
    rest = _input_table(report, equal, [0], "inputs_in_common", sources)
    return [
        doc.Section(said("Inputs that differ"), tuple(same), "differing_inputs", 3),
        doc.Section(said("Inputs in common"), (*rest, *sources.blocks()), "common_inputs", 3),
    ]


class _Sources:
    """Sources by a number, said once below the tables."""

    def __init__(self) -> None:
        self._found: list[str] = []

    def cell(self, found: Input | None) -> str:
        if found is None:
            return ""
        origin = said(ORIGINS[found.origin])
        if not found.source:
            return origin
        if found.source not in self._found:
            self._found.append(found.source)
        return f"{origin} [{self._found.index(found.source) + 1}]"

    def blocks(self) -> tuple[doc.Statement, ...]:
        return tuple(
            doc.Statement(source, "faint", indent=2, mark=f"[{number}]")
            for number, source in enumerate(self._found, start=1)
        )


def _all_fields(report: Report) -> list[str]:
    """Names of the inputs of all cases, in the order of the tables of a case file."""
    known = list(Case.fields())
    found = dict.fromkeys(one.field for case in report.cases for one in case.inputs)

    def place(name: str) -> tuple[int, str]:
        own = next((at for at, field in enumerate(known) if name == field), None)
        if own is None:
            own = next(at for at, field in enumerate(known) if name.startswith(f"{field}."))
        return own, name

    tables = list(TABLES)
    return sorted(found, key=lambda name: (tables.index(name.partition(".")[0]), place(name)))


def _differing(report: Report, field: str) -> list[int]:
    """Which cases have another value than the first."""
    found = [case.input(field) for case in report.cases]
    values = [None if one is None else one.value for one in found]
    return [index for index, value in enumerate(values) if value != values[0]]


def _input_table(
    report: Report, fields: Sequence[str], cases: Sequence[int], key: str, sources: _Sources
) -> list[doc.Table]:
    if not fields:
        return []
    first = {field: _any_input(report, field) for field in fields}
    groups, place = [], ""
    for at, field in enumerate(fields):
        table = field.partition(".")[0]
        if table != place:
            groups.append((at, said(TABLES[table])))
            place = table
    many = len(cases) > 1
    columns = [
        doc.Column(said("input"), [_label(field) for field in fields], "input"),
        doc.Column(said("field"), list(fields), "field", tone="faint", only_in_files=many),
        doc.Column(said("unit"), [first[f].unit for f in fields], "unit", tone="faint"),
    ]
    for index in cases:
        case = report.cases[index]
        own = [case.input(field) for field in fields]
        columns.append(
            doc.Column(
                said("case {name}", name=case.name) if many else said("value"),
                [_input_cell(one) for one in own],
                case.name,
                align="right",
            )
        )
        if index:
            columns += _input_differences(report, fields, index)
        columns.append(
            doc.Column(said("origin"), [sources.cell(one) for one in own], f"{case.name}_origin")
        )
    return [doc.Table(tuple(columns), key, groups=tuple(groups), rule=True, fixed=2)]


def _any_input(report: Report, field: str) -> Input:
    return next(one for case in report.cases if (one := case.input(field)) is not None)


def _label(field: str) -> str:
    """What a field is called; that of a row of a set with the row's number."""
    known = Case.fields()
    if field in known:
        return known[field].label
    listed = next(name for name in known if field.startswith(f"{name}."))
    index, _, leaf = field[len(listed) + 1 :].partition(".")
    return said("{what}, {which}", what=known[listed].entries[leaf].label, which=index)


def _input_cell(found: Input | None) -> doc.CellContent:
    if found is None:
        return doc.Number(nan)
    value = found.value
    if isinstance(value, bool):
        return said("yes") if value else said("no")
    if isinstance(value, str):
        return value
    return doc.Number(float(value), f".10 [{found.unit}]" if found.unit else ".10")


def _input_differences(report: Report, fields: Sequence[str], case: int) -> list[doc.Column]:
    absolute: list[doc.CellContent] = []
    relative: list[doc.CellContent] = []
    for field in fields:
        own = report.cases[case].input(field)
        difference, share = report.input_difference(field, case)
        unit = "" if own is None else own.unit.replace("°C", "K")
        if difference is None:
            absolute.append(None)
        else:
            absolute.append(doc.Number(difference, f"+.6 [{unit}]" if unit else "+.6"))
        relative.append(None if share is None or unit == "K" else doc.Number(share, "+.1f [%]"))
    name = report.cases[case].name
    return [
        doc.Column("Δ", absolute, f"{name}_difference", align="right", tone="faint"),
        doc.Column("Δ, %", relative, f"{name}_percent", align="right", tone="faint"),
    ]


# --- results --------------------------------------------------------------------------------------


def _results(report: Report) -> list[doc.Section | doc.Beside]:
    """All results: a table for all cases, and for each what has a line a ball."""
    sections: list[doc.Section | doc.Beside] = []

    def add(key: str, heading: str = "") -> None:
        part = part_of(report, key)
        if part.blocks:
            sections.append(replace(part, heading=heading or part.heading, level=3))

    add("loads")
    add("lives")
    sections += _service_lives(report)
    add("clearance")
    sections += _ring_and_rosettes(report)
    add("rows")
    for case in report.cases:
        if case.converged:
            sections += [_distribution(report, case), *_pictures(report, case)]
    compared = worded(
        _elements(report),
        said("Ball loads compared"),
        said("Roller loads compared"),
        said("Element loads compared"),
    )
    loads = _ball_loads(report)
    sections += [doc.Section(compared, loads, "ball_loads", 3)] * bool(loads)
    for key in ("contacts", "film", "friction", "heat", "frequencies", "stiffness"):
        add(key)
    for case in report.cases:
        sections += _asked(report, case)
    missing = doc.Notes(_missing(report))
    if missing.remarks:
        sections.append(doc.Section(said("Not calculated"), (missing,), "missing", 3))
    return sections


def _asked(report: Report, case: CaseReport) -> list[doc.Section]:
    """Static safety and electricity of a case that asks for them."""
    parts = []
    if case.static_safety is not None:
        parts.append(static_sections(case.static_safety, level=3))
    if case.electrics is not None:
        parts.append(electrical_sections(case.electrics, level=3))
    sections = []
    for first, *others in parts:
        heading = _of_case(report, case, first.heading)
        sections += [replace(first, heading=heading), *(replace(one, level=4) for one in others)]
    return sections


def _of_case(report: Report, case: CaseReport, heading: str) -> str:
    """A heading, with the name of its case where there are several."""
    if len(report.cases) == 1:
        return heading
    return said("{what}, case {name}", what=heading, name=case.name)


def _named(report: Report, case: CaseReport) -> list[doc.Title]:
    """The name of a case over its blocks, where there are several."""
    return [doc.Title(said("case {name}", name=case.name))] * (len(report.cases) > 1)


def _elements(report: Report) -> list[str]:
    """What rolls in the rows of all cases."""
    return [place.bearing.element for case in report.cases for place in case.case.bearing.places]


def _missing(report: Report) -> tuple[doc.Remark, ...]:
    """Say which parts no case has, and what they need."""
    solved = [case for case in report.cases if case.converged]
    texts = (
        ("life", said("Ratings and lives: see the summary.")),
        ("film", said("Lubricant film: requires [lubricant] and `temperature.lubricant`.")),
        ("friction", said("Friction: requires [lubricant] and `temperature.lubricant`.")),
        ("frequencies", said("Fault frequencies: the rings do not rotate relative to each other.")),
    )
    remarks = [
        doc.Remark(text, name)
        for name, text in texts
        if all(getattr(case.analysis, name) is None for case in solved)
    ]
    if all(case.clearance is None for case in solved):
        text = said(
            "Clearance in operation: requires [mounting]; the clearance of the inputs is used."
        )
        remarks.append(doc.Remark(text, "clearance"))
    return tuple(remarks)


def _loads(report: Report) -> tuple[doc.Table, ...]:
    lives = [case.analysis.life for case in report.cases if case.analysis.life is not None]
    axial = bool(lives) and all(found.ratings.is_axial for found in lives)
    dynamic, static = (
        (called("axial_equivalent_load"), called("axial_static_equivalent_load"))
        if axial
        else (called("equivalent_load"), called("static_equivalent_load"))
    )
    rated, rated_at_rest = (
        (called("axial_dynamic_rating"), called("axial_static_rating"))
        if axial
        else (called("dynamic_rating"), called("static_rating"))
    )
    rows = [
        q.LIFE(dynamic, "loads.equivalent", ".4 N", lambda own: own.loads.dynamic),
        q.LIFE(said("radial load factor X"), "loads.radial_factor"),
        q.LIFE(said("axial load factor Y"), "loads.axial_factor"),
        q.LIFE(
            said("axial load limit e"), "loads.load_ratio_limit", get=lambda own: own.loads.limit
        ),
        q.LIFE(static, "loads.static_equivalent", ".4 N", lambda own: own.loads.static),
        q.extreme(called("reference_load"), "reference_load", ".4 N"),
    ]
    ratings = [
        q.LIFE(rated, "ratings.dynamic", ".5 N", lambda own: own.ratings.dynamic_of_set),
        q.LIFE(rated_at_rest, "ratings.static", ".5 N", lambda own: own.ratings.static_of_set),
        q.LIFE(
            called("fatigue_load_limit"),
            "ratings.fatigue",
            ".5 N",
            lambda own: own.ratings.fatigue_of_set,
        ),
    ]
    safety = [_static_safety(), _load_ratio()]
    groups = [
        (said("Equivalent loads"), rows),
        (said("Ratings"), ratings),
        (said("Safety"), safety),
    ]
    return q.tables_of(report.cases, groups, "loads", legends=_rating_sources(report))


def _rating_sources(report: Report) -> tuple[str, ...]:
    """Say where C, C_0 and C_u come from; of cases that agree once."""
    symbols = {"dynamic": "C", "static": "C_0", "fatigue": "C_u"}
    found: dict[str, dict[str, list[str]]] = {}
    for case in report.cases:
        for name, symbol in symbols.items():
            source = _rating_source(case, name)
            if source:
                found.setdefault(source, {}).setdefault(case.name, []).append(symbol)
    rated = sum(case.analysis.life is not None for case in report.cases)
    legends = []
    for source, cases in found.items():
        alike = len(cases) == rated and len({tuple(own) for own in cases.values()}) == 1
        ratings = "; ".join(
            ", ".join(own)
            if alike
            else said("{ratings} of case {name}", ratings=", ".join(own), name=name)
            for name, own in list(cases.items())[: 1 if alike else None]
        )
        legends.append(said("{ratings}: {source}", ratings=ratings, source=source))
    return tuple(legends)


def _rating_source(case: CaseReport, name: str) -> str:
    life = case.analysis.life
    if life is None or q.number_of(getattr(life.ratings, f"{name}_of_set")) is None:
        return ""
    given = life.rating_sources[name] == "given"
    return said("case file") if given else rating_source(life, name)


# --- lives ----------------------------------------------------------------------------------------


def _lives(report: Report) -> list[doc.Table | doc.Statement]:
    theories = [
        name
        for name in THEORIES
        if any(
            case.analysis.life is not None and name in case.analysis.life.theories
            for case in report.cases
        )
    ]
    if not theories:
        return []
    own = report.cases[0].analysis.life
    if len(report.cases) == 1 and own is not None:
        return [_theory_table(report.cases[0], own)]
    groups: list[_Group] = []
    for name in theories:
        rows = [
            _hours_row(report, said("life"), name),
            _factor(said("life modification factor a_ISO"), name, "a_iso"),
            q.Quantity(said("valid here"), partial(_verdict, theory=name)),
        ]
        groups.append((theory_name(name), rows))
    common = [
        q.LIFE(said("reliability"), "headline.reliability", ".6 %"),
        _factor(said("reliability factor a_1"), theories[0], "a_1"),
        q.LIFE(called("viscosity_ratio"), "viscosity_ratio", ".3"),
        q.LIFE(called("contamination_factor"), "contamination_factor", ".3"),
    ]
    groups.append((said("Conditions"), common))
    return list(q.tables_of(report.cases, groups, "lives", legends=_life_legends()))


def _own_life(case: CaseReport, theory: str) -> Life | None:
    return None if case.analysis.life is None else case.analysis.life.theories.get(theory)


def _factor(label: str, theory: str, name: str) -> _Quantity:
    def of(case: CaseReport) -> float | None:
        own = _own_life(case, theory)
        return None if own is None or name not in own.factors else q.number_of(own.factors[name])

    return q.Quantity(label, of, path=f"analysis.life.theories.{theory}.factors.{name}")


def _service_lives(report: Report) -> list[doc.Section]:
    """What ends each case first, where that may be another thing than fatigue."""
    from rolamento.pages.service_life import time_line

    sections = []
    for case in report.cases:
        found = case.service_life
        if found is None:
            continue
        heading = _of_case(report, case, said("What ends it first"))
        figure = replace(time_line(found), key=f"service_life_{case.name}")
        blocks = (*_endings(found), figure)
        sections.append(doc.Section(heading, blocks, f"service_life_{case.name}", 3))
    return sections


def _endings(found: ServiceLife) -> Iterator[doc.Block]:
    """Yield what ends a case first, what qualifies it, and all endings side by side."""
    from rolamento.pages.notes import cautions
    from rolamento.pages.service_life import endings_section, service_life_statement

    yield from service_life_statement(found)
    yield from cautions(
        [note for one in found.endings if one.name != "fatigue" for note in one.notes]
    )
    yield from endings_section(found).blocks


def _all_endings(report: Report) -> list[doc.Block]:
    """What ends every case first, without pictures."""
    return [
        block
        for case in report.cases
        if case.service_life is not None
        for block in (*_named(report, case), *_endings(case.service_life))
    ]


def _hours_row(report: Report, label: str, theory: str) -> _Quantity:
    """Hours, or in words those beyond what fatigue decides."""

    def of(case: CaseReport) -> float | None:
        own = _own_life(case, theory)
        return None if own is None else q.number_of(own.hours)

    def text(case: CaseReport) -> str:
        return "" if (hours := of(case)) is None else hours_text(hours)

    if all((of(case) or 0.0) <= LONGEST_LIFE for case in report.cases):
        return q.Quantity(label, of, ".4r", f"analysis.life.theories.{theory}.hours", "h")
    return q.Quantity(label, text, unit="h")


def _life_legends() -> tuple[str, ...]:
    return (
        said(
            "Above {hours} h fatigue does not limit the life. bound: upper bound of the life. κ "
            "viscosity ratio, e_C contamination factor.",
            hours=int(LONGEST_LIFE),
        ),
    )


def _theory_table(case: CaseReport, life: LifeSummary) -> doc.Table:
    """The theories of one case side by side, as the page of its life has them."""
    table = theory_table(life, f"lives_{case.name}")
    paths = [f"analysis.life.theories.{name}" for name in life.theories]
    mark, theories, *numbers = table.columns
    columns = (
        mark,
        replace(theories, head=said("theory")),
        *numbers,
        doc.Column("path", paths, "path", only_in_files=True),
    )
    legends = (
        said(
            "Lives for {reliability:.6 %} reliability; ▸ marks the most complete valid theory.",
            reliability=float(life.headline.reliability),
        ),
        *_life_legends(),
    )
    return replace(table, columns=columns, legends=legends, rule=True)


def _verdict(case: CaseReport, theory: str) -> str:
    life = case.analysis.life
    if life is None or theory not in life.theories:
        return ""
    own = life.theories[theory]
    return verdict(bool(own.valid[0]), bool(own.below[0]))


# --- clearance ------------------------------------------------------------------------------------


def _clearance(report: Report) -> list[doc.Table]:
    if len(report.cases) == 1:
        return [_chain(case) for case in report.cases if case.clearance is not None]
    names = [
        name
        for name in STEPS
        if any(
            case.clearance is not None and any(step.name == name for step in case.clearance.steps)
            for case in report.cases
        )
    ]
    groups: list[_Group] = [
        (
            said("Diametral clearance in operation"),
            [_clearance_row(head, name) for name, head in limit_heads().items()],
        )
    ]
    steps = []
    for name in names:
        places = [_place_of(case, name) for case in report.cases]
        at = next(place for place in places if place is not None)
        if all(place in (None, at) for place in places):
            steps.append(_step_row(name, at))
    groups.append((said("Mean change of clearance by step"), steps))
    return list(q.tables_of(report.cases, groups, "clearance"))


def _step_row(name: str, at: int) -> _Quantity:
    def of(case: CaseReport) -> float | None:
        return None if _place_of(case, name) is None else float(case.clearance.steps[at].change[1])

    return q.Quantity(said(STEPS[name]), of, ".3 µm", f"clearance.steps.{at}.change.1")


def _place_of(case: CaseReport, step: str) -> int | None:
    if case.clearance is None:
        return None
    names = [own.name for own in case.clearance.steps]
    return names.index(step) if step in names else None


def _chain(case: CaseReport) -> doc.Table:
    """The chain of clearances of one case, with what went into the fits."""
    lines = list(chain_lines(case.clearance))
    tones = [line.tone for line in lines]
    columns = [
        doc.Column(
            said("diametral clearance"), [line.label for line in lines], "step", tones=tones
        ),
        doc.Column(said("unit"), [line.unit for line in lines], "unit", tone="faint"),
    ]
    for at, (key, head) in enumerate(limit_heads().items()):
        cells = [doc.Number(line.values[at], f".1f [{line.unit}]") for line in lines]
        columns.append(doc.Column(head, cells, key, tones=tones))
    columns += [
        doc.Column(said("source"), [line.source for line in lines], "source", tone="faint"),
        doc.Column("path", [line.path for line in lines], "path", only_in_files=True),
    ]
    return doc.Table(tuple(columns), f"clearance_{case.name}", rule=True)


# --- ring, rows, balls ----------------------------------------------------------------------------


def _ring(report: Report) -> tuple[doc.Table, ...]:
    moved = [
        q.SOLVED(
            _label(f"duty.displacement.{axis}"),
            f"displacement.{axis}",
            ".3f µm" if len(axis) == 1 else ".4f mrad",
        )
        for axis in AXES
    ]
    loads = [
        q.SOLVED(
            _label(f"duty.load.{load}"), f"load.{load}", ".1f N" if load[0] == "f" else ".3f N·m"
        )
        for load in LOADS
    ]
    groups = [(said("Displacements"), moved), (said("Loads of the shaft"), loads)]
    legend = said(
        "Loads not listed among the inputs are reactions at constrained degrees of freedom."
    )
    return q.tables_of(report.cases, groups, "ring", legends=(legend,))


def _rows(report: Report) -> tuple[doc.Table, ...]:
    """Rows of a set, and what its preload does; nothing of a plain bearing."""
    if not any(case.case.bearing.is_set for case in report.cases):
        return ()
    first = worded(
        _elements(report),
        said("load factor at which the first ball loses contact"),
        said("load factor at which the first roller loses contact"),
        said("load factor at which the first rolling element loses contact"),
    )
    preload = [
        q.PRELOAD(said("axial preload at rest"), "at_rest", ".4 N"),
        q.PRELOAD(said("axial preload at speed"), "at_speed", ".4 N"),
        q.PRELOAD(first, "lift_factor", ".3"),
        q.PRELOAD(said("load factor at which a row loses contact"), "loss_factor", ".3"),
    ]
    groups: list[_Group] = [(said("Preload"), preload), *_preload_stages(report)]
    most = max(len(case.analysis.solved.rows) for case in report.cases)
    groups += [(said("row {number}", number=row), _row_quantities(row)) for row in range(most)]
    return q.tables_of(report.cases, groups, "set")


def _row_quantities(row: int) -> list[_Quantity]:
    """What is known of a row of a set."""

    def loaded(own: Solved, *, balls: bool) -> float | None:
        kind = row < len(own.rows) and (own.rows.element[row] == "ball") == balls
        return own.loaded_elements[0, row] if kind else None

    def load(place: int, own: Solved) -> float | None:
        return own.rows.load[0, row, place] if row < len(own.rows) else None

    path = f"rows.{row}"
    return [
        q.SOLVED(
            said("position"),
            f"{path}.position",
            ".4 mm",
            lambda own: own.rows.position[0, row] if row < len(own.rows) else None,
        ),
        q.SOLVED(
            said("loaded balls"), f"{path}.loaded_balls", get=lambda own: loaded(own, balls=True)
        ),
        q.SOLVED(
            said("loaded rollers"),
            f"{path}.loaded_rollers",
            get=lambda own: loaded(own, balls=False),
        ),
        *(
            q.SOLVED(_label(f"duty.load.{name}"), f"{path}.load.{name}", ".4 N", partial(load, at))
            for at, name in enumerate(LOADS[:3])
        ),
    ]


def _heat(report: Report) -> list[doc.Block]:
    """The heat balance of each case that has a [heat] table."""
    from rolamento.pages.heat import heat_blocks

    found: list[doc.Block] = []
    for case in report.cases:
        if case.heat is not None:
            if len(report.cases) > 1:
                found.append(doc.Statement(said("case {name}", name=case.name), "strong"))
            found += heat_blocks(case.heat)
    return found


def _mean_preload(own: Preloading, at: int) -> float | None:
    return own.stages[at].preload[1] if at < len(own.stages) else None


def _preload_stages(report: Report) -> list[_Group]:
    """What becomes of the preload of mounted sets, at mean tolerances."""
    found = [case.analysis.solved.preload for case in report.cases]
    stages = max((one.stages for one in found if one is not None), key=len, default=())
    rows = [
        q.PRELOAD(
            said(STAGE_NAMES[stage.name]),
            f"stages.{place}.preload.1",
            ".4 N",
            partial(_mean_preload, at=place),
        )
        for place, stage in enumerate(stages)
    ]
    return [(said("Preload without external load, at mean tolerances"), rows)] if rows else []


def _ring_and_rosettes(report: Report) -> list[doc.Section | doc.Beside]:
    """The ring beside the loads round it; of several cases the rosettes below the ring's table."""
    ring = doc.Section(said("Displacements and loads of the inner ring"), _ring(report), "ring", 3)
    pictures = tuple(_rosette(report, case) for case in report.cases if case.converged)
    if len(report.cases) == 1:
        return [doc.Beside((ring,), pictures, key="ring")]
    if len(pictures) < 2:
        return [ring, *pictures]
    return [ring, doc.Beside(pictures[::2], pictures[1::2], key="rosettes")]


def _rosette(report: Report, case: CaseReport) -> doc.Section:
    found = rosette_section(case.analysis.solved)
    figure = found.blocks[0]
    assert isinstance(figure, doc.Figure)
    heading = _of_case(report, case, found.heading)
    return doc.Section(
        heading, (replace(figure, key=f"rosette_{case.name}"),), f"rosette_{case.name}", 3
    )


def _distribution(report: Report, case: CaseReport) -> doc.Section:
    """The loads of the elements, a line each."""
    heading = _of_case(report, case, said("Load distribution"))
    tables = tuple(
        replace(table, key=f"{name}_{case.name}")
        for name, table in element_tables(case.analysis.solved).items()
    )
    return doc.Section(heading, tables, f"distribution_{case.name}", 3)


def _pictures(report: Report, case: CaseReport) -> list[doc.Section]:
    """What rollers bear along their length, and how the most loaded one lies."""
    sections = []
    for found in roller_pictures(case.analysis.solved):
        heading = _of_case(report, case, found.heading)
        figures = (
            replace(figure, key=f"{figure.key}_{case.name}")
            for figure in found.blocks
            if isinstance(figure, doc.Figure)
        )
        sections.append(doc.Section(heading, tuple(figures), f"{found.key}_{case.name}", 3))
    return sections


def _inner_load(own: Solved, element: int) -> float | None:
    return float(own.inner.load[0, element]) if own.converged[0] else None


def _ball_loads(report: Report) -> tuple[doc.Table, ...]:
    """The inner loads element by element, where cases that converged have as many of one kind."""
    solved = [case for case in report.cases if case.converged]
    counts = {len(case.analysis.solved.elements.row) for case in solved}
    kinds = set(_elements(report))
    if len(solved) < 2 or len(counts) != 1 or ("ball" in kinds and len(kinds) > 1):
        return ()
    balls = kinds == {"ball"}
    rows = [
        q.SOLVED(
            said("ball {number}", number=one) if balls else said("roller {number}", number=one),
            f"{'balls' if balls else 'rollers'}.{one}.inner.load",
            ".4 N",
            partial(_inner_load, element=one),
        )
        for one in range(counts.pop())
    ]
    return q.tables_of(
        report.cases, [("", rows)], "ball_loads", legends=(said("Load at the inner race"),)
    )


_OF_CONTACTS: Final = (
    "max_pressure", "ball", "roller", "azimuth", "contact_angle", "semi_major", "semi_minor",
    "deflection", "max_shear", "max_shear_depth", "orthogonal_shear", "orthogonal_shear_depth",
    "load", "spin_to_roll",
)  # fmt: skip
"""Rows of the contacts of a race, by their names in the extremes."""


def _contacts(report: Report) -> tuple[doc.Table, ...]:
    heads: dict[Race, str] = {"inner": said("Inner race"), "outer": said("Outer race")}
    elements = _elements(report)
    beside = {
        "ball": said("ball number"),
        "roller": said("roller number"),
        "azimuth": worded(
            elements,
            said("azimuth of the ball"),
            said("azimuth of the roller"),
            said("azimuth of the element"),
        ),
        **{
            one: said("maximum {quantity}", quantity=called(one))
            for one in ("load", "spin_to_roll")
        },
    }
    forms = {"load": ".5 N", "spin_to_roll": ".4f", "azimuth": ".4 °"}
    rows = [
        (
            name,
            beside.get(name) or contact_name(name, elements),
            forms.get(name, f".4 {CONTACT_UNITS.get(name, '')}".rstrip()),
        )
        for name in _OF_CONTACTS
    ]
    return (*_by_race(report, rows, heads, "contacts"), *_roller_table(report))


def _roller_table(report: Report) -> tuple[doc.Table, ...]:
    """Tilt and rib forces of rollers; nothing of balls."""
    rows = [
        q.extreme(said("maximum tilt of a roller"), "roller_tilt", ".3 mrad"),
        q.extreme(said("maximum force of a rib on a roller"), "rib_force", ".4 N"),
    ]
    return q.tables_of(report.cases, [("", rows)], "roller_extremes")


def _by_race(
    report: Report, rows: Sequence[tuple[str, str, str]], heads: Mapping[Race, str], key: str
) -> tuple[doc.Table, ...]:
    """Numbers of both races: of one case beside each other, of several below each other."""
    if len(report.cases) > 1:
        groups = [
            (head, [q.extreme(label, f"{race}_{name}", form) for name, label, form in rows])
            for race, head in heads.items()
        ]
        return q.tables_of(report.cases, groups, key)
    case = report.cases[0]
    found: list[q.Quantity[Race]] = [
        q.Quantity(label, _at_race(case, name), form, f"extremes.*_{name}")
        for name, label, form in rows
    ]
    found = [row for row in found if row.known(heads)]
    label, unit, *values = q.beside(found, [(race, head, race) for race, head in heads.items()])
    columns = (
        replace(label, head=said("quantity")),
        replace(unit, tone="faint"),
        *values,
        doc.Column("path", [row.path for row in found], "path", only_in_files=True),
    )
    return (doc.Table(columns, key, rule=True),)


def _at_race(case: CaseReport, name: str) -> Callable[[Race], float | None]:
    return lambda race: case.extreme(f"{race}_{name}")


# --- film, friction, frequencies, stiffness -------------------------------------------------------


def _film(report: Report) -> tuple[doc.Table, ...]:
    oil: list[_Quantity] = [
        q.Quantity(said("lubricant"), _lubricant),
        q.FILM(said("lubricant temperature"), "temperature", ".5 °C"),
        q.FILM(said("kinematic viscosity ν"), "kinematic_viscosity", ".4 mm²/s"),
        q.FILM(said("dynamic viscosity η"), "dynamic_viscosity", ".4 mPa·s"),
        q.FILM(said("pressure-viscosity coefficient α_p"), "pressure_viscosity", ".4 1/GPa"),
        q.FILM(said("required viscosity ν_1"), "reference_viscosity", ".4 mm²/s"),
        _viscosity_ratio(),
    ]
    if not any(case.analysis.film is not None for case in report.cases):
        return ()
    heads: dict[Race, str] = {
        "inner": said("Thinnest film, inner race"),
        "outer": said("Thinnest film, outer race"),
    }
    tables = q.tables_of(report.cases, [(said("Lubricant"), oil)], "oil")
    films = [(name, said(label), form) for name, label, form in FILMS]
    return (*tables, *_by_race(report, films, heads, "film"))


def _lubricant(case: CaseReport) -> str:
    lubricant = case.case.lubricant
    return "" if lubricant is None else lubricant.name


def _friction(report: Report) -> tuple[doc.Table, ...]:
    torque, power = _torque_form(report), _power_form(report)
    whole = [
        q.FRICTION(said("coefficient of friction μ"), "friction_coefficient"),
        q.FRICTION(
            said("coefficient of friction μ, from"),
            "coefficient_range.0",
            get=lambda own: own.coefficient_range[0, 0],
        ),
        q.FRICTION(
            said("coefficient of friction μ, to"),
            "coefficient_range.1",
            get=lambda own: own.coefficient_range[0, 1],
        ),
        q.Quantity(said("model of the contacts"), _torque_model),
        q.FRICTION(_bounded(report, "torque"), "torque", torque),
        q.FRICTION(called("starting_torque"), "starting_torque", torque),
        q.FRICTION(_bounded(report, "power"), "power", power),
    ]
    torques = [
        q.FRICTION(
            source_name(one), f"torque_by_source.{one}", torque, partial(_of_source, name=one)
        )
        for one in SOURCES
    ]
    heats = [q.extreme(source_name(one), f"heat_{one}", power) for one in SOURCES]
    found = [case.analysis.friction for case in report.cases if case.analysis.friction is not None]
    models = [
        q.FRICTION(
            torque_model_name(name), f"models.{name}.torque", torque, partial(_of_model, name=name)
        )
        for name in dict.fromkeys(name for one in found for name in one.models)
    ]
    rolling = [
        q.ROLLING(called("cage_speed"), "cage_speed", ".5 rpm"),
        q.ROLLING(said("cage slip relative to outer raceway control"), "skid", ".3 %"),
        q.ROLLING(said("torque on the shaft"), "inner_torque", torque),
        q.ROLLING(said("torque on the housing"), "outer_torque", torque),
        q.ROLLING(called("rolling_power"), "power", power),
    ]
    added = [
        q.SEALS_AND_BATH(said("torque of the seals"), "seal", torque),
        q.SEALS_AND_BATH(said("torque of the oil bath"), "drag", torque),
        q.SEALS_AND_BATH(said("power of seals and oil bath"), "power", power),
    ]
    groups = [
        (said("Friction of the contacts"), whole),
        (said("Seals and oil bath, in addition"), added),
        (said("Torque by source"), torques),
        (said("Power by source"), heats),
        (said("Torque by model"), models),
        (said("Motion under friction control"), rolling),
    ]
    legend = said("Losses of seals, cage and oil churning are not included.")
    return q.tables_of(report.cases, groups, "friction", legends=(legend,))


def _of_source(own: Friction, name: str) -> FloatArray | None:
    return own.torque_by_source.get(name)


def _of_model(own: Friction, name: str) -> FloatArray | None:
    return own.models[name].total if name in own.models else None


def _torque_model(case: CaseReport) -> str:
    friction = case.analysis.friction
    return "" if friction is None else torque_model_name(friction.model)


def _bounded(report: Report, quantity: str) -> str:
    """A quantity that is an upper bound in some cases of the report, with the names of these."""
    found = [
        case.name
        for case in report.cases
        if case.analysis.friction is not None and case.analysis.friction.upper_bound[0]
    ]
    label = called(quantity, bound=bool(found))
    if len(found) in (0, len(report.cases)):
        return label
    return said("{label} (case {names})", label=label, names=", ".join(found))


def _torque_form(report: Report) -> str:
    """The form of torques of all cases, those of friction control too."""
    found = (q.FRICTION("", "torque"), q.ROLLING("", "inner_torque"))
    return f".4 {torque_unit(_numbers(report, found))}"


def _power_form(report: Report) -> str:
    found = (q.FRICTION("", "power"), q.ROLLING("", "power"))
    return f".4 {power_unit(_numbers(report, found))}"


def _numbers(report: Report, quantities: Sequence[_Quantity]) -> list[float]:
    found = (one.number(case) for case in report.cases for one in quantities)
    return [number for number in found if number is not None]


def _line_names(cases: Sequence[CaseReport]) -> dict[LineName, str]:
    """What the lines are called in some cases, whose frequencies are of balls or of rollers."""
    found = [case.analysis.frequencies for case in cases]
    elements = [one.element for one in found if one is not None]
    return {name: line_name(name, *(elements or ("ball",))) for name in ABBREVIATIONS}


def _frequencies(report: Report) -> tuple[doc.Table, ...]:
    if len(report.cases) == 1:
        return _frequency_table(report.cases[0])
    shaft = q.FREQUENCIES(said("shaft frequency"), "shaft_frequency", ".5 Hz")
    labels = _line_names(report.cases)
    hertz = [q.FREQUENCIES(label, f"{name}.frequency", ".5 Hz") for name, label in labels.items()]
    orders = [q.FREQUENCIES(label, f"{name}.order", ".5") for name, label in labels.items()]
    groups: list[_Group] = [
        (said("Shaft"), [shaft]),
        (said("Frequencies"), hertz),
        (said("Orders of the shaft"), orders),
    ]
    return q.tables_of(report.cases, groups, "frequencies")


def _frequency_table(case: CaseReport) -> tuple[doc.Table, ...]:
    """Frequencies of one case with their orders."""
    found = case.analysis.frequencies
    if found is None:
        return ()
    labels = _line_names([case])
    lines = [found.lines[name] for name in labels]
    columns = (
        doc.Column("", list(labels.values()), "line"),
        doc.Column("", [ABBREVIATIONS[name] for name in labels], "abbreviation"),
        doc.Column(
            said("frequency"),
            [doc.Number(own.frequency, ".5 [Hz]") for own in lines],
            "frequency",
            "Hz",
        ),
        doc.Column(said("order"), [doc.Number(own.order, ".5") for own in lines], "order"),
        doc.Column(
            "path", [f"{q.FREQUENCIES.path}.{name}" for name in labels], "path", only_in_files=True
        ),
    )
    legend = said(
        "Orders are multiples of the shaft frequency, {frequency:.5 Hz}.",
        frequency=found.shaft_frequency,
    )
    return (doc.Table(columns, f"frequencies_{case.name}", legends=(legend,), rule=True),)


def _stiffness(report: Report) -> list[doc.Table]:
    tables: list[doc.Table] = []
    if len(report.cases) > 1:
        rows = [
            _stiffness_row(said("stiffness {load}–{axis}", load=axis, axis=axis), at)
            for at, axis in enumerate(AXES)
        ]
        tables += q.tables_of(report.cases, [("", rows)], "diagonal", caption=said("Diagonal"))
    for case in report.cases:
        if case.converged:
            found = stiffness_section(case.analysis.solved).blocks[0]
            assert isinstance(found, doc.Table)
            many = len(report.cases) > 1
            caption = said("Stiffness matrix, case {name}", name=case.name) if many else ""
            tables.append(replace(found, key=f"stiffness_{case.name}", caption=caption))
    return tables


def _distributions(report: Report) -> list[doc.Block]:
    """The loads of the elements of every case."""
    return [
        block
        for case in report.cases
        for block in (*_named(report, case), *_distribution(report, case).blocks)
    ]


def _blocks(sections: Iterable[doc.Section]) -> list[doc.Block]:
    """What stands in sections, without their headings."""
    return [block for section in sections for block in section.blocks]


@frozen
class Part:
    """A part of the results.

    Attributes
    ----------
    label
        what it is called, marked
    blocks
        of the cases of a report, side by side; none where no case has such numbers
    """

    label: str
    blocks: Callable[[Report], Sequence[doc.Block]]


PARTS: Final[Mapping[str, Part]] = {
    "loads": Part(marked("Loads and ratings"), _loads),
    "lives": Part(marked("Lives by theory"), _lives),
    "service_life": Part(marked("What ends it first"), _all_endings),
    "clearance": Part(marked("Clearance in operation"), _clearance),
    "ring": Part(marked("Inner ring"), _ring),
    "rows": Part(marked("Rows and preload"), _rows),
    "elements": Part(marked("Load distribution"), _distributions),
    "contacts": Part(marked("Contact stresses"), _contacts),
    "film": Part(marked("Lubricant film"), _film),
    "friction": Part(marked("Friction"), _friction),
    "heat": Part(marked("Heat balance"), _heat),
    "frequencies": Part(marked("Fault frequencies"), _frequencies),
    "stiffness": Part(marked("Stiffness"), _stiffness),
    "inputs": Part(marked("Inputs"), lambda report: _blocks(_inputs(report))),
    "validity": Part(marked("Validity"), lambda report: _blocks(_validity(report))),
}
"""The results by parts, in the order in which an engineer reads them."""
_COMPARED: Final = (
    "loads", "lives", "clearance", "ring", "rows", "contacts", "film", "friction", "stiffness",
)  # fmt: skip


# --- validity, references, provenance -------------------------------------------------------------

_CHECKS: Final[Mapping[str, tuple[str, str]]] = {
    "pressure": (marked("contact pressure, static limit of ISO 76"), ".4 [MPa]"),
    "line_pressure": (marked("contact pressure of rollers, static limit of ISO 76"), ".4 [MPa]"),
    "tilt": (marked("tilt of the inner ring (small angles)"), ".3 [°]"),
    "misalignment": (marked("misalignment that makers permit of roller bearings"), ".3 [mrad]"),
    "speed": (marked("speed factor n·d_m"), ".3 [10⁶ mm·rpm]"),
    "load": (marked("equivalent load P over dynamic rating C"), ".3"),
    "reference_load": (marked("reference load P_ref over dynamic rating C"), ".3"),
    "film_U": (marked("Hamrock–Dowson, speed parameter U"), ".1e"),
    "film_W": (marked("Hamrock–Dowson, load parameter W"), ".1e"),
    "film_G": (marked("Hamrock–Dowson, material parameter G"), ".4"),
    "film_k": (marked("Hamrock–Dowson, ellipticity k"), ".3"),
}
"""Labels of the checks of a case: label, and form of the numbers."""


def _validity(report: Report) -> list[doc.Section]:
    many = len(report.cases) > 1
    sections = []
    for case in report.cases:
        if not case.converged:
            continue
        heading = (
            said("Limits of the models, case {name}", name=case.name)
            if many
            else said("Limits of the models")
        )
        sections.append(doc.Section(heading, (_check_table(case),), f"limits_{case.name}", 3))
    life = _life_validity(report)
    if life:
        sections.append(doc.Section(said("Theories of life"), life, "life_validity", 3))
    friction = _friction_validity(report)
    if friction:
        sections.append(doc.Section(said("Models of friction"), friction, "friction_validity", 3))
    return sections


def _check_table(case: CaseReport) -> doc.Table:
    checks = [check for check in case.checks if check.name in _CHECKS]
    forms = [_CHECKS[check.name][1] for check in checks]
    units = [form.partition("[")[2].rstrip("]") for form in forms]

    def column(name: str, head: str) -> doc.Column:
        values: list[doc.CellContent] = []
        for check, form in zip(checks, forms, strict=True):
            value = getattr(check, name)
            own = None if value is None or (name == "least" and check.low is None) else value
            values.append(None if own is None else doc.Number(float(own), form))
        return doc.Column(head, values, name, align="right")

    columns = (
        doc.Column(said("limit"), [said(_CHECKS[check.name][0]) for check in checks], "limit"),
        doc.Column(said("unit"), units, "unit", tone="faint"),
        column("low", said("lower limit")),
        column("high", said("upper limit")),
        column("least", said("minimum here")),
        column("greatest", said("maximum here")),
        doc.Column(
            said("within limits"),
            [said("yes") if check.met else said("no") for check in checks],
            "met",
            tones=["good" if check.met else "warning" for check in checks],
        ),
        doc.Column(
            "path",
            [f"checks.{case.checks.index(check)}" for check in checks],
            "path",
            only_in_files=True,
        ),
    )
    return doc.Table(columns, f"limits_{case.name}", rule=True)


def _life_validity(report: Report) -> tuple[doc.Table, ...]:
    """Which theory is valid for which case, and what refuses or bounds it."""
    rows, verdicts = [], []
    for name in THEORIES:
        own = [_reasoned(case, name) for case in report.cases]
        if any(text for text, _ in own):
            rows.append(theory_name(name))
            verdicts.append(own)
    return _verdict_table(report, said("theory"), rows, verdicts, "life_validity")


def _reasoned(case: CaseReport, theory: str) -> tuple[str, doc.Tone]:
    life = case.analysis.life
    if life is None or theory not in life.theories:
        return "", ""
    own = life.theories[theory]
    why = [note.text for note in own.notes_of(0) if note.key in OUTSIDE | BOUNDS]
    holds = bool(own.valid[0] or own.below[0])
    return _with_reasons(_verdict(case, theory), why), "" if holds else "warning"


def _with_reasons(verdict: str, why: Sequence[str]) -> str:
    return said("{verdict}: {why}", verdict=verdict, why=" ".join(why)) if why else verdict


def _friction_validity(report: Report) -> tuple[doc.Table, ...]:
    names = dict.fromkeys(
        found.model
        for case in report.cases
        if case.analysis.friction is not None
        for found in case.analysis.friction.judged
    )
    verdicts = [[_friction_verdict(case, name) for case in report.cases] for name in names]
    labels = [torque_model_name(name) for name in names]
    return _verdict_table(report, said("model"), labels, verdicts, "friction_validity")


def _friction_verdict(case: CaseReport, model: str) -> tuple[str, doc.Tone]:
    friction = case.analysis.friction
    found = None if friction is None else next(
        (own for own in friction.validity if own.model == model), None
    )  # fmt: skip
    if found is None:
        return "", ""
    why = [note.text for note in found.notes_of(0)]
    if found.valid[0]:
        return _with_reasons(said("yes"), why), ""
    return _with_reasons(said("no"), why), "warning"


def _verdict_table(
    report: Report,
    head: str,
    rows: Sequence[str],
    verdicts: Sequence[Sequence[tuple[str, doc.Tone]]],
    key: str,
) -> tuple[doc.Table, ...]:
    if not rows:
        return ()
    many = len(report.cases) > 1
    columns = [doc.Column(head, list(rows), head)]
    for index, case in enumerate(report.cases):
        texts, tones = zip(*(own[index] for own in verdicts), strict=True)
        columns.append(
            doc.Column(
                said("case {name}", name=case.name) if many else said("valid here"),
                texts,
                case.name,
                tones=tones,
            )
        )
    return (doc.Table(tuple(columns), key, rule=True),)


def _references(cases: Iterable[CaseReport]) -> tuple[doc.Statement, ...]:
    return tuple(
        doc.Statement(text, mark=f"[{number}]")
        for number, text in enumerate(references_of(cases), start=1)
    )


def _provenance(report: Report) -> tuple[doc.KeyValues | doc.Statement, ...]:
    entries = [doc.Entry(said("program"), said("Rolamento {version}", version=report.version))]
    many = len(report.cases) > 1
    for case in report.cases:
        if many:
            label = said("case {name}, SHA-256 of the inputs", name=case.name)
            source = said("case {name}, source", name=case.name)
        else:
            label, source = said("SHA-256 of the inputs"), said("source")
        if case.source:
            entries.append(doc.Entry(source, case.source))
        entries.append(doc.Entry(label, case.checksum))
    explained = said(
        "The checksum covers all inputs in SI units, defaults included; titles and the title block "
        "are excluded. Equal checksums mean equal inputs."
    )
    return doc.KeyValues(tuple(entries)), doc.Statement(explained, "faint")
