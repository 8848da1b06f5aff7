"""NSK's life L_able = a_1 a_NSK L_10: what can be had without the maker's charts.

a_NSK is published as curves over (P - P_u)/(C a_c) at some κ, and not as numbers. None are made up
here. There are three ways instead:

- a table that the user reads off the maker's chart, interpolated and never continued;
- a_ISO with e_C = a_c, a stand-in that is named as such;
- the structure behind the curves: the risk below the surface, with a fatigue limit, over a factor
  f ≤ 1 of contamination and lubrication. Of that risk, (1/f - 1) comes from the surface; f follows
  from one known a_NSK.

The maker refuses P > 0.5 C, P > C_0, less than 20 r/min and more than 130 °C, and so does this.

Source: Takemura, Matsumoto and Murakami (2000), as in Campanha (2008), eqs. 2.6.8, 2.6.9 and
table 2.6.3.
"""

from __future__ import annotations

import os
from math import isfinite
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import FileError, InputError
from rolamento.life.iso281 import load_notes
from rolamento.life.iso281_modified import life_modification_factor
from rolamento.life.iso16281 import SLOPE
from rolamento.life.theory import (
    OF_BEARING,
    OF_EQUIVALENT_LOAD,
    VISCOSITY_RATIO,
    Need,
    Theory,
)
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.validate import numbers, positive
from rolamento.words import marked, said

if TYPE_CHECKING:
    from rolamento.life.basis import Basis
    from rolamento.life.record import Life

CLEANLINESS: Final = {
    "very_clean": (1.0, 1.0),
    "clean": (0.8, 0.8),
    "normal": (0.5, 0.5),
    "contaminated": (0.1, 0.4),
    "very_contaminated": (0.05, 0.05),
}
"""a_c by word, least and most: filters to 10, 30, 100 µm, coarser, none. Campanha, table 2.6.3."""
MINIMUM_SPEED: Final = 20.0
"""r/min."""
MAXIMUM_TEMPERATURE: Final = 130.0 + 273.15
"""K."""
_MAXIMUM_POINTS: Final = 10_000
_MAXIMUM_ROWS: Final = 1000
_NAMES: Final = {
    "viscosity_ratio": marked("κ of the rows"),
    "load_parameter": marked("load parameters of the header"),
    "factor": "a_NSK",
}
_EXAMPLE: Final = "kappa,0.01,0.05,0.2"


@frozen(eq=False)
class FactorTable:
    """a_NSK as a user reads it off the maker's chart.

    Attributes
    ----------
    viscosity_ratio
        κ of the curves, rising
    load_parameter
        (P - P_u)/(C a_c) of the readings, rising, above 0
    factor
        a_NSK, (κ, load parameters), above 0

    Raises
    ------
    InputError
        If the arrays do not fit together, or a number is not above 0.
    """

    viscosity_ratio: FloatArray
    load_parameter: FloatArray
    factor: FloatArray

    def __post_init__(self) -> None:
        for name in ("viscosity_ratio", "load_parameter", "factor"):
            array = np.array(positive(getattr(self, name), name))
            if not np.all(np.isfinite(array)) or array.size > _MAXIMUM_POINTS:
                raise InputError(
                    said("must be at most {most} finite numbers", most=_MAXIMUM_POINTS),
                    field=name,
                )
            object.__setattr__(self, name, array)
        for name in ("viscosity_ratio", "load_parameter"):
            axis = getattr(self, name)
            if axis.ndim != 1 or axis.size < 2 or not np.all(np.diff(axis) > 0.0):
                raise InputError(said("must be at least two increasing numbers"), field=name)
        if self.factor.shape != (self.viscosity_ratio.size, self.load_parameter.size):
            raise InputError(
                said(
                    "must have {size} rows of {size_2} numbers",
                    size=self.viscosity_ratio.size,
                    size_2=self.load_parameter.size,
                ),
                field="factor",
            )

    def at(self, viscosity_ratio: ArrayLike, load_parameter: ArrayLike) -> FloatArray:
        """Interpolate a_NSK, all in logarithms; NaN outside the table.

        A load parameter of 0 or less (P ≤ P_u) gives infinity: the fatigue limit is not reached.
        """
        kappa, load = np.broadcast_arrays(
            numbers(viscosity_ratio, "viscosity_ratio"), numbers(load_parameter, "load_parameter")
        )
        with np.errstate(divide="ignore", invalid="ignore"):
            row, row_share = _placed(np.log(kappa), np.log(self.viscosity_ratio))
            column, column_share = _placed(np.log(load), np.log(self.load_parameter))
        table = np.log(self.factor)
        low, high = (
            table[row + i, column] * (1.0 - column_share)
            + table[row + i, column + 1] * column_share
            for i in (0, 1)
        )
        return np.where(load <= 0.0, np.inf, np.exp(low * (1.0 - row_share) + high * row_share))


def read_factor_table(
    path: str | os.PathLike[str], *, decimal_mark: str | None = None
) -> FactorTable:
    """Read a table of a_NSK.

    Parameters
    ----------
    path
        Comma-separated values. The header has any word, then the load parameters (P - P_u)/(C a_c)
        of the columns, rising; every row below has κ, rising from row to row, and a_NSK.
    decimal_mark
        ``"point"`` or ``"comma"``, where nothing in the table shows whether 1.500 is 1.5.

    Raises
    ------
    FileError
        If it is not such a file; with line and column.
    """
    from rolamento.io.tables import read_table

    table = read_table(path, most_rows=_MAXIMUM_ROWS, example=_EXAMPLE).plain(decimal_mark)
    loads = [_cell(text, table.source, table.header_line, text) for text in table.header[1:]]
    rows = [
        [
            _cell(text, table.source, line, "κ" if column == 0 else table.header[column])
            for column, text in enumerate(cells)
        ]
        for cells, line in zip(table.rows, table.lines, strict=True)
    ]
    if len(loads) < 2 or len(rows) < 2:
        raise FileError(
            said("needs at least two rows (κ) of two columns (load parameters)"),
            source=table.source,
            example=_EXAMPLE,
        )
    array = np.array(rows)
    try:
        return FactorTable(array[:, 0], np.array(loads), array[:, 1:])
    except InputError as error:
        field = _NAMES.get(error.field, error.field)
        raise error.with_details(source=table.source, field=field) from None


def _cell(text: str, source: str, line: int, column: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = float("nan")
    if not isfinite(value):
        raise FileError(
            said("must be a number"),
            field=column,
            value=text,
            source=source,
            line=line,
            example="0.5",
        )
    return value


def load_parameter(
    equivalent_load: ArrayLike,
    fatigue_load_limit: ArrayLike,
    dynamic_rating: ArrayLike,
    contamination_factor: ArrayLike,
) -> FloatArray:
    """(P - P_u)/(C a_c), over which the maker's curves are drawn; arrays, N."""
    rating = positive(dynamic_rating, "dynamic_rating")
    clean = positive(contamination_factor, "contamination_factor")
    excess = numbers(equivalent_load, "equivalent_load") - numbers(
        fatigue_load_limit, "fatigue_load_limit"
    )
    return np.asarray(excess / (rating * clean))


def refusals(
    equivalent_load: ArrayLike,
    dynamic_rating: ArrayLike,
    static_rating: ArrayLike,
    speed: ArrayLike,
    temperature: ArrayLike,
) -> dict[str, BoolArray]:
    """Where the maker refuses to give a life, by name.

    Parameters
    ----------
    equivalent_load, dynamic_rating, static_rating : arrays, P, C and C_0; N.
    speed : array, of the rings against each other; rad/s.
    temperature : array, of the bearing; K, NaN if unknown.
    """
    turns = np.abs(numbers(speed, "speed")) * 30.0 / np.pi
    return {
        **load_notes(equivalent_load, dynamic_rating, static_rating),
        "too_slow": np.asarray(turns < MINIMUM_SPEED * (1.0 - 1e-12)),
        "too_hot": np.asarray(numbers(temperature, "temperature") > MAXIMUM_TEMPERATURE),
    }


def l_able(
    basic_life: ArrayLike,
    factor: ArrayLike,
    refused: dict[str, BoolArray],
    reliability_factor: ArrayLike = 1.0,
) -> FloatArray:
    """L_able = a_1 a_NSK L_10, NaN where the maker refuses; in the unit of the basic life.

    Parameters
    ----------
    basic_life, factor, reliability_factor : arrays that broadcast, L_10, a_NSK (or its stand-in)
        and a_1.
    refused : of `refusals`.
    """
    life = (
        numbers(basic_life, "basic_life")
        * numbers(factor, "factor")
        * numbers(reliability_factor, "reliability_factor")
    )
    outside = np.any(np.broadcast_arrays(*refused.values()), axis=0)
    return np.where(outside, np.nan, life)


def surface_factor(
    factor: ArrayLike, basic_life: ArrayLike, subsurface_life: ArrayLike
) -> FloatArray:
    """f(a_c, a_L) that turns the subsurface risk with a fatigue limit into a known a_NSK.

    Parameters: arrays that broadcast: a_NSK, L_10 and the life by `ioannides_harris`, in one
    unit. Returns f = (a_NSK L_10/L)^e; NaN above 1, where no risk is left for the surface.
    Campanha (2008), eq. 2.6.9.
    """
    ratio = (
        numbers(factor, "factor")
        * numbers(basic_life, "basic_life")
        / numbers(subsurface_life, "subsurface_life")
    )
    f = ratio**SLOPE
    return np.where(f <= 1.0, f, np.nan)


def life_with_surface(subsurface_life: ArrayLike, surface_factor: ArrayLike) -> FloatArray:
    """Life L f^(1/e) under the risk of subsurface and surface together; arrays, 0 < f ≤ 1.

    The risk below the surface counts 1, that of the surface 1/f - 1: together 1/f.
    """
    f = numbers(surface_factor, "surface_factor")
    if np.any((f <= 0.0) | (f > 1.0)):
        raise InputError(
            said("must be above 0 and at most 1"), field="surface_factor", example="0.5"
        )
    return np.asarray(numbers(subsurface_life, "subsurface_life") * f ** (1.0 / SLOPE))


def _placed(
    value: FloatArray, axis: FloatArray
) -> tuple[np.ndarray[tuple[int, ...], np.dtype[np.int64]], FloatArray]:
    """Interval of an axis that a value lies in, and how far in it; NaN outside."""
    index = np.clip(np.searchsorted(axis, value), 1, axis.size - 1) - 1
    share = (value - axis[index]) / (axis[index + 1] - axis[index])
    inside = (share >= -1e-9) & (share <= 1.0 + 1e-9)
    return np.asarray(index, dtype=np.int64), np.where(inside, share, np.nan)


def _evaluate(basis: Basis) -> Life:
    """L_able of solved cases; InputError if κ is not known."""
    given, ratio, ratings = basis.given, basis.viscosity_ratio, basis.ratings
    if ratio is None:
        raise InputError(
            said("is missing: L_able needs the viscosity ratio, or the viscosity"),
            field="viscosity_ratio",
            example="viscosity_ratio = 1.5",
        )
    clean, load = basis.over_cases("nsk_cleanliness"), basis.loads.dynamic
    hot = np.fmax(basis.over_cases("temperature"), basis.over_cases("bearing_temperature"))
    refused = refusals(load, ratings.dynamic_of_set, ratings.static_of_set, basis.speed, hot)
    if given.nsk_table is None:
        outside = "viscosity_ratio_too_small"
        factor = life_modification_factor(
            ratio,
            np.minimum(clean, 1.0),
            ratings.fatigue_in_factor,
            load,
            rollers=basis.has_rollers,
        )
    else:
        outside = "outside_the_table"
        place = load_parameter(load, ratings.fatigue_of_set, ratings.dynamic_of_set, clean)
        factor = given.nsk_table.at(ratio, place)
    notes = {
        **basis.notes_on_load(),
        **refused,
        "stand_in_for_the_chart": np.full(len(basis), given.nsk_table is None),
        outside: np.isnan(factor) & ~np.isnan(load),
    }
    factors = {"a_1": basis.reliability_factor, "a_nsk": l_able(1.0, factor, refused)}
    return basis.record(THEORY.name, basis.basic_life, factors, notes)


NSK_CLEANLINESS: Final = Need(
    "life.nsk_cleanliness",
    marked("the maker's cleanliness factor"),
    "[life] with nsk_cleanliness = 0.8 in the case",
    ("nsk_cleanliness",),
)
THEORY: Final = Theory(
    name="l_able",
    evaluate=_evaluate,
    asked=lambda basis: basis.given.nsk_cleanliness is not None,
    needs=(NSK_CLEANLINESS, VISCOSITY_RATIO),
    validity=(
        *OF_BEARING,
        *OF_EQUIVALENT_LOAD,
        "viscosity_ratio_too_small",
        "outside_the_table",
        "too_slow",
        "too_hot",
    ),
    rank=5,
    refuses=True,
)
