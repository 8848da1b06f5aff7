"""The report of a solved state, for a terminal or as plain text."""

from __future__ import annotations

from io import StringIO

from rich.console import Console, Group, RenderableType
from rich.table import Table

from rolamento.bearing import Bearing
from rolamento.duty import AXES, LOADS, Duty
from rolamento.report.balls import ball_parts, heaviest_part, rosette_part
from rolamento.report.language import ENGLISH, Words
from rolamento.report.medium import Medium
from rolamento.report.page import Page
from rolamento.report.ring import ring_part, stiffness_part
from rolamento.state import State
from rolamento.units import Dimension, from_si

__all__ = ["terminal_report"]


def terminal_report(state: State, words: Words = ENGLISH, medium: Medium | None = None) -> str:
    """Return the report of a state as text that ends in a newline.

    Parameters
    ----------
    state
        Converged or not; without a result the report says why and what to do.
    words
        The language.
    medium
        What the text is shown on; by default plain text of 80 columns in UTF-8.
    """
    page = Page(words, medium or Medium())
    parts: list[RenderableType] = [_head(page, state)]
    if state.status.converged:
        parts += [_middle(page, state), stiffness_part(page, state), *ball_parts(page, state)]
    if state.notes:
        parts.append(_notes(page, state))
    return _rendered(page.medium, parts)


def _rendered(medium: Medium, parts: list[RenderableType]) -> str:
    """Return the parts one below the other, with an empty line between them."""
    console = Console(
        file=StringIO(),
        width=medium.width,
        color_system=medium.colors,
        force_terminal=medium.colors is not None,
        no_color=medium.colors is None,
        legacy_windows=False,
        highlight=False,
        markup=False,
        emoji=False,
    )
    with console.capture() as capture:
        for number, part in enumerate(parts):
            if number:
                console.print()
            console.print(part)
    return "\n".join(line.rstrip() for line in capture.get().split("\n"))


def _head(page: Page, state: State) -> RenderableType:
    """Show the title, what was given, and how the solution ended."""
    words, case = page.words, state.case
    grid = page.grid(gap=2)
    grid.add_column(no_wrap=True, style="dim")
    grid.add_column()
    grid.add_row(page.text(words.bearing), page.text(_bearing(page, case.bearing)))
    grid.add_row(page.text(words.duty), page.text(_duty(page, case.duty)))
    model = _model(page, state)
    if model:
        grid.add_row(page.text(words.model), page.text(model))
    _add_status(page, grid, state)
    title = page.text(state.title or words.untitled, "bold")
    rule = page.text(("─" if page.medium.shows("─") else "-") * page.medium.width, "dim")
    return Group(title, rule, grid)


def _bearing(page: Page, bearing: Bearing) -> str:
    words, rings, balls = page.words, bearing.ring_material, bearing.ball_material
    geometry = words.geometry.format(
        count=bearing.ball_count,
        ball=_quantity(page, bearing.ball_diameter, "length"),
        pitch=_quantity(page, bearing.pitch_diameter, "length"),
    )
    conformities = words.conformities.format(
        play=_play(page, bearing),
        inner=page.digits.short(bearing.inner_conformity),
        outer=page.digits.short(bearing.outer_conformity),
    )
    materials = words.one_material if rings == balls else words.materials
    return "\n".join((geometry, conformities, materials.format(rings=rings.name, balls=balls.name)))


def _play(page: Page, bearing: Bearing) -> str:
    """Return the contact angle or the clearance, whichever was given."""
    if bearing.contact_angle is not None:
        angle = _quantity(page, bearing.contact_angle, "angle")
        return page.words.given_contact_angle.format(angle=angle)
    clearance = _quantity(page, bearing.diametral_clearance or 0.0, "length")
    return page.words.given_clearance.format(clearance=clearance)


def _duty(page: Page, duty: Duty) -> str:
    words = page.words
    speeds = [
        template.format(speed=_quantity(page, speed, "angular_speed"))
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
            f"{name} {_quantity(page, value, dimension)}"
            for name, value, dimension in kinds
            if value is not None
        ]
    return given


def _model(page: Page, state: State) -> str:
    """Return the choices that matter: at rest, none does."""
    words, duty, model = page.words, state.case.duty, state.case.model
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
    return ", ".join([words.raceway_control[model.raceway_control], *left_out])


def _quantity(page: Page, value: float, dimension: Dimension) -> str:
    return page.digits.localised(from_si(value, dimension)).replace(" deg", "°")


def _middle(page: Page, state: State) -> RenderableType:
    """Show the ring above the heaviest ball, and the rosette beside them."""
    grid = page.grid(gap=3)
    grid.add_column(no_wrap=True)
    grid.add_column(no_wrap=True)
    left = Group(ring_part(page, state), "", heaviest_part(page, state))
    grid.add_row(left, rosette_part(page, state))
    return grid


def _add_status(page: Page, grid: Table, state: State) -> None:
    words, status = page.words, state.status
    if status.converged:
        text = words.converged.format(
            iterations=status.iterations, residual=page.digits.exponent(status.residual)
        )
        grid.add_row(page.text(words.status), page.text(f"✓ {text}", "green"))
        return
    grid.add_row(page.text(words.status), page.text(f"✗ {words.reason(status)}", "bold red"))
    advice = words.advice(status)
    if advice:
        grid.add_row(page.text(words.advice_label), page.text(advice))


def _notes(page: Page, state: State) -> RenderableType:
    grid = page.grid(gap=1)
    grid.add_column(no_wrap=True)
    grid.add_column()
    for note in state.notes:
        grid.add_row(page.text("  •", "yellow"), page.text(page.words.note(note)))
    return Group(page.heading(page.words.notes), grid)
