"""Life over a field of a case: by every theory, in hours."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from rolamento.plots.axes_units import read_values
from rolamento.plots.frame import GREY, add_title, empty_frame, legend_above
from rolamento.plots.life_words import LifeWords, life_words
from rolamento.plots.over_field import across, decades, judged_line, short_label
from rolamento.plots.style import new_figure, series, styled
from rolamento.plots.words import PlotWords, plot_words

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.studies.life_curves import LifeCurve

__all__ = ["in_order", "life_figure", "life_limits", "lives_by_theory", "theory_look"]

Floats = NDArray[np.float64]

_ORDER: Final = (
    "iso16281_modified",
    "iso281_modified",
    "iso16281",
    "iso281",
    "ioannides_harris",
    "l_able",
    "iso281_1990",
)
"""Of colours, so that a theory looks the same on every figure."""
_BOUND: Final = "ioannides_harris"
_ABOVE: Final = 10.0
"""How far an upper bound may lead the axis beyond the other theories."""
_ROOM: Final = 1.5
_VARIANTS: Final[tuple[Any, ...]] = ("-", "--", ":", "-.", (0, (5, 1, 1, 1)), (0, (7, 2)))
_HOUR: Final = 3600.0


def life_figure(curves: Sequence[LifeCurve], language: str = "en") -> Figure:
    """Draw life over a field, with the case's title.

    Parameters
    ----------
    curves
        The case's own first, then its variants; over one field.
    language
        ``"en"`` or ``"pt"``.
    """
    with styled():
        figure, axes = new_figure(height=110.0)
        lives_by_theory(curves, axes, language=language)
        if curves[0].case.title:
            add_title(figure, curves[0].case.title)
    return figure


def lives_by_theory(
    curves: Sequence[LifeCurve], axes: Axes | None = None, *, language: str = "en"
) -> Axes:
    """Draw the life by every theory, faintly where it does not hold; of variants what leads.

    Lives are in hours, or in millions of revolutions where nothing turns at any point. An endless
    life leaves the frame at the top; a point without a result has a cross at its foot.

    Parameters
    ----------
    curves
        As in `life_figure`.
    axes
        To draw on; of a new figure if not given.
    language
        ``"en"`` or ``"pt"``.
    """
    shared, words = plot_words(language), life_words(language)
    with styled():
        axes = new_figure(height=110.0)[1] if axes is None else axes
        own = curves[0]
        turns = any(not np.isnan(life).all() for life in own.lives.values())
        lines = list(_lines(curves, turns, words))
        limits = life_limits((life, theory) for life, _, theory, _, _ in lines)
        if limits is None:
            endless = any(np.isposinf(life).any() for life, *_ in lines)
            return empty_frame(axes, words.endless if endless else shared.no_result)
        x, faint = read_values(own.over.field, own.values)[0], False
        for life, holds, _, name, look in lines:
            beyond = not np.any(life < limits[1])
            shown = words.above.format(name=name) if beyond else name
            faint |= judged_line(axes, x, life, holds, shown, look)
        if turns and own.case.life is not None and own.case.life.wanted_life is not None:
            wanted = own.case.life.wanted_life / _HOUR
            axes.axhline(wanted, color=GREY, linewidth=0.9, label=words.wanted)
            limits = min(limits[0], wanted / _ROOM), max(limits[1], wanted * _ROOM)
        _mark_missing(axes, x, own, shared)
        across(axes, own.over.field, own.values, words.fields, shared)
        decades(axes, "y", limits, shared)
        axes.set_ylabel(words.life if turns else words.revolutions, parse_math=False)
        legend_above(axes, title=words.faint if faint else "")
    return axes


def theory_look(theory: str) -> dict[str, Any]:
    """Return the colour and line of a theory, the same on every figure."""
    place = _ORDER.index(theory) if theory in _ORDER else len(_ORDER)
    return series(place).keywords()


def in_order(theories: Iterable[str]) -> list[str]:
    """Return theories in the order in which figures list them."""
    return sorted(theories, key=lambda t: _ORDER.index(t) if t in _ORDER else len(_ORDER))


def life_limits(lives: Iterable[tuple[Floats, str]]) -> tuple[float, float] | None:
    """Return how far an axis of lives goes; None if there is none.

    An upper bound, decades above all others, leads it a little, and not at all from far away.
    """
    known = [(life[np.isfinite(life) & (life > 0.0)], theory) for life, theory in lives]
    known = [(life, theory) for life, theory in known if life.size]
    if not known:
        return None
    others = [life for life, theory in known if theory != _BOUND]
    least = min(float(life.min()) for life, _ in known)
    most = max(float(life.max()) for life, _ in known)
    if others:
        highest = max(float(life.max()) for life in others)
        near = any(life.min() < _ABOVE * highest for life, theory in known if theory == _BOUND)
        most = min(most, _ABOVE * highest if near else highest)
    return least / _ROOM, most * _ROOM


def _lines(
    curves: Sequence[LifeCurve], turns: bool, words: LifeWords
) -> Iterable[tuple[Floats, NDArray[np.bool_], str, str, dict[str, Any]]]:
    """Life, where it holds, theory, name and look of every line."""

    def found(curve: LifeCurve, theory: str) -> tuple[Floats, NDArray[np.bool_]]:
        lives = curve.lives if turns else curve.revolutions
        return lives[theory], curve.holds[theory]

    for theory in in_order(curves[0].lives):
        name = words.theories.get(theory, theory)
        yield (*found(curves[0], theory), theory, name, theory_look(theory))
    for number, curve in enumerate(curves[1:], start=1):
        leading = curve.headline
        names = dict.fromkeys(theory for theory in leading.theory.tolist() if theory)
        look = {"color": "#000000", "linestyle": _VARIANTS[number % len(_VARIANTS)]}
        theories = " / ".join(words.theories[theory] for theory in names)
        led = leading.hours if turns else leading.life
        label = f"{theories}, {short_label(curve.label)}"
        yield (led, leading.holds, next(iter(names), ""), label, look)


def _mark_missing(axes: Axes, x: Floats, curve: LifeCurve, shared: PlotWords) -> None:
    missing = curve.status != "converged"
    if missing.any():
        axes.plot(
            x[missing],
            np.full(int(missing.sum()), 0.02),
            transform=axes.get_xaxis_transform(),
            color=GREY,
            linestyle="",
            marker="x",
            label=shared.no_result_count.format(count=int(missing.sum()), total=len(missing)),
        )
