"""Depth of the greatest shear, and how the bearings failed: chapters 2.5 and 4.2."""

from __future__ import annotations

from functools import cache

import numpy as np

from rolamento.contact.hertz import HertzContact
from rolamento.contact.subsurface import greatest_shear
from rolamento.life.iso16281 import race_ratings, reference_life
from rolamento.lubrication.regime import crack_origin
from rolamento.static import RadialSolution, radial_load
from rolamento.verification.campanha_2008 import LINE_CONTACT_DEPTH
from rolamento.verification.published import MM
from rolamento_reproductions.campanha_2008.inputs import (
    GIVEN,
    ball_diameter,
    bearing,
    clearances_of_class,
    contact_at,
    load,
    outer_conformity,
    printed,
)
from rolamento_reproductions.campanha_2008.numbers import Number, numbers_table
from rolamento_reproductions.record import Claim, Section
from rolamento_reproductions.text import Text, said

__all__ = ["shear_numbers", "shear_section"]


def shear_section(title: Text) -> Section:
    """Compute the depth, and judge the failures by it."""
    table = numbers_table(
        "F",
        said(
            "Depth of the greatest shear stress under the heaviest ball of the 6305.",
            "Profundidade da máxima tensão de cisalhamento sob a esfera mais carregada do 6305.",
        ),
        GIVEN.source_of("shear"),
        shear_numbers(),
        claims=(_subsurface(), _surface(), _inner_ring()),
    )
    return Section(title, (table,))


@cache
def _heaviest() -> tuple[RadialSolution, RadialSolution]:
    """The new bearing with its least and its greatest clearance, a ball under the load."""
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
    """Depth of the greatest shear; mm."""
    poisson = printed("bearing_6305")["poisson_ratio"]
    return [
        float(greatest_shear(c.max_pressure, c.semi_major, c.semi_minor, poisson).depth) / MM
        for c in _contacts(inner_conformity)
    ]


@cache
def shear_numbers() -> tuple[Number, ...]:
    """Return the printed depth."""
    whole = contact_at(load(), _nominal(), "inner")
    contact = _contacts(_measured())[0]
    share = _depths(_measured())[0] * MM / float(contact.semi_minor)
    return (
        Number(
            "depth",
            said("z of the greatest shear (mm)", "z da máxima tensão de cisalhamento (mm)"),
            printed("shear_depth")["greatest_shear_depth_mm"],
            LINE_CONTACT_DEPTH * float(whole.semi_minor) / MM,
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
    origins = {crack_origin(value * MM, depth * MM) for value in lost}
    return Claim(
        said(
            "Bearing 1 lost metal to a depth of 0.1 to 0.2 mm: fatigue from beneath the surface.",
            "O rolamento 1 perdeu material até 0,1 a 0,2 mm: fadiga sub-superficial.",
        ),
        said(
            "{:.1f} to {:.1f} times the depth of the greatest shear; 0.5 to 1.5 times is beneath"
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
    origins = {crack_origin(value * MM, depth * MM) for value in cracks}
    return Claim(
        said(
            "The cracks of bearing 22 are an order of magnitude less deep: fatigue from the"
            " surface.",
            "As trincas do rolamento 22 são uma ordem de grandeza menos profundas: fadiga"
            " superficial.",
        ),
        said(
            "Some {:.2f} to {:.2f} times the depth of the greatest shear; up to 0.2 times is from"
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
            "Fatigue starts at the inner ring, the part with the greatest load and stress.",
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
        rings["pitch_diameter_mm"] * MM,
        _measured(),
        outer_conformity(),
        0.0,
    )
    loads = state.ball_loads[np.newaxis]
    found = reference_life(loads, loads, ratings)
    return float(found.inner[0, 0]), float(found.outer[0, 0])
