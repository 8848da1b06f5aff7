"""Published life tests of ball bearings that come with the package.

"lieblein_zelen_1956": 23 deep-groove ball bearings, all failed, in millions of revolutions.
"campanha_2008": 24 bearings 6305 in two conditions (the groups), most of them in pairs, in hours.
"""

from __future__ import annotations

from importlib import resources
from typing import Final

from rolamento.weibull._checks import one_of
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.reading import parse_life_test

__all__ = ["PUBLISHED", "published_life_test", "published_text"]

PUBLISHED: Final = ("lieblein_zelen_1956", "campanha_2008")


def published_life_test(name: str, *, group: str | None = None) -> LifeTest:
    """Return a published life test.

    Parameters
    ----------
    name
        One of `PUBLISHED`.
    group
        Name of the column that holds the groups, as of `read_life_test`: "procedure" of Campanha.
    """
    return parse_life_test(published_text(name), f"{name}.csv", group=group)


def published_text(name: str) -> str:
    """Return a published life test as CSV, with its source in the comments."""
    one_of(name, "name", PUBLISHED)
    file = resources.files("rolamento.weibull") / "data" / f"{name}.csv"
    return file.read_text(encoding="utf-8")
