"""What the theories of life read of solved cases: the same arrays from a batch or one state."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from rolamento.case import Case
from rolamento.contact.hertz import effective_modulus
from rolamento.geometry import Race, ring_geometry
from rolamento.life.ioannides_harris import Ellipses
from rolamento.numerics import BoolArray, FloatArray
from rolamento.rows.ball import BatchState, layout
from rolamento.rows.ball.detail import BallTable
from rolamento.state import State


@dataclass(frozen=True, slots=True, eq=False)
class SolvedRows:
    """Rows of solved cases. Arrays (cases or 1, rows) unless said otherwise, SI.

    Attributes
    ----------
    inner_load, outer_load
        of the balls, (cases, balls), row after row; NaN without a result
    row_starts
        index of each row's first ball
    signs
        of the rows: +1 or -1, the way that each faces
    ball_count
        (rows,)
    ball_diameter, pitch_diameter, inner_conformity, outer_conformity, contact_angle, modulus
        of the rows; the angle is the free one of a bearing given by it, 0 of one given by clearance
    ring_load
        fx, fy, fz, my, mz on the inner ring, (cases, 5)
    inner_speed, outer_speed
        (cases,)
    steel_balls
        whether the balls of all rows are of the rings' stiffness
    preloaded
        whether rows of a set press on each other
    """

    inner_load: FloatArray
    outer_load: FloatArray
    row_starts: tuple[int, ...]
    signs: tuple[float, ...]
    ball_count: FloatArray
    ball_diameter: FloatArray
    pitch_diameter: FloatArray
    inner_conformity: FloatArray
    outer_conformity: FloatArray
    contact_angle: FloatArray
    modulus: FloatArray
    ring_load: FloatArray
    inner_speed: FloatArray
    outer_speed: FloatArray
    steel_balls: bool
    preloaded: bool
    source: State | BatchState = field(repr=False)
    table: BallTable | None = field(default=None, repr=False)

    def __len__(self) -> int:
        """Count the cases."""
        return len(self.inner_load)

    @property
    def speed(self) -> FloatArray:
        """(cases,): of the rings against each other, unsigned."""
        return np.asarray(np.abs(self.inner_speed - self.outer_speed))

    @property
    def unloaded(self) -> BoolArray:
        """(cases,): whether no ball carries load from ring to ring; not without a result."""
        return np.asarray(np.all(self.inner_load == 0.0, axis=1))

    def ellipses(self, race: Race) -> Ellipses:
        """Contacts of a race, (cases, balls)."""
        if isinstance(self.source, BatchState):
            hertz = self.source.contact(race, self.table)
            return Ellipses(hertz.semi_major, hertz.semi_minor, hertz.max_pressure)
        balls = self.source.balls
        return Ellipses(
            *(
                np.array([[getattr(getattr(ball, race), name) for ball in balls]])
                for name in ("semi_major", "semi_minor", "max_pressure")
            )
        )


def rows_of_state(state: State) -> SolvedRows:
    """Gather the rows of one state, as a batch of one case."""
    nan = 0.0 if state.status.converged else np.nan
    places = state.case.bearing.places
    duty = state.case.duty

    def column(name: str) -> FloatArray:
        return np.array([[float(getattr(place.bearing, name)) for place in places]])

    angles = [
        ring_geometry(p.bearing).free_contact_angle if p.bearing.contact_angle is not None else 0.0
        for p in places
    ]
    counts = [place.bearing.ball_count for place in places]
    steel, preloaded = _kind(state.case)
    return SolvedRows(
        inner_load=np.array([[ball.inner.load for ball in state.balls]]) + nan,
        outer_load=np.array([[ball.outer.load for ball in state.balls]]) + nan,
        row_starts=_starts(counts),
        signs=tuple(place.sign for place in places),
        ball_count=np.array(counts, dtype=np.float64),
        ball_diameter=column("ball_diameter"),
        pitch_diameter=column("pitch_diameter"),
        inner_conformity=column("inner_conformity"),
        outer_conformity=column("outer_conformity"),
        contact_angle=np.array([angles]),
        modulus=np.array(
            [[effective_modulus(p.bearing.ring_material, p.bearing.ball_material) for p in places]]
        ),
        ring_load=np.array([list(state.load)]) + nan,
        inner_speed=np.array([duty.inner_speed]),
        outer_speed=np.array([duty.outer_speed]),
        steel_balls=steel,
        preloaded=preloaded,
        source=state,
    )


def rows_of_batch(case: Case, batch: BatchState) -> SolvedRows:
    """Gather the rows of a batch; case: what was solved, for what its rows are made of."""
    table = batch.balls()
    counts = [row.azimuth.shape[1] for row in batch.rows]
    first = batch.rows[0].parameters

    def spread(index: int) -> FloatArray:
        return np.stack([row.parameters[index] for row in batch.rows], axis=1)

    diameter = spread(layout.BALL_DIAMETER)
    # by the radial offset: a preload moves the axial one
    distance = spread(layout.INNER_LENGTH) + spread(layout.OUTER_LENGTH)
    cosine = np.clip(spread(layout.RADIAL_OFFSET) / distance, 0.0, 1.0)
    angle = np.where(spread(layout.ONE_SIDED) > 0.0, np.arccos(cosine), 0.0)
    steel, preloaded = _kind(case)
    solved = batch.converged[:, np.newaxis]
    return SolvedRows(
        inner_load=np.where(solved, table.inner.load, np.nan),
        outer_load=np.where(solved, table.outer.load, np.nan),
        row_starts=_starts(counts),
        signs=tuple(place.sign for place in case.bearing.places),
        ball_count=np.array(counts, dtype=np.float64),
        ball_diameter=diameter,
        pitch_diameter=diameter / spread(layout.GAMMA),
        inner_conformity=0.5 + spread(layout.INNER_LENGTH) / diameter,
        outer_conformity=0.5 + spread(layout.OUTER_LENGTH) / diameter,
        contact_angle=angle,
        modulus=spread(layout.MODULUS),
        ring_load=np.where(solved, batch.load, np.nan),
        inner_speed=first[layout.INNER_SPEED],
        outer_speed=first[layout.OUTER_SPEED],
        steel_balls=steel,
        preloaded=preloaded,
        source=batch,
        table=table,
    )


def _starts(counts: list[int]) -> tuple[int, ...]:
    return tuple(int(start) for start in np.cumsum([0, *counts[:-1]]))


def _kind(case: Case) -> tuple[bool, bool]:
    """Whether the balls are as stiff as the rings, within a tenth, and whether there is preload."""
    steel = all(
        abs(p.bearing.ball_material.youngs_modulus / p.bearing.ring_material.youngs_modulus - 1.0)
        <= 0.1
        for p in case.bearing.places
    )
    return steel, case.bearing.preload is not None
