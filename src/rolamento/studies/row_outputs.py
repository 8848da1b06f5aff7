"""Outputs of a set: the load of each row, and what holds its rows together.

The load factors are searched over all cases together; each takes some 20 solutions more.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.case import Case
from rolamento.case.duty import LOADS
from rolamento.studies.outputs import Evaluation, Floats, Output
from rolamento.words import marked, said

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
        yield Output(f"row_{name}", unit, _load_name(name), _load(place), along="row")
    yield Output(
        "row_loaded_balls",
        "1",
        lambda: said("number of loaded balls (inner race), per row"),
        _loaded_balls,
        along="row",
    )


def _load_name(load: str) -> Callable[[], str]:
    return lambda: said("{quantity}, per row", quantity=Case.fields()[f"duty.load.{load}"].label)


def _load(place: int) -> Callable[[Evaluation], Floats]:
    return lambda given: given.solved.rows.load[:, :, place]


def _loaded_balls(given: Evaluation) -> Floats:
    load = given.solved.inner.load
    loaded = np.where(np.isnan(load), np.nan, load > 0.0)
    return np.asarray(np.add.reduceat(loaded, given.solved.rows.starts, axis=1), np.float64)


def _of_preload() -> Iterator[Output]:
    for name, unit, called, compute in (
        ("preload_at_rest", "N", marked("axial preload at rest"), _preload(running=False)),
        ("preload_at_speed", "N", marked("axial preload at speed"), _preload(running=True)),
        (
            "lift_factor",
            "1",
            marked("load factor at which the first ball loses contact"),
            _factor(_first_lift_off),
        ),
        (
            "lift_row",
            "1",
            marked("row whose ball first loses contact, counted from 0"),
            _row(_first_lift_off),
        ),
        (
            "loss_factor",
            "1",
            marked("load factor at which a row loses contact"),
            _factor(_preload_loss),
        ),
        (
            "lost_row",
            "1",
            marked("row that first loses contact, counted from 0"),
            _row(_preload_loss),
        ),
    ):
        yield Output(name, unit, partial(said, called), compute, needs=_PRELOAD)


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
