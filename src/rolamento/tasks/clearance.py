"""What a mounting leaves: the clearance of a bearing, and the preload of a set, step by step."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from rolamento.case import Case
from rolamento.clearance import (
    OperatingClearance,
    clearance_notes,
    clearance_of_case,
    sample_clearance,
)
from rolamento.errors import InputError
from rolamento.io.json import plain
from rolamento.records import frozen
from rolamento.solved import PreloadStage
from rolamento.words import Note, said

if TYPE_CHECKING:
    from rolamento.clearance import ClearanceSamples

__all__ = ["Mounted", "mounted_clearance", "mounted_samples"]


@frozen
class Mounted:
    """The clearance in operation of a bearing or of the rows of a set, and the set's preload.

    Attributes
    ----------
    rows
        of a single bearing one; of a set one for each row that differs from those before it
    stages
        of the preload of a set whose rows face each other; empty of any other bearing
    notes
        what to know about it
    of_set
        whether the bearing is a set
    """

    rows: tuple[OperatingClearance, ...]
    stages: tuple[PreloadStage, ...]
    notes: tuple[Note, ...]
    of_set: bool

    def to_mapping(self) -> dict[str, Any]:
        """Give everything as plain mappings and lists, SI; of a set its rows and stages too."""
        mapping = self.rows[0].to_mapping()
        if not self.of_set:
            return mapping
        mapping["rows"] = [row.to_mapping() for row in self.rows]
        mapping["preload"] = [plain(asdict(stage)) for stage in self.stages]
        mapping["notes"] = [note.to_mapping() for note in self.notes]
        return mapping


def mounted_clearance(case: Case) -> Mounted:
    """The clearance in operation of a case with a mounting, and what becomes of a set's preload.

    Raises
    ------
    InputError
        As `clearance_of_case`.
    """
    if case.mounting is None or case.bearing.is_one_bearing:
        found = clearance_of_case(case)
        return Mounted((found,), (), _notes_on(found), of_set=False)
    from rolamento.system.mounted import clearances_of_set, notes_on_set, preload_stages

    rows = clearances_of_set(case)
    stages = preload_stages(case)
    return Mounted(rows, stages, notes_on_set(case, stages), of_set=True)


def _notes_on(found: OperatingClearance) -> tuple[Note, ...]:
    """What its page says; the sum of the steps is there already, unless it is no clearance."""
    return clearance_notes(found) if found.bearing.bearing_type.conical else found.warnings


def mounted_samples(case: Case, samples: int, seed: int) -> ClearanceSamples:
    """Clearances of bearings drawn from the tolerances of a case that has a mounting.

    Of a set those of any one of its rows.

    Raises
    ------
    InputError
        As `sample_clearance`, and for a set whose rows differ.
    """
    assert case.mounting is not None
    bearings = {place.bearing for place in case.bearing.places}
    if len(bearings) > 1:
        raise InputError(
            said("is for sets of equal rows: these differ"), field="samples", value=samples
        )
    return sample_clearance(
        bearings.pop(),
        case.mounting,
        case.temperature,
        inner_speed=case.duty.inner_speed,
        outer_speed=case.duty.outer_speed,
        samples=samples,
        seed=seed,
    )
