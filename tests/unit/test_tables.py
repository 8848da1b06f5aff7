"""Tables that people write: one reader, any separator, either decimal mark."""

from __future__ import annotations

import json
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path

import pytest
from typer.testing import CliRunner

from rolamento.catalogue.records import records_of_csv
from rolamento.cli.app import app
from rolamento.errors import InputError
from rolamento.io.dates import DateOrder, Dates, dates_of
from rolamento.io.numerals import Numerals, numerals_of
from rolamento.io.tables import parse_table
from rolamento.life.l_able import read_factor_table
from rolamento.tasks.life_spectrum import read_spectrum
from rolamento.vibration.reading import open_signal
from rolamento.weibull import parse_life_test, parse_trend, read_life_test

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
        '--decimal-mark: "dot": must be one of point, comma'
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


@pytest.mark.parametrize(
    ("cells", "order", "doubt"),
    [
        (["03/04/2024", "05/04/2024"], None, "03/04/2024"),
        (["03/04/2024", "25/04/2024"], "day_first", ""),
        (["03-04-2024", "04-25-2024"], "month_first", ""),
        (["03.04.2024", "2024-04-03", "4 mar 2024", "04/04/2024"], None, ""),
        (["", "x"], None, ""),
    ],
)
def test_what_dates_tell_of_their_order(cells: list[str], order: str | None, doubt: str) -> None:
    found = dates_of(cells)
    assert (found.order, found.doubt) == (order, doubt)
    assert dates_of(cells, "mdy").order == "month_first"


@pytest.mark.parametrize(
    ("cell", "order", "moment"),
    [
        ("2024-02-29", None, datetime(2024, 2, 29)),
        ("2024-02-29T14:30:00", None, datetime(2024, 2, 29, 14, 30)),
        ("20240229T143000", None, datetime(2024, 2, 29, 14, 30)),
        ("2024-02-29T14:30:00+02:00", None, datetime(2024, 2, 29, 12, 30, tzinfo=UTC)),
        ("2024-02-29 14:30 Z", None, datetime(2024, 2, 29, 14, 30, tzinfo=UTC)),
        ("29/02/2024 14:30", None, datetime(2024, 2, 29, 14, 30)),
        ("29/02/2024 14:30:15,250", None, datetime(2024, 2, 29, 14, 30, 15, 250_000)),
        ("29/02/2024 às 14h30", None, datetime(2024, 2, 29, 14, 30)),
        ("02/29/2024 2:30:00 PM", "month_first", datetime(2024, 2, 29, 14, 30)),
        ("02/29/2024 12:05 am", "month_first", datetime(2024, 2, 29, 0, 5)),
        ("03/04/2024", "month_first", datetime(2024, 3, 4)),
        ("03.04.24", "month_first", datetime(2024, 4, 3)),
        ("3 de março de 2024", None, datetime(2024, 3, 3)),
        ("4. März 2024, 08:00", None, datetime(2024, 3, 4, 8)),
        ("4 de enero de 2024", None, datetime(2024, 1, 4)),
        ("Mar 4, 2024 08:00", None, datetime(2024, 3, 4, 8)),
        ("03-Mar-2024", None, datetime(2024, 3, 3)),
        ("13-Apr-23 09:57:51", None, datetime(2023, 4, 13, 9, 57, 51)),
        ("2024-02-29 24:00", None, datetime(2024, 3, 1)),
        ("2024-02-29 25:00", None, None),
        ("2024-02-29 13:30 PM", None, None),
        ("2024-02-29 about noon", None, None),
        ("30/02/2024", None, None),
        ("25/13/2024", None, None),
        ("2024", None, None),
        ("1" * 99, None, None),
    ],
)
def test_dates(cell: str, order: DateOrder | None, moment: datetime | None) -> None:
    assert Dates(order).moment(cell) == moment


def test_dates_of_two_readings_are_asked_about(run: Run) -> None:
    Path("t.csv").write_text("Date;Vibration (mm/s)\n03/04/2024;2.1\n05/04/2024;2.4\n", "utf-8")
    code, _, error = run("trend", "t.csv")
    assert code == 2
    assert 'line 2: Date = "03/04/2024": is 2024-04-03 if the day comes first' in error
    assert "--date-order day_first for 2024-04-03, --date-order month_first for 2024-03-04" in error
    for order, days in (("day_first", 2.0), ("month_first", 61.0)):
        code, out, _ = run("trend", "t.csv", "--date-order", order, "--json")
        record = json.loads(out)
        assert (code, record["time_unit"], record["rows"][1]["time"]) == (0, "d", days)
    said = "# dates: day first\n" + Path("t.csv").read_text("utf-8")
    assert parse_trend(said).start == "2024-04-03"
    assert '--date-order: "dd": must be one of' in run("trend", "t.csv", "--date-order", "dd")[2]


def test_a_record_of_one_machine_needs_no_column_of_it() -> None:
    """Dates with the day above 12; quantities by a usual name, a unit behind it or as chosen."""
    record = parse_trend("data;velocidade mm/s\n13/02/2024;2,1\n14/02/2024;2,4\n")
    assert (record.names, record.quantities, record.units) == (("",), ("velocidade",), ("mm/s",))
    assert (record.start, list(record.times)) == ("2024-02-13", [0.0, 1.0])
    assert parse_trend("horas,valor\n1,2\n").quantities == ("valor",)
    table = "horas,id,largura,valor\n1,A,2,3\n"
    record = parse_trend(table, values=["largura"])
    assert (record.values[0, 0], record.passed_over) == (2.0, ("valor",))
    assert [note.key for note in record.notes] == ["passed_over_columns"]
    with pytest.raises(InputError, match=r'may name what was measured.*bearing="Sala"'):
        parse_trend("horas,Sala,valor\n1,A,2\n1,B,3\n")


def test_a_fleet_as_maintenance_has_it() -> None:
    """Free text beside the status, machines that had several bearings, separators at the end."""
    text = (
        "Máquina;Falha;Horas (h);Situação;Qtde;Custo\n"
        "B-1;pista externa;12500;quebra;1;1.234,50;;\nB-1;;8200;falha;1;;\n"
        "B-3;;15000;em operação;2;\nB-4;;9400;troca preventiva;1;\n"
    )
    test = parse_life_test(text)
    assert list(test.failed) == [True, True, False, False]
    assert (test.size, test.passed_over, test.machines) == (5, ("Falha", "Custo"), "Máquina")
    assert [note.key for note in test.notes] == ["passed_over_columns", "machines_not_rigs"]
    assert test.select([0]).notes == test.notes
    # machines that end as one are rigs
    alike = parse_life_test("Mrev,máquina,status\n10,A,f\n10,A,s\n12,B,s\n12,B,s\n")
    assert (list(alike.rig), alike.notes) == (["A", "A", "B", "B"], ())


def test_a_column_of_counts_by_another_name(run: Run) -> None:
    Path("t.csv").write_text("horas;situação;unidades\n100;falha;2\n200;falha;1\n", "utf-8")
    assert read_life_test("t.csv", count="unidades").size == 3
    code, out, _ = run("weibull", "t.csv", "--count-column", "unidades", "--json")
    assert (code, json.loads(out)["size"]) == (0, 3)
    notes = json.loads(run("weibull", "t.csv", "--json")[1])["notes"]
    assert notes[0]["values"] == {"columns": ["unidades"]}


def test_status_in_letters() -> None:
    """F and S under any name are no remark: else all bearings would count as failed."""
    assert list(parse_life_test("horas;F/S\n10;F\n20;S\n").failed) == [True, False]
    assert list(parse_life_test("horas;Falha/Suspensão\n10;F\n20;C\n").failed) == [True, False]
    with pytest.raises(InputError, match="Cod: seems to say what failed"):
        parse_life_test("horas;Cod\n10;F\n20;S\n")


def test_comments_in_portuguese_and_thousands_with_spaces() -> None:
    text = "# título: Bombas\n# unidade: km\n# separador decimal: vírgula\nvida;status\n12.500;f\n"
    test = parse_life_test(text)
    assert (test.title, test.unit, list(test.times)) == ("Bombas", "km", [12_500.0])
    assert parse_trend("# datas: dia primeiro\ndata;valor\n03/04/2024;1\n").start == "2024-04-03"
    numerals = Numerals(commas=True, mark="comma")
    assert numerals.number("12\u202f500,5") == 12_500.5
    assert numerals.number("1 234 567") == 1_234_567.0
    assert numerals.number("12 50") is None


def test_a_table_without_names_is_told_so() -> None:
    for text in ("12500;falha\n8200;falha\n", "12.500;falha\n8.200;falha\n"):
        with pytest.raises(InputError, match=r"header = .*names of the columns must be"):
            parse_life_test(text)
        with pytest.raises(InputError, match="names of the columns must be"):
            parse_trend(text)


def test_decimal_commas_elsewhere_in_a_table_of_commas() -> None:
    """Quotation marks hold them; then the points of 12.500 may part thousands."""
    text = 'horas,status,custo\n12.500,falha,"1.234,50"\n8.200,falha,"0,5"\n'
    with pytest.raises(InputError, match=r"is 12.5 if .* and 12500 if"):
        parse_life_test(text)
    assert list(parse_life_test(text, decimal_mark="comma").times) == [12_500.0, 8200.0]
    assert list(parse_life_test(text, decimal_mark="point").times) == [12.5, 8.2]
    english = text.replace("1.234,50", "1,234").replace("0,5", "12,345")
    assert list(parse_life_test(english).times) == [12.5, 8.2]


def test_commas_in_thousands_of_a_table_of_tabs() -> None:
    text = "hours\tstatus\n12,500\tfailed\n8,200\tfailed\n"
    with pytest.raises(InputError, match=r"is 12500 if the comma separates .* and 12.5 if"):
        parse_life_test(text)
    assert list(parse_life_test(text, decimal_mark="point").times) == [12_500.0, 8200.0]
    assert list(parse_life_test(text.replace("8,200", "8,2")).times) == [12.5, 8.2]
    assert list(parse_life_test(text.replace("8,200", "8.2")).times) == [12_500.0, 8.2]
    assert list(parse_life_test(text.replace("\t", ";")).times) == [12.5, 8.2]


def test_signals_are_asked_about_as_well(tmp_path: Path) -> None:
    path = tmp_path / "s.csv"
    path.write_text("acc (mg)\n" + "1.250\n-2.500\n" * 50, "utf-8")
    with pytest.raises(InputError, match=r"is 1.25 if .* and 1250 if"):
        open_signal(path)


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
        "Data;Horas;Alojamento;Operador;folga radial (µm)\n"
        "01/02/2024;0;A;J;27,5\n02/02/2024;60;A;J;36\n03/02/2024;120;A;M;x\n04/02/2024;240;A;M;45\n"
    )
    Path("t.csv").write_text(text, "utf-8")
    code, _, error = run("trend", "t.csv")
    assert code == 2
    assert "may name what was measured" in error
    assert "--bearing-column Alojamento" in error
    code, out, _ = run("trend", "t.csv", "--bearing-column", "alojamento")
    assert code == 0
    assert "Columns of the table that were not read: Data, Operador." in flat(out)
    record = parse_trend(text, time="horas", bearing="Alojamento")
    assert (record.time_unit, record.units, record.names) == ("h", ("µm",), ("A",))
    assert list(record.values[:2, 0]) == [27.5, 36.0]
    assert record.rejected[2, 0]


def test_decimal_commas_in_other_columns_tell_what_points_are() -> None:
    """A maintenance record of a Brazilian spreadsheet: hours in thousands beside costs."""
    text = (
        "TAG;horas;situação;custo (R$)\n"
        "B-01;12.450;falha;1.250,00\nB-02;8.760;falha;0,00\nB-03;20.000;suspenso;0,00\n"
    )
    assert list(parse_life_test(text).times) == [12_450.0, 8760.0, 20_000.0]
    assert list(parse_life_test(text, decimal_mark="point").times) == [12.45, 8.76, 20.0]
    silent = text.replace("1.250,00", "1250").replace("0,00", "0")
    contradictory = text.replace("B-02", "3.5")
    for doubtful in (silent, contradictory):
        with pytest.raises(InputError, match=r"is 12.45 if .* and 12450 if"):
            parse_life_test(doubtful)
