"""Nobody waits for the compiler: another process works while plain Python goes on."""

from __future__ import annotations

import importlib
import os
import pkgutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import rolamento
from rolamento.numerics import beside, threads
from rolamento.numerics.compiled import Kernel
from rolamento.tasks.warm import PARTS


class Pretended:
    """A kernel that somebody compiles: `cached_after` looks, it is there."""

    def __init__(self, cached_after: float = np.inf) -> None:
        self._looks = cached_after
        self.is_loaded = False
        self.is_kept = True

    @property
    def is_cached(self) -> bool:
        self._looks -= 1
        return self._looks < 0

    def compiled(self) -> None:
        """Stands for the compiled code."""


@pytest.fixture
def shared(monkeypatch: pytest.MonkeyPatch) -> Callable[..., list[tuple[str, int]]]:
    """Share cases out, and return how each was run, in order."""
    monkeypatch.delenv(beside.VARIABLE)
    monkeypatch.setattr(threads, "_spent", [0.0])
    monkeypatch.setattr(threads, "_ready", set())

    def share(kernel: Any, cases: int, *, little: bool = False) -> list[tuple[str, int]]:
        done: list[tuple[str, int]] = []

        def run(function: Any, first: int, last: int) -> None:
            how = "plain" if function is kernel else "compiled"
            done.extend((how, case) for case in range(first, last))

        threads.share_out(kernel, run, cases, chunk=2, threads=1, little=little)
        return done

    return share


def test_what_is_compiled_meanwhile_takes_over(
    shared: Callable[..., list[tuple[str, int]]], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(threads, "compile_beside", lambda: True)
    monkeypatch.setattr(threads, "SLICE", 0.0)  # one case at a time
    done = shared(Pretended(cached_after=3), 7)
    assert [case for _, case in done] == list(range(7))
    assert [how for how, _ in done] == ["plain"] * 3 + ["compiled"] * 4
    assert [how for how, _ in shared(Pretended(), 3)] == ["plain"] * 3


def test_where_nobody_compiles_it_is_done_here_once_that_is_quicker(
    shared: Callable[..., list[tuple[str, int]]], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(threads, "compile_beside", lambda: False)
    assert {how for how, _ in shared(Pretended(), 3)} == {"plain"}
    monkeypatch.setattr(threads, "_spent", [threads.COMPILING])
    assert {how for how, _ in shared(Pretended(), 3)} == {"compiled"}


def test_who_says_so_compiles_here(
    shared: Callable[..., list[tuple[str, int]]], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(beside.VARIABLE, beside.HERE)
    assert {how for how, _ in shared(Pretended(), 3)} == {"compiled"}
    assert {how for how, _ in shared(Pretended(), 1, little=True)} == {"plain"}
    assert not beside.compile_beside()


@pytest.fixture
def fresh(tmp_path: Path) -> Iterator[Callable[[str], subprocess.CompletedProcess[str]]]:
    """Run a program on a machine on which nothing is compiled."""
    kernels = tmp_path / "kernels"
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(kernels), beside.VARIABLE: ""}

    def run(program: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [sys.executable, "-c", program],
            capture_output=True,
            text=True,
            env=environment,
            cwd=tmp_path,
            timeout=120,
        )

    yield run
    lock = kernels / "compiling.lock"
    for _ in range(100):
        if lock.is_file() and (written := lock.read_text()):
            with suppress(ProcessLookupError):
                os.kill(int(written), signal.SIGKILL)
            break
        time.sleep(0.1)


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="needs locks of POSIX")
def test_a_batch_is_answered_before_anything_is_compiled(
    fresh: Callable[[str], subprocess.CompletedProcess[str]], tmp_path: Path, examples: Path
) -> None:
    (tmp_path / "numpy.py").write_text("raise SystemExit('imported from the folder of work')")
    program = (
        "import sys; sys.path.pop(0)\n"
        "import rolamento, numpy\n"
        f"case = rolamento.load_case({str(examples / '218_combined.toml')!r})\n"
        "found = rolamento.solve(case, fz=numpy.linspace(5e3, 20e3, 4))\n"
        "print(*found.displacement.array.ravel().tolist())"
    )
    first = fresh(program)
    assert first.returncode == 0, first.stderr
    assert first.stderr.count("\n") == 1
    assert "in the background" in first.stderr
    second = fresh(program)  # the process that the first has begun is still at work
    assert (second.returncode, second.stderr) == (0, "")
    assert second.stdout == first.stdout
    case = rolamento.load_case(examples / "218_combined.toml")
    compiled = rolamento.solve(case, fz=np.linspace(5e3, 20e3, 4)).displacement.array
    plain = np.array(first.stdout.split(), float).reshape(compiled.shape)
    np.testing.assert_allclose(plain, compiled, rtol=0, atol=1e-9 * np.abs(compiled).max())


@pytest.mark.skipif(os.name != "posix", reason="needs locks of POSIX")
def test_there_is_one_at_a_time(tmp_path: Path) -> None:
    program = (
        "from rolamento.numerics import beside\n"
        "from rolamento.tasks.warm import warm\n"
        "with beside.alone() as free:\n"
        "    print(free, warm().busy, beside.compile_beside())"
    )
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path), beside.VARIABLE: ""}
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, env=environment
    )
    assert (done.stdout, done.stderr) == ("True True True\n", "")


def test_a_version_is_begun_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    beside._folder.cache_clear()
    assert not beside.has_begun("1.0")
    beside.begin("1.0")
    assert beside.has_begun("1.0")
    assert not beside.has_begun("1.1")
    beside._folder.cache_clear()


def test_every_kernel_is_compiled_ahead() -> None:
    """`rolamento warm` leaves none out."""
    kernels = {
        value
        for module in pkgutil.walk_packages(rolamento.__path__, "rolamento.")
        if not module.name.endswith("__main__")
        for value in vars(importlib.import_module(module.name)).values()
        if isinstance(value, Kernel) and value._options.get("cache")
    }
    assert len(kernels) >= 20
    if not all(kernel.is_cached for kernel in kernels):
        for part in PARTS:
            part.solve()
    left = {f"{kernel.__module__}.{kernel.__name__}" for kernel in kernels if not kernel.is_cached}
    assert not left


def test_a_ball_that_takes_long_to_balance_waits_for_nobody(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """What plain Python usually leaves to the compiler it does itself while there is none."""
    case = rolamento.Case(
        bearing="7210 C",
        duty=rolamento.Duty(
            inner_speed=154.985238,
            displacement=rolamento.Displacement(x=1.28475930e-05, y=0.0, z=2.75723821e-05),
        ),
    )
    expected = rolamento.solve(case)

    def waits() -> None:
        raise AssertionError("it waits for the compiler")

    monkeypatch.delenv(beside.VARIABLE)
    monkeypatch.setattr(Kernel, "is_loaded", property(lambda self: False))
    monkeypatch.setattr(Kernel, "is_cached", property(lambda self: False))
    monkeypatch.setattr(threads, "_ready", set())
    monkeypatch.setattr(threads, "compile_beside", lambda: True)
    monkeypatch.setattr(threads, "_say_that_it_takes_a_while", waits)
    found = rolamento.solve(case)
    assert found.converged.all()
    assert expected.converged.all()
    np.testing.assert_allclose(found.inner.load, expected.inner.load, rtol=1e-9, atol=1e-6)
