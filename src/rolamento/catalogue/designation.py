"""What a designation says by itself: series, bore, contact angle, clearance class, the rest.

Insert bearings and their units have the inside of a deep-groove bearing; of other types only what
they are is known.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import lru_cache, partial
from math import radians
from typing import Any, Final, Literal, NamedTuple, cast

from rolamento._data import toml_of
from rolamento.errors import InputError
from rolamento.units import MILLIMETRE
from rolamento.words import said

designation_data = partial(toml_of, "designations")
"""What the parts of designations mean."""

_INSERT: Final = re.compile(
    r"(?P<letters>[A-Z]{2,7})-?(?P<series>[23X])(?P<bore>\d\d)(?:-(?P<sixteenths>\d{1,2})(?![A-Z\d]))?"
    r"(?P<rest>(?:[-/]?[A-Z]|[-/]\d).*)?"
)
_UNIT: Final = re.compile(r"(?P<letters>[A-Z]{2,5})-?(?P<bore>\d{2,3})(?P<rest>(?:-|[A-Z]).*)?")
_MIN_BORE_CODE: Final = 4
"""Of the bore: below 20 mm makers differ in the outside diameter."""
_MAX_BORE_CODE: Final = 22


class Insert(NamedTuple):
    """An insert bearing, alone or in its housing.

    Attributes
    ----------
    number
        of the deep-groove bearing with the same inside
    clearance_class
        with which it is supplied, unless its suffixes say another
    meanings
        of its letters
    rest
        suffixes that follow
    """

    number: str
    clearance_class: str
    meanings: tuple[tuple[str, str], ...]
    rest: str


def insert_of(text: str) -> Insert | None:
    """Return the insert bearing that a designation names, such as ``"UCP 205-16"``; else None.

    Raises
    ------
    InputError
        If it is one whose inside depends on the maker.
    """
    plain = re.sub(r"[\s.]", "", text.upper())
    found = _INSERT.fullmatch(plain)
    parts = None if found is None else _letters_of_unit(found["letters"])
    if found is not None and parts is not None:
        series, code = found["series"], int(found["bore"])
        _check_bore_code(text, series, code)
        number = f"62{code + 1:02d}" if series == "X" else f"6{series}{code:02d}"
        meanings = [(parts.insert, parts.meaning)]
        if parts.housing:
            meanings.append((parts.housing, designation_data()["insert_housings"][parts.housing]))
        if found["sixteenths"]:
            meanings.append((f"-{found['sixteenths']}", designation_data()["phrases"]["inches"]))
        tapered = "tapered" in parts.meaning
        return Insert(number, "C4" if tapered else "C3", tuple(meanings), found["rest"] or "")
    found = _UNIT.fullmatch(plain)
    if found is None or found["letters"] not in designation_data()["insert_units"]["names"]:
        return None
    code, off = divmod(int(found["bore"]), 5)
    plain_bearing = found["letters"] == "GE" and not re.match(r"-?(?:K|NPP)", found["rest"] or "")
    if off or plain_bearing or code > _MAX_BORE_CODE:
        return None
    _check_bore_code(text, "2", code)
    meanings = [(found["letters"], designation_data()["phrases"]["unit"])]
    return Insert(f"62{code:02d}", "C3", tuple(meanings), found["rest"] or "")


class _UnitLetters(NamedTuple):
    insert: str
    meaning: str
    housing: str


def _letters_of_unit(letters: str) -> _UnitLetters | None:
    """Part the letters of a unit into those of its insert and of its housing."""
    data = designation_data()
    for insert in sorted(data["inserts"], key=len, reverse=True):
        housing = letters.removeprefix(insert)
        if letters.startswith(insert) and (not housing or housing in data["insert_housings"]):
            return _UnitLetters(insert, data["inserts"][insert], housing)
    return None


def _check_bore_code(text: str, series: str, code: int) -> None:
    if _MIN_BORE_CODE <= code <= _MAX_BORE_CODE:
        return
    if code > _MAX_BORE_CODE:
        rule = said("is not an insert bearing: bore codes end at {most}", most=_MAX_BORE_CODE)
    else:
        rule = (
            said("is an insert bearing with the internal geometry of 6304; use that")
            if series == "3"
            else said(
                "is an insert bearing with the internal geometry of 6203 or 6204, "
                "depending on the maker; use that"
            )
        )
    raise InputError(rule, field="designation", value=text, example='designation = "6204"')


def other_type(text: str) -> str:
    """Return what a designation is, as the end of a sentence, if its type is not known here."""
    plain = re.sub(r"[\s\-/.]", "", text.upper())
    for kind in designation_data()["type"]:
        kept_out = kind.get("unless")
        if re.match(kind["begins"], plain) and not (kept_out and re.match(kept_out, plain)):
            return _other_type_sentence(kind)
    return ""


def _other_type_sentence(kind: dict[str, Any]) -> str:
    name = said(kind["name"])
    if "advice" in kind:
        return said("is {kind}; {advice}", kind=name, advice=said(kind["advice"]))
    return said(
        "is {kind}; the catalogue covers single-row deep-groove, single- and double-row"
        " angular-contact, four-point contact, self-aligning and single-direction thrust ball"
        " bearings",
        kind=name,
    )


ClearanceClass = Literal["C2", "CN", "C3", "C4", "C5"]

_LONGEST: Final = 60
_NUMBER: Final = re.compile(
    r"(?P<prefix>[A-Z0-9]*?[A-Z]|E2)?\|?"
    r"(?P<series>6[02389]|61[89]|7[0239]|71[89]|[35][23]|[12][23]|51[1-4])\|?"
    r"(?P<bore>\d{2})"
    r"(?P<rest>(?:\|?2[RZ]|\D).*)?"
)
_FOUR_POINT: Final = re.compile(
    r"(?P<series>QJF?\|?(?:2|3|10))(?P<bore>\d{2})(?P<rest>(?:\|?2[RZ]|\D).*)?"
)
"""Of a text whose blanks, hyphens, strokes and points are one stroke each."""
_ANGLE: Final = re.compile(r"(?<=[\s/-])(?P<angle>\d{1,2}(?:\.\d+)?)\s*(?:DEG|°)(?![A-Z])")
_CLASS: Final = re.compile(r"C[0-9N]")
_MOST_LETTERS: Final = 2
"""Suffixes of one letter in a row; more of them are a word that nobody meant so."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Designation:
    """The parts of a designation.

    Attributes
    ----------
    text
        As it was given.
    name
        The same without a maker's name.
    maker
        Whose name stands before or behind it; empty if none does.
    number
        The basic number, such as ``"6205"`` or ``"7218"``; empty if it is of another system.
    series
        Such as ``"62"``; empty likewise.
    insert
        Whether it is an insert bearing or a unit with one, with the inside of that number.
    bore
        In m, by the code; None likewise.
    dimension_series
        The deep-groove series of the same boundary dimensions, ``"62"`` for 7218.
    contact_angle
        In rad, by its letters or as ``"25deg"``; None if it says none.
    clearance_class
        By ISO 5753-1; None if it says none, which means normal, CN.
    meanings
        Each prefix and suffix that is understood, with its meaning.
    unknown
        What is not understood.
    """

    text: str
    name: str = ""
    maker: str = ""
    number: str = ""
    series: str = ""
    insert: bool = False
    bore: float | None = None
    dimension_series: str = ""
    contact_angle: float | None = None
    clearance_class: ClearanceClass | None = None
    meanings: tuple[tuple[str, str], ...] = ()
    unknown: tuple[str, ...] = ()

    @property
    def is_angular_contact(self) -> bool:
        """Whether the series is one of angular-contact bearings."""
        return self.series.startswith("7")

    @property
    def kind(self) -> str:
        """What a series is that is neither deep-groove nor single-row angular contact; or empty."""
        return str(designation_data()["kinds"].get(self.series, ""))

    @property
    def equivalents(self) -> tuple[str, ...]:
        """Numbers by which makers list a bearing of the same type and size, the nearest first."""
        own = [
            self.number + letters
            for letters in designation_data()["listed_as"].get(self.series, ())
        ]
        other = designation_data()["same_size"].get(self.series)
        return (*own, other + self.number[-2:]) if other else tuple(own)

    @property
    def keys(self) -> tuple[str, ...]:
        """What to look for in a catalogue, folded, the most telling first."""
        angle = self.contact_angle
        keys = [folded(self.text), folded(self.name)]
        if self.number:
            letters = [
                key for key, value in _angles_of(self.kind).items() if angle == radians(value)
            ]
            keys += [folded(self.number + letter) for letter in letters] if angle else []
            keys += [folded(self.number)] if angle is None else []
        return tuple(dict.fromkeys(key for key in keys if key))


def folded(text: str) -> str:
    """Return a designation without case, spaces, hyphens, slashes and points."""
    return re.sub(r"[\s\-/.,_]", "", text[:_LONGEST].replace("°", "deg")).casefold()


def parse_designation(text: str) -> Designation:
    """Take a designation apart.

    Parameters
    ----------
    text
        Such as ``"6205"``, ``"6205-2RS1/C3"``, ``"7218B"`` or ``"EX 70 25deg"``.

    Raises
    ------
    InputError
        If it is empty, too long, or names a clearance class that does not exist.
    """
    if not text.strip() or len(text) > _LONGEST:
        raise InputError(
            said("must be text of 1 to {most} characters", most=_LONGEST),
            field="designation",
            value=text,
            example='designation = "6205"',
        )
    name, maker = _without_maker(text.strip())
    meanings = [(maker, designation_data()["phrases"]["maker"])] if maker else []
    given = name.upper()
    written = _ANGLE.search(given)
    plain = given if written is None else given[: written.start()] + given[written.end() :]
    angle = None if written is None else radians(float(written["angle"]))
    grouped = "|".join(suffix_groups(plain))
    arched = _FOUR_POINT.fullmatch(grouped)
    parts = arched or _NUMBER.fullmatch(grouped)
    prefix = "" if parts is None or arched else parts["prefix"] or ""
    if parts is None or (prefix and prefix not in designation_data()["prefixes"]):
        insert = insert_of(plain)
        if insert is None:
            return _of_another_system(text, name, maker, plain, angle)
        suffixes = _suffixes(suffix_groups(insert.rest), text)
        return Designation(
            text=text.strip(),
            name=name,
            maker=maker,
            number=insert.number,
            series=insert.number[:2],
            insert=True,
            bore=_bore(insert.number[2:]),
            dimension_series=insert.number[:2],
            clearance_class=suffixes.clearance or cast("ClearanceClass", insert.clearance_class),
            meanings=(*meanings, *insert.meanings, *suffixes.meanings),
            unknown=suffixes.unknown,
        )
    if prefix:
        meanings.append((prefix, designation_data()["prefixes"][prefix]))
    groups = suffix_groups(parts["rest"] or "")
    series = "QJ" + re.sub(r"\D", "", parts["series"]) if arched else parts["series"]
    kind = designation_data()["kinds"].get(series, "")
    if angle is None and (series.startswith("7") or kind == "double_row") and groups:
        angle, groups[0] = _angle(groups[0], kind)
    suffixes = _suffixes(groups, text)
    return Designation(
        text=text.strip(),
        name=name,
        maker=maker,
        number=series + parts["bore"],
        series=series,
        bore=_bore(parts["bore"]),
        dimension_series=designation_data()["dimension_series"].get(series, series),
        contact_angle=angle,
        clearance_class=suffixes.clearance,
        meanings=(*meanings, *suffixes.meanings),
        unknown=suffixes.unknown,
    )


def suffix_groups(text: str) -> list[str]:
    """Return what blanks, hyphens, strokes and points part in a designation."""
    return [group for group in re.split(r"[\s\-/.|]+", text) if group]


def _without_maker(text: str) -> tuple[str, str]:
    """Part a designation from the name of a maker before or behind it."""
    names = "|".join(
        sorted(map(re.escape, designation_data()["makers"]["names"]), key=len, reverse=True)
    )
    before = re.match(rf"\(?({names})\)?[\s\-/:]*(?=[^\s\-/:)]*\d)(?![A-Z])", text, re.IGNORECASE)
    spaced = re.match(rf"\(?({names})\)?[\s\-/:]+(?=\S)", text, re.IGNORECASE)
    first = spaced or before
    if first is not None:
        return text[first.end() :].strip(), first[1].upper()
    behind = re.search(rf"(?:[\s\-/(]+|(?<=\d))({names})\)?$", text, re.IGNORECASE)
    if behind is not None and behind.start() > 0:
        return text[: behind.start()].strip(), behind[1].upper()
    return text, ""


def _of_another_system(
    text: str, name: str, maker: str, plain: str, angle: float | None
) -> Designation:
    """Makers' own numbers: only an angle and a class at the end are understood."""
    given = re.search(r"[/\s-](C[2-5N])\s*$", plain)
    clearance: ClearanceClass | None = (
        None if given is None else designation_data()["clearance"][given[1]]
    )
    return Designation(
        text=text.strip(), name=name, maker=maker, contact_angle=angle, clearance_class=clearance
    )


def _bore(code: str) -> float:
    millimetres = designation_data()["bore_codes"].get(code, 5 * int(code))
    return float(millimetres) * MILLIMETRE


def _angles_of(kind: str) -> dict[str, float]:
    return dict(designation_data()["angles_of_double_rows" if kind == "double_row" else "angles"])


def _angle(rest: str, kind: str) -> tuple[float | None, str]:
    """Return the contact angle that the letters behind the number tell, and what is left."""
    for letters, angle in _angles_of(kind).items():
        if rest.startswith(letters) and not _CLASS.match(rest):
            return radians(angle), rest[len(letters) :]
    return None, rest


class _Suffixes(NamedTuple):
    """What suffixes say."""

    clearance: ClearanceClass | None
    meanings: tuple[tuple[str, str], ...]
    unknown: tuple[str, ...]


def _suffixes(groups: list[str], text: str) -> _Suffixes:
    """Take suffixes apart, group by group."""
    classes, known = designation_data()["clearance"], designation_data()["suffixes"]
    clearance: ClearanceClass | None = None
    meanings: list[tuple[str, str]] = []
    unknown: list[str] = []
    for group in groups:
        parts = _known_suffixes(group)
        if parts is None:  # what is not understood is one word, not some of its letters
            parts = tuple(re.findall(_known_suffix_pattern(), group))
        for part in parts:
            if _CLASS.fullmatch(part):
                if part not in classes:
                    raise InputError(
                        said(
                            "names no clearance class of ISO 5753-1 with {part}; the classes are "
                            "C2, CN, C3, C4 and C5",
                            part=part,
                        ),
                        field="designation",
                        value=text,
                        example='designation = "6205/C3"',
                    )
                clearance = classes[part]
            elif part in known:
                meanings.append((part, known[part]))
            else:
                unknown.append(part)
    return _Suffixes(clearance, tuple(meanings), tuple(unknown))


@lru_cache(maxsize=1024)
def _known_suffixes(group: str, letters: int = 0) -> tuple[str, ...] | None:
    """Known suffixes that make up a group, the longest first; None if none do.

    letters: how many suffixes of one letter stand before it.
    """
    if not group:
        return ()
    if _CLASS.match(group):
        rest = _known_suffixes(group[2:])
        return None if rest is None else (group[:2], *rest)
    known = designation_data()["suffixes"]
    for length in range(len(group), 0, -1):
        if group[:length] in known and (length > 1 or letters < _MOST_LETTERS):
            rest = _known_suffixes(group[length:], letters + 1 if length == 1 else 0)
            if rest is not None:
                return (group[:length], *rest)
    return None


@lru_cache(maxsize=1)
def _known_suffix_pattern() -> re.Pattern[str]:
    """Classes and suffixes of more than one sign, and what is between them."""
    known = sorted(
        (re.escape(s) for s in designation_data()["suffixes"] if len(s) > 1), key=len, reverse=True
    )
    named = "|".join(("C[0-9N]", *known))
    return re.compile(rf"{named}|(?:(?!{named}).)+")
