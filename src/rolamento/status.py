"""How a case may end: the numbers that the solvers give, and their names."""

from __future__ import annotations

from typing import Final

CONVERGED: Final = 0
NO_EQUILIBRIUM: Final = 1
NOT_CONVERGED: Final = 2
OVERLOADED: Final = 3
INVALID_INPUT: Final = 4
UNCONSTRAINED_BALL: Final = 5
OVER_SHOULDER: Final = 6

TOLERANCE: Final = 5e-9
"""Residual of ring and elements at which a case may be shown: half of what is promised."""

GREATEST_APPROACH: Final = 0.02
"""Approach over an element's diameter, far beyond any elastic contact: of more it is overloaded."""

STATUS_NAMES: Final = {
    CONVERGED: "converged",
    NO_EQUILIBRIUM: "no_equilibrium",
    NOT_CONVERGED: "not_converged",
    OVERLOADED: "overloaded",
    INVALID_INPUT: "invalid_input",
    UNCONSTRAINED_BALL: "unconstrained_ball",
    OVER_SHOULDER: "over_shoulder",
}
STATUS_NUMBERS: Final = {name: number for number, name in STATUS_NAMES.items()}
