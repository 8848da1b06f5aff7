"""Friction-controlled balls on a film: what the film changes, and where it makes no difference."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from tests.one_case import solve_one

import rolamento as ro
from rolamento.assembly import balance, result, solve_cases, spread
from rolamento.errors import InputError
from rolamento.lubrication import film_of_batch
from rolamento.lubrication.film_control import ShearedFilm, solve_on_film
from rolamento.oil.piezoviscosity import roelands
from rolamento.rows import ball as equilibrium
from rolamento.rows.ball.traction.contact import ellipse_nodes
from rolamento.solving import solve

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
    dry, wet = solve_one(case()), solve_one(case(traction="film"))
    assert dry.rolling is not None
    assert wet.rolling is not None
    assert wet.status.converged
    assert wet.rolling.power < dry.rolling.power
    work = wet.rolling.inner_torque * wet.case.duty.inner_speed
    assert work == pytest.approx(wet.rolling.power, rel=1e-6)
    for ball, moved in zip(wet.balls, wet.rolling.balls, strict=True):
        for race in ("inner", "outer"):
            friction = getattr(moved, race)
            pull = np.hypot(friction.force_along, friction.force_across)
            assert pull <= MU * getattr(ball, race).load


def test_a_thicker_oil_resists_slip_sooner() -> None:
    """At the races' pressures every oil is all but solid; at a thousandth of it, it is not."""
    nodes = ellipse_nodes(20, 5)
    batch = ro.solve(case())
    thin, thick = (_film(case(oil), batch) for oil in ("ISO VG 32", "ISO VG 460"))
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
    plain = case()
    columns = spread(plain, {})
    nothing = np.zeros((1, 16, 2))
    film = ShearedFilm(
        nothing, nothing, np.array([MU]), np.array([0.03]), np.array([2e-8]), True, True
    )
    one, other = solve_cases(columns), result(columns, balance(columns, film))
    np.testing.assert_array_equal(one.displacement.array, other.displacement.array)
    np.testing.assert_array_equal(one.load.array, other.load.array)


def test_a_film_in_the_contact_lifts_the_ring_off_by_its_thickness() -> None:
    """Under thrust both films together move the ring back by their sum over sin α, or nearly."""
    flat, lifted = ro.solve(case()), ro.solve(case(film_in_contact=True))
    films = film_of_batch(case(), lifted)
    both = films.inner.central_thickness[0, 0] + films.outer.central_thickness[0, 0]
    moved = flat.displacement.array[0, 0] - lifted.displacement.array[0, 0]
    angles = lifted
    inner, outer = angles.inner.contact_angle[0, 0], angles.outer.contact_angle[0, 0]
    expected = films.inner.central_thickness[0, 0] / np.sin(inner)
    expected += films.outer.central_thickness[0, 0] / np.sin(outer)
    assert both > 1e-7
    assert moved == pytest.approx(expected, rel=0.25)
    assert angles.inner.load[0, 0] == pytest.approx(flat.inner.load[0, 0], rel=1e-2)


def test_loads_are_those_of_the_lifted_contacts() -> None:
    """Loads shown come from the approach with the film in it: they balance the ring."""
    state = solve_one(case(film_in_contact=True, traction="film", fz=15e3))
    assert state.rolling is not None
    axial = 0.0
    for ball, moved in zip(state.balls, state.rolling.balls, strict=True):
        angle = ball.inner.contact_angle
        axial += ball.inner.load * np.sin(angle) + moved.inner.force_across * np.cos(angle)
    assert axial == pytest.approx(20e3, rel=1e-7)


def test_the_film_belongs_to_the_motion_that_it_brings_about() -> None:
    wanted = case(traction="film", film_in_contact=True)
    batch = solve_on_film(wanted, spread(wanted, {}))
    once_more = ro.solve(wanted)
    np.testing.assert_allclose(batch.displacement.array, once_more.displacement.array, rtol=1e-12)
    again = film_of_batch(wanted, batch).inner.central_thickness
    used = batch.answer.motion
    assert used is not None
    np.testing.assert_allclose(used.lift[..., 0], np.nan_to_num(again), rtol=1e-5)


def test_a_batch_is_the_cases_one_by_one() -> None:
    wanted = case(traction="film")
    loads = [15e3, 25e3]
    batch = ro.solve(wanted, fx=loads)
    for index, load in enumerate(loads):
        alone = ro.solve(wanted, fx=[load])
        np.testing.assert_allclose(
            batch.displacement.array[index], alone.displacement.array[0], rtol=1e-6, atol=1e-12
        )


def test_the_equilibrium_by_itself_sends_on() -> None:
    for call in (equilibrium.solve, equilibrium.solve_batch):
        with pytest.raises(InputError, match=r"rolamento\.solve"):
            call(case(traction="film"))


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


def _film(wanted: ro.Case, batch: ro.Solved) -> ShearedFilm:
    films = film_of_batch(wanted, batch)
    thickness = np.stack([films.inner.central_thickness, films.outer.central_thickness], axis=-1)
    pressure = np.stack([batch.contacts[race].max_pressure for race in ("inner", "outer")], axis=-1)
    # the same gap for both: only the oil differs
    gap = np.full_like(thickness, 3e-7)
    return ShearedFilm(
        gap, pressure, np.array([MU]), films.oil.dynamic_viscosity, films.oil.pressure_viscosity,
        True, False,
    )  # fmt: skip


def test_a_film_that_does_not_settle_leaves_no_number(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rolamento.lubrication.film_control.PASSES", 1)
    batch = solve(case(film_in_contact=True))
    assert batch.status.code.tolist() == ["not_converged"]
    rolling = batch.answer.motion
    assert rolling is not None
    for array in (
        batch.displacement.array, batch.load.array, batch.stiffness.array, batch.rows.load,
        rolling.power, batch.inner.load,
    ):  # fmt: skip
        assert np.isnan(array).all()
