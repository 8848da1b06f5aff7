"""The load zone: figures 4.1.3 and 4.1.4, and the life that clearance takes off."""

from __future__ import annotations

from functools import cache

import numpy as np

from rolamento.life.iso281 import hours
from rolamento.life.iso16281 import RaceRatings, race_ratings, reference_life
from rolamento.life.load_zone import catalogue_stiffness, clearance_function, load_zone, zone_life
from rolamento.static import RadialSolution, radial_load
from rolamento.verification.campanha_2008 import STRIBECK
from rolamento_reproductions.campanha_2008.inputs import (
    GIVEN,
    MICRO,
    NONE,
    Number,
    ball_count,
    ball_diameter,
    basic_life_hours,
    bearing,
    clearances_of_class,
    load,
    numbers_table,
    outer_conformity,
    pitch_diameter,
    printed,
    said,
    speed,
)
from rolamento_reproductions.given import KILO, grid
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
)
from rolamento_reproductions.text import Text, same

NO_CLEARANCE = 0.5
"""ε without clearance."""


def elastic_deflection() -> float:
    """Return what a ball approaches the rings by under 5 F_r/Z, with the maker's stiffness; m."""
    ball = STRIBECK * load() / ball_count()
    return float((ball / catalogue_stiffness(ball_diameter())) ** (2.0 / 3.0))


def _clearances() -> list[float]:
    """Preload, none, the new bearing's, a worn one's, and what was taken for a clearance; m."""
    given = GIVEN.inputs_of("load_zone")
    return [
        given["preload_um"] * MICRO,
        *(value * MICRO for value in given["clearances_um"]),
        elastic_deflection(),
    ]


@cache
def loaded(clearance: float) -> RadialSolution:
    """Return the bearing with a clearance (m) under the load, its balls smeared round the ring."""
    return radial_load(bearing(clearance), load())


def distribution_figure() -> Figure:
    """Compute figure 4.1.3."""
    clearances = _clearances()
    azimuth = grid(-180.0, 180.0, 1.0)
    place = np.mod(azimuth, 360.0) * ball_count() / 360.0
    ball = np.where(np.isclose(place, np.round(place)), np.round(place) + 1.0, np.nan)
    microns = [clearance / MICRO for clearance in clearances]
    columns = (
        Series("clearance", "µm", said("radial_clearance"), np.repeat(microns, azimuth.size)),
        Series(
            "azimuth", "°", said("distribution_figure.azimuth"), np.tile(azimuth, len(clearances))
        ),
        Series("ball", "", said("distribution_figure.ball"), np.tile(ball, len(clearances))),
        Series(
            "ball_load",
            "kN",
            said("distribution_figure.ball_load"),
            np.concatenate([loaded(c).load_at(np.radians(azimuth)) / KILO for c in clearances]),
        ),
    )
    lines = tuple(
        Line(
            "ball_load",
            look,
            same("Δ = {:.0f} µm, ε = {:.2f}", micron, float(loaded(clearance).load_zone_parameter)),
            by=("clearance", micron),
            marked="ball",
        )
        for look, (micron, clearance) in enumerate(zip(microns, clearances, strict=True))
    )
    return Figure(
        number="4.1.3",
        caption=said("distribution_figure.caption", load=load()),
        source=GIVEN.source_of("load_zone"),
        columns=columns,
        picture=Curves(
            (
                Panel(
                    "azimuth",
                    columns[3].title,
                    "kN",
                    lines,
                    tick=45.0,
                    around=True,
                    legend_columns=3,
                ),
            )
        ),
        claims=(_half(), _heaviest()),
        notes=(
            said(
                "distribution_figure.printed_figure_is",
                measured_conformity=printed("life")["measured_conformity"],
            ),
        ),
    )


def _half() -> Claim:
    none = loaded(0.0)
    return Claim(
        said("half.statement"),
        said(
            "half.finding",
            load_zone_parameter=float(none.load_zone_parameter),
            load_zone_half_angle=float(np.degrees(none.load_zone_half_angle)),
        ),
        abs(float(none.load_zone_parameter) - NO_CLEARANCE) < 1e-12,
    )


def _heaviest() -> Claim:
    new = [loaded(clearance) for clearance in clearances_of_class()]
    stribeck = STRIBECK * load() / ball_count()
    loads = [float(state.max_ball_load) for state in new]
    return Claim(
        said("heaviest.statement", stribeck=stribeck),
        said("heaviest.finding", *loads),
        holds=False,
        partly=all(0.85 * stribeck < value < stribeck for value in loads),
    )


_OTHER_LOADS = (0.1, 0.01)
"""Fraction of the test load: where the mistaken clearance is shown to cost as much as there."""
_BEST = (0.7, 0.8)
"""ε between which life is longest, by the maker's own table."""


def load_zone_section(title: Text) -> Section:
    """Compute figures 4.1.3 and 4.1.4 and the reduced life."""
    return Section(title, (distribution_figure(), _life_figure(), _load_zone_table()))


# --- figure 4.1.4 -----------------------------------------------------------


@cache
def _ratings() -> RaceRatings:
    """Ratings of the races, with the catalogue's C and the conformities that it stands for."""
    return race_ratings(
        printed("life")["dynamic_rating_N"],
        ball_count(),
        ball_diameter(),
        pitch_diameter(),
        GIVEN.inputs_of("ratings")["nominal_conformity"],
        outer_conformity(),
        0.0,
    )


def _by_the_maker(clearance: Floats) -> tuple[Floats, Floats]:
    """Return ε and the relative life of a smeared ring of balls with the maker's stiffness."""
    zone = load_zone(clearance, load(), ball_count(), catalogue_stiffness(ball_diameter()))
    return zone, zone_life(zone, _ratings())


@cache
def _ball_by_ball(clearance: float) -> float:
    """Reference life of ISO/TS 16281 in 10^6 rev, eight balls in all positions, groove as measured.

    The balls stand everywhere in turn: a point of the outer race sees the ball that passes it, and
    a point of the inner race all of them.
    """
    count = GIVEN.inputs_of("load_zone")["positions"]
    step = 2.0 * np.pi / ball_count() / count
    at = bearing(clearance)
    solved = [
        radial_load(at, load(), distribution="discrete", first_ball_azimuth=step * place)
        for place in range(count // 2 + 1)
    ]
    # beyond half the spacing the balls stand as before it, mirrored
    states = [solved[min(place, count - place)] for place in range(count)]
    loads = np.concatenate([state.ball_loads for state in states])[np.newaxis]
    return float(reference_life(loads, loads, _ratings()).life[0])


def relative_life(clearance: float) -> float:
    """Return the life of eight balls with a clearance (m) over that without."""
    return _ball_by_ball(clearance) / _ball_by_ball(0.0)


def _life_figure() -> Figure:
    given = GIVEN.inputs_of("load_zone")
    taken_at = elastic_deflection() / MICRO
    shown = grid(given["lowest_um"], given["highest_um"], given["step_um"])
    microns = np.unique([*shown, *given["clearances_um"], taken_at])
    zone, by_maker = _by_the_maker(microns * MICRO)
    balls = np.array([relative_life(float(micron) * MICRO) for micron in microns])
    marked = np.where(np.isin(microns, given["clearances_um"][1:]), balls, np.nan)
    taken = np.where(microns == taken_at, by_maker, np.nan)
    life = said("life_figure.life_over_that")
    columns = (
        Series("clearance", "µm", said("radial_clearance"), microns),
        Series("load_zone", "", said("life_figure.load_zone"), zone),
        Series("life_by_maker", "", life, by_maker),
        Series("life_ball_by_ball", "", life, balls),
        Series("life_of_tested", "", life, marked),
        Series("life_as_taken", "", life, taken),
    )
    lines = (
        Line("life_by_maker", 0, said("life_figure.maker_s_formula")),
        Line("life_ball_by_ball", 1, said("life_figure.ball_by_ball")),
        Line("life_of_tested", 2, said("life_figure.clearance_13_28"), points=True),
        Line("life_as_taken", 3, said("life_figure.72_m_as"), points=True),
    )
    return Figure(
        number="4.1.4",
        caption=said("life_figure.caption", load=load()),
        source=GIVEN.source_of("load_zone"),
        columns=columns,
        picture=Curves(
            (Panel("clearance", life, "", lines, tick=20.0, from_zero=False, legend_columns=2),)
        ),
        claims=(_fifth(), _rare(), _best_zone()),
        notes=(_same_everywhere(), _before_mounting()),
    )


def _fifth() -> Claim:
    new = [relative_life(clearance) for clearance in clearances_of_class()]
    worn = relative_life(GIVEN.inputs_of("load_zone")["clearances_um"][-1] * MICRO)
    zone, life = _by_the_maker(np.array([elastic_deflection()]))
    return Claim(
        said("fifth.statement"),
        said(
            "fifth.finding",
            *(100.0 * (1.0 - value) for value in (*new, worn)),
            elastic_deflection() / MICRO,
            float(zone[0]),
            100.0 * (1.0 - float(life[0])),
        ),
        holds=max(1.0 - value for value in new) >= 0.195,
    )


def _rare() -> Claim:
    low, high = (float(loaded(c).load_zone_parameter) for c in clearances_of_class())
    return Claim(
        said("rare.statement"), said("rare.finding", high=high, low=low), high < low < NO_CLEARANCE
    )


def _best_zone() -> Claim:
    microns = np.linspace(-120.0, 20.0, 561)
    zone, life = _by_the_maker(microns * MICRO)
    best = int(np.argmax(life))
    return Claim(
        said("best_zone.statement"),
        said(
            "best_zone.finding",
            zone=float(zone[best]),
            life=100.0 * (float(life[best]) - 1.0),
            microns=-float(microns[best]),
        ),
        _BEST[0] < float(zone[best]) < _BEST[1],
        of_theory=True,
    )


def _same_everywhere() -> Text:
    """Show that the mistaken clearance costs the same under any load."""
    lives = []
    for share in (1.0, *_OTHER_LOADS):
        force = share * load()
        stiffness = catalogue_stiffness(ball_diameter())
        taken = float((STRIBECK * force / ball_count() / stiffness) ** (2.0 / 3.0))
        zone = load_zone(taken, force, ball_count(), stiffness)
        lives.append(100.0 * (1.0 - float(zone_life(zone, _ratings()))))
    return said(
        "same_everywhere",
        STRIBECK ** (2.0 / 3.0),
        load(),
        *(share * load() for share in _OTHER_LOADS),
        *lives,
    )


def _before_mounting() -> Text:
    return said("before_mounting")


# --- the reduced life -------------------------------------------------------


@cache
def load_zone_numbers() -> tuple[Number, ...]:
    """Return the printed reduction, and the life that it leaves."""
    given = GIVEN.inputs_of("load_zone")
    kept = _read_off_a_table()
    new = [relative_life(clearance) for clearance in clearances_of_class()]
    life = float(given["life_h"])
    return (
        Number(
            "reduction",
            said("load_zone_numbers.reduction.quantity"),
            given["reduction_percent"],
            100.0 * (1.0 - kept),
            said("load_zone_numbers.reduction.right", *(100.0 * (1.0 - value) for value in new)),
            said(
                "load_zone_numbers.reduction.reason",
                elastic_deflection=elastic_deflection() / MICRO,
                by_the_maker=100.0
                * (1.0 - float(_by_the_maker(np.array([elastic_deflection()]))[1][0])),
            ),
        ),
        Number(
            "reduced_life",
            said("load_zone_numbers.reduced_life.quantity"),
            given["reduced_life_h"],
            life * round(kept, 2),
            NONE,
            said(
                "load_zone_numbers.reduced_life.reason", *(life * value for value in reversed(new))
            ),
        ),
    )


def _read_off_a_table() -> float:
    """Relative life by f(ε), linear between steps of ε."""
    step = GIVEN.inputs_of("load_zone")["table_step"]
    zones = grid(step, 1.0, step)
    wanted = STRIBECK ** (2.0 / 3.0)
    lives = zone_life(zones, _ratings())
    return float(np.interp(-wanted, -clearance_function(zones), lives))


def _load_zone_table() -> Table:
    lives = [_ball_by_ball(clearance) for clearance in (0.0, *clearances_of_class())]
    none, low, high = (float(hours(life, speed())) for life in lives)
    return numbers_table(
        "D",
        said("load_zone_table.caption"),
        GIVEN.source_of("load_zone"),
        load_zone_numbers(),
        notes=(
            said(
                "load_zone_table.reference_life_iso",
                none=none,
                high=high,
                low=low,
                basic_life_hours=basic_life_hours(printed("life")["dynamic_rating_N"]),
            ),
        ),
    )
