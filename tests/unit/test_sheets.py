"""Workbooks as tables: one sheet, or the one that is named; damaged and hostile ones."""

from __future__ import annotations

import datetime
import zipfile
from pathlib import Path

import openpyxl
import pytest

from rolamento.errors import FileError, InputError
from rolamento.vibration.reading import open_signal
from rolamento.weibull import read_life_test, read_trend


def _book(path: Path, **sheets: list[list[object]]) -> Path:
    book = openpyxl.Workbook()
    book.remove(book.active)
    for name, rows in sheets.items():
        sheet = book.create_sheet(name)
        for row in rows:
            sheet.append(row)
    book.save(path)
    return path


LIVES: list[list[object]] = [
    ["Life tests of rig 3"], [], ["Lebensdauer (h)", "Status"],
    [1250.5, "failed"], [12500, "suspended"], [1.234, "failed"],
]  # fmt: skip


def test_numbers_are_what_the_sheet_holds(tmp_path: Path) -> None:
    test = read_life_test(_book(tmp_path / "a.xlsx", Lives=LIVES, Empty=[]))
    assert test.times.tolist() == [1250.5, 12500.0, 1.234]
    assert list(test.failed) == [True, False, True]
    assert test.title == "Life tests of rig 3"


def test_a_workbook_goes_by_its_bytes(tmp_path: Path) -> None:
    path = _book(tmp_path / "a.xlsx", Lives=LIVES).rename(tmp_path / "dropped")
    assert read_life_test(path).failures == 2


def test_one_of_several_sheets_is_named(tmp_path: Path) -> None:
    path = _book(tmp_path / "a.xlsx", **{"Rig 3": LIVES, "Rig 4": [["time"], [7]]})
    with pytest.raises(FileError, match=r"several sheets \(Rig 3, Rig 4\).*a\.xlsx#Rig 3"):
        read_life_test(path)
    assert read_life_test(f"{path}#Rig 4").times.tolist() == [7.0]
    with pytest.raises(FileError, match="has no such sheet"):
        read_life_test(f"{path}#Rig 5")


def test_a_number_that_was_typed_as_text_is_none(tmp_path: Path) -> None:
    for text in ("12,5", "1.500", "1.5"):
        with pytest.raises(InputError, match="must be a number"):
            read_life_test(_book(tmp_path / "a.xlsx", S=[["time"], [text]]))


def test_moments_and_signals(tmp_path: Path) -> None:
    begin = datetime.datetime(2024, 1, 1, 8)
    rows: list[list[object]] = [["Date", "Velocity (mm/s)"]]
    rows += [[begin + datetime.timedelta(hours=6 * i), 1.0 + 0.1 * i] for i in range(4)]
    assert read_trend(_book(tmp_path / "t.xlsx", S=rows)).times.tolist() == [0.0, 0.25, 0.5, 0.75]
    record: list[list[object]] = [["Time (ms)", "Acc (g)"]]
    record += [[0.5 * i, float(i % 7)] for i in range(50)]
    with open_signal(_book(tmp_path / "s.xlsx", S=record)) as source:
        assert source.rate == pytest.approx(2000.0)
        assert source.read(0, 3).samples == pytest.approx([0.0, 9.80665, 2 * 9.80665])


@pytest.mark.parametrize(
    ("name", "content", "message"),
    [
        ("a.xlsx", b"PK\x03\x04[Content_Types].xml" + bytes(200), "is not a readable workbook"),
        ("a.zip", b"PK\x03\x04" + bytes(200), "is a binary file"),
        ("a.xls", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(600), "before 2007"),
        ("a.ods", b"PK\x03\x04mimetypeapplication/vnd.oasis.opendocument.spreadsheet", "OpenDocu"),
    ],
)
def test_what_is_no_workbook(tmp_path: Path, name: str, content: bytes, message: str) -> None:
    path = tmp_path / name
    path.write_bytes(content)
    with pytest.raises(FileError, match=message):
        read_life_test(path)


def test_a_workbook_that_inflates_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.xlsx"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("[Content_Types].xml", "<Types/>")
        archive.writestr("xl/worksheets/sheet1.xml", b" " * (70 * 2**20))
    with pytest.raises(FileError, match="declares 70 MB"):
        read_life_test(path)
