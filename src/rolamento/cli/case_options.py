"""Where a command's case comes from: a file or a designation, and options that go over it."""

from __future__ import annotations

import shlex
from collections.abc import Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager, nullcontext
from typing import Annotated, Any, Final

import typer

from rolamento.errors import InputError
from rolamento.words import said

__all__ = ["CASE_OPTIONS", "SHORT_FORMS", "CaseOptions", "missing_options"]

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
_OIL: Final = ("lubricant", "temperature")
_TOGETHER: Final = {
    "duty.load": ("fr", "speed"),
    "lubricant": _OIL,
    "lubricant.friction_coefficient": _OIL,
    "temperature.lubricant": _OIL[1:],
}
"""Options that give what is missing, by its field."""


def missing_options(field: str) -> str:
    """Return the options by which a command is given a field that its case lacks; empty if none."""
    given = (_FIELDS[name] for name in _TOGETHER.get(field, ()))
    return " ".join(f"{option} {shlex.quote(value)}" for option, _, value in given)


def _option(name: str, metavar: str, help: str, *, many: bool = False) -> Any:
    """Return the annotation of an option that may be left out."""
    kind: Any = list[str] if many else str
    return Annotated[kind | None, typer.Option(name, metavar=metavar, help=help)]


CASE_OPTIONS: Final[Mapping[str, Any]] = {
    "fr": _option("--fr", "FORCE", "Radial load Fr (along z), such as '5 kN'."),
    "fa": _option("--fa", "FORCE", "Axial load Fa (along x), such as '1 kN'."),
    "moment": _option("--moment", "MOMENT", "Moment about y, such as '20 N m'."),
    "speed": _option("--speed", "SPEED", "Speed of the inner ring, such as '1797 rpm'."),
    "outer_speed": _option("--outer-speed", "SPEED", "Speed of the outer ring, with its sign."),
    "temperature": _option(
        "--temperature", "TEMPERATURE", "Temperature of the lubricant, such as '70 degC'."
    ),
    "lubricant": _option("--lubricant", "NAME", "Oil or grease by its name, such as 'ISO VG 68'."),
    "catalogue": _option(
        "--catalogue",
        "FILE",
        "A catalogue of your own, CSV or TOML, for designations.",
        many=True,
    ),
    "set": _option("--set", "KEY=VALUE", "Override a field of the case.", many=True),
}
"""Options by their parameters, in the order of the help."""


class CaseOptions:
    """What options say of a case: its load, speeds and oil, any other field, own catalogues.

    Parameters
    ----------
    given
        Values of `CASE_OPTIONS`; what is missing is not given.
    """

    def __init__(self, given: Mapping[str, Any]) -> None:
        self._given = given

    @property
    def settings(self) -> tuple[str, ...]:
        """Settings ``KEY=VALUE`` of all options but the catalogues, in the order of the help.

        Raises
        ------
        InputError
            If an option and ``--set`` give one field.
        """
        own = tuple(self._given.get("set") or ())
        named = {one.partition("=")[0].strip() for one in own}
        found = []
        for parameter, (option, field, example) in _FIELDS.items():
            value = self._given.get(parameter)
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
        own = self._given.get("catalogue")
        if not own:
            return nullcontext()
        from rolamento.catalogue import catalogues

        return catalogues(own)

    def _in_options(self, error: InputError) -> InputError:
        """Name a field that an option gave in the words of that option."""
        for parameter, (option, field, example) in _FIELDS.items():
            given = self._given.get(parameter)
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
