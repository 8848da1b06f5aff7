"""Figure 5.10 and table 5.3, and the static examples of tables C.1 and C.2."""

from __future__ import annotations

import numpy as np

from rolamento.case.duty import Displacement, Duty, Load
from rolamento.contact.hertz import hertz_coefficients
from rolamento.geometry import Race, race_curvature
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.static import axial_load, radial_load, sjovall_radial
from rolamento.units import RPM
from rolamento_reproductions.given import KILO, MILLI
from rolamento_reproductions.radaelli_2013.inputs import bearing, case, inputs_of, said, source_of
from rolamento_reproductions.record import (
    Cell,
    Claim,
    Figure,
    Positions,
    Section,
    Series,
    Table,
    TableColumn,
)
from rolamento_reproductions.text import Text, same

_PER_MM = 10.0**4.5  # N/m^1.5 in a N/mm^1.5
_DIGITS = 9  # what is looked at of two numbers that should be equal


# --- figure 5.10 and table 5.3 ----------------------------------------------


def radial_section(title: Text) -> Section:
    """Compute figure 5.10 and table 5.3."""
    return Section(title, (_positions(), _radial_table()))


def _positions() -> Figure:
    rings = bearing("218")
    ball = np.arange(1.0, rings.ball_count + 1.0)
    azimuth = 180.0 - np.mod(180.0 - (ball - 1.0) * 360.0 / rings.ball_count, 360.0)
    columns = (
        Series("ball", "", said("ball"), ball),
        Series("azimuth", "°", said("azimuth"), azimuth),
    )
    return Figure(
        number="5.10",
        caption=said("positions.caption", ball_count=rings.ball_count),
        source=source_of("positions"),
        columns=columns,
        picture=Positions(rings.ball_diameter / MILLI, rings.pitch_diameter / MILLI),
    )


def _radial_case(speed_rpm: float) -> Solved:
    given = inputs_of("table_5_3")
    duty = Duty(
        inner_speed=speed_rpm * RPM,
        load=Load(fz=given["radial_load_kN"] * KILO),
        displacement=Displacement(x=0.0),
    )
    return solve(case(duty))


def _radial_table() -> Table:
    given = inputs_of("table_5_3")
    solved = _radial_case(given["inner_speed_rpm"])
    rows: list[list[str]] = given["rows"]
    count = solved.elements.azimuth.shape[1]
    computed = (
        np.degrees(solved.outer.contact_angle[0, : len(rows)]),
        np.degrees(solved.inner.contact_angle[0, : len(rows)]),
        solved.outer.load[0, : len(rows)],
        solved.inner.load[0, : len(rows)],
    )
    titles = (same("α_o (°)"), same("α_i (°)"), same("Q_o (N)"), same("Q_i (N)"))
    numbered = tuple(
        same(f"{j + 1}")
        if j in (0, count // 2)
        else said("radial_table.and", first=j + 1, second=count + 1 - j)
        for j in range(len(rows))
    )
    return Table(
        number="5.3",
        caption=said(
            "radial_table.caption",
            inner_speed_rpm=given["inner_speed_rpm"],
            radial_load_kn=given["radial_load_kN"],
            printed=same("{:.4f}", float(given["radial_displacement_mm"])),
            z=float(solved.displacement.z[0]) / MILLI,
        ),
        source=source_of("table_5_3"),
        columns=(
            TableColumn("balls", said("radial_table.balls"), numbered),
            TableColumn("azimuth_deg", same("± ψ (°)"), tuple(str(row[0]) for row in rows)),
            *(
                TableColumn(
                    name,
                    title,
                    tuple(Cell(r[k], float(v)) for r, v in zip(rows, values, strict=True)),
                )
                for k, (name, title, values) in enumerate(
                    zip(given["columns"][1:], titles, computed, strict=True), start=1
                )
            ),
        ),
        claims=(_displacement(solved), _mirrored(solved), *_static_estimate(solved)),
        notes=(said("radial_table.holding_ring_at", fx=float(solved.load.fx[0])),),
    )


def _displacement(solved: Solved) -> Claim:
    printed = inputs_of("table_5_3")["radial_displacement_mm"]
    cell = Cell(printed, float(solved.displacement.z[0]) / MILLI)
    return Claim(
        said("displacement.statement", printed=float(printed)),
        same("{:.5f} mm.", cell.computed),
        cell.agreement == "printed",
    )


def _mirrored(solved: Solved) -> Claim:
    loads = solved.inner.load[0]
    apart = float(np.abs(loads[1:] - loads[:0:-1]).max() / loads.max())
    digits = min(_DIGITS, int(-np.log10(max(apart, 1e-99))))
    return Claim(
        said("mirrored.statement"), said("mirrored.finding", digits=digits), digits == _DIGITS
    )


def _static_estimate(solved: Solved) -> tuple[Claim, Claim]:
    """Look into the static estimate, and why the result at speed is so much greater."""
    given = inputs_of("table_5_3")
    printed = given["static_estimate_mm"]
    without = bearing("218").replace(contact_angle=None, diametral_clearance=0.0)
    estimate = radial_load(without, given["radial_load_kN"] * KILO)
    cell = Cell(printed, float(estimate.radial_displacement) / MILLI)
    at_rest, turning = (float(one.displacement.z[0]) / MILLI for one in (_radial_case(0.0), solved))
    gap = turning - cell.computed
    by_speed = (turning - at_rest) / gap
    return (
        Claim(
            said("static_estimate.statement", printed=float(printed)),
            said("static_estimate.finding", computed=cell.computed),
            cell.agreement == "printed",
        ),
        Claim(
            said("static_estimate.statement.centrifugal_force_explains"),
            said(
                "static_estimate.finding.at_rest_with", at_rest=at_rest, by_speed=100.0 * by_speed
            ),
            by_speed > 0.5,
        ),
    )


# --- tables C.1 and C.2 -----------------------------------------------------


def examples_section(title: Text) -> Section:
    """Compute tables C.1 and C.2."""
    return Section(title, (_radial_example(), _axial_example()))


def _radial_example() -> Table:
    given = inputs_of("table_C1")
    computed = _radial_example_values(given["radial_load_N"])
    return Table(
        number="C.1",
        caption=said("radial_example.caption", radial_load_n=given["radial_load_N"]),
        source=source_of("table_C1"),
        columns=_example_columns(given["rows"], computed, _C1_TITLES),
        claims=(_greatest_difference(given),),
    )


_C1_TITLES = {
    "curvature_sum_inner": (same("Σρ_i"), "1/mm"),
    "curvature_difference_inner": (same("F_i(ρ)"), ""),
    "curvature_sum_outer": (same("Σρ_o"), "1/mm"),
    "curvature_difference_outer": (same("F_o(ρ)"), ""),
    "deflection_star_inner": (same("δ_i*"), ""),
    "deflection_star_outer": (same("δ_o*"), ""),
    "stiffness_inner": (same("K_i"), "N/mm^1.5"),
    "stiffness_outer": (same("K_o"), "N/mm^1.5"),
    "stiffness_combined": (same("K_n"), "N/mm^1.5"),
    "load_zone_parameter": (same("ε"), ""),
    "radial_integral": (same("J_r(ε)"), ""),
    "radial_displacement": (same("δ_r"), "mm"),
    "max_ball_load": (same("Q_max"), "N"),
    "ball_load_0": (same("Q, ψ = 0°"), "N"),
    "ball_load_40": (same("Q, ψ = ±40°"), "N"),
    "ball_load_80": (same("Q, ψ = ±80°"), "N"),
    "ball_load_120": (same("Q, ψ = ±120°"), "N"),
    "ball_load_160": (same("Q, ψ = ±160°"), "N"),
}
_C2_TITLES = {
    "free_angle_rad": (said("free"), "rad"),
    "free_angle_deg": (said("free"), "°"),
    "axial_displacement": (same("δ_a"), "mm"),
    "contact_angle_rad": (same("α"), "rad"),
    "contact_angle_deg": (same("α"), "°"),
    "ball_load": (same("Q"), "N"),
}


def _radial_example_values(load: float) -> dict[str, float]:
    rings = bearing("209")
    state = radial_load(rings, load)
    values: dict[str, float] = {}
    races: tuple[tuple[Race, float], ...] = (
        ("inner", rings.inner_conformity),
        ("outer", rings.outer_conformity),
    )
    for race, conformity in races:
        curvature = race_curvature(rings.ball_diameter, rings.pitch_diameter, conformity, 0.0, race)
        values[f"curvature_sum_{race}"] = float(curvature.sum) * MILLI
        values[f"curvature_difference_{race}"] = float(curvature.difference)
        star = hertz_coefficients(curvature.difference).deflection
        values[f"deflection_star_{race}"] = float(star)
        values[f"stiffness_{race}"] = float(getattr(state.stiffness, race)) / _PER_MM
    values["stiffness_combined"] = float(state.stiffness.combined) / _PER_MM
    values["load_zone_parameter"] = float(state.load_zone_parameter)
    values["radial_integral"] = float(sjovall_radial(state.load_zone_parameter))
    values["radial_displacement"] = float(state.radial_displacement) / MILLI
    values["max_ball_load"] = float(state.max_ball_load)
    for azimuth, ball in zip(np.degrees(state.ball_azimuths), state.ball_loads, strict=True):
        values[f"ball_load_{azimuth:.0f}"] = float(ball)
    return values


def _axial_example() -> Table:
    given = inputs_of("table_C2")
    rings = bearing("218")
    state = axial_load(rings, given["axial_load_N"], stiffness_angle="free")
    free = float(rings.contact_angle or 0.0)
    computed = {
        "free_angle_rad": free,
        "free_angle_deg": float(np.degrees(free)),
        "axial_displacement": float(state.axial_displacement) / MILLI,
        "contact_angle_rad": float(state.contact_angle),
        "contact_angle_deg": float(np.degrees(state.contact_angle)),
        "ball_load": float(state.ball_load),
    }
    return Table(
        number="C.2",
        caption=said("axial_example.caption", axial_load_n=given["axial_load_N"]),
        source=source_of("table_C2"),
        columns=_example_columns(given["rows"], computed, _C2_TITLES),
        claims=(_greatest_difference(given),),
        notes=(said("axial_example.loaded_angle_in"),),
    )


def _example_columns(
    rows: list[list[str]], computed: dict[str, float], titles: dict[str, tuple[Text, str]]
) -> tuple[TableColumn, ...]:
    names = [row[0] for row in rows]
    return (
        TableColumn(
            "quantity", said("example_columns.quantity"), tuple(titles[name][0] for name in names)
        ),
        TableColumn("unit", said("example_columns.unit"), tuple(titles[name][1] for name in names)),
        TableColumn("Harris_1991", same("Harris (1991)"), tuple(str(row[1]) for row in rows)),
        TableColumn(
            "value",
            same("Radaelli (2013)"),
            tuple(Cell(row[2], computed[row[0]], cut="cut" in row[3:]) for row in rows),
        ),
    )


def _greatest_difference(given: dict[str, object]) -> Claim:
    """Compare the two printed columns with each other."""
    rows, stated = given["rows"], given["greatest_difference_percent"]
    assert isinstance(rows, list)
    assert isinstance(stated, float)
    differences = [
        100.0 * abs(float(ours) - float(theirs)) / float(theirs)
        for _, theirs, ours, *_ in rows
        if float(theirs) != 0.0
    ]
    return Claim(
        said("greatest_difference.statement", stated=stated),
        said("greatest_difference.finding", differences_max=max(differences)),
        round(max(differences), 0 if stated >= 1.0 else 1) == stated,
    )
