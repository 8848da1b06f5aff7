"""Life over load, as a diagram of stress over cycles: every theory, the case, tests beside them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Final, Literal, NamedTuple

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import ArrayLike, NDArray

from rolamento.plots.axes_units import MEGAPASCAL
from rolamento.plots.frame import GREY, add_title, empty_frame, legend_above
from rolamento.plots.life import in_order, life_limits, theory_look
from rolamento.plots.life_words import LifeWords, life_words
from rolamento.plots.over_field import decades, judged_line
from rolamento.plots.style import SERIES, new_figure, styled
from rolamento.plots.words import plot_words

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.studies.life_diagram import LoadLives

__all__ = ["BearingTests", "load_over_life", "sn_figure"]

Floats = NDArray[np.float64]
By = Literal["load", "pressure"]

_ROOM: Final = 1.15
_BLACK: Final = "#000000"


class BearingTests(NamedTuple):
    """Bearings that ran: what they are called, how long and under what they ran, which failed.

    revolutions: millions; load: P/C, or Pa on a figure over pressure; failed: else they were
    taken off whole. Of each, (bearings,).
    """

    label: str
    revolutions: ArrayLike
    load: ArrayLike
    failed: ArrayLike


def sn_figure(
    lives: LoadLives, language: str = "en", *, by: By = "load", tests: Sequence[BearingTests] = ()
) -> Figure:
    """Draw life over load, as `load_over_life`, with the case's title."""
    with styled():
        figure, axes = new_figure(height=115.0)
        load_over_life(lives, axes, language=language, by=by, tests=tests)
        if lives.case.title:
            add_title(figure, lives.case.title)
    return figure


def load_over_life(
    lives: LoadLives,
    axes: Axes | None = None,
    *,
    language: str = "en",
    by: By = "load",
    tests: Sequence[BearingTests] = (),
) -> Axes:
    """Draw load over life by every theory: straight the basic one, bent those with a fatigue limit.

    Parameters
    ----------
    lives
        Of `rolamento.studies.life_diagram.lives_over_load`.
    axes
        To draw on; of a new figure if not given.
    language
        ``"en"`` or ``"pt"``.
    by
        Upright is P/C ("load"), or the greatest contact pressure ("pressure").
    tests
        Bearings that ran: filled marks of those that failed, hollow ones of the others.

    A line is faint where its theory does not hold; the case itself has a mark on each.
    """
    shared, words = plot_words(language), life_words(language)
    with styled():
        axes = new_figure(height=115.0)[1] if axes is None else axes
        upright = lives.load if by == "load" else MEGAPASCAL.of(lives.pressure)
        found = {name: record.life for name, record in lives.theories.items()}
        limits = life_limits((life, name) for name, life in found.items())
        if limits is None or not np.isfinite(upright).any():
            return empty_frame(axes, shared.no_result)
        faint = False
        for theory in in_order(found):
            record, name = lives.theories[theory], words.theories.get(theory, theory)
            faint |= _line(axes, found[theory], upright, record.holds, name, theory_look(theory))
        own = [life[lives.own] for life in found.values()]
        axes.plot(
            own, np.full(len(own), upright[lives.own]), label=words.own, color=_BLACK,
            marker="o", markerfacecolor="white", linestyle="", zorder=3.0,
        )  # fmt: skip
        for number, one in enumerate(tests):
            _tests(axes, one, number, by, words)
        if by == "load":
            axes.axhline(lives.fatigue_load, color=GREY, linewidth=0.9, label=words.fatigue_load)
        ran = np.array(
            [limits[0] * _ROOM, *(n for one in tests for n in np.ravel(one.revolutions))]
        )
        least = float(ran[ran > 0.0].min()) / _ROOM
        decades(axes, "x", (least, limits[1]), shared)
        decades(axes, "y", _upright_limits(lives, upright, by), shared)
        axes.set_xlabel(words.revolutions, parse_math=False)
        axes.set_ylabel(_upright_name(lives, by, words), parse_math=False)
        legend_above(axes, title=words.faint if faint else "")
    return axes


def _line(
    axes: Axes,
    life: Floats,
    upright: Floats,
    holds: NDArray[np.bool_],
    name: str,
    look: dict[str, Any],
) -> bool:
    """Draw load over life; what is without an end lies beyond the frame."""
    there = np.isfinite(life) & np.isfinite(upright)
    return judged_line(axes, life[there], upright[there], holds[there], name, look)


def _tests(axes: Axes, tests: BearingTests, number: int, by: By, words: LifeWords) -> None:
    look = SERIES[(number + 1) % len(SERIES)]
    ran, load = np.asarray(tests.revolutions, np.float64), np.asarray(tests.load, np.float64)
    upright = load if by == "load" else MEGAPASCAL.of(load)
    failed = np.asarray(tests.failed, np.bool_)
    for chosen, said, face in (
        (failed, words.failed, look.color),
        (~failed, words.standing, "white"),
    ):
        if chosen.any():
            axes.plot(
                ran[chosen], upright[chosen], label=f"{tests.label}: {said}",
                color=look.color, marker=look.marker, markerfacecolor=face, markersize=5.0,
                linestyle="", zorder=2.5,
            )  # fmt: skip


def _shortest(tests: BearingTests) -> float:
    ran = np.asarray(tests.revolutions, np.float64)
    return float(np.min(ran, initial=np.inf, where=ran > 0.0))


def _upright_limits(lives: LoadLives, upright: Floats, by: By) -> tuple[float, float]:
    known = upright[np.isfinite(upright)]
    least, most = float(known.min()), float(known.max())
    if by == "load":
        least = min(least, lives.fatigue_load)
    return least / _ROOM, most * _ROOM


def _upright_name(lives: LoadLives, by: By, words: LifeWords) -> str:
    if by == "pressure":
        return MEGAPASCAL.label(words.pressure)
    return words.reference_load if lives.by_reference else words.load
