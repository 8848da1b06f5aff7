"""Regimes of lubrication, how a bearing is expected to fail in them, and where cracks start.

The limits and modes are in data/lubrication_regimes.toml, with their sources.
"""

from __future__ import annotations

from functools import lru_cache
from math import isnan
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.errors import InputError
from rolamento.io.data import toml_of
from rolamento.records import frozen
from rolamento.validate import within
from rolamento.words import said

Origin = Literal["surface", "subsurface", "undecided"]


@frozen
class FailureMode:
    """One way to fail: group (fatigue, deformation, wear), origin or kind, and what it is."""

    name: str
    group: str
    origin: str
    text: str


@frozen
class Regime:
    """A range of the film parameter: λ > above, up to the limit of the regime before."""

    name: str
    above: float
    text: str
    expects: tuple[FailureMode, ...]


@lru_cache(maxsize=1)
def failure_modes() -> tuple[FailureMode, ...]:
    """Return all modes of the table. Moyer (1992); Campanha (2008), table 2.5.1."""
    return tuple(FailureMode(**record) for record in toml_of("lubrication_regimes")["mode"])


@lru_cache(maxsize=1)
def regimes() -> tuple[Regime, ...]:
    """Return the regimes, from thick films to thin ones. Campanha (2008), 2.4.7 and 2.5.1."""
    modes = {mode.name: mode for mode in failure_modes()}
    return tuple(
        Regime(**{**record, "expects": tuple(modes[name] for name in record["expects"])})
        for record in toml_of("lubrication_regimes")["regime"]
    )


def adhesive_wear_by_speed() -> dict[str, str]:
    """Return what adhesive wear looks like at low and at high speed. Moyer (1992)."""
    return {
        record["name"]: record["text"]
        for record in toml_of("lubrication_regimes")["adhesive_speed"]
    }


def regime_indices(film_parameter: ArrayLike) -> NDArray[np.int64]:
    """Which of `regimes` each film parameter λ falls into; -1 for NaN."""
    parameter = np.asarray(film_parameter, dtype=np.float64)
    indices = np.full(parameter.shape, -1, dtype=np.int64)
    for index, regime in reversed(list(enumerate(regimes()))):
        indices[parameter > regime.above] = index
    return indices


def regime_of(film_parameter: float) -> Regime | None:
    """Return the regime of a film parameter λ; None for NaN."""
    index = int(regime_indices(film_parameter))
    return None if index < 0 else regimes()[index]


def crack_origin(crack_depth: float, greatest_shear_depth: float) -> Origin:
    """Return where a crack started, from its depth over that of the maximum shear stress.

    0.5 to 1.5: beneath the surface; up to 0.2: at the surface; else undecided. Both in m.

    Raises
    ------
    InputError
        If a depth is not a positive number (the crack's may be zero).
    """
    crack = float(within(crack_depth, "crack_depth", "m", 0.0, 1e3))
    shear = float(
        within(greatest_shear_depth, "greatest_shear_depth", "m", 0.0, 1e3, least_too=False)
    )
    ratio = crack / shear
    if isnan(ratio):
        field = "crack_depth" if isnan(crack) else "greatest_shear_depth"
        raise InputError(said("must be a number"), field=field, value="nan")
    origins: list[Origin] = [
        record["origin"]
        for record in toml_of("lubrication_regimes")["crack"]
        if record["from"] <= ratio <= record["to"]
    ]
    return origins[0] if origins else "undecided"
