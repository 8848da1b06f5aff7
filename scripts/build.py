"""What a build does beside copying files: it compiles the catalogues of words."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class CompiledCatalogues(BuildHookInterface):  # type: ignore[type-arg]
    """Runs before a wheel or an editable installation is put together."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Compile every catalogue beside its source."""
        sys.path.insert(0, str(Path(self.root) / "scripts"))
        from words import LOCALE, compile_

        for language in sorted(path.name for path in LOCALE.iterdir() if path.is_dir()):
            compile_(language)
