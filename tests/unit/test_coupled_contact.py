"""Slices that feel each other: the influence, the conditions of contact, limits and hard cases."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import integrate

from rolamento.case.profile import Profile
from rolamento.contact.coupled import (
    CoupledPress,
    body_term,
    coupled_press,
    coupled_slices,
    influence_table,
    scratch,
)
from rolamento.contact.line import contact_constant, half_width, slice_places
from rolamento.contact.profile import drop
from rolamento.contact.slices import independent_slices

E = 207e9 / (1.0 - 0.3**2)
D, L = 7.5e-3, 9e-3
RHO = 2.0 / D + 2.0 / 27e-3
ISO = Profile(kind="iso")


def press(
    approach: float, tilt: float = 0.0, n: int = 35, given: Profile = ISO, **changed: float
) -> CoupledPress:
    size = {"effective_length": L, "roller_diameter": D, "curvature": RHO, "modulus": E, **changed}
    drops = drop(
        given,
        slice_places(size["effective_length"], n),
        length=size["effective_length"],
        diameter=size["roller_diameter"],
    )
    return coupled_press(approach, tilt, drops, **size)  # type: ignore[arg-type]


STRAIGHT, CROWNED = Profile(kind="none"), Profile(kind="crowned", radius=1.0)


def mean_over_ellipse(j: int, beta: float) -> float:
    """g_j by quadrature, t = sin u."""

    def integrand(u: float) -> float:
        x = beta * np.sin(u)
        return float(
            4.0 / np.pi * np.cos(u) ** 2 * (np.arcsinh((j + 0.5) / x) - np.arcsinh((j - 0.5) / x))
        )

    return float(integrate.quad(integrand, 0.0, 0.5 * np.pi, epsabs=1e-12, epsrel=1e-12)[0])


@pytest.mark.parametrize("point", [0, 37, 64, 80, 112])
@pytest.mark.parametrize("j", [0, 1, 2, 9])
def test_influence_is_the_mean_over_the_half_ellipse(j: int, point: int) -> None:
    beta = np.exp(-8.0 + point / 8.0)
    assert influence_table(11)[point, 0, j] == pytest.approx(
        mean_over_ellipse(j, beta), rel=1e-9, abs=1e-11
    )


def influence(beta: float, n: int = 11) -> np.ndarray:
    """What the kernel takes from the table, through one loaded slice of a cut of n."""
    place, load, answer = slice_places(float(n), n), np.zeros(n), np.empty(6)
    # one slice alone is in contact: q from the half width that is meant
    q = np.pi * E * beta**2 / 8.0
    drops = np.full(n, np.inf)
    drops[n // 2] = 0.0
    self_influence = mean_over_ellipse(0, beta)
    number = coupled_slices(
        2.0 * q / (np.pi * E) * self_influence, 0.0, place, drops, 1.0, 2.0 / (np.pi * E),
        np.ones(n), influence_table(n), np.zeros(n), load, scratch(n), answer,
    )  # fmt: skip
    assert number == 0
    return np.asarray(load / q)


@pytest.mark.parametrize("beta", [1e-6, 3.1e-4, 0.0123, 0.277, 1.31, 17.3, 380.0])
def test_between_the_points_of_the_table_it_is_as_good(beta: float) -> None:
    assert influence(beta)[5] == pytest.approx(1.0, rel=1e-5)


def test_the_table_is_shared_and_cannot_be_spoiled() -> None:
    assert influence_table(35) is influence_table(35)
    with pytest.raises(ValueError, match="read-only"):
        influence_table(35)[0, 0, 0] = 1.0


@pytest.mark.parametrize("tilt", [0.0, 1e-3, 5e-3])
@pytest.mark.parametrize("given", [STRAIGHT, ISO, CROWNED], ids=lambda one: one.kind)
def test_where_it_presses_it_touches_and_nowhere_overlaps(given: Profile, tilt: float) -> None:
    """The gaps, from g_j by quadrature and not from the kernel."""
    n = 9
    pressed = press(9e-6, tilt, n, given)
    assert pressed.converged
    width = L / n
    moved = np.zeros(n)
    body = body_term(n, width, D, 0.5)
    for k, (q, b) in enumerate(zip(pressed.load_per_length, pressed.half_width, strict=True)):
        for line in range(n):
            if q > 0.0:
                j = abs(line - k)
                g = mean_over_ellipse(j, b / width) - body[j]
                moved[line] += 2.0 * q / (np.pi * E) * g
    place = pressed.place
    gap = moved - (9e-6 + tilt * place - drop(given, place, length=L, diameter=D))
    loaded = pressed.load_per_length > 0.0
    np.testing.assert_allclose(gap[loaded], 0.0, atol=9e-6 * 3e-6)
    assert np.all(gap[~loaded] > 0.0)
    assert loaded.any()


def test_load_and_moment_are_those_of_the_slices() -> None:
    pressed = press(1e-5, 2e-3)
    q, width = pressed.load_per_length, L / 35
    assert pressed.load == pytest.approx(q.sum() * width, rel=1e-12)
    assert pressed.moment == pytest.approx((q * pressed.place).sum() * width, rel=1e-12)
    assert np.all(q >= 0.0)


@pytest.mark.parametrize("given", [STRAIGHT, ISO, CROWNED], ids=lambda one: one.kind)
def test_symmetry(given: Profile) -> None:
    even = press(1e-5, 0.0, given=given)
    np.testing.assert_allclose(even.load_per_length, even.load_per_length[::-1], rtol=1e-9)
    assert even.moment == pytest.approx(0.0, abs=1e-9 * even.load * L)
    one, other = press(1e-5, 3e-3, given=given), press(1e-5, -3e-3, given=given)
    np.testing.assert_allclose(one.load_per_length, other.load_per_length[::-1], rtol=1e-8)
    assert one.moment == pytest.approx(-other.moment, rel=1e-9)


@pytest.mark.parametrize(
    ("approach", "tilt"), [(3e-6, 0.0), (1e-5, 1e-3), (1e-5, 6e-3), (-5e-6, 4e-3), (4e-5, 0.0)]
)
@pytest.mark.parametrize("given", [STRAIGHT, ISO], ids=lambda one: one.kind)
def test_derivatives_are_those_of_the_answers(given: Profile, approach: float, tilt: float) -> None:
    stiffness = press(approach, tilt, given=given).stiffness
    for column, (d, t) in enumerate(((1e-10, 0.0), (0.0, 1e-8))):
        after, before = (
            press(approach + sign * d, tilt + sign * t, given=given) for sign in (1.0, -1.0)
        )
        slope = [(after.load - before.load), (after.moment - before.moment)]
        np.testing.assert_allclose(
            stiffness[:, column],
            np.array(slope) / (2.0 * (d + t)),
            rtol=1e-5,
            atol=1e-5 * np.abs(stiffness[:, column]).max(),
        )


def test_work_is_nearly_that_of_a_potential() -> None:
    # each slice has its own half width: the influence is symmetric but for that
    stiffness = press(1e-5, 2e-3).stiffness
    assert stiffness[0, 1] == pytest.approx(stiffness[1, 0], rel=2e-3)


def test_middle_of_a_long_roller_is_a_hertz_line_contact() -> None:
    """Its approach: Lundberg's finite line in the half-space, 2 ln(2L/b) + 1 in the middle."""
    length = 100.0 * D
    pressed = press(1e-5, 0.0, 201, STRAIGHT, effective_length=length, share=0.0)
    middle = pressed.load_per_length[100]
    assert pressed.load_per_length[60] == pytest.approx(middle, rel=0.01)
    b = half_width(middle, RHO, E)
    even = 2.0 * middle / (np.pi * E) * (2.0 * np.log(2.0 * length / b) + 1.0)
    assert even == pytest.approx(1e-5, rel=0.02)  # loads at the ends are somewhat greater
    assert pressed.max_pressure[100] == pytest.approx(2.0 * middle / (np.pi * b), rel=1e-12)


def test_smooth_profiles_converge_in_second_order() -> None:
    """Contact within the roller's length: pressure falls to zero on its own."""
    loads = np.array([press(4e-6, 5e-4, n, CROWNED).load for n in (27, 81, 243)])
    errors = np.abs(np.diff(loads))
    assert errors[1] < errors[0] / 3.0**1.5
    assert errors[1] < 2e-4 * loads[-1]


def test_an_edge_peak_grows_with_the_slices_and_the_load_hardly() -> None:
    """A straight roller: the pressure of its ends has no bound, and is that of the last slice."""
    pressed = [press(8e-6, 0.0, n, STRAIGHT) for n in (15, 45, 135)]
    loads = np.array([one.load for one in pressed])
    assert np.all(np.diff(loads) > 0.0)
    assert loads[-1] == pytest.approx(loads[0], rel=0.02)
    peaks = [one.max_pressure.max() for one in pressed]
    assert peaks[0] < 0.9 * peaks[1] < 0.8 * peaks[2]
    middles = [one.max_pressure[one.place.size // 2] for one in pressed]
    np.testing.assert_allclose(middles, middles[0], rtol=2e-3)


@pytest.mark.parametrize("approach", [3e-6, 1e-5, 2e-5])
@pytest.mark.parametrize("slenderness", [1.0, 2.0])
def test_load_is_near_that_of_the_standards_slices(slenderness: float, approach: float) -> None:
    """The standard's profile, from 1.1 to 3.2 GPa: as near as 6 %."""
    length = slenderness * D
    place, answer = slice_places(length, 35), np.empty(6)
    drops = drop(ISO, place, length=length, diameter=D)
    constant = float(contact_constant(length, E)) / length
    independent_slices(approach, 0.0, place, drops, length / 35, constant, np.empty(35), answer)
    pressed = press(approach, effective_length=length)
    assert pressed.load == pytest.approx(answer[0], rel=0.06)


def test_slices_that_know_nothing_of_each_other_miss_the_edge_peak() -> None:
    pressed = press(1e-5, 0.0, given=STRAIGHT)
    assert pressed.load_per_length[0] > 1.5 * pressed.load_per_length[17]
    assert pressed.max_pressure[0] > 1.25 * pressed.max_pressure[17]


@pytest.mark.parametrize("slenderness", [0.1, 1.0, 50.0])
def test_hard_cases_are_solved(slenderness: float) -> None:
    """Whatever a Newton's method on the way may ask for."""
    for given in (STRAIGHT, ISO):
        for approach in (1e-12, 1e-9, 1e-7, 1e-6, 1e-4):
            for tilt in (0.0, 1e-4, -1e-2, 0.1):
                pressed = press(approach, tilt, given=given, effective_length=slenderness * D)
                assert pressed.converged
                assert pressed.load > 0.0
                symmetric = pressed.stiffness + pressed.stiffness.T
                assert np.all(np.linalg.eigvalsh(symmetric) > -1e-9)


@pytest.mark.parametrize(("approach", "tilt"), [(1e-2, 0.0), (1e-6, 10.0), (1e5, 1e5)])
def test_bodies_pressed_through_each_other(approach: float, tilt: float) -> None:
    pressed = press(approach, tilt)
    assert pressed.converged == bool(np.isfinite(pressed.load))
    assert pressed.converged == bool(np.isfinite(pressed.load_per_length).all())


def test_waves_touch_in_many_places() -> None:
    """A profile of hills, as only a table has: contacts that come and go."""
    place = slice_places(L, 101)
    drops = 2e-6 * (1.0 + np.sin(place * 1e4))
    for approach in (1e-7, 1e-6, 3e-6, 1e-5):
        pressed = coupled_press(
            approach, 0.0, drops, effective_length=L, curvature=RHO, modulus=E, roller_diameter=D
        )
        assert pressed.converged
        assert pressed.load > 0.0


def test_any_start_leads_to_the_same_loads() -> None:
    n = 35
    place, width = slice_places(L, n), L / n
    drops = drop(ISO, place, length=L, diameter=D)
    expected = press(1e-5, 2e-3).load_per_length
    rng = np.random.default_rng(1)
    for start in (np.full(n, 1e9), np.full(n, 1e-9), 1e5 * rng.random(n), np.full(n, np.nan)):
        load, answer = start.copy(), np.empty(6)
        number = coupled_slices(
            1e-5, 2e-3, place, drops, width, 2.0 / (np.pi * E), np.full(n, RHO),
            influence_table(n), body_term(n, width, D, 0.5), load, scratch(n), answer,
        )  # fmt: skip
        assert number == 0
        np.testing.assert_allclose(load, expected, rtol=1e-7, atol=1e-7 * expected.max())


def test_no_contact_and_no_number() -> None:
    free = press(-1e-6)
    assert free.converged
    assert free.load == free.moment == 0.0
    assert not free.stiffness.any()
    for bad in ({"approach": np.nan}, {"approach": np.inf}, {"approach": 1e-6, "tilt": np.nan}):
        lost = press(**bad)
        assert not lost.converged
        assert np.isnan(lost.load)
        assert np.isnan(lost.load_per_length).all()
    for name in ("curvature", "modulus"):
        for bad_value in (np.nan, -1.0, np.inf):
            assert not press(1e-6, **{name: bad_value}).converged


def test_room_that_is_too_small_is_refused() -> None:
    n = 5
    load, answer = np.zeros(n), np.empty(6)
    number = coupled_slices(
        1e-6, 0.0, slice_places(L, n), np.zeros(n), L / n, 2.0 / (np.pi * E), np.full(n, RHO),
        influence_table(n), np.zeros(n), load, np.empty((n, n)), answer,
    )  # fmt: skip
    assert number == 1
    assert np.isnan(answer).all()
