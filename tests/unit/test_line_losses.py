"""Losses of line contacts: limits, integrals by other means, and what the sources compare with."""

from __future__ import annotations

from math import cos, exp, pi, radians, sqrt

import numpy as np
import pytest
from scipy.integrate import quad

from rolamento.friction.line_losses import (
    computed_inlet_force,
    inlet_force,
    line_hysteresis,
    rib_coefficient,
    slip_moment,
    starting_torque,
)

E_STAR, RADIUS, ALPHA = 2.26e11, 4e-3, 2e-8


def test_a_rigid_roller_by_reynolds() -> None:
    """t = ∫ (h/2) dp/dx dx of a rigid roller: 1.46 E' R √(U W) by Dowson, 1.42 as computed here."""
    c = 0.475132
    force = 6.0 * sqrt(2.0) * quad(lambda s: (s * s - c * c) / (1 + s * s) ** 2, -np.inf, c)[0]
    load = 4.896
    own = abs(force) / sqrt(load) / sqrt(2.0)  # U has the factor 2
    assert own == pytest.approx(1.46, rel=1e-2)
    eta, u, q = 0.1, 20.0, 5.0
    there = computed_inlet_force(q, 1 / RADIUS, E_STAR, eta, u)
    assert there == pytest.approx(1.42 * sqrt(2.0 * eta * u * q), rel=1e-3)
    assert there / (own * sqrt(2.0 * eta * u * q)) == pytest.approx(1.0, abs=0.04)


def test_the_elastic_limit_knows_no_load() -> None:
    low, high = computed_inlet_force(np.array([2e5, 2e6]), 1 / RADIUS, E_STAR, 0.02, 3.0)
    rate = 2.0 * 0.02 * 3.0 / (E_STAR * RADIUS)
    assert high == pytest.approx(1.47 * E_STAR * RADIUS * rate**0.75, rel=2e-2)
    assert low == pytest.approx(high, rel=2e-2)


def test_goksem_and_hargreaves_as_biboulet_and_houpert_print_it() -> None:
    """Their equation 39 compares it with their own at G 4000, U 1e-11, W 1e-4: 1.00.

    Aihara's factor is that formula's with 20.4 W^0.3 in front of it.
    """
    speed = 1e-11 * E_STAR * RADIUS / (2.0 * 0.02)
    load, alpha = 1e-4 * E_STAR * RADIUS, 4000.0 / E_STAR
    aihara = inlet_force(load, 1 / RADIUS, E_STAR, 0.02, alpha, speed)
    goksem = aihara * 4.318 / 88.0 * (1e-4) ** (0.0126 - 0.31)
    computed = computed_inlet_force(load, 1 / RADIUS, E_STAR, 0.02, speed)
    assert goksem / computed == pytest.approx(1.00, abs=0.01)
    assert aihara == pytest.approx(88.0 / 4.318 * 1e-4**0.2974 * goksem)


def test_inlet_force_without_load_speed_or_oil() -> None:
    for q, eta, u in ((0.0, 0.02, 3.0), (1e5, 0.0, 3.0), (1e5, 0.02, 0.0)):
        assert inlet_force(q, 1 / RADIUS, E_STAR, eta, ALPHA, u) == 0.0
        assert computed_inlet_force(q, 1 / RADIUS, E_STAR, eta, u) == 0.0


def test_hysteresis_is_the_work_of_the_front_half() -> None:
    """∫ p x dx over the front half of Hertz's pressure, per unit of rolling, is q 2b/(3π)."""
    b, q = 0.12e-3, 3e5
    p0 = 2.0 * q / (pi * b)
    work = quad(lambda x: p0 * sqrt(1.0 - (x / b) ** 2) * x, 0.0, b)[0]
    assert line_hysteresis(q, b, 0.01) == pytest.approx(0.01 * work)


@pytest.mark.parametrize("slices", [4, 5, 35])
def test_slip_of_a_uniform_load(slices: int) -> None:
    length = 10e-3
    place = (np.arange(slices) + 0.5) / slices * length - length / 2
    assert slip_moment(np.full(slices, 2e5), place) == pytest.approx(2e5 * length**2 / 4)


def test_slip_of_a_triangular_load_and_of_none() -> None:
    """Half of a load that grows from zero lies beyond l/√2: ∫ q |x - x0| = q l² (1/3 - √2/6 …)."""
    length, slices = 1.0, 2001
    place = (np.arange(slices) + 0.5) / slices * length
    middle = length / sqrt(2.0)
    exact = quad(lambda x: x * abs(x - middle), 0.0, length, points=[middle])[0]
    assert slip_moment(place.copy(), place) == pytest.approx(exact, rel=1e-6)
    assert slip_moment(np.zeros((3, slices)), place[np.newaxis]).tolist() == [0.0, 0.0, 0.0]
    # no other place of rolling loses less
    for other in (0.6, 0.75, 0.8):
        lost = quad(lambda x, at: x * abs(x - at), 0, 1, args=(other,), points=[other])[0]
        assert lost > exact


def test_rib_friction_falls_with_the_film() -> None:
    assert rib_coefficient(0.0) == pytest.approx(0.2)
    assert rib_coefficient(1.0, 0.1) == pytest.approx(0.1 * exp(-1.8))
    assert rib_coefficient(3.0) < 0.001


def test_starting_torque_by_hand() -> None:
    """NSK: M = e μ F_a cos β; 1 mm, 0.2, 500 N: 100 N·mm."""
    assert starting_torque(500.0, 1e-3, 0.0) == pytest.approx(0.1)
    assert starting_torque(-500.0, 1e-3, radians(2.0)) == pytest.approx(0.1 * cos(radians(2.0)))
