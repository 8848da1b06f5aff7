"""A roller on a race cut into slices that know nothing of each other: the law of ISO/TS 16281.

Slice k, at x_k along the roller, is pressed in by what approach, tilt and profile leave of it,

    δ_k = δ + x_k tan ψ - P(x_k),      q_k = (c/L_we) δ_k^(10/9) where δ_k > 0.

`contact.coupled` answers the same question for slices that feel each other.

Source: ISO/TS 16281:2008; Harris (1991), section 6.
"""

from __future__ import annotations

import numpy as np

from rolamento.numerics import FloatArray as Array
from rolamento.numerics.compiled import shared

__all__ = ["independent_slices"]


@shared
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
    force = moment = by_approach = mixed = by_tilt = 0.0
    finite = abs(approach) < 1e300 and abs(tilt) < 1e300
    for k in range(place.size):
        deflection = approach + tilt * place[k] - drop[k]
        finite = finite and deflection < 1e300
        load[k] = 0.0
        if finite and deflection > 0.0:
            x = place[k]
            stiffness = constant * deflection ** (1.0 / 9.0)
            slope = 10.0 / 9.0 * stiffness
            load[k] = stiffness * deflection
            force += load[k]
            moment += load[k] * x
            by_approach += slope
            mixed += slope * x
            by_tilt += slope * x * x
    if not finite:
        load[:] = 0.0
        answer[:] = np.nan
        return 1
    answer[0] = force * width
    answer[1] = moment * width
    answer[2] = by_approach * width
    answer[3] = answer[4] = mixed * width
    answer[5] = by_tilt * width
    return 0
