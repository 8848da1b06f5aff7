"""All that may end a bearing, in the order of tables; a new ending is named here.

An ending is found by a function of an `Analysis` that returns an `Ending`, or None where it does
not apply. Its name is worded in `rolamento.words.sentences.service_life`.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from rolamento.tasks.endings import currents, fatigue, grease, oscillation, overload, wear
from rolamento.tasks.endings.ending import EndingLaw

__all__ = ["ENDINGS"]

ENDINGS: Final[Mapping[str, EndingLaw]] = {
    law.name: law
    for law in (
        fatigue.LAW,
        oscillation.LAW,
        oscillation.FRETTING,
        grease.LAW,
        grease.RENEWAL,
        wear.LAW,
        currents.LAW,
        overload.LAW,
    )
}
"""By name."""
