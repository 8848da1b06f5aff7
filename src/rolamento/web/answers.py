"""What is read from a request and said back: JSON bodies, JSON answers, refusals."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable, Mapping
from contextlib import asynccontextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Final

import anyio.to_thread
from starlette.requests import Request
from starlette.responses import Response

from rolamento.errors import ABSENT, FileError, InputError, shown
from rolamento.io.json import dumps
from rolamento.io.text import parse_mapping
from rolamento.words import language_of, languages, said

__all__ = [
    "MOST_COLUMNS",
    "MOST_JSON",
    "RequestError",
    "answer",
    "error_object",
    "language_for",
    "read_body",
    "read_json",
    "received",
    "refused",
    "written",
]

MOST_JSON: Final = 1_000_000
"""Bytes of a JSON body that holds cases."""
MOST_COLUMNS: Final = 5_000_000
"""Bytes of one that holds columns: a batch of 10 000 cases with a dozen fields."""
_SMALL: Final = 20_000
"""Bytes of JSON that take less than a millisecond."""
_SLOWEST: Final = 50_000.0
"""Bytes a second that a sender has to keep up with, after `_PATIENCE`."""
_PATIENCE: Final = 10.0
"""Seconds that a body may take, however small."""
_LONGEST: Final = 600.0
"""Seconds that a body may take, however large."""
_MOST_COMING: Final = 8
_MOST_OF_ONE: Final = 3
"""Files that may come at once: all, and from one address."""
_COMING: Final[dict[str, str]] = {}
"""Folders of files that are being sent or read, and the address that each comes from."""
_WRONG_INPUT: Final = 422
_HEADERS: Final = {
    408: {"connection": "close"},
    413: {"connection": "close"},
    503: {"retry-after": "2"},
}


class RequestError(InputError):
    """A request that is not answered for what it is, whatever it asks.

    Parameters
    ----------
    rule, details
        As of `InputError`.
    status
        Of HTTP: 401 without the token, 403 from another site, 404, 405, 408 too slow, 413 too
        large, 415 of another kind, 421 meant for another server, 503 too many, 504 too long.
    """

    def __init__(self, rule: str, status: int = 400, **details: Any) -> None:
        super().__init__(rule, **details)
        self.status = status


def answer(
    content: Mapping[str, Any] | str, status: int = 200, headers: Mapping[str, str] | None = None
) -> Response:
    """Return JSON as a response: the text of a record's `to_json`, or a mapping to be written."""
    text = content if isinstance(content, str) else dumps(content)
    return Response(text, status, headers, media_type="application/json")


def written(
    function: Callable[[Mapping[str, Any]], Mapping[str, Any]], asked: Mapping[str, Any]
) -> str:
    """Return what a function answers as JSON: who works it out writes it too, not the server."""
    return dumps(function(asked))


def error_object(error: InputError) -> dict[str, Any]:
    """Return what is wrong as plain data: the whole sentence, and its parts."""
    return {
        "field": error.field,
        "value": _value(error.value),
        "message": str(error),
        "rule": error.rule,
        "example": error.example,
        "line": error.line,
    }


def _value(given: object) -> str | None:
    """Return what was given as a short text, without the marks around a text."""
    if given is ABSENT or given is None:
        return None
    text = shown(given)
    return text[1:-1] if isinstance(given, str) else text


def refused(error: InputError) -> Response:
    """Return what is wrong as a response; input that is not usable is 422."""
    status = error.status if isinstance(error, RequestError) else _WRONG_INPUT
    return answer({"error": error_object(error)}, status, _HEADERS.get(status))


def language_for(query: str, chosen: str, accepted: str) -> str:
    """Return the language of an answer: asked for, or the server's, or the first accepted one.

    Parameters
    ----------
    query
        ``lang`` of the address; empty if it has none.
    chosen
        Of the server; empty if it has none.
    accepted
        The header Accept-Language.
    """
    if query or chosen:
        return language_of(query or chosen)
    ranked = []
    for one in accepted[:200].split(","):
        code, _, quality = one.partition(";q=")
        try:
            ranked.append((-float(quality or 1.0), code.strip()[:2].lower()))
        except ValueError:
            continue
    ranked.sort(key=lambda pair: pair[0])
    known = (code for weight, code in ranked if weight < 0.0 and code in languages())
    return next(known, language_of("en"))


async def read_body(request: Request, most: int = MOST_JSON) -> bytes:
    """Return the body of a request, bounded in size and time while it comes.

    Raises
    ------
    RequestError
        413 or 408.
    """
    body = bytearray()
    async for chunk in chunks(request, most):
        body += chunk
    return bytes(body)


async def chunks(request: Request, most: int) -> AsyncIterator[bytes]:
    """Yield the body of a request as it comes, bounded in size and time.

    Raises
    ------
    RequestError
        413 or 408.
    """
    told = request.headers.get("content-length", "")
    if told.isdecimal() and int(told[:20]) > most:
        raise _too_large(most)
    clock = asyncio.get_running_loop().time
    began, came = clock(), 0
    stream = request.stream().__aiter__()
    while True:
        left = began + min(_PATIENCE + came / _SLOWEST, _LONGEST) - clock()
        try:
            async with asyncio.timeout(max(left, 0.0)):  # unlike wait_for, without a task
                chunk = await anext(stream)
        except StopAsyncIteration:
            return
        except TimeoutError:
            raise RequestError(said("the body of the request did not come in time"), 408) from None
        came += len(chunk)
        if came > most:
            raise _too_large(most)
        yield chunk


@asynccontextmanager
async def received(request: Request, most: int, ending: str = "") -> AsyncIterator[Path]:
    """Keep the body of a request in a private file as long as the context lasts.

    Parameters
    ----------
    most
        Bytes.
    ending
        Of the file's name, which nothing else of the request is part of.

    Raises
    ------
    RequestError
        413 or 408; 503 if too many files come at once.
    """
    sender = "" if request.client is None else request.client.host
    if len(_COMING) >= _MOST_COMING or [*_COMING.values()].count(sender) >= _MOST_OF_ONE:
        raise RequestError(said("too many files are being sent; try again in a moment"), 503)
    with TemporaryDirectory(prefix="rolamento-") as folder:
        _COMING[folder] = sender
        try:
            path = Path(folder) / f"upload{ending}"
            with path.open("wb") as file:
                async for chunk in chunks(request, most):
                    file.write(chunk)
            yield path
        finally:
            del _COMING[folder]


def _too_large(most: int) -> RequestError:
    rule = said("the body of the request is larger than {most} MB", most=most / 1e6)
    return RequestError(rule, 413)


async def read_json(request: Request, most: int = MOST_JSON) -> dict[str, Any]:
    """Return the JSON object that a request brings, bounded in size, time and depth.

    Raises
    ------
    RequestError
        If it is too large, too slow, or no JSON by its Content-Type.
    FileError
        If it is not valid JSON, or no object.
    """
    kind = request.headers.get("content-type", "").partition(";")[0].strip().lower()
    if kind != "application/json":
        raise RequestError(
            said("must be application/json"), 415, field="Content-Type", value=kind,
            example="Content-Type: application/json",
        )  # fmt: skip
    body = await read_body(request, most)
    if len(body) <= _SMALL:  # read sooner than a thread takes it
        return _parsed(body)
    # other requests go on meanwhile
    return await anyio.to_thread.run_sync(_parsed, body)


def _parsed(body: bytes) -> dict[str, Any]:
    try:
        text = body.decode()
    except UnicodeDecodeError:
        raise FileError(said("is not UTF-8 text")) from None
    return parse_mapping(text, "json", "")
