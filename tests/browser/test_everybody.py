"""Whether everybody can use the page: axe finds nothing, on a wide screen and a phone."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest

PHONE = (390, 844)
WIDE = (1400, 950)
SCREENS = Path(os.environ["SCREENS"]) if os.environ.get("SCREENS") else None
"""A folder for pictures of what was looked at."""


def at(visit: Any, view: str, **who: Any) -> Any:
    """A page with everything on it that axe is to look at."""
    page = visit(f"#{view}" if view != "open" else "", **who)
    if view == "case":
        page.locator("#examples button:has([data-example='6310_motor'])").click()
        page.locator("#status p.good").wait_for()
        page.evaluate("for (const one of document.querySelectorAll('details')) one.open = true")
        page.wait_for_timeout(2000)
        page.locator("#tolerance table").wait_for(state="attached")  # a phone shows the inputs
        page.locator("#work:not(.asking)").wait_for()
        page.locator("#results [data-stale]").first.wait_for(state="detached")
        page.wait_for_timeout(500)  # what was faint appears
    elif view == "machine":
        page.locator("#machine-examples button").first.click()
        page.locator("#machine-status p.good").wait_for()
        page.evaluate("for (const one of document.querySelectorAll('details')) one.open = true")
        page.wait_for_timeout(2000)
        page.locator("#machine-work:not(.asking)").wait_for()
    elif view in ("weibull", "signal"):
        page.locator(f"#{view} .drop-examples button").first.click()
        page.locator(f"#{view} .drop-result table, #{view} .drop-result figure").first.wait_for()
    return page


def shot(page: Any, name: str) -> None:
    if SCREENS is not None:
        SCREENS.mkdir(parents=True, exist_ok=True)
        page.screenshot(path=SCREENS / f"{name}.png", full_page=True)


VIEWS = ("open", "case", "machine", "weibull", "signal")


@pytest.mark.parametrize("view", VIEWS)
@pytest.mark.parametrize(
    ("scheme", "lang", "size"),
    [("light", "en", WIDE), ("dark", "pt", WIDE), ("light", "pt", PHONE), ("dark", "en", PHONE)],
    ids=["light, wide", "dark, wide", "light, phone", "dark, phone"],
)
def test_axe_finds_nothing(
    visit: Any, view: str, scheme: str, lang: str, size: tuple[int, int]
) -> None:
    axe = pytest.importorskip("axe_playwright_python.sync_playwright").Axe()
    page = at(visit, view, lang=lang, scheme=scheme, size=size)
    shot(page, f"{view}-{scheme}-{size[0]}-{lang}")
    found = axe.run(page)
    told = [
        f"{one['id']}: {one['help']}: {[node['target'] for node in one['nodes']][:4]}"
        for one in found.response["violations"]
    ]
    assert told == []
    assert len(found.response["passes"]) > 10  # it did look


@pytest.mark.parametrize(
    ("view", "lang"),
    [("open", "en"), ("case", "pt"), ("machine", "pt"), ("weibull", "pt"), ("signal", "en")],
)
def test_a_phone_never_scrolls_sideways(visit: Any, view: str, lang: str) -> None:
    page = at(visit, view, lang=lang, size=PHONE)
    panes = page.locator(f"#{view} .panes button").all() if view == "case" else [None]
    for pane in panes:
        if pane is not None:
            pane.click()
        for width in (390, 360, 320):
            page.set_viewport_size({"width": width, "height": 800})
            page.wait_for_timeout(300)
            beyond = page.evaluate("document.documentElement.scrollWidth - innerWidth")
            assert beyond <= 0, f"{beyond} px wider than a window of {width} px"


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_a_theme_that_is_chosen_stays(visit: Any, theme: str) -> None:
    page = visit(scheme="dark" if theme == "light" else "light")
    page.select_option("#theme", theme)
    page.reload()
    page.locator("#version").filter(has_text="Rolamento").wait_for()
    paper = page.evaluate("getComputedStyle(document.body).backgroundColor")
    levels = [int(part) for part in paper.strip("rgba()").split(",")[:3]]
    assert (sum(levels) > 384) == (theme == "light")


def test_the_language_is_changed_in_place(visit: Any) -> None:
    page = at(visit, "case")
    page.select_option("#language", "pt")
    page.locator("#status p.good").filter(has_text="onvergi").wait_for()
    assert page.locator("html").get_attribute("lang") == "pt-BR"
    assert page.locator("#open").inner_text() == "Abrir"


def test_the_documentation_of_the_api_is_served_here(visit: Any, address: str) -> None:
    page = visit()
    page.goto(f"{address}api/docs")
    page.get_by_text("/api/v1/solve").first.wait_for()


@pytest.mark.parametrize("view", ["machine", "weibull", "signal"])
def test_the_address_of_a_page_leaves_the_head_in_sight(visit: Any, view: str) -> None:
    page = visit("#case", size=PHONE)
    page.evaluate(f"location.hash = '{view}'")
    page.wait_for_timeout(1000)
    assert page.evaluate("document.querySelector('.head').getBoundingClientRect().top") == 0
