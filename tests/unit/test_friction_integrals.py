"""Closed forms of friction against quadrature, and how fast the mesh converges."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import ellipe

from rolamento.friction.closed_forms import (
    MOMENT_COEFFICIENT,
    ROLLING_LINE,
    hysteresis_moment,
    rolling_moment,
    spin_moment,
)
from rolamento.friction.harris_1971 import line_friction
from rolamento.friction.slip import Patch, RelativeMotion, rolling_lines, slip_velocity
from rolamento.friction.traction import contact_friction, ellipse_mesh

MU = 0.13


def patch(a: float = 1e-3, b: float = 0.2e-3, race: str = "outer") -> Patch:
    values = (250.0, 0.4, a, b, 12e-3, 60e-3, 0.52)
    return Patch(race, *(np.array([value]) for value in values))  # type: ignore[arg-type]


def spinning(side: float = 1.0) -> RelativeMotion:
    zero = np.zeros(1)
    return RelativeMotion(zero, zero, np.ones(1), zero, side)


def rolling(p: Patch, line: float = ROLLING_LINE) -> RelativeMotion:
    """Rolling without spin, nothing slipping at x0 = ± line a."""
    roll = np.ones(1)
    drift = -p.side * p.rolling_radius(np.array([line]))
    return RelativeMotion(drift, roll, np.zeros(1), np.zeros(1), p.side)


@pytest.mark.parametrize("ratio", [1.0, 0.5, 0.12, 0.02])
def test_spin_moment_is_exact(ratio: float) -> None:
    """(3/8) μ Q a E against μ Q <√(a²u² + b²v²)>, polar: the angle's part by quadrature."""
    p = patch(b=ratio * 1e-3)
    angular = quad(lambda t: np.hypot(np.cos(t), ratio * np.sin(t)), 0.0, 0.5 * np.pi)[0]
    # <r f(θ)> = (3/2π) ∫ r² √(1-r²) dr ∫ f dθ = (3/2π)(π/16) 4 ∫₀^{π/2} f dθ
    expected = MU * 250.0 * 1e-3 * 1.5 / np.pi * np.pi / 16.0 * 4.0 * angular
    assert spin_moment(p, MU)[0] == pytest.approx(expected, rel=1e-12)
    assert spin_moment(p, MU)[0] == pytest.approx(
        0.375 * MU * 250.0 * 1e-3 * ellipe(1.0 - ratio**2), rel=1e-12
    )


def errors(counts: list[int], function: object) -> np.ndarray:
    return np.array([abs(function(n)) for n in counts])  # type: ignore[operator]


def order(counts: list[int], error: np.ndarray) -> float:
    return float(-np.polyfit(np.log(counts), np.log(error), 1)[0])


def test_spin_converges_with_third_order() -> None:
    """The integrand has a cone at the centre: error ~ 1/n³, both ways refined together."""
    p, exact = patch(b=0.6e-3), spin_moment(patch(b=0.6e-3), MU)[0]
    counts = [8, 16, 32, 64]

    def error(n: int) -> float:
        got = contact_friction(p, spinning(), MU, mesh=ellipse_mesh(n, n))
        return float(abs(got.moment_twist[0]) / exact - 1.0)

    found = errors(counts, error)
    assert found[-1] < 1e-5
    assert order(counts, found) > 2.7


def test_heathcote_constants_by_quadrature() -> None:
    k = ROLLING_LINE
    assert k == pytest.approx(0.347296, abs=5e-7)
    balance = quad(lambda s: (1 - s**2) * np.sign(s**2 - k**2), 0.0, 1.0, points=[k])[0]
    assert balance == pytest.approx(0.0, abs=1e-14)
    whole = quad(lambda s: (1 - s**2) * abs(s**2 - k**2), -1.0, 1.0, points=[-k, k])[0]
    assert 0.375 * whole == pytest.approx(MOMENT_COEFFICIENT, rel=1e-13)
    assert pytest.approx(0.080571, abs=5e-7) == MOMENT_COEFFICIENT


def test_heathcote_moment_on_the_true_arc() -> None:
    """Power of pure rolling on the arc, by closed form, against M_H and by quadrature."""
    for a, tolerance in ((0.3e-3, 2e-3), (1e-3, 2e-2)):
        p = patch(a=a)
        sums = line_friction(p, rolling(p))
        assert MU * sums.power[0] == pytest.approx(rolling_moment(p, MU)[0], rel=tolerance)

        def power(s: float, p: Patch = p) -> float:
            v = slip_velocity(p, rolling(p), np.array([s]), np.zeros(1)).rolling[0, 0]
            return 0.75 * 250.0 * (1.0 - s**2) * abs(float(v))

        k = ROLLING_LINE
        by_quadrature = quad(power, -1.0, 1.0, points=[-k, k], epsabs=0, epsrel=1e-11)[0]
        assert sums.power[0] == pytest.approx(by_quadrature, rel=1e-9)


def test_rolling_without_a_force_has_its_lines_where_heathcote_says() -> None:
    p = patch(a=0.2e-3)
    motion = rolling(p)
    np.testing.assert_allclose(rolling_lines(p, motion)[0], [-ROLLING_LINE, ROLLING_LINE])
    assert abs(line_friction(p, motion).force[0]) < 1e-3 * 250.0


def test_rolling_power_converges_with_second_order() -> None:
    """The integrand has kinks on the rolling lines: error ~ 1/n² across, none along."""
    p = patch()
    exact = line_friction(p, rolling(p)).power[0]
    counts = [10, 20, 40, 80, 160, 320]

    def error(n: int) -> float:
        return float(contact_friction(p, rolling(p), 1.0, mesh=ellipse_mesh(n, 1)).power[0])

    found = errors(counts, lambda n: error(n) / exact - 1.0)
    assert order(counts, found) > 1.6
    assert found[-1] < 2e-4


def test_rolling_force_converges_with_first_order() -> None:
    """The integrand jumps on the rolling lines: error ~ 1/n."""
    p = patch()
    motion = rolling(p, 0.5)
    exact = line_friction(p, motion).force[0]
    counts = [10, 20, 40, 80, 160, 320]
    found = errors(
        counts,
        lambda n: (
            (contact_friction(p, motion, 1.0, mesh=ellipse_mesh(n, 1)).force_rolling[0] - exact)
            / 250.0
        ),
    )
    assert np.all(found < 4.0 / np.array(counts))
    assert 0.7 < order(counts, found) < 1.4


@pytest.mark.sweep
def test_rounded_law_converges_to_the_sharp_one() -> None:
    """The power is low by the order (v0/v)² ln(v/v0) where slip has lines of zeros."""
    p, mesh = patch(), ellipse_mesh(2000, 1)
    motion = rolling(p)
    sharp = contact_friction(p, motion, MU, mesh=mesh).power[0]
    scale = 1e-3**2 / (2.0 * float(p.deformed_radius[0]))
    widths = [0.1, 0.05, 0.025]
    lost = [
        1.0 - contact_friction(p, motion, MU, rounding=w * scale, mesh=mesh).power[0] / sharp
        for w in widths
    ]
    assert lost[0] > lost[1] > lost[2] > 0.0
    assert 1.4 < np.log2(lost[1] / lost[2]) < 2.1


def test_closed_form_of_lines_with_spin_and_one_two_or_no_lines() -> None:
    p = patch(a=2e-3, race="inner")
    scale = 2e-3**2 / (2.0 * float(p.deformed_radius[0]))
    for lift, twist, count in ((0.3, 0.0, 2), (0.3, 0.4, 2), (0.6, 0.6, 1), (1.4, 0.1, 0)):
        motion = RelativeMotion(
            -p.side * (p.rolling_radius(np.zeros(1)) - lift * scale),
            np.ones(1),
            np.array([twist * scale / 2e-3]),
            np.zeros(1),
            p.side,
        )
        lines = rolling_lines(p, motion)[0]
        cuts = lines[np.isfinite(lines)]
        assert cuts.size == count

        def integral(kind: str, m: RelativeMotion = motion, c: np.ndarray = cuts) -> float:
            def integrand(s: float) -> float:
                u = np.array([s])
                v = float(slip_velocity(p, m, u, np.zeros(1)).rolling[0, 0])
                factor = {
                    "force": 1.0,
                    "roll": float(p.rolling_radius(u)[0]),
                    "twist": s * 2e-3,
                    "power": v,
                }[kind]
                return 0.75 * 250.0 * (1.0 - s**2) * np.sign(v) * factor

            edges = [-1.0, *c, 1.0]
            points, weights = np.polynomial.legendre.leggauss(40)
            return sum(
                0.5 * (high - low) * w * integrand(0.5 * (low + high) + 0.5 * (high - low) * t)
                for low, high in pairwise(edges)
                for t, w in zip(points, weights, strict=True)
            )

        sums = line_friction(p, motion)
        for kind, unit in (("force", 250.0), ("roll", 1.5), ("twist", 0.5), ("power", 250 * scale)):
            got = getattr(sums, kind)[0]
            assert got == pytest.approx(integral(kind), abs=1e-8 * unit), (kind, lift, twist)


def test_friction_on_ball_and_race_is_one_force_at_one_place() -> None:
    """Power from forces at points is power from resultants: F·v of ring less ball."""
    p = patch(race="inner")
    random = np.random.default_rng(5)
    mesh = ellipse_mesh(30, 8)
    for _ in range(20):
        drift, roll, twist, tumble = random.normal(size=4)
        motion = RelativeMotion(
            np.array([-0.5 * drift * 60e-3]),
            np.array([roll]),
            np.array([twist]),
            np.array([tumble]),
            p.side,
        )
        f = contact_friction(p, motion, MU, mesh=mesh)
        by_sums = (
            f.force_rolling * motion.drift
            - f.moment_roll * motion.roll
            - f.moment_tumble * motion.tumble
            - f.moment_twist * motion.twist
        )
        np.testing.assert_allclose(f.power, by_sums, rtol=1e-12)
        assert f.power[0] > 0.0
        # r × f about the shaft: the ring gets the force's arm and the ball's moment
        sine, cosine = np.sin(0.4), np.cos(0.4)
        about_x = f.moment_roll * cosine + f.moment_twist * sine
        np.testing.assert_allclose(
            f.race_torque, 30e-3 * f.force_rolling - about_x, rtol=1e-10, atol=1e-15
        )


def test_hysteresis_moment_is_the_work_of_the_front_half() -> None:
    """Moment of the pressure ahead of the middle about the middle line: ∫ p y0 over half."""
    mesh = ellipse_mesh(200, 199)
    front = np.sum(mesh.weight * np.maximum(mesh.along, 0.0)) * 250.0 * 0.2e-3
    assert hysteresis_moment(patch(), 1.0)[0] == pytest.approx(front, rel=1e-3)
