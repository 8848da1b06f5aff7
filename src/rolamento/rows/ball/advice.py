"""What a person can do about a case that has no result."""

from __future__ import annotations

from math import acos, degrees, pi
from typing import Final

from rolamento import status
from rolamento.case import Case
from rolamento.geometry import Race, edge_cosine, ring_geometry
from rolamento.rows.ball.batch_state import BatchState

_DIRECTIONS: Final = (
    "along x",
    "along y",
    "along z",
    "against tilting about y (ry)",
    "against tilting about z (rz)",
)

_FASTEST: Final = 4e6
"""n d_m beyond which no ball bearing is known to have run; mm r/min. Bamberger, Zaretsky and Signer
(1976) ran main-shaft bearings of jet engines at 3e6 mm r/min, by the bore."""

_LOST_SHOULDER: Final = (
    "The inner ring moves so far that balls of a row would have to carry on the shoulder that an "
    "angular-contact bearing lacks. More preload or less play (bearing.preload), a smaller axial "
    "load or moment, or rings that are held from tilting keep them on their side."
)


def advise(case: Case, batch: BatchState) -> str | None:
    """Advice on the status of the first case of a batch; None where it has a result."""
    code = int(batch.code[0])
    if code == status.CONVERGED:
        return None
    if code == status.NO_EQUILIBRIUM:
        return _no_equilibrium(case, int(batch.unsupported[0]))
    factor = _speed_factor(case)
    if factor > _FASTEST and code != status.INVALID_INPUT:
        return (
            f"An overspeed: the rings turn at n d_m = {1e-6 * factor:.3g} million mm r/min, and no "
            f"ball bearing is known to have run beyond some {1e-6 * _FASTEST:.0f} million: "
            "centrifugal force presses the balls out of all elastic contact. Check the unit of the "
            "speed, or lower it."
        )
    if code == status.OVERLOADED:
        return (
            "A ball would sink into its groove by more than 2 % of its diameter, far beyond any "
            "elastic contact: check the units of the loads and displacements."
        )
    if code == status.INVALID_INPUT:
        return "A number of this case is not finite."
    if code == status.OVER_SHOULDER:
        return _over_shoulder(case)
    alone = case.model.raceway_control == "inner" and case.model.cage == "none"
    if code == status.UNHELD_BALL or alone:
        return (
            "This raceway control cannot hold a ball that a race loads too lightly to "
            'bear its gyroscopic moment. Take model.cage = "loose", model.raceway_control = '
            '"jones" or "outer", or more axial load.'
        )
    if case.model.raceway_control == "friction":
        return _friction_alone(float(batch.residual[0]))
    if case.duty.inner_speed * case.duty.outer_speed < 0.0:
        return (
            "Between rings that turn against each other the balls may orbit so slowly that the "
            "gyroscopic moment overturns one that carries little load. Add axial load, or change "
            "the ratio of the speeds."
        )
    return (
        f"The solver stopped at a residual of {batch.residual[0]:.1e} of the loads, above "
        f"{status.TOLERANCE:.0e}, so it shows no result. Vary a load or the speed a little, hold "
        "the tilts, or approach the duty in steps; and please report the case."
    )


def _speed_factor(case: Case) -> float:
    """N d_m of the faster ring and the largest row; mm r/min."""
    speed = max(abs(case.duty.inner_speed), abs(case.duty.outer_speed))
    pitch = max(place.bearing.pitch_diameter for place in case.bearing.places)
    return speed * 30.0 / pi * pitch * 1e3


def _over_shoulder(case: Case) -> str:
    """Say where the grooves end, and what keeps the balls in them."""
    return (
        f"The centre of a loaded contact lies beyond the edge of its groove: the inner groove ends "
        f"at a contact angle of {_edge(case, 'inner'):.1f}°, the outer at "
        f"{_edge(case, 'outer'):.1f}° (90° where no shoulder height is given: a half circle). "
        "Where speed drives the inner contact up its groove, a lower speed or more axial load or "
        "preload brings it back; where the load does, less axial load, moment or tilt, or a higher "
        "shoulder (bearing.inner_shoulder_height, bearing.outer_shoulder_height)."
    )


def _edge(case: Case, race: Race) -> float:
    """The contact angle in degrees at which the shallowest groove of a race ends."""
    return min(
        degrees(acos(float(edge_cosine(place.bearing, race)))) for place in case.bearing.places
    )


def _no_equilibrium(case: Case, axis: int) -> str:
    """Say which direction nothing supports, and what would."""
    bearing = case.bearing
    one_sided = [ring_geometry(place.bearing).one_sided for place in bearing.places]
    if bearing.is_set and all(one_sided) and axis == 0:
        return _set_without_equilibrium(case)
    if len(set(one_sided)) > 1:
        return _LOST_SHOULDER
    lost = f"Nothing supports the inner ring {_DIRECTIONS[axis]}: "
    if not all(one_sided):
        return lost + (
            "the balls never come to carry the load. Give a smaller load, or hold this degree of "
            "freedom with a displacement."
        )
    if axis == 0:
        return lost.replace("along x", "toward -x") + (
            "an angular-contact bearing carries axial load toward +x only, and a radial load "
            "needs an axial load beside it (about fz tan(contact angle)). Turn the load round, "
            "add axial preload (duty.load.fx), or hold the ring with duty.displacement.x."
        )
    return lost + (
        "balls would have to carry on the shoulder that an angular-contact bearing lacks. Add "
        "axial preload (duty.load.fx), lower the moment, or hold the tilt."
    )


def _set_without_equilibrium(case: Case) -> str:
    """Of rows that each carry axial load one way: all the same way, on springs, or clamped."""
    signs = {place.sign for place in case.bearing.places}
    if len(signs) == 1:
        faced, away = ("+x", "-x") if signs == {1.0} else ("-x", "+x")
        return (
            f"Nothing supports the inner ring toward {away}: all rows carry axial load toward "
            f"{faced} only, and a radial load needs an axial load beside it in every row (about fz "
            "tan(contact angle)). Turn the load round, add axial load (duty.load.fx), take an "
            'arrangement with rows that face each other, such as "DB", or hold the ring with '
            "duty.displacement.x."
        )
    spring = None if case.bearing.preload is None else case.bearing.preload.spring
    if spring is None:
        return _LOST_SHOULDER
    axial = case.duty.load.fx or 0.0
    if axial <= -spring:
        return (
            f"Nothing supports the inner ring toward -x: an axial load of {-axial:.4g} N pushes "
            f"back the springs, which press with {spring:.4g} N. Take springs that are stronger "
            "than the load, clamp the rings (bearing.preload.force), or turn the load or the set "
            "round: toward +x the rows that face + carry it without the springs."
        )
    return (
        f"Springs of {spring:.4g} N do not keep the balls of every row in place: in each row a "
        "radial load needs an axial load beside it (about fz tan(contact angle)), and a moment "
        "needs more. Take stronger springs, clamp the rings (bearing.preload.force), lower the "
        "radial load or the moment, or hold the tilts."
    )


def _friction_alone(residual: float) -> str:
    """Advice where balls that friction controls found no balance, or one that cannot be shown."""
    if residual <= status.TOLERANCE:
        return (
            "Under friction alone the forces balance, but a ball stands where none can be or the "
            "power does not balance, so there is no result to show. Vary a little the load, the "
            "speed or lubricant.friction_coefficient, take the other model.mesh, more load or less "
            'model.cage_drag; raceway_control = "jones" gives loads and angles close to these.'
        )
    return (
        f"Under friction alone the solver stopped at a residual of {residual:.1e} of the loads, so "
        "it shows no result. Vary a little the load, the speed or lubricant.friction_coefficient, "
        "take the other model.mesh, more load or less model.cage_drag; "
        'raceway_control = "jones" gives loads and angles close to these.'
    )
