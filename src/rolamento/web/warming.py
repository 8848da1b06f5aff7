"""Making ready: what the first request would wait for is loaded and compiled before it comes.

A request that comes earlier waits no longer than it would have to anyway; the page says how far
the server is.
"""

from __future__ import annotations

import gc
import logging
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

from rolamento.numerics.threads import load_at_first_use
from rolamento.words import languages, speaking

__all__ = ["Warmth", "make_follower_ready", "make_ready", "make_worker_ready"]

_log: Final = logging.getLogger("rolamento.web")
_SPEED: Final = {"inner_speed": "1480 rpm"}
_BALLS: Final = {"bearing": {"designation": "6310"},
                 "duty": {**_SPEED, "load": {"fx": "1 kN", "fz": "5 kN"}}}  # fmt: skip
_SET: Final = {
    "bearing": {
        "designation": "7210 C",
        "arrangement": "DB",
        "spacing": "30 mm",
        "preload": {"force": "300 N"},
    },
    "duty": {**_SPEED, "load": {"fz": "2 kN"}},
}
_ROLLERS: Final = {"bearing": {"designation": "NU 208"}, "duty": {**_SPEED, "load": {"fz": "5 kN"}}}
_REST: Final = {"lubricant": "ISO VG 68", "temperature": {"lubricant": "70 degC"}}


@dataclass
class Warmth:
    """How far a server is with making ready."""

    ready: bool = False
    done: int = 0
    total: int = 0

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain data."""
        return {"ready": self.ready, "done": self.done, "total": self.total}


def make_ready(warmth: Warmth) -> None:
    """Do what the first requests ask for, step by step; what fails there fails for them too."""
    steps: tuple[Callable[[], None], ...] = (
        *(lambda code=code: _start(code) for code in languages()),
        *(lambda case=case: _follow(case) for case in (_BALLS, _SET, _ROLLERS)),
    )
    warmth.total = len(steps)
    load_at_first_use()
    for step in steps:
        try:
            step()
        except Exception:
            _log.exception("a step of making ready failed")
        warmth.done += 1
    _settle_memory()
    warmth.ready = True


def make_follower_ready() -> None:
    """Load and compile what follows a hand, in a process that answers nothing else."""
    load_at_first_use()
    for case in (_BALLS, _SET, _ROLLERS):
        _follow(case)
    _settle_memory()


def make_worker_ready() -> None:
    """Load and compile what slow requests need, in the process that answers them."""
    from rolamento.tasks.batch import batch
    from rolamento.tasks.report import calculation_report  # noqa: F401  # what it imports is the point

    batch(_case(_BALLS), {"duty.load.fz": ["1 kN", "2 kN"]})
    _settle_memory()


def _settle_memory() -> None:
    """Look for no more garbage in what is loaded: it stays, and a look takes as long as answers."""
    gc.collect()
    gc.freeze()


def _start(code: str) -> None:
    """Make what the page starts with, in a language."""
    from rolamento.web.page_api import start

    with speaking(code):
        start()


def _follow(tables: dict[str, Any]) -> None:
    """Follow a case as the page does, alone and as one of several, which other code solves."""
    from rolamento.pages.report import PARTS
    from rolamento.solution import solve
    from rolamento.web.live import live
    from rolamento.web.pictures import PICTURES

    solve(_case(tables), fz=[1000.0, 2000.0])
    for quick in (False, True):
        request = {"case": {**tables, **_REST}, "changes": {}}
        seen = {"pictures": list(PICTURES), "sections": [] if quick else list(PARTS)}
        (answer,) = live({"cases": [request], **seen, "quick": quick})["cases"]
        if answer["error"] is not None:
            raise RuntimeError(answer["error"]["message"])


def _case(tables: dict[str, Any]) -> Any:
    from rolamento.case import Case

    return Case.from_mapping(tables)
