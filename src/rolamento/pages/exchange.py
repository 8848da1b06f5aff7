"""The pages of `import` and `export`: what became of a model, and what did not."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from typing import TYPE_CHECKING

from rolamento import document as doc
from rolamento.words import counted, said
from rolamento.words.naming import machine_title

if TYPE_CHECKING:
    from rolamento.exchange.rexs import Exported, Imported
    from rolamento.tasks.exchange import Written
    from rolamento.tasks.maps import Mapped

__all__ = ["export_page", "import_page", "written_page"]


def import_page(found: Imported) -> doc.Document:
    """Return the page of an imported machine: what was taken, inferred and left out.

    Parameters
    ----------
    found
        Of a `rolamento.tasks.ImportRequest`.
    """
    title = machine_title(found.machine.title)
    by = said("REXS {version}, written by {application}", version=found.version,
              application=found.application or "–")  # fmt: skip
    parts = Counter(
        part.partition(".")[0] for one in found.taken for part in one.part.split(", ") if part
    )
    head = doc.KeyValues((
        doc.Entry(said("file"), by),
        doc.Entry(said("machine"), ", ".join(_how_many(*one) for one in parts.items())),
    ))  # fmt: skip
    names = {one.component: one.name for one in found.taken}
    return doc.Document(
        title,
        (
            doc.Section("", (doc.Title(title), head), "head"),
            _taken(found),
            *_remarks(said("Inferred"), "inferred", found, names),
            *_remarks(said("Left out"), "left", found, names),
        ),
        kind="rexs_import",
        main="taken",
    )


def _how_many(kind: str, count: int) -> str:
    """Say how many parts there are of a kind, by the table of a machine file that holds them."""
    match kind:
        case "shafts":
            return counted("{n} shaft", "{n} shafts", count)
        case "bearings":
            return counted("{n} bearing", "{n} bearings", count)
        case "loads":
            return counted("{n} load", "{n} loads", count)
        case "gears":
            return counted("{n} gear", "{n} gears", count)
        case _:
            return f"{count} {kind}"


def _taken(found: Imported) -> doc.Section:
    lines = [one for one in found.taken if one.part]
    columns = (
        doc.Column(said("part"), [one.part for one in lines], "part"),
        doc.Column(said("name"), [one.name for one in lines], "name"),
        doc.Column(said("type"), [one.type for one in lines], "type", once=True),
        doc.Column(
            said("component"), [one.component for one in lines], "component", only_in_files=True
        ),
        doc.Column(
            said("attributes read"),
            [" ".join(one.attributes) for one in lines],
            "attributes",
            only_in_files=True,
        ),
    )
    return doc.Section(said("Taken"), (doc.Table(columns, "taken"),), "taken")


def _remarks(
    heading: str, sort: str, found: Imported, names: dict[int, str]
) -> Iterable[doc.Section]:
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
            doc.Remark(f"{', '.join(of)}: {text}" if of else text, keys[text])
            for text, of in about.items()
        )
        yield doc.Section(heading, (doc.Notes(remarks),), sort)


def export_page(found: Exported, path: str) -> doc.Document:
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
        doc.Column(said("components"), list(parts), "type"),
        doc.Column(said("count"), list(parts.values()), "count", most=0),
    )
    sections = [
        doc.Section("", (doc.Title(title),), "head"),
        doc.Section(
            said("REXS {version}", version=model.version), (doc.Table(columns, "parts"),), "parts"
        ),
    ]
    if found.notes:
        remarks = {note.text: doc.Remark(note.text, note.key) for note in found.notes}
        sections.append(doc.Section(said("Notes"), (doc.Notes(tuple(remarks.values())),), "notes"))
    return doc.Document(title, tuple(sections), kind="rexs_export", main="parts")


def written_page(found: Written, path: str) -> doc.Document:
    """Return the page of a file for another program: what it has, and what it leaves out.

    Parameters
    ----------
    found
        Of a `rolamento.tasks.ExportRequest`.
    path
        Of the file that was written.
    """
    title = said("Wrote {path}", path=path)
    sections = [doc.Section("", (doc.Title(title),), "head")]
    if found.elements:
        sections.append(doc.Section(said("Elements for ROSS"), (_elements(found),), "elements"))
    elif found.mapped is not None:
        sections.append(doc.Section(said("Bearings"), (_maps(found.mapped),), "bearings"))
    if found.notes:
        remarks = {note.text: doc.Remark(note.text, note.key) for note in found.notes}
        sections.append(doc.Section(said("Notes"), (doc.Notes(tuple(remarks.values())),), "notes"))
    return doc.Document(title, tuple(sections), kind=f"{found.kind}_export", main="elements")


def _elements(found: Written) -> doc.Table:
    lines = found.elements
    first = {one.of: one for one in reversed(lines)}

    def once(place: int) -> list[float | None]:
        return [one.left_out[place] if first[one.of] is one else None for one in lines]

    last = [one.stiffness[-1] for one in lines]
    columns = (
        doc.Column(said("element"), [one.name for one in lines], "element"),
        doc.Column(said("at"), [one.position for one in lines], "position", "mm"),
        doc.Column(said("up to"), [float(one.speed[-1]) for one in lines], "speed", "rpm"),
        *(
            doc.Column(
                f"k_{2 * axis}", [float(k[place, place]) for k in last], f"k{2 * axis}", "N/µm"
            )
            for place, axis in enumerate("xyz")
        ),
        doc.Column(said("left out:\nx, y–z"), once(0), "left_out_axial_radial", "N/µm"),
        doc.Column(said("shift–tilt"), once(1), "left_out_shift_tilt", "N/mrad"),
        doc.Column(said("tilt"), once(2), "left_out_tilt", "N·m/mrad"),
    )
    legends = (
        said(
            "x, y, z of ROSS are y, z, x of Rolamento: z is along the shaft; stiffness at the last"
            " speed. Elements of ROSS have no stiffness between shifts along and across the shaft,"
            " and none of tilts: the greatest of all speeds is what is left out"
        ),
    )
    return doc.Table(columns, "elements", legends=legends)


def _maps(mapped: Mapped) -> doc.Table:
    maps = mapped.maps
    missing = [int((one.status != "converged").sum()) for one in maps]
    columns = (
        doc.Column(said("bearing"), [one.name for one in maps], "bearing"),
        doc.Column(
            said("over"), [", ".join(axis.field for axis in one.axes) for one in maps], "over"
        ),
        doc.Column(said("points"), [one.status.size for one in maps], "points", most=0),
        doc.Column(said("without a\nresult"), missing, "missing", most=0),
    )
    return doc.Table(columns, "bearings")
