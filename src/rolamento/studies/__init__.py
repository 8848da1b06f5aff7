"""Studies: many cases from one file, over axes and random scatter.

>>> from rolamento import studies
>>> result = studies.run(studies.load_study("study.toml"))  # doctest: +SKIP

From the inside out: `fields` (what may vary), `axes` and `scatter` (how), `sampling` (the draws),
`outputs` (what is wanted), `study` and `reading` (the file), `plan` (numbered cases, chunks),
`store` (what is kept), `writing` (files), `runner` (all together).
"""

from rolamento.case.variant import Variant
from rolamento.studies.axes import Axis
from rolamento.studies.runner import FirstCase, Interrupted, OutputRange, Summary, run, run_to_file
from rolamento.studies.scatter import Correlation, Distribution, Scatter
from rolamento.studies.study import Study, load_study, parse_study, study_to_json, study_to_toml

__all__ = [
    "Axis",
    "Correlation",
    "Distribution",
    "FirstCase",
    "Interrupted",
    "OutputRange",
    "Scatter",
    "Study",
    "Summary",
    "Variant",
    "load_result",
    "load_study",
    "parse_study",
    "run",
    "run_to_file",
    "study_to_json",
    "study_to_toml",
]


def __getattr__(name: str) -> object:
    """Import what needs xarray when it is first used."""
    if name != "load_result":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from rolamento.studies.dataset import load_result

    return load_result
