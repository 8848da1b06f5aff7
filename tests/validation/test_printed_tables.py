"""Tables of constants against the pages that they were taken from, number by number.

Each table stands here as its source prints it, ranges as ranges, and with the page; what the
program uses is compared with that. Tables that a verification compares (ISO 281 and ISO 76:
`rolamento verify`) or that other tests hold against a print (ISO 286: test_iso286, ISO 5753 of
rollers: test_roller_clearance, ratings: test_iso281_rollers, test_iso_annexes) are not here. Where
the print itself was not at hand the source says "general knowledge", as the data do.
"""

from __future__ import annotations

from math import pi, sqrt
from typing import Any

import numpy as np
import pytest

from rolamento.case import case_of
from rolamento.clearance import class_clearance
from rolamento.friction.palmgren import friction_load, load_torque, palmgren, rib_torque
from rolamento.friction.skf import (
    SkfConstants,
    SkfMoment,
    constants_by_series,
    series_constants,
    skf_moment,
)
from rolamento.io.data import toml_of
from rolamento.life.contamination import (
    class_of_code,
    class_of_filter,
    class_of_grease,
    contamination_factor,
    level_of,
)
from rolamento.life.equivalent_load import equivalent_load, static_equivalent_load
from rolamento.life.iso281_modified import life_modification_factor
from rolamento.lubrication.regime import regime_of
from rolamento.ratings.ribs import permissible_axial_load_nsk, permissible_axial_load_skf
from rolamento.speeds import (
    minimum_load_factors,
    reference_coefficients,
    reference_heat_flow,
    speed_class,
)
from rolamento.speeds.minimum_load import minimum_share, roller_load_factor
from rolamento.vibration import severity

RPM = pi / 30.0
CST = 1e-6

# --- friction: Palmgren ---------------------------------------------------------------------------

# Palmgren (1959) as Harris, Rolling Bearing Analysis (1991), tables 14.1 to 14.3, and SKF, General
# catalogue (1989), table of f_0 and f_1, print it; of all but deep-groove and single-row
# angular-contact bearings general knowledge. Ranges: light to heavy series.
F_0 = {
    #                  grease         oil spot or mist  oil bath     bath, vertical shaft; jet
    "deep_groove":     ((0.7, 2.0),   (1.0, 1.0),       (2.0, 2.0),  (4.0, 4.0)),
    "self_aligning":   ((1.5, 2.0),   (0.7, 1.0),       (1.5, 2.0),  (3.0, 4.0)),
    "angular_contact": ((2.0, 2.0),   (1.7, 1.7),       (3.3, 3.3),  (6.6, 6.6)),
    "double_row":      ((4.0, 4.0),   (3.4, 3.4),       (6.5, 6.5),  (13.0, 13.0)),
    "four_point":      ((6.0, 6.0),   (2.0, 2.0),       (6.0, 6.0),  (9.0, 9.0)),
    "thrust":          ((5.5, 5.5),   (0.8, 0.8),       (1.5, 1.5),  (3.0, 3.0)),
    "cylindrical":     ((0.6, 1.0),   (1.5, 2.8),       (2.2, 4.0),  (2.2, 4.0)),
    "tapered":         ((6.0, 6.0),   (3.0, 3.0),       (6.0, 6.0),  (9.0, 9.0)),
    "needle":          ((12.0, 12.0), (6.0, 6.0),       (12.0, 12.0), (24.0, 24.0)),
}  # fmt: skip
WAYS = ("grease", "oil_mist", "oil_bath", "oil_jet")
Z_Y = {
    # f_1 = z (P_0/C_0)^y
    "deep_groove": ((0.0004, 0.0006), 0.55),
    "self_aligning": ((0.0003, 0.0003), 0.40),
    "angular_contact": ((0.001, 0.001), 0.33),
    "double_row": ((0.001, 0.001), 0.33),
    "four_point": ((0.001, 0.001), 0.33),
    "thrust": ((0.0008, 0.0008), 0.33),
    "cylindrical": ((0.0002, 0.0004), 0.0),
    "tapered": ((0.0004, 0.0004), 0.0),
    "needle": ((0.002, 0.002), 0.0),
}


@pytest.mark.parametrize("kind", F_0)
@pytest.mark.parametrize("way", WAYS)
def test_f_0_of_palmgren(kind: str, way: str) -> None:
    """M_0 of d_m = 70 mm at ν n = 27 000 by hand: 1e-7 f_0 · 27 000^(2/3) · 70³ N·mm."""
    found = palmgren(
        kind=kind,  # type: ignore[arg-type]
        lubrication=way,  # type: ignore[arg-type]
        speed=1350.0 * RPM, mean_diameter=0.07, kinematic_viscosity=20.0 * CST,
        radial_load=1e3, axial_load=1e2, static_load_ratio=0.1, contact_angle=0.5,
    )  # fmt: skip
    f_0 = 1e3 * float(found.parts["lubricant"][0]) / (1e-7 * 900.0 * 70.0**3)
    low, high = F_0[kind][WAYS.index(way)]
    # of light to heavy series the middle is taken; of greased deep-groove bearings a light one
    printed = 1.0 if (kind, way) == ("deep_groove", "grease") else 0.5 * (low + high)
    assert low <= printed <= high
    assert f_0 == pytest.approx(printed, rel=1e-9)


@pytest.mark.parametrize("kind", Z_Y)
def test_f_1_of_palmgren(kind: str) -> None:
    """M_1 under 1 kN at d_m = 100 mm: f_1 · 100 N·m, at two ratios P_0/C_0."""
    (low, high), y = Z_Y[kind]
    for ratio in (0.04, 0.25):
        found = float(load_torque(1e3, 0.1, ratio, kind))  # type: ignore[arg-type]
        assert found == pytest.approx(0.5 * (low + high) * ratio**y * 100.0, rel=1e-9)


def test_f_2_and_p_1_of_palmgren() -> None:
    """SKF, General catalogue (1989): f_2 0.003 with grease, 0.002 with oil; Harris, table 14.2."""
    assert rib_torque(1e3, 0.1, "grease") == pytest.approx(0.3)
    for way in ("oil_mist", "oil_bath", "oil_jet"):
        assert rib_torque(1e3, 0.1, way) == pytest.approx(0.2)  # type: ignore[arg-type]
    cot = 1.0 / np.tan(0.5)
    assert friction_load(100.0, 1e3, "deep_groove") == pytest.approx(2990.0)
    assert friction_load(100.0, 1e3, "four_point", 0.5) == pytest.approx(900.0 * cot - 10.0)
    assert friction_load(100.0, 1e3, "tapered", 0.5) == pytest.approx(800.0 * cot)
    assert friction_load(100.0, 1e3, "thrust") == pytest.approx(1e3)


# --- friction: SKF --------------------------------------------------------------------------------

# SKF, Rolling bearings (PUB BU/P1 10000 EN), geometry constants R and S, table 2b.
DEEP_GROOVE = {
    # series: R_1 (1e-7), R_2, S_1 (1e-3), S_2
    "2": (4.4, 1.7, 2.00, 100.0), "3": (4.4, 1.7, 2.00, 100.0),
    "42": (5.4, 0.96, 3.00, 40.0), "43": (5.4, 0.96, 3.00, 40.0),
    "60": (4.1, 1.7, 3.73, 14.6), "630": (4.1, 1.7, 3.73, 14.6),
    "62": (3.9, 1.7, 3.23, 36.5), "622": (3.9, 1.7, 3.23, 36.5),
    "63": (3.7, 1.7, 2.84, 92.8), "623": (3.7, 1.7, 2.84, 92.8),
    "64": (3.6, 1.7, 2.43, 198.0),
    "160": (4.3, 1.7, 4.63, 4.25), "161": (4.3, 1.7, 4.63, 4.25),
    "617": (4.7, 1.7, 6.50, 0.78), "618": (4.7, 1.7, 6.50, 0.78), "628": (4.7, 1.7, 6.50, 0.78),
    "637": (4.7, 1.7, 6.50, 0.78), "638": (4.7, 1.7, 6.50, 0.78),
    "619": (4.3, 1.7, 4.75, 3.6), "639": (4.3, 1.7, 4.75, 3.6),
}  # fmt: skip
SELF_ALIGNING = {
    # series: R_1 (1e-7), R_2, R_3 (1e-12), S_1 (1e-3), S_2, S_3 (1e-12)
    "12": (3.25, 6.51, 2.43, 4.36, 9.33, 2.43),
    "13": (3.11, 5.76, 3.52, 5.76, 8.03, 3.52),
    "22": (3.13, 5.54, 3.12, 5.84, 6.60, 3.12),
    "23": (3.11, 3.87, 5.41, 10.0, 4.35, 5.41),
}
CYLINDRICAL = {
    # series: R_1 (1e-6), S_1, S_2
    "2": (1.09, 0.16, 0.0015), "3": (1.09, 0.16, 0.0015), "4": (1.00, 0.16, 0.0015),
    "10": (1.12, 0.17, 0.0015), "12": (1.23, 0.16, 0.0015), "20": (1.23, 0.16, 0.0015),
    "22": (1.40, 0.16, 0.0015), "23": (1.48, 0.16, 0.0015),
}  # fmt: skip
TAPERED = {
    # series: R_1 (1e-6), R_2, S_1, S_2
    "302": (1.76, 10.9, 0.017, 2.0), "303": (1.69, 10.9, 0.017, 2.0),
    "313": (1.84, 10.9, 0.048, 2.0), "320": (2.38, 10.9, 0.014, 2.0),
    "322": (2.27, 10.9, 0.018, 2.0), "322B": (2.38, 10.9, 0.026, 2.0),
    "323": (2.38, 10.9, 0.019, 2.0), "323B": (2.79, 10.9, 0.030, 2.0),
    "329": (2.31, 10.9, 0.009, 2.0), "330": (2.71, 11.3, 0.010, 2.0),
    "331": (2.71, 10.9, 0.015, 2.0), "332": (2.71, 10.9, 0.018, 2.0),
}  # fmt: skip


def numbers_of(constants: SkfConstants, *names: str) -> tuple[float, ...]:
    return tuple(getattr(constants, name) for name in names)


def test_geometry_constants_of_skf() -> None:
    for series, (r1, r2, s1, s2) in DEEP_GROOVE.items():
        found = numbers_of(
            constants_by_series("deep_groove")[series], "r1", "r2", "s1", "s2", "k_z"
        )
        assert found == pytest.approx((1e-7 * r1, r2, 1e-3 * s1, s2, 3.1)), series
    for series, (r1, r2, r3, s1, s2, s3) in SELF_ALIGNING.items():
        found = numbers_of(
            constants_by_series("self_aligning")[series], "r1", "r2", "r3", "s1", "s2", "s3", "k_z"
        )
        printed = (1e-7 * r1, r2, 1e-12 * r3, 1e-3 * s1, s2, 1e-12 * s3, 4.8)
        assert found == pytest.approx(printed), series
    for series, (r1, s1, s2) in CYLINDRICAL.items():
        found = numbers_of(constants_by_series("cylindrical")[series], "r1", "s1", "s2", "k_z")
        assert found == pytest.approx((1e-6 * r1, s1, s2, 5.1)), series
    for series, (r1, r2, s1, s2) in TAPERED.items():
        found = numbers_of(constants_by_series("tapered")[series], "r1", "r2", "s1", "s2", "k_z")
        assert found == pytest.approx((1e-6 * r1, r2, s1, s2, 6.0)), series
    found = numbers_of(series_constants("thrust"), "r1", "s1", "k_z")
    assert found == pytest.approx((1.03e-6, 1.6e-2, 3.8))


@pytest.mark.parametrize(
    ("supply", "printed"),
    [("bath", 3e-8), ("jet", 3e-8), ("grease", 6e-8), ("oil_air", 6e-8)],
)
def test_replenishment_constant_of_skf(supply: str, printed: float) -> None:
    """φ_rs = exp(-K_rs ν n (d + D) √(K_z/(2 (D - d)))).

    SKF, Rolling bearings (10000 EN), kinematic replenishment/starvation reduction factor.
    """
    found = skf_moment(
        series_constants("angular_contact"),
        speed=6000.0 * RPM, bore_diameter=50e-3, outside_diameter=90e-3,
        kinematic_viscosity=30.0 * CST, radial_load=2e3, axial_load=1e3,
        supply=supply,  # type: ignore[arg-type]
    )  # fmt: skip
    step = 30.0 * 6000.0 * (50.0 + 90.0) * sqrt(4.4 / (2.0 * (90.0 - 50.0)))
    assert found.replenishment == pytest.approx(np.exp(-printed * step))


@pytest.mark.parametrize(
    ("oil", "printed"), [("mineral", 0.05), ("synthetic", 0.04), ("transmission_fluid", 0.1)]
)
def test_sliding_coefficients_of_skf(oil: str, printed: float) -> None:
    """μ_EHL of ball bearings, where the film is full; 0.12 and 0.15 at the boundary and at rest."""

    def moment(speed: float) -> SkfMoment:
        return skf_moment(
            series_constants("angular_contact"),
        speed=speed, bore_diameter=50e-3, outside_diameter=90e-3,
            kinematic_viscosity=300.0 * CST, radial_load=2e3, axial_load=1e3,
            oil=oil,  # type: ignore[arg-type]
        )  # fmt: skip

    assert moment(6000.0 * RPM).sliding_coefficient == pytest.approx(printed)
    slow = moment(1e-6)
    assert slow.sliding_coefficient == pytest.approx(0.12, rel=1e-4)
    assert slow.starting / slow.sliding == pytest.approx(0.15 / 0.12, rel=1e-4)


# --- ribs -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(("lubricant", "k1", "k2"), [("grease", 1.0, 0.1), ("oil", 1.5, 0.15)])
def test_permissible_axial_load_of_skf_above_and_below_50_000_mm2(
    lubricant: str, k1: float, k2: float
) -> None:
    """SKF, Rolling bearings, dynamic axial load carrying capacity of single-row bearings.

    F_ap = k_1 C_0 10⁴/(n (d + D)) - k_2 F_r up to π B (D + d) = 50 000 mm², above it
    7.5 k_1 C_0^(2/3) 10⁴/(n (d + D)) - k_2 F_r; kN, mm, r/min.
    """
    small = permissible_axial_load_skf(0.06, 0.13, 0.031, 180e3, 60e3, 1000.0 * RPM, lubricant)  # type: ignore[arg-type]
    assert pi * 31.0 * 190.0 < 50_000.0
    assert small == pytest.approx(1e3 * (k1 * 180.0 * 1e4 / (1000.0 * 190.0) - k2 * 60.0))
    large = permissible_axial_load_skf(0.15, 0.32, 0.065, 1e6, 100e3, 1000.0 * RPM, lubricant)  # type: ignore[arg-type]
    assert pi * 65.0 * 470.0 > 50_000.0
    strength = 7.5 * 100.0  # 1000 kN to the power of 2/3
    assert large == pytest.approx(1e3 * (k1 * strength * 1e4 / (1000.0 * 470.0) - k2 * 100.0))


def test_ribs_do_not_break_and_half_of_the_radial_load_is_the_limit() -> None:
    """0.0045 D^1.5 of series 2, 0.0023 D^1.7 of others (kN, mm), F_a ≤ 0.5 F_r: skf.com."""
    slow: dict[str, Any] = {
        "bore": 0.06,
        "outside_diameter": 0.11,
        "width": 0.022,
        "static_rating": 1e6,
    }
    for series_2, printed in ((True, 0.0045 * 110.0**1.5), (False, 0.0023 * 110.0**1.7)):
        found = permissible_axial_load_skf(**slow, radial_load=20e3, speed=RPM, series_2=series_2)
        assert found == pytest.approx(1e3 * printed)
    light = permissible_axial_load_skf(**slow, radial_load=5e3, speed=RPM)
    assert light == pytest.approx(2500.0)


@pytest.mark.parametrize(("series", "k"), [(2, 0.75), (3, 1.0), (4, 1.2)])
def test_permissible_axial_load_of_nsk(series: int, k: float) -> None:
    """NSK, Rolling Bearings (CAT. No. E1102e), 5.6, page A33: equations 5.34 and 5.35."""
    kd, n = 60.0 * k, 1500.0
    grease = 9.8 * (900.0 * kd**2 / (n + 1500.0) - 0.023 * kd**2.5)
    oil = 9.8 * (490.0 * kd**2 / (n + 1000.0) - 0.000135 * kd**3.4)
    assert permissible_axial_load_nsk(0.06, n * RPM, series) == pytest.approx(grease)
    assert permissible_axial_load_nsk(0.06, n * RPM, series, "oil") == pytest.approx(oil)


@pytest.mark.parametrize("bore", [40, 50, 60, 70, 80, 100])
def test_makers_agree_on_ribs(bore: int) -> None:
    """NJ 3 of NSK's list (E1102, with limiting speeds): NSK's and SKF's rules side by side.

    This tells which of NSK's two fractions is of which lubricant. At 0.4 of the limit with oil both
    makers permit the same within a factor of 3; with the fractions exchanged no greased bearing
    could carry anything there. At rest, where only the strength of the rib is left, both lubricants
    permit alike; exchanged, oil permits 1.6 to 2 times as much.
    """
    found = case_of(f"NJ 3{bore // 5:02d}").bearing.published
    assert found is not None
    d, outside, width = (1e3 * size for size in (found.bore, found.outside_diameter, found.width))
    rating, speed = 1e-3 * found.static_rating, 0.4 * found.limiting_speed
    large = pi * width * (d + outside) > 50_000.0
    strength = 7.5 * rating ** (2.0 / 3.0) if large else rating
    for lubricant, k_1 in (("grease", 1.0), ("oil", 1.5)):
        skf = 1e3 * k_1 * strength * 1e4 / (speed / RPM * (d + outside))
        nsk = permissible_axial_load_nsk(found.bore, speed, 3, lubricant)  # type: ignore[arg-type]
        assert 1.0 / 3.0 < float(nsk) / skf < 3.0
    grease, oil = (
        float(permissible_axial_load_nsk(found.bore, 0.0, 3, name))  # type: ignore[arg-type]
        for name in ("grease", "oil")
    )
    assert oil == pytest.approx(1.05 * grease, rel=0.06)


# --- life: contamination, modification, equivalent loads ------------------------------------------

# ISO 281:2007, annex A, equations A.2 to A.18: c_1, c_2
CIRCULATING = {"-/13/10": (0.0864, 0.5663), "-/15/12": (0.0432, 0.9987),
               "-/17/14": (0.0288, 1.6329), "-/19/16": (0.0216, 2.3362)}  # fmt: skip
BATH = {"-/13/10": (0.0864, 0.6796), "-/15/12": (0.0288, 1.141), "-/17/14": (0.0133, 1.67),
        "-/19/16": (0.00864, 2.5164), "-/21/18": (0.00411, 3.8974)}  # fmt: skip
GREASE = {"high": (0.0864, 0.6796), "normal": (0.0432, 1.141), "slight": (0.0177, 1.887),
          "severe": (0.0115, 2.662), "very_severe": (0.00617, 4.06)}  # fmt: skip


def e_c(c1: float, c2: float, kappa: float, pitch: float) -> float:
    return float(min(1.0, c1 * kappa**0.68 * pitch**0.55) * (1.0 - c2 / pitch ** (1.0 / 3.0)))


def test_contamination_factors() -> None:
    for code, constants in CIRCULATING.items():
        found = contamination_factor(class_of_code(code, "circulating"), 0.7, 0.08)
        assert found == pytest.approx(e_c(*constants, 0.7, 80.0)), code
    for code, constants in BATH.items():
        found = contamination_factor(class_of_code(code, "bath"), 0.7, 0.08)
        assert found == pytest.approx(e_c(*constants, 0.7, 80.0)), code
    for level, constants in GREASE.items():
        found = contamination_factor(class_of_grease(level), 0.7, 0.08)
        assert found == pytest.approx(max(e_c(*constants, 0.7, 80.0), 0.0)), level
    large = contamination_factor(class_of_grease("slight"), 0.1, 0.6)  # footnote: 1.677 from 500 mm
    assert large == pytest.approx(e_c(0.0177, 1.677, 0.1, 600.0))


@pytest.mark.parametrize(
    ("size", "ratio", "code"),
    [(6.0, 200.0, "-/13/10"), (12.0, 200.0, "-/15/12"), (25.0, 75.0, "-/17/14"),
     (40.0, 75.0, "-/19/16")],
)  # fmt: skip
def test_filters_of_the_classes(size: float, ratio: float, code: str) -> None:
    """ISO 281:2007, figures A.1 to A.4: β_6 = 200, β_12 = 200, β_25 = 75, β_40 = 75."""
    assert class_of_filter(1e-6 * size, ratio).name == code
    if code != "-/19/16":
        assert class_of_filter(1.01e-6 * size, ratio).name != code


# ISO 281:2007, table 13: e_C below 100 mm and from there on
LEVELS = {
    "extreme": ((1.0, 1.0), (1.0, 1.0)), "high": ((0.6, 0.8), (0.8, 0.9)),
    "normal": ((0.5, 0.6), (0.6, 0.8)), "slight": ((0.3, 0.5), (0.4, 0.6)),
    "typical": ((0.1, 0.3), (0.2, 0.4)), "severe": ((0.0, 0.1), (0.0, 0.1)),
    "very_severe": ((0.0, 0.0), (0.0, 0.0)),
}  # fmt: skip


@pytest.mark.parametrize("name", LEVELS)
def test_levels_of_contamination_in_words(name: str) -> None:
    for pitch, printed in zip((0.0999, 0.1), LEVELS[name], strict=True):
        low, high = level_of(name).range_at(pitch)
        assert (float(low), float(high)) == pytest.approx(printed)


@pytest.mark.parametrize(
    ("kappa", "c", "p", "of_rollers"),
    [(0.2, 2.2649, 0.054381, 1.3993), (0.7, 1.9987, 0.19087, 1.2348),
     (2.0, 1.9987, 0.071739, 1.2348)],
)  # fmt: skip
def test_life_modification_factor(kappa: float, c: float, p: float, of_rollers: float) -> None:
    """ISO 281:2007, 9.3.3.4: equations 31 to 33 of radial ball, 34 to 36 of radial roller
    bearings, at e_C C_u/P = 0.05."""
    balls = 0.1 * (1.0 - (2.5671 - c / kappa**p) ** 0.83 * 0.05 ** (1.0 / 3.0)) ** -9.3
    found = life_modification_factor(np.array([kappa]), 0.5, 100.0, 1000.0)
    assert found == pytest.approx(balls, rel=1e-6)
    rollers = 0.1 * (1.0 - (1.5859 - of_rollers / kappa**p) * 0.05**0.4) ** -9.185
    found = life_modification_factor(np.array([kappa]), 0.5, 100.0, 1000.0, rollers=True)
    assert found == pytest.approx(rollers, rel=1e-6)


# ISO 76:2006, table 2: X_0, Y_0 of single rows (of double rows twice as much, X_0 1)
STATIC = {0: (0.6, 0.5), 5: (0.5, 0.52), 10: (0.5, 0.5), 15: (0.5, 0.46), 20: (0.5, 0.42),
          25: (0.5, 0.38), 30: (0.5, 0.33), 35: (0.5, 0.29), 40: (0.5, 0.26),
          45: (0.5, 0.22)}  # fmt: skip


@pytest.mark.parametrize("degrees", STATIC)
def test_static_equivalent_load(degrees: int) -> None:
    x, y = STATIC[degrees]
    angle = np.radians([float(degrees)])
    assert static_equivalent_load(1e3, 9e3, angle) == pytest.approx(1e3 * x + 9e3 * y)
    double = (x, y) if degrees == 0 else (1.0, 2.0 * y)
    found = static_equivalent_load(1e3, 9e3, angle, double_row=True)
    assert found == pytest.approx(1e3 * double[0] + 9e3 * double[1])


@pytest.mark.parametrize(("wide", "e", "y"), [(False, 0.2, 0.6), (True, 0.3, 0.4)])
def test_equivalent_load_of_ribs(wide: bool, e: float, y: float) -> None:
    """SKF, Rolling bearings (17000 EN), page 509: P = F_r up to e, 0.92 F_r + Y F_a beyond."""
    axial = np.array([0.99 * e, 1.01 * e]) * 1e3
    found = equivalent_load(1e3, axial, np.zeros(2), np.zeros(2), kind="roller", wide=wide)
    assert found.load == pytest.approx([1e3, 920.0 + y * axial[1]])


# --- speeds ---------------------------------------------------------------------------------------

# ISO 15312:2003, annex A (checked rows)
F_R = {
    # series: f_0r, f_1r (1e-4)
    "618": (1.7, 1.0), "619": (1.7, 1.5), "160": (1.7, 1.5), "60": (1.7, 1.5), "62": (2.0, 2.0),
    "63": (2.3, 2.0), "64": (2.3, 2.0), "72": (2.0, 2.5), "73": (3.0, 3.5),
    "NU10": (2.0, 2.0), "NU2": (2.0, 3.0), "NU3": (2.0, 3.5), "NU4": (2.0, 4.0),
    "NU22": (3.0, 4.0), "NU23": (4.0, 4.0),
    "302": (3.0, 4.0), "303": (3.0, 4.0), "320": (3.0, 4.0), "329": (3.0, 4.0), "330": (3.0, 4.0),
    "313": (4.5, 4.0), "322": (4.5, 4.0), "323": (4.5, 4.0), "331": (4.5, 4.0), "332": (4.5, 4.0),
    "NA48": (5.0, 5.0), "NA49": (5.5, 5.0), "NA69": (10.0, 5.0),
}  # fmt: skip


@pytest.mark.parametrize("series", F_R)
def test_coefficients_of_the_reference_speed(series: str) -> None:
    found = reference_coefficients(series)
    assert found is not None
    f_0r, f_1r = F_R[series]
    assert (found.f_0r, found.f_1r) == pytest.approx((f_0r, 1e-4 * f_1r))


def test_reference_conditions() -> None:
    """ISO 15312:2003, clause 4: 12 mm²/s, 5 % of C_0r; q_r = 0.016 W/mm² up to 50 000 mm²."""
    known = toml_of("speeds")["reference"]["radial"]
    assert (known["viscosity"], known["load_share"]) == (12.0, 0.05)
    area = pi * 20.0 * (90.0 + 50.0)
    assert reference_heat_flow(0.05, 0.09, 0.02) == pytest.approx(0.016 * area)
    large = pi * 100.0 * (300.0 + 500.0)
    flow = 0.016 * (large / 5e4) ** -0.34 * large
    assert reference_heat_flow(0.3, 0.5, 0.1) == pytest.approx(flow)


PREFERRED = (10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 22, 24, 26, 28, 30, 32, 34, 36, 38, 40, 43,
             45, 48, 50, 53, 56, 60, 63, 67, 71, 75, 80, 85, 90, 95)  # fmt: skip
"""The first figures of all limiting speeds that NSK's catalogue E1102 prints."""


def test_limiting_speeds_are_numbers_that_nsk_prints() -> None:
    for row in toml_of("speeds")["classes"]["series"]:
        for bearing in row["bearings"]:
            for name in ("grease", "oil"):
                figures = f"{bearing[name]}".rstrip("0").ljust(2, "0")
                assert int(figures) in PREFERRED, bearing
            assert 1.1 < bearing["oil"] / bearing["grease"] < 1.5, bearing


# SKF, Rolling bearings (10000 EN): minimum load factors, most sizes of a series; general knowledge
@pytest.mark.parametrize(
    ("series", "k_r"),
    [("618", 0.015), ("619", 0.02), ("160", 0.02), ("60", 0.025), ("62", 0.025), ("63", 0.03),
     ("64", 0.035)],
)  # fmt: skip
def test_minimum_load_factors_of_deep_groove_bearings(series: str, k_r: float) -> None:
    assert minimum_load_factors(series, None).radial == pytest.approx(k_r)


@pytest.mark.parametrize(("series", "k_a", "k_r"), [("72", 1.4, 0.095), ("73", 1.6, 0.1)])
def test_minimum_load_factors_of_angular_contact_bearings(
    series: str, k_a: float, k_r: float
) -> None:
    found = minimum_load_factors(series, np.radians(40.0))
    assert (found.axial, found.radial) == pytest.approx((k_a, k_r))


# SKF, Rolling bearings (10000 EN): k_r as listed with each bearing of 15 to 25 mm bore; 0.02 C of
# tapered and needle roller bearings, 0.01 C of ball bearings
@pytest.mark.parametrize(
    ("series", "k_r"),
    [("NU10", 0.1), ("NU2", 0.15), ("NJ3", 0.15), ("NUP22", 0.2), ("N23", 0.25)],
)
def test_minimum_load_factors_of_cylindrical_roller_bearings(series: str, k_r: float) -> None:
    found = roller_load_factor(series)
    assert found is not None
    assert found.factor == pytest.approx(k_r)


def test_minimum_share_of_the_rating() -> None:
    assert [minimum_share(one) for one in ("ball", "tapered", "needle")] == [0.01, 0.02, 0.02]


# --- severity -------------------------------------------------------------------------------------

# ISO 10816-3:2009, tables A.1 and A.2 (ISO 20816-3:2022): mm/s, µm; ISO 10816-1:1995, table B.1
ZONES = {
    "group 1, rigid": ((2.3, 4.5, 7.1), (29, 57, 90)),
    "group 1, flexible": ((3.5, 7.1, 11.0), (45, 90, 140)),
    "group 2, rigid": ((1.4, 2.8, 4.5), (22, 45, 71)),
    "group 2, flexible": ((2.3, 4.5, 7.1), (37, 71, 113)),
    "class I": ((0.71, 1.8, 4.5), None),
    "class II": ((1.12, 2.8, 7.1), None),
    "class III": ((1.8, 4.5, 11.2), None),
    "class IV": ((2.8, 7.1, 18.0), None),
}


@pytest.mark.parametrize("name", ZONES)
def test_boundaries_of_the_zones(name: str) -> None:
    velocity, displacement = ZONES[name]
    machine = next(one for one in severity.machine_classes() if one.name == name)
    for zone, limit in zip("ABC", velocity, strict=True):
        assert machine.zone_of(0.999e-3 * limit) == zone
        assert machine.zone_of(1.001e-3 * limit) != zone
    for zone, limit in zip("ABC", displacement or (), strict=displacement is not None):
        assert machine.zone_of_displacement(0.999e-6 * limit) == zone
        assert machine.zone_of_displacement(1.001e-6 * limit) != zone


def test_bands_of_the_severity() -> None:
    """ISO 20816-3:2022: 10 to 1000 Hz, from 2 Hz below 600 r/min."""
    usual, slow = severity.band_at(600.0 * RPM), severity.band_at(599.0 * RPM)
    assert tuple(usual) == (10.0, 1000.0)
    assert tuple(slow) == (2.0, 1000.0)


def test_alarm_and_trip() -> None:
    """ISO 10816-3:2009, 5.4: baseline plus 25 % of B/C, at most 1.25 times B/C; trip 1.25 C/D."""
    machine = next(one for one in severity.machine_classes() if one.name == "group 2, rigid")
    found = severity.alarm_setting(machine, 1e-3)
    assert found.alarm == pytest.approx(1.7e-3)
    assert severity.alarm_setting(machine, 3.4e-3).alarm == pytest.approx(3.5e-3)
    assert found.trip == pytest.approx(1.25 * 4.5e-3)


def test_overlap_of_segments() -> None:
    """Welch, IEEE Trans. Audio Electroacoust. 15 (1967) 70: the variance of the mean of K spectra
    that overlap by half is that of K independent ones times 1 + 2 ρ, ρ the square of the window's
    correlation with itself at half its length; Harris, Proc. IEEE 66 (1978) 51, table 1: 16.7 % of
    Hann's window. Only neighbours overlap.
    """
    window = np.hanning(4097)[:-1]
    correlation = float(window[:2048] @ window[2048:] / (window @ window))
    assert correlation == pytest.approx(0.167, abs=5e-4)
    squares = np.array([0.9, 1.1, 1.05, 0.95, 1.2, 0.8])
    low, high = severity._limits(1.0, squares, 0.95)
    quantile = 2.570582  # Student's t of five degrees of freedom, 97.5 %
    half = quantile * float(np.std(squares, ddof=1)) / sqrt(6.0) * sqrt(1.0 + 2.0 * correlation**2)
    assert (low**2, high**2) == pytest.approx((1.0 - half, 1.0 + half), rel=2e-4)


# --- clearance, play, materials, regimes ----------------------------------------------------------

# ISO 5753-1:2009, table 1, as NTN's Ball and Roller Bearings, table 8.3, prints it: bore above and
# up to (mm), then C2, CN, C3, C4, C5 in µm
RADIAL = (
    (10, 18, (0, 9), (3, 18), (11, 25), (18, 33), (25, 45)),
    (18, 24, (0, 10), (5, 20), (13, 28), (20, 36), (28, 48)),
    (24, 30, (1, 11), (5, 20), (13, 28), (23, 41), (30, 53)),
    (30, 40, (1, 11), (6, 20), (15, 33), (28, 46), (40, 64)),
    (40, 50, (1, 11), (6, 23), (18, 36), (30, 51), (45, 73)),
    (50, 65, (1, 15), (8, 28), (23, 43), (38, 61), (55, 90)),
    (65, 80, (1, 15), (10, 30), (25, 51), (46, 71), (65, 105)),
    (80, 100, (1, 18), (12, 36), (30, 58), (53, 84), (75, 120)),
    (100, 120, (2, 20), (15, 41), (36, 66), (61, 97), (90, 140)),
    (120, 140, (2, 23), (18, 48), (41, 81), (71, 114), (105, 160)),
    (140, 160, (2, 23), (18, 53), (46, 91), (81, 130), (120, 180)),
    (160, 180, (2, 25), (20, 61), (53, 102), (91, 147), (135, 200)),
    (180, 200, (2, 30), (25, 71), (63, 117), (107, 163), (150, 230)),
    (200, 225, (2, 35), (25, 85), (75, 140), (125, 195), (175, 265)),
    (225, 250, (2, 40), (30, 95), (85, 160), (145, 225), (205, 300)),
)


@pytest.mark.parametrize("row", RADIAL, ids=lambda row: f"{row[0]} to {row[1]} mm")
def test_clearance_classes_of_deep_groove_bearings(
    row: tuple[int, int, tuple[int, int], tuple[int, int], tuple[int, int], tuple[int, int],
               tuple[int, int]],
) -> None:  # fmt: skip
    over, to, *classes = row
    for name, printed in zip(("C2", "CN", "C3", "C4", "C5"), classes, strict=True):
        for bore in (over + 0.01, float(to)):
            band = class_clearance(1e-3 * bore, name)  # type: ignore[arg-type]
            assert (1e6 * band.low, 1e6 * band.high) == pytest.approx(printed), (name, bore)


# SKF, General catalogue (6000 RU), table 2, page 514: axial play (µm) of NUP bearings, by series
# the last bore code of each step
PLAY = {
    "2": (("06", 37, 140), ("16", 47, 155), ("30", 62, 180), ("40", 87, 230), ("44", 95, 230),
          ("52", 95, 250)),
    "3": (("04", 37, 140), ("10", 47, 155), ("19", 62, 180), ("28", 87, 230)),
    "22": (("03", 37, 140), ("11", 47, 155), ("19", 62, 180), ("30", 87, 230)),
    "23": (("06", 47, 155), ("11", 62, 180), ("19", 87, 230), ("30", 120, 315)),
}  # fmt: skip


@pytest.mark.parametrize("series", PLAY)
def test_axial_play_of_nup_bearings(series: str) -> None:
    for code, found in toml_of("axial_play")["NUP"][series].items():
        printed = next((low, high) for last, low, high in PLAY[series] if code <= last)
        assert tuple(found) == printed, code


def test_high_speed_over_the_oil_bath() -> None:
    """NSK, Rolling Bearings (E1102), page A37: jet, mist or oil-air up to 2.5 and 1.5 times."""
    deep, angular = speed_class("62", None), speed_class("72", np.radians(30.0))
    assert deep is not None
    assert angular is not None
    assert deep.high_speed == pytest.approx(2.5 * deep.oil_bath)
    assert angular.high_speed == pytest.approx(1.5 * angular.oil_bath)
    assert toml_of("speeds")["classes"]["matched"] == 0.82


def test_expansion_of_ring_and_ball_materials() -> None:
    """Bearing steel: NSK, E1102; 440C: SDP/SI, table 18-10, 5.6e-6/°F; Si3N4: Carter."""
    found = toml_of("expansion", "rolamento.clearance")
    assert {name: one["expansion"] for name, one in found.items()} == {
        "100Cr6": 12.5e-6, "440C": pytest.approx(1.8 * 5.6e-6, rel=3e-3), "Si3N4": 2.8e-6,
    }  # fmt: skip


def test_oils_of_the_list() -> None:
    """Campanha 2008, table 3.1; Bessette, NASA CP-3350 (1997), table 6; ISO 3448."""
    data = toml_of("lubricants")
    assert data["grades"]["names"] == [
        10, 15, 22, 32, 46, 68, 100, 150, 220, 320, 460, 680, 1000, 1500,
    ]  # fmt: skip
    assert data["grades"]["viscosity_index"] == 95.0
    oils = {one["name"]: one for one in data["lubricant"]}
    names = ("viscosity_40", "viscosity_100", "density", "minimum_temperature")
    assert [oils["Shell Tonna S 68"][name] for name in names] == [
        "66.9 mm^2/s", "8.77 mm^2/s", "880.1 kg/m^3", "-15 degC",
    ]  # fmt: skip
    assert [oils["Pennzane SHF X-2000"][name] for name in names] == [
        "107 mm^2/s", "14.3 mm^2/s", "840 kg/m^3", "-55 degC",
    ]  # fmt: skip
    assert oils["BP 135, boundary"]["friction_coefficient"] == 0.17


def test_materials() -> None:
    """Elasticity, density and expansion of steels, ceramic and seats, by their sources."""
    materials = {one["name"]: one for one in toml_of("materials")["material"]}
    printed = {
        "100Cr6": ("207 GPa", 0.3, "7810 kg/m^3"),  # ISO/TS 16281:2008; Harris 1991
        "440C": ("200 GPa", 0.28, "7650 kg/m^3"),  # producer's table; MakeItFrom
        "M50": ("203 GPa", 0.29, "7870 kg/m^3"),  # MakeItFrom and BTI Metals
        "Si3N4": ("310 GPa", 0.26, "3240 kg/m^3"),  # Lily Bearing, 300 to 315 GPa
    }
    for name, numbers in printed.items():
        own = materials[name]
        found = (own["youngs_modulus"], own["poisson_ratio"], own["density"])
        assert found == numbers, name
    seats = {one["name"]: one for one in toml_of("seat_materials")["material"]}
    printed_seats = {  # Autodesk, Press Fit Material Table; density: SDP/SI
        "steel": ("210 GPa", 0.3, "7850 kg/m^3", "11e-6 1/K"),
        "cast iron": ("90 GPa", 0.25, "7200 kg/m^3", "10e-6 1/K"),
        "aluminium": ("70 GPa", 0.3, "2700 kg/m^3", "23e-6 1/K"),
    }
    fields = ("youngs_modulus", "poisson_ratio", "density", "thermal_expansion")
    for name, row in printed_seats.items():
        assert tuple(seats[name][field] for field in fields) == row, name


@pytest.mark.parametrize(
    ("film_parameter", "regime"),
    [(3.01, "full_film"), (3.0, "partial"), (1.01, "partial"), (1.0, "boundary"),
     (0.31, "boundary"), (0.3, "adhesive"), (0.0, "adhesive")],
)  # fmt: skip
def test_regimes_of_lubrication(film_parameter: float, regime: str) -> None:
    """Campanha 2008, 2.4.7 and table 2.5.1: λ of 3, 1 and 0.3."""
    found = regime_of(film_parameter)
    assert found is not None
    assert found.name == regime


def test_what_the_depth_of_a_crack_tells() -> None:
    """Campanha 2008, 2.5: over the depth of the greatest shear up to 0.2, and from 0.5 to 1.5."""
    rows = toml_of("lubrication_regimes")["crack"]
    found = {row["origin"]: (row["from"], row["to"]) for row in rows}
    assert found == {"surface": (0.0, 0.2), "subsurface": (0.5, 1.5)}
