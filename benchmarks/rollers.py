"""A tilted NU 205 at speed: the engine, and `scipy.optimize.root` on the same equations.

SciPy's side has the place of the ring and, of every roller, the radial place and the tilt for
unknowns; the slices of all rollers and both races are evaluated at once in NumPy.
"""

from __future__ import annotations

from functools import partial
from typing import Final

import numpy as np
from scipy.optimize import root

import rolamento
from benchmarks.figures import Figure, Findings, alternately, at_least, below
from rolamento.contact.line import contact_constant, slice_places
from rolamento.contact.profile import drop
from rolamento.numerics import FloatArray

GROUP: Final = "rollers: NU 205, 3 mrad, 6000 rpm"
AGREEMENT: Final = 1e-6
"""Greatest difference of displacements and roller loads, over their size."""
TILT: Final = 3e-3
UNIT: Final = 1e-6
"""Of SciPy's unknowns: micrometres and microradians."""


def example(contact: str = "slices") -> rolamento.Case:
    """Its geometry and duty, written out."""
    return rolamento.Case.model_validate(
        {
            "bearing": {
                "element": "cylindrical",
                "roller_count": 13,
                "roller_diameter": "7.5 mm",
                "effective_length": "9 mm",
                "pitch_diameter": "38.5 mm",
                "diametral_clearance": "30 um",
            },
            "duty": {
                "load": {"fz": "4 kN"},
                "displacement": {"ry": f"{TILT} rad", "rz": "0 rad"},
                "inner_speed": "6000 rpm",
            },
            "model": {"roller_contact": contact},
        }
    )


def measure(cases: int, sample: int, repeats: int) -> Findings:
    """Time one case with both laws, a study of many, and SciPy; compare what they find."""
    case, coupled = example(), example("coupled")
    loads = np.linspace(1e3, 6e3, cases)
    study = partial(rolamento.solve, case, {"duty.load.fz": loads})
    few = np.linspace(2e3, 6e3, sample)
    found: list[FloatArray] = []

    def scipy() -> None:
        found[:] = [by_scipy(case, load) for load in few]

    expected = rolamento.solve(case, {"duty.load.fz": few})
    rolamento.solve(coupled)
    one = partial(rolamento.solve, case)
    spent = alternately([one, partial(rolamento.solve, coupled), scipy], 3 * repeats + 1)
    many = alternately([study], 1)[0]
    plain = spent[2] / sample
    findings = Findings.none()
    findings.figures += [
        Figure(GROUP, "35 slices, one call", 1e3 * spent[0], "ms", below(2.0)),
        Figure(GROUP, "35 coupled slices, one call", 1e3 * spent[1], "ms", below(50.0)),
        Figure(GROUP, "a study of 10 000 cases", 1e4 * many / cases, "s", below(20.0)),
        Figure(GROUP, "scipy.optimize.root, one case", 1e3 * plain, "ms"),
        Figure(GROUP, "  the study is faster by", plain * cases / many, "times", at_least(20.0)),
    ]  # fmt: skip
    places = np.array(found)[:, :2]
    own = np.stack([expected.displacement.y, expected.displacement.z], axis=1)
    worst = float(np.abs(places - own).max() / np.abs(own).max())
    worst = max(
        worst, float(np.abs(np.array(found)[:, 2:] - expected.outer.load).max() / few.max())
    )
    if not worst < AGREEMENT:
        findings.failures.append(f"rollers: SciPy's answers differ by up to {worst:.1e}")
    return findings


def by_scipy(case: rolamento.Case, load: float) -> FloatArray:
    """The ring's y and z (m), and the loads of the rollers on the outer race (N)."""
    bearing = case.bearing
    count, diameter = bearing.roller_count, bearing.roller_diameter
    length, pitch = bearing.effective_length, bearing.pitch_diameter
    slices = case.model.slices
    place = slice_places(length, slices)
    crown = drop(bearing.roller_profile, place, length=length, diameter=diameter)
    steel = bearing.ring_material
    modulus = steel.youngs_modulus / (1.0 - steel.poisson_ratio**2)
    constant = float(contact_constant(length, modulus)) / slices
    azimuth = 2.0 * np.pi * np.arange(count) / count
    cosine, sine = np.cos(azimuth), np.sin(azimuth)
    mass = 0.25 * np.pi * diameter**2 * bearing.roller_length * bearing.roller_material.density
    orbit = 0.5 * case.duty.inner_speed * (1.0 - diameter / pitch)
    thrown = 0.5 * mass * pitch * orbit**2
    gap = 0.25 * bearing.diametral_clearance
    tilt = TILT * cosine

    def loads(unknowns: FloatArray) -> tuple[FloatArray, FloatArray]:
        ring, own = UNIT * unknowns[:2], UNIT * unknowns[2:].reshape(2, count)
        toward = ring[0] * sine + ring[1] * cosine
        outer = own[0][:, np.newaxis] - own[1][:, np.newaxis] * place - crown - gap
        inner = (
            (toward - own[0])[:, np.newaxis] - (tilt - own[1])[:, np.newaxis] * place - crown - gap
        )
        return tuple(constant * np.maximum(one, 0.0) ** (10 / 9) for one in (inner, outer))

    def unbalanced(unknowns: FloatArray) -> FloatArray:
        inner, outer = loads(unknowns)
        radial = inner.sum(axis=1) + thrown - outer.sum(axis=1)
        moment = (outer - inner) @ place
        force = inner.sum(axis=1)
        return np.concatenate([[force @ sine, force @ cosine - load], radial, moment / length])

    # the loaded rollers begin half way in, the others on the outer race
    inward = 0.5 * bearing.diametral_clearance + 15e-6
    start = np.concatenate(
        [[0.0, inward], np.maximum(0.5 * inward * cosine, gap + 1e-7), 0.5 * tilt]
    ) / UNIT  # fmt: skip
    found = root(unbalanced, start, method="hybr", tol=1e-12)
    if not np.abs(unbalanced(found.x)).max() < 1e-5 * load:
        found = root(unbalanced, found.x, method="lm", tol=1e-12)
    return np.concatenate([UNIT * found.x[:2], loads(found.x)[1].sum(axis=1)])
