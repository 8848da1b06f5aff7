"""Bearings of a REXS model: by their inside, their designation, or their type and size."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, Final

from rolamento.case.machine import MachineBearing
from rolamento.catalogue import CatalogueBearing, catalogue
from rolamento.errors import InputError
from rolamento.exchange.rexs.head import HeadReader
from rolamento.exchange.rexs.model import Component
from rolamento.exchange.rexs.reader import (
    BEARINGS,
    Laid,
    Part,
    put_written,
    written,
)
from rolamento.exchange.rexs.values import words
from rolamento.types import BALL, TYPES, BearingType

__all__ = ["BearingReader"]

_SIZE: Final = 1e-6
_OFTEN_REFUSED: Final = ("mounting", "temperature", "life", "preload", "offset")
"""What a bearing may do without, in the order in which it is tried."""


class BearingReader(HeadReader):
    """Reads rolling bearings."""

    def _read_bearings(self) -> Iterator[Part]:
        for one in self.model.of_type(*BEARINGS):
            if (table := self._bearing(one)) is not None:
                yield Part("bearings", one.id, table)

    def _bearing(self, one: Component) -> dict[str, Any] | None:
        inner, outer = self._sides(one)
        laid = None if inner is None else self._shafts.get(inner.id)
        if laid is None:
            around = None if outer is None else self._shafts.get(outer.id)
            self._note("left", one, "rexs_ring_on_casing" if around else "rexs_no_shaft")
            return None
        position = self._position(one, laid, "u_coordinate_on_shaft_inner_side")
        if position is None:
            return None
        inside = self._inside(one)
        if inside is None:
            self._note("left", one, "rexs_bearing_unknown")
            return None
        table: dict[str, Any] = {
            "name": self._named(one, "bearings"),
            "shaft": laid.name,
            "position": written(position, "length"),
            **inside,
        }
        if outer is not None and outer.id in self._shafts:
            self._value(one, "u_coordinate_on_shaft_outer_side")
            table["outer_shaft"] = self._shafts[outer.id].name
        for key, own in (
            ("life", self._life(one)), ("temperature", self._warmth(one)),
            ("mounting", self._mounting(one)),
        ):  # fmt: skip
            if own:
                table[key] = own
        if force := self._value(one, "preload_force"):
            table["preload"] = written(force, "force")
        elif shift := self._value(one, "preload_distance"):
            table["offset"] = written(shift, "length")
        oil = self._lubricant_of(one)
        if oil is not None and oil is not self._shared_oil() and (found := self._lubricant(oil)):
            table["lubricant"] = found
        if any(
            self._value(one, name)
            for name in ("misalignment_in_v_direction", "misalignment_in_w_direction",
                         "angular_misalignment_around_v_axis",
                         "angular_misalignment_around_w_axis")
        ):  # fmt: skip
            self._note("left", one, "rexs_misaligned")
        return self._valid_bearing(one, table, laid)

    def _valid_bearing(
        self, one: Component, table: dict[str, Any], laid: Laid
    ) -> dict[str, Any] | None:
        """The table of a bearing without what its type does not take; None if it is none."""
        while True:
            try:
                case = MachineBearing.from_mapping(table).case
            except InputError as error:
                head = (error.field or "").partition(".")[0]
                spare = [key for key in _OFTEN_REFUSED if key in table]
                if not spare:
                    self._note("left", one, "rexs_bearing_refused", reason=str(error))
                    return None
                key = head if head in spare else spare[0]
                del table[key]
                self._note("left", one, "rexs_table_refused", table=key, reason=str(error))
            else:
                break
        bearing = case.bearing
        word = self._text(one, "axial_force_absorption")
        sign = {"positive": 1.0, "negative": -1.0}.get(word)
        if sign is not None:
            way = "+x" if sign * self._toward_x(one, laid) > 0.0 else "-x"
            if bearing.carries_one_way:
                table["faces"] = way
            elif bearing.locates or bearing.is_set:
                table["located"] = way
            self._note(
                "inferred", one, "rexs_axial_word", word=word,
                key="faces" if "faces" in table else "located", value=way,
            )  # fmt: skip
        elif word == "no_direction" and (
            bearing.locates or getattr(bearing, "inner_ribs", "none") != "none"
        ):
            table["located"] = "floating"
        elif word == "both_directions" and bearing.carries_one_way:
            self._note("left", one, "rexs_one_way", word=word)
        if not (bearing.locates or bearing.is_set):
            table.pop("preload", None)
            table.pop("offset", None)
        return table

    def _inside(self, one: Component) -> dict[str, Any] | None:
        """Designation or table of a bearing; None where nothing says what rolls in it."""
        word = self._text(one, "bearing_type")
        keys: list[str] = words()["bearing_types"].get(word, [])
        sizes = [self._value(one, name) for name in ("inner_diameter", "outer_diameter", "width")]
        designation = self._designation(one, keys, sizes, word)
        geometry = self._geometry(one, keys)
        clearance = self._value(one, "radial_bearing_clearance")
        kind = TYPES[keys[0]] if keys else None
        angled = kind is not None and (kind.in_pairs or kind.conical or kind.washers)
        if clearance and not angled:
            geometry = {**(geometry or {}), "diametral_clearance": written(clearance, "length")}
        if designation and not geometry:
            return {"designation": designation}
        if designation:
            return {"bearing": {"designation": designation, **(geometry or {})}}
        if geometry and len(geometry) > 3:
            return {"bearing": geometry}
        return None

    def _designation(
        self, one: Component, keys: Sequence[str], sizes: Sequence[float | None], word: str
    ) -> str:
        """A designation that the catalogue knows, with the sizes of the file; empty without one."""
        given = self._text(one, "catalogue_designation")
        plain = one.name.removesuffix(f"[{one.id}]").strip()
        tried = {given: False, plain: True, plain.partition(" ")[2]: True}
        for text, from_name in tried.items():
            if not (found := _of_catalogue(text)):
                continue
            bore, outside, _ = sizes
            if _apart(found.bore, bore) or _apart(found.outside_diameter, outside):
                self._note(
                    "inferred", one, "rexs_other_sizes", designation=text, bore=found.bore,
                    outside=found.outside_diameter, given_bore=bore or 0.0,
                    given_outside=outside or 0.0,
                )  # fmt: skip
                continue
            if from_name:
                self._note("inferred", one, "rexs_by_name", designation=text)
            if keys and found.kind not in keys:
                self._note(
                    "inferred", one, "rexs_type_misleads", word=word, designation=text,
                    type=TYPES[found.kind].name,
                )  # fmt: skip
            return self._with_class(one, text)
        return self._by_size(one, keys, sizes)

    def _with_class(self, one: Component, designation: str) -> str:
        given = self._text(one, "radial_clearance_class")
        usual: dict[str, str] = words()["fits"]["clearance_classes"]
        suffix = usual.get(given, "CN")
        if suffix == "CN" or "/C" in designation.upper():
            return designation
        longer = f"{designation}/{suffix}"
        return longer if _of_catalogue(longer) else designation

    def _by_size(self, one: Component, keys: Sequence[str], sizes: Sequence[float | None]) -> str:
        bore, outside, width = sizes
        if bore is None or outside is None or not keys:
            return ""
        rating = self._value(one, "radial_dynamic_load_rating") or 0.0
        alike = [
            other
            for other in catalogue().bearings
            if other.kind in keys
            and not _apart(other.bore, bore)
            and not _apart(other.outside_diameter, outside)
            and not _apart(other.width, width)
        ]
        if not alike:
            return ""
        found = min(alike, key=lambda other: abs((other.dynamic_rating or 0.0) - rating))
        self._note(
            "inferred", one, "rexs_by_size", designation=found.designation, bore=bore,
            outside=outside, width=found.width or 0.0, count=len(alike),
            rated=bool(rating),
        )  # fmt: skip
        return found.designation

    def _geometry(self, one: Component, keys: Sequence[str]) -> dict[str, Any] | None:
        """The inside of a bearing as rows and elements give it; None where one is missing."""
        rows = self.model.parts(one.id, "rolling_bearing_row")
        if not rows or not keys:
            return None
        row = rows[0]
        elements = self.model.parts(row.id, "rolling_element")
        kind: BearingType = TYPES[keys[0]]
        if len(rows) > 1 and kind.rows < len(rows):
            return None
        count = self._whole(row, "number_of_rolling_elements") or len(elements)
        pitch = self._value(row, "reference_diameter_rolling_bearing")
        size = self._value(elements[0], "diameter_of_rolling_element") if elements else None
        angle = self._value(row, "pressure_angle")
        if not (count and pitch and size):
            return None
        table: dict[str, Any] = {} if kind.grooves is None else {"kind": kind.grooves}
        table["pitch_diameter"] = written(pitch, "length")
        if kind.element == BALL:
            radii = [self._value(row, f"raceway_radius_of_{ring}_ring") for ring in
                     ("inner", "outer")]  # fmt: skip
            if not all(radii):
                return None
            table["ball_count"], table["ball_diameter"] = count, written(size, "length")
            for ring, radius in zip(("inner", "outer"), radii, strict=True):
                table[f"{ring}_conformity"] = round((radius or 0.0) / size, 15)
        else:
            long = self._value(elements[0], "length_of_rolling_element")
            contact = self._value(row, "significant_contact_length_inner_ring") or long
            if not (long and contact):
                return None
            table |= {
                "element": kind.element, "roller_count": count,
                "roller_diameter": written(size, "length"),
                "roller_length": written(long, "length"),
                "effective_length": written(contact, "length"),
            }  # fmt: skip
        if angle:
            table["contact_angle"] = written(angle, "angle")
        elif self._value(one, "radial_bearing_clearance") is None:
            table["diametral_clearance"] = "0 mm"
            self._note("inferred", one, "rexs_no_clearance")
        return table

    def _life(self, one: Component) -> dict[str, Any]:
        life: dict[str, Any] = {}
        for key, names in (
            ("dynamic_rating", ("radial_dynamic_load_rating", "axial_dynamic_load_rating")),
            ("static_rating", ("radial_static_load_rating", "axial_static_load_rating")),
            ("fatigue_load_limit", ("fatigue_limit_load",)),
        ):
            given = [self._value(one, name) for name in names]
            put_written(life, key, next((value for value in given if value), None), "force")
        clean = self._number(one, "contamination_factor_iso_281_2007")
        if clean is not None:
            life["contamination"] = clean
        survival = self._number(one, "survival_probability")
        if survival:
            life["reliability"] = survival / 100.0
        return life

    def _warmth(self, one: Component) -> dict[str, Any]:
        warm: dict[str, Any] = {}
        for key, name in (
            ("lubricant", "temperature_lubricant"),
            ("inner_ring", "mean_operating_temperature_inner_ring"),
            ("outer_ring", "mean_operating_temperature_outer_ring"),
        ):
            put_written(warm, key, self._value(one, name), "temperature")
        return warm

    def _mounting(self, one: Component) -> dict[str, Any]:
        fits = {
            "shaft_tolerance": self._text(one, "shaft_tolerance_class"),
            "housing_tolerance": self._text(one, "casing_bore_tolerance_class"),
        }
        if not all(fits.values()):
            return {}
        table: dict[str, Any] = dict(fits)
        for key, name in (
            ("bore", "inner_diameter"), ("outside_diameter", "outer_diameter"),
            ("width", "width"), ("shaft_bore", "shaft_inner_diameter"),
            ("housing_outside_diameter", "casing_outer_diameter"),
        ):  # fmt: skip
            if value := self._value(one, name):
                put_written(table, key, value, "length")
        return table


def _of_catalogue(designation: str) -> CatalogueBearing | None:
    if not designation or len(designation) > 60:
        return None
    try:
        return catalogue().find(designation).bearing
    except InputError:
        return None


def _apart(one: float | None, other: float | None) -> bool:
    """Whether two sizes are known and differ."""
    return one is not None and other is not None and abs(one - other) > _SIZE
