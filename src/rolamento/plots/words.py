"""What stands on figures, in English and in Brazilian Portuguese."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

__all__ = ["ENGLISH", "PORTUGUESE", "PlotWords", "plot_words"]

_STIFFNESS: Final = re.compile(r"stiffness_(r?[xyz])(r?[xyz])")


@dataclass(frozen=True, slots=True)
class PlotWords:
    """The words of one language; `names` says what variables of a study are."""

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
    names: Mapping[str, str]

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
            What the study's file calls it, in English; goes before the English names.
        """
        known = self.names.get(variable, "")
        if not known and (match := _STIFFNESS.fullmatch(variable)):
            known = f"{self.stiffness} {match[1]}–{match[2]}"
        said = long_name or known if self.code == "en" else known or long_name
        said = said or variable.replace("_", " ")
        return said[:1].upper() + said[1:]


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
        "invalid_input": "invalid input",
    },
    median="median",
    percentile_band="{least} % to {most} %",
    share="Share of the samples",
    written="Wrote {path}",
    names={
        "x": "axial displacement x",
        "y": "displacement y",
        "z": "radial displacement z",
        "ry": "tilt about y",
        "rz": "tilt about z",
        "fx": "axial load Fx",
        "fy": "load Fy",
        "fz": "radial load Fz",
        "my": "moment My",
        "mz": "moment Mz",
        "inner_speed": "speed of the inner ring",
        "outer_speed": "speed of the outer ring",
        "first_ball_azimuth": "azimuth of the first ball",
        "max_inner_load": "greatest load on an inner contact",
        "max_outer_load": "greatest load on an outer contact",
        "max_inner_max_pressure": "greatest pressure on the inner race",
        "max_outer_max_pressure": "greatest pressure on the outer race",
        "ball": "ball",
        "sample": "sample",
    },
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
        "invalid_input": "entrada inválida",
    },
    median="mediana",
    percentile_band="{least} % a {most} %",
    share="Parcela das amostras",
    written="{path} gravado",
    names={
        "x": "deslocamento axial x",
        "y": "deslocamento y",
        "z": "deslocamento radial z",
        "ry": "inclinação em torno de y",
        "rz": "inclinação em torno de z",
        "fx": "carga axial Fx",
        "fy": "carga Fy",
        "fz": "carga radial Fz",
        "my": "momento My",
        "mz": "momento Mz",
        "inner_speed": "rotação do anel interno",
        "outer_speed": "rotação do anel externo",
        "first_ball_azimuth": "azimute da primeira esfera",
        "max_inner_load": "maior carga em um contato interno",
        "max_outer_load": "maior carga em um contato externo",
        "max_inner_max_pressure": "maior pressão na pista interna",
        "max_outer_max_pressure": "maior pressão na pista externa",
        "ball_count": "número de esferas",
        "ball_diameter": "diâmetro da esfera",
        "pitch_diameter": "diâmetro primitivo",
        "contact_angle": "ângulo de contato livre",
        "diametral_clearance": "folga diametral",
        "inner_conformity": "conformidade interna",
        "outer_conformity": "conformidade externa",
        "spacing": "distância entre carreiras",
        "preload": "pré-carga",
        "ball": "esfera",
        "sample": "amostra",
    },
)

_LANGUAGES: Final[Mapping[str, PlotWords]] = {w.code: w for w in (ENGLISH, PORTUGUESE)}


def plot_words(code: str) -> PlotWords:
    """Return a language by its code, ``"en"`` or ``"pt"``; English for any other."""
    return _LANGUAGES.get(code, ENGLISH)
