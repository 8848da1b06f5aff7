"""How far a profile drops below the straight generator, at places along a roller.

A drop is that of one body against a straight counterpart; drops of roller and race add up. At the
end of the effective length a logarithmic profile drops without bound, and beyond it there is no
contact at all: both are infinite here, and slices, whose middles lie inside, do not meet them.

Sources: Lundberg (1939) for the logarithm, which a line load of even pressure leaves; Johns and
Gohar (1981) for its finite form; Fujiwara and Kawase (2007), NTN Technical Review 75, for a
straight middle; ISO/TS 16281:2008 for the profile to assume; Harris (1991), section 6, for crowns.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case.profile import Profile, ProfileKind
from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.units import readable
from rolamento.words import said

__all__ = ["ISO_FACTOR", "ISO_FACTOR_TAPERED", "drop"]

ISO_FACTOR: Final = 0.00035
"""Profile factor of cylindrical and needle rollers, L_we ≤ 2.5 D_we. ISO/TS 16281:2008. It is the
drop that evens out some 3000 MPa of steel: Lundberg's amplitude 2q/(πE') is then 2 D p0²/E'² =
0.00035 D."""

ISO_FACTOR_TAPERED: Final = 0.00045
"""Profile factor of rollers of tapered and thrust bearings. ISO/TS 16281:2008."""

_LONG: Final = 2.5
"""L_we/D_we above which ISO/TS 16281:2008 leaves the middle of a cylindrical roller straight."""
_LONG_FACTOR: Final = 0.0005
"""Profile factor of the ends of such rollers."""


def drop(
    profile: Profile,
    place: ArrayLike,
    *,
    length: ArrayLike,
    diameter: ArrayLike,
    tapered: bool = False,
) -> FloatArray:
    """Return the drop P(x) of a profile.

    Parameters
    ----------
    profile : of a roller, or of a race against a roller.
    place : array, x from the roller's middle; m.
    length : array, L_we; m.
    diameter : array, D_we; m.
        All broadcast against each other.
    tapered : whether the standard's profile is that of tapered and thrust bearings.

    Returns
    -------
    P of the broadcast shape; m. Infinite beyond the effective length, and at its end for a
    logarithmic profile without an end drop.

    Raises
    ------
    InputError
        If a table does not reach to the end of the effective length, or an arc does not.
    """
    x, size, d = np.broadcast_arrays(
        *(np.asarray(value, np.float64) for value in (place, length, diameter))
    )
    with np.errstate(divide="ignore", invalid="ignore"):
        found = _DROPS[profile.kind](profile, x, size, d, tapered)
    return np.asarray(np.where(np.abs(x) > 0.5 * size * (1.0 + 1e-12), np.inf, found))


def _none(
    profile: Profile, x: FloatArray, length: FloatArray, diameter: FloatArray, tapered: bool
) -> FloatArray:
    return np.zeros_like(x)


def _iso(
    profile: Profile, x: FloatArray, length: FloatArray, diameter: FloatArray, tapered: bool
) -> FloatArray:
    """ISO/TS 16281:2008; a given factor takes the place of each of the standard's.

    P = 0.00035 D ln 1/(1 - (2x/L)²); of longer cylindrical rollers, L > 2.5 D, only the ends of
    1.25 D drop, with 0.0005. Of tapered rollers 0.00045 over the whole length.
    """
    crowned = length if tapered else np.minimum(length, _LONG * diameter)
    short = ISO_FACTOR_TAPERED if tapered else ISO_FACTOR
    standard = np.where(crowned < length, _LONG_FACTOR, short)
    factor = standard if profile.factor is None else profile.factor
    return factor * diameter * _logarithm(x, length, 0.5 * crowned)


def _logarithmic(
    profile: Profile, x: FloatArray, length: FloatArray, diameter: FloatArray, tapered: bool
) -> FloatArray:
    """P = A ln 1/(1 - (1 - e^(-z/A)) s²), s from 0 where it begins to drop to 1 at the end.

    z is the end drop. Johns and Gohar (1981) have a drop over the whole length; Fujiwara and
    Kawase (2007), eq. 6, one over a part.
    """
    given = profile.amplitude
    amplitude = np.asarray(ISO_FACTOR * diameter if given is None else given, np.float64)
    half = 0.5 * length
    crowned = half if profile.crowned_length is None else np.minimum(profile.crowned_length, half)
    end = np.inf if profile.end_drop is None else profile.end_drop
    depth = np.asarray(-np.expm1(-end / amplitude), np.float64)
    return np.asarray(amplitude * _logarithm(x, length, crowned, depth))


def _logarithm(
    x: FloatArray, length: FloatArray, crowned: FloatArray, depth: FloatArray | float = 1.0
) -> FloatArray:
    """The logarithm ln 1/(1 - depth s²), s counted over the crowned length at each end."""
    s = np.clip((np.abs(x) - 0.5 * length) / crowned + 1.0, 0.0, 1.0)
    return np.asarray(-np.log1p(-depth * s * s))


def _crowned(
    profile: Profile, x: FloatArray, length: FloatArray, diameter: FloatArray, tapered: bool
) -> FloatArray:
    """An arc about the middle: P = R - √(R² - x²)."""
    return _arc(profile, np.abs(x), 0.5 * length)


def _tangential(
    profile: Profile, x: FloatArray, length: FloatArray, diameter: FloatArray, tapered: bool
) -> FloatArray:
    """Arcs that begin at the ends of the straight middle, in its direction."""
    flat = 0.5 * (profile.flat_length or 0.0)
    return _arc(profile, np.maximum(np.abs(x) - flat, 0.0), np.maximum(0.5 * length - flat, 0.0))


def _arc(profile: Profile, x: FloatArray, furthest: FloatArray) -> FloatArray:
    radius = profile.radius or np.nan
    if np.any(furthest > radius):
        raise InputError(
            said("must be at least {least:.4 mm}, for the arc to reach to the end of the roller",
                 least=float(np.max(furthest))),
            field="radius",
            value=readable(radius, "length"),
            example='radius = "1 m"',
        )  # fmt: skip
    return np.asarray(x * x / (radius + np.sqrt(radius * radius - x * x)))


def _table(
    profile: Profile, x: FloatArray, length: FloatArray, diameter: FloatArray, tapered: bool
) -> FloatArray:
    """Straight between the points; mirrored if they begin at the middle."""
    places, drops = np.array(profile.places), np.array(profile.drops)
    mirrored = places[0] == 0.0
    reach = places[-1] if mirrored else min(-places[0], places[-1])
    if np.any(0.5 * length > reach * (1.0 + 1e-9)):
        raise InputError(
            said(
                "must reach to the end of the effective length, {half:.6 mm} from the middle",
                half=float(np.max(length)) / 2.0,
            ),
            field="places",
            value=readable(reach, "length"),
            example='places = ["0 mm", "3 mm", "4.5 mm"]',
        )
    return np.asarray(np.interp(np.abs(x) if mirrored else x, places, drops))


_DROPS: Final[
    dict[ProfileKind, Callable[[Profile, FloatArray, FloatArray, FloatArray, bool], FloatArray]]
] = {
    "none": _none,
    "iso": _iso,
    "logarithmic": _logarithmic,
    "crowned": _crowned,
    "tangential": _tangential,
    "table": _table,
}
