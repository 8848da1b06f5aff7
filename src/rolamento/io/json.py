"""Results as plain data, JSON and CSV: no arrays, nothing for a number that does not exist."""

from __future__ import annotations

import json
from collections.abc import Mapping
from math import isfinite
from typing import Any, Final

import numpy as np

__all__ = ["csv_number", "dumps", "plain"]


_AS_THEY_ARE: Final = frozenset({str, int, bool, type(None)})


def plain(value: Any) -> Any:
    """Return arrays as lists, NumPy's numbers as Python's, what is not finite as None.

    Mappings become dicts, and tuples lists, at any depth.
    """
    kind = type(value)
    if kind is float:
        return value if isfinite(value) else None
    if kind in _AS_THEY_ARE:
        return value
    if isinstance(value, np.ndarray | np.generic):
        whole = value.dtype.kind == "f" and np.isfinite(value).all()
        value = value.tolist()
        return value if whole else plain(value)
    if isinstance(value, Mapping):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    return None if isinstance(value, float) and not isfinite(value) else value


def dumps(value: Any, indent: int | None = None) -> str:
    """Return data as JSON text, made `plain` where they are not."""
    try:
        return json.dumps(value, indent=indent, ensure_ascii=False, allow_nan=False)
    except (TypeError, ValueError):
        return json.dumps(plain(value), indent=indent, ensure_ascii=False, allow_nan=False)


def csv_number(value: float) -> str:
    """Write a number with a decimal point and ten digits; nothing for one that does not exist."""
    return f"{value:.10g}" if isfinite(value) else ""
