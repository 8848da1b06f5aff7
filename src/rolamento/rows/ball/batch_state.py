"""The result of a batch: arrays over cases, with a status code for each."""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import reduce
from typing import Any, Final, TypeVar

import numpy as np
from numpy.typing import NDArray

from rolamento import status
from rolamento.contact.hertz import HertzContact
from rolamento.geometry import Race
from rolamento.rows.ball import layout
from rolamento.rows.ball.detail import BallTable, ball_table, groove_centres, hertz
from rolamento.rows.ball.problem import Floats
from rolamento.rows.ball.rolling import Rolling

T = TypeVar("T")

STATUS_NAMES: Final = {
    status.CONVERGED: "converged",
    status.NO_EQUILIBRIUM: "no_equilibrium",
    status.NOT_CONVERGED: "not_converged",
    status.OVERLOADED: "overloaded",
    status.INVALID_INPUT: "invalid_input",
    status.UNHELD_BALL: "unheld_ball",
    status.OVER_SHOULDER: "over_shoulder",
}


@dataclass(frozen=True, slots=True, eq=False)
class RowBatch:
    """One row of balls of a batch, in the row's own frame and the scaled form of `rows`.

    parameters (layout.COLUMN, cases); control and azimuth (cases, balls); position (cases, balls,
    2); displacement (cases, 5). load: what the shaft puts on the ring through this row, in the
    frame and about the origin of the bearing (cases, 5), N and N·m. rolling: how friction moves
    the balls, if it controls them.
    """

    parameters: Floats
    control: Floats
    position: Floats
    azimuth: Floats
    displacement: Floats
    load: Floats
    rolling: Rolling | None = None

    def balls(self) -> BallTable:
        """Evaluate every ball: arrays (cases, balls)."""
        return ball_table(
            self.parameters,
            self.control,
            self.displacement,
            self.position,
            self.azimuth,
            self.rolling,
        )

    def inner_approach(self) -> Floats:
        """How far every ball is pressed into the inner groove; (cases, balls), m, a gap below 0.

        Past the edge of the groove: into its flank, were that higher.
        """
        a1, a2 = groove_centres(self.parameters, self.displacement, self.azimuth)
        up = np.maximum(a2 - self.position[..., 1], 0.0)
        distance = np.hypot(a1 - self.position[..., 0], up)
        return np.asarray(distance - self.parameters[layout.INNER_LENGTH][:, np.newaxis])


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
    raceway_control
        (cases, balls): 1 outer, -1 inner, 0 where Jones's criterion favours neither
    rows
        the rows of balls of a set, one by one; a plain bearing has one
    """

    code: NDArray[np.int64]
    unsupported: NDArray[np.int64]
    residual: Floats
    iterations: NDArray[np.int64]
    safe_path: NDArray[np.bool_]
    displacement: Floats
    load: Floats
    stiffness: Floats
    raceway_control: NDArray[np.int64]
    rows: tuple[RowBatch, ...]

    def __len__(self) -> int:
        """Count the cases."""
        return len(self.code)

    @property
    def converged(self) -> NDArray[np.bool_]:
        """(cases,): whether there is a result."""
        converged: NDArray[np.bool_] = self.code == status.CONVERGED
        return converged

    @property
    def status(self) -> NDArray[np.str_]:
        """(cases,): the name of each case's status."""
        return np.array([STATUS_NAMES[int(code)] for code in self.code], dtype=np.str_)

    @property
    def row(self) -> NDArray[np.int64]:
        """(balls,): the row of each ball, counted from 0."""
        counts = [row.azimuth.shape[1] for row in self.rows]
        return np.repeat(np.arange(len(counts)), counts)

    def balls(self) -> BallTable:
        """Evaluate every ball of every case: arrays (cases, balls), row after row."""
        return _side_by_side([row.balls() for row in self.rows])

    def contact(self, race: Race, table: BallTable | None = None) -> HertzContact:
        """Ellipse and pressure of every contact of a race: arrays (cases, balls).

        table: what `balls` returns, if it is at hand.
        """
        table = self.balls() if table is None else table
        contacts = table.inner if race == "inner" else table.outer
        ends = np.cumsum([row.azimuth.shape[1] for row in self.rows])[:-1]
        parts = []
        for index, row in enumerate(self.rows):
            own = _mapped(lambda array, i=index: np.split(array, ends, axis=1)[i], contacts)
            parts.append(hertz(row.parameters, own, race))
        return _side_by_side(parts)


def _side_by_side(parts: list[T]) -> T:
    """Join records of arrays (cases, balls) along the balls."""
    return parts[0] if len(parts) == 1 else reduce(_joined, parts)


def _joined(one: Any, other: Any) -> Any:
    if isinstance(one, np.ndarray):
        return np.concatenate([one, other], axis=1)
    return type(one)(*(_joined(getattr(one, f.name), getattr(other, f.name)) for f in fields(one)))


def _mapped(function: Any, record: T) -> T:
    """Apply a function to every array of a record."""
    return type(record)(*(function(getattr(record, f.name)) for f in fields(record)))  # type: ignore[arg-type]
