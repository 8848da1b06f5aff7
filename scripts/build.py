"""What a build does beside copying files: it compiles the catalogues of words, and the tables."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class Compiled(BuildHookInterface):  # type: ignore[type-arg]
    """Runs before a wheel or an editable installation is put together."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Compile every catalogue and every table beside its source."""
        root = Path(self.root)
        sys.path[:0] = [str(root / "scripts"), str(root / "src")]
        from words import LOCALE, compile_

        from rolamento.io.data import as_json

        for table in (root / "src").glob("rolamento/**/data/*.toml"):
            table.with_suffix(".json").write_text(as_json(table.read_bytes()), encoding="utf-8")

        for language in sorted(path.name for path in LOCALE.iterdir() if path.is_dir()):
            compile_(language)
