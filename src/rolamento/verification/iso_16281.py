"""Displacements and lives of a reference program for ISO/TS 16281, against the solver at rest.

The standard takes the stiffness of a ball between its races once, at the free contact angle,
however far the angle rises under load. Under radial load at contact angle zero there is nothing to
tell the two apart. Under axial load the bearing of the examples turns from 0° to 13.1°.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from rolamento.case import Case
from rolamento.case.bearing import Bearing
from rolamento.case.duty import Duty, Load
from rolamento.life.iso16281 import race_ratings, reference_life
from rolamento.rows.ball import solve
from rolamento.static import axial_load
from rolamento.verification.check import Check, half_unit
from rolamento.verification.published import MM, bearing_of, published, steel

__all__ = ["bearing", "checks", "life"]

_PER_MICROMETRE: Final = 1e6
_PRECISION: Final = 1e-5
"""Relative, of the reference program: its elliptic integrals are approximate."""
_LIFE_PRECISION: Final = 1e-4
"""Relative, of its lives: loads to about 1e-5 and less, and the life goes with their cube."""
_FROZEN_LIFE: Final = 2e-4
"""Relative: what the stiffness of the loaded angle makes of the life."""
_FROZEN_DEVIATION: Final = 1e-4
"""Relative: the most that the stiffness of the loaded angle may make of it."""

_APPROXIMATE: Final = (
    "The tolerance is 1e-5 of the number where that is more than half a digit: the reference"
    " program approximates the elliptic integrals."
)
_FROZEN: Final = (
    "The standard keeps the contact stiffness of the free contact angle, 0°, while the angle rises"
    " to 13.1°, which makes less than 1e-4 of the number. Tolerance as for radial load."
)
_APPROXIMATE_LOADS: Final = (
    "The program balances its ball loads to some 1e-5, of which the life takes the cube: tolerance"
    " 1e-4."
)
_FROZEN_ANGLE: Final = (
    "With the contact stiffness of the free contact angle, as the standard keeps it, the balls"
    " stand 0.0006° steeper and carry less. Tolerance 3e-5: the cube of 1e-5 in the loads."
)


def bearing(clearance_mm: float) -> Bearing:
    """Return the bearing of the examples, with a clearance in mm."""
    given = published("iso_16281")["bearing"]
    material = steel(given["youngs_modulus_GPa"] * 1e9, given["poisson_ratio"])
    return bearing_of(given, material, diametral_clearance=clearance_mm * MM)


def checks() -> Iterator[Check]:
    """Compare displacement and life of all examples."""
    data = published("iso_16281")
    for example in data["radial"]["example"]:
        state = solve(_case(example["clearance_mm"], Load(fz=example["load_N"])))
        yield Check(
            source=data["radial"]["source"],
            quantity=f"δ_r, P_d = {example['clearance_mm']:g} mm",
            unit="µm",
            printed=example["displacement_um"],
            computed=state.displacement.z * _PER_MICROMETRE,
            tolerance=_tolerance(example["displacement_um"]),
            explanation=_APPROXIMATE,
        )
        yield Check(
            source=data["radial"]["source"],
            quantity=f"L_10r, P_d = {example['clearance_mm']:g} mm",
            unit="10⁶",
            printed=example["life_million"],
            computed=life([ball.inner.load for ball in state.balls]),
            tolerance=_LIFE_PRECISION * float(example["life_million"]),
            explanation=_APPROXIMATE_LOADS,
        )
    example = data["axial"]
    state = solve(_case(example["clearance_mm"], Load(fx=example["load_N"])))
    frozen = axial_load(bearing(example["clearance_mm"]), example["load_N"], stiffness_angle="free")
    yield Check(
        source=data["axial"]["source"],
        quantity="δ_a",
        unit="µm",
        printed=example["displacement_um"],
        computed=state.displacement.x * _PER_MICROMETRE,
        tolerance=_tolerance(example["displacement_um"]),
        explanation=_FROZEN,
        evidence=float(frozen.axial_displacement) * _PER_MICROMETRE,
        deviation=_FROZEN_DEVIATION * float(example["displacement_um"]),
    )
    printed = example["life_million"]
    yield Check(
        source=data["axial"]["source"],
        quantity="L_10r",
        unit="10⁶",
        printed=printed,
        computed=life([ball.inner.load for ball in state.balls]),
        tolerance=3.0 * _PRECISION * float(printed),
        explanation=_FROZEN_ANGLE,
        evidence=life([float(frozen.ball_load)] * len(state.balls)),
        deviation=_FROZEN_LIFE * float(printed),
    )


def life(loads: list[float]) -> float:
    """Return the reference life of the examples' bearing under ball loads (N); 10⁶ revolutions."""
    given = published("iso_16281")["bearing"]
    ratings = race_ratings(
        given["dynamic_rating_N"],
        given["ball_count"],
        given["ball_diameter_mm"] * MM,
        given["pitch_diameter_mm"] * MM,
        given["inner_conformity"],
        given["outer_conformity"],
        0.0,
    )
    return float(reference_life([loads], [loads], ratings).life[0])


def _case(clearance_mm: float, load: Load) -> Case:
    return Case(bearing=bearing(clearance_mm), duty=Duty(load=load))


def _tolerance(printed: str) -> float:
    return max(half_unit(printed), _PRECISION * float(printed))
