"""The report of a solved state, for a terminal or as plain text."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rich.text import Text

from rolamento.case import Case
from rolamento.case.bearing import Bearing
from rolamento.case.duty import AXES, LOADS, Duty
from rolamento.document.medium import Medium
from rolamento.report.balls import (
    ball_parts,
    heaviest_part,
    rolling_part,
    rosette_part,
    rosettes_width,
)
from rolamento.report.language import ENGLISH, Words
from rolamento.report.page import Lines, Page, beside, notes_part, rendered
from rolamento.report.ring import (
    arrangement_lines,
    preload_part,
    ring_part,
    rows_part,
    stiffness_part,
)
from rolamento.solved import Solved
from rolamento.units import Dimension

if TYPE_CHECKING:
    from rolamento.analysis import Analysis

_GAP: Final = 3


def terminal_report(
    solved: Solved,
    words: Words = ENGLISH,
    medium: Medium | None = None,
    analysis: Analysis | None = None,
) -> str:
    """Return the report of a case as text that ends in a newline.

    Parameters
    ----------
    solved
        One case, converged or not: without a result the report says why and what to do.
    words
        The language.
    medium
        What the text is shown on; by default plain text of 80 columns in UTF-8.
    analysis
        What follows from it; film, friction and life are shown if it has them.
    """
    page = Page(words, medium or Medium())
    parts = [terminal_head(page, solved)]
    if solved.converged[0]:
        parts += [*_set(page, solved), *_middle(page, solved)]
        parts += [stiffness_part(page, solved), *ball_parts(page, solved)]
        parts += [part for part in [rolling_part(page, solved)] if part]
    notes = [words.note(note) for note in solved.notes[0]]
    if analysis is not None:
        parts += _what_follows(page, solved, analysis, notes)
    if notes:
        parts.append(notes_part(page, notes))
    return rendered(page.medium, parts)


def terminal_head(page: Page, solved: Solved) -> Lines:
    """Show the title, what was given, and how the solution ended."""
    words, case = page.words, solved.case
    entries = [
        (words.bearing, _bearing(page, case.bearing), ""),
        (words.duty, _duty(page, case.duty), ""),
        (words.model, _model(page, case), ""),
        *_status(page, solved),
    ]
    entries = [entry for entry in entries if entry[1]]  # at rest no model matters
    return [*page.title(solved.title or words.untitled), *page.labelled(entries)]


def _bearing(page: Page, bearing: Bearing) -> str:
    words, rings, balls = page.words, bearing.ring_material, bearing.ball_material
    geometry = words.geometry.format(
        count=bearing.ball_count,
        ball=page.quantity(bearing.ball_diameter, "length"),
        pitch=page.quantity(bearing.pitch_diameter, "length"),
    )
    conformities = words.conformities.format(
        play=_play(page, bearing),
        inner=page.digits.short(bearing.inner_conformity),
        outer=page.digits.short(bearing.outer_conformity),
    )
    materials = words.one_material if rings == balls else words.materials
    named = materials.format(rings=rings.name, balls=balls.name)
    return "\n".join((geometry, conformities, named, *arrangement_lines(page, bearing)))


def _play(page: Page, bearing: Bearing) -> str:
    """Return the contact angle or the clearance, whichever was given."""
    if bearing.contact_angle is not None:
        angle = page.quantity(bearing.contact_angle, "angle")
        return page.words.given_contact_angle.format(angle=angle)
    clearance = page.quantity(bearing.diametral_clearance or 0.0, "length")
    return page.words.given_clearance.format(clearance=clearance)


def _duty(page: Page, duty: Duty) -> str:
    words = page.words
    speeds = [
        template.format(speed=page.quantity(speed, "angular_speed"))
        for template, speed in (
            (words.inner_speed, duty.inner_speed),
            (words.outer_speed, duty.outer_speed),
        )
        if speed != 0.0
    ]
    return ", ".join(speeds or [words.at_rest]) + "".join(
        f", {item}" for item in _imposed(page, duty)
    )


def _imposed(page: Page, duty: Duty) -> list[str]:
    """Return loads and displacements that were given, as they were given."""
    given = []
    for axis, load in zip(AXES, LOADS, strict=True):
        shift = len(axis) == 1
        kinds: tuple[tuple[str, float | None, Dimension], ...] = (
            (load, getattr(duty.load, load), "force" if shift else "moment"),
            (axis, getattr(duty.displacement, axis), "length" if shift else "angle"),
        )
        given += [
            f"{name} {page.quantity(value, dimension)}"
            for name, value, dimension in kinds
            if value is not None
        ]
    return given


def _model(page: Page, case: Case) -> str:
    """Return the choices that matter: at rest, none does."""
    words, duty, model = page.words, case.duty, case.model
    if duty.inner_speed == 0.0 == duty.outer_speed:
        return ""
    left_out = [
        text
        for text, included in (
            (words.without_centrifugal_force, model.centrifugal_force),
            (words.without_gyroscopic_moment, model.gyroscopic_moment),
        )
        if not included
    ]
    # the default is not said, nor anything under friction control, where the cage is always rigid
    usual = model.cage == "loose" or model.raceway_control == "friction"
    cage = [] if usual else [words.cage[model.cage]]
    return ", ".join([words.raceway_control[model.raceway_control], *cage, *left_out])


def _status(page: Page, solved: Solved) -> list[tuple[str, str, str]]:
    """Return label, text and style of the status, and of the advice if there is any."""
    words, status = page.words, solved.status
    if solved.converged[0]:
        text = words.converged.format(
            iterations=int(status.iterations[0]),
            residual=page.digits.exponent(float(status.residual[0])),
        )
        return [(words.status, f"✓ {text}", "green")]
    reason = (words.status, f"✗ {words.reason(solved)}", "bold red")
    return [reason, (words.advice_label, words.advice(solved), "")]


def _set(page: Page, solved: Solved) -> list[Lines]:
    """Show the rows of a set and their preload; nothing of a plain bearing."""
    if not solved.case.bearing.is_set:
        return []
    preload = [] if solved.preload is None else [preload_part(page, solved, solved.preload)]
    return [rows_part(page, solved), *preload]


def _middle(page: Page, solved: Solved) -> list[Lines]:
    """Show the ring above the heaviest ball, and the rosettes beside them, or below in a line."""
    left = [*ring_part(page, solved), Text(), *heaviest_part(page, solved)]
    room, rows = page.medium.width - max(map(len, left)) - _GAP, len(solved.rows)
    if rows < 2 or rosettes_width(rows) <= room:
        return [beside(left, rosette_part(page, solved, room), gap=_GAP)]
    return [left, rosette_part(page, solved, page.medium.width)]


def _what_follows(page: Page, solved: Solved, analysis: Analysis, notes: list[str]) -> list[Lines]:
    """Show film, friction and life; what is to be known of them goes to the notes."""
    parts: list[Lines] = []
    if analysis.film is not None:
        from rolamento.report.film import film_notes, film_parts

        parts += film_parts(page, analysis.film)
        notes += film_notes(page, analysis.film)
    if analysis.friction is not None:
        from rolamento.report.friction import friction_parts

        parts += friction_parts(page, solved, analysis.friction)
    if analysis.life is not None:
        from rolamento.document import Document
        from rolamento.document.terminal import terminal
        from rolamento.pages.life import life_notes, life_section

        life = Document("", (life_section(solved, analysis.life),), language=page.words.code)
        text = terminal(life, page.medium)
        parts.append([Text.from_ansi(line) for line in text.splitlines()])
        notes += [page.words.note(note) for note in life_notes(analysis.life)]
    if analysis.notes:
        notes += [page.words.note(note) for note in analysis.notes]
    return parts
