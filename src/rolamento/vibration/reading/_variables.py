"""Files that hold named arrays: which of them are channels, and which are numbers about them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from math import pi, prod
from typing import Final, NamedTuple

from rolamento.errors import FileError
from rolamento.vibration.reading._channel import Channel
from rolamento.vibration.reading._metadata import (
    RateClaims,
    label_parts,
    positive,
    rate_of,
    rates_among,
    short_name,
    speed_among,
    time_scale,
    unit_among,
)
from rolamento.vibration.reading._units import quantity_of_unit

__all__ = ["MOST_VARIABLES", "Column", "Place", "Times", "Variable", "check_shape", "columns_of"]

MOST_VARIABLES: Final = 10_000
_MOST_COLUMNS: Final = 64
"""Of a matrix whose columns, or rows, are channels."""


@dataclass(frozen=True, slots=True)
class Variable:
    """An array of real numbers in a file.

    Attributes
    ----------
    name
        with dots or strokes before it where the file has structures or groups
    shape
        of the array
    value
        of an array of one number; None of others
    numbers, texts
        what the file says of it
    """

    name: str
    shape: tuple[int, ...]
    value: float | None = None
    numbers: Mapping[str, float] = field(default_factory=dict)
    texts: Mapping[str, str] = field(default_factory=dict)


class Place(NamedTuple):
    """A row or column of a variable.

    Attributes
    ----------
    variable
        its number
    row
        number of the row or column of a matrix
    axis
        along which the samples run
    """

    variable: int
    row: int
    axis: int


class Times(NamedTuple):
    """An array of times.

    Attributes
    ----------
    place
        where it lies
    scale
        seconds in its unit
    """

    place: Place
    scale: float


@dataclass(frozen=True, slots=True)
class Column:
    """A channel and where its samples lie, their times if the file has them, and its rates."""

    channel: Channel
    place: Place
    times: Times | None
    rates: RateClaims


def columns_of(variables: Sequence[Variable]) -> Iterator[Column]:
    """Channels among the variables: rows, columns, and matrices much longer than wide.

    Single numbers are read by their name: a sampling rate of all channels in the same group or
    structure, or a speed such as `X097RPM` of the channels that begin with `X097`. An array of
    times beside channels of its length is none itself.
    """
    singles = {v.name: v.value for v in variables if v.value is not None}
    within: dict[str, dict[str, float]] = {"": {}, **{_group(v.name): {} for v in variables}}
    for name, value in singles.items():
        group = _group(name)
        within[group][name[len(group) + 1 if group else 0 :]] = value
    rates = {group: rates_among((numbers, within[""])) for group, numbers in within.items()}
    speeds = _Speeds(singles)
    shafts = {group: speed_among(numbers) for group, numbers in within.items()}
    layouts = [_layout(variable.shape) for variable in variables]
    times = _times_of(variables, layouts)
    stamps = {found.place.variable for found in times.values()}
    for number, (variable, layout) in enumerate(zip(variables, layouts, strict=True)):
        if layout is None or number in stamps:
            continue
        axis, columns = layout
        group = _group(variable.name)
        unit = unit_among(variable.texts)
        claims = rates[group]
        if variable.numbers:
            claims = rates_among((variable.numbers, within[group], within[""]))
        rate = rate_of(claims)
        by_name = (speed_among(variable.numbers), shafts[group], speeds.of(variable.name))
        speed = next((found for found in by_name if found is not None), shafts[""])
        for row in range(columns):
            name = short_name(variable.name) + (f"[{row + 1}]" if columns > 1 else "")
            channel = Channel(
                name,
                variable.shape[axis],
                rate.value,
                unit,
                quantity_of_unit(unit),
                speed,
                rate.doubt,
                rate.aside,
            )
            yield Column(channel, Place(number, row, axis), times.get(number), claims)


def check_shape(shape: Sequence[int], item_size: int, size: int, source: str) -> None:
    """Refuse an array that declares more, or fewer, bytes than there are.

    Raises
    ------
    FileError
        If it does.
    """
    if any(length < 0 for length in shape) or prod(shape) * item_size > size:
        raise FileError(
            f"is cut off or damaged: an array of the shape {tuple(shape)} does not fit into it",
            source=source,
        )


def _times_of(
    variables: Sequence[Variable], layouts: Sequence[tuple[int, int] | None]
) -> dict[int, Times]:
    """Times of the variables that have them, by number: of the same group, or from the top."""
    lengths = [
        0 if layout is None else variables[n].shape[layout[0]] for n, layout in enumerate(layouts)
    ]
    stamps: dict[tuple[str, int], Times] = {}
    named: set[int] = set()
    for number, (variable, layout) in enumerate(zip(variables, layouts, strict=True)):
        scale = _scale_of_times(variable)
        if scale is not None and layout is not None and layout[1] == 1:
            named.add(number)
            place = Place(number, 0, layout[0])
            stamps.setdefault((_group(variable.name), lengths[number]), Times(place, scale))
    found = {}
    for number, variable in enumerate(variables):
        if number not in named and lengths[number]:
            keys = [(group, lengths[number]) for group in (_group(variable.name), "")]
            times = next((stamps[key] for key in keys if key in stamps), None)
            if times is not None:
                found[number] = times
    return found


def _scale_of_times(variable: Variable) -> float | None:
    """Seconds in the unit of a variable, if its name is that of times."""
    cut = len(_group(variable.name))
    name, unit = label_parts(variable.name[cut:].lstrip("./"))
    return time_scale(name, unit_among(variable.texts) or unit)


class _Speeds:
    """Speeds of the shaft among the single numbers, by what stands before RPM in their names."""

    def __init__(self, singles: Mapping[str, float]) -> None:
        self._by_prefix = {
            name[:-3].rstrip("_ ."): value * pi / 30.0
            for name, value in singles.items()
            if name.lower().endswith("rpm") and positive(abs(value))
        }

    def of(self, name: str) -> float | None:
        """Return the speed with the longest prefix that a channel's name begins with."""
        fitting = [prefix for prefix in self._by_prefix if name.startswith(prefix)]
        return self._by_prefix[max(fitting, key=len)] if fitting else None


def _layout(shape: Sequence[int]) -> tuple[int, int] | None:
    """Axis of the samples and number of channels; None of what is no channel."""
    if len(shape) == 1:
        return (0, 1) if shape[0] != 1 else None
    if len(shape) != 2 or max(shape) <= 1:
        return None
    axis = 0 if shape[0] >= shape[1] else 1
    columns = shape[1 - axis]
    return (axis, columns) if 1 <= columns <= _MOST_COLUMNS else None


def _group(name: str) -> str:
    """What stands before the last dot or stroke of a name."""
    return name[: max(name.rfind("."), name.rfind("/"), 0)]
