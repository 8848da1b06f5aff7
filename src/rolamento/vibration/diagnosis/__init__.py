"""Diagnosis: which parts of a bearing a vibration signal shows to be damaged, and how sure that is.

`diagnose` is the way in. From the outside in: `verdict` (the clearest fault first), `search` (the
least probable match in noise), `hypotheses` (what damage may look like), `unexplained` (what else
stands out), `masks` (lines of the shaft), `band_spectra` (squared envelopes of many bands over
orders), `whitening`, `tones` (discrete lines taken out), `blocks`.
"""

from rolamento.vibration.diagnosis.diagnose import diagnose
from rolamento.vibration.diagnosis.orders import COMPONENTS, Component, FaultOrders
from rolamento.vibration.diagnosis.record import (
    ComponentVerdict,
    Diagnosis,
    EnvelopeSpectra,
    MatchedLine,
    Reason,
    UnexplainedLine,
)
from rolamento.vibration.diagnosis.settings import DiagnosisSettings

__all__ = [
    "COMPONENTS",
    "Component",
    "ComponentVerdict",
    "Diagnosis",
    "DiagnosisSettings",
    "EnvelopeSpectra",
    "FaultOrders",
    "MatchedLine",
    "Reason",
    "UnexplainedLine",
    "diagnose",
]
