"""Fault frequencies of the drive-end bearing of the Case Western Reserve test rig, and others."""

from __future__ import annotations

from itertools import product
from math import radians
from typing import NamedTuple

import pytest

from rolamento import Bearing
from rolamento.units import to_si
from rolamento.verification import Check
from rolamento.verification.case_western import checks, multiples
from rolamento.verification.check import half_unit
from rolamento.verification.published import published
from rolamento.vibration.frequencies import nominal_frequencies

CHECKS = tuple(checks())


@pytest.mark.parametrize("check", CHECKS, ids=lambda c: c.quantity)
def test_printed_number(check: Check) -> None:
    assert check.verdict == "agrees", check


def test_all_that_is_printed_is_compared() -> None:
    printed = published("case_western")["multiples"].values()
    assert [check.printed for check in CHECKS] == list(printed)


def test_the_tolerance_is_not_so_wide_that_anything_fits() -> None:
    assert all(check.tolerance < 1e-3 * float(check.printed) for check in CHECKS)


def test_every_ball_strikes_each_race_once_a_turn() -> None:
    found = multiples(0.2, 9)
    assert found["inner_race"] + found["outer_race"] == pytest.approx(9.0, rel=1e-14)
    assert found["cage"] == pytest.approx(0.4, rel=1e-14)
    assert found["ball"] == pytest.approx((1.0 - 0.2**2) / 0.2, rel=1e-14)


# --- other test rigs -------------------------------------------------------------------------


class Rig(NamedTuple):
    """A test rig's bearing as its publishers print it; numbers as text, to keep their digits.

    ball and pitch in one unit; angle in degrees; shaft in Hz, empty where orders are printed.
    """

    name: str
    source: str
    count: int
    ball: str
    pitch: str
    angle: str
    shaft: str
    printed: dict[str, str]


RIGS = (
    Rig(
        "Case Western, fan end, 6203-2RS",
        "Case Western Reserve University, Bearing Data Center, bearing information (inch)",
        8,
        "0.2656",
        "1.122",
        "0",
        "",
        {
            "ball_pass_inner": "4.9469",
            "ball_pass_outer": "3.0530",
            "cage": "0.3817",
            "ball_spin_twice": "3.9874",
        },
    ),
    Rig(
        "IMS, Rexnord ZA-2115",
        "Qiu, Lee, Lin & Yu, J. Sound Vib. 289 (2006) 1066-1090: 16 rollers a row, 2000 rpm (inch)",
        16,
        "0.331",
        "2.815",
        "15.17",
        "2000 rpm",
        {"ball_pass_outer": "236.4"},
    ),
    Rig(
        "IMS, Rexnord ZA-2115, as others print it",
        "Gousseau, Antoni, Girardin & Griffaton, CM/MFPT 2016, of the same rig",
        16,
        "0.331",
        "2.815",
        "15.17",
        "2000 rpm",
        {"ball_pass_outer": "236", "ball_pass_inner": "297", "cage": "15"},
    ),
    Rig(
        "MaFaulDa, SpectraQuest simulator",
        "Signals, Multimedia and Telecommunications Laboratory, UFRJ, data base page (cm); every"
        " order ends in a zero there, which is left out here: three decimals hold together",
        8,
        "0.7145",
        "2.8519",
        "0",
        "",
        {
            "cage": "0.375",
            "ball_pass_outer": "2.998",
            "ball_pass_inner": "5.002",
            "ball_spin": "1.871",
        },
    ),
    Rig(
        "MFPT, NICE bearing",
        "Bechhoefer, MFPT fault data sets (inch); frequencies at 25 Hz: MathWorks, Predictive"
        " Maintenance Toolbox, example Rolling Element Bearing Fault Diagnosis",
        8,
        "0.235",
        "1.245",
        "0",
        "1500 rpm",
        {"ball_pass_outer": "81.125", "ball_pass_inner": "118.875"},
    ),
    Rig(
        "XJTU-SY, LDK UER204",
        "Wang, Lei, Li & Li, IEEE Trans. Reliab. 69 (2020) 401-412, table I (mm); the outer race"
        " at 2100 rpm as the literature on these data has it",
        8,
        "7.92",
        "34.55",
        "0",
        "2100 rpm",
        {"ball_pass_outer": "107.91"},
    ),
    Rig(
        "Paderborn, 6203",
        "Lessmeier, Kimotho, Zimmer & Sextro, PHM Society European Conf. 2016 (mm); orders as"
        " rounded by users of the data",
        8,
        "6.75",
        "28.55",
        "0",
        "",
        {"ball_pass_outer": "3.05", "ball_pass_inner": "4.95"},
    ),
)
PRINTED = [(rig, line) for rig in RIGS for line in rig.printed]


def _computed(rig: Rig, ball: float, pitch: float, angle: float, line: str) -> float:
    """By the engine: an order, or Hz where the rig has a speed."""
    bearing = Bearing(
        ball_count=rig.count,
        ball_diameter=1e-3 * ball,
        pitch_diameter=1e-3 * pitch,
        contact_angle=radians(angle),
        inner_conformity=0.52,
        outer_conformity=0.52,
    )
    speed = to_si(rig.shaft, "angular_speed") if rig.shaft else None
    found = nominal_frequencies(bearing, speed).lines[line]  # type: ignore[index]
    return found.frequency if rig.shaft else found.order


def _ends(text: str) -> tuple[float, float]:
    half = half_unit(text) if float(text) else 0.0
    return float(text) - half, float(text) + half


@pytest.mark.parametrize(("rig", "line"), PRINTED, ids=lambda value: getattr(value, "name", value))
def test_frequencies_of_other_rigs(rig: Rig, line: str) -> None:
    """As near as the print says: its last digit, and what the rounded dimensions leave open."""
    found = _computed(rig, float(rig.ball), float(rig.pitch), float(rig.angle), line)
    corners = product(_ends(rig.ball), _ends(rig.pitch), _ends(rig.angle))
    room = max(abs(_computed(rig, *corner, line) - found) for corner in corners)
    tolerance = half_unit(rig.printed[line]) + room
    assert abs(found - float(rig.printed[line])) <= tolerance, (found, tolerance)
    assert tolerance < 0.04 * found


def test_the_cages_of_the_rigs_could_not_be_exchanged() -> None:
    """A count of balls that is off by one fails every print of passages."""
    for rig, line in PRINTED:
        if line.startswith("ball_pass"):
            other = rig._replace(count=rig.count - 1)
            found = _computed(other, float(rig.ball), float(rig.pitch), float(rig.angle), line)
            assert abs(found - float(rig.printed[line])) > 0.03 * found
