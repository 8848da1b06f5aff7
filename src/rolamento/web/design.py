"""Design questions of the page: what would help most, and which input gives an output its value."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from math import isfinite
from typing import Any, Final

import numpy as np

from rolamento.case import Case
from rolamento.case.fields import changed
from rolamento.case.labels import label_of
from rolamento.charts.axes_units import read_values, readable_unit
from rolamento.charts.plotly import picture
from rolamento.charts.texts import capitalised
from rolamento.document import Document
from rolamento.document.html import body
from rolamento.errors import InputError
from rolamento.life.sensitivity import CHANGES, holding_load, sensitivity
from rolamento.pages.across import read_text
from rolamento.pages.seek import seek_chart, seek_statement
from rolamento.pages.tolerance import distribution_chart, tolerance_summary
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.studies.fields import Field, read_field
from rolamento.tasks.curve import fields_over, outputs_over
from rolamento.tasks.report import number_of_field
from rolamento.tasks.seek import GoalSeek
from rolamento.tasks.studies import room_of, tolerance_of_case
from rolamento.words import language, said

__all__ = ["helps", "seek", "tolerance"]

_LOADS: Final = tuple(f"duty.load.{name}" for name in ("fx", "fy", "fz", "my", "mz"))
_TILTS: Final = ("duty.displacement.ry", "duty.displacement.rz")
_GRADE: Final = re.compile(r"ISO VG (\d+)$")
_GRADES: Final = (2, 3, 5, 7, 10, 15, 22, 32, 46, 68, 100, 150, 220, 320, 460, 680, 1000, 1500)
"""Grades of ISO 3448: each about 1.5 times as viscous as the one before."""
_USUAL_FIELDS: Final = (
    "bearing.preload.force", "bearing.diametral_clearance", "bearing.contact_angle",
    "duty.load.fz", "duty.load.fx", "duty.inner_speed", "temperature.lubricant",
)  # fmt: skip
_USUAL_OUTPUTS: Final = (
    "life_hours", "max_inner_max_pressure", "max_outer_max_pressure", "stiffness_xx",
    "stiffness_zz", "static_safety", "viscosity_ratio", "friction_torque", "preload_at_speed",
)  # fmt: skip

_SCATTERING: Final = (
    "bearing.preload.force", "bearing.diametral_clearance", "bearing.contact_angle",
    "bearing.inner_conformity", "bearing.outer_conformity", "duty.load.fz", "duty.load.fx",
    "temperature.inner_ring", "temperature.outer_ring", "temperature.lubricant",
)  # fmt: skip
_MOST_FIELDS: Final = 8


def helps(request: Mapping[str, Any]) -> dict[str, Any]:
    """Return what would make the life of a case longer, the most helpful first.

    Where there is no equilibrium, the axial load that gives it one.

    Parameters
    ----------
    request
        ``case``: tables as a file has them.

    Returns
    -------
    dict
        ``trials``: of each ``label``, ``times`` (life after it over life before), and ``changes``
        by field, as a file has them, with which the page tries it; none where no field says it.
    """
    tables = _tables(request)
    case = Case.from_mapping(tables)
    solved = solve(case)
    if not solved.converged[0]:
        return {"trials": list(_holding(tables, solved))}
    try:
        found = sensitivity(solved)
    except InputError:  # no life: nothing to make longer
        return {"trials": []}
    return {
        "trials": [
            {
                "name": one.name,
                "label": capitalised(one.note.text),
                "times": said("life × {times:.3}", times=one.life_ratio),
                "ratio": one.life_ratio,
                "changes": _valid(tables, dict(_changes(case, one.name))),
            }
            for one in found
            if isfinite(one.life_ratio)
        ]
    }


def _holding(tables: Mapping[str, Any], solved: Solved) -> Iterator[dict[str, Any]]:
    """The axial load that a bearing without an equilibrium lacks."""
    force = holding_load(solved)
    if force is not None:
        field = "duty.load.fx"
        text = read_field(field).written(force)
        yield {
            "name": "axial_load",
            "label": capitalised(
                said("{field} of {load:.2 kN}", field=label_of(field), load=force)
            ),
            "times": said("in equilibrium"),
            "ratio": None,
            "changes": _valid(tables, {field: text}),
        }


def _changes(case: Case, name: str) -> Iterator[tuple[str, Any]]:
    """What a change of `rolamento.life.sensitivity` writes into a case file, if fields say it."""
    size = CHANGES[name]
    if name in ("less_load", "less_tilt"):
        for field in _LOADS if name == "less_load" else _TILTS:
            own = number_of_field(case, field)
            if own:
                yield field, read_field(field).written((1.0 + size) * own)
    elif name in ("less_clearance", "more_clearance"):
        field = "bearing.diametral_clearance"
        own = number_of_field(case, field)
        if own is not None and case.mounting is None:
            yield field, read_field(field).written(own + size)
    elif name == "profiled_rollers":
        yield "bearing.roller_profile.kind", "iso"
    elif name == "thicker_oil" and case.lubricant is not None:
        base = case.lubricant.base_oil
        match = _GRADE.match(base or str(case.lubricant.name))
        thicker = [one for one in _GRADES if match and one > int(match[1])]
        if thicker:
            field = "lubricant" if base is None else "lubricant.base_oil"
            yield field, f"ISO VG {thicker[0]}"
    elif name == "cleaner_oil" and case.life is not None and case.life.contamination is not None:
        yield "life.contamination", min(float(case.life.contamination) + size, 1.0)


def _valid(tables: Mapping[str, Any], changes: dict[str, Any]) -> dict[str, Any]:
    """The changes where the case takes them; none else."""
    try:
        Case.from_mapping(changed(tables, changes, Case, in_file=True))
    except InputError:
        return {}
    return changes


def seek(request: Mapping[str, Any]) -> dict[str, Any]:
    """Return which value of a field gives an output the value that is wanted, with its curve.

    Parameters
    ----------
    request
        ``case``: tables; ``vary``: a field, ``output``, and ``wanted``: the value, as people write
        it with its unit. Without ``wanted`` only what there is to choose from is returned.

    Returns
    -------
    dict
        ``fields`` and ``outputs`` to choose from, each with ``usual``; with ``wanted`` also
        ``statement``, ``found`` (``text``, and ``value`` as a file has it) and ``picture``.
    """
    case = Case.from_mapping(_tables(request))
    fields, outputs = fields_over(case), outputs_over(case)
    vary, output = (_text(request, name) for name in ("vary", "output"))
    answer: dict[str, Any] = {
        "fields": _offered(fields, _USUAL_FIELDS),
        "outputs": _offered(outputs, _USUAL_OUTPUTS),
    }
    wanted = _text(request, "wanted")
    if not wanted:
        return answer
    found = GoalSeek(case=case, vary=vary, wanted=f"{output}={wanted}").run()
    return {
        **answer,
        "statement": seek_statement(found),
        "good": bool(found.found),
        "field": found.field.name,
        "found": [
            {
                "text": read_text(found.field, np.append(found.curve.values, at), at),
                "value": found.field.written(at),
            }
            for at in found.found
        ],
        "picture": {**picture(seek_chart(found))},
    }


def tolerance(request: Mapping[str, Any]) -> dict[str, Any]:
    """Return what the results of a case come to when some of its fields scatter.

    Parameters
    ----------
    request
        ``case``: tables; ``scatter``: by field, up to eight, by how much to either side, SI;
        ``output``: of which the distribution is drawn. Without ``scatter`` only what there is to
        choose from is returned.

    Returns
    -------
    dict
        ``fields`` to choose from, each with the greatest tolerance ``most``, SI, its ``unit`` as
        people read it and how much that is, ``factor``; ``outputs``; with ``scatter`` also
        ``table`` of all outputs and ``picture`` of one.
    """
    case = Case.from_mapping(_tables(request))
    known = [(one, room_of(case, one)) for one in fields_over(case)]
    rooms = {one.name: room for one, room in known if room > 0.0}
    outputs = [one for one in outputs_over(case) if one.name in _USUAL_OUTPUTS]
    output = _text(request, "output")
    offered = _offered([one for one, room in known if room > 0.0], _SCATTERING)
    answer: dict[str, Any] = {
        "fields": [
            {**one, "most": rooms[one["name"]], **_read_by(case, read_field(one["name"]))}
            for one in offered
        ],
        "outputs": _offered(outputs, _USUAL_OUTPUTS),
    }
    scatter = request.get("scatter")
    if not scatter:
        return answer
    names = [one["name"] for one in answer["outputs"]]
    found = tolerance_of_case(case, _deviations(scatter), names)
    shown = output if output in names else names[0]
    return {
        **answer,
        "output": shown,
        "table": body(Document("", (tolerance_summary(found),), kind="live", language=language())),
        "picture": {**picture(distribution_chart(found, shown))},
    }


def _deviations(scatter: Any) -> dict[str, float]:
    if not isinstance(scatter, Mapping) or len(scatter) > _MOST_FIELDS:
        raise InputError(
            said("must be a table of at most {most} fields", most=_MOST_FIELDS), field="scatter"
        )
    for name, size in scatter.items():
        if isinstance(size, bool) or not isinstance(size, int | float):
            raise InputError(said("must be a number"), field=f"scatter.{name}", value=size)
    return {str(name): float(size) for name, size in scatter.items()}


def _read_by(case: Case, field: Field) -> dict[str, Any]:
    """The unit in which a tolerance of a field is read, and what one of it is in SI."""
    own, room = number_of_field(case, field.name) or 0.0, room_of(case, field)
    shown, symbol = read_values(field, np.array([own, own + 0.2 * room]))
    if field.dimension == "temperature":
        return {"unit": "K", "factor": 1.0}
    return {"unit": "" if symbol == "–" else symbol, "factor": 0.2 * room / float(np.ptp(shown))}


def _offered(known: list[Any], usual: tuple[str, ...]) -> list[dict[str, Any]]:
    """What may be chosen, the usual ones first."""
    order = {name: place for place, name in enumerate(usual)}
    ranked = sorted(known, key=lambda one: order.get(one.name, len(order)))
    return [
        {
            "name": one.name,
            "label": capitalised(one.label),
            "unit": _unit(one),
            "usual": one.name in order,
        }
        for one in ranked
    ]


def _unit(one: Any) -> str:
    """The unit in which people write a value of an output; of a field nothing is asked."""
    unit = getattr(one, "unit", "")
    return "" if unit in ("", "1", "-") else readable_unit(unit, np.ones(1), one.name).symbol


def _tables(request: Mapping[str, Any]) -> Mapping[str, Any]:
    found = request.get("case")
    if not isinstance(found, Mapping):
        raise InputError(said("must be a table"), field="case", example='{"bearing": {}}')
    return found


def _text(request: Mapping[str, Any], name: str) -> str:
    given = request.get(name) or ""
    if not isinstance(given, str):
        raise InputError(said("must be text"), field=name, value=str(given)[:100])
    return given.strip()[:200]
