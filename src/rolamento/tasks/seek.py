"""An input for an output: which value of a field gives a result the value that it should have."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final

import numpy as np

from rolamento.case import Case
from rolamento.errors import InputError
from rolamento.io.json import dumps, plain
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.tasks.case_request import CaseRequest
from rolamento.tasks.parameters import Progress, quietly
from rolamento.tasks.request import PICTURE, Input, Product
from rolamento.words import Note, marked, said

if TYPE_CHECKING:
    from rolamento.studies.fields import Field
    from rolamento.studies.outputs import Output
    from rolamento.tasks.curve import Curve, Scale

__all__ = ["Goal", "GoalSeek"]

GOAL: Final = marked("Goal")
_POINTS: Final = 25
"""Points of the curve, between which solutions are looked for."""
_ROUNDS: Final = 8
_PARTS: Final = 9
"""A round cuts the part of the curve that holds a solution into so many."""
_WIDER: Final = (10.0, 100.0)
"""Times the value of the field, where no range is given and it is not found near it."""
_CLOSE: Final = 1e-6
"""Relative, of the output at a solution."""


@frozen(eq=False)
class Goal:
    """The values of a field at which an output is what it should be.

    Attributes
    ----------
    curve
        the output over the field
    target
        of the output, in its unit
    found
        values of the field, rising, SI; none if the output has the value nowhere in the range
    jumps
        values at which the output jumps over the target, or has no result on one side
    cases
        the case at each that was found
    notes
        what qualifies the results there
    """

    curve: Curve
    target: float
    found: tuple[float, ...]
    jumps: tuple[float, ...]
    cases: tuple[Case, ...]
    notes: tuple[Note, ...]
    report: ClassVar[None] = None
    text: ClassVar[str] = ""

    @property
    def field(self) -> Field:
        """What is varied."""
        return self.curve.field

    @property
    def output(self) -> Output:
        """What is to have a value."""
        return self.curve.output

    @property
    def status(self) -> str:
        """How it ended: found, not_in_range, or no_result where the whole curve has none."""
        if self.found:
            return "found"
        return "not_in_range" if np.isfinite(self.curve.numbers).any() else "no_result"

    @property
    def is_result(self) -> bool:
        """Whether any value was found."""
        return bool(self.found)

    @property
    def complaint(self) -> str:
        """Why nothing was found; "" if something was."""
        from rolamento.pages.seek import seek_statement

        return "" if self.found else seek_statement(self)

    def page(self) -> Any:
        """Return what people read of it."""
        from rolamento.pages.seek import seek_page

        return seek_page(self)

    def picture(self) -> Any:
        """Draw the output over the field, with the goal."""
        from rolamento.pages.seek import seek_picture

        return seek_picture(self)

    def to_json(self) -> str:
        """Return everything as JSON."""
        return dumps(self.to_mapping(), indent=2)

    def to_mapping(self) -> dict[str, Any]:
        """Return everything as plain data, in SI units; lives in their own."""
        return {
            "schema": 1,
            "kind": "seek",
            "status": self.status,
            "field": self.field.name,
            "output": self.output.name,
            "unit": self.output.unit,
            "target": self.target,
            "found": list(self.found),
            "jumps": list(self.jumps),
            "curve": plain(
                {
                    "values": self.curve.values,
                    "numbers": self.curve.numbers,
                    "status": self.curve.status.tolist(),
                }
            ),
            "notes": [note.to_mapping() for note in self.notes],
            "cases": [case.to_mapping() for case in self.cases],
        }


class GoalSeek(CaseRequest):
    """Find the input that brings an output to a target value.

    Any field of a case, for any result of one number: in the range of the field, all solutions
    that a curve of 25 points shows.

    Parameters
    ----------
    vary
        Field to vary, such as `bearing.preload`, or with its range, FIELD=FIRST..LAST; by default
        around its value, up to a hundred times as much.
    wanted
        Output and the value that it should have, such as 'stiffness_xx=200 N/um' or
        'life_hours=20000 h'.
    log
        Logarithmic spacing of the values.

    >>> duty = {"duty.load.fz": "5 kN", "duty.inner_speed": "1480 rpm"}
    >>> field, goal = "duty.load.fz=2..20kN", "max_inner_max_pressure=2 GPa"
    >>> asked = GoalSeek(case="6310", changes=duty, vary=field, wanted=goal)
    >>> print([round(force) for force in asked.run().found])
    [4435]
    """

    vary: Annotated[
        str,
        Input("Field to vary", group=GOAL, example="bearing.preload=100..1000N", metavar="FIELD"),
    ]
    wanted: Annotated[
        str,
        Input(
            "Goal",
            group=GOAL,
            example="stiffness_xx=200 N/um",
            option="--for",
            metavar="OUTPUT=VALUE",
        ),
    ]
    log: Annotated[bool, Input("By equal ratios", "switch", GOAL)] = False

    counts: ClassVar = True
    examples: ClassVar = (
        "Examples: seek pair.toml --vary bearing.preload --for 'stiffness_xx=200 N/um'; "
        "seek 6310 --fr '5 kN' --speed '1480 rpm' --vary duty.load.fz=2..20kN --for "
        "'max_inner_max_pressure=2 GPa' --plot curve.png."
    )

    def run(self, progress: Progress = quietly) -> Goal:
        """Look for it.

        Raises
        ------
        FileError, InputError
            If the case cannot be read, the field takes no range, there is no such output, or the
            value is none of its unit.
        """
        from rolamento.charts.axes_units import si_value
        from rolamento.tasks.curve import curve_over

        case = self.loaded(needs_load=False)
        name, first, last = _range_of(self.vary)
        output, value = self._goal()
        for low, high, scale in self._ranges(case, name, first, last):
            try:
                curve = curve_over(case, name, output, low, high, scale=scale, points=_POINTS)
            except InputError as error:
                raise _in_words_of(error) from None
            target = si_value(value, curve.output.unit, "wanted", "stiffness_xx=200 N/um")
            parts = _crossed(curve.values, curve.numbers - target)
            if parts:
                break
        found: list[float] = []
        jumps: list[float] = []
        for done, (low, high) in enumerate(parts):
            progress(done, len(parts))
            at, is_jump = _closed_in(curve, target, low, high)
            (jumps if is_jump else found).append(at)
        cases = tuple(case.with_({curve.field.name: at}) for at in found)
        notes = dict.fromkeys(note for one in cases for note in _notes_of(one, curve.output))
        return Goal(curve, target, tuple(found), tuple(jumps), cases, tuple(notes))

    def _ranges(
        self, case: Case, name: str, first: str | None, last: str | None
    ) -> Iterator[tuple[Any, Any, Scale]]:
        """Yield where to look: in the range that is given, or ever wider around the value."""
        from rolamento.studies.fields import read_field
        from rolamento.tasks.curve import bounds_of
        from rolamento.tasks.report import number_of_field

        yield first, last, "log" if self.log else "linear"
        own = number_of_field(case, name)
        if first is not None or not own or own < 0.0:
            return
        field = read_field(name, at="vary")
        least, most = bounds_of(field)
        if field.dimension != "temperature":
            for factor in _WIDER:
                ends = max(own / factor, least), min(own * factor, most)
                yield field.written(ends[0]), field.written(ends[1]), "log"

    def _goal(self) -> tuple[str, str]:
        output, equals, value = self.wanted.partition("=")
        if not equals or not output.strip() or not value.strip():
            raise InputError(said("must be OUTPUT=VALUE"), field="wanted", value=self.wanted)
        return output.strip(), value.strip()

    products: ClassVar = {"plot": Product(PICTURE, lambda asked, found: found.picture())}


def _range_of(text: str) -> tuple[str, str | None, str | None]:
    """Return a field, and the ends of its range if they are given; a preload is its force."""
    from rolamento.studies.ranges import range_of_field

    name, first, last = text.strip(), None, None
    if "=" in text:
        try:
            name, first, last = range_of_field(text, "bearing.preload.force=100..1000N")
        except InputError as error:
            raise error.with_details(field="vary") from None
    return ("bearing.preload.force" if name == "bearing.preload" else name), first, last


def _in_words_of(error: InputError) -> InputError:
    """Say which field of the request gave what a curve refuses."""
    fields = {
        "field": "vary", "low": "vary", "high": "vary", "output": "wanted", "outputs": "wanted",
    }  # fmt: skip
    return error.with_details(field=fields.get(error.field, error.field))


def _crossed(values: FloatArray, over: FloatArray) -> list[tuple[float, float]]:
    """Return the parts of a curve in which it passes its target; a point on it counts once.

    over: by how much the curve exceeds the target at the values.
    """
    parts = []
    for place in range(len(over) - 1):
        left, right = over[place], over[place + 1]
        if left == 0.0:
            parts.append((values[place], values[place]))
        elif left * right < 0.0:
            parts.append((values[place], values[place + 1]))
    if over[-1] == 0.0:
        parts.append((values[-1], values[-1]))
    return [(float(low), float(high)) for low, high in parts]


def _closed_in(curve: Curve, target: float, low: float, high: float) -> tuple[float, bool]:
    """Return where a curve has the target between two values, and whether it jumps over it."""
    from rolamento.tasks.curve import curve_over

    if low == high:
        return low, False
    at = low
    for _ in range(_ROUNDS):
        fine = curve_over(
            curve.case, curve.field.name, curve.output.name,
            curve.field.written(low), curve.field.written(high), points=_PARTS + 1,
        )  # fmt: skip
        inside = (fine.values >= low) & (fine.values <= high)  # the present value comes besides
        values, over = fine.values[inside], fine.numbers[inside] - target
        known = np.isfinite(over)
        nearest = int(np.argmin(np.where(known, np.abs(over), np.inf)))
        at = float(values[nearest])
        if abs(over[nearest]) <= _CLOSE * max(abs(target), _size(curve.numbers)):
            return at, False
        crossed = _crossed(values, over)
        if not crossed:
            return at, True
        low, high = crossed[0]
    return at, True


def _size(numbers: FloatArray) -> float:
    """Greatest magnitude of an output, beside which a target of zero is met."""
    return 1e-3 * float(np.nanmax(np.abs(numbers)))


def _notes_of(case: Case, output: Output) -> tuple[Note, ...]:
    """Return what qualifies a result: of the state, and of the laws that the output rests on."""
    from rolamento.analysis import analyse

    found = analyse(case)
    notes = [*found.solved.notes[0]]
    if "life" in output.needs and found.life is not None:
        theories = found.life.theories
        own = next((theories[name] for name in theories if output.name.endswith(f"_{name}")), None)
        notes += found.life.qualifications() if own is None else own.notes_of()
    if "friction" in output.needs and found.friction is not None:
        models = [one for one in found.friction.validity if output.name.endswith(f"_{one.model}")]
        notes += found.friction.qualifications(found.solved)
        notes += [note for one in models for note in one.notes_of()]
    if "lubricant" in output.needs and found.film is not None:
        notes += found.film.notes_of()
    return tuple(notes)
