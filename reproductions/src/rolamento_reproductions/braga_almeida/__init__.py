"""Braga and Almeida, relative motions: what is computed, part by part."""

from __future__ import annotations

from typing import Final

from rolamento_reproductions.braga_almeida.inputs import GIVEN, said
from rolamento_reproductions.braga_almeida.misprints import misprints_section
from rolamento_reproductions.braga_almeida.slip import inner_section, outer_section
from rolamento_reproductions.braga_almeida.speeds import orbit_section, speeds_section
from rolamento_reproductions.record import ERRATA_STEM, Part, Source

SOURCE: Final = Source(
    name="braga-almeida",
    title=said("title"),
    reference=said("reference"),
    remarks=(
        said("paper_derives_motions"),
        said(
            "bearing_is_218",
            *(
                GIVEN.inputs_of("bearing")[name]
                for name in (
                    "ball_count",
                    "ball_diameter_mm",
                    "pitch_diameter_mm",
                    "conformity",
                    "contact_angle_deg",
                )
            ),
        ),
    ),
    parts=(
        Part(
            said("speeds_cage_and_balls"),
            ("figure-2.01", "figure-2.02", "table-2.1"),
            speeds_section,
        ),
        Part(said("outer_contact"), ("figure-3.01", "figure-3.02"), outer_section),
        Part(said("inner_contact"), ("figure-4.01", "figure-4.02", "table-4.1"), inner_section),
        Part(said("orbit"), ("figure-5.01", "figure-5.02", "table-5.1"), orbit_section),
        Part(said("misprints"), (ERRATA_STEM,), misprints_section),
    ),
)
