"""What the theories of life are called, and what each is for, by their names in the engine."""

from __future__ import annotations

from typing import Final

from rolamento.words.speaking import marked, said

__all__ = ["theory_heads", "theory_life", "theory_name", "theory_scope"]

_NAMES: Final = {
    "iso281": marked("ISO 281, basic"),
    "iso281_modified": marked("ISO 281, modified"),
    "iso281_1990": marked("ISO 281:1990, adjusted"),
    "iso16281": marked("ISO/TS 16281, basic"),
    "iso16281_modified": marked("ISO/TS 16281, modified"),
    "ioannides_harris": marked("Ioannides and Harris"),
    "l_able": marked("NSK, L_able"),
    "tallian": marked("Tallian's form"),
}
_HEADS: Final = {
    "iso281": ("ISO 281", marked("basic")),
    "iso281_modified": ("ISO 281", marked("modified")),
    "iso281_1990": ("281:1990", marked("adjusted")),
    "iso16281": ("TS 16281", marked("basic")),
    "iso16281_modified": ("TS 16281", marked("modified")),
    "ioannides_harris": ("Ioannides", "Harris"),
    "l_able": ("NSK", "L_able"),
    "tallian": ("Tallian", marked("form")),
}
_LIVES: Final = {
    "iso281": marked("basic rating life, ISO 281"),
    "iso281_modified": marked("modified rating life, ISO 281"),
    "iso281_1990": marked("adjusted rating life, ISO 281:1990"),
    "iso16281": marked("basic reference rating life, ISO/TS 16281"),
    "iso16281_modified": marked("modified reference rating life, ISO/TS 16281"),
    "ioannides_harris": marked("stress-volume life, Ioannides and Harris"),
    "l_able": marked("L_able, NSK"),
    "tallian": marked("life by Tallian's form"),
}
_SCOPES: Final = {
    "iso281": marked(
        "one row, rows in tandem, or a pair back to back or face to face; P up to C/2 and C_0. "
        "Lubrication and contamination are not considered."
    ),
    "iso281_modified": marked(
        "as the basic one, for κ ≥ 0.1 and without severe contamination (e_C > 0)."
    ),
    "iso281_1990": marked("as the basic one; a_2 and a_3 are the user's."),
    "iso16281": marked(
        "any load, tilt, clearance, preload, set of rows and speed, ball by ball; P_ref up to C/2 "
        "and C_0. Lubrication and contamination are not considered."
    ),
    "iso16281_modified": marked(
        "as the basic one, for κ ≥ 0.1 and without severe contamination (e_C > 0)."
    ),
    "ioannides_harris": marked(
        "clean oil and thick films: subsurface-initiated fatigue only. An upper bound."
    ),
    "l_able": marked("P up to C/2 and C_0, at 20 rpm or more and 130 °C or less."),
    "tallian": marked("P_ref up to C/2 and C_0; as good as its factors, which are the user's."),
}


def theory_name(theory: str) -> str:
    """Return what a theory is called in a table: ``"ISO 281, basic"``."""
    return said(_NAMES[theory]) if theory in _NAMES else theory


def theory_heads(theory: str) -> tuple[str, str]:
    """Return what stands over its column, in two lines."""
    first, second = _HEADS[theory]
    return first, said(second)


def theory_life(theory: str) -> str:
    """Return what the life by a theory is called: ``"modified rating life, ISO 281"``."""
    return said(_LIVES[theory])


_SCOPES_OF_ROLLERS: Final = {
    "iso16281": marked(
        "any load, tilt, clearance, preload, set of rows and speed, slice by slice of every "
        "roller; P_ref up to C/2 and C_0. Lubrication and contamination are not considered."
    ),
}
"""Where their names differ."""


def theory_scope(theory: str, element: str = "ball") -> str:
    """Say what a theory is for."""
    scopes = _SCOPES if element == "ball" else _SCOPES | _SCOPES_OF_ROLLERS
    return said(scopes[theory])
