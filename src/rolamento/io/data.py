"""The tables that come with the package, from their TOML files.

Python reads TOML sixty times as slowly as JSON: a build leaves each table beside its file as JSON
too, and that is read as long as it is of the same text.
"""

from __future__ import annotations

import json
from functools import cache
from importlib import resources
from typing import Any
from zlib import crc32

__all__ = ["as_json", "toml_of"]


@cache
def toml_of(name: str, package: str = "rolamento") -> dict[str, Any]:
    """Return what ``data/NAME.toml`` of a package holds, read once; not to be changed.

    package: dotted; only its first part is imported.
    """
    top, *inner = package.split(".")
    folder = resources.files(top).joinpath(*inner, "data")
    source, made = folder / f"{name}.toml", folder / f"{name}.json"
    text = source.read_bytes()
    if made.is_file():
        ready = json.loads(made.read_bytes())
        if ready["crc32"] == crc32(text):
            return dict(ready["tables"])
    return _parsed(text)


def as_json(text: bytes) -> str:
    """Return what a TOML file holds as the JSON that `toml_of` takes in its place."""
    return json.dumps({"crc32": crc32(text), "tables": _parsed(text)}, separators=(",", ":"))


def _parsed(text: bytes) -> dict[str, Any]:
    import tomllib

    return tomllib.loads(text.decode("utf-8"))
