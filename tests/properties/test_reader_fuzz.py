"""Whatever is read is a valid case or one message of the `InputError` family, soon."""

from __future__ import annotations

import json
import time
from pathlib import Path
from typing import Any

from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

import rolamento
from rolamento.case import Case, case_to_json, load_case, override, parse_case
from rolamento.errors import InputError

EXAMPLES = sorted((Path(rolamento.__file__).parent / "examples").glob("*.toml"))
TEXTS = [file.read_text(encoding="utf-8") for file in EXAMPLES]
TEXTS += [case_to_json(load_case(file)) for file in EXAMPLES]
WORDS = [
    *("bearing", "duty", "model", "load", "displacement", "title", "fx", "ry", "ball_count"),
    *("ball_diameter", "ring_material", "ball_material", "contact_angle", "density", "x.y"),
]
SPLINTERS = [
    *("[", "]", "{", "}", '"', "'", "=", ",", ".", "\n", "#", "[[", '"""', "\\", "\\u", "\0"),
    *("nan", "inf", "1e999", "-", "9" * 5000, "true", "1979-05-27", "0x", "[bearing]", "é"),
    *("\ud7ff", "\u2028", "NaN", ":", "null", " mm", "**9999", "a." * 200, "[" * 2000),
]

scalars = (
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.text(max_size=20)
    | st.sampled_from(["22.23 mm", "40 deg", "10 kN", "10 000 rpm", "1e400 N", "100Cr6", "5,3 mm"])
)
tables = st.recursive(
    scalars,
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(st.sampled_from(WORDS) | st.text(max_size=8), inner, max_size=5)
    ),
    max_leaves=20,
)


def check(text: str, **arguments: Any) -> None:
    """Read a text; nothing may come out but a case or a short message."""
    start = time.monotonic()
    try:
        case = parse_case(text, **arguments)
    except InputError as error:
        assert str(error).isprintable()
        assert len(str(error)) < 1000
    else:
        assert isinstance(case, Case)
    assert time.monotonic() - start < 5.0


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(content=st.binary(max_size=300), suffix=st.sampled_from([".toml", ".json", ""]))
@example(content=b"\xff\xfe\0", suffix="")
def test_any_bytes(tmp_path: Path, content: bytes, suffix: str) -> None:
    file = tmp_path / f"case{suffix}"
    file.write_bytes(content)
    try:
        load_case(file)
    except InputError as error:
        assert str(error).isprintable()


@given(st.text(max_size=300), st.sampled_from(["toml", "json", None]))
def test_any_text(text: str, text_format: str | None) -> None:
    check(text, format=text_format)


@given(
    text=st.sampled_from(TEXTS),
    cut=st.tuples(st.floats(0, 1), st.floats(0, 0.1)),
    splinter=st.sampled_from(SPLINTERS) | st.text(max_size=10),
)
@settings(max_examples=500)
def test_a_valid_file_with_a_piece_replaced(
    text: str, cut: tuple[float, float], splinter: str
) -> None:
    start = int(cut[0] * len(text))
    end = start + int(cut[1] * len(text))
    check(text[:start] + splinter + text[end:])


@given(
    text=st.sampled_from(TEXTS), old=st.integers(0, 60), value=st.sampled_from(SPLINTERS) | scalars
)
@settings(max_examples=300)
def test_a_valid_file_with_a_line_replaced(text: str, old: int, value: object) -> None:
    lines = text.split("\n")
    key, separator, _ = lines[old % len(lines)].partition("=")
    lines[old % len(lines)] = f"{key}{separator}{value}"
    check("\n".join(lines))


@given(tables)
@settings(max_examples=300)
def test_any_json_value(value: object) -> None:
    check(json.dumps(value), format="json")


@given(st.dictionaries(st.sampled_from(["bearing", "duty", "model", "title"]), tables, max_size=4))
@settings(max_examples=300)
def test_any_value_under_the_known_tables(value: dict[str, object]) -> None:
    check(json.dumps(value), format="json")


@given(st.integers(1, 90), st.integers(0, 400), st.sampled_from(["[1]", "{a = 1}", "[[[]]]"]))
def test_nested_tables(dots: int, depth: int, value: str) -> None:
    header = "[" + ".".join(["a"] * dots) + "]\n"
    check(f"{header}{'a.' * min(dots, 90)}b = {'{a = ' * depth}{value}{'}' * depth}\n")
    check(f"bearing.{'a.' * dots}b = {value}", overrides=["bearing.ball_count=3"])


@given(
    st.lists(
        st.text(max_size=40)
        | st.tuples(st.lists(st.sampled_from(WORDS), min_size=1, max_size=4), scalars).map(
            lambda pair: f"{'.'.join(pair[0])}={pair[1]}"
        ),
        max_size=3,
    )
)
@settings(max_examples=300)
def test_any_settings(given_settings: list[str]) -> None:
    case = load_case(EXAMPLES[0])
    try:
        override(case, given_settings)
    except InputError as error:
        assert str(error).isprintable()
