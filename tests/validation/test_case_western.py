"""Fault frequencies of the bearings of public test rigs: Case Western's, and others."""

from __future__ import annotations

from math import radians
from typing import Any

import pytest

from rolamento import Bearing
from rolamento.units import to_si
from rolamento.verification import Check
from rolamento.verification.check import half_unit, published
from rolamento.verification.rigs import (
    case_western_checks,
    frequency,
    multiples,
    rig_checks,
    room_of_rounding,
)
from rolamento.vibration.frequencies import LINES, nominal_frequencies

CHECKS = tuple(case_western_checks())
RIG_CHECKS = tuple(rig_checks())
RIGS = published("rigs")["rig"]
PRINTED = [(rig, line) for rig in RIGS for line in rig["printed"]]
IDS = [f"{rig['source']}, {line}" for rig, line in PRINTED]
EACH = pytest.mark.parametrize(("rig", "line"), PRINTED, ids=IDS)


@pytest.mark.parametrize("check", CHECKS + RIG_CHECKS, ids=lambda c: f"{c.source}, {c.quantity}")
def test_printed_number(check: Check) -> None:
    assert check.verdict == "agrees", check


def test_all_that_is_printed_is_compared() -> None:
    printed = [m for b in published("case_western")["bearing"] for m in b["multiples"].values()]
    assert [check.printed for check in CHECKS] == printed
    assert [check.printed for check in RIG_CHECKS] == [r["printed"][line] for r, line in PRINTED]


def test_the_tolerance_is_not_so_wide_that_anything_fits() -> None:
    assert all(check.tolerance < 1e-3 * float(check.printed) for check in CHECKS)
    assert all(check.tolerance < 0.004 * float(check.printed) for check in RIG_CHECKS
               if check.explanation)  # fmt: skip


def test_every_ball_strikes_each_race_once_a_turn() -> None:
    found = multiples(0.2, 9)
    assert found["inner_race"] + found["outer_race"] == pytest.approx(9.0, rel=1e-14)
    assert found["cage"] == pytest.approx(0.4, rel=1e-14)
    assert found["ball"] == pytest.approx((1.0 - 0.2**2) / 0.2, rel=1e-14)


# --- other test rigs -------------------------------------------------------------------------


def test_every_line_that_is_printed_is_known() -> None:
    assert {line for _, line in PRINTED} <= set(LINES)


@EACH
@pytest.mark.thirds
def test_the_command_for_frequencies_gives_the_same(rig: dict[str, Any], line: str) -> None:
    """`nominal_frequencies` of a whole bearing, in Hz where the rig has a speed."""
    bearing = Bearing(
        ball_count=rig["ball_count"],
        ball_diameter=1e-3 * float(rig["ball_diameter"]),
        pitch_diameter=1e-3 * float(rig["pitch_diameter"]),
        contact_angle=radians(float(rig.get("contact_angle_deg", "0"))),
        inner_conformity=0.52,
        outer_conformity=0.52,
    )
    speed = to_si(f"{rig['speed_rpm']} rpm", "angular_speed") if "speed_rpm" in rig else None
    found = nominal_frequencies(bearing, speed).lines[line]  # type: ignore[index]
    value = found.order if speed is None else found.frequency
    assert value == pytest.approx(frequency(rig, line), rel=1e-12)  # type: ignore[arg-type]


@EACH
def test_the_bearings_could_not_be_exchanged(rig: dict[str, Any], line: str) -> None:
    """A count of balls that is off by one fails every print of passages."""
    if line.startswith("ball_pass"):
        other = rig | {"ball_count": rig["ball_count"] - 1}
        found = frequency(other, line)  # type: ignore[arg-type]
        assert abs(found - float(rig["printed"][line])) > 0.03 * found


# --- prints that disagree, and why -----------------------------------------------------------


def _rig(start: str) -> dict[str, Any]:
    return next(rig for rig in RIGS if rig["source"].startswith(start))


def test_the_cage_of_the_mfpt_bearing_is_printed_as_seen_from_the_inner_ring() -> None:
    """With γ = 0.187, which the printed spin of the ball has in it too.

    Speed of the shaft less that of the cage: ½ (1 + γ), the cage's own if the outer ring turned.
    """
    rig = _rig("NICE")
    ratio = 0.187
    shaft = float(rig["speed_rpm"]) / 60.0
    author = shaft * (1.0 - multiples(ratio, 8)["cage"])
    spin = 0.5 * shaft * float(rig["pitch_diameter"]) / float(rig["ball_diameter"])
    assert spin * (1.0 - ratio**2) == pytest.approx(63.91, abs=0.005)
    found = Check(
        source=rig["source"], quantity="cage", unit="Hz", printed="14.8375",
        computed=frequency(rig, "cage"), evidence=author, deviation=ratio * shaft + 0.05,
        explanation="what the inner ring gains on the cage",
    )  # fmt: skip
    assert found.verdict == "explained", found


def test_the_cage_of_the_tecnalia_bearing_contradicts_its_outer_race() -> None:
    """Each ball passes a point of the outer race once a turn of the cage: f_o = Z f_c."""
    rig = _rig("ER-16KCL")
    found = Check(
        source=rig["source"], quantity="cage", unit="1/turn", printed="0.402", corrected="0.397",
        computed=frequency(rig, "cage"),
        evidence=float(rig["printed"]["ball_pass_outer"]) / rig["ball_count"],
        deviation=0.0055, explanation="nine of it are not the printed outer race",
    )  # fmt: skip
    assert found.verdict == "explained", found


def test_the_catalogue_bearing_of_that_name_has_another_count_of_rollers() -> None:
    """The maker's factors of ZA2115, Hz per rpm, are not those of the rig's 16 rollers."""
    outer, inner, cage = "0.1217", "0.1617", "0.0072"
    rollers = 60.0 * (float(outer) + float(inner))
    assert rollers == pytest.approx(17.0, abs=60.0 * (half_unit(outer) + half_unit(inner)))
    assert float(outer) / 17 == pytest.approx(float(cage), abs=half_unit(cage))
    rig = _rig("Rexnord")
    for line, factor in (("ball_pass_outer", outer), ("ball_pass_inner", inner)):
        room = room_of_rounding(rig, line) / 2000.0  # type: ignore[arg-type]
        ours = frequency(rig, line) / 2000.0  # type: ignore[arg-type]
        assert abs(ours - float(factor)) > 10.0 * (half_unit(factor) + room)
