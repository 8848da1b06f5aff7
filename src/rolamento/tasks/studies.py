"""Studies from end to end: a file of many cases solved, a scatter study taken apart."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Final

from rolamento.case import Case
from rolamento.case.fields import Changes
from rolamento.case.variant import named
from rolamento.errors import FileError, InputError
from rolamento.io.text import format_of_path
from rolamento.records import frozen
from rolamento.studies.fields import Field, read_field
from rolamento.studies.scatter import Distribution, Scatter
from rolamento.studies.sensitivity import ToleranceStudy, sobol
from rolamento.studies.study import Study, file_in_study, load_study
from rolamento.studies.tolerance import (
    PERCENTILES,
    checked_percentiles,
)
from rolamento.tasks.curve import bounds_of
from rolamento.tasks.report import number_of_field, with_life
from rolamento.words import marked, said

if TYPE_CHECKING:
    from rolamento.case.variant import Variant
    from rolamento.studies.plan import Plan
    from rolamento.studies.runner import Executor, Progress, Summary
    from rolamento.studies.tables import KeptCases
    from rolamento.words import Note

__all__ = ["Sweep", "room_of", "sweep", "tolerance", "tolerance_of_case", "with_variants"]

_STANDARD_INPUT: Final = "-"
SIGMAS: Final = 3.0
"""Standard deviations that a tolerance to either side holds."""
SAMPLES: Final = 600
_SHARE: Final = 0.5
_KELVIN: Final = 20.0
"""How far a field may scatter: half its value, a temperature so much."""


@frozen
class Sweep:
    """A study, and what became of it."""

    study: Study
    summary: Summary


def sweep(
    study: Study | str | os.PathLike[str],
    result: str | os.PathLike[str] | None = None,
    *,
    changes: Changes = (),
    variants: Iterable[Variant] = (),
    threads: int | None = None,
    scheduler: str | None = None,
    restart: bool = False,
    progress: Progress | None = None,
    keep_cases: bool = False,
) -> Sweep:
    """Solve all cases of a study, and write them to a file.

    Parameters
    ----------
    study
        A `Study`, or a study file; ``"-"`` is standard input.
    result
        A ``.nc``, ``.csv``, ``.parquet`` or ``.xlsx`` file; by default named after the study's
        file, as NetCDF in the current directory. A workbook has the units that people read.
    changes
        What goes over the case of a study file, by dotted name.
    variants
        To be compared with the case, beside those of the study.
    threads
        As many as there are processors by default.
    scheduler
        Of a Dask cluster that solves the cases instead, such as ``"tcp://127.0.0.1:8786"``.
    restart
        Throw away what an earlier run has kept.
    progress
        Called with the cases done, all cases, and those without a result.
    keep_cases
        Whether the summary has the cases too, for the tables of its page.

    Raises
    ------
    InputError, FileError
        If the study cannot be read or the result not written, or it would go over what is read.
    Interrupted
        On Ctrl-C; what was solved is kept.
    """
    from rolamento.studies.runner import run_to_file

    executor = _executor(threads, scheduler)
    if isinstance(study, Study):
        if changes:
            raise InputError(
                said("apply to a study file; change the case of a Study instead"), field="changes"
            )
        loaded, target = study, Path(result or "study.nc")
    else:
        name = "study" if os.fspath(study) == _STANDARD_INPUT else Path(study).stem
        target = Path(result or f"{name}.nc")
        _check_target(target, os.fspath(study))
        loaded = load_study(study, changes)
    loaded = with_variants(loaded, variants)
    summary = run_to_file(
        loaded,
        target,
        executor=executor,
        restart=restart,
        progress=progress,
        keep_cases=keep_cases,
        writers={".xlsx": _workbook},
    )
    return Sweep(loaded, summary)


@contextmanager
def _workbook(
    place: Path, plan: Plan, counts: Mapping[str, int], reasons: tuple[Note, ...]
) -> Iterator[KeptCases]:
    """Open a workbook with the cases in one sheet, in the units that people read."""
    from rolamento.document import Document, Section
    from rolamento.document.tables import to_xlsx
    from rolamento.pages.study import cases_table
    from rolamento.studies.tables import KeptCases

    kept = KeptCases(plan, reasons)
    yield kept
    title = plan.study.title or plan.study.subject.title
    page = Document(title, (Section(blocks=(cases_table(kept.columns),)),), "sweep")
    place.write_bytes(to_xlsx(page))


def with_variants(study: Study, variants: Iterable[Variant]) -> Study:
    """Return a study that compares further variants.

    Raises
    ------
    InputError
        If they do not go with its case, or two have one name.
    """
    added = tuple(variants)
    if not added:
        return study
    try:
        return study.replace(variants=(*study.variants, *added))
    except InputError as error:
        if not error.field.startswith("variants."):
            raise
        place, _, field = error.field.removeprefix("variants.").partition(".changes")
        name = (*study.variants, *added)[int(place)].name
        raise named(error, name, field.lstrip(".")) from None


def _executor(threads: int | None, scheduler: str | None) -> Executor:
    """Solve in threads of this process, or on a cluster."""
    from rolamento.studies.runner import local_threads

    if scheduler is None:
        return local_threads(threads)
    if threads is not None:
        raise InputError(
            said("cannot be combined with `scheduler`: the cluster has its own threads"),
            field="threads",
            value=threads,
        )
    from rolamento.studies.cluster import dask_cluster

    return dask_cluster(scheduler)


def _check_target(target: Path, study: str) -> None:
    """Refuse a result that would go over what is read."""
    if study == _STANDARD_INPUT:  # which is there to be read once
        return
    for path, rule in (
        (Path(study), marked("is the study file itself; choose another name")),
        (file_in_study(study), marked("is the case file of the study; choose another name")),
    ):
        if path is not None and os.path.realpath(path) == os.path.realpath(target):
            raise FileError(said(rule), source=str(target))


def tolerance(
    study: Study | str | os.PathLike[str],
    *,
    percentiles: Sequence[float] = PERCENTILES,
    sobol_samples: int | None = None,
) -> ToleranceStudy:
    """Take percentiles of a scatter study, and find which input matters.

    Parameters
    ----------
    study
        A `Study` or a study file, which is run; or the NetCDF file of its result.
    percentiles
        In per cent.
    sobol_samples
        Sobol's indices too, from so many samples (a power of two), which takes runs of their own;
        not of a result.

    Raises
    ------
    InputError, FileError
        If there is no scatter, a percentile is out of range, or a file cannot be read.
    """
    from rolamento.studies.runner import run

    wanted = checked_percentiles(percentiles)
    indices, source = None, "" if isinstance(study, Study) else os.fspath(study)
    if not isinstance(study, Study) and (
        source == _STANDARD_INPUT or format_of_path(source) is not None
    ):
        study = load_study(study)
    if isinstance(study, Study):
        if study.scatter is None:
            raise InputError(
                said("is missing: there is nothing to take percentiles of"),
                field="scatter",
                source=source,
            )
        if sobol_samples is not None:
            indices = sobol(study, samples=sobol_samples)
        dataset = run(study)
    elif sobol_samples is not None:
        raise InputError(
            said("needs the study file: the indices come from runs of their own"),
            field="sobol",
            source=source,
            example="rolamento tolerance study.toml --sobol 1024",
        )
    else:
        from rolamento.studies.dataset import load_result

        dataset = load_result(study)
    return ToleranceStudy.of(dataset, wanted, indices)


def tolerance_of_case(
    case: Case,
    deviations: Mapping[str, float],
    outputs: Sequence[str],
    *,
    samples: int = SAMPLES,
    percentiles: Sequence[float] = (5.0, 50.0, 95.0),
) -> ToleranceStudy:
    """Scatter fields of a case around their values, each by so much to either side.

    A field is normally distributed around its value, its tolerance three standard deviations, and
    is cut off there and at the field's own bounds; fields scatter independently.

    Parameters
    ----------
    case
        With a value of each field.
    deviations
        By the dotted name of the field: the tolerance to either side, SI, positive.
    outputs
        Names of the catalogue of outputs.
    samples
        Number of draws.
    percentiles
        In per cent.

    Raises
    ------
    InputError
        If nothing scatters, a field has no value or takes none beside it, or the case lacks what
        an output rests on.
    """
    case = with_life(case)
    fields = {name: _around(case, read_field(name, at="deviations"), size)
              for name, size in deviations.items()}  # fmt: skip
    scatter = Scatter(count=samples, fields=fields)
    study = Study(case=case, outputs=tuple(outputs), scatter=scatter)
    return tolerance(study, percentiles=percentiles)


def _around(case: Case, field: Field, size: float) -> Distribution:
    at, room = number_of_field(case, field.name), room_of(case, field)
    if at is None or not 0.0 < size <= room:
        raise InputError(
            said("takes a tolerance above 0 and at most {most}", most=field.written(room)),
            field=f"deviations.{field.name}",
            value=size,
        )
    low, high = bounds_of(field)
    return Distribution(
        distribution="normal", mean=at, standard_deviation=size / SIGMAS,
        minimum=max(at - size, low), maximum=min(at + size, high),
    )  # fmt: skip


def room_of(case: Case, field: Field) -> float:
    """Return by how much a field of a case may scatter to either side, SI; 0 where it may not."""
    at = number_of_field(case, field.name)
    if at is None or not field.continuous:
        return 0.0
    low, high = bounds_of(field)
    wide = _KELVIN if field.dimension == "temperature" else _SHARE * abs(at)
    return max(0.0, min(wide, at - low, high - at))
