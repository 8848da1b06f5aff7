"""Rollers that turn so slowly that their inertia hardly presses them anywhere."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from rolamento import Case, Solved, solve

RPM = np.pi / 30.0
SPEEDS = np.array([0.0, 1e-3, 1e-2, 0.1, 0.2, 0.3, 1.0, 5.0]) * RPM
TAPERED = ("30204", "30206", "32008 X", "30310", "32216", "33111")


def of(bearing: dict[str, Any], **parts: Any) -> Case:
    return Case.model_validate({"bearing": bearing, **parts})


def check_light_rollers(solved: Solved) -> None:
    """A roller that the inner race does not touch rests on the outer with what inertia presses."""
    free = (solved.inner.load == 0.0) & (solved.outer.load > 0.0)
    force = solved.elements.centrifugal_force
    angle = solved.outer.contact_angle
    # the rib takes the rest of what is not along the contact's normal
    excess = np.where(free, np.abs(solved.outer.load - force), 0.0)
    assert (excess <= 0.2 * force + 1e-11 * solved.inner.load.max(axis=1, keepdims=True)).all()
    assert np.isfinite(angle).all()


@pytest.mark.parametrize("designation", TAPERED)
def test_slow_tapered_rollers_are_as_those_at_rest(designation: str) -> None:
    case = of({"designation": designation}, duty={"load": {"fz": "4 kN", "fx": "1.5 kN"}})
    solved = solve(case, inner_speed=SPEEDS)
    assert solved.converged.all()
    loads = solved.inner.load
    assert np.abs(loads - loads[0]).max() <= 1e-5 * loads.max()
    check_light_rollers(solved)


def test_a_slow_bearing_alone_without_the_compiler() -> None:
    case = of(
        {"designation": "30206"},
        duty={"load": {"fz": "4 kN", "fx": "1.5 kN"}, "inner_speed": "0.2 rpm"},
    )
    alone = solve(case)
    assert alone.status.code.tolist() == ["converged"]
    among = solve(case, inner_speed=SPEEDS)
    assert alone.inner.load[0] == pytest.approx(among.inner.load[4], rel=1e-9, abs=1e-7)


def test_a_slow_tilted_row_with_little_load() -> None:
    case = of(
        {
            "element": "needle",
            "roller_count": 25,
            "roller_diameter": "10.0951 mm",
            "effective_length": "24.9677 mm",
            "pitch_diameter": "110.8853 mm",
            "diametral_clearance": "57.26 um",
        },
        duty={
            "load": {"fz": "-14.3496 N"},
            "displacement": {"x": "0 mm", "ry": "3.10666 mrad", "rz": "-0.578094 mrad"},
            "first_ball_azimuth": "41.775 deg",
        },
    )
    solved = solve(case, inner_speed=np.array([0.0, -1e-3, -0.1616, -1.0]) * RPM)
    assert solved.converged.all()
    loads = solved.inner.load
    assert np.abs(loads - loads[0]).max() <= 1e-5 * loads.max()


@pytest.mark.parametrize("seed", range(3))
def test_random_tapered_bearings_at_a_crawl(seed: int) -> None:
    random = np.random.default_rng(seed)
    case = of({"designation": TAPERED[seed]}, duty={})
    cases = 150
    size = 10.0 ** random.uniform(0.0, 4.3, cases)
    around = random.uniform(0.0, 2.0 * np.pi, cases)
    angle = case.bearing.contact_angle
    solved = solve(
        case,
        fz=size * np.cos(around),
        fy=size * np.sin(around),
        fx=size * np.tan(angle) * random.uniform(1.3, 5.0, cases),
        inner_speed=10.0 ** random.uniform(-3.0, 0.5, cases) * RPM,
    )
    assert (solved.status.code != "not_converged").all()
    assert solved.converged.mean() > 0.9


def test_straight_rollers_whose_axial_load_is_too_small_have_no_equilibrium() -> None:
    """The ring leaves them far, and rounding grows with its way.

    Below F_r tan α nothing holds a cone; below Σ F_c tan α the rollers' inertia pushes it out.
    """
    straight = {
        "element": "tapered",
        "roller_count": 30,
        "roller_diameter": "38.67276 mm",
        "effective_length": "57.741508 mm",
        "roller_length": "60.628583 mm",
        "pitch_diameter": "417.868305 mm",
        "contact_angle": "20.327507 deg",
        "roller_profile": {"kind": "none"},
    }
    radial = 22.624e3
    least = radial * np.tan(np.radians(20.327507))
    solved = solve(
        of(straight, duty={"load": {"fz": radial, "fx": least}}),
        fz=np.array([radial, radial, 1.0]),
        fx=least * np.array([0.65, 3.0, 1e-3]),
        inner_speed=np.array([-1.843, -1.843, 300.0]) * RPM,
    )
    assert solved.status.code.tolist() == ["no_equilibrium", "converged", "no_equilibrium"]
