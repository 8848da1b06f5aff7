"""Film and friction of solved cases, over all of their contacts: every model of friction.

The duty set of `duty_sets.tilts_held` with oil, temperature, roughness and a coefficient of
friction; friction by a closed form, Jones's simplified model, with hysteresis and the oil's
rolling resistance. What is measured begins where the cases are solved. Beside the film stands
what an engineer writes with NumPy and SciPy's elliptic integrals, of one race, on whole arrays.

The models of friction that look for the motion of the balls (Jones's, Harris's) stand beside
`scipy.optimize.minimize` on the same rounded power of one ball, with its gradient, on one thread.
"""

from __future__ import annotations

from functools import partial

import numpy as np
from scipy.optimize import minimize
from scipy.special import ellipe, ellipk

from benchmarks import duty_sets
from benchmarks.figures import Figure, Findings, alternately, at_least, below
from rolamento import Lubricant
from rolamento.friction import friction
from rolamento.friction.models import CONTACT_MODELS, TORQUE_MODELS
from rolamento.lubrication import film
from rolamento.lubrication.films import Film
from rolamento.numerics import FloatArray
from rolamento.solution import solve
from rolamento.solved import Solved

CASES = 100_000
SECONDS = 1.5
SAMPLE = 4000
AGREEMENT = 1e-9
OF_MODELS = 5000
"""Cases for each model of friction."""
MILLISECONDS = {"closed form": 0.05, "motion sought": 0.1}
SHARP = (1.0, 0.1, 0.01)
"""Stages of the rounding, over the slip that rolling makes."""
POINTS = (80, 5)
TORQUES = 1e-4
"""Greatest difference of the torque of Jones's full model: SciPy stops sooner."""
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
    findings = Findings(figures, [], failures)
    findings.add(_of_models(batch[: min(cases, OF_MODELS)]))
    return findings


def _of_models(batch: Solved) -> Findings:
    """Every model of the friction in the contacts, and SciPy for one that looks for a motion."""
    findings, cases = Findings.none(), len(batch)
    group = f"friction by every model, {cases} solved cases"
    for model in CONTACT_MODELS:
        run = partial(friction, batch, model=model)
        friction(batch[:100], model=model)  # so that its kernel is loaded
        closed = TORQUE_MODELS[model].closed_form
        limit = MILLISECONDS["closed form" if closed else "motion sought"]
        spent = 1e3 * alternately([run], 2)[0] / cases
        target = below(limit) if cases >= OF_MODELS else None
        findings.figures.append(Figure(group, model, spent, "ms/case", target))
        if model != "jones_full":
            continue
        seconds = alternately([partial(_least_power, batch, 0)], 1)[0]
        findings.figures += [
            Figure(group, "  NumPy and scipy.optimize.minimize", 1e3 * seconds, "ms/case"),
            Figure(
                group, "  the engine is faster by", 1e3 * seconds / spent, "times", at_least(1e3)
            ),
        ]
        own = friction(batch[:1], model=model, compare=False).models[model].total[0]
        off = abs(_least_power(batch, 0) / own - 1.0)
        if not off < TORQUES:
            findings.failures.append(f"{group}: SciPy's torque differs by {off:.1e}")
    return findings


def _least_power(solved: Solved, case: int) -> float:
    """Torque of Jones's full model by SciPy, N·m: each ball's motion of least power."""
    bearing = solved.case.bearing
    d, radius = bearing.ball_diameter, 0.5 * bearing.pitch_diameter
    u, gauss = np.polynomial.legendre.leggauss(POINTS[0])
    angle = np.arange(1, POINTS[1] + 1) * np.pi / (POINTS[1] + 1)
    v = np.outer(np.sqrt(1.0 - u**2), np.cos(angle))
    weight = 1.5 / (POINTS[1] + 1) * np.outer((1.0 - u**2) * gauss, np.sin(angle) ** 2)
    mu, total = solved.case.lubricant.friction_coefficient, 0.0  # type: ignore[union-attr]
    for ball in range(solved.inner.load.shape[1]):
        slips, loads, smallest = [], [], np.inf
        for ring, side, contacts, conformity in (
            (1.0, -1.0, solved.inner, bearing.inner_conformity),
            (0.0, 1.0, solved.outer, bearing.outer_conformity),
        ):
            a, b = contacts.semi_major[case, ball], contacts.semi_minor[case, ball]
            c, s = (f(contacts.contact_angle[case, ball]) for f in (np.cos, np.sin))
            arc = 2.0 * conformity * d / (2.0 * conformity + 1.0)
            x = np.repeat(a * u, POINTS[1])
            r = side * (
                np.sqrt(arc**2 - x**2) + np.sqrt(0.25 * d**2 - a**2) - np.sqrt(arc**2 - a**2)
            )
            along = np.stack([r * c - x * s, -r * s - x * c, np.full_like(x, radius)])
            across = b * np.stack([v.ravel() * s, v.ravel() * c, np.zeros_like(x)])
            slips.append((along, across, ring * (along[0] + along[2]), ring * across[0]))
            loads.append(contacts.load[case, ball] * weight.ravel())
            smallest = min(smallest, a**2 / (2.0 * arc))
        along, across = (np.concatenate([slip[i] for slip in slips], axis=1) for i in (0, 1))
        driven, turned = (np.concatenate([slip[i] for slip in slips]) for i in (2, 3))
        load = np.concatenate(loads)

        def power(
            motion: FloatArray, v0: float, of: tuple[FloatArray, ...] = (along, across, driven,
            turned, load),
        ) -> tuple[float, FloatArray]:  # fmt: skip
            rolling, sliding = motion @ of[0] - of[2], motion @ of[1] - of[3]
            speed = np.sqrt(rolling**2 + sliding**2 + v0**2)
            share = of[4] / speed
            return float(of[4] @ speed), of[0] @ (share * rolling) + of[1] @ (share * sliding)

        orbit = solved.elements.orbital_speed[case, ball] / solved.field("duty.inner_speed")[case]
        speed = solved.elements.ball_speed[case, ball] / solved.field("duty.inner_speed")[case]
        tilt = solved.elements.attitude[case, ball]
        motion = np.array([orbit + speed * np.cos(tilt), -speed * np.sin(tilt), orbit])
        for stage in SHARP:
            v0 = stage * smallest * abs(speed)
            motion = minimize(power, motion, (v0,), jac=True, method="BFGS", tol=1e-12).x
        total += mu * power(motion, 0.0)[0]
    return total


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
