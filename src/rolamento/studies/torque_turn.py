"""Friction torque over a turn of the cage: what the torque of a slow mechanism varies by.

At every instant of `cage_turn` the loads of the contacts give a friction torque, by the closed form
of the contacts (and the oil's rolling resistance, where there is a film). It repeats with every
element that passes under the load. A bearing or a pair under axial load alone has none of it: all
elements are loaded alike.

That is the part of torque noise that an ideal bearing has. Elements of unlike diameter, waviness,
the cage's rubbing and debris add more, in general more than this; they need measured input and are
not modelled. In a pair both cages are taken to turn together; they drift in fact, and the variation
of the pair then lies between the difference and the sum of both rows'.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rolamento.analysis import film_and_friction
from rolamento.analysis.needs import has_friction
from rolamento.records import frozen, span
from rolamento.studies.cage_turn import ROUNDING, CageTurn

__all__ = ["TorqueTurn", "torque_over_turn"]


@frozen(eq=False)
class TorqueTurn:
    """Friction torque over one period of the cage's turn.

    Attributes
    ----------
    torque
        (points,), N·m, of slow turning where the bearing stands
    mean
        over the period, N·m
    peak_to_peak
        maximum less minimum, N·m
    harmonics
        (orders,) complex amplitudes at the orders of the turn, N·m
    model
        of the friction in the contacts
    """

    torque: NDArray[np.float64]
    mean: float
    peak_to_peak: float
    harmonics: NDArray[np.complex128]
    model: str

    def _shown(self) -> dict[str, str]:
        return {
            "": self.model,
            "torque": span(1e3 * self.torque, "N mm"),
            "peak to peak": f"{self.noise:.3%} of the mean",
        }

    @property
    def noise(self) -> float:
        """Peak to peak over the mean; NaN without a torque."""
        return self.peak_to_peak / self.mean if self.mean else float("nan")

    def to_mapping(self) -> dict[str, Any]:
        """Give everything as plain values in SI units."""
        return {
            "values": self.torque,
            "mean": self.mean,
            "peak_to_peak": self.peak_to_peak,
            "amplitude": np.abs(self.harmonics),
            "model": self.model,
        }


def torque_over_turn(turn: CageTurn) -> TorqueTurn | None:
    """Friction torque at the instants of a turn; None without a result or known friction.

    Parameters
    ----------
    turn
        Of `cage_turn`, of a case with a coefficient of friction, or an oil or a grease at its
        temperature.

    >>> from rolamento.case import case_of
    >>> from rolamento.studies.cage_turn import cage_turn
    >>> case = case_of("6205", {"duty.load.fz": "100 N", "lubricant.kind": "dry",
    ...                "lubricant.friction_coefficient": 0.1})
    >>> found = torque_over_turn(cage_turn(case, points=8))
    >>> found is not None and found.peak_to_peak > 0.0
    True
    """
    if not turn.converged or turn.case.lubricant is None or not has_friction(turn.solved):
        return None
    _, friction = film_and_friction(turn.solved)
    if friction is None:
        return None
    torque = np.asarray(friction.torque, np.float64)
    count = len(turn.orders)
    extent = float(np.ptp(torque))
    still = extent <= 10.0 * ROUNDING * float(np.abs(torque).max(initial=0.0))
    harmonics = 2.0 * np.fft.rfft(torque)[1 : count + 1] / len(torque)
    return TorqueTurn(
        torque,
        float(torque.mean()),
        0.0 if still else extent,
        np.where(still, 0.0, harmonics),
        friction.model,
    )
