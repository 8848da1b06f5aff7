"""`rolamento import` and `rolamento export`: machines from and to the files of other programs."""

from __future__ import annotations

import os
from typing import Annotated

import typer

from rolamento.cli.common import NO_RESULT, SOLVED, plain_endings, same_file
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import (
    CataloguesOption,
    ForceOption,
    LanguageOption,
    MachineArgument,
    MachineSettingsOption,
    json_option,
)
from rolamento.cli.streams import STANDARD_STREAM, print_data, print_text, put, put_json, show
from rolamento.cli.waiting import waiting
from rolamento.errors import FileError, InputError
from rolamento.words import said

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
    " --set loads.0.fz='-8 kN'.",
)
def export(
    machine: MachineArgument,
    output: Annotated[
        str | None,
        typer.Option(
            "--output",
            "-o",
            metavar="FILE",
            help="File to write: .rexs (XML), .rexsj (JSON) or .rexsz (zipped); by default named "
            "after the machine file.",
        ),
    ] = None,
    settings: MachineSettingsOption = None,
    without_results: Annotated[
        bool,
        typer.Option("--without-results", help="Do not solve it: what is given alone is written."),
    ] = False,
    force: ForceOption = False,
    catalogues: CataloguesOption = None,
    json: Annotated[str | None, json_option("Write what others do not see as JSON")] = None,
    lang: LanguageOption = None,
) -> None:
    """Write a machine and its results as a REXS model.

    As version 2.0. What REXS has no word for stands in attributes that only Rolamento reads: read
    back, it is the same machine.
    """
    with plain_endings(lang):
        path = _named_after(machine, "machine", ".rexs") if output is None else output
        _check_output(path, machine, json, force)
        from rolamento.exchange.rexs import check_ending, rexs_bytes, write_rexs
        from rolamento.tasks.exchange import exported_machine

        if path != STANDARD_STREAM:
            check_ending(path)
        with waiting(lang):
            found = exported_machine(
                machine, settings or (), catalogues or (), results=not without_results
            )
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
        unsolved = any(note.key == "rexs_unsolved" for note in found.notes)
    raise typer.Exit(NO_RESULT if unsolved else SOLVED)


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
