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
            head=said("without external load"),
            values=[said(STAGE_NAMES[stage.name]) for stage in stages],
            key="stage",
        ),
        Column(
            head=said("preload"),
            values=[stage.preload[1] for stage in stages],
            unit="N",
            key="preload",
            figures=4,
        ),
    ]
    if scatters:
        columns += [
            Column(
                head=head,
                values=[stage.preload[place] for stage in stages],
                unit="N",
                key=key,
                figures=4,
            )
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
                head=f"α{suffix}",
                values=[stage.contact_angle[row] for stage in stages],
                unit="°",
                key="contact_angle" if alike else f"contact_angle_{row}",
                figures=4,
            ),
            Column(
                head=f"e{suffix}",
                values=[stage.offset[row] for stage in stages],
                unit="µm",
                key="offset" if alike else f"offset_{row}",
                figures=4,
            ),
        ]
    columns += [
        Column(
            head="k_x",
            values=[stage.axial_stiffness for stage in stages],
            unit="N/µm",
            key="axial_stiffness",
            figures=4,
        ),
        Column(
            head="p",
            values=[stage.max_pressure for stage in stages],
            unit="MPa",
            key="max_pressure",
            figures=4,
        ),
    ]
    legend = said(
        "α free contact angle, e how far a row is pressed in from first contact, k_x axial"
        " stiffness, p maximum pressure"
    )
    return Table(columns=tuple(columns), key="preload", legends=(legend,), rule=True, fixed=1)


def _alike(values: Sequence[float]) -> bool:
    """Whether they are the same but for rounding; NaN are."""
    first = values[0]
    return all(
        value == first or abs(value - first) <= 1e-6 * abs(first) or value != value
        for value in values
    )
