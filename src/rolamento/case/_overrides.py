"""Settings such as ``duty.load.fz=10 kN``, put over the mapping of a case file.

They are applied before anything is validated, so that a setting can put right what
would be refused, and what replaces a rival (a clearance for a contact angle, a
displacement for a load) takes its place.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, Final, Literal, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from rolamento.case.arrangement import PRELOAD_KINDS, Preload
from rolamento.case.duty import AXES, LOADS
from rolamento.case.life_model import DIRT
from rolamento.case.lubricant import Lubricant, lubricant_table
from rolamento.case.material import Material
from rolamento.case.record import record_of
from rolamento.errors import InputError, UnknownKeyError, nearest

__all__ = ["OVERRIDE_SOURCE", "overridden"]

OVERRIDE_SOURCE: Final = "--set"

_EXAMPLE: Final = 'duty.load.fz="10 kN"'
_LONGEST_SETTING: Final = 300

Path = tuple[str, ...]


_SHORTHANDS: Final = (Material, Preload, Lubricant)
"""Tables that may be given as text as well."""


_LUBRICANT_RIVALS: Final = (
    ("viscosity_40", "viscosities", "base_oil"),
    ("viscosity_100", "viscosity_index"),
    ("pressure_viscosity", "pressure_viscosity_method"),
)


_MOUNTING_RIVALS: Final = (
    ("clearance_class", "measured_clearance"),
    ("shaft_tolerance", "shaft_interference"),
    ("housing_tolerance", "housing_interference"),
    ("shaft_finish", "shaft_roughness"),
    ("housing_finish", "housing_roughness"),
)


_DIRT_PARTNERS: Final = {"cleanliness": "oil_supply", "filter_size": "filter_ratio"}


def _rivals() -> dict[Path, tuple[Path, ...]]:
    preload = ("bearing", "preload")
    groups: list[tuple[Path, ...]] = [
        (("bearing", "contact_angle"), ("bearing", "diametral_clearance")),
        (("bearing", "arrangement"), ("bearing", "rows")),
        tuple((*preload, name) for name in PRELOAD_KINDS),
        *(tuple(("lubricant", name) for name in rivals) for rivals in _LUBRICANT_RIVALS),
        *(tuple(("mounting", name) for name in rivals) for rivals in _MOUNTING_RIVALS),
        tuple(("life", name) for name in DIRT),
    ]
    for axis, load in zip(AXES, LOADS, strict=True):
        groups.append((("duty", "load", load), ("duty", "displacement", axis)))
    rivals = {
        one: tuple(other for other in group if other != one) for group in groups for one in group
    }
    for name in ("force", "offset", "spring"):
        rivals[*preload, name] += ((*preload, "designation"),)
    rivals["bearing", "rows"] += (("bearing", "spacing"),)
    for name in DIRT:
        rivals["life", name] += tuple(
            ("life", partner) for other, partner in _DIRT_PARTNERS.items() if other != name
        )
    # another bearing of the catalogue has other balls, another size and other ratings
    rivals["bearing", "designation"] = (
        *(("bearing", name) for name in ("ball_count", "ball_diameter", "pitch_diameter")),
        *((part, name) for part in ("mounting", "film") for name in ("bore", "outside_diameter")),
        *(("life", name) for name in ("dynamic_rating", "static_rating")),
    )
    return rivals


_RIVALS: Final = _rivals()


def overridden(
    mapping: Mapping[str, Any], settings: Iterable[str], model: type[BaseModel]
) -> tuple[dict[str, Any], frozenset[str]]:
    """Return a copy of a mapping with settings applied, and the fields that they set.

    Parameters
    ----------
    mapping
        The tables of a case file.
    settings
        Each ``KEY=VALUE``, with a dotted key and the value as in a case file; the
        quotes around text may be left out.
    model
        The record that the mapping describes.

    Raises
    ------
    InputError
        If a setting is not of that form, or its key names no field.
    """
    result = dict(mapping)
    paths: set[Path] = set()
    for setting in settings:
        path, text = _split(setting)
        value = _value(text, _field(path, model))
        if path[:-1] == ("bearing", "preload") and path[:-1] not in paths:
            _remove_text(result, path[:-1])
        if path[:-1] == ("lubricant",):
            _open_lubricant(result)
        for rival in _RIVALS.get(path, ()):
            if rival not in paths:
                _remove(result, rival)
        _put(result, path, value)
        paths.add(path)
    return result, frozenset(".".join(path) for path in paths)


def _split(setting: str) -> tuple[Path, str]:
    key, equals, text = setting.partition("=")
    if not equals or not key.strip() or len(setting) > _LONGEST_SETTING:
        raise InputError(
            "must be KEY=VALUE", value=setting, source=OVERRIDE_SOURCE, example=_EXAMPLE
        )
    return tuple(part.strip() for part in key.split(".")), text.strip()


def _field(path: Path, model: type[BaseModel]) -> FieldInfo:
    """Return the field that a path leads to; it must not be a whole table."""
    field = _found(path, 1, model.model_fields)
    for depth in range(2, len(path) + 1):
        _refuse_list(path[: depth - 1], field)
        field = _found(path, depth, _fields_of(field))
    _refuse_list(path, field)
    inner = _fields_of(field)
    if inner and record_of(field.annotation) not in _SHORTHANDS:
        raise InputError(
            f"is a table; set one of its fields: {', '.join(inner)}",
            field=".".join(path),
            source=OVERRIDE_SOURCE,
            example=_EXAMPLE,
        )
    return field


def _refuse_list(path: Path, field: FieldInfo) -> None:
    """A list of tables is too long for a setting."""
    record = record_of(field.annotation)
    if record is not None and record not in _SHORTHANDS and _is_list(field.annotation):
        raise InputError(
            "is a list; give it in the file",
            field=".".join(path),
            source=OVERRIDE_SOURCE,
            example=_EXAMPLE,
        )


def _is_list(annotation: object) -> bool:
    return get_origin(annotation) is tuple or any(map(_is_list, get_args(annotation)))


def _found(path: Path, depth: int, fields: Mapping[str, FieldInfo]) -> FieldInfo:
    field = fields.get(path[depth - 1])
    if field is None:
        raise _unknown(path, depth, fields)
    return field


def _fields_of(field: FieldInfo) -> dict[str, FieldInfo]:
    table = record_of(field.annotation)
    return {} if table is None or get_origin(field.annotation) is tuple else table.model_fields


def _unknown(path: Path, depth: int, fields: Mapping[str, FieldInfo]) -> UnknownKeyError:
    near = nearest(path[depth - 1], fields)
    parent = ".".join(path[: depth - 1])
    known = f"known here: {', '.join(fields)}" if fields else f"{parent} is not a table"
    return UnknownKeyError(
        f"is not a known key; {f'did you mean {near}?' if near else known}",
        field=".".join(path),
        source=OVERRIDE_SOURCE,
        example=_EXAMPLE,
    )


def _value(text: str, field: FieldInfo) -> object:
    """Return the value that a setting's text stands for, as a file would have held it."""
    if len(text) >= 2 and text[0] == text[-1] and text[0] in "\"'":
        return text[1:-1]
    kind = field.annotation
    if kind is str or record_of(kind) is not None or _is_choice(kind):
        return text
    if text in ("true", "false"):
        return text == "true"
    for number in (int, float):
        try:
            return number(text)
        except ValueError:
            continue
    return text


def _is_choice(annotation: object) -> bool:
    return get_origin(annotation) is Literal or any(map(_is_choice, get_args(annotation)))


def _put(mapping: dict[str, Any], path: Path, value: object) -> None:
    """Set a value, copying the tables on its path: the caller's stay as they are."""
    table = mapping
    for depth, name in enumerate(path[:-1], start=1):
        inner = table.get(name, {})
        if not isinstance(inner, dict):
            raise InputError(
                "is not a table in this case; set it as a whole, or give a table in the file",
                field=".".join(path[:depth]),
                value=inner,
                source=OVERRIDE_SOURCE,
            )
        table[name] = table = dict(inner)
    table[path[-1]] = value


def _open_lubricant(mapping: dict[str, Any]) -> None:
    """Put the table of a lubricant in the place of its name, so that a field can be set in it."""
    if isinstance(mapping.get("lubricant"), str):
        mapping["lubricant"] = lubricant_table(mapping["lubricant"])


def _remove(mapping: dict[str, Any], path: Path) -> None:
    """Take a value away, if it is there, likewise."""
    table = mapping
    for name in path[:-1]:
        inner = table.get(name)
        if not isinstance(inner, dict):
            return
        table[name] = table = dict(inner)
    table.pop(path[-1], None)


def _remove_text(mapping: dict[str, Any], path: Path) -> None:
    """Take away what was given as text, so that a field of its table can take its place."""
    inner = mapping.get(path[0])
    if isinstance(inner, dict) and isinstance(inner.get(path[1]), str):
        _remove(mapping, path)
