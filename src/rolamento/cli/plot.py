"""The command that draws: a state's JSON or a study's file, as PNG, SVG or PDF."""

from __future__ import annotations

import os
from enum import StrEnum
from typing import TYPE_CHECKING, Annotated, Final

import typer

from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    Language,
    plain_endings,
    words_of,
)
from rolamento.cli.options import LanguageOption
from rolamento.cli.outputs import check_outputs
from rolamento.cli.streams import STANDARD_STREAM, complain, print_text
from rolamento.errors import InputError

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.case import Case
    from rolamento.plots.words import PlotWords

__all__ = ["Kind", "plot"]

_HDF5: Final = b"\x89HDF\r\n\x1a\n"
_STUDY_ENDINGS: Final = (".nc", ".nc4", ".h5", ".hdf5")


class Kind(StrEnum):
    """What can be drawn: the first five of a state, then four of its life, then of a study."""

    rosette = "rosette"
    balls = "balls"
    angles = "angles"
    pressures = "pressures"
    ellipses = "ellipses"
    aiso = "aiso"
    sn = "sn"
    zone = "zone"
    helps = "helps"
    lines = "lines"
    map = "map"
    histogram = "histogram"
    scatter = "scatter"


_OF_LIFE: Final = (Kind.aiso, Kind.sn, Kind.zone, Kind.helps)
_OF_STATES: Final = (
    Kind.rosette,
    Kind.balls,
    Kind.angles,
    Kind.pressures,
    Kind.ellipses,
    *_OF_LIFE,
)
_OF_STUDIES: Final = tuple(kind for kind in Kind if kind not in _OF_STATES)


def plot(
    result: Annotated[
        str,
        typer.Argument(
            metavar="RESULT",
            help="What to draw: the JSON of a state (solve --json), - for standard input, or the "
            "NetCDF file of a study.",
        ),
    ],
    kind: Annotated[
        Kind | None,
        typer.Option(
            metavar="KIND",
            help="Of a state: rosette (default), balls, angles, pressures, ellipses; of its life: "
            "aiso (a_ISO), sn (life over load), zone (life over the load zone), helps (what would "
            "help); of a study: lines, map, histogram, scatter (default: what suits it).",
        ),
    ] = None,
    variable: Annotated[
        str | None, typer.Option(metavar="NAME", help="The output of a study to draw.")
    ] = None,
    over: Annotated[
        str | None,
        typer.Option(metavar="NAME", help="The input of a study that runs across the figure."),
    ] = None,
    output: Annotated[
        str | None,
        typer.Option(
            "--output",
            "-o",
            metavar="FILE",
            help="Ends in .png, .svg or .pdf; by default RESULT's name with .png, in this folder.",
        ),
    ] = None,
    lang: LanguageOption = None,
) -> None:
    """Draw a result: a state, its life, or a study.

    Ball loads, angles, pressures, ellipses, life, sweeps, distributions.
    """
    with plain_endings(lang):
        from rolamento.plots.saving import check_name

        target = _default_name(result) if output is None else output
        check_name(target)
        check_outputs({"--output": target}, result, rule="is the result itself")
        if _is_study(result):
            code = _plot_study(result, kind, variable or "", over or "", target, lang)
        else:
            code = _plot_state(result, kind, variable, over, target, lang)
    raise typer.Exit(code)


def _default_name(result: str) -> str:
    if result == STANDARD_STREAM:
        return "state.png"
    name = os.path.splitext(os.path.basename(result))[0].strip(".")
    return f"{name or 'figure'}.png"


def _is_study(path: str) -> bool:
    """Tell a study's file by its first bytes, or by its name if there are none to read."""
    if path == STANDARD_STREAM:
        return False
    try:
        if os.path.isfile(path):
            with open(path, "rb") as file:
                return file.read(len(_HDF5)) == _HDF5 or _named_as_study(path)
    except (OSError, ValueError):
        pass  # whoever reads the whole file tells what is wrong
    return _named_as_study(path)


def _named_as_study(path: str) -> bool:
    return path.lower().endswith(_STUDY_ENDINGS)


def _plot_state(
    result: str,
    kind: Kind | None,
    variable: str | None,
    over: str | None,
    target: str,
    lang: Language | None,
) -> int:
    """Draw a state; return the exit code."""
    from rolamento.plots import balls, ellipses, reading, rosette
    from rolamento.plots.frame import empty_frame
    from rolamento.plots.style import new_figure

    for name, given in (("--variable", variable), ("--over", over)):
        if given is not None:
            raise InputError("is for studies; this is a state", field=name, value=given)
    words = _plot_words(lang)
    state = reading.read_state(result)
    chosen = _checked(kind or Kind.rosette, _OF_STATES, "the JSON of a state")
    if chosen is Kind.ellipses:
        axes: Axes = ellipses.ellipses_of_both_races(state, words=words)[0]
    elif chosen in _OF_LIFE and state.status.converged:
        axes = _life(chosen, state.case, words.code)
    elif chosen in _OF_LIFE:
        axes = empty_frame(new_figure()[1], words.reason(state.status.code))
    else:
        draw = {
            Kind.rosette: rosette.load_rosette,
            Kind.balls: balls.ball_loads,
            Kind.angles: balls.contact_angles,
            Kind.pressures: balls.pressures,
        }[chosen]
        axes = draw(state, words=words)
    _write(axes, state.title, target, words)
    if state.status.converged:
        return SOLVED
    complain(words.reason(state.status.code))
    return NO_RESULT


def _life(kind: Kind, case: Case | None, language: str) -> Axes:
    """Draw the life of a state; its case is solved again, for a file does not hold all of it."""
    from rolamento.analysis.needs import has_life
    from rolamento.life import life, sensitivity
    from rolamento.plots import life as figures
    from rolamento.solution import solve
    from rolamento.tasks.life_over import lives_over_load, lives_over_zone

    if case is None:
        raise InputError(
            "is missing: figures of life need the case; solve it with this release to write it "
            "into the JSON",
            field="case",
            example="rolamento solve case.toml --json state.json",
        )
    if not has_life(case):
        raise InputError(
            "is missing: figures of life need it, or a bearing with a designation",
            field="case.life",
            example='[life] with cleanliness = "-/17/14" and oil_supply = "circulating"',
        )
    state = solve(case)
    if kind is Kind.sn:
        return figures.load_over_life(lives_over_load(state), language=language)
    if kind is Kind.zone:
        return figures.life_over_zone(lives_over_zone(state), language=language)
    if kind is Kind.helps:
        return figures.what_helps(sensitivity(state), language=language)
    summary = life(state, stress_volume=False)
    if summary.contamination_factor is None:
        raise InputError(
            "needs a viscosity ratio, or a lubricant and its temperature, and the cleanliness of "
            "the oil",
            field="--kind",
            value=kind.value,
            example="[life] with viscosity_ratio = 1.5 and contamination = 0.5",
        )
    return figures.aiso_chart(summary, language=language)


def _plot_study(
    result: str, kind: Kind | None, variable: str, over: str, target: str, lang: Language | None
) -> int:
    """Draw a study; return the exit code."""
    from rolamento.plots import samples, study, sweep
    from rolamento.studies.dataset import load_result

    words = _plot_words(lang)
    data = load_result(result)
    chosen = _checked(kind or Kind(sweep.telling_kind(data, variable)), _OF_STUDIES, "a study")
    if kind is None and over and chosen is Kind.histogram:
        chosen = Kind.scatter
    if chosen is Kind.histogram:
        if over:
            raise InputError("does not go with a histogram", field="--over", value=over)
        axes = samples.study_histogram(data, variable, words=words)
    else:
        draw = {
            Kind.lines: sweep.study_lines,
            Kind.map: sweep.study_map,
            Kind.scatter: samples.study_scatter,
        }[chosen]
        axes = draw(data, variable, over=over, words=words)
    _write(axes, str(data.attrs.get("title", "")), target, words)
    if study.has_result(data, variable or study.most_telling(data)):
        return SOLVED
    complain(words.reason(study.common_failure(data)))
    return NO_RESULT


def _checked(kind: Kind, possible: tuple[Kind, ...], what: str) -> Kind:
    if kind not in possible:
        raise InputError(
            f"does not go with {what}; possible are {', '.join(possible)}",
            field="--kind",
            value=kind.value,
        )
    return kind


def _plot_words(lang: Language | None) -> PlotWords:
    from rolamento.plots.words import plot_words

    return plot_words(words_of(lang).code)


def _write(axes: Axes, title: str, target: str, words: PlotWords) -> None:
    from rolamento.plots.frame import add_title, figure_of
    from rolamento.plots.saving import save_figure

    if title.strip():
        add_title(figure_of(axes), title)
    save_figure(axes, target)
    print_text(words.written.format(path=target) + "\n")
