"""Errors of a task in the words of its command: ``--speed-unit Hz``, not ``speed_unit="Hz"``."""

from __future__ import annotations

import inspect
import json
import shlex
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import partial

from typer.models import OptionInfo

from rolamento.cli.case_options import SHORT_FORMS
from rolamento.errors import InputError, respelled


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
        names = {"changes": "--set", **options}
        spelled = partial(respelled, names=names, written=written, between=" ")
        source, field = names.get(error.source, error.source), error.field
        if not source and field in names:
            source, field = names[field], ""
        elif error.source not in names:
            field = names.get(field, field)
        raise error.with_details(
            rule=spelled(error.rule), source=source, field=field, example=spelled(error.example)
        ) from None


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
    """Write an option, or what stands for an argument, with a value, as for a shell."""
    if not option.startswith("--"):
        return shlex.quote(value.strip('[]"'))
    if value in ("True", "…"):
        return option
    if value.startswith("{"):  # what goes over a case
        return " ".join(
            written(SHORT_FORMS[name], given) if name in SHORT_FORMS
            else written("--set", f"{name}={given}")
            for name, given in json.loads(value).items()
        )  # fmt: skip
    return f"{option} {shlex.quote(value.strip('[]').strip(chr(34)))}"
