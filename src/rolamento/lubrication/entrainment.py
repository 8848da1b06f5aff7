"""Moved to `rolamento.kinematics`."""

from rolamento.kinematics import SurfaceSpeeds, rolling_entrainment_speed, surface_speeds

__all__ = ["SurfaceSpeeds", "rolling_entrainment_speed", "surface_speeds"]
