"""What a user would write instead: lives in plain Python, case by case, and scipy's quadrature.

Nothing here is shared with the engine. Ratings, angle and oil are given, so that a loop over balls
and a few formulas are all there is to it.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass

from scipy.integrate import dblquad
from scipy.optimize import minimize_scalar


@dataclass(frozen=True, slots=True)
class PlainBearing:
    """A single row at 40°; N, mm and mm²/s."""

    balls: int
    ball: float
    pitch: float
    inner: float
    outer: float
    angle: float
    dynamic: float
    fatigue: float
    viscosity: float
    clean: float
    reliability: float


def lives(
    bearing: PlainBearing,
    inner: Sequence[float],
    outer: Sequence[float],
    axial: float,
    radial: float,
    rpm: float,
) -> dict[str, float]:
    """Lives of one case by the theories, millions of revolutions."""
    load = radial if axial <= 1.14 * radial else 0.35 * radial + 0.57 * axial
    basic = (bearing.dynamic / load) ** 3
    risk = math.log(1.0 / bearing.reliability) / math.log(1.0 / 0.9)
    a_1 = 0.95 * risk ** (2.0 / 3.0) + 0.05
    needed = 45000.0 * rpm**-0.83 if rpm < 1000.0 else 4500.0 * rpm**-0.5
    kappa = bearing.viscosity * math.sqrt(bearing.pitch) / needed
    reference = reference_life(bearing, inner, outer)
    equivalent = bearing.dynamic / reference ** (1.0 / 3.0)
    return {
        "iso281": a_1 * basic,
        "iso281_modified": a_1 * basic * a_iso(bearing, kappa, load),
        "iso16281": a_1 * reference,
        "iso16281_modified": a_1 * reference * a_iso(bearing, kappa, equivalent),
        "iso281_1990": risk ** (2.0 / 3.0) * basic,
    }


def reference_life(bearing: PlainBearing, inner: Sequence[float], outer: Sequence[float]) -> float:
    """L_10r, the inner ring turning."""
    gamma = bearing.ball * math.cos(bearing.angle) / bearing.pitch
    f_i, f_o = bearing.inner, bearing.outer
    grooves = f_i / f_o * (2.0 * f_o - 1.0) / (2.0 * f_i - 1.0)
    ratio = 1.044 * ((1.0 - gamma) / (1.0 + gamma)) ** 1.72 * grooves**0.41
    one = bearing.dynamic / (bearing.balls * math.cos(bearing.angle))
    rated_inner = one / 0.407 * (1.0 + ratio ** (10.0 / 3.0)) ** 0.3
    rated_outer = one / 0.389 * (1.0 + ratio ** (-10.0 / 3.0)) ** 0.3
    turning = (sum(q**3 for q in inner) / len(inner)) ** (1.0 / 3.0)
    standing = (sum(q ** (10.0 / 3.0) for q in outer) / len(outer)) ** 0.3
    power = -10.0 / 3.0
    return ((rated_inner / turning) ** power + (rated_outer / standing) ** power) ** -0.9


def a_iso(bearing: PlainBearing, kappa: float, load: float) -> float:
    """The factor of radial ball bearings; NaN below κ = 0.1."""
    if kappa < 0.1:
        return math.nan
    kappa = min(kappa, 4.0)
    if kappa < 0.4:
        c, p = 2.2649, 0.054381
    else:
        c, p = 1.9987, 0.19087 if kappa < 1.0 else 0.071739
    strength = (bearing.clean * bearing.fatigue / load) ** (1.0 / 3.0)
    left = 1.0 - (2.5671 - c / kappa**p) ** 0.83 * strength
    return 50.0 if left <= 0.0 else min(0.1 * left**-9.3, 50.0)


def stress_integral(a: float, b: float, p0: float, limit: float, accuracy: float) -> float:
    """∫∫ ⟨τ - τ_u⟩^(31/3)/z^(7/3) dy dz under a contact, by scipy; in its units."""
    k, threshold = a / b, limit / p0

    def risk(eta: float, zeta: float) -> float:
        if zeta <= 0.0:
            return 0.0
        found = minimize_scalar(
            lambda x: -shear(x, eta * k, zeta, k),
            bounds=(0.0, 1.5 + 1.5 * zeta),
            method="bounded",
            options={"xatol": 1e-3},
        )
        excess = -found.fun - threshold
        return excess ** (31.0 / 3.0) * zeta ** (-7.0 / 3.0) if excess > 0.0 else 0.0

    half, _ = dblquad(risk, 0.0, 6.0, 0.0, 1.5, epsabs=0.0, epsrel=accuracy)
    return 2.0 * half * float(p0 ** (31.0 / 3.0) * a * b ** (-4.0 / 3.0))


def shear(x: float, y: float, z: float, k: float) -> float:
    """|τ_xz| over p0 in units of b, by the confocal ellipsoid."""
    root = max(z * z, x * x + z * z - 1.0)
    for _ in range(60):
        u, v, w = x * x / (1.0 + root), y * y / (k * k + root), z * z / root
        step = (u + v + w - 1.0) / (u / (1.0 + root) + v / (k * k + root) + w / root)
        root += step
        if step <= 1e-12 * root:
            break
    g = math.sqrt((k * k + root) * (1.0 + root) * root)
    h = (x / (1.0 + root)) ** 2 + (y / (k * k + root)) ** 2 + (z / root) ** 2
    return k * x * z * z / (root * (1.0 + root) * g * h)


def infer(
    bore: float,
    outside: float,
    dynamic: float,
    static: float,
    sizes: Sequence[float],
    f_c: Sequence[float],
    f_0: Sequence[float],
) -> tuple[int, float]:
    """Balls and their diameter (mm) of a deep-groove bearing: every combination, one by one."""
    height, mean = 0.5 * (outside - bore), 0.5 * (outside + bore)
    best = (math.inf, 0, 0.0)
    for balls in range(4, 81):
        for ball in sizes:
            if not 0.30 * height < ball < 0.76 * height:
                continue
            for step in range(37):
                pitch = mean * (0.964 + 0.002 * step)
                gamma = ball / pitch
                if not 0.01 <= gamma <= 0.40 or not 0.35 < balls * ball / (math.pi * pitch) < 0.98:
                    continue
                c = 1.3 * at(f_c, gamma, 0.01) * balls ** (2.0 / 3.0)
                c *= ball**1.8 if ball <= 25.4 else 3.647 * ball**1.4
                c_0 = at(f_0, gamma, 0.0) * balls * ball**2
                misfit = (math.log(c / dynamic) / 0.006) ** 2 + (math.log(c_0 / static) / 0.01) ** 2
                misfit += ((pitch / mean - 1.0) / 0.01) ** 2
                best = min(best, (misfit, balls, ball))
    return best[1], best[2]


def at(table: Sequence[float], gamma: float, first: float) -> float:
    """A factor in its table of steps of 0.01."""
    grid = [first + 0.01 * i for i in range(len(table))]
    i = min(max(bisect_right(grid, gamma) - 1, 0), len(table) - 2)
    return table[i] + (table[i + 1] - table[i]) * (gamma - grid[i]) / 0.01


def search(names: Sequence[str], text: str) -> list[str]:
    """The designations that begin with, then those that contain a text, all folded anew."""

    def folded(name: str) -> str:
        return "".join(c for c in name.casefold() if c not in " -/.,_")

    wanted = folded(text)
    found = [(name, folded(name)) for name in names]
    first = [name for name, key in found if key.startswith(wanted)]
    return first + [name for name, key in found if wanted in key and not key.startswith(wanted)]
