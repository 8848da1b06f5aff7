"""Figures 5.11 to 5.14: the 218 under axial load at several speeds."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rolamento.rows.ball import BatchState, solve_batch
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

__all__ = ["axial_section"]

_RACES = (said("inner race", "pista interna"), said("outer race", "pista externa"))
_SHIFT = said("Axial displacement δ_a", "Deslocamento axial δ_a")
_MOMENT = said("Gyroscopic moment |M_g|", "Momento giroscópico |M_g|")


@dataclass(frozen=True, slots=True, eq=False)
class _Sweep:
    """All speeds and loads solved: arrays (speeds, loads); the balls of a case are alike."""

    speeds: Floats
    loads: Floats
    state: BatchState
    inner_load: Floats
    outer_load: Floats
    inner_angle: Floats
    outer_angle: Floats
    shift: Floats
    moment: Floats


def axial_section(title: Text) -> Section:
    """Compute figures 5.11 to 5.14."""
    sweep = _sweep()
    return Section(title, (_angles(sweep), _ball_loads(sweep), _shifts(sweep), _moments(sweep)))


def _sweep() -> _Sweep:
    given = inputs_of("axial_at_speed")
    speeds = np.asarray(given["speeds_rpm"], dtype=np.float64)
    loads = grid(0.0, given["highest_load_kN"], given["step_kN"])
    state = solve_batch(
        case(),
        inner_speed=np.repeat(speeds, loads.size) * RPM,
        fx=np.tile(loads, speeds.size) * KILO,
    )
    balls = state.balls()
    shape = speeds.size, loads.size
    inner, outer = balls.inner, balls.outer
    return _Sweep(
        speeds=speeds,
        loads=loads,
        state=state,
        inner_load=inner.load[:, 0].reshape(shape) / KILO,
        outer_load=outer.load[:, 0].reshape(shape) / KILO,
        inner_angle=np.degrees(inner.contact_angle[:, 0]).reshape(shape),
        outer_angle=np.degrees(outer.contact_angle[:, 0]).reshape(shape),
        shift=state.displacement[:, 0].reshape(shape) / MILLI,
        moment=np.abs(balls.gyroscopic_moment[:, 0]).reshape(shape),
    )


def _columns(sweep: _Sweep, *columns: Series) -> tuple[Series, ...]:
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
        status_column(sweep.state),
    )


def _lines(sweep: _Sweep, y: str, dashed: str | None = None) -> tuple[Line, ...]:
    """Return a line for each speed; for two columns, the second dashed and without a label."""
    lines: list[Line] = []
    for look, speed in enumerate(sweep.speeds):
        label = said("{:,.0f} rpm", "{:,.0f} rpm", float(speed))
        by = ("inner_speed", float(speed))
        lines.append(Line(y, look, label, by, dashed=False))
        if dashed is not None:
            lines.append(Line(dashed, look, None, by, dashed=True))
    return tuple(lines)


def _figure(
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
    return _figure(
        "5.11",
        said(
            "The 218 under axial load at several speeds: contact angles at both races.",
            "218 sob carga axial em várias rotações: ângulos de contato nas duas pistas.",
        ),
        _columns(
            sweep,
            Series("inner_contact_angle", "°", title, inner.ravel()),
            Series("outer_contact_angle", "°", title, outer.ravel()),
        ),
        Panel(
            "axial_load",
            title,
            "°",
            _lines(sweep, "inner_contact_angle", "outer_contact_angle"),
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
                    *_at(sweep, inner, 10.0)[[0, -1]],
                    *_at(sweep, outer, 10.0)[[0, -1]],
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
    return _figure(
        "5.12",
        said(
            "The 218 under axial load at several speeds: ball loads at both races.",
            "218 sob carga axial em várias rotações: cargas na esfera nas duas pistas.",
        ),
        _columns(
            sweep,
            Series("inner_load", "kN", title, sweep.inner_load.ravel()),
            Series("outer_load", "kN", title, outer.ravel()),
        ),
        Panel("axial_load", title, "kN", _lines(sweep, "inner_load", "outer_load"), keys=_RACES),
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
                    *_at(sweep, outer, 10.0)[[0, -1]],
                ),
                bool((np.diff(outer, axis=0) > 0.0).all()),
            ),
            _towards_rest(sweep, np.abs(outer - outer[0]), same("Q_o"), " kN"),
        ),
    )


def _shifts(sweep: _Sweep) -> Figure:
    backward = [float(sweep.loads[row < 0.0].max(initial=0.0)) for row in sweep.shift]
    turning = sweep.speeds > 0.0
    return _figure(
        "5.13",
        said(
            "The 218 under axial load at several speeds: axial displacement of the inner ring,"
            " counted from the first contact at rest.",
            "218 sob carga axial em várias rotações: deslocamento axial do anel interno, contado"
            " do primeiro contato em repouso.",
        ),
        _columns(sweep, Series("axial_displacement", "mm", _SHIFT, sweep.shift.ravel())),
        Panel("axial_load", _SHIFT, "mm", _lines(sweep, "axial_displacement")),
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
    return _figure(
        "5.14",
        said(
            "The 218 under axial load at several speeds: gyroscopic moment on a ball.",
            "218 sob carga axial em várias rotações: momento giroscópico na esfera.",
        ),
        _columns(sweep, Series("gyroscopic_moment", "N·m", _MOMENT, sweep.moment.ravel())),
        Panel("axial_load", _MOMENT, "N·m", _lines(sweep, "gyroscopic_moment")),
        (
            Claim(
                said(
                    "A higher speed brings a greater gyroscopic moment.",
                    "Uma rotação maior gera um momento giroscópico maior.",
                ),
                said(
                    "At 10 kN: {:.3f} N·m at {:,.0f} rpm, {:.3f} N·m at {:,.0f} rpm.",
                    "A 10 kN: {:.3f} N·m a {:,.0f} rpm, {:.3f} N·m a {:,.0f} rpm.",
                    float(_at(sweep, sweep.moment, 10.0)[1]),
                    float(sweep.speeds[1]),
                    float(_at(sweep, sweep.moment, 10.0)[-1]),
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
    """State how far a quantity is from its value at rest, at a small and at the greatest load."""
    small, great = float(_at(sweep, distance, 5.0)[-1]), float(distance[-1, -1])
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


def _at(sweep: _Sweep, values: Floats, load: float) -> Floats:
    """Return a quantity at one load, for every speed."""
    column: Floats = values[:, int(np.argmin(np.abs(sweep.loads - load)))]
    return column
