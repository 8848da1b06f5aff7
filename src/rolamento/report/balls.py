"""The balls in the report: tables, rosette, the stresses of the heaviest ball, their motion; CSV.

The rosette is a small polar drawing of the ball loads. The bearing is seen from the +x end, so
that x points at the reader: +z is up, +y is to the right, and azimuths run clockwise like the
hours.
"""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from io import StringIO
from itertools import chain
from math import ceil, cos, degrees, isfinite, nan, pi, sin
from typing import Final, NamedTuple

import numpy as np
from rich.text import Text

from rolamento.geometry import Race
from rolamento.numerics import BoolArray, FloatArray
from rolamento.report.numbers import ABSENT, aligned
from rolamento.report.page import Lines, Page, beside
from rolamento.report.plain_data import csv_number
from rolamento.solved import NO_LOAD, RACES, Rolling, Solved
from rolamento.solved.form import control_names

_RPM: Final = 30.0 / pi
_DEGREE: Final = 180.0 / pi
_NO_MOTION: Final = 1e-9
"""Angles (rad) and ratios that are rounding."""
_ROSETTE_HEIGHT: Final = 11
_ROSETTE_GAP: Final = 2
_SIDE: Final = " +y"
_LONGEST_BAR: Final = 20
_EIGHTHS: Final = " ▏▎▍▌▋▊▉"

Values = Callable[[Solved], FloatArray]
"""A number of every ball of a single case; (balls,), in the unit that is shown."""


def _of_ball(name: str, factor: float = 1.0) -> Values:
    return lambda solved: factor * getattr(solved.elements, name)[0]


def _of_contact(race: Race, name: str, factor: float = 1.0) -> Values:
    """Numbers of the contacts with a race; NaN where ball and race do not touch."""

    def values(solved: Solved) -> FloatArray:
        touched = solved.loaded[0] if race == "inner" else solved.outer.load[0] > 0.0
        numbers = factor * getattr(solved.contacts[race], name)[0]
        return np.where(touched, numbers, np.nan)

    return values


def _without_rounding(of: Values, least: float = _NO_MOTION) -> Values:
    """Give rounding errors, such as the spin at a race in control, as zero."""

    def values(solved: Solved) -> FloatArray:
        numbers = of(solved)
        return np.where(np.abs(numbers) < least, 0.0, numbers)

    return values


@dataclass(frozen=True, slots=True)
class _Column:
    """One number of every ball: how it is called, read, written, and whether it peaks."""

    symbol: str
    unit: str
    of: Values
    digits: int = 4
    most: int = 2
    peak: bool = False


_PLACE: Final = _Column("ψ", "°", _of_ball("azimuth", _DEGREE), digits=5)
_LOADS: Final = (
    _Column("Q_i", "N", _of_contact("inner", "load"), digits=5, peak=True),
    _Column("Q_o", "N", _of_contact("outer", "load"), digits=5, peak=True),
    _Column("α_i", "°", _of_contact("inner", "contact_angle", _DEGREE)),
    _Column("α_o", "°", _of_contact("outer", "contact_angle", _DEGREE)),
    _Column("p_i", "MPa", _of_contact("inner", "max_pressure", 1e-6), peak=True),
    _Column("p_o", "MPa", _of_contact("outer", "max_pressure", 1e-6), peak=True),
)
_MOTION: Final = (
    _Column("F_c", "N", _of_ball("centrifugal_force"), digits=5),
    _Column("M_g", "N·mm", _of_ball("gyroscopic_moment", 1e3)),
    _Column("n_m", "rpm", _of_ball("orbital_speed", _RPM), digits=5),
    _Column("n_R", "rpm", _of_ball("ball_speed", _RPM), digits=5),
    _Column("s_i", "–", _without_rounding(_of_contact("inner", "spin_to_roll")), most=4),
    _Column("s_o", "–", _without_rounding(_of_contact("outer", "spin_to_roll")), most=4),
)


def ball_parts(page: Page, solved: Solved) -> list[Lines]:
    """Show the balls in one wide table or in two narrow ones; at rest, loads only."""
    words, duty = page.words, solved.case.duty
    loads = _BallTable(page, solved, words.balls, (_PLACE, *_LOADS), (words.load_legend,))
    if duty.inner_speed == 0.0 == duty.outer_speed:
        return [loads.lines(bars=True)]
    legends = (words.load_legend, words.motion_legend)
    merged = _BallTable(page, solved, words.balls, (_PLACE, *_LOADS, *_MOTION), legends)
    if merged.width <= page.medium.width:
        return [merged.lines()]
    motion = _BallTable(page, solved, words.motion, (_PLACE, *_MOTION), (words.motion_legend,))
    return [loads.lines(bars=True), motion.lines()]


class _BallTable:
    """Some numbers of all balls, one line a ball, the maxima marked."""

    _GAP: Final = 2

    def __init__(
        self,
        page: Page,
        solved: Solved,
        heading: str,
        columns: Sequence[_Column],
        legends: Sequence[str],
    ) -> None:
        self._page, self._solved = page, solved
        self._heading, self._legends = heading, legends
        self._columns = [_ball_numbers(solved), *(_column(page, solved, c) for c in columns)]

    @property
    def width(self) -> int:
        """How many characters the table takes."""
        return sum(self._GAP + max(map(len, column)) for column in self._columns)

    def lines(self, *, bars: bool = False) -> Lines:
        """Return the table between heading and legends; bars show the inner loads."""
        page, columns = self._page, list(self._columns)
        if bars:
            room = page.medium.width - self.width - self._GAP
            columns.append([Text(), Text("Q_i"), *_bars(page, self._solved.inner.load[0], room)])
        rows = list(zip(*columns, strict=True))
        table = page.columns(rows, "r" * len(self._columns) + "l" * bars, self._GAP)
        table = self._by_row(table, page.rule(max(map(len, table))))
        legends = [page.hanging(Text("  "), text, "dim") for text in self._legends]
        return [page.heading(self._heading), *table, *chain(*legends)]

    def _by_row(self, table: Lines, rule: Text) -> Lines:
        """Put a rule below the header, and above the balls of each row of a set its name."""
        page, rows = self._page, self._solved.rows
        lines, balls = [*table[:2], rule], table[2:]
        if len(rows) < 2:
            return lines + balls
        for row, (first, count) in enumerate(zip(rows.starts, rows.element_count, strict=True)):
            lines.append(page.text("  " + page.words.row.format(number=row), "cyan"))
            lines += balls[first : first + count]
        return lines


def _ball_numbers(solved: Solved) -> Lines:
    return [Text(), Text("#"), *(Text(str(j), "dim") for j in range(len(solved.elements.row)))]


def _column(page: Page, solved: Solved, column: _Column) -> Lines:
    """Return symbol, unit and numbers, with room for the mark where there may be one."""
    room = " " if column.peak else ""
    values = column.of(solved).tolist()
    texts = page.digits.column(values, column.digits, column.most)
    texts = [_centred_dash(text, texts) for text in texts]
    top = max((abs(value) for value in values if isfinite(value)), default=nan)
    header = [page.text(column.symbol + room), page.text(column.unit + room, "dim")]
    if not column.peak:
        return header + [page.text(t, "dim" if t.startswith(ABSENT) else "") for t in texts]
    pairs = zip(texts, values, strict=True)
    return header + [_marked(page, text, value == top) for text, value in pairs]


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


def _bars(page: Page, loads: FloatArray, room: int) -> Lines:
    """Draw the inner load of every ball as a bar."""
    longest = min(max(room, 0), _LONGEST_BAR)
    largest = float(loads.max())
    return [_bar(page, load / largest * longest if largest > 0.0 else 0.0) for load in loads]


def _bar(page: Page, length: float) -> Text:
    if not page.medium.draws:
        return Text("#" * round(length))
    eighths = round(8 * length)
    return Text("█" * (eighths // 8) + _EIGHTHS[eighths % 8].strip(), "cyan")


_STRESSES: Final = (
    ("contact_load", "N", "load", 1.0),
    ("contact_angle", "°", "contact_angle", _DEGREE),
    ("approach", "µm", "deflection", 1e6),
    ("max_pressure", "MPa", "max_pressure", 1e-6),
    ("semi_major", "mm", "semi_major", 1e3),
    ("semi_minor", "mm", "semi_minor", 1e3),
    ("max_shear", "MPa", "max_shear", 1e-6),
    ("at_depth", "mm", "max_shear_depth", 1e3),
    ("orthogonal_shear", "MPa", "orthogonal_shear", 1e-6),
    ("at_depth", "mm", "orthogonal_shear_depth", 1e3),
)
"""Word, unit, name of the contact's column, factor to the unit."""


def heaviest_part(page: Page, solved: Solved) -> Lines:
    """Show the contacts of the ball with the maximum load and the stresses under them."""
    words = page.words
    ball = int(np.argmax(np.maximum(solved.inner.load[0], solved.outer.load[0])))
    columns = [_stresses(page, solved, race, ball) for race in RACES]
    rows = [[Text(), Text(), page.text(words.inner, "dim"), page.text(words.outer, "dim")]]
    for (name, unit, _, _), *cells in zip(_STRESSES, *columns, strict=True):
        label = page.text(getattr(words, name))
        rows.append([label, page.text(unit), *map(page.text, cells)])
    place = page.digits.short(degrees(solved.elements.azimuth[0, ball]))
    template = words.heaviest if len(solved.rows) < 2 else words.heaviest_in_row
    row = solved.elements.row[ball]
    heading = page.heading(template.format(number=ball, azimuth=place, row=row))
    return [heading, *page.columns(rows, "llrr", gap=1)]


def _stresses(page: Page, solved: Solved, race: Race, ball: int) -> list[str]:
    contacts = solved.contacts[race]
    if not contacts.load[0, ball] > 0.0:
        return [ABSENT] * len(_STRESSES)
    values = [factor * float(getattr(contacts, name)[0, ball]) for *_, name, factor in _STRESSES]
    cells = [page.digits.column([value])[0] for value in values]
    return [f"  {cell}" for cell in aligned(cells, page.words.decimal_mark)]


# --- the rosette ------------------------------------------------------------------------------

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
        The load at the rim; the maximum of the loads if not given.
    braille
        Draw with braille dots, two by four to a character; otherwise with ASCII.
    """
    canvas = _Canvas(height, braille=braille)
    for step in range(16 * height):
        canvas.dot(1.0, 2.0 * pi * step / (16 * height), loaded=False)
    largest = rim or max((load for load in loads if load > 0.0), default=0.0)
    for load, azimuth in zip(loads, azimuths, strict=True):
        if load > 0.0:
            canvas.spoke(load / largest, azimuth)
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


def rosettes_width(rows: int) -> int:
    """Return how many characters so many rosettes take side by side."""
    return rows * (2 * _ROSETTE_HEIGHT + len(_SIDE)) + (rows - 1) * _ROSETTE_GAP


def rosette_part(page: Page, solved: Solved, room: int) -> Lines:
    """Draw the inner loads round the bearing, with the axes and the scale: one rosette a row.

    As many stand side by side as there is room for; all have the same scale.
    """
    words, count = page.words, len(solved.rows)
    rim = float(solved.inner.load[0].max())
    drawn = [_rosette(page, solved, row, rim) for row in range(count)]
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


def _rosette(page: Page, solved: Solved, row: int, rim: float) -> Lines:
    """Draw one row, as wide as every other."""
    own = solved.elements.row == row
    loads, azimuths = solved.inner.load[0, own], solved.elements.azimuth[0, own]
    drawn = rosette(
        loads.tolist(), azimuths.tolist(), _ROSETTE_HEIGHT, rim=rim, braille=page.medium.draws
    )
    width = 2 * _ROSETTE_HEIGHT
    lines = [Text("+z".center(width))]
    if len(solved.rows) > 1:
        lines.insert(0, page.text(page.words.row.format(number=row).center(width)))
    for number, cells in enumerate(drawn):
        line = Text.assemble(*((c.character, "cyan" if c.loaded else "dim") for c in cells))
        lines.append(line.append(_SIDE if number == _ROSETTE_HEIGHT // 2 else ""))
    return lines


# --- balls that friction alone moves ------------------------------------------------------------


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


def _spin(race: Race) -> Values:
    """Spin to roll, if the race touches the ball."""

    def values(solved: Solved) -> FloatArray:
        own, other = solved.contacts[race], solved.contacts["outer" if race == "inner" else "inner"]
        touched: BoolArray = own.load[0] > NO_LOAD * other.load[0]
        return np.where(touched, own.spin_to_roll[0], np.nan)

    return _without_rounding(values)


def _of_rolling(race: Race, name: str, factor: float = 1.0) -> Values:
    return lambda solved: factor * getattr(getattr(solved.rolling, race), name)[0]


_SMALLEST_ANGLE: Final = _DEGREE * _NO_MOTION
_ROLLING: Final = (
    _Column("ψ", "°", _of_ball("azimuth", _DEGREE), digits=5),
    _Column("β", "°", _without_rounding(_of_ball("attitude", _DEGREE), _SMALLEST_ANGLE)),
    _Column("β′", "°", _without_rounding(_of_ball("yaw", _DEGREE), _SMALLEST_ANGLE), 3, 3),
    _Column("s_i", "–", _spin("inner"), 3, 3),
    _Column("s_o", "–", _spin("outer"), 3, 3),
    _Column("P_i", "W", _of_rolling("inner", "power"), most=3),
    _Column("P_o", "W", _of_rolling("outer", "power"), most=3),
    _Column("v_i", "mm/s", _of_rolling("inner", "slip", 1e3)),
    _Column("v_o", "mm/s", _of_rolling("outer", "slip", 1e3)),
)


def rolling_part(page: Page, solved: Solved) -> Lines:
    """Show how friction moves cage and balls, and what it costs; nothing under raceway control."""
    rolling = solved.rolling
    if rolling is None:
        return []
    said = _ROLLING_WORDS.get(page.words.code, _ROLLING_WORDS["en"])
    entries = [
        (said.cage, _cage(page, said, rolling), ""),
        (said.torque, _torques(page, said, rolling), ""),
        (said.power, _powers(page, said, rolling, solved.case.model.cage_drag), ""),
    ]
    columns = [_ball_numbers(solved)]
    for column in _ROLLING:
        texts = page.digits.column(column.of(solved).tolist(), column.digits, column.most)
        header = [page.text(column.symbol), page.text(column.unit, "dim")]
        columns.append(header + [page.text(text) for text in texts])
    return [
        page.heading(said.heading),
        *page.labelled(entries, indent="  "),
        Text(),
        *page.table(columns),
        *page.hanging(Text("  "), said.legend, "dim"),
    ]


def _cage(page: Page, said: _RollingWords, rolling: Rolling) -> str:
    skid = float(rolling.skid[0])
    return (said.behind if skid >= 0.0 else said.ahead).format(
        speed=page.digits.short(_RPM * float(rolling.cage_speed[0])),
        skid=page.digits.short(100.0 * abs(skid), digits=3),
        usual=page.digits.short(_RPM * float(rolling.control_cage_speed[0])),
    )


def _torques(page: Page, said: _RollingWords, rolling: Rolling) -> str:
    inner, outer = (
        page.digits.short(1e3 * float(value[0]), digits=4)
        for value in (rolling.inner_torque, rolling.outer_torque)
    )
    return said.torques.format(inner=inner, outer=outer)


def _powers(page: Page, said: _RollingWords, rolling: Rolling, drag: float) -> str:
    powers = (rolling.power[0], rolling.inner.power[0].sum(), rolling.outer.power[0].sum())
    total, inner, outer = (page.digits.short(float(value), digits=4) for value in powers)
    text = said.powers.format(total=total, inner=inner, outer=outer)
    if drag:
        own = page.digits.short(drag * abs(float(rolling.cage_speed[0])), digits=4)
        text += said.drag.format(drag=own)
    return text


# --- CSV (RFC 4180), for spreadsheets and scripts -----------------------------------------------

_CSV_CONTACT: Final = {
    "load_N": ("load", 1.0),
    "contact_angle_deg": ("contact_angle", _DEGREE),
    "deflection_um": ("deflection", 1e6),
    "semi_major_mm": ("semi_major", 1e3),
    "semi_minor_mm": ("semi_minor", 1e3),
    "max_pressure_MPa": ("max_pressure", 1e-6),
    "mean_pressure_MPa": ("mean_pressure", 1e-6),
    "max_shear_MPa": ("max_shear", 1e-6),
    "max_shear_depth_mm": ("max_shear_depth", 1e3),
    "orthogonal_shear_MPa": ("orthogonal_shear", 1e-6),
    "orthogonal_shear_depth_mm": ("orthogonal_shear_depth", 1e3),
    "spin_to_roll": ("spin_to_roll", 1.0),
}
_CSV_BALL: Final = {
    "centrifugal_force_N": ("centrifugal_force", 1.0),
    "gyroscopic_moment_Nmm": ("gyroscopic_moment", 1e3),
    "orbital_speed_rpm": ("orbital_speed", _RPM),
    "ball_speed_rpm": ("ball_speed", _RPM),
    "attitude_deg": ("attitude", _DEGREE),
}

CSV_COLUMNS: Final = (
    "row",
    "ball",
    "azimuth_deg",
    *(f"{race}_{name}" for race in RACES for name in _CSV_CONTACT),
    *_CSV_BALL,
    "raceway_control",
)
"""The header: what each column holds, and its unit."""


def ball_csv(solved: Solved) -> str:
    """Return the balls of a case, one a line below a header, lines ending in CR LF.

    Names and numbers are the same in every language: units as people use them, named in the
    header, a decimal point, and an empty field for a number that does not exist.
    """
    elements = solved.elements
    columns = [_DEGREE * elements.azimuth[0]]
    for contacts in solved.contacts.values():
        columns += [f * getattr(contacts, name)[0] for name, f in _CSV_CONTACT.values()]
    columns += [factor * getattr(elements, name)[0] for name, factor in _CSV_BALL.values()]
    text = StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(CSV_COLUMNS)
    numbers = np.stack(columns, axis=1).tolist()
    for ball, (row, control) in enumerate(zip(elements.row, control_names(solved), strict=True)):
        writer.writerow([row, ball, *map(csv_number, numbers[ball]), control])
    return text.getvalue()
