"""Where commands write to: checked before any work, so that none is lost at the end."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from rolamento.cli.common import same_file
from rolamento.cli.streams import STANDARD_STREAM
from rolamento.errors import FileError, InputError
from rolamento.words import marked, said

__all__ = ["check_outputs"]

_PICTURES: Final = ("--plot", "--contour", "--kurtogram")


def check_outputs(
    outputs: Mapping[str, str | None],
    *read: str | None,
    rule: str = marked("is the case file itself; choose another name"),
) -> None:
    """Refuse outputs that would run into each other or over what is read, and unknown pictures.

    Parameters
    ----------
    outputs
        Files by option; None where nothing is asked for.
    read
        Files that the command reads.
    rule
        What is wrong with an output that is one of those.

    Raises
    ------
    InputError, FileError
        For the first that will not do.
    """
    given = {option: path for option, path in outputs.items() if path is not None}
    for option, path in given.items():
        if sum(same_file(path, other) for other in given.values()) > 1:
            where = "standard output" if path == STANDARD_STREAM else path
            raise InputError(
                said("only one of {options} can go there", options=", ".join(outputs)), source=where
            )
        if path != STANDARD_STREAM and any(other and same_file(path, other) for other in read):
            raise FileError(said(rule), source=path)
        if option in _PICTURES:
            from rolamento.plots.saving import check_name

            check_name(path)
