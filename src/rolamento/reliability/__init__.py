"""Life tests and Weibull's distribution: fits, bounds, comparisons, bearings in series."""
