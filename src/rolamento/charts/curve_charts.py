"""An output of a case, or of two, over one of its fields, with the present points on it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Final, Literal

import numpy as np
from numpy.typing import NDArray

from rolamento.charts.axes_units import ReadableUnit, read_values, readable_unit
from rolamento.charts.palette import Look, case_look
from rolamento.charts.record import Axis, Chart, Line, nothing
from rolamento.charts.texts import capitalised, no_result_count, number
from rolamento.words import said
from rolamento.words.reasons import reason

if TYPE_CHECKING:
    from rolamento.tasks.curve import Curve

__all__ = ["curve_chart"]

Floats = NDArray[np.float64]
Scale = Literal["linear", "log"]

_NAMES: Final = "AB"


def curve_chart(
    curves: Sequence[Curve], *, scale: Scale = "linear", upright: Scale = "linear"
) -> Chart:
    """Return the chart of one curve, or of two of the same field and output.

    Parameters
    ----------
    curves
        What `rolamento.tasks.curve.curve_over` gives.
    scale
        Of the field.
    upright
        Of the output; where it is not positive throughout, a linear one.
    """
    field, output = curves[0].field, curves[0].output
    every = np.concatenate([one.numbers for one in curves])
    if not np.isfinite(every).any():
        return nothing("\n".join(dict.fromkeys(_why(curves))))
    unit = readable_unit(output.unit, every, output.name)
    x, symbol = read_values(field, np.concatenate([one.values for one in curves]))
    along, name = capitalised(field.label), capitalised(output.label)
    logarithmic = upright == "log" and not np.any(every <= 0.0)
    series: list[Line] = []
    told = []
    begins = np.cumsum([0, *(len(one.values) for one in curves)])
    for place, one in enumerate(curves):
        own = x[begins[place] : begins[place + 1]]
        series += _one_curve(one, place, own, unit, many=len(curves) > 1)
        told += _present(one, place, own, (symbol, unit), many=len(curves) > 1)
    low, high = float(x.min()), float(x.max())
    return Chart(
        tuple(series),
        Axis(along, symbol, (low, high), log=scale == "log" and low > 0.0),
        Axis(name, unit.symbol, log=logarithmic),
        "; ".join(told) or said("{what} over {field}.", what=name, field=along),
    )


def _one_curve(one: Curve, place: int, x: Floats, unit: ReadableUnit, *, many: bool) -> list[Line]:
    """Return the curve, where it has no number, and the case itself."""
    case = said("case {name}", name=_NAMES[place]) if many else said("this case")
    look, y, missing = case_look(place), unit.of(one.numbers), one.missing
    lines = [Line(x, y, case if many else capitalised(one.output.label), look)]
    if missing.any():
        count = int(missing.sum())
        why = tuple(reason(str(code)) for code in one.status[missing])
        name = no_result_count(count, len(missing))
        lines.append(
            Line(x[missing], np.zeros(count), name, Look("bad", mark="thin"), "points", height=0.0,
                 texts=why)
        )  # fmt: skip
    if one.present is not None and not missing[one.present]:
        at = slice(one.present, one.present + 1)
        name = said("now, {case}", case=case) if many else said("this case")
        lines.append(Line(x[at], y[at], name, replace(look, width=1.4), "points"))
    return lines


def _present(
    one: Curve, place: int, x: Floats, units: tuple[str, ReadableUnit], *, many: bool
) -> list[str]:
    """Say what the case itself has."""
    if one.present is None or one.missing[one.present]:
        return []
    symbol, unit = units
    at, value = number(float(x[one.present])), number(float(unit.of(one.numbers[one.present])))
    told = said(
        "{output} {value} at {field} {at}",
        output=capitalised(one.output.label),
        value=Axis(unit=unit.symbol).with_unit(value),
        field=one.field.label,
        at=Axis(unit=symbol).with_unit(at),
    )
    return [said("{case}: {what}", case=_NAMES[place], what=told) if many else told]


def _why(curves: Sequence[Curve]) -> Iterable[str]:
    for one in curves:
        yield no_result_count(int(one.missing.sum()), len(one.values))
        for code in dict.fromkeys(one.status[one.missing].tolist()):
            yield reason(code)
        yield from (note.text for note in one.reasons[:1])
