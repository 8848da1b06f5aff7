"""What the variables of studies are called on axes, short enough to stand beside one."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from rolamento.case import Case

__all__ = ["torque_model_name", "variable_name"]

_STIFFNESS: Final = re.compile(r"stiffness_(r?[xyz])(r?[xyz])")
_OF_BALLS: Final = re.compile(r"(?:(max|min|mean)_)?(?:(inner|outer)_)?([a-z_]+)")


@dataclass(frozen=True, slots=True)
class _Names:
    """Names in one language: whole ones, and the parts of those that are put together."""

    whole: Mapping[str, str]
    quantities: Mapping[str, str]
    races: Mapping[str, str]
    reductions: Mapping[str, str]
    stiffness: str


def _labels() -> dict[str, str]:
    """Labels of fields by the last part of their names, where that is of one field only."""
    fields = Case.fields().values()
    leaves = [field.leaf for field in fields]
    labelled = (field for field in fields if field.is_labelled and leaves.count(field.leaf) == 1)
    return {field.leaf: field.label for field in labelled}


_ENGLISH: Final = _Names(
    whole={
        **_labels(),
        "loaded_balls": "loaded balls",
        "life_hours": "life",
        "equivalent_load": "equivalent load P",
        "static_safety": "static safety",
    },
    quantities={
        "load": "contact load",
        "contact_angle": "contact angle",
        "deflection": "deflection",
        "semi_major": "semi-major axis",
        "semi_minor": "semi-minor axis",
        "max_pressure": "Hertz pressure",
        "mean_pressure": "mean Hertz pressure",
        "spin_to_roll": "ratio of spin to roll",
        "centrifugal_force": "centrifugal force",
        "gyroscopic_moment": "gyroscopic moment",
        "orbital_speed": "orbital speed",
        "ball_speed": "ball speed",
        "attitude": "attitude of the ball",
        "azimuth": "azimuth of the ball",
    },
    races={"inner": "inner race", "outer": "outer race"},
    reductions={"max": "greatest {}", "min": "least {}", "mean": "mean {}"},
    stiffness="stiffness",
)

_PORTUGUESE: Final = _Names(
    whole={
        "x": "deslocamento axial x",
        "y": "deslocamento radial y",
        "z": "deslocamento radial z",
        "ry": "inclinação em torno de y",
        "rz": "inclinação em torno de z",
        "fx": "carga axial Fx",
        "fy": "carga radial Fy",
        "fz": "carga radial Fz",
        "my": "momento My",
        "mz": "momento Mz",
        "inner_speed": "rotação do anel interno",
        "outer_speed": "rotação do anel externo",
        "first_ball_azimuth": "azimute da primeira esfera",
        "ball_count": "número de esferas",
        "ball_diameter": "diâmetro da esfera",
        "pitch_diameter": "diâmetro primitivo",
        "contact_angle": "ângulo de contato livre",
        "diametral_clearance": "folga diametral",
        "inner_conformity": "conformidade interna",
        "outer_conformity": "conformidade externa",
        "spacing": "distância entre carreiras",
        "preload": "pré-carga",
        "raceway_control": "controle de pista",
        "cage": "gaiola",
        "loaded_balls": "esferas carregadas",
        "life_hours": "vida",
        "equivalent_load": "carga equivalente P",
        "static_safety": "segurança estática",
        "residual": "resíduo",
        "iterations": "iterações",
        "ball": "esfera",
        "sample": "amostra",
    },
    quantities={
        "load": "carga no contato",
        "contact_angle": "ângulo de contato",
        "deflection": "aproximação",
        "semi_major": "semieixo maior",
        "semi_minor": "semieixo menor",
        "max_pressure": "pressão de Hertz",
        "mean_pressure": "pressão média de Hertz",
        "spin_to_roll": "razão entre spin e rolamento",
        "centrifugal_force": "força centrífuga",
        "gyroscopic_moment": "momento giroscópico",
        "orbital_speed": "rotação orbital",
        "ball_speed": "rotação da esfera",
        "attitude": "inclinação do eixo da esfera",
        "azimuth": "azimute da esfera",
    },
    races={"inner": "pista interna", "outer": "pista externa"},
    reductions={"max": "maior {}", "min": "menor {}", "mean": "{}, média"},
    stiffness="rigidez",
)


def variable_name(variable: str, language: str) -> str:
    """Return what a variable of a study is called, or nothing if it is not known.

    Parameters
    ----------
    variable
        Such as ``"fx"``, ``"stiffness_zz"`` or ``"max_inner_load"``.
    language
        ``"pt"``; English for any other.
    """
    names = _PORTUGUESE if language == "pt" else _ENGLISH
    if variable in names.whole:
        return names.whole[variable]
    if match := _STIFFNESS.fullmatch(variable):
        return f"{names.stiffness} {match[1]}–{match[2]}"
    match = _OF_BALLS.fullmatch(variable)
    if match is None or match[3] not in names.quantities:
        return ""
    reduction, race, quantity = match.groups()
    name = names.quantities[quantity]
    if race:
        name = f"{name}, {names.races[race]}"
    return names.reductions[reduction].format(name) if reduction else name


_CONTROLLED: Final = {
    "en": ("friction control", "fr. control"),
    "pt": ("controle por atrito", "c. atrito"),
}
_TORQUE_MODELS_PT: Final[Mapping[str, tuple[str, str]]] = {
    "jones_full": ("Jones, completo", "Jones comp"),
    "jones_control": ("Jones, controle de pista", "Jones ctrl"),
    "jones_simplified": ("Jones, simplificado", "Jones simp"),
}
"""Of those whose name is not the same in Portuguese."""


def torque_model_name(model: str, language: str, *, short: bool = False) -> str:
    """Say what a torque model, or friction control, is called; short: over a narrow column."""
    from rolamento.friction.models import TORQUE_MODELS

    if model == "friction_control":
        return _CONTROLLED.get(language, _CONTROLLED["en"])[short]
    if language == "pt" and model in _TORQUE_MODELS_PT:
        return _TORQUE_MODELS_PT[model][short]
    known = TORQUE_MODELS.get(model)
    if known is None:
        return model
    return known.short_title if short else known.title
