"""Stiffness of a ball at its races: the contact at the inner one, the outer one, both in line."""

from __future__ import annotations

from typing import Protocol

from numpy.typing import ArrayLike

from rolamento.contact.hertz import (
    ElasticMaterial,
    contact_stiffness,
    effective_modulus,
    series_stiffness,
)
from rolamento.geometry import BearingGeometry, Race, race_curvature
from rolamento.numerics import FloatArray
from rolamento.records import frozen


class BallBearing(BearingGeometry, Protocol):
    """What contacts and static analyses read of a bearing: geometry, balls and materials."""

    @property
    def ball_count(self) -> int:
        """Z."""
        ...

    @property
    def ring_material(self) -> ElasticMaterial:
        """Material of both rings."""
        ...

    @property
    def ball_material(self) -> ElasticMaterial | None:
        """Material of the balls; None: that of the rings."""
        ...


@frozen
class RaceStiffness:
    """Contact stiffness of a ball at the inner and outer race, and of both in line; N/m^1.5."""

    inner: FloatArray
    outer: FloatArray
    combined: FloatArray


def race_stiffness(bearing: BallBearing, contact_angle: ArrayLike) -> RaceStiffness:
    """Hertz stiffness at both races for a ball at a contact angle.

    Parameters
    ----------
    bearing : any object with the attributes of `BallBearing`; SI.
    contact_angle : array, the same at both races; rad.

    Returns
    -------
    RaceStiffness of that shape; N/m^1.5.

    Radaelli (2013) eqs. 10 and 11.
    """
    inner = _stiffness(bearing, contact_angle, "inner", bearing.inner_conformity)
    outer = _stiffness(bearing, contact_angle, "outer", bearing.outer_conformity)
    return RaceStiffness(inner, outer, series_stiffness(inner, outer))


def _stiffness(
    bearing: BallBearing, contact_angle: ArrayLike, race: Race, conformity: float
) -> FloatArray:
    rings, balls = bearing.ring_material, bearing.ball_material
    modulus = effective_modulus(rings, rings if balls is None else balls)
    curvature = race_curvature(
        bearing.ball_diameter, bearing.pitch_diameter, conformity, contact_angle, race
    )
    return contact_stiffness(curvature.rolling, curvature.across, modulus)
