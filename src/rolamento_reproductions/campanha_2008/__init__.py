"""Campanha (2008), every number that can be computed: what is shown, part by part."""

from __future__ import annotations

from typing import Final

from rolamento_reproductions.campanha_2008.clearance import clearance_section
from rolamento_reproductions.campanha_2008.contact import shear_section
from rolamento_reproductions.campanha_2008.film import film_section
from rolamento_reproductions.campanha_2008.inputs import GIVEN
from rolamento_reproductions.campanha_2008.life_tests import life_tests_section
from rolamento_reproductions.campanha_2008.load_zone import load_zone_section
from rolamento_reproductions.campanha_2008.overview import overview_section, slips_section
from rolamento_reproductions.campanha_2008.rating import rating_section
from rolamento_reproductions.campanha_2008.surfaces import noise_section, roughness_section
from rolamento_reproductions.record import Part, Source
from rolamento_reproductions.text import said

SOURCE: Final = Source(
    name="campanha-2008",
    title=GIVEN.title,
    reference=said(
        "Campanha (2008), master's dissertation: every number that can be computed, as printed,"
        " with its choices, and right; figures 4.1.1 to 4.1.4, 4.3.1 to 4.3.3, 4.4.1",
        "Campanha (2008), dissertação de mestrado: cada número calculável, como impresso, com suas"
        " escolhas, e correto; figuras 4.1.1 a 4.1.4, 4.3.1 a 4.3.3, 4.4.1",
    ),
    remarks=(
        said(
            "Twenty-four 6305 C3 deep-groove ball bearings were run at 2000 rpm under 10.8 kN, in"
            " two conditions of temperature (83.4 and 110 °C), and their lives compared with"
            " calculated ones. Here every number of the dissertation that can be computed stands"
            " three times: as printed; computed with the author's choices, to prove where it comes"
            " from; and as it should be, with the reason.",
            "Vinte e quatro rolamentos fixos de esferas 6305 C3 giraram a 2000 rpm sob 10,8 kN, em"
            " duas condições de temperatura (83,4 e 110 °C), e suas vidas foram comparadas com as"
            " calculadas. Aqui cada número calculável da dissertação aparece três vezes: como"
            " impresso; calculado com as escolhas do autor, para provar de onde vem; e como deve"
            " ser, com o motivo.",
        ),
        said(
            "A number that agrees below agrees with the author's choices; whether these are right"
            " is told beside it. Tables and figures with a number have that of the dissertation,"
            " tables with a letter gather numbers of its text. Annexes and drawn points were not at"
            " hand.",
            "Um número que concorda abaixo concorda com as escolhas do autor; se estas são"
            " corretas, diz-se ao lado. Tabelas e figuras com número têm o da dissertação; tabelas"
            " com letra reúnem números do texto. Os anexos e os pontos desenhados não estavam"
            " disponíveis.",
        ),
    ),
    parts=(
        Part(said("In short", "Em resumo"), ("table-A",), overview_section),
        Part(
            said("Ratings and calculated life", "Capacidades e vida calculada"),
            ("table-B", "table-2.6.2", "table-C"),
            rating_section,
        ),
        Part(
            said("Clearance and life", "Folga e vida"),
            ("figure-4.1.03", "figure-4.1.04", "table-D"),
            load_zone_section,
        ),
        Part(
            said("Life tests", "Ensaios de vida"),
            ("table-4.1.1", "figure-4.1.01", "figure-4.1.02", "table-E", "table-E.1", "table-E.2"),
            life_tests_section,
        ),
        Part(said("Noise", "Ruído"), ("table-4.1.3", "table-4.1.4"), noise_section),
        Part(
            said("How the bearings failed", "Como os rolamentos falharam"),
            ("table-F",),
            shear_section,
        ),
        Part(
            said("Clearance and wear", "Folga e desgaste"),
            ("table-3.2", "table-G", "figure-4.3.01", "figure-4.3.02", "figure-4.3.03"),
            clearance_section,
        ),
        Part(
            said("Oil, film and film parameter", "Óleo, filme e parâmetro de filme"),
            ("table-H", "table-I", "table-J"),
            film_section,
        ),
        Part(
            said("Roughness and temperature", "Rugosidade e temperatura"),
            ("table-4.4.1", "figure-4.4.01"),
            roughness_section,
        ),
        Part(said("Slips of the text", "Lapsos do texto"), ("table-K",), slips_section),
    ),
)
