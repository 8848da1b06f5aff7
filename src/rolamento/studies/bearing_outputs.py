"""Outputs of the state itself: the ring's, each ball's, and what is taken over the balls."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, Final

import numpy as np

from rolamento.case import Case
from rolamento.case.duty import AXES, LOADS
from rolamento.contact.hertz import elliptical_contact
from rolamento.geometry import Race, race_curvature
from rolamento.solved import RACES, Solved
from rolamento.studies.outputs import Evaluation, Floats, Output
from rolamento.words import marked, said
from rolamento.words.quantities import CALLED

Get = Callable[[Evaluation], Floats]

_CONTACT: Final = (
    ("load", "N", CALLED["load"]),
    ("contact_angle", "rad", CALLED["contact_angle"]),
    ("deflection", "m", CALLED["deflection"]),
    ("semi_major", "m", CALLED["semi_major"]),
    ("semi_minor", "m", CALLED["semi_minor"]),
    ("max_pressure", "Pa", CALLED["pressure"]),
    ("mean_pressure", "Pa", CALLED["mean_pressure"]),
    ("spin_to_roll", "1", CALLED["spin_to_roll"]),
)
_BALL: Final = (
    ("centrifugal_force", "N", marked("centrifugal force")),
    ("gyroscopic_moment", "N*m", marked("gyroscopic moment")),
    ("orbital_speed", "rad/s", marked("orbital speed")),
    ("ball_speed", "rad/s", marked("ball speed about its own axis")),
    ("attitude", "rad", marked("angle of the ball's axis to the shaft")),
)
_ONLY_LOADED: Final = ("contact_angle", "spin_to_roll")
"""Means nothing at a contact without load, and is left out of what is taken over the balls."""
_MARGIN: Final = 1e-9
"""Rounding must not shut out the maximum."""


# --- the ring ---------------------------------------------------------------------------------


def ring_outputs() -> tuple[Output, ...]:
    """Return the outputs of the ring: displacements, loads, stiffness, and how it was solved."""
    return (
        *(_displacement(axis) for axis in AXES),
        *(_load(load) for load in LOADS),
        *(_stiffness(load, axis) for load in LOADS for axis in AXES),
        Output(
            "residual",
            "1",
            lambda: said("residual of the equilibrium, over the scale of its loads"),
            lambda given: given.solved.status.residual,
        ),
        Output(
            "iterations",
            "1",
            lambda: said("Newton iterations"),
            lambda given: given.solved.status.iterations,
            kind="whole",
        ),
        Output(
            "loaded_balls", "1", lambda: said("number of loaded balls (inner race)"), _loaded_balls
        ),
    )


def _displacement(axis: str) -> Output:
    return Output(
        axis,
        "rad" if len(axis) > 1 else "m",
        lambda: Case.fields()[f"duty.displacement.{axis}"].label,
        lambda given: getattr(given.solved.displacement, axis),
    )


def _load(load: str) -> Output:
    return Output(
        load,
        "N*m" if load[0] == "m" else "N",
        lambda: Case.fields()[f"duty.load.{load}"].label,
        lambda given: getattr(given.solved.load, load),
    )


def _stiffness(load: str, axis: str) -> Output:
    unit = ("N*m" if load[0] == "m" else "N") + ("/rad" if len(axis) > 1 else "/m")
    along = AXES[LOADS.index(load)]
    return Output(
        f"stiffness_{along}{axis}",
        {"N*m/m": "N"}.get(unit, unit),
        lambda: said("stiffness {load}–{axis}", load=along, axis=axis),
        lambda given: given.solved.stiffness[load, axis],
    )


def _loaded_balls(given: Evaluation) -> Floats:
    load, _ = given.solved.pressed_on("inner")
    return np.where(np.isnan(load).any(axis=1), np.nan, (load > 0.0).sum(axis=1))


# --- the balls --------------------------------------------------------------------------------


def ball_outputs() -> tuple[Output, ...]:
    """Return the outputs of the balls: each by itself, and its maximum, minimum and mean."""
    azimuth = Output(
        "azimuth", "rad", lambda: said("azimuth of the ball"), _of_elements("azimuth"), along="ball"
    )
    return (azimuth, *_of_contacts(), *_of_balls())


def _of_contacts() -> Iterator[Output]:
    for race in RACES:
        for name, unit, called in _CONTACT:
            get = _of_race(race, name)
            yield from family(f"{race}_{name}", unit, at_race(race, called), get, race)


def _of_balls() -> Iterator[Output]:
    for name, unit, called in _BALL:
        yield from family(name, unit, partial(said, called), _of_elements(name), None)


def at_race(race: Race, quantity: str) -> Callable[[], str]:
    """Return what a quantity of the contacts with a race is called; to be said later."""
    if race == "inner":
        return lambda: said("{quantity}, inner race", quantity=said(quantity))
    return lambda: said("{quantity}, outer race", quantity=said(quantity))


def family(
    name: str,
    unit: str,
    called: Callable[[], str],
    get: Get,
    race: Race | None,
    needs: tuple[str, ...] = (),
) -> Iterator[Output]:
    """Make an output per ball, and what is taken of it over the balls; of some, over each row's.

    race: whose loads show which balls count, for outputs that mean nothing without load.
    """
    yield Output(name, unit, called, get, along="ball", needs=needs)
    among = race if name.endswith(_ONLY_LOADED) else None
    reduced = partial(_loaded_balls_of, called) if name.endswith(_ONLY_LOADED) else called
    for prefix, reduce in _REDUCTIONS:
        compute = _reduced(get, reduce, among)
        if prefix == "max" and race is not None and name.endswith("_max_pressure"):
            compute = _maximum_pressure(race)
        label = partial(_called_by, prefix, reduced)
        yield Output(f"{prefix}_{name}", unit, label, compute, needs=needs)
    for prefix, ufunc in _OF_ROWS:
        if name.endswith(_BY_ROW[prefix]):
            compute = _reduced_by_row(get, ufunc, among)
            label = partial(_per_row, partial(_called_by, prefix, reduced))
            yield Output(f"row_{prefix}_{name}", unit, label, compute, along="row", needs=needs)


def _loaded_balls_of(called: Callable[[], str]) -> str:
    return said("{quantity}, loaded balls", quantity=called())


def _called_by(reduction: str, called: Callable[[], str]) -> str:
    name = called()
    return {
        "max": said("maximum {quantity}", quantity=name),
        "min": said("minimum {quantity}", quantity=name),
        "mean": said("mean {quantity}", quantity=name),
    }[reduction]


def _per_row(called: Callable[[], str]) -> str:
    return said("{quantity}, per row", quantity=called())


def _of_elements(name: str) -> Get:
    return lambda given: getattr(given.solved.elements, name)


def _of_race(race: Race, name: str) -> Get:
    if name == "load":
        return lambda given: given.solved.pressed_on(race)[0]
    if name == "contact_angle":
        return lambda given: given.solved.pressed_on(race)[1].value
    return lambda given: getattr(given.solved.contacts[race], name)


def _reduced_by_row(get: Get, ufunc: np.ufunc, race: Race | None) -> Get:
    """Take the greatest or the least of each row's balls; (cases, rows)."""

    def reduced(given: Evaluation) -> Floats:
        values = _among(get, given, race)
        return np.asarray(ufunc.reduceat(values, given.solved.rows.starts, axis=1), np.float64)

    return reduced


def _among(get: Get, given: Evaluation, race: Race | None) -> Floats:
    """Return what each ball has; NaN where a race, if one is named, does not load it."""
    values = get(given)
    if race is None:
        return values
    return np.where(given.solved.pressed_on(race)[0] > 0.0, values, np.nan)


def _reduced(get: Get, reduce: Callable[[Floats], Floats], race: Race | None) -> Get:
    """Take something over the balls; over those that a race loads, if one is named."""
    return lambda given: reduce(_among(get, given, race))


def _maximum(values: Floats) -> Floats:
    return np.asarray(np.fmax.reduce(values, axis=1))


def _minimum(values: Floats) -> Floats:
    return np.asarray(np.fmin.reduce(values, axis=1))


def _mean(values: Floats) -> Floats:
    """Mean of what is there; NaN where nothing is."""
    there = ~np.isnan(values)
    count = there.sum(axis=1)
    total = np.where(there, values, 0.0).sum(axis=1)
    mean = np.full(len(values), np.nan)
    np.divide(total, count, out=mean, where=count > 0)
    return mean


_REDUCTIONS: Final = (("max", _maximum), ("min", _minimum), ("mean", _mean))
_OF_ROWS: Final = (("max", np.fmax), ("min", np.fmin))
_BY_ROW: Final = {
    "max": ("_load", "contact_angle", "max_pressure", "spin_to_roll"),
    "min": ("_load", "contact_angle", "spin_to_roll", "central_film_thickness", "film_parameter"),
}
"""What distinguishes one row of a set from another."""


def _maximum_pressure(race: Race) -> Get:
    return lambda given: maximum_pressure(given.solved, race)


def maximum_pressure(solved: Solved, race: Race) -> Floats:
    """Return the maximum pressure at a race, of balls without the pressures of all their contacts.

    Parameters
    ----------
    solved
        The cases.
    race
        ``"inner"`` or ``"outer"``.

    Returns
    -------
    (cases,), Pa.

    Only contacts that may have the maximum are evaluated. In a row, at a given load, the pressure
    grows with the curvature ρ_x in the rolling direction, as ρ_x to a power between 1/3 (where
    ρ_x = ρ_y) and 2/3 (ρ_y = 0), since p_0 goes with the curvatures to the power 2/3 altogether
    and ρ_x is the larger. With r = ρ_x over the largest of the row,

        Q^(1/3) r^(2/3)  ≤  p_0 / c  ≤  Q^(1/3) r^(1/3),

    and a contact whose upper bound is below another's lower bound has not the maximum.
    """
    load, angle = solved.pressed_on(race)
    found = np.full(len(solved), np.nan)
    rows = solved.rows
    conformity = getattr(rows, f"{race}_conformity")
    parts = zip(rows.element, rows.starts, rows.element_count, strict=True)
    for row, (element, first, count) in enumerate(parts):
        own = slice(first, first + count)
        line = None if element == "ball" else solved.contacts[race].line
        if line is not None:
            found = np.fmax(found, line.pressure[:, own].reshape(len(solved), -1).max(axis=1))
            continue
        ratio = (rows.ball_diameter[:, row] / rows.pitch_diameter[:, row])[:, np.newaxis]
        case, ball = np.nonzero(_candidates(load[:, own], angle.cosine[:, own], ratio, race))
        place = case, ball + first
        curvature = race_curvature(
            rows.ball_diameter[case, row],
            rows.pitch_diameter[case, row],
            conformity[case, row],
            angle.value[place],
            race,
        )
        ellipse = elliptical_contact(
            load[place], curvature.rolling, curvature.across, rows.modulus[case, row]
        )
        np.fmax.at(found, case, ellipse.max_pressure)
    return found


def _candidates(
    load: Floats, cosine: Floats, ratio: Floats, race: Race
) -> np.ndarray[Any, np.dtype[np.bool_]]:
    """Which contacts of a row may have the maximum pressure of their case; ratio: D/d_m.

    Of the bounds the cubes are compared.
    """
    sign = -1.0 if race == "inner" else 1.0
    curvature = 1.0 / (1.0 + sign * ratio * cosine)
    with np.errstate(invalid="ignore"):
        curvature /= curvature.max(axis=1, keepdims=True)
        above = load * curvature
        below = (above * curvature).max(axis=1, keepdims=True)
        return np.asarray(above >= (1.0 - _MARGIN) * below)
