"""Use cases from end to end, for the command line, a notebook or a web page: a record each.

>>> from rolamento import tasks
>>> found = tasks.diagnose("signal.npz", "6205", speed="1797 rpm")  # doctest: +SKIP
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    from rolamento.tasks.case_request import CaseRequest, Finding
    from rolamento.tasks.catalogue import BearingRequest, CatalogueSearch
    from rolamento.tasks.demonstration import example_case, write_example
    from rolamento.tasks.diagnosis import (
        DiagnosisResult,
        TooShort,
        UnknownResult,
        diagnose,
        rank_bearings,
    )
    from rolamento.tasks.drawing import Drawing, Kind, draw
    from rolamento.tasks.exchange import ExportRequest, ImportRequest, Written
    from rolamento.tasks.frequencies import FrequencyResult, fault_frequencies
    from rolamento.tasks.grease import GreaseCase, choose_oil_of_case, grease_of_case
    from rolamento.tasks.history import History, Records, diagnose_since, trend_of_records
    from rolamento.tasks.inside import (
        ElectricalRequest,
        FrictionRequest,
        HeatRequest,
        ReportRequest,
        SolveRequest,
        StaticRequest,
        TurnRequest,
    )
    from rolamento.tasks.lasting import (
        GreaseRequest,
        LifeRequest,
        OilRequest,
        OscillationRequest,
        ServiceLifeRequest,
    )
    from rolamento.tasks.life import CaseLife, ShaftLife, life_of_case, life_of_shaft
    from rolamento.tasks.life_over import LifeCurve, life_curve
    from rolamento.tasks.life_spectrum import (
        DutyLife,
        SpectrumLife,
        life_of_duty_spectrum,
        read_spectrum,
    )
    from rolamento.tasks.machine_diagnosis import (
        Machine,
        MachineDiagnosis,
        diagnose_machine,
        read_machine,
    )
    from rolamento.tasks.machines import MachineCurve, MachineRequest, ShaftRequest
    from rolamento.tasks.new_case import ExamplesRequest, NewRequest
    from rolamento.tasks.noise import FullScale, NoiseLevel, NoiseResult
    from rolamento.tasks.oscillation import (
        OscillationCase,
        OscillationSpectrum,
        life_in_oscillation,
        life_under_oscillations,
    )
    from rolamento.tasks.recipe import SynthesisRequest
    from rolamento.tasks.replace import (
        FleetRequest,
        FleetStudy,
        RemainingLifeRequest,
        RemainingStudy,
        ReplacementRequest,
        ReplacementStudy,
    )
    from rolamento.tasks.report import CaseReport, Report, calculation_report, compare_variants
    from rolamento.tasks.request import Input, Request
    from rolamento.tasks.rotor import MachineVibration, RotorRequest
    from rolamento.tasks.running import ClearanceRequest, FrequenciesRequest, SpeedRequest
    from rolamento.tasks.seek import Goal, GoalSeek
    from rolamento.tasks.severity import SeverityResult, VibrationSeverity
    from rolamento.tasks.studies import Sweep, sweep, tolerance, tolerance_of_case
    from rolamento.tasks.studying import PlotRequest, SweepRequest, ToleranceRequest
    from rolamento.tasks.synthesis import SynthesisResult, synthesise
    from rolamento.tasks.time_line import ServiceLife, service_life
    from rolamento.tasks.verifying import VerificationRequest
    from rolamento.tasks.vibration_diagnosis import VibrationDiagnosis
    from rolamento.tasks.weibull import (
        DemonstrationStudy,
        DemonstrationTest,
        LifeTestEvaluation,
        PrecisionStudy,
        PrecisionTest,
        TrendEvaluation,
        TrendStudy,
        life_test_study,
    )

_NAMES_OF_MODULES: Final = {
    "verifying": ("VerificationRequest",),
    "new_case": (
        "ExamplesRequest",
        "NewRequest",
    ),
    "catalogue": (
        "BearingRequest",
        "CatalogueSearch",
    ),
    "exchange": (
        "ExportRequest",
        "ImportRequest",
        "Written",
    ),
    "recipe": ("SynthesisRequest",),
    "studying": (
        "PlotRequest",
        "SweepRequest",
        "ToleranceRequest",
    ),
    "case_request": ("CaseRequest", "Finding"),
    "inside": (
        "ElectricalRequest",
        "FrictionRequest",
        "HeatRequest",
        "ReportRequest",
        "SolveRequest",
        "StaticRequest",
        "TurnRequest",
    ),
    "lasting": (
        "GreaseRequest",
        "LifeRequest",
        "OilRequest",
        "OscillationRequest",
        "ServiceLifeRequest",
    ),
    "rotor": ("MachineVibration", "RotorRequest"),
    "running": ("ClearanceRequest", "FrequenciesRequest", "SpeedRequest"),
    "demonstration": ("example_case", "write_example"),
    "diagnosis": ("DiagnosisResult", "TooShort", "UnknownResult", "diagnose", "rank_bearings"),
    "vibration_diagnosis": ("VibrationDiagnosis",),
    "drawing": ("Drawing", "Kind", "draw"),
    "frequencies": ("FrequencyResult", "fault_frequencies"),
    "grease": ("GreaseCase", "choose_oil_of_case", "grease_of_case"),
    "history": ("History", "Records", "diagnose_since", "trend_of_records"),
    "life": ("CaseLife", "ShaftLife", "life_of_case", "life_of_shaft"),
    "life_over": ("LifeCurve", "life_curve"),
    "life_spectrum": ("DutyLife", "SpectrumLife", "life_of_duty_spectrum", "read_spectrum"),
    "machine_diagnosis": ("Machine", "MachineDiagnosis", "diagnose_machine", "read_machine"),
    "machines": ("MachineCurve", "MachineRequest", "ShaftRequest"),
    "noise": ("FullScale", "NoiseLevel", "NoiseResult"),
    "oscillation": (
        "OscillationCase",
        "OscillationSpectrum",
        "life_in_oscillation",
        "life_under_oscillations",
    ),
    "replace": (
        "FleetStudy",
        "RemainingStudy",
        "ReplacementStudy",
        "FleetRequest",
        "RemainingLifeRequest",
        "ReplacementRequest",
    ),
    "report": ("CaseReport", "Report", "compare_variants", "calculation_report"),
    "request": ("Input", "Request"),
    "seek": ("Goal", "GoalSeek"),
    "severity": ("SeverityResult", "VibrationSeverity"),
    "studies": ("Sweep", "sweep", "tolerance", "tolerance_of_case"),
    "synthesis": ("SynthesisResult", "synthesise"),
    "time_line": ("ServiceLife", "service_life"),
    "weibull": (
        "DemonstrationStudy",
        "DemonstrationTest",
        "LifeTestEvaluation",
        "PrecisionStudy",
        "PrecisionTest",
        "TrendEvaluation",
        "TrendStudy",
        "life_test_study",
    ),
}
_MODULE_OF_NAME: Final = {
    name: module for module, names in _NAMES_OF_MODULES.items() for name in names
}

__all__ = [
    "BearingRequest",
    "CaseLife",
    "CaseReport",
    "CaseRequest",
    "CatalogueSearch",
    "ClearanceRequest",
    "DemonstrationStudy",
    "DemonstrationTest",
    "DiagnosisResult",
    "Drawing",
    "DutyLife",
    "ElectricalRequest",
    "ExamplesRequest",
    "ExportRequest",
    "Finding",
    "FleetRequest",
    "FleetStudy",
    "FrequenciesRequest",
    "FrequencyResult",
    "FrictionRequest",
    "FullScale",
    "Goal",
    "GoalSeek",
    "GreaseCase",
    "GreaseRequest",
    "HeatRequest",
    "History",
    "ImportRequest",
    "Input",
    "Kind",
    "LifeCurve",
    "LifeRequest",
    "LifeTestEvaluation",
    "Machine",
    "MachineCurve",
    "MachineDiagnosis",
    "MachineRequest",
    "MachineVibration",
    "NewRequest",
    "NoiseLevel",
    "NoiseResult",
    "OilRequest",
    "OscillationCase",
    "OscillationRequest",
    "OscillationSpectrum",
    "PlotRequest",
    "PrecisionStudy",
    "PrecisionTest",
    "Records",
    "RemainingLifeRequest",
    "RemainingStudy",
    "ReplacementRequest",
    "ReplacementStudy",
    "Report",
    "ReportRequest",
    "Request",
    "RotorRequest",
    "ServiceLife",
    "ServiceLifeRequest",
    "SeverityResult",
    "ShaftLife",
    "ShaftRequest",
    "SolveRequest",
    "SpectrumLife",
    "SpeedRequest",
    "StaticRequest",
    "Sweep",
    "SweepRequest",
    "SynthesisRequest",
    "SynthesisResult",
    "ToleranceRequest",
    "TooShort",
    "TrendEvaluation",
    "TrendStudy",
    "TurnRequest",
    "UnknownResult",
    "VerificationRequest",
    "VibrationDiagnosis",
    "VibrationSeverity",
    "Written",
    "calculation_report",
    "choose_oil_of_case",
    "compare_variants",
    "diagnose",
    "diagnose_machine",
    "diagnose_since",
    "draw",
    "example_case",
    "fault_frequencies",
    "grease_of_case",
    "life_curve",
    "life_in_oscillation",
    "life_of_case",
    "life_of_duty_spectrum",
    "life_of_shaft",
    "life_test_study",
    "life_under_oscillations",
    "rank_bearings",
    "read_machine",
    "read_spectrum",
    "service_life",
    "sweep",
    "synthesise",
    "tolerance",
    "tolerance_of_case",
    "trend_of_records",
    "write_example",
]


def __getattr__(name: str) -> Any:
    module = _MODULE_OF_NAME.get(name)
    if module is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"{__name__}.{module}"), name)


def __dir__() -> list[str]:
    return sorted(__all__)
