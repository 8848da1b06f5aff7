"""What a person can do about a case without a result."""

from __future__ import annotations

from math import acos, isfinite, radians, tan
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.case import Case
from rolamento.case.bearing import ball_bearing
from rolamento.case.duty import AXES
from rolamento.geometry import Race, edge_cosine
from rolamento.kinematics import ball_mass, centrifugal_force, nominal_orbit
from rolamento.solved.notes.bearing import (
    MILLION,
    RADIAL_SHARE,
    free_degrees,
    given_forces,
    is_washers,
    speed_factor,
)
from rolamento.status import (
    CONVERGED,
    GREATEST_APPROACH,
    INVALID_INPUT,
    NO_EQUILIBRIUM,
    OVER_SHOULDER,
    OVERLOADED,
    TOLERANCE,
    UNCONSTRAINED_BALL,
)
from rolamento.words import Note
from rolamento.words.naming import of_element

if TYPE_CHECKING:
    from rolamento.solved.result import Solved

_FASTEST: Final = 4.0 * MILLION
"""n d_m beyond which no ball bearing is known to have run. Bamberger, Zaretsky and Signer
(1976) ran main-shaft bearings of jet engines at 3e6 mm·rpm, by the bore."""


def advice_on(solved: Solved, case: int = 0) -> Note | None:
    """What a person can do about a case without a result; None where there is one."""
    code = int(solved.status.number[case])
    if code == CONVERGED:
        return None
    given, residual = solved.case, float(solved.status.residual[case])
    if code == NO_EQUILIBRIUM:
        return _no_equilibrium(solved[case], int(solved.status.unsupported[case]))
    if code == INVALID_INPUT:
        return Note("invalid_input") if solved.refusals is None else solved.refusals.note(case)
    factor = speed_factor(solved[case])
    if factor > _FASTEST:
        return Note("overspeed", {"speed_factor": factor, "limit": _FASTEST})
    rolls = any(place.bearing.element != "ball" for place in given.bearing.places)
    if code == OVERLOADED:
        key = "overloaded_rollers" if rolls else "overloaded"
        return Note(key, {"limit": GREATEST_APPROACH})
    if code == OVER_SHOULDER and given.bearing.bearing_type.washers:
        return _out_of_the_washers(solved[case])
    if code == OVER_SHOULDER:
        return Note(
            "over_shoulder",
            {"inner_edge": _edge(given, "inner"), "outer_edge": _edge(given, "outer")},
        )
    if rolls:
        return Note("not_converged", {**_residual(residual), "tolerance": TOLERANCE})
    alone = given.model.raceway_control == "inner" and given.model.cage == "none"
    if code == UNCONSTRAINED_BALL or alone:
        return Note("unconstrained_ball")
    if given.model.raceway_control == "friction":
        return _friction_alone(residual)
    inner, outer = (float(solved.field(f"duty.{race}_speed")[case]) for race in ("inner", "outer"))
    if inner * outer < 0.0:
        return Note("counter_rotation")
    if given.model.raceway_control == "inner":
        return Note("inner_control", _residual(residual))
    return Note("not_converged", {**_residual(residual), "tolerance": TOLERANCE})


def _residual(residual: float) -> dict[str, float | None]:
    return {"residual": residual if isfinite(residual) else None}


def _edge(case: Case, race: Race) -> float:
    """The contact angle (rad) at which the shallowest groove of a race ends."""
    return min(acos(float(edge_cosine(place.bearing, race))) for place in case.bearing.places)


def _out_of_the_washers(solved: Solved) -> Note:
    """Advice where balls climb out of a thrust bearing's grooves, and the load that keeps them.

    Where there is a radial load, that it is the wrong bearing for it.

    With α_i = π - α_o, F_c = 2 Q cos α_o and F_a = Z Q sin α_o: at the edge of the outer groove
    F_a = ½ Z F_c tan α_o.
    """
    radial, axial = given_forces(solved)
    if is_washers(solved.case) and radial > RADIAL_SHARE * abs(axial):
        return Note("thrust_carries_no_radial_load", {"radial": radial, "axial": axial})
    rows = solved.rows
    bearing = ball_bearing(solved.case)
    deepest = bearing.groove_bottom
    lowest = max(deepest - _edge(solved.case, "outer"), radians(0.1))
    orbit = nominal_orbit(
        float(rows.ball_diameter[0, 0] / rows.pitch_diameter[0, 0]) * np.cos(deepest),
        *(float(solved.field(f"duty.{race}_speed")[0]) for race in ("inner", "outer")),
    )
    mass = ball_mass(rows.ball_diameter[0, 0], bearing.ball_material.density)
    force = float(centrifugal_force(mass, rows.pitch_diameter[0, 0], orbit))
    if not solved.case.model.centrifugal_force:
        force = 0.0
    least = 0.5 * bearing.ball_count * force * float(np.tan(lowest))
    return Note(
        "thrust_over_shoulder",
        {
            "inner_edge": _edge(solved.case, "inner"),
            "outer_edge": _edge(solved.case, "outer"),
            "centrifugal_force": force,
            "minimum_load": least if force > 0.0 else None,
        },
    )


def _no_equilibrium(solved: Solved, axis: int) -> Note:
    """Name the direction that nothing supports, and what would."""
    case, bearing = solved.case, solved.case.bearing
    radial, axial_load = given_forces(solved)
    if bearing.bearing_type.washers:
        note = Note("thrust_pushed_aside" if axial_load > 0.0 else "thrust_unsupported")
        if is_washers(case) and axial_load > 0.0 and radial > RADIAL_SHARE * axial_load:
            values = {"radial": radial, "axial": axial_load}
            note = Note("thrust_carries_no_radial_load", values)
        return of_element(note, bearing.bearing_type.rolls)
    if bearing.bearing_type.aligns and axis > 2:
        return Note("sphere_holds_no_moment", {"axis": AXES[axis]})
    if any(place.bearing.element != "ball" for place in bearing.places):
        tilts = bool(free_degrees(solved)[3:].any())
        return _rollers_without_equilibrium(case, axis, (axial_load, radial), tilts=tilts)
    if bearing.kind is not None:
        return Note("unsupported", {"axis": AXES[axis]})
    one_sided = [place.bearing.carries_one_way for place in bearing.places]
    if bearing.is_set and all(one_sided) and axis == 0:
        return _set_without_equilibrium(case, axial_load)
    if len(set(one_sided)) > 1:
        return Note("shoulder_lost")
    if not all(one_sided):
        return Note("unsupported", {"axis": AXES[axis]})
    if axis == 0:
        return Note("unsupported_axially")
    return Note("unsupported_one_sided", {"axis": AXES[axis]})


def _set_without_equilibrium(case: Case, axial: float) -> Note:
    """Why rows that carry axial load one way only have no equilibrium."""
    signs = {place.sign for place in case.bearing.places}
    if len(signs) == 1:
        toward, away = ("+x", "-x") if signs == {1.0} else ("-x", "+x")
        return Note("unsupported_tandem", {"toward": toward, "away": away})
    spring = None if case.bearing.preload is None else case.bearing.preload.spring
    if spring is None:
        return Note("shoulder_lost")
    if axial <= -spring:
        return Note("springs_overcome", {"load": -axial, "spring": spring})
    return Note("springs_weak", {"spring": spring})


def _friction_alone(residual: float) -> Note:
    """Advice where balls that friction controls found no balance, or one that cannot be shown."""
    if residual <= TOLERANCE:
        return Note("friction_without_balance")
    return Note("friction_not_converged", _residual(residual))


def _rollers_without_equilibrium(
    case: Case, axis: int, load: tuple[float, float], *, tilts: bool
) -> Note:
    """Name the direction in which nothing supports a ring with rollers, and what would.

    Every tapered roller presses at α_o, and all together with F_a ≥ F_r tan α_o; with more axial
    load than that, rings that are kept aligned find their place. Then it is the free tilt that
    does not.

    Parameters
    ----------
    case
        Of the rows.
    axis
        The direction, as in `AXES`.
    load
        Axial and radial, as given (N).
    tilts
        Whether the ring is free to tilt.
    """
    kinds = case.bearing.row_types
    if axis == 0 and all(one.floats for one in kinds):
        return Note("ribs_do_not_hold")
    if axis == 0 and all(one.conical for one in kinds):
        signs = {place.sign for place in case.bearing.places}
        if len(signs) == 1:
            toward, away = ("+x", "-x") if signs == {1.0} else ("-x", "+x")
            axial, radial = load
            needed = radial * max(tan(place.bearing.row_angle) for place in case.bearing.places)
            if tilts and axial * signs.pop() > needed:
                return Note("tapered_free_to_tilt", {"axial": abs(axial), "needed": needed})
            return Note("tapered_unsupported_axially", {"toward": toward, "away": away})
    return Note("rollers_unsupported", {"axis": AXES[axis]})
