"""Figures 5.11 to 5.14, 5.25 and 5.26: the 218 at speed under axial load, and radial with it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rolamento.case.duty import Duty, Load
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.units import RPM
from rolamento_reproductions.given import KILO, MILLI, grid, status_column
from rolamento_reproductions.radaelli_2013.inputs import case, inputs_of, source_of
from rolamento_reproductions.record import (
    Claim,
    Curves,
    Figure,
    Floats,
    Line,
    Panel,
    Section,
    Series,
)
from rolamento_reproductions.text import Text, said, same

_RACES = (said("inner race", "pista interna"), said("outer race", "pista externa"))
_AXIAL_SHIFT = said("Axial displacement δ_a", "Deslocamento axial δ_a")
_MOMENT = said("Gyroscopic moment |M_g|", "Momento giroscópico |M_g|")


@dataclass(frozen=True, slots=True, eq=False)
class _Sweep:
    """All speeds and loads solved: arrays (speeds, loads); the balls of a case are alike."""

    speeds: Floats
    loads: Floats
    solved: Solved
    inner_load: Floats
    outer_load: Floats
    inner_angle: Floats
    outer_angle: Floats
    shift: Floats
    moment: Floats


def axial_section(title: Text) -> Section:
    """Compute figures 5.11 to 5.14."""
    sweep = _solved_sweep()
    return Section(title, (_angles(sweep), _ball_loads(sweep), _shifts(sweep), _moments(sweep)))


def _solved_sweep() -> _Sweep:
    given = inputs_of("axial_at_speed")
    speeds = np.asarray(given["speeds_rpm"], dtype=np.float64)
    loads = grid(0.0, given["highest_load_kN"], given["step_kN"])
    solved = solve(
        case(),
        inner_speed=np.repeat(speeds, loads.size) * RPM,
        fx=np.tile(loads, speeds.size) * KILO,
    )
    shape = speeds.size, loads.size
    inner, outer = solved.inner, solved.outer
    return _Sweep(
        speeds=speeds,
        loads=loads,
        solved=solved,
        inner_load=inner.load[:, 0].reshape(shape) / KILO,
        outer_load=outer.load[:, 0].reshape(shape) / KILO,
        inner_angle=np.degrees(inner.contact_angle[:, 0]).reshape(shape),
        outer_angle=np.degrees(outer.contact_angle[:, 0]).reshape(shape),
        shift=solved.displacement.x.reshape(shape) / MILLI,
        moment=np.abs(solved.elements.gyroscopic_moment[:, 0]).reshape(shape),
    )


def _with_speed_and_load(sweep: _Sweep, *columns: Series) -> tuple[Series, ...]:
    speeds, loads = sweep.speeds, sweep.loads
    return (
        Series(
            "inner_speed",
            "rpm",
            said("Inner ring speed n_i", "Rotação do anel interno n_i"),
            np.repeat(speeds, loads.size),
        ),
        Series(
            "axial_load",
            "kN",
            said("Axial load F_a", "Carga axial F_a"),
            np.tile(loads, speeds.size),
        ),
        *columns,
        status_column(sweep.solved.status.code),
    )


def _line_per_speed(sweep: _Sweep, y: str, dashed: str | None = None) -> tuple[Line, ...]:
    """Return a line for each speed; for two columns, the second dashed and without a label."""
    lines: list[Line] = []
    for look, speed in enumerate(sweep.speeds):
        label = same("{:,.0f} rpm", float(speed))
        by = ("inner_speed", float(speed))
        lines.append(Line(y, look, label, by, dashed=False))
        if dashed is not None:
            lines.append(Line(dashed, look, None, by, dashed=True))
    return tuple(lines)


def _axial_figure(
    number: str,
    caption: Text,
    columns: tuple[Series, ...],
    panel: Panel,
    claims: tuple[Claim, ...],
    notes: tuple[Text, ...] = (),
) -> Figure:
    return Figure(
        number=number,
        caption=caption,
        source=source_of("axial_at_speed"),
        columns=columns,
        picture=Curves((panel,)),
        claims=claims,
        notes=notes,
    )


def _angles(sweep: _Sweep) -> Figure:
    title = said("Contact angle α", "Ângulo de contato α")
    inner, outer = sweep.inner_angle, sweep.outer_angle
    loaded = slice(1, None)  # without load and at rest an angle is only a convention
    apart = bool((np.diff(inner, axis=0)[:, loaded] > 0.0).all()) and bool(
        (np.diff(outer, axis=0)[:, loaded] < 0.0).all()
    )
    return _axial_figure(
        "5.11",
        said(
            "The 218 under axial load at several speeds: contact angles at both races.",
            "218 sob carga axial em várias rotações: ângulos de contato nas duas pistas.",
        ),
        _with_speed_and_load(
            sweep,
            Series("inner_contact_angle", "°", title, inner.ravel()),
            Series("outer_contact_angle", "°", title, outer.ravel()),
        ),
        Panel(
            "axial_load",
            title,
            "°",
            _line_per_speed(sweep, "inner_contact_angle", "outer_contact_angle"),
            keys=_RACES,
        ),
        (
            Claim(
                said(
                    "A higher speed raises the angle at the inner race and lowers the one at the"
                    " outer race.",
                    "Uma rotação maior aumenta o ângulo na pista interna e diminui o da externa.",
                ),
                said(
                    "At 10 kN, from {:,.0f} to {:,.0f} rpm: α_i from {:.1f}° to {:.1f}°, α_o from"
                    " {:.1f}° to {:.1f}°.",
                    "A 10 kN, de {:,.0f} a {:,.0f} rpm: α_i de {:.1f}° a {:.1f}°, α_o de {:.1f}°"
                    " a {:.1f}°.",
                    *sweep.speeds[[0, -1]],
                    *_at_load(sweep, inner, 10.0)[[0, -1]],
                    *_at_load(sweep, outer, 10.0)[[0, -1]],
                ),
                apart,
            ),
            _towards_rest(sweep, np.abs(inner - inner[0]), same("α_i"), "°"),
        ),
        (
            said(
                "With no load and at rest the balls touch at the free angle of {:.0f}°.",
                "Sem carga e em repouso as esferas tocam no ângulo livre de {:.0f}°.",
                float(inner[0, 0]),
            ),
        ),
    )


def _ball_loads(sweep: _Sweep) -> Figure:
    title = said("Ball load Q", "Carga na esfera Q")
    outer = sweep.outer_load
    return _axial_figure(
        "5.12",
        said(
            "The 218 under axial load at several speeds: ball loads at both races.",
            "218 sob carga axial em várias rotações: cargas na esfera nas duas pistas.",
        ),
        _with_speed_and_load(
            sweep,
            Series("inner_load", "kN", title, sweep.inner_load.ravel()),
            Series("outer_load", "kN", title, outer.ravel()),
        ),
        Panel(
            "axial_load",
            title,
            "kN",
            _line_per_speed(sweep, "inner_load", "outer_load"),
            keys=_RACES,
        ),
        (
            Claim(
                said(
                    "A higher speed raises the load at the outer race.",
                    "Uma rotação maior aumenta a carga na pista externa.",
                ),
                said(
                    "At 10 kN, from {:,.0f} to {:,.0f} rpm: Q_o from {:.3f} to {:.3f} kN.",
                    "A 10 kN, de {:,.0f} a {:,.0f} rpm: Q_o de {:.3f} a {:.3f} kN.",
                    *sweep.speeds[[0, -1]],
                    *_at_load(sweep, outer, 10.0)[[0, -1]],
                ),
                bool((np.diff(outer, axis=0) > 0.0).all()),
            ),
            _towards_rest(sweep, np.abs(outer - outer[0]), same("Q_o"), " kN"),
        ),
    )


def _shifts(sweep: _Sweep) -> Figure:
    backward = [float(sweep.loads[row < 0.0].max(initial=0.0)) for row in sweep.shift]
    turning = sweep.speeds > 0.0
    return _axial_figure(
        "5.13",
        said(
            "The 218 under axial load at several speeds: axial displacement of the inner ring,"
            " counted from the first contact at rest.",
            "218 sob carga axial em várias rotações: deslocamento axial do anel interno, contado"
            " do primeiro contato em repouso.",
        ),
        _with_speed_and_load(
            sweep, Series("axial_displacement", "mm", _AXIAL_SHIFT, sweep.shift.ravel())
        ),
        Panel("axial_load", _AXIAL_SHIFT, "mm", _line_per_speed(sweep, "axial_displacement")),
        (
            Claim(
                said(
                    "At high speed and small axial load the displacement becomes negative.",
                    "Em alta rotação e com pequena carga axial o deslocamento torna-se negativo.",
                ),
                said(
                    "It is negative up to {:.1f} kN at {:,.0f} rpm and up to {:.1f} kN at"
                    " {:,.0f} rpm; never at rest.",
                    "É negativo até {:.1f} kN a {:,.0f} rpm e até {:.1f} kN a {:,.0f} rpm; nunca"
                    " em repouso.",
                    backward[-2],
                    float(sweep.speeds[-2]),
                    backward[-1],
                    float(sweep.speeds[-1]),
                ),
                bool((sweep.shift[turning, 1] < 0.0).all())
                and bool((sweep.shift[~turning] >= 0.0).all()),
            ),
        ),
    )


def _moments(sweep: _Sweep) -> Figure:
    loaded = slice(1, None)
    return _axial_figure(
        "5.14",
        said(
            "The 218 under axial load at several speeds: gyroscopic moment on a ball.",
            "218 sob carga axial em várias rotações: momento giroscópico na esfera.",
        ),
        _with_speed_and_load(
            sweep, Series("gyroscopic_moment", "N·m", _MOMENT, sweep.moment.ravel())
        ),
        Panel("axial_load", _MOMENT, "N·m", _line_per_speed(sweep, "gyroscopic_moment")),
        (
            Claim(
                said(
                    "A higher speed brings a greater gyroscopic moment.",
                    "Uma rotação maior gera um momento giroscópico maior.",
                ),
                said(
                    "At 10 kN: {:.3f} N·m at {:,.0f} rpm, {:.3f} N·m at {:,.0f} rpm.",
                    "A 10 kN: {:.3f} N·m a {:,.0f} rpm, {:.3f} N·m a {:,.0f} rpm.",
                    float(_at_load(sweep, sweep.moment, 10.0)[1]),
                    float(sweep.speeds[1]),
                    float(_at_load(sweep, sweep.moment, 10.0)[-1]),
                    float(sweep.speeds[-1]),
                ),
                bool((np.diff(sweep.moment[:, loaded], axis=0) > 0.0).all()),
            ),
        ),
        (
            said(
                "The size is drawn; its sign is negative, because the inner ring turns. It rises"
                " with the load at one speed, because the contact angle at the outer race does.",
                "Desenha-se o módulo; o sinal é negativo, pois o anel interno gira. A uma mesma"
                " rotação ele cresce com a carga, pois cresce o ângulo de contato na pista"
                " externa.",
            ),
        ),
    )


def _towards_rest(sweep: _Sweep, distance: Floats, symbol: Text, unit: str) -> Claim:
    """State how far a quantity is from its value at rest, at a small and at the maximum load."""
    small, great = float(_at_load(sweep, distance, 5.0)[-1]), float(distance[-1, -1])
    return Claim(
        said(
            "The greater the axial load, the nearer {} comes to its value at rest.",
            "Quanto maior a carga axial, mais {} se aproxima do valor em repouso.",
            symbol,
        ),
        said(
            "At {:,.0f} rpm it is {:.2f}{unit} away at 5 kN and {:.2f}{unit} at {:.0f} kN.",
            "A {:,.0f} rpm a distância é {:.2f}{unit} a 5 kN e {:.2f}{unit} a {:.0f} kN.",
            float(sweep.speeds[-1]),
            small,
            great,
            float(sweep.loads[-1]),
            unit=unit,
        ),
        great < small,
    )


def _at_load(sweep: _Sweep, values: Floats, load: float) -> Floats:
    """Return a quantity at one load, for every speed."""
    column: Floats = values[:, int(np.argmin(np.abs(sweep.loads - load)))]
    return column


_RADIAL_SHIFT = said("Radial displacement δ_z", "Deslocamento radial δ_z")


def shift_section(title: Text) -> Section:
    """Compute figures 5.25 and 5.26."""
    over_load, over_speed = _over_axial_load(), _over_speed()
    fall = _last_over_first(over_load)
    rise = _last_over_first(over_speed)
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
    solved = solve(case(duty), fx=loads * KILO)
    return (
        Series("axial_load", "kN", said("Axial load F_a", "Carga axial F_a"), loads),
        Series("radial_displacement", "mm", _RADIAL_SHIFT, solved.displacement.z / MILLI),
        status_column(solved.status.code),
    )


def _over_speed() -> tuple[Series, ...]:
    given = inputs_of("radial_over_speed")
    speeds = grid(given["lowest_speed_rpm"], given["highest_speed_rpm"], given["step_rpm"])
    load = Load(fx=given["axial_load_kN"] * KILO, fz=given["radial_load_kN"] * KILO)
    solved = solve(case(Duty(load=load)), inner_speed=speeds * RPM)
    return (
        Series(
            "inner_speed",
            "rpm",
            said("Inner ring speed n_i", "Rotação do anel interno n_i"),
            speeds,
        ),
        Series("radial_displacement", "mm", _RADIAL_SHIFT, solved.displacement.z / MILLI),
        status_column(solved.status.code),
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
        picture=_curve_over(columns, 10.0),
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
        picture=_curve_over(columns, 2500.0),
        claims=(
            Claim(
                said(
                    "The displacement grows with the speed.", "O deslocamento cresce com a rotação."
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


def _curve_over(columns: tuple[Series, ...], tick: float) -> Curves:
    x, y = columns[0], columns[1]
    return Curves((Panel(x.name, y.title, y.unit, (Line(y.name, 0),), tick=tick),))


def _last_over_first(columns: tuple[Series, ...]) -> float:
    """Last value over first."""
    shift = columns[1].numbers
    return float(shift[-1] / shift[0])
