"""The words of code and guides are the field's: no dialect in docstrings, names and prose."""

from __future__ import annotations

import ast
import importlib
import inspect
import re
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest

import rolamento

ROOT = Path(__file__).resolve().parents[2]
SOURCES = [*(ROOT / "src").rglob("*.py"), *(ROOT / "reproductions" / "src").rglob("*.py")]
OTHERS = {"_build", "adr", "gallery", "api"}
"""Folders of docs that are made, or that record what was decided when."""
GUIDES = [
    *(path for path in (ROOT / "docs").rglob("*.md") if not OTHERS & {*path.parts}),
    *(ROOT / name for name in ("README.md", "CHANGELOG.md", "CONTRIBUTING.md")),
]
FRAGMENTS = re.compile(r"(?:Of|How many|In all|Likewise)\b")
"""Beginnings of docstrings that name nothing."""
DIALECT = re.compile(r"\b(tells?|told|telling|reckon(?:s|ed)?|unheld|abreast)\b", re.I)
APART = re.compile(r"\b(?:tell|tells|told)\b (?:\w+ ){0,6}apart\b", re.I)
"""To tell things apart is English."""
NAMES = re.compile(
    r"(?:^|_)(wanted|told|tell|tells|asked|nobody|dirt|firm|little|wish|endless)(?:$|_)"
)


def docstrings(path: Path) -> Iterator[tuple[int, str]]:
    """Docstrings of modules, classes, functions, constants and fields, with their lines."""
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        body = getattr(node, "body", ())
        for part in body if isinstance(body, list) else ():
            value = getattr(getattr(part, "value", None), "value", None)
            if isinstance(part, ast.Expr) and isinstance(value, str):
                yield part.lineno, value


def prose(text: str) -> str:
    """A guide without its blocks and quotations of code, and what is made from the program."""
    text = re.sub(r"^(```|~~~).*?^\1", "", text, flags=re.S | re.M)
    text = re.sub(r"^(?: {4}|\t).*$", "", text, flags=re.M)
    return re.sub(r"`[^`]*`|<!--.*?-->", "", text, flags=re.S)


def test_docstrings_name_what_they_are_of() -> None:
    found = [
        f"{path.relative_to(ROOT)}:{line}: {text.strip().splitlines()[0]}"
        for path in SOURCES
        for line, text in docstrings(path)
        if FRAGMENTS.match(text.strip())
    ]
    assert found == []


def test_docstrings_without_dialect() -> None:
    found = [
        f"{path.relative_to(ROOT)}:{line}: {match[0]}"
        for path in SOURCES
        for line, text in docstrings(path)
        if (match := DIALECT.search(APART.sub("", text)))
    ]
    assert found == []


@pytest.mark.parametrize("path", GUIDES, ids=lambda path: str(path.relative_to(ROOT)))
def test_guides_without_dialect(path: Path) -> None:
    if "pt-BR" in path.name:
        return
    text = APART.sub("", prose(path.read_text("utf-8")))
    assert [match[0] for match in DIALECT.finditer(text)] == []


def public_names() -> Iterator[str]:
    """Names of the package, of what its subpackages export, of their parameters and attributes."""
    for package in sorted(rolamento._PACKAGES):
        module = importlib.import_module(f"rolamento.{package}")
        for name in getattr(module, "__all__", ()):
            yield f"{package}.{name}"
            one = getattr(module, name)
            own: Iterable[str] = ()
            if inspect.isclass(one):
                own = (attribute for attribute in vars(one) if not attribute.startswith("_"))
            elif inspect.isfunction(one):
                own = inspect.signature(one).parameters
            yield from (f"{package}.{name}.{part}" for part in own)


def test_public_names_are_the_fields() -> None:
    names = list(public_names())
    assert len(names) > 1500
    assert [name for name in names if NAMES.search(name.rpartition(".")[2].lower())] == []
