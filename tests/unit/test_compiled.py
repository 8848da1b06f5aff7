"""A kernel as plain Python and compiled: the same results, and the compiler left alone."""

from __future__ import annotations

import itertools
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import rolamento
from rolamento.case import Case
from rolamento.numerics.compiled import Kernel
from rolamento.numerics.threads import ready
from rolamento.rows.ball import layout
from rolamento.rows.ball.batch import solve_some
from rolamento.rows.ball.blocks import Batch
from rolamento.rows.ball.mirror import mirror
from rolamento.rows.ball.run import BallResponse
from rolamento.rows.ball.set_blocks import solve_sets
from rolamento.rows.roller.batch import hold_cases
from rolamento.system import spread


@pytest.mark.parametrize("speed", [0.0, 1047.0], ids=["static", "moving"])
def test_both_ways_agree(case_218: Case, speed: float) -> None:
    p = spread(case_218).rows[0].row.p
    p[layout.INNER_SPEED] = speed
    azimuth = 2.0 * np.pi * np.arange(16) / 16
    bearing = p.bearing.copy()
    batch = Batch(
        p.duty, bearing, np.ones((1, 16)), np.cos(azimuth), np.sin(azimuth), mirror(16, 0)
    )
    results = []
    for form in (lambda kernel: kernel, ready):
        solution = BallResponse.empty(1, 16)
        solve_some(batch, speed > 0.0, np.arange(1), False, 1e6, solution.arrays(), form)
        results.append(solution)
    plain, compiled = results
    assert plain.number[0] == compiled.number[0] == 0
    np.testing.assert_allclose(plain.displacement, compiled.displacement, atol=1e-16)
    np.testing.assert_allclose(plain.force, compiled.force, rtol=1e-10, atol=1e-6)
    np.testing.assert_allclose(
        plain.stiffness, compiled.stiffness, rtol=1e-9, atol=1e-9 * plain.stiffness.max()
    )


def test_one_case_does_not_load_the_compiler() -> None:
    program = (
        "import sys, rolamento\n"
        "from importlib.resources import files\n"
        "case = rolamento.load_case(files('rolamento') / 'examples' / '218_combined.toml')\n"
        "assert rolamento.solve(case).converged[0]\n"
        "loaded = {'numba', 'scipy', 'pint'} & set(sys.modules)\n"
        "sys.exit(', '.join(sorted(loaded)) or 0)"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize(
    ("example", "kernel", "needless"),
    [
        ("6012_pair.toml", solve_sets, ["numba.np.arrayobj", "numba.np.linalg", "scipy.linalg"]),
        ("30206_pinion.toml", hold_cases, ["scipy.linalg"]),
    ],
)
def test_a_set_loads_what_runs_it_and_not_what_compiles_it(
    example: str, kernel: Kernel[..., object], needless: list[str]
) -> None:
    program = (
        "import sys, rolamento\n"
        "from importlib.resources import files\n"
        f"case = rolamento.load_case(files('rolamento') / 'examples' / {example!r})\n"
        "solved = rolamento.solve(case)\n"
        "assert solved.converged[0] and solved.preload\n"
        f"print(*(name for name in ['numba', *{needless}] if name in sys.modules))"
    )
    for kept in (kernel.is_cached, True):  # compiled by the first, where nobody has before
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        if kept:
            assert done.stdout == "numba\n"


KERNEL = """
import logging, sys
from rolamento.numerics.compiled import kernel

logging.basicConfig(format="%(message)s")

@kernel
def doubled(x: float) -> float:
    return 2.0 * x

if __name__ == "__main__":
    if len(sys.argv) > 1:
        import resource
        resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv[1]), resource.RLIM_INFINITY))
    compiled = doubled.compiled
    print(compiled(21.0), sum(compiled.stats.cache_hits.values()))
"""


@pytest.fixture
def script(tmp_path: Path) -> Path:
    """A program with a kernel of its own, kept in a folder of its own."""
    path = tmp_path / "program.py"
    path.write_text(KERNEL, "utf-8")
    return path


def ran(script: Path, *arguments: str) -> tuple[str, str]:
    """Output and messages of a process, which has to end well."""
    environment = {
        **os.environ,
        "NUMBA_CACHE_DIR": str(script.with_name("kept")),
        "PYTHONPATH": str(Path(rolamento.__file__).parents[1]),
    }
    done = subprocess.run(
        [sys.executable, str(script), *arguments], capture_output=True, text=True, env=environment
    )
    assert done.returncode == 0, done.stderr
    return done.stdout, done.stderr


def kept(script: Path, ending: str) -> Path:
    (file,) = script.with_name("kept").rglob(f"*.{ending}")
    return file


@pytest.mark.slow
@pytest.mark.parametrize(
    ("damage", "ending"),
    [
        ("emptied", "nbi"),
        ("changed", "nbc"),
        *(
            pytest.param(damage, ending, marks=pytest.mark.sweep)
            for damage, ending in itertools.product(
                ("emptied", "cut", "changed", "replaced"), ("nbi", "nbc")
            )
            if (damage, ending) not in (("emptied", "nbi"), ("changed", "nbc"))
        ),
    ],
)
@pytest.mark.thirds
def test_damaged_compiled_code_is_discarded(script: Path, ending: str, damage: str) -> None:
    assert ran(script) == ("42.0 0\n", "")
    assert ran(script) == ("42.0 1\n", "")
    file = kept(script, ending)
    content = file.read_bytes()
    middle = len(content) // 2
    file.write_bytes(
        {
            "emptied": b"",
            "cut": content[:middle],
            "changed": content[:middle] + bytes([content[middle] ^ 1]) + content[middle + 1 :],
            "replaced": bytes(range(256)) * 20,
        }[damage]
    )
    output, said = ran(script)
    assert output == "42.0 0\n"
    assert said.count("\n") == 1
    assert "is damaged: compiling it anew" in said
    assert ran(script) == ("42.0 1\n", "")


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="needs limits of POSIX")
@pytest.mark.sweep
def test_compiled_code_on_a_full_disk(script: Path) -> None:
    for most in ("0", "2000"):
        output, said = ran(script, most)
        assert output == "42.0 0\n"
        assert said.count("\n") <= 1
        assert not said or "cannot be kept" in said
    assert "cannot be kept" in ran(script, "2000")[1]
    assert ran(script) == ("42.0 0\n", "")
    assert ran(script) == ("42.0 1\n", "")


def test_what_an_index_names_is_there(script: Path) -> None:
    """Another process may read at any moment: else it runs whatever an older source has left."""
    script.write_text(
        KERNEL
        + """
    import os
    replace = os.replace
    os.replace = lambda a, b: (print(os.path.splitext(b)[1]), replace(a, b))
    print(compiled(1))
""",
        "utf-8",
    )
    output, said = ran(script)
    assert output.split() == ["42.0", "0", ".nbc", ".nbi", "2.0"]
    assert said == ""
    assert len(list(script.with_name("kept").rglob("*.nbc"))) == 2  # one a signature
