"""The rolling elements of a solved case, balls and rollers: the heaviest one, and a line for each.

Along a roller places are counted from its middle, toward +x; its tilt is positive where the +x end
stands outward.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import nan
from typing import TYPE_CHECKING, Final, Literal

import numpy as np

from rolamento import plots
from rolamento.document import Break, CellContent, Column, Figure, Number, Section, Table, Tone
from rolamento.geometry import Race
from rolamento.numerics import BoolArray, FloatArray
from rolamento.solved import RACES, Solved
from rolamento.solved.form import control_names
from rolamento.types import type_of_element
from rolamento.words import decimals_for, in_unit, manner, said, said_in
from rolamento.words.quantities import called

if TYPE_CHECKING:
    from rolamento.solved import Rollers

__all__ = [
    "CONTACT_UNITS",
    "contact_name",
    "element_sections",
    "element_tables",
    "heaviest_section",
    "roller_pictures",
    "without_rounding",
]

_NO_MOTION: Final = 1e-9
"""Angles (rad) and ratios that are rounding."""
_NO_TILT: Final = 1e-8
"""rad: of rollers."""


# --- the heaviest element ------------------------------------------------------------------------


def heaviest_section(solved: Solved) -> Section:
    """Show the contacts of the element with the maximum load and the stresses under them."""
    one = int(np.argmax(np.maximum(solved.inner.load[0], solved.outer.load[0])))
    row, azimuth = int(solved.elements.row[one]), float(solved.elements.azimuth[0, one])
    place = {"number": one, "azimuth": azimuth, "row": row}
    roller, several = solved.rows.element[row] != "ball", len(solved.rows) > 1
    if roller and several:
        heading = said("Heaviest roller: #{number} of row {row} at {azimuth:.5 °}", **place)
    elif roller:
        heading = said("Heaviest roller: #{number} at {azimuth:.5 °}", **place)
    elif several:
        heading = said("Heaviest ball: #{number} of row {row} at {azimuth:.5 °}", **place)
    else:
        heading = said("Heaviest ball: #{number} at {azimuth:.5 °}", **place)
    element, depth = solved.rows.element[row], "  " + said("at a depth of")

    angle = ["contact_angle"] * (not roller or type_of_element(element).conical)
    length = [] if roller else ["semi_major"]
    names = ["load", *angle, "deflection", "max_pressure", *length, "semi_minor", "max_shear",
             "max_shear_depth", "orthogonal_shear", "orthogonal_shear_depth"]  # fmt: skip
    shown: list[tuple[str, str, str | dict[Race, float]]] = [
        (
            depth if name.endswith("depth") else contact_name(name, [element]),
            CONTACT_UNITS[name],
            name,
        )
        for name in names
    ]
    if roller:
        shown[names.index("semi_minor") : 0] = _along_the_roller(solved, one)
    races = {"inner": said_in("race", "inner"), "outer": said_in("race", "outer")}
    columns = [
        Column("", [label for label, _, _ in shown], "quantity"),
        Column("", [unit for _, unit, _ in shown], "unit"),
    ]
    for race in RACES:
        contacts, cells = solved.contacts[race], list[CellContent]()
        for _, unit, what in shown:
            value = float(getattr(contacts, what)[0, one] if isinstance(what, str) else what[race])
            decimals = decimals_for([float(in_unit(value, unit))], 5)
            touches = contacts.load[0, one] > 0.0
            cells.append(Number(value, f".{decimals}f [{unit}]") if touches else nan)
        columns.append(Column(races[race], cells, race, align="right"))
    return Section(heading, (Table(tuple(columns), "heaviest"),), "heaviest")


def _along_the_roller(
    solved: Solved, roller: int
) -> tuple[tuple[str, str, str | dict[Race, float]], ...]:
    """Return label, unit and values at the races of what the heaviest roller bears along it."""
    rollers = solved.rollers
    assert rollers is not None
    lines = {race: _line(rollers, race)[roller] for race in RACES}
    places = {race: float(_peak_place(rollers, race)[roller]) for race in RACES}
    middle, left, right = (
        {race: float(line[place]) for race, line in lines.items()}
        for place in (rollers.slices // 2, 0, -1)
    )
    return (
        ("  " + said("at, from the middle"), "mm", places),
        (said("pressure in the middle"), "MPa", middle),
        (said("pressure at the −x end"), "MPa", left),
        (said("pressure at the +x end"), "MPa", right),
    )


# --- a line for each -----------------------------------------------------------------------------


def element_sections(solved: Solved) -> list[Section]:
    """Show the elements, a line each: their contacts, and their motion where the rings turn.

    Without a result the tables of files remain, without numbers.
    """
    converged = bool(solved.converged[0])
    sections = []
    kinds = set(solved.rows.element)
    if "ball" in kinds:
        shown = (balls_table(solved),) if converged else ()
        heading = said("Balls") if converged else ""
        sections.append(Section(heading, (*shown, all_of_the_balls(solved)), "balls"))
    if kinds != {"ball"}:
        shown = (rollers_table(solved),) if converged else ()
        heading = said("Rollers") if converged else ""
        files = (all_of_the_rollers(solved), all_of_the_slices(solved))
        sections.append(Section(heading, (*shown, *files), "rollers"))
    return sections


def element_tables(solved: Solved) -> dict[str, Table]:
    """Return the tables that are shown of a solved case, by what is in them: balls, rollers."""
    tables = {}
    kinds = set(solved.rows.element)
    if "ball" in kinds:
        tables["balls"] = balls_table(solved)
    if kinds != {"ball"}:
        tables["rollers"] = rollers_table(solved)
    return tables


def _touching(solved: Solved, race: Race, numbers: FloatArray) -> FloatArray:
    """Numbers of the contacts with a race; NaN where element and race do not touch."""
    touches = solved.loaded[0] if race == "inner" else solved.outer.load[0] > 0.0
    return np.where(touches, numbers, np.nan)


def without_rounding(numbers: FloatArray, least: float = _NO_MOTION) -> FloatArray:
    """Return rounding errors, such as the spin at a race in control, as zero."""
    return np.where(np.abs(numbers) < least, 0.0, numbers)


def _row_names(solved: Solved, chosen: BoolArray) -> tuple[tuple[int, str], ...]:
    """Where the elements of each row of a set begin, and what it is called."""
    if len(solved.rows) < 2:
        return ()
    rows = solved.elements.row[chosen]
    return tuple(
        (int(np.argmax(rows == row)), said("row {number}", number=row)) for row in np.unique(rows)
    )


CONTACT_UNITS: Final = {
    "load": "N",
    "contact_angle": "°",
    "deflection": "µm",
    "semi_major": "mm",
    "semi_minor": "mm",
    "max_pressure": "MPa",
    "mean_pressure": "MPa",
    "max_shear": "MPa",
    "max_shear_depth": "mm",
    "orthogonal_shear": "MPa",
    "orthogonal_shear_depth": "mm",
    "spin_to_roll": "",
}
"""Numbers of contacts, and the units in which they are read."""
_OF_LINES: Final = {
    "deflection": "line_deflection",
    "semi_major": "half_length",
    "semi_minor": "half_width",
}
"""What is called otherwise of a line of contact."""


def contact_name(name: str, elements: Iterable[str]) -> str:
    """Return what a number of the contacts is called, by its name in `CONTACT_UNITS`.

    elements: what rolls there, as of `Row.element`.
    """
    line = called(_OF_LINES.get(name, name))
    kinds = set(elements)
    if name not in _OF_LINES or "ball" not in kinds:
        return line
    if kinds == {"ball"}:
        return called(name)
    return said("{balls}; of rollers {rollers}", balls=called(name), rollers=line)


# --- balls ---------------------------------------------------------------------------------------

_BALL_COLUMNS: Final = (
    ("centrifugal_force", "N"),
    ("gyroscopic_moment", "N·mm"),
    ("orbital_speed", "rpm"),
    ("ball_speed", "rpm"),
    ("attitude", "°"),
)


def balls_table(solved: Solved) -> Table:
    """Return a line for every ball: loads, angles, pressures; then its motion."""
    elements, balls = solved.elements, ~solved.are_rollers
    columns = [
        Column("#", np.flatnonzero(balls).tolist(), "ball", tone="faint"),
        Column("ψ", elements.azimuth[0, balls].tolist(), "azimuth", "°", figures=5),
    ]
    for name, symbol, unit, figures in (
        ("load", "Q", "N", 5), ("contact_angle", "α", "°", 4), ("max_pressure", "p", "MPa", 4),
    ):  # fmt: skip
        for race in RACES:
            numbers = _touching(solved, race, getattr(solved.contacts[race], name)[0])[balls]
            columns.append(
                Column(
                    f"{symbol}_{race[0]}", numbers.tolist(), f"{race}_{name}", unit,
                    figures=figures, peak="" if name == "contact_angle" else "maximum",
                )
            )  # fmt: skip
    columns.append(Column("Q_i", solved.inner.load[0, balls].tolist(), bar=True))
    breaks: tuple[Break, ...] = ()
    if solved.case.duty.turns:
        heading = said("Motion of the balls")
        legend = said(
            "F_c centrifugal force, M_g gyroscopic moment, n_m orbital speed, n_R ball speed, "
            "s spin-to-roll ratio"
        )
        breaks = (Break(len(columns), heading, legend),)
        columns += [
            Column(head, getattr(elements, name)[0, balls].tolist(), name, unit, figures=figures)
            for head, unit, name, figures in (
                ("F_c", "N", "centrifugal_force", 5), ("M_g", "N·mm", "gyroscopic_moment", 4),
                ("n_m", "rpm", "orbital_speed", 5), ("n_R", "rpm", "ball_speed", 5),
            )
        ]  # fmt: skip
        for race in RACES:
            spin = _touching(solved, race, without_rounding(solved.contacts[race].spin_to_roll[0]))
            name = f"{race}_spin_to_roll"
            columns.append(Column(f"s_{race[0]}", spin[balls].tolist(), name, "–", most=4))
    legend = said("Q load, α contact angle, p maximum pressure; i inner, o outer; ◂ maximum")
    return Table(
        tuple(columns),
        legends=(legend,),
        groups=_row_names(solved, balls),
        rule=True,
        fixed=2,
        breaks=breaks,
    )


def all_of_the_balls(solved: Solved) -> Table:
    """Return the table of balls that is written to files: all numbers, touching or not."""
    elements, balls = solved.elements, ~solved.are_rollers
    columns = [
        Column("row", elements.row[balls].tolist(), "row"),
        Column("ball", np.flatnonzero(balls).tolist(), "ball"),
        Column("azimuth", elements.azimuth[0, balls].tolist(), "azimuth", "°"),
    ]
    columns += [
        Column(name, values, f"{race}_{name}", unit)
        for race in RACES
        for name, unit in CONTACT_UNITS.items()
        for values in [getattr(solved.contacts[race], name)[0, balls].tolist()]
    ]
    columns += [
        Column(name, getattr(elements, name)[0, balls].tolist(), name, unit)
        for name, unit in _BALL_COLUMNS
    ]
    names = np.array(list(control_names(solved)), dtype=object)
    columns.append(Column("raceway_control", names[balls].tolist(), "raceway_control"))
    return Table(tuple(columns), "balls", only_in_files=True)


# --- rollers -------------------------------------------------------------------------------------

_ROLLER_CONTACTS: Final = {
    "load": "load",
    "contact_angle": "contact_angle",
    "deflection": "deflection",
    "semi_minor": "half_width",
    "max_pressure": "max_pressure",
    "mean_pressure": "mean_pressure",
    "max_shear": "max_shear",
    "max_shear_depth": "max_shear_depth",
    "orthogonal_shear": "orthogonal_shear",
    "orthogonal_shear_depth": "orthogonal_shear_depth",
}
"""Columns of the contacts of rollers, what files have, and under which name."""
_ROLLER_COLUMNS: Final = (
    ("centrifugal_force", "centrifugal_force", "N"),
    ("gyroscopic_moment", "gyroscopic_moment", "N·mm"),
    ("orbital_speed", "orbital_speed", "rpm"),
    ("ball_speed", "roller_speed", "rpm"),
)


def _line(rollers: Rollers, race: Race) -> FloatArray:
    """Pressures along the rollers; (elements, slices)."""
    return np.asarray((rollers.inner if race == "inner" else rollers.outer).pressure[0])


def _in_the_middle(rollers: Rollers, race: Race) -> FloatArray:
    pressure = _line(rollers, race)
    return np.asarray(pressure[:, pressure.shape[1] // 2])


def _peak_place(rollers: Rollers, race: Race) -> FloatArray:
    """Where along the rollers the pressure is greatest; NaN of balls beside them."""
    peak = np.nan_to_num(_line(rollers, race)).argmax(axis=1)
    return np.take_along_axis(rollers.slice_place[0], peak[:, np.newaxis], axis=1)[:, 0]


def _end_over_middle(rollers: Rollers, race: Race) -> FloatArray:
    """The pressure at the end that bears more over that in the middle."""
    pressure, middle = _line(rollers, race), _in_the_middle(rollers, race)
    end = np.maximum(pressure[:, 0], pressure[:, -1])
    return np.asarray(np.divide(end, middle, out=np.full(len(end), np.nan), where=middle > 0.0))


def rollers_table(solved: Solved) -> Table:
    """Return a line for every roller: loads and pressures; along it; then its motion."""
    chosen, elements, rollers = solved.are_rollers, solved.elements, solved.rollers
    assert rollers is not None

    def own(
        head: str, unit: str, of: FloatArray, key: str, figures: int = 4, most: int = 2,
        *, peak: bool = False,
    ) -> Column:  # fmt: skip
        top: Literal["", "maximum"] = "maximum" if peak else ""
        return Column(head, of[chosen].tolist(), key, unit, figures=figures, most=most, peak=top)

    columns = [
        Column("#", np.flatnonzero(chosen).tolist(), "roller", tone="faint"),
        own("ψ", "°", elements.azimuth[0], "azimuth", 5),
    ]
    for name, symbol, unit, figures in (("load", "Q", "N", 5), ("max_pressure", "p", "MPa", 4)):
        columns += [
            own(
                f"{symbol}_{race[0]}",
                unit,
                _touching(solved, race, getattr(solved.contacts[race], name)[0]),
                f"{race}_{name}",
                figures,
                peak=True,
            )
            for race in RACES
        ]
    columns += [
        own(f"x_{race[0]}", "mm", _touching(solved, race, place), f"{race}_peak_place")
        for race in RACES
        for place in [_peak_place(rollers, race)]
    ]
    tilt = without_rounding(rollers.tilt[0], _NO_TILT)
    columns += [
        own("θ", "mrad", tilt, "tilt", most=3),
        Column("Q_i", solved.inner.load[0, chosen].tolist(), bar=True),
    ]
    first, symbols = len(columns), [said("e pressure at the more loaded end over the middle's")]
    columns += [
        own(f"e_{race[0]}", "–", _touching(solved, race, ratio), f"{race}_end_over_middle", 3)
        for race in RACES
        for ratio in [_end_over_middle(rollers, race)]
    ]
    if np.nan_to_num(rollers.rib_force[0]).any():
        symbols.append(said("F_rib force of the rib on the roller's end"))
        columns.append(own("F_rib", "N", rollers.rib_force[0], "rib_force"))
    turning = solved.case.duty.turns
    if turning:
        symbols.append(said("F_c centrifugal force"))
        columns.append(own("F_c", "N", elements.centrifugal_force[0], "centrifugal_force", 5))
        if any(type_of_element(one).conical for one in solved.rows.element):
            symbols.append(said("M_g gyroscopic moment"))
            moment = elements.gyroscopic_moment[0]
            columns.append(own("M_g", "N·mm", moment, "gyroscopic_moment"))
        symbols.append(said("n_m orbital speed, n_R roller speed"))
        columns += [
            own("n_m", "rpm", elements.orbital_speed[0], "orbital_speed", 5),
            own("n_R", "rpm", elements.ball_speed[0], "roller_speed", 5),
        ]
    heading = said("Ends and motion of the rollers") if turning else said("Ends")
    breaks = (Break(first, heading, ", ".join(symbols)),)
    legend = said(
        "Q load, p maximum pressure along the roller, x its place from the middle toward +x, θ tilt"
        " of the roller, positive where its +x end stands outward; i inner, o outer; ◂ maximum"
    )
    legends: tuple[str, ...] = (legend,)
    if np.any(solved.rows.sign < 0.0):
        legends += (said("x and θ of a row that faces − are as seen in a row that faces +"),)
    return Table(
        tuple(columns),
        legends=legends,
        groups=_row_names(solved, chosen),
        rule=True,
        fixed=2,
        breaks=breaks,
    )


def all_of_the_rollers(solved: Solved) -> Table:
    """Return the table of rollers that is written to files: all numbers, touching or not."""
    elements, chosen, rollers = solved.elements, solved.are_rollers, solved.rollers
    assert rollers is not None

    def own(head: str, of: FloatArray, unit: str = "") -> Column:
        return Column(head, of[chosen].tolist(), head, unit)

    columns = [
        Column("row", elements.row[chosen].tolist(), "row"),
        Column("roller", np.flatnonzero(chosen).tolist(), "roller"),
        own("azimuth", elements.azimuth[0], "°"),
    ]
    for race in RACES:
        columns += [
            Column(
                f"{race}_{name}",
                getattr(solved.contacts[race], of)[0, chosen].tolist(),
                f"{race}_{name}",
                CONTACT_UNITS[of],
            )
            for of, name in _ROLLER_CONTACTS.items()
        ]
        columns += [
            own(f"{race}_peak_place", _touching(solved, race, _peak_place(rollers, race)), "mm"),
            own(
                f"{race}_end_over_middle", _touching(solved, race, _end_over_middle(rollers, race))
            ),
        ]
    columns += [
        own("tilt", rollers.tilt[0], "mrad"),
        own("rib_force", rollers.rib_force[0], "N"),
        own("rib_moment", rollers.rib_moment[0], "N·mm"),
    ]
    columns += [own(name, getattr(elements, of)[0], unit) for of, name, unit in _ROLLER_COLUMNS]
    return Table(tuple(columns), "rollers", only_in_files=True)


def all_of_the_slices(solved: Solved) -> Table:
    """Return what files have of every slice of every roller."""
    rollers = solved.rollers
    assert rollers is not None
    chosen = np.flatnonzero(solved.are_rollers)
    count = rollers.slice_place.shape[-1]

    def own(head: str, values: FloatArray, unit: str) -> Column:
        cells: Sequence[CellContent] = values[0, chosen].ravel().tolist()
        return Column(head, cells, head, unit)

    columns = [
        Column("row", np.repeat(solved.elements.row[chosen], count).tolist()),
        Column("roller", np.repeat(chosen, count).tolist()),
        Column("slice", np.tile(np.arange(count), len(chosen)).tolist()),
        own("place", rollers.slice_place, "mm"),
    ]
    for race in RACES:
        line = rollers.inner if race == "inner" else rollers.outer
        columns += [
            own(f"{race}_load_per_length", line.load_per_length, "N/mm"),
            own(f"{race}_pressure", line.pressure, "MPa"),
            own(f"{race}_half_width", line.half_width, "mm"),
        ]
    return Table(tuple(columns), "slices", only_in_files=True)


# --- pictures of rollers -------------------------------------------------------------------------

_SKETCH_HEIGHT: Final = 8
_EIGHTHS: Final = " ▁▂▃▄▅▆▇█"
_HASHES: Final = " #"


def roller_pictures(solved: Solved) -> list[Section]:
    """Draw the pressure along the rollers, and the most loaded one between the races; if any is."""
    if not solved.are_rollers.any() or not solved.loaded[0, solved.are_rollers].any():
        return []
    along = Figure(
        said("Pressure along the rollers at both races, the most loaded one in full"),
        lambda: plots.pressures_of_both_races(solved)[0],
        "along",
        sketch=lambda width, draws: _sketch(solved, width, draws),
    )
    between = Figure(
        said("The most loaded roller between the races, before they are pressed flat"),
        lambda: plots.roller_between_races(solved),
        "between",
    )
    return [Section(said("Along the rollers"), (along, between), "along")]


def _sketch(solved: Solved, width: int, draws: bool) -> list[list[tuple[str, Tone]]]:
    """Draw the pressure along the most loaded roller at the inner race in bars, one a slice."""
    rollers = solved.rollers
    assert rollers is not None
    pressure = np.nan_to_num(_line(rollers, "inner"))
    roller = int(pressure.max(axis=1).argmax())
    shown = pressure[roller]
    most = max(width - 14, 8)
    if len(shown) > most:  # the greatest of neighbours, so that no peak is lost
        shown = np.array([part.max() for part in np.array_split(shown, most)])
    characters = _EIGHTHS if draws else _HASHES
    steps = len(characters) - 1
    heights = np.rint(shown / shown.max() * _SKETCH_HEIGHT * steps).astype(int)
    top = manner().number(float(shown.max()), ".4 MPa")
    lines: list[list[tuple[str, Tone]]] = []
    for line in range(_SKETCH_HEIGHT - 1, -1, -1):
        bars = "".join(characters[min(max(h - steps * line, 0), steps)] for h in heights)
        label = top if line == _SKETCH_HEIGHT - 1 else ""
        lines.append([("  ", ""), (bars, "mark"), (f" {label}", "faint")])
    ends = "−x" + "+x".rjust(len(shown) - 2)
    lines.append([("  ", ""), (ends, "faint")])
    caption = said("pressure at the inner race along roller #{number}", number=roller)
    return [*lines, [(f"  {caption}", "faint")]]
