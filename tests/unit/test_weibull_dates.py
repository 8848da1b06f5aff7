"""Lives between two dates, and intervals with an open end."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from rolamento.cli.app import app
from rolamento.errors import InputError
from rolamento.weibull import LifeTest, maximum_likelihood, parse_life_test

INTERVALS = "lower,upper,count\n0,10,50\n11,20,25\n21,25,15\n26,30,9\n31,,1\n"
DATES = (
    "tag;installed;failure date\na;2024-01-01;2024-06-01\nb;2024-02-01;\nc;15/01/2024;14/01/2025\n"
)


@pytest.mark.parametrize("names", ["lower,upper", "start,end", "left,right", "from,to", "de,até"])
@pytest.mark.parametrize("open_end", ["", "inf", "∞", "Infinity"])
def test_an_open_end_is_a_suspension(names: str, open_end: str) -> None:
    text = INTERVALS.replace("lower,upper", names).replace("31,,", f"31,{open_end},")
    test = parse_life_test(text)
    assert (test.failures, test.suspensions) == (99, 1)
    fit = maximum_likelihood(test)
    assert fit.shape == pytest.approx(1.441, abs=5e-4)
    assert fit.scale == pytest.approx(14.05, abs=5e-3)
    usual = parse_life_test(
        "lower,time,status,count\n0,10,f,50\n11,20,f,25\n21,25,f,15\n26,30,f,9\n,31,s,1\n"
    )
    assert fit.shape == maximum_likelihood(usual).shape


def test_equal_ends_are_a_time() -> None:
    test = parse_life_test("lower (Mrev),upper (Mrev)\n10,10\n12,15\n20,\n")
    assert test.unit == "Mrev"
    assert test.times.tolist() == [10.0, 15.0, 20.0]
    assert test.failed.tolist() == [True, True, False]
    assert test.lower.tolist()[1] == 12.0
    assert test.inspected


def test_a_status_beside_intervals_holds() -> None:
    test = parse_life_test("lower;upper;status\n5;10;f\n10;;s\n")
    assert test.failed.tolist() == [True, False]
    with pytest.raises(InputError, match="must be empty for a bearing that did not fail"):
        parse_life_test("lower;upper;status\n5;10;s\n")


def test_a_time_beside_a_lower_end_is_read_as_ever() -> None:
    test = parse_life_test("lower,time,status\n0,10,f\n,12,s\n")
    assert isinstance(test, LifeTest)
    assert test.lower.tolist()[0] == 0.0


def test_days_between_two_dates() -> None:
    test = parse_life_test(DATES, as_of="2024-12-31")
    assert test.unit == "d"
    assert test.times.tolist() == [152.0, 334.0, 365.0]  # 2024 has 29 February
    assert test.failed.tolist() == [True, False, True]
    assert [note.key for note in test.notes][:2] == ["lives_from_dates", "running_on_day_of_data"]


def test_a_use_per_day_makes_running_hours() -> None:
    test = parse_life_test(DATES, as_of="2024-12-31", use_per_day="16 h")
    assert test.unit == "h"
    assert test.times.tolist() == [152.0 * 16.0, 334.0 * 16.0, 365.0 * 16.0]
    by_column = parse_life_test(
        "installed;failure date;hours per day\n"
        "2024-01-01;2024-01-11;16\n2024-01-01;2024-01-21;8,5\n"
    )
    assert by_column.times.tolist() == [160.0, 170.0]
    assert "lives_from_dates_and_column" in [note.key for note in by_column.notes]
    with pytest.raises(InputError, match="at most 24 h a day"):
        parse_life_test(DATES, as_of="2024-12-31", use_per_day="30 h")


def test_a_time_of_day_counts() -> None:
    test = parse_life_test(
        "installed,failed on,status\n2024-01-01 06:00,2024-01-02 18:00,f\n2024-01-01,2024-01-03,f\n"
    )
    assert test.times.tolist() == pytest.approx([1.5, 2.0])


def test_the_day_of_the_data_is_asked_for() -> None:
    with pytest.raises(InputError, match="until which day") as raised:
        parse_life_test(DATES)
    assert (raised.value.line, raised.value.example) == (3, 'as_of="2026-12-31"')


def test_what_failed_is_asked_for_where_nothing_says_it() -> None:
    text = DATES.replace("failure date", "removal date")
    with pytest.raises(InputError, match="nothing says which of the others failed"):
        parse_life_test(text, as_of="2024-12-31")


def test_dates_in_doubt_are_asked_about() -> None:
    text = "installed,failure date\n03/04/2024,05/06/2024\n01/02/2024,07/09/2024\n"
    with pytest.raises(InputError, match="if the day comes first"):
        parse_life_test(text)
    by_day = parse_life_test(text, date_order="day_first")
    by_month = parse_life_test(text, date_order="month_first")
    assert by_day.times.tolist() == [63.0, 219.0]
    assert by_month.times.tolist() == [63.0, 189.0]


def test_columns_of_dates_can_be_chosen() -> None:
    text = "a,b,status\n2024-01-01,2024-02-01,f\n2024-01-01,2024-03-01,s\n"
    test = parse_life_test(text, start="a", end="b")
    assert test.times.tolist() == [31.0, 60.0]
    with pytest.raises(InputError, match="second column of dates"):
        parse_life_test(text, start="a")


@pytest.mark.parametrize(
    ("row", "message"),
    [
        ("2024-02-01,2024-01-01", "must be after the day"),
        ("soon,2024-01-01", "must be a date"),
        ("2024-01-01,never", "must be a date"),
    ],
)
def test_impossible_dates_are_refused_with_their_line(row: str, message: str) -> None:
    with pytest.raises(InputError, match=message) as raised:
        parse_life_test(f"installed,failure date\n2024-01-01,2024-02-01\n{row}\n")
    assert raised.value.line == 3


def test_what_goes_with_dates_alone_is_refused_elsewhere() -> None:
    for name, value in (("use_per_day", "16 h"), ("as_of", "2026-12-31")):
        with pytest.raises(InputError, match="goes with lives between two dates"):
            parse_life_test("time\n1\n2\n", **{name: value})


def test_the_command_takes_dates(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "d.csv").write_text(DATES, encoding="utf-8")
    few = ["--samples", "200"]
    result = CliRunner().invoke(app, ["weibull", "d.csv", *few], env={"LC_ALL": "C.UTF-8"})
    assert result.exit_code == 2
    assert "--as-of 2026-12-31" in result.stderr
    result = CliRunner().invoke(
        app,
        ["weibull", "d.csv", "--as-of", "2024-12-31", "--use-per-day", "16 h", *few],
        env={"LC_ALL": "C.UTF-8"},
    )
    assert result.exit_code == 0
    assert "2432 to 5840 h" in result.stdout
    plain = CliRunner().invoke(
        app, ["weibull", "d.csv", "--as-of", "2024-12-31", *few], env={"LC_ALL": "C.UTF-8"}
    )
    text = " ".join(plain.stdout.split())
    assert text.index("calendar days between installed and failure date") < text.index("confidence")
