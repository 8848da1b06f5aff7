"""Grease: how long it lives, when a bearing wants new one, how much, and which.

A file a law: lives of sealed ball bearings by `nsk`, `kawamura` and `jtekt`, intervals in
`relubrication`, amounts in `amount`. `rolamento.grease.of_case` asks all of them of a case.

>>> from rolamento import grease
>>> print(f"{grease.grease_life_nsk(0.25, 343.15, 'wide_range'):.0f} h")
41210 h
"""

from rolamento.grease.amount import fag_amount, skf_amount
from rolamento.grease.estimate import GreaseDuty, GreaseLife, GreaseModel, l10_of_mean
from rolamento.grease.jtekt import grease_life_jtekt
from rolamento.grease.kawamura import grease_life_kawamura
from rolamento.grease.models import MODELS
from rolamento.grease.nsk import grease_life_nsk
from rolamento.grease.relubrication import (
    Interval,
    base_interval,
    fag_interval,
    noria_interval,
    skf_interval,
)

__all__ = [
    "MODELS",
    "GreaseDuty",
    "GreaseLife",
    "GreaseModel",
    "Interval",
    "base_interval",
    "fag_amount",
    "fag_interval",
    "grease_life_jtekt",
    "grease_life_kawamura",
    "grease_life_nsk",
    "l10_of_mean",
    "noria_interval",
    "skf_amount",
    "skf_interval",
]
