"""Spin over roll at both contacts over the speed: the bearing of Ricci and Fleury under thrust."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

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
from rolamento_reproductions.given import MILLI, grid
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
from rolamento_reproductions.ricci_fleury.inputs import GIVEN, said
from rolamento_reproductions.text import Text, same


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
            said("spin_figure.outer_conformity"),
            np.repeat(values, speeds.size),
        ),
        Series("inner_speed", "rpm", said("spin_figure.inner_speed"), np.tile(speeds, len(values))),
        Series(
            "inner_spin_to_roll",
            "",
            said("spin_figure.inner_spin_to_roll"),
            np.concatenate([one.inner for one in found]),
        ),
        Series(
            "outer_spin_to_roll",
            "",
            said("spin_figure.outer_spin_to_roll"),
            np.concatenate([one.outer for one in found]),
        ),
        Series(
            "inner_rolling_lines",
            "",
            said("spin_figure.inner_rolling_lines"),
            np.concatenate([one.inner_lines for one in found]),
        ),
        Series(
            "outer_rolling_lines",
            "",
            said("spin_figure.outer_rolling_lines"),
            np.concatenate([one.outer_lines for one in found]),
        ),
        Series(
            "friction_torque",
            "N·mm",
            said("friction_torque_t"),
            np.concatenate([one.torque for one in found]) / MILLI,
        ),
        Series(
            "status",
            "",
            said("spin_figure.status"),
            tuple(str(code) for one in found for code in one.solved.status.code),
        ),
    )
    return Figure(
        number="9",
        caption=said("spin_figure.caption", axial_load_n=given["axial_load_N"], values=values[1]),
        source=GIVEN.source_of("spin"),
        columns=columns,
        picture=Curves((_spin_panel(values),)),
        claims=(
            _improvement(values, found),
            _lines_of(found[0], values[0]),
            *_no_free_lunch(found),
        ),
        notes=(said("spin_figure.both_contact_angles"),),
    )


def _spin_panel(values: list[float]) -> Panel:
    contacts = (
        ("inner_spin_to_roll", said("spin_panel.inner_spin_to_roll")),
        ("outer_spin_to_roll", said("spin_panel.outer_spin_to_roll")),
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
        "inner_speed", said("spin_panel.y_title"), "", lines, tick=5000.0, keys=(solid, dashed)
    )


def _improvement(values: list[float], found: list[_Bearing]) -> Claim:
    """Compare both contacts and the torque of the two bearings."""
    first, second = found
    better_in = second.inner < first.inner
    better_out = second.outer < first.outer
    cheaper = second.torque < first.torque
    share = [100.0 * float(np.mean(which)) for which in (better_in, better_out, cheaper)]
    return Claim(
        said("improvement.statement", values=values[1]),
        said(
            "improvement.finding",
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
        said("lines_of.statement"),
        said(
            "lines_of.finding",
            seen_pairs_in_words=_pairs_in_words(seen),
            under_more_pairs_in_words=_pairs_in_words(under_more),
            heavier=heavier,
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
            said("no_free_lunch.statement"),
            said("no_free_lunch.finding", minimum=minimum),
            minimum > 0.05,
            of_theory=True,
        ),
    )
