"""What is left of the film where the inlet lacks oil."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento._reach import in_reach
from rolamento.case.film_model import Supply
from rolamento.numerics import FloatArray

REPLENISHMENT: Final[dict[Supply, float]] = {
    "bath": 3e-8,
    "jet": 3e-8,
    "grease": 6e-8,
    "oil_air": 6e-8,
}
"""K_rs by the way of lubrication. SKF, General catalogue (2018), frictional moment."""
BEARING_TYPE: Final = {"deep_groove": 3.1, "angular_contact": 4.4}
"""K_z. As above."""


def flooded_distance_central(
    film: ArrayLike, rolling_radius: ArrayLike, semi_minor: ArrayLike
) -> FloatArray:
    """Inlet distance m* in semi-axes b beyond which more oil does not thicken the central film.

    Parameters: film h/R_x, arrays; R_x and b, m. Returns m* = 1 + 3.06 ((R_x/b)² H)^0.58.
    Hamrock and Dowson (1977), part IV.
    """
    return _flooded(film, rolling_radius, semi_minor, 3.06, 0.58)


def flooded_distance_minimum(
    film: ArrayLike, rolling_radius: ArrayLike, semi_minor: ArrayLike
) -> FloatArray:
    """As `flooded_distance_central` for the minimum film: m* = 1 + 3.34 ((R_x/b)² H)^0.56."""
    return _flooded(film, rolling_radius, semi_minor, 3.34, 0.56)


def inlet_distance_central(distance: ArrayLike, flooded: ArrayLike) -> FloatArray:
    """Share of the central film that is left, ((m - 1)/(m* - 1))^0.29, at most 1.

    Parameters: m, distance of the oil's beginning from the centre over b, and m*, arrays. Returns
    the broadcast shape; 0 where the oil begins inside the contact. Hamrock and Dowson (1977), IV.
    """
    return _share(distance, flooded, 0.29)


def inlet_distance_minimum(distance: ArrayLike, flooded: ArrayLike) -> FloatArray:
    """As `inlet_distance_central` for the minimum film, with the exponent 0.25."""
    return _share(distance, flooded, 0.25)


def replenishment(
    viscosity: ArrayLike,
    speed: ArrayLike,
    bore: float,
    outside_diameter: float,
    supply: Supply,
    *,
    angular_contact: bool,
) -> FloatArray:
    """Factor of how well the track is refilled between balls.

    Parameters
    ----------
    viscosity : array, kinematic, in operation; m²/s.
    speed : array, of the rings against each other; rad/s.
    bore, outside_diameter : m.
    supply : way of lubrication.
    angular_contact : whether the bearing is one, or else a deep-groove bearing.

    Returns
    -------
    exp(-K_rs ν n (d + D) √(K_z / (2 (D - d)))) in mm²/s, r/min and mm; the broadcast shape.

    SKF, General catalogue (2018): there of the rolling friction, which follows the film.
    """
    d = 1e3 * float(in_reach(bore, "bore", "m", 0.0, 1e3))
    outside = 1e3 * float(
        in_reach(outside_diameter, "outside_diameter", "m", bore, 1e3, least_too=False)
    )
    kind = BEARING_TYPE["angular_contact" if angular_contact else "deep_groove"]
    nu = in_reach(viscosity, "viscosity", "m²/s", 0.0, 1e6)
    omega = in_reach(speed, "speed", "rad/s", 0.0, 1e9)
    flow = nu * omega * 1e6 * 30.0 / np.pi
    spread = (d + outside) * np.sqrt(kind / (2.0 * (outside - d)))
    return np.asarray(np.exp(-REPLENISHMENT[supply] * flow * spread))


def _flooded(
    film: ArrayLike,
    rolling_radius: ArrayLike,
    semi_minor: ArrayLike,
    factor: float,
    exponent: float,
) -> FloatArray:
    radius = in_reach(rolling_radius, "rolling_radius", "m", 1e-12, 1e9)
    b = in_reach(semi_minor, "semi_minor", "m", 1e-15, 1e3)
    ratio = radius / b
    return np.asarray(1.0 + factor * (ratio**2 * in_reach(film, "film", "", 0.0, 1e9)) ** exponent)


def _share(distance: ArrayLike, flooded: ArrayLike, exponent: float) -> FloatArray:
    beyond = np.maximum(in_reach(distance, "distance", "", 0.0, 1e30) - 1.0, 0.0)
    needed = np.asarray(flooded, dtype=np.float64) - 1.0
    with np.errstate(divide="ignore", invalid="ignore"):
        share = np.minimum(beyond / needed, 1.0) ** exponent
    return np.asarray(np.where(needed > 0.0, share, np.where(np.isnan(needed), np.nan, 1.0)))
