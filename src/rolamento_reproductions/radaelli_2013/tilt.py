"""Figures 5.27 to 5.32 and table 5.4: the 218 with its inner ring tilted."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from rolamento.case.duty import Displacement, Duty, Load
from rolamento_reproductions.radaelli_2013.balls import Round, figure_pair, solved_round
from rolamento_reproductions.radaelli_2013.inputs import KILO, RPM, case, inputs_of, source_of
from rolamento_reproductions.record import Cell, Claim, Figure, Section, Table, TableColumn
from rolamento_reproductions.text import Text, said

__all__ = ["tilt_section"]

_NUMBERS = (("5.27", "5.28"), ("5.29", "5.30"), ("5.31", "5.32"))
_STRONG = 0.10
"""A change of a displacement that counts as strong."""
_WEAK_LOAD, _WEAK_ANGLE = 0.10, 5.0
"""Changes that count as weak: a part of the greatest load, and degrees."""
_LOADED = 0.10
"""Part of the greatest load from which a ball counts as loaded."""


def tilt_section(title: Text) -> Section:
    """Compute figures 5.27 to 5.32 and table 5.4."""
    tilts = [float(value) for value in inputs_of("tilted")["tilts_deg"]]
    found = {tilt: _solved(tilt) for tilt in tilts}
    figures = tuple(
        figure
        for numbers, tilt in zip(_NUMBERS, tilts, strict=True)
        for figure in _figures(numbers, tilt, found)
    )
    return Section(title, (*figures, _table(found)))


def _solved(tilt: float) -> Round:
    given = inputs_of("tilted")
    duty = Duty(
        inner_speed=given["inner_speed_rpm"] * RPM,
        load=Load(fx=given["axial_load_kN"] * KILO, fz=given["radial_load_kN"] * KILO),
        displacement=Displacement(ry=np.radians(tilt)),
    )
    return solved_round(case(duty))


def _figures(
    numbers: tuple[str, str], tilt: float, found: dict[float, Round]
) -> tuple[Figure, Figure]:
    given = inputs_of("tilted")
    named = said(
        "The 218 at {:,.0f} rpm: F_a = {:.0f} kN, F_z = {:.0f} kN, tilted by θ_y = {:.2f}°.",
        "218 a {:,.0f} rpm: F_a = {:.0f} kN, F_z = {:.0f} kN, desalinhado de θ_y = {:.2f}°.",
        given["inner_speed_rpm"],
        given["axial_load_kN"],
        given["radial_load_kN"],
        tilt,
    )
    loads, angles = figure_pair(numbers, named, source_of("tilted"), found[tilt])
    if tilt == 0.0:
        return replace(loads, claims=(_moment_without_tilt(found[tilt]),)), angles
    level = found[0.0]
    return (
        replace(loads, claims=(_weak_on_loads(level, found[tilt]),)),
        replace(angles, claims=(_weak_on_angles(level, found[tilt]),)),
    )


def _weak_on_loads(level: Round, tilted: Round) -> Claim:
    inner = np.abs(level.inner_load - tilted.inner_load)
    outer = np.abs(level.outer_load - tilted.outer_load)
    change = float(np.maximum(inner, outer)[level.placed].max())
    share = change / float(level.outer_load.max())
    return Claim(
        said(
            "The tilt has a weak influence on the ball loads.",
            "O desalinhamento influi fracamente nas cargas das esferas.",
        ),
        said(
            "They differ from figure 5.29 by at most {:,.0f} N, {:.1f} % of the greatest.",
            "Diferem da figura 5.29 em no máximo {:,.0f} N, {:.1f} % da maior.",
            change,
            100.0 * share,
        ),
        share < _WEAK_LOAD,
    )


def _weak_on_angles(level: Round, tilted: Round) -> Claim:
    inner = np.abs(level.inner_angle - tilted.inner_angle)
    outer = np.abs(level.outer_angle - tilted.outer_angle)
    change = np.maximum(inner, outer)[level.placed]
    loaded = level.inner_load[level.placed] > _LOADED * level.inner_load.max()
    of_loaded, greatest = float(change[loaded].max()), float(change.max())
    return Claim(
        said(
            "The tilt has a weak influence on the contact angles.",
            "O desalinhamento influi fracamente nos ângulos de contato.",
        ),
        said(
            "They differ from figure 5.30 by at most {:.1f}° on the {} balls that carry more than"
            " {:.0f} % of the greatest load, and by up to {:.1f}° on the others.",
            "Diferem da figura 5.30 em no máximo {:.1f}° nas {} esferas com mais de {:.0f} % da"
            " maior carga, e em até {:.1f}° nas outras.",
            of_loaded,
            int(loaded.sum()),
            100.0 * _LOADED,
            greatest,
        ),
        holds=greatest < _WEAK_ANGLE,
        partly=of_loaded < _WEAK_ANGLE,
    )


def _moment_without_tilt(level: Round) -> Claim:
    return Claim(
        said(
            "Even without tilt the shaft has to hold a moment, because the balls load the ring"
            " unevenly.",
            "Mesmo sem desalinhamento o eixo precisa sustentar um momento, pois as esferas carregam"
            " o anel de forma desigual.",
        ),
        said("M_y = {:.2f} N·m.", "M_y = {:.2f} N·m.", level.moment),
        level.moment > 1.0,
    )


def _table(found: dict[float, Round]) -> Table:
    given = inputs_of("table_5_4")
    rows = given["rows"]
    states = [found[float(row[0])] for row in rows]
    columns = (
        TableColumn("tilt_deg", said("θ_y (°)", "θ_y (°)"), tuple(str(row[0]) for row in rows)),
        _column(rows, 1, "axial_displacement_mm", "δ_a (mm)", [s.shift[0] for s in states]),
        _column(rows, 2, "radial_displacement_mm", "δ_z (mm)", [s.shift[2] for s in states]),
        _column(rows, 3, "moment_Nm", "M_y (N·m)", [s.moment for s in states]),
    )
    return Table(
        number="5.4",
        caption=said(
            "The 218 tilted: displacements and moment, printed beside computed.",
            "218 desalinhado: deslocamentos e momento, impressos ao lado dos calculados.",
        ),
        source=source_of("table_5_4"),
        columns=columns,
        claims=(_strong_on_ring(found),),
        notes=(
            said(
                "The moment is measured with the radius of the circle of inner groove centres as"
                " its arm. The digits need the gyroscopic moment's sign: with its size alone the"
                " displacements are others (docs/adr/0001).",
                "O momento é medido com o raio do círculo dos centros de curvatura da pista interna"
                " como braço. Os dígitos exigem o sinal do momento giroscópico: só com o módulo os"
                " deslocamentos são outros (docs/adr/0001).",
            ),
        ),
    )


def _column(
    rows: list[list[str]], place: int, name: str, title: str, computed: list[float]
) -> TableColumn:
    cells = tuple(Cell(row[place], float(v)) for row, v in zip(rows, computed, strict=True))
    return TableColumn(name, said("{}", "{}", title), cells)


def _strong_on_ring(found: dict[float, Round]) -> Claim:
    level = found[0.0]
    others = [state for tilt, state in found.items() if tilt != 0.0]
    axial, radial = (
        [float(state.shift[axis] / level.shift[axis] - 1.0) for state in others] for axis in (0, 2)
    )
    return Claim(
        said(
            "The tilt has a strong influence on the displacements and changes the moment.",
            "O desalinhamento influi fortemente nos deslocamentos e altera o momento.",
        ),
        said(
            "By ±{:.2f}°: δ_a {:+.0f} % and {:+.0f} %, δ_z {:+.0f} % and {:+.0f} %, M_y {:+.0f} %"
            " and {:+.0f} %.",
            "Com ±{:.2f}°: δ_a {:+.0f} % e {:+.0f} %, δ_z {:+.0f} % e {:+.0f} %, M_y {:+.0f} % e"
            " {:+.0f} %.",
            max(found),
            *(100.0 * value for value in (*axial, *radial)),
            *(100.0 * (state.moment / level.moment - 1.0) for state in others),
        ),
        min(abs(value) for value in (*axial, *radial)) > _STRONG,
    )
