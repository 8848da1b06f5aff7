"""The record of a life test, and reading it from CSV."""

from __future__ import annotations

import copy
import pickle
from pathlib import Path

import numpy as np
import pytest

from rolamento.errors import FileError, InputError, UnknownKeyError
from rolamento.weibull import (
    LifeTest,
    maximum_likelihood,
    parse_life_test,
    published_life_test,
    published_text,
    read_life_test,
)


def test_one_value_stands_for_all_rows() -> None:
    test = LifeTest([3.0, 1.0, 2.0], [True, False, True], counts=2)
    assert test.size == 6
    assert test.failures == 4
    assert test.suspensions == 2
    assert test.total_time == 12.0
    assert len(test) == 3
    assert test.unit == "h"


def test_arrays_are_their_own_and_cannot_be_written() -> None:
    times = np.array([1.0, 2.0])
    test = LifeTest(times)
    times[0] = 9.0
    assert test.times[0] == 1.0
    with pytest.raises(ValueError, match="read-only"):
        test.times[0] = 5.0
    with pytest.raises(AttributeError):
        test.unit = "rev"  # type: ignore[misc]


def test_survives_copying_and_pickling() -> None:
    test = LifeTest([1.0, 2.0], [True, False], group=["a", "b"], unit="Mrev")
    for other in (copy.deepcopy(test), pickle.loads(pickle.dumps(test))):
        assert np.array_equal(other.times, test.times)
        assert list(other.group) == ["a", "b"]
        assert other.unit == "Mrev"


@pytest.mark.parametrize(
    ("scheme", "times", "failed"),
    [
        ("complete", [1.0, 2.0, 3.0], [1, 1, 1]),
        ("type_ii", [1.0, 2.0, 2.0], [1, 1, 0]),
        ("type_i", [1.0, 2.0, 3.0], [1, 1, 0]),
        ("type_i", [3.0, 3.0], [0, 0]),
        ("multiple", [1.0, 2.0, 3.0], [1, 0, 1]),
        ("multiple", [1.0, 2.0, 3.0], [1, 0, 0]),
    ],
)
def test_how_the_test_ended(scheme: str, times: list[float], failed: list[int]) -> None:
    assert LifeTest(times, failed).scheme == scheme


def test_rigs() -> None:
    test = LifeTest.sudden_death([50.0, 30.0], [4, 1])
    assert list(test.times) == [50.0, 50.0, 30.0]
    assert list(test.failed) == [True, False, True]
    assert list(test.counts) == [1, 3, 1]
    assert test.scheme == "sudden_death"
    ended = LifeTest.sudden_death([50.0, 30.0], 4, failed=[True, False])
    assert ended.size == 8
    assert ended.failures == 1
    assert ended.scheme == "multiple"
    assert LifeTest([5.0], [True], lower=[1.0]).scheme == "interval"


def test_groups_and_rows() -> None:
    test = LifeTest([1.0, 2.0, 3.0], group=["b", "a", "b"], unit="rev")
    parts = test.by_group()
    assert list(parts) == ["b", "a"]
    assert list(parts["b"].times) == [1.0, 3.0]
    assert parts["b"].unit == "rev"
    assert list(test.select([2, 0]).times) == [3.0, 1.0]
    with pytest.raises(InputError, match="rows"):
        test.select([True])


@pytest.mark.parametrize(
    ("match", "given"),
    [
        ("times", {"times": []}),
        ("times", {"times": [[1.0]]}),
        ("must be finite and positive; leave out a bearing that never", {"times": [0.0]}),
        ("must be finite and positive; leave out a bearing that never", {"times": [np.nan]}),
        ("must be finite and positive; leave out a bearing that never", {"times": [np.inf]}),
        ("times", {"times": ["long"]}),
        ("failed", {"times": [1.0], "failed": ["yes"]}),
        ("failed.*as long", {"times": [1.0], "failed": [True, False]}),
        ("failed", {"times": [1.0], "failed": [[True], [1, 2]]}),
        ("lower.*below", {"times": [1.0], "lower": [1.0]}),
        ("lower.*below", {"times": [1.0], "lower": [-0.5]}),
        ("lower.*failed", {"times": [1.0], "failed": [False], "lower": [0.5]}),
        ("counts", {"times": [1.0], "counts": [0]}),
        ("counts", {"times": [1.0], "counts": [1.5]}),
        ("counts.*bearings", {"times": [1.0, 2.0], "counts": [1_000_000, 1]}),
        ("group", {"times": [1.0], "group": ["a\nb"]}),
        ("group", {"times": [1.0], "group": ["a" * 100]}),
        ("rig.*several times", {"times": [1.0, 2.0], "rig": "A"}),
        ("rig.*several failures", {"times": [1.0, 1.0], "rig": "A"}),
        ("rig.*inspection", {"times": [1.0], "lower": [0.5], "rig": "A"}),
    ],
)
def test_what_cannot_be(match: str, given: dict[str, object]) -> None:
    with pytest.raises(InputError, match=match):
        LifeTest(**given)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "text",
    [
        "time,status\n120.5,failed\n88,suspended\n",
        "\ufeffTempo [h];Situação\r\n120,5;Falha\r\n88;Suspenso\r\n",
        "hours\tfailed\n120.5\tyes\n88\tno\n",
        "# unit: h\n# any remark\n\nHORAS;Falhou;Observação\n120,5;S;óleo\n88;n;\n",
        'bearing,censored,"time (hours)"\n1,0,120.5\n2,1,88\n',
        "status,vida_h\n1,120.5\n0,88\n",
    ],
)
def test_the_same_test_in_many_hands(text: str) -> None:
    test = parse_life_test(text)
    assert list(test.times) == [120.5, 88.0]
    assert list(test.failed) == [True, False]
    assert test.unit == "h"


def test_all_columns() -> None:
    test = parse_life_test(
        "# title: Eight\n# source: here\nfrom;to;count;status;lot;note\n"
        "0;10;2;failed;A;x\n10;20;1;failed;B;\n;20;5;suspended;A;\n"
    )
    assert list(test.lower[:2]) == [0.0, 10.0]
    assert np.isnan(test.lower[2])
    assert list(test.counts) == [2, 1, 5]
    assert list(test.group) == ["A", "B", "A"]
    assert (test.title, test.source) == ("Eight", "here")
    assert test.scheme == "interval"


def test_rigs_by_size_and_by_label() -> None:
    by_size = parse_life_test("Mrev,size,status\n10,4,f\n12,4,s\n")
    assert list(by_size.counts) == [1, 3, 4]
    assert list(by_size.failed) == [True, False, False]
    assert by_size.unit == "Mrev"
    by_label = parse_life_test("Mrev,rig,status\n10,A,f\n10,A,s\n12,B,s\n12,B,s\n")
    assert by_label.scheme == "multiple"
    assert list(by_label.rig) == ["A", "A", "B", "B"]


def test_another_column_for_the_groups() -> None:
    text = "time,condition,procedure\n5,hot,one\n6,cold,one\n"
    assert list(parse_life_test(text).group) == ["hot", "cold"]
    assert list(parse_life_test(text, group="Procedure").group) == ["one", "one"]
    with pytest.raises(InputError, match="oil: is not a column"):
        parse_life_test(text, group="oil")


def test_the_unit_of_the_caller_wins() -> None:
    text = "# unit: Mrev\ntime [cycles]\n5\n"
    assert parse_life_test(text).unit == "Mrev"
    assert parse_life_test(text, unit="rev").unit == "rev"
    assert parse_life_test("time [cycles]\n5\n").unit == "cycles"


@pytest.mark.parametrize(
    ("kind", "message", "text"),
    [
        (FileError, "no table", ""),
        (FileError, "no table", "# only this\n;;;\n"),
        (FileError, "no rows", "time\n"),
        (InputError, "line 1: header.*no column of times", "status\nfailed\n"),
        (UnknownKeyError, "line 1: statsu: .*did you mean status", "time,statsu\n1,f\n"),
        (InputError, "line 1: hours: occurs twice", "time,hours\n1,1\n"),
        (InputError, "two columns", "time,status,failed\n1,f,1\n"),
        (InputError, "has rig sizes besides counts or inspections", "time,size,count\n1,2,2\n"),
        (FileError, "line 3: has 1 cell .*semicolons", "time,status\n1,f\n2\n"),
        (FileError, "line 2: has 3 cells", "time,status\n1,2,f\n"),
        (InputError, r'line 2: time = "1.23,5": must be a number', "time;status\n1.23,5;f\n"),
        (InputError, "decimal point", 'time,status\n"1,5",f\n'),
        (InputError, "line 2: time.*120.5", "time\nnan\n"),
        (InputError, "must be positive", "time\n-3\n"),
        (InputError, "must be positive", "time\n1e99\n"),
        (InputError, "must be a number", "time\n" + "1" * 50 + "\n"),
        (InputError, 'line 2: status = "maybe".*failed, suspended', "time,status\n1,maybe\n"),
        (InputError, "count.*integer from 1", "time,count\n1,0\n"),
        (InputError, "count.*integer", "time,count\n1,2.5\n"),
        (InputError, "lower.*below the time", "time,lower\n1,2\n"),
        (InputError, "lower.*must be empty", "time,lower,status\n2,1,s\n"),
        (InputError, "group.*one line", "time,group\n1," + "x" * 80 + "\n"),
        (FileError, "is not a line of a CSV table; check for an unmatched", 'time\n"1\n'),
        (FileError, "longer than", "time\n" + " " * 6000 + "1\n"),
        (FileError, "more than 1000 columns", ",".join(["n"] * 1200)),
        (InputError, "rig.*several times", "time,rig\n1,A\n2,A\n"),
    ],
)
def test_what_is_no_life_test(kind: type[InputError], message: str, text: str) -> None:
    with pytest.raises(kind, match=message):
        parse_life_test(text, "test.csv")


def test_too_many_rows() -> None:
    with pytest.raises(FileError, match="more than 100 000 rows"):
        parse_life_test("time\n" + "1\n" * 100_001)


def test_reading_files(tmp_path: Path) -> None:
    path = tmp_path / "test.csv"
    path.write_bytes("hours;condição\n120,5;úmida\n".encode("cp1252"))
    test = read_life_test(path)
    assert list(test.group) == ["úmida"]
    assert test.source == str(path)
    for content, message in (
        (b"\xff\xfet\x00\n", "damaged UTF-16"),
        (b"time\n\x00", "binary"),
        (b"time\n" + b"1\n" * 2_600_000, "larger than 5 MB"),
    ):
        path.write_bytes(content)
        with pytest.raises(FileError, match=message):
            read_life_test(path)
    for wrong, message in (
        (tmp_path, "directory"),
        (tmp_path / "none.csv", "cannot be opened: no such file"),
        ("\0", "is not a valid file name"),
        ("/dev/null", "not a regular file"),
    ):
        with pytest.raises(FileError, match=message):
            read_life_test(wrong)


def test_published_tests_can_be_read_again(tmp_path: Path) -> None:
    path = tmp_path / "again.csv"
    path.write_text(published_text("campanha_2008"), encoding="utf-8")
    test, again = published_life_test("campanha_2008"), read_life_test(path)
    assert np.array_equal(test.times, again.times)
    assert (test.size, test.failures) == (24, 6)
    assert "Universidade de São Paulo" in test.source
    with pytest.raises(InputError, match="lieblein_zelen_1956"):
        published_life_test("nobody")
    # a shape that bearings have
    assert 1.0 < maximum_likelihood(published_life_test("lieblein_zelen_1956")).shape < 3.0
