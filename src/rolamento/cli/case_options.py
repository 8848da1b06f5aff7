"""Where a command's case comes from: a file or a designation, and options that go over it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext
from dataclasses import fields
from typing import TYPE_CHECKING, Annotated, Final

import typer

from rolamento.errors import InputError
from rolamento.records import frozen
from rolamento.words import said

if TYPE_CHECKING:
    pass

__all__ = ["CASE_OPTIONS", "SHORT_FORMS", "CaseOptions"]

_FIELDS: Final = {
    "fr": ("--fr", "duty.load.fz", "5 kN"),
    "fa": ("--fa", "duty.load.fx", "1 kN"),
    "moment": ("--moment", "duty.load.my", "20 N m"),
    "speed": ("--speed", "duty.inner_speed", "1480 rpm"),
    "outer_speed": ("--outer-speed", "duty.outer_speed", "300 rpm"),
    "temperature": ("--temperature", "temperature.lubricant", "70 degC"),
    "lubricant": ("--lubricant", "lubricant", "ISO VG 68"),
}
"""Option, the field of the case that it gives, and a value, by the parameter."""
SHORT_FORMS: Final = {field: option for option, field, _ in _FIELDS.values()}
"""Options by the fields of a case that they give."""


@frozen
class CaseOptions:
    """What options say of a case: its load, speeds and oil, any other field, own catalogues."""

    fr: Annotated[
        str | None,
        typer.Option("--fr", metavar="FORCE", help="Radial load Fr (along z), such as '5 kN'."),
    ] = None
    fa: Annotated[
        str | None,
        typer.Option("--fa", metavar="FORCE", help="Axial load Fa (along x), such as '1 kN'."),
    ] = None
    moment: Annotated[
        str | None,
        typer.Option("--moment", metavar="MOMENT", help="Moment about y, such as '20 N m'."),
    ] = None
    speed: Annotated[
        str | None,
        typer.Option(
            "--speed", metavar="SPEED", help="Speed of the inner ring, such as '1797 rpm'."
        ),
    ] = None
    outer_speed: Annotated[
        str | None,
        typer.Option(
            "--outer-speed", metavar="SPEED", help="Speed of the outer ring, with its sign."
        ),
    ] = None
    temperature: Annotated[
        str | None,
        typer.Option(
            "--temperature",
            metavar="TEMPERATURE",
            help="Temperature of the lubricant, such as '70 degC'.",
        ),
    ] = None
    lubricant: Annotated[
        str | None,
        typer.Option(
            "--lubricant", metavar="NAME", help="Oil or grease by its name, such as 'ISO VG 68'."
        ),
    ] = None
    catalogue: Annotated[
        list[str] | None,
        typer.Option(
            "--catalogue",
            metavar="FILE",
            help="A catalogue of your own, CSV or TOML, for designations. Repeatable.",
        ),
    ] = None
    set: Annotated[
        list[str] | None,
        typer.Option(
            "--set", metavar="KEY=VALUE", help="Override a field of the case. Repeatable."
        ),
    ] = None

    @property
    def settings(self) -> tuple[str, ...]:
        """Settings ``KEY=VALUE`` of all options but the catalogues, in the order of the help.

        Raises
        ------
        InputError
            If an option and ``--set`` give one field.
        """
        own = tuple(self.set or ())
        named = {one.partition("=")[0].strip() for one in own}
        found = []
        for parameter, (option, field, example) in _FIELDS.items():
            value = getattr(self, parameter)
            if value is None:
                continue
            if field in named:
                rule = said("is given by --set {field} too", field=field)
                raise InputError(rule, source=option, value=value, example=f"{option} '{example}'")
            _refuse_thousands(value, option)
            found.append(f"{field}={value}")
        for one in own:
            _refuse_thousands(one.partition("=")[2].strip().strip("\"'"), "--set")
        return (*found, *own)

    @contextmanager
    def in_force(self) -> Iterator[None]:
        """Find designations in the user's catalogues too; name options in what is refused."""
        try:
            with self._catalogues():
                yield
        except InputError as error:
            raise self._in_options(error) from None

    def _catalogues(self) -> AbstractContextManager[object]:
        if not self.catalogue:
            return nullcontext()
        from rolamento.catalogue import catalogues

        return catalogues(self.catalogue)

    def _in_options(self, error: InputError) -> InputError:
        """Name a field that an option gave in the words of that option."""
        for parameter, (option, field, example) in _FIELDS.items():
            given = getattr(self, parameter)
            if given is not None and error.field == field and error.source in ("", "--set"):
                return error.with_details(
                    source=option, field="", value=given, example=f"{option} '{example}'"
                )
        return error


def _refuse_thousands(text: str, option: str) -> None:
    """Refuse what an option gives if it may be a thousand times as much."""
    from rolamento.units import refuse_thousands

    try:
        refuse_thousands(text)
    except InputError as error:
        example = f"{option} '{error.example}'" if option != "--set" else error.example
        raise error.with_details(source=option, example=example) from None


CASE_OPTIONS: Final = tuple(one.name for one in fields(CaseOptions))
"""The names of their parameters, for the groups of a help."""
