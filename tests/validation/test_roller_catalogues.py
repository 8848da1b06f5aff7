"""The roller bearings of the catalogue against ISO's rules, each other and what they do not print.

NSK prints C, C0 and of cylindrical roller bearings the diameter of one raceway; SKF those of both
or of one. What the one prints of a size is what the inference from the other's list must find.
"""

from __future__ import annotations

from math import atan, degrees, pi, tan

import numpy as np
import pytest

from rolamento.catalogue import CatalogueBearing, catalogue, geometry_of, inferred_rollers
from rolamento.catalogue.roller_inference import roller_diameters
from rolamento.ratings import roller_dynamic_rating, roller_static_rating

BUILT_IN = catalogue().bearings


def of(kind: str, maker: str = "NSK") -> list[CatalogueBearing]:
    return [one for one in BUILT_IN if one.kind == kind and one.maker == maker]


def of_both_raceways(maker: str) -> list[tuple[CatalogueBearing, float, float]]:
    """Bearings with F_w and E_w of their size and ratings, one of each size; m."""
    raceways: dict[tuple[float, ...], dict[str, float]] = {}
    first: dict[tuple[float, ...], CatalogueBearing] = {}
    for one in of("cylindrical", maker):
        if None in one.rated:
            continue
        size = (one.bore, one.outside_diameter, one.width or 0.0, *(one.rated))
        first.setdefault(size, one)  # type: ignore[arg-type]
        known = raceways.setdefault(size, {})  # type: ignore[arg-type]
        for name in ("inner_raceway_diameter", "outer_raceway_diameter"):
            if getattr(one, name) is not None:
                known[name] = getattr(one, name)
    return [
        (first[size], known["inner_raceway_diameter"], known["outer_raceway_diameter"])
        for size, known in raceways.items()
        if len(known) == 2
    ]


def isos_ratio(
    bearing: CatalogueBearing, inner: float, outer: float, filling: float = 0.78
) -> float:
    """C of ISO 281 for rollers that have the printed C0, over the printed C.

    Z and L_we stand in C0 as a product; what is left, Z^(-1/36), hardly depends on the filling.
    """
    roller, pitch = 0.5 * (outer - inner), 0.5 * (outer + inner)
    count = round(filling * pi * pitch / roller)
    dynamic, static = bearing.rated
    assert dynamic is not None
    assert static is not None
    length = static / float(roller_static_rating(count, roller, 1.0, pitch))
    return float(roller_dynamic_rating(count, roller, length, pitch)) / dynamic


def test_nsk_rates_by_the_standards() -> None:
    """Where both raceways are printed, C and C0 of NSK agree with ISO 281 and ISO 76 to 1.4 %."""
    ratios = [isos_ratio(*one) for one in of_both_raceways("NSK")]
    assert len(ratios) > 60
    assert max(abs(ratio - 1.0) for ratio in ratios) < 0.014
    assert np.mean(ratios) == pytest.approx(1.0, abs=0.003)
    assert np.std(ratios) < 0.005


def test_skf_rates_explorer_bearings_higher() -> None:
    """Others by ISO; Explorer bearings 1.13 to 1.16 times as high."""
    factors = np.array([1.0 / isos_ratio(*one) for one in of_both_raceways("SKF")])
    explorer = factors > 1.07
    assert explorer.sum() > 20
    assert factors[explorer].min() > 1.12
    assert factors[explorer].max() < 1.17
    assert np.abs(factors[~explorer] - 1.0).max() < 0.015


def test_rollers_of_nsk_are_those_between_the_raceways_of_skf() -> None:
    """NSK prints F_w alone of its E designs; E_w of SKF's equals are kept from the inference."""
    theirs = {
        (one.bore, one.outside_diameter, one.width, inner): outer
        for one, inner, outer in of_both_raceways("SKF")
    }
    compared, right = 0, 0
    for one in of("cylindrical"):
        if not one.designation.startswith("NU") or one.outer_raceway_diameter is not None:
            continue
        key = (one.bore, one.outside_diameter, one.width, one.inner_raceway_diameter)
        if key not in theirs or " E" not in one.designation.replace("EW", "E").replace("ET", "E"):
            continue
        compared += 1
        best = inferred_rollers(one, most=1)[0]
        true = 0.5 * (theirs[key] - (one.inner_raceway_diameter or 0.0))  # type: ignore[operator]
        right += abs(best.roller_diameter - true) < 0.3e-3
        assert best.roller_diameter == pytest.approx(true, rel=0.06)
    assert compared > 15
    assert right / compared > 0.9


def test_needles_come_out_with_standard_diameters() -> None:
    """Inner raceway, C and C0 alone; that found diameters are standard ones was not put in."""
    standard = roller_diameters()
    for name, known in (("NA 4905", 4.0), ("HK 2020", 2.0)):
        best = inferred_rollers(catalogue().find(name).bearing, most=1)[0]
        assert 1e3 * best.roller_diameter == pytest.approx(known)
        assert np.abs(standard - best.roller_diameter).min() < 1e-6


def test_cages_of_needles_are_rated_by_the_standards() -> None:
    """K: F_w and E_w are printed, so C/C0 is a check without any unknown but Z^(1/36)."""
    ratios = [isos_ratio(*one, filling=0.6) for one in _of_cages()]
    assert len(ratios) > 60
    assert np.mean(ratios) == pytest.approx(1.0, abs=0.005)
    assert np.std(ratios) < 0.008


def _of_cages() -> list[tuple[CatalogueBearing, float, float]]:
    return [
        (one, one.inner_raceway_diameter, one.outer_raceway_diameter)
        for one in of("needle")
        if one.inner_raceway_diameter and one.outer_raceway_diameter and None not in one.rated
    ]


def test_factors_of_tapered_bearings_tell_one_angle() -> None:
    """ISO 281 and ISO 76: e = 1.5 tan α, Y = 0.4 cot α, Y0 = 0.22 cot α, each as rounded."""
    for one in of("tapered"):
        assert one.axial_limit is not None
        assert one.axial_factor is not None
        assert one.static_axial_factor is not None
        low, high = (atan((one.axial_limit + d) / 1.5) for d in (-0.0051, 0.0051))
        by_y = sorted(atan(0.4 / (one.axial_factor + d)) for d in (-0.051, 0.051))
        assert max(low, by_y[0]) <= min(high, by_y[1]) + 2e-3, one.designation
        by_0 = [0.22 / tan(angle) for angle in (high, low)]
        half = 0.051 if one.static_axial_factor >= 1.0 else 0.0051
        assert by_0[0] - half <= one.static_axial_factor * 1.006, one.designation
        assert one.static_axial_factor <= by_0[1] + half + 6e-3, one.designation


def test_the_load_centre_lies_on_the_normal_of_the_cups_raceway() -> None:
    """a, which no rule of inference has seen, gives the place of the rollers' middle in the cup."""
    places = []
    for one in of("tapered")[::4]:
        fields = geometry_of(one.designation).fields
        assert one.load_centre is not None
        assert one.width is not None
        angle = fields["contact_angle"]
        radius = 0.5 * (fields["pitch_diameter"] + fields["roller_diameter"] * np.cos(angle))
        middle = one.load_centre - radius * tan(angle)
        places.append((middle - 0.5 * (one.outer_width or 0.0)) / one.width)
        assert 10.0 < degrees(angle) < 31.0
    assert abs(float(np.median(places))) < 0.03
    assert np.percentile(np.abs(places), 90) < 0.08
