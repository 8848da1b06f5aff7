"""How life depends on the required reliability: the factor a_1.

A Weibull distribution of slope 3/2; the edition of 2007 adds a minimum life that (nearly) every
bearing reaches, 5 % of the rating life:

    2007: a_1 = 0.95 [ln(1/S)/ln(1/0.9)]^(2/3) + 0.05
    1990: a_1 = [ln(1/S)/ln(1/0.9)]^(2/3).

The standards print a_1 from 90 % to 99.95 % (2007) and to 99 % (1990); both columns are these
formulas, rounded. Below 90 % the formula is continued: the median life, for instance.

Sources: ISO 281:2007, table 12; ISO 281:1990; Weibull (1951).
"""

from __future__ import annotations

from typing import Final, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from rolamento.numerics import BoolArray, FloatArray
from rolamento.validate import numbers, one_of, positive, within

Edition = Literal["2007", "1990"]

RATING_RELIABILITY: Final = 0.9
"""S of the rating life L_10."""
_MINIMUM_LIFE: Final = {"2007": 0.05, "1990": 0.0}
_PRINTED_TO: Final = {"2007": 0.9995, "1990": 0.99}
_SLOPE: Final = 1.5
_MINIMUM, _MAXIMUM = 0.01, 0.999999
_ROUNDING: Final = 1e-12


def reliability_factor(reliability: ArrayLike, edition: Edition = "2007") -> FloatArray:
    """Factor a_1 by which the life for a reliability differs from that for 90 %.

    Parameters
    ----------
    reliability : array, S, from 0.01 to 0.999999.
    edition : of ISO 281.

    Returns
    -------
    a_1 of that shape; 1 for 0.9.

    Raises
    ------
    InputError
        For a reliability out of range (a percentage, perhaps), or an unknown edition.

    >>> print(f"{reliability_factor(0.95):.2f}")
    0.64
    """
    s = within(
        reliability,
        "reliability",
        "",
        _MINIMUM,
        _MAXIMUM,
        example="reliability = 0.95",
        nan_too=False,
    )
    least = _MINIMUM_LIFE[_checked(edition)]
    risk = np.log(s) / np.log(RATING_RELIABILITY)
    return np.asarray((1.0 - least) * risk ** (1.0 / _SLOPE) + least)


def reliability_of(life_ratio: ArrayLike, edition: Edition = "2007") -> FloatArray:
    """Reliability S at a life, given as a multiple of the life for 90 %; inverse of a_1.

    Parameters
    ----------
    life_ratio : array, required life over L_10 (or over the life for 90 % of any theory).
    edition : of ISO 281.

    Returns
    -------
    S of that shape: 1 up to the minimum life of the edition.

    >>> print(f"{reliability_of(1.0):.2f}")
    0.90
    """
    ratio = positive(life_ratio, "life_ratio", zero=True)
    least = _MINIMUM_LIFE[_checked(edition)]
    risk = np.maximum((ratio - least) / (1.0 - least), 0.0) ** _SLOPE
    return np.asarray(RATING_RELIABILITY**risk)


def outside_print(reliability: ArrayLike, edition: Edition = "2007") -> BoolArray:
    """Return whether a reliability lies outside the standard's table, so that a_1 is continued."""
    s = numbers(reliability, "reliability")
    most = _PRINTED_TO[_checked(edition)]
    return np.asarray((s < RATING_RELIABILITY - _ROUNDING) | (s > most + _ROUNDING))


def _checked(edition: str) -> str:
    one_of(edition, "edition", get_args(Edition), 'edition = "2007"')
    return edition
