"""Oil and contact as chapter 4.4.3 has them, and the maximum shear: chapters 2.5 and 4.2."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from rolamento.contact.hertz import HertzContact, effective_modulus, elliptical_contact
from rolamento.contact.subsurface import maximum_shear
from rolamento.geometry import Race, race_curvature
from rolamento.life.iso16281 import race_ratings, reference_life
from rolamento.lubrication.regime import crack_origin
from rolamento.static import RadialSolution, radial_load
from rolamento.units import MILLIMETRE
from rolamento.verification import Check
from rolamento.verification.campanha_2008 import LINE_CONTACT_DEPTH, STRIBECK
from rolamento_reproductions.campanha_2008.inputs import (
    GIVEN,
    Number,
    ball_diameter,
    bearing,
    clearances_of_class,
    contact_at,
    film_checks,
    load,
    numbers_table,
    oil_at,
    outer_conformity,
    printed,
    speed,
    steel_of_film,
    temperature,
)
from rolamento_reproductions.record import Claim, Section, Table
from rolamento_reproductions.text import Text, said, same

_MILLI = 1e-3


def check_of(quantity: str, condition: str = "") -> Check:
    """Return a verified number by its name, of a condition of the tests if it depends on it."""
    found = [
        check
        for check in film_checks()
        if check.quantity == quantity
        and check.source.endswith(f"condition {condition}" if condition else "")
    ]
    assert len(found) == 1, quantity
    return found[0]


def contact_table() -> Table:
    """Return the numbers of oil and contact."""
    return numbers_table(
        "H",
        said(
            "Oil and inner contact of the film's calculation.",
            "Óleo e contato interno do cálculo do filme.",
        ),
        GIVEN.source_of("contact"),
        contact_numbers(),
    )


@cache
def contact_numbers() -> tuple[Number, ...]:
    """Return the printed numbers of oil and contact."""
    return (*_oil(), *_radii(), *_ellipse(), *_motion())


# --- oil --------------------------------------------------------------------


def _oil() -> tuple[Number, ...]:
    index = check_of("viscosity index")
    warm, hot = check_of("ν, 83.4 °C"), check_of("ν, 110 °C")
    return (
        Number(
            "viscosity_index",
            said("viscosity index", "índice de viscosidade"),
            index.printed,
            index.computed,
            index.computed,
            said(
                "From the two printed viscosities, by ISO 2909.",
                "Das duas viscosidades impressas, pela ISO 2909.",
            ),
        ),
        Number(
            "viscosity_I",
            said("ν, condition I (mm²/s)", "ν, condição I (mm²/s)"),
            warm.printed,
            evidence(warm),
            warm.computed,
            said(
                "The oil's line (ASTM D341) has the printed viscosity at {:.1f} °C; the text's mean"
                " temperature is {:.1f} °C.",
                "A reta do óleo (ASTM D341) tem a viscosidade impressa a {:.1f} °C; a temperatura"
                " média do texto é {:.1f} °C.",
                temperature_of_print(),
                temperature("I"),
            ),
        ),
        Number(
            "viscosity_II",
            said("ν, condition II (mm²/s)", "ν, condição II (mm²/s)"),
            hot.printed,
            hot.computed,
            hot.computed,
            said("The same line at 110 °C.", "A mesma reta a 110 °C."),
        ),
        *(_dynamic(row) for row in GIVEN.inputs_of("contact")["viscosity"]),
        *(_coefficient(condition) for condition in ("I", "II")),
    )


def temperature_of_print() -> float:
    """Return the temperature at which the oil has the viscosity printed for condition I; °C."""
    return float(printed("oil_in_operation")[0]["temperature_of_print_degC"])


def _dynamic(row: dict[str, Any]) -> Number:
    given, condition = GIVEN.inputs_of("contact"), row["condition"]
    oil = oil_at(temperature(condition))
    cut = said(" Printed with its digits cut.", " Impresso com os dígitos cortados.")
    lighter = said(
        "The density is that of 20 °C; at {:.1f} °C the oil has {:.3f} g/cm³.{}",
        "A densidade é a de 20 °C; a {:.1f} °C o óleo tem {:.3f} g/cm³.{}",
        temperature(condition),
        float(oil.density) * _MILLI,
        cut if condition == "II" else same(""),
    )
    return Number(
        f"dynamic_{condition}",
        said("η_0, condition {} (mPa·s)", "η_0, condição {} (mPa·s)", condition),
        row["dynamic_mPa_s"],
        given["viscosities_mm2_s"][condition] * given["density_g_cm3"],
        float(oil.dynamic_viscosity) / _MILLI,
        lighter,
        cut=condition == "II",
    )


def _coefficient(condition: str) -> Number:
    check = check_of("α", condition)
    return Number(
        f"coefficient_{condition}",
        said("α, condition {} (10⁻⁸/Pa)", "α, condição {} (10⁻⁸/Pa)", condition),
        check.printed,
        check.computed,
        float(oil_at(temperature(condition)).pressure_viscosity) * 1e8,
        said(
            "Wooster's correlation; right with the viscosity above. Measured values of mineral oils"
            " differ from it by some 10 %.",
            "Correlação de Wooster; correto com a viscosidade acima. Valores medidos de óleos"
            " minerais diferem dela em cerca de 10 %.",
        ),
    )


# --- radii ------------------------------------------------------------------


def _radii() -> tuple[Number, ...]:
    given, rings = GIVEN.inputs_of("contact"), printed("bearing_6305")
    ball, pitch = rings["ball_diameter_mm"], rings["pitch_diameter_mm"]
    groove = printed("life")["measured_conformity"] * ball
    rolling, across = curvatures()
    of_ball, of_ring, of_groove = (
        float(given[name]) for name in ("ball_radius_mm", "inner_radius_mm", "groove_radius_mm")
    )
    return (
        Number(
            "ball_radius",
            said("R_ax, R_ay, ball (mm)", "R_ax, R_ay, esfera (mm)"),
            given["ball_radius_mm"],
            0.5 * ball,
            0.5 * ball,
            same("D_w/2."),
        ),
        Number(
            "ring_radius",
            said("R_bx, inner race (mm)", "R_bx, pista interna (mm)"),
            given["inner_radius_mm"],
            0.5 * (pitch - ball),
            0.5 * (pitch - ball),
            said("(D_pw − D_w)/2, convex.", "(D_pw − D_w)/2, convexo."),
        ),
        Number(
            "groove_radius",
            said("R_by, groove (mm)", "R_by, canal (mm)"),
            given["groove_radius_mm"],
            groove,
            groove,
            said("0.505 D_w; it is hollow.", "0,505 D_w; é côncavo."),
        ),
        Number(
            "rolling_radius",
            said("R_x, along rolling (mm)", "R_x, na direção de rolagem (mm)"),
            given["rolling_radius_mm"],
            1.0 / (1.0 / of_ball + 1.0 / of_ring),
            1.0 / (rolling * MILLIMETRE),
            said(
                "Both bodies are convex along rolling.",
                "Na direção de rolagem os dois são convexos.",
            ),
        ),
        Number(
            "across_radius",
            said("R_y, across (mm)", "R_y, transversal (mm)"),
            given["across_radius_mm"],
            1.0 / (1.0 / of_ball + 1.0 / of_groove),
            same("{:.0f}", 1.0 / (across * MILLIMETRE)),
            said(
                "Eq. 2.3.1 gives a hollow body a minus; the dissertation adds the groove's"
                " curvature as if it were convex.",
                "A eq. 2.3.1 dá sinal negativo ao corpo côncavo; a dissertação soma a curvatura do"
                " canal como se fosse convexo.",
            ),
        ),
    )


def curvatures(race: Race = "inner") -> tuple[float, float]:
    """1/R_x and 1/R_y of a contact, with the inner groove as the film takes it; 1/m."""
    rings, film = printed("bearing_6305"), printed("film")
    inner = film["groove_radius_mm"] / rings["ball_diameter_mm"]
    curvature = race_curvature(
        rings["ball_diameter_mm"] * MILLIMETRE,
        rings["pitch_diameter_mm"] * MILLIMETRE,
        inner if race == "inner" else outer_conformity(),
        0.0,
        race,
    )
    return float(curvature.rolling), float(curvature.across)


def _ellipse() -> tuple[Number, ...]:
    rolling, across = curvatures()
    radius, ratio = check_of("R, convex"), check_of("k, convex")
    steel = steel_of_film()
    modulus = effective_modulus(steel, steel)
    contact = elliptical_contact(printed("film")["load_N"], rolling, across, modulus)
    return (
        Number(
            "reduced_radius",
            same("R′ (mm)"),
            radius.printed,
            radius.computed,
            1.0 / ((rolling + across) * MILLIMETRE),
            said(
                "Of all curvatures, the groove taken for convex. The film's formula wants R_x in"
                " its place.",
                "De todas as curvaturas, o canal tomado por convexo. A fórmula do filme pede R_x em"
                " seu lugar.",
            ),
        ),
        Number(
            "ellipticity",
            same("k"),
            ratio.printed,
            ratio.computed,
            same("{:.1f}", float(contact.ellipticity)),
            said(
                "Eq. 2.4.9 with the convex groove, and x and y exchanged because R_x > R_y then."
                " But x is the direction of rolling: nothing may be exchanged.",
                "Eq. 2.4.9 com o canal convexo, e x e y trocados porque então R_x > R_y. Mas x é a"
                " direção de rolagem: nada se troca.",
            ),
        ),
        Number(
            "modulus",
            same("E′ (MPa)"),
            GIVEN.inputs_of("contact")["modulus_MPa"],
            modulus / 1e6,
            modulus / 1e6,
            said("Eq. 2.3.9 with 208 GPa and 0.3.", "Eq. 2.3.9 com 208 GPa e 0,3."),
        ),
    )


# --- load and speed ---------------------------------------------------------


def _motion() -> tuple[Number, ...]:
    check = check_of("U")
    heaviest = [
        float(radial_load(bearing(clearance), load(), distribution="discrete").max_ball_load)
        for clearance in clearances_of_class()
    ]
    return (
        Number(
            "ball_load",
            same("W (N)"),
            GIVEN.inputs_of("contact")["ball_load_N"],
            STRIBECK * load() / printed("bearing_6305")["ball_count"],
            said("{:,.0f} to {:,.0f}", "{:,.0f} a {:,.0f}", *heaviest),
            said(
                "Stribeck's 5 F_r/Z. By the equilibrium of the eight balls, with one under the load"
                " and the clearance of a new C3. The film hardly feels it.",
                "5 F_r/Z, de Stribeck. Correto: equilíbrio das oito esferas, uma sob a carga, com a"
                " folga de um C3 novo. O filme quase não o sente.",
            ),
        ),
        Number(
            "speed",
            same("U (mm/s)"),
            check.printed,
            _printed_speed(),
            check.computed,
            said(
                "Eq. 4.4.3 adds the speeds of ring and ball; eq. 2.4.8 wants their mean. With φ"
                " rounded to 0.232 the printed sum comes out.",
                "A eq. 4.4.3 soma as velocidades do anel e da esfera; a eq. 2.4.8 pede a média. Com"
                " φ arredondado a 0,232 sai a soma impressa.",
            ),
        ),
    )


def _printed_speed() -> float:
    """U by eq. 4.4.3, φ rounded as printed; mm/s."""
    rings, phi = printed("bearing_6305"), GIVEN.inputs_of("contact")["rounded_gamma"]
    cage = 0.5 * speed() * (1.0 - phi)
    ball = 0.5 * speed() * rings["pitch_diameter_mm"] / rings["ball_diameter_mm"] * (1.0 - phi**2)
    radius = 0.5 * rings["pitch_diameter_mm"]
    return float(radius * ((1.0 - phi) * (speed() - cage) + phi * ball))


def evidence(check: Check) -> float:
    """Return what the program gives with the author's choice."""
    return np.nan if check.evidence is None else check.evidence


def shear_section(title: Text) -> Section:
    """Compute the depth, and judge the failures by it."""
    table = numbers_table(
        "F",
        said(
            "Depth of the maximum shear stress under the heaviest ball of the 6305.",
            "Profundidade da máxima tensão de cisalhamento sob a esfera mais carregada do 6305.",
        ),
        GIVEN.source_of("shear"),
        shear_numbers(),
        claims=(_subsurface(), _surface(), _inner_ring()),
    )
    return Section(title, (table,))


@cache
def _heaviest() -> tuple[RadialSolution, RadialSolution]:
    """The new bearing with its minimum and its maximum clearance, a ball under the load."""
    low, high = (
        radial_load(bearing(clearance), load(), distribution="discrete")
        for clearance in clearances_of_class()
    )
    return low, high


def _contacts(inner_conformity: float) -> list[HertzContact]:
    """Inner contacts of the heaviest ball with both clearances."""
    return [
        contact_at(float(state.max_ball_load), inner_conformity, "inner") for state in _heaviest()
    ]


def _measured() -> float:
    return float(printed("life")["measured_conformity"])


def _nominal() -> float:
    return float(GIVEN.inputs_of("ratings")["nominal_conformity"])


def _depths(inner_conformity: float) -> list[float]:
    """Depth of the maximum shear; mm."""
    poisson = printed("bearing_6305")["poisson_ratio"]
    return [
        float(maximum_shear(c.max_pressure, c.semi_major, c.semi_minor, poisson).depth) / MILLIMETRE
        for c in _contacts(inner_conformity)
    ]


@cache
def shear_numbers() -> tuple[Number, ...]:
    """Return the printed depth."""
    whole = contact_at(load(), _nominal(), "inner")
    contact = _contacts(_measured())[0]
    share = _depths(_measured())[0] * MILLIMETRE / float(contact.semi_minor)
    return (
        Number(
            "depth",
            said("z of the maximum shear (mm)", "z da máxima tensão de cisalhamento (mm)"),
            printed("shear_depth")["greatest_shear_depth_mm"],
            LINE_CONTACT_DEPTH * float(whole.semi_minor) / MILLIMETRE,
            said("{:.3f} to {:.3f}", "{:.3f} a {:.3f}", *_depths(_measured())),
            said(
                "The whole load on one ball, the catalogue's groove of 0.52, and 0.5 b of a line"
                " contact; or b itself under F_r/8, which is the same number. The heaviest ball"
                " carries {:.1f} to {:.1f} kN, the groove has 0.505, and the shear peaks at {:.2f}"
                " b: the choices cancel. With 0.52 it would be {:.3f} to {:.3f} mm.",
                "A carga toda em uma esfera, o canal de catálogo, 0,52, e 0,5 b de um contato"
                " linear; ou o próprio b sob F_r/8, que dá o mesmo número. A esfera mais carregada"
                " leva {:.1f} a {:.1f} kN, o canal tem 0,505, e a tensão é máxima em {:.2f} b: as"
                " escolhas se compensam. Com 0,52 seriam {:.3f} a {:.3f} mm.",
                *(float(state.max_ball_load) / 1e3 for state in _heaviest()),
                share,
                *_depths(_nominal()),
            ),
        ),
    )


def _subsurface() -> Claim:
    depth = float(np.mean(_depths(_measured())))
    lost = GIVEN.inputs_of("shear")["lost_metal_mm"]
    origins = {crack_origin(value * MILLIMETRE, depth * MILLIMETRE) for value in lost}
    return Claim(
        said(
            "Bearing 1 lost metal to a depth of 0.1 to 0.2 mm: fatigue from beneath the surface.",
            "O rolamento 1 perdeu material até 0,1 a 0,2 mm: fadiga sub-superficial.",
        ),
        said(
            "{:.1f} to {:.1f} times the depth of the maximum shear; 0.5 to 1.5 times is beneath"
            " the surface.",
            "{:.1f} a {:.1f} vezes a profundidade da máxima tensão; de 0,5 a 1,5 vez é"
            " sub-superficial.",
            *(value / depth for value in lost),
        ),
        origins == {"subsurface"},
    )


def _surface() -> Claim:
    given = GIVEN.inputs_of("shear")
    depth = float(np.mean(_depths(_measured())))
    cracks = [given["crack_share"] * value for value in given["lost_metal_mm"]]
    origins = {crack_origin(value * MILLIMETRE, depth * MILLIMETRE) for value in cracks}
    return Claim(
        said(
            "The cracks of bearing 22 are an order of magnitude less deep: fatigue from the"
            " surface.",
            "As trincas do rolamento 22 são uma ordem de grandeza menos profundas: fadiga"
            " superficial.",
        ),
        said(
            "Some {:.2f} to {:.2f} times the depth of the maximum shear; up to 0.2 times is from"
            " the surface.",
            "Cerca de {:.2f} a {:.2f} vezes a profundidade da máxima tensão; até 0,2 vez é"
            " superficial.",
            *(value / depth for value in cracks),
        ),
        origins == {"surface"},
    )


def _inner_ring() -> Claim:
    state = _heaviest()[0]
    heaviest = float(state.max_ball_load)
    inner = float(contact_at(heaviest, _measured(), "inner").max_pressure) / 1e9
    outer = float(contact_at(heaviest, outer_conformity(), "outer").max_pressure) / 1e9
    nominal = float(contact_at(heaviest, _nominal(), "inner").max_pressure) / 1e9
    lives = _race_lives(state)
    return Claim(
        said(
            "Fatigue starts at the inner ring, the part with the maximum load and stress.",
            "A fadiga se origina no anel interno, o componente com maior carga e tensão.",
        ),
        said(
            "So with the catalogue's grooves: {:.2f} GPa inside, {:.2f} outside. With the measured"
            " inner groove it has {:.2f} GPa, less than the outer race, and by its rating it lives"
            " {:.2f} times as long as that: theory then expects failures of both. That five of six"
            " came from the inner ring points to its surface, or to an outer groove closer than"
            " 0.53.",
            "Assim é com os canais de catálogo: {:.2f} GPa na interna, {:.2f} na externa. Com o"
            " canal interno medido são {:.2f} GPa, menos que na externa, e por sua capacidade ela"
            " vive {:.2f} vezes o que vive esta: a teoria então espera falhas de ambas. Que cinco"
            " de seis tenham vindo do anel interno aponta para sua superfície, ou para um canal"
            " externo mais fechado que 0,53.",
            nominal,
            outer,
            inner,
            lives[0] / lives[1],
        ),
        holds=False,
        partly=inner < outer < nominal,
    )


def _race_lives(state: RadialSolution) -> tuple[float, float]:
    """Lives of both races with the grooves as measured; 10^6 rev."""
    rings = printed("bearing_6305")
    ratings = race_ratings(
        printed("life")["dynamic_rating_N"],
        rings["ball_count"],
        ball_diameter(),
        rings["pitch_diameter_mm"] * MILLIMETRE,
        _measured(),
        outer_conformity(),
        0.0,
    )
    loads = state.ball_loads[np.newaxis]
    found = reference_life(loads, loads, ratings)
    return float(found.inner[0, 0]), float(found.outer[0, 0])
