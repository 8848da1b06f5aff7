"""The vibration of a machine about where it came to rest: matrices, modes, forced response.

    M q" + (C + G) q' + K q = f,

K is the tangent of everything at the operating point, G the gyroscopic matrix of each shaft at its
speed, and C what damps. Rings that have no mass follow at once. Friswell, Penny, Garvey and Lees,
Dynamics of Rotating Machines (2010), chapters 5 and 6.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Final

import numpy as np

from rolamento.case.machine import Machine
from rolamento.numerics import ComplexArray, FloatArray, IntArray
from rolamento.records import frozen
from rolamento.system.network import FIVE
from rolamento.system.shafts import MachineRest, Structure

__all__ = ["Eigenmodes", "Rotor", "rotor_of", "unbalance_force"]

BASIS: Final = 6
"""Modes at rest, of the mean of all cases, for each mode that is asked for. With these, and what is
added to them, eigenvalues are within 1e-6 of those of all degrees of freedom
(`tests/unit/test_rotor.py`)."""
LEAST_BASIS: Final = 100
OWN: Final = 2
"""Modes of each case's symmetric part for each that is asked for, and besides:"""
OWN_BESIDES: Final = 8
DEPENDENT: Final = 1e-9
"""Part of a vector's length that counts as none, once others are taken out of it."""
SWINGING: Final = 1e-3
"""√(1 - ζ²) from which on a mode counts as one that swings."""
RIGID: Final = 1e-6
"""Square of a frequency, over the mean of all, that is added where statics are solved: a free body
has none of its own."""


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


@frozen(eq=False, slots=False)
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

        They are sought among modes of its symmetric stiffness, each with its static answers to
        what couples it to others: gyroscopic moments, and the part of the stiffness that is not
        symmetric.
        """
        heavy, follow = self._condensed(case)
        basis = self._basis(count)
        k = basis.T @ self._stiffness(case) @ basis
        g = basis.T @ self.gyroscopic[case][np.ix_(heavy, heavy)] @ basis
        symmetric, skew = 0.5 * (k + k.T), 0.5 * (k - k.T)
        own = np.linalg.eigh(symmetric)[1][:, : OWN * count + OWN_BESIDES]
        shifted = symmetric + RIGID * np.trace(symmetric) / len(k) * np.eye(len(k))
        answers = np.linalg.solve(shifted, np.hstack([g @ own, skew @ own]))
        own = np.hstack([own, _apart(own, answers)])
        k, g = own.T @ k @ own, own.T @ g @ own
        size = len(k)
        state = np.block([[np.zeros((size, size)), np.eye(size)], [-k, -(self.damping * k + g)]])
        values, vectors = np.linalg.eig(state)
        # what damping keeps from swinging at all has next to no imaginary part
        chosen = np.flatnonzero(values.imag > SWINGING * np.abs(values))
        chosen = chosen[np.argsort(np.abs(values[chosen]))][:count]
        whole = np.zeros((len(chosen), len(self.mass)), np.complex128)
        shape = (basis @ (own @ vectors[:size, chosen])).T
        whole[:, heavy] = shape
        whole[:, self._light] = shape @ follow.T
        return Eigenmodes(values[chosen], *_normalised(whole))

    @cached_property
    def _light(self) -> IntArray:
        """Free degrees of freedom without mass: of rings, which follow the others at once."""
        return self.free[~self.mass[:, self.free].any(axis=0)]

    def _condensed(self, case: int) -> tuple[IntArray, FloatArray]:
        """Degrees of freedom with mass, and how those without follow them; exact.

        Damping in proportion to the stiffness changes nothing in that.
        """
        light = self._light
        heavy = np.setdiff1d(self.free, light)
        k = self.stiffness[case]
        # what nothing holds and nothing weighs down stays where it is
        return heavy, -np.linalg.pinv(k[np.ix_(light, light)]) @ k[np.ix_(light, heavy)]

    def _stiffness(self, case: int) -> FloatArray:
        """Between the degrees of freedom with mass, the others following; (heavy, heavy)."""
        heavy, follow = self._condensed(case)
        k = self.stiffness[case]
        return np.asarray(k[np.ix_(heavy, heavy)] + k[np.ix_(heavy, self._light)] @ follow)

    @cached_property
    def _at_rest(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Square root L of the mass, modes at rest of the mean stiffness, and static answers.

        M = L L'. Modes and answers are of L' q, in which the mass is one: (heavy, heavy) and
        (heavy, answers). The answers are to unit forces wherever the cases' stiffness differs.
        """
        known = [case for case in range(len(self)) if np.isfinite(self.stiffness[case]).all()]
        heavy = np.setdiff1d(self.free, self._light)
        mean = np.zeros((len(heavy), len(heavy)))
        for case in known:
            own = self._stiffness(case)
            mean += 0.5 * (own + own.T) / len(known)
        apart = np.zeros(len(heavy))
        for case in known:
            apart = np.maximum(apart, np.abs(self._stiffness(case) - mean).max(axis=0))
        root = np.linalg.cholesky(self.mass[np.ix_(heavy, heavy)])
        within = np.linalg.solve(root, np.linalg.solve(root, mean).T)
        squares, modes = np.linalg.eigh(0.5 * (within + within.T))
        met = np.flatnonzero(apart > DEPENDENT * np.abs(np.diagonal(mean)))
        forces = modes.T @ np.linalg.solve(root, np.eye(len(heavy))[:, met])
        answers = modes @ (forces / (squares + RIGID * squares.mean())[:, np.newaxis])
        return np.asarray(root), np.asarray(modes), np.asarray(answers)

    def _basis(self, count: int) -> FloatArray:
        """Basis for all cases, of unit mass; (heavy, basis)."""
        root, modes, answers = self._at_rest
        some = modes[:, : max(BASIS * count, LEAST_BASIS)]
        return np.asarray(np.linalg.solve(root.T, np.hstack([some, _apart(some, answers)])))

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


def _apart(basis: FloatArray, others: FloatArray) -> FloatArray:
    """What others span besides an orthonormal basis, orthonormal; (size, found)."""
    length = np.linalg.norm(others, axis=0)
    left = others[:, length > 0.0] / length[length > 0.0]
    for _ in range(2):  # twice is enough (Kahan)
        left = left - basis @ (basis.T @ left)
    found, sizes, _ = np.linalg.svd(left, full_matrices=False)
    return np.asarray(found[:, sizes > DEPENDENT])


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
