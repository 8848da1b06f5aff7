"""Machines from the files of other programs, and to them."""

from __future__ import annotations

import os
from collections.abc import Sequence

from rolamento.analysis.machine import analyse_machine
from rolamento.case.machine import load_machine
from rolamento.catalogue import catalogues as catalogues_beside
from rolamento.errors import InputError
from rolamento.exchange.rexs import (
    Exported,
    Imported,
    machine_of_rexs,
    read_rexs,
    rexs_of_machine,
)

__all__ = ["exported_machine", "imported_machine"]


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
