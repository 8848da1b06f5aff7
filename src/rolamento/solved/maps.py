"""Stiffness and force of a bearing over one or two quantities, as other programs take them in."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace

import numpy as np
from numpy.typing import NDArray

from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.words import Note

__all__ = ["MapAxis", "StiffnessMap"]


@frozen(eq=False)
class MapAxis:
    """A quantity that varies in a map.

    Attributes
    ----------
    field
        dotted name of the field, such as ``"duty.inner_speed"``
    unit
        SI; empty of a number without one
    values
        (points,), rising or falling
    """

    field: str
    unit: str
    values: FloatArray

    @property
    def leaf(self) -> str:
        """The last part of the field's name, such as ``"inner_speed"``."""
        return self.field.rpartition(".")[2]


@frozen(eq=False)
class StiffnessMap:
    """Stiffness and force of a bearing at the operating points of a grid; SI.

    Order of the five degrees of freedom: x, y, z, ry, rz, x along the shaft. Where there is no
    equilibrium all numbers are NaN.

    Attributes
    ----------
    name
        of the bearing
    axes
        one or two; points below is the lengths of these
    stiffness
        derivatives of the force by the displacement; (*points, 5, 5), N/m, N/rad, N and N·m/rad
    force
        that the shaft puts on the inner ring; (*points, 5), N and N·m
    displacement
        of the inner ring against the outer one; (*points, 5), m and rad
    status
        how each point was solved; (*points,)
    made_of
        what it is of, by name: title, kind, digest of the input
    notes
        what it leaves out
    """

    name: str
    axes: tuple[MapAxis, ...]
    stiffness: FloatArray
    force: FloatArray
    displacement: FloatArray
    status: NDArray[np.str_]
    made_of: Mapping[str, str] = field(default_factory=dict)
    notes: tuple[Note, ...] = ()

    @property
    def shape(self) -> tuple[int, ...]:
        """Points along each axis."""
        return tuple(len(axis.values) for axis in self.axes)

    @property
    def converged(self) -> bool:
        """Whether every point has a result."""
        return bool((self.status == "converged").all())

    def rising(self) -> StiffnessMap:
        """Return the same map, the values of all its axes rising."""
        found = self
        for place, axis in enumerate(self.axes):
            order = np.argsort(axis.values, kind="stable")
            axes = list(found.axes)
            axes[place] = replace(axis, values=axis.values[order])
            found = replace(
                found,
                axes=tuple(axes),
                stiffness=np.take(found.stiffness, order, axis=place),
                force=np.take(found.force, order, axis=place),
                displacement=np.take(found.displacement, order, axis=place),
                status=np.take(found.status, order, axis=place),
            )
        return found
