"""Shafts of a REXS model: sections, speeds, and where parts are on them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

from rolamento.errors import FileError
from rolamento.exchange.rexs.model import Component
from rolamento.exchange.rexs.poses import HOME, Pose, Vector, dot
from rolamento.exchange.rexs.reader import (
    FINEST,
    NEAR,
    PARALLEL,
    Laid,
    Mesh,
    Part,
    Reader,
    put_written,
    written,
)
from rolamento.exchange.rexs.values import placed
from rolamento.words import said

__all__ = ["ShaftReader"]


class ShaftReader(Reader):
    """Reads shafts, and places on them."""

    # --- shafts -----------------------------------------------------------------------------------

    def _read_shafts(self) -> list[Part]:
        components = list(self.model.of_type("shaft"))
        self._lay_frame(components)
        sections = {one.id: self._sections(one) for one in components}
        for one in components:
            pose = self._poses.get(one.id, HOME)
            along = dot(pose.u, self._frame.u)
            if abs(abs(along) - 1.0) > PARALLEL:
                self._note("left", one, "rexs_not_parallel")
                continue
            if not sections[one.id]:
                self._note("left", one, "rexs_no_sections")
                continue
            if along < 0.0:
                self._note("inferred", one, "rexs_turned_shaft")
            start = sections[one.id][0][0]
            length = math.fsum(section[1] for section in sections[one.id])
            name = self._named(one, "shafts")
            self._shafts[one.id] = Laid(one, name, pose, along < 0.0, start, length)
        self._meshes = list(self._read_meshes())
        ratios = self._read_speeds()
        parts = []
        for number, laid in self._shafts.items():
            left = laid.start + (laid.length if laid.flipped else 0.0)
            at = self._frame.seen_from(laid.pose.point((left, 0.0, 0.0)))[0]
            table: dict[str, Any] = {
                "name": laid.name,
                "sections": [
                    _section(one, laid.flipped)
                    for one in sections[number][:: -1 if laid.flipped else 1]
                ],
                **ratios.get(number, {}),
            }
            if at := round(at, FINEST) + 0.0:
                table["position"] = written(at, "length")
            if material := self._material(laid.component):
                table["material"] = material
            parts.append(Part("shafts", number, table))
        return parts

    def _lay_frame(self, shafts: Sequence[Component]) -> None:
        """Choose x: along u of the gear unit if the first shaft lies so, else along the shaft."""
        if not shafts:
            return
        pose = self._poses.get(shafts[0].id, HOME)
        if abs(abs(pose.u[0]) - 1.0) > PARALLEL:
            self._frame = Pose((0.0, 0.0, 0.0), pose.u, pose.v, pose.w)
            self._note("inferred", None, "rexs_axes", shaft=shafts[0].name)

    def _sections(self, shaft: Component) -> list[tuple[float, ...]]:
        """Start, length, both outside and both inside diameters of its sections, in order."""
        found: list[tuple[float, ...]] = []
        for one in self.model.parts(shaft.id, "shaft_section"):
            length = self._value(one, "length")
            outside = [self._value(one, f"outer_diameter_{end}") for end in ("begin", "end")]
            begin = outside[0] if outside[0] is not None else outside[1]
            end = outside[1] if outside[1] is not None else outside[0]
            if length is None or begin is None or end is None:
                raise placed(
                    FileError(said("is missing")), one,
                    "length" if length is None else "outer_diameter_begin",
                )  # fmt: skip
            inside = [
                self._value(one, f"inner_diameter_{side}") or 0.0 for side in ("begin", "end")
            ]
            start = self._value(one, "u_coordinate_on_shaft")
            if start is None:
                start = found[-1][0] + found[-1][1] if found else 0.0
            if length > 0.0:
                found.append((start, length, begin, end, *inside))
        found.sort(key=lambda section: section[0])
        filled: list[tuple[float, ...]] = []
        for section in found:
            gap = round(section[0] - filled[-1][0] - filled[-1][1], 9) if filled else 0.0
            if gap < 0.0:
                raise FileError(
                    said("has sections that overlap by {overlap}",
                         overlap=written(-gap, "length")),
                    field=f"shaft {shaft.id}", value=shaft.name or None,
                )  # fmt: skip
            if gap > 0.0:
                last = filled[-1]
                thin = min((last[3], last[5]), (section[2], section[4]))
                filled.append((last[0] + last[1], gap, thin[0], thin[0], thin[1], thin[1]))
                self._note("inferred", shaft, "rexs_gap", gap=gap)
            filled.append(section)
        return filled

    def _material(self, shaft: Component) -> dict[str, Any] | None:
        for found in self.model.related("reference", shaft.id, "origin", "referenced"):
            if found.type != "material":
                continue
            table: dict[str, Any] = {}
            put_written(table, "youngs_modulus", self._value(found, "elastic_modulus"), "stress")
            put_written(table, "density", self._value(found, "density"), "density")
            if (ratio := self._number(found, "poisson_ratio")) is not None:
                table["poisson_ratio"] = ratio
            if len(table) == 3:
                named = self._text(found, "material_designation") or found.name
                return {"name": " ".join(named.split())[:100] or "custom", **table}
        return None

    def _read_meshes(self) -> Iterator[Mesh]:
        for relation in self.model.relations:
            if relation.type != "stage":
                continue
            numbers = [relation.in_role(role) for role in ("stage", "gear_1", "gear_2")]
            found = [self.model.by_id.get(number or 0) for number in numbers]
            if None in found:
                continue
            stage, *gears = (one for one in found if one is not None)
            shafts = [self._shaft_of(gear) for gear in gears]
            if all(gear.type == "cylindrical_gear" for gear in gears) and None not in shafts:
                one, other = (shaft for shaft in shafts if shaft is not None)
                yield Mesh(stage, (gears[0], gears[1]), (one, other))

    def _shaft_of(self, part: Component) -> Laid | None:
        whole = self.model.whole_of(part.id, "shaft")
        return None if whole is None else self._shafts.get(whole.id)

    def _read_speeds(self) -> dict[int, dict[str, Any]]:
        """Speeds that are given, and ratios to shafts in mesh for those that have none."""
        found: dict[int, dict[str, Any]] = {}
        for number, laid in self._shafts.items():
            speed = self._value(laid.component, "rotational_speed")
            defines = self._true(laid.component, "defines_speed")
            if speed is None and defines and "rotational_speed" in laid.component.attributes:
                speed = 0.0
            if speed is not None:
                self._speeds[number] = -speed if laid.flipped else speed
                found[number] = {"speed": written(self._speeds[number] + 0.0, "angular_speed")}
        waiting = True
        while waiting:
            waiting = False
            for mesh in self._meshes:
                numbers = [shaft.component.id for shaft in mesh.shafts]
                known = [number in self._speeds for number in numbers]
                if known[0] == known[1] or numbers[0] == numbers[1]:
                    continue
                here = known.index(False)
                teeth = [self._whole(gear, "number_of_teeth") or 0 for gear in mesh.gears]
                if min(teeth) < 1:
                    continue
                ratio = -teeth[1 - here] / teeth[here]
                self._speeds[numbers[here]] = ratio * self._speeds[numbers[1 - here]]
                found[numbers[here]] = {"ratio": ratio, "of": mesh.shafts[1 - here].name}
                self._note(
                    "inferred", mesh.shafts[here].component, "rexs_speed_by_teeth",
                    gear=mesh.gears[here].name, mate=mesh.gears[1 - here].name,
                )  # fmt: skip
                waiting = True
        for number, laid in self._shafts.items():
            if number not in self._speeds:
                self._speeds[number] = 0.0
                self._note("inferred", laid.component, "rexs_at_rest")
        return found

    # --- places -----------------------------------------------------------------------------------

    def _position(
        self, part: Component, laid: Laid, coordinate: str, before: float = 0.0
    ) -> float | None:
        """Where a part is from the left end of its shaft; before: its middle, past a coordinate."""
        given = self._value(part, coordinate)
        by_coordinate = None if given is None else laid.position(given + before)
        pose = self._poses.get(part.id)
        position = by_coordinate
        if pose is not None:
            local = laid.pose.seen_from(pose.origin)
            position = laid.position(local[0])
            if by_coordinate is not None and abs(position - by_coordinate) > NEAR:
                self._note("inferred", part, "rexs_places_differ",
                           difference=abs(position - by_coordinate))  # fmt: skip
        if position is None:
            self._note("left", part, "rexs_no_place")
            return None
        if not -NEAR <= position <= laid.length + NEAR:
            self._note("left", part, "rexs_off_shaft")
            return None
        return min(max(position, 0.0), laid.length)

    def _sides(self, part: Component) -> tuple[Component | None, Component | None]:
        """What stands in a bearing or coupling, and what around it."""
        for relation in self.model.relations_of(part.id, "assembly", "side"):
            one, other = (
                self.model.by_id.get(relation.in_role(role) or 0)
                for role in ("inner_part", "outer_part")
            )
            return one, other
        return self.model.whole_of(part.id, "shaft"), None

    def _toward_x(self, part: Component, laid: Laid) -> float:
        """+1 where the u axis of a part points as the machine's x, else -1."""
        pose = self._poses.get(part.id, laid.pose)
        return -1.0 if dot(pose.u, self._frame.u) < 0.0 else 1.0

    def _vector(self, one: Component, laid: Laid, names: str) -> Vector:
        """A vector of a part in the axes of the machine."""
        local = tuple(self._value(one, names.format(axis)) or 0.0 for axis in "uvw")
        pose = self._poses.get(one.id, laid.pose)
        if pose.u == self._frame.u and pose.w == self._frame.w:
            return local[0], local[1], local[2]
        return self._frame.local(pose.direction((local[0], local[1], local[2])))


def _section(section: Sequence[float], flipped: bool) -> dict[str, str]:
    _, length, begin, end, bore, end_bore = section
    if flipped:
        begin, end, bore, end_bore = end, begin, end_bore, bore
    table = {"length": written(length, "length"), "diameter": written(begin, "length")}
    if bore:
        table["bore"] = written(bore, "length")
    if end != begin:
        table["end_diameter"] = written(end, "length")
    if end_bore != bore:
        table["end_bore"] = written(end_bore, "length")
    return table
