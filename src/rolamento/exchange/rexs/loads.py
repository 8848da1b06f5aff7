"""Springs, loads and masses of a REXS model."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from rolamento.exchange.rexs.reader import (
    SPRINGS,
    Part,
    load_table,
    put_written,
    written,
)
from rolamento.exchange.rexs.shafts import ShaftReader

__all__ = ["LoadReader"]


class LoadReader(ShaftReader):
    """Reads what acts on shafts besides bearings and gears."""

    def _read_springs(self) -> Iterator[Part]:
        for one in self.model.of_type(*SPRINGS):
            inner, outer = self._sides(one)
            ends = [None if side is None else self._shafts.get(side.id) for side in (inner, outer)]
            laid = ends[0] or ends[1]
            if laid is None:
                self._note("left", one, "rexs_no_shaft")
                continue
            numbers = [
                self._value(one, name)
                for name in ("axial_stiffness", "radial_stiffness", "bending_stiffness")
            ]
            axial, radial, bending = (number or 0.0 for number in numbers)
            if not (axial or radial or bending):
                self._note("left", one, "rexs_stiffness_unknown")
                continue
            side = "inner" if ends[0] else "outer"
            position = self._position(one, laid, f"u_coordinate_on_shaft_{side}_side")
            if position is None:
                continue
            table: dict[str, Any] = {
                "name": self._named(one, "springs"),
                "shaft": laid.name,
                "position": written(position, "length"),
                "stiffness": [
                    *(written(value, "stiffness") for value in (axial, radial, radial)),
                    *[written(bending, "angular_stiffness")] * 2,
                ],
            }
            if ends[0] and ends[1]:
                there = self._position(one, ends[1], "u_coordinate_on_shaft_outer_side")
                if there is None:
                    continue
                table |= {"to_shaft": ends[1].name, "to_position": written(there, "length")}
            yield Part("springs", one.id, table)

    def _read_loads(self) -> Iterator[Part]:
        for one in self.model.of_type("external_load"):
            laid = self._shaft_of(one)
            if laid is None:
                self._note("left", one, "rexs_no_shaft")
                continue
            position = self._position(one, laid, "u_coordinate_on_shaft")
            if position is None:
                continue
            force = self._vector(one, laid, "force_{}_direction")
            moment = self._vector(one, laid, "torque_around_{}_axis")
            speed = self._speeds[laid.component.id]
            power = self._value(one, "power")
            if power and not moment[0] and speed:
                moment = (power / speed, moment[1], moment[2])
                self._note("inferred", one, "rexs_torque_of_power")
            self._use(one, "transmits_torque")
            self._use(one, "defines_torque")
            known = "torque_around_u_axis" in one.attributes or bool(power)
            through = self._true(one, "transmits_torque")
            flows = self._powers.setdefault(laid.component.id, [])
            if not known and through:
                flows.append(math.nan)
                self._open.append((laid, one, position))
                continue
            flows.append(moment[0] * speed)
            yield Part("loads", one.id, load_table(self._named(one, "loads"), laid.name, position,
                                              force, moment))  # fmt: skip

    def _read_masses(self) -> Iterator[Part]:
        for one in self.model.of_type("additional_mass"):
            laid = self._shaft_of(one)
            mass = self._value(one, "mass_of_component")
            if laid is None or mass is None:
                self._note("left", one, "rexs_no_shaft" if laid is None else "rexs_no_mass")
                continue
            position = self._position(one, laid, "u_coordinate_on_shaft")
            if position is None:
                continue
            table: dict[str, Any] = {
                "name": self._named(one, "masses"), "shaft": laid.name,
                "position": written(position, "length"), "mass": written(mass, "mass"),
            }  # fmt: skip
            polar = self._value(one, "moment_of_inertia_u_axis")
            across = [
                value
                for axis in "vw"
                if (value := self._value(one, f"moment_of_inertia_{axis}_axis"))
            ]
            put_written(table, "polar_inertia", polar, "inertia")
            put_written(table, "transverse_inertia", max(across, default=None), "inertia")
            if polar and "transverse_inertia" not in table:
                table["transverse_inertia"] = written(0.5 * polar, "inertia")
            eccentric = self._numbers(one, "eccentricity_vector")
            if len(eccentric) == 3 and any(eccentric[1:]):
                y, z = eccentric[1:]
                table["unbalance"] = written(mass * math.hypot(y, z), "unbalance")
                table["unbalance_azimuth"] = written(math.atan2(y, z), "angle")
            yield Part("masses", one.id, table)
