"""The base of everything that the user gives: frozen, compared by value, plainly refused.

Pydantic checks; what it finds is reported in Rolamento's own words. None of its
exceptions reaches a user.

Modules of records do without ``from __future__ import annotations``: as texts, the types of their
fields would be compiled anew in every process, a third of what it takes to make the classes.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterator, Mapping
from functools import cache
from types import UnionType
from typing import Annotated, Any, ClassVar, Final, NoReturn, Self, Union, get_args, get_origin

from pydantic import (
    BaseModel,
    ConfigDict,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    ValidationError,
)
from pydantic.fields import FieldInfo
from pydantic_core import CoreSchema, ErrorDetails, core_schema

from rolamento.case.hints import hint
from rolamento.case.quantity import AT_THE_BORDER, Replaces
from rolamento.errors import ABSENT, InputError, UnknownKeyError, phrase
from rolamento.records import concise
from rolamento.words import marked, said

__all__ = [
    "ByElement",
    "Record",
    "example_of",
    "meanings",
    "record_for",
    "records_of",
    "refuse_rivals",
    "replaced",
]

_RULES: Final = {
    "missing": marked("is missing"),
    "bool_type": marked("must be true or false"),
    "int_type": marked("must be an integer"),
    "string_type": marked("must be text"),
    "string_unicode": marked("must be text"),
    "string_pattern_mismatch": marked("must be one line without control characters"),
    "string_too_long": marked("must be at most {max_length} characters long"),
    "greater_than_equal": marked("must be at least {ge:.6g}"),
    "less_than_equal": marked("must be at most {le:.6g}"),
    "too_short": marked("must have at least {min_length} entries, and has {actual_length}"),
    "too_long": marked("must have at most {max_length} entries"),
    "tuple_type": marked("must be a list"),
    "dict_type": marked("must be a table"),
    "float_type": marked("must be a number"),
    "literal_error": marked("must be one of {expected}"),
    "union_tag_invalid": marked("must be one of {expected_tags}"),
    "union_tag_not_found": marked("must be a table"),
    "model_type": marked("must be a table"),
    "model_attributes_type": marked("must be a table"),
}


class Record(BaseModel):
    """A frozen record of validated fields; equal and hashable by value.

    What a field is by default, `model_construct` makes: that needs no validation, nor its schema.

    Raises
    ------
    InputError
        From the constructor, naming the field, the value, the rule and an example.
    """

    # most records are only ever read as parts of a case, whose schema holds theirs
    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False, defer_build=True)

    def __init__(self, /, **fields: Any) -> None:
        try:
            super().__init__(**fields)
        except ValidationError as error:
            raise _plain_error(error, type(self)) from None

    # Pydantic then validates nested records directly, with the context of their parent,
    # and this constructor is used only where a person calls it.
    __init__.__pydantic_base_init__ = True  # type: ignore[attr-defined]

    __repr__ = concise
    __str__ = concise

    def _printed(self) -> Iterator[tuple[str, Any]]:
        """What the user gave that is no default; what a designation fills in is left out."""
        for name, field in type(self).model_fields.items():
            value = getattr(self, name)
            given = {"validated_data": self.__dict__} if field.default_factory else {}
            default = field.get_default(call_default_factory=True, **given)
            if name in self.model_fields_set and value != default:
                yield name, value

    def __setattr__(self, name: str, value: object) -> NoReturn:
        raise AttributeError(f"a {type(self).__name__} does not change; see its replace method")

    has_short_form: ClassVar[bool] = False
    """Whether a text may stand for the table that describes it in a case file."""

    @classmethod
    def table_of_text(cls, text: str) -> dict[str, Any]:
        """Return the table of a case file that a text stands for.

        Raises
        ------
        InputError
            If the text stands for none.
        """
        raise InputError(said("must be a table"), value=text)

    @classmethod
    def text_or_table(cls, value: object) -> object:
        """Let a field of such a record take the text that stands for its table."""
        return cls.table_of_text(value) if isinstance(value, str) else value

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        """Put the meaning of each field beside its unit and bounds."""
        described = handler(schema)
        table = handler.resolve_ref_schema(described)
        table["description"] = inspect.cleandoc(cls.__doc__ or "").partition("\n\nParameters")[0]
        for name, field in table.get("properties", {}).items():
            if name in meanings(cls):
                field.setdefault("description", meanings(cls)[name])
            if others := replaced(cls, name):
                field["replaces"] = list(others)
        return described

    def replace(self, **changes: Any) -> Self:
        """Return a new record with the given fields changed, validated afresh.

        Parameters
        ----------
        changes
            New values by field name; ``None`` takes an optional field away.

        Raises
        ------
        InputError
            If the result is not valid.
        """
        kept = {name: getattr(self, name) for name in self.model_fields_set}
        return type(self)(**{**kept, **changes})

    @classmethod
    def from_mapping(cls, mapping: Mapping[str, Any]) -> Self:
        """Return the record that a file's table describes: quantities are text with units.

        Raises
        ------
        InputError
            If the table is not valid.
        """
        try:
            return cls.model_validate(mapping, context=AT_THE_BORDER)
        except ValidationError as error:
            raise _plain_error(error, cls) from None

    def to_mapping(self) -> dict[str, Any]:
        """Return the table that describes the record in a file; inverse of `from_mapping`."""
        return self.model_dump(context=AT_THE_BORDER, exclude_none=True)


class ByElement:
    """Annotation of a record, or a union of records, that `element` distinguishes.

    Parameters
    ----------
    element_of
        Returns the element of a table without one; None for that of the first record.
    """

    def __init__(self, element_of: Callable[[Mapping[str, Any]], str | None] | None = None) -> None:
        self.element_of = element_of

    def __get_pydantic_core_schema__(
        self, source: object, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        """Have pydantic choose the record by the element."""
        members = get_args(source) or (source,)
        choices = {
            f"{_TAG}{element}": member for member in members for element in elements_of(member)
        }
        first = next(iter(choices))

        def tag(given: Any) -> str | None:
            if isinstance(given, Mapping):
                named = self.element_of and "element" not in given and self.element_of(given)
                element = given.get("element", named or None)
                return first if element is None else f"{_TAG}{element}"
            return f"{_TAG}{given.element}" if isinstance(given, members) else None

        return core_schema.tagged_union_schema(
            {name: handler.generate_schema(member) for name, member in choices.items()}, tag
        )

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        """Any of the records: a table may fit several if more than `element` distinguishes them."""
        described = handler(schema)
        if "oneOf" in described:
            described["anyOf"] = described.pop("oneOf")
        return described


_TAG: Final = "element="
"""Begins the part of an error's place that shows which member of a union it is in."""


def refuse_rivals(record: BaseModel) -> None:
    """Refuse a record that gives two of its fields of which there may be one.

    Raises
    ------
    InputError
        Naming both.
    """
    given = [name for name in type(record).model_fields if getattr(record, name) is not None]
    for index, name in enumerate(given):
        for before in given[:index]:
            if before in replaced(type(record), name) and name in replaced(type(record), before):
                raise InputError(
                    phrase(marked("cannot be combined with {before}"), before=before), field=name
                )


@cache
def replaced(record: type[BaseModel], field: str) -> tuple[str, ...]:
    """Return what a value of a field takes the place of: fields of the record, or dotted ones."""
    marks = (mark for mark in record.model_fields[field].metadata if isinstance(mark, Replaces))
    names = dict.fromkeys(name for mark in marks for name in mark.names if name != field)
    return tuple(names)


@cache
def meanings(record: type[BaseModel]) -> Mapping[str, str]:
    """Return what each field of a record means, from the parameters of its docstring."""
    lines = inspect.cleandoc(record.__doc__ or "").split("\n")
    found: dict[str, list[str]] = {}
    names: list[str] = []
    for line in lines:
        if line.startswith(" "):
            for name in names:
                found[name].append(line.strip())
        else:
            names = re.split(r", ", line)
            names = names if all(name in record.model_fields for name in names) else []
            found.update({name: [] for name in names})
    return {name: " ".join(text) for name, text in found.items()}


def _plain_error(error: ValidationError, model: type[BaseModel]) -> InputError:
    """Return the most specific of pydantic's findings, in our words."""
    # A misspelt key is also a missing one: tell of the misspelling. Another element has other keys.
    found = min(
        error.errors(include_url=False),
        key=lambda e: (e["loc"][-1:] != ("element",), e["type"] != "extra_forbidden"),
    )
    place = tuple(map(str, found["loc"]))
    path = tuple(part for part in place if not part.startswith(_TAG))
    tags = [part.removeprefix(_TAG) for part in place if part.startswith(_TAG)]
    parent = _model_at(model, path[:-1], *tags[-1:])
    if found["type"] == "extra_forbidden":
        return _unknown_key(path, parent, model)
    cause = found.get("ctx", {}).get("error")
    if isinstance(cause, InputError):
        return _completed(cause, path, parent, found["input"])
    value: Any = ABSENT if found["type"] == "missing" else found["input"]
    if found["type"] == "union_tag_invalid":
        path, value = (*path, "element"), value["element"]
    return InputError(
        _rule(found), field=".".join(path), value=value, example=example_of(parent, path)
    )


def _rule(found: ErrorDetails) -> str:
    template = _RULES.get(found["type"])
    if template is None:
        return found["msg"].replace(_TAG, "")
    values = found.get("ctx", {})
    choices = {  # 'one', 'two' or 'three'
        name: text.replace(_TAG, "").replace("'", "").replace(" or ", ", ")
        for name, text in values.items()
        if isinstance(text, str)
    }
    return said(template, **{**values, **choices})


def _completed(
    cause: InputError, path: tuple[str, ...], parent: type[BaseModel] | None, given: object
) -> InputError:
    """Return an error raised by a validator of ours, with the place where it happened."""
    full_path = (*path, cause.field) if cause.field else path
    known = cause.with_details(field=".".join(full_path))
    if not full_path:  # of the record itself, which has no value that can be shown
        return known
    if not cause.field:
        whole = not isinstance(given, list | tuple) or cause.value is ABSENT  # not one of several
        value = given if whole else cause.value
        known = known.with_details(value=value, example=example_of(parent, path) or None)
    return known


def _unknown_key(
    path: tuple[str, ...], parent: type[BaseModel] | None, model: type[BaseModel]
) -> UnknownKeyError:
    here = list(parent.model_fields) if parent is not None else []
    name = ".".join(path)
    others = [one for one in _dotted_names(model) if one != name]
    rule = said("is an unknown key; {guess}", guess=hint(name, others, here))
    return UnknownKeyError(rule, field=name)


@cache
def _dotted_names(model: type[BaseModel]) -> tuple[str, ...]:
    """The names of the fields of a record and of the records in it, not of those in lists."""
    found = []
    for leaf, field in model.model_fields.items():
        found.append(leaf)
        for inner in () if _is_list(field.annotation) else records_of(field.annotation):
            found += [f"{leaf}.{one}" for one in _dotted_names(inner)]
    return tuple(dict.fromkeys(found))


def _is_list(annotation: object) -> bool:
    return get_origin(annotation) is tuple or any(map(_is_list, get_args(annotation)))


def _model_at(
    model: type[BaseModel], path: tuple[str, ...], element: str = ""
) -> type[BaseModel] | None:
    """Return the record type that a path of field names, places and keys leads to.

    element: of the last member of a union on the path.
    """
    names = iter(path)
    for name in names:
        if name.isdigit():
            continue
        field = model.model_fields.get(name)
        found = records_of(field.annotation) if field is not None else ()
        if field is not None and get_origin(field.annotation) in (dict, Mapping):
            next(names, None)  # its key
        if not found:
            return None
        model = next((one for one in found if element in elements_of(one)), found[0])
    return model


def record_for(info: FieldInfo, given: object) -> type[Record] | None:
    """Return the record of a field, or of its entries, that a table would be read as; or None."""
    found = [record for record in records_of(info.annotation) if issubclass(record, Record)]
    if len(found) > 1 and isinstance(given, Mapping):
        marks = (mark.element_of for mark in info.metadata if isinstance(mark, ByElement))
        element_of = next(marks, None)
        element = given.get("element") or (element_of(given) if element_of else None)
        unknown = {record: given.keys() - record.model_fields for record in found}
        found.sort(
            key=lambda one: element not in elements_of(one) if element else len(unknown[one])
        )
    return found[0] if found else None


def elements_of(record: type[BaseModel]) -> tuple[str, ...]:
    """Return the rolling elements of which a record is; none of most."""
    field = record.model_fields.get("element")
    return get_args(field.annotation) if field is not None else ()


def records_of(annotation: object) -> tuple[type[BaseModel], ...]:
    """Return the records of which a field holds one, also where it may be absent; perhaps none."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return (annotation,)
    if get_origin(annotation) not in (Annotated, Union, UnionType, tuple, dict, Mapping):
        return ()
    return tuple(record for part in get_args(annotation) for record in records_of(part))


def example_of(parent: type[BaseModel] | None, path: tuple[str, ...]) -> str:
    """Return an example of a field as a line of a case file."""
    field = parent.model_fields.get(path[-1]) if parent is not None and path else None
    if field is None or not field.examples:
        return ""
    example = field.examples[0]
    is_text = isinstance(example, str) and not example.startswith("[")
    text = f'"{example}"' if is_text else str(example)
    text = text.lower() if isinstance(example, bool) else text
    return f"{path[-1]} = {text}"
