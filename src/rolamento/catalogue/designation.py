"""What a designation says by itself: series, bore, contact angle, clearance class, the rest."""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass
from functools import lru_cache
from importlib import resources
from math import radians
from typing import Any, Final, Literal

from rolamento.errors import InputError

__all__ = ["ClearanceClass", "Designation", "folded", "parse_designation"]

ClearanceClass = Literal["C2", "CN", "C3", "C4", "C5"]

_LONGEST: Final = 60
_NUMBER: Final = re.compile(
    r"(?P<prefix>[A-Z0-9]*?[A-Z])?"
    r"(?P<series>6[02389]|61[89]|7[0239]|71[89])"
    r"(?P<bore>\d{2})"
    r"(?P<rest>(?:2[RZ]|\D).*)?"
)
_ANGLE: Final = re.compile(r"(?<=[\s/-])(?P<angle>\d{1,2}(?:\.\d+)?)\s*(?:DEG|°)(?![A-Z])")
_CLASS: Final = re.compile(r"C[0-9N]")
_MILLIMETRE: Final = 1e-3


@dataclass(frozen=True, slots=True, kw_only=True)
class Designation:
    """The parts of a designation.

    Attributes
    ----------
    text
        As it was given.
    number
        The basic number, such as ``"6205"`` or ``"7218"``; empty if it is of another system.
    series
        Such as ``"62"``; empty likewise.
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
    number: str = ""
    series: str = ""
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
    def keys(self) -> tuple[str, ...]:
        """What to look for in a catalogue, folded, the most telling first."""
        angle = self.contact_angle
        keys = [folded(self.text)]
        if self.number:
            letters = [key for key, value in _data()["angles"].items() if angle == radians(value)]
            keys += [folded(self.number + letter) for letter in letters] if angle else []
            keys += [folded(self.number)] if angle is None else []
        return tuple(dict.fromkeys(keys))


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
            f"must be a text of 1 to {_LONGEST} characters",
            field="designation",
            value=text,
            example='designation = "6205"',
        )
    given = text.strip().upper()
    written = _ANGLE.search(given)
    plain = given if written is None else given[: written.start()] + given[written.end() :]
    angle = None if written is None else radians(float(written["angle"]))
    parts = _NUMBER.fullmatch(_compact(plain))
    if parts is None or (parts["prefix"] or "W") not in _data()["prefixes"]:
        return _of_another_system(text, plain, angle)
    meanings: list[tuple[str, str]] = []
    unknown: list[str] = []
    prefix = parts["prefix"] or ""
    if prefix:
        meanings.append((prefix, _data()["prefixes"][prefix]))
    rest = parts["rest"] or ""
    if angle is None and parts["series"].startswith("7"):
        angle, rest = _angle(rest)
    clearance = _suffixes(rest, meanings, unknown, text)
    series = parts["series"]
    return Designation(
        text=text.strip(),
        number=series + parts["bore"],
        series=series,
        bore=_bore(parts["bore"]),
        dimension_series=_data()["dimension_series"].get(series, series),
        contact_angle=angle,
        clearance_class=clearance,
        meanings=tuple(meanings),
        unknown=tuple(unknown),
    )


def _of_another_system(text: str, plain: str, angle: float | None) -> Designation:
    """Makers' own numbers: only an angle and a class at the end are understood."""
    given = re.search(r"[/\s-](C[2-5N])\s*$", plain)
    clearance: ClearanceClass | None = None if given is None else _data()["clearance"][given[1]]
    return Designation(text=text.strip(), contact_angle=angle, clearance_class=clearance)


def _bore(code: str) -> float:
    millimetres = _data()["bore_codes"].get(code, 5 * int(code))
    return float(millimetres) * _MILLIMETRE


def _angle(rest: str) -> tuple[float | None, str]:
    """Return the contact angle that the letters behind the number tell, and what is left."""
    for letters, angle in _data()["angles"].items():
        if rest.startswith(letters) and not _CLASS.match(rest):
            return radians(angle), rest[len(letters) :]
    return None, rest


def _suffixes(
    rest: str, meanings: list[tuple[str, str]], unknown: list[str], text: str
) -> ClearanceClass | None:
    """Take the suffixes apart, the longest known one first."""
    classes, known = _data()["clearance"], _data()["suffixes"]
    by_length = sorted(known, key=len, reverse=True)
    clearance: ClearanceClass | None = None
    while rest:
        if _CLASS.match(rest):
            if rest[:2] not in classes:
                raise InputError(
                    f"names no clearance class of ISO 5753-1 with {rest[:2]}; they are"
                    " C2, CN, C3, C4 and C5",
                    field="designation",
                    value=text,
                    example='designation = "6205/C3"',
                )
            clearance, rest = classes[rest[:2]], rest[2:]
            continue
        found = next((suffix for suffix in by_length if rest.startswith(suffix)), "")
        if found:
            meanings.append((found, known[found]))
        else:
            unknown.append(rest[0])
        rest = rest[len(found) or 1 :]
    return clearance


def _compact(text: str) -> str:
    return re.sub(r"[\s\-/]", "", text).upper()


@lru_cache(maxsize=1)
def _data() -> dict[str, Any]:
    file = resources.files("rolamento") / "data" / "designations.toml"
    return tomllib.loads(file.read_text(encoding="utf-8"))
