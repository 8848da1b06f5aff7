"""Cases per second on the duty sets, and what a ball costs."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from functools import partial
from typing import Final

import numpy as np

import rolamento
from benchmarks import duty_sets
from benchmarks.figures import Figure, Findings, Target, alternately, at_least, seconds
from rolamento.numerics.compiled import filling
from rolamento.rows.ball import lanes, layout
from rolamento.rows.ball.blocks import Room, room_for
from rolamento.rows.ball.run import solve_columns
from rolamento.solved import Solved
from rolamento.system import spread

PROMISED_RESIDUAL: Final = 1e-8

SETS: Final[dict[str, tuple[Callable[[int], duty_sets.Duties], Target | None, bool]]] = {
    "duty set, tilts held": (duty_sets.tilts_held, at_least(1e6, 500e3), True),
    "tilts held, load in a plane": (duty_sets.in_a_plane, None, True),
    "duty set, moments given": (duty_sets.moments_given, at_least(700e3, 350e3), True),
    "hard set": (duty_sets.hard, at_least(300e3, 150e3), False),
}
"""The set, its target in cases/s on two threads, and whether every case has a solution."""


def measure(name: str, cases: int, repeats: int) -> Findings:
    """Solve a set on one and on two threads; count statuses, iterations and residuals."""
    duties_of, target, all_solvable = SETS[name]
    case, duties = duty_sets.example(), duty_sets.some(duties_of(duty_sets.CASES), cases)
    batch = rolamento.solve(case, **duties)
    iterations = float(batch.status.iterations.mean())

    threads = (1, 2)
    solves = [partial(rolamento.solve, case, threads=n, **duties) for n in threads]
    rate = {n: cases / time for n, time in zip(threads, alternately(solves, repeats), strict=True)}
    per_ball = 1e9 / (rate[1] * case.bearing.ball_count * iterations)
    figures = [
        Figure(name, "one thread", rate[1], "cases/s"),
        Figure(name, "two threads", rate[2], "cases/s", target),
        Figure(name, "a ball, of all an iteration takes", per_ball, "ns"),
        Figure(name, "iterations, mean", iterations),
        Figure(name, "iterations, greatest", float(batch.status.iterations.max())),
        Figure(name, "cases on the safe path", 100.0 * float(batch.status.safe_path.mean()), "%"),
        Figure(name, "converged", 100.0 * float(batch.converged.mean()), "%"),
        Figure(name, "greatest residual", float(np.nanmax(batch.status.residual[batch.converged]))),
    ]
    return Findings(figures, [statuses(name, batch)], complaints(name, batch, all_solvable))


def statuses(name: str, batch: Solved) -> str:
    """How many cases ended how."""
    counts = Counter(batch.status.code.tolist())
    return f"{name}: " + ", ".join(f"{count} {status}" for status, count in counts.most_common())


def complaints(name: str, batch: Solved, all_solvable: bool) -> list[str]:
    """What must not happen: no convergence, or a residual above what is promised."""
    found = []
    status = batch.status.code
    bad = np.flatnonzero(status != "converged" if all_solvable else status == "not_converged")
    if len(bad):
        shown = ", ".join(f"{case} ({status[case]})" for case in bad[:10])
        found.append(f"{name}: {len(bad)} cases without a result: {shown}")
    worst = float(np.max(batch.status.residual[batch.converged], initial=0.0))
    if not worst <= PROMISED_RESIDUAL:
        found.append(f"{name}: a converged case has a residual of {worst:.1e}")
    return found


def warm_up() -> None:
    """Compile the kernels, or load them: a few cases would be solved without."""
    rolamento.solve(duty_sets.example(), threads=1, **duty_sets.tilts_held(1000))


def measure_kernels(cases: int, repeats: int) -> Findings:
    """The compiled part alone, one thread, and within it the evaluation of a ball."""
    case = duty_sets.example()
    p = spread(case, duty_sets.some(duty_sets.tilts_held(), cases)).rows[0].row.p
    control, balls = np.ones((1, case.bearing.ball_count)), case.bearing.ball_count
    kernels = seconds(lambda: solve_columns(p, control, balls, threads=1), repeats)
    group = "kernels, tilts held"
    figures = [
        Figure(group, "without the Python around them", cases / kernels, "cases/s"),
        Figure(group, "evaluation of a ball in motion", ball_evaluation(repeats), "ns"),
    ]
    return Findings(figures, [], [])


def ball_evaluation(repeats: int, passes: int = 2000) -> float:
    """Nanoseconds for one ball of one case in `lanes.add_moving_ball`, all lanes at work."""
    room = _filled_lanes()

    def run() -> None:
        _pass_over_balls.compiled(room, passes)

    run()
    return 1e9 * seconds(run, repeats) / (passes * room.b.shape[0] * layout.LANES)


@filling
def _pass_over_balls(room: Room, passes: int) -> None:
    for _ in range(passes):
        lanes.reset_sums(room.w)
        for j in range(room.b.shape[0]):
            lanes.add_moving_ball(room.w, room.b[j], room.touch, 1e-5)


def _filled_lanes() -> Room:
    """Room of the kernels, one solved case of the duty set in each lane."""
    case = duty_sets.example()
    p = spread(case, duty_sets.tilts_held(layout.LANES)).rows[0].row.p
    balls = case.bearing.ball_count
    solution = solve_columns(p, np.ones((1, balls)), balls, threads=1)
    azimuth = 2.0 * np.pi * np.arange(balls)[:, np.newaxis] / balls
    room = room_for(balls)
    room.rings[: layout.PARAMETERS] = p.whole()[: layout.PARAMETERS]
    room.rings[layout.DISPLACEMENT : layout.DISPLACEMENT + 5] = solution.displacement.T
    ball = room.b.reshape(balls, layout.BALL_ROWS, layout.LANES)
    ball[:, layout.COS], ball[:, layout.SIN] = np.cos(azimuth), np.sin(azimuth)
    ball[:, layout.SIGMA] = 1.0
    ball[:, layout.POSITION : layout.POSITION + 2] = solution.position.transpose(1, 2, 0)
    return room
