"""What rollers lose: sliding on ribs and along raceways of another apex, hysteresis, oil.

A roller rolls without differential slip where the cones of roller and raceways have one apex. Then
all that slides is its end on the rib, at the height h over the raceway, where Coulomb's friction
takes μ F_rib v. With the axial load F_a on a tapered bearing this is the torque e μ F_a that NSK
and Aihara (1987) give. The coefficient falls with the film between rib and roller end where the
radius of the end is known; else it is that of the lubricant, which bounds it from above.

There is no model of skew, nor of the shear of the film on raceways under traction.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields
from typing import Any, Final

import numpy as np

from rolamento.case.parameters import RollerParameters, parameters_of
from rolamento.case.roller_bearing import USUAL_RIB_HEIGHT, raceway_radii
from rolamento.friction.line_losses import (
    RIB_FILM,
    curved_slip_moment,
    inlet_force,
    line_hysteresis,
    rib_coefficient,
    slip_moment,
)
from rolamento.friction.model import (
    ContactLoss,
    Setting,
    Torque,
    TorqueModel,
    torque_of_losses,
)
from rolamento.geometry import Race
from rolamento.kinematics import BallMotion, RibMotion, rib_motion, roller_motion
from rolamento.lubrication.film_thickness import film_groups, minimum_film
from rolamento.lubrication.films import has_film, resistance_left
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.solved import RACES, Solved
from rolamento.solved.rollers import Line
from rolamento.types import TYPES, type_of_element
from rolamento.words import marked

SLIPS: Final = 1e-3
"""Fraction of the speed of entrainment: a line that slips more at its ends slips by its shape."""


@frozen(eq=False)
class RollerShape:
    """The rollers of solved cases; (cases, elements) each, NaN for balls; m, rad.

    axis and taper are the angles β and φ; end_radius is NaN where it is not given.
    """

    diameter: FloatArray
    pitch: FloatArray
    length: FloatArray
    axis: FloatArray
    taper: FloatArray
    inner_curve: FloatArray
    outer_curve: FloatArray
    rib_height: FloatArray
    end_radius: FloatArray

    @classmethod
    def of(cls, solved: Solved) -> RollerShape:
        """Read that of a result, fields that vary over the cases included."""
        columns = [_shape_of_row(solved, index) for index in range(len(solved.rows))]
        rows = (np.stack([column[part.name] for column in columns], axis=1) for part in fields(cls))
        return cls(*map(solved.rows.per_element, rows))

    @property
    def motion(self) -> BallMotion:
        """For a unit speed of the inner ring relative to the outer."""
        return roller_motion(self.diameter, self.pitch, self.axis, self.taper, 1.0)

    def rib(self, race: Race) -> RibMotion:
        """The motion at a rib, likewise."""
        end = np.where(np.isnan(self.end_radius), np.inf, self.end_radius)
        return rib_motion(
            race, self.diameter, self.pitch, self.length, self.axis, self.taper,
            self.rib_height, 1.0, 0.0, end,
        )  # fmt: skip

    @property
    def rib_curvature(self) -> tuple[FloatArray, FloatArray]:
        """1/R of roller end and inner rib along sliding, and across it; 1/m, NaN if unknown.

        The rib's normal meets the shaft's axis behind the centre of the sphere: along sliding the
        rib is hollow, R_s r_P/r_C with the distances of contact and centre from the axis; across it
        it is straight.
        """
        place = 0.5 * self.length / np.cos(self.taper) - self.rib_height * np.tan(self.taper)
        inner = self.axis - self.taper
        off_axis = 0.5 * self.diameter + 0.5 * self.length * np.tan(self.taper)
        off_axis = off_axis - self.rib_height / np.cos(self.taper)
        contact = 0.5 * (self.pitch - self.diameter * np.cos(self.axis))
        contact = contact + place * np.sin(inner) + self.rib_height * np.cos(inner)
        with np.errstate(invalid="ignore", divide="ignore"):
            back = np.sqrt(self.end_radius**2 - off_axis**2)
            centre = 0.5 * self.pitch + (0.5 * self.length - back) * np.sin(self.axis)
            across = 1.0 / self.end_radius
            along = np.where(centre > 0.0, across * centre / contact, np.nan)
        return along, across


def _shape_of_row(solved: Solved, index: int) -> dict[str, FloatArray]:
    rows, place, whole = solved.rows, solved.case.bearing.places[index], solved.case.bearing
    if not place.bearing.bearing_type.has_rollers:
        return {part.name: np.full(len(solved), np.nan) for part in fields(RollerShape)}
    arrays = {name: solved.field(name) for name in solved.varied if name.startswith("bearing.")}
    row = parameters_of(whole, place.bearing, whole.own_fields(index), arrays)

    def column(value: Any, otherwise: Any = np.nan) -> FloatArray:
        return np.broadcast_to(otherwise if value is None else value, len(solved))

    diameter = rows.ball_diameter[:, index]
    grown = diameter / row.roller_diameter  # the case of a mounted set has its cold rollers
    taper = column(row.roller_half_angle, 0.0)
    inner_curve, outer_curve = _curves(row)
    return {
        "diameter": diameter,
        "pitch": rows.pitch_diameter[:, index],
        "length": column(row.roller_length),
        "axis": column(row.contact_angle, 0.0) - taper,
        "taper": taper,
        "inner_curve": column(inner_curve),
        "outer_curve": column(outer_curve),
        "rib_height": column(row.rib_height, USUAL_RIB_HEIGHT * diameter),
        "end_radius": grown * column(row.roller_end_radius),
    }


def _curves(row: RollerParameters) -> tuple[Any, Any]:
    """1/R of the pressed surface along the roller, on each race; of barrels, else 0.

    R = 2 r_r r/(r_r + r), halfway between the profiles; Harris (1991), eq. 2.18.
    """
    if not row.bearing_type.barrels:
        return 0.0, 0.0
    profile, inner, outer = raceway_radii(row)
    return 0.5 * (1.0 / profile + 1.0 / inner), 0.5 * (1.0 / profile + 1.0 / outer)


# --- sliding -----------------------------------------------------------------------------------


def rib_film_parameter(setting: Setting, shape: RollerShape) -> FloatArray:
    """Λ between the inner rib and tapered rollers, (cases, elements); NaN where it is not known.

    1.25 times the minimum film by Hamrock and Dowson over the combined roughness of the inner race
    and the rollers, for that of the rib is not given. Aihara (1987), equations 16 and 17.
    """
    solved = setting.solved
    unknown = np.full(shape.diameter.shape, np.nan)
    surface = solved.case.surface
    assert solved.rollers is not None
    if surface is None or not has_film(solved):
        return unknown
    oil = solved.oil.columns()
    along, across = shape.rib_curvature
    speed = solved.relative_speed[:, np.newaxis]
    force = np.abs(solved.rollers.rib_force)
    known = solved.rollers_bear & (force > 0.0) & (along > 0.0)
    ellipticity = np.where(known, 1.03 * (along / across) ** 0.64, np.nan)
    groups = film_groups(
        np.where(known, shape.rib("inner").entrainment * speed, np.nan),
        np.where(known, force, np.nan),
        np.where(known, along, np.nan),
        ellipticity,
        solved.inner.modulus,
        oil.dynamic_viscosity,
        oil.pressure_viscosity,
    )
    height = RIB_FILM * minimum_film(groups) / np.where(known, along, np.nan)
    return np.asarray(np.where(known, height / surface.inner_combined, np.nan))


def roller_sliding(
    setting: Setting, *, coefficient: FloatArray | None = None
) -> dict[str, ContactLoss]:
    """Losses of sliding at a unit speed of the rings: "rib" and "rolling_slip"; W s/rad.

    coefficient : μ at the ribs, (cases or 1, 1), in the place of what the film leaves of μ_0.
    """
    solved = setting.solved
    rollers = solved.rollers
    assert rollers is not None
    shape, loaded = RollerShape.of(solved), solved.rollers_bear
    mu = setting.coefficient.rollers
    at_rib = coefficient
    if at_rib is None:
        parameter = rib_film_parameter(setting, shape)
        under = rib_coefficient(np.nan_to_num(parameter), setting.coefficient.boundary)
        at_rib = np.where(np.isnan(parameter), mu, under)
    force = np.where(loaded & _ribbed(solved), np.abs(rollers.rib_force), 0.0) * at_rib
    straight = np.array([type_of_element(one).straight for one in solved.rows.element])
    both = straight[solved.rows.row_of_element]
    rib = ContactLoss(
        np.where(force > 0.0, force * shape.rib("inner").sliding, 0.0),
        np.where((force > 0.0) & both, force * shape.rib("outer").sliding, 0.0),
    )
    motion = shape.motion

    def along(line: Line, spin: FloatArray, roll: FloatArray, curve: FloatArray) -> FloatArray:
        q, x = line.load_per_length, rollers.slice_place
        power = slip_moment(q, x) * np.abs(spin)
        if (curve > 0.0).any():
            power = power + curved_slip_moment(q, x, curve) * np.abs(roll)
        return np.where(loaded, mu * power, 0.0)

    slip = ContactLoss(
        along(rollers.inner, motion.inner_spin, motion.inner_roll, shape.inner_curve),
        along(rollers.outer, motion.outer_spin, motion.outer_roll, shape.outer_curve),
    )
    return {"rib": rib, "rolling_slip": slip}


def _ribbed(solved: Solved) -> BoolArray:
    """Which rollers lean on ribs; barrels are guided by a loose ring; (elements,)."""
    ribs = np.array([not type_of_element(one).barrels for one in solved.rows.element])
    return np.asarray(ribs[solved.rows.row_of_element])


def starting_losses(setting: Setting) -> dict[str, ContactLoss]:
    """What slides at the first motion."""
    return roller_sliding(setting, coefficient=setting.rib_coefficient)


# --- oil and hysteresis, which every model is given -----------------------------------------------


def line_hysteresis_loss(solved: Solved, loss: FloatArray) -> ContactLoss:
    """Loss of every line of contact by elastic hysteresis at a unit speed; α_h (cases or 1, 1)."""
    motion = RollerShape.of(solved).motion

    def moment(line: Line) -> FloatArray:
        return line_hysteresis(line.load_per_length, line.half_width, loss[..., np.newaxis])

    return ContactLoss(
        _along(solved, "inner", moment, motion.inner_roll),
        _along(solved, "outer", moment, motion.outer_roll),
    )


def line_resistance_loss(solved: Solved, viscosity: FloatArray) -> ContactLoss:
    """Power of the oil at the inlets of every line of contact as it was solved: 2 t u; W.

    viscosity : η₀ at the inlets, (cases, 1). The pressure-viscosity coefficient, the heat of shear
    and the starvation are those of the case; without an oil there is nothing.
    """
    if not has_film(solved):
        nothing = np.zeros(solved.inner.load.shape)
        return ContactLoss(nothing, nothing)
    oil = solved.oil.columns()

    def of_race(race: Race) -> FloatArray:
        contacts = solved.contacts[race]
        speed = np.abs(contacts.entrainment)
        bears = solved.rollers_bear
        u = np.where(bears, speed, 0.0)

        def force(line: Line) -> FloatArray:
            return inlet_force(
                line.load_per_length,
                contacts.rolling_curvature[..., np.newaxis],
                contacts.modulus[..., np.newaxis],
                viscosity[..., np.newaxis],
                oil.pressure_viscosity[..., np.newaxis],
                u[..., np.newaxis],
            )

        return _along(solved, race, force, 2.0 * u * resistance_left(solved, race, viscosity))

    return ContactLoss(*map(of_race, RACES))


def _along(
    solved: Solved, race: Race, per_length: Callable[[Line], FloatArray], rate: FloatArray
) -> FloatArray:
    """What a loss per length adds up to along the lines of a race, times a rate."""
    assert solved.rollers is not None
    line = getattr(solved.rollers, race)
    width = solved.rows.per_element(solved.rows.effective_length) / solved.rollers.slices
    bears = solved.rollers_bear
    whole = np.nansum(np.where(bears[..., np.newaxis], per_length(line), 0.0), axis=-1)
    return np.asarray(np.where(bears, whole * width * np.abs(rate), 0.0))


# --- the model ---------------------------------------------------------------------------------


def _of_contacts(setting: Setting) -> Torque:
    solved = setting.solved
    return torque_of_losses(MODEL.name, solved, roller_sliding(setting))


def _limits(setting: Setting) -> dict[str, BoolArray]:
    solved = setting.solved
    rollers = solved.rollers
    assert rollers is not None
    shape, bears = RollerShape.of(solved), solved.rollers_bear
    motion = shape.motion
    with np.errstate(invalid="ignore"):
        end = 0.5 * solved.rows.per_element(solved.rows.effective_length)
        fast = SLIPS * 0.5 * np.abs(motion.ball_speed) * shape.diameter
        slips = bears & (np.maximum(abs(motion.inner_spin), abs(motion.outer_spin)) * end > fast)
        presses = bears & _ribbed(solved) & (np.abs(rollers.rib_force) > 0.0)
    unknown = presses & np.isnan(rib_film_parameter(setting, shape))
    return {
        "full_film": (setting.regime == "full_film")
        & np.any(slips, axis=-1)
        & (not setting.by_regime),
        "rib_film_unknown": np.any(unknown, axis=-1),
    }


MODEL: Final = TorqueModel(
    name="roller_sliding",
    title=marked("Contacts of the rollers"),
    short_title=marked("Rollers"),
    needs=("friction_coefficient",),
    evaluate=_of_contacts,
    limits=_limits,
    closed_form=True,
    elements=tuple(dict.fromkeys(one.element for one in TYPES.values() if one.has_rollers)),
)
