"""The app's curve: an output of one case or two over a field, with the present points on it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Final, get_args

from rolamento.case import Case
from rolamento.case.fields import changed
from rolamento.charts.curve_charts import curve_chart
from rolamento.charts.plotly import Picture, picture
from rolamento.charts.texts import capitalised
from rolamento.errors import InputError
from rolamento.tasks.curve import Curve, Scale, curve_over, fields_over, outputs_over
from rolamento.validate import one_of
from rolamento.words import said

__all__ = ["MOST_CASES", "curve", "picture_of"]

MOST_CASES: Final = 2


def curve(request: Mapping[str, Any]) -> dict[str, Any]:
    """Return the curve that the page asks for, and what else it may ask for.

    Parameters
    ----------
    request
        ``cases``: one or two of ``{"case": tables, "changes": {field: value}}``, or ``case``:
        tables; ``field``, ``output``: names, by default those offered first; ``low``, ``high``:
        as a case file has them, by default around the present value; ``scale`` of the field and
        ``upright`` of the output: "linear" or "log".

    Returns
    -------
    dict
        A `Picture` with ``field``, ``output``, ``low``, ``high`` (as a file has them), and
        ``fields`` and ``outputs`` to choose from: ``{"name", "label"}``.

    Raises
    ------
    InputError
        If it is no such request, a case is wrong, or there is no such curve.
    """
    cases = list(_cases(request))
    fields, outputs = fields_over(cases[0]), outputs_over(cases[0])
    field = _text(request, "field") or _first([one.name for one in fields], _FIELDS)
    output = _text(request, "output") or _first([one.name for one in outputs], _OUTPUTS)
    scale, upright = (_scale(request, name) for name in ("scale", "upright"))
    ends = request.get("low"), request.get("high")
    first = curve_over(cases[0], field, output, *ends, scale=scale)
    known = first.field
    low, high = (known.written(float(first.values[place])) for place in (0, -1))
    found = [first, *(curve_over(case, field, output, low, high, scale=scale)
                      for case in cases[1:])]  # fmt: skip
    return {
        **picture_of(found, scale=scale, upright=upright),
        "field": field,
        "output": output,
        "low": low,
        "high": high,
        "fields": [{"name": one.name, "label": capitalised(one.label)} for one in fields],
        "outputs": [{"name": one.name, "label": capitalised(one.label)} for one in outputs],
    }


_FIELDS: Final = ("duty.load.fz", "duty.load.fx", "duty.inner_speed")
_OUTPUTS: Final = ("life_hours", "max_inner_max_pressure", "max_inner_load")


def _first(known: Sequence[str], preferred: Sequence[str]) -> str:
    return next((name for name in preferred if name in known), known[0])


def _text(request: Mapping[str, Any], name: str) -> str:
    given = request.get(name) or ""
    if not isinstance(given, str):
        raise InputError(said("must be text"), field=name, value=str(given)[:100])
    return given


def _scale(request: Mapping[str, Any], name: str) -> Scale:
    given = request.get(name) or "linear"
    one_of(str(given)[:100], name, get_args(Scale))
    return "log" if given == "log" else "linear"


def _cases(request: Mapping[str, Any]) -> Iterable[Case]:
    entries = request.get("cases") or [{"case": request.get("case")}]
    if not isinstance(entries, list) or not 1 <= len(entries) <= MOST_CASES:
        raise InputError(said("must be a list of 1 to {most} cases", most=MOST_CASES),
                         field="cases")  # fmt: skip
    for entry in entries:
        mapping: Any = entry.get("case") if isinstance(entry, Mapping) else None
        changes: Any = entry.get("changes") or {} if isinstance(entry, Mapping) else None
        if not isinstance(mapping, Mapping) or not isinstance(changes, Mapping):
            raise InputError(
                said("must have the tables of a case, and may have changes"), field="cases"
            )
        yield Case.from_mapping(changed(mapping, changes, Case, in_file=True))


def picture_of(
    curves: Sequence[Curve], *, scale: Scale = "linear", upright: Scale = "linear"
) -> Picture:
    """Return the picture of one curve, or of two of the same field and output.

    upright: the scale of the output; where it is not positive throughout, a linear one.
    """
    return picture(curve_chart(curves, scale=scale, upright=upright))
