"""Radaelli's static examples (tables C.1, C.2) and the 218 bearing at speed (5.3, 5.4, text).

His stiffness constant 2.15e5 stands for a modulus of 207.518 GPa at ν = 0.3; it is taken here. His
balls orbit as raceway control says even where the inner ring does not touch them (`AS_PUBLISHED`).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import degrees, nan, radians
from typing import Any, Final

import numpy as np

from rolamento.case import Case
from rolamento.case.duty import Displacement, Duty, Load
from rolamento.case.model import Model
from rolamento.kinematics import ball_mass, ball_motion, centrifugal_force, gyroscopic_moment
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.static import radial_load
from rolamento.units import MILLIMETRE, RPM
from rolamento.verification.check import Check, cut, last_unit, published, rounded
from rolamento.verification.harris_1991 import (
    AXIAL,
    BY_INTEGRAL,
    RADIAL,
    Label,
    Number,
    axial_example,
    bearing_209,
    bearing_218,
    radial_example,
)
from rolamento.words import Note

BALL_QUANTITIES: Final[Mapping[str, Label]] = {
    "outer_angle_deg": Label("α_o", "°"),
    "inner_angle_deg": Label("α_i", "°"),
    "outer_load_N": Label("Q_o", "N"),
    "inner_load_N": Label("Q_i", "N"),
}

_INTEGRAL: Final = Note("verify_radaelli_integral")
_FROZEN: Final = Note("verify_radaelli_frozen")
_CUT: Final = Note("verify_radaelli_cut")
_HELD: Final = Note("verify_radaelli_held")
_TIE: Final = Note("verify_radaelli_tie")
_REACTION: Final = Note("verify_radaelli_reaction")
_AS_RADIAL: Final = Note("verify_radaelli_as_radial")
_WITHOUT_CLEARANCE: Final = Note("verify_radaelli_without_clearance")
_PROPORTION: Final = Note("verify_radaelli_proportion")
_LOADS_GIVEN: Final = Note("verify_radaelli_loads_given")

AS_PUBLISHED: Final = Model(cage="none")
"""Raceway control alone moves the balls."""
HALF_AGAIN: Final = 0.5
_PROPORTION_TOLERANCE: Final = 1e-6
_ANY_ANGLE_DEG: Final = 30.0
_ANY_SPEED_RPM: Final = 10000.0


def checks() -> Iterator[Check]:
    """Compare all tables, and the numbers in the text."""
    yield from _example("table_C1", RADIAL, radial_example(), _reason_c1)
    yield from _example("table_C2", AXIAL, axial_example(), _reason_c2)
    yield from _static_text()
    yield from _table_5_3()
    yield from _table_5_4()
    yield _figure_5_25()


def _example(
    table: str, quantities: Mapping[str, Label], found: Mapping[str, Number], reason: Any
) -> Iterator[Check]:
    data = published("radaelli_2013")[table]
    for key, printed in data["printed"].items():
        yield Check(
            source=data["source"],
            quantity=quantities[key].name,
            unit=quantities[key].unit,
            printed=printed,
            computed=found[key].computed,
            **reason(key, printed, found[key]),
        )


def _reason_c1(_key: str, printed: str, number: Number) -> dict[str, Any]:
    if number.by_choice is None or float(printed) == 0.0:
        return {}
    deviation = BY_INTEGRAL * float(printed)
    return {"explanation": _INTEGRAL, "evidence": number.by_choice, "deviation": deviation}


def _reason_c2(key: str, printed: str, number: Number) -> dict[str, Any]:
    by_choice = nan if number.by_choice is None else number.by_choice
    if key == "contact_angle_deg":
        evidence = cut(by_choice, printed)
        return {"explanation": _CUT, "evidence": evidence, "deviation": last_unit(printed)}
    return {"explanation": _FROZEN, "evidence": by_choice}


def _static_text() -> Iterator[Check]:
    """Compare the numbers that stand in the text: load zone, start value, doubled speed."""
    text, table = published("radaelli_2013")["text"], published("radaelli_2013")["table_5_3"]
    zone = radial_load(
        bearing_209(diametral_clearance=0.0),
        published("radaelli_2013")["table_C1"]["radial_load_N"],
    ).load_zone_half_angle
    yield Check(
        source=text["load_zone_source"],
        quantity="ψ_l, P_d = 0",
        unit="°",
        printed=text["load_zone_half_angle_deg"],
        computed=degrees(float(zone)),
        explanation=_WITHOUT_CLEARANCE,
    )
    for name, (slow, fast) in _inertia_at_two_speeds().items():
        yield Check(
            source=text["doubled_speed_source"],
            quantity=f"{name}(2n)/{name}(n)",
            unit="",
            printed=text["doubled_speed_factor"],
            computed=fast / slow,
            tolerance=_PROPORTION_TOLERANCE,
            explanation=_PROPORTION,
        )
    as_radial = radial_load(bearing_218(contact_angle=0.0), table["radial_load_N"])
    yield Check(
        source=text["static_start_source"],
        quantity="δ_r at rest",
        unit="mm",
        printed=text["static_radial_displacement_mm"],
        computed=float(solve(case_5_3(speed_rpm=0.0)).displacement.z[0]) / MILLIMETRE,
        explanation=_AS_RADIAL,
        evidence=float(as_radial.radial_displacement) / MILLIMETRE,
        deviation=HALF_AGAIN * float(text["static_radial_displacement_mm"]),
    )


def _inertia_at_two_speeds() -> dict[str, tuple[float, float]]:
    """Centrifugal force and gyroscopic moment of a ball of the 209, at a speed and at twice it."""
    bearing = bearing_209()
    angle, speed = radians(_ANY_ANGLE_DEG), _ANY_SPEED_RPM * RPM
    ratio = bearing.ball_diameter / bearing.pitch_diameter
    motion = ball_motion(angle, angle, ratio, [speed, 2.0 * speed])
    mass = ball_mass(bearing.ball_diameter, bearing.ball_material.density)
    force = centrifugal_force(mass, bearing.pitch_diameter, motion.orbital_speed)
    moment = gyroscopic_moment(mass, bearing.ball_diameter, motion)
    return {"F_c": (float(force[0]), float(force[1])), "M_g": (float(moment[0]), float(moment[1]))}


def case_5_3(youngs_modulus: float | None = None, speed_rpm: float | None = None) -> Case:
    """Return the case of table 5.3, as given or with another modulus (Pa) or speed."""
    table = published("radaelli_2013")["table_5_3"]
    speed = table["inner_speed_rpm"] if speed_rpm is None else speed_rpm
    duty = Duty(
        inner_speed=speed * RPM,
        load=Load(fz=table["radial_load_N"]),
        displacement=Displacement(x=0.0),
    )
    return Case(bearing=bearing_218(youngs_modulus), duty=duty, model=AS_PUBLISHED)


def case_5_4(tilt_deg: float) -> Case:
    """Return the case of table 5.4 with a tilt about y."""
    table = published("radaelli_2013")["table_5_4"]
    duty = Duty(
        inner_speed=table["inner_speed_rpm"] * RPM,
        load=Load(fx=table["axial_load_N"], fz=table["radial_load_N"]),
        displacement=Displacement(ry=radians(tilt_deg)),
    )
    return Case(bearing=bearing_218(), duty=duty, model=AS_PUBLISHED)


def numbers_of_balls(solved: Solved) -> dict[tuple[float, str], float]:
    """Return the columns of table 5.3 by azimuth in degrees, all round, and key."""
    columns = {
        "outer_angle_deg": np.degrees(solved.outer.contact_angle[0]),
        "inner_angle_deg": np.degrees(solved.inner.contact_angle[0]),
        "outer_load_N": solved.outer.load[0],
        "inner_load_N": solved.inner.load[0],
    }
    azimuths = np.degrees(solved.elements.azimuth[0]).round(6).tolist()
    return {
        (azimuth, key): float(value)
        for key, values in columns.items()
        for azimuth, value in zip(azimuths, values, strict=True)
    }


def _table_5_3() -> Iterator[Check]:
    table = published("radaelli_2013")["table_5_3"]
    solved = solve(case_5_3())
    yield Check(
        source=table["source"],
        quantity="δ_z",
        unit="mm",
        printed=table["radial_displacement_mm"],
        computed=float(solved.displacement.z[0]) / MILLIMETRE,
        explanation=_HELD,
    )
    found = numbers_of_balls(solved)
    for azimuth, *row in table["rows"]:
        for key, printed in zip(table["columns"][1:], row, strict=True):
            computed = found.get((float(azimuth), key), nan)
            tie = (azimuth, key) == ("90.0", "inner_angle_deg")
            yield Check(
                source=table["source"],
                quantity=f"{BALL_QUANTITIES[key].name}, ψ = {float(azimuth):g}°",
                unit=BALL_QUANTITIES[key].unit,
                printed=printed,
                computed=computed,
                explanation=_TIE if tie else _HELD,
                evidence=rounded(rounded(computed, printed, 1), printed) if tie else None,
                deviation=last_unit(printed) if tie else 0.0,
            )


def _table_5_4() -> Iterator[Check]:
    table = published("radaelli_2013")["table_5_4"]
    for tilt, *row in table["rows"]:
        solved = solve(case_5_4(float(tilt)))
        shift = solved.displacement
        computed = (shift.x / MILLIMETRE, shift.z / MILLIMETRE, solved.load.my)
        names = (("δ_a", "mm"), ("δ_z", "mm"), ("M_y", "N·m"))
        for (name, unit), printed, value in zip(names, row, computed, strict=True):
            yield Check(
                source=table["source"],
                quantity=f"{name}, θ_y = {float(tilt):g}°".replace("-", "−"),
                unit=unit,
                printed=printed,
                computed=float(value[0]),
                explanation=_REACTION,
            )


def _figure_5_25() -> Check:
    """Compare the reduction of the radial displacement that an axial load brings."""
    text = published("radaelli_2013")["text"]
    light, heavy = (
        float(solve(_case_5_25(text, axial)).displacement.z[0])
        for axial in text["figure_5_25_axial_loads_N"]
    )
    return Check(
        source=text["figure_5_25_source"],
        quantity="fall of δ_z",
        unit="%",
        printed=text["figure_5_25_reduction_percent"],
        computed=100.0 * (1.0 - heavy / light),
        explanation=_LOADS_GIVEN,
    )


def _case_5_25(text: Mapping[str, Any], axial_load: float) -> Case:
    duty = Duty(
        inner_speed=text["figure_5_25_speed_rpm"] * RPM,
        load=Load(fx=axial_load, fz=text["figure_5_25_radial_load_N"]),
    )
    return Case(bearing=bearing_218(), duty=duty, model=AS_PUBLISHED)
