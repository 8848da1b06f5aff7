"""Clearance under radial load: the load zone ε, and what it does to the life.

A ring with clearance Δ (diametral) under a radial load F_r carries on the part ε of its diameter:

    f(ε) = (1 - 2ε)/(ε J_r(ε)^(2/3)) = Δ K^(2/3)/(F_r/Z)^(2/3),

K being the stiffness of a ball between both races; makers write K^(-2/3) as 0.00044 D^(-1/3) in N
and mm. At ε = 0.5 there is no clearance, and the rating life is defined there. Life is greatest
with some preload, ε about 0.7 to 0.8. The balls count as a continuous ring here.

Rollers of straight lines likewise, with 9/10 in the place of 2/3 and K of both contacts by ISO/TS
16281; their life ratio leaves out the edges.

Sources: NSK, Rolling Bearings (E1102), 9.2; Sjövall (1933); ISO/TS 16281:2008 for the mean loads.
"""

from __future__ import annotations

from functools import cache
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.contact.line import EXPONENT as LINE
from rolamento.life.iso16281 import ROLLER_SLOPE, RaceRatings, race_life, system_life
from rolamento.life.lamina import EXPONENT as LAMINA_EXPONENT
from rolamento.numerics import FloatArray
from rolamento.static.sjovall import sjovall_radial
from rolamento.validate import numbers, positive

NO_CLEARANCE: Final = 0.5
_CATALOGUE: Final = 0.00044
"""δ Q^(-2/3) D^(1/3) of steel balls; N, mm."""
_NODES: Final = 64
_MINIMUM, _MAXIMUM = 1e-5, 1e5
_GRID: Final = 4001
_STEPS: Final = 4


def catalogue_stiffness(ball_diameter: ArrayLike) -> FloatArray:
    """Stiffness K of a steel ball between both races, as makers take it; N/m^1.5.

    Parameters: array, D; m. K = D^½/0.00044^1.5 in N and mm. NSK E1102, 9.2.
    """
    diameter = positive(ball_diameter, "ball_diameter") * 1e3
    return np.asarray(np.sqrt(diameter) / _CATALOGUE**1.5 * 1e3**1.5)


def clearance_function(load_zone: ArrayLike) -> FloatArray:
    """f(ε) = (1 - 2ε)/(ε J_r^(2/3)), falling from +∞ to -∞. Parameters: array, ε > 0."""
    epsilon = positive(load_zone, "load_zone")
    return np.asarray((1.0 - 2.0 * epsilon) / (epsilon * np.cbrt(sjovall_radial(epsilon)) ** 2))


def load_zone(
    diametral_clearance: ArrayLike,
    radial_load: ArrayLike,
    ball_count: ArrayLike,
    stiffness: ArrayLike,
) -> FloatArray:
    """Load zone ε of a radially loaded ring.

    Parameters
    ----------
    diametral_clearance : array, Δ in operation; m, negative for preload.
    radial_load : array, F_r; N.
    ball_count : array, Z.
    stiffness : array, K of a ball between both races; N/m^1.5.
        All broadcast against each other.

    Returns
    -------
    ε of the broadcast shape, from 1e-5 to 1e5; NaN beyond, or without load.
    """
    load = positive(radial_load, "radial_load", zero=True) / positive(ball_count, "ball_count")
    clearance, load, k = np.broadcast_arrays(
        numbers(diametral_clearance, "diametral_clearance"), load, positive(stiffness, "stiffness")
    )
    with np.errstate(divide="ignore", invalid="ignore"):
        target = clearance * np.cbrt(k / load) ** 2
    grid, values = _grid()
    inside = (target <= values[0]) & (target >= values[-1])
    return np.where(inside, _refined(np.where(inside, target, 0.0), grid, values), np.nan)


def zone_life(load_zone: ArrayLike, ratings: RaceRatings) -> FloatArray:
    """Life at a load zone over the life at ε = 0.5, under the same radial load.

    Parameters
    ----------
    load_zone : array, ε > 0.
    ratings : of the races, arrays that broadcast with it; the inner ring turns.

    Returns
    -------
    Array of the broadcast shape; above 1 from a little preload.

    ISO/TS 16281:2008 over a continuous ring of balls.
    """
    epsilon = positive(load_zone, "load_zone")
    return np.asarray(_life_at(epsilon, ratings) / _life_at(np.asarray(NO_CLEARANCE), ratings))


def continuous_life(
    load_zone: ArrayLike, ratings: RaceRatings, radial_load: ArrayLike, ball_count: ArrayLike
) -> FloatArray:
    """Reference life under a radial load that a continuous ring of balls carries.

    Parameters: arrays that broadcast: ε, F_r (N) and Z; the ratings likewise. Returns millions of
    revolutions. At ε = 0.5 and a conformity of 0.52 this is (C/F_r)³.
    """
    ball = positive(radial_load, "radial_load") / numbers(ball_count, "ball_count")
    return np.asarray(_life_at(positive(load_zone, "load_zone"), ratings) / ball**3)


def mean_loads(load_zone: ArrayLike) -> tuple[FloatArray, FloatArray]:
    """J_1 and J_2: means of the ball loads over the heaviest, cubic and of power 10/3.

    Parameters: array, ε > 0. Returns two arrays of its shape: for the turning ring, and for the
    standing one. Lundberg and Palmgren (1947).
    """
    epsilon = positive(load_zone, "load_zone")
    return _mean(epsilon, 4.5) ** (1.0 / 3.0), _mean(epsilon, 5.0) ** 0.3


def roller_radial(load_zone: ArrayLike) -> FloatArray:
    """J_r of rollers: F_r over Z times the heaviest roller's load, for straight lines.

    Parameters: array, ε > 0. 0.2448 at ½; the 0.2453 of Harris (1991) and of ISO 281, annex B, is
    that of the exponent 1.1.
    """
    epsilon = positive(load_zone, "load_zone")
    whole, more = _mean(epsilon, LINE), _mean(epsilon, LINE + 1.0)
    return np.asarray((1.0 - 2.0 * epsilon) * whole + 2.0 * epsilon * more)


def roller_clearance_function(load_zone: ArrayLike) -> FloatArray:
    """f(ε) = (1 - 2ε)/(ε J_r^(9/10)) = Δ K^(9/10)/(F_r/Z)^(9/10) of rollers.

    Parameters: array, ε > 0. K: `rolamento.contact.line.pair_constant`, N/m^(10/9).
    """
    epsilon = positive(load_zone, "load_zone")
    return np.asarray((1.0 - 2.0 * epsilon) / (epsilon * roller_radial(epsilon) ** (1.0 / LINE)))


def roller_zone_life(load_zone: ArrayLike, ratings: RaceRatings) -> FloatArray:
    """Life of rollers at a load zone over the life at ε = 0.5, under the same radial load.

    Parameters
    ----------
    load_zone : array, ε > 0.
    ratings : of the races, arrays that broadcast with it; the inner ring turns.

    ISO/TS 16281:2008 over a continuous ring of straight rollers, without edges.
    """
    epsilon = positive(load_zone, "load_zone")
    half = _roller_life_at(np.asarray(NO_CLEARANCE), ratings)
    return np.asarray(_roller_life_at(epsilon, ratings) / half)


def _roller_life_at(epsilon: FloatArray, ratings: RaceRatings) -> FloatArray:
    heaviest = 1.0 / roller_radial(epsilon)
    turning = _mean(epsilon, 4.0 * LINE) ** (1.0 / 4.0)
    standing = _mean(epsilon, 4.5 * LINE) ** (1.0 / 4.5)
    races = [
        (rating / (heaviest * mean)) ** LAMINA_EXPONENT
        for rating, mean in ((ratings.inner, turning), (ratings.outer, standing))
    ]
    return system_life(np.stack(np.broadcast_arrays(*races)), axis=0, slope=ROLLER_SLOPE)


def _life_at(epsilon: FloatArray, ratings: RaceRatings) -> FloatArray:
    """Life under a radial load of 1 N for each ball."""
    turning, standing = mean_loads(epsilon)
    heaviest = 1.0 / sjovall_radial(epsilon)
    inner = race_life(ratings.inner, heaviest * turning)
    outer = race_life(ratings.outer, heaviest * standing)
    return system_life(np.stack(np.broadcast_arrays(inner, outer)), axis=0)


def _mean(epsilon: FloatArray, power: float) -> FloatArray:
    """Mean round the ring of w^power, w = 1 - (1 - cos ψ)/(2ε) where positive.

    With sin(ψ/2) = √ε sin θ up to ε = 1, and θ = ψ/2 above: smooth on a quarter turn.
    """
    node, weight = np.polynomial.legendre.leggauss(_NODES)
    theta, weight = 0.25 * np.pi * (node + 1.0), 0.25 * np.pi * weight
    with np.errstate(divide="ignore"):
        m = np.minimum(epsilon, 1.0 / epsilon)[..., np.newaxis]
    delta = np.sqrt(1.0 - m * np.sin(theta) ** 2)
    partial = (epsilon <= 1.0)[..., np.newaxis]
    part = np.where(partial, np.cos(theta) ** (2.0 * power + 1.0) / delta, delta ** (2.0 * power))
    return np.asarray(2.0 / np.pi * np.sqrt(np.minimum(epsilon, 1.0)) * (part @ weight))


@cache
def _grid() -> tuple[FloatArray, FloatArray]:
    """Logarithms of ε and f there, from the narrowest zone to the widest."""
    grid = np.linspace(np.log(_MINIMUM), np.log(_MAXIMUM), _GRID)
    return grid, clearance_function(np.exp(grid))


def _refined(target: FloatArray, grid: FloatArray, values: FloatArray) -> FloatArray:
    """ε where f is the target: from the grid, then by secants of f over ln ε."""
    position = np.interp(-target, -values, grid)
    for _ in range(_STEPS):
        epsilon, step = np.exp(position), 1e-5
        value = clearance_function(epsilon)
        slope = (clearance_function(epsilon * np.exp(step)) - value) / step
        position = np.clip(position - (value - target) / slope, grid[0], grid[-1])
    return np.asarray(np.exp(position))
