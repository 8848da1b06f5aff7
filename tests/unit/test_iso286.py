"""ISO 286 and ISO 492: against tables that others print, and against the standard's formulas."""

from __future__ import annotations

from itertools import pairwise
from math import sqrt

import pytest

from rolamento.clearance import (
    Band,
    bore_deviations,
    hole_deviations,
    outside_deviations,
    shaft_deviations,
    standard_tolerance,
)
from rolamento.errors import InputError
from rolamento.io.data import toml_of

SIZES = toml_of("iso286", "rolamento.clearance")["sizes_mm"]
STEPS = list(pairwise(SIZES))


def micrometres(band: Band) -> tuple[float, float]:
    return round(band.low * 1e6, 6), round(band.high * 1e6, 6)


# Longxi, Fits of radial spherical plain bearings: upper and lower deviation by size, in µm.
SHAFTS_OF_LONGXI = {
    (3, 6): {"g6": (-4, -12), "h6": (0, -8), "k6": (9, 1), "m6": (12, 4)},
    (6, 10): {"g6": (-5, -14), "h6": (0, -9), "k6": (10, 1), "m6": (15, 6)},
    (10, 18): {"g6": (-6, -17), "h6": (0, -11), "k6": (12, 1), "m6": (18, 7)},
    (18, 30): {"g6": (-7, -20), "h6": (0, -13), "k6": (15, 2), "m6": (21, 8)},
    (30, 50): {"g6": (-9, -25), "h6": (0, -16), "k6": (18, 2), "m6": (25, 9)},
    (50, 80): {"g6": (-10, -29), "h6": (0, -19), "k6": (21, 2), "m6": (30, 11)},
    (80, 120): {"g6": (-12, -34), "h6": (0, -22), "k6": (25, 3), "m6": (35, 13)},
    (120, 180): {"g6": (-14, -39), "h6": (0, -25), "k6": (28, 3), "m6": (40, 15)},
    (180, 250): {"g6": (-15, -44), "h6": (0, -29), "k6": (33, 4), "m6": (46, 17)},
    (250, 315): {"g6": (-17, -49), "h6": (0, -32), "k6": (36, 4), "m6": (52, 20)},
    (315, 400): {"g6": (-18, -54), "h6": (0, -36), "k6": (40, 4), "m6": (57, 21)},
    (400, 500): {"g6": (-20, -60), "h6": (0, -40), "k6": (45, 5), "m6": (63, 23)},
}
HOLES_OF_LONGXI = {
    (10, 18): {"H7": (0, 18), "K7": (-12, 6), "M7": (-18, 0), "N7": (-23, -5)},
    (18, 30): {"H7": (0, 21), "K7": (-15, 6), "M7": (-21, 0), "N7": (-28, -7)},
    (30, 50): {"H7": (0, 25), "K7": (-18, 7), "M7": (-25, 0), "N7": (-33, -8)},
    (50, 80): {"H7": (0, 30), "K7": (-21, 9), "M7": (-30, 0), "N7": (-39, -9)},
    (80, 120): {"H7": (0, 35), "K7": (-25, 10), "M7": (-35, 0), "N7": (-45, -10)},
    (120, 180): {"H7": (0, 40), "K7": (-28, 12), "M7": (-40, 0), "N7": (-52, -12)},
    (180, 250): {"H7": (0, 46), "K7": (-33, 13), "M7": (-46, 0), "N7": (-60, -14)},
    (250, 315): {"H7": (0, 52), "K7": (-36, 16), "M7": (-52, 0), "N7": (-66, -14)},
    (315, 400): {"H7": (0, 57), "K7": (-40, 17), "M7": (-57, 0), "N7": (-73, -16)},
    (400, 500): {"H7": (0, 63), "K7": (-45, 18), "M7": (-63, 0), "N7": (-80, -17)},
}
# SKF, Housing tolerances and resultant fits: bearing low, J7, JS5, JS6, JS7, K5.
HOUSINGS_OF_SKF = {
    (6, 10): (-8, (-7, 8), (-3, 3), (-4.5, 4.5), (-7.5, 7.5), (-5, 1)),
    (10, 18): (-8, (-8, 10), (-4, 4), (-5.5, 5.5), (-9, 9), (-6, 2)),
    (18, 30): (-9, (-9, 12), (-4.5, 4.5), (-6.5, 6.5), (-10.5, 10.5), (-8, 1)),
    (30, 50): (-11, (-11, 14), (-5.5, 5.5), (-8, 8), (-12.5, 12.5), (-9, 2)),
    (50, 80): (-13, (-12, 18), (-6.5, 6.5), (-9.5, 9.5), (-15, 15), (-10, 3)),
    (80, 120): (-15, (-13, 22), (-7.5, 7.5), (-11, 11), (-17.5, 17.5), (-13, 2)),
    (120, 150): (-18, (-14, 26), (-9, 9), (-12.5, 12.5), (-20, 20), (-15, 3)),
    (150, 180): (-25, (-14, 26), (-9, 9), (-12.5, 12.5), (-20, 20), (-15, 3)),
}


@pytest.mark.parametrize("step", SHAFTS_OF_LONGXI, ids=str)
def test_shafts_as_a_maker_prints_them(step: tuple[float, float]) -> None:
    for size in (step[0] + 0.5, step[1]):
        for tolerance, (upper, lower) in SHAFTS_OF_LONGXI[step].items():
            assert micrometres(shaft_deviations(size * 1e-3, tolerance)) == (lower, upper)


@pytest.mark.parametrize("step", HOLES_OF_LONGXI, ids=str)
def test_holes_as_a_maker_prints_them(step: tuple[float, float]) -> None:
    for size in (step[0] + 0.5, step[1]):
        for tolerance, limits in HOLES_OF_LONGXI[step].items():
            assert micrometres(hole_deviations(size * 1e-3, tolerance)) == limits


@pytest.mark.parametrize("step", HOUSINGS_OF_SKF, ids=str)
def test_housings_as_skf_prints_them(step: tuple[float, float]) -> None:
    low, *limits = HOUSINGS_OF_SKF[step]
    size = step[1] * 1e-3
    for tolerance, printed in zip(("J7", "JS5", "JS6", "JS7", "K5"), limits, strict=True):
        assert micrometres(hole_deviations(size, tolerance)) == printed
    assert micrometres(outside_deviations(size)) == (low, 0)


@pytest.mark.parametrize(
    ("diameter", "tolerance", "limits"),
    [
        # the public list iso_shafts.csv of P. Greene's isofits
        (25, "k5", (2, 11)),
        (25, "j5", (-4, 5)),
        (25, "j6", (-4, 9)),
        (75, "j5", (-7, 6)),  # and NKE's catalogue of 2011: 75 j5 = +6 -7
        (150, "j7", (-18, 22)),
        (40, "k7", (2, 27)),
        (100, "n6", (23, 45)),
        (60, "p6", (32, 51)),
        (60, "r6", (41, 60)),
        (70, "r6", (43, 62)),
        (390, "r6", (114, 150)),
        (25, "f7", (-41, -20)),
        (25, "e6", (-53, -40)),
        (25, "d6", (-78, -65)),
        (25, "js5", (-4.5, 4.5)),
        (25, "k8", (0, 33)),
        # DIN 7154: 40 s6
        (40, "s6", (43, 59)),
    ],
)
def test_shafts_spot_values(diameter: float, tolerance: str, limits: tuple[float, float]) -> None:
    assert micrometres(shaft_deviations(diameter * 1e-3, tolerance)) == limits


@pytest.mark.parametrize(
    ("diameter", "tolerance", "limits"),
    [
        # the public list iso_holes.csv of P. Greene's isofits
        (62, "J6", (-6, 13)),
        (62, "J7", (-12, 18)),
        (62, "J8", (-18, 28)),
        (62, "K6", (-15, 4)),
        (62, "K8", (-32, 14)),
        (62, "M6", (-24, -5)),
        (62, "M8", (-41, 5)),
        (62, "N6", (-33, -14)),
        (62, "N8", (-50, -4)),
        (62, "P6", (-45, -26)),
        (62, "P7", (-51, -21)),
        (62, "P8", (-78, -32)),
        (62, "G7", (10, 40)),
        (62, "F8", (30, 76)),
        (62, "E6", (60, 79)),
        (300, "M6", (-41, -9)),
        (300, "M7", (-52, 0)),
        (62, "N9", (-74, 0)),
    ],
)
def test_holes_spot_values(diameter: float, tolerance: str, limits: tuple[float, float]) -> None:
    assert micrometres(hole_deviations(diameter * 1e-3, tolerance)) == limits


def test_a_sliding_fit() -> None:
    """50 H7/g6: 9 to 50 µm of clearance."""
    hole, shaft = hole_deviations(0.05, "H7"), shaft_deviations(0.05, "g6")
    assert (hole.low - shaft.high) * 1e6 == pytest.approx(9)
    assert (hole.high - shaft.low) * 1e6 == pytest.approx(50)


# --- the standard's formulas ----------------------------------------------------

FACTORS = {5: 7, 6: 10, 7: 16, 8: 25, 9: 40, 10: 64, 11: 100}


@pytest.mark.parametrize("step", STEPS, ids=str)
def test_grades_follow_the_tolerance_unit(step: tuple[float, float]) -> None:
    """i = 0.45 ∛D + 0.001 D, D the geometric mean of the step; the standard rounds."""
    mean = sqrt(step[0] * step[1])
    unit = 0.45 * mean ** (1 / 3) + 0.001 * mean
    for grade, factor in FACTORS.items():
        tolerance = standard_tolerance(step[1] * 1e-3, grade) * 1e6
        assert tolerance == pytest.approx(factor * unit, rel=0.03, abs=1.01)
    seventh, twelfth = (standard_tolerance(step[1] * 1e-3, grade) for grade in (7, 12))
    assert twelfth == pytest.approx(10.0 * seventh)


@pytest.mark.parametrize("step", STEPS, ids=str)
def test_deviations_follow_their_formulas(step: tuple[float, float]) -> None:
    mean, size = sqrt(step[0] * step[1]), step[1] * 1e-3
    for letter, factor, power in (("d", 16, 0.44), ("e", 11, 0.41), ("f", 5.5, 0.41)):
        upper = shaft_deviations(size, f"{letter}7").high * 1e6
        assert upper == pytest.approx(-factor * mean**power, rel=0.03, abs=1.01)
    for letter, factor, power in (("k", 0.6, 1 / 3), ("n", 5, 0.34)):
        lower = shaft_deviations(size, f"{letter}6").low * 1e6
        assert lower == pytest.approx(factor * mean**power, rel=0.03, abs=0.8)
    seventh, sixth = (standard_tolerance(size, grade) for grade in (7, 6))
    assert shaft_deviations(size, "m6").low == pytest.approx(seventh - sixth, abs=1.01e-6)
    assert 0.0 <= shaft_deviations(size, "p6").low - seventh + 1e-12 <= 5.01e-6


@pytest.mark.parametrize("step", STEPS, ids=str)
def test_r_is_the_geometric_mean_of_p_and_s(step: tuple[float, float]) -> None:
    for size in (step[0] + 0.5, step[1]):
        p, r, s = (shaft_deviations(size * 1e-3, f"{letter}6").low for letter in "prs")
        assert r == pytest.approx(sqrt(p * s), rel=0.03, abs=0.8e-6)


@pytest.mark.parametrize("step", STEPS, ids=str)
def test_hole_basis_and_shaft_basis_fit_alike(step: tuple[float, float]) -> None:
    """H7/p6 and P7/h6, H8/n7 and N8/h7 have the same limits of interference."""
    size = step[1] * 1e-3
    for hole, shaft, other_hole, other_shaft in (
        ("H7", "p6", "P7", "h6"),
        ("H8", "n7", "N8", "h7"),
        ("H7", "k6", "K7", "h6"),
        ("H7", "m6", "M7", "h6"),
    ):
        first, second = hole_deviations(size, hole), shaft_deviations(size, shaft)
        third, fourth = hole_deviations(size, other_hole), shaft_deviations(size, other_shaft)
        assert second.high - first.low == pytest.approx(fourth.high - third.low, abs=1e-12)
        assert second.low - first.high == pytest.approx(fourth.low - third.high, abs=1e-12)


def test_coarser_bearings_vary_more() -> None:
    for size in (5, 25, 60, 150, 250):
        classes = ("normal", "P6", "P5")
        bores = [bore_deviations(size * 1e-3, c).low for c in classes]  # type: ignore[arg-type]
        assert bores == sorted(bores)
        outer = [outside_deviations(size * 2e-3, c).low for c in classes]  # type: ignore[arg-type]
        assert outer == sorted(outer)
    assert micrometres(bore_deviations(0.025)) == (-10, 0)
    assert micrometres(bore_deviations(0.025, "P5")) == (-6, 0)


@pytest.mark.parametrize(
    ("diameter", "tolerance", "told"),
    [
        (0.025, "K5", "must be one of d, e, f"),
        (0.025, "k13", "grade from 1 to 12"),
        (0.025, "k", "must be one of"),
        (0.025, "k2", "h, js, H and JS only"),
        (0.025, "j8", "grades 5, 6, 7 only"),
        (0.025, "k" * 5000, "must be one of"),
        (0.0025, "k5", "over 3 mm up to 500 mm"),
        (0.6, "k5", "over 3 mm up to 500 mm"),
        (float("nan"), "k5", "over 3 mm up to 500 mm"),
    ],
)
def test_what_is_not_in_the_tables_is_refused(diameter: float, tolerance: str, told: str) -> None:
    with pytest.raises(InputError, match=told) as error:
        shaft_deviations(diameter, tolerance)
    assert error.value.field == ("bore" if "500 mm" in told else "shaft_tolerance")


def test_holes_that_do_not_exist_are_refused() -> None:
    with pytest.raises(InputError, match="up to 8 only"):
        hole_deviations(0.062, "K9")
    with pytest.raises(InputError, match="grades 6, 7, 8 only"):
        hole_deviations(0.062, "J9")
    with pytest.raises(InputError, match="from 1 to 12"):
        standard_tolerance(0.062, 13)
    with pytest.raises(InputError, match="must be one of normal, P6, P5"):
        bore_deviations(0.025, "sizes_mm")  # type: ignore[arg-type]
    with pytest.raises(InputError, match="has no table for bore = 300 mm"):
        bore_deviations(0.3, "P6")
