"""Frozen records, printed in at most ten lines.

`frozen` makes a frozen dataclass with slots. What a record prints is for a person at a prompt: a
small one stands on one line as a dataclass does; of a large one each field has a line, an array its
range and shape, and a record within it its beginning. Nothing reads it back.

`Lazily` is what a record holds whose parts take long and are seldom all looked at.

A command makes some 140 classes of records before its first answer. `dataclasses` writes five
methods for each and has them compiled in every process; here that is one, ``__init__``, and what
refuses a change, compares and copies is the same for all (decision 53).
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import MISSING, FrozenInstanceError, dataclass, field, fields
from functools import partial
from math import isfinite, nan
from numbers import Number
from operator import attrgetter
from typing import Any, Final, NoReturn, TypeVar, dataclass_transform, overload

__all__ = ["Lazily", "concise", "frozen", "span"]

T = TypeVar("T")

_LINES: Final = 10
_WIDTH: Final = 96
_FEW: Final = 4
"""Items of a sequence or an array that are printed one by one."""


@overload
def frozen(cls: type[T], /) -> type[T]: ...
@overload
def frozen(
    *, eq: bool = True, kw_only: bool = False, slots: bool = True, init: bool = True
) -> Callable[[type[T]], type[T]]: ...
@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def frozen(cls: type[T] | None = None, /, **options: bool) -> Any:
    """Make a frozen dataclass with slots that prints itself in at most ten lines.

    Parameters
    ----------
    cls
        The class; options are those of `dataclasses.dataclass`. ``eq=False`` for what holds
        arrays, ``slots=False`` for what caches a property.
    """
    return partial(_frozen, **options) if cls is None else _frozen(cls, **options)


def _frozen(
    cls: type[Any], /, eq: bool = True, kw_only: bool = False, slots: bool = True, init: bool = True
) -> Any:
    own = frozenset(vars(cls))
    made: Any = dataclass(init=False, repr=False, eq=False, kw_only=kw_only, slots=slots)(cls)
    methods: dict[str, Any] = {
        "__repr__": concise,
        "__setattr__": _refused,
        "__delattr__": _refused,
    }
    if init:
        methods["__init__"] = _Init(made)
    if eq:
        methods["__eq__"], methods["__hash__"] = _comparison_of(made)
    if slots:
        methods |= {"__getstate__": _state, "__setstate__": _set_state}
    for name, method in methods.items():
        if name not in own:
            setattr(made, name, method)
    return made


def _refused(self: object, name: str, value: object = None) -> NoReturn:
    raise FrozenInstanceError(f"field {name!r} of a {type(self).__name__} does not change")


def _state(self: Any) -> list[Any]:
    return [getattr(self, one.name) for one in fields(self)]


def _set_state(self: Any, state: list[Any]) -> None:
    for one, value in zip(fields(self), state, strict=True):
        object.__setattr__(self, one.name, value)


def _comparison_of(cls: Any) -> tuple[Callable[..., Any], Callable[..., Any]]:
    """Return what compares two records of one class by their fields, and what hashes one."""
    compared = _getter([one.name for one in fields(cls) if one.compare])
    kept = _getter([
        one.name for one in fields(cls) if (one.compare if one.hash is None else one.hash)
    ])  # fmt: skip

    def equal(self: object, other: object) -> Any:
        same = other.__class__ is self.__class__
        return compared(self) == compared(other) if same else NotImplemented

    def hashed(self: object) -> int:
        return hash(kept(self))

    return equal, hashed


def _getter(names: Sequence[str]) -> Callable[[Any], tuple[Any, ...]]:
    if len(names) > 1:  # else `attrgetter` gives no tuple
        return attrgetter(*names)
    return lambda record: tuple(getattr(record, name) for name in names)


class _Init:
    """The ``__init__`` of a record, which is written when it is first asked for.

    Half of the records that a command imports are never made.
    """

    def __init__(self, cls: Any) -> None:
        self._cls = cls
        self._names = vars(sys.modules[cls.__module__])  # of a script, it may be gone by then

    def __get__(self, record: object, cls: Any) -> Any:
        self._cls.__init__ = init = _init_of(self._cls, self._names)
        return init if record is None else init.__get__(record, cls)


class _Made:
    """Stands in a signature for what is made anew for every record."""

    def __repr__(self) -> str:
        return "<made>"


def _init_of(cls: Any, names: dict[str, Any]) -> Callable[..., None]:
    """Write the ``__init__`` of a record: what a dataclass has, in one piece of code.

    names: of the module that it is of.
    """
    known: dict[str, Any] = {"_set": object.__setattr__, "_made": _Made()}
    by_place: list[str] = []
    by_name: list[str] = []
    lines = []
    for one in fields(cls):
        parameter = value = one.name
        if one.default_factory is not MISSING:
            known[f"_make_{value}"] = one.default_factory
            parameter = f"{value}=_made"
            value = f"_make_{value}() if {value} is _made else {value}"
        elif one.default is not MISSING:
            known[f"_default_{value}"] = one.default
            parameter = f"{value}=_default_{value}"
        (by_name if one.kw_only else by_place).append(parameter)
        lines.append(f"_set(self, {one.name!r}, {value})")
    if hasattr(cls, "__post_init__"):
        lines.append("self.__post_init__()")
    parameters = ", ".join(("self", *by_place, *(("*", *by_name) if by_name else ())))
    body = "\n  ".join(lines) or "pass"
    code = (
        f"def make({', '.join(known)}):\n def __init__({parameters}):\n  {body}\n return __init__"
    )
    written: dict[str, Any] = {}
    exec(code, names, written)
    init: Callable[..., None] = written["make"](**known)
    init.__annotations__ = {**{one.name: one.type for one in fields(cls)}, "return": None}
    init.__qualname__ = f"{cls.__qualname__}.__init__"
    return init


class Lazily(Mapping[str, T]):
    """Values by their names, each found when it is first looked up.

    Parameters
    ----------
    names
        In the order in which they stand.
    find
        Returns the value of a name.
    """

    def __init__(self, names: Iterable[str], find: Callable[[str], T]) -> None:
        self._find = find
        self._found: dict[str, T | None] = dict.fromkeys(names)

    def __getitem__(self, name: str) -> T:
        found = self._found[name]
        if found is None:
            found = self._found[name] = self._find(name)
        return found

    def __contains__(self, name: object) -> bool:
        return name in self._found

    def __iter__(self) -> Iterator[str]:
        return iter(self._found)

    def __len__(self) -> int:
        return len(self._found)

    def __reduce__(self) -> Any:
        return dict, (dict(self),)  # as it travels: all found, without what that takes


def concise(record: Any) -> str:
    """Print a record in at most ten lines.

    What a record shows of itself are its fields; or those that its method ``_printed`` gives, or
    the lines of ``_shown``, a mapping of names to texts, of which the name ``""`` is its title.

    >>> @frozen
    ... class Contact:
    ...     load: float
    ...     angle: float
    >>> Contact(1200.0, 0.26)
    Contact(load=1200.0, angle=0.26)
    """
    name = type(record).__name__
    if hasattr(record, "_shown"):
        return _lines(name, record._shown().items())
    parts = list(_fields(record))
    inline = f"{name}({', '.join(f'{key}={_inline(value)}' for key, value in parts)})"
    if len(inline) <= _WIDTH and "\n" not in inline:
        return inline
    return _lines(name, ((key, _short(value)) for key, value in parts if value is not None))


def span(values: Any, unit: str = "") -> str:
    """Print numbers by their range: ``"1.2 to 3.4 N"``, a single one as itself, NaN left out."""
    known = [value for value in _flat(values) if isfinite(value)]
    low, high = (min(known), max(known)) if known else (nan, nan)
    first, last = _four_digits(low), _four_digits(high)
    text = first if first == last else f"{first} to {last}"
    return f"{text} {unit}".rstrip()


def _four_digits(value: float) -> str:
    text = f"{value:.0f}" if 1e4 <= abs(value) < 1e7 else f"{value:.4g}"
    return "0" if text == "-0" else text


def _lines(name: str, parts: Iterable[tuple[str, str]]) -> str:
    lines = []
    for key, text in parts:
        if key:
            lines.append(f"  {key}: {text}")
        else:
            name = f"{name}: {text}"
    if len(lines) >= _LINES:
        rest = (line.strip().partition(":")[0] for line in lines[_LINES - 2 :])
        lines[_LINES - 2 :] = [f"  and {', '.join(rest)}"]
    return "\n".join(_cut(line.replace("\n", " ")) for line in (name, *lines))


def _fields(record: Any) -> Iterator[tuple[str, Any]]:
    if hasattr(record, "_printed"):
        yield from record._printed()
        return
    for one in fields(record):
        if one.repr and not one.name.startswith("_"):
            yield one.name, getattr(record, one.name)


def _inline(value: Any) -> str:
    """Print a value as a dataclass does, but for what would be long."""
    if hasattr(value, "shape") and hasattr(value, "dtype"):
        return str(value.tolist()) if value.size <= _FEW else "…" * _WIDTH
    if isinstance(value, str) or (isinstance(value, Sequence | Mapping) and len(value) > _FEW):
        return repr(value) if len(value) <= _WIDTH else "…" * _WIDTH
    return repr(value)


def _short(value: Any) -> str:
    """Print a value in a part of a line."""
    if isinstance(value, str):
        return value
    if hasattr(value, "shape") and hasattr(value, "dtype"):
        return _of_array(value)
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, Mapping):
        return ", ".join(map(str, value)) or "none"
    if isinstance(value, Sequence | frozenset | set):
        items = list(value)
        if not items:
            return "none"
        if len(items) > _FEW and not isinstance(items[0], Number | str):
            return f"{len(items)} of {type(items[0]).__name__}"
        return ", ".join(_cut(_short(item), _WIDTH // 2) for item in items)
    if getattr(type(value), "__repr__", None) is concise:
        parts = (f"{key}={_short(own)}" for key, own in _fields(value) if own is not None)
        return f"{type(value).__name__}({', '.join(parts)})"
    return repr(value)


def _of_array(array: Any) -> str:
    if array.dtype.kind not in "fiu":
        return _short(array.tolist()) if array.size <= _FEW else f"array of shape {array.shape}"
    if array.size <= _FEW:
        return ", ".join(f"{value:.6g}" for value in _flat(array))
    return f"{span(array)}, shape {array.shape}"


def _flat(values: Any) -> list[float]:
    return [float(value) for value in values.ravel()] if hasattr(values, "ravel") else [*values]


def _cut(text: str, width: int = _WIDTH) -> str:
    return text if len(text) <= width else f"{text[: width - 1]}…"
