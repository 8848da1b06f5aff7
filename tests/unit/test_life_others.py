"""Tallian's form, L_able, spectra and several bearings."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.one_case import keys

import rolamento
from rolamento import load_case
from rolamento.case.life_model import LifeModel
from rolamento.contact.hertz import elliptical_contact
from rolamento.contact.subsurface import orthogonal_shear
from rolamento.errors import InputError
from rolamento.life import LifeSummary, life
from rolamento.life.iso16281 import ROLLER_SLOPE
from rolamento.life.l_able import (
    FactorTable,
    l_able,
    life_with_surface,
    load_parameter,
    refusals,
    surface_factor,
)
from rolamento.life.spectrum import (
    miner_life,
    races_under_spectrum,
    revolution_shares,
    shaft_life,
)
from rolamento.life.tallian import (
    TallianFactors,
    lundberg_palmgren_integral,
    risk,
    survival,
    tallian_life,
)
from rolamento.solution import solve

EXAMPLE = Path(rolamento.__file__).parent / "examples" / "6305_life.toml"
RPM = np.pi / 30.0
ORIGIN = TallianFactors(
    strength=1e-9,
    defect_shape=2.0,
    defect_density=0.5,
    failure_rate=3.0,
    pressure_distribution=1.5,
)


def test_tallian_life_and_survival_agree() -> None:
    life = tallian_life(ORIGIN, [0.5, 0.9])
    assert survival((ORIGIN,), life) == pytest.approx([0.5, 0.9], rel=1e-12)
    assert risk(ORIGIN, 0.0) == 0.0
    two = survival((ORIGIN, ORIGIN), life)
    assert two == pytest.approx([0.25, 0.81], rel=1e-12)


def test_tallians_factors_must_be_given_and_positive() -> None:
    with pytest.raises(InputError, match="defect_density"):
        TallianFactors(defect_density=0.0)
    with pytest.raises(InputError, match="exponent"):
        TallianFactors(exponent=-1.0)
    with pytest.raises(InputError, match="pressure_distribution"):
        TallianFactors(strength=1.0, failure_rate=1.0)
    with pytest.raises(InputError, match="strength"):
        TallianFactors(pressure_distribution=1.0, failure_rate=1.0)
    with pytest.raises(InputError, match="strength: is missing"):
        tallian_life(TallianFactors())
    with pytest.raises(InputError, match=r"tallian_surface\.failure_rate"):
        LifeModel(tallian_surface=TallianFactors(strength=1.0))


def test_lundberg_and_palmgren_as_a_special_case() -> None:
    """With their factors, life falls with the cube of the load."""
    lives = []
    for load in (500.0, 1000.0):
        hertz = elliptical_contact(load, 250.0, 8.0, 2.27e11)
        shear = orthogonal_shear(hertz.max_pressure, hertz.semi_major, hertz.semi_minor)
        integral = lundberg_palmgren_integral(hertz.semi_major, shear.amplitude, shear.depth, 0.1)
        factors = TallianFactors(
            strength=1e-97, failure_rate=float(integral), pressure_distribution=1.0
        )
        lives.append(float(tallian_life(factors)))
    assert lives[0] / lives[1] == pytest.approx(8.0, rel=1e-9)


def lives_of_6305(**table: object) -> LifeSummary:
    case = load_case(EXAMPLE)
    assert case.life is not None
    return life(solve(case.replace(life=case.life.replace(**table))))


def test_tallian_without_factors_of_its_own_is_the_reference_life() -> None:
    found = lives_of_6305(tallian_subsurface=TallianFactors())
    assert found["tallian"].life == pytest.approx(found["iso16281"].life, rel=1e-12)
    assert found["tallian"].valid[0]
    assert {"factors_of_the_user", "surface_left_out"} <= keys(found["tallian"].notes_of())
    assert "tallian" not in lives_of_6305().theories


def test_tallian_life_falls_with_the_density_of_defects_by_its_power() -> None:
    one, two = (
        lives_of_6305(tallian_subsurface=TallianFactors(defect_density=density))["tallian"].life
        for density in (1.0, 2.0)
    )
    assert two / one == pytest.approx(2.0**-0.9, rel=1e-12)


def test_tallian_with_lundberg_and_palmgrens_constant_comes_near_the_reference_life() -> None:
    """A of both races is alike within 20 %: with one of them the lives of all loads go together."""
    ratios = []
    for load in (1000.0, 2000.0, 4000.0):
        case = load_case(EXAMPLE, [f"duty.load.fz={load} N"])
        assert case.life is not None
        factors = TallianFactors(strength=1e-97)
        found = life(solve(case.replace(life=case.life.replace(tallian_subsurface=factors))))
        ratios.append(float(found["tallian"].life[0] / found["iso16281"].life[0]))
    # not quite, for under less radial load the axial one puts the contacts at another angle
    assert ratios == pytest.approx([ratios[0]] * 3, rel=0.05)


def test_tallian_adds_the_risk_from_the_surface() -> None:
    surface = {"strength": 1e-12, "failure_rate": 1.0, "pressure_distribution": 1.0}
    below = lives_of_6305(tallian_subsurface=TallianFactors())["tallian"]
    both = lives_of_6305(tallian_surface=TallianFactors(**surface, exponent=2.0))["tallian"]
    alike = lives_of_6305(tallian_surface=TallianFactors(**surface))["tallian"]
    assert both.life[0] < below.life[0]
    assert alike.life[0] < below.life[0]
    assert "surface_left_out" not in keys(both.notes_of())


def test_tallian_for_another_reliability() -> None:
    """By its own exponent, not by a_1 of the standard."""
    found = lives_of_6305(tallian_subsurface=TallianFactors(), reliability=0.98)["tallian"]
    ratio = (np.log(0.98) / np.log(0.9)) ** 0.9
    assert found.life[0] / found.basic[0] == pytest.approx(ratio, rel=1e-12)


TABLE = FactorTable(
    np.array([0.1, 1.0, 4.0]),
    np.array([0.01, 0.1, 1.0]),
    np.array([[1.0, 0.3, 0.1], [30.0, 2.0, 0.2], [50.0, 8.0, 0.5]]),
)


def test_table_gives_back_what_was_read() -> None:
    for row, kappa in enumerate(TABLE.viscosity_ratio):
        assert TABLE.at(kappa, TABLE.load_parameter) == pytest.approx(TABLE.factor[row], rel=1e-12)
    between = TABLE.at(np.sqrt(0.1), 0.1)
    assert between == pytest.approx(np.sqrt(0.3 * 2.0))


def test_table_is_never_continued() -> None:
    assert np.all(np.isnan(TABLE.at([0.05, 5.0, 1.0, 1.0], [0.1, 0.1, 0.001, 2.0])))
    assert TABLE.at(1.0, -0.1) == np.inf


@pytest.mark.parametrize(
    ("kappa", "load", "factor"),
    [
        ([1.0, 0.1], [0.1, 1.0], np.ones((2, 2))),
        ([0.1, 1.0], [0.1, 1.0], np.ones((2, 3))),
        ([0.1, 1.0], [0.1, 1.0], np.zeros((2, 2))),
        ([0.1, np.nan], [0.1, 1.0], np.ones((2, 2))),
        ([0.1], [0.1, 1.0], np.ones((1, 2))),
    ],
)
def test_wrong_tables(kappa: list[float], load: list[float], factor: np.ndarray) -> None:
    with pytest.raises(InputError):
        FactorTable(np.array(kappa), np.array(load), factor)


def test_refusals_of_the_maker() -> None:
    loads = np.array([5000.0, 11000.0, 5000.0, 5000.0])
    speeds = np.array([2000.0, 2000.0, 10.0, 2000.0]) * RPM
    refused = refusals(loads, 20000.0, 11200.0, speeds, [350.0, 350.0, 350.0, 410.0])
    assert list(refused["load_above_half_rating"]) == [False, True, False, False]
    assert list(refused["too_slow"]) == [False, False, True, False]
    assert list(refused["too_hot"]) == [False, False, False, True]
    life = l_able(100.0, 0.5, refused, 0.62)
    assert life[0] == pytest.approx(31.0)
    assert np.all(np.isnan(life[1:]))
    assert not np.any(refusals(5000.0, 20000.0, 11200.0, 20.0 * RPM, np.nan)["too_slow"])


def test_load_parameter() -> None:
    assert load_parameter(1000.0, 200.0, 10000.0, 0.8) == pytest.approx(0.1)
    with pytest.raises(InputError, match="contamination_factor"):
        load_parameter(1000.0, 200.0, 10000.0, 0.0)


def test_surface_risk_from_a_known_factor() -> None:
    f = surface_factor(0.7, 100.0, 900.0)
    assert 0.0 < f < 1.0
    assert life_with_surface(900.0, f) == pytest.approx(70.0)
    assert np.isnan(surface_factor(20.0, 100.0, 900.0))
    with pytest.raises(InputError, match="surface_factor"):
        life_with_surface(900.0, 1.5)


def test_miner() -> None:
    assert miner_life([10.0, 20.0], [0.5, 0.5]) == pytest.approx(1.0 / (0.05 + 0.025))
    assert miner_life([10.0, np.inf], [0.5, 0.5]) == pytest.approx(20.0)
    assert miner_life([10.0, np.nan], [1.0, 0.0]) == pytest.approx(10.0)
    assert np.isnan(miner_life([10.0, np.nan], [0.5, 0.5]))
    assert miner_life([[7.0, 3.0]] * 4, [0.25] * 4) == pytest.approx([7.0, 3.0])


def test_wrong_shares() -> None:
    with pytest.raises(InputError, match="sum to 1"):
        miner_life([10.0, 20.0], [0.5, 0.4])
    with pytest.raises(InputError, match="as many"):
        miner_life([10.0, 20.0], [1.0])
    with pytest.raises(InputError, match="shares"):
        miner_life([10.0, 20.0], [1.5, -0.5])
    with pytest.raises(InputError, match="speeds: must not all be zero: nothing rotates"):
        revolution_shares([0.5, 0.5], [0.0, 0.0])


def test_hours_and_revolutions_give_one_life() -> None:
    """Two steps at different speeds, in revolutions and in hours."""
    times, speeds = np.array([0.7, 0.3]), np.array([1000.0, 3000.0])
    revolutions = np.array([90e6, 20e6])
    in_hours = miner_life(revolutions / (60.0 * speeds), times)
    in_turns = miner_life(revolutions, revolution_shares(times, speeds))
    mean_speed = float(times @ speeds)
    assert in_hours == pytest.approx(in_turns / (60.0 * mean_speed))


def test_damage_is_gathered_race_by_race() -> None:
    inner, outer = np.array([[10.0], [1000.0]]), np.array([[1000.0], [10.0]])
    apart = races_under_spectrum(inner, outer, [0.5, 0.5])
    assert apart == pytest.approx(2.0**-0.9 / (0.05 + 0.0005))


def test_shaft() -> None:
    assert shaft_life([100.0, 100.0, 100.0]) == pytest.approx(100.0 * 3.0**-0.9)
    assert shaft_life([100.0, np.inf]) == pytest.approx(100.0)
    lives = np.array([[100.0, 300.0], [np.nan, 5.0]])
    same = shaft_life(lives, slope=[10 / 9, 10 / 9])
    assert same[0] == pytest.approx(shaft_life(lives)[0], rel=1e-12)
    assert np.isnan(same[1])
    mixed = shaft_life([100.0, 300.0], slope=[10 / 9, ROLLER_SLOPE])
    total = (mixed / 100.0) ** (10 / 9) + (mixed / 300.0) ** ROLLER_SLOPE
    assert total == pytest.approx(1.0, rel=1e-12)
    with pytest.raises(InputError, match="slope"):
        shaft_life([1.0, 2.0], slope=[1.0, 1.0, 1.0])
