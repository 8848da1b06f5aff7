"""Ball loads and contact angles round the ring of the 218, with the cage turned step by step.

The markers of a figure are the balls where the source puts them. The line between them is what
the same bearing gives with the cage turned by parts of the spacing of the balls: every ball passes
every azimuth, and the ring finds its balance anew each time.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from rolamento.case import Case
from rolamento.rows.ball import BatchState, solve_batch
from rolamento_reproductions.radaelli_2013.inputs import MILLI, status_column
from rolamento_reproductions.record import Curves, Figure, Floats, Line, Panel, Series
from rolamento_reproductions.text import Text, said

__all__ = ["Round", "figure_pair", "solved_round"]

_STEPS: Final = 15
"""Turns of the cage within the spacing of two balls: every 1.5° with sixteen balls."""


@dataclass(frozen=True, slots=True, eq=False)
class Round:
    """A case with the cage turned: arrays over all balls of all turns, by azimuth; SI and degrees.

    ball: 1 to Z where the source has a ball, NaN between. Displacement and moment are those with
    the balls where the source puts them.
    """

    case: Case
    state: BatchState
    turn: Floats
    azimuth: Floats
    ball: Floats
    inner_load: Floats
    outer_load: Floats
    inner_angle: Floats
    outer_angle: Floats
    order: np.ndarray[tuple[int, ...], np.dtype[np.int64]]

    @property
    def placed(self) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
        """Where the source has a ball."""
        return np.isfinite(self.ball)

    @property
    def shift(self) -> Floats:
        """Displacement (x, y, z) of the inner ring; mm."""
        shift: Floats = self.state.displacement[0, :3] / MILLI
        return shift

    @property
    def moment(self) -> float:
        """Reaction my; N·m."""
        return float(self.state.load[0, 3])


def solved_round(case: Case) -> Round:
    """Solve a case, and again with the cage turned."""
    count = case.bearing.ball_count
    turns = np.arange(_STEPS) * 2.0 * np.pi / (count * _STEPS)
    state = solve_batch(case, first_ball_azimuth=case.duty.first_ball_azimuth + turns)
    balls = state.balls()
    number = np.full((_STEPS, count), np.nan)
    number[0] = np.arange(1.0, count + 1.0)
    # From above -180° to 180°; rounded, lest noise move a ball from one end to the other.
    azimuth = 180.0 - np.mod(np.round(180.0 - np.degrees(balls.azimuth), 9), 360.0)
    order = np.argsort(azimuth.ravel(), kind="stable")
    turned = np.broadcast_to(np.degrees(turns)[:, np.newaxis], azimuth.shape)

    def sorted_by_azimuth(values: Floats) -> Floats:
        by_azimuth: Floats = values.ravel()[order]
        return by_azimuth

    return Round(
        case=case,
        state=state,
        turn=sorted_by_azimuth(turned),
        azimuth=sorted_by_azimuth(azimuth),
        ball=sorted_by_azimuth(number),
        inner_load=sorted_by_azimuth(balls.inner.load),
        outer_load=sorted_by_azimuth(balls.outer.load),
        inner_angle=sorted_by_azimuth(np.degrees(balls.inner.contact_angle)),
        outer_angle=sorted_by_azimuth(np.degrees(balls.outer.contact_angle)),
        order=order,
    )


def figure_pair(
    numbers: tuple[str, str], case: Text, source: Text, found: Round
) -> tuple[Figure, Figure]:
    """Return the figure of ball loads and that of contact angles, without statements."""
    load = said("Ball load Q", "Carga na esfera Q")
    angle = said("Contact angle α", "Ângulo de contato α")
    loads = _figure(
        numbers[0],
        said(
            "{} Ball loads at both races. Markers: the balls; lines: the cage turned between them.",
            "{} Cargas nas esferas nas duas pistas. Marcadores: as esferas; linhas: com a gaiola"
            " girada entre elas.",
            case,
        ),
        source,
        found,
        (
            Series("inner_load", "N", load, found.inner_load),
            Series("outer_load", "N", load, found.outer_load),
        ),
        ("Q_i", "Q_o"),
    )
    angles = _figure(
        numbers[1],
        said(
            "{} Contact angles at both races. Markers: the balls; lines: the cage turned between"
            " them.",
            "{} Ângulos de contato nas duas pistas. Marcadores: as esferas; linhas: com a gaiola"
            " girada entre elas.",
            case,
        ),
        source,
        found,
        (
            Series("inner_contact_angle", "°", angle, found.inner_angle),
            Series("outer_contact_angle", "°", angle, found.outer_angle),
        ),
        ("α_i", "α_o"),
    )
    return loads, angles


def _figure(
    number: str,
    caption: Text,
    source: Text,
    found: Round,
    pair: tuple[Series, Series],
    symbols: tuple[str, str],
) -> Figure:
    places = (
        Series("azimuth", "°", said("Azimuth ψ", "Azimute ψ"), found.azimuth),
        Series("ball", "", said("Ball", "Esfera"), found.ball),
        Series("cage_turned", "°", said("Cage turned by", "Giro da gaiola"), found.turn),
    )
    status = status_column(found.state)
    states = np.asarray(status.values).repeat(found.case.bearing.ball_count)[found.order]
    races = (
        said("inner race, {}", "pista interna, {}", symbols[0]),
        said("outer race, {}", "pista externa, {}", symbols[1]),
    )
    lines = tuple(
        Line(column.name, look, race, dashed=bool(look), marked="ball")
        for look, (column, race) in enumerate(zip(pair, races, strict=True))
    )
    return Figure(
        number=number,
        caption=caption,
        source=source,
        columns=(*places, *pair, Series("status", "", status.title, tuple(map(str, states)))),
        picture=Curves(
            (Panel("azimuth", pair[0].title, pair[0].unit, lines, tick=45.0, around=True),)
        ),
    )
