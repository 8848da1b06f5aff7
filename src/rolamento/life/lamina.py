"""Basic reference rating life of roller rows, from the loads of the single slices of each roller.

A roller is cut into n_s slices (laminae) of equal width. Each race has a rating for a whole roller,
and each slice its part of it:

    Q_ci = C/(0.378 λν Z cos α i^(7/9)) (1 + T^(9/2))^(2/9)
    Q_ce = C/(0.364 λν Z cos α i^(7/9)) (1 + T^(-9/2))^(2/9)
    T = 1.038 ((1-γ)/(1+γ))^(143/108),   λν = 0.83,   q_c = Q_c n_s^(-7/9);

thrust bearings have C_a/(λν Z sin α) with λν = 0.73 and no 1.038. λν, by which C counts edge stress
and uneven loading, is undone here, for both are in the loads. On a race that turns against the load
the slices of one place pass all rollers, and count by the mean of power 4; on one that stands by
that of power 9/2. The slices of a race live together by the product of their reliabilities:

    L = {Σ_k (q_ke/q_kc)^(9/2)}^(-8/9),      and so do the races and rows of a bearing.

Independent slices know nothing of the peak at the end of a line; the standard multiplies their
loads by f_k = 1 - 0.01/ln(1.985 |(2k - n_s - 1)/(2 n_s - 2)|), which is 2.33 at the last slice
however narrow it is. Where the contact was computed with the slices coupled, the peak is in the
loads, and f_k would count it twice: it is left out there. So the number of slices is part of the
method: lives with different numbers, or of different contacts, are not compared.

Sources: ISO/TS 16281:2008, 5.3 and 5.4, as transcribed in public source code; Lundberg and Palmgren
(1952).
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.life.iso16281 import ROLLER_SLOPE, RaceRatings
from rolamento.numerics import FloatArray
from rolamento.ratings.rollers import REDUCTION, THRUST_REDUCTION, roller_race_shares
from rolamento.validate import numbers, positive
from rolamento.words import said

EXPONENT: Final = 4.0
"""Exponent of the load, in the life of a line contact."""
_RISK: Final = EXPONENT * ROLLER_SLOPE
_SLICE_SHARE: Final = 7.0 / 9.0


def roller_race_ratings(
    dynamic_rating: ArrayLike,
    roller_count: ArrayLike,
    roller_diameter: ArrayLike,
    pitch_diameter: ArrayLike,
    contact_angle: ArrayLike,
    *,
    thrust: bool = False,
) -> RaceRatings:
    """Load ratings of a roller on the races of a row.

    Parameters
    ----------
    dynamic_rating : array, C_r of one row (that of i rows is i^(7/9) as much), or C_a; N.
    roller_count : array, Z.
    roller_diameter, pitch_diameter : arrays, D_we and d_pw; m.
    contact_angle : array, nominal α; rad.
        All broadcast against each other.
    thrust : whether the bearing is rated for axial load.

    ISO/TS 16281:2008, equations 47 to 55.
    """
    rating = positive(dynamic_rating, "dynamic_rating")
    angle = numbers(contact_angle, "contact_angle")
    cosine = np.where(angle >= np.pi / 2, 0.0, np.cos(angle))
    size = numbers(roller_diameter, "roller_diameter") / numbers(pitch_diameter, "pitch_diameter")
    rollers = numbers(roller_count, "roller_count")
    if thrust:
        inner, outer = roller_race_shares(size * cosine, 1.0)
        roller = rating / (THRUST_REDUCTION * rollers * np.sin(angle))
        return RaceRatings(np.asarray(roller * inner), np.asarray(roller * outer))
    inner, outer = roller_race_shares(size * cosine, 1.038)
    roller = rating / (REDUCTION * rollers * cosine)
    return RaceRatings(np.asarray(roller / 0.378 * inner), np.asarray(roller / 0.364 * outer))


def edge_factor(slices: int) -> FloatArray:
    """Return f_k by which the loads of independent slices count, for the stress at the ends.

    Parameters
    ----------
    slices : n_s, above 1.

    Returns
    -------
    (slices,): 1 in the middle, 2.33 at both ends.

    ISO/TS 16281:2008, 5.3.3.
    """
    k = np.arange(1.0, slices + 1.0)
    place = 1.985 * np.abs(2.0 * k - slices - 1.0) / (2.0 * slices - 2.0)
    with np.errstate(divide="ignore"):
        return np.asarray(1.0 - 0.01 / np.log(place))


def equivalent_slice_load(load: ArrayLike, *, turning: ArrayLike) -> FloatArray:
    """Mean load q_ke of the slices at each place of a race, by what it does to the life.

    Parameters
    ----------
    load : array (…, Z, slices), of the slices of the rollers, N or N/m; none is 0.
    turning : array that broadcasts with (…), whether the race turns against the load.

    Returns
    -------
    Array (…, slices), in the unit of the loads.

    ISO/TS 16281:2008, equations 61 to 64: mean of power 4 if turning, else of power 9/2.
    """
    q = np.maximum(numbers(load, "load"), 0.0)
    scale = q.max(axis=(-2, -1), keepdims=True)
    part = q / np.where(scale > 0.0, scale, 1.0)
    fourth = np.square(np.square(part))
    turned = fourth.mean(axis=-2) ** (1.0 / EXPONENT)
    stood = (fourth * np.sqrt(part)).mean(axis=-2) ** (1.0 / _RISK)
    return np.asarray(scale[..., 0] * np.where(np.asarray(turning)[..., None], turned, stood))


def lamina_life(
    rating: ArrayLike,
    load: ArrayLike,
    *,
    turning: ArrayLike,
    edges: bool = True,
) -> FloatArray:
    """Life of a race from the loads of the slices of its rollers; millions of revolutions.

    Parameters
    ----------
    rating : array (…), Q_c of a whole roller; N.
    load : array (…, Z, slices), of the slices; N.
    turning : array that broadcasts with (…), whether the race turns against the load.
    edges : whether the loads count by `edge_factor`: not if the slices were coupled.

    Returns
    -------
    Array (…); infinite without load.

    ISO/TS 16281:2008, 5.3.5.
    """
    q = numbers(load, "load")
    slices = q.shape[-1]
    equivalent = equivalent_slice_load(q * edge_factor(slices) if edges else q, turning=turning)
    slice_rating = numbers(rating, "rating") * slices**-_SLICE_SHARE
    with np.errstate(divide="ignore"):
        risk = np.sum((equivalent / slice_rating[..., np.newaxis]) ** _RISK, axis=-1)
        return np.asarray(risk ** (-1.0 / ROLLER_SLOPE))


def one_number_of_slices(slices: Iterable[int | None]) -> int | None:
    """Return how many slices all of several lives were computed with.

    Parameters
    ----------
    slices : of each life; None of a bearing without rollers.

    Returns
    -------
    The number; None without any rollers.

    Raises
    ------
    InputError
        If they differ: the edge factor is tied to the slice, and the lives are not to be compared.
    """
    different = sorted({number for number in slices if number is not None})
    if len(different) > 1:
        raise InputError(
            said(
                "differ: {numbers}. The edge factor of ISO/TS 16281 acts on the outermost slice"
                " however narrow it is, so lives with different numbers of slices cannot be"
                " compared",
                numbers=", ".join(map(str, different)),
            ),
            field="model.slices",
            example="slices = 35",
        )
    return different[0] if different else None
