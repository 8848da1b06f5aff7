"""The balls in the report: tables, rosette, the stresses of the heaviest ball."""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from io import StringIO
from itertools import chain
from math import ceil, cos, degrees, isfinite, nan, pi, sin
from typing import Final, NamedTuple

from rich.text import Text

from rolamento.report.numbers import ABSENT, aligned
from rolamento.report.page import Lines, Page, beside
from rolamento.report.plain_data import csv_number
from rolamento.state import BallState, ContactState, RollingBall, RollingState, State

_BRAILLE: Final = 0x2800
_BITS: Final = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
"""Bit of the dot in a row and column of a braille character."""


class Cell(NamedTuple):
    """One character of the drawing, and whether a load (or only the rim) is in it."""

    character: str
    loaded: bool


def rosette(
    loads: Sequence[float],
    azimuths: Sequence[float],
    height: int,
    *,
    rim: float | None = None,
    braille: bool = True,
) -> list[list[Cell]]:
    """Draw a spoke for each ball, as long as its load, within a rim.

    Parameters
    ----------
    loads
        Of the balls; what is not a number or not above zero is left out.
    azimuths
        Of the balls, in rad.
    height
        In lines; the drawing is twice as many characters wide.
    rim
        The load at the rim; the greatest of the loads if not given.
    braille
        Draw with braille dots, two by four to a character; otherwise with ASCII.
    """
    canvas = _Canvas(height, braille=braille)
    for step in range(16 * height):
        canvas.dot(1.0, 2.0 * pi * step / (16 * height), loaded=False)
    greatest = rim or max((load for load in loads if load > 0.0), default=0.0)
    for load, azimuth in zip(loads, azimuths, strict=True):
        if load > 0.0:
            canvas.spoke(load / greatest, azimuth)
    return list(canvas.lines())


class _Canvas:
    """Dots on a grid of characters, addressed by radius (1 at the rim) and azimuth."""

    def __init__(self, height: int, *, braille: bool) -> None:
        self._height, self._width = height, 2 * height
        self._braille = braille
        self._across, self._down = (2, 4) if braille else (1, 1)
        self._rim: set[tuple[int, int]] = set()
        self._loads: set[tuple[int, int]] = set()

    def dot(self, radius: float, azimuth: float, *, loaded: bool) -> None:
        columns, rows = self._width * self._across, self._height * self._down
        column = round((columns - 1) / 2 * (1.0 + radius * sin(azimuth)))
        row = round((rows - 1) / 2 * (1.0 - radius * cos(azimuth)))
        (self._loads if loaded else self._rim).add((row, column))

    def spoke(self, length: float, azimuth: float) -> None:
        steps = self._width * self._across
        for step in range(round(length * steps) + 1):
            self.dot(step / steps, azimuth, loaded=True)

    def lines(self) -> Iterator[list[Cell]]:
        for row in range(self._height):
            yield [self._cell(row, column) for column in range(self._width)]

    def _cell(self, row: int, column: int) -> Cell:
        if not self._braille:
            loaded = (row, column) in self._loads
            return Cell("o" if loaded else "." if (row, column) in self._rim else " ", loaded)
        bits, loaded = 0, False
        for down in range(self._down):
            for across in range(self._across):
                place = (self._down * row + down, self._across * column + across)
                loaded = loaded or place in self._loads
                if place in self._loads or place in self._rim:
                    bits |= _BITS[down][across]
        return Cell(chr(_BRAILLE + bits) if bits else " ", loaded)


_RPM: Final = 30.0 / pi
_NO_SPIN: Final = 1e-9
_NO_LOAD: Final = 1e-9
"""Of the load at the other race: what is less is rounding, and no contact."""
_ROSETTE_HEIGHT: Final = 11
_ROSETTE_GAP: Final = 2
_SIDE: Final = " +y"
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
    return lambda ball: of(ball.inner) if ball.inner.load > _NO_LOAD * ball.outer.load else nan


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


def ball_parts(page: Page, state: State) -> list[Lines]:
    """Show the balls in one wide table or in two narrow ones; at rest, loads only."""
    words, duty = page.words, state.case.duty
    loads = _BallTable(page, state, words.balls, (_PLACE, *_LOADS), (words.load_legend,))
    if duty.inner_speed == 0.0 == duty.outer_speed:
        return [loads.lines(bars=True)]
    legends = (words.load_legend, words.motion_legend)
    merged = _BallTable(page, state, words.balls, (_PLACE, *_LOADS, *_MOTION), legends)
    if merged.width <= page.medium.width:
        return [merged.lines()]
    motion = _BallTable(page, state, words.motion, (_PLACE, *_MOTION), (words.motion_legend,))
    return [loads.lines(bars=True), motion.lines()]


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
        self._page, self._balls, self._state = page, state.balls, state
        self._heading, self._legends = heading, legends
        self._columns = [self._numbers(), *(_column(page, state.balls, c) for c in columns)]

    def _numbers(self) -> Lines:
        return [Text(), Text("#"), *(Text(str(j), "dim") for j in range(len(self._balls)))]

    @property
    def width(self) -> int:
        """How many characters the table takes."""
        return sum(self._GAP + max(map(len, column)) for column in self._columns)

    def lines(self, *, bars: bool = False) -> Lines:
        """Return the table between heading and legends; bars show the inner loads."""
        page, columns = self._page, list(self._columns)
        if bars:
            room = page.medium.width - self.width - self._GAP
            columns.append([Text(), Text("Q_i"), *_bars(page, self._balls, room)])
        rows = list(zip(*columns, strict=True))
        table = page.columns(rows, "r" * len(self._columns) + "l" * bars, self._GAP)
        table = self._by_row(table, page.rule(max(map(len, table))))
        legends = [page.hanging(Text("  "), text, "dim") for text in self._legends]
        return [page.heading(self._heading), *table, *chain(*legends)]

    def _by_row(self, table: Lines, rule: Text) -> Lines:
        """Put a rule below the header, and above the balls of each row of a set its name."""
        page, state = self._page, self._state
        lines, balls = [*table[:2], rule], table[2:]
        if len(state.rows) < 2:
            return lines + balls
        for row in state.rows:
            lines.append(page.text("  " + page.words.row.format(number=row.row), "cyan"))
            lines += (
                line for line, ball in zip(balls, self._balls, strict=True) if ball.row == row.row
            )
        return lines


def _column(page: Page, balls: Sequence[BallState], column: _Column) -> Lines:
    """Return symbol, unit and numbers, with room for the mark where there may be one."""
    room = " " if column.peak else ""
    header = [page.text(column.symbol + room), page.text(column.unit + room, "dim")]
    return header + _numbers(page, balls, column)


def _numbers(page: Page, balls: Sequence[BallState], column: _Column) -> Lines:
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
    style = "dim" if text.startswith(ABSENT) else "bold magenta" if top else ""
    return page.text(text + ("◂" if top else " "), style)


def _bars(page: Page, balls: Sequence[BallState], room: int) -> Lines:
    """Draw the inner load of every ball as a bar."""
    longest = min(max(room, 0), _LONGEST_BAR)
    greatest = max(ball.inner.load for ball in balls)
    parts = (ball.inner.load / greatest if greatest > 0.0 else 0.0 for ball in balls)
    return [_bar(page, part * longest) for part in parts]


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


def heaviest_part(page: Page, state: State) -> Lines:
    """Show the contacts of the heaviest ball and the stresses under them."""
    words = page.words
    number, ball = heaviest(state)
    contacts = (ball.inner, ball.outer)
    columns = [_stresses(page, contact) for contact in contacts]
    rows = [[Text(), Text(), page.text(words.inner, "dim"), page.text(words.outer, "dim")]]
    for (name, unit, _), *cells in zip(_STRESSES, *columns, strict=True):
        label = page.text(getattr(words, name))
        rows.append([label, page.text(unit), *map(page.text, cells)])
    place = page.digits.short(degrees(ball.azimuth))
    template = words.heaviest if len(state.rows) < 2 else words.heaviest_in_row
    heading = page.heading(template.format(number=number, azimuth=place, row=ball.row))
    return [heading, *page.columns(rows, "llrr", gap=1)]


def _stresses(page: Page, contact: ContactState) -> list[str]:
    if not contact.load > 0.0:
        return [ABSENT] * len(_STRESSES)
    cells = [page.digits.column([of(contact)])[0] for _, _, of in _STRESSES]
    return [f"  {cell}" for cell in aligned(cells, page.words.decimal_mark)]


def rosettes_width(rows: int) -> int:
    """Return how many characters so many rosettes take side by side."""
    return rows * (2 * _ROSETTE_HEIGHT + len(_SIDE)) + (rows - 1) * _ROSETTE_GAP


def rosette_part(page: Page, state: State, room: int) -> Lines:
    """Draw the inner loads round the bearing, with the axes and the scale: one rosette a row.

    As many stand side by side as there is room for; all have the same scale.
    """
    words, count = page.words, len(state.rows)
    rim = max(ball.inner.load for ball in state.balls)
    drawn = [_rosette(page, state, row.row, rim) for row in state.rows]
    most = next((n for n in range(count, 1, -1) if rosettes_width(n) <= room), 1)
    abreast = ceil(count / ceil(count / most))  # four as two and two, not three and one
    lines = [page.heading(words.rosette if count == 1 else words.rosettes)]
    for first in range(0, count, abreast):
        line = drawn[first]
        for other in drawn[first + 1 : first + abreast]:
            line = beside(line, other, _ROSETTE_GAP)
        lines += line
    scale = page.digits.column([rim])[0] if rim > 0.0 else ABSENT
    captions = [words.rim.format(load=scale), words.seen_from]
    width = 2 * _ROSETTE_HEIGHT
    if count > 1:
        return [*lines, page.text(f"  {', '.join(captions)}", "dim")]
    return [*lines, *(page.text(caption.center(width), "dim") for caption in captions)]


def _rosette(page: Page, state: State, row: int, rim: float) -> Lines:
    """Draw one row, as wide as every other."""
    balls = [ball for ball in state.balls if ball.row == row]
    loads, azimuths = [b.inner.load for b in balls], [b.azimuth for b in balls]
    drawn = rosette(loads, azimuths, _ROSETTE_HEIGHT, rim=rim, braille=page.medium.draws)
    width = 2 * _ROSETTE_HEIGHT
    lines = [Text("+z".center(width))]
    if len(state.rows) > 1:
        lines.insert(0, page.text(page.words.row.format(number=row).center(width)))
    for number, cells in enumerate(drawn):
        line = Text.assemble(*((c.character, "cyan" if c.loaded else "dim") for c in cells))
        lines.append(line.append(_SIDE if number == _ROSETTE_HEIGHT // 2 else ""))
    return lines


"""Of the load at the other race: what is less is rounding, and no contact."""
_NO_MOTION: Final = 1e-9
"""Angles (rad) and ratios that are rounding."""


@dataclass(frozen=True, slots=True)
class _RollingWords:
    heading: str
    cage: str
    behind: str
    ahead: str
    torque: str
    torques: str
    power: str
    powers: str
    drag: str
    legend: str


_ROLLING_WORDS: Final[Mapping[str, _RollingWords]] = {
    "en": _RollingWords(
        heading="Motion under friction",
        cage="cage",
        behind="{speed} rpm, {skid} % behind the {usual} rpm of outer raceway control",
        ahead="{speed} rpm, {skid} % ahead of the {usual} rpm of outer raceway control",
        torque="torque",
        torques="{inner} N·mm on the shaft, {outer} N·mm on the housing",
        power="losses",
        powers="{total} W in the contacts: {inner} W inner, {outer} W outer",
        drag="; {drag} W against the cage's drag",
        legend=(
            "β, β′ angles of the ball's axis to the shaft, in its axial plane and out of it; s "
            "spin/roll, P power lost, v slip at the contact's centre along the orbit"
        ),
    ),
    "pt": _RollingWords(
        heading="Movimento sob atrito",
        cage="gaiola",
        behind="{speed} rpm, {skid} % atrás dos {usual} rpm do controle pela pista externa",
        ahead="{speed} rpm, {skid} % à frente dos {usual} rpm do controle pela pista externa",
        torque="torque",
        torques="{inner} N·mm no eixo, {outer} N·mm no alojamento",
        power="perdas",
        powers="{total} W nos contatos: {inner} W na pista interna, {outer} W na externa",
        drag="; {drag} W contra o arrasto da gaiola",
        legend=(
            "β, β′ ângulos do eixo da esfera com o eixo do rolamento, no plano axial e fora dele; "
            "s spin/rolamento, P potência perdida, v escorregamento no centro do contato, no "
            "sentido da órbita"
        ),
    ),
}


@dataclass(frozen=True, slots=True)
class _RollingColumn:
    """One number of every ball."""

    symbol: str
    unit: str
    of: Callable[[BallState, RollingBall], float]
    digits: int = 3
    most: int = 3


def _rolling_spin(contact: ContactState, other: ContactState) -> float:
    """Spin to roll, if the race touches the ball; rounding as zero."""
    touched = contact.load > _NO_LOAD * other.load
    return _without_rounding(contact.spin_to_roll) if touched else nan


def _without_rounding(value: float) -> float:
    return 0.0 if abs(value) < _NO_MOTION else value


_ROLLING_COLUMNS: Final = (
    _RollingColumn("ψ", "°", lambda ball, _: degrees(ball.azimuth), digits=5, most=2),
    _RollingColumn(
        "β", "°", lambda ball, _: degrees(_without_rounding(ball.attitude)), digits=4, most=2
    ),
    _RollingColumn("β′", "°", lambda _, own: degrees(_without_rounding(own.yaw))),
    _RollingColumn("s_i", "–", lambda ball, _: _rolling_spin(ball.inner, ball.outer)),
    _RollingColumn("s_o", "–", lambda ball, _: _rolling_spin(ball.outer, ball.inner)),
    _RollingColumn("P_i", "W", lambda _, own: own.inner.power, digits=4),
    _RollingColumn("P_o", "W", lambda _, own: own.outer.power, digits=4),
    _RollingColumn("v_i", "mm/s", lambda _, own: 1e3 * own.inner.slip, digits=4, most=2),
    _RollingColumn("v_o", "mm/s", lambda _, own: 1e3 * own.outer.slip, digits=4, most=2),
)


def rolling_part(page: Page, state: State) -> Lines:
    """Show how friction moves cage and balls, and what it costs; nothing under raceway control."""
    if state.rolling is None:
        return []
    said = _ROLLING_WORDS.get(page.words.code, _ROLLING_WORDS["en"])
    entries = [
        (said.cage, _cage(page, said, state.rolling), ""),
        (said.torque, _torques(page, said, state.rolling), ""),
        (said.power, _powers(page, said, state), ""),
    ]
    lines = [page.heading(said.heading), *page.labelled(entries, indent="  ")]
    return [
        *lines,
        Text(),
        *_rolling_table(page, state, state.rolling),
        *_rolling_legend(page, said),
    ]


def _cage(page: Page, said: _RollingWords, rolling: RollingState) -> str:
    template = said.behind if rolling.skid >= 0.0 else said.ahead
    return template.format(
        speed=page.digits.short(_RPM * rolling.cage_speed),
        skid=page.digits.short(100.0 * abs(rolling.skid), digits=3),
        usual=page.digits.short(_RPM * rolling.control_cage_speed),
    )


def _torques(page: Page, said: _RollingWords, rolling: RollingState) -> str:
    inner, outer = (
        page.digits.short(1e3 * value, digits=4)
        for value in (rolling.inner_torque, rolling.outer_torque)
    )
    return said.torques.format(inner=inner, outer=outer)


def _powers(page: Page, said: _RollingWords, state: State) -> str:
    rolling, drag = state.rolling, state.case.model.cage_drag
    if rolling is None:
        return ""
    inner = sum(ball.inner.power for ball in rolling.balls)
    outer = sum(ball.outer.power for ball in rolling.balls)
    total, *parts = (page.digits.short(v, digits=4) for v in (rolling.power, inner, outer))
    text = said.powers.format(total=total, inner=parts[0], outer=parts[1])
    if drag:
        own = page.digits.short(drag * abs(rolling.cage_speed), digits=4)
        text += said.drag.format(drag=own)
    return text


def _rolling_table(page: Page, state: State, rolling: RollingState) -> Lines:
    pairs = list(zip(state.balls, rolling.balls, strict=True))
    numbers = [Text(), Text("#"), *(Text(str(j), "dim") for j in range(len(pairs)))]
    columns = [numbers]
    for column in _ROLLING_COLUMNS:
        values = [column.of(*pair) for pair in pairs]
        texts = page.digits.column(values, column.digits, column.most)
        header = [page.text(column.symbol), page.text(column.unit, "dim")]
        columns.append(header + [page.text(text) for text in texts])
    table = page.columns(list(zip(*columns, strict=True)), "r" * len(columns))
    return [*table[:2], page.rule(max(map(len, table))), *table[2:]]


def _rolling_legend(page: Page, said: _RollingWords) -> Lines:
    return page.hanging(Text("  "), said.legend, "dim")


_CSV_BALL: Final[dict[str, Callable[[BallState], float]]] = {
    "azimuth_deg": lambda ball: degrees(ball.azimuth),
}
_CSV_CONTACT: Final[dict[str, Callable[[ContactState], float]]] = {
    "load_N": lambda contact: contact.load,
    "contact_angle_deg": lambda contact: degrees(contact.contact_angle),
    "deflection_um": lambda contact: 1e6 * contact.deflection,
    "semi_major_mm": lambda contact: 1e3 * contact.semi_major,
    "semi_minor_mm": lambda contact: 1e3 * contact.semi_minor,
    "max_pressure_MPa": lambda contact: 1e-6 * contact.max_pressure,
    "mean_pressure_MPa": lambda contact: 1e-6 * contact.mean_pressure,
    "max_shear_MPa": lambda contact: 1e-6 * contact.max_shear,
    "max_shear_depth_mm": lambda contact: 1e3 * contact.max_shear_depth,
    "orthogonal_shear_MPa": lambda contact: 1e-6 * contact.orthogonal_shear,
    "orthogonal_shear_depth_mm": lambda contact: 1e3 * contact.orthogonal_shear_depth,
    "spin_to_roll": lambda contact: contact.spin_to_roll,
}
_CSV_MOTION: Final[dict[str, Callable[[BallState], float]]] = {
    "centrifugal_force_N": lambda ball: ball.centrifugal_force,
    "gyroscopic_moment_Nmm": lambda ball: 1e3 * ball.gyroscopic_moment,
    "orbital_speed_rpm": lambda ball: _RPM * ball.orbital_speed,
    "ball_speed_rpm": lambda ball: _RPM * ball.ball_speed,
    "attitude_deg": lambda ball: degrees(ball.attitude),
}

CSV_COLUMNS: Final = (
    "row",
    "ball",
    *_CSV_BALL,
    *(f"{race}_{name}" for race in ("inner", "outer") for name in _CSV_CONTACT),
    *_CSV_MOTION,
    "raceway_control",
)
"""The header: what each column holds, and its unit."""


def ball_csv(state: State) -> str:
    """Return the balls of a state, one a line below a header, lines ending in CR LF."""
    text = StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(CSV_COLUMNS)
    writer.writerows(_csv_line(number, ball) for number, ball in enumerate(state.balls))
    return text.getvalue()


def _csv_line(number: int, ball: BallState) -> list[object]:
    numbers = [csv_number(value) for value in _csv_numbers(ball)]
    return [ball.row, number, *numbers, ball.raceway_control]


def _csv_numbers(ball: BallState) -> Iterator[float]:
    yield from (of(ball) for of in _CSV_BALL.values())
    for contact in (ball.inner, ball.outer):
        yield from (of(contact) for of in _CSV_CONTACT.values())
    yield from (of(ball) for of in _CSV_MOTION.values())
