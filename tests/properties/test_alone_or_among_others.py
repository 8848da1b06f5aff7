"""A case's status and numbers do not depend on what is solved beside it.

To the last bit among compiled kernels, whatever the number, the order and the threads; a case that
plain Python solves alone, before the compiler is loaded, agrees to 1e-9 of its scale.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from benchmarks import laws
from numpy.typing import NDArray

from rolamento import Bearing, Case
from rolamento.solution import solve
from rolamento.solved import Solved

Floats = NDArray[np.float64]


def fields(solved: Solved) -> tuple[NDArray[Any], ...]:
    status = solved.status
    return status.code, solved.displacement.array, solved.stiffness.array, status.residual


def taken(duty: dict[str, Floats], cases: NDArray[np.intp]) -> dict[str, Floats]:
    return {name: values[cases] for name, values in duty.items()}


# turns round from every start but that to which caution leads
COUNTER_ROTATING = Case(
    bearing=Bearing(
        ball_count=9,
        ball_diameter="0.012830664026854847 m",
        pitch_diameter="0.04881036196316283 m",
        diametral_clearance="3.037270274943052e-05 m",
        inner_conformity=0.5232060031909948,
        outer_conformity=0.5218851503156856,
    ),
    duty={
        "inner_speed": "-3348.1020631089423 rad/s",
        "outer_speed": "2120.6384025714024 rad/s",
        "first_ball_azimuth": "0.14563657393468582 rad",
        "load": {
            "fx": "1.983598831364686 N",
            "fz": "0 N",
            "fy": "0 N",
            "my": "-0.021705387868398162 N m",
            "mz": "0.0027040553190347733 N m",
        },
    },
    model={"raceway_control": "jones"},
)


@pytest.mark.parametrize("threads", [1, 2])
def test_copies_of_a_hard_case_are_alike(threads: int) -> None:
    first = None
    for count in (2, 3, 7, 8, 9, 17, 170):
        solved = solve(COUNTER_ROTATING, fx=np.full(count, 1.983598831364686), threads=threads)
        assert solved.converged.all(), count
        own = solved.displacement.array
        first = own[0] if first is None else first
        np.testing.assert_array_equal(own, np.broadcast_to(first, own.shape))
    alone = solve(COUNTER_ROTATING)
    assert alone.converged[0]
    np.testing.assert_allclose(alone.displacement.array[0], first, rtol=1e-9)


@pytest.mark.parametrize("seed", [pytest.param(s, marks=pytest.mark.thirds) for s in range(12)])
def test_random_duties_alone_and_among_others(seed: int) -> None:
    random = np.random.default_rng(seed)
    case = laws.random_case(random)
    duty = laws.random_duty(random, case.bearing, 170)
    duty = {name: np.broadcast_to(values, 170).copy() for name, values in duty.items()}
    whole = fields(solve(case, threads=1, **duty))
    shuffled = random.permutation(170)
    back = np.argsort(shuffled)
    for other in (
        [part[back] for part in fields(solve(case, threads=2, **taken(duty, shuffled)))],
        [
            np.concatenate(parts)
            for parts in zip(
                *(
                    fields(solve(case, threads=1, **taken(duty, cases)))
                    for cases in np.array_split(np.arange(170), 22)
                ),
                strict=True,
            )
        ],
    ):
        for one, two in zip(whole, other, strict=True):
            np.testing.assert_array_equal(one, two)
    hard = np.flatnonzero(whole[0] != "converged")[:4]
    for index in {*hard.tolist(), *range(4)}:
        pair = fields(solve(case, threads=1, **taken(duty, np.array([index, (index + 1) % 170]))))
        for one, two in zip(whole, pair, strict=True):
            np.testing.assert_array_equal(one[index], two[0])


@pytest.mark.parametrize("count", [2, 40])
def test_a_batch_of_nothing_but_unusable_cases_is_refused_whole(count: int) -> None:
    solved = solve(COUNTER_ROTATING, fx=np.full(count, np.nan))
    assert set(solved.status.code) == {"invalid_input"}
    mixed = np.array([np.nan, 1.983598831364686] * count)
    assert set(solve(COUNTER_ROTATING, fx=mixed).status.code[::2]) == {"invalid_input"}
    assert solve(COUNTER_ROTATING, fx=mixed).converged[1::2].all()
