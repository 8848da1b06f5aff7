"""Which oil: the thinnest ISO viscosity grade with which κ is enough at the hottest temperature.

κ = ν/ν_1 of ISO 281 falls with the temperature, so the hottest decides; at the coldest a thick oil
drags. Grades are those of ISO 3448 with the viscosity index of the data file.

Sources: ISO 281:2007, 9.3.3; ISO 3448:1992; ASTM D341.
"""

from __future__ import annotations

from functools import cache
from math import isnan, nan
from typing import Any

import numpy as np

from rolamento.case.lubricant import Lubricant
from rolamento.errors import InputError
from rolamento.oil import viscosity_100_of_index
from rolamento.oil.properties import astm_d341, astm_d341_line
from rolamento.oil.state import oil_state, reference_viscosity
from rolamento.records import frozen
from rolamento.validate import number
from rolamento.words import Note, said

__all__ = ["Grade", "OilChoice", "choose_oil", "viscosity_at_40"]

_PREFIX = "ISO VG "
_ENOUGH = 4.0
"""κ beyond which ISO 281 counts no more."""
_40, _100 = 313.15, 373.15


@frozen
class Grade:
    """A grade at the two ends of a range of temperatures.

    Attributes
    ----------
    name
        such as "ISO VG 68"
    viscosity_cold, viscosity_hot
        kinematic, m²/s
    ratio_cold, ratio_hot
        κ
    """

    name: str
    viscosity_cold: float
    viscosity_hot: float
    ratio_cold: float
    ratio_hot: float


@frozen(eq=False)
class OilChoice:
    """Grades over a range of temperatures, and the one to take.

    Attributes
    ----------
    required
        κ
    coldest, hottest
        K
    speed
        of the rings against each other, rad/s
    pitch_diameter
        d_m, m
    reference
        ν_1, m²/s
    needed_40
        viscosity at 40 °C of an oil of that index with which κ is as required at the hottest
        temperature; m²/s
    grades
        all of them, the thinnest first
    chosen
        name of the thinnest that is enough; None if none is
    notes
        what to know
    """

    required: float
    coldest: float
    hottest: float
    speed: float
    pitch_diameter: float
    reference: float
    needed_40: float
    grades: tuple[Grade, ...]
    chosen: str | None
    notes: tuple[Note, ...] = ()

    def __getitem__(self, name: str) -> Grade:
        """Return a grade by its name."""
        return next(grade for grade in self.grades if grade.name == name)

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values, SI."""
        names = ("required", "coldest", "hottest", "speed", "pitch_diameter", "reference", "chosen")
        return {
            **{name: getattr(self, name) for name in names},
            "needed_40": None if isnan(self.needed_40) else self.needed_40,
            "grades": [
                {name: getattr(grade, name) for name in Grade.__dataclass_fields__}
                for grade in self.grades
            ],
            "notes": [note.to_mapping() for note in self.notes],
        }


@cache
def _grades() -> tuple[Lubricant, ...]:
    named = (Lubricant.named(name) for name in Lubricant.names() if name.startswith(_PREFIX))
    return tuple(sorted(named, key=lambda oil: oil.viscosity_40 or 0.0))


def choose_oil(
    speed: float, pitch_diameter: float, required: float, coldest: float, hottest: float
) -> OilChoice:
    """Choose the ISO viscosity grade for a required κ over a range of temperatures.

    Parameters
    ----------
    speed
        Of the rings against each other, rad/s.
    pitch_diameter
        d_m, m.
    required
        κ that the hottest temperature has to leave, 0.1 to 10.
    coldest, hottest
        Temperatures of the lubricant, K.

    Raises
    ------
    InputError
        If nothing turns, κ is out of range, or the coldest is not the coldest.

    >>> found = choose_oil(155.0, 0.080, 1.5, 313.15, 353.15)  # 1480 r/min, 40 to 80 °C
    >>> found.chosen, f"{1e6 * found.needed_40:.0f} mm^2/s at 40 °C"
    ('ISO VG 150', '101 mm^2/s at 40 °C')
    """
    if not speed > 0.0:
        raise InputError(
            said("is zero: κ is of a speed"), field="duty.inner_speed", example="--speed '1480 rpm'"
        )
    number(required, "kappa", least=0.1, most=10.0, example="1.5")
    if coldest > hottest:
        raise InputError(
            said("must not be hotter than the hottest"), field="coldest", value=coldest
        )
    reference = float(reference_viscosity(speed, pitch_diameter))
    ends = np.array([coldest, hottest])
    grades = []
    for oil in _grades():
        cold, hot = oil_state(oil, ends).kinematic_viscosity.tolist()
        grades.append(Grade(oil.name, cold, hot, cold / reference, hot / reference))
    chosen = next((grade for grade in grades if grade.ratio_hot >= required), None)
    notes = [Note("oil_index_assumed", {"index": _grades()[0].viscosity_index})]
    if chosen is None:
        notes.insert(0, Note("no_oil_thick_enough", {"kappa": grades[-1].ratio_hot}))
    elif chosen.ratio_cold > _ENOUGH and coldest < hottest:
        notes.append(Note("oil_drags_in_the_cold", {"kappa": chosen.ratio_cold}))
    return OilChoice(
        required=required,
        coldest=coldest,
        hottest=hottest,
        speed=speed,
        pitch_diameter=pitch_diameter,
        reference=reference,
        needed_40=viscosity_at_40(required * reference, hottest),
        grades=tuple(grades),
        chosen=None if chosen is None else chosen.name,
        notes=tuple(notes),
    )


def viscosity_at_40(viscosity: float, temperature: float) -> float:
    """Viscosity at 40 °C of an oil that has another at a temperature; m²/s.

    Parameters
    ----------
    viscosity
        Kinematic, at the temperature, m²/s.
    temperature
        K.

    Returns
    -------
    float
        With the viscosity index of the ISO grades in the data file; NaN beyond 2 to 10 000 mm²/s.

    ASTM D341.

    >>> print(f"{1e6 * viscosity_at_40(13e-6, 353.15):.0f} mm^2/s")
    59 mm^2/s
    """
    index = _grades()[0].viscosity_index
    assert index is not None
    low, high = 3e-6, 1e-2
    for _ in range(60):
        middle = (low * high) ** 0.5
        line = astm_d341_line(_40, middle, _100, viscosity_100_of_index(middle, index))
        at = float(astm_d341(np.asarray(temperature), line))
        if isnan(at) or at < viscosity:
            low = middle
        else:
            high = middle
    return nan if low < 8e-6 or high > 9.9e-3 else float(high)
