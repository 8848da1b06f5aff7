"""What `solve` takes as arrays: names, shapes, rivals, what follows what."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from rolamento import (
    Bearing,
    Case,
    Duty,
    InputError,
    Load,
    UnknownKeyError,
    solve,
)
from rolamento.case.fields import field_of, fields_of
from rolamento.case.varied import SHORT_NAMES, batch_fields, bounded, varied_arrays
from rolamento.system.preload import preload_of

ANGULAR: dict[str, Any] = {
    "ball_count": 16,
    "ball_diameter": "22.23 mm",
    "pitch_diameter": "125.26 mm",
    "contact_angle": "40 deg",
    "inner_conformity": 0.5232,
    "outer_conformity": 0.5232,
}
DUTY = Duty(load=Load(fx=4e3))
PLAIN = Case(bearing=Bearing(**ANGULAR), duty=DUTY)
PAIR = Case(
    bearing=Bearing(**ANGULAR, arrangement="DB", spacing="40 mm", preload="2 kN"), duty=DUTY
)


@pytest.fixture(scope="module", autouse=True)
def _compiled() -> None:
    """Load the compiled kernels first: few cases alone would run as plain Python, slowly."""
    solve(PLAIN, fx=np.full(100, 1e4), inner_speed=100.0)


# --- names and shapes ------------------------------------------------------------------------


def test_fields_are_listed_by_their_dotted_names() -> None:
    names = batch_fields()
    assert len(set(names)) == len(names)
    assert set(SHORT_NAMES.values()) <= set(names)
    assert {"bearing.spacing", "bearing.preload.spring", "bearing.ball_material.density"} <= set(
        names
    )


def test_dotted_and_short_names_are_the_same() -> None:
    by_name = solve(PLAIN, {"duty.load.fz": [1e3, 2e3], "duty.inner_speed": 100.0})
    by_keyword = solve(PLAIN, fz=[1e3, 2e3], inner_speed=100.0)
    assert np.array_equal(by_name.displacement.array, by_keyword.displacement.array)
    short = solve(PLAIN, {"fz": [1e3, 2e3]}, inner_speed=100.0)
    assert np.array_equal(short.displacement.array, by_keyword.displacement.array)


def test_scalars_stand_beside_arrays() -> None:
    batch = solve(
        PLAIN, {"bearing.contact_angle": 0.5, "bearing.inner_conformity": [0.52, 0.53]}, fx=3e3
    )
    both = solve(
        PLAIN,
        {"bearing.contact_angle": [0.5, 0.5], "bearing.inner_conformity": [0.52, 0.53]},
        fx=[3e3, 3e3],
    )
    assert len(batch) == 2
    assert np.array_equal(batch.displacement.array, both.displacement.array)
    assert len(solve(PLAIN, {"bearing.contact_angle": 0.5})) == 1
    assert len(solve(PLAIN)) == 1


@pytest.mark.parametrize("case", [PLAIN, PAIR], ids=["plain", "pair"])
@pytest.mark.parametrize("control", ["outer", "jones"])
def test_no_values_are_no_cases(case: Case, control: Any) -> None:
    case = case.replace(model=case.model.replace(raceway_control=control))
    for values in ({"bearing.contact_angle": []}, {"duty.load.fz": np.zeros(0)}):
        batch = solve(case, values, inner_speed=100.0)
        rows = len(case.bearing.places)
        assert len(batch) == 0
        assert batch.displacement.array.shape == (0, 5)
        assert batch.stiffness.array.shape == (0, 5, 5)
        assert batch.inner.load.shape == (0, 16 * rows)
        assert len(batch.rows) == rows
        assert batch.status.code.shape == (0,)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"duty.load.fz": [1.0, 2.0], "duty.load.fy": [1.0]}, "arrays of one length"),
        ({"duty.load.fz": [[1.0, 2.0]]}, "one-dimensional"),
        (
            {"bearing.contact_angle": 0.5, "bearing.diametral_clearance": 1e-5},
            "cannot be combined with",
        ),
        ({"duty.load.fz": 1.0, "duty.displacement.z": 0.0}, "cannot be combined with"),
        ({"duty.load.fz": 1.0, "fz": 2.0}, "given twice"),
        (
            {"bearing.preload.force": 1.0, "bearing.preload.spring": 2.0},
            "cannot be combined with",
        ),
        (
            {"bearing.preload.offset": 1e-6, "bearing.preload.force": [2.0]},
            "cannot be combined with",
        ),
    ],
)
def test_what_does_not_go_together_is_refused(values: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message) as caught:
        solve(PAIR, values)
    assert caught.value.field


@pytest.mark.parametrize(
    ("name", "near"),
    [
        ("bearing.contact_angel", "bearing.contact_angle"),
        ("duty.load.f", "duty.load.f"),
        ("bearing.ball_count", "one of|bearing.ball"),
        ("bearing.preload.level", "bearing.preload"),
        ("", "nearest: |did you mean"),
    ],
)
def test_an_unknown_field_is_refused_with_the_nearest(name: str, near: str) -> None:
    with pytest.raises(UnknownKeyError, match=near):
        solve(PAIR, {name: [1.0]})


def test_one_field_is_found_as_all_are() -> None:
    names = ("name", "replaces", "rivals", "kind", "bounds", "choices", "meaning")
    for name, among_all in fields_of(Case).items():
        alone = field_of(Case, name)
        assert alone is not None
        assert [getattr(alone, one) for one in names] == [getattr(among_all, one) for one in names]
    for unknown in ("duty.load", "duty.load.f", "duty.load.fz.x", "", "duty."):
        assert field_of(Case, unknown) is None


def test_fields_of_sets_belong_to_sets() -> None:
    with pytest.raises(InputError, match="applies to an arrangement, and this bearing has none"):
        solve(PLAIN, {"bearing.spacing": [0.03]})
    rows = PLAIN.replace(bearing=Bearing(**ANGULAR, rows=[{"position": 0.0}, {"position": 0.04}]))
    with pytest.raises(InputError, match="applies to an arrangement, and this bearing has none"):
        solve(rows, {"bearing.spacing": [0.03]})
    for case in (PLAIN, rows):
        with pytest.raises(InputError, match="opposed rows"):
            solve(case, {"bearing.preload.force": [100.0]})


# --- bad values ------------------------------------------------------------------------------


@pytest.mark.parametrize("case", [PLAIN, PAIR], ids=["plain", "pair"])
def test_a_bad_value_is_its_own_cases_affair(case: Case) -> None:
    angles = [0.5, np.nan, -1.0, 0.6, np.inf, 2.0, 1e300, -np.inf]
    batch = solve(case, {"bearing.contact_angle": angles}, inner_speed=200.0)
    good = [0, 3]
    bad = [i for i in range(len(angles)) if i not in good]
    assert (batch.status.code[bad] == "invalid_input").all()
    assert np.isnan(batch.displacement.array[bad]).all()
    alone = solve(case, {"bearing.contact_angle": [0.5, 0.6]}, inner_speed=200.0)
    assert np.array_equal(batch.displacement.array[good], alone.displacement.array)
    assert np.array_equal(batch.stiffness.array[good], alone.stiffness.array)


def test_a_bad_scalar_spoils_all() -> None:
    batch = solve(PAIR, {"bearing.preload.spring": -1.0}, fx=[1e3, 2e3])
    assert batch.status.code.tolist() == ["invalid_input"] * 2


def test_bounds_are_the_fields_own() -> None:
    def valid(name: str, *values: float) -> list[bool]:
        return [bool(kept == kept) for kept in bounded(varied_arrays({name: values}))[name]]

    assert valid("bearing.contact_angle", 0.0, 1.57, 1.5708, np.nan) == [True, True, False, False]
    assert valid("bearing.preload.spring", 0.0, 1e-9) == [False, True]
    assert valid("bearing.preload.force", 0.0, -1e-9) == [True, False]


# --- what follows what -----------------------------------------------------------------------


def test_the_balls_are_of_the_rings_material_unless_they_have_their_own() -> None:
    moduli = [1.5e11, 2.5e11]
    values = {"bearing.ring_material.youngs_modulus": moduli}
    followed = solve(PLAIN, values)
    both = solve(PLAIN, {**values, "bearing.ball_material.youngs_modulus": moduli})
    assert np.array_equal(followed.displacement.array, both.displacement.array)
    hybrid = PLAIN.replace(bearing=Bearing(**ANGULAR, ball_material="Si3N4"))
    own = solve(hybrid, values)
    silicon = hybrid.bearing.ball_material.youngs_modulus
    given = solve(PLAIN, {**values, "bearing.ball_material.youngs_modulus": silicon,
                                "bearing.ball_material.poisson_ratio": 0.26})  # fmt: skip
    poisson = hybrid.bearing.ball_material.poisson_ratio
    assert poisson == 0.26
    assert own.displacement.array[:, 0] == pytest.approx(given.displacement.array[:, 0], rel=1e-12)
    assert not np.allclose(own.displacement.array[:, 0], followed.displacement.array[:, 0])


def test_an_angle_takes_the_place_of_a_clearance_and_the_other_way_round() -> None:
    clearance = PLAIN.replace(
        bearing=Bearing(**{**ANGULAR, "contact_angle": None, "diametral_clearance": "50 um"})
    )
    by_angle = solve(clearance, {"bearing.contact_angle": [0.5]}, fz=500.0)
    assert by_angle.displacement.array == pytest.approx(
        solve(PLAIN, {"bearing.contact_angle": [0.5]}, fz=500.0).displacement.array
    )
    by_clearance = solve(PLAIN, {"bearing.diametral_clearance": [50e-6]}, fz=500.0)
    assert by_clearance.displacement.array == pytest.approx(
        solve(clearance, fz=[500.0]).displacement.array
    )


def test_a_row_keeps_what_it_has_of_its_own() -> None:
    own = {"position": "30 mm", "orientation": "-", "ball_diameter": "20 mm"}
    case = PLAIN.replace(
        bearing=Bearing(**ANGULAR, rows=[{"position": "-30 mm"}, own], preload="10 um")
    )
    batch = solve(case, {"bearing.ball_diameter": [0.0222, 0.021]})
    for i, diameter in enumerate((0.0222, 0.021)):
        one = solve(case.replace(bearing=case.bearing.replace(ball_diameter=diameter)))
        assert batch.displacement.array[i] == pytest.approx(
            one.displacement.array[0], rel=1e-9, abs=1e-15
        )
    assert (batch.rows.ball_diameter[:, 1] == 0.020).all()


def test_a_rows_own_angle_is_not_replaced_by_the_sets_clearance() -> None:
    rows = [
        {"position": "-30 mm"},
        {"position": "30 mm", "orientation": "-", "contact_angle": "30 deg"},
    ]
    case = PLAIN.replace(bearing=Bearing(**ANGULAR, rows=rows, preload="5 um"))
    batch = solve(case, {"bearing.diametral_clearance": [60e-6]})
    changed = case.bearing.replace(contact_angle=None, diametral_clearance=60e-6)
    alone = solve(case.replace(bearing=changed))
    assert batch.displacement.array[0] == pytest.approx(
        alone.displacement.array[0], rel=1e-9, abs=1e-15
    )


def test_spacing_moves_the_rows_and_nothing_else() -> None:
    spacing = np.array([0.02, 0.05, 0.2])
    batch = solve(PAIR, {"bearing.spacing": spacing}, fz=1e3)
    # held upright, and in the middle: the load does not feel where the rows are
    assert np.allclose(batch.displacement.array, batch.displacement.array[0])
    fz = batch.rows.load[:, 0, 2]
    moments = batch.rows.load[:, 0, 3] - batch.rows.load[0, 0, 3]
    assert moments == pytest.approx(0.5 * (spacing - spacing[0]) * fz, rel=1e-9, abs=1e-9)


def test_a_batch_of_preloads_is_the_preload_of_each() -> None:
    forces = [0.0, 500.0, 4e3]
    batch = solve(PAIR, {"bearing.preload.force": forces}, fx=0.0)
    assert batch.rows.load[:, 0, 0] == pytest.approx(forces, abs=1e-9)
    for force in forces[1:]:
        one = PAIR.replace(bearing=PAIR.bearing.replace(preload={"force": force}))
        found = preload_of(one)
        assert found is not None
        assert found.at_rest == pytest.approx(force)


def test_a_masked_value_is_no_value(case_218: Case) -> None:
    """What lies below a mask is not solved, nor is the rest of the batch touched."""
    whole = solve(case_218, fx=[2e4, 3e4, 4e4])
    load = np.ma.array([20_000, 30_000, 40_000], mask=[False, True, False])
    batch = solve(case_218, fx=load)
    assert list(batch.status.code) == ["converged", "invalid_input", "converged"]
    assert np.isnan(batch.displacement.array[1]).all()
    np.testing.assert_allclose(
        batch.displacement.array[[0, 2]], whole.displacement.array[[0, 2]], rtol=1e-9
    )
