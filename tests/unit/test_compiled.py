"""A kernel as plain Python and compiled: the same results, and the compiler left alone."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest

from rolamento.case import Case
from rolamento.equilibrium import rows
from rolamento.equilibrium.batch import solve_cases
from rolamento.equilibrium.problem import case_parameters
from rolamento.equilibrium.run import Solution


@pytest.mark.parametrize("speed", [0.0, 1047.0], ids=["static", "moving"])
def test_both_ways_agree(case_218: Case, speed: float) -> None:
    p = case_parameters(case_218)[:, np.newaxis].copy()
    p[rows.INNER_SPEED] = speed
    azimuth = 2.0 * np.pi * np.arange(16) / 16
    control = np.ones((1, 16))
    results = []
    for run in (solve_cases, solve_cases.compiled):
        solution = Solution.empty(1, 16)
        run(
            p, control, np.cos(azimuth), np.sin(azimuth), speed > 0.0, 0, 1, False,
            solution.arrays(),
        )  # fmt: skip
        results.append(solution)
    plain, compiled = results
    assert plain.code[0] == compiled.code[0] == 0
    np.testing.assert_allclose(plain.displacement, compiled.displacement, atol=1e-16)
    np.testing.assert_allclose(plain.reaction, compiled.reaction, rtol=1e-10, atol=1e-6)
    np.testing.assert_allclose(
        plain.stiffness, compiled.stiffness, rtol=1e-9, atol=1e-9 * plain.stiffness.max()
    )


def test_one_case_does_not_load_the_compiler() -> None:
    program = (
        "import sys, rolamento\n"
        "from importlib.resources import files\n"
        "case = rolamento.load_case(files('rolamento') / 'examples' / '218_combined.toml')\n"
        "assert rolamento.solve(case).status.converged\n"
        "loaded = {'numba', 'scipy', 'pint'} & set(sys.modules)\n"
        "sys.exit(', '.join(sorted(loaded)) or 0)"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
