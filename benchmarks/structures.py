"""Mutate what people write by its structure, and read it in this process: of `benchmarks.faults`.

Bytes that are wrong are mostly refused by the parser of TOML or JSON. Here what comes out of the
parser is wrong: fields that nobody knows, missing, of another kind, in each other's place, at the
limits of numbers, lists for scalars; and cells and columns of tables likewise. Samples are the
shipped examples and what the documentation prints. What is read is also written, read again and,
now and then, solved. Anything but an `InputError` of one short printable line is a bad end: another
exception, a warning, more than `BOUND` seconds of processor time.
"""

from __future__ import annotations

import copy
import json
import random
import re
import signal
import tomllib
import traceback
import warnings
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Final

import tomli_w

import rolamento
from rolamento import RolamentoError, Solved, case_to_json, case_to_toml, parse_case, solve
from rolamento.case import override
from rolamento.case.variant import read_variant
from rolamento.catalogue.records import records_of_csv, records_of_toml
from rolamento.studies import parse_study, study_to_toml
from rolamento.studies import run as run_study
from rolamento.studies.scatter import Sampler
from rolamento.tasks import read_machine, read_spectrum
from rolamento.weibull.fleet_table import parse_fleet
from rolamento.weibull.reading import parse_life_test
from rolamento.weibull.trend import parse_trend

EXAMPLES: Final = Path(rolamento.__file__).parent / "examples"
DOCS: Final = Path(__file__).parents[1] / "docs"
BOUND: Final = 5.0
"""Seconds of processor time that one text may take."""
_LONGEST_MESSAGE: Final = 1500
_SOLVED: Final = 25
"""Of so many texts one is solved too, if it has few rolling elements."""
_MOST_ELEMENTS: Final = 60
_MOST_SOLVED: Final = 100
"""Cases of a study."""
_HIDDEN: Final = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\ud800-\udfff]")

NUMBERS: Final[tuple[Any, ...]] = (
    *(0, -1, 1, 2, 3, 0.0, -0.0, 0.5, -0.5, 1e-320, 1e-30, 1e-9, 1e6, 1e30, 1e150, 1e300, 1e308),
    *(-1e308, float("nan"), float("inf"), float("-inf"), 2**31, 2**53 + 1, 2**63 - 1, -(2**63)),
    *(10**30, 10**400, -(10**400), True, False),
)
TEXTS: Final = (
    *("", " ", "x", "nan", "inf", "-inf", "true", "null", "None", "0", "-1", "1e400", "1e-400"),
    *("١٢ mm", "½ mm", "1,5 mm", "1.234,5 mm", "12 mm 12 mm", "mm", "1e308 km", "-1e308 km"),
    *("1/0 mm", "2**99999 mm", "__import__('os')", "{x}", "%s", "\x1b]0;x\x07", "\u202etxet"),
    *("é" * 50, "9" * 5000, "a" * 100_000, "a.b", "../../etc/passwd", "CON", "\ud7ff", "\n", "\t"),
    *("case.toml", "6310/C3", "1979-05-27", "0x10", "fx", "steel", "🦓"),
)
UNITS: Final = (
    *("m", "mm", "km", "µm", "in", "N", "kN", "lbf", "N·m", "rpm", "rad/s", "Hz", "deg", "rad"),
    *("K", "degC", "degF", "Pa", "GPa", "mm²/s", "cSt", "kg", "kg/m³", "h", "s", "%", "W", "1/K"),
    *("m^9", "N/N", "furlong", "(m", "m**", "m/0", "m*m*m*m", "", "1"),
)
_QUANTITY: Final = re.compile(r"\s*([-+0-9.,e]+)\s*(\D.*)?")


class Late(BaseException):
    """A text takes longer than it may; no reader catches that."""


@dataclass(frozen=True, slots=True)
class Kind:
    """A kind of text: samples, what changes them, what reads them.

    `read` gets a text and whether to go beyond reading.
    """

    name: str
    samples: Sequence[Any]
    mutated: Callable[[Sequence[Any], random.Random], str]
    read: Callable[[str, bool], object]


@dataclass(slots=True)
class Found:
    """What came of the texts of one kind; bad: by what and where it was, an example each."""

    name: str
    outcomes: Counter[str] = field(default_factory=Counter)
    bad: dict[str, str] = field(default_factory=dict)
    count_of_bad: Counter[str] = field(default_factory=Counter)
    longest: float = 0.0


KINDS: Final = (
    *("cases", "studies", "machines", "own catalogues, TOML", "solved states"),
    *("settings and variants", "life tests", "fleets", "trends", "own catalogues, CSV", "spectra"),
)


def run(count: int, seed: int, only: Sequence[str] = ()) -> Iterator[Found]:
    """Read `count` texts of each kind."""
    with TemporaryDirectory() as folder:
        for kind in kinds(Path(folder)):
            if only and kind.name not in only:
                continue
            rng = random.Random(f"{seed} {kind.name}")
            yield take(kind, (kind.mutated(kind.samples, rng) for _ in range(count)))


def take(kind: Kind, texts: Iterable[str]) -> Found:
    """Read texts of a kind."""
    found = Found(kind.name)
    for number, text in enumerate(texts):
        _take(found, kind, text, number % _SOLVED == 0)
    return found


def _take(found: Found, kind: Kind, text: str, further: bool) -> None:
    """Read one text, and count how that ended."""
    with _bounded() as spent:
        outcome, wrong = _ended(lambda: kind.read(text, further))
    found.longest = max(found.longest, spent())
    found.outcomes["bad" if wrong else outcome] += 1
    if wrong:
        found.count_of_bad[wrong] += 1
        if len(text) < len(found.bad.get(wrong, text + " ")):
            found.bad[wrong] = text


def _ended(read: Callable[[], object]) -> tuple[str, str]:
    """Outcome, and what is wrong with it."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            read()
    except RolamentoError as error:
        said = str(error)
        if len(said) > _LONGEST_MESSAGE or _HIDDEN.search(said):
            return "", f"message: {type(error).__name__}: {said[:80]!r} ({len(said)} characters)"
        return "refused", ""
    except (Exception, Late) as error:
        return "", f"{type(error).__name__} at {_place_of(error)}: {str(error)[:80]}"
    return "read", ""


def _place_of(error: BaseException) -> str:
    """The innermost line of the project."""
    frames = traceback.extract_tb(error.__traceback__)
    own = [one for one in frames if "rolamento" in Path(one.filename).parts] or frames
    return f"{Path(own[-1].filename).name}:{own[-1].lineno}"


@contextmanager
def _bounded() -> Iterator[Callable[[], float]]:
    """Raise `Late` in the body after `BOUND` seconds of processor time; yields what was spent."""

    def late(*_: object) -> None:
        raise Late(f"more than {BOUND:.6g} s")

    before = signal.signal(signal.SIGVTALRM, late)
    signal.setitimer(signal.ITIMER_VIRTUAL, BOUND)
    rest = BOUND
    try:
        yield lambda: BOUND - rest
    finally:
        rest = signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)[0]
        signal.signal(signal.SIGVTALRM, before)


# --- trees: TOML and JSON -------------------------------------------------------------------

Place = tuple[Any, Any]
"""A table or list, and the key or index of what stands there."""


def places(tree: Any) -> list[Place]:
    """All places of a tree."""
    keys = tree.keys() if isinstance(tree, dict) else range(len(tree))
    here: list[Place] = [(tree, key) for key in keys]
    return here + [
        place for _, key in tuple(here) if isinstance(tree[key], dict | list)
        for place in places(tree[key])
    ]  # fmt: skip


def mutated_tree(samples: Sequence[Any], rng: random.Random) -> str:
    """A sample with one to four changes, as TOML or as JSON."""
    tree = copy.deepcopy(rng.choice(samples))
    for _ in range(rng.choice((1, 1, 1, 2, 2, 3, 4))):
        found = places(tree)
        if found:
            rng.choice(CHANGES)(tree, found, samples, rng)
    return _written(tree, rng)


def _written(tree: Any, rng: random.Random) -> str:
    if rng.random() < 0.5:
        try:
            return _repeated(tomli_w.dumps(tree), rng)
        except (TypeError, ValueError, AttributeError):  # null, or a number that TOML has not
            pass
    return json.dumps(tree, ensure_ascii=rng.random() < 0.5)


def _repeated(text: str, rng: random.Random) -> str:
    """A line of some again, now and then: keys and tables that are there twice."""
    lines = text.splitlines()
    if lines and rng.random() < 0.08:
        lines.insert(rng.randrange(len(lines) + 1), rng.choice(lines))
    return "\n".join(lines) + "\n"


def hostile(rng: random.Random) -> Any:
    """A value that is probably none of those that are expected."""
    kind = rng.random()
    if kind < 0.4:
        return rng.choice(NUMBERS)
    if kind < 0.75:
        return rng.choice(TEXTS)
    if kind < 0.85:
        return f"{rng.choice(NUMBERS[:22])} {rng.choice(UNITS)}"
    return rng.choice((
        [], {}, [[]], [{}], {"": {}}, {"a": 1}, [1, 2, 3], ["1 mm"], [1, "1 mm"], [None], None,
        [1.0] * 2000, ["x"] * 300, {f"k{n}": n for n in range(300)}, _nested(rng),
    ))  # fmt: skip


def _nested(rng: random.Random) -> Any:
    inner: Any = 1
    is_table = rng.random() < 0.5
    for _ in range(rng.choice((3, 30, 200))):
        inner = {"a": inner} if is_table else [inner]
    return inner


def _unknown(tree: Any, found: list[Place], samples: Sequence[Any], rng: random.Random) -> None:
    tables = [tree, *(box[key] for box, key in found if isinstance(box[key], dict))]
    name = rng.choice((rng.choice(TEXTS[:20]), rng.choice(keys_of(samples)), "unknown", "a.b.c"))
    value = rng.choice((hostile(rng), _value(*rng.choice(found)), 1))
    chosen = rng.choice(tables)
    at = rng.randrange(len(chosen) + 1)
    items = [(key, one) for key, one in chosen.items() if key != name]
    items.insert(at, (name, copy.deepcopy(value)))
    chosen.clear()
    chosen.update(items)


def _renamed(tree: Any, found: list[Place], samples: Sequence[Any], rng: random.Random) -> None:
    tables = [(box, key) for box, key in found if isinstance(box, dict)]
    if not tables:
        return
    box, key = rng.choice(tables)
    wrong = (
        key[:-1],
        key + "s",
        key.upper(),
        key + ".x",
        rng.choice(keys_of(samples)),
        "",
        "é" + key,
    )
    items = [(rng.choice(wrong) if one == key else one, value) for one, value in box.items()]
    box.clear()
    box.update(items)


def _beside(tree: Any, found: list[Place], samples: Sequence[Any], rng: random.Random) -> None:
    """What stands in a table once more under another name, known or not."""
    box, key = rng.choice([place for place in found if isinstance(place[0], dict)] or [({}, "")])
    if key in box:
        name = rng.choice((key + "s", key[:-1], rng.choice(keys_of(samples)), "duty.load.fy"))
        box.setdefault(name, copy.deepcopy(box[key]))


def _misspelt(tree: Any, found: list[Place], samples: Sequence[Any], rng: random.Random) -> None:
    texts = [(box, key) for box, key in found if isinstance(box[key], str) and box[key]]
    if texts:
        box, key = rng.choice(texts)
        value, at = box[key], rng.randrange(len(box[key]))
        box[key] = (
            value[:at] + rng.choice(("", "x", ".", " ", "_", value[at] * 2)) + value[at + 1 :]
        )


def _dropped(tree: Any, found: list[Place], samples: Sequence[Any], rng: random.Random) -> None:
    box, key = rng.choice(found)
    del box[key]


def _replaced(tree: Any, found: list[Place], samples: Sequence[Any], rng: random.Random) -> None:
    box, key = rng.choice(found)
    box[key] = hostile(rng)


def _swapped(tree: Any, found: list[Place], samples: Sequence[Any], rng: random.Random) -> None:
    (box, key), (other, its) = rng.choice(found), rng.choice(found)
    first, second = copy.deepcopy(box[key]), copy.deepcopy(other[its])
    box[key] = second
    if _value(other, its) is not None:  # it may have been inside what has gone
        other[its] = first


def _grafted(tree: Any, found: list[Place], samples: Sequence[Any], rng: random.Random) -> None:
    others = places(rng.choice(samples))
    box, key = rng.choice(found)
    there, its = rng.choice(others)
    if isinstance(box, dict) and isinstance(there, dict) and rng.random() < 0.5:
        key = its
    box[key] = copy.deepcopy(there[its])


def _wrapped(tree: Any, found: list[Place], samples: Sequence[Any], rng: random.Random) -> None:
    box, key = rng.choice(found)
    value = box[key]
    forms = [value], [value, value], {"value": value}, {str(key): value}, [[value]], str(value)
    box[key] = copy.deepcopy(rng.choice(forms))


def _unwrapped(tree: Any, found: list[Place], samples: Sequence[Any], rng: random.Random) -> None:
    filled = [(box, key) for box, key in found if isinstance(box[key], dict | list) and box[key]]
    if filled:
        box, key = rng.choice(filled)
        value = box[key]
        inner = list(value.values()) if isinstance(value, dict) else value
        box[key] = rng.choice((rng.choice(inner), list(inner), type(value)()))


def _lengthened(tree: Any, found: list[Place], samples: Sequence[Any], rng: random.Random) -> None:
    lists = [box[key] for box, key in found if isinstance(box[key], list) and box[key]]
    if lists:
        chosen = rng.choice(lists)
        more = rng.choice((1, 1, 2, 30, 300))
        chosen += [copy.deepcopy(rng.choice(chosen)) for _ in range(more)]


def _measured(tree: Any, found: list[Place], samples: Sequence[Any], rng: random.Random) -> None:
    """Another number, or another unit, where a quantity stands."""
    texts = [
        (box, key) for box, key in found if isinstance(box[key], str) and box[key][:1].isdigit()
    ]
    if not texts:
        return
    box, key = rng.choice(texts)
    match = _QUANTITY.match(box[key])
    number, unit = (match[1], match[2] or "") if match else (box[key], "")
    if rng.random() < 0.5:
        unit = rng.choice(UNITS)
    else:
        number = str(rng.choice(NUMBERS[:28]))
    box[key] = f"{number} {unit}"


CHANGES: Final = (
    *(_unknown, _unknown, _renamed, _dropped, _replaced, _replaced, _replaced, _swapped, _grafted),
    *(
        _grafted,
        _wrapped,
        _unwrapped,
        _lengthened,
        _measured,
        _measured,
        _beside,
        _beside,
        _misspelt,
    ),
)


def _value(box: Any, key: Any) -> Any:
    try:
        return box[key]
    except (KeyError, IndexError):
        return None


def keys_of(samples: Sequence[Any]) -> tuple[str, ...]:
    """All keys of some samples."""
    return _keys_of(json.dumps(samples, default=str))


@cache
def _keys_of(text: str) -> tuple[str, ...]:
    found = {
        key for sample in json.loads(text) for _, key in places(sample) if isinstance(key, str)
    }
    return tuple(sorted(found)) or ("x",)


# --- tables: CSV ----------------------------------------------------------------------------

Rows = list[list[str]]


def mutated_table(samples: Sequence[str], rng: random.Random) -> str:
    """A table with one to four changes."""
    text = rng.choice(samples)
    separator = next((sign for sign in ("\t", ";") if sign in text), ",")
    rows = [line.split(separator) for line in text.splitlines()]
    for _ in range(rng.choice((1, 1, 2, 3, 4))):
        if rows:
            rng.choice(CHANGES_OF_TABLES)(rows, samples, rng)
    return "\n".join(separator.join(row) for row in rows) + "\n"


def _cell(rng: random.Random) -> str:
    value = hostile(rng)
    return str(value)[:3000] if not isinstance(value, list | dict) else "[]"


def _other_cell(rows: Rows, samples: Sequence[str], rng: random.Random) -> None:
    row = rng.choice(rows)
    if row:
        row[rng.randrange(len(row))] = _cell(rng)


def _other_heading(rows: Rows, samples: Sequence[str], rng: random.Random) -> None:
    head = next((row for row in rows if not row[:1] or not row[0].startswith("#")), rows[0])
    if head:
        words = re.findall(r"\w+", rng.choice(samples))
        at = rng.randrange(len(head))
        head[at] = rng.choice(
            (
                _cell(rng),
                rng.choice(words or ["x"]),
                f"{head[at]} ({rng.choice(UNITS)})",
                head[0],
                "",
            )
        )


def _no_column(rows: Rows, samples: Sequence[str], rng: random.Random) -> None:
    at = rng.randrange(max(map(len, rows)) or 1)
    for row in rows:
        del row[at : at + 1]


def _column_twice(rows: Rows, samples: Sequence[str], rng: random.Random) -> None:
    at = rng.randrange(max(map(len, rows)) or 1)
    for row in rows:
        row.extend(row[at : at + 1])


def _columns_swapped(rows: Rows, samples: Sequence[str], rng: random.Random) -> None:
    size = min(map(len, rows))
    if size > 1:
        i, j = rng.sample(range(size), 2)
        for row in rows if rng.random() < 0.5 else rows[:1]:
            row[i], row[j] = row[j], row[i]


def _column_alike(rows: Rows, samples: Sequence[str], rng: random.Random) -> None:
    """One value down a column."""
    value, at = _cell(rng), rng.randrange(max(map(len, rows)) or 1)
    for row in rows[1:]:
        row[at : at + 1] = [value]


def _row_changed(rows: Rows, samples: Sequence[str], rng: random.Random) -> None:
    at = rng.randrange(len(rows))
    change = rng.random()
    if change < 0.3:
        del rows[at]
    elif change < 0.6:
        rows.insert(at, list(rng.choice(rows)))
    elif change < 0.8:
        rows[at] = rows[at][: rng.randrange(len(rows[at]) + 1)] + [_cell(rng)] * rng.randrange(3)
    elif change < 0.9:
        del rows[at:]
    else:
        rows[at:at] = [list(rows[at])] * rng.choice((10, 300))


CHANGES_OF_TABLES: Final = (
    *(_other_cell, _other_cell, _other_cell, _other_heading, _other_heading, _no_column),
    *(_column_twice, _columns_swapped, _column_alike, _row_changed, _row_changed),
)


# --- settings: the texts of --set and --variant ------------------------------------------------


def mutated_setting(samples: Sequence[tuple[str, str]], rng: random.Random) -> str:
    """FIELD=VALUE, one of them or several."""
    parts = []
    for _ in range(rng.choice((1, 1, 2, 3))):
        name, value = rng.choice(samples)
        if rng.random() < 0.6:
            wrong = hostile(rng)
            value = wrong if isinstance(wrong, str) else _inline(wrong, rng)
        if rng.random() < 0.3:
            name = rng.choice((name[:-1], name + ".x", name.rpartition(".")[0], name.upper(), ""))
        parts.append(f"{name}{rng.choice(('=', '=', '=', '==', '', ' = ', ':'))}{value}")
    return rng.choice(("", "", "name:", ":", "a:b:")) + ",".join(parts)


def _inline(value: Any, rng: random.Random) -> str:
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key} = {_inline(one, rng)}" for key, one in value.items()) + "}"
    return "[" * 300 if rng.random() < 0.02 else str(value)


# --- what reads them ------------------------------------------------------------------------


def _read_case(text: str, further: bool) -> object:
    case = parse_case(text)
    again = parse_case(case_to_toml(case)), parse_case(case_to_json(case))
    if further and _is_cheap(case):
        solve(case).to_mapping()
    return again


def _is_cheap(case: Any) -> bool:
    bearing, arrangement = case.bearing, getattr(case, "arrangement", None)
    count = getattr(bearing, "ball_count", None) or getattr(bearing, "roller_count", None) or 0
    rows = len(getattr(arrangement, "rows", None) or ()) or 1
    is_slow = case.model.raceway_control == "friction"
    return 0 < count * rows <= _MOST_ELEMENTS and not is_slow and hasattr(bearing, "ball_count")


def _read_study(text: str, further: bool) -> object:
    study = parse_study(text, folder=EXAMPLES / "studies")
    again = parse_study(study_to_toml(study), folder=EXAMPLES / "studies")
    if study.scatter is not None:
        Sampler(study.scatter, study.seed).draw(0, 10)
    if further and study.cases <= _MOST_SOLVED and _is_cheap(study.case):
        run_study(study, threads=1)
    return again


def _read_state(text: str, further: bool) -> object:
    solved = Solved.from_json(text)
    return Solved.from_json(solved.to_json())


def _read_settings(text: str, further: bool) -> object:
    if further:
        return read_variant(text)
    return override(_case(), text.split(","))


@cache
def _case() -> rolamento.Case:
    return parse_case((EXAMPLES / "218_combined.toml").read_text("utf-8"))


# --- samples --------------------------------------------------------------------------------


@cache
def documented() -> tuple[Mapping[str, Any], ...]:
    """What the documentation prints as TOML and is whole."""
    found = []
    for page in sorted(DOCS.rglob("*.md")):
        for text in re.findall(r"^```toml\n(.*?)^```", page.read_text("utf-8"), re.M | re.S):
            try:
                found.append(tomllib.loads(text))
            except tomllib.TOMLDecodeError:  # with an ellipsis
                continue
    return tuple(found)


def _trees(*patterns: str) -> list[Mapping[str, Any]]:
    files = [file for pattern in patterns for file in sorted(EXAMPLES.glob(pattern))]
    return [tomllib.loads(file.read_text("utf-8")) for file in files]


MACHINE: Final = {
    "shafts": [{"name": "output", "ratio": 0.25}, {"name": "fan", "ratio": 2.0}],
    "bearings": [
        {"name": "motor, drive end", "designation": "6205"},
        {"designation": "6310", "shaft": "output"},
    ],
    "gears": [{"teeth": 31}, {"teeth": 17, "shaft": "output"}],
}
OWN_CATALOGUE: Final = {
    "maker": "Own",
    "bearing": [
        {"designation": "Z6205", "bore": "25 mm", "outside_diameter": "52 mm", "width": "15 mm"},
        {"designation": "Z7205", "bore": "25 mm", "outside_diameter": "52 mm",
         "contact_angle": "40 deg", "ball_count": 12, "ball_diameter": "7.9 mm"},
    ],
}  # fmt: skip
FLEET: Final = "name,age (h),status,count\nA,12000,running,1\nB,8000,failed,2\nC,100,running,30\n"
CATALOGUE: Final = (
    "designation,bore (mm),outside_diameter (mm),width (mm),ball_count\nZ6205,25,52,15,9\n"
)


def kinds(folder: Path) -> Iterator[Kind]:
    """All that is mutated; folder: for what is read from files."""
    pages = documented()
    cases = [*_trees("*.toml"), *(tree for tree in pages if "bearing" in tree and "duty" in tree)]
    yield Kind("cases", cases, mutated_tree, _read_case)
    studies = [
        *_trees("studies/*.toml"),
        *(tree for tree in pages if "case" in tree and _VARYING & tree.keys()),
    ]
    studies = [_smaller(tree) for tree in studies]
    whole = [{**tree, "case": cases[0]} for tree in studies]
    yield Kind("studies", [*studies, *whole], mutated_tree, _read_study)
    machines = [MACHINE, *(tree for tree in pages if "bearings" in tree)]
    yield Kind("machines", machines, mutated_tree, _through(folder / "m.toml", read_machine))
    catalogues = [OWN_CATALOGUE, *(t for t in pages if isinstance(t.get("bearing"), list))]
    own: Reader = lambda text: records_of_toml(text, "own.toml")  # noqa: E731
    yield Kind("own catalogues, TOML", catalogues, mutated_tree, _only(own))
    states = [json.loads(solve(parse_case(tomli_w.dumps(one))).to_json()) for one in cases[:2]]
    yield Kind("solved states", states, mutated_tree, _read_state)
    settings = [(name, str(one.example)) for name, one in rolamento.Case.fields().items()]
    yield Kind("settings and variants", settings, mutated_setting, _read_settings)
    tables = [file.read_text("utf-8")[:6000] for file in sorted(EXAMPLES.glob("*.csv"))]
    readers: Mapping[str, Reader] = {
        "life tests": parse_life_test,
        "fleets": parse_fleet,
        "trends": parse_trend,
        "own catalogues, CSV": lambda text: records_of_csv(text, "own.csv"),
    }
    for name, read in readers.items():
        taken = [text for text in (*tables, FLEET, CATALOGUE) if _is_read(read, text)]
        yield Kind(name, taken, mutated_table, _only(read))
    spectra = [(EXAMPLES / "6305_steps.csv").read_text("utf-8")]
    yield Kind("spectra", spectra, mutated_table, _through(folder / "s.csv", read_spectrum))


Reader = Callable[[str], object]
_VARYING: Final = {"axes", "scatter", "variants"}


def _is_read(read: Reader, text: str) -> bool:
    return _ended(lambda: read(text)) == ("read", "")


def _only(read: Reader) -> Callable[[str, bool], object]:
    """Of what there is nothing further to do with."""
    return lambda text, further: read(text)


def _through(path: Path, read: Callable[[Path], object]) -> Callable[[str, bool], object]:
    """Read from a file."""

    def through(text: str, further: bool) -> object:
        path.write_text(text, "utf-8", errors="replace")
        return read(path)

    return through


def _smaller(study: Mapping[str, Any]) -> dict[str, Any]:
    """A study with a few draws, so that it can be run."""
    scatter = study.get("scatter")
    return {**study, **({"scatter": {**scatter, "count": 5}} if scatter else {})}
