"""Help in the language of its reader, in groups: commands by purpose, options by subject."""

from __future__ import annotations

import copy
import re
from collections.abc import Collection, Mapping, Sequence
from functools import partial
from typing import Any, ClassVar, Final, TypeVar, get_args

import typer.core
from typer.core import TyperCommand, TyperGroup

from rolamento.cli.complaints import UsageError, complaining, refuse_language
from rolamento.cli.waiting import working
from rolamento.errors import nearest
from rolamento.words import code_asked, language_asked, marked, said, said_in, speaking, spelling

__all__ = [
    "METAVAR",
    "GroupedCommands",
    "Groups",
    "SpokenCommand",
    "as_option",
    "paragraphs",
    "unwrapped",
]

Groups = Mapping[str, Collection[str]]
"""Headings, in their order, and the names below each."""

METAVAR: Final = "metavar"
"""The context of words that stand for a value, such as FILE."""

_LONGEST: Final = 200
"""Characters of a one-line help, which is wrapped and not cut where it is too long for a line."""

_COLUMN: Final = 30
"""Characters of names beside what they mean; longer ones stand above it."""

typer.core._ = said  # type: ignore[attr-defined, assignment]  # else it asks the process's own catalogue
_OF_TYPER: Final = (
    marked("default: {default}"),
    marked("required"),
    marked("Missing command."),
    marked("Aborted!"),
    marked("Show this message and exit."),
)
"""What Typer says, beside what is said here in its place."""


class SpokenCommand(TyperCommand):
    """A command whose help is said, the options in groups by the names of their parameters."""

    groups: ClassVar[Groups] = {}

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Parse the arguments, and refuse those that are too many."""
        ctx.allow_extra_args = True  # to be refused here
        try:
            extra = super().parse_args(ctx, _with_points(args, self.params))
        except UsageError as error:
            error.ctx = error.ctx or ctx
            raise
        if extra:
            ctx.fail(said("Got unexpected extra arguments: {arguments}", arguments=" ".join(extra)))
        return extra

    def invoke(self, ctx: Any) -> Any:
        """Run the command, and show that it is at work where it takes long."""
        with working():
            return super().invoke(ctx)

    def format_usage(self, ctx: Any, formatter: Any) -> None:
        """Write how the command is called."""
        _write_usage(self, ctx, formatter)

    def format_help(self, ctx: Any, formatter: Any) -> None:
        """Write the help in the language that is spoken."""
        super(SpokenCommand, _spoken(self)).format_help(ctx, formatter)

    def format_options(self, ctx: Any, formatter: Any) -> None:
        """Write the arguments, and the options below their headings."""
        _write_options(self, ctx, formatter, {})


def _with_points(arguments: Sequence[str], parameters: Sequence[Any]) -> list[str]:
    """Return the arguments, those of options that take a number with a decimal point."""
    from rolamento.units import typed

    takers = {name for one in parameters if _takes_number(one) for name in one.opts}
    words: list[str] = []
    for word in arguments:
        option, equals, value = word.partition("=")
        if words and words[-1] in takers:
            word = typed(word)
        elif equals and option in takers:
            word = f"{option}={typed(value)}"
        words.append(word)
    return words


def _takes_number(parameter: Any) -> bool:
    kind = getattr(parameter, "type_descriptor", None)
    annotation = getattr(kind, "annotation", None)
    return float in {annotation, *get_args(annotation)}


def as_option(options: Mapping[str, str], text: str) -> str:
    """Spell a name in a text as the command line does (`rolamento.words.spelling`).

    Parameters
    ----------
    options
        By the names of the inputs, where they are not just ``--name``.
    text
        An input, a field of a case or a command; the first two with a value or without.
    """
    name, equals, value = text.partition("=")
    if "." in name:
        return f"--set {text}" if equals else text
    if " " in name:
        return text
    option = options.get(name, f"--{name.replace('_', '-')}")
    return f"{option} {value}" if equals else option


class GroupedCommands(TyperGroup):
    """A command whose help shows its own commands in groups, with all of the one-line help."""

    groups: ClassVar[Groups] = {}

    def main(self, args: Sequence[str] | None = None, *others: Any, **more: Any) -> Any:
        """Run in the language that the arguments ask for, or else in that of the locale."""
        as_typed = spelling(partial(as_option, {"changes": "--set"}))
        with speaking(language_asked(args)), as_typed, complaining():
            refuse_language(code_asked(args))
            more["standalone_mode"] = False
            raise SystemExit(super().main(args, *others, **more) or 0)

    def resolve_command(self, ctx: Any, args: list[str]) -> tuple[str | None, Any, list[str]]:
        """Find the command that is called, or name the nearest one."""
        name = args[0]
        if self.get_command(ctx, name) is None and not name.startswith("-"):
            near = nearest(name, self.commands)
            ctx.fail(
                said("No such command: {name}. Did you mean {near}?", name=name, near=near)
                if near
                else said("No such command: {name}.", name=name)
            )
        return super().resolve_command(ctx, args)

    def list_commands(self, ctx: Any) -> list[str]:
        """Return the names, in the order of the groups."""
        known = list(self.commands)
        named = [name for names in self.groups.values() for name in names]
        ordered = [name for name in named if name in known]
        return ordered + [name for name in known if name not in named]

    def format_usage(self, ctx: Any, formatter: Any) -> None:
        """Write how the command is called."""
        _write_usage(self, ctx, formatter)

    def format_help(self, ctx: Any, formatter: Any) -> None:
        """Write the help in the language that is spoken."""
        super(GroupedCommands, _spoken(self)).format_help(ctx, formatter)

    def format_options(self, ctx: Any, formatter: Any) -> None:
        """Write the options, and the commands below their headings."""
        commands = {name: (name, self.line_of(name)) for name in self.list_commands(ctx)}
        _write_options(self, ctx, formatter, _grouped(commands, self.groups, marked("Commands")))

    def line_of(self, name: str) -> str:
        """Return what a command does, in one line."""
        return str(_spoken(self.commands[name]).get_short_help_str(_LONGEST))


def unwrapped(text: str) -> str:
    """Return a help text with one line a paragraph."""
    return re.sub(r"(?<!\n)\n(?!\n)", " ", text)


def paragraphs(text: str) -> list[str]:
    """Return the paragraphs of a help text, each an entry of the catalogues."""
    return unwrapped(text).split("\n\n")


C = TypeVar("C")


def _spoken(shown: C) -> C:
    """Return a command or a parameter that says its help in the language that is spoken."""
    copied: Any = copy.copy(shown)
    for name in ("help", "epilog"):
        if getattr(copied, name, None):
            setattr(copied, name, "\n\n".join(map(said, paragraphs(getattr(copied, name)))))
    if getattr(copied, "multiple", False):
        copied.help += " " + said("Repeatable.")
    if getattr(copied, "metavar", None):
        copied.metavar = said_in(METAVAR, copied.metavar)
    if getattr(copied, "param_type_name", "") == "argument":
        copied.display_type_rich = lambda ctx: None  # all are texts; the help says of what
    return copied  # type: ignore[no-any-return]


def _write_usage(command: Any, ctx: Any, formatter: Any) -> None:
    pieces = [said_in(METAVAR, command.options_metavar)]
    for parameter in command.get_params(ctx):
        pieces += map(_without_braces, _spoken(parameter).get_usage_pieces(ctx))
    if isinstance(command, TyperGroup):
        pieces.append(said_in(METAVAR, command.subcommand_metavar))
    formatter.write_usage(ctx.command_path, " ".join(pieces), said("Usage: "))


def _without_braces(piece: str) -> str:
    """Return what stands for an argument as usual: CASE, not {CASE}, where it is required."""
    return piece.translate({ord("{"): None, ord("}"): None})


def _write_options(
    command: Any, ctx: Any, formatter: Any, more: Mapping[str, Sequence[tuple[str, str]]]
) -> None:
    """Write arguments and options below their headings, then what stands below further ones."""
    arguments: list[tuple[str, str]] = []
    options: dict[str, tuple[str, str]] = {}
    for parameter in command.get_params(ctx):
        record = _spoken(parameter).get_help_record(ctx)
        if record is not None and parameter.param_type_name == "argument":
            arguments.append(record)
        elif record is not None:
            options[str(parameter.name)] = record
    of_command = {} if more else command.groups
    groups = _grouped(options, of_command, marked("Options"))
    _write(formatter, {marked("Arguments"): arguments, **groups})
    _write(formatter, more)


def _grouped(
    records: Mapping[str, tuple[str, str]], groups: Groups, rest: str
) -> dict[str, list[tuple[str, str]]]:
    """Put each record below its heading, in the order there; what has none below the last."""
    found = {
        heading: [records[name] for name in names if name in records]
        for heading, names in groups.items()
    }
    named = {name for names in groups.values() for name in names}
    left = [record for name, record in records.items() if name not in named]
    return {**found, rest: [*found.get(rest, []), *left]}


def _write(formatter: Any, groups: Mapping[str, Sequence[tuple[str, str]]]) -> None:
    """Write what stands below each heading, in one column for all but long names."""
    widths = [len(name) for group in groups.values() for name, _ in group]
    width = max((width for width in widths if width <= _COLUMN), default=0)
    for heading, group in groups.items():
        if group:
            with formatter.section(said(heading)):
                formatter.write_dl(
                    [(name.ljust(width), text) for name, text in group], col_max=width
                )
