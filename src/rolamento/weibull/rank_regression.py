"""Straight line through the Weibull plot, by least squares.

ln ln 1/(1 - F) = β ln t - β ln η. Either the ordinate is regressed on ln t ("Y on X") or ln t on
the ordinate ("X on Y"), which makes the line steeper by 1/correlation².
Of suspensions only the order counts, not how long they ran.

Sources: Abernethy (2006), chapter 2; IEC 61649:2008.
"""

from __future__ import annotations

from typing import Literal

import numpy as np

from rolamento.weibull._checks import one_of
from rolamento.weibull.fit import WeibullFit
from rolamento.weibull.life_test import LifeTest
from rolamento.weibull.maximum_likelihood import found, too_few
from rolamento.weibull.ranks import Ranks, plotting_positions

__all__ = ["Regression", "rank_regression"]

Regression = Literal["x_on_y", "y_on_x"]


def rank_regression(
    test: LifeTest, regression: Regression = "x_on_y", ranks: Ranks = "median"
) -> WeibullFit:
    """Fit shape and scale by rank regression.

    Parameters
    ----------
    test
        Complete or right-censored.
    regression
        "x_on_y": distances along the times are least, as IEC 61649 has it. "y_on_x": along the
        ordinate, as a spreadsheet does it.
    ranks
        "median" or "benard".

    Returns
    -------
    WeibullFit
        Without numbers for fewer than two different times of failure.

    Raises
    ------
    InputError
        For an inspected test.
    """
    one_of(regression, "regression", ("x_on_y", "y_on_x"))
    points = plotting_positions(test, ranks)
    method = f"rank_regression_{regression}"
    code = too_few(test)
    x, y = points.x, points.y
    if not code and np.ptp(x) <= 1e-12 * max(1.0, float(np.abs(x).max())):
        code = "no_spread"
    if code:
        return WeibullFit.without(test, method, code)
    dx, dy = x - x.mean(), y - y.mean()
    xx, xy, yy = float(dx @ dx), float(dx @ dy), float(dy @ dy)
    shape = xy / xx if regression == "y_on_x" else yy / xy
    scale = float(np.exp(x.mean() - y.mean() / shape))
    fit = found(test, method, shape, scale, correlation=xy / (xx * yy) ** 0.5)
    return fit.with_notes("suspensions_early") if _early(test) else fit


def _early(test: LifeTest) -> bool:
    """Tell whether most suspensions come before the first failure."""
    early = ~test.failed & (test.times < test.times[test.failed].min())
    return 2 * int(test.counts[early].sum()) > test.suspensions > 0
