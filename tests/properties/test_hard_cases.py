"""Every case of a wide random set has a result that holds, or a name for why not.

Bearings of 3 to 60 balls of 3 to 60 mm, conformities 0.505 to 0.6, contact angles to 45°, play
and interference, steel and ceramic; either ring turning, both, against each other; light loads
at high speed, radial loads three times the axial, tilts, moments, reversed thrust, no load, no
speed and hardly any, loads far beyond any bearing.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from rolamento import Bearing, Case, Duty, Model
from rolamento.geometry import ring_geometry
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.system import solve_cases, spread

Floats = NDArray[np.float64]
RPM = math.pi / 30.0
BEARINGS = 36
STATUSES = {
    "converged", "no_equilibrium", "not_converged", "over_shoulder", "overloaded",
    "unconstrained_ball",
}  # fmt: skip
PROMISED = 1e-8
ORDINARY_WITHOUT_RESULT = 0.003
ANY_WITHOUT_RESULT = 0.04
"""Greatest shares of not_converged. Most of them have no solution: under inner control, and with
rings turning against each other, the friction that holds the gyroscopic moment drives a lightly
loaded ball to where it cannot be, α_o < 0. Others are too light for the arithmetic: at a
thousandth of a revolution a minute, and under no load, forces are rounding errors."""
OTHER_EQUILIBRIUM = 0.005
"""Greatest share where the fast and the safe path find different equilibria: light loads leave
balls more than one place."""


@dataclass(frozen=True)
class Hard:
    """Duties for one bearing and model: fields as for `solve`, arrays of one length."""

    number: int
    case: Case
    fields: dict[str, Floats]

    def solve(self) -> Solved:
        return solve(self.case, **self.fields)

    @property
    def ordinary(self) -> NDArray[np.bool_]:
        """(cases,): a load, rings not against each other, no crawl, no inner control."""
        inner, outer = self.fields["inner_speed"], self.fields["outer_speed"]
        loads = [np.abs(self.fields[name]) for name in ("fx", "fy", "fz") if name in self.fields]
        crawls = (inner != 0.0) & (np.abs(inner) < 0.1)
        allowed = self.case.model.raceway_control != "inner"
        return (np.max(loads, axis=0) > 0.0) & (inner * outer >= 0.0) & ~crawls & allowed

    def describe(self, row: int) -> str:
        """Everything to reproduce a case: bearing, model, duty."""
        given = self.case.bearing.model_dump(exclude_none=True, exclude={"ring_material"})
        given["ball_material"] = self.case.bearing.ball_material.name
        duty = {name: float(values[row]) for name, values in self.fields.items()}
        return f"{self.case.model.raceway_control} {given} {duty}"


def random_bearing(rng: np.random.Generator) -> Bearing:
    count = int(rng.choice([3, 4, 5, 7, 8, 9, 12, 16, 21, 30, 45, 60]))
    diameter = 1e-3 * float(np.exp(rng.uniform(np.log(3.0), np.log(60.0))))
    least = max(diameter / math.sin(math.pi / count), 2.5 * diameter)
    inner, outer = (float(f) for f in np.round(rng.uniform(0.505, 0.6, 2), 4))
    distance = diameter * (inner + outer - 1.0)
    shape: dict[str, Any]
    if rng.random() < 0.55:
        shape = {"contact_angle": float(np.radians(rng.choice([0, 12, 15, 25, 30, 40, 45])))}
    else:
        shape = {"diametral_clearance": float(distance * rng.uniform(-0.03, 0.5))}
    return Bearing(
        ball_count=count,
        ball_diameter=diameter,
        pitch_diameter=least * float(rng.uniform(1.02, 1.6)),
        inner_conformity=inner,
        outer_conformity=outer,
        ball_material=str(rng.choice(["100Cr6", "100Cr6", "Si3N4"])),
        **shape,
    )


def random_speeds(rng: np.random.Generator, n: int, pitch: float) -> dict[str, Floats]:
    """Inner, outer, both, against each other; hardly any; none."""
    fastest = min(15e3, 1.5e3 / pitch) * RPM
    kind = rng.choice(["inner", "outer", "both", "counter", "tiny", "rest"], n,
                      p=[0.4, 0.15, 0.15, 0.12, 0.08, 0.1])  # fmt: skip
    speed, other = fastest * rng.uniform(0.02, 1.0, n), fastest * rng.uniform(0.02, 1.0, n)
    inner = np.select([kind == "outer", kind == "rest", kind == "tiny"], [0.0, 0.0, 1e-3 * RPM],
                      speed)  # fmt: skip
    outer = np.select([kind == "outer", kind == "both", kind == "counter"],
                      [speed, other, -other], 0.0)  # fmt: skip
    return {"inner_speed": inner, "outer_speed": outer}


def random_loads(rng: np.random.Generator, n: int, bearing: Bearing) -> dict[str, Floats]:
    """Axial loads from 50 N or less to a stout duty, radial loads up to three times that."""
    stout = 5e6 * bearing.ball_count * bearing.ball_diameter**2
    fx = np.exp(rng.uniform(np.log(min(50.0, 0.1 * stout)), np.log(stout), n))
    fx = np.where(rng.random(n) < 0.25, min(50.0, stout), fx)
    ratio = rng.choice([0.0, 0.4, 0.9, 3.0], n) * rng.uniform(0.0, 1.0, n)
    angle = rng.uniform(0.0, 2.0 * np.pi, n)
    fz, fy = fx * ratio * np.cos(angle), fx * ratio * np.sin(angle)
    odd = rng.random(n)
    fx = np.select([odd < 0.06, odd < 0.12, odd < 0.15, odd < 0.17],
                   [-fx, 0.0, 0.0, fx * 1e5], fx)  # fmt: skip
    fy, fz = (np.where((odd > 0.12) & (odd < 0.15), 0.0, f) for f in (fy, fz))
    return {"fx": fx, "fy": fy, "fz": fz}


def hard_set(seed: int, bearings: int = BEARINGS) -> list[Hard]:
    rng = np.random.default_rng(seed)
    controls = ["outer", "outer", "inner", "none", "jones"]
    found = []
    for number in range(bearings):
        bearing = random_bearing(rng)
        model = Model(raceway_control=str(rng.choice(controls)))
        case = Case(bearing=bearing, duty=Duty(), model=model)
        pitch = bearing.pitch_diameter
        for n, kind in ((48, "tilts"), (26, "moments"), (10, "x held")):
            fields = random_loads(rng, n, bearing) | random_speeds(rng, n, pitch)
            fields["first_ball_azimuth"] = rng.uniform(0.0, 2.0 * np.pi, n)
            if kind == "moments":
                for name in ("my", "mz"):
                    part = rng.choice([0.0, 0.02, 0.2], n) * rng.uniform(-1.0, 1.0, n)
                    fields[name] = np.abs(fields["fx"]) * pitch * part
            else:
                part = rng.choice([0.0, 1.0], n)
                for name in ("ry", "rz"):
                    fields[name] = np.radians(0.1) * rng.uniform(-1.0, 1.0, n) * part
            if kind == "x held":
                del fields["fx"]
                fields["x"] = bearing.ball_diameter * rng.uniform(-1e-3, 2e-3, n)
            found.append(Hard(number, case, fields))
    return found


HARD = hard_set(1991)
GREATEST_FORCE = 1e9  # N; a case refuses more


@pytest.fixture(scope="module")
def solutions() -> list[tuple[Hard, Solved]]:
    return [(hard, hard.solve()) for hard in HARD]


def test_the_set_is_as_large_as_promised(solutions: list[tuple[Hard, Solved]]) -> None:
    assert sum(len(batch) for _, batch in solutions) >= 3000
    assert np.mean(np.concatenate([batch.converged for _, batch in solutions])) > 0.6


def test_every_case_converges_or_says_why(solutions: list[tuple[Hard, Solved]]) -> None:
    cases = ordinary = 0
    open_cases: list[str] = []
    open_ordinary: list[str] = []
    for hard, batch in solutions:
        refused = batch.status.code == "invalid_input"
        assert set(batch.status.code[~refused]) <= STATUSES
        too_great = np.abs(hard.fields.get("fx", np.zeros(len(batch)))) > GREATEST_FORCE
        assert (refused == too_great).all()
        assert (batch.status.residual[batch.converged] < PROMISED).all()
        named = batch.status.code == "no_equilibrium"
        assert ((batch.status.unsupported >= 0) == named).all()
        cases += len(batch)
        ordinary += int(hard.ordinary.sum())
        for row in np.flatnonzero(batch.status.code == "not_converged"):
            (open_ordinary if hard.ordinary[row] else open_cases).append(hard.describe(row))
    assert ordinary > 1000
    assert len(open_ordinary) <= ORDINARY_WITHOUT_RESULT * ordinary, "\n".join(open_ordinary)
    assert len(open_cases) <= ANY_WITHOUT_RESULT * cases, "\n".join(open_cases)


def test_no_number_without_a_result(solutions: list[tuple[Hard, Solved]]) -> None:
    """NaN everywhere where a case has no result, and nowhere else."""
    for hard, batch in solutions:
        balls, done = batch, batch.converged
        arrays = [batch.displacement.array, batch.load.array, batch.stiffness.array]
        for contact in (balls.inner, balls.outer):
            arrays += [contact.load, contact.contact_angle, contact.deflection]
        arrays += [
            balls.elements.centrifugal_force,
            balls.elements.gyroscopic_moment,
            balls.elements.orbital_speed,
        ]
        for array in arrays:
            axes = tuple(range(1, array.ndim))
            assert np.isfinite(array).all(axis=axes)[done].all(), hard.number
            assert np.isnan(array).all(axis=axes)[~done].all(), hard.number


def test_balls_lie_where_they_can(solutions: list[tuple[Hard, Solved]]) -> None:
    """No contact pulls; both angles on the side of A1; under outer control α_o ≤ α_i."""
    for hard, batch in solutions:
        balls, done = batch, batch.converged
        inner, outer = balls.inner, balls.outer
        assert (inner.load[done] >= 0.0).all()
        assert (outer.load[done] >= 0.0).all()
        ring = ring_geometry(hard.case.bearing)
        c, s = np.cos(balls.elements.azimuth), np.sin(balls.elements.azimuth)
        x, _, _, ry, rz = (batch.displacement.array[:, i, np.newaxis] for i in range(5))
        a1 = ring.axial_offset + x + ring.inner_groove_radius * (ry * c - rz * s)
        heaviest = outer.load.max(axis=1, keepdims=True)
        clear = (
            done[:, np.newaxis] & (inner.load > 1e-6 * heaviest) & (outer.load > 1e-6 * heaviest)
        )
        side = np.where(a1 < 0.0, -1.0, 1.0)
        slack = 1e-6
        assert (side * outer.contact_angle >= -slack)[clear].all(), hard.number
        assert (side * inner.contact_angle >= -slack)[clear].all(), hard.number
        # outer control and no counter-rotation: centrifugal force turns the inner angle up
        same_way = (hard.fields["inner_speed"] * hard.fields["outer_speed"] >= 0.0)[:, np.newaxis]
        outer_control = (batch.elements.raceway_control > 0.0) & (
            hard.case.model.raceway_control != "none"
        )
        ordered = side * (inner.contact_angle - outer.contact_angle) >= -slack
        assert ordered[clear & same_way & outer_control].all(), hard.number


def test_one_bad_case_spoils_no_other(solutions: list[tuple[Hard, Solved]]) -> None:
    for hard, clean in solutions[:9]:
        fields = {name: values.copy() for name, values in hard.fields.items()}
        fields["fz"][5] = np.nan
        fields["inner_speed"][11 % len(clean)] = np.inf
        fields["fy"][7] = -np.inf
        spoilt = solve(hard.case, **fields)
        bad = np.zeros(len(clean), bool)
        bad[[5, 7, 11 % len(clean)]] = True
        assert (spoilt.status.code[bad] == "invalid_input").all()
        assert np.isnan(spoilt.displacement.array[bad]).all()
        assert np.isnan(spoilt.outer.load[bad]).all()
        np.testing.assert_array_equal(spoilt.status.number[~bad], clean.status.number[~bad])
        unit = hard.case.bearing.ball_diameter
        np.testing.assert_allclose(
            spoilt.displacement.array[~bad],
            clean.displacement.array[~bad],
            rtol=1e-7,
            atol=1e-9 * unit,
        )


def test_the_safe_path_finds_the_same(solutions: list[tuple[Hard, Solved]]) -> None:
    """The fast path and the safe path, wherever both have a result."""
    compared = 0
    others: list[str] = []
    for hard, batch in solutions[::2]:
        if hard.case.model.raceway_control == "jones":
            continue  # the order in which balls change over is part of the path
        safe = solve_cases(spread(hard.case, hard.fields, fast=False))
        done = batch.converged & safe.converged & hard.ordinary
        compared += int(done.sum())
        heaviest = batch.outer.load.max(axis=1)
        error = np.abs(batch.inner.load - safe.inner.load).max(axis=1)
        different = np.flatnonzero(done & (error > 1e-6 * heaviest))
        others += [hard.describe(row) for row in different]
    assert compared > 500
    assert len(others) <= OTHER_EQUILIBRIUM * compared, "\n".join(others)


@pytest.mark.parametrize("control", ["outer", "jones"])
@pytest.mark.parametrize("turning", ["inner_speed", "outer_speed"])
@pytest.mark.parametrize("balls", ["100Cr6", "Si3N4"])
def test_light_fast_and_tilted_all_converge(control: Any, turning: str, balls: str) -> None:
    """A real bearing: 50 N to 20 kN axial, fz/fx to 3, tilts of ±0.1°, up to 15 000 rpm."""
    bearing = Bearing(
        ball_count=16,
        ball_diameter="22.23 mm",
        pitch_diameter="125.26 mm",
        contact_angle="40 deg",
        inner_conformity=0.5232,
        outer_conformity=0.5232,
        ball_material=balls,
    )
    rng, n = np.random.default_rng(218), 400
    fx = 50.0 * np.exp(rng.uniform(0.0, np.log(400.0), n))
    fields = {
        "fx": fx,
        "fz": fx * rng.uniform(0.0, 3.0, n),
        "ry": np.radians(0.1) * rng.uniform(-1.0, 1.0, n),
        "rz": np.radians(0.1) * rng.uniform(-1.0, 1.0, n),
        turning: 15e3 * RPM * rng.uniform(0.01, 1.0, n),
    }
    model = Model(raceway_control=control)
    batch = solve(Case(bearing=bearing, duty=Duty(), model=model), **fields)
    assert batch.converged.all()
    assert batch.status.residual.max() < PROMISED
    found = batch
    loose = found.inner.load == 0.0
    assert loose.any()
    if turning == "inner_speed":  # only centrifugal force is left, and it acts radially
        assert np.abs(found.outer.contact_angle[loose]).max() < 1e-6
        assert np.abs(found.elements.gyroscopic_moment[loose]).max() < 1e-6
