"""The rows of a mounted set as they run: what fits, temperatures and speed do to their grooves.

A clamped set keeps the axial distance of its grooves, not its force. Of a row with ball D, grooves
r_i = f_i D and r_o = f_o D, groove centres BD = r_i + r_o - D apart at first contact and the
clearance P, the centre of the inner groove lies beside that of the outer one at

    radially BD - P/2,     axially A = BD sin α + e,     cos α = 1 - P/(2 BD)

where e is how far the clamping presses the row in. Free thermal strains ε of rings and balls, and
the clearance P' that the chain of `operating` leaves, take it to

    BD' = r_i (1 + ε_i) + r_o (1 + ε_o) - D (1 + ε_b)
    A'  = A [1 + (L_i ε_i + L_o ε_o)/(L_i + L_o)] + σ S
    e'  = A' - BD' sin α',     cos α' = 1 - P'/(2 BD')

with L = r - D/2, σ = ±1 the way that the row faces, and S how far, at its place, the inner rings
have moved along the shaft beside the outer ones in the housing. S is zero at x = 0, the reference
of the set, and grows over each distance between rows: where the width B of the bearing is known,
by its rings over B and by spacers over the rest; else by shaft and housing.

Springs move after their rings: of such a set only the differences of σ S between rows act.

A row of tapered rollers has no grooves: its inner raceway, the rollers on it and their rib move as
one against the cone of the outer raceway, at α to the bearing's axis. What the chain leaves of the
diametral clearance P, from first contact on, presses it in less by (P/2) cot α, so that

    e' = e + σ S - (P'/2) cot α.

All parts as warm as each other change nothing but the size. With equal rings and rollers this is
the rule of Timken's manual for the setting of two rows: half the growth of the mean outer raceway
times cot α, and the distance of the rows.

Rigid rings; plane press fits; expansion free in every direction. Sources: as of `effects`; the
place of the groove centres: Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapters 2 and 3;
tapered rollers: The Timken Company, Mounting, Fitting and Setting Your Bearings, chapter E 2.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import pairwise
from typing import Any, Final, Literal

import numpy as np

from rolamento.case import Case
from rolamento.case.roller_bearing import roller_clearance_fits
from rolamento.clearance.batch import (
    initial_of_row,
    inside_seats,
    mounting_of,
    row_bearing,
    temperatures_of,
)
from rolamento.clearance.chain import (
    Chain,
    PartTemperatures,
    Strains,
    gathered,
    housing_bands,
    shaft_bands,
    warm_geometry,
)
from rolamento.clearance.standards import Limit
from rolamento.errors import InputError
from rolamento.geometry import free_contact_angle
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen

__all__ = ["STAGES", "RunningRow", "Stage", "running_rows", "width_of"]

_PAST_SENSE: Final = 0.25
"""Fraction of the distance of the groove centres."""

Stage = Literal["unmounted", "mounted", "warm", "running"]
STAGES: Final[tuple[Stage, ...]] = ("unmounted", "mounted", "warm", "running")
"""What has happened so far: nothing, the fits, the temperatures too, the rings' growth too."""


@frozen
class RunningRow:
    """One row at a stage; arrays that broadcast over cases, SI.

    Attributes
    ----------
    geometry
        By field of the row's bearing, as the temperatures leave it.
    clearance
        Diametral clearance, of tapered rollers from first contact; NaN where the row does not lie
        between its seats.
    contact_angle
        Free contact angle, 0 of balls under interference; that of the outer raceway of tapered
        rollers; rad.
    touch
        Axial distance of the groove centres at first contact, BD sin α, 0 under interference; of
        tapered rollers how far first contact has moved.
    stretch
        What the temperatures multiply axial distances within the row by.
    along
        σ S of the module: how much further the row's place along the shaft presses it in.
    closed
        Where balls given by their contact angle have no clearance left to have one.
    shut
        Where the interference is past all sense.
    """

    geometry: Mapping[str, FloatArray]
    clearance: FloatArray
    contact_angle: FloatArray
    touch: FloatArray
    stretch: FloatArray
    along: FloatArray
    closed: BoolArray
    shut: BoolArray

    def over(self, cases: int) -> RunningRow:
        """The same row with arrays (cases,)."""
        names = ("clearance", "contact_angle", "touch", "stretch", "along", "closed", "shut")
        wide = {name: np.broadcast_to(getattr(self, name), cases) for name in names}
        geometry = {name: np.broadcast_to(array, cases) for name, array in self.geometry.items()}
        return RunningRow(geometry=geometry, **wide)


def width_of(case: Case) -> float | None:
    """B of one bearing of a set: as the mounting has it, or as the catalogue gives; m."""
    if case.mounting is not None and case.mounting.width is not None:
        return case.mounting.width
    published = case.bearing.published
    return None if published is None else published.width


def running_rows(
    case: Case, arrays: Mapping[str, FloatArray], stage: Stage, limit: Limit | None = None
) -> tuple[RunningRow, ...]:
    """The rows of a mounted set at a stage.

    Parameters
    ----------
    case
        With a mounting.
    arrays
        What varies, by the dotted names of fields; SI, scalars or arrays (cases,).
    stage
        One of `STAGES`.
    limit
        Which tolerances; those that the mounting names if not given.

    Raises
    ------
    InputError
        If a temperature or an expansion that is needed is missing, or something is not in the
        tables.
    """
    mounting = mounting_of(case, arrays)
    warm: Any = PartTemperatures()
    if stage in ("warm", "running"):
        warm = temperatures_of(case, arrays)
    speeds = [
        arrays.get(f"duty.{name}", getattr(case.duty, name)) if stage == "running" else 0.0
        for name in ("inner_speed", "outer_speed")
    ]
    rows, strains = [], None
    for index, place in enumerate(case.bearing.places):
        bearing = row_bearing(case.bearing, place.bearing, case.bearing.own_fields(index), arrays)
        assembly = gathered(bearing, mounting, warm, *speeds)
        strains = assembly.strains
        try:
            initial, reading = initial_of_row(assembly, place.bearing, arrays)
            chain = Chain(
                assembly, initial, reading, shaft_bands(mounting), housing_bands(mounting)
            )
        except InputError as error:
            raise error.with_details(field=f"mounting.{error.field}") from None
        at = limit or mounting.limit
        found = initial.at(at) if stage == "unmounted" else chain.at(at)
        clearance = np.where(inside_seats(assembly, mounting), found, np.nan)
        make = _rollers if bearing.bearing_type.has_rollers else _balls
        rows.append(make(bearing, clearance, strains))
    assert strains is not None
    moved = _moved_along(case, arrays, strains)
    signs = (place.sign for place in case.bearing.places)
    return tuple(
        replace(row, along=np.asarray(sign * shift))
        for row, sign, shift in zip(rows, signs, moved, strict=True)
    )


def _balls(bearing: Any, clearance: FloatArray, strains: Strains) -> RunningRow:
    names = ("ball_diameter", "pitch_diameter", "inner_conformity", "outer_conformity")
    geometry = _geometry(bearing, names, strains)
    diameter = geometry["ball_diameter"]
    reach = diameter * (geometry["inner_conformity"] + geometry["outer_conformity"] - 1.0)
    lengths = [np.asarray(f) - 0.5 for f in (bearing.inner_conformity, bearing.outer_conformity)]
    mean = lengths[0] * strains.inner_ring + lengths[1] * strains.outer_ring
    angle = free_contact_angle(clearance, reach)
    return RunningRow(
        geometry=geometry,
        clearance=clearance,
        contact_angle=np.asarray(angle),
        touch=np.asarray(reach * np.sin(angle)),
        stretch=np.asarray(1.0 + mean / (lengths[0] + lengths[1])),
        along=np.zeros(()),
        closed=np.asarray(~(clearance > 0.0)),
        shut=np.asarray(~(clearance > -_PAST_SENSE * reach)),
    )


def _rollers(bearing: Any, clearance: FloatArray, strains: Strains) -> RunningRow:
    geometry = _geometry(bearing, ("roller_diameter", "pitch_diameter"), strains)
    angle, touch = np.zeros(()), 0.0 * clearance
    if bearing.bearing_type.conical:
        angle = np.asarray(bearing.contact_angle, np.float64)
        touch = 0.5 * clearance / np.tan(angle)
    return RunningRow(
        geometry=geometry,
        clearance=clearance,
        contact_angle=angle,
        touch=np.asarray(touch),
        stretch=np.ones(()),
        along=np.zeros(()),
        closed=np.zeros((), np.bool_),
        shut=np.asarray(~roller_clearance_fits(clearance, geometry["roller_diameter"])),
    )


def _geometry(bearing: Any, names: tuple[str, ...], strains: Strains) -> dict[str, FloatArray]:
    """The sizes of a row, as its temperatures leave them."""
    own = {name: np.asarray(getattr(bearing, name), np.float64) for name in names}
    return {**own, **warm_geometry(bearing, strains)}


def _moved_along(
    case: Case, arrays: Mapping[str, FloatArray], strains: Strains
) -> list[FloatArray]:
    """S of each row: how far its inner ring has moved toward +x beside its outer ring; m."""
    width, places = width_of(case), [place.position for place in case.bearing.places]
    scale = np.ones(())
    if "bearing.spacing" in arrays and case.bearing.spacing:
        scale = np.asarray(arrays["bearing.spacing"] / case.bearing.spacing)
    rings = np.asarray(strains.inner_ring) - np.asarray(strains.outer_ring)
    rest = np.asarray(strains.inner_spacer) - np.asarray(strains.outer_spacer)
    seats = np.asarray(strains.shaft) - np.asarray(strains.housing)

    def growth(gap: float) -> FloatArray:
        length = np.abs(gap) * scale
        if width is None:
            return np.asarray(np.sign(gap) * seats * length)
        of_rings = np.minimum(width, length)
        return np.asarray(np.sign(gap) * (rings * of_rings + rest * (length - of_rings)))

    moved = [np.zeros(())]
    for before, after in pairwise(places):
        moved.append(moved[-1] + growth(after - before))
    # from where x = 0 lies between two rows, or beyond the first or the last
    first = next((i for i in range(len(places) - 1) if places[i + 1] >= 0.0), len(places) - 2)
    gap = places[first + 1] - places[first]
    share = -places[first] / gap if gap else 0.0
    start = moved[first] + share * (moved[first + 1] - moved[first])
    return [np.asarray(shift - start) for shift in moved]
