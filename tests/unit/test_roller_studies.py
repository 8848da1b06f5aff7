"""Studies of roller bearings: what varies, what comes out, and what a batch refuses."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from rolamento import Case, InputError, parse_case, solve
from rolamento.studies.outputs import Evaluation, catalogue, refuse_missing

NU = """
[bearing]
element = "cylindrical"
roller_count = 13
roller_diameter = "7.5 mm"
effective_length = "8 mm"
roller_length = "8.5 mm"
pitch_diameter = "39 mm"
diametral_clearance = "0.03 mm"
[duty.load]
fz = "4 kN"
[duty.displacement]
ry = "1 mrad"
"""
TAPERED = """
[bearing]
element = "tapered"
roller_count = 17
roller_diameter = "7 mm"
effective_length = "10 mm"
pitch_diameter = "39 mm"
contact_angle = "14 deg"
roller_half_angle = "1.8 deg"
[duty.load]
fx = "1 kN"
fz = "2 kN"
"""


def case(text: str = NU, **fields: Any) -> Case:
    return parse_case(text).with_({key.replace("__", "."): v for key, v in fields.items()})


def outputs(given: Case, *names: str, **values: Any) -> dict[str, Any]:
    found = Evaluation(solve(given, values.get("values")))
    return {name: catalogue()[name].compute(found) for name in names}


@pytest.mark.parametrize(
    ("text", "field", "values"),
    [
        (NU, "bearing.roller_diameter", [7.4e-3, 7.6e-3]),
        (NU, "bearing.pitch_diameter", [38e-3, 40e-3]),
        (NU, "bearing.diametral_clearance", [-5e-6, 40e-6]),
        (NU, "bearing.roller_material.density", [3200.0, 7810.0]),
        (NU, "duty.displacement.ry", [0.0, 2e-3]),
        (TAPERED, "bearing.contact_angle", [0.2, 0.27]),
        (TAPERED, "bearing.roller_half_angle", [0.02, 0.04]),
        (TAPERED, "bearing.rib_height", [0.4e-3, 1.0e-3]),
    ],
)
def test_each_case_is_as_solved_alone(text: str, field: str, values: list[float]) -> None:
    names = ("z", "max_inner_load", "max_inner_max_pressure", "max_rib_force", "inner_edge_ratio")
    batch = outputs(case(text), *names, values={field: np.array(values)})
    for index, value in enumerate(values):
        alone = outputs(case(text, **{field.replace(".", "__"): value}), *names)
        for name in names:
            expected = alone[name][0]
            assert batch[name][index] == pytest.approx(expected, rel=1e-7, abs=1e-9, nan_ok=True)


def test_the_length_of_rollers_follows_that_of_their_contact() -> None:
    values = np.array([9e-3, 11e-3])
    batch = outputs(case(TAPERED), "max_inner_load", values={"bearing.effective_length": values})
    for index, value in enumerate(values):
        alone = outputs(case(TAPERED, bearing__effective_length=value), "max_inner_load")
        assert batch["max_inner_load"][index] == pytest.approx(alone["max_inner_load"][0], rel=1e-8)


def test_what_the_rollers_say() -> None:
    solved = solve(case())
    found = outputs(case(), "max_roller_tilt", "max_inner_end_pressure", "loaded_rollers",
                    "loaded_balls", "max_inner_edge_ratio", "roller_tilt", "rib_force",
                    "max_inner_max_pressure")  # fmt: skip
    assert solved.rollers is not None
    line = solved.rollers.inner.pressure[0]
    assert found["max_roller_tilt"][0] == np.abs(solved.rollers.tilt).max()
    assert found["max_inner_end_pressure"][0] == max(line[:, 0].max(), line[:, -1].max())
    assert found["max_inner_max_pressure"][0] == pytest.approx(line.max())
    heaviest = int(np.argmax(solved.inner.load[0]))
    ends = max(line[heaviest, 0], line[heaviest, -1])
    ratio = outputs(case(), "inner_edge_ratio")["inner_edge_ratio"][0]
    assert ratio[heaviest] == pytest.approx(ends / line[heaviest, 17])
    assert found["loaded_rollers"][0] == found["loaded_balls"][0] == (solved.inner.load > 0).sum()
    assert found["roller_tilt"].shape == (1, 13)
    assert not found["rib_force"].any()


def test_a_straight_roller_without_tilt_has_no_edge_but_that_of_its_slices() -> None:
    straight = case(bearing__roller_profile="none", duty__displacement__ry=0.0)
    assert outputs(straight, "max_inner_edge_ratio")["max_inner_edge_ratio"][0] == pytest.approx(1)


@pytest.mark.parametrize(
    ("text", "field", "bad"),
    [
        (NU, "bearing.roller_diameter", 12e-3),  # 13 of them do not fit
        (NU, "bearing.diametral_clearance", -0.2e-3),
        (NU, "bearing.effective_length", 9e-3),  # longer than the roller
        (NU, "bearing.pitch_diameter", 7e-3),
        (TAPERED, "bearing.roller_half_angle", 0.13),  # more than half the contact angle
        (TAPERED, "bearing.contact_angle", 0.05),
        (TAPERED, "bearing.roller_length", 0.5),  # no small end
    ],
)
def test_what_the_record_refuses_is_that_case_alone(text: str, field: str, bad: float) -> None:
    good = case(text)
    value = float(getattr(good.bearing, field.removeprefix("bearing.")))
    batch = solve(good, {field: np.array([value, bad])})
    assert batch.converged.tolist() == [True, False]
    with pytest.raises(InputError):
        case(text, **{field.replace(".", "__"): bad})


def test_what_such_a_bearing_does_not_have() -> None:
    for text, field in (
        (NU, "bearing.ball_diameter"),
        (NU, "bearing.contact_angle"),
        (TAPERED, "bearing.diametral_clearance"),
        (TAPERED, "bearing.inner_conformity"),
    ):
        with pytest.raises(InputError, match="no quantity of such a bearing") as error:
            solve(case(text), {field: np.array([1e-5, 2e-5])})
        assert error.value.field == field


def test_balls_have_no_outputs_of_rollers() -> None:
    balls = parse_case('[bearing]\ndesignation = "6205"\n[duty.load]\nfz = "1 kN"\n')
    with pytest.raises(InputError, match="needs rollers"):
        refuse_missing([catalogue()["max_rib_force"]], balls, ())
    refuse_missing([catalogue()["max_rib_force"]], case(), ())


def test_a_part_of_the_usual_profile_may_vary() -> None:
    wide = case(bearing__roller_profile={"factor": 0.001})
    assert wide.bearing == case(bearing__roller_profile={"kind": "iso", "factor": 0.001}).bearing
    with pytest.raises(InputError, match="kind"):
        case(bearing__roller_profile={"factor": 0.001, "radius": 1.0})
    arc = parse_case(NU, overrides=["bearing.roller_profile.radius=2 m"])
    assert arc.bearing.roller_profile.kind == "crowned"
