"""Use cases from end to end, for the command line, a notebook or a web page: a record each.

>>> from rolamento import tasks
>>> found = tasks.diagnose("signal.npz", "6205", speed="1797 rpm")  # doctest: +SKIP
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    from rolamento.tasks.demonstration import example_case, write_example
    from rolamento.tasks.diagnosis import DiagnosisResult, TooShort, diagnose
    from rolamento.tasks.drawing import Drawing, Kind, draw
    from rolamento.tasks.frequencies import FrequencyResult, fault_frequencies
    from rolamento.tasks.noise import FullScale, NoiseResult, anderons
    from rolamento.tasks.studies import Sweep, sweep, tolerance
    from rolamento.tasks.synthesis import SynthesisResult, Unsolved, synthesise

__all__ = [
    "DiagnosisResult",
    "Drawing",
    "FrequencyResult",
    "FullScale",
    "Kind",
    "NoiseResult",
    "Sweep",
    "SynthesisResult",
    "TooShort",
    "Unsolved",
    "anderons",
    "diagnose",
    "draw",
    "example_case",
    "fault_frequencies",
    "sweep",
    "synthesise",
    "tolerance",
    "write_example",
]

_MODULES: Final = (
    "frequencies", "diagnosis", "synthesis", "noise", "studies", "drawing", "demonstration",
)  # fmt: skip


def __getattr__(name: str) -> Any:
    for part in _MODULES if name in __all__ else ():
        module = importlib.import_module(f"{__name__}.{part}")
        if hasattr(module, name):
            return getattr(module, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted(__all__)
