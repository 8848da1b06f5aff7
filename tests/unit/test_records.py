"""Records: frozen, and printed in at most ten lines."""

from __future__ import annotations

import copy
import inspect
import pickle
import runpy
from dataclasses import FrozenInstanceError, dataclass, field, fields, is_dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import rolamento as ro
from rolamento.records import Lazily, concise, frozen, span

OIL: dict[str, Any] = {"lubricant": "ISO VG 68", "temperature": "70 degC"}


@frozen
class Small:
    load: float
    name: str = "inner"


@frozen(eq=False)
class Large:
    """With all kinds of fields."""

    load: np.ndarray
    few: np.ndarray
    named: dict[str, float]
    inner: Small
    many: tuple[Small, ...]
    texts: tuple[str, ...]
    truth: np.ndarray
    missing: float | None = None
    hidden: float = field(default=1.0, repr=False)
    _private: int = 3


@frozen
class Wide:
    a: int = 1
    b: int = 2
    c: int = 3
    d: int = 4
    e: str = "x" * 100
    f: int = 6
    g: int = 7
    h: int = 8
    i: int = 9
    j: int = 10
    k: int = 11


def large() -> Large:
    return Large(
        np.linspace(1.0, 3.0, 12).reshape(3, 4), np.array([1.0, np.nan]), {"spin": 1.0, "rib": 2.0},
        Small(2.0), (Small(1.0),) * 9, ("a", "b"), np.ones(7, bool),
    )  # fmt: skip


def test_small_ones_are_printed_as_dataclasses_are() -> None:
    assert repr(Small(1.5)) == "Small(load=1.5, name='inner')"


def test_large_ones_have_a_line_a_field() -> None:
    assert repr(large()).splitlines() == [
        "Large",
        "  load: 1 to 3, shape (3, 4)",
        "  few: 1, nan",
        "  named: spin, rib",
        "  inner: Small(load=2, name=inner)",
        "  many: 9 of Small",
        "  texts: a, b",
        "  truth: array of shape (7,)",
    ]


def test_ten_lines_at_most() -> None:
    lines = repr(Wide()).splitlines()
    assert len(lines) == 10
    assert lines[-1] == "  and i, j, k"
    assert max(map(len, lines)) <= 96


def test_they_are_frozen_hashed_and_pickled() -> None:
    one = Small(1.0)
    with pytest.raises(FrozenInstanceError):
        one.load = 2.0  # type: ignore[misc]
    assert {one: 1}[Small(1.0)] == 1
    assert pickle.loads(pickle.dumps(one)) == one
    assert not hasattr(one, "__dict__")
    assert large() != large()


def _first(frozen: Any) -> Any:
    class First:
        """A class to be made a record."""

        load: float
        parts: list[int] = field(default_factory=lambda: [1])
        name: str = "inner"

    return frozen(First)


def _second(frozen: Any) -> Any:
    class Second(_first(frozen)):  # type: ignore[misc]
        """One that inherits, checks itself, and says what is equal."""

        angle: float = 0.0

        def __post_init__(self) -> None:
            if self.load < 0.0:
                raise ValueError("load")

        def __hash__(self) -> int:
            return 7

    return frozen(Second)


def _third(frozen: Any) -> Any:
    class Third:
        """One that is called by names."""

        load: float = 1.0
        name: str
        angle: float | None = field(default=None, compare=False)
        sources: dict[str, str] = field(default_factory=dict, hash=False)

    return frozen(Third, kw_only=True, slots=False)


def _plain(cls: type[Any], **options: bool) -> Any:
    return dataclass(frozen=True, repr=False, **{"slots": True, **options})(cls)


def _record(cls: type[Any], **options: bool) -> Any:
    return frozen(**options)(cls)


@pytest.mark.parametrize("made", [_first, _second, _third])
@pytest.mark.parametrize(
    ("places", "names"),
    [
        ((), {}), ((2.0,), {}), ((2.0, [3]), {"name": "outer"}), ((), {"name": "x"}),
        ((), {"name": "x", "load": 3.0}), ((1.0,), {"load": 1.0}), ((), {"other": 1}),
        ((-1.0,), {}), ((1.0, [2], "x", 0.5), {}), ((1.0, [2], "x", 0.5, 1), {}),
    ],
)  # fmt: skip
def test_they_are_made_as_dataclasses_are(made: Any, places: Any, names: Any) -> None:
    own, plain = made(_record), made(_plain)
    try:
        as_plain = plain(*places, **names)
    except (TypeError, ValueError) as error:
        with pytest.raises(type(error)):
            own(*places, **names)
        return
    one, other = own(*places, **names), own(*places, **names)
    values = {each.name: getattr(one, each.name) for each in fields(own)}
    assert values == {each.name: getattr(as_plain, each.name) for each in fields(plain)}
    assert one == other
    assert one != as_plain
    assert one == copy.copy(one) == copy.deepcopy(one) == replace(one)
    assert one != replace(one, name="another")
    for changes in ({"load": 9.0}, {"angle": 9.0}, {"sources": {"load": "print"}}):
        if changes.keys() <= values.keys():
            changed, as_changed = replace(one, **changes), replace(as_plain, **changes)
            assert (one == changed) == (as_plain == as_changed)
    assert hasattr(one, "__dict__") == hasattr(as_plain, "__dict__")
    assert own.__match_args__ == plain.__match_args__
    for record in (one, as_plain):
        with pytest.raises(FrozenInstanceError):
            record.name = "another"
        with pytest.raises(FrozenInstanceError):
            del record.name
    if made is _first:  # of a list
        with pytest.raises(TypeError):
            hash(one)
    else:
        assert (hash(one) == 7) == (hash(as_plain) == 7)
        assert hash(one) == hash(other)


@pytest.mark.parametrize("made", [_second, _third])
def test_their_signature_is_that_of_a_dataclass(made: Any) -> None:
    own, plain = (inspect.signature(made(frozen)) for frozen in (_record, _plain))
    assert str(own).replace("<made>", "<factory>") == str(plain)


@pytest.mark.parametrize(
    ("values", "text"),
    [
        ([1.0, 2.0], "1 to 2 N"), ([2.0, np.nan], "2 N"), ([], "nan N"), ([-0.0], "0 N"),
        ([123456.7], "123457 N"), ([1e12], "1e+12 N"), (np.array([[0.012345]]), "0.01235 N"),
        ([np.inf, 1.0], "1 N"),
    ],
)  # fmt: skip
def test_span(values: Any, text: str) -> None:
    assert span(values, "N") == text


def test_what_people_print_has_ten_lines() -> None:
    case = ro.load_case("6310/C3").with_(fz=5e3, inner_speed="1480 rpm", **OIL_FIELDS)
    analysis = ro.analyse(case)
    frequencies = ro.fault_frequencies(case)
    report = ro.report(case)
    fit = ro.fit_weibull([55.2, 81.0, 104.5])
    found = ro.diagnose(np.random.default_rng(0).normal(size=24_000), case, rate=12_000.0)
    summary = ro.tasks.life_test_study([55.2, 81.0, 104.5], samples=1000)
    roots = (analysis, frequencies, report, fit, found, summary, case, ro.find_bearings("6310")[0])
    printed = list(_records_in(roots, set()))
    assert len(printed) > 60
    for record in printed:
        text = repr(record)
        assert len(text.splitlines()) <= 10, text
        assert len(text) <= 1000, text


OIL_FIELDS: dict[str, Any] = {"lubricant": "ISO VG 68", "temperature__lubricant": "70 degC"}


def test_a_constructor_is_written_when_it_is_first_asked_for() -> None:
    @frozen
    class Made:
        load: float
        name: str = "inner"

    class Derived(Made):
        """Made by the constructor of another."""

    assert not inspect.isfunction(vars(Made)["__init__"])
    assert Derived(2.0).load == 2.0
    assert inspect.isfunction(vars(Made)["__init__"])
    assert "__init__" not in vars(Derived)
    assert str(inspect.signature(Made)) == "(load: 'float', name: 'str' = 'inner') -> None"


def _records_in(value: Any, seen: set[int]) -> Any:
    if id(value) in seen:
        return
    seen.add(id(value))
    if isinstance(value, tuple | list):
        for item in value:
            yield from _records_in(item, seen)
    elif isinstance(value, dict):
        yield from _records_in(list(value.values()), seen)
    elif is_dataclass(value) and not isinstance(value, type):
        yield value
        for one in fields(value):
            yield from _records_in(getattr(value, one.name), seen)
    elif type(value).__repr__ is concise:
        yield value


def test_an_analysis_says_what_a_person_asks_first() -> None:
    text = repr(ro.analyse("6310/C3", fz=5e3, inner_speed="1480 rpm", **OIL))
    for part in ("Analysis: 6310/C3", "converged", "fz 5000 N", "W", "h, "):
        assert part in text


def test_a_case_prints_what_was_given() -> None:
    case = ro.Case(bearing="6310/C3").with_(fz=5e3)
    assert repr(case) == (
        "Case(bearing=Bearing(designation='6310/C3'), duty=Duty(load=Load(fz=5000.0)))"
    )
    assert str(case) == repr(case)


def test_a_record_of_a_script_outlives_its_run(tmp_path: Path) -> None:
    script = tmp_path / "script.py"
    script.write_text(
        "from rolamento.records import frozen\n"
        "@frozen\nclass Pair:\n    first: int\n    second: int = 2\n"
    )
    pair = runpy.run_path(str(script), run_name="script")["Pair"]
    assert pair(1).second == 2


def test_what_is_looked_up_is_found_once_and_travels_whole() -> None:
    found: list[str] = []

    def find(name: str) -> int:
        found.append(name)
        return len(name)

    lazily = Lazily(("outer", "ring"), find)
    assert "ring" in lazily
    assert "race" not in lazily
    assert [*lazily] == ["outer", "ring"]
    assert len(lazily) == 2
    assert not found  # nobody has looked
    assert lazily["ring"] == lazily.get("ring") == 4
    assert found == ["ring"]
    with pytest.raises(KeyError):
        lazily["race"]
    assert pickle.loads(pickle.dumps(lazily)) == {"outer": 5, "ring": 4}
    assert found == ["ring", "outer"]
