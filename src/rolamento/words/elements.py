"""What rolls, in words: a text for balls, one for rollers, and one for a set that has both."""

from __future__ import annotations

from collections.abc import Iterable

__all__ = ["worded"]

_BALL = "ball"


def worded(elements: Iterable[str], balls: str, rollers: str, both: str = "") -> str:
    """Return the text that suits what rolls in the rows of a bearing, or of several.

    Parameters
    ----------
    elements
        Of each row, as a case file has it: ``"ball"``, ``"tapered"`` …
    balls, rollers
        What is said of each.
    both
        What is said of rows of both; as of rollers if not given.
    """
    kinds = set(elements)
    if kinds == {_BALL}:
        return balls
    return both if both and _BALL in kinds else rollers
