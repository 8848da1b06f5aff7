"""A machine's own history: a record against those of its good days, and a folder of records."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import chain, pairwise
from math import exp, isfinite, nan
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, Literal

import numpy as np

from rolamento.case.case import BearingLike
from rolamento.errors import InputError, arguments
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.tasks.diagnosis import (
    SCHEMA,
    Concluded,
    Conclusion,
    DiagnosisResult,
    diagnose,
)
from rolamento.vibration.diagnosis import COMPONENTS, DAMAGE, Component, DiagnosisSettings
from rolamento.vibration.reading import read_signal
from rolamento.vibration.reading.formats import ENDINGS
from rolamento.vibration.signal import Signal
from rolamento.vibration.spectrum import indicators
from rolamento.words import Note, said
from rolamento.words.naming import of_element

if TYPE_CHECKING:
    from rolamento.document import Document

__all__ = ["History", "PartThen", "Records", "diagnose_since", "records_of", "trend_of_records"]

Change = Literal["grown", "as_always", "small", "unknown"]

_SIGNALS: Final = frozenset(chain.from_iterable(ENDINGS.values()))
_DOUBLED: Final = 2.0
"""Depth now over the greatest of the good days, from which on it is damage."""
_LEAST: Final = 0.5 * DAMAGE
"""Depth below which nothing is said to have grown: noise alone doubles it."""
_LIKE_SPEED: Final = 0.1
"""Part by which the speed of two records may differ for their depths to be compared."""
_NEAR: Final = 0.005
"""Fraction of a part's order, within which its depth is taken: the cage slips a little
otherwise."""
_MOST_RECORDS: Final = 20_000
_LEAST_TURNS: Final = 50.0
"""Revolutions from which on a record has a depth of its own; shorter ones are taken together."""
_GROUPED_TURNS: Final = 100.0


def records_of(paths: Sequence[str | os.PathLike[str]]) -> list[Path]:
    """Return the files that are named, and those of folders, in the order of their names.

    Raises
    ------
    InputError
        If a folder holds no signal.
    """
    found: list[Path] = []
    for path in map(Path, paths):
        if not path.is_dir():
            found.append(path)
            continue
        inside = sorted(
            (file for file in path.iterdir() if file.suffix.lower() in _SIGNALS), key=_natural
        )
        if not inside:
            rule = said("holds no signal file")
            raise InputError(rule, field=str(path), example="records/2026-01-31.wav")
        found += inside
    if len(found) > _MOST_RECORDS:
        raise InputError(
            said("must be at most {most} records", most=_MOST_RECORDS),
            field="records",
            value=len(found),
        )
    return found


def _natural(path: Path) -> tuple[tuple[int, str], ...]:
    """Order of names in which 2 comes before 10."""
    pieces = re.split(r"(\d+)", path.name)
    return tuple((int(piece), "") if piece.isdecimal() else (-1, piece) for piece in pieces)


# --- now and then --------------------------------------------------------------------------------


@frozen
class PartThen:
    """A part now, and in the records of the machine's good days.

    Attributes
    ----------
    component
        which part
    order
        at which its depth is compared
    now
        depth; NaN if the spectra do not reach the order
    then
        greatest depth of each record at like speed
    change
        "grown" where it doubled, "as_always", "small" where it has no peaks of its own now or
        they are too small to compare, "unknown" without a record at like speed
    """

    component: Component
    order: float
    now: float
    then: tuple[float, ...]
    change: Change

    @property
    def usual(self) -> float:
        """Greatest depth of the good days; NaN without any."""
        return max(self.then, default=nan)


@frozen(eq=False, slots=False)
class History(Concluded):
    """A diagnosis, and what the machine's own good days make of it.

    Attributes
    ----------
    now
        of the record in question
    baseline
        diagnoses of the good days, in order
    compared
        names of those at like speed
    parts
        each part now and then
    """

    now: DiagnosisResult
    baseline: tuple[DiagnosisResult, ...]
    compared: tuple[str, ...]
    parts: tuple[PartThen, ...]

    @property
    def grown(self) -> tuple[PartThen, ...]:
        """Parts whose depth doubled, the deepest first; what is undecided stays so."""
        verdicts = {part.component: part.verdict for part in self.now.diagnosis.components}
        some = [
            part
            for part in self.parts
            if part.change == "grown" and verdicts[part.component] != "undecided"
        ]
        return tuple(sorted(some, key=lambda part: -part.now))

    @property
    def always(self) -> tuple[PartThen, ...]:
        """Parts that the record alone would state, and that always had that depth."""
        named = {part.component for part in self.now.diagnosis.stated}
        return tuple(p for p in self.parts if p.change == "as_always" and p.component in named)

    @property
    def verdict(self) -> Conclusion:
        """What it comes to: damage where a depth doubled, watch where it was always there."""
        if self.now.too_short is not None:
            return self.now.verdict
        if self.grown:
            return "fault"
        faults = set(self.now.diagnosis.faults)
        if faults and faults <= {part.component for part in self.always}:
            return "watch"
        return self.now.verdict

    @property
    def statement(self) -> tuple[Note, ...]:
        """What it comes to, sentence by sentence."""
        if self.now.too_short is not None:
            return self.now.statement
        notes = [self._said("depth_grown", part) for part in self.grown]
        notes += [self._said("depth_as_always", part) for part in self.always]
        if not self.compared:
            notes.append(Note("no_like_speed", {"within": _LIKE_SPEED}))
        told = {part.component for part in (*self.grown, *self.always)}
        stated = {part.component for part in self.now.diagnosis.stated}
        if not told or stated - told:
            notes += self.now.statement
        return tuple(notes)

    def _said(self, key: str, part: PartThen) -> Note:
        values = {
            "part": part.component,
            "now": part.now,
            "then": part.usual,
            "records": len(part.then),
        }
        return of_element(Note(key, values), self.now.diagnosis.element)

    def page(self) -> Document:
        """Return what people read of it."""
        from rolamento.pages.history import history_page

        return history_page(self)

    def to_mapping(self) -> dict[str, Any]:
        """Return everything as plain data, in SI units and Hz."""
        return {
            **self._head("diagnosis_history"),
            "parts": [
                {
                    "component": part.component,
                    "order": part.order,
                    "now": part.now,
                    "then": list(part.then),
                    "change": part.change,
                }
                for part in self.parts
            ],
            "compared": list(self.compared),
            "now": self.now.to_mapping(),
            "baseline": [one.to_mapping() for one in self.baseline],
        }


def diagnose_since(
    path: str | os.PathLike[str],
    bearing: BearingLike,
    baseline: Sequence[str | os.PathLike[str]],
    **inputs: Any,
) -> History:
    """Diagnose a record beside records of the same machine in good order.

    Parameters
    ----------
    path, bearing, inputs
        As of `rolamento.tasks.diagnose`; what is inputs holds for all records.
    baseline
        Files, or folders of them, of the same place on the machine.

    Raises
    ------
    FileError, InputError
        As of `rolamento.tasks.diagnose`, or if there is no record.
    """
    now = diagnose(path, bearing, **inputs)
    if now.too_short is not None:
        return History(now, (), (), ())
    files = records_of(baseline)
    if not files:
        raise InputError(
            said("must name at least one record"),
            field="baseline",
            example=arguments(baseline=["good.wav"]),
        )
    alike = {key: value for key, value in inputs.items() if key != "progress"}
    found = [(file, diagnose(file, bearing, **alike)) for file in files]
    then = [(file, one) for file, one in found if one.too_short is None]
    speed = now.diagnosis.shaft_frequency
    like = [
        (file, one)
        for file, one in then
        if abs(one.diagnosis.shaft_frequency / speed - 1.0) <= _LIKE_SPEED
    ]
    parts = tuple(
        _then(part.component, now, [one for _, one in like])
        for part in now.diagnosis.components
        if part.nominal_order > 0.0
    )
    names = tuple(file.name for file, _ in like)
    return History(now, tuple(one for _, one in then), names, parts)


def _then(component: Component, now: DiagnosisResult, like: list[DiagnosisResult]) -> PartThen:
    """Compare a part with the good days, at its own order where it has one."""
    own = now.diagnosis.of(component)
    order = own.order if isfinite(own.order) else own.nominal_order
    within = _NEAR if isfinite(own.order) else now.diagnosis.tolerance
    depth = own.depth if isfinite(own.order) else _depth(now, order, within)
    # the cage may have slipped otherwise: of the good days the deepest of all that slip allows
    usual = tuple(
        float(
            np.fmax(
                _depth(one, order, within),
                one.diagnosis.of(component).depth,
            )
        )
        for one in like
    )
    known = [value for value in usual if isfinite(value)]
    change = _change(depth, known) if isfinite(own.order) else "small"
    return PartThen(component, order, depth, tuple(known), change if known else "unknown")


def _depth(one: DiagnosisResult, order: float, within: float) -> float:
    return one.diagnosis.spectra.depth_about(order, within)


def _change(now: float, then: Sequence[float]) -> Change:
    if now >= max(_LEAST, _DOUBLED * max(then, default=nan)):
        return "grown"
    return "as_always" if now >= _LEAST else "small"


# --- a folder of records -------------------------------------------------------------------------


@frozen
class Step:
    """Where a series of values changes its level.

    Attributes
    ----------
    place
        the first value of the new level, counted from 0
    before, after
        medians
    probability
        that a series without a change has one as clear
    """

    place: int
    before: float
    after: float
    probability: float


@frozen(eq=False)
class Records:
    """Many records of one machine, one after the other.

    Attributes
    ----------
    names
        (groups,), of the first record of each group; a group is one record if that is long
        enough, and else as many as make 100 revolutions
    counts
        (groups,), records in each
    rms, kurtosis
        (groups,); rms in `unit`
    depths
        (groups,) for each part; NaN where the record allows none
    unit
        of the samples
    last
        diagnosis of the last group; None if it is too short
    title
        of the folder, or of the first record
    """

    names: tuple[str, ...]
    counts: tuple[int, ...]
    rms: FloatArray
    kurtosis: FloatArray
    depths: dict[Component, FloatArray]
    unit: str
    last: DiagnosisResult | None
    title: str = ""

    @property
    def series(self) -> dict[str, FloatArray]:
        """All series by name."""
        depths: dict[str, FloatArray] = {str(part): one for part, one in self.depths.items()}
        return {"rms": self.rms, "kurtosis": self.kurtosis, **depths}

    @property
    def steps(self) -> dict[str, tuple[Step, ...]]:
        """Change points of each series, in order."""
        return {name: change_points(values) for name, values in self.series.items()}

    @property
    def statement(self) -> tuple[Note, ...]:
        """What the records come to: what changed, where, and the last diagnosis."""
        notes = []
        for name, steps in self.steps.items():
            for step in steps[-1:]:
                values = {
                    "series": name,
                    "record": self.names[step.place],
                    "before": step.before,
                    "after": step.after,
                    "probability": step.probability,
                }
                notes.append(Note("series_changed", values))
        if not notes:
            notes.append(Note("nothing_changed", {"records": sum(self.counts)}))
        if self.last is not None:
            notes += [Note("last_record"), *self.last.statement]
        return tuple(notes)

    @property
    def complaint(self) -> str:
        """Nothing: what was measured is shown in any case."""
        return ""

    def page(self) -> Document:
        """Return what people read of it."""
        from rolamento.pages.history import records_page

        return records_page(self, self.title)

    def to_mapping(self) -> dict[str, Any]:
        """Return everything as plain data."""
        return {
            "schema": SCHEMA,
            "kind": "diagnosis_records",
            "names": list(self.names),
            "counts": list(self.counts),
            "unit": self.unit,
            "series": {name: values.tolist() for name, values in self.series.items()},
            "changes": {
                name: [
                    {
                        "record": self.names[step.place],
                        "before": step.before,
                        "after": step.after,
                        "probability": step.probability,
                    }
                    for step in steps
                ]
                for name, steps in self.steps.items()
            },
            "statement": [note.to_mapping() for note in self.statement],
            "last": None if self.last is None else self.last.to_mapping(),
        }


_CERTAIN: Final = 0.01
_SHORTEST: Final = 5
"""Values of a level, at least."""


def change_points(values: FloatArray) -> tuple[Step, ...]:
    """Find where a series changes its level, by ranks (Pettitt, Applied Statistics 28 (1979)).

    With U_t the sum of the signs of all differences between values up to t and those after, and K
    its greatest size, p ≈ 2 exp(-6 K²/(n³ + n²)) (his equation 4.1). Each side of a change is
    looked at again; values that are NaN are passed over.

    Parameters
    ----------
    values
        (n,), in order of time.
    """
    places = np.flatnonzero(np.isfinite(values))
    found: list[tuple[int, float]] = []
    left = [(0, len(places))]
    while left:
        first, end = left.pop()
        some = values[places[first:end]]
        if len(some) < 2 * _SHORTEST:
            continue
        at, probability = _pettitt(some)
        if probability <= _CERTAIN and _SHORTEST <= at <= len(some) - _SHORTEST:
            found.append((first + at, probability))
            left += [(first, first + at), (first + at, end)]
    found.sort()
    edges = [0, *(at for at, _ in found), len(places)]
    medians = [float(np.median(values[places[a:b]])) if b > a else nan for a, b in pairwise(edges)]
    return tuple(
        Step(int(places[at]), before, after, probability)
        for (at, probability), (before, after) in zip(found, pairwise(medians), strict=True)
    )


def _pettitt(values: FloatArray) -> tuple[int, float]:
    """Place of the most likely change, and the probability that there is none."""
    count = len(values)
    ranks = np.argsort(np.argsort(values, kind="stable"), kind="stable") + 1.0
    sums = 2.0 * np.cumsum(ranks) - np.arange(1, count + 1) * (count + 1.0)
    at = int(np.argmax(np.abs(sums[:-1])))
    size = float(abs(sums[at]))
    return at + 1, min(1.0, 2.0 * exp(-6.0 * size**2 / (count**3 + count**2)))


def trend_of_records(
    paths: Sequence[str | os.PathLike[str]], bearing: BearingLike, **inputs: Any
) -> Records:
    """Follow depth, RMS and kurtosis over many records of one machine.

    Parameters
    ----------
    paths
        Files, or folders of them; in the order of their names, 2 before 10.
    bearing, inputs
        As of `rolamento.tasks.diagnose`. Short records, such as of 0.1 s, need one speed for all:
        those that follow each other are joined, each a block of the spectra, which are averaged.

    Raises
    ------
    FileError, InputError
        As of `rolamento.tasks.diagnose`, or if there is no record.
    """
    files = records_of(paths)
    if not files:
        raise InputError(said("must name at least one record"), field="records")
    reading = {key: inputs[key] for key in _READING if key in inputs}
    search = inputs.pop("search", None) or DiagnosisSettings()
    inputs = {key: value for key, value in inputs.items() if key not in ("progress", *_READING)}
    names, counts, rms, kurtosis, found = [], [], [], [], []
    unit, place = "", 0
    while place < len(files):
        group = [read_signal(files[place], **reading)]
        turns = _turns(group[0], inputs)
        if turns < _LEAST_TURNS:
            alike = files[place + 1 : place + int(_GROUPED_TURNS / max(turns, 1e-9)) + 1]
            for file in alike:
                more = read_signal(file, **reading)
                if more.rate != group[0].rate or len(more.samples) != len(group[0].samples):
                    break
                group.append(more)
        joined = replace(group[0], samples=np.concatenate([one.samples for one in group]))
        settings = search
        if len(group) > 1:
            settings = replace(search, block_revolutions=max(2.0, turns), speed_tolerance=0.0)
        sizes = [indicators(one) for one in group]
        one = diagnose(joined, bearing, search=settings, **inputs)
        names.append(files[place].name)
        counts.append(len(group))
        rms.append(float(np.sqrt(np.mean([size.rms**2 for size in sizes]))))
        kurtosis.append(float(np.mean([size.kurtosis for size in sizes])))
        found.append(one if one.too_short is None else None)
        unit, place = joined.unit, place + len(group)
    depths = {part: np.array([_depth_of(one, part) for one in found]) for part in COMPONENTS}
    return Records(
        tuple(names), tuple(counts), np.array(rms), np.array(kurtosis), depths, unit, found[-1],
        os.fspath(paths[0]),
    )  # fmt: skip


_READING: Final = ("channel", "rate", "unit", "scale", "decimal_mark")


def _turns(signal: Signal, inputs: dict[str, Any]) -> float:
    """Revolutions of a record, by the speed that is given or in it; many if nobody knows."""
    from rolamento.tasks.parameters import speed_of

    given = speed_of(inputs.get("speed"), "speed")
    speed = signal.mean_speed if given is None else given
    if not isfinite(speed) or speed == 0.0:
        return 2.0 * _LEAST_TURNS
    return abs(speed) * signal.duration / (2.0 * np.pi)


def _depth_of(one: DiagnosisResult | None, part: Component) -> float:
    """Depth of a part where it has peaks, or the deepest that its window holds.

    NaN of a part that could not be tested, as of records so short that multiples of the shaft hide
    its window.
    """
    if one is None:
        return nan
    own = one.diagnosis.of(part)
    if own.verdict == "not_tested":
        return nan
    if isfinite(own.depth):
        return own.depth
    return _depth(one, own.nominal_order, one.diagnosis.tolerance)
