"""What is misprinted in a publication: each equation with its derivation and a numerical proof.

Equations are evaluated at random attitudes, beside the same quantity from vectors in space. A
residual is the distance of the two over the greatest term, attitude by attitude.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from rolamento_reproductions.text import Text

__all__ = [
    "ERRATA_STEM",
    "Errata",
    "Misprint",
    "Proof",
    "Residual",
    "Sound",
    "power_above",
    "power_text",
    "proven",
    "residual",
]

Floats = NDArray[np.float64]

ERRATA_STEM: Final = "misprints"
"""Name of the page's files without an ending."""


@dataclass(frozen=True, slots=True)
class Residual:
    """How far an equation is from the truth at random attitudes: in the middle, and at most."""

    median: float
    greatest: float


def residual(form: Floats, truth: Floats, scale: Floats) -> Residual:
    """Compare an equation with the truth.

    Parameters
    ----------
    form, truth
        Of one shape, attitudes first.
    scale
        The size of what is compared, above zero, (attitudes,).
    """
    gap = np.abs(form - truth).reshape(len(scale), -1).max(axis=1) / scale
    return Residual(float(np.median(gap)), float(gap.max()))


def power_above(value: float) -> float:
    """Return the power of ten above a residual, at least 1e-15: what stands of rounding."""
    return float(10.0 ** np.ceil(np.log10(max(value, 1e-15)) + 1e-9))


def power_text(value: float) -> str:
    """Return that power as people write it: ``"10⁻¹⁴"``."""
    exponent = round(float(np.log10(power_above(value))))
    return "10" + str(exponent).translate(_RAISED)


_RAISED: Final = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


@dataclass(frozen=True, slots=True)
class Misprint:
    """One equation, or statement of the text, that does not hold as it is printed.

    number: of the equation, "" for a statement; place: where it stands, for a reader; what: the
    quantity; printed and corrected: as formulas; proof: residuals of both.
    """

    number: str
    place: Text
    what: Text
    printed: Text
    corrected: Text
    derivation: Text
    printed_residual: Residual
    corrected_residual: Residual


@dataclass(frozen=True, slots=True)
class Sound:
    """An equation that was checked likewise and holds as printed."""

    number: str
    what: Text
    form: Text
    residual: Residual


@dataclass(frozen=True, slots=True)
class Errata:
    """The misprints of a publication, and what was checked and is right.

    remarks: on axes and symbols, before the list; attitudes: how many the proofs rest on.
    """

    caption: Text
    source: Text
    remarks: tuple[Text, ...]
    misprints: tuple[Misprint, ...]
    sound: tuple[Sound, ...]
    attitudes: int

    @property
    def stem(self) -> str:
        """Its files' name without an ending."""
        return ERRATA_STEM


@dataclass(frozen=True, slots=True, eq=False)
class Proof:
    """A quantity at random attitudes: as printed, as corrected, and from vectors.

    Arrays (attitudes, ...) of one shape; scale: (attitudes,), the size of what is compared.
    """

    printed: Floats
    corrected: Floats
    truth: Floats
    scale: Floats


def proven(
    place: tuple[str, Text],
    what: Text,
    forms: tuple[Text, Text],
    derivation: Text,
    proof: Proof,
) -> Misprint:
    """Put a misprint together with the residuals of its proof.

    Parameters
    ----------
    place
        Number of the equation, "" if it has none, and where it stands.
    what
        The quantity.
    forms
        As printed, and as corrected.
    derivation
        In words and formulas.
    proof
        The numbers.
    """
    return Misprint(
        number=place[0],
        place=place[1],
        what=what,
        printed=forms[0],
        corrected=forms[1],
        derivation=derivation,
        printed_residual=residual(proof.printed, proof.truth, proof.scale),
        corrected_residual=residual(proof.corrected, proof.truth, proof.scale),
    )
