"""What `rolamento friction` and `rolamento life` share where they vary a field of the case."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Annotated, Final, Protocol, TypeVar

import typer

from rolamento.cli.common import Language, complain_of_points
from rolamento.cli.options import plot_option
from rolamento.cli.outputs import Outputs
from rolamento.cli.streams import STANDARD_STREAM, put
from rolamento.errors import InputError
from rolamento.words import said

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from rolamento.case import Case
    from rolamento.document import Document


__all__ = [
    "POINTS",
    "CurvesPlotOption",
    "LogOption",
    "PointsOption",
    "cases_over",
    "check_variants",
    "show_curves",
]

POINTS: Final = 40
_MOST_VARIANTS: Final = 5
"""Lines that one figure over a field can distinguish."""

PointsOption = Annotated[
    int, typer.Option("--points", metavar="N", help="Number of values of that field, 2 to 1000.")
]
LogOption = Annotated[bool, typer.Option("--log", help="Logarithmic spacing of the values.")]
CurvesPlotOption = Annotated[str | None, plot_option("With --over, draw it")]


class Curve(Protocol):
    """What a case does over a field."""

    @property
    def status(self) -> NDArray[np.str_]:
        """Status of each point."""
        ...

    @property
    def converged(self) -> bool:
        """Whether every point has a result."""
        ...


C = TypeVar("C", bound=Curve)


def check_variants(variants: list[str]) -> None:
    """Refuse more variants than can be distinguished.

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


def cases_over(case: Case, variants: list[str]) -> list[tuple[str, Case]]:
    """Return the case, without a label unless a variant names it, and its variants by their names.

    Raises
    ------
    InputError
        If a text is no variant, or one of another case.
    """
    from rolamento.case.variant import AS_GIVEN, cases_compared, read_variants

    found = cases_compared(case, read_variants(variants)) or {AS_GIVEN: case}
    return [("" if name == AS_GIVEN else name, own) for name, own in found.items()]


def show_curves(
    curves: Sequence[C],
    page: Callable[[Sequence[C]], Document],
    json_text: Callable[[Sequence[C]], str],
    figure: Callable[[Sequence[C]], Figure],
    json: str | None,
    plot: str | None,
    outputs: Outputs,
    lang: Language | None,
) -> bool:
    """Write what was asked for; standard output takes data or the page, not both.

    Parameters
    ----------
    curves
        The case's own first, then its variants.
    page, json_text, figure
        Make them; called only for what is asked for.
    json, plot, outputs
        Files; None where nothing is asked for.
    lang
        The language; that of the locale if not given.

    Returns
    -------
    bool
        Whether every point has a result.
    """
    if json is not None:
        put(json_text(curves) + "\n", json)
    if plot is not None:
        from rolamento.plots.saving import save_figure

        save_figure(figure(curves), plot)
    outputs.show(lambda: page(curves), json)
    failed = next((curve.status for curve in curves if not curve.converged), None)
    if failed is not None and STANDARD_STREAM in (json, outputs.csv):
        complain_of_points(failed[failed != "converged"], len(failed), lang)
    return failed is None
