"""Lives of bearings in the field that failed by two modes, drawn: what the guides show of modes."""

from __future__ import annotations

import numpy as np

from rolamento.weibull import LifeTest

SEED = 92


def field_data() -> LifeTest:
    """Forty bearings in the field: mounting damage (β 0.8) and fatigue (β 3.2), drawn."""
    random = np.random.default_rng(SEED)
    mounting = 60_000.0 * random.weibull(0.8, 40)
    fatigue = 22_000.0 * random.weibull(3.2, 40)
    end = random.uniform(3000.0, 30_000.0, 40)
    times = np.minimum(np.minimum(mounting, fatigue), end)
    modes = np.where(times == end, "", np.where(times == mounting, "mounting", "fatigue"))
    return LifeTest(np.round(times), modes != "", mode=modes)


def as_table(test: LifeTest) -> str:
    rows = zip(test.times, test.failed, test.mode, strict=True)
    lines = [
        f"P{i};{time:.0f};{'falhou' if failed else 'em operação'};{mode}"
        for i, (time, failed, mode) in enumerate(rows)
    ]
    return "\n".join(["TAG;Horas de operação;Situação;Modo de falha", *lines, ""])
