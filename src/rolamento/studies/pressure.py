"""The greatest Hertz pressure of a race, without the pressures of all its contacts."""

from __future__ import annotations

import numpy as np

from rolamento.geometry import Race
from rolamento.rows.ball import layout
from rolamento.rows.ball.batch_state import RowBatch
from rolamento.rows.ball.detail import ContactTable, hertz
from rolamento.studies.outputs import Floats, Solved

__all__ = ["greatest_pressure"]

_MARGIN = 1e-9
"""Rounding must not shut out the greatest."""


def greatest_pressure(solved: Solved, race: Race) -> Floats:
    """Return the greatest of the maximum pressures at a race's contacts; (cases,), Pa.

    Only contacts that may be the greatest are evaluated. At a given load the pressure grows with
    the curvature ρ_x in the rolling direction, as ρ_x to a power between 1/3 (where ρ_x = ρ_y)
    and 2/3 (ρ_y = 0), since p_0 goes with the curvatures to the power 2/3 altogether and ρ_x is
    the greater. With r = ρ_x over the greatest of the case,

        Q^(1/3) r^(2/3)  ≤  p_0 / c  ≤  Q^(1/3) r^(1/3),

    and a contact whose upper bound is below another's lower bound is not the greatest.
    """
    contacts = solved.contacts(race)
    greatest = np.full(len(contacts.load), np.nan)
    first = 0
    for row in solved.batch.rows:
        balls = slice(first, first + row.azimuth.shape[1])
        first = balls.stop
        own = ContactTable(
            contacts.load[:, balls],
            contacts.contact_angle[:, balls],
            contacts.deflection[:, balls],
        )
        np.fmax(greatest, _greatest_of_row(row, own, race), out=greatest)
    return greatest


def _greatest_of_row(row: RowBatch, contacts: ContactTable, race: Race) -> Floats:
    case, ball = np.nonzero(_candidates(row, contacts, race))
    chosen = ContactTable(
        contacts.load[case, ball, np.newaxis],
        contacts.contact_angle[case, ball, np.newaxis],
        contacts.deflection[case, ball, np.newaxis],
    )
    pressure = hertz(row.parameters[:, case], chosen, race).max_pressure[:, 0]
    greatest = np.full(len(contacts.load), np.nan)
    np.fmax.at(greatest, case, pressure)
    return greatest


def _candidates(
    row: RowBatch, contacts: ContactTable, race: Race
) -> np.ndarray[tuple[int, int], np.dtype[np.bool_]]:
    """Which contacts may have the greatest pressure of their case."""
    sign = -1.0 if race == "inner" else 1.0
    gamma = row.parameters[layout.GAMMA][:, np.newaxis] * np.cos(contacts.contact_angle)
    curvature = 1.0 / (1.0 + sign * gamma)
    with np.errstate(invalid="ignore"):
        ratio = np.cbrt(curvature / curvature.max(axis=1, keepdims=True))
        above = np.cbrt(contacts.load) * ratio
        below = (above * ratio).max(axis=1, keepdims=True)
        return np.asarray(above >= (1.0 - _MARGIN) * below)
