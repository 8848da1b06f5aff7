"""Figures 5.25 and 5.26: radial displacement of the 218 over axial load and over speed."""

from __future__ import annotations

import numpy as np

from rolamento.case.duty import Duty, Load
from rolamento.rows.ball import solve_batch
from rolamento_reproductions.radaelli_2013.inputs import (
    KILO,
    MILLI,
    RPM,
    case,
    grid,
    inputs_of,
    source_of,
    status_column,
)
from rolamento_reproductions.record import Claim, Curves, Figure, Line, Panel, Section, Series
from rolamento_reproductions.text import Text, said

__all__ = ["shift_section"]

_SHIFT = said("Radial displacement δ_z", "Deslocamento radial δ_z")


def shift_section(title: Text) -> Section:
    """Compute figures 5.25 and 5.26."""
    over_load, over_speed = _over_axial_load(), _over_speed()
    fall = _ratio(over_load)
    rise = _ratio(over_speed)
    weaker = Claim(
        said(
            "The speed matters, but less than the axial load.",
            "A rotação influi, mas menos que a carga axial.",
        ),
        said(
            "From end to end of the curves δ_z changes by a factor of {:.2f} with the speed and"
            " {:.2f} with the axial load.",
            "De ponta a ponta das curvas, δ_z muda por um fator de {:.2f} com a rotação e de"
            " {:.2f} com a carga axial.",
            rise,
            1.0 / fall,
        ),
        1.0 < rise < 1.0 / fall,
    )
    return Section(title, (_figure_over_load(over_load), _figure_over_speed(over_speed, weaker)))


def _over_axial_load() -> tuple[Series, ...]:
    given = inputs_of("radial_over_axial_load")
    loads = grid(given["lowest_load_kN"], given["highest_load_kN"], given["step_kN"])
    duty = Duty(
        inner_speed=given["inner_speed_rpm"] * RPM, load=Load(fz=given["radial_load_kN"] * KILO)
    )
    state = solve_batch(case(duty), fx=loads * KILO)
    return (
        Series("axial_load", "kN", said("Axial load F_a", "Carga axial F_a"), loads),
        Series("radial_displacement", "mm", _SHIFT, state.displacement[:, 2] / MILLI),
        status_column(state),
    )


def _over_speed() -> tuple[Series, ...]:
    given = inputs_of("radial_over_speed")
    speeds = grid(given["lowest_speed_rpm"], given["highest_speed_rpm"], given["step_rpm"])
    load = Load(fx=given["axial_load_kN"] * KILO, fz=given["radial_load_kN"] * KILO)
    state = solve_batch(case(Duty(load=load)), inner_speed=speeds * RPM)
    return (
        Series(
            "inner_speed",
            "rpm",
            said("Inner ring speed n_i", "Rotação do anel interno n_i"),
            speeds,
        ),
        Series("radial_displacement", "mm", _SHIFT, state.displacement[:, 2] / MILLI),
        status_column(state),
    )


def _figure_over_load(columns: tuple[Series, ...]) -> Figure:
    given = inputs_of("radial_over_axial_load")
    loads, shift = columns[0].numbers, columns[1].numbers
    low, high = 20.0, 80.0
    at_low, at_high = float(np.interp(low, loads, shift)), float(np.interp(high, loads, shift))
    fall = 100.0 * (1.0 - at_high / at_low)
    return Figure(
        number="5.25",
        caption=said(
            "The 218 under {:.0f} kN of radial load at {:,.0f} rpm: radial displacement over the"
            " axial load.",
            "218 sob {:.0f} kN de carga radial a {:,.0f} rpm: deslocamento radial em função da"
            " carga axial.",
            given["radial_load_kN"],
            given["inner_speed_rpm"],
        ),
        source=source_of("radial_over_axial_load"),
        columns=columns,
        picture=_picture(columns, 10.0),
        claims=(
            Claim(
                said(
                    "From {:.0f} to {:.0f} kN of axial load the displacement falls by about 80 %.",
                    "De {:.0f} a {:.0f} kN de carga axial o deslocamento cai cerca de 80 %.",
                    low,
                    high,
                ),
                said(
                    "From {:.4f} to {:.4f} mm: by {:.2f} %.",
                    "De {:.4f} a {:.4f} mm: {:.2f} %.",
                    at_low,
                    at_high,
                    fall,
                ),
                abs(fall - 80.0) < 1.0,
            ),
        ),
    )


def _figure_over_speed(columns: tuple[Series, ...], weaker: Claim) -> Figure:
    given = inputs_of("radial_over_speed")
    speeds, shift = columns[0].numbers, columns[1].numbers
    return Figure(
        number="5.26",
        caption=said(
            "The 218 under {:.0f} kN of radial and {:.0f} kN of axial load: radial displacement"
            " over the speed.",
            "218 sob {:.0f} kN de carga radial e {:.0f} kN de carga axial: deslocamento radial em"
            " função da rotação.",
            given["radial_load_kN"],
            given["axial_load_kN"],
        ),
        source=source_of("radial_over_speed"),
        columns=columns,
        picture=_picture(columns, 2500.0),
        claims=(
            Claim(
                said(
                    "The displacement grows with the speed.",
                    "O deslocamento cresce com a rotação.",
                ),
                said(
                    "From {:.4f} mm at {:,.0f} rpm to {:.4f} mm at {:,.0f} rpm.",
                    "De {:.4f} mm a {:,.0f} rpm até {:.4f} mm a {:,.0f} rpm.",
                    float(shift[0]),
                    float(speeds[0]),
                    float(shift[-1]),
                    float(speeds[-1]),
                ),
                bool((np.diff(shift) > 0.0).all()),
            ),
            weaker,
        ),
    )


def _picture(columns: tuple[Series, ...], tick: float) -> Curves:
    x, y = columns[0], columns[1]
    return Curves((Panel(x.name, y.title, y.unit, (Line(y.name, 0),), tick=tick),))


def _ratio(columns: tuple[Series, ...]) -> float:
    """Last value over first."""
    shift = columns[1].numbers
    return float(shift[-1] / shift[0])
