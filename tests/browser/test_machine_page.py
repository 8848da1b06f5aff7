"""The page of a machine in a real browser: a load is dragged, and the numbers are the command's."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from rolamento.cli.app import app

PHONE = (390, 844)
GRIP = "#machine-hold .grip[aria-label^='{}']"


def opened(visit: Any, name: str = "spindle", **options: Any) -> Any:
    page = visit("#machine", **options)
    page.locator(f"#machine-examples button[value={name}]").click()
    settled(page)
    return page


def settled(page: Any) -> None:
    """Wait until everything shown is of the present machine."""
    page.locator("#machine-status p.good").wait_for()
    page.wait_for_timeout(400)
    for _ in range(200):
        if not page.locator("#machine-work.asking, #machine-work [data-stale]").count():
            return
        page.wait_for_timeout(100)
    raise AssertionError("it does not come to rest")


def position(page: Any) -> str:
    return str(page.locator("#machine-part input[data-name$='.position']").input_value())


def of_command(page: Any, tmp_path: Path) -> Any:
    """What the command says of the machine that the page saves."""
    with page.expect_download() as download:
        page.click("#machine-save")
    out = tmp_path / "out.json"
    file = tmp_path / "machine.toml"
    file.write_bytes(Path(download.value.path()).read_bytes())
    result = CliRunner().invoke(app, ["shaft", str(file), "--json", str(out)])
    assert result.exit_code == 0, result.output
    return json.loads(out.read_text(encoding="utf-8"))


def plain(text: str) -> str:
    return re.sub(r"[\s\u00a0\u202f\u2009]", "", text).replace(",", ".").replace("−", "-")


@pytest.mark.parametrize("lang", ["en", "pt"])
def test_a_load_is_dragged_and_the_numbers_are_those_of_the_command(
    visit: Any, tmp_path: Path, lang: str
) -> None:
    page = opened(visit, lang=lang)
    before = page.locator("#machine-life").inner_text()
    grip = page.locator(GRIP.format("cutting force"))
    box = grip.locator(".hit").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    for step in range(1, 11):
        page.mouse.move(x - 12 * step, y)
        page.wait_for_timeout(40)
    assert page.locator(GRIP.format("cutting force")).get_attribute("aria-valuetext") != "320 mm"
    page.mouse.up()
    settled(page)
    assert page.locator("#machine-life").inner_text() != before
    found = of_command(page, tmp_path)
    at = float(found["machine"]["loads"][0]["position"].partition(" ")[0])
    at *= 1e3 if at < 1.0 else 1.0
    assert float(position(page).replace(",", ".")) == pytest.approx(at, abs=1e-6)
    table = plain(page.locator("#machine-bearings table").inner_text())
    for one in found["bearings"]:
        radial = (one["force"][0][1] ** 2 + one["force"][0][2] ** 2) ** 0.5
        assert f"{radial:.1f}" in table, one["name"]
    page.click("#machine-undo")
    settled(page)
    assert position(page) == "320"
    assert page.locator("#machine-life").inner_text() == before
    page.click("#machine-redo")
    settled(page)
    assert position(page) != "320"


def test_parts_move_by_keyboard_and_are_typed(visit: Any) -> None:
    page = opened(visit, "motor")
    grip = page.locator(GRIP.format("drive end"))
    start = float(grip.get_attribute("aria-valuenow"))
    grip.focus()
    for key in ("ArrowLeft", "ArrowLeft", "Shift+ArrowLeft", "ArrowRight"):
        page.keyboard.press(key)
    settled(page)
    assert float(grip.get_attribute("aria-valuenow")) == pytest.approx(start - 11.0)
    assert grip.evaluate("one => one === document.activeElement")
    box = page.locator("#machine-part input[data-name$='.position']")
    box.fill("90 m")
    box.press("Enter")
    page.locator("#machine-status p.bad").wait_for()
    assert "is not on shaft" in page.locator("#machine-part .error").first.inner_text()
    assert page.locator("#machine-stage[data-stale]").count() == 1
    box.fill("41 cm")
    box.press("Enter")
    settled(page)
    assert float(grip.get_attribute("aria-valuenow")) == pytest.approx(410.0)
    designation = page.locator("#machine-part input[data-name$='.designation']")
    designation.fill("6312/C3")
    designation.press("Enter")
    settled(page)
    assert page.locator("#machine-image").get_attribute("src").startswith("data:image/svg")


def test_a_file_is_dropped_in_and_what_it_may_not_say_is_told(visit: Any, tmp_path: Path) -> None:
    page = visit("#machine")
    file = tmp_path / "own.toml"
    file.write_text('[[shafts]]\nname = "s"\nsections = "other.csv"\n', encoding="utf-8")
    page.set_input_files("#machine-input", file)
    told = page.locator("#machine-file-error")
    told.filter(has_text="names a file").wait_for()
    assert "own.toml" in told.inner_text()
    assert "shafts.0.sections" in told.inner_text()


@pytest.mark.parametrize("form", ["html", "pdf"])
def test_the_report_is_saved(visit: Any, form: str) -> None:
    page = opened(visit, "three_supports")
    with page.expect_download() as download:
        page.click(f"#machine-report-{form}")
    assert download.value.suggested_filename.endswith(f".{form}")
    assert Path(download.value.path()).stat().st_size > 10_000


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_nothing_is_wider_than_a_phone(visit: Any, scheme: str) -> None:
    page = opened(visit, "gear_shaft", lang="pt", size=PHONE, scheme=scheme)
    assert page.evaluate("document.documentElement.scrollWidth") <= PHONE[0]
    page.select_option("#machine-step", "2")
    settled(page)
    assert page.locator("#machine-pictures img").count() == 3
