"""Speeds of cage and balls, equations 19 to 24, beside those of the solved bearing."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from rolamento_reproductions.braga_almeida.solved import GIVEN, Ball, ball, bearing
from rolamento_reproductions.given import grid
from rolamento_reproductions.record import (
    Claim,
    Curves,
    Figure,
    Floats,
    Line,
    Panel,
    Section,
    Series,
    Table,
    TableColumn,
)
from rolamento_reproductions.text import Text, said, same

__all__ = ["speeds_section"]

_NOTICED = 0.005
"""A change of a frequency that a spectrum shows."""
_WAYS = (
    ("equations", said("equations 19 to 24", "equações 19 a 24")),
    ("outer_control", said("outer raceway control", "controle pela pista externa")),
    ("friction", said("friction alone", "só o atrito")),
)


def speeds_section(title: Text) -> Section:
    """Compute figures 2.1 and 2.2 and table 2.1."""
    given = GIVEN.inputs_of("speeds")
    speeds = grid(given["lowest_rpm"], given["highest_rpm"], given["step_rpm"])
    solved = {
        "outer_control": [ball("outer", float(n)) for n in speeds],
        "friction": [ball("friction", float(n)) for n in speeds],
    }
    return Section(title, (_cage(speeds, solved), _balls(speeds, solved), _frequencies()))


def _gamma() -> float:
    rings = bearing()
    angle = np.radians(GIVEN.inputs_of("bearing")["contact_angle_deg"])
    return float(rings.ball_diameter * np.cos(angle) / rings.pitch_diameter)


def _by_equations() -> tuple[float, float]:
    """n_m/n_i and n_R/n_i by (23) and (24), at the free contact angle."""
    rings, gamma = bearing(), _gamma()
    cage = 0.5 * (1.0 - gamma)
    return cage, -0.5 * rings.pitch_diameter / rings.ball_diameter * (1.0 - gamma**2)


def _figure(
    number: str, caption: Text, title: Text, speeds: Floats, values: dict[str, Floats]
) -> Figure:
    columns = (
        Series(
            "inner_speed",
            "rpm",
            said("Inner ring speed n_i", "Rotação do anel interno n_i"),
            speeds,
        ),
        *(Series(name, "", label, values[name]) for name, label in _WAYS),
        Series(
            "status",
            "",
            said("status", "estado"),
            tuple(
                "converged" if np.isfinite(value) else "not_converged"
                for value in values["friction"]
            ),
        ),
    )
    lines = tuple(Line(name, look, label) for look, (name, label) in enumerate(_WAYS))
    return Figure(
        number=number,
        caption=caption,
        source=GIVEN.source_of("speeds"),
        columns=columns,
        picture=Curves((Panel("inner_speed", title, "", lines, tick=2000.0, from_zero=False),)),
    )


def _cage(speeds: Floats, solved: dict[str, list[Ball]]) -> Figure:
    values = {
        name: np.array([one.orbit / one.speed for one in balls]) for name, balls in solved.items()
    }
    values["equations"] = np.full(speeds.size, _by_equations()[0])
    figure = _figure(
        "2.1",
        said(
            "The 218 under {:.0f} kN of thrust: cage speed over ring speed, by equation 23 at the"
            " free contact angle, and of the solved bearing.",
            "218 sob {:.0f} kN de carga axial: rotação da gaiola sobre a do anel, pela equação 23"
            " com o ângulo de contato livre, e a do rolamento resolvido.",
            GIVEN.inputs_of("contacts")["axial_load_kN"],
        ),
        said("Cage speed n_m/n_i", "Rotação da gaiola n_m/n_i"),
        speeds,
        values,
    )
    return replace(figure, claims=(_other_motions(speeds, values),))


def _other_motions(speeds: Floats, values: dict[str, Floats]) -> Claim:
    change = values["friction"] / values["equations"] - 1.0
    worst = int(np.argmax(np.abs(change)))
    among = np.abs(values["friction"] / values["outer_control"] - 1.0)
    return Claim(
        said(
            "The balls may have other motions than that of equation 24, which change the"
            " frequencies that monitoring looks for.",
            "As esferas poderão apresentar outros movimentos além do representado pela equação 24,"
            " interferindo nas frequências utilizadas na monitoração.",
        ),
        said(
            "The cage's frequency differs from equation 23 by up to {:+.1f} % (at {:,.0f} rpm), and"
            " by up to {:.1f} % between outer control and friction.",
            "A frequência da gaiola difere da equação 23 em até {:+.1f} % (a {:,.0f} rpm), e em até"
            " {:.1f} % entre controle externo e atrito.",
            100.0 * float(change[worst]),
            float(speeds[worst]),
            100.0 * float(among.max()),
        ),
        bool(abs(change[worst]) > _NOTICED),
    )


def _balls(speeds: Floats, solved: dict[str, list[Ball]]) -> Figure:
    values = {
        name: np.array([-one.ball_speed / one.speed for one in balls])
        for name, balls in solved.items()
    }
    values["equations"] = np.full(speeds.size, -_by_equations()[1])
    return _figure(
        "2.2",
        said(
            "The same: ball speed over ring speed, by equation 24 and of the solved bearing. The"
            " size is drawn; its sign is against the ring's.",
            "O mesmo: rotação da esfera sobre a do anel, pela equação 24 e a do rolamento"
            " resolvido. Desenha-se o módulo; o sinal é contrário ao do anel.",
        ),
        said("Ball speed |n_R|/n_i", "Rotação da esfera |n_R|/n_i"),
        speeds,
        values,
    )


def _frequencies() -> Table:
    """Frequencies of the parts, in Hz, in the three ways."""
    speed_rpm = GIVEN.inputs_of("contacts")["inner_speed_rpm"]
    count = bearing().ball_count
    turns = speed_rpm / 60.0
    by_equations = _by_equations()
    ways = [(by_equations[0], -by_equations[1])]
    ways += [
        (one.orbit / one.speed, -one.ball_speed / one.speed)
        for one in (ball("outer"), ball("friction"))
    ]
    parts = (
        said("cage", "gaiola"),
        said("ball about itself", "esfera em torno de si"),
        said("balls passing the outer race", "passagem na pista externa"),
        said("balls passing the inner race", "passagem na pista interna"),
    )
    values = [
        [turns * ratio for ratio in (cage, spin, count * cage, count * (1.0 - cage))]
        for cage, spin in ways
    ]
    return Table(
        number="2.1",
        caption=said(
            "The 218 at {:,.0f} rpm: frequencies in Hz.",
            "218 a {:,.0f} rpm: frequências em Hz.",
            speed_rpm,
        ),
        source=GIVEN.source_of("speeds"),
        columns=(
            TableColumn("part", said("Part", "Componente"), parts),
            *(
                TableColumn(
                    f"{name}_Hz",
                    title,
                    tuple(f"{value:.2f}" for value in column),
                )
                for (name, title), column in zip(_WAYS, values, strict=True)
            ),
        ),
        notes=(same("BPFO = Z n_m/60, BPFI = Z (n_i − n_m)/60."),),
    )
