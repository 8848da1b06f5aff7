"""What stands on figures of life tests, in English and in Brazilian Portuguese."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

__all__ = ["WeibullPlotWords", "weibull_plot_words"]


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
