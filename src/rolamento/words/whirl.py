"""What the ways in which a shaft whirls are called."""

from __future__ import annotations

from typing import Final

from rolamento.words.speaking import marked, said

__all__ = ["whirl_name"]

_NAMES: Final = {
    "forward": marked("forward whirl"),
    "backward": marked("backward whirl"),
    "along a line": marked("along a line"),
    "axial": marked("axial"),
}


def whirl_name(whirl: str) -> str:
    """Return what a motion is called, of `rolamento.solved.rotor.whirl_names`; "" of none."""
    return said(_NAMES[whirl]) if whirl else ""
