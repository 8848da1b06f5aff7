"""Compile all kernels, so that nothing that comes later waits for the compiler.

A kernel is compiled for what calls it: a small problem of each kind is solved.
"""

from __future__ import annotations

import logging
import os
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from contextlib import ExitStack, suppress
from multiprocessing import get_context
from typing import TYPE_CHECKING, Any, Final, cast

import numpy as np

from rolamento import __version__
from rolamento.numerics import beside
from rolamento.records import frozen
from rolamento.words import marked

if TYPE_CHECKING:
    from rolamento.case import Case
    from rolamento.rows.ball.row import BallRow
    from rolamento.solved import Solved

__all__ = ["CHAINS", "PARTS", "Part", "Warmed", "warm"]


@frozen
class Part:
    """Kernels that are compiled together.

    title: of what, untranslated; solve: what needs them.
    """

    title: str
    solve: Callable[[], object]


@frozen
class Warmed:
    """What was done: the titles of the parts, and whether another process was at it already."""

    parts: tuple[str, ...]
    busy: bool = False


def warm(
    progress: Callable[[int, int], None] = lambda done, total: None, *, background: bool = False
) -> Warmed:
    """Compile what is not kept on this machine yet.

    Parameters
    ----------
    progress
        Takes how many parts are done, and of how many.
    background
        Give way to others, and use one processor; else as many as help.
    """
    with beside.alone() as free:
        if not free:
            return Warmed((), busy=True)
        if background:
            with suppress(AttributeError, OSError):  # Windows has no such thing
                os.nice(beside.LOW)
        beside.begin(__version__)
        progress(0, len(PARTS))
        for done, _ in enumerate(_compiled(background), start=1):
            progress(done, len(PARTS))
    return Warmed(tuple(part.title for part in PARTS))


def _compiled(background: bool) -> Iterator[Part]:
    """Compile the parts; yield each as it is done."""
    if background:
        for part in PARTS:
            _compile(part)
            yield part
        return
    with ExitStack() as stack:
        waiting = {}
        for chain in CHAINS:  # what follows another part finds its kernels in the same process
            pool = ProcessPoolExecutor(1, get_context("spawn"))
            stack.enter_context(pool)
            waiting.update({pool.submit(_compile, part): part for part in chain})
        for done in as_completed(waiting):
            done.result()
            yield waiting[done]


def _compile(part: Part) -> None:
    """Solve what needs the kernels of a part, in this process."""
    os.environ[beside.VARIABLE] = beside.HERE
    logging.getLogger("rolamento").setLevel(logging.ERROR)  # that it takes a while is known
    part.solve()


def _case(bearing: dict[str, Any], **tables: Any) -> Case:
    from rolamento.case import Case

    duty = {"inner_speed": "1000 rpm", "load": {"fx": "2 kN", "fz": "1 kN"}}
    return Case.from_mapping({"bearing": bearing, "duty": duty, **tables})


def _solved(bearing: dict[str, Any], cases: int = 2, **tables: Any) -> Solved:
    """Solve cases of a bearing at two loads and more, which takes the compiler."""
    from rolamento.solution import solve

    return solve(_case(bearing, **tables), fz=np.linspace(1e3, 1.5e3, cases))


_BALLS: Final = {"designation": "7210 C"}
_OIL: Final[dict[str, Any]] = {
    "lubricant": {"base_oil": "ISO VG 68", "friction_coefficient": 0.07},
    "temperature": {"lubricant": "70 degC"},
}


def _balls() -> None:
    from rolamento.rows.ball.run import compile_all
    from rolamento.system import spread

    row = cast("BallRow", spread(_case(_BALLS), threads=1).rows[0].row)
    compile_all(row.p, np.ones((1, row.element_count)), row.element_count)
    _solved({**_BALLS, "arrangement": "DB", "spacing": "30 mm", "preload": "300 N"})


def _formulas() -> None:
    """Enough contacts for a compiled loop to pay."""
    from rolamento.analysis import analyse
    from rolamento.contact.subsurface import maximum_shear
    from rolamento.numerics.elementwise import MANY

    many = _solved(_BALLS, 400, **_OIL)
    for model in ("jones_full", "harris_1971"):
        analyse(many, model=model)
    many.to_xarray()
    maximum_shear(np.full(MANY, 1e9), 2e-3, 1e-3, 0.2)  # as of ceramic rings


def _rollers() -> None:
    from rolamento.contact.coupled import coupled_press

    for model in ({}, {"roller_contact": "coupled", "slices": 5}):
        _solved({"designation": "30206"}, model=model)
    size = {"effective_length": 0.01, "roller_diameter": 0.01}
    coupled_press(1e-6, 0.0, np.zeros(5), **size, curvature=200.0, modulus=1e11, share=0.5)


def _moved_by_friction() -> None:
    _solved(_BALLS, model={"raceway_control": "friction"}, **_OIL)


def _on_several_arcs() -> None:
    _solved({"designation": "QJ 210"})


CHAINS: Final = (
    (
        Part(marked("balls, alone and in sets"), _balls),
        Part(marked("friction, films and stresses of many contacts"), _formulas),
    ),
    (
        Part(marked("rollers"), _rollers),
        Part(marked("balls that friction moves"), _moved_by_friction),
        Part(marked("four-point contact"), _on_several_arcs),
    ),
)
"""What is compiled: by one process each, one after the other."""
PARTS: Final = tuple(part for chain in CHAINS for part in chain)
