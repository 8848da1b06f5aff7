"""What the page's addresses are sent by those who mean harm: each is refused, in words, at once."""

from __future__ import annotations

import io
import json
import time
import zipfile
from typing import Any

import anyio
import httpx
import pytest

from rolamento.web.server import Settings, create_app

APP = create_app(Settings(warm=False))
CASE: dict[str, Any] = {"bearing": {"designation": "6310"}, "duty": {"load": {"fz": "5 kN"}}}
AT_ONCE = 20.0
"""Seconds, on a machine that is busy."""


def ask(method: str, address: str, seconds: float = AT_ONCE, **more: Any) -> httpx.Response:
    """Ask the server as it stands, without a network."""

    async def asked() -> httpx.Response:
        transport = httpx.ASGITransport(APP)
        async with httpx.AsyncClient(transport=transport, base_url="http://127.0.0.1:8000") as one:
            return await one.request(method, address, **more)

    began = time.perf_counter()
    response = anyio.run(asked)
    assert time.perf_counter() - began < seconds
    assert "Traceback" not in response.text
    assert "/home/" not in response.text
    return response


def post(path: str, body: str) -> httpx.Response:
    return ask("POST", path, content=body, headers={"content-type": "application/json"})


def live(changes: dict[str, Any], **more: Any) -> httpx.Response:
    entry = {"case": CASE, "changes": changes}
    return post("/page/live", json.dumps({"cases": [entry], "quick": True, **more}))


@pytest.mark.parametrize("path", ["/page/live", "/page/open", "/page/save", "/page/curve"])
@pytest.mark.parametrize(
    "body",
    [
        "[" * 100_000,
        '{"a":' * 5_000 + "1" + "}" * 5_000,
        '{"a":' * 450 + "1" + "}" * 450,
        '{"case": ' + "[" * 970 + "]" * 970 + "}",
        '{"cases": [NaN], "case": NaN, "text": NaN}',
        '{"cases": 1e999, "case": 1e999, "text": 1e999}',
        '{"cases": ' + "9" * 10_000 + "}",
        '{"cases": "\\ud800", "case": "\\ud800", "text": "\\ud800"}',
        '{"__proto__": {"admin": true}, "constructor": {}}',
        '{"cases": [' + ",".join(["{}"] * 10_000) + "]}",
    ],
    ids=[
        "open",
        "deep",
        "half deep",
        "nearly too deep",
        "NaN",
        "infinite",
        "long number",
        "half a letter",
        "names",
        "list",
    ],
)
def test_a_body_that_is_made_to_break_is_refused(path: str, body: str) -> None:
    response = post(path, body)
    assert response.status_code in (400, 413, 422)
    assert response.json()["error"]["message"]


@pytest.mark.parametrize(
    "value",
    [1e308, -1e308, 5e-324, "1e308 kN", "NaN N", "inf N", "1e999 N", "9" * 4000, "\0", "٣ kN", [[]],
     {"a": 1}, True, "__import__('os').system('true')", "../../etc/passwd"],
    ids=lambda value: str(value)[:20].replace("\0", "nul"),
)  # fmt: skip
def test_a_value_that_is_no_load_is_told_at_its_field(value: Any) -> None:
    response = live({"duty.load.fz": value})
    assert response.status_code == 200
    one = response.json()["cases"][0]
    assert one["error"]["message"] or not one["status"]["converged"]
    assert not any(word in response.text for word in ("NaN,", "Infinity"))


@pytest.mark.parametrize(
    "name",
    ["__class__", "duty.__dict__", "duty.load.fz.x.y", "", ".", "duty..load", "bearing.rows.999999",
     "bearing.rows.-1.position", "../case", "x" * 10_000],
    ids=lambda name: name[:20] or "none",
)  # fmt: skip
def test_a_field_that_is_none_is_told(name: str) -> None:
    one = live({name: "5 kN"}).json()["cases"][0]
    assert one["error"]["message"]


def test_keys_of_pictures_and_sections_are_those_of_the_page() -> None:
    many = [f"x{n}" for n in range(20_000)] + ["__class__", "../loads", "rosette"]
    answer = live({}, pictures=many, sections=many)
    assert answer.status_code in (200, 422)
    if answer.status_code == 200:
        assert set(answer.json()["pictures"]) == {"rosette"}
        assert answer.json()["sections"] == {}


def test_a_set_of_too_many_rows_is_refused() -> None:
    rows = [{"position": f"{n} mm"} for n in range(5_000)]
    one = live({"bearing.rows": rows}).json()["cases"][0]
    assert one["error"]["message"]


@pytest.mark.parametrize("count", [10**6, 10**9, 10**30])
def test_a_bearing_of_a_million_balls_is_refused(count: int) -> None:
    response = post(
        "/page/live",
        json.dumps({"cases": [{"case": {**CASE, "bearing": {
            "ball_count": count, "ball_diameter": "1 mm", "pitch_diameter": "1 m",
            "contact_angle": "15 deg", "inner_conformity": 0.52, "outer_conformity": 0.52}}}]}),
    )  # fmt: skip
    assert response.json()["cases"][0]["error"]["message"]


@pytest.mark.parametrize(
    "name", ["../examples/218_combined", "/etc/passwd", "218_combined.toml\0", "C:\\x"]
)
def test_an_example_is_a_name_and_no_path(name: str) -> None:
    response = post("/page/open", json.dumps({"example": name}))
    assert response.status_code == 422


@pytest.mark.parametrize("path", ["/static/../server.py", "/static/%2e%2e/server.py",
                                  "/static/..%2fserver.py", "/static//etc/passwd",
                                  "/static/vendor/../../server.py"])  # fmt: skip
def test_files_beside_the_page_are_not_served(path: str) -> None:
    response = ask("GET", path)
    assert response.status_code == 404
    assert "create_app" not in response.text


def test_a_text_that_opens_as_a_case_is_bounded() -> None:
    nested = "a = " + "[" * 5_000 + "]" * 5_000
    headers = "\n".join(f"[x{n}]" for n in range(50_000))
    for text in (nested, headers, "[bearing]\nball_count = 0x" + "f" * 5_000, "\0"):
        assert post("/page/open", json.dumps({"text": text})).status_code == 422


def bomb() -> bytes:
    """A small archive that would be a gigabyte."""
    packed = io.BytesIO()
    head = (
        b"\x93NUMPY\x01\x00v\x00{'descr': '<f8', 'fortran_order': False, 'shape': (125000000,), }"
    )
    with (
        zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive,
        archive.open("signal.npy", "w", force_zip64=True) as member,
    ):
        member.write(head.ljust(127) + b"\n")
        for _ in range(20):
            member.write(bytes(1_000_000))
    return packed.getvalue()


@pytest.mark.parametrize(
    ("address", "name", "content"),
    [
        ("/page/signal?rate=20kHz&speed=1500rpm&bearing=6205", "record.npz", bomb),
        ("/page/weibull", "lives.xlsx", bomb),
    ],
    ids=["npz", "xlsx"],
)
@pytest.mark.thirds
def test_an_archive_that_is_a_bomb_is_refused(address: str, name: str, content: Any) -> None:
    response = ask("PUT", address, 60.0, content=content(), headers={"x-file-name": name})
    assert response.status_code in (413, 422)
    assert name in response.json()["error"]["message"]
