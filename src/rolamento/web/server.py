"""The server of the app: what is let in, what is sent along, and what is ready."""

from __future__ import annotations

import asyncio
import gzip
import hmac
import ipaddress
import logging
import mimetypes
import os
import socket
import sys
import threading
from collections import Counter
from collections.abc import AsyncIterator, Mapping
from contextlib import asynccontextmanager, suppress
from functools import cache, lru_cache
from http.cookies import CookieError, SimpleCookie
from pathlib import Path
from secrets import token_hex
from typing import Any, Final
from urllib.parse import parse_qs, urlencode, urlsplit

from starlette.applications import Starlette
from starlette.datastructures import Headers
from starlette.exceptions import HTTPException
from starlette.middleware import Middleware
from starlette.requests import ClientDisconnect, Request
from starlette.responses import FileResponse, RedirectResponse, Response
from starlette.routing import Mount, Route
from starlette.staticfiles import StaticFiles
from starlette.types import ASGIApp, Message, Receive, Scope, Send
from uvicorn.protocols.http.h11_impl import H11Protocol

from rolamento.errors import InputError
from rolamento.io.json import dumps
from rolamento.records import frozen
from rolamento.web import api, drops, machine, page_api
from rolamento.web.answers import RequestError, answer, language_for, refused
from rolamento.web.hands import PROCESSES, Hands
from rolamento.web.limits import VISITOR, slow
from rolamento.web.openapi import DOCS, DOCUMENT, docs_page, openapi_document
from rolamento.web.warming import Warmth, make_ready, make_worker_ready
from rolamento.words import language, said, speaking

__all__ = ["PAGE", "Settings", "create_app", "server_options"]

PAGE: Final = Path(__file__).parent / "page"
"""Where the files of the page are; each is served as ``/static/<path>``."""
_log: Final = logging.getLogger("rolamento.web")

_HERE: Final = ("127.0.0.1", "localhost", "[::1]")
"""Names of this machine, as a browser on it says them."""
_COOKIE: Final = "rolamento_token"
"""And the port: two servers of a machine share its name."""
_SLOW_REFUSAL: Final = 0.5
"""Seconds before a wrong token is refused."""
_KINDS: Final = {".js": "text/javascript", ".mjs": "text/javascript", ".css": "text/css",
                 ".html": "text/html", ".svg": "image/svg+xml"}  # fmt: skip
"""Media types that the system's own table may have otherwise."""
_POLICY: Final = "; ".join(
    (
        "default-src 'none'",
        "script-src 'self'",
        "style-src 'self'",
        "img-src 'self' data: blob:",
        "connect-src 'self'",
        "manifest-src 'self'",
        "base-uri 'none'",
        "form-action 'self'",
        "frame-ancestors 'none'",
    )
)
_HEADERS: Final = {
    "content-security-policy": _POLICY,
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "cache-control": "no-cache",
}
_SAFE: Final = ("GET", "HEAD")
_WORKS: Final = ("/page/", f"{api.PREFIX}/")
"""Addresses at which even a GET may start work."""
_MOST_CONNECTIONS: Final = 256
_MOST_OF_ONE: Final = 192
"""Connections at once: all, and of one address."""
_LARGEST_HEAD: Final = 65_536
"""Bytes of a request's line and headers; a query may hold a case."""
_FIRST_REQUEST: Final = 10.0
"""Seconds after which a new connection has to have brought one."""
_KEPT_OPEN: Final = 30
"""Seconds that a connection is kept between two requests."""
_HAND_OVER: Final = 5e-4
"""Seconds after which a thread at work lets another one go on, ten times as often as usual: each
request passes from thread to thread some five times, and waited for it each time."""


@frozen(slots=False)
class Settings:
    """How a server is started.

    Attributes
    ----------
    host
        address that it listens at
    token
        that every request has to bring; none is asked for where it is empty
    code
        that lets in the first browser that brings it, in the place of the token; none if empty
    language
        of what is said, unless a request asks for another; empty to go by what the browser accepts
    warm
        whether to make ready for the first request in the background
    """

    host: str = "127.0.0.1"
    token: str = ""
    code: str = ""
    language: str = ""
    warm: bool = True


def create_app(settings: Settings | None = None) -> Starlette:
    """Make the server of the app.

    Parameters
    ----------
    settings
        How it is started; for this machine alone by default.
    """
    settings = settings or Settings()
    warmth, hands = Warmth(), Hands(PROCESSES if settings.warm else 0)

    @asynccontextmanager
    async def lifespan(_: Starlette) -> AsyncIterator[None]:
        sys.setswitchinterval(_HAND_OVER)
        warmth.ready = not settings.warm
        tasks = [asyncio.create_task(_make_all_ready(warmth))] if settings.warm else []
        yield
        hands.close()
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)

    app = Starlette(
        lifespan=lifespan,
        exception_handlers={InputError: _refused, HTTPException: _not_found},
        middleware=[Middleware(Gate, settings=settings)],
        routes=[
            *page_api.ROUTES,
            *drops.ROUTES,
            *machine.ROUTES,
            *api.ROUTES,
            Route(DOCUMENT, _openapi),
            Route(DOCS, _docs),
            Route("/", _index),
            Mount("/static", Files(directory=PAGE, check_dir=False)),
        ],
    )
    app.router.redirect_slashes = False
    app.state.settings, app.state.warmth, app.state.hands = settings, warmth, hands
    return app


async def _make_all_ready(warmth: Warmth) -> None:
    """Make this process ready in a thread that the program does not wait for, then a worker."""
    loop = asyncio.get_running_loop()
    done = asyncio.Event()

    def work() -> None:
        make_ready(warmth)
        with suppress(RuntimeError):  # the server has ended
            loop.call_soon_threadsafe(done.set)

    threading.Thread(target=work, daemon=True).start()
    await done.wait()
    await slow(make_worker_ready)


_CONNECTED: Final[Counter[str]] = Counter()
"""Connections by the address that they come from."""


class PatientProtocol(H11Protocol):
    """HTTP/1.1 that ends a connection on which no request comes, and one too many of an address."""

    def connection_made(self, transport: Any) -> None:
        """Begin to wait for the first request; uvicorn waits only between two."""
        super().connection_made(transport)
        held = transport.get_extra_info("socket")
        if held is not None and held.family != getattr(socket, "AF_UNIX", None):
            # asyncio does so for its own sockets alone; else each answer waits 40 ms for an echo
            held.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._first = self.loop.call_later(_FIRST_REQUEST, self._end_if_silent)
        self._address = self.client[0] if self.client else ""
        _CONNECTED[self._address] += 1
        if _CONNECTED[self._address] > _MOST_OF_ONE:
            transport.abort()

    def connection_lost(self, exc: Exception | None) -> None:
        """Stop waiting."""
        self._first.cancel()
        _CONNECTED[self._address] -= 1
        if not _CONNECTED[self._address]:
            del _CONNECTED[self._address]
        super().connection_lost(exc)

    def send_400_response(self, msg: str) -> None:
        """Answer what is no HTTP, with the headers of every answer."""
        head = [b"HTTP/1.1 400 Bad Request", b"content-type: text/plain; charset=utf-8"]
        head += [b"connection: close", *(b": ".join(pair) for pair in _ENCODED), b"", b""]
        self.transport.write(b"\r\n".join(head) + msg.encode("ascii", "replace"))
        self.transport.close()

    def _end_if_silent(self) -> None:
        if self.cycle is None:
            self.transport.close()


def server_options() -> dict[str, Any]:
    """Return how uvicorn runs the server: bounded connections, no log of requests."""
    return {
        "http": PatientProtocol,
        "loop": "asyncio",
        "ws": "none",
        "lifespan": "on",
        "log_level": "warning",
        "access_log": False,
        "server_header": False,
        "proxy_headers": False,
        "limit_concurrency": _MOST_CONNECTIONS,
        "h11_max_incomplete_event_size": _LARGEST_HEAD,
        "timeout_keep_alive": _KEPT_OPEN,
        "timeout_graceful_shutdown": 1,
    }


class Files(StaticFiles):
    """The files of the page, of kinds that do not depend on the system; text is sent packed."""

    def file_response(
        self, full_path: Any, stat_result: os.stat_result, scope: Scope, status_code: int = 200
    ) -> Response:
        """Answer with a file, or that it has not changed."""
        response = super().file_response(full_path, stat_result, scope, status_code)
        if not isinstance(response, FileResponse):
            return response
        path = os.fspath(full_path)
        response.headers["content-type"] = kind = _kind_of(path)
        if "gzip" not in Headers(scope=scope).get("accept-encoding", "") or not _packs(kind):
            return response
        headers = {
            "content-type": kind,
            "content-encoding": "gzip",
            "vary": "accept-encoding",
            "etag": f"W/{response.headers['etag']}",
        }
        return Response(_packed(path, stat_result.st_mtime_ns), status_code, headers)


def _packs(kind: str) -> bool:
    """Return whether a file becomes smaller when it is packed."""
    return kind.startswith("text/") or "svg" in kind or "json" in kind


@lru_cache(maxsize=64)
def _packed(path: str, _changed: int) -> bytes:
    return gzip.compress(Path(path).read_bytes(), mtime=0)


def _kind_of(path: str) -> str:
    kind = _KINDS.get(os.path.splitext(path)[1].lower()) or mimetypes.guess_type(path)[0]
    kind = kind or "application/octet-stream"
    return f"{kind}; charset=utf-8" if kind.startswith("text/") else kind


async def _index(request: Request) -> Response:
    return await Files(directory=PAGE, check_dir=False).get_response("index.html", request.scope)


async def _openapi(request: Request) -> Response:
    return answer(_texts(language())[0])


async def _docs(request: Request) -> Response:
    return Response(_texts(language())[1], media_type="text/html")


@cache
def _texts(code: str) -> tuple[str, str]:
    """The OpenAPI document and its page in a language."""
    with speaking(code):
        document = openapi_document()
        return dumps(document), docs_page(document)


async def _refused(_: Request, error: Exception) -> Response:
    assert isinstance(error, InputError)
    return refused(error)


async def _not_found(request: Request, error: Exception) -> Response:
    """Say in our words what Starlette refuses."""
    assert isinstance(error, HTTPException)
    path = request.url.path
    if error.status_code == 404:
        return refused(RequestError(said("nothing has this address"), 404, value=path))
    if error.status_code == 405:
        allowed = (error.headers or {}).get("allow", (error.headers or {}).get("Allow", ""))
        rule = said("must be {allowed} for this address", allowed=allowed)
        response = refused(RequestError(rule, 405, field="method", value=request.method))
        response.headers["allow"] = allowed
        return response
    return refused(RequestError(said("the request is not usable"), error.status_code))


class Gate:
    """What every request passes: whose it is, in which language, and what goes out with the answer.

    Parameters
    ----------
    app
        Behind it.
    settings
        How the server was started.
    """

    def __init__(self, app: ASGIApp, settings: Settings) -> None:
        self.app = app
        self.settings = settings
        self._code = settings.code

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Let a request in, or refuse it."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        headers = {
            name.decode("latin-1"): value.decode("latin-1") for name, value in scope["headers"]
        }
        query = _query(scope["query_string"])
        begun = False

        async def send_with_headers(message: Message) -> None:
            nonlocal begun
            if message["type"] == "http.response.start":
                begun = True
                own = {name for name, _ in message["headers"]}
                message["headers"] = [
                    *message["headers"],
                    *((name, value) for name, value in _ENCODED if name not in own),
                ]
            await send(message)

        asked = query.get("lang", "")
        language = language_for(asked, self.settings.language, headers.get("accept-language", ""))
        VISITOR.set(receive)
        with speaking(language):
            try:
                response = self._refusal(scope, headers, query)
                if response is not None and response.status_code == 401:
                    await asyncio.sleep(_SLOW_REFUSAL)
                handler = self.app if response is None else response
                await handler(scope, receive, send_with_headers)
            except ClientDisconnect:
                pass  # who went away while sending waits for no answer
            except Exception:
                number = token_hex(4)
                _log.exception("error %s in %s %s", number, scope["method"], scope["path"])
                if not begun:
                    await _broken(number)(scope, receive, send_with_headers)

    def _refusal(
        self, scope: Scope, headers: Mapping[str, str], query: Mapping[str, str]
    ) -> Response | None:
        """Return the answer to who may not come in."""
        try:
            self._check_host(headers)
            self._check_origin(scope, headers)
            return self._check_token(scope, headers, query)
        except InputError as error:
            return refused(error)

    def _check_host(self, headers: Mapping[str, str]) -> None:
        """Refuse what was meant for another name: it comes from a page that bent its name to here.

        Where a token is asked for, another name does no harm: the page has no token of ours.
        """
        host = headers.get("host", "")
        name = host.rpartition(":")[0] if not host.endswith("]") and ":" in host else host
        if not self.settings.token and name.lower() not in (*_HERE, _bracketed(self.settings.host)):
            rule = said("is not a name of this server")
            raise RequestError(rule, 421, field="Host", value=host, example="127.0.0.1:8000")

    def _check_origin(self, scope: Scope, headers: Mapping[str, str]) -> None:
        """Refuse what another site's page sends, or has a browser fetch where that is work."""
        origin, site = headers.get("origin"), headers.get("sec-fetch-site", "none")
        works = scope["method"] not in _SAFE or scope["path"].startswith(_WORKS)
        foreign = origin is not None and urlsplit(origin).netloc != headers.get("host")
        if works and (foreign or site not in ("same-origin", "none")):
            raise RequestError(said("is another site"), 403, field="Origin", value=origin)

    def _check_token(
        self, scope: Scope, headers: Mapping[str, str], query: Mapping[str, str]
    ) -> Response | None:
        """Refuse who does not know the token; take one in the address into a cookie."""
        token = self.settings.token
        if not token:
            return None
        if scope["method"] in _SAFE and self._is_let_in(query, token):
            kept = {name: value for name, value in query.items() if name not in ("token", "code")}
            response = RedirectResponse(
                "/" + scope["path"].lstrip("/") + (f"?{urlencode(kept)}" if kept else ""), 303
            )
            response.set_cookie(_cookie_of(scope), token, httponly=True, samesite="strict")
            return response
        scheme, _, given = headers.get("authorization", "").partition(" ")
        if scheme.lower() == "bearer" and _same(given.strip(), token):
            return None
        if _same(_cookie(headers.get("cookie", ""), _cookie_of(scope)), token):
            return None
        raise RequestError(
            said("is missing or wrong; open the address that the server printed"),
            401,
            field="token",
            example="Authorization: Bearer TOKEN",
        )

    def _is_let_in(self, query: Mapping[str, str], token: str) -> bool:
        """Whether an address has the token, or the code that counts once."""
        if _same(query.get("token", ""), token):
            return True
        is_first = bool(self._code) and _same(query.get("code", ""), self._code)
        if is_first:
            self._code = ""
        return is_first


def _query(text: bytes) -> dict[str, str]:
    """Return the first value of each name in an address; nothing of an address with too many."""
    try:
        found = parse_qs(text.decode("latin-1"), keep_blank_values=True, max_num_fields=100)
    except ValueError:
        return {}
    return {name: values[0] for name, values in found.items()}


def _same(given: str, token: str) -> bool:
    return hmac.compare_digest(given.encode(), token.encode())


def _cookie_of(scope: Scope) -> str:
    """Return the name of the cookie of this server."""
    return f"{_COOKIE}_{(scope.get('server') or ('', 0))[1] or 0}"


def _cookie(header: str, name: str) -> str:
    try:
        found = SimpleCookie(header).get(name)
    except CookieError:
        return ""
    return "" if found is None else found.value


def _bracketed(host: str) -> str:
    """Return an address as it stands in a URL."""
    try:
        return f"[{host}]" if ipaddress.ip_address(host).version == 6 else host
    except ValueError:
        return host.lower()


_ENCODED: Final = [(name.encode(), value.encode()) for name, value in _HEADERS.items()]


def _broken(number: str) -> Response:
    """Say that something is wrong here; what, the log says under the number."""
    rule = said("an error in the program; its log tells more under {number}", number=number)
    return refused(RequestError(rule, 500))
