"""The parameters of a case: the stiffness polynomials, scaling, and what a batch may override."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento.case import Case
from rolamento.case.bearing import Bearing
from rolamento.errors import InputError
from rolamento.rows.ball import layout
from rolamento.rows.ball.problem import ring_arms
from rolamento.static import race_stiffness
from rolamento.system import spread


@pytest.mark.parametrize(
    ("ratio", "tolerance"), [(0.05, 1e-13), (0.1775, 1e-10), (0.3, 5e-9), (0.45, 2e-7)]
)
@pytest.mark.parametrize("conformity", [0.505, 0.52, 0.6])
def test_polynomials_follow_the_exact_stiffness(
    ratio: float, tolerance: float, conformity: float, case_218: Case
) -> None:
    bearing = Bearing(
        ball_count=4,
        ball_diameter=0.02,
        pitch_diameter=0.02 / ratio,
        contact_angle=0.5,
        inner_conformity=conformity,
        outer_conformity=conformity,
    )
    p = spread(case_218.replace(bearing=bearing)).rows[0].row.p.whole()[:, 0]
    angles = np.linspace(0.0, np.pi / 2, 200)
    stiffness = race_stiffness(bearing, angles)
    for first, exact in (
        (layout.INNER_STIFFNESS, stiffness.inner),
        (layout.OUTER_STIFFNESS, stiffness.outer),
        (layout.SERIES_STIFFNESS, stiffness.combined),
    ):
        fitted = np.polynomial.polynomial.polyval(np.cos(angles), p[first : first + 7])
        np.testing.assert_allclose(fitted, exact, rtol=tolerance)


def test_a_batch_repeats_the_case(case_218: Case) -> None:
    p = spread(case_218, {"fz": [1.0, 2.0, 3.0]}).rows[0].row.p
    single = spread(case_218).rows[0].row.p.whole()
    assert p.duty.shape == (layout.DUTY, 3)
    assert p.bearing.shape == (layout.COLUMN - layout.DUTY, 1)
    np.testing.assert_array_equal(p[layout.APPLIED + 2], [1.0, 2.0, 3.0])
    others = np.arange(layout.COLUMN) != layout.APPLIED + 2
    np.testing.assert_array_equal(p.whole()[others], np.repeat(single[others], 3, axis=1))


def test_what_varies_of_the_bearing_has_columns_of_its_own(case_218: Case) -> None:
    angles = np.array([0.6, 0.7])
    p = spread(case_218, {"bearing.contact_angle": angles, "fx": [1.0, 2.0]}).rows[0].row.p
    assert p.bearing.shape == (layout.COLUMN - layout.DUTY, 2)
    for k, angle in enumerate(angles):
        bearing = case_218.bearing.replace(contact_angle=float(angle))
        single = spread(case_218.replace(bearing=bearing), {"fx": 1.0 + k}).rows[0].row.p
        np.testing.assert_allclose(p.of([k]).whole(), single.whole(), rtol=1e-12)
    np.testing.assert_array_equal(p.whole()[layout.DUTY :], p.bearing)


def test_loads_free_and_displacements_hold(case_218: Case) -> None:
    p = spread(case_218, {"my": [5.0, 6.0], "x": 1e-5}).rows[0].row.p
    arm = ring_arms(p)[3]
    np.testing.assert_array_equal(p[layout.FREE : layout.FREE + 5][:, 0], [0, 1, 1, 1, 0])
    np.testing.assert_allclose(p[layout.APPLIED + 3] * arm, [5.0, 6.0])
    np.testing.assert_array_equal(p[layout.APPLIED], 0.0)
    np.testing.assert_array_equal(p[layout.IMPOSED], 1e-5)


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"fx": [1.0, 2.0], "fz": [1.0]}, "one length"),
        ({"fx": [[1.0]]}, "one-dimensional"),
        ({"f_x": [1.0]}, "fx"),
        ({"x": [0.0], "fx": [1.0]}, "cannot be combined with"),
    ],
)
def test_a_batch_refuses(case_218: Case, fields: dict, words: str) -> None:
    with pytest.raises(InputError, match=words):
        spread(case_218, fields)
