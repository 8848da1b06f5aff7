"""What the data files of the reproductions hold, and what every reproduction needs to read them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from rolamento.io.data import toml_of
from rolamento_reproductions.record import Floats, Series
from rolamento_reproductions.text import Prose, Text

MILLI: Final = 1e-3
KILO: Final = 1e3


@dataclass(frozen=True, slots=True)
class Given:
    """A data file: inputs and printed numbers; their places in the source are in its prose."""

    name: str

    @property
    def data(self) -> dict[str, Any]:
        """All of it."""
        return toml_of(self.name, "rolamento_reproductions")

    def inputs_of(self, name: str) -> dict[str, Any]:
        """Return one of its tables."""
        table: dict[str, Any] = self.data[name]
        return table

    def source_of(self, name: str) -> Text:
        """Return where a table's inputs stand, or how they were chosen."""
        return Prose(self.name)(f"source.{name}")


def grid(lowest: float, highest: float, step: float) -> Floats:
    """Return numbers from the lowest to the highest, both included."""
    return np.linspace(lowest, highest, round((highest - lowest) / step) + 1)


def status_column(codes: Iterable[str]) -> Series:
    """Return how each case ended, such as `rolamento.solved.Status.code`."""
    return Series("status", "", Prose("")("status"), tuple(map(str, codes)))
