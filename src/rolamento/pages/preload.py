"""What becomes of the preload of a mounted set: a table of its stages."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from rolamento.document import Column, Table
from rolamento.solved import PreloadStage
from rolamento.words import marked, said

__all__ = ["STAGE_NAMES", "stage_table"]

STAGE_NAMES: Final = {
    "unmounted": marked("before mounting"),
    "mounted": marked("mounted"),
    "warm": marked("warm"),
    "rings_grown": marked("rings grown at speed"),
    "at_speed": marked("at speed"),
}
"""Headings of `PreloadStage.name`."""


def stage_table(stages: Sequence[PreloadStage]) -> Table:
    """Return a line for each stage; of rows that differ the first one's angle and offset."""
    alike = all(_alike(stage.offset) and _alike(stage.contact_angle) for stage in stages)
    scatters = any(not _alike(stage.preload) for stage in stages)
    columns = [
        Column(
            said("without external load"),
            [said(STAGE_NAMES[stage.name]) for stage in stages],
            "stage",
        ),
        Column(said("preload"), [stage.preload[1] for stage in stages], "preload", "N", figures=4),
    ]
    if scatters:
        columns += [
            Column(head, [stage.preload[place] for stage in stages], key, "N", figures=4)
            for head, key, place in (
                (said("loosest"), "loosest", 0),
                (said("tightest"), "tightest", 2),
            )
        ]
    rows = range(1 if alike else len(stages[0].offset))
    for row in rows:
        suffix = "" if alike else f" {row}"
        columns += [
            Column(
                f"α{suffix}",
                [stage.contact_angle[row] for stage in stages],
                "contact_angle" if alike else f"contact_angle_{row}",
                "°",
                figures=4,
            ),
            Column(
                f"e{suffix}",
                [stage.offset[row] for stage in stages],
                "offset" if alike else f"offset_{row}",
                "µm",
                figures=4,
            ),
        ]
    columns += [
        Column(
            "k_x", [stage.axial_stiffness for stage in stages], "axial_stiffness", "N/µm", figures=4
        ),
        Column("p", [stage.max_pressure for stage in stages], "max_pressure", "MPa", figures=4),
    ]
    legend = said(
        "α free contact angle, e how far a row is pressed in from first contact, k_x axial"
        " stiffness, p maximum pressure"
    )
    return Table(tuple(columns), "preload", legends=(legend,), rule=True, fixed=1)


def _alike(values: Sequence[float]) -> bool:
    """Whether they are the same but for rounding; NaN are."""
    first = values[0]
    return all(
        value == first or abs(value - first) <= 1e-6 * abs(first) or value != value
        for value in values
    )
