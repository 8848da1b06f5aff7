"""A case file to start from: every field that there is, with what it means, most of them asleep."""

from __future__ import annotations

import math
import textwrap
import tomllib
from collections.abc import Iterator, Mapping
from importlib import resources
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final, Self, cast

from pydantic import model_validator

from rolamento.case import Case, parse_case
from rolamento.case.bearing import Bearing
from rolamento.case.fields import Field, changed, in_file_form, of_elements
from rolamento.case.machine import Machine
from rolamento.case.roller_bearing import RollerBearing
from rolamento.case.rolling_bearing import BY_ELEMENT, element_named
from rolamento.catalogue import catalogues
from rolamento.errors import InputError, arguments, phrase
from rolamento.tasks.case_request import Finding, FindingRequest
from rolamento.tasks.machines import CATALOGUES
from rolamento.tasks.parameters import Progress, quietly
from rolamento.tasks.request import FORCE, Input
from rolamento.units import from_si, readable
from rolamento.words import marked, said

if TYPE_CHECKING:
    from rolamento.catalogue import CatalogueBearing

__all__ = [
    "TABLES", "ExamplesRequest", "NewRequest", "case_template", "file_name", "machine_template",
    "machine_workbook",
]  # fmt: skip

TABLES: Final = {
    "": marked("Every value has its unit. Lines that begin with # are optional: what they show is "
               "an example, and goes into effect without the #. The other values are there to "
               "start with: put your own in their place."),
    "bearing": marked("The bearing. What a designation tells (balls or rollers, angle or clearance)"
                      " may be given over it."),
    "duty": marked("Speeds of the rings about the shaft's axis x."),
    "duty.load": marked("What the shaft puts on the inner ring: x along the shaft, z the usual "
                        "direction of the radial load. A moment of zero leaves the ring free to "
                        "tilt."),
    "duty.displacement": marked("Displacements that are imposed instead of loads. A tilt without "
                                "a moment or a value is held at zero."),
    "duty.oscillation": marked("A ring that swings to and fro in the place of speeds, for "
                               "`rolamento oscillation`."),
    "model": marked("Hypotheses of the calculation."),
    "lubricant": marked("Oil or grease: for film, friction and modified life."),
    "surface": marked("Roughness, for the film parameter."),
    "temperature": marked("Temperatures in operation."),
    "mounting": marked("Fits: with this table the bearing is solved with the clearance that fits, "
                       "temperatures and speed leave."),
    "film": marked("How the film thickness is calculated."),
    "grease": marked("The grease and how it is kept, for `rolamento grease`."),
    "heat": marked("Ways of the heat out of the bearing, for `rolamento heat`; conductances that "
                   "are not given are estimated."),
    "static": marked("Demands on the static safety, for `rolamento static`; hardness of the "
                     "raceways."),
    "electrical": marked("Voltage and current across the bearing, for `rolamento electrical`."),
    "losses": marked("Seals and oil bath, for the friction; seals are those of the designation."),
    "life": marked("Ratings, cleanliness and what is required of the life."),
    "report": marked("Title block of `rolamento report`."),
}  # fmt: skip
"""What stands above each table of a case, and above the whole."""

_WIDTH: Final = 88
_COMMENTS_FROM: Final = 40
_SPEED_FACTOR: Final = {True: 0.6, False: 0.15}
"""n·d_m in 10⁶ mm/min to start with, of spindle bearings and of others: of usual size, no limit."""
_SPINDLE_ANGLE: Final = math.radians(26.0)
_LOAD_SHARE: Final = 0.1
_LOAD: Final = 1000.0
"""To start with: this share of C, or this force (N) where no rating is known."""
_FRICTION: Final = ('model.raceway_control = "friction"',)
_REPLENISHED: Final = ('film.starvation = "replenishment"',)
_WITH: Final[Mapping[str, tuple[str, ...]]] = {
    "bearing.shim_angle": ("bearing.kind",),
    "bearing.preload": ("bearing.arrangement",),
    "model.traction": _FRICTION,
    "model.film_in_contact": _FRICTION,
    "lubricant.viscosity_100": ("lubricant.viscosity_40",),
    "lubricant.viscosity_index": ("lubricant.viscosity_40",),
    "temperature.shaft": ("mounting.shaft_tolerance",),
    "temperature.housing": ("mounting.housing_tolerance",),
    "temperature.inner_spacer": ("mounting.shaft_tolerance", "bearing.arrangement"),
    "temperature.outer_spacer": ("mounting.housing_tolerance", "bearing.arrangement"),
    "mounting.measuring_load": ("mounting.measured_clearance",),
    "mounting.inner_spacer_material": ("bearing.arrangement",),
    "mounting.outer_spacer_material": ("bearing.arrangement",),
    "film.inlet_distance": ('film.starvation = "inlet_distance"',),
    "film.supply": _REPLENISHED,
    "film.bore": _REPLENISHED,
    "film.outside_diameter": _REPLENISHED,
    "heat.oil_inlet": ("heat.oil_flow",),
    "life.oil_supply": ("life.cleanliness",),
    "life.filter_ratio": ("life.filter_size",),
}
"""What a field takes effect with, if it does not alone: the example of another field, or a value.
What is merely missing beside it, the case says itself."""
_MOST_NEEDED: Final = 6


class NewRequest(FindingRequest):
    """Write a commented case file to start from.

    It solves as it is, and shows every field that there is, with an example.

    Parameters
    ----------
    designation
        Designation such as 6310/C3; without it the bearing is given by its geometry.
    output
        File to write, by default named after the bearing; - is standard output.
    machine
        A machine file instead: shafts on their bearings; as a workbook if FILE ends in .xlsx.
    force
        Overwrite files that are there.
    catalogues
        A catalogue of your own, CSV or TOML, for designations.
    """

    designation: Annotated[
        str | None,
        Input(example="6310/C3", stands_alone=True, metavar="DESIGNATION"),
    ] = None
    output: Annotated[Any, Input("", "target", metavar="FILE")] = None
    machine: Annotated[bool, Input("", "switch")] = False
    force: Annotated[bool, FORCE] = False
    catalogues: Annotated[Any, CATALOGUES] = ()

    shows_page: ClassVar = False
    json_meaning: ClassVar = ""
    says_written: ClassVar = True
    examples: ClassVar = (
        "Examples: new 6310/C3; new 'S 6012 C' --lang pt -o spindle.toml; new --machine."
    )

    @property
    def target(self) -> str:
        """Name of the file; after the bearing where none is given."""
        usual = "machine.toml" if self.machine else file_name(self.designation)
        return str(self.output or usual)

    @property
    def _is_workbook(self) -> bool:
        return self.machine and self.target.lower().endswith(".xlsx")

    def check_target(self, path: str) -> None:
        """Refuse a name that ends otherwise."""
        if path != "-" and not self._is_workbook and not path.lower().endswith(".toml"):
            raise InputError(said("must end in .toml"), example="case.toml")

    @model_validator(mode="after")
    def _machine_of_no_bearing(self) -> Self:
        if self.machine and self.designation is not None:
            before = arguments(machine=...)
            rule = phrase(marked("cannot be combined with {before}"), before=before)
            raise InputError(rule, field="designation", value=self.designation)
        return self

    def run(self, progress: Progress = quietly) -> Finding:
        """Make it, a text, or the bytes of a workbook."""
        words = ["rolamento", "shaft" if self.machine else "solve", self.target]
        words += [word for own in self.catalogues for word in ("--catalogue", own)]
        text = said("Wrote {path}; now try: {command}", path=self.target, command=" ".join(words))
        with catalogues(self.catalogues):
            if self._is_workbook:
                made: str | bytes = machine_workbook()
            else:
                try:
                    made = machine_template() if self.machine else case_template(self.designation)
                except InputError as error:
                    own = error.with_details(example="") if error.field == "designation" else error
                    raise self._with_example(own) from None
        return Finding(made, text=text + "\n")

    def content(self, found: Any) -> str | bytes:
        """Return the file."""
        return found.found  # type: ignore[no-any-return]


class ExamplesRequest(FindingRequest):
    """List the shipped examples, or copy one or all of them.

    Case files, studies, duties, life tests and scripts, each with a command to try on it.

    Parameters
    ----------
    name
        Example to copy, such as 6310_motor; all: every one.
    output
        Folder to copy to; by default here.
    force
        Overwrite files that are there.
    """

    name: Annotated[str | None, Input(example="6310_motor", stands_alone=True, metavar="NAME")] = (
        None
    )
    output: Annotated[Any, Input("", "target", default=".", metavar="FOLDER")] = "."
    force: Annotated[bool, FORCE] = False

    shows_page: ClassVar = False
    json_meaning: ClassVar = ""
    examples: ClassVar = "Examples: examples; examples 6310_motor; examples all -o gallery."

    def run(self, progress: Progress = quietly) -> Finding:
        """Copy them; return the examples by their names."""
        from rolamento.tasks.examples import EXAMPLES, copy_examples

        if self.name is None:
            parts = (
                f"{name}\n    {said(one.shows)}\n    {one.command}\n"
                for name, one in EXAMPLES.items()
            )
            how = said("To copy one: rolamento examples NAME; every one: rolamento examples all")
            return Finding(EXAMPLES, text="".join([*parts, "\n", how, "\n"]))
        copied = copy_examples(self.name, self.output, force=self.force)
        paths = dict.fromkeys(path for example in copied.values() for path in example.files)
        lines = [said("Wrote {path}", path=path) for path in paths]
        if len(copied) == 1:
            lines += [said("Now try: {command}", command=one.command) for one in copied.values()]
        else:
            lines += [said("What each shows, and a command to try: rolamento examples")]
        return Finding(copied, text="\n".join(lines) + "\n")


def case_template(designation: str | None = None) -> str:
    """Return a commented case file in the language that is spoken, which solves as it is.

    Parameters
    ----------
    designation
        Of its bearing; without one it is given by its geometry.

    Raises
    ------
    InputError
        If there is no such bearing, or its designation says too little.
    """
    bearing = None if designation is None else _named(designation)
    awake = _by_geometry() if bearing is None else _by_designation(bearing)
    asleep = {} if bearing is None else _examples_of(bearing)
    template = _Template(awake, asleep)
    lines = [*_wrapped(TABLES[""]), ""]
    for table, fields in _tables(bearing).items():
        written = [line for field in fields if (line := template.line(field))]
        if table and written:
            is_awake = any(field.name in awake for field in fields) or table in ("bearing", "duty")
            lines += ["", *_wrapped(TABLES[table]), f"[{table}]" if is_awake else f"# [{table}]"]
        lines += written
    text = "\n".join(lines) + "\n"
    parse_case(text)  # what is written can be read
    return text


def machine_template() -> str:
    """Return the text of a machine file to start from, which solves as it is."""
    file = resources.files("rolamento") / "data" / "machine_template.toml"
    return file.read_text(encoding="utf-8")


def machine_workbook() -> bytes:
    """Return the machine of `machine_template` as a workbook."""
    from rolamento.exchange.workbook import machine_to_xlsx

    return machine_to_xlsx(Machine.from_toml(machine_template()))


def file_name(designation: str | None) -> str:
    """Return a name for the case file of a bearing, such as ``"6310-C3.toml"``."""
    kept = "".join(c if c.isalnum() or c in "._" else "-" for c in (designation or "case").strip())
    return f"{kept.strip('-.') or 'case'}.toml"


def _named(designation: str) -> Bearing | RollerBearing:
    """The bearing of a designation: of balls, unless it names rollers."""
    record = BY_ELEMENT[element_named({"designation": designation}) or "ball"]
    return cast("Bearing | RollerBearing", record.named(designation))


def _matters(name: str, bearing: Bearing | RollerBearing | None) -> bool:
    """Whether a field is of such a bearing; of one of balls if there is none yet."""
    table, _, leaf = name.rpartition(".")
    record = Bearing if bearing is None else type(bearing)
    if table == "bearing":
        other = () if bearing is None else bearing.bearing_type.idle_fields
        return leaf in record.model_fields and leaf not in other
    return of_elements(name, ["ball" if bearing is None else bearing.element])


def _tables(bearing: Bearing | RollerBearing | None) -> dict[str, list[Field]]:
    """The fields of a case by their tables, in its order; not what a name stands for as a whole."""
    known = {name: field for name, field in Case.fields().items() if _matters(name, bearing)}
    tables: dict[str, list[Field]] = {"": []}
    for name, field in known.items():
        table, _, _leaf = name.rpartition(".")
        if table in TABLES and name not in TABLES and field.leaf != "element":
            tables.setdefault(table, []).append(field)
    return tables


class _Template:
    """The lines of a case file: fields that have a value, and those that could have one.

    awake, asleep: values as a file holds them, by the names of fields; the examples of the fields
    stand for the others that sleep.
    """

    def __init__(self, awake: Mapping[str, Any], asleep: Mapping[str, Any]) -> None:
        self._awake, self._asleep = awake, asleep
        self._case = changed({}, awake, Case, in_file=True)
        places = Case.from_mapping(self._case).bearing.places
        self._elements = [place.bearing.element for place in places]

    def line(self, field: Field) -> str:
        """Return the line of a field; empty where this case would not take it."""
        line, needed = f"{field.leaf} = {_toml(self._value(field.name))}", self._needed(field)
        if field.name not in self._awake:
            if needed is None:
                return ""
            line = f"# {line}"
        return f"{line.ljust(_COMMENTS_FROM - 1)} # {self._meaning(field, needed or ())}"

    def _value(self, name: str) -> Any:
        """The value of a line, as a file holds it."""
        given = self._awake.get(name, self._asleep.get(name))
        return _example(Case.fields()[name]) if given is None else given

    def _needed(self, field: Field) -> tuple[str, ...] | None:
        """What has to be woken up with a field so that the case loads; None where nothing helps."""
        alone = self._missing(field.name, ())
        return self._missing(field.name, _WITH.get(field.name, ())) if alone is None else alone

    def _missing(self, name: str, needed: tuple[str, ...]) -> tuple[str, ...] | None:
        """What a field needs, what the case finds missing included; None where that is not all."""
        for _ in range(_MOST_NEEDED):
            values = {name: self._value(name), **dict(map(self._told, needed))}
            try:
                Case.from_mapping(changed(self._case, values, Case, in_file=True))
            except InputError as error:
                lacks = error.field in Case.fields() and of_elements(error.field, self._elements)
                if error.field in {*values, *self._awake} or not lacks:
                    return None
                needed = (*needed, error.field)
                continue
            return needed
        return None

    def _told(self, needed: str) -> tuple[str, Any]:
        """Name and value of what a field needs."""
        name, _, text = needed.partition(" = ")
        return name, tomllib.loads(f"value = {text}")["value"] if text else self._value(name)

    def _meaning(self, field: Field, needed: tuple[str, ...]) -> str:
        """What a field is called, what it may be, what it takes the place of and what it needs."""
        parts = [field.label]
        if field.choices:
            parts.append(" | ".join(field.choices))
        table = f"{field.name.rpartition('.')[0]}."
        rivals = (one for one in field.rivals if of_elements(one, self._elements))
        replaced = (*rivals, *(one for one in field.replaces if one in self._awake))
        others = dict.fromkeys(one.removeprefix(table) for one in replaced)
        if others:
            parts.append(said("instead of {others}", others=", ".join(others)))
        if needed:
            beside = (one.removeprefix(table) for one in needed)
            parts.append(said("with {others}", others=", ".join(beside)))
        return "; ".join(parts)


def _toml(value: Any) -> str:
    """A value in one line of TOML."""
    if isinstance(value, str):
        escaped = value.replace("\\", "\\\\").replace('"', '\\"')
        return f'"{escaped}"'
    if isinstance(value, Mapping):
        return f"{{ {', '.join(f'{name} = {_toml(one)}' for name, one in value.items())} }}"
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(_toml, value))}]"
    return str(value).lower() if isinstance(value, bool) else str(value)


def _wrapped(text: str) -> Iterator[str]:
    for line in textwrap.wrap(said(text), _WIDTH):
        yield f"# {line}"


# --- what it starts with --------------------------------------------------------------------------


def _by_geometry() -> dict[str, Any]:
    """A bearing by its balls and grooves, from the examples of the fields."""
    names = (
        *("ball_count", "ball_diameter", "pitch_diameter", "contact_angle"),
        *("inner_conformity", "outer_conformity"),
    )
    fields = Case.fields()
    own = {f"bearing.{name}": _example(fields[f"bearing.{name}"]) for name in names}
    duty = ("duty.inner_speed", "duty.load.fx", "duty.load.fz")
    return {
        "title": said("My bearing"),
        **own,
        **{name: _example(fields[name]) for name in duty},
        **_OIL,
    }


_OIL: Final = {
    "lubricant.name": "ISO VG 68",
    "lubricant.base_oil": "ISO VG 68",
    "temperature.lubricant": "70 degC",
}


def _by_designation(bearing: Bearing | RollerBearing) -> dict[str, Any]:
    """A bearing of the catalogue, with a load and a speed that it bears for long."""
    published = bearing.published
    assert published is not None
    load = _rounded(_LOAD_SHARE * (published.dynamic_rating or _LOAD / _LOAD_SHARE))
    angle = bearing.contact_angle if isinstance(bearing, Bearing) else None
    spindle = angle is not None and angle < _SPINDLE_ANGLE
    speed = _rounded(1e3 * _SPEED_FACTOR[spindle] / bearing.pitch_diameter)
    loads = {} if published.type.washers else {"duty.load.fz": from_si(load, "force")}
    if published.type.carries_axial or bearing.contact_angle is not None:
        loads["duty.load.fx"] = from_si(load, "force")
    return {
        "title": str(bearing.designation),
        "bearing.designation": str(bearing.designation),
        "duty.inner_speed": f"{speed:.0f} rpm",
        **loads,
        **_OIL,
    }


def _examples_of(bearing: Bearing | RollerBearing) -> dict[str, Any]:
    """Examples for dormant fields: the values that the bearing has."""
    published = bearing.published
    assert published is not None
    fields = Case.fields()
    found = {}
    own = ("roller_length", "roller_half_angle") if isinstance(bearing, RollerBearing) else ()
    for leaf in (*bearing.origins, *own):
        if getattr(bearing, leaf) is None:
            continue
        field = fields[f"bearing.{leaf}"]
        found[field.name] = _written(field, getattr(bearing, leaf))
    found.update(_sizes(published, fields))
    if isinstance(bearing, RollerBearing) and bearing.resolved is not None:
        spacing = bearing.spacing or bearing.resolved.spacing("DB")
        if spacing:
            found["bearing.spacing"] = _written(fields["bearing.spacing"], spacing)
    return found


def _sizes(published: CatalogueBearing, fields: Mapping[str, Field]) -> dict[str, Any]:
    """Sizes and ratings of the catalogue, where a case has a field for them."""
    names = {
        **{f"{table}.bore": published.bore for table in ("mounting", "film")},
        **{
            f"{table}.outside_diameter": published.outside_diameter
            for table in ("mounting", "film")
        },
        "bearing.spacing": published.width,
        "life.dynamic_rating": published.dynamic_rating,
        "life.static_rating": published.static_rating,
        "mounting.shaft_bore": 0.5 * published.bore,
        "mounting.housing_outside_diameter": 1.5 * published.outside_diameter,
    }
    return {name: _written(fields[name], value) for name, value in names.items() if value}


def _written(field: Field, value: Any) -> Any:
    """A value as a file has it, with no more digits than people read."""
    if field.dimension is not None:
        return readable(value, field.dimension).replace("µm", "um")
    return in_file_form(field.name, value, Case)


def _example(field: Field) -> Any:
    return tomllib.loads(f"value = {field.example}")["value"]


def _rounded(value: float) -> float:
    """To one digit."""
    return float(f"{value:.0e}")
