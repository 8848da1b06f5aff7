"""What is said of the static safety."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Final

from rolamento.words.speaking import marked, said

if TYPE_CHECKING:
    from rolamento.words.sentences import Sentence

__all__ = ["OPERATIONS", "REQUIREMENTS", "SENTENCES"]

OPERATIONS: Final = {
    "smooth": marked("smooth operation"),
    "normal": marked("normal operation"),
    "shock": marked("shock loads"),
}
"""Names of `rolamento.case.Static.operation`."""
REQUIREMENTS: Final = {
    "unimportant": marked("quiet running unimportant"),
    "normal": marked("normal demands on quiet running"),
    "high": marked("high demands on quiet running"),
    "at_rest": marked("does not turn"),
}
"""Names of `rolamento.case.Static.requirement`."""


def _gap(values: Mapping[str, Any]) -> str:
    return said(
        "Rows {rows} lose all contact under this load, with gaps of up to {gap:.3 µm}: in vibration"
        " their elements hammer; more preload keeps them together.",
        rows=values["rows"],
        gap=values["gap"],
    )


SENTENCES: Final[dict[str, Sentence]] = {
    "no_static_rating_for_safety": marked(
        "C_0 is not known: there is no safety by load; `life.static_rating` gives it."
    ),
    "soft_raceways": marked(
        "Raceways of {hardness:.3} HRC bear less than those of 58: all safeties are multiplied by"
        " {factor:.3} (Harris and Kotzalas, 2006; general knowledge)."
    ),
    "rows_gap": _gap,
    "case_too_shallow": marked(
        "The hardened case of {depth:.3 mm} is shallower than the {needed:.3 mm} at which the core"
        " bears the stresses."
    ),
    "subsurface_yielding": marked(
        "Below the contact with the most pressure the ring yields: there it needs {needed:.3r} HV"
        " and has {hardness:.3r}. Under C_0 that is so by definition: elements leave marks of"
        " 1/10 000 of their diameter."
    ),
    "launch_limits_at_rest": marked(
        "The allowable pressures of NASA-STD-5017B are for a bearing that does not turn; here a"
        " ring turns."
    ),
}
"""By key."""
