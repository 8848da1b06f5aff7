"""Notes on a result, and advice where there is none.

A note never changes a number. Each check reads one solved case and returns notes: limits exceeded,
contacts lost, assumptions strained. A type of bearing brings the names of those that are its own.
Their sentences are in `rolamento.words.sentences.solved`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Final, TypeAlias

from rolamento.solved.notes import balls, bearing, rollers
from rolamento.solved.notes.advice import advice_on
from rolamento.solved.notes.balls import jones_verdict, pressure_limit
from rolamento.solved.notes.bearing import (
    SPEED_LIMIT,
    TILT_LIMIT,
    misalignment,
    nothing_given,
    usual_misalignments,
)
from rolamento.words import Note

if TYPE_CHECKING:
    from rolamento.solved.result import Solved

__all__ = [
    "SPEED_LIMIT",
    "TILT_LIMIT",
    "advice_on",
    "jones_verdict",
    "misalignment",
    "notes_on",
    "nothing_given",
    "pressure_limit",
    "usual_misalignments",
]

_Check: TypeAlias = Callable[["Solved"], Iterator[Note]]

_OF_ANY: Final = (
    bearing.lost_contacts, balls.pressures, bearing.speeds, bearing.tilts, bearing.free_directions,
)  # fmt: skip
_OF_DESIGNATION: Final = (bearing.other_than_said, bearing.estimated_geometry, bearing.letters)
"""Checks of what a designation says, if there is one."""
_OF_ROWS: Final = (bearing.lost_rows, bearing.nearly_lost)
"""Checks of several rows beside each other."""
_OF_CONTROL: Final[Mapping[_Check, tuple[str, ...]]] = {
    balls.control: ("outer", "inner", "jones"),
    balls.orbits: ("inner", "jones"),
    balls.gyroscopic_slip: ("outer", "inner", "jones", "none"),
    balls.rolling: ("friction",),
}
"""The raceway controls of the model that a check is about, where it is not about all."""
_OF_ROLLERS: Final = (
    rollers.rollers_unloaded, rollers.line_pressures, rollers.misaligned,
    rollers.on_part_of_the_length, rollers.ends,
)  # fmt: skip
"""Checks of the rollers of a ring, whatever else rolls in it."""
_ORDER: Final = (
    bearing.other_than_said, bearing.lost_rows, *_OF_ANY[:2], balls.past_edge, balls.shoulders,
    *_OF_ANY[2:], bearing.free_tilt, balls.control, balls.orbits, balls.gyroscopic_slip,
    balls.gyroscopic_left_out, balls.arches, balls.rolling, *_OF_DESIGNATION[1:],
    bearing.nearly_lost, bearing.radial_load_on_thrust, balls.four_point_load,
    rollers.axial_load_on_torus, *_OF_ROLLERS,
)  # fmt: skip
CHECKS: Final[Mapping[str, _Check]] = {check.__name__: check for check in _ORDER}
"""Every check by its name, in the order of the notes."""


def notes_on(solved: Solved) -> tuple[Note, ...]:
    """The notes on a single case; none without a result."""
    if not solved.converged[0]:
        return ()
    case, control = solved.case, solved.case.model.raceway_control
    common = (
        *_OF_ANY,
        *(_OF_DESIGNATION if case.bearing.resolved is not None else ()),
        *(_OF_ROWS if len(solved.rows) > 1 else ()),
        *(_OF_ROLLERS if solved.rollers is not None else ()),
    )
    brought = set.intersection(*({*one.notes} for one in case.bearing.row_types))
    wanted = brought | {check.__name__ for check in common}
    return tuple(
        note
        for name, check in CHECKS.items()
        if name in wanted and control in _OF_CONTROL.get(check, (control,))
        for note in check(solved)
    )
