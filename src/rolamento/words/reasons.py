"""Why a case has no result, by the code of its status."""

from __future__ import annotations

from typing import Final

from rolamento.words.speaking import marked, said

__all__ = ["reason"]

_REASONS: Final = {
    "no_equilibrium": marked("there is no equilibrium"),
    "not_converged": marked("not converged"),
    "overloaded": marked("overloaded"),
    "unconstrained_ball": marked("a ball is not held"),
    "over_shoulder": marked("a contact lies beyond the shoulder of its groove"),
    "invalid_input": marked("invalid input"),
    "thermal_runaway": marked("no stable temperature below the limit"),
}


def reason(code: str) -> str:
    """Say why a status of this code has no result; the code where that is not known."""
    return said(_REASONS[code]) if code in _REASONS else code
