"""A figure of a result in a file: the JSON of a state, or the NetCDF file of a study."""

from __future__ import annotations

import os
from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING, Final

from rolamento.errors import InputError
from rolamento.words import said

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from rolamento.solved import Solved

__all__ = ["Drawing", "Kind", "draw"]

_HDF5: Final = b"\x89HDF\r\n\x1a\n"
_STUDY_ENDINGS: Final = (".nc", ".nc4", ".h5", ".hdf5")
_STANDARD_INPUT: Final = "-"


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
_OF_STUDIES: Final = (Kind.lines, Kind.map, Kind.histogram, Kind.scatter)
_OF_STATES: Final = tuple(kind for kind in Kind if kind not in _OF_STUDIES)


@dataclass(frozen=True, slots=True, eq=False)
class Drawing:
    """A figure.

    Attributes
    ----------
    figure
        to be saved with `rolamento.plots.save_figure`
    failure
        why there is no result to be seen in it, as the code of a status; None if there is one
    """

    figure: Figure
    failure: str | None


def draw(
    result: str | os.PathLike[str],
    kind: Kind | str | None = None,
    *,
    variable: str | None = None,
    over: str | None = None,
) -> Drawing:
    """Draw a result.

    Parameters
    ----------
    result
        The JSON of a state, as ``solve --json`` writes it (``"-"`` is standard input), or the
        NetCDF file of a study.
    kind
        Of a state: rosette (default), balls, angles, pressures, ellipses; of its life: aiso
        (a_ISO), sn (life over load), zone (life over the load zone), helps (what would help); of
        a study: lines, map, histogram, scatter (default: what suits it).
    variable
        The output of a study to draw.
    over
        The input of a study that runs across the figure.

    Raises
    ------
    InputError, FileError
        If the file cannot be read, or does not hold what is to be drawn.
    """
    from rolamento.plots.frame import add_title, figure_of

    if kind is not None and kind not in list(Kind):
        raise InputError(
            said("must be one of {known}", known=", ".join(Kind)), field="--kind", value=kind
        )
    wanted, path = None if kind is None else Kind(kind), str(result)
    if _is_study(path):
        axes, title, failure = _of_study(path, wanted, variable or "", over or "")
    else:
        for name, given in (("--variable", variable), ("--over", over)):
            if given is not None:
                raise InputError(said("is for studies; this is a state"), field=name, value=given)
        axes, title, failure = _of_state(path, wanted or Kind.rosette)
    if title.strip():
        add_title(figure_of(axes), title)
    return Drawing(figure_of(axes), failure)


def _is_study(path: str) -> bool:
    """Tell a study's file by its first bytes, or by its name if there are none to read."""
    if path == _STANDARD_INPUT:
        return False
    named = path.lower().endswith(_STUDY_ENDINGS)
    try:
        with open(path, "rb") as file:
            return named or file.read(len(_HDF5)) == _HDF5
    except (OSError, ValueError):
        return named  # whoever reads the whole file tells what is wrong


def _of_state(path: str, kind: Kind) -> tuple[Axes, str, str | None]:
    """Draw a state; return title and failure too."""
    from rolamento.plots import balls, ellipses
    from rolamento.plots.frame import empty_frame, no_result
    from rolamento.plots.style import new_figure
    from rolamento.solved import Solved

    solved = Solved.read(path)
    failure = None if solved.converged[0] else str(solved.status.code[0])
    _check(kind, _OF_STATES, "the JSON of a state")
    if kind is Kind.ellipses:
        axes: Axes = ellipses.ellipses_of_both_races(solved)[0]
    elif kind in _OF_LIFE and failure is not None:
        axes = empty_frame(new_figure()[1], no_result(failure))
    elif kind in _OF_LIFE:
        axes = _of_life(kind, solved)
    else:
        drawers = {
            Kind.rosette: balls.load_rosette,
            Kind.balls: balls.ball_loads,
            Kind.angles: balls.contact_angles,
            Kind.pressures: balls.pressures,
        }
        axes = drawers[kind](solved)
    return axes, solved.title, failure


def _of_life(kind: Kind, solved: Solved) -> Axes:
    """Draw the life of a state."""
    from rolamento.analysis.needs import has_life
    from rolamento.life import life, sensitivity
    from rolamento.plots import life as figures
    from rolamento.tasks.life_over import lives_over_load, lives_over_zone

    if not has_life(solved.case):
        raise InputError(
            said("is missing: figures of life need it, or a bearing with a designation"),
            field="case.life",
            example='[life] with cleanliness = "-/17/14" and oil_supply = "circulating"',
        )
    if kind is Kind.sn:
        return figures.load_over_life(lives_over_load(solved))
    if kind is Kind.zone:
        return figures.life_over_zone(lives_over_zone(solved))
    if kind is Kind.helps:
        return figures.what_helps(sensitivity(solved))
    summary = life(solved, stress_volume=False)
    if summary.contamination_factor is None:
        raise InputError(
            said(
                "needs a viscosity ratio, or a lubricant and its temperature, and the "
                "oil cleanliness"
            ),
            field="--kind",
            value=kind.value,
            example="[life] with viscosity_ratio = 1.5 and contamination = 0.5",
        )
    return figures.aiso_chart(summary)


def _of_study(
    path: str, kind: Kind | None, variable: str, over: str
) -> tuple[Axes, str, str | None]:
    """Draw a study; return title and failure too."""
    from rolamento.plots import study, sweep
    from rolamento.studies.dataset import load_result

    data = load_result(path)
    chosen = kind or Kind(sweep.telling_kind(data, variable))
    _check(chosen, _OF_STUDIES, "a study")
    if kind is None and over and chosen is Kind.histogram:
        chosen = Kind.scatter
    if chosen is Kind.histogram:
        if over:
            raise InputError(
                said("cannot be combined with a histogram"), field="--over", value=over
            )
        axes = sweep.study_histogram(data, variable)
    else:
        drawers = {
            Kind.lines: sweep.study_lines,
            Kind.map: sweep.study_map,
            Kind.scatter: sweep.study_scatter,
        }
        axes = drawers[chosen](data, variable, over=over)
    has_result = study.has_result(data, variable or study.most_telling(data))
    return (
        axes,
        str(data.attrs.get("title", "")),
        None if has_result else study.common_failure(data),
    )


def _check(kind: Kind, possible: tuple[Kind, ...], what: str) -> None:
    if kind not in possible:
        raise InputError(
            said(
                "does not suit {what}; possible: {possible}",
                what=what,
                possible=", ".join(possible),
            ),
            field="--kind",
            value=kind.value,
        )
