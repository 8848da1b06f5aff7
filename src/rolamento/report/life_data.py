"""The life of one case as JSON."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Final

from rolamento.report.plain_data import json_text

if TYPE_CHECKING:
    from rolamento.life import Change, LifeSummary
    from rolamento.state import State

__all__ = ["life_json"]

SCHEMA: Final = 1


def life_json(state: State, summary: LifeSummary | None, changes: Sequence[Change] = ()) -> str:
    """Return the life of one case as one JSON object, SI units, hours, millions of revolutions."""
    return json_text(
        {
            "schema": SCHEMA,
            "kind": "life",
            "title": state.title,
            "status": asdict(state.status),
            "life": None if summary is None else summary.to_mapping(),
            "sensitivity": [
                {"change": change.name, "life_ratio": change.life_ratio, "what": change.sentence}
                for change in changes
            ],
            "notes": list(state.notes),
            "case": state.case.to_mapping(),
        }
    )
