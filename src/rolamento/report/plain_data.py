"""What programs read: JSON without NaN, numbers of CSV files."""

from __future__ import annotations

from math import isfinite
from typing import Any

from rolamento._json import dumps

__all__ = ["csv_number", "json_text"]


def json_text(mapping: dict[str, Any]) -> str:
    """Return a mapping as JSON: arrays as lists, ``null`` for what is not finite."""
    return dumps(mapping, indent=2)


def csv_number(value: float) -> str:
    """Write a number with a decimal point and ten digits; nothing for one that does not exist."""
    return f"{value:.10g}" if isfinite(value) else ""
