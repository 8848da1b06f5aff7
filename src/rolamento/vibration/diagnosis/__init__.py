"""Diagnosis: which parts of a bearing a vibration signal shows to be damaged, and how sure that is.

`diagnose` is the way in. From the outside in: `shaft` (its speed, by its own lines), `verdict` (one
cause before several), `size` (how deep, and what that is worth), `field` (what is searched, what a
fault explains, what nothing does), `search` (what damage may look like, the least probable match
in noise), `band_spectra` (squared envelopes of many bands over orders), `whitening`, `blocks`.
"""

from rolamento.vibration.diagnosis.record import (
    Cause,
    ComponentVerdict,
    Diagnosis,
    EnvelopeSpectra,
    MatchedLine,
    UnexplainedLine,
)
from rolamento.vibration.diagnosis.settings import (
    COMPONENTS,
    Component,
    DiagnosisSettings,
    FaultOrders,
)
from rolamento.vibration.diagnosis.size import DAMAGE, GRADES, SEVERE, SMOOTH, Grade
from rolamento.vibration.diagnosis.verdict import diagnose

__all__ = [
    "COMPONENTS",
    "DAMAGE",
    "GRADES",
    "SEVERE",
    "SMOOTH",
    "Cause",
    "Component",
    "ComponentVerdict",
    "Diagnosis",
    "DiagnosisSettings",
    "EnvelopeSpectra",
    "FaultOrders",
    "Grade",
    "MatchedLine",
    "UnexplainedLine",
    "diagnose",
]
