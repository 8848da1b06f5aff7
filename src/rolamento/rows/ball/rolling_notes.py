"""What the user should know about balls that friction alone controls."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi
from typing import Final

from rolamento.rows.ball.wording import azimuths as _azimuths
from rolamento.rows.ball.wording import count as _count
from rolamento.state import State

SKID_LIMIT: Final = 0.05
"""Of the cage's speed under outer raceway control: what differs more deserves a word."""
SPIN_LIMIT: Final = 0.05
"""Spin to roll at both races above which no race can be said to control a ball."""
_RPM: Final = 30.0 / pi


def notes_on_rolling(state: State) -> Iterator[str]:
    """Say what friction does that raceway control would not show."""
    if state.case.model.raceway_control != "friction":
        return
    if state.rolling is None:
        yield (
            "The rings do not turn against each other, so friction has nothing to decide: this is "
            "the result of outer raceway control."
        )
        return
    rolling = state.rolling
    if abs(rolling.skid) > SKID_LIMIT:
        sense = "behind" if rolling.skid > 0.0 else "ahead of"
        speed, usual = _RPM * rolling.cage_speed, _RPM * rolling.control_cage_speed
        yield (
            f"The cage runs {100.0 * abs(rolling.skid):.1f} % {sense} that of outer raceway "
            f"control ({speed:.1f} instead of {usual:.1f} rpm): the balls skid, and the fault "
            "frequencies move with the cage."
        )
    spinning = [
        ball
        for ball in state.balls
        if min(abs(ball.inner.spin_to_roll), abs(ball.outer.spin_to_roll)) > SPIN_LIMIT
        and ball.inner.load > 0.0
    ]
    if spinning:
        inner = max(abs(ball.inner.spin_to_roll) for ball in spinning)
        outer = max(abs(ball.outer.spin_to_roll) for ball in spinning)
        yield (
            f"{_count(spinning)} spin at both races (azimuth {_azimuths(state, spinning)}), by "
            f"up to {inner:.2f} of the roll at the inner and {outer:.2f} at the outer race: no "
            "raceway control describes them."
        )
