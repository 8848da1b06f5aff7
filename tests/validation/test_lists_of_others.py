"""Makers' lists that the program does not carry, read as a user's own catalogue.

SKF, General catalogue (6000 RU), full-complement cylindrical roller bearings, pages 564 to 573; KRW
Leipzig, delivery programme (2006), barrel roller bearings, pages 241 and 242.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from rolamento.catalogue.records import CatalogueBearing, records_of_csv
from rolamento.catalogue.roller_inference import inferred_rollers

LISTS = Path(__file__).parent / "lists"


def listed(name: str) -> tuple[CatalogueBearing, ...]:
    return records_of_csv((LISTS / f"{name}.csv").read_text("utf-8"), name)


@pytest.mark.parametrize(("name", "count"), [("skf_full_complement", 126), ("krw_barrel", 60)])
def test_rollers_have_both_printed_ratings(name: str, count: int) -> None:
    """C by ISO 281, or 15 % more of SKF's Explorer class, and C_0 by ISO 76."""
    found = listed(name)
    assert len(found) == count
    for one in found:
        best = inferred_rollers(one)[0]
        assert best.reproduces, one.designation
        assert one.width is not None
        assert best.effective_length < one.width, one.designation
        assert best.rating_factor in ((1.0, 1.146) if one.maker == "SKF" else (1.0,))


def test_rollers_without_a_cage_fill_the_pitch_circle() -> None:
    for one in listed("skf_full_complement"):
        assert one.is_full_complement, one.designation
        assert 0.9 < inferred_rollers(one)[0].filling <= 1.0, one.designation
