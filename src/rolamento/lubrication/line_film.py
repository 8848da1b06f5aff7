"""Film thickness of a line contact: a roller on its race.

Per unit of length, for the load q of a slice, with the radius R_x of rolling:

    U = η u / (E' R_x)      W' = q / (E' R_x)      G = α E'      H = h / R_x

Two pairs of formulas, each with the central and the minimum film: Pan and Hamrock (1989), which
were fitted to one set of computed films, and Dowson and Toyoda (1979) with Dowson (1968). The
films are isothermal and fully flooded, and know nothing of the ends of the roller. They hold where
the contact is elastic and the oil thickens under pressure; a light load at high speed leaves that
regime, which `rigid_film` shows. The heat of shear in the inlet is that of `film_thickness`: Murch
and Wilson found it for lines. The starvation there was computed for ellipses, and is not applied.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case.film_model import LineFilm
from rolamento.lubrication.film_thickness import FilmGroups, of_speed_and_oil
from rolamento.numerics import FloatArray
from rolamento.validate import within

MARTIN: Final = 4.896
"""Load times film of a rigid roller in a fluid of constant viscosity, w h/(η u R)."""


def line_groups(
    entrainment_speed: ArrayLike,
    load_per_length: ArrayLike,
    rolling_curvature: ArrayLike,
    modulus: ArrayLike,
    viscosity: ArrayLike,
    pressure_viscosity_coefficient: ArrayLike,
) -> FilmGroups:
    """Dimensionless groups U, W' and G; the ellipticity of a line is infinite.

    Parameters
    ----------
    entrainment_speed : array, m/s.
    load_per_length : array, q; N/m.
    rolling_curvature : array, 1/R_x; 1/m.
    modulus : array, effective modulus E' (2/E' = Σ (1 - ν²)/E); Pa.
    viscosity, pressure_viscosity_coefficient : arrays, at the inlet; Pa·s, 1/Pa.
        All broadcast against each other.

    Raises
    ------
    InputError
        If a number is negative, not finite, or far beyond any contact.
    """
    curvature, e, speed, material = of_speed_and_oil(
        entrainment_speed, rolling_curvature, modulus, viscosity, pressure_viscosity_coefficient
    )
    q = within(load_per_length, "load_per_length", "N/m", 0.0, 1e12)
    load = np.asarray(q * curvature / e)
    return FilmGroups(
        speed=speed,
        load=load,
        material=material,
        ellipticity=np.where(np.isnan(load), np.nan, np.inf),
    )


def pan_hamrock_central(groups: FilmGroups) -> FloatArray:
    """Central film over R_x: 2.922 U^0.692 G^0.470 W'^-0.166; NaN without load.

    Pan and Hamrock (1989), Journal of Tribology 111, 246.
    """
    return _power(groups, 2.922, 0.692, 0.470, -0.166)


def pan_hamrock_minimum(groups: FilmGroups) -> FloatArray:
    """Minimum film over R_x: 1.714 U^0.694 G^0.568 W'^-0.128; NaN without load.

    Pan and Hamrock (1989), Journal of Tribology 111, 246.
    """
    return _power(groups, 1.714, 0.694, 0.568, -0.128)


def dowson_toyoda_central(groups: FilmGroups) -> FloatArray:
    """Central film over R_x: 3.06 U^0.69 G^0.56 W'^-0.10; NaN without load.

    Dowson and Toyoda (1979), 5th Leeds-Lyon symposium.
    """
    return _power(groups, 3.06, 0.69, 0.56, -0.10)


def dowson_minimum(groups: FilmGroups) -> FloatArray:
    """Minimum film over R_x: 2.65 U^0.70 G^0.54 W'^-0.13; NaN without load.

    Dowson (1968), Proc. IMechE 182, part 3A, 151; often called Dowson and Higginson's.
    """
    return _power(groups, 2.65, 0.70, 0.54, -0.13)


def rigid_film(groups: FilmGroups) -> FloatArray:
    """Film over R_x of a rigid roller and a constant viscosity: 4.896 U/W'; infinite without load.

    Martin (1916), with the outlet where pressure and its slope vanish. Where it exceeds the films
    above, the contact is too lightly loaded for them.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(MARTIN * groups.speed / groups.load)


def line_film(groups: FilmGroups, formula: LineFilm) -> tuple[FloatArray, FloatArray]:
    """The central and the minimum film over R_x by a pair of formulas."""
    if formula == "dowson_toyoda":
        return dowson_toyoda_central(groups), dowson_minimum(groups)
    return pan_hamrock_central(groups), pan_hamrock_minimum(groups)


def _power(
    groups: FilmGroups, factor: float, speed: float, material: float, load: float
) -> FloatArray:
    loaded = np.where(groups.load > 0.0, groups.load, np.nan)
    return np.asarray(factor * groups.speed**speed * groups.material**material * loaded**load)
