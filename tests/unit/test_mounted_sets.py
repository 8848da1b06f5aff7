"""Fits, temperatures and speed on the preload of a set: limits, symmetries, first principles."""

from __future__ import annotations

import json
from math import acos, cos, hypot, pi, sin, sqrt
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

from rolamento import Case, InputError, parse_case
from rolamento.cli.requested import program_of
from rolamento.document.terminal import terminal
from rolamento.pages.clearance import clearance_page
from rolamento.pages.state import state_page
from rolamento.solution import solve
from rolamento.solved import PreloadStage, Solved
from rolamento.static import race_stiffness
from rolamento.system import solve_cases, spread
from rolamento.system.mounted import LIMITS, preload_stages, running_set
from rolamento.system.preload import first_lift_off, preload_at
from rolamento.tasks.clearance import mounted_clearance, mounted_samples

PAIR = """
title = "spindle pair"
[bearing]
ball_count = 20
ball_diameter = "11.906 mm"
pitch_diameter = "90 mm"
contact_angle = "15 deg"
inner_conformity = 0.52
outer_conformity = 0.53
arrangement = "DB"
spacing = "40 mm"
preload = "250 N"
[duty]
[duty.load]
fx = "0 N"
[mounting]
bore = "70 mm"
outside_diameter = "110 mm"
shaft_bore = "30 mm"
"""
ALPHA = 12.5e-6
DM, D, Z, FI, FO = 90e-3, 11.906e-3, 20, 0.52, 0.53


def pair(**fields: Any) -> Case:
    return parse_case(PAIR).with_({key.replace("__", "."): v for key, v in fields.items()})


def last(case: Case) -> float:
    return preload_stages(case)[-1].preload[1]


def stage(case: Case, name: str) -> PreloadStage:
    return next(one for one in preload_stages(case) if one.name == name)


def alone(case: Case) -> Solved:
    """The running set, solved without what takes hundreds of solutions more."""
    return solve_cases(spread(running_set(case), threads=1))


# --- limits --------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", ["250 N", "6 um", {"spring": "250 N"}], ids=str)
@pytest.mark.parametrize("arrangement", ["DB", "DF", "TBT", "QBC"])
def test_a_mounting_that_does_nothing_changes_nothing(arrangement: str, kind: Any) -> None:
    case = pair(bearing__arrangement=arrangement, bearing__preload=kind, duty__load__fx="100 N")
    bare = solve_cases(spread(case.replace(mounting=None)))
    state = alone(case)
    assert state.converged[0]
    expected = pytest.approx(bare.displacement.array, rel=1e-7, abs=1e-13)
    assert state.displacement.array == expected
    first, second = preload_stages(case)
    assert second.preload == pytest.approx(first.preload, rel=1e-9)


def test_uniform_heating_scales_the_geometry_only() -> None:
    """All lengths grow by 1 + αT: Hertz's forces by its square, and no angle changes."""
    warm = {f"temperature__{part}": 353.15 for part in ("inner_ring", "outer_ring")}
    found = preload_stages(pair(**warm, mounting__width="18 mm"))
    scale = 1.0 + ALPHA * 60.0
    before, after = found[0], found[-1]
    assert after.name == "warm"
    assert after.preload[1] == pytest.approx(before.preload[1] * scale**2, rel=2e-6)
    assert after.contact_angle == pytest.approx(before.contact_angle, rel=1e-9)
    assert after.offset == pytest.approx([scale * e for e in before.offset], rel=2e-6)
    assert after.max_pressure == pytest.approx(before.max_pressure, rel=2e-6)
    assert after.axial_stiffness == pytest.approx(before.axial_stiffness * scale, rel=2e-6)


def test_without_opposed_rows_there_is_no_preload_to_tell() -> None:
    case = pair(bearing__arrangement="DT", bearing__preload=None, duty__load__fx="500 N")
    assert preload_stages(case) == ()
    assert solve(case).preload is None


# --- first principles ----------------------------------------------------------------------------


def by_hand(case: Case, inner_growth: float, outer_shrinkage: float, along: float) -> float:
    """Preload of a clamped pair from Hertz's law and the places of the groove centres alone.

    inner_growth, outer_shrinkage: of the raceways' diameters; along: σ S of both rows; m.
    """
    single = case.bearing.places[0].bearing
    reach = (FI + FO - 1.0) * D
    alpha = pi / 12.0

    def force(axial: float, radial: float) -> float:
        angle = np.arctan2(axial, radial)
        stiffness = float(race_stiffness(single, np.array([angle])).combined[0])
        approach = hypot(axial, radial) - reach
        return Z * stiffness * max(approach, 0.0) ** 1.5 * sin(angle)

    low, high = 0.0, 1e-3
    for _ in range(200):
        middle = 0.5 * (low + high)
        below = force(reach * sin(alpha) + middle, reach * cos(alpha)) < 250.0
        low, high = (middle, high) if below else (low, middle)
    radial = reach * cos(alpha) + 0.5 * (inner_growth + outer_shrinkage)
    return force(reach * sin(alpha) + low + along, radial)


def test_a_press_fit_by_lame_and_hertz() -> None:
    case = pair(mounting__shaft_interference="6 um", mounting__housing_interference="2 um")
    inner = DM * 1.0 - 2.0 * (FI * D - (FI - 0.5) * D * cos(pi / 12.0))
    reach = (FI + FO - 1.0) * D
    outer = inner + 2.0 * D + 2.0 * reach * (1.0 - cos(pi / 12.0))
    q, k = 70e-3 / inner, 30.0 / 70.0
    growth = 6e-6 * q * (1.0 - k * k) / (1.0 - q * q * k * k)
    h = outer / 110e-3
    assert last(case) == pytest.approx(by_hand(case, growth, 2e-6 * h, 0.0), rel=1e-4)


def test_a_spacer_by_its_expansion() -> None:
    """12 mm of a warmer inner spacer move the rows of a DB pair apart by half of it each."""
    case = pair(
        temperature__inner_ring=293.15,
        temperature__outer_ring=293.15,
        temperature__inner_spacer=303.15,
        mounting__width="28 mm",
    )
    along = -0.5 * 12e-3 * ALPHA * 10.0
    assert last(case) == pytest.approx(by_hand(case, 0.0, 0.0, along), rel=1e-4)
    bronze = case.with_(
        {
            "mounting.inner_spacer_material": {
                "youngs_modulus": "100 GPa", "poisson_ratio": 0.34, "density": "8800 kg/m^3",
                "thermal_expansion": "18e-6 1/K",
            }
        }
    )  # fmt: skip
    along = -0.5 * 12e-3 * 18e-6 * 10.0
    assert last(bronze) == pytest.approx(by_hand(case, 0.0, 0.0, along), rel=1e-4)


def test_a_small_radial_growth_acts_as_its_cotangent_along_the_axis() -> None:
    case = pair(mounting__shaft_interference="0.05 um", mounting__shaft_bore="0 mm")
    before, after = preload_stages(case)[:2]
    inner = DM - 2.0 * (FI * D - (FI - 0.5) * D * cos(pi / 12.0))
    growth = 0.05e-6 * 70e-3 / inner
    change = after.offset[0] - before.offset[0]
    assert change == pytest.approx(0.5 * growth / np.tan(pi / 12.0), rel=2e-3)


def test_the_speed_grows_the_rings_and_throws_the_balls() -> None:
    found = preload_stages(pair(duty__inner_speed="12000 rpm"))
    assert [one.name for one in found] == ["unmounted", "mounted", "rings_grown", "at_speed"]
    omega, nu, modulus = 12000.0 * pi / 30.0, 0.3, 208e9
    material = pair().bearing.ring_material
    nu, modulus, density = material.poisson_ratio, material.youngs_modulus, material.density
    b = 0.5 * (DM - 2.0 * (FI * D - (FI - 0.5) * D * cos(pi / 12.0)))
    a = 35e-3
    growth = density * omega**2 * b / (4.0 * modulus) * ((1.0 - nu) * b * b + (3.0 + nu) * a * a)
    assert found[2].preload[1] == pytest.approx(by_hand(pair(), 2.0 * growth, 0.0, 0.0), rel=1e-4)
    assert found[3].preload[1] > found[2].preload[1]


# --- O and X -------------------------------------------------------------------------------------


def warm_shaft(case: Case, rise: float) -> Case:
    """Inner rings and shaft warmer than the rest, which is as at assembly."""
    base = 293.15
    return case.with_(
        {
            "temperature.inner_ring": base + rise,
            "temperature.outer_ring": base,
            "temperature.balls": base,
        }
    )


def test_the_vertex() -> None:
    """A warm inner ring and shaft that grow about one point move tangentially at the contacts.

    That point is where the tangents of both rows' inner contacts meet the axis: back to back, and
    at this one spacing only, the balls' loads do not change (p³ goes with them; the angle does
    change, and with it the axial force by a per cent). Closer rows tighten, wider ones loosen.
    """
    case = pair()
    found = solve(case).inner.contact_angle[0, 0]
    reach, alpha = (FI + FO - 1.0) * D, pi / 12.0
    length = (FI - 0.5) * D
    groove = 0.5 * DM + length * cos(alpha)
    push = preload_stages(case)[0].offset[0]
    axial = reach * sin(alpha) + push
    # of a contact normal at the loaded angle: inner groove centre at (x_g, R_i)
    x_g = axial * length / reach
    contact_radius = groove - FI * D * cos(found)
    contact_x = x_g - FI * D * sin(found)
    half = contact_x + contact_radius / np.tan(found)
    changes = {}
    for factor in (0.5, 1.0, 1.5):
        there = case.with_({"bearing.spacing": 2.0 * factor * float(half)})
        rise = (warm_shaft(there, one) for one in (1.0, -1.0))
        up, down = (preload_stages(one)[-1].max_pressure ** 3 for one in rise)
        changes[factor] = (up - down) / (up + down)
    assert changes[0.5] > 0.03
    assert changes[1.5] < -0.03
    assert abs(changes[1.0]) < 5e-3 * changes[0.5]  # of second order


def test_a_warm_shaft_tightens_x_and_a_long_o_less() -> None:
    near = {name: last(warm_shaft(pair(bearing__arrangement=name), 8.0)) for name in ("DB", "DF")}
    far = {
        name: last(warm_shaft(pair(bearing__arrangement=name, bearing__spacing="500 mm"), 8.0))
        for name in ("DB", "DF")
    }
    assert far["DB"] < 250.0 < near["DB"] < near["DF"] < far["DF"]


def test_o_and_x_are_mirror_images_along_the_shaft() -> None:
    def along(arrangement: str, inner: float, outer: float) -> float:
        case = pair(
            bearing__arrangement=arrangement,
            mounting__width="20 mm",
            temperature__inner_ring=293.15,
            temperature__outer_ring=293.15,
            temperature__inner_spacer=inner,
            temperature__outer_spacer=outer,
        )
        return last(case)

    assert along("DB", 303.15, 293.15) == pytest.approx(along("DF", 293.15, 303.15), rel=1e-9)
    assert along("DB", 293.15, 303.15) == pytest.approx(along("DF", 303.15, 293.15), rel=1e-9)
    assert along("DB", 303.15, 293.15) < 250.0 < along("DF", 303.15, 293.15)


def test_rows_listed_one_by_one_are_the_arrangement() -> None:
    case = warm_shaft(pair(), 5.0)
    rows = [
        {"orientation": "+", "position": "-20 mm"},
        {"orientation": "-", "position": "20 mm"},
    ]
    listed = case.with_(
        {"bearing.rows": rows, "bearing.arrangement": None, "bearing.spacing": None}
    )
    assert last(listed) == pytest.approx(last(case), rel=1e-9)
    moved = [{**row, "position": f"{float(row['position'].split()[0]) + 500.0} mm"} for row in rows]
    shifted = listed.with_({"bearing.rows": moved})
    assert last(shifted) == pytest.approx(last(case), rel=1e-6)


# --- many rows, springs --------------------------------------------------------------------------


def test_outer_rows_of_a_quadruplex_let_go_first() -> None:
    case = pair(
        bearing__arrangement="QBC",
        mounting__width="20 mm",
        temperature__inner_ring=293.15,
        temperature__outer_ring=293.15,
        temperature__inner_spacer=298.15,
    )
    e = preload_stages(case)[-1].offset
    assert e[0] == pytest.approx(e[3])
    assert e[1] == pytest.approx(e[2])
    step = 20e-3 * ALPHA * 5.0
    assert e[1] - e[0] == pytest.approx(step, rel=1e-6)


def test_a_tandem_shares_its_load_unevenly() -> None:
    case = pair(bearing__arrangement="DT", bearing__preload=None, duty__load__fx="600 N")
    even = solve(case).rows.load[0, :, 0]
    assert even == pytest.approx([300.0, 300.0], rel=1e-8)
    warm = case.with_(
        {
            "mounting.width": "20 mm",
            "temperature.inner_ring": 293.15,
            "temperature.outer_ring": 293.15,
            "temperature.inner_spacer": 303.15,
        }
    )
    found = solve(warm)
    first, second = found.rows.load[0, :, 0]
    assert first + second == pytest.approx(600.0, rel=1e-8)
    assert second > 1.3 * first  # its inner ring is moved on toward +x
    assert found.displacement.x[0] == pytest.approx(solve(case).displacement.x[0], rel=0.05)


def test_springs_keep_their_force_and_lose_contact_angle() -> None:
    case = pair(
        bearing__preload={"spring": "250 N"},
        duty__inner_speed="12000 rpm",
        mounting__shaft_interference="6 um",
        temperature__inner_ring="50 degC",
        temperature__outer_ring="40 degC",
    )
    found = preload_stages(case)
    assert [one.preload[1] for one in found] == pytest.approx([250.0] * 5, rel=1e-6)
    angles = [one.contact_angle[0] for one in found]
    assert angles == sorted(angles, reverse=True)
    assert angles[0] == pytest.approx(pi / 12.0)
    assert angles[-1] < 0.8 * angles[0]


# --- what is solved ------------------------------------------------------------------------------


HOT = {
    "duty__inner_speed": "8000 rpm",
    "duty__load__fz": "400 N",
    "mounting__shaft_tolerance": "js4",
    "mounting__housing_tolerance": "JS5",
    "mounting__tolerance_class": "P5",
    "temperature__inner_ring": "45 degC",
    "temperature__outer_ring": "38 degC",
}


@pytest.mark.parametrize("arrangement", ["DB", "TBT"])
@pytest.mark.thirds
def test_the_running_set_is_what_is_solved(arrangement: str) -> None:
    case = pair(bearing__arrangement=arrangement, **HOT)
    state = solve(case)
    assert state.converged[0]
    assert state.case == running_set(case)
    again = solve(state.case)
    assert again.displacement.array == pytest.approx(state.displacement.array, rel=1e-9, abs=1e-15)
    assert state.preload is not None
    assert again.preload is not None
    assert again.preload.at_speed == pytest.approx(state.preload.stages[-1].preload[1], rel=1e-6)
    assert state.preload.at_speed == again.preload.at_speed
    assert state.preload.at_rest == state.preload.stages[2].preload[1]  # mounted and warm


@pytest.mark.parametrize("limit", LIMITS)
@pytest.mark.thirds
def test_the_limit_that_the_mounting_names(limit: str) -> None:
    case = pair(**HOT, mounting__limit=limit)
    stages = preload_stages(case)
    loosest, mean, tightest = stages[-1].preload
    assert loosest < mean < tightest
    expected = stages[-1].preload[LIMITS.index(limit)]  # type: ignore[arg-type]
    found = solve(case).preload
    assert found is not None
    assert found.at_speed == pytest.approx(expected, rel=1e-6)


def test_the_result_comes_back_from_json() -> None:
    state = solve(pair(**HOT))
    text = state.to_json()
    read = Solved.from_json(text)
    assert repr(read.preload) == repr(state.preload)  # NaN is not itself
    assert read.to_json() == text
    broken = json.loads(text)
    broken["preload"]["stages"][0]["preload"] = [1.0]
    with pytest.raises(InputError, match="3 numbers"):
        Solved.from_json(json.dumps(broken))


VALUES = {
    "temperature.inner_ring": (303.0, 315.0, 325.0),
    "temperature.inner_spacer": (293.0, 313.0, 333.0),
    "temperature.outer_spacer": (293.0, 303.0, 308.0),
    "mounting.shaft_interference": (-2e-6, 3e-6, 6e-6),
    "mounting.wear": (0.0, 1e-6, 2e-6),
    "duty.inner_speed": (0.0, 500.0, 900.0),
    "duty.load.fz": (100.0, 400.0, 800.0),
    "bearing.contact_angle": (0.24, 0.26, 0.3),
    "bearing.spacing": (25e-3, 40e-3, 80e-3),
    "bearing.preload.force": (100.0, 250.0, 400.0),
    "bearing.preload.spring": (100.0, 250.0, 400.0),
}


@pytest.mark.parametrize("name", VALUES)
def test_each_case_of_a_batch_is_as_solved_alone(name: str) -> None:
    case = pair(**HOT, mounting__width="20 mm", bearing__arrangement="TBT")
    batch = solve(case, {name: np.array(VALUES[name])})
    assert list(batch.status.code) == ["converged"] * 3
    for index, value in enumerate(VALUES[name]):
        one = alone(case.with_({name: value}))
        assert batch.displacement.array[index] == pytest.approx(
            one.displacement.array[0], rel=1e-7, abs=1e-13
        )
        assert batch.rows.free_contact_angle[index] == pytest.approx(
            one.rows.free_contact_angle[0], rel=1e-9
        )
    assert batch.field(name) == pytest.approx(VALUES[name])


def test_a_case_without_a_free_angle_is_solved_in_a_batch_as_alone() -> None:
    interferences = [3e-6, 60e-6, 1e-3]
    batch = solve(pair(**HOT), {"mounting.shaft_interference": interferences})
    assert list(batch.status.code) == ["converged", "converged", "invalid_input"]
    for index, interference in enumerate(interferences[:2]):
        alone = solve(pair(**HOT).with_({"mounting.shaft_interference": interference}))
        largest = alone.inner.load.max()
        assert batch.inner.load[index] == pytest.approx(alone.inner.load[0], abs=1e-9 * largest)
    with pytest.raises(InputError, match="closes the bearing"):
        solve(pair(**HOT).with_({"mounting.shaft_interference": interferences[2]}))


def test_a_row_that_its_fits_close_still_has_its_clamped_offset() -> None:
    case = pair(mounting__shaft_interference="60 um")
    state = solve(case)
    assert state.converged[0]
    assert "no_free_angle" in {note.key for note in state.notes[0]}
    assert state.preload is not None
    assert state.preload.stages[-1].contact_angle == (0.0, 0.0)
    assert state.preload.at_speed > 10.0 * 250.0
    assert np.all(np.abs(state.inner.contact_angle) > 0.1)
    with pytest.raises(InputError, match="closes the bearing"):
        solve(pair(mounting__shaft_interference="1 mm"))


def test_deep_groove_pairs_clamped_against_each_other() -> None:
    case = pair(bearing__diametral_clearance="0.03 mm", bearing__contact_angle=None, **HOT)  # 30 µm
    found = preload_stages(case)
    assert found[0].preload[1] == pytest.approx(250.0, rel=1e-6)
    state = solve(case)
    assert state.converged[0]
    assert state.case == running_set(case)
    reach = (FI + FO - 1.0) * D
    assert found[0].contact_angle[0] == pytest.approx(acos(1.0 - 0.03e-3 / (2.0 * reach)))
    batch = solve(case, {"duty.load.fz": [400.0]})
    assert batch.displacement.array[0] == pytest.approx(state.displacement.array[0], rel=1e-7)


def test_play_is_no_preload() -> None:
    case = pair(bearing__spacing="600 mm", temperature__inner_ring=320.0,
                temperature__outer_ring=293.15, temperature__balls=293.15)  # fmt: skip
    found = preload_stages(case)[-1]
    assert found.preload == (0.0, 0.0, 0.0)
    keys = {note.key for note in mounted_clearance(case).notes}
    assert "preload_lost_mounted" in keys


def test_refused_by_name() -> None:
    single = pair(bearing__arrangement=None, bearing__spacing=None, bearing__preload=None)
    with pytest.raises(InputError, match="sets") as error:
        single.with_({"temperature.inner_ring": 300.0, "temperature.outer_ring": 300.0,
                      "temperature.inner_spacer": 300.0})  # fmt: skip
    assert error.value.field == "temperature.inner_spacer"
    row = {"orientation": "+", "position": "-20 mm", "offset": "5 um"}
    other = {"orientation": "-", "position": "20 mm"}
    with pytest.raises(InputError, match="preload given by its force") as error:
        pair(bearing__rows=[row, other], bearing__arrangement=None, bearing__spacing=None)
    assert error.value.field == "bearing.rows.0.offset"
    case = pair(temperature__inner_ring=320.0)
    with pytest.raises(InputError) as error:
        solve(case)
    assert error.value.field == "temperature.outer_ring"


# --- pages ---------------------------------------------------------------------------------------


def test_the_pages_show_the_stages() -> None:
    case = pair(**HOT)
    page = terminal(state_page(solve(case)))
    for word in ("before mounting", "mounted", "warm", "at speed", "loosest", "tightest"):
        assert word in page
    found = mounted_clearance(case)
    assert "Preload" in terminal(clearance_page(found))
    samples = mounted_samples(case, 100, 1)
    assert len(samples.clearance) == 100
    assert "sampled" in terminal(clearance_page(found, samples))


def test_the_command_answers_for_a_set(tmp_path: Path) -> None:
    app = program_of("running:ClearanceRequest", "clearance")
    path = tmp_path / "pair.toml"
    path.write_text(PAIR, encoding="utf-8")
    result = CliRunner().invoke(app, [str(path), "--json", "-"])
    assert result.exit_code == 0
    mapping = json.loads(result.stdout)
    assert [one["name"] for one in mapping["preload"]] == ["unmounted", "mounted"]
    assert mapping["preload"][1]["preload"][1] == pytest.approx(250.0, rel=1e-9)
    assert len(mapping["rows"]) == 1
    assert sqrt(mapping["mean"]) > 0.0


def test_the_preload_of_a_batch_is_that_of_each_mounted_case() -> None:
    case = pair(**HOT)
    batch = solve(case, {"mounting.shaft_interference": [0.0, 4e-6], "duty.inner_speed": 800.0})
    at_speed, at_rest = (preload_at(batch, running=which) for which in (True, False))
    factor = first_lift_off(batch).factor
    for index, interference in enumerate((0.0, 4e-6)):
        values = {"mounting.shaft_interference": interference, "duty.inner_speed": 800.0}
        single = case.with_(values)
        stages = {one.name: one.preload[1] for one in preload_stages(single)}
        assert at_speed[index] == pytest.approx(stages["at_speed"], rel=1e-6)
        assert at_rest[index] == pytest.approx(stages["warm"], rel=1e-6)
        found = solve(single).preload
        assert found is not None
        assert factor[index] == pytest.approx(found.lift_factor, rel=1e-5, nan_ok=True)
