"""What stands at the head of a report: the [report] table of a case."""

from pydantic import Field

from rolamento.case.quantity import Line
from rolamento.case.record import Record

__all__ = ["ReportHead"]


class ReportHead(Record):
    """Title block of a report; no number of the analysis depends on it.

    Parameters
    ----------
    project
        That the calculation belongs to.
    author
        Who calculated.
    revision
        Of the calculation, such as ``"B"``.
    date
        Of the report; that of the day if not given.
    checked_by
        Who checked it; a line to sign on if not given.

    Raises
    ------
    InputError
        If a value is not one line of text.
    """

    project: Line = Field("", examples=["Spindle unit 4711"])
    author: Line = Field("", examples=["A. Souza"])
    revision: Line = Field("", examples=["B"])
    date: Line = Field("", examples=["2026-11-30"])
    checked_by: Line = Field("", examples=["M. Okafor"])
