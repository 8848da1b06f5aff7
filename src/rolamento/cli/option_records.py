"""Options that several commands share, as one record that a command takes as one argument."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from dataclasses import fields
from functools import wraps
from typing import Any, TypeVar

__all__ = ["with_record"]

Result = TypeVar("Result")
Command = Callable[..., Result]


def with_record(argument: str, record: type[Any]) -> Callable[[Command[Result]], Command[Result]]:
    """Return a decorator that gives a command the options of a dataclass.

    An option that the command has itself stays the command's own; the record has its default.

    Parameters
    ----------
    argument
        Of the command, in whose place the options are shown.
    record
        A dataclass whose fields are annotated with options.
    """

    def decorated(command: Command[Result]) -> Command[Result]:
        own = inspect.signature(command, eval_str=True).parameters
        options = inspect.signature(record, eval_str=True).parameters
        shared = {name: option for name, option in options.items() if name not in own}

        @wraps(command)
        def taking_options(**given: Any) -> Result:
            values = {one.name: given.pop(one.name) for one in fields(record) if one.name in shared}
            return command(**given, **{argument: record(**values)})

        parameters = [
            one
            for name, parameter in own.items()
            for one in (shared.values() if name == argument else (parameter,))
        ]
        taking_options.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
        taking_options.__annotations__ = {one.name: one.annotation for one in parameters}
        return taking_options

    return decorated
