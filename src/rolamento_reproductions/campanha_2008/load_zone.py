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
from rolamento_reproductions.text import Text, said, same

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
        Series(
            "clearance",
            "µm",
            said("Radial clearance Δ", "Folga radial Δ"),
            np.repeat(microns, azimuth.size),
        ),
        Series("azimuth", "°", said("Azimuth ψ", "Azimute ψ"), np.tile(azimuth, len(clearances))),
        Series("ball", "", said("Ball", "Esfera"), np.tile(ball, len(clearances))),
        Series(
            "ball_load",
            "kN",
            said("Ball load Q", "Carga na esfera Q"),
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
        caption=said(
            "What the load factor ε means for the 6305 under {:,.0f} N: ball load round the ring"
            " with preload, without clearance, with the clearance of a new bearing of class C3, of"
            " one worn for 628 h, and with the elastic deflection taken for a clearance. Markers:"
            " the eight balls.",
            "O que o fator de carga ε significa para o 6305 sob {:,.0f} N: carga nas esferas ao"
            " redor do anel com pré-carga, sem folga, com a folga de um rolamento novo da classe"
            " C3, com a de um gasto por 628 h e com a aproximação elástica tomada por folga."
            " Marcadores: as oito esferas.",
            load(),
        ),
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
                "The printed figure is a sketch. Here the inner groove is as measured ({:.3f}), and"
                " the contacts are exact; balls are smeared round the ring (Sjövall).",
                "A figura impressa é um esquema. Aqui o canal interno é o medido ({:.3f}) e os"
                " contatos são exatos; as esferas são distribuídas ao redor do anel (Sjövall).",
                printed("life")["measured_conformity"],
            ),
        ),
    )


def _half() -> Claim:
    none = loaded(0.0)
    return Claim(
        said(
            "The calculation of life takes ε = 0.5, a bearing without clearance in operation.",
            "O cálculo de vida prevê ε = 0,5, um rolamento sem folga em operação.",
        ),
        said(
            "ε = {:.4f} without clearance, loaded over {:.1f}° on either side.",
            "ε = {:.4f} sem folga, com carga até {:.1f}° para cada lado.",
            float(none.load_zone_parameter),
            float(np.degrees(none.load_zone_half_angle)),
        ),
        abs(float(none.load_zone_parameter) - NO_CLEARANCE) < 1e-12,
    )


def _heaviest() -> Claim:
    new = [loaded(clearance) for clearance in clearances_of_class()]
    stribeck = STRIBECK * load() / ball_count()
    loads = [float(state.max_ball_load) for state in new]
    return Claim(
        said(
            "The heaviest ball carries 5 F_r/Z = {:,.0f} N (chapter 4.4.3).",
            "A esfera mais carregada leva 5 F_r/Z = {:,.0f} N (capítulo 4.4.3).",
            stribeck,
        ),
        said(
            "{:,.0f} to {:,.0f} N with the clearance of a new bearing: Stribeck's 5 leaves room for"
            " more clearance than these have.",
            "{:,.0f} a {:,.0f} N com a folga de um rolamento novo: o 5 de Stribeck deixa margem"
            " para folga maior que a destes.",
            *loads,
        ),
        holds=False,
        partly=all(0.85 * stribeck < value < stribeck for value in loads),
    )


_OTHER_LOADS = (0.1, 0.01)
"""Of the test load: where the mistaken clearance is shown to cost as much as there."""
_BEST = (0.7, 0.8)
"""ε between which life is longest, by the maker's own table."""


def load_zone_section(title: Text) -> Section:
    """Compute figures 4.1.3 and 4.1.4 and the reduced life."""
    return Section(title, (distribution_figure(), _life_figure(), _load_zone_table()))


# --- figure 4.1.4 -----------------------------------------------------------


@cache
def _ratings() -> RaceRatings:
    """Of the races, with the catalogue's C and the conformities that it stands for."""
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
    life = said("Life over that without clearance", "Vida sobre a vida sem folga")
    columns = (
        Series("clearance", "µm", said("Radial clearance Δ", "Folga radial Δ"), microns),
        Series("load_zone", "", said("Load factor ε", "Fator de carga ε"), zone),
        Series("life_by_maker", "", life, by_maker),
        Series("life_ball_by_ball", "", life, balls),
        Series("life_of_tested", "", life, marked),
        Series("life_as_taken", "", life, taken),
    )
    lines = (
        Line("life_by_maker", 0, said("maker's formula", "fórmula do fabricante")),
        Line(
            "life_ball_by_ball", 1, said("ball by ball, ISO/TS 16281", "por esfera, ISO/TS 16281")
        ),
        Line(
            "life_of_tested",
            2,
            said("clearance 13, 28, 50 µm", "folga de 13, 28, 50 µm"),
            points=True,
        ),
        Line("life_as_taken", 3, said("72 µm, as taken", "72 µm, como tomado"), points=True),
    )
    return Figure(
        number="4.1.4",
        caption=said(
            "Life of the 6305 under {:,.0f} N over its clearance in operation, relative to that"
            " without clearance.",
            "Vida do 6305 sob {:,.0f} N em função da folga em operação, relativa à vida sem folga.",
            load(),
        ),
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
        said(
            "In condition I the clearance takes 20 % off the life.",
            "Na condição I a folga tira 20 % da vida.",
        ),
        said(
            "{:.0f} to {:.0f} % with the 13 to 28 µm of a new bearing, {:.0f} % with the 50 µm of"
            " one worn for 628 h. The dissertation puts the elastic deflection of the heaviest"
            " ball, {:.0f} µm, in the place of the clearance: that gives ε = {:.3f} and {:.0f} %.",
            "{:.0f} a {:.0f} % com os 13 a 28 µm de um rolamento novo, {:.0f} % com os 50 µm de um"
            " gasto por 628 h. A dissertação põe a aproximação elástica da esfera mais carregada,"
            " {:.0f} µm, no lugar da folga: disso resultam ε = {:.3f} e {:.0f} %.",
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
        said(
            "A bearing without clearance in operation is rare.",
            "Um rolamento sem folga em operação é raro.",
        ),
        said(
            "With class C3 as new, ε = {:.2f} to {:.2f}. Which fits the rings had is not printed; a"
            " press fit would bring ε nearer to 0.5.",
            "Com a classe C3, novo, ε = {:.2f} a {:.2f}. Os ajustes dos anéis não foram impressos;"
            " um ajuste com interferência aproximaria ε de 0,5.",
            high,
            low,
        ),
        high < low < NO_CLEARANCE,
    )


def _best_zone() -> Claim:
    microns = np.linspace(-120.0, 20.0, 561)
    zone, life = _by_the_maker(microns * MICRO)
    best = int(np.argmax(life))
    return Claim(
        said(
            "Life is longest with a little preload, ε between 0.7 and 0.8.",
            "A vida é máxima com pequena pré-carga, ε entre 0,7 e 0,8.",
        ),
        said(
            "At ε = {:.2f}, {:.0f} % above that without clearance; here a preload of {:.0f} µm.",
            "Em ε = {:.2f}, {:.0f} % acima da vida sem folga; aqui, pré-carga de {:.0f} µm.",
            float(zone[best]),
            100.0 * (float(life[best]) - 1.0),
            -float(microns[best]),
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
        "The mistake shows by itself: with Q = 5 F_r/Z the deflection taken for a clearance makes"
        " f(ε) = 5^(2/3) = {:.3f}, whatever the load, the bearing or the clearance. Under"
        " {:,.0f}, {:,.0f} and {:,.0f} N the loss would be {:.1f}, {:.1f} and {:.1f} %.",
        "O engano se revela por si: com Q = 5 F_r/Z a aproximação tomada por folga dá f(ε) ="
        " 5^(2/3) = {:.3f}, quaisquer que sejam a carga, o rolamento e a folga. Sob"
        " {:,.0f}, {:,.0f} e {:,.0f} N a perda seria de {:.1f}, {:.1f} e {:.1f} %.",
        STRIBECK ** (2.0 / 3.0),
        load(),
        *(share * load() for share in _OTHER_LOADS),
        *lives,
    )


def _before_mounting() -> Text:
    return said(
        "The clearances are those before mounting and after the test; the one in operation is"
        " smaller by the press fit and the warmer inner ring, which makes the loss smaller still.",
        "As folgas são as de antes da montagem e de depois do ensaio; a de operação é menor por"
        " causa do ajuste e do anel interno mais quente, o que torna a perda ainda menor.",
    )


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
            said("loss of life by clearance (%)", "perda de vida pela folga (%)"),
            given["reduction_percent"],
            100.0 * (1.0 - kept),
            said("{:.0f} to {:.0f}", "{:.0f} a {:.0f}", *(100.0 * (1.0 - value) for value in new)),
            said(
                "The elastic deflection, {:.1f} µm, taken for the clearance, and the life read off"
                " a table in steps of ε of 0.1, as makers print it; without the table {:.1f} %. The"
                " real clearance is 13 to 28 µm.",
                "A aproximação elástica, {:.1f} µm, tomada por folga, e a vida lida em uma tabela"
                " com passos de ε de 0,1, como a dos fabricantes; sem a tabela, {:.1f} %. A folga"
                " real é de 13 a 28 µm.",
                elastic_deflection() / MICRO,
                100.0 * (1.0 - float(_by_the_maker(np.array([elastic_deflection()]))[1][0])),
            ),
        ),
        Number(
            "reduced_life",
            said("L_able, corrected for ε (h)", "L_able, corrigido por ε (h)"),
            given["reduced_life_h"],
            life * round(kept, 2),
            NONE,
            said(
                "0.80 of 189 h, which is none either (table C). The right factor would leave {:.0f}"
                " to {:.0f} h of them.",
                "0,80 de 189 h, que também não valem (tabela C). O fator correto deixaria {:.0f} a"
                " {:.0f} h delas.",
                *(life * value for value in reversed(new)),
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
        said(
            "The load zone's share in the life of condition I.",
            "A parte da zona de carga na vida da condição I.",
        ),
        GIVEN.source_of("load_zone"),
        load_zone_numbers(),
        notes=(
            said(
                "The reference life of ISO/TS 16281, with the catalogue's rating and the real loads"
                " of the eight balls, is {:.1f} h without clearance and {:.1f} to {:.1f} h with"
                " that of class C3; (C/P)³ has {:.1f} h.",
                "A vida de referência da ISO/TS 16281, com a capacidade de catálogo e as cargas"
                " reais das oito esferas, é {:.1f} h sem folga e {:.1f} a {:.1f} h com a da classe"
                " C3; (C/P)³ dá {:.1f} h.",
                none,
                high,
                low,
                basic_life_hours(printed("life")["dynamic_rating_N"]),
            ),
        ),
    )
