"""The fields of a case as a form: groups, labels, units, bounds, choices; values with their origin.

Made from the records themselves (`Case.fields`); only what stands first, and which pairs of fields
an engineer moves with a slider, is said here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cache, partial
from typing import Any, Final

from rolamento.analysis import Analysis
from rolamento.case import Case
from rolamento.case.bearing import Bearing
from rolamento.case.fields import Field, fields_of, of_elements
from rolamento.case.labels import LABELS, choice_label, label_of
from rolamento.case.roller_bearing import RollerBearing
from rolamento.errors import InputError, respelled
from rolamento.life.iso281 import MAXIMUM_LOAD
from rolamento.pages.report import TABLES
from rolamento.solved.notes import SPEED_LIMIT
from rolamento.tasks.report import Input
from rolamento.types import BALL, ROLLER, TYPES
from rolamento.units import Dimension, from_si, to_si, usual_units
from rolamento.web.answers import written
from rolamento.words import language, said, spelling, unit_sign

__all__ = ["FIRST", "form", "in_labels", "inputs", "labelled", "likely", "suitable", "units"]

FIRST: Final = (
    "bearing.designation",
    "bearing.contact_angle",
    "bearing.diametral_clearance",
    "bearing.arrangement",
    "bearing.preload.force",
    "bearing.preload.spring",
    "bearing.preload.level",
    "bearing.preload.designation",
    "duty.inner_speed",
    "duty.load.fx",
    "duty.load.fz",
    "duty.load.fy",
    "duty.load.my",
    "duty.load.mz",
    "lubricant",
    "lubricant.base_oil",
    "lubricant.viscosity_40",
    "temperature.lubricant",
    "mounting.clearance_class",
    "mounting.shaft_tolerance",
    "mounting.housing_tolerance",
    "life.cleanliness",
    "life.required_life",
)
"""The fields that an engineer asks for first; the others of their group stand behind them."""

_GROUPS: Final = (
    "bearing", "duty", "lubricant", "temperature", "surface", "mounting", "heat", "grease",
    "static", "electrical", "losses", "life", "film", "model",
)  # fmt: skip
"""Tables of a case, those first that an engineer fills in first."""
_CUSTOMARY: Final[Mapping[Dimension, tuple[str, ...]]] = {
    "force": ("lbf",),
    "moment": ("lbf in",),
    "stress": ("ksi",),
    "temperature": ("degF",),
}
"""Units that are read too, beside the usual ones of a dimension."""
_ELEMENTS: Final = {
    rolls: tuple(dict.fromkeys(one.element for one in TYPES.values() if one.rolls == rolls))
    for rolls in (BALL, ROLLER)
}
_MICROMETRES: Final = {"um": "µm"}
"""For keyboards without the sign; the form offers the sign alone."""
_OF_SETS: Final = ("bearing.preload", "bearing.spacing")
"""What a bearing that stands alone has not."""
_USUAL_PART: Final = 0.2
"""Part of the greatest likely value that an example asks for."""
_OF_MOMENT: Final = 0.05
"""Moment at the end of a slider, over rating and pitch diameter: a load beside the middle."""


def in_labels(
    function: Callable[[Mapping[str, Any]], Mapping[str, Any]], asked: Mapping[str, Any]
) -> str:
    """Return what a function answers as JSON; fields are called as the page labels them."""
    with spelling(partial(as_labelled, _labels(language()))):
        try:
            return written(function, asked)
        except InputError as error:
            raise labelled(error) from None


@cache
def _labels(_language: str) -> Mapping[str, str]:
    """What fields are called on the page, by their names, in the language that is spoken."""
    own = {name: f"“{label_of(name)}”" for name in LABELS if "." in name}
    return {**own, "rolamento catalogue show": said("the catalogue")}


def as_labelled(labels: Mapping[str, str], text: str) -> str:
    """Spell a name in a text, or one with a value, by its label (`rolamento.words.spelling`)."""
    name, equals, value = text.partition("=")
    return f"{labels.get(name, name)} {equals} {value}".rstrip()


def labelled(error: InputError) -> InputError:
    """Return a refusal that calls the fields beside its own as the page does."""
    table = error.field.rpartition(".")[0]
    beside = {
        name.rpartition(".")[2]: label
        for name, label in _labels(language()).items()
        if name.rpartition(".")[0] == table
    }
    error.rule = respelled(error.rule, beside)
    return error


def form() -> list[dict[str, Any]]:
    """Return the groups of fields, in the language that is spoken."""
    groups = {**{name: said(TABLES[name]) for name in _GROUPS}, "report": said("Report")}
    found: dict[str, list[dict[str, Any]]] = {key: [] for key in groups}
    for name, field in Case.fields().items():
        group = name.partition(".")[0]
        found["report" if group == "title" else group].append(_described(name, field))
    order = {name: place for place, name in enumerate(FIRST)}
    for fields in found.values():
        fields.sort(key=lambda one: order.get(one["name"], len(order)))
    return [{"key": key, "label": groups[key], "fields": fields} for key, fields in found.items()]


def _described(name: str, field: Field, table: str = "") -> dict[str, Any]:
    """What the page knows of a field; table: that a list of tables stands in, its entries alike."""
    holder = f"{name.rpartition('.')[0]}."
    alike = Case.fields().get(f"{table}{name}", field)
    return {
        "name": name,
        "label": alike.label,
        "meaning": field.meaning,
        "kind": field.kind,
        "dimension": field.dimension or "",
        "unit": _MICROMETRES.get(field.shown_unit, field.shown_unit),
        "choices": [
            {"value": one, "label": choice_label(f"{table}{name}", one)} for one in field.choices
        ],
        "suggestions": list(_named_like(name, field).names),
        "limits": {} if field.bounds is None else field.bounds.limits_in_si,
        "limits_text": field.limits,
        "example": field.example.strip('"') if field.kind != "list" else field.example,
        "replaces": list(field.replaces),
        "of": [kind for kind, elements in _ELEMENTS.items() if name in suitable(*elements)],
        "of_sets": name.startswith(_OF_SETS),
        "first": name in FIRST,
        "entries": [_described(leaf, own, holder) for leaf, own in field.entries.items()],
    }


def _named_like(name: str, field: Field) -> Field:
    """The field whose names a field takes: a base oil is a lubricant."""
    return Case.fields()["lubricant"] if name == "lubricant.base_oil" else field


@cache
def suitable(*elements: str) -> frozenset[str]:
    """Return the names of the fields that bearings with one of these elements have."""
    records = {Bearing if element == "ball" else RollerBearing for element in elements}
    own = {f"bearing.{name}" for record in records for name in fields_of(record)}
    return frozenset(
        name
        for name in Case.fields()
        if of_elements(name, elements) and (not name.startswith("bearing.") or name in own)
    )


@cache
def units() -> dict[str, list[dict[str, Any]]]:
    """Return the units of each dimension: value in SI = factor × number + offset."""
    dimensions = sorted({one.dimension for one in Case.fields().values() if one.dimension})
    return {dimension: list(_units_of(dimension)) for dimension in dimensions}


def _units_of(dimension: Dimension) -> Iterator[dict[str, Any]]:
    for unit in (*usual_units(dimension), *_CUSTOMARY.get(dimension, ())):
        if unit in _MICROMETRES:
            continue
        offset = to_si(f"0 {unit}", dimension) if dimension == "temperature" else 0.0
        yield {
            "unit": unit,
            "label": unit_sign(unit),
            "factor": to_si(f"1 {unit}", dimension) - offset,
            "offset": offset,
        }


def likely(analysis: Analysis) -> dict[str, dict[str, Any]]:
    """Return up to where the sliders of loads and speed go, and an example of each.

    Loads go to the half of the basic dynamic rating, the limit of its theory (ISO 281), speeds to
    the limiting speed of the catalogue, or to the n·d_m up to which the model holds. SI; empty for
    a field of which no limit is known.
    """
    case = analysis.solved.case
    published = case.bearing.published
    rating = getattr(published, "dynamic_rating", None)
    if analysis.life is not None:
        own = float(analysis.life.ratings.dynamic_of_set[0])
        rating = own if own > 0.0 else rating
    pitch = max(float(place.bearing.pitch_diameter) for place in case.bearing.places)
    found: dict[str, float] = {
        "duty.inner_speed": getattr(published, "limiting_speed", None) or SPEED_LIMIT / pitch
    }
    if rating:
        for name in ("fx", "fy", "fz"):
            found[f"duty.load.{name}"] = MAXIMUM_LOAD * float(rating)
        for name in ("my", "mz"):
            found[f"duty.load.{name}"] = _OF_MOMENT * float(rating) * pitch
    fields = Case.fields()
    return {
        name: {
            "most": most,
            "example": _rounded(_USUAL_PART * most, fields[name]),
        }
        for name, most in found.items()
    }


def _rounded(value: float, field: Field) -> str:
    """A value to one figure, in the unit in which people read the field."""
    unit = field.shown_unit
    factor = to_si(f"1 {unit}", field.dimension or "force")
    return f"{float(f'{value / factor:.1g}'):g} {unit}"


def inputs(known: Iterable[Input]) -> dict[str, dict[str, Any]]:
    """Return inputs of a case by their fields: in SI, as a file holds them, and their origins."""
    fields = Case.fields()
    found = {}
    for one in known:
        field, text = fields.get(one.field), str(one.value)
        if field is not None and field.dimension and not isinstance(one.value, bool | str):
            text = from_si(float(one.value), field.dimension)
        found[one.field] = {
            "value": one.value,
            "text": text,
            "origin": one.origin,
            "source": one.source,
        }
    return found
