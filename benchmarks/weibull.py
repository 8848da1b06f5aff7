"""Ten thousand Weibull fits of a censored sample, beside the same in a loop of others.

A sample of 30 bearings, some of them suspended, is drawn with replacement and fitted by maximum
likelihood 10 000 times, and 10 000 tests are drawn at the fit for pivotal bounds; one thread. SciPy
(`weibull_min.fit` on `CensoredData`) and SurPyval fit a few of the same resamples, one at a time.
"""

from __future__ import annotations

import time
import warnings
from collections.abc import Callable
from typing import Final

import numpy as np

from benchmarks.figures import Figure, Findings, at_least, below, seconds
from rolamento.weibull import LifeTest, bounds
from rolamento.weibull.likelihood import Rows, fit_rows

SIZE: Final = 30
FITS: Final = 10_000
SECONDS: Final = 1.0
AGREEMENT: Final = 1e-3
GROUP: Final = "Weibull fits"

Pair = tuple[float, float]
Floats = np.ndarray


def sample() -> LifeTest:
    """Thirty bearings, each with its own time of withdrawal."""
    random = np.random.default_rng(2)
    times, ends = 1000.0 * random.weibull(1.5, SIZE), 1000.0 * random.uniform(0.3, 2.0, SIZE)
    return LifeTest(np.minimum(times, ends), times <= ends)


def measure(fits: int = FITS, few: int = 20, repeats: int = 3) -> Findings:
    """Take the times; the fits of all have to agree."""
    test = sample()
    counts = np.random.default_rng(3).multinomial(SIZE, np.full(SIZE, 1.0 / SIZE), size=fits)
    counts = counts.astype(np.float64)
    log_time = np.broadcast_to(np.log(test.times), counts.shape)

    def batch() -> object:
        return fit_rows(Rows(log_time, counts * test.failed, counts))

    ours = fit_rows(Rows(log_time, counts * test.failed, counts))
    taken = seconds(batch, repeats)
    pivotal = seconds(lambda: bounds(test, "L10", samples=max(fits, 100)), repeats)
    target = below(SECONDS) if fits >= FITS else None
    figures = [
        Figure(GROUP, f"{fits} bootstrap fits of {SIZE} bearings", taken, "s", target),
        Figure(GROUP, f"pivotal bounds of L10, {fits} drawn tests", pivotal, "s", target),
        Figure(GROUP, "rate", fits / taken, "fits/s"),
    ]
    failures: list[str] = []
    remarks: list[str] = []
    if np.any(ours.code != 0):
        failures.append(f"Weibull: {np.count_nonzero(ours.code)} fits without a result")
    for name, fit in (("SciPy", _scipy), ("SurPyval", _surpyval())):
        if fit is None:
            remarks.append(f"{name} is not installed: no comparison with it.")
        elif few:
            begin = time.perf_counter()
            theirs = np.array([fit(test, row.astype(int)) for row in counts[:few]])
            rate = few / (time.perf_counter() - begin)
            figures += [
                Figure(GROUP, f"{name}, one at a time", rate, "fits/s"),
                Figure(GROUP, "  the batch is faster by", fits / taken / rate, "times",
                       at_least(100.0)),
            ]  # fmt: skip
            own = np.column_stack([ours.shape, np.exp(ours.log_scale[0])])[:few]
            worst = float(np.max(np.abs(theirs / own - 1.0)))
            if worst > AGREEMENT:
                failures.append(f"Weibull: {name} differs by up to {worst:.1e}")
    return Findings(figures, remarks, failures)


def _scipy(test: LifeTest, counts: Floats) -> Pair:
    from scipy import stats

    times, failed = np.repeat(test.times, counts), np.repeat(test.failed, counts)
    data = stats.CensoredData.right_censored(times, ~failed)
    shape, _, scale = stats.weibull_min.fit(data, floc=0.0)
    return float(shape), float(scale)


def _surpyval() -> Callable[[LifeTest, Floats], Pair] | None:
    """Return SurPyval's fit, if it is installed."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            import surpyval
        except ImportError:
            return None

    def fit(test: LifeTest, counts: Floats) -> Pair:
        drawn = counts > 0
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            model = surpyval.Weibull.fit(
                x=test.times[drawn], c=(~test.failed[drawn]).astype(int), n=counts[drawn]
            )
        return float(model.params[1]), float(model.params[0])

    return fit


if __name__ == "__main__":
    found = measure()
    for figure in found.figures:
        print(f"{figure.name}: {figure.value:.3g} {figure.unit}")
    for line in found.remarks + found.failures:
        print(line)
