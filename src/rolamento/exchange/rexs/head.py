"""What counts for a whole REXS model: title, gravity, oil, temperatures."""

from __future__ import annotations

import math
from typing import Any, Final

from rolamento.case.lubricant import Lubricant
from rolamento.errors import InputError
from rolamento.exchange.rexs.model import Component
from rolamento.exchange.rexs.reader import (
    PARALLEL,
    put_written,
    written,
)
from rolamento.exchange.rexs.shafts import ShaftReader
from rolamento.units import Dimension

__all__ = ["HeadReader"]

_USUAL_DENSITY: Final = "880 kg/m^3"


class HeadReader(ShaftReader):
    """Reads what stands above the parts of a machine."""

    def _read_head(self, unit: Component | None) -> dict[str, Any]:
        head: dict[str, Any] = {}
        warm: dict[str, str] = {}
        if unit is not None:
            if title := self._text(unit, "model_name"):
                head["title"] = " ".join(title.split())[:200]
            if gravity := self._gravity(unit):
                head["gravity"] = gravity
        for casing in self.model.of_type("gear_casing"):
            put_written(
                warm, "lubricant", self._value(casing, "temperature_lubricant"), "temperature"
            )
            put_written(
                warm, "housing", self._value(casing, "mean_operating_temperature"), "temperature"
            )
            break
        for laid in self._shafts.values():
            hot = self._value(laid.component, "mean_operating_temperature")
            if "shaft" not in warm:
                put_written(warm, "shaft", hot, "temperature")
        oil = self._shared_oil()
        if oil is not None and (table := self._lubricant(oil)):
            head["lubricant"] = table
        if warm:
            head["temperature"] = warm
        if self._spectrum:
            head["spectrum"] = self._spectrum
        return head

    def _gravity(self, unit: Component) -> dict[str, Any] | None:
        if not self._true(unit, "account_for_gravity"):
            return None
        vector = [self._number(unit, f"direction_vector_gravity_{axis}") or 0.0 for axis in "uvw"]
        local = self._frame.local((vector[0], vector[1], vector[2]))
        size = math.hypot(*local)
        axis = max(range(3), key=lambda place: abs(local[place]))
        if not size or abs(local[axis]) < (1.0 - PARALLEL) * size:
            self._note("left", unit, "rexs_gravity")
            return None
        gravity = {"direction": f"{'+' if local[axis] > 0.0 else '-'}{'xyz'[axis]}"}
        put_written(gravity, "acceleration", self._value(unit, "gravitational_acceleration"),
             "acceleration")  # fmt: skip
        return gravity

    def _lubricant_of(self, *origins: Component) -> Component | None:
        for origin in origins:
            for found in self.model.related("reference", origin.id, "origin", "referenced"):
                if found.type == "lubricant":
                    return found
        return None

    def _shared_oil(self) -> Component | None:
        """The lubricant of the casing, or the first one."""
        of_casing = self._lubricant_of(*self.model.of_type("gear_casing"))
        return of_casing or next(self.model.of_type("lubricant"), None)

    def _lubricant(self, oil: Component) -> Any:
        """A lubricant by its viscosities, or its name where that is known."""
        name = self._text(oil, "name") or oil.name.removesuffix(f"[{oil.id}]").strip()
        table: dict[str, Any] = {}
        quantities: tuple[tuple[str, str, Dimension], ...] = (
            ("viscosity_40", "viscosity_at_40_degree_celsius", "kinematic_viscosity"),
            ("viscosity_100", "viscosity_at_100_degree_celsius", "kinematic_viscosity"),
            ("density", "density_at_15_degree_celsius", "density"),
            ("pressure_viscosity", "pressure_viscosity_coefficient_at_38_degrees_celsius",
             "pressure_viscosity_coefficient"),
            ("thermal_conductivity", "thermal_conductivity", "thermal_conductivity"),
        )  # fmt: skip
        for key, attribute, dimension in quantities:
            put_written(table, key, self._value(oil, attribute), dimension)
        if "density" in table:
            table["density_temperature"] = "15 degC"
        if "viscosity_40" not in table or "viscosity_100" not in table:
            points = zip(
                self._numbers(oil, "temperature_variation_lubricant_viscosity"),
                self._numbers(oil, "temperature_dependent_kinematic_viscosity"),
                strict=False,
            )
            found = [
                {"temperature": written(hot, "temperature"),
                 "viscosity": written(thick, "kinematic_viscosity")}
                for hot, thick in points
            ]  # fmt: skip
            if len(found) > 1:
                table = {k: v for k, v in table.items() if not k.startswith("viscosity_")}
                table["viscosities"] = [found[0], found[-1]]
        if name:
            table["name"] = " ".join(name.split())[:100]
        if (kind := self._text(oil, "kind")) in ("oil", "grease"):
            table["kind"] = kind
        if self._text(oil, "basis") == "mineral":
            table["oil_type"] = "mineral"
        if any(key.startswith("viscosit") for key in table) and "density" not in table:
            table["density"] = _USUAL_DENSITY
        for tried in (table, name):
            try:
                if isinstance(tried, str):
                    Lubricant.named(tried)
                else:
                    Lubricant.from_mapping(tried)
            except InputError:
                continue
            if tried is table and table.get("density") == _USUAL_DENSITY:
                self._note("inferred", oil, "rexs_usual_density")
            return tried
        self._note("left", oil, "rexs_lubricant")
        return None
