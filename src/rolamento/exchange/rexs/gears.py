"""Gears of a REXS model: given forces, or the power that flows through their meshes."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Final

from rolamento.case.machine_loads import operating_mesh
from rolamento.exchange.rexs.model import Component
from rolamento.exchange.rexs.poses import Pose, crossing, dot
from rolamento.exchange.rexs.reader import (
    ALIKE,
    GEARS,
    NEAR,
    Laid,
    Mesh,
    Part,
    is_valid,
    load_table,
    put_written,
    written,
)
from rolamento.exchange.rexs.shafts import ShaftReader
from rolamento.units import readable

__all__ = ["GearReader"]

_CROSSING: Final = 0.01
"""Distance of two axes, over the pitch diameter, up to which they count as crossing: no hypoids."""
_USUAL_PRESSURE_ANGLE: Final = math.radians(20.0)


class GearReader(ShaftReader):
    """Reads gears."""

    def _read_gears(self) -> Iterator[Part]:
        given: set[int] = set()
        middles: dict[int, float] = {}
        bevels: list[tuple[Laid, Component]] = []
        for one in self.model.of_type(*GEARS):
            laid = self._shaft_of(one)
            if laid is None:
                self._note("left", one, "rexs_no_shaft")
                continue
            straight = one.type in ("cylindrical_gear", "ring_gear")
            width = (self._value(one, "face_width") or 0.0) if straight else 0.0
            middle = self._position(one, laid, "u_coordinate_on_shaft", 0.5 * width)
            if middle is None:
                continue
            force = self._vector(one, laid, "force_acting_on_shaft_{}")
            moment = self._vector(one, laid, "torque_acting_on_shaft_{}")
            if any(force) or any(moment):
                given.add(one.id)
                self._note("inferred", one, "rexs_forces_as_load")
                self._powers.setdefault(laid.component.id, []).append(
                    moment[0] * self._speeds[laid.component.id]
                )
                yield Part(
                    "loads", one.id,
                    load_table(self._named(one, "loads"), laid.name, middle, force, moment),
                )  # fmt: skip
            elif one.type == "bevel_gear":
                self._powers.setdefault(laid.component.id, []).append(math.nan)
                bevels.append((laid, one))
            elif one.type == "ring_gear":
                self._note("left", one, "rexs_internal_gear")
            else:
                middles[one.id] = middle
        meshes = [
            mesh
            for mesh in self._meshes
            if not given & {gear.id for gear in mesh.gears}
            and all(gear.id in middles for gear in mesh.gears)
        ]
        powers = self._power_flow(meshes)
        done: set[int] = set(given)
        for place, mesh in enumerate(meshes):
            if (power := powers.get(place)) is None:
                continue
            for part in self._mesh(mesh, power, middles):
                done.add(part.component)
                yield part
        for number in middles.keys() - done:
            self._note("left", self.model.by_id[number], "rexs_mesh_left")
        for laid, gear in bevels:
            if (table := self._bevel_gear(laid, gear)) is None:
                self._note("left", gear, "rexs_mesh_left")
            else:
                yield Part("gears", gear.id, table)
        yield from self._balancing()

    def _bevel_gear(self, laid: Laid, gear: Component) -> dict[str, Any] | None:
        """A bevel gear with the power that its shaft leaves it; None where something is missing.

        Its mate is on a shaft across, which no machine has: where the axes cross is the apex of
        its pitch cone, and the mesh lies toward its mate.
        """
        speed = self._speeds[laid.component.id]
        power = self._left_over.get(laid.component.id, 0.0)
        mate = self._mate(gear)
        other = None if mate is None else self.model.whole_of(mate.id, "shaft")
        if not power or not speed or mate is None or other is None or other.id not in self._poses:
            return None
        pose = self._poses[other.id]
        met = crossing(laid.pose, pose)
        if met is None:
            return None
        sides = [
            self._side(gear, laid.component, laid.pose, met[0]),
            self._side(mate, other, pose, met[1]),
        ]
        away = [(side * u[0], side * u[1], side * u[2])
                for side, u in zip(sides, (laid.pose.u, pose.u), strict=True)]  # fmt: skip
        teeth = [self._whole(one, "number_of_teeth") or 0 for one in (gear, mate)]
        cone = self._value(gear, "pitch_angle")
        if not cone and min(teeth) > 0:
            apart = math.acos(max(-1.0, min(1.0, dot(away[0], away[1]))))
            cone = math.atan2(math.sin(apart), teeth[1] / teeth[0] + math.cos(apart))
        spiral = abs(self._value(gear, "mean_spiral_angle") or 0.0)
        diameter = self._mean_diameter(gear, cone or 0.0, spiral)
        if not cone or not diameter or met[2] > _CROSSING * diameter:
            return None
        position = laid.position(met[0] + sides[0] * 0.5 * diameter / math.tan(cone))
        if not 0.0 <= position <= laid.length:
            return None
        _, y, z = self._frame.local(away[1])
        pressure = self._value(gear, "normal_pressure_angle")
        table: dict[str, Any] = {
            "name": self._named(gear, "gears"),
            "shaft": laid.name,
            "position": written(position, "length"),
            "kind": "bevel",
            "pitch_diameter": readable(diameter, "length", 12),
            "cone_angle": readable(cone, "angle", 12),
            "apex": "-x" if dot(away[0], self._frame.u) > 0.0 else "+x",
            "pressure_angle": readable(pressure or _USUAL_PRESSURE_ANGLE, "angle", 12),
            "power": readable(abs(power), "power", 12),
            "drives": power < 0.0,
            "mesh_azimuth": readable(math.atan2(y, z), "angle", 12),
        }
        hand = self._text(gear, "spiral_angle_pitch_direction").casefold()
        if spiral:
            table |= {"helix_angle": readable(spiral, "angle", 12),
                      "hand": "left" if hand.startswith("left") else "right"}  # fmt: skip
        if not is_valid("gears", table):
            return None
        if not pressure:
            self._note("inferred", gear, "rexs_pressure_angle")
        if spiral and not hand.startswith(("left", "right")):
            self._note("inferred", gear, "rexs_hand")
        self._note("inferred", gear, "rexs_bevel", power=abs(power), diameter=diameter, cone=cone)
        return table

    def _mate(self, gear: Component) -> Component | None:
        for relation in self.model.relations:
            numbers = [relation.in_role(role) for role in ("gear_1", "gear_2")]
            if relation.type == "stage" and gear.id in numbers:
                return self.model.by_id.get(numbers[1 - numbers.index(gear.id)] or 0)
        return None

    def _side(self, gear: Component, shaft: Component, pose: Pose, crossed: float) -> float:
        """On which side of the crossing of the axes a gear is, along u of its shaft: +1 or -1."""
        own = self._poses.get(gear.id)
        at = self._value(gear, "u_coordinate_on_shaft")
        here = pose.seen_from(own.origin)[0] if own is not None else at or 0.0
        if abs(here - crossed) < NEAR:  # it is placed by its apex: the shaft is behind it
            lengths = [self._value(one, "length") or 0.0
                       for one in self.model.parts(shaft.id, "shaft_section")]  # fmt: skip
            here = 0.5 * math.fsum(lengths)
        return 1.0 if here > crossed else -1.0

    def _mean_diameter(self, gear: Component, cone: float, spiral: float) -> float | None:
        """Pitch diameter of a bevel gear in the middle of its face; m."""
        if mean := self._value(gear, "mean_pitch_diameter"):
            return mean
        teeth, module = (
            self._whole(gear, "number_of_teeth"),
            self._value(gear, "mean_normal_module"),
        )
        if teeth and module:
            return teeth * module / math.cos(spiral)
        outer, width = (self._value(gear, name) for name in ("outer_pitch_diameter", "face_width"))
        return outer - width * math.sin(cone) if outer and width else None

    def _power_flow(self, meshes: Sequence[Mesh]) -> dict[int, float]:
        """Power that each mesh brings to its second gear: what comes to a shaft leaves it; W."""
        powers: dict[int, float] = {}
        waiting = True
        while waiting:
            waiting = False
            for number in self._shafts:
                flows = self._powers.get(number, [])
                total = math.fsum(power for power in flows if not math.isnan(power))
                unknown: list[tuple[int, float] | None] = [
                    None for power in flows if math.isnan(power)
                ]
                for place, mesh in enumerate(meshes):
                    for side, shaft in enumerate(mesh.shafts):
                        if shaft.component.id != number:
                            continue
                        sign = 1.0 if side else -1.0
                        if place in powers:
                            total += sign * powers[place]
                        else:
                            unknown.append((place, sign))
                if len(unknown) != 1:
                    continue
                if unknown[0] is None:
                    if number not in self._left_over:
                        self._left_over[number] = -total
                    continue
                place, sign = unknown[0]
                if self._speeds[number] and (flows or total):
                    powers[place] = -sign * total
                    waiting = True
        return {place: power for place, power in powers.items() if power}

    def _balancing(self) -> Iterator[Part]:
        """The torques that external loads take or bring, where the gears give them."""
        for laid, one, position in self._open:
            speed = self._speeds[laid.component.id]
            power = self._left_over.get(laid.component.id, 0.0)
            force = self._vector(one, laid, "force_{}_direction")
            moment = self._vector(one, laid, "torque_around_{}_axis")
            if power and speed:
                moment = (power / speed, moment[1], moment[2])
                self._note("inferred", one, "rexs_balance", torque=moment[0])
            yield Part("loads", one.id, load_table(self._named(one, "loads"), laid.name, position,
                                              force, moment))  # fmt: skip

    def _mesh(self, mesh: Mesh, power: float, middles: Mapping[int, float]) -> Iterator[Part]:
        """Two gears in mesh: the driving one with the power, the other with its mate."""
        teeth = [self._whole(gear, "number_of_teeth") for gear in mesh.gears]
        modules = [self._value(gear, "normal_module") for gear in mesh.gears]
        helices = [
            self._value(gear, "helix_angle_reference_diameter") or 0.0 for gear in mesh.gears
        ]
        module = modules[0] or modules[1]
        axes = [shaft.pose.origin for shaft in mesh.shafts]
        _, *across = self._frame.local(
            (axes[1][0] - axes[0][0], axes[1][1] - axes[0][1], axes[1][2] - axes[0][2])
        )
        distance = math.hypot(*across)
        if None in teeth or not module or distance < NEAR:
            return
        if min(count or 0 for count in teeth) < 0:
            for gear in mesh.gears:
                self._note("left", gear, "rexs_internal_gear")
            return
        total = sum(count or 0 for count in teeth)
        helix = abs(helices[0] or helices[1])
        at = operating_mesh(
            self._value(mesh.stage, "center_distance") or distance, total, module,
            self._pressure_angle(mesh), helix,
        )  # fmt: skip
        if abs(at.module - module) > ALIKE * module:
            self._note(
                "inferred", mesh.gears[0], "rexs_operating_mesh",
                distance=self._value(mesh.stage, "center_distance") or distance,
                pressure=at.pressure_angle, helix=at.helix_angle,
            )  # fmt: skip
        else:
            at = at._replace(
                module=module, pressure_angle=self._pressure_angle(mesh), helix_angle=helix
            )
        driver = 0 if power > 0.0 else 1
        if helix:
            self._note("inferred", mesh.gears[driver], "rexs_hand")
        self._note(
            "inferred", mesh.gears[driver], "rexs_power_flow", power=abs(power),
            gear=mesh.gears[driver].name, mate=mesh.gears[1 - driver].name,
        )  # fmt: skip
        names = [self._named(gear, "gears") for gear in mesh.gears]
        for side in (driver, 1 - driver):
            gear = mesh.gears[side]
            table: dict[str, Any] = {
                "name": names[side],
                "shaft": mesh.shafts[side].name,
                "position": written(middles[gear.id], "length"),
                "teeth": teeth[side],
                "module": readable(at.module, "length", 12),
                "pressure_angle": readable(at.pressure_angle, "angle", 12),
            }
            put_written(table, "face_width", self._value(gear, "face_width"), "length")
            if at.helix_angle:
                left = (helices[side] or -helices[1 - side]) < 0.0
                table |= {"kind": "helical", "helix_angle": readable(at.helix_angle, "angle", 12),
                          "hand": "left" if left else "right"}  # fmt: skip
            if side == driver:
                toward = 1.0 if side == 0 else -1.0
                azimuth = math.atan2(toward * across[0], toward * across[1])
                table |= {"power": readable(abs(power), "power", 12), "drives": True,
                          "mesh_azimuth": readable(azimuth, "angle", 12)}  # fmt: skip
            else:
                table["mate"] = names[driver]
            yield Part("gears", gear.id, table)

    def _pressure_angle(self, mesh: Mesh) -> float:
        for gear in mesh.gears:
            for relation in self.model.relations_of(gear.id, "gear", "flank"):
                for ref in relation.refs:
                    flank = self.model.by_id.get(ref.id)
                    if flank is not None and flank.type == "flank_geometry":
                        angle = self._value(flank, "normal_pressure_angle")
                        if angle:
                            return angle
        self._note("inferred", mesh.gears[0], "rexs_pressure_angle")
        return _USUAL_PRESSURE_ANGLE
