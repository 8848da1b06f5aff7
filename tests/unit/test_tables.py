"""Tables that people write: one reader, any separator, either decimal mark."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import CliRunner

from rolamento._tables import Numerals, numerals_of, parse_table
from rolamento.catalogue.records import records_of_csv
from rolamento.cli.app import app
from rolamento.errors import InputError
from rolamento.life.l_able import read_factor_table
from rolamento.tasks.life_spectrum import read_spectrum
from rolamento.weibull import parse_life_test, parse_trend

Run = Callable[..., tuple[int, str, str]]
THOUSANDS = "vida (h);situação\n12.500;falha\n8.200;falha\n15.000;suspenso\n"


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    monkeypatch.chdir(tmp_path)

    def runner(*arguments: str) -> tuple[int, str, str]:
        result = CliRunner().invoke(app, arguments, env={"LC_ALL": "C.UTF-8"})
        if result.exception and not isinstance(result.exception, SystemExit):
            raise result.exception
        squeezed = (" ".join(text.split()) for text in (result.stdout, result.stderr))
        return (result.exit_code, *squeezed)

    return runner


@pytest.mark.parametrize(
    ("cells", "mark", "doubt"),
    [
        (["12.500", "8.200"], None, "12.500"),
        (["12.500", "850"], None, "12.500"),
        (["12.500", "3,5"], None, "12.500"),  # one hand writes both? it is asked
        (["12.500", "8.2"], None, ""),
        (["12.500", "0.250"], None, ""),
        (["12.500", "1,234.5"], None, ""),
        (["12.500", "1.234,5"], "comma", ""),
        (["1.234.567"], "comma", ""),
        (["12,5", "8"], None, ""),
        (["falha", "2.2024.1", "6205"], None, ""),
        (["1.500e3"], None, ""),
    ],
)
def test_what_numbers_tell_of_their_marks(cells: list[str], mark: str | None, doubt: str) -> None:
    found = numerals_of(cells, commas=True)
    assert (found.mark, found.doubt) == (mark, doubt)
    assert numerals_of(cells, commas=False) == Numerals(commas=False)


@pytest.mark.parametrize(
    ("cell", "mark", "number"),
    [
        ("12.500", "point", 12.5),
        ("12.500", "comma", 12500.0),
        ("-1.234.567,25", "comma", -1234567.25),
        ("1,234.5", "point", 1234.5),
        ("12,500", "point", 12500.0),
        ("12,500", "comma", 12.5),
        ("12,500", None, 12.5),
        ("1,234.5", None, 1234.5),
        ("12.5", "comma", None),
        ("3,5", "point", None),
        ("0.125", "comma", None),
        ("12.50.0", "comma", None),
        ("nan", None, None),
        ("1" * 41, None, None),
        ("", None, None),
    ],
)
def test_numbers_with_a_known_mark(cell: str, mark: str | None, number: float | None) -> None:
    assert Numerals(commas=True, mark=mark).number(cell) == number  # type: ignore[arg-type]


def test_a_life_test_of_a_spreadsheet_is_asked_about(run: Run) -> None:
    """12.500 is 12 500 h in Brazil and 12.5 h elsewhere: it is never guessed."""
    Path("vidas.csv").write_text(THOUSANDS, "utf-8")
    code, out, error = run("weibull", "vidas.csv")
    assert (code, out) == (2, "")
    assert (
        'vidas.csv, line 2: vida (h) = "12.500": is 12.5 if the point is the decimal mark' in error
    )
    assert "if the point is the decimal mark and" in error
    assert "--decimal-mark point for 12.5, --decimal-mark comma for 12500" in error
    for mark, last in (("comma", "15000"), ("point", "15")):
        code, out, _ = run("weibull", "vidas.csv", "--decimal-mark", mark, "--samples", "100")
        assert code == 0
        assert f"to {last} h" in out.replace("15 000", "15000")
    Path("vidas.csv").write_text("# decimal mark: comma\n" + THOUSANDS, "utf-8")
    code, out, _ = run("weibull", "vidas.csv", "--samples", "100", "--json")
    assert (code, json.loads(out)["failures"]) == (0, 2)
    assert (
        '--decimal-mark = "dot": must be one of point, comma'
        in run("weibull", "vidas.csv", "--decimal-mark", "dot")[2]
    )


def test_every_reader_asks(tmp_path: Path, run: Run) -> None:
    path = tmp_path / "t.csv"
    trend = "tempo (h);rolamento;folga (µm)\n1.000;9;27\n2.000;9;36\n"
    with pytest.raises(InputError, match=r"is 1 if .* and 1000 if"):
        parse_trend(trend)
    assert list(parse_trend(trend, decimal_mark="comma").times) == [1000.0, 2000.0]
    path.write_text(trend, "utf-8")
    assert "--decimal-mark point for 1, --decimal-mark comma for 1000" in run("trend", str(path))[2]
    assert run("trend", str(path), "--decimal-mark", "comma")[0] == 0

    duty = "share;duty.load.fz\n50 %;1.500 N\n50 %;2.500 N\n"
    path.write_text(duty, "utf-8")
    with pytest.raises(InputError, match=r"is 1.5 if .* and 1500 if"):
        read_spectrum(path)
    steps = read_spectrum(path, decimal_mark="comma")
    assert steps.cells["duty.load.fz"] == ("1500 N", "2500 N")
    path.write_text(duty.replace("2.500", "2.500,5"), "utf-8")
    assert read_spectrum(path).cells["duty.load.fz"] == ("1500 N", "2500.5 N")

    path.write_text("kappa;1;2\n1;1.200;1.300\n2;1.400;1.500\n", "utf-8")
    with pytest.raises(InputError, match=r"is 1.2 if"):
        read_factor_table(path)
    assert read_factor_table(path, decimal_mark="point").factor[0, 0] == 1.2

    own = "designation;bore_mm;outside_diameter_mm;dynamic_rating_N\nA-1;25;52;14.000\n"
    with pytest.raises(
        InputError, match=r'line 2: dynamic_rating_N = "14.000": is 14 if'
    ) as caught:
        records_of_csv(own, "own.csv")
    assert "decimal_mark=" not in str(caught.value)  # the file says it: there is no argument
    assert records_of_csv("# decimal mark: comma\n" + own, "own.csv")[0].dynamic_rating == 14_000.0


def test_one_reader_for_all_separators() -> None:
    for text in ("a,b\n1,2\n", "a;b\n1;2\n", "\ufeffa\tb\r\n1\t2\r\n"):
        table = parse_table(text.removeprefix("\ufeff"), "t", most_rows=5, example="a,b")
        assert (table.header, table.rows, table.lines) == (("a", "b"), (("1", "2"),), (2,))
    said = parse_table("# Title: x: y\n#nothing\na\n# unit: h\n1\n", "t", most_rows=5, example="a")
    assert said.said == {"title": "x: y"}


def flat(text: str) -> str:
    """The text without line breaks and margins."""
    return " ".join(text.split())


def test_tables_of_life_as_people_have_them(run: Run) -> None:
    """A shift report: columns nobody asked for, names of the shop, words of the shop."""
    text = (
        "TAG;Data de instalação;Horas de operação;Condição final;Lubrificante;Operador\n"
        "B-01;01.02.2024;1250,5;Quebrou;Óleo;J\nB-02;01.02.2024;1800;Em operação;Graxa;M\n"
        "B-03;05.03.2024;900;quebrou;Óleo;J\nB-04;05.03.2024;2100,0;ok;Óleo;J\n"
    )
    Path("shop.csv").write_text(text, "cp1252")
    code, _, error = run("weibull", "shop.csv")
    assert code == 2  # without a status all would count as failed
    assert "Condição final: seems to say what failed" in error
    assert "--status-column 'Condição final'" in error
    arguments = ("weibull", "shop.csv", "--status-column", "condição final", "--samples", "100")
    code, out, _ = run(*arguments)
    assert code == 0
    assert "4 bearings, 2 failed, 2 suspended; 900 to 2100 h" in out.replace("2 100", "2100")
    assert "not read: TAG, Data de instalação, Lubrificante, Operador" in flat(out)
    out = run(*arguments, "--lang", "pt")[1]
    assert "Colunas da tabela que não foram lidas: TAG, Data de instalação" in out
    test = parse_life_test(text, time="Horas de operação", status="Condição final")
    assert (list(test.failed), test.unit) == ([True, False, True, False], "h")
    assert test.select([0]).passed_over == test.passed_over


def test_columns_by_choice() -> None:
    text = "tempo;horas no ensaio;estado;falha\n1;10;falha;0\n2;20;falha;1\n"
    with pytest.raises(InputError, match='status="name of the column"'):
        parse_life_test(text)
    by_state = parse_life_test(text, status="estado")
    assert (list(by_state.times), by_state.failures) == ([1.0, 2.0], 2)
    assert by_state.passed_over == ("horas no ensaio", "falha")
    chosen = parse_life_test(text, time="Horas no ensaio", status="falha")
    assert (list(chosen.times), list(chosen.failed)) == ([10.0, 20.0], [False, True])
    assert chosen.unit == "h"
    with pytest.raises(
        InputError, match="hours: is not a column of the file; the columns are tempo"
    ):
        parse_life_test(text, time="hours")
    with pytest.raises(InputError, match=r"is chosen for two purposes"):
        parse_life_test(text, time="estado", status="estado")
    with pytest.raises(InputError, match=r"occurs twice.*time=\"hours\""):
        parse_life_test("time,hours\n1,1\n")
    with pytest.raises(InputError, match="did you mean status"):  # a slip is no other column
        parse_life_test("time,statsu,zz\n1,f,1\n")


def test_trends_as_people_have_them(run: Run) -> None:
    text = (
        "Data;Horas;Mancal;Operador;folga radial (µm)\n"
        "01/02/2024;0;A;J;27,5\n02/02/2024;60;A;J;36\n03/02/2024;120;A;M;x\n04/02/2024;240;A;M;45\n"
    )
    Path("t.csv").write_text(text, "utf-8")
    code, _, error = run("trend", "t.csv")
    assert code == 2
    assert "--time-column 'name of the column', --bearing-column 'name of the column'" in error
    code, out, _ = run("trend", "t.csv", "--bearing-column", "mancal")
    assert code == 0
    assert "not read, as they have no unit: Data, Operador" in flat(out)
    record = parse_trend(text, time="horas", bearing="Mancal")
    assert (record.time_unit, record.units, record.names) == ("h", ("µm",), ("A",))
    assert list(record.values[:2, 0]) == [27.5, 36.0]
    assert record.rejected[2, 0]
