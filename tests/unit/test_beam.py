"""Beams against their closed forms, and chains of them against stiffness matrices."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento.numerics import FloatArray
from rolamento.system.beam import Chain, Elements, shear_coefficient

E, NU, RHO = 206e9, 0.3, 7850.0


def beam(
    length: float, left: float, right: float | None = None, bore: float = 0.0, count: int = 1
) -> Elements:
    """A cylinder, or a cone, in equal elements."""
    ones = np.ones(count)
    d = np.linspace(left, left if right is None else right, count + 1)
    return Elements(
        ones * length / count, d[:-1], d[1:], ones * bore, ones * bore,
        ones * E, ones * NU, ones * RHO,
    )  # fmt: skip


def test_cylinder_has_timoshenko_s_stiffness() -> None:
    """Przemieniecki (1968), eq. 5.116: 12 E I/(L³ (1 + φ)), φ = 12 E I/(κ G A L²)."""
    length, d = 0.5, 0.04
    k = beam(length, d).stiffness()[0]
    inertia, area = np.pi / 64 * d**4, np.pi / 4 * d**2
    kappa = shear_coefficient(np.zeros(1), np.full(1, NU))[0]
    assert kappa == pytest.approx(6 * (1 + NU) / (7 + 6 * NU))
    phi = 12 * E * inertia / (kappa * E / 2 / (1 + NU) * area * length**2)
    own = E * inertia / (length**3 * (1 + phi))
    np.testing.assert_allclose(
        [k[1, 1], k[1, 4], k[4, 4], k[4, 9], k[2, 3], k[0, 0], k[0, 5]],
        [
            12 * own, 6 * length * own, (4 + phi) * length**2 * own, (2 - phi) * length**2 * own,
            -6 * length * own, E * area / length, -E * area / length,
        ],
        rtol=1e-13,
    )  # fmt: skip
    np.testing.assert_allclose(k, k.T, atol=1e-6)


def test_cone_bends_as_by_integration() -> None:
    """Euler: w = 64 F L³/(3 π E d_0³ d_1), d_0 held, d_1 loaded; shear integrated beside it."""
    length, d0, d1 = 0.4, 0.05, 0.03
    own = beam(length, d0, d1)
    kappa = shear_coefficient(np.zeros(1), np.full(1, NU))[0]
    shear = length / (kappa * E / 2 / (1 + NU) * np.pi / 4 * d0 * d1)
    bent = 64 * length**3 / (3 * np.pi * E * d0**3 * d1)
    assert own.flexibility()[0, 0, 0] == pytest.approx(bent + shear, rel=1e-13)


def test_mass_and_gyroscopic_matrices_move_a_rigid_body_as_they_should() -> None:
    """The sums over rigid motions are mass, moment of inertia and 2 ρ I L."""
    own = beam(0.5, 0.04)
    m, g = (one[0] for one in own.inertia())
    mass = own.mass()[0]
    assert mass == pytest.approx(RHO * 0.5 * np.pi / 4 * 0.04**2)
    for axis in (0, 1, 2):
        shift = np.zeros(10)
        shift[[axis, axis + 5]] = 1.0
        assert shift @ m @ shift == pytest.approx(mass, rel=1e-12)
    about_y = np.array([0, 0, 0, 1, 0, 0, 0, -0.5, 1, 0], float)  # w' = -ry
    about_z = np.array([0, 0, 0, 0, 1, 0, 0.5, 0, 0, 1], float)  # v' = +rz
    turning = mass * (0.5**2 / 3 + 0.04**2 / 16)
    assert about_y @ m @ about_y == pytest.approx(turning, rel=1e-12)
    assert about_z @ m @ about_z == pytest.approx(turning, rel=1e-12)
    polar = mass * 0.04**2 / 8
    assert about_y @ g @ about_z == pytest.approx(polar, rel=1e-12)  # + I_p rz' against ry
    assert about_z @ g @ about_y == pytest.approx(-polar, rel=1e-12)
    np.testing.assert_allclose(m, m.T, atol=1e-12)
    np.testing.assert_allclose(g, -g.T, atol=1e-14)


def assembled(elements: Elements) -> FloatArray:
    """Of one plane, node after node (v, θ)."""
    n = len(elements)
    k = np.zeros((2 * n + 2, 2 * n + 2))
    for i, own in enumerate(elements.stiffness()):
        at = slice(2 * i, 2 * i + 4)
        k[at, at] += own[np.ix_([1, 4, 6, 9], [1, 4, 6, 9])]
    return k


@pytest.mark.parametrize("kept", [[0, 6], [2, 3, 5], [1], [6], [0, 1, 2, 3, 4, 5, 6]])
def test_chain_is_its_elements_condensed(kept: list[int]) -> None:
    """Cones, a bore, overhanging ends: against Guyan's reduction of the whole."""
    elements = beam(0.6, 0.05, 0.03, bore=0.01, count=6)
    chain = Chain.of(elements.length, elements.flexibility(), np.array(kept))
    k = assembled(elements)
    own = (2 * np.array(kept)[:, np.newaxis] + np.arange(2)).ravel()
    left = np.setdiff1d(np.arange(14), own)
    inner = np.linalg.inv(k[np.ix_(left, left)])
    follow = -inner @ k[np.ix_(left, own)]
    stiffness = k[np.ix_(own, own)] + k[np.ix_(own, left)] @ follow
    scale = np.abs(k).max()
    np.testing.assert_allclose(chain.stiffness / scale, stiffness / scale, atol=1e-12)
    np.testing.assert_allclose(chain.follow[left], follow, atol=1e-9)
    np.testing.assert_allclose(chain.follow[own], np.eye(len(own)), atol=0)
    np.testing.assert_allclose(chain.by_load[np.ix_(left, left)], inner, rtol=1e-6, atol=1e-14)
    assert not chain.by_load[own].any()


@pytest.mark.parametrize("kept", [[0, 6], [2, 3, 5], [4]])
def test_chain_along_the_axis(kept: list[int]) -> None:
    """The same of stretching."""
    elements = beam(0.6, 0.05, 0.03, count=6)
    stretch = elements.stretch()
    chain = Chain.along(stretch, np.array(kept))
    k = np.zeros((7, 7))
    for i, one in enumerate(stretch):
        k[i : i + 2, i : i + 2] += np.array([[1, -1], [-1, 1]]) / one
    left = np.setdiff1d(np.arange(7), kept)
    inner = np.linalg.inv(k[np.ix_(left, left)])
    np.testing.assert_allclose(
        chain.follow[left], -inner @ k[np.ix_(left, kept)], rtol=1e-9, atol=1e-12
    )
    np.testing.assert_allclose(chain.by_load[np.ix_(left, left)], inner, rtol=1e-9, atol=1e-22)


def test_short_elements_cost_no_digits() -> None:
    """A sliver of 0.1 µm beside a metre: nothing holds the chain, to the last digit."""
    elements = beam(1.0, 0.04, count=4)
    length = np.insert(elements.length, 2, 1e-7)
    whole = beam(1.0, 0.04)
    pieces = Elements(length, *(np.full(5, value) for value in (0.04, 0.04, 0.0, 0.0, E, NU, RHO)))
    chain = Chain.of(pieces.length, pieces.flexibility(), np.array([0, 5]))
    plane = whole.stiffness()[0][np.ix_([1, 4, 6, 9], [1, 4, 6, 9])]
    np.testing.assert_allclose(chain.stiffness, plane, rtol=1e-6)
    rigid = np.array([[1.0, 0.0, 1.0, 0.0], [0.0, 1.0, length.sum(), 1.0]])
    left = np.abs(chain.stiffness @ rigid.T).max() / np.abs(chain.stiffness).max()
    assert left < 1e-15


def test_three_supports_by_hand() -> None:
    """Ø40, 600 mm, supports in the ends and the middle, 5 kN at 150 mm.

    Rigid supports: 13/32, 22/32 and -3/32 of the load, from the equation of three moments.
    """
    length, rigidity = np.full(12, 0.05), E * np.pi / 64 * 0.04**4
    by_bending = np.array([[0.05**3 / 3, 0.05**2 / 2], [0.05**2 / 2, 0.05]]) / rigidity
    chain = Chain.of(length, np.tile(by_bending, (12, 1, 1)), np.array([0, 6, 12]))
    load = np.zeros(26)
    load[2 * 3] = 5000.0
    on_kept, k = chain.follow.T @ load, chain.stiffness
    tilts = [1, 3, 5]
    turned = np.linalg.solve(k[np.ix_(tilts, tilts)], on_kept[tilts])
    borne = on_kept[[0, 2, 4]] - k[np.ix_([0, 2, 4], tilts)] @ turned
    np.testing.assert_allclose(borne, [2031.25, 3437.5, -468.75], rtol=1e-11)
    yielding = k + np.diag([1e8, 0, 1e8, 0, 1e8, 0])
    place = np.linalg.solve(yielding, on_kept)
    np.testing.assert_allclose(1e8 * place[[0, 2, 4]], [2101.583, 3296.834, -398.417], atol=6e-4)


def test_weight_is_as_by_hand() -> None:
    """A cantilever under its own weight: q L⁴/(8 E I) + q L²/(2 κ G A)."""
    elements = beam(0.8, 0.05, count=5)
    load = elements.body_load(np.array([0.0, 0.0, -9.81]))
    nodal = np.zeros(12)
    for i, own in enumerate(load):
        nodal[2 * i : 2 * i + 4] += own[[2, 3, 7, 8]] * [1, -1, 1, -1]
    chain = Chain.of(elements.length, elements.flexibility(), np.array([0]))
    tip = (chain.by_load @ nodal)[10]
    area, inertia = np.pi / 4 * 0.05**2, np.pi / 64 * 0.05**4
    q = RHO * 9.81 * area
    kappa = shear_coefficient(np.zeros(1), np.full(1, NU))[0]
    bent = q * 0.8**4 / (8 * E * inertia) + q * 0.8**2 / (2 * kappa * E / 2 / (1 + NU) * area)
    assert tip == pytest.approx(-bent, rel=1e-12)
    assert nodal[::2].sum() == pytest.approx(-q * 0.8, rel=1e-12)
