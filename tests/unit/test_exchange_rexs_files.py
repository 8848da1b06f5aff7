"""Containers of REXS, and files that are none, damaged or hostile: one message, soon."""

from __future__ import annotations

import io
import json
import random
import time
import tracemalloc
import zipfile
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from tests.rexs_models import shaft_on_two

from rolamento.errors import FileError, InputError
from rolamento.exchange.rexs import (
    Attribute,
    Component,
    Ref,
    Relation,
    RexsModel,
    machine_of_rexs,
    parse_rexs,
    read_rexs,
    rexs_bytes,
    write_rexs,
)

HEAD = '<model version="2.0" applicationId="a" applicationVersion="1" date="d">'


def refused(content: bytes) -> str:
    with pytest.raises(FileError) as caught:
        parse_rexs(content, "model.rexs")
    assert "\n" not in str(caught.value)
    assert str(caught.value).startswith("model.rexs")
    return str(caught.value)


def archive(*members: tuple[str, bytes]) -> bytes:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as written:
        for name, content in members:
            written.writestr(name, content)
    return file.getvalue()


# --- hostile --------------------------------------------------------------------------------------

LAUGHS = """<?xml version="1.0"?>
<!DOCTYPE model [
 <!ENTITY a "ha">
 <!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;">
 <!ENTITY c "&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;">
]>
<model version="2.0">&c;</model>
"""
OUTSIDE = """<?xml version="1.0"?>
<!DOCTYPE model [<!ENTITY x SYSTEM "file:///etc/passwd">]>
<model version="2.0"><components><component id="1" type="shaft" name="&x;"/></components></model>
"""


@pytest.mark.parametrize(
    "text",
    [LAUGHS, OUTSIDE, '<!DOCTYPE model SYSTEM "http://example.org/x.dtd"><model version="2.0"/>',
     "<!DOCTYPE model><model version='2.0'/>"],
)  # fmt: skip
def test_document_types_and_entities_are_refused(text: str) -> None:
    assert "document type or entities" in refused(text.encode())
    assert "document type or entities" in refused(text.encode("utf-16"))


def test_an_archive_that_inflates_without_end_is_refused() -> None:
    bomb = archive(("model.rexs", b" " * (200 * 2**20)))
    assert len(bomb) < 1_000_000
    tracemalloc.start()
    began = time.perf_counter()
    assert "is larger than 32 MB" in refused(bomb)
    assert time.perf_counter() - began < 5.0
    assert tracemalloc.get_traced_memory()[1] < 150 * 2**20
    tracemalloc.stop()


@pytest.mark.parametrize(
    ("content", "expected"),
    [
        (b"x" * (33 * 2**20), "is larger than 32 MB"),
        (HEAD.encode() + b"<a>" * 100, "nested too deeply"),
        (b'{"model": ' + b"[" * 200_000, "nested too deeply"),
        (b'{"model": ' + b'{"a":' * 200_000, "nested too deeply"),
        (HEAD.encode() + b"<relations>" + b"<x/>" * 1_000_001, "has more than 1 000 000 elements"),
        (b'{"model": {"version": "2.0", "components": [{"id": 1, "type": "a", "attributes": [{"id":'
         b' "b", "floating_point_array": [' + b"0," * 1_000_001 + b"0]}]}]}}",
         "has more than 1 000 000 elements"),
        (archive(*((f"{n}.txt", b"") for n in range(1001))), "has more than 1000 files"),
    ],
    ids=["large", "deep XML", "deep JSON list", "deep JSON", "elements", "numbers", "members"],
)  # fmt: skip
def test_what_is_larger_than_any_gear_unit_is_refused_soon(content: bytes, expected: str) -> None:
    began = time.perf_counter()
    assert expected in refused(content)
    assert time.perf_counter() - began < 10.0


# --- no model -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("content", "expected"),
    [
        (b"", "is empty"),
        (b"\xef\xbb\xbf  \n", "is empty"),
        (b"\x89PNG\r\n\x1a\n\0\0\0", "is not a REXS model, which is XML, JSON or a zip archive"),
        (b"title = 1", "is not a REXS model, which is XML, JSON or a zip archive"),
        (b"<html></html>", "is not a REXS model: it begins with html"),
        (b"<model></model>", "version: is missing"),
        (b'<?xml version="1.0" encoding="klingon"?><model version="2.0"/>', "is not valid XML"),
        (b'<model version="2.0">\n<components></relations></model>', "line 2: is not valid XML"),
        (b"{}", "is not a REXS model"),
        (b'{"bearing": {}}', "is not a REXS model: it begins with bearing"),
        (b'{"model": []}', "is not a REXS model"),
        (b'{"model": {"version": null}}', "version: is missing"),
        (b'{"model": {"version": "2.0", "components": {}}}', "components: must be a list"),
        (b'{"model": {"version": "2.0", "components": [1]}}', "components.0: must be a table"),
        (b'{"model": {"version": "2.0", "components": [{"type": "shaft"}]}}', "components.0.id"),
        (b'{"model": {"version": "2.0", "relations": [{"id": 1, "refs": [{"id": "a"}]}]}}',
         "relations.0.refs.0.id"),
        (b'{"model": {"version": "2.0", "components": [{"id": 1, "attributes": [{"id": "a",'
         b' "floating_point": NaN}]}]}}', "contains NaN"),
        (b'{"model": \n{"version": "2.0",,}}', "line 2: is not valid JSON"),
        (b'{"model": {"version": "\xff"}}', "is not UTF-8 text"),
        (b'{"model": {"version": "2.0", "components": [{"id": 99999999999999999999}]}}',
         "must be a whole number"),
        (b"PK\x03\x04 not an archive", "is not a readable archive"),
        (archive(("readme.txt", b"")), "must hold one REXS model, and holds 0"),
        (archive(("a.rexs", b"<a/>"), ("b.rexsj", b"{}")), "must hold one REXS model, and holds 2"),
    ],
)  # fmt: skip
def test_other_files_are_refused_with_the_place(content: bytes, expected: str) -> None:
    assert expected in refused(content)


@pytest.mark.parametrize(
    ("inner", "expected"),
    [
        ('<component id="x" type="shaft"/>', 'id = "x": must be a whole number'),
        ('<component type="shaft"/>', "id"),
        ('<component id="1" type="a"/><component id="1" type="b"/>',
         "component id = 1: is given twice"),
        ('<component id="1"><attribute id="a"><array code="float32">AAA</array></attribute>'
         "</component>", "has 2 bytes, not a whole number of float32"),
        ('<component id="1"><attribute id="a"><array code="float32">?!</array></attribute>'
         "</component>", "is not valid Base64"),
        ('<component id="1"><attribute id="a"><array code="int8">AAAA</array></attribute>'
         "</component>", 'code = "int8": must be one of int32, float32, float64'),
        ('<component id="1"><attribute id="a"><matrix code="int32" rows="2" columns="2">AAAAAA=='
         "</matrix></attribute></component>", "holds 1 numbers, not 2 rows of 2"),
    ],
)  # fmt: skip
def test_what_is_wrong_in_a_component_has_its_line(inner: str, expected: str) -> None:
    content = f"{HEAD}<components>\n{inner}\n</components></model>".encode()
    assert expected in refused(content)


def test_any_beginning_of_a_file_is_refused_in_one_line() -> None:
    for content in (shaft_on_two().xml(), shaft_on_two().json(), shaft_on_two().zipped()):
        for length in range(0, len(content) - 1, 97):
            refused(content[:length])


@pytest.mark.parametrize("container", ["xml", "json", "zipped"])
def test_damaged_files_are_read_or_refused(container: str) -> None:
    chance = random.Random(7)
    whole: bytes = getattr(shaft_on_two("1.0"), container)()
    for _ in range(150):
        content = bytearray(whole)
        for _ in range(chance.randint(1, 4)):
            place = chance.randrange(len(content))
            content[place : place + chance.randint(0, 3)] = chance.randbytes(chance.randint(0, 3))
        try:
            machine_of_rexs(parse_rexs(bytes(content)))
        except InputError as error:
            assert "\n" not in str(error)


# --- what is there comes back ---------------------------------------------------------------------

MODEL = RexsModel(
    "2.0",
    "Äpp & <Co>",
    "1.0 \"x\"",
    "2026-01-01T00:00:00+00:00",
    (
        Component(1, "gear_unit", "Über <a> & \"b\" 'c'", {
            "text": Attribute("text", "a < b & c\u00a0d", "none", "string"),
            "number": Attribute("number", "1.234567890123456789", "mm", "floating_point"),
            "yes": Attribute("yes", "true", "none", "boolean"),
            "array": Attribute("array", ("1.0", "2.5E-7"), "mm", "floating_point_array"),
            "matrix": Attribute("matrix", (("1.0", "2.0"), ("3.0", "4.0")), "none",
                                "floating_point_matrix"),
        }),
        Component(2, "shaft"),
    ),
    (Relation(1, "ordered_assembly", (Ref(1, "assembly"), Ref(2, "part")), 1),),
)  # fmt: skip


@pytest.mark.parametrize("name", ["a.rexs", "a.REXSJ", "a.rexsz", "a.rexs.xml", "a.rexs.json"])
def test_a_model_is_read_as_it_was_written(name: str, tmp_path: Path) -> None:
    write_rexs(MODEL, tmp_path / name)
    found = read_rexs(tmp_path / name)
    assert replace(found, components=()) == replace(MODEL, components=())
    for one, other in zip(found.components, MODEL.components, strict=True):
        assert (one.id, one.type, one.name) == (other.id, other.type, other.name)
    assert {n: (a.value, a.unit) for n, a in found.components[0].attributes.items()} == {
        n: (a.value, a.unit) for n, a in MODEL.components[0].attributes.items()
    }
    assert rexs_bytes(MODEL, name) == (tmp_path / name).read_bytes()


def test_what_is_written_begins_as_the_standard_wants() -> None:
    for name, begin in (("a.rexs", b"\xef\xbb\xbf<?xml"), ("a.rexsj", b'\xef\xbb\xbf{"model"')):
        assert rexs_bytes(MODEL, name).startswith(begin)
    assert isinstance(json.loads(rexs_bytes(MODEL, "a.rexsj").decode("utf-8-sig")), dict)


def test_another_ending_is_refused(tmp_path: Path) -> None:
    with pytest.raises(FileError, match=r"must end in \.rexs, \.rexsj, \.rexsz"):
        write_rexs(MODEL, tmp_path / "a.xml")


def test_names_of_a_namespace_are_read() -> None:
    content = shaft_on_two().xml().replace(b"<model ", b'<r:model xmlns:r="http://rexs.info" ')
    content = content.replace(b"</model>", b"</r:model>")
    assert parse_rexs(content).components == parse_rexs(shaft_on_two().xml()).components


@pytest.mark.parametrize("convert", [lambda text: text.encode("utf-16"), str.encode])
def test_encodings(convert: Callable[[str], bytes]) -> None:
    text = shaft_on_two().xml().decode().replace('encoding="UTF-8" ', "").replace("Welle", "Wälle")
    assert parse_rexs(convert(text)).components[2].name == "Wälle [3]"
