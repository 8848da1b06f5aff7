"""What a vibration record says, whatever is known: a bearing, a machine, its past, or nothing."""

from __future__ import annotations

import os
from typing import Annotated, Any, ClassVar, Final, Self

from pydantic import model_validator

from rolamento.errors import InputError, arguments, phrase
from rolamento.tasks.diagnosis import DiagnosisResult, UnknownResult, diagnose, rank_bearings
from rolamento.tasks.history import History, Records, diagnose_since, trend_of_records
from rolamento.tasks.machine_diagnosis import MachineDiagnosis, diagnose_machine
from rolamento.tasks.parameters import Progress, quietly
from rolamento.tasks.request import Input, Product
from rolamento.tasks.signals import SIGNAL, SignalRequest
from rolamento.vibration.diagnosis import DiagnosisSettings
from rolamento.words import marked, said

__all__ = ["SEARCH", "VibrationDiagnosis"]

BEARING: Final = marked("Bearing")
SPEED: Final = marked("Speed")
SEARCH: Final = marked("Search")
UNKNOWN: Final = "unknown"
"""In the place of a bearing: that nobody knows which it is."""


class VibrationDiagnosis(SignalRequest):
    """Diagnose damaged parts of a bearing from a vibration signal.

    How severe, why, and what speaks against it. A long signal is read block by block, in
    bounded memory.

    Parameters
    ----------
    signal
        Signal file: WAV, CSV, NumPy, MATLAB, HDF5, Parquet or UFF 58; or a folder of many,
        followed by their names.
    bearing
        Designation such as 6205, or a case file; for a case with a load, the frequencies of
        the loaded bearing are searched. 'unknown' ranks the bearings of the catalogue.
    machine
        File of a machine with several bearings, shafts and gears, instead of `bearing`: all
        are tested together.
    baseline
        Record of the machine in good order, or a folder of them. Damage is what has
        doubled since.
    nominal
        Search the frequencies of the geometry, whatever the load.
    angle
        Contact angle without a load: zero (radial load, the default) or free (axial load)
        of a bearing given by its clearance; or any angle, such as '15 deg'.
    speed
        Steady speed of the inner ring, such as '1797 rpm'; by default that of the file, or
        else of the case.
    outer_speed
        Speed of the outer ring, with its sign.
    speed_channel
        Channel of the same file with the shaft speed at each sample, by name or number.
    speed_unit
        Unit of that channel: rpm, rad/s, deg/s or Hz, if the file gives none.
    tacho
        Channel of the same file with tachometer pulses of the shaft; held in memory, up to
        20 million samples.
    pulses
        Tachometer pulses per revolution (default 1).
    track
        Track the speed in the vibration itself, around `speed`; at least 96 revolutions.
    within
        Maximum deviation of a tracked speed from the one given, up to 30 % (default 10 %).
    tolerance
        Maximum deviation of the cage from its expected speed, 0 to 0.1.
    speed_tolerance
        Uncertainty of a steady speed, such as '3 %', up to 10 %; 0 if it is exact. It is
        corrected by the peaks of the shaft itself.
    false_alarm
        Probability that noise without peaks of the bearing gives any finding, up to 0.5.
    """

    signal: Annotated[Any, Input("Signal", "file", essential=True, metavar="SIGNAL")]
    bearing: Annotated[
        Any,
        Input(
            BEARING,
            "bearing",
            BEARING,
            example="6205",
            on_page=marked(
                "Designation; left empty, the bearing and the load of the case on the page."
            ),
            essential=True,
        ),
    ] = None
    machine: Annotated[
        Any, Input("Machine", "path", BEARING, example="machine.toml", metavar="FILE")
    ] = None
    baseline: Annotated[
        Any, Input("Records in good order", "paths", BEARING, example="good.wav", metavar="PATH")
    ] = ()
    changes: Any = ()
    nominal: Annotated[bool, Input("Without the load", "switch", BEARING)] = False
    angle: Annotated[
        float | str | None, Input("Contact angle", group=BEARING, example="15 deg")
    ] = None
    speed: Annotated[
        float | None,
        Input(
            "Shaft speed",
            "quantity",
            SPEED,
            example="1797 rpm",
            dimension="angular_speed",
            essential=True,
        ),
    ] = None
    outer_speed: Annotated[
        float | None,
        Input(
            "Speed of the outer ring",
            "quantity",
            SPEED,
            example="0 rpm",
            dimension="angular_speed",
            metavar="SPEED",
        ),
    ] = None
    speed_channel: Annotated[
        str | int | None, Input("Channel of the speed", group=SPEED, example="2", metavar="CHANNEL")
    ] = None
    speed_unit: Annotated[
        str | None,
        Input(
            "Unit of that channel",
            "choice",
            SPEED,
            example="rpm",
            choices=lambda: {"rpm": "", "rad/s": "", "deg/s": "", "Hz": ""},
            metavar="UNIT",
        ),
    ] = None
    tacho: Annotated[
        str | int | None,
        Input("Channel of the tachometer", group=SPEED, example="2", metavar="CHANNEL"),
    ] = None
    pulses: Annotated[int | None, Input("Pulses per revolution", "count", SPEED, example="1")] = (
        None
    )
    track: Annotated[
        bool,
        Input(
            "Track the speed",
            "switch",
            SPEED,
            on_page=marked(
                "Find the varying speed in the vibration itself, around the shaft speed given"
                " above; at least 96 revolutions."
            ),
        ),
    ] = False
    within: Annotated[
        float | None, Input("Greatest deviation of the speed", "fraction", SPEED, example="10 %")
    ] = None
    tolerance: Annotated[
        float,
        Input(
            "Slip of the cage", "fraction", SEARCH, example="2 %", default="2 %", option="--slip"
        ),
    ] = 0.02
    speed_tolerance: Annotated[
        float, Input("Uncertainty of the speed", "fraction", SEARCH, example="3 %", default="3 %")
    ] = 0.03
    false_alarm: Annotated[
        float, Input("False alarms", "fraction", SEARCH, example="1 %", default="1 %", metavar="P")
    ] = 0.01

    examples: ClassVar = (
        "Examples: diagnose signal.wav --bearing 6205 --speed '1797 rpm' --plot signal.png; "
        "diagnose run.npz --bearing case.toml --speed-channel rpm."
    )
    waiting: ClassVar = marked("blocks of the signal")
    headings: ClassVar = (BEARING, SPEED, SIGNAL, SEARCH)
    takes_case: ClassVar = True

    @model_validator(mode="after")
    def _goes_together(self) -> Self:
        """Refuse what does not: a machine, a bearing, a folder and a history."""
        folder = isinstance(self.signal, str | os.PathLike) and os.path.isdir(self.signal)
        if not self.bearing and self.machine is None:
            raise InputError(said("must be given"), field="bearing")
        if self.bearing and self.machine is not None:
            leave = marked("names the bearings: leave {option} out")
            rule: str = phrase(leave, option=arguments(bearing=...))
            raise InputError(rule, field="machine")
        if self.baseline and (self.machine is not None or self._is_unknown or folder):
            raise InputError(said("goes with one record and one bearing"), field="baseline")
        if folder and (self.machine is not None or self._is_unknown):
            rule = said("must be one record here")
            raise InputError(rule, field="signal", value=self.signal, example="now.wav")
        return self

    @property
    def _is_unknown(self) -> bool:
        return isinstance(self.bearing, str) and self.bearing == UNKNOWN

    @property
    def search(self) -> DiagnosisSettings:
        """How to look, and how sure to be."""
        return DiagnosisSettings(
            false_alarm=self.false_alarm,
            tolerance=self.tolerance,
            speed_tolerance=self.speed_tolerance,
        )

    def run(
        self, progress: Progress = quietly
    ) -> DiagnosisResult | UnknownResult | MachineDiagnosis | History | Records:
        """Diagnose.

        Raises
        ------
        FileError, InputError
            If a file cannot be read, or what is given contradicts itself or does not suffice.
        """
        part: dict[str, Any] = {
            "start": self.start, "duration": self.duration, "search": self.search, **self.reading,
        }  # fmt: skip
        if self._is_unknown:
            return rank_bearings(self.signal, speed=self.speed, **part)
        asked: dict[str, Any] = {
            name: getattr(self, name)
            for name in (
                "speed", "outer_speed", "speed_channel", "speed_unit", "tacho", "pulses", "track",
                "within", "nominal", "angle", "changes",
            )
        } | {**part, "progress": progress}  # fmt: skip
        if self.machine is not None:
            return diagnose_machine(self.signal, self.machine, **asked)
        if isinstance(self.signal, str | os.PathLike) and os.path.isdir(self.signal):
            return trend_of_records([self.signal], self.bearing, **asked)
        if self.baseline:
            since = diagnose_since(self.signal, self.bearing, self.baseline, **asked)
            return since if since.now.too_short is None else since.now
        return diagnose(self.signal, self.bearing, **asked)

    products: ClassVar = {
        "plot": Product(
            marked("Draw waveform, kurtogram and envelope spectrum: a .png, .svg or .pdf file."),
            lambda asked, found: _drawn(found, "plot").picture(),
        ),
        "kurtogram": Product(
            marked("Draw the kurtogram alone, likewise."),
            lambda asked, found: _drawn(found, "kurtogram").kurtogram(),
        ),
    }


def _drawn(found: Any, option: str) -> DiagnosisResult:
    """Refuse to draw several records, or several bearings, which a report draws."""
    if not isinstance(found, DiagnosisResult):
        rule = said("goes with one record; `report` draws the others")
        raise InputError(rule, field=option, example="--report page.pdf")
    return found
