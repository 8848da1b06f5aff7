"""Checks of what the analyses of this package are given."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import isfinite
from typing import Final

import numpy as np

from rolamento.errors import InputError, shown
from rolamento.vibration.signal import Signal
from rolamento.words import marked, said

Band = tuple[float, float]
"""Lower and upper edge of a frequency band; Hz."""


def checked_number(
    value: object,
    field: str,
    *,
    above: float | None = None,
    least: float | None = None,
    most: float | None = None,
    example: str,
) -> float:
    """Return a finite number within its limits.

    Raises
    ------
    InputError
        If it is not.
    """
    number = _as_float(value)
    wrong = (
        not isfinite(number)
        or (above is not None and number <= above)
        or (least is not None and number < least)
        or (most is not None and number > most)
    )
    if wrong:
        raise InputError(_rule(above, least, most), field=field, value=value, example=example)
    return number


def checked_count(value: object, field: str, *, least: int, most: int, example: str) -> int:
    """Return a whole number within its limits.

    Raises
    ------
    InputError
        If it is not.
    """
    whole = isinstance(value, int | np.integer) and not isinstance(value, bool)
    if not whole or not least <= int(value) <= most:  # type: ignore[call-overload]
        rule = said("must be an integer from {least} to {most}", least=least, most=most)
        raise InputError(rule, field=field, value=value, example=example)
    return int(value)  # type: ignore[call-overload, no-any-return]


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
    low, high = map(_as_float, given or (None, None))
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
            value=type(given).__name__,
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


def _as_float(value: object) -> float:
    """Return a plain number; NaN of anything else, and of one that no float holds."""
    if isinstance(value, bool) or not isinstance(value, int | float | np.integer | np.floating):
        return float("nan")
    try:
        return float(value)
    except OverflowError:
        return float("nan")


_RULES: Final[dict[tuple[str, ...], str]] = {
    (): marked("must be a number"),
    ("above",): marked("must be a number greater than {above:.6g}"),
    ("least",): marked("must be a number of at least {least:.6g}"),
    ("most",): marked("must be a number of at most {most:.6g}"),
    ("above", "most"): marked("must be a number greater than {above:.6g} and at most {most:.6g}"),
    ("least", "most"): marked("must be a number from {least:.6g} to {most:.6g}"),
}


def _rule(above: float | None, least: float | None, most: float | None) -> str:
    limits = {"above": above, "least": least, "most": most}
    given = {name: limit for name, limit in limits.items() if limit is not None}
    return said(_RULES[tuple(given)], **given)


def check_within(
    field: str, value: float, least: float, most: float, example: str, unit: str = ""
) -> None:
    """Refuse a number that is not between two bounds, both allowed; NaN never is."""
    if not least <= _as_float(value) <= most:
        limits = {"least": least, "most": most, "unit": f" {unit}" if unit else ""}
        raise InputError(
            said("must be from {least:.6g} to {most:.6g}{unit}", **limits),
            field=field,
            value=value,
            example=example,
        )


def check_count(field: str, count: int, most: int) -> None:
    """Refuse more of something than there may be."""
    if count > most:
        raise InputError(said("may have at most {most}", most=most), field=field, value=count)
