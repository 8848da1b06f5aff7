"""What a text is shown on: how wide it is, its colours, the characters that it can show."""

from __future__ import annotations

import os
import sys
import unicodedata
from typing import Final, TextIO

from rolamento.errors import printable
from rolamento.records import frozen

__all__ = ["Medium"]

NARROWEST: Final = 80
WIDEST: Final = 120

_PLAINER: Final = {
    "−": "-", "–": "-", "—": "-", "─": "-", "·": ".", "×": "x", "…": "...", "•": "*",
    "µ": "u", "μ": "u", "°": "deg", "³": "^3", "²": "^2", "±": "+/-", "≤": "<=", "≥": ">=",
    "α": "alpha", "ψ": "psi", "ω": "omega", "ν": "nu", "γ": "gamma", "δ": "delta", "τ": "tau",
    "Σ": "Sum ", "ρ": "rho", "ε": "epsilon", "θ": "theta", "σ": "sigma", "λ": "lambda", "Δ": "D",
    "κ": "kappa", "◂": "<", "▸": ">", "✓": "+", "✗": "x", "→": "->", "∥": "|", "’": "'", "“": '"',
    "”": '"', "β": "beta", "η": "eta", "∞": "inf",
}  # fmt: skip
_GRAPHICS: Final = "⣿█▏"


@frozen
class Medium:
    """A terminal, a file or a pipe.

    Parameters
    ----------
    width
        In characters.
    colors
        Whether it shows them.
    encoding
        Of what is written there.
    """

    width: int = NARROWEST
    colors: bool = False
    encoding: str = "utf-8"

    @classmethod
    def of(cls, stream: TextIO | None) -> Medium:
        """Find out what a stream can show; a pipe or a file gets plain text."""
        return cls(
            width=min(max(_columns(), NARROWEST), WIDEST),
            colors=_has_colors(stream),
            encoding=getattr(stream, "encoding", None) or sys.getdefaultencoding(),
        )

    @property
    def draws(self) -> bool:
        """Whether block and braille characters can be shown."""
        return self.shows(_GRAPHICS)

    def shows(self, text: str) -> bool:
        """Return whether the encoding has all characters of a text."""
        try:
            text.encode(self.encoding)
        except (UnicodeEncodeError, LookupError):
            return False
        return True

    def fitted(self, text: str) -> str:
        """Return the text with what cannot be shown replaced by something like it.

        What a terminal would act on is shown as an escape: colours are put on later.
        """
        text = printable(text)
        if self.shows(text):
            return text
        return "".join(c if self.shows(c) else self._replacement(c) for c in text)

    def _replacement(self, character: str) -> str:
        plainer = _PLAINER.get(character)
        if plainer is not None:
            return plainer
        base = unicodedata.normalize("NFKD", character).encode("ascii", "ignore").decode()
        return base or "?"


def _columns() -> int:
    """The width that the user gives, or that of the terminal at any of the standard streams."""
    given = os.environ.get("COLUMNS", "")
    if given.isdigit():
        return int(given)
    for descriptor in range(3):
        try:
            return os.get_terminal_size(descriptor).columns
        except (OSError, ValueError):
            continue
    return NARROWEST


def _has_colors(stream: TextIO | None) -> bool:
    """By `NO_COLOR <https://no-color.org>`_, `FORCE_COLOR <https://force-color.org>`_ and TERM."""
    if os.environ.get("NO_COLOR") or os.environ.get("TERM", "").lower() in ("dumb", "unknown"):
        return False
    forced = os.environ.get("FORCE_COLOR")
    return bool(forced) if forced is not None else stream is not None and stream.isatty()
