"""The part of the report about balls that friction alone controls."""

from __future__ import annotations

import json
import re
from functools import lru_cache
from math import pi

import numpy as np
import pytest
from tests.one_case import said

from rolamento import Bearing, Case, Duty, Load, Lubricant, Model
from rolamento.document.medium import Medium
from rolamento.document.terminal import terminal
from rolamento.pages.state import state_page
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.solved.notes.advice import _friction_alone
from rolamento.solved.notes.balls import SKID_LIMIT
from rolamento.words import speaking

BOTH = pytest.mark.parametrize("language", ["en", "pt"])
HEADINGS = {"en": "Motion under friction", "pt": "Movimento sob atrito"}


@lru_cache(maxsize=8)
def solved(
    *,
    fx: float = 20e3,
    fz: float = 5e3,
    speed: float = 10_000.0,
    outer: float = 0.0,
    drag: float = 0.0,
    mu: float = 0.07,
    control: str = "friction",
    centrifugal: bool = True,
) -> Solved:
    bearing = Bearing(
        ball_count=9,
        ball_diameter="22.23 mm",
        pitch_diameter="125.26 mm",
        contact_angle="40 deg",
        inner_conformity=0.5232,
        outer_conformity=0.5232,
    )
    return solve(
        Case(
            bearing=bearing,
            duty=Duty(
                inner_speed=speed * pi / 30.0,
                outer_speed=outer * pi / 30.0,
                load=Load(fx=fx, fz=fz),
            ),
            model=Model(
                raceway_control=control,
                mesh="coarse",
                cage_drag=drag,
                centrifugal_force=centrifugal,
            ),
            lubricant=Lubricant(kind="dry", friction_coefficient=mu),
        )
    )


def plain(state: Solved, language: str = "en", width: int = 80) -> str:
    with speaking(language):
        return terminal(state_page(state), Medium(width=width))


def part(state: Solved, language: str = "en") -> list[str]:
    """The lines of the part, from its heading to the next empty line after its table."""
    lines = plain(state, language).splitlines()
    first = lines.index(HEADINGS[language])
    table = next(i for i in range(first, len(lines)) if lines[i] == "")
    last = next((i for i in range(table + 1, len(lines)) if lines[i] == ""), len(lines))
    return lines[first:last]


def number(text: str) -> float:
    return float(text.replace("−", "-").replace(" ", ""))


def test_cage_torque_and_losses_are_those_of_the_state() -> None:
    state = solved(drag=0.05)
    rolling = state.rolling
    assert rolling is not None
    text = " ".join(" ".join(part(state)).split())
    cage = re.search(r"cage ([\d ]+\.?\d*) rpm, ([\d.]+) % behind the ([\d ]+\.?\d*) rpm", text)
    assert cage is not None
    assert number(cage[1]) == pytest.approx(rolling.cage_speed[0] * 30.0 / pi, rel=1e-4)
    assert number(cage[2]) == pytest.approx(100.0 * rolling.skid[0], rel=1e-2)
    assert number(cage[3]) == pytest.approx(rolling.control_cage_speed[0] * 30.0 / pi, rel=1e-4)
    torque = re.search(r"torque ([\d ]+\.?\d*) N·mm on the shaft, (−?[\d ]+\.?\d*) N·mm", text)
    assert torque is not None
    assert number(torque[1]) == pytest.approx(1e3 * rolling.inner_torque[0], rel=1e-3)
    assert number(torque[2]) == pytest.approx(1e3 * rolling.outer_torque[0], rel=1e-3)
    power = re.search(r"losses ([\d ]+\.?\d*) W .*: ([\d ]+\.?\d*) W inner, ([\d ]+\.?\d*) W", text)
    assert power is not None
    assert number(power[1]) == pytest.approx(rolling.power[0], rel=1e-3)
    assert number(power[2]) + number(power[3]) == pytest.approx(rolling.power[0], rel=2e-3)
    drag = re.search(r"([\d ]+\.?\d*) W against the cage's drag", text)
    assert drag is not None
    assert number(drag[1]) == pytest.approx(0.05 * rolling.cage_speed[0], rel=1e-3)


def test_every_ball_has_its_motion() -> None:
    state = solved()
    assert state.rolling is not None
    rows = [line.split() for line in part(state) if re.match(r" +\d+ +\d+\.\d\d ", line)]
    elements, rolling = state.elements, state.rolling
    expected = np.stack(
        [
            np.degrees(elements.azimuth[0]), np.degrees(elements.attitude[0]),
            np.degrees(elements.yaw[0]), state.inner.spin_to_roll[0], state.outer.spin_to_roll[0],
            rolling.inner.power[0], rolling.outer.power[0],
        ],
        axis=1,
    )  # fmt: skip
    found = [[number(cell) for cell in cells[1:8]] for cells in rows]
    np.testing.assert_allclose(found, expected, atol=0.06, rtol=1e-2)


@BOTH
@pytest.mark.parametrize("width", [80, 120])
def test_no_line_is_too_wide(language: str, width: int) -> None:
    lines = plain(solved(drag=0.05), language, width).splitlines()
    assert max(map(len, lines)) == width
    assert all(line == line.rstrip() for line in lines)


@BOTH
def test_only_friction_control_has_the_part(language: str) -> None:
    assert HEADINGS[language] in plain(solved(), language)
    assert HEADINGS[language] not in plain(solved(control="outer"), language)
    alike = solved(outer=10_000.0)
    assert alike.rolling is None
    assert HEADINGS[language] not in plain(alike, language)


@BOTH
def test_a_cage_that_leads_is_said_to_lead(language: str) -> None:
    state = solved(fx=11e3, mu=0.005, fz=0.0)
    assert state.rolling is not None
    assert state.rolling.skid[0] < -SKID_LIMIT
    text = " ".join(part(state, language))
    assert {"en": "ahead of", "pt": "acima dos"}[language] in text
    note = next(note for note in state.notes[0] if note.key == "cage_skids")
    assert "faster than" in note.text
    assert said(note, language) in " ".join(plain(state, language).split())


@BOTH
def test_notes_of_friction_are_said_in_both_languages(language: str) -> None:
    states = [solved(), solved(fx=11e3, mu=0.005, fz=0.0), solved(outer=10_000.0)]
    marks = ("spin_at_both_races", "cage_skids", "friction_control_at_rest")
    for state, mark in zip(states, marks, strict=True):
        note = next(note for note in state.notes[0] if note.key == mark)
        assert (said(note, language) == note.text) == (language == "en")


@BOTH
def test_advice_when_friction_does_not_settle(language: str) -> None:
    state = solved(drag=1e4)
    assert state.status.code[0] == "not_converged"
    advice = said(state.advice[0], language)
    assert "model.mesh" in advice
    assert "lubricant.friction_coefficient" in advice
    assert (advice == said(state.advice[0])) == (language == "en")


@pytest.mark.parametrize("residual", [1e-12, 3e-2])
def test_advice_says_what_is_missing(residual: float) -> None:
    """A residual as small as a solution's is not what stands in the way."""
    advice = _friction_alone(residual)
    assert ("residual" in advice.text) == (residual > 1e-6)
    assert said(advice, "pt") != said(advice)


def test_a_ball_that_nothing_touches_has_dashes() -> None:
    state = solved(fx=5e3, fz=8e3, centrifugal=False, speed=100.0)
    assert state.rolling is not None
    loose = np.flatnonzero(state.outer.load[0] == 0.0)
    assert len(loose)
    rows = [line.split() for line in part(state) if re.match(r" +\d+ +\d+\.\d\d ", line)]
    assert rows[loose[0]][2:6] == ["–"] * 4
    assert rows[loose[0]][8:] == ["–"] * 2


def test_json_has_the_motion() -> None:
    state = solved(drag=0.05)
    rolling = json.loads(state.to_json())["rolling"]
    assert set(rolling) == {
        "cage_speed", "control_cage_speed", "skid", "inner_torque", "outer_torque", "power",
        "imbalance", "balls",
    }  # fmt: skip
    assert len(rolling["balls"]) == 9
    ball = rolling["balls"][0]
    assert set(ball) == {"angular_velocity", "yaw", "inner", "outer"}
    assert set(ball["inner"]) == {"power", "slip", "force_along", "force_across"}
    assert rolling["imbalance"] < 1e-6
    assert json.loads(solved(control="outer").to_json())["rolling"] is None
