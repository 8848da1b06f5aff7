"""From a slider to the picture, as the browser counts it."""

from __future__ import annotations

import os
from statistics import quantiles
from typing import Any

MOVES = 120
GOAL = 0.060
"""Seconds at the 95th percentile, of a bearing with fits, grease and temperatures, where a machine
of two cores has nothing else to do. Every move changes the ends of the axes: Plotly draws them."""
MEASURE = """async moves => {
  const slider = document.querySelector('[data-name="duty.load.fz"] input[type=range]');
  const plot = document.querySelector('[data-key=rosette] .plot');
  const times = [];
  for (let n = 0; n < moves; n += 1) {
    const drawn = new Promise((resolve) => {
      const seen = new MutationObserver(() => { seen.disconnect(); resolve(performance.now()); });
      seen.observe(plot, { subtree: true, attributeFilter: ["d"] });
    });
    slider.value = 60 + ((n * 37) % 300);
    const moved = performance.now();
    slider.dispatchEvent(new Event("input", { bubbles: true }));
    const late = new Promise((resolve) => setTimeout(resolve, 3000, null));
    const shown = await Promise.race([drawn, late]);
    times.push(shown === null ? null : shown - moved);
    await new Promise((resolve) => setTimeout(resolve, 30));
  }
  return times;
}"""


def test_the_picture_follows_the_slider(visit: Any, record_property: Any) -> None:
    load = os.getloadavg()[0]
    page = visit()
    page.locator("#examples button:has([data-example='6310_motor'])").click()
    page.locator("#status p.good").wait_for()
    page.wait_for_timeout(1500)
    page.evaluate(MEASURE, 20)  # warm
    times = page.evaluate(MEASURE, MOVES)
    assert None not in times
    cuts = quantiles([1e-3 * time for time in times], n=20)
    p50, p95 = cuts[9], cuts[18]
    record_property("p50", p50)
    record_property("p95", p95)
    print(
        f"slider to picture: p50 {1e3 * p50:.1f} ms, p95 {1e3 * p95:.1f} ms (goal {1e3 * GOAL:.0f})"
    )
    busy = load / (os.cpu_count() or 1)  # by others
    if busy < 1.0:
        assert p95 < (GOAL if busy < 0.25 else 5 * GOAL)
