"""What preloaded sets and ceramic balls make of the limiting speed of a single bearing.

A spindle bearing that is listed alone, with steel balls and preloaded by a spring, runs at

    n = n_listed f_n2 f_n4

in other conditions: f_n2 of its arrangement and its preload, f_n4 = 1.25 with balls of silicon
nitride. Makers give these as guidance; they are of angular-contact ball bearings. Where the
preload is not known, the columns of a maker's catalogue for bearings side by side count.

Source: data/speeds.toml (GMN; NSK, E1102).
"""

from __future__ import annotations

from typing import Final, Literal, NamedTuple

from rolamento.io.data import toml_of

__all__ = ["SpeedFactor", "ceramic_factor", "set_factor"]

FactorName = Literal["ceramic", "matched", "spring", "rigid_pair", "rigid_set"]
_PAIR: Final = 2


class SpeedFactor(NamedTuple):
    """A factor on the limiting speed of a single bearing with steel balls.

    Attributes
    ----------
    name
        ``"ceramic"`` (f_n4), ``"spring"``, ``"rigid_pair"`` or ``"rigid_set"`` (f_n2), or
        ``"matched"``: side by side, with a preload that is not known.
    value
        Of the speed.
    level
        Of the preload of a rigid set; else empty.
    """

    name: FactorName
    value: float
    level: str = ""


def ceramic_factor() -> SpeedFactor:
    """Return f_n4, of spindle bearings with balls of silicon nitride. GMN."""
    return SpeedFactor("ceramic", toml_of("speeds")["factors"]["ceramic"])


def set_factor(bearings: int, preload: str | None) -> SpeedFactor:
    """Return f_n2 of angular-contact bearings side by side. GMN; NSK, E1102, columns DB, DF, DT.

    Parameters
    ----------
    bearings
        How many, two or more.
    preload
        ``"spring"``, or the level of a rigid preload: ``"light"``, ``"medium"`` or ``"heavy"``.
        None, or a level that the source does not have, gives the factor of matched bearings.
    """
    data = toml_of("speeds")
    if preload == "spring" and bearings == _PAIR:
        return SpeedFactor("spring", data["factors"]["spring"])
    name: FactorName = "rigid_pair" if bearings == _PAIR else "rigid_set"
    value = data["factors"][name].get(preload)
    if value is None:
        return SpeedFactor("matched", data["classes"]["matched"])
    return SpeedFactor(name, value, str(preload))
