"""Campanha (2008), every number that can be computed: what is shown, part by part."""

from __future__ import annotations

from typing import Final

from rolamento_reproductions.campanha_2008.clearance import clearance_section
from rolamento_reproductions.campanha_2008.contact import shear_section
from rolamento_reproductions.campanha_2008.film import film_section
from rolamento_reproductions.campanha_2008.inputs import said
from rolamento_reproductions.campanha_2008.life_tests import life_tests_section
from rolamento_reproductions.campanha_2008.load_zone import load_zone_section
from rolamento_reproductions.campanha_2008.overview import overview_section, slips_section
from rolamento_reproductions.campanha_2008.rating import rating_section
from rolamento_reproductions.campanha_2008.surfaces import noise_section, roughness_section
from rolamento_reproductions.record import Part, Source

SOURCE: Final = Source(
    name="campanha-2008",
    title=said("title"),
    reference=said("reference"),
    remarks=(said("twenty_four_6305"), said("number_that_agrees")),
    parts=(
        Part(said("in_short"), ("table-A",), overview_section),
        Part(
            said("ratings_and_calculated_life"),
            ("table-B", "table-2.6.2", "table-C"),
            rating_section,
        ),
        Part(
            said("clearance_and_life"),
            ("figure-4.1.03", "figure-4.1.04", "table-D"),
            load_zone_section,
        ),
        Part(
            said("life_tests"),
            ("table-4.1.1", "figure-4.1.01", "figure-4.1.02", "table-E", "table-E.1", "table-E.2"),
            life_tests_section,
        ),
        Part(said("noise"), ("table-4.1.3", "table-4.1.4"), noise_section),
        Part(said("how_bearings_failed"), ("table-F",), shear_section),
        Part(
            said("clearance_and_wear"),
            ("table-3.2", "table-G", "figure-4.3.01", "figure-4.3.02", "figure-4.3.03"),
            clearance_section,
        ),
        Part(said("oil_film_and_film"), ("table-H", "table-I", "table-J"), film_section),
        Part(
            said("roughness_and_temperature"), ("table-4.4.1", "figure-4.4.01"), roughness_section
        ),
        Part(said("slips_text"), ("table-K",), slips_section),
    ),
)
