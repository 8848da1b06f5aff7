"""Records that a data file knows by their names: materials, lubricants."""

from collections.abc import Mapping
from functools import cache
from typing import Any, ClassVar, Self

from pydantic import (
    Field,
    SerializationInfo,
    SerializerFunctionWrapHandler,
    model_serializer,
)

from rolamento.case.quantity import AT_THE_BORDER, Line
from rolamento.case.record import Record
from rolamento.errors import InputError, alike, guess
from rolamento.io.data import toml_of
from rolamento.words import marked, said

__all__ = ["NamedRecord"]


class NamedRecord(Record):
    """A record of values, or of the data file by its name or an alias."""

    has_short_form: ClassVar = True
    data_file: ClassVar[str]
    """Name of a file of rolamento/data, without its ending."""
    data_key: ClassVar[str] = "material"
    """Key of the list."""
    called: ClassVar[str] = marked("material")
    """What such a record is of, for messages."""
    usual: ClassVar[str]
    """The name of one, for messages."""

    name: Line = Field("custom", examples=["supplier's certificate"])

    @classmethod
    def named(cls, name: str) -> Self:
        """Return a record of the data file by its name or an alias, in any case.

        Raises
        ------
        InputError
            If none has that name; the message gives the nearest one.
        """
        table = _tables_by_name(cls).get(_folded(name))
        if table is not None:
            return _read(cls, table["name"])  # type: ignore[return-value]
        near = alike(name, cls.names(with_aliases=True))
        known = {"kind": said(cls.called), "guess": guess(name, near or cls.names())}
        raise InputError(
            said("is an unknown name ({kind}); {guess}", **known),
            value=name,
            example=f'"{cls.usual}"',
        )

    @classmethod
    def names(cls, *, with_aliases: bool = False) -> tuple[str, ...]:
        """Return the names of the records in the data file."""
        return tuple(
            name
            for table in cls.tables()
            for name in (table["name"], *(table.get("aliases", ()) if with_aliases else ()))
        )

    @classmethod
    def tables(cls) -> tuple[dict[str, Any], ...]:
        """Return the tables of the data file."""
        return tuple(toml_of(cls.data_file)[cls.data_key])

    @classmethod
    def table_of_text(cls, text: str) -> dict[str, Any]:
        """Return a record of the data file as the table that describes it in a case file."""
        cls.named(text)
        table = _tables_by_name(cls)[_folded(text)]
        return {key: value for key, value in table.items() if key != "aliases"}

    @classmethod
    def name_or_table(cls, value: object) -> object:
        """Let a field of such a record take the name of one."""
        if isinstance(value, str):
            return cls.named(value)
        if isinstance(value, cls | Mapping):
            return value
        raise InputError(
            said("must be a name ({kind}) or a table", kind=said(cls.called)), value=value
        )

    @model_serializer(mode="wrap")
    def _name_or_fields(
        self, handler: SerializerFunctionWrapHandler, info: SerializationInfo
    ) -> Any:
        """Write a record of the data file as its name, where a person reads."""
        table = _tables_by_name(type(self)).get(_folded(self.name))
        if info.context == AT_THE_BORDER and table and _read(type(self), table["name"]) == self:
            return self.name
        return handler(self)


def _folded(name: str) -> str:
    return "".join(name.split()).casefold()


@cache
def _tables_by_name(record: type[NamedRecord]) -> dict[str, dict[str, Any]]:
    return {
        _folded(name): table
        for table in record.tables()
        for name in (table["name"], *table.get("aliases", ()))
    }


@cache
def _read(record: type[NamedRecord], name: str) -> NamedRecord:
    table = _tables_by_name(record)[_folded(name)]
    return record.from_mapping({key: value for key, value in table.items() if key != "aliases"})
