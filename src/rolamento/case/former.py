"""Names that files, outputs and statuses had before release 0.2, still read in this one.

Each is said once to be another now, on the log. A name goes from here with release 0.3.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any, Final

from rolamento.words import said

__all__ = ["FIELDS", "OUTPUTS", "STATUSES", "current", "with_current_names"]


FIELDS: Final = {"life.wanted_life": "life.required_life"}
"""Fields of a case, dotted."""
OUTPUTS: Final = {
    "life_below": "life_upper_bound",
    "wanted_reliability": "required_life_reliability",
    **{
        f"life_holds{end}": f"life_valid{end}"
        for end in (
            "", "_iso281", "_iso281_modified", "_iso281_1990", "_iso16281", "_iso16281_modified",
            "_ioannides_harris", "_l_able", "_tallian",
        )
    },
}  # fmt: skip
"""Outputs of a study."""
STATUSES: Final = {"unheld_ball": "unconstrained_ball"}
"""Statuses of a case that is solved."""


def current(name: str, former: Mapping[str, str] = FIELDS) -> str:
    """Return what a name is now; a former one is said to be that."""
    new = former.get(name)
    if new is None:
        return name
    _say_once(name, new)
    return new


def with_current_names(given: Any, former: Mapping[str, str]) -> Any:
    """Return a table with its former keys as they are now; anything else as it is.

    A table that has both keeps both, for whoever reads it to refuse.
    """
    if not isinstance(given, Mapping) or not any(name in given for name in former):
        return given
    return {
        current(name, former)
        if former.get(name) in former or former.get(name) not in given
        else name: value
        for name, value in given.items()
    }


@cache
def _say_once(old: str, new: str) -> None:
    import logging

    logging.getLogger("rolamento").warning(
        said("{old} is called {new} now; the old name is read until release 0.3", old=old, new=new)
    )
