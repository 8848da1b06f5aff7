"""The server of the app: who is let in, how much is taken, what goes out with every answer."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import contextmanager, suppress
from functools import cache
from pathlib import Path
from typing import Any

import anyio
import anyio.to_thread
import httpx
import pytest
import uvicorn
from tests.children import python
from typer.testing import CliRunner

import rolamento
from rolamento.cli.app import app as commands
from rolamento.errors import InputError
from rolamento.units import to_si
from rolamento.web import answers, api, limits, page_api, server, warming
from rolamento.web.hands import Hands
from rolamento.web.live import live
from rolamento.web.server import Settings, create_app, server_options
from rolamento.words import speaking

HERE = "http://127.0.0.1:8000"
TOKEN = "a-token-that-is-long"
SOLVE = {"designation": "6310", "settings": {"duty.load.fz": "5 kN"}}


made = cache(create_app)


def ask(
    method: str, address: str, *, settings: Settings | None = None, base: str = HERE, **more: Any
) -> httpx.Response:
    app = made(settings or Settings(warm=False))

    async def asked() -> httpx.Response:
        transport = httpx.ASGITransport(app)
        async with httpx.AsyncClient(transport=transport, base_url=base) as client:
            return await client.request(method, address, **more)

    return anyio.run(asked)


def error_of(response: httpx.Response) -> dict[str, Any]:
    error: dict[str, Any] = response.json()["error"]
    assert {"field", "value", "message", "rule", "example"} <= error.keys()
    assert error["message"]
    assert "Traceback" not in response.text
    return error


# --- who is let in ----------------------------------------------------------------------------


def test_every_answer_has_the_policy_and_no_answer_names_the_server() -> None:
    for address, status in (("/api/v1/version", 200), ("/nowhere", 404), ("/", 200)):
        response = ask("GET", address)
        assert response.status_code == status
        policy = response.headers["content-security-policy"]
        assert "default-src 'none'" in policy
        assert "script-src 'self'" in policy
        assert "frame-ancestors 'none'" in policy
        assert "unsafe" not in policy
        assert "http:" not in policy
        assert response.headers["x-content-type-options"] == "nosniff"
        assert response.headers["referrer-policy"] == "no-referrer"
        assert response.headers["cross-origin-opener-policy"] == "same-origin"
        assert response.headers["cross-origin-resource-policy"] == "same-origin"
        assert "access-control-allow-origin" not in response.headers
        assert "server" not in response.headers


@pytest.mark.parametrize(
    ("host", "status"),
    [
        ("127.0.0.1:8000", 200),
        ("localhost:8000", 200),
        ("[::1]:8000", 200),
        ("LOCALHOST", 200),
        ("evil.example:8000", 421),
        ("127.0.0.1.evil.example", 421),
        ("", 421),
    ],
)
def test_another_hosts_name_is_refused(host: str, status: int) -> None:
    response = ask("GET", "/api/v1/version", headers={"host": host})
    assert response.status_code == status
    if status != 200:
        assert error_of(response)["field"] == "Host"


@pytest.mark.parametrize("method", ["POST", "PUT", "DELETE"])
@pytest.mark.parametrize(
    "headers",
    [
        {"origin": "http://evil.example"},
        {"origin": "null"},
        {"origin": "http://127.0.0.1:9999"},
        {"sec-fetch-site": "cross-site"},
        {"sec-fetch-site": "same-site"},
    ],
)
def test_another_sites_page_may_not_send(method: str, headers: dict[str, str]) -> None:
    response = ask(method, "/api/v1/solve", json=SOLVE, headers=headers)
    assert response.status_code == 403
    assert error_of(response)["field"] == "Origin"


def test_the_page_itself_may_send() -> None:
    headers = {"origin": HERE, "sec-fetch-site": "same-origin"}
    assert ask(
        "POST", "/api/v1/frequencies", json={"designation": "6205"}, headers=headers
    ).is_success


def test_a_token_is_asked_for_in_the_header_the_cookie_or_the_first_address() -> None:
    guarded = Settings(token=TOKEN, warm=False)

    def status(address: str = "/api/v1/version", **more: Any) -> int:
        return ask("GET", address, settings=guarded, base="http://box:8000", **more).status_code

    assert status() == 401
    assert status("/") == 401
    assert status("/static/app.css") == 401
    assert status(headers={"authorization": "Bearer wrong"}) == 401
    assert status(headers={"authorization": f"Basic {TOKEN}"}) == 401
    assert status(headers={"cookie": "rolamento_token_8000=wrong"}) == 401
    assert status(headers={"authorization": f"Bearer {TOKEN}"}) == 200
    assert status(headers={"cookie": f"x=1; rolamento_token_8000={TOKEN}"}) == 200
    first = ask("GET", f"/?token={TOKEN}&lang=pt", settings=guarded, base="http://box:8000")
    assert first.status_code == 303
    assert first.headers["location"] == "/?lang=pt"
    assert TOKEN not in first.headers["location"]
    cookie = first.headers["set-cookie"].lower()
    assert "httponly" in cookie
    assert "samesite=strict" in cookie
    assert status("/?token=wrong") == 401


def test_the_first_address_of_the_browser_lets_in_once() -> None:
    settings = Settings(token=TOKEN, code="a-code-that-counts-once", warm=False)
    address = "/?code=a-code-that-counts-once"
    first = ask("GET", address, settings=settings, base="http://box:8000")
    assert first.status_code == 303
    assert first.headers["location"] == "/"
    assert first.headers["set-cookie"].startswith("rolamento_token_8000=")
    assert ask("GET", address, settings=settings, base="http://box:8000").status_code == 401
    wrong = Settings(token=TOKEN, code="", warm=False)
    assert ask("GET", "/?code=", settings=wrong, base="http://box:8000").status_code == 401


def test_a_wrong_token_is_refused_slowly() -> None:
    guarded = Settings(token=TOKEN, warm=False)
    began = time.monotonic()
    assert ask("GET", "/", settings=guarded, base="http://box:8000").status_code == 401
    assert time.monotonic() - began >= 0.4


@pytest.mark.parametrize(
    ("address", "status"),
    [("/page/example/signal/outer_race", 403), ("/api/v1/version", 403), ("/", 200)],
)
@pytest.mark.parametrize("site", ["cross-site", "same-site"])
def test_another_sites_image_starts_no_work(address: str, status: int, site: str) -> None:
    assert ask("GET", address, headers={"sec-fetch-site": site}).status_code == status


def test_a_redirect_never_leaves_this_server() -> None:
    guarded = Settings(token=TOKEN, warm=False)
    response = ask("GET", f"http://box//evil.example/?token={TOKEN}", settings=guarded)
    assert response.status_code == 303
    assert not response.headers["location"].startswith("//")


# --- languages --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("query", "chosen", "accepted", "language"),
    [
        ("", "", "", "en"),
        ("pt", "", "en", "pt"),
        ("", "pt", "en", "pt"),
        ("en", "pt", "", "en"),
        ("", "", "pt-BR,pt;q=0.9,en;q=0.8", "pt"),
        ("", "", "de,en;q=0.2,pt;q=0.5", "pt"),
        ("", "", "pt;q=0", "en"),
        ("", "", "pt;q=x, ;;,*", "en"),
        ("xx", "", "pt", "en"),
    ],
)
def test_the_language_is_asked_for_or_the_servers_or_accepted(
    query: str, chosen: str, accepted: str, language: str
) -> None:
    assert answers.language_for(query, chosen, accepted) == language


def test_errors_are_said_in_the_language_asked() -> None:
    wrong = {"designation": "6310", "settings": {"duty.load.fz": "5 kg"}}
    english = error_of(ask("POST", "/api/v1/solve?lang=en", json=wrong))
    portuguese = error_of(ask("POST", "/api/v1/solve?lang=pt", json=wrong))
    assert english["field"] == portuguese["field"] == "duty.load.fz"
    assert english["rule"] != portuguese["rule"]


# --- what is taken ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("content", "status"),
    [
        (b"", 422),
        (b"[1]", 422),
        (b'"text"', 422),
        (b"{", 422),
        (b'{"a": NaN}', 422),
        (b'{"designation": "6310", "designation": "6205"}', 422),
        (b"\xff\xfe{}", 422),
        (b"[" * 200_000, 422),
        (b'{"a":' * 100_000, 422),
        (b'{"case": 1' + b"0" * 5000 + b"}", 422),
        (b"\x00" * 100, 422),
    ],
)
def test_what_is_no_json_object_is_refused(content: bytes, status: int) -> None:
    headers = {"content-type": "application/json"}
    response = ask("POST", "/api/v1/solve", content=content, headers=headers)
    assert response.status_code == status
    error_of(response)


def test_a_body_of_another_kind_is_refused() -> None:
    for kind in ("text/plain", "application/x-www-form-urlencoded", ""):
        response = ask("POST", "/api/v1/solve", content=b"{}", headers={"content-type": kind})
        assert response.status_code == 415
        assert error_of(response)["example"]


def test_a_body_that_says_it_is_too_large_is_not_read() -> None:
    headers = {"content-type": "application/json", "content-length": "999999999"}
    response = ask("POST", "/api/v1/solve", content=b"{}", headers=headers)
    assert response.status_code == 413
    error_of(response)


def test_a_body_that_grows_too_large_is_ended_while_it_comes() -> None:
    sent = 0

    async def endless() -> AsyncIterator[bytes]:
        nonlocal sent
        for _ in range(1000):
            sent += 1
            yield b" " * 100_000

    headers = {"content-type": "application/json"}
    response = ask("POST", "/api/v1/solve", content=endless(), headers=headers)
    assert response.status_code == 413
    assert sent < 100


def test_a_slow_sender_is_ended(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(answers, "_PATIENCE", 0.1)

    async def trickle() -> AsyncIterator[bytes]:
        yield b"{"
        await anyio.sleep(2.0)
        yield b"}"

    began = time.monotonic()
    headers = {"content-type": "application/json"}
    response = ask("POST", "/api/v1/solve", content=trickle(), headers=headers)
    assert response.status_code == 408
    assert time.monotonic() - began < 1.9


def test_addresses_and_methods_that_are_not_there() -> None:
    assert error_of(ask("GET", "/api/v1/solves"))["value"] == "/api/v1/solves"
    response = ask("GET", "/api/v1/solve")
    assert response.status_code == 405
    assert response.headers["allow"] == "POST"
    for path in ("/static/../server.py", "/static/%2e%2e/server.py", "/static/..%2fserver.py",
                 "/static//etc/passwd", "/static/%00", "/static/" + "a" * 300):  # fmt: skip
        assert ask("GET", path).status_code == 404
    many = "&".join(f"a{i}=1" for i in range(500))
    assert ask("GET", f"/api/v1/version?{many}").status_code in (200, 422)


def test_who_goes_away_while_sending_is_no_bug(caplog: pytest.LogCaptureFixture) -> None:
    async def gone() -> dict[str, Any]:
        return {"type": "http.disconnect"}

    async def send(message: Any) -> None:
        raise AssertionError(message)

    scope = {
        "type": "http",
        "method": "POST",
        "path": "/page/report",
        "query_string": b"",
        "headers": [(b"host", b"127.0.0.1"), (b"content-type", b"application/json")],
    }
    anyio.run(create_app(), scope, gone, send)
    assert "error" not in caplog.text


def test_a_bug_is_told_by_a_number_and_logged(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def broken(_: object) -> str:
        raise RuntimeError("secret /etc/path")

    monkeypatch.setitem(api._BY_PATH, "/version", _with_run(api._BY_PATH["/version"], broken))
    response = ask("GET", "/api/v1/version")
    assert response.status_code == 500
    assert "secret" not in response.text
    number = error_of(response)["message"].split()[-1]
    assert number in caplog.text
    assert "secret" in caplog.text


def _with_run(one: api.Operation, run: Callable[[Any], str]) -> api.Operation:
    from dataclasses import replace

    return replace(one, run=run)


# --- files of the page ------------------------------------------------------------------------


def test_files_of_the_page_have_their_kinds_and_are_sent_once() -> None:
    kinds = {".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml"}
    for file in sorted(server.PAGE.iterdir()):
        if file.suffix in kinds:
            plain = ask("GET", f"/static/{file.name}", headers={"accept-encoding": "identity"})
            packed = ask("GET", f"/static/{file.name}")
            assert plain.headers["content-type"].startswith(kinds[file.suffix])
            assert packed.headers["content-encoding"] == "gzip"
            assert plain.content == packed.content == file.read_bytes()
            assert plain.headers["cache-control"] == "no-cache"
            for tag in (plain.headers["etag"], packed.headers["etag"]):
                again = ask("GET", f"/static/{file.name}", headers={"if-none-match": tag})
                assert again.status_code == 304


def test_the_page_of_the_api_needs_nothing_from_elsewhere() -> None:
    for language in ("en", "pt"):
        text = ask("GET", f"/api/docs?lang={language}").text
        assert "<script>" not in text
        assert "style=" not in text
        assert "https://" not in text
        assert all(one.path in text for one in api.OPERATIONS)


# --- fast and slow ----------------------------------------------------------------------------


def test_work_in_a_process_speaks_the_language_and_refuses_whole() -> None:
    async def run() -> None:
        assert await limits.slow(to_si, "10 mm", "length") == 0.01
        with speaking("pt"), pytest.raises(InputError) as caught:
            await limits.slow(to_si, "10 kN", "length")
        assert "comprimento" in str(caught.value)

    anyio.run(run)


def test_what_takes_too_long_is_ended_and_holds_nothing_up() -> None:
    async def run() -> None:
        fast_answers: list[float] = []

        async def quick() -> None:
            await anyio.sleep(0.1)
            began = time.monotonic()
            await limits.fast(to_si, "10 mm", "length")
            fast_answers.append(time.monotonic() - began)

        began = time.monotonic()
        async with anyio.create_task_group() as group:
            group.start_soon(quick)
            with pytest.raises(answers.RequestError) as caught:
                await limits.slow(time.sleep, 60.0, seconds=0.5)
        assert caught.value.status == 504
        assert time.monotonic() - began < 30.0
        assert fast_answers[0] < 1.0

    anyio.run(run)


@pytest.mark.parametrize(
    ("asked", "seconds", "expected"),
    [
        ({"case": {"model": {"roller_contact": "slices"}}}, 0.0, ("fast", None)),
        ({"case": {"title": "not coupled at all"}}, 0.0, ("fast", None)),
        ({"case": {"model": {"roller_contact": "coupled"}}}, 0.0, ("slow", limits.SECONDS)),
        ({"cases": [{"case": {}, "changes": {"model.roller_contact": "coupled"}}]}, 0.0,
         ("slow", limits.SECONDS)),
        ({"designation": "6310"}, 120.0, ("slow", 120.0)),
        ({"case": {"bearing": {"ball_count": 500, "rows": [{}] * 32}}}, 0.0,
         ("slow", limits.SECONDS)),
        ({"designation": "6310", "settings": {"bearing.ball_count": "500"}}, 0.0,
         ("slow", limits.SECONDS)),
        ({"case": {"bearing": {"ball_count": 40, "arrangement": "DBDB"}}}, 0.0, ("fast", None)),
        ({"case": {"bearing": {"ball_count": 1e400, "rows": "many"}}}, 0.0, ("fast", None)),
    ],
)  # fmt: skip
def test_a_heavy_case_is_slow_wherever_it_stands(
    asked: dict[str, Any],
    seconds: float,
    expected: tuple[str, float | None],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async def fast(*_: object, **__: object) -> tuple[str, None]:
        return "fast", None

    async def slow(*_: object, seconds: float) -> tuple[str, float]:
        return "slow", seconds

    monkeypatch.setattr(limits, "fast", fast)
    monkeypatch.setattr(limits, "slow", slow)

    async def run() -> None:
        assert await limits.by_weight(to_si, asked=asked, seconds=seconds) == expected

    anyio.run(run)


def test_too_many_that_wait_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    async def run() -> None:
        queue = limits.Limits(1, 2)
        monkeypatch.setattr(limits, "_queue", lambda *_: queue)
        refused = []

        async def one() -> None:
            try:
                await limits.fast(time.sleep, 0.2)
            except answers.RequestError as error:
                refused.append(error.status)

        async with anyio.create_task_group() as group:
            for _ in range(6):
                group.start_soon(one)
                await anyio.sleep(0.02)
        assert refused == [503, 503, 503]

    anyio.run(run)


def test_a_hand_does_not_wait_for_programs() -> None:
    """However many requests of programs run, a thread is left for the page."""

    async def run() -> float:
        hands = Hands(processes=0)
        async with anyio.create_task_group() as group:
            for _ in range(5):
                group.start_soon(limits.fast, time.sleep, 0.2)
            await anyio.sleep(0.05)
            began = time.perf_counter()
            await hands.run(to_si, "10 mm", "length")
            return time.perf_counter() - began

    assert anyio.run(run) < 0.5  # five of them take a second


def test_what_is_small_goes_first_but_not_for_ever() -> None:
    """Of those who wait; whoever came much earlier is not overtaken again and again."""

    async def run() -> None:
        turns, order = limits.Turns(1, 8), []

        async def one(name: str, size: float) -> None:
            async with turns.turn(size):
                order.append(name)
                await anyio.sleep(0.02)

        async with anyio.create_task_group() as group:
            for name, size in [("first", 1e6), ("large", 1e5), ("small", 10.0), ("less", 1e2)]:
                group.start_soon(one, name, size)
                await anyio.sleep(0)
        assert order == ["first", "small", "less", "large"]

        order.clear()
        async with anyio.create_task_group() as group:
            group.start_soon(one, "first", 1.0)
            await anyio.sleep(0)
            group.start_soon(one, "large", 1e5)
            for number in range(7):
                await anyio.sleep(0)
                group.start_soon(one, f"small {number}", 1.0)
        assert 3 <= order.index("large") <= 6

    anyio.run(run)


def test_turns_are_not_lost(monkeypatch: pytest.MonkeyPatch) -> None:
    """By who is refused, gives up waiting, or fails."""

    async def run() -> None:
        turns = limits.Turns(1, 1)
        refused = []

        async def one(seconds: float) -> None:
            try:
                async with turns.turn(1.0):
                    await anyio.sleep(seconds)
            except answers.RequestError as error:
                refused.append(error.status)

        async with anyio.create_task_group() as group:
            for _ in range(3):
                group.start_soon(one, 0.05)
                await anyio.sleep(0)
        assert refused == [503]
        async with anyio.create_task_group() as group:
            group.start_soon(one, 0.2)
            await anyio.sleep(0)
            with anyio.move_on_after(0.05):
                await one(0.0)
            monkeypatch.setattr(limits, "_LONGEST_WAIT", 0.02)
            await one(0.0)
        assert refused == [503, 503]
        with pytest.raises(ZeroDivisionError):
            async with turns.turn(1.0):
                raise ZeroDivisionError
        with anyio.fail_after(1.0):
            await one(0.0)

    anyio.run(run)


def test_what_is_asked_for_is_counted(tmp_path: Path) -> None:
    record = tmp_path / "a.wav"
    record.write_bytes(bytes(50_000))
    bearing = {"bearing": {"ball_count": 20, "arrangement": "DB"}}
    assert limits._size_of((str(record), "a.wav")) == 50.0
    assert limits._size_of(([{"case": bearing}] * 3, {}, "pdf")) == 3 * 40.0 + 1.0
    slow = {"case": {"model": {"roller_contact": "coupled"}}}
    assert limits._size_of((slow,)) > 1e4


KILLED = """
import os, pathlib, signal
path = pathlib.Path({path!r})
path.touch()
if len(path.read_text()) < {times}:
    path.write_text(path.read_text() + "x")
    os.kill(os.getpid(), signal.SIGKILL)
"""
"""Ends the process that it runs in, so many times."""


@pytest.mark.skipif(os.name != "posix", reason="needs signals of POSIX")
@pytest.mark.parametrize(("times", "expected"), [(1, None), (2, 503)])
def test_a_killed_worker_is_tried_once_more(times: int, expected: object, tmp_path: Path) -> None:
    async def run() -> object:
        try:
            await limits.slow(exec, KILLED.format(path=str(tmp_path / "count"), times=times))
        except answers.RequestError as error:
            assert answers.refused(error).headers["retry-after"]
            return error.status
        return None

    assert anyio.run(run) == expected


def test_other_requests_go_on_while_a_body_is_parsed() -> None:
    body = json.dumps({"designation": "6205", "settings": {f"a{i}": 1 for i in range(60_000)}})

    async def run() -> float:
        app = made(Settings(warm=False))
        longest = 0.0
        async with (
            httpx.AsyncClient(transport=httpx.ASGITransport(app), base_url=HERE) as client,
            anyio.create_task_group() as group,
        ):
            done = anyio.Event()

            async def send() -> None:
                kind = {"content-type": "application/json"}
                for _ in range(3):
                    response = await client.post("/api/v1/solve", content=body, headers=kind)
                    assert response.status_code == 422
                done.set()

            group.start_soon(send)
            while not done.is_set():
                began = time.monotonic()
                await anyio.sleep(0.001)
                longest = max(longest, time.monotonic() - began)
        return longest

    whole = time.monotonic()
    json.loads(body)
    assert anyio.run(run) < 1.0 + 5.0 * (time.monotonic() - whole)


def test_files_of_one_sender_do_not_take_all_places() -> None:
    async def run() -> list[int]:
        refused: list[int] = []

        async def one(sender: str) -> None:
            scope = {"type": "http", "client": (sender, 1), "headers": []}

            async def receive() -> dict[str, Any]:
                await anyio.sleep(0.2)
                return {"type": "http.request", "body": b"", "more_body": False}

            try:
                async with answers.received(answers.Request(scope, receive), 100):
                    await anyio.sleep(0.2)
            except answers.RequestError as error:
                refused.append(error.status)

        async with anyio.create_task_group() as group:
            for sender in (*["203.0.113.1"] * 5, "203.0.113.2"):
                group.start_soon(one, sender)
        return refused

    assert anyio.run(run) == [503, 503]


def test_a_body_may_not_take_for_ever(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(answers, "_LONGEST", 0.2)
    monkeypatch.setattr(answers, "_PATIENCE", 60.0)

    async def run() -> int:
        async def receive() -> dict[str, Any]:
            await anyio.sleep(0.05)
            return {"type": "http.request", "body": b"x", "more_body": True}

        request = answers.Request({"type": "http", "headers": []}, receive)
        with pytest.raises(answers.RequestError) as caught:
            await answers.read_body(request)
        return caught.value.status

    assert anyio.run(run) == 408


def test_a_visitor_who_leaves_ends_the_work() -> None:
    async def run() -> None:
        async def gone() -> dict[str, Any]:
            await anyio.sleep(0.2)
            return {"type": "http.disconnect"}

        token = limits.VISITOR.set(gone)
        began = time.monotonic()
        with pytest.raises(answers.RequestError) as caught:
            await limits.slow(time.sleep, 60.0)
        limits.VISITOR.reset(token)
        assert caught.value.status == 499
        assert time.monotonic() - began < 30.0

    anyio.run(run)


def test_making_ready_goes_on_when_a_step_fails(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def broken(_: object) -> None:
        raise RuntimeError("no")

    monkeypatch.setattr(warming, "_follow", broken)
    monkeypatch.setattr(page_api, "start", lambda: {})
    warmth = warming.Warmth()
    warming.make_ready(warmth)
    assert warmth.to_mapping() == {"ready": True, "done": warmth.total, "total": warmth.total}
    assert "making ready" in caplog.text


@pytest.mark.parametrize("case", [warming._BALLS, warming._SET, warming._ROLLERS])
def test_making_ready_follows_cases_that_are_right(case: dict[str, Any]) -> None:
    analysis = live({"cases": [{"case": {**case, **warming._REST}}], "quick": True})
    (answer,) = analysis["cases"]
    assert answer["error"] is None
    assert answer["status"]["converged"]
    assert "analysis.film.viscosity_ratio" in {one["key"] for one in analysis["figures"][0]}


# --- a real server ----------------------------------------------------------------------------


@contextmanager
def running(settings: Settings) -> Iterator[int]:
    """A server in a thread of this process, at a free port."""
    listener = socket.create_server(("127.0.0.1", 0))
    own = uvicorn.Server(uvicorn.Config(create_app(settings), **server_options()))
    thread = threading.Thread(target=own.run, kwargs={"sockets": [listener]}, daemon=True)
    thread.start()
    try:
        until = time.monotonic() + 20.0
        while not own.started and time.monotonic() < until:
            time.sleep(0.02)
        yield listener.getsockname()[1]
    finally:
        own.should_exit = True
        thread.join(20.0)
        listener.close()


def test_silent_connections_and_damaged_requests_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(server, "_FIRST_REQUEST", 0.3)
    with running(Settings(warm=False)) as port:
        with socket.create_connection(("127.0.0.1", port), timeout=10.0) as silent:
            silent.sendall(b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n")
            assert silent.recv(100) == b""
        with socket.create_connection(("127.0.0.1", port), timeout=10.0) as other:
            other.sendall(b"\x16\x03\x01 nonsense\r\n\r\n")
            said = other.recv(2000)
            assert b"400" in said
            assert b"x-content-type-options: nosniff" in said
        with socket.create_connection(("127.0.0.1", port), timeout=10.0) as long_one:
            long_one.sendall(b"GET /?" + b"a" * 100_000)
            assert b"200" not in long_one.recv(1000)[:20]
        assert httpx.get(f"http://127.0.0.1:{port}/api/v1/version").json() == {
            "version": rolamento.__version__
        }


def test_connections_of_one_address_are_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(server, "_MOST_OF_ONE", 3)
    with running(Settings(warm=False)) as port:
        held = [socket.create_connection(("127.0.0.1", port), timeout=10.0) for _ in range(3)]
        time.sleep(0.2)
        one_more = socket.create_connection(("127.0.0.1", port), timeout=10.0)
        with one_more, suppress(ConnectionResetError):
            assert one_more.recv(100) == b""
        for own in held:
            own.close()
        time.sleep(0.2)
        assert httpx.get(f"http://127.0.0.1:{port}/api/v1/version").is_success


def test_an_answer_waits_for_no_echo() -> None:
    with running(Settings(warm=False)) as port, httpx.Client() as client:
        address = f"http://127.0.0.1:{port}/api/v1/version"
        times = []
        for _ in range(20):
            began = time.perf_counter()
            client.get(address)
            times.append(time.perf_counter() - began)
        assert min(times) < 0.03  # 40 ms with Nagle's algorithm


def test_ctrl_c_ends_the_program_without_a_word_too_many() -> None:
    program = (
        "from rolamento.cli import main; import sys;"
        "from rolamento.web import server; server.make_ready = lambda warmth: None;"
        "server.make_worker_ready = print;"
        "sys.argv = ['rolamento', 'app', '--no-browser']; main()"
    )
    pipes: dict[str, Any] = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    with python("-c", program, env={"LANG": "C"}, **pipes) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        assert "http://127.0.0.1:8" in process.stdout.readline()
        process.send_signal(signal.SIGINT)
        assert process.wait(20.0) == 0
        assert process.stderr.read() == ""


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["--port", "0"], "--port"),
        (["--port", "70000"], "--port"),
        (["--port", "x"], "--port"),
        (["--host", "evil.example"], "--host"),
        (["--host", "203.0.113.7"], "203.0.113.7"),
        (["--token", "short"], "--token"),
        (["--token", "with spaces in it"], "--token"),
        (["--unknown"], "--unknown"),
    ],
)
def test_wrong_usage_is_told_in_a_line(arguments: list[str], told: str) -> None:
    found = CliRunner().invoke(commands, ["app", "--no-browser", *arguments])
    assert found.exit_code == 2
    assert told in found.output


def test_a_port_that_is_taken_is_told_or_the_next_one_is_found(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    from rolamento.cli import browser

    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        with pytest.raises(InputError, match="in use"):
            browser._listening("127.0.0.1", port)
        monkeypatch.setattr(browser, "_PORT", port)
        with browser._listening("127.0.0.1", None) as found:
            assert port < found.getsockname()[1] < port + 50


def test_another_address_has_a_token_in_the_address_that_is_told() -> None:
    from rolamento.cli import browser

    settings = Settings(host="0.0.0.0", token=TOKEN)
    assert browser._address(settings, 8000, own=True) == f"http://127.0.0.1:8000/?token={TOKEN}"
    assert TOKEN in browser._address(settings, 8000, own=False)
    assert browser._address(Settings(host="::1"), 8000, own=True) == "http://[::1]:8000/"


def test_importing_the_package_imports_no_server() -> None:
    program = "import sys, rolamento, rolamento.cli; print([m for m in sys.modules if m.startswith(('uvicorn', 'starlette', 'rolamento.web'))])"  # noqa: E501
    found = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert found.stdout.strip() == "[]"
    assert Path(rolamento.__file__).exists()
