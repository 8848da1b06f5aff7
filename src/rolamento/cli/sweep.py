"""`rolamento sweep`: many cases from one study file."""

from __future__ import annotations

from enum import StrEnum
from typing import TYPE_CHECKING, Annotated, NoReturn

import typer

from rolamento.cli.case_options import NOTHING_GIVEN, CaseOptions, with_case
from rolamento.cli.common import (
    INTERRUPTED,
    NO_RESULT,
    SOLVED,
    ended_softly,
    plain_endings,
)
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import LanguageOption, VariantsOption
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.streams import complain, print_text
from rolamento.errors import InputError
from rolamento.words import marked, said

if TYPE_CHECKING:
    from rolamento.studies.subject import Subject


class Listed(StrEnum):
    """What can be listed."""

    fields = "fields"
    outputs = "outputs"


app = typer.Typer()


@app.command(
    cls=JsonCommand, epilog="Examples: sweep study.toml -o result.nc; sweep --list fields."
)
@with_outputs
@with_case
def sweep(
    study: Annotated[
        str | None,
        typer.Argument(metavar="STUDY", help="Study file (TOML or JSON); - for standard input."),
    ] = None,
    output: Annotated[
        str | None,
        typer.Option(
            "--output",
            "-o",
            metavar="FILE",
            help="Result: a .nc (NetCDF), .csv, .parquet or .xlsx file; by default named after the"
            " study.",
        ),
    ] = None,
    given: CaseOptions = NOTHING_GIVEN,
    variants: VariantsOption = None,
    threads: Annotated[
        int | None,
        typer.Option(
            "--threads",
            metavar="N",
            min=1,
            max=1024,
            help="Number of threads; by default one per processor.",
        ),
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
        bool, typer.Option("--restart", help="Start over, discarding what an earlier run has kept.")
    ] = False,
    listed: Annotated[
        Listed | None,
        typer.Option(
            "--list",
            help="List the fields that may vary, or the outputs: those of a STUDY, or of any case.",
        ),
    ] = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Solve many cases: ranges of fields, or random draws.

    A study file says what varies, of a bearing's case or of a machine: all values of some fields,
    or values drawn at random.
    """
    with plain_endings(lang), given.in_force():
        if listed is not None:
            subject = _subject(study, given)
            text = fields_text if listed is Listed.fields else outputs_text
            print_text(text(subject))
            return
        if study is None:
            raise InputError(
                said("is missing"), field="STUDY", example="rolamento sweep study.toml"
            )
        outputs.check(
            {"--output": output},
            study,
            rule=marked("is the study file itself; choose another name"),
        )
        from rolamento.case.variant import read_variants
        from rolamento.cli.sweep_progress import told
        from rolamento.pages.study import study_page
        from rolamento.tasks import studies

        try:
            with ended_softly(), told() as progress:
                swept = studies.sweep(
                    study,
                    output,
                    changes=given.settings,
                    variants=read_variants(variants or ()),
                    threads=threads,
                    scheduler=scheduler,
                    restart=restart,
                    progress=progress,
                    keep_cases=outputs.csv is not None or outputs.xlsx is not None,
                )
        except KeyboardInterrupt as stop:
            _tell_what_is_kept(stop)
        title = swept.study.title or swept.study.subject.title
        outputs.show(lambda: study_page(swept.summary, title))
    raise typer.Exit(SOLVED if swept.summary.converged else NO_RESULT)


def _tell_what_is_kept(stop: KeyboardInterrupt) -> NoReturn:
    """End an interrupted study; before the first case there is nothing to show."""
    from rolamento.studies import Interrupted

    if not isinstance(stop, Interrupted):
        raise stop
    complain(
        said(
            "stopped; {done} of {total} cases are kept in {folder}. Run the same command to"
            " continue",
            done=stop.done,
            total=stop.total,
            folder=str(stop.folder),
        )
    )
    raise typer.Exit(INTERRUPTED) from None


def _subject(study: str | None, given: CaseOptions) -> Subject | None:
    """What a study file is of; None without one."""
    from rolamento.studies import load_study

    return None if study is None else load_study(study, given.settings).subject


def fields_text(subject: Subject | None = None) -> str:
    """Return the fields, one a line: name, SI unit, an example, and whether it can be scattered.

    Parameters
    ----------
    subject
        Whose fields; those of any case if not given.
    """
    from rolamento.studies.fields import known_fields
    from rolamento.studies.solving import array_fields

    fields = known_fields() if subject is None else subject.fields()
    rows = []
    for name, field in fields.items():
        in_batch = name in array_fields() if subject is None else subject.varies_in_batch(name)
        both = field.continuous and in_batch
        kinds = said("axes, scatter") if both else said("axes")
        rows.append((name, field.unit, field.example, kinds))
    return _columns([(said("field"), said("unit"), said("example"), said("for")), *rows])


def outputs_text(subject: Subject | None = None) -> str:
    """Return the outputs, one a line: name, SI unit, whether it is one of several, meaning.

    Parameters
    ----------
    subject
        Whose outputs; those of any case if not given.
    """
    from rolamento.studies.outputs import DEFAULT_OUTPUTS, catalogue

    known = catalogue() if subject is None else subject.catalogue()
    usual = DEFAULT_OUTPUTS if subject is None else subject.default_outputs()
    along = {
        "": "",
        "ball": said("per ball"),
        "row": said("per row"),
        "bearing": said("per bearing"),
        "shaft": said("per shaft"),
    }
    rows = [
        (
            f"{name}{'*' if name in usual else ''}",
            output.unit,
            along[output.along],
            output.label,
        )
        for name, output in known.items()
    ]
    foot = f"\n* {said('by default, if a study names no outputs')}\n"
    return _columns([(said("output"), said("unit"), "", said("meaning")), *rows]) + foot


def _columns(rows: list[tuple[str, ...]]) -> str:
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = ("  ".join(c.ljust(w) for c, w in zip(row, widths, strict=True)) for row in rows)
    return "".join(f"{line.rstrip()}\n" for line in lines)
