"""A use case as a record: what it asks for is described once, and every face is made of it.

A `Request` has a field for everything that may be given, each with an `Input` that says what it is
called, what it means and what it may be. The command line makes its options of them, the page its
form, the HTTP API the parameters of an address; `read` takes what was typed in any of them. An
error names the field; each face writes that in its own spelling.
"""

import inspect
import os
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from datetime import date
from math import isfinite
from typing import TYPE_CHECKING, Any, ClassVar, Final, Literal, Self, get_args

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler, model_validator
from pydantic_core import CoreSchema, core_schema

from rolamento.case.record import Record, meanings
from rolamento.errors import InputError, Phrase, arguments
from rolamento.io.json import dumps
from rolamento.io.writing import write_bytes, write_text
from rolamento.records import frozen
from rolamento.tasks.bearing import designated
from rolamento.tasks.parameters import quietly
from rolamento.units import Dimension, readable, refuse_thousands, to_si
from rolamento.words import manner, marked, said

if TYPE_CHECKING:
    from rolamento.document import Document

__all__ = ["DECIMAL_MARK", "FORCE", "PICTURE", "Input", "Product", "Request", "number_in"]

Kind = Literal[
    "text", "number", "count", "fraction", "frequency", "time", "quantity", "cost", "date",
    "switch", "choice", "choices", "list", "numbers", "values", "bearing", "shipped", "file",
    "files", "path", "paths", "target",
]  # fmt: skip
"""Kind of a value: text with or without a unit, a number, one of several, several of them.

Values are numbers or texts by a choice, or as ``KEY=VALUE``.

A bearing is a designation, or a case; at the computer itself also the name of a case file. Files
are the arguments of a command, a path is an option with the name of a file, and a target one with
that of a file to be written: no page and no program elsewhere may name one. What is shipped may be
read in the place of a file.
"""
PICTURE: Final = marked("Draw the result: a .png, .svg or .pdf file.")
_PARTED: Final = {
    ";": marked("Separate several with semicolons."),
    ",": marked("Separate several with commas."),
}
_OPTIONS: Final = marked("Options")
_OUTPUT: Final = marked("Output")
_LONGEST: Final = 300
_MOST: Final = 50
_GREATEST: Final = 1e300


@frozen
class Product:
    """A file that a use case may write beside its page, by an option of its own.

    Attributes
    ----------
    meaning
        marked
    make
        returns a text, or a picture, of a request and its result; None of one that has none
    is_picture
        whether it is one
    check
        refuses a request that cannot have it, before any work
    """

    meaning: str
    make: Callable[[Any, Any], Any]
    is_picture: bool = True
    check: Callable[[Any], None] | None = None


@frozen
class Input:
    """One thing that may be given: the annotation of a field of a `Request`.

    Attributes
    ----------
    label
        in English, where a page asks for it; what the field means stands in the docstring of its
        request
    kind
        what is typed
    group
        heading below which it stands, marked
    example
        of a value, as it is typed
    choices
        returns the values that it may have, with their labels, marked; those that are no words of
        a language are their own labels
    aliases
        what else may be typed for one of them, in lower case without accents
    dimension
        of a quantity
    between
        bounds of a number, or of each of several; they belong to it
    most
        of its values
    separator
        between the values of a list; "" where each is given by itself
    default
        as it is typed; empty where the task or the file decides
    essential
        whether it is seen at once
    on_page
        the meaning on a page, where that is another; marked
    at_computer
        whether no page asks for it
    of_case
        dotted name of the field of a case that it gives
    stands_alone
        whether a command takes it without an option
    option, metavar
        of the command line: its long name, or both of a switch with its opposite, where that is
        not the name of the field; and what stands for its value
    """

    label: str = ""
    kind: Kind = "text"
    group: str = ""
    example: str = ""
    choices: Callable[[], Mapping[str, str]] | None = None
    aliases: Mapping[str, str] | None = None
    dimension: Dimension | None = None
    between: tuple[float, float] | None = None
    most: int = _MOST
    separator: str = ";"
    default: str = ""
    essential: bool = False
    on_page: str = ""
    at_computer: bool = False
    of_case: str = ""
    stands_alone: bool = False
    option: str = ""
    metavar: str = ""

    @property
    def is_many(self) -> bool:
        """Whether it takes several values."""
        return self.kind in ("list", "numbers", "choices", "values", "files", "paths")

    @property
    def is_by_key(self) -> bool:
        """Whether it takes texts KEY=VALUE, or a mapping in their place."""
        return "=" in self.metavar

    @property
    def is_argument(self) -> bool:
        """Whether it is no option of a command, but stands by itself."""
        return self.kind in ("file", "files") or self.stands_alone

    @property
    def is_local(self) -> bool:
        """Whether only who sits at the computer is asked for it."""
        return self.names_files or self.at_computer or self.kind == "shipped"

    @property
    def names_files(self) -> bool:
        """Whether it is read from the disk, or written there."""
        return self.kind in ("file", "files", "path", "paths", "target")

    def long_option(self, name: str) -> str:
        """Return the long name of its option, the first of a switch; name: of its field."""
        return self.option.partition("/")[0] or f"--{name.replace('_', '-')}"

    def below(self, group: str) -> "Input":
        """Return it below another heading."""
        return replace(self, group=group)

    def described(self, name: str, meaning: str) -> dict[str, Any]:
        """Return it as plain data, in the language that is spoken; name, meaning: of its field."""
        choices = {} if self.choices is None else self.choices()
        sentences = (self.on_page or meaning, _PARTED[self.separator] if self._is_joined else "")
        return {
            "name": name,
            "label": said(self.label),
            "meaning": " ".join(said(one) for one in sentences if one),
            "kind": "text" if self.kind in ("quantity", "bearing") else self.kind,
            "example": self.example,
            "choices": [
                {"value": value, "label": said(label).strip() if label else value}
                for value, label in choices.items()
            ],
            "default": self.default,
            "essential": self.essential,
        }

    def value(self, given: Any) -> Any:
        """Return what was given, a text as it is typed or a value, as the use case takes it.

        SI units of frequencies, times and speeds, parts of one of fractions, a tuple of several.

        Raises
        ------
        InputError
            If it is not of its kind.
        """
        if self.kind == "files" and isinstance(given, str | os.PathLike):
            return (given,)
        if self.names_files or self.kind == "bearing":
            return given
        if given is None or (isinstance(given, str) and not given.strip()):
            return () if self.is_many else None
        if isinstance(given, date) and self.kind == "date":
            return given
        if isinstance(given, date) or (isinstance(given, Mapping) and not self.is_by_key):
            raise InputError(said("must be a number or text"), value=given)
        if self.kind == "values":
            return self._by_key(given)
        if isinstance(given, Mapping):  # which its request reads
            return given
        if self.is_many:
            return self._values(given)
        if not isinstance(given, str):
            return self._bounded(self._checked(given))
        if self._is_too_long(given):
            raise InputError(said("must be at most {most} characters long", most=_LONGEST))
        return self._bounded(self._read(given.strip()))

    def _text(self, given: Any) -> Any:
        if isinstance(given, int | float):
            raise InputError(said("must be text"), value=given)
        return self.value(given)

    def _bounded(self, number: Any) -> Any:
        """Return a number, if it lies within the bounds."""
        if self.between is not None and not self.between[0] <= number <= self.between[1]:
            low, high = (
                end if self.dimension is None else readable(end, self.dimension)
                for end in self.between
            )
            rule = said("must be at least {at_least} and at most {at_most}",
                        at_least=low, at_most=high)  # fmt: skip
            raise InputError(rule, value=number)
        return number

    def _is_too_long(self, given: str) -> bool:
        return len(given) > _LONGEST and not self.at_computer

    def typed(self, texts: Sequence[str]) -> Any:
        """Return texts as they are typed, each of several values perhaps, as `value` takes them."""
        return self.separator.join(texts) if self._is_joined else texts

    @property
    def _is_joined(self) -> bool:
        """Whether one text may have several of its values."""
        return self.kind in ("list", "numbers") and self.separator != ""

    def _values(self, given: Any) -> tuple[Any, ...]:
        if isinstance(given, str) and self._is_joined:
            given = [part.strip() for part in given.split(self.separator)]
        elif isinstance(given, str | int | float):
            given = (given,)
        elif len(given) > self.most and not self.at_computer:
            raise InputError(said("may be given at most {most} times", most=self.most))
        if any(self._is_too_long(one) for one in given if isinstance(one, str)):
            raise InputError(said("must be at most {most} characters long", most=_LONGEST))
        if self.kind == "choices":
            return tuple(dict.fromkeys(self._chosen(one) for one in given))

        given = [one for one in given if one != ""]
        if any(one is None or isinstance(one, bool | Mapping | list | tuple) for one in given):
            raise InputError(said("must be a number or text"))
        if self.kind == "numbers" and len(given) > self.most:
            raise InputError(said("may be given at most {most} times", most=self.most))
        if self.kind == "numbers":
            read = (number_in(part) if isinstance(part, str) else self._checked(part)
                    for part in given)  # fmt: skip
            return tuple(dict.fromkeys(map(self._bounded, read)))
        return tuple(given)

    def _by_key(self, given: Mapping[str, Any] | Sequence[str]) -> dict[str, Any]:
        known = {} if self.choices is None else self.choices()
        pairs: dict[str, Any] = {}
        if isinstance(given, Mapping):
            pairs |= given
        else:
            texts = given if isinstance(given, list | tuple) else (given,)
            parted = (str(one).partition("=") for one in texts)
            pairs |= {key: value if equals else None for key, equals, value in parted}
        for key, value in pairs.items():
            if key not in known or value is None:
                rule = said("must be KEY=VALUE; KEY is one of {known}", known=", ".join(known))
                raise InputError(rule, value=key if value is None else f"{key}={value}")
            if not isinstance(value, str):
                self._checked(value)
        return pairs

    def _checked(self, given: Any) -> Any:
        """Return a value that is no text, if it is of the kind."""
        if self.kind == "switch":
            if not isinstance(given, bool):
                raise InputError(said("must be true or false"), value=given)
        elif isinstance(given, bool) or not isinstance(given, int | float):
            raise InputError(said("must be a number or text"), value=given)
        elif not abs(given) <= _GREATEST or (self.kind == "count" and given != int(given)):
            rule = said("must be an integer") if self.kind == "count" else said("must be a number")
            raise InputError(rule, value=given)
        if self.kind == "count":
            return int(given)
        return self._chosen(str(given)) if self.kind == "choice" else given

    def _read(self, text: str) -> Any:
        if self.kind == "choice":
            return self._chosen(text)
        if self.kind == "shipped":
            return self._chosen(text.casefold().replace("_", "-"))
        if self.kind == "switch":
            if text not in ("true", "false"):
                raise InputError(said("must be true or false"), value=text)
            return text == "true"
        if self.dimension is not None:
            refuse_thousands(text)
            try:
                return to_si(text, self.dimension)
            except InputError as error:
                raise error.with_details(value=text, example="") from None
        if self.kind in ("frequency", "time"):
            from rolamento.tasks.quantities import number_given

            return number_given(_with_point(text), "", self.kind, "")
        if self.kind == "fraction":
            from rolamento.tasks.quantities import part_of_one

            return part_of_one(_with_point(text), "", "")
        if self.kind == "cost":
            return cost_of(text)
        if self.kind in ("number", "count"):
            return number_in(text, whole=self.kind == "count")
        return text

    def _chosen(self, text: str) -> str:
        from rolamento.io.columns import folded_name

        known = {} if self.choices is None else self.choices()
        text = (self.aliases or {}).get(folded_name(text), text)
        if text not in known:
            rule = said("must be one of {known}", known=", ".join(known))
            raise InputError(rule, value=text)
        return text

    def __get_pydantic_core_schema__(
        self, source: object, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        """Have pydantic read the field with this object; a number only where its type has one."""
        is_text = str in (source, *get_args(source)) and not {int, float} & {*get_args(source)}
        read = self._text if is_text and self.kind in ("text", "choice") else self.value
        return core_schema.no_info_plain_validator_function(read)

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        """Describe what it takes in JSON: a number in SI units, or text as it is typed."""
        text: dict[str, Any] = {"type": "string", "maxLength": _LONGEST}
        if self.choices is not None:
            text = {"type": "string", "enum": list(self.choices())}
        if self.kind == "values":
            either = {"anyOf": [{"type": "string"}, {"type": "number"}]}
            return {"type": "object", "propertyNames": text, "additionalProperties": either}
        if self.is_many:
            either = text if self.kind == "choices" else {"anyOf": [{"type": "number"}, text]}
            return {"type": "array", "items": either, "maxItems": self.most}
        kind = {"switch": "boolean", "count": "integer"}.get(self.kind, "number")
        number: dict[str, Any] = {"type": kind}
        if self.between is not None:
            number["minimum"], number["maximum"] = self.between
        is_text = self.kind in ("text", "choice", "date")
        return text if is_text else {"anyOf": [number, text]}


def _marks() -> Mapping[str, str]:
    return {"point": marked("point: 12.5"), "comma": marked("comma: 12,5")}


FORCE: Final = Input("", "switch")
DECIMAL_MARK: Final = Input(
    "Decimal mark", "choice", choices=_marks, example="comma", metavar="MARK"
)


class Request(Record):
    """A use case: everything that it may be given, and how it is run.

    Raises
    ------
    InputError
        From the constructor, naming the field, the value, the rule and an example.
    """

    products: ClassVar[Mapping[str, Product]] = {}
    """Files beside the page, by the names of their options."""
    json_meaning: ClassVar[str] = "Write everything as JSON, in SI units"
    """What JSON of the result is; "" where there is none."""
    shows_page: ClassVar[bool] = True
    """Whether its page and the tables on it may be written to files, beside its target."""
    says_written: ClassVar[bool] = False
    """Whether its page or what closes it names its target already."""
    examples: ClassVar[str] = ""
    """Command lines, for its help."""
    waiting: ClassVar[str] = marked("Calculating")
    """What a progress bar says, marked."""
    counts: ClassVar[bool] = True
    """Whether it says how far it is."""
    headings: ClassVar[tuple[str, ...]] = ()
    """Order of the headings of the fields, marked; that of the fields by default."""
    columns: ClassVar[frozenset[str]] = frozenset()
    """Fields that name columns: what is said of a file may be of its column so called."""
    needs_file: ClassVar[bool] = True
    """Whether a file must be given, or an example that is shipped."""
    ships: ClassVar[bool] = False
    """Whether examples are shipped, which its field ``example`` names."""
    takes_case: ClassVar[bool] = False
    """Whether load, speed and any other field of a case may be given as well, as ``changes``."""

    def __init__(self, /, **fields: Any) -> None:
        try:
            super().__init__(**fields)
        except InputError as error:
            raise self._with_example(error) from None

    __init__.__pydantic_base_init__ = True  # type: ignore[attr-defined]

    @classmethod
    def inputs(cls) -> dict[str, Input]:
        """Return what may be given, by the names of the fields, in their order."""
        return {
            name: mark
            for name, field in cls.model_fields.items()
            for mark in field.metadata
            if isinstance(mark, Input)
        }

    @classmethod
    def summary(cls) -> str:
        """Return what it does: a line, and perhaps further paragraphs."""
        return re.split(r"\n\n(?:Parameters|>>>)", inspect.cleandoc(cls.__doc__ or ""))[0]

    @classmethod
    def meanings(cls) -> dict[str, str]:
        """Return what each field means, from the docstrings of the request and of its bases."""
        return {
            name: meaning
            for base in reversed(cls.__mro__)
            if issubclass(base, Request)
            for name, meaning in meanings(base).items()
        }

    @classmethod
    def options_by_heading(cls) -> dict[str, tuple[str, ...]]:
        """Return the names of the options below each heading, marked."""
        found: dict[str, tuple[str, ...]] = dict.fromkeys(cls.headings, ())
        for name, one in cls.inputs().items():
            if not one.is_argument:
                heading = one.group or (_OUTPUT if one.kind == "target" else _OPTIONS)
                found[heading] = (*found.get(heading, ()), name)
        return found

    @classmethod
    def described(cls, *headings: str) -> list[dict[str, Any]]:
        """Return what a form is made of: the headings, or some of them, and what is below each."""
        inputs, means = cls.inputs(), cls.meanings()
        return [
            {
                "label": said(heading),
                "options": [
                    inputs[name].described(name, means[name])
                    for name in names
                    if not inputs[name].is_local
                ],
            }
            for heading, names in cls.options_by_heading().items()
            if not headings or heading in headings
        ]

    @classmethod
    def read(cls, typed: Mapping[str, Sequence[str]], **own: Any) -> Self:
        """Return the request that was typed; what is left empty has its default.

        Parameters
        ----------
        typed
            Texts by the names of fields; several only where several may be given.
        own
            Values of fields that nobody types.

        Raises
        ------
        InputError
            For a name that is not asked for, or a value that is not of its kind.
        """
        known = {name: one for name, one in cls.inputs().items() if not one.is_local}
        for name in typed:
            if name not in known:
                rule = said("is not asked for here; known: {known}", known=", ".join(known))
                raise InputError(rule, field=name)
        found: dict[str, Any] = {}
        for name, one in known.items():
            texts = [text for text in typed.get(name, ()) if text.strip()]
            if one.kind == "switch" and not one.default and texts == ["false"]:
                continue  # as it stands on a page that nobody has touched
            texts = texts or ([one.default] if one.default else [])
            if texts and one.kind == "bearing":
                found[name] = designated(texts[-1].strip(), name)
            elif texts:
                found[name] = one.typed(texts) if one.is_many else texts[-1]
        return cls(**{**found, **own})

    def run(self, progress: Any = quietly) -> Any:
        """Do it; progress: called with how much is done, and of how much."""
        raise NotImplementedError

    @property
    def lasts(self) -> bool:
        """Whether it may take hours, and keeps what is done when it is ended."""
        return False

    @property
    def target(self) -> str | None:
        """Name of the file that the result itself is written to; None where a page is all."""
        return None

    def check_target(self, path: str) -> None:
        """Refuse a name that ends as no such file.

        Raises
        ------
        InputError
            If it does.
        """

    @model_validator(mode="after")
    def _writes_where_it_can(self) -> Self:
        if self.target is not None:
            try:
                self.check_target(self.target)
            except InputError as error:
                raise error.with_details(source="", field="output", value=self.target) from None
        return self

    def content(self, found: Any) -> str | bytes:
        """Return what stands in that file."""
        raise NotImplementedError

    def write(self, found: Any, path: str) -> None:
        """Write it; a request whose `run` has written it does nothing.

        Raises
        ------
        InputError, FileError
            If it cannot be written, or is there and may not be overwritten.
        """
        content, is_new = self.content(found), not getattr(self, "force", True)
        if isinstance(content, bytes):
            write_bytes(content, path, new=is_new)
        else:
            write_text(content, path, new=is_new)

    def page(self, found: Any) -> "Document":
        """Return what people read of a result."""
        return found.page()  # type: ignore[no-any-return]

    def has_page(self, found: Any) -> bool:
        """Return whether a result has a page."""
        return True

    def closing(self, found: Any) -> str:
        """Return what they read behind the page, or in its place, as it is."""
        return ""

    def report(self, found: Any) -> "Callable[[], Document] | None":
        """Return what makes the page of a report, where that is more than `page`."""
        return None

    def complaint(self, found: Any) -> str:
        """Return why there is no result, for who reads the data alone; "" if there is one."""
        return str(found.complaint)

    def has_result(self, found: Any) -> bool:
        """Return whether there is one."""
        return not self.complaint(found)

    def json_text(self, found: Any) -> str:
        """Return everything as JSON."""
        return dumps(found.to_mapping(), indent=2)

    @classmethod
    def shipped_text(cls, name: str) -> str:
        """Return an example that is shipped, by its name, as a table."""
        raise NotImplementedError

    @classmethod
    def _with_example(cls, error: InputError) -> InputError:
        """Give an error about a field an example, written as an argument."""
        one = cls.inputs().get(error.field)
        if one is None or not (error.example or one.example) or isinstance(error.example, Phrase):
            return error
        example = error.example or one.example
        return error.with_details(example=arguments(**{error.field: example}))


def number_in(text: str, *, whole: bool = False) -> float | int:
    """Return the number of a text, its decimal mark a point or a comma.

    Raises
    ------
    InputError
        If it is none.
    """
    try:
        value = float(_with_point(text))
    except ValueError:
        value = float("nan")
    if not isfinite(value) or (whole and (value != int(value) or abs(value) > 1e9)):
        rule = said("must be an integer") if whole else said("must be a number")
        raise InputError(rule, value=text)
    return int(value) if whole else value


def cost_of(text: str) -> float:
    """Return a cost; 12.000 and 12.000,00 as the language that is spoken writes them.

    Raises
    ------
    InputError
        If it is no number, or may be two.
    """
    from rolamento.io.numerals import Numerals

    refuse_thousands(text, units=("",))
    comma = "," in text and manner().mark == ","
    cost = Numerals(True, "comma" if comma else "point").number(text.strip())
    if cost is None:
        raise InputError(said("must be a number"), value=text)
    return cost


def _with_point(text: str) -> str:
    """Return a number with a decimal comma as one with a point, whatever language is spoken."""
    return text.replace(",", ".") if text.count(",") == 1 and "." not in text else text
