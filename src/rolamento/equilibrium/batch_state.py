"""The result of a batch: arrays over cases, with a status code for each."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from rolamento.bearing import Bearing
from rolamento.equilibrium import accept
from rolamento.equilibrium.detail import BallTable, ball_table
from rolamento.equilibrium.problem import Floats, ring_arms

STATUS_NAMES: Final = {
    accept.CONVERGED: "converged",
    accept.NO_EQUILIBRIUM: "no_equilibrium",
    accept.NOT_CONVERGED: "not_converged",
    accept.OVERLOADED: "overloaded",
    accept.INVALID_INPUT: "invalid_input",
    accept.UNHELD_BALL: "unheld_ball",
}


@dataclass(frozen=True, slots=True, eq=False)
class BatchState:
    """Equilibria of many cases; a case without a result carries NaN.

    Attributes
    ----------
    code
        (cases,), a key of `STATUS_NAMES`
    unsupported
        (cases,), for no_equilibrium the degree of freedom (0 to 4) that nothing holds, else -1
    residual
        (cases,), the greatest of ring and balls, each over the scale of its own loads
    iterations
        (cases,), Newton steps
    safe_path
        (cases,), whether the fast path needed help
    displacement
        (cases, 5): x, y, z (m), ry, rz (rad)
    load
        (cases, 5): fx, fy, fz (N), my, mz (N·m); given loads, and reactions of what is held
    stiffness
        (cases, 5, 5), derivative of the load by the displacement
    bearing
        that was solved
    """

    code: NDArray[np.int64]
    unsupported: NDArray[np.int64]
    residual: Floats
    iterations: NDArray[np.int64]
    safe_path: NDArray[np.bool_]
    displacement: Floats
    load: Floats
    stiffness: Floats
    bearing: Bearing
    raceway_control: NDArray[np.int64]
    """(cases, balls): 1 outer, -1 inner, 0 where Jones's criterion favours neither."""
    _parameters: Floats
    _control: Floats
    _position: Floats
    _azimuth: Floats

    def __len__(self) -> int:
        """Count the cases."""
        return len(self.code)

    @property
    def converged(self) -> NDArray[np.bool_]:
        """(cases,): whether there is a result."""
        converged: NDArray[np.bool_] = self.code == accept.CONVERGED
        return converged

    @property
    def status(self) -> NDArray[np.str_]:
        """(cases,): the name of each case's status."""
        return np.array([STATUS_NAMES[int(code)] for code in self.code], dtype=np.str_)

    def balls(self) -> BallTable:
        """Evaluate every ball of every case: arrays (cases, balls)."""
        scaled = self.displacement * ring_arms(self._parameters).T
        return ball_table(self._parameters, self._control, scaled, self._position, self._azimuth)
