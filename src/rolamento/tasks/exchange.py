"""Machines from the files of other programs, and to them: use cases, each a request."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final, Self

from pydantic import model_validator

from rolamento.case import Case
from rolamento.case.machine import Machine
from rolamento.catalogue import catalogues
from rolamento.errors import FileError, InputError, arguments
from rolamento.io.json import dumps, plain
from rolamento.records import frozen
from rolamento.tasks.case_request import Finding, FindingRequest, in_json
from rolamento.tasks.machines import CATALOGUES, MachineRequest
from rolamento.tasks.parameters import Progress, quietly
from rolamento.tasks.request import FORCE, Input
from rolamento.words import Note, marked, said

if TYPE_CHECKING:
    from rolamento.exchange.ross import RossBearing
    from rolamento.tasks.maps import Mapped

__all__ = ["ENDINGS", "ExportRequest", "ImportRequest", "Written"]

_STANDARD_STREAM: Final = "-"
_MAPPED: Final = {"over": (), "points": 9, "bearing": None}
"""What each format takes that has tables, and what it is unless it is given."""
_ALWAYS: Final = {**_MAPPED, "ross": None, "fmi": None, "damping": None, "levers": False}


def _named_after(source: str, ending: str) -> str:
    """A name in the current folder that says where a file comes from."""
    name = os.path.basename(source) if source != _STANDARD_STREAM else "machine"
    for end in (".rexs.xml", ".rexs.json", ".rexs.zip"):
        name = name.removesuffix(end)
    return (os.path.splitext(name)[0] or "machine") + ending


class ImportRequest(FindingRequest):
    """Make a machine file from a REXS model.

    REXS is the format in which programs exchange gear units. Shows what was taken, what was
    inferred, and what was left out.

    Parameters
    ----------
    model
        REXS file: .rexs (XML), .rexsj (JSON) or .rexsz (zipped); - for standard input.
    output
        Machine file to write, .toml or .json, by default named after the model; - is standard
        output.
    load_case
        Load case to take, of a model that has several.
    force
        Overwrite files that are there.
    catalogues
        A catalogue of your own, CSV or TOML, for designations.
    """

    model: Annotated[Any, Input("", "file", essential=True, metavar="MODEL")]
    output: Annotated[Any, Input("", "target", metavar="FILE")] = None
    load_case: Annotated[int | None, Input("", "count", example="1", metavar="NUMBER")] = None
    force: Annotated[bool, FORCE] = False
    catalogues: Annotated[Any, CATALOGUES] = ()

    shows_page: ClassVar = False
    json_meaning: ClassVar = "Write what was taken, inferred and left out as JSON"
    examples: ClassVar = (
        "Examples: import gearbox.rexs; import gearbox.rexsz -o machine.toml --json taken.json."
    )

    @model_validator(mode="after")
    def _refuse_files_of_our_own(self) -> Self:
        source = os.fspath(self.model)
        if not source.lower().endswith(".toml"):
            return self
        raise FileError(
            said(
                "is not a REXS model, which is XML, JSON or a zip archive; a case file is for "
                "`rolamento solve`, a machine file for `rolamento shaft`"
            ),
            source=source,
        )

    @property
    def target(self) -> str:
        """Name of the machine file; after the model where none is given."""
        return str(self.output or _named_after(os.fspath(self.model), ".toml"))

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it, an `Imported`."""
        from rolamento.exchange.rexs import machine_of_rexs, read_rexs
        from rolamento.pages.exchange import import_page

        model = read_rexs(self.model)
        with catalogues(self.catalogues):
            try:
                found = machine_of_rexs(model, load_case=self.load_case)
            except InputError as error:
                source = error.source or os.fspath(self.model)
                raise error.with_details(source=source) from None
        path, command = self.target, f"rolamento shaft {self.target}"
        text = said("Wrote {path}; now try: {command}", path=path, command=command)
        return Finding(found, partial(import_page, found), in_json(found), text=f"\n{text}\n")

    def content(self, found: Any) -> str:
        """Return the machine file."""
        return str(found.found.machine.to_toml())

    def write(self, found: Any, path: str) -> None:
        """Write the machine file."""
        from rolamento.case.machine import save_machine

        save_machine(found.found.machine, path)


class ExportRequest(MachineRequest):
    """Write a machine or its bearings for another program.

    REXS 2.0 has the machine and its results; what it has no word for stands in attributes that only
    Rolamento reads. The other formats have stiffness and force of the bearings, as they are solved
    over speed or any other field.

    Parameters
    ----------
    machine
        Machine file (TOML, JSON or .xlsx); but for REXS, rotors and workbooks also a case file or a
        designation; - for standard input.
    output
        File to write, whose ending says the format: .rexs, .rexsj, .rexsz (REXS, by default); .toml
        (elements for ROSS, with `ross`), .py (rotors for ROSS); .csv, .mat (MATLAB), .txt
        (Modelica): tables of stiffness and force; .fmu (FMI); .xlsx (the machine as a workbook).
    settings
        Override a field of the machine or the case.
    without_results
        REXS: do not solve it: what is given alone is written.
    over
        Field over which bearings are solved, such as loads.0.fz=1..10kN; by default the speed, from
        rest. At most two fields.
    points
        Values of each field, by default 9.
    bearing
        Bearing, instead of all.
    ross
        ROSS: 3 or 2.
    fmi
        FMI: 3 (default) or 2.
    levers
        ROSS: two elements a bearing, so far apart that they resist tilt as it does.
    damping
        Damping over stiffness, in s; none by default.
    force
        Overwrite files that are there.
    """

    output: Annotated[Any, Input("", "target", metavar="FILE")] = None
    without_results: Annotated[bool, Input("", "switch")] = False
    over: Annotated[
        tuple[str, ...],
        Input(
            "", "list", example="loads.0.fz=1..10kN", separator="", metavar="KEY=FIRST..LAST",
            at_computer=True,
        ),
    ] = ()  # fmt: skip
    points: Annotated[int, Input("", "count", example="9")] = 9
    bearing: Annotated[str | None, Input(metavar="NAME")] = None
    ross: Annotated[int | None, Input("", "count", example="3", metavar="VERSION")] = None
    fmi: Annotated[int | None, Input("", "count", example="3", metavar="VERSION")] = None
    levers: Annotated[bool, Input("", "switch")] = False
    damping: Annotated[float | None, Input("", "number", metavar="S")] = None
    force: Annotated[bool, FORCE] = False

    shows_page: ClassVar = False
    counts: ClassVar = True
    waiting: ClassVar = marked("operating points")
    json_meaning: ClassVar = "Write what others do not see, and what was solved, as JSON"
    examples: ClassVar = (
        "Examples: export machine.toml; export machine.toml -o gearbox.rexsz"
        " --set loads.0.fz='-8 kN'; export machine.toml -o rotor.py; export machine.toml --ross 3"
        " -o bearings.toml; export 6310.toml -o stiffness.csv --over duty.load.fz=1..20kN."
    )

    @property
    def target(self) -> str:
        """Name of the file; after the machine where none is given."""
        usual = "_ross.toml" if self.ross is not None else ".rexs"
        return str(self.output or _named_after(os.fspath(self.machine), usual))

    @property
    def ending(self) -> str:
        """Ending of that name if it is one of `ENDINGS`; else empty, of a REXS model.

        What goes to standard output is of ROSS if a version of that is asked for.
        """
        if self.target == _STANDARD_STREAM and self.ross is not None:
            return ".toml"
        ending = os.path.splitext(self.target)[1].lower()
        return ending if ending in ENDINGS else ""

    def check_target(self, path: str) -> None:
        """Refuse a name that ends as no file that can be written."""
        if self.ending or path == _STANDARD_STREAM:
            return
        from rolamento.exchange.rexs import check_ending

        try:
            check_ending(path)
        except FileError as error:
            endings = ", ".join([".rexs", ".rexsj", ".rexsz", *ENDINGS])
            raise error.with_details(rule=said("must end in {endings}", endings=endings)) from None

    @model_validator(mode="after")
    def _goes_with_the_format(self) -> Self:
        known = ENDINGS[self.ending].options if self.ending else ("without_results",)
        for name in (*_ALWAYS, "without_results"):
            if name not in known and getattr(self, name) != _ALWAYS.get(name, False):
                ending = self.ending or ".rexs"
                rule = said("is not for files that end in {ending}", ending=ending)
                raise InputError(rule, source=name)
        if self.ending == ".toml" and self.ross is None:
            rule = said("is missing: elements for ROSS need its version")
            raise InputError(rule, field="ross", example=arguments(ross=3))
        return self

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it: a `Written`, or an `Exported` of REXS."""
        if not self.ending:
            return self._rexs()
        from rolamento.pages.exchange import written_page
        from rolamento.tasks.maps import read_subject

        with catalogues(self.catalogues):
            subject = read_subject(self.machine, self.settings)
            found = ENDINGS[self.ending].make(subject, self.ending, self, progress)
        page = partial(written_page, found, self.target)
        return Finding(found, page, in_json(found), is_result=found.converged)

    def _rexs(self) -> Finding:
        from rolamento.analysis.machine import analyse_machine
        from rolamento.exchange.rexs import rexs_of_machine
        from rolamento.pages.exchange import export_page

        with self.loaded() as machine:
            found = rexs_of_machine(machine if self.without_results else analyse_machine(machine))
        notes = [note.to_mapping() for note in found.notes]
        return Finding(
            found, partial(export_page, found, self.target),
            lambda: dumps({"schema": 1, "kind": "rexs_export", "notes": notes}, indent=2),
            is_result=not any(note.key == "rexs_unsolved" for note in found.notes),
        )  # fmt: skip

    def content(self, found: Any) -> bytes:
        """Return the file."""
        if self.ending:
            return bytes(found.found.content)
        from rolamento.exchange.rexs import rexs_bytes

        is_named = self.target != _STANDARD_STREAM
        name = os.path.basename(self.target) if is_named else "model.rexs"
        return rexs_bytes(found.found.model, name)


# --- to programs that are none for gear units -----------------------------------------------------


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


def _ross(
    subject: Machine | Case, ending: str, wanted: ExportRequest, progress: Progress
) -> Written:
    from rolamento.exchange.ross import bearing_file, ross_bearings, ross_script
    from rolamento.rotors import natural_modes
    from rolamento.tasks.maps import mapped

    damping = wanted.damping or 0.0
    found = mapped(
        subject, wanted.over, points=wanted.points, bearing=wanted.bearing,
        with_housing=True, progress=progress,
    )  # fmt: skip
    elements = ross_bearings(found.maps, found.machine, levers=wanted.levers)
    if ending == ".toml":
        text = bearing_file(elements, wanted.ross or 3, found.machine, damping=damping)
    else:
        if found.machine is None:
            raise InputError(
                said("is a bearing alone; a rotor is made of a machine"), field="machine",
                example=arguments(output="rotor.py"),
            )  # fmt: skip
        own = natural_modes(found.machine, damping=damping).frequency
        text = ross_script(found.machine, elements, frequencies=own, damping=damping)
    notes = tuple(note for one in elements for note in one.notes)
    return Written("ross", text.encode("utf-8"), found, elements, notes)


def _tables(
    subject: Machine | Case, ending: str, wanted: ExportRequest, progress: Progress
) -> Written:
    from rolamento.exchange.tables import maps_to_csv, maps_to_mat, maps_to_modelica
    from rolamento.tasks.maps import mapped

    found = mapped(
        subject, wanted.over, points=wanted.points, bearing=wanted.bearing, progress=progress
    )
    if ending == ".mat":
        content = maps_to_mat(found.maps)
    else:
        make = maps_to_csv if ending == ".csv" else maps_to_modelica
        content = make(found.maps).encode("utf-8")
    return Written("table", content, found)


def _fmu(
    subject: Machine | Case, ending: str, wanted: ExportRequest, progress: Progress
) -> Written:
    from rolamento.exchange.fmi import between_points, fmu_bytes
    from rolamento.tasks.maps import Mapped, mapped

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
        points=2 * wanted.points - 1,
        bearing=wanted.bearing,
        progress=progress,
    )
    kept, apart = between_points(found.maps[0])
    content = fmu_bytes(kept, wanted.fmi or 3, damping=wanted.damping or 0.0)
    note = Note("fmu_between_points", {"apart": apart})
    return Written("fmu", content, Mapped(found.subject, (kept,)), notes=(note,))


def _workbook(
    subject: Machine | Case, ending: str, wanted: ExportRequest, progress: Progress
) -> Written:
    from rolamento.exchange.workbook import machine_to_xlsx

    if not isinstance(subject, Machine):
        raise InputError(
            said("is a bearing alone; a workbook is of a machine"),
            field="machine",
            example=arguments(output="machine.xlsx"),
        )
    return Written("workbook", machine_to_xlsx(subject))


_Make = Callable[[Machine | Case, str, ExportRequest, Progress], Written]


@frozen
class Format:
    """A format: how a file is made, and which fields of an `ExportRequest` it has."""

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
