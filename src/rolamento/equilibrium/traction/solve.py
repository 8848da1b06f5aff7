"""Equilibrium with friction-controlled balls: from columns of parameters to motions and forces.

The start is the equilibrium under outer raceway control. What comes out replaces its places, its
motions and its loads; a case that does not settle is left without a result.
"""

from __future__ import annotations

import logging
import os
from concurrent.futures import ThreadPoolExecutor
from typing import Final

import numpy as np

from rolamento.contact.hertz import elliptical_contact
from rolamento.equilibrium import accept, rows
from rolamento.equilibrium.problem import LEAST_ANGLE_COSINE, Floats
from rolamento.equilibrium.rolling import Rolling
from rolamento.equilibrium.run import Solution
from rolamento.equilibrium.traction import system
from rolamento.equilibrium.traction.ball import (
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
)
from rolamento.equilibrium.traction.contact import ellipse_nodes
from rolamento.geometry import Race, race_curvature

_log = logging.getLogger("rolamento")

SMOOTHEST: Final = 1e-1
"""Where the friction begins: the smoothing speed over |ω_i - ω_o| D."""
SMOOTHING: Final = 1e-4
"""Where it ends; the power changes by less than 1 in 10^3 from there to Coulomb's law."""
MESHES: Final = {"coarse": (40, 5), "fine": (120, 9)}
COARSE: Final = MESHES["coarse"]


def solve_rolling(
    p: Floats,
    start: Solution,
    balls: int,
    friction: Floats,
    drag: Floats,
    *,
    mesh: str = "fine",
    threads: int | None = None,
) -> tuple[Solution, Rolling]:
    """Let friction control the balls of every case.

    p: (rows.COLUMN, cases); start: under outer raceway control; friction: μ, (cases,); drag: the
    torque that holds the cage back, (cases,), N·m. Returns the solution, scaled as `run` has it,
    and the motions.
    """
    cases = p.shape[1]
    constants = case_constants(p, friction)
    solution = Solution.empty(cases, balls)
    solution.put(np.arange(cases), start)
    rolling = Rolling(
        cage_speed=np.full(cases, np.nan),
        angular_velocity=np.full((cases, balls, 3), np.nan),
        inner=np.full((cases, balls, 6), np.nan),
        outer=np.full((cases, balls, 6), np.nan),
        power=np.full((cases, balls, 2), np.nan),
        radius=constants[RADIUS].copy(),
    )
    azimuth = 2.0 * np.pi * np.arange(balls) / balls
    cosines, sines = np.cos(azimuth), np.sin(azimuth)
    coarse, fine = ellipse_nodes(*COARSE), ellipse_nodes(*MESHES[mesh])
    columns = np.ascontiguousarray(p[: rows.PARAMETERS])
    turning = p[rows.INNER_SPEED] != p[rows.OUTER_SPEED]
    if not system.solve_with_friction.is_cached:
        _log.warning("compiling the friction solver for this machine, once: some half a minute")
    wanted = np.flatnonzero((start.code == accept.CONVERGED) & turning)

    def run(case: int) -> None:
        u, x = np.zeros(system.RING), start.position[case].copy()
        u[:5] = start.displacement[case]
        omega, view = np.zeros((balls, 3)), np.zeros((balls, 4))
        forces, tangent = np.zeros((balls, system.FORCES)), np.zeros((5, 5))
        code, residual, steps = system.solve_with_friction.compiled(
            columns, case, constants[:, case].copy(), float(drag[case]), cosines, sines, coarse,
            fine, SMOOTHEST, SMOOTHING, u, x, omega, view, forces, tangent,
        )  # fmt: skip
        solution.residual[case] = residual
        solution.iterations[case] += steps
        if code != system.CONVERGED:
            solution.code[case] = accept.NOT_CONVERGED
            return
        solution.displacement[case], solution.position[case] = u[:5], x
        solution.reaction[case] = _reaction(columns[:, case], cosines, sines, view)
        solution.stiffness[case] = tangent
        rolling.cage_speed[case], rolling.angular_velocity[case] = u[system.CAGE], omega
        rolling.power[case] = forces[:, 4:6]
        rolling.inner[case] = forces[:, system.OF_INNER : system.OF_OUTER]
        rolling.outer[case] = forces[:, system.OF_OUTER : system.FORCES]

    workers = min(threads or os.cpu_count() or 1, max(len(wanted), 1))
    if workers == 1:
        for case in wanted:
            run(int(case))
    else:
        with ThreadPoolExecutor(workers) as pool:
            list(pool.map(run, wanted.tolist()))
    return solution, rolling


def _reaction(p: Floats, cosines: Floats, sines: Floats, view: Floats) -> Floats:
    """What the balls ask of the ring: x, y, z, ry R_i, rz R_i."""
    total = np.zeros(5)
    c0, s0 = p[rows.COS_FIRST], p[rows.SIN_FIRST]
    for c, s, ball in zip(cosines, sines, view, strict=True):
        system.add_reaction(c * c0 - s * s0, s * c0 + c * s0, ball, total)
    return total


def case_constants(p: Floats, friction: Floats) -> Floats:
    """What the kernel needs beside `rows`; (CONSTANTS, cases)."""
    cases = p.shape[1]
    k = np.zeros((CONSTANTS, cases))
    diameter = p[rows.BALL_DIAMETER]
    pitch = diameter / p[rows.GAMMA]
    # switched-off effects are zero in the column: mass from one, inertia from the other
    k[RADIUS] = 0.5 * pitch
    k[MASS] = 2.0 * p[rows.CENTRIFUGAL] / pitch
    k[INERTIA] = p[rows.GYROSCOPIC] * p[rows.GAMMA] * diameter
    k[HALF] = 0.5 * diameter
    k[FRICTION] = friction
    for race, length, groove, axes in _RACES:
        conformity = 0.5 + p[length] / diameter
        k[groove] = 2.0 * conformity * diameter / (2.0 * conformity + 1.0)
        k[axes : axes + 2 * rows.COEFFICIENTS] = _axes_polynomials(p, conformity, race)
    return k


_RACES: Final[tuple[tuple[Race, int, int, int], ...]] = (
    ("inner", rows.INNER_LENGTH, GROOVE_INNER, AXES_INNER),
    ("outer", rows.OUTER_LENGTH, GROOVE_OUTER, AXES_OUTER),
)


def _axes_polynomials(p: Floats, conformity: Floats, race: Race) -> Floats:
    """Coefficients of a / Q^(1/3) and b / Q^(1/3) in cos α; (14, cases)."""
    count = rows.COEFFICIENTS
    chebyshev = np.cos(np.pi * (np.arange(count) + 0.5) / count)
    cosines = LEAST_ANGLE_COSINE + 0.5 * (1.0 - LEAST_ANGLE_COSINE) * (1.0 + chebyshev)
    diameter = p[rows.BALL_DIAMETER]
    curvature = race_curvature(
        diameter, diameter / p[rows.GAMMA], conformity, np.arccos(cosines)[:, np.newaxis], race
    )
    contact = elliptical_contact(1.0, curvature.rolling, curvature.across, p[rows.MODULUS])
    powers = np.vander(cosines, count, increasing=True)
    return np.concatenate(
        [np.linalg.solve(powers, contact.semi_major), np.linalg.solve(powers, contact.semi_minor)]
    )


__all__ = ["MESHES", "solve_rolling"]
