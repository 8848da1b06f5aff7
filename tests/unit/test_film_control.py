"""Friction-controlled balls on a film: what the film changes, and where it makes no difference."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import rolamento as ro
from rolamento import system
from rolamento.errors import InputError
from rolamento.lubrication import film as film_of
from rolamento.lubrication.film_control import ShearedFilm, balanced_on_film
from rolamento.oil import roelands
from rolamento.rows.ball.traction.contact import ellipse_nodes
from rolamento.solution import solve
from rolamento.solved import Solved

BEARING = ro.Bearing(
    ball_count=16,
    ball_diameter="22.23 mm",
    pitch_diameter="125.26 mm",
    contact_angle="40 deg",
    inner_conformity=0.5232,
    outer_conformity=0.5232,
)
MU = 0.07


def case(oil: str = "ISO VG 68", fz: float = 0.0, **model: Any) -> ro.Case:
    return ro.Case(
        bearing=BEARING,
        duty=ro.Duty(inner_speed="10000 rpm", load=ro.Load(fx=20e3, fz=fz)),
        lubricant={"base_oil": oil, "friction_coefficient": MU},
        temperature={"lubricant": "60 degC"},
        model={"raceway_control": "friction", "mesh": "coarse", **model},
    )


def test_a_film_that_shears_costs_less_than_friction_and_balances() -> None:
    dry, wet = solve(case()), solve(case(traction="film"))
    assert dry.rolling is not None
    assert wet.rolling is not None
    assert wet.converged[0]
    assert wet.rolling.power[0] < dry.rolling.power[0]
    work = wet.rolling.inner_torque * wet.case.duty.inner_speed
    assert work == pytest.approx(wet.rolling.power, rel=1e-6)
    for contacts, friction in ((wet.inner, wet.rolling.inner), (wet.outer, wet.rolling.outer)):
        pull = np.hypot(friction.force_along, friction.force_across)
        assert (pull <= MU * contacts.load).all()


def test_a_thicker_oil_resists_slip_sooner() -> None:
    """At the races' pressures every oil is all but solid; at a thousandth of it, it is not."""
    nodes = ellipse_nodes(20, 5)
    solved = solve(case())
    thin, thick = (_film(case(oil), solved) for oil in ("ISO VG 32", "ISO VG 460"))
    light = [
        ShearedFilm(
            f.thickness, f.pressure * 1e-3, f.friction, f.viscosity, f.pressure_viscosity, True,
            False,
        ).slip_speed(0, nodes[0], nodes[1])
        for f in (thin, thick)
    ]  # fmt: skip
    inside = light[0] > 0.0
    assert inside.any()
    assert (light[1][inside] < light[0][inside]).all()


def test_slip_speed_is_limiting_friction_over_shear() -> None:
    film = ShearedFilm(
        np.full((1, 1, 2), 2e-7), np.full((1, 1, 2), 1e9), np.array([MU]), np.array([0.03]),
        np.array([2e-8]), True, False,
    )  # fmt: skip
    centre = film.slip_speed(0, np.zeros(1), np.zeros(1))[0, 0, 0]
    assert centre == pytest.approx(MU * 1e9 * 2e-7 / float(roelands(1e9, 0.03, 2e-8)))
    edge = film.slip_speed(0, np.ones(1), np.zeros(1))
    assert (edge == 0.0).all()


def test_without_film_it_is_coulomb() -> None:
    """A film of no thickness neither shears nor lifts."""
    cases, nothing = system.spread(case()), np.zeros((1, 16, 2))
    film = ShearedFilm(
        nothing, nothing, np.array([MU]), np.array([0.03]), np.array([2e-8]), True, True
    )
    one, other = system.balance(cases), system.balance(cases, film)
    np.testing.assert_array_equal(one.place, other.place)
    np.testing.assert_array_equal(one.force, other.force)


def test_a_film_in_the_contact_lifts_the_ring_off_by_its_thickness() -> None:
    """Under thrust both films together move the ring back by their sum over sin α, or nearly."""
    flat, lifted = solve(case()), solve(case(film_in_contact=True))
    films = film_of(lifted)
    inner, outer = films.inner.central_thickness[0, 0], films.outer.central_thickness[0, 0]
    moved = (flat.displacement.x - lifted.displacement.x)[0]
    expected = inner / np.sin(lifted.inner.contact_angle[0, 0])
    expected += outer / np.sin(lifted.outer.contact_angle[0, 0])
    assert inner + outer > 1e-7
    assert moved == pytest.approx(expected, rel=0.25)
    assert lifted.inner.load[0, 0] == pytest.approx(flat.inner.load[0, 0], rel=1e-2)


def test_loads_are_those_of_the_lifted_contacts() -> None:
    """Loads shown come from the approach with the film in it: they balance the ring."""
    solved = solve(case(film_in_contact=True, traction="film", fz=15e3))
    assert solved.rolling is not None
    inner, pull = solved.inner, solved.rolling.inner.force_across
    axial = inner.load * np.sin(inner.contact_angle) + pull * np.cos(inner.contact_angle)
    assert axial.sum() == pytest.approx(20e3, rel=1e-7)


def test_the_film_belongs_to_the_motion_that_it_brings_about() -> None:
    balanced, settled, felt = balanced_on_film(
        system.spread(case(traction="film", film_in_contact=True))
    )
    assert settled.all()
    cases = system.spread(case(traction="film", film_in_contact=True))
    again = film_of(system.result(cases, balanced)).inner.central_thickness
    np.testing.assert_allclose(felt.lift[..., 0], np.nan_to_num(again), rtol=1e-5)


def test_a_batch_is_the_cases_one_by_one() -> None:
    wanted, loads = case(traction="film"), [15e3, 25e3]
    batch = solve(wanted, fx=loads)
    for index, load in enumerate(loads):
        alone = solve(wanted, fx=[load])
        np.testing.assert_allclose(
            batch[index].displacement.array, alone.displacement.array, rtol=1e-6, atol=1e-12
        )


def test_the_film_is_that_of_each_cases_temperature() -> None:
    wanted = case(traction="film")
    batch = solve(wanted, {"temperature.lubricant": [313.15, 353.15]})
    hot = wanted.replace(temperature={"lubricant": 353.15})
    np.testing.assert_allclose(
        batch[1].displacement.array, solve(hot).displacement.array, rtol=1e-6, atol=1e-12
    )


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"model": {"traction": "film"}}, 'for raceway_control = "friction" only'),
        ({"model": {"film_in_contact": True}}, "model.film_in_contact"),
        ({"temperature": None}, "needs an oil or a grease"),
        (
            {"lubricant": {"kind": "dry", "friction_coefficient": 0.1}},
            "needs an oil or a grease",
        ),
    ],
)
def test_what_a_film_needs(change: dict[str, Any], words: str) -> None:
    with pytest.raises(InputError, match=words):
        case(traction="film").replace(**change)


def _film(wanted: ro.Case, solved: Solved) -> ShearedFilm:
    films = film_of(replace(solved, case=wanted))
    pressure = np.stack([solved.inner.max_pressure, solved.outer.max_pressure], axis=-1)
    # the same gap for both: only the oil differs
    gap = np.full_like(pressure, 3e-7)
    return ShearedFilm(
        gap, pressure, np.array([MU]), films.dynamic_viscosity, films.pressure_viscosity,
        True, False,
    )  # fmt: skip


def test_a_film_that_does_not_settle_leaves_no_number(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rolamento.lubrication.film_control.PASSES", 1)
    solved = solve(case(film_in_contact=True))
    assert solved.status.code.tolist() == ["not_converged"]
    for array in (
        solved.displacement.array, solved.load.array, solved.stiffness.array, solved.rows.load,
        solved.inner.load,
    ):  # fmt: skip
        assert np.isnan(array).all()
