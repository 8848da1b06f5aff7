"""Machines: shafts on their bearings against sets, rigid limits, symmetry and a plain solution."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import root

import rolamento as ro
from rolamento.case.lubricant import Lubricant
from rolamento.case.machine import Housing, Machine
from rolamento.errors import InputError
from rolamento.machines import shaft
from rolamento.numerics import FloatArray
from rolamento.solution import solve
from rolamento.solved.machine import SolvedMachine
from rolamento.system.shafts import structure_of

EXAMPLES = Path(ro.__file__).parent / "examples" / "machines"
RPM = np.pi / 30.0
ROW = {
    "ball_count": 14,
    "ball_diameter": 0.0127,
    "pitch_diameter": 0.07,
    "contact_angle": np.radians(25.0),
    "inner_conformity": 0.52,
    "outer_conformity": 0.53,
}
LOAD = {"fx": 800.0, "fy": 200.0, "fz": 1500.0, "my": 20.0, "mz": -10.0}


def pair(left: str, right: str, diameter: float = 0.05, speed: float = 12000 * RPM) -> Machine:
    """Two rows, 20 mm apart, that face two ways; the load acts half way between them."""
    bearings = [
        {
            "name": name, "shaft": "s", "position": place, "faces": way, "offset": 5e-6,
            "bearing": ro.Bearing(**ROW),
        }
        for name, place, way in (("A", 0.04, left), ("B", 0.06, right))
    ]  # fmt: skip
    return Machine(
        shafts=[{"name": "s", "speed": speed, "sections": [{"length": 0.1, "diameter": diameter}]}],
        bearings=bearings,
        loads=[{"shaft": "s", "position": 0.05, **LOAD}],
    )


def middle(solved: SolvedMachine) -> FloatArray:
    return solved.shafts["s"].displacement_at(0.05)[0]


@pytest.mark.parametrize(("left", "right", "arrangement"), [("+x", "-x", "DB"), ("-x", "+x", "DF")])
def test_a_stiff_shaft_makes_the_set(left: str, right: str, arrangement: str) -> None:
    """The trap of sides: back to back is +x on the left; a set of rigid rings is the limit.

    What the shaft yields falls with its area at least.
    """
    bearing = ro.Bearing(**ROW, arrangement=arrangement, spacing=0.02, preload={"offset": 5e-6})
    of_set = solve(bearing, inner_speed=12000 * RPM, **LOAD).displacement.array[0]
    off = []
    for diameter in (0.1, 0.4, 1.6):
        found = shaft(pair(left, right, diameter))
        assert found.status.converged.all()
        off.append(np.abs(middle(found) / of_set - 1.0).max())
    assert off[0] < 0.05
    assert off[1] < off[0] / 10.0
    assert off[2] < 1e-4


def test_swapped_sides_tilt_many_times_as_much() -> None:
    """Face to face carries moments on a shorter base."""
    back, face = (middle(shaft(pair(*ways)))[3] for ways in (("+x", "-x"), ("-x", "+x")))
    assert abs(face) > 3.0 * abs(back)


def test_a_bearing_solved_alone_gives_the_same() -> None:
    """Its own result is that of its own case."""
    for one in shaft(pair("+x", "-x")).bearings.values():
        alone = solve(one.solved.case)
        np.testing.assert_allclose(
            alone.displacement.array, one.solved.displacement.array, rtol=1e-8, atol=1e-14
        )
        np.testing.assert_allclose(alone.inner.load, one.solved.inner.load, rtol=1e-8)
        np.testing.assert_allclose(alone.load.array, one.solved.load.array, rtol=1e-7, atol=1e-7)


def test_forces_are_in_balance_and_sections_carry_them() -> None:
    """Sum of forces and moments; the section just beside a load differs by that load."""
    found = shaft(pair("+x", "-x"))
    total, about = np.zeros(3), np.zeros(2)
    for one in found.bearings.values():
        x, force = one.bearing.position - 0.05, one.force[0]
        total += force[:3]
        about += force[3:] + np.array([-x * force[2], x * force[1]])
    np.testing.assert_allclose(total, [800.0, 200.0, 1500.0], rtol=1e-9)
    np.testing.assert_allclose(about, [20.0, -10.0], rtol=1e-8)
    of_shaft = found.shafts["s"]
    at = int(np.argmin(np.abs(of_shaft.position - 0.05)))
    jump = of_shaft.force[0, at, 0] - of_shaft.force[0, at, 1]
    np.testing.assert_allclose(jump, [800.0, 200.0, 1500.0, 20.0, -10.0], rtol=1e-8)
    assert np.abs(of_shaft.force[0, :5]).max() < 1e-6  # nothing beyond the left bearing


def test_stiff_housings_are_the_ground() -> None:
    """A housing of 1e14 N/m changes nothing that shows; one of 1e8 yields by F/k."""
    rigid, machine = shaft(pair("+x", "-x")), pair("+x", "-x")
    on = [one.replace(housing="h") for one in machine.bearings]
    for stiffness, tolerance in ((1e14, 1e-5), (1e8, None)):
        housing = {"name": "h", "stiffness": [stiffness] * 3}
        found = shaft(machine.replace(bearings=on, housings=[housing]))
        if tolerance:
            np.testing.assert_allclose(middle(found), middle(rigid), rtol=tolerance)
            continue
        for one in found.bearings.values():
            np.testing.assert_allclose(one.outer[0, :3], one.force[0, :3] / 1e8, rtol=1e-9)


def test_turned_by_a_right_angle_it_is_the_same() -> None:
    """Balls 4 k: y becomes z, z becomes -y."""
    machine = pair("+x", "-x")
    bearings = [
        one.replace(bearing=ro.Bearing(**{**ROW, "ball_count": 12})) for one in machine.bearings
    ]
    here = shaft(machine.replace(bearings=bearings))
    turned = {"fx": 800.0, "fy": 1500.0, "fz": -200.0, "my": -10.0, "mz": -20.0}
    there = shaft(
        machine.replace(bearings=bearings, loads=[{"shaft": "s", "position": 0.05, **turned}])
    )
    x, y, z, ry, rz = middle(here)
    np.testing.assert_allclose(middle(there), [x, z, -y, rz, -ry], rtol=1e-11)


def test_weights_hang_on_their_bearings() -> None:
    """Shaft and disk under gravity alone; the section in the middle carries q x/2 and so on."""
    machine = pair("+x", "-x").replace(
        loads=(), gravity={}, masses=[{"shaft": "s", "position": 0.1, "mass": 20.0}]
    )
    found = shaft(machine)
    weight = 9.80665 * (20.0 + 7850.0 * 0.1 * np.pi / 4 * 0.05**2)
    borne = sum(one.force[0, 2] for one in found.bearings.values())
    assert borne == pytest.approx(-weight, rel=1e-9)
    of_shaft = found.shafts["s"]
    q = 9.80665 * 7850.0 * np.pi / 4 * 0.05**2
    at = int(np.argmin(np.abs(of_shaft.position - 0.02)))
    np.testing.assert_allclose(of_shaft.force[0, at, :, 2], q * of_shaft.position[at], rtol=1e-9)
    np.testing.assert_allclose(
        np.abs(of_shaft.force[0, at, :, 3]), 0.5 * q * of_shaft.position[at] ** 2, rtol=1e-9
    )


def test_what_nothing_holds_along_x_is_named() -> None:
    """Cylindrical bearings alone: the shaft may shift."""
    machine = Machine(
        shafts=[{"name": "rotor", "sections": [{"length": 0.3, "diameter": 0.04}]}],
        bearings=[
            {"name": n, "shaft": "rotor", "position": p, "designation": "NU 208"}
            for n, p in (("A", 0.03), ("B", 0.27))
        ],
        loads=[{"shaft": "rotor", "position": 0.15, "fz": -1000.0}],
    )
    found = shaft(machine)
    assert found.status.code.tolist() == ["no_equilibrium"]
    advice = found.advice[0]
    assert advice is not None
    assert (advice.key, advice.values["shaft"], advice.values["axis"]) == (
        "shaft_not_held", "rotor", "x",
    )  # fmt: skip
    assert np.isnan(found.bearings["A"].force).all()
    held = machine.replace(springs=[{"shaft": "rotor", "position": 0.0, "stiffness": [1e6, 0, 0]}])
    assert shaft(held).status.converged.all()


@pytest.mark.parametrize("designation", ["6208", "NUP 208 ECP", "NJ 208 ECP", "22208 E"])
def test_a_floating_bearing_bears_no_thrust(designation: str) -> None:
    """A locating 6208 and a floating bearing of any type: thrust goes to one of them alone."""
    machine = Machine(
        shafts=[{"name": "s", "sections": [{"length": 0.3, "diameter": 0.04}]}],
        bearings=[
            {"name": "A", "shaft": "s", "position": 0.03, "designation": "6208"},
            {"name": "B", "shaft": "s", "position": 0.27, "designation": designation,
             "located": "floating"},
        ],
        loads=[{"shaft": "s", "position": 0.15, "fz": -2000.0, "fx": 500.0}],
    )  # fmt: skip
    found = shaft(machine)
    assert found.bearings["A"].force[0, 0] == pytest.approx(500.0, rel=1e-9)
    assert found.bearings["B"].force[0, 0] == pytest.approx(0.0, abs=1e-6)
    one_way = [machine.bearings[0].replace(located="floating"),
               machine.bearings[1].replace(located="+x")]  # fmt: skip
    found = shaft(machine.replace(bearings=one_way))
    assert found.bearings["B"].force[0, 0] == pytest.approx(500.0, rel=1e-6)
    away = machine.replace(
        bearings=one_way, loads=[{"shaft": "s", "position": 0.15, "fz": -2000.0, "fx": -500.0}]
    )
    assert shaft(away).status.code.tolist() == ["no_equilibrium"]


def test_a_spectrum_is_its_steps() -> None:
    """Each step as it would be alone."""
    machine = Machine.from_file(EXAMPLES / "gear_shaft.toml")
    found = shaft(machine)
    assert len(found) == len(machine.spectrum) > 1
    for index, step in enumerate(machine.spectrum):
        alone = shaft(machine.replace(spectrum=[step.replace(share=1.0)]))
        for name, one in found.bearings.items():
            np.testing.assert_allclose(
                one.force[index], alone.bearings[name].force[0], rtol=1e-7, atol=1e-6
            )


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.toml")), ids=lambda path: path.stem)
def test_examples_come_to_rest(path: Path) -> None:
    """Every bearing has a result of its own, which is in balance."""
    found = shaft(path)
    assert found.status.converged.all()
    assert found.status.residual.max() < 5e-9
    for one in found.bearings.values():
        assert one.solved.converged.all()
        assert np.isfinite(one.solved.inner.load).all()


def plainly(machine: Machine) -> tuple[FloatArray, int]:
    """A machine by beam elements, one function a bearing, and SciPy's root: no condensation.

    Returns the displacement of all nodes, and the number of nodes.
    """
    from rolamento.machines import _running

    cases = [_running([machine], i) for i in range(len(machine.bearings))]
    structure = structure_of([machine], cases)
    beam = structure.beams[0]
    n = 5 * len(beam.place)
    k = np.zeros((n, n))
    for i, own in enumerate(beam.elements.stiffness()):
        at = slice(5 * i, 5 * i + 10)
        k[at, at] += own
    scale = np.tile([1e-6, 1e-6, 1e-6, 3e-5, 3e-5], len(beam.place))

    def bearing(index: int, place: FloatArray) -> FloatArray:
        seat = structure.seats[index]
        x, y, z, ry, rz = place
        s = seat.way
        own = np.array([[s * x + seat.press[0][0], y, z, s * ry, s * rz]])
        force = seat.cases.rows[0].row.respond(own, np.array([0])).force[0]
        return force * [s, 1.0, 1.0, s, s]

    def left(u: FloatArray) -> FloatArray:
        place = u * scale
        rest = k @ place - structure.load[0]
        for index, seat in enumerate(structure.seats):
            at = slice(5 * seat.inner, 5 * seat.inner + 5)
            rest[at] += bearing(index, place[at])
        return rest * scale * 1e3

    found = root(left, np.zeros(n), method="lm", options={"xtol": 1e-14, "ftol": 1e-15})
    return found.x * scale, len(beam.place)


@pytest.mark.parametrize("seed", range(4))
def test_a_plain_solution_finds_the_same(seed: int) -> None:
    """Random shafts, loads and rows, at rest."""
    rng = np.random.default_rng(seed)
    a, b = rng.uniform(0.02, 0.06), rng.uniform(0.12, 0.18)
    machine = pair("+x", "-x", rng.uniform(0.03, 0.06), speed=0.0)
    machine = machine.replace(
        shafts=[machine.shafts[0].replace(sections=[
            {"length": 0.1, "diameter": 0.04, "end_diameter": rng.uniform(0.03, 0.05)},
            {"length": 0.1, "diameter": rng.uniform(0.03, 0.05), "bore": 0.01},
        ])],
        bearings=[machine.bearings[0].replace(position=a), machine.bearings[1].replace(position=b)],
        loads=[{
            "shaft": "s", "position": rng.uniform(0.0, 0.2), "fx": rng.uniform(-500, 500),
            "fy": rng.uniform(-1000, 1000), "fz": rng.uniform(-2000, 2000),
        }],
    )  # fmt: skip
    found = shaft(machine)
    place, nodes = plainly(machine)
    own = found.shafts["s"].displacement[0]
    assert own.shape == (nodes, 5)
    scale = np.abs(own).max(axis=0) + 1e-12
    np.testing.assert_allclose(place.reshape(-1, 5) / scale, own / scale, atol=1e-6)


def test_the_tangent_is_symmetric_at_rest() -> None:
    """Betti: what a load at one place does at another is what that does at the one."""
    base = pair("+x", "-x", speed=0.0)
    step = 1e-2

    def moved(place: float, axis: str, seen: float, way: int) -> float:
        more = {"shaft": "s", "position": place, axis: step}
        less = {"shaft": "s", "position": place, axis: -step}
        both = [
            shaft(base.replace(loads=[*base.loads, one])).shafts["s"].displacement_at(seen)[0, way]
            for one in (more, less)
        ]
        return (both[0] - both[1]) / (2.0 * step)

    assert moved(0.09, "fz", 0.01, 1) == pytest.approx(moved(0.01, "fy", 0.09, 2), rel=1e-3)
    assert moved(0.09, "fx", 0.01, 2) == pytest.approx(moved(0.01, "fz", 0.09, 0), rel=1e-3)


def test_sets_on_springs_stand_in_housings_too() -> None:
    """A pair on springs: the same on the ground and in a very stiff housing."""
    bearing = ro.Bearing(**ROW, arrangement="DB", spacing=0.02, preload={"spring": 400.0})
    machine = pair("+x", "-x")
    one = {"name": "P", "shaft": "s", "position": 0.05, "bearing": bearing}
    on_ground = shaft(machine.replace(bearings=[one]))
    alone = solve(bearing, inner_speed=12000 * RPM, **LOAD)
    np.testing.assert_allclose(
        on_ground.bearings["P"].inner[0], alone.displacement.array[0], rtol=1e-7
    )
    housing = {"name": "h", "stiffness": [1e14, 1e14, 1e14]}
    housed = machine.replace(bearings=[{**one, "housing": "h"}], housings=[housing])
    np.testing.assert_allclose(middle(shaft(housed)), middle(on_ground), rtol=1e-4)


def test_cases_of_a_bearing_keep_their_own_memory() -> None:
    """Two steps of one duty are one and the same."""
    machine = pair("+x", "-x").replace(spectrum=[{"share": 0.5}, {"share": 0.5}])
    found = shaft(machine)
    for one in found.bearings.values():
        np.testing.assert_array_equal(one.force[0], one.force[1])


def test_raceway_control_by_jones_goes_through_the_machine() -> None:
    """A row under a light load at speed is guided by another race than one under a heavy load."""
    machine = pair("+x", "-x")
    by_jones = [one.replace(model={"raceway_control": "jones"}) for one in machine.bearings]
    found = shaft(machine.replace(bearings=by_jones))
    assert found.status.converged.all()
    for one in found.bearings.values():
        alone = solve(one.solved.case)
        np.testing.assert_array_equal(
            alone.elements.raceway_control, one.solved.elements.raceway_control
        )


@pytest.mark.parametrize("own", [{}, {"traction": "film"}])
def test_friction_control_is_refused_by_the_field_that_asks_for_it(own: dict[str, str]) -> None:
    first, second = pair("+x", "-x").bearings
    first = first.replace(
        model={"raceway_control": "friction", **own},
        lubricant=Lubricant.named("ISO VG 68").replace(friction_coefficient=0.06),
        temperature={"lubricant": "70 degC"},
    )
    machine = pair("+x", "-x").replace(bearings=[first, second])
    with pytest.raises(ro.InputError, match="for a bearing alone") as error:
        shaft(machine)
    assert error.value.field == f"bearings.0.model.{'traction' if own else 'raceway_control'}"


def test_a_housing_takes_numbers_of_numpy_as_any_field_does() -> None:
    plain = Housing(name="h", stiffness=[1e8, 2e8, 3e8])
    held = Housing(name="h", stiffness=list(np.array([1, 2, 3], np.float32) * 1e8))
    assert held.stiffness == plain.stiffness
    for wrong, rule in ((True, "must be a number"), (np.nan, "must be a finite number")):
        with pytest.raises(InputError, match=rule):
            Housing(name="h", stiffness=[1e8, 1e8, wrong])
