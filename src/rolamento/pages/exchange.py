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
    from rolamento.tasks.exchange import Written
    from rolamento.tasks.maps import Mapped

__all__ = ["export_page", "import_page", "written_page"]


def import_page(found: Imported) -> Document:
    """Return the page of an imported machine: what was taken, inferred and left out.

    Parameters
    ----------
    found
        Of a `rolamento.tasks.ImportRequest`.
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
            Section("", (Title(title), head), "head"),
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
        Column(said("part"), [one.part for one in lines], "part"),
        Column(said("name"), [one.name for one in lines], "name"),
        Column(said("type"), [one.type for one in lines], "type", once=True),
        Column(
            said("component"), [one.component for one in lines], "component", only_in_files=True
        ),
        Column(
            said("attributes read"),
            [" ".join(one.attributes) for one in lines],
            "attributes",
            only_in_files=True,
        ),
    )
    return Section(said("Taken"), (Table(columns, "taken"),), "taken")


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
        yield Section(heading, (Notes(remarks),), sort)


def export_page(found: Exported, path: str) -> Document:
    """Return the page of an exported machine: what the file holds, and what others do not see.

    Parameters
    ----------
    found
        Of a `rolamento.tasks.ExportRequest`, a REXS model.
    path
        Of the file that was written.
    """
    model = found.model
    title = said("Wrote {path}", path=path)
    parts = Counter(one.type for one in model.components)
    columns = (
        Column(said("components"), list(parts), "type"),
        Column(said("count"), list(parts.values()), "count", most=0),
    )
    sections = [
        Section("", (Title(title),), "head"),
        Section(said("REXS {version}", version=model.version), (Table(columns, "parts"),), "parts"),
    ]
    if found.notes:
        remarks = {note.text: Remark(note.text, note.key) for note in found.notes}
        sections.append(Section(said("Notes"), (Notes(tuple(remarks.values())),), "notes"))
    return Document(title, tuple(sections), kind="rexs_export", main="parts")


def written_page(found: Written, path: str) -> Document:
    """Return the page of a file for another program: what it has, and what it leaves out.

    Parameters
    ----------
    found
        Of a `rolamento.tasks.ExportRequest`.
    path
        Of the file that was written.
    """
    title = said("Wrote {path}", path=path)
    sections = [Section("", (Title(title),), "head")]
    if found.elements:
        sections.append(Section(said("Elements for ROSS"), (_elements(found),), "elements"))
    elif found.mapped is not None:
        sections.append(Section(said("Bearings"), (_maps(found.mapped),), "bearings"))
    if found.notes:
        remarks = {note.text: Remark(note.text, note.key) for note in found.notes}
        sections.append(Section(said("Notes"), (Notes(tuple(remarks.values())),), "notes"))
    return Document(title, tuple(sections), kind=f"{found.kind}_export", main="elements")


def _elements(found: Written) -> Table:
    lines = found.elements
    first = {one.of: one for one in reversed(lines)}

    def once(place: int) -> list[float | None]:
        return [one.left_out[place] if first[one.of] is one else None for one in lines]

    last = [one.stiffness[-1] for one in lines]
    columns = (
        Column(said("element"), [one.name for one in lines], "element"),
        Column(said("at"), [one.position for one in lines], "position", "mm"),
        Column(said("up to"), [float(one.speed[-1]) for one in lines], "speed", "rpm"),
        *(
            Column(f"k_{2 * axis}", [float(k[place, place]) for k in last], f"k{2 * axis}", "N/µm")
            for place, axis in enumerate("xyz")
        ),
        Column(said("left out:\nx, y–z"), once(0), "left_out_axial_radial", "N/µm"),
        Column(said("shift–tilt"), once(1), "left_out_shift_tilt", "N/mrad"),
        Column(said("tilt"), once(2), "left_out_tilt", "N·m/mrad"),
    )
    legends = (
        said(
            "x, y, z of ROSS are y, z, x of Rolamento: z is along the shaft; stiffness at the last"
            " speed. Elements of ROSS have no stiffness between shifts along and across the shaft,"
            " and none of tilts: the greatest of all speeds is what is left out"
        ),
    )
    return Table(columns, "elements", legends=legends)


def _maps(mapped: Mapped) -> Table:
    maps = mapped.maps
    missing = [int((one.status != "converged").sum()) for one in maps]
    columns = (
        Column(said("bearing"), [one.name for one in maps], "bearing"),
        Column(said("over"), [", ".join(axis.field for axis in one.axes) for one in maps], "over"),
        Column(said("points"), [one.status.size for one in maps], "points", most=0),
        Column(said("without a\nresult"), missing, "missing", most=0),
    )
    return Table(columns, "bearings")
