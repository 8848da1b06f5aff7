"""What stands on figures of life tests, in English and in Brazilian Portuguese; their legends."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from rolamento.plots.frame import legend_above, shown_text

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

__all__ = ["WeibullPlotWords", "legend_in_columns", "weibull_plot_words"]

_HALF_LINE: Final = 42
"""Characters of a label of which two stand side by side."""


@dataclass(frozen=True, slots=True, kw_only=True)
class WeibullPlotWords:
    """The words of one language; `{…}` are filled in. fits by the engine's names of methods."""

    failed_share: str
    time: str
    shape: str
    life: str
    scale: str
    of_failed: str
    bounds: str
    lower_bound: str
    suspended: str
    inspected: str
    calculated: str
    fits: Mapping[str, str]
    region: str
    drawn: str
    chi_square: str
    rating_shape: str


_ENGLISH: Final = WeibullPlotWords(
    failed_share="Failed (%)",
    time="Time ({unit})",
    shape="Shape β",
    life="{life} ({unit})",
    scale="Scale η ({unit})",
    of_failed="{failed}/{size} failed",
    bounds="{confidence} % bounds",
    lower_bound="lower bound ({confidence} %)",
    suspended="suspended",
    inspected="failed between inspections",
    calculated="calculated {life}: {name}",
    fits={
        "maximum_likelihood": "maximum likelihood",
        "unbiased": "shape unbiased",
        "rank_regression_x_on_y": "rank regression, X on Y",
        "rank_regression_y_on_x": "rank regression, Y on X",
        "three_parameter": "three parameters",
        "fixed_shape": "known shape",
    },
    region="{probability} %",
    drawn="regions of equal likelihood, with drawn levels",
    chi_square="regions of equal likelihood, for many failures",
    rating_shape="10/9 of the rating standards",
)

_PORTUGUESE: Final = WeibullPlotWords(
    failed_share="Falharam (%)",
    time="Tempo ({unit})",
    shape="Forma β",
    life="{life} ({unit})",
    scale="Escala η ({unit})",
    of_failed="{failed}/{size} falharam",
    bounds="limites de {confidence} %",
    lower_bound="limite inferior ({confidence} %)",
    suspended="suspensos",
    inspected="falharam entre inspeções",
    calculated="{life} calculada: {name}",
    fits={
        "maximum_likelihood": "máxima verossimilhança",
        "unbiased": "forma sem viés",
        "rank_regression_x_on_y": "regressão de postos, X em Y",
        "rank_regression_y_on_x": "regressão de postos, Y em X",
        "three_parameter": "três parâmetros",
        "fixed_shape": "forma conhecida",
    },
    region="{probability} %",
    drawn="regiões de igual verossimilhança, com níveis sorteados",
    chi_square="regiões de igual verossimilhança, para muitas falhas",
    rating_shape="10/9 das normas",
)


def weibull_plot_words(code: str) -> WeibullPlotWords:
    """Return a language by its code, ``"en"`` or ``"pt"``; English for any other."""
    return _PORTUGUESE if code == "pt" else _ENGLISH


def legend_in_columns(axes: Axes, handles: Sequence[Artist] = (), title: str = "") -> None:
    """Put the legend over the frame, in two columns where its labels are short enough.

    handles: what to show, with labels of their own; all that is drawn if not given.
    """
    shown = handles or axes.get_legend_handles_labels()[0]
    longest = max((len(shown_text(str(handle.get_label()), 60)) for handle in shown), default=0)
    legend_above(axes, handles=shown, title=title, columns=2 if longest <= _HALF_LINE else None)
