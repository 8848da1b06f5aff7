"""What a life test brings: how long each bearing ran, and whether it failed.

A bearing that did not fail is *suspended*: it ran so long and would have run on. Where failures
are only found at inspections, a failure lies between the last inspection that it passed (`lower`)
and the one that found it (`times`). Bearings that stop together because one of them failed share a
`rig`: the test of a rig ends with its first failure (sudden death).

Bearings fail by several *modes* (fatigue, mounting damage, lubrication), of which the first to
come ends the life. To each mode a failure by another one is a suspension: `for_mode`.

Times have no unit of their own but a label that goes with every result.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.errors import InputError
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.validate import numbers
from rolamento.words import Note, marked, said
from rolamento.words.naming import one_line, shortened

Scheme = Literal["complete", "type_ii", "sudden_death", "type_i", "multiple", "interval"]
TextArray = NDArray[np.str_]
IntArray = NDArray[np.int64]

MAXIMUM_ROWS: Final = 100_000
MAXIMUM_UNITS: Final = 1_000_000
MAXIMUM_GROUPS: Final = 1000
LONGEST_LABEL: Final = 60
_LONGEST_TITLE: Final = 30
_EXAMPLE: Final = "[120.5, 88.0, 300.0]"
_FLAGS: Final = "[True, False, True]"
BLANK_GROUP: Final = marked("(blank)")
"""Name of the bearings whose group is not given, beside others that have one."""
UNKNOWN_MODE: Final = marked("unknown mode")
"""Name of the failures whose mode is not given, beside others that have one."""
MINIMUM_TIME: Final = 1e-30
MAXIMUM_TIME: Final = 1e30


@frozen(eq=False, init=False)
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
    mode
        (rows,) label of the mode by which a bearing failed; empty where it is not known, and for
        suspended bearings
    unit
        label of the times: "h", "Mrev" (millions of revolutions), "rev"
    title, source
        what the data are, and where they come from
    passed_over
        columns of their file that were not read, as their meaning is unknown
    machines
        the column of machines in their file, if it was not read as rigs; empty without
    remarks
        what else is to be known of how they were read

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
    mode: TextArray
    unit: str
    title: str
    source: str
    passed_over: tuple[str, ...]
    machines: str
    remarks: tuple[Note, ...]

    def __init__(
        self,
        times: ArrayLike,
        failed: ArrayLike = True,
        *,
        lower: ArrayLike | None = None,
        counts: ArrayLike = 1,
        group: ArrayLike = "",
        rig: ArrayLike = "",
        mode: ArrayLike = "",
        unit: str = "h",
        title: str = "",
        source: str = "",
        passed_over: Sequence[str] = (),
        machines: str = "",
        remarks: Sequence[Note] = (),
    ) -> None:
        t = _times_of(times)
        rows = len(t)
        put: dict[str, Any] = {
            "times": t,
            "failed": _flags_of(failed, rows),
            "lower": _spread(
                np.array(numbers(np.nan if lower is None else lower, "lower", "[100.0]")),
                "lower",
                rows,
            ),
            "counts": _counts_of(counts, rows),
            "group": _labels_of(group, "group", rows),
            "rig": _labels_of(rig, "rig", rows),
            "mode": _labels_of(mode, "mode", rows),
            "unit": _label_of(unit, "unit") or "h",
            "title": str(title),
            "source": str(source),
            "passed_over": tuple(passed_over),
            "machines": machines,
            "remarks": tuple(remarks),
        }
        put["mode"] = np.where(put["failed"], put["mode"], "")
        _check_times(t, put["failed"], put["lower"])
        _check_rigs(t, put["failed"], put["lower"], put["counts"], put["rig"])
        for name, value in put.items():
            if isinstance(value, np.ndarray):
                value.setflags(write=False)
            object.__setattr__(self, name, value)

    @classmethod
    def of(cls, test: LifeTest | ArrayLike) -> LifeTest:
        """Return a test as it is, and times alone as a test in which all bearings failed."""
        return test if isinstance(test, LifeTest) else cls(test)

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
        ends = _times_of(times)
        sizes = _counts_of(size, len(ends), "size")
        fails = _flags_of(failed, len(ends))
        rest = sizes - fails
        rows = np.concatenate([np.flatnonzero(fails), np.flatnonzero(rest)])
        first = np.arange(len(rows)) < np.count_nonzero(fails)
        order = np.argsort(rows, kind="stable")
        rows, first = rows[order], first[order]
        return cls(
            ends[rows],
            first,
            counts=np.where(first, 1, rest[rows]),
            group=_labels_of(group, "group", len(ends))[rows],
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
        """Number of bearings tested."""
        return int(self.counts.sum())

    @property
    def failures(self) -> int:
        """Number of failures."""
        return int(self.counts[self.failed].sum())

    @property
    def suspensions(self) -> int:
        """Number of suspensions."""
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
    def notes(self) -> tuple[Note, ...]:
        """What of their file was not read."""
        found = passed_over_notes(self.passed_over)
        if self.machines:
            found += (Note("machines_not_rigs", {"column": _shown(self.machines)}),)
        return (*self.remarks, *found)

    @property
    def modes(self) -> tuple[str, ...]:
        """Modes by which bearings failed, in the order of the data; "" for unknown, the last.

        Empty where the mode of no failure is given.
        """
        names = dict.fromkeys(str(name) for name in self.mode[self.failed])
        unknown = [""] if "" in names else []
        known = [name for name in names if name]
        return (*known, *unknown) if known else ()

    @property
    def unknown_modes(self) -> int:
        """Number of failures whose mode is not given, where that of others is."""
        return int(self.counts[self.failed & (self.mode == "")].sum()) if self.modes else 0

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
        which = _entries(rows, "rows", "[0, 2]")
        mask = which.dtype == np.bool_
        inside = mask or (
            which.dtype.kind in "iu" and np.all((-len(self) <= which) & (which < len(self)))
        )
        if which.ndim != 1 or not inside or (mask and len(which) != len(self)):
            raise InputError(
                said("must be a mask, one entry per row, or row numbers"),
                field="rows",
                example="[0, 2]",
            )
        return self._with(
            times=self.times[which],
            failed=self.failed[which],
            lower=self.lower[which],
            counts=self.counts[which],
            group=self.group[which],
            rig=self.rig[which],
            mode=self.mode[which],
        )

    def _with(self, **changed: Any) -> LifeTest:
        """Return the test with other rows."""
        names = (
            "times", "failed", "lower", "counts", "group", "rig", "mode", "unit", "title",
            "source", "passed_over", "machines", "remarks",
        )  # fmt: skip
        return LifeTest(**{name: changed.get(name, getattr(self, name)) for name in names})

    def for_mode(self, name: str, *, or_unknown: bool = False) -> LifeTest:
        """Return the test as one of a single mode, to which all others are suspensions.

        A failure by another mode is suspended when it failed; if it was found at an inspection,
        at the last one that it passed, as that is how long it is known to have run.

        Parameters
        ----------
        name
            Of the mode, as in `modes`; "" for the failures whose mode is unknown.
        or_unknown
            Whether these count as failures by the mode.

        Raises
        ------
        InputError
            If no bearing failed by that mode.
        """
        known = self.modes
        if name not in known:
            there = ", ".join(mode or said(UNKNOWN_MODE) for mode in known)
            rule = (
                said("is not a failure mode of the data; the modes are {there}", there=there)
                if there
                else said("is not a failure mode of the data, which have none")
            )
            raise InputError(rule, field="only_mode", value=name)
        mine = self.failed & ((self.mode == name) | (or_unknown & (self.mode == "")))
        seen = self.failed & ~mine & ~np.isnan(self.lower)
        times = np.where(seen, self.lower, self.times)
        ran = times > 0.0  # one that was never seen to run says nothing of the others
        changed = {"times": times, "failed": mine, "lower": np.where(mine, self.lower, np.nan)}
        rows = {name: value[ran] for name, value in changed.items()}
        kept = {name: getattr(self, name)[ran] for name in ("counts", "group", "rig")}
        return self._with(**rows, **kept, mode="")

    def noted(self, *notes: Note) -> LifeTest:
        """Return the test with more to be known of how it was read."""
        return self._with(remarks=(*self.remarks, *notes))

    def by_mode(self) -> dict[str, LifeTest]:
        """Return the test of each mode, by its name, in the order of `modes`."""
        return {name or said(UNKNOWN_MODE): self.for_mode(name) for name in self.modes}

    def by_group(self) -> dict[str, LifeTest]:
        """Part the test by its groups, in the order in which they appear."""
        names = dict.fromkeys(str(name) for name in self.group)
        if len(names) > MAXIMUM_GROUPS:
            raise InputError(
                said("has more than {most} groups", most=MAXIMUM_GROUPS), field="group"
            )
        return {
            name or (said(BLANK_GROUP) if len(names) > 1 else ""): self.select(self.group == name)
            for name in names
        }

    def _rigs_all_failed(self) -> bool:
        """Return whether every suspended bearing was suspended by a failure in its rig."""
        stopped = set(self.rig[self.failed])
        return all(name != "" and name in stopped for name in self.rig[~self.failed])


def passed_over_notes(titles: Sequence[str]) -> tuple[Note, ...]:
    """Return the note that names columns of a file that were not read; none if there are none."""
    columns = [_shown(title) for title in titles if title.strip()]
    return (Note("passed_over_columns", {"columns": columns}),) if columns else ()


def _shown(title: str) -> str:
    return shortened(one_line(title), _LONGEST_TITLE)


# --- what a caller gives ---------------------------------------------------------------------


def _times_of(values: ArrayLike) -> FloatArray:
    """Return times, one a row."""
    array = np.array(numbers(values, "times", _EXAMPLE))  # a copy: the caller's may change
    if array.ndim != 1 or not 1 <= len(array) <= MAXIMUM_ROWS:
        raise InputError(
            said("must be a list of 1 to {most} numbers", most=MAXIMUM_ROWS),
            field="times",
            example=_EXAMPLE,
        )
    return array


def _flags_of(values: ArrayLike, rows: int) -> BoolArray:
    """Return true or false, one a row."""
    array = _entries(values, "failed", _FLAGS)
    if array.dtype != np.bool_ and not (
        array.dtype.kind in "iuf" and np.all((array == 0) | (array == 1))
    ):
        raise InputError(said("must be true or false, one per row"), field="failed", example=_FLAGS)
    return _spread(array.astype(np.bool_), "failed", rows)


def _counts_of(values: ArrayLike, rows: int, field: str = "counts") -> IntArray:
    """Return whole numbers above zero, one a row."""
    array = numbers(values, field, "[1, 1, 4]")
    bad = ~((array >= 1.0) & (array <= MAXIMUM_UNITS) & (array == np.floor(array)))
    if np.any(bad):
        raise InputError(
            said("must be integers from 1 to {most}", most=MAXIMUM_UNITS),
            field=field,
            value=float(array[bad].flat[0]),
            example="[1, 1, 4]",
        )
    counts = _spread(array, field, rows).astype(np.int64)
    if counts.sum() > MAXIMUM_UNITS:
        raise InputError(
            said("must be at most {most} bearings in total", most=MAXIMUM_UNITS),
            field=field,
        )
    return counts


def _labels_of(values: ArrayLike, field: str, rows: int) -> TextArray:
    """Return short texts, one a row."""
    array = _entries(values, field, '["lot A", "lot B"]')
    if array.size == 0:
        array = np.array([], dtype=np.str_)
    texts = np.array([_label_of(v, field) for v in array.ravel().tolist()], dtype=np.str_)
    return _spread(texts.reshape(array.shape), field, rows)


def _label_of(value: object, field: str) -> str:
    """Return a short text."""
    text = str(value).strip()
    if len(text) > LONGEST_LABEL or not text.isprintable():
        raise InputError(
            said("must be one line of at most {most} characters", most=LONGEST_LABEL),
            field=field,
            value=text,
        )
    return text


def _entries(values: ArrayLike, field: str, example: str) -> NDArray[Any]:
    """Return what is one a row, or one for all of them; no table, and nothing ragged."""
    try:
        array = np.array(values)
    except ValueError:  # lists in lists of several lengths
        array = np.array(None)
    if hasattr(values, "columns") or array.ndim > 1 or (array.ndim == 0 and array[()] is None):
        raise InputError(said("must be a list, one entry per row"), field=field, example=example)
    return array


def _spread(array: NDArray[Any], field: str, rows: int) -> NDArray[Any]:
    """Give one value to all rows, or check that there is one for each."""
    if array.ndim == 0:
        return np.full(rows, array[()])
    if array.shape != (rows,):
        raise InputError(
            said("must be as long as the times, {rows}", rows=rows),
            field=field,
            value=array.shape,
        )
    return array


def _check_times(times: FloatArray, failed: BoolArray, lower: FloatArray) -> None:
    """Refuse times that cannot be, and inspections that do not precede their failure."""
    bad = ~((times >= MINIMUM_TIME) & (times <= MAXIMUM_TIME))
    if np.any(bad):
        raise InputError(
            said("must be finite and positive; leave out a bearing that never ran"),
            field="times",
            value=float(times[bad][0]),
            example=_EXAMPLE,
        )
    given = ~np.isnan(lower)
    bad = given & ~((lower >= 0.0) & (lower < times) & failed)
    if np.any(bad):
        raise InputError(
            said("must be below the time of its row, and only a failed bearing has one"),
            field="lower",
            value=float(lower[bad][0]),
            example="lower = [100.0], times = [150.0]",
        )


def _check_rigs(
    times: FloatArray, failed: BoolArray, lower: FloatArray, counts: IntArray, rig: TextArray
) -> None:
    """Refuse a rig that does not end as one, at its first failure."""
    labelled = rig != ""
    if not np.any(labelled):
        return
    names, which = np.unique(rig[labelled], return_inverse=True)
    ends = times[labelled]
    first, last = np.full(len(names), np.inf), np.zeros(len(names))
    np.minimum.at(first, which, ends)
    np.maximum.at(last, which, ends)
    failures = np.bincount(which, weights=(counts * failed)[labelled])
    inspected = np.bincount(which, weights=~np.isnan(lower[labelled]))
    for wrong, what in (
        (first < last, marked("ends at several times; {rest}")),
        (failures > 1.0, marked("has several failures; {rest}")),
        (inspected > 0.0, marked("has a failure found at an inspection; {rest}")),
    ):
        if np.any(wrong):
            raise InputError(
                said(
                    what,
                    rest=said(
                        "a rig ends as one, at its first failure: leave the rig out where its"
                        " bearings ran on"
                    ),
                ),
                field="rig",
                value=str(names[wrong][0]),
            )
