"""Why a case has no result, by the code of its status."""

from __future__ import annotations

from typing import Any, Final

from rolamento.words.speaking import marked, said

__all__ = ["reason", "why_not"]

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


def why_not(solved: Any, *, advised: bool = False) -> str:
    """Say why a solved case has no result; "" if it has one. advised: and what to do."""
    if solved.converged[0]:
        return ""
    advice = solved.advice[0] if advised else None
    parts = (reason(str(solved.status.code[0])), "" if advice is None else advice.text)
    return ": ".join(part for part in parts if part)
