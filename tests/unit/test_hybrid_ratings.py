"""Ratings with elements of another stiffness than the rings: by Hertz at the same pressure."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento import Case, analyse, solve
from rolamento.case import case_of
from rolamento.life import conditions_of
from rolamento.life.hybrid import is_of_steel, static_share
from rolamento.safety import static_safety_of

LOAD = {"duty.load.fz": "5 kN", "duty.inner_speed": "3000 rpm"}


def case(designation: str, **more: object) -> Case:
    return case_of(designation, {**LOAD, **more})


def test_silicon_nitride_leaves_seven_tenths() -> None:
    """0.7 is what makers list; by E of 300 to 320 GPa it is 0.69 to 0.72."""
    assert static_share(case("6310/HC5").bearing) == pytest.approx(0.7, abs=0.02)


def test_steels_of_nearly_the_same_stiffness_count_as_one() -> None:
    bearing = case("6310", **{"bearing.ball_material": "440C"}).bearing
    assert is_of_steel(bearing)
    assert static_share(bearing) == 1.0


def test_ceramic_rollers_lose_by_the_first_power() -> None:
    ball = static_share(case("6310/HC5").bearing)
    roller = static_share(case("NU 210", **{"bearing.roller_material": "Si3N4"}).bearing)
    assert roller**2 == pytest.approx(ball)


def test_the_catalogue_is_multiplied_and_c_is_not() -> None:
    steel, hybrid = (conditions_of(case(name)) for name in ("6310", "6310/HC5"))
    share = static_share(case("6310/HC5").bearing)
    assert hybrid.static_rating == pytest.approx(share * steel.static_rating)  # type: ignore[operator]
    assert hybrid.dynamic_rating == steel.dynamic_rating


def test_a_rating_that_is_given_stays() -> None:
    given = case("6310/HC5", **{"life.static_rating": "30 kN"})
    assert conditions_of(given).static_rating == 30e3


def test_by_the_geometry_it_is_the_same_share() -> None:
    fields = {"ball_count": 16, "ball_diameter": 0.02223, "pitch_diameter": 0.12526,
              "contact_angle": 0.698, "inner_conformity": 0.5232,
              "outer_conformity": 0.5232}  # fmt: skip
    from rolamento import Bearing, Duty, Load

    found = []
    for material in ("100Cr6", "Si3N4"):
        bearing = Bearing(**fields, ball_material=material)
        solved = Case(bearing=bearing, duty=Duty(load=Load(fx=20e3)))
        found.append(static_safety_of(solved).rating[0, 0])
    assert found[1] / found[0] == pytest.approx(static_share(bearing))


def test_at_c_0_both_have_the_limiting_pressure() -> None:
    """Why C_0 falls: with stiffer balls the same load presses harder."""
    pressures = []
    for name in ("6310", "6310/HC5"):
        one = case(name, **{"bearing.diametral_clearance": "0 mm", "duty.inner_speed": "0 rpm"})
        rating = float(conditions_of(one).static_rating)  # type: ignore[arg-type]
        pressures.append(float(solve(one.with_(fz=rating)).inner.max_pressure.max()))
    assert pressures[1] == pytest.approx(pressures[0], rel=0.02)


def test_the_static_safety_of_a_hybrid_bearing_is_known() -> None:
    life = analyse(case("6310/HC5")).life
    assert life is not None
    assert np.isfinite(life.loads.safety[0])
    assert "no_static_rating" not in {note.key for note in life["iso281"].notes_of()}
