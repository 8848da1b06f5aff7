"""Factors and fatigue load limits of roller bearings as makers list them, against the standards'.

NSK, Rolling Bearings (CAT. No. E1102e), single-row tapered roller bearings, pages B112 to B129;
SKF, product tables of tapered and cylindrical roller bearings, as the catalogue here cites them.
"""

from __future__ import annotations

import pytest

from rolamento.case import case_of
from rolamento.catalogue import CatalogueBearing, catalogue
from rolamento.life import life
from rolamento.life.equivalent_load import ListedFactors, equivalent_load, static_equivalent_load
from rolamento.life.iso281_modified import fatigue_load_limit
from rolamento.solution import solve

TAPERED = [one for one in catalogue().bearings if one.type.conical and one.axial_factor is not None]
LIMITED = [one for one in catalogue().bearings if one.fatigue_load_limit is not None]


def test_hr_30305_dj_by_hand() -> None:
    """NSK E1102, page B114: e 0.83, Y 0.73, Y_0 0.40; 1569 N radial, 3474 N axial, 600 r/min."""
    settings = ["duty.load.fz=1569 N", "duty.load.fx=3474 N", "duty.inner_speed=600 rpm"]
    loads = life(solve(case_of("HR 30305 DJ", settings))).loads
    assert loads.dynamic[0] == pytest.approx(0.4 * 1569 + 0.73 * 3474)
    assert loads.dynamic[0] == pytest.approx(3164, abs=0.5)
    assert loads.static[0] == pytest.approx(0.5 * 1569 + 0.40 * 3474)


def test_every_maker_s_factors_are_those_of_one_angle() -> None:
    """E = 1.5 tan α and Y = 0.4 cot α: e Y = 0.6, as far as their digits go; Y_0/Y = 0.55."""
    assert len(TAPERED) > 300
    for one in TAPERED:
        assert one.axial_limit is not None
        assert one.axial_factor is not None
        step = 0.05 if one.axial_factor >= 1.0 else 0.005
        room = 0.005 / one.axial_limit + step / one.axial_factor
        assert one.axial_limit * one.axial_factor == pytest.approx(0.6, rel=1.1 * room), one
        if one.static_axial_factor is not None:
            step_0 = 0.05 if one.static_axial_factor >= 0.995 or one.maker == "SKF" else 0.005
            room = step / one.axial_factor + step_0 / one.static_axial_factor
            ratio = one.static_axial_factor / one.axial_factor
            assert ratio == pytest.approx(0.55, rel=1.1 * room), one


@pytest.mark.parametrize("one", TAPERED[:: len(TAPERED) // 12], ids=lambda b: b.designation)
def test_loads_by_listed_factors(one: CatalogueBearing) -> None:
    assert one.axial_limit is not None
    assert one.axial_factor is not None
    assert one.static_axial_factor is not None
    listed = ListedFactors(one.axial_limit, one.axial_factor, one.static_axial_factor)
    for radial, axial in ((1000.0, 2000.0), (1000.0, 0.5 * one.axial_limit * 1000.0)):
        found = equivalent_load(radial, axial, 0.2, 0.0, kind="roller", listed=listed)
        by_hand = 0.4 * radial + one.axial_factor * axial
        assert found.load == pytest.approx(by_hand if axial / radial > one.axial_limit else radial)
        still = static_equivalent_load(radial, axial, 0.2, kind="roller", listed=listed)
        by_hand = max(0.5 * radial + one.static_axial_factor * axial, radial)
        assert still == pytest.approx(by_hand)


@pytest.mark.parametrize(
    ("kind", "low", "high"), [("cylindrical", 0.94, 1.11), ("tapered", 0.8, 0.94)]
)
def test_printed_fatigue_load_limits_beside_the_simplified_ones(
    kind: str, low: float, high: float
) -> None:
    """SKF's C_u over C_0/8.2, the estimate of ISO 281:2007, B.3.3: of tapered rollers below it."""
    shares = []
    for one in LIMITED:
        if one.kind == kind:
            assert one.static_rating is not None
            assert one.fatigue_load_limit is not None
            estimate = fatigue_load_limit(one.static_rating, one.mean_diameter, rollers=True)
            shares.append(one.fatigue_load_limit / float(estimate))
    assert len(shares) >= 26
    assert low <= min(shares)
    assert max(shares) <= high
