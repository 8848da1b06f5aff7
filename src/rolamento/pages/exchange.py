"""The pages of `import` and `export`: what became of a model, and what did not."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from typing import TYPE_CHECKING

from rolamento.document import (
    Column,
    Document,
    Entry,
    KeyValues,
    Notes,
    Remark,
    Section,
    Table,
    Title,
)
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.exchange.rexs import Exported, Imported

__all__ = ["export_page", "import_page"]


def import_page(found: Imported) -> Document:
    """Return the page of an imported machine: what was taken, inferred and left out.

    Parameters
    ----------
    found
        Of `rolamento.tasks.exchange.imported_machine`.
    """
    title = found.machine.title or said("Machine without a title")
    by = said("REXS {version}, written by {application}", version=found.version,
              application=found.application or "–")  # fmt: skip
    parts = Counter(
        part.partition(".")[0] for one in found.taken for part in one.part.split(", ") if part
    )
    head = KeyValues((
        Entry(said("file"), by),
        Entry(said("machine"), ", ".join(f"{kind} {count}" for kind, count in parts.items())),
    ))  # fmt: skip
    names = {one.component: one.name for one in found.taken}
    return Document(
        title,
        (
            Section("", (Title(title), head), key="head"),
            _taken(found),
            *_remarks(said("Inferred"), "inferred", found, names),
            *_remarks(said("Left out"), "left", found, names),
        ),
        kind="rexs_import",
        main="taken",
    )


def _taken(found: Imported) -> Section:
    lines = [one for one in found.taken if one.part]
    columns = (
        Column(head=said("part"), key="part", values=[one.part for one in lines]),
        Column(head=said("name"), key="name", values=[one.name for one in lines]),
        Column(head=said("type"), key="type", values=[one.type for one in lines], once=True),
        Column(
            head=said("component"),
            key="component",
            values=[one.component for one in lines],
            only_in_files=True,
        ),
        Column(
            head=said("attributes read"),
            key="attributes",
            values=[" ".join(one.attributes) for one in lines],
            only_in_files=True,
        ),
    )
    return Section(said("Taken"), (Table(columns=columns, key="taken"),), key="taken")


def _remarks(heading: str, sort: str, found: Imported, names: dict[int, str]) -> Iterable[Section]:
    """Remarks of a sort: each said once, with the components that it is about."""
    about: dict[str, list[str]] = {}
    keys: dict[str, str] = {}
    for remark in found.of_sort(sort):
        text = remark.note.text
        keys[text] = remark.note.key
        of = about.setdefault(text, [])
        if remark.component is not None:
            name = names.get(remark.component) or said("component {id}", id=remark.component)
            if name not in of:
                of.append(name)
    if about:
        remarks = tuple(
            Remark(f"{', '.join(of)}: {text}" if of else text, keys[text])
            for text, of in about.items()
        )
        yield Section(heading, (Notes(remarks),), key=sort)


def export_page(found: Exported, path: str) -> Document:
    """Return the page of an exported machine: what the file holds, and what others do not see.

    Parameters
    ----------
    found
        Of `rolamento.tasks.exchange.exported_machine`.
    path
        Of the file that was written.
    """
    model = found.model
    title = said("Wrote {path}", path=path)
    parts = Counter(one.type for one in model.components)
    columns = (
        Column(head=said("components"), key="type", values=list(parts)),
        Column(head=said("count"), key="count", values=list(parts.values()), most=0),
    )
    sections = [
        Section("", (Title(title),), key="head"),
        Section(
            said("REXS {version}", version=model.version), (Table(columns=columns, key="parts"),),
            key="parts",
        ),
    ]  # fmt: skip
    if found.notes:
        remarks = {note.text: Remark(note.text, note.key) for note in found.notes}
        sections.append(Section(said("Notes"), (Notes(tuple(remarks.values())),), key="notes"))
    return Document(title, tuple(sections), kind="rexs_export", main="parts")
