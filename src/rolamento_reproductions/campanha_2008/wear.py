"""How the clearance of test 5 grew: figures 4.3.2 and 4.3.3."""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import numpy as np

from rolamento.clearance import WearFit, fit_wear
from rolamento_reproductions.campanha_2008.inputs import GIVEN, HOUR, MICRO
from rolamento_reproductions.given import grid
from rolamento_reproductions.record import Claim, Curves, Figure, Floats, Line, Panel, Series
from rolamento_reproductions.text import Text, said

__all__ = ["BEARINGS", "CLEARANCE", "TIME", "measured_of", "wear_figures", "wear_of"]

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
    greatest = max(fit.constants["wear_rate"] for fit in fits) * 1e3 * HOUR / MICRO
    return said(
        "A steady rate of wear beside the running in comes out below {:.1f} µm per 1000 h: the late"
        " increase is the end of the running in. What another bearing will do, two of one test do"
        " not tell.",
        "Uma taxa constante de desgaste ao lado do amaciamento resulta menor que {:.1f} µm por 1000"
        " h: o aumento tardio é o fim do amaciamento. O que outro rolamento fará, dois de um mesmo"
        " ensaio não dizem.",
        max(0.1, float(np.ceil(10.0 * greatest) / 10.0)),
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
