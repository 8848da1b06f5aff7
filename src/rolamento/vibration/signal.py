"""A vibration signal: evenly spaced samples of one channel, with rate, unit and shaft speed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Final, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError, kind_of, nearest, shown
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import one_of, scalar
from rolamento.words import marked, said

Quantity = Literal["acceleration", "velocity", "displacement", "unknown"]

Band = tuple[float, float]
"""Lower and upper edge of a frequency band; Hz."""

SI_UNITS: Final[dict[Quantity, str]] = {
    "acceleration": "m/s^2",
    "velocity": "m/s",
    "displacement": "m",
}

_GRAVITY: Final = 9.80665
_INCH: Final = 0.0254
_SCALES: Final[dict[Quantity, dict[str, float]]] = {
    "acceleration": {"m/s^2": 1.0, "mm/s^2": 1e-3, "g": _GRAVITY, "mg": 1e-3 * _GRAVITY},
    "velocity": {"m/s": 1.0, "mm/s": 1e-3, "um/s": 1e-6, "in/s": _INCH},
    "displacement": {"m": 1.0, "mm": 1e-3, "um": 1e-6, "nm": 1e-9, "in": _INCH, "mil": 25.4e-6},
}
_LONGEST_TEXT: Final = 300
_HIGHEST_RATE: Final = 1e9
_MAXIMUM_SAMPLE: Final = 1e60
"""The sum of fourth powers, as the kurtosis takes them, stays finite in double precision."""
_HIGHEST_SPEED: Final = 1e7
_SAMPLES_EXAMPLE: Final = "samples = [0.1, -0.2, 0.05]"
_SPEED_EXAMPLE: Final = "speed = 188.5"


@frozen(eq=False)
class Signal:
    """Evenly spaced samples of one vibration channel.

    Attributes
    ----------
    samples
        (samples,), read-only; in `unit`
    rate
        sampling rate; Hz
    quantity
        what was measured: acceleration, velocity, displacement, or unknown
    unit
        of the samples: one of the quantity's units, or any text for an unknown quantity
    speed
        of the shaft, rad/s: () if it is steady, (samples,) if it was measured along; None if it
        is not known
    title
        what a person calls it

    Raises
    ------
    InputError
        If there are no samples or one is not a finite number, if the rate is not positive, if
        the unit is not one of the quantity, or if the speed does not fit the samples.
    """

    samples: FloatArray
    rate: float
    quantity: Quantity = "unknown"
    unit: str = ""
    speed: FloatArray | None = None
    title: str = ""

    def __post_init__(self) -> None:
        samples = _checked_samples(self.samples)
        object.__setattr__(self, "samples", samples)
        object.__setattr__(self, "rate", _checked_rate(self.rate))
        unit_scale(self.quantity, self.unit)
        if self.speed is not None:
            object.__setattr__(self, "speed", _checked_speed(self.speed, len(samples)))
        _check_text(self.title, "title", "drive end, horizontal")

    @property
    def duration(self) -> float:
        """Number of samples over the rate; s."""
        return len(self.samples) / self.rate

    @property
    def mean_speed(self) -> float:
        """Mean of the shaft speed; rad/s, NaN if it is not known."""
        return float("nan") if self.speed is None else float(np.mean(self.speed))

    @property
    def in_si(self) -> Signal:
        """The same signal in m/s², m/s or m; of an unknown quantity, the signal as it is."""
        scale = unit_scale(self.quantity, self.unit)
        if self.quantity == "unknown" or self.unit == SI_UNITS[self.quantity]:
            return self
        return replace(self, samples=self.samples * scale, unit=SI_UNITS[self.quantity])


def unit_scale(quantity: Quantity, unit: str) -> float:
    """SI value of one unit of a quantity; 1 for an unknown quantity, whose unit is any text.

    Raises
    ------
    InputError
        If there is no such quantity, or the unit is not one of its units.
    """
    near = nearest(str(quantity), get_args(Quantity)) or "acceleration"
    one_of(quantity, "quantity", get_args(Quantity), near)
    _check_text(unit, "unit", "m/s^2")
    if quantity == "unknown":
        return 1.0
    known = _SCALES[quantity]
    if unit not in known:
        raise InputError(
            said("is not a unit of {quantity}: {known}", quantity=quantity, known=", ".join(known)),
            field="unit",
            value=unit,
            example=SI_UNITS[quantity],
        )
    return known[unit]


def _check_text(text: object, field: str, example: str) -> None:
    if not isinstance(text, str) or len(text) > _LONGEST_TEXT:
        rule = said("must be text of at most {most} characters", most=_LONGEST_TEXT)
        raise InputError(rule, field=field, value=text, example=example)


def _checked_samples(given: ArrayLike) -> FloatArray:
    samples = real_numbers(given, "samples", _SAMPLES_EXAMPLE)
    if samples.ndim != 1 or len(samples) == 0:
        raise InputError(
            said("must be a single row of numbers, and has the shape {shape}", shape=samples.shape),
            field="samples",
            example=_SAMPLES_EXAMPLE,
        )
    _refuse_bad(samples, _MAXIMUM_SAMPLE, "samples", _SAMPLES_EXAMPLE)
    return samples


def _checked_rate(rate: object) -> float:
    number = float(rate) if isinstance(rate, int | float | np.number) else float("nan")
    if not 0.0 < number <= _HIGHEST_RATE:
        raise InputError(
            said(
                "must be a positive number of samples per second, up to {most:.6g}",
                most=_HIGHEST_RATE,
            ),
            field="rate",
            value=rate,
            example="rate = 51200.0",
        )
    return number


def _checked_speed(given: ArrayLike, count: int) -> FloatArray:
    speed = real_numbers(given, "speed", _SPEED_EXAMPLE)
    if speed.shape not in ((), (count,)):
        raise InputError(
            said(
                "must be one number or one for each sample ({count}), in rad/s",
                count=count,
            ),
            field="speed",
            example=_SPEED_EXAMPLE,
        )
    _refuse_bad(speed, _HIGHEST_SPEED, "speed", _SPEED_EXAMPLE)
    return speed


def real_numbers(given: ArrayLike, field: str, example: str) -> FloatArray:
    """Return a read-only view of real numbers in double precision; no copy where none is needed.

    Raises
    ------
    InputError
        For text, rows of different lengths, and whatever else is no array of real numbers.
    """
    try:
        plain = np.asarray(given)
        numeric = plain.dtype.kind in "iufb"
        array = plain.astype(np.float64, copy=False).view() if numeric else None
    except (TypeError, ValueError, OverflowError):
        array = None
    if array is None:
        rule = said("must be real numbers: a list, an array or a series")
        raise InputError(rule, field=field, value=kind_of(given), example=example)
    array.flags.writeable = False
    return array


def _refuse_bad(numbers: FloatArray, maximum: float, field: str, example: str) -> None:
    """Refuse what is not finite or beyond a limit; the extremes show it without a copy."""
    lowest, highest = float(np.min(numbers)), float(np.max(numbers))
    if not (lowest >= -maximum and highest <= maximum):
        wrong = np.flatnonzero(~(np.abs(np.atleast_1d(numbers)) <= maximum))[0]
        raise InputError(
            said(
                "must be finite numbers of magnitude up to {most:.6g}; number {wrong} is not",
                most=maximum,
                wrong=wrong,
            ),
            field=field,
            value=float(np.atleast_1d(numbers)[wrong]),
            example=example,
        )


# --- what analyses ask of a signal ------------------------------------------------------------


def checked_band(band: object, rate: float, field: str = "band") -> Band:
    """Return a band that lies within 0 and half the sampling rate; Hz.

    Raises
    ------
    InputError
        If it does not, or has no width.
    """
    given: tuple[object, ...] = ()
    if isinstance(band, Sequence) and not isinstance(band, str) and len(band) == 2:
        given = tuple(band)
    low, high = map(scalar, given or (None, None))
    if not 0.0 <= low < high <= 0.5 * rate:
        raise InputError(
            said(
                "must be a lower and an upper frequency from 0 to half the sampling "
                "rate, {rate:.6g} Hz",
                rate=0.5 * rate,
            ),
            field=field,
            value=f"({', '.join(shown(edge) for edge in given)})" if given else band,
            example=f"{field} = (2000.0, 4000.0)",
        )
    return low, high


def require_signal(given: object) -> None:
    """Refuse what is no `Signal`: bare samples have no rate.

    Raises
    ------
    InputError
        If it is anything else.
    """
    if not isinstance(given, Signal):
        raise InputError(
            said("must be a Signal, samples with their rate"),
            field="signal",
            value=kind_of(given),
            example="Signal(samples, rate=51200.0)",
        )


def pieces_of(given: Signal | Iterable[Signal]) -> Iterator[Signal]:
    """Return a signal, or the pieces of one, one by one.

    Raises
    ------
    InputError
        If it is neither, or there is none.
    """
    if isinstance(given, Signal) or not isinstance(given, Iterable):
        require_signal(given)
        yield given
        return
    nothing = True
    for piece in given:
        require_signal(piece)
        nothing = False
        yield piece
    if nothing:
        raise InputError(said("has no samples"), field="signal")


def require_samples(signal: Signal, least: int, purpose: str) -> None:
    """Refuse what is no signal, or one that is too short for a purpose.

    Raises
    ------
    InputError
        If it has fewer samples.
    """
    require_signal(signal)
    if len(signal.samples) < least:
        raise InputError(
            said("must be at least {least} for {purpose}", least=least, purpose=said(purpose)),
            field=marked("number of samples"),
            value=len(signal.samples),
        )
