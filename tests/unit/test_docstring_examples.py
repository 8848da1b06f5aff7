"""The examples of the docstrings are run: their numbers are the program's, and a reader's."""

from __future__ import annotations

import ast
import doctest
import importlib
import inspect
import textwrap
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

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


EXPORTING = [
    "analysis", "catalogue", "clearance", "contact.hertz", "contact.line", "contact.subsurface",
    "friction", "geometry", "kinematics", "life", "lubrication", "oil", "plots", "ratings",
    "speeds", "static", "studies", "tasks", "units", "verification", "vibration", "weibull",
]  # fmt: skip


def _functions(module: ModuleType) -> list[Callable[..., object]]:
    try:
        names = module.__all__
    except AttributeError:
        names = [name for name in dir(module) if not name.startswith("_")]
    found = [getattr(module, name) for name in names]
    return [
        one for one in found if inspect.isfunction(one) and one.__module__.startswith("rolamento")
    ]


def test_the_stable_functions_describe_parameters_and_what_they_return() -> None:
    without = []
    for one in _functions(rolamento):
        text = inspect.getdoc(one) or ""
        signature = inspect.signature(one)
        if signature.parameters and "\nParameters\n---" not in text:
            without.append(f"{one.__name__}: Parameters")
        returns = signature.return_annotation not in (None, "None")
        if returns and not text.startswith("Return ") and "\nReturns\n---" not in text:
            without.append(f"{one.__name__}: Returns")
    assert not without


@pytest.mark.parametrize("package", ["", *EXPORTING])
def test_what_a_public_function_raises_is_in_its_docstring(package: str) -> None:
    module = importlib.import_module(".".join(filter(None, ("rolamento", package))))
    without = []
    for one in _functions(module):
        tree = ast.parse(textwrap.dedent(inspect.getsource(one)))
        raises = any(isinstance(node, ast.Raise) for node in ast.walk(tree))
        text = inspect.getdoc(one) or ""
        if raises and "\nRaises\n---" not in text and "errors as of `" not in text:
            without.append(one.__name__)
    assert not without
