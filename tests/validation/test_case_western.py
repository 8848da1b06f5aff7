"""Fault frequencies of the drive-end bearing of the Case Western Reserve test rig."""

from __future__ import annotations

import pytest

from rolamento.verification import Check
from rolamento.verification.case_western import checks, multiples
from rolamento.verification.published import published

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
