"""What notes about a machine say."""

from __future__ import annotations

from typing import Final

from rolamento.words.sentences import Sentence
from rolamento.words.speaking import marked

__all__ = ["SENTENCES"]

SENTENCES: Final[dict[str, Sentence]] = {
    "bore_beside_shaft": marked(
        "Bearing {bearing} has a bore of {bore:.6g mm}, and the shaft there a diameter of"
        " {seat:.6g mm}."
    ),
}
