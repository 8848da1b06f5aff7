"""Stiffness and force of bearings over speed, load or any other field, for other programs."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable, Sequence
from itertools import product
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.case import Case, case_to_toml, load_case, parse_case
from rolamento.case.case import is_designation
from rolamento.case.duty import AXES, LOADS
from rolamento.case.machine import (
    Machine,
    Step,
    load_machine,
    machine_to_toml,
    parse_machine,
    parts_of_key,
    with_values,
)
from rolamento.case.machine_fields import place_of_key
from rolamento.case.machine_sheets import holds_sheets
from rolamento.errors import InputError, arguments, guess
from rolamento.io.text import format_of_path, format_of_text, parse_mapping, read_text
from rolamento.machines import acts_alone, solve_machines
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.rotors import supports, turning_shaft
from rolamento.solved.maps import MapAxis, StiffnessMap
from rolamento.status import STATUS_NAMES
from rolamento.studies.ranges import Range, check_points, read_range
from rolamento.tasks.parameters import Progress
from rolamento.units import rpm_of
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.solved.machine import SolvedMachine

__all__ = ["POINTS", "Mapped", "mapped", "read_subject", "speed_range"]

POINTS: Final = 9
MOST_POINTS: Final = 500
"""Points of each axis."""
MOST_MACHINES: Final = 2500
"""Points of both axes together."""
_MOST_OVER: Final = 2


@frozen(eq=False)
class Mapped:
    """A machine or a case, and the maps of its bearings."""

    subject: Machine | Case
    maps: tuple[StiffnessMap, ...]

    @property
    def machine(self) -> Machine | None:
        """The machine; None of a case."""
        return self.subject if isinstance(self.subject, Machine) else None

    @property
    def converged(self) -> bool:
        """Whether every point of every bearing has a result."""
        return all(one.converged for one in self.maps)


def read_subject(source: str | os.PathLike[str], settings: Sequence[str] = ()) -> Machine | Case:
    """Read a machine file, a case file or a designation.

    Parameters
    ----------
    source
        A file is of a machine if it has shafts; ``"-"`` is standard input.
    settings
        ``KEY=VALUE`` that go over it.

    Raises
    ------
    InputError, FileError
        As `rolamento.load_machine` or `rolamento.load_case`.
    """
    if holds_sheets(source):
        return load_machine(source, settings)
    if is_designation(source):
        return load_case(source, settings)
    text, name = read_text(source)
    form = format_of_path(source) or format_of_text(text)
    if "shafts" in parse_mapping(text, form, name):
        folder = "" if os.fspath(source) == "-" else os.path.dirname(os.fspath(source))
        return parse_machine(text, format=form, source=name, folder=folder, settings=settings)
    return parse_case(text, format=form, source=name, overrides=settings)


def mapped(
    subject: Machine | Case,
    over: Sequence[str] = (),
    *,
    points: int = POINTS,
    bearing: str | None = None,
    with_housing: bool = False,
    progress: Progress | None = None,
) -> Mapped:
    """Solve a machine or a case over one or two fields, and map its bearings.

    Parameters
    ----------
    subject
        Of `read_subject`; of a spectrum the first step counts.
    over
        One or two ranges such as ``"duty.load.fz=1..10kN"``, of a machine ``"loads.0.fz=1..10kN"``;
        by default from rest to its speed.
    points
        Of each, 2 to 500; of both together at most 2500.
    bearing
        Of a machine, the one that is mapped; all if not given.
    with_housing
        What stands under outer rings is condensed into the stiffness, as of
        `rolamento.rotors.supports`: over the speed of a shaft alone.
    progress
        Called with how many of how many points are done.

    Raises
    ------
    InputError
        If a range is not of that form or not one that the subject takes, or it has no such bearing.
    """
    texts = list(over) or [speed_range(subject)]
    if len(texts) > _MOST_OVER:
        raise InputError(
            said("can be given {most} times at most", most=_MOST_OVER), field="over",
            value=texts[_MOST_OVER],
        )  # fmt: skip
    check_points(points, min(MOST_POINTS, int(MOST_MACHINES ** (1.0 / len(texts)))))
    ranges = [read_range(one, points, of_machine=isinstance(subject, Machine)) for one in texts]
    for one in ranges:
        if one.values[0] == one.values[-1]:
            raise InputError(
                said("must have two different ends"), field="over", value=one.field.name
            )
    names = [one.field.name for one in ranges]
    if len(set(names)) < len(names):
        raise InputError(said("is given twice"), field="over", value=names[0])
    if isinstance(subject, Case):
        if bearing is not None:
            raise InputError(said("is for a machine; a case has one"), field="bearing",
                             value=bearing)  # fmt: skip
        return Mapped(subject, (_of_case(subject, ranges, progress),))
    if bearing is not None:
        _known(subject, bearing)
    found = (
        _of_supports(subject, ranges[0])
        if with_housing
        else _of_machine(subject, ranges, progress or (lambda _done, _all: None))
    )
    return Mapped(subject, tuple(one for one in found if bearing in (None, one.name)))


def speed_range(subject: Machine | Case) -> str:
    """Return the range from rest to the speed of a machine or a case, as a range is written.

    Raises
    ------
    InputError
        If nothing turns.
    """
    if isinstance(subject, Machine):
        name = turning_shaft(subject, None)
        factor = subject.spectrum[0].speed_factor if subject.spectrum else 1.0
        field = f'shafts."{name}".speed' if "." in name else f"shafts.{name}.speed"
        return f"{field}=0..{rpm_of(subject.speed(name, factor)):.12g} rpm"
    for field in ("inner_speed", "outer_speed"):
        if (speed := getattr(subject.duty, field)) != 0.0:
            return f"duty.{field}=0..{rpm_of(speed):.12g} rpm"
    raise InputError(
        said("is missing: nothing turns, so that there is no range of speed"), field="over",
        example=arguments(over="duty.inner_speed=0..6000rpm"),
    )  # fmt: skip


def _known(machine: Machine, bearing: str) -> None:
    names = [one.name for one in machine.bearings]
    if bearing not in names:
        raise InputError(
            said("is an unknown name; {guess}", guess=guess(bearing, names)), field="bearing",
            value=bearing,
        )  # fmt: skip


def _axes(ranges: Sequence[Range]) -> tuple[MapAxis, ...]:
    return tuple(
        MapAxis(one.field.name, "" if one.field.unit == "1" else one.field.unit, one.values)
        for one in ranges
    )


def _made_of(kind: str, title: str, text: str) -> dict[str, str]:
    digest = hashlib.sha256(text.encode("utf-8")).hexdigest()
    return {"title": title, kind: f"sha256 {digest[:16]}"}


# --- a bearing alone ------------------------------------------------------------------------------


def _of_case(case: Case, ranges: Sequence[Range], progress: Progress | None) -> StiffnessMap:
    from rolamento.studies import Axis, Study, run

    stiffness = [f"stiffness_{row}{column}" for row in AXES for column in AXES]
    study = Study(
        case=case,
        axes=[Axis(field=one.field.name, values=one.values.tolist()) for one in ranges],
        outputs=(*stiffness, *LOADS, *AXES),
    )
    found = run(
        study, progress=None if progress is None else lambda done, of, _: progress(done, of)
    )
    # axes whose values need cases of their own come first there
    order = [list(study.ordered_axes).index(axis) for axis in study.axes]
    shape = tuple(len(one.values) for one in ranges)

    def taken(names: Sequence[str]) -> FloatArray:
        arrays = [np.asarray(found[name].values).transpose(order) for name in names]
        return np.stack(arrays, axis=-1)

    codes = np.asarray(found["status"].values).transpose(order)
    return StiffnessMap(
        name=case.title or case.bearing.designation or "bearing",
        axes=_axes(ranges),
        stiffness=taken(stiffness).reshape(*shape, 5, 5),
        force=taken(LOADS),
        displacement=taken(AXES),
        status=np.vectorize(lambda code: STATUS_NAMES[int(code)], otypes=["U32"])(codes),
        made_of=_made_of("case", case.title, case_to_toml(case)),
    )


# --- the bearings of a machine --------------------------------------------------------------------


def _of_supports(machine: Machine, along: Range) -> tuple[StiffnessMap, ...]:
    place = place_of_key(machine, along.field.name)
    if len(place) != 3 or place[0] != "shafts" or place[2] != "speed":
        raise InputError(
            said("must be the speed of a shaft"), field="over", value=along.field.name,
            example=arguments(over=speed_range(machine)),
        )  # fmt: skip
    return supports(machine, along.values, shaft=machine.shafts[int(place[1])].name)


def _of_machine(
    machine: Machine, ranges: Sequence[Range], progress: Callable[[int, int], None]
) -> tuple[StiffnessMap, ...]:
    shape = tuple(len(one.values) for one in ranges)
    keys = [parts_of_key(one.field.name) for one in ranges]
    tables = _first_step(machine).to_mapping()
    machines = []
    for values in product(*(one.values.tolist() for one in ranges)):
        given = zip(keys, ranges, values, strict=True)
        written = [(key, one.field.written(value)) for key, one, value in given]
        machines.append(Machine.from_mapping(with_values(tables, written)))
    together = all(acts_alone(machine, place_of_key(machine, one.field.name)) for one in ranges)
    groups = [machines] if together else [[one] for one in machines]
    solved = []
    for done, group in enumerate(groups, start=1):
        solved.append(solve_machines(group))
        progress(done, len(groups))
    made_of = _made_of("machine", machine.title, machine_to_toml(machine))
    return tuple(
        _of_bearing(one.name, solved, shape, _axes(ranges), made_of) for one in machine.bearings
    )


def _first_step(machine: Machine) -> Machine:
    if not machine.spectrum:
        return machine
    first = machine.spectrum[0]
    only = Step(share=1.0, speed_factor=first.speed_factor, load_factor=first.load_factor)
    return machine.replace(spectrum=[only])


def _of_bearing(
    name: str,
    solved: Sequence[SolvedMachine],
    shape: tuple[int, ...],
    axes: tuple[MapAxis, ...],
    made_of: dict[str, str],
) -> StiffnessMap:
    seated = [one.bearings[name] for one in solved]
    # a bearing's own x is the machine's -x where it is turned round
    way = np.array(
        [seated[0].bearing.side, 1.0, 1.0, seated[0].bearing.side, seated[0].bearing.side]
    )
    own = np.concatenate([one.solved.stiffness.array for one in seated])
    numbers = np.concatenate([one.solved.status.number for one in seated])
    return StiffnessMap(
        name=name,
        axes=axes,
        stiffness=(way[:, np.newaxis] * own * way).reshape(*shape, 5, 5),
        force=np.concatenate([one.force for one in seated]).reshape(*shape, 5),
        displacement=np.concatenate([one.inner - one.outer for one in seated]).reshape(*shape, 5),
        status=np.array([STATUS_NAMES[int(one)] for one in numbers]).reshape(shape),
        made_of=made_of,
    )
