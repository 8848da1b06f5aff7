"""Ricci and Fleury, friction in ball bearings: what is computed, part by part."""

from __future__ import annotations

from typing import Final

from rolamento_reproductions.record import ERRATA_STEM, Part, Source
from rolamento_reproductions.ricci_fleury.inputs import GIVEN, said
from rolamento_reproductions.ricci_fleury.misprints import misprints_section
from rolamento_reproductions.ricci_fleury.spin import spin_section
from rolamento_reproductions.ricci_fleury.torque import torque_section

SOURCE: Final = Source(
    name="ricci-fleury",
    title=said("title"),
    reference=said("reference"),
    remarks=(
        said("every_figure_and"),
        said(
            "bearing_mm_bore",
            *(
                GIVEN.inputs_of("bearing")[name]
                for name in (
                    "bore_mm",
                    "outside_mm",
                    "ball_diameter_mm",
                    "conformity",
                    "contact_angle_deg",
                )
            ),
        ),
    ),
    parts=(
        Part(said("torque_at_low_speed"), ("figure-08", "table-8"), torque_section),
        Part(said("spin_and_roll_at"), ("figure-09",), spin_section),
        Part(said("misprints"), (ERRATA_STEM,), misprints_section),
    ),
)
