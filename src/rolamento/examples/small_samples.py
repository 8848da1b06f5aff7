"""What a life test of six bearings knows of its Weibull shape: 2000 tests, made and fitted.

    python small_samples.py [FOLDER]

All bearings come from one distribution, of shape 1.5. The maximum-likelihood shapes scatter from
below 1 to above 3, and lie too high on average: a single test's β is nearly noise.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from rolamento.charts.style import in_style, new_figure
from rolamento.plots.saving import save_figure
from rolamento.weibull import LifeTest, maximum_likelihood

SHAPE = 1.5


@in_style
def main(folder: Path) -> None:
    """Make and fit the tests, print percentiles of the shape, and write small_samples.png."""
    random = np.random.default_rng(1)
    shapes = []
    for _ in range(2000):
        lives = 100.0 * random.weibull(SHAPE, 6)
        shapes.append(maximum_likelihood(LifeTest(lives, failed=[True] * 6)).shape)
    low, middle, high = np.percentile(shapes, [5, 50, 95])
    print(
        f"true shape {SHAPE}: fitted {low:.2f} to {high:.2f} in 90 % of tests, median {middle:.2f}"
    )
    figure, axes = new_figure(height=75.0)
    axes.hist(shapes, bins=[0.1 * step for step in range(61)])
    axes.axvline(SHAPE, color="black")
    axes.set_xlabel("fitted shape β of six lives [–]")
    axes.set_ylabel("tests")
    save_figure(figure, folder / "small_samples.png")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
