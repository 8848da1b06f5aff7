"""The guide to the HTTP API: its examples are run against a server."""

from __future__ import annotations

import json
import re
import shlex
import socket
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import urlsplit

import httpx
import pytest
import uvicorn

from rolamento.web import api
from rolamento.web.server import Settings, create_app, server_options

GUIDE = (Path(__file__).parents[2] / "docs" / "http-api.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"```(python|sh)\n(.*?)```", GUIDE, re.DOTALL)


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    listener = socket.create_server(("127.0.0.1", 0))
    server = uvicorn.Server(uvicorn.Config(create_app(Settings(warm=False)), **server_options()))
    thread = threading.Thread(target=server.run, kwargs={"sockets": [listener]}, daemon=True)
    thread.start()
    until = time.monotonic() + 20.0
    while not server.started and time.monotonic() < until:
        time.sleep(0.02)
    yield f"http://127.0.0.1:{listener.getsockname()[1]}"
    server.should_exit = True
    thread.join(20.0)
    listener.close()


def test_every_address_is_in_the_guide() -> None:
    for one in (*api.OPERATIONS, api.DIAGNOSE, api.READY):
        assert f"`{one.method} {one.path}`" in GUIDE


@pytest.mark.parametrize("number", range(len(BLOCKS)))
def test_examples_of_the_guide_run(
    number: int, address: str, capsys: pytest.CaptureFixture[str]
) -> None:
    language, text = BLOCKS[number]
    if language == "python":
        exec(compile(text.replace("http://127.0.0.1:8000", address), "http-api.md", "exec"), {})
        assert capsys.readouterr().out
        return
    words = shlex.split(text.replace("\\\n", ""))
    where = next(urlsplit(word) for word in words if word.startswith("http"))
    body = json.loads(words[words.index("--json") + 1])
    asked = f"{address}{where.path}?{where.query}"
    response = httpx.post(asked, json=body, timeout=60.0)
    if "Errors" in GUIDE[: GUIDE.index(text)].rpartition("\n## ")[2]:
        assert response.status_code == 422
        told = GUIDE[GUIDE.index(text) :].partition("\n    {")[2].partition("\n\n")[0]
        assert json.loads("{" + told) == response.json()
    else:
        assert response.status_code == 200, response.text
