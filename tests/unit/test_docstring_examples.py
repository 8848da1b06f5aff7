"""The examples of the docstrings are run: their numbers are the program's, and a reader's."""

from __future__ import annotations

import doctest
import importlib
from pathlib import Path

import pytest

import rolamento

SOURCE = Path(rolamento.__file__).parent


def _modules() -> list[str]:
    found = []
    for path in sorted(SOURCE.rglob("*.py")):
        if ">>> " in path.read_text(encoding="utf-8"):
            parts = path.relative_to(SOURCE.parent).with_suffix("").parts
            found.append(".".join(parts).removesuffix(".__init__"))
    return found


MODULES = _modules()


@pytest.mark.parametrize("name", MODULES)
def test_examples(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    failures, tried = doctest.testmod(importlib.import_module(name), verbose=False)
    assert tried
    assert not failures


def test_the_verbs_have_examples() -> None:
    verbs = importlib.import_module("rolamento.verbs")
    named = [*(getattr(verbs, name) for name in verbs.__all__), rolamento.diagnose]
    named += [rolamento.solve, rolamento.analyse, rolamento.fault_frequencies]
    without = [one.__name__ for one in named if ">>> " not in (one.__doc__ or "")]
    assert not without
