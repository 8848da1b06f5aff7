"""The data files that come with the package."""

from __future__ import annotations

import tomllib
from functools import cache
from importlib import resources
from typing import Any


@cache
def shipped_table(path: str) -> dict[str, Any]:
    """Return a TOML file of the package, such as ``"data/materials.toml"``; not to be changed."""
    return tomllib.loads((resources.files("rolamento") / path).read_text(encoding="utf-8"))
