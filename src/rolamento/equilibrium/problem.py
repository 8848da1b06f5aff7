"""From a case to the numbers that the kernels work on: one column of parameters."""

from __future__ import annotations

from functools import lru_cache
from math import cos, sin
from typing import Final

import numpy as np
from numpy.typing import NDArray

from rolamento.bearing import Bearing
from rolamento.case import Case
from rolamento.equilibrium import rows
from rolamento.geometry import ring_geometry
from rolamento.kinematics import ball_mass
from rolamento.model import Model
from rolamento.static import race_stiffness

Floats = NDArray[np.float64]

LEAST_ANGLE_COSINE: Final = -0.1
"""Where the polynomials of the stiffness begin: light, fast balls touch a little beyond 90°."""


def case_parameters(case: Case) -> Floats:
    """The parameters of a case in the order of `rows`; shape (rows.PARAMETERS,), SI."""
    p = _bearing_parameters(case.bearing).copy()
    apply_model(p, case.model)
    duty = case.duty
    p[rows.INNER_SPEED] = duty.inner_speed
    p[rows.OUTER_SPEED] = duty.outer_speed
    p[rows.COS_FIRST] = cos(duty.first_ball_azimuth)
    p[rows.SIN_FIRST] = sin(duty.first_ball_azimuth)
    arms = ring_arms(p)
    p[rows.APPLIED : rows.APPLIED + 5] = duty.applied_load / arms
    p[rows.IMPOSED : rows.IMPOSED + 5] = duty.imposed_displacement * arms
    p[rows.FREE : rows.FREE + 5] = duty.free
    return p


def ring_arms(p: Floats) -> Floats:
    """The lengths (1, 1, 1, R_i, R_i) that turn tilts into shifts and moments into forces."""
    arms = np.ones((rows.DEGREES_OF_FREEDOM, *p.shape[1:]))
    arms[3:] = p[rows.ARM]
    return arms


def apply_model(p: Floats, model: Model) -> None:
    """Switch inertia effects off, and share out the gyroscopic moment, as the model says."""
    p[rows.CENTRIFUGAL] *= model.centrifugal_force
    p[rows.GYROSCOPIC] *= model.gyroscopic_moment
    p[rows.LAMBDA_INNER] = 1.0 if model.raceway_control == "none" else 0.0


@lru_cache(maxsize=256)
def _bearing_parameters(bearing: Bearing) -> Floats:
    """What does not depend on the duty."""
    ring = ring_geometry(bearing)
    mass = float(ball_mass(bearing.ball_diameter, bearing.ball_material.density))
    inner, outer, series = _stiffness_polynomials(bearing)
    p = np.zeros(rows.PARAMETERS)
    p[rows.OUTER_LENGTH] = ring.outer_length
    p[rows.INNER_LENGTH] = ring.inner_length
    p[rows.AXIAL_OFFSET] = ring.axial_offset
    p[rows.RADIAL_OFFSET] = ring.radial_offset
    p[rows.GAMMA] = bearing.ball_diameter / bearing.pitch_diameter
    p[rows.CENTRIFUGAL] = 0.5 * mass * bearing.pitch_diameter
    p[rows.GYROSCOPIC] = 0.1 * mass * bearing.pitch_diameter
    p[rows.ARM] = ring.inner_groove_radius
    p[rows.FRICTION_ARM] = (
        bearing.inner_conformity * bearing.ball_diameter / ring.inner_groove_radius
    )
    p[rows.ONE_SIDED] = ring.one_sided
    p[rows.BALL_DIAMETER] = bearing.ball_diameter
    p[rows.OUTER_STIFFNESS : rows.OUTER_STIFFNESS + rows.COEFFICIENTS] = outer
    p[rows.INNER_STIFFNESS : rows.INNER_STIFFNESS + rows.COEFFICIENTS] = inner
    p[rows.SERIES_STIFFNESS : rows.SERIES_STIFFNESS + rows.COEFFICIENTS] = series
    p.flags.writeable = False
    return p


def _stiffness_polynomials(bearing: Bearing) -> Floats:
    """Coefficients of K_i, K_o and both in series as polynomials in cos α.

    The exact stiffness depends on the loaded angle through the curvatures, weakly: a polynomial
    through seven Chebyshev points keeps it within 1e-10 for D/d_m up to 0.2, 2e-9 up to 0.3.
    """
    count = rows.COEFFICIENTS
    chebyshev = np.cos(np.pi * (np.arange(count) + 0.5) / count)
    cosines = LEAST_ANGLE_COSINE + 0.5 * (1.0 - LEAST_ANGLE_COSINE) * (1.0 + chebyshev)
    exact = race_stiffness(bearing, np.arccos(cosines))
    powers = np.vander(cosines, count, increasing=True)
    values = np.stack([exact.inner, exact.outer, exact.combined], axis=1)
    return np.asarray(np.linalg.solve(powers, values).T, dtype=np.float64)
