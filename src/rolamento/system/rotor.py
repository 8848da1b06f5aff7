"""The vibration of a machine about where it came to rest: matrices, modes, forced response.

    M q" + (C + G) q' + K q = f,

K is the tangent of everything at the operating point, G the gyroscopic matrix of each shaft at its
speed, and C what damps. Rings that have no mass follow at once. Friswell, Penny, Garvey and Lees,
Dynamics of Rotating Machines (2010), chapters 5 and 6.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np
from scipy.linalg import eig, eigh

from rolamento.case.machine import Machine
from rolamento.numerics import ComplexArray, FloatArray, IntArray
from rolamento.records import frozen
from rolamento.system.network import FIVE
from rolamento.system.shafts import MachineRest, Structure

__all__ = ["Eigenmodes", "Rotor", "rotor_of", "unbalance_force"]

BASIS: Final = 6
"""Modes without gyroscopic effects for each that is asked for: with six, frequencies are within
1e-6 of those of all modes (`tests/unit/test_rotor.py`)."""
LEAST_BASIS: Final = 60
SWINGING: Final = 1e-3
"""√(1 - ζ²) from which on a mode counts as one that swings."""
RIGID: Final = 1e-6
"""Square of a frequency over the largest that counts as none."""


@frozen(eq=False)
class Eigenmodes:
    """Modes of one case, by rising frequency.

    Attributes
    ----------
    eigenvalue
        λ = -ζ ω + i ω_d; (modes,), 1/s
    shape
        of all degrees of freedom, the greatest shift 1; (modes, unknowns)
    forward
        from -1, backward whirl in circles, over 0, along a line, to +1, forward; (modes,)
    """

    eigenvalue: ComplexArray
    shape: ComplexArray
    forward: FloatArray

    @property
    def frequency(self) -> FloatArray:
        """Damped natural frequency; (modes,), rad/s."""
        return np.asarray(self.eigenvalue.imag)

    @property
    def damping_ratio(self) -> FloatArray:
        """ζ; (modes,)."""
        size = np.abs(self.eigenvalue)
        return np.divide(-self.eigenvalue.real, size, out=np.zeros_like(size), where=size > 0.0)


@frozen(eq=False)
class Rotor:
    """The matrices of a machine; (cases, …) where they differ.

    Attributes
    ----------
    mass
        (unknowns, unknowns), kg and kg·m²
    gyroscopic
        at the speeds of each case; (cases, unknowns, unknowns)
    stiffness
        at its operating point; (cases, unknowns, unknowns)
    damping
        s, by which the stiffness is multiplied
    free
        degrees of freedom that may move; (free,)
    """

    mass: FloatArray
    gyroscopic: FloatArray
    stiffness: FloatArray
    damping: float
    free: IntArray

    def __len__(self) -> int:
        """Count the cases."""
        return len(self.stiffness)

    def modes(self, case: int, count: int) -> Eigenmodes:
        """Return the lowest modes of a case.

        They are sought among those without gyroscopic effects, damping and asymmetry.
        """
        at = np.ix_(self.free, self.free)
        m, g = self.mass[at], self.gyroscopic[case][at]
        scale = self._scale()
        m, g, k = (one / scale[:, np.newaxis] / scale for one in (m, g, self.stiffness[case][at]))
        basis = self._basis(m, 0.5 * (k + k.T), max(BASIS * count, LEAST_BASIS))
        k_own, g_own = basis.T @ k @ basis, basis.T @ g @ basis
        size = len(k_own)
        state = np.block(
            [
                [np.zeros((size, size)), np.eye(size)],
                [-k_own, -(self.damping * k_own + g_own)],
            ]
        )
        values, vectors = eig(state)
        # what damping keeps from swinging at all has next to no imaginary part
        chosen = np.flatnonzero(values.imag > SWINGING * np.abs(values))
        chosen = chosen[np.argsort(np.abs(values[chosen]))][:count]
        shape = (basis @ vectors[:size, chosen]).T / scale
        whole = np.zeros((len(chosen), len(self.mass)), np.complex128)
        whole[:, self.free] = shape
        return Eigenmodes(values[chosen], *_normalised(whole))

    def _scale(self) -> FloatArray:
        """Lengths that make one unit of shifts and tilts: the square roots of the stiffness."""
        own = np.abs(np.diagonal(self.stiffness[0]))[self.free]
        return np.asarray(np.sqrt(np.where(own > 0.0, own, own.max())))

    @staticmethod
    def _basis(mass: FloatArray, stiffness: FloatArray, count: int) -> FloatArray:
        """Lowest modes of the symmetric problem, of unit mass; (free, count)."""
        # a little mass-proportional stiffness lets free bodies be, and is taken out again
        shift = RIGID * np.trace(stiffness) / max(np.trace(mass), np.finfo(float).tiny)
        values, vectors = eigh(mass, stiffness + shift * mass)
        some = np.flatnonzero(values > 1e-14 * values[-1])[::-1][:count]
        return np.asarray(vectors[:, some] / np.sqrt(values[some]))

    def response(self, case: int, speed: float, force: ComplexArray) -> ComplexArray:
        """Steady vibration under a force that turns at a speed, of e^(i speed t); (unknowns,)."""
        at = np.ix_(self.free, self.free)
        k = self.stiffness[case][at]
        dynamic = (
            k * (1.0 + 1j * speed * self.damping)
            + 1j * speed * self.gyroscopic[case][at]
            - speed**2 * self.mass[at]
        )
        out = np.zeros(len(self.mass), np.complex128)
        out[self.free] = np.linalg.solve(dynamic, force[self.free])
        return out


def rotor_of(
    machine: Machine,
    structure: Structure,
    rest: MachineRest,
    speeds: Mapping[str, FloatArray],
    damping: float = 0.0,
) -> Rotor:
    """Put the matrices together.

    Parameters
    ----------
    speeds
        of each shaft, by name; (cases,), rad/s
    damping
        of all that is elastic: C = damping · K; s
    """
    unknowns, cases = len(structure.held), len(structure)
    mass = np.zeros((unknowns, unknowns))
    gyroscopic = np.zeros((cases, unknowns, unknowns))
    for beam in structure.beams:
        own = np.zeros_like(mass)
        for at, m, g in zip(beam.unknowns(), *beam.elements.inertia(), strict=True):
            mass[at[:, np.newaxis], at] += m
            own[at[:, np.newaxis], at] += g
        for part in machine.masses:
            if part.shaft == beam.shaft.name:
                at = FIVE * beam.node_at(part.position) + np.arange(FIVE)
                inertia = part.inertia
                mass[at, at] += (*(inertia.mass,) * 3, *(inertia.transverse,) * 2)
                own[at[3], at[4]] += inertia.polar
                own[at[4], at[3]] -= inertia.polar
        gyroscopic += speeds[beam.shaft.name][:, np.newaxis, np.newaxis] * own
    return Rotor(
        mass, gyroscopic, structure.tangent(rest), damping, np.flatnonzero(~structure.held)
    )


def unbalance_force(
    machine: Machine, structure: Structure, speed: float, shaft: str
) -> ComplexArray:
    """The force of the unbalances on a shaft that turns at a speed, of e^(i speed t); (unknowns,).

    Turning about +x takes y to z, and so an unbalance at the azimuth ψ, from +z toward +y, back:
    F_z = U Ω² e^(-iψ), F_y = i F_z.
    """
    force = np.zeros(len(structure.held), np.complex128)
    for beam in structure.beams:
        if beam.shaft.name != shaft:
            continue
        for part in machine.masses:
            if part.shaft == shaft and part.unbalance:
                at = FIVE * beam.node_at(part.position)
                own = part.unbalance * speed**2 * np.exp(-1j * part.unbalance_azimuth)
                force[at + 2] += own
                force[at + 1] += 1j * own
    return force


def _normalised(shape: ComplexArray) -> tuple[ComplexArray, FloatArray]:
    """Shapes with their greatest shift 1, and which way they whirl."""
    nodes = shape.reshape(len(shape), -1, FIVE)
    shifts = nodes[..., :3].reshape(len(shape), -1)
    greatest = np.take_along_axis(shifts, np.abs(shifts).argmax(axis=1)[:, np.newaxis], axis=1)
    nodes = nodes / np.where(greatest == 0.0, 1.0, greatest)[..., np.newaxis]
    y, z = nodes[..., 1], nodes[..., 2]
    across = (np.abs(y) ** 2 + np.abs(z) ** 2).sum(axis=1)
    turning = -2.0 * (np.conj(y) * z).imag.sum(axis=1)
    forward = np.divide(turning, across, out=np.zeros(len(shape)), where=across > 1e-12)
    return nodes.reshape(shape.shape), np.asarray(forward)
