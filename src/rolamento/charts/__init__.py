"""Charts: what a picture shows, as a record, and what draws it on paper or on the page.

A function of `contact_charts` and its neighbours takes results and returns a `Chart`;
`drawing.draw` draws it with Matplotlib, `plotly.picture` writes it for the page.
"""

from rolamento.charts.palette import Look, case_look, race_look, series_look
from rolamento.charts.record import (
    Axis,
    Bars,
    Chart,
    Ellipses,
    Labels,
    Line,
    Mark,
    Spread,
    Zone,
    nothing,
)

__all__ = [
    "Axis", "Bars", "Chart", "Ellipses", "Labels", "Line", "Look", "Mark", "Spread", "Zone",
    "case_look", "nothing", "race_look", "series_look",
]  # fmt: skip
