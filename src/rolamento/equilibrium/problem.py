"""From bearings and duties to the numbers that the kernels work on: a column a case."""

from __future__ import annotations

from functools import lru_cache
from math import cos, sin
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.bearing import Bearing
from rolamento.case import Case
from rolamento.contact.hertz import effective_modulus
from rolamento.equilibrium import rows
from rolamento.geometry import groove_places
from rolamento.kinematics import ball_mass
from rolamento.model import Model
from rolamento.static import race_stiffness

Floats = NDArray[np.float64]

LEAST_ANGLE_COSINE: Final = -0.1
"""Where the polynomials of the stiffness begin: light, fast balls touch a little beyond 90°."""


def case_parameters(case: Case) -> Floats:
    """The parameters of a case of one row in the order of `rows`; shape (rows.COLUMN,), SI."""
    p = bearing_column(case.bearing).copy()
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
def bearing_column(bearing: Bearing) -> Floats:
    """What does not depend on the duty, of a bearing of one row; not to be written to."""
    p = bearing_columns(bearing, ())
    p.flags.writeable = False
    return p


def bearing_columns(bearing: Any, shape: tuple[int, ...]) -> Floats:
    """What does not depend on the duty; (rows.COLUMN, *shape).

    bearing: a `Bearing`, or an object with its attributes as arrays that broadcast to the shape.
    """
    diameter, pitch = bearing.ball_diameter, bearing.pitch_diameter
    places = groove_places(
        diameter,
        pitch,
        bearing.inner_conformity,
        bearing.outer_conformity,
        contact_angle=bearing.contact_angle,
        diametral_clearance=bearing.diametral_clearance,
    )
    mass = ball_mass(diameter, bearing.ball_material.density)
    p = np.zeros((rows.COLUMN, *shape))
    p[rows.OUTER_LENGTH] = places.outer_length
    p[rows.INNER_LENGTH] = places.inner_length
    p[rows.AXIAL_OFFSET] = places.axial_offset
    p[rows.RADIAL_OFFSET] = places.radial_offset
    p[rows.GAMMA] = diameter / pitch
    p[rows.CENTRIFUGAL] = 0.5 * mass * pitch
    p[rows.GYROSCOPIC] = 0.1 * mass * pitch
    p[rows.ARM] = places.inner_groove_radius
    p[rows.FRICTION_ARM] = bearing.inner_conformity * diameter / places.inner_groove_radius
    p[rows.ONE_SIDED] = bearing.contact_angle is not None and np.greater(bearing.contact_angle, 0.0)
    p[rows.BALL_DIAMETER] = diameter
    p[rows.MODULUS] = effective_modulus(bearing.ring_material, bearing.ball_material)
    polynomials = _stiffness_polynomials(bearing, len(shape))
    for row, coefficients in zip(
        (rows.INNER_STIFFNESS, rows.OUTER_STIFFNESS, rows.SERIES_STIFFNESS),
        polynomials,
        strict=True,
    ):
        p[row : row + rows.COEFFICIENTS] = coefficients
    return p


def _stiffness_polynomials(bearing: Any, dimensions: int) -> tuple[Floats, ...]:
    """Coefficients of K_i, K_o and both in series as polynomials in cos α; (7, *shape) each.

    The exact stiffness depends on the loaded angle through the curvatures, weakly: a polynomial
    through seven Chebyshev points keeps it within 1e-10 for D/d_m up to 0.2, 2e-9 up to 0.3.
    """
    count = rows.COEFFICIENTS
    chebyshev = np.cos(np.pi * (np.arange(count) + 0.5) / count)
    cosines = LEAST_ANGLE_COSINE + 0.5 * (1.0 - LEAST_ANGLE_COSINE) * (1.0 + chebyshev)
    angles = np.arccos(cosines).reshape(count, *(1,) * dimensions)
    exact = race_stiffness(bearing, angles)
    powers = np.vander(cosines, count, increasing=True)
    return tuple(
        np.asarray(np.linalg.solve(powers, values.reshape(count, -1)).reshape(values.shape))
        for values in (exact.inner, exact.outer, exact.combined)
    )
