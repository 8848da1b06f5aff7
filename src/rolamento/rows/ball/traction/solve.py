"""Equilibrium with friction-controlled balls: from columns of parameters to motions and forces.

The start is the equilibrium under outer raceway control. What comes out replaces its places, its
motions and its loads; a case that does not settle is left without a result.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

import numpy as np

from rolamento import status
from rolamento.contact.hertz import elliptical_contact
from rolamento.geometry import Race, race_curvature
from rolamento.numerics.threads import share_out
from rolamento.records import frozen
from rolamento.rows.ball import layout
from rolamento.rows.ball.detail import BallTable, ball_table
from rolamento.rows.ball.problem import Columns, Floats, directions, ring_arms
from rolamento.rows.ball.rolling import Rolling
from rolamento.rows.ball.run import BallResponse, has_inertia
from rolamento.rows.ball.traction import balance, system
from rolamento.rows.ball.traction.balance import Place
from rolamento.rows.ball.traction.ball import (
    AXES_INNER,
    AXES_OUTER,
    CONSTANTS,
    FRICTION,
    GROOVE_INNER,
    GROOVE_OUTER,
    HALF,
    INERTIA,
    MASS,
    RADIUS,
    Mesh,
    Rig,
)
from rolamento.rows.ball.traction.contact import ellipse_nodes
from rolamento.rows.row import Film

SMOOTHEST: Final = 1.0
"""Where the friction begins: the smoothing speed over |ω_i - ω_o| D."""
SMOOTHING: Final = 1e-4
"""Where it ends; the power changes by less than 1 in 10^3 from there to Coulomb's law."""
MESHES: Final = {"coarse": (40, 5), "fine": (120, 9)}
COARSEST: Final = (40, 3)
"""Until the friction is sharp."""
MOST_IMBALANCE: Final = 1e-6
"""Fraction of the power: what may be missing between the rings' work and the losses."""


def solve_rolling(
    p: Columns,
    start: BallResponse,
    balls: int,
    friction: Floats,
    drag: Floats,
    *,
    mesh: str = "fine",
    film: Film | None = None,
    threads: int | None = None,
) -> BallResponse:
    """Let friction control the balls of every case.

    start: under outer raceway control; friction: μ, (cases,); drag: the
    torque that holds the cage back, (cases,), N·m; film: what shears in the contacts.
    """
    cases = p.cases
    constants = case_constants(p, friction)
    solution = BallResponse.empty(cases, balls, start.arms)
    solution.put(np.arange(cases), start)
    table = ball_table(p, np.ones((1, balls)), start.displacement, start.position)
    rolling = Rolling.empty(cases, balls, constants[RADIUS], _mean_orbit(table))
    if film is not None:
        rolling.lift[:] = film.lift
    problem = _Problem.of(p, constants, drag, balls, mesh, film)
    turning = p[layout.INNER_SPEED] != p[layout.OUTER_SPEED]
    wanted = np.flatnonzero((start.number == status.CONVERGED) & turning).tolist()

    def run(kernel: Callable[..., Any], first: int, last: int) -> None:
        for case in wanted[first:last]:
            _solve_case(kernel, problem, case, solution, rolling)

    kernel = system.solve_with_friction
    share_out(kernel, run, len(wanted), chunk=1, threads=threads, little=False)
    _check_power(p, drag, solution, rolling)
    solution.motion = rolling
    return solution


@frozen
class _Problem:
    """What all cases of a batch are solved from."""

    p: Floats
    constants: Floats
    drag: Floats
    cosines: Floats
    sines: Floats
    coarse: tuple[Floats, Floats, Floats]
    fine: tuple[Floats, Floats, Floats]
    film: Film | None

    @classmethod
    def of(
        cls,
        p: Columns,
        constants: Floats,
        drag: Floats,
        balls: int,
        mesh: str,
        film: Film | None = None,
    ) -> _Problem:
        """Prepare the arrays of a batch."""
        return cls(
            p.whole(), constants, drag, *directions(balls),
            ellipse_nodes(*COARSEST), ellipse_nodes(*MESHES[mesh]), film,
        )  # fmt: skip

    def rig(self, case: int) -> Rig:
        """One case, as the kernel takes it."""
        constants = np.ascontiguousarray(self.constants[:, case])
        return Rig(self.p, case, constants, float(self.drag[case]), self.cosines, self.sines)

    def mesh(self, nodes: tuple[Floats, Floats, Floats], case: int) -> Mesh:
        """Nodes with room of their own for the smoothing, and the film of a case."""
        least = np.zeros(nodes[0].size)
        if self.film is None:
            return Mesh(*nodes, least)
        slow = self.film.slip_speed(case, nodes[0], nodes[1])
        return Mesh(*nodes, least, np.ascontiguousarray(slow**2), self.film.lift[case].copy())


def _solve_case(
    kernel: Callable[..., Any],
    problem: _Problem,
    case: int,
    solution: BallResponse,
    rolling: Rolling,
) -> None:
    """Solve one case and put the result into its place, or the code of its failure."""
    rig, balls = problem.rig(case), problem.cosines.size
    u = np.append(solution.displacement[case], 0.0)
    place = Place(u, solution.position[case].copy(), np.zeros((balls, 3)))
    reaction, tangent = np.zeros(layout.DEGREES_OF_FREEDOM), np.zeros((5, 5))
    forces = np.zeros((balls, balance.FORCES))
    coarse, fine = problem.mesh(problem.coarse, case), problem.mesh(problem.fine, case)
    code, solution.residual[case], steps = kernel(
        rig, place, coarse, fine, SMOOTHEST, SMOOTHING, reaction, forces, tangent
    )
    solution.iterations[case] += steps
    if code != system.CONVERGED:
        solution.number[case] = status.NOT_CONVERGED
        return
    touched = np.asarray(forces[:, :2].sum(axis=1) > 0.0)
    rolling.cage_speed[case] = place.u[balance.CAGE]
    rolling.angular_velocity[case] = np.where(touched[:, np.newaxis], place.omega, np.nan)
    rolling.power[case] = forces[:, balance.INNER_POWER : balance.OF_INNER]
    rolling.inner[case] = forces[:, balance.OF_INNER : balance.OF_OUTER]
    rolling.outer[case] = forces[:, balance.OF_OUTER : balance.FORCES]
    solution.displacement[case], solution.position[case] = place.u[:5], place.x
    arms = ring_arms(problem.p[:, case])
    solution.force[case] = reaction * arms
    solution.stiffness[case] = tangent * np.outer(arms, arms)


def _check_power(p: Columns, drag: Floats, solution: BallResponse, rolling: Rolling) -> None:
    """Compare the work of shaft and housing with the losses; a case that fails has no result."""
    work = p[layout.INNER_SPEED] * rolling.torque("inner")
    work += p[layout.OUTER_SPEED] * rolling.torque("outer")
    lost = np.asarray(rolling.power.sum(axis=(1, 2))) + drag * np.abs(rolling.cage_speed)
    with np.errstate(invalid="ignore", divide="ignore"):
        rolling.imbalance[:] = np.abs(work - lost) / lost
    failed = np.isfinite(rolling.cage_speed)
    failed &= ~(rolling.imbalance <= MOST_IMBALANCE)
    solution.number[failed] = status.NOT_CONVERGED
    rolling.forget(failed)


def _mean_orbit(table: BallTable) -> Floats:
    """The cage's speed under raceway control, the balls' mean weighted by their loads; (cases,)."""
    load = np.where(table.inner.load > 0.0, table.inner.load, 0.0)
    with np.errstate(invalid="ignore", divide="ignore"):
        mean = (load * np.nan_to_num(table.motion.orbital_speed)).sum(axis=1) / load.sum(axis=1)
    return np.asarray(mean)


def case_constants(p: Columns, friction: Floats) -> Floats:
    """What the kernel needs beside `rows`; (CONSTANTS, cases)."""
    cases = p.cases
    k = np.zeros((CONSTANTS, cases))
    diameter = p[layout.BALL_DIAMETER]
    pitch = diameter / p[layout.GAMMA]
    # switched-off effects are zero in the column: mass from one, inertia from the other
    k[RADIUS] = 0.5 * pitch
    moving = has_inertia(p)  # else it cannot be told from rounding
    k[MASS] = np.where(moving, 2.0 * p[layout.CENTRIFUGAL] / pitch, 0.0)
    k[INERTIA] = np.where(moving, p[layout.GYROSCOPIC] * p[layout.GAMMA] * diameter, 0.0)
    k[HALF] = 0.5 * diameter
    k[FRICTION] = friction
    for race, length, radius, axes in _RACES:
        conformity = 0.5 + p[length] / diameter
        k[radius] = 2.0 * conformity * diameter / (2.0 * conformity + 1.0)
        k[axes : axes + 2 * layout.COEFFICIENTS] = _axes_polynomials(p, conformity, race)
    return k


_RACES: Final[tuple[tuple[Race, int, int, int], ...]] = (
    ("inner", layout.INNER_LENGTH, GROOVE_INNER, AXES_INNER),
    ("outer", layout.OUTER_LENGTH, GROOVE_OUTER, AXES_OUTER),
)


def _axes_polynomials(p: Columns, conformity: Floats, race: Race) -> Floats:
    """Coefficients of a / Q^(1/3) and b / Q^(1/3) in cos α; (14, cases)."""
    count = layout.COEFFICIENTS
    chebyshev = np.cos(np.pi * (np.arange(count) + 0.5) / count)
    cosines = 0.5 * (1.0 + chebyshev)
    diameter = p[layout.BALL_DIAMETER]
    curvature = race_curvature(
        diameter, diameter / p[layout.GAMMA], conformity, np.arccos(cosines)[:, np.newaxis], race
    )
    contact = elliptical_contact(1.0, curvature.rolling, curvature.across, p[layout.MODULUS])
    powers = np.vander(cosines, count, increasing=True)
    return np.concatenate(
        [np.linalg.solve(powers, contact.semi_major), np.linalg.solve(powers, contact.semi_minor)]
    )


__all__ = ["MESHES", "solve_rolling"]
