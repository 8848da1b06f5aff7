"""Film and friction of a hundred thousand solved cases, over all of their contacts.

The duty set of `duty_sets.tilts_held` with oil, temperature, roughness and a coefficient of
friction; friction by a closed form, Jones's simplified model, with hysteresis and the oil's
rolling resistance. What is measured begins where the cases are solved. Beside the film stands
what an engineer writes with NumPy and SciPy's elliptic integrals, of one race, whole arrays at once.
"""

from __future__ import annotations

from functools import partial

import numpy as np
from scipy.special import ellipe, ellipk

from benchmarks import duty_sets
from benchmarks.figures import Figure, Findings, alternately, at_least, below
from rolamento import Lubricant
from rolamento.friction import friction
from rolamento.lubrication import film
from rolamento.lubrication.films import Film
from rolamento.numerics import FloatArray
from rolamento.solution import solve
from rolamento.solved import Solved

CASES = 100_000
SECONDS = 1.5
SAMPLE = 4000
AGREEMENT = 1e-9
SURFACE = dict.fromkeys(("inner_roughness", "outer_roughness", "ball_roughness"), 1e-7)


def measure(cases: int = CASES) -> Findings:
    """Film and friction of a solved batch; every case has to have a film and a torque."""
    oil = Lubricant.named("ISO VG 68").replace(friction_coefficient=0.08)
    case = duty_sets.example().replace(
        lubricant=oil, temperature={"lubricant": 343.15}, surface=SURFACE
    )
    random = np.random.default_rng(duty_sets.SEED)
    batch = solve(
        case,
        inner_speed=random.uniform(0.0, 1500.0, cases),
        fx=random.uniform(20e3, 45e3, cases),
        fz=random.uniform(0.0, 18e3, cases),
    )
    of_friction = partial(friction, batch, model="jones_simplified")
    some = batch[: min(cases, SAMPLE)]
    seconds = alternately(
        [partial(film, batch), of_friction, partial(film, some), partial(_plain, some)], 3
    )
    name = f"film and friction, {cases} solved cases"
    both = seconds[0] + seconds[1]
    figures = [
        Figure(name, "film", seconds[0], "s"),
        Figure(name, "friction", seconds[1], "s"),
        Figure(name, "both", both, "s", below(SECONDS) if cases >= CASES else None),
        Figure(name, "rate", cases / both, "cases/s"),
        Figure(name, f"film of {len(some)} cases with NumPy and SciPy", seconds[3], "s"),
        Figure(name, "  the engine is faster by", seconds[3] / seconds[2], "times", at_least(5.0)),
    ]
    found, torque = film(batch), of_friction().torque
    there = np.isfinite(found.outer.central_thickness).any(axis=1)
    missing = cases - int((there & np.isfinite(torque)).sum())
    failures = [f"{name}: {missing} without a result"] if missing else []
    worst = _difference(film(some), _plain(some))
    if not worst < AGREEMENT:
        failures.append(f"{name}: the plain film differs by {worst:.1e}")
    return Findings(figures, [], failures)


def _plain(solved: Solved) -> dict[str, FloatArray]:
    """The central film of both races, (cases, elements), m: Hertz by bisection, powers as such."""
    bearing, oil = solved.case.bearing, film(solved[:1])
    alpha, eta = oil.pressure_viscosity[0], oil.dynamic_viscosity[0]
    d, pitch = bearing.ball_diameter, bearing.pitch_diameter
    steel = bearing.ring_material
    modulus = steel.youngs_modulus / (1.0 - steel.poisson_ratio**2)
    orbit, ball = solved.elements.orbital_speed, solved.elements.ball_speed
    beta, found = solved.elements.attitude, {}
    for race, side, conformity in (
        ("inner", -1.0, bearing.inner_conformity),
        ("outer", 1.0, bearing.outer_conformity),
    ):
        contacts = getattr(solved, race)
        q, angle = contacts.load, contacts.contact_angle
        gamma = d * np.cos(angle) / pitch
        rolling = 2.0 / d / (1.0 + side * gamma)
        across = 2.0 / d - 1.0 / (conformity * d)
        share = (rolling - across) / (rolling + across)
        low, high = np.full_like(q, 1e-6), np.full_like(q, 5.0)
        for _ in range(50):
            u = 0.5 * (low + high)
            k2 = np.exp(2.0 * u)
            first, second = ellipk(1.0 - 1.0 / k2), ellipe(1.0 - 1.0 / k2)
            less = ((k2 + 1.0) * second - 2.0 * first) / ((k2 - 1.0) * second) < share
            low, high = np.where(less, u, low), np.where(less, high, u)
        ring = solved.field(f"duty.{race}_speed")[:, np.newaxis] - orbit
        tangent = np.cos(beta) * np.cos(angle) + np.sin(beta) * np.sin(angle)
        speed = ring * 0.5 * pitch * (1.0 + side * gamma) + side * 0.5 * d * ball * tangent
        u_mean = 0.5 * np.abs(speed)
        film_u = eta * u_mean * rolling / modulus
        film_w = q * rolling**2 / modulus
        h = 2.69 * film_u**0.67 * (alpha * modulus) ** 0.53 * film_w**-0.067
        found[race] = h * (1.0 - 0.61 * np.exp(-0.73 * np.exp(u))) / rolling
    return found


def _difference(own: Film, plain: dict[str, FloatArray]) -> float:
    """Maximum relative difference of the isothermal central films of both races."""
    worst = 0.0
    for race, thickness in plain.items():
        films = own.inner if race == "inner" else own.outer
        isothermal = films.central_thickness / films.thermal_factor
        with np.errstate(invalid="ignore"):
            worst = max(worst, float(np.nanmax(np.abs(thickness / isothermal - 1.0))))
    return worst


if __name__ == "__main__":
    findings = measure()
    for figure in findings.figures:
        print(f"{figure.name}: {figure.value:.3g} {figure.unit}")
    for failure in findings.failures:
        print("Failed:", failure)
