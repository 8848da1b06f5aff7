"""Catalogues: the built-in one, a user's beside it; search as one types, look up a designation."""

from __future__ import annotations

import difflib
import os
import re
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import field, replace
from functools import cached_property, lru_cache
from importlib import resources
from itertools import chain, islice
from math import degrees, radians
from typing import Final, NamedTuple, cast

from rolamento.catalogue.designation import (
    Designation,
    each_folded,
    folded,
    other_type,
    parse_designation,
    with_kept_bore,
)
from rolamento.catalogue.letters import (
    Letters,
    designation_data,
    groups_of,
    letters_before,
    letters_behind,
)
from rolamento.catalogue.records import (
    CatalogueBearing,
    OwnRecords,
    records_of_csv,
    records_of_toml,
)
from rolamento.errors import FileError, InputError
from rolamento.io.data import toml_of
from rolamento.io.text import read_text
from rolamento.records import frozen
from rolamento.types import BearingKey, of_balls
from rolamento.units import MILLIMETRE
from rolamento.words import said

_MOST_RESULTS: Final = 1000
_NEAREST: Final = 3
_SIZES: Final = re.compile(r"\d+(?:\.\d+)?(?:[x×]\d+(?:\.\d+)?){1,2}")
_OF_SKF: Final = "SNFA"
_QUICK: Final = ("E", "B")
"""Internal designs with smaller balls than those of the bearing that makers list by the number."""
_ISO_15: Final = "ISO 15, dimension series {}"
_ROUNDING: Final = 1e-6
_SISTER_ANGLE: Final = radians(5.0)
"""By which the contact angle of a bearing that may stand in for another differs at most."""


@frozen
class Found:
    """A bearing of a catalogue, and what the designation says beyond its number."""

    bearing: CatalogueBearing
    designation: Designation


def _snfa_key(designation: Designation) -> str:
    """The key of SNFA's bearing that SKF sells by such a designation; empty if none."""
    names = designation_data()["snfa_names"].get(designation.letters.design, {})
    name, angle = names.get(designation.series), designation.contact_angle
    if name is None or angle is None or designation.bore is None:
        return ""
    bore = round(designation.bore / MILLIMETRE)
    return folded(f"{name.format(bore=bore)} {round(degrees(angle))}deg")


class Dimensions(NamedTuple):
    """Outside diameter and width, in m, and where they are from."""

    outside_diameter: float
    width: float
    source: str


def dimensions_of(designation: Designation) -> Dimensions | None:
    """Return the boundary dimensions that ISO 15 gives a number; None of what it does not know."""
    data = toml_of("iso15")
    series = data["numbers"].get(designation.series)
    if series is None or designation.bore is None:
        return None
    for table in ("series", "beyond"):
        found = data[table][series].get(f"{designation.bore / MILLIMETRE:.6g}")
        if found is not None:
            outside, width = (size * MILLIMETRE for size in found)
            return Dimensions(outside, width, _ISO_15.format(series))
    return None


def standard_width(bore: float, outside_diameter: float) -> float | None:
    """Return the width (m) that ISO 15 gives a bore and an outside diameter (m); None without."""
    data = toml_of("iso15")
    for table in ("series", "beyond"):
        for sizes in data[table].values():
            found = sizes.get(f"{bore / MILLIMETRE:.6g}")
            if found is not None and abs(found[0] * MILLIMETRE - outside_diameter) < _ROUNDING:
                return float(found[1] * MILLIMETRE)
    return None


@frozen(eq=False, slots=False)
class Catalogue:
    """Bearings by their designation; later ones take the place of earlier ones.

    Parameters
    ----------
    bearings
        The records.
    keys
        Their designations as they are looked up, `folded`; by default those that they name.
    """

    bearings: Sequence[CatalogueBearing]
    keys: Sequence[str] = field(default=(), repr=False)

    @cached_property
    def _places(self) -> dict[str, int]:
        keys = self.keys or [folded(bearing.designation) for bearing in self.bearings]
        return {key: place for place, key in enumerate(keys)}

    @cached_property
    def _with_maker(self) -> dict[str, str]:
        """The keys behind those of the makers, by the keys."""
        makers = {key: self._named(key).maker for key in self._places}
        before = {maker: folded(maker) for maker in {*makers.values()}}
        return {key: before[maker] + key for key, maker in makers.items()}

    def _named(self, key: str) -> CatalogueBearing:
        return self.bearings[self._places[key]]

    def _known(self, key: str) -> CatalogueBearing | None:
        return self._named(key) if key in self._places else None

    def beside(self, paths: Iterable[str | os.PathLike[str]]) -> Catalogue:
        """Return a catalogue with a user's files added; what they name again, they replace.

        Parameters
        ----------
        paths
            Files that end in .csv, of 5 MB at most, or .toml, of 1 MB.

        Raises
        ------
        InputError
            If a file cannot be read, or is no catalogue; with the line.
        """
        from rolamento.io.tables import table_text

        added: list[CatalogueBearing] = []
        for path in paths:
            name = os.fspath(path)
            ending = os.path.splitext(name)[1].lower()
            if ending not in (".csv", ".toml"):
                raise FileError(
                    said("must end in .csv or .toml"), source=name, example="bearings.csv"
                )
            if ending == ".csv":
                added += records_of_csv(*table_text(path))
            else:
                added += records_of_toml(*read_text(path))
        return Catalogue((*self.bearings, *added))

    def search(self, text: str, most: int = 50) -> tuple[CatalogueBearing, ...]:
        """Return the bearings whose designation begins with, then those that contain, a text.

        Parameters
        ----------
        text
            Part of a designation, or of "maker designation"; or boundary dimensions in mm such
            as ``"25x52"`` or ``"25x52x15"``. Case, spaces, hyphens and slashes do not matter.
        most
            Maximum number of results.
        """
        wanted = folded(text)
        if not wanted:
            return ()
        most = min(most, _MOST_RESULTS)
        compact = "".join(text[:60].split()).casefold()
        if _SIZES.fullmatch(compact):
            return self._of_sizes([1e-3 * float(size) for size in re.split("[x×]", compact)])[:most]
        first = (key for key in self._places if key.startswith(wanted))
        rest = (
            key
            for key, name in self._with_maker.items()
            if wanted in name and not key.startswith(wanted)
        )
        return tuple(map(self._named, islice(chain(first, rest), most)))

    def find(self, text: str) -> Found:
        """Return the bearing of a designation with prefixes and suffixes.

        A number of ISO's system that is in no list still has its boundary dimensions, if a
        bearing of the same dimension series is.

        Parameters
        ----------
        text
            Such as ``"6205"``, ``"6205/C3"``, ``"7218B"`` or ``"EX 70 25deg"``.

        Raises
        ------
        InputError
            If nothing is known of it; the message names the nearest designations.
        """
        return _found_in(self, text)

    def _found(self, text: str) -> Found:
        own = self._known(folded(text))
        if own is not None and not self._is_displaced(own, text):
            return self._own(own, text)
        designation = parse_designation(text)
        own = self._known(folded(designation.name))
        if own is not None and own.has_rollers and own.maker == designation.maker:
            return self._own(own, text)
        named = self._by_shorter_name(designation)
        if named is not None:
            return named
        for key in designation.names:
            if key in self._places:
                return Found(self._named(key), designation)
        quick = designation.letters.design in _QUICK
        plain = None if quick else self._known(folded(designation.number))
        if plain is not None and _same_angle(plain, designation):
            return Found(plain, designation)
        for key in (_snfa_key(designation), *(() if quick else designation.keys)):
            if key in self._places:
                return Found(self._named(key), designation)
        for number in designation.equivalents:
            like = self._known(folded(number))
            if like is not None and (
                designation.contact_angle is None or _same_angle(like, designation)
            ):
                return Found(like, designation)
        by_sizes = self._of_dimension_series(designation)
        if by_sizes is not None:
            return Found(by_sizes, designation)
        raise self._unknown(text)

    def _is_displaced(self, bearing: CatalogueBearing, text: str) -> bool:
        """Whether a bearing of the built-in catalogue is a user's own by its plain number."""
        if not is_built_in(bearing):
            return False
        designation = parse_designation(text)
        plain = self._known(folded(designation.number))
        return plain is not None and plain is not bearing and _same_angle(plain, designation)

    def _own(self, bearing: CatalogueBearing, text: str) -> Found:
        """A bearing that is listed by that very text: its letters need not mean what others do."""
        plain = Designation(text=text.strip(), name=text.strip())
        if folded(text).isdecimal() or bearing.has_rollers:
            plain = parse_designation(text)
        return Found(bearing, replace(plain, contact_angle=bearing.contact_angle))

    def _by_shorter_name(self, designation: Designation) -> Found | None:
        """The bearing whose whole name stands among the letters, as ``Q-17`` in Q-17/C3.

        A plain number is none: its letters may denote another contact angle.
        """
        groups = groups_of(with_kept_bore(designation.name.upper()))
        first = "" if designation.number or not groups else groups[0]
        before = letters_before(first, spindle=True)
        for start in (0, 1) if before.parts else (0,):
            for end in range(len(groups) - 1 + start, start, -1):
                key = folded("".join(groups[start:end]))
                bearing = self._known(key)
                if bearing is None or key == folded(designation.number):
                    continue
                alike = _same_angle(bearing, designation)
                if not (designation.number or designation.contact_angle is None or alike):
                    continue
                if bearing.has_rollers:
                    return Found(bearing, designation)
                angular = bearing.type.in_pairs
                letters = designation.of_maker + (before if start else Letters())
                letters += letters_behind(groups[end:], designation.text, angular=angular)
                found = replace(designation, contact_angle=bearing.contact_angle, letters=letters)
                return Found(bearing, found)
        return None

    def _of_sizes(self, sizes: list[float]) -> tuple[CatalogueBearing, ...]:
        bore, outside, *width = sizes
        return tuple(
            bearing
            for bearing in map(self._named, self._places)
            if abs(bearing.bore - bore) < _ROUNDING
            and abs(bearing.outside_diameter - outside) < _ROUNDING
            and all(bearing.width and abs(bearing.width - size) < _ROUNDING for size in width)
        )

    def _of_dimension_series(self, designation: Designation) -> CatalogueBearing | None:
        """A bearing of which only the boundary dimensions are known, by its number."""
        found = dimensions_of(designation)
        if found is None or designation.bore is None or designation.kind:
            return None
        sources = dict.fromkeys(("bore", "outside_diameter", "width"), found.source)
        if designation.contact_angle is not None:
            sources["contact_angle"] = "designation letters"
        return CatalogueBearing(
            designation=min(designation.keys, key=len).upper(),
            kind=cast("BearingKey", of_balls(angled=designation.is_angular_contact).key),
            bore=designation.bore,
            outside_diameter=found.outside_diameter,
            width=found.width,
            contact_angle=designation.contact_angle,
            sources=sources,
        )

    def sisters(self, bearing: CatalogueBearing, design: str = "") -> tuple[CatalogueBearing, ...]:
        """Return bearings of the same boundary dimensions whose balls are published.

        Parameters
        ----------
        bearing
            Angular-contact, else there are none.
        design
            Its internal design, as of `Letters`.

        Returns
        -------
        tuple
            Those of a like design first, then by the contact angle; none that is off by more than
            5 degrees.
        """
        angle, width = bearing.contact_angle, bearing.width
        if not bearing.type.in_pairs or angle is None:
            return ()

        def off(other: CatalogueBearing) -> float:
            return abs((other.contact_angle or 0.0) - angle)

        sizes = [bearing.bore, bearing.outside_diameter]
        alike = (
            other
            for other in self._of_sizes(sizes)
            if other.kind == bearing.kind
            and other.ball_count is not None
            and other.ball_diameter is not None
            and off(other) <= _SISTER_ANGLE
            and other.designation != bearing.designation
            and (not other.width or not width or abs(other.width - width) < _ROUNDING)
        )

        def rank(other: CatalogueBearing) -> tuple[bool, float, bool]:
            quick = other.designation.startswith(tuple(designation_data()["high_speed"]["names"]))
            of_skf = bool(design) and other.maker == _OF_SKF
            return quick != (design in _QUICK), off(other), not of_skf

        return tuple(sorted(alike, key=rank))

    def _unknown(self, text: str) -> InputError:
        other = other_type(parse_designation(text).name)
        if other:
            raise InputError(other, field="designation", value=text, example='designation = "6205"')
        near = ", ".join(self.nearest(text))
        return InputError(
            said("is in no catalogue; did you mean {near}?", near=near)
            if near
            else said("is in no catalogue"),
            field="designation",
            value=text,
            example='designation = "6205"',
        )

    def nearest(self, text: str) -> tuple[str, ...]:
        """Return up to three designations that are most like a text, two swapped signs first."""
        wanted = folded(text)
        swapped = [
            wanted[:i] + wanted[i + 1] + wanted[i] + wanted[i + 2 :] for i in range(len(wanted) - 1)
        ]
        alike = difflib.get_close_matches(wanted, self._places, n=_NEAREST, cutoff=0.6)
        keys = dict.fromkeys([*(key for key in swapped if key in self._places), *alike])
        return tuple(self._named(key).designation for key in list(keys)[:_NEAREST])


_asked: Final[ContextVar[Catalogue | None]] = ContextVar("_asked", default=None)


def catalogue() -> Catalogue:
    """Return the catalogue in which designations are looked up.

    The built-in one, and within `catalogues` the user's files beside it.
    """
    return _asked.get() or built_in_catalogue()


@contextmanager
def catalogues(paths: Iterable[str | os.PathLike[str]] | None = None) -> Iterator[Catalogue]:
    """Look up every designation in a user's files too, within a block.

    What is found there stays with the `rolamento.Bearing`, which may be read, changed, pickled and
    sent to other threads and processes after the block.

    Parameters
    ----------
    paths
        As of `Catalogue.beside`; with none of them nothing changes.

    Raises
    ------
    InputError
        If a file cannot be read, or is no catalogue; with the line.
    """
    added = tuple(paths or ())
    with _asking(catalogue().beside(added) if added else catalogue()) as known:
        yield known


@contextmanager
def listed(bearings: Sequence[CatalogueBearing]) -> Iterator[Catalogue]:
    """Look up every designation among some bearings too, within a block."""
    with _asking(_with(catalogue(), tuple(bearings)) if bearings else catalogue()) as known:
        yield known


def catalogue_with(bearings: Sequence[CatalogueBearing]) -> Catalogue:
    """Return the built-in catalogue with some bearings beside."""
    known = built_in_catalogue()
    return _with(known, tuple(bearings)) if bearings else known


def is_built_in(bearing: CatalogueBearing) -> bool:
    """Return whether a bearing is one of the built-in catalogue's."""
    return built_in_catalogue()._known(folded(bearing.designation)) is bearing


@contextmanager
def _asking(known: Catalogue) -> Iterator[Catalogue]:
    token = _asked.set(known)
    try:
        yield known
    finally:
        _asked.reset(token)


@lru_cache(maxsize=512)
def _found_in(known: Catalogue, text: str) -> Found:
    """Return what `Catalogue.find` finds; a case that is changed asks for its bearing each time."""
    return known._found(text)


@lru_cache(maxsize=64)
def _with(known: Catalogue, bearings: tuple[CatalogueBearing, ...]) -> Catalogue:
    return Catalogue((*known.bearings, *bearings))


@lru_cache(maxsize=1)
def built_in_catalogue() -> Catalogue:
    """Return the catalogue that comes with the package."""
    folder = resources.files("rolamento") / "data" / "catalogue"
    files = {file.name: file for file in folder.iterdir() if file.name.endswith(".csv")}
    own = OwnRecords({name: files[name].read_bytes().decode("utf-8") for name in sorted(files)})
    return Catalogue(own, each_folded(own.designations))


def _same_angle(bearing: CatalogueBearing, designation: Designation) -> bool:
    angle, wanted = bearing.contact_angle, designation.contact_angle
    return angle is not None and wanted is not None and abs(angle - wanted) < _ROUNDING
