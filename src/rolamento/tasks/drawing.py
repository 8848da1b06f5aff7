"""A figure of results in files: the JSON of states, or the NetCDF files of studies."""

from __future__ import annotations

import os
from collections.abc import Sequence
from enum import StrEnum
from typing import TYPE_CHECKING, Final

from rolamento.errors import InputError
from rolamento.records import frozen
from rolamento.validate import one_of
from rolamento.words import said

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from xarray import Dataset

    from rolamento.case.variant import Variant
    from rolamento.charts.contacts import QuantityName
    from rolamento.solved import Solved

__all__ = ["Drawing", "Kind", "draw"]

_HDF5: Final = b"\x89HDF\r\n\x1a\n"
_STUDY_ENDINGS: Final = (".nc", ".nc4", ".h5", ".hdf5")
_STANDARD_INPUT: Final = "-"


class Kind(StrEnum):
    """What can be drawn: of a state, the last two of rollers; four of its life; then of a study."""

    rosette = "rosette"
    balls = "balls"
    angles = "angles"
    pressures = "pressures"
    ellipses = "ellipses"
    along = "along"
    between = "between"
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
_OF_CONTACTS: Final[dict[Kind, QuantityName]] = {
    Kind.balls: "load",
    Kind.angles: "contact_angle",
    Kind.pressures: "max_pressure",
}
_OF_SEVERAL: Final = (*_OF_CONTACTS, Kind.along)
_MOST_FILES: Final = 7
_OF_STATES: Final = tuple(kind for kind in Kind if kind not in _OF_STUDIES)


@frozen(eq=False)
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
    result: str | os.PathLike[str] | Sequence[str | os.PathLike[str]],
    kind: Kind | str | None = None,
    *,
    variable: str | None = None,
    over: str | None = None,
    labels: Sequence[str] = (),
    variants: Sequence[Variant] = (),
) -> Drawing:
    """Draw a result, or several in one figure.

    Parameters
    ----------
    result
        The JSON of a state, as ``solve --json`` writes it (``"-"`` is standard input), or the
        NetCDF file of a study; or several of one or the other.
    kind
        Of a state: rosette (default), balls (loads over azimuth, of rollers too), angles,
        pressures, ellipses; of one with rollers: along (pressure along them), between (the most
        loaded one between the races); of its life: aiso (a_ISO), sn (life over load), zone (life
        over the load zone), helps (what would help); of a study: lines, map, histogram, scatter
        (default: what suits it). Several states: balls (default), angles, pressures, along;
        several studies: lines, histogram.
    variable
        The output of a study to draw.
    over
        The input of a study that runs across the figure.
    labels
        What to call several results; their titles, or their files' names, if not given.
    variants
        Of the case of the result: solved too, and drawn beside it.

    Raises
    ------
    InputError, FileError
        If a file cannot be read, or does not hold what is to be drawn, or the results share no
        figure.
    """
    from rolamento.charts.frame import add_title, figure_of

    if kind is not None:
        one_of(kind, "kind", Kind)
    one = isinstance(result, str | os.PathLike)
    paths = [os.fspath(result)] if one else [os.fspath(path) for path in result]  # type: ignore[arg-type,union-attr]
    wanted = None if kind is None else Kind(kind)
    _check_several(paths, labels)
    if _is_study(paths[0]):
        axes, title, failure = _of_studies(
            paths, wanted, variable or "", over or "", labels, variants
        )
    else:
        for name, given in (("variable", variable), ("over", over)):
            if given is not None:
                raise InputError(said("is for studies; this is a state"), field=name, value=given)
        if len(paths) > 1 or variants:
            axes, title, failure = _of_states(paths, wanted or Kind.balls, labels, variants)
        else:
            axes, title, failure = _of_state(paths[0], wanted or Kind.rosette)
    if title.strip():
        add_title(figure_of(axes), title)
    return Drawing(figure_of(axes), failure)


def _check_several(paths: Sequence[str], labels: Sequence[str]) -> None:
    """Refuse files that are none together, and labels that are not theirs."""
    if not 1 <= len(paths) <= _MOST_FILES:
        raise InputError(
            said("must be 1 to {most} files", most=_MOST_FILES), field="results", value=len(paths)
        )
    if labels and len(labels) != len(paths):
        raise InputError(
            said(
                "must be given once for each file: {files} files, {labels} labels",
                files=len(paths),
                labels=len(labels),
            ),
            field="labels",
            value=labels[-1],
        )
    if len(set(labels)) < len(labels):
        raise InputError(said("occurs twice"), field="labels", value=labels[-1])
    kinds = [_is_study(path) for path in paths]
    if len(set(kinds)) > 1:
        other = paths[kinds.index(not kinds[0])]
        raise InputError(
            said(
                "is {what}, and {first} is {other}: they share no figure",
                what=said("a study") if not kinds[0] else said("a state"),
                first=paths[0],
                other=said("a study") if kinds[0] else said("a state"),
            ),
            field="results",
            value=other,
        )


def _labelled(paths: Sequence[str], titles: Sequence[str], labels: Sequence[str]) -> list[str]:
    """Return what to call each of several results: their labels, titles, or files."""
    if labels:
        return list(labels)
    if all(titles) and len(set(titles)) == len(titles):
        return list(titles)
    names = [os.path.splitext(os.path.basename(path))[0] for path in paths]
    return names if len(set(names)) == len(names) else list(paths)


def _is_study(path: str) -> bool:
    """Recognise a study's file by its first bytes, or by its name if there are none to read."""
    if path == _STANDARD_INPUT:
        return False
    named = path.lower().endswith(_STUDY_ENDINGS)
    try:
        with open(path, "rb") as file:
            return named or file.read(len(_HDF5)) == _HDF5
    except (OSError, ValueError):
        return named  # whoever reads the whole file tells what is wrong


def _of_states(
    paths: Sequence[str], kind: Kind, labels: Sequence[str], variants: Sequence[Variant]
) -> tuple[Axes, str, str | None]:
    """Draw states in one frame, and the variants of each; return title and failure too."""
    from rolamento.plots.balls import compared_states
    from rolamento.plots.roller import compared_rollers
    from rolamento.solution import solve
    from rolamento.solved import Solved
    from rolamento.studies.names import setting_name

    _check(kind, _OF_SEVERAL, "several states")
    read = [Solved.read(path) for path in paths]
    names = _labelled(paths, [solved.title for solved in read], labels)
    states: dict[str, Solved] = {}
    for name, solved in zip(names, read, strict=True):
        if len(read) == 1 and not variants:
            states[name] = solved
            continue
        from rolamento.case.variant import AS_GIVEN, cases_compared

        compared = cases_compared(solved.case, variants) or {AS_GIVEN: solved.case}
        for variant, case in compared.items():
            parts = [name if len(read) > 1 else "", setting_name(variant) if variants else ""]
            own = solved if case is solved.case else solve(case)
            states[", ".join(part for part in parts if part)] = own
    failed = [solved for solved in states.values() if not solved.converged[0]]
    failure = str(failed[0].status.code[0]) if len(failed) == len(states) else None
    title = read[0].title if len({solved.title for solved in read}) == 1 else ""
    if kind is Kind.along:
        return compared_rollers(states), title, failure
    return compared_states(states, _OF_CONTACTS[kind]), title, failure


def _of_state(path: str, kind: Kind) -> tuple[Axes, str, str | None]:
    """Draw a state; return title and failure too."""
    from rolamento.charts.frame import empty_frame
    from rolamento.charts.style import new_figure
    from rolamento.charts.texts import no_result
    from rolamento.plots import balls, ellipses, roller
    from rolamento.solved import Solved

    solved = Solved.read(path)
    failure = None if solved.converged[0] else str(solved.status.code[0])
    _check(kind, _OF_STATES, "the JSON of a state")
    if kind is Kind.ellipses:
        axes: Axes = ellipses.ellipses_of_both_races(solved)[0]
    elif kind is Kind.along:
        axes = roller.pressures_of_both_races(solved)[0]
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
            Kind.between: roller.roller_between_races,
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
            example='[life] cleanliness = "-/17/14", oil_supply = "circulating"',
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
            field="kind",
            value=kind.value,
            example="[life] viscosity_ratio = 1.5, contamination = 0.5",
        )
    return figures.aiso_chart(summary)


def _of_studies(
    paths: Sequence[str],
    kind: Kind | None,
    variable: str,
    over: str,
    labels: Sequence[str],
    variants: Sequence[Variant],
) -> tuple[Axes, str, str | None]:
    """Draw studies; return title and failure too."""
    from rolamento.plots import study, sweep
    from rolamento.studies.dataset import load_result

    read = [load_result(path) for path in paths]
    if variants:
        read = [_with_variants(data, variants) for data in read]
    if len(read) > 1:
        _check_common(read, paths, variable)
    data = read[0]
    chosen = kind or Kind(sweep.telling_kind(data, variable))
    several = len(read) > 1
    if several and kind is None and chosen is Kind.map:
        chosen = Kind.lines
    possible = (Kind.lines, Kind.histogram) if several else _OF_STUDIES
    _check(chosen, possible, "several studies" if several else "a study")
    if kind is None and over and chosen is Kind.histogram and not several:
        chosen = Kind.scatter
    titles = [str(one.attrs.get("title", "")) for one in read]
    named = dict(zip(_labelled(paths, titles, labels) if several else [""], read, strict=True))
    if chosen is Kind.histogram:
        if over:
            raise InputError(said("cannot be combined with a histogram"), field="over", value=over)
        axes = sweep.compared_histograms(named, variable)
    elif chosen is Kind.lines:
        axes = sweep.compared_lines(named, variable, over=over)
    else:
        drawers = {Kind.map: sweep.study_map, Kind.scatter: sweep.study_scatter}
        axes = drawers[chosen](data, variable, over=over)
    name = variable or study.most_telling(data)
    has_result = any(study.has_result(one, name) for one in read)
    title = titles[0] if len(set(titles)) == 1 else ""
    return axes, title, None if has_result else study.common_failure(data)


def _with_variants(data: Dataset, variants: Sequence[Variant]) -> Dataset:
    """Run the study of a result again, with variants beside its case."""
    from rolamento.studies.runner import run
    from rolamento.studies.study import parse_study
    from rolamento.tasks.studies import with_variants

    study = parse_study(str(data.attrs["study"]), format="toml")
    return run(with_variants(study, variants))


def _check_common(read: Sequence[Dataset], paths: Sequence[str], variable: str) -> None:
    """Refuse studies without an output in common, or without the one that is asked for."""
    from rolamento.plots.study import most_telling, outputs

    name = variable or most_telling(read[0])
    for data, path in zip(read, paths, strict=True):
        if name in outputs(data):
            continue
        common = [one for one in outputs(read[0]) if all(one in outputs(d) for d in read)]
        known = ", ".join(common[:8])
        raise InputError(
            said("has no {name}; outputs in common: {known}", name=name, known=known)
            if common
            else said("has no output in common with {first}", first=paths[0]),
            field="variable",
            source=path,
        )


def _check(kind: Kind, possible: tuple[Kind, ...], what: str) -> None:
    if kind not in possible:
        raise InputError(
            said(
                "does not suit {what}; possible: {possible}",
                what=what,
                possible=", ".join(possible),
            ),
            field="kind",
            value=kind.value,
        )
