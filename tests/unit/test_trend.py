"""Records of what grew while bearings ran: reading, laws of wear, page and figure."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from rolamento.charts.drawing import draw
from rolamento.clearance import fit_wear
from rolamento.cli.app import app
from rolamento.document.medium import Medium
from rolamento.document.terminal import terminal
from rolamento.errors import InputError
from rolamento.pages.trend import trend_page
from rolamento.plots.trend import trend_chart, trend_figure
from rolamento.tasks.weibull import TrendEvaluation, TrendStudy
from rolamento.weibull import (
    PUBLISHED_TRENDS,
    parse_trend,
    published_trend,
    published_trend_text,
    wear_of_each,
)
from rolamento.words import speaking

Run = Callable[..., tuple[int, str, str]]
CLEARANCE = "time (h),bearing,clearance (µm)\n"


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    monkeypatch.chdir(tmp_path)

    def runner(*arguments: str, given: str | bytes | None = None) -> tuple[int, str, str]:
        result = CliRunner().invoke(
            app, ["trend", *arguments], input=given, env={"LC_ALL": "C.UTF-8"}
        )
        if result.exception and not isinstance(result.exception, SystemExit):
            raise result.exception
        return result.exit_code, result.stdout, result.stderr

    return runner


def test_the_clearances_of_campanha() -> None:
    """Table 4.3.1."""
    trend = published_trend("campanha_2008_clearance")
    assert (trend.time_unit, trend.units) == ("h", ("µm",))
    assert trend.names == ("9", "10")
    times, values = trend.of_bearing("10")
    np.testing.assert_array_equal(times, [0.0, 60.0, 120.0, 180.0, 627.6])
    np.testing.assert_array_equal(values, [24.0, 37.0, 44.0, 47.0, 48.0])


def test_the_noise_of_campanha() -> None:
    """Table 4.1.4: bearing 9 was rejected at the end."""
    trend = published_trend("campanha_2008_anderon")
    assert trend.quantities == ("L", "M", "H")
    np.testing.assert_array_equal(trend.of_bearing("9", 1)[1], [30.0, 45.0, 60.0])
    np.testing.assert_array_equal(trend.of_bearing("10", 2)[1], [30.0, 40.0, 40.0, 70.0])
    assert trend.rejected.sum() == 3
    assert trend.to_mapping()["rows"][3]["values"] == [None, None, None]


def test_the_law_is_that_of_the_clearance_module() -> None:
    trend = published_trend("campanha_2008_clearance")
    for name, fit in wear_of_each(trend).items():
        times, values = trend.of_bearing(name)
        alone = fit_wear(3600.0 * times, 1e-6 * values)
        assert fit.constants == pytest.approx(alone.constants)


def test_what_is_no_length_has_no_law() -> None:
    with pytest.raises(InputError):
        wear_of_each(published_trend("campanha_2008_anderon"))


@pytest.mark.parametrize("name", PUBLISHED_TRENDS)
def test_published_records_name_their_source(name: str) -> None:
    assert "Campanha" in published_trend(name).source
    assert published_trend_text(name).startswith("# title: ")


@pytest.mark.parametrize(
    "text",
    [
        "", "\n", CLEARANCE, "time (h),point of mine,clearance (µm)\n1,A,2\n",
        "bearing,clearance (µm)\n1,2\n", "time,bearing,clearance (µm)\n1,9,2\n",
        "time (h),bearing,width\n1,9,2\n", "time (h),bearing\n1,9\n", CLEARANCE + "1,9\n",
        CLEARANCE + "1,9,2,3\n",
        CLEARANCE + "-1,9,2\n", CLEARANCE + "nan,9,2\n", CLEARANCE + "1,9,inf\n",
        CLEARANCE + "1,9,1e999\n", CLEARANCE + "1,,2\n", CLEARANCE + "1," + "9" * 99 + ",2\n",
        CLEARANCE + '1,"9,2\n', CLEARANCE + "1,9," + "2" * 3000 + "\n",
        CLEARANCE + "".join(f"1,{i},2\n" for i in range(51)),
        "time (h),bearing," + ",".join(f"q{i} (m)" for i in range(9)) + "\n" + "1," * 10 + "1\n",
    ],
)  # fmt: skip
def test_hostile_records_end_with_one_line(run: Run, text: str) -> None:
    with pytest.raises(InputError):
        parse_trend(text)
    code, out, err = run("-", given=text)
    assert (code, out) == (2, "")
    assert err.count("\n") == 1


@pytest.mark.parametrize("language", ["en", "pt"])
@pytest.mark.parametrize("name", PUBLISHED_TRENDS)
def test_pages(name: str, language: str) -> None:
    found = TrendEvaluation(data=published_trend(name)).run()
    with speaking(language):
        document = trend_page(found)
    assert bool(found.fits) == name.endswith("clearance")
    for width in (80, 120):
        page = terminal(document, Medium(width))
        assert max(map(len, page.splitlines())) <= width
        assert "nan" not in page
    assert ("×" in page) == name.endswith("anderon")


def test_constants_of_the_page_are_those_of_the_fit() -> None:
    trend = published_trend("campanha_2008_clearance")
    fits = wear_of_each(trend)
    page = terminal(trend_page(TrendStudy(trend, fits)))
    (line,) = [x for x in page.splitlines() if x.startswith("  9  ")]
    cells, fit = line.split(), fits["9"]
    assert float(cells[1]) == pytest.approx(1e6 * fit.constants["initial_clearance"], rel=5e-3)
    assert float(cells[2]) == pytest.approx(1e6 * fit.standard_errors["initial_clearance"], rel=0.1)
    assert float(cells[5]) == pytest.approx(fit.constants["running_in_time"] / 3600.0, rel=5e-3)


def test_the_figure_shows_points_law_and_rejected() -> None:
    trend = published_trend("campanha_2008_clearance")
    fits = wear_of_each(trend)
    axes = draw(trend_chart(trend, fits=fits))
    points, law = axes.get_lines()[:2]
    np.testing.assert_array_equal(points.get_ydata(), [27.0, 36.0, 41.0, 45.0, 50.0])
    x, y = np.asarray(law.get_xdata()), np.asarray(law.get_ydata())
    np.testing.assert_allclose(y, 1e6 * fits["9"].clearance(3600.0 * x), rtol=1e-9)
    noise = trend_figure(published_trend("campanha_2008_anderon"))
    assert len(noise.get_axes()) == 3
    crosses = [
        line for panel in noise.get_axes() for line in panel.get_lines() if line.get_marker() == "x"
    ]
    assert [list(np.asarray(line.get_xdata())) for line in crosses] == [[627.6]] * 3


def test_the_command(run: Run, tmp_path: Path) -> None:
    code, out, err = run(
        "--example", "campanha-2008-clearance", "--plot", "c.png", "--json", "c.json"
    )
    assert (code, err) == (0, "")
    assert "Law of wear: P_0 + A (1 − e^(−t/τ))" in out
    assert (tmp_path / "c.png").read_bytes().startswith(b"\x89PNG")
    data = json.loads((tmp_path / "c.json").read_text("utf-8"))
    assert data["wear"]["9"]["law"] == "running_in"
    code, out, _ = run("--example", "campanha-2008-anderon", "--lang", "pt")
    assert code == 0
    assert "× reprovado" in out
    code, out, _ = run("--example", "campanha-2008-clearance", "--law", "power", "--json")
    assert json.loads(out)["wear"]["10"]["law"] == "power"


@pytest.mark.parametrize(
    "arguments",
    [
        (),
        ("--example", "other"),
        ("nothere.csv",),
        ("--example", "campanha-2008-clearance", "--law", "cubic"),
        ("--example", "campanha-2008-anderon", "--law", "power"),
        ("--example", "campanha-2008-clearance", "--plot", "x.gif"),
    ],
)
def test_wrong_wishes_end_with_one_line(run: Run, arguments: tuple[str, ...]) -> None:
    code, out, err = run(*arguments)
    assert (code, out) == (2, "")
    assert err.count("\n") == 1


def test_a_limit_reached_already_has_no_date(run: Run, tmp_path: Path) -> None:
    """That of the last measurement is none on which it was reached."""
    rows = "2026-01-05,1.20\n2026-02-02,1.45\n2026-03-02,1.62\n2026-03-30,2.05\n"
    (tmp_path / "t.csv").write_text("date,vibration (mm/s)\n" + rows, "utf-8")
    code, out, _ = run("t.csv", "--limit", "1.5 mm/s")
    assert code == 0
    section = out.partition("Time to the limit")[2]
    assert "has been reached already" in section
    assert "2026" not in section
    assert section.count(" already ") >= 2
