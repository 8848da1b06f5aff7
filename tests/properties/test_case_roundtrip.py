"""What is written reads back as the identical case, bit for bit."""

from __future__ import annotations

import math

from hypothesis import given
from hypothesis import strategies as st

from rolamento import (
    Bearing,
    Case,
    Displacement,
    Duty,
    LifeModel,
    Load,
    Material,
    Model,
    Temperature,
)
from rolamento.case import case_to_json, case_to_toml, override, parse_case

LINES = st.text(
    st.characters(exclude_categories=["Cc", "Cs", "Zl", "Zp"]), min_size=0, max_size=200
)


def reals(least: float, greatest: float) -> st.SearchStrategy[float]:
    return st.floats(least, greatest, allow_nan=False)


materials = st.sampled_from(["100Cr6", "440C", "M50", "Si3N4"]).map(Material.named) | st.builds(
    Material,
    name=LINES,
    youngs_modulus=reals(1e9, 2e12),
    poisson_ratio=reals(0.0, 0.49),
    density=reals(100.0, 25000.0),
    source=LINES,
)


@st.composite
def bearings(draw: st.DrawFn) -> Bearing:
    count = draw(st.integers(3, 60))
    pitch = draw(reals(0.01, 1.0))
    ball = pitch * math.sin(math.pi / count) * draw(reals(0.1, 0.999))
    inner, outer = draw(reals(0.501, 0.6)), draw(reals(0.501, 0.6))
    distance = ball * (inner + outer - 1.0)
    by_angle = draw(st.booleans())
    return Bearing(
        ball_count=count,
        ball_diameter=ball,
        pitch_diameter=pitch,
        contact_angle=draw(reals(0.0, 1.57)) if by_angle else None,
        diametral_clearance=None if by_angle else distance * draw(reals(-0.2, 1.9)),
        inner_conformity=inner,
        outer_conformity=outer,
        ring_material=draw(materials),
        ball_material=draw(materials),
        inner_shoulder_height=draw(st.none() | reals(1e-9, 0.49).map(lambda part: part * ball)),
    )


@st.composite
def duties(draw: st.DrawFn, reach: float) -> Duty:
    loads: dict[str, float] = {}
    shifts: dict[str, float] = {}
    limits = {"x": reach, "y": reach, "z": reach, "ry": 0.08, "rz": 0.08}
    for axis, load in zip(limits, ["fx", "fy", "fz", "my", "mz"], strict=True):
        kind = draw(st.sampled_from(["load", "displacement", "neither"]))
        if kind == "load":
            loads[load] = draw(reals(-1e9, 1e9))
        elif kind == "displacement":
            shifts[axis] = draw(reals(-limits[axis], limits[axis]))
    return Duty(
        inner_speed=draw(reals(-1e5, 1e5)),
        outer_speed=draw(reals(-1e5, 1e5)),
        first_ball_azimuth=draw(reals(-6.28, 6.28)),
        load=Load(**loads),
        displacement=Displacement(**shifts),
    )


@st.composite
def cases(draw: st.DrawFn) -> Case:
    bearing = draw(bearings())
    model = Model(
        raceway_control=draw(st.sampled_from(["outer", "inner", "jones", "none"])),
        centrifugal_force=draw(st.booleans()),
        gyroscopic_moment=draw(st.booleans()),
    )
    duty = draw(duties(bearing.ball_diameter))
    return Case(title=draw(LINES), bearing=bearing, duty=duty, model=model)


@given(cases())
def test_toml_is_the_identity(case: Case) -> None:
    again = parse_case(case_to_toml(case), format="toml")
    assert again == case
    assert hash(again) == hash(case)
    assert repr(again.model_dump()) == repr(case.model_dump())


@given(cases())
def test_json_is_the_identity(case: Case) -> None:
    again = parse_case(case_to_json(case), format="json")
    assert again == case
    assert repr(again.model_dump()) == repr(case.model_dump())


@given(cases())
def test_setting_nothing_changes_nothing(case: Case) -> None:
    assert override(case, []) == case


@given(cases())
def test_python_values_are_the_identity(case: Case) -> None:
    assert Case(**case.model_dump()) == case


def test_a_table_without_a_value_is_a_table_still() -> None:
    """Of no values at all; a table that holds tables only needs no line of its own."""
    bearing = Bearing.named("6305")
    case = Case(bearing=bearing, duty=Duty(), temperature=Temperature(), life=LifeModel())
    text = case_to_toml(case)
    assert "[temperature]" in text.splitlines()
    assert parse_case(text, format="toml") == case
    assert case_to_toml(parse_case(text, format="toml")) == text
    assert parse_case(case_to_json(case), format="json") == case
    without = case.replace(temperature=None)
    assert parse_case(case_to_toml(without), format="toml") == without != case
