"""What is said of rollers: their notes, and the advice where they have no result."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from rolamento.words.sentences import Sentence
from rolamento.words.sentences.solved import direction, race_of, where_of
from rolamento.words.speaking import counted, marked, said

__all__ = ["SENTENCES"]

Values = Mapping[str, Any]


def _count(values: Values) -> int:
    return len(values["rollers"])


def _rollers(values: Values) -> str:
    return counted("{n} roller", "{n} rollers", _count(values))


def _rollers_unloaded(values: Values) -> str:
    n, where = _count(values), where_of(values)
    if values["pressed_outward"]:
        return counted(
            "{n} roller without inner contact ({where}): only centrifugal force presses it against"
            " the outer race.",
            "{n} rollers without inner contact ({where}): only centrifugal force presses them"
            " against the outer race.",
            n, where=where,
        )  # fmt: skip
    return counted(
        "{n} roller without inner contact ({where}): it carries no load.",
        "{n} rollers without inner contact ({where}): they carry no load.",
        n, where=where,
    )  # fmt: skip


def _line_pressure_high(values: Values) -> str:
    return said(
        "The contact pressure at the {race} race reaches {max_pressure:.0f MPa}, above"
        " {limit:.0f MPa} (ISO 76), at which rollers begin to indent the raceway permanently:"
        " {rollers} ({where}).",
        rollers=_rollers(values),
        race=race_of(values),
        where=where_of(values),
        max_pressure=values["max_pressure"],
        limit=values["limit"],
    )


def _edge_pressure_peak(values: Values) -> str:
    numbers = {
        "rollers": _rollers(values),
        "race": race_of(values),
        "where": where_of(values),
        "max_pressure": values["max_pressure"],
    }
    if values["ratio"] is None:
        return said(
            "The pressure at the {race} race peaks at the end of {rollers} ({where}): up to"
            " {max_pressure:.0f MPa}, while the middle bears nothing. Less tilt, or a profile that"
            " drops more toward the ends, lowers the peak.",
            **numbers,
        )
    return said(
        "The pressure at the {race} race peaks at the end of {rollers} ({where}): up to"
        " {max_pressure:.0f MPa}, {ratio:.2f} times that in the middle. Less tilt, or a profile"
        " that drops more toward the ends, lowers the peak.",
        ratio=values["ratio"],
        **numbers,
    )


def _edges_bear(values: Values) -> str:
    if values.get("barrels"):
        return said(
            "The ends of {rollers} bear their share at the {race} race ({where}):"
            " {max_pressure:.0f MPa} at the outermost slices. Slices do not show the peak of"
            " pressure at an edge.",
            rollers=_rollers(values),
            race=race_of(values),
            where=where_of(values),
            max_pressure=values["max_pressure"],
        )
    return said(
        "The ends of {rollers} bear their share at the {race} race ({where}):"
        " {max_pressure:.0f MPa} at the outermost slices. Independent slices do not show the peak"
        ' of pressure at an edge; `model.roller_contact` = "coupled" does.',
        rollers=_rollers(values),
        race=race_of(values),
        where=where_of(values),
        max_pressure=values["max_pressure"],
    )


def _rollers_misaligned(values: Values) -> str:
    numbers = {"tilt": values["tilt"], "limit": values["limit"]}
    if "of_wide" in values:
        return said(
            "The rings are tilted against each other by {tilt:.2f mrad}: makers permit about"
            " {limit:.1f mrad} of most bearings of this type under normal loads, and"
            " {of_wide:.1f mrad} of wide ones. The skew of the rollers that tilt causes is not"
            " modelled.",
            of_wide=values["of_wide"],
            **numbers,
        )
    return said(
        "The rings are tilted against each other by {tilt:.2f mrad}: makers permit about"
        " {limit:.1f mrad} of most bearings of this type under normal loads. The skew of the"
        " rollers that tilt causes is not modelled.",
        **numbers,
    )


def _rollers_unsupported(values: Values) -> str:
    return said(
        "Nothing supports the inner ring {direction}: the rollers never come to carry the load."
        " Apply a smaller load, or hold this degree of freedom with a displacement.",
        direction=direction(values["axis"]),
    )


def _row_of_elements_unloaded(values: Values) -> str:
    n, rows = len(values["rows"]), values["rows"]
    if values["preloaded"]:
        return counted(
            "Nothing in row {rows} contacts the inner ring: the row has lost its preload, and the"
            " rest of the set carries the whole load.",
            "Nothing in rows {rows} contacts the inner ring: these rows have lost their preload,"
            " and the rest of the set carries the whole load.",
            n, rows=rows,
        )  # fmt: skip
    return counted(
        "Nothing in row {rows} contacts the inner ring: no preload holds the row in contact, and"
        " the rest of the set carries the whole load.",
        "Nothing in rows {rows} contacts the inner ring: no preload holds these rows in contact,"
        " and the rest of the set carries the whole load.",
        n, rows=rows,
    )  # fmt: skip


SENTENCES: Final[dict[str, Sentence]] = {
    # notes
    "no_element_loaded": marked(
        "No rolling element contacts the inner ring: without load its position is indeterminate."
    ),
    "row_of_elements_unloaded": _row_of_elements_unloaded,
    "rollers_unloaded": _rollers_unloaded,
    "line_pressure_high": _line_pressure_high,
    "rollers_misaligned": _rollers_misaligned,
    "roller_on_part_of_its_length": marked(
        "The most loaded roller, at {azimuth:.4 °}, bears on {share:.0f %} of its effective length."
    ),
    "edge_pressure_peak": _edge_pressure_peak,
    "edges_bear": _edges_bear,
    "toroidal_under_axial_load": marked(
        "Toroidal roller bearings are not for axial load (SKF, CARB): {axial:.4 N} shift the inner"
        " ring by {shift:.3 mm} until the rollers wedge between the raceways. The equivalent load"
        " P = F_r does not include it. Let another bearing locate the shaft."
    ),
    "direction_unsupported_by_rollers": marked(
        "No rolling element supports the ring along {axis}: it carries no load there, and the"
        " displacement shown is arbitrary."
    ),
    # advice
    "overloaded_rollers": marked(
        "A roller would sink into its raceway by more than {limit:.0f %} of its diameter, far"
        " beyond any elastic contact: check the units of the loads and displacements."
    ),
    "ribs_do_not_hold": marked(
        "Nothing supports the inner ring along x: no pair of ribs carries this axial load (an NU or"
        " N carries none, an NJ toward +x only, an NUP both ways), and radial load alone gives"
        " cylindrical rollers no axial support. Take the axial load away (`duty.load.fx`), choose"
        " ribs that carry it (`bearing.inner_ribs`, `bearing.outer_ribs`), or hold the ring with"
        " `duty.displacement.x`."
    ),
    "tapered_unsupported_axially": marked(
        "Nothing supports the inner ring toward {away}: a tapered roller bearing carries axial load"
        " toward {toward} only, and a radial load needs an accompanying axial load (about"
        " F_r/(2 Y)). Reverse the load, add axial load (`duty.load.fx`), choose an arrangement with"
        ' opposed rows, such as "DB", or hold the ring with `duty.displacement.x`.'
    ),
    "tapered_free_to_tilt": marked(
        "A single row of tapered rollers hardly resists tilting, and the inner ring is free to tilt"
        " (my and mz are given): it turns out of the outer ring. With the rings held in line the"
        " axial load of {axial:.4 N} would do, for this radial load takes {needed:.4 N}"
        " (F_r tan α). Hold the tilt with `duty.displacement.ry` and `duty.displacement.rz`, as a"
        " stiff shaft on a second bearing does, or solve both bearings as a set."
    ),
    "rollers_unsupported": _rollers_unsupported,
}
