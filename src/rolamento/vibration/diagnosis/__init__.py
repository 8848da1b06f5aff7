"""Diagnosis: which parts of a bearing a vibration signal shows to be damaged, and how sure that is.

`diagnose` is the way in. From the outside in: `shaft` (its speed, by its own lines), `verdict` (one
cause before several), `family` (what that explains), `size` (how deep, and what that is worth),
`search` (the least probable match in noise), `hypotheses` (what damage may look like),
`unexplained` (what else stands out), `masks` (lines of the shaft), `band_spectra` (squared
envelopes of many bands over orders), `whitening`, `tones` (discrete lines taken out), `blocks`.
"""

from rolamento.vibration.diagnosis.diagnose import diagnose
from rolamento.vibration.diagnosis.orders import COMPONENTS, Component, FaultOrders
from rolamento.vibration.diagnosis.record import (
    Cause,
    ComponentVerdict,
    Diagnosis,
    EnvelopeSpectra,
    MatchedLine,
    Reason,
    UnexplainedLine,
)
from rolamento.vibration.diagnosis.settings import DiagnosisSettings
from rolamento.vibration.diagnosis.size import DAMAGE, GRADES, SEVERE, Grade

__all__ = [
    "COMPONENTS",
    "DAMAGE",
    "GRADES",
    "SEVERE",
    "Cause",
    "Component",
    "ComponentVerdict",
    "Diagnosis",
    "DiagnosisSettings",
    "EnvelopeSpectra",
    "FaultOrders",
    "Grade",
    "MatchedLine",
    "Reason",
    "UnexplainedLine",
    "diagnose",
]
