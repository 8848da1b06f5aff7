"""Studies of many cases and figures of results: use cases, each a request."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Annotated, Any, ClassVar, Self

from pydantic import model_validator

from rolamento.errors import InputError
from rolamento.io.json import dumps
from rolamento.tasks.case_request import VARIANTS, CaseRequest, Finding, FindingRequest, drawn
from rolamento.tasks.parameters import Progress, quietly
from rolamento.tasks.request import Input
from rolamento.words import marked, said

__all__ = ["PlotRequest", "SweepRequest", "ToleranceRequest"]

_STANDARD_INPUT = "-"


def _lists() -> Mapping[str, str]:
    return {"fields": "", "outputs": ""}


class SweepRequest(FindingRequest):
    """Solve many cases: ranges of fields, or random draws.

    A study file says what varies, of a bearing's case or of a machine: all values of some fields,
    or values drawn at random.

    Parameters
    ----------
    study
        Study file (TOML or JSON); - for standard input.
    output
        Result: a .nc (NetCDF), .csv, .parquet or .xlsx file; by default named after the study.
    variants
        Also the case with this changed, under this name; further FIELD=VALUE after commas, such as
        'spring:bearing.preload={ spring = "500 N" }'.
    threads
        Number of threads; by default one per processor.
    scheduler
        Solve on a Dask cluster instead, such as tcp://127.0.0.1:8786.
    restart
        Start over, discarding what an earlier run has kept.
    listed
        List the fields that may vary, or the outputs: those of a STUDY, or of any case.
    changes
        What goes over its case, by dotted name.
    tables
        Whether the page has all cases, for its tables.
    """

    study: Annotated[Any, Input("", "file", metavar="STUDY")] = None
    output: Annotated[Any, Input("", "target", metavar="FILE")] = None
    variants: Annotated[tuple[str, ...], VARIANTS] = ()
    threads: Annotated[int | None, Input("", "count", example="4", between=(1, 1024))] = None
    scheduler: Annotated[
        str | None, Input(example="tcp://127.0.0.1:8786", metavar="ADDRESS", at_computer=True)
    ] = None
    restart: Annotated[bool, Input("", "switch")] = False
    listed: Annotated[
        str | None, Input("", "choice", choices=_lists, option="--list", metavar="NAME")
    ] = None
    changes: Any = ()
    tables: bool = False

    headings: ClassVar = CaseRequest.headings
    takes_case: ClassVar = True
    json_meaning: ClassVar = ""
    examples: ClassVar = "Examples: sweep study.toml -o result.nc; sweep --list fields."

    @property
    def target(self) -> str | None:
        """Name of the file of the result, if it is given."""
        return None if self.listed else self.output

    @property
    def lasts(self) -> bool:
        """Whether it solves."""
        return self.listed is None

    @model_validator(mode="after")
    def _has_a_study(self) -> Self:
        if self.study is None and self.listed is None:
            raise InputError(said("is missing"), field="study", example="study.toml")
        return self

    def run(self, progress: Any = quietly) -> Finding:
        """Find it, a `Sweep`; or only list what there is."""
        if self.listed is not None:
            from rolamento.pages.study import fields_text, outputs_text
            from rolamento.studies import load_study

            of = None if self.study is None else load_study(self.study, self.changes).subject
            text = fields_text if self.listed == "fields" else outputs_text
            return Finding(None, text=text(of))
        from rolamento.case.variant import read_variants
        from rolamento.pages.study import study_page
        from rolamento.tasks.studies import sweep

        own = ("threads", "scheduler", "restart", "changes")
        found = sweep(
            self.study, self.output, **{name: getattr(self, name) for name in own},
            variants=read_variants(self.variants), progress=progress, keep_cases=self.tables,
        )  # fmt: skip
        title = found.study.title or found.study.subject.title
        return Finding(
            found,
            partial(study_page, found.summary, title),
            is_result=bool(found.summary.converged),
        )

    def write(self, found: Any, path: str) -> None:
        """Leave the file as it was written while it was solved."""


class ToleranceRequest(FindingRequest):
    """Show percentiles of a study, and which inputs matter.

    For every output of a scatter study, with the inputs that it depends on most.

    Parameters
    ----------
    study
        Result of a scatter study (.nc), or a study file with [scatter] to run.
    percentiles
        Percentiles in per cent, such as 5,50,95.
    sobol
        Also Sobol's indices, from N (inputs + 2) runs of a study file; N such as 1024.
    """

    study: Annotated[Any, Input("", "file", essential=True, metavar="RESULT")]
    percentiles: Annotated[
        tuple[float, ...],
        Input("", "numbers", example="5,50,95", separator=",", metavar="LIST"),
    ] = ()
    sobol: Annotated[int | None, Input("", "count", example="1024", metavar="N")] = None

    examples: ClassVar = "Example: tolerance scatter.nc --plot bands.png."
    products: ClassVar = drawn(marked("Draw the result: a .png, .svg or .pdf file."))

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it, a `ToleranceStudy`."""
        from rolamento.pages.tolerance import tolerance_page
        from rolamento.plots.tolerance import tolerance_figure
        from rolamento.studies.tolerance import PERCENTILES
        from rolamento.tasks.studies import tolerance

        found = tolerance(
            self.study, percentiles=self.percentiles or PERCENTILES, sobol_samples=self.sobol
        )
        return Finding(
            found, partial(tolerance_page, found), lambda: dumps(found.to_mapping()),
            partial(tolerance_figure, found), "", found.bands.share_without_result < 1.0,
        )  # fmt: skip


def _kinds() -> Mapping[str, str]:
    from rolamento.tasks.drawing import Kind

    return dict.fromkeys((kind.value for kind in Kind), "")


class PlotRequest(FindingRequest):
    """Draw a state, its life or a study; several share a figure.

    Loads, angles, pressures, ellipses, rollers, life, sweeps, distributions.

    Parameters
    ----------
    results
        What to draw: the JSON of a state (solve --json), - for standard input, or the NetCDF file
        of a study; several of one or the other share a figure.
    kind
        For a state: rosette (default), balls, angles, pressures, ellipses; with rollers: along
        (pressure along them), between (the most loaded one between the races); for its life: aiso
        (a_ISO), sn (life over load), zone (life over the load zone), helps (what would help); for
        a study: lines, map, histogram, scatter (default: what suits it).
    variable
        Output of a study to draw.
    over
        Input of a study along the horizontal axis.
    labels
        What the legend calls a file, one for each; by default titles or names.
    variants
        Also the case with this changed, under this name; further FIELD=VALUE after commas, such as
        'spring:bearing.preload={ spring = "500 N" }'.
    output
        File to write: .png, .svg or .pdf; by default RESULT's name with .png, in this folder.
    """

    results: Annotated[Any, Input("", "files", essential=True, metavar="RESULT")]
    kind: Annotated[str | None, Input("", "choice", choices=_kinds)] = None
    variable: Annotated[str | None, Input(example="stiffness_zz", metavar="NAME")] = None
    over: Annotated[str | None, Input(example="inner_speed", metavar="NAME")] = None
    labels: Annotated[
        tuple[str, ...],
        Input("", "list", separator="", option="--label", metavar="TEXT", at_computer=True),
    ] = ()
    variants: Annotated[tuple[str, ...], VARIANTS] = ()
    output: Annotated[Any, Input("", "target", metavar="FILE")] = None

    json_meaning: ClassVar = ""
    shows_page: ClassVar = False
    examples: ClassVar = (
        "Examples: plot state.json --kind ellipses -o ellipses.pdf;"
        " plot sweep.nc --variable stiffness_zz."
    )

    @property
    def target(self) -> str:
        """Name of the picture; after the first result where none is given."""
        if self.output is not None:
            return str(self.output)
        if self.results[0] == _STANDARD_INPUT:
            return "state.png"
        return f"{Path(self.results[0]).stem.strip('.') or 'figure'}.png"

    def check_target(self, path: str) -> None:
        """Refuse a name that ends as no picture."""
        from rolamento.plots.saving import check_name

        check_name(path)

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it, a `Drawing`."""
        from rolamento.case.variant import read_variants
        from rolamento.charts.texts import no_result
        from rolamento.tasks.drawing import draw

        own = {name: getattr(self, name) for name in ("variable", "over", "labels")}
        found = draw(self.results, self.kind, variants=read_variants(self.variants), **own)
        return Finding(
            found, picture=lambda: found.figure, is_result=found.failure is None,
            complaint="" if found.failure is None else no_result(found.failure),
        )  # fmt: skip

    def write(self, found: Any, path: str) -> None:
        """Save the picture."""
        from rolamento.plots.saving import save_figure

        save_figure(found.picture(), path)
