"""Balls that friction controls: milliseconds a case, and a NumPy and SciPy version beside them.

SciPy begins where the engine does, at outer raceway control, takes the same steps of the
smoothing and about as many nodes; both on one thread, on the same duties.
"""

from __future__ import annotations

from functools import partial
from typing import Any, Final, Literal

import numpy as np

import rolamento
from benchmarks import duty_sets
from benchmarks.figures import Figure, Findings, alternately, at_least, below
from benchmarks.friction_model import Duty, Found, FrictionModel

FRICTION: Final = 0.07
STAGES: Final = [0.1, 0.01, 1e-3, 1e-4]
NODES: Final = (20, 54)
"""As many as the engine's fine mesh has."""
AGREEMENT: Final = 0.02
"""Greatest difference of the torque: two quadratures of sharp friction differ by some 0.1 %."""
GROUP: Final = "friction control, 218, 16 balls"


def case_of(mesh: Literal["coarse", "fine"]) -> rolamento.Case:
    """The shipped example's bearing under friction control."""
    example = duty_sets.example()
    return rolamento.Case(
        bearing=example.bearing,
        duty=example.duty,
        model=rolamento.Model(raceway_control="friction", mesh=mesh),
        lubricant=rolamento.Lubricant(kind="dry", friction_coefficient=FRICTION),
    )


def measure(cases: int, sample: int, repeats: int) -> Findings:
    """Time the engine on both meshes, and SciPy on a sample: half a minute a case, or none."""
    duties = duty_sets.some(duty_sets.tilts_held(duty_sets.CASES), cases)
    findings, spent = Findings.none(), {}
    for mesh, target in (("fine", 2.0), ("coarse", 2.0)):
        case = case_of(mesh)  # type: ignore[arg-type]
        run, wide = (partial(rolamento.solve, case, threads=n, **duties) for n in (1, 2))
        solved = run()
        seconds, on_two = alternately([run, wide], repeats)
        spent[mesh] = seconds / cases
        findings.figures += [
            Figure(GROUP, f"{mesh} mesh, one core", 1e3 * spent[mesh], "ms/case", below(target)),
            Figure(GROUP, "  two threads are faster by", seconds / on_two, "times"),
            Figure(GROUP, "  converged", 100.0 * float(solved.converged.mean()), "%"),
        ]
        if not solved.converged.any():
            findings.failures.append(f"friction control, {mesh} mesh: nothing converged")
    if sample:
        findings.add(_beside_scipy(duties, sample, spent["fine"]))
    return findings


def _beside_scipy(duties: duty_sets.Duties, sample: int, spent: float) -> Findings:
    some = duty_sets.some(duties, sample)
    fine = rolamento.solve(case_of("fine"), threads=1, **some)
    rolling = fine.answer.motion
    assert rolling is not None
    found: list[Found] = []

    def scipy() -> None:
        found[:] = [_solved(some, index) for index in range(sample)]

    seconds = alternately([scipy], 1)[0] / sample
    success = [one.success for one in found]
    findings = Findings.none()
    findings.figures += [
        Figure(GROUP, "NumPy and scipy.optimize.root", 1e3 * seconds, "ms/case"),
        Figure(GROUP, "  the engine is faster by", seconds / spent, "times", at_least(10.0)),
        Figure(GROUP, "  SciPy finds a solution", 100.0 * float(np.mean(success)), "%"),
    ]
    torque = rolling.torque("inner")
    wrong = [
        abs(one.torque / own - 1.0)
        for one, own in zip(found, torque, strict=True)
        if one.success and np.isfinite(own)
    ]
    if max(wrong, default=0.0) > AGREEMENT:
        findings.failures.append(f"friction control: SciPy's torque differs by {max(wrong):.1e}")
    return findings


def _solved(duties: duty_sets.Duties, index: int) -> Found:
    """One duty by SciPy, from the engine's solution under outer raceway control."""
    case = duty_sets.example()
    given: dict[str, Any] = {name: values[index : index + 1] for name, values in duties.items()}
    batch = rolamento.solve(case, threads=1, **given)
    motion, azimuth = batch.elements, batch.elements.azimuth[0]
    out = -motion.ball_speed[0] * np.sin(motion.attitude[0])
    spins = np.stack(
        [
            motion.orbital_speed[0] + motion.ball_speed[0] * np.cos(motion.attitude[0]),
            out * np.sin(azimuth),
            out * np.cos(azimuth),
        ],
        axis=1,
    )
    load = batch.inner.load[0]
    cage = float(np.average(motion.orbital_speed[0], weights=load))
    place = batch.answer.position[0]
    start = Found(True, batch.displacement.array[0], cage, place, spins, 0.0, 0.0)
    free = np.array([True, True, True, False, False])
    duty = Duty(
        np.where(free, batch.load.array[0], 0.0), np.zeros(5), free,
        float(duties["inner_speed"][index]), 0.0, FRICTION,
    )  # fmt: skip
    return FrictionModel(case.bearing, *NODES).solve(duty, start, STAGES)
