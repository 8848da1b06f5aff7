"""What the page asks of the server: what it needs to start, to open a case, and to follow it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from functools import cache, lru_cache
from typing import Any, Final

from starlette.requests import Request
from starlette.responses import FileResponse, Response
from starlette.routing import Route

from rolamento import __version__
from rolamento.case import Case, case_to_json, case_to_toml, parse_case
from rolamento.catalogue.records import CatalogueBearing
from rolamento.catalogue.search import built_in_catalogue
from rolamento.document.html import STYLE as DOCUMENT_STYLE
from rolamento.errors import InputError
from rolamento.io.text import format_of_text, parse_mapping
from rolamento.pages.catalogue import KINDS
from rolamento.pages.report import ORIGINS, PARTS
from rolamento.tasks.examples import EXAMPLES, TITLES
from rolamento.tasks.report import inputs_of, names_in
from rolamento.validate import one_of
from rolamento.web import drops
from rolamento.web.answers import answer, read_json
from rolamento.web.curves import curve
from rolamento.web.design import helps, seek, tolerance
from rolamento.web.form import form, in_labels, inputs, units
from rolamento.web.limits import by_weight, fast
from rolamento.web.live import live
from rolamento.web.machine import machine_described
from rolamento.web.page_words import page_words
from rolamento.web.pictures import described
from rolamento.web.section import section_svg
from rolamento.words import language, languages, said, speaking

__all__ = ["ROUTES", "example_drawings", "opened", "saved", "search", "start"]

_FORMATS: Final = ("toml", "json")
_FOUND: Final = 30
_SHORTEST: Final = 3
"""Signs of what may be a whole designation."""
_LONGEST_SEARCH: Final = 60


async def _start_request(request: Request) -> Response:
    warmth = request.app.state.warmth
    progress = warmth.done / warmth.total if warmth.total else None
    return answer({**await fast(start), "ready": warmth.ready, "progress": progress})


async def _warmth_request(request: Request) -> Response:
    warmth = request.app.state.warmth
    progress = warmth.done / warmth.total if warmth.total else None
    return answer({"ready": warmth.ready, "progress": progress})


async def _drawings_request(_: Request) -> Response:
    return answer(await fast(example_drawings))


async def _style_of_documents(_: Request) -> Response:
    """The style of what is shown as a document, the same in reports."""
    return FileResponse(DOCUMENT_STYLE, media_type="text/css")


def start() -> dict[str, Any]:
    """Return what the page needs before anything else, in the language that is spoken."""
    return _start(language())


@cache
def _start(code: str) -> dict[str, Any]:
    with speaking(code):
        return {
            "version": __version__,
            "lang": code,
            "languages": {one: tag.replace("_", "-") for one, tag in languages().items()},
            "words": page_words(),
            "form": {"groups": form()},
            "units": units(),
            "origins": {key: said(text) for key, text in ORIGINS.items()},
            "examples": [
                {"name": name, "title": said(shows)} for name, shows in _example_cases().items()
            ],
            "pictures": described(),
            "drops": drops.described(),
            "machine": machine_described(),
            "sections": [{"key": key, "label": said(part.label)} for key, part in PARTS.items()],
        }


@cache
def _example_cases() -> dict[str, str]:
    """The case files among the examples, and what the first example with each of them shows."""
    found: dict[str, str] = {}
    for example in EXAMPLES.values():
        for file in example.files:
            if file.endswith(".toml") and "/" not in file:
                found.setdefault(file.removesuffix(".toml"), example.shows)
    return found


def opened(request: Mapping[str, Any]) -> dict[str, Any]:
    """Return a case as the page holds it: the tables of its file, and every value that counts.

    Parameters
    ----------
    request
        One of ``text`` (of a case file, with its ``format`` if it is known), ``designation``,
        ``example``, ``case`` (tables).

    Raises
    ------
    InputError
        If it is none of them, or no valid case.
    """
    mapping = _mapping_asked(request)
    case = Case.from_mapping(mapping)
    return {
        "case": mapping,
        "title": case.title,
        "elements": sorted({place.bearing.element for place in case.bearing.places}),
        "inputs": inputs(inputs_of(case, frozenset(names_in(mapping)))),
    }


def _mapping_asked(request: Mapping[str, Any]) -> dict[str, Any]:
    given = {name: request[name] for name in ("text", "designation", "example", "case")
             if request.get(name) is not None}  # fmt: skip
    if len(given) != 1:
        raise InputError(
            said("must have one of text, designation, example and case"),
            field="open",
            example='{"designation": "6310/C3"}',
        )
    ((kind, value),) = given.items()
    if kind == "case":
        if not isinstance(value, dict):
            raise InputError(said("must be a table"), field="case", example='{"bearing": {}}')
        return value
    if not isinstance(value, str):
        raise InputError(said("must be text"), field=kind, value=value, example='"6310/C3"')
    if kind == "text":
        known = request.get("format")
        form_ = known if known in _FORMATS else format_of_text(value)
        source = str(request.get("name") or "")
        parse_case(value, format=form_, source=source)  # its errors name the line
        return parse_mapping(value, form_, source)
    if kind == "example":
        return _example(value)
    return {"bearing": {"designation": value.strip()}, "duty": {}}


def _example(name: str) -> dict[str, Any]:
    file = f"{name}.toml"
    own = next((one for one in EXAMPLES.values() if file in one.files), None)
    if name not in _example_cases() or own is None:
        known = ", ".join(_example_cases())
        raise InputError(said("must be one of {known}", known=known), field="example", value=name)
    case = parse_mapping(own.source(file).read_text(encoding="utf-8"), "toml", file)
    return {**case, "title": said(TITLES[name])}


def saved(request: Mapping[str, Any]) -> dict[str, str]:
    """Return a case as the text of a file.

    Parameters
    ----------
    request
        ``case``: tables; ``format``: ``"toml"`` (default) or ``"json"``.

    Raises
    ------
    InputError
        If it is no valid case.
    """
    mapping = request.get("case")
    if not isinstance(mapping, dict):
        raise InputError(said("must be a table"), field="case", example='{"bearing": {}}')
    wanted = request.get("format", "toml")
    one_of(wanted, "format", _FORMATS)
    case = Case.from_mapping(mapping)
    text = case_to_json(case) if wanted == "json" else case_to_toml(case)
    called = case.title or str(case.bearing.designation or "")
    return {"text": text, "name": f"{drops.plain_name(called) or 'case'}.{wanted}"}


def search(request: Mapping[str, Any]) -> dict[str, Any]:
    """Return the bearings of the catalogue whose designation or sizes match a text.

    Parameters
    ----------
    request
        ``text``: a designation or part of one, or sizes such as ``"25x52"``.

    Returns
    -------
    dict
        ``bearings`` of the catalogue; ``opens``: the bearing that the text itself opens, with its
        suffixes, or None; where nothing is found, ``why`` and ``near``, designations like it.

    Raises
    ------
    InputError
        If it is no text.
    """
    text = request.get("text")
    if not isinstance(text, str) or len(text) > _LONGEST_SEARCH:
        raise InputError(
            said("must be text of at most {most} characters", most=_LONGEST_SEARCH),
            field="text",
            example='"6205"',
        )
    wanted = text.strip()
    found = built_in_catalogue().search(wanted, _FOUND + 1) if wanted else ()
    opens, why, near = _resolved(wanted) if len(wanted) >= _SHORTEST else (None, "", ())
    return {
        "opens": opens,
        "why": "" if found else why,
        "near": () if found else near,
        "bearings": [_listed(one) for one in found[:_FOUND]],
        "more": len(found) > _FOUND,
    }


def _listed(one: CatalogueBearing) -> dict[str, Any]:
    """A bearing of the catalogue as the page lists it."""
    return {
        "designation": one.designation,
        "maker": one.maker,
        "kind": said(KINDS[one.kind]) if one.kind in KINDS else one.kind,
        "bore": one.figures.get("bore"),
        "outside_diameter": one.figures.get("outside_diameter"),
        "width": one.figures.get("width"),
        "dynamic_rating": one.figures.get("dynamic_rating"),
    }


@lru_cache(maxsize=256)
def _resolved_in(wanted: str, code: str) -> tuple[dict[str, Any] | None, str, tuple[str, ...]]:
    """What a designation opens; else why it does not, and what is most like it."""
    with speaking(code):
        known = built_in_catalogue()
        try:
            case = Case.from_mapping({"bearing": {"designation": wanted}, "duty": {}})
        except InputError as error:
            near = tuple(one for one in known.nearest(wanted) if one != wanted)
            return None, error.rule, near
        published = case.bearing.published
        one: dict[str, Any] = {} if published is None else _listed(published)
        arranged = getattr(case.bearing, "arrangement", None)
        return {**one, "designation": wanted, "arrangement": arranged or ""}, "", ()


def _resolved(wanted: str) -> tuple[dict[str, Any] | None, str, tuple[str, ...]]:
    return _resolved_in(wanted, language())


@cache
def example_drawings() -> dict[str, str]:
    """Return the bearing of each example in section, as SVG, by the name of the example."""
    found = {}
    for name in _example_cases():
        with suppress(InputError):  # an example without a picture is still an example
            found[name] = section_svg(Case.from_mapping(_example(name)), mark="card")
    return found


def _asks(
    path: str, function: Callable[[Mapping[str, Any]], Mapping[str, Any]], *, follows: bool = False
) -> Route:
    """Serve a function of the JSON object that a request brings; follows: a hand that drags."""

    async def endpoint(request: Request) -> Response:
        asked = await read_json(request)
        light = request.app.state.hands.run if follows else fast
        return answer(await by_weight(in_labels, function, asked, asked=asked, light=light))

    return Route(path, endpoint, methods=["POST"])


ROUTES: Final = (
    _asks("/page/live", live, follows=True),
    _asks("/page/curve", curve),
    _asks("/page/helps", helps),
    _asks("/page/seek", seek),
    _asks("/page/tolerance", tolerance),
    _asks("/page/open", opened),
    _asks("/page/save", saved),
    _asks("/page/search", search),
    Route("/page/start", _start_request),
    Route("/page/drawings", _drawings_request),
    Route("/page/warmth", _warmth_request),
    Route("/page/document.css", _style_of_documents),
)
