"""What a diagnosis may be told: how sure to be, and how far the bearing may be off its orders."""

from __future__ import annotations

from dataclasses import dataclass

from rolamento.errors import InputError
from rolamento.vibration._checks import checked_number

__all__ = ["DiagnosisSettings"]


@dataclass(frozen=True, slots=True)
class DiagnosisSettings:
    """Settings of a diagnosis.

    Attributes
    ----------
    false_alarm
        probability that noise without lines of the bearing gives any finding; what a finding is
        worth is decided by its size
    tolerance
        part by which the cage may turn faster or slower than its nominal order: slip, and a
        contact angle that is not quite known
    speed_tolerance
        part by which a speed that was given as one number may be wrong: all lines move alike, and
        the shaft's own lines tell by how much; 0 if it is certain
    speed_uncertainty
        part by which a speed that is known may still be off or wander
    block_revolutions
        revolutions of the shaft of which one spectrum is made; longer records are averaged
    remove_tones
        whether to take out discrete lines first, as of gears and electric fields; a bearing's own
        blows slip, and make none

    Raises
    ------
    InputError
        If a number is out of range.
    """

    false_alarm: float = 0.01
    tolerance: float = 0.02
    speed_tolerance: float = 0.03
    speed_uncertainty: float = 0.001
    block_revolutions: float = 400.0
    remove_tones: bool = True

    def __post_init__(self) -> None:
        checked_number(
            self.false_alarm, "false_alarm", above=0.0, most=0.5, example="false_alarm = 0.01"
        )
        checked_number(self.tolerance, "tolerance", least=0.0, most=0.1, example="tolerance = 0.02")
        checked_number(
            self.speed_tolerance,
            "speed_tolerance",
            least=0.0,
            most=0.1,
            example="speed_tolerance = 0.03",
        )
        checked_number(
            self.speed_uncertainty,
            "speed_uncertainty",
            least=0.0,
            most=0.02,
            example="speed_uncertainty = 0.001",
        )
        checked_number(
            self.block_revolutions,
            "block_revolutions",
            least=50.0,
            most=5000.0,
            example="block_revolutions = 400",
        )
        if not isinstance(self.remove_tones, bool):
            raise InputError("must be true or false", field="remove_tones", value=self.remove_tones)
