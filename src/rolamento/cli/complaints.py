"""What is wrong with a command line, in the language of its user."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any, Final, get_args

import typer

from rolamento.errors import printable
from rolamento.words import languages, said, said_in

__all__ = ["UsageError", "complaining", "refuse_language"]

_CLICK: Final[Any] = sys.modules[typer.BadParameter.__module__]
"""Where Typer has its errors from: its own copy of click, of which it exports few."""
UsageError: Final = _CLICK.UsageError

_WRONG: Final = 2


@contextmanager
def complaining() -> Iterator[None]:
    """Say what Typer finds wrong with a command line, and end with exit code 2."""
    try:
        yield
    except _CLICK.NoArgsIsHelpError as error:
        error.show()
    except UsageError as error:
        if error.ctx is not None:
            _echo(error.ctx.get_usage())
            command, option = error.ctx.command_path, error.ctx.help_option_names[0]
            _echo(said("Try '{command} {option}' for help.", command=command, option=option) + "\n")
        _echo(said("Error: {message}", message=_message(error)))
    except typer.Abort:
        _echo(said("Aborted!"))
        raise SystemExit(1) from None
    else:
        return
    raise SystemExit(_WRONG)


def _echo(text: str) -> None:
    typer.echo(text, file=sys.stderr)


def _message(error: Any) -> str:
    """Return what is wrong, by the kind of the error and the parameter that it is of."""
    if isinstance(error, _CLICK.NoSuchOption):
        name = printable(error.option_name)
        near = ", ".join(sorted(error.possibilities or ()))
        if near:
            return said("No such option: {name}. Did you mean {near}?", name=name, near=near)
        return said("No such option: {name}.", name=name)
    if isinstance(error, _CLICK.MissingParameter) and error.param is not None:
        name = _name(error.param)
        if error.param.param_type_name == "argument":
            return said("Missing argument: {name}.", name=name)
        return said("Missing option: {name}.", name=name)
    if isinstance(error, _CLICK.BadParameter) and error.param is not None:
        rule = _rule(error.param) or error.message
        return said("Invalid value for {name}: {rule}.", name=_name(error.param), rule=rule)
    if isinstance(error, _CLICK.BadOptionUsage):
        options = error.ctx.command.get_params(error.ctx)
        flags = [one for one in options if getattr(one, "is_flag", False)]
        if any(error.option_name in one.opts for one in flags):
            return said("Option {name} takes no value.", name=error.option_name)
        return said("Option {name} needs a value.", name=error.option_name)
    return str(error.format_message())


def _name(parameter: Any) -> str:
    """Return how a parameter is written: its option, or what stands for its value."""
    if parameter.param_type_name == "option":
        return str(next((o for o in parameter.opts if o.startswith("--")), parameter.opts[0]))
    return said_in("metavar", parameter.display_name_raw)


def refuse_language(code: str | None) -> None:
    """Refuse what is no language, also where a help or the version is shown, before any command.

    Raises
    ------
    UsageError
        If it is none.
    """
    if code and code not in languages():
        rule = _of_choice("--lang", list(languages()))
        raise UsageError(said("Invalid value for {name}: {rule}.", name="--lang", rule=rule))


def _of_choice(name: str, known: Sequence[str]) -> str:
    """Return which values are allowed, and an example."""
    rule = said("must be one of {known}", known=", ".join(known))
    return f"{rule} {said('(example: {example})', example=f'{name} {known[-1]}')}"


def _rule(parameter: Any) -> str:
    """Return what a value has to be; empty for what no command asks for."""
    kind = parameter.type_descriptor
    if kind.is_choice:
        return _of_choice(
            _name(parameter), [str(getattr(one, "value", one)) for one in kind.choices]
        )
    kinds = {kind.annotation, *get_args(kind.annotation)}
    least = getattr(parameter, "min", None)
    if int in kinds and least is not None:
        return said("must be an integer of at least {least}", least=least)
    if int in kinds:
        return said("must be an integer")
    return said("must be a number") if float in kinds else ""
