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
from rolamento_reproductions.text import Text, said, same

BEARINGS = (9, 10)
"""Of test 5."""
CLEARANCE = said("Radial clearance", "Folga radial")
TIME = said("Running time", "Tempo de ensaio")


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
        Series("measurement", "", said("Measurement", "Medição"), number),
        *(
            Series(f"bearing_{b}", "µm", said("Bearing {}", "Rolamento {}", b), measured_of(b))
            for b in BEARINGS
        ),
    )
    lines = tuple(
        Line(f"bearing_{b}", look, said("bearing {}", "rolamento {}", b), marked="measurement")
        for look, b in enumerate(BEARINGS)
    )
    growth = [np.diff(measured_of(b)) for b in BEARINGS]
    return Figure(
        number="4.3.2",
        caption=said(
            "Clearance of the bearings of test 5 at the five measurements: new, after 60, 120, 180"
            " and 627.6 h.",
            "Folga dos rolamentos do ensaio 5 nas cinco medições: novo, após 60, 120, 180 e 627,6"
            " h.",
        ),
        source=GIVEN.source_of("clearance"),
        columns=columns,
        picture=Curves((Panel("measurement", CLEARANCE, "µm", lines, tick=1.0),)),
        claims=(
            Claim(
                said(
                    "The clearance of bearings 9 and 10 grows through the five measurements.",
                    "A folga dos rolamentos 9 e 10 aumenta nas cinco medições.",
                ),
                said(
                    "By {:.0f}, {:.0f}, {:.0f}, {:.0f} µm and by {:.0f}, {:.0f}, {:.0f}, {:.0f}"
                    " µm.",
                    "Em {:.0f}, {:.0f}, {:.0f}, {:.0f} µm e em {:.0f}, {:.0f}, {:.0f}, {:.0f} µm.",
                    *(float(step) for steps in growth for step in steps),
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
        title = said("Bearing {}", "Rolamento {}", bearing)
        columns += [
            Series(f"bearing_{bearing}_measured", "µm", title, measured),
            Series(f"bearing_{bearing}_law", "µm", title, law),
        ]
        lines += [
            Line(
                f"bearing_{bearing}_measured",
                look,
                said("bearing {}, measured", "rolamento {}, medido", bearing),
                points=True,
            ),
            Line(
                f"bearing_{bearing}_law",
                look,
                said("bearing {}, law", "rolamento {}, lei", bearing),
            ),
        ]
    return Figure(
        number="4.3.3",
        caption=said(
            "Clearance of the bearings of test 5 over time: measured, and the law of running in"
            " P_0 + A (1 − e^(−t/τ)) fitted to it.",
            "Folga dos rolamentos do ensaio 5 em função do tempo: medida, e a lei de amaciamento"
            " P_0 + A (1 − e^(−t/τ)) ajustada a ela.",
        ),
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
        said(
            "At first the clearance grows much, from moderate to severe wear; then little, and the"
            " wear is stable.",
            "No início a folga varia muito, com desgaste de moderado a severo; depois, pouco, e o"
            " desgaste se estabiliza.",
        ),
        said(
            "{:.0f} and {:.0f} µm per 1000 h over the first 60 h, {:.0f} and {:.0f} over the last"
            " {:.0f} h.",
            "{:.0f} e {:.0f} µm por 1000 h nas primeiras 60 h, {:.0f} e {:.0f} nas últimas {:.0f}"
            " h.",
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
    return said(
        "A steady rate of wear beside the running in comes out below {:.1f} µm per 1000 h: the late"
        " increase is the end of the running in. What another bearing will do, two of one test do"
        " not tell.",
        "Uma taxa constante de desgaste ao lado do amaciamento resulta menor que {:.1f} µm por 1000"
        " h: o aumento tardio é o fim do amaciamento. O que outro rolamento fará, dois de um mesmo"
        " ensaio não dizem.",
        max(0.1, float(np.ceil(10.0 * maximum) / 10.0)),
    )


def _constants(bearing: int) -> Text:
    fit = wear_of(bearing)
    names = ("initial_clearance", "running_in_wear", "running_in_time")
    scales = (MICRO, MICRO, HOUR)
    pairs = [
        value / scale
        for name, scale in zip(names, scales, strict=True)
        for value in (fit.constants[name], fit.standard_errors[name])
    ]
    return said(
        "Bearing {}: P_0 = {:.1f} ± {:.1f} µm, A = {:.1f} ± {:.1f} µm, τ = {:.0f} ± {:.0f} h; the"
        " points lie {:.1f} µm from the law (standard deviation).",
        "Rolamento {}: P_0 = {:.1f} ± {:.1f} µm, A = {:.1f} ± {:.1f} µm, τ = {:.0f} ± {:.0f} h; os"
        " pontos distam {:.1f} µm da lei (desvio padrão).",
        bearing,
        *pairs,
        fit.residual / MICRO,
    )


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
        caption=said(
            "What the measuring load adds to the clearance (µm), by range of bores and class:"
            " printed beside twice the radial displacement beyond the clearance, by the equilibrium"
            " of a usual bearing of that range with a ball under the load.",
            "O que a carga de medição acresce à folga (µm), por faixa de furo e classe: impresso ao"
            " lado do dobro do deslocamento radial além da folga, pelo equilíbrio de um rolamento"
            " usual da faixa com uma esfera sob a carga.",
        ),
        source=GIVEN.source_of("measuring_load"),
        columns=(
            TableColumn("load_N", same("F (N)"), tuple(f"{row['load_N']:.1f}" for row in rows)),
            TableColumn(
                "bearing", said("Bearing", "Rolamento"), tuple(row["bearing"] for row in rows)
            ),
            *(
                TableColumn(head, _class_title(head), tuple(cells[:, place]))
                for place, head in enumerate(heads)
            ),
        ),
        claims=(_elastic(),),
        notes=(
            said(
                "Other bearings of the same range come out up to 2 µm away: for a bearing at hand"
                " the correction is better computed than looked up.",
                "Outros rolamentos da mesma faixa diferem em até 2 µm: para um rolamento dado, é"
                " melhor calcular a correção do que tirá-la da tabela.",
            ),
        ),
    )


def _ends(numbers: list[str]) -> tuple[str, ...]:
    """Of a class with one number for the minimum clearance and one for the maximum."""
    return ("least", "greatest") if len(numbers) == 2 else ("um",)


def _class_title(head: str) -> Text:
    name, end = head.split("_")
    ends = {"least": said(", minimum", ", mínima"), "greatest": said(", maximum", ", máxima")}
    return same("{}{}", name, ends.get(end, same("")))


def _elastic() -> Claim:
    checks = [check for check in clearance_checks() if check.quantity.startswith("ΔP_d")]
    agreeing = sum(check.verdict == "agrees" for check in checks)
    return Claim(
        said(
            "The measured clearance is a little greater than the real one by the elastic"
            " deformation under the measuring load.",
            "A folga medida é ligeiramente maior que a real, pela deformação elástica sob a carga"
            " de medição.",
        ),
        said(
            "All {} of the {} numbers follow from just that.",
            "Todos os {} de {} números decorrem exatamente disso.",
            agreeing,
            len(checks),
        ),
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
            said("ISO 5753-1, by the bore.", "ISO 5753-1, pelo furo."),
        )
        for check in checks
    )
    low, high = (value / MICRO for value in clearances_of_class())
    new = measured_of(9)[0], measured_of(10)[0]
    return numbers_table(
        "G",
        said(
            "Clearance of the tested and the supporting bearings, new.",
            "Folga dos rolamentos testados e dos de suporte, novos.",
        ),
        GIVEN.source_of("class_clearance"),
        rows,
        claims=(
            Claim(
                said(
                    "The tested bearings are of class C3.",
                    "Os rolamentos testados são da classe C3.",
                ),
                said(
                    "The two measured new had {:.0f} and {:.0f} µm; C3 is {:.0f} to {:.0f} µm.",
                    "Os dois medidos novos tinham {:.0f} e {:.0f} µm; C3 é {:.0f} a {:.0f} µm.",
                    *new,
                    low,
                    high,
                ),
                all(low <= value <= high for value in new),
            ),
        ),
    )


def _class_quantity(quantity: str) -> Text:
    """Say ``"P_d min, 6305 C3"`` in both languages."""
    which, bearing = quantity.removeprefix("P_d ").split(", ")
    words = {"min": said("minimum", "mínima"), "max": said("maximum", "máxima")}
    return same("{} {} (µm)", bearing, words[which])


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
        title = said("Condition {}", "Condição {}", name)
        columns.append(Series(f"condition_{name}", "µm", title, np.concatenate(values)[order]))
    law = np.mean([wear_of(b).clearance(time[order] * HOUR) / MICRO for b in BEARINGS], axis=0)
    columns.append(Series("law", "µm", said("Law of test 5", "Lei do ensaio 5"), law))
    means = {name: float(_after_test(name).mean()) for name in times}
    lines = (
        *(
            Line(
                f"condition_{name}",
                look,
                said("condition {}, mean {:.1f} µm", "condição {}, média {:.1f} µm", name, mean),
                points=True,
            )
            for look, (name, mean) in enumerate(means.items())
        ),
        Line("law", 6, said("bearings 9 and 10, mean of laws", "rolamentos 9 e 10, lei média")),
    )
    return Figure(
        number="4.3.1",
        caption=said(
            "Clearance after the test in both conditions, over the time run until then; 9 and 10 at"
            " 180 h, as in the dissertation. The line is what figure 4.3.3 gives for those two.",
            "Folga após o ensaio nas duas condições, em função do tempo até a medição; 9 e 10 com"
            " 180 h, como na dissertação. A linha é o que a figura 4.3.3 dá para esses dois.",
        ),
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
        said(
            "The clearances of conditions I and II do not differ significantly.",
            "As folgas das condições I e II não apresentam variação significativa.",
        ),
        said(
            "Means {:.1f} and {:.1f} µm; they differ by {:.1f} µm with a standard error of {:.1f}"
            " µm.",
            "Médias de {:.1f} e {:.1f} µm; diferem em {:.1f} µm com erro padrão de {:.1f} µm.",
            float(_after_test("I").mean()),
            float(_after_test("II").mean()),
            difference,
            error,
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
        said(
            "The wear of both conditions is alike; the temperature makes no perceptible"
            " difference.",
            "O desgaste nas duas condições é similar; a temperatura não o altera de forma"
            " perceptível.",
        ),
        said(
            "A difference below some {:.0f} µm could not be seen. Most bearings were measured after"
            " the test only, and new ones differ by up to {:.0f} µm; condition II ran longer on"
            " average, {:.0f} against {:.0f} h, worth {:.1f} µm by the law of test 5.",
            "Uma diferença menor que cerca de {:.0f} µm não seria vista. A maioria só foi medida"
            " após o ensaio, e novos diferem em até {:.0f} µm; a condição II durou mais em média,"
            " {:.0f} contra {:.0f} h, o que vale {:.1f} µm pela lei do ensaio 5.",
            _LIKELY * error,
            high - low,
            hours[1],
            hours[0],
            worn[1] - worn[0],
        ),
        holds=False,
        partly=True,
    )
