"""What the commands share: languages, exit codes, and how a command ends."""

from __future__ import annotations

import os
import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from enum import StrEnum
from typing import TYPE_CHECKING, Annotated, Any, Final

import typer

from rolamento.cli.streams import STANDARD_STREAM, complain
from rolamento.errors import InputError
from rolamento.words import languages, said, speaking

SOLVED: Final = 0
NO_RESULT: Final = 1
WRONG_INPUT: Final = 2
INTERRUPTED: Final = 130


if TYPE_CHECKING:

    class Language(StrEnum):
        """The languages that there are catalogues for."""

        en = "en"

else:
    Language = StrEnum("Language", {code: code for code in languages()})

LanguageOption = Annotated[
    Language | None,
    typer.Option(
        "--lang", help="Language of pages, help and messages; by default that of the locale."
    ),
]


def json_option(what: str) -> Any:
    """Return the option ``--json [FILE]`` that does what is said."""
    text = f"{what}; without FILE, to standard output."
    return typer.Option("--json", metavar="[FILE]", help=text)


@contextmanager
def plain_endings(lang: Language | None) -> Iterator[None]:
    """Turn wrong input and Ctrl-C into one line and an exit code; a bug stays a traceback."""
    with speaking(lang):
        try:
            yield
        except InputError as error:
            complain(str(error))
            raise typer.Exit(WRONG_INPUT) from None
        except KeyboardInterrupt as stop:  # which may say what is kept
            complain(str(stop) or said("interrupted"))
            raise typer.Exit(INTERRUPTED) from None


@contextmanager
def ended_softly() -> Iterator[None]:
    """Let a request to terminate end a long command as Ctrl-C does: what is done is kept.

    Where Ctrl-C is ignored, as in what a shell starts in the background, say how it is ended.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        complain(
            said(
                "Ctrl-C is ignored here, in the background: 'kill {process}' ends the command, and"
                " what is done is kept",
                process=str(os.getpid()),
            )
        )
    before = signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)


def same_file(path: str, other: str) -> bool:
    """Return whether two paths lead to one file, whether it is there or not."""
    if STANDARD_STREAM in (path, other):
        return path == other
    try:
        if os.path.realpath(path) == os.path.realpath(other):
            return True
        return os.path.samefile(path, other)
    except (OSError, ValueError):
        return False
