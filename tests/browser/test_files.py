"""The pages of files in a real browser: a life test and a vibration record."""

from __future__ import annotations

import json
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.image import imread
from typer.testing import CliRunner

from rolamento.cli.app import app

LIVES = "time,status\n105,failed\n160,failed\n230,failed\n310,suspended\n420,failed\n500,failed\n"


@pytest.mark.parametrize("lang", ["en", "pt"])
def test_a_life_test_is_read(visit: Any, tmp_path: Path, lang: str) -> None:
    file = tmp_path / "lives.csv"
    file.write_text(LIVES, encoding="utf-8")
    page = visit("#weibull", lang=lang)
    page.set_input_files("#drop-file-weibull", file)
    page.locator("#weibull .drop-end button[type=submit]").first.click()
    result = page.locator("#weibull .drop-result").first
    result.locator("table").first.wait_for()
    out = tmp_path / "out.json"
    command = ["weibull", str(file), "--json", str(out)]
    assert CliRunner().invoke(app, command).exit_code == 0
    text = result.inner_text().replace(",", ".").replace("\u202f", "").replace("\u00a0", "")
    fit = json.loads(out.read_text(encoding="utf-8"))["groups"][0]["fits"][0]
    for name in ("shape", "scale"):
        value = fit[name]
        assert f"{value:.4g}" in text, name
    assert result.locator("img, svg").count() >= 1


@pytest.mark.parametrize("lang", ["en", "pt"])
def test_an_example_record_is_judged(visit: Any, lang: str) -> None:
    page = visit("#signal", lang=lang)
    page.locator("#signal .drop-examples button").first.click()
    result = page.locator("#signal .drop-result").first
    result.locator("table").first.wait_for()
    assert len(result.inner_text()) > 200
    assert page.locator("#signal .drop-state").inner_text().strip()


def test_a_file_that_is_no_record_is_told(visit: Any, tmp_path: Path) -> None:
    file = tmp_path / "noise.wav"
    file.write_bytes(b"RIFF\x00\x00\x00\x00WAVEnothing more")
    page = visit("#signal")
    page.set_input_files("#drop-file-signal", file)
    page.fill("#drop-signal-bearing", "6205")
    page.fill("#drop-signal-speed", "1500 rpm")
    with page.expect_response("**/page/signal*") as response:
        page.locator("#signal .drop-end button[type=submit]").click()
    assert response.value.status == 422
    page.locator("#signal .error").filter(has_text="noise.wav").or_(
        page.locator("#signal .error").filter(has_text="WAV")
    ).first.wait_for()


def test_colours_that_are_numbers_stay_in_the_dark(visit: Any) -> None:
    seen = {}
    for scheme in ("light", "dark"):
        page = visit("#signal", scheme=scheme)
        page.locator("#signal .drop-examples button").first.click()
        picture = page.locator('#signal .drop-result img[alt^="Kurtogram"]')
        picture.scroll_into_view_if_needed()
        shown = imread(BytesIO(picture.screenshot()))[..., :3]
        height, width = shown.shape[:2]
        paper = shown[2:6, -6:-2].mean()
        field = shown[int(0.2 * height) : int(0.8 * height), int(0.2 * width) : int(0.7 * width)]
        seen[scheme] = paper, field.mean(axis=(0, 1))
    assert seen["light"][0] > 0.9
    assert seen["dark"][0] < 0.2  # its paper is that of the page
    assert np.abs(seen["dark"][1] - seen["light"][1]).max() < 0.15
