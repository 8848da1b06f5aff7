"""Solve cases: one or many, with or without a mounting, with or without a film in the balance."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from typing import Any, Unpack

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case import Case, case_of
from rolamento.case.bearing import Bearing
from rolamento.case.roller_bearing import RollerBearing
from rolamento.case.varied import DutyFields, bounded, varied_arrays
from rolamento.errors import InputError, refusal
from rolamento.numerics import FloatArray
from rolamento.numerics.threads import thread_count
from rolamento.records import frozen
from rolamento.solved import Delivered, Index, Preloading, PreloadStage, Solved
from rolamento.system import solve_cases, spread
from rolamento.units import readable
from rolamento.words import Note, said

__all__ = ["solve", "solved_of"]

_TELLS_ANGLE = frozenset({"contact_angle", "diametral_clearance"})
_GROOVES = ("inner_conformity", "outer_conformity")


def solve(
    case: Case | Bearing | RollerBearing | str | os.PathLike[str],
    values: Any = None,
    *,
    threads: int | None = None,
    preload_loss: bool = True,
    **fields: Unpack[DutyFields],
) -> Solved:
    """Find the internal state of a bearing: Jones-Harris equilibrium, five degrees of freedom.

    Rows that share a bearing share one rigid inner ring. Never raises for a duty that has no
    solution: the status of the case says so, with advice, and its numbers are NaN. A case with a
    mounting is solved with the clearance in operation of each case, that of its temperatures,
    speeds and whatever else varies: `Solved.case` is the case that it comes to. Of many cases of a
    mounted set it is the case itself, for each of its rows runs with a geometry of its own.

    Parameters
    ----------
    case
        Or its file, a designation, or a bearing; supplies what does not vary.
    values
        What varies: numbers in SI units, texts with a unit, or arrays or lists of one length of
        either, by the dotted names of the case's fields, such as
        ``{"bearing.contact_angle": [0.6, 0.7]}``; or a data frame whose columns are such names.
    threads
        As many as there are processors by default.
    preload_loss
        Whether `Solved.preload` of a single case looks for the load at which a set loses contact:
        some twenty solutions more, when it is first asked for.
    fields
        Likewise by the short names of the duty's fields: inner_speed, outer_speed (rad/s),
        first_ball_azimuth (rad), loads fx, fy, fz (N), my, mz (N·m) and displacements x, y, z
        (m), ry, rz (rad). A load frees its degree of freedom, a displacement holds it.

    Returns
    -------
    Solved
        Of one case if nothing varies.

    Raises
    ------
    InputError
        For an unknown field, arrays of different lengths, fields that exclude each other, fewer
        threads than one, or a mounting that is not one for this bearing or closes it. A value
        that the case would refuse is that case's affair: its status is "invalid_input", and
        `Solved.advice` says which rule it violates.
    FileError
        If the file cannot be read.

    Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapter 8; Jones (1960); Radaelli (2013),
    chapter 4. See docs/theory/equilibrium.md.

    >>> solved = solve("6310/C3", fz=[2e3, 5e3], inner_speed="1480 rpm")
    >>> carried = (solved.inner.load * np.cos(solved.elements.azimuth)).sum(axis=1)
    >>> carried.round(3)  # no tilt, no thrust: the balls' loads add up to the radial load
    array([2000., 5000.])
    """
    case = case_of(case)
    thread_count(threads)
    given = varied_arrays(values, **fields)
    if not given:
        return _solve_one(case, preload_loss)
    solved = _solve_varied(case, given, threads)
    return replace(solved, refusals=Refused(case, _spread_over(len(solved), given)))


def solved_of(
    source: Case | Bearing | RollerBearing | Solved | str | os.PathLike[str],
    values: Any = None,
    *,
    lubricant: Any = None,
    temperature: str | float | None = None,
    threads: int | None = None,
    preload_loss: bool = True,
    **fields: Unpack[DutyFields],
) -> Solved:
    """Return solved cases as they are, or solve what is none yet: the door of all laws.

    Parameters
    ----------
    source
        What `solve` returned; or a case, a bearing without a load, a case file or a designation.
    values, threads, preload_loss, fields
        As of `solve`.
    lubricant
        Over that of the case: a `Lubricant`, or the name of one such as ``"ISO VG 68"``.
    temperature
        Of the lubricant, over that of the case: text such as ``"70 degC"``, or K.

    Raises
    ------
    InputError
        As `solve`; or if anything is to vary of cases that are solved already.
    FileError
        If the file cannot be read.
    """
    over = {"lubricant": lubricant, "temperature.lubricant": temperature}
    over = {name: value for name, value in over.items() if value is not None}
    if isinstance(source, Solved):
        if over or fields or values is not None:
            name = next(iter({**over, **fields}), "values")
            raise InputError(
                said("cannot change: the case is solved already; give the case instead"),
                field=name,
                example='rolamento.friction_torque("6310/C3", fz=5e3)',
            )
        return source
    return solve(
        case_of(source, over), values, threads=threads, preload_loss=preload_loss, **fields
    )


@frozen(eq=False)
class Refused:
    """Cases of a batch, and what each would be refused for as a case of its own.

    Attributes
    ----------
    case
        as it is given
    values
        what varies from it, by the dotted names of fields; (cases,) each, SI
    """

    case: Case
    values: Mapping[str, FloatArray]

    def part(self, index: Index) -> Refused:
        """Return some of the cases."""
        return Refused(self.case, {name: array[index] for name, array in self.values.items()})

    def alone(self, case: int) -> Case:
        """Return a case as one of its own."""
        return self.case.with_({name: float(array[case]) for name, array in self.values.items()})

    def note(self, case: int) -> Note:
        """Return the note on a case: the rule that it violates."""
        own = {name: float(array[case]) for name, array in self.values.items()}
        return refusal(lambda: self._running(own)) or Note("invalid_input")

    def _running(self, values: Mapping[str, float]) -> Case:
        """The case of some values as it runs.

        Raises
        ------
        InputError
            If it is none, or its mounting leaves no bearing.
        """
        for name, value in values.items():  # sooner than the whole case, and by its own name
            field = Case.fields()[name]
            if field.dimension is not None and np.isfinite(value):
                field.checked(readable(value, field.dimension), in_file=True)
            else:
                field.checked(value, in_file=False)
        case = self.case.with_(values)
        if case.mounting is not None and not case.bearing.is_one_bearing:
            from rolamento.system.mounted import running_set

            return running_set(case)
        from rolamento.clearance import operating_case

        return operating_case(case)


def _solve_varied(case: Case, given: Mapping[str, FloatArray], threads: int | None) -> Solved:
    if case.mounting is None:
        return _solve_many(case, given, threads)
    if not case.bearing.is_one_bearing:
        from rolamento.system.mounted import solve_mounted

        solved = solve_mounted(case, bounded(given), threads=threads)
        delivered = _delivered(solved, case, given)
        varied = _spread_over(len(solved), given)
        return replace(solved, case=case, varied=varied, before_mounting=delivered)
    from rolamento.clearance import operating_batch

    running, of_running = operating_batch(case, bounded(given))
    solved = _solve_many(running, dict(of_running), threads)
    return replace(
        solved,
        varied={**_spread_over(len(solved), given), **solved.varied},
        before_mounting=_delivered(solved, case, given),
    )


def _delivered(solved: Solved, case: Case, given: Mapping[str, ArrayLike]) -> Delivered:
    """The bearing before its mounting, with the nominal angle and grooves of every case and row."""
    running = solved.rows.free_contact_angle
    angle = running.copy()
    grooves = {name: np.full_like(running, np.nan) for name in _GROOVES}
    for index, place in enumerate(case.bearing.places):
        for name, found in grooves.items():
            varied = (
                None if name in case.bearing.own_fields(index) else given.get(f"bearing.{name}")
            )
            value = getattr(place.bearing, name, np.nan) if varied is None else varied
            found[:, index] = np.asarray(value, np.float64)
        own = case.bearing.own_fields(index) & _TELLS_ANGLE
        if not own and "bearing.diametral_clearance" in given:
            angle[:, index] = 0.0
        elif not own and "bearing.contact_angle" in given:
            angle[:, index] = np.asarray(given["bearing.contact_angle"], np.float64)
        else:
            angle[:, index] = place.bearing.contact_angle or 0.0
    possible = (angle >= 0.0) & (angle <= 0.5 * np.pi)
    return Delivered(case, np.where(possible, angle, running), **grooves)


def _spread_over(cases: int, arrays: Mapping[str, ArrayLike]) -> dict[str, FloatArray]:
    return {name: np.broadcast_to(np.asarray(v, np.float64), cases) for name, v in arrays.items()}


def _solve_many(case: Case, given: Mapping[str, ArrayLike], threads: int | None) -> Solved:
    cases = spread(case, given, threads=threads)
    if case.model.film_field is not None:
        from rolamento.lubrication.film_control import solved_on_film

        return solved_on_film(cases)
    return solve_cases(cases)


def _solve_one(case: Case, loss: bool) -> Solved:
    if case.mounting is not None and not case.bearing.is_one_bearing:
        return _solve_mounted_set(case, loss)
    notes: tuple[Note, ...] = ()
    given = case
    if case.mounting is not None:
        from rolamento.clearance import clearance_notes, clearance_of_case, operating_case

        notes = clearance_notes(clearance_of_case(case))
        case = operating_case(case)
    solved = _solve_many(case, {}, threads=1)
    if case.bearing.preload is not None and solved.converged[0]:
        from rolamento.system.preload import preload_of

        solved = replace(solved, preloading=partial(preload_of, case, loss=loss))
    if given.mounting is not None:
        solved = replace(solved, before_mounting=_delivered(solved, given, {}))
    return replace(solved, first_notes=notes) if notes else solved


def _solve_mounted_set(case: Case, loss: bool) -> Solved:
    from rolamento.system.mounted import notes_on_set, preload_stages, running_set

    running = running_set(case)
    stages = preload_stages(case)
    solved = _solve_many(running, {}, threads=1)
    delivered = _delivered(solved, case, {})
    solved = replace(solved, first_notes=notes_on_set(case, stages), before_mounting=delivered)
    if running.bearing.preload is None or not solved.converged[0]:
        return solved
    return replace(solved, preloading=partial(_preload_of_mounted, case, running, stages, loss))


def _preload_of_mounted(
    case: Case, running: Case, stages: tuple[PreloadStage, ...], loss: bool
) -> Preloading | None:
    """Return the preload of a mounted set, at rest that of its warm stage."""
    from rolamento.system.mounted import LIMITS
    from rolamento.system.preload import preload_of

    preload, mounting = preload_of(running, loss=loss), case.mounting
    if preload is None or mounting is None or not stages:
        return preload
    by_name = {stage.name: stage for stage in stages}
    warm = by_name.get("warm", by_name["mounted"])
    at_rest = warm.preload[LIMITS.index(mounting.limit)]
    kind = preload.kind if case.bearing.preload is None else case.bearing.preload.kind
    return replace(preload, kind=kind, at_rest=at_rest, stages=stages)
