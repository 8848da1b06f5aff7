"""`rolamento app`: the app in the browser, served by this machine."""

from __future__ import annotations

import errno
import ipaddress
import os
import secrets
import socket
import webbrowser
from typing import TYPE_CHECKING, Annotated, Any, Final

import typer

from rolamento.cli.common import SOLVED, LanguageOption, plain_endings
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.streams import print_text
from rolamento.cli.waiting import silenced
from rolamento.errors import InputError, cause
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.web.server import Settings

__all__ = ["app", "browser"]

_HOST: Final = "127.0.0.1"
_PORT: Final = 8000
_TRIED: Final = 50
"""Ports after the usual one that may do instead."""
_HIGHEST_PORT: Final = 65535
_SHORTEST_TOKEN: Final = 8


app = typer.Typer()


@app.command(
    "app",
    cls=JsonCommand,
    epilog="Examples: app; app --port 9000 --no-browser; app --host 0.0.0.0 --lang pt.",
)
def browser(
    host: Annotated[
        str,
        typer.Option(
            "--host",
            metavar="ADDRESS",
            help="Address to listen on; any but this machine's own requires a token.",
        ),
    ] = _HOST,
    port: Annotated[
        int | None,
        typer.Option(
            "--port",
            metavar="N",
            help=f"Port, 1 to 65535; by default {_PORT} or the next free one.",
        ),
    ] = None,
    token: Annotated[
        str | None,
        typer.Option(
            "--token",
            metavar="TEXT",
            envvar="ROLAMENTO_TOKEN",
            show_envvar=False,
            help="Token that every visitor needs, at least 8 characters; made and printed if"
            " the app listens on any address but this machine's own. ROLAMENTO_TOKEN in the"
            " environment is not shown to other users of the machine.",
        ),
    ] = None,
    show: Annotated[
        bool, typer.Option("--browser/--no-browser", help="Open the page in the browser.")
    ] = True,
    lang: LanguageOption = None,
) -> None:
    """Open the app in the browser.

    Move a load and see the bearing answer. It is served by this machine for itself, with
    an HTTP API; Ctrl-C ends it.
    """
    with plain_endings(lang):
        _check(host, port, token)
        if token is None and not _is_this_machine(host):
            token = secrets.token_urlsafe(16)
        with _listening(host, port) as listener:
            from rolamento.web.server import Settings

            # others see the address that a browser is started with: what it has counts once
            code = secrets.token_urlsafe(16) if token and show else ""
            settings = Settings(host=host, token=token or "", code=code, language=lang or "")
            _serve(listener, settings, show=show)
    raise typer.Exit(SOLVED)


def _check(host: str, port: int | None, token: str | None) -> None:
    """Refuse what is no address, no port or no token, before anything is loaded."""
    if host != "localhost":
        try:
            ipaddress.ip_address(host)
        except ValueError:
            rule = said("must be an address of this machine")
            raise InputError(rule, source="--host", value=host, example="--host 0.0.0.0") from None
    if port is not None and not 1 <= port <= _HIGHEST_PORT:
        rule = said("must be from {least} to {most}", least=1, most=_HIGHEST_PORT)
        raise InputError(rule, source="--port", value=port, example=f"--port {_PORT}")
    if token is not None:
        rule = said("must be at least {least} letters, digits, - or _", least=_SHORTEST_TOKEN)
        plain = token.replace("-", "").replace("_", "")
        if len(token) < _SHORTEST_TOKEN or not (plain.isalnum() and plain.isascii()):
            raise InputError(rule, source="--token", example="--token 4f9c1e7ab2")


def _is_this_machine(host: str) -> bool:
    return host == "localhost" or ipaddress.ip_address(host).is_loopback


def _listening(host: str, port: int | None) -> socket.socket:
    """Return a socket at the port, or at the first free one from the usual one on.

    Raises
    ------
    InputError
        If the address is not this machine's, or the port is taken.
    """
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    ports = range(_PORT, _PORT + _TRIED) if port is None else [port]
    for number in ports:
        try:
            return socket.create_server((host, number), family=family, backlog=128)
        except OSError as error:
            failure = OSError(error.errno, os.strerror(error.errno or errno.EADDRNOTAVAIL))
            if error.errno != errno.EADDRINUSE:
                break
    rule = said("cannot be listened at: {reason}", reason=cause(failure))
    example = "--port 8001" if port is not None else "--host 127.0.0.1"
    raise InputError(rule, value=f"{host}:{ports[0]}", example=example)


def _serve(listener: socket.socket, settings: Settings, *, show: bool) -> None:
    """Serve until Ctrl-C."""
    import uvicorn

    from rolamento.web.server import create_app, server_options

    class Server(uvicorn.Server):
        async def startup(self, sockets: Any = None) -> None:
            await super().startup(sockets)
            if self.started:
                _welcome(listener, settings, show=show)

    config = uvicorn.Config(create_app(settings), **server_options())
    with silenced():  # it is at work as long as it is wanted
        try:
            Server(config).run(sockets=[listener])
        except KeyboardInterrupt:
            print_text("\n")


def _welcome(listener: socket.socket, settings: Settings, *, show: bool) -> None:
    """Say where the page is, and open it."""
    port = listener.getsockname()[1]
    here = _address(settings, port, own=True)
    print_text(said("The app is at {address} (Ctrl-C ends it)", address=here) + "\n")
    if not _is_this_machine(settings.host):
        there = _address(settings, port, own=False)
        print_text(said("From other machines: {address}", address=there) + "\n")
    if show:
        webbrowser.open(_address(settings, port, own=True, code=settings.code))


def _address(settings: Settings, port: int, *, own: bool, code: str = "") -> str:
    """Return the address of the page, as this machine or another one calls it."""
    host = settings.host
    if host != "localhost" and ipaddress.ip_address(host).is_unspecified:
        host = _HOST if own else socket.gethostname()
    name = f"[{host}]" if ":" in host else host
    query = f"?code={code}" if code else f"?token={settings.token}" if settings.token else ""
    return f"http://{name}:{port}/{query}"
