"""Components between nodes: springs by hand, rows between two moving rings, warm starts."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import rolamento as ro
from rolamento.numerics import FloatArray
from rolamento.status import CONVERGED, NO_EQUILIBRIUM
from rolamento.system import solve_cases, spread
from rolamento.system.network import FIVE, Asked, Component, Linear, Rest, RowBetween, solve
from rolamento.system.ring import RowsOnRing, pressed_in

BALLS = ro.Bearing(
    ball_count=14,
    ball_diameter=0.0127,
    pitch_diameter=0.07,
    contact_angle=np.radians(25.0),
    inner_conformity=0.52,
    outer_conformity=0.53,
)


def asked_of(load: FloatArray, free: FloatArray | bool, held: FloatArray | float = 0.0) -> Asked:
    """One case: loads (unknowns,) where free, places where held; no scaling."""
    n = load.size
    return Asked(
        chosen=np.array([0]),
        arms=np.ones((1, n)),
        free=np.broadcast_to(np.asarray(free, np.bool_), (1, n)),
        target=load[np.newaxis],
        start=np.broadcast_to(np.asarray(held, np.float64), (1, n)).copy(),
        sound=np.array([True]),
        longest=np.array([5e-3]),
        limit=np.array([0.1]),
        reference=np.array([1.0]),
    )


def spring(rate: float, nodes: tuple[int, ...]) -> Linear:
    """The same rate in all directions, between two nodes or to the ground."""
    k = rate * np.eye(FIVE)
    if len(nodes) == 2:
        k = np.block([[k, -k], [-k, k]])
    return Linear(nodes, k[np.newaxis])


def test_springs_in_series_stretch_as_by_hand() -> None:
    """Ground - 1e6 - node 0 - 2e6 - node 1, 300 N at the end: 0.3 mm and 0.45 mm."""
    load = np.zeros(2 * FIVE)
    load[FIVE] = 300.0
    rest = solve([spring(1e6, (0,)), spring(2e6, (0, 1))], asked_of(load, True))
    assert rest.number[0] == CONVERGED
    np.testing.assert_allclose(rest.place[0, [0, FIVE]], [3e-4, 4.5e-4], rtol=1e-12)


def test_what_nothing_holds_is_named() -> None:
    """Two nodes joined to each other alone run away."""
    load = np.zeros(2 * FIVE)
    load[2] = 10.0
    rest = solve([spring(1e6, (0, 1))], asked_of(load, True))
    assert rest.number[0] == NO_EQUILIBRIUM
    assert rest.unsupported[0] in (2, FIVE + 2)


def row_of(speed: float = 0.0) -> tuple[ro.Case, RowBetween]:
    case = ro.Case(bearing=BALLS, duty={"inner_speed": speed, "load": {"fx": 800.0, "fz": 300.0}})
    cases = spread(case, threads=1)
    zero = np.zeros(1)
    return case, RowBetween(cases.rows[0].row, 0, 1, 1.0, zero, zero)


def test_only_the_place_of_one_ring_against_the_other_counts() -> None:
    """With the outer ring displaced and held, the inner ring follows it."""
    case, row = row_of()
    alone = solve_cases(spread(case, threads=1))
    load, free = np.zeros(2 * FIVE), np.zeros(2 * FIVE, np.bool_)
    load[[0, 2]], free[:3] = (800.0, 300.0), True
    moved = np.zeros(2 * FIVE)
    moved[FIVE : FIVE + 3] = 1e-4, -2e-4, 3e-4
    rest = solve([row], asked_of(load, free, moved))
    apart = rest.place[0, :FIVE] - rest.place[0, FIVE:]
    np.testing.assert_allclose(apart, alone.displacement.array[0], atol=1e-12)
    np.testing.assert_allclose(rest.force[0, :FIVE], -rest.force[0, FIVE:], atol=1e-9)


def test_a_ring_on_springs_shares_the_way() -> None:
    """An outer ring on springs yields by F/k; the row itself is pressed in as before."""
    case, row = row_of()
    alone = solve_cases(spread(case, threads=1))
    load, free = np.zeros(2 * FIVE), np.ones(2 * FIVE, np.bool_)
    load[[0, 2]] = 800.0, 300.0
    free[[3, 4, FIVE + 3, FIVE + 4]] = False
    rest = solve([row, spring(1e7, (1,))], asked_of(load, free))
    assert rest.number[0] == CONVERGED
    np.testing.assert_allclose(rest.place[0, FIVE : FIVE + 3], [8e-5, 0.0, 3e-5], atol=1e-13)
    apart = rest.place[0, :3] - rest.place[0, FIVE : FIVE + 3]
    np.testing.assert_allclose(apart, alone.displacement.array[0, :3], atol=1e-12)


def test_the_tangent_is_the_derivative_of_the_force() -> None:
    """Central differences of a row between two tilted rings, faced the other way, aside."""
    _, row = row_of(2000.0)
    row = replace(row, way=-1.0, lever=np.array([0.02]))
    place = np.array([[-5e-5, 1e-5, 2e-5, 1e-4, -2e-4, 1e-5, 0.0, -1e-5, 0.0, 1e-4]])
    here = row.respond(place, np.array([0]), None)
    numeric = np.empty((10, 10))
    for i in range(10):
        step = 1e-7 if i % FIVE < 3 else 1e-6
        both = []
        for sign in (1.0, -1.0):
            moved = place.copy()
            moved[0, i] += sign * step
            both.append(row.respond(moved, np.array([0]), None).force[0])
        numeric[:, i] = (both[0] - both[1]) / (2.0 * step)
    scale = np.abs(here.stiffness[0]).max()
    np.testing.assert_allclose(here.stiffness[0] / scale, numeric / scale, atol=1e-6)


def on_springs(speed: float) -> ro.Case:
    bearing = BALLS.replace(arrangement="DB", spacing=0.018, preload={"spring": 400.0})
    return ro.Case(
        bearing=bearing, duty={"inner_speed": speed, "load": {"fx": 150.0, "fz": 900.0, "my": 5.0}}
    )


def by_network(case: ro.Case) -> Rest:
    """The set solved row by row, without the kernels that know sets."""
    system = RowsOnRing.of(spread(case, threads=1))
    return system._by_network(system._asked(np.array([0])))


@pytest.mark.parametrize("speed", [0.0, 2500.0])
def test_joint_kernels_and_the_network_agree(speed: float) -> None:
    """A pair on springs: by its own kernels, and as a network of two nodes."""
    case = on_springs(speed)
    joint, network = solve_cases(spread(case, threads=1)), by_network(case)
    np.testing.assert_allclose(
        network.place[0, :FIVE], joint.displacement.array[0], rtol=1e-8, atol=1e-14
    )
    np.testing.assert_allclose(network.force[0, FIVE], 400.0, rtol=1e-9)


def test_a_row_begins_from_its_memory_and_comes_to_the_same() -> None:
    """A little farther on, balls at speed take fewer steps from where they were."""
    case = on_springs(2500.0)
    row = spread(case, threads=1).rows[0].row
    place, which = np.array([[3e-5, 0.0, 1e-5, 0.0, 0.0]]), np.array([0])
    memory = row.respond(place, which).memory
    assert memory is not None
    cold = row.respond(place + 1e-7, which)
    warm = row.respond(place + 1e-7, which, memory)
    assert cold.number[0] == warm.number[0] == CONVERGED
    np.testing.assert_allclose(warm.force, cold.force, rtol=1e-9)
    np.testing.assert_allclose(warm.stiffness, cold.stiffness, rtol=1e-7)
    unknown = row.respond(place + 1e-7, which, np.full_like(memory, np.nan))
    np.testing.assert_array_equal(unknown.force, cold.force)


def test_the_two_places_of_a_row_differ_by_its_lever() -> None:
    """Rows beside the node are pressed in as the set has them."""
    cases = spread(on_springs(0.0), threads=1)
    components: list[Component] = [
        RowBetween(p.row, 0, None, p.sign, p.lever, press)
        for p, press in zip(cases.rows, pressed_in(cases), strict=True)
    ]
    tilt = np.array([[0.0, 0.0, 0.0, 1e-4, 0.0]])
    for component, placed in zip(components, cases.rows, strict=True):
        alone = placed.row.respond(
            np.array([[0.0, 0.0, -placed.position[0] * 1e-4, placed.sign * 1e-4, 0.0]]),
            np.array([0]),
        )
        seen = component.respond(tilt, np.array([0]), None)
        np.testing.assert_allclose(seen.force[0, 2], alone.force[0, 2], rtol=1e-9)
