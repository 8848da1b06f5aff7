"""Balls that friction alone moves: compiled and by NumPy, as plain Python and compiled."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from rolamento import Bearing, Case, Duty, Load
from rolamento.case import load_case
from rolamento.friction import harris_1971, minimum_power
from rolamento.friction.jones_control import jones_control
from rolamento.friction.jones_full import jones_full
from rolamento.friction.line_balance import balance_balls
from rolamento.friction.model import Torque, unit_motion
from rolamento.friction.traction import ellipse_mesh
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.tasks.demonstration import EXAMPLE

MU = 0.1


@pytest.fixture(scope="module")
def balls() -> Solved:
    """Thrust, where all balls of a case are alike, combined load, and balls that bear nothing."""
    bearing = Bearing(
        ball_count=7,
        ball_diameter="12 mm",
        pitch_diameter="60 mm",
        contact_angle="25 deg",
        inner_conformity=0.53,
        outer_conformity=0.52,
    )
    case = Case(bearing=bearing, duty=Duty(inner_speed="100 rpm", load=Load(fx="1 kN")))
    return solve(case, fx=np.array([500.0, 2000.0, 800.0]), fz=np.array([0.0, 600.0, 2500.0]))


@pytest.mark.parametrize("model", [jones_full, jones_control])
def test_compiled_and_numpy_find_the_same_torque(
    model: Callable[..., Torque], balls: Solved, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(minimum_power, "FEW", 0)
    compiled = model(balls, MU)

    monkeypatch.setattr(minimum_power, "share_out", _plainly)
    by_numpy = model(balls, MU)
    assert compiled.converged.all()
    assert by_numpy.converged.all()
    np.testing.assert_allclose(compiled.total, by_numpy.total, rtol=1e-12)
    for name, part in compiled.parts.items():
        np.testing.assert_allclose(part, by_numpy.parts[name], rtol=0, atol=1e-10 * part.max())


def test_light_balls_lose_the_same_compiled_and_by_numpy(monkeypatch: pytest.MonkeyPatch) -> None:
    """What a light ball loses by slip is a thousandth of its load's: both settle to the end."""
    spindle = solve(load_case(str(EXAMPLE)))
    monkeypatch.setattr(minimum_power, "FEW", 0)
    compiled = jones_full(spindle, MU)
    monkeypatch.setattr(minimum_power, "share_out", _plainly)
    by_numpy = jones_full(spindle, MU)
    for name, loss in compiled.losses.items():
        np.testing.assert_allclose(loss.inner, by_numpy.losses[name].inner, rtol=1e-10)


@pytest.mark.parametrize("few", [0, 10**6])
def test_balls_near_rest_settle_either_way(few: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """The power of a slow set's balls is known to fewer digits than its gradient."""
    monkeypatch.setattr(minimum_power, "FEW", few)
    monkeypatch.setattr(minimum_power, "share_out", _plainly if few else minimum_power.share_out)
    pair = Case.from_mapping(
        {
            "bearing": {"designation": "7014 C DB", "preload": "200 N"},
            "duty": {"inner_speed": "11.1 rpm", "load": {"fx": "2.4 kN", "fz": "2.4 kN"}},
        }
    )
    solved = solve(pair, inner_speed=np.array([0.05, 1.162, 1.1624, 2.0, 11.6]))
    assert jones_full(solved, MU).converged.all()


def _plainly(kernel: Any, run: Any, cases: int, **_: Any) -> None:
    run(kernel, 0, cases)


def test_the_kernel_runs_as_plain_python(balls: Solved) -> None:
    from rolamento.friction.free_ball import move_free_balls

    inner, outer, chosen = minimum_power.loaded_contacts(balls)
    start = minimum_power.start_of(unit_motion(balls, np.ones(chosen.shape, np.int64)), chosen)
    free = np.ascontiguousarray(np.broadcast_to(np.eye(3), (*start.shape, 3)))
    contacts = np.stack([minimum_power.contact_numbers(patch) for patch in (inner, outer)])
    coarse, fine = ellipse_mesh(6, 1).rows, ellipse_mesh(12, 3).folded.rows
    found = []
    for run in (move_free_balls, move_free_balls.compiled):
        motion, last, sharp = np.empty((2, 3)), np.empty((2, 2)), np.empty((2, 2, 2))
        run(0, 2, coarse, fine, contacts, start, free, np.array([0.1]), motion, last, sharp)
        assert (last[:, 1] < 1e-9).all()
        found.append(np.concatenate([motion.ravel(), sharp.ravel()]))
    np.testing.assert_allclose(*found, rtol=1e-9, atol=1e-12)
    np.testing.assert_array_equal(found[1][:3], found[1][3:6])  # thrust: like its neighbour


def test_an_ellipse_wider_than_the_ball_has_no_balance() -> None:
    contacts = np.full((2, 9, 1), np.nan)
    motion, converged = np.zeros((1, 3)), np.ones(1, np.bool_)
    balance_balls(0, 1, contacts, motion, converged)
    assert not converged[0]


def test_balance_between_the_lines_as_plain_python_and_compiled(balls: Solved) -> None:
    inner, outer, chosen = minimum_power.loaded_contacts(balls)
    start = minimum_power.start_of(unit_motion(balls, np.ones(chosen.shape, np.int64)), chosen)
    contacts = np.stack([minimum_power.contact_numbers(patch) for patch in (inner, outer)])
    motion, _ = harris_1971._balanced(inner, outer, start)
    found = []
    for run in (balance_balls, balance_balls.compiled):
        own, converged = motion + 1e-7, np.empty(len(motion), np.bool_)
        run(0, len(motion), contacts, own, converged)
        assert converged.all()
        found.append(own)
    np.testing.assert_allclose(*found, rtol=0, atol=1e-6 * np.abs(motion).max())


def test_a_mesh_in_rows_is_the_mesh() -> None:
    mesh = ellipse_mesh(8, 5).folded
    u, square, weight = mesh.rows
    assert square.shape == weight.shape == (3, 8)
    np.testing.assert_array_equal(weight.T.ravel(), mesh.weight)
    np.testing.assert_array_equal(square.T.ravel(), mesh.along**2)
    np.testing.assert_array_equal(np.repeat(u, 3), mesh.across)
