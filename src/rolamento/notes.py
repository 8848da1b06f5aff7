"""What the user should know about a result, and what he can do where there is none.

A note never changes a number. Each check reads one solved case and returns sentences: limits
passed, contacts lost, assumptions strained.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import acos, degrees, radians
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.case import Case
from rolamento.case.duty import AXES, LOADS
from rolamento.catalogue import built_in_geometry
from rolamento.geometry import Race, edge_cosine, ring_geometry
from rolamento.kinematics import (
    RacewayControl,
    friction_demand,
    jones_control,
    spin_resistance,
)
from rolamento.numerics import BoolArray, FloatArray
from rolamento.status import (
    CONVERGED,
    INVALID_INPUT,
    NO_EQUILIBRIUM,
    OVER_SHOULDER,
    OVERLOADED,
    TOLERANCE,
    UNHELD_BALL,
)
from rolamento.units import rpm_of

if TYPE_CHECKING:
    from rolamento.solved import Solved

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
STATIC_PRESSURE_LIMIT: Final = 4.2e9
"""Pa; permanent set of 1e-4 ball diameters at the ball-groove contact (ISO 76)."""
SPEED_LIMIT: Final = 3.0e6
"""mm/min: n d_m of the fastest hybrid spindle bearings; 1 mm/min is 1 rpm times 1 mm."""
TILT_LIMIT: Final = radians(1.0)
"""rad: the equations take tilts as small; at 1 degree that costs up to 2 % of BD."""
FRICTION_LIMIT: Final = 0.1
"""Coefficient of friction above which a lubricated contact will hardly hold the ball."""
SPINNING_ANGLE: Final = radians(0.1)
"""rad: a ball at a smaller contact angle hardly spins, whichever race controls it."""
FREE_STIFFNESS: Final = 1e-9
"""Of the greatest stiffness: a direction with less is free."""
PAST_EDGE: Final = 1e-9
"""Of the groove's offset: what is less is rounding."""
PRELOAD_MARGIN: Final = 1.1
"""Times the load at which a row lifts off: what is nearer deserves a word."""
SKID_LIMIT: Final = 0.05
"""Of the cage's speed under outer raceway control: what differs more deserves a word."""
SPIN_LIMIT: Final = 0.05
"""Spin to roll at both races above which no race can be said to control a ball."""
_MOST_AZIMUTHS: Final = 6
_MOST_IN_A_ROW: Final = 4


def notes_on(solved: Solved) -> tuple[str, ...]:
    """The notes on a single case; none without a result."""
    if not solved.converged[0]:
        return ()
    checks = (
        _lost_rows, _lost_contacts, _pressures, _past_edge, _shoulders, _speeds, _tilts,
        _free_directions, _control, _gyroscopic_slip, _rolling, _inferred_balls, _nearly_lost,
    )  # fmt: skip
    return tuple(note for check in checks for note in check(solved))


def jones_verdict(solved: Solved) -> NDArray[np.int64]:
    """Which race controls every element by Jones's criterion: codes (cases, elements)."""
    inner, outer = solved.inner, solved.outer
    return jones_control(
        spin_resistance(inner.load, inner.semi_major, inner.ellipticity),
        spin_resistance(outer.load, outer.semi_major, outer.ellipticity),
        inner.contact_angle,
        outer.contact_angle,
    )


def _lost_rows(solved: Solved) -> Iterator[str]:
    """Rows of a set that the inner ring does not touch at all."""
    loaded = solved.loaded_elements[0]
    lost = np.flatnonzero(loaded == 0).tolist()
    if lost and len(lost) < len(loaded):
        cause = (
            "its preload is gone" if solved.case.bearing.preload else "no preload holds it there"
        )
        yield (
            f"No ball of row {', '.join(map(str, lost))} presses on the inner ring: {cause}, and "
            "the rest of the set carries the whole load. Where the bearing turns, such balls skid."
        )


def _lost_contacts(solved: Solved) -> Iterator[str]:
    """Balls that the inner ring does not touch."""
    free = ~solved.loaded[0]
    if free.all():
        yield "No ball presses on the inner ring: without a load, its place is one of many."
        return
    # of rows that the ring does not touch at all _lost_rows has told
    free &= solved.loaded_elements[0, solved.elements.row] > 0
    if free.any():
        pressed = bool((solved.outer.load[0, free] > 0.0).any())
        model = solved.case.model
        alone = model.cage == "none" and model.raceway_control != "friction"
        holder = "only centrifugal force presses on them" if pressed else "nothing presses on them"
        if pressed and not alone:
            holder += ", and they orbit with the cage"
        yield f"{_balls(free)} without inner contact ({_azimuths(solved, free)}): {holder}."
        if pressed and alone:
            yield (
                "The orbit of a ball without inner contact, and with it its centrifugal force, is "
                'a guess under model.cage = "none": raceway control says nothing about it. Under '
                '"loose" the cage drives it.'
            )


def _pressures(solved: Solved) -> Iterator[str]:
    for race, contacts in solved.contacts.items():
        over = contacts.max_pressure[0] > STATIC_PRESSURE_LIMIT
        if over.any():
            worst = contacts.max_pressure[0, over].max()
            yield (
                f"Contact pressure at the {race} race is up to {worst / 1e6:.0f} MPa, above "
                f"4200 MPa (ISO 76), where balls begin to dent the groove: {_balls(over)} "
                f"({_azimuths(solved, over)})."
            )


def _past_edge(solved: Solved) -> Iterator[str]:
    """Balls that the inner groove has left, so that nothing presses on them."""
    inner, rows = solved.inner, solved.rows
    length = rows.per_element((rows.inner_conformity - 0.5) * rows.ball_diameter)
    past = ((inner.approach > PAST_EDGE * length) & (inner.load == 0.0))[0]
    if past.any():
        yield (
            f"{_balls(past)} past the edge of the inner groove ({_azimuths(solved, past)}):"
            " no force is computed there. In the real bearing such a ball may bear on the edge of "
            "the shoulder, and the loads of all balls differ from those shown."
        )


def _shoulders(solved: Solved) -> Iterator[str]:
    """Contact ellipses that run over the edge of their groove."""
    bearings = [place.bearing for place in solved.case.bearing.places]
    row = solved.elements.row
    for race, contacts in solved.contacts.items():
        ends = np.array([acos(float(edge_cosine(bearing, race))) for bearing in bearings])[row]
        reach = np.abs(contacts.contact_angle) + contacts.semi_major / (
            contacts.conformity * contacts.ball_diameter
        )
        reach = np.where(contacts.load == 0.0, 0.0, reach)[0]
        over = reach > ends
        if over.any():
            worst = int(np.argmax(reach - ends))
            given = getattr(bearings[row[worst]], f"{race}_shoulder_height") is not None
            groove = "the groove" if given else "the groove, taken as a half circle,"
            yield (
                f"The contact ellipse runs over the {race} shoulder: it reaches "
                f"{degrees(reach[worst]):.1f}°, {groove} ends at {degrees(ends[worst]):.1f}° "
                f"({_balls(over)}, {_azimuths(solved, over)}). Pressure at the edge is "
                "higher than shown."
            )


def _speeds(solved: Solved) -> Iterator[str]:
    product = _speed_factor(solved)
    if product > SPEED_LIMIT:
        yield (
            f"The speed factor n·d_m = {product:.2g} mm/min is beyond what rolling bearings reach "
            f"({SPEED_LIMIT:.0e} mm/min): the rings' own growth and the heat are not in these "
            "numbers."
        )


def _speed_factor(solved: Solved) -> float:
    """The faster ring's n times d_m of the largest row; mm/min."""
    speed = max(abs(float(solved.field(f"duty.{race}_speed")[0])) for race in ("inner", "outer"))
    return float(rpm_of(speed)) * float(solved.rows.pitch_diameter[0].max()) * 1e3


def _tilts(solved: Solved) -> Iterator[str]:
    worst = max(abs(float(solved.displacement.ry[0])), abs(float(solved.displacement.rz[0])))
    if worst > TILT_LIMIT:
        yield (
            f"The ring tilts by {degrees(worst):.2f}°: the equations take tilts as small, good "
            "to about 1°."
        )


def _free_directions(solved: Solved) -> Iterator[str]:
    """Directions that are under no load and have no stiffness: their displacement is any."""
    if not solved.load.array.any():
        return  # nothing is held, and _lost_contacts says so
    free = _free(solved)
    arm = 0.5 * float(solved.rows.pitch_diameter[0, 0])
    arms = np.array([1.0, 1.0, 1.0, arm, arm])
    scaled = solved.stiffness.array[0] / np.outer(arms, arms)
    vectors, values, _ = np.linalg.svd(scaled[np.ix_(free, free)])
    names = [axis for axis, is_free in zip(AXES, free, strict=True) if is_free]
    for value, vector in zip(values, vectors.T, strict=True):
        if value <= FREE_STIFFNESS * np.abs(scaled).max():
            name = names[int(np.abs(vector).argmax())]
            yield (
                f"No ball holds the ring along {name}: it carries no load there, and the "
                "displacement shown is one of many."
            )


def _free(solved: Solved) -> BoolArray:
    """Which degrees of freedom take a load rather than a displacement; (5,)."""
    free = np.array(solved.case.duty.free)
    for i, (axis, load) in enumerate(zip(AXES, LOADS, strict=True)):
        free[i] |= f"duty.load.{load}" in solved.varied
        free[i] &= f"duty.displacement.{axis}" not in solved.varied
    return free


def _control(solved: Solved) -> Iterator[str]:
    """Where Jones's criterion does not bear out the raceway control that was assumed."""
    assumed = solved.case.model.raceway_control
    if assumed in ("none", "friction") or not _turns(solved):
        return
    if assumed == "jones":
        undecided = solved.elements.raceway_control[0] == RacewayControl.INDETERMINATE
        if undecided.any():
            yield (
                f"Jones's criterion favours neither race at {_balls(undecided)} ("
                f"{_azimuths(solved, undecided)}): they are taken as before, as controlled by the "
                "race that they last rolled on, first the outer."
            )
        return
    against = RacewayControl.INNER if assumed == "outer" else RacewayControl.OUTER
    spinning = np.abs(solved.inner.contact_angle[0]) > SPINNING_ANGLE
    contradicted = (jones_verdict(solved)[0] == against) & spinning
    if contradicted.any():
        yield (
            f"Jones's criterion contradicts {assumed} raceway control at {_balls(contradicted)} "
            f'({_azimuths(solved, contradicted)}); model.raceway_control = "jones" decides '
            "ball by ball."
        )


def _gyroscopic_slip(solved: Solved) -> Iterator[str]:
    """Balls whose gyroscopic moment needs more friction than a lubricated contact gives."""
    mode = solved.case.model.raceway_control
    if mode == "friction":
        return
    inner, outer, moment = solved.inner, solved.outer, solved.elements.gyroscopic_moment
    if mode == "none":  # both races share it
        load, share = np.minimum(inner.load, outer.load), 1.0
    else:
        by_inner = solved.elements.raceway_control == RacewayControl.INNER
        load, share = np.where(by_inner, inner.load, outer.load), 2.0
    needed = friction_demand(moment, inner.ball_diameter, load, share)
    needed = np.where(moment == 0.0, 0.0, needed)[0]
    slipping = needed > FRICTION_LIMIT
    if slipping.any():
        yield (
            "To hold the gyroscopic moment as assumed, a coefficient of friction of "
            f"{needed.max():.2f} is needed, more than about {FRICTION_LIMIT}: "
            f"{_balls(slipping)} will slip ({_azimuths(solved, slipping)})."
        )


def _rolling(solved: Solved) -> Iterator[str]:
    """What friction does that raceway control would not show."""
    if solved.case.model.raceway_control != "friction":
        return
    rolling = solved.rolling
    if rolling is None:
        yield (
            "The rings do not turn against each other, so friction has nothing to decide: this is "
            "the result of outer raceway control."
        )
        return
    skid = float(rolling.skid[0])
    if abs(skid) > SKID_LIMIT:
        sense = "behind" if skid > 0.0 else "ahead of"
        speed = rpm_of(float(rolling.cage_speed[0]))
        usual = rpm_of(float(rolling.control_cage_speed[0]))
        yield (
            f"The cage runs {100.0 * abs(skid):.1f} % {sense} that of outer raceway "
            f"control ({speed:.1f} instead of {usual:.1f} rpm): the balls skid, and the fault "
            "frequencies move with the cage."
        )
    inner, outer = (np.abs(contacts.spin_to_roll[0]) for contacts in solved.contacts.values())
    spinning = (np.minimum(inner, outer) > SPIN_LIMIT) & (solved.inner.load[0] > 0.0)
    if spinning.any():
        yield (
            f"{_balls(spinning)} spin at both races ({_azimuths(solved, spinning)}), by "
            f"up to {inner[spinning].max():.2f} of the roll at the inner and "
            f"{outer[spinning].max():.2f} at the outer race: no raceway control describes them."
        )


def _inferred_balls(solved: Solved) -> Iterator[str]:
    """Balls that stand in for those that the catalogue does not tell."""
    bearing = solved.case.bearing
    if bearing.designation is None or "inferred" not in bearing.origins.values():
        return
    name = bearing.designation
    alike = sum(one.reproduces for one in built_in_geometry(name).candidates)
    if alike > 1:
        yield (
            f"The balls of {name} are not published, but inferred from its ratings, which {alike}"
            " insides reproduce (rolamento catalogue show): the best one is taken."
        )
    else:
        yield (
            f"The balls of {name} are not published, but inferred from its ratings; no other"
            " standard balls reproduce them."
        )


def _nearly_lost(solved: Solved) -> Iterator[str]:
    preload = solved.preload
    row = None if preload is None else preload.lost_row
    if preload is None or row is None or not 1.0 <= preload.loss_factor < PRELOAD_MARGIN:
        return
    if solved.loaded_elements[0, row]:  # else _lost_rows says so
        yield (
            f"Row {row} is about to lose its preload: it lifts off the inner ring at "
            f"{preload.loss_factor:.3g} times this load. More preload keeps it in contact."
        )


def _turns(solved: Solved) -> bool:
    return bool(solved.field("duty.inner_speed")[0] != solved.field("duty.outer_speed")[0])


# --- how notes name balls -------------------------------------------------------------------------


def _balls(chosen: BoolArray) -> str:
    """Say how many balls."""
    number = int(chosen.sum())
    return "1 ball" if number == 1 else f"{number} balls"


def _azimuths(solved: Solved, chosen: BoolArray) -> str:
    """Say where some balls of the first case are; of a set, row by row."""
    row, azimuth = solved.elements.row, solved.elements.azimuth[0]
    if len(solved.rows) < 2:
        return f"azimuth {_listed(azimuth[chosen], _MOST_AZIMUTHS)}"
    parts = []
    for index in np.unique(row[chosen]).tolist():
        own = chosen & (row == index)
        whole = own.sum() == (row == index).sum()
        parts.append(f"row {index}: {'all' if whole else _listed(azimuth[own], _MOST_IN_A_ROW)}")
    more = "; …" if len(parts) > _MOST_AZIMUTHS else ""
    return f"azimuth {'; '.join(parts[:_MOST_AZIMUTHS])}{more}"


def _listed(azimuths: FloatArray, most: int) -> str:
    angles = [f"{degrees(azimuth):.4g}°" for azimuth in azimuths]
    return ", ".join(angles[:most]) + (" …" if len(angles) > most else "")


# --- advice ---------------------------------------------------------------------------------------


def advice_on(solved: Solved, case: int = 0) -> str | None:
    """What a person can do about a case without a result; None where there is one."""
    code = int(solved.status.number[case])
    if code == CONVERGED:
        return None
    given, residual = solved.case, float(solved.status.residual[case])
    if code == NO_EQUILIBRIUM:
        axial = float(np.nan_to_num(solved.field("duty.load.fx")[case]))
        return _no_equilibrium(given, int(solved.status.unsupported[case]), axial)
    factor = _speed_factor(solved[case])
    if factor > _FASTEST and code != INVALID_INPUT:
        return (
            f"An overspeed: the rings turn at n d_m = {1e-6 * factor:.3g} million mm r/min, and no "
            f"ball bearing is known to have run beyond some {1e-6 * _FASTEST:.0f} million: "
            "centrifugal force presses the balls out of all elastic contact. Check the unit of the "
            "speed, or lower it."
        )
    if code == OVERLOADED:
        return (
            "A ball would sink into its groove by more than 2 % of its diameter, far beyond any "
            "elastic contact: check the units of the loads and displacements."
        )
    if code == INVALID_INPUT:
        return "A number of this case is not finite, or out of its bounds."
    if code == OVER_SHOULDER:
        return _over_shoulder(given)
    alone = given.model.raceway_control == "inner" and given.model.cage == "none"
    if code == UNHELD_BALL or alone:
        return (
            "This raceway control cannot hold a ball that a race loads too lightly to "
            'bear its gyroscopic moment. Take model.cage = "loose", model.raceway_control = '
            '"jones" or "outer", or more axial load.'
        )
    if given.model.raceway_control == "friction":
        return _friction_alone(residual)
    inner, outer = (float(solved.field(f"duty.{race}_speed")[case]) for race in ("inner", "outer"))
    if inner * outer < 0.0:
        return (
            "Between rings that turn against each other the balls may orbit so slowly that the "
            "gyroscopic moment overturns one that carries little load. Add axial load, or change "
            "the ratio of the speeds."
        )
    return (
        f"The solver stopped at a residual of {residual:.1e} of the loads, above "
        f"{TOLERANCE:.0e}, so it shows no result. Vary a load or the speed a little, hold "
        "the tilts, or approach the duty in steps; and please report the case."
    )


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


def _no_equilibrium(case: Case, axis: int, axial_load: float) -> str:
    """Say which direction nothing supports, and what would."""
    bearing = case.bearing
    one_sided = [ring_geometry(place.bearing).one_sided for place in bearing.places]
    if bearing.is_set and all(one_sided) and axis == 0:
        return _set_without_equilibrium(case, axial_load)
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


def _set_without_equilibrium(case: Case, axial: float) -> str:
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
    if residual <= TOLERANCE:
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
