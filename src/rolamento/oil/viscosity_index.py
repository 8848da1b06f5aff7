"""The viscosity index: how little an oil thins between 40 and 100 °C.

Plain numbers: an index belongs to one oil. Viscosities in m²/s.
"""

from __future__ import annotations

from math import inf, log10
from typing import Final

from rolamento._reach import in_reach

LEAST_VISCOSITY: Final = 2e-6
"""m²/s at 100 °C; the index is not defined below."""
GREATEST_INDEX: Final = 400.0

# From Y mm²/s at 100 °C on: a, b, c of L = a Y² + b Y + c, and d, e, f of H likewise.
_COEFFICIENTS: Final = (
    (2.0, 1.14673, 1.7576, -0.109, 0.84155, 1.5521, -0.077),
    (3.8, 3.38095, -15.4952, 33.196, 0.78571, 1.7929, -0.183),
    (4.4, 2.5, -7.2143, 13.812, 0.82143, 1.5679, 0.119),
    (5.0, 0.101, 16.635, -45.469, 0.04985, 9.1613, -18.557),
    (6.4, 3.35714, -23.5643, 78.466, 0.22619, 7.7369, -16.656),
    (7.0, 0.01191, 21.475, -72.870, 0.79762, -0.7321, 14.61),
    (7.7, 0.41858, 16.1558, -56.040, 0.05794, 10.5156, -28.240),
    (9.0, 0.88779, 7.5527, -16.600, 0.26665, 6.7015, -10.810),
    (12.0, 0.7672, 10.7972, -38.180, 0.20073, 8.4658, -22.490),
    (15.0, 0.97305, 5.3135, -2.200, 0.28889, 5.9741, -4.930),
    (18.0, 0.97256, 5.25, -0.980, 0.24504, 7.416, -16.730),
    (22.0, 0.91413, 7.4759, -21.820, 0.20323, 9.1267, -34.230),
    (28.0, 0.87031, 9.7157, -50.770, 0.18411, 10.1015, -46.750),
    (40.0, 0.84703, 12.6752, -133.310, 0.17029, 11.4866, -80.620),
    (55.0, 0.85921, 11.1009, -83.19, 0.1713, 11.368, -76.940),
    (70.0, 0.83531, 14.6731, -216.246, 0.16841, 11.8493, -96.947),
)
_MM2: Final = 1e6
_HALVINGS: Final = 80


def viscosity_index(viscosity_40: float, viscosity_100: float) -> float:
    """Viscosity index from the kinematic viscosities at 40 and 100 °C, m²/s; not rounded.

    NaN below 2 mm²/s at 100 °C. ISO 2909, ASTM D2270, with the polynomials that the latter gives
    for its table: good to about a unit of the index.
    """
    u = float(in_reach(viscosity_40, "viscosity_40", "m²/s", 1e-9, 1.0)) * _MM2
    y = float(in_reach(viscosity_100, "viscosity_100", "m²/s", 1e-9, 1.0)) * _MM2
    if not y >= LEAST_VISCOSITY * _MM2:
        return float("nan")
    low, high = reference_viscosities(y)
    if u >= high:
        return 100.0 * (low - u) / (low - high)
    exponent = log10(high / u) / log10(y)
    return float((10.0**exponent - 1.0) / 0.00715 + 100.0)


def reference_viscosities(viscosity_100: float) -> tuple[float, float]:
    """L and H: at 40 °C, of oils of index 0 and 100 that have this viscosity at 100 °C; mm²/s.

    ASTM D2270, appendix X2.
    """
    y = float(in_reach(viscosity_100, "viscosity_100", "mm²/s", LEAST_VISCOSITY * _MM2, 1e6))
    a, b, c, d, e, f = next(line[1:] for line in reversed(_COEFFICIENTS) if y >= line[0])
    return (a * y + b) * y + c, (d * y + e) * y + f


def viscosity_100_of_index(viscosity_40: float, index: float) -> float:
    """Kinematic viscosity at 100 °C of an oil given at 40 °C by its viscosity index; m²/s.

    NaN where it would be below 2 mm²/s. The inverse of `viscosity_index`, by bisection: the index
    rises with the viscosity at 100 °C.
    """
    least, most = LEAST_VISCOSITY, viscosity_40
    if not viscosity_index(viscosity_40, least) <= index < inf or most <= least:
        return float("nan")
    for _ in range(_HALVINGS):
        middle = 0.5 * (least + most)
        if viscosity_index(viscosity_40, middle) < index:
            least = middle
        else:
            most = middle
    return 0.5 * (least + most)
