"""One published number beside the computed one, and the verdict.

A number that disagrees is not excused by words. Its explanation is put to the test as well: either
the program must give the printed number once it makes the author's choice, or the number that
should have been printed must follow from the publication itself (or be printed by another) and the
program must give that one. In both cases the explanation bounds by how much the print may be off.

Reads what was published: data files with the package, and the bearings that they describe.
"""

from __future__ import annotations

from collections.abc import Mapping
from decimal import ROUND_DOWN, ROUND_HALF_UP, Decimal
from math import isfinite, isnan, nan, radians, sqrt
from typing import Any, Final, Literal

from rolamento.case.bearing import Bearing
from rolamento.case.material import Material
from rolamento.io.data import toml_of
from rolamento.io.json import plain
from rolamento.records import frozen
from rolamento.units import MILLIMETRE
from rolamento.words import Note

CheckVerdict = Literal["agrees", "explained", "fails"]
VERDICTS: Final[tuple[CheckVerdict, ...]] = ("agrees", "explained", "fails")

_ROUNDING: Final = 1e-9
"""Fraction of a tolerance: so that a number that ends in a five is not lost to binary
arithmetic."""


@frozen(kw_only=True)
class Check:
    """A published number, what the program gives for it, and how near that has to be.

    Attributes
    ----------
    source
        Short citation with table, page or example.
    quantity
        With its symbol.
    unit
        Of all numbers of the check; empty where there is none.
    printed
        The published number, as text that keeps its digits.
    computed
        What the program gives, by its own models; NaN where there is no result.
    tolerance
        What the print supports; half a unit of its last digit if not given.
    explanation
        Why the two differ, or which choice the source does not state; None if there is nothing to
        explain.
    evidence
        What proves the explanation: the number that the program gives when it makes the author's
        choice, or, with `corrected`, what the publication's other numbers give.
    corrected
        The number that should have been printed, as text, where the print is known to be wrong.
    deviation
        The most by which the explanation says that the print is off: from the corrected number if
        there is one, else from the computed one.
    """

    source: str
    quantity: str
    unit: str
    printed: str
    computed: float
    tolerance: float = nan
    explanation: Note | None = None
    evidence: float | None = None
    corrected: str = ""
    deviation: float = 0.0

    def __post_init__(self) -> None:
        if isnan(self.tolerance):
            object.__setattr__(self, "tolerance", half_unit(self.printed))

    @property
    def difference(self) -> float:
        """Computed less printed."""
        return self.computed - float(self.printed)

    @property
    def verdict(self) -> CheckVerdict:
        """Whether the number agrees, or its deviation is explained and the explanation holds."""
        if not self._proved():
            return "fails"
        if _near(self.computed, self.printed, self.tolerance):
            return "agrees"
        return "explained" if self._explained() else "fails"

    def to_mapping(self) -> dict[str, Any]:
        """Give the check as a plain mapping; NaN as None."""
        mapping = {
            "source": self.source,
            "quantity": self.quantity,
            "unit": self.unit,
            "printed": self.printed,
            "computed": self.computed,
            "difference": self.difference,
            "tolerance": self.tolerance,
            "verdict": self.verdict,
            "evidence": self.evidence,
            "corrected": self.corrected or None,
        }
        explanation = None if self.explanation is None else self.explanation.to_mapping()
        return {key: plain(value) for key, value in mapping.items()} | {"explanation": explanation}

    def _proved(self) -> bool:
        """Return whether the evidence, if there is any, gives the number that it must give."""
        if self.evidence is None:
            return True
        if self.corrected:
            return _near(self.evidence, self.corrected, half_unit(self.corrected))
        return _near(self.evidence, self.printed, self.tolerance)

    def _explained(self) -> bool:
        """Return whether a number that disagrees does so for the reason given, and as much."""
        if not self.explanation:
            return False
        if not self.corrected:
            known = self.evidence is not None
            return known and _near(self.computed, self.printed, self.deviation)
        right = _near(self.computed, self.corrected, half_unit(self.corrected))
        return right and _near(float(self.printed), self.corrected, self.deviation)


def half_unit(printed: str) -> float:
    """Return half a unit of the last printed digit.

    Raises
    ------
    ValueError
        If the text is not a finite number.
    """
    return float(Decimal(5).scaleb(_last_place(printed) - 1))


def last_unit(printed: str) -> float:
    """Return a unit of the last printed digit; ValueError as `half_unit`."""
    return 2.0 * half_unit(printed)


def cut(value: float, printed: str) -> float:
    """Return the value with the digits beyond the printed ones cut off."""
    return _quantized(value, _last_place(printed), ROUND_DOWN)


def rounded(value: float, printed: str, extra: int = 0) -> float:
    """Return the value rounded to the printed digits and so many more, half away from zero."""
    return _quantized(value, _last_place(printed) - extra, ROUND_HALF_UP)


def _quantized(value: float, place: int, rounding: str) -> float:
    if not isfinite(value):
        return value
    return float(Decimal(value).quantize(Decimal(1).scaleb(place), rounding=rounding))


def _last_place(printed: str) -> int:
    """Return the power of ten of the last printed digit."""
    number = Decimal(printed) if printed.strip() == printed else Decimal("nan")
    exponent = number.as_tuple().exponent
    if not isinstance(exponent, int):
        raise ValueError(f"{printed!r} is not a printed number")
    return exponent


def _near(value: float, printed: str, tolerance: float) -> bool:
    """Return whether a value is near enough; NaN never is."""
    return abs(value - float(printed)) <= tolerance * (1.0 + _ROUNDING)


MODULUS_SCALE: Final = 3.0 / sqrt(8.0)
"""K = √8/3 · E/(1 - ν²) · Σρ^-½ δ*^-3/2 for two bodies of one material."""
_UNKNOWN_DENSITY: Final = 7810.0


def published(name: str) -> Mapping[str, Any]:
    """Return what a source prints, from its data file; not to be changed."""
    return toml_of(name, "rolamento.verification")


def modulus_of_constant(constant: float, poisson_ratio: float) -> float:
    """Return Young's modulus (Pa) that stands behind a printed constant of K in N and mm."""
    return constant * 1e6 * MODULUS_SCALE * (1.0 - poisson_ratio**2)


def steel(
    youngs_modulus: float, poisson_ratio: float, density: float = _UNKNOWN_DENSITY
) -> Material:
    """Return a source's steel; at rest its density does not matter."""
    return Material(
        name="steel", youngs_modulus=youngs_modulus, poisson_ratio=poisson_ratio, density=density
    )


def bearing_of(table: Mapping[str, Any], material: Material, **changes: float | None) -> Bearing:
    """Return the bearing of a data file's table, all of one material.

    Parameters
    ----------
    table
        In mm and degrees, as the sources print.
    material
        Of rings and balls.
    changes
        Fields of `Bearing` to be given instead (SI), None to leave one out.
    """
    fields: dict[str, Any] = {
        "ball_count": table["ball_count"],
        "ball_diameter": table["ball_diameter_mm"] * MILLIMETRE,
        "pitch_diameter": table["pitch_diameter_mm"] * MILLIMETRE,
        "inner_conformity": table["inner_conformity"],
        "outer_conformity": table["outer_conformity"],
        "ring_material": material,
    }
    if "contact_angle_deg" in table:
        fields["contact_angle"] = radians(table["contact_angle_deg"])
    if "diametral_clearance_mm" in table:
        fields["diametral_clearance"] = table["diametral_clearance_mm"] * MILLIMETRE
    fields |= changes
    return Bearing(**{name: value for name, value in fields.items() if value is not None})
