"""What is said of a solved case: its notes, and the advice where it has no result."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from rolamento.words.naming import by_element
from rolamento.words.sentences import Sentence
from rolamento.words.speaking import ENGLISH, counted, language, marked, said, said_in

__all__ = ["SENTENCES", "direction", "race_of", "where_of"]

_MOST_ROWS: Final = 6

Values = Mapping[str, Any]


# --- how notes name elements --------------------------------------------------------------------


def where_of(values: Values) -> str:
    """Say where some elements are; of a set, row by row."""
    azimuths = values["azimuths"]
    if "rows" not in values:
        return said("azimuth {azimuths:.4 °}", azimuths=azimuths)
    parts = []
    for row in dict.fromkeys(values["rows"]):
        own = [a for a, of in zip(azimuths, values["rows"], strict=True) if of == row]
        parts.append(
            said("row {row}: all", row=row)
            if row in values["whole_rows"]
            else said("row {row}: {azimuths:.4 °}", row=row, azimuths=own)
        )
    more = "; …" if len(parts) > _MOST_ROWS else ""
    return said("azimuth {rows}", rows="; ".join(parts[:_MOST_ROWS]) + more)


def _count(values: Values) -> int:
    return len(values["balls"])


def _balls_unloaded(values: Values) -> str:
    n, where = _count(values), where_of(values)
    if not values["pressed_outward"]:
        return counted(
            "{n} ball without inner contact ({where}): no force acts on it.",
            "{n} balls without inner contact ({where}): no force acts on them.",
            n, where=where,
        )  # fmt: skip
    if values["cage_drives"]:
        return counted(
            "{n} ball without inner contact ({where}): only centrifugal force acts on it, and it"
            " orbits with the cage.",
            "{n} balls without inner contact ({where}): only centrifugal force acts on them, and"
            " they orbit with the cage.",
            n, where=where,
        )  # fmt: skip
    return counted(
        "{n} ball without inner contact ({where}): only centrifugal force acts on it.",
        "{n} balls without inner contact ({where}): only centrifugal force acts on them.",
        n, where=where,
    )  # fmt: skip


def _orbit_outside(values: Values) -> str:
    return said(
        "{balls} ({where}): inner raceway control gives an orbital speed outside the speeds of"
        " both rings, which no ball without slip can have, because the contact angles at the races"
        " lie far apart. Its centrifugal force and the loads that follow are not reliable. Choose"
        ' `model.raceway_control` = "jones" or "outer".',
        balls=_balls(values),
        where=where_of(values),
    )


def _balls(values: Values) -> str:
    return counted("{n} ball", "{n} balls", _count(values))


def race_of(values: Values) -> str:
    """Name the race of a note."""
    return said_in("race", "inner") if values["race"] == "inner" else said_in("race", "outer")


def _contact_pressure_high(values: Values) -> str:
    return said(
        "The contact pressure at the {race} race reaches {max_pressure:.0f MPa}, above"
        " {limit:.0f MPa} (ISO 76), at which balls begin to indent the raceway permanently:"
        " {balls} ({where}).",
        balls=_balls(values),
        race=race_of(values),
        where=where_of(values),
        max_pressure=values["max_pressure"],
        limit=values["limit"],
    )


def _ball_past_groove_edge(values: Values) -> str:
    return counted(
        "{n} ball beyond the edge of the inner groove ({where}): no contact force is computed"
        " there. In the real bearing such a ball may bear on the edge of the shoulder, and the"
        " loads of all balls differ from those shown.",
        "{n} balls beyond the edge of the inner groove ({where}): no contact force is computed"
        " there. In the real bearing such balls may bear on the edge of the shoulder, and the"
        " loads of all balls differ from those shown.",
        _count(values), where=where_of(values),
    )  # fmt: skip


def _ellipse_over_shoulder(values: Values) -> str:
    numbers = {
        "balls": _balls(values),
        "race": race_of(values),
        "reach": values["reach"],
        "edge": values["edge"],
        "where": where_of(values),
    }
    if values["shoulder_given"]:
        return said(
            "The contact ellipse is truncated at the {race} shoulder: it reaches {reach:.1f °},"
            " and the groove ends at {edge:.1f °} ({balls}, {where}). The pressure at the edge is"
            " higher than shown.",
            **numbers,
        )
    return said(
        "The contact ellipse is truncated at the {race} shoulder: it reaches {reach:.1f °}, and"
        " the groove, assumed to be a half circle, ends at {edge:.1f °} ({balls}, {where}). The"
        " pressure at the edge is higher than shown.",
        **numbers,
    )


def _ellipse_over_arch(values: Values) -> str:
    return said(
        "The contact ellipse at the {race} race runs over the middle of the arch, where the other"
        " arc begins: it reaches down to {reach:.1f °} ({balls}, {where}). The pressure at that"
        " edge is higher than shown.",
        balls=_balls(values),
        race=race_of(values),
        reach=values["reach"],
        where=where_of(values),
    )


def _gyroscopic_moment_not_held(values: Values) -> str:
    numbers = {"moment": values["moment"], "limit": values["limit"]}
    needed = values["friction_coefficient"]
    if needed is None:
        return said(
            "The balls orbit with the cage at its nominal speed, and their gyroscopic moment, up to"
            " {moment:.3 N·mm}, is left out of the balance: friction has to hold it, and there is a"
            " ball without load.",
            **numbers,
        )
    return said(
        "The balls orbit with the cage at its nominal speed, and their gyroscopic moment, up to"
        " {moment:.3 N·mm}, is left out of the balance: holding it takes a coefficient of"
        " friction of {friction_coefficient:.2f}, more than about {limit:.1f}, so that the"
        " balls slip. More load or less speed keeps them rolling.",
        friction_coefficient=needed,
        **numbers,
    )


def _four_point_under_radial_load(values: Values) -> str:
    first = said(
        "The axial load is {ratio:.2f} of the radial load; a four-point bearing is for {limit:.2f}"
        " or more (SKF), where each ball bears on one arc of each ring.",
        ratio=values["ratio"],
        limit=values["limit"],
    )
    n = values["both_arcs"]
    if not n:
        return first
    second = counted(
        "Here {n} ball bears on both arcs and has to slide on them: friction and wear are higher"
        " than shown, and the life may be shorter.",
        "Here {n} balls bear on both arcs and have to slide on them: friction and wear are higher"
        " than shown, and the life may be shorter.",
        n,
    )
    return f"{first} {second}"


def _no_load_given(values: Values) -> str:
    if values["speed"]:
        return said(
            "No load is given: nothing presses on the rolling elements, and there is nothing to"
            " calculate but frequencies. Give the axial load (`duty.load.fx`), the radial load"
            " (`duty.load.fz`), or both."
        )
    return said(
        "Neither load nor speed is given: nothing presses on the rolling elements, and there is"
        " nothing to calculate. Give the axial load (`duty.load.fx`) or the radial load"
        " (`duty.load.fz`), and the speed (`duty.inner_speed`)."
    )


def _thrust_over_shoulder(values: Values) -> str:
    if values["minimum_load"] is None:
        return said(
            "The centre of a loaded contact lies beyond the edge of its groove, which ends"
            " {inner_edge:.1f °} to either side of its bottom at the shaft washer and"
            " {outer_edge:.1f °} at the housing washer (90° where no shoulder height is given: a"
            " half circle). Less radial load or tilt, or more axial load, keeps the balls in their"
            " grooves.",
            **values,
        )
    return said(
        "The centre of a loaded contact lies beyond the edge of its groove, which ends"
        " {inner_edge:.1f °} to either side of its bottom at the shaft washer and"
        " {outer_edge:.1f °} at the housing washer (90° where no shoulder height is given: a half"
        " circle). A centrifugal force of {centrifugal_force:.3 N} drives each ball outward: by"
        " force alone an axial load of {minimum_load:.3 N} keeps them in, without radial load or"
        " tilt; the makers' minimum load is higher. Add axial load, or reduce the speed, the radial"
        " load or the tilt.",
        **values,
    )


def _sphere_holds_no_moment(values: Values) -> str:
    return said(
        "A self-aligning bearing bears no moment: nothing supports the inner ring {direction}. Take"
        " the moment away, or hold the tilt with a displacement.",
        direction=direction(values["axis"]),
    )


def _jones_undecided(values: Values) -> str:
    return counted(
        "Jones's criterion favours neither race at {n} ball ({where}): it is kept under the"
        " control of the race that it last rolled on, initially the outer one.",
        "Jones's criterion favours neither race at {n} balls ({where}): they are kept under the"
        " control of the race that they last rolled on, initially the outer one.",
        _count(values), where=where_of(values),
    )  # fmt: skip


def _jones_contradicts(values: Values) -> str:
    numbers = {"balls": _balls(values), "where": where_of(values)}
    if values["assumed"] == "outer":
        return said(
            "Jones's criterion contradicts outer raceway control at {balls} ({where});"
            ' `model.raceway_control` = "jones" decides ball by ball.',
            **numbers,
        )
    return said(
        "Jones's criterion contradicts inner raceway control at {balls} ({where});"
        ' `model.raceway_control` = "jones" decides ball by ball.',
        **numbers,
    )


def _gyroscopic_slip(values: Values) -> str:
    return said(
        "Holding the gyroscopic moment as assumed takes a coefficient of friction of"
        " {friction_coefficient:.2f}, more than about {limit:.1f}: {balls} will slip ({where}).",
        balls=_balls(values),
        where=where_of(values),
        friction_coefficient=values["friction_coefficient"],
        limit=values["limit"],
    )


def _spin_at_both_races(values: Values) -> str:
    return counted(
        "{n} ball spins at both races ({where}), with a spin-to-roll ratio of up to {inner:.2f} at"
        " the inner and {outer:.2f} at the outer race: no raceway control describes it.",
        "{n} balls spin at both races ({where}), with spin-to-roll ratios of up to {inner:.2f} at"
        " the inner and {outer:.2f} at the outer race: no raceway control describes them.",
        _count(values), where=where_of(values), inner=values["inner"], outer=values["outer"],
    )  # fmt: skip


def _cage_skids(values: Values) -> str:
    numbers = {**values, "skid": abs(values["skid"])}
    if values["skid"] > 0.0:
        return said(
            "The cage runs {skid:.1f %} slower than under outer raceway control"
            " ({cage_speed:.1f [rpm]} instead of {control_cage_speed:.1f rpm}): the balls skid, and"
            " the fault frequencies shift with the cage speed.",
            **numbers,
        )
    return said(
        "The cage runs {skid:.1f %} faster than under outer raceway control"
        " ({cage_speed:.1f [rpm]} instead of {control_cage_speed:.1f rpm}): the balls skid, and"
        " the fault frequencies shift with the cage speed.",
        **numbers,
    )


def _row_unloaded(values: Values) -> str:
    n, rows = len(values["rows"]), values["rows"]
    if values["preloaded"]:
        return counted(
            "No ball of row {rows} contacts the inner ring: the row has lost its preload, and the"
            " rest of the set carries the whole load. In a rotating bearing such balls skid.",
            "No ball of rows {rows} contacts the inner ring: these rows have lost their preload,"
            " and the rest of the set carries the whole load. In a rotating bearing such balls"
            " skid.",
            n, rows=rows,
        )  # fmt: skip
    return counted(
        "No ball of row {rows} contacts the inner ring: no preload holds the row in contact, and"
        " the rest of the set carries the whole load. In a rotating bearing such balls skid.",
        "No ball of rows {rows} contacts the inner ring: no preload holds these rows in contact,"
        " and the rest of the set carries the whole load. In a rotating bearing such balls skid.",
        n, rows=rows,
    )  # fmt: skip


# --- advice -------------------------------------------------------------------------------------


def direction(axis: str) -> str:
    """Say in which direction the ring is not held."""
    if axis in ("ry", "rz"):
        return said("against tilting about {axis} ({name})", axis=axis[1], name=axis)
    return said("along {axis}", axis=axis)


def _unsupported(values: Values) -> str:
    return said(
        "Nothing supports the inner ring {direction}: the balls never come to carry the load."
        " Apply a smaller load, or hold this degree of freedom with a displacement.",
        direction=direction(values["axis"]),
    )


def _unsupported_one_sided(values: Values) -> str:
    return said(
        "Nothing supports the inner ring {direction}: balls would have to bear on the shoulder that"
        " an angular contact bearing does not have. Add axial preload (`duty.load.fx`), reduce the"
        " moment, or hold the tilt.",
        direction=direction(values["axis"]),
    )


def _invalid_input(values: Values) -> str:
    rules = values.get("rule")
    if not rules:
        return said("A value of this case is not finite, or out of range.")
    return str(rules.get(language(), rules[ENGLISH]))


def _designation_without_effect(values: Values) -> str:
    parts = [
        said("{part}: {meaning}", part=part, meaning=said(meaning))
        for part, meaning in values["parts"]
    ]
    return said(
        "Parts of {designation} that are understood and have no effect on loads, film and life:"
        " {parts}.",
        designation=values["designation"],
        parts="; ".join(parts),
    )


def _stainless(values: Values) -> str:
    low, high = values["low"], values["high"]
    return said(
        "{designation} is of stainless steel ({part}), but C and C_0 here are those of bearing"
        " steel. Stainless ball bearings have {low:.2 [%]} to {high:.2 %} of them (SMB Bearings),"
        " and {short:.2 [%]} to {long:.2 %} of the rating life: give `life.dynamic_rating` and"
        " `life.static_rating`.",
        designation=values["designation"],
        part=values["part"],
        low=low,
        high=high,
        short=low**3,
        long=high**3,
    )


def _designation_preload(values: Values) -> str:
    return said(
        "{designation} names a preload ({part}: {meaning}) whose force is in no list here: the rows"
        " are set without preload. Give `bearing.preload`.",
        designation=values["designation"],
        part=values["part"],
        meaning=said(values["meaning"]),
    )


def _designation_not_understood(values: Values) -> str:
    return said(
        "Parts of {designation} that are not recognised, and not taken into account: {parts}.",
        designation=values["designation"],
        parts=", ".join(values["parts"]),
    )


SENTENCES: Final[dict[str, Sentence]] = {
    "text": lambda values: str(values["text"]),  # of files of an earlier release
    # notes
    "row_unloaded": _row_unloaded,
    "no_load_given": _no_load_given,
    "no_ball_loaded": marked(
        "No ball contacts the inner ring: without load its position is indeterminate."
    ),
    "balls_unloaded": _balls_unloaded,
    "orbit_assumed": marked(
        "The orbital speed of a ball without inner contact, and with it its centrifugal force, is"
        ' an assumption with `model.cage` = "none": raceway control does not determine it. With'
        ' "loose" the cage drives it.'
    ),
    "orbit_outside": _orbit_outside,
    "contact_pressure_high": _contact_pressure_high,
    "ball_past_groove_edge": _ball_past_groove_edge,
    "ellipse_over_shoulder": _ellipse_over_shoulder,
    "speed_factor_high": marked(
        "The speed factor n·d_m of {speed_factor:.3 [10⁶ mm·rpm]} million mm·rpm exceeds what"
        " rolling bearings reach ({limit:.3 [10⁶ mm·rpm]} million mm·rpm): centrifugal growth of"
        " the rings and heating are not included in these results."
    ),
    "tilt_large": marked(
        "The inner ring tilts by {tilt:.2f °}: the equations assume small tilts, up to about"
        " {limit:.0f °}."
    ),
    "direction_unsupported": marked(
        "No ball supports the ring along {axis}: it carries no load there, and the displacement"
        " shown is arbitrary."
    ),
    "ellipse_over_arch": _ellipse_over_arch,
    "gyroscopic_moment_left_out": marked(
        "The balls orbit with the cage at its nominal speed, and their gyroscopic moment, up to"
        " {moment:.3 N·mm}, is left out of the balance: friction holds it with a coefficient of"
        " {friction_coefficient:.2}."
    ),
    "gyroscopic_moment_not_held": _gyroscopic_moment_not_held,
    "four_point_under_radial_load": _four_point_under_radial_load,
    "thrust_under_radial_load": by_element(
        marked(
            "A thrust ball bearing is for axial load alone (makers' catalogues): the radial load of"
            " {radial:.4 N} shifts its washers until the balls climb the grooves, and the state"
            " shown is what ideal grooves would give. Let another bearing carry the radial load,"
            " and hold this one with `duty.displacement.y` and `duty.displacement.z`."
        ),
        marked(
            "A tapered roller thrust bearing is for axial load alone: its conical washers hardly"
            " resist the radial load of {radial:.4 N}, which shifts them far. Let another bearing"
            " carry the radial load, and hold this one with `duty.displacement.y` and"
            " `duty.displacement.z`."
        ),
    ),
    "tilt_beyond_self_aligning": marked(
        "The inner ring tilts by {tilt:.2f °}: self-aligning ball bearings permit about"
        " {limit:.1f °}, less if sealed. Beyond, the balls run off the outer race."
    ),
    "tilt_undetermined": marked(
        "A self-aligning bearing does not resist tilting: the tilt shown is arbitrary."
    ),
    "jones_undecided": _jones_undecided,
    "jones_contradicts": _jones_contradicts,
    "gyroscopic_slip": _gyroscopic_slip,
    "friction_control_at_rest": marked(
        "The rings do not rotate relative to each other, so that friction determines nothing: this"
        " is the result of outer raceway control."
    ),
    "cage_skids": _cage_skids,
    "spin_at_both_races": _spin_at_both_races,
    "geometry_estimated": marked(
        "The internal geometry of {designation} is not published; it is estimated from the load"
        " ratings, which {count} geometries reproduce (`rolamento catalogue show`): the best match"
        " is used."
    ),
    "geometry_estimated_uniquely": marked(
        "The internal geometry of {designation} is not published; it is estimated from the load"
        " ratings, and no other standard ball size reproduces them."
    ),
    "geometry_estimated_from_given": marked(
        "The internal geometry of {designation} is not published; it is estimated from the load"
        " ratings that are given (`life.dynamic_rating`, `life.static_rating`), which {count}"
        " geometries reproduce (`rolamento catalogue show`): the best match is used."
    ),
    "designation_listed_as": marked(
        "{designation} is looked up as {maker} {listed}, which has the same type, boundary"
        " dimensions and contact angle."
    ),
    "designation_without_effect": _designation_without_effect,
    "designation_preload": _designation_preload,
    "designation_not_understood": _designation_not_understood,
    "stainless_rating": _stainless,
    "pair_clearance_not_listed": marked(
        "{designation} has a small axial clearance in a pair ({part}), which is in no list here:"
        " the rows are set without clearance or preload. Give `bearing.preload` as a negative"
        " offset."
    ),
    "preload_nearly_lost": marked(
        "Row {row} is about to lose its preload: it lifts off the inner ring at {factor:.3} times"
        " this load. More preload keeps it in contact."
    ),
    # advice
    "overspeed": marked(
        "Overspeed: the rings rotate at n·d_m = {speed_factor:.3 [10⁶ mm·rpm]} million mm·rpm, and"
        " no ball bearing is known to have run beyond about {limit:.0f [10⁶ mm·rpm]} million:"
        " centrifugal force drives the balls out of any elastic contact. Check the unit of the"
        " speed, or reduce it."
    ),
    "overloaded": marked(
        "A ball would sink into its groove by more than {limit:.0f %} of its diameter, far beyond"
        " any elastic contact: check the units of the loads and displacements."
    ),
    "invalid_input": _invalid_input,
    "over_shoulder": marked(
        "The centre of a loaded contact lies beyond the edge of its groove: the inner groove ends"
        " at a contact angle of {inner_edge:.1f °}, the outer at {outer_edge:.1f °} (90° where no"
        " shoulder height is given: a half circle). Where speed drives the inner contact up its"
        " groove, a lower speed or more axial load or preload brings it back; where the load does,"
        " less axial load, moment or tilt, or a higher shoulder (`bearing.inner_shoulder_height`,"
        " `bearing.outer_shoulder_height`)."
    ),
    "thrust_over_shoulder": _thrust_over_shoulder,
    "thrust_carries_no_radial_load": by_element(
        marked(
            "A thrust ball bearing carries no radial load: the {radial:.4 N} given here push its"
            " balls out of their grooves, which the axial load of {axial:.4 N} cannot prevent. Let"
            " a radial bearing on the shaft carry it, and hold this one with `duty.displacement.y`"
            " and `duty.displacement.z`; or choose an angular contact bearing, such as one of"
            " series 72."
        ),
        marked(
            "A roller thrust bearing carries no radial load: flat washers do not resist the"
            " {radial:.4 N} given here, and conical ones hardly do. Let a radial bearing on the"
            " shaft carry it, and hold this one with `duty.displacement.y` and"
            " `duty.displacement.z`."
        ),
    ),
    "thrust_unsupported": by_element(
        marked(
            "Nothing supports the inner ring along x: a thrust ball bearing carries axial load of"
            " the shaft toward +x only, and needs some to keep its balls in their grooves. Reverse"
            " the load, add axial load (`duty.load.fx`), or hold the ring with"
            " `duty.displacement.x`."
        ),
        marked(
            "Nothing supports the shaft washer along x: a roller thrust bearing carries axial load"
            " of the shaft toward +x only, and no radial load. Reverse the load, add axial load"
            " (`duty.load.fx`), or hold the washer with `duty.displacement.x`; let a radial bearing"
            " on the shaft carry a radial load."
        ),
    ),
    "thrust_pushed_aside": by_element(
        marked(
            "The axial load does not hold the balls in their grooves against the radial load or the"
            " moment: a thrust bearing bears these only as far as its contact angles change and its"
            " balls stay loaded. Add axial load, or hold the ring with `duty.displacement`, as a"
            " radial bearing on the shaft does."
        ),
        marked(
            "The axial load does not keep the washers together against the moment, which they hold"
            " only while rollers on both sides are loaded. Add axial load, or hold the washer with"
            " `duty.displacement.ry` and `duty.displacement.rz`, as other bearings on the shaft do."
        ),
    ),
    "sphere_holds_no_moment": _sphere_holds_no_moment,
    "unconstrained_ball": marked(
        "This raceway control cannot hold a ball that a race loads too lightly to bear its"
        ' gyroscopic moment. Choose `model.cage` = "loose", `model.raceway_control` = "jones" or'
        ' "outer", or more axial load.'
    ),
    "friction_without_balance": marked(
        "Under friction alone the forces balance, but a ball is in an impossible position or the"
        " power balance does not close, so there is no result to show. Change slightly the load,"
        " the speed or `lubricant.friction_coefficient`, choose the other `model.mesh`, more load"
        ' or less `model.cage_drag`; raceway_control = "jones" gives similar loads and angles.'
    ),
    "friction_not_converged": marked(
        "Under friction alone the solver stopped at a residual of {residual:.1e} of the loads, so"
        " there is no result to show. Change slightly the load, the speed or"
        " `lubricant.friction_coefficient`, choose the other `model.mesh`, more load or less"
        ' `model.cage_drag`; raceway_control = "jones" gives similar loads and angles.'
    ),
    "counter_rotation": marked(
        "Between counter-rotating rings the balls may orbit so slowly that the gyroscopic moment"
        " overturns a lightly loaded one: raceway control then has no unique equilibrium. Add axial"
        " load, or change the ratio of the speeds."
    ),
    "inner_control": marked(
        "Under inner raceway control a ball on which the inner ring hardly presses may have several"
        " equilibria or none. The solver stopped at a residual of {residual:.1e} of the loads, so"
        ' there is no result to show. Choose `model.raceway_control` = "jones" or "outer", or add'
        " axial load."
    ),
    "not_converged": marked(
        "The solver stopped at a residual of {residual:.1e} of the loads, above {tolerance:.0e}, so"
        " there is no result to show. Change a load or the speed slightly, hold the tilts, or"
        " approach the duty in steps; and please report the case."
    ),
    "unsupported": _unsupported,
    "unsupported_one_sided": _unsupported_one_sided,
    "unsupported_axially": marked(
        "Nothing supports the inner ring toward -x: an angular contact bearing carries axial load"
        " toward +x only, and a radial load needs an accompanying axial load (about F_r tan α)."
        " Reverse the load, add axial preload (`duty.load.fx`), or hold the ring with"
        " `duty.displacement.x`."
    ),
    "unsupported_tandem": marked(
        "Nothing supports the inner ring toward {away}: all rows carry axial load toward {toward}"
        " only, and a radial load needs an accompanying axial load in every row (about F_r"
        " tan α). Reverse the load, add axial load (`duty.load.fx`), choose an"
        ' arrangement with opposed rows, such as "DB", or hold the ring with `duty.displacement.x`.'
    ),
    "shoulder_lost": marked(
        "The inner ring moves so far that balls of a row would have to bear on the shoulder that an"
        " angular contact bearing does not have. More preload or less clearance"
        " (`bearing.preload`), a smaller axial load or moment, or rings held against tilting"
        " keep them in their groove."
    ),
    "springs_overcome": marked(
        "Nothing supports the inner ring toward -x: an axial load of {load:.4 N} pushes back the"
        " springs, which press with {spring:.4 N}. Choose springs stronger than the load, clamp the"
        " rings (`bearing.preload.force`), or reverse the load or the set: toward +x the rows that"
        " face + carry it without the springs."
    ),
    "springs_weak": marked(
        "Springs of {spring:.4 N} do not keep the balls of every row in place: in each row a radial"
        " load needs an accompanying axial load (about F_r tan α), and a moment needs"
        " more. Choose stronger springs, clamp the rings (`bearing.preload.force`), reduce the"
        " radial load or the moment, or hold the tilts."
    ),
}
