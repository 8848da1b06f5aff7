"""Shafts on their bearings: a machine, its spectrum, its Campbell diagram, beside plain SciPy.

SciPy's side is what one would write: beam elements in a dense matrix, a function a bearing (balls
on Hertz's law, at rest, K taken at the nominal angle), the bearings' stiffness by differences, and
`scipy.optimize.root`.
"""

from __future__ import annotations

from functools import partial
from typing import Any, Final

import numpy as np
from scipy.optimize import root

import rolamento
from benchmarks.figures import Figure, Findings, alternately, at_least, below
from rolamento.case.machine import Machine
from rolamento.numerics import FloatArray
from rolamento.rotors import campbell
from rolamento.static import race_stiffness
from rolamento.system.beam import Elements

GROUP: Final = "machines"
AGREEMENT: Final = 5e-3
"""Of the forces: the plain side has one K for all contact angles."""
STEPS: Final = 1000
SPEEDS: Final = 40
PLACES: Final = (0.0, 0.3, 0.6)
LOAD: Final = (0.15, -5000.0)
"""Where it acts, m, and along z, N."""


def three_supports(speed: float = 0.0, steps: int = 1) -> Machine:
    """Shaft of 40 mm and 600 mm on three deep-groove bearings."""
    random = np.random.default_rng(6208)
    bearing = rolamento.Case.model_validate(
        {"bearing": {"designation": "6208"}, "duty": {}}
    ).bearing
    own = rolamento.Bearing(
        ball_count=bearing.ball_count,
        ball_diameter=bearing.ball_diameter,
        pitch_diameter=bearing.pitch_diameter,
        diametral_clearance=bearing.diametral_clearance,
        inner_conformity=bearing.inner_conformity,
        outer_conformity=bearing.outer_conformity,
    )
    factors = random.uniform(0.3, 1.2, steps)
    spectrum = [{"share": 1.0 / steps, "load_factor": float(one)} for one in factors]
    return Machine(
        shafts=[{"name": "s", "speed": speed, "sections": [{"length": 0.6, "diameter": 0.04}]}],
        bearings=[
            {"name": name, "shaft": "s", "position": place, "bearing": own,
             "located": "both" if name == "A" else "floating"}
            for name, place in zip("ABC", PLACES, strict=True)
        ],
        loads=[{"shaft": "s", "position": LOAD[0], "fz": LOAD[1], "fx": 200.0}],
        spectrum=spectrum if steps > 1 else (),
    )  # fmt: skip


def measure(sample: int, repeats: int) -> Findings:
    """One machine, a spectrum, a Campbell diagram; and the same machine by SciPy."""
    machine = three_supports()
    rolamento.shaft(machine)
    plain = PlainShaft(machine)
    found: list[FloatArray] = []

    def scipy() -> None:
        found[:] = [plain.solve()]

    def engine() -> None:
        for _ in range(sample):
            rolamento.shaft(machine)

    spent, own = alternately([scipy, engine], repeats)
    solved = rolamento.shaft(machine)
    forces = np.array([one.force[0, 2] for one in solved.bearings.values()])
    wrong = np.abs(found[0] - forces).max() / np.abs(forces).max()
    failures = [] if wrong < AGREEMENT else [f"machines: SciPy's forces differ by {wrong:.1e}"]
    many = three_supports(150.0, STEPS)
    spectrum, diagram = alternately(
        [
            partial(rolamento.shaft, many),
            partial(campbell, three_supports(150.0), np.linspace(50.0, 2000.0, SPEEDS)),
        ],
        repeats,
    )
    return Findings(
        [
            Figure(GROUP, "shaft on three bearings", 1e3 * own / sample, "ms", below(20.0)),
            Figure(GROUP, "  beside scipy.optimize.root", spent / (own / sample), "times",
                   at_least(5.0)),
            Figure(GROUP, f"spectrum of {STEPS} steps, at speed", spectrum, "s", below(2.0)),
            Figure(GROUP, f"Campbell diagram of {SPEEDS} speeds", diagram, "s", below(1.5)),
        ],
        [],
        failures,
    )  # fmt: skip


class PlainShaft:
    """The machine of `three_supports` as one would write it."""

    def __init__(self, machine: Machine, count: int = 40) -> None:
        ones = np.ones(count)
        elements = Elements(
            ones * 0.6 / count, 0.04 * ones, 0.04 * ones, 0.0 * ones, 0.0 * ones,
            206e9 * ones, 0.3 * ones, 7850.0 * ones,
        )  # fmt: skip
        self.k = np.zeros((5 * count + 5, 5 * count + 5))
        for i, own in enumerate(elements.stiffness()):
            self.k[5 * i : 5 * i + 10, 5 * i : 5 * i + 10] += own
        self.nodes = [round(count * place / 0.6) for place in PLACES]
        self.load = np.zeros(5 * count + 5)
        at = 5 * round(count * LOAD[0] / 0.6)
        self.load[at], self.load[at + 2] = 200.0, LOAD[1]
        bearing: Any = machine.bearings[0].case.bearing
        self.azimuth = 2.0 * np.pi * np.arange(bearing.ball_count) / bearing.ball_count
        total = bearing.inner_conformity + bearing.outer_conformity - 1.0
        self.reach = total * bearing.ball_diameter
        self.play = 0.5 * bearing.diametral_clearance
        self.arm = 0.5 * bearing.pitch_diameter + (bearing.inner_conformity - 0.5) * (
            bearing.ball_diameter
        )
        self.stiffness = float(np.ravel(race_stiffness(bearing, np.array(0.1)).combined)[0])

    def row(self, u: FloatArray, floating: bool) -> FloatArray:
        """Force of a row at rest on its ring; a floating one follows along x."""
        c, s = np.cos(self.azimuth), np.sin(self.azimuth)
        along = (0.0 if floating else u[0]) + self.arm * (u[3] * c - u[4] * s)
        across = self.reach - self.play + u[2] * c + u[1] * s
        length = np.hypot(along, across)
        load = self.stiffness * np.maximum(length - self.reach, 0.0) ** 1.5
        axial, radial = load * along / length, load * across / length
        force = [axial.sum(), (radial * s).sum(), (radial * c).sum(),
                 self.arm * (axial * c).sum(), -self.arm * (axial * s).sum()]  # fmt: skip
        return np.array([0.0 if floating else force[0], *force[1:]])

    def residual(self, scaled: FloatArray) -> FloatArray:
        """Unbalanced forces, over 1 kN."""
        u = scaled * self.scale
        rest = self.k @ u - self.load
        for index, node in enumerate(self.nodes):
            rest[5 * node : 5 * node + 5] += self.row(u[5 * node : 5 * node + 5], index > 0)
        return rest * self.scale * 1e3

    def jacobian(self, scaled: FloatArray) -> FloatArray:
        """Beams as they are, rows by differences."""
        u, k = scaled * self.scale, self.k.copy()
        for index, node in enumerate(self.nodes):
            at = slice(5 * node, 5 * node + 5)
            here = self.row(u[at], index > 0)
            for i in range(5):
                moved = u[at].copy()
                moved[i] += 1e-9
                k[at, 5 * node + i] += (self.row(moved, index > 0) - here) / 1e-9
        return k * self.scale[:, np.newaxis] * self.scale * 1e3

    @property
    def scale(self) -> FloatArray:
        """Micrometres and what tilts are beside them."""
        return np.tile([1e-6, 1e-6, 1e-6, 3e-5, 3e-5], len(self.load) // 5)

    def solve(self) -> FloatArray:
        """Forces of the three bearings along z; N."""
        start = np.zeros(len(self.load))
        start[2::5] = -20.0  # through the play
        found = root(self.residual, start, jac=self.jacobian, method="lm")
        u = found.x * self.scale
        return np.array([
            self.row(u[5 * n : 5 * n + 5], index > 0)[2] for index, n in enumerate(self.nodes)
        ])  # fmt: skip
