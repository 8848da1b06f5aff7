"""Where the torque is an upper bound only: what was assumed of inlets and ribs that may take less.

A bound is worth a word where it may take more than a twentieth off the torque.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np

from rolamento.case.film_model import FilmModel, Supply
from rolamento.friction.model import Setting
from rolamento.friction.rollers import RollerShape, rib_film_parameter
from rolamento.lubrication.film_thickness import aihara, replenishment, thermal_loading
from rolamento.lubrication.films import film, has_film, refilled_kind
from rolamento.numerics import BoolArray, FloatArray
from rolamento.solved import RACES, Solved

WORTH: Final = 0.05
"""Fraction of the torque: less is within what any model of it is good for."""


def upper_bounds(
    setting: Setting, torque: FloatArray, by_source: Mapping[str, FloatArray]
) -> dict[str, BoolArray]:
    """Why the torque is an upper bound, by keys of notes, each with (cases,).

    Parameters
    ----------
    setting
        What the torque was found with.
    torque, by_source
        The whole, and what each source has of it, (cases,), N·m.

    Returns
    -------
    dict
        "inlets_flooded" where full inlets were assumed and the track may not be refilled;
        "inlets_starved_as_film" where an inlet distance was counted by the film, of which it takes
        less; "inlets_isothermal" where the heat in the inlets was left out; "rib_without_film"
        where the rib slides with a coefficient that a film would lower.
    """
    solved = setting.solved
    left: dict[str, tuple[str, FloatArray]] = {}
    if "rolling_resistance" in by_source and has_film(solved):
        model = solved.case.film or FilmModel()
        if model.starvation == "none":
            left["inlets_flooded"] = ("rolling_resistance", _refilled(solved, model))
        if model.starvation == "inlet_distance":
            left["inlets_starved_as_film"] = ("rolling_resistance", _thinned(solved))
        if model.thermal == "none":
            left["inlets_isothermal"] = ("rolling_resistance", _heated(solved))
    if "rib" in by_source and not setting.by_regime and has_film(solved):
        left["rib_without_film"] = ("rib", _ribs_known(setting))
    with np.errstate(invalid="ignore"):
        return {
            key: np.asarray(by_source[source] * (1.0 - share) > WORTH * torque)
            for key, (source, share) in left.items()
        }


def _refilled(solved: Solved, model: FilmModel) -> FloatArray:
    """The factor of replenishment, or a lower limit of it, (cases,).

    Where bore and outside diameter are not known, d + D = 2 d_m, and D - d is at least two element
    diameters, for the rings have a thickness.
    """
    case, lubricant = solved.case, solved.case.lubricant
    grease = lubricant is not None and lubricant.kind == "grease"
    supply: Supply = model.supply or ("grease" if grease else "bath")
    speed, oil = solved.relative_speed, solved.oil
    published = case.bearing.published
    if model.bore is not None and model.outside_diameter is not None:
        sizes = [(np.asarray(model.bore), np.asarray(model.outside_diameter))]
    elif published is not None:
        sizes = [(np.asarray(published.bore), np.asarray(published.outside_diameter))]
    else:
        rows = solved.rows
        middle, half = rows.pitch_diameter.T, rows.ball_diameter.T
        sizes = list(zip(middle - half, middle + half, strict=True))
    factors = [
        replenishment(
            oil.kinematic_viscosity, speed, bore, outside, supply, kind=refilled_kind(case)
        )
        for bore, outside in sizes
    ]
    return np.asarray(np.min(factors, axis=0), dtype=np.float64)


def _thinned(solved: Solved) -> FloatArray:
    """What the inlet distance leaves of the film at the contact that it takes most of; (cases,)."""
    found = film(solved, threads=1)
    factors = np.hstack([found.of(race).starvation_factor for race in RACES])
    thinnest: FloatArray = np.fmin.reduce(factors, axis=1)
    return np.where(np.isnan(thinnest), 1.0, thinnest)


def _heated(solved: Solved) -> FloatArray:
    """What the heat would leave of the resistance at the fastest contact; (cases,)."""
    oil = solved.oil
    speeds = np.hstack([np.abs(solved.contacts[race].entrainment) for race in RACES])
    fastest: FloatArray = np.fmax.reduce(speeds, axis=1)
    loading = thermal_loading(
        oil.dynamic_viscosity, oil.viscosity_temperature, fastest, oil.thermal_conductivity
    )
    return np.asarray(aihara(loading))


def _ribs_known(setting: Setting) -> FloatArray:
    """1 where the film at every rib that carries load is known, else 0; (cases,)."""
    solved = setting.solved
    assert solved.rollers is not None
    parameter = rib_film_parameter(setting, RollerShape.of(solved))
    with np.errstate(invalid="ignore"):
        presses = solved.rollers_bear & (np.abs(solved.rollers.rib_force) > 0.0)
    return np.where(np.any(presses & np.isnan(parameter), axis=1), 0.0, 1.0)
