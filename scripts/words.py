"""The catalogues of words: gather what the program says, and keep the translations in step.

    python scripts/words.py             bring the catalogues up to date, and compile them
    python scripts/words.py --check     name what is missing, unused, fuzzy or filled in otherwise
    python scripts/words.py --new fr    begin a further language

A catalogue is `src/rolamento/locale/<language>/LC_MESSAGES/rolamento.po`.
"""

from __future__ import annotations

import argparse
import re
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from babel.messages.catalog import Catalog, Message
from babel.messages.extract import extract_from_dir
from babel.messages.mofile import write_mo
from babel.messages.pofile import read_po, write_po

ROOT: Final = Path(__file__).parents[1]
SOURCE: Final = ROOT / "src" / "rolamento"
LOCALE: Final = SOURCE / "locale"
NAME: Final = "rolamento.po"

KEYWORDS: Final = {
    "said": None,
    "marked": None,
    "said_in": ((1, "c"), 2),
    "marked_in": ((1, "c"), 2),
    "counted": (1, 2),
}
_PLACE: Final = re.compile(r"\{[^{}]*\}|`[^`]+`")
"""What is filled in: values, and names in the spelling of whoever says the text."""


def template() -> Catalog:
    """Return all that the program says, in English."""
    catalogue = Catalog()
    for _, _, message, _, context in extract_from_dir(
        SOURCE,
        method_map=[("**.py", "python")],
        keywords=KEYWORDS,
        directory_filter=lambda folder: True,  # Babel would pass over private packages
    ):
        catalogue.add(message, context=context)
    for message, context in (*of_commands(), *of_requests(), *of_data()):
        catalogue.add(message, context=context)
    catalogue.add(".", context="decimal mark")
    return catalogue


def of_commands() -> Iterator[tuple[str, str | None]]:
    """Return what the help of the commands says, each with its context."""
    from typer.main import get_command

    from rolamento.cli.app import app
    from rolamento.cli.grouped_help import METAVAR, paragraphs

    pending = [get_command(app)]
    while pending:
        command = pending.pop()
        texts = [command.help, command.epilog, *command.groups]
        texts += [getattr(one, "help", None) for one in command.params]
        yield from ((one, None) for text in texts if text for one in paragraphs(text))
        marks = [command.options_metavar, getattr(command, "subcommand_metavar", None)]
        marks += [getattr(one, "metavar", None) for one in command.params]
        yield from ((mark, METAVAR) for mark in marks if mark)
        pending += getattr(command, "commands", {}).values()


def of_requests() -> Iterator[tuple[str, str | None]]:
    """Return what the use cases ask for: labels and meanings."""
    from rolamento import tasks
    from rolamento.tasks.request import Request

    for name in tasks.__all__:
        request = getattr(tasks, name)
        if isinstance(request, type) and issubclass(request, Request):
            meanings = request.meanings()
            for field, one in request.inputs().items():
                yield from ((text, None) for text in (one.label, meanings[field]) if text)


_TABLES = (
    "prefixes",
    "spindle_prefixes",
    "spindle_designs",
    "suffixes",
    "patterns",
    "clearance_halves",
    "sets",
    "universal",
    "preloads",
    "rings",
    "inserts",
    "insert_housings",
    "phrases",
    "roller_types",
    "roller_designs",
)
"""Of designations, whose values are meanings."""


def of_data() -> Iterator[tuple[str, str | None]]:
    """Return what stands in data files and is said, each with its context."""
    with (SOURCE / "data" / "designations.toml").open("rb") as file:
        data = tomllib.load(file)
    for kind in data["type"]:
        yield from ((kind[name], None) for name in ("name", "advice") if name in kind)
    yield from ((kind["name"], None) for kind in data["spindle"])
    for table in _TABLES:
        yield from ((meaning, None) for meaning in data[table].values())
    with (SOURCE / "data" / "equations.toml").open("rb") as file:
        data = tomllib.load(file)
    for law in data["equation"]:
        yield from ((law[name], None) for name in ("name", "source", "valid") if name in law)
    for table in ("symbols", "roller_symbols"):
        yield from ((meaning, None) for _, meaning, _ in data[table].values())


def translated(language: str, *, parts: bool = True) -> Catalog:
    """Return what a catalogue has, with the parts that are to be folded into it."""
    folder = LOCALE / language
    catalogue = Catalog(locale=language)
    found = sorted((folder / "parts").glob("*.po")) if parts else []  # the first found counts
    found.append(folder / "LC_MESSAGES" / NAME)
    for path in found:
        if not path.exists():
            continue
        with path.open("rb") as file:
            kept = read_po(file, locale=language)
        # its own plural forms, by which its messages are numbered: Babel's differ by release
        catalogue.mime_headers = [("Plural-Forms", kept.plural_forms)]
        for message in kept:
            if message.id and message.string:
                catalogue.add(
                    message.id, message.string, context=message.context, flags=message.flags
                )
    return catalogue


def merged(language: str) -> Catalog:
    """Return a catalogue with all that is said, translated as far as it is."""
    known, wanted = translated(language), template()
    catalogue = Catalog(locale=language, project="rolamento", fuzzy=False)
    catalogue.mime_headers = [("Plural-Forms", known.plural_forms)]
    for message in wanted:
        if not message.id:
            continue
        old = known.get(_key(message), message.context)
        if old is not None and isinstance(old.string, str) != isinstance(message.id, str):
            old = None  # it is counted now, or no more
        catalogue.add(
            message.id,
            None if old is None else old.string,
            context=message.context,
            flags=() if old is None else old.flags - {"python-format"},
        )
    return catalogue


def update(language: str) -> None:
    """Write a catalogue anew from the sources, and compile it."""
    folder = LOCALE / language / "LC_MESSAGES"
    folder.mkdir(parents=True, exist_ok=True)
    catalogue = merged(language)
    with (folder / NAME).open("wb") as file:
        write_po(file, catalogue, width=96, no_location=True, sort_output=True)
    header = re.compile(rb'^"(?:POT?-|Report-|Last-|Generated|Language-Team).*\n', re.M)
    text = (folder / NAME).read_bytes()
    (folder / NAME).write_bytes(header.sub(b"", re.sub(rb"\A(?:#.*\n)+", b"", text)))
    compile_(language)


def compile_(language: str) -> None:
    """Compile a catalogue, with the parts that are to be folded into it."""
    path = (LOCALE / language / "LC_MESSAGES" / NAME).with_suffix(".mo")
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("wb") as file:
        write_mo(file, translated(language))


def complaints(language: str) -> Iterator[str]:
    """Name what is wrong with a catalogue."""
    known, wanted = translated(language, parts=False), template()
    for message in wanted:
        if message.id and not _said(known.get(_key(message), message.context)):
            yield f"missing: {_key(message)!r}"
    for message in known:
        if not message.id:
            continue
        if wanted.get(_key(message), message.context) is None:
            yield f"unused: {_key(message)!r}"
        if message.fuzzy:
            yield f"fuzzy: {_key(message)!r}"
        allowed = _places(message.id)
        for text in _texts(message.string):
            if text and _places(text) - allowed:
                yield f"filled in otherwise: {_key(message)!r}: {text!r}"


def _key(message: Message) -> str:
    return message.id[0] if isinstance(message.id, tuple) else message.id


def _said(message: Message | None) -> bool:
    return message is not None and all(_texts(message.string))


def _texts(text: object) -> tuple[str, ...]:
    return tuple(text) if isinstance(text, tuple | list) else (str(text),)


def _places(text: object) -> set[str]:
    return {place for one in _texts(text) for place in _PLACE.findall(one)}


def main() -> int:
    """Do what the command line says."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--check", action="store_true", help="complain, change nothing")
    parser.add_argument("--compile", action="store_true", help="compile only")
    parser.add_argument("--new", metavar="LANGUAGE", help="begin a language, such as fr")
    options = parser.parse_args()
    if options.new:
        (LOCALE / options.new / "LC_MESSAGES").mkdir(parents=True, exist_ok=True)
        update(options.new)
    languages = sorted(path.name for path in LOCALE.iterdir() if path.is_dir())
    wrong = 0
    for language in languages:
        if options.check:
            for complaint in complaints(language):
                wrong += 1
                print(f"{language}: {complaint}")
        elif options.compile:
            compile_(language)
        else:
            update(language)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
