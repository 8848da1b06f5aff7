"""The app as people have it: `rolamento app` on this machine, and Debian's Chromium before it."""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from urllib.request import urlopen

import pytest
from tests.children import python

BROWSERS = ("chromium", "chromium-browser", "google-chrome")
ARGUMENTS = (  # it runs as root in a container, and asks nobody for anything
    "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
)  # fmt: skip
PATIENCE = 60_000.0
"""Milliseconds: a machine may be busy."""
LOCALES = {"en": "en-GB", "pt": "pt-BR"}
WIDE, PHONE = (1400, 950), (390, 844)

Visit = Callable[..., Any]


def pytest_configure(config: pytest.Config) -> None:
    """Say which browser is used, or that there is none."""
    config.addinivalue_line("filterwarnings", "ignore::ResourceWarning")  # Playwright's pipes


@pytest.fixture(scope="session")
def address() -> Iterator[str]:
    """Where the app is served, its kernels warm."""
    command = ("-m", "rolamento", "app", "--no-browser")
    with python(*command, stdout=subprocess.PIPE, text=True) as served:
        assert served.stdout is not None
        try:
            found = re.search(r"http://127\.0\.0\.1:\d+/", served.stdout.readline())
            assert found is not None
            end = time.monotonic() + 600.0  # kernels may have to be compiled
            while b'"ready": true' not in urlopen(f"{found[0]}page/start", timeout=60).read():
                assert time.monotonic() < end
                time.sleep(0.5)
            yield found[0]
        finally:
            served.send_signal(signal.SIGINT)
            assert served.wait(30) == 0


@pytest.fixture(scope="session")
def chromium() -> Iterator[Any]:
    """The browser of this machine; CHROME names another."""
    playwright = pytest.importorskip("playwright.sync_api", reason="`make browser` installs it")
    found = os.environ.get("CHROME") or next(filter(None, map(shutil.which, BROWSERS)), None)
    if found is None:
        pytest.skip("there is no Chromium: install it (apt install chromium), or name it: CHROME=…")
    with playwright.sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=found, args=list(ARGUMENTS))
        yield browser
        browser.close()


@pytest.fixture
def visit(chromium: Any, address: str) -> Iterator[Visit]:
    """Open the page as somebody with a language, a size of window and a theme.

    Whatever is done there, nothing is asked of another machine and nothing fails unseen.
    """
    contexts, asked, failed = [], [], []

    def opened(
        path: str = "",
        *,
        lang: str = "en",
        size: tuple[int, int] = WIDE,
        scheme: str = "light",
        **options: Any,
    ) -> Any:
        width, height = size
        context = chromium.new_context(
            locale=LOCALES[lang],
            viewport={"width": width, "height": height},
            color_scheme=scheme,
            **options,
        )
        context.set_default_timeout(PATIENCE)
        contexts.append(context)
        context.on("request", lambda request: asked.append(request.url))
        page = context.new_page()
        page.on("pageerror", lambda error: failed.append(str(error)))
        page.on("console", lambda said: said.type == "error" and failed.append(said.text))
        page.goto(f"{address}{path}")
        page.locator("#version").filter(has_text="Rolamento").wait_for()
        return page

    yield opened
    for context in contexts:
        context.close()
    own = (address, f"blob:{address}", "data:")
    assert [url for url in asked if not url.startswith(own)] == []
    refused = "status of 422"  # what is wrong was given, and is told on the page
    assert [text for text in failed if refused not in text] == []


@pytest.fixture
def case_file(tmp_path: Path) -> Path:
    """A motor's bearing that turns in oil."""
    path = tmp_path / "motor.toml"
    path.write_text(
        'title = "Motor"\nlubricant = "VG 68"\n\n[bearing]\ndesignation = "6310"\n\n'
        '[duty]\ninner_speed = "1500 rpm"\n\n[duty.load]\nfx = "1.5 kN"\nfz = "6 kN"\n',
        encoding="utf-8",
    )
    return path
