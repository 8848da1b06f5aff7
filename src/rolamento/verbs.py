"""What Rolamento does, a verb each: they take a designation, a case, a case file or solved cases.

>>> import rolamento
>>> life = rolamento.rating_life("6310/C3", fz=5e3, inner_speed="1480 rpm")
>>> f"{life.ratings.dynamic[0, 0] / 1e3:.0f} kN"
'62 kN'
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Final, Unpack

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case import Case, case_of, is_designation
from rolamento.case.bearing import Bearing
from rolamento.case.duty import SHORT_NAMES
from rolamento.case.machine import Machine
from rolamento.case.roller_bearing import RollerBearing
from rolamento.case.varied import DutyFields
from rolamento.errors import InputError
from rolamento.solution import solved_of
from rolamento.solved import Solved
from rolamento.words import said

if TYPE_CHECKING:
    from xarray import Dataset

    from rolamento.catalogue import CatalogueBearing
    from rolamento.friction import Friction
    from rolamento.life import LifeConditions, LifeSummary
    from rolamento.lubrication import Film
    from rolamento.studies import Study
    from rolamento.tasks.report import Report
    from rolamento.weibull import FitMethod, LifeTest, WeibullFit

__all__ = [
    "find_bearings",
    "fit_weibull",
    "friction_torque",
    "lubricant_film",
    "rating_life",
    "report",
    "sweep",
]

Source = Case | Bearing | RollerBearing | Solved | str | os.PathLike[str]
"""A case, a bearing, solved cases, a case file, or a designation."""

_MOST_FOUND: Final = 50


def lubricant_film(
    source: Source,
    values: Any = None,
    *,
    lubricant: Any = None,
    temperature: str | float | None = None,
    threads: int | None = None,
    **fields: Unpack[DutyFields],
) -> Film:
    """Film thickness of every contact, and the viscosity ratio κ.

    Parameters
    ----------
    source
        A designation, a case, its file, a bearing, or what `rolamento.solve` returned.
    values, fields
        What varies or goes over the duty, as of `rolamento.solve`: numbers in SI units, texts with
        a unit, or arrays of one length.
    lubricant
        An oil or a grease, or its name; by default that of the case.
    temperature
        Of the lubricant: text such as ``"70 degC"``, or K; by default that of the case.
    threads
        As many as there are processors by default.

    Returns
    -------
    Film
        Arrays over cases and contacts, SI; NaN where a case has no solution.

    Raises
    ------
    InputError
        If there is no lubricant or no temperature, or a value is not one that the case takes.
    FileError
        If a file cannot be read.

    >>> film = lubricant_film(
    ...     "6310/C3", fz=5e3, inner_speed="1480 rpm", lubricant="ISO VG 68", temperature="70 degC"
    ... )
    >>> print(f"{1e6 * film.kinematic_viscosity[0]:.1f} mm^2/s, {film.viscosity_ratio[0]:.2f}")
    19.9 mm^2/s, 1.53
    """
    from rolamento.lubrication import film

    solved = solved_of(
        source, values, lubricant=lubricant, temperature=temperature, threads=threads, **fields
    )
    return film(solved, threads=threads)


def friction_torque(
    source: Source,
    values: Any = None,
    *,
    lubricant: Any = None,
    temperature: str | float | None = None,
    model: str | None = None,
    compare: bool | None = None,
    threads: int | None = None,
    **fields: Unpack[DutyFields],
) -> Friction:
    """Friction torque, power loss and heat, by their sources.

    Parameters
    ----------
    source, values, lubricant, temperature, threads, fields
        As of `lubricant_film`.
    model
        Of the friction in the contacts, such as ``"jones_simplified"``; by default as of
        `rolamento.analyse`.
    compare
        Whether to evaluate all models; by default of a single case only.

    Returns
    -------
    Friction
        Arrays over cases, SI; NaN where a case has no solution.

    Raises
    ------
    InputError
        If neither a coefficient of friction nor an oil or a grease at its temperature is given.
    FileError
        If a file cannot be read.

    >>> friction = friction_torque(
    ...     "6310/C3", fz=5e3, inner_speed="1480 rpm", lubricant="ISO VG 68", temperature="70 degC"
    ... )
    >>> print(f"{friction.power[0] / friction.torque[0]:.2f} rad/s")  # 1480 rpm
    154.99 rad/s
    """
    from rolamento.analysis import film_and_friction
    from rolamento.friction.summary import no_coefficient

    solved = solved_of(
        source, values, lubricant=lubricant, temperature=temperature, threads=threads, **fields
    )
    compare = len(solved) == 1 if compare is None else compare
    _, friction = film_and_friction(solved, model=model, compare=compare, threads=threads)
    if friction is None:
        raise no_coefficient(solved.case)
    return friction


def rating_life(
    source: Source,
    values: Any = None,
    *,
    lubricant: Any = None,
    temperature: str | float | None = None,
    conditions: LifeConditions | None = None,
    threads: int | None = None,
    **fields: Unpack[DutyFields],
) -> LifeSummary:
    """Fatigue life by every theory that the case allows: ISO 281, ISO/TS 16281 and others.

    Parameters
    ----------
    source, values, lubricant, temperature, threads, fields
        As of `lubricant_film`; without a lubricant the life is the basic one.
    conditions
        Ratings, lubrication, cleanliness and reliability; by default those of the case.

    Returns
    -------
    LifeSummary
        Its ``headline`` is the life that leads; arrays over cases, NaN without a solution.

    Raises
    ------
    InputError
        If no theory is for such a bearing, or neither the catalogue nor the geometry gives a
        rating.
    FileError
        If a file cannot be read.

    >>> life = rating_life("6310/C3", fz=5e3, inner_speed="1480 rpm")
    >>> f"{life['iso281'].life[0]:.0f} million revolutions"
    '1907 million revolutions'
    """
    from rolamento.life import life

    solved = solved_of(
        source, values, lubricant=lubricant, temperature=temperature, threads=threads, **fields
    )
    return life(solved, conditions)


def fit_weibull(
    data: LifeTest | ArrayLike | str | os.PathLike[str],
    failed: ArrayLike | None = None,
    *,
    method: FitMethod = "maximum_likelihood",
    unit: str | None = None,
    **columns: Any,
) -> WeibullFit:
    """Fit a Weibull distribution to the lives of a test.

    `rolamento.weibull.bounds` gives confidence limits, `rolamento.tasks.life_test_study` all that
    a test says, group by group and failure mode by failure mode.

    Parameters
    ----------
    data
        Times; or a `LifeTest`; or a CSV or XLSX file of them.
    failed
        Whether each bearing failed; by default all did. A file says it itself.
    method
        One of `rolamento.weibull.FIT_METHODS`.
    unit
        Of the times; by default hours, or that of the file.
    columns
        Of a file, as of `rolamento.weibull.read_life_test`.

    Returns
    -------
    WeibullFit
        With ``shape``, ``scale``, ``l10``; its ``code`` says why there is none.

    Raises
    ------
    InputError, FileError
        If the data are no life test, or there is no such method.

    >>> fit = fit_weibull([55.2, 81.0, 104.5, 132.1, 150.0, 150.0], [1, 1, 1, 1, 0, 0])
    >>> f"{fit.shape:.3f}, {fit.l10:.1f} {fit.unit}"
    '2.529, 57.9 h'
    """
    from rolamento import weibull

    if isinstance(data, str | os.PathLike):
        if failed is not None:
            raise InputError(said("is in the file of a life test"), field="failed")
        test = weibull.read_life_test(data, unit=unit, **columns)
    elif isinstance(data, weibull.LifeTest):
        test = data
    else:
        test = weibull.LifeTest(data, True if failed is None else failed, unit=unit or "h")
    return weibull.fit_by(method, test)


def sweep(
    source: Study | Machine | Source,
    axes: Mapping[str, Any] | None = None,
    path: str | os.PathLike[str] | None = None,
    *,
    outputs: Sequence[str] | None = None,
    threads: int | None = None,
    progress: Callable[[int, int, int], None] | None = None,
    **fields: Any,
) -> Dataset:
    """Solve every combination of values of some fields.

    Parameters
    ----------
    source
        A designation, a case or its file, or a `Machine`, with `axes`; or a `Study`, or a study
        file.
    axes, fields
        Values of each axis by the dotted name of a field, such as
        ``{"bearing.contact_angle": ["15 deg", "25 deg"]}``, of a machine
        ``{"loads.0.fz": ["1 kN", "2 kN"]}``, or by a short name of the duty's, such as
        ``fz=[1e3, 2e3]``; numbers in SI units or texts with a unit.
    path
        A ``.nc``, ``.csv``, ``.parquet`` or ``.xlsx`` file that the result is written to as well.
    outputs
        Names of what is put out, of docs/reference/outputs.md; by default the usual ones.
    threads
        As many as there are processors by default.
    progress
        Called with the cases done, all cases, and those without a result.

    Returns
    -------
    xarray.Dataset
        A dimension for each axis, a variable for each output; ``status`` says why a case has none.

    Raises
    ------
    InputError, FileError
        If a field is not known or takes no such value, or a file is no study.

    >>> found = sweep("6310/C3", fz=[2e3, 4e3], inner_speed=["1000 rpm", "3000 rpm"])
    >>> found.sizes["fz"], found.sizes["inner_speed"], bool((found.status == 0).all())
    (2, 2, True)
    """
    from rolamento.studies import run

    study = _study_of(source, {**(axes or {}), **fields})
    study = study if outputs is None else study.replace(outputs=tuple(outputs))
    if path is None:
        return run(study, threads=threads, progress=progress)
    from rolamento import tasks
    from rolamento.studies.dataset import load_result

    tasks.sweep(study, path, threads=threads, progress=progress)
    if os.fspath(path).lower().endswith(".nc"):
        return load_result(path)
    return run(study, threads=threads)


def _study_of(source: Study | Machine | Source, axes: Mapping[str, Any]) -> Study:
    """The study that a source is, or that crosses some axes of its case."""
    from rolamento.studies import Axis, Study, load_study

    if isinstance(source, Solved):
        raise InputError(said("must be a case, not a solved one"), field="source")
    if not axes:
        if isinstance(source, Study):
            return source
        if isinstance(source, str | os.PathLike) and not is_designation(source):
            return load_study(source)
        raise InputError(
            said("must be given: values of at least one field"),
            field="axes",
            example='rolamento.sweep("6310/C3", fz=[1e3, 2e3])',
        )
    if isinstance(source, Study):
        raise InputError(said("has axes of its own"), field="source")
    crossed = [
        Axis(field=SHORT_NAMES.get(name, name), values=_listed(values))
        for name, values in axes.items()
    ]
    if isinstance(source, Machine):
        return Study(machine=source, axes=crossed)
    return Study(case=case_of(source), axes=crossed)


def _listed(values: Any) -> tuple[Any, ...]:
    if isinstance(values, str) or not np.ndim(values):
        return (values,)
    return tuple(values.tolist() if hasattr(values, "tolist") else values)


def report(
    sources: Source | Sequence[Source],
    path: str | os.PathLike[str] | None = None,
    *,
    head: Mapping[str, str] | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> Report:
    """Analyse cases as a calculation report has them, side by side, and write it.

    Parameters
    ----------
    sources
        A designation, a case or its file, or several of them; of solved cases each.
    path
        A ``.pdf``, ``.html``, ``.md``, ``.txt`` or ``.json`` file; nothing is written by default.
    head
        Project, author, revision, date and checked_by, over those of the first case.
    progress
        Called with the cases done and all cases.

    Returns
    -------
    Report
        Its cases, each with its inputs, their origins, the analysis and the checks.

    Raises
    ------
    InputError, FileError
        If there are more than 20 cases, one is not valid, or the file cannot be written.

    >>> print(report("6310/C3").cases[0].title)
    6310/C3
    """
    from rolamento.tasks.report import calculation_report

    given: Sequence[Any] = sources if isinstance(sources, list | tuple) else [sources]
    cases: list[Any] = []
    for one in given:
        solved = isinstance(one, Solved)
        cases += [one.case_at(index) for index in range(len(one))] if solved else [one]
    found = calculation_report(cases, head, progress=progress)
    if path is not None:
        _write(found, os.fspath(path))
    return found


def _write(found: Report, path: str) -> None:
    from rolamento.document.writing import write
    from rolamento.io.writing import write_text
    from rolamento.pages.report import report_page

    if path.lower().endswith(".json"):
        write_text(found.to_json() + "\n", path)
    else:
        write(report_page(found), path)


def find_bearings(text: str, most: int = _MOST_FOUND) -> tuple[CatalogueBearing, ...]:
    """Find bearings of the catalogue by part of a designation, or by boundary dimensions.

    Parameters
    ----------
    text
        Such as ``"6310"``, ``"NSK 7014"``, or mm: ``"25x52"`` or ``"25x52x15"``.
    most
        Bearings that are returned at most.

    Returns
    -------
    tuple of CatalogueBearing
        Those that begin with the text before those that contain it; empty if there is none.

    Raises
    ------
    InputError
        If it is no text.

    >>> "6205" in [bearing.designation for bearing in find_bearings("25x52x15")]
    True
    """
    from rolamento.catalogue import catalogue

    if not isinstance(text, str):
        raise InputError(said("must be text"), field="text", value=text, example='"25x52"')
    return catalogue().search(text, most)
