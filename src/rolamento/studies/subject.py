"""What a study is of, as far as the study asks: a case, or a machine.

A subject says which fields may vary and what may be put out. Its `Work` solves cases: numbers and
arrays by field go in, status and outputs come out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from numpy.typing import NDArray

from rolamento.catalogue import CatalogueBearing
from rolamento.studies.axes import Column
from rolamento.studies.fields import Field
from rolamento.studies.outputs import Output
from rolamento.words import Note

if TYPE_CHECKING:
    from rolamento.studies.study import Study

__all__ = ["Attempt", "Found", "Inputs", "Subject", "Work"]

Indices = NDArray[np.intp]
Inputs = Mapping[str, NDArray[Any]]
"""What each varied field takes in each of some cases; quantities in SI units."""


class Found(Protocol):
    """Some solved cases."""

    @property
    def number(self) -> NDArray[Any]:
        """How each of them ended."""
        ...

    @property
    def advice(self) -> Sequence[Note | None]:
        """Why a case has no result; may be empty if all have one."""
        ...

    def of(self, output: Output) -> NDArray[Any] | None:
        """Return an output of all of them; None if these have no such output."""
        ...


Attempt = Callable[[], Found]
"""Solves some cases; raises `InputError` if there are no such cases."""


class Work(Protocol):
    """Solves the cases of a study.

    balls, rows: sizes of the dimensions of outputs per ball and per row. chunk: cases that are best
    solved together. listed: bearings outside the built-in catalogue that its designations need.
    """

    balls: int
    rows: int
    chunk: int
    listed: tuple[CatalogueBearing, ...]

    def attempts(
        self, group: int, inputs: Inputs, count: int, threads: int | None
    ) -> Iterator[tuple[Indices, Attempt]]:
        """Yield ways to solve cases of a group, each with the places of those that it solves."""
        ...

    def qualifications(self, group: int, inputs: Inputs) -> Sequence[Note]:
        """Return what qualifies the outputs of a single case."""
        ...


class Subject(Protocol):
    """What a study varies."""

    @property
    def key(self) -> str:
        """What holds it in the file of a study, and in a result."""
        ...

    @property
    def title(self) -> str:
        """Its title."""
        ...

    def to_toml(self) -> str:
        """Return it as the text of its own file."""
        ...

    def check_field(self, name: str, at: str) -> None:
        """Refuse a field that it does not have; at: where the study has it."""
        ...

    def place_of(self, name: str) -> str:
        """Return a field's one name, where it may be called by several."""
        ...

    def varies_in_batch(self, name: str) -> bool:
        """Return whether cases that differ in a field need no group of their own."""
        ...

    def fields(self) -> Mapping[str, Field]:
        """Return the fields that may vary, by their dotted names."""
        ...

    def catalogue(self) -> Mapping[str, Output]:
        """Return what may be put out, by the names that a study uses."""
        ...

    def default_outputs(self) -> Sequence[str]:
        """Return what is put out where a study does not say."""
        ...

    def outputs_of(self, names: Sequence[str]) -> tuple[Output, ...]:
        """Return the outputs of some names, which must be known."""
        ...

    def refuse_missing(self, names: Sequence[str], varied: Sequence[str]) -> None:
        """Refuse outputs that rest on what is not there, whatever varies."""
        ...

    def check_size(self, cases: int) -> None:
        """Refuse more cases than it can be solved for."""
        ...

    def work(self, study: Study, columns: Sequence[Mapping[str, Column]]) -> Work:
        """Return what solves the cases of a study; columns: values along each axis."""
        ...
