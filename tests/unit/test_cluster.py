"""A study on a Dask cluster of real processes, one of which is killed half way."""

from __future__ import annotations

import os
import re
import signal
import socket
import socketserver
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path
from types import SimpleNamespace
from typing import Any, ClassVar

import numpy as np
import pytest
from tests.children import python

from rolamento import studies
from rolamento.cli.app import app
from rolamento.studies.cluster import ClusterError, _result, dask_cluster

distributed = pytest.importorskip("distributed")

STUDY = """
title = "a small study in many chunks"
seed = 7
outputs = ["x", "z", "max_inner_load", "inner_load"]

[case.bearing]
ball_count = 16
ball_diameter = "22.23 mm"
pitch_diameter = "125.26 mm"
contact_angle = "40 deg"
inner_conformity = 0.5232
outer_conformity = 0.5232

[case.duty]
inner_speed = "10000 rpm"

[case.duty.load]
fx = "20 kN"
fz = "15 kN"

[scatter]
count = 3000

[scatter.fields."duty.load.fx"]
distribution = "normal"
mean = "20 kN"
standard_deviation = "2 kN"

[scatter.fields."bearing.contact_angle"]
distribution = "uniform"
minimum = "38 deg"
maximum = "42 deg"
"""
CHUNK = 100
ROUNDING = 1e-11  # each process may have compiled the kernels for itself


@pytest.fixture(scope="module")
def cluster() -> Iterator[Any]:
    with distributed.LocalCluster(
        n_workers=2,
        threads_per_worker=1,
        processes=True,
        dashboard_address=":0",
        silence_logs=50,
    ) as cluster:
        yield cluster


@pytest.fixture(scope="module")
def local(tmp_path_factory: pytest.TempPathFactory) -> Any:
    file = tmp_path_factory.mktemp("local") / "result.nc"
    studies.run_to_file(studies.parse_study(STUDY), file, chunk=CHUNK, threads=2)
    return studies.load_result(file)


@pytest.fixture(scope="module")
def undisturbed(cluster: Any, tmp_path_factory: pytest.TempPathFactory) -> Any:
    """On the cluster, with nobody killed."""
    file = tmp_path_factory.mktemp("cluster") / "result.nc"
    executor = dask_cluster(cluster.scheduler_address)
    for _ in range(2):  # once for every worker to compile or load its kernels from one cache
        studies.run_to_file(studies.parse_study(STUDY), file, chunk=CHUNK, executor=executor)
    return studies.load_result(file)


def same(one: Any, other: Any, rtol: float = ROUNDING) -> None:
    """All alike: statuses to the letter, numbers to what two compilations may differ by."""
    assert set(one.variables) == set(other.variables)
    np.testing.assert_array_equal(one["status"].values, other["status"].values)
    for name in one.variables:
        size = np.nanmax(np.abs(other[name].values.astype(np.float64)), initial=0.0)
        np.testing.assert_allclose(
            one[name].values, other[name].values, rtol=rtol, atol=rtol * size
        )


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::DeprecationWarning", "ignore::ResourceWarning")
def test_a_killed_worker_changes_nothing(
    cluster: Any, undisturbed: Any, local: Any, tmp_path: Path
) -> None:
    victims = [worker["pid"] for worker in _workers(cluster)]
    seen: list[int] = []

    def kill_half_way(done: int, total: int, failed: int) -> None:
        seen.append(done)
        if victims and done >= total // 3:
            os.kill(victims.pop(), signal.SIGKILL)
            victims.clear()

    file = tmp_path / "result.nc"
    summary = studies.run_to_file(
        studies.parse_study(STUDY),
        file,
        chunk=CHUNK,
        executor=dask_cluster(cluster.scheduler_address),
        progress=kill_half_way,
    )
    assert not victims
    assert summary.cases == 3000 == seen[-1]
    same(studies.load_result(file), undisturbed)
    same(studies.load_result(file), local)


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::DeprecationWarning", "ignore::ResourceWarning")
def test_a_run_that_stopped_on_the_cluster_goes_on_here(
    cluster: Any, local: Any, tmp_path: Path
) -> None:
    def stop(done: int, total: int, failed: int) -> None:
        if done >= total // 2:
            raise KeyboardInterrupt

    file, study = tmp_path / "result.nc", studies.parse_study(STUDY)
    executor = dask_cluster(cluster.scheduler_address)
    with pytest.raises(studies.Interrupted):
        studies.run_to_file(study, file, chunk=CHUNK, executor=executor, progress=stop)
    summary = studies.run_to_file(study, file, chunk=CHUNK)
    assert 0 < summary.solved < 3000
    same(studies.load_result(file), local)


class Fetched:
    """A future whose worker is lost before its result is fetched: it comes the third time."""

    def __init__(self) -> None:
        self.asked = 0

    def result(self, timeout: float) -> tuple[list[Any], float]:
        self.asked += 1
        if self.asked < 3:
            raise TimeoutError(f"timed out after {timeout:g} s.")
        return [], 0.5


class Asked:
    """A client whose scheduler answers, or does not."""

    scheduler = SimpleNamespace(identity=None)

    def __init__(self, status: str) -> None:
        self.status = status

    def sync(self, action: None, callback_timeout: float) -> None:
        pass


def test_a_result_lost_before_it_was_fetched_is_waited_for() -> None:
    future = Fetched()
    assert _result(future, Asked("running")) == ([], 0.5)
    assert future.asked == 3
    with pytest.raises(TimeoutError, match="gone away"):
        _result(Fetched(), Asked("closed"))


def _workers(cluster: Any) -> list[dict[str, Any]]:
    with distributed.Client(cluster.scheduler_address, set_as_default=False) as client:
        pids = client.run(os.getpid)
    return [{"address": address, "pid": pid} for address, pid in pids.items()]


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:9", "nonsense://x", "127.0.0.1"])
def test_no_scheduler(address: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rolamento.studies.cluster.PATIENCE", 1.0)
    plan = studies.plan.Plan(studies.parse_study(STUDY), CHUNK)
    with pytest.raises(ClusterError, match="cannot be reached"):
        next(dask_cluster(address)(plan, [0]))


def test_without_dask(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    plan = studies.plan.Plan(studies.parse_study(STUDY), CHUNK)
    with pytest.raises(ClusterError, match="not installed"):
        next(dask_cluster("tcp://127.0.0.1:8786")(plan, [0]))


def test_the_command_says_what_is_wrong(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("rolamento.studies.cluster.PATIENCE", 1.0)
    study = tmp_path / "study.toml"
    study.write_text(STUDY, encoding="utf-8")
    arguments = ["sweep", str(study), "-o", str(tmp_path / "r.nc"), "--scheduler", "127.0.0.1:9"]
    for more, said in (
        (["--threads", "2"], "cannot be combined with --scheduler: the cluster has its"),
        ([], "cannot be reached"),
    ):
        with pytest.raises(SystemExit) as end:
            app([*arguments, *more])
        assert end.value.code == 2
        assert said in capsys.readouterr().err


# --- what answers there is no scheduler, or goes away ----------------------------------------

LONGEST = 15.0
"""Seconds until a message; each takes half of it where nothing else runs."""


@contextmanager
def swept(folder: Path, address: str) -> Iterator[subprocess.Popen[str]]:
    """The command in a process of its own: its exit code and all that it says matter."""
    (folder / "study.toml").write_text(STUDY.replace("count = 3000", "count = 400000"), "utf-8")
    code = (
        "from rolamento.cli.app import app;"
        f"app(['sweep', 'study.toml', '-o', 'r.nc', '--scheduler', {address!r}])"
    )
    pipes: dict[str, Any] = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    with python("-c", code, cwd=folder, **pipes) as process:
        yield process


def check_end(process: subprocess.Popen[str], says: str, since: float | None = None) -> None:
    """One message and the code 2, soon after the command has begun or something has happened.

    Before it, of a sweep that takes its time on a busy machine, how far it has come.
    """
    begin = time.monotonic() if since is None else since
    out, errors = process.communicate(timeout=120)
    seconds = time.monotonic() - begin
    assert (process.returncode, out) == (2, "")
    *progress, message = errors.splitlines()
    assert message.startswith("rolamento: --scheduler: ")
    assert says in message
    assert all(re.match(r"rolamento: [\d ]+ of 400 000 cases, ", line) for line in progress)
    assert seconds < 2.0 * LONGEST  # twice, for the machine may be busy


class Stranger(socketserver.BaseRequestHandler):
    """Takes a connection, and says what it has to say."""

    greeting: ClassVar[bytes | None] = None

    def handle(self) -> None:
        if self.greeting is None:
            time.sleep(60.0)
        else:
            self.request.sendall(self.greeting)


class Web(Stranger):
    greeting = b"HTTP/1.1 400 Bad Request\r\nConnection: close\r\n\r\n"


class Closing(Stranger):
    greeting = b""


@pytest.mark.slow
@pytest.mark.parametrize("handler", [Stranger, Web, Closing])
@pytest.mark.sweep
def test_something_else_at_the_address(tmp_path: Path, handler: type[Stranger]) -> None:
    with socketserver.ThreadingTCPServer(("127.0.0.1", 0), handler) as server:
        server.daemon_threads = True
        threading.Thread(target=server.serve_forever, daemon=True).start()
        port = server.server_address[1]
        with swept(tmp_path, f"tcp://127.0.0.1:{port}") as process:
            check_end(process, "cannot be reached")
        server.shutdown()


@pytest.mark.parametrize("address", ["abc", "ftp://127.0.0.1:1", "tcp://"])
@pytest.mark.sweep
def test_an_address_that_is_none(tmp_path: Path, address: str) -> None:
    with swept(tmp_path, address) as process:
        check_end(process, "cannot be reached")


@pytest.fixture
def dask_processes() -> Iterator[tuple[str, subprocess.Popen[bytes]]]:
    """A scheduler and a worker as a user starts them: the address, and the scheduler."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        address = f"tcp://127.0.0.1:{free.getsockname()[1]}"
    quiet: dict[str, Any] = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}

    def started(command: str, *arguments: str) -> AbstractContextManager[subprocess.Popen[bytes]]:
        code = f"from distributed.cli.dask_{command} import main; main()"
        return python("-c", code, *arguments, **quiet)

    host, port = address.removeprefix("tcp://").split(":")
    with (
        started("scheduler", "--host", host, "--port", port, "--no-dashboard") as scheduler,
        started("worker", address, "--nthreads", "1", "--no-dashboard", "--no-nanny"),
    ):
        with distributed.Client(address, timeout="60 s", set_as_default=False) as client:
            client.wait_for_workers(1, timeout=60)
        yield address, scheduler


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="needs POSIX signals")
@pytest.mark.filterwarnings("ignore::DeprecationWarning", "ignore::ResourceWarning")
@pytest.mark.parametrize(
    "how", [signal.SIGKILL, pytest.param(signal.SIGSTOP, marks=pytest.mark.sweep)]
)
@pytest.mark.sweep
def test_a_scheduler_that_is_lost(
    tmp_path: Path, dask_processes: tuple[str, subprocess.Popen[bytes]], how: signal.Signals
) -> None:
    """Killed, or there and silent: said, with all that was solved kept."""
    address, scheduler = dask_processes
    with swept(tmp_path, address) as process:
        parts, deadline = tmp_path / "r.nc.parts", time.monotonic() + 120.0
        while not list(parts.glob("*.npz")) and time.monotonic() < deadline:
            assert process.poll() is None
            time.sleep(0.05)
        scheduler.send_signal(how)
        try:
            check_end(process, "what was solved is kept", time.monotonic())
        finally:
            scheduler.send_signal(signal.SIGCONT)
    assert list(parts.glob("*.npz"))
