"""The shapes of numbers that the kernels pass to each other; for readers and type checkers."""

from __future__ import annotations

from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]
Order: TypeAlias = NDArray[np.int64]
"""Numbers of cases, as they are taken."""

Two: TypeAlias = tuple[float, float]
Three: TypeAlias = tuple[float, float, float]
Four: TypeAlias = tuple[float, float, float, float]
Five: TypeAlias = tuple[float, float, float, float, float]
Six: TypeAlias = tuple[float, float, float, float, float, float]
Seven: TypeAlias = tuple[float, float, float, float, float, float, float]
Eight: TypeAlias = tuple[float, float, float, float, float, float, float, float]

Coefficients: TypeAlias = Seven
"""Coefficients of a contact's stiffness, a polynomial in cos a."""
StoredPolynomial: TypeAlias = tuple[Array, int, int]
"""Where such a polynomial stands: parameters, first row, case."""
Race: TypeAlias = tuple[float, Any]
"""Free length L of a contact, and its stiffness in either form."""
Contact: TypeAlias = Seven
"""Sin a and cos a of a contact, da/dt, approach, Q, dQ/d|y| and dQ/da; see `ball.contact`."""
Touching: TypeAlias = tuple[Contact, Contact, Three]
"""Inner and outer contact of a ball, and the speed of its own orbit with its derivatives."""
Motion: TypeAlias = Six
"""gamma', c_f, c_g, inner speed, outer speed, f_i D / R_i."""
Cage: TypeAlias = Four
"""Speed of the cage, and the rate, the offset and the weight of `rows` that hand a ball over."""
Found: TypeAlias = tuple[bool, float, float]
"""Whether a ball's place was found, and X1, X2."""
Linearised: TypeAlias = tuple[Two, Eight, Three, Six, float, Five, Seven, Five]
"""Residual, step, force, stiffness, scale, touch, cage and what is before the step, of a ball.

See `ball.linearised`.
"""
Settled: TypeAlias = tuple[bool, float, float, Linearised]
"""Whether a ball's place was found, X1, X2, and the ball there."""
StaticBall: TypeAlias = tuple[float, float, Three, Six, float, Five]
"""X1, X2, force, stiffness, scale and touch of a ball without inertia."""


class Output(NamedTuple):
    """What the kernels find, in the arrays that they fill.

    displacement (cases, 5): scaled as in `layout`; cage (cases,): its speed; position (cases,
    balls, 2); force (cases, 5), stiffness (cases, 5, 5): SI; residual, number of the status,
    unsupported and iterations (cases,); safe_path (cases,): whether a case was solved one by one.
    """

    displacement: Array
    cage: Array
    position: Array
    force: Array
    stiffness: Array
    residual: Array
    number: Order
    unsupported: Order
    iterations: Order
    safe_path: NDArray[np.bool_]
