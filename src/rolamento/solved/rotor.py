"""Results of a machine's vibration: modes, a Campbell diagram, the response to unbalance."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rolamento.case.machine import Machine
from rolamento.io.json import plain
from rolamento.numerics import ComplexArray, FloatArray
from rolamento.records import frozen
from rolamento.words import Note

__all__ = ["Campbell", "CriticalSpeed", "Modes", "UnbalanceResponse", "whirl_names"]

_CIRCLE = 0.2
"""How much of a circle an orbit is at least that whirls one way."""


def whirl_names(forward: FloatArray, axial: NDArray[np.bool_]) -> NDArray[np.str_]:
    """Name how modes whirl: "forward", "backward", "along a line" or "axial"."""
    names = np.where(forward > _CIRCLE, "forward", "along a line")
    names = np.where(forward < -_CIRCLE, "backward", names)
    return np.where(axial, "axial", names)


@frozen(eq=False)
class Modes:
    """Natural frequencies and modes of a machine at one operating point; SI.

    Attributes
    ----------
    machine
        as it was given
    frequency, damping_ratio
        damped natural frequency, rad/s, and ζ; (modes,)
    whirl
        "forward", "backward", "along a line" or "axial"; (modes,)
    position
        of the nodes of each shaft from its left end, by name; (nodes,)
    shape
        of each shaft, the greatest shift of the machine 1; (modes, nodes, 5), complex
    notes
        what qualifies the result
    """

    machine: Machine
    frequency: FloatArray
    damping_ratio: FloatArray
    whirl: NDArray[np.str_]
    position: Mapping[str, FloatArray]
    shape: Mapping[str, ComplexArray]
    notes: tuple[Note, ...] = ()

    def __len__(self) -> int:
        """Count the modes."""
        return len(self.frequency)

    def to_mapping(self) -> dict[str, Any]:
        """Give everything but the machine as plain values in SI units; shapes in two parts."""
        return {
            "frequency": plain(self.frequency),
            "damping_ratio": plain(self.damping_ratio),
            "whirl": self.whirl.tolist(),
            "shapes": _parts(self.position, self.shape),
            "notes": [note.to_mapping() for note in self.notes],
        }


@frozen
class CriticalSpeed:
    """A speed at which a natural frequency meets an order of a shaft's rotation.

    Attributes
    ----------
    order
        of the rotation
    speed
        of the shaft, rad/s
    frequency
        rad/s
    whirl
        of the mode
    branch
        of the Campbell diagram
    """

    order: float
    speed: float
    frequency: float
    whirl: str
    branch: int


@frozen(eq=False)
class Campbell:
    """Natural frequencies over the speed of a shaft, each speed with its own operating point; SI.

    Attributes
    ----------
    machine, shaft
        what was solved, and by whose speed
    speed
        (speeds,), rad/s
    status
        of each speed; (speeds,)
    frequency, damping_ratio
        NaN without equilibrium; (speeds, branches)
    whirl
        (speeds, branches)
    critical
        where a branch meets an order of the rotation, by rising speed; solved anew there
    notes
        what qualifies the result
    """

    machine: Machine
    shaft: str
    speed: FloatArray
    status: NDArray[np.str_]
    frequency: FloatArray
    damping_ratio: FloatArray
    whirl: NDArray[np.str_]
    critical: tuple[CriticalSpeed, ...]
    notes: tuple[Note, ...] = ()

    def to_mapping(self) -> dict[str, Any]:
        """Give everything but the machine as plain values in SI units, NaN as None."""
        return {
            "shaft": self.shaft,
            "speed": plain(self.speed),
            "status": self.status.tolist(),
            "frequency": plain(self.frequency),
            "damping_ratio": plain(self.damping_ratio),
            "whirl": self.whirl.tolist(),
            "critical": [asdict(one) for one in self.critical],
            "notes": [note.to_mapping() for note in self.notes],
        }


@frozen(eq=False)
class UnbalanceResponse:
    """Steady vibration by the unbalances on one shaft over its speed; SI.

    Attributes
    ----------
    machine, shaft
        what was solved, and whose unbalances act
    speed
        (speeds,), rad/s
    position
        of the nodes of each shaft from its left end, by name; (nodes,)
    displacement
        of each shaft, of e^(i Ω t); (speeds, nodes, 5), complex
    force
        that each bearing's inner ring is put under besides what it carries, by name; (speeds, 5),
        complex, N and N·m
    damping
        C = damping · K; s
    notes
        what qualifies the result
    """

    machine: Machine
    shaft: str
    speed: FloatArray
    position: Mapping[str, FloatArray]
    displacement: Mapping[str, ComplexArray]
    force: Mapping[str, ComplexArray]
    damping: float
    notes: tuple[Note, ...] = ()

    def phase(self, shaft: str) -> FloatArray:
        """Azimuth of the high spot of each node when the shaft's angle is zero; (speeds, nodes).

        rad, from -π to π, of the part of the orbit that whirls with the shaft, and counted as an
        unbalance's: what it has beyond that is the lag, 0 far below a resonance and π far above.
        """
        y, z = self.displacement[shaft][..., 1], self.displacement[shaft][..., 2]
        return np.asarray(-np.angle(z - 1j * y))

    def amplitude(self, shaft: str) -> FloatArray:
        """Semi-major axis of the orbit of each node; (speeds, nodes), m."""
        y, z = self.displacement[shaft][..., 1], self.displacement[shaft][..., 2]
        forward, backward = 0.5 * np.abs(z - 1j * y), 0.5 * np.abs(z + 1j * y)
        return np.asarray(forward + backward)

    def force_amplitude(self, bearing: str) -> FloatArray:
        """Greatest radial force in a turn that unbalance adds at a bearing; (speeds,), N."""
        y, z = self.force[bearing][:, 1], self.force[bearing][:, 2]
        return np.asarray(0.5 * (np.abs(z - 1j * y) + np.abs(z + 1j * y)))

    def to_mapping(self) -> dict[str, Any]:
        """Give everything but the machine as plain values in SI units, NaN as None."""
        return {
            "shaft": self.shaft,
            "speed": plain(self.speed),
            "damping": self.damping,
            "displacement": _parts(self.position, self.displacement),
            "amplitude": {name: plain(self.amplitude(name)) for name in self.displacement},
            "force": {
                name: {"real": plain(own.real), "imaginary": plain(own.imag)}
                for name, own in self.force.items()
            },
            "notes": [note.to_mapping() for note in self.notes],
        }


def _parts(
    position: Mapping[str, FloatArray], complex_: Mapping[str, ComplexArray]
) -> dict[str, Any]:
    return {
        name: {
            "position": plain(position[name]),
            "real": plain(own.real),
            "imaginary": plain(own.imag),
        }
        for name, own in complex_.items()
    }
