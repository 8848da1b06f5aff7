"""The app's curve: an output of one case or two over a field, with the present points on it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Final, get_args

import numpy as np

from rolamento.case import Case
from rolamento.case.fields import changed
from rolamento.errors import InputError
from rolamento.plots.axes_units import NONE, ReadableUnit, read_values, readable_unit
from rolamento.plots.texts import capitalised, no_result_count, number
from rolamento.tasks.curve import Curve, Scale, curve_over, fields_over, outputs_over
from rolamento.web.drawing import (
    NUMBER,
    Picture,
    axis,
    decades,
    empty,
    line,
    numbers,
    picture,
    reach,
)
from rolamento.words import said
from rolamento.words.reasons import reason

__all__ = ["MOST_CASES", "curve", "picture_of"]

MOST_CASES: Final = 2
_NAMES: Final = "AB"
_COLORS: Final = (("inner", "solid"), ("inner2", "dashdot"))


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
    if given not in get_args(Scale):
        raise InputError(
            said("must be one of {known}", known=", ".join(get_args(Scale))),
            field=name,
            value=str(given)[:100],
        )
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
    field, output = curves[0].field, curves[0].output
    every = np.concatenate([one.numbers for one in curves])
    if not np.isfinite(every).any():
        return empty("\n".join(dict.fromkeys(_why(curves))))
    unit = readable_unit(output.unit, every, output.name)
    name = capitalised(output.label)
    title = name if unit.symbol == NONE.symbol else unit.label(name)
    x_all, symbol = read_values(field, np.concatenate([one.values for one in curves]))
    along = capitalised(field.label)
    x_title = along if symbol == NONE.symbol else f"{along} ({symbol})"
    logarithmic = upright == "log" and not np.any(every <= 0.0)
    limits = decades(unit.of(every)) if logarithmic else reach(unit.of(every))
    assert limits is not None
    foot = 10.0 ** limits[0] if logarithmic else limits[0]
    hover = f"%{{x:{NUMBER}}} {symbol}, %{{y:{NUMBER}}} {unit.symbol}".replace(NONE.symbol, "")
    drawn: list[dict[str, Any]] = []
    told = []
    count = [len(one.values) for one in curves]
    begins = np.cumsum([0, *count])
    for place, one in enumerate(curves):
        x = x_all[begins[place] : begins[place + 1]]
        drawn += _one_curve(one, place, x, unit, hover, foot, many=len(curves) > 1)
        told += _present(one, place, x, (symbol, unit), many=len(curves) > 1)
    span = [float(x_all.min()), float(x_all.max())]
    if scale == "log" and span[0] > 0.0:
        across = axis(x_title, np.log10(span).tolist(), type="log")
    else:
        across = axis(x_title, span)
    return picture(
        drawn,
        "; ".join(told) or said("{what} over {field}.", what=name, field=along),
        xaxis=across,
        yaxis=axis(title, limits, **({"type": "log"} if logarithmic else {})),
    )


def _one_curve(
    one: Curve,
    place: int,
    x: np.ndarray[Any, Any],
    unit: ReadableUnit,
    hover: str,
    foot: float,
    *,
    many: bool,
) -> list[dict[str, Any]]:
    color, dash = _COLORS[place]
    case = said("case {name}", name=_NAMES[place]) if many else said("this case")
    curve = line(x, unit.of(one.numbers), capitalised(one.output.label) if not many else case,
                 hover, line={"color": color, "dash": dash, "width": 2})  # fmt: skip
    drawn = [curve]
    missing = one.missing
    if missing.any():
        why = [reason(str(code)) for code in one.status[missing]]
        drawn.append(
            {
                "type": "scatter",
                "mode": "markers",
                "x": numbers(x[missing]),
                "y": [foot] * int(missing.sum()),
                "text": why,
                "meta": {"told": True},
                "name": no_result_count(int(missing.sum()), len(missing)),
                "hovertemplate": f"%{{x:{NUMBER}}}: %{{text}}<extra></extra>",
                "marker": {"color": "bad", "symbol": "x-thin-open", "size": 8},
                "cliponaxis": False,
            }
        )
    if one.present is not None and not missing[one.present]:
        at = slice(one.present, one.present + 1)
        drawn.append(
            {
                "type": "scatter",
                "mode": "markers",
                "x": numbers(x[at]),
                "y": numbers(unit.of(one.numbers[at])),
                "name": said("now, {case}", case=case) if many else said("this case"),
                "hovertemplate": f"{hover}<extra>%{{fullData.name}}</extra>",
                "marker": {"color": color, "size": 11, "symbol": "diamond" if place else "circle",
                           "line": {"color": "ink", "width": 1.5}},
                "cliponaxis": False,
            }
        )  # fmt: skip
    return drawn


def _present(
    one: Curve, place: int, x: np.ndarray[Any, Any], units: tuple[str, ReadableUnit], *, many: bool
) -> list[str]:
    """Say what the case itself has."""
    if one.present is None or one.missing[one.present]:
        return []
    symbol, unit = units
    at, value = number(float(x[one.present])), number(float(unit.of(one.numbers[one.present])))
    told = said(
        "{output} {value} at {field} {at}",
        output=capitalised(one.output.label),
        value=_with(value, unit.symbol),
        field=one.field.label,
        at=_with(at, symbol),
    )
    return [said("{case}: {what}", case=_NAMES[place], what=told) if many else told]


def _with(text: str, symbol: str) -> str:
    return text if symbol == NONE.symbol else f"{text} {symbol}"


def _why(curves: Sequence[Curve]) -> Iterable[str]:
    for one in curves:
        yield no_result_count(int(one.missing.sum()), len(one.values))
        for code in dict.fromkeys(one.status[one.missing].tolist()):
            yield reason(code)
        yield from (note.text for note in one.reasons[:1])
