"""The page of the verification: published numbers beside the computed ones."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import groupby
from math import floor, isfinite, log10
from typing import Final

from rolamento import document as doc
from rolamento.verification import (
    VERDICTS,
    Check,
    CheckVerdict,
    SourceResult,
    Verification,
    held_out,
)
from rolamento.words import ABSENT, manner, marked, said, said_in

__all__ = ["COMMAND", "summary", "verification_page"]

COMMAND: Final = "rolamento verify --markdown docs/verification.md"
"""What writes the page of the documentation."""

_TONES: Final[Mapping[CheckVerdict, doc.Tone]] = {
    "agrees": "good",
    "explained": "warning",
    "fails": "bad-strong",
}
_VERDICTS: Final[Mapping[CheckVerdict, str]] = {
    "agrees": marked("agrees"),
    "explained": marked("explained"),
    "fails": marked("fails"),
}
_TERMS: Final = (
    marked("over the pair's preload or rigidity"),
    marked("unloading load"),
    marked("axial rigidity"),
    marked("preload"),
    marked("General Catalogue, page"),
    marked("catalogue 4000 0813 EN, page"),
    marked("catalogue 4000 0813 EN, table of bearing data"),
    marked("Reference program for"),
    marked("as in"),
    marked("chapters 3.4.2 and 4.4.3"),
    marked("chapter"),
    marked("dimensionless contact parameters"),
    marked("example"),
    marked("text before figure"),
    marked("text after figure"),
    marked("text to figure"),
    marked("table of"),
    marked("table"),
    marked("radial load"),
    marked("axial load"),
    marked("drive-end bearing"),
    marked("at rest"),
    marked("fall of"),
    marked(" of Harris"),
    marked("cage"),
    marked("outer race"),
    marked("inner race"),
    marked("ball, twice"),
    marked("turn"),
    marked("viscosity index"),
    marked(", bearing new"),
    marked(", bearing"),
    marked(", condition"),
    marked(", convex"),
    marked("without test"),
    marked("L_10h, all"),
    marked("quoted"),
)
"""Words of citations and of quantities: what is not a name or a symbol. The longer ones come
first."""
_TERM: Final = re.compile("|".join(map(re.escape, _TERMS)))


def verification_page(found: Verification, *, introduction: bool = False) -> doc.Document:
    """Return the page of a verification.

    Parameters
    ----------
    found
        From `rolamento.verification.run`.
    introduction
        Whether to begin with what the page is, for the documentation.
    """
    title = said("Verification")
    sections = [_introduction(title), _held_out()] if introduction else []
    for result in found.results:
        sections += _of_source(result)
    sections.append(doc.Section(blocks=(doc.Statement(_proof_note(), "faint"),), key="proof"))
    mark, tone = ("✓", _TONES["agrees"]) if found.passed else ("✗", _TONES["fails"])
    sections.append(
        doc.Section(blocks=(doc.Statement(summary(found), tone, mark=mark),), key="summary")
    )
    return doc.Document(title, tuple(sections), "verify")


def summary(found: Verification) -> str:
    """Say how many numbers there are, and how many of each verdict."""
    counts = {verdict: found.count(verdict) for verdict in VERDICTS}
    return said(
        "{count} numbers: {agrees} agree, {explained} explained, {fails} fail",
        count=len(found.checks),
        **counts,
    )


def term(text: str) -> str:
    """Say a citation or the name of a quantity, its words one by one."""
    return _TERM.sub(lambda match: said(match[0]), text)


def _introduction(title: str) -> doc.Section:
    text = said(
        "Published numbers beside those that this program gives. This page is written by"
        " {command}; `rolamento verify` prints the same in a terminal, with exit code 1 if a number"
        " fails.",
        command=COMMAND,
    )
    meaning = said(
        "Printed is the published number with its digits; computed is what the program gives by"
        " its own models, with one digit more; the tolerance is half a unit of the last printed"
        " digit, unless a note says otherwise. A number agrees if the difference is within the"
        " tolerance; it is explained if it is not, but the explanation has been tested; otherwise"
        " it fails."
    )
    return doc.Section(blocks=(doc.Title(title), doc.Statement(text), doc.Statement(meaning)))


def _held_out() -> doc.Section:
    """What took no part in the development."""
    text = said(
        "What was kept back while the program was written, and tried on it afterwards (version"
        " 0.1.0): a number that agrees here was not at hand to be matched."
    )
    tried = held_out()
    columns = (
        doc.Column(said("held out"), [one.what.text for one in tried], "held_out"),
        doc.Column(said("tried"), [one.of for one in tried], "tried"),
        doc.Column(said("hold"), [one.hold for one in tried], "hold"),
        doc.Column(said("within"), [one.within or None for one in tried], "within", align="right"),
    )
    table = doc.Table(columns, "held_out")
    return doc.Section(said("Held out"), (doc.Statement(text), table), "held_out", 1)


def _proof_note() -> str:
    return said(
        "Proof of an explanation: what the program gives with the author's choice, which must equal"
        " the printed number; or, where the print is wrong, the number that should have been"
        " printed, which must equal the computed one."
    )


def _of_source(result: SourceResult) -> Iterator[doc.Section]:
    yield doc.Section(result.title, key=result.name, level=1)
    for place, (source, group) in enumerate(groupby(result.checks, lambda check: check.source)):
        key = f"{result.name}_{place + 1}"
        yield doc.Section(term(source), (_table(list(group), key),), key)


def _table(checks: Sequence[Check], key: str) -> doc.Table:
    """Return one table with its notes; the column of proofs only where there is one."""
    notes = list(dict.fromkeys(one.explanation for one in checks if one.explanation))
    mark = manner().mark
    columns = [
        doc.Column(
            said("quantity"), [_quantity(check).replace(".", mark) for check in checks], "quantity"
        ),
        _numbers(said("printed"), "printed", checks, _printed),
        replace(
            _numbers(said("computed"), "computed", checks, _computed),
            tones=["bad-strong" if one.verdict == "fails" else "strong" for one in checks],
        ),
        _numbers(said("difference"), "difference", checks, _difference),
        _numbers(said_in("verification", "tolerance"), "tolerance", checks, _tolerance),
    ]
    if any(one.corrected or one.evidence is not None for one in checks):
        columns.append(_numbers(said("proof"), "proof", checks, _proof))
    columns.append(
        doc.Column(
            said("verdict"),
            [
                f"{said(_VERDICTS[one.verdict])} [{notes.index(one.explanation) + 1}]"
                if one.explanation
                else said(_VERDICTS[one.verdict])
                for one in checks
            ],
            "verdict",
            tones=[_TONES[one.verdict] for one in checks],
        )
    )
    legends = tuple(f"[{place}] {note.text}" for place, note in enumerate(notes, start=1))
    return doc.Table(tuple(columns), key, legends=legends)


def _quantity(check: Check) -> str:
    """Return the quantity with its unit."""
    return term(check.quantity) + (f" [{term(check.unit)}]" if check.unit else "")


# --- numbers, each with one digit more than the print ------------------------------------------


def _numbers(
    head: str, key: str, checks: Sequence[Check], cell: Callable[[Check], doc.CellContent]
) -> doc.Column:
    values = [cell(check) for check in checks]
    return doc.Column(head, values, key, align="right")


def _places(printed: str) -> tuple[int, int]:
    """Return the decimals of the mantissa of a printed number, and its power of ten."""
    mantissa, _, exponent = printed.partition("e")
    return len(mantissa.partition(".")[2]), int(exponent or 0)


def _printed(check: Check) -> doc.CellContent:
    decimals, power = _places(check.printed)
    return _number(float(check.printed), decimals, power)


def _computed(check: Check) -> doc.CellContent:
    return _like_print(check, check.computed)


def _like_print(check: Check, value: float) -> doc.CellContent:
    decimals, power = _places(check.printed)
    return _number(value, decimals + 1, power)


def _proof(check: Check) -> doc.CellContent:
    if check.corrected:
        return _number(float(check.corrected), *_places(check.corrected))
    return None if check.evidence is None else _like_print(check, check.evidence)


def _number(value: float, decimals: int, power: int) -> doc.CellContent:
    if not isfinite(value):
        return ABSENT
    if not power:
        return doc.Number(value, f".{decimals}f")
    return f"{manner().fixed(value / 10.0**power, decimals)}e{power}"


def _difference(check: Check) -> doc.CellContent:
    decimals, power = _places(check.printed)
    decimals = max(decimals + 1 - power, 0)
    value = check.difference
    if not isfinite(value):
        return ABSENT
    sign = "+" if round(value, decimals) > 0.0 else ""
    return doc.Number(value, f"{sign}.{decimals}f")


def _tolerance(check: Check) -> doc.Number:
    """Return a tolerance with two significant digits at most, never as a power of ten."""
    value = check.tolerance
    if value == 0.0:
        return doc.Number(value, ".0f")
    decimals = max(1 - floor(log10(value)), 0)
    return doc.Number(value, f".{len(f'{value:.{decimals}f}'.rstrip('0').partition('.')[2])}f")
