"""The result of a machine: its shafts, and a `Solved` for each of its bearings.

All arrays run over cases first: the steps of the machine's spectrum, or one. Machine's axes; a
bearing's own result counts along its own x, which is the machine's -x where it is turned round.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from rolamento.case.machine import Machine, MachineBearing, Shaft
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.solved.result import Solved
from rolamento.solved.tables import Status
from rolamento.words import Note

__all__ = ["SeatedBearing", "SolvedMachine", "SolvedShaft"]


@frozen(eq=False)
class SolvedShaft:
    """A shaft under load; SI.

    Attributes
    ----------
    shaft
        as it is given
    position
        of its nodes from its left end; (nodes,)
    diameter
        on the left and on the right of each node; (nodes, 2)
    displacement
        x, y, z, ry, rz of each node; (cases, nodes, 5)
    force
        what the part on the right puts on the part on the left: N, V_y, V_z, M_y, M_z, just left
        and just right of each node; (cases, nodes, 2, 5)
    torque
        likewise, about x; (cases, nodes, 2)
    stress
        nominal equivalent stress at the surface, by von Mises, of both; (cases, nodes, 2)
    euler_load
        the axial force at which it would buckle between its outermost bearings
    """

    shaft: Shaft
    position: FloatArray
    diameter: FloatArray
    displacement: FloatArray
    force: FloatArray
    torque: FloatArray
    stress: FloatArray
    euler_load: float

    @property
    def name(self) -> str:
        """What the machine calls it."""
        return self.shaft.name

    @property
    def deflection(self) -> FloatArray:
        """How far each node is from the axis; (cases, nodes), m."""
        return np.asarray(np.hypot(self.displacement[..., 1], self.displacement[..., 2]))

    @property
    def slope(self) -> FloatArray:
        """How much each node is turned; (cases, nodes), rad."""
        return np.asarray(np.hypot(self.displacement[..., 3], self.displacement[..., 4]))

    @property
    def bending_moment(self) -> FloatArray:
        """Of both planes together; (cases, nodes, 2), N·m."""
        return np.asarray(np.hypot(self.force[..., 3], self.force[..., 4]))

    @property
    def shear_force(self) -> FloatArray:
        """Of both planes together; (cases, nodes, 2), N."""
        return np.asarray(np.hypot(self.force[..., 1], self.force[..., 2]))

    def displacement_at(self, position: float) -> FloatArray:
        """Return the displacement of the node nearest to a position; (cases, 5)."""
        return np.asarray(self.displacement[:, int(np.argmin(np.abs(self.position - position)))])


@frozen(eq=False)
class SeatedBearing:
    """A bearing in its machine; SI.

    Attributes
    ----------
    bearing
        as it is given
    solved
        its own result: what reads one reads this
    inner, outer
        displacement of its rings; (cases, 5)
    force
        that the shaft puts on its inner ring; (cases, 5), N and N·m
    """

    bearing: MachineBearing
    solved: Solved
    inner: FloatArray
    outer: FloatArray
    force: FloatArray

    @property
    def name(self) -> str:
        """What the machine calls it."""
        return self.bearing.name

    @property
    def tilt(self) -> FloatArray:
        """Angle between its rings; (cases,), rad."""
        apart = self.inner - self.outer
        return np.asarray(np.hypot(apart[:, 3], apart[:, 4]))

    @property
    def radial_force(self) -> FloatArray:
        """(cases,), N."""
        return np.asarray(np.hypot(self.force[:, 1], self.force[:, 2]))


@frozen(eq=False)
class SolvedMachine:
    """Where a machine comes to rest, in each step of its spectrum.

    Attributes
    ----------
    machine
        what was solved
    status
        whether and how each case was solved; `unsupported` of "no_equilibrium" counts as in a
        bearing, of the part that `advice` names
    shafts, bearings
        by name
    stiffness
        of the whole machine at its operating points is that of `rolamento.rotor`
    notes
        what qualifies the result
    advice
        of each case that has no result, why
    """

    machine: Machine
    status: Status
    shafts: Mapping[str, SolvedShaft]
    bearings: Mapping[str, SeatedBearing]
    notes: tuple[tuple[Note, ...], ...]
    advice: tuple[Note | None, ...]

    def __len__(self) -> int:
        """Count the cases."""
        return len(self.status.number)

    @property
    def title(self) -> str:
        """Of the machine."""
        return self.machine.title

    @property
    def share(self) -> FloatArray:
        """Of the time, of each case; (cases,)."""
        return np.array([step.share for step in self.machine.spectrum] or [1.0])

    @property
    def steps(self) -> tuple[str, ...]:
        """What each case is called."""
        steps = self.machine.spectrum
        return tuple(step.name or str(index + 1) for index, step in enumerate(steps)) or ("",)
