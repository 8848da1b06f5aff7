"""`rolamento import` and `rolamento export`: machines from and to the files of other programs."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated

import typer

from rolamento.cli.common import NO_RESULT, SOLVED, plain_endings, same_file
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import CataloguesOption, ForceOption, LanguageOption, json_option
from rolamento.cli.streams import STANDARD_STREAM, print_data, print_text, put, put_json, show
from rolamento.cli.waiting import progress_of, waiting
from rolamento.errors import FileError, InputError
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.tasks.exchange import Wanted

__all__ = ["app"]

_SCHEMA = 1

app = typer.Typer()


@app.command(
    "import",
    cls=JsonCommand,
    epilog="Examples: import gearbox.rexs; import gearbox.rexsz -o machine.toml --json taken.json.",
)
def import_(
    model: Annotated[
        str,
        typer.Argument(
            metavar="MODEL",
            help="REXS file: .rexs (XML), .rexsj (JSON) or .rexsz (zipped); - for standard input.",
        ),
    ],
    output: Annotated[
        str | None,
        typer.Option(
            "--output",
            "-o",
            metavar="FILE",
            help="Machine file to write, .toml or .json, by default named after the model; - is "
            "standard output.",
        ),
    ] = None,
    load_case: Annotated[
        int | None,
        typer.Option(
            "--load-case", metavar="NUMBER", help="Load case to take, of a model that has several."
        ),
    ] = None,
    force: ForceOption = False,
    catalogues: CataloguesOption = None,
    json: Annotated[
        str | None, json_option("Write what was taken, inferred and left out as JSON")
    ] = None,
    lang: LanguageOption = None,
) -> None:
    """Make a machine file of a REXS model.

    REXS is the format in which programs exchange gear units. Shows what was taken, what was
    inferred, and what was left out.
    """
    with plain_endings(lang):
        path = _named_after(model, "machine", ".toml") if output is None else output
        _check_output(path, model, json, force)
        from rolamento.tasks.exchange import imported_machine

        found = imported_machine(model, catalogues or (), load_case=load_case)
        if json is not None:
            put_json(found.to_mapping(), json)
        if path == STANDARD_STREAM:
            put(found.machine.to_toml(), path)
        else:
            from rolamento.case.machine import save_machine

            save_machine(found.machine, path)
        if STANDARD_STREAM not in (path, json):
            from rolamento.pages.exchange import import_page

            show(import_page(found))
            command = f"rolamento shaft {path}"
            print_text(
                "\n" + said("Wrote {path}; now try: {command}", path=path, command=command) + "\n"
            )
    raise typer.Exit(SOLVED)


@app.command(
    cls=JsonCommand,
    epilog="Examples: export machine.toml; export machine.toml -o gearbox.rexsz"
    " --set loads.0.fz='-8 kN'; export machine.toml -o rotor.py; export machine.toml --ross 3"
    " -o bearings.toml; export 6310.toml -o stiffness.csv --over duty.load.fz=1..20kN.",
)
def export(
    machine: Annotated[
        str,
        typer.Argument(
            metavar="MACHINE",
            help="Machine file (TOML, JSON or .xlsx); but for REXS, rotors and workbooks also a"
            " case file or a designation; - for standard input.",
        ),
    ],
    output: Annotated[
        str | None,
        typer.Option(
            "--output",
            "-o",
            metavar="FILE",
            help="File to write, whose ending says the format: .rexs, .rexsj, .rexsz (REXS, by"
            " default); .toml (elements for ROSS, with --ross), .py (rotors for ROSS); .csv, .mat"
            " (MATLAB), .txt (Modelica): tables of stiffness and force; .fmu (FMI); .xlsx (the"
            " machine as a workbook).",
        ),
    ] = None,
    settings: Annotated[
        list[str] | None,
        typer.Option(
            "--set",
            metavar="KEY=VALUE",
            help="Override a field of the machine or the case. Repeatable.",
        ),
    ] = None,
    without_results: Annotated[
        bool,
        typer.Option(
            "--without-results", help="REXS: do not solve it: what is given alone is written."
        ),
    ] = False,
    over: Annotated[
        list[str] | None,
        typer.Option(
            "--over",
            metavar="KEY=FIRST..LAST",
            help="Field over which bearings are solved, such as loads.0.fz=1..10kN; by default the"
            " speed, from rest. Repeatable, for two fields.",
        ),
    ] = None,
    points: Annotated[
        int | None,
        typer.Option("--points", metavar="N", help="Values of each field, by default 9."),
    ] = None,
    bearing: Annotated[
        str | None, typer.Option("--bearing", metavar="NAME", help="Bearing, instead of all.")
    ] = None,
    ross: Annotated[
        int | None, typer.Option("--ross", metavar="VERSION", help="ROSS: 3 or 2.")
    ] = None,
    fmi: Annotated[
        int | None, typer.Option("--fmi", metavar="VERSION", help="FMI: 3 (default) or 2.")
    ] = None,
    levers: Annotated[
        bool,
        typer.Option(
            "--levers",
            help="ROSS: two elements a bearing, so far apart that they resist tilt as it does.",
        ),
    ] = False,
    damping: Annotated[
        float | None,
        typer.Option(
            "--damping", metavar="S", help="Damping over stiffness, in s; none by default."
        ),
    ] = None,
    force: ForceOption = False,
    catalogues: CataloguesOption = None,
    json: Annotated[
        str | None, json_option("Write what others do not see, and what was solved, as JSON")
    ] = None,
    lang: LanguageOption = None,
) -> None:
    """Write a machine or its bearings for another program.

    REXS 2.0 has the machine and its results; what it has no word for stands in attributes that only
    Rolamento reads. The other formats have stiffness and force of the bearings, as they are solved
    over speed or any other field.
    """
    with plain_endings(lang):
        from rolamento.tasks.exchange import Wanted, check_wanted, ending_of

        wanted = Wanted(
            over=tuple(over or ()), points=points, bearing=bearing, ross=ross, fmi=fmi,
            damping=damping, levers=levers,
        )  # fmt: skip
        path = _usual_name(machine, wanted) if output is None else output
        _check_output(path, machine, json, force)
        ending = ending_of(path, wanted)
        check_wanted(ending, wanted)
        if ending:
            if without_results:
                rule = said("is not for files that end in {ending}", ending=ending)
                raise InputError(rule, field="--without-results")
            solved = _write_other(machine, path, wanted, settings or (), catalogues or (), json)
        else:
            solved = _write_rexs(
                machine, path, settings or (), catalogues or (), json, results=not without_results
            )
    raise typer.Exit(SOLVED if solved else NO_RESULT)


def _usual_name(machine: str, wanted: Wanted) -> str:
    """A name in the current folder that says what was asked for."""
    return _named_after(machine, "machine", "_ross.toml" if wanted.ross is not None else ".rexs")


def _write_other(
    machine: str,
    path: str,
    wanted: Wanted,
    settings: Sequence[str],
    catalogues: Sequence[str],
    json: str | None,
) -> bool:
    """Write what programs take in that are none for gear units; return whether all was solved."""
    from rolamento.io.writing import write_bytes
    from rolamento.tasks.exchange import written_for

    with progress_of(said("operating points")) as progress:
        found = written_for(machine, path, wanted, settings, catalogues, progress=progress)
    if json is not None:
        put_json(found.to_mapping(), json)
    if path == STANDARD_STREAM:
        print_data(found.content.decode("utf-8"))
    else:
        write_bytes(found.content, path)
    if STANDARD_STREAM not in (path, json):
        from rolamento.pages.exchange import written_page

        show(written_page(found, path))
    return found.converged


def _write_rexs(
    machine: str,
    path: str,
    settings: Sequence[str],
    catalogues: Sequence[str],
    json: str | None,
    *,
    results: bool,
) -> bool:
    """Write a REXS model; return whether it has results, if it should."""
    from rolamento.exchange.rexs import rexs_bytes, write_rexs
    from rolamento.tasks.exchange import check_rexs_ending, exported_machine

    if path != STANDARD_STREAM:
        check_rexs_ending(path)
    with waiting(None):
        found = exported_machine(machine, settings, catalogues, results=results)
    if json is not None:
        notes = [note.to_mapping() for note in found.notes]
        put_json({"schema": _SCHEMA, "kind": "rexs_export", "notes": notes}, json)
    if path == STANDARD_STREAM:
        print_data(rexs_bytes(found.model, "model.rexs").decode("utf-8-sig"))
    else:
        write_rexs(found.model, path)
    if STANDARD_STREAM not in (path, json):
        from rolamento.pages.exchange import export_page

        show(export_page(found, path))
    return not any(note.key == "rexs_unsolved" for note in found.notes)


def _named_after(source: str, usual: str, ending: str) -> str:
    """A name in the current folder that says where a file comes from."""
    name = os.path.basename(source) if source != STANDARD_STREAM else usual
    for end in (".rexs.xml", ".rexs.json", ".rexs.zip"):
        name = name.removesuffix(end)
    return (os.path.splitext(name)[0] or usual) + ending


def _check_output(path: str, source: str, json: str | None, force: bool) -> None:
    """Refuse outputs that run into each other or over what is read, and files that are there."""
    if json is not None and same_file(path, json):
        where = said("standard output") if path == STANDARD_STREAM else path
        raise InputError(
            said("only one of {options} can go there", options="--output, --json"), source=where
        )
    for one in (path, json):
        if one is not None and one != STANDARD_STREAM and same_file(one, source):
            raise FileError(said("is the file that is read; choose another name"), source=one)
    if path != STANDARD_STREAM and not force and os.path.lexists(path):
        raise InputError(said("already exists; --force overwrites it"), source=path)
