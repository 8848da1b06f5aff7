"""The tables that come with the package, from their TOML files."""

from __future__ import annotations

import tomllib
from functools import cache
from importlib import resources
from typing import Any

__all__ = ["toml_of"]


@cache
def toml_of(name: str, package: str = "rolamento") -> dict[str, Any]:
    """Return what ``data/NAME.toml`` of a package holds, read once; not to be changed.

    package: dotted; only its first part is imported.
    """
    top, *inner = package.split(".")
    file = resources.files(top).joinpath(*inner, "data", f"{name}.toml")
    return tomllib.loads(file.read_text(encoding="utf-8"))
