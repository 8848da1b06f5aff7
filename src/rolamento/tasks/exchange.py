"""Machines from the files of other programs, and to them."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import fields
from typing import Any, Final

from rolamento.analysis.machine import analyse_machine
from rolamento.case import Case
from rolamento.case.machine import Machine, load_machine
from rolamento.catalogue import catalogues as catalogues_beside
from rolamento.errors import FileError, InputError, arguments
from rolamento.exchange.fmi import between_points, fmu_bytes
from rolamento.exchange.rexs import (
    Exported,
    Imported,
    check_ending,
    machine_of_rexs,
    read_rexs,
    rexs_of_machine,
)
from rolamento.exchange.ross import RossBearing, bearing_file, ross_bearings, ross_script
from rolamento.exchange.tables import maps_to_csv, maps_to_mat, maps_to_modelica
from rolamento.exchange.workbook import machine_to_xlsx
from rolamento.io.json import plain
from rolamento.records import frozen
from rolamento.tasks.maps import POINTS, Mapped, mapped, read_subject
from rolamento.tasks.parameters import Progress
from rolamento.words import Note, said

__all__ = [
    "ENDINGS",
    "Wanted",
    "Written",
    "check_rexs_ending",
    "check_wanted",
    "ending_of",
    "exported_machine",
    "imported_machine",
    "written_for",
]


def imported_machine(
    source: str | os.PathLike[str],
    catalogues: Sequence[str | os.PathLike[str]] = (),
    *,
    load_case: int | None = None,
) -> Imported:
    """Read a machine from a REXS file.

    Parameters
    ----------
    source
        A ``.rexs``, ``.rexsj`` or ``.rexsz`` file; ``"-"`` for standard input.
    catalogues
        Files of catalogues of one's own, for designations.
    load_case
        As of `rolamento.exchange.rexs.machine_of_rexs`.

    Raises
    ------
    FileError
        If the file cannot be read, or is no REXS model.
    InputError
        If what is there makes no machine.
    """
    model = read_rexs(source)
    with catalogues_beside(catalogues):
        try:
            return machine_of_rexs(model, load_case=load_case)
        except InputError as error:
            if error.source:
                raise
            raise error.with_details(source=os.fspath(source)) from None


def exported_machine(
    source: str | os.PathLike[str],
    settings: Sequence[str] = (),
    catalogues: Sequence[str | os.PathLike[str]] = (),
    *,
    results: bool = True,
) -> Exported:
    """Read a machine file, solve it, and make a REXS model of it.

    Parameters
    ----------
    source, settings, catalogues
        As of `rolamento.tasks.machines.analysed_machine`.
    results
        Whether it is solved, and the model has its results.

    Raises
    ------
    InputError, FileError
        As `rolamento.tasks.machines.analysed_machine`.
    """
    with catalogues_beside(catalogues):
        machine = load_machine(source, settings)
        return rexs_of_machine(analyse_machine(machine) if results else machine)


# --- to programs that are none for gear units -----------------------------------------------------


@frozen
class Wanted:
    """What is to be written.

    Attributes
    ----------
    over, points, bearing
        as of `rolamento.tasks.maps.mapped`
    ross
        version of ROSS, 2 or 3
    fmi
        version of FMI, 2 or 3
    damping
        s: damping over stiffness
    levers
        as of `rolamento.exchange.ross.ross_bearings`
    """

    over: tuple[str, ...] = ()
    points: int | None = None
    bearing: str | None = None
    ross: int | None = None
    fmi: int | None = None
    damping: float | None = None
    levers: bool = False


@frozen(eq=False)
class Written:
    """A file for another program.

    Attributes
    ----------
    kind
        ``"ross"``, ``"table"``, ``"fmu"`` or ``"workbook"``
    content
        of the file
    mapped
        what was solved for it, if anything
    elements
        of ROSS
    notes
        what it leaves out
    """

    kind: str
    content: bytes
    mapped: Mapped | None = None
    elements: tuple[RossBearing, ...] = ()
    notes: tuple[Note, ...] = ()

    @property
    def converged(self) -> bool:
        """Whether every point has a result."""
        return self.mapped is None or self.mapped.converged

    def to_mapping(self) -> dict[str, Any]:
        """Give what is said of it as plain values; SI."""
        maps = () if self.mapped is None else self.mapped.maps
        return {
            "schema": 1,
            "kind": f"{self.kind}_export",
            "bearings": [
                {
                    "name": one.name,
                    "axes": [
                        {"field": axis.field, "unit": axis.unit, "values": axis.values.tolist()}
                        for axis in one.axes
                    ],
                    "status": one.status.tolist(),
                    "stiffness": plain(one.stiffness.tolist()),
                    "force": plain(one.force.tolist()),
                    "displacement": plain(one.displacement.tolist()),
                }
                for one in maps
            ],
            "elements": [
                {
                    "name": one.name,
                    "of": one.of,
                    "shaft": one.shaft,
                    "position": one.position,
                    "left_out": dict(zip(LEFT_OUT, one.left_out, strict=True)),
                }
                for one in self.elements
            ],
            "notes": [note.to_mapping() for note in self.notes],
        }


LEFT_OUT: Final = ("axial_radial", "shift_tilt", "tilt")


def written_for(
    source: str | os.PathLike[str],
    path: str,
    wanted: Wanted,
    settings: Sequence[str] = (),
    catalogues: Sequence[str | os.PathLike[str]] = (),
    *,
    progress: Progress | None = None,
) -> Written:
    """Read a machine, a case or a designation, and make a file for another program.

    Parameters
    ----------
    source
        As of `rolamento.tasks.maps.read_subject`.
    path
        Whose ending says the format: see `ENDINGS`.
    wanted
        What of it.
    settings, catalogues
        As of `exported_machine`.
    progress
        Called with how many of how many points are done.

    Raises
    ------
    InputError, FileError
        If an option is not for the format, or the subject cannot be read or mapped.
    """
    ending = ending_of(path, wanted)
    check_wanted(ending, wanted)
    with catalogues_beside(catalogues):
        return ENDINGS[ending].make(read_subject(source, settings), ending, wanted, progress)


def ending_of(path: str, wanted: Wanted) -> str:
    """Return the ending of a name if it is one of `ENDINGS`; else empty.

    What goes to standard output, ``"-"``, is of ROSS if a version of that is wanted.
    """
    if path == "-" and wanted.ross is not None:
        return ".toml"
    ending = os.path.splitext(path)[1].lower()
    return ending if ending in ENDINGS else ""


def check_rexs_ending(path: str) -> None:
    """Refuse a name that ends as no file that can be written.

    Raises
    ------
    FileError
        If it does.
    """
    try:
        check_ending(path)
    except FileError as error:
        endings = ", ".join([".rexs", ".rexsj", ".rexsz", *ENDINGS])
        rule = said("must end in {endings}", endings=endings)
        raise FileError(rule, source=path, example=error.example) from None


def check_wanted(ending: str, wanted: Wanted) -> None:
    """Refuse what a format does not have.

    Raises
    ------
    InputError
        Naming the option.
    """
    known = ENDINGS[ending].options if ending else ()
    for name in (one.name for one in fields(Wanted)):
        if getattr(wanted, name) not in (None, (), False) and name not in known:
            rule = said("is not for files that end in {ending}", ending=ending or ".rexs")
            raise InputError(rule, field=f"--{name}")
    if ending == ".toml" and wanted.ross is None:
        raise InputError(
            said("is missing: elements for ROSS need its version"), field="ross",
            example=arguments(ross=3),
        )  # fmt: skip


def _ross(
    subject: Machine | Case, ending: str, wanted: Wanted, progress: Progress | None
) -> Written:
    from rolamento.rotors import natural_modes

    damping = wanted.damping or 0.0
    found = mapped(
        subject, wanted.over, points=wanted.points or POINTS, bearing=wanted.bearing,
        with_housing=True, progress=progress,
    )  # fmt: skip
    elements = ross_bearings(found.maps, found.machine, levers=wanted.levers)
    if ending == ".toml":
        text = bearing_file(elements, wanted.ross or 3, found.machine, damping=damping)
    else:
        if found.machine is None:
            raise InputError(
                said("is a bearing alone; a rotor is made of a machine"), field="MACHINE",
                example="rolamento export machine.toml -o rotor.py",
            )  # fmt: skip
        own = natural_modes(found.machine, damping=damping).frequency
        text = ross_script(found.machine, elements, frequencies=own, damping=damping)
    notes = tuple(note for one in elements for note in one.notes)
    return Written("ross", text.encode("utf-8"), found, elements, notes)


def _tables(
    subject: Machine | Case, ending: str, wanted: Wanted, progress: Progress | None
) -> Written:
    found = mapped(
        subject,
        wanted.over,
        points=wanted.points or POINTS,
        bearing=wanted.bearing,
        progress=progress,
    )
    if ending == ".mat":
        content = maps_to_mat(found.maps)
    else:
        make = maps_to_csv if ending == ".csv" else maps_to_modelica
        content = make(found.maps).encode("utf-8")
    return Written("table", content, found)


def _fmu(
    subject: Machine | Case, ending: str, wanted: Wanted, progress: Progress | None
) -> Written:
    if isinstance(subject, Machine) and wanted.bearing is None and len(subject.bearings) > 1:
        names = ", ".join(one.name for one in subject.bearings)
        raise InputError(
            said("is missing: an FMU is of one bearing; one of {names}", names=names),
            field="bearing",
            example=arguments(bearing=subject.bearings[0].name),
        )
    # with a point between every two, by which what is linear between them is judged
    found = mapped(
        subject,
        wanted.over,
        points=2 * (wanted.points or POINTS) - 1,
        bearing=wanted.bearing,
        progress=progress,
    )
    kept, apart = between_points(found.maps[0])
    content = fmu_bytes(kept, wanted.fmi or 3, damping=wanted.damping or 0.0)
    note = Note("fmu_between_points", {"apart": apart})
    return Written("fmu", content, Mapped(found.subject, (kept,)), notes=(note,))


def _workbook(
    subject: Machine | Case, ending: str, wanted: Wanted, progress: Progress | None
) -> Written:
    if not isinstance(subject, Machine):
        raise InputError(
            said("is a bearing alone; a workbook is of a machine"),
            field="MACHINE",
            example="rolamento export machine.toml -o machine.xlsx",
        )
    return Written("workbook", machine_to_xlsx(subject))


_Make = Callable[[Machine | Case, str, Wanted, Progress | None], Written]


@frozen
class Format:
    """A format: how a file is made, and which of `Wanted` it has."""

    make: _Make
    options: tuple[str, ...]


_MAP: Final = ("over", "points", "bearing")
ENDINGS: Final[dict[str, Format]] = {
    ".toml": Format(_ross, (*_MAP, "ross", "damping", "levers")),
    ".py": Format(_ross, ("over", "points", "damping", "levers")),
    ".csv": Format(_tables, _MAP),
    ".mat": Format(_tables, _MAP),
    ".txt": Format(_tables, _MAP),
    ".xlsx": Format(_workbook, ()),
    ".fmu": Format(_fmu, (*_MAP, "fmi", "damping")),
}
"""The formats by the endings of their files, but for REXS."""
