"""A table reads to the same numbers however it is written, or is refused: never to others."""

from __future__ import annotations

import csv
import io
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Final

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rolamento.errors import InputError
from rolamento.io.tables import decoded
from rolamento.vibration.reading import open_signal
from rolamento.weibull import parse_life_test, parse_trend

SEPARATORS: Final = (";", "\t", "|", ",", " ")
BRACKETS: Final = (" ({})", "({})", " [{}]", "[{}]", " below", "_{}", "")
ENCODINGS: Final = ("utf-8", "utf-8-sig", "utf-16", "utf-16-le", "cp1252")
TIMES: Final = ("time", "Failure Time", "vida", "Lebensdauer", "tiempo", "T")
STATES: Final = ("status", "E", "event_observed", "failed", "estado", "delta")


@dataclass(frozen=True)
class Manner:
    """How a table is written."""

    separator: str
    comma: bool
    thousands: bool
    bracket: str
    encoding: str
    says_separator: bool
    title: str
    upper: bool
    quoted: bool
    ends: str

    def number(self, value: float) -> str:
        text = f"{value:,.3f}" if self.thousands else f"{value:.3f}"
        if self.comma:
            text = text.translate(str.maketrans(".,", ",."))
        return text

    def write(self, names: list[str], units: list[str], rows: list[list[str]]) -> bytes:
        heads, below = [], []
        for name, unit in zip(names, units, strict=True):
            head = name.upper() if self.upper else name
            if self.separator == " ":
                head = head.replace(" ", "_")
            if unit and self.bracket == " below":
                below.append(unit)
            else:
                below.append("")
                head += self.bracket.format(unit) if unit else ""
            if self.separator == " ":
                head = head.replace(" ", "")
            heads.append(head)
        text = io.StringIO(newline="")
        if self.says_separator:
            text.write(f"sep={self.separator}{self.ends}")
        if self.title:
            text.write(f"{self.title}{self.ends}{self.ends}")
        quoting = csv.QUOTE_ALL if self.quoted else csv.QUOTE_MINIMAL
        writer = csv.writer(
            text, delimiter=self.separator, lineterminator=self.ends, quoting=quoting
        )
        if self.separator == " ":  # blanks part cells, however many
            units = [below] if all(below) else []  # a cell of nothing is none
            for row in (heads, *units, *rows):
                text.write("  ".join(row) + self.ends)
        else:
            writer.writerow(heads)
            if any(below):
                writer.writerow(below)
            writer.writerows(rows)
        return text.getvalue().encode(self.encoding, "replace")


manners = st.builds(
    Manner,
    separator=st.sampled_from(SEPARATORS),
    comma=st.booleans(),
    thousands=st.booleans(),
    bracket=st.sampled_from(BRACKETS),
    encoding=st.sampled_from(ENCODINGS),
    says_separator=st.booleans(),
    title=st.sampled_from(("", "Ensaio de vida; bancada 3", "Lives, rig 3", "Test 2024")),
    upper=st.booleans(),
    quoted=st.booleans(),
    ends=st.sampled_from(("\n", "\r\n")),
)
numbers = st.lists(
    st.one_of(
        st.integers(1, 99_999_999).map(lambda n: n / 1000.0),
        st.integers(1, 99_999).map(float),
        st.sampled_from((12.5, 12.345, 1.0, 1500.0, 12_500.0, 0.125)),
    ),
    min_size=2,
    max_size=6,
)


@given(manner=manners, times=numbers, data=st.data())
def test_lives(manner: Manner, times: list[float], data: st.DataObject) -> None:
    """Of any separator, decimal mark, bracket, encoding and order of columns."""
    failed = [True, *data.draw(st.lists(st.booleans(), min_size=len(times), max_size=len(times)))]
    failed = failed[: len(times)]
    columns = {
        data.draw(st.sampled_from(TIMES)): ("h", [manner.number(time) for time in times]),
        data.draw(st.sampled_from(STATES)): ("", [str(int(state)) for state in failed]),
        "lot": ("", ["A"] * len(times)),
    }
    order = data.draw(st.permutations(list(columns)))
    rows = [list(row) for row in zip(*(columns[name][1] for name in order), strict=True)]
    text = manner.write(list(order), [columns[name][0] for name in order], rows)
    try:
        test = parse_life_test(decoded(text, "t"), "t")
    except InputError:
        return
    assert test.times == pytest.approx(np.round(times, 3), rel=1e-12)
    assert list(test.failed) == failed
    assert test.unit == "h"


@given(manner=manners, values=numbers, day_first=st.booleans(), data=st.data())
def test_trends(manner: Manner, values: list[float], day_first: bool, data: st.DataObject) -> None:
    """Dates with times of day, in one column or two, in either order of day and month."""
    days = data.draw(
        st.lists(
            st.datetimes(
                min_value=datetime(2020, 1, 1),
                max_value=datetime(2029, 1, 1),
                allow_imaginary=False,
            ).map(lambda moment: moment.replace(microsecond=0)),
            min_size=len(values),
            max_size=len(values),
        )
    )
    form = data.draw(st.sampled_from(("%Y-%m-%d", "%d.%m.%Y", "%d/%m/%Y", "%m/%d/%Y")))
    apart = data.draw(st.booleans())
    stamps = [[moment.strftime(form), moment.strftime("%H:%M:%S")] for moment in days]
    rows = [
        [*(stamp if apart else [" ".join(stamp)]), manner.number(value)]
        for stamp, value in zip(stamps, values, strict=True)
    ]
    names = ["date", "time", "velocity"] if apart else ["timestamp", "velocity"]
    text = manner.write(names, ["", "", "mm/s"] if apart else ["", "mm/s"], rows)
    order = {"%d/%m/%Y": "day_first", "%m/%d/%Y": "month_first"}.get(form)
    try:
        trend = parse_trend(
            decoded(text, "t"), "t", date_order=order, values=() if manner.bracket else ["velocity"]
        )
    except InputError:
        return
    first = min(days)
    expected = [(moment - first).total_seconds() / 86_400.0 for moment in days]
    assert trend.times == pytest.approx(expected, abs=1e-9)
    assert trend.values[:, 0] == pytest.approx(np.round(values, 3), rel=1e-12)


@pytest.mark.parametrize("encoding", ENCODINGS)
@pytest.mark.parametrize("bracket", BRACKETS)
@pytest.mark.parametrize("comma", [False, True])
@pytest.mark.parametrize("separator", SEPARATORS)
def test_what_is_clear_is_read(separator: str, comma: bool, bracket: str, encoding: str) -> None:
    """Not all is refused: what nobody could read in two ways is read."""
    if comma and separator == ",":
        return
    manner = Manner(separator, comma, False, bracket, encoding, False, "", False, False, "\n")
    rows = [[manner.number(12.25), "1"], [manner.number(1500.5), "0"], [manner.number(0.125), "1"]]
    if bracket == " below" and separator == " ":
        return
    test = parse_life_test(decoded(manner.write(["time", "status"], ["h", ""], rows), "t"), "t")
    assert test.times.tolist() == [12.25, 1500.5, 0.125]
    assert test.failures == 2


@given(manner=manners, scale=st.sampled_from((1.0, 1e3, 1e6)))
def test_signals(tmp_path_factory: pytest.TempPathFactory, manner: Manner, scale: float) -> None:
    """A record of ten samples, its times in s, ms or µs."""
    samples = np.round(np.sin(np.arange(1.0, 11.0)), 3)
    unit = {1.0: "s", 1e3: "ms", 1e6: "µs"}[scale]
    rows = [
        [manner.number(scale * 0.004 * i), manner.number(x)] for i, x in enumerate(samples.tolist())
    ]
    path: Path = tmp_path_factory.mktemp("signals") / "a"
    path.write_bytes(manner.write(["time", "acc"], [unit, "g"], rows))
    try:
        with open_signal(path, channel=None) as source:
            rate, found = source.rate, source.read().samples
            of_unit = source.channel.unit
    except InputError:
        return
    if manner.bracket in ("", "_{}"):  # a name that holds no unit: what is not calibrated
        found = found / (9.80665 if of_unit == "g" else 1.0)
    else:
        assert of_unit == "g"
        found = found / 9.80665
    assert found == pytest.approx(samples, abs=1e-9)
    if manner.bracket:
        assert rate == pytest.approx(250.0, rel=1e-6)
