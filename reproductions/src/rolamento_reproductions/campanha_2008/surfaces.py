"""Roughness of the races, the oil's temperature, noise: chapters 2.8, 4.1.1, 4.4.1 and 4.4.2."""

from __future__ import annotations

from functools import cache
from typing import Final

import numpy as np

from rolamento.lubrication.regime import regime_of
from rolamento.lubrication.roughness import rms_of_mean_roughness
from rolamento.oil.state import reference_viscosity
from rolamento.units import RPM
from rolamento.vibration.anderon import velocity_of_anderons
from rolamento_reproductions.campanha_2008.clearance import BEARINGS, measured_of
from rolamento_reproductions.campanha_2008.contact import check_of
from rolamento_reproductions.campanha_2008.film import REGIMES
from rolamento_reproductions.campanha_2008.inputs import (
    GIVEN,
    MICRO,
    oil_at,
    pitch_diameter,
    said,
    speed,
    temperature,
)
from rolamento_reproductions.campanha_2008.life_tests import life_tests
from rolamento_reproductions.given import grid
from rolamento_reproductions.record import (
    Claim,
    Curves,
    Figure,
    Floats,
    Line,
    Panel,
    Section,
    Series,
    Table,
    TableColumn,
)
from rolamento_reproductions.text import Text, same

_NEAR_ONE = (0.7, 1.4)
"""λ that reads as close to 1: a root of two on either side."""


def roughness_section(title: Text) -> Section:
    """Compute table 4.4.1 with λ, and figure 4.4.1."""
    return Section(title, (_surfaces(), _temperatures()))


# --- table 4.4.1 ------------------------------------------------------------


def _roughness_rows() -> list[tuple[int, str, float, float, float]]:
    """Bearing, condition, hours, R_a and R_z (µm)."""
    tests = {number: test for test in life_tests() for number in test.bearings}
    return [
        (number, tests[number].condition, tests[number].hours, float(mean), float(height))
        for number, mean, height in GIVEN.inputs_of("roughness")["rows"]
    ]


def _parameter(condition: str, mean: float) -> float:
    """λ of a race with this R_a (µm), the ball as measured on one bearing of its condition."""
    ball = GIVEN.inputs_of("roughness")["balls"][condition]
    rough = np.hypot(rms_of_mean_roughness(mean), rms_of_mean_roughness(ball))
    return float(check_of("h_c", condition).computed / rough)


def _regime(parameter: float) -> Text:
    regime = regime_of(parameter)
    assert regime is not None
    return REGIMES[regime.name]


def _surfaces() -> Table:
    rows = _roughness_rows()
    parameters = [_parameter(condition, mean) for _, condition, _, mean, _ in rows]

    def column(name: str, title: Text, cells: list[str]) -> TableColumn:
        return TableColumn(name, title, tuple(cells))

    return Table(
        number="4.4.1",
        caption=said("surfaces.caption"),
        source=GIVEN.source_of("roughness"),
        columns=(
            column("bearing", said("bearing"), [str(row[0]) for row in rows]),
            column("condition", said("condition"), [row[1] for row in rows]),
            column("hours", said("time_h"), [f"{row[2]:.1f}" for row in rows]),
            column("Ra_um", same("R_a (µm)"), [f"{row[3]:.4f}" for row in rows]),
            column("Rz_um", same("R_z (µm)"), [f"{row[4]:.4f}" for row in rows]),
            column("Rz_over_Ra", same("R_z/R_a"), [f"{row[4] / row[3]:.1f}" for row in rows]),
            column("lambda", same("λ"), [f"{value:.2f}" for value in parameters]),
            TableColumn("regime", same("regime"), tuple(_regime(value) for value in parameters)),
        ),
        claims=(_close_to_one(), _worn_alike()),
        notes=(_shape(rows),),
    )


def _close_to_one() -> Claim:
    values = np.array(
        [
            _parameter("I", mean)
            for _, condition, _, mean, _ in _roughness_rows()
            if condition == "I"
        ]
    )
    near = int(((values > _NEAR_ONE[0]) & (values < _NEAR_ONE[1])).sum())
    new = check_of("λ, bearing new", "I").computed
    return Claim(
        said("close_to_one.statement"),
        said(
            "close_to_one.finding",
            values_min=float(values.min()),
            values_max=float(values.max()),
            near=near,
            size=values.size,
            new=new,
        ),
        holds=near == values.size,
        partly=near > 0,
    )


def _worn_alike() -> Claim:
    means = {
        name: np.array(
            [mean for _, condition, _, mean, _ in _roughness_rows()[:20] if condition == name]
        )
        for name in ("I", "II")
    }
    first, second = means["I"], means["II"]
    error = float(np.sqrt(first.var(ddof=1) / first.size + second.var(ddof=1) / second.size))
    difference = float(second.mean() - first.mean())
    return Claim(
        said("worn_alike.statement"),
        said(
            "worn_alike.finding",
            first_mean=float(first.mean()),
            second_mean=float(second.mean()),
            difference=difference / error,
        ),
        holds=difference < 2.0 * error,
    )


def _shape(rows: list[tuple[int, str, float, float, float]]) -> Text:
    ratios = [row[4] / row[3] for row in rows]
    return said("shape.r_z_r", ratios_min=min(ratios), ratios_max=max(ratios))


# --- figure 4.4.1 -----------------------------------------------------------


def _temperatures() -> Figure:
    given = GIVEN.inputs_of("temperature")
    celsius = np.unique(
        np.concatenate(
            [
                grid(given["lowest_degC"], given["highest_degC"], given["step_degC"]),
                [temperature("I"), temperature("II")],
            ]
        )
    )
    viscosity = np.asarray(oil_at(celsius).kinematic_viscosity) / MICRO
    means = [temperature("I"), temperature("II")]
    at_means = np.where(np.isin(celsius, means), viscosity, np.nan)
    as_printed = np.full(celsius.size, np.nan)
    for name, value in GIVEN.inputs_of("contact")["viscosities_mm2_s"].items():
        as_printed[np.searchsorted(celsius, temperature(name))] = value
    title = said("temperatures.kinematic_viscosity")
    levels = [
        np.full(celsius.size, value) for value in (given["reference_viscosity_mm2_s"], _needed())
    ]
    columns = (
        Series("temperature", "°C", said("temperatures.temperature"), celsius),
        Series("viscosity", "mm²/s", title, viscosity),
        Series("of_conditions", "mm²/s", title, at_means),
        Series("as_printed", "mm²/s", title, as_printed),
        Series("of_1990", "mm²/s", title, levels[0]),
        Series("of_2007", "mm²/s", title, levels[1]),
    )
    lines = (
        Line("viscosity", 0, same("Tonna S 68, ASTM D341")),
        Line("of_1990", 3, same("13 mm²/s, ISO 281:1990")),
        Line("of_2007", 2, same("ν_1, ISO 281:2007")),
        Line("of_conditions", 5, said("temperatures.conditions_i_and"), points=True),
        Line("as_printed", 1, said("temperatures.as_printed"), points=True),
    )
    return Figure(
        number="4.4.1",
        caption=said(
            "temperatures.caption", temperature_1=temperature("I"), temperature_2=temperature("II")
        ),
        source=GIVEN.source_of("temperature"),
        columns=columns,
        picture=Curves(
            (
                Panel(
                    "temperature",
                    title,
                    "mm²/s",
                    lines,
                    tick=5.0,
                    from_zero=False,
                    legend_columns=3,
                ),
            )
        ),
        claims=(_above_reference(), _below_reference(), _enough()),
        notes=(said("temperatures.measured_temperatures_oil"),),
    )


def _needed() -> float:
    """ν_1 of the 6305 at the speed of the tests; mm²/s."""
    return float(reference_viscosity(speed(), pitch_diameter())) / MICRO


def _viscosity(condition: str) -> float:
    return float(oil_at(temperature(condition)).kinematic_viscosity) / MICRO


def _above_reference() -> Claim:
    reference = GIVEN.inputs_of("temperature")["reference_viscosity_mm2_s"]
    used = GIVEN.inputs_of("contact")["viscosities_mm2_s"]["I"]
    return Claim(
        said("above_reference.statement"),
        said(
            "above_reference.finding",
            viscosity=_viscosity("I"),
            temperature=temperature("I"),
            used=used,
        ),
        _viscosity("I") > reference,
    )


def _below_reference() -> Claim:
    reference = GIVEN.inputs_of("temperature")["reference_viscosity_mm2_s"]
    return Claim(
        said("below_reference.statement"),
        same("{:.2f} mm²/s.", _viscosity("II")),
        _viscosity("II") < reference,
    )


def _enough() -> Claim:
    needed = _needed()
    return Claim(
        said("enough.statement"),
        said("enough.finding", needed, *(_viscosity(name) / needed for name in ("I", "II"))),
        needed <= GIVEN.inputs_of("temperature")["reference_viscosity_mm2_s"],
    )


_MICRO: Final = 1e6
_BANDS: Final = ("L", "M", "H")
_CLOSE: Final = 0.9
"""Correlation from which two quantities are said to rise together."""
_TIME: Final = said("time_h")


def noise_section(title: Text) -> Section:
    """Show the noise records, and what they show."""
    return Section(title, (_after_test(), _test_5()))


def anderon_speed(band: str) -> float:
    """Return the vibration of one anderon in a band; rms, µm/s."""
    given = GIVEN.inputs_of("noise")
    low, high = given["bands_Hz"][band]
    return _MICRO * velocity_of_anderons(1.0, (low, high), given["speed_rpm"] * RPM)


# --- table 4.1.3 ------------------------------------------------------------


@cache
def _rejected() -> dict[int, str]:
    """Bands in which each bearing was rejected."""
    return {int(name): bands for name, bands in GIVEN.inputs_of("noise")["rejected"].items()}


def _roughness(bearing: int) -> float:
    """R_a of the inner race after the test; µm."""
    rows = GIVEN.inputs_of("roughness")["rows"]
    return float(next(row[1] for row in rows if row[0] == bearing))


def _after_test() -> Table:
    rejected = _rejected()
    tests = {number: test for test in life_tests() for number in test.bearings}

    def column(name: str, title: Text, cells: list[str]) -> TableColumn:
        return TableColumn(name, title, tuple(cells))

    return Table(
        number="4.1.3",
        caption=said("after_test.caption"),
        source=GIVEN.source_of("noise"),
        columns=(
            column("bearing", said("bearing"), [str(n) for n in rejected]),
            column("condition", said("condition"), [tests[n].condition for n in rejected]),
            column("hours", said("time_h"), [f"{tests[n].hours:.1f}" for n in rejected]),
            *(
                column(
                    band, same(band), ["×" if band in bands else "–" for bands in rejected.values()]
                )
                for band in _BANDS
            ),
            column("Ra_um", same("R_a (µm)"), [f"{_roughness(n):.4f}" for n in rejected]),
        ),
        claims=(_high(), _low(), _reliable()),
    )


def _mark(rejected: bool) -> str:
    return "×" if rejected else "–"


def _high() -> Claim:
    new = GIVEN.inputs_of("roughness")["new_inner_um"]
    found = [_roughness(n) for n, bands in _rejected().items() if "H" in bands]
    return Claim(
        said("high.statement"),
        said(
            "high.finding",
            found_count=len(found),
            new=new,
            found_min=min(found),
            found_max=max(found),
        ),
        len(found) == len(_rejected()) and min(found) > new,
    )


def _low() -> Claim:
    seen = set(GIVEN.inputs_of("noise")["found_by_eye"])
    rejected = {n for n, bands in _rejected().items() if "L" in bands}
    rejected |= {bearing for hours, bearing, levels in _levels() if not levels}
    recorded = seen & (set(_rejected()) | set(BEARINGS))
    return Claim(
        said("low.statement"),
        said("low.finding", bearings=said("low.and", *sorted(rejected))),
        rejected == recorded,
    )


def _reliable() -> Claim:
    failed = {number for test in life_tests() for number in test.failed}
    passed = {n: bands for n, bands in _rejected().items() if n not in failed}
    counts = [sum(band in bands for bands in passed.values()) for band in _BANDS]
    return Claim(
        said("reliable.statement"),
        said("reliable.finding", len(passed), *counts),
        holds=counts[-1] == 0,
        partly=counts[0] == 0,
    )


# --- table 4.1.4 ------------------------------------------------------------


def _levels() -> list[tuple[float, int, list[int]]]:
    """Hours, bearing and the levels of test 5, none where rejected."""
    return [(hours, bearing, levels) for hours, bearing, levels in GIVEN.inputs_of("noise")["rows"]]


def _test_5() -> Table:
    rows = _levels()
    hours = [float(value) for value in GIVEN.inputs_of("clearance")["hours"]]

    def level(levels: list[int], place: int) -> str:
        return str(levels[place]) if levels else "×"

    def speed(levels: list[int], place: int) -> str:
        return f"{levels[place] * anderon_speed(_BANDS[place]):.0f}" if levels else "–"

    return Table(
        number="4.1.4",
        caption=said("test_5.caption"),
        source=GIVEN.source_of("noise"),
        columns=(
            TableColumn("hours", _TIME, tuple(f"{r[0]:.1f}" for r in rows)),
            TableColumn("bearing", said("bearing"), tuple(str(r[1]) for r in rows)),
            *(
                TableColumn(
                    f"{band}_anderon",
                    same("{} (anderon)", band),
                    tuple(level(r[2], place) for r in rows),
                )
                for place, band in enumerate(_BANDS)
            ),
            *(
                TableColumn(
                    f"{band}_um_per_s",
                    same("{} (µm/s)", band),
                    tuple(speed(r[2], place) for r in rows),
                )
                for place, band in enumerate(_BANDS)
            ),
            TableColumn(
                "clearance_um",
                said("test_5.clearance_um"),
                tuple(f"{measured_of(r[1])[hours.index(r[0])]:.0f}" for r in rows),
            ),
        ),
        claims=(_marks_and_clearance(),),
        notes=(_anderon_unit(),),
    )


def _together(bearing: int) -> tuple[Floats, Floats]:
    """Level in M and clearance (µm) of a bearing at the times that have both."""
    hours = [float(value) for value in GIVEN.inputs_of("clearance")["hours"]]
    rows = [(time, levels) for time, b, levels in _levels() if b == bearing and levels]
    level = np.array([levels[_BANDS.index("M")] for _, levels in rows], dtype=np.float64)
    clearance = np.array([measured_of(bearing)[hours.index(time)] for time, _ in rows])
    return level, clearance


def _marks_and_clearance() -> Claim:
    correlations = [float(np.corrcoef(*_together(bearing))[0, 1]) for bearing in BEARINGS]
    rises = [np.diff(_together(bearing)[0]) for bearing in BEARINGS]
    return Claim(
        said("marks_and_clearance.statement"),
        said("marks_and_clearance.finding", *correlations),
        all(bool((rise > 0).all()) for rise in rises) and min(correlations) > _CLOSE,
        of_theory=True,
    )


def _anderon_unit() -> Text:
    return said(
        "anderon_unit",
        speed_rpm=GIVEN.inputs_of("noise")["speed_rpm"],
        anderon_speed_1=anderon_speed("L"),
        anderon_speed_2=anderon_speed("H"),
        levels=_levels()[0][2][0] * anderon_speed("L"),
    )
