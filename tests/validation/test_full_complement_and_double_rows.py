"""Cylindrical roller bearings without a cage (SKF) and of two rows (NSK), by their printed ratings.

SKF, General catalogue (6000 RU), pages 564 to 573; NSK, Rolling Bearings (E1102e), B102 to B105.
"""

from __future__ import annotations

import numpy as np
import pytest

from rolamento import Case, Duty, InputError, Load, RollerBearing, solve
from rolamento.case import parse_case
from rolamento.catalogue import geometry_of
from rolamento.catalogue.records import CatalogueBearing
from rolamento.catalogue.roller_inference import inferred_rollers, roller_diameters
from rolamento.catalogue.search import built_in_catalogue


def listed(kind: str) -> tuple[CatalogueBearing, ...]:
    return tuple(one for one in built_in_catalogue().bearings if one.kind == kind)


FULL = listed("full_complement")
DOUBLE = listed("double_row_cylindrical")


def test_lists_are_whole() -> None:
    assert len(FULL) == 126
    assert sum(one.designation.startswith("NJG") for one in FULL) == 25
    assert sum(one.designation.startswith("NNU ") for one in DOUBLE) == 18
    assert len(DOUBLE) == 53


@pytest.mark.parametrize("one", FULL, ids=lambda one: one.designation)
def test_rollers_without_a_cage_fill_the_pitch_circle(one: CatalogueBearing) -> None:
    """C by ISO 281, or 15 % more of SKF's Explorer class, and C_0 by ISO 76."""
    best = inferred_rollers(one)[0]
    assert one.is_full_complement
    assert best.reproduces
    assert best.rating_factor in (1.0, 1.146)
    assert best.filling == pytest.approx(0.97, abs=0.04)
    assert best.filling <= 1.0


@pytest.mark.parametrize("one", DOUBLE, ids=lambda one: one.designation)
def test_two_rows_have_both_ratings_of_the_bearing(one: CatalogueBearing) -> None:
    """With i = 2, standard rollers give both ratings within 1.2 %, and fit into half the width."""
    best = inferred_rollers(one)[0]
    assert best.dynamic_error == pytest.approx(0.0, abs=0.012)
    assert best.static_error == pytest.approx(0.0, abs=1e-6)
    assert np.min(np.abs(roller_diameters() - best.roller_diameter)) < 1e-9
    assert one.width is not None
    assert 0.49 < best.effective_length / (0.5 * one.width) < 0.71
    assert 0.73 < best.filling < 0.85


@pytest.mark.parametrize(
    ("name", "inner", "outer", "rows"),
    [
        ("NN 3020", "both", "none", 2),
        ("NNU 4926 K", "none", "both", 2),
        ("NCF 2912 CV", "both", "+", 1),
        ("NJG 2309 VH/C3", "-", "both", 1),
    ],
)
def test_ribs_and_rows(name: str, inner: str, outer: str, rows: int) -> None:
    bearing = RollerBearing.named(name)
    assert (bearing.inner_ribs, bearing.outer_ribs) == (inner, outer)
    assert len(bearing.places) == bearing.listed_type.rows == rows
    assert bearing.rows_of_one_bearing == rows


@pytest.mark.parametrize(
    ("name", "clearance_class", "clearance"),
    [
        ("NN 3020", "CN", 67.5), ("NN 3020 K", "CC", 92.5), ("NN 3020 K CC1", "CC1", 35.0),
        ("NNU 4926 K/SP", "CC", 120.0), ("NN3020TBKRCC0P4", "CC0", 27.5),
        ("NCF 2912 CV", "CN", 55.0),
    ],
)  # fmt: skip
def test_a_tapered_bore_has_its_own_classes(
    name: str, clearance_class: str, clearance: float
) -> None:
    """µm; ISO 5753-1 of cylindrical bores, JIS B 1520 (NSK, table 9.14) of tapered ones."""
    found = geometry_of(name)
    assert found.clearance_class == clearance_class
    assert 1e6 * found.fields["diametral_clearance"] == pytest.approx(clearance)


def test_two_rows_share_a_radial_load() -> None:
    solved = solve(Case(bearing=RollerBearing.named("NN 3020"), duty=Duty(load=Load(fz=5000.0))))
    assert solved.status.converged
    loads = np.add.reduceat(solved.loaded.astype(np.int64), solved.rows.starts, axis=-1)
    assert loads.tolist()[0][0] == loads.tolist()[0][1]


def test_a_taper_takes_no_fit() -> None:
    """The class is of the tapered bore, and shaft tolerances are of cylindrical seats."""
    text = '[bearing]\ndesignation = "{}"\n[duty.load]\nfz = "5 kN"\n[mounting]\n'
    text += 'shaft_tolerance = "k5"\nhousing_tolerance = "H7"'
    assert parse_case(text.format("NN 3020")).mounting is not None
    with pytest.raises(InputError, match="tapered bore"):
        parse_case(text.format("NN 3020 K"))
