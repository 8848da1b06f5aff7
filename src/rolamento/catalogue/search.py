"""Catalogues: the built-in one, a user's beside it; search as one types, look up a designation."""

from __future__ import annotations

import difflib
import os
import re
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field, replace
from functools import lru_cache
from importlib import resources
from itertools import chain, islice
from typing import Final

from rolamento._reading import read_text
from rolamento._tables import table_text
from rolamento.catalogue.designation import (
    Designation,
    folded,
    other_type,
    parse_designation,
    suffix_groups,
)
from rolamento.catalogue.records import CatalogueBearing, records_of_csv, records_of_toml
from rolamento.errors import FileError, InputError
from rolamento.words import said

_MOST_RESULTS: Final = 1000
_NEAREST: Final = 3
_BOUNDARY: Final = ("bore", "outside_diameter", "width")
_SIZES: Final = re.compile(r"\d+(?:\.\d+)?(?:[x×]\d+(?:\.\d+)?){1,2}")
_ISO_15: Final = "ISO 15, dimension series of {}"
_ROUNDING: Final = 1e-6


@dataclass(frozen=True, slots=True)
class Found:
    """A bearing of a catalogue, and what the designation says beyond its number."""

    bearing: CatalogueBearing
    designation: Designation


@dataclass(frozen=True, slots=True, eq=False)
class Catalogue:
    """Bearings by their designation; later ones take the place of earlier ones.

    Parameters
    ----------
    bearings
        The records.
    """

    bearings: tuple[CatalogueBearing, ...]
    _by_key: dict[str, CatalogueBearing] = field(init=False, repr=False, compare=False)
    _with_maker: tuple[str, ...] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        by_key = {folded(bearing.designation): bearing for bearing in self.bearings}
        makers = {bearing.maker: folded(bearing.maker) for bearing in self.bearings}
        with_maker = tuple(makers[bearing.maker] + key for key, bearing in by_key.items())
        object.__setattr__(self, "_by_key", by_key)
        object.__setattr__(self, "_with_maker", with_maker)

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
        keyed = self._by_key.items()
        first = (bearing for key, bearing in keyed if key.startswith(wanted))
        rest = (
            bearing
            for (key, bearing), name in zip(keyed, self._with_maker, strict=True)
            if wanted in name and not key.startswith(wanted)
        )
        return tuple(islice(chain(first, rest), most))

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
        own = self._by_key.get(folded(text))
        if own is not None:
            return self._own(own, text)
        designation = parse_designation(text)
        named = self._by_shorter_name(designation)
        if named is not None:
            return Found(named, replace(designation, contact_angle=named.contact_angle))
        for key in designation.keys:
            if key in self._by_key:
                return Found(self._by_key[key], designation)
        plain = self._by_key.get(folded(designation.number))
        if plain is not None and _same_angle(plain, designation):
            return Found(plain, designation)
        for number in designation.equivalents:
            like = self._by_key.get(folded(number))
            if like is not None and (
                designation.contact_angle is None or _same_angle(like, designation)
            ):
                return Found(like, designation)
        by_sizes = self._of_dimension_series(designation)
        if by_sizes is not None:
            return Found(by_sizes, designation)
        raise self._unknown(text)

    def _own(self, bearing: CatalogueBearing, text: str) -> Found:
        """A bearing that is listed by that very text: its letters need not mean what others do."""
        plain = Designation(text=text.strip(), name=text.strip())
        if folded(text).isdecimal():
            plain = parse_designation(text)
        return Found(bearing, replace(plain, contact_angle=bearing.contact_angle))

    def _by_shorter_name(self, designation: Designation) -> CatalogueBearing | None:
        """The bearing whose whole name stands before the last suffixes, as ``Q-17`` in Q-17/C3.

        A plain number is none: its letters may tell another contact angle.
        """
        groups = suffix_groups(designation.name)
        for count in range(len(groups) - 1, 0, -1):
            key = folded("".join(groups[:count]))
            found = self._by_key.get(key)
            if found is None or key == folded(designation.number):
                continue
            if designation.number or designation.contact_angle is None:
                return found
            if _same_angle(found, designation):
                return found
        return None

    def _of_sizes(self, sizes: list[float]) -> tuple[CatalogueBearing, ...]:
        bore, outside, *width = sizes
        return tuple(
            bearing
            for bearing in self._by_key.values()
            if abs(bearing.bore - bore) < _ROUNDING
            and abs(bearing.outside_diameter - outside) < _ROUNDING
            and all(bearing.width and abs(bearing.width - size) < _ROUNDING for size in width)
        )

    def _of_dimension_series(self, designation: Designation) -> CatalogueBearing | None:
        if not designation.number or designation.kind:
            return None
        number = designation.dimension_series + designation.number[-2:]
        like = self._by_key.get(folded(number))
        if like is None:
            return None
        source = _ISO_15.format(like.designation)
        angular = designation.is_angular_contact
        return CatalogueBearing(
            designation=min(designation.keys, key=len).upper(),
            kind="angular_contact" if angular else "deep_groove",
            bore=like.bore,
            outside_diameter=like.outside_diameter,
            width=like.width,
            contact_angle=designation.contact_angle,
            sources=dict.fromkeys(_BOUNDARY, source)
            | ({"contact_angle": "designation letters"} if designation.contact_angle else {}),
        )

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
        alike = difflib.get_close_matches(wanted, self._by_key, n=_NEAREST, cutoff=0.6)
        keys = dict.fromkeys([*(key for key in swapped if key in self._by_key), *alike])
        return tuple(self._by_key[key].designation for key in list(keys)[:_NEAREST])


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
    """Tell whether a bearing is one of the built-in catalogue's."""
    return built_in_catalogue()._by_key.get(folded(bearing.designation)) is bearing


@contextmanager
def _asking(known: Catalogue) -> Iterator[Catalogue]:
    token = _asked.set(known)
    try:
        yield known
    finally:
        _asked.reset(token)


@lru_cache(maxsize=64)
def _with(known: Catalogue, bearings: tuple[CatalogueBearing, ...]) -> Catalogue:
    return Catalogue((*known.bearings, *bearings))


@lru_cache(maxsize=1)
def built_in_catalogue() -> Catalogue:
    """Return the catalogue that comes with the package."""
    folder = resources.files("rolamento") / "data" / "catalogue"
    files = sorted(
        (file for file in folder.iterdir() if file.name.endswith(".csv")), key=lambda f: f.name
    )
    found = [records_of_csv(file.read_text(encoding="utf-8"), file.name) for file in files]
    return Catalogue(tuple(bearing for bearings in found for bearing in bearings))


def _same_angle(bearing: CatalogueBearing, designation: Designation) -> bool:
    angle, wanted = bearing.contact_angle, designation.contact_angle
    return angle is not None and wanted is not None and abs(angle - wanted) < _ROUNDING
