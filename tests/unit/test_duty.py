from __future__ import annotations

import pytest

from rolamento import Displacement, Duty, InputError, Load, Model


def test_an_absent_force_is_zero_and_an_absent_tilt_is_held() -> None:
    duty = Duty(load=Load(fx=20e3))
    assert duty.free == (True, True, True, False, False)
    assert duty.applied_load == (20e3, 0.0, 0.0, 0.0, 0.0)
    assert duty.imposed_displacement == (0.0,) * 5


def test_a_moment_of_zero_leaves_the_ring_free_to_tilt() -> None:
    assert Duty(load=Load(my=0.0)).free == (True, True, True, True, False)


def test_a_displacement_holds_its_degree_of_freedom() -> None:
    shift = Displacement(x=0.0, z="0.01 mm", ry="1 deg", rz=0.01)
    duty = Duty(load={"fy": 5.0, "my": None}, displacement=shift)
    assert duty.free == (False, True, False, False, False)
    assert duty.imposed_displacement == (0.0, 0.0, 1e-5, shift.ry, 0.01)
    assert duty.applied_load == (0.0, 5.0, 0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("axis", "load"), [("x", "fx"), ("y", "fy"), ("z", "fz"), ("ry", "my"), ("rz", "mz")]
)
def test_a_degree_of_freedom_is_not_given_twice(axis: str, load: str) -> None:
    with pytest.raises(InputError, match=rf"displacement\.{axis} .* with load\.{load}"):
        Duty(load={load: 1.0}, displacement={axis: 0.0})


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"inner_speed": "10000 mm"}, "not a unit of angular speed"),
        ({"inner_speed": "2e6 rpm"}, "must be at least −1 000 000 rpm and at most 1 000 000 rpm"),
        ({"outer_speed": float("inf")}, "must be a finite number"),
        ({"first_ball_azimuth": 7.0}, "at most 360°"),
        ({"load": 3}, "load = 3: must be a table"),
        ({"load": {"fw": 3.0}}, "known: fx, fy, fz, my, mz"),
        ({"load": {"fx": 2e9}}, "at most 1 000 000 kN"),
        ({"displacement": {"ry": 0.1}}, "at most 5°"),
        ({"displacement": {"x": True}}, "must be a number"),
    ],
)
def test_impossible_duties_are_refused(fields: dict[str, object], message: str) -> None:
    with pytest.raises(InputError, match=message):
        Duty(**fields)


def test_a_negative_zero_is_zero() -> None:
    assert str(Duty(inner_speed=-0.0).inner_speed) == "0.0"


def test_the_model_defaults_to_outer_control_with_all_effects() -> None:
    model = Model()
    assert (model.raceway_control, model.centrifugal_force, model.gyroscopic_moment) == (
        "outer",
        True,
        True,
    )


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"raceway_control": "outre"}, "one of outer, inner, jones, none, friction"),
        ({"centrifugal_force": 1}, "must be true or false"),
        ({"gyroscopic": False}, "did you mean gyroscopic_moment"),
    ],
)
def test_unknown_models_are_refused(fields: dict[str, object], message: str) -> None:
    with pytest.raises(InputError, match=message):
        Model(**fields)
