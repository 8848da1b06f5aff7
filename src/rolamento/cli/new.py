"""`rolamento new` and `rolamento examples`: files to start from."""

from __future__ import annotations

import os
from typing import Annotated

import typer

from rolamento.cli.common import plain_endings
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import CataloguesOption, ForceOption, LanguageOption
from rolamento.cli.streams import STANDARD_STREAM, print_text, put
from rolamento.errors import InputError
from rolamento.io.writing import write_bytes, write_text
from rolamento.words import said

__all__ = ["app", "examples", "new"]

app = typer.Typer()


@app.command(
    cls=JsonCommand,
    epilog="Examples: new 6310/C3; new 'S 6012 C' --lang pt -o spindle.toml; new --machine.",
)
def new(
    designation: Annotated[
        str | None,
        typer.Argument(
            metavar="DESIGNATION",
            help="Designation such as 6310/C3; without it the bearing is given by its geometry.",
        ),
    ] = None,
    output: Annotated[
        str | None,
        typer.Option(
            "--output",
            "-o",
            metavar="FILE",
            help="File to write, by default named after the bearing; - is standard output.",
        ),
    ] = None,
    machine: Annotated[
        bool,
        typer.Option(
            "--machine",
            help="A machine file instead: shafts on their bearings; as a workbook if FILE ends in"
            " .xlsx.",
        ),
    ] = False,
    force: ForceOption = False,
    catalogue: CataloguesOption = None,
    lang: LanguageOption = None,
) -> None:
    """Write a commented case file to start from.

    It solves as it is, and shows every field that there is, with an example.
    """
    from rolamento.catalogue import catalogues
    from rolamento.tasks.new_case import case_template, file_name, machine_template

    with plain_endings(lang), catalogues(catalogue or ()):
        if machine:
            _write_machine(machine_template(), designation, output, force)
            return
        path = file_name(designation) if output is None else output
        _check_ending(path)
        text = case_template(designation)
        if path == STANDARD_STREAM:
            put(text, path)
            return
        _write(text, path, force)
        command = " ".join(
            ["rolamento solve", path, *(f"--catalogue {own}" for own in catalogue or ())]
        )
        print_text(said("Wrote {path}; now try: {command}", path=path, command=command) + "\n")


def _write_machine(text: str, designation: str | None, output: str | None, force: bool) -> None:
    """Write the template of a machine, which is of no bearing in particular."""
    if designation is not None:
        raise InputError(
            said("cannot be combined with {before}", before="--machine"),
            source="DESIGNATION",
            value=designation,
        )
    path = "machine.toml" if output is None else output
    if path.lower().endswith(".xlsx"):
        from rolamento.tasks.new_case import machine_workbook

        _refuse_there(path, force)
        write_bytes(machine_workbook(), path, new=not force)
    else:
        _check_ending(path)
        if path == STANDARD_STREAM:
            put(text, path)
            return
        _write(text, path, force)
    command = f"rolamento shaft {path}"
    print_text(said("Wrote {path}; now try: {command}", path=path, command=command) + "\n")


@app.command(
    cls=JsonCommand,
    epilog="Examples: examples; examples 6310_motor; examples all -o gallery.",
)
def examples(
    name: Annotated[
        str | None,
        typer.Argument(metavar="NAME", help="Example to copy, such as 6310_motor; all: every one."),
    ] = None,
    output: Annotated[
        str,
        typer.Option(
            "--output", "-o", metavar="FOLDER", help="Folder to copy to; by default here."
        ),
    ] = ".",
    force: ForceOption = False,
    lang: LanguageOption = None,
) -> None:
    """List the shipped examples, or copy one or all of them.

    Case files, studies, duties, life tests and scripts, each with a command to try on it.
    """
    with plain_endings(lang):
        from rolamento.tasks.examples import copy_examples

        if name is None:
            print_text(_listed())
            return
        copied = copy_examples(name, output, force=force)
        paths = dict.fromkeys(path for example in copied.values() for path in example.files)
        lines = [said("Wrote {path}", path=path) for path in paths]
        lines += [said("Now try: {command}", command=one.command) for one in copied.values()]
        print_text("\n".join(lines) + "\n")


def _listed() -> str:
    """Return every example with what it shows and a command, and how to copy one."""
    from rolamento.tasks.examples import EXAMPLES

    lines = [
        f"{name}\n    {said(one.shows)}\n    {one.command}\n" for name, one in EXAMPLES.items()
    ]
    copying = said("To copy one: rolamento examples NAME; every one: rolamento examples all")
    return "".join([*lines, "\n", copying, "\n"])


def _check_ending(path: str) -> None:
    if path != STANDARD_STREAM and not path.lower().endswith(".toml"):
        raise InputError(said("must end in .toml"), source=path, example="case.toml")


def _write(text: str, path: str, force: bool) -> None:
    """Write a file; one that is there only if that is meant."""
    _refuse_there(path, force)
    write_text(text, path, new=not force)


def _refuse_there(path: str, force: bool) -> None:
    if not force and os.path.lexists(path):
        raise InputError(said("already exists; --force overwrites it"), source=path)
