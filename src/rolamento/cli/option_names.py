"""Errors of a task in the words of its command: ``--speed-unit Hz``, not ``speed_unit="Hz"``."""

from __future__ import annotations

import json
import shlex
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import partial

from rolamento.cli.case_options import SHORT_FORMS
from rolamento.errors import InputError, respelled


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
