"""Sizes, classes and lists against the pages that they were taken from, number by number.

As test_printed_tables does for the constants of models. Each list stands here as its source prints
it, typed by size rather than by column as the data are. Where the whole list is too long, its rule
is tested on every row and a part of it number by number.
"""

from __future__ import annotations

from fractions import Fraction
from statistics import median
from typing import Any

import numpy as np
import pytest

from rolamento.catalogue import ball_sizes
from rolamento.catalogue.search import built_in_catalogue
from rolamento.clearance import bore_deviations, class_clearance, outside_deviations
from rolamento.io.data import toml_of

INCH = 25.4

# --- boundary dimensions --------------------------------------------------------------------------

# ISO 15, as makers' tables of deep-groove and angular-contact ball bearings print it: bore, then
# outside diameter and width of the dimension series 18, 19, 10, 02, 03; mm
ISO_15 = """
 10  19/5   22/6   26/8   30/9   35/11
 12  21/5   24/6   28/8   32/10  37/12
 15  24/5   28/7   32/9   35/11  42/13
 17  26/5   30/7   35/10  40/12  47/14
 20  32/7   37/9   42/12  47/14  52/15
 25  37/7   42/9   47/12  52/15  62/17
 30  42/7   47/9   55/13  62/16  72/19
 35  47/7   55/10  62/14  72/17  80/21
 40  52/7   62/12  68/15  80/18  90/23
 45  58/7   68/12  75/16  85/19  100/25
 50  65/7   72/12  80/16  90/20  110/27
 55  72/9   80/13  90/18  100/21 120/29
 60  78/10  85/13  95/18  110/22 130/31
 65  85/10  90/13  100/18 120/23 140/33
 70  90/10  100/16 110/20 125/24 150/35
 75  95/10  105/16 115/20 130/25 160/37
 80  100/10 110/16 125/22 140/26 170/39
 85  110/13 120/18 130/22 150/28 180/41
 90  115/13 125/18 140/24 160/30 190/43
 95  120/13 130/18 145/24 170/32 200/45
100  125/13 140/20 150/24 180/34 215/47
105  130/13 145/20 160/26 190/36 225/49
110  140/16 150/20 170/28 200/38 240/50
120  150/16 165/22 180/28 215/40 260/55
130  165/18 180/24 200/33 230/40 280/58
140  175/18 190/24 210/33 250/42 300/62
150  190/20 210/28 225/35 270/45 320/65
160  200/20 220/28 240/38 290/48 340/68
170  215/22 230/28 260/42 310/52 360/72
180  225/22 250/33 280/46 320/52 380/75
190  240/24 260/33 290/46 340/55 400/78
200  250/24 280/38 310/51 360/58 420/80
"""
SERIES = ("18", "19", "10", "02", "03")


def test_boundary_dimensions_of_iso_15() -> None:
    data = toml_of("iso15")
    found = {series: data["series"][series] | data["beyond"][series] for series in data["series"]}
    printed: dict[str, dict[str, list[int]]] = {series: {} for series in SERIES}
    for line in ISO_15.strip().splitlines():
        bore, *sizes = line.split()
        for series, size in zip(SERIES, sizes, strict=True):
            printed[series][bore] = [int(part) for part in size.split("/")]
    assert found == printed


def test_dimension_series_of_the_numbers() -> None:
    """DIN 623-1: the last two figures of the series, width and diameter."""
    numbers = toml_of("iso15")["numbers"]
    by_series: dict[str, set[str]] = {}
    for number, series in numbers.items():
        by_series.setdefault(series, set()).add(number)
    assert by_series == {
        "18": {"618", "68", "718", "78"}, "19": {"619", "69", "719", "79"},
        "10": {"60", "70"}, "02": {"62", "72"}, "03": {"63", "73"},
    }  # fmt: skip


# --- ISO 492 --------------------------------------------------------------------------------------

# ISO 492:2014, t_Δdmp and t_ΔDmp (µm, below zero) of radial bearings but tapered ones: up to (mm),
# then the classes normal, 6, 5. Of class 6 no bore over 250 mm is on file.
BORES: tuple[tuple[float, ...], ...] = (
    (10, 8, 7, 5), (18, 8, 7, 5), (30, 10, 8, 6), (50, 12, 10, 8), (80, 15, 12, 9),
    (120, 20, 15, 10), (180, 25, 18, 13), (250, 30, 22, 15), (315, 35, 0, 18), (400, 40, 0, 23),
    (500, 45, 0, 28),
)  # fmt: skip
OUTSIDES: tuple[tuple[float, ...], ...] = (
    (18, 8, 7, 5), (30, 9, 8, 6), (50, 11, 9, 7), (80, 13, 11, 9), (120, 15, 13, 10),
    (150, 18, 15, 11), (180, 25, 18, 13), (250, 30, 20, 15), (315, 35, 25, 18), (400, 40, 28, 20),
    (500, 45, 33, 23), (630, 50, 38, 28),
)  # fmt: skip


@pytest.mark.parametrize(
    ("read", "rows", "least"), [(bore_deviations, BORES, 2.5), (outside_deviations, OUTSIDES, 6.0)]
)
def test_deviations_of_iso_492(read: Any, rows: tuple[Any, ...], least: float) -> None:
    below = least
    for to, *printed in rows:
        for name, limit in zip(("normal", "P6", "P5"), printed, strict=True):
            for size in (below + 0.01, to):
                if limit:
                    band = read(1e-3 * size, name)
                    assert (1e6 * band.low, band.high) == pytest.approx((-limit, 0.0)), (name, size)
        below = to


# --- balls ----------------------------------------------------------------------------------------


def test_ball_sizes_on_the_market() -> None:
    """Preferred sizes of ISO 3290-1: inches by 1/64 to 25/64, by 1/32 to 1 1/2, by 1/16 above."""
    inches = [
        *(Fraction(n, 64) for n in range(2, 26)), *(Fraction(n, 32) for n in range(13, 49)),
        *(Fraction(n, 16) for n in range(25, 33)), *(Fraction(n, 8) for n in range(17, 25)),
        *(Fraction(n, 4) for n in range(13, 17)),
    ]  # fmt: skip
    metric = [
        0.5, 0.6, 0.7, 0.8, 1, 1.2, 1.5, 2, 2.5, 3, 3.5, 4, 4.5, 5, 5.5, 6, 6.5, 7, 7.5, 8, 8.5, 9,
        10, 11, 11.5, *range(12, 27), 28, 30, 32, 34, 35, 36, 38, 40, 42, 45, 48, 50, 55, 60, 65,
        70, 80, 90, 100,
    ]  # fmt: skip
    printed = np.unique(np.round([*(INCH * float(one) for one in inches), *metric], 6))
    found = np.unique(np.round(1e3 * np.asarray(ball_sizes()), 6))
    assert found.tolist() == printed.tolist()


# --- clearance classes ----------------------------------------------------------------------------

# ISO 5753-1:2009, table 1, bores that test_printed_tables leaves out: up to 10 mm and over 250 mm
DEEP_GROOVE = """
  6  0/7   2/13   8/23    -        -
 10  0/7   2/13   8/23    14/29    20/37
280  2/45  35/105 90/170  155/245  225/340
315  2/55  40/115 100/190 175/270  245/370
355  3/60  45/125 110/210 195/300  275/410
400  3/70  55/145 130/240 225/340  315/460
450  3/80  60/170 150/270 250/380  350/510
500  3/90  70/190 170/300 280/420  390/570
"""
# NSK, Rolling Bearings (E1102e), table 9.12: radial clearance of self-aligning ball bearings
SELF_ALIGNING = """
  6  1/8   5/15  10/20  15/25   21/33
 10  2/9   6/17  12/25  19/33   27/42
 14  2/10  6/19  13/26  21/35   30/48
 18  3/12  8/21  15/28  23/37   32/50
 24  4/14  10/23 17/30  25/39   34/52
 30  5/16  11/24 19/35  29/46   40/58
 40  6/18  13/29 23/40  34/53   46/66
 50  6/19  14/31 25/44  37/57   50/71
 65  7/21  16/36 30/50  45/69   62/88
 80  8/24  18/40 35/60  54/83   76/108
100  9/27  22/48 42/70  64/96   89/124
120  10/31 25/56 50/83  75/114  105/145
140  10/38 30/68 60/100 90/135  125/175
160  15/44 35/80 70/120 110/161 150/210
"""
SELF_ALIGNING_TAPERED = """
 24  7/17  13/26  20/33  28/42   37/55
 30  9/20  15/28  23/39  33/50   44/62
 40  12/24 19/35  29/46  40/59   52/72
 50  14/27 22/39  33/52  45/65   58/79
 65  18/32 27/47  41/61  56/80   73/99
 80  23/39 35/57  50/75  69/98   91/123
100  29/47 42/68  62/90  84/116  109/144
120  35/56 50/81  75/108 100/139 130/170
140  40/68 60/98  90/130 120/165 155/205
160  45/74 65/110 100/150 140/191 180/240
"""
# The same, table 9.18: axial clearance of four-point contact ball bearings, C2 to C4
FOUR_POINT = """
 18  15/55   45/85   75/125  115/165
 40  26/66   56/106  96/146  136/186
 60  36/86   76/126  116/166 156/206
 80  46/96   86/136  126/176 166/226
100  56/106  96/156  136/196 186/246
140  66/126  116/176 156/216 206/266
180  76/156  136/196 176/246 226/296
220  96/176  156/226 206/276 256/326
260  115/196 175/245 225/305 285/365
300  135/215 195/275 255/335 315/395
350  155/235 215/305 275/365 345/425
400  175/265 245/335 315/405 385/475
500  205/305 285/385 355/455 435/525
"""


@pytest.mark.parametrize(
    ("table", "printed"),
    [("", DEEP_GROOVE), ("self_aligning", SELF_ALIGNING),
     ("self_aligning_tapered", SELF_ALIGNING_TAPERED), ("four_point", FOUR_POINT)],
)  # fmt: skip
def test_clearance_classes(table: Any, printed: str) -> None:
    for line in printed.strip().splitlines():
        to, *ranges = line.split()
        names = ("C2", "CN", "C3", "C4", "C5")[: len(ranges)]
        for name, text in zip(names, ranges, strict=True):
            if text != "-":
                band = class_clearance(1e-3 * float(to), name, table)
                assert [1e6 * band.low, 1e6 * band.high] == pytest.approx(
                    [float(one) for one in text.split("/")]
                ), (to, name)


@pytest.mark.parametrize(
    ("bore", "printed"), [(18, (4, 11)), (30, (5, 12)), (50, (9, 17)), (80, (12, 22)),
                          (100, (18, 30)), (120, (18, 30)), (160, (24, 38))],
)  # fmt: skip
def test_clearance_of_nsk_for_electric_motors(bore: float, printed: tuple[float, float]) -> None:
    """NSK, Rolling Bearings (E1102e), table 9.13.1: CM of deep-groove ball bearings."""
    band = class_clearance(1e-3 * bore, "CM")
    assert (1e6 * band.low, 1e6 * band.high) == pytest.approx(printed)


# --- preloads -------------------------------------------------------------------------------------

LEVELS = ("extra_light", "light", "medium", "heavy")
# NSK, Rolling Bearings (E1102e), table 10.2.2: average preloads EL, L, M, H of series 70 C, N
NSK_70_C = """
00  12  25  49   100
01  12  25  59   120
02  14  29  69   150
03  14  29  69   150
04  24  49  120  250
05  29  59  150  290
06  39  78  200  390
07  60  120 250  490
08  60  120 290  590
09  75  150 340  690
10  75  150 390  780
11  100 200 490  980
12  100 200 540  1080
13  125 250 540  1080
14  145 290 740  1470
15  145 290 780  1570
16  195 390 930  1860
17  195 390 980  1960
18  245 490 1180 2350
19  270 540 1180 2350
20  270 540 1270 2550
"""
# SNFA, General Catalogue (CATGEN6GB), page 31, and GMN, catalogue 4000 0813 EN, page 63: sets over
# the pair of the same bearings: preload, axial rigidity, unloading load over the preload of a pair
SETS = {
    ("SNFA", "1+1"): (1.0, None, 2.83), ("SNFA", "2+1"): (1.35, None, None),
    ("SNFA", "3+1"): (1.6, None, None), ("SNFA", "2+2"): (2.0, None, None),
    ("GMN", "1+1"): (1.0, 1.0, 2.85), ("GMN", "2+1"): (1.35, 1.45, 5.65),
    ("GMN", "2+2"): (2.0, 2.0, 5.65), ("GMN", "3+1"): (1.6, 1.8, 8.5),
    ("NSK", "2+1"): (1.36, 1.48, None), ("NSK", "2+2"): (2.0, 2.0, None),
}  # fmt: skip


def newtons(line: dict[str, str], level: str) -> float:
    return float(line[level].removesuffix(" N"))


def listed(maker: str) -> list[dict[str, str]]:
    found = next(one for one in toml_of("preloads")["maker"] if one["name"] == maker)
    lines: list[dict[str, str]] = found["bearings"]
    return lines


def test_preloads_that_nsk_prints_for_series_70() -> None:
    by_name = {line["designation"]: line for line in listed("NSK")}
    for printed in NSK_70_C.strip().splitlines():
        code, *forces = printed.split()
        line = by_name[f"70{code}C"]
        assert [newtons(line, level) for level in LEVELS] == [float(one) for one in forces], code


@pytest.mark.parametrize(("maker", "least", "most"), [("SNFA", 1.92, 2.07), ("GMN", 1.88, 2.12)])
def test_preload_classes_are_one_three_and_six_on_every_line(
    maker: str, least: float, most: float
) -> None:
    """The rule of both lists, within what the rounding of print leaves from 20 N on."""
    for line in listed(maker):
        light, medium, heavy = (newtons(line, level) for level in LEVELS[1:])
        if light >= 20.0:
            assert least < heavy / medium < most, line
            assert 2.79 < medium / light < 3.34, line


def test_preloads_at_25_degrees_are_1_6_times_those_at_15() -> None:
    """Of SNFA's lists, by 1.5 to 1.67; 1.6 is the rule of the whole list."""
    by_name: dict[str, dict[str, dict[str, str]]] = {}
    for line in listed("SNFA"):
        by_name.setdefault(line["designation"], {})[line["contact_angle"]] = line
    both = [angles for angles in by_name.values() if len(angles) == 2]
    assert len(both) > 150
    for level in LEVELS[1:]:
        ratios = [newtons(a["25 deg"], level) / newtons(a["15 deg"], level) for a in both]
        assert median(ratios) == pytest.approx(1.6, abs=0.01)
        assert 1.5 - 1e-9 <= min(ratios) <= max(ratios) < 1.88


def test_sets_over_their_pair() -> None:
    keys = ("preload", "axial_rigidity", "unloading_load")
    found = {
        (one["maker"], one["bearings"]): tuple(one.get(key) for key in keys)
        for one in toml_of("preloads")["set"]
    }
    assert found == SETS


def test_shares_of_the_rating_are_those_of_the_lists() -> None:
    """Of SNFA, whose list has C beside: the median within 3 %, all between the two extremes."""
    ratings = {one.designation: one.dynamic_rating for one in built_in_catalogue().bearings}
    for row in toml_of("preloads")["share_of_dynamic_rating"]:
        angle = row["contact_angle"]
        shares = [
            newtons(line, row["class"])
            / (ratings[f"{line['designation']} {angle.replace(' ', '')}"] or 0)
            for line in listed("SNFA")
            if line["contact_angle"] == angle
        ]
        assert median(shares) == pytest.approx(row["share"], rel=0.03)
        assert row["low"] - 5e-5 <= min(shares) <= max(shares) <= row["high"] + 5e-5, row


# --- designations ---------------------------------------------------------------------------------


def test_numbers_of_the_designations() -> None:
    """DIN 623-1 for bores; SKF, FAG, NSK and NTN for the angles behind a number."""
    data = toml_of("designations")
    assert data["bore_codes"] == {"00": 10, "01": 12, "02": 15, "03": 17}
    assert data["angles"] == {
        "C": 15.0, "E": 25.0, "AC": 25.0, "A5": 25.0, "A": 30.0, "B": 40.0, "BE": 40.0,
    }  # fmt: skip
    assert data["angles_of_double_rows"] == {"B": 25.0, "BB": 25.0, "A": 30.0, "BD": 30.0}
    assert data["spindle_angles"] == {"C": 15.0, "F": 18.0, "AC": 25.0}
    assert data["angles_after_u"] == {"C": 15.0, "AD": 25.0}
    assert [one["type"] for one in data["spindle"]] == [
        {"BGR": 15.0, "BNR": 18.0, "BER": 25.0}, {"C": 15.0, "AD": 25.0},
    ]  # fmt: skip
    assert data["stainless"]["share"] == [0.80, 0.85]


def test_kinds_of_the_series() -> None:
    """DIN 623-1 and ISO 15: the series that are not deep-groove or single-row angular contact."""
    by_kind: dict[str, str] = {}
    for series, kind in toml_of("designations")["kinds"].items():
        by_kind[kind] = f"{by_kind.get(kind, '')} {series}".strip()
    assert by_kind == {
        "double_row": "32 33 52 53",
        "four_point": "QJ2 QJ3 QJ10",
        "self_aligning": "12 13 22 23",
        "thrust": "511 512 513 514",
        "tapered": "302 303 313 320 322 323 329 330 331 332",
    }


def test_what_the_letters_of_classes_mean() -> None:
    """ISO 5753-1 for clearances; the makers for preloads, arrangements and ceramic balls."""
    data = toml_of("designations")
    assert data["clearance"] == {
        "C2": "C2", "CN": "CN", "C0": "CN", "C3": "C3", "C4": "C4", "C5": "C5", "CM": "CM",
    }  # fmt: skip
    assert data["levels"] == {
        "EL": "extra_light", "L": "light", "M": "medium", "H": "heavy", "S": "heavy", "F": "heavy",
    }  # fmt: skip
    nsk = ("DBD", "DFD", "DTD", "DBB", "DFF", "DBT", "DFT", "DTT")
    as_skf = [data["arrangements"][name] for name in nsk]
    assert as_skf == [
        "TBT", "TFT", "TT", "QBC", "QFC", "QBT", "QFT", "QT",
    ]  # fmt: skip
    assert set(data["balls"]) == {
        "HC", "HC5", "H", "HY", "5S", "3NC", "HCB", "HCS", "XCB", "XCS", "XC", "V", "SN24",
    }  # fmt: skip
    assert set(data["balls"].values()) == {"Si3N4"}
    assert data["same_size"] == {
        "32": "52", "33": "53", "52": "32", "53": "33",
        "719": "79", "718": "78", "79": "719", "78": "718",
    }  # fmt: skip
    assert data["snfa_names"]["D"] == {
        "718": "SEA {bore}", "719": "SEB {bore}", "70": "EX {bore}", "72": "E 2{bore}",
    }  # fmt: skip
