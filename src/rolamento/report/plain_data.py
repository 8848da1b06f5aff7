"""What programs read: JSON without NaN, numbers of CSV files."""

from __future__ import annotations

import json
from math import isfinite
from typing import Any

import numpy as np

__all__ = ["csv_number", "json_text"]


def json_text(mapping: dict[str, Any], indent: int | None = 2) -> str:
    """Return a mapping as JSON: arrays as lists, ``null`` for what is not finite."""
    return json.dumps(_plain(mapping), indent=indent, ensure_ascii=False, allow_nan=False)


def csv_number(value: float) -> str:
    """Write a number with a decimal point and ten digits; nothing for one that does not exist."""
    return f"{value:.10g}" if isfinite(value) else ""


def _plain(value: Any) -> Any:
    """Turn arrays into lists and what is not finite into None, at any depth."""
    if isinstance(value, np.ndarray | np.generic):
        return _plain(value.tolist())
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    return None if isinstance(value, float) and not isfinite(value) else value
