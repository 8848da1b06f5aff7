"""How much grease a bearing gets when it is relubricated.

    SKF    G = 0.005 D B from the side, 0.002 D B through a groove and holes of the outer ring
    FAG    m_1 = D B x, x = 0.002 weekly, 0.003 monthly, 0.004 yearly

in g, with D and B in mm. Sources: in data/grease.toml.
"""

from __future__ import annotations

from typing import Literal

from rolamento.grease.estimate import MILLIMETRES, figures

__all__ = ["fag_amount", "skf_amount"]

_GRAM = 1e-3
_WEEK, _MONTH = 168.0, 730.0


def skf_amount(
    outside_diameter: float, width: float, way: Literal["side", "middle"] = "side"
) -> float:
    """Amount of grease of one relubrication by SKF; kg.

    Parameters
    ----------
    outside_diameter, width
        D and B, or the height of a thrust bearing; m.
    way
        ``"side"``, or ``"middle"`` through the outer ring.

    SKF, Rolling bearings, relubrication.

    >>> print(f"{1e3 * skf_amount(0.110, 0.027):.2f} g")
    14.85 g
    """
    share = figures()["amount"]["skf"][way]
    return float(_GRAM * share * outside_diameter * width * MILLIMETRES**2)


def fag_amount(outside_diameter: float, width: float, interval: float) -> float:
    """Amount of grease of one relubrication by FAG; kg.

    Parameters
    ----------
    outside_diameter, width
        D and B; m.
    interval
        After which the bearing is relubricated, h: to a week, to a month, longer.

    FAG, Rolling Bearing Lubrication (WL 81 115).

    >>> print(f"{1e3 * fag_amount(0.110, 0.027, 3000.0):.2f} g")
    11.88 g
    """
    data = figures()["amount"]["fag"]
    how = "weekly" if interval <= _WEEK else "monthly" if interval <= _MONTH else "yearly"
    return float(_GRAM * data[how] * outside_diameter * width * MILLIMETRES**2)
