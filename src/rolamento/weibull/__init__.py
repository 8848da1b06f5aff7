"""Life tests and Weibull's distribution: fits, bounds, comparisons, plans, bearings in series.

A `LifeTest` holds the data, `read_life_test` reads them; times alone will do where all bearings
failed. `maximum_likelihood` and other fits give a `WeibullFit`, `bounds` and `all_bounds` limits by
several methods, `compare`, `life_ratio` and `against_calculated_life` tests; `summarise` all of it.
`demonstrate` and `plan_for_ratio` plan a test, `series_life` puts bearings together.
`remaining_life`, `age_replacement` and `fleet_forecast` decide by a `LifeDistribution`. Every
record has a status; what does not exist is NaN. See docs/theory/weibull.md.
"""

from __future__ import annotations

from rolamento.weibull.bounds import (
    METHODS,
    Band,
    Bounds,
    Method,
    Sides,
    all_bounds,
    bounds,
    confidence_band,
)
from rolamento.weibull.comparison import (
    CalculatedLife,
    Comparison,
    Contradiction,
    Hypothesis,
    LifeRatio,
    against_calculated_life,
    compare,
    life_ratio,
)
from rolamento.weibull.distribution import Interval, LifeDistribution
from rolamento.weibull.estimates import (
    PlottingPositions,
    Ranks,
    Regression,
    fixed_shape,
    maximum_likelihood,
    median_rank,
    plotting_positions,
    rank_regression,
    three_parameter,
)
from rolamento.weibull.fit import Estimand, WeibullFit, plot_ordinate
from rolamento.weibull.fleet import Fleet, FleetForecast, fleet_forecast
from rolamento.weibull.fleet_table import FleetTable, read_fleet
from rolamento.weibull.goodness import DogLeg, GoodnessOfFit, goodness_of_fit
from rolamento.weibull.life_test import LifeTest, Scheme
from rolamento.weibull.likelihood_ratio import LikelihoodRegion, likelihood_region
from rolamento.weibull.models import MODELS, LifeModel, life_models
from rolamento.weibull.modes import ModeResult, ModeSystem, system_of_modes
from rolamento.weibull.planning import Demonstration, alternatives, demonstrate
from rolamento.weibull.posterior import Posterior, ShapePrior, posterior
from rolamento.weibull.precision import (
    FailureTime,
    LifeTestPlan,
    failure_time,
    mean_failure_times,
    plan_for_ratio,
    plan_of,
    plans_for_ratio,
)
from rolamento.weibull.reading import (
    PUBLISHED,
    parse_life_test,
    published_life_test,
    published_text,
    read_life_test,
)
from rolamento.weibull.replacement import AgeReplacement, age_replacement
from rolamento.weibull.residual import RemainingLife, remaining_life
from rolamento.weibull.sampled import Correction, Draws, pivotal_draws, unbiased
from rolamento.weibull.summary import (
    FIT_METHODS,
    FitMethod,
    GroupSummary,
    LifeTestRequest,
    LifeTestSummary,
    bands_of,
    fit_by,
    regions_of,
    summarise,
)
from rolamento.weibull.system import (
    EXPONENTS,
    series_life,
    series_reliability,
    system_rating_life,
)
from rolamento.weibull.trend import (
    PUBLISHED_TRENDS,
    Trend,
    parse_trend,
    published_trend,
    published_trend_text,
    read_trend,
    wear_of_each,
)

__all__ = [
    "EXPONENTS",
    "FIT_METHODS",
    "METHODS",
    "MODELS",
    "PUBLISHED",
    "PUBLISHED_TRENDS",
    "AgeReplacement",
    "Band",
    "Bounds",
    "CalculatedLife",
    "Comparison",
    "Contradiction",
    "Correction",
    "Demonstration",
    "DogLeg",
    "Draws",
    "Estimand",
    "FailureTime",
    "FitMethod",
    "Fleet",
    "FleetForecast",
    "FleetTable",
    "GoodnessOfFit",
    "GroupSummary",
    "Hypothesis",
    "Interval",
    "LifeDistribution",
    "LifeModel",
    "LifeRatio",
    "LifeTest",
    "LifeTestPlan",
    "LifeTestRequest",
    "LifeTestSummary",
    "LikelihoodRegion",
    "Method",
    "ModeResult",
    "ModeSystem",
    "PlottingPositions",
    "Posterior",
    "Ranks",
    "Regression",
    "RemainingLife",
    "Scheme",
    "ShapePrior",
    "Sides",
    "Trend",
    "WeibullFit",
    "against_calculated_life",
    "age_replacement",
    "all_bounds",
    "alternatives",
    "bands_of",
    "bounds",
    "compare",
    "confidence_band",
    "demonstrate",
    "failure_time",
    "fit_by",
    "fixed_shape",
    "fleet_forecast",
    "goodness_of_fit",
    "life_models",
    "life_ratio",
    "likelihood_region",
    "maximum_likelihood",
    "mean_failure_times",
    "median_rank",
    "parse_life_test",
    "parse_trend",
    "pivotal_draws",
    "plan_for_ratio",
    "plan_of",
    "plans_for_ratio",
    "plot_ordinate",
    "plotting_positions",
    "posterior",
    "published_life_test",
    "published_text",
    "published_trend",
    "published_trend_text",
    "rank_regression",
    "read_fleet",
    "read_life_test",
    "read_trend",
    "regions_of",
    "remaining_life",
    "series_life",
    "series_reliability",
    "summarise",
    "system_of_modes",
    "system_rating_life",
    "three_parameter",
    "unbiased",
    "wear_of_each",
]
