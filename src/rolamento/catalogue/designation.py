"""What a designation says by itself: series, bore, contact angle, clearance class, the rest.

Insert bearings and their units have the inside of a deep-groove bearing; of other types only what
they are is known.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import field
from functools import cache
from math import radians
from typing import Any, Final, NamedTuple, cast

from rolamento.catalogue.letters import (
    ClearanceClass,
    Letters,
    Part,
    designation_data,
    groups_of,
    letters_before,
    letters_behind,
)
from rolamento.catalogue.roller_designation import RollerNumber, roller_number_of
from rolamento.errors import InputError
from rolamento.records import frozen
from rolamento.types import TYPES
from rolamento.units import MILLIMETRE
from rolamento.words import said

_INSERT: Final = (
    r"(?P<letters>[A-Z]{2,7})-?(?P<series>[23X])(?P<bore>\d\d)(?:-(?P<sixteenths>\d{1,2})(?![A-Z\d]))?"
    r"(?P<rest>(?:[-/]?[A-Z]|[-/]\d).*)?"
)
_UNIT: Final = r"(?P<letters>[A-Z]{2,5})-?(?P<bore>\d{2,3})(?P<rest>(?:-|[A-Z]).*)?"
_MIN_BORE_CODE: Final = 4
"""Smallest code of the bore: below 20 mm makers differ in the outside diameter."""
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
    found = re.fullmatch(_INSERT, plain)
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
        supplied = designation_data()["insert_classes"].get(parts.insert, "C3")
        return Insert(number, supplied, tuple(meanings), found["rest"] or "")
    found = re.fullmatch(_UNIT, plain)
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
        "is {kind}, a type that the catalogue does not have; give its rolling elements and rings",
        kind=name,
    )


_LONGEST: Final = 60
_NUMBER: Final = re.compile(
    r"(?P<prefix>[A-Z0-9]*?[A-Z]|E2)?\|?"
    r"(?P<series>6[02389]|61[89]|7[02389]|71[89]|[35][23]|[12][23]|51[1-4])\|?"
    r"(?P<bore>\d{2})"
    r"(?P<rest>(?:\|?2[RZ]|\D).*)?"
)
"""Pattern of a text whose blanks, hyphens, strokes and points are one stroke each."""
_FOUR_POINT: Final = re.compile(
    r"(?P<series>QJF?\|?(?:2|3|10))(?P<bore>\d{2})(?P<rest>(?:\|?2[RZ]|\D).*)?"
)
"""The same pattern for four-point bearings."""
_ANGLE: Final = re.compile(r"(?<=[\s/-])(?P<angle>\d{1,2}(?:\.\d+)?)\s*(?:DEG|°)(?![A-Z])")
_DESIGN: Final = re.compile(r"(?P<angle>AC|C|F)(?P<design>[DEB])(?=G[ABC]?(?:\||$)|\||$)")
"""SKF's letters of contact angle and internal design, behind the number of a spindle bearing."""
_PARTING: Final = str.maketrans(dict.fromkeys("-/.,_"))
_BORE_IN_MM: Final = re.compile(r"\b((?:HR\s*)?3\d\d|R?NA\s*\d\d)\s*/\s*(\d\d)(?!\d)", re.I)
"""Pattern of tapered and needle roller bearings."""
_SPINDLE_SERIES: Final = ("70", "718", "719")
_MILLIMETRES_A_CODE: Final = 5


@frozen(kw_only=True)
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
    bearing_type
        Of a roller bearing: ``"NU"``, ``"NJ"`` …, ``"NA"``, ``"K"`` or ``"HK"``; else empty.
    names
        By which makers list a roller bearing, the likeliest first.
    insert
        Whether it is an insert bearing or a unit with one, with the inside of that number.
    bore
        In m, by the code; None likewise.
    contact_angle
        In rad, by its letters or as ``"25deg"``; None if it says none.
    letters
        What the letters before and behind the number say.
    """

    text: str
    name: str = ""
    maker: str = ""
    number: str = ""
    series: str = ""
    bearing_type: str = ""
    names: tuple[str, ...] = ()
    insert: bool = False
    bore: float | None = None
    contact_angle: float | None = None
    letters: Letters = field(default_factory=Letters)

    @property
    def clearance_class(self) -> ClearanceClass | None:
        """By ISO 5753-1, or CM; None if it says none, which means normal, CN."""
        return self.letters.clearance_class

    @property
    def of_maker(self) -> Letters:
        """What a maker's name beside the designation says."""
        return Letters(parts=(Part(self.maker, _phrase("maker")),) if self.maker else ())

    @property
    def meanings(self) -> tuple[Part, ...]:
        """Each prefix and suffix that is understood, with its meaning."""
        return self.letters.parts

    @property
    def unknown(self) -> tuple[str, ...]:
        """What is not understood."""
        return self.letters.unknown

    @property
    def is_angular_contact(self) -> bool:
        """Whether the series is one of angular-contact bearings."""
        return self.series.startswith("7")

    @property
    def kind(self) -> str:
        """What a series is that is neither deep-groove nor single-row angular contact; or empty."""
        data = designation_data()
        by_type = data["kinds_of_types"].get(self.bearing_type)
        return str(by_type or data["kinds"].get(self.series, ""))

    @property
    def equivalents(self) -> tuple[str, ...]:
        """Numbers by which makers list a bearing of the same type and size, the nearest first."""
        letters = designation_data()["listed_as"].get(self.series, ())
        own = [self.number + letter for letter in letters]
        other = designation_data()["same_size"].get(self.series)
        return (*own, other + self.number[-2:]) if other else tuple(own)

    @property
    def keys(self) -> tuple[str, ...]:
        """What to look for in a catalogue, folded, the most specific first."""
        keys = [self.text, self.name]
        for number in self._numbers:
            if self.contact_angle is None:
                keys.append(number)
            keys += [number + letter for letter in self.angle_letters]
        return tuple(dict.fromkeys(key for key in map(folded, keys) if key))

    @property
    def angle_letters(self) -> tuple[str, ...]:
        """The letters by which makers denote this contact angle."""
        angle = self.contact_angle
        angles = _angles_of(self.kind).items()
        return tuple(letters for letters, value in angles if angle == radians(value))

    @property
    def _numbers(self) -> tuple[str, ...]:
        """The number, and that of other makers for the same boundary dimensions."""
        same = "" if self.kind else designation_data()["same_size"].get(self.series)
        numbers = (self.number, f"{same}{self.number[-2:]}" if same else "")
        return tuple(number for number in numbers if number)


def folded(text: str) -> str:
    """Return a designation without case, spaces, hyphens, slashes and points.

    A stroke before a bore in mm stays, as of 322/28, which is another bearing than 32228.
    """
    kept = with_kept_bore(text[:_LONGEST].replace("°", "deg"))
    return "".join(kept.translate(_PARTING).split()).casefold()


def each_folded(texts: Sequence[str]) -> list[str]:
    """Return thousands of designations, none longer than a line, as `folded` returns each."""
    kept = with_kept_bore("\n".join(texts).replace("°", "deg"))
    return kept.translate(_PARTING).replace(" ", "").casefold().split("\n")


def with_kept_bore(text: str) -> str:
    """Return a designation with a colon for the stroke before a bore in mm."""
    return _BORE_IN_MM.sub(r"\1:\2", text) if "/" in text else text


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

    >>> found = parse_designation("6310/C3").number
    >>> print(f"{found}")
    6310
    """
    if not text.strip() or len(text) > _LONGEST:
        raise InputError(
            said("must be text of 1 to {most} characters", most=_LONGEST),
            field="designation",
            value=text,
            example='designation = "6205"',
        )
    name, maker = _without_maker(text.strip())
    known: dict[str, Any] = {"text": text.strip(), "name": name, "maker": maker}
    whole = Designation(**known).of_maker
    given = name.upper()
    written = _ANGLE.search(given)
    plain = given if written is None else given[: written.start()] + given[written.end() :]
    angle = None if written is None else radians(float(written["angle"]))
    joined = "|".join(groups_of(plain))
    rollers = None if angle is not None else roller_number_of(plain, joined, maker)
    if rollers is not None:
        return _with_rollers(known, rollers, whole)
    arched = _FOUR_POINT.fullmatch(joined)
    parts = arched or _NUMBER.fullmatch(joined)
    prefix = "" if parts is None or arched else parts["prefix"] or ""
    before = letters_before(prefix, spindle=parts is not None and parts["series"][0] == "7")
    if parts is None or (prefix and not before.parts):
        insert = insert_of(plain)
        if insert is not None:
            meanings = tuple(Part(*meaning) for meaning in insert.meanings)
            supplied = cast("ClearanceClass", insert.clearance_class)
            whole += Letters(clearance_class=supplied, parts=meanings)
            return Designation(
                **known,
                number=insert.number,
                series=insert.number[:2],
                insert=True,
                bore=_bore(insert.number[2:]),
                letters=whole + letters_behind(groups_of(insert.rest), text),
            )
        return _spindle(known, joined, angle, whole) or _of_another_system(
            known, plain, angle, whole
        )
    series, rest = parts["series"], parts["rest"] or ""
    if arched:
        series = "QJ" + re.sub(r"\D", "", series)
    kind = designation_data()["kinds"].get(series, "")
    whole += before
    angular = series.startswith("7")
    if angle is None and (angular or _is_double(kind)):
        angle, design, rest = _angle(rest.lstrip("|"), series, kind)
        whole += design
    return Designation(
        **known,
        number=series + parts["bore"],
        series=series,
        bore=_bore(parts["bore"]),
        contact_angle=angle,
        letters=whole + letters_behind(groups_of(rest), text, angular=angular),
    )


_OF_ROLLERS: Final = re.compile(r"CC[0-59]?|CT")
"""Clearance classes of NSK's that balls do not have, or where the letters mean something else."""
_WITHIN: Final = r"CC[0-59](?=P\d|$)"
"""Those that NSK writes without a blank, as in NN3020TBKRCC0P4."""


def _with_rollers(known: Mapping[str, Any], rollers: RollerNumber, before: Letters) -> Designation:
    coded = rollers.bore.removeprefix("code ")
    in_mm = coded == rollers.bore
    groups = groups_of(re.sub(_WITHIN, r"|\g<0>|", rollers.rest))
    others = (group for group in groups if not _OF_ROLLERS.fullmatch(group))
    behind = letters_behind(others, known["text"])
    for group in filter(_OF_ROLLERS.fullmatch, groups):
        behind += Letters(clearance_class=cast("ClearanceClass", group))
    return Designation(
        **known,
        number=rollers.number,
        series=rollers.series,
        bearing_type=rollers.type,
        names=tuple(folded(name) for name in rollers.names),
        bore=float(coded) * MILLIMETRE if in_mm else _bore(coded),
        letters=before + rollers.letters + behind,
    )


def _phrase(key: str) -> str:
    return str(designation_data()["phrases"][key])


def _spindle(
    known: Mapping[str, Any], joined: str, angle: float | None, before: Letters
) -> Designation | None:
    """A spindle bearing of a maker's own numbers, such as NSK's 70BNR10; None of anything else."""
    prefix, _, behind = joined.partition("|")
    ahead = letters_before(prefix, spindle=True) if behind else Letters()
    number = behind if ahead.parts else joined
    for kind in designation_data()["spindle"]:
        found = re.fullmatch(kind["begins"], number)
        if found is None:
            continue
        told = found.groupdict()
        code = told.get("bore") or _code_of(int(told["bore_mm"]))
        if code is None:
            continue
        letters = before + ahead
        letters += Letters(design="E", parts=(Part(number[: found.start("rest")], kind["name"]),))
        if told.get("balls"):
            letters += letters_before(told["balls"])
        series = kind["series"][told["series"]]
        return Designation(
            **known,
            number=series + code,
            series=series,
            bore=_bore(code),
            contact_angle=angle or radians(kind["type"][told["type"]]),
            letters=letters + letters_behind(groups_of(told["rest"]), known["text"], angular=True),
        )
    return None


@cache
def _makers() -> tuple[str, ...]:
    """The makers' names, the longest first."""
    return tuple(sorted(designation_data()["makers"]["names"], key=len, reverse=True))


def _without_maker(text: str) -> tuple[str, str]:
    """Part a designation from the name of a maker before or behind it."""
    plain = text.casefold()
    if not any(name.casefold() in plain for name in _makers()):
        return text, ""
    names = "|".join(map(re.escape, _makers()))
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
    known: Mapping[str, Any], plain: str, angle: float | None, whole: Letters
) -> Designation:
    """Makers' own numbers: only an angle and a class at the end are understood."""
    given = re.search(r"[/\s-](C[2-5NM])\s*$", plain)
    if given is not None:
        whole += Letters(clearance_class=designation_data()["clearance"][given[1]])
    return Designation(**known, contact_angle=angle, letters=whole)


def _bore(code: str) -> float:
    millimetres = designation_data()["bore_codes"].get(code, 5 * int(code))
    return float(millimetres) * MILLIMETRE


def _is_double(kind: str) -> bool:
    return bool(kind) and TYPES[kind].is_double_row


def _angles_of(kind: str) -> dict[str, float]:
    return dict(designation_data()["angles_of_double_rows" if _is_double(kind) else "angles"])


def _code_of(millimetres: int) -> str | None:
    """The bore code of a bore; None if it has none of two figures."""
    for code, bore in designation_data()["bore_codes"].items():
        if bore == millimetres:
            return str(code)
    code, off = divmod(millimetres, _MILLIMETRES_A_CODE)
    return f"{code:02d}" if not off and code in range(4, 100) else None


def _angle(rest: str, series: str, kind: str) -> tuple[float | None, Letters, str]:
    """Return the contact angle that the letters behind the number denote, and what is left."""
    data = designation_data()
    spindle = None if kind else _DESIGN.match(rest)
    if spindle is not None and (series in _SPINDLE_SERIES or spindle["design"] == "D"):
        design = Part(spindle["design"], data["spindle_designs"][spindle["design"]])
        angle = radians(data["spindle_angles"][spindle["angle"]])
        return angle, Letters(design=design.text, parts=(design,)), rest[spindle.end() :]
    if rest.startswith("U") and not kind:
        for letters, degrees in data["angles_after_u"].items():
            if rest.startswith(letters, 1):
                return radians(degrees), Letters(), rest[1 + len(letters) :]
    for letters, degrees in _angles_of(kind).items():
        if rest.startswith(letters) and not re.match(r"C[0-9NM]", rest):
            return radians(degrees), Letters(), rest[len(letters) :]
    return None, Letters(), rest
