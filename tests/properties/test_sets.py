"""Sets of rows against single bearings, put together by hand, and what must stay the same.

The hand calculation knows nothing of the package's matrices: a row is moved as a point of a rigid
body, mirrored as vectors and axial vectors are, solved alone with all five displacements held, and
its load is mirrored back and moved to the origin as a force and a couple.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.optimize import root

from rolamento import Bearing, Case, Duty, Model
from rolamento.case.arrangement import ARRANGEMENTS
from rolamento.case.duty import AXES, LOADS
from rolamento.solution import solve
from rolamento.solved import Solved

Floats = NDArray[np.float64]

ANGULAR: dict[str, Any] = {
    "ball_count": 16,
    "ball_diameter": "22.23 mm",
    "pitch_diameter": "125.26 mm",
    "contact_angle": "40 deg",
    "inner_conformity": 0.5232,
    "outer_conformity": 0.5232,
}
SPINDLE: dict[str, Any] = {
    "ball_count": 21,
    "ball_diameter": "9.525 mm",
    "pitch_diameter": "77.5 mm",
    "contact_angle": "15 deg",
    "inner_conformity": 0.53,
    "outer_conformity": 0.52,
    "ball_material": "Si3N4",
}
DEEP_GROOVE: dict[str, Any] = {
    "ball_count": 9,
    "ball_diameter": "12.7 mm",
    "pitch_diameter": "65 mm",
    "diametral_clearance": "0.02 mm",
    "inner_conformity": 0.52,
    "outer_conformity": 0.53,
}
CONTROLS = ["outer", "inner", "none"]
RPM = math.pi / 30.0


@pytest.fixture(scope="module", autouse=True)
def _compiled() -> None:
    """Load the compiled kernels first: few cases alone would run as plain Python, slowly."""
    solve(Case(bearing=Bearing(**ANGULAR), duty=Duty()), fx=np.full(100, 1e4), inner_speed=100.0)


def solved(
    bearing: Bearing,
    fields: Mapping[str, Any] | None = None,
    *,
    control: Any = "outer",
    converged: bool = True,
    **duty: Any,
) -> Solved:
    case = Case(bearing=bearing, duty=Duty(), model=Model(raceway_control=control))
    batch = solve(case, {**(fields or {}), **duty})
    assert not converged or batch.converged.all(), batch.status.code
    return batch


def by_axis(vector: Floats) -> dict[str, float]:
    return dict(zip(AXES, vector.tolist(), strict=True))


def arms(bearing: Bearing) -> Floats:
    """Lengths that make moments comparable with forces."""
    arm = 0.5 * bearing.pitch_diameter
    return np.array([1.0, 1.0, 1.0, arm, arm])


# --- by hand ---------------------------------------------------------------------------------


def mirrored(shift: Floats, turn: Floats) -> tuple[Floats, Floats]:
    """A vector and an axial vector seen in the plane x = 0."""
    mirror = np.diag([-1.0, 1.0, 1.0])
    return mirror @ shift, np.linalg.det(mirror) * mirror @ turn


def load_of_row(
    alone: Bearing,
    sign: int,
    position: float,
    press: float,
    displacement: Floats,
    *,
    control: Any = "outer",
    **speeds: float,
) -> Floats:
    """What a row asks of a shaft at this place: (fx, fy, fz, my, mz) about the origin."""
    arm = np.array([position, 0.0, 0.0])
    turn = np.array([0.0, *displacement[3:]])
    shift = displacement[:3] + np.cross(turn, arm)
    if sign < 0:
        shift, turn = mirrored(shift, turn)
    held = by_axis(np.array([shift[0] + press, *shift[1:], *turn[1:]]))
    load = solved(alone, control=control, **held, **speeds).load.array[0]
    force, moment = load[:3], np.array([0.0, *load[3:]])
    if sign < 0:
        force, moment = mirrored(force, moment)
    return np.array([*force, *(moment + np.cross(arm, force))[1:]])


def press_at_rest(alone: Bearing, force: float) -> float:
    return float(solved(alone, fx=force).displacement.array[0, 0])


RADIAL = {"fz": 3e3, "fy": -1e3}
PAIRS: dict[str, tuple[dict[str, Any], str, float, Any, dict[str, float]]] = {
    "DB, at rest": (ANGULAR, "DB", 5e3, "outer", {"fx": 2e3, **RADIAL}),
    "DB, fast": (ANGULAR, "DB", 5e3, "outer", {**RADIAL, "inner_speed": 900.0}),
    "DB, moments": (
        ANGULAR, "DB", 5e3, "none",
        {"fx": -3e3, **RADIAL, "my": 200.0, "mz": -90.0, "inner_speed": 600.0},
    ),
    "DF, moments": (
        ANGULAR, "DF", 5e3, "outer",
        {"fx": 3e3, **RADIAL, "my": 100.0, "mz": -90.0, "inner_speed": 600.0},
    ),
    "DF, tilted": (
        SPINDLE, "DF", 500.0, "outer", {"fx": 100.0, "fz": 200.0, "ry": 2e-4, "outer_speed": 900.0},
    ),
    "DB, one row lifted": (SPINDLE, "DB", 200.0, "outer", {"fx": 2e3, "fz": 100.0}),
    "DB, inner control": (SPINDLE, "DB", 500.0, "inner", {"fx": 200.0, "inner_speed": 1500.0}),
}  # fmt: skip
SPACING = 0.04


@pytest.mark.parametrize("name", PAIRS)
def test_a_pair_is_two_single_bearings_on_one_shaft(name: str) -> None:
    geometry, arrangement, force, control, duty = PAIRS[name]
    alone = Bearing(**geometry)
    pair = Bearing(**geometry, arrangement=arrangement, spacing=SPACING, preload={"force": force})
    batch = solved(pair, control=control, **duty)
    press = press_at_rest(alone, force)
    speeds = {key: value for key, value in duty.items() if key.endswith("speed")}
    total = np.zeros(5)
    scale = 0.0
    signs = {"DB": (1, -1), "DF": (-1, 1)}[arrangement]
    for row, sign, place in zip(batch.rows.load[0], signs, (-0.5, 0.5), strict=True):
        load = load_of_row(
            alone,
            sign,
            place * SPACING,
            press,
            batch.displacement.array[0],
            control=control,
            **speeds,
        )
        scale = max(scale, float(np.abs(load / arms(alone)).max()))
        assert np.abs((row - load) / arms(alone)).max() <= 1e-8 * max(scale, force)
        total += load
    error = (total - batch.load.array[0]) / arms(alone)
    assert np.abs(error).max() <= 2e-8 * scale
    for name_of_load in LOADS:
        if name_of_load in duty:
            given_load = duty[name_of_load]
            assert batch.load.array[0, LOADS.index(name_of_load)] == given_load


@pytest.mark.parametrize("name", ["DB, moments", "DF, moments"])
def test_the_pairs_place_is_the_one_that_scipy_finds_over_single_bearings(name: str) -> None:
    geometry, arrangement, force, control, duty = PAIRS[name]
    alone = Bearing(**geometry)
    press = press_at_rest(alone, force)
    signs = {"DB": (1, -1), "DF": (-1, 1)}[arrangement]
    wanted = np.array([duty.get(load, 0.0) for load in LOADS])
    scale = arms(alone)

    def unbalanced(scaled: Floats) -> Floats:
        loads = [
            load_of_row(
                alone,
                sign,
                place * SPACING,
                press,
                1e-6 * scaled / scale,
                control=control,
                inner_speed=duty["inner_speed"],
            )
            for sign, place in zip(signs, (-0.5, 0.5), strict=True)
        ]
        return np.asarray((sum(loads) - wanted) / scale)

    found = root(unbalanced, np.zeros(5), tol=1e-11)
    assert np.abs(unbalanced(found.x)).max() < 1e-4  # N
    pair = Bearing(**geometry, arrangement=arrangement, spacing=SPACING, preload={"force": force})
    batch = solved(pair, control=control, **duty)
    assert np.abs(1e6 * scale * batch.displacement.array[0] - found.x).max() < 1e-6  # picometres


def test_a_spring_loaded_pair_by_hand() -> None:
    """Each row's own equilibrium: F on the one, F + fx on the other, whatever the speed."""
    alone = Bearing(**SPINDLE)
    pair = Bearing(**SPINDLE, arrangement="DB", spacing=SPACING, preload={"spring": 300.0})
    batch = solved(pair, fx=[-200.0, 0.0, 500.0], inner_speed=1500.0)
    front = solved(alone, fx=[100.0, 300.0, 800.0], inner_speed=1500.0)
    assert batch.displacement.array[:, 0] == pytest.approx(front.displacement.array[:, 0], rel=1e-7)
    back = solved(alone, fx=300.0, inner_speed=1500.0)
    approach = back.inner.load
    assert np.allclose(batch.answer.rows[1].tables().inner.load, approach, rtol=1e-7)
    assert batch.rows.load[:, 0, 0] == pytest.approx([100.0, 300.0, 800.0], rel=1e-9)
    assert batch.rows.load[:, 1, 0] == pytest.approx([-300.0] * 3, rel=1e-9)
    # the springs follow: axially, the front row alone resists
    assert batch.stiffness.array[:, 0, 0] == pytest.approx(front.stiffness.array[:, 0, 0], rel=1e-6)


# --- stiffness -------------------------------------------------------------------------------

FIVE = Bearing(
    **SPINDLE,
    arrangement="TBT",
    spacing=0.025,
    preload={"force": 700.0},
)
PLACES: dict[str, tuple[Bearing, dict[str, float]]] = {
    "TBT at rest": (FIVE, {"fx": 300.0, "fz": 250.0, "my": 6.0, "mz": 2.0}),
    "TBT fast": (FIVE, {"fx": -200.0, "fy": 250.0, "my": 3.0, "mz": 2.0, "inner_speed": 1800.0}),
    "TBT spring": (
        FIVE.replace(preload={"spring": 700.0}),
        {"fx": 200.0, "fy": 150.0, "my": 3.0, "mz": 2.0, "inner_speed": 1200.0},
    ),
    "DF fast": (
        Bearing(**ANGULAR, arrangement="DF", spacing=0.04, preload={"offset": 20e-6}),
        {"fx": 900.0, "fy": 2e3, "my": 50.0, "mz": 20.0, "inner_speed": 700.0},
    ),
    "deep-groove pair": (
        Bearing(**DEEP_GROOVE, arrangement="DB", spacing=0.03, preload={"force": 400.0}),
        {"fx": 200.0, "fz": 900.0, "my": 6.0, "mz": 2.0, "inner_speed": 300.0},
    ),
}
WEIGHTS = {-2: 1.0 / 12.0, -1: -2.0 / 3.0, 1: 2.0 / 3.0, 2: -1.0 / 12.0}


def _derivative(bearing: Bearing, at: dict[str, float], names: Any, steps: Floats) -> Any:
    """Five-point differences of a batch's fields by each of five inputs."""
    fields = {key: np.full(20, value) for key, value in at.items()}
    weights = np.tile(list(WEIGHTS.values()), 5)
    for i, name in enumerate(names):
        fields[name][4 * i : 4 * i + 4] += steps[i] * np.array(list(WEIGHTS))
    batch = solved(bearing, **fields)

    def of(array: Floats) -> Floats:
        weighted = (weights[:, np.newaxis] * array).reshape(5, 4, -1).sum(axis=1)
        return np.asarray((weighted / steps[:, np.newaxis]).T)

    return batch, of


@pytest.mark.parametrize("name", PLACES)
def test_stiffness_is_the_derivative_both_ways(name: str) -> None:
    bearing, duty = PLACES[name]
    duty = dict.fromkeys(LOADS, 0.0) | duty
    batch = solved(bearing, **duty)
    stiffness = batch.stiffness.array[0]
    speeds = {key: value for key, value in duty.items() if key.endswith("speed")}
    scale = arms(bearing)
    size = np.abs(stiffness / np.outer(scale, scale)).max()

    steps = 2e-8 / scale
    held, of = _derivative(bearing, by_axis(batch.displacement.array[0]) | speeds, AXES, steps)
    error = (of(held.load.array) - stiffness) / np.outer(scale, scale)
    assert np.abs(error).max() <= 2e-5 * size

    steps = np.abs(0.01 * size * 1e-6 * scale)
    loaded, of = _derivative(bearing, duty, LOADS, steps)
    product = stiffness @ of(loaded.displacement.array)
    error = (product - np.eye(5)) * np.outer(1.0 / scale, scale)
    assert np.abs(error).max() <= 2e-4


@pytest.mark.parametrize("name", PLACES)
def test_stiffness_at_rest_is_nearly_symmetrical(name: str) -> None:
    """But for the slight turning of the contacts' stiffness, as in a single bearing."""
    bearing, duty = PLACES[name]
    still = {key: value for key, value in duty.items() if not key.endswith("speed")}
    stiffness = solved(bearing, **still).stiffness.array[0] / np.outer(arms(bearing), arms(bearing))
    assert np.abs(stiffness - stiffness.T).max() <= 1e-5 * np.abs(stiffness).max()
    assert np.linalg.eigvalsh(0.5 * (stiffness + stiffness.T)).min() > 0.0


# --- what the arrangement does ----------------------------------------------------------------


def _pairs(arrangement: str, spacing: Any) -> Solved:
    pair = Bearing(**SPINDLE, arrangement=arrangement, spacing=0.04, preload={"force": 500.0})
    return solved(pair, {"bearing.spacing": spacing}, fx=0.0)


def test_back_to_back_is_stiffer_in_tilt_and_alike_otherwise() -> None:
    back, face = _pairs("DB", 0.02).stiffness.array[0], _pairs("DF", 0.02).stiffness.array[0]
    for i in range(3):
        assert back[i, i] == pytest.approx(face[i, i], rel=1e-8)
    for i in (3, 4):
        assert back[i, i] > 2.0 * face[i, i]


@pytest.mark.parametrize(("arrangement", "sign"), [("DB", 1.0), ("DF", -1.0)])
def test_tilt_stiffness_grows_with_the_square_of_the_distance_of_the_pressure_centres(
    arrangement: str, sign: float
) -> None:
    """K_tilt = ¼ K_zz (s + s0)² + c with s0 about ± d_m tan α: exactly quadratic in s."""
    spacing = np.array([0.02, 0.04, 0.08, 0.3, 1.0])
    batch = _pairs(arrangement, spacing)
    tilt = batch.stiffness.array[:, 3, 3]
    square, linear, constant = np.polyfit(spacing[:3], tilt[:3], 2)
    assert np.polyval([square, linear, constant], spacing) == pytest.approx(tilt, rel=1e-6)
    assert square == pytest.approx(0.25 * batch.stiffness.array[0, 2, 2], rel=1e-6)
    apart = 0.5 * linear / square
    loaded = float(np.mean(batch.answer.rows[0].tables().inner.angle.value[0]))
    # the contacts' arm is the circle of the groove's centres, a little less than d_m / 2
    assert apart == pytest.approx(sign * 77.5e-3 * math.tan(loaded), rel=0.02)
    # what is left does not hang on the offsets: the rows' own bending, small
    assert 0.0 < constant - square * apart**2 < 0.2 * square * apart**2


def test_two_in_tandem_are_twice_one_under_half_the_load() -> None:
    """With the tilts held: free, a radial load would turn the ring about the loaded side."""
    alone = Bearing(**ANGULAR)
    tandem = Bearing(**ANGULAR, arrangement="DT", spacing=0.04)
    duty: dict[str, Any] = {"inner_speed": [0.0, 900.0]}
    one = solved(alone, fx=10e3, fy=2e3, fz=4e3, **duty)
    two = solved(tandem, fx=20e3, fy=4e3, fz=8e3, **duty)
    assert two.displacement.array == pytest.approx(one.displacement.array, rel=1e-7, abs=1e-14)
    assert two.load.array == pytest.approx(2.0 * one.load.array, rel=1e-7, abs=1e-5)
    block = np.ix_([0, 1], range(3), range(3))
    assert two.stiffness.array[block] == pytest.approx(2.0 * one.stiffness.array[block], rel=1e-5)
    free = solved(tandem, fx=20e3, fy=4e3, fz=8e3, my=0.0, mz=0.0)
    assert abs(free.displacement.array[0, 3]) > 1e-5
    one_free = solved(alone, fx=10e3, fy=2e3, fz=4e3, my=0.0, mz=0.0)
    assert abs(free.displacement.array[0, 3]) < 0.5 * abs(one_free.displacement.array[0, 3])


# --- what must stay the same ------------------------------------------------------------------

MIRROR = np.array([-1.0, 1.0, 1.0, -1.0, -1.0])


@pytest.mark.parametrize("control", CONTROLS)
@pytest.mark.parametrize("arrangement", ["DB", "DF", "TBT", "QFC", "QBT"])
def test_a_set_turned_around_answers_turned_around(arrangement: Any, control: Any) -> None:
    spacing = 0.025
    plain = Bearing(**SPINDLE, arrangement=arrangement, spacing=spacing, preload={"force": 800.0})
    signs = ARRANGEMENTS[arrangement]
    turned = Bearing(
        **SPINDLE,
        rows=[
            {
                "orientation": "-" if sign == "+" else "+",
                "position": -spacing * (i - 0.5 * (len(signs) - 1)),
            }
            for i, sign in enumerate(signs)
        ],
        preload={"force": 800.0},
    )
    load = np.array([250.0, -100.0, 200.0, 4.0, -2.0])
    speed = {"inner_speed": 900.0} if control != "inner" else {"inner_speed": 200.0}
    one = solved(plain, control=control, **dict(zip(LOADS, load, strict=True)), **speed)
    other = solved(turned, control=control, **dict(zip(LOADS, MIRROR * load, strict=True)), **speed)
    assert other.displacement.array[0] == pytest.approx(
        MIRROR * one.displacement.array[0], rel=1e-6, abs=1e-13
    )
    for here, there in zip(one.rows.load[0], other.rows.load[0], strict=True):
        assert there == pytest.approx(MIRROR * here, rel=1e-6, abs=1e-5)
    stiffness = np.outer(MIRROR, MIRROR) * one.stiffness.array[0]
    assert other.stiffness.array[0] == pytest.approx(
        stiffness, rel=1e-5, abs=1e-5 * stiffness.max()
    )


@settings(max_examples=25)
@given(
    turn=st.integers(-25, 25),
    arrangement=st.sampled_from(["DB", "DF", "TBT", "DT"]),
    radial=st.floats(10.0, 300.0),
    speed=st.sampled_from([0.0, 300.0, 1500.0]),
)
def test_turned_by_whole_pitches_a_set_answers_turned(
    turn: int, arrangement: Any, radial: float, speed: float
) -> None:
    two_sided = len(set(ARRANGEMENTS[arrangement])) > 1
    bearing = Bearing(
        **SPINDLE,
        arrangement=arrangement,
        spacing=0.03,
        preload={"force": 600.0} if two_sided else None,
    )
    angle = 2.0 * math.pi * turn / bearing.ball_count
    c, s = math.cos(angle), math.sin(angle)
    # z toward y, in the plane of (y, z) and in that of (ry, rz) alike
    rotation = np.eye(5)
    for y, z in ((1, 2), (3, 4)):
        rotation[np.ix_([y, z], [y, z])] = [[c, s], [-s, c]]
    load = np.array([400.0, 0.3 * radial, radial, 1.0, -2.0])
    turned = rotation @ load
    fields = {name: [load[i], turned[i], load[i]] for i, name in enumerate(LOADS)}
    batch = solved(
        bearing, **fields, inner_speed=speed, first_ball_azimuth=[0.3, 0.3, 0.3 + angle % 1e-9]
    )
    scaled = batch.displacement.array * arms(bearing)
    size = np.abs(scaled).max()
    assert np.abs(scaled[1] - rotation @ scaled[0]).max() <= 1e-7 * size


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("speed", [0.0, 900.0])
def test_one_row_elsewhere_is_the_plain_bearing_from_another_point(sign: int, speed: float) -> None:
    position = 0.055
    orientation = "+" if sign > 0 else "-"
    moved = Bearing(**ANGULAR, rows=[{"orientation": orientation, "position": position}])
    alone = Bearing(**ANGULAR)
    force = np.array([sign * 20e3, 2e3, 5e3])
    couple = np.array([0.0, 40.0, -30.0])
    arm = np.array([position, 0.0, 0.0])
    at_origin = couple + np.cross(arm, force)
    load = np.array([*force, *at_origin[1:]])
    batch = solved(moved, **dict(zip(LOADS, load, strict=True)), inner_speed=speed)
    own_force, own_couple = (force, couple) if sign > 0 else mirrored(force, couple)
    own = np.array([*own_force, *own_couple[1:]])
    plain = solved(alone, **dict(zip(LOADS, own, strict=True)), inner_speed=speed)
    shift, turn = plain.displacement.array[0, :3], np.array([0.0, *plain.displacement.array[0, 3:]])
    if sign < 0:
        shift, turn = mirrored(shift, turn)
    expected = np.array([*(shift - np.cross(turn, arm)), *turn[1:]])
    assert batch.displacement.array[0] == pytest.approx(expected, rel=1e-7, abs=1e-13)
    assert batch.inner.load == pytest.approx(plain.inner.load, rel=1e-6)


def test_a_row_at_the_origin_is_the_plain_bearing() -> None:
    plain = solved(Bearing(**ANGULAR), fx=20e3, fz=15e3, inner_speed=900.0)
    same = solved(Bearing(**ANGULAR, rows=[{"position": 0.0}]), fx=20e3, fz=15e3, inner_speed=900.0)
    assert np.array_equal(same.displacement.array, plain.displacement.array)


def test_a_rows_phase_turns_its_balls() -> None:
    phase = 0.11
    row = {"position": 0.0, "phase": phase}
    set_of_one = Bearing(**ANGULAR, rows=[row])
    batch = solved(set_of_one, fx=20e3, fz=15e3, inner_speed=900.0, first_ball_azimuth=0.2)
    plain = solved(
        Bearing(**ANGULAR), fx=20e3, fz=15e3, inner_speed=900.0, first_ball_azimuth=0.2 + phase
    )
    assert batch.displacement.array == pytest.approx(plain.displacement.array, rel=1e-12, abs=1e-20)
    assert batch.elements.azimuth[0, 0] == pytest.approx(0.2 + phase)


def test_unequal_rows_by_hand() -> None:
    """An offset of the rings presses each row in, whatever its geometry."""
    own = {"ball_count": 12, "ball_diameter": "12 mm", "contact_angle": "25 deg"}
    bearing = Bearing(
        **SPINDLE,
        rows=[
            {"orientation": "+", "position": "-30 mm"},
            {"orientation": "-", "position": "10 mm", **own},
            {"orientation": "-", "position": "45 mm"},
        ],
        preload={"offset": "8 um"},
    )
    batch = solved(bearing, fx=100.0, fz=150.0, my=2.0, mz=1.0, inner_speed=1000.0)
    singles = [Bearing(**SPINDLE), Bearing(**(SPINDLE | own)), Bearing(**SPINDLE)]
    total = np.zeros(5)
    for alone, sign, place in zip(singles, (1, -1, -1), (-0.03, 0.01, 0.045), strict=True):
        total += load_of_row(
            alone, sign, place, 8e-6, batch.displacement.array[0], inner_speed=1000.0
        )
    assert total / arms(bearing) == pytest.approx(batch.load.array[0] / arms(bearing), abs=1e-4)
    assert batch.inner.load.shape == (1, 21 + 12 + 21)
    assert batch.elements.row.tolist() == [0] * 21 + [1] * 12 + [2] * 21


def test_jones_names_the_race_in_each_row_as_in_a_single_bearing() -> None:
    pair = Bearing(**ANGULAR, arrangement="DB", spacing=0.04, preload={"spring": 4e3})
    fx = [0.0, 6e3, 60e3]
    both = solved(pair, control="jones", fx=fx, inner_speed=300.0)
    front = solved(Bearing(**ANGULAR), control="jones", fx=np.array(fx) + 4e3, inner_speed=300.0)
    back = solved(Bearing(**ANGULAR), control="jones", fx=4e3, inner_speed=300.0)
    control = both.elements.raceway_control
    assert control.shape == (3, 32)
    assert np.array_equal(control[:, :16], front.elements.raceway_control)
    assert (control[:, 16:] == back.elements.raceway_control).all()
    assert len(set(control.ravel().tolist())) > 1  # both races are in control somewhere


# --- whatever the set and the load ------------------------------------------------------------

STATUSES = {"converged", "no_equilibrium", "not_converged", "overloaded", "unconstrained_ball"}
PROMISED = 1e-8
SETS, EACH = 36, 24
WITHOUT_RESULT = 0.02


def random_set(rng: np.random.Generator) -> tuple[Bearing, float]:
    """A set of any kind, and the force that loads it well."""
    count = int(rng.choice([3, 5, 8, 12, 16, 21, 30]))
    diameter = 1e-3 * float(np.exp(rng.uniform(np.log(3.0), np.log(40.0))))
    least = max(diameter / math.sin(math.pi / count), 2.5 * diameter)
    inner, outer = (float(f) for f in np.round(rng.uniform(0.505, 0.58, 2), 4))
    shape: dict[str, Any]
    if rng.random() < 0.7:
        shape = {"contact_angle": float(np.radians(rng.choice([0, 12, 15, 25, 30, 40])))}
    else:
        distance = diameter * (inner + outer - 1.0)
        shape = {"diametral_clearance": float(distance * rng.uniform(-0.03, 0.4))}
    bearing = Bearing(
        ball_count=count,
        ball_diameter=diameter,
        pitch_diameter=least * float(rng.uniform(1.01, 1.8)),
        inner_conformity=inner,
        outer_conformity=outer,
        ball_material=str(rng.choice(["100Cr6", "Si3N4"])),
        arrangement=str(rng.choice(list(ARRANGEMENTS))),
        spacing=float(diameter * rng.uniform(0.8, 6.0)),
        **shape,
    )
    return bearing, 4e7 * count * diameter**2


def random_duties(rng: np.random.Generator, bearing: Bearing, rating: float) -> dict[str, Floats]:
    fields: dict[str, Floats] = {}
    two_sided = len({place.sign for place in bearing.places}) > 1
    kind = str(rng.choice(["", "force", "offset", "spring"]))
    if kind == "offset" and two_sided:
        size = bearing.ball_diameter * 10.0 ** rng.uniform(-5.0, -2.7, EACH)
        fields["bearing.preload.offset"] = size * rng.choice([-1.0, 1.0], EACH, p=[0.2, 0.8])
    elif kind and two_sided:
        fields[f"bearing.preload.{kind}"] = rating * 10.0 ** rng.uniform(-3.5, -1.0, EACH)
    size = 0.3 * rating * 10.0 ** rng.uniform(-4.0, 0.0, EACH)
    fields["fx"] = size * rng.choice([0.0, 1.0, -1.0], EACH)
    fields["fz"] = size * rng.normal(size=EACH) * rng.choice([0.0, 1.0], EACH)
    fields["fy"] = 0.3 * size * rng.normal(size=EACH)
    if rng.random() < 0.5:
        fields["my"], fields["mz"] = size * bearing.ball_diameter * rng.normal(size=(2, EACH))
    speed = 10.0 ** rng.uniform(3.0, 6.2, EACH) / (1e3 * bearing.pitch_diameter) * RPM
    fields["inner_speed"] = speed * rng.choice([0.0, 1.0], EACH)
    return fields


def test_random_sets_have_a_result_that_holds_or_a_name_for_why_not() -> None:
    rng = np.random.default_rng(16)
    without, still_without = 0, 0
    for number in range(SETS):
        bearing, rating = random_set(rng)
        fields = random_duties(rng, bearing, rating)
        control = ("outer", "none", "jones")[number % 3]
        batch = solved(bearing, fields, control=control, converged=False)
        assert set(batch.status.code.tolist()) <= STATUSES
        good = batch.converged
        wanted = np.stack([np.broadcast_to(fields.get(n, 0.0), EACH) for n in LOADS], axis=1)
        free = np.array([True] * 3 + ["my" in fields] * 2)
        rows = np.swapaxes(batch.rows.load, 0, 1) / arms(bearing)
        scale = np.maximum(
            np.abs(rows).max(axis=(0, 2)), np.abs(wanted / arms(bearing))[:, free].max(axis=1)
        )
        error = np.abs(rows.sum(axis=0) - wanted / arms(bearing))[:, free].max(axis=1)
        assert (error[good] <= PROMISED * scale[good]).all()
        assert (batch.status.residual[good] <= PROMISED).all()
        for array in (
            batch.displacement.array,
            batch.load.array,
            batch.stiffness.array,
            rows.swapaxes(0, 1),
        ):
            finite = np.isfinite(array).reshape(EACH, -1)
            assert finite[good].all()
            assert not finite[~good].any()
        lost = batch.status.code == "not_converged"
        without += int(lost.sum())
        still_without += int((lost & (fields["inner_speed"] == 0.0)).sum())
    assert without <= WITHOUT_RESULT * SETS * EACH
    assert still_without == 0  # at rest the energy is convex, and every set comes home
