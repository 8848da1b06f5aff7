"""The app under load: people who drag sliders, something slow beside them, and what memory does.

The server is `rolamento app` itself, in a process of its own. Users go in a closed loop, as the
page does: the next move is sent when the answer to the last has come. Every answer is compared with
what the engine says of the same load in one batch. `python -m benchmarks.app` measures it alone;
`--minutes 10` lets others send reports, uploads and whatever is hostile beside them.
"""

from __future__ import annotations

import argparse
import asyncio
import json
import os
import random
import re
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Final

import httpx
import numpy as np

from benchmarks.figures import Figure, Findings, below
from benchmarks.start import command_line
from benchmarks.structures import documented, mutated_tree
from rolamento import Case, solve

USERS: Final = 20
BEARINGS: Final = ("6310", "6205", "7014C", "6012", "6306")
LIMIT: Final = 150.0
"""Milliseconds, at the 95th percentile."""
PACE: Final = 0.1
"""Seconds between the moves of a hand that stops to look."""
AGREES: Final = 1e-9
GROWTH: Final = 20.0
"""Megabytes that memory may grow by over all requests, caches that fill included."""


def measure(moves: int, total: int) -> Findings:
    """Let users drag, then others beside something slow, then count memory over many requests."""
    findings = Findings.none()
    with _served() as (address, process):
        for pace, name in ((PACE, "20 users, ten moves a second"), (0.0, "20 users without pause")):
            spent = _processor(process.pid)
            times, wrong = asyncio.run(_drag(address, moves, pace))
            spent = 1e3 * (_processor(process.pid) - spent) / len(times)
            findings.add(_told(name, times, wrong, pace > 0.0))
            findings.figures.append(Figure("app", f"{name}: processor, of an answer", spent, "ms"))
        times, wrong, slow = asyncio.run(_beside_slow(address, moves))
        findings.add(_told("beside reports as PDF", times, wrong, True))
        findings.remarks.append(f"app: {slow} reports as PDF were made beside 20 users.")
        before = _memory(process.pid)
        asyncio.run(_many(address, total))
        grown = _memory(process.pid) - before  # warm: all kinds of requests have been answered
        findings.figures.append(
            Figure("app", f"memory grown over {total} requests", grown, "MB", below(GROWTH))
        )
    return findings


def _told(name: str, times: list[float], wrong: int, aimed: bool) -> Findings:
    p50, p95 = np.percentile(times, [50, 95])
    figures = [
        Figure("app", f"{name}: half of the answers within", 1e3 * p50, "ms"),
        Figure("app", f"{name}: 95 % within", 1e3 * p95, "ms", below(LIMIT) if aimed else None),
        Figure("app", f"{name}: answers", len(times) / (sum(times) / USERS), "1/s"),
    ]
    failures = [f"app, {name}: {wrong} of {len(times)} answers differ"] if wrong else []
    return Findings(figures, [], failures)


@contextmanager
def _served() -> Iterator[tuple[str, subprocess.Popen[str]]]:
    """Start the app and wait until it is warm."""
    command = [*(command_line() or ()), "app", "--no-browser"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout is not None
            found = re.search(r"http://127\.0\.0\.1:\d+", process.stdout.readline())
            assert found is not None
            while not httpx.get(f"{found[0]}/page/start", timeout=60.0).json()["ready"]:
                time.sleep(0.2)
            yield found[0], process
        finally:
            process.send_signal(signal.SIGINT)
            process.wait(30)


def _asked(bearing: str, load: float) -> dict[str, Any]:
    """What the page asks while the slider of the radial load moves."""
    case = {"bearing": {"designation": bearing}, "duty": {"inner_speed": "1500 rpm"}}
    return {
        "cases": [
            {"case": case, "changes": {"duty.load.fx": "500 N", "duty.load.fz": f"{load} N"}}
        ],
        "pictures": ["rosette"],
        "sections": [],
        "quick": True,
    }


def _loads(seed: int, moves: int) -> np.ndarray:
    """Loads that nobody else asks for, as a hand sets them: to a newton."""
    rng = np.random.default_rng(seed)
    return 1000.0 + np.cumsum(rng.uniform(0.1, 1.9, moves) * 1000.0 / moves).round(3)


def _answers(bearing: str, loads: np.ndarray) -> np.ndarray:
    """The greatest inner contact load of each, by the engine alone, N."""
    duty = {"inner_speed": "1500 rpm", "load": {"fx": "500 N"}}
    case = Case.from_mapping({"bearing": {"designation": bearing}, "duty": duty})
    return np.nanmax(solve(case, fz=loads).inner.load, axis=1)  # type: ignore[no-any-return]


async def _user(
    client: httpx.AsyncClient, number: int, seed: int, moves: int, pace: float, until: float
) -> tuple[list[float], list[bytes], np.ndarray]:
    """One person's drag: times, answers, loads."""
    bearing, loads = BEARINGS[number % len(BEARINGS)], _loads(seed, moves)
    times, bodies = [], []
    for load in loads:
        if time.perf_counter() > until:
            break
        began = time.perf_counter()
        answer = await client.post("/page/live", json=_asked(bearing, load))
        times.append(time.perf_counter() - began)
        answer.raise_for_status()
        bodies.append(answer.content)
        await asyncio.sleep(max(0.0, pace - times[-1]))
    return times, bodies, loads[: len(bodies)]


async def _drag(
    address: str, moves: int, pace: float, until: float = np.inf
) -> tuple[list[float], int]:
    async with _client(address) as client:
        seeds = np.random.default_rng(int(1e3 * pace)).integers(1 << 30, size=USERS)
        done = await asyncio.gather(
            *(_user(client, n, int(seed), moves, pace, until) for n, seed in enumerate(seeds))
        )
    wrong = 0
    for number, (_, bodies, loads) in enumerate(done):
        expected = _answers(BEARINGS[number % len(BEARINGS)], loads)
        for body, greatest in zip(bodies, expected, strict=True):
            found = json.loads(body)
            drawn = found["pictures"]["rosette"]["data"][0]["r"]
            good = found["cases"][0]["status"]["converged"]
            shown = max(value for value in drawn if value is not None)
            wrong += not (good and abs(shown - greatest) <= AGREES * greatest + 1e-6)
    return [time for times, *_ in done for time in times], wrong


async def _beside_slow(address: str, moves: int) -> tuple[list[float], int, int]:
    """Drag while reports are made one after the other."""
    count = 0

    async def reports() -> None:
        nonlocal count
        case = _asked("6310", 4000.0)["cases"][0]["case"]
        async with _client(address) as client:
            while True:
                answer = await client.post("/page/report", json={"cases": [case], "format": "pdf"})
                assert answer.content.startswith(b"%PDF")
                count += 1

    slow = asyncio.create_task(reports())
    times, wrong = await _drag(address, moves, 1.001 * PACE)
    while not count and not slow.done():
        await asyncio.sleep(0.1)
    slow.cancel()
    return times, wrong, count


def besiege(minutes: float) -> Findings:
    """Let users drag beside reports, uploads and whatever a stranger may send, for some minutes."""
    findings = Findings.none()
    with _served() as (address, process):
        asyncio.run(_besieged(address, 1.0))  # every door has been used, what is kept is there
        before = _memory(process.pid)
        times, wrong, counts = asyncio.run(_besieged(address, minutes))
        name = f"{minutes:g} min of 20 users, reports, uploads and hostile requests"
        findings.add(_told(name, times, wrong, True))
        grown = _memory(process.pid) - before
        findings.figures.append(Figure("app", f"{name}: memory grown", grown, "MB", below(GROWTH)))
        findings.remarks.append(
            "app: beside them " + ", ".join(f"{n} {what}" for what, n in sorted(counts.items()))
        )
        findings.failures += [what for what in counts if what.startswith("bad")]
    return findings


async def _besieged(address: str, minutes: float) -> tuple[list[float], int, Counter[str]]:
    """Times of the users' answers, how many are wrong, and what came of what was sent beside."""
    counts: Counter[str] = Counter()
    beside = [
        asyncio.create_task(_reports(address, counts)),
        asyncio.create_task(_uploads(address, counts)),
        *(asyncio.create_task(_hostile(address, seed, counts)) for seed in range(3)),
    ]
    moves, until = max(1, round(minutes * 60.0 / PACE)), time.perf_counter() + minutes * 60.0
    times, wrong = await _drag(address, moves, PACE, until)
    for task in beside:
        if task.done() and (error := task.exception()):
            counts[f"bad end beside: {error!r}"] += 1
        task.cancel()
    await asyncio.gather(*beside, return_exceptions=True)
    return times, wrong, counts


async def _reports(address: str, counts: Counter[str]) -> None:
    case = _asked("6310", 4000.0)["cases"][0]["case"]
    async with _client(address) as client:
        while True:
            answer = await client.post("/page/report", json={"cases": [case], "format": "pdf"})
            good = answer.content.startswith(b"%PDF") or answer.status_code == 503
            counts["reports" if good else f"bad report: {answer.status_code}"] += 1


async def _uploads(address: str, counts: Counter[str]) -> None:
    rng = np.random.default_rng(7)
    rows = "".join(f"{value:.6g}\n" for value in rng.normal(size=24_000))
    text = f"acc (m/s^2)\n{rows}".encode()
    async with _client(address) as client:
        while True:
            whole = rng.random() < 0.5
            body = text if whole else text[: rng.integers(len(text))] + rng.bytes(200)
            answer = await client.post(
                "/api/v1/diagnose",
                params={"bearing": "6205", "speed": "1797 rpm", "rate": "12 kHz"},
                content=body,
            )
            known = answer.status_code == 200 if whole else answer.status_code in (200, 413, 422)
            what = f"bad upload: {answer.status_code} {answer.text[:80]}"
            counts["uploads" if known or answer.status_code == 503 else what] += 1
            await asyncio.sleep(0.5)


_DOORS: Final = ("solve", "analyse", "life", "friction", "frequencies", "batch", "weibull")


async def _hostile(address: str, seed: int, counts: Counter[str]) -> None:
    """Cases of another shape, nests, heaps of keys, and visitors who leave before the answer."""
    rng = random.Random(seed)
    samples = [{"case": own} for own in documented()]
    async with _client(address) as client:
        while True:
            kind, patience = rng.random(), 60.0
            if kind < 0.7:
                body = mutated_tree(samples, rng)
            elif kind < 0.8:
                body = "[" * rng.choice((90, 500, 5000))
            elif kind < 0.9:
                body = "{" + ",".join(f'"k{n}":1' for n in range(rng.choice((100, 60_000)))) + "}"
            else:
                bearing = {"ball_count": 400, "ball_diameter": "5 mm", "pitch_diameter": "1 m"}
                body = json.dumps({"case": {"bearing": bearing}, "settings": {}})
                patience = 0.2
            try:
                answer = await client.post(
                    f"/api/v1/{rng.choice(_DOORS)}", content=body.encode("utf-8", "replace"),
                    headers={"Content-Type": "application/json"}, timeout=patience,
                )  # fmt: skip
            except httpx.TimeoutException:
                counts[
                    "left before the answer" if patience < 1.0 else f"bad: late: {body[:80]}"
                ] += 1
                continue
            except httpx.TransportError as error:
                counts[f"bad: {error!r}: {len(body)} characters, {body[:80]}"] += 1
                continue
            code = answer.status_code
            known = code in (200, 400, 413, 422, 429, 503) and "Traceback" not in answer.text
            counts["hostile requests" if known else f"bad answer {code} to {body[:80]}"] += 1
            await asyncio.sleep(0.05)


async def _many(address: str, total: int) -> None:
    """Ask for much, of many kinds, without looking at it."""
    async with _client(address) as client:

        async def one(worker: int) -> None:
            rng = np.random.default_rng(worker)
            for n in range(total // USERS):
                load = float(rng.uniform(500.0, 5000.0))
                kind = n % 4
                if kind < 2:
                    asked = _asked(BEARINGS[n % len(BEARINGS)], load)
                    answer = await client.post("/page/live", json=asked)
                elif kind == 2:
                    answer = await client.post("/page/open", json={"designation": f"no {load}"})
                else:
                    answer = await client.get("/page/start")
                assert answer.status_code in (200, 422), answer.text

        await asyncio.gather(*map(one, range(USERS)))


def _client(address: str) -> httpx.AsyncClient:
    limits = httpx.Limits(max_connections=USERS, max_keepalive_connections=USERS)
    return httpx.AsyncClient(base_url=address, timeout=120.0, limits=limits)


def _answering(server: int) -> Iterator[Path]:
    """What the system knows of the server, and of the processes beside it that answer hands.

    Not those of slow work, which come and go.
    """
    yield Path(f"/proc/{server}")
    for task in Path(f"/proc/{server}/task").iterdir():
        for child in (task / "children").read_text(encoding="ascii").split():
            own = Path(f"/proc/{child}")
            if b"spawn_main" in (own / "cmdline").read_bytes():
                yield own


def _memory(server: int) -> float:
    """MB that are resident of the server and the processes that answer hands."""
    total = 0.0
    for own in _answering(server):
        found = re.search(r"VmRSS:\s+(\d+) kB", (own / "status").read_text(encoding="ascii"))
        assert found is not None
        total += int(found[1]) / 1e3
    return total


def _processor(server: int) -> float:
    """Seconds that the server and the processes that answer hands have kept processors busy."""
    total = 0
    for own in _answering(server):
        fields = (own / "stat").read_text(encoding="ascii").rpartition(")")[2].split()
        total += int(fields[11]) + int(fields[12])
    return total / os.sysconf("SC_CLK_TCK")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="The app under load.")
    parser.add_argument("--minutes", type=float, help="let it be besieged so long instead")
    minutes = parser.parse_args().minutes
    found = measure(50, 10_000) if minutes is None else besiege(minutes)
    for one in found.figures:
        print(f"{one.name:60} {one.value:10.4g} {one.unit}")
    print(*found.remarks, *found.failures, sep="\n")
    sys.exit(bool(found.failures))
