"""How numbers are written for a reader: few digits, the decimal mark of the language, a unit.

A number in SI is written in a unit by a specification, in templates and in tables alike::

    ""            a text as it is, a `Written` one as on pages; an integer grouped in threes; a
                  float with four figures
    ".5"          five significant figures, without trailing zeros
    ".2f"         two decimals
    ".3r"         three significant figures with their zeros, the rest rounded away: 5.00, 12 300;
                  by its order of magnitude where that is far from one
    ".1e"         by its order of magnitude
    ".6g"         six significant figures, by its order of magnitude where that is shorter
    "+.2f"        with its sign
    ".4 rpm"      in a unit, which is written behind the number
    ".4 [rpm]"    in a unit, which is not written

A sequence is written item by item, with commas; beyond `MOST_ITEMS` items comes "…".
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from math import floor, inf, isfinite, log10, pi
from string import Formatter
from typing import Any, Final

__all__ = [
    "ABSENT",
    "ENDLESS",
    "UNITS",
    "Manner",
    "Written",
    "decimals_for",
    "in_unit",
    "unit_of",
    "unit_sign",
]

ABSENT: Final = "–"
"""What stands for a number that does not exist."""
ENDLESS: Final = "∞"
"""What stands for a number beyond all others, such as a life that fatigue does not end."""

MOST_ITEMS: Final = 8
"""Maximum number of items of a sequence in a text."""

UNITS: Final[dict[str, tuple[float, float]]] = {
    # written in SI × factor + offset
    "": (1.0, 0.0),
    "–": (1.0, 0.0),  # a number without a unit, said so
    "%": (100.0, 0.0),
    "m": (1.0, 0.0),
    "mm": (1e3, 0.0),
    "µm": (1e6, 0.0),
    "nm": (1e9, 0.0),
    "mm²": (1e6, 0.0),
    "mm³": (1e9, 0.0),
    "rad": (1.0, 0.0),
    "mrad": (1e3, 0.0),
    "µrad": (1e6, 0.0),
    "°": (180.0 / pi, 0.0),
    "rad/s": (1.0, 0.0),
    "rpm": (30.0 / pi, 0.0),
    "10⁶ mm·rpm": (30.0 / pi * 1e-3, 0.0),
    "Hz": (1.0, 0.0),
    "kHz": (1e-3, 0.0),
    "N": (1.0, 0.0),
    "kN": (1e-3, 0.0),
    "N·m": (1.0, 0.0),
    "N·mm": (1e3, 0.0),
    "µN·m": (1e6, 0.0),
    "N/mm": (1e-3, 0.0),
    "N/µm": (1e-6, 0.0),
    "N/mrad": (1e-3, 0.0),
    "N·m/mm": (1e-3, 0.0),
    "N·m/mrad": (1e-3, 0.0),
    "Pa": (1.0, 0.0),
    "MPa": (1e-6, 0.0),
    "GPa": (1e-9, 0.0),
    "1/GPa": (1e9, 0.0),
    "W": (1.0, 0.0),
    "mW": (1e3, 0.0),
    "µW": (1e6, 0.0),
    "°C": (1.0, -273.15),
    "K": (1.0, 0.0),
    "W/K": (1.0, 0.0),
    "l/min": (60e3, 0.0),
    "V": (1.0, 0.0),
    "A": (1.0, 0.0),
    "pF": (1e12, 0.0),
    "nJ": (1e9, 0.0),
    "A/mm²": (1e-6, 0.0),
    "V/µm": (1e-6, 0.0),
    "J/K": (1.0, 0.0),
    "mm²/s": (1e6, 0.0),
    "mPa·s": (1e3, 0.0),
    "Pa·s": (1.0, 0.0),
    "m/s": (1.0, 0.0),
    "mm/s": (1e3, 0.0),
    "µm/s": (1e6, 0.0),
    "m/s²": (1.0, 0.0),
    "kg/m³": (1.0, 0.0),
    "W/(m·K)": (1.0, 0.0),
    "10⁻⁶/K": (1e6, 0.0),
    "s": (1.0, 0.0),
    "ms": (1e3, 0.0),
    "min": (1.0 / 60.0, 0.0),
    "h": (1.0 / 3600.0, 0.0),
    "rev": (1.0, 0.0),
    "10⁶ rev": (1e-6, 0.0),
    "osc.": (1.0, 0.0),
    "10⁶ osc.": (1e-6, 0.0),
    "dB": (1.0, 0.0),
}
"""Factor and offset from SI to every unit that a page writes."""

_MINUS: Final = "−"
_SMALLEST_GROUPED: Final = 10_000
_FIGURES: Final = 4
_SMALLEST, _GREATEST = 1e-4, 1e8
_SPECIFICATION: Final = re.compile(r"(\+?)(?:\.(\d+)([fegr]?))?(?: ?(\[)?([^\[\]]*)\]?)?")
_SIGNS: Final = (("deg", "°"), ("^2", "²"), ("^3", "³"), (" ", "·"))
_CLOSE: Final = ("°",)
"""Units that stand at the number without a space."""


def decimals_for(values: Iterable[float], digits: int, most: int = 4) -> int:
    """Return how many decimals give the maximum of the values so many significant digits."""
    maximum = max((abs(value) for value in values if isfinite(value)), default=0.0)
    if maximum == 0.0:
        return 0
    return min(max(digits - 1 - floor(log10(maximum)), 0), most)


def in_unit(value: Any, unit: str) -> Any:
    """Return an SI value, or an array of them, in one of `UNITS`.

    Raises
    ------
    KeyError
        For a unit that is not known.
    """
    factor, offset = UNITS[unit]
    return value * factor + offset


def unit_of(specification: str) -> str:
    """Return the unit of a specification of a number, written or not (see the module)."""
    found = _SPECIFICATION.fullmatch(specification)
    return found[5] if found and found[5] in UNITS else ""


def unit_sign(unit: str) -> str:
    """Return a unit of a case file, such as ``"N m"``, as pages write it: N·m, °C, mm²/s."""
    for typed, sign in _SIGNS:
        unit = unit.replace(typed, sign)
    return unit


@lru_cache(maxsize=1024)
def _pieces(template: str) -> tuple[tuple[str, str | None, str], ...] | None:
    """Part a template into texts, each with the name and the form of what follows it.

    None where that is more than a name and a form.
    """
    found = []
    for text, name, form, conversion in Formatter().parse(template):
        if conversion or (name is not None and not name.isidentifier()) or "{" in (form or ""):
            return None
        found.append((text, name, form or ""))
    return tuple(found)


class Written(str):
    """A quantity as a case file writes it, such as ``"22.23 mm"``; sentences say it as pages do."""

    __slots__ = ()


class Manner(Formatter):
    """Writes numbers with one decimal mark, and fills templates with them.

    Parameters
    ----------
    mark
        ``"."`` or ``","``.
    """

    def __init__(self, mark: str) -> None:
        self.mark = mark

    def vformat(self, format_string: str, args: Sequence[Any], kwargs: Mapping[str, Any]) -> str:
        """Fill a template in: plain names at once, anything else as `Formatter` does."""
        pieces = _pieces(format_string)
        if pieces is None:
            return super().vformat(format_string, args, kwargs)
        return "".join(
            text if name is None else text + self.format_field(kwargs[name], form)
            for text, name, form in pieces
        )

    def fixed(self, value: float, decimals: int) -> str:
        """Write a number with so many decimals, groups of three from ten thousand on."""
        if not isfinite(value):
            return ABSENT
        text = f"{abs(value):,.{decimals}f}"
        grouped = text.replace(",", " " if abs(value) >= _SMALLEST_GROUPED else "")
        negative = value < 0.0 and any(digit in "123456789" for digit in text)
        return (_MINUS if negative else "") + grouped.replace(".", self.mark)

    def column(self, values: Sequence[float], digits: int = 5, most: int = 4) -> list[str]:
        """Write numbers that stand below each other, with the same decimals."""
        decimals = decimals_for(values, digits, most)
        return [self.fixed(value, decimals) for value in values]

    def short(self, value: float, digits: int = 5) -> str:
        """Write one number without trailing zeros."""
        if not isfinite(value):
            return ABSENT
        text = self.fixed(value, decimals_for([value], digits, most=9))
        return text.rstrip("0").rstrip(self.mark) if self.mark in text else text

    def significant(self, value: float, figures: int) -> str:
        """Write one number with so many figures, such as a life: no more are worth printing."""
        if value == inf:
            return ENDLESS
        if not isfinite(value) or value == 0.0:
            return self.fixed(value, 0)
        if not _SMALLEST <= abs(value) < _GREATEST:
            return self.formatted(value, f".{figures - 1}e")
        rounded = round(value, figures - 1 - floor(log10(abs(value))))
        return self.fixed(rounded, max(figures - 1 - floor(log10(abs(rounded))), 0))

    def formatted(self, value: float, form: str) -> str:
        """Write a number as Python's ``format`` does, its power of ten briefly: 1.83e18, 2e-7."""
        mantissa, _, exponent = f"{abs(value):{form}}".partition("e")
        minus = _MINUS if value < 0.0 else ""
        power = f"e{int(exponent)}" if exponent else ""
        return minus + mantissa.replace(".", self.mark) + power

    def localised(self, quantity: str) -> str:
        """Write a quantity of a case file, such as ``"22.23 mm"``, as a page does."""
        number, space, unit = quantity.partition(" ")
        try:
            value = float(number)
        except ValueError:
            return quantity
        if unit and abs(value) >= _SMALLEST_GROUPED and value.is_integer():
            number = self.fixed(value, 0)
        unit = unit_sign(unit)
        number = number.replace("-", _MINUS).replace(".", self.mark)
        return number + ("" if unit in _CLOSE else space) + unit

    def number(self, value: float, specification: str = "") -> str:
        """Write an SI value by a specification (see the module)."""
        found = _SPECIFICATION.fullmatch(specification)
        if found is None or found[5] not in UNITS:
            raise ValueError(f"{specification!r} is no specification of a number")
        sign, digits, form, bracket, unit = found.groups()
        scaled = float(in_unit(value, unit))
        if form == "f":
            text = self.fixed(scaled, int(digits))
        elif form == "r":
            text = self.significant(scaled, int(digits))
        elif form in ("e", "g"):
            text = self.formatted(scaled, f".{digits}{form}") if isfinite(scaled) else ABSENT
        else:
            text = self.short(scaled, int(digits) if digits else _FIGURES)
        text = f"+{text}" if sign and scaled > 0.0 else text
        if bracket or not unit:
            return text
        return text + ("" if unit in _CLOSE else " ") + unit

    def format_field(self, value: Any, format_spec: str) -> str:
        """Write what a template holds in one of its places."""
        if isinstance(value, str):
            return self.localised(value) if isinstance(value, Written) else value
        if value is None:
            return ABSENT
        if isinstance(value, bool):
            return str(value)
        if isinstance(value, int) and not format_spec:  # of any size, with all its digits
            text = f"{abs(value):,}".replace(",", " " if abs(value) >= _SMALLEST_GROUPED else "")
            return (_MINUS if value < 0 else "") + text
        if isinstance(value, int | float):
            return self.number(float(value), format_spec)
        if hasattr(value, "tolist"):
            value = value.tolist()
            if not isinstance(value, list):
                return self.format_field(value, format_spec)
        if isinstance(value, list | tuple):
            items = [self.format_field(one, format_spec) for one in value[:MOST_ITEMS]]
            return ", ".join(items) + (" …" if len(value) > MOST_ITEMS else "")
        return str(value)
