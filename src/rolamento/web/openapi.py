"""The OpenAPI document of the HTTP API, made of the records that its bodies hold, and its page."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Iterable, Mapping
from html import escape
from typing import Any, Final
from urllib.parse import urlencode

from pydantic import BaseModel
from pydantic.json_schema import models_json_schema

import rolamento
from rolamento.case import Case
from rolamento.web.api import DIAGNOSE, OPERATIONS, PREFIX, READY, Operation, Parameter
from rolamento.words import language, languages, marked, said

__all__ = ["DOCS", "docs_page", "openapi_document"]

DOCS: Final = "/api/docs"
DOCUMENT: Final = f"{PREFIX}/openapi.json"
_JSON: Final = "application/json"
_BYTES: Final = "application/octet-stream"
_REFERENCE: Final = "#/components/schemas/"
_REFUSALS: Final = {
    "400": marked("The request is not usable."),
    "401": marked("The token is missing or wrong."),
    "413": marked("The body is too large."),
    "415": marked("The body is of another kind than is read."),
    "422": marked("What is asked is not valid: the field, the value and what is allowed."),
    "503": marked("Too many requests are waiting; the header Retry-After says when to try again."),
    "504": marked("It took longer than a request may take, and was ended."),
}
_PARTS: Final = ("field", "value", "message", "rule", "example")


def openapi_document() -> dict[str, Any]:
    """Return the OpenAPI 3.1 document, in the language that is spoken; meanings are in English."""
    return {
        "openapi": "3.1.0",
        "info": {
            "title": "Rolamento",
            "version": rolamento.__version__,
            "description": said(
                "Rolling bearing analysis. Numbers in answers are in SI units; in a case,"
                " quantities are text with a unit. A number that does not exist is null. Errors are"
                " objects that name the field, the value, what is allowed and an example. The"
                " parameter lang chooses the language of texts."
            ),
        },
        "servers": [{"url": PREFIX}],
        "paths": {one.path: {one.method.lower(): _described(one)} for one in _all()},
        "components": {
            "schemas": _schemas(),
            "securitySchemes": {"token": {"type": "http", "scheme": "bearer"}},
        },
        "security": [{}, {"token": []}],
    }


def _all() -> tuple[Operation, ...]:
    return (*OPERATIONS[:-3], DIAGNOSE, *OPERATIONS[-3:], READY)


def _described(one: Operation) -> dict[str, Any]:
    found: dict[str, Any] = {
        "operationId": one.path.strip("/"),
        "summary": said(one.summary),
        "description": said(one.description),
        "parameters": [*map(_parameter, one.parameters), _language()],
        "responses": {"200": _success(one), **_refused(one)},
    }
    if one.asks is not None:
        content: dict[str, Any] = {"schema": {"$ref": f"{_REFERENCE}{one.asks.__name__}"}}
        found["requestBody"] = {
            "required": True,
            "content": {_JSON: {**content, "example": dict(one.example)}},
        }
    elif one is DIAGNOSE:
        found["requestBody"] = {
            "required": True,
            "content": {_BYTES: {"schema": {"type": "string", "format": "binary"}}},
        }
        name = Parameter(
            "X-File-Name",
            marked("Name of the file, percent-encoded: its ending tells the format."),
            {"type": "string"},
            "signal.npz",
        )
        found["parameters"] = [*found["parameters"], {**_parameter(name), "in": "header"}]
    return found


def _language() -> dict[str, Any]:
    codes = {"type": "string", "enum": list(languages())}
    return _parameter(Parameter("lang", marked("Language of texts."), codes))


def _parameter(one: Parameter) -> dict[str, Any]:
    found: dict[str, Any] = {
        "name": one.name,
        "in": "query",
        "required": one.is_required,
        "description": said(one.meaning),
        "schema": dict(one.schema),
    }
    return {**found, "example": one.example} if one.example else found


def _success(one: Operation) -> dict[str, Any]:
    content: dict[str, Any]
    if one.files:
        content = {kind: {"schema": {}} for kind in one.files}
    else:
        content = {_JSON: {"schema": {"type": "object", "required": list(one.has)}}}
    return {"description": said(one.summary), "content": content}


def _refused(one: Operation) -> dict[str, Any]:
    taken = set(_REFUSALS) if one.asks or one is DIAGNOSE else {"400", "401", "422", "503"}
    schema = {"$ref": f"{_REFERENCE}Error"}
    return {
        status: {"description": said(text), "content": {_JSON: {"schema": schema}}}
        for status, text in _REFUSALS.items()
        if status in taken
    }


def _schemas() -> dict[str, Any]:
    records: list[type[BaseModel]] = [Case]
    records += [one.asks for one in OPERATIONS if one.asks is not None]
    _, found = models_json_schema(
        [(record, "validation") for record in dict.fromkeys(records)],
        ref_template=_REFERENCE + "{model}",
    )
    error = {
        "type": "object",
        "required": ["error"],
        "properties": {
            "error": {
                "type": "object",
                "required": list(_PARTS),
                "properties": {
                    **{name: {"type": ["string", "null"]} for name in _PARTS},
                    "line": {"type": ["integer", "null"]},
                },
            }
        },
    }
    return {**_in_file_form(found["$defs"]), "Error": error}


def _in_file_form(schema: Any) -> Any:
    """Return a schema of a record as a file holds it: quantities are text with a unit.

    Texts have their dimension for a format; examples of tables that are words are left out.
    """
    if isinstance(schema, list):
        return [_in_file_form(one) for one in schema]
    if not isinstance(schema, dict):
        return schema
    found = {name: _in_file_form(one) for name, one in schema.items() if name != "examples"}
    if isinstance(schema.get("examples"), list):
        takes_text = _takes_text(schema)
        examples = [one if takes_text else _read(one) for one in schema["examples"]]
        found |= {"examples": known} if (known := [one for one in examples if one]) else {}
    if isinstance(found.get("anyOf"), list):
        is_quantity = any("dimension" in one for one in found["anyOf"] if isinstance(one, dict))
        found["anyOf"] = [one for one in found["anyOf"] if not (is_quantity and "unit" in one)]
    if "dimension" in found:
        found["format"] = found["dimension"]
    return found


def _takes_text(schema: Mapping[str, Any]) -> bool:
    members = [one for one in schema.get("anyOf", ()) if isinstance(one, dict)]
    return schema.get("type") == "string" or any(map(_takes_text, members))


def _read(example: Any) -> Any:
    """Return an example of a list or a table, which may be written as a case file has it."""
    if not isinstance(example, str):
        return example
    try:
        return tomllib.loads(f"example = {example}")["example"]
    except tomllib.TOMLDecodeError:  # words
        return None


# --- the page -----------------------------------------------------------------------------------


def docs_page(document: Mapping[str, Any]) -> str:
    """Return the OpenAPI document as a page to read, with a form to try each request."""
    title = said("HTTP API")
    operations = [
        (path, method, one)
        for path, methods in document["paths"].items()
        for method, one in methods.items()
    ]
    contents = "".join(
        f'<li><a href="#{one["operationId"]}">{escape(one["summary"])}</a></li>'
        for _, _, one in operations
    )
    parts = [
        f"<h1>Rolamento: {escape(title)}</h1>",
        f"<p>{escape(document['info']['description'])}</p>",
        f'<p><a href="{DOCUMENT}">{escape(said("OpenAPI document"))}</a> · <a href="/">'
        f"{escape(said('To the app'))}</a></p>",
        f'<nav aria-label="{escape(title)}"><ol>{contents}</ol></nav>',
        *(_operation(document, path, method, one) for path, method, one in operations),
        _fields(),
    ]
    return (
        f'<!DOCTYPE html>\n<html lang="{languages()[language()].replace("_", "-")}">\n<head>\n'
        '<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>Rolamento: {escape(title)}</title>\n"
        '<link rel="icon" href="/static/icon.svg" type="image/svg+xml">\n'
        '<link rel="stylesheet" href="/page/document.css">\n'
        '<link rel="stylesheet" href="/static/api.css">\n'
        '<script type="module" src="/static/api.js"></script>\n'
        f'</head>\n<body class="rolamento">\n<main>\n{"".join(parts)}</main>\n</body>\n</html>\n'
    )


def _operation(document: Mapping[str, Any], path: str, method: str, one: Mapping[str, Any]) -> str:
    name, address = one["operationId"], f"{PREFIX}{path}"
    example = _example(one)
    return "".join(
        (
            f'<section id="{name}" aria-labelledby="{name}-head">',
            f'<h2 id="{name}-head">{escape(one["summary"])}</h2>',
            f"<p><code>{method.upper()} {address}</code></p><p>{escape(one['description'])}</p>",
            _table(
                (said("Parameter"), said("Example"), said("Meaning")),
                (
                    (each["name"], str(each.get("example", "")), each.get("description", ""))
                    for each in one["parameters"]
                ),
            ),
            _body(document, one),
            f'<h3>curl</h3><pre tabindex="0">{escape(_curl(method, address, one, example))}</pre>',
            _form(method, address, name, example) if example is not None else "",
            "</section>",
        )
    )


def _example(one: Mapping[str, Any]) -> Any:
    """Return a body to try; what is asked for behind a question mark; None of a file."""
    if "requestBody" not in one:
        return {each["name"]: each["example"] for each in one["parameters"] if "example" in each}
    return one["requestBody"]["content"].get(_JSON, {}).get("example")


def _curl(method: str, address: str, one: Mapping[str, Any], example: Any) -> str:
    where = f"http://127.0.0.1:8000{address}"
    if method == "get":
        query = urlencode(example)
        return f"curl '{where}?{query}'" if query else f"curl {where}"
    if example is None:
        return (
            f"curl '{where}?bearing=6205&speed=1797+rpm' \\\n"
            "  -H 'X-File-Name: signal.npz' --data-binary @signal.npz"
        )
    body = json.dumps(example, ensure_ascii=False)
    output = " -o report.html" if one["operationId"] == "report" else ""
    return f"curl {where}{output} \\\n  --json '{body}'"


def _form(method: str, address: str, name: str, example: Any) -> str:
    """Return a form to try a request; `api.js` sends it."""
    text = json.dumps(example, ensure_ascii=False, indent=1) if method == "post" else ""
    text = text if method == "post" else urlencode(example)
    label = said("Body of the request") if method == "post" else said("Behind the question mark")
    rows = min(text.count("\n") + 1, 20)
    return (
        f'<form class="try" data-method="{method.upper()}" data-address="{address}">'
        f'<label for="{name}-body">{escape(label)}</label>'
        f'<textarea id="{name}-body" rows="{rows}" spellcheck="false">{escape(text)}</textarea>'
        f"<button>{escape(said('Send'))}</button>"
        f'<output for="{name}-body" tabindex="0" hidden></output></form>'
    )


def _body(document: Mapping[str, Any], one: Mapping[str, Any]) -> str:
    content = one.get("requestBody", {}).get("content", {}).get(_JSON)
    if content is None:
        return ""
    record = document["components"]["schemas"][content["schema"]["$ref"].rpartition("/")[2]]
    rows = (
        (name, _shown(each), each.get("description", ""))
        for name, each in record["properties"].items()
    )
    return _table((said("Field of the body"), said("Example"), said("Meaning")), rows)


def _shown(schema: Mapping[str, Any]) -> str:
    examples = schema.get("examples")
    given = examples[0] if examples else schema.get("default")
    return "" if given is None else json.dumps(given, ensure_ascii=False)


def _fields() -> str:
    """Return a table of the fields of a case: what they are called, an example, their limits."""
    heads = (said("Field"), said("Example"), said("Meaning"), said("Limits"))
    rows = ((name, str(one.example), one.label, one.limits) for name, one in Case.fields().items())
    title = said("Fields of a case")
    return f'<section id="fields"><h2>{escape(title)}</h2>{_table(heads, rows)}</section>'


def _table(heads: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> str:
    lines = [
        '<tr><th scope="row"><code>{}</code></th><td><code>{}</code></td>{}</tr>'.format(
            *map(escape, row[:2]), "".join(f"<td>{escape(cell)}</td>" for cell in row[2:])
        )
        for row in rows
    ]
    if not lines:
        return ""
    head = "".join(f'<th scope="col">{escape(one)}</th>' for one in heads)
    return (
        f'<div class="wide" tabindex="0" role="group"><table><thead><tr>{head}</tr></thead>'
        f"<tbody>{''.join(lines)}</tbody></table></div>"
    )
