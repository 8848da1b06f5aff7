"""The page of a case in a real browser: what people do there, and that the numbers are true."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from rolamento.cli.app import app

LANGUAGES = ("en", "pt")
CONVERGED = "#status p.good"
ANSWERED = "#drawing svg"
"""Drawn: a bearing that was opened by its designation has no load yet."""
ROWS_OF_SUMMARY = {  # a word of the row in both languages, and where the JSON has it
    ("safety", "segurança"): (("life", "loads", "static_safety"), 1.0),
    ("C/P", "C/P"): (None, 1.0),
    ("pressure", "pressão"): (None, 1e-6),
    ("radial stiffness", "rigidez radial"): (("stiffness", 2, 2), 1e-6),
}


def opened(page: Any, designation: str = "6310") -> None:
    page.fill("#wanted", designation)
    page.press("#wanted", "Enter")
    page.locator(ANSWERED).wait_for()


def field(page: Any, name: str) -> Any:
    return page.locator(f'#form .field[data-name="{name}"]')


def typed(page: Any, name: str, text: str) -> None:
    box = field(page, name).locator("input:not([type=range])")
    box.fill(text)
    box.press("Enter")
    settled(page)


def settled(page: Any) -> None:
    """Wait until everything shown is of the present case."""
    page.wait_for_timeout(250)
    absent(page, "#work.asking, #figures[data-stale], .section[open][data-stale]")
    page.wait_for_timeout(400)  # what was only traced is drawn


def absent(page: Any, selector: str) -> None:
    for _ in range(200):
        if not page.locator(selector).count():
            return
        page.wait_for_timeout(100)
    raise AssertionError(f"{selector} stays")


def saved(page: Any, button: str = "#save") -> Path:
    with page.expect_download() as download:
        page.click(button)
    return Path(download.value.path())


def answers(case: Path, *options: str) -> Any:
    """What the command says of a case."""
    result = CliRunner().invoke(app, ["solve", str(case), "--json", *options])
    assert result.exit_code == 0, result.stderr
    return json.loads(result.stdout)


def number(text: str) -> float:
    """A number as it is shown in either language."""
    plain = re.sub(r"[\s\u00a0\u202f]", "", text).replace("−", "-")
    return float(plain.replace(",", "."))


def alike(shown: str, value: float) -> bool:
    """Whether what is shown is a value to as many digits as are shown."""
    digits = re.sub(r"[^\d.,]", "", shown)
    decimals = len(re.split("[.,]", digits)[1]) if re.search("[.,]", digits) else 0
    return abs(number(shown) - value) <= 0.5000001 * 10.0**-decimals + 5e-4 * abs(value)


def shown_in(page: Any, words: tuple[str, str]) -> str:
    for figure in page.locator("#figures .figure").all():
        label = figure.locator("dt").inner_text()
        if any(word.casefold() in label.casefold() for word in words):
            return re.sub(r"\s\D+$", "", figure.locator("dd").first.inner_text())
    raise AssertionError(f"{words} is not among the key figures")


def same_numbers(page: Any, truth: Any) -> None:
    """Compare summary and pictures with the JSON of the command."""
    pressures = [ball[race]["max_pressure"] for ball in truth["balls"]
                 for race in ("inner", "outer")]  # fmt: skip
    loads = truth["life"]["loads"]
    derived = {"C/P": truth["life"]["ratings"]["dynamic"] / loads["equivalent"],
               "pressure": max(filter(None, pressures))}  # fmt: skip
    for words, (path, factor) in ROWS_OF_SUMMARY.items():
        value = truth
        for key in path or ():
            value = value[key]
        value = derived[words[0]] if path is None else value
        assert alike(shown_in(page, words), value * factor), words
    rosette = page.evaluate(
        "document.querySelector('[data-key=rosette] .plot').data.map(one => Array.from(one.r))"
    )
    for race, drawn in zip(("inner", "outer"), rosette, strict=False):
        expected = [ball[race]["load"] or 0.0 for ball in truth["balls"]]
        assert drawn[: len(expected)] == pytest.approx(expected, rel=1e-6, abs=1e-6), race


@pytest.mark.parametrize("lang", LANGUAGES)
def test_a_designation_is_opened_and_its_numbers_are_those_of_the_command(
    visit: Any, lang: str
) -> None:
    page = visit(lang=lang)
    assert page.locator("html").get_attribute("lang").startswith(lang)
    opened(page)
    typed(page, "duty.load.fz", "10 kN")
    typed(page, "duty.inner_speed", "1500 rpm")
    settled(page)
    same_numbers(page, answers(saved(page)))
    assert not re.search(r"\b(undefined|NaN|null|\[object)\b", page.locator("body").inner_text())


@pytest.mark.parametrize("lang", LANGUAGES)
def test_a_slider_moves_the_numbers(visit: Any, lang: str) -> None:
    page = visit(lang=lang)
    opened(page)
    typed(page, "duty.load.fz", "5 kN")
    before = shown_in(page, ("pressure", "pressão"))
    slider = field(page, "duty.load.fz").locator("input[type=range]")
    slider.focus()
    for _ in range(30):
        slider.press("ArrowRight")
    settled(page)
    assert number(shown_in(page, ("pressure", "pressão"))) > number(before)
    same_numbers(page, answers(saved(page)))


@pytest.mark.parametrize("lang", LANGUAGES)
def test_an_error_stands_beside_its_field(visit: Any, lang: str) -> None:
    page = visit(lang=lang)
    opened(page)
    box = field(page, "duty.load.fz").locator("input:not([type=range])")
    box.fill("ten horses")
    box.press("Enter")
    error = field(page, "duty.load.fz").locator(".error")
    error.filter(has_text=re.compile(r"\w{3}")).wait_for()
    assert box.get_attribute("aria-invalid") == "true"
    assert error.get_attribute("id") in box.get_attribute("aria-describedby")
    page.locator("#drawing[data-stale]").wait_for()  # no old number
    box.fill("8 kN")
    box.press("Enter")
    page.locator(CONVERGED).wait_for()
    settled(page)
    assert error.inner_text() == ""
    same_numbers(page, answers(saved(page)))


@pytest.mark.parametrize("lang", LANGUAGES)
def test_a_unit_changes_what_is_read_and_not_what_is_meant(visit: Any, lang: str) -> None:
    page = visit(lang=lang)
    opened(page)
    typed(page, "duty.load.fz", "10 kN")
    place = field(page, "duty.load.fz")
    pressure = shown_in(page, ("pressure", "pressão"))
    place.locator("select.unit").select_option("N")
    assert number(place.locator("input:not([type=range])").input_value()) == 10_000.0
    typed(page, "duty.load.fz", "10000")  # in the unit that is shown
    assert shown_in(page, ("pressure", "pressão")) == pressure


def test_a_decimal_comma_is_a_decimal_mark_in_portuguese(visit: Any) -> None:
    page = visit(lang="pt")
    opened(page)
    typed(page, "duty.load.fz", "2,5 kN")
    assert answers(saved(page))["load"]["fz"] == 2500.0


@pytest.mark.parametrize("lang", LANGUAGES)
def test_two_cases_stand_side_by_side_with_their_difference(visit: Any, lang: str) -> None:
    page = visit(lang=lang)
    opened(page)
    typed(page, "duty.load.fz", "10 kN")
    page.click("#compare")
    settled(page)
    page.check('input[name="slot"][value="1"]')
    typed(page, "duty.load.fz", "5 kN")
    settled(page)
    head = page.locator("#summary thead th").all_inner_texts()
    assert "A" in head[2]
    assert "B" in head[3]
    row = page.locator("#summary tbody tr").filter(has_text=re.compile("pressure|pressão", re.I))
    a, b, difference = (number(text) for text in row.locator("td").all_inner_texts()[1:4])
    assert b < a
    assert difference == pytest.approx(b - a, abs=1.0)
    page.click("#keep")
    settled(page)
    assert answers(saved(page))["load"]["fz"] in (5e3, 10e3)


def test_any_field_is_a_curve_with_the_present_point(visit: Any) -> None:
    page = visit()
    opened(page)
    typed(page, "duty.load.fz", "10 kN")
    typed(page, "duty.inner_speed", "1500 rpm")
    figure = page.locator('[data-key="curve"]')
    figure.locator("summary").click()
    figure.locator(".plot").scroll_into_view_if_needed()
    figure.locator(".js-line").first.wait_for(state="attached")
    figure.locator("select[name=field]").select_option("duty.load.fz")
    page.wait_for_timeout(1500)
    data = page.evaluate("document.querySelector('[data-key=curve] .plot').data")
    assert len(data[0]["x"]) >= 21
    single = [one for one in data if len(one["x"]) == 1]
    assert single
    assert single[0]["x"][0] in (10.0, 10e3)


@pytest.mark.parametrize("lang", LANGUAGES)
def test_what_is_saved_opens_again(visit: Any, case_file: Path, lang: str) -> None:
    page = visit(lang=lang)
    page.set_input_files("#file", case_file)
    page.locator(CONVERGED).wait_for()
    settled(page)
    first = saved(page)
    assert answers(first)["case"] == answers(case_file)["case"]
    again = visit(lang=lang)
    copy = case_file.with_name("copy.toml")
    copy.write_bytes(first.read_bytes())
    again.set_input_files("#file", copy)
    again.locator(CONVERGED).wait_for()
    assert saved(again).read_bytes() == first.read_bytes()


def test_a_file_that_is_no_case_is_told(visit: Any, tmp_path: Path) -> None:
    page = visit()
    bad = tmp_path / "bad.toml"
    bad.write_text("[bearing]\nball_count = -3\n<script>alert(1)</script>", encoding="utf-8")
    with page.expect_response("**/page/open*") as response:
        page.set_input_files("#file", bad)
    assert response.value.status == 422
    page.locator("#wanted-error").filter(has_text="3").wait_for()


@pytest.mark.parametrize("lang", LANGUAGES)
def test_the_link_holds_the_whole_case(visit: Any, lang: str, case_file: Path) -> None:
    page = visit(lang=lang)
    page.set_input_files("#file", case_file)
    page.locator(CONVERGED).wait_for()
    page.click("#share")
    page.locator("#sharing").wait_for()  # the case is packed first
    link = page.locator("#link").input_value()
    asked: list[str] = []
    other = visit(lang=lang)
    other.context.on("request", lambda request: asked.append(request.url))
    other.goto("about:blank")
    other.goto(link)
    other.locator(CONVERGED).wait_for()
    assert not any("case=" in url.partition("#")[0] for url in asked)
    assert answers(saved(other))["case"] == answers(saved_after_sharing(page))["case"]


def saved_after_sharing(page: Any) -> Path:
    page.keyboard.press("Escape")
    return saved(page)


@pytest.mark.parametrize(("lang", "kind"), [("en", "html"), ("pt", "html"), ("en", "pdf")])
def test_the_report_is_that_of_the_case(visit: Any, lang: str, kind: str, case_file: Path) -> None:
    page = visit(lang=lang)
    page.set_input_files("#file", case_file)
    page.locator(CONVERGED).wait_for()
    settled(page)
    pressure = shown_in(page, ("pressure", "pressão"))
    report = saved(page, f"#report-{kind}").read_bytes()
    if kind == "pdf":
        assert report.startswith(b"%PDF")
    else:
        text = report.decode()
        assert pressure in text
        assert "<script" not in text
        assert "http://" not in re.sub(r'xmlns(:\w+)?="[^"]*"', "", text)


def test_undo_and_redo(visit: Any) -> None:
    page = visit()
    opened(page)
    typed(page, "duty.load.fz", "10 kN")
    typed(page, "duty.load.fz", "4 kN")
    page.click("#undo")
    settled(page)
    assert answers(saved(page))["load"]["fz"] == 10e3
    page.click("#redo")
    settled(page)
    assert answers(saved(page))["load"]["fz"] == 4e3


def test_the_keyboard_alone_does(visit: Any) -> None:
    page = visit()
    page.locator("#wanted").wait_for()
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement !== document.body")
    page.evaluate("document.activeElement.blur()")

    def go_to(selector: str) -> None:
        for _ in range(150):
            page.keyboard.press("Tab")
            if page.evaluate("one => document.activeElement.matches(one)", selector):
                ring = page.evaluate(
                    "(({outlineStyle, boxShadow}) => outlineStyle + boxShadow)"
                    "(getComputedStyle(document.activeElement))"
                )
                assert ring != "nonenone", f"nobody sees where {selector} is"
                return
        raise AssertionError(f"the keyboard does not reach {selector}")

    go_to("#wanted")
    page.keyboard.type("6205")
    page.keyboard.press("Enter")
    page.locator(ANSWERED).wait_for()
    go_to('[data-name="duty.load.fz"] input:not([type=range])')
    page.keyboard.type("3 kN")
    page.keyboard.press("Enter")
    settled(page)
    page.keyboard.press("Shift+Tab")  # its slider
    page.keyboard.press("ArrowRight")
    settled(page)
    truth = answers(saved(page))
    assert truth["load"]["fz"] > 3e3
    same_numbers(page, truth)


def test_an_unsolved_case_shows_no_number(visit: Any, tmp_path: Path) -> None:
    case = tmp_path / "away.toml"
    case.write_text(
        '[bearing]\nball_count = 16\nball_diameter = "22.23 mm"\npitch_diameter = "125.26 mm"\n'
        'contact_angle = "40 deg"\ninner_conformity = 0.5232\nouter_conformity = 0.5232\n'
        '[duty]\ninner_speed = "10000 rpm"\n[duty.load]\nfx = "-20 kN"\n',
        encoding="utf-8",
    )
    page = visit()
    page.set_input_files("#file", case)
    page.locator("#status p.warning").filter(has_text=re.compile(r"\w{5}")).wait_for()
    settled(page)
    assert page.locator("#figures .figure").count() == 0
    assert page.locator("#status p").count() == 1  # the reason stands once
    assert "duty.load" not in page.locator("#work .results, #status").all_inner_texts()[0]


def test_every_designation_that_opens_is_found(visit: Any) -> None:
    page = visit()
    page.fill("#wanted", "7014 C/HCP4A DBA")
    page.locator("#found .best").filter(has_text="7014 C/HCP4A DBA").click()
    page.locator("#drawing svg .ring").first.wait_for()
    assert page.locator("#drawing svg .ring").count() == 8  # two bearings, above and below


def test_sizes_lead_to_a_choice(visit: Any) -> None:
    page = visit()
    page.fill("#wanted", "40x68")
    page.press("#wanted", "Enter")
    page.locator("#wanted-error").filter(has_text=re.compile(r"\w")).wait_for()
    assert page.evaluate("document.activeElement.closest('#found') !== null")


def test_what_is_carried_is_asked_first(visit: Any) -> None:
    page = visit()
    opened(page)
    page.locator("#first").wait_for()
    assert page.locator("#figures .figure").count() == 0
    page.fill('#first input[name="duty.load.fz"]', "5")
    page.fill('#first input[name="duty.inner_speed"]', "1480")
    page.press('#first input[name="duty.inner_speed"]', "Enter")
    page.locator(CONVERGED).wait_for()
    settled(page)
    assert page.locator("#first").is_hidden()
    assert "5 kN" in page.locator("#drawing text.load").text_content()
    truth = answers(saved(page))
    assert truth["load"]["fz"] == 5000.0
    same_numbers(page, truth)


def test_limits_stand_beside_the_key_figures(visit: Any) -> None:
    page = visit()
    opened(page)
    typed(page, "duty.load.fz", "60 kN")
    pressure = page.locator('.figure[data-key="extremes.max_pressure"]')
    assert "4200 MPa" in pressure.inner_text()
    assert "bad" in pressure.get_attribute("class").split()


def test_an_oil_and_a_base_oil_do_not_freeze_the_page(visit: Any) -> None:
    page = visit()
    opened(page)
    typed(page, "duty.load.fz", "5 kN")
    typed(page, "lubricant", "ISO VG 32")
    typed(page, "lubricant.base_oil", "ISO VG 32")
    assert page.locator("#status p.bad").count() == 0
    typed(page, "duty.load.fz", "6 kN")
    assert answers(saved(page))["load"]["fz"] == 6000.0


def test_four_cases_have_names(visit: Any) -> None:
    page = visit()
    opened(page)
    typed(page, "duty.load.fz", "10 kN")
    page.click("#compare")
    page.click("#add")
    page.click("#add")
    settled(page)
    assert page.locator("#add").is_hidden()
    name = page.locator("#slot-list .slot input[type=text]").first
    name.fill("as drawn")
    name.press("Enter")
    typed(page, "duty.load.fz", "5 kN")
    rows = page.locator("#figures tbody th").all_inner_texts()
    assert rows == ["as drawn", "B", "C", "D"]
    assert page.locator("#figures").bounding_box()["height"] < 160
    assert "5 kN" in page.locator("#changed").inner_text()


def test_a_goal_is_sought_and_used(visit: Any) -> None:
    page = visit()
    opened(page)
    typed(page, "duty.load.fz", "10 kN")
    typed(page, "duty.inner_speed", "1500 rpm")
    page.locator("#seek summary").click()
    page.locator("#seek select[name=output] option[value=life_hours]").wait_for(state="attached")
    page.select_option("#seek select[name=vary]", "duty.load.fz")
    page.select_option("#seek select[name=output]", "life_hours")
    page.fill("#seek input[name=wanted]", "20000")
    page.press("#seek input[name=wanted]", "Enter")
    page.locator("#seek .tools button").filter(has_text="kN").click()
    settled(page)
    life = page.locator('.figure[data-key="life"] dd').first.inner_text()
    assert number(life.replace("h", "")) == pytest.approx(20_000, rel=2e-3)


def test_what_would_help_is_tried_beside(visit: Any) -> None:
    page = visit()
    opened(page)
    typed(page, "duty.load.fz", "10 kN")
    typed(page, "duty.inner_speed", "1500 rpm")
    page.locator("#helps button").first.click()
    settled(page)
    assert page.locator("#slot-list .slot").count() == 2
    assert "9 kN" in page.locator("#changed").inner_text()


def test_a_link_gives_the_names_of_the_cases(visit: Any) -> None:
    page = visit()
    opened(page)
    typed(page, "duty.load.fz", "5")
    page.click("#compare")
    for place, name in enumerate(("as drawn", "belt too tight")):
        called = page.locator("#slot-list input[type=text]").nth(place)
        called.fill(name)
        called.press("Enter")
    page.click("#share")
    page.locator("#sharing").wait_for()
    link = page.locator("#link").input_value()
    other = visit()
    other.goto("about:blank")
    other.goto(link)
    other.locator("#slot-list input[type=text]").nth(1).wait_for()
    names = [one.input_value() for one in other.locator("#slot-list input[type=text]").all()]
    assert names == ["as drawn", "belt too tight"]
    other.reload()
    other.locator("#slot-list input[type=text]").nth(1).wait_for()
    assert other.locator("#slot-list input[type=text]").nth(1).input_value() == "belt too tight"


@pytest.mark.parametrize("lang", LANGUAGES)
def test_tolerances_scatter_the_results(visit: Any, lang: str) -> None:
    page = visit(lang=lang)
    opened(page)
    typed(page, "duty.inner_speed", "1480")
    typed(page, "duty.load.fz", "15")
    page.locator("#tolerance summary").click()
    page.locator("#tolerance table").wait_for()
    page.select_option("#tolerance select[name=more]", "duty.load.fz")
    answered = "**/page/tolerance*"
    with page.expect_response(answered):
        page.locator("#tolerance .tools button").first.click()
    load = page.locator("#tolerance .row", has=page.locator("[id='scatter-duty.load.fz']"))
    load.wait_for()
    page.wait_for_timeout(300)

    def lives() -> list[float]:
        row = page.locator("#tolerance tr", has_text="vida" if lang == "pt" else "life").first
        cells = row.locator("td").all_inner_texts()[:3]
        return [number(cell) for cell in cells]

    narrow = lives()
    assert narrow == sorted(narrow)
    with page.expect_response(answered):
        load.locator("input[type=range]").fill("90")
    page.wait_for_timeout(300)
    wide = lives()
    assert wide[0] < 0.8 * narrow[0]
    assert wide[2] > 1.2 * narrow[2]
    page.locator("#tolerance .plot .js-line").first.wait_for(state="attached")
    assert "±" in (load.locator("input[type=range]").get_attribute("aria-valuetext") or "")
    load.locator("input[type=text]").fill("99")
    load.locator("input[type=text]").press("Enter")
    assert page.locator("#tolerance .error").inner_text() != ""
    count = page.locator("#tolerance .row").count()
    page.locator("#tolerance .close").first.click()
    page.locator("#tolerance .row").nth(count - 1).wait_for(state="detached")
