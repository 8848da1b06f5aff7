from __future__ import annotations

import copy
import pickle
from typing import Any

import numpy as np
import pytest

from rolamento import Bearing, InputError, Material, UnitError, UnknownKeyError

GEOMETRY: dict[str, Any] = {
    "ball_count": 16,
    "ball_diameter": 0.02223,
    "pitch_diameter": 0.12526,
    "contact_angle": 0.7,
    "inner_conformity": 0.5232,
    "outer_conformity": 0.5232,
}


def test_plain_floats_are_si_and_text_has_units(bearing_218: Bearing) -> None:
    assert bearing_218.ball_diameter == 0.02223
    assert Bearing(**GEOMETRY).ball_diameter == bearing_218.ball_diameter


def test_the_materials_default_to_bearing_steel_and_the_balls_to_the_rings() -> None:
    assert Bearing(**GEOMETRY).ring_material == Material.named("100Cr6")
    stainless = Bearing(**GEOMETRY, ring_material="440C")
    assert stainless.ball_material == Material.named("440C")
    hybrid = Bearing(**GEOMETRY, ball_material="si3n4")
    assert hybrid.ball_material == Material.named("Si3N4")
    assert hybrid.ring_material == Material.named("100Cr6")


def test_equal_by_value_hashable_and_copied_by_pickle(bearing_218: Bearing) -> None:
    twin = pickle.loads(pickle.dumps(bearing_218))
    assert twin == bearing_218 == copy.deepcopy(bearing_218)
    assert len({twin, bearing_218}) == 1


def test_frozen_and_replaced_with_the_same_checks(bearing_218: Bearing) -> None:
    with pytest.raises(AttributeError, match="does not change"):
        bearing_218.ball_count = 3  # type: ignore[misc]
    assert bearing_218.replace(ball_count=15).ball_count == 15
    deep_groove = bearing_218.replace(contact_angle=None, diametral_clearance=20e-6)
    assert deep_groove.contact_angle is None
    with pytest.raises(InputError, match="do not fit"):
        bearing_218.replace(ball_count=18)


def test_numpy_numbers_are_numbers() -> None:
    bearing = Bearing(**{**GEOMETRY, "ball_count": np.int64(16), "contact_angle": np.float64(0.7)})
    assert bearing == Bearing(**GEOMETRY)
    assert type(bearing.ball_count) is int
    assert type(bearing.contact_angle) is float


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"ball_count": 18}, "ball_count = 18: balls of 22.23 mm do not fit .* room for 17"),
        ({"ball_count": 2}, "ball_count = 2: must be at least 3"),
        ({"ball_count": 16.0}, "ball_count = 16.0: must be an integer"),
        ({"ball_count": "16"}, 'ball_count = "16": must be an integer'),
        ({"ball_count": True}, "ball_count = true: must be an integer"),
        ({"ball_count": 10**5000}, "a very long integer: must be at most 500"),
        ({"ball_diameter": -0.02}, "ball_diameter = -0.02: must be at least 0.01 mm"),
        ({"ball_diameter": 0}, "must be at least 0.01 mm and at most 1 m"),
        ({"ball_diameter": float("nan")}, "ball_diameter = nan: must be a finite number"),
        ({"ball_diameter": 10**400}, "must be a finite number"),
        ({"ball_diameter": False}, "ball_diameter = false: must be a number"),
        ({"ball_diameter": None}, "must be a number"),
        ({"ball_diameter": 22.23}, "must be at least 0.01 mm and at most 1 m"),
        ({"pitch_diameter": 0.02}, "must be greater than the ball diameter, 22.23 mm"),
        ({"contact_angle": -0.1}, "must be at least 0° and at most 90°"),
        ({"contact_angle": "90 deg"}, 'must be less than 90°, unless kind = "thrust"'),
        ({"inner_conformity": 0.5}, "inner_conformity = 0.5: must be at least 0.501"),
        ({"outer_conformity": 1.1}, "at most 1"),
        ({"outer_conformity": "0.52"}, "must be a number"),
        ({"diametral_clearance": 1e-5}, "cannot be combined with the contact angle: each follows"),
        ({"contact_angle": None}, "give the contact angle or the diametral clearance"),
        ({"contact_angle": None, "diametral_clearance": 0.01}, "less than 2.063 mm"),
        ({"contact_angle": None, "diametral_clearance": -0.001}, "greater than −0.2579 mm"),
        ({"inner_shoulder_height": 0.012}, "less than the ball radius, 11.11 mm"),
        ({"outer_shoulder_height": 0.0}, "greater than 0 mm"),
        ({"ring_material": "101Cr6"}, "did you mean 100Cr6"),
        ({"ring_material": 207e9}, r"must be a name \(material\) or a table"),
        ({"ball_material": {"density": 3240.0}}, "ball_material.youngs_modulus: is missing"),
    ],
)
def test_impossible_bearings_are_refused(change: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message) as caught:
        Bearing(**{**GEOMETRY, **change})
    assert caught.value.field


def test_every_refusal_of_a_value_shows_an_example() -> None:
    for name, wrong in {"ball_count": "x", "ball_diameter": "x", "inner_conformity": "x"}.items():
        with pytest.raises(InputError) as caught:
            Bearing(**{**GEOMETRY, name: wrong})
        assert caught.value.example.startswith(f"{name} = ")


def test_a_missing_unit_and_a_misspelt_key_have_their_own_exceptions() -> None:
    with pytest.raises(UnitError, match="needs a unit"):
        Bearing(**{**GEOMETRY, "ball_diameter": "22.23"})
    with pytest.raises(UnknownKeyError, match="did you mean ball_diameter"):
        Bearing(**GEOMETRY, ball_diametre=0.02)


def test_the_fullest_complement_fits() -> None:
    full = Bearing(
        ball_count=4,
        ball_diameter=0.01,
        pitch_diameter=0.01 * 2**0.5 * (1 + 1e-12),
        diametral_clearance=0.0,
        inner_conformity=0.52,
        outer_conformity=0.53,
    )
    assert full.diametral_clearance == 0.0


def test_pydantic_never_speaks() -> None:
    with pytest.raises(InputError, match="ball_count: is missing"):
        Bearing()
    with pytest.raises(InputError, match="must be a table"):
        Bearing.from_mapping([])  # type: ignore[arg-type]
