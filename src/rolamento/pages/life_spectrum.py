"""The page of `life --spectrum`: the life under a duty of several steps, and what each takes."""

from __future__ import annotations

from collections.abc import Sequence
from textwrap import wrap
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from rolamento import document as doc
from rolamento.case import Case
from rolamento.life import Life
from rolamento.life.iso16281 import THEORY as REFERENCE
from rolamento.life.record import BOUNDS, OUTSIDE, note_of
from rolamento.life.theory import VISCOSITY_RATIO
from rolamento.pages.given import title_of
from rolamento.pages.life import (
    formulas_only,
    life_columns,
    none_valid,
    percent,
    reached,
    remarks,
    required_sentence,
    verdict,
)
from rolamento.pages.notes import cautions
from rolamento.pages.shaft import together_statement
from rolamento.units import HOUR
from rolamento.words import Note, counted, manner, said
from rolamento.words.reasons import reason
from rolamento.words.theories import theory_life, theory_name

if TYPE_CHECKING:
    from rolamento.tasks.life_spectrum import ShaftSpectrum, SpectrumLife

__all__ = ["life_spectrum_page", "shaft_spectrum_page"]

_MOST_SHOWN: Final = 40
_MOST_CHARACTERS: Final = 44
"""Width in characters of the columns of fields that a page shows; files have all of them."""
_HEAD: Final = 12
_CONVERGED: Final = "converged"


def life_spectrum_page(found: SpectrumLife) -> doc.Document:
    """Return the page of the life under a spectrum.

    Parameters
    ----------
    found
        Of `rolamento.tasks.life_spectrum.life_of_duty_spectrum`.
    """
    title = title_of(found.case)
    heading = counted(
        "Life under {n} step of duty", "Life under {n} steps of duty", len(found.steps)
    )
    sections = [
        doc.Section("", (doc.Title(title),)),
        doc.Section(heading, _statement(found), "life"),
        *([_theories(found)] if found.converged else []),
        _steps(found),
    ]
    return doc.Document(title, tuple(sections), kind="life_spectrum", main="all_steps")


def shaft_spectrum_page(found: ShaftSpectrum, names: Sequence[str]) -> doc.Document:
    """Return the page of several bearings of a shaft under one spectrum.

    Parameters
    ----------
    found
        Of `rolamento.tasks.life_spectrum.lives_under`.
    names
        Of the bearings: their titles, or files.
    """
    heading = said("Life of {count} bearings on one shaft", count=len(found.bearings))
    sections: list[doc.Section | doc.Beside] = [
        doc.Section(heading, together_statement(found.together, found.bearings[0].reliability))
    ]
    for name, own in zip(names, found.bearings, strict=True):
        page = life_spectrum_page(own)
        sections += [doc.Section("", (doc.Title(name),)), *page.sections[1:]]
    return doc.Document(heading, tuple(sections), kind="shaft_life_spectrum")


def _statement(found: SpectrumLife) -> tuple[doc.Block, ...]:
    leading = found.headline
    sentences: list[tuple[str, doc.Tone]] = []
    qualified: list[Note] = []
    if not found.converged:
        sentences.append((said("Without a result of every step there is no life."), "bad-strong"))
    elif not (leading.valid or leading.below):
        none = none_valid(found.headline.steps.element)
        sentences += [(none, "bad-strong"), (formulas_only(), "strong")]
    else:
        text = reached(
            leading.theory,
            leading.life,
            leading.hours,
            found.reliability,
            said("this duty"),
            below=leading.below,
        )
        sentences.append((text, "strong"))
        if leading.below:
            bounded = said(
                "It is an upper bound: in some of the steps the standard only bounds the life."
            )
            sentences.append((bounded, "warning"))
        sentences += _worst(found)
        reliability = found.reliability_of_required()
        if found.required_life is not None and reliability is not None:
            text = required_sentence(found.required_life, reliability, below=leading.below)
            sentences.append((text, ""))
        qualified = _qualifications(found)
    if abs(found.steps.given_sum - 1.0) > 1e-9:
        text = said(
            "The shares sum to {total:.5} and were scaled to 1.", total=found.steps.given_sum
        )
        sentences.append((text, "warning"))
    statements = tuple(doc.Statement(text, tone, indent=2) for text, tone in sentences)
    return (*statements, *cautions(qualified))


def _qualifications(found: SpectrumLife) -> list[Note]:
    """Return what qualifies the life that leads, in any of the steps."""
    theory = found.headline.theory
    notes = []
    if theory == REFERENCE.name and not found.headline.below:
        known = VISCOSITY_RATIO.met(found.case)
        notes.append(Note("cleanliness_missing" if known else "lubrication_left_out"))
    steps = found.theories.get(theory, found.theories[REFERENCE.name]).steps
    assert isinstance(steps, Life)
    part = found.taking_part
    for key, where in steps.notes.items():
        if (where & part).any() and key not in OUTSIDE | BOUNDS:
            notes.append(note_of(key, steps.element))
    return notes


def _worst(found: SpectrumLife) -> list[tuple[str, doc.Tone]]:
    damage = found.headline.damage
    if len(damage) < 2 or not np.all(np.isfinite(damage)):
        return []
    worst = int(np.argmax(damage))
    text = said(
        "Step {step} contributes most: {damage} of the damage in {time} of the time.",
        step=worst + 1,
        damage=percent(float(damage[worst])),
        time=percent(float(found.time_shares[worst])),
    )
    return [(text, "")]


def _theories(found: SpectrumLife) -> doc.Section:
    lives = list(found.theories.values())
    judged = [(own.valid, own.below) for own in lives]
    columns = (
        doc.Column("", [theory_name(name) for name in found.theories], "theory"),
        *life_columns([own.life for own in lives], [own.hours for own in lives]),
        doc.Column(
            said("valid here"),
            [verdict(*one) for one in judged],
            "valid",
            tones=["good" if valid else "warning" for valid, _ in judged],
        ),
    )
    legends = [said("for {reliability:.7 %} reliability", reliability=found.reliability)]
    if not found.stress_volume:
        legends.append(
            said("Ioannides and Harris is left out: it is evaluated for at most 1000 steps.")
        )
    table = doc.Table(columns, "theories", legends=tuple(legends), units="behind")
    heading = said("Life by theory, damage summed by Miner's rule")
    return doc.Section(heading, (table, *_remarks(found)), "theories")


def _remarks(found: SpectrumLife) -> tuple[doc.Block, ...]:
    part = found.taking_part
    count = int(part.sum())
    notes = []
    for theory, life in found.theories.items():
        assert isinstance(life.steps, Life)
        for key, where in life.steps.notes.items():
            some = int((where & part).sum())
            if some == count:
                notes.append((theory, note_of(key, life.steps.element), said("in all steps")))
            elif some:
                place = said("in {some} of {count} steps", some=some, count=count)
                notes.append((theory, note_of(key, life.steps.element), place))
    return remarks(notes, len(found.theories))


# --- the steps ---------------------------------------------------------------------------------


def _steps(found: SpectrumLife) -> doc.Section:
    """Set the steps in a table; of many, those that contribute most."""
    shown = _shown(found)
    damage = found.headline.damage[shown]
    legends = []
    if len(shown) < len(found.steps):
        legends.append(
            said(
                "the {shown} steps that contribute most; {count} more contribute {damage} together",
                shown=len(shown),
                count=len(found.steps) - len(shown),
                damage=percent(max(1.0 - float(damage.sum()), 0.0)),
            )
        )
    theory = theory_life(found.headline.theory or REFERENCE.name)
    legends.append(
        said(
            "time, rev: shares of time and of revolutions; h: life if the step were the whole "
            "duty; damage: its share of the damage, by the {theory}",
            theory=theory,
        )
    )
    bars = doc.Column("", np.nan_to_num(damage).tolist(), bar=True)
    table = doc.Table(
        (*_columns(found, shown, shortened=True), bars), "steps", legends=tuple(legends)
    )
    every = np.arange(len(found.steps), dtype=np.int64)
    rest = [
        doc.Column(said("status"), [str(one) for one in found.status], "status"),
        *(
            doc.Column(
                theory_name(name),
                (scale * getattr(own, attribute)).tolist(),
                name if unit == "h" else f"{name}_damage",
                unit,
            )
            for attribute, unit, scale in (("hours", "h", HOUR), ("damage", "%", 1.0))
            for name, life in found.theories.items()
            for own in (life.steps if unit == "h" else life,)
        ),
    ]
    full = doc.Table(
        (*_columns(found, every, shortened=False), *rest), "all_steps", only_in_files=True
    )
    return doc.Section(said("Steps"), (table, *_failures(found), full), "steps")


def _columns(found: SpectrumLife, steps: NDArray[np.int64], *, shortened: bool) -> list[doc.Column]:
    leading = found.headline
    columns = [
        doc.Column(said("step"), [int(step) + 1 for step in steps], "step"),
        _share_column(said("time"), found.time_shares[steps], "time_share"),
        _share_column(said("rev"), found.revolution_shares[steps], "revolution_share"),
    ]
    room = _MOST_CHARACTERS
    fields = Case.fields()
    for name, cells in found.steps.cells.items():
        values = [cells[step] for step in steps]
        values = [manner().localised(one) for one in values] if shortened else values
        label = fields[name].label
        head = "\n".join(wrap(label, _HEAD)) if shortened else label
        room -= max(map(len, (*head.split("\n"), *values))) + 2
        if room >= 0 or not shortened:
            columns.append(doc.Column(head, values, name, align="right"))
    return [
        *columns,
        doc.Column(
            said("life"),
            (HOUR * leading.steps.hours[steps]).tolist(),
            "headline",
            "h",
            form=".3r [h]",
        ),
        _share_column(said("damage"), leading.damage[steps], "headline_damage"),
    ]


def _share_column(head: str, shares: NDArray[np.float64], key: str) -> doc.Column:
    return doc.Column(head, shares.tolist(), key, "%", figures=3, most=2)


def _shown(found: SpectrumLife) -> NDArray[np.int64]:
    """Steps of the table: all, or of many those with the greatest damage, in their order."""
    count = len(found.steps)
    if count <= _MOST_SHOWN:
        return np.arange(count, dtype=np.int64)
    damage = np.nan_to_num(found.headline.damage, nan=0.0)
    return np.sort(np.argsort(-damage, kind="stable")[:_MOST_SHOWN]).astype(np.int64)


def _failures(found: SpectrumLife) -> list[doc.Block]:
    failed = np.flatnonzero((found.status != _CONVERGED) & found.taking_part)
    return [
        doc.Statement(
            said(
                "step {step} (line {line}): {reason}",
                step=step + 1,
                line=found.steps.lines[step],
                reason=reason(str(found.status[step])),
            ),
            "bad",
            indent=2,
            mark="✗",
        )
        for step in failed[:_MOST_SHOWN].tolist()
    ]
