"""The containers of REXS: XML (.rexs), JSON (.rexsj), and a zipped one of them (.rexsz).

A file is not trusted: no document type, so no entities; bounded in bytes, elements and depth,
before and after it is inflated; nothing that it names is opened.
"""

from __future__ import annotations

import base64
import binascii
import io
import json
import os
import struct
import zipfile
import zlib
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, Final, NoReturn
from xml.parsers import expat
from xml.sax.saxutils import escape, quoteattr

from rolamento.errors import FileError, cause
from rolamento.exchange.rexs.model import (
    Attribute,
    Component,
    LoadCase,
    Ref,
    Relation,
    RexsModel,
    Value,
)
from rolamento.io.text import read_bytes
from rolamento.io.writing import write_bytes
from rolamento.words import marked, said

__all__ = ["ENDINGS", "check_ending", "parse_rexs", "read_rexs", "rexs_bytes", "write_rexs"]

ENDINGS: Final = {
    ".rexs": "xml", ".rexs.xml": "xml", ".rexsj": "json", ".rexs.json": "json",
    ".rexsz": "zip", ".rexs.zip": "zip",
}  # fmt: skip
"""Containers by the endings of names."""

_LARGEST: Final = 32 * 2**20
"""Bytes of a file, and of what it inflates to."""
_MOST_ELEMENTS: Final = 1_000_000
"""Elements of XML, numbers in arrays among them; or the values of JSON."""
_MOST_MARKS: Final = 4 * _MOST_ELEMENTS
"""Brackets and commas of JSON, of which an attribute has some beside its values."""
_DEEPEST: Final = 32
_MOST_ENTRIES: Final = 1000
_LONGEST_NUMBER: Final = 10
"""Digits of an id."""
_CODES: Final = {"int32": "i", "float32": "f", "float64": "d"}
_OTHER_ENCODINGS: Final = (b"\xff\xfe", b"\xfe\xff", b"\0<", b"<\0")
"""How XML as UTF-16 begins."""
_BYTE_ORDER_MARK: Final = b"\xef\xbb\xbf"
_EXAMPLE: Final = "gearbox.rexs"


def read_rexs(path: str | os.PathLike[str]) -> RexsModel:
    """Read a REXS file, of whichever container.

    Parameters
    ----------
    path
        Of the file; ``"-"`` for standard input.

    Raises
    ------
    FileError
        If it cannot be read, is none, or is larger or deeper than any gear unit.
    """
    content = read_bytes(path, _LARGEST, marked("a REXS file"))
    return parse_rexs(content, os.fspath(path))


def parse_rexs(content: bytes, source: str = "") -> RexsModel:
    """Return the model that the content of a REXS file describes.

    Parameters
    ----------
    content
        XML, JSON, or a zip archive with one of them.
    source
        What to call it in messages.

    Raises
    ------
    FileError
        As `read_rexs`.
    """
    try:
        if content.startswith(b"PK"):
            content = _unzipped(content)
        _check_size(content)
        plain = content.removeprefix(_BYTE_ORDER_MARK).lstrip()
        if not plain:
            raise FileError(said("is empty; a REXS model is expected"), example=_EXAMPLE)
        if plain.startswith(b"{"):
            return _of_json(plain)
        if not plain.startswith((b"<", *_OTHER_ENCODINGS)):
            raise FileError(said("is not a REXS model, which is XML, JSON or a zip archive"))
        return _XmlReader(content).model
    except FileError as error:
        raise error if error.source else error.with_details(source=source) from None
    except RecursionError:
        raise FileError(said("is nested too deeply"), source=source) from None


def _check_size(content: bytes) -> None:
    if len(content) > _LARGEST:
        raise FileError(said("is larger than {most} MB", most=_LARGEST // 2**20))


def _unzipped(content: bytes) -> bytes:
    """Return the one model of an archive, inflated no further than any model goes."""
    _check_size(content)
    if content.count(b"PK\x01\x02") > _MOST_ENTRIES:
        raise FileError(said("has more than {most} files", most=_MOST_ENTRIES))
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            names = [name for name in archive.namelist() if _is_model(name)]
            if len(names) != 1:
                raise FileError(
                    said("must hold one REXS model, and holds {count}", count=len(names)),
                    value=", ".join(names[:4]) or None,
                    example=_EXAMPLE,
                )
            if archive.getinfo(names[0]).flag_bits & 1:
                raise FileError(said("is encrypted"), value=names[0])
            with archive.open(names[0]) as member:
                return member.read(_LARGEST + 1)
    except FileError:  # which is a ValueError too
        raise
    except (
        zipfile.BadZipFile, zlib.error, EOFError, OSError, ValueError, NotImplementedError,
        IndexError, struct.error, RuntimeError,
    ) as error:  # fmt: skip
        raise FileError(
            said("is not a readable archive: {reason}", reason=_reason(error))
        ) from None


def _is_model(name: str) -> bool:
    low = name.lower()
    return any(low.endswith(end) for end, kind in ENDINGS.items() if kind != "zip")


# --- XML ------------------------------------------------------------------------------------------


class _XmlReader:
    """Reads a model by the events of expat, without a document type."""

    def __init__(self, content: bytes) -> None:
        self._parser = parser = expat.ParserCreate(namespace_separator=" ")
        parser.buffer_text = True
        parser.StartDoctypeDeclHandler = self._refuse_document_type
        parser.EntityDeclHandler = self._refuse_document_type
        parser.StartElementHandler = self._begin
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self._take
        self._path: list[str] = []
        self._text: list[str] = []
        self._count = 0
        self._metadata: dict[str, str] = {}
        self._given: list[dict[str, str]] = []
        self._components: list[Component] = []
        self._relations: list[Relation] = []
        self._cases: list[LoadCase] = []
        self._accumulation: list[Component] = []
        self._refs: list[Ref] = []
        self._attributes: dict[str, Attribute] = {}
        self._in_case: list[Component] = []
        self._cells: list[str] = []
        self._rows: list[tuple[str, ...]] = []
        self._value: Value | None = None
        try:
            parser.Parse(content, True)
        except expat.ExpatError as error:
            reason = expat.ErrorString(error.code) or ""
            raise FileError(
                said("is not valid XML: {reason}", reason=reason), line=error.lineno
            ) from None
        except (LookupError, ValueError) as error:  # an encoding that nobody knows
            if isinstance(error, FileError):
                raise
            raise FileError(said("is not valid XML: {reason}", reason=_reason(error))) from None
        self.model = _model(
            self._metadata, self._components, self._relations, self._cases, self._accumulation
        )

    def _refuse(self, rule: str, **details: Any) -> NoReturn:
        raise FileError(rule, line=self._parser.CurrentLineNumber, **details)

    def _refuse_document_type(self, *_: object) -> None:
        self._refuse(said("has a document type or entities, which a REXS model never needs"))

    def _begin(self, name: str, given: dict[str, str]) -> None:
        name = name.rpartition(" ")[2]
        self._count += 1
        if self._count > _MOST_ELEMENTS:
            self._refuse(said("has more than {most} elements", most=_MOST_ELEMENTS))
        if len(self._path) >= _DEEPEST:
            self._refuse(said("is nested too deeply"))
        if not self._path:
            if name != "model":
                self._refuse(said("is not a REXS model: it begins with {name}", name=name[:40]))
            self._metadata = given
        self._path.append(name)
        self._given.append(given)
        self._text.clear()
        if name == "relation":
            self._refs = []
        elif name == "component":
            self._attributes = {}
        elif name == "load_case" or name == "accumulation":
            self._in_case = []
        elif name == "attribute":
            self._value, self._rows = None, []
        elif name in ("array", "r", "matrix"):
            self._cells = []

    def _take(self, text: str) -> None:
        self._text.append(text)

    def _end(self, name: str) -> None:
        name = self._path.pop()
        given = self._given.pop()
        parent = self._path[-1] if self._path else ""
        text = "".join(self._text)
        if name == "c":
            self._cells.append(text.strip())
        elif name == "r":
            self._rows.append(tuple(self._cells))
        elif name == "array":
            row = self._decoded(given, text) if "code" in given else tuple(self._cells)
            if parent == "array_of_arrays":
                self._rows.append(row)
            else:
                self._value = row
        elif name == "matrix":
            if "code" in given:
                self._rows = self._matrix(given, text)
            self._value = tuple(self._rows)
        elif name == "array_of_arrays":
            self._value = tuple(self._rows)
        elif name == "attribute" and parent == "component":
            self._keep(given, text)
        elif name == "ref" and parent == "relation":
            self._refs.append(Ref(self._number(given, "id"), given.get("role", "")))
        elif name == "relation" and parent == "relations":
            order = self._number(given, "order") if "order" in given else None
            self._relations.append(
                Relation(self._number(given, "id"), given.get("type", ""), tuple(self._refs), order)
            )
        elif name == "component" and parent in ("components", "load_case", "accumulation"):
            own = Component(
                self._number(given, "id"), given.get("type", ""), given.get("name", ""),
                self._attributes,
            )  # fmt: skip
            (self._components if parent == "components" else self._in_case).append(own)
        elif name == "load_case":
            self._cases.append(LoadCase(self._number(given, "id"), tuple(self._in_case)))
        elif name == "accumulation":
            self._accumulation += self._in_case
        self._text.clear()

    def _keep(self, given: Mapping[str, str], text: str) -> None:
        name = given.get("id", "")
        value = text if self._value is None else self._value
        self._attributes[name] = Attribute(name, value, given.get("unit", ""))

    def _number(self, given: Mapping[str, str], key: str) -> int:
        text = given.get(key, "").strip()
        try:
            return _whole(text)
        except ValueError:
            self._refuse(said("must be a whole number"), field=key, value=text)

    def _decoded(self, given: Mapping[str, str], text: str) -> tuple[str, ...]:
        try:
            found = _decoded(given["code"], text, _MOST_ELEMENTS - self._count)
        except FileError as error:
            raise error.with_details(line=self._parser.CurrentLineNumber) from None
        self._count += len(found)
        return found

    def _matrix(self, given: Mapping[str, str], text: str) -> list[tuple[str, ...]]:
        cells = self._decoded(given, text)
        rows, columns = (self._number(given, key) for key in ("rows", "columns"))
        if rows * columns != len(cells) or min(rows, columns) < 1:
            self._refuse(
                said("holds {count} numbers, not {rows} rows of {columns}",
                     count=len(cells), rows=rows, columns=columns)
            )  # fmt: skip
        return _rows_of(cells, columns)


def _reason(error: Exception) -> str:
    """Why a library refused something, in short."""
    return cause(error) if isinstance(error, OSError) else str(error)[:150].lower()


def _whole(text: str) -> int:
    if len(text) > _LONGEST_NUMBER + 1:
        raise ValueError(text)
    return int(text)


def _rows_of(cells: tuple[str, ...], columns: int) -> list[tuple[str, ...]]:
    return [cells[at : at + columns] for at in range(0, len(cells), columns)]


def _decoded(code: str, text: str, most: int) -> tuple[str, ...]:
    """Return the numbers of an array in Base64, little endian; its padding may be missing.

    Raises
    ------
    FileError
        If it holds none of that code.
    """
    kind = _CODES.get(code)
    if kind is None:
        raise FileError(
            said("must be one of {names}", names=", ".join(_CODES)), field="code", value=code
        )
    letters = "".join(text.split())
    try:
        content = base64.b64decode(letters + "=" * (-len(letters) % 4), validate=True)
    except (binascii.Error, ValueError):
        raise FileError(said("is not valid Base64"), field="array", value=letters[:40]) from None
    size = struct.calcsize(kind)
    count, rest = divmod(len(content), size)
    if rest:
        raise FileError(
            said("has {count} bytes, not a whole number of {code}", count=len(content), code=code),
            field="array",
        )
    if count > most:
        raise FileError(said("has more than {most} elements", most=_MOST_ELEMENTS))
    return tuple(map(repr, struct.unpack(f"<{count}{kind}", content)))


# --- JSON -----------------------------------------------------------------------------------------


def _of_json(content: bytes) -> RexsModel:
    # before anything is made of them: a bracket takes a byte in the file, and fifty in memory
    if sum(content.count(mark) for mark in (b"[", b"{", b",")) > _MOST_MARKS:
        raise FileError(said("has more than {most} elements", most=_MOST_ELEMENTS))
    try:
        text = content.decode("utf-8")
        # numbers stay texts: none is rounded, and none has too many digits
        parsed = json.loads(text, parse_int=str, parse_float=str, parse_constant=_refused)
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        raise FileError(said("is not UTF-8 text"), line=line) from None
    except json.JSONDecodeError as error:
        raise FileError(
            said("is not valid JSON: {reason}", reason=error.msg.lower()), line=error.lineno
        ) from None
    model = parsed.get("model")
    if not isinstance(model, dict):
        raise FileError(said("is not a REXS model: it begins with {name}",
                             name=next(iter(parsed), "{}")[:40]))  # fmt: skip
    reader = _JsonReader()
    spectra = model.get("load_spectrum", ())
    spectra = spectra if isinstance(spectra, list) else [spectra] if spectra else []
    cases: list[LoadCase] = []
    accumulation: list[Component] = []
    for at, spectrum in enumerate(spectra):
        where = f"load_spectrum.{at}"
        table = _table(spectrum, where)
        key = "load_cases" if "load_cases" in table else "load_case"
        for place, case in enumerate(_list(table.get(key, []), f"{where}.{key}")):
            here = f"{where}.{key}.{place}"
            own = _table(case, here)
            found = reader.components(own.get("components", []), f"{here}.components")
            cases.append(LoadCase(_json_number(own, "id", here), tuple(found)))
        total = _table(table.get("accumulation", {}), f"{where}.accumulation")
        accumulation += reader.components(total.get("components", []), f"{where}.accumulation")
    metadata = {key: value for key, value in model.items() if isinstance(value, str)}
    return _model(
        metadata,
        list(reader.components(model.get("components", []), "components")),
        list(_json_relations(model.get("relations", []))),
        cases,
        accumulation,
    )


def _refused(constant: str) -> NoReturn:
    raise FileError(said("contains {constant}, which is not a number", constant=constant))


def _table(value: Any, field: str) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise FileError(said("must be a table"), field=field)
    return value


def _list(value: Any, field: str) -> list[Any]:
    if not isinstance(value, list):
        raise FileError(said("must be a list"), field=field)
    return value


def _json_number(table: Mapping[str, Any], key: str, field: str) -> int:
    value = table.get(key)
    try:
        return _whole(str(value).strip())
    except ValueError:
        raise FileError(
            said("must be a whole number"), field=f"{field}.{key}", value=value
        ) from None


def _text(table: Mapping[str, Any], key: str) -> str:
    value = table.get(key)
    return value if isinstance(value, str) else ""


def _json_relations(given: Any) -> Iterator[Relation]:
    for place, value in enumerate(_list(given, "relations")):
        where = f"relations.{place}"
        table = _table(value, where)
        refs = []
        for at, one in enumerate(_list(table.get("refs", []), f"{where}.refs")):
            ref = _table(one, f"{where}.refs.{at}")
            refs.append(Ref(_json_number(ref, "id", f"{where}.refs.{at}"), _text(ref, "role")))
        order = None if table.get("order") is None else _json_number(table, "order", where)
        number = _json_number(table, "id", where)
        yield Relation(number, _text(table, "type"), tuple(refs), order)


class _JsonReader:
    """Reads components, and counts their values."""

    def __init__(self) -> None:
        self._count = 0

    def components(self, given: Any, field: str) -> Iterator[Component]:
        for place, value in enumerate(_list(given, field)):
            where = f"{field}.{place}"
            table = _table(value, where)
            attributes = {}
            for at, one in enumerate(_list(table.get("attributes", []), f"{where}.attributes")):
                own = self._attribute(_table(one, f"{where}.attributes.{at}"))
                attributes[own.id] = own
            yield Component(
                _json_number(table, "id", where), _text(table, "type"), _text(table, "name"),
                attributes,
            )  # fmt: skip

    def _attribute(self, table: Mapping[str, Any]) -> Attribute:
        name, unit = _text(table, "id"), _text(table, "unit")
        form = next((key for key in table if key not in ("id", "unit")), "")
        try:
            value = self._value(table.get(form, ""))
        except FileError as error:
            raise error.with_details(field=name) from None
        return Attribute(name, value, unit, form.removesuffix("_coded"))

    def _value(self, given: Any) -> Value:
        if isinstance(given, dict):
            cells = _decoded(
                _text(given, "code"), _text(given, "value"), _MOST_ELEMENTS - self._count
            )
            self._more(len(cells))
            if "columns" not in given:
                return cells
            columns = _json_number(given, "columns", "matrix")
            if columns < 1 or len(cells) % columns:
                raise FileError(
                    said("holds {count} numbers, not {rows} rows of {columns}", count=len(cells),
                         rows=_text(given, "rows"), columns=columns)
                )  # fmt: skip
            return tuple(_rows_of(cells, columns))
        if isinstance(given, list):
            if any(isinstance(one, list) for one in given):
                return tuple(
                    tuple(self._scalar(cell) for cell in _list(row, "matrix")) for row in given
                )
            return tuple(self._scalar(cell) for cell in given)
        return self._scalar(given)

    def _scalar(self, given: Any) -> str:
        self._more(1)
        if isinstance(given, bool):
            return "true" if given else "false"
        if not isinstance(given, str):
            raise FileError(said("must be a single value, not a table or a list"), value=given)
        return given

    def _more(self, count: int) -> None:
        self._count += count
        if self._count > _MOST_ELEMENTS:
            raise FileError(said("has more than {most} elements", most=_MOST_ELEMENTS))


# --- what goes together ---------------------------------------------------------------------------


def _model(
    metadata: Mapping[str, str],
    components: list[Component],
    relations: list[Relation],
    cases: list[LoadCase],
    accumulation: list[Component],
) -> RexsModel:
    """Return a model whose components differ in their ids.

    Raises
    ------
    FileError
        If they do not, or there is no version.
    """
    if not metadata.get("version", "").strip():
        raise FileError(said("is missing"), field="version", example='version="2.0"')
    _refuse_repeated(components, "component")
    _refuse_repeated(relations, "relation")
    _refuse_repeated(cases, "load_case")
    return RexsModel(
        metadata["version"].strip(), metadata.get("applicationId", ""),
        metadata.get("applicationVersion", ""), metadata.get("date", ""),
        tuple(components), tuple(relations), tuple(cases), tuple(accumulation),
    )  # fmt: skip


def _refuse_repeated(parts: Iterable[Component | Relation | LoadCase], kind: str) -> None:
    seen: set[int] = set()
    for part in parts:
        if part.id in seen:
            raise FileError(said("is given twice"), field=f"{kind} id", value=part.id)
        seen.add(part.id)


# --- writing --------------------------------------------------------------------------------------


def write_rexs(model: RexsModel, path: str | os.PathLike[str]) -> None:
    """Write a model to a file, in the container that its name ends with.

    Parameters
    ----------
    model
        What to write.
    path
        A name that ends in ``.rexs``, ``.rexsj`` or ``.rexsz``.

    Raises
    ------
    FileError
        If the name ends otherwise, or the file cannot be written.
    """
    write_bytes(rexs_bytes(model, os.path.basename(os.fspath(path))), path)


def check_ending(name: str) -> str:
    """Return the container that a name ends with: ``"xml"``, ``"json"`` or ``"zip"``.

    Raises
    ------
    FileError
        If it does not end as one of REXS.
    """
    low = name.lower()
    kind = next((kind for end, kind in ENDINGS.items() if low.endswith(end)), None)
    if kind is None:
        rule = said("must end in {endings}", endings=".rexs, .rexsj, .rexsz")
        raise FileError(rule, source=name, example=_EXAMPLE)
    return kind


def rexs_bytes(model: RexsModel, name: str) -> bytes:
    """Return the content of a file of that name; the same bytes for the same model.

    Raises
    ------
    FileError
        If the name does not end as one of REXS.
    """
    kind = check_ending(name)
    if kind == "json":
        return _BYTE_ORDER_MARK + _as_json(model).encode("utf-8")
    content = _BYTE_ORDER_MARK + "".join(_as_xml(model)).encode("utf-8")
    if kind == "xml":
        return content
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        member = zipfile.ZipInfo("model.rexs")
        member.compress_type = zipfile.ZIP_DEFLATED
        archive.writestr(member, content)
    return file.getvalue()


def _as_xml(model: RexsModel) -> Iterator[str]:
    yield '<?xml version="1.0" encoding="UTF-8" standalone="no"?>\n'
    yield (
        f"<model applicationId={quoteattr(model.application)}"
        f" applicationVersion={quoteattr(model.application_version)}"
        f" date={quoteattr(model.date)} version={quoteattr(model.version)}>\n"
    )
    yield "  <relations>\n"
    for relation in model.relations:
        order = "" if relation.order is None else f' order="{relation.order}"'
        yield f'    <relation id="{relation.id}"{order} type={quoteattr(relation.type)}>\n'
        for ref in relation.refs:
            hint = model.by_id[ref.id].type
            yield f'      <ref hint="{hint}" id="{ref.id}" role={quoteattr(ref.role)}/>\n'
        yield "    </relation>\n"
    yield "  </relations>\n  <components>\n"
    for component in model.components:
        yield from _component_as_xml(component, "    ")
    yield "  </components>\n"
    if model.load_cases:
        yield '  <load_spectrum id="1">\n'
        for case in model.load_cases:
            yield f'    <load_case id="{case.id}">\n'
            for component in case.components:
                yield from _component_as_xml(component, "      ")
            yield "    </load_case>\n"
        if model.accumulation:
            yield "    <accumulation>\n"
            for component in model.accumulation:
                yield from _component_as_xml(component, "      ")
            yield "    </accumulation>\n"
        yield "  </load_spectrum>\n"
    yield "</model>\n"


def _component_as_xml(component: Component, space: str) -> Iterator[str]:
    name = f" name={quoteattr(component.name)}" if component.name else ""
    yield f'{space}<component id="{component.id}"{name} type={quoteattr(component.type)}>\n'
    for one in component.attributes.values():
        unit = f" unit={quoteattr(one.unit)}" if one.unit else ""
        yield (
            f"{space}  <attribute id={quoteattr(one.id)}{unit}>{_value_as_xml(one)}</attribute>\n"
        )
    yield f"{space}</component>\n"


def _value_as_xml(attribute: Attribute) -> str:
    value = attribute.value
    if isinstance(value, str):
        return escape(value)
    if value and isinstance(value[0], tuple):
        inner = "".join(
            f"<r>{''.join(f'<c>{escape(cell)}</c>' for cell in row)}</r>" for row in value
        )
        return f"<matrix>{inner}</matrix>"
    return f"<array>{''.join(f'<c>{escape(str(cell))}</c>' for cell in value)}</array>"


_NUMBERS: Final = ("floating_point", "integer", "boolean", "reference_component")
"""How the forms of values begin that JSON writes without quotes."""


def _as_json(model: RexsModel) -> str:
    relations = [
        {
            "id": relation.id,
            "type": relation.type,
            **({} if relation.order is None else {"order": relation.order}),
            "refs": [
                {"id": ref.id, "role": ref.role, "hint": model.by_id[ref.id].type}
                for ref in relation.refs
            ],
        }
        for relation in model.relations
    ]
    found: dict[str, Any] = {
        "version": model.version,
        "applicationId": model.application,
        "applicationVersion": model.application_version,
        "date": model.date,
        "relations": relations,
    }
    parts = [f"{json.dumps(key)}: {_dumped(value)}" for key, value in found.items()]
    parts.append(f'"components": {_components_as_json(model.components)}')
    if model.load_cases:
        cases = ",\n".join(
            f'{{"id": {case.id}, "components": {_components_as_json(case.components)}}}'
            for case in model.load_cases
        )
        total = (
            f', "accumulation": {{"components": {_components_as_json(model.accumulation)}}}'
            if model.accumulation
            else ""
        )
        parts.append(f'"load_spectrum": {{"id": 1, "load_cases": [{cases}]{total}}}')
    return '{"model": {' + ",\n".join(parts) + "}}\n"


def _dumped(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False)


def _components_as_json(components: Iterable[Component]) -> str:
    return "[" + ",\n".join(map(_component_as_json, components)) + "]"


def _component_as_json(component: Component) -> str:
    attributes = ",\n  ".join(_attribute_as_json(one) for one in component.attributes.values())
    name = f', "name": {_dumped(component.name)}' if component.name else ""
    return (
        f'{{"id": {component.id}, "type": {_dumped(component.type)}{name}, "attributes": ['
        f"{attributes}]}}"
    )


def _attribute_as_json(one: Attribute) -> str:
    unit = f', "unit": {_dumped(one.unit)}' if one.unit else ""
    form = one.form or "string"
    plain = form.startswith(_NUMBERS)

    def written(value: Any) -> str:
        if isinstance(value, tuple):
            return f"[{', '.join(written(cell) for cell in value)}]"
        return str(value) if plain else _dumped(value)

    return f'{{"id": {_dumped(one.id)}{unit}, "{form}": {written(one.value)}}}'
