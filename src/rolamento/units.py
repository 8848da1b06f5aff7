"""The border between what people write and the SI floats inside.

`to_si` reads ``"22.23 mm"`` as 0.02223 and `from_si` writes it back. Both work with
exact fractions and round once, at the end: ``"22.23 mm"`` is the very float that
Python reads from ``0.02223``, and what `from_si` writes, `to_si` reads back bit for
bit. This is the only module that imports pint.
"""

from __future__ import annotations

import math
import re
from contextlib import suppress
from decimal import Context, Decimal
from fractions import Fraction
from functools import lru_cache
from importlib import resources
from typing import TYPE_CHECKING, Any, Final, Literal, NamedTuple

from rolamento.errors import UnitError, nearest, shown
from rolamento.words import Written, manner, marked, said

if TYPE_CHECKING:
    import pint

__all__ = [
    "DEGREES",
    "HOUR",
    "MICROMETRE",
    "MILLIMETRE",
    "RPM",
    "SI_UNIT",
    "ZERO_CELSIUS",
    "Dimension",
    "doubt_of_thousands",
    "from_si",
    "name_of",
    "readable",
    "refuse_thousands",
    "rpm_of",
    "to_si",
    "typed",
    "usual_units",
]

MILLIMETRE: Final = 1e-3
MICROMETRE: Final = 1e-6
RPM: Final = math.pi / 30.0
"""One revolution a minute in rad/s."""


def rpm_of(speed: Any) -> Any:
    """Return a speed in rad/s (a number or an array) in revolutions a minute."""
    return speed * 30.0 / math.pi


DEGREES: Final = 180.0 / math.pi
"""Degrees in one rad."""
HOUR: Final = 3600.0
"""Seconds in it."""
ZERO_CELSIUS: Final = 273.15
"""0 °C in K."""

Dimension = Literal[
    "length",
    "angle",
    "angular_speed",
    "force",
    "moment",
    "stress",
    "density",
    "temperature",
    "kinematic_viscosity",
    "dynamic_viscosity",
    "pressure_viscosity_coefficient",
    "thermal_conductivity",
    "thermal_expansion",
    "time",
    "velocity",
    "power",
    "stiffness",
    "angular_stiffness",
    "mass",
    "inertia",
    "unbalance",
    "acceleration",
    "thermal_conductance",
    "flow_rate",
    "voltage",
    "electric_current",
    "frequency",
    "heat_capacity",
]

_NAMES: Final[dict[Dimension, str]] = {
    "length": marked("length"),
    "angle": marked("angle"),
    "angular_speed": marked("angular speed"),
    "force": marked("force"),
    "moment": marked("moment"),
    "stress": marked("stress"),
    "density": marked("density"),
    "temperature": marked("temperature"),
    "kinematic_viscosity": marked("kinematic viscosity"),
    "dynamic_viscosity": marked("dynamic viscosity"),
    "pressure_viscosity_coefficient": marked("pressure-viscosity coefficient"),
    "thermal_conductivity": marked("thermal conductivity"),
    "thermal_expansion": marked("thermal expansion"),
    "time": marked("time"),
    "velocity": marked("velocity"),
    "power": marked("power"),
    "stiffness": marked("stiffness"),
    "angular_stiffness": marked("angular stiffness"),
    "mass": marked("mass"),
    "inertia": marked("moment of inertia"),
    "unbalance": marked("unbalance"),
    "acceleration": marked("acceleration"),
    "thermal_conductance": marked("thermal conductance"),
    "flow_rate": marked("flow rate"),
    "voltage": marked("voltage"),
    "electric_current": marked("electric current"),
    "frequency": marked("frequency"),
    "heat_capacity": marked("heat capacity"),
}

SI_UNIT: Final[dict[Dimension, str]] = {
    "length": "m",
    "angle": "rad",
    "angular_speed": "rad/s",
    "force": "N",
    "moment": "N m",
    "stress": "Pa",
    "density": "kg/m^3",
    "temperature": "K",
    "kinematic_viscosity": "m^2/s",
    "dynamic_viscosity": "Pa s",
    "pressure_viscosity_coefficient": "1/Pa",
    "thermal_conductivity": "W/m/K",
    "thermal_expansion": "1/K",
    "time": "s",
    "velocity": "m/s",
    "power": "W",
    "stiffness": "N/m",
    "angular_stiffness": "N m/rad",
    "mass": "kg",
    "inertia": "kg m^2",
    "unbalance": "kg m",
    "acceleration": "m/s^2",
    "thermal_conductance": "W/K",
    "flow_rate": "m^3/s",
    "voltage": "V",
    "electric_current": "A",
    "frequency": "Hz",
    "heat_capacity": "J/K",
}


class _Unit(NamedTuple):
    """SI value = scale · number + offset, exactly."""

    scale: Fraction
    offset: Fraction = Fraction(0)


_PI: Final = Fraction("3.14159265358979323846264338327950288419716939937510")

# What nearly every case file uses. Importing pint takes longer than solving ten
# thousand bearings; a file that keeps to these never waits for it. A test holds each
# line against pint.
_COMMON: Final[dict[Dimension, dict[str, _Unit]]] = {
    "length": {
        "mm": _Unit(Fraction(1, 10**3)),
        "µm": _Unit(Fraction(1, 10**6)),
        "um": _Unit(Fraction(1, 10**6)),
        "m": _Unit(Fraction(1)),
        "in": _Unit(Fraction(254, 10**4)),
    },
    "angle": {"deg": _Unit(_PI / 180), "rad": _Unit(Fraction(1))},
    "angular_speed": {"rpm": _Unit(_PI / 30), "rad/s": _Unit(Fraction(1))},
    "force": {"N": _Unit(Fraction(1)), "kN": _Unit(Fraction(10**3))},
    "moment": {
        "N m": _Unit(Fraction(1)),
        "N mm": _Unit(Fraction(1, 10**3)),
        "kN m": _Unit(Fraction(10**3)),
    },
    "stress": {
        "GPa": _Unit(Fraction(10**9)),
        "MPa": _Unit(Fraction(10**6)),
        "Pa": _Unit(Fraction(1)),
    },
    "density": {"kg/m^3": _Unit(Fraction(1)), "g/cm^3": _Unit(Fraction(10**3))},
    "temperature": {
        "degC": _Unit(Fraction(1), Fraction(27315, 100)),
        "K": _Unit(Fraction(1)),
    },
    "kinematic_viscosity": {
        "mm^2/s": _Unit(Fraction(1, 10**6)),
        "cSt": _Unit(Fraction(1, 10**6)),
        "m^2/s": _Unit(Fraction(1)),
    },
    "dynamic_viscosity": {
        "mPa s": _Unit(Fraction(1, 10**3)),
        "cP": _Unit(Fraction(1, 10**3)),
        "Pa s": _Unit(Fraction(1)),
    },
    "pressure_viscosity_coefficient": {
        "1/GPa": _Unit(Fraction(1, 10**9)),
        "1/MPa": _Unit(Fraction(1, 10**6)),
        "1/Pa": _Unit(Fraction(1)),
    },
    "thermal_conductivity": {
        "W/m/K": _Unit(Fraction(1)),
        "mW/m/K": _Unit(Fraction(1, 10**3)),
    },
    "thermal_expansion": {"1/K": _Unit(Fraction(1))},
    "time": {"h": _Unit(Fraction(3600)), "s": _Unit(Fraction(1))},
    "velocity": {
        "mm/s": _Unit(Fraction(1, 10**3)),
        "m/s": _Unit(Fraction(1)),
        "in/s": _Unit(Fraction(254, 10**4)),
    },
    "power": {
        "kW": _Unit(Fraction(10**3)),
        "W": _Unit(Fraction(1)),
        "hp": _Unit(Fraction("745.69987158227022")),
        "cv": _Unit(Fraction("735.49875")),
    },
    "stiffness": {
        "N/mm": _Unit(Fraction(10**3)),
        "N/um": _Unit(Fraction(10**6)),
        "N/µm": _Unit(Fraction(10**6)),
        "kN/mm": _Unit(Fraction(10**6)),
        "N/m": _Unit(Fraction(1)),
    },
    "angular_stiffness": {
        "N m/rad": _Unit(Fraction(1)),
        "kN m/rad": _Unit(Fraction(10**3)),
        "N mm/rad": _Unit(Fraction(1, 10**3)),
    },
    "mass": {"kg": _Unit(Fraction(1)), "g": _Unit(Fraction(1, 10**3))},
    "inertia": {
        "kg m^2": _Unit(Fraction(1)),
        "kg mm^2": _Unit(Fraction(1, 10**6)),
        "kg cm^2": _Unit(Fraction(1, 10**4)),
    },
    "unbalance": {
        "g mm": _Unit(Fraction(1, 10**6)),
        "kg mm": _Unit(Fraction(1, 10**3)),
        "kg m": _Unit(Fraction(1)),
    },
    "acceleration": {"m/s^2": _Unit(Fraction(1)), "mm/s^2": _Unit(Fraction(1, 10**3))},
    "thermal_conductance": {"W/K": _Unit(Fraction(1)), "kW/K": _Unit(Fraction(10**3))},
    "flow_rate": {"l/min": _Unit(Fraction(1, 60_000)), "m^3/s": _Unit(Fraction(1))},
    "voltage": {"V": _Unit(Fraction(1)), "mV": _Unit(Fraction(1, 10**3))},
    "electric_current": {"A": _Unit(Fraction(1)), "mA": _Unit(Fraction(1, 10**3))},
    "frequency": {"Hz": _Unit(Fraction(1)), "1/min": _Unit(Fraction(1, 60))},
    "heat_capacity": {"J/K": _Unit(Fraction(1)), "kJ/K": _Unit(Fraction(10**3))},
}

_LONGEST_TEXT: Final = 100
_GREATEST_EXPONENT: Final = 400
_NUMBER: Final = r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?"
_WITH_COMMA: Final = (
    r"(?s)([+-]?(?:[1-9][0-9]{0,2}(?:\.[0-9]{3})+|[0-9]*),[0-9]+(?:[eE][+-]?[0-9]+)?)\s*([^,]*)"
)
"""A number with a decimal comma, as those write who part thousands with points."""
_QUANTITY: Final = re.compile(rf"({_NUMBER})\s*(.*)", re.DOTALL)
_IN_THOUSANDS: Final = r"[+-]?[1-9]\d{0,2}\.\d{3}"
"""As those write thousands whose decimal mark is a comma."""
_COUNTED_IN_THOUSANDS: Final = (
    "rpm", "RPM", "r/min", "1/min", "min^-1", "min⁻¹", "U/min", "rot/min", "N", "kgf", "kp",
)  # fmt: skip
"""Units of which a thousandth is hardly meant; 9.525 mm is."""
_FACTOR: Final = re.compile(r"\s*([*/])?\s*([A-Za-zµμ]+)(?:(?:\^|\*\*)?(-?[1-4])(?![0-9]))?\s*")
_ONE_OVER: Final = r"^\s*1\s*/\s*([A-Za-z]+)(?![A-Za-z^*0-9])"
_PLAINER: Final = str.maketrans(
    {"·": "*", "⋅": "*", "×": "*", ".": "*", "²": "2", "³": "3", "⁴": "4", "¹": "1", "⁻": "-",
     "−": "-", "º": "°", "˚": "°", "℃": "°C", "℉": "°F"}
)  # fmt: skip
_HYPHEN: Final = re.compile(r"(?<=[A-Za-z])-(?=[A-Za-z])")
"""Between the units of a moment: N-m, in-lb."""
_TURNS: Final = {
    **dict.fromkeys(
        ("rpm", "1/min", "/min", "min^-1", "min-1", "r/min", "rev/min", "u/min", "rot/min",
         "tr/min", "umdr/min", "upm", "giri/min"), "rpm"
    ),
    **dict.fromkeys(("hz", "rps", "r/s", "rev/s", "u/s", "rot/s", "tr/s"), "rev/s"),
}  # fmt: skip
"""What name plates call turns in a minute and in a second, without case.

Of a speed ISO 80000-3 has r/min, or min⁻¹, for the rotational frequency: a shaft's hertz are turns.
s⁻¹ is of turns or of radians, and is refused.
"""
_ALSO: Final[dict[Dimension, dict[str, str]]] = {
    "temperature": {"C": "degC", "c": "degC", "F": "degF"},
    "power": {"PS": "cv", "ch": "cv", "CV": "cv"},
    "force": {"lbs": "lbf", "lb": "lbf"},
}
"""Units that another quantity has under the same name, or that have none here."""
_PLATES: Final[dict[Dimension, tuple[str, ...]]] = {
    "length": ("cm", "km"),
    "force": ("MN", "mN", "daN", "kgf", "kp", "lbf"),
    "moment": ("Nm", "kNm", "mN m", "MN m", "kgf m", "daN m"),
    "stress": ("mPa", "kPa", "bar", "psi", "ksi"),
    "time": ("min", "ms", "d"),
    "power": ("MW", "mW"),
    "velocity": ("µm/s",),
    "temperature": ("degF", "°C", "°F"),
}
"""Units besides the common ones whose case may be wrong, and those for which they may be taken."""
_POUND: Final = r"\blbs?\b"
_SMALL_LENGTH: Final = 1e-4
"""Below it (m) people write a computed length in micrometres."""
_FIFTEEN_DIGITS: Final = Context(prec=15)


def to_si(text: str, dimension: Dimension) -> float:
    """Read a number with its unit.

    Parameters
    ----------
    text
        Such as ``"22.23 mm"``, ``"10000 rpm"`` or ``"1.5 N·m"``; at most 100 characters.
    dimension
        The quantity that is expected.

    Returns
    -------
    float
        The value in the unit of `SI_UNIT`, correctly rounded.

    Raises
    ------
    UnitError
        If the text is not a finite number followed by a unit of that quantity.

    >>> found = to_si("30 rpm", "angular_speed")
    >>> print(f"{found:.6f} rad/s")
    3.141593 rad/s
    """
    if len(text) > _LONGEST_TEXT:
        raise UnitError(
            said("must be at most {most} characters long", most=_LONGEST_TEXT), value=text
        )
    number, unit_text = _split(text, dimension)
    unit = _COMMON[dimension].get(unit_text) or _spelled_unit(unit_text, dimension)
    exponent = int(number.lower().partition("e")[2] or 0)
    with suppress(OverflowError):
        if abs(exponent) <= _GREATEST_EXPONENT:  # a greater one would fill the memory
            return float(Fraction(number) * unit.scale + unit.offset)
    raise UnitError(said("is beyond the range of floating-point numbers"), value=text)


def from_si(value: float, dimension: Dimension) -> str:
    """Write an SI value with a unit so that `to_si` returns the identical float.

    The unit is the one that people use (mm, N or kN, rpm, deg …) if fifteen digits
    of it say the value exactly, and the SI unit otherwise.

    Parameters
    ----------
    value
        A finite number, in the unit of `SI_UNIT`.
    dimension
        The quantity that it is.

    Raises
    ------
    ValueError
        If the value is infinite or not a number.
    """
    if not math.isfinite(value):
        raise ValueError(f"{value} cannot be written: it is not a finite number")
    unit_text = _familiar_unit(value, dimension)
    unit = _COMMON[dimension][unit_text]
    number = (Fraction(value) - unit.offset) / unit.scale
    decimal = _FIFTEEN_DIGITS.divide(Decimal(number.numerator), Decimal(number.denominator))
    text = f"{_plain(decimal)} {unit_text}"
    return text if _reads_as(text, dimension, value) else f"{value!r} {SI_UNIT[dimension]}"


def readable(value: float, dimension: Dimension, digits: int = 6) -> Written:
    """Write an SI value in the unit that people use, with as many digits as they read.

    A value that a person gave comes out as it was given; a computed one is rounded.
    """
    unit_text = _familiar_unit(value, dimension)
    unit = _COMMON[dimension][unit_text]
    number = float((Fraction(value) - unit.offset) / unit.scale) if math.isfinite(value) else value
    text = f"{number:.12g}"
    if len(text) <= 2 * digits:
        return Written(f"{text} {unit_text}")
    if dimension == "length" and abs(value) < _SMALL_LENGTH:
        return Written(f"{value / MICROMETRE:.{digits}g} µm")
    return Written(f"{number:.{digits}g} {unit_text}")


def _reads_as(text: str, dimension: Dimension, value: float) -> bool:
    try:
        return to_si(text, dimension) == value
    except UnitError:  # rounding up took it beyond the greatest float
        return False


def _familiar_unit(value: float, dimension: Dimension) -> str:
    """Return the unit in which people write a value of this size."""
    if dimension == "force":
        return "kN" if abs(value) >= 1e3 else "N"
    if dimension == "stress":
        return "GPa" if abs(value) >= 1e9 else "MPa"
    return next(iter(_COMMON[dimension]))


def _plain(decimal: Decimal) -> str:
    """Return a decimal without trailing zeros, and without an exponent if it is short."""
    if not decimal:
        return "0"
    short = decimal.normalize()
    return f"{short:f}" if -7 < short.adjusted() < 15 else f"{short:e}"


def _split(text: str, dimension: Dimension) -> tuple[str, str]:
    """Return the number and the unit of a text, or explain what is wrong with it."""
    stripped = re.sub("^−", "-", text.strip())
    match = _QUANTITY.fullmatch(typed(stripped) if "," in stripped else stripped)
    if match is None:
        raise UnitError(
            said(
                "must be a finite number with a unit of {dimension}", dimension=name_of(dimension)
            ),
            value=text,
            example=_example(dimension),
        )
    number, unit = match[1], match[2]
    if not unit:
        raise UnitError(
            said("needs a unit of {dimension}", dimension=name_of(dimension)),
            value=text,
            example=f'"{number} {usual_units(dimension)[0]}"',
        )
    if unit.startswith(","):
        raise UnitError(
            said("needs a decimal point, not a comma"), value=text, example=_example(dimension)
        )
    return number, unit


def typed(text: str) -> str:
    """Return a number with a decimal point that was typed with a comma, and its unit behind it.

    Where the language that is spoken has decimal commas; other texts are returned as they are.
    """
    if manner().mark != "," or not (match := re.fullmatch(_WITH_COMMA, text.strip())):
        return text
    return f"{match[1].replace('.', '').replace(',', '.')} {match[2]}".strip()


def refuse_thousands(text: str, units: tuple[str, ...] = _COUNTED_IN_THOUSANDS) -> None:
    """Refuse 1.480 rpm where the language that is spoken parts thousands with points.

    For what a person types; a file has decimal points whatever the language. Texts that are no
    number with a unit are passed over: whoever reads them refuses them.

    Parameters
    ----------
    text
        Number and unit.
    units
        Those that count; "" for a number without one.

    Raises
    ------
    UnitError
        With both readings.
    """
    match = _QUANTITY.fullmatch(text.strip())
    if match is None or match[2] not in units:
        return
    if rule := doubt_of_thousands(match[1]):
        example = f"{match[1].replace('.', '')} {match[2]}".strip()
        raise UnitError(rule, value=text, example=example)


def doubt_of_thousands(number: str) -> str:
    """Return the rule that a number breaks whose points may part thousands; empty for others."""
    if manner().mark != "," or not re.fullmatch(_IN_THOUSANDS, number):
        return ""
    return said(
        "may be {decimal} or, with a point between thousands, {whole}; write it without that point",
        decimal=float(number),
        whole=int(number.replace(".", "")),
    )


@lru_cache(maxsize=1024)
def _spelled_unit(text: str, dimension: Dimension) -> _Unit:
    """Return any unit of a quantity, in the spellings of name plates and in the wrong case.

    Case is mended only where one meaning is left: KN is kN, and MPA is refused for mPa and MPa.
    """
    if dimension == "angular_speed":
        plain = text.translate(_PLAINER).replace(" ", "").casefold()
        if plain in _TURNS:
            return _parsed_unit(_TURNS[plain], dimension)
    text = _ALSO.get(dimension, {}).get(text, text)
    try:
        return _parsed_unit(text, dimension)
    except UnitError:
        found = _mended(text, dimension)
        if found is None:
            raise
        return found


def _mended(text: str, dimension: Dimension) -> _Unit | None:
    """The only unit of a quantity that a text is but for its case; None of others."""
    folded = text.translate(_PLAINER).replace(" ", "").casefold()
    found = {
        _parsed_unit(name, dimension)
        for name in (*_COMMON[dimension], *_PLATES.get(dimension, ()))
        if name.translate(_PLAINER).replace(" ", "").casefold() == folded
    }
    return found.pop() if len(found) == 1 else None


@lru_cache(maxsize=1024)
def _parsed_unit(text: str, dimension: Dimension) -> _Unit:
    """Return any unit of a quantity, by way of pint."""
    common = _COMMON[dimension].get(text)
    if common is not None:
        return common
    import pint

    names = _factors(text, dimension)
    if dimension == "temperature" and (len(names) > 1 or names[0][2] != 1):
        raise _wrong_dimension(text, dimension)  # a scale with an offset has no powers
    registry = _registry()
    for _, name, _ in names:
        if not _is_known(registry, name):
            raise _unknown(name, dimension)
    expression = "".join(f"{operator}{name}**{power}" for operator, name, power in names)
    try:  # a scale with an offset has no prefixes either
        zero, one = (registry.Quantity(Fraction(n), expression.lstrip("*")) for n in (0, 1))
        offset = Fraction(zero.m_as(_pint_name(SI_UNIT[dimension])))
        scale = Fraction(one.m_as(_pint_name(SI_UNIT[dimension]))) - offset
    except pint.PintError:
        raise _wrong_dimension(text, dimension) from None
    return _Unit(scale, offset)


def _factors(text: str, dimension: Dimension) -> list[tuple[str, str, int]]:
    """Return operator, name and power of each factor of a unit.

    The grammar is read here, not by pint, whose parser would evaluate arithmetic.
    """
    plain = _HYPHEN.sub("*", text).translate(_PLAINER)
    plain = plain.replace("°C", "degC").replace("°F", "degF")
    if dimension in ("force", "moment"):
        plain = re.sub(_POUND, "lbf", plain)
    plain = plain.replace("°", "deg")
    if SI_UNIT[dimension].startswith("1/"):
        plain = re.sub(_ONE_OVER, r"\1^-1", plain, count=1)
    factors: list[tuple[str, str, int]] = []
    position = 0
    while position < len(plain):
        match = _FACTOR.match(plain, position)
        if match is None or (position == 0 and match[1]):
            raise _unknown(text, dimension)
        factors.append((match[1] or "*", match[2], int(match[3] or 1)))
        position = match.end()
    return factors


def _is_known(registry: pint.UnitRegistry[Fraction], name: str) -> bool:
    """Return whether a name is a unit; a plural only of a unit written in full.

    Without that, "Ns" would pass for newtons.
    """
    return any(
        not plural or name == f"{prefix}{unit}{plural}"
        for prefix, unit, plural in registry.parse_unit_name(name)
    )


@lru_cache(maxsize=1)
def _registry() -> pint.UnitRegistry[Fraction]:
    """Return a registry of our own few units: the stock one takes a third of a second."""
    import pint

    with resources.as_file(resources.files("rolamento") / "data" / "units.txt") as path:
        return pint.UnitRegistry(path, non_int_type=Fraction)


def _pint_name(unit: str) -> str:
    return unit.replace("^", "**").replace(" ", "*")


def _unknown(name: str, dimension: Dimension) -> UnitError:
    usual = usual_units(dimension)
    known = {
        "name": shown(name),
        "near": nearest(name, usual),
        "dimension": name_of(dimension),
        "usual": ", ".join(usual),
    }
    rule = (
        said(
            "{name} is not a known unit; did you mean {near}? (units of {dimension}: {usual} …)",
            **known,
        )
        if known["near"]
        else said("{name} is not a known unit (units of {dimension}: {usual} …)", **known)
    )
    return UnitError(rule, example=_example(dimension))


def _wrong_dimension(text: str, dimension: Dimension) -> UnitError:
    return UnitError(
        said(
            "{text} is not a unit of {dimension} (units of {dimension}: {known} …)",
            text=shown(text),
            dimension=name_of(dimension),
            known=", ".join(usual_units(dimension)),
        ),
        example=_example(dimension),
    )


def usual_units(dimension: Dimension) -> list[str]:
    """Return the units that case files usually have of a dimension, as they are written there."""
    return list(_COMMON[dimension])


def _example(dimension: Dimension) -> str:
    return f'"{_EXAMPLE_NUMBERS.get(dimension, "10")} {usual_units(dimension)[0]}"'


def name_of(dimension: Dimension) -> str:
    """Return what a quantity is called, as it is said."""
    return said(_NAMES[dimension])


_EXAMPLE_NUMBERS: Final[dict[Dimension, str]] = {
    "length": "22.23",
    "angle": "40",
    "angular_speed": "10000",
    "stress": "207",
    "density": "7810",
    "kinematic_viscosity": "68",
    "pressure_viscosity_coefficient": "20",
    "thermal_conductivity": "0.14",
    "thermal_expansion": "0.0007",
    "velocity": "1.8",
    "power": "45",
    "flow_rate": "0.5",
    "electric_current": "0.5",
    "voltage": "10",
    "frequency": "2",
    "heat_capacity": "400",
}
