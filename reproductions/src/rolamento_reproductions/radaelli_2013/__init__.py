"""Radaelli (2013), chapter 5 and appendix C: what is computed, part by part."""

from __future__ import annotations

from typing import Final

from rolamento_reproductions.radaelli_2013.at_rest import motion_section, static_section
from rolamento_reproductions.radaelli_2013.at_speed import axial_section, shift_section
from rolamento_reproductions.radaelli_2013.combined import (
    combined_section,
    three_loads_section,
    tilt_section,
)
from rolamento_reproductions.radaelli_2013.inputs import modulus, said
from rolamento_reproductions.radaelli_2013.tables import examples_section, radial_section
from rolamento_reproductions.record import Part, Source

_FIGURES: Final = tuple(f"figure-5.{number:02d}" for number in range(33))


SOURCE: Final = Source(
    name="radaelli-2013",
    title=said("title"),
    reference=said("reference"),
    remarks=(
        said("every_figure_and"),
        said("throughout_outer_raceway", modulus=modulus() / 1e9),
        said("table_5_2"),
    ),
    parts=(
        Part(said("at_rest"), _FIGURES[1:6], static_section),
        Part(said("speeds_and_forces_from"), _FIGURES[6:10], motion_section),
        Part(said("radial_load_at_speed"), ("figure-5.10", "table-5.3"), radial_section),
        Part(said("axial_load_at_several"), _FIGURES[11:15], axial_section),
        Part(said("combined_load_and_which"), _FIGURES[15:21], combined_section),
        Part(said("loads_along_three_axes"), _FIGURES[21:25], three_loads_section),
        Part(said("radial_displacement"), _FIGURES[25:27], shift_section),
        Part(said("tilted_inner_ring"), (*_FIGURES[27:33], "table-5.4"), tilt_section),
        Part(said("examples_harris_1991"), ("table-C.1", "table-C.2"), examples_section),
    ),
)
