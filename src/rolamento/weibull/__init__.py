"""Life tests and Weibull's distribution: fits, bounds, comparisons, bearings in series.

A `LifeTest` holds the data. Fits give a `WeibullFit`, `bounds` and `all_bounds` limits by several
methods, `compare`, `life_ratio` and `against_calculated_life` tests; `series_life` puts bearings
together. Every record has a status; what does not exist is NaN. See docs/theory/weibull.md.
"""

from __future__ import annotations

from rolamento.weibull.bounds import METHODS, Bounds, Method, Sides, all_bounds, bounds
from rolamento.weibull.calculated import CalculatedLife, Verdict, against_calculated_life
from rolamento.weibull.comparison import Comparison, Hypothesis, compare
from rolamento.weibull.fit import ADVICE, NOTES, WeibullFit
from rolamento.weibull.fixed_shape import fixed_shape
from rolamento.weibull.life_ratio import LifeRatio, life_ratio
from rolamento.weibull.life_test import LifeTest, Scheme
from rolamento.weibull.maximum_likelihood import maximum_likelihood
from rolamento.weibull.posterior import Posterior, ShapePrior, posterior
from rolamento.weibull.published import PUBLISHED, published_life_test, published_text
from rolamento.weibull.quantity import Quantity
from rolamento.weibull.rank_regression import Regression, rank_regression
from rolamento.weibull.ranks import PlottingPositions, Ranks, median_rank, plotting_positions
from rolamento.weibull.reading import parse_life_test, read_life_test
from rolamento.weibull.sampled import Draws, pivotal_draws
from rolamento.weibull.system import (
    EXPONENTS,
    series_life,
    series_reliability,
    system_rating_life,
)
from rolamento.weibull.three_parameter import three_parameter
from rolamento.weibull.unbiased import Correction, unbiased

__all__ = [
    "ADVICE",
    "EXPONENTS",
    "METHODS",
    "NOTES",
    "PUBLISHED",
    "Bounds",
    "CalculatedLife",
    "Comparison",
    "Correction",
    "Draws",
    "Hypothesis",
    "LifeRatio",
    "LifeTest",
    "Method",
    "PlottingPositions",
    "Posterior",
    "Quantity",
    "Ranks",
    "Regression",
    "Scheme",
    "ShapePrior",
    "Sides",
    "Verdict",
    "WeibullFit",
    "against_calculated_life",
    "all_bounds",
    "bounds",
    "compare",
    "fixed_shape",
    "life_ratio",
    "maximum_likelihood",
    "median_rank",
    "parse_life_test",
    "pivotal_draws",
    "plotting_positions",
    "posterior",
    "published_life_test",
    "published_text",
    "rank_regression",
    "read_life_test",
    "series_life",
    "series_reliability",
    "system_rating_life",
    "three_parameter",
    "unbiased",
]
