"""Data of a command that are a file, or one of the examples that are shipped."""

from __future__ import annotations

from collections.abc import Sequence

from rolamento.cli.streams import STANDARD_STREAM
from rolamento.errors import InputError
from rolamento.words import said

__all__ = ["check_one_given", "data_and_json"]


def data_and_json(
    data: str | None, example: str | None, json: str | None
) -> tuple[str | None, str | None]:
    """Return which file is read and where JSON goes.

    The word after ``--json`` is taken for the data where it is the only one; beside an example,
    which needs no data, it is the file of the JSON.
    """
    if example is not None and json == STANDARD_STREAM and data is not None:
        return None, data
    return data, json


def check_one_given(
    data: str | None, example: str | None, command: str, names: Sequence[str]
) -> None:
    """Refuse neither or both of a file and an example.

    Raises
    ------
    InputError
        With a command that would do.
    """
    if (data is None) == (example is None):
        rule = (
            said("give a CSV file or --example, not both")
            if data
            else said("give a CSV file or --example")
        )
        raise InputError(rule, field="DATA.csv", example=f"{command} --example {names[0]}")
