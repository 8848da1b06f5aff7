"""What `rolamento friction` and `rolamento life` share where they vary a field of the case."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Annotated, Final, Protocol, TypeVar

import typer

from rolamento.cli.common import Language, complain_of_points
from rolamento.cli.options import plot_option
from rolamento.cli.streams import STANDARD_STREAM, print_text, put
from rolamento.errors import InputError
from rolamento.words import said

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.figure import Figure
    from numpy.typing import NDArray


__all__ = [
    "POINTS",
    "CurvesPlotOption",
    "LogOption",
    "PointsOption",
    "VariantsOption",
    "check_variants",
    "show_curves",
]

POINTS: Final = 40
_MOST_VARIANTS: Final = 5

PointsOption = Annotated[
    int, typer.Option("--points", metavar="N", help="Number of values of that field, 2 to 1000.")
]
LogOption = Annotated[bool, typer.Option("--log", help="Logarithmic spacing of the values.")]
VariantsOption = Annotated[
    list[str] | None,
    typer.Option(
        "--variant",
        metavar="KEY=VALUE",
        help="Also show the case with this field changed; with --over. Repeatable.",
    ),
]
CurvesPlotOption = Annotated[str | None, plot_option("With --over, draw it")]


class Curve(Protocol):
    """What a case does over a field."""

    @property
    def status(self) -> NDArray[np.str_]:
        """Of each point."""
        ...

    @property
    def converged(self) -> bool:
        """Whether every point has a result."""
        ...


C = TypeVar("C", bound=Curve)


def check_variants(variants: list[str]) -> None:
    """Refuse more variants than can be told apart.

    Raises
    ------
    InputError
        For more than five.
    """
    if len(variants) > _MOST_VARIANTS:
        raise InputError(
            said("may be given at most {most} times", most=_MOST_VARIANTS),
            field="--variant",
            value=len(variants),
        )


def show_curves(
    curves: Sequence[C],
    *,
    json_text: Callable[[Sequence[C]], str],
    csv_text: Callable[[Sequence[C]], str],
    page_text: Callable[[Sequence[C]], str],
    figure: Callable[[Sequence[C]], Figure],
    outputs: tuple[str | None, str | None, str | None],
    lang: Language | None,
) -> bool:
    """Write what was asked for; standard output takes data or the report, not both.

    Parameters
    ----------
    curves
        The case's own first, then its variants.
    json_text, csv_text, page_text, figure
        Write and draw them; called only for what is asked for.
    outputs
        Files for JSON, a table and a picture; None where nothing is asked for.
    lang
        The language; that of the locale if not given.

    Returns
    -------
    bool
        Whether every point has a result.
    """
    json, csv, plot = outputs
    if json is not None:
        put(json_text(curves) + "\n", json)
    if csv is not None:
        put(csv_text(curves), csv)
    if plot is not None:
        from rolamento.plots.saving import save_figure

        save_figure(figure(curves), plot)
    converged = all(curve.converged for curve in curves)
    if STANDARD_STREAM not in (json, csv):
        print_text(page_text(curves))
    elif not converged:
        status = next(curve.status for curve in curves if not curve.converged)
        complain_of_points(status[status != "converged"], len(status), lang)
    return converged
