"""Errors of a task in the words of its command: ``--speed-unit Hz``, not ``speed_unit="Hz"``."""

from __future__ import annotations

import inspect
import shlex
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager

from typer.models import OptionInfo

from rolamento.errors import InputError


@contextmanager
def in_options(command: Callable[..., None], **others: str) -> Iterator[None]:
    """Say which option gave a parameter that is refused.

    Parameters
    ----------
    command
        Whose options are named.
    others
        Options that are called otherwise than the parameter of the task.
    """
    with in_names({**_option_names(command), **others}):
        yield


@contextmanager
def in_names(options: Mapping[str, str]) -> Iterator[None]:
    """Say which option gave a field that is refused; options: by the names of the fields."""
    try:
        yield
    except InputError as error:
        if error.source.startswith("--"):
            raise
        from rolamento.tasks.parameters import renamed

        names = {"changes": "--set", **options}
        told = renamed(error, names, written, between=" ")
        if not told.source and error.field in names:
            told = told.with_details(field="", source=told.field)
        raise told from None


def _option_names(command: Callable[..., None]) -> dict[str, str]:
    """Return the long name of each option of a command, by the name of its parameter."""
    names: dict[str, str] = {}
    for one in inspect.signature(command, eval_str=True).parameters.values():
        for part in getattr(one.annotation, "__metadata__", ()):
            if isinstance(part, OptionInfo):
                # within `Annotated`, typer holds the first name in the place of the default
                declared = (part.default, *(part.param_decls or ()))
                names[one.name] = next(str(name) for name in declared if str(name)[:2] == "--")
    return names


def written(option: str, value: str) -> str:
    """Write an option with a value, as for a shell."""
    if value in ("True", "…"):
        return option
    return f"{option} {shlex.quote(value.strip('[]').strip(chr(34)))}"
