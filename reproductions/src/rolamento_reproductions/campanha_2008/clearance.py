"""Clearance: the measuring load, the classes, how it grew in tests; figures 4.3.1 to 4.3.3."""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import numpy as np

from rolamento.clearance import WearFit, fit_wear
from rolamento.clearance.standards import CLEARANCE_CLASSES
from rolamento_reproductions.campanha_2008.inputs import (
    GIVEN,
    HOUR,
    MICRO,
    Number,
    clearance_checks,
    clearances_of_class,
    numbers_table,
    printed,
    said,
)
from rolamento_reproductions.campanha_2008.life_tests import life_tests
from rolamento_reproductions.given import grid
from rolamento_reproductions.record import (
    Cell,
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

BEARINGS = (9, 10)
"""Hours of test 5."""
CLEARANCE = said("clearance.radial_clearance")
TIME = said("time.running_time")


def wear_figures() -> tuple[Figure, Figure]:
    """Compute figures 4.3.2 and 4.3.3."""
    return _by_measurement(), _over_time()


@cache
def wear_of(bearing: int) -> WearFit:
    """Return the law of running in of a bearing of test 5."""
    hours = np.array(GIVEN.inputs_of("clearance")["hours"])
    return fit_wear(hours * HOUR, measured_of(bearing) * MICRO)


def measured_of(bearing: int) -> Floats:
    """Return the clearances of a bearing of test 5; µm."""
    return np.array(GIVEN.inputs_of("clearance")[f"bearing_{bearing}"], dtype=np.float64)


def _by_measurement() -> Figure:
    count = len(GIVEN.inputs_of("clearance")["hours"])
    number = np.arange(1.0, count + 1.0)
    columns = (
        Series("measurement", "", said("by_measurement.measurement"), number),
        *(
            Series(f"bearing_{b}", "µm", said("by_measurement.bearing", bearing=b), measured_of(b))
            for b in BEARINGS
        ),
    )
    lines = tuple(
        Line(
            f"bearing_{b}",
            look,
            said("by_measurement.bearing.bearing", bearing=b),
            marked="measurement",
        )
        for look, b in enumerate(BEARINGS)
    )
    growth = [np.diff(measured_of(b)) for b in BEARINGS]
    return Figure(
        number="4.3.2",
        caption=said("by_measurement.caption"),
        source=GIVEN.source_of("clearance"),
        columns=columns,
        picture=Curves((Panel("measurement", CLEARANCE, "µm", lines, tick=1.0),)),
        claims=(
            Claim(
                said("by_measurement.statement"),
                said(
                    "by_measurement.finding", *(float(step) for steps in growth for step in steps)
                ),
                all(bool((steps > 0.0).all()) for steps in growth),
            ),
        ),
    )


def _over_time() -> Figure:
    given = GIVEN.inputs_of("clearance")
    hours = np.array(given["hours"])
    time = np.unique(np.concatenate([grid(0.0, 625.0, 5.0), hours]))
    at = np.searchsorted(time, hours)
    columns = [Series("time", "h", TIME, time)]
    lines = []
    for look, bearing in enumerate(BEARINGS):
        measured = np.full(time.size, np.nan)
        measured[at] = measured_of(bearing)
        law = wear_of(bearing).clearance(time * HOUR) / MICRO
        title = said("over_time.bearing", bearing=bearing)
        columns += [
            Series(f"bearing_{bearing}_measured", "µm", title, measured),
            Series(f"bearing_{bearing}_law", "µm", title, law),
        ]
        lines += [
            Line(
                f"bearing_{bearing}_measured",
                look,
                said("over_time.bearing_measured", bearing=bearing),
                points=True,
            ),
            Line(f"bearing_{bearing}_law", look, said("over_time.bearing_law", bearing=bearing)),
        ]
    return Figure(
        number="4.3.3",
        caption=said("over_time.caption"),
        source=GIVEN.source_of("clearance"),
        columns=tuple(columns),
        picture=Curves(
            (Panel("time", CLEARANCE, "µm", tuple(lines), tick=100.0, legend_columns=2),)
        ),
        claims=(_two_phases(),),
        notes=(*(_constants(bearing) for bearing in BEARINGS), _no_steady_wear()),
    )


def _two_phases() -> Claim:
    hours = np.array(GIVEN.inputs_of("clearance")["hours"])
    rates = [np.diff(measured_of(b)) / np.diff(hours) * 1e3 for b in BEARINGS]
    slowing = all(early >= late for rate in rates for early, late in pairwise(rate))
    return Claim(
        said("two_phases.statement"),
        said(
            "two_phases.finding",
            *(float(rate[0]) for rate in rates),
            *(float(rate[-1]) for rate in rates),
            float(hours[-1] - hours[-2]),
        ),
        slowing,
    )


def _no_steady_wear() -> Text:
    hours = np.array(GIVEN.inputs_of("clearance")["hours"])
    fits = [
        fit_wear(hours * HOUR, measured_of(b) * MICRO, "running_in_and_steady") for b in BEARINGS
    ]
    maximum = max(fit.constants["wear_rate"] for fit in fits) * 1e3 * HOUR / MICRO
    return said("no_steady_wear", value_max=max(0.1, float(np.ceil(10.0 * maximum) / 10.0)))


def _constants(bearing: int) -> Text:
    fit = wear_of(bearing)
    names = ("initial_clearance", "running_in_wear", "running_in_time")
    scales = (MICRO, MICRO, HOUR)
    pairs = [
        value / scale
        for name, scale in zip(names, scales, strict=True)
        for value in (fit.constants[name], fit.standard_errors[name])
    ]
    return said("constants", bearing, *pairs, fit.residual / MICRO)


_LATE = 180.0
"""h: the last measurement but one."""
_LIKELY = 2.0
"""Standard errors, within which two means are taken for alike."""


def clearance_section(title: Text) -> Section:
    """Compute table 3.2, the classes, and figures 4.3.1 to 4.3.3."""
    return Section(title, (_measuring_load(), _classes(), _by_condition(), *wear_figures()))


# --- table 3.2 and the classes ----------------------------------------------


def _measuring_load() -> Table:
    rows = printed("measuring_load")["row"]
    heads = [f"{name}_{end}" for name in CLEARANCE_CLASSES for end in _ends(rows[0][f"{name}_um"])]
    checks = [check for check in clearance_checks() if check.quantity.startswith("ΔP_d")]
    cells = np.array([Cell(c.printed, c.computed) for c in checks]).reshape(len(rows), -1)
    return Table(
        number="3.2",
        caption=said("measuring_load.caption"),
        source=GIVEN.source_of("measuring_load"),
        columns=(
            TableColumn("load_N", same("F (N)"), tuple(f"{row['load_N']:.1f}" for row in rows)),
            TableColumn("bearing", said("bearing"), tuple(row["bearing"] for row in rows)),
            *(
                TableColumn(head, _class_title(head), tuple(cells[:, place]))
                for place, head in enumerate(heads)
            ),
        ),
        claims=(_elastic(),),
        notes=(said("measuring_load.other_bearings_same"),),
    )


def _ends(numbers: list[str]) -> tuple[str, ...]:
    """Clearances of a class with one number for the minimum clearance and one for the maximum."""
    return ("least", "greatest") if len(numbers) == 2 else ("um",)


def _class_title(head: str) -> Text:
    name, end = head.split("_")
    return same(name) if end == "um" else said(f"class_title.{end}", name=name)


def _elastic() -> Claim:
    checks = [check for check in clearance_checks() if check.quantity.startswith("ΔP_d")]
    agreeing = sum(check.verdict == "agrees" for check in checks)
    return Claim(
        said("elastic.statement"),
        said("elastic.finding", agreeing=agreeing, checks_count=len(checks)),
        agreeing == len(checks),
    )


def _classes() -> Table:
    checks = [check for check in clearance_checks() if check.quantity.startswith("P_d")]
    rows = tuple(
        Number(
            check.quantity,
            _class_quantity(check.quantity),
            check.printed,
            check.computed,
            check.computed,
            said("classes.reason"),
        )
        for check in checks
    )
    low, high = (value / MICRO for value in clearances_of_class())
    new = measured_of(9)[0], measured_of(10)[0]
    return numbers_table(
        "G",
        said("classes.caption"),
        GIVEN.source_of("class_clearance"),
        rows,
        claims=(
            Claim(
                said("classes.statement"),
                said("classes.finding", *new, low, high),
                all(low <= value <= high for value in new),
            ),
        ),
    )


def _class_quantity(quantity: str) -> Text:
    """Say ``"P_d min, 6305 C3"`` in both languages."""
    which, bearing = quantity.removeprefix("P_d ").split(", ")
    return said(f"class_quantity.{which}", bearing=bearing)


# --- figure 4.3.1 -----------------------------------------------------------


def hours_of_samples(condition: str) -> Floats:
    """Return how long each sample of a condition of procedure I had run when it was measured; h."""
    return np.array(
        [
            _LATE if set(test.bearings) == set(BEARINGS) else test.hours
            for test in life_tests()
            if test.procedure == "I" and test.condition == condition
            for _ in test.bearings
        ]
    )


def _after_test(condition: str) -> Floats:
    return np.array(GIVEN.inputs_of("clearance")[f"condition_{condition}"], dtype=np.float64)


def _by_condition() -> Figure:
    times = {name: hours_of_samples(name) for name in ("I", "II")}
    curve = grid(0.0, 200.0, 2.0)
    time = np.concatenate([*times.values(), curve])
    order = np.argsort(time, kind="stable")
    none = [np.full(part.size, np.nan) for part in (*times.values(), curve)]
    columns = [Series("time", "h", TIME, time[order])]
    for place, name in enumerate(times):
        values = list(none)
        values[place] = _after_test(name)
        title = said("by_condition.condition", name=name)
        columns.append(Series(f"condition_{name}", "µm", title, np.concatenate(values)[order]))
    law = np.mean([wear_of(b).clearance(time[order] * HOUR) / MICRO for b in BEARINGS], axis=0)
    columns.append(Series("law", "µm", said("by_condition.law"), law))
    means = {name: float(_after_test(name).mean()) for name in times}
    lines = (
        *(
            Line(
                f"condition_{name}",
                look,
                said("by_condition.condition_mean_m", name=name, mean=mean),
                points=True,
            )
            for look, (name, mean) in enumerate(means.items())
        ),
        Line("law", 6, said("by_condition.bearings_9_and")),
    )
    return Figure(
        number="4.3.1",
        caption=said("by_condition.caption"),
        source=GIVEN.source_of("clearance"),
        columns=tuple(columns),
        picture=Curves((Panel("time", CLEARANCE, "µm", lines, tick=40.0, legend_columns=2),)),
        claims=(_alike(), _same_wear()),
    )


def _difference() -> tuple[float, float]:
    """Difference of the means of the two conditions and its standard error; µm."""
    first, second = _after_test("I"), _after_test("II")
    error = np.sqrt(first.var(ddof=1) / first.size + second.var(ddof=1) / second.size)
    return float(second.mean() - first.mean()), float(error)


def _alike() -> Claim:
    difference, error = _difference()
    return Claim(
        said("alike.statement"),
        said(
            "alike.finding",
            after_test_mean_1=float(_after_test("I").mean()),
            after_test_mean_2=float(_after_test("II").mean()),
            difference=difference,
            error=error,
        ),
        abs(difference) < _LIKELY * error,
    )


def _same_wear() -> Claim:
    _, error = _difference()
    low, high = (value / MICRO for value in clearances_of_class())
    hours = [float(hours_of_samples(name).mean()) for name in ("I", "II")]
    worn = [
        float(np.mean([wear_of(b).growth(time * HOUR) for b in BEARINGS])) / MICRO for time in hours
    ]
    return Claim(
        said("same_wear.statement"),
        said(
            "same_wear.finding",
            likely=_LIKELY * error,
            high=high - low,
            hours_1=hours[1],
            hours_2=hours[0],
            worn=worn[1] - worn[0],
        ),
        holds=False,
        partly=True,
    )
