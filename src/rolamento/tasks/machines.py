"""A machine from its file to all that follows."""

from __future__ import annotations

import os
from collections.abc import Sequence
from contextlib import nullcontext

from rolamento.analysis.machine import MachineAnalysis, analyse_machine
from rolamento.case.machine import load_machine

__all__ = ["analysed_machine"]


def analysed_machine(
    source: str | os.PathLike[str],
    settings: Sequence[str] = (),
    catalogues: Sequence[str | os.PathLike[str]] = (),
) -> MachineAnalysis:
    """Read a machine, solve it, and find what follows for its bearings.

    Parameters
    ----------
    source
        Its file.
    settings
        That go over it, as of `rolamento.case.load_machine`.
    catalogues
        Files of catalogues of one's own, for designations.

    Raises
    ------
    InputError, FileError
        As `rolamento.case.load_machine` and `analyse_machine`.
    """
    from rolamento.catalogue import catalogues as among

    with among(catalogues) if catalogues else nullcontext():
        return analyse_machine(load_machine(source, settings))
