"""The parts of the reference that are made from the program: Markdown, by their names.

A page of `docs/reference` has a mark where one of them stands, ``<!-- made: fields -->``.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any, Final

from rolamento.web.openapi import openapi_document
from rolamento.words import said, speaking

__all__ = ["PARTS", "made", "table"]

ROOT: Final = Path(__file__).resolve().parents[2]
DATA: Final = ROOT / "src" / "rolamento" / "data"
_NO_VALUES: Final[Mapping[str, Any]] = {}


def made(part: str) -> str:
    """Return a part of the reference.

    Raises
    ------
    KeyError
        If there is none of that name.
    """
    with speaking("en"):
        return PARTS[part]()


def table(heads: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a table in Markdown."""
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join("| " + " | ".join(map(_cell, line)) + " |" for line in lines) + "\n"


def _cell(text: str) -> str:
    return " ".join(text.replace("``", "`").split()).replace("|", "\\|")


_POWERS: Final = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


def _unit(text: str) -> str:
    """A unit as a person writes it; empty of a number without one."""
    if text in ("", "1"):
        return ""
    powers = re.sub(r"\^(-?\d+)", lambda found: found[1].translate(_POWERS), text)
    return powers.replace("*", "·")


def _code(text: str) -> str:
    return f"`{text}`" if text else ""


# --- commands -------------------------------------------------------------------------------------


def commands() -> str:
    """Return every command with all its options, as its own help has them."""
    from typer.main import get_command

    from rolamento.cli.app import COMMANDS, app

    program: Any = get_command(app)
    pieces = []
    for heading, names in COMMANDS.items():
        pieces.append(f"## {heading}\n")
        pieces += [_command(program.commands[name], f"rolamento {name}", 3) for name in names]
    missing = set(program.commands) - {name for names in COMMANDS.values() for name in names}
    others = sorted(name for name in missing if not program.commands[name].hidden)
    if others:
        pieces.append("## Others\n")
        pieces += [_command(program.commands[name], f"rolamento {name}", 3) for name in others]
    pieces.append("## Of the program itself\n")
    pieces.append(_parameters(program, "rolamento"))
    return "\n".join(pieces)


def _command(command: Any, path: str, level: int) -> str:
    from rolamento.cli.grouped_help import unwrapped

    pieces = [f"{'#' * level} `{path}`\n", _prose(unwrapped(command.help or ""))]
    inner = getattr(command, "commands", {})
    if not inner:
        pieces.append(_parameters(command, path))
    if command.epilog:
        pieces.append(_examples(unwrapped(command.epilog)))
    pieces += [_command(one, f"{path} {name}", level + 1) for name, one in inner.items()]
    return "\n".join(piece for piece in pieces if piece)


def _prose(text: str) -> str:
    return text.replace("*", "\\*").replace("<", "&lt;").replace("\b", "") + "\n"


def _examples(text: str) -> str:
    """The examples of an epilogue, a line each; other words as they are."""
    words, mark, listed = text.partition("Examples: ")
    if not mark:
        words, mark, listed = text.partition("Example: ")
    lines = "\n".join(f"rolamento {one.strip()}" for one in listed.rstrip(". ").split("; "))
    examples = f"```text\n{lines}\n```\n" if mark else ""
    return "\n".join(piece for piece in (_prose(words) if words.strip() else "", examples) if piece)


def _parameters(command: Any, path: str) -> str:
    context = command.make_context(path, [], resilient_parsing=True)
    rows = []
    for parameter in command.get_params(context):
        record = parameter.get_help_record(context)
        if record is not None:
            rows.append((_code(record[0]), _prose(record[1] or "")))
    return table(("argument or option", "meaning"), rows)


# --- fields ---------------------------------------------------------------------------------------


def fields() -> str:
    """Return every field of a case: unit, bounds, example, meaning."""
    from rolamento.case import Case

    return "\n".join(_tables_of(Case.fields(), "## ", ""))


def _tables_of(own: Mapping[str, Any], mark: str, before: str) -> list[str]:
    tables: dict[str, list[Any]] = {}
    for field in own.values():
        tables.setdefault(field.name.rpartition(".")[0], []).append(field)
    pieces = []
    for name, members in tables.items():
        heading = f"`[{before}{name}]`" if name or before else "At the top of the file"
        pieces.append(f"{mark}{heading}\n")
        pieces.append(table(_HEADS, [_field(field) for field in members]))
        for field in members:
            if field.entries:
                entries = {one: value for one, value in field.entries.items() if "." not in one}
                pieces.append(f"Each entry of `{field.name}`, `[[{field.name}]]`, has:\n")
                pieces.append(table(_HEADS, [_field(value) for value in entries.values()]))
    return pieces


_HEADS: Final = ("field", "unit", "allowed", "meaning")


def _field(field: Any) -> tuple[str, ...]:
    table_of = field.name.rpartition(".")[0] + "."
    allowed = [", ".join(map(_code, field.choices)) or field.limits]
    if field.example:
        allowed.append(f"such as {_code(field.example)}")
    if field.replaces:
        others = ", ".join(_code(one.removeprefix(table_of)) for one in field.replaces)
        allowed.append(f"in place of {others}")
    label = field.label if field.label not in (field.name, field.leaf) else ""
    return (
        _code(field.leaf) + (f"<br>{label}" if label else ""),
        _unit(field.unit),
        "<br>".join(filter(None, allowed)),
        field.meaning,
    )


def outputs() -> str:
    """Return what a study may put out: names, units and meanings."""
    from rolamento.studies import outputs as found

    rows = [
        (_code(one.name), _unit(one.unit) or "–", one.along or "case", one.long_name)
        for one in found.catalogue().values()
    ]
    return table(("output", "unit", "one for each", "meaning"), rows)


# --- notes ----------------------------------------------------------------------------------------


def notes() -> str:
    """Return the sentence of every note, by chapter and key."""
    from importlib import import_module
    from pkgutil import iter_modules

    from rolamento.words import sentences as package

    pieces = []
    for chapter in iter_modules(package.__path__):
        module = import_module(f"{package.__name__}.{chapter.name}")
        pieces.append(f"## {_heading(chapter.name)}\n\n{(module.__doc__ or '').splitlines()[0]}\n")
        rows = [(_code(key), _sentences(said_of)) for key, said_of in module.SENTENCES.items()]
        pieces.append(table(("key", "sentence"), rows))
    return "\n".join(pieces)


def _heading(name: str) -> str:
    return name.replace("_", " ").capitalize()


def _sentences(sentence: Any) -> str:
    """A sentence with its places; of one that depends on its values, all its forms."""
    if isinstance(sentence, str):
        return _code_places(sentence)
    return " / ".join(map(_code_places, dict.fromkeys(_texts_in(sentence)))) or "depends on values"


def _texts_in(function: Any) -> Iterable[str]:
    """The texts that a function of sentences chooses from: in its code and what it closes over."""
    values = [cell.cell_contents for cell in function.__closure__ or ()]
    values += function.__code__.co_consts
    values += [function.__globals__.get(name) for name in function.__code__.co_names]
    for value in values:
        if isinstance(value, str):
            texts: Iterable[Any] = (value,)
        elif isinstance(value, Mapping):
            texts = value.values()
        else:
            texts = value if isinstance(value, tuple) else ()
        for text in texts:
            if not isinstance(text, str) or text == function.__doc__:
                continue
            if " " in text and text[:1].isupper() and text[-1] in ".:}":
                yield text


def _code_places(sentence: str) -> str:
    coded = re.sub(r"`[^`]*`|\{[^{}]*\}", lambda found: f"`{found[0].strip('`')}`", sentence)
    return coded.replace("<", "&lt;").replace("*", "\\*")


# --- what the program knows by name ---------------------------------------------------------------


def materials() -> str:
    """Return the materials of rings and balls."""
    listed = _data("materials.toml")["material"]
    return table(
        ("material", "also called", "E", "ν", "density", "source"),
        [
            (
                _code(one["name"]),
                ", ".join(one.get("aliases", ())),
                one["youngs_modulus"],
                str(one["poisson_ratio"]),
                one["density"],
                one["source"],
            )
            for one in listed
        ],
    )


def lubricants() -> str:
    """Return the lubricants by name, after the ISO VG grades."""
    data = _data("lubricants.toml")
    grades = data["grades"]
    numbers = ", ".join(f"`ISO VG {name}`" for name in grades["names"])
    rows = [
        (
            _code(one["name"]),
            one.get("kind", "oil"),
            one.get("viscosity_40", ""),
            one.get("viscosity_100", ""),
            one.get("density", ""),
            one["source"],
        )
        for one in data["lubricant"]
    ]
    return (
        f"{numbers}: viscosity index {grades['viscosity_index']:g}, density {grades['density']}."
        f" Source: {grades['source']}.\n\n"
        + table(("lubricant", "kind", "ν at 40 °C", "ν at 100 °C", "density", "source"), rows)
    )


def _data(name: str) -> dict[str, Any]:
    with (DATA / name).open("rb") as file:
        return tomllib.load(file)


# --- equations ------------------------------------------------------------------------------------


def laws() -> str:
    """Return the register of equations: what a report sets, numbered as they stand here."""
    from rolamento.pages import equations as register

    pieces = []
    for number, law in enumerate(register.EQUATIONS, 1):
        kind = {"ball": " Balls.", "roller": " Rollers.", "": ""}[law.rolls]
        symbols = [
            "{}: {}{}".format(symbol, meaning, f" ({unit})" if unit else "")
            for symbol, meaning, unit in (register.SYMBOLS[key] for key in law.symbols)
        ]
        pieces += [
            f"## {law.name}{': ' + law.rolls + 's' if law.rolls else ''}\n",
            f"```math\n{law.latex} \\tag{{{number}}}\n```\n",
            f"Source: {law.source}.{kind}" + (f" Valid for: {law.valid}." if law.valid else ""),
            "",
            ("Symbols: " + "; ".join(symbols) + ".\n") if symbols else "",
        ]
    pieces.append("## Works\n")
    pieces += [f"- {work}" for work in register.REFERENCES.values()]
    return "\n".join(pieces) + "\n"


# --- glossary -------------------------------------------------------------------------------------


def glossary() -> str:
    """Return the terms in both languages, from the terms of `glossary.toml` and the catalogue.

    Raises
    ------
    ValueError
        If a term is not in the catalogue of words.
    """
    rows = [
        (english, portuguese, term.get("symbol", ""), term.get("unit", "–"), term["meaning"])
        for english, portuguese, term in terms()
    ]
    return table(("English", "Português", "symbol", "unit", "meaning"), rows)


def terms() -> list[tuple[str, str, Mapping[str, str]]]:
    """Return the terms in English and in Portuguese, with their entries, in alphabetical order.

    Raises
    ------
    ValueError
        If a term is not in the catalogue of words.
    """
    found = []
    for term in sorted(glossary_file()["term"], key=lambda one: one["english"].casefold()):
        key = term.get("said", term["english"])
        portuguese = in_portuguese(key)
        if portuguese is None:
            raise ValueError(f"glossary.toml: {key!r} is not in the catalogue of words")
        if term["english"][0].islower():  # a heading of the program is a word here
            portuguese = portuguese[0].lower() + portuguese[1:]
        found.append((term["english"], portuguese, term))
    return found


@cache
def glossary_file() -> dict[str, Any]:
    """Return what `glossary.toml` holds."""
    with (Path(__file__).parent / "glossary.toml").open("rb") as file:
        return tomllib.load(file)


def symbols() -> str:
    """Return the symbols of the equations, in both languages."""
    from rolamento.pages import equations as register

    every = {**register.SYMBOLS, **{f"roller {k}": v for k, v in register.ROLLER_SYMBOLS.items()}}
    rows = [
        (symbol, meaning, in_portuguese(meaning) or meaning, unit or "–")
        for symbol, meaning, unit in every.values()
    ]
    return table(("symbol", "meaning", "significado", "unit"), sorted(set(rows), key=_by_letter))


def _by_letter(row: Sequence[str]) -> tuple[str, str]:
    return row[0].casefold(), row[1]


def labels() -> str:
    """Return what the fields of a case are called, in both languages."""
    from rolamento.case import Case

    rows = []
    for name, field in Case.fields().items():
        english = field.label
        with speaking("pt"):
            portuguese = field.label
        rows.append((_code(name), english, portuguese, _unit(field.unit) or "–"))
    return table(("field", "English", "Português", "unit"), rows)


def in_portuguese(text: str) -> str | None:
    """Return how the catalogue of words has a text; None where it has not."""
    with speaking("pt"):
        found = said(text, **_NO_VALUES)
    return found if found != text or text in _messages() else None


@cache
def _messages() -> frozenset[str]:
    path = ROOT / "src/rolamento/locale/pt_BR/LC_MESSAGES/rolamento.po"
    return frozenset(re.findall(r'^msgid "(.+)"$', path.read_text("utf-8"), re.MULTILINE))


# --- the HTTP API ---------------------------------------------------------------------------------


def http_api() -> str:
    """Return every operation of the HTTP API, from its own OpenAPI document."""
    return operations_of(openapi_document())


def operations_of(document: Mapping[str, Any]) -> str:
    """Return the operations of an OpenAPI document."""
    pieces = []
    base = str((document.get("servers") or [{"url": ""}])[0]["url"]).rstrip("/")
    for path, methods in document["paths"].items():
        for method, operation in methods.items():
            pieces.append(f"## `{method.upper()} {base}{path}`\n")
            pieces.append(_prose(operation.get("description") or operation.get("summary", "")))
            parameters = [
                (
                    _code(one["name"]),
                    one["in"],
                    _type_of(one.get("schema", {})),
                    _prose(one.get("description", "")),
                )
                for one in operation.get("parameters", ())
            ]
            if parameters:
                pieces.append(table(("parameter", "in", "type", "meaning"), parameters))
            body = operation.get("requestBody", {}).get("content", {})
            if body:
                kinds = [
                    f"`{kind}`: {_type_of(one.get('schema', {}))}" for kind, one in body.items()
                ]
                pieces.append("Body: " + "; ".join(kinds) + ".\n")
            answers = [
                (code, _prose(one.get("description", "")), _contents(one.get("content", {})))
                for code, one in operation["responses"].items()
            ]
            pieces.append(table(("status", "meaning", "content"), answers))
    schemas = document.get("components", {}).get("schemas", {})
    if schemas:
        pieces.append("## Records\n")
    for name, schema in sorted(schemas.items()):
        pieces.append(f"### {name}\n")
        if schema.get("description"):
            pieces.append(_prose(schema["description"].split("\n\n")[0]))
        required = schema.get("required", ())
        rows = [
            (
                _code(key) + (" (required)" if key in required else ""),
                _type_of(one),
                _prose(one.get("description", "")),
            )
            for key, one in schema.get("properties", {}).items()
        ]
        if rows:
            pieces.append(table(("name", "type", "meaning"), rows))
    return "\n".join(pieces)


def _contents(content: Mapping[str, Any]) -> str:
    return "; ".join(
        f"`{kind}`: {_type_of(one.get('schema', {}))}" for kind, one in content.items()
    )


def _type_of(schema: Mapping[str, Any]) -> str:
    if "$ref" in schema:
        return str(schema["$ref"]).rpartition("/")[2]
    if "anyOf" in schema or "oneOf" in schema:
        return " or ".join(map(_type_of, schema.get("anyOf") or schema["oneOf"]))
    if "enum" in schema:
        return ", ".join(_code(str(one)) for one in schema["enum"])
    if "const" in schema:
        return _code(str(schema["const"]))
    if schema.get("type") == "array":
        return f"list of {_type_of(schema.get('items', {}))}"
    return str(schema.get("type", "any"))


# --- pages of the project -------------------------------------------------------------------------


def changelog() -> str:
    """Return the changelog of the project, without its title."""
    return _without_title(ROOT / "CHANGELOG.md")


def examples() -> str:
    """Return the way to the gallery of the shipped examples; empty where it was not made."""
    if not (ROOT / "docs" / "gallery" / "examples" / "index.md").exists():
        return ""
    return (
        "- [Shipped examples](examples/index.md): every case file and script that comes with the"
        " program, run while this site was built"
    )


def _without_title(path: Path) -> str:
    text = path.read_text("utf-8")
    return text.partition("\n")[2] if text.startswith("# ") else text


def api_pages() -> str:
    """Return the list of the packages, each with what it is for."""
    import importlib
    import inspect

    from builder.api import packages

    rows = []
    for name in packages():
        first = (inspect.getdoc(importlib.import_module(name)) or "").partition("\n")[0]
        rows.append((f"[`{name}`](api/{name}.rst)", first))
    tree = "\n".join(f"{name} <api/{name}>" for name in packages())
    return table(("package", "what it is for"), rows) + (
        f"\n```{{toctree}}\n:hidden:\n\n{tree}\n```\n"
    )


PARTS: Final[Mapping[str, Callable[[], str]]] = {
    "api": api_pages,
    "changelog": changelog,
    "examples": examples,
    "commands": commands,
    "equations": laws,
    "fields": fields,
    "glossary": glossary,
    "http-api": http_api,
    "labels": labels,
    "lubricants": lubricants,
    "materials": materials,
    "notes": notes,
    "outputs": outputs,
    "symbols": symbols,
}
