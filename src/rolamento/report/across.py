"""A field of a case and its values, as the first column of a table has them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.plots.axes_units import read_values
from rolamento.report.page import Page

if TYPE_CHECKING:
    from rolamento.studies.fields import Field

__all__ = ["place_text", "written_values"]

_DECADES: Final = 100.0
_PLACES: Final = {
    "en": ("everywhere", "at {value}", "from {least} to {greatest}"),
    "pt": ("em todos os pontos", "em {value}", "de {least} a {greatest}"),
}


def written_values(page: Page, values: NDArray[np.float64]) -> list[str]:
    """Write the values of a field, each with its own digits where they span decades."""
    if np.abs(values).max() > _DECADES * np.abs(values).min() > 0.0:
        return [page.digits.short(float(value), 4) for value in values]
    return page.digits.column(values.tolist(), 5, 6)


def place_text(
    page: Page, field: Field, values: NDArray[np.float64], where: NDArray[np.bool_]
) -> str:
    """Say at which values of a field something is the case: everywhere, at one, between two."""
    everywhere, at, between = _PLACES.get(page.words.code, _PLACES["en"])
    if where.all():
        return everywhere
    across, symbol = read_values(field, values)
    some = across[where]
    least, greatest = (page.digits.short(float(v), 4) for v in (some.min(), some.max()))
    if least == greatest:
        return f"{at.format(value=least)} {symbol}"
    return f"{between.format(least=least, greatest=greatest)} {symbol}"
