"""The rolling elements of a solved case, balls and rollers: the heaviest one, and a line for each.

Along a roller places are counted from its middle, toward +x; its tilt is positive where the +x end
stands outward.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import nan
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento import plots
from rolamento.document import Break, CellContent, Column, Figure, Number, Section, Table, Tone
from rolamento.geometry import Race
from rolamento.numerics import BoolArray, FloatArray
from rolamento.solved import RACES, Solved
from rolamento.solved.form import control_names
from rolamento.types import type_of_element
from rolamento.words import decimals_for, in_unit, manner, said, said_in

if TYPE_CHECKING:
    from rolamento.solved import Rollers

__all__ = [
    "Values",
    "column",
    "element_sections",
    "element_tables",
    "heaviest_section",
    "main_table",
    "of_element",
    "roller_pictures",
    "without_rounding",
]

_NO_MOTION: Final = 1e-9
"""Angles (rad) and ratios that are rounding."""
_NO_TILT: Final = 1e-8
"""rad: of rollers."""


# --- which elements ------------------------------------------------------------------------------


def main_table(solved: Solved) -> str:
    """Return the key of the table of elements that a file of one table holds."""
    return "balls" if "ball" in solved.rows.element else "rollers"


def _is_roller(solved: Solved) -> BoolArray:
    """Which elements are rollers; (elements,)."""
    return np.array([element != "ball" for element in solved.rows.element])[solved.elements.row]


# --- the heaviest element ------------------------------------------------------------------------

Quantities = tuple[tuple[str, str, Callable[[Race], float]], ...]
"""Label, unit, and the value at a race in SI."""


def heaviest_section(solved: Solved) -> Section:
    """Show the contacts of the element with the maximum load and the stresses under them."""
    one = int(np.argmax(np.maximum(solved.inner.load[0], solved.outer.load[0])))
    if _is_roller(solved)[one]:
        return _heaviest_roller(solved, one)
    return _heaviest_ball(solved, one)


def _heaviest_ball(solved: Solved, ball: int) -> Section:
    shown = (
        (said("load"), "N", "load"),
        (said("contact angle"), "°", "contact_angle"),
        (said("approach"), "µm", "deflection"),
        (said("maximum pressure"), "MPa", "max_pressure"),
        (said("ellipse, semi-major"), "mm", "semi_major"),
        (said("ellipse, semi-minor"), "mm", "semi_minor"),
        *_stresses(),
    )
    names = {"number": ball, "azimuth": float(solved.elements.azimuth[0, ball])}
    if len(solved.rows) < 2:
        heading = said("Heaviest ball: #{number} at {azimuth:.5 °}", **names)
    else:
        row = int(solved.elements.row[ball])
        heading = said("Heaviest ball: #{number} of row {row} at {azimuth:.5 °}", **names, row=row)
    table = _both_races(solved, ball, _of_contacts(solved, ball, shown))
    return Section(heading, (table,), "heaviest")


def _heaviest_roller(solved: Solved, roller: int) -> Section:
    rollers = solved.rollers
    assert rollers is not None
    tapered = type_of_element(solved.rows.element[solved.elements.row[roller]]).conical
    first = (
        (said("load"), "N", "load"),
        *([(said("contact angle"), "°", "contact_angle")] if tapered else []),
        (said("approach of the middle"), "µm", "deflection"),
        (said("maximum pressure"), "MPa", "max_pressure"),
    )
    along: Quantities = (
        (
            "  " + said("at, from the middle"),
            "mm",
            lambda race: float(_peak_place(rollers, race)[roller]),
        ),
        (
            said("pressure in the middle"),
            "MPa",
            lambda race: float(_in_the_middle(rollers, race)[roller]),
        ),
        (said("pressure at the −x end"), "MPa", lambda race: _at_end(rollers, race, roller, 0)),
        (said("pressure at the +x end"), "MPa", lambda race: _at_end(rollers, race, roller, -1)),
    )
    last = ((said("half-width"), "mm", "semi_minor"), *_stresses())
    quantities = (*_of_contacts(solved, roller, first), *along, *_of_contacts(solved, roller, last))
    names = {"number": roller, "azimuth": float(solved.elements.azimuth[0, roller])}
    if len(solved.rows) < 2:
        heading = said("Heaviest roller: #{number} at {azimuth:.5 °}", **names)
    else:
        row = int(solved.elements.row[roller])
        heading = said(
            "Heaviest roller: #{number} of row {row} at {azimuth:.5 °}", **names, row=row
        )
    return Section(heading, (_both_races(solved, roller, quantities),), "heaviest")


def _stresses() -> tuple[tuple[str, str, str], ...]:
    return (
        (said("maximum shear"), "MPa", "max_shear"),
        ("  " + said("at a depth of"), "mm", "max_shear_depth"),
        (said("orthogonal shear"), "MPa", "orthogonal_shear"),
        ("  " + said("at a depth of"), "mm", "orthogonal_shear_depth"),
    )


def _of_contacts(solved: Solved, element: int, shown: Sequence[tuple[str, str, str]]) -> Quantities:
    def at(name: str) -> Callable[[Race], float]:
        return lambda race: float(getattr(solved.contacts[race], name)[0, element])

    return tuple((label, unit, at(name)) for label, unit, name in shown)


def _both_races(solved: Solved, element: int, shown: Quantities) -> Table:
    """Set what an element has at the inner race beside what it has at the outer."""
    races = {"inner": said_in("race", "inner"), "outer": said_in("race", "outer")}
    columns = [
        Column("", [label for label, _, _ in shown], "quantity"),
        Column("", [unit for _, unit, _ in shown], "unit"),
    ]
    for race in RACES:
        touched = solved.contacts[race].load[0, element] > 0.0
        values = [_five_figures(at(race), unit) if touched else nan for _, unit, at in shown]
        columns.append(Column(races[race], values, race, align="right"))
    return Table(tuple(columns), "heaviest")


def _five_figures(value: float, unit: str) -> Number:
    return Number(value, f".{decimals_for([float(in_unit(value, unit))], 5)}f [{unit}]")


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


Values = Callable[[Solved], FloatArray]
"""A number of every element of a single case in SI; (elements,)."""


def of_element(name: str) -> Values:
    """Numbers of the elements by their name in `rolamento.solved.Elements`."""
    return lambda solved: getattr(solved.elements, name)[0]


def _of_contact(race: Race, name: str) -> Values:
    """Numbers of the contacts with a race; NaN where element and race do not touch."""

    def values(solved: Solved) -> FloatArray:
        return np.where(_touches(solved, race), getattr(solved.contacts[race], name)[0], np.nan)

    return values


def _touches(solved: Solved, race: Race) -> BoolArray:
    return np.asarray(solved.loaded[0] if race == "inner" else solved.outer.load[0] > 0.0)


def without_rounding(of: Values, least: float = _NO_MOTION) -> Values:
    """Give rounding errors, such as the spin at a race in control, as zero."""

    def values(solved: Solved) -> FloatArray:
        numbers = of(solved)
        return np.where(np.abs(numbers) < least, 0.0, numbers)

    return values


def column(
    solved: Solved,
    head: str,
    unit: str,
    of: Values,
    key: str,
    *,
    figures: int = 4,
    most: int = 2,
    peak: bool = False,
    chosen: BoolArray | slice = slice(None),
) -> Column:
    """Return a column of a table with a line for each element, or for some of them."""
    return Column(
        head,
        of(solved)[chosen].tolist(),
        key,
        unit,
        figures=figures,
        most=most,
        peak="maximum" if peak else "",
    )


def _row_names(solved: Solved, chosen: BoolArray) -> tuple[tuple[int, str], ...]:
    """Where the elements of each row of a set begin, and what it is called."""
    if len(solved.rows) < 2:
        return ()
    rows = solved.elements.row[chosen]
    return tuple(
        (int(np.argmax(rows == row)), said("row {number}", number=row)) for row in np.unique(rows)
    )


_CONTACT_COLUMNS: Final = (
    ("load", "N"),
    ("contact_angle", "°"),
    ("deflection", "µm"),
    ("semi_major", "mm"),
    ("semi_minor", "mm"),
    ("max_pressure", "MPa"),
    ("mean_pressure", "MPa"),
    ("max_shear", "MPa"),
    ("max_shear_depth", "mm"),
    ("orthogonal_shear", "MPa"),
    ("orthogonal_shear_depth", "mm"),
    ("spin_to_roll", ""),
)


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
    balls = ~_is_roller(solved)
    columns = [
        Column("#", np.flatnonzero(balls).tolist(), "ball", tone="faint"),
        column(solved, "ψ", "°", of_element("azimuth"), "azimuth", figures=5, chosen=balls),
    ]
    for name, symbol, unit, figures, peak in (
        ("load", "Q", "N", 5, True),
        ("contact_angle", "α", "°", 4, False),
        ("max_pressure", "p", "MPa", 4, True),
    ):
        columns += [
            column(
                solved,
                f"{symbol}_{race[0]}",
                unit,
                _of_contact(race, name),
                f"{race}_{name}",
                figures=figures,
                peak=peak,
                chosen=balls,
            )
            for race in RACES
        ]
    columns.append(Column("Q_i", solved.inner.load[0, balls].tolist(), bar=True))
    breaks: tuple[Break, ...] = ()
    if _turning(solved):
        heading = said("Motion of the balls")
        legend = said(
            "F_c centrifugal force, M_g gyroscopic moment, n_m orbital speed, n_R ball speed, "
            "s spin-to-roll ratio"
        )
        breaks = (Break(len(columns), heading, legend),)
        columns += _motion(solved, balls)
    legend = said("Q load, α contact angle, p maximum pressure; i inner, o outer; ◂ maximum")
    return Table(
        tuple(columns),
        legends=(legend,),
        groups=_row_names(solved, balls),
        rule=True,
        fixed=2,
        breaks=breaks,
    )


def _turning(solved: Solved) -> bool:
    return solved.case.duty.inner_speed != 0.0 or solved.case.duty.outer_speed != 0.0


def _motion(solved: Solved, balls: BoolArray) -> list[Column]:
    def own(head: str, unit: str, name: str, figures: int) -> Column:
        return column(solved, head, unit, of_element(name), name, figures=figures, chosen=balls)

    spins = [
        column(
            solved,
            f"s_{race[0]}",
            "–",
            without_rounding(_of_contact(race, "spin_to_roll")),
            f"{race}_spin_to_roll",
            most=4,
            chosen=balls,
        )
        for race in RACES
    ]
    return [
        own("F_c", "N", "centrifugal_force", 5),
        own("M_g", "N·mm", "gyroscopic_moment", 4),
        own("n_m", "rpm", "orbital_speed", 5),
        own("n_R", "rpm", "ball_speed", 5),
        *spins,
    ]


def all_of_the_balls(solved: Solved) -> Table:
    """Return the table of balls that is written to files: all numbers, touching or not."""
    elements, balls = solved.elements, ~_is_roller(solved)
    columns = [
        Column("row", elements.row[balls].tolist(), "row"),
        Column("ball", np.flatnonzero(balls).tolist(), "ball"),
        Column("azimuth", elements.azimuth[0, balls].tolist(), "azimuth", "°"),
    ]
    columns += [
        Column(name, values, f"{race}_{name}", unit)
        for race in RACES
        for name, unit in _CONTACT_COLUMNS
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


def _at_end(rollers: Rollers, race: Race, roller: int, end: int) -> float:
    return float(_line(rollers, race)[roller, end])


def _peak_place(rollers: Rollers, race: Race) -> FloatArray:
    """Where along the rollers the pressure is greatest; NaN of balls beside them."""
    peak = np.nan_to_num(_line(rollers, race)).argmax(axis=1)
    return np.take_along_axis(rollers.slice_place[0], peak[:, np.newaxis], axis=1)[:, 0]


def _end_over_middle(rollers: Rollers, race: Race) -> FloatArray:
    """The pressure at the end that bears more over that in the middle."""
    pressure, middle = _line(rollers, race), _in_the_middle(rollers, race)
    end = np.maximum(pressure[:, 0], pressure[:, -1])
    return np.asarray(np.divide(end, middle, out=np.full(len(end), np.nan), where=middle > 0.0))


def _along(race: Race, of: Callable[[Rollers, Race], FloatArray]) -> Values:
    """Numbers of what a roller bears along its length; NaN where it does not touch the race."""

    def values(solved: Solved) -> FloatArray:
        assert solved.rollers is not None
        return np.where(_touches(solved, race), of(solved.rollers, race), np.nan)

    return values


def _of_rollers(name: str) -> Values:
    return lambda solved: getattr(solved.rollers, name)[0]


def rollers_table(solved: Solved) -> Table:
    """Return a line for every roller: loads and pressures; along it; then its motion."""
    rollers = _is_roller(solved)
    assert solved.rollers is not None

    def own(
        head: str, unit: str, of: Values, key: str, figures: int = 4, most: int = 2,
        *, peak: bool = False,
    ) -> Column:  # fmt: skip
        return column(
            solved, head, unit, of, key, figures=figures, most=most, peak=peak, chosen=rollers
        )

    columns = [
        Column("#", np.flatnonzero(rollers).tolist(), "roller", tone="faint"),
        own("ψ", "°", of_element("azimuth"), "azimuth", 5),
    ]
    for name, symbol, unit, figures in (("load", "Q", "N", 5), ("max_pressure", "p", "MPa", 4)):
        columns += [
            own(f"{symbol}_{race[0]}", unit, _of_contact(race, name), f"{race}_{name}", figures,
                peak=True)
            for race in RACES
        ]  # fmt: skip
    columns += [
        own(f"x_{race[0]}", "mm", _along(race, _peak_place), f"{race}_peak_place") for race in RACES
    ]
    tilt = without_rounding(_of_rollers("tilt"), _NO_TILT)
    columns += [
        own("θ", "mrad", tilt, "tilt", most=3),
        Column("Q_i", solved.inner.load[0, rollers].tolist(), bar=True),
    ]
    first, symbols = len(columns), [said("e pressure at the more loaded end over the middle's")]
    columns += [
        own(f"e_{race[0]}", "–", _along(race, _end_over_middle), f"{race}_end_over_middle", 3)
        for race in RACES
    ]
    if np.nan_to_num(solved.rollers.rib_force[0]).any():
        symbols.append(said("F_rib force of the rib on the roller's end"))
        columns.append(own("F_rib", "N", _of_rollers("rib_force"), "rib_force"))
    if _turning(solved):
        symbols.append(said("F_c centrifugal force"))
        columns.append(own("F_c", "N", of_element("centrifugal_force"), "centrifugal_force", 5))
        if any(type_of_element(one).conical for one in solved.rows.element):
            symbols.append(said("M_g gyroscopic moment"))
            moment = of_element("gyroscopic_moment")
            columns.append(own("M_g", "N·mm", moment, "gyroscopic_moment"))
        symbols.append(said("n_m orbital speed, n_R roller speed"))
        columns += [
            own("n_m", "rpm", of_element("orbital_speed"), "orbital_speed", 5),
            own("n_R", "rpm", of_element("ball_speed"), "roller_speed", 5),
        ]
    heading = said("Ends and motion of the rollers") if _turning(solved) else said("Ends")
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
        groups=_row_names(solved, rollers),
        rule=True,
        fixed=2,
        breaks=breaks,
    )


def all_of_the_rollers(solved: Solved) -> Table:
    """Return the table of rollers that is written to files: all numbers, touching or not."""
    elements, chosen = solved.elements, _is_roller(solved)

    def own(head: str, of: Values, unit: str = "") -> Column:
        return Column(head, of(solved)[chosen].tolist(), head, unit)

    units = dict(_CONTACT_COLUMNS)
    columns = [
        Column("row", elements.row[chosen].tolist(), "row"),
        Column("roller", np.flatnonzero(chosen).tolist(), "roller"),
        own("azimuth", of_element("azimuth"), "°"),
    ]
    for race in RACES:
        columns += [
            Column(
                f"{race}_{name}",
                getattr(solved.contacts[race], of)[0, chosen].tolist(),
                f"{race}_{name}",
                units[of],
            )
            for of, name in _ROLLER_CONTACTS.items()
        ]
        columns += [
            own(f"{race}_peak_place", _along(race, _peak_place), "mm"),
            own(f"{race}_end_over_middle", _along(race, _end_over_middle)),
        ]
    columns += [
        own("tilt", _of_rollers("tilt"), "mrad"),
        own("rib_force", _of_rollers("rib_force"), "N"),
        own("rib_moment", _of_rollers("rib_moment"), "N·mm"),
    ]
    columns += [own(name, of_element(of), unit) for of, name, unit in _ROLLER_COLUMNS]
    return Table(tuple(columns), "rollers", only_in_files=True)


def all_of_the_slices(solved: Solved) -> Table:
    """Return what files have of every slice of every roller."""
    rollers = solved.rollers
    assert rollers is not None
    chosen = np.flatnonzero(_is_roller(solved))
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
    if not _is_roller(solved).any() or not solved.loaded[0, _is_roller(solved)].any():
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
