"""What a text is shown on: how wide it is, its colours, the characters that it can show."""

from __future__ import annotations

import sys
import unicodedata
from typing import Final, Literal, TextIO

from rolamento.errors import printable
from rolamento.records import frozen

__all__ = ["Medium"]

ColorSystem = Literal["auto", "standard", "256", "truecolor", "windows"]

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
        As Rich names them; ``None`` for plain text.
    encoding
        Of what is written there.
    """

    width: int = NARROWEST
    colors: ColorSystem | None = None
    encoding: str = "utf-8"

    @classmethod
    def of(cls, stream: TextIO) -> Medium:
        """Find out what a stream can show; a pipe or a file gets plain text."""
        from rich.console import Console

        console = Console(file=stream)
        colors: dict[str | None, ColorSystem] = {
            "standard": "standard", "256": "256", "truecolor": "truecolor", "windows": "windows"
        }  # fmt: skip
        return cls(
            width=min(max(console.width, NARROWEST), WIDEST),
            colors=None if console.no_color else colors.get(console.color_system),
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
