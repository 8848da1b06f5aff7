"""The reference of the public names: a page for every package, from the docstrings."""

from __future__ import annotations

import ast
import importlib
import inspect
import pkgutil
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any, Final

__all__ = [
    "on_attributes",
    "on_bases",
    "on_docstring",
    "on_member",
    "on_signature",
    "packages",
    "public_of",
    "write_pages",
]

_FACES: Final = ("rolamento.cli", "rolamento.__main__", "rolamento.web")
"""Described by their own references: the commands, the HTTP API."""
_CODE: Final = re.compile(
    r"(``.+?``|`[^`]+`|:\w+:`[^`]+`|\*\*\w.*?\*\*|(?<![\w*])\*\w[^*]*\w\*(?![\w*]))"
)

_ARRAY: Final = re.compile(
    r"~?(?:numpy\.)?ndarray\[tuple\[~?(?:typing\.)?Any, \.\.\.\],"
    r" ~?(?:numpy\.)?dtype\[(~?[\w.]+)\]\]"
)


def packages() -> list[str]:
    """Return the packages and modules at the top of the program, in alphabetical order."""
    import rolamento

    names = ["rolamento"]
    for module in pkgutil.iter_modules(rolamento.__path__, "rolamento."):
        if module.name not in _FACES and not module.name.rpartition(".")[2].startswith("_"):
            names.append(module.name)
    return names


def public_of(package: str) -> Iterator[tuple[ModuleType, tuple[str, ...]]]:
    """Yield the modules to be described for a package, each with its public names.

    A package that exports nothing itself is its modules; one that says nothing at all (no
    ``__all__``) has what is defined in it.
    """
    module = importlib.import_module(package)
    names = _names_in(module)
    if names or not hasattr(module, "__path__"):
        yield module, names
        return
    for inner in pkgutil.iter_modules(module.__path__, f"{package}."):
        if not inner.name.rpartition(".")[2].startswith("_"):
            yield from public_of(inner.name)


def _names_in(module: ModuleType) -> tuple[str, ...]:
    if hasattr(module, "__all__"):
        return tuple(name for name in module.__all__ if not name.startswith("__"))
    return tuple(
        name
        for name, value in vars(module).items()
        if not name.startswith("_")
        and getattr(value, "__module__", None) == module.__name__
        and (inspect.isclass(value) or callable(value))
    )


def write_pages(folder: Path) -> None:
    """Write a page for every package into a folder; a page that is as it was stays untouched."""
    folder.mkdir(parents=True, exist_ok=True)
    known: dict[int, str] = {}
    wanted = set()
    # what is re-exported is described where it comes from, and named at the top
    for package in [*packages()[1:], "rolamento"]:
        path = folder / f"{package}.rst"
        wanted.add(path)
        text = _page(package, known)
        if not path.exists() or path.read_text("utf-8") != text:
            path.write_text(text, "utf-8")
    for path in set(folder.glob("*.rst")) - wanted:
        path.unlink()


def _page(package: str, known: dict[int, str]) -> str:
    described = list(public_of(package))
    pieces = [f"{package}\n{'=' * len(package)}\n"]
    alone = len(described) == 1 and described[0][0].__name__ == package
    if not alone:
        pieces.append(_docstring(importlib.import_module(package)))
    for module, names in described:
        if not alone:
            pieces.append(f"{module.__name__}\n{'-' * len(module.__name__)}\n")
        pieces += [_docstring(module), f".. py:currentmodule:: {module.__name__}\n"]
        if len(names) > 3:
            links = (f":py:obj:`{name} <{module.__name__}.{name}>`" for name in names)
            pieces.append(".. rst-class:: names\n\n" + " · ".join(links) + "\n")
        elsewhere = []
        for name in names:
            value = getattr(module, name)
            place = known.get(id(value)) if _is_described(value) else None
            if place is not None:
                elsewhere.append(f"- ``{name}``: :py:obj:`{place}`")
                continue
            if _is_described(value):
                known[id(value)] = f"{module.__name__}.{name}"
            pieces.append(_entry(module, name, value))
        if elsewhere:
            links = "\n".join(elsewhere)
            pieces.append(f"Also here, described where they belong:\n\n{links}\n")
    return "\n".join(pieces).rstrip() + "\n"


def _docstring(module: ModuleType) -> str:
    return "\n".join([*escaped((inspect.getdoc(module) or "").splitlines()), ""])


def _is_described(value: object) -> bool:
    return inspect.isclass(value) or inspect.isroutine(value) or hasattr(value, "py_func")


def _entry(module: ModuleType, name: str, value: object) -> str:
    if inspect.isclass(value):
        kind = "exception" if issubclass(value, BaseException) else "class"
    elif callable(value) and (inspect.isroutine(value) or hasattr(value, "py_func")):
        kind = "function"
    else:
        return _constant(module, name)
    options = "" if kind == "function" else "   :members:\n"
    if inspect.isclass(value) and any(map(_is_own, value.__bases__)):
        options += "   :show-inheritance:\n"
    return f".. auto{kind}:: {module.__name__}.{name}\n{options}"


def _constant(module: ModuleType, name: str) -> str:
    lines = escaped(text_of_constant(module.__name__, name).splitlines())
    inner = "\n".join(f"   {line}".rstrip() for line in lines)
    return f".. py:data:: {module.__name__}.{name}\n\n{inner}\n"


@cache
def _tree_of(module: str) -> ast.Module:
    path = inspect.getsourcefile(importlib.import_module(module)) or ""
    return ast.parse(Path(path).read_text("utf-8"))


def text_of_constant(module: str, name: str) -> str:
    """Return what stands below an assignment, in the module that it is imported from; or ""."""
    body = _tree_of(module).body
    for place, node in enumerate(body):
        if isinstance(node, ast.ImportFrom):
            for one in node.names:
                if (one.asname or one.name) == name:
                    return text_of_constant(str(node.module), one.name)
        targets = node.targets if isinstance(node, ast.Assign) else [getattr(node, "target", None)]
        if any(isinstance(one, ast.Name) and one.id == name for one in targets):
            below = body[place + 1] if place + 1 < len(body) else None
            if isinstance(below, ast.Expr) and isinstance(below.value, ast.Constant):
                return inspect.cleandoc(str(below.value.value))
    return ""


# --- docstrings as they are written here ----------------------------------------------------------


def escaped(lines: list[str]) -> list[str]:
    """Return lines of prose in which bars, stars and trailing underscores are no markup."""
    found = []
    literal = False
    for line in lines:
        if literal and line.strip() and not line.startswith("    "):
            literal = False
        if literal or line.lstrip().startswith((">>>", "..")):
            found.append(line)
            continue
        literal = line.rstrip().endswith("::")
        pieces = _CODE.split(line)
        for place in range(0, len(pieces), 2):
            piece = re.sub(r"(?<!\\)([|*])", r"\\\1", pieces[place])
            pieces[place] = re.sub(r"(?<=\w)_(?!\w)", r"\\_", piece)
        found.append("".join(pieces))
    return found


def on_docstring(app: Any, what: str, name: str, obj: Any, options: Any, lines: list[str]) -> None:
    """Let Sphinx read a docstring as it is meant."""
    lines[:] = escaped(lines)


def on_attributes(app: Any, what: str, name: str, obj: Any, options: Any, lines: list[str]) -> None:
    """Keep attributes that share a description together: the first is no type of the second."""
    for place, line in enumerate(lines):
        if line.startswith(":ivar ") and ", " in line.split(":")[1]:
            _, names, text = line.split(":", 2)
            lines[place] = ":ivar " + names[5:].replace(", ", ",\u200b") + ":" + text


def on_signature(
    app: Any, what: str, name: str, obj: Any, options: Any, signature: str, returns: str
) -> tuple[str, str] | None:
    """Write a record by its fields and their defaults, and arrays as the source does."""
    fields = getattr(obj, "model_fields", None)
    if what in ("class", "exception") and fields:
        own = [f"{one}{_default(field)}" for one, field in fields.items()]
        return "(*, " + ", ".join(own) + ")", ""
    if not signature:
        return None
    if "Annotated[" in signature or " at 0x" in signature:
        return str(_bare(obj)), returns
    if "ndarray[" not in signature + (returns or ""):
        return None
    return _ARRAY.sub(r"NDArray[\1]", signature), _ARRAY.sub(r"NDArray[\1]", returns or "")


def _default(field: Any) -> str:
    if field.is_required():
        return ""
    value = field.default
    return f"={value!r}" if isinstance(value, str | int | float | None) else "=..."


def _bare(obj: Any) -> inspect.Signature:
    """A signature without types: those of constrained values are pages of pydantic's own words."""
    found = inspect.signature(obj)
    bare = [one.replace(annotation=inspect.Parameter.empty) for one in found.parameters.values()]
    return found.replace(parameters=bare, return_annotation=inspect.Signature.empty)


def on_bases(app: Any, name: str, obj: Any, options: Any, bases: list[type]) -> None:
    """Name the bases of the program alone."""
    bases[:] = filter(_is_own, bases)


def _is_own(base: type) -> bool:
    return base.__module__.startswith("rolamento")


def on_member(app: Any, what: str, name: str, obj: Any, skip: bool, options: Any) -> bool | None:
    """Leave out what pydantic and the language give to every record."""
    inner = getattr(obj, "fget", obj)
    module = getattr(inner, "__module__", None)
    if module is not None and not str(module).startswith("rolamento"):
        return True
    return True if name.startswith("model_") else None
