"""What stands on figures, in English and in Brazilian Portuguese."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from rolamento.plots.variable_names import variable_name

__all__ = ["ENGLISH", "PORTUGUESE", "PlotWords", "plot_words"]


@dataclass(frozen=True, slots=True)
class PlotWords:
    """The words of one language."""

    code: str
    decimal_mark: str
    azimuth: str
    ball_load: str
    contact_angle: str
    max_pressure: str
    inner: str
    outer: str
    row: str
    free_angle: str
    seen_from: str
    across_inner: str
    across_outer: str
    side_by_side: str
    ellipse: str
    groove_edge: str
    over_edge: str
    stiffness: str
    inner_speed: str
    all_balls: str
    no_result: str
    no_result_count: str
    reasons: Mapping[str, str]
    median: str
    percentile_band: str
    share: str
    written: str

    def reason(self, code: str) -> str:
        """Say why there is no result."""
        said = self.reasons.get(code, code)
        return f"{self.no_result}: {said}" if said else self.no_result

    def name(self, variable: str, long_name: str = "") -> str:
        """Say what a variable of a study is.

        Parameters
        ----------
        variable
            Its name in the study.
        long_name
            What the study's file calls it, in English, for variables that nobody knows here.
        """
        known = variable_name(variable, self.code) or long_name or variable.replace("_", " ")
        return known[:1].upper() + known[1:]


ENGLISH: Final = PlotWords(
    code="en",
    decimal_mark=".",
    azimuth="Azimuth of the ball",
    ball_load="Contact load",
    contact_angle="Contact angle",
    max_pressure="Greatest contact pressure",
    inner="inner",
    outer="outer",
    row="row {number}",
    free_angle="free (unloaded)",
    seen_from="seen from +x",
    across_inner="Across inner groove",
    across_outer="Across outer groove",
    side_by_side="ellipses to scale, balls side by side",
    ellipse="contact ellipse",
    groove_edge="edge of the groove",
    over_edge="ellipse over the edge",
    stiffness="Stiffness",
    inner_speed="Speed of the inner ring",
    all_balls="all balls",
    no_result="No result",
    no_result_count="no result: {count} of {total}",
    reasons={
        "no_equilibrium": "there is no equilibrium",
        "not_converged": "not converged",
        "overloaded": "overloaded",
        "unheld_ball": "a ball is not held",
        "over_shoulder": "a ball rides over the shoulder",
        "invalid_input": "invalid input",
    },
    median="median",
    percentile_band="{least} % to {most} %",
    share="Share of the samples",
    written="Wrote {path}",
)

PORTUGUESE: Final = PlotWords(
    code="pt",
    decimal_mark=",",
    azimuth="Azimute da esfera",
    ball_load="Carga no contato",
    contact_angle="Ângulo de contato",
    max_pressure="Pressão máxima de contato",
    inner="interno",
    outer="externo",
    row="carreira {number}",
    free_angle="livre (sem carga)",
    seen_from="visto de +x",
    across_inner="Através da pista interna",
    across_outer="Através da pista externa",
    side_by_side="elipses em escala, esferas lado a lado",
    ellipse="elipse de contato",
    groove_edge="borda da pista",
    over_edge="elipse além da borda",
    stiffness="Rigidez",
    inner_speed="Rotação do anel interno",
    all_balls="todas as esferas",
    no_result="Sem resultado",
    no_result_count="sem resultado: {count} de {total}",
    reasons={
        "no_equilibrium": "não há equilíbrio",
        "not_converged": "não convergiu",
        "overloaded": "sobrecarga",
        "unheld_ball": "uma esfera não é segurada",
        "over_shoulder": "uma esfera passa do rebordo da pista",
        "invalid_input": "entrada inválida",
    },
    median="mediana",
    percentile_band="{least} % a {most} %",
    share="Parcela das amostras",
    written="{path} gravado",
)

_LANGUAGES: Final[Mapping[str, PlotWords]] = {w.code: w for w in (ENGLISH, PORTUGUESE)}


def plot_words(code: str) -> PlotWords:
    """Return a language by its code, ``"en"`` or ``"pt"``; English for any other."""
    return _LANGUAGES.get(code, ENGLISH)
