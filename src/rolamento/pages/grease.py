"""The page of `grease`: lives by every law, intervals, amounts, limits, and which grease."""

from __future__ import annotations

from collections.abc import Iterator
from math import isfinite, isnan
from typing import TYPE_CHECKING

from rolamento import document as doc
from rolamento import plots
from rolamento.pages.given import case_page, head, picture
from rolamento.pages.notes import cautions, notes_section, remarks_of
from rolamento.units import HOUR
from rolamento.words import ABSENT, said
from rolamento.words.sentences.grease import BASE_OILS, FACTORS, LAWS, SETS, THICKENERS

if TYPE_CHECKING:
    from rolamento.grease.of_case import GreaseCase
    from rolamento.lubrication.oil_choice import OilChoice

__all__ = ["grease_page", "grease_statement", "oil_page", "oil_section"]

_HOURS = ".3r [h]"


def grease_page(found: GreaseCase) -> doc.Document:
    """Return the grease of one case.

    Parameters
    ----------
    found
        What `rolamento.tasks.grease_of_case` gives.
    """
    solved = found.solved
    blocks = (*grease_statement(found), *cautions(found.notes))
    sections = [doc.Section(said("Grease"), blocks, "grease")]
    if found.lives:
        sections.append(_lives(found))
        caption = said("Life of the grease over the temperature")
        sections.append(picture(caption, lambda: plots.grease_figure(found), "grease"))
    if found.intervals:
        sections.append(_intervals(found))
    sections.append(_limits(found))
    if found.oil is not None:
        sections.append(_which(found))
    remarks = remarks_of(found.notes)
    return case_page(solved.case, head(solved), sections, "grease", "lives", remarks=remarks)


def grease_statement(found: GreaseCase) -> Iterator[doc.Block]:
    """Yield how long the grease lives or when it wants renewing, in a sentence."""
    low, high = found.spread
    if isfinite(found.hours):
        values = {"hours": HOUR * found.hours, "low": HOUR * low, "high": HOUR * high}
        text = said(
            "The grease lives {hours:.2r h} on average, by {count} laws from {low:.2r [h]} to"
            " {high:.2r h}; 90 % of the bearings reach {l10:.2r h}.",
            **values,
            count=sum(one.valid for one in found.lives),
            l10=HOUR * found.l10,
        )
        yield doc.Statement(text, "strong", indent=2)
        return
    if found.intervals:
        low, high = found.interval
        text = said(
            "Relubricate every {low:.2r [h]} to {high:.2r h}, by whose factors are taken.",
            low=HOUR * low,
            high=HOUR * high,
        )
        if isfinite(found.amount_side):
            text = said(
                "Relubricate every {low:.2r [h]} to {high:.2r h}, by whose factors are taken, with"
                " {amount:.2} g from the side.",
                low=HOUR * low,
                high=HOUR * high,
                amount=1e3 * found.amount_side,
            )
        yield doc.Statement(text, "strong", indent=2)
        return
    text = said("No law gives a life of the grease or an interval for this case.")
    yield doc.Statement(text, "warning", indent=2)


def _lives(found: GreaseCase) -> doc.Section:
    tones: list[doc.Tone] = ["" if one.valid else "warning" for one in found.lives]
    hours: list[doc.CellContent] = [doc.Number(HOUR * one.hours, _HOURS) for one in found.lives]
    notes = ["; ".join(note.text for note in one.notes) or ABSENT for one in found.lives]
    columns = (
        doc.Column("", [said(LAWS[one.name]) for one in found.lives], "law", tones=tones),
        doc.Column(said("mean life"), hours, "hours", "h", align="right", tones=tones),
        doc.Column(said("range"), notes, "notes", tone="faint"),
        doc.Column(
            said("source"), [one.source for one in found.lives], "source", only_in_files=True
        ),
    )
    duty = found.duty
    legend = said(
        "at {temperature:.4 °C}, n/N = {ratio:.3}, n d_m = {product:.3r}, P/C = {load:.3}",
        temperature=duty.temperature,
        ratio=duty.speed_ratio,
        product=duty.speed_factor,
        load=duty.load_ratio,
    )
    table = doc.Table(columns, "lives", legends=(legend,), rule=True, fixed=1)
    return doc.Section(said("Life of the grease"), (table,), "lives")


def _intervals(found: GreaseCase) -> doc.Section:
    acting = (
        name
        for one in found.intervals
        for name, pair in one.factors.items()
        if pair != (1.0, 1.0) or name == "temperature"
    )
    names = list(dict.fromkeys(acting))
    columns = [doc.Column("", [said(SETS[one.name]) for one in found.intervals], "set")]
    for end, head_ in (("low", said("from")), ("high", said("to"))):
        values: list[doc.CellContent] = [
            doc.Number(HOUR * getattr(one, end), _HOURS) for one in found.intervals
        ]
        columns.append(doc.Column(head_, values, end, "h", align="right"))
    for name in names:
        texts = [_factor(one.factors.get(name)) for one in found.intervals]
        columns.append(doc.Column(said(FACTORS[name]), texts, name, align="right"))
    columns.append(
        doc.Column(
            said("source"), [one.source for one in found.intervals], "source", only_in_files=True
        )
    )
    legend = said(
        "factors on K (14·10⁶/(n √d) − 4 d) = {base:.3r h}; FAG's are ranges, from general"
        " knowledge of its publication",
        base=HOUR * found.base,
    )
    table = doc.Table(tuple(columns), "intervals", legends=(legend,), rule=True, fixed=1)
    blocks: list[doc.Block] = [table]
    if isfinite(found.amount_side):
        entries = [
            doc.Entry(said("SKF, from the side"), _grams(found.amount_side)),
            doc.Entry(said("SKF, through the outer ring"), _grams(found.amount_middle)),
        ]
        if isfinite(found.amount_fag):
            entries.append(doc.Entry(said("FAG, by the interval"), _grams(found.amount_fag)))
        blocks.append(doc.Statement(said("Amount of each relubrication"), indent=2))
        blocks.append(doc.KeyValues(tuple(entries), 4))
    return doc.Section(said("Relubrication"), tuple(blocks), "intervals")


def _grams(kilograms: float) -> str:
    return said("{amount:.3} g", amount=1e3 * kilograms)


def _factor(pair: tuple[float, float] | None) -> str:
    if pair is None:
        return ABSENT
    low, high = pair
    if low == high:
        return said("{value:.3}", value=low)
    return said("{low:.3}–{high:.3}", low=low, high=high)


def _limits(found: GreaseCase) -> doc.Section:
    duty, (low, high) = found.duty, found.usable
    hot = not low <= duty.temperature <= high
    fast = duty.speed_ratio > 1.0
    entries = [
        doc.Entry(
            said("temperature"),
            said(
                "{temperature:.4 °C}; the grease may be used from {low:.4 [°C]} to {high:.4 °C}",
                temperature=duty.temperature,
                low=low,
                high=high,
            ),
            "warning" if hot else "",
        )
    ]
    if isnan(duty.speed_ratio):
        text = said("{speed:.5 rpm}; n d_m = {product:.3r}", speed=duty.speed,
                    product=duty.speed_factor)  # fmt: skip
    else:
        text = said(
            "{speed:.5 rpm}, {ratio:.3} of N = {limit:.3 rpm}; n d_m = {product:.3r}",
            speed=duty.speed,
            ratio=duty.speed_ratio,
            limit=duty.limiting_speed,
            product=duty.speed_factor,
        )
    entries.append(doc.Entry(said("speed"), text, "warning" if fast else ""))
    return doc.Section(said("Limits"), (doc.KeyValues(tuple(entries), 2),), "limits")


def _which(found: GreaseCase) -> doc.Section:
    oil, duty = found.oil, found.duty
    assert oil is not None
    entries = [
        doc.Entry(
            said("base oil for κ = {kappa:.3}", kappa=oil.required),
            said(
                "{needed:.3 mm²/s} at 40 °C, {at:.3 mm²/s} at {temperature:.4 °C}",
                needed=oil.needed_40,
                at=oil.required * oil.reference,
                temperature=duty.temperature,
            ),
        ),
        doc.Entry(
            said("thickener and base oil"),
            said(
                "{thickener} with {base_oil}",
                thickener=said(THICKENERS[duty.thickener]),
                base_oil=said(BASE_OILS[duty.base_oil]),
            ),
        ),
        doc.Entry(said("consistency"), _nlgi(found)),
    ]
    return doc.Section(said("Which grease"), (doc.KeyValues(tuple(entries), 2),), "which")


def _nlgi(found: GreaseCase) -> str:
    if found.vertical:
        return said("NLGI {grade}: a softer one runs out of a vertical shaft", grade=found.nlgi)
    if found.nlgi == 1:
        return said("NLGI {grade}: a stiffer one does not start in the cold", grade=found.nlgi)
    return said("NLGI {grade}, as a rule", grade=found.nlgi)


# --- an oil ---------------------------------------------------------------------------------------


def oil_page(found: OilChoice, title: str) -> doc.Document:
    """Return the ISO viscosity grades for a required κ over a range of temperatures.

    Parameters
    ----------
    found
        What `rolamento.tasks.choose_oil_of_case` gives.
    title
        Of the page.
    """
    from rolamento.document import Title

    if found.chosen is None:
        text = said("No ISO grade gives κ = {kappa:.3}.", kappa=found.required)
        statement = doc.Statement(text, "bad-strong", indent=2)
    else:
        chosen = found[found.chosen]
        values = {
            "name": chosen.name, "hot": chosen.ratio_hot, "cold": chosen.ratio_cold,
            "hottest": found.hottest, "coldest": found.coldest,
        }  # fmt: skip
        if found.coldest == found.hottest:
            text = said("{name}: κ = {hot:.3} at {hottest:.4 °C}.", **values)
        else:
            text = said(
                "{name}: κ = {hot:.3} at {hottest:.4 °C} and {cold:.3} at {coldest:.4 °C}.",
                **values,
            )
        statement = doc.Statement(text, "strong", indent=2)
    sections = [
        doc.Section("", (Title(title), statement, *cautions(found.notes)), "head"),
        oil_section(found),
        *notes_section(remarks_of(found.notes)),
    ]
    return doc.Document(title, tuple(sections), kind="oil", main="grades")


def oil_section(found: OilChoice) -> doc.Section:
    """Return the grades side by side, the one to take in front."""
    grades = found.grades
    tones: list[doc.Tone] = [
        "strong" if one.name == found.chosen else "faint" if one.ratio_hot < found.required else ""
        for one in grades
    ]
    columns = [
        doc.Column(
            "",
            ["▸" if one.name == found.chosen else "" for one in grades],
            "leads",
            tone="good-strong",
        ),
        doc.Column(said("grade"), [one.name for one in grades], "grade", tones=tones),
    ]
    for end, temperature in (("cold", found.coldest), ("hot", found.hottest)):
        where = said("{temperature:.4 °C}", temperature=temperature)
        ratios = [getattr(one, f"ratio_{end}") for one in grades]
        columns += [
            doc.Column(
                said("ν at {where}", where=where),
                [getattr(one, f"viscosity_{end}") for one in grades],
                f"viscosity_{end}",
                "mm²/s",
                form=".3 [mm²/s]",
                tones=tones,
            ),
            doc.Column(
                said("κ at {where}", where=where), ratios, f"ratio_{end}", form=".3", tones=tones
            ),
        ]
        if found.coldest == found.hottest:
            break
    legend = said(
        "ν_1 = {reference:.3 mm²/s} at {speed:.5 rpm} (ISO 281); κ = {kappa:.3} wants"
        " {needed:.3 mm²/s} at 40 °C",
        reference=found.reference,
        speed=found.speed,
        kappa=found.required,
        needed=found.needed_40,
    )
    table = doc.Table(tuple(columns), "grades", legends=(legend,), rule=True, fixed=2)
    return doc.Section(said("Grades"), (table,), "grades")
