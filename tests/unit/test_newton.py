"""The guarded Newton's method on small systems whose answers are known."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from rolamento.numerics import newton
from rolamento.numerics.newton import Balance, balance

Floats = NDArray[np.float64]


@dataclass
class View:
    force: Floats
    stiffness: Floats
    scale: Floats
    sound: NDArray[np.bool_]


def viewed(force: Floats, stiffness: Floats, sound: Any = True, scale: Any = None) -> View:
    size = np.abs(force).max(axis=1) if scale is None else scale
    return View(force, stiffness, size, np.broadcast_to(sound, len(force)).copy())


def springs(
    normals: Floats, gaps: Floats, stiffness: float = 1.0, exponent: float = 1.5
) -> Callable[[Any, Floats], View]:
    """Hertz-like springs along unit vectors, each beyond its gap: a convex potential."""

    def evaluate(which: Any, u: Floats) -> View:
        approach = np.maximum(u @ normals.T - gaps, 0.0)
        force = stiffness * approach**exponent
        slopes = stiffness * exponent * approach ** (exponent - 1.0)
        return viewed(
            force @ normals,
            np.einsum("nk,ki,kj->nij", slopes, normals, normals),
            scale=force.max(axis=1),
        )

    return evaluate


def solved(
    evaluate: Callable[[Any, Floats], Any],
    target: Any,
    *,
    start: Any = None,
    free: Any = None,
    **options: Any,
) -> Balance:
    wanted = np.atleast_2d(np.asarray(target, dtype=float))
    n, unknowns = wanted.shape
    given: dict[str, Any] = {
        "precision": 1e-10,
        "longest": np.full(n, 1.0),
        "limit": np.full(n, 1e3),
        "reference": np.full(n, 1e-3),
    }
    return balance(
        evaluate,
        np.zeros((n, unknowns)) if start is None else np.array(start, dtype=float),
        wanted,
        np.ones((n, unknowns), np.bool_) if free is None else np.array(free),
        **given | options,
    )


def ring(count: int, unknowns: int = 2) -> Floats:
    angle = 2.0 * np.pi * np.arange(count) / count
    return np.stack([np.cos(angle), np.sin(angle)], axis=1)


def test_a_linear_system_takes_one_step() -> None:
    matrix = np.array([[4.0, 1.0], [1.0, 3.0]])

    def evaluate(which: Any, u: Floats) -> View:
        return viewed(u @ matrix.T, np.broadcast_to(matrix, (len(u), 2, 2)).copy())

    target = np.array([[0.1, 0.2], [-0.3, 0.0], [0.0, 0.0]])
    found = solved(evaluate, target)
    assert found.settled.all()
    assert found.steps.tolist() == [1, 1, 0]
    assert found.displacement == pytest.approx(np.linalg.solve(matrix, target.T).T)
    assert (found.escaping == -1).all()
    assert (found.residual <= 1e-10).all()


def test_steps_are_no_longer_than_allowed() -> None:
    far = np.array([[2.5, 0.0]])
    seen = []

    def evaluate(which: Any, u: Floats) -> View:
        seen.append(u.copy())
        return viewed(u.copy(), np.eye(2)[np.newaxis])

    found = solved(evaluate, far, longest=np.array([0.5]))
    moves = np.linalg.norm(np.diff(np.concatenate(seen), axis=0), axis=1)
    assert moves.max() <= 0.5 * (1.0 + 1e-12)
    assert found.steps[0] == 5
    assert found.displacement == pytest.approx(far)


def test_what_is_held_stays_and_its_force_does_not_matter() -> None:
    found = solved(
        springs(ring(7), np.full(7, -0.01)), [[0.3, 9.9]], start=[[0.0, 0.02]], free=[[True, False]]
    )
    assert found.settled[0]
    assert found.displacement[0, 1] == 0.02
    view = springs(ring(7), np.full(7, -0.01))(None, found.displacement)
    assert view.force[0, 0] == pytest.approx(0.3)


@pytest.mark.parametrize("gap", [-0.05, 0.0, 0.02, 0.3])
@pytest.mark.parametrize("size", [1e-9, 1e-3, 1.0, 1e3])
def test_springs_with_play_come_to_rest_from_no_stiffness(gap: float, size: float) -> None:
    """The start touches nothing if there is play: Newton's matrix is zero there."""
    angle = np.linspace(0.0, 2.0 * np.pi, 40)
    target = size * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    evaluate = springs(ring(7), np.full(7, gap))
    found = solved(evaluate, target)
    assert found.settled.all()
    error = np.abs(evaluate(None, found.displacement).force - target).max()
    assert error <= 1e-10 * (size + max(-gap, 0.0) ** 1.5) * 2.0


def test_a_stiff_and_a_loose_direction_together() -> None:
    """Newton's step along the loose one overshoots by far; the stiff one must not wait for it."""
    normals = np.concatenate([ring(4), 1e-3 * ring(9)])
    gaps = np.concatenate([np.full(4, -1e-3), np.full(9, 1e-6)])
    evaluate = springs(normals, gaps, stiffness=1e6)
    rng = np.random.default_rng(3)
    found = solved(evaluate, rng.normal(size=(200, 2)) * 10.0 ** rng.uniform(-6, 3, (200, 1)))
    assert found.settled.all()
    assert found.steps.max() < 80


def test_near_the_solution_the_error_is_squared() -> None:
    evaluate = springs(ring(9), np.full(9, -0.2))
    target = np.array([[0.4, 0.1]])
    exact = solved(evaluate, target, precision=1e-15).displacement
    errors = []
    for precision in (1e-1, 1e-2, 1e-4, 1e-8):
        found = solved(evaluate, target, precision=precision)
        errors.append(float(np.abs(found.displacement - exact).max()))
    last, before = errors[-1], next(e for e in reversed(errors) if e > errors[-1])
    assert last <= 10.0 * before**2
    assert last < 1e-8


def test_a_push_against_nothing_escapes() -> None:
    """A one-sided spring pulled away: along which unknown, and no result."""
    normals = np.array([[1.0, 0.0], [0.0, 1.0], [0.0, -1.0]])
    evaluate = springs(normals, np.full(3, -0.1))
    found = solved(evaluate, [[-0.5, 0.0], [0.5, 0.0]], limit=np.array([20.0, 20.0]))
    assert found.settled.tolist() == [False, True]
    assert found.escaping.tolist() == [0, -1]
    assert found.displacement[0, 0] < -20.0
    assert found.residual[0] > 0.1


def test_places_that_cannot_be_evaluated_are_stepped_back_from() -> None:
    """Unsound beyond u = 1, as a bearing overloaded; the answer is at 0.9, the step goes to 3."""
    asked = []

    def evaluate(which: Any, u: Floats) -> View:
        asked.append(float(u[0, 0]))
        view = viewed(u**5, (5.0 * u**4)[:, :, np.newaxis], np.abs(u[:, 0]) <= 1.0)
        view.force[~view.sound] = np.nan
        return view

    found = solved(evaluate, [[0.9**5]], start=[[0.45]], longest=np.array([5.0]))
    assert max(asked) > 1.0
    assert found.settled[0]
    assert found.displacement[0, 0] == pytest.approx(0.9)


def test_nothing_but_unsound_places_end_without_a_result() -> None:
    def evaluate(which: Any, u: Floats) -> View:
        return viewed(np.full_like(u, np.nan), np.full((*u.shape, 2), np.nan), sound=False)

    found = solved(evaluate, np.ones((3, 2)))
    assert not found.settled.any()
    assert (found.steps == 0).all()


def test_one_bad_system_does_not_touch_the_others() -> None:
    good = springs(ring(7), np.full(7, -0.01))
    target = np.array([[0.3, 0.1], [0.2, 0.2], [-0.1, 0.4]])

    def evaluate(which: Any, u: Floats) -> View:
        view = good(which, u)
        bad = np.asarray(which) == 1
        view.force[bad] = view.stiffness[bad] = np.nan
        return view

    alone = solved(good, target)
    found = solved(evaluate, target)
    assert found.settled.tolist() == [True, False, True]
    for i in (0, 2):
        assert np.array_equal(found.displacement[i], alone.displacement[i])


def test_rank_deficient_systems_move_where_they_can() -> None:
    """One spring across two unknowns: the load along it is borne, across it is not."""
    normal = np.array([[0.6, 0.8]])
    evaluate = springs(normal, np.array([-0.5]), exponent=1.0)
    along = solved(evaluate, [[0.6, 0.8]])
    assert along.settled[0]
    assert along.displacement[0] @ normal[0] == pytest.approx(0.5)
    across = solved(evaluate, [[-0.8, 0.6]], limit=np.array([50.0]))
    assert not across.settled[0]


def test_no_load_on_nothing_is_at_rest() -> None:
    found = solved(springs(ring(5), np.full(5, 0.1)), np.zeros((2, 2)))
    assert found.settled.all()
    assert (found.residual == 0.0).all()
    assert (found.steps == 0).all()


def test_no_systems_are_no_work() -> None:
    found = solved(springs(ring(5), np.full(5, 0.1)), np.zeros((0, 2)))
    assert found.settled.shape == (0,)
    assert found.displacement.shape == (0, 2)


def test_the_work_is_bounded_when_there_is_no_solution() -> None:
    """The force jumps over the target: no step can be right."""
    asked = 0

    def evaluate(which: Any, u: Floats) -> View:
        nonlocal asked
        asked += 1
        return viewed(np.sign(u) + 2.0, np.ones((len(u), 1, 1)))

    found = solved(evaluate, [[2.0]], start=[[0.3]], longest=np.array([0.7]))
    assert not found.settled[0]
    assert found.residual[0] > 0.1
    assert asked <= newton.STEPS * (newton.SHORTENINGS + 1) + 1
