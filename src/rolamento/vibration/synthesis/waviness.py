"""Waviness of races and balls: which frequencies it makes, and how strong.

n waves around a surface move the ring by what the balls feel of them together. Of Z equally
pressed balls at angle α, evenly spaced, only some waves leave anything:

    surface   radial: waves      at                      axial: waves   at
    outer     n = qZ ± 1         |n (ω_m-ω_o) ∓ ω_m|     n = qZ         n |ω_m - ω_o|
    inner     n = qZ ± 1         |n (ω_m-ω_i) ∓ ω_m|     n = qZ         n |ω_i - ω_m|
    ball      n even             n ω_R ± ω_m             n even         n ω_R

A ring that follows waves of amplitude A moves by A/cos α radially or A/sin α axially, for those of
a single ball by 2A/Z of that. Elastic bodies between are left out: the ring follows the waves, as
it does below its resonances. Under a load zone further lines appear, which are left out as well.

Source: Wardle, Vibration forces produced by waviness of the rolling surfaces of thrust loaded ball
bearings, Proc. Instn Mech. Engrs 202 (1988) C5.
"""

from __future__ import annotations

import cmath
from collections.abc import Sequence
from math import cos, sin
from typing import Final, Literal, NamedTuple, Self

import numpy as np

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import check_count, number, one_of
from rolamento.vibration.frequencies import FaultFrequencies
from rolamento.words import said

Surface = Literal["outer", "inner", "ball"]
Direction = Literal["radial", "axial"]
_TURN: Final = 2.0 * np.pi
_MOST_WAVES: Final = 10_000
_LEAST_ANGLE: Final = 1e-3
_MOST_LINES: Final = 500
_SAME: Final = 9
"""Decimals to which orders are the same line."""


@frozen
class Waviness:
    """Waves of one surface.

    Attributes
    ----------
    surface
        "outer", "inner", or "ball": of one ball
    amplitudes
        pairs of waves a turn and their amplitude (m)
    direction
        of the vibration that is looked at: "radial" or "axial"
    """

    surface: Surface
    amplitudes: tuple[tuple[int, float], ...]
    direction: Direction = "radial"

    def __post_init__(self) -> None:
        for field, allowed in (
            ("surface", ("outer", "inner", "ball")),
            ("direction", ("radial", "axial")),
        ):
            one_of(getattr(self, field), field, allowed)
        check_count("amplitudes", len(self.amplitudes), _MOST_WAVES)
        for waves, amplitude in self.amplitudes:
            number(waves, "waves a turn", least=1, most=_MOST_WAVES, example="(10, 1e-8)")
            number(amplitude, "amplitude", least=0.0, most=1e-3, unit="m", example="(10, 1e-8)")

    @classmethod
    def falling(
        cls,
        surface: Surface,
        amplitude: float,
        *,
        first: int = 2,
        last: int = 100,
        slope: float = 1.0,
        direction: Direction = "radial",
    ) -> Self:
        """Amplitudes that fall with the waves a turn: amplitude (first/n)^slope.

        Parameters
        ----------
        surface, direction
            As of the record.
        amplitude
            Of the first (m).
        first, last
            Waves a turn.
        slope
            With 1, the waves are equally steep.
        """
        number(first, "first", least=1, most=_MOST_WAVES, example="first = 2")
        number(last, "last", least=first, most=_MOST_WAVES, example="last = 100")
        number(slope, "slope", least=-10.0, most=10.0, example="slope = 1.0")
        waves = range(first, last + 1)
        return cls(surface, tuple((n, amplitude * (first / n) ** slope) for n in waves), direction)


class WavinessLine(NamedTuple):
    """One line: surface, waves a turn, order of the shaft, and amplitude (m) of the ring."""

    surface: Surface
    waves: int
    order: float
    amplitude: float


def waviness_lines(frequencies: FaultFrequencies, waviness: Waviness) -> tuple[WavinessLine, ...]:
    """Return the lines that waves make in a bearing with equally pressed balls.

    Raises
    ------
    InputError
        If axial vibration is asked for of a bearing with contact angle 0, or there are too many
        lines.
    """
    angle = 0.5 * (frequencies.inner_contact_angle + frequencies.outer_contact_angle)
    radial = waviness.direction == "radial"
    if not radial and abs(angle) < _LEAST_ANGLE:
        raise InputError(
            said(
                "needs a contact angle: at contact angle 0, waviness does not move the "
                "ring along the shaft"
            ),
            field="waviness.direction",
            value=waviness.direction,
            example='direction = "radial"',
        )
    reach = 1.0 / abs(cos(angle) if radial else sin(angle))
    found = [
        WavinessLine(waviness.surface, waves, order, part * reach * amplitude)
        for waves, amplitude in waviness.amplitudes
        for order, part in _orders(frequencies, waviness, waves)
        if order > 0.0 and amplitude > 0.0
    ]
    check_count("waviness.lines", len(found), _MOST_LINES)
    return tuple(found)


def waviness_acceleration(
    lines: Sequence[WavinessLine],
    phases: FloatArray,
    angle: FloatArray,
    speeds: FloatArray,
    rate: float,
) -> FloatArray:
    """Acceleration of a ring that follows the lines; (samples,), m/s².

    Parameters
    ----------
    lines
        Of the waves; those that pass half the rate are left out.
    phases
        One each (rad).
    angle, speeds
        Of the shaft, (samples,) and () or (samples,); rad and rad/s.
    rate
        Samples per second.
    """
    total = np.zeros(angle.size)
    most = float(np.max(np.abs(speeds)))
    for order, phasor in _merged(lines, phases):
        if order * most >= 0.5 * rate * _TURN:
            continue
        amplitude, at = abs(phasor), order * angle + np.angle(phasor)
        total -= (amplitude * (order * speeds) ** 2) * np.cos(at)
        if speeds.ndim:
            total -= (amplitude * order * rate) * np.gradient(speeds) * np.sin(at)
    return total


def _merged(lines: Sequence[WavinessLine], phases: FloatArray) -> list[tuple[float, complex]]:
    """Orders, and what all lines at each come to."""
    merged: dict[float, tuple[float, complex]] = {}
    for line, phase in zip(lines, phases.tolist(), strict=True):
        key = round(line.order, _SAME)
        order, sum_so_far = merged.get(key, (line.order, 0j))
        merged[key] = order, sum_so_far + line.amplitude * cmath.exp(1j * phase)
    return list(merged.values())


def _orders(
    frequencies: FaultFrequencies, waviness: Waviness, waves: int
) -> list[tuple[float, float]]:
    """Return orders of the shaft, and parts of the amplitude, of waves on a surface."""
    turns, count = frequencies.turns, frequencies.ball_count
    axial = waviness.direction == "axial"
    if waviness.surface == "ball":
        # odd waves push the ball to and fro between the races, and leave the ring where it is
        if waves % 2:
            return []
        spin, part = waves * turns.ball, 2.0 / count
        sides = (0.0,) if axial else (turns.cage, -turns.cage)
        return [(abs(spin + side), part) for side in sides]
    ring = turns.outer if waviness.surface == "outer" else turns.inner
    passing = waves * (turns.cage - ring)
    if axial:
        return [(abs(passing), 1.0)] if waves % count == 0 else []
    found = []
    if (waves + 1) % count == 0:
        found.append((abs(passing + turns.cage), 1.0))
    if (waves - 1) % count == 0:
        found.append((abs(passing - turns.cage), 1.0))
    return found
