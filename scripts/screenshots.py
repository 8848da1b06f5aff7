"""Photograph the app for its guide, docs/app.md; after a change of the page.

    python scripts/screenshots.py

starts the app on this machine, does in Chromium what the guide says, and writes docs/app/*.png.
Chromium is that of the system; ROLAMENTO_CHROMIUM names another.
"""

from __future__ import annotations

import contextlib
import os
import shlex
import subprocess
import sys
import tempfile
import time
import urllib.request
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from playwright.sync_api import Browser, Page, sync_playwright

sys.path.insert(0, str(Path(__file__).parent))
from guides import command, keep_picture

TARGET: Final = Path(__file__).parents[1] / "docs" / "app"
PORT: Final = 8798
ADDRESS: Final = f"http://127.0.0.1:{PORT}/"
CHROMIUM: Final = os.environ.get("ROLAMENTO_CHROMIUM", "/usr/bin/chromium")
FLAGS: Final = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]
RECORD: Final = (
    "synthesise 6310/C3 --speed 1480rpm --fault outer_race --slip 0.008 --snr -3 "
    "--rate 25.6kHz --duration 8s --seed 3 -o record.npz"
)
_PATIENCE: Final = 120.0
"""Seconds to wait for the app."""
_SETTLED: Final = 4000.0
"""Milliseconds after which a page stands still."""


@contextlib.contextmanager
def app() -> Iterator[None]:
    """Run the app, until it is done with."""
    words = [sys.executable, "-m", "rolamento", "app", "--no-browser", "--port", str(PORT)]
    with subprocess.Popen(words, stdout=subprocess.DEVNULL) as process:
        try:
            end = time.monotonic() + _PATIENCE
            while time.monotonic() < end:
                with contextlib.suppress(OSError), urllib.request.urlopen(ADDRESS):
                    break
                time.sleep(0.5)
            yield
        finally:
            process.terminate()


def photograph(browser: Browser, folder: Path) -> None:
    """Do what the guide says, and write a picture of each step."""
    page = browser.new_page(viewport={"width": 1200, "height": 820}, color_scheme="light")
    page.goto(ADDRESS, wait_until="networkidle")
    page.get_by_label("Designation or dimensions").fill("6310")
    _keep(page, folder / "open.png")
    page.goto(ADDRESS, wait_until="networkidle")
    page.locator("#examples").get_by_text("6310_motor").click()
    _calculated(page)
    _keep(page, folder / "case.png")
    page.locator("#compare").click()
    load = page.locator("#form .field", has_text="Radial load Fz").locator("input[type=text]").first
    load.fill("7")
    load.press("Enter")
    _keep(page, folder / "compare.png")
    page.close()
    for view, word, file in (
        ("signal", "Vibration", "record.npz"),
        ("weibull", "Life tests", "lives.csv"),
    ):
        page = browser.new_page(viewport={"width": 1200, "height": 980}, color_scheme="light")
        page.goto(f"{ADDRESS}#{view}", wait_until="networkidle")
        page.get_by_role("link", name=word).click()
        if view == "signal":
            page.locator("#signal").get_by_label("Bearing").first.fill("6310/C3")
        page.locator(f"#{view} input[type=file]").set_input_files(file)
        page.locator(f"#{view} button[type=submit]").first.click()
        result = page.locator(f"#{view} .drop-result").first
        result.get_by_role("heading").first.wait_for(timeout=1000.0 * _PATIENCE)
        result.evaluate("element => element.scrollIntoView()")
        _keep(page, folder / f"{view}.png")
        page.close()
    page = browser.new_page(viewport={"width": 390, "height": 780}, color_scheme="dark")
    page.goto(ADDRESS, wait_until="networkidle")
    page.locator("#examples").get_by_text("6012_pair").click()
    _calculated(page)
    page.locator(".panes button[data-pane=results]").click()
    _keep(page, folder / "phone.png")
    page.close()


def _calculated(page: Page) -> None:
    page.locator("#status", has_text="Converged").wait_for(timeout=1000.0 * _PATIENCE)


def _keep(page: Page, target: Path) -> None:
    page.wait_for_timeout(_SETTLED)
    fresh = Path("fresh.png")
    page.screenshot(path=fresh)
    keep_picture(fresh, target)


def main() -> int:
    """Write all pictures."""
    with tempfile.TemporaryDirectory() as place, contextlib.chdir(place):
        command(["weibull", "--example", "campanha-2008", "--write", "lives.csv"])
        command(shlex.split(RECORD))
        with app(), sync_playwright() as playwright:
            browser = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
            photograph(browser, TARGET)
            browser.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
