"""The pages of a machine's history, of its bearings together, and of a bearing nobody knows."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rolamento import document as doc
from rolamento import plots
from rolamento.pages.diagnosis import diagnosis_page
from rolamento.pages.given import picture
from rolamento.words import ABSENT, said, said_in
from rolamento.words.naming import one_line, part_name
from rolamento.words.sentences.history import series_name

if TYPE_CHECKING:
    from rolamento.tasks.diagnosis import UnknownResult
    from rolamento.tasks.history import History, Records
    from rolamento.tasks.machine_diagnosis import MachineDiagnosis
    from rolamento.words import Note

__all__ = ["history_page", "machine_page", "records_page", "unknown_page"]

_TONES: Final[dict[str, doc.Tone]] = {
    "fault": "bad-strong",
    "undecided": "warning-strong",
    "watch": "warning",
    "nothing_found": "good",
    "no_verdict": "warning-strong",
}
_MOST_FITS: Final = 20
_MOST_ROWS: Final = 60


def _headline(verdict: str, statement: tuple[Note, ...]) -> doc.Section:
    tone = _TONES[verdict]
    return doc.Section("", tuple(doc.Statement(note.text, tone) for note in statement), "verdict")


def history_page(found: History) -> doc.Document:
    """Return the page of a record beside those of the machine's good days.

    Parameters
    ----------
    found
        Of `rolamento.tasks.history.diagnose_since`.
    """
    element = found.now.diagnosis.element
    changes = {
        "grown": said_in("depth", "doubled"),
        "as_always": said_in("depth", "as always"),
        "small": said_in("depth", "small"),
        "unknown": ABSENT,
    }
    parts = found.parts
    table = doc.Table(
        (
            doc.Column("", [part_name(p.component, element) for p in parts], "part"),
            doc.Column(said("order"), [p.order for p in parts], "order", form=".4f"),
            doc.Column(
                said("depth then, at most"), [p.usual for p in parts], "then", "%", form=".0f [%]"
            ),
            doc.Column(said("depth now"), [p.now for p in parts], "now", "%", form=".0f [%]"),
            doc.Column(said("change"), [changes[p.change] for p in parts], "change"),
        ),
        "then",
        legends=(
            said(
                "Depth then: the greatest of {count} records at like speed, of all bands, near the"
                " order of now. Doubled: damage; below {least:.0f %} nothing is compared.",
                count=len(found.compared),
                least=0.15,
            ),
        ),
    )

    depths = [(part.component, part.now, part.then) for part in parts]
    caption = said("Modulation depth now and then")
    page = diagnosis_page(found.now)
    rest = [section for section in page.sections if section.key != "verdict"]
    sections = (
        _headline(found.verdict, found.statement),
        doc.Section(said("Now and then"), (table,), "history"),
        picture(caption, lambda: plots.then_figure(depths), "then", "history_figure"),
        *rest,
    )
    return doc.Document(page.title, sections, kind="diagnose", main="then")


def records_page(found: Records, title: str) -> doc.Document:
    """Return the page of many records of one machine.

    Parameters
    ----------
    found
        Of `rolamento.tasks.history.trend_of_records`.
    title
        Of the folder.
    """
    last = found.last
    verdict = "watch" if any(found.steps.values()) else "nothing_found"
    if last is not None and last.verdict in ("fault", "undecided"):
        verdict = last.verdict
    columns = [
        doc.Column(said("from record"), list(found.names), "record"),
        doc.Column(said("records"), list(found.counts), "count"),
    ]
    for name, values in found.series.items():
        is_depth = name not in ("rms", "kurtosis")
        columns.append(
            doc.Column(
                series_name(name),
                values.tolist(),
                name,
                "%" if is_depth else "",
                form=".0f [%]" if is_depth else ".4",
            )
        )
    table = doc.Table(tuple(columns), "records")

    changes = {name: [step.place for step in steps] for name, steps in found.steps.items()}
    depths = {str(part): values for part, values in found.depths.items()}
    caption = said("Modulation depth over the records")
    blocks: list[doc.Block] = [doc.Title(one_line(title)), table]
    sections = [
        _headline(verdict, found.statement),
        doc.Section("", tuple(blocks), "records"),
        picture(caption, lambda: plots.records_figure(depths, changes), "records", "figures"),
    ]
    return doc.Document(title, tuple(sections), kind="diagnose", main="records")


def machine_page(found: MachineDiagnosis) -> doc.Document:
    """Return the page of all bearings of a machine.

    Parameters
    ----------
    found
        Of `rolamento.tasks.machine_diagnosis.diagnose_machine`.
    """
    sections: list[doc.Section | doc.Beside] = [_headline(found.verdict, found.statement)]
    for bearing, one in zip(found.machine.bearings, found.found, strict=True):
        page = diagnosis_page(one)
        kept = [part for part in page.sections if part.key in ("given", "parts", "why")]
        sections += [doc.Section(bearing.name, (), "bearing"), *kept]
    return doc.Document(
        one_line(found.found[0].title), tuple(sections), kind="diagnose", main="parts"
    )


def unknown_page(found: UnknownResult) -> doc.Document:
    """Return the page of the combs of a record, and of the bearings that would have them.

    Parameters
    ----------
    found
        Of `rolamento.tasks.diagnosis.rank_bearings`.
    """
    combs, fits = found.found.combs, found.found.fits[:_MOST_FITS]
    confirmed = found.found.speed_confirmed
    speed = said("by the shaft's own peaks") if confirmed else said("as given")
    entries = (
        doc.Entry(
            said("shaft"),
            said(
                "{frequency:.5 Hz}, {source}", frequency=found.found.shaft_frequency, source=speed
            ),
        ),
        doc.Entry(said("compared"), said("{count} bearings", count=found.found.compared)),
    )
    table = doc.Table(
        (
            doc.Column(said("comb"), list(range(1, len(combs) + 1)), "comb"),
            doc.Column(
                said("frequency"),
                [comb.frequency for comb in combs],
                "frequency",
                "Hz",
                form=".2f [Hz]",
            ),
            doc.Column(said("order"), [c.order for c in combs], "order", form=".4f"),
            doc.Column(
                said_in("column", "depth"),
                [comb.depth for comb in combs],
                "depth",
                "%",
                form=".0f [%]",
            ),
            doc.Column(said("lines"), [comb.lines for comb in combs], "lines"),
        ),
        "combs",
    )
    ranked = doc.Table(
        (
            doc.Column(said("bearing"), [fit.designation for fit in fits], "designation"),
            doc.Column(said("explains"), [fit.share for fit in fits], "share", "%", form=".0f [%]"),
            doc.Column(
                said("cage off by"), [fit.slip for fit in fits], "slip", "%", form=".2f [%]"
            ),
            doc.Column(
                said("combs"),
                [
                    ", ".join(f"{number + 1}: {part_name(part)}" for part, number, _ in fit.parts)
                    for fit in fits
                ],
                "parts",
            ),
        ),
        "bearings",
        legends=(said("Explains: of the squared depths of all combs, with one cage speed."),),
    )
    sections = (
        _headline(found.verdict, found.statement),
        doc.Section("", (doc.Title(one_line(found.title)), doc.KeyValues(entries)), "given"),
        doc.Section(said("Combs"), (table,), "combs"),
        doc.Section(said("Bearings that would have them"), (ranked,), "bearings"),
    )
    return doc.Document(one_line(found.title), sections, kind="diagnose", main="bearings")
