"""What the measuring load adds to the clearance of a ball bearing.

A dial gauge reads how far one ring moves when the load on it is reversed: the clearance, and the
elastic approach of balls and races on both sides. With δ_r the radial displacement from the
centre under the load F and Δ the clearance without load,

    reading = 2 δ_r(F, Δ),    correction = 2 [δ_r(F, Δ) - Δ/2].

The correction grows with the clearance, because fewer balls then share the load, until one ball
carries it all.

Source of the idea and of the usual loads: Campanha (2008), table 3.2 (as JIS B 1515 and makers'
catalogues); the correction itself follows from the equilibrium.
"""

from __future__ import annotations

from typing import Final

from rolamento.case.bearing import Bearing
from rolamento.clearance.standards import step_of
from rolamento.errors import InputError
from rolamento.static import radial_load
from rolamento.static.radial import Distribution
from rolamento.units import MILLIMETRE, readable
from rolamento.words import said

# Campanha 2008, table 3.2
_BORES: Final = (2.5, 18.0, 50.0, 280.0)
_LOADS: Final = (24.5, 49.0, 147.0)
_GREATEST_LOAD: Final = 1e6
_STEPS: Final = 60
_TOLERANCE: Final = 1e-13
"""m: a thousandth of what any gauge resolves, and beyond."""


def usual_measuring_load(bore: float) -> float:
    """Radial load under which a bearing of this bore is usually measured; N.

    Raises
    ------
    InputError
        If the bore (m) is outside 2.5 to 280 mm.
    """
    standard = said("the table of measuring loads")
    return _LOADS[step_of(bore, _BORES, field="bore", standard=standard)]


def measuring_load_correction(
    bearing: Bearing,
    clearance: float,
    load: float,
    *,
    distribution: Distribution = "discrete",
    first_ball_azimuth: float = 0.0,
) -> float:
    """How much more than its clearance a bearing shows under the measuring load; m.

    Parameters
    ----------
    bearing
        Its balls, grooves and materials; its own clearance or contact angle is not read.
    clearance
        Δ without load, in m; not negative.
    load
        F, in N.
    distribution
        ``"discrete"`` counts the balls where they stand, ``"continuous"`` smears them round the
        ring (Sjövall).
    first_ball_azimuth
        Of the first ball from the load line, in rad: a ball under the load by default.

    Raises
    ------
    InputError
        If the load or the clearance is out of range.
    """
    _checked(load, clearance)
    loose = bearing.replace(contact_angle=None, diametral_clearance=clearance)
    state = radial_load(
        loose, load, distribution=distribution, first_ball_azimuth=first_ball_azimuth
    )
    return 2.0 * float(state.radial_displacement) - clearance


def clearance_from_reading(
    bearing: Bearing,
    reading: float,
    load: float,
    *,
    distribution: Distribution = "discrete",
    first_ball_azimuth: float = 0.0,
) -> float:
    """Clearance without load that shows as this reading under the measuring load; m.

    The reading rises with the clearance, faster than it: bisection finds the one answer.

    Parameters
    ----------
    reading
        What the gauge shows from stop to stop, in m.

    The others are as in `measuring_load_correction`.

    Raises
    ------
    InputError
        If the reading is less than what the load alone moves a bearing without clearance.
    """

    def excess(clearance: float) -> float:
        correction = measuring_load_correction(
            bearing,
            clearance,
            load,
            distribution=distribution,
            first_ball_azimuth=first_ball_azimuth,
        )
        return clearance + correction - reading

    _checked(load, reading)
    elastic = excess(0.0) + reading
    if reading < elastic:
        raise InputError(
            said(
                "is less than the elastic approach under the load alone, {deflection}: "
                "the bearing has an interference, which this reading cannot show",
                deflection=readable(float(f"{elastic:.3g}"), "length"),
            ),
            field="measured_clearance",
            value=readable(reading, "length"),
            example='measured_clearance = "0.02 mm"',
        )
    low, high = 0.0, reading
    for _ in range(_STEPS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if excess(middle) < 0.0 else (low, middle)
        if high - low <= _TOLERANCE:
            break
    return 0.5 * (low + high)


def _checked(load: float, clearance: float) -> None:
    if not 0.0 < load <= _GREATEST_LOAD:
        raise InputError(
            said("must be greater than 0 N and at most 1000 kN"),
            field="measuring_load",
            value=load,
            example='measuring_load = "49 N"',
        )
    if not 0.0 <= clearance <= 5.0 * MILLIMETRE:
        raise InputError(
            said("must be at least 0 mm and at most 5 mm"),
            field="measured_clearance",
            value=clearance,
            example='measured_clearance = "0.02 mm"',
        )
