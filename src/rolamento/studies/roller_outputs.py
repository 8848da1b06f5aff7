"""Outputs of rollers: their tilt, the force of their ribs, and the pressure at their ends."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Final

import numpy as np

from rolamento.geometry import Race
from rolamento.solved import RACES
from rolamento.solved.rollers import Line, Rollers
from rolamento.studies.bearing_outputs import Get, at_race, family
from rolamento.studies.outputs import Evaluation, Floats, Output
from rolamento.words import marked, said

__all__ = ["roller_outputs"]

_NEEDS: Final = ("rollers",)


def roller_outputs() -> tuple[Output, ...]:
    """Return the outputs that only rollers have; NaN of balls."""
    tilt, force = (_of(lambda found: found.tilt), _of(lambda found: found.rib_force))
    return (
        *_with_greatest("roller_tilt", "rad", marked("tilt of the roller"), tilt),
        *_with_greatest("rib_force", "N", marked("force of the ribs on the roller"), force),
        *_of_lines(),
        Output(
            "loaded_rollers",
            "1",
            lambda: said("number of loaded rollers (inner race)"),
            _loaded,
            needs=_NEEDS,
        ),
    )


def _with_greatest(name: str, unit: str, called: str, get: Get) -> Iterator[Output]:
    """An output of each roller, and the greatest magnitude over the rollers; (cases,)."""
    yield Output(name, unit, partial(said, called), get, along="ball", needs=_NEEDS)
    yield Output(
        f"max_{name}",
        unit,
        lambda: said("maximum {quantity}", quantity=said(called)),
        lambda given: np.asarray(np.fmax.reduce(np.abs(get(given)), axis=1)),
        needs=_NEEDS,
    )


def _of_lines() -> Iterator[Output]:
    for race in RACES:
        for name, unit, called, read in (
            ("end_pressure", "Pa", marked("pressure at the roller's worse end"), _ends),
            (
                "edge_ratio",
                "1",
                marked("pressure at the roller's worse end over that in the middle"),
                _edge_ratio,
            ),
        ):
            label, get = at_race(race, called), _of_line(race, read)
            yield from family(f"{race}_{name}", unit, label, get, race, needs=_NEEDS)


def _of(read: Callable[[Rollers], Floats]) -> Get:
    """What the rollers have; NaN of a batch without any."""

    def get(given: Evaluation) -> Floats:
        found = given.solved.rollers
        if found is None:
            return np.full(given.solved.inner.load.shape, np.nan)
        return np.asarray(read(found), np.float64)

    return get


def _of_line(race: Race, read: Callable[[Line], Floats]) -> Get:
    return _of(lambda found: read(found.inner if race == "inner" else found.outer))


def _ends(line: Line) -> Floats:
    """The greater pressure of the two slices at the ends; (cases, elements)."""
    return np.asarray(np.maximum(line.pressure[..., 0], line.pressure[..., -1]))


def _edge_ratio(line: Line) -> Floats:
    """The pressure at the worse end over that in the middle; NaN where the middle has none."""
    middle = line.pressure[..., line.pressure.shape[-1] // 2]
    found = np.full(middle.shape, np.nan)
    np.divide(_ends(line), middle, out=found, where=middle > 0.0)
    return found


def _loaded(given: Evaluation) -> Floats:
    """Rollers on the inner race that carry; of a set with balls, its rollers alone."""
    rollers = given.solved.rollers
    if rollers is None:
        return np.full(len(given.solved), np.nan)
    counted = ((given.solved.inner.load > 0.0) & ~np.isnan(rollers.tilt)).sum(axis=1)
    return np.where(given.solved.converged, counted, np.nan)
