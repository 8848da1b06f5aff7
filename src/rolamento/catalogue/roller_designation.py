"""What the designation of a roller bearing says: type, series, bore, design, and what follows.

Cylindrical roller bearings by DIN 623-1 (NU 205, NJ 2205, N 10/500), tapered ones by DIN 623-1 and
with NSK's letters (30205, HR 32005 XJ, 320/28), needle roller bearings (NA 4905), cages with
needles (K 10X14X13) and drawn cups (HK 1612). What the letters mean is in data/designations.toml.
"""

from __future__ import annotations

import re
from typing import Final

from rolamento.catalogue.letters import Letters, Part, designation_data, groups_of
from rolamento.records import frozen

__all__ = ["RollerNumber", "roller_number_of"]

_REST: Final = r"(?P<rest>(?:\|?2[RZ]|\|?\D).*)?"
_CYLINDRICAL: Final = re.compile(
    r"(?P<type>NUP|NU|NJ|NF|N)\|?(?P<series>10|22|23|2|3|4)"
    r"(?:(?P<bore>\d\d)|\|(?P<millimetres>\d{3}))" + _REST
)
"""Pattern of a text whose blanks, hyphens, strokes and points are one stroke each."""
_TAPERED: Final = re.compile(
    r"(?:HR\|?)?(?P<series>30[23]|313|32[0239]|33[0-2])"
    r"(?:\|?(?P<bore>\d\d)|/(?P<millimetres>\d\d))" + _REST
)
_NEEDLE: Final = re.compile(
    r"(?P<type>R?NA)\|?(?P<series>[456]9|48)(?:(?P<bore>\d\d)|/(?P<millimetres>\d\d))" + _REST
)
_DRAWN_CUP: Final = re.compile(r"(?P<type>HK|BK)\|?(?P<bore>\d\d)\|?(?P<width>\d\d)" + _REST)
_CAGE: Final = re.compile(
    r"K\|?(?P<inner>\d{1,3})\|?[X×]\|?(?P<outer>\d{1,3})\|?[X×]\|?(?P<width>\d{1,3})" + _REST
)
_SERIES: Final = {"cylindrical": _CYLINDRICAL, "tapered": _TAPERED, "needle": _NEEDLE}
_STROKE: Final = re.compile(r"(?<=\d)\s*/\s*(?=(?:22|28|32)(?!\d))")
"""Stroke before a bore in mm; a blank or a hyphen would make it two figures of a bore code."""
_STANDARD: Final = ""
_LETTERS: Final = {
    "cylindrical": re.compile(r"\|?(?P<design>EC|E)(?=[WTMJPGHX|-]|$)"),
    "tapered": re.compile(
        r"\|?(?P<design>XJ2|XJ|X|DJ|D(?![BFTYU])|CJ|C\|?A|C(?![0-9NM])|BJ2|BJ|B|AJ|A|J2|J)"
        r"(?:\|?(?P<quality>Q)(?![A-Z0-9]))?|\|?(?P<only>Q)(?![A-Z0-9])"
    ),
}
_OF_STEEP: Final = "DCB"
"""Letters behind the number of a tapered bearing with a contact angle that is not the usual one."""


@frozen
class RollerNumber:
    """What the number of a roller bearing says.

    Attributes
    ----------
    kind
        ``"cylindrical"``, ``"tapered"``, ``"needle"`` or ``"drawn_cup"``.
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
    for kind, pattern in (
        ("cylindrical", _CYLINDRICAL),
        ("tapered", _TAPERED),
        ("needle", _NEEDLE),
    ):
        found = pattern.fullmatch(joined)
        if found is not None:
            return _of_series(kind, found, maker)
    if (found := _DRAWN_CUP.fullmatch(joined)) is not None:
        bore, width = int(found["bore"]), int(found["width"])
        own = [f"{prefix}{bore}{width}" for prefix in ("FJ", "FJP")]
        names = (f"{found['type']}{found['bore']}{found['width']}", *own, f"FJ{bore}{width}L")
        return RollerNumber(
            "drawn_cup", found["type"], "", names[0], str(bore), names,
            _meant("roller_types", found["type"]), found["rest"] or "",
        )  # fmt: skip
    if (found := _CAGE.fullmatch(joined)) is not None:
        inner, outer, wide = (found[name] for name in ("inner", "outer", "width"))
        sizes = f"{inner}{outer}{wide}"
        own = [f"{letters}{sizes}" for letters in ("FWF", "FWJ", "FBN", "FBNP")]
        names = (f"K{inner}X{outer}X{wide}", *own, f"FWF{sizes}A")
        return RollerNumber(
            "needle", "K", "", names[0], inner, names, _meant("roller_types", "K"),
            found["rest"] or "",
        )  # fmt: skip
    return None


def _of_series(kind: str, found: re.Match[str], maker: str) -> RollerNumber:
    told = found.groupdict()
    series, rest = told["series"], told["rest"] or ""
    bore = told["bore"] or told["millimetres"]
    place = bore if told["bore"] else f"/{bore}"
    type_ = told.get("type") or ""
    number = f"{type_}{series}{place}"
    letters, design = _meant("roller_types", type_), _STANDARD
    own = _LETTERS[kind].match(rest) if kind in _LETTERS else None
    if own is not None:
        parts = [part for part in own.groupdict().values() if part]
        design = (own["design"] or "").replace("|", "")
        rest = rest[own.end() :]
        for part in parts:
            letters += _meant("roller_designs", part.replace("|", ""))
    names = tuple(f"{number}{behind}" for behind in _behind(kind, design, maker))
    if kind == "tapered":
        names = tuple(name for one in names for name in _with_prefix(one, maker))
    in_mm = bore if told["millimetres"] else f"code {bore}"
    return RollerNumber(kind, type_, series, number, in_mm, names, letters, rest)


def _with_prefix(name: str, maker: str) -> tuple[str, ...]:
    """NSK's tapered bearings of high capacity bear HR before the number."""
    return (name, f"HR{name}") if maker == "SKF" else (f"HR{name}", name)


def _behind(kind: str, design: str, maker: str) -> tuple[str, ...]:
    """Return the letters with which makers list a design, those of the maker first."""
    listed = designation_data()["roller_listed_as"]
    if kind == "tapered":
        plain = "steep" if design[:1] in tuple(_OF_STEEP) and design else "usual"
        plain = {"D": "steepest", "B": "larger"}.get(design[:1], plain)
        groups = listed["tapered"][plain]
    elif kind == "cylindrical":
        groups = listed["cylindrical"][design or "plain"]
    else:
        return ("",)
    first = groups.get(maker, ())
    return tuple(dict.fromkeys((*first, *(one for group in groups.values() for one in group))))


def _meant(table: str, part: str) -> Letters:
    """What a part of a number means; it takes part in finding the bearing."""
    meaning = designation_data()[table].get(part)
    return Letters(parts=(Part(part, meaning),)) if meaning else Letters()
