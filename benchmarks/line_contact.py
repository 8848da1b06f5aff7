"""A roller on a race, its slices coupled: the kernel, and NumPy with `scipy.linalg.solve`.

SciPy's side takes half widths for known, builds the influence by quadrature, solves for the loads
of the slices in contact, lets go those that pull, takes in those that overlap, and begins again
with the new half widths until they stay.
"""

from __future__ import annotations

from functools import partial
from typing import Final

import numpy as np
from scipy.linalg import solve

from benchmarks.figures import Figure, Findings, alternately, at_least, below
from rolamento.case.profile import Profile
from rolamento.contact.coupled import body_term, coupled_press, influence_table, scratch
from rolamento.contact.coupled import press_one as kernel
from rolamento.contact.line import half_width, slice_places
from rolamento.contact.profile import drop
from rolamento.numerics import FloatArray

GROUP: Final = "line contact, 35 coupled slices"
MODULUS: Final = 207e9 / (1.0 - 0.3**2)
DIAMETER, LENGTH, SLICES = 7.5e-3, 9e-3, 35
CURVATURE: Final = 2.0 / DIAMETER + 2.0 / 31e-3
AGREEMENT: Final = 1e-5
"""Greatest difference of the loads per length, over the greatest."""
_NODES: Final = 40
_ROUNDS: Final = 60

PLACE: Final = slice_places(LENGTH, SLICES)
DROP: Final = drop(Profile(kind="iso"), PLACE, length=LENGTH, diameter=DIAMETER)


def duties(count: int) -> FloatArray:
    """Approach (m) and tilt of so many contacts, as a Newton's method asks for them in turn."""
    turn = np.linspace(0.0, 1.0, count)
    return np.stack([8e-6 + 6e-6 * turn, 1e-3 + 2e-3 * turn], axis=1)


def measure(contacts: int, sample: int, repeats: int) -> Findings:
    """Time both, and compare the loads that they find."""
    asked = duties(contacts)
    warm, cold = (partial(_by_kernel, asked, known) for known in (True, False))
    warm()
    few = asked[:: max(1, contacts // sample)]
    found: list[FloatArray] = []

    def scipy() -> None:
        found[:] = [by_scipy(*one) for one in few]

    spent = alternately([warm, cold, scipy], repeats)
    one, first, plain = spent[0] / contacts, spent[1] / contacts, spent[2] / len(few)
    findings = Findings.none()
    findings.figures += [
        Figure(GROUP, "from the last answer", 1e6 * one, "µs", below(100.0)),
        Figure(GROUP, "from nothing", 1e6 * first, "µs", below(200.0)),
        Figure(GROUP, "NumPy and scipy.linalg.solve", 1e6 * plain, "µs"),
        Figure(GROUP, "  the kernel is faster by", plain / first, "times", at_least(20.0)),
    ]
    worst = max(
        float(np.abs(own - other).max() / own.max())
        for own, other in zip((by_engine(*one) for one in few), found, strict=True)
    )
    if not worst < AGREEMENT:
        findings.failures.append(f"line contact: SciPy's loads differ by up to {worst:.1e}")
    return findings


def by_engine(approach: float, tilt: float) -> FloatArray:
    """Loads per length; N/m."""
    return coupled_press(
        approach, tilt, DROP, effective_length=LENGTH, curvature=CURVATURE, modulus=MODULUS,
        roller_diameter=DIAMETER,
    ).load_per_length  # fmt: skip


def _by_kernel(asked: FloatArray, known: bool) -> None:
    load, answer, room = np.zeros(SLICES), np.empty(6), scratch(SLICES)
    width = LENGTH / SLICES
    body = body_term(SLICES, width, DIAMETER, 0.5)
    curvature, table = np.full(SLICES, CURVATURE), influence_table(SLICES)
    for approach, tilt in asked:
        if not known:
            load[:] = 0.0
        kernel.compiled(
            approach, tilt, PLACE, DROP, width, 2.0 / (np.pi * MODULUS), curvature, table, body,
            load, room, answer,
        )  # fmt: skip


def by_scipy(approach: float, tilt: float) -> FloatArray:
    """Loads per length; N/m."""
    depth = approach + tilt * PLACE - DROP
    load = np.maximum(depth, 0.0) * np.pi * MODULUS / 24.0
    for _ in range(_ROUNDS):
        before, influence = load, _influence(half_width(load, CURVATURE, MODULUS))
        pressed, load = before > 0.0, np.zeros(SLICES)
        load[pressed] = solve(influence[np.ix_(pressed, pressed)], depth[pressed])
        load = np.maximum(load, 0.0)
        overlap = np.where(pressed, 0.0, depth - influence @ load)
        load += np.maximum(overlap, 0.0) * np.pi * MODULUS / 24.0
        if np.abs(load - before).max() < 0.1 * AGREEMENT * load.max():
            return load
    return np.full_like(load, np.nan)


def _influence(width_of: FloatArray) -> FloatArray:
    """Displacement in the middle of each slice by a unit load on each; (slices, slices)."""
    node, weight = np.polynomial.legendre.leggauss(_NODES)
    angle = 0.25 * np.pi * (node + 1.0)
    # with the fourth power of the angle the logarithm in the slice itself is smooth
    angle, weight = angle * (angle / (0.5 * np.pi)) ** 3, weight * (angle / (0.5 * np.pi)) ** 3
    mean = weight * np.cos(angle) ** 2 * 4.0
    b = np.maximum(width_of, 1e-3 * LENGTH / SLICES)
    across = b[:, np.newaxis] * np.sin(angle)
    step = np.abs(PLACE[:, np.newaxis] - PLACE)[..., np.newaxis]
    half = 0.5 * LENGTH / SLICES
    total = (np.arcsinh((step + half) / across) - np.arcsinh((step - half) / across)) @ mean
    image = DIAMETER / np.e
    away = np.arcsinh((step + half) / image) - np.arcsinh((step - half) / image)
    return 2.0 / (np.pi * MODULUS) * (total - 0.5 * away[..., 0])
