"""Figures 5.11 to 5.14, 5.25 and 5.26: the 218 at speed under axial load, and radial with it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rolamento.case.duty import Duty, Load
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.units import RPM
from rolamento_reproductions.given import KILO, MILLI, grid, status_column
from rolamento_reproductions.radaelli_2013.inputs import case, inputs_of, said, source_of
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
from rolamento_reproductions.text import Text, same

_RACES = (said("races.inner_race"), said("races.outer_race"))
_AXIAL_SHIFT = said("axial_displacement_delta")
_MOMENT = said("gyroscopic_moment_m_g")


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
        Series("inner_speed", "rpm", said("inner_ring_speed_n"), np.repeat(speeds, loads.size)),
        Series("axial_load", "kN", said("axial_load_f"), np.tile(loads, speeds.size)),
        *columns,
        status_column(sweep.solved.status.code),
    )


def _line_per_speed(sweep: _Sweep, y: str, dashed: str | None = None) -> tuple[Line, ...]:
    """Return a line for each speed; for two columns, the second dashed and without a label."""
    lines: list[Line] = []
    for look, speed in enumerate(sweep.speeds):
        label = same("{:.0f} rpm", float(speed))
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
    title = said("contact_angle")
    inner, outer = sweep.inner_angle, sweep.outer_angle
    loaded = slice(1, None)  # without load and at rest an angle is only a convention
    apart = bool((np.diff(inner, axis=0)[:, loaded] > 0.0).all()) and bool(
        (np.diff(outer, axis=0)[:, loaded] < 0.0).all()
    )
    return _axial_figure(
        "5.11",
        said("figure_5_11.caption"),
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
                said("angles.statement"),
                said(
                    "angles.finding",
                    *sweep.speeds[[0, -1]],
                    *_at_load(sweep, inner, 10.0)[[0, -1]],
                    *_at_load(sweep, outer, 10.0)[[0, -1]],
                ),
                apart,
            ),
            _towards_rest(sweep, np.abs(inner - inner[0]), same("α_i"), "°"),
        ),
        (said("figure_5_11.with_no_load", inner=float(inner[0, 0])),),
    )


def _ball_loads(sweep: _Sweep) -> Figure:
    title = said("ball_load_q")
    outer = sweep.outer_load
    return _axial_figure(
        "5.12",
        said("figure_5_12.caption"),
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
                said("ball_loads.statement"),
                said(
                    "ball_loads.finding",
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
        said("figure_5_13.caption"),
        _with_speed_and_load(
            sweep, Series("axial_displacement", "mm", _AXIAL_SHIFT, sweep.shift.ravel())
        ),
        Panel("axial_load", _AXIAL_SHIFT, "mm", _line_per_speed(sweep, "axial_displacement")),
        (
            Claim(
                said("shifts.statement"),
                said(
                    "shifts.finding",
                    backward_1=backward[-2],
                    speeds_1=float(sweep.speeds[-2]),
                    backward_2=backward[-1],
                    speeds_2=float(sweep.speeds[-1]),
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
        said("figure_5_14.caption"),
        _with_speed_and_load(
            sweep, Series("gyroscopic_moment", "N·m", _MOMENT, sweep.moment.ravel())
        ),
        Panel("axial_load", _MOMENT, "N·m", _line_per_speed(sweep, "gyroscopic_moment")),
        (
            Claim(
                said("moments.statement"),
                said(
                    "moments.finding",
                    at_load_1=float(_at_load(sweep, sweep.moment, 10.0)[1]),
                    speeds_1=float(sweep.speeds[1]),
                    at_load_2=float(_at_load(sweep, sweep.moment, 10.0)[-1]),
                    speeds_2=float(sweep.speeds[-1]),
                ),
                bool((np.diff(sweep.moment[:, loaded], axis=0) > 0.0).all()),
            ),
        ),
        (said("figure_5_14.size_is_drawn"),),
    )


def _towards_rest(sweep: _Sweep, distance: Floats, symbol: Text, unit: str) -> Claim:
    """State how far a quantity is from its value at rest, at a small and at the maximum load."""
    small, great = float(_at_load(sweep, distance, 5.0)[-1]), float(distance[-1, -1])
    return Claim(
        said("towards_rest.statement", symbol=symbol),
        said(
            "towards_rest.finding",
            speeds=float(sweep.speeds[-1]),
            small=small,
            great=great,
            loads=float(sweep.loads[-1]),
            unit=unit,
        ),
        great < small,
    )


def _at_load(sweep: _Sweep, values: Floats, load: float) -> Floats:
    """Return a quantity at one load, for every speed."""
    column: Floats = values[:, int(np.argmin(np.abs(sweep.loads - load)))]
    return column


_RADIAL_SHIFT = said("radial_shift.radial_displacement_delta")


def shift_section(title: Text) -> Section:
    """Compute figures 5.25 and 5.26."""
    over_load, over_speed = _over_axial_load(), _over_speed()
    fall = _last_over_first(over_load)
    rise = _last_over_first(over_speed)
    weaker = Claim(
        said("shift_section.statement"),
        said("shift_section.finding", rise=rise, fall=1.0 / fall),
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
        Series("axial_load", "kN", said("axial_load_f"), loads),
        Series("radial_displacement", "mm", _RADIAL_SHIFT, solved.displacement.z / MILLI),
        status_column(solved.status.code),
    )


def _over_speed() -> tuple[Series, ...]:
    given = inputs_of("radial_over_speed")
    speeds = grid(given["lowest_speed_rpm"], given["highest_speed_rpm"], given["step_rpm"])
    load = Load(fx=given["axial_load_kN"] * KILO, fz=given["radial_load_kN"] * KILO)
    solved = solve(case(Duty(load=load)), inner_speed=speeds * RPM)
    return (
        Series("inner_speed", "rpm", said("inner_ring_speed_n"), speeds),
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
            "figure_over_load.caption",
            radial_load_kn=given["radial_load_kN"],
            inner_speed_rpm=given["inner_speed_rpm"],
        ),
        source=source_of("radial_over_axial_load"),
        columns=columns,
        picture=_curve_over(columns, 10.0),
        claims=(
            Claim(
                said("figure_over_load.statement", low=low, high=high),
                said("figure_over_load.finding", at_low=at_low, at_high=at_high, fall=fall),
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
            "figure_over_speed.caption",
            radial_load_kn=given["radial_load_kN"],
            axial_load_kn=given["axial_load_kN"],
        ),
        source=source_of("radial_over_speed"),
        columns=columns,
        picture=_curve_over(columns, 2500.0),
        claims=(
            Claim(
                said("figure_over_speed.statement"),
                said(
                    "figure_over_speed.finding",
                    shift_1=float(shift[0]),
                    speeds_1=float(speeds[0]),
                    shift_2=float(shift[-1]),
                    speeds_2=float(speeds[-1]),
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
