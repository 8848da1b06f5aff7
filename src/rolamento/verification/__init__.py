"""Published numbers beside computed ones, run on request.

`run` goes through the sources: one module and one data file each. What a publication prints is
data; what the program gives for it is computed here, every time; `check` judges.
"""

from rolamento.verification.check import VERDICTS, Check, CheckVerdict
from rolamento.verification.held_out import HeldOut, held_out
from rolamento.verification.registry import (
    Progress,
    Source,
    SourceResult,
    Verification,
    run,
    sources,
)

__all__ = [
    "VERDICTS",
    "Check",
    "CheckVerdict",
    "HeldOut",
    "Progress",
    "Source",
    "SourceResult",
    "Verification",
    "held_out",
    "run",
    "sources",
]
