"""How dirty the lubricant is: from a code, a filter or a word to the contamination factor e_C.

    e_C = min(1, c1 κ^0.68 D_pw^0.55) (1 - c2/D_pw^(1/3)),   D_pw in mm, at least 0.

Grease of slight contamination has c2 = 1.677 from D_pw = 500 mm on, 1.887 below.
The standard gives c1 and c2 for a few classes of oil, by their ISO 4406 codes, and of grease. An
oil between two of them counts as the dirtier one; one dirtier than the last has no factor.

Of a level in words, such as normal cleanliness, the standard gives a range of e_C by D_pw alone;
the middle of it is taken.

Sources: ISO 281:2007, annex A and table 13 (levels in words); ISO 4406.
"""

from __future__ import annotations

from typing import Any, Final, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError, guess
from rolamento.io.data import toml_of
from rolamento.iso4406 import cleanliness_numbers
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import one_of, positive
from rolamento.words import said

OilSupply = Literal["circulating", "bath"]
"""Circulating: filtered in the line before the bearing; bath: not, or in a circuit of its own."""

_LARGE: Final = 500.0 * (1.0 - 1e-9)
"""Pitch diameter from which grease of slight contamination has a c2 of its own; mm, as rounded."""
_LARGE_OF_LEVELS: Final = 100.0 * (1.0 - 1e-9)
"""Pitch diameter from which levels in words have ranges of their own; mm, as rounded."""
_EXAMPLE = 'cleanliness = "-/17/14"'


@frozen
class ContaminationClass:
    """A class of cleanliness: its name in the standard, and its constants.

    c2_of_large: in the place of c2 for pitch diameters of 500 mm and more, if they have their own.
    """

    name: str
    supply: str
    c1: float
    c2: float
    c2_of_large: float | None = None


@frozen
class ContaminationLevel:
    """A level of cleanliness in words, and the range of e_C that it stands for.

    small, large: the dirtier and the cleaner end for pitch diameters below 100 mm, and from there.
    """

    name: str
    small: tuple[float, float]
    large: tuple[float, float]

    def range_at(self, pitch_diameter: ArrayLike) -> tuple[FloatArray, FloatArray]:
        """Return the dirtier and the cleaner end of e_C; pitch diameter in m."""
        large = positive(pitch_diameter, "pitch_diameter") * 1e3 >= _LARGE_OF_LEVELS
        low, high = (np.where(large, *ends) for ends in zip(self.large, self.small, strict=True))
        return low, high


def level_of(name: str) -> ContaminationLevel:
    """Return a level of cleanliness: extreme, high, normal, slight, typical, severe, very_severe.

    Raises
    ------
    InputError
        For another word.
    """
    rows = {row["name"]: row for row in toml_of("iso281")["contamination"]["level"]}
    if name not in rows:
        raise InputError(
            said("is an unknown class; {guess}", guess=guess(str(name), rows)),
            field="cleanliness",
            value=name,
            example='cleanliness = "normal"',
        )
    row = rows[name]
    return ContaminationLevel(name, tuple(row["small"]), tuple(row["large"]))


def class_of_code(code: str, supply: OilSupply) -> ContaminationClass:
    """Return the class of an oil by its ISO 4406 code: the cleanest one not cleaner than the oil.

    Raises
    ------
    InputError
        For a malformed code, an oil dirtier than all classes, or an unknown supply.
    """
    one_of(supply, "supply", get_args(OilSupply), 'supply = "circulating"')
    _, six, fourteen = cleanliness_numbers(code)
    rows = toml_of("iso281")["contamination"][supply]
    for row in rows:
        _, most_six, most_fourteen = cleanliness_numbers(row["name"])
        if six <= most_six and fourteen <= most_fourteen:
            return _class(row, supply)
    raise InputError(
        said(
            "is dirtier than {rows}, the last class of the standard for this supply",
            rows=rows[-1]["name"],
        ),
        field="cleanliness",
        value=code,
        example=_EXAMPLE,
    )


def class_of_filter(size: float, ratio: float) -> ContaminationClass:
    """Return the class of circulating oil by its in-line filter.

    Parameters
    ----------
    size : of the particles that the filter is rated for; m (as ISO 16889 counts them).
    ratio : filtration ratio β at that size: particles before over particles after.

    Raises
    ------
    InputError
        If the filter is coarser than all of the standard's.
    """
    micrometres = float(positive(size, "filter_size")) * 1e6
    beta = float(positive(ratio, "filter_ratio"))
    for row in toml_of("iso281")["contamination"]["circulating"]:
        if micrometres <= row["filter_size"] * (1.0 + 1e-9) and beta >= row["filter_ratio"]:
            return _class(row, "circulating")
    raise InputError(
        said("is coarser than the last filter of the standard, β of 75 at 40 µm"),
        field="filter",
        value=said("β = {beta:.6} at {size:.6 µm}", beta=beta, size=1e-6 * micrometres),
        example=said("β = {beta:.6} at {size:.6 µm}", beta=200.0, size=12e-6),
    )


def class_of_grease(level: str) -> ContaminationClass:
    """Return the class of a grease: high (cleanliness), normal, slight, severe, very_severe.

    Raises
    ------
    InputError
        For another word.
    """
    rows = {row["name"]: row for row in toml_of("iso281")["contamination"]["grease"]}
    if level not in rows:
        raise InputError(
            said("is an unknown class; {guess}", guess=guess(str(level), rows)),
            field="grease_cleanliness",
            value=level,
            example='grease_cleanliness = "normal"',
        )
    return _class(rows[level], "grease")


def contamination_factor(
    found: ContaminationClass | ContaminationLevel,
    viscosity_ratio: ArrayLike,
    pitch_diameter: ArrayLike,
) -> FloatArray:
    """Contamination factor e_C, 0 (severe contamination) to 1 (clean).

    Parameters
    ----------
    found : the class; of a level in words the middle of its range, whatever κ is.
    viscosity_ratio : array, κ.
    pitch_diameter : array that broadcasts with it; m.

    ISO 281:2007, annex A, table 13.
    """
    if isinstance(found, ContaminationLevel):
        low, high = found.range_at(pitch_diameter)
        return np.asarray(np.broadcast_arrays(0.5 * (low + high), viscosity_ratio)[0])
    ratio = positive(viscosity_ratio, "viscosity_ratio", zero=True)
    diameter = positive(pitch_diameter, "pitch_diameter") * 1e3
    film = np.minimum(found.c1 * ratio**0.68 * diameter**0.55, 1.0)
    own = found.c2 if found.c2_of_large is None else found.c2_of_large
    c2 = np.where(diameter >= _LARGE, own, found.c2)
    return np.asarray(np.maximum(film * (1.0 - c2 / np.cbrt(diameter)), 0.0))


def _class(row: dict[str, Any], supply: str) -> ContaminationClass:
    large = row.get("c2_from_500_mm")
    return ContaminationClass(row["name"], supply, row["c1"], row["c2"], large)
