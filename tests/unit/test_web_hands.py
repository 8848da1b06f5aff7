"""Several hands at once: processes beside the server answer as the server itself does."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable
from typing import Any

import anyio
import pytest

from rolamento.errors import InputError
from rolamento.units import to_si
from rolamento.web.answers import RequestError
from rolamento.web.hands import Hands
from rolamento.words import language, speaking

READY_WITHIN = 60.0
"""Seconds, on a machine that is busy."""


def nothing() -> None:
    """What such a process does to be ready, in these tests."""


def process_after(seconds: float) -> int:
    time.sleep(seconds)
    return os.getpid()


def die() -> int:
    """End the process, unless it is the server's."""
    if os.getpid() != SERVER:
        os.kill(os.getpid(), signal.SIGKILL)
    return os.getpid()


SERVER = int(os.environ.setdefault("ROLAMENTO_TEST_SERVER", str(os.getpid())))


async def all_at_once(hands: Hands, count: int, work: Callable[..., Any], *args: Any) -> list[Any]:
    found: list[Any] = []

    async def one() -> None:
        found.append(await hands.run(work, *args))

    async with anyio.create_task_group() as group:
        for _ in range(count):
            group.start_soon(one)
    return found


async def beside(hands: Hands) -> int:
    """Let several wait until a process beside the server answers; return its number."""
    with anyio.fail_after(READY_WITHIN):
        while True:
            others = {*await all_at_once(hands, 4, process_after, 0.01)} - {os.getpid()}
            if others:
                return others.pop()


def with_hands(work: Callable[[Hands], Any], processes: int = 1) -> Any:
    async def run() -> Any:
        hands = Hands(processes, ready=nothing)
        try:
            return await work(hands)
        finally:
            hands.close()

    return anyio.run(run)


def test_one_hand_starts_no_process() -> None:
    async def run(hands: Hands) -> None:
        for _ in range(3):
            assert await hands.run(os.getpid) == os.getpid()
        assert hands._starting is None

    with_hands(run)


def test_several_hands_are_answered_beside_the_server() -> None:
    """Numbers, language and refusals are as they are in the server."""

    async def run(hands: Hands) -> None:
        await beside(hands)
        assert await hands.run(os.getpid) != os.getpid()
        assert await hands.run(to_si, "10 mm", "length") == to_si("10 mm", "length")
        with speaking("pt"):
            assert await hands.run(language) == "pt"
        with pytest.raises(InputError) as here:
            to_si("10 kg", "length")
        with pytest.raises(InputError) as there:
            await hands.run(to_si, "10 kg", "length")
        assert (there.value.field, str(there.value)) == (here.value.field, str(here.value))

    with_hands(run)


def test_a_process_that_is_ended_costs_nobody_the_answer() -> None:
    """It is worked out in the server, and later in a new process."""

    async def run(hands: Hands) -> None:
        first = await beside(hands)
        assert await hands.run(die) == os.getpid()
        assert await beside(hands) not in (first, os.getpid())

    with_hands(run)


def test_processes_end_with_the_server() -> None:
    async def run(hands: Hands) -> int:
        return await beside(hands)

    number = with_hands(run)
    deadline = time.monotonic() + READY_WITHIN
    while time.monotonic() < deadline:
        try:
            os.kill(number, 0)
        except ProcessLookupError:
            return
        time.sleep(0.05)
    pytest.fail("it is still there")


def test_too_many_are_refused() -> None:
    async def run(hands: Hands) -> None:
        refused = []

        async def one() -> None:
            try:
                await hands.run(time.sleep, 0.02)
            except RequestError as error:
                refused.append(error.status)

        async with anyio.create_task_group() as group:
            for _ in range(105):
                group.start_soon(one)
        assert refused == [503] * 4

    with_hands(run, processes=0)
