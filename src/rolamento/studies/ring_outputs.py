"""Outputs of the ring: displacements, loads, stiffness, and how the solution went."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from rolamento.case.duty import AXES, LOADS
from rolamento.studies.outputs import Floats, Output, Solved

__all__ = ["ring_outputs"]


def ring_outputs() -> tuple[Output, ...]:
    """Return the outputs of the ring."""
    return (
        *(_displacement(i) for i in range(5)),
        *(_load(i) for i in range(5)),
        *(_stiffness(i, j) for i in range(5) for j in range(5)),
        Output(
            "residual",
            "1",
            "greatest unbalanced load over the scale of its loads",
            lambda solved: solved.batch.residual,
        ),
        Output(
            "iterations",
            "1",
            "Newton steps",
            lambda solved: solved.batch.iterations,
            kind="whole",
        ),
        Output("loaded_balls", "1", "balls that touch the inner race", _loaded_balls),
    )


def _displacement(i: int) -> Output:
    tilt = i > 2
    word = "tilt of the inner ring about" if tilt else "displacement of the inner ring along"
    return Output(
        AXES[i], "rad" if tilt else "m", f"{word} {AXES[i][-1]}", _column("displacement", i)
    )


def _load(i: int) -> Output:
    moment = i > 2
    word = "moment on the inner ring about" if moment else "force on the inner ring along"
    return Output(LOADS[i], "N*m" if moment else "N", f"{word} {LOADS[i][-1]}", _column("load", i))


def _stiffness(i: int, j: int) -> Output:
    unit = ("N*m" if i > 2 else "N") + ("/rad" if j > 2 else "/m")
    return Output(
        f"stiffness_{AXES[i]}{AXES[j]}",
        {"N*m/m": "N"}.get(unit, unit),
        f"derivative of {LOADS[i]} by {AXES[j]}",
        lambda solved: solved.batch.stiffness[:, i, j],
    )


def _column(name: str, i: int) -> Callable[[Solved], Floats]:
    def column(solved: Solved) -> Floats:
        array: Floats = getattr(solved.batch, name)
        return array[:, i]

    return column


def _loaded_balls(solved: Solved) -> Floats:
    load = solved.contacts("inner").load
    return np.where(np.isnan(load).any(axis=1), np.nan, (load > 0.0).sum(axis=1))
