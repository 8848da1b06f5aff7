"""What the designation of a roller bearing says: type, series, bore, design, and what follows.

Cylindrical roller bearings by DIN 623-1 (NU 205, NJ 2205, N 10/500), tapered ones by DIN 623-1 and
with NSK's letters (30205, HR 32005 XJ, 320/28), needle roller bearings (NA 4905), cages with
needles (K 10X14X13) and drawn cups (HK 1612). What the letters mean is in data/designations.toml.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from typing import Any, Final

from rolamento.catalogue.letters import Letters, Part, designation_data, groups_of
from rolamento.records import frozen

__all__ = ["RollerNumber", "roller_number_of"]

_REST: Final = r"(?P<rest>(?:\|?2[RZ]|\|?\D).*)?"
_STROKE: Final = re.compile(r"(?<=\d)\s*/\s*(?=(?:22|28|32)(?!\d))")
"""Stroke before a bore in mm; a blank or a hyphen would make it two figures of a bore code."""
_SIZES: Final = ("bore", "outer", "width")


@cache
def _numbers() -> tuple[tuple[re.Pattern[str], Mapping[str, Any]], ...]:
    """Pattern of each kind's number, with what is said of it."""
    return tuple(
        (re.compile(one["pattern"] + _REST), one) for one in designation_data()["roller_number"]
    )


@frozen
class RollerNumber:
    """What the number of a roller bearing says.

    Attributes
    ----------
    kind
        Key of its type.
    type
        ``"NU"``, ``"NJ"``, ``"NUP"``, ``"N"`` or ``"NF"``; ``"NA"`` or ``"RNA"``; ``"K"``, a cage
        with its needles; ``"HK"`` or ``"BK"``; empty of a tapered bearing.
    series
        Such as ``"2"``, ``"22"`` or ``"302"``; empty of a cage or a drawn cup.
    number
        Without letters behind it, such as ``"NU205"`` or ``"30205"``.
    bore
        In mm, or as a code of two figures.
    names
        By which makers list it, the likeliest first.
    letters
        Those of its design.
    rest
        What follows.
    """

    kind: str
    type: str
    series: str
    number: str
    bore: str
    names: tuple[str, ...]
    letters: Letters
    rest: str


def roller_number_of(plain: str, joined: str, maker: str = "") -> RollerNumber | None:
    """Return what a designation says if it is a roller bearing's.

    Parameters
    ----------
    plain
        In capitals.
    joined
        The same, with one stroke for what parts it.
    maker
        Whose name stands beside it; its list is then the first to look in.
    """
    if _STROKE.search(plain):  # 322/28, not 32228
        joined = "/".join("|".join(groups_of(part)) for part in _STROKE.split(plain))
    for pattern, one in _numbers():
        found = pattern.fullmatch(joined)
        if found is not None:
            return _by_sizes(one, found) if "names" in one else _of_series(one, found, maker)
    return None


def _by_sizes(one: Mapping[str, Any], found: re.Match[str]) -> RollerNumber:
    told = found.groupdict()
    sizes = {name: int(told[name]) for name in _SIZES if told.get(name)}
    names = tuple(name.format(type=told["type"], **sizes) for name in one["names"])
    return RollerNumber(
        one["kind"], told["type"], "", names[0], str(sizes["bore"]), names,
        _meant("roller_types", told["type"]), told["rest"] or "",
    )  # fmt: skip


def _of_series(one: Mapping[str, Any], found: re.Match[str], maker: str) -> RollerNumber:
    told = found.groupdict()
    series, rest = told["series"], told["rest"] or ""
    bore = told["bore"] or told.get("millimetres") or ""
    place = bore if told["bore"] else f"/{bore}"
    type_ = told.get("type") or ""
    number = f"{type_}{series}{place}"
    letters, design = _meant("roller_types", type_), ""
    own = re.match(one["letters"], rest) if "letters" in one else None
    if own is not None:
        parts = [part for part in own.groupdict().values() if part]
        design = (own["design"] or "").replace("|", "")
        rest = rest[own.end() :]
        for part in parts:
            letters += _meant("roller_designs", part.replace("|", ""))
    names = tuple(f"{number}{behind}" for behind in _behind(one, design, maker))
    if prefix := one.get("prefix"):
        names = tuple(name for own in names for name in _with_prefix(own, prefix, maker))
    in_mm = bore if told.get("millimetres") else f"code {bore}"
    return RollerNumber(one["kind"], type_, series, number, in_mm, names, letters, rest)


def _with_prefix(name: str, prefix: str, maker: str) -> tuple[str, ...]:
    """NSK's bearings of high capacity bear letters before the number."""
    return (name, f"{prefix}{name}") if maker == "SKF" else (f"{prefix}{name}", name)


def _behind(one: Mapping[str, Any], design: str, maker: str) -> tuple[str, ...]:
    """Return the letters with which makers list a design, those of the maker first."""
    listed = designation_data()["roller_listed_as"].get(one["kind"])
    if listed is None:
        return ("",)
    groups = listed[one["steep"].get(design[:1], "usual") if "steep" in one else design or "plain"]
    own = groups.get(maker, ())
    written = [design] if one.get("as_written") and (not own or design in own) else []
    first = (*written, *own)
    return tuple(dict.fromkeys((*first, *(name for group in groups.values() for name in group))))


def _meant(table: str, part: str) -> Letters:
    """What a part of a number means; it takes part in finding the bearing."""
    meaning = designation_data()[table].get(part)
    return Letters(parts=(Part(part, meaning),)) if meaning else Letters()
