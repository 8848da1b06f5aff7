"""Palmgren's friction torque of lubricated machine bearings: M = M0 + M1, and M2 of rollers' ribs.

With lengths in mm, ν in mm²/s and n in rpm, moments come in N·mm:

    M0 = 1e-7 f0 (ν n)^(2/3) d_m³      for ν n ≥ 2000, else 160e-7 f0 d_m³
    M1 = f1 P1 d_m,    f1 = z (P0/C0)^y of balls, a constant of rollers
    M2 = f2 F_a d_m    of cylindrical roller bearings whose ribs carry an axial load

P1 = max(3 F_a - 0.1 F_r, F_r) for deep-groove bearings, max(0.9 F_a cot α - 0.1 F_r, F_r) for
angular-contact ones, double-row, four-point and self-aligning ones among them, F_a for thrust
bearings; of tapered roller bearings max(0.8 F_a cot α, F_r), of cylindrical and needle ones F_r.
The constants hold for moderate speed and load and the lubrication named.

Palmgren (1959); constants and P1 as Harris (1991), chapter 14, gives them; those of double-row,
four-point, self-aligning and thrust bearings, and all of roller bearings, are from general
knowledge of its tables 14.1 to 14.3 and of SKF's General catalogue of 1989, no print was at hand.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import pi
from typing import TYPE_CHECKING, Final, Literal

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.friction.model import (
    RIB_LOAD_SHARE,
    Setting,
    Torque,
    TorqueModel,
    added,
    bearing_load,
    checked_numbers,
    checked_positive,
    limits_of_lubricated_bearings,
    relative_speed,
    torque_of_parts,
)
from rolamento.numerics import BoolArray, FloatArray
from rolamento.words import marked, said

if TYPE_CHECKING:
    from rolamento.friction.machine import MachineBearing

BearingKind = Literal[
    "deep_groove", "angular_contact", "double_row", "four_point", "self_aligning", "thrust",
    "cylindrical", "tapered", "needle",
]  # fmt: skip
Lubrication = Literal["grease", "oil_mist", "oil_bath", "oil_jet"]

LUBRICATION_FACTORS: Final[Mapping[str, Mapping[str, float]]] = {
    "deep_groove": {"grease": 1.0, "oil_mist": 1.0, "oil_bath": 2.0, "oil_jet": 4.0},
    "angular_contact": {"grease": 2.0, "oil_mist": 1.7, "oil_bath": 3.3, "oil_jet": 6.6},
    "double_row": {"grease": 4.0, "oil_mist": 3.4, "oil_bath": 6.5, "oil_jet": 13.0},
    "four_point": {"grease": 6.0, "oil_mist": 2.0, "oil_bath": 6.0, "oil_jet": 9.0},
    "self_aligning": {"grease": 1.75, "oil_mist": 0.85, "oil_bath": 1.75, "oil_jet": 3.5},
    "thrust": {"grease": 5.5, "oil_mist": 0.8, "oil_bath": 1.5, "oil_jet": 3.0},
    "cylindrical": {"grease": 0.8, "oil_mist": 2.15, "oil_bath": 3.1, "oil_jet": 3.1},
    "tapered": {"grease": 6.0, "oil_mist": 3.0, "oil_bath": 6.0, "oil_jet": 9.0},
    "needle": {"grease": 12.0, "oil_mist": 6.0, "oil_bath": 12.0, "oil_jet": 24.0},
}
"""f0. Deep-groove bearings with grease: 0.7 (light series) to 2 (heavy series). "oil_jet" is
also for an oil bath with a vertical shaft. Self-aligning and cylindrical roller bearings (with
cage): the middle between light and heavy series, 1.5 to 2 and 0.6 to 1 with grease, and of
cylindrical roller bearings 2.2 to 4 with an oil bath."""

LOAD_FACTORS: Final[Mapping[str, tuple[float, float]]] = {
    "deep_groove": (0.0005, 0.55),
    "angular_contact": (0.001, 0.33),
    "double_row": (0.001, 0.33),
    "four_point": (0.001, 0.33),
    "self_aligning": (0.0003, 0.40),
    "thrust": (0.0008, 0.33),
    "cylindrical": (0.0003, 0.0),
    "tapered": (0.0004, 0.0),
    "needle": (0.002, 0.0),
}
"""z and y of f1. Deep-groove bearings: z from 0.0004 (light series) to 0.0006 (heavy series);
cylindrical roller bearings with cage: 0.0002 to 0.0004."""

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
    f0 : of type and lubrication, `LUBRICATION_FACTORS`.

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
    load: ArrayLike, mean_diameter: ArrayLike, static_load_ratio: ArrayLike, kind: BearingKind
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
    z, y = LOAD_FACTORS[_checked_kind(kind)]
    f1 = z * np.asarray(static_load_ratio, dtype=np.float64) ** y
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
    radial: ArrayLike, axial: ArrayLike, kind: BearingKind, contact_angle: ArrayLike = 0.0
) -> FloatArray:
    """Load P1 that goes into M1; N. contact_angle: nominal, of all but deep-groove ones; rad.

    Cylindrical and needle roller bearings have none.
    """
    fr, fa = np.abs(radial), np.abs(axial)
    if _checked_kind(kind) == "thrust":
        return np.broadcast_arrays(fa, fr)[0].copy()
    if kind == "deep_groove":
        combined = 3.0 * fa - 0.1 * fr
    elif kind in ("cylindrical", "needle"):
        combined = 0.0 * fa
    elif kind == "tapered":
        combined = 0.8 * fa / np.tan(contact_angle)
    else:
        combined = 0.9 * fa / np.tan(contact_angle) - 0.1 * fr
    return np.maximum(combined, fr)


def palmgren(
    *,
    kind: BearingKind,
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
    if lubrication not in LUBRICATION_FACTORS[_checked_kind(kind)]:
        known = ", ".join(LUBRICATION_FACTORS[kind])
        raise InputError(
            said("must be one of {known}", known=known), field="lubrication", value=lubrication
        )
    if kind not in ("deep_groove", "thrust", "cylindrical", "needle"):
        checked_positive(contact_angle, "contact_angle")
    turning = np.atleast_1d(checked_numbers(speed, "speed"))
    diameter = checked_positive(mean_diameter, "mean_diameter")
    viscosity = checked_positive(kinematic_viscosity, "kinematic_viscosity")
    ratio = checked_positive(static_load_ratio, "static_load_ratio", zero=True)
    radial, axial = (
        checked_numbers(radial_load, "radial_load"),
        checked_numbers(axial_load, "axial_load"),
    )
    load = friction_load(radial, axial, kind, contact_angle)
    factor = LUBRICATION_FACTORS[kind][lubrication] if f0 is None else f0
    parts = {
        "lubricant": lubricant_torque(viscosity, turning, diameter, factor),
        "load": load_torque(load, diameter, ratio, kind),
    }
    if kind == "cylindrical":
        parts["rib"] = rib_torque(axial, diameter, lubrication)
    whole = np.broadcast_arrays(*parts.values())
    return torque_of_parts(MODEL.name, dict(zip(parts, whole, strict=True)), turning)


def _checked_kind(kind: str) -> str:
    if kind not in LOAD_FACTORS:
        raise InputError(
            said("must be one of {known}", known=", ".join(LOAD_FACTORS)),
            field="kind",
            value=kind,
        )
    return kind


def _of_bearing(setting: Setting) -> Torque:
    return added([_of_machine(setting, machine) for machine in setting.machines])


def _of_machine(setting: Setting, machine: MachineBearing) -> Torque:
    """That of one of the bearings under its own load."""
    assert machine.static_load_ratio is not None
    radial, axial = bearing_load(setting.solved, machine)
    return palmgren(
        kind=machine.kind,
        lubrication=machine.lubrication,
        speed=relative_speed(setting.solved),
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
            if one.kind == "cylindrical"
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
