"""Electric currents: at work from the published band of fluting on, open between the bands."""

from __future__ import annotations

from math import inf, isfinite, nan
from typing import TYPE_CHECKING, Final

from rolamento.electrical import electrics_of, has_electrics
from rolamento.tasks.endings.ending import Ending, EndingLaw

if TYPE_CHECKING:
    from rolamento.analysis import Analysis

__all__ = ["LAW"]


def _evaluate(found: Analysis) -> Ending | None:
    given = found.solved.case.electrical
    if given is None or given.current is None or not has_electrics(found.solved):
        return None
    electrics = electrics_of(found.solved, found.film)
    density = float(electrics.current_density[0])
    bands = {band.key: band for band in electrics.density}
    if not isfinite(density):
        return None
    if density <= bands["harmless"].high:
        return Ending("currents", inf, inf, inf, basis="below_bands")
    acting = density >= bands["fluting"].low
    return Ending("currents", nan, basis="untimed", acting=acting, notes=electrics.notes)


LAW: Final = EndingLaw("currents", _evaluate)
