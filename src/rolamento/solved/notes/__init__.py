"""Notes on a result, and advice where there is none.

A note never changes a number. Each check reads one solved case and returns notes: limits exceeded,
contacts lost, assumptions strained. A type of bearing brings the names of those that are its own.
Their sentences are in `rolamento.words.sentences.solved`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Final

from rolamento.solved.notes import balls, bearing, rollers
from rolamento.solved.notes.advice import advice_on
from rolamento.solved.notes.balls import jones_verdict, pressure_limit
from rolamento.solved.notes.bearing import (
    SPEED_LIMIT,
    TILT_LIMIT,
    are_rollers,
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
    "are_rollers",
    "jones_verdict",
    "misalignment",
    "notes_on",
    "nothing_given",
    "pressure_limit",
    "usual_misalignments",
]

_OF_ANY: Final = (
    bearing.other_than_said, bearing.lost_rows, bearing.lost_contacts, balls.pressures,
    bearing.speeds, bearing.tilts, bearing.free_directions, bearing.free_tilt,
    bearing.estimated_geometry, bearing.letters, bearing.nearly_lost,
)  # fmt: skip
_OF_ROLLERS: Final = (
    rollers.rollers_unloaded, rollers.line_pressures, rollers.misaligned,
    rollers.on_part_of_the_length, rollers.ends,
)  # fmt: skip
"""Checks of the rollers of a ring, whatever else rolls in it."""
_ORDER: Final = (
    *_OF_ANY[:4], balls.past_edge, balls.shoulders, *_OF_ANY[4:8], balls.control, balls.orbits,
    balls.gyroscopic_slip, balls.gyroscopic_left_out, balls.arches, balls.rolling, *_OF_ANY[8:],
    bearing.radial_load_on_thrust, balls.four_point_load, rollers.axial_load_on_torus,
    *_OF_ROLLERS,
)  # fmt: skip
CHECKS: Final[Mapping[str, Callable[[Solved], Iterator[Note]]]] = {
    check.__name__: check for check in _ORDER
}
"""Every check by its name, in the order of the notes."""


def notes_on(solved: Solved) -> tuple[Note, ...]:
    """The notes on a single case; none without a result."""
    if not solved.converged[0]:
        return ()
    brought = [{*one.notes} for one in solved.case.bearing.row_types]
    wanted = set.intersection(*brought) | {check.__name__ for check in _OF_ANY}
    if solved.rollers is not None:
        wanted |= {check.__name__ for check in _OF_ROLLERS}
    return tuple(note for name, check in CHECKS.items() if name in wanted for note in check(solved))
