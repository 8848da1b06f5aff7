"""What a life test brings: how long each bearing ran, and whether it failed.

A bearing that did not fail is *suspended*: it ran so long and would have run on. Where failures
are only found at inspections, a failure lies between the last inspection that it passed (`lower`)
and the one that found it (`times`). Bearings that stop together because one of them failed share a
`rig`: the test of a rig ends with its first failure (sudden death).

Times have no unit of their own but a label that goes with every result.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final, Literal

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.numerics import BoolArray, FloatArray
from rolamento.weibull import _columns as columns
from rolamento.weibull._columns import IntArray, TextArray

__all__ = ["LifeTest", "Scheme"]

MOST_GROUPS: Final = 1000

Scheme = Literal["complete", "type_ii", "sudden_death", "type_i", "multiple", "interval"]


@dataclass(frozen=True, slots=True, eq=False, init=False)
class LifeTest:
    """Lives of a test, one row a bearing or so many alike.

    Attributes
    ----------
    times
        (rows,) at which a bearing failed, was found to have failed, or was suspended; above zero
    failed
        (rows,) whether it failed
    lower
        (rows,) time of the last inspection that a failed bearing passed, 0 where there was none;
        NaN where the time of failure itself is known, and for suspended bearings
    counts
        (rows,) how many bearings the row stands for
    group
        (rows,) label of the group, such as a lot or a condition; empty without
    rig
        (rows,) label of bearings whose test ended together, at the first failure; empty without
    unit
        label of the times: "h", "Mrev" (millions of revolutions), "rev"
    title, source
        what the data are, and where they come from
    passed_over
        columns of their file that were not read, as nobody knows what they are

    Raises
    ------
    InputError
        If arrays differ in length, are too long, or hold what cannot be.
    """

    times: FloatArray
    failed: BoolArray
    lower: FloatArray
    counts: IntArray
    group: TextArray
    rig: TextArray
    unit: str
    title: str
    source: str
    passed_over: tuple[str, ...]

    def __init__(
        self,
        times: ArrayLike,
        failed: ArrayLike = True,
        *,
        lower: ArrayLike | None = None,
        counts: ArrayLike = 1,
        group: ArrayLike = "",
        rig: ArrayLike = "",
        unit: str = "h",
        title: str = "",
        source: str = "",
        passed_over: Sequence[str] = (),
    ) -> None:
        t = columns.numbers(times, "times")
        rows = len(t)
        put: dict[str, Any] = {
            "times": t,
            "failed": columns.flags(failed, rows),
            "lower": columns.numbers(np.nan if lower is None else lower, "lower", rows),
            "counts": columns.counts(counts, rows),
            "group": columns.labels(group, "group", rows),
            "rig": columns.labels(rig, "rig", rows),
            "unit": columns.label(unit, "unit") or "h",
            "title": str(title),
            "source": str(source),
            "passed_over": tuple(passed_over),
        }
        columns.check_times(t, put["failed"], put["lower"])
        columns.check_rigs(t, put["failed"], put["lower"], put["counts"], put["rig"])
        for name, value in put.items():
            if isinstance(value, np.ndarray):
                value.setflags(write=False)
            object.__setattr__(self, name, value)

    @classmethod
    def sudden_death(
        cls,
        times: ArrayLike,
        size: ArrayLike,
        *,
        failed: ArrayLike = True,
        group: ArrayLike = "",
        unit: str = "h",
        title: str = "",
        source: str = "",
    ) -> LifeTest:
        """Test of rigs that each ran until their first failure.

        Parameters
        ----------
        times
            At which each rig stopped.
        size
            Bearings in each rig; the others are suspended when the first fails.
        failed
            Whether it stopped for a failure; otherwise all its bearings are suspended.
        group, unit, title, source
            As of `LifeTest`; the group of each rig.
        """
        ends = columns.numbers(times, "times")
        sizes = columns.counts(size, len(ends), "size")
        fails = columns.flags(failed, len(ends))
        rest = sizes - fails
        rows = np.concatenate([np.flatnonzero(fails), np.flatnonzero(rest)])
        first = np.arange(len(rows)) < np.count_nonzero(fails)
        order = np.argsort(rows, kind="stable")
        rows, first = rows[order], first[order]
        return cls(
            ends[rows],
            first,
            counts=np.where(first, 1, rest[rows]),
            group=columns.labels(group, "group", len(ends))[rows],
            rig=[f"rig {row + 1}" for row in rows],
            unit=unit,
            title=title,
            source=source,
        )

    def __len__(self) -> int:
        """Count the rows."""
        return len(self.times)

    @property
    def size(self) -> int:
        """How many bearings were tested."""
        return int(self.counts.sum())

    @property
    def failures(self) -> int:
        """How many of them failed."""
        return int(self.counts[self.failed].sum())

    @property
    def suspensions(self) -> int:
        """How many of them did not."""
        return self.size - self.failures

    @property
    def inspected(self) -> bool:
        """Whether any failure is only known to lie between two inspections."""
        return bool(np.any(~np.isnan(self.lower)))

    @property
    def total_time(self) -> float:
        """Sum of all times, of failed and suspended bearings."""
        return float(np.sum(self.counts * self.times))

    @property
    def scheme(self) -> Scheme:
        """How the test ended.

        "complete": all failed. "type_ii": stopped for all at the last failure. "sudden_death":
        each rig stopped at its first failure. "type_i": stopped for all at one time after the last
        failure. "multiple": suspended at several times. "interval": failures found at inspections.
        """
        if self.inspected:
            return "interval"
        if not self.suspensions:
            return "complete"
        if np.any(self.rig != ""):
            return "sudden_death" if self._rigs_all_failed() else "multiple"
        ends = np.unique(self.times[~self.failed])
        last = self.times[self.failed].max(initial=0.0)
        if len(ends) > 1 or ends[0] < last:
            return "multiple"
        return "type_ii" if ends[0] == last else "type_i"

    def select(self, rows: ArrayLike) -> LifeTest:
        """Return some of the rows, by a mask or by their numbers."""
        which = np.asarray(rows)
        if which.dtype != np.bool_:
            which = which.astype(np.int64)
        if which.ndim != 1 or (which.dtype == np.bool_ and len(which) != len(self)):
            raise InputError("must be a mask, one entry a row, or a list of numbers", field="rows")
        return LifeTest(
            self.times[which],
            self.failed[which],
            lower=self.lower[which],
            counts=self.counts[which],
            group=self.group[which],
            rig=self.rig[which],
            unit=self.unit,
            title=self.title,
            source=self.source,
            passed_over=self.passed_over,
        )

    def by_group(self) -> dict[str, LifeTest]:
        """Part the test by its groups, in the order in which they appear."""
        names = dict.fromkeys(str(name) for name in self.group)
        if len(names) > MOST_GROUPS:
            raise InputError(f"has more than {MOST_GROUPS} groups", field="group")
        return {name: self.select(self.group == name) for name in names}

    def _rigs_all_failed(self) -> bool:
        """Tell whether every suspended bearing was suspended by a failure in its rig."""
        stopped = set(self.rig[self.failed])
        return all(name != "" and name in stopped for name in self.rig[~self.failed])
