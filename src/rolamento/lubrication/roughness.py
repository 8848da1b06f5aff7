"""Roughness parameters of a measured profile.

The profile is levelled by a least-squares line or parabola; the Gaussian filter takes the waves
longer than the cut-off λ_c away, which leaves the roughness profile, of which the parameters are
taken over as many sampling lengths λ_c as the profile holds, five by custom.

At the ends the filter sees only a part of its weights, which are scaled to a sum of one; half a
cut-off at either end is left out of the parameters all the same.
"""

from __future__ import annotations

from math import floor, isfinite, log, pi, sqrt
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.numerics.masked import filled
from rolamento.records import frozen
from rolamento.words import said

SAMPLING_LENGTHS: Final = 5
"""By ISO 4288."""
_GAUSS: Final = sqrt(log(2.0) / pi)
"""α of the weight function: half of a wave of the cut-off's length passes."""
_MINIMUM_POINTS: Final = 10
"""In a cut-off: with fewer the weights are too coarse."""
_MAXIMUM_POINTS: Final = 10_000_000


@frozen
class Roughness:
    """Parameters of a roughness profile, in m.

    Attributes
    ----------
    ra
        mean of the heights' sizes over the evaluation length
    rq
        root mean square of the heights
    rz
        mean over the sampling lengths of highest peak to deepest valley
    rt
        highest peak to deepest valley of the whole evaluation length
    sampling_lengths
        how many there are
    """

    ra: float
    rq: float
    rz: float
    rt: float
    sampling_lengths: int


def roughness_of_profile(
    heights: ArrayLike,
    spacing: float,
    cutoff: float,
    *,
    short_cutoff: float | None = None,
    sampling_lengths: int = SAMPLING_LENGTHS,
    form: int = 1,
) -> Roughness:
    """Ra, Rq, Rz and Rt of a measured profile.

    Parameters
    ----------
    heights
        (points,), of the profile; m.
    spacing
        Distance of neighbouring points; m.
    cutoff
        λ_c, which is also the sampling length; m.
    short_cutoff
        λ_s, below which waves are taken for noise of the stylus; m. None leaves all in.
    sampling_lengths
        How many to evaluate; the middle of the profile is taken.
    form
        Degree of the polynomial that is taken off first: 0 a level, 1 a line, 2 an arc.

    Raises
    ------
    InputError
        If the profile is too short or too coarse, or a value is not usable.

    ISO 16610-21 (filter), ISO 4287 (parameters).
    """
    profile = _checked_heights(heights)
    _check_lengths(spacing, cutoff, short_cutoff, sampling_lengths, form)
    points = floor(cutoff / spacing + 1e-9)
    margin = points // 2
    needed = sampling_lengths * points + 2 * margin
    if profile.size < needed:
        raise InputError(
            said(
                "is too short: {sampling_lengths} sampling lengths and half a cut-off "
                "at either end need {needed} points",
                sampling_lengths=sampling_lengths,
                needed=needed,
            ),
            field="heights",
            value=profile.size,
        )
    rough = roughness_profile(_levelled(profile, form), spacing, cutoff, short_cutoff)
    first = (profile.size - sampling_lengths * points) // 2
    lengths = rough[first : first + sampling_lengths * points].reshape(sampling_lengths, points)
    heights_above = lengths - lengths.mean()
    return Roughness(
        ra=float(np.abs(heights_above).mean()),
        rq=float(np.sqrt(np.square(heights_above).mean())),
        rz=float(np.ptp(lengths, axis=1).mean()),
        rt=float(np.ptp(lengths)),
        sampling_lengths=sampling_lengths,
    )


def roughness_profile(
    profile: FloatArray, spacing: float, cutoff: float, short_cutoff: float | None = None
) -> FloatArray:
    """Profile without its waves beyond the cut-off λ_c, and below λ_s if that is given; m.

    Parameters: (points,); m. Returns (points,). ISO 16610-21.
    """
    smooth = profile if short_cutoff is None else gaussian_mean_line(profile, spacing, short_cutoff)
    return np.asarray(smooth - gaussian_mean_line(smooth, spacing, cutoff))


def gaussian_mean_line(profile: FloatArray, spacing: float, cutoff: float) -> FloatArray:
    """Mean line of a profile: what the Gaussian filter lets pass; m.

    Parameters: (points,); m. Returns (points,). A wave of the cut-off's length passes by half, one
    of half that length by a sixteenth. ISO 16610-21; at the ends the weights that are left are
    scaled to one.
    """
    from scipy.signal import fftconvolve

    reach = max(int(np.ceil(cutoff / spacing)), 1)
    place = np.arange(-reach, reach + 1) * spacing
    weights = np.exp(-pi * (place / (_GAUSS * cutoff)) ** 2)
    total = fftconvolve(np.ones_like(profile), weights, mode="full")
    mean = fftconvolve(profile, weights, mode="full")
    inside = slice(reach, reach + profile.size)
    return np.asarray(mean[inside] / total[inside])


def gaussian_transmission(wavelength: ArrayLike, cutoff: float) -> FloatArray:
    """Share of a wave that the mean line keeps, exp(-π (α λ_c/λ)²); m. ISO 16610-21."""
    ratio = _GAUSS * cutoff / np.asarray(wavelength, dtype=np.float64)
    return np.asarray(np.exp(-pi * ratio**2))


def rms_of_mean_roughness(mean_roughness: ArrayLike) -> FloatArray:
    """Rq = √(π/2) Ra of a Gaussian surface, exactly; tables use 1.25. Parameters: Ra, any unit."""
    return np.asarray(sqrt(pi / 2.0) * np.asarray(mean_roughness, dtype=np.float64))


def _checked_heights(heights: ArrayLike) -> FloatArray:
    try:
        profile = filled(heights)
    except (TypeError, ValueError):
        raise InputError(said("must be numbers"), field="heights") from None
    if profile.ndim != 1 or not 0 < profile.size <= _MAXIMUM_POINTS:
        raise InputError(
            said("must be a list of at most {most} heights", most=_MAXIMUM_POINTS),
            field="heights",
            value=str(profile.shape),
        )
    if not np.all(np.isfinite(profile)):
        raise InputError(said("must be finite numbers"), field="heights")
    return profile


def _check_lengths(
    spacing: float, cutoff: float, short_cutoff: float | None, sampling_lengths: int, form: int
) -> None:
    for name, value in (("spacing", spacing), ("cutoff", cutoff)):
        if not _is_positive(value):
            raise InputError(said("must be positive"), field=name, value=value)
    if cutoff < _MINIMUM_POINTS * spacing:
        raise InputError(
            said(
                "must be at least {least} times the point spacing",
                least=_MINIMUM_POINTS,
            ),
            field="cutoff",
            value=cutoff,
        )
    if short_cutoff is not None and not (_is_positive(short_cutoff) and short_cutoff < cutoff):
        raise InputError(
            said("must be greater than zero and less than the cut-off"),
            field="short_cutoff",
            value=short_cutoff,
        )
    if not _is_positive(sampling_lengths) or sampling_lengths != int(sampling_lengths):
        raise InputError(
            said("must be a positive integer"),
            field="sampling_lengths",
            value=sampling_lengths,
        )
    if form not in (0, 1, 2):
        raise InputError(said("must be 0, 1 or 2"), field="form", value=form)


def _is_positive(value: object) -> bool:
    return isinstance(value, int | float | np.number) and isfinite(value) and bool(value > 0.0)


def _levelled(profile: FloatArray, degree: int) -> FloatArray:
    """Take the form off, by least squares."""
    place = np.linspace(-1.0, 1.0, profile.size)
    fit = np.polynomial.polynomial.polyfit(place, profile, degree)
    return np.asarray(profile - np.polynomial.polynomial.polyval(place, fit))
