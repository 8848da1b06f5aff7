"""Speeds of cage and balls, equations 19 to 24 and 48 to 50, beside those of the 218 solved."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache
from typing import Literal

import numpy as np

from rolamento.case import Case
from rolamento.case.bearing import Bearing
from rolamento.case.duty import Duty, Load
from rolamento.case.lubricant import Lubricant
from rolamento.case.model import Model
from rolamento.friction.slip import Patch, RelativeMotion, solved_motion
from rolamento.geometry import Race
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.units import RPM
from rolamento_reproductions.braga_almeida.inputs import GIVEN, said
from rolamento_reproductions.braga_almeida.misprints import Orbits
from rolamento_reproductions.given import KILO, MILLI, grid
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
from rolamento_reproductions.text import Text, same

Control = Literal["outer", "friction"]


def bearing() -> Bearing:
    """Return the 218."""
    given = GIVEN.inputs_of("bearing")
    return Bearing(
        ball_count=given["ball_count"],
        ball_diameter=given["ball_diameter_mm"] * MILLI,
        pitch_diameter=given["pitch_diameter_mm"] * MILLI,
        contact_angle=np.radians(given["contact_angle_deg"]),
        inner_conformity=given["conformity"],
        outer_conformity=given["conformity"],
    )


@dataclass(frozen=True, slots=True)
class Ball:
    """One ball of the solved bearing; under thrust all are alike."""

    solved: Solved

    @property
    def speed(self) -> float:
        """Speed of the inner ring; rad/s."""
        return self.solved.case.duty.inner_speed

    @property
    def orbit(self) -> float:
        """Speed of the cage; rad/s."""
        return float(self.solved.elements.orbital_speed[0, 0])

    @property
    def ball_speed(self) -> float:
        """ω_R, negative: against the orbit; rad/s."""
        return float(self.solved.elements.ball_speed[0, 0])

    @property
    def attitude(self) -> float:
        """β; rad."""
        return float(self.solved.elements.attitude[0, 0])

    @property
    def yaw(self) -> float:
        """β′; rad."""
        return float(self.solved.elements.yaw[0, 0])

    @property
    def velocity(self) -> tuple[float, float, float]:
        """Seen from the cage, along x, the orbit and outward; rad/s."""
        across = self.ball_speed * np.cos(self.attitude)
        outward = -self.ball_speed * np.sin(self.attitude)
        return float(across * np.cos(self.yaw)), float(across * np.sin(self.yaw)), float(outward)

    def patch(self, race: Race) -> Patch:
        """The contact with a race, arrays of one."""
        return Patch.of(self.solved.contacts[race]).mapped(lambda array: array[0, :1])

    def motion(self, race: Race) -> RelativeMotion:
        """How the race moves relative to the ball, arrays of one."""
        found = solved_motion(self.solved, race)
        parts = ("drift", "roll", "twist", "tumble")
        return replace(found, **{name: getattr(found, name)[0, :1] for name in parts})

    def rolling_radius(self, race: Race) -> float:
        """r′ of (37), where ball and race would move alike on the normal; m."""
        motion = self.motion(race)
        return float(-motion.drift[0] / (motion.side * motion.roll[0]))

    def orbits(self, *, idle: bool = False, beta: Floats | None = None, yaw: float = 0.0) -> Orbits:
        """Equations 48 to 50 for this ball.

        idle: with rolling radii of D/2 and β′ = 0; beta: at other attitudes, with that yaw.
        """
        half = 0.5 * self.solved.case.bearing.element_diameter
        one = np.ones(1) if beta is None else np.ones_like(beta)
        inner, outer = self.patch("inner"), self.patch("outer")
        return Orbits(
            pitch_radius=0.5 * self.solved.case.bearing.pitch_diameter * one,
            r_e=(half if idle else self.rolling_radius("outer")) * one,
            r_i=(half if idle else self.rolling_radius("inner")) * one,
            theta_e=outer.contact_angle * one,
            theta_i=inner.contact_angle * one,
            beta=self.attitude * one if beta is None else beta,
            yaw=(0.0 if idle else self.yaw) * one if beta is None else yaw * one,
            speed=self.speed * one,
        )


@cache
def ball(
    control: Control, speed_rpm: float | None = None, friction_coefficient: float | None = None
) -> Ball:
    """Solve the bearing and return a ball; speed and friction of figure 3.1 by default."""
    given = GIVEN.inputs_of("contacts")
    speed = RPM * (given["inner_speed_rpm"] if speed_rpm is None else speed_rpm)
    mu = given["friction_coefficient"] if friction_coefficient is None else friction_coefficient
    case = Case(
        bearing=bearing(),
        duty=Duty(inner_speed=speed, load=Load(fx=given["axial_load_kN"] * KILO)),
        model=Model(raceway_control=control),
        lubricant=Lubricant(kind="dry", friction_coefficient=mu),
    )
    return Ball(solve(case))


_NOTICED = 0.005
"""A change of a frequency that a spectrum shows."""
_WAYS = (
    ("equations", said("ways.equations")),
    ("outer_control", said("ways.outer_control")),
    ("friction", said("ways.friction")),
)


def speeds_section(title: Text) -> Section:
    """Compute figures 2.1 and 2.2 and table 2.1."""
    given = GIVEN.inputs_of("speeds")
    speeds = grid(given["lowest_rpm"], given["highest_rpm"], given["step_rpm"])
    solved = {
        "outer_control": [ball("outer", float(n)) for n in speeds],
        "friction": [ball("friction", float(n)) for n in speeds],
    }
    return Section(
        title, (_cage_figure(speeds, solved), _ball_figure(speeds, solved), _table_of_frequencies())
    )


def _gamma() -> float:
    rings = bearing()
    angle = np.radians(GIVEN.inputs_of("bearing")["contact_angle_deg"])
    return float(rings.ball_diameter * np.cos(angle) / rings.pitch_diameter)


def _by_equations() -> tuple[float, float]:
    """n_m/n_i and n_R/n_i by (23) and (24), at the free contact angle."""
    rings, gamma = bearing(), _gamma()
    cage = 0.5 * (1.0 - gamma)
    return cage, -0.5 * rings.pitch_diameter / rings.ball_diameter * (1.0 - gamma**2)


def _speed_figure(
    number: str, caption: Text, title: Text, speeds: Floats, values: dict[str, Floats]
) -> Figure:
    columns = (
        Series("inner_speed", "rpm", said("speed_figure.inner_speed"), speeds),
        *(Series(name, "", label, values[name]) for name, label in _WAYS),
        Series(
            "status",
            "",
            said("speed_figure.status"),
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


def _cage_figure(speeds: Floats, solved: dict[str, list[Ball]]) -> Figure:
    values = {
        name: np.array([one.orbit / one.speed for one in balls]) for name, balls in solved.items()
    }
    values["equations"] = np.full(speeds.size, _by_equations()[0])
    figure = _speed_figure(
        "2.1",
        said("figure_2_1.caption", axial_load_kn=GIVEN.inputs_of("contacts")["axial_load_kN"]),
        said("figure_2_1.cage_speed_n"),
        speeds,
        values,
    )
    return replace(figure, claims=(_other_motions(speeds, values),))


def _other_motions(speeds: Floats, values: dict[str, Floats]) -> Claim:
    change = values["friction"] / values["equations"] - 1.0
    worst = int(np.argmax(np.abs(change)))
    among = np.abs(values["friction"] / values["outer_control"] - 1.0)
    return Claim(
        said("other_motions.statement"),
        said(
            "other_motions.finding",
            change=100.0 * float(change[worst]),
            speeds=float(speeds[worst]),
            among_max=100.0 * float(among.max()),
        ),
        bool(abs(change[worst]) > _NOTICED),
    )


def _ball_figure(speeds: Floats, solved: dict[str, list[Ball]]) -> Figure:
    values = {
        name: np.array([-one.ball_speed / one.speed for one in balls])
        for name, balls in solved.items()
    }
    values["equations"] = np.full(speeds.size, -_by_equations()[1])
    return _speed_figure(
        "2.2", said("figure_2_2.caption"), said("figure_2_2.ball_speed_n"), speeds, values
    )


def _table_of_frequencies() -> Table:
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
        said("table_of_frequencies.cage"),
        said("table_of_frequencies.ball_about_itself"),
        said("table_of_frequencies.balls_passing_outer"),
        said("table_of_frequencies.balls_passing_inner"),
    )
    values = [
        [turns * ratio for ratio in (cage, spin, count * cage, count * (1.0 - cage))]
        for cage, spin in ways
    ]
    return Table(
        number="2.1",
        caption=said("table_of_frequencies.caption", speed_rpm=speed_rpm),
        source=GIVEN.source_of("speeds"),
        columns=(
            TableColumn("part", said("table_of_frequencies.part"), parts),
            *(
                TableColumn(f"{name}_Hz", title, tuple(f"{value:.2f}" for value in column))
                for (name, title), column in zip(_WAYS, values, strict=True)
            ),
        ),
        notes=(same("BPFO = Z n_m/60, BPFI = Z (n_i − n_m)/60."),),
    )


_ROUNDING = 1e-12
_ORBIT_FIGURES = (
    ("5.1", "orbital_speed", said("figure_5_1"), said("figure_5_1.cage_speed_by")),
    ("5.2", "ball_speed", said("figure_5_2"), said("figure_5_2.ball_speed_by")),
)


def orbit_section(title: Text) -> Section:
    """Compute figures 5.1 and 5.2 and table 5.1."""
    return Section(title, (*(_orbit_figure(*what) for what in _ORBIT_FIGURES), _orbit_table()))


def _orbit_figure(number: str, name: str, title: Text, words: Text) -> Figure:
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
        Series("yaw", "°", same("β′"), np.repeat(yaws, degrees.size)),
        Series("attitude", "°", said("orbit_figure.attitude"), np.tile(degrees, len(yaws))),
        Series(name, "", title, value),
    ]
    lines = [
        Line(name, look, same("β′ = {:.0f}°", yaw), ("yaw", yaw)) for look, yaw in enumerate(yaws)
    ]
    if name == "orbital_speed":
        columns.append(Series("as_printed", "", said("48_as_printed"), printed))
        label = said("orbit_figure.from_48_as")
        lines.append(Line("as_printed", len(yaws), label, ("yaw", yaws[0])))
    return Figure(
        number=number,
        caption=said(
            "orbit_figure.caption",
            words=words,
            one_attitude=float(np.degrees(one.attitude)),
            ball_attitude=float(np.degrees(ball("outer").attitude)),
        ),
        source=GIVEN.source_of("orbit"),
        columns=tuple(columns),
        picture=Curves((Panel("attitude", title, "", tuple(lines), tick=10.0, from_zero=False),)),
    )


def _orbit_table() -> Table:
    one = ball("friction")
    exact, idle = one.orbits(), one.orbits(idle=True)
    cage = one.orbit / one.speed
    turning = one.ball_speed / one.speed

    def ratio(value: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> float:
        return float(value[0]) / one.speed

    columns = (
        ("solved", said("orbit_table.solved"), cage, turning),
        (
            "equations",
            said("orbit_table.equations"),
            -ratio(exact.outer_speed()),
            ratio(exact.ball_speed()),
        ),
        (
            "equations_idle",
            said("orbit_table.equations_idle"),
            -ratio(idle.outer_speed()),
            ratio(idle.ball_speed()),
        ),
        (
            "as_printed",
            said("48_as_printed"),
            1.0 - ratio(exact.inner_speed_printed()),
            float("nan"),
        ),
    )
    gap = max(abs(columns[1][2] / cage - 1.0), abs(columns[1][3] / turning - 1.0))
    off = columns[3][2] / cage - 1.0
    return Table(
        number="5.1",
        caption=said("orbit_table.caption"),
        source=GIVEN.source_of("orbit"),
        columns=(
            TableColumn("quantity", said("quantity"), (same("ω_m/ω"), same("ω_R/ω"))),
            *(
                TableColumn(
                    name, title, tuple("" if np.isnan(v) else f"{v:.6f}" for v in (first, second))
                )
                for name, title, first, second in columns
            ),
        ),
        claims=(
            Claim(
                said("orbit_table.statement"),
                said("orbit_table.finding", off=100.0 * off),
                holds=gap < _ROUNDING and abs(off) < _ROUNDING,
                partly=gap < _ROUNDING,
            ),
        ),
    )
