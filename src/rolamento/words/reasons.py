"""Why a case has no result, by the code of its status."""

from __future__ import annotations

from typing import Final

from rolamento.words.speaking import marked, said

__all__ = ["reason_of"]

_REASONS: Final = {
    "no_equilibrium": marked("no equilibrium exists"),
    "not_converged": marked("not converged"),
    "overloaded": marked("overloaded"),
    "unheld_ball": marked("a ball is unconstrained"),
    "over_shoulder": marked("a ball rides over the shoulder"),
    "invalid_input": marked("invalid input"),
}


def reason_of(code: str) -> str:
    """Say why a status of this code has no result; the code where that is not known."""
    return said(_REASONS[code]) if code in _REASONS else code
