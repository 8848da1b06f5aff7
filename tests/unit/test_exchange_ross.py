"""Bearing elements and rotors for ROSS."""

from __future__ import annotations

import ast
import sys
import tomllib
import warnings
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest

import rolamento
from rolamento.case.machine import Machine, load_machine
from rolamento.errors import InputError
from rolamento.exchange.ross import RossBearing, bearing_file, ross_bearings, ross_script
from rolamento.machines import shaft
from rolamento.rotors import supports
from rolamento.solved.maps import MapAxis, StiffnessMap
from rolamento.tasks.maps import mapped, read_subject

MACHINES = Path(rolamento.__file__).parent / "examples" / "machines"
KEYS = {
    "n", "tag", "scale_factor", "color",
    *(letter + pair for letter in "kcm" for pair in ("xx", "xy", "yx", "yy", "zz")),
}  # fmt: skip
"""Of a bearing element as ROSS 2.3.0 saves it, but for its axis."""


def map_of(stiffness: np.ndarray, name: str = "A", speeds: int = 7) -> StiffnessMap:
    return StiffnessMap(
        name, (MapAxis("duty.inner_speed", "rad/s", np.linspace(0.0, 100.0, speeds)),),
        np.broadcast_to(stiffness, (speeds, 5, 5)), np.zeros((speeds, 5)), np.zeros((speeds, 5)),
        np.full(speeds, "converged"),
    )  # fmt: skip


def springs(places: list[float], y: float, z: float) -> np.ndarray:
    """The stiffness of springs across a shaft at some places, of all of them y and z."""
    k = np.zeros((5, 5))
    for place in places:
        seen = np.array([[0.0, 1.0, 0.0, 0.0, place], [0.0, 0.0, 1.0, -place, 0.0]])
        k += seen.T @ np.diag([y, z]) @ seen / len(places)
    return k


# --- elements -------------------------------------------------------------------------------------


@pytest.mark.parametrize(("version", "axis"), [(2, "frequency"), (3, "speed")])
def test_a_file_has_what_ross_saves(version: int, axis: str) -> None:
    k = np.arange(25.0).reshape(5, 5)
    (table,) = tomllib.loads(bearing_file(ross_bearings([map_of(k)]), version)).values()
    assert set(table) == {*KEYS, axis}
    assert {len(value) for value in table.values() if isinstance(value, list)} == {7}
    assert table[axis][-1] == 100.0


def test_y_and_z_are_its_x_and_y_and_x_its_z() -> None:
    k = np.arange(25.0).reshape(5, 5)
    text = bearing_file(ross_bearings([map_of(k)]), 3, damping=1e-5)
    table = tomllib.loads(text)["BearingElement_A"]
    for pair, (row, column) in {
        "xx": (1, 1), "xy": (1, 2), "yx": (2, 1), "yy": (2, 2), "zz": (0, 0),
    }.items():  # fmt: skip
        assert table[f"k{pair}"] == [k[row, column]] * 7
        assert table[f"c{pair}"] == pytest.approx([1e-5 * k[row, column]] * 7)


def test_what_is_left_out_is_named_with_its_size() -> None:
    k = np.diag([3.0, 4.0, 5.0, 6.0, 7.0])
    k[0, 2], k[2, 4] = 11.0, -12.0
    (one,) = ross_bearings([map_of(k)])
    assert one.left_out == (11.0, 12.0, 7.0)
    assert "A: 11 N/m, 12 N/rad, 7 N m/rad" in bearing_file([one], 3)


def test_two_elements_resist_tilt_as_the_bearing_does() -> None:
    k = springs([-0.011, 0.025], 2e8, 3e8)
    first, second = ross_bearings([map_of(k)], levers=True)
    assert (first.position, second.position) == pytest.approx((-0.011, 0.025))
    assert first.stiffness[0] == pytest.approx(np.diag([1e8, 1.5e8, 0.0]))
    assert np.abs(first.left_out) == pytest.approx((0.0, 0.0, 0.0), abs=1e-6)


def test_a_bearing_without_tilt_stiffness_stays_one_element() -> None:
    (one,) = ross_bearings([map_of(springs([0.004], 2e8, 3e8))], levers=True)
    assert [note.key for note in one.notes] == ["ross_no_lever"]


@pytest.mark.parametrize(
    ("one", "rule"),
    [
        (map_of(np.eye(5), speeds=6), "points = 6: must be at least 7"),
        (
            StiffnessMap(
                "A", (MapAxis("duty.load.fx", "N", np.arange(7.0)),), np.zeros((7, 5, 5)),
                np.zeros((7, 5)), np.zeros((7, 5)), np.full(7, "converged"),
            ),
            "must be a speed",
        ),
        (
            StiffnessMap(
                "A", (MapAxis("duty.inner_speed", "rad/s", np.arange(7.0)),),
                np.zeros((7, 5, 5)), np.zeros((7, 5)), np.zeros((7, 5)),
                np.array(["converged"] * 6 + ["no_equilibrium"]),
            ),
            "has no equilibrium at 57.2958 rpm",
        ),
    ],
)  # fmt: skip
def test_what_ross_cannot_take_is_refused(one: StiffnessMap, rule: str) -> None:
    with pytest.raises(InputError, match=rule):
        ross_bearings([one])


def over_speeds(*speeds: float) -> StiffnessMap:
    k = np.arange(len(speeds) * 25.0).reshape(-1, 5, 5)
    zero = np.zeros((len(speeds), 5))
    axis = MapAxis("duty.inner_speed", "rad/s", np.array(speeds))
    return StiffnessMap("A", (axis,), k, zero, zero, np.full(len(speeds), "converged"))


def test_speeds_that_fall_are_turned_round() -> None:
    (one,) = ross_bearings([over_speeds(60, 50, 40, 30, 20, 10, 0)])
    assert one.speed.tolist() == [0, 10, 20, 30, 40, 50, 60]
    assert one.stiffness[0, 2, 2] == 150.0


@pytest.mark.parametrize("speeds", [(-30, -20, -10, 0, 10, 20, 30), (0, 1, 2, 3, 4, 4, 5)])
def test_speeds_below_zero_or_twice_are_refused(speeds: tuple[float, ...]) -> None:
    with pytest.raises(InputError, match="must rise from 0 or more"):
        ross_bearings([over_speeds(*speeds)])


def test_other_versions_are_refused() -> None:
    with pytest.raises(InputError, match="must be one of 2, 3"):
        bearing_file(ross_bearings([map_of(np.eye(5))]), 4)


# --- what holds a shaft ---------------------------------------------------------------------------

ON_SPRINGS = """
[[shafts]]
name = "shaft"
speed = "1500 rpm"
sections = [{ length = "200 mm", diameter = "30 mm" }]
[[bearings]]
name = "A"
shaft = "shaft"
position = "20 mm"
designation = "6206"
housing = "wall"
[[bearings]]
name = "B"
shaft = "shaft"
position = "180 mm"
designation = "NU206"
[[loads]]
shaft = "shaft"
position = "120 mm"
fz = "-2 kN"
fx = "200 N"
[[housings]]
name = "wall"
stiffness = [STIFFNESS]
units = "N/mm"
"""


def on_housing(stiffness: str) -> Machine:
    return Machine.from_toml(ON_SPRINGS.replace("STIFFNESS", stiffness))


def test_a_housing_is_in_series_with_its_bearing() -> None:
    machine = on_housing("5e4, 4e4, 6e4, 1e6, 1e6")
    (support, _), solved = supports(machine, [157.07963267948966]), shaft(machine)
    own = solved.bearings["A"].solved.stiffness.array[0]
    under = machine.housing("wall").stiffness_matrix
    series = own - own @ np.linalg.solve(own + under, own)
    assert support.stiffness[0] == pytest.approx(series, rel=1e-9, abs=1e-6 * series.max())
    assert support.force[0] == pytest.approx(solved.bearings["A"].force[0], rel=1e-8)


def test_a_rigid_housing_is_none() -> None:
    (held, _) = supports(on_housing("1e13, 1e13, 1e13"), [100.0])
    free = Machine.from_toml(
        ON_SPRINGS.replace('housing = "wall"', "").replace("STIFFNESS", "1, 1, 1")
    )
    (rigid, _) = supports(free, [100.0])
    assert held.stiffness == pytest.approx(rigid.stiffness, rel=1e-5, abs=1e-3)


def test_a_ring_that_slides_holds_nothing_along_its_shaft() -> None:
    machine = load_machine(MACHINES / "motor.toml")
    (free, fixed) = supports(machine, [100.0])
    assert free.stiffness[0, 0] == pytest.approx(np.zeros(5), abs=1e-3)
    assert fixed.stiffness[0, 0, 0] > 1e6
    assert not any(one.notes for one in (free, fixed))


def test_a_housing_in_common_is_said_to_couple_its_bearings() -> None:
    keys = {note.key for one in supports(load_machine(MACHINES / "coaxial.toml"), [90.0])
            for note in one.notes}  # fmt: skip
    machine = load_machine(MACHINES / "three_supports.toml")
    tables = machine.to_mapping()
    tables["housings"] = [{
        "name": "wall", "bearings": ["left", "right"], "units": "N/m",
        "matrix": (np.kron(np.array([[3.0, -1.0], [-1.0, 3.0]]), np.eye(5)) * 1e8).tolist(),
    }]  # fmt: skip
    for bearing in tables["bearings"]:
        bearing.pop("housing", None)
    left, middle, right = supports(Machine.from_mapping(tables), [60.0])
    assert keys == set()
    assert [len(one.notes) for one in (left, middle, right)] == [1, 0, 1]
    assert left.notes[0].values["stiffness"] == pytest.approx(1e8)


# --- scripts --------------------------------------------------------------------------------------


class Recorded(SimpleNamespace):
    """What a script makes, by the keywords that it gives."""


def run(text: str) -> dict[str, Any]:
    """Run a script with something in the place of ROSS that keeps what it is given."""
    ross = ModuleType("ross")
    ross.__version__ = "3.0.0"  # type: ignore[attr-defined]

    def made(kind: str) -> Any:
        return lambda *given, **named: Recorded(kind=kind, given=given, **named)

    for kind in ("Material", "ShaftElement", "DiskElement", "BearingElement", "Rotor",
                 "CoAxialRotor"):  # fmt: skip
        setattr(ross, kind, made(kind))
    names: dict[str, Any] = {"__name__": "rotor"}
    before = sys.modules.get("ross")
    sys.modules["ross"] = ross
    try:
        exec(compile(text, "rotor.py", "exec"), names)
    finally:
        sys.modules.pop("ross")
        if before is not None:
            sys.modules["ross"] = before
    return names


def script_of(name: str, *, levers: bool = False) -> tuple[Machine, tuple[RossBearing, ...], str]:
    subject = read_subject(str(MACHINES / name))
    found = mapped(subject, points=7, with_housing=True)
    assert found.machine is not None
    elements = ross_bearings(found.maps, found.machine, levers=levers)
    return found.machine, elements, ross_script(found.machine, elements)


@pytest.mark.parametrize("levers", [False, True])
def test_a_rotor_has_its_bearings_where_the_machine_has_them(levers: bool) -> None:
    machine, elements, text = script_of("spindle.toml", levers=levers)
    (rotor,) = run(text)["rotors"]
    shafts, disks, bearings = rotor.given
    ends = np.concatenate([[0.0], np.cumsum([one.L for one in shafts])])
    assert ends[-1] == pytest.approx(machine.shafts[0].length)
    assert [ends[one.n] for one in bearings] == pytest.approx([one.position for one in elements])
    assert len(bearings) == (4 if levers else 2)
    assert disks == []
    assert bearings[0].speed == elements[0].speed.tolist()


def test_coaxial_shafts_are_one_rotor_with_a_link() -> None:
    _, _, text = script_of("coaxial.toml")
    (rotor,) = run(text)["rotors"]
    shafts, _, bearings = rotor.given
    assert rotor.kind == "CoAxialRotor"
    assert [len(shafts), sum("n_link" in vars(one) for one in bearings)] == [2, 1]


def test_masses_are_disks_and_unbalances_have_their_phase() -> None:
    tables = load_machine(MACHINES / "spindle.toml").to_mapping()
    tables["masses"] = [{
        "name": "cutter", "shaft": "spindle", "position": "300 mm", "mass": "2 kg",
        "transverse_inertia": "0.002 kg m^2", "polar_inertia": "0.003 kg m^2",
        "unbalance": "50 g mm", "unbalance_azimuth": "90 deg",
    }]  # fmt: skip
    machine = Machine.from_mapping(tables)
    maps = supports(machine, np.linspace(0.0, 800.0, 7))
    names = run(ross_script(machine, ross_bearings(maps, machine)))
    (disk,) = names["rotors"][0].given[1]
    assert (disk.m, disk.Id, disk.Ip) == (2.0, 0.002, 0.003)
    # 90° is at our +y, which is ROSS's x
    ((node, size, phase),) = names["unbalances"]
    assert (node, size) == (disk.n, pytest.approx(5e-5))
    assert phase == pytest.approx(0.0)


def test_no_name_ends_a_comment_or_a_text_of_the_script() -> None:
    tables = load_machine(MACHINES / "spindle.toml").to_mapping()
    tables["title"] = 'x""" \\'
    tables["bearings"][0]["name"] = "x'\"); import os; ("
    tables["shafts"][0]["material"] = {
        "name": '""" import os', "youngs_modulus": "206 GPa", "poisson_ratio": 0.3,
        "density": "7850 kg/m^3",
    }  # fmt: skip
    machine = Machine.from_mapping(tables)
    maps = supports(machine, np.linspace(0.0, 800.0, 7))
    elements = ross_bearings(maps, machine)
    tree = ast.parse(ross_script(machine, elements))
    imported = [n.names[0].name for n in ast.walk(tree) if isinstance(n, ast.Import)]
    assert imported == ["ross"]
    assert len(tomllib.loads(bearing_file(elements, 3, machine))) == 2


# --- with ROSS, where it is installed -------------------------------------------------------------


def test_ross_itself_takes_them(tmp_path: Path) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        ross = pytest.importorskip("ross")
        _, elements, text = script_of("motor.toml")
        version = 3 if int(ross.__version__.partition(".")[0]) > 2 else 2
        (tmp_path / "bearings.toml").write_text(bearing_file(elements[:1], version), "utf-8")
        loaded = ross.BearingElement.load(tmp_path / "bearings.toml")
        assert loaded.kxx == pytest.approx(elements[0].stiffness[:, 0, 0].tolist())
        names: dict[str, Any] = {"__name__": "rotor"}
        exec(compile(text, "rotor.py", "exec"), names)
        modes = names["rotors"][0].run_modal(speed=names["speed"], num_modes=24)
    # of the shaft with what elements of ROSS have of its bearings, by our own matrices
    found = sorted(one for one in modes.wd if one > 1.0)[:4]
    assert found == pytest.approx([416.037, 1649.73, 1662.35, 3874.6], rel=1e-5)
