"""The documentation site in a browser: from a disk and from a server, `make docs` before."""

from __future__ import annotations

import functools
import threading
from collections.abc import Iterator
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import pytest

from builder.search import EXPECTED

SITE = Path(__file__).resolve().parents[2] / "docs" / "_build" / "html"
PAGES = ("index", "theory/life", "reference/fields", "reference/api/rolamento.life", "glossary")

if not (SITE / "searchindex.js").exists():
    pytest.skip("there is no site: `make docs` builds it", allow_module_level=True)


class _Quiet(SimpleHTTPRequestHandler):
    def log_message(self, *args: Any) -> None:
        """Say nothing."""


@pytest.fixture(scope="module", params=["disk", "server"])
def place(request: pytest.FixtureRequest) -> Iterator[str]:
    """Where the site is."""
    if request.param == "disk":
        yield SITE.as_uri()
        return
    with ThreadingHTTPServer(
        ("127.0.0.1", 0), functools.partial(_Quiet, directory=str(SITE))
    ) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()


@pytest.fixture
def page(chromium: Any, place: str) -> Iterator[Any]:
    """A page of a browser that asks nothing of another machine, and in which nothing fails."""
    asked: list[str] = []
    failed: list[str] = []
    context = chromium.new_context()
    context.on("request", lambda request: asked.append(request.url))
    found = context.new_page()
    found.on("pageerror", lambda error: failed.append(str(error)))
    found.on("console", lambda said: said.type == "error" and failed.append(said.text))
    yield found
    context.close()
    assert [url for url in asked if not url.startswith((place, "data:"))] == []
    assert failed == []


@pytest.mark.parametrize("question", EXPECTED)
def test_the_search_finds_a_standard_by_its_number(page: Any, place: str, question: str) -> None:
    page.goto(f"{place}/index.html")
    page.locator("input[name=q]").first.fill(question)
    page.keyboard.press("Enter")
    page.locator(".search-summary", has_text="found").wait_for()
    found = page.locator("#search-results li > a").evaluate_all(
        "links => links.map((link) => link.getAttribute('href'))"
    )
    pages = [link.partition(".html")[0] for link in found]
    assert set(EXPECTED[question]) <= set(pages[:12]), pages


@pytest.mark.parametrize("name", PAGES)
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing(page: Any, place: str, name: str, scheme: str) -> None:
    axe = pytest.importorskip("axe_playwright_python.sync_playwright").Axe()
    if place.startswith("file:"):
        pytest.skip("it reads the style sheets anew, which a page from a disk may not")
    page.emulate_media(color_scheme=scheme)
    page.goto(f"{place}/{name}.html")
    found = axe.run(page).response["violations"]
    told = [(one["id"], [node["target"] for node in one["nodes"]][:4]) for one in found]
    assert told == []


@pytest.mark.parametrize("name", PAGES)
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_a_page_is_as_wide_as_a_phone(page: Any, place: str, name: str, scheme: str) -> None:
    page.emulate_media(color_scheme=scheme)
    page.set_viewport_size({"width": 390, "height": 844})
    page.goto(f"{place}/{name}.html")
    wide = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
    assert page.evaluate(wide) == 0
