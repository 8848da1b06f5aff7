"""Help in groups: commands by what a person wants, options by what they are about."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar, Final

from typer.core import TyperGroup

from rolamento.cli.optional_value import JsonCommand

__all__ = ["GroupedCommand", "GroupedCommands", "Groups"]

Groups = Mapping[str, tuple[str, ...]]
"""Headings, in their order, and the names below each."""

_LONGEST: Final = 200
"""Characters of a one-line help, which is wrapped and not cut where it is too long for a line."""


class GroupedCommand(JsonCommand):
    """A command whose help shows the options in groups, by the names of their parameters."""

    groups: ClassVar[Groups] = {}

    def format_options(self, ctx: Any, formatter: Any) -> None:
        """Write the arguments, and the options below their headings."""
        arguments: dict[str, tuple[str, str]] = {}
        options: dict[str, tuple[str, str]] = {}
        for parameter in self.get_params(ctx):
            record = parameter.get_help_record(ctx)
            if record is not None:
                is_argument = parameter.param_type_name == "argument"
                (arguments if is_argument else options)[str(parameter.name)] = record
        groups = _grouped(options, self.groups, "Options")
        _write(formatter, {"Arguments": list(arguments.values()), **groups})


class GroupedCommands(TyperGroup):
    """A command whose help shows its own commands in groups, with all of the one-line help."""

    groups: ClassVar[Groups] = {}

    def list_commands(self, ctx: Any) -> list[str]:
        """Return the names, in the order of the groups."""
        known = super().list_commands(ctx)
        named = [name for names in self.groups.values() for name in names]
        ordered = [name for name in named if name in known]
        return ordered + [name for name in known if name not in named]

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        """Write the commands below their headings."""
        records: dict[str, tuple[str, str]] = {}
        for name in self.list_commands(ctx):
            command = self.get_command(ctx, name)
            if command is not None and not command.hidden:
                records[name] = name, command.get_short_help_str(_LONGEST)
        _write(formatter, _grouped(records, self.groups, "Commands"))


def _grouped(
    records: Mapping[str, tuple[str, str]], groups: Groups, rest: str
) -> dict[str, list[tuple[str, str]]]:
    """Put each record below its heading, in the order there; what has none below the last."""
    found = {
        heading: [records[name] for name in names if name in records]
        for heading, names in groups.items()
    }
    named = {name for names in groups.values() for name in names}
    found[rest] = [record for name, record in records.items() if name not in named]
    return found


def _write(formatter: Any, groups: Mapping[str, list[tuple[str, str]]]) -> None:
    """Write what stands below each heading, in one column for all of them."""
    width = max((len(name) for group in groups.values() for name, _ in group), default=0)
    for heading, group in groups.items():
        if group:
            with formatter.section(heading):
                formatter.write_dl([(name.ljust(width), text) for name, text in group])
