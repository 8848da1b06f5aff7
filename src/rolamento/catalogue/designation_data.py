"""What the parts of designations mean, from the data of the package."""

from __future__ import annotations

import tomllib
from functools import lru_cache
from importlib import resources
from typing import Any

__all__ = ["designation_data"]


@lru_cache(maxsize=1)
def designation_data() -> dict[str, Any]:
    """Return the tables of ``data/designations.toml``."""
    file = resources.files("rolamento") / "data" / "designations.toml"
    return tomllib.loads(file.read_text(encoding="utf-8"))
