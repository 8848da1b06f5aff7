"""Spin over roll at both contacts over the speed: the bearing of Ricci and Fleury under thrust."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Final

import numpy as np

from rolamento.case import Case
from rolamento.case.bearing import Bearing
from rolamento.case.duty import Duty, Load
from rolamento.case.model import Model
from rolamento.friction.harris_1971 import line_friction
from rolamento.friction.minimum_power import loaded_contacts, minimum_power_motion, start_of
from rolamento.friction.model import controlling_race, unit_motion
from rolamento.friction.slip import rolling_lines
from rolamento.friction.traction import ellipse_mesh
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.units import RPM
from rolamento_reproductions.given import MILLI, Given, grid
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

GIVEN: Final = Given("ricci_fleury")


def case(axial_load: float, speed_rpm: float, *, outer_conformity: float | None = None) -> Case:
    """Return a case of the bearing under thrust.

    Without the gyroscopic moment: Harris's model of 1971 has no force that could carry it, and
    the models of figure 8 are for speeds at which it is nothing.
    """
    given = GIVEN.inputs_of("bearing")
    conformity = given["conformity"]
    bearing = Bearing(
        ball_count=given["ball_count"],
        ball_diameter=given["ball_diameter_mm"] * MILLI,
        pitch_diameter=0.5 * (given["bore_mm"] + given["outside_mm"]) * MILLI,
        contact_angle=np.radians(given["contact_angle_deg"]),
        inner_conformity=conformity,
        outer_conformity=conformity if outer_conformity is None else outer_conformity,
    )
    return Case(
        bearing=bearing,
        duty=Duty(inner_speed=speed_rpm * RPM, load=Load(fx=axial_load)),
        model=Model(gyroscopic_moment=False),
    )


_POINTS = 400
"""Along the ellipse: Harris's model has slip along rolling only, one point across is exact."""


@dataclass(frozen=True, slots=True, eq=False)
class _Bearing:
    """One bearing over speed: ratios, lines of pure rolling in each contact, torque in N·m."""

    solved: Solved
    inner: Floats
    outer: Floats
    inner_lines: Floats
    outer_lines: Floats
    torque: Floats


def spin_section(title: Text) -> Section:
    """Compute figure 9."""
    return Section(title, (_spin_figure(),))


def _speeds() -> Floats:
    given = GIVEN.inputs_of("spin")
    return grid(given["lowest_speed_rpm"], given["highest_speed_rpm"], given["step_rpm"])


@cache
def _solved_over_speed(conformity: float, load: float | None = None) -> _Bearing:
    given = GIVEN.inputs_of("spin")
    speeds = _speeds()
    load = given["axial_load_N"] if load is None else load
    base = case(load, float(speeds[0]), outer_conformity=conformity)
    solved = solve(base, inner_speed=speeds * RPM)
    inner, outer, chosen = loaded_contacts(solved)
    start = start_of(unit_motion(solved, controlling_race(solved, "jones")), chosen)
    free = np.broadcast_to(np.eye(3), (*start.shape, 3))
    motion = minimum_power_motion(inner, outer, start, free, ellipse_mesh(_POINTS, 1))
    count = chosen.shape[1]
    ratios, lines = [], []
    power = np.zeros(inner.load.shape)
    for patch in (inner, outer):
        seen = motion.relative_motion(patch)
        power += line_friction(patch, seen).power
        ratios.append(seen.spin_to_roll[::count])
        lines.append(np.isfinite(rolling_lines(patch, seen)).sum(axis=-1)[::count].astype(float))
    # at a unit speed of the shaft the power is the torque
    torque = GIVEN.inputs_of("torque")["friction_coefficient"] * power.reshape(-1, count).sum(
        axis=1
    )
    return _Bearing(solved, ratios[0], ratios[1], lines[0], lines[1], torque)


def _spin_figure() -> Figure:
    given = GIVEN.inputs_of("spin")
    values = [float(f) for f in given["outer_conformities"]]
    found = [_solved_over_speed(value) for value in values]
    speeds = _speeds()
    columns = (
        Series(
            "outer_conformity",
            "",
            said("Outer conformity f_o", "Conformidade externa f_o"),
            np.repeat(values, speeds.size),
        ),
        Series(
            "inner_speed",
            "rpm",
            said("Shaft speed n", "Rotação do eixo n"),
            np.tile(speeds, len(values)),
        ),
        Series(
            "inner_spin_to_roll",
            "",
            said("inner", "interno"),
            np.concatenate([one.inner for one in found]),
        ),
        Series(
            "outer_spin_to_roll",
            "",
            said("outer", "externo"),
            np.concatenate([one.outer for one in found]),
        ),
        Series(
            "inner_rolling_lines",
            "",
            said("lines of pure rolling, inner", "linhas de rolamento puro, interno"),
            np.concatenate([one.inner_lines for one in found]),
        ),
        Series(
            "outer_rolling_lines",
            "",
            said("lines of pure rolling, outer", "linhas de rolamento puro, externo"),
            np.concatenate([one.outer_lines for one in found]),
        ),
        Series(
            "friction_torque",
            "N·mm",
            said("Friction torque T", "Torque de atrito T"),
            np.concatenate([one.torque for one in found]) / MILLI,
        ),
        Series(
            "status",
            "",
            said("status", "estado"),
            tuple(str(code) for one in found for code in one.solved.status.code),
        ),
    )
    return Figure(
        number="9",
        caption=said(
            "Spin over roll at both contacts over the shaft's speed, by Harris's model, under"
            " {:.0f} N of thrust: the bearing of figure 8, and the same with f_o = {:.2f}.",
            "Relação entre pivotamento e rolamento nos dois contatos em função da rotação do eixo,"
            " pelo modelo de Harris, sob {:.0f} N de carga axial: o rolamento da figura 8 e o mesmo"
            " com f_o = {:.2f}.",
            given["axial_load_N"],
            values[1],
        ),
        source=GIVEN.source_of("spin"),
        columns=columns,
        picture=Curves((_spin_panel(values),)),
        claims=(
            _improvement(values, found),
            _lines_of(found[0], values[0]),
            *_no_free_lunch(found),
        ),
        notes=(
            said(
                "Both contact angles are those at speed, with the balls' centrifugal force and"
                " without their gyroscopic moment, which friction along rolling alone cannot hold.",
                "Os dois ângulos de contato são os em rotação, com a força centrífuga das esferas e"
                " sem seu momento giroscópico, que o atrito só no sentido do rolamento não pode"
                " equilibrar.",
            ),
        ),
    )


def _spin_panel(values: list[float]) -> Panel:
    contacts = (
        ("inner_spin_to_roll", said("inner contact", "contato interno")),
        ("outer_spin_to_roll", said("outer contact", "contato externo")),
    )
    lines = tuple(
        Line(
            name, look, None if place else contact, ("outer_conformity", value), dashed=bool(place)
        )
        for place, value in enumerate(values)
        for look, (name, contact) in enumerate(contacts)
    )
    solid, dashed = (same("f_o = {:.3f}", value) for value in values)
    return Panel(
        "inner_speed",
        said("Spin over roll", "Pivotamento sobre rolamento"),
        "",
        lines,
        tick=5000.0,
        keys=(solid, dashed),
    )


def _improvement(values: list[float], found: list[_Bearing]) -> Claim:
    """Compare both contacts and the torque of the two bearings."""
    first, second = found
    better_in = second.inner < first.inner
    better_out = second.outer < first.outer
    cheaper = second.torque < first.torque
    share = [100.0 * float(np.mean(which)) for which in (better_in, better_out, cheaper)]
    return Claim(
        said(
            "With f_o = {:.2f} the ratios improve substantially.",
            "Com f_o = {:.2f} as relações melhoram substancialmente.",
            values[1],
        ),
        said(
            "Over the range of speeds the ratio is lower at the inner contact in {:.0f} % of it, at"
            " the outer in {:.0f} %; the torque, which heats, is lower in {:.0f} %, by"
            " {:.0f} % in the mean. The inner contact spins more than the outer from {:,.0f} rpm"
            " on, instead of {:,.0f} rpm. What spins less inside spins more outside, on a smaller"
            " ellipse.",
            "Na faixa de rotações a relação é menor no contato interno em {:.0f} % dela e no"
            " externo em {:.0f} %; o torque, que aquece, é menor em {:.0f} %, em média"
            " {:.0f} %. O contato interno pivota mais que o externo a partir de"
            " {:,.0f} rpm, em vez de {:,.0f} rpm. O que pivota menos na interna pivota mais na"
            " externa, em uma elipse menor.",
            *share,
            100.0 * (1.0 - float(np.mean(second.torque / first.torque))),
            _change(second),
            _change(first),
        ),
        holds=bool(np.all(better_in & better_out)),
        partly=share[0] > 50.0,
    )


def _change(one: _Bearing) -> float:
    """Return the minimum speed at which the inner contact spins more; rpm."""
    return float(_speeds()[np.argmax(one.inner > one.outer)])


def _lines_of(one: _Bearing, conformity: float) -> Claim:
    """Count the lines of pure rolling over speed."""
    heavier = float(GIVEN.inputs_of("spin")["heavier_load_N"])
    seen, under_more = _pairs(one), _pairs(_solved_over_speed(conformity, heavier))
    stated = [(2, 1), (1, 1), (1, 2)]
    return Claim(
        said(
            "Where the inner race holds the ball, the inner contact has two lines of pure rolling"
            " and the outer one; where the outer race holds it, the reverse; in between there is"
            " one in each.",
            "Onde a pista interna controla, o contato interno tem duas linhas de rolamento puro e o"
            " externo uma; onde a externa controla, o contrário; na transição há uma em cada.",
        ),
        said(
            "Lines inside/outside with rising speed, f_o = f_i: {} at the load of the figure; {}"
            " under {:.0f} N. It depends on the load.",
            "Linhas interno/externo com rotação crescente, f_o = f_i: {} com a carga da figura; {}"
            " sob {:.0f} N. Depende da carga.",
            _pairs_in_words(seen),
            _pairs_in_words(under_more),
            heavier,
        ),
        holds=seen == stated and under_more == stated,
        partly=stated in (seen, under_more),
    )


def _pairs(one: _Bearing) -> list[tuple[int, int]]:
    """Return how many lines the contacts have, inner and outer, in the order of appearance."""
    pairs = zip(one.inner_lines.tolist(), one.outer_lines.tolist(), strict=True)
    return list(dict.fromkeys((int(inner), int(outer)) for inner, outer in pairs))


def _pairs_in_words(pairs: list[tuple[int, int]]) -> str:
    return ", ".join(f"{inner}/{outer}" for inner, outer in pairs)


def _no_free_lunch(found: list[_Bearing]) -> tuple[Claim, ...]:
    """The contacts' angles leave a sum to be shared: no bearing here rolls purely on both."""
    minimum = min(float((one.inner + one.outer).min()) for one in found)
    return (
        Claim(
            said(
                "The two ratios cannot vanish together: races that stand at an angle to the shaft"
                " leave spin to be shared out between the contacts.",
                "As duas relações não podem anular-se juntas: pistas inclinadas em relação ao eixo"
                " deixam um pivotamento a repartir entre os contatos.",
            ),
            said(
                "Their sum is nowhere below {:.3f}.",
                "Sua soma não é menor que {:.3f} em parte alguma.",
                minimum,
            ),
            minimum > 0.05,
            of_theory=True,
        ),
    )
