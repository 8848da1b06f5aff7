"""Photograph the app for its guide, docs/app.md; after a change of the page.

    python scripts/screenshots.py [NAME…]

starts the app on this machine, does in Chromium what the guide says, and writes docs/app/NAME.png.
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
from typing import Final, Literal

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


def opening(page: Page) -> None:
    """A designation is being typed."""
    page.get_by_label("Designation or dimensions").fill("6310")


def case(page: Page) -> None:
    """An example is open."""
    _example(page, "6310_motor")


def roller(page: Page) -> None:
    """A bearing with rollers is open."""
    _example(page, "nu205_gear")


def lost(page: Page) -> None:
    """A radial load has no axial load beside it."""
    first(page, "7210 B")
    page.locator("#first input[name='duty.load.fz']").fill("4 kN")
    page.locator("#first button").click()
    page.locator("#helps button").wait_for(timeout=1000.0 * _PATIENCE)


def first(page: Page, designation: str = "7014 C/HCP4A DBA") -> None:
    """A bearing is open of which nothing but its designation is known."""
    page.get_by_label("Designation or dimensions").fill(designation)
    page.get_by_label("Designation or dimensions").press("Enter")
    page.locator("#first").wait_for(timeout=1000.0 * _PATIENCE)


def seek(page: Page) -> None:
    """The load that gives a life."""
    _example(page, "6310_motor")
    page.locator("#seek summary").click()
    page.locator("#seek option[value=life_hours]").wait_for(state="attached")
    page.select_option("#seek select[name=vary]", "duty.load.fz")
    page.fill("#seek input[name=wanted]", "30000")
    page.press("#seek input[name=wanted]", "Enter")
    page.locator("#seek .js-line").first.wait_for(state="attached", timeout=1000.0 * _PATIENCE)
    page.evaluate("document.querySelector('#seek').scrollIntoView({ block: 'center' })")


def tolerance(page: Page) -> None:
    """The scatter of the results with clearance, conformity and load."""
    page.get_by_label("Designation or dimensions").fill("6310")
    page.get_by_label("Designation or dimensions").press("Enter")
    page.locator("#first").wait_for(timeout=1000.0 * _PATIENCE)
    for name, text in (("duty.load.fz", "8 kN"), ("duty.inner_speed", "1480 rpm")):
        page.locator(f"#first input[name='{name}']").fill(text)
    page.locator("#first button").click()
    page.locator("#status", has_text="Converged").wait_for(timeout=1000.0 * _PATIENCE)
    page.locator("#tolerance summary").click()
    page.locator("#tolerance option[value='duty.load.fz']").wait_for(state="attached")
    page.select_option("#tolerance select[name=more]", "duty.load.fz")
    page.locator("#tolerance .tools button").first.click()
    page.locator("#tolerance .js-line").first.wait_for(state="attached")
    page.evaluate("document.querySelector('#tolerance').scrollIntoView({ block: 'end' })")


def compare(page: Page) -> None:
    """Two cases of it, one with more load."""
    _example(page, "6310_motor")
    page.locator("#compare").click()
    for place, name in enumerate(("as drawn", "belt too tight")):
        called = page.locator("#slot-list input[type=text]").nth(place)
        called.fill(name)
        called.press("Enter")
    load = page.locator("#form .field", has_text="Radial load Fz").locator("input[type=text]").first
    load.fill("7")
    load.press("Enter")


def machine(page: Page) -> None:
    """A machine whose load is moved along its shaft."""
    page.get_by_role("link", name="Machine", exact=True).click()
    page.locator("#machine-examples").get_by_text("spindle").first.click()
    page.locator("#machine-status", has_text="Converged").wait_for(timeout=1000.0 * _PATIENCE)
    page.locator("#machine-hold .grip[aria-label^='cutting force']").press("Shift+ArrowLeft")


def signal(page: Page) -> None:
    """The verdict on a record."""
    page.get_by_role("link", name="Vibration", exact=True).click()
    page.locator("#signal").get_by_label("Bearing").first.fill("6310/C3")
    _dropped(page, "signal", "record.npz")


def weibull(page: Page) -> None:
    """The evaluation of a life test."""
    page.get_by_role("link", name="Life tests", exact=True).click()
    _dropped(page, "weibull", "lives.csv")


def phone(page: Page) -> None:
    """Results on a narrow screen."""
    _example(page, "6012_pair")
    page.locator(".panes button[data-pane=results]").click()


PICTURES: Final = {
    "open": (opening, 1200, 820),
    "first": (first, 1200, 820),
    "case": (case, 1200, 820),
    "roller": (roller, 1200, 820),
    "lost": (lost, 1200, 620),
    "seek": (seek, 1200, 820),
    "tolerance": (tolerance, 1200, 820),
    "compare": (compare, 1200, 820),
    "machine": (machine, 1200, 980),
    "signal": (signal, 1200, 980),
    "weibull": (weibull, 1200, 980),
    "phone": (phone, 390, 780),
}
"""By the name of the file: what is done, width and height; the phone is dark."""


def _example(page: Page, name: str) -> None:
    page.locator(f"#examples button:has([data-example='{name}'])").click()
    page.locator("#status", has_text="Converged").wait_for(timeout=1000.0 * _PATIENCE)


def _dropped(page: Page, view: str, file: str) -> None:
    page.locator(f"#{view} input[type=file]").set_input_files(file)
    page.locator(f"#{view} button[type=submit]").first.click()
    page.locator(f"#{view} .drop-result").first.wait_for(timeout=1000.0 * _PATIENCE)


def photograph(browser: Browser, name: str) -> None:
    """Do what the guide says, and write the picture of it."""
    done, width, height = PICTURES[name]
    scheme: Literal["dark", "light"] = "dark" if name == "phone" else "light"
    page = browser.new_page(viewport={"width": width, "height": height}, color_scheme=scheme)
    page.goto(ADDRESS, wait_until="networkidle")
    done(page)
    page.wait_for_timeout(_SETTLED)
    fresh = Path("fresh.png")
    page.screenshot(path=fresh)
    keep_picture(fresh, TARGET / f"{name}.png")
    page.close()


def main() -> int:
    """Write the pictures that are named, or all."""
    with tempfile.TemporaryDirectory() as place, contextlib.chdir(place):
        command(["weibull", "--example", "campanha-2008", "--write", "lives.csv"])
        command(shlex.split(RECORD))
        with app(), sync_playwright() as playwright:
            browser = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
            for name in sys.argv[1:] or PICTURES:
                photograph(browser, name)
            browser.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
