"""Makers' lists that the program does not carry, read as a user's own catalogue.

KRW Leipzig, delivery programme (2006), barrel roller bearings, pages 241 and 242.
"""

from __future__ import annotations

from pathlib import Path

from rolamento.catalogue.records import CatalogueBearing, records_of_csv
from rolamento.catalogue.roller_inference import inferred_rollers

LISTS = Path(__file__).parent / "lists"


def listed(name: str) -> tuple[CatalogueBearing, ...]:
    return records_of_csv((LISTS / f"{name}.csv").read_text("utf-8"), name)


def test_rollers_have_both_printed_ratings() -> None:
    """C by ISO 281, and C_0 by ISO 76."""
    found = listed("krw_barrel")
    assert len(found) == 60
    for one in found:
        best = inferred_rollers(one)[0]
        assert best.reproduces, one.designation
        assert one.width is not None
        assert best.effective_length < one.width, one.designation
        assert best.rating_factor == 1.0
