"""A roller on a race cut into slices that know nothing of each other: the law of ISO/TS 16281.

Slice k, at x_k along the roller, is pressed in by what approach, tilt and profile leave of it,

    δ_k = δ + x_k tan ψ - P(x_k),      q_k = (c/L_we) δ_k^(10/9) where δ_k > 0.

`contact.coupled` answers the same question for slices that feel each other.

Source: ISO/TS 16281:2008; Harris (1991), section 6.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from rolamento.numerics import FloatArray as Array
from rolamento.numerics.compiled import inline_fast, vector_loop

__all__ = ["independent_slices", "ninth_root"]

_LEAST: Final = 1e-290
"""Whose ninth root is still found; m."""
_MANTISSA: Final = 2.0**52
_OFFSET: Final = (1023.0 * 10.0 / 9.0 - 0.0478) * _MANTISSA
"""The bits of a number are about its logarithm: those of x^(-1/9) are this less a ninth of x's."""


@inline_fast
def ninth_root(x: float) -> float:
    """Return x^(1/9) of a number that is not negative."""
    return float(x ** (1.0 / 9.0))


def _ninth_root(x: Any) -> Any:
    """What kernels take instead, as vectors can: from its bits, in steps without a division.

    The root z of z^-9 = x is known to 3.4 % from the bits of x, read as a whole number. With
    h = 1 - x z^9 the series z (1 + h/9 + 5h²/81) leaves an error of some 30 times its cube.
    """
    number = max(x, _LEAST)
    bits = np.float64(number).view(np.int64)
    z = np.int64(_OFFSET - bits * (1.0 / 9.0)).view(np.float64)
    for _ in range(3):
        z4 = (z * z) * (z * z)
        h = 1.0 - number * (z4 * z4 * z)
        z = z * (1.0 + h * (1.0 / 9.0 + h * (5.0 / 81.0)))
    z4 = (z * z) * (z * z)
    return x * (z4 * z4)


ninth_root.python = _ninth_root


@vector_loop
def independent_slices(
    approach: float,
    tilt: float,
    place: Array,
    drop: Array,
    width: float,
    constant: float,
    load: Array,
    answer: Array,
) -> int:
    """Press a roller on a race.

    Parameters
    ----------
    approach : δ, of the rigid bodies at the roller's middle; m.
    tilt : tan ψ, the slope of the roller against the race; positive presses the end at +x in.
    place : (n,), x_k; m.
    drop : (n,), P(x_k) of roller and race together; m. Infinite where there is no contact.
    width : of a slice; m.
    constant : c/L_we, of one contact or of both together (`contact.line`); N/m^(19/9).
    load : (n,), takes q_k; N/m.
    answer : (6,), takes load Q (N), moment M = Σ q_k x_k width (N·m), and their derivatives
        ∂Q/∂δ, ∂Q/∂tan ψ, ∂M/∂δ, ∂M/∂tan ψ.

    Returns
    -------
    0; or 1 with NaN where a number is not one.
    """
    force = moment = by_approach = mixed = by_tilt = finite = 0.0
    if abs(approach) < 1e300 and abs(tilt) < 1e300:
        for k in range(place.size):
            x = place[k]
            deflection = approach + tilt * x - drop[k]
            known = deflection < 1e300
            finite += 1.0 if known else 0.0
            pressed = deflection if known and deflection > 0.0 else 0.0
            stiffness = constant * ninth_root(pressed)
            slope = 10.0 / 9.0 * stiffness if pressed > 0.0 else 0.0
            load[k] = stiffness * pressed
            force += load[k]
            moment += load[k] * x
            by_approach += slope
            mixed += slope * x
            by_tilt += slope * x * x
    if finite < place.size:
        load[:] = 0.0
        answer[:] = np.nan
        return 1
    answer[0] = force * width
    answer[1] = moment * width
    answer[2] = by_approach * width
    answer[3] = answer[4] = mixed * width
    answer[5] = by_tilt * width
    return 0
