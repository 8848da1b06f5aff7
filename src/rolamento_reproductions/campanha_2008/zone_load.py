"""Load round the ring at several clearances: figure 4.1.3."""

from __future__ import annotations

from functools import cache

import numpy as np

from rolamento.life.load_zone import catalogue_stiffness
from rolamento.static import RadialSolution, radial_load
from rolamento.verification.campanha_2008 import STRIBECK
from rolamento_reproductions.campanha_2008.inputs import (
    GIVEN,
    MICRO,
    ball_count,
    ball_diameter,
    bearing,
    clearances_of_class,
    load,
    printed,
)
from rolamento_reproductions.given import KILO, grid
from rolamento_reproductions.record import Claim, Curves, Figure, Floats, Line, Panel, Series
from rolamento_reproductions.text import said

__all__ = ["NO_CLEARANCE", "distribution_figure", "elastic_approach", "loaded"]

NO_CLEARANCE = 0.5
"""ε without clearance."""


def elastic_approach() -> float:
    """Return what a ball approaches the rings by under 5 F_r/Z, with the maker's stiffness; m."""
    ball = STRIBECK * load() / ball_count()
    return float((ball / catalogue_stiffness(ball_diameter())) ** (2.0 / 3.0))


def _clearances() -> list[float]:
    """Preload, none, the new bearing's, a worn one's, and what was taken for a clearance; m."""
    given = GIVEN.inputs_of("load_zone")
    return [
        given["preload_um"] * MICRO,
        *(value * MICRO for value in given["clearances_um"]),
        elastic_approach(),
    ]


@cache
def loaded(clearance: float) -> RadialSolution:
    """Return the bearing with a clearance (m) under the load, its balls smeared round the ring."""
    return radial_load(bearing(clearance), load())


def distribution_figure() -> Figure:
    """Compute figure 4.1.3."""
    clearances = _clearances()
    azimuth = grid(-180.0, 180.0, 1.0)
    place = np.mod(azimuth, 360.0) * ball_count() / 360.0
    ball = np.where(np.isclose(place, np.round(place)), np.round(place) + 1.0, np.nan)
    microns = [clearance / MICRO for clearance in clearances]
    columns = (
        Series(
            "clearance",
            "µm",
            said("Radial clearance Δ", "Folga radial Δ"),
            np.repeat(microns, azimuth.size),
        ),
        Series("azimuth", "°", said("Azimuth ψ", "Azimute ψ"), np.tile(azimuth, len(clearances))),
        Series("ball", "", said("Ball", "Esfera"), np.tile(ball, len(clearances))),
        Series(
            "ball_load",
            "kN",
            said("Ball load Q", "Carga na esfera Q"),
            np.concatenate([_round_the_ring(loaded(c), azimuth) / KILO for c in clearances]),
        ),
    )
    lines = tuple(
        Line(
            "ball_load",
            look,
            said(
                "Δ = {:.0f} µm, ε = {:.2f}",
                "Δ = {:.0f} µm, ε = {:.2f}",
                micron,
                float(loaded(clearance).load_zone_parameter),
            ),
            by=("clearance", micron),
            marked="ball",
        )
        for look, (micron, clearance) in enumerate(zip(microns, clearances, strict=True))
    )
    return Figure(
        number="4.1.3",
        caption=said(
            "What the load factor ε means for the 6305 under {:,.0f} N: ball load round the ring"
            " with preload, without clearance, with the clearance of a new bearing of class C3, of"
            " one worn for 628 h, and with the elastic approach taken for a clearance. Markers: the"
            " eight balls.",
            "O que o fator de carga ε significa para o 6305 sob {:,.0f} N: carga nas esferas ao"
            " redor do anel com pré-carga, sem folga, com a folga de um rolamento novo da classe"
            " C3, com a de um gasto por 628 h e com a aproximação elástica tomada por folga."
            " Marcadores: as oito esferas.",
            load(),
        ),
        source=GIVEN.source_of("load_zone"),
        columns=columns,
        picture=Curves(
            (
                Panel(
                    "azimuth",
                    columns[3].title,
                    "kN",
                    lines,
                    tick=45.0,
                    around=True,
                    legend_columns=3,
                ),
            )
        ),
        claims=(_half(), _heaviest()),
        notes=(
            said(
                "The printed figure is a sketch. Here the inner groove is as measured ({:.3f}), and"
                " the contacts are exact; balls are smeared round the ring (Sjövall).",
                "A figura impressa é um esquema. Aqui o canal interno é o medido ({:.3f}) e os"
                " contatos são exatos; as esferas são distribuídas ao redor do anel (Sjövall).",
                printed("life")["measured_conformity"],
            ),
        ),
    )


def _round_the_ring(solved: RadialSolution, azimuth_deg: Floats) -> Floats:
    """Q(ψ) = Q_max [1 - (1 - cos ψ)/(2ε)]^1.5 where positive. Sjövall (1933)."""
    epsilon, greatest = float(solved.load_zone_parameter), float(solved.max_ball_load)
    share = 1.0 - (1.0 - np.cos(np.radians(azimuth_deg))) / (2.0 * epsilon)
    return np.asarray(greatest * np.maximum(share, 0.0) ** 1.5)


def _half() -> Claim:
    none = loaded(0.0)
    return Claim(
        said(
            "The calculation of life takes ε = 0.5, a bearing without clearance in operation.",
            "O cálculo de vida prevê ε = 0,5, um rolamento sem folga em operação.",
        ),
        said(
            "ε = {:.4f} without clearance, loaded over {:.1f}° on either side.",
            "ε = {:.4f} sem folga, com carga até {:.1f}° para cada lado.",
            float(none.load_zone_parameter),
            float(np.degrees(none.load_zone_half_angle)),
        ),
        abs(float(none.load_zone_parameter) - NO_CLEARANCE) < 1e-12,
    )


def _heaviest() -> Claim:
    new = [loaded(clearance) for clearance in clearances_of_class()]
    stribeck = STRIBECK * load() / ball_count()
    loads = [float(state.max_ball_load) for state in new]
    return Claim(
        said(
            "The heaviest ball carries 5 F_r/Z = {:,.0f} N (chapter 4.4.3).",
            "A esfera mais carregada leva 5 F_r/Z = {:,.0f} N (capítulo 4.4.3).",
            stribeck,
        ),
        said(
            "{:,.0f} to {:,.0f} N with the clearance of a new bearing: Stribeck's 5 leaves room for"
            " more clearance than these have.",
            "{:,.0f} a {:,.0f} N com a folga de um rolamento novo: o 5 de Stribeck deixa margem"
            " para folga maior que a destes.",
            *loads,
        ),
        holds=False,
        partly=all(0.85 * stribeck < value < stribeck for value in loads),
    )
