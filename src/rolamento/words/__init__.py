"""Words: languages, numbers as people write them, notes and their sentences."""

from rolamento.words.elements import worded
from rolamento.words.manner import (
    ABSENT,
    ENDLESS,
    UNITS,
    Manner,
    Written,
    decimals_for,
    in_unit,
    unit_of,
    unit_sign,
)
from rolamento.words.note import Note
from rolamento.words.speaking import (
    code_asked,
    counted,
    language,
    language_asked,
    language_of,
    languages,
    manner,
    marked,
    said,
    said_in,
    speaking,
    spelling,
)

__all__ = [
    "ABSENT",
    "ENDLESS",
    "UNITS",
    "Manner",
    "Note",
    "Written",
    "code_asked",
    "counted",
    "decimals_for",
    "in_unit",
    "language",
    "language_asked",
    "language_of",
    "languages",
    "manner",
    "marked",
    "said",
    "said_in",
    "speaking",
    "spelling",
    "unit_of",
    "unit_sign",
    "worded",
]
