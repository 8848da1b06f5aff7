"""Palmgren's friction torque of lubricated machine bearings: M = M0 + M1, and M2 of rollers' ribs.

With lengths in mm, ν in mm²/s and n in rpm, moments come in N·mm:

    M0 = 1e-7 f0 (ν n)^(2/3) d_m³      for ν n ≥ 2000, else 160e-7 f0 d_m³
    M1 = f1 P1 d_m,    f1 = z (P0/C0)^y of balls, a constant of rollers
    M2 = f2 F_a d_m    of cylindrical roller bearings whose ribs carry an axial load

P1 = max(3 F_a - 0.1 F_r, F_r) for deep-groove bearings, max(0.9 F_a cot α - 0.1 F_r, F_r) for
angular-contact ones; what it is of each type, and f0, z and y, stand in data/palmgren.toml. The
constants hold for moderate speed and load and the lubrication named.

Palmgren (1959); Harris (1991), chapter 14.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from math import pi
from typing import TYPE_CHECKING, Final, Literal

import numpy as np
from numpy.typing import ArrayLike

from rolamento.friction.model import (
    RIB_LOAD_SHARE,
    Setting,
    Torque,
    TorqueModel,
    added,
    bearing_load,
    limits_of_lubricated_bearings,
    torque_of_parts,
)
from rolamento.io.data import toml_of
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.validate import numbers, one_of, positive
from rolamento.words import marked

if TYPE_CHECKING:
    from rolamento.friction.machine import MachineBearing

Lubrication = Literal["grease", "oil_mist", "oil_bath", "oil_jet"]


@frozen
class Constants:
    """What Palmgren's model has of a type of bearing; data/palmgren.toml says whence.

    f0: by the way of lubrication. z, y: of f1. axial, radial: of P1; by_cotangent: whether the
    axial load counts by cot α; only_axial: whether the radial one does not count at all. ribs:
    whether an axial load rubs on them.
    """

    f0: Mapping[str, float]
    z: float
    y: float
    axial: float = 0.0
    radial: float = 0.0
    by_cotangent: bool = False
    only_axial: bool = False
    ribs: bool = False


@cache
def constants_by_type() -> Mapping[str, Constants]:
    """Return the constants by the key of the type of bearing."""
    tables = toml_of("palmgren").items()
    return {key: Constants(**table) for key, table in tables if isinstance(table, Mapping)}


RIB_FACTORS: Final[Mapping[str, float]] = {
    "grease": 0.003, "oil_mist": 0.002, "oil_bath": 0.002, "oil_jet": 0.002,
}  # fmt: skip
"""f2 of cylindrical roller bearings with cage and ribs of today's design, up to F_a = 0.4 F_r;
older ones have three times as much."""

_KNEE = 2000.0
_SLOW = 160e-7
_RPM = 30.0 / pi


def lubricant_torque(
    kinematic_viscosity: ArrayLike, speed: ArrayLike, mean_diameter: ArrayLike, f0: ArrayLike
) -> FloatArray:
    """Torque M0, which does not depend on load; N·m.

    Parameters
    ----------
    kinematic_viscosity : ν of the oil, or of the grease's base oil, at its temperature; m²/s.
    speed : of the rings to each other; rad/s.
    mean_diameter : d_m; m.
    f0 : of type and lubrication, `constants_by_type`.

    Returns
    -------
    M0 of the broadcast shape.

    >>> print(f"{1e3 * lubricant_torque(20e-6, 150.0, 0.08, 2.0):.1f} N mm")
    95.9 N mm
    """
    product = 1e6 * np.asarray(kinematic_viscosity) * _RPM * np.abs(speed)
    factor = np.where(product >= _KNEE, 1e-7 * product ** (2.0 / 3.0), _SLOW)
    return np.asarray(1e-3 * np.asarray(f0) * factor * (1e3 * np.asarray(mean_diameter)) ** 3)


def load_torque(
    load: ArrayLike, mean_diameter: ArrayLike, static_load_ratio: ArrayLike, kind: str
) -> FloatArray:
    """Torque M1, which the load makes; N·m.

    Parameters
    ----------
    load : P1, `friction_load`; N.
    mean_diameter : d_m; m.
    static_load_ratio : P0/C0, equivalent static load over static load rating.
    kind : of bearing.

    Returns
    -------
    M1 of the broadcast shape.
    """
    own = _constants(kind)
    f1 = own.z * np.asarray(static_load_ratio, dtype=np.float64) ** own.y
    return np.asarray(f1 * np.asarray(load) * np.asarray(mean_diameter))


def rib_torque(
    axial: ArrayLike, mean_diameter: ArrayLike, lubrication: Lubrication = "oil_bath"
) -> FloatArray:
    """Torque M2, which the axial load makes at the ribs of a cylindrical roller bearing; N·m.

    Parameters: F_a (N), d_m (m), lubrication. Valid to F_a = 0.4 F_r.
    """
    load = np.abs(np.asarray(axial, dtype=np.float64))
    return np.asarray(RIB_FACTORS[lubrication] * load * np.asarray(mean_diameter))


def friction_load(
    radial: ArrayLike, axial: ArrayLike, kind: str, contact_angle: ArrayLike = 0.0
) -> FloatArray:
    """Load P1 that goes into M1; N.

    Parameters: F_r and F_a (N), the type of bearing, its nominal contact angle (rad) where the
    axial load counts by that.
    """
    fr, fa, own = np.abs(radial), np.abs(axial), _constants(kind)
    if own.only_axial:
        return np.broadcast_arrays(fa, fr)[0].copy()
    slope = np.tan(contact_angle) if own.by_cotangent else 1.0
    return np.maximum(own.axial * fa / slope - own.radial * fr, fr)


def palmgren(
    *,
    kind: str,
    lubrication: Lubrication,
    speed: ArrayLike,
    mean_diameter: ArrayLike,
    kinematic_viscosity: ArrayLike,
    radial_load: ArrayLike,
    axial_load: ArrayLike,
    static_load_ratio: ArrayLike,
    contact_angle: ArrayLike = 0.0,
    f0: float | None = None,
) -> Torque:
    """Palmgren's torque of a lubricated bearing.

    Parameters
    ----------
    kind, lubrication : choose the constants.
    speed : of the rings to each other; rad/s.
    mean_diameter : d_m, the mean of bore and outside diameter; m.
    kinematic_viscosity : of the oil at its temperature; m²/s.
    radial_load, axial_load : N.
    static_load_ratio : P0/C0; dimensionless.
    contact_angle : nominal, of angular-contact bearings; rad.
    f0 : in place of the table's.

    Returns
    -------
    Torque; parts "lubricant" and "load", and "rib" of cylindrical roller bearings.

    Raises
    ------
    InputError
        For an unknown word, or a number out of range.
    """
    own = _constants(kind)
    one_of(lubrication, "lubrication", own.f0)
    if own.by_cotangent:
        positive(contact_angle, "contact_angle", finite=True)
    turning = np.atleast_1d(numbers(speed, "speed"))
    diameter = positive(mean_diameter, "mean_diameter", finite=True)
    viscosity = positive(kinematic_viscosity, "kinematic_viscosity", finite=True)
    ratio = positive(static_load_ratio, "static_load_ratio", zero=True, finite=True)
    radial, axial = (
        numbers(radial_load, "radial_load"),
        numbers(axial_load, "axial_load"),
    )
    load = friction_load(radial, axial, kind, contact_angle)
    factor = own.f0[lubrication] if f0 is None else f0
    parts = {
        "lubricant": lubricant_torque(viscosity, turning, diameter, factor),
        "load": load_torque(load, diameter, ratio, kind),
    }
    if own.ribs:
        parts["rib"] = rib_torque(axial, diameter, lubrication)
    whole = np.broadcast_arrays(*parts.values())
    return torque_of_parts(MODEL.name, dict(zip(parts, whole, strict=True)), turning)


def _constants(kind: str) -> Constants:
    known = constants_by_type()
    one_of(kind, "kind", known)
    return known[kind]


def _of_bearing(setting: Setting) -> Torque:
    return added([_of_machine(setting, machine) for machine in setting.machines])


def _of_machine(setting: Setting, machine: MachineBearing) -> Torque:
    """That of one of the bearings under its own load."""
    assert machine.static_load_ratio is not None
    radial, axial = bearing_load(setting.solved, machine)
    return palmgren(
        kind=machine.kind,
        lubrication=machine.lubrication,
        speed=setting.solved.relative_speed,
        mean_diameter=machine.mean_diameter,
        kinematic_viscosity=machine.kinematic_viscosity,
        radial_load=radial,
        axial_load=axial,
        static_load_ratio=machine.static_load_ratio,
        contact_angle=machine.contact_angle,
    )


def _limits(setting: Setting) -> dict[str, BoolArray]:
    """The third term is valid up to a share of the radial load."""
    limits = limits_of_lubricated_bearings(setting)
    whole = np.zeros(setting.regime.shape, np.bool_)
    of_steel = np.full(whole.shape, any(one.rated_as_steel for one in setting.machines))
    pushed = [
        np.abs(fa) > RIB_LOAD_SHARE * fr
        for fr, fa in (
            bearing_load(setting.solved, one)
            for one in setting.machines
            if _constants(one.kind).ribs
        )
    ]
    return {
        **limits,
        **({"axial_share": np.any(pushed, axis=0)} if pushed else {}),
        "rating_of_steel": of_steel,
    }


MODEL: Final = TorqueModel(
    name="palmgren",
    title=marked("Palmgren"),
    short_title=marked("Palmgren"),
    needs=("static_load_ratio",),
    evaluate=_of_bearing,
    limits=_limits,
    of_contacts=False,
    closed_form=True,
)
