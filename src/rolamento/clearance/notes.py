"""What the user should know of the clearance that a case was solved with."""

from __future__ import annotations

from rolamento.clearance.record import WARNINGS, OperatingClearance
from rolamento.clearance.tables import MICROMETRE

__all__ = ["clearance_notes"]


def clearance_notes(found: OperatingClearance) -> tuple[str, ...]:
    """The clearance in operation and its warnings, in sentences."""
    low, mean, high = (
        f"{value / MICROMETRE:.1f}" for value in (found.minimum, found.mean, found.maximum)
    )
    told = (
        f"Mounted, at its temperatures and speeds, the bearing has a diametral clearance of {mean}"
        f" µm, between {low} and {high} µm with all tolerances at their worst."
    )
    return (told, *(WARNINGS[name] for name in found.warnings))
