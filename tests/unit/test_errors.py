from __future__ import annotations

import copy
import inspect
import pickle

import pytest

from rolamento import errors
from rolamento.errors import FileError, InputError, RolamentoError, UnitError, nearest, shown


def test_one_message_names_place_field_value_rule_and_example() -> None:
    error = InputError(
        "must be at least 3",
        field="bearing.ball_count",
        value=2,
        example="ball_count = 16",
        source="case.toml",
        line=8,
    )
    assert str(error) == (
        "case.toml, line 8: bearing.ball_count = 2: must be at least 3 (example: ball_count = 16)"
    )


def test_what_is_not_known_is_left_out() -> None:
    assert str(InputError("is wrong")) == "is wrong"
    assert str(InputError("is wrong", value="x")) == '"x": is wrong'
    assert str(FileError("is empty", source="case.toml")) == "case.toml: is empty"
    assert str(InputError("is wrong", value=None)) == "None: is wrong"


def test_details_are_filled_in_on_a_copy() -> None:
    error = UnitError("needs a unit", value="5")
    located = error.with_details(field="bearing.ball_diameter", source="a.toml", line=3)
    assert isinstance(located, UnitError)
    assert str(located) == 'a.toml, line 3: bearing.ball_diameter = "5": needs a unit'
    assert str(error) == '"5": needs a unit'


def test_errors_cross_processes() -> None:
    for error in (InputError("is wrong", field="x", line=3), FileError("is empty", value=2)):
        assert str(pickle.loads(pickle.dumps(error))) == str(error)
        assert str(copy.deepcopy(error)) == str(error)


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ("a\nb\x1b[31m\u202e", '"a\\nb\\x1b[31m\\u202e"'),
        ("\ud800", '"\\ud800"'),
        ("x" * 1000, '"' + "x" * 59 + '…"'),
        (True, "true"),
        pytest.param(10**5000, "a very long integer", id="long"),
        ({"a": 1}, "a table"),
        ([1], "a list"),
        (1.5, "1.5"),
    ],
)
def test_values_are_shown_short_and_printable(value: object, text: str) -> None:
    assert shown(value) == text


def test_field_and_source_are_shown_short_and_printable() -> None:
    message = str(InputError("is wrong", field="a\n" * 10**6, source="b\x07" * 10**6))
    assert message.isprintable()
    assert len(message) < 1500


def test_the_nearest_word() -> None:
    assert nearest("Ball_Diametre", ["ball_count", "ball_diameter"]) == "ball_diameter"
    assert nearest("q", ["ball_count"]) == ""
    assert nearest("x" * 10**6, ["ball_count"]) == ""


def test_the_tree_in_the_docstring_is_the_tree_in_the_code() -> None:
    classes = [
        item
        for _, item in inspect.getmembers(errors, inspect.isclass)
        if issubclass(item, Exception)
    ]
    assert all(issubclass(item, RolamentoError) for item in classes)
    assert errors.__doc__ is not None
    for item in classes:
        assert item.__name__ in errors.__doc__
    assert issubclass(InputError, ValueError)
