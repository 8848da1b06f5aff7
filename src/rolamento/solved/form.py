"""A result as JSON and back: the keys that files and other programs know.

What is written is read again to the last bit. What is read is taken for hostile: every key is
looked at, and the message names the one that is missing or not what it should be.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict, fields, replace
from math import isfinite, nan
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from rolamento.case import Case
from rolamento.case.bearing import RowPlace
from rolamento.case.duty import AXES, LOADS
from rolamento.case.former import STATUSES, current
from rolamento.contact.hertz import effective_modulus
from rolamento.errors import ABSENT, FileError, InputError
from rolamento.geometry import Angle, Race
from rolamento.io.json import plain
from rolamento.kinematics import RacewayControl
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.solved.rollers import LINE_COLUMNS, ROLLER_COLUMNS, Line, Rollers
from rolamento.solved.tables import (
    CONTACT_COLUMNS,
    ELEMENT_COLUMNS,
    GEOMETRY_COLUMNS,
    MORE_COLUMNS,
    RACES,
    Elements,
    Index,
    IntArray,
    Preloading,
    PreloadStage,
    Pressed,
    RingDisplacement,
    RingLoad,
    Rolling,
    RollingContacts,
    Rows,
    Status,
    Stiffness,
    Tables,
    taken,
)
from rolamento.status import STATUS_NUMBERS
from rolamento.validate import one_of
from rolamento.words import Note, said

if TYPE_CHECKING:
    from rolamento.solved.result import Solved

SCHEMA: Final = 3
_FORMER_SCHEMAS: Final = (1, 2)
"""Where notes and advice were texts."""
EXAMPLE: Final = "rolamento solve case.toml --json state.json"
_LARGEST: Final = 1e20
_MOST_ROWS: Final = 1000
_MOST_SLICES: Final = 1001


def mapping_of(solved: Solved) -> dict[str, Any]:
    """The only case of a result as plain values."""
    before = ("schema", "title", "status", "displacement", "load", "stiffness")
    after = ("preload", "rolling", "notes", "case")
    return {
        **{name: part_of(solved, name) for name in before},
        **_elements_mapping(solved),
        "rows": _rows_mapping(solved),
        **{name: part_of(solved, name) for name in after},
    }


def part_of(solved: Solved, name: str) -> Any:
    """One part of `mapping_of` by its key, of those that need no tables of the elements."""
    return _PARTS[name](solved)


def _status_mapping(solved: Solved) -> dict[str, Any]:
    status, advice = solved.status, solved.advice[0]
    return {
        "code": str(status.code[0]),
        "converged": bool(status.converged[0]),
        "residual": plain(float(status.residual[0])),
        "iterations": int(status.iterations[0]),
        "advice": None if advice is None else advice.to_mapping(),
    }


def _of_axes(values: Any) -> dict[str, Any]:
    return {name: plain(float(value[0])) for name, value in values._asdict().items()}


_PARTS: Final[Mapping[str, Callable[[Solved], Any]]] = {
    "schema": lambda solved: SCHEMA,
    "title": lambda solved: solved.title,
    "status": _status_mapping,
    "displacement": lambda solved: _of_axes(solved.displacement),
    "load": lambda solved: _of_axes(solved.load),
    "stiffness": lambda solved: plain(solved.stiffness.array[0].tolist()),
    "preload": lambda solved: None if solved.preload is None else _preload_mapping(solved.preload),
    "rolling": lambda solved: _rolling_mapping(solved),
    "notes": lambda solved: [note.to_mapping() for note in solved.notes[0]],
    "case": lambda solved: solved.case.to_mapping(),
}
"""What does not need the tables of the elements."""


def _elements_mapping(solved: Solved) -> dict[str, Any]:
    """The balls, and the rollers where there are any, one by one."""
    control = control_names(solved)
    of_race = {
        race: _entries(_columns(contacts, (*CONTACT_COLUMNS, *MORE_COLUMNS)))
        for race, contacts in solved.contacts.items()
    }
    elements = _columns(solved.elements, ELEMENT_COLUMNS)
    balls = [
        {
            "row": int(row),
            "azimuth": elements["azimuth"][j],
            **{race: of_race[race][j] for race in RACES},
            **{name: elements[name][j] for name in ELEMENT_COLUMNS[1:]},
            "raceway_control": control[j],
        }
        for j, row in enumerate(solved.elements.row)
        if solved.rows.element[row] == "ball"
    ]
    return {"balls": balls, **_rollers_mapping(solved, elements, of_race)}


def _rows_mapping(solved: Solved) -> list[dict[str, Any]]:
    rows = solved.rows
    geometry = _columns(rows, GEOMETRY_COLUMNS)
    return [
        {
            "row": index,
            "orientation": "+" if rows.sign[index] > 0.0 else "-",
            "position": plain(float(rows.position[0, index])),
            "load": dict(zip(LOADS, plain((rows.load[0, index] + 0.0).tolist()), strict=True)),
            **_of_kind(
                {
                    "loaded_balls": int(solved.loaded_elements[0, index]),
                    "ball_count": int(rows.element_count[index]),
                    **{name: geometry[name][index] for name in GEOMETRY_COLUMNS},
                },
                rows.element[index],
            ),
            **_line_of_row(rows, index),
        }
        for index in range(len(rows))
    ]


def _rollers_mapping(
    solved: Solved,
    elements: Mapping[str, list[Any]],
    of_race: Mapping[Race, list[dict[str, Any]]],
) -> dict[str, Any]:
    """The rollers of the first case, slice by slice; nothing where there are none."""
    rollers, rows = solved.rollers, solved.rows
    if rollers is None:
        return {}
    own = _entries(_columns(rollers, (*ROLLER_COLUMNS, "slice_place")))
    lines = {race: _entries(_columns(getattr(rollers, race), LINE_COLUMNS)) for race in RACES}
    entries = [
        {
            "row": int(row),
            "azimuth": elements["azimuth"][j],
            **{race: {**of_race[race][j], **lines[race][j]} for race in RACES},
            **_of_kind({name: elements[name][j] for name in ELEMENT_COLUMNS[1:]}, "roller"),
            **own[j],
        }
        for j, row in enumerate(solved.elements.row)
        if rows.element[row] != "ball"
    ]
    contact = solved.case.model.roller_contact
    return {"rollers": entries, "slices": rollers.slices, "roller_contact": contact}


def _of_kind(columns: Mapping[str, Any], element: str) -> dict[str, Any]:
    """Columns of balls by the names that they have of rollers, which lack conformities."""
    if element == "ball":
        return dict(columns)
    return {
        name.replace("ball", "roller"): value
        for name, value in columns.items()
        if not name.endswith("_conformity")
    }


def _line_of_row(rows: Rows, index: int) -> dict[str, Any]:
    if rows.element[index] == "ball":
        return {}
    length = plain(float(rows.effective_length[0, index]))
    return {"element": rows.element[index], "effective_length": length}


def _preload_mapping(preload: Preloading) -> dict[str, Any]:
    """The preload; its stages of a mounted set only, its loss where it was looked for."""
    mapping: dict[str, Any] = plain(asdict(preload))
    unknown = [] if preload.stages else ["stages"]
    if preload.loss_factor is None:
        unknown += ["lift_factor", "lift_row", "loss_factor", "lost_row"]
    return {name: value for name, value in mapping.items() if name not in unknown}


def control_names(solved: Solved) -> list[str]:
    """Which race controls each element of the first case, in words."""
    mode = solved.case.model.raceway_control
    codes = solved.elements.raceway_control[0]
    if mode in ("none", "friction"):
        return [mode] * len(codes)
    return [RacewayControl(int(code)).name.lower() for code in codes]


def _columns(record: object, names: Iterable[str]) -> dict[str, list[Any]]:
    """Numbers of the first case by name, NaN as None."""
    return {name: plain(getattr(record, name)[0]) for name in names}


def _entries(columns: Mapping[str, list[Any]]) -> list[dict[str, Any]]:
    """The same element by element."""
    return [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]


def _rolling_mapping(solved: Solved) -> dict[str, Any] | None:
    rolling = solved.rolling
    if rolling is None or not solved.converged[0]:
        return None
    names = (
        "cage_speed", "control_cage_speed", "skid", "inner_torque", "outer_torque", "power",
        "imbalance",
    )  # fmt: skip
    parts = [part.name for part in fields(RollingContacts)]
    races = {race: _columns(getattr(rolling, race), parts) for race in RACES}
    velocity, yaw = rolling.angular_velocity[0].tolist(), solved.elements.yaw[0].tolist()
    mapping: dict[str, Any] = {name: plain(float(getattr(rolling, name)[0])) for name in names}
    mapping["balls"] = [
        {
            "angular_velocity": plain(velocity[j]),
            "yaw": plain(yaw[j]),
            **{race: {name: column[j] for name, column in races[race].items()} for race in RACES},
        }
        for j in range(len(yaw))
    ]
    return mapping


@frozen
class ReadAnswer:
    """Tables as a file has them; kept: by race and name, what need not be worked out again."""

    read: Tables
    kept: Mapping[Race, Mapping[str, FloatArray]]

    def grip(self) -> FloatArray:
        """How deep each element is pressed into the inner ring."""
        return self.tables().inner.approach

    def tables(self) -> Tables:
        """As they were read."""
        return self.read

    def part(self, index: Index) -> ReadAnswer:
        """Return some of the cases."""
        kept = {race: {k: v[index] for k, v in own.items()} for race, own in self.kept.items()}
        return ReadAnswer(taken(self.read, index), kept)


@frozen
class Pieces:
    """What a file holds of a result, beside its case."""

    status: Status
    displacement: RingDisplacement
    load: RingLoad
    stiffness: Stiffness
    rows: Rows
    answer: ReadAnswer
    preloading: Preloading | None
    written_notes: tuple[tuple[Note, ...], ...]
    written_advice: tuple[Note | None, ...]


def pieces_of(mapping: Mapping[str, Any]) -> tuple[Case, dict[str, FloatArray], Pieces]:
    """Case, what varied and the rest, of parsed JSON that is taken for hostile.

    Raises
    ------
    FileError
        If this is no result at all, or one of another schema.
    InputError
        If a key is missing or not what it should be.
    """
    schema = mapping.get("schema")
    if schema is None or not ("balls" in mapping or "states" in mapping):
        raise FileError(said("is not the JSON of a solved state"), example=EXAMPLE)
    if schema is True or schema not in (*_FORMER_SCHEMAS, SCHEMA):
        raise FileError(
            said("is of another release; 1 to {last} are known", last=SCHEMA),
            field="schema",
            value=schema,
        )
    case = _case(_value(mapping, "case"))
    one = "balls" in mapping
    states = [mapping] if one else _list(mapping, "states")
    parts = [_state(item, case, "" if one else f"states.{i}.") for i, item in enumerate(states)]
    if len({part.answer.read.elements.azimuth.shape for part in parts}) != 1:
        raise InputError(said("must all be of one bearing"), field="states")
    varied = {}
    table = _table(mapping, "varied") if "varied" in mapping else {}
    for name, values in table.items():
        if not isinstance(values, list) or len(values) != len(parts):
            raise InputError(
                said("must be a list of {count} numbers", count=len(parts)), field=f"varied.{name}"
            )
        varied[name] = np.array([_number_of(value, f"varied.{name}") for value in values])
    return case, varied, parts[0] if len(parts) == 1 else _after_one_another(parts)


def _state(item: Any, case: Case, at: str) -> Pieces:
    """One case from its mapping; at: where it stands, for messages."""
    if not isinstance(item, dict):
        raise InputError(said("must be a table"), field=at.rstrip("."), value=item)
    status = _table(item, f"{at}status")
    balls, where = _elements_of(item, at)
    row = np.array([_row(b, f"{w}.row") for b, w in zip(balls, where, strict=True)])
    contacts = {
        race: _contact_columns(
            [_table(ball, f"{place}.{race}") for ball, place in zip(balls, where, strict=True)],
            [f"{place}.{race}" for place in where],
        )
        for race in RACES
    }
    own = {
        name: np.array(
            [[_number(b, f"{w}.{_name_in(b, name)}") for b, w in zip(balls, where, strict=True)]]
        )
        for name in ELEMENT_COLUMNS
    }
    rolling, yaw = _rolling_of(item, len(balls), at)
    elements = Elements(row=row, yaw=yaw, raceway_control=_codes(balls), **own)
    pressed = {
        race: Pressed(
            angle=Angle(columns["contact_angle"]),
            **{name: columns[name] for name in ("load", "deflection", *MORE_COLUMNS)},
        )
        for race, columns in contacts.items()
    }
    rollers = _rollers_of(item, balls, where, at) if "rollers" in item else None
    tables = Tables(elements, pressed["inner"], pressed["outer"], rolling, rollers)
    code = current(_text(status, f"{at}status.code"), STATUSES)
    one_of(code, f"{at}status.code", STATUS_NUMBERS)
    if _truth(status, f"{at}status.converged") != (code == "converged"):
        raise InputError(said("contradicts status.code"), field=f"{at}status.converged")
    notes = [
        _note(note, f"{at}notes.{j}") for j, note in enumerate(_list(item, f"{at}notes", least=0))
    ]
    advice = status.get("advice")
    return Pieces(
        status=Status(
            number=np.array([STATUS_NUMBERS[code]]),
            residual=np.array([_number(status, f"{at}status.residual")]),
            iterations=np.array([int(np.nan_to_num(_number(status, f"{at}status.iterations")))]),
            safe_path=np.array([False]),
            unsupported=np.array([-1]),
        ),
        displacement=RingDisplacement(*_five(item, f"{at}displacement", AXES)),
        load=RingLoad(*_five(item, f"{at}load", LOADS)),
        stiffness=Stiffness(_matrix(item, f"{at}stiffness")),
        rows=_rows_of(item, at, row, case),
        answer=ReadAnswer(tables, contacts),
        preloading=_preloading_of(item, at),
        written_notes=(tuple(notes),),
        written_advice=(None if advice is None else _note(advice, f"{at}status.advice"),),
    )


def _elements_of(item: Mapping[str, Any], at: str) -> tuple[list[Mapping[str, Any]], list[str]]:
    """Balls and rollers, row after row, and where each stands."""
    both = "rollers" in item
    found = []
    for key in ("balls", "rollers") if both else ("balls",):
        for j, entry in enumerate(_list(item, f"{at}{key}", least=0 if both else 1)):
            found.append((_entry(entry, f"{at}{key}.{j}"), f"{at}{key}.{j}"))
    if not found:
        raise InputError(said("must be a list of at least {least}", least=1), field=f"{at}balls")
    found.sort(key=lambda one: _row(one[0], f"{one[1]}.row"))  # stable
    return [entry for entry, _ in found], [place for _, place in found]


def _name_in(entry: Mapping[str, Any], name: str) -> str:
    """What a column is called in the entry of a ball or a roller."""
    return name.replace("ball", "roller") if "tilt" in entry else name


def _rollers_of(
    item: Mapping[str, Any], entries: list[Mapping[str, Any]], where: list[str], at: str
) -> Rollers:
    """The rollers of a state, NaN for the balls beside them."""
    slices = _value(item, f"{at}slices")
    if isinstance(slices, bool) or not isinstance(slices, int) or not 5 <= slices <= _MOST_SLICES:
        raise InputError(
            said("must be a whole number from 5 to {most}", most=_MOST_SLICES),
            field=f"{at}slices",
            value=slices,
        )

    def flat(name: str) -> FloatArray:
        found = [
            _number(entry, f"{place}.{name}") if "tilt" in entry else nan
            for entry, place in zip(entries, where, strict=True)
        ]
        return np.array([found])

    def deep(name: str, race: Race | None = None) -> FloatArray:
        found = []
        for entry, place in zip(entries, where, strict=True):
            if "tilt" not in entry:
                found.append([nan] * slices)
                continue
            own = place if race is None else f"{place}.{race}"
            values = _list(entry if race is None else _table(entry, own), f"{own}.{name}")
            if len(values) != slices:
                raise InputError(
                    said("must be a list of {count} numbers", count=slices), field=f"{own}.{name}"
                )
            found.append([_number_of(value, f"{own}.{name}") for value in values])
        return np.array([found])

    lines = {race: Line(*(deep(name, race) for name in LINE_COLUMNS)) for race in RACES}
    return Rollers(
        tilt=flat("tilt"),
        rib_force=flat("rib_force"),
        rib_moment=flat("rib_moment"),
        slice_place=deep("slice_place"),
        inner=lines["inner"],
        outer=lines["outer"],
    )


def _note(given: object, field: str) -> Note:
    if isinstance(given, str):  # schema 1
        return Note("text", {"text": given})
    table = _entry(given, field)
    key, text = _text(table, f"{field}.key"), _text(table, f"{field}.text")
    values = _table(table, f"{field}.values")
    return Note.from_mapping({"key": key, "text": text, "values": values})


def _contact_columns(items: list[Mapping[str, Any]], where: list[str]) -> dict[str, FloatArray]:
    columns = {}
    for name in (*CONTACT_COLUMNS, *MORE_COLUMNS):
        numbers = [
            _number(item, f"{at}.{name}") if name in item or name in CONTACT_COLUMNS else nan
            for item, at in zip(items, where, strict=True)
        ]  # an earlier release wrote no more than CONTACT_COLUMNS
        if name in ("load", "deflection", "semi_major", "semi_minor", "max_pressure"):
            for number, at in zip(numbers, where, strict=True):
                if number < 0.0:
                    raise InputError(
                        said("must not be negative"), field=f"{at}.{name}", value=number
                    )
        columns[name] = np.array([numbers])
    return columns


def _codes(balls: list[Mapping[str, Any]]) -> IntArray:
    codes = {"outer": 1, "inner": -1, "indeterminate": 0, "none": 1, "friction": 1}
    return np.array([[codes.get(str(ball.get("raceway_control")), 0) for ball in balls]])


def _rolling_of(item: Mapping[str, Any], count: int, at: str) -> tuple[Rolling | None, FloatArray]:
    """The motion under friction, and the yaw of the elements' axes, which it alone gives them."""
    if item.get("rolling") is None:
        return None, np.zeros((1, count))
    table = _table(item, f"{at}rolling")
    balls = [
        _entry(b, f"{at}rolling.balls.{j}")
        for j, b in enumerate(_list(table, f"{at}rolling.balls"))
    ]
    if len(balls) != count:
        raise InputError(said("must have {count} balls", count=count), field=f"{at}rolling.balls")
    yaw = [_number(ball, f"{at}rolling.balls.{j}.yaw") for j, ball in enumerate(balls)]
    races = {
        race: RollingContacts(
            **{
                part.name: np.array(
                    [[_number(_table(ball, race), f"{race}.{part.name}") for ball in balls]]
                )
                for part in fields(RollingContacts)
            }
        )
        for race in RACES
    }
    velocity = [
        [_number_of(v, "angular_velocity") for v in _list(ball, "angular_velocity", least=3)[:3]]
        for ball in balls
    ]

    def number(name: str) -> FloatArray:
        return np.array([_number(table, f"{at}rolling.{name}")])

    rolling = Rolling(
        cage_speed=number("cage_speed"),
        control_cage_speed=number("control_cage_speed"),
        inner_torque=number("inner_torque"),
        outer_torque=number("outer_torque"),
        imbalance=number("imbalance"),
        angular_velocity=np.array([velocity]),
        inner=races["inner"],
        outer=races["outer"],
    )
    return rolling, np.array([yaw])


def _rows_of(item: Mapping[str, Any], at: str, row: IntArray, case: Case) -> Rows:
    given, places = _list(item, f"{at}rows"), case.bearing.places
    if len(given) != len(places):
        raise InputError(
            said("must have the {count} rows of the case", count=len(places)), field=f"{at}rows"
        )
    rows = [
        _row_entry(r, f"{at}rows.{i}", place)
        for i, (r, place) in enumerate(zip(given, places, strict=True))
    ]
    count = np.bincount(row, minlength=len(rows))
    if len(count) != len(rows) or np.any(count == 0) or np.any(np.diff(row) < 0):
        raise InputError(said("do not match the rows of the balls"), field=f"{at}rows")
    where = [f"{at}rows.{i}" for i in range(len(rows))]
    load = [[_five(r, f"{w}.load", LOADS) for r, w in zip(rows, where, strict=True)]]
    return Rows(
        sign=np.array([1.0 if r.get("orientation") != "-" else -1.0 for r in rows]),
        element_count=count.astype(np.int64),
        load=np.array(load)[..., 0],
        **{
            name: np.array([[_number(r, f"{w}.{name}") for r, w in zip(rows, where, strict=True)]])
            for name in ("position", *GEOMETRY_COLUMNS)
        },
        element=tuple(place.bearing.element for place in places),
        effective_length=np.array(
            [
                [
                    nan if p.bearing.element == "ball" else _number(r, f"{w}.effective_length")
                    for r, w, p in zip(rows, where, places, strict=True)
                ]
            ]
        ),
    )


def _row_entry(item: object, field: str, place: RowPlace) -> Mapping[str, Any]:
    """A row as it was written; what an earlier release left out is the case's."""
    bearing = place.bearing
    geometry = {name: getattr(bearing, name, None) for name in GEOMETRY_COLUMNS}
    geometry["free_contact_angle"] = bearing.contact_angle or 0.0
    geometry["modulus"] = effective_modulus(bearing.ring_material, bearing.element_material)
    known = _entry(item, field)
    if bearing.element != "ball":
        names: dict[str, Any] = dict.fromkeys(GEOMETRY_COLUMNS)  # rollers have no conformity
        return {**names, **{name.replace("roller", "ball"): v for name, v in known.items()}}
    return {**geometry, **known}


def _preloading_of(item: Mapping[str, Any], at: str) -> Preloading | None:
    if item.get("preload") is None:
        return None
    table = _table(item, f"{at}preload")

    def number(name: str) -> float:
        return _number(table, f"{at}preload.{name}")

    def row(name: str) -> int | None:
        return None if table.get(name) is None else _row(table, f"{at}preload.{name}")

    found = Preloading(
        _text(table, f"{at}preload.kind"), number("at_rest"), number("at_speed"),
        stages=_preload_stages(table, f"{at}preload.stages") if "stages" in table else (),
    )  # fmt: skip
    if "loss_factor" not in table:
        return found
    return replace(
        found,
        lift_factor=number("lift_factor"),
        lift_row=row("lift_row"),
        loss_factor=number("loss_factor"),
        lost_row=row("lost_row"),
    )


def _preload_stages(table: Mapping[str, Any], at: str) -> tuple[PreloadStage, ...]:
    """The stages of a mounted set, as they were written."""
    stages = []
    for index, given in enumerate(_list(table, at)):
        own = f"{at}.{index}"
        stage = _entry(given, own)
        preload, angle, offset = (
            tuple(_number_of(one, f"{own}.{name}") for one in _list(stage, f"{own}.{name}"))
            for name in ("preload", "contact_angle", "offset")
        )
        if len(preload) != 3:
            rule = said("must be a list of {count} numbers", count=3)
            raise InputError(rule, field=f"{own}.preload")
        stiffness, pressure = (
            _number(stage, f"{own}.{name}") for name in ("axial_stiffness", "max_pressure")
        )
        name = _text(stage, f"{own}.name")
        loosest, mean, tightest = preload
        stages.append(
            PreloadStage(name, (loosest, mean, tightest), angle, offset, stiffness, pressure)
        )
    return tuple(stages)


def _after_one_another(parts: list[Pieces]) -> Pieces:
    """The pieces of several cases of one bearing as those of one result."""
    whole: Pieces = _joined(parts)
    return replace(whole, preloading=None)


_SHARED: Final = ("row", "sign", "element_count", "element", "preloading")


def _joined(records: list[Any]) -> Any:
    """Records of arrays over cases, one after another."""
    first = records[0]
    if first is None or isinstance(first, np.ndarray):
        return None if first is None else np.concatenate(records)
    if isinstance(first, dict):
        return {key: _joined([record[key] for record in records]) for key in first}
    if isinstance(first, RingDisplacement | RingLoad):
        return type(first)(*(np.concatenate(columns) for columns in zip(*records, strict=True)))
    if isinstance(first, tuple):
        return tuple(item for record in records for item in record)
    names = [part.name for part in fields(first) if part.name not in _SHARED]
    return replace(first, **{n: _joined([getattr(r, n) for r in records]) for n in names})


def _case(value: object) -> Case:
    if not isinstance(value, dict):
        raise InputError(said("must be a table"), field="case", value=value)
    try:
        return Case.from_mapping(value)
    except InputError as error:
        raise error.with_details(field=f"case.{error.field}") from None


def _five(item: Mapping[str, Any], at: str, names: tuple[str, ...]) -> list[FloatArray]:
    table = _table(item, at)
    return [np.array([_number(table, f"{at}.{name}")]) for name in names]


def _matrix(item: Mapping[str, Any], at: str) -> FloatArray:
    lines = _list(item, at)
    if len(lines) != 5 or any(not isinstance(line, list) or len(line) != 5 for line in lines):
        raise InputError(said("must be a 5 × 5 matrix"), field=at)
    return np.array([[[_number_of(value, at) for value in line] for line in lines]])


def _value(item: Mapping[str, Any], field: str) -> Any:
    """What stands under the last name of a dotted field."""
    value = item.get(field.rpartition(".")[2], ABSENT)
    if value is ABSENT:
        raise InputError(said("is missing"), field=field)
    return value


def _entry(item: object, field: str) -> Mapping[str, Any]:
    if not isinstance(item, dict):
        raise InputError(said("must be a table"), field=field, value=item)
    return item


def _table(item: Mapping[str, Any], field: str) -> Mapping[str, Any]:
    return _entry(_value(item, field), field)


def _list(item: Mapping[str, Any], field: str, least: int = 1) -> list[Any]:
    value = _value(item, field)
    if not isinstance(value, list) or len(value) < least:
        rule = (
            said("must be a list")
            if least == 0
            else said("must be a list of at least {least}", least=least)
        )
        raise InputError(rule, field=field, value=value)
    return value


def _text(item: Mapping[str, Any], field: str) -> str:
    value = _value(item, field)
    if not isinstance(value, str):
        raise InputError(said("must be text"), field=field, value=value)
    return value


def _truth(item: Mapping[str, Any], field: str) -> bool:
    value = _value(item, field)
    if not isinstance(value, bool):
        raise InputError(said("must be true or false"), field=field, value=value)
    return value


def _row(item: Mapping[str, Any], field: str) -> int:
    value = _value(item, field)
    if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value < _MOST_ROWS:
        raise InputError(said("must be the number of a row, from 0"), field=field, value=value)
    return value


def _number(item: Mapping[str, Any], field: str) -> float:
    """A number; null stands for one that does not exist."""
    return _number_of(_value(item, field), field)


def _number_of(value: object, field: str) -> float:
    if value is None:
        return float("nan")
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise InputError(said("must be a number or null"), field=field, value=value)
    if abs(value) > _LARGEST or not isfinite(value):  # a whole number may be too large for a float
        raise InputError(
            said("must be within ±{most:.6g}", most=_LARGEST), field=field, value=value
        )
    return float(value)


def array(item: Mapping[str, Any], field: str, shape: tuple[int, ...]) -> FloatArray:
    """An array of numbers or null, of a shape."""

    def read(value: object, left: tuple[int, ...]) -> Any:
        if not left:
            return _number_of(value, field)
        if not isinstance(value, list) or len(value) != left[0]:
            raise InputError(said("must be a list of {count} numbers", count=left[0]), field=field)
        return [read(one, left[1:]) for one in value]

    return np.array(read(_value(item, field), shape), dtype=np.float64).reshape(shape)


# what other forms of results read by
entry, table, rows, text = _entry, _table, _list, _text
truth, number, value, note = _truth, _number, _value, _note
