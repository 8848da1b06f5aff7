"""`rolamento sweep`: many cases from one study file."""

from __future__ import annotations

import sys
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rolamento.cli.common import (
    INTERRUPTED,
    NO_RESULT,
    SOLVED,
    Language,
    plain_endings,
    words_of,
)
from rolamento.cli.options import LanguageOption, SettingsOption
from rolamento.cli.outputs import check_outputs
from rolamento.cli.streams import STANDARD_STREAM, complain, print_text
from rolamento.errors import InputError

if TYPE_CHECKING:
    from rolamento.studies import Study, Summary
    from rolamento.studies.runner import Executor

__all__ = ["sweep"]


class Listed(StrEnum):
    """What can be listed."""

    fields = "fields"
    outputs = "outputs"


def sweep(
    study: Annotated[
        str | None,
        typer.Argument(metavar="STUDY", help="Study file (TOML or JSON); - is standard input."),
    ] = None,
    output: Annotated[
        str | None,
        typer.Option(
            "--output",
            "-o",
            metavar="FILE",
            help="Result: a .nc (NetCDF), .csv or .parquet file; by default named after the study.",
        ),
    ] = None,
    settings: SettingsOption = None,
    threads: Annotated[
        int | None,
        typer.Option("--threads", metavar="N", min=1, max=1024, help="By default all processors."),
    ] = None,
    scheduler: Annotated[
        str | None,
        typer.Option(
            "--scheduler",
            metavar="ADDRESS",
            help="Solve on a Dask cluster instead, such as tcp://127.0.0.1:8786.",
        ),
    ] = None,
    restart: Annotated[
        bool, typer.Option("--restart", help="Begin anew, whatever an earlier run has kept.")
    ] = False,
    listed: Annotated[
        Listed | None,
        typer.Option("--list", help="Show which fields may vary, or which outputs there are."),
    ] = None,
    lang: LanguageOption = None,
) -> None:
    """Solve many cases: ranges of fields, or random draws.

    A study file says what varies: all values of some fields, or values drawn at random.
    """
    with plain_endings(lang):
        if listed is not None:
            from rolamento.cli.sweep_list import fields_text, outputs_text

            print_text(fields_text() if listed is Listed.fields else outputs_text())
            return
        if study is None:
            raise InputError("is missing", field="STUDY", example="rolamento sweep study.toml")
        where = _executor(threads, scheduler)
        summary = _swept(study, output, settings or [], where, restart, lang)
    raise typer.Exit(SOLVED if summary.converged else NO_RESULT)


def _swept(
    path: str,
    output: str | None,
    settings: list[str],
    where: Executor,
    restart: bool,
    lang: Language | None,
) -> Summary:
    from rolamento.studies import load_study
    from rolamento.studies.study import case_file_of

    result = output or _default_name(path)
    check_outputs({"--output": result}, path, rule="is the study file itself")
    if path != STANDARD_STREAM:  # which is there to be read once
        case = case_file_of(path)
        check_outputs(
            {"--output": result},
            None if case is None else str(case),
            rule="is the study's case file",
        )
    loaded = load_study(path, settings)
    summary = _run(loaded, result, where, restart, lang)
    _print_report(loaded, summary, lang)
    return summary


def _executor(threads: int | None, scheduler: str | None) -> Executor:
    """Solve in threads of this process, or on a cluster."""
    from rolamento.studies.runner import local_threads

    if scheduler is None:
        return local_threads(threads)
    if threads is not None:
        raise InputError(
            "is given beside --scheduler: the cluster has threads of its own",
            field="--threads",
            value=threads,
        )
    from rolamento.studies.cluster import dask_cluster

    return dask_cluster(scheduler)


def _run(
    study: Study, result: str, where: Executor, restart: bool, lang: Language | None
) -> Summary:
    """Solve with progress; on Ctrl-C say what is kept."""
    from rolamento.cli.sweep_progress import told
    from rolamento.report.study_words import STUDY_WORDS
    from rolamento.studies import Interrupted, run_to_file

    words = words_of(lang)
    try:
        with told(words) as progress:
            return run_to_file(study, result, executor=where, restart=restart, progress=progress)
    except Interrupted as stop:
        said = STUDY_WORDS[words.code].stopped
        complain(said.format(done=stop.done, total=stop.total, folder=stop.folder))
        raise typer.Exit(INTERRUPTED) from None


def _print_report(study: Study, summary: Summary, lang: Language | None) -> None:
    from rolamento.report.medium import Medium
    from rolamento.report.study import study_report

    title = study.title or study.case.title
    print_text(study_report(summary, title, words_of(lang), Medium.of(sys.stdout)))


def _default_name(path: str) -> str:
    """Return the study's name with the ending of NetCDF, in the current directory."""
    stem = "study" if path == STANDARD_STREAM else Path(path).stem
    return f"{stem}.nc"
