"""Rolamento tells what happens inside a rolling bearing, and what follows from it.

>>> import rolamento
>>> case = rolamento.load_case("218.toml")  # doctest: +SKIP
>>> state = rolamento.solve(case)  # doctest: +SKIP

Names are imported when they are first used: neither the compiler nor the readers are
loaded until needed.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    from rolamento.analysis import Analysis, BatchAnalysis, analyse, analyse_batch
    from rolamento.bearing import Bearing
    from rolamento.case import (
        Case,
        case_to_json,
        case_to_toml,
        load_case,
        override,
        parse_case,
        save_case,
    )
    from rolamento.catalogue import geometry_of
    from rolamento.duty import Displacement, Duty, Load
    from rolamento.equilibrium import BatchState
    from rolamento.errors import (
        FileError,
        InputError,
        RolamentoError,
        UnitError,
        UnknownKeyError,
    )
    from rolamento.film_model import FilmModel
    from rolamento.life import LifeConditions, LifeSummary
    from rolamento.life_model import LifeModel
    from rolamento.lubricant import Lubricant
    from rolamento.material import Material
    from rolamento.model import Model
    from rolamento.mounting import Mounting, SeatMaterial
    from rolamento.solution import solve, solve_batch
    from rolamento.state import State
    from rolamento.surface import Surface
    from rolamento.temperature import Temperature

__version__ = "0.1.0"

__all__ = [
    "Analysis",
    "BatchAnalysis",
    "BatchState",
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
    "State",
    "Surface",
    "Temperature",
    "UnitError",
    "UnknownKeyError",
    "__version__",
    "analyse",
    "analyse_batch",
    "case_to_json",
    "case_to_toml",
    "geometry_of",
    "load_case",
    "override",
    "parse_case",
    "save_case",
    "solve",
    "solve_batch",
]

_NAMES_OF_MODULES: Final = {
    "analysis": ("Analysis", "BatchAnalysis", "analyse", "analyse_batch"),
    "bearing": ("Bearing",),
    "case": (
        "Case",
        "case_to_json",
        "case_to_toml",
        "load_case",
        "override",
        "parse_case",
        "save_case",
    ),
    "catalogue": ("geometry_of",),
    "duty": ("Displacement", "Duty", "Load"),
    "equilibrium": ("BatchState",),
    "errors": ("FileError", "InputError", "RolamentoError", "UnitError", "UnknownKeyError"),
    "film_model": ("FilmModel",),
    "life": ("LifeConditions", "LifeSummary"),
    "life_model": ("LifeModel",),
    "lubricant": ("Lubricant",),
    "material": ("Material",),
    "model": ("Model",),
    "mounting": ("Mounting", "SeatMaterial"),
    "solution": ("solve", "solve_batch"),
    "state": ("State",),
    "surface": ("Surface",),
    "temperature": ("Temperature",),
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
