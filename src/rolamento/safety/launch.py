"""Launch loads of space mechanisms: allowable stress, margin of safety, gaps of preloaded rows.

A bearing that stands still while it is shaken is limited by the brinell marks that it gets:
NASA-STD-5017B, 4.9, allows a mean Hertz pressure by the material of the rings, less where the
bearing has to run quietly afterwards. The margin of safety is

    MoS = allowable/mean pressure - 1

under the design load, the limit load times its factor, which the case gives as
``[static] load_factor``. ECSS-E-ST-33-01C asks for the same with the maximum pressure (as public
summaries of it have it); what is allowed is up to the material: ``[static] allowable_pressure``.

A pair loses the contact of a row where the load takes its preload away: the balls then hammer in
the gap, ``gap``.
"""

from __future__ import annotations

import numpy as np

from rolamento.io.data import toml_of
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.solved import RACES, Solved

__all__ = ["Allowable", "Launch", "launch_of"]


@frozen(eq=False)
class Allowable:
    """An allowable pressure and the margin to it.

    Attributes
    ----------
    key
        "quiet" or "other", of NASA-STD-5017B; "own", of the case
    pressure
        allowed (Pa): mean pressure, but maximum pressure of "own"
    margin
        MoS of the contact with the most pressure, (cases,)
    """

    key: str
    pressure: float
    margin: FloatArray


@frozen(eq=False)
class Launch:
    """How near a bearing is to its allowable stress, and how far its rows gap; SI.

    Attributes
    ----------
    mean_pressure, max_pressure
        of the contact with the most pressure, (cases,) (Pa)
    allowables
        with their margins
    gap
        maximum gap between an element and its inner race, (cases, rows) (m); 0 where all touch
    lost
        whether no element of a row touches, (cases, rows)
    source
        of the allowables
    """

    mean_pressure: FloatArray
    max_pressure: FloatArray
    allowables: tuple[Allowable, ...]
    gap: FloatArray
    lost: FloatArray
    source: str


def launch_of(solved: Solved, allowable_pressure: float | None = None) -> Launch:
    """Return margins and gaps of solved cases, under the loads that they have.

    Parameters
    ----------
    solved
        Of `rolamento.solve`.
    allowable_pressure
        Maximum pressure that the user allows, in Pa.

    NASA-STD-5017B, table 3, of the materials that it names.
    """
    mean = _most(solved, "mean_pressure")
    most = _most(solved, "max_pressure")
    data = toml_of("static_safety")["launch"]
    ring = solved.case.bearing.ring_material.name
    allowables = [
        Allowable(key, 1e6 * row[key], _margin(1e6 * row[key], mean))
        for row in data["materials"]
        if row["name"] == ring
        for key in ("quiet", "other")
    ]
    if allowable_pressure is not None:
        margin = _margin(allowable_pressure, most)
        allowables.append(Allowable("own", allowable_pressure, margin))
    approach = solved.inner.approach
    starts = solved.rows.starts
    gap = np.maximum.reduceat(np.maximum(-approach, 0.0), starts, axis=1)
    touching = np.add.reduceat(solved.loaded.astype(np.int64), starts, axis=1)
    unsolved = ~solved.converged[:, np.newaxis]
    return Launch(
        mean,
        most,
        tuple(allowables),
        np.where(unsolved, np.nan, gap),
        np.where(unsolved, False, touching == 0),
        data["source"],
    )


def _most(solved: Solved, name: str) -> FloatArray:
    """Greatest of all contacts of both races; (cases,)."""
    both = [getattr(solved.contacts[race], name).max(axis=1) for race in RACES]
    return np.asarray(np.maximum(*both))


def _margin(allowable: float, pressure: FloatArray) -> FloatArray:
    with np.errstate(divide="ignore"):
        return np.asarray(allowable / pressure - 1.0)
