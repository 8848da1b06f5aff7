"""Balls that friction alone controls, in the report: the cage, the losses, every ball's motion."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import degrees, nan, pi
from typing import Final

from rich.text import Text

from rolamento.report.page import Lines, Page
from rolamento.state import BallState, ContactState, RollingBall, RollingState, State

__all__ = ["rolling_part"]

_RPM: Final = 30.0 / pi
_NO_LOAD: Final = 1e-9
"""Of the load at the other race: what is less is rounding, and no contact."""
_NO_MOTION: Final = 1e-9
"""Angles (rad) and ratios that are rounding."""


@dataclass(frozen=True, slots=True)
class _Words:
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


_WORDS: Final[Mapping[str, _Words]] = {
    "en": _Words(
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
    "pt": _Words(
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
class _Column:
    """One number of every ball."""

    symbol: str
    unit: str
    of: Callable[[BallState, RollingBall], float]
    digits: int = 3
    most: int = 3


def _spin(contact: ContactState, other: ContactState) -> float:
    """Spin to roll, if the race touches the ball; rounding as zero."""
    touched = contact.load > _NO_LOAD * other.load
    return _plain(contact.spin_to_roll) if touched else nan


def _plain(value: float) -> float:
    return 0.0 if abs(value) < _NO_MOTION else value


_COLUMNS: Final = (
    _Column("ψ", "°", lambda ball, _: degrees(ball.azimuth), digits=5, most=2),
    _Column("β", "°", lambda ball, _: degrees(_plain(ball.attitude)), digits=4, most=2),
    _Column("β′", "°", lambda _, own: degrees(_plain(own.yaw))),
    _Column("s_i", "–", lambda ball, _: _spin(ball.inner, ball.outer)),
    _Column("s_o", "–", lambda ball, _: _spin(ball.outer, ball.inner)),
    _Column("P_i", "W", lambda _, own: own.inner.power, digits=4),
    _Column("P_o", "W", lambda _, own: own.outer.power, digits=4),
    _Column("v_i", "mm/s", lambda _, own: 1e3 * own.inner.slip, digits=4, most=2),
    _Column("v_o", "mm/s", lambda _, own: 1e3 * own.outer.slip, digits=4, most=2),
)


def rolling_part(page: Page, state: State) -> Lines:
    """Show how friction moves cage and balls, and what it costs; nothing under raceway control."""
    if state.rolling is None:
        return []
    said = _WORDS.get(page.words.code, _WORDS["en"])
    entries = [
        (said.cage, _cage(page, said, state.rolling)),
        (said.torque, _torques(page, said, state.rolling)),
        (said.power, _powers(page, said, state)),
    ]
    width = max(len(label) for label, _ in entries)
    lines = [page.heading(said.heading)]
    for label, content in entries:
        lines += page.hanging(page.text(f"  {label:{width}}  ", "dim"), content)
    return [*lines, Text(), *_table(page, state, state.rolling), *_legend(page, said)]


def _cage(page: Page, said: _Words, rolling: RollingState) -> str:
    template = said.behind if rolling.skid >= 0.0 else said.ahead
    return template.format(
        speed=page.digits.short(_RPM * rolling.cage_speed),
        skid=page.digits.short(100.0 * abs(rolling.skid), digits=3),
        usual=page.digits.short(_RPM * rolling.control_cage_speed),
    )


def _torques(page: Page, said: _Words, rolling: RollingState) -> str:
    inner, outer = (
        page.digits.short(1e3 * value, digits=4)
        for value in (rolling.inner_torque, rolling.outer_torque)
    )
    return said.torques.format(inner=inner, outer=outer)


def _powers(page: Page, said: _Words, state: State) -> str:
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


def _table(page: Page, state: State, rolling: RollingState) -> Lines:
    pairs = list(zip(state.balls, rolling.balls, strict=True))
    numbers = [Text(), Text("#"), *(Text(str(j), "dim") for j in range(len(pairs)))]
    columns = [numbers]
    for column in _COLUMNS:
        values = [column.of(*pair) for pair in pairs]
        texts = page.digits.column(values, column.digits, column.most)
        header = [page.text(column.symbol), page.text(column.unit, "dim")]
        columns.append(header + [page.text(text) for text in texts])
    table = page.columns(list(zip(*columns, strict=True)), "r" * len(columns))
    return [*table[:2], page.rule(max(map(len, table))), *table[2:]]


def _legend(page: Page, said: _Words) -> Lines:
    return page.hanging(Text("  "), said.legend, "dim")
