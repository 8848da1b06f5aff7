"""Charts: what a picture shows, as a record, and what draws it on paper or on the page.

A function of `contact_charts` and its neighbours takes results and returns a `Chart`;
`drawing.draw` draws it with Matplotlib, `plotly.picture` writes it for the page.
"""

from rolamento.charts.palette import Look, case_look, race_look, series_look
from rolamento.charts.record import (
    Arrows,
    Axis,
    Bars,
    Chart,
    Ellipses,
    Field,
    Labels,
    Line,
    Mark,
    Spread,
    Zone,
    key,
    nothing,
    once,
    step_line,
)

__all__ = [
    "Arrows", "Axis", "Bars", "Chart", "Ellipses", "Field", "Labels", "Line", "Look", "Mark",
    "Spread", "Zone", "case_look", "key", "nothing", "once", "race_look", "series_look",
    "step_line",
]  # fmt: skip
