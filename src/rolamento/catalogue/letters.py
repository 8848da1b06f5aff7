"""What the letters behind a designation's number say: clearance, balls, arrangement, and the rest.

They come in groups, parted by blanks, hyphens, strokes and points. A group is taken apart into
known parts, the longest first; one that cannot be taken apart as a whole is not read letter by
letter. What the parts mean is in data/designations.toml.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import cache, lru_cache, partial
from typing import Final, Literal, NamedTuple, cast

from rolamento.errors import InputError
from rolamento.io.data import toml_of
from rolamento.records import frozen
from rolamento.words import said

designation_data = partial(toml_of, "designations")
"""What the parts of designations mean."""

ClearanceClass = Literal[
    "C2", "CN", "C3", "C4", "C5", "CM", "CT",
    "CC9", "CC0", "CC1", "CC2", "CC", "CC3", "CC4", "CC5",
]  # fmt: skip
"""CC of rollers between rings that are not interchangeable (CC9 and CC0: of tapered bores), CM and
CT of electric motors."""

_CLASS: Final = re.compile(r"C[0-9N]")
_TOLERANCE_AND_CLASS: Final = re.compile(r"(P[456])([2345])(?!\d)")
"""Such as P63: class P6 and clearance C3."""
_MOST_LETTERS: Final = 2
"""Suffixes of one letter in a row; more of them are a word that nobody meant so."""
_NSK_SET: Final = re.compile(r"D[BFT][BDFT](?=EL|[LMH])")
"""NSK's set of three or four has to have one of NSK's preloads behind it."""


class Part(NamedTuple):
    """A part of a designation, and its meaning in English."""

    text: str
    meaning: str


@frozen(kw_only=True)
class Letters:
    """What letters say.

    Attributes
    ----------
    clearance_class
        By ISO 5753-1, or a maker's; None if they say none.
    ball_material
        A name of `rolamento.Material`; None likewise.
    arrangement
        Of `rolamento.case.arrangement.ARRANGEMENTS`; None likewise.
    preload
        The part that names a class of preload; None likewise.
    design
        ``"D"``, ``"E"`` or ``"B"`` where they denote SKF's internal designs of spindle bearings, or
        that it is of a high-speed one, ``"E"``; else empty.
    parts
        What is understood, with the meaning; of a clearance class only what narrows it.
    idle
        Of those, and of what else they say, what changes no result.
    unknown
        What is not understood.
    """

    clearance_class: ClearanceClass | None = None
    ball_material: str | None = None
    arrangement: str | None = None
    preload: Part | None = None
    design: str = ""
    parts: tuple[Part, ...] = ()
    idle: tuple[Part, ...] = ()
    unknown: tuple[str, ...] = ()

    @property
    def preload_level(self) -> str | None:
        """The class of preload as makers' lists call it; None of a maker's own class."""
        levels: dict[str, str] = designation_data()["levels"]
        return None if self.preload is None else levels.get(self.preload.text)

    @property
    def stainless(self) -> Part | None:
        """The part that says that the rings are of stainless steel; None if none does."""
        return next((part for part in self.parts if _is_stainless(part)), None)

    @property
    def pair_clearance(self) -> Part | None:
        """The part by which a pair has an axial clearance, not a preload; None if none does."""
        known = designation_data()["pair_clearance"]["parts"]
        return next((part for part in self.parts if part.text in known), None)

    @property
    def at_speed(self) -> tuple[Part, ...]:
        """Parts that affect the limiting speed: tolerance class, cage, seals, design."""
        data = designation_data()
        known = {text for texts in data["bears_on_speed"].values() for text in texts}
        suffixes, prefixes = data["suffixes"], data["prefixes"]
        return tuple(
            part
            for part in self.parts  # M behind a set is a preload, behind a number a cage
            if part.text in known
            and part.meaning in (suffixes.get(part.text), prefixes.get(part.text))
        )

    def __add__(self, other: Letters) -> Letters:
        """Put what stands behind to what stands before; what is said last counts."""
        return Letters(
            clearance_class=other.clearance_class or self.clearance_class,
            ball_material=other.ball_material or self.ball_material,
            arrangement=other.arrangement or self.arrangement,
            preload=other.preload or self.preload,
            design=other.design or self.design,
            parts=(*self.parts, *other.parts),
            idle=(*self.idle, *other.idle),
            unknown=(*self.unknown, *other.unknown),
        )


def groups_of(text: str) -> list[str]:
    """Return what blanks, hyphens, strokes and points part in a designation."""
    return [group for group in re.split(r"[\s\-/.,|]+", text) if group]


def letters_before(prefix: str, *, spindle: bool = False) -> Letters:
    """Return what the letters before a number say; `spindle`: of a spindle bearing's."""
    data = designation_data()
    known = {**data["prefixes"], **(data["spindle_prefixes"] if spindle else {})}
    if prefix not in known:
        return Letters()
    found = _acting(Part(prefix, known[prefix]), takes_part=prefix == "B")
    return found + Letters(design="E") if prefix in data["high_speed"]["prefixes"] else found


def letters_behind(groups: Iterable[str], designation: str, *, angular: bool = False) -> Letters:
    """Return what groups of letters say.

    Parameters
    ----------
    groups
        In capitals.
    designation
        That they are of, for messages.
    angular
        Whether it is an angular-contact bearing's: letters of universal pairing are such.

    Raises
    ------
    InputError
        If they name a clearance class that does not exist.
    """
    whole = Letters()
    after: _Kind = ""
    for group in groups:
        found = _taken_apart(group, angular, after)
        if found is None:  # what is not understood is one word, not some of its letters
            found = tuple(_told_apart(group, angular))
        for part, kind in found:
            whole += _said_by(part, kind, designation)
            after = kind
    return whole


_Kind = Literal[
    "", "class", "digit", "half", "suffix", "tolerance", "set", "universal", "preload", "unknown"
]
_Found = tuple[tuple[str, _Kind], ...]


def _said_by(part: str, kind: _Kind, designation: str) -> Letters:
    data = designation_data()
    if kind == "digit":
        return Letters(clearance_class=data["clearance"][f"C{part}"])
    if kind == "class":
        if part not in data["clearance"]:
            raise InputError(
                said(
                    "names no clearance class of ISO 5753-1 with {part}; the classes are "
                    "C2, CN, C3, C4 and C5",
                    part=part,
                ),
                field="designation",
                value=designation,
                example='designation = "6205/C3"',
            )
        return Letters(clearance_class=cast("ClearanceClass", data["clearance"][part]))
    if kind == "half":
        narrowed = (Part(part, data["clearance_halves"][part]),)
        return Letters(parts=narrowed, idle=narrowed)
    if kind == "set":
        arrangement = data["arrangements"][part]
        return Letters(arrangement=arrangement, parts=(Part(part, data["sets"][part]),))
    if kind == "universal":
        return _acting(Part(part, data["universal"][part]))
    if kind == "preload":
        known = Part(part, data["preloads"][part])
        preload = None if part in data["pair_clearance"]["none"] else known
        return Letters(preload=preload, parts=(known,))
    if kind in ("suffix", "tolerance"):
        return _acting(Part(part, _meaning(part)))
    return Letters(unknown=(part,))


def _acting(part: Part, *, takes_part: bool = False) -> Letters:
    """What a part does beside being understood; `takes_part`: it belongs to the number."""
    data = designation_data()
    material, rings = data["balls"].get(part.text), data["rings"].get(part.text)
    idle = (Part(part.text, rings),) if rings else ()
    acts = takes_part or _is_stainless(part) or part.text in data["pair_clearance"]["parts"]
    if material is None and not rings and not acts:
        idle = (part,)
    return Letters(ball_material=material, parts=(part,), idle=idle)


def _is_stainless(part: Part) -> bool:
    """Whether a part names a stainless steel: S before a spindle bearing's number means sealed."""
    data = designation_data()
    return any(
        part.text in data["stainless"][table] and part.meaning == data[table][part.text]
        for table in ("prefixes", "inserts")
    )


def _meaning(part: str) -> str:
    data = designation_data()
    if part in data["suffixes"]:
        return str(data["suffixes"][part])
    patterns = _patterns()
    return next(meaning for pattern, meaning in patterns if pattern.fullmatch(part))


@cache
def _patterns() -> tuple[tuple[re.Pattern[str], str], ...]:
    return tuple(
        (re.compile(pattern), meaning)
        for pattern, meaning in designation_data()["patterns"].items()
    )


@lru_cache(maxsize=4096)
def _taken_apart(group: str, angular: bool, after: _Kind = "", letters: int = 0) -> _Found | None:
    """Known parts that make up a group, the longest first; None if none do.

    after: the kind of the part before it; letters: how many suffixes of one letter those were.
    """
    if not group:
        return ()
    for part, kind in _beginnings(group, angular, after):
        alone = kind == "suffix" and len(part) == 1
        if alone and letters >= _MOST_LETTERS:
            continue
        rest = _taken_apart(group[len(part) :], angular, kind, letters + 1 if alone else 0)
        if rest is not None:
            return ((part, kind), *rest)
    return None


def _beginnings(group: str, angular: bool, after: _Kind) -> Iterator[tuple[str, _Kind]]:
    """What a group may begin with, the most specific first."""
    data = designation_data()
    if after == "tolerance":
        yield group[0], "digit"
        return
    if _CLASS.match(group):
        yield group[:2], "class"
        return
    if (both := _TOLERANCE_AND_CLASS.match(group)) and both[0] not in data["suffixes"]:
        yield both[1], "tolerance"
    for length in (2, 1):
        ground = after in ("set", "universal") or (angular and group[:1] == "G" and length > 1)
        if ground and group[:length] in data["preloads"]:
            yield group[:length], "preload"
    if (nsk := _NSK_SET.match(group)) and nsk[0] in data["sets"]:
        yield nsk[0], "set"
    for length in range(len(group), 0, -1):
        part = group[:length]
        if part in data["clearance"]:
            yield part, "class"
        if part in data["sets"] and not _NSK_SET.match(f"{part}L"):
            yield part, "set"
        if angular and part in data["universal"]:
            yield part, "universal"
        if part in data["suffixes"] or any(pattern.fullmatch(part) for pattern, _ in _patterns()):
            yield part, "suffix"
    if after == "class" and group[0] in data["clearance_halves"]:
        yield group[0], "half"


def _told_apart(group: str, angular: bool) -> Iterator[tuple[str, _Kind]]:
    """What a group begins with as far as it is known; of the rest, parts of more than one sign."""
    known = 0
    for end in range(len(group) - 1, 1, -1):
        found = _taken_apart(group[:end], angular)
        if found is not None and (len(found[-1][0]) > 1 or found[-1][1] != "suffix"):
            yield from found
            known = end
            break
    for part in _long_part_pattern().findall(group[known:]):
        found = _taken_apart(part, angular)
        yield from ((part, "unknown"),) if found is None or len(part) == 1 else found


@cache
def _long_part_pattern() -> re.Pattern[str]:
    data = designation_data()
    known = [key for table in ("suffixes", "sets", "universal") for key in data[table]]
    known = sorted((re.escape(key) for key in known if len(key) > 1), key=len, reverse=True)
    named = "|".join(("C[0-9N]", "CM", *known))
    return re.compile(rf"(?:{named})|(?:(?!{named}).)+")
