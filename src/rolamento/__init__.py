"""Rolamento computes what happens inside a rolling bearing, and what follows from it.

>>> import rolamento
>>> solved = rolamento.solve("6310/C3", fz=5e3, inner_speed="1480 rpm")
>>> print(f"{solved.inner.load.max():.0f} N")
3031 N

`solve`, `analyse` and the verbs of `rolamento.verbs` take a designation, a case, a case file or
solved cases; the records say what they are given and what they return. Subpackages such as
`rolamento.weibull` are there by their names. Everything is imported when it is first used: neither
the compiler nor the readers are loaded until needed.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    from rolamento import (
        analysis,
        catalogue,
        clearance,
        contact,
        electrical,
        friction,
        geometry,
        grease,
        kinematics,
        life,
        lubrication,
        plots,
        ratings,
        rotors,
        safety,
        speeds,
        static,
        studies,
        tasks,
        units,
        verification,
        vibration,
        weibull,
    )
    from rolamento.analysis import Analysis, analyse
    from rolamento.analysis.machine import MachineAnalysis, analyse_machine
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
    from rolamento.case.duty import Displacement, Duty, Load, Oscillation
    from rolamento.case.electrical import Electrical
    from rolamento.case.film_model import FilmModel
    from rolamento.case.grease import Grease
    from rolamento.case.heat import Heat
    from rolamento.case.life_model import LifeModel
    from rolamento.case.losses import Losses
    from rolamento.case.lubricant import Lubricant
    from rolamento.case.machine import Machine, load_machine
    from rolamento.case.material import Material
    from rolamento.case.model import Model
    from rolamento.case.mounting import Mounting, SeatMaterial
    from rolamento.case.roller_bearing import RollerBearing
    from rolamento.case.static import Static
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
    from rolamento.machines import shaft
    from rolamento.solution import solve
    from rolamento.solved import Solved
    from rolamento.solved.machine import SolvedMachine
    from rolamento.tasks.diagnosis import diagnose
    from rolamento.tasks.frequencies import fault_frequencies
    from rolamento.verbs import (
        find_bearings,
        fit_weibull,
        friction_torque,
        lubricant_film,
        rating_life,
        report,
        sweep,
    )

__version__ = "0.2.0"

_NAMES_OF_MODULES: Final = {
    "analysis": ("Analysis", "analyse"),
    "analysis.machine": ("MachineAnalysis", "analyse_machine"),
    "case": (
        "Bearing",
        "Case",
        "Displacement",
        "Duty",
        "Electrical",
        "FilmModel",
        "Grease",
        "Heat",
        "LifeModel",
        "Load",
        "Losses",
        "Lubricant",
        "Machine",
        "Material",
        "Model",
        "Mounting",
        "Oscillation",
        "RollerBearing",
        "SeatMaterial",
        "Static",
        "Surface",
        "Temperature",
        "case_to_json",
        "case_to_toml",
        "load_case",
        "load_machine",
        "override",
        "parse_case",
        "save_case",
    ),
    "catalogue": ("geometry_of",),
    "errors": ("FileError", "InputError", "RolamentoError", "UnitError", "UnknownKeyError"),
    "life": ("LifeConditions", "LifeSummary"),
    "machines": ("shaft",),
    "solution": ("solve",),
    "solved": ("Solved",),
    "solved.machine": ("SolvedMachine",),
    "tasks.diagnosis": ("diagnose",),
    "tasks.frequencies": ("fault_frequencies",),
    "verbs": (
        "find_bearings",
        "fit_weibull",
        "friction_torque",
        "lubricant_film",
        "rating_life",
        "report",
        "sweep",
    ),
}
_MODULE_OF_NAME: Final = {
    name: module for module, names in _NAMES_OF_MODULES.items() for name in names
}
_PACKAGES: Final = frozenset(
    {
        "analysis",
        "case",
        "catalogue",
        "clearance",
        "contact",
        "electrical",
        "errors",
        "examples",
        "friction",
        "geometry",
        "grease",
        "kinematics",
        "life",
        "lubrication",
        "plots",
        "ratings",
        "rotors",
        "safety",
        "solved",
        "speeds",
        "static",
        "studies",
        "tasks",
        "units",
        "verification",
        "vibration",
        "weibull",
    }
)
"""That a name leads to, whatever was imported before."""

__all__ = [
    "Analysis",
    "Bearing",
    "Case",
    "Displacement",
    "Duty",
    "Electrical",
    "FileError",
    "FilmModel",
    "Grease",
    "Heat",
    "InputError",
    "LifeConditions",
    "LifeModel",
    "LifeSummary",
    "Load",
    "Losses",
    "Lubricant",
    "Machine",
    "MachineAnalysis",
    "Material",
    "Model",
    "Mounting",
    "Oscillation",
    "RolamentoError",
    "RollerBearing",
    "SeatMaterial",
    "Solved",
    "SolvedMachine",
    "Static",
    "Surface",
    "Temperature",
    "UnitError",
    "UnknownKeyError",
    "__version__",
    "analyse",
    "analyse_machine",
    "analysis",
    "case_to_json",
    "case_to_toml",
    "catalogue",
    "clearance",
    "contact",
    "diagnose",
    "electrical",
    "fault_frequencies",
    "find_bearings",
    "fit_weibull",
    "friction",
    "friction_torque",
    "geometry",
    "geometry_of",
    "grease",
    "kinematics",
    "life",
    "load_case",
    "load_machine",
    "lubricant_film",
    "lubrication",
    "override",
    "parse_case",
    "plots",
    "rating_life",
    "ratings",
    "report",
    "rotors",
    "safety",
    "save_case",
    "shaft",
    "solve",
    "speeds",
    "static",
    "studies",
    "sweep",
    "tasks",
    "units",
    "verification",
    "vibration",
    "weibull",
]


def __getattr__(name: str) -> Any:
    if name in _PACKAGES:
        return importlib.import_module(f"{__name__}.{name}")
    module = _MODULE_OF_NAME.get(name)
    if module is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(importlib.import_module(f"{__name__}.{module}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*__all__, *_PACKAGES})
