"""Laws of the clearance in operation: scale, order, superposition, round trips."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rolamento import Bearing, Case, Duty, Load
from rolamento.case import case_to_toml, parse_case
from rolamento.clearance import (
    Mounting,
    PartTemperatures,
    operating_clearance,
    sample_clearance,
)

INTERFERENCES = st.floats(-30e-6, 30e-6)
TEMPERATURES = st.floats(250.0, 420.0)
SPEEDS = st.floats(0.0, 4000.0)
SEATS = st.sampled_from([None, "steel", "cast iron", "aluminium"])


def bearing(scale: float = 1.0) -> Bearing:
    return Bearing(
        ball_count=8,
        ball_diameter=10.319e-3 * scale,
        pitch_diameter=44.5e-3 * scale,
        diametral_clearance=20e-6 * scale,
        inner_conformity=0.515,
        outer_conformity=0.53,
    )


@st.composite
def fits(draw: st.DrawFn) -> dict[str, Any]:
    return {
        "shaft_interference": draw(INTERFERENCES),
        "housing_interference": draw(INTERFERENCES),
        "shaft_bore": draw(st.floats(0.0, 20e-3)),
        "housing_outside_diameter": draw(st.floats(70e-3, 200e-3)),
        "shaft_roughness": draw(st.floats(0.0, 10e-6)),
        "shaft_material": draw(SEATS),
        "housing_material": draw(SEATS),
    }


LENGTHS = (
    "shaft_interference",
    "housing_interference",
    "shaft_bore",
    "housing_outside_diameter",
    "shaft_roughness",
)


def mounted(fit: dict[str, Any], scale: float = 1.0, **changes: Any) -> Mounting:
    fields = {name: scale * value if name in LENGTHS else value for name, value in fit.items()}
    return Mounting(bore=25e-3 * scale, outside_diameter=62e-3 * scale, **(fields | changes))


@given(fits(), st.floats(0.5, 3.0), TEMPERATURES, TEMPERATURES, SPEEDS)
def test_all_lengths_scale_together(
    fit: dict[str, Any], scale: float, inner: float, outer: float, speed: float
) -> None:
    """At equal temperatures and equal circumferential speeds."""
    warm = PartTemperatures(inner, outer)
    small = operating_clearance(bearing(), mounted(fit), warm, inner_speed=speed)
    great = operating_clearance(
        bearing(scale), mounted(fit, scale), warm, inner_speed=speed / scale
    )
    assert great.mean == pytest.approx(scale * small.mean, rel=1e-9, abs=1e-15)


@given(fits(), INTERFERENCES, st.sampled_from(["shaft_interference", "housing_interference"]))
def test_a_tighter_fit_never_leaves_more(fit: dict[str, Any], other: float, name: str) -> None:
    first = operating_clearance(bearing(), mounted(fit)).mean
    second = operating_clearance(bearing(), mounted({**fit, name: other})).mean
    if other >= fit[name]:
        assert second <= first + 1e-18
    else:
        assert second >= first - 1e-18


@given(fits())
def test_the_raceway_never_moves_more_than_the_interference(fit: dict[str, Any]) -> None:
    found = operating_clearance(bearing(), mounted(fit))
    for step in found.steps[1:]:
        interference = step.details["interference"][1]
        assert -max(interference, 0.0) <= step.change[1] <= 0.0


@given(fits(), TEMPERATURES, TEMPERATURES, SPEEDS)
def test_the_steps_always_add_up(
    fit: dict[str, Any], inner: float, outer: float, speed: float
) -> None:
    warm = PartTemperatures(inner, outer)
    found = operating_clearance(bearing(), mounted(fit), warm, inner_speed=speed)
    total = sum(step.change[1] for step in found.steps)
    assert total == pytest.approx(found.mean, rel=1e-9, abs=1e-15)
    assert found.minimum == found.mean == found.maximum


@given(
    st.sampled_from(["h6", "j5", "k5", "m5", "n6"]),
    st.sampled_from(["H7", "J7", "K7", "P7"]),
    st.sampled_from(["C2", "CN", "C3", "C5"]),
    st.integers(0, 2**32 - 1),
)
def test_samples_stay_within_the_limits(shaft: str, hole: str, name: str, seed: int) -> None:
    place = mounted({}, shaft_tolerance=shaft, housing_tolerance=hole, clearance_class=name)
    found = operating_clearance(bearing(), place)
    samples = sample_clearance(bearing(), place, samples=200, seed=seed)
    assert found.minimum <= samples.clearance.min()
    assert samples.clearance.max() <= found.maximum
    assert found.minimum <= found.mean <= found.maximum


@given(fits(), TEMPERATURES, TEMPERATURES)
def test_a_case_with_a_mounting_is_read_back(
    fit: dict[str, Any], inner: float, outer: float
) -> None:
    case = Case(
        bearing=bearing(),
        duty=Duty(load=Load(fz=1.0)),
        mounting=mounted(fit),
        temperature={"lubricant": 340.0, "inner_ring": inner, "outer_ring": outer},
    )
    assert parse_case(case_to_toml(case), format="toml") == case
