"""How notes name balls: how many, and where they are."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees
from typing import Final

from rolamento.state import BallState, State

_MOST_AZIMUTHS: Final = 6
_MOST_IN_A_ROW: Final = 4


def count(balls: Sequence[BallState]) -> str:
    """Say how many balls."""
    return "1 ball" if len(balls) == 1 else f"{len(balls)} balls"


def azimuths(state: State, balls: Sequence[BallState]) -> str:
    """Say where some balls are; of a set, row by row."""
    if len(state.rows) < 2:
        return _listed(balls, _MOST_AZIMUTHS)
    parts = []
    for row in dict.fromkeys(ball.row for ball in balls):
        own = [ball for ball in balls if ball.row == row]
        all_of_it = len(own) == sum(ball.row == row for ball in state.balls)
        parts.append(f"row {row}: {'all' if all_of_it else _listed(own, _MOST_IN_A_ROW)}")
    return "; ".join(parts[:_MOST_AZIMUTHS]) + ("; …" if len(parts) > _MOST_AZIMUTHS else "")


def _listed(balls: Sequence[BallState], most: int) -> str:
    angles = [f"{degrees(ball.azimuth):.4g}°" for ball in balls]
    return ", ".join(angles[:most]) + (" …" if len(angles) > most else "")
