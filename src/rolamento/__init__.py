"""Rolamento tells what happens inside a rolling bearing, and what follows from it.

>>> import rolamento
>>> case = rolamento.load_case("218.toml")  # doctest: +SKIP
>>> solved = rolamento.solve(case)  # doctest: +SKIP

Names are imported when they are first used: neither the compiler nor the readers are
loaded until needed.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    from rolamento.analysis import Analysis, analyse
    from rolamento.case import (
        Case,
        case_to_json,
        case_to_toml,
        load_case,
        override,
        parse_case,
        save_case,
    )
    from rolamento.case.bearing import Bearing
    from rolamento.case.duty import Displacement, Duty, Load
    from rolamento.case.film_model import FilmModel
    from rolamento.case.life_model import LifeModel
    from rolamento.case.lubricant import Lubricant
    from rolamento.case.material import Material
    from rolamento.case.model import Model
    from rolamento.case.mounting import Mounting, SeatMaterial
    from rolamento.case.surface import Surface
    from rolamento.case.temperature import Temperature
    from rolamento.catalogue import geometry_of
    from rolamento.errors import (
        FileError,
        InputError,
        RolamentoError,
        UnitError,
        UnknownKeyError,
    )
    from rolamento.life import LifeConditions, LifeSummary
    from rolamento.solution import solve
    from rolamento.solved import Solved

__version__ = "0.1.0"

__all__ = [
    "Analysis",
    "Bearing",
    "Case",
    "Displacement",
    "Duty",
    "FileError",
    "FilmModel",
    "InputError",
    "LifeConditions",
    "LifeModel",
    "LifeSummary",
    "Load",
    "Lubricant",
    "Material",
    "Model",
    "Mounting",
    "RolamentoError",
    "SeatMaterial",
    "Solved",
    "Surface",
    "Temperature",
    "UnitError",
    "UnknownKeyError",
    "__version__",
    "analyse",
    "case_to_json",
    "case_to_toml",
    "geometry_of",
    "load_case",
    "override",
    "parse_case",
    "save_case",
    "solve",
]

_NAMES_OF_MODULES: Final = {
    "analysis": ("Analysis", "analyse"),
    "case": (
        "Bearing",
        "Case",
        "Displacement",
        "Duty",
        "FilmModel",
        "LifeModel",
        "Load",
        "Lubricant",
        "Material",
        "Model",
        "Mounting",
        "SeatMaterial",
        "Surface",
        "Temperature",
        "case_to_json",
        "case_to_toml",
        "load_case",
        "override",
        "parse_case",
        "save_case",
    ),
    "catalogue": ("geometry_of",),
    "errors": ("FileError", "InputError", "RolamentoError", "UnitError", "UnknownKeyError"),
    "life": ("LifeConditions", "LifeSummary"),
    "solution": ("solve",),
    "solved": ("Solved",),
}
_MODULE_OF_NAME: Final = {
    name: module for module, names in _NAMES_OF_MODULES.items() for name in names
}


def __getattr__(name: str) -> Any:
    module = _MODULE_OF_NAME.get(name)
    if module is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(importlib.import_module(f"{__name__}.{module}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
