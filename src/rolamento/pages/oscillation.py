"""The pages of `oscillation`: lives in oscillations, of one angle or of a histogram of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import isfinite, isinf
from typing import TYPE_CHECKING, Final

from rolamento import document as doc
from rolamento import plots
from rolamento.pages.given import case_page, head, picture, race_name, title_of
from rolamento.pages.notes import cautions, remarks_of
from rolamento.units import HOUR
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.life.oscillation import OscillationLife
    from rolamento.tasks.oscillation import OscillationCase, OscillationSpectrum

__all__ = ["oscillation_page", "oscillation_spectrum_page", "oscillation_statement"]

_MILLION: Final = 1e6
_LIFE: Final = ".3r"
_UNIT: Final = "10⁶ osc."


def oscillation_page(found: OscillationCase) -> doc.Document:
    """Return the life of one case in oscillations: the life, its races, other forms, all angles.

    Parameters
    ----------
    found
        What `rolamento.tasks.life_in_oscillation` gives.
    """
    solved, life = found.solved, found.life
    sections: list[doc.Section] = []
    remarks = remarks_of(solved.notes[0])
    if life is not None:
        blocks = (*oscillation_statement(life), *cautions(life.notes))
        sections.append(doc.Section(said("Life in oscillations"), blocks, "life"))
        caption = said("Life over the angle of oscillation")
        shown = picture(caption, lambda: plots.oscillation_figure(found), "oscillation")
        sections += [_races(life), _forms(life), shown]
        remarks = (*remarks_of(life.notes), *remarks)
    return case_page(
        solved.case,
        head(solved),
        sections,
        "oscillation",
        "races",
        cautions=solved.notes[0],
        remarks=remarks,
    )


def oscillation_statement(life: OscillationLife) -> Iterator[doc.Block]:
    """Yield the life in oscillations and hours, or why there is none."""
    values = {
        "reliability": life.reliability,
        "angle": life.angle,
        "life": _MILLION * life.life,
        "hours": HOUR * life.hours,
    }
    if life.fretting:
        text = said("No fatigue life: swinging by {angle:.4 °}, it frets first.", **values)
        yield doc.Statement(text, "bad-strong", indent=2)
        return
    if not isfinite(life.life):
        endless = isinf(life.life)
        text = said("Fatigue does not end it.") if endless else said("There is no life.")
        yield doc.Statement(text, "strong", indent=2)
        return
    text = said(
        "{reliability:.7 %} of such bearings survive {life:.3r [10⁶ osc.]} million oscillations of"
        " {angle:.4 °}.",
        **values,
    )
    if isfinite(life.hours):
        text = said(
            "{reliability:.7 %} of such bearings survive {life:.3r [10⁶ osc.]} million oscillations"
            " of {angle:.4 °}: {hours:.3r h}.",
            **values,
        )
    yield doc.Statement(text, "strong", indent=2)
    limiting = life.limiting
    yield doc.Statement(said("The inner race limits it.") if limiting == "inner" else
        said("The outer race limits it."), indent=2)  # fmt: skip


def _races(life: OscillationLife) -> doc.Section:
    """Critical angle, lost averaging and life of each race."""
    rows = len(life.inner)
    races, places, critical, window, lives = [], [], [], [], []
    tones: list[doc.Tone] = []
    for row in range(rows):
        for race in ("inner", "outer"):
            own = float(getattr(life, f"critical_{race}")[row])
            races.append(race_name(race))
            places.append(row)
            critical.append(own)
            window.append(float(life.window[row]) if race == life.moving else 1.0)
            lives.append(_MILLION * float(getattr(life, race)[row]))
            tones.append("warning" if life.angle < own else "")
    columns = [doc.Column("", races, "race", tones=tones)]
    if rows > 1:
        columns.append(doc.Column(said("row"), places, "row"))
    columns += [
        doc.Column(
            said("critical angle"),
            [doc.Number(value, ".4 [°]") for value in critical],
            "critical",
            "°",
            tones=tones,
        ),
        doc.Column(said("lost averaging"), window, "window", "–", form=".4", tones=tones),
        doc.Column(
            said("life"),
            [doc.Number(value, f"{_LIFE} [{_UNIT}]") for value in lives],
            "life",
            _UNIT,
            tones=tones,
        ),
    ]
    legend = said(
        "critical angle between the end points, at which neighbouring arcs meet; lost averaging by"
        " which the life of the race that moves against the load falls"
    )
    table = doc.Table(tuple(columns), "races", legends=(legend,), rule=True, fixed=1)
    return doc.Section(said("Races"), (table,), "races")


def _forms(life: OscillationLife) -> doc.Section:
    """The life beside what simpler forms make of it."""
    harris = said("Harris, (90°/θ) L_rot with θ = φ/2: without the lost averaging")
    makers = said("makers of robot gears, (180°/φ) (C/P)^p: of the catalogue's load")
    rows = (
        (said("race by race, as above"), life.life),
        (harris, life.harris),
        (makers, life.makers),
    )
    entries = [
        doc.Entry(name, doc.Number(_MILLION * value, f"{_LIFE} [{_UNIT}]"), "")
        for name, value in rows
    ]
    entries.append(
        doc.Entry(
            said("reference life in rotation, million revolutions"),
            doc.Number(_MILLION * life.rotation, f"{_LIFE} [{_UNIT}]"),
        )
    )
    return doc.Section(
        said("Other forms, million oscillations"), (doc.KeyValues(tuple(entries), 2),), "forms"
    )


# --- of a histogram -------------------------------------------------------------------------------


def oscillation_spectrum_page(found: OscillationSpectrum) -> doc.Document:
    """Return the life under a histogram of oscillations, and what each step takes of it.

    Parameters
    ----------
    found
        What `rolamento.tasks.life_under_oscillations` gives.
    """
    title = title_of(found.case)
    values = {
        "reliability": found.reliability,
        "life": _MILLION * found.life,
        "hours": HOUR * found.hours,
    }
    if found.converged:
        text = said(
            "{reliability:.7 %} of such bearings survive {life:.3r [10⁶ osc.]} million oscillations"
            " of this duty.",
            **values,
        )
        if isfinite(found.hours):
            text = said(
                "{reliability:.7 %} of such bearings survive {life:.3r [10⁶ osc.]} million"
                " oscillations of this duty: {hours:.3r h}.",
                **values,
            )
        statement = doc.Statement(text, "strong", indent=2)
    else:
        text = said("No fatigue life: at least one step frets, or has no life.")
        statement = doc.Statement(text, "bad-strong", indent=2)
    tones: list[doc.Tone] = ["warning" if one.fretting else "" for one in found.lives]
    columns = (
        _percent(said("share"), "share", found.steps.shares.tolist(), tones),
        doc.Column(
            said("angle"),
            [doc.Number(one.angle, ".4 [°]") for one in found.lives],
            "angle",
            "°",
            tones=tones,
        ),
        doc.Column(
            said("life of the step alone"),
            [doc.Number(_MILLION * one.life, f"{_LIFE} [{_UNIT}]") for one in found.lives],
            "life",
            _UNIT,
            tones=tones,
        ),
        _percent(said("share of the damage"), "damage", found.damage.tolist(), tones),
    )
    table = doc.Table(columns, "steps", rule=True)
    first = doc.Section("", (doc.Title(title), statement, *cautions(found.notes)), "head")
    steps = doc.Section(said("Steps"), (table,), "steps")
    remarks = remarks_of(found.notes)
    return case_page(found.case, first, [steps], "oscillation", "steps", remarks=remarks)


def _percent(head: str, key: str, shares: Sequence[float], tones: Sequence[doc.Tone]) -> doc.Column:
    values = [doc.Number(share, ".3 [%]") for share in shares]
    return doc.Column(head, values, key, "%", align="right", tones=tones)
