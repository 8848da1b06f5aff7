"""Rows of balls on one ring in lanes: as the guarded method has it, rows held at every step."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import rolamento
from rolamento.numerics import FloatArray
from rolamento.rows.ball import sets
from rolamento.rows.ball.row import BallRow
from rolamento.system.cases import spread
from rolamento.system.solve import solve_cases

CASES = 40
BALLS: dict[str, Any] = {
    "ball_count": 14,
    "ball_diameter": "10 mm",
    "pitch_diameter": "60 mm",
    "inner_conformity": 0.52,
    "outer_conformity": 0.53,
    "spacing": "20 mm",
}
SETS: dict[str, dict[str, Any]] = {
    "rigid": {"contact_angle": "25 deg", "arrangement": "DB", "preload": "4 um"},
    "face to face": {"contact_angle": "15 deg", "arrangement": "DF", "preload": "300 N"},
    "play": {"contact_angle": "25 deg", "arrangement": "DB", "preload": "-5 um"},
    "springs": {"contact_angle": "25 deg", "arrangement": "DB", "preload": {"spring": "200 N"}},
    "clearance": {"diametral_clearance": "20 um", "arrangement": "DB"},
    "four rows": {"contact_angle": "25 deg", "arrangement": "QBC", "preload": "300 N"},
}


def case(bearing: dict[str, Any], control: str = "outer") -> rolamento.Case:
    return rolamento.Case.model_validate(
        {
            "bearing": {**BALLS, **bearing},
            "duty": {},
            "model": {"raceway_control": control},
        }
    )


def duties(*, moments: bool) -> dict[str, FloatArray]:
    random = np.random.default_rng(6)
    found = {f"duty.load.{name}": random.uniform(-2e3, 2e3, CASES) for name in ("fx", "fy", "fz")}
    tilts = {"load.my": 20.0, "load.mz": 20.0} if moments else {"displacement.ry": 3e-4}
    found |= {f"duty.{name}": random.uniform(-size, size, CASES) for name, size in tilts.items()}
    # some at rest, some so slow that their inertia hardly counts
    speed = random.uniform(0.0, 1500.0, CASES) * random.choice([0.0, 1e-3, 1.0, 1.0], CASES)
    return {**found, "duty.inner_speed": speed}


@pytest.mark.parametrize("moments", [False, True])
@pytest.mark.parametrize("name", SETS)
def test_same_as_rows_held_one_by_one(name: str, moments: bool) -> None:
    own, given = case(SETS[name]), duties(moments=moments)
    quick, slow = (solve_cases(spread(own, given, fast=fast)) for fast in (True, False))
    assert np.array_equal(quick.status.number, slow.status.number)
    assert quick.converged.any()
    places, expected = quick.displacement.array[:, :3], slow.displacement.array[:, :3]
    assert np.nanmax(np.abs(places - expected)) < 1e-7 * np.nanmax(np.abs(expected))
    heaviest = np.nanmax(slow.outer.load)
    assert np.nanmax(np.abs(quick.outer.load - slow.outer.load)) < 1e-8 * heaviest


@pytest.mark.parametrize("control", ["inner", "none", "jones"])
def test_every_control(control: str) -> None:
    own, given = case(SETS["rigid"], control), duties(moments=True)
    quick, slow = (solve_cases(spread(own, given, fast=fast)) for fast in (True, False))
    assert np.array_equal(quick.status.number, slow.status.number)
    assert np.allclose(quick.outer.load, slow.outer.load, rtol=1e-8, atol=1e-5, equal_nan=True)


def test_kernels_settle_nearly_all(monkeypatch: pytest.MonkeyPatch) -> None:
    found: list[sets.Proposal | None] = []
    settle = sets.settle

    def watched(*arguments: Any) -> sets.Proposal | None:
        found.append(settle(*arguments))
        return found[-1]

    monkeypatch.setattr(sets, "settle", watched)
    for name in ("rigid", "face to face", "play", "clearance"):
        found.clear()
        solve_cases(spread(case(SETS[name]), duties(moments=True)))
        (proposal,) = found
        assert proposal is not None
        assert proposal.sound.mean() > 0.9


def test_a_tilted_sphere_is_a_set_without_tilt() -> None:
    own = rolamento.Case.model_validate({"bearing": {"designation": "1205"}, "duty": {}})
    given = {
        "duty.load.fz": np.linspace(500.0, 3e3, 8),
        "duty.load.fx": np.linspace(0.0, 300.0, 8),
        "duty.load.fy": np.zeros(8),
        "duty.displacement.ry": np.linspace(-0.02, 0.02, 8),
        "duty.displacement.rz": np.linspace(0.0, 0.01, 8),
        "duty.inner_speed": np.linspace(0.0, 200.0, 8),
    }
    quick, slow = (solve_cases(spread(own, given, fast=fast)) for fast in (True, False))
    assert quick.converged.all()
    assert np.allclose(quick.displacement.array, slow.displacement.array, rtol=1e-8, atol=1e-13)
    assert np.allclose(quick.stiffness.array, slow.stiffness.array, rtol=1e-6, atol=1.0)


def test_pressed_in_is_where_the_solver_puts_the_ring() -> None:
    force = np.geomspace(1.0, 1e6, 30)
    row = spread(case(SETS["rigid"]), {"duty.inner_speed": np.zeros(30)}).rows[0].row
    assert isinstance(row, BallRow)
    free, load = np.zeros((30, 5), np.bool_), np.zeros((30, 5))
    free[:, 0], load[:, 0] = True, force
    asked = replace(row, p=row.p.of(np.arange(30))).asked(free, load, np.zeros_like(load))
    held = asked.solve()
    expected = np.where(held.number == 0, held.place[:, 0], np.nan)
    assert np.isnan(expected).any()
    found = row.press_in(force)
    assert np.array_equal(np.isnan(found), np.isnan(expected))
    assert np.allclose(found, expected, rtol=1e-8, equal_nan=True)
    assert np.isnan(row.press_in(np.full(30, -1.0))).all()
