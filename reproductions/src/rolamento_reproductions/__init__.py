"""Figures and tables of a publication, computed anew: pictures, data and an index page.

`find` gives a source by name, `computed` its figures and tables, `write` the folder.
"""

from __future__ import annotations

from importlib import import_module
from typing import Final

from rolamento.errors import InputError, nearest
from rolamento_reproductions.record import Source
from rolamento_reproductions.writing import computed, open_folder, write

__all__ = ["NAMES", "computed", "find", "open_folder", "write"]

_MODULES: Final = {
    "radaelli-2013": "rolamento_reproductions.radaelli_2013",
    "ricci-fleury": "rolamento_reproductions.ricci_fleury",
    "braga-almeida": "rolamento_reproductions.braga_almeida",
    "campanha-2008": "rolamento_reproductions.campanha_2008",
}
NAMES: Final = tuple(_MODULES)
"""What can be reproduced."""


def find(name: str) -> Source:
    """Return the source of a name.

    Raises
    ------
    InputError
        If there is none; the message names the nearest, or all.
    """
    module = _MODULES.get(name)
    if module is None:
        near = nearest(name, NAMES)
        advice = f"did you mean {near}?" if near else f"known here: {', '.join(NAMES)}"
        raise InputError(f"cannot be reproduced; {advice}", value=name)
    source: Source = import_module(module).SOURCE
    return source
