"""Film thickness of an elliptical contact, and what heat and lack of oil leave of it.

Isothermal and fully flooded first: every group takes the radius R_x of the rolling direction, 1/R_x
summed over both bodies with a hollow negative, and k is the exact ratio of the semi-axes, across
over along rolling:

    U = η u / (E' R_x)      W = Q / (E' R_x²)      G = α E'      H = h / R_x

The heat of shear in the inlet goes by the loading L = η b u²/k_f with b = -d ln η/dT there. Heat
and lack of oil take from the rolling resistance of the oil as they take from the film.
"""

from __future__ import annotations

from functools import cached_property
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case.film_model import Supply
from rolamento.errors import InputError
from rolamento.io.data import toml_of
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import within
from rolamento.words import said

COMPUTED_RANGE: Final[dict[str, tuple[float, float]]] = {
    "U": (8e-13, 5.1e-11),
    "W": (1.1e-7, 1.3e-6),
    "G": (2300.0, 6800.0),
    "k": (1.0, 8.0),
}
"""What the formulas were fitted to, rounded outward; rolling bearings mostly lie beyond in W."""

REPLENISHMENT: Final[dict[Supply, float]] = {
    "bath": 3e-8,
    "jet": 3e-8,
    "grease": 6e-8,
    "oil_air": 6e-8,
}
"""K_rs by the way of lubrication. SKF, General catalogue (2018), frictional moment."""


def spreading_factor(kind: str) -> float:
    """Return K_z of a kind of bearing.

    SKF, General catalogue (2018), frictional moment; it has none of needle roller bearings, which
    take that of cylindrical ones.
    """
    return float(toml_of("skf_friction")["K_Z"][kind])


_RPM: Final = 30.0 / np.pi


@frozen(slots=False)
class FilmGroups:
    """Dimensionless groups of a contact; arrays of one shape."""

    speed: FloatArray
    """U"""
    load: FloatArray
    """W"""
    material: FloatArray
    """G"""
    ellipticity: FloatArray
    """k = a/b"""

    def powers(self, speed: float, material: float, load: float) -> FloatArray:
        """U, G and W to these powers, multiplied; NaN without load."""
        u, g, w = self._logarithms
        return np.asarray(np.exp(speed * u + material * g + load * w))

    @cached_property
    def _logarithms(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        with np.errstate(divide="ignore"):
            return (
                np.log(self.speed),
                np.log(self.material),
                np.log(np.where(self.load > 0.0, self.load, np.nan)),
            )


def film_groups(
    entrainment_speed: ArrayLike,
    load: ArrayLike,
    rolling_curvature: ArrayLike,
    ellipticity: ArrayLike,
    modulus: ArrayLike,
    viscosity: ArrayLike,
    pressure_viscosity_coefficient: ArrayLike,
) -> FilmGroups:
    """Dimensionless groups U, W, G and k.

    Parameters
    ----------
    entrainment_speed, load : arrays; m/s, N.
    rolling_curvature : array, 1/R_x; 1/m.
    ellipticity : array, a/b.
    modulus : array, effective modulus E' (2/E' = Σ (1 - ν²)/E); Pa.
    viscosity, pressure_viscosity_coefficient : arrays, at the inlet; Pa·s, 1/Pa.
        All broadcast against each other.

    Raises
    ------
    InputError
        If a number is negative, not finite, or far beyond any contact.

    Hamrock and Dowson (1977).
    """
    curvature, e, speed, material = of_speed_and_oil(
        entrainment_speed, rolling_curvature, modulus, viscosity, pressure_viscosity_coefficient
    )
    q = within(load, "load", "N", 0.0, 1e12)
    return FilmGroups(
        speed=speed,
        load=np.asarray(q * curvature**2 / e),
        material=material,
        ellipticity=within(ellipticity, "ellipticity", "", 0.0, 1e9),
    )


def of_speed_and_oil(
    entrainment_speed: ArrayLike,
    rolling_curvature: ArrayLike,
    modulus: ArrayLike,
    viscosity: ArrayLike,
    pressure_viscosity_coefficient: ArrayLike,
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """1/R_x and E', checked, and the groups U and G, as of `film_groups`."""
    u = within(entrainment_speed, "entrainment_speed", "m/s", 0.0, 1e6)
    curvature = within(rolling_curvature, "rolling_curvature", "1/m", 1e-9, 1e12)
    e = within(modulus, "modulus", "Pa", 1.0, 1e15)
    eta = within(viscosity, "viscosity", "Pa·s", 0.0, 1e9)
    alpha = within(
        pressure_viscosity_coefficient, "pressure_viscosity_coefficient", "1/Pa", 0.0, 1e-3
    )
    return curvature, e, np.asarray(eta * u * curvature / e), np.asarray(alpha * e)


def central_film(groups: FilmGroups) -> FloatArray:
    """Central film over R_x: 2.69 U^0.67 G^0.53 W^-0.067 (1 - 0.61 e^(-0.73 k)).

    NaN without load. Hamrock and Dowson (1977), part III.

    >>> groups = film_groups(3.0, 1000.0, 200.0, 8.0, 2.27e11, 0.017, 1.8e-8)
    >>> found = 1e6 * central_film(groups) / 200.0  # of R_x = 5 mm
    >>> print(f"{found:.3f} um")
    0.229 um
    """
    shape = 1.0 - 0.61 * np.exp(-0.73 * groups.ellipticity)
    return 2.69 * groups.powers(0.67, 0.53, -0.067) * shape


def minimum_film(groups: FilmGroups) -> FloatArray:
    """Minimum film over R_x: 3.63 U^0.68 G^0.49 W^-0.073 (1 - e^(-0.68 k)).

    NaN without load. Hamrock and Dowson (1977), part III.

    >>> groups = film_groups(3.0, 1000.0, 200.0, 8.0, 2.27e11, 0.017, 1.8e-8)
    >>> found = 1e6 * minimum_film(groups) / 200.0  # of R_x = 5 mm
    >>> print(f"{found:.3f} um")
    0.184 um
    """
    shape = 1.0 - np.exp(-0.68 * groups.ellipticity)
    return 3.63 * groups.powers(0.68, 0.49, -0.073) * shape


# --- heat of shear in the inlet ---------------------------------------------------------------


def thermal_loading(
    viscosity: ArrayLike,
    viscosity_temperature_coefficient: ArrayLike,
    entrainment_speed: ArrayLike,
    thermal_conductivity: ArrayLike,
) -> FloatArray:
    """Loading parameter L = η b u²/k_f; dimensionless.

    Parameters: arrays that broadcast; Pa·s, 1/K, m/s, W/(m·K). Returns the broadcast shape.
    Raises InputError if a number is negative, not finite, or far beyond any oil.

    >>> print(f"{thermal_loading(0.017, 0.03, 3.0, 0.13):.4f}")
    0.0353
    """
    eta = within(viscosity, "viscosity", "Pa·s", 0.0, 1e9)
    falling = within(
        viscosity_temperature_coefficient, "viscosity_temperature_coefficient", "1/K", 0.0, 1e3
    )
    u = within(entrainment_speed, "entrainment_speed", "m/s", 0.0, 1e6)
    conductivity = within(thermal_conductivity, "thermal_conductivity", "W/(m·K)", 1e-6, 1e6)
    return np.asarray(eta * falling * u**2 / conductivity)


def murch_wilson(loading: ArrayLike) -> FloatArray:
    """Share of the film that is left, 3.94/(3.94 + L^0.62); at most 1.

    Parameters: L, array, at least 0. Returns its shape. Murch and Wilson (1975), for rolling.

    >>> print(f"{murch_wilson(0.5):.3f}")
    0.858
    """
    return np.asarray(3.94 / (3.94 + within(loading, "loading", "", 0.0, 1e40) ** 0.62))


def gupta_cheng(
    loading: ArrayLike, max_pressure: ArrayLike, modulus: ArrayLike, slide_to_roll: ArrayLike
) -> FloatArray:
    """Share of the film that is left under load and sliding; at least 0.

    Parameters
    ----------
    loading : array, L.
    max_pressure, modulus : arrays, Hertz pressure and E'; Pa.
    slide_to_roll : array, sliding over entrainment speed.
        All broadcast against each other.

    Gupta, Cheng, Zhu, Forster and Schrand (1992):
    (1 - 13.2 (p_0/E') L^0.42) / (1 + 0.213 (1 + 2.23 S^0.83) L^0.64).
    """
    loading = within(loading, "loading", "", 0.0, 1e40)
    pressure = within(max_pressure, "max_pressure", "Pa", 0.0, 1e15)
    modulus = within(modulus, "modulus", "Pa", 1.0, 1e15)
    strained = 1.0 - 13.2 * pressure / modulus * loading**0.42
    sliding = 1.0 + 2.23 * within(slide_to_roll, "slide_to_roll", "", 0.0, 1e40) ** 0.83
    return np.asarray(np.maximum(strained, 0.0) / (1.0 + 0.213 * sliding * loading**0.64))


def aihara(loading: ArrayLike) -> FloatArray:
    """Share of the oil's rolling resistance that is left, 1/(1 + 0.29 L^0.78); at most 1.

    Parameters: L, array, at least 0. Returns its shape. Aihara (1987), equation 27, a fit to the
    thermal inlet of Goksem and Hargreaves (1978) for lines; NSK's ball bearing program D-BRAIN has
    it for points as well.

    >>> print(f"{aihara(0.5):.3f}")
    0.856
    """
    return np.asarray(1.0 / (1.0 + 0.29 * within(loading, "loading", "", 0.0, 1e40) ** 0.78))


def skf_inlet_heating(
    viscosity: ArrayLike, speed: ArrayLike, mean_diameter: ArrayLike
) -> FloatArray:
    """Share of the rolling resistance of a whole bearing that the heat in its inlets leaves.

    Parameters
    ----------
    viscosity : array, kinematic, in operation; m²/s.
    speed : array, of the rings against each other; rad/s.
    mean_diameter : array, d_m; m.

    Returns
    -------
    φ_ish = 1/(1 + 1.84e-9 (n d_m)^1.28 ν^0.64) in r/min, mm and mm²/s; the broadcast shape.

    SKF, Rolling bearings (10000 EN, 2013), frictional moment.
    """
    n = _RPM * within(speed, "speed", "rad/s", 0.0, 1e9)
    mean = 1e3 * within(mean_diameter, "mean_diameter", "m", 0.0, 1e3)
    nu = 1e6 * within(viscosity, "viscosity", "m²/s", 0.0, 1e6)
    return np.asarray(1.0 / (1.0 + 1.84e-9 * (n * mean) ** 1.28 * nu**0.64))


# --- lack of oil in the inlet -----------------------------------------------------------------


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
    return _share_left(distance, flooded, 0.29)


def inlet_distance_minimum(distance: ArrayLike, flooded: ArrayLike) -> FloatArray:
    """As `inlet_distance_central` for the minimum film, with the exponent 0.25."""
    return _share_left(distance, flooded, 0.25)


def replenishment(
    viscosity: ArrayLike,
    speed: ArrayLike,
    bore: ArrayLike,
    outside_diameter: ArrayLike,
    supply: Supply,
    *,
    kind: str | float,
) -> FloatArray:
    """Factor of how well the track is refilled between balls.

    Parameters
    ----------
    viscosity : array, kinematic, in operation; m²/s.
    speed : array, of the rings against each other; rad/s.
    bore, outside_diameter : arrays; m.
    supply : way of lubrication, a key of `REPLENISHMENT`.
    kind : of bearing, as SKF names it, or its K_z.

    Returns
    -------
    exp(-K_rs ν n (d + D) √(K_z / (2 (D - d)))) in mm²/s, r/min and mm; the broadcast shape.

    SKF, General catalogue (2018): there of the rolling friction, which follows the film.
    """
    d = 1e3 * within(bore, "bore", "m", 0.0, 1e3)
    outside = 1e3 * within(outside_diameter, "outside_diameter", "m", 0.0, 1e3)
    if np.any(outside <= d):
        raise InputError(said("must be greater than the bore diameter"), field="outside_diameter")
    spreading = spreading_factor(kind) if isinstance(kind, str) else kind
    nu = within(viscosity, "viscosity", "m²/s", 0.0, 1e6)
    omega = within(speed, "speed", "rad/s", 0.0, 1e9)
    flow = nu * omega * 1e6 * _RPM
    spread = (d + outside) * np.sqrt(spreading / (2.0 * (outside - d)))
    return np.asarray(np.exp(-REPLENISHMENT[supply] * flow * spread))


def _flooded(
    film: ArrayLike,
    rolling_radius: ArrayLike,
    semi_minor: ArrayLike,
    factor: float,
    exponent: float,
) -> FloatArray:
    radius = within(rolling_radius, "rolling_radius", "m", 1e-12, 1e9)
    b = within(semi_minor, "semi_minor", "m", 1e-15, 1e3)
    ratio = radius / b
    return np.asarray(1.0 + factor * (ratio**2 * within(film, "film", "", 0.0, 1e9)) ** exponent)


def _share_left(distance: ArrayLike, flooded: ArrayLike, exponent: float) -> FloatArray:
    beyond = np.maximum(within(distance, "distance", "", 0.0, 1e30) - 1.0, 0.0)
    needed = np.asarray(flooded, dtype=np.float64) - 1.0
    with np.errstate(divide="ignore", invalid="ignore"):
        share = np.minimum(beyond / needed, 1.0) ** exponent
    return np.asarray(np.where(needed > 0.0, share, np.where(np.isnan(needed), np.nan, 1.0)))
