"""Outputs of a set: the load of each row, and what holds its rows together.

The load factors are searched over all cases together; each takes some 20 solutions more.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.case.duty import LOADS
from rolamento.studies.outputs import Evaluation, Floats, Output

if TYPE_CHECKING:
    from rolamento.solved import Solved
    from rolamento.system.preload import Lost

_PRELOAD: Final = ("bearing.preload",)


def row_outputs() -> tuple[Output, ...]:
    """Return the outputs of the rows of a set, and of its preload."""
    return (*_of_rows(), *_of_preload())


def _of_rows() -> Iterator[Output]:
    for place, name in enumerate(LOADS):
        unit = "N*m" if name[0] == "m" else "N"
        yield Output(f"row_{name}", unit, _load(place), along="row")
    yield Output("row_loaded_balls", "1", _loaded_balls, along="row")


def _load(place: int) -> Callable[[Evaluation], Floats]:
    return lambda given: given.solved.rows.load[:, :, place]


def _loaded_balls(given: Evaluation) -> Floats:
    load = given.solved.inner.load
    loaded = np.where(np.isnan(load), np.nan, load > 0.0)
    return np.asarray(np.add.reduceat(loaded, given.solved.rows.starts, axis=1), np.float64)


def _of_preload() -> Iterator[Output]:
    for name, running in (("preload_at_rest", False), ("preload_at_speed", True)):
        yield Output(name, "N", _preload(running=running), needs=_PRELOAD)
    for law, factor, row in (
        (_first_lift_off, "lift_factor", "lift_row"),
        (_preload_loss, "loss_factor", "lost_row"),
    ):
        yield Output(factor, "1", _factor(law), needs=_PRELOAD)
        yield Output(row, "1", _row(law), needs=_PRELOAD)


def _first_lift_off(solved: Solved) -> Lost:
    from rolamento.system.preload import first_lift_off

    return first_lift_off(solved)


def _preload_loss(solved: Solved) -> Lost:
    from rolamento.system.preload import preload_loss

    return preload_loss(solved)


def _preload_at(solved: Solved, *, running: bool) -> Floats:
    from rolamento.system.preload import preload_at

    return preload_at(solved, running=running)


def _preload(*, running: bool) -> Callable[[Evaluation], Floats]:
    return lambda given: _of_solved(given, given.of(_preload_at, running=running))


def _factor(law: Callable[[Solved], Lost]) -> Callable[[Evaluation], Floats]:
    return lambda given: _of_solved(given, given.of(law).factor)


def _row(law: Callable[[Solved], Lost]) -> Callable[[Evaluation], Floats]:
    def compute(given: Evaluation) -> Floats:
        found = given.of(law)
        return _of_solved(given, np.where(np.isnan(found.factor), np.nan, found.row))

    return compute


def _of_solved(given: Evaluation, values: Floats) -> Floats:
    """NaN of a case that has no result itself."""
    return np.where(given.solved.converged, values, np.nan)
