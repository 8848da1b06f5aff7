"""What the user gives: bearing, duty, model, lubricant and the rest, frozen and validated."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any, Final

from rolamento.case.bearing import Bearing
from rolamento.case.case import (
    Case,
    case_of,
    case_to_json,
    case_to_toml,
    is_designation,
    load_case,
    override,
    parse_case,
    save_case,
)
from rolamento.case.duty import Displacement, Duty, Load, Oscillation
from rolamento.case.electrical import Electrical
from rolamento.case.film_model import FilmModel
from rolamento.case.grease import Grease
from rolamento.case.heat import Heat
from rolamento.case.life_model import LifeModel
from rolamento.case.losses import Losses
from rolamento.case.lubricant import Lubricant
from rolamento.case.material import Material
from rolamento.case.model import Model
from rolamento.case.mounting import Mounting, SeatMaterial
from rolamento.case.report import ReportHead
from rolamento.case.roller_bearing import RollerBearing
from rolamento.case.static import Static
from rolamento.case.surface import Surface
from rolamento.case.temperature import Temperature

if TYPE_CHECKING:  # else imported when asked for: few users of a case need a machine
    from rolamento.case.machine import (
        Housing,
        Machine,
        MachineBearing,
        Section,
        Shaft,
        Spring,
        Step,
        load_machine,
        machine_to_json,
        machine_to_toml,
        parse_machine,
        save_machine,
    )
    from rolamento.case.machine_loads import Belt, Gear, Gravity, Mass, ShaftLoad

__all__ = [
    "Bearing",
    "Belt",
    "Case",
    "Displacement",
    "Duty",
    "Electrical",
    "FilmModel",
    "Gear",
    "Gravity",
    "Grease",
    "Heat",
    "Housing",
    "LifeModel",
    "Load",
    "Losses",
    "Lubricant",
    "Machine",
    "MachineBearing",
    "Mass",
    "Material",
    "Model",
    "Mounting",
    "Oscillation",
    "ReportHead",
    "RollerBearing",
    "SeatMaterial",
    "Section",
    "Shaft",
    "ShaftLoad",
    "Spring",
    "Static",
    "Step",
    "Surface",
    "Temperature",
    "case_of",
    "case_to_json",
    "case_to_toml",
    "is_designation",
    "load_case",
    "load_machine",
    "machine_to_json",
    "machine_to_toml",
    "override",
    "parse_case",
    "parse_machine",
    "save_case",
    "save_machine",
]

_LATER: Final = frozenset(
    {
        "Belt",
        "Gear",
        "Gravity",
        "Housing",
        "Machine",
        "MachineBearing",
        "Mass",
        "Section",
        "Shaft",
        "ShaftLoad",
        "Spring",
        "Step",
        "load_machine",
        "machine_to_json",
        "machine_to_toml",
        "parse_machine",
        "save_machine",
    }
)
"""What `rolamento.case.machine` has."""


def __getattr__(name: str) -> Any:
    if name not in _LATER:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"{__name__}.machine"), name)


def __dir__() -> list[str]:
    return sorted(__all__)
