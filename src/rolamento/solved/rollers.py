"""What a result knows of rollers beside what all elements have: lines of contact, tilt, ribs."""

from __future__ import annotations

from typing import Final

import numpy as np

from rolamento.contact.hertz import HertzContact
from rolamento.numerics import FloatArray
from rolamento.records import frozen

__all__ = ["LINE_COLUMNS", "ROLLER_COLUMNS", "Line", "Rollers", "line_contact"]

ROLLER_COLUMNS: Final = ("tilt", "rib_force", "rib_moment")
LINE_COLUMNS: Final = ("load_per_length", "pressure", "half_width")


@frozen(eq=False)
class Line:
    """The lines of contact with one race, slice by slice; (cases, elements, slices), SI.

    Attributes
    ----------
    load_per_length
        q (N/m)
    pressure
        maximum across the width (Pa)
    half_width
        b (m)
    """

    load_per_length: FloatArray
    pressure: FloatArray
    half_width: FloatArray


@frozen(eq=False)
class Rollers:
    """The rollers of a result; NaN for balls of a set that has both; SI.

    Attributes
    ----------
    tilt
        of the roller's axis in its plane through the bearing's axis, from where it stands without
        load, positive where the end toward +x of the row stands outward; (cases, elements), rad
    rib_force
        between a rib and the roller's end; (cases, elements), N
    rib_moment
        of the forces on the roller's ends about its middle; (cases, elements), N·m
    slice_place
        x_k of the slices along the roller from its middle, toward +x of the row;
        (cases, elements, slices), m
    inner, outer
        the lines of contact
    """

    tilt: FloatArray
    rib_force: FloatArray
    rib_moment: FloatArray
    slice_place: FloatArray
    inner: Line
    outer: Line

    @property
    def slices(self) -> int:
        """Into how many slices a roller is divided."""
        return int(self.slice_place.shape[-1])

    @classmethod
    def nowhere(cls, like: FloatArray, slices: int) -> Rollers:
        """Make those of a row of balls: NaN; like: (cases, elements)."""
        flat, deep = np.full(like.shape, np.nan), np.full((*like.shape, slices), np.nan)
        line = Line(deep, deep, deep)
        return cls(flat, flat, flat, deep, line, line)


def line_contact(line: Line, effective_length: FloatArray, load: FloatArray) -> HertzContact:
    """The whole line as one contact: half as long as it, and as wide as where it is widest.

    The pressure is the maximum of all slices, and its mean the load over the strip's area.
    """
    width, pressure = line.half_width.max(axis=-1), line.pressure.max(axis=-1)
    area = 2.0 * line.half_width.mean(axis=-1) * effective_length
    nothing = np.full(load.shape, np.nan)
    return HertzContact(
        load=load,
        semi_major=np.where(load > 0.0, 0.5 * effective_length, 0.0 * load),
        semi_minor=width,
        deflection=nothing,
        max_pressure=pressure,
        mean_pressure=np.divide(load, area, where=area > 0.0, out=0.0 * load),
        stiffness=nothing,
        ellipticity=np.full(load.shape, np.inf),
        second_integral=np.ones(load.shape),
    )
