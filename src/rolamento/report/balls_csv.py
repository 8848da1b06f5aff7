"""The table of balls as comma-separated values (RFC 4180), for spreadsheets and scripts.

Names and numbers are the same in every language: units as people use them, named in the header, a
decimal point, and an empty field for a number that does not exist.
"""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterator
from io import StringIO
from math import degrees, isfinite, pi
from typing import Final

from rolamento.state import BallState, ContactState, State

__all__ = ["CSV_COLUMNS", "ball_csv"]

_RPM: Final = 30.0 / pi

_BALL: Final[dict[str, Callable[[BallState], float]]] = {
    "azimuth_deg": lambda ball: degrees(ball.azimuth),
}
_CONTACT: Final[dict[str, Callable[[ContactState], float]]] = {
    "load_N": lambda contact: contact.load,
    "contact_angle_deg": lambda contact: degrees(contact.contact_angle),
    "deflection_um": lambda contact: 1e6 * contact.deflection,
    "semi_major_mm": lambda contact: 1e3 * contact.semi_major,
    "semi_minor_mm": lambda contact: 1e3 * contact.semi_minor,
    "max_pressure_MPa": lambda contact: 1e-6 * contact.max_pressure,
    "mean_pressure_MPa": lambda contact: 1e-6 * contact.mean_pressure,
    "max_shear_MPa": lambda contact: 1e-6 * contact.max_shear,
    "max_shear_depth_mm": lambda contact: 1e3 * contact.max_shear_depth,
    "orthogonal_shear_MPa": lambda contact: 1e-6 * contact.orthogonal_shear,
    "orthogonal_shear_depth_mm": lambda contact: 1e3 * contact.orthogonal_shear_depth,
    "spin_to_roll": lambda contact: contact.spin_to_roll,
}
_MOTION: Final[dict[str, Callable[[BallState], float]]] = {
    "centrifugal_force_N": lambda ball: ball.centrifugal_force,
    "gyroscopic_moment_Nmm": lambda ball: 1e3 * ball.gyroscopic_moment,
    "orbital_speed_rpm": lambda ball: _RPM * ball.orbital_speed,
    "ball_speed_rpm": lambda ball: _RPM * ball.ball_speed,
    "attitude_deg": lambda ball: degrees(ball.attitude),
}

CSV_COLUMNS: Final = (
    "row",
    "ball",
    *_BALL,
    *(f"{race}_{name}" for race in ("inner", "outer") for name in _CONTACT),
    *_MOTION,
    "raceway_control",
)
"""The header: what each column holds, and its unit."""


def ball_csv(state: State) -> str:
    """Return the balls of a state, one a line below a header, lines ending in CR LF."""
    text = StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(CSV_COLUMNS)
    writer.writerows(_line(number, ball) for number, ball in enumerate(state.balls))
    return text.getvalue()


def _line(number: int, ball: BallState) -> list[object]:
    numbers = [_written(value) for value in _numbers(ball)]
    return [ball.row, number, *numbers, ball.raceway_control]


def _numbers(ball: BallState) -> Iterator[float]:
    yield from (of(ball) for of in _BALL.values())
    for contact in (ball.inner, ball.outer):
        yield from (of(contact) for of in _CONTACT.values())
    yield from (of(ball) for of in _MOTION.values())


def _written(value: float) -> str:
    """Write ten significant digits: more than any of the numbers is worth, and no noise."""
    return f"{value:.10g}" if isfinite(value) else ""
