"""Commands made of requests: the options, their help, and what is written are the request's."""

from __future__ import annotations

import inspect
import json as json_format
import os
import shlex
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING, Annotated, Any, Final

import typer

from rolamento.cli.case_options import CASE_OPTIONS, SHORT_FORMS, CaseOptions, missing_options
from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    LanguageOption,
    ended_softly,
    json_option,
    plain_endings,
)
from rolamento.cli.grouped_help import as_option
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.outputs import OUTPUT_OPTIONS, Outputs
from rolamento.cli.streams import STANDARD_STREAM, complain, print_text, put
from rolamento.errors import ABSENT, InputError, UnknownKeyError
from rolamento.io.writing import write_text
from rolamento.words import said, spelling

if TYPE_CHECKING:
    from rolamento.tasks.request import Input, Request

__all__ = ["add_command", "options_of", "program_of"]

_METAVARS: Final = {
    "number": "NUMBER", "count": "N", "fraction": "FRACTION", "frequency": "FREQUENCY",
    "time": "TIME",
}  # fmt: skip


def add_command(app: typer.Typer, request: type[Request], name: str) -> None:
    """Give a program the command of a request.

    Parameters
    ----------
    app
        The program.
    request
        Whose fields become arguments and options.
    name
        What the command is called.
    """

    def command(**typed: Any) -> None:
        lang, json = typed.pop("lang"), typed.pop("json", None)
        own = {one: typed.pop(one) for one in CASE_OPTIONS if one not in inputs and one in typed}
        given = CaseOptions(own)
        outputs = Outputs(**{one: typed.pop(one) for one in OUTPUT_OPTIONS if one in typed})
        with plain_endings(lang), given.in_force(), _in_options(request, typed):
            files = {f"--{one}": typed.pop(one) for one in request.products}
            if request.ships:
                json = _shipped(request, name, typed, json)
            read = _read(request, typed)
            _check_words(request, read, json)
            if "tables" in request.model_fields:
                typed["tables"] = outputs.has_tables
            asked = _asked(request, typed, given)
            target = asked.target
            others = {
                one.long_option(name): typed[name]
                for name, one in inputs.items()
                if one.kind == "target" and name != "output"
            }
            outputs.check({"--output": target, **others, "--json": json, **files}, *read)
            _refuse_there(asked)
            for option, path in files.items():
                check = request.products[option.removeprefix("--")].check
                if path is not None and check is not None:
                    check(asked)
            found = _run(asked)
            if target == STANDARD_STREAM:
                content = asked.content(found)
                put(content if isinstance(content, str) else content.decode("utf-8-sig"), target)
            elif target is not None:
                asked.write(found, target)
            _write(asked, found, files)
            if STANDARD_STREAM in others.values() and asked.has_result(found):
                json = STANDARD_STREAM  # what another target holds is its JSON
            if json is not None:
                put(asked.json_text(found) + "\n", json)
            elsewhere, has_page = (json, target, *files.values()), asked.has_page(found)
            if has_page:
                outputs.show(lambda: asked.page(found), *elsewhere, report=asked.report(found))
            if STANDARD_STREAM not in elsewhere:
                print_text(asked.closing(found))
                if target is not None and not (has_page or asked.says_written):
                    print_text(said("Wrote {path}", path=target) + "\n")
            complaint = asked.complaint(found)
            if complaint and (not has_page or STANDARD_STREAM in (outputs.csv, *elsewhere)):
                for line in complaint.splitlines():
                    complain(line)
        raise typer.Exit(SOLVED if asked.has_result(found) else NO_RESULT)

    inputs, taken = request.inputs(), _signature(request)
    command.__signature__ = taken  # type: ignore[attr-defined]
    command.__name__, command.__doc__ = name, request.summary()
    groups: dict[str, tuple[str, ...]] = request.options_by_heading()
    written = (*request.products, "write", "json", *OUTPUT_OPTIONS, "lang")
    there = (one for one in written if one in taken.parameters)
    groups["Output"] = (*groups.pop("Output", ()), *there, "help")
    if request.takes_case:
        first = next(iter(groups))
        groups[first] += tuple(name for name in CASE_OPTIONS if name not in inputs)
    shown = type("RequestedCommand", (JsonCommand,), {"groups": groups})
    app.command(name, cls=shown, epilog=request.examples or None)(command)


def program_of(path: str, name: str) -> typer.Typer:
    """Return a program with one command; path: of its request, ``module:Class`` in the tasks."""
    module, _, request = path.partition(":")
    app = typer.Typer(add_completion=False)
    add_command(app, getattr(import_module(f"rolamento.tasks.{module}"), request), name)
    return app


def options_of(request: type[Request]) -> dict[str, inspect.Parameter]:
    """Return the parameters of a command by the names of a request's fields."""
    inputs, means = request.inputs(), request.meanings()
    arguments_first = sorted(inputs, key=lambda name: not inputs[name].is_argument)
    return {name: _parameter(name, inputs[name], means[name]) for name in arguments_first}


def _signature(request: type[Request]) -> inspect.Signature:
    """Return all that the command of a request takes; a field goes over a common option."""
    common = CASE_OPTIONS if request.takes_case else {}
    found = {name: _with(name, one, None) for name, one in common.items()} | options_of(request)
    found |= {name: _product(name, one.meaning) for name, one in request.products.items()}
    if request.ships:
        found["write"] = _product("write", "Write the example as CSV instead.")
    if request.json_meaning:
        json = Annotated[str | None, json_option(request.json_meaning)]
        found["json"] = _with("json", json, None)
    found |= _parameters(Outputs) if request.shows_page else {}
    found["lang"] = _with("lang", LanguageOption, None)
    needed_first = sorted(found.values(), key=lambda one: one.default is not one.empty)
    return inspect.Signature(needed_first)


def _parameters(record: type[Any]) -> dict[str, inspect.Parameter]:
    """Return the options of a record whose fields are annotated with them."""
    return dict(inspect.signature(record, eval_str=True).parameters)


def _parameter(name: str, one: Input, meaning: str) -> inspect.Parameter:
    """Return the parameter of a command for a field: a text, whatever the request makes of it."""
    metavar = one.metavar or _METAVARS.get(one.kind) or name.upper().replace("_", "-")
    default: Any = None if one.is_many else one.default or None
    if one.kind == "switch":
        made = typer.Option(one.option or one.long_option(name), help=meaning)
        has_opposite = "/" in one.option
        default = {"true": True, "false": False}.get(one.default, None if has_opposite else False)
        kind: Any = bool | None if default is None else bool
    elif one.is_argument:
        made = typer.Argument(metavar=metavar, help=meaning)
        kind = list[str] if one.is_many else str
        if one.essential:
            default = inspect.Parameter.empty
        else:
            kind = kind | None
    else:
        names = ("--output", "-o") if name == "output" else (one.long_option(name),)
        made = typer.Option(*names, metavar=metavar, help=meaning)
        kind = list[str] | None if one.is_many else str | None
        if one.kind == "target" and one.essential:
            kind, default = str, inspect.Parameter.empty
    return _with(name, Annotated[kind, made], default)


def _product(name: str, meaning: str) -> inspect.Parameter:
    made = typer.Option(f"--{name}", metavar="FILE", help=meaning)
    return _with(name, Annotated[str | None, made], None)


def _with(name: str, annotation: Any, default: Any) -> inspect.Parameter:
    kind = inspect.Parameter.POSITIONAL_OR_KEYWORD
    return inspect.Parameter(name, kind, default=default, annotation=annotation)


@contextmanager
def _in_options(request: type[Request], typed: Mapping[str, Any]) -> Iterator[None]:
    """Say which option gave what is refused; of a table, a column is called as it is there.

    A file may be called as a field is.
    """
    options = {
        name: one.metavar if one.is_argument else one.long_option(name)
        for name, one in request.inputs().items()
    } | {name: f"--{name}" for name in request.products}
    try:
        with spelling(partial(as_option, {"changes": "--set", **options})):
            yield
    except InputError as error:
        of_column = error.field in request.columns and error.source not in ("", *options)
        if isinstance(error, UnknownKeyError) and error.source:
            raise  # of a file, whose keys may be called as the fields of the request
        is_file = error.source in _read(request, typed)
        named = {**options, error.field: error.field} if of_column else options
        named = {name: one for name, one in named.items() if not is_file or name != error.source}
        if request.takes_case and error.value is ABSENT and (more := missing_options(error.field)):
            error = error.with_details(example=more)
        with _in_names(named):
            raise error from None


def _read(request: type[Request], typed: Mapping[str, Any]) -> list[str]:
    """Return the names of the files that are read."""
    return [
        path
        for field, one in request.inputs().items()
        if (one.names_files or one.kind == "bearing") and one.kind != "target" and typed.get(field)
        for path in (typed[field] if one.is_many else [typed[field]])
    ]


def _refuse_there(asked: Request) -> None:
    """Refuse to overwrite a file of a request that has ``--force``, without it."""
    target = asked.target
    if target in (None, STANDARD_STREAM) or getattr(asked, "force", True):
        return
    if os.path.lexists(target):
        raise InputError(said("already exists; --force overwrites it"), source=target)


def _check_words(request: type[Request], read: Sequence[str], json: str | None) -> None:
    """Refuse two files from one stream, and one that is taken as that of ``--json``.

    Raises
    ------
    InputError
        For either.
    """
    if read.count(STANDARD_STREAM) > 1:
        raise InputError(said("can be read only once"), source="standard input")
    takes_cases = any(one.kind == "files" for one in request.inputs().values())
    if request.takes_case and takes_cases and (json or "").lower().endswith(".toml"):
        rule = said(
            "is taken as the FILE of --json; put --json last, or follow it with a name that ends in"
            " .json"
        )
        raise InputError(rule, source="--json", value=json)


def _shipped(
    request: type[Request], command: str, typed: dict[str, Any], json: str | None
) -> str | None:
    """Take an example in the place of a file, or write it and end; return where JSON goes.

    Raises
    ------
    InputError
        For neither or both of a file and an example.
    """
    field = next(name for name, one in request.inputs().items() if one.is_argument)
    data, example, path = typed[field], typed["example"], typed.pop("write")
    known = list((request.inputs()["example"].choices or dict)())
    if example is not None:
        typed["example"] = example = request.inputs()["example"].value(example)
        if json == STANDARD_STREAM and data is not None:  # beside an example, the file of the JSON
            data, json = None, data
    typed[field] = data
    if path is not None:
        if example is None or data is not None:
            raise InputError(said("goes with --example alone"), source="--write", value=path)
        write_text(request.shipped_text(example), path, new=True)
        print_text(said("Wrote {path}", path=path) + "\n")
        raise typer.Exit(SOLVED)
    if data is not None and example is not None:
        rule = said("give a CSV file or --example, not both")
    elif request.needs_file and data is None and example is None:
        rule = said("give a CSV file or --example")
    else:
        return json
    raise InputError(rule, field="DATA.csv", example=f"{command} --example {known[0]}")


def _asked(request: type[Request], typed: Mapping[str, Any], given: CaseOptions) -> Request:
    usual = {name: one.default for name, one in request.model_fields.items()}
    own = {name: one for name, one in typed.items() if one not in (None, [], usual[name])}
    for name, value in own.items():
        if value in ("", [""]):
            raise InputError(said("is missing"), field=name)
    inputs = request.inputs()
    own = {
        name: inputs[name].typed(value) if isinstance(value, list) else value
        for name, value in own.items()
    }
    if request.takes_case:
        own["changes"] = given.settings
    return request(**own)


def _run(asked: Request) -> Any:
    from rolamento.cli.waiting import progress_of, waiting

    if asked.lasts:
        from rolamento.cli.sweep_progress import told

        with ended_softly(), told() as counted:
            return asked.run(counted)
    if asked.counts:
        with progress_of(said(asked.waiting)) as progress:
            return asked.run(progress)
    with waiting(None, said(asked.waiting)):
        return asked.run()


def _write(asked: Request, found: Any, files: Mapping[str, str | None]) -> None:
    """Write the files that the request has beside its page."""
    for option, path in files.items():
        product = asked.products[option.removeprefix("--")]
        made = None if path is None else product.make(asked, found)
        if path is None or made is None:
            continue
        if product.is_picture:
            from rolamento.plots.saving import save_figure

            save_figure(made, path)
        else:
            put(made, path)


# --- errors in the words of a command ------------------------------------------------------------


@contextmanager
def _in_names(options: Mapping[str, str]) -> Iterator[None]:
    """Say which option gave a field that is refused; options: by the names of the fields."""
    try:
        yield
    except InputError as error:
        if error.source.startswith("--"):
            raise
        names = {"changes": "--set", **options}
        if not error.source and error.field in names:
            error = error.with_details(source=error.field, field="")
        raise error.spelled(names, _written, " ") from None


def _written(option: str, value: str) -> str:
    """Write an option, or what stands for an argument, with a value, as for a shell."""
    if not option.startswith("--"):
        return shlex.quote(value.strip('[]"'))
    if value in ("True", "…"):
        return option
    if value.startswith("{"):  # what goes over a case
        return " ".join(
            _written(SHORT_FORMS[name], given) if name in SHORT_FORMS
            else _written("--set", f"{name}={given}")
            for name, given in json_format.loads(value).items()
        )  # fmt: skip
    return f"{option} {shlex.quote(value.strip('[]').strip(chr(34)))}"
