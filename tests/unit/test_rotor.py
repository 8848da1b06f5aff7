"""Modes, Campbell diagrams and unbalance of machines; see also the validation by Friswell."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import rolamento as ro
from rolamento.case.machine import Machine, Mass, Shaft
from rolamento.errors import InputError
from rolamento.machines import balanced
from rolamento.numerics import ComplexArray, FloatArray
from rolamento.rotors import campbell, compliance, natural_modes, unbalance_response
from rolamento.solved.rotor import whirl_names
from rolamento.status import CONVERGED
from rolamento.system.network import FIVE, Linear, Rest
from rolamento.system.rotor import Rotor, rotor_of, unbalance_force
from rolamento.system.shafts import Beam, MachineRest, Structure

EXAMPLES = Path(ro.__file__).parent / "examples" / "machines"
MOTOR = EXAMPLES / "motor.toml"
STEEL = {"name": "steel of the test", "youngs_modulus": 210e9, "poisson_ratio": 0.3,
         "density": 7800.0}  # fmt: skip


def on_springs(
    shaft: Shaft, rates: dict[float, list[float]], masses: tuple[Mass, ...] = (), speed: float = 0.0
) -> tuple[Rotor, Structure, Machine]:
    """A shaft on linear springs alone, which no machine file has."""
    beam = Beam.of(shaft, 0, [*rates, *(mass.position for mass in masses)])
    unknowns = FIVE * len(beam.place)
    springs = tuple(
        Linear((beam.node_at(place),), np.diag(rate)[np.newaxis]) for place, rate in rates.items()
    )
    nothing = np.zeros(unknowns, np.bool_)
    structure = Structure((beam,), (), springs, nothing, (), np.zeros((1, unknowns)))
    machine = Machine.model_construct(shafts=(shaft,), masses=masses)
    rest = MachineRest(Rest.nowhere(1, unknowns, ()), np.zeros((1, len(beam.place), FIVE)))
    speeds = {shaft.name: np.array([speed])}
    return rotor_of(machine, structure, rest, speeds), structure, machine


def frequencies(rotor: Rotor, count: int) -> FloatArray:
    return rotor.modes(0, count).frequency


def test_simply_supported_shaft_has_timoshenko_s_frequencies() -> None:
    """Against the closed form for a pinned Timoshenko beam; Timoshenko (1922).

    ω is a root of r² q² ω⁴ - (…) ω² + …: with a² = E I/(ρ A), k = n π/L,
    ω⁴ ρ I ρ/(κ G ρ A)... solved as a quadratic in ω².
    """
    length, d, e, nu, rho = 0.6, 0.04, 210e9, 0.3, 7800.0
    shaft = Shaft(name="s", sections=[{"length": length, "diameter": d}], material=STEEL)
    pinned = [1e12, 1e13, 1e13, 0.0, 0.0]
    rotor, _, _ = on_springs(shaft, {0.0: pinned, length: pinned})
    area, inertia = np.pi / 4 * d**2, np.pi / 64 * d**4
    kappa, g = 6 * (1 + nu) / (7 + 6 * nu), e / 2 / (1 + nu)
    expected = []
    for n in (1, 2, 3):
        k = n * np.pi / length
        # E I k⁴ - (ρ A + ρ I k² (1 + E/κG)) ω² + ρ² I/(κ G) ω⁴ = 0
        roots = np.roots(
            [rho**2 * inertia / (kappa * g), -(rho * area + rho * inertia * k**2
             * (1 + e / (kappa * g))), e * inertia * k**4]
        )  # fmt: skip
        expected += [np.sqrt(roots.min())] * 2
    np.testing.assert_allclose(frequencies(rotor, 6), expected, rtol=2e-4)


def test_a_free_body_has_rigid_modes_and_those_of_a_free_beam() -> None:
    """Five rigid motions of next to no frequency; then 22.37 √(E I/(ρ A L⁴)), Euler's, slender."""
    shaft = Shaft(name="s", sections=[{"length": 2.0, "diameter": 0.02}], material=STEEL)
    rotor, _, _ = on_springs(shaft, {})
    found = frequencies(rotor, 12)
    bent = 22.3733 * np.sqrt(210e9 * 0.02**2 / 16 / 7800.0) / 2.0**2
    rest = found[found > 1.0]
    np.testing.assert_allclose(rest[:2], bent, rtol=1e-3)


def test_a_jeffcott_rotor_whirls_with_its_unbalance() -> None:
    """A disk on a light shaft: the orbit is e r²/√((1 - r²)² + (2 ζ r)²); Friswell, eq. 6.21.

    With C = β K, ζ = β ω_n/2.
    """
    light = {**STEEL, "density": 100.0}
    shaft = Shaft(name="s", sections=[{"length": 0.4, "diameter": 0.02}], material=light)
    disk = Mass(shaft="s", position=0.2, mass=1e4, unbalance=1.0, unbalance_azimuth=0.3)
    pinned = [1e9, 1e13, 1e13, 0.0, 0.0]
    rotor, structure, machine = on_springs(shaft, {0.0: pinned, 0.4: pinned}, (disk,))
    natural = frequencies(rotor, 1)[0]
    beta = 1e-2
    damped = Rotor(rotor.mass, rotor.gyroscopic, rotor.stiffness, beta, rotor.free)
    node = structure.beams[0].node_at(0.2)
    for ratio in (0.5, 0.95, 1.0, 2.0):
        speed = ratio * natural
        moved = damped.response(0, speed, unbalance_force(machine, structure, speed, "s"))
        y, z = moved[FIVE * node + 1], moved[FIVE * node + 2]
        zeta = 0.5 * beta * natural
        size = 1e-4 * ratio**2 / np.hypot(1 - ratio**2, 2 * zeta * ratio)
        np.testing.assert_allclose([abs(y), abs(z)], size, rtol=2e-5)
        np.testing.assert_allclose(y / z, 1j, atol=1e-9)  # a circle, forward
        turned = z * np.exp(1j * (0.3 + np.arctan2(2 * zeta * ratio, 1 - ratio**2)))
        assert np.angle(turned) == pytest.approx(0.0, abs=1e-4)
    modes = damped.modes(0, 2)
    np.testing.assert_allclose(modes.damping_ratio, 0.5 * beta * natural, rtol=1e-4)


def all_eigenvalues(rotor: Rotor, case: int, count: int) -> ComplexArray:
    """The lowest that swing, of all free degrees of freedom, none left out: 1/λ of A⁻¹ B."""
    at = np.ix_(rotor.free, rotor.free)
    scale = np.sqrt(np.abs(np.diagonal(rotor.stiffness[case][at])))
    m, g, k = (
        one[at] / scale[:, np.newaxis] / scale
        for one in (rotor.mass, rotor.gyroscopic[case], rotor.stiffness[case])
    )
    none, one = np.zeros_like(m), np.eye(len(m))
    a = np.block([[none, one], [-k, -(rotor.damping * k + g)]])
    inverse = np.linalg.eigvals(np.linalg.solve(a, np.block([[one, none], [none, m]])))
    values = 1.0 / inverse[np.abs(inverse) > 1e-13 * np.abs(inverse).max()]
    values = values[values.imag > 1e-3 * np.abs(values)]
    return values[np.argsort(np.abs(values))][:count]


@pytest.mark.parametrize("name", ["motor", "spindle", "coaxial", "three_supports", "pinion"])
def test_a_basis_of_modes_is_good_to_a_millionth(name: str) -> None:
    """Beside all degrees of freedom at once, at each speed, from slow to twelve times its own.

    With gyroscopic moments, rings without mass, and balls at speed, whose moments leave the
    stiffness without symmetry: of the spindle by half a percent.
    """
    machine = Machine.from_file(EXAMPLES / f"{name}.toml")
    factors = [0.1, 1.0, 5.0, 12.0]
    steps = [{"share": 0.25, "speed_factor": one} for one in factors]
    machine = machine.replace(spectrum=steps)
    structure, rest, _ = balanced(machine)
    speeds = {one.name: np.array(factors) * machine.speed(one.name) for one in machine.shafts}
    rotor = rotor_of(machine, structure, rest, speeds)
    assert (rest.number == CONVERGED).all()
    for case in range(len(rotor)):
        found = rotor.modes(case, 8)
        np.testing.assert_allclose(found.eigenvalue, all_eigenvalues(rotor, case, 8), rtol=1e-6)
        # what is left over as a force would move next to nothing, and no ring without mass
        free = np.ix_(rotor.free, rotor.free)
        k, g = rotor.stiffness[case], rotor.gyroscopic[case]
        light = rotor.free[~rotor.mass[:, rotor.free].any(axis=0)]
        assert light.size
        for value, shape in zip(found.eigenvalue, found.shape, strict=True):
            left = value**2 * rotor.mass @ shape + value * g @ shape + k @ shape
            moved = np.linalg.solve(k[free], left[rotor.free])
            assert np.abs(moved).max() < 2e-4 * np.abs(shape).max()
            assert np.abs(left[light]).max() < 1e-9 * np.abs(k[light]).max()


def test_modes_at_rest_are_orthogonal() -> None:
    """By mass and by stiffness, on springs that differ in all directions."""
    shaft = Shaft(name="s", sections=[{"length": 0.6, "diameter": 0.04}], material=STEEL)
    rates = {0.0: [1e8, 1e7, 3e7, 0.0, 0.0], 0.5: [0.0, 4e7, 2e7, 0.0, 0.0]}
    rotor, _, _ = on_springs(shaft, rates)
    modes = rotor.modes(0, 8)
    shape = modes.shape.real
    np.testing.assert_allclose(modes.shape.imag, 0.0, atol=1e-6)
    mass, stiffness = shape @ rotor.mass @ shape.T, shape @ rotor.stiffness[0] @ shape.T
    size = np.sqrt(np.diagonal(mass))
    np.testing.assert_allclose(mass / size / size[:, np.newaxis], np.eye(8), atol=1e-6)
    expected = np.diag(modes.frequency**2)
    limit = 1e-6 * np.outer(modes.frequency, modes.frequency).max()
    np.testing.assert_allclose(stiffness / size / size[:, np.newaxis], expected, atol=limit)


def test_a_machine_turned_by_a_right_angle_has_the_same_modes() -> None:
    """Its load and its bearings' stiffness turned about the shaft; elements by fours.

    Other numbers of balls do not look the same after a quarter of a turn.
    """
    machine = Machine.from_file(MOTOR)
    counts = [one.case.bearing.ball_count for one in machine.bearings]
    assert not any(count % 4 for count in counts)
    down = {"shaft": "rotor shaft", "position": 0.1, "fz": -500.0}
    aside = {"shaft": "rotor shaft", "position": 0.1, "fy": -500.0}
    found = [
        natural_modes(machine.replace(loads=[load], belts=[], gravity=None))
        for load in (down, aside)
    ]
    np.testing.assert_allclose(found[0].frequency, found[1].frequency, rtol=1e-8)


def test_modes_of_a_machine() -> None:
    """By rising frequency; the greatest shift is 1; whirl splits with speed."""
    modes = natural_modes(MOTOR, count=8)
    assert len(modes) == 8
    assert (np.diff(modes.frequency) >= 0.0).all()
    shifts = np.abs(modes.shape["rotor shaft"][..., :3])
    assert shifts.max() == pytest.approx(1.0)
    assert set(modes.whirl) <= {"forward", "backward", "along a line", "axial"}
    np.testing.assert_allclose(modes.damping_ratio, 0.0, atol=1e-7)
    damped = natural_modes(MOTOR, count=4, damping=1e-5)
    np.testing.assert_allclose(damped.damping_ratio, 0.5e-5 * np.abs(damped.frequency), rtol=2e-2)


def test_campbell_solves_each_speed_anew() -> None:
    """At the machine's own speed it is what the modes say.

    At a critical speed the machine has that frequency, however coarse the speeds.
    """
    machine = Machine.from_file(MOTOR)
    own = machine.speed("rotor shaft")
    speeds = np.array([0.5, 1.0, 5.0, 10.0]) * own
    found = campbell(machine, speeds, count=6, orders=(1.0, 2.0))
    assert (found.status == "converged").all()
    modes = natural_modes(machine, count=6)
    np.testing.assert_allclose(np.sort(found.frequency[1]), modes.frequency, rtol=1e-6)
    assert found.critical
    for one in found.critical:
        there = natural_modes(machine, speed=one.speed, count=6).frequency
        np.testing.assert_allclose(np.abs(there / one.frequency - 1.0).min(), 0.0, atol=1e-7)
        assert one.frequency == pytest.approx(one.order * one.speed)


def test_a_response_that_lifts_the_balls_off_is_named() -> None:
    """A resonance adds more force than rows carry; a hundredth of the unbalance does not."""
    machine = Machine.from_file(MOTOR)
    at_resonance = [14_932.0 * np.pi / 30.0]
    found = unbalance_response(machine, at_resonance, damping=1e-5)
    assert [note.key for note in found.notes] == ["beyond_linear"] * 2
    assert {note.values["bearing"] for note in found.notes} == {b.name for b in machine.bearings}
    small = machine.masses[0].unbalance / 100.0
    machine = machine.replace(masses=[machine.masses[0].replace(unbalance=small)])
    assert not unbalance_response(machine, at_resonance, damping=1e-5).notes


def test_critical_speeds_do_not_depend_on_the_grid() -> None:
    """From a standstill on too, where the first interval begins."""
    machine = Machine.from_file(MOTOR)
    coarse, fine = (
        [one.speed for one in campbell(machine, np.linspace(0.0, 1700.0, n), count=4).critical]
        for n in (3, 18)
    )
    assert len(coarse) == 3
    np.testing.assert_allclose(coarse, fine, rtol=1e-6)


def test_a_speed_that_is_not_possible_leaves_the_others() -> None:
    """The fit of the inner ring is lost at one of them; the others are as they are alone."""
    machine = Machine.from_file(MOTOR)
    found = campbell(machine, [100.0, 12_000.0], count=4)
    assert found.status.tolist() == ["converged", "invalid_input"]
    assert np.isnan(found.frequency[1]).all()
    alone = campbell(machine, [100.0], count=4)
    np.testing.assert_allclose(found.frequency[0], alone.frequency[0], rtol=1e-9)


def test_modes_at_another_speed() -> None:
    """As of the machine that turns so; a standing shaft has no speed that could be another."""
    machine = Machine.from_file(MOTOR)
    fast = machine.replace(shafts=[machine.shafts[0].replace(speed=400.0)])
    masses = {"belts": [], "loads": []}  # a belt's power would pull less
    found = natural_modes(machine.replace(**masses), speed=400.0, shaft="rotor shaft")
    expected = natural_modes(fast.replace(**masses))
    np.testing.assert_allclose(found.frequency, expected.frequency, rtol=1e-9)
    with pytest.raises(InputError):
        natural_modes(standing(), speed=10.0)


def test_the_phase_of_a_response_lags_behind_its_unbalance() -> None:
    """Slow, the high spot is the heavy one; beyond the first resonance it is opposite."""
    machine = Machine.from_file(MOTOR)
    heavy = machine.masses[0].replace(unbalance=1e-3, unbalance_azimuth=0.5)
    machine = machine.replace(masses=[heavy])
    # critical at 1536, 1564 and, in backward whirl, 2874 rad/s
    found = unbalance_response(machine, [30.0, 2500.0], damping=1e-6)
    middle = int(np.argmin(np.abs(found.position["rotor shaft"] - heavy.position)))
    phase = found.phase("rotor shaft")[:, middle]
    assert phase.shape == (2,)
    assert phase[0] == pytest.approx(0.5, abs=0.02)
    assert np.cos(phase[1] - 0.5 - np.pi) > 0.9


def test_unbalance_of_a_machine_names_the_damping_that_it_assumes() -> None:
    """Given or assumed; amplitudes grow with the square of a low speed."""
    machine = Machine.from_file(MOTOR)
    masses = [machine.masses[0].replace(unbalance=1e-3)]
    machine = machine.replace(masses=masses)
    slow = machine.speed("rotor shaft") * np.array([0.02, 0.04])
    found = unbalance_response(machine, slow)
    assert [note.key for note in found.notes] == ["assumed_damping"]
    assert not unbalance_response(machine, slow, damping=1e-6).notes
    amplitude = found.amplitude("rotor shaft").max(axis=1)
    assert amplitude[1] / amplitude[0] == pytest.approx(4.0, rel=0.05)
    forces = sum(force[1] for force in found.force.values())
    # in quasi-statics the bearings carry the unbalance
    assert abs(forces[2]) == pytest.approx(1e-3 * slow[1] ** 2, rel=0.05)


def test_compliance_is_what_a_small_load_does() -> None:
    """The derivative of the displacement by a load at the place."""
    machine = Machine.from_file(EXAMPLES / "pinion.toml")
    name, at = machine.shafts[0].name, 0.05
    found = compliance(machine, name, at)[0]
    moved = []
    for step in (1.0, -1.0):
        more = {"shaft": name, "position": at, "fz": 10.0 * step}
        solved = ro.shaft(machine.replace(loads=[*machine.loads, more]))
        moved.append(solved.shafts[name].displacement_at(at)[0])
    np.testing.assert_allclose((moved[0] - moved[1])[2] / 20.0, found[2, 2], rtol=1e-3)


def standing() -> Machine:
    machine = Machine.from_file(EXAMPLES / "three_supports.toml")
    return machine.replace(shafts=[machine.shafts[0].replace(speed=0.0)])


@pytest.mark.parametrize(
    ("call", "says"),
    [
        (lambda: campbell(MOTOR, [np.nan]), "speeds"),
        (lambda: campbell(MOTOR, [1.0], shaft="lost"), "shaft"),
        (lambda: natural_modes(MOTOR, count=0), "count"),
        (lambda: unbalance_response(EXAMPLES / "gear_shaft.toml", [1.0]), "masses"),
        (lambda: campbell(standing(), [1.0]), "speed"),
        (lambda: compliance(MOTOR, "rotor shaft", 9.0), "position"),
    ],
)
def test_what_makes_no_sense_is_refused(call: object, says: str) -> None:
    """With the field that is wrong."""
    with pytest.raises(InputError) as caught:
        call()  # type: ignore[operator]
    assert says in caught.value.field


def test_whirl_by_name() -> None:
    """Circles, lines, the axis."""
    forward = np.array([1.0, -0.5, 0.1, 0.0])
    names = whirl_names(forward, np.array([False, False, False, True]))
    assert names.tolist() == ["forward", "backward", "along a line", "axial"]
