"""The balls in the report: tables, rosette, the stresses of the heaviest ball."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import degrees, isfinite, nan, pi
from typing import Final

from rich.console import Group, RenderableType
from rich.padding import Padding
from rich.text import Text

from rolamento.report.numbers import ABSENT, aligned
from rolamento.report.page import Page
from rolamento.report.rosette import rosette
from rolamento.state import BallState, ContactState, State

__all__ = ["ball_parts", "heaviest_part", "rosette_part"]

_RPM: Final = 30.0 / pi
_NO_SPIN: Final = 1e-9
_ROSETTE_HEIGHT: Final = 11
_LONGEST_BAR: Final = 20
_EIGHTHS: Final = " ▏▎▍▌▋▊▉"


@dataclass(frozen=True, slots=True)
class _Column:
    """One number of every ball: how it is called, read, written, and whether it peaks."""

    symbol: str
    unit: str
    of: Callable[[BallState], float]
    digits: int = 4
    most: int = 2
    peak: bool = False


def _inner(of: Callable[[ContactState], float]) -> Callable[[BallState], float]:
    return lambda ball: of(ball.inner) if ball.inner.load > 0.0 else nan


def _outer(of: Callable[[ContactState], float]) -> Callable[[BallState], float]:
    return lambda ball: of(ball.outer) if ball.outer.load > 0.0 else nan


def _spin(contact: ContactState) -> float:
    """Return the spin to roll ratio, and the rounding errors of a race in control as zero."""
    return contact.spin_to_roll if abs(contact.spin_to_roll) > _NO_SPIN else 0.0


_PLACE: Final = _Column("ψ", "°", lambda ball: degrees(ball.azimuth), digits=5)
_LOADS: Final = (
    _Column("Q_i", "N", _inner(lambda c: c.load), digits=5, peak=True),
    _Column("Q_o", "N", _outer(lambda c: c.load), digits=5, peak=True),
    _Column("α_i", "°", _inner(lambda c: degrees(c.contact_angle))),
    _Column("α_o", "°", _outer(lambda c: degrees(c.contact_angle))),
    _Column("p_i", "MPa", _inner(lambda c: 1e-6 * c.max_pressure), peak=True),
    _Column("p_o", "MPa", _outer(lambda c: 1e-6 * c.max_pressure), peak=True),
)
_MOTION: Final = (
    _Column("F_c", "N", lambda ball: ball.centrifugal_force, digits=5),
    _Column("M_g", "N·mm", lambda ball: 1e3 * ball.gyroscopic_moment),
    _Column("n_m", "rpm", lambda ball: _RPM * ball.orbital_speed, digits=5),
    _Column("n_R", "rpm", lambda ball: _RPM * ball.ball_speed, digits=5),
    _Column("s_i", "–", _inner(_spin), most=4),
    _Column("s_o", "–", _outer(_spin), most=4),
)


def ball_parts(page: Page, state: State) -> list[RenderableType]:
    """Show the balls in one wide table or in two narrow ones; at rest, loads only."""
    words, duty = page.words, state.case.duty
    loads = _BallTable(page, state, words.balls, (_PLACE, *_LOADS), (words.load_legend,))
    if duty.inner_speed == 0.0 == duty.outer_speed:
        return [loads.rendered(bars=True)]
    legends = (words.load_legend, words.motion_legend)
    merged = _BallTable(page, state, words.balls, (_PLACE, *_LOADS, *_MOTION), legends)
    if merged.width <= page.medium.width:
        return [merged.rendered()]
    motion = _BallTable(page, state, words.motion, (_PLACE, *_MOTION), (words.motion_legend,))
    return [loads.rendered(bars=True), motion.rendered()]


class _BallTable:
    """Some numbers of all balls, one line a ball, the greatest values marked."""

    _GAP: Final = 2

    def __init__(
        self,
        page: Page,
        state: State,
        heading: str,
        columns: Sequence[_Column],
        legends: Sequence[str],
    ) -> None:
        self._page, self._balls = page, state.balls
        self._heading, self._legends = heading, legends
        self._headers = [_header(page, column) for column in columns]
        self._cells = [_numbers(page, state.balls, column) for column in columns]

    @property
    def width(self) -> int:
        """How many characters the table takes."""
        texts = (
            [*header.split("\n"), *cells]
            for header, cells in zip(self._headers, self._cells, strict=True)
        )
        numbers = len(f"  {len(self._balls) - 1}")
        return numbers + sum(self._GAP + max(map(len, column)) for column in texts)

    def rendered(self, *, bars: bool = False) -> RenderableType:
        """Return the table between heading and legends; bars show the inner loads."""
        page, cells = self._page, list(self._cells)
        table = page.table()
        table.add_column(page.text("\n#", "dim"), justify="right", no_wrap=True)
        for header in self._headers:
            table.add_column(header, justify="right", no_wrap=True)
        if bars:
            table.add_column(page.text("Q_i"), no_wrap=True)
            room = page.medium.width - self.width - self._GAP
            cells.append(_bars(page, self._balls, min(room, _LONGEST_BAR)))
        for number, line in enumerate(zip(*cells, strict=True)):
            table.add_row(page.text(f"  {number}", "dim"), *line)
        legends = (Padding(page.text(text, "dim"), (0, 0, 0, 2)) for text in self._legends)
        return Group(page.heading(self._heading), table, *legends)


def _header(page: Page, column: _Column) -> Text:
    """Return symbol above unit, with room for the mark where there may be one."""
    room = " " if column.peak else ""
    symbol, unit = page.text(column.symbol + room), page.text(column.unit + room, "dim")
    return Text.assemble(symbol, "\n", unit)


def _numbers(page: Page, balls: Sequence[BallState], column: _Column) -> list[Text]:
    values = [column.of(ball) for ball in balls]
    texts = page.digits.column(values, column.digits, column.most)
    texts = [_centred_dash(text, texts) for text in texts]
    if not column.peak:
        return [page.text(text, "dim" if text.startswith(ABSENT) else "") for text in texts]
    top = max((abs(value) for value in values if isfinite(value)), default=nan)
    return [_marked(page, text, value == top) for text, value in zip(texts, values, strict=True)]


def _centred_dash(text: str, texts: Sequence[str]) -> str:
    """Put a dash below the last digit before the decimal mark, as far as that is known."""
    if text != ABSENT:
        return text
    longest = max(texts, key=len)
    tail = len(longest) - max(longest.find("."), longest.find(","))
    return text + " " * (tail if tail <= len(longest) else 0)


def _marked(page: Page, text: str, top: bool) -> Text:
    style = "dim" if text.startswith(ABSENT) else "bold yellow" if top else ""
    return page.text(text + ("◂" if top else " "), style)


def _bars(page: Page, balls: Sequence[BallState], longest: int) -> list[Text]:
    """Draw the inner load of every ball as a bar."""
    greatest = max(ball.inner.load for ball in balls)
    parts = (ball.inner.load / greatest if greatest > 0.0 else 0.0 for ball in balls)
    return [_bar(page, part * max(longest, 0)) for part in parts]


def _bar(page: Page, length: float) -> Text:
    if not page.medium.draws:
        return Text("#" * round(length))
    eighths = round(8 * length)
    return Text("█" * (eighths // 8) + _EIGHTHS[eighths % 8].strip(), "cyan")


def heaviest(state: State) -> tuple[int, BallState]:
    """Return number and state of the ball with the greatest load at either race."""
    return max(enumerate(state.balls), key=lambda item: max(item[1].inner.load, item[1].outer.load))


_STRESSES: Final[tuple[tuple[str, str, Callable[[ContactState], float]], ...]] = (
    ("contact_load", "N", lambda c: c.load),
    ("contact_angle", "°", lambda c: degrees(c.contact_angle)),
    ("approach", "µm", lambda c: 1e6 * c.deflection),
    ("max_pressure", "MPa", lambda c: 1e-6 * c.max_pressure),
    ("semi_major", "mm", lambda c: 1e3 * c.semi_major),
    ("semi_minor", "mm", lambda c: 1e3 * c.semi_minor),
    ("max_shear", "MPa", lambda c: 1e-6 * c.max_shear),
    ("at_depth", "mm", lambda c: 1e3 * c.max_shear_depth),
    ("orthogonal_shear", "MPa", lambda c: 1e-6 * c.orthogonal_shear),
    ("at_depth", "mm", lambda c: 1e3 * c.orthogonal_shear_depth),
)


def heaviest_part(page: Page, state: State) -> RenderableType:
    """Show the contacts of the heaviest ball and the stresses under them."""
    words = page.words
    number, ball = heaviest(state)
    contacts = (ball.inner, ball.outer)
    columns = [_stresses(page, contact) for contact in contacts]
    grid = page.grid(gap=1)
    for justify in ("left", "left", "right", "right"):
        grid.add_column(justify=justify, no_wrap=True)
    grid.add_row("", "", page.text(words.inner, "dim"), page.text(words.outer, "dim"))
    for (name, unit, _), inner, outer in zip(_STRESSES, *columns, strict=True):
        grid.add_row(
            page.text(f"  {getattr(words, name)}"),
            page.text(unit),
            page.text(inner),
            page.text(outer),
        )
    place = page.digits.short(degrees(ball.azimuth))
    return Group(page.heading(words.heaviest.format(number=number, azimuth=place)), grid)


def _stresses(page: Page, contact: ContactState) -> list[str]:
    if not contact.load > 0.0:
        return [ABSENT] * len(_STRESSES)
    cells = [page.digits.column([of(contact)])[0] for _, _, of in _STRESSES]
    return [f"  {cell}" for cell in aligned(cells, page.words.decimal_mark)]


def rosette_part(page: Page, state: State) -> RenderableType:
    """Draw the inner loads round the bearing, with the axes and the scale."""
    _, ball = heaviest(state)
    row = [other for other in state.balls if other.row == ball.row]
    loads, azimuths = [b.inner.load for b in row], [b.azimuth for b in row]
    drawn = rosette(loads, azimuths, _ROSETTE_HEIGHT, braille=page.medium.draws)
    lines = [Text("+z".center(2 * _ROSETTE_HEIGHT))]
    for number, line in enumerate(drawn):
        cells = Text.assemble(*((c.character, "cyan" if c.loaded else "dim") for c in line))
        lines.append(cells + Text(" +y" if number == _ROSETTE_HEIGHT // 2 else ""))
    greatest = max(loads)
    scale = page.digits.column([greatest])[0] if greatest > 0.0 else ABSENT
    width = 2 * _ROSETTE_HEIGHT
    for caption in (page.words.rim.format(load=scale), page.words.seen_from):
        lines.append(page.text(caption.center(width), "dim"))
    return Group(page.heading(page.words.rosette), *lines)
