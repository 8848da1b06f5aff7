"""Orbit and ball speed, equations 48 to 50: over the ball's attitude, and for the solved ball."""

from __future__ import annotations

import numpy as np

from rolamento_reproductions.braga_almeida.solved import GIVEN, ball
from rolamento_reproductions.given import grid
from rolamento_reproductions.record import (
    Claim,
    Curves,
    Figure,
    Line,
    Panel,
    Section,
    Series,
    Table,
    TableColumn,
)
from rolamento_reproductions.text import Text, said

__all__ = ["orbit_section"]

_ROUNDING = 1e-12
_QUANTITIES = (
    (
        "5.1",
        "orbital_speed",
        said("Cage speed ω_m/ω", "Rotação da gaiola ω_m/ω"),
        said("cage speed by equation 49", "rotação da gaiola pela equação 49"),
    ),
    (
        "5.2",
        "ball_speed",
        said("Ball speed |ω_R|/ω", "Rotação da esfera |ω_R|/ω"),
        said("ball speed by equation 50", "rotação da esfera pela equação 50"),
    ),
)


def orbit_section(title: Text) -> Section:
    """Compute figures 5.1 and 5.2 and table 5.1."""
    return Section(title, (*(_figure(*what) for what in _QUANTITIES), _table()))


def _figure(number: str, name: str, title: Text, words: Text) -> Figure:
    given = GIVEN.inputs_of("orbit")
    one = ball("friction")
    degrees = grid(0.0, given["highest_attitude_deg"], given["step_deg"])
    yaws = [float(yaw) for yaw in given["yaws_deg"]]
    found = [one.orbits(beta=np.radians(degrees), yaw=float(np.radians(yaw))) for yaw in yaws]
    printed = np.concatenate([1.0 - o.inner_speed_printed() / o.speed for o in found])
    value = (
        np.concatenate([-o.outer_speed() / o.speed for o in found])
        if name == "orbital_speed"
        else np.concatenate([-o.ball_speed() / o.speed for o in found])
    )
    columns = [
        Series("yaw", "°", said("β′", "β′"), np.repeat(yaws, degrees.size)),
        Series(
            "attitude",
            "°",
            said("Attitude of the ball's axis β", "Inclinação do eixo da esfera β"),
            np.tile(degrees, len(yaws)),
        ),
        Series(name, "", title, value),
    ]
    lines = [
        Line(name, look, said("β′ = {:.0f}°", "β′ = {:.0f}°", yaw), ("yaw", yaw))
        for look, yaw in enumerate(yaws)
    ]
    if name == "orbital_speed":
        columns.append(
            Series("as_printed", "", said("(48) as printed", "(48) como impressa"), printed)
        )
        label = said("from (48) as printed, β′ = 0°", "de (48) como impressa, β′ = 0°")
        lines.append(Line("as_printed", len(yaws), label, ("yaw", yaws[0])))
    return Figure(
        number=number,
        caption=said(
            "The 218 as in figures 3.1 and 4.1: {}, over the attitude of the ball's axis. Friction"
            " puts it at β = {:.1f}°, outer raceway control at {:.1f}°.",
            "218 como nas figuras 3.1 e 4.1: {}, em função da inclinação do eixo da esfera. O"
            " atrito o leva a β = {:.1f}°, o controle pela pista externa a {:.1f}°.",
            words,
            float(np.degrees(one.attitude)),
            float(np.degrees(ball("outer").attitude)),
        ),
        source=GIVEN.source_of("orbit"),
        columns=tuple(columns),
        picture=Curves((Panel("attitude", title, "", tuple(lines), tick=10.0, from_zero=False),)),
    )


def _table() -> Table:
    one = ball("friction")
    exact, idle = one.orbits(), one.orbits(idle=True)
    cage = one.orbit / one.speed
    turning = one.ball_speed / one.speed

    def ratio(value: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> float:
        return float(value[0]) / one.speed

    columns = (
        ("solved", said("solved", "resolvido"), cage, turning),
        (
            "equations",
            said("(49), (50) with its r′", "(49), (50) com seus r′"),
            -ratio(exact.outer_speed()),
            ratio(exact.ball_speed()),
        ),
        (
            "equations_idle",
            said("(49), (50) with r′ = D/2, β′ = 0", "(49), (50) com r′ = D/2, β′ = 0"),
            -ratio(idle.outer_speed()),
            ratio(idle.ball_speed()),
        ),
        (
            "as_printed",
            said("(48) as printed", "(48) como impressa"),
            1.0 - ratio(exact.inner_speed_printed()),
            float("nan"),
        ),
    )
    gap = max(abs(columns[1][2] / cage - 1.0), abs(columns[1][3] / turning - 1.0))
    off = columns[3][2] / cage - 1.0
    return Table(
        number="5.1",
        caption=said(
            "The 218 as in figures 3.1 and 4.1, under friction alone: cage and ball speed over that"
            " of the inner ring.",
            "218 como nas figuras 3.1 e 4.1, só com o atrito: rotação da gaiola e da esfera sobre a"
            " do anel interno.",
        ),
        source=GIVEN.source_of("orbit"),
        columns=(
            TableColumn(
                "quantity",
                said("Quantity", "Grandeza"),
                (said("ω_m/ω", "ω_m/ω"), said("ω_R/ω", "ω_R/ω")),
            ),
            *(
                TableColumn(
                    name,
                    title,
                    tuple("" if np.isnan(v) else f"{v:.6f}" for v in (first, second)),
                )
                for name, title, first, second in columns
            ),
        ),
        claims=(
            Claim(
                said(
                    "Under pure rolling (48), (49) and (50) give the motion of the balls.",
                    "Em puro rolamento (48), (49) e (50) representam o movimento das esferas.",
                ),
                said(
                    "With the rolling radii of the solved ball, (49) and (50) return its motion"
                    " (to 10⁻¹²). (48) as printed is off by {:+.1f} %; corrected, it agrees.",
                    "Com os raios de rolamento da esfera resolvida, (49) e (50) devolvem seu"
                    " movimento (até 10⁻¹²). (48) como impressa erra em {:+.1f} %; corrigida,"
                    " concorda.",
                    100.0 * off,
                ),
                holds=gap < _ROUNDING and abs(off) < _ROUNDING,
                partly=gap < _ROUNDING,
            ),
        ),
    )
