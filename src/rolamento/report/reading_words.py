"""What was taken for what where a signal's file tells a thing twice, in a person's language."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from rolamento.report.language import words_for
from rolamento.vibration.reading import ReadingNote

__all__ = ["said_choice"]

_NOTES: Final[Mapping[str, Mapping[str, str]]] = {
    "en": {
        "rate_over_file": "The sampling rate is {rate} as given; the file says {file}.",
        "rate_over_doubt": "The sampling rate is {rate} as given; in the file {doubt}.",
        "rate_aside": "The sampling rate is {rate}; {name} = {value} of the file is not taken for"
        " one.",
        "speed_over_file": "The speed is {speed} as given; the file says {file}.",
    },
    "pt": {
        "rate_over_file": "A taxa de amostragem é {rate}, como dada; o arquivo diz {file}.",
        "rate_over_doubt": "A taxa de amostragem é {rate}, como dada; no arquivo há mais de uma"
        " ({doubt}).",
        "rate_aside": "A taxa de amostragem é {rate}; {name} = {value}, do arquivo, não é tomada"
        " por ela.",
        "speed_over_file": "A rotação é {speed}, como dada; o arquivo diz {file}.",
    },
}


def said_choice(note: ReadingNote, language: str) -> str:
    """Return a note on a signal's file in a language."""
    return _NOTES[words_for(language).code][note.name].format(**note.numbers)
